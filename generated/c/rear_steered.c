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
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 1U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 2U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 3U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 4U, false},
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
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 13U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 14U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 14U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 15U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 16U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 17U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 17U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 18U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 19U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 20U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 21U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 22U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 22U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 23U, true},
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
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 87U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 87U, false},
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
    const double t2 = p->zH * p->mH;
    const double t7 = p->rF * p->mF;
    const double t11 = p->IHxx + ((p->rF * t7) + p->IFxx);
    const double t14 = p->rR * p->mR;
    const double t18 = p->zB * p->mB;
    const double M_11 = (p->zH * t2) + (t11 + ((p->rR * t14) + ((p->zB * t18) + p->IRxx +
        p->IBxx)));
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t31 = 1.0 / p->w;
    const double t32 = cos_lam * t31;
    const double yaw_by_delta = p->c * t32;
    const double wz_delta2_delta = cos_lam + yaw_by_delta;
    const double t39 = (wz_delta2_delta * p->IHxz) + (t11 * sin_lam);
    const double t43 = (t18 * p->xB) - p->IBxz;
    const double t52 = (p->zH * sin_lam) + (cos_lam * (p->c + p->w)) - (wz_delta2_delta * p->xH);
    const double t53 = p->mH * t52;
    const double M_12 = (yaw_by_delta * t43) - t39 - (p->zH * t53);
    const double t59 = p->mB * p->xB;
    const double t62 = yaw_by_delta * (p->IRxx + p->IBzz + (t59 * p->xB));
    const double t69 = (p->IHxz * sin_lam) + (wz_delta2_delta * (p->IFxx + p->IHzz));
    const double M_22 = (t53 * t52) + (yaw_by_delta * t62) + ((wz_delta2_delta * t69) + (sin_lam *
        t39));
    const double h_spin_R = p->IFyy / p->rF;
    const double K0_11 = t18 + t2 - (t7 + t14);
    const double t84 = p->IRyy / p->rR;
    const double t85 = K0_11 - h_spin_R - t84;
    const double t91 = t7 + h_spin_R - (t31 * ((t2 * p->xH) + ((p->c * t85) + t43) - p->IHxz));
    const double C1_12 = t91 * cos_lam;
    const double t96 = t7 * sin_lam;
    const double t101 = t96 + (yaw_by_delta * t59);
    const double t102 = t53 - t101;
    const double C1_22 = cos_lam * ((t31 * ((p->xH * t53) - (t62 + t69) + (p->c * t102))) - t96);
    const double K0_22 = sin_lam * t102;
    const double K2_12 = t32 * t85;
    const double K2_22 = t32 * ((sin_lam * h_spin_R) - t102);
    const double C1_21 = -((yaw_by_delta * t84) + (wz_delta2_delta * h_spin_R));
    const double K0_12 = t101 - t53;
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
    const double t2 = p->zH * p->mH;
    const double M_11_mB = p->zB * p->zB;
    const double t11 = p->rR * p->mR;
    const double t18 = p->rF * p->mF;
    const double t21 = p->IFxx + p->IHxx + (p->rF * t18);
    const double M_11 = (p->zH * t2) + p->IRxx + (p->mB * M_11_mB) + (p->rR * t11) + p->IBxx + t21;
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t29 = p->zH * sin_lam;
    const double t35 = p->xH - p->c - p->w;
    const double t37 = t29 - (cos_lam * t35);
    const double t38 = 1.0 / p->w;
    const double C1_12_IBxz = cos_lam * t38;
    const double yaw_by_delta = p->c * C1_12_IBxz;
    const double t41 = p->xH * yaw_by_delta;
    const double t42 = t37 - t41;
    const double wz_delta2_delta = cos_lam + yaw_by_delta;
    const double t48 = (t21 * sin_lam) + (wz_delta2_delta * p->IHxz);
    const double t51 = p->mB * p->xB;
    const double t53 = p->IBxz - (p->zB * t51);
    const double t58 = sin_lam * p->IHxz;
    const double t60 = p->IFxx + p->IHzz;
    const double t62 = t58 + (wz_delta2_delta * t60);
    const double t67 = p->IRxx + (p->xB * t51) + p->IBzz;
    const double t68 = C1_12_IBxz * yaw_by_delta;
    const double M_22_IRxx = p->c * t68;
    const double t71 = p->mH * t42;
    const double M_22 = (sin_lam * t48) + (wz_delta2_delta * t62) + (t67 * M_22_IRxx) + (t42 * t71);
    const double t78 = 1.0 / p->rF;
    const double h_spin_R = p->IFyy * t78;
    const double t80 = p->IHxz + t53;
    const double t82 = 1.0 / p->rR;
    const double t83 = p->IRyy * t82;
    const double t84 = h_spin_R + t83;
    const double t85 = p->mB * p->zB;
    const double t87 = t2 + t85 - t18;
    const double t89 = t84 + (t11 - t87);
    const double t94 = t38 * (t80 + (p->c * t89) - (t2 * p->xH));
    const double t96 = t18 + h_spin_R + t94;
    const double C1_12 = cos_lam * t96;
    const double t98 = yaw_by_delta * t84;
    const double t99 = cos_lam * h_spin_R;
    const double K0_12_rF = p->mF * sin_lam;
    const double t102 = p->rF * K0_12_rF;
    const double K0_12_mB = yaw_by_delta * p->xB;
    const double M_12_zB = p->mB * K0_12_mB;
    const double K0_12 = t102 + M_12_zB - t71;
    const double t110 = t62 + (yaw_by_delta * t67);
    const double t113 = t38 * ((p->c * K0_12) + t110 - (p->xH * t71));
    const double t114 = t102 + t113;
    const double C1_12_c = C1_12_IBxz * t89;
    const double t118 = sin_lam * h_spin_R;
    const double t119 = K0_12 + t118;
    const double K2_22 = C1_12_IBxz * t119;
    const double t122 = cos_lam + (t38 * t41);
    const double t124 = t38 * yaw_by_delta;
    const double M_12_w = (t80 * t124) - (t2 * t122);
    const double t129 = (t110 * t124) - (t71 * t122);
    const double t130 = t129 + t129;
    const double t131 = C1_12_IBxz * t94;
    const double C1_21_w = t38 * t98;
    const double t135 = M_12_zB + (C1_12_IBxz * (t60 + t67));
    const double t138 = p->mH * t122;
    const double t139 = p->xH * C1_12_IBxz;
    const double t140 = yaw_by_delta + t139;
    const double C1_22_w = (t124 * t135) + (C1_12_IBxz * t113) + (t138 * t140);
    const double t145 = t138 + (t51 * t124);
    const double K0_22_w = sin_lam * t145;
    const double K2_12_w = t38 * C1_12_c;
    const double t151 = C1_12_IBxz * (t138 + (t38 * (M_12_zB + t119)));
    const double t152 = cos_lam - t139;
    const double t153 = p->mH * t152;
    const double t156 = (p->zH * t153) + (C1_12_IBxz * t80);
    const double t159 = (t71 * t152) + (C1_12_IBxz * t110);
    const double M_22_c = t159 + t159;
    const double t161 = C1_12_IBxz * t84;
    const double C1_22_c = (t140 * t153) - (C1_12_IBxz * (K0_12 + t135));
    const double K2_12_zB = p->mB * C1_12_IBxz;
    const double K2_22_yaw_by_delta = p->xB * K2_12_zB;
    const double t168 = t153 - K2_22_yaw_by_delta;
    const double K0_22_c = sin_lam * t168;
    const double t170 = C1_12_IBxz * t168;
    const double t172 = sin_lam * t38;
    const double t173 = p->c * t172;
    const double t177 = p->zH * cos_lam;
    const double t179 = (sin_lam * t35) + (p->xH * t173) + t177;
    const double t183 = (t21 * cos_lam) + (t2 * t179) - t58 - (t80 * t173);
    const double t185 = p->mH * t179;
    const double t191 = (sin_lam * t62) + (t110 * t173) - (t42 * t185) - (cos_lam * t48);
    const double t192 = t191 + t191;
    const double t193 = sin_lam * t96;
    const double C1_21_lam = t118 + (t84 * t173);
    const double C1_12_mF = p->rF * wz_delta2_delta;
    const double t205 = p->mH * t140;
    const double C1_22_lam = (sin_lam * t114) + (t135 * t173) + (t179 * t205) - (cos_lam *
        ((C1_12_IBxz * p->IHxz) + (p->mF * C1_12_mF) - (t60 * t172)));
    const double K0_12_lam = (t18 * cos_lam) - t185 - (t51 * t173);
    const double t216 = (cos_lam * K0_12) + (sin_lam * K0_12_lam);
    const double K2_12_lam = t89 * t172;
    const double K2_22_lam = (C1_12_IBxz * (t99 + K0_12_lam)) - (t119 * t172);
    const double M_11_rR = t11 + t11;
    const double t223 = t82 * t83;
    const double t225 = C1_12_IBxz * (p->mR - t223);
    const double C1_12_rR = p->c * t225;
    const double C1_21_rR = yaw_by_delta * t223;
    const double M_11_mR = p->rR * p->rR;
    const double t229 = p->rR * C1_12_IBxz;
    const double C1_12_mR = p->c * t229;
    const double t232 = C1_12_IBxz * t82;
    const double C1_12_IRyy = p->c * t232;
    const double t234 = C1_12_IBxz * t85;
    const double M_12_xB = p->c * t234;
    const double t236 = yaw_by_delta * M_12_zB;
    const double M_22_xB = t236 + t236;
    const double t238 = p->c + p->xB;
    const double t239 = K2_12_zB * t238;
    const double t241 = yaw_by_delta * (K2_22_yaw_by_delta + t239);
    const double K0_12_xB = p->mB * yaw_by_delta;
    const double t243 = sin_lam * K0_12_xB;
    const double K2_22_xB = C1_12_IBxz * K0_12_xB;
    const double M_11_zB = t85 + t85;
    const double M_12_mB = p->zB * K0_12_mB;
    const double M_22_mB = K0_12_mB * K0_12_mB;
    const double K2_12_mB = p->zB * C1_12_IBxz;
    const double t249 = t238 * K2_12_mB;
    const double K2_22_mB = C1_12_IBxz * K0_12_mB;
    const double t251 = t238 * K2_22_mB;
    const double t252 = sin_lam * K0_12_mB;
    const double K0_12_xH = p->mH * wz_delta2_delta;
    const double M_12_xH = p->zH * K0_12_xH;
    const double t255 = t71 + t71;
    const double t256 = wz_delta2_delta * t255;
    const double K2_12_zH = p->mH * C1_12_IBxz;
    const double t258 = p->zH * K2_12_zH;
    const double C1_22_xH = (t42 * K2_12_zH) - (wz_delta2_delta * t205);
    const double t262 = sin_lam * wz_delta2_delta;
    const double t263 = p->mH * t262;
    const double t264 = C1_12_IBxz * wz_delta2_delta;
    const double K2_22_xH = p->mH * t264;
    const double M_11_zH = t2 + t2;
    const double t268 = p->mH * (t29 + t42);
    const double M_22_zH = sin_lam * t255;
    const double C1_22_zH = sin_lam * t205;
    const double t271 = p->mH * sin_lam;
    const double K0_22_zH = sin_lam * t271;
    const double t273 = C1_12_IBxz * t271;
    const double M_11_mH = p->zH * p->zH;
    const double t275 = p->zH * t42;
    const double M_22_mH = t42 * t42;
    const double t277 = p->zH * t140;
    const double C1_22_mH = t42 * t140;
    const double K0_22_mH = sin_lam * t42;
    const double K2_12_mH = t38 * t177;
    const double t281 = C1_12_IBxz * t42;
    const double M_22_IHxx = sin_lam * sin_lam;
    const double M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const double M_22_IHxz = t262 + t262;
    const double K2_22_h_spin_R = cos_lam * t172;
    const double M_11_rF = t18 + t18;
    const double t287 = t102 + t102;
    const double M_22_rF = sin_lam * t287;
    const double t289 = t78 * h_spin_R;
    const double t290 = p->mF - t289;
    const double C1_12_rF = wz_delta2_delta * t290;
    const double C1_21_rF = wz_delta2_delta * t289;
    const double t293 = p->mF * t262;
    const double t294 = sin_lam * K0_12_rF;
    const double t295 = C1_12_IBxz * t290;
    const double K2_22_rF = K2_22_h_spin_R * t290;
    const double M_11_mF = p->rF * p->rF;
    const double K0_12_mF = p->rF * sin_lam;
    const double t299 = p->rF * K0_12_mF;
    const double M_22_mF = sin_lam * t299;
    const double t301 = wz_delta2_delta * K0_12_mF;
    const double t302 = sin_lam * K0_12_mF;
    const double t303 = p->rF * C1_12_IBxz;
    const double K2_22_mF = p->rF * K2_22_h_spin_R;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double C1_12_IFyy = wz_delta2_delta * t78;
    const double t307 = C1_12_IBxz * t78;
    const double K2_22_IFyy = t78 * K2_22_h_spin_R;
    const double M_12 = -((t2 * t42) + t48 + (yaw_by_delta * t53));
    const double C1_21 = -(t98 + t99);
    const double C1_22 = -(cos_lam * t114);
    const double K0_11 = t87 - t11;
    const double K0_22 = -(sin_lam * K0_12);
    const double K2_12 = -C1_12_c;
    const double K0_12_c = K2_22_yaw_by_delta - t153;
    const double K0_12_mH = t41 - t37;
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
    derivatives->values[1] = t130;
    derivatives->values[2] = t131;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = t145;
    derivatives->values[6] = K0_22_w;
    derivatives->values[7] = K2_12_w;
    derivatives->values[8] = t151;
    derivatives->values[9] = t156;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = C1_12_c;
    derivatives->values[12] = t161;
    derivatives->values[13] = C1_22_c;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t170;
    derivatives->values[17] = t183;
    derivatives->values[18] = t192;
    derivatives->values[19] = t193;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = t216;
    derivatives->values[24] = K2_12_lam;
    derivatives->values[25] = K2_22_lam;
    derivatives->values[26] = M_11_rR;
    derivatives->values[27] = C1_12_rR;
    derivatives->values[28] = C1_21_rR;
    derivatives->values[29] = p->mR;
    derivatives->values[30] = t225;
    derivatives->values[31] = M_11_mR;
    derivatives->values[32] = C1_12_mR;
    derivatives->values[33] = p->rR;
    derivatives->values[34] = t229;
    derivatives->values[35] = 1.0;
    derivatives->values[36] = M_22_IRxx;
    derivatives->values[37] = t68;
    derivatives->values[38] = C1_12_IRyy;
    derivatives->values[39] = t232;
    derivatives->values[40] = M_12_xB;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t234;
    derivatives->values[43] = t241;
    derivatives->values[44] = K0_12_xB;
    derivatives->values[45] = t243;
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
    derivatives->values[65] = t256;
    derivatives->values[66] = t258;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = K0_12_xH;
    derivatives->values[69] = t263;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = t268;
    derivatives->values[73] = M_22_zH;
    derivatives->values[74] = t205;
    derivatives->values[75] = C1_22_zH;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = t271;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = K2_12_zH;
    derivatives->values[80] = t273;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = t275;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t277;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = K0_22_mH;
    derivatives->values[89] = K2_12_mH;
    derivatives->values[90] = t281;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_IHxx;
    derivatives->values[93] = M_22_IHzz;
    derivatives->values[94] = t264;
    derivatives->values[95] = wz_delta2_delta;
    derivatives->values[96] = M_22_IHxz;
    derivatives->values[97] = K2_22_h_spin_R;
    derivatives->values[98] = M_11_rF;
    derivatives->values[99] = t287;
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = t293;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = K0_12_rF;
    derivatives->values[106] = t294;
    derivatives->values[107] = t295;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = t299;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = t301;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = t302;
    derivatives->values[117] = t303;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t307;
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
    const float t2 = p->zH * p->mH;
    const float t7 = p->rF * p->mF;
    const float t11 = p->IHxx + ((p->rF * t7) + p->IFxx);
    const float t14 = p->rR * p->mR;
    const float t18 = p->zB * p->mB;
    const float M_11 = (p->zH * t2) + (t11 + ((p->rR * t14) + ((p->zB * t18) + p->IRxx + p->IBxx)));
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t31 = 1.0F / p->w;
    const float t32 = cos_lam * t31;
    const float yaw_by_delta = p->c * t32;
    const float wz_delta2_delta = cos_lam + yaw_by_delta;
    const float t39 = (wz_delta2_delta * p->IHxz) + (t11 * sin_lam);
    const float t43 = (t18 * p->xB) - p->IBxz;
    const float t52 = (p->zH * sin_lam) + (cos_lam * (p->c + p->w)) - (wz_delta2_delta * p->xH);
    const float t53 = p->mH * t52;
    const float M_12 = (yaw_by_delta * t43) - t39 - (p->zH * t53);
    const float t59 = p->mB * p->xB;
    const float t62 = yaw_by_delta * (p->IRxx + p->IBzz + (t59 * p->xB));
    const float t69 = (p->IHxz * sin_lam) + (wz_delta2_delta * (p->IFxx + p->IHzz));
    const float M_22 = (t53 * t52) + (yaw_by_delta * t62) + ((wz_delta2_delta * t69) + (sin_lam *
        t39));
    const float h_spin_R = p->IFyy / p->rF;
    const float K0_11 = t18 + t2 - (t7 + t14);
    const float t84 = p->IRyy / p->rR;
    const float t85 = K0_11 - h_spin_R - t84;
    const float t91 = t7 + h_spin_R - (t31 * ((t2 * p->xH) + ((p->c * t85) + t43) - p->IHxz));
    const float C1_12 = t91 * cos_lam;
    const float t96 = t7 * sin_lam;
    const float t101 = t96 + (yaw_by_delta * t59);
    const float t102 = t53 - t101;
    const float C1_22 = cos_lam * ((t31 * ((p->xH * t53) - (t62 + t69) + (p->c * t102))) - t96);
    const float K0_22 = sin_lam * t102;
    const float K2_12 = t32 * t85;
    const float K2_22 = t32 * ((sin_lam * h_spin_R) - t102);
    const float C1_21 = -((yaw_by_delta * t84) + (wz_delta2_delta * h_spin_R));
    const float K0_12 = t101 - t53;
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
    const float t2 = p->zH * p->mH;
    const float M_11_mB = p->zB * p->zB;
    const float t11 = p->rR * p->mR;
    const float t18 = p->rF * p->mF;
    const float t21 = p->IFxx + p->IHxx + (p->rF * t18);
    const float M_11 = (p->zH * t2) + p->IRxx + (p->mB * M_11_mB) + (p->rR * t11) + p->IBxx + t21;
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t29 = p->zH * sin_lam;
    const float t35 = p->xH - p->c - p->w;
    const float t37 = t29 - (cos_lam * t35);
    const float t38 = 1.0F / p->w;
    const float C1_12_IBxz = cos_lam * t38;
    const float yaw_by_delta = p->c * C1_12_IBxz;
    const float t41 = p->xH * yaw_by_delta;
    const float t42 = t37 - t41;
    const float wz_delta2_delta = cos_lam + yaw_by_delta;
    const float t48 = (t21 * sin_lam) + (wz_delta2_delta * p->IHxz);
    const float t51 = p->mB * p->xB;
    const float t53 = p->IBxz - (p->zB * t51);
    const float t58 = sin_lam * p->IHxz;
    const float t60 = p->IFxx + p->IHzz;
    const float t62 = t58 + (wz_delta2_delta * t60);
    const float t67 = p->IRxx + (p->xB * t51) + p->IBzz;
    const float t68 = C1_12_IBxz * yaw_by_delta;
    const float M_22_IRxx = p->c * t68;
    const float t71 = p->mH * t42;
    const float M_22 = (sin_lam * t48) + (wz_delta2_delta * t62) + (t67 * M_22_IRxx) + (t42 * t71);
    const float t78 = 1.0F / p->rF;
    const float h_spin_R = p->IFyy * t78;
    const float t80 = p->IHxz + t53;
    const float t82 = 1.0F / p->rR;
    const float t83 = p->IRyy * t82;
    const float t84 = h_spin_R + t83;
    const float t85 = p->mB * p->zB;
    const float t87 = t2 + t85 - t18;
    const float t89 = t84 + (t11 - t87);
    const float t94 = t38 * (t80 + (p->c * t89) - (t2 * p->xH));
    const float t96 = t18 + h_spin_R + t94;
    const float C1_12 = cos_lam * t96;
    const float t98 = yaw_by_delta * t84;
    const float t99 = cos_lam * h_spin_R;
    const float K0_12_rF = p->mF * sin_lam;
    const float t102 = p->rF * K0_12_rF;
    const float K0_12_mB = yaw_by_delta * p->xB;
    const float M_12_zB = p->mB * K0_12_mB;
    const float K0_12 = t102 + M_12_zB - t71;
    const float t110 = t62 + (yaw_by_delta * t67);
    const float t113 = t38 * ((p->c * K0_12) + t110 - (p->xH * t71));
    const float t114 = t102 + t113;
    const float C1_12_c = C1_12_IBxz * t89;
    const float t118 = sin_lam * h_spin_R;
    const float t119 = K0_12 + t118;
    const float K2_22 = C1_12_IBxz * t119;
    const float t122 = cos_lam + (t38 * t41);
    const float t124 = t38 * yaw_by_delta;
    const float M_12_w = (t80 * t124) - (t2 * t122);
    const float t129 = (t110 * t124) - (t71 * t122);
    const float t130 = t129 + t129;
    const float t131 = C1_12_IBxz * t94;
    const float C1_21_w = t38 * t98;
    const float t135 = M_12_zB + (C1_12_IBxz * (t60 + t67));
    const float t138 = p->mH * t122;
    const float t139 = p->xH * C1_12_IBxz;
    const float t140 = yaw_by_delta + t139;
    const float C1_22_w = (t124 * t135) + (C1_12_IBxz * t113) + (t138 * t140);
    const float t145 = t138 + (t51 * t124);
    const float K0_22_w = sin_lam * t145;
    const float K2_12_w = t38 * C1_12_c;
    const float t151 = C1_12_IBxz * (t138 + (t38 * (M_12_zB + t119)));
    const float t152 = cos_lam - t139;
    const float t153 = p->mH * t152;
    const float t156 = (p->zH * t153) + (C1_12_IBxz * t80);
    const float t159 = (t71 * t152) + (C1_12_IBxz * t110);
    const float M_22_c = t159 + t159;
    const float t161 = C1_12_IBxz * t84;
    const float C1_22_c = (t140 * t153) - (C1_12_IBxz * (K0_12 + t135));
    const float K2_12_zB = p->mB * C1_12_IBxz;
    const float K2_22_yaw_by_delta = p->xB * K2_12_zB;
    const float t168 = t153 - K2_22_yaw_by_delta;
    const float K0_22_c = sin_lam * t168;
    const float t170 = C1_12_IBxz * t168;
    const float t172 = sin_lam * t38;
    const float t173 = p->c * t172;
    const float t177 = p->zH * cos_lam;
    const float t179 = (sin_lam * t35) + (p->xH * t173) + t177;
    const float t183 = (t21 * cos_lam) + (t2 * t179) - t58 - (t80 * t173);
    const float t185 = p->mH * t179;
    const float t191 = (sin_lam * t62) + (t110 * t173) - (t42 * t185) - (cos_lam * t48);
    const float t192 = t191 + t191;
    const float t193 = sin_lam * t96;
    const float C1_21_lam = t118 + (t84 * t173);
    const float C1_12_mF = p->rF * wz_delta2_delta;
    const float t205 = p->mH * t140;
    const float C1_22_lam = (sin_lam * t114) + (t135 * t173) + (t179 * t205) - (cos_lam *
        ((C1_12_IBxz * p->IHxz) + (p->mF * C1_12_mF) - (t60 * t172)));
    const float K0_12_lam = (t18 * cos_lam) - t185 - (t51 * t173);
    const float t216 = (cos_lam * K0_12) + (sin_lam * K0_12_lam);
    const float K2_12_lam = t89 * t172;
    const float K2_22_lam = (C1_12_IBxz * (t99 + K0_12_lam)) - (t119 * t172);
    const float M_11_rR = t11 + t11;
    const float t223 = t82 * t83;
    const float t225 = C1_12_IBxz * (p->mR - t223);
    const float C1_12_rR = p->c * t225;
    const float C1_21_rR = yaw_by_delta * t223;
    const float M_11_mR = p->rR * p->rR;
    const float t229 = p->rR * C1_12_IBxz;
    const float C1_12_mR = p->c * t229;
    const float t232 = C1_12_IBxz * t82;
    const float C1_12_IRyy = p->c * t232;
    const float t234 = C1_12_IBxz * t85;
    const float M_12_xB = p->c * t234;
    const float t236 = yaw_by_delta * M_12_zB;
    const float M_22_xB = t236 + t236;
    const float t238 = p->c + p->xB;
    const float t239 = K2_12_zB * t238;
    const float t241 = yaw_by_delta * (K2_22_yaw_by_delta + t239);
    const float K0_12_xB = p->mB * yaw_by_delta;
    const float t243 = sin_lam * K0_12_xB;
    const float K2_22_xB = C1_12_IBxz * K0_12_xB;
    const float M_11_zB = t85 + t85;
    const float M_12_mB = p->zB * K0_12_mB;
    const float M_22_mB = K0_12_mB * K0_12_mB;
    const float K2_12_mB = p->zB * C1_12_IBxz;
    const float t249 = t238 * K2_12_mB;
    const float K2_22_mB = C1_12_IBxz * K0_12_mB;
    const float t251 = t238 * K2_22_mB;
    const float t252 = sin_lam * K0_12_mB;
    const float K0_12_xH = p->mH * wz_delta2_delta;
    const float M_12_xH = p->zH * K0_12_xH;
    const float t255 = t71 + t71;
    const float t256 = wz_delta2_delta * t255;
    const float K2_12_zH = p->mH * C1_12_IBxz;
    const float t258 = p->zH * K2_12_zH;
    const float C1_22_xH = (t42 * K2_12_zH) - (wz_delta2_delta * t205);
    const float t262 = sin_lam * wz_delta2_delta;
    const float t263 = p->mH * t262;
    const float t264 = C1_12_IBxz * wz_delta2_delta;
    const float K2_22_xH = p->mH * t264;
    const float M_11_zH = t2 + t2;
    const float t268 = p->mH * (t29 + t42);
    const float M_22_zH = sin_lam * t255;
    const float C1_22_zH = sin_lam * t205;
    const float t271 = p->mH * sin_lam;
    const float K0_22_zH = sin_lam * t271;
    const float t273 = C1_12_IBxz * t271;
    const float M_11_mH = p->zH * p->zH;
    const float t275 = p->zH * t42;
    const float M_22_mH = t42 * t42;
    const float t277 = p->zH * t140;
    const float C1_22_mH = t42 * t140;
    const float K0_22_mH = sin_lam * t42;
    const float K2_12_mH = t38 * t177;
    const float t281 = C1_12_IBxz * t42;
    const float M_22_IHxx = sin_lam * sin_lam;
    const float M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const float M_22_IHxz = t262 + t262;
    const float K2_22_h_spin_R = cos_lam * t172;
    const float M_11_rF = t18 + t18;
    const float t287 = t102 + t102;
    const float M_22_rF = sin_lam * t287;
    const float t289 = t78 * h_spin_R;
    const float t290 = p->mF - t289;
    const float C1_12_rF = wz_delta2_delta * t290;
    const float C1_21_rF = wz_delta2_delta * t289;
    const float t293 = p->mF * t262;
    const float t294 = sin_lam * K0_12_rF;
    const float t295 = C1_12_IBxz * t290;
    const float K2_22_rF = K2_22_h_spin_R * t290;
    const float M_11_mF = p->rF * p->rF;
    const float K0_12_mF = p->rF * sin_lam;
    const float t299 = p->rF * K0_12_mF;
    const float M_22_mF = sin_lam * t299;
    const float t301 = wz_delta2_delta * K0_12_mF;
    const float t302 = sin_lam * K0_12_mF;
    const float t303 = p->rF * C1_12_IBxz;
    const float K2_22_mF = p->rF * K2_22_h_spin_R;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float C1_12_IFyy = wz_delta2_delta * t78;
    const float t307 = C1_12_IBxz * t78;
    const float K2_22_IFyy = t78 * K2_22_h_spin_R;
    const float M_12 = -((t2 * t42) + t48 + (yaw_by_delta * t53));
    const float C1_21 = -(t98 + t99);
    const float C1_22 = -(cos_lam * t114);
    const float K0_11 = t87 - t11;
    const float K0_22 = -(sin_lam * K0_12);
    const float K2_12 = -C1_12_c;
    const float K0_12_c = K2_22_yaw_by_delta - t153;
    const float K0_12_mH = t41 - t37;
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
    derivatives->values[1] = t130;
    derivatives->values[2] = t131;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = t145;
    derivatives->values[6] = K0_22_w;
    derivatives->values[7] = K2_12_w;
    derivatives->values[8] = t151;
    derivatives->values[9] = t156;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = C1_12_c;
    derivatives->values[12] = t161;
    derivatives->values[13] = C1_22_c;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t170;
    derivatives->values[17] = t183;
    derivatives->values[18] = t192;
    derivatives->values[19] = t193;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = t216;
    derivatives->values[24] = K2_12_lam;
    derivatives->values[25] = K2_22_lam;
    derivatives->values[26] = M_11_rR;
    derivatives->values[27] = C1_12_rR;
    derivatives->values[28] = C1_21_rR;
    derivatives->values[29] = p->mR;
    derivatives->values[30] = t225;
    derivatives->values[31] = M_11_mR;
    derivatives->values[32] = C1_12_mR;
    derivatives->values[33] = p->rR;
    derivatives->values[34] = t229;
    derivatives->values[35] = 1.0F;
    derivatives->values[36] = M_22_IRxx;
    derivatives->values[37] = t68;
    derivatives->values[38] = C1_12_IRyy;
    derivatives->values[39] = t232;
    derivatives->values[40] = M_12_xB;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t234;
    derivatives->values[43] = t241;
    derivatives->values[44] = K0_12_xB;
    derivatives->values[45] = t243;
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
    derivatives->values[65] = t256;
    derivatives->values[66] = t258;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = K0_12_xH;
    derivatives->values[69] = t263;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = t268;
    derivatives->values[73] = M_22_zH;
    derivatives->values[74] = t205;
    derivatives->values[75] = C1_22_zH;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = t271;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = K2_12_zH;
    derivatives->values[80] = t273;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = t275;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t277;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = K0_22_mH;
    derivatives->values[89] = K2_12_mH;
    derivatives->values[90] = t281;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_IHxx;
    derivatives->values[93] = M_22_IHzz;
    derivatives->values[94] = t264;
    derivatives->values[95] = wz_delta2_delta;
    derivatives->values[96] = M_22_IHxz;
    derivatives->values[97] = K2_22_h_spin_R;
    derivatives->values[98] = M_11_rF;
    derivatives->values[99] = t287;
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = t293;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = K0_12_rF;
    derivatives->values[106] = t294;
    derivatives->values[107] = t295;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = t299;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = t301;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = t302;
    derivatives->values[117] = t303;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = t307;
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
