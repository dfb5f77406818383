/* SPDX-License-Identifier: MIT OR Apache-2.0 */

/**
 * @file carvallo_trig.h
 * @brief Sine and cosine, for models with angles.
 *
 * In double precision they are computed here, by the same steps as in the crate `carvallo`, so that models give the
 * same bits on every processor, whichever libm is linked: up to 1e5 rad, and beyond by `sin` and `cos` of libm. The
 * result differs from the exact one by less than one unit in the last place. In single precision they are `sinf` and
 * `cosf` of libm.
 *
 * For sines of your own (a table, an instruction of the processor, a safety library) compile `carvallo_trig.c` with
 * `CARVALLO_OWN_SIN_COS_F64` or `CARVALLO_OWN_SIN_COS_F32` defined, and define the function `carvallo_sin_cos_f64` or
 * `carvallo_sin_cos_f32` elsewhere. All others here call it.
 */

#ifndef CARVALLO_TRIG_H
#define CARVALLO_TRIG_H

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Sine and cosine of one angle.
 *
 * @param[in] angle In rad.
 * @param[out] sine The sine; no number if the angle is not finite.
 * @param[out] cosine The cosine; no number if the angle is not finite.
 */
void carvallo_sin_cos_f64(double angle, double *sine, double *cosine);

/** The sine of an angle in rad. */
double carvallo_sin_f64(double angle);

/** The cosine of an angle in rad. */
double carvallo_cos_f64(double angle);

/**
 * Sine and cosine of one angle, in single precision.
 *
 * @param[in] angle In rad.
 * @param[out] sine The sine; no number if the angle is not finite.
 * @param[out] cosine The cosine; no number if the angle is not finite.
 */
void carvallo_sin_cos_f32(float angle, float *sine, float *cosine);

/** The sine of an angle in rad, in single precision. */
float carvallo_sin_f32(float angle);

/** The cosine of an angle in rad, in single precision. */
float carvallo_cos_f32(float angle);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_TRIG_H */
