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
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 2U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 3U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 4U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 5U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 5U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 6U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 7U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 8U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 9U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 9U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 10U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 11U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 12U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 13U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 14U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 14U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 15U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 16U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 17U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 17U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 18U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 19U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 20U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 21U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 22U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 22U, false},
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
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 65U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 66U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 67U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 68U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 68U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 69U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 70U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 71U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 72U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 72U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 73U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 74U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 75U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 76U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 77U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 77U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 78U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 79U, false},
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
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 88U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 89U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 90U, true},
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
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 100U, false},
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
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 110U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 110U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 111U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 112U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 113U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 114U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 115U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 115U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 116U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 117U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 118U, false},
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
    const double t4 = p->zB * p->mB;
    const double t8 = p->zH * p->mH;
    const double t15 = p->rR * p->mR;
    const double t20 = p->rF * p->mF;
    const double t24 = p->IHxx + ((p->rF * t20) + p->IFxx);
    const double M_11 = p->IBxx + (p->IRxx + ((p->zB * t4) + (p->zH * t8))) + ((p->rR * t15) + t24);
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t33 = 1.0 / p->w;
    const double t34 = cos_lam * t33;
    const double yaw_by_delta = p->c * t34;
    const double wz_delta2_delta = cos_lam + yaw_by_delta;
    const double K_phi_delta_ = (t24 * sin_lam) + (wz_delta2_delta * p->IHxz);
    const double t45 = (p->xH * wz_delta2_delta) - (cos_lam * (p->c + p->w));
    const double t47 = p->mH * (t45 - (p->zH * sin_lam));
    const double t49 = (p->zH * t47) - K_phi_delta_;
    const double t53 = (t4 * p->xB) - p->IBxz;
    const double M_12 = t49 + (yaw_by_delta * t53);
    const double t60 = (sin_lam * p->IHxz) + (wz_delta2_delta * (p->IFxx + p->IHzz));
    const double t61 = p->mB * p->xB;
    const double t67 = t60 + (yaw_by_delta * ((p->xB * t61) + (p->IRxx + p->IBzz)));
    const double t76 = p->IRyy / p->rR;
    const double h_spin_R = p->IFyy / p->rF;
    const double t81 = (yaw_by_delta * t76) + (wz_delta2_delta * h_spin_R);
    const double K0_11 = t8 - (t15 + t20 - t4);
    const double C1_12 = t81 + ((t20 * cos_lam) - (t34 * (t53 + (p->c * K0_11) + ((t8 * p->xH) -
        p->IHxz))));
    const double t98 = t20 * sin_lam;
    const double K0_12 = (yaw_by_delta * t61) + t47 + t98;
    const double t104 = cos_lam * ((t33 * (t67 + (p->xH * t47) + (K0_12 * p->c))) + t98);
    const double K2_12 = t34 * (K0_11 - t76 - h_spin_R);
    const double K2_22 = t34 * (K0_12 + (sin_lam * h_spin_R));
    const double M_22 = (yaw_by_delta * t67) - ((sin_lam * t49) - (cos_lam * t60) - (t47 * t45));
    const double C1_21 = -t81;
    const double C1_22 = -t104;
    const double K0_22 = -(K0_12 * sin_lam);
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
    const double M_11_mB = p->zB * p->zB;
    const double M_11_mF = p->rF * p->rF;
    const double t13 = p->IHxx + p->IFxx + (p->mF * M_11_mF);
    const double t16 = p->zH * p->mH;
    const double t18 = t13 + (p->zH * t16);
    const double M_11_mR = p->rR * p->rR;
    const double M_11 = p->IBxx + (p->mB * M_11_mB) + p->IRxx + t18 + (p->mR * M_11_mR);
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t29 = t13 * sin_lam;
    const double t34 = 1.0 / p->w;
    const double t35 = p->c * t34;
    const double yaw_by_delta = cos_lam * t35;
    const double wz_delta2_delta = cos_lam + yaw_by_delta;
    const double t39 = t29 + (p->IHxz * wz_delta2_delta);
    const double t42 = p->mB * p->xB;
    const double t44 = p->IBxz - (p->zB * t42);
    const double t49 = p->c + p->w - p->xH;
    const double t50 = t35 * p->xH;
    const double t51 = t49 - t50;
    const double t53 = (p->zH * sin_lam) + (cos_lam * t51);
    const double t54 = p->mH * t53;
    const double C1_12_IBxz = cos_lam * t34;
    const double t59 = yaw_by_delta * C1_12_IBxz;
    const double M_22_IRxx = p->c * t59;
    const double t64 = p->IRxx + p->IBzz + (p->xB * t42);
    const double t66 = sin_lam * p->IHxz;
    const double t68 = p->IFxx + p->IHzz;
    const double t70 = t66 + (wz_delta2_delta * t68);
    const double M_22_mH = t53 * t53;
    const double M_22 = (M_22_IRxx * t64) + (wz_delta2_delta * (t66 + t70)) + (p->mH * M_22_mH) +
        (sin_lam * t29);
    const double t81 = 1.0 / p->rR;
    const double t82 = p->IRyy * t81;
    const double t84 = 1.0 / p->rF;
    const double h_spin_R = p->IFyy * t84;
    const double t86 = t82 + h_spin_R;
    const double t87 = C1_12_IBxz * t86;
    const double t88 = p->c * t87;
    const double t89 = cos_lam * h_spin_R;
    const double t90 = t88 + t89;
    const double t91 = p->mF * p->rF;
    const double t92 = cos_lam * t91;
    const double t93 = p->mB * p->zB;
    const double t94 = p->mR * p->rR;
    const double K0_11 = t93 - (t91 + t94 - t16);
    const double t101 = p->IHxz + t44 - (t16 * p->xH);
    const double t102 = t101 - (p->c * K0_11);
    const double t103 = C1_12_IBxz * t102;
    const double C1_12 = t90 + t92 + t103;
    const double K0_12_mF = p->rF * sin_lam;
    const double t107 = p->mF * K0_12_mF;
    const double t110 = t70 + (yaw_by_delta * t64);
    const double K2_12_zB = p->mB * C1_12_IBxz;
    const double K0_12_xB = p->c * K2_12_zB;
    const double M_12_zB = p->xB * K0_12_xB;
    const double K0_12 = t107 + M_12_zB - t54;
    const double t119 = t34 * ((p->xH * t54) - t110 - (p->c * K0_12));
    const double t120 = t107 - t119;
    const double t123 = t86 - K0_11;
    const double C1_12_c = C1_12_IBxz * t123;
    const double t125 = sin_lam * h_spin_R;
    const double t126 = K0_12 + t125;
    const double K2_22 = C1_12_IBxz * t126;
    const double t128 = C1_12_IBxz * t101;
    const double t130 = t16 * cos_lam;
    const double M_12_w = (t35 * t128) - t130;
    const double t133 = cos_lam + (t50 * C1_12_IBxz);
    const double t135 = C1_12_IBxz * t110;
    const double t137 = (t54 * t133) - (t35 * t135);
    const double M_22_w = t137 + t137;
    const double t140 = t34 * (t88 + t103);
    const double C1_21_w = t34 * t88;
    const double t142 = p->mH * t133;
    const double t143 = p->c + p->xH;
    const double t147 = M_12_zB + (C1_12_IBxz * (t64 + t68));
    const double t148 = t35 * t147;
    const double t151 = C1_12_IBxz * (t119 - (t142 * t143) - t148);
    const double t152 = t42 * C1_12_IBxz;
    const double t154 = t142 + (t35 * t152);
    const double K0_22_w = sin_lam * t154;
    const double K2_12_w = t34 * C1_12_c;
    const double t159 = t34 * (K2_22 + (cos_lam * t154));
    const double t160 = t128 + t130;
    const double t161 = t54 + t54;
    const double t162 = p->xH * C1_12_IBxz;
    const double t163 = cos_lam - t162;
    const double M_22_c = t135 + t135 + (t161 * t163);
    const double t167 = p->mH * t163;
    const double t171 = C1_12_IBxz * (K0_12 + t147 - (t143 * t167));
    const double K0_12_c = t152 - t167;
    const double t173 = sin_lam * K0_12_c;
    const double K2_22_c = C1_12_IBxz * K0_12_c;
    const double t176 = sin_lam * t34;
    const double t177 = p->c * t176;
    const double t179 = p->mH * sin_lam;
    const double t180 = p->zH * t179;
    const double M_12_lam = t66 + (t101 * t177) + (t49 * t180) - (t18 * cos_lam);
    const double t186 = t130 - (t51 * t179);
    const double t193 = (t53 * t186) + (cos_lam * t39) - (sin_lam * (t70 + (t35 * t110)));
    const double M_22_lam = t193 + t193;
    const double C1_21_lam = t125 + (t86 * t177);
    const double t199 = t107 + (t102 * t176) + C1_21_lam;
    const double t200 = yaw_by_delta + t162;
    const double t202 = cos_lam * C1_12_IBxz;
    const double C1_22_lam = (t186 * t200) + (sin_lam * (t120 + t148 + (C1_12_IBxz * t68))) -
        (p->IHxz * t202) - (wz_delta2_delta * t92);
    const double K0_12_lam = t92 - t186 - (t42 * t177);
    const double K2_12_lam = t123 * t176;
    const double K2_22_lam = (C1_12_IBxz * (t89 + K0_12_lam)) - (t126 * t176);
    const double M_11_rR = t94 + t94;
    const double t226 = C1_12_IBxz * (p->mR - (t81 * t82));
    const double C1_12_rR = p->c * t226;
    const double C1_12_IRyy = yaw_by_delta * t81;
    const double C1_21_rR = t82 * C1_12_IRyy;
    const double C1_12_mR = p->rR * yaw_by_delta;
    const double t231 = p->rR * C1_12_IBxz;
    const double t233 = C1_12_IBxz * t81;
    const double M_12_xB = yaw_by_delta * t93;
    const double M_22_xB = yaw_by_delta * (M_12_zB + M_12_zB);
    const double t237 = p->zB * K2_12_zB;
    const double t238 = p->c + p->xB;
    const double t239 = K2_12_zB * t238;
    const double t241 = yaw_by_delta * (t152 + t239);
    const double t242 = sin_lam * K0_12_xB;
    const double K2_22_xB = p->mB * t59;
    const double M_11_zB = t93 + t93;
    const double K0_12_mB = yaw_by_delta * p->xB;
    const double M_12_mB = p->zB * K0_12_mB;
    const double M_22_mB = K0_12_mB * K0_12_mB;
    const double K2_12_mB = p->zB * C1_12_IBxz;
    const double t249 = t238 * K2_12_mB;
    const double K2_22_mB = C1_12_IBxz * K0_12_mB;
    const double t251 = t238 * K2_22_mB;
    const double t252 = sin_lam * K0_12_mB;
    const double K0_12_xH = p->mH * wz_delta2_delta;
    const double M_12_xH = p->zH * K0_12_xH;
    const double t255 = wz_delta2_delta * t161;
    const double t256 = t34 * t130;
    const double K2_12_zH = p->mH * C1_12_IBxz;
    const double t259 = t143 * K2_12_zH;
    const double C1_22_xH = (t53 * K2_12_zH) - (wz_delta2_delta * t259);
    const double t262 = sin_lam * wz_delta2_delta;
    const double t263 = p->mH * t262;
    const double t264 = t59 + t202;
    const double K2_22_xH = p->mH * t264;
    const double M_11_zH = t16 + t16;
    const double t267 = t54 + t180;
    const double M_22_zH = sin_lam * t161;
    const double C1_22_zH = t179 * t200;
    const double M_22_IHxx = sin_lam * sin_lam;
    const double K0_22_zH = p->mH * M_22_IHxx;
    const double t272 = sin_lam * K2_12_zH;
    const double M_11_mH = p->zH * p->zH;
    const double t274 = p->zH * t53;
    const double t275 = p->zH * t200;
    const double C1_22_mH = t53 * t200;
    const double K0_22_mH = sin_lam * t53;
    const double K2_12_mH = p->zH * C1_12_IBxz;
    const double t279 = t53 * C1_12_IBxz;
    const double M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const double M_22_IHxz = t262 + t262;
    const double K2_22_h_spin_R = cos_lam * t176;
    const double M_11_rF = t91 + t91;
    const double t284 = t107 + t107;
    const double M_22_rF = sin_lam * t284;
    const double t286 = t84 * h_spin_R;
    const double t287 = p->mF - t286;
    const double C1_12_rF = wz_delta2_delta * t287;
    const double C1_21_rF = wz_delta2_delta * t286;
    const double K0_12_rF = p->mF * sin_lam;
    const double t291 = wz_delta2_delta * K0_12_rF;
    const double t292 = sin_lam * K0_12_rF;
    const double t293 = C1_12_IBxz * t287;
    const double K2_22_rF = K2_22_h_spin_R * t287;
    const double t295 = p->rF * K0_12_mF;
    const double t296 = p->rF * M_22_IHxx;
    const double M_22_mF = p->rF * t296;
    const double C1_12_mF = p->rF * wz_delta2_delta;
    const double t299 = sin_lam * C1_12_mF;
    const double t300 = p->rF * C1_12_IBxz;
    const double K2_22_mF = C1_12_IBxz * K0_12_mF;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double C1_12_IFyy = wz_delta2_delta * t84;
    const double t304 = C1_12_IBxz * t84;
    const double K2_22_IFyy = t84 * K2_22_h_spin_R;
    const double M_12 = -(t39 + (yaw_by_delta * t44) + (p->zH * t54));
    const double C1_21 = -t90;
    const double C1_22 = -(cos_lam * t120);
    const double K0_22 = -(sin_lam * K0_12);
    const double K2_12 = -C1_12_c;
    const double K0_22_lam = -((sin_lam * K0_12_lam) + (cos_lam * K0_12));
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
    derivatives->values[2] = t140;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = t151;
    derivatives->values[5] = t154;
    derivatives->values[6] = K0_22_w;
    derivatives->values[7] = K2_12_w;
    derivatives->values[8] = t159;
    derivatives->values[9] = t160;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = C1_12_c;
    derivatives->values[12] = t87;
    derivatives->values[13] = t171;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = t173;
    derivatives->values[16] = K2_22_c;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t199;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = K2_12_lam;
    derivatives->values[25] = K2_22_lam;
    derivatives->values[26] = M_11_rR;
    derivatives->values[27] = C1_12_rR;
    derivatives->values[28] = C1_21_rR;
    derivatives->values[29] = p->mR;
    derivatives->values[30] = t226;
    derivatives->values[31] = M_11_mR;
    derivatives->values[32] = C1_12_mR;
    derivatives->values[33] = p->rR;
    derivatives->values[34] = t231;
    derivatives->values[35] = 1.0;
    derivatives->values[36] = M_22_IRxx;
    derivatives->values[37] = t59;
    derivatives->values[38] = C1_12_IRyy;
    derivatives->values[39] = t233;
    derivatives->values[40] = M_12_xB;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t237;
    derivatives->values[43] = t241;
    derivatives->values[44] = K0_12_xB;
    derivatives->values[45] = t242;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = M_12_zB;
    derivatives->values[49] = t239;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = K2_12_zB;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = M_12_mB;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t249;
    derivatives->values[56] = t251;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = K0_12_mB;
    derivatives->values[59] = t252;
    derivatives->values[60] = K2_12_mB;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = yaw_by_delta;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = M_12_xH;
    derivatives->values[65] = t255;
    derivatives->values[66] = t256;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = K0_12_xH;
    derivatives->values[69] = t263;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = t267;
    derivatives->values[73] = M_22_zH;
    derivatives->values[74] = t259;
    derivatives->values[75] = C1_22_zH;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = t179;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = K2_12_zH;
    derivatives->values[80] = t272;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = t274;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t275;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = t53;
    derivatives->values[88] = K0_22_mH;
    derivatives->values[89] = K2_12_mH;
    derivatives->values[90] = t279;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_IHxx;
    derivatives->values[93] = M_22_IHzz;
    derivatives->values[94] = t264;
    derivatives->values[95] = wz_delta2_delta;
    derivatives->values[96] = M_22_IHxz;
    derivatives->values[97] = K2_22_h_spin_R;
    derivatives->values[98] = M_11_rF;
    derivatives->values[99] = t284;
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = t291;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = K0_12_rF;
    derivatives->values[106] = t292;
    derivatives->values[107] = t293;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = t295;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = t299;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = t296;
    derivatives->values[117] = t300;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t304;
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
    const float t4 = p->zB * p->mB;
    const float t8 = p->zH * p->mH;
    const float t15 = p->rR * p->mR;
    const float t20 = p->rF * p->mF;
    const float t24 = p->IHxx + ((p->rF * t20) + p->IFxx);
    const float M_11 = p->IBxx + (p->IRxx + ((p->zB * t4) + (p->zH * t8))) + ((p->rR * t15) + t24);
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t33 = 1.0F / p->w;
    const float t34 = cos_lam * t33;
    const float yaw_by_delta = p->c * t34;
    const float wz_delta2_delta = cos_lam + yaw_by_delta;
    const float K_phi_delta_ = (t24 * sin_lam) + (wz_delta2_delta * p->IHxz);
    const float t45 = (p->xH * wz_delta2_delta) - (cos_lam * (p->c + p->w));
    const float t47 = p->mH * (t45 - (p->zH * sin_lam));
    const float t49 = (p->zH * t47) - K_phi_delta_;
    const float t53 = (t4 * p->xB) - p->IBxz;
    const float M_12 = t49 + (yaw_by_delta * t53);
    const float t60 = (sin_lam * p->IHxz) + (wz_delta2_delta * (p->IFxx + p->IHzz));
    const float t61 = p->mB * p->xB;
    const float t67 = t60 + (yaw_by_delta * ((p->xB * t61) + (p->IRxx + p->IBzz)));
    const float t76 = p->IRyy / p->rR;
    const float h_spin_R = p->IFyy / p->rF;
    const float t81 = (yaw_by_delta * t76) + (wz_delta2_delta * h_spin_R);
    const float K0_11 = t8 - (t15 + t20 - t4);
    const float C1_12 = t81 + ((t20 * cos_lam) - (t34 * (t53 + (p->c * K0_11) + ((t8 * p->xH) -
        p->IHxz))));
    const float t98 = t20 * sin_lam;
    const float K0_12 = (yaw_by_delta * t61) + t47 + t98;
    const float t104 = cos_lam * ((t33 * (t67 + (p->xH * t47) + (K0_12 * p->c))) + t98);
    const float K2_12 = t34 * (K0_11 - t76 - h_spin_R);
    const float K2_22 = t34 * (K0_12 + (sin_lam * h_spin_R));
    const float M_22 = (yaw_by_delta * t67) - ((sin_lam * t49) - (cos_lam * t60) - (t47 * t45));
    const float C1_21 = -t81;
    const float C1_22 = -t104;
    const float K0_22 = -(K0_12 * sin_lam);
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
    const float M_11_mB = p->zB * p->zB;
    const float M_11_mF = p->rF * p->rF;
    const float t13 = p->IHxx + p->IFxx + (p->mF * M_11_mF);
    const float t16 = p->zH * p->mH;
    const float t18 = t13 + (p->zH * t16);
    const float M_11_mR = p->rR * p->rR;
    const float M_11 = p->IBxx + (p->mB * M_11_mB) + p->IRxx + t18 + (p->mR * M_11_mR);
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t29 = t13 * sin_lam;
    const float t34 = 1.0F / p->w;
    const float t35 = p->c * t34;
    const float yaw_by_delta = cos_lam * t35;
    const float wz_delta2_delta = cos_lam + yaw_by_delta;
    const float t39 = t29 + (p->IHxz * wz_delta2_delta);
    const float t42 = p->mB * p->xB;
    const float t44 = p->IBxz - (p->zB * t42);
    const float t49 = p->c + p->w - p->xH;
    const float t50 = t35 * p->xH;
    const float t51 = t49 - t50;
    const float t53 = (p->zH * sin_lam) + (cos_lam * t51);
    const float t54 = p->mH * t53;
    const float C1_12_IBxz = cos_lam * t34;
    const float t59 = yaw_by_delta * C1_12_IBxz;
    const float M_22_IRxx = p->c * t59;
    const float t64 = p->IRxx + p->IBzz + (p->xB * t42);
    const float t66 = sin_lam * p->IHxz;
    const float t68 = p->IFxx + p->IHzz;
    const float t70 = t66 + (wz_delta2_delta * t68);
    const float M_22_mH = t53 * t53;
    const float M_22 = (M_22_IRxx * t64) + (wz_delta2_delta * (t66 + t70)) + (p->mH * M_22_mH) +
        (sin_lam * t29);
    const float t81 = 1.0F / p->rR;
    const float t82 = p->IRyy * t81;
    const float t84 = 1.0F / p->rF;
    const float h_spin_R = p->IFyy * t84;
    const float t86 = t82 + h_spin_R;
    const float t87 = C1_12_IBxz * t86;
    const float t88 = p->c * t87;
    const float t89 = cos_lam * h_spin_R;
    const float t90 = t88 + t89;
    const float t91 = p->mF * p->rF;
    const float t92 = cos_lam * t91;
    const float t93 = p->mB * p->zB;
    const float t94 = p->mR * p->rR;
    const float K0_11 = t93 - (t91 + t94 - t16);
    const float t101 = p->IHxz + t44 - (t16 * p->xH);
    const float t102 = t101 - (p->c * K0_11);
    const float t103 = C1_12_IBxz * t102;
    const float C1_12 = t90 + t92 + t103;
    const float K0_12_mF = p->rF * sin_lam;
    const float t107 = p->mF * K0_12_mF;
    const float t110 = t70 + (yaw_by_delta * t64);
    const float K2_12_zB = p->mB * C1_12_IBxz;
    const float K0_12_xB = p->c * K2_12_zB;
    const float M_12_zB = p->xB * K0_12_xB;
    const float K0_12 = t107 + M_12_zB - t54;
    const float t119 = t34 * ((p->xH * t54) - t110 - (p->c * K0_12));
    const float t120 = t107 - t119;
    const float t123 = t86 - K0_11;
    const float C1_12_c = C1_12_IBxz * t123;
    const float t125 = sin_lam * h_spin_R;
    const float t126 = K0_12 + t125;
    const float K2_22 = C1_12_IBxz * t126;
    const float t128 = C1_12_IBxz * t101;
    const float t130 = t16 * cos_lam;
    const float M_12_w = (t35 * t128) - t130;
    const float t133 = cos_lam + (t50 * C1_12_IBxz);
    const float t135 = C1_12_IBxz * t110;
    const float t137 = (t54 * t133) - (t35 * t135);
    const float M_22_w = t137 + t137;
    const float t140 = t34 * (t88 + t103);
    const float C1_21_w = t34 * t88;
    const float t142 = p->mH * t133;
    const float t143 = p->c + p->xH;
    const float t147 = M_12_zB + (C1_12_IBxz * (t64 + t68));
    const float t148 = t35 * t147;
    const float t151 = C1_12_IBxz * (t119 - (t142 * t143) - t148);
    const float t152 = t42 * C1_12_IBxz;
    const float t154 = t142 + (t35 * t152);
    const float K0_22_w = sin_lam * t154;
    const float K2_12_w = t34 * C1_12_c;
    const float t159 = t34 * (K2_22 + (cos_lam * t154));
    const float t160 = t128 + t130;
    const float t161 = t54 + t54;
    const float t162 = p->xH * C1_12_IBxz;
    const float t163 = cos_lam - t162;
    const float M_22_c = t135 + t135 + (t161 * t163);
    const float t167 = p->mH * t163;
    const float t171 = C1_12_IBxz * (K0_12 + t147 - (t143 * t167));
    const float K0_12_c = t152 - t167;
    const float t173 = sin_lam * K0_12_c;
    const float K2_22_c = C1_12_IBxz * K0_12_c;
    const float t176 = sin_lam * t34;
    const float t177 = p->c * t176;
    const float t179 = p->mH * sin_lam;
    const float t180 = p->zH * t179;
    const float M_12_lam = t66 + (t101 * t177) + (t49 * t180) - (t18 * cos_lam);
    const float t186 = t130 - (t51 * t179);
    const float t193 = (t53 * t186) + (cos_lam * t39) - (sin_lam * (t70 + (t35 * t110)));
    const float M_22_lam = t193 + t193;
    const float C1_21_lam = t125 + (t86 * t177);
    const float t199 = t107 + (t102 * t176) + C1_21_lam;
    const float t200 = yaw_by_delta + t162;
    const float t202 = cos_lam * C1_12_IBxz;
    const float C1_22_lam = (t186 * t200) + (sin_lam * (t120 + t148 + (C1_12_IBxz * t68))) -
        (p->IHxz * t202) - (wz_delta2_delta * t92);
    const float K0_12_lam = t92 - t186 - (t42 * t177);
    const float K2_12_lam = t123 * t176;
    const float K2_22_lam = (C1_12_IBxz * (t89 + K0_12_lam)) - (t126 * t176);
    const float M_11_rR = t94 + t94;
    const float t226 = C1_12_IBxz * (p->mR - (t81 * t82));
    const float C1_12_rR = p->c * t226;
    const float C1_12_IRyy = yaw_by_delta * t81;
    const float C1_21_rR = t82 * C1_12_IRyy;
    const float C1_12_mR = p->rR * yaw_by_delta;
    const float t231 = p->rR * C1_12_IBxz;
    const float t233 = C1_12_IBxz * t81;
    const float M_12_xB = yaw_by_delta * t93;
    const float M_22_xB = yaw_by_delta * (M_12_zB + M_12_zB);
    const float t237 = p->zB * K2_12_zB;
    const float t238 = p->c + p->xB;
    const float t239 = K2_12_zB * t238;
    const float t241 = yaw_by_delta * (t152 + t239);
    const float t242 = sin_lam * K0_12_xB;
    const float K2_22_xB = p->mB * t59;
    const float M_11_zB = t93 + t93;
    const float K0_12_mB = yaw_by_delta * p->xB;
    const float M_12_mB = p->zB * K0_12_mB;
    const float M_22_mB = K0_12_mB * K0_12_mB;
    const float K2_12_mB = p->zB * C1_12_IBxz;
    const float t249 = t238 * K2_12_mB;
    const float K2_22_mB = C1_12_IBxz * K0_12_mB;
    const float t251 = t238 * K2_22_mB;
    const float t252 = sin_lam * K0_12_mB;
    const float K0_12_xH = p->mH * wz_delta2_delta;
    const float M_12_xH = p->zH * K0_12_xH;
    const float t255 = wz_delta2_delta * t161;
    const float t256 = t34 * t130;
    const float K2_12_zH = p->mH * C1_12_IBxz;
    const float t259 = t143 * K2_12_zH;
    const float C1_22_xH = (t53 * K2_12_zH) - (wz_delta2_delta * t259);
    const float t262 = sin_lam * wz_delta2_delta;
    const float t263 = p->mH * t262;
    const float t264 = t59 + t202;
    const float K2_22_xH = p->mH * t264;
    const float M_11_zH = t16 + t16;
    const float t267 = t54 + t180;
    const float M_22_zH = sin_lam * t161;
    const float C1_22_zH = t179 * t200;
    const float M_22_IHxx = sin_lam * sin_lam;
    const float K0_22_zH = p->mH * M_22_IHxx;
    const float t272 = sin_lam * K2_12_zH;
    const float M_11_mH = p->zH * p->zH;
    const float t274 = p->zH * t53;
    const float t275 = p->zH * t200;
    const float C1_22_mH = t53 * t200;
    const float K0_22_mH = sin_lam * t53;
    const float K2_12_mH = p->zH * C1_12_IBxz;
    const float t279 = t53 * C1_12_IBxz;
    const float M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const float M_22_IHxz = t262 + t262;
    const float K2_22_h_spin_R = cos_lam * t176;
    const float M_11_rF = t91 + t91;
    const float t284 = t107 + t107;
    const float M_22_rF = sin_lam * t284;
    const float t286 = t84 * h_spin_R;
    const float t287 = p->mF - t286;
    const float C1_12_rF = wz_delta2_delta * t287;
    const float C1_21_rF = wz_delta2_delta * t286;
    const float K0_12_rF = p->mF * sin_lam;
    const float t291 = wz_delta2_delta * K0_12_rF;
    const float t292 = sin_lam * K0_12_rF;
    const float t293 = C1_12_IBxz * t287;
    const float K2_22_rF = K2_22_h_spin_R * t287;
    const float t295 = p->rF * K0_12_mF;
    const float t296 = p->rF * M_22_IHxx;
    const float M_22_mF = p->rF * t296;
    const float C1_12_mF = p->rF * wz_delta2_delta;
    const float t299 = sin_lam * C1_12_mF;
    const float t300 = p->rF * C1_12_IBxz;
    const float K2_22_mF = C1_12_IBxz * K0_12_mF;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float C1_12_IFyy = wz_delta2_delta * t84;
    const float t304 = C1_12_IBxz * t84;
    const float K2_22_IFyy = t84 * K2_22_h_spin_R;
    const float M_12 = -(t39 + (yaw_by_delta * t44) + (p->zH * t54));
    const float C1_21 = -t90;
    const float C1_22 = -(cos_lam * t120);
    const float K0_22 = -(sin_lam * K0_12);
    const float K2_12 = -C1_12_c;
    const float K0_22_lam = -((sin_lam * K0_12_lam) + (cos_lam * K0_12));
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
    derivatives->values[2] = t140;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = t151;
    derivatives->values[5] = t154;
    derivatives->values[6] = K0_22_w;
    derivatives->values[7] = K2_12_w;
    derivatives->values[8] = t159;
    derivatives->values[9] = t160;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = C1_12_c;
    derivatives->values[12] = t87;
    derivatives->values[13] = t171;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = t173;
    derivatives->values[16] = K2_22_c;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t199;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = K2_12_lam;
    derivatives->values[25] = K2_22_lam;
    derivatives->values[26] = M_11_rR;
    derivatives->values[27] = C1_12_rR;
    derivatives->values[28] = C1_21_rR;
    derivatives->values[29] = p->mR;
    derivatives->values[30] = t226;
    derivatives->values[31] = M_11_mR;
    derivatives->values[32] = C1_12_mR;
    derivatives->values[33] = p->rR;
    derivatives->values[34] = t231;
    derivatives->values[35] = 1.0F;
    derivatives->values[36] = M_22_IRxx;
    derivatives->values[37] = t59;
    derivatives->values[38] = C1_12_IRyy;
    derivatives->values[39] = t233;
    derivatives->values[40] = M_12_xB;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t237;
    derivatives->values[43] = t241;
    derivatives->values[44] = K0_12_xB;
    derivatives->values[45] = t242;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = M_12_zB;
    derivatives->values[49] = t239;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = K2_12_zB;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = M_12_mB;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t249;
    derivatives->values[56] = t251;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = K0_12_mB;
    derivatives->values[59] = t252;
    derivatives->values[60] = K2_12_mB;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = yaw_by_delta;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = M_12_xH;
    derivatives->values[65] = t255;
    derivatives->values[66] = t256;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = K0_12_xH;
    derivatives->values[69] = t263;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = t267;
    derivatives->values[73] = M_22_zH;
    derivatives->values[74] = t259;
    derivatives->values[75] = C1_22_zH;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = t179;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = K2_12_zH;
    derivatives->values[80] = t272;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = t274;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t275;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = t53;
    derivatives->values[88] = K0_22_mH;
    derivatives->values[89] = K2_12_mH;
    derivatives->values[90] = t279;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_IHxx;
    derivatives->values[93] = M_22_IHzz;
    derivatives->values[94] = t264;
    derivatives->values[95] = wz_delta2_delta;
    derivatives->values[96] = M_22_IHxz;
    derivatives->values[97] = K2_22_h_spin_R;
    derivatives->values[98] = M_11_rF;
    derivatives->values[99] = t284;
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = t291;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = K0_12_rF;
    derivatives->values[106] = t292;
    derivatives->values[107] = t293;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = t295;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = t299;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = t296;
    derivatives->values[117] = t300;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t304;
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
