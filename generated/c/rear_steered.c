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
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 0U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 0U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 1U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 2U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 3U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 5U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 5U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 6U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 7U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 8U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 10U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 11U, true},
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
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 23U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 24U, true},
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
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 67U, true},
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
    const double t3 = p->zH * p->mH;
    const double t8 = p->rF * p->mF;
    const double t12 = p->IFxx + (p->zH * t3) + p->IHxx + (p->rF * t8);
    const double t17 = p->rR * p->mR;
    const double t21 = p->zB * p->mB;
    const double M_11 = t12 + p->IRxx + p->IBxx + (p->rR * t17) + (p->zB * t21);
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t31 = 1.0 / p->w;
    const double C1_12_IBxz = cos_lam * t31;
    const double yaw_by_delta = p->c * C1_12_IBxz;
    const double t39 = (t21 * p->xB) - p->IHxz - p->IBxz;
    const double t43 = p->c + p->w - p->xH;
    const double t45 = yaw_by_delta * p->xH;
    const double t46 = t45 - (cos_lam * t43);
    const double t49 = t12 * sin_lam;
    const double t50 = (t3 * t46) - t49;
    const double t51 = cos_lam * p->IHxz;
    const double M_12 = (yaw_by_delta * t39) + t50 - t51;
    const double wz_delta2_delta = cos_lam + yaw_by_delta;
    const double t55 = p->IHxz * sin_lam;
    const double t57 = p->IFxx + p->IHzz;
    const double t59 = t55 + (wz_delta2_delta * t57);
    const double t63 = p->mB * p->xB;
    const double t66 = p->IRxx + p->IBzz + (p->xB * t63);
    const double t67 = yaw_by_delta * t66;
    const double t69 = p->zH * sin_lam;
    const double K0_12_mH = t46 - t69;
    const double t71 = t69 - K0_12_mH;
    const double t72 = p->mH * t71;
    const double M_22 = (wz_delta2_delta * (t55 + t59)) + (yaw_by_delta * t67) + (sin_lam * t49) -
        (t46 * t72);
    const double K0_11 = t3 + t21 - t8 - t17;
    const double t85 = t39 + (p->c * K0_11) + (t3 * p->xH);
    const double t86 = C1_12_IBxz * t85;
    const double t88 = 1.0 / p->rF;
    const double h_spin_R = p->IFyy * t88;
    const double t91 = 1.0 / p->rR;
    const double t92 = p->IRyy * t91;
    const double t93 = h_spin_R + t92;
    const double t94 = yaw_by_delta * t93;
    const double t95 = cos_lam * h_spin_R;
    const double t96 = t94 + t95;
    const double t97 = t8 * cos_lam;
    const double C1_12 = t96 + t97 - t86;
    const double K0_12_mF = p->rF * sin_lam;
    const double t101 = p->mF * K0_12_mF;
    const double t102 = p->mH * K0_12_mH;
    const double M_22_wz_delta2_delta = p->xH * t102;
    const double t104 = C1_12_IBxz * t63;
    const double M_12_zB = p->c * t104;
    const double K0_12 = t101 + t102 + M_12_zB;
    const double t109 = t59 + t67;
    const double t112 = t31 * (M_22_wz_delta2_delta + (p->c * K0_12) + t109);
    const double t113 = t101 + t112;
    const double t116 = K0_11 - t93;
    const double K2_12 = C1_12_IBxz * t116;
    const double t118 = sin_lam * h_spin_R;
    const double t119 = K0_12 + t118;
    const double K2_22 = C1_12_IBxz * t119;
    const double t122 = cos_lam + (t31 * t45);
    const double t124 = t31 * yaw_by_delta;
    const double t126 = (t3 * t122) + (t39 * t124);
    const double M_22_yaw_by_delta = t109 + t109;
    const double t129 = t102 + t102;
    const double t131 = (t124 * M_22_yaw_by_delta) + (t122 * t129);
    const double C1_21_w = t31 * t94;
    const double C1_12_w = (t31 * t86) - C1_21_w;
    const double t135 = p->mH * t122;
    const double t136 = C1_12_IBxz * p->xH;
    const double t137 = yaw_by_delta + t136;
    const double t139 = t57 + t66;
    const double t141 = M_12_zB + (C1_12_IBxz * t139);
    const double C1_22_w = (t135 * t137) + (t124 * t141) + (C1_12_IBxz * t112);
    const double t147 = t135 + (t31 * M_12_zB);
    const double K0_22_w = sin_lam * t147;
    const double t149 = t31 * K2_12;
    const double t152 = C1_12_IBxz * (t147 + (t31 * t119));
    const double t154 = cos_lam - t136;
    const double M_12_c = (C1_12_IBxz * t39) - (t3 * t154);
    const double M_22_c = (C1_12_IBxz * M_22_yaw_by_delta) - (t129 * t154);
    const double t160 = C1_12_IBxz * t93;
    const double t161 = p->mH * t154;
    const double t162 = p->c + p->xH;
    const double t166 = C1_12_IBxz * (K0_12 + t141 - (t161 * t162));
    const double K0_12_c = t104 - t161;
    const double t171 = t31 * sin_lam;
    const double t172 = p->c * t171;
    const double t174 = (p->xH * t172) - (t43 * sin_lam);
    const double t177 = t12 * cos_lam;
    const double M_12_lam = t55 - (t3 * t174) - (t39 * t172) - t177;
    const double t181 = wz_delta2_delta + wz_delta2_delta;
    const double t185 = p->mH * t174;
    const double t188 = t185 + (t3 * cos_lam);
    const double t196 = (t71 * t185) - (cos_lam * (t50 - (p->IHxz * t181))) - (t46 * t188) -
        (sin_lam * (t59 + t59 - t177));
    const double M_22_lam = t196 - (M_22_yaw_by_delta * t172);
    const double C1_21_lam = t118 + (t93 * t172);
    const double t202 = t101 + C1_21_lam - (t85 * t171);
    const double ay_all1_delta = t139 * t171;
    const double K0_12_lam = t97 - t188 - (t63 * t172);
    const double t215 = t97 + (t31 * (t51 - (p->xH * t188) - (p->c * (ay_all1_delta - K0_12_lam)) -
        (sin_lam * t57)));
    const double C1_22_lam = (sin_lam * t113) - (cos_lam * t215);
    const double t221 = (sin_lam * K0_12_lam) + (cos_lam * K0_12);
    const double t222 = t116 * t171;
    const double K2_22_lam = (C1_12_IBxz * (t95 + K0_12_lam)) - (t119 * t171);
    const double M_11_rR = t17 + t17;
    const double t230 = C1_12_IBxz * (p->mR - (t91 * t92));
    const double C1_12_rR = p->c * t230;
    const double C1_12_IRyy = yaw_by_delta * t91;
    const double C1_21_rR = t92 * C1_12_IRyy;
    const double M_11_mR = p->rR * p->rR;
    const double C1_12_mR = p->rR * yaw_by_delta;
    const double t236 = p->rR * C1_12_IBxz;
    const double M_22_IRxx = yaw_by_delta * yaw_by_delta;
    const double t239 = cos_lam * t124;
    const double t240 = C1_12_IBxz * t91;
    const double K2_12_mB = p->zB * C1_12_IBxz;
    const double t242 = p->mB * K2_12_mB;
    const double M_12_xB = p->c * t242;
    const double M_22_xB = yaw_by_delta * (M_12_zB + M_12_zB);
    const double t246 = p->c + p->xB;
    const double K2_22_xB = p->mB * t239;
    const double t249 = (p->xB + t246) * K2_22_xB;
    const double K2_12_zB = p->mB * C1_12_IBxz;
    const double K0_12_xB = p->c * K2_12_zB;
    const double t252 = sin_lam * K0_12_xB;
    const double M_11_zB = t21 + t21;
    const double t254 = t104 + K0_12_xB;
    const double M_11_mB = p->zB * p->zB;
    const double K0_12_mB = yaw_by_delta * p->xB;
    const double M_12_mB = p->zB * K0_12_mB;
    const double M_22_mB = K0_12_mB * K0_12_mB;
    const double t259 = K2_12_mB * t246;
    const double K2_22_mB = C1_12_IBxz * K0_12_mB;
    const double t261 = t246 * K2_22_mB;
    const double t262 = sin_lam * K0_12_mB;
    const double M_12_xH = t3 * wz_delta2_delta;
    const double M_22_xH = t102 * t181;
    const double K2_12_zH = p->mH * C1_12_IBxz;
    const double t266 = p->zH * K2_12_zH;
    const double K0_12_xH = p->mH * wz_delta2_delta;
    const double t270 = (t137 * K0_12_xH) + (K0_12_mH * K2_12_zH);
    const double t271 = sin_lam * K0_12_xH;
    const double K2_22_xH = wz_delta2_delta * K2_12_zH;
    const double M_11_zH = t3 + t3;
    const double t274 = sin_lam * t129;
    const double t275 = p->mH * t137;
    const double C1_22_zH = sin_lam * t275;
    const double t277 = p->mH * sin_lam;
    const double K0_22_zH = sin_lam * t277;
    const double t279 = sin_lam * K2_12_zH;
    const double M_11_mH = p->zH * p->zH;
    const double M_12_mH = p->zH * K0_12_mH;
    const double M_22_mH = K0_12_mH * K0_12_mH;
    const double t283 = p->zH * t137;
    const double K2_22_mH = C1_12_IBxz * K0_12_mH;
    const double t285 = t162 * K2_22_mH;
    const double t286 = sin_lam * K0_12_mH;
    const double K2_12_mH = p->zH * C1_12_IBxz;
    const double M_22_ay_all1_delta = sin_lam * sin_lam;
    const double M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const double t290 = C1_12_IBxz * wz_delta2_delta;
    const double M_22_IHxz = sin_lam * t181;
    const double K2_22_h_spin_R = C1_12_IBxz * sin_lam;
    const double ay_all1_delta_rF = t8 + t8;
    const double t294 = t101 + t101;
    const double M_22_rF = sin_lam * t294;
    const double t296 = t88 * h_spin_R;
    const double t297 = p->mF - t296;
    const double C1_12_rF = wz_delta2_delta * t297;
    const double C1_21_rF = wz_delta2_delta * t296;
    const double K0_12_rF = p->mF * sin_lam;
    const double t301 = wz_delta2_delta * K0_12_rF;
    const double t302 = sin_lam * K0_12_rF;
    const double t303 = C1_12_IBxz * t297;
    const double K2_22_rF = K2_22_h_spin_R * t297;
    const double ay_all1_delta_mF = p->rF * p->rF;
    const double t306 = sin_lam * ay_all1_delta_mF;
    const double t307 = sin_lam * K0_12_mF;
    const double M_22_mF = p->rF * t307;
    const double C1_12_mF = p->rF * wz_delta2_delta;
    const double t310 = wz_delta2_delta * K0_12_mF;
    const double t311 = p->rF * C1_12_IBxz;
    const double K2_22_mF = C1_12_IBxz * K0_12_mF;
    const double M_22_IFxx = M_22_ay_all1_delta + M_22_IHzz;
    const double C1_12_IFyy = wz_delta2_delta * t88;
    const double t315 = C1_12_IBxz * t88;
    const double K2_22_IFyy = sin_lam * t315;
    const double C1_21 = -t96;
    const double C1_22 = -(cos_lam * t113);
    const double K0_22 = -(sin_lam * K0_12);
    const double K0_22_c = -(sin_lam * K0_12_c);
    const double t321 = -(C1_12_IBxz * K0_12_c);
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
    derivatives->values[0] = t126;
    derivatives->values[1] = t131;
    derivatives->values[2] = C1_12_w;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = t147;
    derivatives->values[6] = K0_22_w;
    derivatives->values[7] = t149;
    derivatives->values[8] = t152;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t160;
    derivatives->values[13] = t166;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t321;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t202;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = t221;
    derivatives->values[24] = t222;
    derivatives->values[25] = K2_22_lam;
    derivatives->values[26] = M_11_rR;
    derivatives->values[27] = C1_12_rR;
    derivatives->values[28] = C1_21_rR;
    derivatives->values[29] = p->mR;
    derivatives->values[30] = t230;
    derivatives->values[31] = M_11_mR;
    derivatives->values[32] = C1_12_mR;
    derivatives->values[33] = p->rR;
    derivatives->values[34] = t236;
    derivatives->values[35] = 1.0;
    derivatives->values[36] = M_22_IRxx;
    derivatives->values[37] = t239;
    derivatives->values[38] = C1_12_IRyy;
    derivatives->values[39] = t240;
    derivatives->values[40] = M_12_xB;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t242;
    derivatives->values[43] = t249;
    derivatives->values[44] = K0_12_xB;
    derivatives->values[45] = t252;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = M_12_zB;
    derivatives->values[49] = t254;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = K2_12_zB;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = M_12_mB;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t259;
    derivatives->values[56] = t261;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = K0_12_mB;
    derivatives->values[59] = t262;
    derivatives->values[60] = K2_12_mB;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = yaw_by_delta;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = M_12_xH;
    derivatives->values[65] = M_22_xH;
    derivatives->values[66] = t266;
    derivatives->values[67] = t270;
    derivatives->values[68] = K0_12_xH;
    derivatives->values[69] = t271;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = t72;
    derivatives->values[73] = t274;
    derivatives->values[74] = t275;
    derivatives->values[75] = C1_22_zH;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = t277;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = K2_12_zH;
    derivatives->values[80] = t279;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = M_12_mH;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t283;
    derivatives->values[85] = t285;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = t286;
    derivatives->values[89] = K2_12_mH;
    derivatives->values[90] = K2_22_mH;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_ay_all1_delta;
    derivatives->values[93] = M_22_IHzz;
    derivatives->values[94] = t290;
    derivatives->values[95] = wz_delta2_delta;
    derivatives->values[96] = M_22_IHxz;
    derivatives->values[97] = K2_22_h_spin_R;
    derivatives->values[98] = ay_all1_delta_rF;
    derivatives->values[99] = t294;
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = t301;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = K0_12_rF;
    derivatives->values[106] = t302;
    derivatives->values[107] = t303;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = ay_all1_delta_mF;
    derivatives->values[110] = t306;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = t310;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = t307;
    derivatives->values[117] = t311;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t315;
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
    const float t3 = p->zH * p->mH;
    const float t8 = p->rF * p->mF;
    const float t12 = p->IFxx + (p->zH * t3) + p->IHxx + (p->rF * t8);
    const float t17 = p->rR * p->mR;
    const float t21 = p->zB * p->mB;
    const float M_11 = t12 + p->IRxx + p->IBxx + (p->rR * t17) + (p->zB * t21);
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t31 = 1.0F / p->w;
    const float C1_12_IBxz = cos_lam * t31;
    const float yaw_by_delta = p->c * C1_12_IBxz;
    const float t39 = (t21 * p->xB) - p->IHxz - p->IBxz;
    const float t43 = p->c + p->w - p->xH;
    const float t45 = yaw_by_delta * p->xH;
    const float t46 = t45 - (cos_lam * t43);
    const float t49 = t12 * sin_lam;
    const float t50 = (t3 * t46) - t49;
    const float t51 = cos_lam * p->IHxz;
    const float M_12 = (yaw_by_delta * t39) + t50 - t51;
    const float wz_delta2_delta = cos_lam + yaw_by_delta;
    const float t55 = p->IHxz * sin_lam;
    const float t57 = p->IFxx + p->IHzz;
    const float t59 = t55 + (wz_delta2_delta * t57);
    const float t63 = p->mB * p->xB;
    const float t66 = p->IRxx + p->IBzz + (p->xB * t63);
    const float t67 = yaw_by_delta * t66;
    const float t69 = p->zH * sin_lam;
    const float K0_12_mH = t46 - t69;
    const float t71 = t69 - K0_12_mH;
    const float t72 = p->mH * t71;
    const float M_22 = (wz_delta2_delta * (t55 + t59)) + (yaw_by_delta * t67) + (sin_lam * t49) -
        (t46 * t72);
    const float K0_11 = t3 + t21 - t8 - t17;
    const float t85 = t39 + (p->c * K0_11) + (t3 * p->xH);
    const float t86 = C1_12_IBxz * t85;
    const float t88 = 1.0F / p->rF;
    const float h_spin_R = p->IFyy * t88;
    const float t91 = 1.0F / p->rR;
    const float t92 = p->IRyy * t91;
    const float t93 = h_spin_R + t92;
    const float t94 = yaw_by_delta * t93;
    const float t95 = cos_lam * h_spin_R;
    const float t96 = t94 + t95;
    const float t97 = t8 * cos_lam;
    const float C1_12 = t96 + t97 - t86;
    const float K0_12_mF = p->rF * sin_lam;
    const float t101 = p->mF * K0_12_mF;
    const float t102 = p->mH * K0_12_mH;
    const float M_22_wz_delta2_delta = p->xH * t102;
    const float t104 = C1_12_IBxz * t63;
    const float M_12_zB = p->c * t104;
    const float K0_12 = t101 + t102 + M_12_zB;
    const float t109 = t59 + t67;
    const float t112 = t31 * (M_22_wz_delta2_delta + (p->c * K0_12) + t109);
    const float t113 = t101 + t112;
    const float t116 = K0_11 - t93;
    const float K2_12 = C1_12_IBxz * t116;
    const float t118 = sin_lam * h_spin_R;
    const float t119 = K0_12 + t118;
    const float K2_22 = C1_12_IBxz * t119;
    const float t122 = cos_lam + (t31 * t45);
    const float t124 = t31 * yaw_by_delta;
    const float t126 = (t3 * t122) + (t39 * t124);
    const float M_22_yaw_by_delta = t109 + t109;
    const float t129 = t102 + t102;
    const float t131 = (t124 * M_22_yaw_by_delta) + (t122 * t129);
    const float C1_21_w = t31 * t94;
    const float C1_12_w = (t31 * t86) - C1_21_w;
    const float t135 = p->mH * t122;
    const float t136 = C1_12_IBxz * p->xH;
    const float t137 = yaw_by_delta + t136;
    const float t139 = t57 + t66;
    const float t141 = M_12_zB + (C1_12_IBxz * t139);
    const float C1_22_w = (t135 * t137) + (t124 * t141) + (C1_12_IBxz * t112);
    const float t147 = t135 + (t31 * M_12_zB);
    const float K0_22_w = sin_lam * t147;
    const float t149 = t31 * K2_12;
    const float t152 = C1_12_IBxz * (t147 + (t31 * t119));
    const float t154 = cos_lam - t136;
    const float M_12_c = (C1_12_IBxz * t39) - (t3 * t154);
    const float M_22_c = (C1_12_IBxz * M_22_yaw_by_delta) - (t129 * t154);
    const float t160 = C1_12_IBxz * t93;
    const float t161 = p->mH * t154;
    const float t162 = p->c + p->xH;
    const float t166 = C1_12_IBxz * (K0_12 + t141 - (t161 * t162));
    const float K0_12_c = t104 - t161;
    const float t171 = t31 * sin_lam;
    const float t172 = p->c * t171;
    const float t174 = (p->xH * t172) - (t43 * sin_lam);
    const float t177 = t12 * cos_lam;
    const float M_12_lam = t55 - (t3 * t174) - (t39 * t172) - t177;
    const float t181 = wz_delta2_delta + wz_delta2_delta;
    const float t185 = p->mH * t174;
    const float t188 = t185 + (t3 * cos_lam);
    const float t196 = (t71 * t185) - (cos_lam * (t50 - (p->IHxz * t181))) - (t46 * t188) -
        (sin_lam * (t59 + t59 - t177));
    const float M_22_lam = t196 - (M_22_yaw_by_delta * t172);
    const float C1_21_lam = t118 + (t93 * t172);
    const float t202 = t101 + C1_21_lam - (t85 * t171);
    const float ay_all1_delta = t139 * t171;
    const float K0_12_lam = t97 - t188 - (t63 * t172);
    const float t215 = t97 + (t31 * (t51 - (p->xH * t188) - (p->c * (ay_all1_delta - K0_12_lam)) -
        (sin_lam * t57)));
    const float C1_22_lam = (sin_lam * t113) - (cos_lam * t215);
    const float t221 = (sin_lam * K0_12_lam) + (cos_lam * K0_12);
    const float t222 = t116 * t171;
    const float K2_22_lam = (C1_12_IBxz * (t95 + K0_12_lam)) - (t119 * t171);
    const float M_11_rR = t17 + t17;
    const float t230 = C1_12_IBxz * (p->mR - (t91 * t92));
    const float C1_12_rR = p->c * t230;
    const float C1_12_IRyy = yaw_by_delta * t91;
    const float C1_21_rR = t92 * C1_12_IRyy;
    const float M_11_mR = p->rR * p->rR;
    const float C1_12_mR = p->rR * yaw_by_delta;
    const float t236 = p->rR * C1_12_IBxz;
    const float M_22_IRxx = yaw_by_delta * yaw_by_delta;
    const float t239 = cos_lam * t124;
    const float t240 = C1_12_IBxz * t91;
    const float K2_12_mB = p->zB * C1_12_IBxz;
    const float t242 = p->mB * K2_12_mB;
    const float M_12_xB = p->c * t242;
    const float M_22_xB = yaw_by_delta * (M_12_zB + M_12_zB);
    const float t246 = p->c + p->xB;
    const float K2_22_xB = p->mB * t239;
    const float t249 = (p->xB + t246) * K2_22_xB;
    const float K2_12_zB = p->mB * C1_12_IBxz;
    const float K0_12_xB = p->c * K2_12_zB;
    const float t252 = sin_lam * K0_12_xB;
    const float M_11_zB = t21 + t21;
    const float t254 = t104 + K0_12_xB;
    const float M_11_mB = p->zB * p->zB;
    const float K0_12_mB = yaw_by_delta * p->xB;
    const float M_12_mB = p->zB * K0_12_mB;
    const float M_22_mB = K0_12_mB * K0_12_mB;
    const float t259 = K2_12_mB * t246;
    const float K2_22_mB = C1_12_IBxz * K0_12_mB;
    const float t261 = t246 * K2_22_mB;
    const float t262 = sin_lam * K0_12_mB;
    const float M_12_xH = t3 * wz_delta2_delta;
    const float M_22_xH = t102 * t181;
    const float K2_12_zH = p->mH * C1_12_IBxz;
    const float t266 = p->zH * K2_12_zH;
    const float K0_12_xH = p->mH * wz_delta2_delta;
    const float t270 = (t137 * K0_12_xH) + (K0_12_mH * K2_12_zH);
    const float t271 = sin_lam * K0_12_xH;
    const float K2_22_xH = wz_delta2_delta * K2_12_zH;
    const float M_11_zH = t3 + t3;
    const float t274 = sin_lam * t129;
    const float t275 = p->mH * t137;
    const float C1_22_zH = sin_lam * t275;
    const float t277 = p->mH * sin_lam;
    const float K0_22_zH = sin_lam * t277;
    const float t279 = sin_lam * K2_12_zH;
    const float M_11_mH = p->zH * p->zH;
    const float M_12_mH = p->zH * K0_12_mH;
    const float M_22_mH = K0_12_mH * K0_12_mH;
    const float t283 = p->zH * t137;
    const float K2_22_mH = C1_12_IBxz * K0_12_mH;
    const float t285 = t162 * K2_22_mH;
    const float t286 = sin_lam * K0_12_mH;
    const float K2_12_mH = p->zH * C1_12_IBxz;
    const float M_22_ay_all1_delta = sin_lam * sin_lam;
    const float M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const float t290 = C1_12_IBxz * wz_delta2_delta;
    const float M_22_IHxz = sin_lam * t181;
    const float K2_22_h_spin_R = C1_12_IBxz * sin_lam;
    const float ay_all1_delta_rF = t8 + t8;
    const float t294 = t101 + t101;
    const float M_22_rF = sin_lam * t294;
    const float t296 = t88 * h_spin_R;
    const float t297 = p->mF - t296;
    const float C1_12_rF = wz_delta2_delta * t297;
    const float C1_21_rF = wz_delta2_delta * t296;
    const float K0_12_rF = p->mF * sin_lam;
    const float t301 = wz_delta2_delta * K0_12_rF;
    const float t302 = sin_lam * K0_12_rF;
    const float t303 = C1_12_IBxz * t297;
    const float K2_22_rF = K2_22_h_spin_R * t297;
    const float ay_all1_delta_mF = p->rF * p->rF;
    const float t306 = sin_lam * ay_all1_delta_mF;
    const float t307 = sin_lam * K0_12_mF;
    const float M_22_mF = p->rF * t307;
    const float C1_12_mF = p->rF * wz_delta2_delta;
    const float t310 = wz_delta2_delta * K0_12_mF;
    const float t311 = p->rF * C1_12_IBxz;
    const float K2_22_mF = C1_12_IBxz * K0_12_mF;
    const float M_22_IFxx = M_22_ay_all1_delta + M_22_IHzz;
    const float C1_12_IFyy = wz_delta2_delta * t88;
    const float t315 = C1_12_IBxz * t88;
    const float K2_22_IFyy = sin_lam * t315;
    const float C1_21 = -t96;
    const float C1_22 = -(cos_lam * t113);
    const float K0_22 = -(sin_lam * K0_12);
    const float K0_22_c = -(sin_lam * K0_12_c);
    const float t321 = -(C1_12_IBxz * K0_12_c);
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
    derivatives->values[0] = t126;
    derivatives->values[1] = t131;
    derivatives->values[2] = C1_12_w;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = t147;
    derivatives->values[6] = K0_22_w;
    derivatives->values[7] = t149;
    derivatives->values[8] = t152;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t160;
    derivatives->values[13] = t166;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t321;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t202;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = t221;
    derivatives->values[24] = t222;
    derivatives->values[25] = K2_22_lam;
    derivatives->values[26] = M_11_rR;
    derivatives->values[27] = C1_12_rR;
    derivatives->values[28] = C1_21_rR;
    derivatives->values[29] = p->mR;
    derivatives->values[30] = t230;
    derivatives->values[31] = M_11_mR;
    derivatives->values[32] = C1_12_mR;
    derivatives->values[33] = p->rR;
    derivatives->values[34] = t236;
    derivatives->values[35] = 1.0F;
    derivatives->values[36] = M_22_IRxx;
    derivatives->values[37] = t239;
    derivatives->values[38] = C1_12_IRyy;
    derivatives->values[39] = t240;
    derivatives->values[40] = M_12_xB;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t242;
    derivatives->values[43] = t249;
    derivatives->values[44] = K0_12_xB;
    derivatives->values[45] = t252;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = M_12_zB;
    derivatives->values[49] = t254;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = K2_12_zB;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = M_12_mB;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t259;
    derivatives->values[56] = t261;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = K0_12_mB;
    derivatives->values[59] = t262;
    derivatives->values[60] = K2_12_mB;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = yaw_by_delta;
    derivatives->values[63] = C1_12_IBxz;
    derivatives->values[64] = M_12_xH;
    derivatives->values[65] = M_22_xH;
    derivatives->values[66] = t266;
    derivatives->values[67] = t270;
    derivatives->values[68] = K0_12_xH;
    derivatives->values[69] = t271;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = t72;
    derivatives->values[73] = t274;
    derivatives->values[74] = t275;
    derivatives->values[75] = C1_22_zH;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = t277;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = K2_12_zH;
    derivatives->values[80] = t279;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = M_12_mH;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t283;
    derivatives->values[85] = t285;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = t286;
    derivatives->values[89] = K2_12_mH;
    derivatives->values[90] = K2_22_mH;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_ay_all1_delta;
    derivatives->values[93] = M_22_IHzz;
    derivatives->values[94] = t290;
    derivatives->values[95] = wz_delta2_delta;
    derivatives->values[96] = M_22_IHxz;
    derivatives->values[97] = K2_22_h_spin_R;
    derivatives->values[98] = ay_all1_delta_rF;
    derivatives->values[99] = t294;
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = t301;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = K0_12_rF;
    derivatives->values[106] = t302;
    derivatives->values[107] = t303;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = ay_all1_delta_mF;
    derivatives->values[110] = t306;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = t310;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = t307;
    derivatives->values[117] = t311;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t315;
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
