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
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 41U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 41U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 73U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 42U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 48U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 79U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 54U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 54U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 58U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 38U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 59U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 27U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 27U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 74U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 36U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 47U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 78U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 51U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 51U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 52U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 53U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 62U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 62U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 45U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 43U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 63U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 66U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 64U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 64U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 67U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 35U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 65U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 13U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 4U, 75U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 4U, 72U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 1U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 4U, 76U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 14U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 80U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 0U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 5U, 77U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 10U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 81U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 6U, 83U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 7U, 71U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 7U, 71U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 7U, 28U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 8U, 86U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 8U, 86U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 8U, 34U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 8U, 23U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 8U, 89U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 8U, 85U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 8U, 85U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 8U, 87U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 84U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 15U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 33U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 33U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 9U, 91U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 3U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 9U, 24U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 16U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 10U, 30U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 10U, 30U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 10U, 31U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 10U, 92U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 10U, 90U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 10U, 2U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 10U, 29U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 10U, 29U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 10U, 32U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 10U, 25U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 10U, 88U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 11U, 10U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 13U, 81U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 13U, 83U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 14U, 21U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 14U, 21U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 14U, 22U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 15U, 40U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 15U, 40U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 61U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 26U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 82U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 49U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 49U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 50U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 94U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 17U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 60U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 60U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 96U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 99U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 101U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 5U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 20U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 20U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 103U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 93U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 100U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 18U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 55U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 55U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 56U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 105U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 98U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 44U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 44U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 95U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 104U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 97U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 18U, 10U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 18U, 11U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 18U, 11U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 18U, 102U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 20U, 106U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 20U, 39U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 21U, 37U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 21U, 37U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 21U, 46U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 21U, 22U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 21U, 110U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 22U, 19U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 22U, 68U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 22U, 68U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 114U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 22U, 118U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 22U, 109U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 22U, 119U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 22U, 7U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 22U, 120U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 22U, 120U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 22U, 121U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 117U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 22U, 124U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 23U, 12U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 69U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 69U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 70U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 123U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 116U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 6U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 57U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 57U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 113U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 122U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 115U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 10U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 11U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 11U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 107U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 39U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 108U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 108U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 112U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 111U, false},
    {CARVALLO_MATRIX_C0, 1U, 0U, 26U, 9U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 26U, 10U, false},
    {CARVALLO_MATRIX_C0, 1U, 0U, 27U, 8U, true}
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
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double M_11_mF = p->rF * p->rF;
    const double t30 = p->zH * p->mH;
    const double Jxx_delta = p->IFxx + (p->mF * M_11_mF) + p->IHxx + (p->zH * t30);
    const double t36 = p->zB * p->mB;
    const double t37 = p->rR * p->mR;
    const double t38 = p->c + p->w;
    const double M_11_rR = t37 + t37;
    const double M_11_mR = p->rR * p->rR;
    const double M_11_zB = t36 + t36;
    const double M_11_mB = p->zB * p->zB;
    const double M_11_zH = t30 + t30;
    const double M_11_mH = p->zH * p->zH;
    const double C0_21 = -(p->kappa * p->vo);
    const double t47 = t38 - p->xH;
    const double t48 = p->mH * t47;
    const double t49 = p->mF * p->c;
    const double t53 = (p->zH * t48) + p->IHxz - (p->rF * t49);
    const double t54 = 1.0 / p->w;
    const double t55 = p->mF * p->rF;
    const double M_11_rF = t55 + t55;
    const double t57 = t55 - t30;
    const double M_11 = p->IRxx + p->IBxx + Jxx_delta + (p->zB * t36) + (p->rR * t37);
    const double K0_11 = t36 - (t37 + t57);
    const double Jzz_delta = p->IFxx + p->IHzz + (p->c * t49) + (t47 * t48);
    const double t71 = p->c * t54;
    const double t72 = p->mB * p->xB;
    const double t73 = t48 + t49;
    const double t75 = t38 * (p->mF + p->mH);
    const double t77 = t48 - t72 - t75;
    const double t78 = t73 - t75;
    const double t83 = t53 + p->IBxz + (t38 * t57) - (t36 * p->xB);
    const double t90 = p->IRxx + Jzz_delta + (p->xB * t72) + p->IBzz - (t38 * (t73 + t78));
    const double K0_12_zH = p->mH * sin_lam;
    const double t92 = t49 + t77;
    const double t93 = t53 * cos_lam;
    const double t94 = t53 * sin_lam;
    const double mu = cos_lam * t71;
    const double t98 = (sin_lam * t57) - (cos_lam * t73);
    const double t99 = t78 * mu;
    const double t100 = cos_lam * t57;
    const double t102 = t100 + (sin_lam * t73);
    const double hx_delta = t93 + (Jxx_delta * sin_lam);
    const double t106 = (cos_lam * Jzz_delta) + t94;
    const double t107 = t54 * t83;
    const double t108 = 1.0 / p->rF;
    const double t109 = 1.0 / p->rR;
    const double yaw_per_v_delta = cos_lam * t54;
    const double t111 = t36 * yaw_per_v_delta;
    const double t112 = p->mB * yaw_per_v_delta;
    const double t113 = p->zB * yaw_per_v_delta;
    const double t114 = t30 * yaw_per_v_delta;
    const double SF = p->IFyy * t108;
    const double t116 = cos_lam * t107;
    const double t121 = yaw_per_v_delta * (t93 + (t38 * t102) - (sin_lam * Jzz_delta));
    const double t122 = t90 * mu;
    const double t124 = t106 + (t38 * t98);
    const double t125 = t98 - t99;
    const double M_12 = hx_delta + (p->c * t116);
    const double M_12_c = t116 - t100;
    const double t129 = p->IRyy * t109;
    const double K2_12_IRyy = t109 * yaw_per_v_delta;
    const double ST = SF + t129;
    const double t132 = cos_lam * SF;
    const double t133 = p->xB * mu;
    const double t135 = t54 * (ST - K0_11);
    const double C1_21 = p->kappa - (mu * ST) - t132;
    const double t139 = p->zB * t133;
    const double M_22_mB = t133 * t133;
    const double t141 = sin_lam * t133;
    const double t142 = t122 + t124;
    const double t143 = p->mB * t133;
    const double t144 = t125 + t143;
    const double t145 = mu * t143;
    const double M_22_xB = t145 + t145;
    const double t148 = t106 + (t71 * t142);
    const double K0_12 = -t144;
    const double K0_22 = -(sin_lam * t144);
    const double t153 = t142 + (p->c * t144);
    const double t155 = t107 + (p->c * t135);
    const double t156 = t142 * yaw_per_v_delta;
    const double t157 = t156 + t156;
    const double t158 = sin_lam * t135;
    const double K2_12 = cos_lam * t135;
    const double t160 = sin_lam * SF;
    const double t162 = t54 * (t144 + t160);
    const double M_12_Jxz_delta = cos_lam + mu;
    const double t164 = t54 * K2_12;
    const double C1_22_Jzz_delta = yaw_per_v_delta * M_12_Jxz_delta;
    const double t166 = t30 * M_12_Jxz_delta;
    const double M_12_w = t166 - (t71 * M_12_c);
    const double M_22 = (sin_lam * hx_delta) + (cos_lam * (t148 + (t71 * t124)));
    const double C1_12_w = yaw_per_v_delta * (t55 - t155);
    const double t180 = (sin_lam * t148) - (cos_lam * hx_delta) - (p->c * t121);
    const double t181 = SF + t155;
    const double C1_22 = yaw_per_v_delta * t153;
    const double t184 = t54 * (t122 + t153);
    const double C1_12 = cos_lam * t181;
    const double t186 = sin_lam * t181;
    const double K2_22 = cos_lam * t162;
    const double t190 = cos_lam * (p->mF + (t54 * t92));
    const double t191 = t38 * mu;
    const double K0_12_mH = (p->zH * sin_lam) + (t47 * M_12_Jxz_delta) - t191;
    const double t196 = M_12_Jxz_delta + M_12_Jxz_delta;
    const double t197 = t180 + t180;
    const double M_22_Jxz_delta = sin_lam * t196;
    const double t199 = ST * yaw_per_v_delta;
    const double C1_21_w = t71 * t199;
    const double t201 = t71 * t190;
    const double t202 = p->mH * M_12_Jxz_delta;
    const double t203 = sin_lam * t202;
    const double t204 = p->mH * cos_lam;
    const double K0_12_c = t190 + t204;
    const double K0_22_c = sin_lam * K0_12_c;
    const double t207 = yaw_per_v_delta * K0_12_c;
    const double K0_12_w = t204 - t201;
    const double M_12_mH = p->zH * K0_12_mH;
    const double M_22_mH = K0_12_mH * K0_12_mH;
    const double t211 = p->mH * K0_12_mH;
    const double t212 = p->rF * sin_lam;
    const double t213 = t191 + t212;
    const double K0_12_mF = (p->c * M_12_Jxz_delta) - t213;
    const double K0_22_w = sin_lam * K0_12_w;
    const double t218 = yaw_per_v_delta * (t162 + K0_12_w);
    const double M_22_hz_delta = (p->xH * t202) + (p->c * t204) - t211;
    const double M_12_zH = t211 + (t30 * sin_lam);
    const double t225 = t211 * t196;
    const double t226 = sin_lam * t71;
    const double M_12_lam = (Jxx_delta * cos_lam) - t94 - (t83 * t226);
    const double C1_21_lam = t160 + (ST * t226);
    const double t234 = t102 + (t92 * t226);
    const double K2_22_lam = (yaw_per_v_delta * (t132 + t234)) - (sin_lam * t162);
    const double C1_22_lam = t121 + (mu * t234) - (sin_lam * t184);
    const double t245 = (cos_lam * t144) + (sin_lam * t234);
    const double M_12_rF = p->mF * (t212 - K0_12_mF);
    const double t250 = (mu * (t125 + t125)) + t225;
    const double t252 = t125 - t99 - M_22_hz_delta;
    const double t253 = p->rF * K0_12_mF;
    const double M_22_mF = K0_12_mF * K0_12_mF;
    const double t255 = t129 * K2_12_IRyy;
    const double C1_12_IRyy = p->c * K2_12_IRyy;
    const double C1_21_rR = t129 * C1_12_IRyy;
    const double t258 = p->mR * yaw_per_v_delta;
    const double M_22_w = t250 - (t71 * t157);
    const double M_22_c = t250 + t157 + (p->mF * t196 * K0_12_mF);
    const double t266 = p->c * (t255 - t258);
    const double K2_12_rR = t258 - t255;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double C1_22_c = yaw_per_v_delta * (t144 + t252 + (t90 * yaw_per_v_delta) - (p->mF *
        (t213 + (p->w * M_12_Jxz_delta))) - (mu * t77));
    const double C1_22_w = yaw_per_v_delta * ((p->c * t201) + t252 - t184);
    const double C1_12_mR = p->c * K2_12_mR;
    const double M_22_IRxx = mu * mu;
    const double C1_22_xH = (yaw_per_v_delta * M_22_hz_delta) + (p->mH * M_22_IRxx);
    const double C1_22_IRxx = mu * yaw_per_v_delta;
    const double K2_22_xB = p->mB * C1_22_IRxx;
    const double t290 = p->mB * mu;
    const double t291 = p->zB * t290;
    const double t292 = sin_lam * t290;
    const double t293 = p->xB * yaw_per_v_delta;
    const double K2_22_mB = mu * t293;
    const double t295 = mu + t293;
    const double C1_22_xB = t290 * (t293 + t295);
    const double C1_22_mB = t133 * t295;
    const double t299 = p->mB * t295;
    const double t300 = p->zB * t295;
    const double t301 = p->mH * yaw_per_v_delta;
    const double K2_22_xH = M_12_Jxz_delta * t301;
    const double K0_22_mH = sin_lam * K0_12_mH;
    const double t304 = p->mH * K0_22_mH;
    const double M_22_zH = t304 + t304;
    const double t306 = yaw_per_v_delta * K0_12_mH;
    const double t307 = p->c + p->xH;
    const double t308 = t307 * t306;
    const double t309 = t301 * t307;
    const double t310 = sin_lam * t301;
    const double t311 = t307 * t310;
    const double M_22_Jxx_delta = sin_lam * sin_lam;
    const double K0_22_zH = p->mH * M_22_Jxx_delta;
    const double t314 = p->zH * yaw_per_v_delta;
    const double t315 = t307 * t314;
    const double M_22_Jzz_delta = M_12_Jxz_delta * M_12_Jxz_delta;
    const double M_22_IFxx = M_22_Jxx_delta + M_22_Jzz_delta;
    const double C1_12_IFyy = t108 * M_12_Jxz_delta;
    const double C1_21_rF = SF * C1_12_IFyy;
    const double C1_22_Jxz_delta = sin_lam * yaw_per_v_delta;
    const double K2_22_IFyy = t108 * C1_22_Jxz_delta;
    const double K2_12_IFyy = t108 * yaw_per_v_delta;
    const double K0_22_mF = sin_lam * K0_12_mF;
    const double t324 = p->mF * K0_22_mF;
    const double t325 = t324 + t324;
    const double t326 = yaw_per_v_delta * K0_12_mF;
    const double t327 = t38 * t326;
    const double t328 = p->mF * yaw_per_v_delta;
    const double K2_12_rF = t328 - (SF * K2_12_IFyy);
    const double t331 = t38 * t328;
    const double C1_12_rF = t331 - C1_21_rF;
    const double C1_22_rF = sin_lam * t331;
    const double P_delta_lateral_rF = p->mF * sin_lam;
    const double t335 = sin_lam * P_delta_lateral_rF;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double C1_12_mF = t38 * K2_12_mF;
    const double t339 = -(sin_lam * K2_12_rF);
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
    derivatives->values[0] = p->rR;
    derivatives->values[1] = p->mR;
    derivatives->values[2] = p->zB;
    derivatives->values[3] = p->mB;
    derivatives->values[4] = p->zH;
    derivatives->values[5] = p->mH;
    derivatives->values[6] = p->rF;
    derivatives->values[7] = p->mF;
    derivatives->values[8] = p->kappa;
    derivatives->values[9] = p->vo;
    derivatives->values[10] = 1.0;
    derivatives->values[11] = sin_lam;
    derivatives->values[12] = M_11_mF;
    derivatives->values[13] = M_11_rR;
    derivatives->values[14] = M_11_mR;
    derivatives->values[15] = M_11_zB;
    derivatives->values[16] = M_11_mB;
    derivatives->values[17] = M_11_zH;
    derivatives->values[18] = M_11_mH;
    derivatives->values[19] = M_11_rF;
    derivatives->values[20] = K0_12_zH;
    derivatives->values[21] = mu;
    derivatives->values[22] = yaw_per_v_delta;
    derivatives->values[23] = t111;
    derivatives->values[24] = t112;
    derivatives->values[25] = t113;
    derivatives->values[26] = t114;
    derivatives->values[27] = M_12_c;
    derivatives->values[28] = K2_12_IRyy;
    derivatives->values[29] = t133;
    derivatives->values[30] = t139;
    derivatives->values[31] = M_22_mB;
    derivatives->values[32] = t141;
    derivatives->values[33] = t143;
    derivatives->values[34] = M_22_xB;
    derivatives->values[35] = t158;
    derivatives->values[36] = K2_12;
    derivatives->values[37] = M_12_Jxz_delta;
    derivatives->values[38] = t164;
    derivatives->values[39] = C1_22_Jzz_delta;
    derivatives->values[40] = t166;
    derivatives->values[41] = M_12_w;
    derivatives->values[42] = C1_12_w;
    derivatives->values[43] = t186;
    derivatives->values[44] = K0_12_mH;
    derivatives->values[45] = t197;
    derivatives->values[46] = M_22_Jxz_delta;
    derivatives->values[47] = t199;
    derivatives->values[48] = C1_21_w;
    derivatives->values[49] = t202;
    derivatives->values[50] = t203;
    derivatives->values[51] = K0_12_c;
    derivatives->values[52] = K0_22_c;
    derivatives->values[53] = t207;
    derivatives->values[54] = K0_12_w;
    derivatives->values[55] = M_12_mH;
    derivatives->values[56] = M_22_mH;
    derivatives->values[57] = K0_12_mF;
    derivatives->values[58] = K0_22_w;
    derivatives->values[59] = t218;
    derivatives->values[60] = M_12_zH;
    derivatives->values[61] = t225;
    derivatives->values[62] = M_12_lam;
    derivatives->values[63] = C1_21_lam;
    derivatives->values[64] = t234;
    derivatives->values[65] = K2_22_lam;
    derivatives->values[66] = C1_22_lam;
    derivatives->values[67] = t245;
    derivatives->values[68] = M_12_rF;
    derivatives->values[69] = t253;
    derivatives->values[70] = M_22_mF;
    derivatives->values[71] = C1_12_IRyy;
    derivatives->values[72] = C1_21_rR;
    derivatives->values[73] = M_22_w;
    derivatives->values[74] = M_22_c;
    derivatives->values[75] = t266;
    derivatives->values[76] = K2_12_rR;
    derivatives->values[77] = K2_12_mR;
    derivatives->values[78] = C1_22_c;
    derivatives->values[79] = C1_22_w;
    derivatives->values[80] = C1_12_mR;
    derivatives->values[81] = M_22_IRxx;
    derivatives->values[82] = C1_22_xH;
    derivatives->values[83] = C1_22_IRxx;
    derivatives->values[84] = K2_22_xB;
    derivatives->values[85] = t290;
    derivatives->values[86] = t291;
    derivatives->values[87] = t292;
    derivatives->values[88] = K2_22_mB;
    derivatives->values[89] = C1_22_xB;
    derivatives->values[90] = C1_22_mB;
    derivatives->values[91] = t299;
    derivatives->values[92] = t300;
    derivatives->values[93] = t301;
    derivatives->values[94] = K2_22_xH;
    derivatives->values[95] = K0_22_mH;
    derivatives->values[96] = M_22_zH;
    derivatives->values[97] = t306;
    derivatives->values[98] = t308;
    derivatives->values[99] = t309;
    derivatives->values[100] = t310;
    derivatives->values[101] = t311;
    derivatives->values[102] = M_22_Jxx_delta;
    derivatives->values[103] = K0_22_zH;
    derivatives->values[104] = t314;
    derivatives->values[105] = t315;
    derivatives->values[106] = M_22_Jzz_delta;
    derivatives->values[107] = M_22_IFxx;
    derivatives->values[108] = C1_12_IFyy;
    derivatives->values[109] = C1_21_rF;
    derivatives->values[110] = C1_22_Jxz_delta;
    derivatives->values[111] = K2_22_IFyy;
    derivatives->values[112] = K2_12_IFyy;
    derivatives->values[113] = K0_22_mF;
    derivatives->values[114] = t325;
    derivatives->values[115] = t326;
    derivatives->values[116] = t327;
    derivatives->values[117] = K2_12_rF;
    derivatives->values[118] = C1_12_rF;
    derivatives->values[119] = C1_22_rF;
    derivatives->values[120] = P_delta_lateral_rF;
    derivatives->values[121] = t335;
    derivatives->values[122] = K2_12_mF;
    derivatives->values[123] = C1_12_mF;
    derivatives->values[124] = t339;
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
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float M_11_mF = p->rF * p->rF;
    const float t30 = p->zH * p->mH;
    const float Jxx_delta = p->IFxx + (p->mF * M_11_mF) + p->IHxx + (p->zH * t30);
    const float t36 = p->zB * p->mB;
    const float t37 = p->rR * p->mR;
    const float t38 = p->c + p->w;
    const float M_11_rR = t37 + t37;
    const float M_11_mR = p->rR * p->rR;
    const float M_11_zB = t36 + t36;
    const float M_11_mB = p->zB * p->zB;
    const float M_11_zH = t30 + t30;
    const float M_11_mH = p->zH * p->zH;
    const float C0_21 = -(p->kappa * p->vo);
    const float t47 = t38 - p->xH;
    const float t48 = p->mH * t47;
    const float t49 = p->mF * p->c;
    const float t53 = (p->zH * t48) + p->IHxz - (p->rF * t49);
    const float t54 = 1.0F / p->w;
    const float t55 = p->mF * p->rF;
    const float M_11_rF = t55 + t55;
    const float t57 = t55 - t30;
    const float M_11 = p->IRxx + p->IBxx + Jxx_delta + (p->zB * t36) + (p->rR * t37);
    const float K0_11 = t36 - (t37 + t57);
    const float Jzz_delta = p->IFxx + p->IHzz + (p->c * t49) + (t47 * t48);
    const float t71 = p->c * t54;
    const float t72 = p->mB * p->xB;
    const float t73 = t48 + t49;
    const float t75 = t38 * (p->mF + p->mH);
    const float t77 = t48 - t72 - t75;
    const float t78 = t73 - t75;
    const float t83 = t53 + p->IBxz + (t38 * t57) - (t36 * p->xB);
    const float t90 = p->IRxx + Jzz_delta + (p->xB * t72) + p->IBzz - (t38 * (t73 + t78));
    const float K0_12_zH = p->mH * sin_lam;
    const float t92 = t49 + t77;
    const float t93 = t53 * cos_lam;
    const float t94 = t53 * sin_lam;
    const float mu = cos_lam * t71;
    const float t98 = (sin_lam * t57) - (cos_lam * t73);
    const float t99 = t78 * mu;
    const float t100 = cos_lam * t57;
    const float t102 = t100 + (sin_lam * t73);
    const float hx_delta = t93 + (Jxx_delta * sin_lam);
    const float t106 = (cos_lam * Jzz_delta) + t94;
    const float t107 = t54 * t83;
    const float t108 = 1.0F / p->rF;
    const float t109 = 1.0F / p->rR;
    const float yaw_per_v_delta = cos_lam * t54;
    const float t111 = t36 * yaw_per_v_delta;
    const float t112 = p->mB * yaw_per_v_delta;
    const float t113 = p->zB * yaw_per_v_delta;
    const float t114 = t30 * yaw_per_v_delta;
    const float SF = p->IFyy * t108;
    const float t116 = cos_lam * t107;
    const float t121 = yaw_per_v_delta * (t93 + (t38 * t102) - (sin_lam * Jzz_delta));
    const float t122 = t90 * mu;
    const float t124 = t106 + (t38 * t98);
    const float t125 = t98 - t99;
    const float M_12 = hx_delta + (p->c * t116);
    const float M_12_c = t116 - t100;
    const float t129 = p->IRyy * t109;
    const float K2_12_IRyy = t109 * yaw_per_v_delta;
    const float ST = SF + t129;
    const float t132 = cos_lam * SF;
    const float t133 = p->xB * mu;
    const float t135 = t54 * (ST - K0_11);
    const float C1_21 = p->kappa - (mu * ST) - t132;
    const float t139 = p->zB * t133;
    const float M_22_mB = t133 * t133;
    const float t141 = sin_lam * t133;
    const float t142 = t122 + t124;
    const float t143 = p->mB * t133;
    const float t144 = t125 + t143;
    const float t145 = mu * t143;
    const float M_22_xB = t145 + t145;
    const float t148 = t106 + (t71 * t142);
    const float K0_12 = -t144;
    const float K0_22 = -(sin_lam * t144);
    const float t153 = t142 + (p->c * t144);
    const float t155 = t107 + (p->c * t135);
    const float t156 = t142 * yaw_per_v_delta;
    const float t157 = t156 + t156;
    const float t158 = sin_lam * t135;
    const float K2_12 = cos_lam * t135;
    const float t160 = sin_lam * SF;
    const float t162 = t54 * (t144 + t160);
    const float M_12_Jxz_delta = cos_lam + mu;
    const float t164 = t54 * K2_12;
    const float C1_22_Jzz_delta = yaw_per_v_delta * M_12_Jxz_delta;
    const float t166 = t30 * M_12_Jxz_delta;
    const float M_12_w = t166 - (t71 * M_12_c);
    const float M_22 = (sin_lam * hx_delta) + (cos_lam * (t148 + (t71 * t124)));
    const float C1_12_w = yaw_per_v_delta * (t55 - t155);
    const float t180 = (sin_lam * t148) - (cos_lam * hx_delta) - (p->c * t121);
    const float t181 = SF + t155;
    const float C1_22 = yaw_per_v_delta * t153;
    const float t184 = t54 * (t122 + t153);
    const float C1_12 = cos_lam * t181;
    const float t186 = sin_lam * t181;
    const float K2_22 = cos_lam * t162;
    const float t190 = cos_lam * (p->mF + (t54 * t92));
    const float t191 = t38 * mu;
    const float K0_12_mH = (p->zH * sin_lam) + (t47 * M_12_Jxz_delta) - t191;
    const float t196 = M_12_Jxz_delta + M_12_Jxz_delta;
    const float t197 = t180 + t180;
    const float M_22_Jxz_delta = sin_lam * t196;
    const float t199 = ST * yaw_per_v_delta;
    const float C1_21_w = t71 * t199;
    const float t201 = t71 * t190;
    const float t202 = p->mH * M_12_Jxz_delta;
    const float t203 = sin_lam * t202;
    const float t204 = p->mH * cos_lam;
    const float K0_12_c = t190 + t204;
    const float K0_22_c = sin_lam * K0_12_c;
    const float t207 = yaw_per_v_delta * K0_12_c;
    const float K0_12_w = t204 - t201;
    const float M_12_mH = p->zH * K0_12_mH;
    const float M_22_mH = K0_12_mH * K0_12_mH;
    const float t211 = p->mH * K0_12_mH;
    const float t212 = p->rF * sin_lam;
    const float t213 = t191 + t212;
    const float K0_12_mF = (p->c * M_12_Jxz_delta) - t213;
    const float K0_22_w = sin_lam * K0_12_w;
    const float t218 = yaw_per_v_delta * (t162 + K0_12_w);
    const float M_22_hz_delta = (p->xH * t202) + (p->c * t204) - t211;
    const float M_12_zH = t211 + (t30 * sin_lam);
    const float t225 = t211 * t196;
    const float t226 = sin_lam * t71;
    const float M_12_lam = (Jxx_delta * cos_lam) - t94 - (t83 * t226);
    const float C1_21_lam = t160 + (ST * t226);
    const float t234 = t102 + (t92 * t226);
    const float K2_22_lam = (yaw_per_v_delta * (t132 + t234)) - (sin_lam * t162);
    const float C1_22_lam = t121 + (mu * t234) - (sin_lam * t184);
    const float t245 = (cos_lam * t144) + (sin_lam * t234);
    const float M_12_rF = p->mF * (t212 - K0_12_mF);
    const float t250 = (mu * (t125 + t125)) + t225;
    const float t252 = t125 - t99 - M_22_hz_delta;
    const float t253 = p->rF * K0_12_mF;
    const float M_22_mF = K0_12_mF * K0_12_mF;
    const float t255 = t129 * K2_12_IRyy;
    const float C1_12_IRyy = p->c * K2_12_IRyy;
    const float C1_21_rR = t129 * C1_12_IRyy;
    const float t258 = p->mR * yaw_per_v_delta;
    const float M_22_w = t250 - (t71 * t157);
    const float M_22_c = t250 + t157 + (p->mF * t196 * K0_12_mF);
    const float t266 = p->c * (t255 - t258);
    const float K2_12_rR = t258 - t255;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float C1_22_c = yaw_per_v_delta * (t144 + t252 + (t90 * yaw_per_v_delta) - (p->mF *
        (t213 + (p->w * M_12_Jxz_delta))) - (mu * t77));
    const float C1_22_w = yaw_per_v_delta * ((p->c * t201) + t252 - t184);
    const float C1_12_mR = p->c * K2_12_mR;
    const float M_22_IRxx = mu * mu;
    const float C1_22_xH = (yaw_per_v_delta * M_22_hz_delta) + (p->mH * M_22_IRxx);
    const float C1_22_IRxx = mu * yaw_per_v_delta;
    const float K2_22_xB = p->mB * C1_22_IRxx;
    const float t290 = p->mB * mu;
    const float t291 = p->zB * t290;
    const float t292 = sin_lam * t290;
    const float t293 = p->xB * yaw_per_v_delta;
    const float K2_22_mB = mu * t293;
    const float t295 = mu + t293;
    const float C1_22_xB = t290 * (t293 + t295);
    const float C1_22_mB = t133 * t295;
    const float t299 = p->mB * t295;
    const float t300 = p->zB * t295;
    const float t301 = p->mH * yaw_per_v_delta;
    const float K2_22_xH = M_12_Jxz_delta * t301;
    const float K0_22_mH = sin_lam * K0_12_mH;
    const float t304 = p->mH * K0_22_mH;
    const float M_22_zH = t304 + t304;
    const float t306 = yaw_per_v_delta * K0_12_mH;
    const float t307 = p->c + p->xH;
    const float t308 = t307 * t306;
    const float t309 = t301 * t307;
    const float t310 = sin_lam * t301;
    const float t311 = t307 * t310;
    const float M_22_Jxx_delta = sin_lam * sin_lam;
    const float K0_22_zH = p->mH * M_22_Jxx_delta;
    const float t314 = p->zH * yaw_per_v_delta;
    const float t315 = t307 * t314;
    const float M_22_Jzz_delta = M_12_Jxz_delta * M_12_Jxz_delta;
    const float M_22_IFxx = M_22_Jxx_delta + M_22_Jzz_delta;
    const float C1_12_IFyy = t108 * M_12_Jxz_delta;
    const float C1_21_rF = SF * C1_12_IFyy;
    const float C1_22_Jxz_delta = sin_lam * yaw_per_v_delta;
    const float K2_22_IFyy = t108 * C1_22_Jxz_delta;
    const float K2_12_IFyy = t108 * yaw_per_v_delta;
    const float K0_22_mF = sin_lam * K0_12_mF;
    const float t324 = p->mF * K0_22_mF;
    const float t325 = t324 + t324;
    const float t326 = yaw_per_v_delta * K0_12_mF;
    const float t327 = t38 * t326;
    const float t328 = p->mF * yaw_per_v_delta;
    const float K2_12_rF = t328 - (SF * K2_12_IFyy);
    const float t331 = t38 * t328;
    const float C1_12_rF = t331 - C1_21_rF;
    const float C1_22_rF = sin_lam * t331;
    const float P_delta_lateral_rF = p->mF * sin_lam;
    const float t335 = sin_lam * P_delta_lateral_rF;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float C1_12_mF = t38 * K2_12_mF;
    const float t339 = -(sin_lam * K2_12_rF);
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
    derivatives->values[0] = p->rR;
    derivatives->values[1] = p->mR;
    derivatives->values[2] = p->zB;
    derivatives->values[3] = p->mB;
    derivatives->values[4] = p->zH;
    derivatives->values[5] = p->mH;
    derivatives->values[6] = p->rF;
    derivatives->values[7] = p->mF;
    derivatives->values[8] = p->kappa;
    derivatives->values[9] = p->vo;
    derivatives->values[10] = 1.0F;
    derivatives->values[11] = sin_lam;
    derivatives->values[12] = M_11_mF;
    derivatives->values[13] = M_11_rR;
    derivatives->values[14] = M_11_mR;
    derivatives->values[15] = M_11_zB;
    derivatives->values[16] = M_11_mB;
    derivatives->values[17] = M_11_zH;
    derivatives->values[18] = M_11_mH;
    derivatives->values[19] = M_11_rF;
    derivatives->values[20] = K0_12_zH;
    derivatives->values[21] = mu;
    derivatives->values[22] = yaw_per_v_delta;
    derivatives->values[23] = t111;
    derivatives->values[24] = t112;
    derivatives->values[25] = t113;
    derivatives->values[26] = t114;
    derivatives->values[27] = M_12_c;
    derivatives->values[28] = K2_12_IRyy;
    derivatives->values[29] = t133;
    derivatives->values[30] = t139;
    derivatives->values[31] = M_22_mB;
    derivatives->values[32] = t141;
    derivatives->values[33] = t143;
    derivatives->values[34] = M_22_xB;
    derivatives->values[35] = t158;
    derivatives->values[36] = K2_12;
    derivatives->values[37] = M_12_Jxz_delta;
    derivatives->values[38] = t164;
    derivatives->values[39] = C1_22_Jzz_delta;
    derivatives->values[40] = t166;
    derivatives->values[41] = M_12_w;
    derivatives->values[42] = C1_12_w;
    derivatives->values[43] = t186;
    derivatives->values[44] = K0_12_mH;
    derivatives->values[45] = t197;
    derivatives->values[46] = M_22_Jxz_delta;
    derivatives->values[47] = t199;
    derivatives->values[48] = C1_21_w;
    derivatives->values[49] = t202;
    derivatives->values[50] = t203;
    derivatives->values[51] = K0_12_c;
    derivatives->values[52] = K0_22_c;
    derivatives->values[53] = t207;
    derivatives->values[54] = K0_12_w;
    derivatives->values[55] = M_12_mH;
    derivatives->values[56] = M_22_mH;
    derivatives->values[57] = K0_12_mF;
    derivatives->values[58] = K0_22_w;
    derivatives->values[59] = t218;
    derivatives->values[60] = M_12_zH;
    derivatives->values[61] = t225;
    derivatives->values[62] = M_12_lam;
    derivatives->values[63] = C1_21_lam;
    derivatives->values[64] = t234;
    derivatives->values[65] = K2_22_lam;
    derivatives->values[66] = C1_22_lam;
    derivatives->values[67] = t245;
    derivatives->values[68] = M_12_rF;
    derivatives->values[69] = t253;
    derivatives->values[70] = M_22_mF;
    derivatives->values[71] = C1_12_IRyy;
    derivatives->values[72] = C1_21_rR;
    derivatives->values[73] = M_22_w;
    derivatives->values[74] = M_22_c;
    derivatives->values[75] = t266;
    derivatives->values[76] = K2_12_rR;
    derivatives->values[77] = K2_12_mR;
    derivatives->values[78] = C1_22_c;
    derivatives->values[79] = C1_22_w;
    derivatives->values[80] = C1_12_mR;
    derivatives->values[81] = M_22_IRxx;
    derivatives->values[82] = C1_22_xH;
    derivatives->values[83] = C1_22_IRxx;
    derivatives->values[84] = K2_22_xB;
    derivatives->values[85] = t290;
    derivatives->values[86] = t291;
    derivatives->values[87] = t292;
    derivatives->values[88] = K2_22_mB;
    derivatives->values[89] = C1_22_xB;
    derivatives->values[90] = C1_22_mB;
    derivatives->values[91] = t299;
    derivatives->values[92] = t300;
    derivatives->values[93] = t301;
    derivatives->values[94] = K2_22_xH;
    derivatives->values[95] = K0_22_mH;
    derivatives->values[96] = M_22_zH;
    derivatives->values[97] = t306;
    derivatives->values[98] = t308;
    derivatives->values[99] = t309;
    derivatives->values[100] = t310;
    derivatives->values[101] = t311;
    derivatives->values[102] = M_22_Jxx_delta;
    derivatives->values[103] = K0_22_zH;
    derivatives->values[104] = t314;
    derivatives->values[105] = t315;
    derivatives->values[106] = M_22_Jzz_delta;
    derivatives->values[107] = M_22_IFxx;
    derivatives->values[108] = C1_12_IFyy;
    derivatives->values[109] = C1_21_rF;
    derivatives->values[110] = C1_22_Jxz_delta;
    derivatives->values[111] = K2_22_IFyy;
    derivatives->values[112] = K2_12_IFyy;
    derivatives->values[113] = K0_22_mF;
    derivatives->values[114] = t325;
    derivatives->values[115] = t326;
    derivatives->values[116] = t327;
    derivatives->values[117] = K2_12_rF;
    derivatives->values[118] = C1_12_rF;
    derivatives->values[119] = C1_22_rF;
    derivatives->values[120] = P_delta_lateral_rF;
    derivatives->values[121] = t335;
    derivatives->values[122] = K2_12_mF;
    derivatives->values[123] = C1_12_mF;
    derivatives->values[124] = t339;
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
