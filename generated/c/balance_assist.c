/* @generated from generated/models/balance_assist.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: a9fd1c383f4b46f9
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * mA = mH + mF [kg]
 * mu = (c/w)*cos(lam) [1]
 * SR = IRyy/rR [kg*m]
 * SF = IFyy/rF [kg*m]
 * ST = SR + SF [kg*m]
 * yaw_per_v_delta = cos(lam)/w [1/m]
 * Jxx_delta = IHxx + IFxx + zH^2*mH + rF^2*mF [kg*m^2]
 * Jxz_delta = IHxz - c*rF*mF - zH*mH*(xH - (w + c)) [kg*m^2]
 * Jzz_delta = mH*(xH - (w + c))^2 + IHzz + IFxx + c^2*mF [kg*m^2]
 * Sx_delta = mH*(xH - (w + c)) - c*mF [kg*m]
 * Sz_delta = zH*mH - rF*mF [kg*m]
 * py_delta = Sx_delta*cos(lam) - Sz_delta*sin(lam) [kg*m]
 * hx_delta = Jxx_delta*sin(lam) + Jxz_delta*cos(lam) [kg*m^2]
 * hz_delta = Jxz_delta*sin(lam) + Jzz_delta*cos(lam) [kg*m^2]
 * Jxx_all = IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB [kg*m^2]
 * Jxz_all = IBxz + Jxz_delta - xB*zB*mB - Sz_delta*(w + c) [kg*m^2]
 * Jzz_all = IRxx + IBzz + Jzz_delta + 2*(w + c)*((1/2)*mA*(w + c) + Sx_delta) + xB^2*mB [kg*m^2]
 * Sx_all = xB*mB + mA*(w + c) + Sx_delta [kg*m]
 * Sz_all = zB*mB + Sz_delta - rR*mR [kg*m]
 * load_spin_F = -Sx_all/w [kg]
 * M_yaw_delta = py_delta*(w + c) + hz_delta [kg*m^2]
 * M_delta_delta = hx_delta*sin(lam) + hz_delta*cos(lam) [kg*m^2]
 * K_phi_delta = c*load_spin_F*cos(lam) - py_delta [kg*m]
 * K_delta_delta = (c*load_spin_F*cos(lam) - py_delta)*sin(lam) [kg*m]
 * P_delta_lateral = mu*Sx_all + py_delta [kg*m]
 * P_delta_yaw = mu*Jzz_all + M_yaw_delta [kg*m^2]
 * P_delta_delta = mu*M_yaw_delta + M_delta_delta [kg*m^2]
 * M_11 = Jxx_all [kg*m^2]
 * M_12 = M_21 = mu*Jxz_all + hx_delta [kg*m^2]
 * M_22 = mu*P_delta_yaw + P_delta_delta [kg*m^2]
 * C0_21 = -kappa*vo [kg*m^2/s]
 * C1_12 = mu*(ST - Sz_all) + SF*cos(lam) + yaw_per_v_delta*Jxz_all [kg*m]
 * C1_21 = kappa - mu*ST - SF*cos(lam) [kg*m]
 * C1_22 = mu*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
 * K0_11 = Sz_all [kg*m]
 * K0_12 = K0_21 = K_phi_delta [kg*m]
 * K0_22 = K_delta_delta [kg*m]
 * K2_12 = yaw_per_v_delta*(ST - Sz_all) [kg]
 * K2_22 = yaw_per_v_delta*(SF*sin(lam) + P_delta_lateral) [kg]
 * @endverbatim
 */

#include "balance_assist.h"

#include "carvallo_trig.h"

#include <float.h>

const char *balance_assist_set_name(balance_assist_set_t set)
{
    static const char *const TEXTS[] = {
        "benchmark",
        "balanceassistv1",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *balance_assist_validity_text(balance_assist_validity_t validity)
{
    static const char *const TEXTS[] = {
        "BalanceAssist: the parameters are valid",
        "BalanceAssist: w in m must be finite and > 0",
        "BalanceAssist: c in m must be finite",
        "BalanceAssist: lam in rad must be finite and > -1.5707963267948966 and < 1.5707963267948966",
        "BalanceAssist: g in N/kg must be finite and >= 0",
        "BalanceAssist: rR in m must be finite and > 0",
        "BalanceAssist: mR in kg must be finite and >= 0",
        "BalanceAssist: IRxx in kg*m^2 must be finite and >= 0",
        "BalanceAssist: IRyy in kg*m^2 must be finite and >= 0",
        "BalanceAssist: xB in m must be finite",
        "BalanceAssist: zB in m must be finite",
        "BalanceAssist: mB in kg must be finite and >= 0",
        "BalanceAssist: IBxx in kg*m^2 must be finite and >= 0",
        "BalanceAssist: IByy in kg*m^2 must be finite and >= 0",
        "BalanceAssist: IBzz in kg*m^2 must be finite and >= 0",
        "BalanceAssist: IBxz in kg*m^2 must be finite",
        "BalanceAssist: xH in m must be finite",
        "BalanceAssist: zH in m must be finite",
        "BalanceAssist: mH in kg must be finite and >= 0",
        "BalanceAssist: IHxx in kg*m^2 must be finite and >= 0",
        "BalanceAssist: IHyy in kg*m^2 must be finite and >= 0",
        "BalanceAssist: IHzz in kg*m^2 must be finite and >= 0",
        "BalanceAssist: IHxz in kg*m^2 must be finite",
        "BalanceAssist: rF in m must be finite and > 0",
        "BalanceAssist: mF in kg must be finite and >= 0",
        "BalanceAssist: IFxx in kg*m^2 must be finite and >= 0",
        "BalanceAssist: IFyy in kg*m^2 must be finite and >= 0",
        "BalanceAssist: kappa in N*s^2 must be finite and >= 0",
        "BalanceAssist: vo in m/s must be finite and > 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t balance_assist_partials[BALANCE_ASSIST_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 1U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 2U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 3U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 5U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 5U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 6U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 7U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 8U, false},
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
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 17U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 17U, true},
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
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 115U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 115U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 116U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 117U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 118U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 35U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 91U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 91U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 119U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 94U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 120U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 120U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 121U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 122U, false},
    {CARVALLO_MATRIX_C0, 1U, 0U, 26U, 123U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 26U, 35U, false},
    {CARVALLO_MATRIX_C0, 1U, 0U, 27U, 124U, true}
};

const balance_assist_f64_t balance_assist_f64_sets[BALANCE_ASSIST_SETS] = {
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
        .IFyy = 0.28,
        .kappa = 10.0,
        .vo = 4.7
    },
    { /* balanceassistv1 */
        .w = 1.113,
        .c = 0.042,
        .lam = 0.255,
        .g = 9.80665,
        .rR = 0.34895,
        .mR = 4.085,
        .IRxx = 0.1023,
        .IRyy = 0.1887,
        .xB = 0.519,
        .zB = (-0.521),
        .mB = 22.5,
        .IBxx = 1.12,
        .IByy = 3.16,
        .IBzz = 2.119,
        .IBxz = 0.047,
        .xH = 0.921,
        .zH = (-0.86),
        .mH = 4.3,
        .IHxx = 0.2984,
        .IHyy = 0.257,
        .IHzz = 0.0566,
        .IHxz = (-0.038),
        .rF = 0.35231,
        .mF = 2.235,
        .IFxx = 0.0995,
        .IFyy = 0.1902,
        .kappa = 10.0,
        .vo = 4.7
    }
};

balance_assist_validity_t balance_assist_f64_validate(const balance_assist_f64_t *p)
{
    balance_assist_validity_t validity = BALANCE_ASSIST_VALID;
    if (!((p->w > 0.0) && (p->w <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_w;
    } else if (!((p->c >= -DBL_MAX) && (p->c <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_c;
    } else if (!((p->lam > (-1.5707963267948966)) && (p->lam < 1.5707963267948966))) {
        validity = BALANCE_ASSIST_INVALID_lam;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_g;
    } else if (!((p->rR > 0.0) && (p->rR <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_rR;
    } else if (!((p->mR >= 0.0) && (p->mR <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_mR;
    } else if (!((p->IRxx >= 0.0) && (p->IRxx <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0) && (p->IRyy <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IRyy;
    } else if (!((p->xB >= -DBL_MAX) && (p->xB <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_xB;
    } else if (!((p->zB >= -DBL_MAX) && (p->zB <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_zB;
    } else if (!((p->mB >= 0.0) && (p->mB <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_mB;
    } else if (!((p->IBxx >= 0.0) && (p->IBxx <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0) && (p->IByy <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0) && (p->IBzz <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IBzz;
    } else if (!((p->IBxz >= -DBL_MAX) && (p->IBxz <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IBxz;
    } else if (!((p->xH >= -DBL_MAX) && (p->xH <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_xH;
    } else if (!((p->zH >= -DBL_MAX) && (p->zH <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_zH;
    } else if (!((p->mH >= 0.0) && (p->mH <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_mH;
    } else if (!((p->IHxx >= 0.0) && (p->IHxx <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0) && (p->IHyy <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0) && (p->IHzz <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IHzz;
    } else if (!((p->IHxz >= -DBL_MAX) && (p->IHxz <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IHxz;
    } else if (!((p->rF > 0.0) && (p->rF <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_rF;
    } else if (!((p->mF >= 0.0) && (p->mF <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_mF;
    } else if (!((p->IFxx >= 0.0) && (p->IFxx <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0) && (p->IFyy <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IFyy;
    } else if (!((p->kappa >= 0.0) && (p->kappa <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_kappa;
    } else if (!((p->vo > 0.0) && (p->vo <= DBL_MAX))) {
        validity = BALANCE_ASSIST_INVALID_vo;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void balance_assist_f64_matrices(const balance_assist_f64_t *p, balance_assist_f64_matrices_t *matrices)
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
    const double t35 = p->c + p->w;
    const double t36 = t35 - p->xH;
    const double Jxz_delta = p->IHxz + (t6 * t36) - (t10 * p->c);
    const double hx_delta = (Jxx_delta * sin_lam) + (Jxz_delta * cos_lam);
    const double yaw_per_v_delta = cos_lam / p->w;
    const double mu = p->c * yaw_per_v_delta;
    const double Sz_delta = t6 - t10;
    const double Jxz_all = Jxz_delta + p->IBxz - (t21 * p->xB) - (t35 * Sz_delta);
    const double M_12 = hx_delta + (mu * Jxz_all);
    const double t57 = p->mH * t36;
    const double t59 = p->mF * p->c;
    const double Jzz_delta = p->IFxx + p->IHzz + (t36 * t57) + (p->c * t59);
    const double hz_delta = (sin_lam * Jxz_delta) + (cos_lam * Jzz_delta);
    const double t67 = t57 + t59;
    const double t69 = (sin_lam * Sz_delta) + (cos_lam * t67);
    const double M_yaw_delta = hz_delta - (t35 * t69);
    const double t73 = p->mB * p->xB;
    const double mA = p->mH + p->mF;
    const double t77 = t67 - (t35 * mA);
    const double P_delta_yaw = M_yaw_delta + (mu * (p->IRxx + Jzz_delta + p->IBzz + (p->xB * t73) -
        (t35 * (t67 + t77))));
    const double M_22 = (mu * (M_yaw_delta + P_delta_yaw)) + (sin_lam * hx_delta) + (cos_lam *
        hz_delta);
    const double SF = p->IFyy / p->rF;
    const double ST = SF + (p->IRyy / p->rR);
    const double Sz_all = t21 + Sz_delta - t17;
    const double t103 = ST - Sz_all;
    const double t105 = cos_lam * SF;
    const double C1_12 = (mu * t103) + t105 + (yaw_per_v_delta * Jxz_all);
    const double C1_21 = p->kappa - t105 - (mu * ST);
    const double Sx_all = t73 - t77;
    const double t113 = mu * Sx_all;
    const double P_delta_lateral = t113 - t69;
    const double C1_22 = (mu * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
    const double K2_12 = yaw_per_v_delta * t103;
    const double K2_22 = yaw_per_v_delta * (P_delta_lateral + (sin_lam * SF));
    const double C0_21 = -(p->kappa * p->vo);
    const double K0_12 = t69 - t113;
    const double K0_22 = -(sin_lam * P_delta_lateral);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = 0.0;
    matrices->c0[1][0] = C0_21;
    matrices->c0[1][1] = 0.0;
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

carvallo_system_error_t balance_assist_f64_at_speed(const balance_assist_f64_matrices_t *matrices,
    double speed, double gravity, balance_assist_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed) && carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < BALANCE_ASSIST_N; row++) {
        for (size_t column = 0U; column < BALANCE_ASSIST_N; column++) {
            const double damping = matrices->c0[row][column] + (matrices->c1[row][column] * speed);
            const double stiffness = (matrices->k0[row][column] * gravity) +
                (matrices->k2[row][column] * speed * speed);
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->c0[row][column]) &&
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

carvallo_system_error_t balance_assist_f64_state_space(const balance_assist_f64_system_t *system,
    balance_assist_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[BALANCE_ASSIST_N * BALANCE_ASSIST_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * BALANCE_ASSIST_N * BALANCE_ASSIST_N];
    for (size_t row = 0U; row < BALANCE_ASSIST_N; row++) {
        double *const solved = &x[3U * BALANCE_ASSIST_N * row];
        for (size_t column = 0U; column < BALANCE_ASSIST_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * BALANCE_ASSIST_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[BALANCE_ASSIST_N + column] = -system->c[row][column];
            solved[(2U * BALANCE_ASSIST_N) + column] = 0.0;
        }
        solved[(2U * BALANCE_ASSIST_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[BALANCE_ASSIST_N * BALANCE_ASSIST_N];
        error = carvallo_solve_f64(BALANCE_ASSIST_N, m, terms, 3U * BALANCE_ASSIST_N, x);
    }
    for (size_t row = 0U; row < (2U * BALANCE_ASSIST_N); row++) {
        for (size_t column = 0U; column < (2U * BALANCE_ASSIST_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < BALANCE_ASSIST_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < BALANCE_ASSIST_N; row++) {
            const size_t target = BALANCE_ASSIST_N + row;
            for (size_t column = 0U; column < (2U * BALANCE_ASSIST_N); column++) {
                space->a[target][column] = x[(3U * BALANCE_ASSIST_N * row) + column];
            }
            for (size_t column = 0U; column < BALANCE_ASSIST_N; column++) {
                space->b[target][column] = x[(3U * BALANCE_ASSIST_N * row) + (2U *
                    BALANCE_ASSIST_N) + column];
            }
            space->a[row][BALANCE_ASSIST_N + row] = 1.0;
        }
    }
    return error;
}

double balance_assist_f64_rate_at(const balance_assist_f64_rate_t *rate, double v,
    const double q[BALANCE_ASSIST_N], const double q_dot[BALANCE_ASSIST_N], double psi)
{
    double by_coordinates = 0.0;
    double by_rates = 0.0;
    for (size_t i = 0U; i < BALANCE_ASSIST_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void balance_assist_f64_kinematics(const balance_assist_f64_t *p, balance_assist_f64_kinematics_t *kinematics)
{
    const double yaw_per_v_delta = carvallo_cos_f64(p->lam) / p->w;
    const double mu = p->c * yaw_per_v_delta;
    const double t12 = -(1.0 / p->rR);
    const double t13 = -(1.0 / p->rF);
    kinematics->lateral.speed = 0.0;
    kinematics->lateral.rates[0] = 0.0;
    kinematics->lateral.rates[1] = 0.0;
    kinematics->lateral.coordinates[0] = 0.0;
    kinematics->lateral.coordinates[1] = 0.0;
    kinematics->lateral.heading = 1.0;
    kinematics->yaw.speed = 0.0;
    kinematics->yaw.rates[0] = 0.0;
    kinematics->yaw.rates[1] = mu;
    kinematics->yaw.coordinates[0] = 0.0;
    kinematics->yaw.coordinates[1] = yaw_per_v_delta;
    kinematics->yaw.heading = 0.0;
    kinematics->wheel_R.speed = t12;
    kinematics->wheel_R.rates[0] = 0.0;
    kinematics->wheel_R.rates[1] = 0.0;
    kinematics->wheel_R.coordinates[0] = 0.0;
    kinematics->wheel_R.coordinates[1] = 0.0;
    kinematics->wheel_R.heading = 0.0;
    kinematics->wheel_F.speed = t13;
    kinematics->wheel_F.rates[0] = 0.0;
    kinematics->wheel_F.rates[1] = 0.0;
    kinematics->wheel_F.coordinates[0] = 0.0;
    kinematics->wheel_F.coordinates[1] = 0.0;
    kinematics->wheel_F.heading = 0.0;
    kinematics->forces[0][0] = 1.0;
    kinematics->forces[0][1] = 0.0;
    kinematics->forces[1][0] = 0.0;
    kinematics->forces[1][1] = 1.0;
}

void balance_assist_f64_derivatives(const balance_assist_f64_t *p,
    balance_assist_f64_matrices_t *matrices, balance_assist_f64_derivatives_t *derivatives)
{
    const double M_11_mB = p->zB * p->zB;
    const double t10 = p->rF * p->mF;
    const double t14 = p->zH * p->mH;
    const double Jxx_delta = p->IFxx + p->IHxx + (p->rF * t10) + (p->zH * t14);
    const double M_11_mR = p->rR * p->rR;
    const double M_11 = p->IBxx + p->IRxx + (p->mB * M_11_mB) + Jxx_delta + (p->mR * M_11_mR);
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t32 = t10 - t14;
    const double t36 = p->w - p->xH;
    const double t39 = p->IHxz + (t14 * t36) - (p->c * t32);
    const double t41 = t39 * cos_lam;
    const double hx_delta = (Jxx_delta * sin_lam) + t41;
    const double t44 = p->c + p->w;
    const double M_22_hz_delta = t32 * t44;
    const double t47 = p->mB * p->zB;
    const double t51 = t39 + p->IBxz + M_22_hz_delta - (p->xB * t47);
    const double t52 = 1.0 / p->w;
    const double yaw_per_v_delta = cos_lam * t52;
    const double mu = p->c * yaw_per_v_delta;
    const double M_12 = hx_delta + (t51 * mu);
    const double t59 = p->mF * p->c;
    const double t60 = t44 - p->xH;
    const double t61 = p->mH * t60;
    const double t62 = t59 + t61;
    const double t64 = (sin_lam * t32) - (cos_lam * t62);
    const double t65 = t44 * t64;
    const double t66 = sin_lam * t39;
    const double Jzz_delta = p->IFxx + p->IHzz + (p->c * t59) + (t60 * t61);
    const double t74 = t66 + (cos_lam * Jzz_delta);
    const double t75 = p->mB * p->xB;
    const double mA = p->mF + p->mH;
    const double t80 = t62 - (t44 * mA);
    const double t86 = p->IRxx + Jzz_delta + (p->xB * t75) + p->IBzz - (t44 * (t62 + t80));
    const double t87 = mu * t86;
    const double t89 = t65 + t74 + t87;
    const double M_12_Jxz_delta = cos_lam + mu;
    const double M_22 = (sin_lam * hx_delta) + (mu * (t65 + t89)) + (t74 * M_12_Jxz_delta);
    const double t101 = 1.0 / p->rF;
    const double SF = p->IFyy * t101;
    const double t104 = 1.0 / p->rR;
    const double t105 = p->IRyy * t104;
    const double ST = SF + t105;
    const double t107 = p->mR * p->rR;
    const double K0_11 = t47 - (t32 + t107);
    const double t111 = t52 * (ST - K0_11);
    const double t113 = t51 * t52;
    const double t114 = (p->c * t111) + t113;
    const double t115 = SF + t114;
    const double C1_12 = cos_lam * t115;
    const double t117 = cos_lam * SF;
    const double t118 = mu * ST;
    const double C1_21 = p->kappa - t117 - t118;
    const double t121 = mu * t75;
    const double t122 = mu * t80;
    const double t123 = t121 - t122;
    const double t124 = t64 + t123;
    const double t126 = t89 + (p->c * t124);
    const double C1_22 = yaw_per_v_delta * t126;
    const double K2_12 = cos_lam * t111;
    const double t130 = sin_lam * SF;
    const double t131 = t124 + t130;
    const double K2_22 = yaw_per_v_delta * t131;
    const double t133 = t32 - t113;
    const double t135 = t14 * M_12_Jxz_delta;
    const double M_12_w = (mu * t133) + t135;
    const double t137 = t52 * t89;
    const double t138 = t137 + t137;
    const double t140 = t60 * M_12_Jxz_delta;
    const double t141 = M_12_Jxz_delta * t140;
    const double t142 = t44 * mu;
    const double t143 = M_12_Jxz_delta + M_12_Jxz_delta;
    const double t144 = t142 * t143;
    const double t145 = t141 - t144;
    const double t146 = p->zH * sin_lam;
    const double t150 = p->mH * (t141 + t145 + (t143 * t146));
    const double t151 = mu + mu;
    const double t152 = t64 - t122;
    const double P_delta_yaw_xB = t151 * t152;
    const double t154 = t150 + P_delta_yaw_xB;
    const double M_22_w = t154 - (mu * t138);
    const double C1_12_w = yaw_per_v_delta * (t10 - t114);
    const double C1_21_w = t52 * t118;
    const double t161 = (p->mF * mu) - (p->mH * cos_lam);
    const double t162 = t52 * t123;
    const double P_delta_lateral_w = t161 - t162;
    const double t165 = t142 - t140;
    const double K0_12_mH = t146 - t165;
    const double t167 = t165 - K0_12_mH;
    const double t168 = cos_lam * t44;
    const double t169 = t167 + t168;
    const double t172 = t122 + (p->mH * t169) - t152;
    const double t174 = t52 * (t87 + t126);
    const double C1_22_w = yaw_per_v_delta * ((p->c * P_delta_lateral_w) - t172 - t174);
    const double t178 = sin_lam * P_delta_lateral_w;
    const double t179 = yaw_per_v_delta * t111;
    const double t180 = t52 * t131;
    const double K2_22_w = yaw_per_v_delta * (P_delta_lateral_w - t180);
    const double t183 = cos_lam * t133;
    const double M_22_Jzz_delta = M_12_Jxz_delta * M_12_Jxz_delta;
    const double t185 = p->c * M_22_Jzz_delta;
    const double t186 = t185 - t144;
    const double t190 = p->mF * M_12_Jxz_delta;
    const double t191 = p->rF * sin_lam;
    const double t193 = (cos_lam * t137) - (t190 * t191);
    const double M_22_c = t154 + (p->mF * (t185 + t186)) + t193 + t193;
    const double t197 = yaw_per_v_delta * ST;
    const double t198 = p->c * M_12_Jxz_delta;
    const double t200 = t142 + t191 - t198;
    const double t201 = t142 + t200;
    const double t205 = t75 - t80;
    const double t207 = t161 + (yaw_per_v_delta * t205);
    const double t212 = t172 + (p->mF * (t168 + t201)) - t124 - (yaw_per_v_delta * t86) - (p->c *
        t207);
    const double t213 = yaw_per_v_delta * t212;
    const double K0_12_c = t190 - t207;
    const double t218 = t66 - (Jxx_delta * cos_lam);
    const double t220 = sin_lam * p->c * t52;
    const double t222 = t218 + (t51 * t220);
    const double t229 = (t32 * cos_lam) + (sin_lam * t62);
    const double t232 = t41 - (sin_lam * Jzz_delta);
    const double t233 = (t44 * t229) + t232;
    const double M_22_lam = (t151 * t233) + (cos_lam * (hx_delta + t232)) - (sin_lam * (t74 + t218 +
        (p->c * t138)));
    const double t239 = sin_lam * t115;
    const double C1_21_lam = t130 + (ST * t220);
    const double t242 = t205 * t220;
    const double t243 = t229 - t242;
    const double C1_22_lam = (yaw_per_v_delta * (t233 + (p->c * t243))) - (sin_lam * t174);
    const double t251 = (sin_lam * t243) + (cos_lam * t124);
    const double t252 = sin_lam * t111;
    const double K2_22_lam = (yaw_per_v_delta * (t117 + t243)) - (sin_lam * t180);
    const double M_11_rR = t107 + t107;
    const double K2_12_IRyy = yaw_per_v_delta * t104;
    const double K2_12_rR = (p->mR * yaw_per_v_delta) - (t105 * K2_12_IRyy);
    const double C1_12_rR = p->c * K2_12_rR;
    const double C1_12_IRyy = mu * t104;
    const double C1_21_rR = t105 * C1_12_IRyy;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double C1_12_mR = p->c * K2_12_mR;
    const double C1_22_IRxx = yaw_per_v_delta * mu;
    const double M_22_IRxx = p->c * C1_22_IRxx;
    const double t270 = p->mB * p->c;
    const double t271 = p->zB * yaw_per_v_delta;
    const double t272 = t270 * t271;
    const double M_22_xB = t121 * t151;
    const double t274 = p->mB * yaw_per_v_delta;
    const double t275 = p->zB * t274;
    const double t276 = p->c + p->xB;
    const double t277 = p->c * t274;
    const double K2_22_xB = yaw_per_v_delta * t277;
    const double t280 = p->xB * mu;
    const double C1_22_xB = (t276 * K2_22_xB) + (t274 * t280);
    const double C1_22_Jxz_delta = sin_lam * yaw_per_v_delta;
    const double t284 = t270 * C1_22_Jxz_delta;
    const double M_11_zB = t47 + t47;
    const double t286 = t274 * t276;
    const double t287 = p->zB * t280;
    const double M_22_mB = t280 * t280;
    const double t289 = t271 * t276;
    const double K2_22_mB = p->xB * C1_22_IRxx;
    const double C1_22_mB = t276 * K2_22_mB;
    const double t292 = sin_lam * t280;
    const double t293 = p->mH * yaw_per_v_delta;
    const double t294 = p->zH * t293;
    const double C1_22_xH = t293 * (t169 + t198);
    const double t297 = p->mH * M_12_Jxz_delta;
    const double t298 = sin_lam * t297;
    const double K2_22_xH = M_12_Jxz_delta * t293;
    const double M_11_zH = t14 + t14;
    const double t301 = t146 + K0_12_mH;
    const double M_12_zH = p->mH * t301;
    const double K0_12_zH = p->mH * sin_lam;
    const double t305 = (t165 - t301) * K0_12_zH;
    const double t306 = p->c + p->xH;
    const double t307 = t293 * t306;
    const double t308 = sin_lam * t307;
    const double K0_22_zH = sin_lam * K0_12_zH;
    const double t310 = yaw_per_v_delta * K0_12_zH;
    const double M_11_mH = p->zH * p->zH;
    const double M_12_mH = p->zH * K0_12_mH;
    const double t313 = t44 * yaw_per_v_delta;
    const double C1_22_mA = t142 * t313;
    const double M_22_mH = (p->c * C1_22_mA) + (t60 * t145) - (t146 * t167);
    const double t320 = p->zH * yaw_per_v_delta;
    const double t321 = t306 * t320;
    const double C1_22_mH = C1_22_mA - (yaw_per_v_delta * ((t44 * t140) + (t36 * t165) + (t146 *
        t306)));
    const double K0_22_mH = sin_lam * K0_12_mH;
    const double t330 = yaw_per_v_delta * K0_12_mH;
    const double M_22_Jxx_delta = sin_lam * sin_lam;
    const double C1_22_Jzz_delta = yaw_per_v_delta * M_12_Jxz_delta;
    const double M_22_Jxz_delta = sin_lam * t143;
    const double M_11_rF = t10 + t10;
    const double M_12_rF = p->mF * (t191 + t200);
    const double P_delta_lateral_rF = p->mF * sin_lam;
    const double t338 = t200 * P_delta_lateral_rF;
    const double M_22_rF = t338 + t338;
    const double t340 = p->mF * t313;
    const double t341 = t101 * SF;
    const double C1_21_rF = M_12_Jxz_delta * t341;
    const double C1_12_rF = t340 - C1_21_rF;
    const double C1_22_rF = sin_lam * t340;
    const double t345 = sin_lam * P_delta_lateral_rF;
    const double K2_12_rF = yaw_per_v_delta * (p->mF - t341);
    const double K2_22_rF = sin_lam * K2_12_rF;
    const double M_11_mF = p->rF * p->rF;
    const double M_12_mF = p->rF * t200;
    const double M_22_mF = (p->c * (t186 + C1_22_mA)) - (t191 * (t198 - t201));
    const double C1_12_mF = p->rF * t313;
    const double C1_22_mF = t200 * t313;
    const double t358 = sin_lam * t200;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double K2_22_mF = yaw_per_v_delta * t200;
    const double M_22_IFxx = M_22_Jzz_delta + M_22_Jxx_delta;
    const double C1_12_IFyy = M_12_Jxz_delta * t101;
    const double K2_12_IFyy = yaw_per_v_delta * t101;
    const double K2_22_IFyy = t101 * C1_22_Jxz_delta;
    const double C0_21 = -(p->kappa * p->vo);
    const double K0_12 = -t124;
    const double K0_22 = -(sin_lam * t124);
    const double K0_12_w = t162 - t161;
    const double t369 = -(sin_lam * K0_12_c);
    const double K2_22_c = -(yaw_per_v_delta * K0_12_c);
    const double K0_12_lam = t242 - t229;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = 0.0;
    matrices->c0[1][0] = C0_21;
    matrices->c0[1][1] = 0.0;
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
    derivatives->values[6] = t178;
    derivatives->values[7] = t179;
    derivatives->values[8] = K2_22_w;
    derivatives->values[9] = t183;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t197;
    derivatives->values[13] = t213;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = t369;
    derivatives->values[16] = K2_22_c;
    derivatives->values[17] = t222;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t239;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = t251;
    derivatives->values[24] = t252;
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
    derivatives->values[40] = t272;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t275;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = t277;
    derivatives->values[45] = t284;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t121;
    derivatives->values[49] = t286;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t274;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t287;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t289;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = t280;
    derivatives->values[59] = t292;
    derivatives->values[60] = t271;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = mu;
    derivatives->values[63] = yaw_per_v_delta;
    derivatives->values[64] = t135;
    derivatives->values[65] = t150;
    derivatives->values[66] = t294;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = t297;
    derivatives->values[69] = t298;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = t305;
    derivatives->values[74] = t307;
    derivatives->values[75] = t308;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t293;
    derivatives->values[80] = t310;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = M_12_mH;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t321;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = K0_22_mH;
    derivatives->values[89] = t320;
    derivatives->values[90] = t330;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_Jxx_delta;
    derivatives->values[93] = M_22_Jzz_delta;
    derivatives->values[94] = C1_22_Jzz_delta;
    derivatives->values[95] = M_12_Jxz_delta;
    derivatives->values[96] = M_22_Jxz_delta;
    derivatives->values[97] = C1_22_Jxz_delta;
    derivatives->values[98] = M_11_rF;
    derivatives->values[99] = M_12_rF;
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = C1_22_rF;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = P_delta_lateral_rF;
    derivatives->values[106] = t345;
    derivatives->values[107] = K2_12_rF;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = M_12_mF;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = C1_22_mF;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = t200;
    derivatives->values[116] = t358;
    derivatives->values[117] = K2_12_mF;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = K2_12_IFyy;
    derivatives->values[122] = K2_22_IFyy;
    derivatives->values[123] = p->vo;
    derivatives->values[124] = p->kappa;
}

void balance_assist_f64_with_respect_to(const balance_assist_f64_derivatives_t *derivatives,
    size_t parameter, balance_assist_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < BALANCE_ASSIST_N; row++) {
        for (size_t column = 0U; column < BALANCE_ASSIST_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c0[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
            matrices->k2[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < BALANCE_ASSIST_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &balance_assist_partials[position];
        if (partial->parameter == parameter) {
            const double value = derivatives->values[partial->value];
            const double signed_value = partial->is_negative ? (-value) : value;
            switch (partial->matrix) {
            case CARVALLO_MATRIX_M:
                matrices->m[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_C0:
                matrices->c0[partial->row][partial->column] = signed_value;
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

const balance_assist_f32_t balance_assist_f32_sets[BALANCE_ASSIST_SETS] = {
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
        .IFyy = 0.28F,
        .kappa = 10.0F,
        .vo = 4.7F
    },
    { /* balanceassistv1 */
        .w = 1.113F,
        .c = 0.042F,
        .lam = 0.255F,
        .g = 9.80665F,
        .rR = 0.34895F,
        .mR = 4.085F,
        .IRxx = 0.1023F,
        .IRyy = 0.1887F,
        .xB = 0.519F,
        .zB = (-0.521F),
        .mB = 22.5F,
        .IBxx = 1.12F,
        .IByy = 3.16F,
        .IBzz = 2.119F,
        .IBxz = 0.047F,
        .xH = 0.921F,
        .zH = (-0.86F),
        .mH = 4.3F,
        .IHxx = 0.2984F,
        .IHyy = 0.257F,
        .IHzz = 0.0566F,
        .IHxz = (-0.038F),
        .rF = 0.35231F,
        .mF = 2.235F,
        .IFxx = 0.0995F,
        .IFyy = 0.1902F,
        .kappa = 10.0F,
        .vo = 4.7F
    }
};

balance_assist_validity_t balance_assist_f32_validate(const balance_assist_f32_t *p)
{
    balance_assist_validity_t validity = BALANCE_ASSIST_VALID;
    if (!((p->w > 0.0F) && (p->w <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_w;
    } else if (!((p->c >= -FLT_MAX) && (p->c <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_c;
    } else if (!((p->lam > (-1.5707964F)) && (p->lam < 1.5707964F))) {
        validity = BALANCE_ASSIST_INVALID_lam;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_g;
    } else if (!((p->rR > 0.0F) && (p->rR <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_rR;
    } else if (!((p->mR >= 0.0F) && (p->mR <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_mR;
    } else if (!((p->IRxx >= 0.0F) && (p->IRxx <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0F) && (p->IRyy <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IRyy;
    } else if (!((p->xB >= -FLT_MAX) && (p->xB <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_xB;
    } else if (!((p->zB >= -FLT_MAX) && (p->zB <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_zB;
    } else if (!((p->mB >= 0.0F) && (p->mB <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_mB;
    } else if (!((p->IBxx >= 0.0F) && (p->IBxx <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0F) && (p->IByy <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0F) && (p->IBzz <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IBzz;
    } else if (!((p->IBxz >= -FLT_MAX) && (p->IBxz <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IBxz;
    } else if (!((p->xH >= -FLT_MAX) && (p->xH <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_xH;
    } else if (!((p->zH >= -FLT_MAX) && (p->zH <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_zH;
    } else if (!((p->mH >= 0.0F) && (p->mH <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_mH;
    } else if (!((p->IHxx >= 0.0F) && (p->IHxx <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0F) && (p->IHyy <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0F) && (p->IHzz <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IHzz;
    } else if (!((p->IHxz >= -FLT_MAX) && (p->IHxz <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IHxz;
    } else if (!((p->rF > 0.0F) && (p->rF <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_rF;
    } else if (!((p->mF >= 0.0F) && (p->mF <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_mF;
    } else if (!((p->IFxx >= 0.0F) && (p->IFxx <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0F) && (p->IFyy <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_IFyy;
    } else if (!((p->kappa >= 0.0F) && (p->kappa <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_kappa;
    } else if (!((p->vo > 0.0F) && (p->vo <= FLT_MAX))) {
        validity = BALANCE_ASSIST_INVALID_vo;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void balance_assist_f32_matrices(const balance_assist_f32_t *p, balance_assist_f32_matrices_t *matrices)
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
    const float t35 = p->c + p->w;
    const float t36 = t35 - p->xH;
    const float Jxz_delta = p->IHxz + (t6 * t36) - (t10 * p->c);
    const float hx_delta = (Jxx_delta * sin_lam) + (Jxz_delta * cos_lam);
    const float yaw_per_v_delta = cos_lam / p->w;
    const float mu = p->c * yaw_per_v_delta;
    const float Sz_delta = t6 - t10;
    const float Jxz_all = Jxz_delta + p->IBxz - (t21 * p->xB) - (t35 * Sz_delta);
    const float M_12 = hx_delta + (mu * Jxz_all);
    const float t57 = p->mH * t36;
    const float t59 = p->mF * p->c;
    const float Jzz_delta = p->IFxx + p->IHzz + (t36 * t57) + (p->c * t59);
    const float hz_delta = (sin_lam * Jxz_delta) + (cos_lam * Jzz_delta);
    const float t67 = t57 + t59;
    const float t69 = (sin_lam * Sz_delta) + (cos_lam * t67);
    const float M_yaw_delta = hz_delta - (t35 * t69);
    const float t73 = p->mB * p->xB;
    const float mA = p->mH + p->mF;
    const float t77 = t67 - (t35 * mA);
    const float P_delta_yaw = M_yaw_delta + (mu * (p->IRxx + Jzz_delta + p->IBzz + (p->xB * t73) -
        (t35 * (t67 + t77))));
    const float M_22 = (mu * (M_yaw_delta + P_delta_yaw)) + (sin_lam * hx_delta) + (cos_lam *
        hz_delta);
    const float SF = p->IFyy / p->rF;
    const float ST = SF + (p->IRyy / p->rR);
    const float Sz_all = t21 + Sz_delta - t17;
    const float t103 = ST - Sz_all;
    const float t105 = cos_lam * SF;
    const float C1_12 = (mu * t103) + t105 + (yaw_per_v_delta * Jxz_all);
    const float C1_21 = p->kappa - t105 - (mu * ST);
    const float Sx_all = t73 - t77;
    const float t113 = mu * Sx_all;
    const float P_delta_lateral = t113 - t69;
    const float C1_22 = (mu * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
    const float K2_12 = yaw_per_v_delta * t103;
    const float K2_22 = yaw_per_v_delta * (P_delta_lateral + (sin_lam * SF));
    const float C0_21 = -(p->kappa * p->vo);
    const float K0_12 = t69 - t113;
    const float K0_22 = -(sin_lam * P_delta_lateral);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[1][0] = C0_21;
    matrices->c0[1][1] = 0.0F;
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

carvallo_system_error_t balance_assist_f32_at_speed(const balance_assist_f32_matrices_t *matrices,
    float speed, float gravity, balance_assist_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed) && carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < BALANCE_ASSIST_N; row++) {
        for (size_t column = 0U; column < BALANCE_ASSIST_N; column++) {
            const float damping = matrices->c0[row][column] + (matrices->c1[row][column] * speed);
            const float stiffness = (matrices->k0[row][column] * gravity) +
                (matrices->k2[row][column] * speed * speed);
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->c0[row][column]) &&
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

carvallo_system_error_t balance_assist_f32_state_space(const balance_assist_f32_system_t *system,
    balance_assist_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[BALANCE_ASSIST_N * BALANCE_ASSIST_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * BALANCE_ASSIST_N * BALANCE_ASSIST_N];
    for (size_t row = 0U; row < BALANCE_ASSIST_N; row++) {
        float *const solved = &x[3U * BALANCE_ASSIST_N * row];
        for (size_t column = 0U; column < BALANCE_ASSIST_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * BALANCE_ASSIST_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[BALANCE_ASSIST_N + column] = -system->c[row][column];
            solved[(2U * BALANCE_ASSIST_N) + column] = 0.0F;
        }
        solved[(2U * BALANCE_ASSIST_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[BALANCE_ASSIST_N * BALANCE_ASSIST_N];
        error = carvallo_solve_f32(BALANCE_ASSIST_N, m, terms, 3U * BALANCE_ASSIST_N, x);
    }
    for (size_t row = 0U; row < (2U * BALANCE_ASSIST_N); row++) {
        for (size_t column = 0U; column < (2U * BALANCE_ASSIST_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < BALANCE_ASSIST_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < BALANCE_ASSIST_N; row++) {
            const size_t target = BALANCE_ASSIST_N + row;
            for (size_t column = 0U; column < (2U * BALANCE_ASSIST_N); column++) {
                space->a[target][column] = x[(3U * BALANCE_ASSIST_N * row) + column];
            }
            for (size_t column = 0U; column < BALANCE_ASSIST_N; column++) {
                space->b[target][column] = x[(3U * BALANCE_ASSIST_N * row) + (2U *
                    BALANCE_ASSIST_N) + column];
            }
            space->a[row][BALANCE_ASSIST_N + row] = 1.0F;
        }
    }
    return error;
}

float balance_assist_f32_rate_at(const balance_assist_f32_rate_t *rate, float v,
    const float q[BALANCE_ASSIST_N], const float q_dot[BALANCE_ASSIST_N], float psi)
{
    float by_coordinates = 0.0F;
    float by_rates = 0.0F;
    for (size_t i = 0U; i < BALANCE_ASSIST_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void balance_assist_f32_kinematics(const balance_assist_f32_t *p, balance_assist_f32_kinematics_t *kinematics)
{
    const float yaw_per_v_delta = carvallo_cos_f32(p->lam) / p->w;
    const float mu = p->c * yaw_per_v_delta;
    const float t12 = -(1.0F / p->rR);
    const float t13 = -(1.0F / p->rF);
    kinematics->lateral.speed = 0.0F;
    kinematics->lateral.rates[0] = 0.0F;
    kinematics->lateral.rates[1] = 0.0F;
    kinematics->lateral.coordinates[0] = 0.0F;
    kinematics->lateral.coordinates[1] = 0.0F;
    kinematics->lateral.heading = 1.0F;
    kinematics->yaw.speed = 0.0F;
    kinematics->yaw.rates[0] = 0.0F;
    kinematics->yaw.rates[1] = mu;
    kinematics->yaw.coordinates[0] = 0.0F;
    kinematics->yaw.coordinates[1] = yaw_per_v_delta;
    kinematics->yaw.heading = 0.0F;
    kinematics->wheel_R.speed = t12;
    kinematics->wheel_R.rates[0] = 0.0F;
    kinematics->wheel_R.rates[1] = 0.0F;
    kinematics->wheel_R.coordinates[0] = 0.0F;
    kinematics->wheel_R.coordinates[1] = 0.0F;
    kinematics->wheel_R.heading = 0.0F;
    kinematics->wheel_F.speed = t13;
    kinematics->wheel_F.rates[0] = 0.0F;
    kinematics->wheel_F.rates[1] = 0.0F;
    kinematics->wheel_F.coordinates[0] = 0.0F;
    kinematics->wheel_F.coordinates[1] = 0.0F;
    kinematics->wheel_F.heading = 0.0F;
    kinematics->forces[0][0] = 1.0F;
    kinematics->forces[0][1] = 0.0F;
    kinematics->forces[1][0] = 0.0F;
    kinematics->forces[1][1] = 1.0F;
}

void balance_assist_f32_derivatives(const balance_assist_f32_t *p,
    balance_assist_f32_matrices_t *matrices, balance_assist_f32_derivatives_t *derivatives)
{
    const float M_11_mB = p->zB * p->zB;
    const float t10 = p->rF * p->mF;
    const float t14 = p->zH * p->mH;
    const float Jxx_delta = p->IFxx + p->IHxx + (p->rF * t10) + (p->zH * t14);
    const float M_11_mR = p->rR * p->rR;
    const float M_11 = p->IBxx + p->IRxx + (p->mB * M_11_mB) + Jxx_delta + (p->mR * M_11_mR);
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t32 = t10 - t14;
    const float t36 = p->w - p->xH;
    const float t39 = p->IHxz + (t14 * t36) - (p->c * t32);
    const float t41 = t39 * cos_lam;
    const float hx_delta = (Jxx_delta * sin_lam) + t41;
    const float t44 = p->c + p->w;
    const float M_22_hz_delta = t32 * t44;
    const float t47 = p->mB * p->zB;
    const float t51 = t39 + p->IBxz + M_22_hz_delta - (p->xB * t47);
    const float t52 = 1.0F / p->w;
    const float yaw_per_v_delta = cos_lam * t52;
    const float mu = p->c * yaw_per_v_delta;
    const float M_12 = hx_delta + (t51 * mu);
    const float t59 = p->mF * p->c;
    const float t60 = t44 - p->xH;
    const float t61 = p->mH * t60;
    const float t62 = t59 + t61;
    const float t64 = (sin_lam * t32) - (cos_lam * t62);
    const float t65 = t44 * t64;
    const float t66 = sin_lam * t39;
    const float Jzz_delta = p->IFxx + p->IHzz + (p->c * t59) + (t60 * t61);
    const float t74 = t66 + (cos_lam * Jzz_delta);
    const float t75 = p->mB * p->xB;
    const float mA = p->mF + p->mH;
    const float t80 = t62 - (t44 * mA);
    const float t86 = p->IRxx + Jzz_delta + (p->xB * t75) + p->IBzz - (t44 * (t62 + t80));
    const float t87 = mu * t86;
    const float t89 = t65 + t74 + t87;
    const float M_12_Jxz_delta = cos_lam + mu;
    const float M_22 = (sin_lam * hx_delta) + (mu * (t65 + t89)) + (t74 * M_12_Jxz_delta);
    const float t101 = 1.0F / p->rF;
    const float SF = p->IFyy * t101;
    const float t104 = 1.0F / p->rR;
    const float t105 = p->IRyy * t104;
    const float ST = SF + t105;
    const float t107 = p->mR * p->rR;
    const float K0_11 = t47 - (t32 + t107);
    const float t111 = t52 * (ST - K0_11);
    const float t113 = t51 * t52;
    const float t114 = (p->c * t111) + t113;
    const float t115 = SF + t114;
    const float C1_12 = cos_lam * t115;
    const float t117 = cos_lam * SF;
    const float t118 = mu * ST;
    const float C1_21 = p->kappa - t117 - t118;
    const float t121 = mu * t75;
    const float t122 = mu * t80;
    const float t123 = t121 - t122;
    const float t124 = t64 + t123;
    const float t126 = t89 + (p->c * t124);
    const float C1_22 = yaw_per_v_delta * t126;
    const float K2_12 = cos_lam * t111;
    const float t130 = sin_lam * SF;
    const float t131 = t124 + t130;
    const float K2_22 = yaw_per_v_delta * t131;
    const float t133 = t32 - t113;
    const float t135 = t14 * M_12_Jxz_delta;
    const float M_12_w = (mu * t133) + t135;
    const float t137 = t52 * t89;
    const float t138 = t137 + t137;
    const float t140 = t60 * M_12_Jxz_delta;
    const float t141 = M_12_Jxz_delta * t140;
    const float t142 = t44 * mu;
    const float t143 = M_12_Jxz_delta + M_12_Jxz_delta;
    const float t144 = t142 * t143;
    const float t145 = t141 - t144;
    const float t146 = p->zH * sin_lam;
    const float t150 = p->mH * (t141 + t145 + (t143 * t146));
    const float t151 = mu + mu;
    const float t152 = t64 - t122;
    const float P_delta_yaw_xB = t151 * t152;
    const float t154 = t150 + P_delta_yaw_xB;
    const float M_22_w = t154 - (mu * t138);
    const float C1_12_w = yaw_per_v_delta * (t10 - t114);
    const float C1_21_w = t52 * t118;
    const float t161 = (p->mF * mu) - (p->mH * cos_lam);
    const float t162 = t52 * t123;
    const float P_delta_lateral_w = t161 - t162;
    const float t165 = t142 - t140;
    const float K0_12_mH = t146 - t165;
    const float t167 = t165 - K0_12_mH;
    const float t168 = cos_lam * t44;
    const float t169 = t167 + t168;
    const float t172 = t122 + (p->mH * t169) - t152;
    const float t174 = t52 * (t87 + t126);
    const float C1_22_w = yaw_per_v_delta * ((p->c * P_delta_lateral_w) - t172 - t174);
    const float t178 = sin_lam * P_delta_lateral_w;
    const float t179 = yaw_per_v_delta * t111;
    const float t180 = t52 * t131;
    const float K2_22_w = yaw_per_v_delta * (P_delta_lateral_w - t180);
    const float t183 = cos_lam * t133;
    const float M_22_Jzz_delta = M_12_Jxz_delta * M_12_Jxz_delta;
    const float t185 = p->c * M_22_Jzz_delta;
    const float t186 = t185 - t144;
    const float t190 = p->mF * M_12_Jxz_delta;
    const float t191 = p->rF * sin_lam;
    const float t193 = (cos_lam * t137) - (t190 * t191);
    const float M_22_c = t154 + (p->mF * (t185 + t186)) + t193 + t193;
    const float t197 = yaw_per_v_delta * ST;
    const float t198 = p->c * M_12_Jxz_delta;
    const float t200 = t142 + t191 - t198;
    const float t201 = t142 + t200;
    const float t205 = t75 - t80;
    const float t207 = t161 + (yaw_per_v_delta * t205);
    const float t212 = t172 + (p->mF * (t168 + t201)) - t124 - (yaw_per_v_delta * t86) - (p->c *
        t207);
    const float t213 = yaw_per_v_delta * t212;
    const float K0_12_c = t190 - t207;
    const float t218 = t66 - (Jxx_delta * cos_lam);
    const float t220 = sin_lam * p->c * t52;
    const float t222 = t218 + (t51 * t220);
    const float t229 = (t32 * cos_lam) + (sin_lam * t62);
    const float t232 = t41 - (sin_lam * Jzz_delta);
    const float t233 = (t44 * t229) + t232;
    const float M_22_lam = (t151 * t233) + (cos_lam * (hx_delta + t232)) - (sin_lam * (t74 + t218 +
        (p->c * t138)));
    const float t239 = sin_lam * t115;
    const float C1_21_lam = t130 + (ST * t220);
    const float t242 = t205 * t220;
    const float t243 = t229 - t242;
    const float C1_22_lam = (yaw_per_v_delta * (t233 + (p->c * t243))) - (sin_lam * t174);
    const float t251 = (sin_lam * t243) + (cos_lam * t124);
    const float t252 = sin_lam * t111;
    const float K2_22_lam = (yaw_per_v_delta * (t117 + t243)) - (sin_lam * t180);
    const float M_11_rR = t107 + t107;
    const float K2_12_IRyy = yaw_per_v_delta * t104;
    const float K2_12_rR = (p->mR * yaw_per_v_delta) - (t105 * K2_12_IRyy);
    const float C1_12_rR = p->c * K2_12_rR;
    const float C1_12_IRyy = mu * t104;
    const float C1_21_rR = t105 * C1_12_IRyy;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float C1_12_mR = p->c * K2_12_mR;
    const float C1_22_IRxx = yaw_per_v_delta * mu;
    const float M_22_IRxx = p->c * C1_22_IRxx;
    const float t270 = p->mB * p->c;
    const float t271 = p->zB * yaw_per_v_delta;
    const float t272 = t270 * t271;
    const float M_22_xB = t121 * t151;
    const float t274 = p->mB * yaw_per_v_delta;
    const float t275 = p->zB * t274;
    const float t276 = p->c + p->xB;
    const float t277 = p->c * t274;
    const float K2_22_xB = yaw_per_v_delta * t277;
    const float t280 = p->xB * mu;
    const float C1_22_xB = (t276 * K2_22_xB) + (t274 * t280);
    const float C1_22_Jxz_delta = sin_lam * yaw_per_v_delta;
    const float t284 = t270 * C1_22_Jxz_delta;
    const float M_11_zB = t47 + t47;
    const float t286 = t274 * t276;
    const float t287 = p->zB * t280;
    const float M_22_mB = t280 * t280;
    const float t289 = t271 * t276;
    const float K2_22_mB = p->xB * C1_22_IRxx;
    const float C1_22_mB = t276 * K2_22_mB;
    const float t292 = sin_lam * t280;
    const float t293 = p->mH * yaw_per_v_delta;
    const float t294 = p->zH * t293;
    const float C1_22_xH = t293 * (t169 + t198);
    const float t297 = p->mH * M_12_Jxz_delta;
    const float t298 = sin_lam * t297;
    const float K2_22_xH = M_12_Jxz_delta * t293;
    const float M_11_zH = t14 + t14;
    const float t301 = t146 + K0_12_mH;
    const float M_12_zH = p->mH * t301;
    const float K0_12_zH = p->mH * sin_lam;
    const float t305 = (t165 - t301) * K0_12_zH;
    const float t306 = p->c + p->xH;
    const float t307 = t293 * t306;
    const float t308 = sin_lam * t307;
    const float K0_22_zH = sin_lam * K0_12_zH;
    const float t310 = yaw_per_v_delta * K0_12_zH;
    const float M_11_mH = p->zH * p->zH;
    const float M_12_mH = p->zH * K0_12_mH;
    const float t313 = t44 * yaw_per_v_delta;
    const float C1_22_mA = t142 * t313;
    const float M_22_mH = (p->c * C1_22_mA) + (t60 * t145) - (t146 * t167);
    const float t320 = p->zH * yaw_per_v_delta;
    const float t321 = t306 * t320;
    const float C1_22_mH = C1_22_mA - (yaw_per_v_delta * ((t44 * t140) + (t36 * t165) + (t146 *
        t306)));
    const float K0_22_mH = sin_lam * K0_12_mH;
    const float t330 = yaw_per_v_delta * K0_12_mH;
    const float M_22_Jxx_delta = sin_lam * sin_lam;
    const float C1_22_Jzz_delta = yaw_per_v_delta * M_12_Jxz_delta;
    const float M_22_Jxz_delta = sin_lam * t143;
    const float M_11_rF = t10 + t10;
    const float M_12_rF = p->mF * (t191 + t200);
    const float P_delta_lateral_rF = p->mF * sin_lam;
    const float t338 = t200 * P_delta_lateral_rF;
    const float M_22_rF = t338 + t338;
    const float t340 = p->mF * t313;
    const float t341 = t101 * SF;
    const float C1_21_rF = M_12_Jxz_delta * t341;
    const float C1_12_rF = t340 - C1_21_rF;
    const float C1_22_rF = sin_lam * t340;
    const float t345 = sin_lam * P_delta_lateral_rF;
    const float K2_12_rF = yaw_per_v_delta * (p->mF - t341);
    const float K2_22_rF = sin_lam * K2_12_rF;
    const float M_11_mF = p->rF * p->rF;
    const float M_12_mF = p->rF * t200;
    const float M_22_mF = (p->c * (t186 + C1_22_mA)) - (t191 * (t198 - t201));
    const float C1_12_mF = p->rF * t313;
    const float C1_22_mF = t200 * t313;
    const float t358 = sin_lam * t200;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float K2_22_mF = yaw_per_v_delta * t200;
    const float M_22_IFxx = M_22_Jzz_delta + M_22_Jxx_delta;
    const float C1_12_IFyy = M_12_Jxz_delta * t101;
    const float K2_12_IFyy = yaw_per_v_delta * t101;
    const float K2_22_IFyy = t101 * C1_22_Jxz_delta;
    const float C0_21 = -(p->kappa * p->vo);
    const float K0_12 = -t124;
    const float K0_22 = -(sin_lam * t124);
    const float K0_12_w = t162 - t161;
    const float t369 = -(sin_lam * K0_12_c);
    const float K2_22_c = -(yaw_per_v_delta * K0_12_c);
    const float K0_12_lam = t242 - t229;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[1][0] = C0_21;
    matrices->c0[1][1] = 0.0F;
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
    derivatives->values[6] = t178;
    derivatives->values[7] = t179;
    derivatives->values[8] = K2_22_w;
    derivatives->values[9] = t183;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t197;
    derivatives->values[13] = t213;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = t369;
    derivatives->values[16] = K2_22_c;
    derivatives->values[17] = t222;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t239;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = t251;
    derivatives->values[24] = t252;
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
    derivatives->values[40] = t272;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t275;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = t277;
    derivatives->values[45] = t284;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t121;
    derivatives->values[49] = t286;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t274;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t287;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t289;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = t280;
    derivatives->values[59] = t292;
    derivatives->values[60] = t271;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = mu;
    derivatives->values[63] = yaw_per_v_delta;
    derivatives->values[64] = t135;
    derivatives->values[65] = t150;
    derivatives->values[66] = t294;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = t297;
    derivatives->values[69] = t298;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = t305;
    derivatives->values[74] = t307;
    derivatives->values[75] = t308;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t293;
    derivatives->values[80] = t310;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = M_12_mH;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t321;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = K0_22_mH;
    derivatives->values[89] = t320;
    derivatives->values[90] = t330;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_Jxx_delta;
    derivatives->values[93] = M_22_Jzz_delta;
    derivatives->values[94] = C1_22_Jzz_delta;
    derivatives->values[95] = M_12_Jxz_delta;
    derivatives->values[96] = M_22_Jxz_delta;
    derivatives->values[97] = C1_22_Jxz_delta;
    derivatives->values[98] = M_11_rF;
    derivatives->values[99] = M_12_rF;
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = C1_22_rF;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = P_delta_lateral_rF;
    derivatives->values[106] = t345;
    derivatives->values[107] = K2_12_rF;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = M_12_mF;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = C1_22_mF;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = t200;
    derivatives->values[116] = t358;
    derivatives->values[117] = K2_12_mF;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = K2_12_IFyy;
    derivatives->values[122] = K2_22_IFyy;
    derivatives->values[123] = p->vo;
    derivatives->values[124] = p->kappa;
}

void balance_assist_f32_with_respect_to(const balance_assist_f32_derivatives_t *derivatives,
    size_t parameter, balance_assist_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < BALANCE_ASSIST_N; row++) {
        for (size_t column = 0U; column < BALANCE_ASSIST_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c0[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
            matrices->k2[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < BALANCE_ASSIST_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &balance_assist_partials[position];
        if (partial->parameter == parameter) {
            const float value = derivatives->values[partial->value];
            const float signed_value = partial->is_negative ? (-value) : value;
            switch (partial->matrix) {
            case CARVALLO_MATRIX_M:
                matrices->m[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_C0:
                matrices->c0[partial->row][partial->column] = signed_value;
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
