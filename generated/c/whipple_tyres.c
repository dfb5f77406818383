/* @generated from generated/models/whipple_tyres.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 0fd874e368fb3457
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
 * m_all = mR + mB + m_delta [kg]
 * load_spin_F = -Sx_all/w [kg]
 * load_spin_R = -(m_all + load_spin_F) [kg]
 * h_spin_R = IRyy/rR [kg*m]
 * h_spin_F = IFyy/rF [kg*m]
 * h_wheels_all = h_spin_R + h_spin_F [kg*m]
 * M_yaw_delta = py_delta*(w + c) + hz_delta [kg*m^2]
 * M_delta_delta = hx_delta*sin(lam) + hz_delta*cos(lam) [kg*m^2]
 * K_phi_phi = Sz_all - rhoR*load_spin_R - rhoF*load_spin_F [kg*m]
 * K_phi_delta = -(py_delta + load_spin_F*(rhoF*sin(lam) - c*cos(lam))) [kg*m]
 * K_delta_delta = -(py_delta + load_spin_F*(rhoF*sin(lam) - c*cos(lam)))*sin(lam) [kg*m]
 * P_delta_lateral = yaw_by_delta*Sx_all + py_delta [kg*m]
 * P_delta_yaw = yaw_by_delta*Jzz_all + M_yaw_delta [kg*m^2]
 * P_delta_delta = yaw_by_delta*M_yaw_delta + M_delta_delta [kg*m^2]
 * M_11 = Jxx_all [kg*m^2]
 * M_12 = M_21 = yaw_by_delta*Jxz_all + hx_delta [kg*m^2]
 * M_22 = yaw_by_delta*P_delta_yaw + P_delta_delta [kg*m^2]
 * C1_12 = yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_F*cos(lam) [kg*m]
 * C1_21 = -(yaw_by_delta*h_wheels_all + h_spin_F*cos(lam)) [kg*m]
 * C1_22 = yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
 * K0_11 = K_phi_phi [kg*m]
 * K0_12 = K0_21 = K_phi_delta [kg*m]
 * K0_22 = K_delta_delta [kg*m]
 * K2_12 = yaw_per_v_delta*(h_wheels_all - Sz_all) [kg]
 * K2_22 = yaw_per_v_delta*(h_spin_F*sin(lam) + P_delta_lateral) [kg]
 * @endverbatim
 */

#include "whipple_tyres.h"

#include "carvallo_trig.h"

#include <float.h>

const char *whipple_tyres_set_name(whipple_tyres_set_t set)
{
    static const char *const TEXTS[] = {
        "benchmark",
        "benchmark_2005",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *whipple_tyres_validity_text(whipple_tyres_validity_t validity)
{
    static const char *const TEXTS[] = {
        "WhippleTyres: the parameters are valid",
        "WhippleTyres: w in m must be finite and > 0",
        "WhippleTyres: c in m must be finite",
        "WhippleTyres: lam in rad must be finite and > -1.5707963267948966 and < 1.5707963267948966",
        "WhippleTyres: g in N/kg must be finite and >= 0",
        "WhippleTyres: rR in m must be finite and > 0",
        "WhippleTyres: mR in kg must be finite and >= 0",
        "WhippleTyres: IRxx in kg*m^2 must be finite and >= 0",
        "WhippleTyres: IRyy in kg*m^2 must be finite and >= 0",
        "WhippleTyres: xB in m must be finite",
        "WhippleTyres: zB in m must be finite",
        "WhippleTyres: mB in kg must be finite and >= 0",
        "WhippleTyres: IBxx in kg*m^2 must be finite and >= 0",
        "WhippleTyres: IByy in kg*m^2 must be finite and >= 0",
        "WhippleTyres: IBzz in kg*m^2 must be finite and >= 0",
        "WhippleTyres: IBxz in kg*m^2 must be finite",
        "WhippleTyres: xH in m must be finite",
        "WhippleTyres: zH in m must be finite",
        "WhippleTyres: mH in kg must be finite and >= 0",
        "WhippleTyres: IHxx in kg*m^2 must be finite and >= 0",
        "WhippleTyres: IHyy in kg*m^2 must be finite and >= 0",
        "WhippleTyres: IHzz in kg*m^2 must be finite and >= 0",
        "WhippleTyres: IHxz in kg*m^2 must be finite",
        "WhippleTyres: rF in m must be finite and > 0",
        "WhippleTyres: mF in kg must be finite and >= 0",
        "WhippleTyres: IFxx in kg*m^2 must be finite and >= 0",
        "WhippleTyres: IFyy in kg*m^2 must be finite and >= 0",
        "WhippleTyres: rhoR in m must be finite and >= 0",
        "WhippleTyres: rhoF in m must be finite and >= 0",
        "WhippleTyres: rR - rhoR in m must be finite and >= 0",
        "WhippleTyres: rF - rhoF in m must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t whipple_tyres_partials[WHIPPLE_TYRES_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 1U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 2U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 3U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 0U, 5U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 6U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 6U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 7U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 8U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 9U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 10U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 10U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 11U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 12U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 13U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 14U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 15U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 15U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 16U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 17U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 18U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 18U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 19U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 20U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 21U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 22U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 23U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 23U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 24U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 25U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 26U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 27U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 4U, 28U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 4U, 29U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 30U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 4U, 31U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 32U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 33U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 34U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 5U, 35U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 36U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 37U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 6U, 38U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 7U, 39U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 7U, 39U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 7U, 40U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 8U, 41U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 8U, 41U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 8U, 42U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 8U, 43U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 8U, 44U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 8U, 45U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 8U, 46U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 8U, 46U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 8U, 47U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 48U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 49U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 50U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 50U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 9U, 51U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 52U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 9U, 53U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 54U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 10U, 55U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 10U, 55U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 10U, 56U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 10U, 57U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 10U, 58U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 10U, 59U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 10U, 60U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 10U, 60U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 10U, 61U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 10U, 62U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 10U, 63U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 11U, 36U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 13U, 37U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 13U, 38U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 14U, 64U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 14U, 64U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 14U, 65U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 15U, 66U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 15U, 66U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 67U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 68U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 69U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 15U, 70U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 71U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 71U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 72U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 73U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 74U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 75U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 75U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 76U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 77U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 78U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 79U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 80U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 80U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 81U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 82U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 83U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 84U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 85U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 85U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 86U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 87U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 88U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 89U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 90U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 90U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 91U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 92U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 93U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 18U, 36U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 18U, 94U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 18U, 94U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 18U, 95U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 20U, 96U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 20U, 97U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 21U, 98U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 21U, 98U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 21U, 99U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 21U, 65U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 21U, 100U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 22U, 101U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 22U, 102U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 22U, 102U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 103U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 22U, 104U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 22U, 105U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 22U, 106U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 22U, 107U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 22U, 108U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 22U, 108U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 22U, 109U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 110U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 22U, 111U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 23U, 112U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 113U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 113U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 114U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 115U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 116U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 117U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 118U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 118U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 119U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 120U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 121U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 36U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 94U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 94U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 122U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 97U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 123U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 123U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 124U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 125U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 26U, 126U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 27U, 127U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 27U, 128U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 27U, 128U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 27U, 129U, false}
};

const whipple_tyres_f64_t whipple_tyres_f64_sets[WHIPPLE_TYRES_SETS] = {
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
        .rhoR = 0.02,
        .rhoF = 0.02
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
        .rhoR = 0.02,
        .rhoF = 0.02
    }
};

whipple_tyres_validity_t whipple_tyres_f64_validate(const whipple_tyres_f64_t *p)
{
    whipple_tyres_validity_t validity = WHIPPLE_TYRES_VALID;
    if (!((p->w > 0.0) && (p->w <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_w;
    } else if (!((p->c >= -DBL_MAX) && (p->c <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_c;
    } else if (!((p->lam > (-1.5707963267948966)) && (p->lam < 1.5707963267948966))) {
        validity = WHIPPLE_TYRES_INVALID_lam;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_g;
    } else if (!((p->rR > 0.0) && (p->rR <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_rR;
    } else if (!((p->mR >= 0.0) && (p->mR <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_mR;
    } else if (!((p->IRxx >= 0.0) && (p->IRxx <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0) && (p->IRyy <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IRyy;
    } else if (!((p->xB >= -DBL_MAX) && (p->xB <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_xB;
    } else if (!((p->zB >= -DBL_MAX) && (p->zB <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_zB;
    } else if (!((p->mB >= 0.0) && (p->mB <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_mB;
    } else if (!((p->IBxx >= 0.0) && (p->IBxx <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0) && (p->IByy <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0) && (p->IBzz <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IBzz;
    } else if (!((p->IBxz >= -DBL_MAX) && (p->IBxz <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IBxz;
    } else if (!((p->xH >= -DBL_MAX) && (p->xH <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_xH;
    } else if (!((p->zH >= -DBL_MAX) && (p->zH <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_zH;
    } else if (!((p->mH >= 0.0) && (p->mH <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_mH;
    } else if (!((p->IHxx >= 0.0) && (p->IHxx <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0) && (p->IHyy <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0) && (p->IHzz <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IHzz;
    } else if (!((p->IHxz >= -DBL_MAX) && (p->IHxz <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IHxz;
    } else if (!((p->rF > 0.0) && (p->rF <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_rF;
    } else if (!((p->mF >= 0.0) && (p->mF <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_mF;
    } else if (!((p->IFxx >= 0.0) && (p->IFxx <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0) && (p->IFyy <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IFyy;
    } else if (!((p->rhoR >= 0.0) && (p->rhoR <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_rhoR;
    } else if (!((p->rhoF >= 0.0) && (p->rhoF <= DBL_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_rhoF;
    } else {
        const double t2 = p->rR - p->rhoR;
        const double t5 = p->rF - p->rhoF;
        if (!((t2 >= 0.0) && (t2 <= DBL_MAX))) {
            validity = WHIPPLE_TYRES_REQUIREMENT_1;
        } else if (!((t5 >= 0.0) && (t5 <= DBL_MAX))) {
            validity = WHIPPLE_TYRES_REQUIREMENT_2;
        } else {
            /* All requirements hold. */
        }
    }
    return validity;
}

void whipple_tyres_f64_matrices(const whipple_tyres_f64_t *p, whipple_tyres_f64_matrices_t *matrices)
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
    const double t43 = 1.0 / p->w;
    const double yaw_per_v_delta = cos_lam * t43;
    const double yaw_by_delta = p->c * yaw_per_v_delta;
    const double Sz_delta = t6 - t10;
    const double Jxz_all = Jxz_delta + p->IBxz - (t21 * p->xB) - (t35 * Sz_delta);
    const double M_12 = hx_delta + (yaw_by_delta * Jxz_all);
    const double t57 = p->mH * t36;
    const double t59 = p->mF * p->c;
    const double t62 = p->IFxx + p->IHzz;
    const double hz_delta = (sin_lam * Jxz_delta) + (cos_lam * ((t36 * t57) + (p->c * t59) + t62));
    const double t68 = t57 + t59;
    const double t70 = (sin_lam * Sz_delta) + (cos_lam * t68);
    const double M_yaw_delta = hz_delta - (t35 * t70);
    const double t74 = p->mB * p->xB;
    const double t85 = yaw_by_delta * (p->IRxx + t62 + p->IBzz + (p->xB * t74) + (p->mH * p->xH *
        p->xH) + (p->mF * p->w * p->w));
    const double P_delta_yaw = M_yaw_delta + t85;
    const double M_22 = (yaw_by_delta * (M_yaw_delta + P_delta_yaw)) + (sin_lam * hx_delta) +
        (cos_lam * hz_delta);
    const double h_spin_F = p->IFyy / p->rF;
    const double h_wheels_all = h_spin_F + (p->IRyy / p->rR);
    const double Sz_all = t21 + Sz_delta - t17;
    const double t101 = h_wheels_all - Sz_all;
    const double t104 = cos_lam * h_spin_F;
    const double C1_12 = (yaw_by_delta * t101) + (yaw_per_v_delta * Jxz_all) + t104;
    const double m_delta = p->mH + p->mF;
    const double Sx_all = t74 + (t35 * m_delta) - t68;
    const double P_delta_lateral = (yaw_by_delta * Sx_all) - t70;
    const double C1_22 = (yaw_by_delta * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
    const double t119 = t43 * Sx_all;
    const double K0_11 = Sz_all + (p->rhoF * t119) + (p->rhoR * (p->mR + p->mB + m_delta - t119));
    const double K_phi_delta = t70 + (t119 * ((sin_lam * p->rhoF) - (p->c * cos_lam)));
    const double K0_22 = sin_lam * K_phi_delta;
    const double K2_12 = yaw_per_v_delta * t101;
    const double K2_22 = yaw_per_v_delta * (P_delta_lateral + (sin_lam * h_spin_F));
    const double C1_21 = -(t104 + (yaw_by_delta * h_wheels_all));
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K_phi_delta;
    matrices->k0[1][0] = K_phi_delta;
    matrices->k0[1][1] = K0_22;
    matrices->k2[0][0] = 0.0;
    matrices->k2[0][1] = K2_12;
    matrices->k2[1][0] = 0.0;
    matrices->k2[1][1] = K2_22;
}

carvallo_system_error_t whipple_tyres_f64_at_speed(const whipple_tyres_f64_matrices_t *matrices,
    double speed, double gravity, whipple_tyres_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed) && carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < WHIPPLE_TYRES_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_TYRES_N; column++) {
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

carvallo_system_error_t whipple_tyres_f64_state_space(const whipple_tyres_f64_system_t *system,
    whipple_tyres_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[WHIPPLE_TYRES_N * WHIPPLE_TYRES_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * WHIPPLE_TYRES_N * WHIPPLE_TYRES_N];
    for (size_t row = 0U; row < WHIPPLE_TYRES_N; row++) {
        double *const solved = &x[3U * WHIPPLE_TYRES_N * row];
        for (size_t column = 0U; column < WHIPPLE_TYRES_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * WHIPPLE_TYRES_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHIPPLE_TYRES_N + column] = -system->c[row][column];
            solved[(2U * WHIPPLE_TYRES_N) + column] = 0.0;
        }
        solved[(2U * WHIPPLE_TYRES_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[WHIPPLE_TYRES_N * WHIPPLE_TYRES_N];
        error = carvallo_solve_f64(WHIPPLE_TYRES_N, m, terms, 3U * WHIPPLE_TYRES_N, x);
    }
    for (size_t row = 0U; row < (2U * WHIPPLE_TYRES_N); row++) {
        for (size_t column = 0U; column < (2U * WHIPPLE_TYRES_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < WHIPPLE_TYRES_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHIPPLE_TYRES_N; row++) {
            const size_t target = WHIPPLE_TYRES_N + row;
            for (size_t column = 0U; column < (2U * WHIPPLE_TYRES_N); column++) {
                space->a[target][column] = x[(3U * WHIPPLE_TYRES_N * row) + column];
            }
            for (size_t column = 0U; column < WHIPPLE_TYRES_N; column++) {
                space->b[target][column] = x[(3U * WHIPPLE_TYRES_N * row) + (2U * WHIPPLE_TYRES_N) +
                    column];
            }
            space->a[row][WHIPPLE_TYRES_N + row] = 1.0;
        }
    }
    return error;
}

double whipple_tyres_f64_rate_at(const whipple_tyres_f64_rate_t *rate, double v,
    const double q[WHIPPLE_TYRES_N], const double q_dot[WHIPPLE_TYRES_N], double psi)
{
    double by_coordinates = 0.0;
    double by_rates = 0.0;
    for (size_t i = 0U; i < WHIPPLE_TYRES_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void whipple_tyres_f64_kinematics(const whipple_tyres_f64_t *p, whipple_tyres_f64_kinematics_t *kinematics)
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

void whipple_tyres_f64_derivatives(const whipple_tyres_f64_t *p,
    whipple_tyres_f64_matrices_t *matrices, whipple_tyres_f64_derivatives_t *derivatives)
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
    const double t34 = p->c + p->w;
    const double t36 = t34 - p->xH;
    const double Jxz_delta = p->IHxz + (t6 * t36) - (t10 * p->c);
    const double t41 = Jxz_delta * cos_lam;
    const double hx_delta = (Jxx_delta * sin_lam) + t41;
    const double t43 = 1.0 / p->w;
    const double yaw_per_v_delta = cos_lam * t43;
    const double yaw_by_delta = p->c * yaw_per_v_delta;
    const double Sz_delta = t6 - t10;
    const double Jxz_all = Jxz_delta + p->IBxz - (t21 * p->xB) - (t34 * Sz_delta);
    const double M_12 = hx_delta + (yaw_by_delta * Jxz_all);
    const double t57 = sin_lam * Jxz_delta;
    const double t59 = p->IFxx + p->IHzz;
    const double t60 = p->mF * p->c;
    const double t62 = p->mH * t36;
    const double t65 = t59 + (p->c * t60) + (t36 * t62);
    const double hz_delta = t57 + (cos_lam * t65);
    const double t70 = t60 + t62;
    const double t72 = (sin_lam * Sz_delta) + (cos_lam * t70);
    const double M_yaw_delta = hz_delta - (t34 * t72);
    const double t76 = p->mB * p->xB;
    const double t78 = p->xH * p->xH;
    const double t80 = p->w * p->w;
    const double P_delta_yaw_yaw_by_delta = p->IRxx + t59 + p->IBzz + (p->xB * t76) + (p->mH *
        t78) + (p->mF * t80);
    const double t87 = yaw_by_delta * P_delta_yaw_yaw_by_delta;
    const double P_delta_yaw = M_yaw_delta + t87;
    const double t89 = M_yaw_delta + P_delta_yaw;
    const double M_22 = (sin_lam * hx_delta) + (cos_lam * hz_delta) + (yaw_by_delta * t89);
    const double t95 = 1.0 / p->rF;
    const double h_spin_F = p->IFyy * t95;
    const double t97 = cos_lam * h_spin_F;
    const double t99 = 1.0 / p->rR;
    const double t100 = p->IRyy * t99;
    const double h_wheels_all = h_spin_F + t100;
    const double Sz_all = t21 + Sz_delta - t17;
    const double t104 = h_wheels_all - Sz_all;
    const double t106 = yaw_per_v_delta * Jxz_all;
    const double C1_12 = t97 + (yaw_by_delta * t104) + t106;
    const double m_delta = p->mH + p->mF;
    const double Sx_all = t76 + (t34 * m_delta) - t70;
    const double t116 = yaw_by_delta * Sx_all;
    const double P_delta_lateral = t116 - t72;
    const double C1_22 = (yaw_per_v_delta * P_delta_yaw) + (yaw_by_delta * P_delta_lateral);
    const double K0_11_rhoF = t43 * Sx_all;
    const double t122 = p->rhoF * K0_11_rhoF;
    const double K0_11_rhoR = p->mR + p->mB + m_delta - K0_11_rhoF;
    const double K0_11 = Sz_all + t122 + (p->rhoR * K0_11_rhoR);
    const double t130 = p->c * cos_lam;
    const double t132 = (sin_lam * p->rhoF) - t130;
    const double K_phi_delta = t72 + (K0_11_rhoF * t132);
    const double K0_22 = sin_lam * K_phi_delta;
    const double K2_12 = yaw_per_v_delta * t104;
    const double t137 = sin_lam * h_spin_F;
    const double t138 = P_delta_lateral + t137;
    const double K2_22 = yaw_per_v_delta * t138;
    const double C1_12_h_spin_F = cos_lam + yaw_by_delta;
    const double t141 = t6 * C1_12_h_spin_F;
    const double t143 = t141 - (yaw_by_delta * Sz_delta);
    const double t144 = t43 * t43;
    const double t145 = cos_lam * t144;
    const double M_12_yaw_per_v_delta = p->c * Jxz_all;
    const double M_12_w = t143 - (t145 * M_12_yaw_per_v_delta);
    const double t149 = yaw_by_delta + yaw_by_delta;
    const double t150 = t34 * t149;
    const double t151 = cos_lam * t150;
    const double t152 = t36 * cos_lam;
    const double M_22_hz_delta = cos_lam + t149;
    const double t155 = (t152 * M_22_hz_delta) - t151;
    const double M_22_Jxz_delta = sin_lam * (cos_lam + M_22_hz_delta);
    const double t160 = cos_lam * t62;
    const double t163 = (p->mH * t155) + (t6 * M_22_Jxz_delta) + (M_22_hz_delta * t160);
    const double t165 = t163 - (t72 * t149);
    const double P_delta_yaw_w = p->mF * p->w * t149;
    const double M_22_yaw_by_delta = t87 + t89;
    const double M_22_yaw_per_v_delta = p->c * M_22_yaw_by_delta;
    const double M_22_w = t165 + (yaw_by_delta * P_delta_yaw_w) - (t145 * M_22_yaw_per_v_delta);
    const double t174 = t6 * yaw_per_v_delta;
    const double t176 = t174 - (yaw_per_v_delta * Sz_delta);
    const double C1_12_yaw_per_v_delta = Jxz_all + (p->c * t104);
    const double C1_12_w = t176 - (t145 * C1_12_yaw_per_v_delta);
    const double t181 = p->c * h_wheels_all;
    const double C1_21_w = t145 * t181;
    const double C1_22_Sx_all = yaw_by_delta * yaw_by_delta;
    const double t185 = yaw_by_delta + (t34 * yaw_per_v_delta);
    const double t187 = C1_22_Sx_all + (cos_lam * t185);
    const double t189 = (yaw_per_v_delta * t152) - t187;
    const double K2_22_h_spin_F = sin_lam * yaw_per_v_delta;
    const double t195 = (p->mH * t189) + (t6 * K2_22_h_spin_F) + (yaw_per_v_delta * t160);
    const double t199 = t195 + (m_delta * C1_22_Sx_all) - (yaw_per_v_delta * t72);
    const double C1_22_yaw_by_delta = t116 + P_delta_lateral + (yaw_per_v_delta *
        P_delta_yaw_yaw_by_delta);
    const double C1_22_yaw_per_v_delta = P_delta_yaw + (p->c * C1_22_yaw_by_delta);
    const double C1_22_w = t199 + (yaw_per_v_delta * P_delta_yaw_w) - (t145 *
        C1_22_yaw_per_v_delta);
    const double t209 = p->rhoF - p->rhoR;
    const double K0_11_Sx_all = t43 * t209;
    const double K0_11_xH = p->mH * K0_11_Sx_all;
    const double t213 = Sx_all * t144;
    const double K0_11_w = (m_delta * K0_11_Sx_all) - K0_11_xH - (t209 * t213);
    const double K_phi_delta_Sx_all = t43 * t132;
    const double t218 = cos_lam - K_phi_delta_Sx_all;
    const double t219 = p->mH * t218;
    const double t221 = t219 + (m_delta * K_phi_delta_Sx_all);
    const double K_phi_delta_w = t221 - (t132 * t213);
    const double K0_22_w = sin_lam * K_phi_delta_w;
    const double t225 = t104 * t145;
    const double K2_22_Sx_all = yaw_per_v_delta * yaw_by_delta;
    const double t228 = (cos_lam * yaw_per_v_delta) + K2_22_Sx_all;
    const double K2_22_xH = p->mH * t228;
    const double t231 = (m_delta * K2_22_Sx_all) - K2_22_xH;
    const double K2_22_yaw_by_delta = yaw_per_v_delta * Sx_all;
    const double K2_22_yaw_per_v_delta = t138 + (p->c * K2_22_yaw_by_delta);
    const double K2_22_w = t231 - (t145 * K2_22_yaw_per_v_delta);
    const double M_12_c = t106 + t143 - (t10 * C1_12_h_spin_F);
    const double t242 = (t130 * M_22_hz_delta) - t151;
    const double hz_delta_c = cos_lam * t60;
    const double M_22_c = t165 + (p->mF * t242) + (yaw_per_v_delta * M_22_yaw_by_delta) +
        (M_22_hz_delta * hz_delta_c) - (t10 * M_22_Jxz_delta);
    const double C1_12_c = t176 + (yaw_per_v_delta * (t104 - t10));
    const double t254 = yaw_per_v_delta * h_wheels_all;
    const double t257 = (yaw_per_v_delta * t130) - t187;
    const double C1_22_c = t199 + (p->mF * t257) + (yaw_per_v_delta * (C1_22_yaw_by_delta +
        hz_delta_c)) - (t10 * K2_22_h_spin_F);
    const double K_phi_delta_c = t221 + (p->mF * t218) - (cos_lam * K0_11_rhoF);
    const double K0_22_c = sin_lam * K_phi_delta_c;
    const double K2_22_c = t231 + (yaw_per_v_delta * K2_22_yaw_by_delta) - (p->mF * t228);
    const double hx_delta_lam = (Jxx_delta * cos_lam) - t57;
    const double t275 = sin_lam * t43;
    const double M_12_lam = hx_delta_lam - (M_12_yaw_per_v_delta * t275);
    const double t283 = (cos_lam * Sz_delta) - (sin_lam * t70);
    const double hz_delta_lam = t41 - (sin_lam * t65);
    const double M_22_lam = (sin_lam * hx_delta_lam) + (cos_lam * hx_delta) + (M_22_hz_delta *
        hz_delta_lam) - (sin_lam * hz_delta) - (t150 * t283) - (M_22_yaw_per_v_delta * t275);
    const double t295 = t137 + (C1_12_yaw_per_v_delta * t275);
    const double C1_21_lam = t137 + (t181 * t275);
    const double C1_22_lam = (yaw_per_v_delta * hz_delta_lam) - (t185 * t283) -
        (C1_22_yaw_per_v_delta * t275);
    const double K_phi_delta_rhoF = sin_lam * K0_11_rhoF;
    const double K_phi_delta_lam = t283 + (p->c * K_phi_delta_rhoF) + (cos_lam * t122);
    const double K0_22_lam = (sin_lam * K_phi_delta_lam) + (cos_lam * K_phi_delta);
    const double t311 = t104 * t275;
    const double K2_22_lam = (yaw_per_v_delta * (t97 - t283)) - (K2_22_yaw_per_v_delta * t275);
    const double M_11_rR = t17 + t17;
    const double t317 = t99 * t100;
    const double t318 = p->mR - t317;
    const double C1_12_rR = yaw_by_delta * t318;
    const double C1_21_rR = yaw_by_delta * t317;
    const double K2_12_rR = yaw_per_v_delta * t318;
    const double M_11_mR = p->rR * p->rR;
    const double C1_12_mR = p->rR * yaw_by_delta;
    const double K0_11_mR = p->rhoR - p->rR;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double C1_12_IRyy = yaw_by_delta * t99;
    const double K2_12_IRyy = yaw_per_v_delta * t99;
    const double t329 = t21 * yaw_by_delta;
    const double t330 = yaw_by_delta * p->xB;
    const double t331 = p->mB * t330;
    const double P_delta_yaw_xB = t331 + (yaw_by_delta * t76);
    const double M_22_xB = yaw_by_delta * P_delta_yaw_xB;
    const double t335 = t21 * yaw_per_v_delta;
    const double C1_22_xB = (p->mB * C1_22_Sx_all) + (yaw_per_v_delta * P_delta_yaw_xB);
    const double K0_11_xB = p->mB * K0_11_Sx_all;
    const double K_phi_delta_xB = p->mB * K_phi_delta_Sx_all;
    const double K0_22_xB = sin_lam * K_phi_delta_xB;
    const double K2_22_xB = p->mB * K2_22_Sx_all;
    const double M_11_zB = t21 + t21;
    const double t345 = yaw_by_delta + (yaw_per_v_delta * p->xB);
    const double t346 = p->mB * t345;
    const double t347 = p->mB * yaw_per_v_delta;
    const double M_11_mB = p->zB * p->zB;
    const double t349 = p->zB * t330;
    const double P_delta_yaw_mB = p->xB * t330;
    const double M_22_mB = yaw_by_delta * P_delta_yaw_mB;
    const double t352 = p->zB * t345;
    const double C1_22_mB = (p->xB * C1_22_Sx_all) + (yaw_per_v_delta * P_delta_yaw_mB);
    const double K0_11_mB = p->zB + p->rhoR + (p->xB * K0_11_Sx_all);
    const double K_phi_delta_mB = p->xB * K_phi_delta_Sx_all;
    const double K0_22_mB = sin_lam * K_phi_delta_mB;
    const double t361 = p->zB * yaw_per_v_delta;
    const double K2_22_mB = p->xB * K2_22_Sx_all;
    const double P_delta_yaw_xH = p->mH * p->xH * t149;
    const double M_22_xH = (yaw_by_delta * P_delta_yaw_xH) - t163;
    const double C1_22_xH = (yaw_per_v_delta * P_delta_yaw_xH) - t195;
    const double t369 = sin_lam * t219;
    const double M_11_zH = t6 + t6;
    const double t371 = t34 * yaw_by_delta;
    const double t373 = p->zH * sin_lam;
    const double t375 = (t36 * C1_12_h_spin_F) + t373 - t371;
    const double M_12_zH = (p->mH * t375) + (t6 * sin_lam);
    const double t379 = sin_lam * t150;
    const double M_22_Jxx_delta = sin_lam * sin_lam;
    const double t384 = (p->zH * M_22_Jxx_delta) + (t36 * M_22_Jxz_delta) - t379;
    const double M_22_zH = (p->mH * t384) + (t6 * M_22_Jxx_delta);
    const double t389 = (t36 * yaw_per_v_delta) - t185;
    const double C1_12_zH = p->mH * t389;
    const double t391 = sin_lam * t185;
    const double t393 = (t36 * K2_22_h_spin_F) - t391;
    const double C1_22_zH = p->mH * t393;
    const double K_phi_delta_zH = p->mH * sin_lam;
    const double K0_22_zH = sin_lam * K_phi_delta_zH;
    const double t397 = p->mH * yaw_per_v_delta;
    const double t398 = p->mH * K2_22_h_spin_F;
    const double M_11_mH = p->zH * p->zH;
    const double M_12_mH = p->zH * t375;
    const double P_delta_yaw_mH = yaw_by_delta * t78;
    const double M_22_mH = (p->zH * t384) + (t36 * t155) + (yaw_by_delta * P_delta_yaw_mH);
    const double C1_12_mH = p->zH * t389;
    const double C1_22_m_delta = t34 * C1_22_Sx_all;
    const double C1_22_mH = C1_22_m_delta + (p->zH * t393) + (t36 * t189) + (yaw_per_v_delta *
        P_delta_yaw_mH);
    const double K0_11_m_delta = p->rhoR + (t34 * K0_11_Sx_all);
    const double K0_11_mH = p->zH + K0_11_m_delta - (t36 * K0_11_Sx_all);
    const double K_phi_delta_m_delta = t34 * K_phi_delta_Sx_all;
    const double K_phi_delta_mH = t373 + K_phi_delta_m_delta + (t36 * t218);
    const double K0_22_mH = sin_lam * K_phi_delta_mH;
    const double t425 = p->zH * yaw_per_v_delta;
    const double K2_22_m_delta = t34 * K2_22_Sx_all;
    const double K2_22_mH = K2_22_m_delta - (p->zH * K2_22_h_spin_F) - (t36 * t228);
    const double M_22_IHzz = C1_22_Sx_all + (cos_lam * M_22_hz_delta);
    const double C1_22_IHzz = yaw_per_v_delta * C1_12_h_spin_F;
    const double M_11_rF = t10 + t10;
    const double t436 = p->rF * sin_lam;
    const double t438 = t371 + t436 - (p->c * C1_12_h_spin_F);
    const double M_12_rF = (p->mF * t438) + (t10 * sin_lam);
    const double t445 = t379 + (p->rF * M_22_Jxx_delta) - (p->c * M_22_Jxz_delta);
    const double M_22_rF = (p->mF * t445) + (t10 * M_22_Jxx_delta);
    const double t449 = t185 - yaw_by_delta;
    const double t451 = t95 * h_spin_F;
    const double C1_21_rF = C1_12_h_spin_F * t451;
    const double C1_12_rF = (p->mF * t449) - C1_21_rF;
    const double t455 = t391 - (p->c * K2_22_h_spin_F);
    const double C1_22_rF = p->mF * t455;
    const double t457 = p->mF * sin_lam;
    const double t458 = sin_lam * t457;
    const double K2_12_rF = (p->mF * yaw_per_v_delta) - (yaw_per_v_delta * t451);
    const double K2_22_rF = (p->mF * K2_22_h_spin_F) - (K2_22_h_spin_F * t451);
    const double M_11_mF = p->rF * p->rF;
    const double M_12_mF = p->rF * t438;
    const double P_delta_yaw_mF = yaw_by_delta * t80;
    const double M_22_mF = (p->c * t242) + (p->rF * t445) + (yaw_by_delta * P_delta_yaw_mF);
    const double C1_12_mF = p->rF * t449;
    const double C1_22_mF = C1_22_m_delta + (p->c * t257) + (p->rF * t455) + (yaw_per_v_delta *
        P_delta_yaw_mF);
    const double K0_11_mF = K0_11_m_delta - p->rF - (p->c * K0_11_Sx_all);
    const double K_phi_delta_mF = K_phi_delta_m_delta + (p->c * t218) - t436;
    const double K0_22_mF = sin_lam * K_phi_delta_mF;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double K2_22_mF = K2_22_m_delta + (p->rF * K2_22_h_spin_F) - (p->c * t228);
    const double M_22_IFxx = M_22_Jxx_delta + M_22_IHzz;
    const double C1_12_IFyy = t95 * C1_12_h_spin_F;
    const double K2_12_IFyy = yaw_per_v_delta * t95;
    const double K2_22_IFyy = t95 * K2_22_h_spin_F;
    const double K0_22_rhoF = sin_lam * K_phi_delta_rhoF;
    const double C1_21 = -(t97 + (yaw_by_delta * h_wheels_all));
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K_phi_delta;
    matrices->k0[1][0] = K_phi_delta;
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
    derivatives->values[5] = K0_11_w;
    derivatives->values[6] = K_phi_delta_w;
    derivatives->values[7] = K0_22_w;
    derivatives->values[8] = t225;
    derivatives->values[9] = K2_22_w;
    derivatives->values[10] = M_12_c;
    derivatives->values[11] = M_22_c;
    derivatives->values[12] = C1_12_c;
    derivatives->values[13] = t254;
    derivatives->values[14] = C1_22_c;
    derivatives->values[15] = K_phi_delta_c;
    derivatives->values[16] = K0_22_c;
    derivatives->values[17] = K2_22_c;
    derivatives->values[18] = M_12_lam;
    derivatives->values[19] = M_22_lam;
    derivatives->values[20] = t295;
    derivatives->values[21] = C1_21_lam;
    derivatives->values[22] = C1_22_lam;
    derivatives->values[23] = K_phi_delta_lam;
    derivatives->values[24] = K0_22_lam;
    derivatives->values[25] = t311;
    derivatives->values[26] = K2_22_lam;
    derivatives->values[27] = M_11_rR;
    derivatives->values[28] = C1_12_rR;
    derivatives->values[29] = C1_21_rR;
    derivatives->values[30] = p->mR;
    derivatives->values[31] = K2_12_rR;
    derivatives->values[32] = M_11_mR;
    derivatives->values[33] = C1_12_mR;
    derivatives->values[34] = K0_11_mR;
    derivatives->values[35] = K2_12_mR;
    derivatives->values[36] = 1.0;
    derivatives->values[37] = C1_22_Sx_all;
    derivatives->values[38] = K2_22_Sx_all;
    derivatives->values[39] = C1_12_IRyy;
    derivatives->values[40] = K2_12_IRyy;
    derivatives->values[41] = t329;
    derivatives->values[42] = M_22_xB;
    derivatives->values[43] = t335;
    derivatives->values[44] = C1_22_xB;
    derivatives->values[45] = K0_11_xB;
    derivatives->values[46] = K_phi_delta_xB;
    derivatives->values[47] = K0_22_xB;
    derivatives->values[48] = K2_22_xB;
    derivatives->values[49] = M_11_zB;
    derivatives->values[50] = t331;
    derivatives->values[51] = t346;
    derivatives->values[52] = p->mB;
    derivatives->values[53] = t347;
    derivatives->values[54] = M_11_mB;
    derivatives->values[55] = t349;
    derivatives->values[56] = M_22_mB;
    derivatives->values[57] = t352;
    derivatives->values[58] = C1_22_mB;
    derivatives->values[59] = K0_11_mB;
    derivatives->values[60] = K_phi_delta_mB;
    derivatives->values[61] = K0_22_mB;
    derivatives->values[62] = t361;
    derivatives->values[63] = K2_22_mB;
    derivatives->values[64] = yaw_by_delta;
    derivatives->values[65] = yaw_per_v_delta;
    derivatives->values[66] = t141;
    derivatives->values[67] = M_22_xH;
    derivatives->values[68] = t174;
    derivatives->values[69] = C1_22_xH;
    derivatives->values[70] = K0_11_xH;
    derivatives->values[71] = t219;
    derivatives->values[72] = t369;
    derivatives->values[73] = K2_22_xH;
    derivatives->values[74] = M_11_zH;
    derivatives->values[75] = M_12_zH;
    derivatives->values[76] = M_22_zH;
    derivatives->values[77] = C1_12_zH;
    derivatives->values[78] = C1_22_zH;
    derivatives->values[79] = p->mH;
    derivatives->values[80] = K_phi_delta_zH;
    derivatives->values[81] = K0_22_zH;
    derivatives->values[82] = t397;
    derivatives->values[83] = t398;
    derivatives->values[84] = M_11_mH;
    derivatives->values[85] = M_12_mH;
    derivatives->values[86] = M_22_mH;
    derivatives->values[87] = C1_12_mH;
    derivatives->values[88] = C1_22_mH;
    derivatives->values[89] = K0_11_mH;
    derivatives->values[90] = K_phi_delta_mH;
    derivatives->values[91] = K0_22_mH;
    derivatives->values[92] = t425;
    derivatives->values[93] = K2_22_mH;
    derivatives->values[94] = sin_lam;
    derivatives->values[95] = M_22_Jxx_delta;
    derivatives->values[96] = M_22_IHzz;
    derivatives->values[97] = C1_22_IHzz;
    derivatives->values[98] = C1_12_h_spin_F;
    derivatives->values[99] = M_22_Jxz_delta;
    derivatives->values[100] = K2_22_h_spin_F;
    derivatives->values[101] = M_11_rF;
    derivatives->values[102] = M_12_rF;
    derivatives->values[103] = M_22_rF;
    derivatives->values[104] = C1_12_rF;
    derivatives->values[105] = C1_21_rF;
    derivatives->values[106] = C1_22_rF;
    derivatives->values[107] = p->mF;
    derivatives->values[108] = t457;
    derivatives->values[109] = t458;
    derivatives->values[110] = K2_12_rF;
    derivatives->values[111] = K2_22_rF;
    derivatives->values[112] = M_11_mF;
    derivatives->values[113] = M_12_mF;
    derivatives->values[114] = M_22_mF;
    derivatives->values[115] = C1_12_mF;
    derivatives->values[116] = C1_22_mF;
    derivatives->values[117] = K0_11_mF;
    derivatives->values[118] = K_phi_delta_mF;
    derivatives->values[119] = K0_22_mF;
    derivatives->values[120] = K2_12_mF;
    derivatives->values[121] = K2_22_mF;
    derivatives->values[122] = M_22_IFxx;
    derivatives->values[123] = C1_12_IFyy;
    derivatives->values[124] = K2_12_IFyy;
    derivatives->values[125] = K2_22_IFyy;
    derivatives->values[126] = K0_11_rhoR;
    derivatives->values[127] = K0_11_rhoF;
    derivatives->values[128] = K_phi_delta_rhoF;
    derivatives->values[129] = K0_22_rhoF;
}

void whipple_tyres_f64_with_respect_to(const whipple_tyres_f64_derivatives_t *derivatives,
    size_t parameter, whipple_tyres_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHIPPLE_TYRES_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_TYRES_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
            matrices->k2[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < WHIPPLE_TYRES_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &whipple_tyres_partials[position];
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

const whipple_tyres_f32_t whipple_tyres_f32_sets[WHIPPLE_TYRES_SETS] = {
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
        .rhoR = 0.02F,
        .rhoF = 0.02F
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
        .rhoR = 0.02F,
        .rhoF = 0.02F
    }
};

whipple_tyres_validity_t whipple_tyres_f32_validate(const whipple_tyres_f32_t *p)
{
    whipple_tyres_validity_t validity = WHIPPLE_TYRES_VALID;
    if (!((p->w > 0.0F) && (p->w <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_w;
    } else if (!((p->c >= -FLT_MAX) && (p->c <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_c;
    } else if (!((p->lam > (-1.5707964F)) && (p->lam < 1.5707964F))) {
        validity = WHIPPLE_TYRES_INVALID_lam;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_g;
    } else if (!((p->rR > 0.0F) && (p->rR <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_rR;
    } else if (!((p->mR >= 0.0F) && (p->mR <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_mR;
    } else if (!((p->IRxx >= 0.0F) && (p->IRxx <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0F) && (p->IRyy <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IRyy;
    } else if (!((p->xB >= -FLT_MAX) && (p->xB <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_xB;
    } else if (!((p->zB >= -FLT_MAX) && (p->zB <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_zB;
    } else if (!((p->mB >= 0.0F) && (p->mB <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_mB;
    } else if (!((p->IBxx >= 0.0F) && (p->IBxx <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0F) && (p->IByy <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0F) && (p->IBzz <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IBzz;
    } else if (!((p->IBxz >= -FLT_MAX) && (p->IBxz <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IBxz;
    } else if (!((p->xH >= -FLT_MAX) && (p->xH <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_xH;
    } else if (!((p->zH >= -FLT_MAX) && (p->zH <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_zH;
    } else if (!((p->mH >= 0.0F) && (p->mH <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_mH;
    } else if (!((p->IHxx >= 0.0F) && (p->IHxx <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0F) && (p->IHyy <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0F) && (p->IHzz <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IHzz;
    } else if (!((p->IHxz >= -FLT_MAX) && (p->IHxz <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IHxz;
    } else if (!((p->rF > 0.0F) && (p->rF <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_rF;
    } else if (!((p->mF >= 0.0F) && (p->mF <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_mF;
    } else if (!((p->IFxx >= 0.0F) && (p->IFxx <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0F) && (p->IFyy <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_IFyy;
    } else if (!((p->rhoR >= 0.0F) && (p->rhoR <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_rhoR;
    } else if (!((p->rhoF >= 0.0F) && (p->rhoF <= FLT_MAX))) {
        validity = WHIPPLE_TYRES_INVALID_rhoF;
    } else {
        const float t2 = p->rR - p->rhoR;
        const float t5 = p->rF - p->rhoF;
        if (!((t2 >= 0.0F) && (t2 <= FLT_MAX))) {
            validity = WHIPPLE_TYRES_REQUIREMENT_1;
        } else if (!((t5 >= 0.0F) && (t5 <= FLT_MAX))) {
            validity = WHIPPLE_TYRES_REQUIREMENT_2;
        } else {
            /* All requirements hold. */
        }
    }
    return validity;
}

void whipple_tyres_f32_matrices(const whipple_tyres_f32_t *p, whipple_tyres_f32_matrices_t *matrices)
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
    const float t43 = 1.0F / p->w;
    const float yaw_per_v_delta = cos_lam * t43;
    const float yaw_by_delta = p->c * yaw_per_v_delta;
    const float Sz_delta = t6 - t10;
    const float Jxz_all = Jxz_delta + p->IBxz - (t21 * p->xB) - (t35 * Sz_delta);
    const float M_12 = hx_delta + (yaw_by_delta * Jxz_all);
    const float t57 = p->mH * t36;
    const float t59 = p->mF * p->c;
    const float t62 = p->IFxx + p->IHzz;
    const float hz_delta = (sin_lam * Jxz_delta) + (cos_lam * ((t36 * t57) + (p->c * t59) + t62));
    const float t68 = t57 + t59;
    const float t70 = (sin_lam * Sz_delta) + (cos_lam * t68);
    const float M_yaw_delta = hz_delta - (t35 * t70);
    const float t74 = p->mB * p->xB;
    const float t85 = yaw_by_delta * (p->IRxx + t62 + p->IBzz + (p->xB * t74) + (p->mH * p->xH *
        p->xH) + (p->mF * p->w * p->w));
    const float P_delta_yaw = M_yaw_delta + t85;
    const float M_22 = (yaw_by_delta * (M_yaw_delta + P_delta_yaw)) + (sin_lam * hx_delta) +
        (cos_lam * hz_delta);
    const float h_spin_F = p->IFyy / p->rF;
    const float h_wheels_all = h_spin_F + (p->IRyy / p->rR);
    const float Sz_all = t21 + Sz_delta - t17;
    const float t101 = h_wheels_all - Sz_all;
    const float t104 = cos_lam * h_spin_F;
    const float C1_12 = (yaw_by_delta * t101) + (yaw_per_v_delta * Jxz_all) + t104;
    const float m_delta = p->mH + p->mF;
    const float Sx_all = t74 + (t35 * m_delta) - t68;
    const float P_delta_lateral = (yaw_by_delta * Sx_all) - t70;
    const float C1_22 = (yaw_by_delta * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
    const float t119 = t43 * Sx_all;
    const float K0_11 = Sz_all + (p->rhoF * t119) + (p->rhoR * (p->mR + p->mB + m_delta - t119));
    const float K_phi_delta = t70 + (t119 * ((sin_lam * p->rhoF) - (p->c * cos_lam)));
    const float K0_22 = sin_lam * K_phi_delta;
    const float K2_12 = yaw_per_v_delta * t101;
    const float K2_22 = yaw_per_v_delta * (P_delta_lateral + (sin_lam * h_spin_F));
    const float C1_21 = -(t104 + (yaw_by_delta * h_wheels_all));
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K_phi_delta;
    matrices->k0[1][0] = K_phi_delta;
    matrices->k0[1][1] = K0_22;
    matrices->k2[0][0] = 0.0F;
    matrices->k2[0][1] = K2_12;
    matrices->k2[1][0] = 0.0F;
    matrices->k2[1][1] = K2_22;
}

carvallo_system_error_t whipple_tyres_f32_at_speed(const whipple_tyres_f32_matrices_t *matrices,
    float speed, float gravity, whipple_tyres_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed) && carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < WHIPPLE_TYRES_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_TYRES_N; column++) {
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

carvallo_system_error_t whipple_tyres_f32_state_space(const whipple_tyres_f32_system_t *system,
    whipple_tyres_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[WHIPPLE_TYRES_N * WHIPPLE_TYRES_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * WHIPPLE_TYRES_N * WHIPPLE_TYRES_N];
    for (size_t row = 0U; row < WHIPPLE_TYRES_N; row++) {
        float *const solved = &x[3U * WHIPPLE_TYRES_N * row];
        for (size_t column = 0U; column < WHIPPLE_TYRES_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * WHIPPLE_TYRES_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHIPPLE_TYRES_N + column] = -system->c[row][column];
            solved[(2U * WHIPPLE_TYRES_N) + column] = 0.0F;
        }
        solved[(2U * WHIPPLE_TYRES_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[WHIPPLE_TYRES_N * WHIPPLE_TYRES_N];
        error = carvallo_solve_f32(WHIPPLE_TYRES_N, m, terms, 3U * WHIPPLE_TYRES_N, x);
    }
    for (size_t row = 0U; row < (2U * WHIPPLE_TYRES_N); row++) {
        for (size_t column = 0U; column < (2U * WHIPPLE_TYRES_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < WHIPPLE_TYRES_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHIPPLE_TYRES_N; row++) {
            const size_t target = WHIPPLE_TYRES_N + row;
            for (size_t column = 0U; column < (2U * WHIPPLE_TYRES_N); column++) {
                space->a[target][column] = x[(3U * WHIPPLE_TYRES_N * row) + column];
            }
            for (size_t column = 0U; column < WHIPPLE_TYRES_N; column++) {
                space->b[target][column] = x[(3U * WHIPPLE_TYRES_N * row) + (2U * WHIPPLE_TYRES_N) +
                    column];
            }
            space->a[row][WHIPPLE_TYRES_N + row] = 1.0F;
        }
    }
    return error;
}

float whipple_tyres_f32_rate_at(const whipple_tyres_f32_rate_t *rate, float v,
    const float q[WHIPPLE_TYRES_N], const float q_dot[WHIPPLE_TYRES_N], float psi)
{
    float by_coordinates = 0.0F;
    float by_rates = 0.0F;
    for (size_t i = 0U; i < WHIPPLE_TYRES_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void whipple_tyres_f32_kinematics(const whipple_tyres_f32_t *p, whipple_tyres_f32_kinematics_t *kinematics)
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

void whipple_tyres_f32_derivatives(const whipple_tyres_f32_t *p,
    whipple_tyres_f32_matrices_t *matrices, whipple_tyres_f32_derivatives_t *derivatives)
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
    const float t34 = p->c + p->w;
    const float t36 = t34 - p->xH;
    const float Jxz_delta = p->IHxz + (t6 * t36) - (t10 * p->c);
    const float t41 = Jxz_delta * cos_lam;
    const float hx_delta = (Jxx_delta * sin_lam) + t41;
    const float t43 = 1.0F / p->w;
    const float yaw_per_v_delta = cos_lam * t43;
    const float yaw_by_delta = p->c * yaw_per_v_delta;
    const float Sz_delta = t6 - t10;
    const float Jxz_all = Jxz_delta + p->IBxz - (t21 * p->xB) - (t34 * Sz_delta);
    const float M_12 = hx_delta + (yaw_by_delta * Jxz_all);
    const float t57 = sin_lam * Jxz_delta;
    const float t59 = p->IFxx + p->IHzz;
    const float t60 = p->mF * p->c;
    const float t62 = p->mH * t36;
    const float t65 = t59 + (p->c * t60) + (t36 * t62);
    const float hz_delta = t57 + (cos_lam * t65);
    const float t70 = t60 + t62;
    const float t72 = (sin_lam * Sz_delta) + (cos_lam * t70);
    const float M_yaw_delta = hz_delta - (t34 * t72);
    const float t76 = p->mB * p->xB;
    const float t78 = p->xH * p->xH;
    const float t80 = p->w * p->w;
    const float P_delta_yaw_yaw_by_delta = p->IRxx + t59 + p->IBzz + (p->xB * t76) + (p->mH * t78) +
        (p->mF * t80);
    const float t87 = yaw_by_delta * P_delta_yaw_yaw_by_delta;
    const float P_delta_yaw = M_yaw_delta + t87;
    const float t89 = M_yaw_delta + P_delta_yaw;
    const float M_22 = (sin_lam * hx_delta) + (cos_lam * hz_delta) + (yaw_by_delta * t89);
    const float t95 = 1.0F / p->rF;
    const float h_spin_F = p->IFyy * t95;
    const float t97 = cos_lam * h_spin_F;
    const float t99 = 1.0F / p->rR;
    const float t100 = p->IRyy * t99;
    const float h_wheels_all = h_spin_F + t100;
    const float Sz_all = t21 + Sz_delta - t17;
    const float t104 = h_wheels_all - Sz_all;
    const float t106 = yaw_per_v_delta * Jxz_all;
    const float C1_12 = t97 + (yaw_by_delta * t104) + t106;
    const float m_delta = p->mH + p->mF;
    const float Sx_all = t76 + (t34 * m_delta) - t70;
    const float t116 = yaw_by_delta * Sx_all;
    const float P_delta_lateral = t116 - t72;
    const float C1_22 = (yaw_per_v_delta * P_delta_yaw) + (yaw_by_delta * P_delta_lateral);
    const float K0_11_rhoF = t43 * Sx_all;
    const float t122 = p->rhoF * K0_11_rhoF;
    const float K0_11_rhoR = p->mR + p->mB + m_delta - K0_11_rhoF;
    const float K0_11 = Sz_all + t122 + (p->rhoR * K0_11_rhoR);
    const float t130 = p->c * cos_lam;
    const float t132 = (sin_lam * p->rhoF) - t130;
    const float K_phi_delta = t72 + (K0_11_rhoF * t132);
    const float K0_22 = sin_lam * K_phi_delta;
    const float K2_12 = yaw_per_v_delta * t104;
    const float t137 = sin_lam * h_spin_F;
    const float t138 = P_delta_lateral + t137;
    const float K2_22 = yaw_per_v_delta * t138;
    const float C1_12_h_spin_F = cos_lam + yaw_by_delta;
    const float t141 = t6 * C1_12_h_spin_F;
    const float t143 = t141 - (yaw_by_delta * Sz_delta);
    const float t144 = t43 * t43;
    const float t145 = cos_lam * t144;
    const float M_12_yaw_per_v_delta = p->c * Jxz_all;
    const float M_12_w = t143 - (t145 * M_12_yaw_per_v_delta);
    const float t149 = yaw_by_delta + yaw_by_delta;
    const float t150 = t34 * t149;
    const float t151 = cos_lam * t150;
    const float t152 = t36 * cos_lam;
    const float M_22_hz_delta = cos_lam + t149;
    const float t155 = (t152 * M_22_hz_delta) - t151;
    const float M_22_Jxz_delta = sin_lam * (cos_lam + M_22_hz_delta);
    const float t160 = cos_lam * t62;
    const float t163 = (p->mH * t155) + (t6 * M_22_Jxz_delta) + (M_22_hz_delta * t160);
    const float t165 = t163 - (t72 * t149);
    const float P_delta_yaw_w = p->mF * p->w * t149;
    const float M_22_yaw_by_delta = t87 + t89;
    const float M_22_yaw_per_v_delta = p->c * M_22_yaw_by_delta;
    const float M_22_w = t165 + (yaw_by_delta * P_delta_yaw_w) - (t145 * M_22_yaw_per_v_delta);
    const float t174 = t6 * yaw_per_v_delta;
    const float t176 = t174 - (yaw_per_v_delta * Sz_delta);
    const float C1_12_yaw_per_v_delta = Jxz_all + (p->c * t104);
    const float C1_12_w = t176 - (t145 * C1_12_yaw_per_v_delta);
    const float t181 = p->c * h_wheels_all;
    const float C1_21_w = t145 * t181;
    const float C1_22_Sx_all = yaw_by_delta * yaw_by_delta;
    const float t185 = yaw_by_delta + (t34 * yaw_per_v_delta);
    const float t187 = C1_22_Sx_all + (cos_lam * t185);
    const float t189 = (yaw_per_v_delta * t152) - t187;
    const float K2_22_h_spin_F = sin_lam * yaw_per_v_delta;
    const float t195 = (p->mH * t189) + (t6 * K2_22_h_spin_F) + (yaw_per_v_delta * t160);
    const float t199 = t195 + (m_delta * C1_22_Sx_all) - (yaw_per_v_delta * t72);
    const float C1_22_yaw_by_delta = t116 + P_delta_lateral + (yaw_per_v_delta *
        P_delta_yaw_yaw_by_delta);
    const float C1_22_yaw_per_v_delta = P_delta_yaw + (p->c * C1_22_yaw_by_delta);
    const float C1_22_w = t199 + (yaw_per_v_delta * P_delta_yaw_w) - (t145 * C1_22_yaw_per_v_delta);
    const float t209 = p->rhoF - p->rhoR;
    const float K0_11_Sx_all = t43 * t209;
    const float K0_11_xH = p->mH * K0_11_Sx_all;
    const float t213 = Sx_all * t144;
    const float K0_11_w = (m_delta * K0_11_Sx_all) - K0_11_xH - (t209 * t213);
    const float K_phi_delta_Sx_all = t43 * t132;
    const float t218 = cos_lam - K_phi_delta_Sx_all;
    const float t219 = p->mH * t218;
    const float t221 = t219 + (m_delta * K_phi_delta_Sx_all);
    const float K_phi_delta_w = t221 - (t132 * t213);
    const float K0_22_w = sin_lam * K_phi_delta_w;
    const float t225 = t104 * t145;
    const float K2_22_Sx_all = yaw_per_v_delta * yaw_by_delta;
    const float t228 = (cos_lam * yaw_per_v_delta) + K2_22_Sx_all;
    const float K2_22_xH = p->mH * t228;
    const float t231 = (m_delta * K2_22_Sx_all) - K2_22_xH;
    const float K2_22_yaw_by_delta = yaw_per_v_delta * Sx_all;
    const float K2_22_yaw_per_v_delta = t138 + (p->c * K2_22_yaw_by_delta);
    const float K2_22_w = t231 - (t145 * K2_22_yaw_per_v_delta);
    const float M_12_c = t106 + t143 - (t10 * C1_12_h_spin_F);
    const float t242 = (t130 * M_22_hz_delta) - t151;
    const float hz_delta_c = cos_lam * t60;
    const float M_22_c = t165 + (p->mF * t242) + (yaw_per_v_delta * M_22_yaw_by_delta) +
        (M_22_hz_delta * hz_delta_c) - (t10 * M_22_Jxz_delta);
    const float C1_12_c = t176 + (yaw_per_v_delta * (t104 - t10));
    const float t254 = yaw_per_v_delta * h_wheels_all;
    const float t257 = (yaw_per_v_delta * t130) - t187;
    const float C1_22_c = t199 + (p->mF * t257) + (yaw_per_v_delta * (C1_22_yaw_by_delta +
        hz_delta_c)) - (t10 * K2_22_h_spin_F);
    const float K_phi_delta_c = t221 + (p->mF * t218) - (cos_lam * K0_11_rhoF);
    const float K0_22_c = sin_lam * K_phi_delta_c;
    const float K2_22_c = t231 + (yaw_per_v_delta * K2_22_yaw_by_delta) - (p->mF * t228);
    const float hx_delta_lam = (Jxx_delta * cos_lam) - t57;
    const float t275 = sin_lam * t43;
    const float M_12_lam = hx_delta_lam - (M_12_yaw_per_v_delta * t275);
    const float t283 = (cos_lam * Sz_delta) - (sin_lam * t70);
    const float hz_delta_lam = t41 - (sin_lam * t65);
    const float M_22_lam = (sin_lam * hx_delta_lam) + (cos_lam * hx_delta) + (M_22_hz_delta *
        hz_delta_lam) - (sin_lam * hz_delta) - (t150 * t283) - (M_22_yaw_per_v_delta * t275);
    const float t295 = t137 + (C1_12_yaw_per_v_delta * t275);
    const float C1_21_lam = t137 + (t181 * t275);
    const float C1_22_lam = (yaw_per_v_delta * hz_delta_lam) - (t185 * t283) -
        (C1_22_yaw_per_v_delta * t275);
    const float K_phi_delta_rhoF = sin_lam * K0_11_rhoF;
    const float K_phi_delta_lam = t283 + (p->c * K_phi_delta_rhoF) + (cos_lam * t122);
    const float K0_22_lam = (sin_lam * K_phi_delta_lam) + (cos_lam * K_phi_delta);
    const float t311 = t104 * t275;
    const float K2_22_lam = (yaw_per_v_delta * (t97 - t283)) - (K2_22_yaw_per_v_delta * t275);
    const float M_11_rR = t17 + t17;
    const float t317 = t99 * t100;
    const float t318 = p->mR - t317;
    const float C1_12_rR = yaw_by_delta * t318;
    const float C1_21_rR = yaw_by_delta * t317;
    const float K2_12_rR = yaw_per_v_delta * t318;
    const float M_11_mR = p->rR * p->rR;
    const float C1_12_mR = p->rR * yaw_by_delta;
    const float K0_11_mR = p->rhoR - p->rR;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float C1_12_IRyy = yaw_by_delta * t99;
    const float K2_12_IRyy = yaw_per_v_delta * t99;
    const float t329 = t21 * yaw_by_delta;
    const float t330 = yaw_by_delta * p->xB;
    const float t331 = p->mB * t330;
    const float P_delta_yaw_xB = t331 + (yaw_by_delta * t76);
    const float M_22_xB = yaw_by_delta * P_delta_yaw_xB;
    const float t335 = t21 * yaw_per_v_delta;
    const float C1_22_xB = (p->mB * C1_22_Sx_all) + (yaw_per_v_delta * P_delta_yaw_xB);
    const float K0_11_xB = p->mB * K0_11_Sx_all;
    const float K_phi_delta_xB = p->mB * K_phi_delta_Sx_all;
    const float K0_22_xB = sin_lam * K_phi_delta_xB;
    const float K2_22_xB = p->mB * K2_22_Sx_all;
    const float M_11_zB = t21 + t21;
    const float t345 = yaw_by_delta + (yaw_per_v_delta * p->xB);
    const float t346 = p->mB * t345;
    const float t347 = p->mB * yaw_per_v_delta;
    const float M_11_mB = p->zB * p->zB;
    const float t349 = p->zB * t330;
    const float P_delta_yaw_mB = p->xB * t330;
    const float M_22_mB = yaw_by_delta * P_delta_yaw_mB;
    const float t352 = p->zB * t345;
    const float C1_22_mB = (p->xB * C1_22_Sx_all) + (yaw_per_v_delta * P_delta_yaw_mB);
    const float K0_11_mB = p->zB + p->rhoR + (p->xB * K0_11_Sx_all);
    const float K_phi_delta_mB = p->xB * K_phi_delta_Sx_all;
    const float K0_22_mB = sin_lam * K_phi_delta_mB;
    const float t361 = p->zB * yaw_per_v_delta;
    const float K2_22_mB = p->xB * K2_22_Sx_all;
    const float P_delta_yaw_xH = p->mH * p->xH * t149;
    const float M_22_xH = (yaw_by_delta * P_delta_yaw_xH) - t163;
    const float C1_22_xH = (yaw_per_v_delta * P_delta_yaw_xH) - t195;
    const float t369 = sin_lam * t219;
    const float M_11_zH = t6 + t6;
    const float t371 = t34 * yaw_by_delta;
    const float t373 = p->zH * sin_lam;
    const float t375 = (t36 * C1_12_h_spin_F) + t373 - t371;
    const float M_12_zH = (p->mH * t375) + (t6 * sin_lam);
    const float t379 = sin_lam * t150;
    const float M_22_Jxx_delta = sin_lam * sin_lam;
    const float t384 = (p->zH * M_22_Jxx_delta) + (t36 * M_22_Jxz_delta) - t379;
    const float M_22_zH = (p->mH * t384) + (t6 * M_22_Jxx_delta);
    const float t389 = (t36 * yaw_per_v_delta) - t185;
    const float C1_12_zH = p->mH * t389;
    const float t391 = sin_lam * t185;
    const float t393 = (t36 * K2_22_h_spin_F) - t391;
    const float C1_22_zH = p->mH * t393;
    const float K_phi_delta_zH = p->mH * sin_lam;
    const float K0_22_zH = sin_lam * K_phi_delta_zH;
    const float t397 = p->mH * yaw_per_v_delta;
    const float t398 = p->mH * K2_22_h_spin_F;
    const float M_11_mH = p->zH * p->zH;
    const float M_12_mH = p->zH * t375;
    const float P_delta_yaw_mH = yaw_by_delta * t78;
    const float M_22_mH = (p->zH * t384) + (t36 * t155) + (yaw_by_delta * P_delta_yaw_mH);
    const float C1_12_mH = p->zH * t389;
    const float C1_22_m_delta = t34 * C1_22_Sx_all;
    const float C1_22_mH = C1_22_m_delta + (p->zH * t393) + (t36 * t189) + (yaw_per_v_delta *
        P_delta_yaw_mH);
    const float K0_11_m_delta = p->rhoR + (t34 * K0_11_Sx_all);
    const float K0_11_mH = p->zH + K0_11_m_delta - (t36 * K0_11_Sx_all);
    const float K_phi_delta_m_delta = t34 * K_phi_delta_Sx_all;
    const float K_phi_delta_mH = t373 + K_phi_delta_m_delta + (t36 * t218);
    const float K0_22_mH = sin_lam * K_phi_delta_mH;
    const float t425 = p->zH * yaw_per_v_delta;
    const float K2_22_m_delta = t34 * K2_22_Sx_all;
    const float K2_22_mH = K2_22_m_delta - (p->zH * K2_22_h_spin_F) - (t36 * t228);
    const float M_22_IHzz = C1_22_Sx_all + (cos_lam * M_22_hz_delta);
    const float C1_22_IHzz = yaw_per_v_delta * C1_12_h_spin_F;
    const float M_11_rF = t10 + t10;
    const float t436 = p->rF * sin_lam;
    const float t438 = t371 + t436 - (p->c * C1_12_h_spin_F);
    const float M_12_rF = (p->mF * t438) + (t10 * sin_lam);
    const float t445 = t379 + (p->rF * M_22_Jxx_delta) - (p->c * M_22_Jxz_delta);
    const float M_22_rF = (p->mF * t445) + (t10 * M_22_Jxx_delta);
    const float t449 = t185 - yaw_by_delta;
    const float t451 = t95 * h_spin_F;
    const float C1_21_rF = C1_12_h_spin_F * t451;
    const float C1_12_rF = (p->mF * t449) - C1_21_rF;
    const float t455 = t391 - (p->c * K2_22_h_spin_F);
    const float C1_22_rF = p->mF * t455;
    const float t457 = p->mF * sin_lam;
    const float t458 = sin_lam * t457;
    const float K2_12_rF = (p->mF * yaw_per_v_delta) - (yaw_per_v_delta * t451);
    const float K2_22_rF = (p->mF * K2_22_h_spin_F) - (K2_22_h_spin_F * t451);
    const float M_11_mF = p->rF * p->rF;
    const float M_12_mF = p->rF * t438;
    const float P_delta_yaw_mF = yaw_by_delta * t80;
    const float M_22_mF = (p->c * t242) + (p->rF * t445) + (yaw_by_delta * P_delta_yaw_mF);
    const float C1_12_mF = p->rF * t449;
    const float C1_22_mF = C1_22_m_delta + (p->c * t257) + (p->rF * t455) + (yaw_per_v_delta *
        P_delta_yaw_mF);
    const float K0_11_mF = K0_11_m_delta - p->rF - (p->c * K0_11_Sx_all);
    const float K_phi_delta_mF = K_phi_delta_m_delta + (p->c * t218) - t436;
    const float K0_22_mF = sin_lam * K_phi_delta_mF;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float K2_22_mF = K2_22_m_delta + (p->rF * K2_22_h_spin_F) - (p->c * t228);
    const float M_22_IFxx = M_22_Jxx_delta + M_22_IHzz;
    const float C1_12_IFyy = t95 * C1_12_h_spin_F;
    const float K2_12_IFyy = yaw_per_v_delta * t95;
    const float K2_22_IFyy = t95 * K2_22_h_spin_F;
    const float K0_22_rhoF = sin_lam * K_phi_delta_rhoF;
    const float C1_21 = -(t97 + (yaw_by_delta * h_wheels_all));
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K_phi_delta;
    matrices->k0[1][0] = K_phi_delta;
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
    derivatives->values[5] = K0_11_w;
    derivatives->values[6] = K_phi_delta_w;
    derivatives->values[7] = K0_22_w;
    derivatives->values[8] = t225;
    derivatives->values[9] = K2_22_w;
    derivatives->values[10] = M_12_c;
    derivatives->values[11] = M_22_c;
    derivatives->values[12] = C1_12_c;
    derivatives->values[13] = t254;
    derivatives->values[14] = C1_22_c;
    derivatives->values[15] = K_phi_delta_c;
    derivatives->values[16] = K0_22_c;
    derivatives->values[17] = K2_22_c;
    derivatives->values[18] = M_12_lam;
    derivatives->values[19] = M_22_lam;
    derivatives->values[20] = t295;
    derivatives->values[21] = C1_21_lam;
    derivatives->values[22] = C1_22_lam;
    derivatives->values[23] = K_phi_delta_lam;
    derivatives->values[24] = K0_22_lam;
    derivatives->values[25] = t311;
    derivatives->values[26] = K2_22_lam;
    derivatives->values[27] = M_11_rR;
    derivatives->values[28] = C1_12_rR;
    derivatives->values[29] = C1_21_rR;
    derivatives->values[30] = p->mR;
    derivatives->values[31] = K2_12_rR;
    derivatives->values[32] = M_11_mR;
    derivatives->values[33] = C1_12_mR;
    derivatives->values[34] = K0_11_mR;
    derivatives->values[35] = K2_12_mR;
    derivatives->values[36] = 1.0F;
    derivatives->values[37] = C1_22_Sx_all;
    derivatives->values[38] = K2_22_Sx_all;
    derivatives->values[39] = C1_12_IRyy;
    derivatives->values[40] = K2_12_IRyy;
    derivatives->values[41] = t329;
    derivatives->values[42] = M_22_xB;
    derivatives->values[43] = t335;
    derivatives->values[44] = C1_22_xB;
    derivatives->values[45] = K0_11_xB;
    derivatives->values[46] = K_phi_delta_xB;
    derivatives->values[47] = K0_22_xB;
    derivatives->values[48] = K2_22_xB;
    derivatives->values[49] = M_11_zB;
    derivatives->values[50] = t331;
    derivatives->values[51] = t346;
    derivatives->values[52] = p->mB;
    derivatives->values[53] = t347;
    derivatives->values[54] = M_11_mB;
    derivatives->values[55] = t349;
    derivatives->values[56] = M_22_mB;
    derivatives->values[57] = t352;
    derivatives->values[58] = C1_22_mB;
    derivatives->values[59] = K0_11_mB;
    derivatives->values[60] = K_phi_delta_mB;
    derivatives->values[61] = K0_22_mB;
    derivatives->values[62] = t361;
    derivatives->values[63] = K2_22_mB;
    derivatives->values[64] = yaw_by_delta;
    derivatives->values[65] = yaw_per_v_delta;
    derivatives->values[66] = t141;
    derivatives->values[67] = M_22_xH;
    derivatives->values[68] = t174;
    derivatives->values[69] = C1_22_xH;
    derivatives->values[70] = K0_11_xH;
    derivatives->values[71] = t219;
    derivatives->values[72] = t369;
    derivatives->values[73] = K2_22_xH;
    derivatives->values[74] = M_11_zH;
    derivatives->values[75] = M_12_zH;
    derivatives->values[76] = M_22_zH;
    derivatives->values[77] = C1_12_zH;
    derivatives->values[78] = C1_22_zH;
    derivatives->values[79] = p->mH;
    derivatives->values[80] = K_phi_delta_zH;
    derivatives->values[81] = K0_22_zH;
    derivatives->values[82] = t397;
    derivatives->values[83] = t398;
    derivatives->values[84] = M_11_mH;
    derivatives->values[85] = M_12_mH;
    derivatives->values[86] = M_22_mH;
    derivatives->values[87] = C1_12_mH;
    derivatives->values[88] = C1_22_mH;
    derivatives->values[89] = K0_11_mH;
    derivatives->values[90] = K_phi_delta_mH;
    derivatives->values[91] = K0_22_mH;
    derivatives->values[92] = t425;
    derivatives->values[93] = K2_22_mH;
    derivatives->values[94] = sin_lam;
    derivatives->values[95] = M_22_Jxx_delta;
    derivatives->values[96] = M_22_IHzz;
    derivatives->values[97] = C1_22_IHzz;
    derivatives->values[98] = C1_12_h_spin_F;
    derivatives->values[99] = M_22_Jxz_delta;
    derivatives->values[100] = K2_22_h_spin_F;
    derivatives->values[101] = M_11_rF;
    derivatives->values[102] = M_12_rF;
    derivatives->values[103] = M_22_rF;
    derivatives->values[104] = C1_12_rF;
    derivatives->values[105] = C1_21_rF;
    derivatives->values[106] = C1_22_rF;
    derivatives->values[107] = p->mF;
    derivatives->values[108] = t457;
    derivatives->values[109] = t458;
    derivatives->values[110] = K2_12_rF;
    derivatives->values[111] = K2_22_rF;
    derivatives->values[112] = M_11_mF;
    derivatives->values[113] = M_12_mF;
    derivatives->values[114] = M_22_mF;
    derivatives->values[115] = C1_12_mF;
    derivatives->values[116] = C1_22_mF;
    derivatives->values[117] = K0_11_mF;
    derivatives->values[118] = K_phi_delta_mF;
    derivatives->values[119] = K0_22_mF;
    derivatives->values[120] = K2_12_mF;
    derivatives->values[121] = K2_22_mF;
    derivatives->values[122] = M_22_IFxx;
    derivatives->values[123] = C1_12_IFyy;
    derivatives->values[124] = K2_12_IFyy;
    derivatives->values[125] = K2_22_IFyy;
    derivatives->values[126] = K0_11_rhoR;
    derivatives->values[127] = K0_11_rhoF;
    derivatives->values[128] = K_phi_delta_rhoF;
    derivatives->values[129] = K0_22_rhoF;
}

void whipple_tyres_f32_with_respect_to(const whipple_tyres_f32_derivatives_t *derivatives,
    size_t parameter, whipple_tyres_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHIPPLE_TYRES_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_TYRES_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
            matrices->k2[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < WHIPPLE_TYRES_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &whipple_tyres_partials[position];
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
