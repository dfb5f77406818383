/* @generated from generated/models/whipple.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 1f3729bd81655189
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * mT = mR + mB + mH + mF [kg]
 * xT = (xB*mB + xH*mH + w*mF)/mT [m]
 * zT = (-rR*mR + zB*mB + zH*mH - rF*mF)/mT [m]
 * ITxx = IRxx + IBxx + IHxx + IFxx + mR*rR^2 + mB*zB^2 + mH*zH^2 + mF*rF^2 [kg*m^2]
 * ITxz = IBxz + IHxz - mB*xB*zB - mH*xH*zH + mF*w*rF [kg*m^2]
 * ITzz = IRxx + IBzz + IHzz + IFxx + mB*xB^2 + mH*xH^2 + mF*w^2 [kg*m^2]
 * mA = mH + mF [kg]
 * xA = (xH*mH + w*mF)/mA [m]
 * zA = (zH*mH - rF*mF)/mA [m]
 * IAxx = IHxx + IFxx + mH*(zH - zA)^2 + mF*(rF + zA)^2 [kg*m^2]
 * IAxz = IHxz - mH*(xH - xA)*(zH - zA) + mF*(w - xA)*(rF + zA) [kg*m^2]
 * IAzz = IHzz + IFxx + mH*(xH - xA)^2 + mF*(w - xA)^2 [kg*m^2]
 * uA = (xA - w - c)*cos(lam) - zA*sin(lam) [m]
 * IAll = mA*uA^2 + IAxx*sin(lam)^2 + 2*IAxz*sin(lam)*cos(lam) + IAzz*cos(lam)^2 [kg*m^2]
 * IAlx = -mA*uA*zA + IAxx*sin(lam) + IAxz*cos(lam) [kg*m^2]
 * IAlz = mA*uA*xA + IAxz*sin(lam) + IAzz*cos(lam) [kg*m^2]
 * mu = (c/w)*cos(lam) [1]
 * SR = IRyy/rR [kg*m]
 * SF = IFyy/rF [kg*m]
 * ST = SR + SF [kg*m]
 * SA = mA*uA + mu*mT*xT [kg*m]
 * M_11 = ITxx [kg*m^2]
 * M_12 = M_21 = IAlx + mu*ITxz [kg*m^2]
 * M_22 = IAll + 2*mu*IAlz + mu^2*ITzz [kg*m^2]
 * C1_12 = mu*ST + SF*cos(lam) + (ITxz/w)*cos(lam) - mu*mT*zT [kg*m]
 * C1_21 = -(mu*ST + SF*cos(lam)) [kg*m]
 * C1_22 = (IAlz/w)*cos(lam) + mu*(SA + (ITzz/w)*cos(lam)) [kg*m]
 * K0_11 = mT*zT [kg*m]
 * K0_12 = K0_21 = -SA [kg*m]
 * K0_22 = -SA*sin(lam) [kg*m]
 * K2_12 = ((ST - mT*zT)/w)*cos(lam) [kg]
 * K2_22 = ((SA + SF*sin(lam))/w)*cos(lam) [kg]
 * @endverbatim
 */

#include "whipple.h"

#include "carvallo_trig.h"

#include <float.h>

const char *whipple_set_name(whipple_set_t set)
{
    static const char *const TEXTS[] = {
        "benchmark",
        "benchmark_2005",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *whipple_validity_text(whipple_validity_t validity)
{
    static const char *const TEXTS[] = {
        "Whipple: the parameters are valid",
        "Whipple: w in m must be finite and > 0",
        "Whipple: c in m must be finite",
        "Whipple: lam in rad must be finite and > -1.5707963267948966 and < 1.5707963267948966",
        "Whipple: g in N/kg must be finite and >= 0",
        "Whipple: rR in m must be finite and > 0",
        "Whipple: mR in kg must be finite and >= 0",
        "Whipple: IRxx in kg*m^2 must be finite and >= 0",
        "Whipple: IRyy in kg*m^2 must be finite and >= 0",
        "Whipple: xB in m must be finite",
        "Whipple: zB in m must be finite",
        "Whipple: mB in kg must be finite and >= 0",
        "Whipple: IBxx in kg*m^2 must be finite and >= 0",
        "Whipple: IByy in kg*m^2 must be finite and >= 0",
        "Whipple: IBzz in kg*m^2 must be finite and >= 0",
        "Whipple: IBxz in kg*m^2 must be finite",
        "Whipple: xH in m must be finite",
        "Whipple: zH in m must be finite",
        "Whipple: mH in kg must be finite and >= 0",
        "Whipple: IHxx in kg*m^2 must be finite and >= 0",
        "Whipple: IHyy in kg*m^2 must be finite and >= 0",
        "Whipple: IHzz in kg*m^2 must be finite and >= 0",
        "Whipple: IHxz in kg*m^2 must be finite",
        "Whipple: rF in m must be finite and > 0",
        "Whipple: mF in kg must be finite and >= 0",
        "Whipple: IFxx in kg*m^2 must be finite and >= 0",
        "Whipple: IFyy in kg*m^2 must be finite and >= 0",
        "Whipple: mR + mB + mH + mF in kg must be finite and > 0",
        "Whipple: mH + mF in kg must be finite and > 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t whipple_partials[WHIPPLE_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 23U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 23U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 62U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 54U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 46U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 60U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 50U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 50U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 59U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 43U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 64U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 24U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 24U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 63U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 42U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 45U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 61U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 51U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 51U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 52U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 53U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 22U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 22U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 72U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 55U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 47U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 71U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 49U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 49U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 56U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 44U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 73U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 11U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 4U, 79U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 4U, 81U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 1U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 4U, 78U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 12U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 27U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 0U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 5U, 19U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 82U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 6U, 74U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 7U, 80U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 7U, 80U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 7U, 36U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 8U, 26U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 8U, 26U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 8U, 83U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 8U, 20U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 8U, 89U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 8U, 93U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 8U, 93U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 8U, 94U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 77U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 13U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 28U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 28U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 9U, 92U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 3U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 9U, 91U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 14U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 10U, 85U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 10U, 85U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 10U, 86U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 10U, 96U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 10U, 90U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 10U, 2U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 10U, 84U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 10U, 84U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 10U, 87U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 10U, 95U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 10U, 88U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 11U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 13U, 82U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 13U, 74U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 14U, 25U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 14U, 25U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 14U, 18U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 15U, 98U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 15U, 98U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 99U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 58U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 67U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 97U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 97U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 100U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 76U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 15U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 32U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 32U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 102U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 65U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 105U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 5U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 101U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 101U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 103U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 57U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 104U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 16U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 33U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 33U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 34U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 107U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 68U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 30U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 30U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 35U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 106U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 66U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 18U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 18U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 18U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 18U, 108U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 20U, 110U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 20U, 75U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 21U, 29U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 21U, 29U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 21U, 70U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 21U, 18U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 21U, 21U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 22U, 17U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 22U, 48U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 22U, 48U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 69U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 22U, 114U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 22U, 113U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 22U, 120U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 22U, 7U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 22U, 119U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 22U, 119U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 22U, 109U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 115U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 22U, 121U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 23U, 10U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 37U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 37U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 38U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 123U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 41U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 6U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 31U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 31U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 39U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 122U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 40U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 111U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 75U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 116U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 112U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 117U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 118U, false}
};

const whipple_f64_t whipple_f64_sets[WHIPPLE_SETS] = {
    { /* benchmark */
        .w = 1.02,
        .c = 0.08,
        .lam = 0.3141592653589793,
        .g = 9.81,
        .rR = 0.3,
        .mR = 2.0,
        .IRxx = 0.0603,
        .IRyy = 0.12,
        .xB = 0.3,
        .zB = (-0.9),
        .mB = 85.0,
        .IBxx = 9.2,
        .IByy = 11.0,
        .IBzz = 2.8,
        .IBxz = 2.4,
        .xH = 0.9,
        .zH = (-0.7),
        .mH = 4.0,
        .IHxx = 0.05892,
        .IHyy = 0.06,
        .IHzz = 0.00708,
        .IHxz = (-0.00756),
        .rF = 0.35,
        .mF = 3.0,
        .IFxx = 0.1405,
        .IFyy = 0.28
    },
    { /* benchmark_2005 */
        .w = 1.02,
        .c = 0.08,
        .lam = 0.3217505543966422,
        .g = 9.81,
        .rR = 0.3,
        .mR = 2.0,
        .IRxx = 0.06,
        .IRyy = 0.12,
        .xB = 0.3,
        .zB = (-0.9),
        .mB = 85.0,
        .IBxx = 9.2,
        .IByy = 11.0,
        .IBzz = 2.8,
        .IBxz = 2.4,
        .xH = 0.9,
        .zH = (-0.7),
        .mH = 4.0,
        .IHxx = 0.0546,
        .IHyy = 0.06,
        .IHzz = 0.0114,
        .IHxz = (-0.0162),
        .rF = 0.35,
        .mF = 3.0,
        .IFxx = 0.14,
        .IFyy = 0.28
    }
};

whipple_validity_t whipple_f64_validate(const whipple_f64_t *p)
{
    whipple_validity_t validity = WHIPPLE_VALID;
    if (!((p->w > 0.0) && (p->w <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_w;
    } else if (!((p->c >= -DBL_MAX) && (p->c <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_c;
    } else if (!((p->lam > (-1.5707963267948966)) && (p->lam < 1.5707963267948966))) {
        validity = WHIPPLE_INVALID_lam;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_g;
    } else if (!((p->rR > 0.0) && (p->rR <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_rR;
    } else if (!((p->mR >= 0.0) && (p->mR <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_mR;
    } else if (!((p->IRxx >= 0.0) && (p->IRxx <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0) && (p->IRyy <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_IRyy;
    } else if (!((p->xB >= -DBL_MAX) && (p->xB <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_xB;
    } else if (!((p->zB >= -DBL_MAX) && (p->zB <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_zB;
    } else if (!((p->mB >= 0.0) && (p->mB <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_mB;
    } else if (!((p->IBxx >= 0.0) && (p->IBxx <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0) && (p->IByy <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0) && (p->IBzz <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_IBzz;
    } else if (!((p->IBxz >= -DBL_MAX) && (p->IBxz <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_IBxz;
    } else if (!((p->xH >= -DBL_MAX) && (p->xH <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_xH;
    } else if (!((p->zH >= -DBL_MAX) && (p->zH <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_zH;
    } else if (!((p->mH >= 0.0) && (p->mH <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_mH;
    } else if (!((p->IHxx >= 0.0) && (p->IHxx <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0) && (p->IHyy <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0) && (p->IHzz <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_IHzz;
    } else if (!((p->IHxz >= -DBL_MAX) && (p->IHxz <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_IHxz;
    } else if (!((p->rF > 0.0) && (p->rF <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_rF;
    } else if (!((p->mF >= 0.0) && (p->mF <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_mF;
    } else if (!((p->IFxx >= 0.0) && (p->IFxx <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0) && (p->IFyy <= DBL_MAX))) {
        validity = WHIPPLE_INVALID_IFyy;
    } else {
        const double t4 = p->mH + p->mF;
        const double t6 = p->mR + p->mB + t4;
        if (!((t6 > 0.0) && (t6 <= DBL_MAX))) {
            validity = WHIPPLE_REQUIREMENT_1;
        } else if (!((t4 > 0.0) && (t4 <= DBL_MAX))) {
            validity = WHIPPLE_REQUIREMENT_2;
        } else {
            /* All requirements hold. */
        }
    }
    return validity;
}

void whipple_f64_matrices(const whipple_f64_t *p, whipple_f64_matrices_t *matrices)
{
    const double t4 = p->rR * p->mR;
    const double t8 = p->zB * p->mB;
    const double t12 = p->rF * p->mF;
    const double t16 = p->zH * p->mH;
    const double t22 = (p->rF * t12) + (p->zH * t16) + p->IHxx + p->IFxx;
    const double ITxx = p->IRxx + p->IBxx + (p->rR * t4) + (p->zB * t8) + t22;
    const double t36 = p->IHxz + (t12 * p->w) - (t16 * p->xH);
    const double ITxz = p->IBxz + t36 - (t8 * p->xB);
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t42 = cos_lam / p->w;
    const double mu = p->c * t42;
    const double t47 = p->w + p->c - p->xH;
    const double t51 = cos_lam * (p->IHxz + (t16 * t47) - (t12 * p->c));
    const double t54 = t51 + (t22 * sin_lam);
    const double M_12 = (ITxz * mu) + t54;
    const double t57 = p->IFxx + p->IHzz;
    const double t58 = p->mH * t47;
    const double t60 = p->mF * p->c;
    const double t69 = p->mH * p->xH;
    const double IAlz = (cos_lam * (t57 - (p->w * t60) - (t47 * t69))) + (t36 * sin_lam);
    const double t77 = p->mB * p->xB;
    const double t80 = p->mF * p->w;
    const double ITzz = p->IRxx + t57 + p->IBzz + (p->xB * t77) + (p->xH * t69) + (p->w * t80);
    const double t88 = IAlz + (mu * ITzz);
    const double M_22 = (cos_lam * cos_lam * (t57 + (t47 * t58) + (p->c * t60))) + (sin_lam * (t51 +
        t54)) + (mu * (IAlz + t88));
    const double SF = p->IFyy / p->rF;
    const double SR = p->IRyy / p->rR;
    const double ST = SF + SR;
    const double t100 = t12 - t16;
    const double t101 = t8 - t4;
    const double t103 = ST + (t100 - t101);
    const double C1_12 = t42 * (ITxz + (p->w * SF) + (p->c * t103));
    const double K0_12 = (cos_lam * (t58 + t60)) - ((mu * (t69 + t77 + t80)) + (sin_lam * t100));
    const double C1_22 = (t42 * t88) - (mu * K0_12);
    const double K0_22 = sin_lam * K0_12;
    const double K2_12 = t42 * t103;
    const double K2_22 = t42 * ((sin_lam * SF) - K0_12);
    const double C1_21 = -((mu * ST) + (cos_lam * SF));
    const double K0_11 = t101 - t100;
    matrices->m[0][0] = ITxx;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k2[0][0] = 0.0;
    matrices->k2[0][1] = K2_12;
    matrices->k2[1][0] = 0.0;
    matrices->k2[1][1] = K2_22;
}

carvallo_system_error_t whipple_f64_at_speed(const whipple_f64_matrices_t *matrices, double speed,
    double gravity, whipple_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed) && carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < WHIPPLE_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_N; column++) {
            const double damping = matrices->c1[row][column] * speed;
            const double stiffness = (matrices->k0[row][column] * gravity) +
                (matrices->k2[row][column] * speed * speed);
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->c1[row][column]) &&
                carvallo_is_finite_f64(matrices->k0[row][column]) &&
                carvallo_is_finite_f64(matrices->k2[row][column]);
            is_in_range = is_in_range && carvallo_is_finite_f64(damping) &&
                carvallo_is_finite_f64(stiffness);
            system->m[row][column] = matrices->m[row][column];
            system->c[row][column] = damping;
            system->k[row][column] = stiffness;
        }
    }
    if (!is_finite) {
        error = CARVALLO_SYSTEM_NOT_FINITE;
    } else if (!is_in_range) {
        error = CARVALLO_SYSTEM_OUT_OF_RANGE;
    } else {
        /* All is well. */
    }
    return error;
}

carvallo_system_error_t whipple_f64_state_space(const whipple_f64_system_t *system,
    whipple_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[WHIPPLE_N * WHIPPLE_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * WHIPPLE_N * WHIPPLE_N];
    for (size_t row = 0U; row < WHIPPLE_N; row++) {
        double *const solved = &x[3U * WHIPPLE_N * row];
        for (size_t column = 0U; column < WHIPPLE_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * WHIPPLE_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHIPPLE_N + column] = -system->c[row][column];
            solved[(2U * WHIPPLE_N) + column] = 0.0;
        }
        solved[(2U * WHIPPLE_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[WHIPPLE_N * WHIPPLE_N];
        error = carvallo_solve_f64(WHIPPLE_N, m, terms, 3U * WHIPPLE_N, x);
    }
    for (size_t row = 0U; row < (2U * WHIPPLE_N); row++) {
        for (size_t column = 0U; column < (2U * WHIPPLE_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < WHIPPLE_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHIPPLE_N; row++) {
            const size_t target = WHIPPLE_N + row;
            for (size_t column = 0U; column < (2U * WHIPPLE_N); column++) {
                space->a[target][column] = x[(3U * WHIPPLE_N * row) + column];
            }
            for (size_t column = 0U; column < WHIPPLE_N; column++) {
                space->b[target][column] = x[(3U * WHIPPLE_N * row) + (2U * WHIPPLE_N) + column];
            }
            space->a[row][WHIPPLE_N + row] = 1.0;
        }
    }
    return error;
}

void whipple_f64_derivatives(const whipple_f64_t *p, whipple_f64_matrices_t *matrices,
    whipple_f64_derivatives_t *derivatives)
{
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double M_11_mF = p->rF * p->rF;
    const double t28 = p->zH * p->mH;
    const double t33 = p->IFxx + p->IHxx + (p->mF * M_11_mF) + (p->zH * t28);
    const double t34 = p->rR * p->mR;
    const double t35 = p->zB * p->mB;
    const double t36 = p->mF * p->rF;
    const double M_11_rR = t34 + t34;
    const double M_11_mR = p->rR * p->rR;
    const double M_11_zB = t35 + t35;
    const double M_11_mB = p->zB * p->zB;
    const double M_11_zH = t28 + t28;
    const double M_11_mH = p->zH * p->zH;
    const double M_11_rF = t36 + t36;
    const double t44 = p->mF * p->w;
    const double t48 = (t28 * p->xH) - p->IHxz - (p->rF * t44);
    const double M_11 = t33 + p->IRxx + p->IBxx + (p->rR * t34) + (p->zB * t35);
    const double t55 = 1.0 / p->w;
    const double t56 = p->c + p->w;
    const double t57 = p->xH - t56;
    const double t58 = p->mH * t57;
    const double t60 = p->IBxz - (t35 * p->xB);
    const double t61 = p->IFxx + p->IHzz;
    const double t62 = t48 * t55;
    const double t63 = p->c * t55;
    const double t65 = p->IHxz - (p->zH * t58);
    const double t66 = p->mH * p->xH;
    const double t68 = t61 + (p->xH * t66);
    const double t69 = p->mB * p->xB;
    const double t70 = 1.0 / p->rF;
    const double t71 = 1.0 / p->rR;
    const double t72 = t36 + t62;
    const double t73 = t28 - t36;
    const double K0_11 = t35 + t73 - t34;
    const double t83 = t44 - (t55 * (p->IRxx + t68 + (p->xB * t69) + (p->w * t44) + p->IBzz));
    const double t87 = p->mF - (t55 * (t44 + t66 + t69));
    const double t90 = cos_lam * (t57 + (p->xH * t63));
    const double t95 = (t33 * sin_lam) - (cos_lam * ((p->c * t72) - t65));
    const double t97 = t72 - (t55 * t60);
    const double C1_12_IBxz = cos_lam * t55;
    const double K2_12_mR = p->rR * C1_12_IBxz;
    const double t100 = t35 * C1_12_IBxz;
    const double K2_22_SF = sin_lam * C1_12_IBxz;
    const double M_12_lam = (t33 * cos_lam) + (sin_lam * ((p->c * t97) - t65));
    const double M_12_w = cos_lam * (t28 + (t63 * t97));
    const double M_12_c = cos_lam * (t28 - t97);
    const double mu = p->c * C1_12_IBxz;
    const double t113 = t35 * mu;
    const double C1_12_mR = p->rR * mu;
    const double t115 = mu * t69;
    const double M_12_IHxz = cos_lam + mu;
    const double t117 = p->zH * sin_lam;
    const double K0_12_mH = t117 - t90;
    const double t119 = t90 - t117;
    const double K0_12_mF = (p->c * (cos_lam - (p->w * C1_12_IBxz))) - (p->rF * sin_lam);
    const double M_12_zH = p->mH * (t117 - t119);
    const double M_12 = t95 + (mu * t60);
    const double t129 = p->zH * t119;
    const double M_22_mH = t119 * t119;
    const double t131 = sin_lam * t119;
    const double SF = p->IFyy * t70;
    const double t133 = p->IRyy * t71;
    const double t138 = C1_12_IBxz * ((p->c * t83) + (t56 * t66) - t68);
    const double K2_12_IRyy = C1_12_IBxz * t71;
    const double t140 = p->rF * K0_12_mF;
    const double M_22_mF = K0_12_mF * K0_12_mF;
    const double K0_22_mF = sin_lam * K0_12_mF;
    const double t143 = p->mF * K0_12_mF;
    const double t144 = C1_12_IBxz * K0_12_mF;
    const double ST = SF + t133;
    const double t146 = ST - K0_11;
    const double t152 = t55 * (t60 + (p->w * SF) + (p->c * t146) - t48);
    const double t153 = t56 * t144;
    const double K2_12 = C1_12_IBxz * t146;
    const double t155 = t55 * t146;
    const double t156 = C1_12_IBxz * t155;
    const double t157 = sin_lam * t155;
    const double t158 = C1_12_IBxz * ST;
    const double t159 = t63 * ST;
    const double C1_21_w = C1_12_IBxz * t159;
    const double t161 = SF + t159;
    const double C1_21_lam = sin_lam * t161;
    const double C1_21 = -(cos_lam * t161);
    const double M_12_rF = (sin_lam * t36) - t143;
    const double t167 = p->c * t87;
    const double t168 = t58 - t167;
    const double K0_12 = (sin_lam * t73) - (cos_lam * t168);
    const double K0_12_lam = (cos_lam * t73) + (sin_lam * t168);
    const double t176 = t138 + (sin_lam * t62);
    const double t177 = cos_lam + cos_lam;
    const double t178 = t119 + t119;
    const double t179 = p->mH * cos_lam;
    const double t180 = t178 * t179;
    const double t181 = p->c + p->xH;
    const double t182 = t179 * t181;
    const double K0_12_w = t179 - (mu * t87);
    const double t187 = K0_12 + (cos_lam * (t83 + t167));
    const double K0_22 = sin_lam * K0_12;
    const double K0_12_c = t179 + (cos_lam * t87);
    const double K0_22_c = sin_lam * K0_12_c;
    const double t192 = C1_12_IBxz * K0_12_c;
    const double ITzz_mF = t36 + SF - t152;
    const double C1_12_w = C1_12_IBxz * ITzz_mF;
    const double C1_12 = cos_lam * t152;
    const double t197 = sin_lam * t152;
    const double K0_22_lam = (cos_lam * K0_12) + (sin_lam * K0_12_lam);
    const double t201 = t55 * t179;
    const double t202 = p->zH * t201;
    const double t204 = -(sin_lam * K0_12_w);
    const double t205 = t143 - t176;
    const double t212 = (M_12_IHxz * t61) + (sin_lam * p->IHxz) + (t58 * t119) + (p->c * t205);
    const double t214 = t176 + (t63 * K0_12);
    const double t216 = (sin_lam * SF) - K0_12;
    const double K2_22 = C1_12_IBxz * t216;
    const double t221 = C1_12_IBxz * (t205 + t182 - (t63 * t187));
    const double t223 = C1_12_IBxz * (t182 + t187);
    const double t224 = t205 * t177;
    const double t226 = (t63 * t224) + t180;
    const double M_22_c = t224 - t180;
    const double t228 = t55 * t216;
    const double t230 = C1_12_IBxz * (K0_12_w + t228);
    const double t231 = t55 * t182;
    const double K2_22_mH = C1_12_IBxz * t119;
    const double C1_22_xH = (p->mH * K2_22_mH) + (M_12_IHxz * t231);
    const double C1_22_mH = t181 * K2_22_mH;
    const double C1_22 = -(cos_lam * t214);
    const double t239 = sin_lam + sin_lam;
    const double t240 = t143 * t239;
    const double M_22_IHxz = M_12_IHxz * t239;
    const double t242 = cos_lam * C1_12_IBxz;
    const double C1_22_lam = (sin_lam * (t138 + t214)) - (mu * K0_12_lam) - (t48 * t242);
    const double M_22_lam = (t95 * t177) - (t212 * t239);
    const double M_22 = (sin_lam * t95) + (cos_lam * t212);
    const double K2_22_lam = (SF * t242) - (C1_12_IBxz * K0_12_lam) - (sin_lam * t228);
    const double C1_22_ITzz = t63 * t242;
    const double C1_22_IHzz = t242 + C1_22_ITzz;
    const double K2_22_xH = p->mH * C1_22_IHzz;
    const double K2_22_xB = p->mB * C1_22_ITzz;
    const double K2_12_rR = (p->mR * C1_12_IBxz) - (t133 * K2_12_IRyy);
    const double C1_12_rR = p->c * K2_12_rR;
    const double C1_12_IRyy = p->c * K2_12_IRyy;
    const double C1_21_rR = t133 * C1_12_IRyy;
    const double M_22_ITzz = mu * mu;
    const double t271 = t69 * M_22_ITzz;
    const double M_22_xB = t271 + t271;
    const double t273 = mu * p->xB;
    const double t274 = p->zB * t273;
    const double M_22_mB = t273 * t273;
    const double t276 = sin_lam * t273;
    const double K2_22_mB = C1_12_IBxz * t273;
    const double t278 = p->c + p->xB;
    const double C1_22_xB = (p->xB + t278) * K2_22_xB;
    const double C1_22_mB = t278 * K2_22_mB;
    const double t282 = p->mB * C1_12_IBxz;
    const double t283 = t278 * t282;
    const double t284 = p->c * t282;
    const double t285 = sin_lam * t284;
    const double t286 = p->zB * C1_12_IBxz;
    const double t287 = t278 * t286;
    const double t288 = p->mH * M_12_IHxz;
    const double t289 = p->zH * t288;
    const double M_22_xH = t178 * t288;
    const double t291 = sin_lam * t288;
    const double K0_12_zH = p->mH * sin_lam;
    const double t293 = t178 * K0_12_zH;
    const double K0_22_zH = sin_lam * K0_12_zH;
    const double t295 = C1_12_IBxz * K0_12_zH;
    const double t296 = t181 * t295;
    const double t297 = p->zH * C1_12_IBxz;
    const double t298 = t181 * t297;
    const double M_22_IHxx = sin_lam * sin_lam;
    const double t300 = p->mF * M_22_IHxx;
    const double M_22_IHzz = M_12_IHxz * M_12_IHxz;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double t303 = M_12_IHxz * t70;
    const double C1_21_rF = SF * t303;
    const double t305 = t56 * C1_12_IBxz;
    const double t307 = p->mF - (t70 * SF);
    const double C1_12_rF = t305 * t307;
    const double K2_12_rF = C1_12_IBxz * t307;
    const double C1_12_IFyy = t70 * t305;
    const double K2_12_IFyy = C1_12_IBxz * t70;
    const double K2_22_IFyy = sin_lam * K2_12_IFyy;
    const double t313 = p->mF * sin_lam;
    const double C1_22_rF = t305 * t313;
    const double K2_22_rF = sin_lam * K2_12_rF;
    const double K2_12_mF = p->rF * C1_12_IBxz;
    const double C1_12_mF = t56 * K2_12_mF;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k2[0][0] = 0.0;
    matrices->k2[0][1] = K2_12;
    matrices->k2[1][0] = 0.0;
    matrices->k2[1][1] = K2_22;
    derivatives->values[0] = p->rR;
    derivatives->values[1] = p->mR;
    derivatives->values[2] = p->zB;
    derivatives->values[3] = p->mB;
    derivatives->values[4] = p->zH;
    derivatives->values[5] = p->mH;
    derivatives->values[6] = p->rF;
    derivatives->values[7] = p->mF;
    derivatives->values[8] = 1.0;
    derivatives->values[9] = sin_lam;
    derivatives->values[10] = M_11_mF;
    derivatives->values[11] = M_11_rR;
    derivatives->values[12] = M_11_mR;
    derivatives->values[13] = M_11_zB;
    derivatives->values[14] = M_11_mB;
    derivatives->values[15] = M_11_zH;
    derivatives->values[16] = M_11_mH;
    derivatives->values[17] = M_11_rF;
    derivatives->values[18] = C1_12_IBxz;
    derivatives->values[19] = K2_12_mR;
    derivatives->values[20] = t100;
    derivatives->values[21] = K2_22_SF;
    derivatives->values[22] = M_12_lam;
    derivatives->values[23] = M_12_w;
    derivatives->values[24] = M_12_c;
    derivatives->values[25] = mu;
    derivatives->values[26] = t113;
    derivatives->values[27] = C1_12_mR;
    derivatives->values[28] = t115;
    derivatives->values[29] = M_12_IHxz;
    derivatives->values[30] = K0_12_mH;
    derivatives->values[31] = K0_12_mF;
    derivatives->values[32] = M_12_zH;
    derivatives->values[33] = t129;
    derivatives->values[34] = M_22_mH;
    derivatives->values[35] = t131;
    derivatives->values[36] = K2_12_IRyy;
    derivatives->values[37] = t140;
    derivatives->values[38] = M_22_mF;
    derivatives->values[39] = K0_22_mF;
    derivatives->values[40] = t144;
    derivatives->values[41] = t153;
    derivatives->values[42] = K2_12;
    derivatives->values[43] = t156;
    derivatives->values[44] = t157;
    derivatives->values[45] = t158;
    derivatives->values[46] = C1_21_w;
    derivatives->values[47] = C1_21_lam;
    derivatives->values[48] = M_12_rF;
    derivatives->values[49] = K0_12_lam;
    derivatives->values[50] = K0_12_w;
    derivatives->values[51] = K0_12_c;
    derivatives->values[52] = K0_22_c;
    derivatives->values[53] = t192;
    derivatives->values[54] = C1_12_w;
    derivatives->values[55] = t197;
    derivatives->values[56] = K0_22_lam;
    derivatives->values[57] = t201;
    derivatives->values[58] = t202;
    derivatives->values[59] = t204;
    derivatives->values[60] = t221;
    derivatives->values[61] = t223;
    derivatives->values[62] = t226;
    derivatives->values[63] = M_22_c;
    derivatives->values[64] = t230;
    derivatives->values[65] = t231;
    derivatives->values[66] = K2_22_mH;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = C1_22_mH;
    derivatives->values[69] = t240;
    derivatives->values[70] = M_22_IHxz;
    derivatives->values[71] = C1_22_lam;
    derivatives->values[72] = M_22_lam;
    derivatives->values[73] = K2_22_lam;
    derivatives->values[74] = C1_22_ITzz;
    derivatives->values[75] = C1_22_IHzz;
    derivatives->values[76] = K2_22_xH;
    derivatives->values[77] = K2_22_xB;
    derivatives->values[78] = K2_12_rR;
    derivatives->values[79] = C1_12_rR;
    derivatives->values[80] = C1_12_IRyy;
    derivatives->values[81] = C1_21_rR;
    derivatives->values[82] = M_22_ITzz;
    derivatives->values[83] = M_22_xB;
    derivatives->values[84] = t273;
    derivatives->values[85] = t274;
    derivatives->values[86] = M_22_mB;
    derivatives->values[87] = t276;
    derivatives->values[88] = K2_22_mB;
    derivatives->values[89] = C1_22_xB;
    derivatives->values[90] = C1_22_mB;
    derivatives->values[91] = t282;
    derivatives->values[92] = t283;
    derivatives->values[93] = t284;
    derivatives->values[94] = t285;
    derivatives->values[95] = t286;
    derivatives->values[96] = t287;
    derivatives->values[97] = t288;
    derivatives->values[98] = t289;
    derivatives->values[99] = M_22_xH;
    derivatives->values[100] = t291;
    derivatives->values[101] = K0_12_zH;
    derivatives->values[102] = t293;
    derivatives->values[103] = K0_22_zH;
    derivatives->values[104] = t295;
    derivatives->values[105] = t296;
    derivatives->values[106] = t297;
    derivatives->values[107] = t298;
    derivatives->values[108] = M_22_IHxx;
    derivatives->values[109] = t300;
    derivatives->values[110] = M_22_IHzz;
    derivatives->values[111] = M_22_IFxx;
    derivatives->values[112] = t303;
    derivatives->values[113] = C1_21_rF;
    derivatives->values[114] = C1_12_rF;
    derivatives->values[115] = K2_12_rF;
    derivatives->values[116] = C1_12_IFyy;
    derivatives->values[117] = K2_12_IFyy;
    derivatives->values[118] = K2_22_IFyy;
    derivatives->values[119] = t313;
    derivatives->values[120] = C1_22_rF;
    derivatives->values[121] = K2_22_rF;
    derivatives->values[122] = K2_12_mF;
    derivatives->values[123] = C1_12_mF;
}

void whipple_f64_with_respect_to(const whipple_f64_derivatives_t *derivatives, size_t parameter,
    whipple_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHIPPLE_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
            matrices->k2[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < WHIPPLE_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &whipple_partials[position];
        if (partial->parameter == parameter) {
            const double value = derivatives->values[partial->value];
            const double signed_value = partial->is_negative ? (-value) : value;
            switch (partial->matrix) {
            case CARVALLO_MATRIX_M:
                matrices->m[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_C1:
                matrices->c1[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_K0:
                matrices->k0[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_K2:
                matrices->k2[partial->row][partial->column] = signed_value;
                break;
            default:
                /* The model has no other matrix. */
                break;
            }
        }
    }
}

const whipple_f32_t whipple_f32_sets[WHIPPLE_SETS] = {
    { /* benchmark */
        .w = 1.02F,
        .c = 0.08F,
        .lam = 0.31415927F,
        .g = 9.81F,
        .rR = 0.3F,
        .mR = 2.0F,
        .IRxx = 0.0603F,
        .IRyy = 0.12F,
        .xB = 0.3F,
        .zB = (-0.9F),
        .mB = 85.0F,
        .IBxx = 9.2F,
        .IByy = 11.0F,
        .IBzz = 2.8F,
        .IBxz = 2.4F,
        .xH = 0.9F,
        .zH = (-0.7F),
        .mH = 4.0F,
        .IHxx = 0.05892F,
        .IHyy = 0.06F,
        .IHzz = 0.00708F,
        .IHxz = (-0.00756F),
        .rF = 0.35F,
        .mF = 3.0F,
        .IFxx = 0.1405F,
        .IFyy = 0.28F
    },
    { /* benchmark_2005 */
        .w = 1.02F,
        .c = 0.08F,
        .lam = 0.32175055F,
        .g = 9.81F,
        .rR = 0.3F,
        .mR = 2.0F,
        .IRxx = 0.06F,
        .IRyy = 0.12F,
        .xB = 0.3F,
        .zB = (-0.9F),
        .mB = 85.0F,
        .IBxx = 9.2F,
        .IByy = 11.0F,
        .IBzz = 2.8F,
        .IBxz = 2.4F,
        .xH = 0.9F,
        .zH = (-0.7F),
        .mH = 4.0F,
        .IHxx = 0.0546F,
        .IHyy = 0.06F,
        .IHzz = 0.0114F,
        .IHxz = (-0.0162F),
        .rF = 0.35F,
        .mF = 3.0F,
        .IFxx = 0.14F,
        .IFyy = 0.28F
    }
};

whipple_validity_t whipple_f32_validate(const whipple_f32_t *p)
{
    whipple_validity_t validity = WHIPPLE_VALID;
    if (!((p->w > 0.0F) && (p->w <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_w;
    } else if (!((p->c >= -FLT_MAX) && (p->c <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_c;
    } else if (!((p->lam > (-1.5707964F)) && (p->lam < 1.5707964F))) {
        validity = WHIPPLE_INVALID_lam;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_g;
    } else if (!((p->rR > 0.0F) && (p->rR <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_rR;
    } else if (!((p->mR >= 0.0F) && (p->mR <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_mR;
    } else if (!((p->IRxx >= 0.0F) && (p->IRxx <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0F) && (p->IRyy <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_IRyy;
    } else if (!((p->xB >= -FLT_MAX) && (p->xB <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_xB;
    } else if (!((p->zB >= -FLT_MAX) && (p->zB <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_zB;
    } else if (!((p->mB >= 0.0F) && (p->mB <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_mB;
    } else if (!((p->IBxx >= 0.0F) && (p->IBxx <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0F) && (p->IByy <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0F) && (p->IBzz <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_IBzz;
    } else if (!((p->IBxz >= -FLT_MAX) && (p->IBxz <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_IBxz;
    } else if (!((p->xH >= -FLT_MAX) && (p->xH <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_xH;
    } else if (!((p->zH >= -FLT_MAX) && (p->zH <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_zH;
    } else if (!((p->mH >= 0.0F) && (p->mH <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_mH;
    } else if (!((p->IHxx >= 0.0F) && (p->IHxx <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0F) && (p->IHyy <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0F) && (p->IHzz <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_IHzz;
    } else if (!((p->IHxz >= -FLT_MAX) && (p->IHxz <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_IHxz;
    } else if (!((p->rF > 0.0F) && (p->rF <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_rF;
    } else if (!((p->mF >= 0.0F) && (p->mF <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_mF;
    } else if (!((p->IFxx >= 0.0F) && (p->IFxx <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0F) && (p->IFyy <= FLT_MAX))) {
        validity = WHIPPLE_INVALID_IFyy;
    } else {
        const float t4 = p->mH + p->mF;
        const float t6 = p->mR + p->mB + t4;
        if (!((t6 > 0.0F) && (t6 <= FLT_MAX))) {
            validity = WHIPPLE_REQUIREMENT_1;
        } else if (!((t4 > 0.0F) && (t4 <= FLT_MAX))) {
            validity = WHIPPLE_REQUIREMENT_2;
        } else {
            /* All requirements hold. */
        }
    }
    return validity;
}

void whipple_f32_matrices(const whipple_f32_t *p, whipple_f32_matrices_t *matrices)
{
    const float t4 = p->rR * p->mR;
    const float t8 = p->zB * p->mB;
    const float t12 = p->rF * p->mF;
    const float t16 = p->zH * p->mH;
    const float t22 = (p->rF * t12) + (p->zH * t16) + p->IHxx + p->IFxx;
    const float ITxx = p->IRxx + p->IBxx + (p->rR * t4) + (p->zB * t8) + t22;
    const float t36 = p->IHxz + (t12 * p->w) - (t16 * p->xH);
    const float ITxz = p->IBxz + t36 - (t8 * p->xB);
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t42 = cos_lam / p->w;
    const float mu = p->c * t42;
    const float t47 = p->w + p->c - p->xH;
    const float t51 = cos_lam * (p->IHxz + (t16 * t47) - (t12 * p->c));
    const float t54 = t51 + (t22 * sin_lam);
    const float M_12 = (ITxz * mu) + t54;
    const float t57 = p->IFxx + p->IHzz;
    const float t58 = p->mH * t47;
    const float t60 = p->mF * p->c;
    const float t69 = p->mH * p->xH;
    const float IAlz = (cos_lam * (t57 - (p->w * t60) - (t47 * t69))) + (t36 * sin_lam);
    const float t77 = p->mB * p->xB;
    const float t80 = p->mF * p->w;
    const float ITzz = p->IRxx + t57 + p->IBzz + (p->xB * t77) + (p->xH * t69) + (p->w * t80);
    const float t88 = IAlz + (mu * ITzz);
    const float M_22 = (cos_lam * cos_lam * (t57 + (t47 * t58) + (p->c * t60))) + (sin_lam * (t51 +
        t54)) + (mu * (IAlz + t88));
    const float SF = p->IFyy / p->rF;
    const float SR = p->IRyy / p->rR;
    const float ST = SF + SR;
    const float t100 = t12 - t16;
    const float t101 = t8 - t4;
    const float t103 = ST + (t100 - t101);
    const float C1_12 = t42 * (ITxz + (p->w * SF) + (p->c * t103));
    const float K0_12 = (cos_lam * (t58 + t60)) - ((mu * (t69 + t77 + t80)) + (sin_lam * t100));
    const float C1_22 = (t42 * t88) - (mu * K0_12);
    const float K0_22 = sin_lam * K0_12;
    const float K2_12 = t42 * t103;
    const float K2_22 = t42 * ((sin_lam * SF) - K0_12);
    const float C1_21 = -((mu * ST) + (cos_lam * SF));
    const float K0_11 = t101 - t100;
    matrices->m[0][0] = ITxx;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k2[0][0] = 0.0F;
    matrices->k2[0][1] = K2_12;
    matrices->k2[1][0] = 0.0F;
    matrices->k2[1][1] = K2_22;
}

carvallo_system_error_t whipple_f32_at_speed(const whipple_f32_matrices_t *matrices, float speed,
    float gravity, whipple_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed) && carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < WHIPPLE_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_N; column++) {
            const float damping = matrices->c1[row][column] * speed;
            const float stiffness = (matrices->k0[row][column] * gravity) +
                (matrices->k2[row][column] * speed * speed);
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->c1[row][column]) &&
                carvallo_is_finite_f32(matrices->k0[row][column]) &&
                carvallo_is_finite_f32(matrices->k2[row][column]);
            is_in_range = is_in_range && carvallo_is_finite_f32(damping) &&
                carvallo_is_finite_f32(stiffness);
            system->m[row][column] = matrices->m[row][column];
            system->c[row][column] = damping;
            system->k[row][column] = stiffness;
        }
    }
    if (!is_finite) {
        error = CARVALLO_SYSTEM_NOT_FINITE;
    } else if (!is_in_range) {
        error = CARVALLO_SYSTEM_OUT_OF_RANGE;
    } else {
        /* All is well. */
    }
    return error;
}

carvallo_system_error_t whipple_f32_state_space(const whipple_f32_system_t *system,
    whipple_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[WHIPPLE_N * WHIPPLE_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * WHIPPLE_N * WHIPPLE_N];
    for (size_t row = 0U; row < WHIPPLE_N; row++) {
        float *const solved = &x[3U * WHIPPLE_N * row];
        for (size_t column = 0U; column < WHIPPLE_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * WHIPPLE_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHIPPLE_N + column] = -system->c[row][column];
            solved[(2U * WHIPPLE_N) + column] = 0.0F;
        }
        solved[(2U * WHIPPLE_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[WHIPPLE_N * WHIPPLE_N];
        error = carvallo_solve_f32(WHIPPLE_N, m, terms, 3U * WHIPPLE_N, x);
    }
    for (size_t row = 0U; row < (2U * WHIPPLE_N); row++) {
        for (size_t column = 0U; column < (2U * WHIPPLE_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < WHIPPLE_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHIPPLE_N; row++) {
            const size_t target = WHIPPLE_N + row;
            for (size_t column = 0U; column < (2U * WHIPPLE_N); column++) {
                space->a[target][column] = x[(3U * WHIPPLE_N * row) + column];
            }
            for (size_t column = 0U; column < WHIPPLE_N; column++) {
                space->b[target][column] = x[(3U * WHIPPLE_N * row) + (2U * WHIPPLE_N) + column];
            }
            space->a[row][WHIPPLE_N + row] = 1.0F;
        }
    }
    return error;
}

void whipple_f32_derivatives(const whipple_f32_t *p, whipple_f32_matrices_t *matrices,
    whipple_f32_derivatives_t *derivatives)
{
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float M_11_mF = p->rF * p->rF;
    const float t28 = p->zH * p->mH;
    const float t33 = p->IFxx + p->IHxx + (p->mF * M_11_mF) + (p->zH * t28);
    const float t34 = p->rR * p->mR;
    const float t35 = p->zB * p->mB;
    const float t36 = p->mF * p->rF;
    const float M_11_rR = t34 + t34;
    const float M_11_mR = p->rR * p->rR;
    const float M_11_zB = t35 + t35;
    const float M_11_mB = p->zB * p->zB;
    const float M_11_zH = t28 + t28;
    const float M_11_mH = p->zH * p->zH;
    const float M_11_rF = t36 + t36;
    const float t44 = p->mF * p->w;
    const float t48 = (t28 * p->xH) - p->IHxz - (p->rF * t44);
    const float M_11 = t33 + p->IRxx + p->IBxx + (p->rR * t34) + (p->zB * t35);
    const float t55 = 1.0F / p->w;
    const float t56 = p->c + p->w;
    const float t57 = p->xH - t56;
    const float t58 = p->mH * t57;
    const float t60 = p->IBxz - (t35 * p->xB);
    const float t61 = p->IFxx + p->IHzz;
    const float t62 = t48 * t55;
    const float t63 = p->c * t55;
    const float t65 = p->IHxz - (p->zH * t58);
    const float t66 = p->mH * p->xH;
    const float t68 = t61 + (p->xH * t66);
    const float t69 = p->mB * p->xB;
    const float t70 = 1.0F / p->rF;
    const float t71 = 1.0F / p->rR;
    const float t72 = t36 + t62;
    const float t73 = t28 - t36;
    const float K0_11 = t35 + t73 - t34;
    const float t83 = t44 - (t55 * (p->IRxx + t68 + (p->xB * t69) + (p->w * t44) + p->IBzz));
    const float t87 = p->mF - (t55 * (t44 + t66 + t69));
    const float t90 = cos_lam * (t57 + (p->xH * t63));
    const float t95 = (t33 * sin_lam) - (cos_lam * ((p->c * t72) - t65));
    const float t97 = t72 - (t55 * t60);
    const float C1_12_IBxz = cos_lam * t55;
    const float K2_12_mR = p->rR * C1_12_IBxz;
    const float t100 = t35 * C1_12_IBxz;
    const float K2_22_SF = sin_lam * C1_12_IBxz;
    const float M_12_lam = (t33 * cos_lam) + (sin_lam * ((p->c * t97) - t65));
    const float M_12_w = cos_lam * (t28 + (t63 * t97));
    const float M_12_c = cos_lam * (t28 - t97);
    const float mu = p->c * C1_12_IBxz;
    const float t113 = t35 * mu;
    const float C1_12_mR = p->rR * mu;
    const float t115 = mu * t69;
    const float M_12_IHxz = cos_lam + mu;
    const float t117 = p->zH * sin_lam;
    const float K0_12_mH = t117 - t90;
    const float t119 = t90 - t117;
    const float K0_12_mF = (p->c * (cos_lam - (p->w * C1_12_IBxz))) - (p->rF * sin_lam);
    const float M_12_zH = p->mH * (t117 - t119);
    const float M_12 = t95 + (mu * t60);
    const float t129 = p->zH * t119;
    const float M_22_mH = t119 * t119;
    const float t131 = sin_lam * t119;
    const float SF = p->IFyy * t70;
    const float t133 = p->IRyy * t71;
    const float t138 = C1_12_IBxz * ((p->c * t83) + (t56 * t66) - t68);
    const float K2_12_IRyy = C1_12_IBxz * t71;
    const float t140 = p->rF * K0_12_mF;
    const float M_22_mF = K0_12_mF * K0_12_mF;
    const float K0_22_mF = sin_lam * K0_12_mF;
    const float t143 = p->mF * K0_12_mF;
    const float t144 = C1_12_IBxz * K0_12_mF;
    const float ST = SF + t133;
    const float t146 = ST - K0_11;
    const float t152 = t55 * (t60 + (p->w * SF) + (p->c * t146) - t48);
    const float t153 = t56 * t144;
    const float K2_12 = C1_12_IBxz * t146;
    const float t155 = t55 * t146;
    const float t156 = C1_12_IBxz * t155;
    const float t157 = sin_lam * t155;
    const float t158 = C1_12_IBxz * ST;
    const float t159 = t63 * ST;
    const float C1_21_w = C1_12_IBxz * t159;
    const float t161 = SF + t159;
    const float C1_21_lam = sin_lam * t161;
    const float C1_21 = -(cos_lam * t161);
    const float M_12_rF = (sin_lam * t36) - t143;
    const float t167 = p->c * t87;
    const float t168 = t58 - t167;
    const float K0_12 = (sin_lam * t73) - (cos_lam * t168);
    const float K0_12_lam = (cos_lam * t73) + (sin_lam * t168);
    const float t176 = t138 + (sin_lam * t62);
    const float t177 = cos_lam + cos_lam;
    const float t178 = t119 + t119;
    const float t179 = p->mH * cos_lam;
    const float t180 = t178 * t179;
    const float t181 = p->c + p->xH;
    const float t182 = t179 * t181;
    const float K0_12_w = t179 - (mu * t87);
    const float t187 = K0_12 + (cos_lam * (t83 + t167));
    const float K0_22 = sin_lam * K0_12;
    const float K0_12_c = t179 + (cos_lam * t87);
    const float K0_22_c = sin_lam * K0_12_c;
    const float t192 = C1_12_IBxz * K0_12_c;
    const float ITzz_mF = t36 + SF - t152;
    const float C1_12_w = C1_12_IBxz * ITzz_mF;
    const float C1_12 = cos_lam * t152;
    const float t197 = sin_lam * t152;
    const float K0_22_lam = (cos_lam * K0_12) + (sin_lam * K0_12_lam);
    const float t201 = t55 * t179;
    const float t202 = p->zH * t201;
    const float t204 = -(sin_lam * K0_12_w);
    const float t205 = t143 - t176;
    const float t212 = (M_12_IHxz * t61) + (sin_lam * p->IHxz) + (t58 * t119) + (p->c * t205);
    const float t214 = t176 + (t63 * K0_12);
    const float t216 = (sin_lam * SF) - K0_12;
    const float K2_22 = C1_12_IBxz * t216;
    const float t221 = C1_12_IBxz * (t205 + t182 - (t63 * t187));
    const float t223 = C1_12_IBxz * (t182 + t187);
    const float t224 = t205 * t177;
    const float t226 = (t63 * t224) + t180;
    const float M_22_c = t224 - t180;
    const float t228 = t55 * t216;
    const float t230 = C1_12_IBxz * (K0_12_w + t228);
    const float t231 = t55 * t182;
    const float K2_22_mH = C1_12_IBxz * t119;
    const float C1_22_xH = (p->mH * K2_22_mH) + (M_12_IHxz * t231);
    const float C1_22_mH = t181 * K2_22_mH;
    const float C1_22 = -(cos_lam * t214);
    const float t239 = sin_lam + sin_lam;
    const float t240 = t143 * t239;
    const float M_22_IHxz = M_12_IHxz * t239;
    const float t242 = cos_lam * C1_12_IBxz;
    const float C1_22_lam = (sin_lam * (t138 + t214)) - (mu * K0_12_lam) - (t48 * t242);
    const float M_22_lam = (t95 * t177) - (t212 * t239);
    const float M_22 = (sin_lam * t95) + (cos_lam * t212);
    const float K2_22_lam = (SF * t242) - (C1_12_IBxz * K0_12_lam) - (sin_lam * t228);
    const float C1_22_ITzz = t63 * t242;
    const float C1_22_IHzz = t242 + C1_22_ITzz;
    const float K2_22_xH = p->mH * C1_22_IHzz;
    const float K2_22_xB = p->mB * C1_22_ITzz;
    const float K2_12_rR = (p->mR * C1_12_IBxz) - (t133 * K2_12_IRyy);
    const float C1_12_rR = p->c * K2_12_rR;
    const float C1_12_IRyy = p->c * K2_12_IRyy;
    const float C1_21_rR = t133 * C1_12_IRyy;
    const float M_22_ITzz = mu * mu;
    const float t271 = t69 * M_22_ITzz;
    const float M_22_xB = t271 + t271;
    const float t273 = mu * p->xB;
    const float t274 = p->zB * t273;
    const float M_22_mB = t273 * t273;
    const float t276 = sin_lam * t273;
    const float K2_22_mB = C1_12_IBxz * t273;
    const float t278 = p->c + p->xB;
    const float C1_22_xB = (p->xB + t278) * K2_22_xB;
    const float C1_22_mB = t278 * K2_22_mB;
    const float t282 = p->mB * C1_12_IBxz;
    const float t283 = t278 * t282;
    const float t284 = p->c * t282;
    const float t285 = sin_lam * t284;
    const float t286 = p->zB * C1_12_IBxz;
    const float t287 = t278 * t286;
    const float t288 = p->mH * M_12_IHxz;
    const float t289 = p->zH * t288;
    const float M_22_xH = t178 * t288;
    const float t291 = sin_lam * t288;
    const float K0_12_zH = p->mH * sin_lam;
    const float t293 = t178 * K0_12_zH;
    const float K0_22_zH = sin_lam * K0_12_zH;
    const float t295 = C1_12_IBxz * K0_12_zH;
    const float t296 = t181 * t295;
    const float t297 = p->zH * C1_12_IBxz;
    const float t298 = t181 * t297;
    const float M_22_IHxx = sin_lam * sin_lam;
    const float t300 = p->mF * M_22_IHxx;
    const float M_22_IHzz = M_12_IHxz * M_12_IHxz;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float t303 = M_12_IHxz * t70;
    const float C1_21_rF = SF * t303;
    const float t305 = t56 * C1_12_IBxz;
    const float t307 = p->mF - (t70 * SF);
    const float C1_12_rF = t305 * t307;
    const float K2_12_rF = C1_12_IBxz * t307;
    const float C1_12_IFyy = t70 * t305;
    const float K2_12_IFyy = C1_12_IBxz * t70;
    const float K2_22_IFyy = sin_lam * K2_12_IFyy;
    const float t313 = p->mF * sin_lam;
    const float C1_22_rF = t305 * t313;
    const float K2_22_rF = sin_lam * K2_12_rF;
    const float K2_12_mF = p->rF * C1_12_IBxz;
    const float C1_12_mF = t56 * K2_12_mF;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k2[0][0] = 0.0F;
    matrices->k2[0][1] = K2_12;
    matrices->k2[1][0] = 0.0F;
    matrices->k2[1][1] = K2_22;
    derivatives->values[0] = p->rR;
    derivatives->values[1] = p->mR;
    derivatives->values[2] = p->zB;
    derivatives->values[3] = p->mB;
    derivatives->values[4] = p->zH;
    derivatives->values[5] = p->mH;
    derivatives->values[6] = p->rF;
    derivatives->values[7] = p->mF;
    derivatives->values[8] = 1.0F;
    derivatives->values[9] = sin_lam;
    derivatives->values[10] = M_11_mF;
    derivatives->values[11] = M_11_rR;
    derivatives->values[12] = M_11_mR;
    derivatives->values[13] = M_11_zB;
    derivatives->values[14] = M_11_mB;
    derivatives->values[15] = M_11_zH;
    derivatives->values[16] = M_11_mH;
    derivatives->values[17] = M_11_rF;
    derivatives->values[18] = C1_12_IBxz;
    derivatives->values[19] = K2_12_mR;
    derivatives->values[20] = t100;
    derivatives->values[21] = K2_22_SF;
    derivatives->values[22] = M_12_lam;
    derivatives->values[23] = M_12_w;
    derivatives->values[24] = M_12_c;
    derivatives->values[25] = mu;
    derivatives->values[26] = t113;
    derivatives->values[27] = C1_12_mR;
    derivatives->values[28] = t115;
    derivatives->values[29] = M_12_IHxz;
    derivatives->values[30] = K0_12_mH;
    derivatives->values[31] = K0_12_mF;
    derivatives->values[32] = M_12_zH;
    derivatives->values[33] = t129;
    derivatives->values[34] = M_22_mH;
    derivatives->values[35] = t131;
    derivatives->values[36] = K2_12_IRyy;
    derivatives->values[37] = t140;
    derivatives->values[38] = M_22_mF;
    derivatives->values[39] = K0_22_mF;
    derivatives->values[40] = t144;
    derivatives->values[41] = t153;
    derivatives->values[42] = K2_12;
    derivatives->values[43] = t156;
    derivatives->values[44] = t157;
    derivatives->values[45] = t158;
    derivatives->values[46] = C1_21_w;
    derivatives->values[47] = C1_21_lam;
    derivatives->values[48] = M_12_rF;
    derivatives->values[49] = K0_12_lam;
    derivatives->values[50] = K0_12_w;
    derivatives->values[51] = K0_12_c;
    derivatives->values[52] = K0_22_c;
    derivatives->values[53] = t192;
    derivatives->values[54] = C1_12_w;
    derivatives->values[55] = t197;
    derivatives->values[56] = K0_22_lam;
    derivatives->values[57] = t201;
    derivatives->values[58] = t202;
    derivatives->values[59] = t204;
    derivatives->values[60] = t221;
    derivatives->values[61] = t223;
    derivatives->values[62] = t226;
    derivatives->values[63] = M_22_c;
    derivatives->values[64] = t230;
    derivatives->values[65] = t231;
    derivatives->values[66] = K2_22_mH;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = C1_22_mH;
    derivatives->values[69] = t240;
    derivatives->values[70] = M_22_IHxz;
    derivatives->values[71] = C1_22_lam;
    derivatives->values[72] = M_22_lam;
    derivatives->values[73] = K2_22_lam;
    derivatives->values[74] = C1_22_ITzz;
    derivatives->values[75] = C1_22_IHzz;
    derivatives->values[76] = K2_22_xH;
    derivatives->values[77] = K2_22_xB;
    derivatives->values[78] = K2_12_rR;
    derivatives->values[79] = C1_12_rR;
    derivatives->values[80] = C1_12_IRyy;
    derivatives->values[81] = C1_21_rR;
    derivatives->values[82] = M_22_ITzz;
    derivatives->values[83] = M_22_xB;
    derivatives->values[84] = t273;
    derivatives->values[85] = t274;
    derivatives->values[86] = M_22_mB;
    derivatives->values[87] = t276;
    derivatives->values[88] = K2_22_mB;
    derivatives->values[89] = C1_22_xB;
    derivatives->values[90] = C1_22_mB;
    derivatives->values[91] = t282;
    derivatives->values[92] = t283;
    derivatives->values[93] = t284;
    derivatives->values[94] = t285;
    derivatives->values[95] = t286;
    derivatives->values[96] = t287;
    derivatives->values[97] = t288;
    derivatives->values[98] = t289;
    derivatives->values[99] = M_22_xH;
    derivatives->values[100] = t291;
    derivatives->values[101] = K0_12_zH;
    derivatives->values[102] = t293;
    derivatives->values[103] = K0_22_zH;
    derivatives->values[104] = t295;
    derivatives->values[105] = t296;
    derivatives->values[106] = t297;
    derivatives->values[107] = t298;
    derivatives->values[108] = M_22_IHxx;
    derivatives->values[109] = t300;
    derivatives->values[110] = M_22_IHzz;
    derivatives->values[111] = M_22_IFxx;
    derivatives->values[112] = t303;
    derivatives->values[113] = C1_21_rF;
    derivatives->values[114] = C1_12_rF;
    derivatives->values[115] = K2_12_rF;
    derivatives->values[116] = C1_12_IFyy;
    derivatives->values[117] = K2_12_IFyy;
    derivatives->values[118] = K2_22_IFyy;
    derivatives->values[119] = t313;
    derivatives->values[120] = C1_22_rF;
    derivatives->values[121] = K2_22_rF;
    derivatives->values[122] = K2_12_mF;
    derivatives->values[123] = C1_12_mF;
}

void whipple_f32_with_respect_to(const whipple_f32_derivatives_t *derivatives, size_t parameter,
    whipple_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHIPPLE_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
            matrices->k2[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < WHIPPLE_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &whipple_partials[position];
        if (partial->parameter == parameter) {
            const float value = derivatives->values[partial->value];
            const float signed_value = partial->is_negative ? (-value) : value;
            switch (partial->matrix) {
            case CARVALLO_MATRIX_M:
                matrices->m[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_C1:
                matrices->c1[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_K0:
                matrices->k0[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_K2:
                matrices->k2[partial->row][partial->column] = signed_value;
                break;
            default:
                /* The model has no other matrix. */
                break;
            }
        }
    }
}
