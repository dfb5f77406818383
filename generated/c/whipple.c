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
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 1U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 2U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 3U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 5U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 5U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 6U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 7U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 10U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 11U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 12U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 13U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 14U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 14U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 15U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 16U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 17U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 17U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 18U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 19U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 20U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 21U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 22U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 22U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 23U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 24U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 25U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 26U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 4U, 27U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 4U, 28U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 29U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 4U, 30U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 31U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 32U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 33U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 5U, 34U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 35U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 36U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 6U, 37U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 7U, 38U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 7U, 38U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 7U, 39U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 8U, 40U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 8U, 40U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 8U, 41U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 8U, 42U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 8U, 43U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 8U, 44U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 8U, 44U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 8U, 45U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 46U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 47U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 48U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 48U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 9U, 49U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 50U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 9U, 51U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 52U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 10U, 53U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 10U, 53U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 10U, 54U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 10U, 55U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 10U, 56U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 10U, 57U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 10U, 58U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 10U, 58U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 10U, 59U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 10U, 60U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 10U, 61U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 11U, 35U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 13U, 36U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 13U, 37U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 14U, 62U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 14U, 62U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 14U, 63U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 15U, 64U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 15U, 64U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 65U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 66U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 67U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 68U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 68U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 69U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 70U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 71U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 72U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 72U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 73U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 74U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 75U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 76U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 77U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 77U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 78U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 79U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 80U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 81U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 82U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 82U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 83U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 84U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 85U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 86U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 87U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 87U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 88U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 89U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 90U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 18U, 35U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 18U, 91U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 18U, 91U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 18U, 92U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 20U, 93U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 20U, 94U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 21U, 95U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 21U, 95U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 21U, 96U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 21U, 63U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 21U, 97U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 22U, 98U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 22U, 99U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 22U, 99U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 100U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 22U, 101U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 22U, 102U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 22U, 103U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 22U, 104U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 22U, 105U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 22U, 105U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 22U, 106U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 107U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 22U, 108U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 23U, 109U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 110U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 110U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 111U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 112U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 113U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 114U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 115U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 115U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 116U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 117U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 118U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 35U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 91U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 91U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 119U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 94U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 120U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 121U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 122U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 123U, false}
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
    const double t5 = p->rF * p->mF;
    const double M_11_mH = p->zH * p->zH;
    const double t13 = p->IFxx + p->IHxx + (p->rF * t5) + (p->mH * M_11_mH);
    const double M_11_mB = p->zB * p->zB;
    const double t21 = p->rR * p->mR;
    const double M_11 = p->IRxx + t13 + (p->mB * M_11_mB) + p->IBxx + (p->rR * t21);
    const double t31 = p->mH * p->xH;
    const double t33 = p->IHxz - (p->zH * t31);
    const double t34 = (t5 * p->w) + t33;
    const double t36 = p->mB * p->zB;
    const double t40 = t34 + p->IBxz - (t36 * p->xB);
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t44 = 1.0 / p->w;
    const double C1_12_IBxz = cos_lam * t44;
    const double mu = p->c * C1_12_IBxz;
    const double t48 = p->mH * p->zH;
    const double t49 = t48 - t5;
    const double t53 = t33 + (p->c * t49) + (p->w * t48);
    const double t57 = (cos_lam * t53) + (t13 * sin_lam);
    const double M_12 = (t40 * mu) + t57;
    const double t63 = p->IFxx + p->IHzz;
    const double t64 = p->w + p->c;
    const double t65 = p->xH - t64;
    const double t66 = p->mH * t65;
    const double t71 = t53 * sin_lam;
    const double t72 = (cos_lam * ((p->mF * p->c * p->c) + t63 + (t65 * t66))) + t71;
    const double t76 = p->mF * p->w;
    const double t80 = cos_lam * (t63 + (t31 * t65) - (p->c * t76));
    const double t81 = (t34 * sin_lam) + t80;
    const double t82 = p->c * cos_lam;
    const double t86 = p->mB * p->xB;
    const double t93 = t44 * (p->IRxx + t63 + p->IBzz + (p->w * t76) + (p->xH * t31) + (p->xB *
        t86));
    const double t94 = t82 * t93;
    const double t95 = t81 + t94;
    const double M_22 = (sin_lam * t57) + (cos_lam * t72) + (mu * (t81 + t95));
    const double t102 = 1.0 / p->rF;
    const double SF = p->IFyy * t102;
    const double t105 = 1.0 / p->rR;
    const double t106 = p->IRyy * t105;
    const double ST = SF + t106;
    const double t108 = t36 + t49;
    const double t110 = ST + (t21 - t108);
    const double t114 = t40 + (p->c * t110) + (p->w * SF);
    const double C1_12 = C1_12_IBxz * t114;
    const double t116 = cos_lam * SF;
    const double t117 = C1_12_IBxz * ST;
    const double t118 = p->c * t117;
    const double t120 = t49 * sin_lam;
    const double t124 = p->mF - (t44 * (t31 + t76 + t86));
    const double t125 = p->c * t124;
    const double t126 = t125 - t66;
    const double K0_12 = t120 + (cos_lam * t126);
    const double t130 = t95 - (p->c * K0_12);
    const double C1_22 = C1_12_IBxz * t130;
    const double K0_22 = sin_lam * K0_12;
    const double K2_12 = C1_12_IBxz * t110;
    const double t134 = sin_lam * SF;
    const double t135 = K0_12 - t134;
    const double t136 = C1_12_IBxz * t135;
    const double t138 = t5 * cos_lam;
    const double t139 = (t40 * C1_12_IBxz) - t138;
    const double t142 = cos_lam * t48;
    const double M_12_w = t142 - (p->c * t44 * t139);
    const double t144 = p->rF * sin_lam;
    const double K0_12_mF = t82 - t144 - (p->w * mu);
    const double t148 = p->mF * K0_12_mF;
    const double t149 = t44 * t95;
    const double t150 = t148 + t149;
    const double t151 = t150 + t150;
    const double M_12_IHxz = cos_lam + mu;
    const double t154 = p->xH * M_12_IHxz;
    const double t155 = cos_lam * t64;
    const double t156 = p->zH * sin_lam;
    const double t157 = t155 + t156;
    const double t158 = t154 - t157;
    const double t159 = t158 + t158;
    const double t160 = p->mH * t159;
    const double t161 = cos_lam * t160;
    const double t162 = (mu * t151) + t161;
    const double t163 = t116 + t138;
    const double t165 = t44 * (C1_12 - t163);
    const double C1_21_w = t44 * t118;
    const double t168 = t44 * (t94 + t130);
    const double t169 = p->mH * cos_lam;
    const double t170 = p->xH + p->c;
    const double t172 = t76 + t125;
    const double C1_22_w = C1_12_IBxz * ((mu * t172) - t148 - t168 - (t169 * t170));
    const double K0_12_w = t169 - (C1_12_IBxz * t125);
    const double t181 = t44 * K2_12;
    const double K2_22_w = t44 * (t136 - (cos_lam * K0_12_w));
    const double M_12_c = t139 + t142;
    const double t187 = cos_lam * (t160 - t151);
    const double t188 = cos_lam * C1_12_IBxz;
    const double t189 = p->mH * t170;
    const double C1_22_c = (t188 * (t93 - t126 - t172 - t189)) - (C1_12_IBxz * t120);
    const double K0_12_c = t169 + (cos_lam * t124);
    const double K0_22_c = sin_lam * K0_12_c;
    const double t199 = C1_12_IBxz * K0_12_c;
    const double t200 = t44 * sin_lam;
    const double t201 = p->c * t200;
    const double t205 = t71 + (t40 * t201) - (t13 * cos_lam);
    const double t210 = (t34 * t188) - (t80 * t200);
    const double t215 = (cos_lam * t57) - (p->c * ((sin_lam * t149) - t210)) - (sin_lam * t72);
    const double M_22_lam = t215 + t215;
    const double t217 = t114 * t200;
    const double C1_21_lam = t134 + (ST * t201);
    const double t222 = t142 - (sin_lam * t126);
    const double t223 = t138 - t222;
    const double C1_22_lam = t210 + (mu * t223) - (sin_lam * t168);
    const double K0_22_lam = (cos_lam * K0_12) - (sin_lam * t223);
    const double t230 = t110 * t200;
    const double K2_22_lam = (C1_12_IBxz * (t163 - t222)) + (t135 * t200);
    const double M_11_rR = t21 + t21;
    const double K2_12_rR = C1_12_IBxz * (p->mR - (t105 * t106));
    const double C1_12_rR = p->c * K2_12_rR;
    const double C1_12_IRyy = mu * t105;
    const double C1_21_rR = t106 * C1_12_IRyy;
    const double M_11_mR = p->rR * p->rR;
    const double C1_12_mR = p->rR * mu;
    const double K2_12_mR = p->rR * C1_12_IBxz;
    const double C1_22_ITzz = C1_12_IBxz * mu;
    const double M_22_ITzz = p->c * C1_22_ITzz;
    const double K2_12_IRyy = C1_12_IBxz * t105;
    const double t249 = p->mB * C1_12_IBxz;
    const double t250 = p->c * t249;
    const double t251 = p->zB * t250;
    const double t252 = p->xB * mu;
    const double t253 = t250 * t252;
    const double M_22_xB = t253 + t253;
    const double t255 = p->zB * t249;
    const double t256 = p->mB * t252;
    const double t257 = p->xB + p->c;
    const double C1_22_xB = C1_12_IBxz * (t256 + (t250 * t257));
    const double t261 = sin_lam * t250;
    const double K2_22_xB = p->mB * C1_22_ITzz;
    const double M_11_zB = t36 + t36;
    const double t264 = t249 * t257;
    const double t265 = p->zB * t252;
    const double M_22_mB = t252 * t252;
    const double t267 = p->zB * C1_12_IBxz;
    const double t268 = t257 * t267;
    const double K2_22_mB = p->xB * C1_22_ITzz;
    const double C1_22_mB = t257 * K2_22_mB;
    const double t271 = sin_lam * t252;
    const double t272 = t48 * M_12_IHxz;
    const double t273 = p->mH * C1_12_IBxz;
    const double t274 = p->c * t273;
    const double M_22_xH = t161 + (t158 * (t274 + t274));
    const double t278 = p->zH * C1_12_IBxz;
    const double t279 = p->mH * t278;
    const double C1_22_IHzz = C1_12_IBxz * M_12_IHxz;
    const double C1_22_xH = (t158 * t273) + (t189 * C1_22_IHzz);
    const double t284 = t169 + t274;
    const double t285 = sin_lam * t284;
    const double K2_22_xH = p->mH * C1_22_IHzz;
    const double M_11_zH = t48 + t48;
    const double M_12_zH = p->mH * (t156 - t158);
    const double K0_12_zH = p->mH * sin_lam;
    const double t291 = t159 * K0_12_zH;
    const double t292 = t170 * t273;
    const double t293 = t169 * t200;
    const double t294 = t170 * t293;
    const double K0_22_zH = sin_lam * K0_12_zH;
    const double t296 = p->zH * t158;
    const double M_22_mH = t158 * t158;
    const double t298 = t170 * t278;
    const double K2_22_mH = C1_12_IBxz * t158;
    const double C1_22_mH = t170 * K2_22_mH;
    const double t301 = sin_lam * t158;
    const double M_22_IHxx = sin_lam * sin_lam;
    const double M_22_IHzz = M_22_ITzz + (cos_lam * (mu + M_12_IHxz));
    const double t306 = sin_lam + sin_lam;
    const double M_22_IHxz = M_12_IHxz * t306;
    const double K2_22_SF = C1_12_IBxz * sin_lam;
    const double M_11_rF = t5 + t5;
    const double M_12_rF = p->mF * (t144 - K0_12_mF);
    const double t312 = t148 * t306;
    const double ITzz_w = p->mF - (t102 * SF);
    const double C1_12_SF = t44 * t155;
    const double C1_12_rF = ITzz_w * C1_12_SF;
    const double t317 = t102 * M_12_IHxz;
    const double C1_21_rF = SF * t317;
    const double t319 = p->mF * sin_lam;
    const double C1_22_rF = C1_12_SF * t319;
    const double t321 = sin_lam * t319;
    const double K2_12_rF = C1_12_IBxz * ITzz_w;
    const double K2_22_rF = sin_lam * K2_12_rF;
    const double M_11_mF = p->rF * p->rF;
    const double t325 = p->rF * K0_12_mF;
    const double M_22_mF = K0_12_mF * K0_12_mF;
    const double C1_12_mF = p->rF * C1_12_SF;
    const double t328 = K0_12_mF * C1_12_SF;
    const double K0_22_mF = sin_lam * K0_12_mF;
    const double K2_12_mF = p->rF * C1_12_IBxz;
    const double t331 = C1_12_IBxz * K0_12_mF;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double C1_12_IFyy = t102 * C1_12_SF;
    const double K2_12_IFyy = C1_12_IBxz * t102;
    const double K2_22_IFyy = t102 * K2_22_SF;
    const double C1_21 = -(t116 + t118);
    const double K0_11 = t108 - t21;
    const double K2_22 = -t136;
    const double t339 = -(sin_lam * K0_12_w);
    const double K0_12_lam = t222 - t138;
    const double K0_12_mH = t157 - t154;
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
    derivatives->values[0] = M_12_w;
    derivatives->values[1] = t162;
    derivatives->values[2] = t165;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = K0_12_w;
    derivatives->values[6] = t339;
    derivatives->values[7] = t181;
    derivatives->values[8] = K2_22_w;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = t187;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t117;
    derivatives->values[13] = C1_22_c;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t199;
    derivatives->values[17] = t205;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t217;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = t230;
    derivatives->values[25] = K2_22_lam;
    derivatives->values[26] = M_11_rR;
    derivatives->values[27] = C1_12_rR;
    derivatives->values[28] = C1_21_rR;
    derivatives->values[29] = p->mR;
    derivatives->values[30] = K2_12_rR;
    derivatives->values[31] = M_11_mR;
    derivatives->values[32] = C1_12_mR;
    derivatives->values[33] = p->rR;
    derivatives->values[34] = K2_12_mR;
    derivatives->values[35] = 1.0;
    derivatives->values[36] = M_22_ITzz;
    derivatives->values[37] = C1_22_ITzz;
    derivatives->values[38] = C1_12_IRyy;
    derivatives->values[39] = K2_12_IRyy;
    derivatives->values[40] = t251;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t255;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = t250;
    derivatives->values[45] = t261;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t256;
    derivatives->values[49] = t264;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t249;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t265;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t268;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = t252;
    derivatives->values[59] = t271;
    derivatives->values[60] = t267;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = mu;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = t272;
    derivatives->values[65] = M_22_xH;
    derivatives->values[66] = t279;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = t284;
    derivatives->values[69] = t285;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = t291;
    derivatives->values[74] = t292;
    derivatives->values[75] = t294;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t273;
    derivatives->values[80] = t293;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = t296;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t298;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = t301;
    derivatives->values[89] = t278;
    derivatives->values[90] = K2_22_mH;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_IHxx;
    derivatives->values[93] = M_22_IHzz;
    derivatives->values[94] = C1_22_IHzz;
    derivatives->values[95] = M_12_IHxz;
    derivatives->values[96] = M_22_IHxz;
    derivatives->values[97] = K2_22_SF;
    derivatives->values[98] = M_11_rF;
    derivatives->values[99] = M_12_rF;
    derivatives->values[100] = t312;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = C1_22_rF;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = t319;
    derivatives->values[106] = t321;
    derivatives->values[107] = K2_12_rF;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = t325;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = t328;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = K0_22_mF;
    derivatives->values[117] = K2_12_mF;
    derivatives->values[118] = t331;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t317;
    derivatives->values[122] = K2_12_IFyy;
    derivatives->values[123] = K2_22_IFyy;
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
    const float t5 = p->rF * p->mF;
    const float M_11_mH = p->zH * p->zH;
    const float t13 = p->IFxx + p->IHxx + (p->rF * t5) + (p->mH * M_11_mH);
    const float M_11_mB = p->zB * p->zB;
    const float t21 = p->rR * p->mR;
    const float M_11 = p->IRxx + t13 + (p->mB * M_11_mB) + p->IBxx + (p->rR * t21);
    const float t31 = p->mH * p->xH;
    const float t33 = p->IHxz - (p->zH * t31);
    const float t34 = (t5 * p->w) + t33;
    const float t36 = p->mB * p->zB;
    const float t40 = t34 + p->IBxz - (t36 * p->xB);
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t44 = 1.0F / p->w;
    const float C1_12_IBxz = cos_lam * t44;
    const float mu = p->c * C1_12_IBxz;
    const float t48 = p->mH * p->zH;
    const float t49 = t48 - t5;
    const float t53 = t33 + (p->c * t49) + (p->w * t48);
    const float t57 = (cos_lam * t53) + (t13 * sin_lam);
    const float M_12 = (t40 * mu) + t57;
    const float t63 = p->IFxx + p->IHzz;
    const float t64 = p->w + p->c;
    const float t65 = p->xH - t64;
    const float t66 = p->mH * t65;
    const float t71 = t53 * sin_lam;
    const float t72 = (cos_lam * ((p->mF * p->c * p->c) + t63 + (t65 * t66))) + t71;
    const float t76 = p->mF * p->w;
    const float t80 = cos_lam * (t63 + (t31 * t65) - (p->c * t76));
    const float t81 = (t34 * sin_lam) + t80;
    const float t82 = p->c * cos_lam;
    const float t86 = p->mB * p->xB;
    const float t93 = t44 * (p->IRxx + t63 + p->IBzz + (p->w * t76) + (p->xH * t31) + (p->xB *
        t86));
    const float t94 = t82 * t93;
    const float t95 = t81 + t94;
    const float M_22 = (sin_lam * t57) + (cos_lam * t72) + (mu * (t81 + t95));
    const float t102 = 1.0F / p->rF;
    const float SF = p->IFyy * t102;
    const float t105 = 1.0F / p->rR;
    const float t106 = p->IRyy * t105;
    const float ST = SF + t106;
    const float t108 = t36 + t49;
    const float t110 = ST + (t21 - t108);
    const float t114 = t40 + (p->c * t110) + (p->w * SF);
    const float C1_12 = C1_12_IBxz * t114;
    const float t116 = cos_lam * SF;
    const float t117 = C1_12_IBxz * ST;
    const float t118 = p->c * t117;
    const float t120 = t49 * sin_lam;
    const float t124 = p->mF - (t44 * (t31 + t76 + t86));
    const float t125 = p->c * t124;
    const float t126 = t125 - t66;
    const float K0_12 = t120 + (cos_lam * t126);
    const float t130 = t95 - (p->c * K0_12);
    const float C1_22 = C1_12_IBxz * t130;
    const float K0_22 = sin_lam * K0_12;
    const float K2_12 = C1_12_IBxz * t110;
    const float t134 = sin_lam * SF;
    const float t135 = K0_12 - t134;
    const float t136 = C1_12_IBxz * t135;
    const float t138 = t5 * cos_lam;
    const float t139 = (t40 * C1_12_IBxz) - t138;
    const float t142 = cos_lam * t48;
    const float M_12_w = t142 - (p->c * t44 * t139);
    const float t144 = p->rF * sin_lam;
    const float K0_12_mF = t82 - t144 - (p->w * mu);
    const float t148 = p->mF * K0_12_mF;
    const float t149 = t44 * t95;
    const float t150 = t148 + t149;
    const float t151 = t150 + t150;
    const float M_12_IHxz = cos_lam + mu;
    const float t154 = p->xH * M_12_IHxz;
    const float t155 = cos_lam * t64;
    const float t156 = p->zH * sin_lam;
    const float t157 = t155 + t156;
    const float t158 = t154 - t157;
    const float t159 = t158 + t158;
    const float t160 = p->mH * t159;
    const float t161 = cos_lam * t160;
    const float t162 = (mu * t151) + t161;
    const float t163 = t116 + t138;
    const float t165 = t44 * (C1_12 - t163);
    const float C1_21_w = t44 * t118;
    const float t168 = t44 * (t94 + t130);
    const float t169 = p->mH * cos_lam;
    const float t170 = p->xH + p->c;
    const float t172 = t76 + t125;
    const float C1_22_w = C1_12_IBxz * ((mu * t172) - t148 - t168 - (t169 * t170));
    const float K0_12_w = t169 - (C1_12_IBxz * t125);
    const float t181 = t44 * K2_12;
    const float K2_22_w = t44 * (t136 - (cos_lam * K0_12_w));
    const float M_12_c = t139 + t142;
    const float t187 = cos_lam * (t160 - t151);
    const float t188 = cos_lam * C1_12_IBxz;
    const float t189 = p->mH * t170;
    const float C1_22_c = (t188 * (t93 - t126 - t172 - t189)) - (C1_12_IBxz * t120);
    const float K0_12_c = t169 + (cos_lam * t124);
    const float K0_22_c = sin_lam * K0_12_c;
    const float t199 = C1_12_IBxz * K0_12_c;
    const float t200 = t44 * sin_lam;
    const float t201 = p->c * t200;
    const float t205 = t71 + (t40 * t201) - (t13 * cos_lam);
    const float t210 = (t34 * t188) - (t80 * t200);
    const float t215 = (cos_lam * t57) - (p->c * ((sin_lam * t149) - t210)) - (sin_lam * t72);
    const float M_22_lam = t215 + t215;
    const float t217 = t114 * t200;
    const float C1_21_lam = t134 + (ST * t201);
    const float t222 = t142 - (sin_lam * t126);
    const float t223 = t138 - t222;
    const float C1_22_lam = t210 + (mu * t223) - (sin_lam * t168);
    const float K0_22_lam = (cos_lam * K0_12) - (sin_lam * t223);
    const float t230 = t110 * t200;
    const float K2_22_lam = (C1_12_IBxz * (t163 - t222)) + (t135 * t200);
    const float M_11_rR = t21 + t21;
    const float K2_12_rR = C1_12_IBxz * (p->mR - (t105 * t106));
    const float C1_12_rR = p->c * K2_12_rR;
    const float C1_12_IRyy = mu * t105;
    const float C1_21_rR = t106 * C1_12_IRyy;
    const float M_11_mR = p->rR * p->rR;
    const float C1_12_mR = p->rR * mu;
    const float K2_12_mR = p->rR * C1_12_IBxz;
    const float C1_22_ITzz = C1_12_IBxz * mu;
    const float M_22_ITzz = p->c * C1_22_ITzz;
    const float K2_12_IRyy = C1_12_IBxz * t105;
    const float t249 = p->mB * C1_12_IBxz;
    const float t250 = p->c * t249;
    const float t251 = p->zB * t250;
    const float t252 = p->xB * mu;
    const float t253 = t250 * t252;
    const float M_22_xB = t253 + t253;
    const float t255 = p->zB * t249;
    const float t256 = p->mB * t252;
    const float t257 = p->xB + p->c;
    const float C1_22_xB = C1_12_IBxz * (t256 + (t250 * t257));
    const float t261 = sin_lam * t250;
    const float K2_22_xB = p->mB * C1_22_ITzz;
    const float M_11_zB = t36 + t36;
    const float t264 = t249 * t257;
    const float t265 = p->zB * t252;
    const float M_22_mB = t252 * t252;
    const float t267 = p->zB * C1_12_IBxz;
    const float t268 = t257 * t267;
    const float K2_22_mB = p->xB * C1_22_ITzz;
    const float C1_22_mB = t257 * K2_22_mB;
    const float t271 = sin_lam * t252;
    const float t272 = t48 * M_12_IHxz;
    const float t273 = p->mH * C1_12_IBxz;
    const float t274 = p->c * t273;
    const float M_22_xH = t161 + (t158 * (t274 + t274));
    const float t278 = p->zH * C1_12_IBxz;
    const float t279 = p->mH * t278;
    const float C1_22_IHzz = C1_12_IBxz * M_12_IHxz;
    const float C1_22_xH = (t158 * t273) + (t189 * C1_22_IHzz);
    const float t284 = t169 + t274;
    const float t285 = sin_lam * t284;
    const float K2_22_xH = p->mH * C1_22_IHzz;
    const float M_11_zH = t48 + t48;
    const float M_12_zH = p->mH * (t156 - t158);
    const float K0_12_zH = p->mH * sin_lam;
    const float t291 = t159 * K0_12_zH;
    const float t292 = t170 * t273;
    const float t293 = t169 * t200;
    const float t294 = t170 * t293;
    const float K0_22_zH = sin_lam * K0_12_zH;
    const float t296 = p->zH * t158;
    const float M_22_mH = t158 * t158;
    const float t298 = t170 * t278;
    const float K2_22_mH = C1_12_IBxz * t158;
    const float C1_22_mH = t170 * K2_22_mH;
    const float t301 = sin_lam * t158;
    const float M_22_IHxx = sin_lam * sin_lam;
    const float M_22_IHzz = M_22_ITzz + (cos_lam * (mu + M_12_IHxz));
    const float t306 = sin_lam + sin_lam;
    const float M_22_IHxz = M_12_IHxz * t306;
    const float K2_22_SF = C1_12_IBxz * sin_lam;
    const float M_11_rF = t5 + t5;
    const float M_12_rF = p->mF * (t144 - K0_12_mF);
    const float t312 = t148 * t306;
    const float ITzz_w = p->mF - (t102 * SF);
    const float C1_12_SF = t44 * t155;
    const float C1_12_rF = ITzz_w * C1_12_SF;
    const float t317 = t102 * M_12_IHxz;
    const float C1_21_rF = SF * t317;
    const float t319 = p->mF * sin_lam;
    const float C1_22_rF = C1_12_SF * t319;
    const float t321 = sin_lam * t319;
    const float K2_12_rF = C1_12_IBxz * ITzz_w;
    const float K2_22_rF = sin_lam * K2_12_rF;
    const float M_11_mF = p->rF * p->rF;
    const float t325 = p->rF * K0_12_mF;
    const float M_22_mF = K0_12_mF * K0_12_mF;
    const float C1_12_mF = p->rF * C1_12_SF;
    const float t328 = K0_12_mF * C1_12_SF;
    const float K0_22_mF = sin_lam * K0_12_mF;
    const float K2_12_mF = p->rF * C1_12_IBxz;
    const float t331 = C1_12_IBxz * K0_12_mF;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float C1_12_IFyy = t102 * C1_12_SF;
    const float K2_12_IFyy = C1_12_IBxz * t102;
    const float K2_22_IFyy = t102 * K2_22_SF;
    const float C1_21 = -(t116 + t118);
    const float K0_11 = t108 - t21;
    const float K2_22 = -t136;
    const float t339 = -(sin_lam * K0_12_w);
    const float K0_12_lam = t222 - t138;
    const float K0_12_mH = t157 - t154;
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
    derivatives->values[0] = M_12_w;
    derivatives->values[1] = t162;
    derivatives->values[2] = t165;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = K0_12_w;
    derivatives->values[6] = t339;
    derivatives->values[7] = t181;
    derivatives->values[8] = K2_22_w;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = t187;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t117;
    derivatives->values[13] = C1_22_c;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t199;
    derivatives->values[17] = t205;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t217;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = t230;
    derivatives->values[25] = K2_22_lam;
    derivatives->values[26] = M_11_rR;
    derivatives->values[27] = C1_12_rR;
    derivatives->values[28] = C1_21_rR;
    derivatives->values[29] = p->mR;
    derivatives->values[30] = K2_12_rR;
    derivatives->values[31] = M_11_mR;
    derivatives->values[32] = C1_12_mR;
    derivatives->values[33] = p->rR;
    derivatives->values[34] = K2_12_mR;
    derivatives->values[35] = 1.0F;
    derivatives->values[36] = M_22_ITzz;
    derivatives->values[37] = C1_22_ITzz;
    derivatives->values[38] = C1_12_IRyy;
    derivatives->values[39] = K2_12_IRyy;
    derivatives->values[40] = t251;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t255;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = t250;
    derivatives->values[45] = t261;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t256;
    derivatives->values[49] = t264;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t249;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t265;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t268;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = t252;
    derivatives->values[59] = t271;
    derivatives->values[60] = t267;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = mu;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = t272;
    derivatives->values[65] = M_22_xH;
    derivatives->values[66] = t279;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = t284;
    derivatives->values[69] = t285;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = t291;
    derivatives->values[74] = t292;
    derivatives->values[75] = t294;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t273;
    derivatives->values[80] = t293;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = t296;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t298;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = t301;
    derivatives->values[89] = t278;
    derivatives->values[90] = K2_22_mH;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_IHxx;
    derivatives->values[93] = M_22_IHzz;
    derivatives->values[94] = C1_22_IHzz;
    derivatives->values[95] = M_12_IHxz;
    derivatives->values[96] = M_22_IHxz;
    derivatives->values[97] = K2_22_SF;
    derivatives->values[98] = M_11_rF;
    derivatives->values[99] = M_12_rF;
    derivatives->values[100] = t312;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = C1_22_rF;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = t319;
    derivatives->values[106] = t321;
    derivatives->values[107] = K2_12_rF;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = t325;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = t328;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = K0_22_mF;
    derivatives->values[117] = K2_12_mF;
    derivatives->values[118] = t331;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t317;
    derivatives->values[122] = K2_12_IFyy;
    derivatives->values[123] = K2_22_IFyy;
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
