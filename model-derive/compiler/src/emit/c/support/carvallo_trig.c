/* SPDX-License-Identifier: MIT OR Apache-2.0 */

/* Compile with -ffp-contract=off (GCC, Clang) or the like, and without -ffast-math: see carvallo_system.h. */

#include "carvallo_trig.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#ifndef CARVALLO_OWN_SIN_COS_F64

/* Sine and cosine of x + y between -pi/4 and pi/4, where y is the rounding of x. The polynomials are those of fdlibm (Sun
 * Microsystems 1993, k_sin.c and k_cos.c). */
static void near_zero(double x, double y, double *sine, double *cosine)
{
    const double z = x * x;
    const double w = z * z;
    const double s = (0.00833333333332249 + (z * (-0.0001984126982985795 + (z * 2.7557313707070068e-6))))
        + ((z * w) * (-2.5050760253406863e-8 + (z * 1.58969099521155e-10)));
    const double v = z * x;
    const double r = (z * (0.0416666666666666 + (z * (-0.001388888888887411 + (z * 2.480158728947673e-5)))))
        + ((w * w) * (-2.7557314351390663e-7 + (z * (2.087572321298175e-9 + (z * -1.1359647557788195e-11)))));
    const double half_square = 0.5 * z;
    const double most = 1.0 - half_square;
    *sine = x - (((z * ((0.5 * y) - (v * s))) - y) + (v * 0.16666666666666632));
    *cosine = most + (((1.0 - most) - half_square) + ((z * r) - (x * y)));
}

/* Less the nearest multiple of pi/2, of which the parts of 33 bits are those of fdlibm (e_rem_pio2.c). */
static void within_limit(double angle, double *sine, double *cosine)
{
    /* Adding 1.5 * 2^52 rounds to a whole number. */
    const double rounded = (angle * 0.6366197723675814) + 6755399441055744.0;
    const double quarters = rounded - 6755399441055744.0;
    const uint32_t turns = (uint32_t)((int32_t)quarters);
    const double first = quarters * 1.5707963267341256;
    const double second = quarters * 6.077100506303966e-11;
    const double third = quarters * 2.0222662487959506e-21;
    /* The first difference is exact; of the second the rounding is kept. */
    const double rest = angle - first;
    const double high = rest - second;
    const double low = ((rest - high) - second) - third;
    const double near = high + low;
    const bool is_odd = (turns & 1U) != 0U;
    const bool is_half = (turns & 2U) != 0U;
    double s = 0.0;
    double c = 0.0;
    near_zero(near, (high - near) + low, &s, &c);
    *sine = is_odd ? c : s;
    *cosine = is_odd ? s : c;
    if (is_half) {
        *sine = -(*sine);
    }
    if (is_odd != is_half) {
        *cosine = -(*cosine);
    }
}

void carvallo_sin_cos_f64(double angle, double *sine, double *cosine)
{
    const double size = fabs(angle);
    if (size <= 0.7853981633974483) {
        near_zero(angle, 0.0, sine, cosine);
    } else if (size <= 1e5) {
        within_limit(angle, sine, cosine);
    } else {
        *sine = sin(angle);
        *cosine = cos(angle);
    }
}

#endif

double carvallo_sin_f64(double angle)
{
    double sine = 0.0;
    double cosine = 0.0;
    carvallo_sin_cos_f64(angle, &sine, &cosine);
    return sine;
}

double carvallo_cos_f64(double angle)
{
    double sine = 0.0;
    double cosine = 0.0;
    carvallo_sin_cos_f64(angle, &sine, &cosine);
    return cosine;
}

#ifndef CARVALLO_OWN_SIN_COS_F32

void carvallo_sin_cos_f32(float angle, float *sine, float *cosine)
{
    *sine = sinf(angle);
    *cosine = cosf(angle);
}

#endif

float carvallo_sin_f32(float angle)
{
    float sine = 0.0F;
    float cosine = 0.0F;
    carvallo_sin_cos_f32(angle, &sine, &cosine);
    return sine;
}

float carvallo_cos_f32(float angle)
{
    float sine = 0.0F;
    float cosine = 0.0F;
    carvallo_sin_cos_f32(angle, &sine, &cosine);
    return cosine;
}
