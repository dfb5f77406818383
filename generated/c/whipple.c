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
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 2U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 3U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 5U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 5U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 6U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 7U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 8U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 10U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 11U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 12U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 13U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 14U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 14U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 15U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 16U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 17U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 17U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 18U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 19U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 20U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 21U, true},
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
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 87U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 87U, true},
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
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 100U, false},
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
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 110U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 110U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 111U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 112U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 113U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 114U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 115U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 115U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 116U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 117U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 118U, false},
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
    const double t3 = p->zB * p->mB;
    const double t7 = p->zH * p->mH;
    const double t12 = p->rF * p->mF;
    const double t17 = (p->zH * t7) + (p->IHxx + ((p->rF * t12) + p->IFxx));
    const double t22 = p->rR * p->mR;
    const double ITxx = p->IBxx + ((p->zB * t3) + t17 + (p->IRxx + (p->rR * t22)));
    const double t28 = p->mH * p->xH;
    const double t34 = p->IHxz + (t12 * p->w) - (p->zH * t28);
    const double ITzz = t3 * p->xB;
    const double t39 = t34 - ITzz + p->IBxz;
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t43 = cos_lam / p->w;
    const double mu = p->c * t43;
    const double t49 = p->w - p->xH + p->c;
    const double t52 = cos_lam * ((t12 * p->c) - p->IHxz - (t7 * t49));
    const double t55 = (t17 * sin_lam) - t52;
    const double M_12 = (t39 * mu) + t55;
    const double t58 = p->IFxx + p->IHzz;
    const double t59 = p->mF * p->c;
    const double t62 = p->mH * t49;
    const double t69 = p->mF * p->w;
    const double IAlz = (t34 * sin_lam) - (cos_lam * ((p->xH * t62) - t58 + (p->c * t69)));
    const double t76 = p->mB * p->xB;
    const double t86 = IAlz + ((p->IRxx + t58 + ((p->xB * t76) + (p->xH * t28) + (p->IBzz + (p->w *
        t69)))) * mu);
    const double t89 = (cos_lam * (cos_lam * (t58 + (p->c * t59) + (t49 * t62)))) + (mu * (IAlz +
        t86));
    const double M_22 = t89 + (sin_lam * (t55 - t52));
    const double SF = p->IFyy / p->rF;
    const double SR = p->IRyy / p->rR;
    const double ST = SF + SR;
    const double t99 = t7 - t12;
    const double K0_11 = t3 + t99 - t22;
    const double t102 = ST - K0_11;
    const double C1_12 = t43 * (t39 + (p->c * t102) + (p->w * SF));
    const double K0_12 = (cos_lam * (t62 + t59)) + (sin_lam * t99) - (mu * (t28 + t69 + t76));
    const double C1_22 = (t43 * t86) - (mu * K0_12);
    const double K0_22 = sin_lam * K0_12;
    const double K2_12 = t43 * t102;
    const double K2_22 = t43 * ((sin_lam * SF) - K0_12);
    const double C1_21 = -((cos_lam * SF) + (mu * ST));
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
    const double t4 = p->zH * p->mH;
    const double t9 = p->rF * p->mF;
    const double t13 = p->IFxx + (p->zH * t4) + p->IHxx + (p->rF * t9);
    const double M_11_mR = p->rR * p->rR;
    const double t21 = p->zB * p->mB;
    const double M_11 = p->IBxx + t13 + (p->mR * M_11_mR) + p->IRxx + (p->zB * t21);
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t33 = t9 * p->c;
    const double t36 = p->c + p->w;
    const double t37 = p->xH - t36;
    const double t38 = p->mH * t37;
    const double IAlz_rF = p->zH * t38;
    const double t41 = p->IHxz - t33 - IAlz_rF;
    const double t43 = (t13 * sin_lam) + (cos_lam * t41);
    const double t48 = p->IHxz + (t9 * p->w) - (t4 * p->xH);
    const double t50 = p->mB * p->xB;
    const double t53 = p->IBxz + t48 - (p->zB * t50);
    const double t54 = 1.0 / p->w;
    const double t55 = p->c * t54;
    const double t56 = t53 * t55;
    const double M_12 = t43 + (cos_lam * t56);
    const double C1_12_IBxz = cos_lam * t54;
    const double t62 = p->IFxx + p->IHzz;
    const double t63 = p->mF * p->w;
    const double t65 = p->mH * p->xH;
    const double t68 = t62 + (t37 * t65) - (p->c * t63);
    const double t70 = sin_lam * t54;
    const double t72 = (C1_12_IBxz * t68) + (t48 * t70);
    const double t73 = cos_lam * p->c;
    const double t88 = C1_12_IBxz * (p->IRxx + t62 + (p->xB * t50) + p->IBzz + (p->w * t63) +
        (p->xH * t65));
    const double t89 = t55 * t88;
    const double t90 = t72 + t89;
    const double t92 = t90 + (p->mF * t73);
    const double t95 = (cos_lam * (t62 + (t37 * t38))) + (sin_lam * t41) + (p->c * t92);
    const double M_22 = (sin_lam * t43) + (t72 * t73) + (cos_lam * t95);
    const double t101 = 1.0 / p->rF;
    const double SF = p->IFyy * t101;
    const double t105 = 1.0 / p->rR;
    const double t106 = p->IRyy * t105;
    const double ST = SF + t106;
    const double t108 = p->mR * p->rR;
    const double t109 = t4 - t9;
    const double K0_11 = t21 + t109 - t108;
    const double t112 = ST - K0_11;
    const double t115 = t53 + (p->w * SF) + (p->c * t112);
    const double C1_12 = C1_12_IBxz * t115;
    const double t117 = t55 * ST;
    const double t118 = SF + t117;
    const double t120 = t63 + t65;
    const double t123 = p->mF - (t54 * (t50 + t120));
    const double t125 = t38 - (p->c * t123);
    const double t126 = cos_lam * t125;
    const double t127 = sin_lam * t109;
    const double t128 = t126 - t127;
    const double t130 = t90 + (t55 * t128);
    const double C1_22 = cos_lam * t130;
    const double K2_12 = C1_12_IBxz * t112;
    const double t135 = t128 + (sin_lam * SF);
    const double K2_22 = C1_12_IBxz * t135;
    const double M_12_w = cos_lam * (t4 + (t54 * (t33 - t56)));
    const double t141 = p->mH * cos_lam;
    const double t144 = (cos_lam * t37) - (p->zH * sin_lam);
    const double t145 = t141 * t144;
    const double t146 = t145 + t145;
    const double mu = cos_lam * t55;
    const double t148 = mu + mu;
    const double t149 = p->w * mu;
    const double t150 = p->rF * sin_lam;
    const double t151 = t73 - t150;
    const double t152 = t149 - t151;
    const double t153 = p->mF * t152;
    const double t154 = p->xH * t141;
    const double t155 = t154 - t153;
    const double t158 = t146 + (t148 * (t90 + t155));
    const double C1_12_SF = t54 * t115;
    const double C1_12_w = C1_12_IBxz * (t9 + SF - C1_12_SF);
    const double C1_21_w = C1_12_IBxz * t117;
    const double K0_12_w = t141 - (t123 * mu);
    const double C1_22_mu = p->c * ((C1_12_IBxz * t63) - K0_12_w);
    const double t169 = t89 + t130;
    const double C1_22_w = C1_12_IBxz * (C1_22_mu - t155 - t169);
    const double t174 = t54 * K2_12;
    const double t177 = t54 * (K2_22 + (cos_lam * K0_12_w));
    const double t179 = cos_lam * t109;
    const double M_12_c = (t53 * C1_12_IBxz) + t179;
    const double t182 = t92 - (t120 * mu);
    const double t183 = sin_lam + sin_lam;
    const double M_12_rF = t9 * t183;
    const double M_22_c = (cos_lam * (t182 + t182 - M_12_rF)) - t146;
    const double t189 = C1_12_IBxz * ST;
    const double IAlz = p->mH + t123;
    const double K0_12_c = cos_lam * IAlz;
    const double t197 = C1_12_IBxz * ((p->c * K0_12_c) + (cos_lam * t120) - t88 - t128);
    const double K0_22_c = sin_lam * K0_12_c;
    const double t199 = C1_12_IBxz * K0_12_c;
    const double M_12_lam = (t13 * cos_lam) - (sin_lam * (t41 + t56));
    const double t206 = (sin_lam * t68) - (cos_lam * t48);
    const double t211 = (cos_lam * (t43 - (t55 * t206))) - (sin_lam * t95);
    const double M_22_lam = t211 + t211;
    const double t213 = sin_lam * C1_12_SF;
    const double C1_21_lam = sin_lam * t118;
    const double K0_12_lam = t179 + (sin_lam * t125);
    const double t221 = (sin_lam * t169) + (mu * K0_12_lam) + (C1_12_IBxz * t206);
    const double K0_22_lam = (sin_lam * K0_12_lam) - (cos_lam * t128);
    const double t225 = t70 * t112;
    const double K2_22_lam = (C1_12_IBxz * ((cos_lam * SF) - K0_12_lam)) - (t70 * t135);
    const double M_11_rR = t108 + t108;
    const double t232 = t105 * t106;
    const double t233 = p->mR - t232;
    const double C1_12_rR = mu * t233;
    const double C1_21_rR = mu * t232;
    const double K2_12_rR = C1_12_IBxz * t233;
    const double C1_12_mR = p->rR * mu;
    const double K2_12_mR = p->rR * C1_12_IBxz;
    const double M_22_IRxx = mu * mu;
    const double C1_22_IRxx = C1_12_IBxz * mu;
    const double C1_12_IRyy = t105 * mu;
    const double K2_12_IRyy = C1_12_IBxz * t105;
    const double t244 = p->mB * C1_12_IBxz;
    const double t245 = p->c * t244;
    const double t246 = p->zB * t245;
    const double t247 = p->xB * t245;
    const double M_22_xB = t148 * t247;
    const double t249 = t21 * C1_12_IBxz;
    const double t250 = p->c + p->xB;
    const double t251 = t244 * t250;
    const double C1_22_xB = C1_12_IBxz * (t247 + (p->c * t251));
    const double t255 = sin_lam * t245;
    const double K2_22_xB = p->mB * C1_22_IRxx;
    const double M_11_zB = t21 + t21;
    const double M_11_mB = p->zB * p->zB;
    const double t259 = p->xB * mu;
    const double t260 = p->zB * t259;
    const double M_22_mB = t259 * t259;
    const double t262 = p->zB * C1_12_IBxz;
    const double t263 = t250 * t262;
    const double K2_22_mB = p->xB * C1_22_IRxx;
    const double C1_22_mB = t250 * K2_22_mB;
    const double t266 = sin_lam * t259;
    const double M_12_IHxz = cos_lam + mu;
    const double t268 = t4 * M_12_IHxz;
    const double t270 = t144 + (p->xH * mu);
    const double t271 = p->mH * t270;
    const double t272 = t154 + t271;
    const double M_22_xH = t146 + (t148 * t272);
    const double t275 = t4 * C1_12_IBxz;
    const double t276 = p->c + p->xH;
    const double C1_22_xH = C1_12_IBxz * (t272 + (p->mH * (t73 + (mu * t276))));
    const double t282 = p->mH * M_12_IHxz;
    const double t283 = sin_lam * t282;
    const double t284 = t54 * t141;
    const double K2_22_xH = M_12_IHxz * t284;
    const double M_11_zH = t4 + t4;
    const double M_12_zH = (t4 * sin_lam) - t271;
    const double t289 = t183 * t271;
    const double t290 = t276 * t284;
    const double t291 = sin_lam * t290;
    const double K0_12_zH = p->mH * sin_lam;
    const double K0_22_zH = sin_lam * K0_12_zH;
    const double t294 = t70 * t141;
    const double M_11_mH = p->zH * p->zH;
    const double t296 = p->zH * t270;
    const double M_22_mH = t270 * t270;
    const double t298 = p->zH * C1_12_IBxz;
    const double t299 = t276 * t298;
    const double K2_22_mH = C1_12_IBxz * t270;
    const double C1_22_mH = t276 * K2_22_mH;
    const double t302 = sin_lam * t270;
    const double M_22_IHxx = sin_lam * sin_lam;
    const double M_22_IHzz = M_12_IHxz * M_12_IHxz;
    const double C1_22_IHzz = C1_12_IBxz * M_12_IHxz;
    const double M_22_IHxz = t183 * M_12_IHxz;
    const double K2_22_SF = cos_lam * t70;
    const double M_11_rF = t9 + t9;
    const double M_22_rF = t153 * t183;
    const double t310 = t36 * C1_12_IBxz;
    const double t312 = p->mF - (t101 * SF);
    const double C1_12_rF = t310 * t312;
    const double t314 = t101 * M_12_IHxz;
    const double C1_21_rF = SF * t314;
    const double t316 = p->mF * sin_lam;
    const double C1_22_rF = t310 * t316;
    const double t318 = sin_lam * t316;
    const double K2_12_rF = C1_12_IBxz * t312;
    const double K2_22_rF = K2_22_SF * t312;
    const double M_11_mF = p->rF * p->rF;
    const double M_12_mF = p->rF * t150;
    const double M_22_mF = t152 * t152;
    const double C1_12_mF = p->rF * t310;
    const double K2_22_mF = C1_12_IBxz * t152;
    const double C1_22_mF = t36 * K2_22_mF;
    const double t327 = sin_lam * t152;
    const double K2_12_mF = p->rF * C1_12_IBxz;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double C1_12_IFyy = t101 * t310;
    const double K2_12_IFyy = C1_12_IBxz * t101;
    const double K2_22_IFyy = t101 * K2_22_SF;
    const double C1_21 = -(cos_lam * t118);
    const double K0_12 = t127 - t126;
    const double K0_22 = -(sin_lam * t128);
    const double t336 = -(sin_lam * K0_12_w);
    const double K0_12_mF = t151 - t149;
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
    derivatives->values[1] = t158;
    derivatives->values[2] = C1_12_w;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = K0_12_w;
    derivatives->values[6] = t336;
    derivatives->values[7] = t174;
    derivatives->values[8] = t177;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t189;
    derivatives->values[13] = t197;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t199;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t213;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = t221;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = t225;
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
    derivatives->values[36] = M_22_IRxx;
    derivatives->values[37] = C1_22_IRxx;
    derivatives->values[38] = C1_12_IRyy;
    derivatives->values[39] = K2_12_IRyy;
    derivatives->values[40] = t246;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t249;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = t245;
    derivatives->values[45] = t255;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t247;
    derivatives->values[49] = t251;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t244;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t260;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t263;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = t259;
    derivatives->values[59] = t266;
    derivatives->values[60] = t262;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = mu;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = t268;
    derivatives->values[65] = M_22_xH;
    derivatives->values[66] = t275;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = t282;
    derivatives->values[69] = t283;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = t289;
    derivatives->values[74] = t290;
    derivatives->values[75] = t291;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t284;
    derivatives->values[80] = t294;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = t296;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t299;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = t270;
    derivatives->values[88] = t302;
    derivatives->values[89] = t298;
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
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = C1_22_rF;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = t316;
    derivatives->values[106] = t318;
    derivatives->values[107] = K2_12_rF;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = M_12_mF;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = C1_22_mF;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = t327;
    derivatives->values[117] = K2_12_mF;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t314;
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
    const float t3 = p->zB * p->mB;
    const float t7 = p->zH * p->mH;
    const float t12 = p->rF * p->mF;
    const float t17 = (p->zH * t7) + (p->IHxx + ((p->rF * t12) + p->IFxx));
    const float t22 = p->rR * p->mR;
    const float ITxx = p->IBxx + ((p->zB * t3) + t17 + (p->IRxx + (p->rR * t22)));
    const float t28 = p->mH * p->xH;
    const float t34 = p->IHxz + (t12 * p->w) - (p->zH * t28);
    const float ITzz = t3 * p->xB;
    const float t39 = t34 - ITzz + p->IBxz;
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t43 = cos_lam / p->w;
    const float mu = p->c * t43;
    const float t49 = p->w - p->xH + p->c;
    const float t52 = cos_lam * ((t12 * p->c) - p->IHxz - (t7 * t49));
    const float t55 = (t17 * sin_lam) - t52;
    const float M_12 = (t39 * mu) + t55;
    const float t58 = p->IFxx + p->IHzz;
    const float t59 = p->mF * p->c;
    const float t62 = p->mH * t49;
    const float t69 = p->mF * p->w;
    const float IAlz = (t34 * sin_lam) - (cos_lam * ((p->xH * t62) - t58 + (p->c * t69)));
    const float t76 = p->mB * p->xB;
    const float t86 = IAlz + ((p->IRxx + t58 + ((p->xB * t76) + (p->xH * t28) + (p->IBzz + (p->w *
        t69)))) * mu);
    const float t89 = (cos_lam * (cos_lam * (t58 + (p->c * t59) + (t49 * t62)))) + (mu * (IAlz +
        t86));
    const float M_22 = t89 + (sin_lam * (t55 - t52));
    const float SF = p->IFyy / p->rF;
    const float SR = p->IRyy / p->rR;
    const float ST = SF + SR;
    const float t99 = t7 - t12;
    const float K0_11 = t3 + t99 - t22;
    const float t102 = ST - K0_11;
    const float C1_12 = t43 * (t39 + (p->c * t102) + (p->w * SF));
    const float K0_12 = (cos_lam * (t62 + t59)) + (sin_lam * t99) - (mu * (t28 + t69 + t76));
    const float C1_22 = (t43 * t86) - (mu * K0_12);
    const float K0_22 = sin_lam * K0_12;
    const float K2_12 = t43 * t102;
    const float K2_22 = t43 * ((sin_lam * SF) - K0_12);
    const float C1_21 = -((cos_lam * SF) + (mu * ST));
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
    const float t4 = p->zH * p->mH;
    const float t9 = p->rF * p->mF;
    const float t13 = p->IFxx + (p->zH * t4) + p->IHxx + (p->rF * t9);
    const float M_11_mR = p->rR * p->rR;
    const float t21 = p->zB * p->mB;
    const float M_11 = p->IBxx + t13 + (p->mR * M_11_mR) + p->IRxx + (p->zB * t21);
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t33 = t9 * p->c;
    const float t36 = p->c + p->w;
    const float t37 = p->xH - t36;
    const float t38 = p->mH * t37;
    const float IAlz_rF = p->zH * t38;
    const float t41 = p->IHxz - t33 - IAlz_rF;
    const float t43 = (t13 * sin_lam) + (cos_lam * t41);
    const float t48 = p->IHxz + (t9 * p->w) - (t4 * p->xH);
    const float t50 = p->mB * p->xB;
    const float t53 = p->IBxz + t48 - (p->zB * t50);
    const float t54 = 1.0F / p->w;
    const float t55 = p->c * t54;
    const float t56 = t53 * t55;
    const float M_12 = t43 + (cos_lam * t56);
    const float C1_12_IBxz = cos_lam * t54;
    const float t62 = p->IFxx + p->IHzz;
    const float t63 = p->mF * p->w;
    const float t65 = p->mH * p->xH;
    const float t68 = t62 + (t37 * t65) - (p->c * t63);
    const float t70 = sin_lam * t54;
    const float t72 = (C1_12_IBxz * t68) + (t48 * t70);
    const float t73 = cos_lam * p->c;
    const float t88 = C1_12_IBxz * (p->IRxx + t62 + (p->xB * t50) + p->IBzz + (p->w * t63) +
        (p->xH * t65));
    const float t89 = t55 * t88;
    const float t90 = t72 + t89;
    const float t92 = t90 + (p->mF * t73);
    const float t95 = (cos_lam * (t62 + (t37 * t38))) + (sin_lam * t41) + (p->c * t92);
    const float M_22 = (sin_lam * t43) + (t72 * t73) + (cos_lam * t95);
    const float t101 = 1.0F / p->rF;
    const float SF = p->IFyy * t101;
    const float t105 = 1.0F / p->rR;
    const float t106 = p->IRyy * t105;
    const float ST = SF + t106;
    const float t108 = p->mR * p->rR;
    const float t109 = t4 - t9;
    const float K0_11 = t21 + t109 - t108;
    const float t112 = ST - K0_11;
    const float t115 = t53 + (p->w * SF) + (p->c * t112);
    const float C1_12 = C1_12_IBxz * t115;
    const float t117 = t55 * ST;
    const float t118 = SF + t117;
    const float t120 = t63 + t65;
    const float t123 = p->mF - (t54 * (t50 + t120));
    const float t125 = t38 - (p->c * t123);
    const float t126 = cos_lam * t125;
    const float t127 = sin_lam * t109;
    const float t128 = t126 - t127;
    const float t130 = t90 + (t55 * t128);
    const float C1_22 = cos_lam * t130;
    const float K2_12 = C1_12_IBxz * t112;
    const float t135 = t128 + (sin_lam * SF);
    const float K2_22 = C1_12_IBxz * t135;
    const float M_12_w = cos_lam * (t4 + (t54 * (t33 - t56)));
    const float t141 = p->mH * cos_lam;
    const float t144 = (cos_lam * t37) - (p->zH * sin_lam);
    const float t145 = t141 * t144;
    const float t146 = t145 + t145;
    const float mu = cos_lam * t55;
    const float t148 = mu + mu;
    const float t149 = p->w * mu;
    const float t150 = p->rF * sin_lam;
    const float t151 = t73 - t150;
    const float t152 = t149 - t151;
    const float t153 = p->mF * t152;
    const float t154 = p->xH * t141;
    const float t155 = t154 - t153;
    const float t158 = t146 + (t148 * (t90 + t155));
    const float C1_12_SF = t54 * t115;
    const float C1_12_w = C1_12_IBxz * (t9 + SF - C1_12_SF);
    const float C1_21_w = C1_12_IBxz * t117;
    const float K0_12_w = t141 - (t123 * mu);
    const float C1_22_mu = p->c * ((C1_12_IBxz * t63) - K0_12_w);
    const float t169 = t89 + t130;
    const float C1_22_w = C1_12_IBxz * (C1_22_mu - t155 - t169);
    const float t174 = t54 * K2_12;
    const float t177 = t54 * (K2_22 + (cos_lam * K0_12_w));
    const float t179 = cos_lam * t109;
    const float M_12_c = (t53 * C1_12_IBxz) + t179;
    const float t182 = t92 - (t120 * mu);
    const float t183 = sin_lam + sin_lam;
    const float M_12_rF = t9 * t183;
    const float M_22_c = (cos_lam * (t182 + t182 - M_12_rF)) - t146;
    const float t189 = C1_12_IBxz * ST;
    const float IAlz = p->mH + t123;
    const float K0_12_c = cos_lam * IAlz;
    const float t197 = C1_12_IBxz * ((p->c * K0_12_c) + (cos_lam * t120) - t88 - t128);
    const float K0_22_c = sin_lam * K0_12_c;
    const float t199 = C1_12_IBxz * K0_12_c;
    const float M_12_lam = (t13 * cos_lam) - (sin_lam * (t41 + t56));
    const float t206 = (sin_lam * t68) - (cos_lam * t48);
    const float t211 = (cos_lam * (t43 - (t55 * t206))) - (sin_lam * t95);
    const float M_22_lam = t211 + t211;
    const float t213 = sin_lam * C1_12_SF;
    const float C1_21_lam = sin_lam * t118;
    const float K0_12_lam = t179 + (sin_lam * t125);
    const float t221 = (sin_lam * t169) + (mu * K0_12_lam) + (C1_12_IBxz * t206);
    const float K0_22_lam = (sin_lam * K0_12_lam) - (cos_lam * t128);
    const float t225 = t70 * t112;
    const float K2_22_lam = (C1_12_IBxz * ((cos_lam * SF) - K0_12_lam)) - (t70 * t135);
    const float M_11_rR = t108 + t108;
    const float t232 = t105 * t106;
    const float t233 = p->mR - t232;
    const float C1_12_rR = mu * t233;
    const float C1_21_rR = mu * t232;
    const float K2_12_rR = C1_12_IBxz * t233;
    const float C1_12_mR = p->rR * mu;
    const float K2_12_mR = p->rR * C1_12_IBxz;
    const float M_22_IRxx = mu * mu;
    const float C1_22_IRxx = C1_12_IBxz * mu;
    const float C1_12_IRyy = t105 * mu;
    const float K2_12_IRyy = C1_12_IBxz * t105;
    const float t244 = p->mB * C1_12_IBxz;
    const float t245 = p->c * t244;
    const float t246 = p->zB * t245;
    const float t247 = p->xB * t245;
    const float M_22_xB = t148 * t247;
    const float t249 = t21 * C1_12_IBxz;
    const float t250 = p->c + p->xB;
    const float t251 = t244 * t250;
    const float C1_22_xB = C1_12_IBxz * (t247 + (p->c * t251));
    const float t255 = sin_lam * t245;
    const float K2_22_xB = p->mB * C1_22_IRxx;
    const float M_11_zB = t21 + t21;
    const float M_11_mB = p->zB * p->zB;
    const float t259 = p->xB * mu;
    const float t260 = p->zB * t259;
    const float M_22_mB = t259 * t259;
    const float t262 = p->zB * C1_12_IBxz;
    const float t263 = t250 * t262;
    const float K2_22_mB = p->xB * C1_22_IRxx;
    const float C1_22_mB = t250 * K2_22_mB;
    const float t266 = sin_lam * t259;
    const float M_12_IHxz = cos_lam + mu;
    const float t268 = t4 * M_12_IHxz;
    const float t270 = t144 + (p->xH * mu);
    const float t271 = p->mH * t270;
    const float t272 = t154 + t271;
    const float M_22_xH = t146 + (t148 * t272);
    const float t275 = t4 * C1_12_IBxz;
    const float t276 = p->c + p->xH;
    const float C1_22_xH = C1_12_IBxz * (t272 + (p->mH * (t73 + (mu * t276))));
    const float t282 = p->mH * M_12_IHxz;
    const float t283 = sin_lam * t282;
    const float t284 = t54 * t141;
    const float K2_22_xH = M_12_IHxz * t284;
    const float M_11_zH = t4 + t4;
    const float M_12_zH = (t4 * sin_lam) - t271;
    const float t289 = t183 * t271;
    const float t290 = t276 * t284;
    const float t291 = sin_lam * t290;
    const float K0_12_zH = p->mH * sin_lam;
    const float K0_22_zH = sin_lam * K0_12_zH;
    const float t294 = t70 * t141;
    const float M_11_mH = p->zH * p->zH;
    const float t296 = p->zH * t270;
    const float M_22_mH = t270 * t270;
    const float t298 = p->zH * C1_12_IBxz;
    const float t299 = t276 * t298;
    const float K2_22_mH = C1_12_IBxz * t270;
    const float C1_22_mH = t276 * K2_22_mH;
    const float t302 = sin_lam * t270;
    const float M_22_IHxx = sin_lam * sin_lam;
    const float M_22_IHzz = M_12_IHxz * M_12_IHxz;
    const float C1_22_IHzz = C1_12_IBxz * M_12_IHxz;
    const float M_22_IHxz = t183 * M_12_IHxz;
    const float K2_22_SF = cos_lam * t70;
    const float M_11_rF = t9 + t9;
    const float M_22_rF = t153 * t183;
    const float t310 = t36 * C1_12_IBxz;
    const float t312 = p->mF - (t101 * SF);
    const float C1_12_rF = t310 * t312;
    const float t314 = t101 * M_12_IHxz;
    const float C1_21_rF = SF * t314;
    const float t316 = p->mF * sin_lam;
    const float C1_22_rF = t310 * t316;
    const float t318 = sin_lam * t316;
    const float K2_12_rF = C1_12_IBxz * t312;
    const float K2_22_rF = K2_22_SF * t312;
    const float M_11_mF = p->rF * p->rF;
    const float M_12_mF = p->rF * t150;
    const float M_22_mF = t152 * t152;
    const float C1_12_mF = p->rF * t310;
    const float K2_22_mF = C1_12_IBxz * t152;
    const float C1_22_mF = t36 * K2_22_mF;
    const float t327 = sin_lam * t152;
    const float K2_12_mF = p->rF * C1_12_IBxz;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float C1_12_IFyy = t101 * t310;
    const float K2_12_IFyy = C1_12_IBxz * t101;
    const float K2_22_IFyy = t101 * K2_22_SF;
    const float C1_21 = -(cos_lam * t118);
    const float K0_12 = t127 - t126;
    const float K0_22 = -(sin_lam * t128);
    const float t336 = -(sin_lam * K0_12_w);
    const float K0_12_mF = t151 - t149;
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
    derivatives->values[1] = t158;
    derivatives->values[2] = C1_12_w;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = K0_12_w;
    derivatives->values[6] = t336;
    derivatives->values[7] = t174;
    derivatives->values[8] = t177;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t189;
    derivatives->values[13] = t197;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t199;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t213;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = t221;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = t225;
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
    derivatives->values[36] = M_22_IRxx;
    derivatives->values[37] = C1_22_IRxx;
    derivatives->values[38] = C1_12_IRyy;
    derivatives->values[39] = K2_12_IRyy;
    derivatives->values[40] = t246;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t249;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = t245;
    derivatives->values[45] = t255;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t247;
    derivatives->values[49] = t251;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t244;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t260;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t263;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = t259;
    derivatives->values[59] = t266;
    derivatives->values[60] = t262;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = mu;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = t268;
    derivatives->values[65] = M_22_xH;
    derivatives->values[66] = t275;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = t282;
    derivatives->values[69] = t283;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = t289;
    derivatives->values[74] = t290;
    derivatives->values[75] = t291;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t284;
    derivatives->values[80] = t294;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = t296;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t299;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = t270;
    derivatives->values[88] = t302;
    derivatives->values[89] = t298;
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
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = C1_22_rF;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = t316;
    derivatives->values[106] = t318;
    derivatives->values[107] = K2_12_rF;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = M_12_mF;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = C1_22_mF;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = t327;
    derivatives->values[117] = K2_12_mF;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t314;
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
