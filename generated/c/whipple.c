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
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 1U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 2U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 3U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 5U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 5U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 6U, false},
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
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 65U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 66U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 67U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 68U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 68U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 69U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 70U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 71U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 72U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 72U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 73U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 74U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 75U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 76U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 77U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 77U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 78U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 79U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 80U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 81U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 82U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 82U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 83U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 84U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 85U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 86U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 87U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 87U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 88U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 89U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 90U, true},
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
    const double M_11_mB = p->zB * p->zB;
    const double t8 = p->rF * p->mF;
    const double t12 = p->zH * p->mH;
    const double t18 = (p->rF * t8) + (p->zH * t12) + p->IHxx + p->IFxx;
    const double t21 = p->rR * p->mR;
    const double M_11 = p->IRxx + p->IBxx + (p->mB * M_11_mB) + t18 + (p->rR * t21);
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t32 = p->c + p->w;
    const double t33 = p->xH - t32;
    const double t34 = p->mH * t33;
    const double t39 = p->IHxz - (p->zH * t34) - (t8 * p->c);
    const double t43 = (cos_lam * t39) + (t18 * sin_lam);
    const double t44 = p->mH * p->xH;
    const double t46 = p->mF * p->w;
    const double t49 = p->IHxz + (p->rF * t46) - (p->zH * t44);
    const double t52 = p->mB * p->xB;
    const double t55 = t49 + p->IBxz - (p->zB * t52);
    const double t56 = 1.0 / p->w;
    const double C1_12_IBxz = cos_lam * t56;
    const double mu = p->c * C1_12_IBxz;
    const double M_12 = t43 + (t55 * mu);
    const double t62 = sin_lam * t56;
    const double t65 = p->IFxx + p->IHzz;
    const double t69 = t65 + (p->xH * t34) - (p->c * t46);
    const double t71 = (t49 * t62) + (C1_12_IBxz * t69);
    const double t73 = t39 * sin_lam;
    const double t86 = C1_12_IBxz * (p->IRxx + t65 + (p->xH * t44) + (p->xB * t52) + (p->w * t46) +
        p->IBzz);
    const double t87 = p->c * t56;
    const double t88 = t86 * t87;
    const double t89 = t71 + t88;
    const double t90 = p->mF * p->c;
    const double t91 = cos_lam * t90;
    const double t95 = t73 + (cos_lam * (t65 + (t33 * t34))) + (p->c * (t89 + t91));
    const double M_22 = (sin_lam * t43) + (cos_lam * ((p->c * t71) + t95));
    const double t101 = 1.0 / p->rF;
    const double SF = p->IFyy * t101;
    const double t104 = 1.0 / p->rR;
    const double t105 = p->IRyy * t104;
    const double ST = SF + t105;
    const double t107 = p->mB * p->zB;
    const double t108 = t8 - t107;
    const double t109 = t12 - t21;
    const double t111 = ST + (t108 - t109);
    const double t115 = t55 + (p->c * t111) + (p->w * SF);
    const double C1_12 = C1_12_IBxz * t115;
    const double t117 = t87 * ST;
    const double t118 = SF + t117;
    const double t120 = t44 + t46;
    const double ITzz_mB = t56 * (t52 + t120);
    const double t123 = p->mF - ITzz_mB;
    const double t125 = (p->c * t123) - t34;
    const double t127 = p->mF * sin_lam;
    const double t128 = p->rF * t127;
    const double K0_12 = (cos_lam * t125) + (t12 * sin_lam) - t128;
    const double t133 = t89 - (t87 * K0_12);
    const double C1_22 = cos_lam * t133;
    const double K0_22 = sin_lam * K0_12;
    const double K2_12 = C1_12_IBxz * t111;
    const double t138 = (sin_lam * SF) - K0_12;
    const double K2_22 = C1_12_IBxz * t138;
    const double t140 = t12 * cos_lam;
    const double t141 = t55 * t56;
    const double M_12_w = t140 + (mu * (t8 - t141));
    const double t145 = p->mH * cos_lam;
    const double M_12_IHxz = cos_lam + mu;
    const double t149 = (cos_lam * t32) - (p->xH * M_12_IHxz);
    const double t150 = p->zH * sin_lam;
    const double K0_12_mH = t149 + t150;
    const double t152 = t150 + K0_12_mH;
    const double t153 = t149 + t152;
    const double t154 = t145 * t153;
    const double t155 = p->w * C1_12_IBxz;
    const double t156 = t90 * t155;
    const double t158 = t128 + t156 - t91;
    const double t159 = t89 - t158;
    const double t160 = mu + mu;
    const double M_22_w = t154 - (t159 * t160);
    const double t163 = cos_lam * SF;
    const double t164 = t8 * cos_lam;
    const double t167 = t56 * (C1_12 - t163 - t164);
    const double C1_21_w = C1_12_IBxz * t117;
    const double t169 = cos_lam * C1_12_IBxz;
    const double t170 = t44 * t169;
    const double t171 = t88 + t133;
    const double K0_12_w = t145 - (mu * t123);
    const double C1_22_w = (C1_12_IBxz * (t156 + t158 - t171 - (p->c * K0_12_w))) - t170;
    const double K0_22_w = sin_lam * K0_12_w;
    const double t181 = t56 * K2_12;
    const double t182 = t56 * t138;
    const double t184 = C1_12_IBxz * (K0_12_w + t182);
    const double t186 = t140 - t164;
    const double M_12_c = (cos_lam * t141) + t186;
    const double t188 = cos_lam * t159;
    const double M_22_c = t154 + t188 + t188;
    const double t191 = C1_12_IBxz * ST;
    const double K0_12_c = t145 + (cos_lam * t123);
    const double t199 = C1_12_IBxz * (K0_12 + (cos_lam * t120) + (p->c * K0_12_c) - t86);
    const double K0_22_c = sin_lam * K0_12_c;
    const double t201 = C1_12_IBxz * K0_12_c;
    const double M_12_lam = (t18 * cos_lam) - t73 - (p->c * t55 * t62);
    const double K2_22_SF = sin_lam * C1_12_IBxz;
    const double ITzz_xB = t69 * K2_22_SF;
    const double t211 = ITzz_xB - (t49 * t169);
    const double t215 = (cos_lam * t43) - (p->c * t211) - (sin_lam * t95);
    const double M_22_lam = t215 + t215;
    const double t217 = t62 * t115;
    const double C1_21_lam = sin_lam * t118;
    const double K0_12_lam = t186 - (sin_lam * t125);
    const double K0_22_lam = (sin_lam * K0_12_lam) + (cos_lam * K0_12);
    const double t228 = t62 * t111;
    const double K2_22_lam = (C1_12_IBxz * (t163 - K0_12_lam)) - (sin_lam * t182);
    const double M_11_rR = t21 + t21;
    const double t234 = t104 * t105;
    const double t235 = p->mR - t234;
    const double C1_12_rR = mu * t235;
    const double C1_21_rR = mu * t234;
    const double K2_12_rR = C1_12_IBxz * t235;
    const double M_11_mR = p->rR * p->rR;
    const double C1_12_mR = p->rR * mu;
    const double K2_12_mR = p->rR * C1_12_IBxz;
    const double M_22_ITzz = mu * mu;
    const double C1_22_ITzz = C1_12_IBxz * mu;
    const double K2_12_IRyy = C1_12_IBxz * t104;
    const double C1_12_IRyy = p->c * K2_12_IRyy;
    const double t247 = mu * t107;
    const double t248 = p->xB * mu;
    const double t249 = p->mB * t248;
    const double M_22_xB = t160 * t249;
    const double t251 = p->mB * C1_12_IBxz;
    const double t252 = p->zB * t251;
    const double t253 = p->c * t251;
    const double t254 = p->xB * C1_12_IBxz;
    const double t255 = mu + t254;
    const double C1_22_xB = t253 * (t254 + t255);
    const double t258 = sin_lam * t253;
    const double K2_22_xB = p->mB * C1_22_ITzz;
    const double M_11_zB = t107 + t107;
    const double t261 = p->mB * t255;
    const double t262 = p->zB * t248;
    const double M_22_mB = t248 * t248;
    const double t264 = p->zB * t255;
    const double C1_22_mB = t248 * t255;
    const double t266 = sin_lam * t248;
    const double t267 = p->zB * C1_12_IBxz;
    const double K2_22_mB = mu * t254;
    const double t269 = p->mH * M_12_IHxz;
    const double t270 = p->zH * t269;
    const double t271 = t153 * t269;
    const double t272 = t12 * C1_12_IBxz;
    const double t274 = C1_12_IBxz * (p->xH + p->c);
    const double t277 = C1_12_IBxz * K0_12_mH;
    const double C1_22_xH = t170 + (p->mH * ((mu * (cos_lam + t274)) - t277));
    const double K0_12_zH = p->mH * sin_lam;
    const double t282 = M_12_IHxz * K0_12_zH;
    const double C1_22_IHzz = t169 + C1_22_ITzz;
    const double K2_22_xH = p->mH * C1_22_IHzz;
    const double M_11_zH = t12 + t12;
    const double M_12_zH = p->mH * t152;
    const double M_22_zH = t153 * K0_12_zH;
    const double t288 = p->mH * t274;
    const double t289 = sin_lam * t288;
    const double K0_22_zH = sin_lam * K0_12_zH;
    const double t291 = p->mH * C1_12_IBxz;
    const double t292 = sin_lam * t291;
    const double M_11_mH = p->zH * p->zH;
    const double M_12_mH = p->zH * K0_12_mH;
    const double M_22_mH = K0_12_mH * K0_12_mH;
    const double t296 = p->zH * t274;
    const double t297 = K0_12_mH * t274;
    const double K0_22_mH = sin_lam * K0_12_mH;
    const double t299 = p->zH * C1_12_IBxz;
    const double M_22_IHxx = sin_lam * sin_lam;
    const double M_22_IHzz = M_12_IHxz * M_12_IHxz;
    const double t302 = sin_lam + sin_lam;
    const double M_22_IHxz = M_12_IHxz * t302;
    const double M_11_rF = t8 + t8;
    const double M_12_rF = t128 + t158;
    const double M_22_rF = t158 * t302;
    const double C1_12_SF = t32 * C1_12_IBxz;
    const double t309 = p->mF - (t101 * SF);
    const double C1_12_rF = C1_12_SF * t309;
    const double t311 = t101 * M_12_IHxz;
    const double C1_21_rF = SF * t311;
    const double C1_22_rF = t127 * C1_12_SF;
    const double t314 = sin_lam * t127;
    const double K2_12_rF = C1_12_IBxz * t309;
    const double K2_22_rF = K2_22_SF * t309;
    const double M_11_mF = p->rF * p->rF;
    const double t318 = p->rF * sin_lam;
    const double t320 = p->c * (cos_lam - t155);
    const double t321 = t318 - t320;
    const double M_12_mF = p->rF * t321;
    const double M_22_mF = t321 * t321;
    const double C1_12_mF = p->rF * C1_12_SF;
    const double K2_22_mF = C1_12_IBxz * t321;
    const double C1_22_mF = t32 * K2_22_mF;
    const double t327 = sin_lam * t321;
    const double K2_12_mF = p->rF * C1_12_IBxz;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double C1_12_IFyy = t101 * C1_12_SF;
    const double K2_12_IFyy = C1_12_IBxz * t101;
    const double K2_22_IFyy = sin_lam * K2_12_IFyy;
    const double C1_21 = -(cos_lam * t118);
    const double K0_11 = t109 - t108;
    const double C1_22_lam = -(t211 + (sin_lam * t171) + (mu * K0_12_lam));
    const double K0_12_mF = t320 - t318;
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
    derivatives->values[1] = M_22_w;
    derivatives->values[2] = t167;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = K0_12_w;
    derivatives->values[6] = K0_22_w;
    derivatives->values[7] = t181;
    derivatives->values[8] = t184;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t191;
    derivatives->values[13] = t199;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t201;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t217;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = t228;
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
    derivatives->values[40] = t247;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t252;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = t253;
    derivatives->values[45] = t258;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t249;
    derivatives->values[49] = t261;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t251;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t262;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t264;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = t248;
    derivatives->values[59] = t266;
    derivatives->values[60] = t267;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = mu;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = t270;
    derivatives->values[65] = t271;
    derivatives->values[66] = t272;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = t269;
    derivatives->values[69] = t282;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = M_22_zH;
    derivatives->values[74] = t288;
    derivatives->values[75] = t289;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t291;
    derivatives->values[80] = t292;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = M_12_mH;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t296;
    derivatives->values[85] = t297;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = K0_22_mH;
    derivatives->values[89] = t299;
    derivatives->values[90] = t277;
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
    derivatives->values[105] = t127;
    derivatives->values[106] = t314;
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
    derivatives->values[121] = t311;
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
    const float M_11_mB = p->zB * p->zB;
    const float t8 = p->rF * p->mF;
    const float t12 = p->zH * p->mH;
    const float t18 = (p->rF * t8) + (p->zH * t12) + p->IHxx + p->IFxx;
    const float t21 = p->rR * p->mR;
    const float M_11 = p->IRxx + p->IBxx + (p->mB * M_11_mB) + t18 + (p->rR * t21);
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t32 = p->c + p->w;
    const float t33 = p->xH - t32;
    const float t34 = p->mH * t33;
    const float t39 = p->IHxz - (p->zH * t34) - (t8 * p->c);
    const float t43 = (cos_lam * t39) + (t18 * sin_lam);
    const float t44 = p->mH * p->xH;
    const float t46 = p->mF * p->w;
    const float t49 = p->IHxz + (p->rF * t46) - (p->zH * t44);
    const float t52 = p->mB * p->xB;
    const float t55 = t49 + p->IBxz - (p->zB * t52);
    const float t56 = 1.0F / p->w;
    const float C1_12_IBxz = cos_lam * t56;
    const float mu = p->c * C1_12_IBxz;
    const float M_12 = t43 + (t55 * mu);
    const float t62 = sin_lam * t56;
    const float t65 = p->IFxx + p->IHzz;
    const float t69 = t65 + (p->xH * t34) - (p->c * t46);
    const float t71 = (t49 * t62) + (C1_12_IBxz * t69);
    const float t73 = t39 * sin_lam;
    const float t86 = C1_12_IBxz * (p->IRxx + t65 + (p->xH * t44) + (p->xB * t52) + (p->w * t46) +
        p->IBzz);
    const float t87 = p->c * t56;
    const float t88 = t86 * t87;
    const float t89 = t71 + t88;
    const float t90 = p->mF * p->c;
    const float t91 = cos_lam * t90;
    const float t95 = t73 + (cos_lam * (t65 + (t33 * t34))) + (p->c * (t89 + t91));
    const float M_22 = (sin_lam * t43) + (cos_lam * ((p->c * t71) + t95));
    const float t101 = 1.0F / p->rF;
    const float SF = p->IFyy * t101;
    const float t104 = 1.0F / p->rR;
    const float t105 = p->IRyy * t104;
    const float ST = SF + t105;
    const float t107 = p->mB * p->zB;
    const float t108 = t8 - t107;
    const float t109 = t12 - t21;
    const float t111 = ST + (t108 - t109);
    const float t115 = t55 + (p->c * t111) + (p->w * SF);
    const float C1_12 = C1_12_IBxz * t115;
    const float t117 = t87 * ST;
    const float t118 = SF + t117;
    const float t120 = t44 + t46;
    const float ITzz_mB = t56 * (t52 + t120);
    const float t123 = p->mF - ITzz_mB;
    const float t125 = (p->c * t123) - t34;
    const float t127 = p->mF * sin_lam;
    const float t128 = p->rF * t127;
    const float K0_12 = (cos_lam * t125) + (t12 * sin_lam) - t128;
    const float t133 = t89 - (t87 * K0_12);
    const float C1_22 = cos_lam * t133;
    const float K0_22 = sin_lam * K0_12;
    const float K2_12 = C1_12_IBxz * t111;
    const float t138 = (sin_lam * SF) - K0_12;
    const float K2_22 = C1_12_IBxz * t138;
    const float t140 = t12 * cos_lam;
    const float t141 = t55 * t56;
    const float M_12_w = t140 + (mu * (t8 - t141));
    const float t145 = p->mH * cos_lam;
    const float M_12_IHxz = cos_lam + mu;
    const float t149 = (cos_lam * t32) - (p->xH * M_12_IHxz);
    const float t150 = p->zH * sin_lam;
    const float K0_12_mH = t149 + t150;
    const float t152 = t150 + K0_12_mH;
    const float t153 = t149 + t152;
    const float t154 = t145 * t153;
    const float t155 = p->w * C1_12_IBxz;
    const float t156 = t90 * t155;
    const float t158 = t128 + t156 - t91;
    const float t159 = t89 - t158;
    const float t160 = mu + mu;
    const float M_22_w = t154 - (t159 * t160);
    const float t163 = cos_lam * SF;
    const float t164 = t8 * cos_lam;
    const float t167 = t56 * (C1_12 - t163 - t164);
    const float C1_21_w = C1_12_IBxz * t117;
    const float t169 = cos_lam * C1_12_IBxz;
    const float t170 = t44 * t169;
    const float t171 = t88 + t133;
    const float K0_12_w = t145 - (mu * t123);
    const float C1_22_w = (C1_12_IBxz * (t156 + t158 - t171 - (p->c * K0_12_w))) - t170;
    const float K0_22_w = sin_lam * K0_12_w;
    const float t181 = t56 * K2_12;
    const float t182 = t56 * t138;
    const float t184 = C1_12_IBxz * (K0_12_w + t182);
    const float t186 = t140 - t164;
    const float M_12_c = (cos_lam * t141) + t186;
    const float t188 = cos_lam * t159;
    const float M_22_c = t154 + t188 + t188;
    const float t191 = C1_12_IBxz * ST;
    const float K0_12_c = t145 + (cos_lam * t123);
    const float t199 = C1_12_IBxz * (K0_12 + (cos_lam * t120) + (p->c * K0_12_c) - t86);
    const float K0_22_c = sin_lam * K0_12_c;
    const float t201 = C1_12_IBxz * K0_12_c;
    const float M_12_lam = (t18 * cos_lam) - t73 - (p->c * t55 * t62);
    const float K2_22_SF = sin_lam * C1_12_IBxz;
    const float ITzz_xB = t69 * K2_22_SF;
    const float t211 = ITzz_xB - (t49 * t169);
    const float t215 = (cos_lam * t43) - (p->c * t211) - (sin_lam * t95);
    const float M_22_lam = t215 + t215;
    const float t217 = t62 * t115;
    const float C1_21_lam = sin_lam * t118;
    const float K0_12_lam = t186 - (sin_lam * t125);
    const float K0_22_lam = (sin_lam * K0_12_lam) + (cos_lam * K0_12);
    const float t228 = t62 * t111;
    const float K2_22_lam = (C1_12_IBxz * (t163 - K0_12_lam)) - (sin_lam * t182);
    const float M_11_rR = t21 + t21;
    const float t234 = t104 * t105;
    const float t235 = p->mR - t234;
    const float C1_12_rR = mu * t235;
    const float C1_21_rR = mu * t234;
    const float K2_12_rR = C1_12_IBxz * t235;
    const float M_11_mR = p->rR * p->rR;
    const float C1_12_mR = p->rR * mu;
    const float K2_12_mR = p->rR * C1_12_IBxz;
    const float M_22_ITzz = mu * mu;
    const float C1_22_ITzz = C1_12_IBxz * mu;
    const float K2_12_IRyy = C1_12_IBxz * t104;
    const float C1_12_IRyy = p->c * K2_12_IRyy;
    const float t247 = mu * t107;
    const float t248 = p->xB * mu;
    const float t249 = p->mB * t248;
    const float M_22_xB = t160 * t249;
    const float t251 = p->mB * C1_12_IBxz;
    const float t252 = p->zB * t251;
    const float t253 = p->c * t251;
    const float t254 = p->xB * C1_12_IBxz;
    const float t255 = mu + t254;
    const float C1_22_xB = t253 * (t254 + t255);
    const float t258 = sin_lam * t253;
    const float K2_22_xB = p->mB * C1_22_ITzz;
    const float M_11_zB = t107 + t107;
    const float t261 = p->mB * t255;
    const float t262 = p->zB * t248;
    const float M_22_mB = t248 * t248;
    const float t264 = p->zB * t255;
    const float C1_22_mB = t248 * t255;
    const float t266 = sin_lam * t248;
    const float t267 = p->zB * C1_12_IBxz;
    const float K2_22_mB = mu * t254;
    const float t269 = p->mH * M_12_IHxz;
    const float t270 = p->zH * t269;
    const float t271 = t153 * t269;
    const float t272 = t12 * C1_12_IBxz;
    const float t274 = C1_12_IBxz * (p->xH + p->c);
    const float t277 = C1_12_IBxz * K0_12_mH;
    const float C1_22_xH = t170 + (p->mH * ((mu * (cos_lam + t274)) - t277));
    const float K0_12_zH = p->mH * sin_lam;
    const float t282 = M_12_IHxz * K0_12_zH;
    const float C1_22_IHzz = t169 + C1_22_ITzz;
    const float K2_22_xH = p->mH * C1_22_IHzz;
    const float M_11_zH = t12 + t12;
    const float M_12_zH = p->mH * t152;
    const float M_22_zH = t153 * K0_12_zH;
    const float t288 = p->mH * t274;
    const float t289 = sin_lam * t288;
    const float K0_22_zH = sin_lam * K0_12_zH;
    const float t291 = p->mH * C1_12_IBxz;
    const float t292 = sin_lam * t291;
    const float M_11_mH = p->zH * p->zH;
    const float M_12_mH = p->zH * K0_12_mH;
    const float M_22_mH = K0_12_mH * K0_12_mH;
    const float t296 = p->zH * t274;
    const float t297 = K0_12_mH * t274;
    const float K0_22_mH = sin_lam * K0_12_mH;
    const float t299 = p->zH * C1_12_IBxz;
    const float M_22_IHxx = sin_lam * sin_lam;
    const float M_22_IHzz = M_12_IHxz * M_12_IHxz;
    const float t302 = sin_lam + sin_lam;
    const float M_22_IHxz = M_12_IHxz * t302;
    const float M_11_rF = t8 + t8;
    const float M_12_rF = t128 + t158;
    const float M_22_rF = t158 * t302;
    const float C1_12_SF = t32 * C1_12_IBxz;
    const float t309 = p->mF - (t101 * SF);
    const float C1_12_rF = C1_12_SF * t309;
    const float t311 = t101 * M_12_IHxz;
    const float C1_21_rF = SF * t311;
    const float C1_22_rF = t127 * C1_12_SF;
    const float t314 = sin_lam * t127;
    const float K2_12_rF = C1_12_IBxz * t309;
    const float K2_22_rF = K2_22_SF * t309;
    const float M_11_mF = p->rF * p->rF;
    const float t318 = p->rF * sin_lam;
    const float t320 = p->c * (cos_lam - t155);
    const float t321 = t318 - t320;
    const float M_12_mF = p->rF * t321;
    const float M_22_mF = t321 * t321;
    const float C1_12_mF = p->rF * C1_12_SF;
    const float K2_22_mF = C1_12_IBxz * t321;
    const float C1_22_mF = t32 * K2_22_mF;
    const float t327 = sin_lam * t321;
    const float K2_12_mF = p->rF * C1_12_IBxz;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float C1_12_IFyy = t101 * C1_12_SF;
    const float K2_12_IFyy = C1_12_IBxz * t101;
    const float K2_22_IFyy = sin_lam * K2_12_IFyy;
    const float C1_21 = -(cos_lam * t118);
    const float K0_11 = t109 - t108;
    const float C1_22_lam = -(t211 + (sin_lam * t171) + (mu * K0_12_lam));
    const float K0_12_mF = t320 - t318;
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
    derivatives->values[1] = M_22_w;
    derivatives->values[2] = t167;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = K0_12_w;
    derivatives->values[6] = K0_22_w;
    derivatives->values[7] = t181;
    derivatives->values[8] = t184;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t191;
    derivatives->values[13] = t199;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t201;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t217;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = t228;
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
    derivatives->values[40] = t247;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t252;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = t253;
    derivatives->values[45] = t258;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t249;
    derivatives->values[49] = t261;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t251;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t262;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t264;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = t248;
    derivatives->values[59] = t266;
    derivatives->values[60] = t267;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = mu;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = t270;
    derivatives->values[65] = t271;
    derivatives->values[66] = t272;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = t269;
    derivatives->values[69] = t282;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = M_22_zH;
    derivatives->values[74] = t288;
    derivatives->values[75] = t289;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t291;
    derivatives->values[80] = t292;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = M_12_mH;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t296;
    derivatives->values[85] = t297;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = K0_22_mH;
    derivatives->values[89] = t299;
    derivatives->values[90] = t277;
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
    derivatives->values[105] = t127;
    derivatives->values[106] = t314;
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
    derivatives->values[121] = t311;
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
