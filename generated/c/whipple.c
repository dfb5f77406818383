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
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 2U, false},
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
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 13U, false},
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
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 85U, false},
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
    const double t6 = p->zH * p->mH;
    const double t10 = p->rF * p->mF;
    const double t14 = p->IHxx + p->IFxx + (p->zH * t6) + (p->rF * t10);
    const double t17 = p->rR * p->mR;
    const double t21 = p->zB * p->mB;
    const double M_11 = p->IRxx + p->IBxx + t14 + (p->rR * t17) + (p->zB * t21);
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t35 = p->c + p->w - p->xH;
    const double t38 = p->IHxz + (t6 * t35) - (t10 * p->c);
    const double t39 = cos_lam * t38;
    const double t42 = t39 + (t14 * sin_lam);
    const double t47 = p->IHxz + (t10 * p->w) - (t6 * p->xH);
    const double ITxz = p->IBxz + t47 - (t21 * p->xB);
    const double t52 = 1.0 / p->w;
    const double C1_12_IBxz = cos_lam * t52;
    const double mu = p->c * C1_12_IBxz;
    const double M_12 = t42 + (ITxz * mu);
    const double t59 = p->IFxx + p->IHzz;
    const double t60 = p->mF * p->c;
    const double t62 = p->mH * p->xH;
    const double t65 = t59 - (p->w * t60) - (t35 * t62);
    const double IAlz = (sin_lam * t47) + (cos_lam * t65);
    const double t69 = p->mF * p->w;
    const double t71 = p->mB * p->xB;
    const double ITzz = p->IRxx + t59 + p->IBzz + (p->w * t69) + (p->xB * t71) + (p->xH * t62);
    const double t80 = IAlz + (mu * ITzz);
    const double t85 = cos_lam * cos_lam;
    const double t87 = p->mH * t35;
    const double t90 = t59 + (p->c * t60) + (t35 * t87);
    const double M_22 = (mu * (IAlz + t80)) + (sin_lam * (t39 + t42)) + (t85 * t90);
    const double t96 = 1.0 / p->rF;
    const double SF = p->IFyy * t96;
    const double t100 = 1.0 / p->rR;
    const double t101 = p->IRyy * t100;
    const double ST = SF + t101;
    const double t103 = t10 - t6;
    const double t104 = t21 - t17;
    const double t106 = ST + (t103 - t104);
    const double t109 = ITxz + (p->w * SF) + (p->c * t106);
    const double C1_12 = C1_12_IBxz * t109;
    const double t111 = cos_lam * SF;
    const double t115 = t62 + t69 + t71;
    const double t118 = t60 + t87;
    const double K0_12 = (cos_lam * t118) - (mu * t115) - (sin_lam * t103);
    const double C1_22 = (C1_12_IBxz * t80) - (mu * K0_12);
    const double K0_22 = sin_lam * K0_12;
    const double K2_12 = C1_12_IBxz * t106;
    const double t127 = sin_lam * SF;
    const double t128 = t127 - K0_12;
    const double K2_22 = C1_12_IBxz * t128;
    const double t130 = t6 * cos_lam;
    const double t132 = t52 * C1_12_IBxz;
    const double t133 = p->c * ITxz;
    const double M_12_w = t130 + (t10 * mu) - (t132 * t133);
    const double t137 = cos_lam * t62;
    const double t138 = mu + mu;
    const double t140 = sin_lam + sin_lam;
    const double t142 = t35 * t85;
    const double t147 = (t130 * t140) + (p->mH * t142) + (t85 * t87) - (t137 * t138);
    const double t149 = t10 * sin_lam;
    const double IAlz_w = t149 - (cos_lam * t60);
    const double M_22_mu = t80 + t80;
    const double t153 = p->c * M_22_mu;
    const double ITzz_w = t69 + t69;
    const double M_22_ITzz = mu * mu;
    const double M_22_w = t147 + (t138 * IAlz_w) + (ITzz_w * M_22_ITzz) - (t132 * t153);
    const double C1_12_w = (C1_12_IBxz * (t10 + SF)) - (t109 * t132);
    const double t165 = p->c * ST;
    const double C1_21_w = t132 * t165;
    const double t167 = C1_12_IBxz * t137;
    const double t168 = p->mH * cos_lam;
    const double t170 = p->c * t115;
    const double K0_12_w = t168 + (t132 * t170) - (p->mF * mu);
    const double C1_22_mu = (C1_12_IBxz * ITzz) - K0_12;
    const double t179 = t80 + (p->c * C1_22_mu);
    const double C1_22_ITzz = C1_12_IBxz * mu;
    const double C1_22_w = (C1_12_IBxz * IAlz_w) + (ITzz_w * C1_22_ITzz) - t167 - (mu * K0_12_w) -
        (t132 * t179);
    const double K0_22_w = sin_lam * K0_12_w;
    const double t188 = t106 * t132;
    const double t191 = (C1_12_IBxz * K0_12_w) + (t128 * t132);
    const double t192 = t10 * cos_lam;
    const double M_12_c = t130 + (ITxz * C1_12_IBxz) - t192;
    const double t197 = cos_lam * p->w;
    const double t200 = (p->c * t85) - (t138 * t197);
    const double M_22_c = t147 + (p->mF * t200) + (C1_12_IBxz * M_22_mu) + (t60 * t85) - (t140 *
        t192);
    const double t208 = C1_12_IBxz * ST;
    const double K0_12_c = t168 + (p->mF * cos_lam) - (C1_12_IBxz * t115);
    const double t214 = C1_12_IBxz * t197;
    const double C1_22_c = (C1_12_IBxz * C1_22_mu) - t167 - (mu * K0_12_c) - (p->mF * t214);
    const double K0_22_c = sin_lam * K0_12_c;
    const double t221 = C1_12_IBxz * K0_12_c;
    const double t222 = t38 * sin_lam;
    const double t224 = sin_lam * t52;
    const double M_12_lam = (t14 * cos_lam) - t222 - (t133 * t224);
    const double t228 = cos_lam * sin_lam;
    const double IAlz_lam = (cos_lam * t47) - (sin_lam * t65);
    const double M_22_lam = (t138 * IAlz_lam) + (cos_lam * (t42 + t42)) - (t90 * (t228 + t228)) -
        (t140 * t222) - (t153 * t224);
    const double t243 = t109 * t224;
    const double C1_21_lam = t127 + (t165 * t224);
    const double K0_12_lam = (t170 * t224) - (cos_lam * t103) - (sin_lam * t118);
    const double C1_22_lam = (C1_12_IBxz * IAlz_lam) - (mu * K0_12_lam) - (t179 * t224);
    const double K0_22_lam = (sin_lam * K0_12_lam) + (cos_lam * K0_12);
    const double t259 = t106 * t224;
    const double K2_22_lam = (C1_12_IBxz * (t111 - K0_12_lam)) - (t128 * t224);
    const double M_11_rR = t17 + t17;
    const double t265 = t100 * t101;
    const double t266 = p->mR - t265;
    const double C1_12_rR = mu * t266;
    const double C1_21_rR = mu * t265;
    const double K2_12_rR = C1_12_IBxz * t266;
    const double M_11_mR = p->rR * p->rR;
    const double C1_12_mR = p->rR * mu;
    const double K2_12_mR = p->rR * C1_12_IBxz;
    const double C1_12_IRyy = mu * t100;
    const double K2_12_IRyy = C1_12_IBxz * t100;
    const double t276 = t21 * mu;
    const double ITzz_xB = t71 + t71;
    const double M_22_xB = M_22_ITzz * ITzz_xB;
    const double t279 = t21 * C1_12_IBxz;
    const double t280 = p->mB * mu;
    const double C1_22_xB = (mu * t280) + (C1_22_ITzz * ITzz_xB);
    const double t284 = sin_lam * t280;
    const double K2_22_xB = C1_12_IBxz * t280;
    const double M_11_zB = t21 + t21;
    const double t287 = p->xB * mu;
    const double t288 = p->mB * t287;
    const double t290 = mu + (p->xB * C1_12_IBxz);
    const double t291 = p->mB * t290;
    const double t292 = p->mB * C1_12_IBxz;
    const double M_11_mB = p->zB * p->zB;
    const double t294 = p->zB * t287;
    const double ITzz_mB = p->xB * p->xB;
    const double M_22_mB = M_22_ITzz * ITzz_mB;
    const double t297 = p->zB * t290;
    const double C1_22_mB = (mu * t287) + (C1_22_ITzz * ITzz_mB);
    const double t301 = sin_lam * t287;
    const double t302 = p->zB * C1_12_IBxz;
    const double K2_22_mB = C1_12_IBxz * t287;
    const double t305 = t130 + (t6 * mu);
    const double t306 = t6 * sin_lam;
    const double t308 = cos_lam * t35;
    const double t311 = (p->xH * M_22_ITzz) - (t138 * t308);
    const double M_22_xH = (p->mH * t311) + (t62 * M_22_ITzz) - t147 - (t138 * t306);
    const double t317 = t6 * C1_12_IBxz;
    const double t319 = t168 + (p->mH * mu);
    const double t323 = (p->xH * C1_22_ITzz) - (C1_12_IBxz * t308);
    const double C1_22_xH = t167 + (mu * t319) + (p->mH * t323) + (t62 * C1_22_ITzz) - (C1_12_IBxz *
        t306);
    const double t331 = sin_lam * t319;
    const double K2_22_xH = C1_12_IBxz * t319;
    const double M_11_zH = t6 + t6;
    const double K0_12_mH = t308 + (p->zH * sin_lam) - (p->xH * mu);
    const double M_12_zH = t306 + (p->mH * K0_12_mH);
    const double t340 = p->xH * sin_lam;
    const double M_22_IHxx = sin_lam * sin_lam;
    const double t346 = (t140 * t308) + (p->zH * M_22_IHxx) - (t138 * t340);
    const double M_22_zH = (p->mH * t346) + (t6 * M_22_IHxx);
    const double t351 = mu + (p->xH * C1_12_IBxz);
    const double t352 = p->mH * t351;
    const double K0_12_zH = p->mH * sin_lam;
    const double t355 = C1_12_IBxz * t340;
    const double t357 = (mu * K0_12_zH) + (p->mH * t355);
    const double K0_22_zH = sin_lam * K0_12_zH;
    const double t359 = p->mH * C1_12_IBxz;
    const double t360 = C1_12_IBxz * K0_12_zH;
    const double M_11_mH = p->zH * p->zH;
    const double M_12_mH = p->zH * K0_12_mH;
    const double M_22_mH = (p->xH * t311) + (p->zH * t346) + (t35 * t142);
    const double t368 = p->zH * t351;
    const double C1_22_mH = (p->xH * t323) - (mu * K0_12_mH) - (p->zH * t355);
    const double K0_22_mH = sin_lam * K0_12_mH;
    const double t375 = p->zH * C1_12_IBxz;
    const double t376 = C1_12_IBxz * K0_12_mH;
    const double M_22_IHzz = t85 + M_22_ITzz + (cos_lam * t138);
    const double C1_22_IHzz = C1_22_ITzz + (cos_lam * C1_12_IBxz);
    const double M_12_IHxz = cos_lam + mu;
    const double t384 = t228 + (sin_lam * mu);
    const double M_22_IHxz = t384 + t384;
    const double K2_22_SF = sin_lam * C1_12_IBxz;
    const double M_11_rF = t10 + t10;
    const double t388 = p->rF * sin_lam;
    const double t389 = cos_lam * p->c;
    const double t391 = t389 - (p->w * mu);
    const double t392 = t388 - t391;
    const double M_12_rF = t149 + (p->mF * t392);
    const double t395 = p->w * sin_lam;
    const double t400 = (t138 * t395) + (p->rF * M_22_IHxx) - (t140 * t389);
    const double M_22_rF = (p->mF * t400) + (t10 * M_22_IHxx);
    const double C1_12_SF = mu + (p->w * C1_12_IBxz);
    const double t407 = t96 * SF;
    const double C1_12_rF = (p->mF * C1_12_SF) - (C1_12_SF * t407);
    const double C1_21_rF = M_12_IHxz * t407;
    const double t411 = p->mF * sin_lam;
    const double t413 = C1_12_IBxz * t395;
    const double C1_22_rF = (mu * t411) + (p->mF * t413);
    const double t416 = sin_lam * t411;
    const double K2_12_rF = C1_12_IBxz * (p->mF - t407);
    const double K2_22_rF = (C1_12_IBxz * t411) - (K2_22_SF * t407);
    const double M_11_mF = p->rF * p->rF;
    const double M_12_mF = p->rF * t392;
    const double ITzz_mF = p->w * p->w;
    const double M_22_mF = (p->c * t200) + (p->rF * t400) + (M_22_ITzz * ITzz_mF);
    const double C1_12_mF = p->rF * C1_12_SF;
    const double C1_22_mF = (mu * t392) + (p->rF * t413) + (C1_22_ITzz * ITzz_mF) - (p->c * t214);
    const double t438 = sin_lam * t392;
    const double K2_12_mF = p->rF * C1_12_IBxz;
    const double K2_22_mF = C1_12_IBxz * t392;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double C1_12_IFyy = t96 * C1_12_SF;
    const double t443 = t96 * M_12_IHxz;
    const double K2_12_IFyy = C1_12_IBxz * t96;
    const double K2_22_IFyy = t96 * K2_22_SF;
    const double C1_21 = -(t111 + (mu * ST));
    const double K0_11 = t104 - t103;
    const double K0_12_mF = t391 - t388;
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
    derivatives->values[2] = C1_12_w;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = K0_12_w;
    derivatives->values[6] = K0_22_w;
    derivatives->values[7] = t188;
    derivatives->values[8] = t191;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t208;
    derivatives->values[13] = C1_22_c;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t221;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t243;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = t259;
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
    derivatives->values[40] = t276;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t279;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = t280;
    derivatives->values[45] = t284;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t288;
    derivatives->values[49] = t291;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t292;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t294;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t297;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = t287;
    derivatives->values[59] = t301;
    derivatives->values[60] = t302;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = mu;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = t305;
    derivatives->values[65] = M_22_xH;
    derivatives->values[66] = t317;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = t319;
    derivatives->values[69] = t331;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = M_22_zH;
    derivatives->values[74] = t352;
    derivatives->values[75] = t357;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t359;
    derivatives->values[80] = t360;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = M_12_mH;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t368;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = K0_22_mH;
    derivatives->values[89] = t375;
    derivatives->values[90] = t376;
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
    derivatives->values[105] = t411;
    derivatives->values[106] = t416;
    derivatives->values[107] = K2_12_rF;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = M_12_mF;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = C1_22_mF;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = t438;
    derivatives->values[117] = K2_12_mF;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t443;
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
    const float t6 = p->zH * p->mH;
    const float t10 = p->rF * p->mF;
    const float t14 = p->IHxx + p->IFxx + (p->zH * t6) + (p->rF * t10);
    const float t17 = p->rR * p->mR;
    const float t21 = p->zB * p->mB;
    const float M_11 = p->IRxx + p->IBxx + t14 + (p->rR * t17) + (p->zB * t21);
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t35 = p->c + p->w - p->xH;
    const float t38 = p->IHxz + (t6 * t35) - (t10 * p->c);
    const float t39 = cos_lam * t38;
    const float t42 = t39 + (t14 * sin_lam);
    const float t47 = p->IHxz + (t10 * p->w) - (t6 * p->xH);
    const float ITxz = p->IBxz + t47 - (t21 * p->xB);
    const float t52 = 1.0F / p->w;
    const float C1_12_IBxz = cos_lam * t52;
    const float mu = p->c * C1_12_IBxz;
    const float M_12 = t42 + (ITxz * mu);
    const float t59 = p->IFxx + p->IHzz;
    const float t60 = p->mF * p->c;
    const float t62 = p->mH * p->xH;
    const float t65 = t59 - (p->w * t60) - (t35 * t62);
    const float IAlz = (sin_lam * t47) + (cos_lam * t65);
    const float t69 = p->mF * p->w;
    const float t71 = p->mB * p->xB;
    const float ITzz = p->IRxx + t59 + p->IBzz + (p->w * t69) + (p->xB * t71) + (p->xH * t62);
    const float t80 = IAlz + (mu * ITzz);
    const float t85 = cos_lam * cos_lam;
    const float t87 = p->mH * t35;
    const float t90 = t59 + (p->c * t60) + (t35 * t87);
    const float M_22 = (mu * (IAlz + t80)) + (sin_lam * (t39 + t42)) + (t85 * t90);
    const float t96 = 1.0F / p->rF;
    const float SF = p->IFyy * t96;
    const float t100 = 1.0F / p->rR;
    const float t101 = p->IRyy * t100;
    const float ST = SF + t101;
    const float t103 = t10 - t6;
    const float t104 = t21 - t17;
    const float t106 = ST + (t103 - t104);
    const float t109 = ITxz + (p->w * SF) + (p->c * t106);
    const float C1_12 = C1_12_IBxz * t109;
    const float t111 = cos_lam * SF;
    const float t115 = t62 + t69 + t71;
    const float t118 = t60 + t87;
    const float K0_12 = (cos_lam * t118) - (mu * t115) - (sin_lam * t103);
    const float C1_22 = (C1_12_IBxz * t80) - (mu * K0_12);
    const float K0_22 = sin_lam * K0_12;
    const float K2_12 = C1_12_IBxz * t106;
    const float t127 = sin_lam * SF;
    const float t128 = t127 - K0_12;
    const float K2_22 = C1_12_IBxz * t128;
    const float t130 = t6 * cos_lam;
    const float t132 = t52 * C1_12_IBxz;
    const float t133 = p->c * ITxz;
    const float M_12_w = t130 + (t10 * mu) - (t132 * t133);
    const float t137 = cos_lam * t62;
    const float t138 = mu + mu;
    const float t140 = sin_lam + sin_lam;
    const float t142 = t35 * t85;
    const float t147 = (t130 * t140) + (p->mH * t142) + (t85 * t87) - (t137 * t138);
    const float t149 = t10 * sin_lam;
    const float IAlz_w = t149 - (cos_lam * t60);
    const float M_22_mu = t80 + t80;
    const float t153 = p->c * M_22_mu;
    const float ITzz_w = t69 + t69;
    const float M_22_ITzz = mu * mu;
    const float M_22_w = t147 + (t138 * IAlz_w) + (ITzz_w * M_22_ITzz) - (t132 * t153);
    const float C1_12_w = (C1_12_IBxz * (t10 + SF)) - (t109 * t132);
    const float t165 = p->c * ST;
    const float C1_21_w = t132 * t165;
    const float t167 = C1_12_IBxz * t137;
    const float t168 = p->mH * cos_lam;
    const float t170 = p->c * t115;
    const float K0_12_w = t168 + (t132 * t170) - (p->mF * mu);
    const float C1_22_mu = (C1_12_IBxz * ITzz) - K0_12;
    const float t179 = t80 + (p->c * C1_22_mu);
    const float C1_22_ITzz = C1_12_IBxz * mu;
    const float C1_22_w = (C1_12_IBxz * IAlz_w) + (ITzz_w * C1_22_ITzz) - t167 - (mu * K0_12_w) -
        (t132 * t179);
    const float K0_22_w = sin_lam * K0_12_w;
    const float t188 = t106 * t132;
    const float t191 = (C1_12_IBxz * K0_12_w) + (t128 * t132);
    const float t192 = t10 * cos_lam;
    const float M_12_c = t130 + (ITxz * C1_12_IBxz) - t192;
    const float t197 = cos_lam * p->w;
    const float t200 = (p->c * t85) - (t138 * t197);
    const float M_22_c = t147 + (p->mF * t200) + (C1_12_IBxz * M_22_mu) + (t60 * t85) - (t140 *
        t192);
    const float t208 = C1_12_IBxz * ST;
    const float K0_12_c = t168 + (p->mF * cos_lam) - (C1_12_IBxz * t115);
    const float t214 = C1_12_IBxz * t197;
    const float C1_22_c = (C1_12_IBxz * C1_22_mu) - t167 - (mu * K0_12_c) - (p->mF * t214);
    const float K0_22_c = sin_lam * K0_12_c;
    const float t221 = C1_12_IBxz * K0_12_c;
    const float t222 = t38 * sin_lam;
    const float t224 = sin_lam * t52;
    const float M_12_lam = (t14 * cos_lam) - t222 - (t133 * t224);
    const float t228 = cos_lam * sin_lam;
    const float IAlz_lam = (cos_lam * t47) - (sin_lam * t65);
    const float M_22_lam = (t138 * IAlz_lam) + (cos_lam * (t42 + t42)) - (t90 * (t228 + t228)) -
        (t140 * t222) - (t153 * t224);
    const float t243 = t109 * t224;
    const float C1_21_lam = t127 + (t165 * t224);
    const float K0_12_lam = (t170 * t224) - (cos_lam * t103) - (sin_lam * t118);
    const float C1_22_lam = (C1_12_IBxz * IAlz_lam) - (mu * K0_12_lam) - (t179 * t224);
    const float K0_22_lam = (sin_lam * K0_12_lam) + (cos_lam * K0_12);
    const float t259 = t106 * t224;
    const float K2_22_lam = (C1_12_IBxz * (t111 - K0_12_lam)) - (t128 * t224);
    const float M_11_rR = t17 + t17;
    const float t265 = t100 * t101;
    const float t266 = p->mR - t265;
    const float C1_12_rR = mu * t266;
    const float C1_21_rR = mu * t265;
    const float K2_12_rR = C1_12_IBxz * t266;
    const float M_11_mR = p->rR * p->rR;
    const float C1_12_mR = p->rR * mu;
    const float K2_12_mR = p->rR * C1_12_IBxz;
    const float C1_12_IRyy = mu * t100;
    const float K2_12_IRyy = C1_12_IBxz * t100;
    const float t276 = t21 * mu;
    const float ITzz_xB = t71 + t71;
    const float M_22_xB = M_22_ITzz * ITzz_xB;
    const float t279 = t21 * C1_12_IBxz;
    const float t280 = p->mB * mu;
    const float C1_22_xB = (mu * t280) + (C1_22_ITzz * ITzz_xB);
    const float t284 = sin_lam * t280;
    const float K2_22_xB = C1_12_IBxz * t280;
    const float M_11_zB = t21 + t21;
    const float t287 = p->xB * mu;
    const float t288 = p->mB * t287;
    const float t290 = mu + (p->xB * C1_12_IBxz);
    const float t291 = p->mB * t290;
    const float t292 = p->mB * C1_12_IBxz;
    const float M_11_mB = p->zB * p->zB;
    const float t294 = p->zB * t287;
    const float ITzz_mB = p->xB * p->xB;
    const float M_22_mB = M_22_ITzz * ITzz_mB;
    const float t297 = p->zB * t290;
    const float C1_22_mB = (mu * t287) + (C1_22_ITzz * ITzz_mB);
    const float t301 = sin_lam * t287;
    const float t302 = p->zB * C1_12_IBxz;
    const float K2_22_mB = C1_12_IBxz * t287;
    const float t305 = t130 + (t6 * mu);
    const float t306 = t6 * sin_lam;
    const float t308 = cos_lam * t35;
    const float t311 = (p->xH * M_22_ITzz) - (t138 * t308);
    const float M_22_xH = (p->mH * t311) + (t62 * M_22_ITzz) - t147 - (t138 * t306);
    const float t317 = t6 * C1_12_IBxz;
    const float t319 = t168 + (p->mH * mu);
    const float t323 = (p->xH * C1_22_ITzz) - (C1_12_IBxz * t308);
    const float C1_22_xH = t167 + (mu * t319) + (p->mH * t323) + (t62 * C1_22_ITzz) - (C1_12_IBxz *
        t306);
    const float t331 = sin_lam * t319;
    const float K2_22_xH = C1_12_IBxz * t319;
    const float M_11_zH = t6 + t6;
    const float K0_12_mH = t308 + (p->zH * sin_lam) - (p->xH * mu);
    const float M_12_zH = t306 + (p->mH * K0_12_mH);
    const float t340 = p->xH * sin_lam;
    const float M_22_IHxx = sin_lam * sin_lam;
    const float t346 = (t140 * t308) + (p->zH * M_22_IHxx) - (t138 * t340);
    const float M_22_zH = (p->mH * t346) + (t6 * M_22_IHxx);
    const float t351 = mu + (p->xH * C1_12_IBxz);
    const float t352 = p->mH * t351;
    const float K0_12_zH = p->mH * sin_lam;
    const float t355 = C1_12_IBxz * t340;
    const float t357 = (mu * K0_12_zH) + (p->mH * t355);
    const float K0_22_zH = sin_lam * K0_12_zH;
    const float t359 = p->mH * C1_12_IBxz;
    const float t360 = C1_12_IBxz * K0_12_zH;
    const float M_11_mH = p->zH * p->zH;
    const float M_12_mH = p->zH * K0_12_mH;
    const float M_22_mH = (p->xH * t311) + (p->zH * t346) + (t35 * t142);
    const float t368 = p->zH * t351;
    const float C1_22_mH = (p->xH * t323) - (mu * K0_12_mH) - (p->zH * t355);
    const float K0_22_mH = sin_lam * K0_12_mH;
    const float t375 = p->zH * C1_12_IBxz;
    const float t376 = C1_12_IBxz * K0_12_mH;
    const float M_22_IHzz = t85 + M_22_ITzz + (cos_lam * t138);
    const float C1_22_IHzz = C1_22_ITzz + (cos_lam * C1_12_IBxz);
    const float M_12_IHxz = cos_lam + mu;
    const float t384 = t228 + (sin_lam * mu);
    const float M_22_IHxz = t384 + t384;
    const float K2_22_SF = sin_lam * C1_12_IBxz;
    const float M_11_rF = t10 + t10;
    const float t388 = p->rF * sin_lam;
    const float t389 = cos_lam * p->c;
    const float t391 = t389 - (p->w * mu);
    const float t392 = t388 - t391;
    const float M_12_rF = t149 + (p->mF * t392);
    const float t395 = p->w * sin_lam;
    const float t400 = (t138 * t395) + (p->rF * M_22_IHxx) - (t140 * t389);
    const float M_22_rF = (p->mF * t400) + (t10 * M_22_IHxx);
    const float C1_12_SF = mu + (p->w * C1_12_IBxz);
    const float t407 = t96 * SF;
    const float C1_12_rF = (p->mF * C1_12_SF) - (C1_12_SF * t407);
    const float C1_21_rF = M_12_IHxz * t407;
    const float t411 = p->mF * sin_lam;
    const float t413 = C1_12_IBxz * t395;
    const float C1_22_rF = (mu * t411) + (p->mF * t413);
    const float t416 = sin_lam * t411;
    const float K2_12_rF = C1_12_IBxz * (p->mF - t407);
    const float K2_22_rF = (C1_12_IBxz * t411) - (K2_22_SF * t407);
    const float M_11_mF = p->rF * p->rF;
    const float M_12_mF = p->rF * t392;
    const float ITzz_mF = p->w * p->w;
    const float M_22_mF = (p->c * t200) + (p->rF * t400) + (M_22_ITzz * ITzz_mF);
    const float C1_12_mF = p->rF * C1_12_SF;
    const float C1_22_mF = (mu * t392) + (p->rF * t413) + (C1_22_ITzz * ITzz_mF) - (p->c * t214);
    const float t438 = sin_lam * t392;
    const float K2_12_mF = p->rF * C1_12_IBxz;
    const float K2_22_mF = C1_12_IBxz * t392;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float C1_12_IFyy = t96 * C1_12_SF;
    const float t443 = t96 * M_12_IHxz;
    const float K2_12_IFyy = C1_12_IBxz * t96;
    const float K2_22_IFyy = t96 * K2_22_SF;
    const float C1_21 = -(t111 + (mu * ST));
    const float K0_11 = t104 - t103;
    const float K0_12_mF = t391 - t388;
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
    derivatives->values[2] = C1_12_w;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = K0_12_w;
    derivatives->values[6] = K0_22_w;
    derivatives->values[7] = t188;
    derivatives->values[8] = t191;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t208;
    derivatives->values[13] = C1_22_c;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t221;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t243;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = t259;
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
    derivatives->values[40] = t276;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t279;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = t280;
    derivatives->values[45] = t284;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t288;
    derivatives->values[49] = t291;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t292;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t294;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t297;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = t287;
    derivatives->values[59] = t301;
    derivatives->values[60] = t302;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = mu;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = t305;
    derivatives->values[65] = M_22_xH;
    derivatives->values[66] = t317;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = t319;
    derivatives->values[69] = t331;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = M_22_zH;
    derivatives->values[74] = t352;
    derivatives->values[75] = t357;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t359;
    derivatives->values[80] = t360;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = M_12_mH;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t368;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = K0_22_mH;
    derivatives->values[89] = t375;
    derivatives->values[90] = t376;
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
    derivatives->values[105] = t411;
    derivatives->values[106] = t416;
    derivatives->values[107] = K2_12_rF;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = M_12_mF;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = C1_22_mF;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = t438;
    derivatives->values[117] = K2_12_mF;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t443;
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
