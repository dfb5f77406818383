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
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 1U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 2U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 3U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 5U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 5U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 6U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 7U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 10U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 11U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 12U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 13U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 14U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 14U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 15U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 16U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 17U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 17U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 18U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 19U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 20U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 21U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 22U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 22U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 23U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 24U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 25U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 26U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 4U, 27U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 4U, 28U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 29U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 4U, 30U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 31U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 32U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 33U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 5U, 34U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 35U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 36U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 6U, 37U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 7U, 38U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 7U, 38U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 7U, 39U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 8U, 40U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 8U, 40U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 8U, 41U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 8U, 42U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 8U, 43U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 8U, 44U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 8U, 44U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 8U, 45U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 46U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 47U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 48U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 48U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 9U, 49U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 50U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 9U, 51U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 52U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 10U, 53U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 10U, 53U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 10U, 54U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 10U, 55U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 10U, 56U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 10U, 57U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 10U, 58U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 10U, 58U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 10U, 59U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 10U, 60U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 10U, 61U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 11U, 35U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 13U, 36U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 13U, 37U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 14U, 62U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 14U, 62U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 14U, 63U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 15U, 64U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 15U, 64U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 65U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 66U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 67U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 68U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 68U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 69U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 70U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 71U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 72U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 72U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 73U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 74U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 75U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 76U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 77U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 77U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 78U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 79U, false},
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
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 88U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 89U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 90U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 18U, 35U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 18U, 91U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 18U, 91U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 18U, 92U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 20U, 93U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 20U, 94U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 21U, 95U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 21U, 95U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 21U, 96U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 21U, 63U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 21U, 97U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 22U, 98U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 22U, 99U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 22U, 99U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 100U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 22U, 101U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 22U, 102U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 22U, 103U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 22U, 104U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 22U, 105U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 22U, 105U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 22U, 106U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 107U, true},
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
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 116U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 117U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 118U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 35U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 91U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 91U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 119U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 94U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 120U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 120U, true},
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
    const double t6 = p->zH * p->mH;
    const double t10 = p->rF * p->mF;
    const double Jxx_delta = p->IHxx + p->IFxx + (p->zH * t6) + (p->rF * t10);
    const double t17 = p->rR * p->mR;
    const double t21 = p->zB * p->mB;
    const double M_11 = p->IRxx + p->IBxx + Jxx_delta + (p->rR * t17) + (p->zB * t21);
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t33 = p->w + p->c;
    const double t34 = t33 - p->xH;
    const double t35 = p->mH * t34;
    const double Jxz_delta = (t10 * p->c) - (p->zH * t35) - p->IHxz;
    const double hx_delta = (Jxz_delta * cos_lam) - (Jxx_delta * sin_lam);
    const double t44 = cos_lam / p->w;
    const double yaw_by_delta = p->c * t44;
    const double Sz_delta = t6 - t10;
    const double Jxz_all = Jxz_delta + (t21 * p->xB) + (t33 * Sz_delta) - p->IBxz;
    const double M_12 = hx_delta + (yaw_by_delta * Jxz_all);
    const double t59 = p->mF * p->c;
    const double t62 = p->IFxx + p->IHzz;
    const double hz_delta = (cos_lam * ((t34 * t35) + (p->c * t59) + t62)) - (sin_lam * Jxz_delta);
    const double py_delta = (sin_lam * Sz_delta) + (cos_lam * (t35 + t59));
    const double M_yaw_delta = hz_delta - (t33 * py_delta);
    const double t74 = p->mB * p->xB;
    const double t76 = p->mH * p->xH;
    const double t78 = p->mF * p->w;
    const double t85 = yaw_by_delta * (p->IRxx + t62 + p->IBzz + (p->xB * t74) + (p->xH * t76) +
        (p->w * t78));
    const double P_delta_yaw = M_yaw_delta + t85;
    const double M_22 = (yaw_by_delta * (M_yaw_delta + P_delta_yaw)) + (cos_lam * hz_delta) -
        (sin_lam * hx_delta);
    const double h_spin_R = p->IFyy / p->rF;
    const double h_wheels_all = h_spin_R + (p->IRyy / p->rR);
    const double Sz_all = t21 + Sz_delta - t17;
    const double t100 = h_wheels_all - Sz_all;
    const double t103 = cos_lam * h_spin_R;
    const double C1_12 = (yaw_by_delta * t100) + t103 - (t44 * Jxz_all);
    const double t110 = yaw_by_delta * (t74 + t76 + t78);
    const double P_delta_lateral = py_delta - t110;
    const double C1_22 = (yaw_by_delta * P_delta_lateral) - (t44 * P_delta_yaw);
    const double K0_22 = sin_lam * P_delta_lateral;
    const double K2_22 = t44 * ((sin_lam * h_spin_R) - P_delta_lateral);
    const double C1_21 = -(t103 + (yaw_by_delta * h_wheels_all));
    const double K0_12 = t110 - py_delta;
    const double K2_12 = -(t44 * t100);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = Sz_all;
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
    const double M_11_mF = p->rF * p->rF;
    const double Jxx_delta_mH = p->zH * p->zH;
    const double Jxx_delta = p->IHxx + (p->mF * M_11_mF) + p->IFxx + (p->mH * Jxx_delta_mH);
    const double t17 = p->zB * p->mB;
    const double M_11_mR = p->rR * p->rR;
    const double M_11 = p->IBxx + Jxx_delta + p->IRxx + (p->zB * t17) + (p->mR * M_11_mR);
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t31 = p->mF * p->c;
    const double t34 = p->mH * p->zH;
    const double t36 = p->c + p->w;
    const double t38 = t36 - p->xH;
    const double t41 = (p->rF * t31) - p->IHxz - (t34 * t38);
    const double t43 = t41 * cos_lam;
    const double t44 = (Jxx_delta * sin_lam) - t43;
    const double t45 = p->mF * p->rF;
    const double Sz_delta = t34 - t45;
    const double t53 = t41 + (t36 * Sz_delta) + (t17 * p->xB) - p->IBxz;
    const double t54 = 1.0 / p->w;
    const double t55 = p->c * t54;
    const double yaw_by_delta = cos_lam * t55;
    const double M_12 = (t53 * yaw_by_delta) - t44;
    const double t60 = sin_lam * t41;
    const double t63 = p->IFxx + p->IHzz;
    const double t64 = p->mH * t38;
    const double t67 = (p->c * t31) + t63 + (t38 * t64);
    const double hz_delta = (cos_lam * t67) - t60;
    const double t71 = t31 + t64;
    const double py_delta = (sin_lam * Sz_delta) + (cos_lam * t71);
    const double M_yaw_delta = hz_delta - (t36 * py_delta);
    const double t77 = p->mH * p->xH;
    const double t79 = p->mF * p->w;
    const double t81 = p->mB * p->xB;
    const double t87 = p->IRxx + t63 + p->IBzz + (p->xH * t77) + (p->w * t79) + (p->xB * t81);
    const double t88 = yaw_by_delta * t87;
    const double P_delta_yaw = M_yaw_delta + t88;
    const double t92 = hz_delta + (t55 * (M_yaw_delta + P_delta_yaw));
    const double M_22 = (sin_lam * t44) + (cos_lam * t92);
    const double t97 = 1.0 / p->rF;
    const double h_spin_R = p->IFyy * t97;
    const double t100 = 1.0 / p->rR;
    const double t101 = p->IRyy * t100;
    const double h_wheels_all = h_spin_R + t101;
    const double t103 = p->mR * p->rR;
    const double K0_11 = t17 + Sz_delta - t103;
    const double t106 = h_wheels_all - K0_11;
    const double t109 = t54 * ((p->c * t106) - t53);
    const double t110 = h_spin_R + t109;
    const double C1_12 = cos_lam * t110;
    const double t112 = cos_lam * h_spin_R;
    const double C1_12_IBxz = cos_lam * t54;
    const double t114 = h_wheels_all * C1_12_IBxz;
    const double t118 = t77 + t79 + t81;
    const double M_22_yaw_by_delta = t54 * t118;
    const double py_delta_mF = p->c * cos_lam;
    const double t121 = M_22_yaw_by_delta * py_delta_mF;
    const double P_delta_lateral = py_delta - t121;
    const double t124 = P_delta_yaw - (p->c * P_delta_lateral);
    const double K0_22 = sin_lam * P_delta_lateral;
    const double C1_12_c = t106 * C1_12_IBxz;
    const double t128 = sin_lam * h_spin_R;
    const double t129 = P_delta_lateral - t128;
    const double t130 = C1_12_IBxz * t129;
    const double M_12_Jxz_delta = cos_lam + yaw_by_delta;
    const double M_12_xH = t34 * M_12_Jxz_delta;
    const double t134 = cos_lam * Sz_delta;
    const double M_12_c = (t53 * C1_12_IBxz) - t134;
    const double t138 = yaw_by_delta + yaw_by_delta;
    const double t139 = C1_12_IBxz * t138;
    const double t140 = t79 * t139;
    const double t142 = P_delta_yaw * (C1_12_IBxz + C1_12_IBxz);
    const double t146 = t38 * cos_lam;
    const double M_22_hz_delta = yaw_by_delta + M_12_Jxz_delta;
    const double t148 = t146 * M_22_hz_delta;
    const double C1_22_py_delta = t36 * C1_12_IBxz;
    const double t150 = py_delta_mF * C1_22_py_delta;
    const double t151 = sin_lam * M_12_Jxz_delta;
    const double M_22_IHxz = t151 + t151;
    const double t154 = t148 + (p->zH * M_22_IHxz);
    const double t158 = p->mH * (t148 + t154 - t150 - t150);
    const double t160 = (py_delta * t138) - t158;
    const double M_22_w = (p->c * (t140 - (t54 * t142))) - t160;
    const double P_delta_yaw_mB = t45 - t109;
    const double C1_12_w = C1_12_IBxz * P_delta_yaw_mB;
    const double C1_21_w = t55 * t114;
    const double t165 = p->mF - M_22_yaw_by_delta;
    const double hz_delta_mF = p->mH - (t55 * t165);
    const double t169 = p->xH * cos_lam;
    const double t170 = p->zH * sin_lam;
    const double py_delta_mH = t146 + t170;
    const double t173 = p->mH * (py_delta_mH - t169);
    const double t174 = py_delta - t173;
    const double t175 = t88 + t124;
    const double P_delta_yaw_xB = t54 * t175;
    const double C1_22_w = (C1_12_IBxz * ((py_delta_mF * hz_delta_mF) + t174 + P_delta_yaw_xB)) -
        t140;
    const double P_delta_lateral_w = cos_lam * hz_delta_mF;
    const double K0_22_w = sin_lam * P_delta_lateral_w;
    const double K2_12_w = t54 * C1_12_c;
    const double hz_delta_mH = cos_lam * P_delta_lateral_w;
    const double K2_22_w = t54 * (t130 - hz_delta_mH);
    const double t187 = M_12_Jxz_delta - C1_22_py_delta;
    const double t190 = t31 * cos_lam * (yaw_by_delta + t187);
    const double M_22_c = t142 + t190 + t190 - t160 - (t45 * M_22_IHxz);
    const double t197 = p->rF * sin_lam;
    const double t198 = py_delta_mF - t197;
    const double t201 = p->mH + t165;
    const double P_delta_yaw_mF = P_delta_lateral + t174 + (p->mF * ((p->w * cos_lam) - t198)) +
        (py_delta_mF * t201) - (t87 * C1_12_IBxz);
    const double C1_22_c = C1_12_IBxz * P_delta_yaw_mF;
    const double t209 = cos_lam * t201;
    const double K0_22_c = sin_lam * t209;
    const double t211 = C1_12_IBxz * t209;
    const double t213 = t60 + (Jxx_delta * cos_lam);
    const double t214 = sin_lam * t54;
    const double t215 = p->c * t214;
    const double t217 = t213 + (t53 * t215);
    const double py_delta_lam = t134 - (sin_lam * t71);
    const double t224 = t36 * py_delta_lam;
    const double P_delta_yaw_xH = cos_lam * t44;
    const double t228 = t43 + (sin_lam * t67);
    const double t231 = P_delta_yaw_xH - (sin_lam * (t92 + (t55 * t88) - t213)) - (t138 * t224);
    const double M_22_lam = t231 - (M_22_hz_delta * t228);
    const double t233 = sin_lam * t110;
    const double C1_21_lam = t128 + (h_wheels_all * t215);
    const double P_delta_lateral_lam = py_delta_lam + (t118 * t215);
    const double C1_22_lam = (t175 * t214) + (C1_12_IBxz * (t224 + t228 + (p->c *
        P_delta_lateral_lam)));
    const double K0_22_lam = (cos_lam * P_delta_lateral) + (sin_lam * P_delta_lateral_lam);
    const double K2_12_lam = t106 * t214;
    const double K2_22_lam = (t129 * t214) + (C1_12_IBxz * (t112 - P_delta_lateral_lam));
    const double M_11_rR = t103 + t103;
    const double t254 = p->mR - (t100 * t101);
    const double C1_12_rR = yaw_by_delta * t254;
    const double t256 = t100 * C1_12_IBxz;
    const double C1_12_IRyy = p->c * t256;
    const double C1_21_rR = t101 * C1_12_IRyy;
    const double t259 = C1_12_IBxz * t254;
    const double t260 = p->rR * C1_12_IBxz;
    const double C1_12_mR = p->c * t260;
    const double t263 = yaw_by_delta * C1_12_IBxz;
    const double M_22_IRxx = p->c * t263;
    const double M_12_xB = t17 * yaw_by_delta;
    const double K0_12_mB = p->xB * yaw_by_delta;
    const double M_12_zB = p->mB * K0_12_mB;
    const double M_22_xB = t138 * M_12_zB;
    const double K2_12_zB = p->mB * C1_12_IBxz;
    const double t270 = p->zB * K2_12_zB;
    const double t271 = p->c + p->xB;
    const double K2_22_xB = yaw_by_delta * K2_12_zB;
    const double t274 = (p->xB + t271) * K2_22_xB;
    const double K0_12_xB = p->mB * yaw_by_delta;
    const double t276 = sin_lam * K0_12_xB;
    const double M_11_zB = t17 + t17;
    const double t278 = K2_12_zB * t271;
    const double M_11_mB = p->zB * p->zB;
    const double M_12_mB = p->zB * K0_12_mB;
    const double M_22_mB = K0_12_mB * K0_12_mB;
    const double K2_12_mB = p->zB * C1_12_IBxz;
    const double t283 = t271 * K2_12_mB;
    const double K2_22_mB = p->xB * t263;
    const double t285 = t271 * K2_22_mB;
    const double t286 = sin_lam * K0_12_mB;
    const double t287 = t77 * t139;
    const double M_22_xH = (p->c * t287) - t158;
    const double t290 = t34 * C1_12_IBxz;
    const double K0_12_xH = p->mH * M_12_Jxz_delta;
    const double C1_22_xH = (C1_12_IBxz * (t173 - (p->c * K0_12_xH))) - t287;
    const double t296 = p->mH * t151;
    const double K2_12_zH = p->mH * C1_12_IBxz;
    const double K2_22_xH = M_12_Jxz_delta * K2_12_zH;
    const double Jxx_delta_zH = t34 + t34;
    const double t300 = t55 * t169;
    const double K0_12_mH = t300 - py_delta_mH;
    const double t303 = p->mH * (t170 - K0_12_mH);
    const double py_delta_zH = p->mH * sin_lam;
    const double t306 = (K0_12_mH + K0_12_mH) * py_delta_zH;
    const double t308 = yaw_by_delta + (t54 * t169);
    const double t309 = p->mH * t308;
    const double C1_22_zH = sin_lam * t309;
    const double M_22_Jxx_delta = sin_lam * sin_lam;
    const double K0_22_zH = p->mH * M_22_Jxx_delta;
    const double t313 = sin_lam * K2_12_zH;
    const double M_12_mH = p->zH * K0_12_mH;
    const double t318 = t36 * yaw_by_delta * py_delta_mH;
    const double M_22_mH = (t170 * t170) + (t300 * t300) + (t38 * t154) - t318 - t318;
    const double t324 = p->zH * t308;
    const double t325 = K0_12_mH * t308;
    const double t326 = sin_lam * K0_12_mH;
    const double K2_12_mH = p->zH * C1_12_IBxz;
    const double K2_22_mH = C1_12_IBxz * K0_12_mH;
    const double M_22_IHzz = M_22_IRxx + (cos_lam * M_22_hz_delta);
    const double t331 = C1_12_IBxz * M_12_Jxz_delta;
    const double C1_22_Jxz_delta = sin_lam * C1_12_IBxz;
    const double M_11_rF = t45 + t45;
    const double t335 = (p->c * t187) - t197;
    const double t337 = p->mF * (t197 - t335);
    const double t338 = p->w * yaw_by_delta;
    const double t339 = t198 - t338;
    const double K0_12_rF = p->mF * sin_lam;
    const double t342 = (t335 + t339) * K0_12_rF;
    const double C1_12_IFyy = t97 * M_12_Jxz_delta;
    const double C1_21_rF = h_spin_R * C1_12_IFyy;
    const double C1_12_rF = (p->mF * C1_22_py_delta) - C1_21_rF;
    const double t347 = C1_22_py_delta * K0_12_rF;
    const double t348 = sin_lam * K0_12_rF;
    const double t351 = C1_12_IBxz * (p->mF - (t97 * h_spin_R));
    const double K2_22_rF = sin_lam * t351;
    const double M_12_mF = p->rF * t335;
    const double M_22_mF = (t198 * t335) - (t338 * t339);
    const double C1_12_mF = p->rF * C1_22_py_delta;
    const double C1_22_mF = C1_22_py_delta * t339;
    const double K0_22_mF = sin_lam * t339;
    const double t360 = p->rF * C1_12_IBxz;
    const double t361 = C1_12_IBxz * t339;
    const double M_22_IFxx = M_22_Jxx_delta + M_22_IHzz;
    const double t363 = t97 * C1_12_IBxz;
    const double K2_22_IFyy = t97 * C1_22_Jxz_delta;
    const double C1_21 = -(t112 + (p->c * t114));
    const double C1_22 = -(C1_12_IBxz * t124);
    const double K0_12 = t121 - py_delta;
    const double K2_12 = -C1_12_c;
    const double K2_22 = -t130;
    const double M_12_w = -(M_12_xH + (t55 * M_12_c));
    const double K0_12_mF = t338 - t198;
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
    derivatives->values[5] = P_delta_lateral_w;
    derivatives->values[6] = K0_22_w;
    derivatives->values[7] = K2_12_w;
    derivatives->values[8] = K2_22_w;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = C1_12_c;
    derivatives->values[12] = t114;
    derivatives->values[13] = C1_22_c;
    derivatives->values[14] = t209;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t211;
    derivatives->values[17] = t217;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t233;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = P_delta_lateral_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = K2_12_lam;
    derivatives->values[25] = K2_22_lam;
    derivatives->values[26] = M_11_rR;
    derivatives->values[27] = C1_12_rR;
    derivatives->values[28] = C1_21_rR;
    derivatives->values[29] = p->mR;
    derivatives->values[30] = t259;
    derivatives->values[31] = M_11_mR;
    derivatives->values[32] = C1_12_mR;
    derivatives->values[33] = p->rR;
    derivatives->values[34] = t260;
    derivatives->values[35] = 1.0;
    derivatives->values[36] = M_22_IRxx;
    derivatives->values[37] = t263;
    derivatives->values[38] = C1_12_IRyy;
    derivatives->values[39] = t256;
    derivatives->values[40] = M_12_xB;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t270;
    derivatives->values[43] = t274;
    derivatives->values[44] = K0_12_xB;
    derivatives->values[45] = t276;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = M_12_zB;
    derivatives->values[49] = t278;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = K2_12_zB;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = M_12_mB;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t283;
    derivatives->values[56] = t285;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = K0_12_mB;
    derivatives->values[59] = t286;
    derivatives->values[60] = K2_12_mB;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = yaw_by_delta;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = M_12_xH;
    derivatives->values[65] = M_22_xH;
    derivatives->values[66] = t290;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = K0_12_xH;
    derivatives->values[69] = t296;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = Jxx_delta_zH;
    derivatives->values[72] = t303;
    derivatives->values[73] = t306;
    derivatives->values[74] = t309;
    derivatives->values[75] = C1_22_zH;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = py_delta_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = K2_12_zH;
    derivatives->values[80] = t313;
    derivatives->values[81] = Jxx_delta_mH;
    derivatives->values[82] = M_12_mH;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t324;
    derivatives->values[85] = t325;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = t326;
    derivatives->values[89] = K2_12_mH;
    derivatives->values[90] = K2_22_mH;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_Jxx_delta;
    derivatives->values[93] = M_22_IHzz;
    derivatives->values[94] = t331;
    derivatives->values[95] = M_12_Jxz_delta;
    derivatives->values[96] = M_22_IHxz;
    derivatives->values[97] = C1_22_Jxz_delta;
    derivatives->values[98] = M_11_rF;
    derivatives->values[99] = t337;
    derivatives->values[100] = t342;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = t347;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = K0_12_rF;
    derivatives->values[106] = t348;
    derivatives->values[107] = t351;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = M_12_mF;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = C1_22_mF;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = K0_22_mF;
    derivatives->values[117] = t360;
    derivatives->values[118] = t361;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t363;
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
    const float t6 = p->zH * p->mH;
    const float t10 = p->rF * p->mF;
    const float Jxx_delta = p->IHxx + p->IFxx + (p->zH * t6) + (p->rF * t10);
    const float t17 = p->rR * p->mR;
    const float t21 = p->zB * p->mB;
    const float M_11 = p->IRxx + p->IBxx + Jxx_delta + (p->rR * t17) + (p->zB * t21);
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t33 = p->w + p->c;
    const float t34 = t33 - p->xH;
    const float t35 = p->mH * t34;
    const float Jxz_delta = (t10 * p->c) - (p->zH * t35) - p->IHxz;
    const float hx_delta = (Jxz_delta * cos_lam) - (Jxx_delta * sin_lam);
    const float t44 = cos_lam / p->w;
    const float yaw_by_delta = p->c * t44;
    const float Sz_delta = t6 - t10;
    const float Jxz_all = Jxz_delta + (t21 * p->xB) + (t33 * Sz_delta) - p->IBxz;
    const float M_12 = hx_delta + (yaw_by_delta * Jxz_all);
    const float t59 = p->mF * p->c;
    const float t62 = p->IFxx + p->IHzz;
    const float hz_delta = (cos_lam * ((t34 * t35) + (p->c * t59) + t62)) - (sin_lam * Jxz_delta);
    const float py_delta = (sin_lam * Sz_delta) + (cos_lam * (t35 + t59));
    const float M_yaw_delta = hz_delta - (t33 * py_delta);
    const float t74 = p->mB * p->xB;
    const float t76 = p->mH * p->xH;
    const float t78 = p->mF * p->w;
    const float t85 = yaw_by_delta * (p->IRxx + t62 + p->IBzz + (p->xB * t74) + (p->xH * t76) +
        (p->w * t78));
    const float P_delta_yaw = M_yaw_delta + t85;
    const float M_22 = (yaw_by_delta * (M_yaw_delta + P_delta_yaw)) + (cos_lam * hz_delta) -
        (sin_lam * hx_delta);
    const float h_spin_R = p->IFyy / p->rF;
    const float h_wheels_all = h_spin_R + (p->IRyy / p->rR);
    const float Sz_all = t21 + Sz_delta - t17;
    const float t100 = h_wheels_all - Sz_all;
    const float t103 = cos_lam * h_spin_R;
    const float C1_12 = (yaw_by_delta * t100) + t103 - (t44 * Jxz_all);
    const float t110 = yaw_by_delta * (t74 + t76 + t78);
    const float P_delta_lateral = py_delta - t110;
    const float C1_22 = (yaw_by_delta * P_delta_lateral) - (t44 * P_delta_yaw);
    const float K0_22 = sin_lam * P_delta_lateral;
    const float K2_22 = t44 * ((sin_lam * h_spin_R) - P_delta_lateral);
    const float C1_21 = -(t103 + (yaw_by_delta * h_wheels_all));
    const float K0_12 = t110 - py_delta;
    const float K2_12 = -(t44 * t100);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = Sz_all;
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
    const float M_11_mF = p->rF * p->rF;
    const float Jxx_delta_mH = p->zH * p->zH;
    const float Jxx_delta = p->IHxx + (p->mF * M_11_mF) + p->IFxx + (p->mH * Jxx_delta_mH);
    const float t17 = p->zB * p->mB;
    const float M_11_mR = p->rR * p->rR;
    const float M_11 = p->IBxx + Jxx_delta + p->IRxx + (p->zB * t17) + (p->mR * M_11_mR);
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t31 = p->mF * p->c;
    const float t34 = p->mH * p->zH;
    const float t36 = p->c + p->w;
    const float t38 = t36 - p->xH;
    const float t41 = (p->rF * t31) - p->IHxz - (t34 * t38);
    const float t43 = t41 * cos_lam;
    const float t44 = (Jxx_delta * sin_lam) - t43;
    const float t45 = p->mF * p->rF;
    const float Sz_delta = t34 - t45;
    const float t53 = t41 + (t36 * Sz_delta) + (t17 * p->xB) - p->IBxz;
    const float t54 = 1.0F / p->w;
    const float t55 = p->c * t54;
    const float yaw_by_delta = cos_lam * t55;
    const float M_12 = (t53 * yaw_by_delta) - t44;
    const float t60 = sin_lam * t41;
    const float t63 = p->IFxx + p->IHzz;
    const float t64 = p->mH * t38;
    const float t67 = (p->c * t31) + t63 + (t38 * t64);
    const float hz_delta = (cos_lam * t67) - t60;
    const float t71 = t31 + t64;
    const float py_delta = (sin_lam * Sz_delta) + (cos_lam * t71);
    const float M_yaw_delta = hz_delta - (t36 * py_delta);
    const float t77 = p->mH * p->xH;
    const float t79 = p->mF * p->w;
    const float t81 = p->mB * p->xB;
    const float t87 = p->IRxx + t63 + p->IBzz + (p->xH * t77) + (p->w * t79) + (p->xB * t81);
    const float t88 = yaw_by_delta * t87;
    const float P_delta_yaw = M_yaw_delta + t88;
    const float t92 = hz_delta + (t55 * (M_yaw_delta + P_delta_yaw));
    const float M_22 = (sin_lam * t44) + (cos_lam * t92);
    const float t97 = 1.0F / p->rF;
    const float h_spin_R = p->IFyy * t97;
    const float t100 = 1.0F / p->rR;
    const float t101 = p->IRyy * t100;
    const float h_wheels_all = h_spin_R + t101;
    const float t103 = p->mR * p->rR;
    const float K0_11 = t17 + Sz_delta - t103;
    const float t106 = h_wheels_all - K0_11;
    const float t109 = t54 * ((p->c * t106) - t53);
    const float t110 = h_spin_R + t109;
    const float C1_12 = cos_lam * t110;
    const float t112 = cos_lam * h_spin_R;
    const float C1_12_IBxz = cos_lam * t54;
    const float t114 = h_wheels_all * C1_12_IBxz;
    const float t118 = t77 + t79 + t81;
    const float M_22_yaw_by_delta = t54 * t118;
    const float py_delta_mF = p->c * cos_lam;
    const float t121 = M_22_yaw_by_delta * py_delta_mF;
    const float P_delta_lateral = py_delta - t121;
    const float t124 = P_delta_yaw - (p->c * P_delta_lateral);
    const float K0_22 = sin_lam * P_delta_lateral;
    const float C1_12_c = t106 * C1_12_IBxz;
    const float t128 = sin_lam * h_spin_R;
    const float t129 = P_delta_lateral - t128;
    const float t130 = C1_12_IBxz * t129;
    const float M_12_Jxz_delta = cos_lam + yaw_by_delta;
    const float M_12_xH = t34 * M_12_Jxz_delta;
    const float t134 = cos_lam * Sz_delta;
    const float M_12_c = (t53 * C1_12_IBxz) - t134;
    const float t138 = yaw_by_delta + yaw_by_delta;
    const float t139 = C1_12_IBxz * t138;
    const float t140 = t79 * t139;
    const float t142 = P_delta_yaw * (C1_12_IBxz + C1_12_IBxz);
    const float t146 = t38 * cos_lam;
    const float M_22_hz_delta = yaw_by_delta + M_12_Jxz_delta;
    const float t148 = t146 * M_22_hz_delta;
    const float C1_22_py_delta = t36 * C1_12_IBxz;
    const float t150 = py_delta_mF * C1_22_py_delta;
    const float t151 = sin_lam * M_12_Jxz_delta;
    const float M_22_IHxz = t151 + t151;
    const float t154 = t148 + (p->zH * M_22_IHxz);
    const float t158 = p->mH * (t148 + t154 - t150 - t150);
    const float t160 = (py_delta * t138) - t158;
    const float M_22_w = (p->c * (t140 - (t54 * t142))) - t160;
    const float P_delta_yaw_mB = t45 - t109;
    const float C1_12_w = C1_12_IBxz * P_delta_yaw_mB;
    const float C1_21_w = t55 * t114;
    const float t165 = p->mF - M_22_yaw_by_delta;
    const float hz_delta_mF = p->mH - (t55 * t165);
    const float t169 = p->xH * cos_lam;
    const float t170 = p->zH * sin_lam;
    const float py_delta_mH = t146 + t170;
    const float t173 = p->mH * (py_delta_mH - t169);
    const float t174 = py_delta - t173;
    const float t175 = t88 + t124;
    const float P_delta_yaw_xB = t54 * t175;
    const float C1_22_w = (C1_12_IBxz * ((py_delta_mF * hz_delta_mF) + t174 + P_delta_yaw_xB)) -
        t140;
    const float P_delta_lateral_w = cos_lam * hz_delta_mF;
    const float K0_22_w = sin_lam * P_delta_lateral_w;
    const float K2_12_w = t54 * C1_12_c;
    const float hz_delta_mH = cos_lam * P_delta_lateral_w;
    const float K2_22_w = t54 * (t130 - hz_delta_mH);
    const float t187 = M_12_Jxz_delta - C1_22_py_delta;
    const float t190 = t31 * cos_lam * (yaw_by_delta + t187);
    const float M_22_c = t142 + t190 + t190 - t160 - (t45 * M_22_IHxz);
    const float t197 = p->rF * sin_lam;
    const float t198 = py_delta_mF - t197;
    const float t201 = p->mH + t165;
    const float P_delta_yaw_mF = P_delta_lateral + t174 + (p->mF * ((p->w * cos_lam) - t198)) +
        (py_delta_mF * t201) - (t87 * C1_12_IBxz);
    const float C1_22_c = C1_12_IBxz * P_delta_yaw_mF;
    const float t209 = cos_lam * t201;
    const float K0_22_c = sin_lam * t209;
    const float t211 = C1_12_IBxz * t209;
    const float t213 = t60 + (Jxx_delta * cos_lam);
    const float t214 = sin_lam * t54;
    const float t215 = p->c * t214;
    const float t217 = t213 + (t53 * t215);
    const float py_delta_lam = t134 - (sin_lam * t71);
    const float t224 = t36 * py_delta_lam;
    const float P_delta_yaw_xH = cos_lam * t44;
    const float t228 = t43 + (sin_lam * t67);
    const float t231 = P_delta_yaw_xH - (sin_lam * (t92 + (t55 * t88) - t213)) - (t138 * t224);
    const float M_22_lam = t231 - (M_22_hz_delta * t228);
    const float t233 = sin_lam * t110;
    const float C1_21_lam = t128 + (h_wheels_all * t215);
    const float P_delta_lateral_lam = py_delta_lam + (t118 * t215);
    const float C1_22_lam = (t175 * t214) + (C1_12_IBxz * (t224 + t228 + (p->c *
        P_delta_lateral_lam)));
    const float K0_22_lam = (cos_lam * P_delta_lateral) + (sin_lam * P_delta_lateral_lam);
    const float K2_12_lam = t106 * t214;
    const float K2_22_lam = (t129 * t214) + (C1_12_IBxz * (t112 - P_delta_lateral_lam));
    const float M_11_rR = t103 + t103;
    const float t254 = p->mR - (t100 * t101);
    const float C1_12_rR = yaw_by_delta * t254;
    const float t256 = t100 * C1_12_IBxz;
    const float C1_12_IRyy = p->c * t256;
    const float C1_21_rR = t101 * C1_12_IRyy;
    const float t259 = C1_12_IBxz * t254;
    const float t260 = p->rR * C1_12_IBxz;
    const float C1_12_mR = p->c * t260;
    const float t263 = yaw_by_delta * C1_12_IBxz;
    const float M_22_IRxx = p->c * t263;
    const float M_12_xB = t17 * yaw_by_delta;
    const float K0_12_mB = p->xB * yaw_by_delta;
    const float M_12_zB = p->mB * K0_12_mB;
    const float M_22_xB = t138 * M_12_zB;
    const float K2_12_zB = p->mB * C1_12_IBxz;
    const float t270 = p->zB * K2_12_zB;
    const float t271 = p->c + p->xB;
    const float K2_22_xB = yaw_by_delta * K2_12_zB;
    const float t274 = (p->xB + t271) * K2_22_xB;
    const float K0_12_xB = p->mB * yaw_by_delta;
    const float t276 = sin_lam * K0_12_xB;
    const float M_11_zB = t17 + t17;
    const float t278 = K2_12_zB * t271;
    const float M_11_mB = p->zB * p->zB;
    const float M_12_mB = p->zB * K0_12_mB;
    const float M_22_mB = K0_12_mB * K0_12_mB;
    const float K2_12_mB = p->zB * C1_12_IBxz;
    const float t283 = t271 * K2_12_mB;
    const float K2_22_mB = p->xB * t263;
    const float t285 = t271 * K2_22_mB;
    const float t286 = sin_lam * K0_12_mB;
    const float t287 = t77 * t139;
    const float M_22_xH = (p->c * t287) - t158;
    const float t290 = t34 * C1_12_IBxz;
    const float K0_12_xH = p->mH * M_12_Jxz_delta;
    const float C1_22_xH = (C1_12_IBxz * (t173 - (p->c * K0_12_xH))) - t287;
    const float t296 = p->mH * t151;
    const float K2_12_zH = p->mH * C1_12_IBxz;
    const float K2_22_xH = M_12_Jxz_delta * K2_12_zH;
    const float Jxx_delta_zH = t34 + t34;
    const float t300 = t55 * t169;
    const float K0_12_mH = t300 - py_delta_mH;
    const float t303 = p->mH * (t170 - K0_12_mH);
    const float py_delta_zH = p->mH * sin_lam;
    const float t306 = (K0_12_mH + K0_12_mH) * py_delta_zH;
    const float t308 = yaw_by_delta + (t54 * t169);
    const float t309 = p->mH * t308;
    const float C1_22_zH = sin_lam * t309;
    const float M_22_Jxx_delta = sin_lam * sin_lam;
    const float K0_22_zH = p->mH * M_22_Jxx_delta;
    const float t313 = sin_lam * K2_12_zH;
    const float M_12_mH = p->zH * K0_12_mH;
    const float t318 = t36 * yaw_by_delta * py_delta_mH;
    const float M_22_mH = (t170 * t170) + (t300 * t300) + (t38 * t154) - t318 - t318;
    const float t324 = p->zH * t308;
    const float t325 = K0_12_mH * t308;
    const float t326 = sin_lam * K0_12_mH;
    const float K2_12_mH = p->zH * C1_12_IBxz;
    const float K2_22_mH = C1_12_IBxz * K0_12_mH;
    const float M_22_IHzz = M_22_IRxx + (cos_lam * M_22_hz_delta);
    const float t331 = C1_12_IBxz * M_12_Jxz_delta;
    const float C1_22_Jxz_delta = sin_lam * C1_12_IBxz;
    const float M_11_rF = t45 + t45;
    const float t335 = (p->c * t187) - t197;
    const float t337 = p->mF * (t197 - t335);
    const float t338 = p->w * yaw_by_delta;
    const float t339 = t198 - t338;
    const float K0_12_rF = p->mF * sin_lam;
    const float t342 = (t335 + t339) * K0_12_rF;
    const float C1_12_IFyy = t97 * M_12_Jxz_delta;
    const float C1_21_rF = h_spin_R * C1_12_IFyy;
    const float C1_12_rF = (p->mF * C1_22_py_delta) - C1_21_rF;
    const float t347 = C1_22_py_delta * K0_12_rF;
    const float t348 = sin_lam * K0_12_rF;
    const float t351 = C1_12_IBxz * (p->mF - (t97 * h_spin_R));
    const float K2_22_rF = sin_lam * t351;
    const float M_12_mF = p->rF * t335;
    const float M_22_mF = (t198 * t335) - (t338 * t339);
    const float C1_12_mF = p->rF * C1_22_py_delta;
    const float C1_22_mF = C1_22_py_delta * t339;
    const float K0_22_mF = sin_lam * t339;
    const float t360 = p->rF * C1_12_IBxz;
    const float t361 = C1_12_IBxz * t339;
    const float M_22_IFxx = M_22_Jxx_delta + M_22_IHzz;
    const float t363 = t97 * C1_12_IBxz;
    const float K2_22_IFyy = t97 * C1_22_Jxz_delta;
    const float C1_21 = -(t112 + (p->c * t114));
    const float C1_22 = -(C1_12_IBxz * t124);
    const float K0_12 = t121 - py_delta;
    const float K2_12 = -C1_12_c;
    const float K2_22 = -t130;
    const float M_12_w = -(M_12_xH + (t55 * M_12_c));
    const float K0_12_mF = t338 - t198;
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
    derivatives->values[5] = P_delta_lateral_w;
    derivatives->values[6] = K0_22_w;
    derivatives->values[7] = K2_12_w;
    derivatives->values[8] = K2_22_w;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = C1_12_c;
    derivatives->values[12] = t114;
    derivatives->values[13] = C1_22_c;
    derivatives->values[14] = t209;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t211;
    derivatives->values[17] = t217;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t233;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = P_delta_lateral_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = K2_12_lam;
    derivatives->values[25] = K2_22_lam;
    derivatives->values[26] = M_11_rR;
    derivatives->values[27] = C1_12_rR;
    derivatives->values[28] = C1_21_rR;
    derivatives->values[29] = p->mR;
    derivatives->values[30] = t259;
    derivatives->values[31] = M_11_mR;
    derivatives->values[32] = C1_12_mR;
    derivatives->values[33] = p->rR;
    derivatives->values[34] = t260;
    derivatives->values[35] = 1.0F;
    derivatives->values[36] = M_22_IRxx;
    derivatives->values[37] = t263;
    derivatives->values[38] = C1_12_IRyy;
    derivatives->values[39] = t256;
    derivatives->values[40] = M_12_xB;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t270;
    derivatives->values[43] = t274;
    derivatives->values[44] = K0_12_xB;
    derivatives->values[45] = t276;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = M_12_zB;
    derivatives->values[49] = t278;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = K2_12_zB;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = M_12_mB;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t283;
    derivatives->values[56] = t285;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = K0_12_mB;
    derivatives->values[59] = t286;
    derivatives->values[60] = K2_12_mB;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = yaw_by_delta;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = M_12_xH;
    derivatives->values[65] = M_22_xH;
    derivatives->values[66] = t290;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = K0_12_xH;
    derivatives->values[69] = t296;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = Jxx_delta_zH;
    derivatives->values[72] = t303;
    derivatives->values[73] = t306;
    derivatives->values[74] = t309;
    derivatives->values[75] = C1_22_zH;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = py_delta_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = K2_12_zH;
    derivatives->values[80] = t313;
    derivatives->values[81] = Jxx_delta_mH;
    derivatives->values[82] = M_12_mH;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t324;
    derivatives->values[85] = t325;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = t326;
    derivatives->values[89] = K2_12_mH;
    derivatives->values[90] = K2_22_mH;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_Jxx_delta;
    derivatives->values[93] = M_22_IHzz;
    derivatives->values[94] = t331;
    derivatives->values[95] = M_12_Jxz_delta;
    derivatives->values[96] = M_22_IHxz;
    derivatives->values[97] = C1_22_Jxz_delta;
    derivatives->values[98] = M_11_rF;
    derivatives->values[99] = t337;
    derivatives->values[100] = t342;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = t347;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = K0_12_rF;
    derivatives->values[106] = t348;
    derivatives->values[107] = t351;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = M_12_mF;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = C1_22_mF;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = K0_22_mF;
    derivatives->values[117] = t360;
    derivatives->values[118] = t361;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t363;
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
