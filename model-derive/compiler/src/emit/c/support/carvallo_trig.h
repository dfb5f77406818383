/* SPDX-License-Identifier: MIT OR Apache-2.0 */

/**
 * @file carvallo_trig.h
 * @brief Sine, cosine and tangent, for models with angles.
 *
 * They are computed here, by the same steps as in the crate `carvallo`, so that models give the same bits on every
 * processor, whichever libm is linked; in double precision up to 1e5 rad, and beyond by `sin` and `cos` of libm. The
 * result differs from the exact one by less than one unit in the last place.
 *
 * In single precision there is no operation of doubles, and that accuracy up to 1e5 rad (of the tangent 1.2
 * units). Beyond, they are those of an angle that differs by less than one unit in its last place; and
 * beyond 2^22 rad, where these units are half a radian and more, those of zero.
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

/** The tangent of an angle in rad, in single precision. */
float carvallo_tan_f32(float angle);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_TRIG_H */
