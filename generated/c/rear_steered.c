/* @generated from generated/models/rear_steered.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 55b70df1229c7642
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * yaw_by_delta = c*cos(lam)/w [1]
 * yaw_per_v_delta = -cos(lam)/w [1/m]
 * Jxx_delta = IHxx + IFxx + zH^2*mH + rF^2*mF [kg*m^2]
 * Jxz_delta = c*rF*mF - zH*mH*(w + c - xH) - IHxz [kg*m^2]
 * Jzz_delta = mH*(w + c - xH)^2 + IHzz + IFxx + c^2*mF [kg*m^2]
 * Sx_delta = c*mF + mH*(w + c - xH) [kg*m]
 * Sz_delta = zH*mH - rF*mF [kg*m]
 * py_delta = Sx_delta*cos(lam) + Sz_delta*sin(lam) [kg*m]
 * hx_delta = Jxz_delta*cos(lam) - Jxx_delta*sin(lam) [kg*m^2]
 * hz_delta = Jzz_delta*cos(lam) - Jxz_delta*sin(lam) [kg*m^2]
 * Jxx_all = IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB [kg*m^2]
 * Jxz_all = xB*zB*mB + Jxz_delta + Sz_delta*(w + c) - IBxz [kg*m^2]
 * Jzz_all = IRxx + IBzz + IHzz + IFxx + w^2*mF + xB^2*mB + xH^2*mH [kg*m^2]
 * Sx_all = -(w*mF + xB*mB + xH*mH) [kg*m]
 * Sz_all = zB*mB + Sz_delta - rR*mR [kg*m]
 * load_spin_R = Sx_all/w [kg]
 * h_spin_F = IRyy/rR [kg*m]
 * h_spin_R = IFyy/rF [kg*m]
 * h_wheels_all = h_spin_F + h_spin_R [kg*m]
 * M_yaw_delta = hz_delta - py_delta*(w + c) [kg*m^2]
 * M_delta_delta = hz_delta*cos(lam) - hx_delta*sin(lam) [kg*m^2]
 * K_phi_delta = -(c*load_spin_R*cos(lam) + py_delta) [kg*m]
 * K_delta_delta = (c*load_spin_R*cos(lam) + py_delta)*sin(lam) [kg*m]
 * P_delta_lateral = yaw_by_delta*Sx_all + py_delta [kg*m]
 * P_delta_yaw = yaw_by_delta*Jzz_all + M_yaw_delta [kg*m^2]
 * P_delta_delta = yaw_by_delta*M_yaw_delta + M_delta_delta [kg*m^2]
 * M_11 = Jxx_all [kg*m^2]
 * M_12 = M_21 = yaw_by_delta*Jxz_all + hx_delta [kg*m^2]
 * M_22 = yaw_by_delta*P_delta_yaw + P_delta_delta [kg*m^2]
 * C1_12 = yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_R*cos(lam) [kg*m]
 * C1_21 = -(yaw_by_delta*h_wheels_all + h_spin_R*cos(lam)) [kg*m]
 * C1_22 = yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
 * K0_11 = Sz_all [kg*m]
 * K0_12 = K0_21 = K_phi_delta [kg*m]
 * K0_22 = K_delta_delta [kg*m]
 * K2_12 = yaw_per_v_delta*(h_wheels_all - Sz_all) [kg]
 * K2_22 = yaw_per_v_delta*(P_delta_lateral - h_spin_R*sin(lam)) [kg]
 * @endverbatim
 */

#include "rear_steered.h"

#include "carvallo_trig.h"

#include <float.h>

const char *rear_steered_set_name(rear_steered_set_t set)
{
    static const char *const TEXTS[] = {
        "backwards",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *rear_steered_validity_text(rear_steered_validity_t validity)
{
    static const char *const TEXTS[] = {
        "RearSteered: the parameters are valid",
        "RearSteered: w in m must be finite and > 0",
        "RearSteered: c in m must be finite",
        "RearSteered: lam in rad must be finite and > -1.5707963267948966 and < 1.5707963267948966",
        "RearSteered: g in N/kg must be finite and >= 0",
        "RearSteered: rR in m must be finite and > 0",
        "RearSteered: mR in kg must be finite and >= 0",
        "RearSteered: IRxx in kg*m^2 must be finite and >= 0",
        "RearSteered: IRyy in kg*m^2 must be finite and >= 0",
        "RearSteered: xB in m must be finite",
        "RearSteered: zB in m must be finite",
        "RearSteered: mB in kg must be finite and >= 0",
        "RearSteered: IBxx in kg*m^2 must be finite and >= 0",
        "RearSteered: IByy in kg*m^2 must be finite and >= 0",
        "RearSteered: IBzz in kg*m^2 must be finite and >= 0",
        "RearSteered: IBxz in kg*m^2 must be finite",
        "RearSteered: xH in m must be finite",
        "RearSteered: zH in m must be finite",
        "RearSteered: mH in kg must be finite and >= 0",
        "RearSteered: IHxx in kg*m^2 must be finite and >= 0",
        "RearSteered: IHyy in kg*m^2 must be finite and >= 0",
        "RearSteered: IHzz in kg*m^2 must be finite and >= 0",
        "RearSteered: IHxz in kg*m^2 must be finite",
        "RearSteered: rF in m must be finite and > 0",
        "RearSteered: mF in kg must be finite and >= 0",
        "RearSteered: IFxx in kg*m^2 must be finite and >= 0",
        "RearSteered: IFyy in kg*m^2 must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t rear_steered_partials[REAR_STEERED_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 51U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 51U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 59U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 43U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 19U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 65U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 52U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 52U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 55U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 46U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 56U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 20U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 20U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 60U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 45U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 21U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 58U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 67U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 67U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 70U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 71U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 73U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 73U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 74U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 53U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 22U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 72U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 76U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 76U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 80U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 54U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 75U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 17U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 4U, 88U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 4U, 84U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 1U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 4U, 82U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 13U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 31U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 0U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 5U, 23U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 86U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 6U, 85U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 7U, 83U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 7U, 83U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 7U, 24U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 8U, 30U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 8U, 30U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 8U, 97U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 8U, 25U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 8U, 99U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 8U, 91U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 8U, 91U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 8U, 92U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 87U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 14U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 44U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 44U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 9U, 98U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 3U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 9U, 66U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 12U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 10U, 94U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 10U, 94U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 10U, 95U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 10U, 101U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 10U, 90U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 10U, 2U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 10U, 93U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 10U, 93U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 10U, 96U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 10U, 100U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 10U, 89U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 11U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 13U, 86U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 13U, 85U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 14U, 29U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 14U, 29U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 14U, 18U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 15U, 34U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 15U, 34U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 81U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 26U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 48U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 61U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 61U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 62U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 103U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 16U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 39U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 39U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 78U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 63U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 64U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 5U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 68U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 68U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 106U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 47U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 69U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 10U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 42U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 42U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 40U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 108U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 50U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 32U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 32U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 41U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 107U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 49U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 18U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 18U, 9U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 18U, 9U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 18U, 104U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 20U, 109U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 20U, 102U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 21U, 33U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 21U, 33U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 21U, 79U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 21U, 18U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 21U, 57U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 22U, 15U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 22U, 27U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 22U, 27U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 77U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 22U, 35U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 22U, 112U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 22U, 114U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 22U, 7U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 22U, 113U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 22U, 113U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 22U, 115U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 36U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 22U, 37U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 23U, 11U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 117U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 117U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 105U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 38U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 118U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 6U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 116U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 116U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 119U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 28U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 120U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 9U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 9U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 110U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 102U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 111U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 111U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 121U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 122U, false}
};

const rear_steered_f64_t rear_steered_f64_sets[REAR_STEERED_SETS] = {
    { /* backwards */
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
    }
};

rear_steered_validity_t rear_steered_f64_validate(const rear_steered_f64_t *p)
{
    rear_steered_validity_t validity = REAR_STEERED_VALID;
    if (!((p->w > 0.0) && (p->w <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_w;
    } else if (!((p->c >= -DBL_MAX) && (p->c <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_c;
    } else if (!((p->lam > (-1.5707963267948966)) && (p->lam < 1.5707963267948966))) {
        validity = REAR_STEERED_INVALID_lam;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_g;
    } else if (!((p->rR > 0.0) && (p->rR <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_rR;
    } else if (!((p->mR >= 0.0) && (p->mR <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_mR;
    } else if (!((p->IRxx >= 0.0) && (p->IRxx <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0) && (p->IRyy <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_IRyy;
    } else if (!((p->xB >= -DBL_MAX) && (p->xB <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_xB;
    } else if (!((p->zB >= -DBL_MAX) && (p->zB <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_zB;
    } else if (!((p->mB >= 0.0) && (p->mB <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_mB;
    } else if (!((p->IBxx >= 0.0) && (p->IBxx <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0) && (p->IByy <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0) && (p->IBzz <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_IBzz;
    } else if (!((p->IBxz >= -DBL_MAX) && (p->IBxz <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_IBxz;
    } else if (!((p->xH >= -DBL_MAX) && (p->xH <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_xH;
    } else if (!((p->zH >= -DBL_MAX) && (p->zH <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_zH;
    } else if (!((p->mH >= 0.0) && (p->mH <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_mH;
    } else if (!((p->IHxx >= 0.0) && (p->IHxx <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0) && (p->IHyy <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0) && (p->IHzz <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_IHzz;
    } else if (!((p->IHxz >= -DBL_MAX) && (p->IHxz <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_IHxz;
    } else if (!((p->rF > 0.0) && (p->rF <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_rF;
    } else if (!((p->mF >= 0.0) && (p->mF <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_mF;
    } else if (!((p->IFxx >= 0.0) && (p->IFxx <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0) && (p->IFyy <= DBL_MAX))) {
        validity = REAR_STEERED_INVALID_IFyy;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void rear_steered_f64_matrices(const rear_steered_f64_t *p, rear_steered_f64_matrices_t *matrices)
{
    const double t2 = p->rR * p->mR;
    const double t6 = p->rF * p->mF;
    const double ay_all1_delta = (p->rF * t6) + (p->IHxx + p->IFxx);
    const double t15 = p->zB * p->mB;
    const double t19 = p->zH * p->mH;
    const double M_11 = (p->rR * t2) + ay_all1_delta + ((p->zB * t15) + ((p->zH * t19) + (p->IRxx +
        p->IBxx)));
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t31 = 1.0 / p->w;
    const double t32 = cos_lam * t31;
    const double yaw_by_delta = p->c * t32;
    const double t39 = (t15 * p->xB) - (p->IBxz + p->IHxz);
    const double wz_delta2_delta = cos_lam + yaw_by_delta;
    const double t50 = (cos_lam * (p->c + p->w)) - (p->xH * wz_delta2_delta);
    const double t51 = (p->zH * sin_lam) + t50;
    const double t54 = (t19 * t51) + (sin_lam * ay_all1_delta);
    const double t55 = sin_lam * p->IHxz;
    const double t59 = t55 + (wz_delta2_delta * (p->IFxx + p->IHzz));
    const double t63 = p->mB * p->xB;
    const double t68 = yaw_by_delta * ((p->xB * t63) + (p->IRxx + p->IBzz));
    const double t71 = p->mH * t51;
    const double M_22 = (wz_delta2_delta * (t55 + t59)) + ((sin_lam * t54) + (yaw_by_delta * t68) +
        (t71 * t50));
    const double K0_11 = t15 - (t2 + (t6 - t19));
    const double t85 = cos_lam * ((t31 * ((t19 * p->xH) + ((p->c * K0_11) + t39))) - t6);
    const double h_spin_R = p->IFyy / p->rF;
    const double t90 = p->IRyy / p->rR;
    const double t92 = (wz_delta2_delta * h_spin_R) + (yaw_by_delta * t90);
    const double C1_12 = t92 - t85;
    const double t94 = t6 * sin_lam;
    const double t96 = (yaw_by_delta * t63) + t94;
    const double t97 = t71 - t96;
    const double t104 = (t31 * ((p->c * t97) + ((p->xH * t71) - t68) - t59)) - t94;
    const double C1_22 = cos_lam * t104;
    const double K0_22 = sin_lam * t97;
    const double K2_12 = t32 * (K0_11 - t90 - h_spin_R);
    const double K2_22 = t32 * ((sin_lam * h_spin_R) - t97);
    const double M_12 = (yaw_by_delta * t39) - (cos_lam * p->IHxz) - t54;
    const double C1_21 = -t92;
    const double K0_12 = t96 - t71;
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
}

carvallo_system_error_t rear_steered_f64_at_speed(const rear_steered_f64_matrices_t *matrices,
    double speed, double gravity, rear_steered_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed) && carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < REAR_STEERED_N; row++) {
        for (size_t column = 0U; column < REAR_STEERED_N; column++) {
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

carvallo_system_error_t rear_steered_f64_state_space(const rear_steered_f64_system_t *system,
    rear_steered_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[REAR_STEERED_N * REAR_STEERED_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * REAR_STEERED_N * REAR_STEERED_N];
    for (size_t row = 0U; row < REAR_STEERED_N; row++) {
        double *const solved = &x[3U * REAR_STEERED_N * row];
        for (size_t column = 0U; column < REAR_STEERED_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * REAR_STEERED_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[REAR_STEERED_N + column] = -system->c[row][column];
            solved[(2U * REAR_STEERED_N) + column] = 0.0;
        }
        solved[(2U * REAR_STEERED_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[REAR_STEERED_N * REAR_STEERED_N];
        error = carvallo_solve_f64(REAR_STEERED_N, m, terms, 3U * REAR_STEERED_N, x);
    }
    for (size_t row = 0U; row < (2U * REAR_STEERED_N); row++) {
        for (size_t column = 0U; column < (2U * REAR_STEERED_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < REAR_STEERED_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < REAR_STEERED_N; row++) {
            const size_t target = REAR_STEERED_N + row;
            for (size_t column = 0U; column < (2U * REAR_STEERED_N); column++) {
                space->a[target][column] = x[(3U * REAR_STEERED_N * row) + column];
            }
            for (size_t column = 0U; column < REAR_STEERED_N; column++) {
                space->b[target][column] = x[(3U * REAR_STEERED_N * row) + (2U * REAR_STEERED_N) +
                    column];
            }
            space->a[row][REAR_STEERED_N + row] = 1.0;
        }
    }
    return error;
}

double rear_steered_f64_rate_at(const rear_steered_f64_rate_t *rate, double v,
    const double q[REAR_STEERED_N], const double q_dot[REAR_STEERED_N], double psi)
{
    double by_coordinates = 0.0;
    double by_rates = 0.0;
    for (size_t i = 0U; i < REAR_STEERED_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void rear_steered_f64_kinematics(const rear_steered_f64_t *p, rear_steered_f64_kinematics_t *kinematics)
{
    const double t6 = carvallo_cos_f64(p->lam) / p->w;
    const double yaw_by_delta = p->c * t6;
    const double t12 = -t6;
    const double t13 = -(1.0 / p->rR);
    const double t14 = -(1.0 / p->rF);
    kinematics->lateral.speed = 0.0;
    kinematics->lateral.rates[0] = 0.0;
    kinematics->lateral.rates[1] = 0.0;
    kinematics->lateral.coordinates[0] = 0.0;
    kinematics->lateral.coordinates[1] = 0.0;
    kinematics->lateral.heading = 1.0;
    kinematics->yaw.speed = 0.0;
    kinematics->yaw.rates[0] = 0.0;
    kinematics->yaw.rates[1] = yaw_by_delta;
    kinematics->yaw.coordinates[0] = 0.0;
    kinematics->yaw.coordinates[1] = t12;
    kinematics->yaw.heading = 0.0;
    kinematics->wheel_F.speed = t13;
    kinematics->wheel_F.rates[0] = 0.0;
    kinematics->wheel_F.rates[1] = 0.0;
    kinematics->wheel_F.coordinates[0] = 0.0;
    kinematics->wheel_F.coordinates[1] = 0.0;
    kinematics->wheel_F.heading = 0.0;
    kinematics->wheel_R.speed = t14;
    kinematics->wheel_R.rates[0] = 0.0;
    kinematics->wheel_R.rates[1] = 0.0;
    kinematics->wheel_R.coordinates[0] = 0.0;
    kinematics->wheel_R.coordinates[1] = 0.0;
    kinematics->wheel_R.heading = 0.0;
    kinematics->forces[0][0] = 1.0;
    kinematics->forces[0][1] = 0.0;
    kinematics->forces[1][0] = 0.0;
    kinematics->forces[1][1] = 1.0;
}

void rear_steered_f64_derivatives(const rear_steered_f64_t *p,
    rear_steered_f64_matrices_t *matrices, rear_steered_f64_derivatives_t *derivatives)
{
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double M_11_mH = p->zH * p->zH;
    const double ay_all1_delta_mF = p->rF * p->rF;
    const double t31 = p->IHxx + p->IFxx + (p->mF * ay_all1_delta_mF);
    const double M_11_mB = p->zB * p->zB;
    const double M_11_mR = p->rR * p->rR;
    const double t34 = p->mB * p->xB;
    const double t37 = (p->zB * t34) - p->IHxz - p->IBxz;
    const double M_11 = (p->mH * M_11_mH) + p->IRxx + p->IBxx + t31 + (p->mB * M_11_mB) + (p->mR *
        M_11_mR);
    const double t46 = 1.0 / p->w;
    const double t47 = p->IFxx + p->IHzz;
    const double t50 = p->IRxx + p->IBzz + (p->xB * t34);
    const double t51 = p->c * t46;
    const double t52 = 1.0 / p->rF;
    const double t53 = 1.0 / p->rR;
    const double t54 = p->mB * p->zB;
    const double M_11_zB = t54 + t54;
    const double t56 = p->mF * p->rF;
    const double ay_all1_delta_rF = t56 + t56;
    const double h_spin_R = p->IFyy * t52;
    const double t59 = p->IRyy * t53;
    const double t60 = p->mH * p->zH;
    const double M_11_zH = t60 + t60;
    const double t62 = p->xH * t51;
    const double t63 = p->mR * p->rR;
    const double M_11_rR = t63 + t63;
    const double K0_11 = t54 - (t56 + t63 - t60);
    const double t68 = h_spin_R + t59;
    const double t70 = t37 + (p->xH * t60);
    const double t73 = p->c + p->w - p->xH - t62;
    const double t74 = t56 + h_spin_R;
    const double t75 = p->c + p->xH;
    const double t76 = p->xB + p->c;
    const double t78 = p->mF - (t52 * h_spin_R);
    const double t79 = t51 * t68;
    const double t80 = t68 - K0_11;
    const double C1_12_IBxz = cos_lam * t46;
    const double t82 = p->zH * sin_lam;
    const double t83 = p->IHxz * cos_lam;
    const double t84 = p->IHxz * sin_lam;
    const double t85 = cos_lam * t74;
    const double t86 = sin_lam * t74;
    const double ay_all1_delta = sin_lam * t56;
    const double t88 = cos_lam * t56;
    const double t89 = h_spin_R + t79;
    const double t90 = p->mH * cos_lam;
    const double t92 = t70 - (p->c * t80);
    const double t93 = cos_lam + cos_lam;
    const double t94 = cos_lam * t60;
    const double C1_21_w = C1_12_IBxz * t79;
    const double M_12_c = (C1_12_IBxz * t70) - t94;
    const double t98 = C1_12_IBxz * t68;
    const double C1_21_lam = sin_lam * t89;
    const double C1_21 = -(cos_lam * t89);
    const double t102 = p->rR * C1_12_IBxz;
    const double t103 = C1_12_IBxz * t53;
    const double t104 = C1_12_IBxz * t54;
    const double t105 = t46 * t94;
    const double t106 = ay_all1_delta + ay_all1_delta;
    const double t107 = p->rF * C1_12_IBxz;
    const double yaw_by_delta = p->c * C1_12_IBxz;
    const double M_12_xB = yaw_by_delta * t54;
    const double C1_12_mR = p->rR * yaw_by_delta;
    const double t111 = t37 * yaw_by_delta;
    const double t113 = (cos_lam * t73) + t82;
    const double wz_delta2_delta = cos_lam + yaw_by_delta;
    const double M_12_xH = wz_delta2_delta * t60;
    const double C1_12_rF = wz_delta2_delta * t78;
    const double t117 = C1_12_IBxz * t78;
    const double K2_22_rF = sin_lam * t117;
    const double C1_12_mF = p->rF * wz_delta2_delta;
    const double t121 = t84 + (t47 * wz_delta2_delta);
    const double t123 = p->mH * (t82 + t113);
    const double M_22_mH = t113 * t113;
    const double K0_22_mH = sin_lam * t113;
    const double t126 = p->zH * t113;
    const double t127 = p->mH * t113;
    const double t128 = C1_12_IBxz * t92;
    const double C1_12 = t85 - t128;
    const double C1_12_w = t46 * t128;
    const double t134 = (t31 * sin_lam) + (p->mH * t126) + t83;
    const double t136 = t121 + (yaw_by_delta * t50);
    const double M_12_zB = t34 * yaw_by_delta;
    const double t140 = M_12_zB + (C1_12_IBxz * (t47 + t50));
    const double t141 = M_12_zB - t127;
    const double K0_12 = ay_all1_delta + t141;
    const double t144 = t46 * (t141 + t86);
    const double C1_12_c = C1_12_IBxz * t80;
    const double K2_12_w = t46 * C1_12_c;
    const double K2_12 = -C1_12_c;
    const double K2_12_zH = p->mH * C1_12_IBxz;
    const double t150 = (t62 * K2_12_zH) + t90;
    const double t153 = K2_12_zH * ((wz_delta2_delta * t75) - t113);
    const double t154 = C1_12_IBxz * t113;
    const double C1_22_mH = t75 * t154;
    const double t159 = t121 + (t73 * t127) + (t51 * t136);
    const double t162 = t46 * (t136 - (p->xH * t127));
    const double M_12 = t111 - t134;
    const double t166 = (p->zH * t150) + (t46 * t111);
    const double t168 = t134 + (t51 * t83);
    const double K2_22 = cos_lam * t144;
    const double t171 = t150 + (t46 * M_12_zB);
    const double t172 = t46 * sin_lam;
    const double C1_12_lam = (t92 * t172) - t86;
    const double K2_12_lam = t80 * t172;
    const double K0_22_w = sin_lam * t171;
    const double t178 = C1_12_IBxz * (t144 + t171);
    const double K2_22_h_spin_R = cos_lam * t172;
    const double t180 = p->c * t172;
    const double K0_22 = -(sin_lam * K0_12);
    const double t183 = t51 * t140;
    const double t185 = t90 - (p->xH * K2_12_zH);
    const double C1_22_c = C1_12_IBxz * ((t75 * t185) - K0_12 - t140);
    const double M_22 = (cos_lam * t159) + (sin_lam * t168);
    const double t195 = ((t51 * t162) - t127) * t93;
    const double M_22_c = t93 * (t127 + t162);
    const double t199 = t162 + (t51 * K0_12);
    const double K0_12_xH = t90 + (t51 * t90);
    const double t202 = sin_lam * K0_12_xH;
    const double t203 = K2_12_zH * t75;
    const double C1_22_zH = sin_lam * t203;
    const double C1_22_w = C1_12_IBxz * (t199 + (t150 * t75) + t183);
    const double t209 = ay_all1_delta + t199;
    const double K2_12_zB = p->mB * C1_12_IBxz;
    const double t211 = p->xB * K2_12_zB;
    const double K0_12_c = t211 - t185;
    const double t213 = t185 - t211;
    const double t214 = p->mH * sin_lam;
    const double M_22_yaw_by_delta = t94 - (t73 * t214);
    const double t217 = C1_12_IBxz * t214;
    const double K0_22_c = sin_lam * t213;
    const double t219 = C1_12_IBxz * t213;
    const double C1_22 = -(cos_lam * t209);
    const double C1_22_lam = (sin_lam * (t209 + t183 + (C1_12_IBxz * t47))) + (C1_12_IBxz * ((t75 *
        M_22_yaw_by_delta) - t83)) - (wz_delta2_delta * t88);
    const double M_12_lam = t84 - (t31 * cos_lam) - (t37 * t180) - (p->zH * M_22_yaw_by_delta);
    const double t239 = M_22_yaw_by_delta + (t34 * t180);
    const double t240 = sin_lam + sin_lam;
    const double M_22_lam = (t168 * t93) - (t159 * t240);
    const double t247 = (sin_lam * t144) + (C1_12_IBxz * (t239 - t85));
    const double K0_12_lam = t88 - t239;
    const double M_22_rF = ay_all1_delta * t240;
    const double M_22_zH = t127 * t240;
    const double M_22_IHxz = wz_delta2_delta * t240;
    const double K0_22_lam = -((cos_lam * K0_12) + (sin_lam * K0_12_lam));
    const double t256 = wz_delta2_delta * t127;
    const double t257 = t256 + t256;
    const double t260 = C1_12_IBxz * (p->mR - (t53 * t59));
    const double C1_12_IRyy = yaw_by_delta * t53;
    const double C1_21_rR = t59 * C1_12_IRyy;
    const double t263 = C1_12_IBxz * yaw_by_delta;
    const double M_22_IRxx = p->c * t263;
    const double K2_22_xB = p->mB * t263;
    const double C1_12_rR = p->c * t260;
    const double K2_22_mB = p->xB * t263;
    const double t268 = t76 * K2_22_mB;
    const double K0_12_xB = p->mB * yaw_by_delta;
    const double t270 = sin_lam * K0_12_xB;
    const double K0_12_mB = p->xB * yaw_by_delta;
    const double M_12_mB = p->zB * K0_12_mB;
    const double M_22_mB = K0_12_mB * K0_12_mB;
    const double t274 = sin_lam * K0_12_mB;
    const double t275 = K0_12_xB * K0_12_mB;
    const double M_22_xB = t275 + t275;
    const double t277 = t211 + K0_12_xB;
    const double t279 = yaw_by_delta * (t211 + t277);
    const double K2_12_mB = p->zB * C1_12_IBxz;
    const double t281 = t76 * K2_12_mB;
    const double t282 = C1_12_IBxz * wz_delta2_delta;
    const double K2_22_xH = p->mH * t282;
    const double M_22_ay_all1_delta = sin_lam * sin_lam;
    const double M_22_mF = ay_all1_delta_mF * M_22_ay_all1_delta;
    const double K0_22_zH = p->mH * M_22_ay_all1_delta;
    const double K2_12_mH = p->zH * C1_12_IBxz;
    const double t288 = t75 * K2_12_mH;
    const double M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const double M_22_IFxx = M_22_ay_all1_delta + M_22_IHzz;
    const double C1_12_IFyy = wz_delta2_delta * t52;
    const double C1_21_rF = h_spin_R * C1_12_IFyy;
    const double K0_12_rF = p->mF * sin_lam;
    const double t294 = wz_delta2_delta * K0_12_rF;
    const double t295 = sin_lam * K0_12_rF;
    const double K0_12_mF = p->rF * sin_lam;
    const double t297 = p->rF * K0_12_mF;
    const double t298 = wz_delta2_delta * K0_12_mF;
    const double t299 = sin_lam * K0_12_mF;
    const double K2_22_mF = C1_12_IBxz * K0_12_mF;
    const double t301 = C1_12_IBxz * t52;
    const double K2_22_IFyy = sin_lam * t301;
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
    derivatives->values[10] = M_11_mH;
    derivatives->values[11] = ay_all1_delta_mF;
    derivatives->values[12] = M_11_mB;
    derivatives->values[13] = M_11_mR;
    derivatives->values[14] = M_11_zB;
    derivatives->values[15] = ay_all1_delta_rF;
    derivatives->values[16] = M_11_zH;
    derivatives->values[17] = M_11_rR;
    derivatives->values[18] = C1_12_IBxz;
    derivatives->values[19] = C1_21_w;
    derivatives->values[20] = M_12_c;
    derivatives->values[21] = t98;
    derivatives->values[22] = C1_21_lam;
    derivatives->values[23] = t102;
    derivatives->values[24] = t103;
    derivatives->values[25] = t104;
    derivatives->values[26] = t105;
    derivatives->values[27] = t106;
    derivatives->values[28] = t107;
    derivatives->values[29] = yaw_by_delta;
    derivatives->values[30] = M_12_xB;
    derivatives->values[31] = C1_12_mR;
    derivatives->values[32] = t113;
    derivatives->values[33] = wz_delta2_delta;
    derivatives->values[34] = M_12_xH;
    derivatives->values[35] = C1_12_rF;
    derivatives->values[36] = t117;
    derivatives->values[37] = K2_22_rF;
    derivatives->values[38] = C1_12_mF;
    derivatives->values[39] = t123;
    derivatives->values[40] = M_22_mH;
    derivatives->values[41] = K0_22_mH;
    derivatives->values[42] = t126;
    derivatives->values[43] = C1_12_w;
    derivatives->values[44] = M_12_zB;
    derivatives->values[45] = C1_12_c;
    derivatives->values[46] = K2_12_w;
    derivatives->values[47] = K2_12_zH;
    derivatives->values[48] = t153;
    derivatives->values[49] = t154;
    derivatives->values[50] = C1_22_mH;
    derivatives->values[51] = t166;
    derivatives->values[52] = t171;
    derivatives->values[53] = C1_12_lam;
    derivatives->values[54] = K2_12_lam;
    derivatives->values[55] = K0_22_w;
    derivatives->values[56] = t178;
    derivatives->values[57] = K2_22_h_spin_R;
    derivatives->values[58] = C1_22_c;
    derivatives->values[59] = t195;
    derivatives->values[60] = M_22_c;
    derivatives->values[61] = K0_12_xH;
    derivatives->values[62] = t202;
    derivatives->values[63] = t203;
    derivatives->values[64] = C1_22_zH;
    derivatives->values[65] = C1_22_w;
    derivatives->values[66] = K2_12_zB;
    derivatives->values[67] = K0_12_c;
    derivatives->values[68] = t214;
    derivatives->values[69] = t217;
    derivatives->values[70] = K0_22_c;
    derivatives->values[71] = t219;
    derivatives->values[72] = C1_22_lam;
    derivatives->values[73] = M_12_lam;
    derivatives->values[74] = M_22_lam;
    derivatives->values[75] = t247;
    derivatives->values[76] = K0_12_lam;
    derivatives->values[77] = M_22_rF;
    derivatives->values[78] = M_22_zH;
    derivatives->values[79] = M_22_IHxz;
    derivatives->values[80] = K0_22_lam;
    derivatives->values[81] = t257;
    derivatives->values[82] = t260;
    derivatives->values[83] = C1_12_IRyy;
    derivatives->values[84] = C1_21_rR;
    derivatives->values[85] = t263;
    derivatives->values[86] = M_22_IRxx;
    derivatives->values[87] = K2_22_xB;
    derivatives->values[88] = C1_12_rR;
    derivatives->values[89] = K2_22_mB;
    derivatives->values[90] = t268;
    derivatives->values[91] = K0_12_xB;
    derivatives->values[92] = t270;
    derivatives->values[93] = K0_12_mB;
    derivatives->values[94] = M_12_mB;
    derivatives->values[95] = M_22_mB;
    derivatives->values[96] = t274;
    derivatives->values[97] = M_22_xB;
    derivatives->values[98] = t277;
    derivatives->values[99] = t279;
    derivatives->values[100] = K2_12_mB;
    derivatives->values[101] = t281;
    derivatives->values[102] = t282;
    derivatives->values[103] = K2_22_xH;
    derivatives->values[104] = M_22_ay_all1_delta;
    derivatives->values[105] = M_22_mF;
    derivatives->values[106] = K0_22_zH;
    derivatives->values[107] = K2_12_mH;
    derivatives->values[108] = t288;
    derivatives->values[109] = M_22_IHzz;
    derivatives->values[110] = M_22_IFxx;
    derivatives->values[111] = C1_12_IFyy;
    derivatives->values[112] = C1_21_rF;
    derivatives->values[113] = K0_12_rF;
    derivatives->values[114] = t294;
    derivatives->values[115] = t295;
    derivatives->values[116] = K0_12_mF;
    derivatives->values[117] = t297;
    derivatives->values[118] = t298;
    derivatives->values[119] = t299;
    derivatives->values[120] = K2_22_mF;
    derivatives->values[121] = t301;
    derivatives->values[122] = K2_22_IFyy;
}

void rear_steered_f64_with_respect_to(const rear_steered_f64_derivatives_t *derivatives,
    size_t parameter, rear_steered_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < REAR_STEERED_N; row++) {
        for (size_t column = 0U; column < REAR_STEERED_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
            matrices->k2[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < REAR_STEERED_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &rear_steered_partials[position];
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

const rear_steered_f32_t rear_steered_f32_sets[REAR_STEERED_SETS] = {
    { /* backwards */
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
    }
};

rear_steered_validity_t rear_steered_f32_validate(const rear_steered_f32_t *p)
{
    rear_steered_validity_t validity = REAR_STEERED_VALID;
    if (!((p->w > 0.0F) && (p->w <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_w;
    } else if (!((p->c >= -FLT_MAX) && (p->c <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_c;
    } else if (!((p->lam > (-1.5707964F)) && (p->lam < 1.5707964F))) {
        validity = REAR_STEERED_INVALID_lam;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_g;
    } else if (!((p->rR > 0.0F) && (p->rR <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_rR;
    } else if (!((p->mR >= 0.0F) && (p->mR <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_mR;
    } else if (!((p->IRxx >= 0.0F) && (p->IRxx <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0F) && (p->IRyy <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_IRyy;
    } else if (!((p->xB >= -FLT_MAX) && (p->xB <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_xB;
    } else if (!((p->zB >= -FLT_MAX) && (p->zB <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_zB;
    } else if (!((p->mB >= 0.0F) && (p->mB <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_mB;
    } else if (!((p->IBxx >= 0.0F) && (p->IBxx <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0F) && (p->IByy <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0F) && (p->IBzz <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_IBzz;
    } else if (!((p->IBxz >= -FLT_MAX) && (p->IBxz <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_IBxz;
    } else if (!((p->xH >= -FLT_MAX) && (p->xH <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_xH;
    } else if (!((p->zH >= -FLT_MAX) && (p->zH <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_zH;
    } else if (!((p->mH >= 0.0F) && (p->mH <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_mH;
    } else if (!((p->IHxx >= 0.0F) && (p->IHxx <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0F) && (p->IHyy <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0F) && (p->IHzz <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_IHzz;
    } else if (!((p->IHxz >= -FLT_MAX) && (p->IHxz <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_IHxz;
    } else if (!((p->rF > 0.0F) && (p->rF <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_rF;
    } else if (!((p->mF >= 0.0F) && (p->mF <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_mF;
    } else if (!((p->IFxx >= 0.0F) && (p->IFxx <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0F) && (p->IFyy <= FLT_MAX))) {
        validity = REAR_STEERED_INVALID_IFyy;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void rear_steered_f32_matrices(const rear_steered_f32_t *p, rear_steered_f32_matrices_t *matrices)
{
    const float t2 = p->rR * p->mR;
    const float t6 = p->rF * p->mF;
    const float ay_all1_delta = (p->rF * t6) + (p->IHxx + p->IFxx);
    const float t15 = p->zB * p->mB;
    const float t19 = p->zH * p->mH;
    const float M_11 = (p->rR * t2) + ay_all1_delta + ((p->zB * t15) + ((p->zH * t19) + (p->IRxx +
        p->IBxx)));
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t31 = 1.0F / p->w;
    const float t32 = cos_lam * t31;
    const float yaw_by_delta = p->c * t32;
    const float t39 = (t15 * p->xB) - (p->IBxz + p->IHxz);
    const float wz_delta2_delta = cos_lam + yaw_by_delta;
    const float t50 = (cos_lam * (p->c + p->w)) - (p->xH * wz_delta2_delta);
    const float t51 = (p->zH * sin_lam) + t50;
    const float t54 = (t19 * t51) + (sin_lam * ay_all1_delta);
    const float t55 = sin_lam * p->IHxz;
    const float t59 = t55 + (wz_delta2_delta * (p->IFxx + p->IHzz));
    const float t63 = p->mB * p->xB;
    const float t68 = yaw_by_delta * ((p->xB * t63) + (p->IRxx + p->IBzz));
    const float t71 = p->mH * t51;
    const float M_22 = (wz_delta2_delta * (t55 + t59)) + ((sin_lam * t54) + (yaw_by_delta * t68) +
        (t71 * t50));
    const float K0_11 = t15 - (t2 + (t6 - t19));
    const float t85 = cos_lam * ((t31 * ((t19 * p->xH) + ((p->c * K0_11) + t39))) - t6);
    const float h_spin_R = p->IFyy / p->rF;
    const float t90 = p->IRyy / p->rR;
    const float t92 = (wz_delta2_delta * h_spin_R) + (yaw_by_delta * t90);
    const float C1_12 = t92 - t85;
    const float t94 = t6 * sin_lam;
    const float t96 = (yaw_by_delta * t63) + t94;
    const float t97 = t71 - t96;
    const float t104 = (t31 * ((p->c * t97) + ((p->xH * t71) - t68) - t59)) - t94;
    const float C1_22 = cos_lam * t104;
    const float K0_22 = sin_lam * t97;
    const float K2_12 = t32 * (K0_11 - t90 - h_spin_R);
    const float K2_22 = t32 * ((sin_lam * h_spin_R) - t97);
    const float M_12 = (yaw_by_delta * t39) - (cos_lam * p->IHxz) - t54;
    const float C1_21 = -t92;
    const float K0_12 = t96 - t71;
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
}

carvallo_system_error_t rear_steered_f32_at_speed(const rear_steered_f32_matrices_t *matrices,
    float speed, float gravity, rear_steered_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed) && carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < REAR_STEERED_N; row++) {
        for (size_t column = 0U; column < REAR_STEERED_N; column++) {
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

carvallo_system_error_t rear_steered_f32_state_space(const rear_steered_f32_system_t *system,
    rear_steered_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[REAR_STEERED_N * REAR_STEERED_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * REAR_STEERED_N * REAR_STEERED_N];
    for (size_t row = 0U; row < REAR_STEERED_N; row++) {
        float *const solved = &x[3U * REAR_STEERED_N * row];
        for (size_t column = 0U; column < REAR_STEERED_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * REAR_STEERED_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[REAR_STEERED_N + column] = -system->c[row][column];
            solved[(2U * REAR_STEERED_N) + column] = 0.0F;
        }
        solved[(2U * REAR_STEERED_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[REAR_STEERED_N * REAR_STEERED_N];
        error = carvallo_solve_f32(REAR_STEERED_N, m, terms, 3U * REAR_STEERED_N, x);
    }
    for (size_t row = 0U; row < (2U * REAR_STEERED_N); row++) {
        for (size_t column = 0U; column < (2U * REAR_STEERED_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < REAR_STEERED_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < REAR_STEERED_N; row++) {
            const size_t target = REAR_STEERED_N + row;
            for (size_t column = 0U; column < (2U * REAR_STEERED_N); column++) {
                space->a[target][column] = x[(3U * REAR_STEERED_N * row) + column];
            }
            for (size_t column = 0U; column < REAR_STEERED_N; column++) {
                space->b[target][column] = x[(3U * REAR_STEERED_N * row) + (2U * REAR_STEERED_N) +
                    column];
            }
            space->a[row][REAR_STEERED_N + row] = 1.0F;
        }
    }
    return error;
}

float rear_steered_f32_rate_at(const rear_steered_f32_rate_t *rate, float v,
    const float q[REAR_STEERED_N], const float q_dot[REAR_STEERED_N], float psi)
{
    float by_coordinates = 0.0F;
    float by_rates = 0.0F;
    for (size_t i = 0U; i < REAR_STEERED_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void rear_steered_f32_kinematics(const rear_steered_f32_t *p, rear_steered_f32_kinematics_t *kinematics)
{
    const float t6 = carvallo_cos_f32(p->lam) / p->w;
    const float yaw_by_delta = p->c * t6;
    const float t12 = -t6;
    const float t13 = -(1.0F / p->rR);
    const float t14 = -(1.0F / p->rF);
    kinematics->lateral.speed = 0.0F;
    kinematics->lateral.rates[0] = 0.0F;
    kinematics->lateral.rates[1] = 0.0F;
    kinematics->lateral.coordinates[0] = 0.0F;
    kinematics->lateral.coordinates[1] = 0.0F;
    kinematics->lateral.heading = 1.0F;
    kinematics->yaw.speed = 0.0F;
    kinematics->yaw.rates[0] = 0.0F;
    kinematics->yaw.rates[1] = yaw_by_delta;
    kinematics->yaw.coordinates[0] = 0.0F;
    kinematics->yaw.coordinates[1] = t12;
    kinematics->yaw.heading = 0.0F;
    kinematics->wheel_F.speed = t13;
    kinematics->wheel_F.rates[0] = 0.0F;
    kinematics->wheel_F.rates[1] = 0.0F;
    kinematics->wheel_F.coordinates[0] = 0.0F;
    kinematics->wheel_F.coordinates[1] = 0.0F;
    kinematics->wheel_F.heading = 0.0F;
    kinematics->wheel_R.speed = t14;
    kinematics->wheel_R.rates[0] = 0.0F;
    kinematics->wheel_R.rates[1] = 0.0F;
    kinematics->wheel_R.coordinates[0] = 0.0F;
    kinematics->wheel_R.coordinates[1] = 0.0F;
    kinematics->wheel_R.heading = 0.0F;
    kinematics->forces[0][0] = 1.0F;
    kinematics->forces[0][1] = 0.0F;
    kinematics->forces[1][0] = 0.0F;
    kinematics->forces[1][1] = 1.0F;
}

void rear_steered_f32_derivatives(const rear_steered_f32_t *p,
    rear_steered_f32_matrices_t *matrices, rear_steered_f32_derivatives_t *derivatives)
{
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float M_11_mH = p->zH * p->zH;
    const float ay_all1_delta_mF = p->rF * p->rF;
    const float t31 = p->IHxx + p->IFxx + (p->mF * ay_all1_delta_mF);
    const float M_11_mB = p->zB * p->zB;
    const float M_11_mR = p->rR * p->rR;
    const float t34 = p->mB * p->xB;
    const float t37 = (p->zB * t34) - p->IHxz - p->IBxz;
    const float M_11 = (p->mH * M_11_mH) + p->IRxx + p->IBxx + t31 + (p->mB * M_11_mB) + (p->mR *
        M_11_mR);
    const float t46 = 1.0F / p->w;
    const float t47 = p->IFxx + p->IHzz;
    const float t50 = p->IRxx + p->IBzz + (p->xB * t34);
    const float t51 = p->c * t46;
    const float t52 = 1.0F / p->rF;
    const float t53 = 1.0F / p->rR;
    const float t54 = p->mB * p->zB;
    const float M_11_zB = t54 + t54;
    const float t56 = p->mF * p->rF;
    const float ay_all1_delta_rF = t56 + t56;
    const float h_spin_R = p->IFyy * t52;
    const float t59 = p->IRyy * t53;
    const float t60 = p->mH * p->zH;
    const float M_11_zH = t60 + t60;
    const float t62 = p->xH * t51;
    const float t63 = p->mR * p->rR;
    const float M_11_rR = t63 + t63;
    const float K0_11 = t54 - (t56 + t63 - t60);
    const float t68 = h_spin_R + t59;
    const float t70 = t37 + (p->xH * t60);
    const float t73 = p->c + p->w - p->xH - t62;
    const float t74 = t56 + h_spin_R;
    const float t75 = p->c + p->xH;
    const float t76 = p->xB + p->c;
    const float t78 = p->mF - (t52 * h_spin_R);
    const float t79 = t51 * t68;
    const float t80 = t68 - K0_11;
    const float C1_12_IBxz = cos_lam * t46;
    const float t82 = p->zH * sin_lam;
    const float t83 = p->IHxz * cos_lam;
    const float t84 = p->IHxz * sin_lam;
    const float t85 = cos_lam * t74;
    const float t86 = sin_lam * t74;
    const float ay_all1_delta = sin_lam * t56;
    const float t88 = cos_lam * t56;
    const float t89 = h_spin_R + t79;
    const float t90 = p->mH * cos_lam;
    const float t92 = t70 - (p->c * t80);
    const float t93 = cos_lam + cos_lam;
    const float t94 = cos_lam * t60;
    const float C1_21_w = C1_12_IBxz * t79;
    const float M_12_c = (C1_12_IBxz * t70) - t94;
    const float t98 = C1_12_IBxz * t68;
    const float C1_21_lam = sin_lam * t89;
    const float C1_21 = -(cos_lam * t89);
    const float t102 = p->rR * C1_12_IBxz;
    const float t103 = C1_12_IBxz * t53;
    const float t104 = C1_12_IBxz * t54;
    const float t105 = t46 * t94;
    const float t106 = ay_all1_delta + ay_all1_delta;
    const float t107 = p->rF * C1_12_IBxz;
    const float yaw_by_delta = p->c * C1_12_IBxz;
    const float M_12_xB = yaw_by_delta * t54;
    const float C1_12_mR = p->rR * yaw_by_delta;
    const float t111 = t37 * yaw_by_delta;
    const float t113 = (cos_lam * t73) + t82;
    const float wz_delta2_delta = cos_lam + yaw_by_delta;
    const float M_12_xH = wz_delta2_delta * t60;
    const float C1_12_rF = wz_delta2_delta * t78;
    const float t117 = C1_12_IBxz * t78;
    const float K2_22_rF = sin_lam * t117;
    const float C1_12_mF = p->rF * wz_delta2_delta;
    const float t121 = t84 + (t47 * wz_delta2_delta);
    const float t123 = p->mH * (t82 + t113);
    const float M_22_mH = t113 * t113;
    const float K0_22_mH = sin_lam * t113;
    const float t126 = p->zH * t113;
    const float t127 = p->mH * t113;
    const float t128 = C1_12_IBxz * t92;
    const float C1_12 = t85 - t128;
    const float C1_12_w = t46 * t128;
    const float t134 = (t31 * sin_lam) + (p->mH * t126) + t83;
    const float t136 = t121 + (yaw_by_delta * t50);
    const float M_12_zB = t34 * yaw_by_delta;
    const float t140 = M_12_zB + (C1_12_IBxz * (t47 + t50));
    const float t141 = M_12_zB - t127;
    const float K0_12 = ay_all1_delta + t141;
    const float t144 = t46 * (t141 + t86);
    const float C1_12_c = C1_12_IBxz * t80;
    const float K2_12_w = t46 * C1_12_c;
    const float K2_12 = -C1_12_c;
    const float K2_12_zH = p->mH * C1_12_IBxz;
    const float t150 = (t62 * K2_12_zH) + t90;
    const float t153 = K2_12_zH * ((wz_delta2_delta * t75) - t113);
    const float t154 = C1_12_IBxz * t113;
    const float C1_22_mH = t75 * t154;
    const float t159 = t121 + (t73 * t127) + (t51 * t136);
    const float t162 = t46 * (t136 - (p->xH * t127));
    const float M_12 = t111 - t134;
    const float t166 = (p->zH * t150) + (t46 * t111);
    const float t168 = t134 + (t51 * t83);
    const float K2_22 = cos_lam * t144;
    const float t171 = t150 + (t46 * M_12_zB);
    const float t172 = t46 * sin_lam;
    const float C1_12_lam = (t92 * t172) - t86;
    const float K2_12_lam = t80 * t172;
    const float K0_22_w = sin_lam * t171;
    const float t178 = C1_12_IBxz * (t144 + t171);
    const float K2_22_h_spin_R = cos_lam * t172;
    const float t180 = p->c * t172;
    const float K0_22 = -(sin_lam * K0_12);
    const float t183 = t51 * t140;
    const float t185 = t90 - (p->xH * K2_12_zH);
    const float C1_22_c = C1_12_IBxz * ((t75 * t185) - K0_12 - t140);
    const float M_22 = (cos_lam * t159) + (sin_lam * t168);
    const float t195 = ((t51 * t162) - t127) * t93;
    const float M_22_c = t93 * (t127 + t162);
    const float t199 = t162 + (t51 * K0_12);
    const float K0_12_xH = t90 + (t51 * t90);
    const float t202 = sin_lam * K0_12_xH;
    const float t203 = K2_12_zH * t75;
    const float C1_22_zH = sin_lam * t203;
    const float C1_22_w = C1_12_IBxz * (t199 + (t150 * t75) + t183);
    const float t209 = ay_all1_delta + t199;
    const float K2_12_zB = p->mB * C1_12_IBxz;
    const float t211 = p->xB * K2_12_zB;
    const float K0_12_c = t211 - t185;
    const float t213 = t185 - t211;
    const float t214 = p->mH * sin_lam;
    const float M_22_yaw_by_delta = t94 - (t73 * t214);
    const float t217 = C1_12_IBxz * t214;
    const float K0_22_c = sin_lam * t213;
    const float t219 = C1_12_IBxz * t213;
    const float C1_22 = -(cos_lam * t209);
    const float C1_22_lam = (sin_lam * (t209 + t183 + (C1_12_IBxz * t47))) + (C1_12_IBxz * ((t75 *
        M_22_yaw_by_delta) - t83)) - (wz_delta2_delta * t88);
    const float M_12_lam = t84 - (t31 * cos_lam) - (t37 * t180) - (p->zH * M_22_yaw_by_delta);
    const float t239 = M_22_yaw_by_delta + (t34 * t180);
    const float t240 = sin_lam + sin_lam;
    const float M_22_lam = (t168 * t93) - (t159 * t240);
    const float t247 = (sin_lam * t144) + (C1_12_IBxz * (t239 - t85));
    const float K0_12_lam = t88 - t239;
    const float M_22_rF = ay_all1_delta * t240;
    const float M_22_zH = t127 * t240;
    const float M_22_IHxz = wz_delta2_delta * t240;
    const float K0_22_lam = -((cos_lam * K0_12) + (sin_lam * K0_12_lam));
    const float t256 = wz_delta2_delta * t127;
    const float t257 = t256 + t256;
    const float t260 = C1_12_IBxz * (p->mR - (t53 * t59));
    const float C1_12_IRyy = yaw_by_delta * t53;
    const float C1_21_rR = t59 * C1_12_IRyy;
    const float t263 = C1_12_IBxz * yaw_by_delta;
    const float M_22_IRxx = p->c * t263;
    const float K2_22_xB = p->mB * t263;
    const float C1_12_rR = p->c * t260;
    const float K2_22_mB = p->xB * t263;
    const float t268 = t76 * K2_22_mB;
    const float K0_12_xB = p->mB * yaw_by_delta;
    const float t270 = sin_lam * K0_12_xB;
    const float K0_12_mB = p->xB * yaw_by_delta;
    const float M_12_mB = p->zB * K0_12_mB;
    const float M_22_mB = K0_12_mB * K0_12_mB;
    const float t274 = sin_lam * K0_12_mB;
    const float t275 = K0_12_xB * K0_12_mB;
    const float M_22_xB = t275 + t275;
    const float t277 = t211 + K0_12_xB;
    const float t279 = yaw_by_delta * (t211 + t277);
    const float K2_12_mB = p->zB * C1_12_IBxz;
    const float t281 = t76 * K2_12_mB;
    const float t282 = C1_12_IBxz * wz_delta2_delta;
    const float K2_22_xH = p->mH * t282;
    const float M_22_ay_all1_delta = sin_lam * sin_lam;
    const float M_22_mF = ay_all1_delta_mF * M_22_ay_all1_delta;
    const float K0_22_zH = p->mH * M_22_ay_all1_delta;
    const float K2_12_mH = p->zH * C1_12_IBxz;
    const float t288 = t75 * K2_12_mH;
    const float M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const float M_22_IFxx = M_22_ay_all1_delta + M_22_IHzz;
    const float C1_12_IFyy = wz_delta2_delta * t52;
    const float C1_21_rF = h_spin_R * C1_12_IFyy;
    const float K0_12_rF = p->mF * sin_lam;
    const float t294 = wz_delta2_delta * K0_12_rF;
    const float t295 = sin_lam * K0_12_rF;
    const float K0_12_mF = p->rF * sin_lam;
    const float t297 = p->rF * K0_12_mF;
    const float t298 = wz_delta2_delta * K0_12_mF;
    const float t299 = sin_lam * K0_12_mF;
    const float K2_22_mF = C1_12_IBxz * K0_12_mF;
    const float t301 = C1_12_IBxz * t52;
    const float K2_22_IFyy = sin_lam * t301;
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
    derivatives->values[10] = M_11_mH;
    derivatives->values[11] = ay_all1_delta_mF;
    derivatives->values[12] = M_11_mB;
    derivatives->values[13] = M_11_mR;
    derivatives->values[14] = M_11_zB;
    derivatives->values[15] = ay_all1_delta_rF;
    derivatives->values[16] = M_11_zH;
    derivatives->values[17] = M_11_rR;
    derivatives->values[18] = C1_12_IBxz;
    derivatives->values[19] = C1_21_w;
    derivatives->values[20] = M_12_c;
    derivatives->values[21] = t98;
    derivatives->values[22] = C1_21_lam;
    derivatives->values[23] = t102;
    derivatives->values[24] = t103;
    derivatives->values[25] = t104;
    derivatives->values[26] = t105;
    derivatives->values[27] = t106;
    derivatives->values[28] = t107;
    derivatives->values[29] = yaw_by_delta;
    derivatives->values[30] = M_12_xB;
    derivatives->values[31] = C1_12_mR;
    derivatives->values[32] = t113;
    derivatives->values[33] = wz_delta2_delta;
    derivatives->values[34] = M_12_xH;
    derivatives->values[35] = C1_12_rF;
    derivatives->values[36] = t117;
    derivatives->values[37] = K2_22_rF;
    derivatives->values[38] = C1_12_mF;
    derivatives->values[39] = t123;
    derivatives->values[40] = M_22_mH;
    derivatives->values[41] = K0_22_mH;
    derivatives->values[42] = t126;
    derivatives->values[43] = C1_12_w;
    derivatives->values[44] = M_12_zB;
    derivatives->values[45] = C1_12_c;
    derivatives->values[46] = K2_12_w;
    derivatives->values[47] = K2_12_zH;
    derivatives->values[48] = t153;
    derivatives->values[49] = t154;
    derivatives->values[50] = C1_22_mH;
    derivatives->values[51] = t166;
    derivatives->values[52] = t171;
    derivatives->values[53] = C1_12_lam;
    derivatives->values[54] = K2_12_lam;
    derivatives->values[55] = K0_22_w;
    derivatives->values[56] = t178;
    derivatives->values[57] = K2_22_h_spin_R;
    derivatives->values[58] = C1_22_c;
    derivatives->values[59] = t195;
    derivatives->values[60] = M_22_c;
    derivatives->values[61] = K0_12_xH;
    derivatives->values[62] = t202;
    derivatives->values[63] = t203;
    derivatives->values[64] = C1_22_zH;
    derivatives->values[65] = C1_22_w;
    derivatives->values[66] = K2_12_zB;
    derivatives->values[67] = K0_12_c;
    derivatives->values[68] = t214;
    derivatives->values[69] = t217;
    derivatives->values[70] = K0_22_c;
    derivatives->values[71] = t219;
    derivatives->values[72] = C1_22_lam;
    derivatives->values[73] = M_12_lam;
    derivatives->values[74] = M_22_lam;
    derivatives->values[75] = t247;
    derivatives->values[76] = K0_12_lam;
    derivatives->values[77] = M_22_rF;
    derivatives->values[78] = M_22_zH;
    derivatives->values[79] = M_22_IHxz;
    derivatives->values[80] = K0_22_lam;
    derivatives->values[81] = t257;
    derivatives->values[82] = t260;
    derivatives->values[83] = C1_12_IRyy;
    derivatives->values[84] = C1_21_rR;
    derivatives->values[85] = t263;
    derivatives->values[86] = M_22_IRxx;
    derivatives->values[87] = K2_22_xB;
    derivatives->values[88] = C1_12_rR;
    derivatives->values[89] = K2_22_mB;
    derivatives->values[90] = t268;
    derivatives->values[91] = K0_12_xB;
    derivatives->values[92] = t270;
    derivatives->values[93] = K0_12_mB;
    derivatives->values[94] = M_12_mB;
    derivatives->values[95] = M_22_mB;
    derivatives->values[96] = t274;
    derivatives->values[97] = M_22_xB;
    derivatives->values[98] = t277;
    derivatives->values[99] = t279;
    derivatives->values[100] = K2_12_mB;
    derivatives->values[101] = t281;
    derivatives->values[102] = t282;
    derivatives->values[103] = K2_22_xH;
    derivatives->values[104] = M_22_ay_all1_delta;
    derivatives->values[105] = M_22_mF;
    derivatives->values[106] = K0_22_zH;
    derivatives->values[107] = K2_12_mH;
    derivatives->values[108] = t288;
    derivatives->values[109] = M_22_IHzz;
    derivatives->values[110] = M_22_IFxx;
    derivatives->values[111] = C1_12_IFyy;
    derivatives->values[112] = C1_21_rF;
    derivatives->values[113] = K0_12_rF;
    derivatives->values[114] = t294;
    derivatives->values[115] = t295;
    derivatives->values[116] = K0_12_mF;
    derivatives->values[117] = t297;
    derivatives->values[118] = t298;
    derivatives->values[119] = t299;
    derivatives->values[120] = K2_22_mF;
    derivatives->values[121] = t301;
    derivatives->values[122] = K2_22_IFyy;
}

void rear_steered_f32_with_respect_to(const rear_steered_f32_derivatives_t *derivatives,
    size_t parameter, rear_steered_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < REAR_STEERED_N; row++) {
        for (size_t column = 0U; column < REAR_STEERED_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
            matrices->k2[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < REAR_STEERED_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &rear_steered_partials[position];
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
