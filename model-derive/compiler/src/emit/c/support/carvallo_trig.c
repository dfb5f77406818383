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

/* In single precision, without an operation of doubles: numbers in two parts, the second of which is small. */
typedef struct {
    float high;
    float low;
} pair_t;

/* Sine and cosine, before their last addition, of x between -pi/4 and pi/4. The polynomials are those of the Cephes library
 * (Moshier 1992, sinf.c). */
static void near_zero_f32(pair_t angle, pair_t *sine, pair_t *cosine)
{
    const float x = angle.high;
    const float z = x * x;
    const float s = -0.16666655F + (z * (0.008332161F + (z * -0.00019515296F)));
    const float c = 0.041666646F + (z * (-0.0013887316F + (z * 2.4433157e-5F)));
    const float half_square = 0.5F * z;
    const float most = 1.0F - half_square;
    sine->high = x;
    sine->low = ((x * z) * s) + (angle.low * most);
    cosine->high = most;
    cosine->low = (((1.0F - most) - half_square) + ((z * z) * c)) - (angle.low * x);
}

static pair_t normalized(pair_t number)
{
    pair_t result;
    result.high = number.high + number.low;
    result.low = (number.high - result.high) + number.low;
    return result;
}

/* Of an angle less a number of quarter turns, which is returned: sine and cosine before their last addition. */
static uint32_t unrounded(float angle, pair_t *sine, pair_t *cosine)
{
    const float size = fabsf(angle);
    uint32_t turns = 0U;
    pair_t x;
    x.high = angle;
    x.low = 0.0F;
    if (size <= 0.785398163F) {
        /* It is as it is. */
    } else if (size < 4194304.0F) {
        /* Adding 1.5 * 2^23 rounds to a whole number. */
        const float rounded = (angle * 0.636619772F) + 12582912.0F;
        const float quarters = rounded - 12582912.0F;
        /* Parts of 8 binary digits, with which the first three differences are exact; of the others the rounding is
         * kept. */
        const float rest = ((angle - (quarters * 1.5703125F)) - (quarters * 4.5776367e-4F))
            - (quarters * 2.5987625e-5F);
        const float fourth = quarters * 7.543713e-8F;
        const float fifth = quarters * 6.002665e-11F;
        const float middle = rest - fourth;
        x.high = middle - fifth;
        x.low = (((rest - middle) - fourth) + ((middle - x.high) - fifth)) - (quarters * 7.443548e-13F);
        x = normalized(x);
        turns = (uint32_t)((int32_t)quarters);
    } else {
        /* Numbers are half a radian and more apart; and what is not finite becomes no number. */
        x.high = angle * 0.0F;
    }
    near_zero_f32(x, sine, cosine);
    return turns;
}

#ifndef CARVALLO_OWN_SIN_COS_F32

void carvallo_sin_cos_f32(float angle, float *sine, float *cosine)
{
    pair_t s;
    pair_t c;
    const uint32_t turns = unrounded(angle, &s, &c);
    const bool is_odd = (turns & 1U) != 0U;
    const bool is_half = (turns & 2U) != 0U;
    const float first = s.high + s.low;
    const float second = c.high + c.low;
    *sine = is_odd ? second : first;
    *cosine = is_odd ? first : second;
    if (is_half) {
        *sine = -(*sine);
    }
    if (is_odd != is_half) {
        *cosine = -(*cosine);
    }
}

#endif

/* The first 12 digits of a number, and the others (Veltkamp 1968): products of such halves are exact. */
static pair_t halves(float x)
{
    const float large = x * 4097.0F;
    pair_t result;
    result.high = large - (large - x);
    result.low = x - result.high;
    return result;
}

float carvallo_tan_f32(float angle)
{
    pair_t s;
    pair_t c;
    const uint32_t turns = unrounded(angle, &s, &c);
    s = normalized(s);
    c = normalized(c);
    if ((turns & 1U) != 0U) {
        const pair_t sine = s;
        s.high = -c.high;
        s.low = -c.low;
        c = sine;
    }
    const float quotient = s.high / c.high;
    const pair_t q = halves(quotient);
    const pair_t d = halves(c.high);
    /* What the rounded quotient leaves of the sine. */
    const float rest = ((s.high - (q.high * d.high)) - ((q.high * d.low) + (q.low * d.high))) - (q.low * d.low);
    return quotient + (((rest + s.low) - (quotient * c.low)) / c.high);
}

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
