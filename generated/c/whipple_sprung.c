/* @generated from generated/models/whipple_sprung.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 578b2dd2541ebae4
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * yaw_by_delta = c*cos(lam)/w [1]
 * yaw_per_v_delta = cos(lam)/w [1/m]
 * Jxx_delta = IHxx + IFxx + zH^2*mH + rF^2*mF [kg*m^2]
 * Jxz_delta = IHxz - c*rF*mF - zH*mH*(xH - (w + c)) [kg*m^2]
 * Jzz_delta = mH*(xH - (w + c))^2 + IHzz + IFxx + c^2*mF [kg*m^2]
 * Sx_delta = mH*(xH - (w + c)) - c*mF [kg*m]
 * Sz_delta = zH*mH - rF*mF [kg*m]
 * m_delta = mH + mF [kg]
 * py_delta = Sx_delta*cos(lam) - Sz_delta*sin(lam) [kg*m]
 * hx_delta = Jxx_delta*sin(lam) + Jxz_delta*cos(lam) [kg*m^2]
 * hz_delta = Jxz_delta*sin(lam) + Jzz_delta*cos(lam) [kg*m^2]
 * Jxx_all = IRxx + IBxx + Jxx_delta + rR^2*mR + zB^2*mB [kg*m^2]
 * Jxz_all = IBxz + Jxz_delta - xB*zB*mB - Sz_delta*(w + c) [kg*m^2]
 * Jzz_all = IRxx + IBzz + IHzz + IFxx + w^2*mF + xB^2*mB + xH^2*mH [kg*m^2]
 * Sx_all = xB*mB + Sx_delta + m_delta*(w + c) [kg*m]
 * Sz_all = zB*mB + Sz_delta - rR*mR [kg*m]
 * load_spin_F = -Sx_all/w [kg]
 * h_spin_R = IRyy/rR [kg*m]
 * h_spin_F = IFyy/rF [kg*m]
 * h_wheels_all = h_spin_R + h_spin_F [kg*m]
 * M_yaw_delta = py_delta*(w + c) + hz_delta [kg*m^2]
 * M_delta_delta = hx_delta*sin(lam) + hz_delta*cos(lam) [kg*m^2]
 * K_phi_delta = c*load_spin_F*cos(lam) - py_delta [kg*m]
 * K_delta_delta = (c*load_spin_F*cos(lam) - py_delta)*sin(lam) [kg*m]
 * P_delta_lateral = yaw_by_delta*Sx_all + py_delta [kg*m]
 * P_delta_yaw = yaw_by_delta*Jzz_all + M_yaw_delta [kg*m^2]
 * P_delta_delta = yaw_by_delta*M_yaw_delta + M_delta_delta [kg*m^2]
 * M_11 = Jxx_all [kg*m^2]
 * M_12 = M_21 = yaw_by_delta*Jxz_all + hx_delta [kg*m^2]
 * M_22 = yaw_by_delta*P_delta_yaw + P_delta_delta [kg*m^2]
 * C0_22 = d [kg*m^2/s]
 * C1_12 = yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_F*cos(lam) [kg*m]
 * C1_21 = -(yaw_by_delta*h_wheels_all + h_spin_F*cos(lam)) [kg*m]
 * C1_22 = yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
 * Kc_22 = k [kg*m^2/s^2]
 * K0_11 = Sz_all [kg*m]
 * K0_12 = K0_21 = K_phi_delta [kg*m]
 * K0_22 = K_delta_delta [kg*m]
 * K2_12 = yaw_per_v_delta*(h_wheels_all - Sz_all) [kg]
 * K2_22 = yaw_per_v_delta*(h_spin_F*sin(lam) + P_delta_lateral) [kg]
 * @endverbatim
 */

#include "whipple_sprung.h"

#include "carvallo_trig.h"

#include <float.h>

const char *whipple_sprung_set_name(whipple_sprung_set_t set)
{
    static const char *const TEXTS[] = {
        "benchmark",
        "benchmark_2005",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *whipple_sprung_validity_text(whipple_sprung_validity_t validity)
{
    static const char *const TEXTS[] = {
        "WhippleSprung: the parameters are valid",
        "WhippleSprung: w in m must be finite and > 0",
        "WhippleSprung: c in m must be finite",
        "WhippleSprung: lam in rad must be finite and > -1.5707963267948966 and < 1.5707963267948966",
        "WhippleSprung: g in N/kg must be finite and >= 0",
        "WhippleSprung: rR in m must be finite and > 0",
        "WhippleSprung: mR in kg must be finite and >= 0",
        "WhippleSprung: IRxx in kg*m^2 must be finite and >= 0",
        "WhippleSprung: IRyy in kg*m^2 must be finite and >= 0",
        "WhippleSprung: xB in m must be finite",
        "WhippleSprung: zB in m must be finite",
        "WhippleSprung: mB in kg must be finite and >= 0",
        "WhippleSprung: IBxx in kg*m^2 must be finite and >= 0",
        "WhippleSprung: IByy in kg*m^2 must be finite and >= 0",
        "WhippleSprung: IBzz in kg*m^2 must be finite and >= 0",
        "WhippleSprung: IBxz in kg*m^2 must be finite",
        "WhippleSprung: xH in m must be finite",
        "WhippleSprung: zH in m must be finite",
        "WhippleSprung: mH in kg must be finite and >= 0",
        "WhippleSprung: IHxx in kg*m^2 must be finite and >= 0",
        "WhippleSprung: IHyy in kg*m^2 must be finite and >= 0",
        "WhippleSprung: IHzz in kg*m^2 must be finite and >= 0",
        "WhippleSprung: IHxz in kg*m^2 must be finite",
        "WhippleSprung: rF in m must be finite and > 0",
        "WhippleSprung: mF in kg must be finite and >= 0",
        "WhippleSprung: IFxx in kg*m^2 must be finite and >= 0",
        "WhippleSprung: IFyy in kg*m^2 must be finite and >= 0",
        "WhippleSprung: k in N*m must be finite and >= 0",
        "WhippleSprung: d in N*m*s must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t whipple_sprung_partials[WHIPPLE_SPRUNG_PARTIALS] = {
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
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 17U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 17U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 18U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 19U, false},
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
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 107U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 22U, 108U, true},
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
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 120U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 121U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 122U, false},
    {CARVALLO_MATRIX_KC, 1U, 1U, 26U, 35U, false},
    {CARVALLO_MATRIX_C0, 1U, 1U, 27U, 35U, false}
};

const whipple_sprung_f64_t whipple_sprung_f64_sets[WHIPPLE_SPRUNG_SETS] = {
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
        .k = 0.5,
        .d = 0.25
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
        .IFyy = 0.28,
        .k = 0.5,
        .d = 0.25
    }
};

whipple_sprung_validity_t whipple_sprung_f64_validate(const whipple_sprung_f64_t *p)
{
    whipple_sprung_validity_t validity = WHIPPLE_SPRUNG_VALID;
    if (!((p->w > 0.0) && (p->w <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_w;
    } else if (!((p->c >= -DBL_MAX) && (p->c <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_c;
    } else if (!((p->lam > (-1.5707963267948966)) && (p->lam < 1.5707963267948966))) {
        validity = WHIPPLE_SPRUNG_INVALID_lam;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_g;
    } else if (!((p->rR > 0.0) && (p->rR <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_rR;
    } else if (!((p->mR >= 0.0) && (p->mR <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_mR;
    } else if (!((p->IRxx >= 0.0) && (p->IRxx <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0) && (p->IRyy <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IRyy;
    } else if (!((p->xB >= -DBL_MAX) && (p->xB <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_xB;
    } else if (!((p->zB >= -DBL_MAX) && (p->zB <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_zB;
    } else if (!((p->mB >= 0.0) && (p->mB <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_mB;
    } else if (!((p->IBxx >= 0.0) && (p->IBxx <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0) && (p->IByy <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0) && (p->IBzz <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IBzz;
    } else if (!((p->IBxz >= -DBL_MAX) && (p->IBxz <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IBxz;
    } else if (!((p->xH >= -DBL_MAX) && (p->xH <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_xH;
    } else if (!((p->zH >= -DBL_MAX) && (p->zH <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_zH;
    } else if (!((p->mH >= 0.0) && (p->mH <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_mH;
    } else if (!((p->IHxx >= 0.0) && (p->IHxx <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0) && (p->IHyy <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0) && (p->IHzz <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IHzz;
    } else if (!((p->IHxz >= -DBL_MAX) && (p->IHxz <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IHxz;
    } else if (!((p->rF > 0.0) && (p->rF <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_rF;
    } else if (!((p->mF >= 0.0) && (p->mF <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_mF;
    } else if (!((p->IFxx >= 0.0) && (p->IFxx <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0) && (p->IFyy <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IFyy;
    } else if (!((p->k >= 0.0) && (p->k <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_k;
    } else if (!((p->d >= 0.0) && (p->d <= DBL_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_d;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void whipple_sprung_f64_matrices(const whipple_sprung_f64_t *p, whipple_sprung_f64_matrices_t *matrices)
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
    const double t36 = p->xH - t35;
    const double t37 = p->mH * t36;
    const double Jxz_delta = p->IHxz - (t10 * p->c) - (p->zH * t37);
    const double hx_delta = (Jxx_delta * sin_lam) + (Jxz_delta * cos_lam);
    const double yaw_per_v_delta = cos_lam / p->w;
    const double yaw_by_delta = p->c * yaw_per_v_delta;
    const double Sz_delta = t6 - t10;
    const double Jxz_all = Jxz_delta + p->IBxz - (t21 * p->xB) - (t35 * Sz_delta);
    const double M_12 = hx_delta + (yaw_by_delta * Jxz_all);
    const double t58 = p->mF * p->c;
    const double t61 = p->IFxx + p->IHzz;
    const double hz_delta = (sin_lam * Jxz_delta) + (cos_lam * ((t36 * t37) + (p->c * t58) + t61));
    const double Sx_delta = t37 - t58;
    const double py_delta = (cos_lam * Sx_delta) - (sin_lam * Sz_delta);
    const double M_yaw_delta = hz_delta + (t35 * py_delta);
    const double t73 = p->mB * p->xB;
    const double t75 = p->mH * p->xH;
    const double t77 = p->mF * p->w;
    const double t84 = yaw_by_delta * (p->IRxx + t61 + p->IBzz + (p->xB * t73) + (p->xH * t75) +
        (p->w * t77));
    const double P_delta_yaw = M_yaw_delta + t84;
    const double M_22 = (yaw_by_delta * (M_yaw_delta + P_delta_yaw)) + (sin_lam * hx_delta) +
        (cos_lam * hz_delta);
    const double h_spin_F = p->IFyy / p->rF;
    const double h_wheels_all = h_spin_F + (p->IRyy / p->rR);
    const double Sz_all = t21 + Sz_delta - t17;
    const double t101 = h_wheels_all - Sz_all;
    const double t104 = cos_lam * h_spin_F;
    const double C1_12 = (yaw_by_delta * t101) + (yaw_per_v_delta * Jxz_all) + t104;
    const double Sx_all = t73 + t75 + t77;
    const double P_delta_lateral = py_delta + (yaw_by_delta * Sx_all);
    const double C1_22 = (yaw_by_delta * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
    const double K2_12 = yaw_per_v_delta * t101;
    const double K2_22 = yaw_per_v_delta * (P_delta_lateral + (sin_lam * h_spin_F));
    const double C1_21 = -(t104 + (yaw_by_delta * h_wheels_all));
    const double K0_12 = -P_delta_lateral;
    const double K0_22 = -(sin_lam * P_delta_lateral);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = 0.0;
    matrices->c0[1][0] = 0.0;
    matrices->c0[1][1] = p->d;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->kc[0][0] = 0.0;
    matrices->kc[0][1] = 0.0;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = p->k;
    matrices->k0[0][0] = Sz_all;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k2[0][0] = 0.0;
    matrices->k2[0][1] = K2_12;
    matrices->k2[1][0] = 0.0;
    matrices->k2[1][1] = K2_22;
}

carvallo_system_error_t whipple_sprung_f64_at_speed(const whipple_sprung_f64_matrices_t *matrices,
    double speed, double gravity, whipple_sprung_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed) && carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < WHIPPLE_SPRUNG_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_SPRUNG_N; column++) {
            const double damping = matrices->c0[row][column] + (matrices->c1[row][column] * speed);
            const double stiffness = matrices->kc[row][column] + (matrices->k0[row][column] *
                gravity) + (matrices->k2[row][column] * speed * speed);
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->c0[row][column]) &&
                carvallo_is_finite_f64(matrices->c1[row][column]) &&
                carvallo_is_finite_f64(matrices->kc[row][column]) &&
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

carvallo_system_error_t whipple_sprung_f64_state_space(const whipple_sprung_f64_system_t *system,
    whipple_sprung_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[WHIPPLE_SPRUNG_N * WHIPPLE_SPRUNG_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * WHIPPLE_SPRUNG_N * WHIPPLE_SPRUNG_N];
    for (size_t row = 0U; row < WHIPPLE_SPRUNG_N; row++) {
        double *const solved = &x[3U * WHIPPLE_SPRUNG_N * row];
        for (size_t column = 0U; column < WHIPPLE_SPRUNG_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * WHIPPLE_SPRUNG_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHIPPLE_SPRUNG_N + column] = -system->c[row][column];
            solved[(2U * WHIPPLE_SPRUNG_N) + column] = 0.0;
        }
        solved[(2U * WHIPPLE_SPRUNG_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[WHIPPLE_SPRUNG_N * WHIPPLE_SPRUNG_N];
        error = carvallo_solve_f64(WHIPPLE_SPRUNG_N, m, terms, 3U * WHIPPLE_SPRUNG_N, x);
    }
    for (size_t row = 0U; row < (2U * WHIPPLE_SPRUNG_N); row++) {
        for (size_t column = 0U; column < (2U * WHIPPLE_SPRUNG_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < WHIPPLE_SPRUNG_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHIPPLE_SPRUNG_N; row++) {
            const size_t target = WHIPPLE_SPRUNG_N + row;
            for (size_t column = 0U; column < (2U * WHIPPLE_SPRUNG_N); column++) {
                space->a[target][column] = x[(3U * WHIPPLE_SPRUNG_N * row) + column];
            }
            for (size_t column = 0U; column < WHIPPLE_SPRUNG_N; column++) {
                space->b[target][column] = x[(3U * WHIPPLE_SPRUNG_N * row) + (2U *
                    WHIPPLE_SPRUNG_N) + column];
            }
            space->a[row][WHIPPLE_SPRUNG_N + row] = 1.0;
        }
    }
    return error;
}

double whipple_sprung_f64_rate_at(const whipple_sprung_f64_rate_t *rate, double v,
    const double q[WHIPPLE_SPRUNG_N], const double q_dot[WHIPPLE_SPRUNG_N], double psi)
{
    double by_coordinates = 0.0;
    double by_rates = 0.0;
    for (size_t i = 0U; i < WHIPPLE_SPRUNG_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void whipple_sprung_f64_kinematics(const whipple_sprung_f64_t *p, whipple_sprung_f64_kinematics_t *kinematics)
{
    const double yaw_per_v_delta = carvallo_cos_f64(p->lam) / p->w;
    const double yaw_by_delta = p->c * yaw_per_v_delta;
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
    kinematics->yaw.rates[1] = yaw_by_delta;
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

void whipple_sprung_f64_derivatives(const whipple_sprung_f64_t *p,
    whipple_sprung_f64_matrices_t *matrices, whipple_sprung_f64_derivatives_t *derivatives)
{
    const double M_11_mB = p->zB * p->zB;
    const double hx_delta_rF = p->mB * M_11_mB;
    const double t7 = p->zH * p->mH;
    const double t13 = p->rF * p->mF;
    const double Jxx_delta = (p->zH * t7) + p->IHxx + p->IFxx + (p->rF * t13);
    const double M_11_mR = p->rR * p->rR;
    const double M_11 = p->IRxx + hx_delta_rF + Jxx_delta + p->IBxx + (p->mR * M_11_mR);
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t31 = 1.0 / p->w;
    const double t32 = p->c * t31;
    const double yaw_by_delta = cos_lam * t32;
    const double t34 = t13 * p->c;
    const double t37 = p->c + p->w;
    const double t38 = p->xH - t37;
    const double t39 = p->mH * t38;
    const double t42 = t34 + (p->zH * t39) - p->IHxz;
    const double t44 = p->mB * p->xB;
    const double Sz_delta = t7 - t13;
    const double t51 = t42 + (p->zB * t44) + (t37 * Sz_delta) - p->IBxz;
    const double t52 = yaw_by_delta * t51;
    const double t55 = cos_lam * t42;
    const double hx_delta = (Jxx_delta * sin_lam) - t55;
    const double M_12 = hx_delta - t52;
    const double t58 = t42 * sin_lam;
    const double t61 = p->IFxx + p->IHzz;
    const double t62 = p->mF * p->c;
    const double t65 = (t38 * t39) + t61 + (p->c * t62);
    const double t67 = t58 - (cos_lam * t65);
    const double t68 = p->mF * cos_lam;
    const double t69 = p->c * t68;
    const double t71 = t69 - (t13 * sin_lam);
    const double t73 = p->zH * sin_lam;
    const double t74 = (cos_lam * t38) - t73;
    const double t75 = p->mH * t74;
    const double t76 = t75 - t71;
    const double t78 = t67 - (t37 * t76);
    const double yaw_per_v_delta = cos_lam * t31;
    const double t81 = p->mH * p->xH;
    const double t83 = p->mF * p->w;
    const double t91 = yaw_per_v_delta * (p->IRxx + t61 + (p->xB * t44) + (p->xH * t81) + (p->w *
        t83) + p->IBzz);
    const double t92 = p->c * t91;
    const double t93 = t78 - t92;
    const double M_22 = (sin_lam * hx_delta) - (cos_lam * (t67 + (t32 * (t78 + t93))));
    const double t103 = 1.0 / p->rF;
    const double h_spin_F = p->IFyy * t103;
    const double t105 = cos_lam * h_spin_F;
    const double t107 = 1.0 / p->rR;
    const double t108 = p->IRyy * t107;
    const double h_wheels_all = h_spin_F + t108;
    const double t110 = p->mR * p->rR;
    const double t111 = p->mB * p->zB;
    const double K0_11 = Sz_delta + t111 - t110;
    const double t114 = h_wheels_all - K0_11;
    const double t116 = t51 - (p->c * t114);
    const double t117 = yaw_per_v_delta * t116;
    const double C1_12 = t105 - t117;
    const double t120 = h_spin_F + (t32 * h_wheels_all);
    const double Sx_all = t44 + t81 + t83;
    const double t124 = yaw_by_delta * Sx_all;
    const double t125 = t76 + t124;
    const double t127 = t93 - (p->c * t125);
    const double K2_12 = yaw_per_v_delta * t114;
    const double t132 = sin_lam * h_spin_F;
    const double t133 = t125 + t132;
    const double K2_22 = yaw_per_v_delta * t133;
    const double C1_12_h_spin_F = cos_lam + yaw_by_delta;
    const double P_delta_lateral_xH = p->mH * C1_12_h_spin_F;
    const double t138 = p->zH * P_delta_lateral_xH;
    const double t139 = (yaw_by_delta * Sz_delta) - t138;
    const double hx_delta_mH = t31 * t52;
    const double M_12_w = hx_delta_mH - t139;
    const double t142 = t75 + t75;
    const double t143 = cos_lam * t142;
    const double t144 = yaw_by_delta + yaw_by_delta;
    const double t145 = t31 * t93;
    const double P_delta_lateral_yaw_per_v_delta = p->w * yaw_per_v_delta;
    const double t147 = t62 * P_delta_lateral_yaw_per_v_delta;
    const double t148 = p->mH * cos_lam;
    const double t149 = p->xH * t148;
    const double t151 = t147 - t71 - t149;
    const double hz_delta_mF = t145 + t151;
    const double M_22_w = (t144 * hz_delta_mF) - t143;
    const double t155 = t13 * cos_lam;
    const double C1_12_w = t31 * (t117 + t155);
    const double t158 = yaw_per_v_delta * h_wheels_all;
    const double C1_21_w = t32 * t158;
    const double K0_12_w = t148 - (t31 * (t69 - t124));
    const double t165 = t31 * (t92 - t127);
    const double C1_22_w = yaw_per_v_delta * (t147 + t151 - (p->c * K0_12_w) - t165);
    const double K0_22_w = sin_lam * K0_12_w;
    const double t171 = t31 * K2_12;
    const double t172 = t31 * t133;
    const double t174 = yaw_per_v_delta * (K0_12_w + t172);
    const double t178 = t139 + t155 + (yaw_per_v_delta * (t34 + t51));
    const double t179 = t145 + t145;
    const double t183 = t37 * t68;
    const double t185 = t69 - t149 - t183;
    const double M_22_c = (t144 * t185) - (cos_lam * (t76 + t76 + t179));
    const double K0_12_c = t68 + t148 - (yaw_per_v_delta * Sx_all);
    const double C1_22_c = yaw_per_v_delta * (t91 + t125 + t185 - (p->c * K0_12_c));
    const double K0_22_c = sin_lam * K0_12_c;
    const double t197 = yaw_per_v_delta * K0_12_c;
    const double hx_delta_lam = t58 + (Jxx_delta * cos_lam);
    const double t200 = t31 * sin_lam;
    const double t201 = p->c * t200;
    const double P_delta_yaw_mH = t51 * t201;
    const double M_12_lam = hx_delta_lam + P_delta_yaw_mH;
    const double t205 = t55 + (sin_lam * t65);
    const double t209 = (cos_lam * Sz_delta) - (sin_lam * (t62 - t39));
    const double t211 = t205 + (t37 * t209);
    const double M_22_lam = (sin_lam * (t67 + hx_delta_lam + (p->c * t179))) + (cos_lam *
        (hx_delta - t205)) - (t144 * t211);
    const double C1_12_lam = (t116 * t200) - t132;
    const double C1_21_lam = sin_lam * t120;
    const double K0_12_lam = t209 + (Sx_all * t201);
    const double t230 = (yaw_per_v_delta * (t211 + (p->c * K0_12_lam))) + (sin_lam * t165);
    const double K0_22_lam = (sin_lam * K0_12_lam) - (cos_lam * t125);
    const double t234 = t114 * t200;
    const double K2_22_lam = (yaw_per_v_delta * (t105 - K0_12_lam)) - (sin_lam * t172);
    const double M_11_rR = t110 + t110;
    const double t241 = p->mR - (t107 * t108);
    const double C1_12_rR = yaw_by_delta * t241;
    const double K2_12_IRyy = yaw_per_v_delta * t107;
    const double C1_12_IRyy = p->c * K2_12_IRyy;
    const double C1_21_rR = t108 * C1_12_IRyy;
    const double K2_12_rR = yaw_per_v_delta * t241;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double C1_12_mR = p->c * K2_12_mR;
    const double C1_22_IRxx = yaw_by_delta * yaw_per_v_delta;
    const double M_22_IRxx = p->c * C1_22_IRxx;
    const double t252 = yaw_by_delta * t111;
    const double P_delta_lateral_mB = yaw_by_delta * p->xB;
    const double t254 = p->mB * P_delta_lateral_mB;
    const double M_22_xB = t144 * t254;
    const double t256 = p->zB * yaw_per_v_delta;
    const double t257 = p->mB * t256;
    const double K2_22_xB = p->mB * C1_22_IRxx;
    const double P_delta_yaw_mB = p->c + p->xB;
    const double C1_22_xB = K2_22_xB * (p->xB + P_delta_yaw_mB);
    const double P_delta_lateral_xB = p->mB * yaw_by_delta;
    const double t263 = sin_lam * P_delta_lateral_xB;
    const double M_11_zB = t111 + t111;
    const double t265 = p->mB * yaw_per_v_delta;
    const double t266 = P_delta_yaw_mB * t265;
    const double t267 = p->zB * P_delta_lateral_mB;
    const double M_22_mB = P_delta_lateral_mB * P_delta_lateral_mB;
    const double t269 = t256 * P_delta_yaw_mB;
    const double K2_22_mB = yaw_per_v_delta * P_delta_lateral_mB;
    const double C1_22_mB = P_delta_yaw_mB * K2_22_mB;
    const double t272 = sin_lam * P_delta_lateral_mB;
    const double t273 = t75 + t149;
    const double t274 = t81 * t144;
    const double t275 = t273 + t274;
    const double M_22_xH = t143 + (yaw_by_delta * (t273 + t275));
    const double t279 = t7 * yaw_per_v_delta;
    const double C1_22_xH = yaw_per_v_delta * (t275 + (p->c * P_delta_lateral_xH));
    const double K0_12_zH = p->mH * sin_lam;
    const double t284 = C1_12_h_spin_F * K0_12_zH;
    const double C1_22_IHzz = yaw_per_v_delta * C1_12_h_spin_F;
    const double K2_22_xH = p->mH * C1_22_IHzz;
    const double Jxx_delta_zH = t7 + t7;
    const double t289 = t74 + (yaw_by_delta * p->xH);
    const double M_12_zH = p->mH * (t73 - t289);
    const double t293 = sin_lam * (t142 + t274);
    const double t294 = p->c + p->xH;
    const double t295 = t31 * t148;
    const double t296 = t294 * t295;
    const double t297 = sin_lam * t295;
    const double t298 = t294 * t297;
    const double K0_22_zH = sin_lam * K0_12_zH;
    const double Jxx_delta_mH = p->zH * p->zH;
    const double t301 = p->zH * t289;
    const double M_22_mH = t289 * t289;
    const double t303 = p->zH * yaw_per_v_delta;
    const double t304 = t294 * t303;
    const double K2_22_mH = yaw_per_v_delta * t289;
    const double C1_22_mH = t294 * K2_22_mH;
    const double t307 = sin_lam * t289;
    const double M_22_IHxx = sin_lam * sin_lam;
    const double t309 = yaw_by_delta + C1_12_h_spin_F;
    const double M_22_yaw_per_v_delta = cos_lam * t309;
    const double M_22_IHzz = M_22_IRxx + M_22_yaw_per_v_delta;
    const double M_22_IHxz = sin_lam * (cos_lam + t309);
    const double K2_22_h_spin_F = sin_lam * yaw_per_v_delta;
    const double t315 = p->mF + p->mF;
    const double M_11_rF = p->rF * t315;
    const double t317 = p->rF * sin_lam;
    const double t319 = p->c * (cos_lam - P_delta_lateral_yaw_per_v_delta);
    const double P_delta_lateral_mF = t317 - t319;
    const double M_12_rF = p->mF * (t317 + P_delta_lateral_mF);
    const double t323 = sin_lam * P_delta_lateral_mF;
    const double M_22_rF = t315 * t323;
    const double C1_12_IFyy = t103 * C1_12_h_spin_F;
    const double C1_21_rF = h_spin_F * C1_12_IFyy;
    const double t327 = t31 * t183;
    const double C1_12_rF = t327 - C1_21_rF;
    const double C1_22_rF = sin_lam * t327;
    const double P_delta_lateral_rF = p->mF * sin_lam;
    const double t331 = p->mF * M_22_IHxx;
    const double t333 = (t103 * t105) - t68;
    const double t334 = t31 * t333;
    const double t335 = t200 * t333;
    const double M_11_mF = p->rF * p->rF;
    const double M_12_mF = p->rF * P_delta_lateral_mF;
    const double M_22_mF = P_delta_lateral_mF * P_delta_lateral_mF;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double C1_12_mF = t37 * K2_12_mF;
    const double K2_22_mF = yaw_per_v_delta * P_delta_lateral_mF;
    const double C1_22_mF = t37 * K2_22_mF;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double K2_12_IFyy = yaw_per_v_delta * t103;
    const double K2_22_IFyy = t103 * K2_22_h_spin_F;
    const double C1_21 = -(cos_lam * t120);
    const double C1_22 = -(yaw_per_v_delta * t127);
    const double K0_12 = -t125;
    const double K0_22 = -(sin_lam * t125);
    const double K0_12_mF = t319 - t317;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = 0.0;
    matrices->c0[1][0] = 0.0;
    matrices->c0[1][1] = p->d;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->kc[0][0] = 0.0;
    matrices->kc[0][1] = 0.0;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = p->k;
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
    derivatives->values[7] = t171;
    derivatives->values[8] = t174;
    derivatives->values[9] = t178;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t158;
    derivatives->values[13] = C1_22_c;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t197;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = C1_12_lam;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = t230;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = t234;
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
    derivatives->values[40] = t252;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t257;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = P_delta_lateral_xB;
    derivatives->values[45] = t263;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t254;
    derivatives->values[49] = t266;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t265;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t267;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t269;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = P_delta_lateral_mB;
    derivatives->values[59] = t272;
    derivatives->values[60] = t256;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = yaw_by_delta;
    derivatives->values[63] = yaw_per_v_delta;
    derivatives->values[64] = t138;
    derivatives->values[65] = M_22_xH;
    derivatives->values[66] = t279;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = P_delta_lateral_xH;
    derivatives->values[69] = t284;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = Jxx_delta_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = t293;
    derivatives->values[74] = t296;
    derivatives->values[75] = t298;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t295;
    derivatives->values[80] = t297;
    derivatives->values[81] = Jxx_delta_mH;
    derivatives->values[82] = t301;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t304;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = t289;
    derivatives->values[88] = t307;
    derivatives->values[89] = t303;
    derivatives->values[90] = K2_22_mH;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_IHxx;
    derivatives->values[93] = M_22_IHzz;
    derivatives->values[94] = C1_22_IHzz;
    derivatives->values[95] = C1_12_h_spin_F;
    derivatives->values[96] = M_22_IHxz;
    derivatives->values[97] = K2_22_h_spin_F;
    derivatives->values[98] = M_11_rF;
    derivatives->values[99] = M_12_rF;
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = C1_22_rF;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = P_delta_lateral_rF;
    derivatives->values[106] = t331;
    derivatives->values[107] = t334;
    derivatives->values[108] = t335;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = M_12_mF;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = C1_22_mF;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = t323;
    derivatives->values[117] = K2_12_mF;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = K2_12_IFyy;
    derivatives->values[122] = K2_22_IFyy;
}

void whipple_sprung_f64_with_respect_to(const whipple_sprung_f64_derivatives_t *derivatives,
    size_t parameter, whipple_sprung_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHIPPLE_SPRUNG_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_SPRUNG_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c0[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->kc[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
            matrices->k2[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < WHIPPLE_SPRUNG_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &whipple_sprung_partials[position];
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
            case CARVALLO_MATRIX_KC:
                matrices->kc[partial->row][partial->column] = signed_value;
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

const whipple_sprung_f32_t whipple_sprung_f32_sets[WHIPPLE_SPRUNG_SETS] = {
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
        .k = 0.5F,
        .d = 0.25F
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
        .IFyy = 0.28F,
        .k = 0.5F,
        .d = 0.25F
    }
};

whipple_sprung_validity_t whipple_sprung_f32_validate(const whipple_sprung_f32_t *p)
{
    whipple_sprung_validity_t validity = WHIPPLE_SPRUNG_VALID;
    if (!((p->w > 0.0F) && (p->w <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_w;
    } else if (!((p->c >= -FLT_MAX) && (p->c <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_c;
    } else if (!((p->lam > (-1.5707964F)) && (p->lam < 1.5707964F))) {
        validity = WHIPPLE_SPRUNG_INVALID_lam;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_g;
    } else if (!((p->rR > 0.0F) && (p->rR <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_rR;
    } else if (!((p->mR >= 0.0F) && (p->mR <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_mR;
    } else if (!((p->IRxx >= 0.0F) && (p->IRxx <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0F) && (p->IRyy <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IRyy;
    } else if (!((p->xB >= -FLT_MAX) && (p->xB <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_xB;
    } else if (!((p->zB >= -FLT_MAX) && (p->zB <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_zB;
    } else if (!((p->mB >= 0.0F) && (p->mB <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_mB;
    } else if (!((p->IBxx >= 0.0F) && (p->IBxx <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0F) && (p->IByy <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0F) && (p->IBzz <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IBzz;
    } else if (!((p->IBxz >= -FLT_MAX) && (p->IBxz <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IBxz;
    } else if (!((p->xH >= -FLT_MAX) && (p->xH <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_xH;
    } else if (!((p->zH >= -FLT_MAX) && (p->zH <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_zH;
    } else if (!((p->mH >= 0.0F) && (p->mH <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_mH;
    } else if (!((p->IHxx >= 0.0F) && (p->IHxx <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0F) && (p->IHyy <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0F) && (p->IHzz <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IHzz;
    } else if (!((p->IHxz >= -FLT_MAX) && (p->IHxz <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IHxz;
    } else if (!((p->rF > 0.0F) && (p->rF <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_rF;
    } else if (!((p->mF >= 0.0F) && (p->mF <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_mF;
    } else if (!((p->IFxx >= 0.0F) && (p->IFxx <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0F) && (p->IFyy <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_IFyy;
    } else if (!((p->k >= 0.0F) && (p->k <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_k;
    } else if (!((p->d >= 0.0F) && (p->d <= FLT_MAX))) {
        validity = WHIPPLE_SPRUNG_INVALID_d;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void whipple_sprung_f32_matrices(const whipple_sprung_f32_t *p, whipple_sprung_f32_matrices_t *matrices)
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
    const float t36 = p->xH - t35;
    const float t37 = p->mH * t36;
    const float Jxz_delta = p->IHxz - (t10 * p->c) - (p->zH * t37);
    const float hx_delta = (Jxx_delta * sin_lam) + (Jxz_delta * cos_lam);
    const float yaw_per_v_delta = cos_lam / p->w;
    const float yaw_by_delta = p->c * yaw_per_v_delta;
    const float Sz_delta = t6 - t10;
    const float Jxz_all = Jxz_delta + p->IBxz - (t21 * p->xB) - (t35 * Sz_delta);
    const float M_12 = hx_delta + (yaw_by_delta * Jxz_all);
    const float t58 = p->mF * p->c;
    const float t61 = p->IFxx + p->IHzz;
    const float hz_delta = (sin_lam * Jxz_delta) + (cos_lam * ((t36 * t37) + (p->c * t58) + t61));
    const float Sx_delta = t37 - t58;
    const float py_delta = (cos_lam * Sx_delta) - (sin_lam * Sz_delta);
    const float M_yaw_delta = hz_delta + (t35 * py_delta);
    const float t73 = p->mB * p->xB;
    const float t75 = p->mH * p->xH;
    const float t77 = p->mF * p->w;
    const float t84 = yaw_by_delta * (p->IRxx + t61 + p->IBzz + (p->xB * t73) + (p->xH * t75) +
        (p->w * t77));
    const float P_delta_yaw = M_yaw_delta + t84;
    const float M_22 = (yaw_by_delta * (M_yaw_delta + P_delta_yaw)) + (sin_lam * hx_delta) +
        (cos_lam * hz_delta);
    const float h_spin_F = p->IFyy / p->rF;
    const float h_wheels_all = h_spin_F + (p->IRyy / p->rR);
    const float Sz_all = t21 + Sz_delta - t17;
    const float t101 = h_wheels_all - Sz_all;
    const float t104 = cos_lam * h_spin_F;
    const float C1_12 = (yaw_by_delta * t101) + (yaw_per_v_delta * Jxz_all) + t104;
    const float Sx_all = t73 + t75 + t77;
    const float P_delta_lateral = py_delta + (yaw_by_delta * Sx_all);
    const float C1_22 = (yaw_by_delta * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
    const float K2_12 = yaw_per_v_delta * t101;
    const float K2_22 = yaw_per_v_delta * (P_delta_lateral + (sin_lam * h_spin_F));
    const float C1_21 = -(t104 + (yaw_by_delta * h_wheels_all));
    const float K0_12 = -P_delta_lateral;
    const float K0_22 = -(sin_lam * P_delta_lateral);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[1][0] = 0.0F;
    matrices->c0[1][1] = p->d;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->kc[0][0] = 0.0F;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = p->k;
    matrices->k0[0][0] = Sz_all;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k2[0][0] = 0.0F;
    matrices->k2[0][1] = K2_12;
    matrices->k2[1][0] = 0.0F;
    matrices->k2[1][1] = K2_22;
}

carvallo_system_error_t whipple_sprung_f32_at_speed(const whipple_sprung_f32_matrices_t *matrices,
    float speed, float gravity, whipple_sprung_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed) && carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < WHIPPLE_SPRUNG_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_SPRUNG_N; column++) {
            const float damping = matrices->c0[row][column] + (matrices->c1[row][column] * speed);
            const float stiffness = matrices->kc[row][column] + (matrices->k0[row][column] *
                gravity) + (matrices->k2[row][column] * speed * speed);
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->c0[row][column]) &&
                carvallo_is_finite_f32(matrices->c1[row][column]) &&
                carvallo_is_finite_f32(matrices->kc[row][column]) &&
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

carvallo_system_error_t whipple_sprung_f32_state_space(const whipple_sprung_f32_system_t *system,
    whipple_sprung_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[WHIPPLE_SPRUNG_N * WHIPPLE_SPRUNG_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * WHIPPLE_SPRUNG_N * WHIPPLE_SPRUNG_N];
    for (size_t row = 0U; row < WHIPPLE_SPRUNG_N; row++) {
        float *const solved = &x[3U * WHIPPLE_SPRUNG_N * row];
        for (size_t column = 0U; column < WHIPPLE_SPRUNG_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * WHIPPLE_SPRUNG_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHIPPLE_SPRUNG_N + column] = -system->c[row][column];
            solved[(2U * WHIPPLE_SPRUNG_N) + column] = 0.0F;
        }
        solved[(2U * WHIPPLE_SPRUNG_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[WHIPPLE_SPRUNG_N * WHIPPLE_SPRUNG_N];
        error = carvallo_solve_f32(WHIPPLE_SPRUNG_N, m, terms, 3U * WHIPPLE_SPRUNG_N, x);
    }
    for (size_t row = 0U; row < (2U * WHIPPLE_SPRUNG_N); row++) {
        for (size_t column = 0U; column < (2U * WHIPPLE_SPRUNG_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < WHIPPLE_SPRUNG_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHIPPLE_SPRUNG_N; row++) {
            const size_t target = WHIPPLE_SPRUNG_N + row;
            for (size_t column = 0U; column < (2U * WHIPPLE_SPRUNG_N); column++) {
                space->a[target][column] = x[(3U * WHIPPLE_SPRUNG_N * row) + column];
            }
            for (size_t column = 0U; column < WHIPPLE_SPRUNG_N; column++) {
                space->b[target][column] = x[(3U * WHIPPLE_SPRUNG_N * row) + (2U *
                    WHIPPLE_SPRUNG_N) + column];
            }
            space->a[row][WHIPPLE_SPRUNG_N + row] = 1.0F;
        }
    }
    return error;
}

float whipple_sprung_f32_rate_at(const whipple_sprung_f32_rate_t *rate, float v,
    const float q[WHIPPLE_SPRUNG_N], const float q_dot[WHIPPLE_SPRUNG_N], float psi)
{
    float by_coordinates = 0.0F;
    float by_rates = 0.0F;
    for (size_t i = 0U; i < WHIPPLE_SPRUNG_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void whipple_sprung_f32_kinematics(const whipple_sprung_f32_t *p, whipple_sprung_f32_kinematics_t *kinematics)
{
    const float yaw_per_v_delta = carvallo_cos_f32(p->lam) / p->w;
    const float yaw_by_delta = p->c * yaw_per_v_delta;
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
    kinematics->yaw.rates[1] = yaw_by_delta;
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

void whipple_sprung_f32_derivatives(const whipple_sprung_f32_t *p,
    whipple_sprung_f32_matrices_t *matrices, whipple_sprung_f32_derivatives_t *derivatives)
{
    const float M_11_mB = p->zB * p->zB;
    const float hx_delta_rF = p->mB * M_11_mB;
    const float t7 = p->zH * p->mH;
    const float t13 = p->rF * p->mF;
    const float Jxx_delta = (p->zH * t7) + p->IHxx + p->IFxx + (p->rF * t13);
    const float M_11_mR = p->rR * p->rR;
    const float M_11 = p->IRxx + hx_delta_rF + Jxx_delta + p->IBxx + (p->mR * M_11_mR);
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t31 = 1.0F / p->w;
    const float t32 = p->c * t31;
    const float yaw_by_delta = cos_lam * t32;
    const float t34 = t13 * p->c;
    const float t37 = p->c + p->w;
    const float t38 = p->xH - t37;
    const float t39 = p->mH * t38;
    const float t42 = t34 + (p->zH * t39) - p->IHxz;
    const float t44 = p->mB * p->xB;
    const float Sz_delta = t7 - t13;
    const float t51 = t42 + (p->zB * t44) + (t37 * Sz_delta) - p->IBxz;
    const float t52 = yaw_by_delta * t51;
    const float t55 = cos_lam * t42;
    const float hx_delta = (Jxx_delta * sin_lam) - t55;
    const float M_12 = hx_delta - t52;
    const float t58 = t42 * sin_lam;
    const float t61 = p->IFxx + p->IHzz;
    const float t62 = p->mF * p->c;
    const float t65 = (t38 * t39) + t61 + (p->c * t62);
    const float t67 = t58 - (cos_lam * t65);
    const float t68 = p->mF * cos_lam;
    const float t69 = p->c * t68;
    const float t71 = t69 - (t13 * sin_lam);
    const float t73 = p->zH * sin_lam;
    const float t74 = (cos_lam * t38) - t73;
    const float t75 = p->mH * t74;
    const float t76 = t75 - t71;
    const float t78 = t67 - (t37 * t76);
    const float yaw_per_v_delta = cos_lam * t31;
    const float t81 = p->mH * p->xH;
    const float t83 = p->mF * p->w;
    const float t91 = yaw_per_v_delta * (p->IRxx + t61 + (p->xB * t44) + (p->xH * t81) + (p->w *
        t83) + p->IBzz);
    const float t92 = p->c * t91;
    const float t93 = t78 - t92;
    const float M_22 = (sin_lam * hx_delta) - (cos_lam * (t67 + (t32 * (t78 + t93))));
    const float t103 = 1.0F / p->rF;
    const float h_spin_F = p->IFyy * t103;
    const float t105 = cos_lam * h_spin_F;
    const float t107 = 1.0F / p->rR;
    const float t108 = p->IRyy * t107;
    const float h_wheels_all = h_spin_F + t108;
    const float t110 = p->mR * p->rR;
    const float t111 = p->mB * p->zB;
    const float K0_11 = Sz_delta + t111 - t110;
    const float t114 = h_wheels_all - K0_11;
    const float t116 = t51 - (p->c * t114);
    const float t117 = yaw_per_v_delta * t116;
    const float C1_12 = t105 - t117;
    const float t120 = h_spin_F + (t32 * h_wheels_all);
    const float Sx_all = t44 + t81 + t83;
    const float t124 = yaw_by_delta * Sx_all;
    const float t125 = t76 + t124;
    const float t127 = t93 - (p->c * t125);
    const float K2_12 = yaw_per_v_delta * t114;
    const float t132 = sin_lam * h_spin_F;
    const float t133 = t125 + t132;
    const float K2_22 = yaw_per_v_delta * t133;
    const float C1_12_h_spin_F = cos_lam + yaw_by_delta;
    const float P_delta_lateral_xH = p->mH * C1_12_h_spin_F;
    const float t138 = p->zH * P_delta_lateral_xH;
    const float t139 = (yaw_by_delta * Sz_delta) - t138;
    const float hx_delta_mH = t31 * t52;
    const float M_12_w = hx_delta_mH - t139;
    const float t142 = t75 + t75;
    const float t143 = cos_lam * t142;
    const float t144 = yaw_by_delta + yaw_by_delta;
    const float t145 = t31 * t93;
    const float P_delta_lateral_yaw_per_v_delta = p->w * yaw_per_v_delta;
    const float t147 = t62 * P_delta_lateral_yaw_per_v_delta;
    const float t148 = p->mH * cos_lam;
    const float t149 = p->xH * t148;
    const float t151 = t147 - t71 - t149;
    const float hz_delta_mF = t145 + t151;
    const float M_22_w = (t144 * hz_delta_mF) - t143;
    const float t155 = t13 * cos_lam;
    const float C1_12_w = t31 * (t117 + t155);
    const float t158 = yaw_per_v_delta * h_wheels_all;
    const float C1_21_w = t32 * t158;
    const float K0_12_w = t148 - (t31 * (t69 - t124));
    const float t165 = t31 * (t92 - t127);
    const float C1_22_w = yaw_per_v_delta * (t147 + t151 - (p->c * K0_12_w) - t165);
    const float K0_22_w = sin_lam * K0_12_w;
    const float t171 = t31 * K2_12;
    const float t172 = t31 * t133;
    const float t174 = yaw_per_v_delta * (K0_12_w + t172);
    const float t178 = t139 + t155 + (yaw_per_v_delta * (t34 + t51));
    const float t179 = t145 + t145;
    const float t183 = t37 * t68;
    const float t185 = t69 - t149 - t183;
    const float M_22_c = (t144 * t185) - (cos_lam * (t76 + t76 + t179));
    const float K0_12_c = t68 + t148 - (yaw_per_v_delta * Sx_all);
    const float C1_22_c = yaw_per_v_delta * (t91 + t125 + t185 - (p->c * K0_12_c));
    const float K0_22_c = sin_lam * K0_12_c;
    const float t197 = yaw_per_v_delta * K0_12_c;
    const float hx_delta_lam = t58 + (Jxx_delta * cos_lam);
    const float t200 = t31 * sin_lam;
    const float t201 = p->c * t200;
    const float P_delta_yaw_mH = t51 * t201;
    const float M_12_lam = hx_delta_lam + P_delta_yaw_mH;
    const float t205 = t55 + (sin_lam * t65);
    const float t209 = (cos_lam * Sz_delta) - (sin_lam * (t62 - t39));
    const float t211 = t205 + (t37 * t209);
    const float M_22_lam = (sin_lam * (t67 + hx_delta_lam + (p->c * t179))) + (cos_lam * (hx_delta -
        t205)) - (t144 * t211);
    const float C1_12_lam = (t116 * t200) - t132;
    const float C1_21_lam = sin_lam * t120;
    const float K0_12_lam = t209 + (Sx_all * t201);
    const float t230 = (yaw_per_v_delta * (t211 + (p->c * K0_12_lam))) + (sin_lam * t165);
    const float K0_22_lam = (sin_lam * K0_12_lam) - (cos_lam * t125);
    const float t234 = t114 * t200;
    const float K2_22_lam = (yaw_per_v_delta * (t105 - K0_12_lam)) - (sin_lam * t172);
    const float M_11_rR = t110 + t110;
    const float t241 = p->mR - (t107 * t108);
    const float C1_12_rR = yaw_by_delta * t241;
    const float K2_12_IRyy = yaw_per_v_delta * t107;
    const float C1_12_IRyy = p->c * K2_12_IRyy;
    const float C1_21_rR = t108 * C1_12_IRyy;
    const float K2_12_rR = yaw_per_v_delta * t241;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float C1_12_mR = p->c * K2_12_mR;
    const float C1_22_IRxx = yaw_by_delta * yaw_per_v_delta;
    const float M_22_IRxx = p->c * C1_22_IRxx;
    const float t252 = yaw_by_delta * t111;
    const float P_delta_lateral_mB = yaw_by_delta * p->xB;
    const float t254 = p->mB * P_delta_lateral_mB;
    const float M_22_xB = t144 * t254;
    const float t256 = p->zB * yaw_per_v_delta;
    const float t257 = p->mB * t256;
    const float K2_22_xB = p->mB * C1_22_IRxx;
    const float P_delta_yaw_mB = p->c + p->xB;
    const float C1_22_xB = K2_22_xB * (p->xB + P_delta_yaw_mB);
    const float P_delta_lateral_xB = p->mB * yaw_by_delta;
    const float t263 = sin_lam * P_delta_lateral_xB;
    const float M_11_zB = t111 + t111;
    const float t265 = p->mB * yaw_per_v_delta;
    const float t266 = P_delta_yaw_mB * t265;
    const float t267 = p->zB * P_delta_lateral_mB;
    const float M_22_mB = P_delta_lateral_mB * P_delta_lateral_mB;
    const float t269 = t256 * P_delta_yaw_mB;
    const float K2_22_mB = yaw_per_v_delta * P_delta_lateral_mB;
    const float C1_22_mB = P_delta_yaw_mB * K2_22_mB;
    const float t272 = sin_lam * P_delta_lateral_mB;
    const float t273 = t75 + t149;
    const float t274 = t81 * t144;
    const float t275 = t273 + t274;
    const float M_22_xH = t143 + (yaw_by_delta * (t273 + t275));
    const float t279 = t7 * yaw_per_v_delta;
    const float C1_22_xH = yaw_per_v_delta * (t275 + (p->c * P_delta_lateral_xH));
    const float K0_12_zH = p->mH * sin_lam;
    const float t284 = C1_12_h_spin_F * K0_12_zH;
    const float C1_22_IHzz = yaw_per_v_delta * C1_12_h_spin_F;
    const float K2_22_xH = p->mH * C1_22_IHzz;
    const float Jxx_delta_zH = t7 + t7;
    const float t289 = t74 + (yaw_by_delta * p->xH);
    const float M_12_zH = p->mH * (t73 - t289);
    const float t293 = sin_lam * (t142 + t274);
    const float t294 = p->c + p->xH;
    const float t295 = t31 * t148;
    const float t296 = t294 * t295;
    const float t297 = sin_lam * t295;
    const float t298 = t294 * t297;
    const float K0_22_zH = sin_lam * K0_12_zH;
    const float Jxx_delta_mH = p->zH * p->zH;
    const float t301 = p->zH * t289;
    const float M_22_mH = t289 * t289;
    const float t303 = p->zH * yaw_per_v_delta;
    const float t304 = t294 * t303;
    const float K2_22_mH = yaw_per_v_delta * t289;
    const float C1_22_mH = t294 * K2_22_mH;
    const float t307 = sin_lam * t289;
    const float M_22_IHxx = sin_lam * sin_lam;
    const float t309 = yaw_by_delta + C1_12_h_spin_F;
    const float M_22_yaw_per_v_delta = cos_lam * t309;
    const float M_22_IHzz = M_22_IRxx + M_22_yaw_per_v_delta;
    const float M_22_IHxz = sin_lam * (cos_lam + t309);
    const float K2_22_h_spin_F = sin_lam * yaw_per_v_delta;
    const float t315 = p->mF + p->mF;
    const float M_11_rF = p->rF * t315;
    const float t317 = p->rF * sin_lam;
    const float t319 = p->c * (cos_lam - P_delta_lateral_yaw_per_v_delta);
    const float P_delta_lateral_mF = t317 - t319;
    const float M_12_rF = p->mF * (t317 + P_delta_lateral_mF);
    const float t323 = sin_lam * P_delta_lateral_mF;
    const float M_22_rF = t315 * t323;
    const float C1_12_IFyy = t103 * C1_12_h_spin_F;
    const float C1_21_rF = h_spin_F * C1_12_IFyy;
    const float t327 = t31 * t183;
    const float C1_12_rF = t327 - C1_21_rF;
    const float C1_22_rF = sin_lam * t327;
    const float P_delta_lateral_rF = p->mF * sin_lam;
    const float t331 = p->mF * M_22_IHxx;
    const float t333 = (t103 * t105) - t68;
    const float t334 = t31 * t333;
    const float t335 = t200 * t333;
    const float M_11_mF = p->rF * p->rF;
    const float M_12_mF = p->rF * P_delta_lateral_mF;
    const float M_22_mF = P_delta_lateral_mF * P_delta_lateral_mF;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float C1_12_mF = t37 * K2_12_mF;
    const float K2_22_mF = yaw_per_v_delta * P_delta_lateral_mF;
    const float C1_22_mF = t37 * K2_22_mF;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float K2_12_IFyy = yaw_per_v_delta * t103;
    const float K2_22_IFyy = t103 * K2_22_h_spin_F;
    const float C1_21 = -(cos_lam * t120);
    const float C1_22 = -(yaw_per_v_delta * t127);
    const float K0_12 = -t125;
    const float K0_22 = -(sin_lam * t125);
    const float K0_12_mF = t319 - t317;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[1][0] = 0.0F;
    matrices->c0[1][1] = p->d;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->kc[0][0] = 0.0F;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = p->k;
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
    derivatives->values[7] = t171;
    derivatives->values[8] = t174;
    derivatives->values[9] = t178;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = K2_12;
    derivatives->values[12] = t158;
    derivatives->values[13] = C1_22_c;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = K0_22_c;
    derivatives->values[16] = t197;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = C1_12_lam;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = t230;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = t234;
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
    derivatives->values[40] = t252;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t257;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = P_delta_lateral_xB;
    derivatives->values[45] = t263;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t254;
    derivatives->values[49] = t266;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t265;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t267;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t269;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = P_delta_lateral_mB;
    derivatives->values[59] = t272;
    derivatives->values[60] = t256;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = yaw_by_delta;
    derivatives->values[63] = yaw_per_v_delta;
    derivatives->values[64] = t138;
    derivatives->values[65] = M_22_xH;
    derivatives->values[66] = t279;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = P_delta_lateral_xH;
    derivatives->values[69] = t284;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = Jxx_delta_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = t293;
    derivatives->values[74] = t296;
    derivatives->values[75] = t298;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t295;
    derivatives->values[80] = t297;
    derivatives->values[81] = Jxx_delta_mH;
    derivatives->values[82] = t301;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = t304;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = t289;
    derivatives->values[88] = t307;
    derivatives->values[89] = t303;
    derivatives->values[90] = K2_22_mH;
    derivatives->values[91] = sin_lam;
    derivatives->values[92] = M_22_IHxx;
    derivatives->values[93] = M_22_IHzz;
    derivatives->values[94] = C1_22_IHzz;
    derivatives->values[95] = C1_12_h_spin_F;
    derivatives->values[96] = M_22_IHxz;
    derivatives->values[97] = K2_22_h_spin_F;
    derivatives->values[98] = M_11_rF;
    derivatives->values[99] = M_12_rF;
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = C1_12_rF;
    derivatives->values[102] = C1_21_rF;
    derivatives->values[103] = C1_22_rF;
    derivatives->values[104] = p->mF;
    derivatives->values[105] = P_delta_lateral_rF;
    derivatives->values[106] = t331;
    derivatives->values[107] = t334;
    derivatives->values[108] = t335;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = M_12_mF;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = C1_22_mF;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = t323;
    derivatives->values[117] = K2_12_mF;
    derivatives->values[118] = K2_22_mF;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = K2_12_IFyy;
    derivatives->values[122] = K2_22_IFyy;
}

void whipple_sprung_f32_with_respect_to(const whipple_sprung_f32_derivatives_t *derivatives,
    size_t parameter, whipple_sprung_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHIPPLE_SPRUNG_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_SPRUNG_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c0[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->kc[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
            matrices->k2[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < WHIPPLE_SPRUNG_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &whipple_sprung_partials[position];
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
            case CARVALLO_MATRIX_KC:
                matrices->kc[partial->row][partial->column] = signed_value;
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
