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
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 52U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 52U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 53U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 46U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 45U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 61U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 59U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 59U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 60U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 39U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 62U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 19U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 19U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 54U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 32U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 27U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 56U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 55U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 55U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 57U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 58U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 70U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 70U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 79U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 49U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 63U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 69U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 71U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 71U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 78U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 40U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 77U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 14U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 4U, 28U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 4U, 23U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 1U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 4U, 29U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 11U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 30U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 0U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 5U, 31U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 67U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 6U, 66U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 7U, 34U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 7U, 34U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 7U, 33U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 8U, 73U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 8U, 73U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 8U, 80U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 8U, 24U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 8U, 75U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 8U, 72U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 8U, 72U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 8U, 81U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 82U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 15U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 48U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 48U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 9U, 74U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 3U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 9U, 68U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 12U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 10U, 83U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 10U, 83U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 10U, 84U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 10U, 89U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 10U, 87U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 10U, 2U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 10U, 76U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 10U, 76U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 10U, 85U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 10U, 88U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 10U, 86U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 11U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 13U, 67U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 13U, 66U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 14U, 18U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 14U, 18U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 14U, 22U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 15U, 92U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 15U, 92U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 91U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 94U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 98U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 90U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 90U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 101U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 97U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 13U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 47U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 47U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 65U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 51U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 106U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 5U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 64U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 64U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 108U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 50U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 105U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 10U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 41U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 41U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 44U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 95U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 100U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 37U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 37U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 42U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 93U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 99U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 18U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 18U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 18U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 18U, 107U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 20U, 111U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 20U, 96U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 21U, 38U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 21U, 38U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 21U, 102U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 21U, 22U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 21U, 103U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 22U, 16U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 22U, 20U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 22U, 20U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 25U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 22U, 43U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 22U, 114U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 22U, 116U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 22U, 7U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 22U, 115U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 22U, 115U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 22U, 109U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 35U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 22U, 104U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 23U, 17U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 21U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 21U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 26U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 117U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 118U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 6U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 119U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 119U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 110U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 36U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 120U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 112U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 96U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 113U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 113U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 121U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 122U, false},
    {CARVALLO_MATRIX_KC, 1U, 1U, 26U, 8U, false},
    {CARVALLO_MATRIX_C0, 1U, 1U, 27U, 8U, false}
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
    const double t2 = p->zH * p->mH;
    const double t7 = p->zB * p->mB;
    const double t13 = p->rR * p->mR;
    const double t18 = p->rF * p->mF;
    const double ay_delta2_delta = p->IHxx + p->IFxx;
    const double t23 = (p->rF * t18) + ay_delta2_delta;
    const double M_11 = (p->zH * t2) + (p->IRxx + (p->zB * t7)) + ((p->rR * t13) + (p->IBxx + t23));
    double wx_delta2_delta = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &wx_delta2_delta, &cos_lam);
    const double yaw_per_v_delta = cos_lam / p->w;
    const double yaw_by_delta = p->c * yaw_per_v_delta;
    const double wz_delta2_delta = cos_lam + yaw_by_delta;
    const double t35 = p->IHxz * wz_delta2_delta;
    const double t38 = t35 + (wx_delta2_delta * t23);
    const double t42 = p->IBxz - (t7 * p->xB);
    const double vy_spin_F4_delta = cos_lam * (p->c + p->w);
    const double t51 = vy_spin_F4_delta + ((p->zH * wx_delta2_delta) - (p->xH * wz_delta2_delta));
    const double t52 = p->mH * t51;
    const double M_12 = t38 + (yaw_by_delta * t42) + (p->zH * t52);
    const double t57 = wz_delta2_delta * (p->IFxx + p->IHzz);
    const double t60 = p->mB * p->xB;
    const double t64 = yaw_by_delta * (p->IRxx + (p->IBzz + (p->xB * t60)));
    const double M_22 = (wz_delta2_delta * t57) + (yaw_by_delta * t64) + ((t51 * t52) +
        (wx_delta2_delta * (t38 + t35)));
    const double vy_all1_delta = (t18 * wz_delta2_delta) + (yaw_per_v_delta * p->IHxz);
    const double t78 = t7 + t2 - t13;
    const double h_spin_R = p->IRyy / p->rR;
    const double h_spin_F = p->IFyy / p->rF;
    const double t91 = (yaw_by_delta * h_spin_R) + (wz_delta2_delta * h_spin_F);
    const double C1_12 = vy_all1_delta - (yaw_per_v_delta * ((p->c * t78) + (t2 * p->xH) - t42)) +
        t91;
    const double t96 = t52 - (yaw_by_delta * t60);
    const double h_wheels_all = ((p->xH * t52) - t64 + (p->c * t96) - t57) * yaw_per_v_delta;
    const double K0_11 = t78 - t18;
    const double K0_12 = t96 - (t18 * wx_delta2_delta);
    const double K0_22 = wx_delta2_delta * K0_12;
    const double K2_12 = yaw_per_v_delta * (h_spin_R + h_spin_F - K0_11);
    const double K2_22 = yaw_per_v_delta * ((wx_delta2_delta * h_spin_F) - K0_12);
    const double C1_21 = -t91;
    const double C1_22 = (vy_all1_delta * wx_delta2_delta) - h_wheels_all;
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
    double wx_delta2_delta = 0.0;
    double wx_delta2_delta_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const double t29 = p->rF * p->mF;
    const double t32 = (p->rF * t29) + p->IHxx + p->IFxx;
    const double M_11_mH = p->zH * p->zH;
    const double M_11_mR = p->rR * p->rR;
    const double M_11_mB = p->zB * p->zB;
    const double t36 = p->mB * p->xB;
    const double M_12_yaw_by_delta = p->IHxz + p->IBxz - (p->zB * t36);
    const double t40 = 1.0 / p->w;
    const double t41 = p->mH * p->zH;
    const double M_11_zH = t41 + t41;
    const double t43 = p->IFxx + p->IHzz;
    const double t46 = p->IRxx + p->IBzz + (p->xB * t36);
    const double M_11 = t32 + (p->mH * M_11_mH) + p->IRxx + (p->mR * M_11_mR) + p->IBxx + (p->mB *
        M_11_mB);
    const double t55 = p->c * t40;
    const double t56 = t55 * p->xH;
    const double t57 = 1.0 / p->rF;
    const double t60 = t40 * ((t41 * p->xH) - M_12_yaw_by_delta);
    const double t61 = 1.0 / p->rR;
    const double h_spin_F = p->IFyy * t57;
    const double t63 = p->mR * p->rR;
    const double M_11_rR = t63 + t63;
    const double t67 = p->c + p->w - p->xH - t56;
    const double h_spin_R = p->IRyy * t61;
    const double t69 = p->mB * p->zB;
    const double M_11_zB = t69 + t69;
    const double t72 = t41 + t69 - t29;
    const double t73 = p->c + p->xH;
    const double t74 = p->xB + p->c;
    const double M_11_rF = t29 + t29;
    const double t76 = h_spin_F + h_spin_R;
    const double t77 = t61 * h_spin_R;
    const double K0_11 = t72 - t63;
    const double t80 = p->mF - (t57 * h_spin_F);
    const double M_11_mF = p->rF * p->rF;
    const double t83 = t76 + (t63 - t72);
    const double t84 = p->mR - t77;
    const double t85 = wx_delta2_delta_lam * p->IHxz;
    const double yaw_by_delta = wx_delta2_delta_lam * t55;
    const double M_12_c = wx_delta2_delta_lam * (t41 - t60);
    const double M_12_rF = wx_delta2_delta * M_11_rF;
    const double M_12_mF = wx_delta2_delta * M_11_mF;
    const double t91 = t32 * wx_delta2_delta;
    const double t92 = p->zH * wx_delta2_delta;
    const double t93 = p->IHxz * wx_delta2_delta;
    const double t94 = wx_delta2_delta_lam * h_spin_F;
    const double vy_all1_delta = t29 * wx_delta2_delta;
    const double yaw_per_v_delta = wx_delta2_delta_lam * t40;
    const double C1_21_rR = yaw_by_delta * t77;
    const double t98 = t69 * yaw_per_v_delta;
    const double M_22_rF = wx_delta2_delta * M_12_rF;
    const double M_22_mF = wx_delta2_delta * M_12_mF;
    const double t101 = t76 * yaw_per_v_delta;
    const double C1_12_rR = yaw_by_delta * t84;
    const double K2_12_rR = yaw_per_v_delta * t84;
    const double C1_12_mR = p->rR * yaw_by_delta;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double K2_12 = t83 * yaw_per_v_delta;
    const double t107 = t40 * t83;
    const double K2_12_IRyy = t61 * yaw_per_v_delta;
    const double C1_12_IRyy = p->c * K2_12_IRyy;
    const double K2_12_rF = yaw_per_v_delta * t80;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double t112 = M_12_yaw_by_delta * yaw_by_delta;
    const double K0_12_mH = t92 + (wx_delta2_delta_lam * t67);
    const double wz_delta2_delta = wx_delta2_delta_lam + yaw_by_delta;
    const double t117 = t60 - (p->c * t107);
    const double M_12 = t85 + t112 + t91 + (t41 * K0_12_mH);
    const double t123 = t91 + (p->IHxz * wz_delta2_delta);
    const double t124 = t107 * yaw_per_v_delta;
    const double t125 = wx_delta2_delta * t107;
    const double M_12_mH = p->zH * K0_12_mH;
    const double K0_22_mH = wx_delta2_delta * K0_12_mH;
    const double C1_12_rF = wz_delta2_delta * t80;
    const double t130 = (wz_delta2_delta * t43) + t93;
    const double t132 = t130 + (yaw_by_delta * t46);
    const double M_22_mH = K0_12_mH * K0_12_mH;
    const double t134 = yaw_by_delta * t76;
    const double C1_21_w = t40 * t134;
    const double C1_21 = -(t94 + t134);
    const double C1_12_w = t117 * yaw_per_v_delta;
    const double t140 = t29 + h_spin_F - t117;
    const double t141 = t29 * wx_delta2_delta_lam;
    const double t142 = p->mH * K0_12_mH;
    const double M_12_zH = t142 + (p->mH * t92);
    const double t145 = t36 * yaw_by_delta;
    const double K0_12 = t142 - vy_all1_delta - t145;
    const double t149 = t130 + (t55 * t132);
    const double t152 = t40 * ((p->xH * t142) - t132);
    const double t156 = t145 + (yaw_per_v_delta * (t43 + t46)) - K0_12;
    const double C1_12 = wx_delta2_delta_lam * t140;
    const double t158 = wx_delta2_delta * t140;
    const double K0_22 = wx_delta2_delta * K0_12;
    const double t161 = t132 * (yaw_per_v_delta + yaw_per_v_delta);
    const double t162 = wx_delta2_delta * h_spin_F;
    const double t164 = t40 * (t162 - K0_12);
    const double t165 = p->mH * yaw_per_v_delta;
    const double t166 = t165 * t73;
    const double C1_12_yaw_per_v_delta = wx_delta2_delta * t123;
    const double M_22 = (wx_delta2_delta_lam * t149) + C1_12_yaw_per_v_delta + (p->mH * M_22_mH);
    const double t172 = p->mH * wx_delta2_delta_lam;
    const double K2_22 = wx_delta2_delta_lam * t164;
    const double t175 = (t56 * t165) + t172;
    const double t177 = t172 - (p->xH * t165);
    const double t178 = vy_all1_delta - t152;
    const double M_22_wz_delta2_delta = K0_12_mH + K0_12_mH;
    const double M_12_w = (p->zH * t175) - (t40 * t112);
    const double C1_12_yaw_by_delta = t175 * M_22_wz_delta2_delta;
    const double M_22_w = C1_12_yaw_by_delta - (t55 * t161);
    const double M_22_c = t161 + (M_22_wz_delta2_delta * t177);
    const double C1_22 = wx_delta2_delta_lam * (t178 - (t55 * K0_12));
    const double t191 = t36 * yaw_per_v_delta;
    const double K0_12_c = t177 - t191;
    const double C1_22_c = yaw_per_v_delta * (t156 - (t73 * t177));
    const double t196 = t55 * t156;
    const double t197 = t191 - t177;
    const double t198 = wx_delta2_delta * t197;
    const double K2_22_c = yaw_per_v_delta * t197;
    const double K0_12_w = t175 + (t55 * t191);
    const double K0_22_w = wx_delta2_delta * K0_12_w;
    const double C1_22_w = yaw_per_v_delta * (t152 - t196 - (t175 * t73));
    const double t208 = yaw_per_v_delta * (t164 + K0_12_w);
    const double t209 = t55 * wx_delta2_delta;
    const double C1_21_lam = t162 + (t76 * t209);
    const double K0_12_zH = p->mH * wx_delta2_delta;
    const double C1_22_yaw_by_delta = (wx_delta2_delta_lam * t41) - (t67 * K0_12_zH);
    const double M_22_zH = M_22_wz_delta2_delta * K0_12_zH;
    const double C1_22_IRxx = yaw_by_delta * yaw_per_v_delta;
    const double M_22_IRxx = p->c * C1_22_IRxx;
    const double t219 = p->mB * yaw_per_v_delta;
    const double C1_22_wz_delta2_delta = wx_delta2_delta * t43;
    const double M_22_yaw_by_delta = t85 - (t73 * C1_22_yaw_by_delta) - C1_22_wz_delta2_delta;
    const double C1_22_lam = (wz_delta2_delta * t141) + (yaw_per_v_delta * M_22_yaw_by_delta) -
        (wx_delta2_delta * (t178 + t196));
    const double t235 = t93 + (M_12_yaw_by_delta * t209) - (p->zH * C1_22_yaw_by_delta) - (t32 *
        wx_delta2_delta_lam);
    const double K0_12_lam = C1_22_yaw_by_delta + (t36 * t209) - t141;
    const double t243 = (K0_12_mH * C1_22_yaw_by_delta) + (wx_delta2_delta_lam * t123) -
        (wx_delta2_delta * t149);
    const double t244 = p->c * t219;
    const double t245 = p->zB * t244;
    const double t246 = t219 * t74;
    const double C1_22_xB = yaw_by_delta * (t191 + t246);
    const double t249 = p->xB * yaw_by_delta;
    const double M_12_yaw_per_v_delta = t94 - K0_12_lam;
    const double K2_22_lam = (yaw_per_v_delta * M_12_yaw_per_v_delta) - (wx_delta2_delta * t164);
    const double K0_22_lam = (wx_delta2_delta_lam * K0_12) + (wx_delta2_delta * K0_12_lam);
    const double M_22_lam = t243 + t243;
    const double M_22_xB = t244 * (t249 + t249);
    const double t260 = wx_delta2_delta * t244;
    const double K2_22_xB = yaw_per_v_delta * t244;
    const double t262 = p->zB * t249;
    const double M_22_mB = t249 * t249;
    const double t264 = wx_delta2_delta * t249;
    const double K2_22_mB = yaw_per_v_delta * t249;
    const double C1_22_mB = t74 * K2_22_mB;
    const double t267 = p->zB * yaw_per_v_delta;
    const double t268 = t74 * t267;
    const double t269 = p->mH * wz_delta2_delta;
    const double t270 = M_22_wz_delta2_delta * t269;
    const double t271 = p->zH * t269;
    const double t272 = p->zH * yaw_per_v_delta;
    const double t273 = p->mH * t272;
    const double t274 = t73 * t272;
    const double C1_22_IHzz = wz_delta2_delta * yaw_per_v_delta;
    const double K2_22_xH = p->mH * C1_22_IHzz;
    const double C1_22_xH = (t73 * K2_22_xH) - (K0_12_mH * t165);
    const double t280 = K0_12_mH * yaw_per_v_delta;
    const double t281 = t73 * t280;
    const double t282 = wx_delta2_delta * wz_delta2_delta;
    const double t283 = p->mH * t282;
    const double M_22_IHxz = t282 + t282;
    const double K2_22_h_spin_F = wx_delta2_delta * yaw_per_v_delta;
    const double K2_22_rF = K2_22_h_spin_F * t80;
    const double t287 = p->mH * K2_22_h_spin_F;
    const double t288 = t73 * t287;
    const double M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const double K0_22_zH = p->mH * M_22_IHxx;
    const double t291 = p->mF * M_22_IHxx;
    const double t292 = p->rF * M_22_IHxx;
    const double M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double C1_12_IFyy = wz_delta2_delta * t57;
    const double C1_21_rF = h_spin_F * C1_12_IFyy;
    const double t297 = p->mF * wx_delta2_delta;
    const double C1_22_rF = wz_delta2_delta * t297;
    const double C1_12_mF = p->rF * wz_delta2_delta;
    const double C1_22_mF = wx_delta2_delta * C1_12_mF;
    const double t301 = p->rF * wx_delta2_delta;
    const double K2_22_mF = yaw_per_v_delta * t301;
    const double K2_12_IFyy = t57 * yaw_per_v_delta;
    const double K2_22_IFyy = wx_delta2_delta * K2_12_IFyy;
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
    derivatives->values[0] = p->rR;
    derivatives->values[1] = p->mR;
    derivatives->values[2] = p->zB;
    derivatives->values[3] = p->mB;
    derivatives->values[4] = p->zH;
    derivatives->values[5] = p->mH;
    derivatives->values[6] = p->rF;
    derivatives->values[7] = p->mF;
    derivatives->values[8] = 1.0;
    derivatives->values[9] = wx_delta2_delta;
    derivatives->values[10] = M_11_mH;
    derivatives->values[11] = M_11_mR;
    derivatives->values[12] = M_11_mB;
    derivatives->values[13] = M_11_zH;
    derivatives->values[14] = M_11_rR;
    derivatives->values[15] = M_11_zB;
    derivatives->values[16] = M_11_rF;
    derivatives->values[17] = M_11_mF;
    derivatives->values[18] = yaw_by_delta;
    derivatives->values[19] = M_12_c;
    derivatives->values[20] = M_12_rF;
    derivatives->values[21] = M_12_mF;
    derivatives->values[22] = yaw_per_v_delta;
    derivatives->values[23] = C1_21_rR;
    derivatives->values[24] = t98;
    derivatives->values[25] = M_22_rF;
    derivatives->values[26] = M_22_mF;
    derivatives->values[27] = t101;
    derivatives->values[28] = C1_12_rR;
    derivatives->values[29] = K2_12_rR;
    derivatives->values[30] = C1_12_mR;
    derivatives->values[31] = K2_12_mR;
    derivatives->values[32] = K2_12;
    derivatives->values[33] = K2_12_IRyy;
    derivatives->values[34] = C1_12_IRyy;
    derivatives->values[35] = K2_12_rF;
    derivatives->values[36] = K2_12_mF;
    derivatives->values[37] = K0_12_mH;
    derivatives->values[38] = wz_delta2_delta;
    derivatives->values[39] = t124;
    derivatives->values[40] = t125;
    derivatives->values[41] = M_12_mH;
    derivatives->values[42] = K0_22_mH;
    derivatives->values[43] = C1_12_rF;
    derivatives->values[44] = M_22_mH;
    derivatives->values[45] = C1_21_w;
    derivatives->values[46] = C1_12_w;
    derivatives->values[47] = M_12_zH;
    derivatives->values[48] = t145;
    derivatives->values[49] = t158;
    derivatives->values[50] = t165;
    derivatives->values[51] = t166;
    derivatives->values[52] = M_12_w;
    derivatives->values[53] = M_22_w;
    derivatives->values[54] = M_22_c;
    derivatives->values[55] = K0_12_c;
    derivatives->values[56] = C1_22_c;
    derivatives->values[57] = t198;
    derivatives->values[58] = K2_22_c;
    derivatives->values[59] = K0_12_w;
    derivatives->values[60] = K0_22_w;
    derivatives->values[61] = C1_22_w;
    derivatives->values[62] = t208;
    derivatives->values[63] = C1_21_lam;
    derivatives->values[64] = K0_12_zH;
    derivatives->values[65] = M_22_zH;
    derivatives->values[66] = C1_22_IRxx;
    derivatives->values[67] = M_22_IRxx;
    derivatives->values[68] = t219;
    derivatives->values[69] = C1_22_lam;
    derivatives->values[70] = t235;
    derivatives->values[71] = K0_12_lam;
    derivatives->values[72] = t244;
    derivatives->values[73] = t245;
    derivatives->values[74] = t246;
    derivatives->values[75] = C1_22_xB;
    derivatives->values[76] = t249;
    derivatives->values[77] = K2_22_lam;
    derivatives->values[78] = K0_22_lam;
    derivatives->values[79] = M_22_lam;
    derivatives->values[80] = M_22_xB;
    derivatives->values[81] = t260;
    derivatives->values[82] = K2_22_xB;
    derivatives->values[83] = t262;
    derivatives->values[84] = M_22_mB;
    derivatives->values[85] = t264;
    derivatives->values[86] = K2_22_mB;
    derivatives->values[87] = C1_22_mB;
    derivatives->values[88] = t267;
    derivatives->values[89] = t268;
    derivatives->values[90] = t269;
    derivatives->values[91] = t270;
    derivatives->values[92] = t271;
    derivatives->values[93] = t272;
    derivatives->values[94] = t273;
    derivatives->values[95] = t274;
    derivatives->values[96] = C1_22_IHzz;
    derivatives->values[97] = K2_22_xH;
    derivatives->values[98] = C1_22_xH;
    derivatives->values[99] = t280;
    derivatives->values[100] = t281;
    derivatives->values[101] = t283;
    derivatives->values[102] = M_22_IHxz;
    derivatives->values[103] = K2_22_h_spin_F;
    derivatives->values[104] = K2_22_rF;
    derivatives->values[105] = t287;
    derivatives->values[106] = t288;
    derivatives->values[107] = M_22_IHxx;
    derivatives->values[108] = K0_22_zH;
    derivatives->values[109] = t291;
    derivatives->values[110] = t292;
    derivatives->values[111] = M_22_IHzz;
    derivatives->values[112] = M_22_IFxx;
    derivatives->values[113] = C1_12_IFyy;
    derivatives->values[114] = C1_21_rF;
    derivatives->values[115] = t297;
    derivatives->values[116] = C1_22_rF;
    derivatives->values[117] = C1_12_mF;
    derivatives->values[118] = C1_22_mF;
    derivatives->values[119] = t301;
    derivatives->values[120] = K2_22_mF;
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
    const float t2 = p->zH * p->mH;
    const float t7 = p->zB * p->mB;
    const float t13 = p->rR * p->mR;
    const float t18 = p->rF * p->mF;
    const float ay_delta2_delta = p->IHxx + p->IFxx;
    const float t23 = (p->rF * t18) + ay_delta2_delta;
    const float M_11 = (p->zH * t2) + (p->IRxx + (p->zB * t7)) + ((p->rR * t13) + (p->IBxx + t23));
    float wx_delta2_delta = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &wx_delta2_delta, &cos_lam);
    const float yaw_per_v_delta = cos_lam / p->w;
    const float yaw_by_delta = p->c * yaw_per_v_delta;
    const float wz_delta2_delta = cos_lam + yaw_by_delta;
    const float t35 = p->IHxz * wz_delta2_delta;
    const float t38 = t35 + (wx_delta2_delta * t23);
    const float t42 = p->IBxz - (t7 * p->xB);
    const float vy_spin_F4_delta = cos_lam * (p->c + p->w);
    const float t51 = vy_spin_F4_delta + ((p->zH * wx_delta2_delta) - (p->xH * wz_delta2_delta));
    const float t52 = p->mH * t51;
    const float M_12 = t38 + (yaw_by_delta * t42) + (p->zH * t52);
    const float t57 = wz_delta2_delta * (p->IFxx + p->IHzz);
    const float t60 = p->mB * p->xB;
    const float t64 = yaw_by_delta * (p->IRxx + (p->IBzz + (p->xB * t60)));
    const float M_22 = (wz_delta2_delta * t57) + (yaw_by_delta * t64) + ((t51 * t52) +
        (wx_delta2_delta * (t38 + t35)));
    const float vy_all1_delta = (t18 * wz_delta2_delta) + (yaw_per_v_delta * p->IHxz);
    const float t78 = t7 + t2 - t13;
    const float h_spin_R = p->IRyy / p->rR;
    const float h_spin_F = p->IFyy / p->rF;
    const float t91 = (yaw_by_delta * h_spin_R) + (wz_delta2_delta * h_spin_F);
    const float C1_12 = vy_all1_delta - (yaw_per_v_delta * ((p->c * t78) + (t2 * p->xH) - t42)) +
        t91;
    const float t96 = t52 - (yaw_by_delta * t60);
    const float h_wheels_all = ((p->xH * t52) - t64 + (p->c * t96) - t57) * yaw_per_v_delta;
    const float K0_11 = t78 - t18;
    const float K0_12 = t96 - (t18 * wx_delta2_delta);
    const float K0_22 = wx_delta2_delta * K0_12;
    const float K2_12 = yaw_per_v_delta * (h_spin_R + h_spin_F - K0_11);
    const float K2_22 = yaw_per_v_delta * ((wx_delta2_delta * h_spin_F) - K0_12);
    const float C1_21 = -t91;
    const float C1_22 = (vy_all1_delta * wx_delta2_delta) - h_wheels_all;
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
    float wx_delta2_delta = 0.0F;
    float wx_delta2_delta_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const float t29 = p->rF * p->mF;
    const float t32 = (p->rF * t29) + p->IHxx + p->IFxx;
    const float M_11_mH = p->zH * p->zH;
    const float M_11_mR = p->rR * p->rR;
    const float M_11_mB = p->zB * p->zB;
    const float t36 = p->mB * p->xB;
    const float M_12_yaw_by_delta = p->IHxz + p->IBxz - (p->zB * t36);
    const float t40 = 1.0F / p->w;
    const float t41 = p->mH * p->zH;
    const float M_11_zH = t41 + t41;
    const float t43 = p->IFxx + p->IHzz;
    const float t46 = p->IRxx + p->IBzz + (p->xB * t36);
    const float M_11 = t32 + (p->mH * M_11_mH) + p->IRxx + (p->mR * M_11_mR) + p->IBxx + (p->mB *
        M_11_mB);
    const float t55 = p->c * t40;
    const float t56 = t55 * p->xH;
    const float t57 = 1.0F / p->rF;
    const float t60 = t40 * ((t41 * p->xH) - M_12_yaw_by_delta);
    const float t61 = 1.0F / p->rR;
    const float h_spin_F = p->IFyy * t57;
    const float t63 = p->mR * p->rR;
    const float M_11_rR = t63 + t63;
    const float t67 = p->c + p->w - p->xH - t56;
    const float h_spin_R = p->IRyy * t61;
    const float t69 = p->mB * p->zB;
    const float M_11_zB = t69 + t69;
    const float t72 = t41 + t69 - t29;
    const float t73 = p->c + p->xH;
    const float t74 = p->xB + p->c;
    const float M_11_rF = t29 + t29;
    const float t76 = h_spin_F + h_spin_R;
    const float t77 = t61 * h_spin_R;
    const float K0_11 = t72 - t63;
    const float t80 = p->mF - (t57 * h_spin_F);
    const float M_11_mF = p->rF * p->rF;
    const float t83 = t76 + (t63 - t72);
    const float t84 = p->mR - t77;
    const float t85 = wx_delta2_delta_lam * p->IHxz;
    const float yaw_by_delta = wx_delta2_delta_lam * t55;
    const float M_12_c = wx_delta2_delta_lam * (t41 - t60);
    const float M_12_rF = wx_delta2_delta * M_11_rF;
    const float M_12_mF = wx_delta2_delta * M_11_mF;
    const float t91 = t32 * wx_delta2_delta;
    const float t92 = p->zH * wx_delta2_delta;
    const float t93 = p->IHxz * wx_delta2_delta;
    const float t94 = wx_delta2_delta_lam * h_spin_F;
    const float vy_all1_delta = t29 * wx_delta2_delta;
    const float yaw_per_v_delta = wx_delta2_delta_lam * t40;
    const float C1_21_rR = yaw_by_delta * t77;
    const float t98 = t69 * yaw_per_v_delta;
    const float M_22_rF = wx_delta2_delta * M_12_rF;
    const float M_22_mF = wx_delta2_delta * M_12_mF;
    const float t101 = t76 * yaw_per_v_delta;
    const float C1_12_rR = yaw_by_delta * t84;
    const float K2_12_rR = yaw_per_v_delta * t84;
    const float C1_12_mR = p->rR * yaw_by_delta;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float K2_12 = t83 * yaw_per_v_delta;
    const float t107 = t40 * t83;
    const float K2_12_IRyy = t61 * yaw_per_v_delta;
    const float C1_12_IRyy = p->c * K2_12_IRyy;
    const float K2_12_rF = yaw_per_v_delta * t80;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float t112 = M_12_yaw_by_delta * yaw_by_delta;
    const float K0_12_mH = t92 + (wx_delta2_delta_lam * t67);
    const float wz_delta2_delta = wx_delta2_delta_lam + yaw_by_delta;
    const float t117 = t60 - (p->c * t107);
    const float M_12 = t85 + t112 + t91 + (t41 * K0_12_mH);
    const float t123 = t91 + (p->IHxz * wz_delta2_delta);
    const float t124 = t107 * yaw_per_v_delta;
    const float t125 = wx_delta2_delta * t107;
    const float M_12_mH = p->zH * K0_12_mH;
    const float K0_22_mH = wx_delta2_delta * K0_12_mH;
    const float C1_12_rF = wz_delta2_delta * t80;
    const float t130 = (wz_delta2_delta * t43) + t93;
    const float t132 = t130 + (yaw_by_delta * t46);
    const float M_22_mH = K0_12_mH * K0_12_mH;
    const float t134 = yaw_by_delta * t76;
    const float C1_21_w = t40 * t134;
    const float C1_21 = -(t94 + t134);
    const float C1_12_w = t117 * yaw_per_v_delta;
    const float t140 = t29 + h_spin_F - t117;
    const float t141 = t29 * wx_delta2_delta_lam;
    const float t142 = p->mH * K0_12_mH;
    const float M_12_zH = t142 + (p->mH * t92);
    const float t145 = t36 * yaw_by_delta;
    const float K0_12 = t142 - vy_all1_delta - t145;
    const float t149 = t130 + (t55 * t132);
    const float t152 = t40 * ((p->xH * t142) - t132);
    const float t156 = t145 + (yaw_per_v_delta * (t43 + t46)) - K0_12;
    const float C1_12 = wx_delta2_delta_lam * t140;
    const float t158 = wx_delta2_delta * t140;
    const float K0_22 = wx_delta2_delta * K0_12;
    const float t161 = t132 * (yaw_per_v_delta + yaw_per_v_delta);
    const float t162 = wx_delta2_delta * h_spin_F;
    const float t164 = t40 * (t162 - K0_12);
    const float t165 = p->mH * yaw_per_v_delta;
    const float t166 = t165 * t73;
    const float C1_12_yaw_per_v_delta = wx_delta2_delta * t123;
    const float M_22 = (wx_delta2_delta_lam * t149) + C1_12_yaw_per_v_delta + (p->mH * M_22_mH);
    const float t172 = p->mH * wx_delta2_delta_lam;
    const float K2_22 = wx_delta2_delta_lam * t164;
    const float t175 = (t56 * t165) + t172;
    const float t177 = t172 - (p->xH * t165);
    const float t178 = vy_all1_delta - t152;
    const float M_22_wz_delta2_delta = K0_12_mH + K0_12_mH;
    const float M_12_w = (p->zH * t175) - (t40 * t112);
    const float C1_12_yaw_by_delta = t175 * M_22_wz_delta2_delta;
    const float M_22_w = C1_12_yaw_by_delta - (t55 * t161);
    const float M_22_c = t161 + (M_22_wz_delta2_delta * t177);
    const float C1_22 = wx_delta2_delta_lam * (t178 - (t55 * K0_12));
    const float t191 = t36 * yaw_per_v_delta;
    const float K0_12_c = t177 - t191;
    const float C1_22_c = yaw_per_v_delta * (t156 - (t73 * t177));
    const float t196 = t55 * t156;
    const float t197 = t191 - t177;
    const float t198 = wx_delta2_delta * t197;
    const float K2_22_c = yaw_per_v_delta * t197;
    const float K0_12_w = t175 + (t55 * t191);
    const float K0_22_w = wx_delta2_delta * K0_12_w;
    const float C1_22_w = yaw_per_v_delta * (t152 - t196 - (t175 * t73));
    const float t208 = yaw_per_v_delta * (t164 + K0_12_w);
    const float t209 = t55 * wx_delta2_delta;
    const float C1_21_lam = t162 + (t76 * t209);
    const float K0_12_zH = p->mH * wx_delta2_delta;
    const float C1_22_yaw_by_delta = (wx_delta2_delta_lam * t41) - (t67 * K0_12_zH);
    const float M_22_zH = M_22_wz_delta2_delta * K0_12_zH;
    const float C1_22_IRxx = yaw_by_delta * yaw_per_v_delta;
    const float M_22_IRxx = p->c * C1_22_IRxx;
    const float t219 = p->mB * yaw_per_v_delta;
    const float C1_22_wz_delta2_delta = wx_delta2_delta * t43;
    const float M_22_yaw_by_delta = t85 - (t73 * C1_22_yaw_by_delta) - C1_22_wz_delta2_delta;
    const float C1_22_lam = (wz_delta2_delta * t141) + (yaw_per_v_delta * M_22_yaw_by_delta) -
        (wx_delta2_delta * (t178 + t196));
    const float t235 = t93 + (M_12_yaw_by_delta * t209) - (p->zH * C1_22_yaw_by_delta) - (t32 *
        wx_delta2_delta_lam);
    const float K0_12_lam = C1_22_yaw_by_delta + (t36 * t209) - t141;
    const float t243 = (K0_12_mH * C1_22_yaw_by_delta) + (wx_delta2_delta_lam * t123) -
        (wx_delta2_delta * t149);
    const float t244 = p->c * t219;
    const float t245 = p->zB * t244;
    const float t246 = t219 * t74;
    const float C1_22_xB = yaw_by_delta * (t191 + t246);
    const float t249 = p->xB * yaw_by_delta;
    const float M_12_yaw_per_v_delta = t94 - K0_12_lam;
    const float K2_22_lam = (yaw_per_v_delta * M_12_yaw_per_v_delta) - (wx_delta2_delta * t164);
    const float K0_22_lam = (wx_delta2_delta_lam * K0_12) + (wx_delta2_delta * K0_12_lam);
    const float M_22_lam = t243 + t243;
    const float M_22_xB = t244 * (t249 + t249);
    const float t260 = wx_delta2_delta * t244;
    const float K2_22_xB = yaw_per_v_delta * t244;
    const float t262 = p->zB * t249;
    const float M_22_mB = t249 * t249;
    const float t264 = wx_delta2_delta * t249;
    const float K2_22_mB = yaw_per_v_delta * t249;
    const float C1_22_mB = t74 * K2_22_mB;
    const float t267 = p->zB * yaw_per_v_delta;
    const float t268 = t74 * t267;
    const float t269 = p->mH * wz_delta2_delta;
    const float t270 = M_22_wz_delta2_delta * t269;
    const float t271 = p->zH * t269;
    const float t272 = p->zH * yaw_per_v_delta;
    const float t273 = p->mH * t272;
    const float t274 = t73 * t272;
    const float C1_22_IHzz = wz_delta2_delta * yaw_per_v_delta;
    const float K2_22_xH = p->mH * C1_22_IHzz;
    const float C1_22_xH = (t73 * K2_22_xH) - (K0_12_mH * t165);
    const float t280 = K0_12_mH * yaw_per_v_delta;
    const float t281 = t73 * t280;
    const float t282 = wx_delta2_delta * wz_delta2_delta;
    const float t283 = p->mH * t282;
    const float M_22_IHxz = t282 + t282;
    const float K2_22_h_spin_F = wx_delta2_delta * yaw_per_v_delta;
    const float K2_22_rF = K2_22_h_spin_F * t80;
    const float t287 = p->mH * K2_22_h_spin_F;
    const float t288 = t73 * t287;
    const float M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const float K0_22_zH = p->mH * M_22_IHxx;
    const float t291 = p->mF * M_22_IHxx;
    const float t292 = p->rF * M_22_IHxx;
    const float M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float C1_12_IFyy = wz_delta2_delta * t57;
    const float C1_21_rF = h_spin_F * C1_12_IFyy;
    const float t297 = p->mF * wx_delta2_delta;
    const float C1_22_rF = wz_delta2_delta * t297;
    const float C1_12_mF = p->rF * wz_delta2_delta;
    const float C1_22_mF = wx_delta2_delta * C1_12_mF;
    const float t301 = p->rF * wx_delta2_delta;
    const float K2_22_mF = yaw_per_v_delta * t301;
    const float K2_12_IFyy = t57 * yaw_per_v_delta;
    const float K2_22_IFyy = wx_delta2_delta * K2_12_IFyy;
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
    derivatives->values[0] = p->rR;
    derivatives->values[1] = p->mR;
    derivatives->values[2] = p->zB;
    derivatives->values[3] = p->mB;
    derivatives->values[4] = p->zH;
    derivatives->values[5] = p->mH;
    derivatives->values[6] = p->rF;
    derivatives->values[7] = p->mF;
    derivatives->values[8] = 1.0F;
    derivatives->values[9] = wx_delta2_delta;
    derivatives->values[10] = M_11_mH;
    derivatives->values[11] = M_11_mR;
    derivatives->values[12] = M_11_mB;
    derivatives->values[13] = M_11_zH;
    derivatives->values[14] = M_11_rR;
    derivatives->values[15] = M_11_zB;
    derivatives->values[16] = M_11_rF;
    derivatives->values[17] = M_11_mF;
    derivatives->values[18] = yaw_by_delta;
    derivatives->values[19] = M_12_c;
    derivatives->values[20] = M_12_rF;
    derivatives->values[21] = M_12_mF;
    derivatives->values[22] = yaw_per_v_delta;
    derivatives->values[23] = C1_21_rR;
    derivatives->values[24] = t98;
    derivatives->values[25] = M_22_rF;
    derivatives->values[26] = M_22_mF;
    derivatives->values[27] = t101;
    derivatives->values[28] = C1_12_rR;
    derivatives->values[29] = K2_12_rR;
    derivatives->values[30] = C1_12_mR;
    derivatives->values[31] = K2_12_mR;
    derivatives->values[32] = K2_12;
    derivatives->values[33] = K2_12_IRyy;
    derivatives->values[34] = C1_12_IRyy;
    derivatives->values[35] = K2_12_rF;
    derivatives->values[36] = K2_12_mF;
    derivatives->values[37] = K0_12_mH;
    derivatives->values[38] = wz_delta2_delta;
    derivatives->values[39] = t124;
    derivatives->values[40] = t125;
    derivatives->values[41] = M_12_mH;
    derivatives->values[42] = K0_22_mH;
    derivatives->values[43] = C1_12_rF;
    derivatives->values[44] = M_22_mH;
    derivatives->values[45] = C1_21_w;
    derivatives->values[46] = C1_12_w;
    derivatives->values[47] = M_12_zH;
    derivatives->values[48] = t145;
    derivatives->values[49] = t158;
    derivatives->values[50] = t165;
    derivatives->values[51] = t166;
    derivatives->values[52] = M_12_w;
    derivatives->values[53] = M_22_w;
    derivatives->values[54] = M_22_c;
    derivatives->values[55] = K0_12_c;
    derivatives->values[56] = C1_22_c;
    derivatives->values[57] = t198;
    derivatives->values[58] = K2_22_c;
    derivatives->values[59] = K0_12_w;
    derivatives->values[60] = K0_22_w;
    derivatives->values[61] = C1_22_w;
    derivatives->values[62] = t208;
    derivatives->values[63] = C1_21_lam;
    derivatives->values[64] = K0_12_zH;
    derivatives->values[65] = M_22_zH;
    derivatives->values[66] = C1_22_IRxx;
    derivatives->values[67] = M_22_IRxx;
    derivatives->values[68] = t219;
    derivatives->values[69] = C1_22_lam;
    derivatives->values[70] = t235;
    derivatives->values[71] = K0_12_lam;
    derivatives->values[72] = t244;
    derivatives->values[73] = t245;
    derivatives->values[74] = t246;
    derivatives->values[75] = C1_22_xB;
    derivatives->values[76] = t249;
    derivatives->values[77] = K2_22_lam;
    derivatives->values[78] = K0_22_lam;
    derivatives->values[79] = M_22_lam;
    derivatives->values[80] = M_22_xB;
    derivatives->values[81] = t260;
    derivatives->values[82] = K2_22_xB;
    derivatives->values[83] = t262;
    derivatives->values[84] = M_22_mB;
    derivatives->values[85] = t264;
    derivatives->values[86] = K2_22_mB;
    derivatives->values[87] = C1_22_mB;
    derivatives->values[88] = t267;
    derivatives->values[89] = t268;
    derivatives->values[90] = t269;
    derivatives->values[91] = t270;
    derivatives->values[92] = t271;
    derivatives->values[93] = t272;
    derivatives->values[94] = t273;
    derivatives->values[95] = t274;
    derivatives->values[96] = C1_22_IHzz;
    derivatives->values[97] = K2_22_xH;
    derivatives->values[98] = C1_22_xH;
    derivatives->values[99] = t280;
    derivatives->values[100] = t281;
    derivatives->values[101] = t283;
    derivatives->values[102] = M_22_IHxz;
    derivatives->values[103] = K2_22_h_spin_F;
    derivatives->values[104] = K2_22_rF;
    derivatives->values[105] = t287;
    derivatives->values[106] = t288;
    derivatives->values[107] = M_22_IHxx;
    derivatives->values[108] = K0_22_zH;
    derivatives->values[109] = t291;
    derivatives->values[110] = t292;
    derivatives->values[111] = M_22_IHzz;
    derivatives->values[112] = M_22_IFxx;
    derivatives->values[113] = C1_12_IFyy;
    derivatives->values[114] = C1_21_rF;
    derivatives->values[115] = t297;
    derivatives->values[116] = C1_22_rF;
    derivatives->values[117] = C1_12_mF;
    derivatives->values[118] = C1_22_mF;
    derivatives->values[119] = t301;
    derivatives->values[120] = K2_22_mF;
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
