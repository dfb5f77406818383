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
#include <math.h>

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
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 44U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 44U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 54U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 43U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 52U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 71U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 0U, 15U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 62U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 62U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 68U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 31U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 53U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 45U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 45U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 55U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 30U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 51U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 61U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 37U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 37U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 38U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 39U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 82U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 82U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 69U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 50U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 63U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 83U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 97U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 97U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 107U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 27U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 96U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 8U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 4U, 73U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 4U, 77U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 0U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 4U, 74U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 9U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 79U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 10U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 5U, 78U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 4U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 81U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 6U, 80U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 7U, 76U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 7U, 76U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 7U, 75U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 8U, 28U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 8U, 28U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 8U, 49U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 8U, 87U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 8U, 89U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 8U, 16U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 8U, 91U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 8U, 91U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 8U, 92U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 88U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 11U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 35U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 35U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 9U, 90U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 1U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 9U, 86U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 7U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 10U, 33U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 10U, 33U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 10U, 34U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 10U, 94U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 10U, 85U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 10U, 17U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 10U, 95U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 10U, 95U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 10U, 98U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 10U, 93U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 10U, 84U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 11U, 4U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 13U, 81U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 13U, 80U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 14U, 26U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 14U, 26U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 14U, 21U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 15U, 32U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 15U, 32U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 102U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 24U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 106U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 15U, 18U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 100U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 100U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 99U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 58U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 14U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 46U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 46U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 72U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 56U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 60U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 2U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 67U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 67U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 109U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 57U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 59U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 6U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 40U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 40U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 41U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 112U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 48U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 19U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 101U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 101U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 104U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 111U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 47U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 18U, 4U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 18U, 5U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 18U, 5U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 18U, 108U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 20U, 113U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 20U, 105U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 21U, 29U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 21U, 29U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 21U, 103U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 21U, 21U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 21U, 64U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 22U, 12U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 22U, 42U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 22U, 42U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 70U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 22U, 119U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 22U, 116U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 22U, 120U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 22U, 3U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 22U, 20U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 22U, 20U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 22U, 110U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 118U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 22U, 129U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 23U, 121U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 123U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 123U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 122U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 125U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 126U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 13U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 127U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 127U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 128U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 124U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 65U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 4U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 5U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 5U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 114U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 105U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 115U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 115U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 117U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 66U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 26U, 36U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 27U, 22U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 27U, 23U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 27U, 23U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 27U, 25U, false}
};

const char *whipple_tyres_position_name(whipple_tyres_position_t which)
{
    static const char *const TEXTS[] = {
        "x",
        "y",
        "psi",
        "phi",
        "pitch",
        "delta",
        "thetaR",
        "thetaF",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such position";
}

const char *whipple_tyres_speed_name(whipple_tyres_speed_t which)
{
    static const char *const TEXTS[] = {
        "phi",
        "delta",
        "thetaR",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such speed";
}

const char *whipple_tyres_force_name(whipple_tyres_force_t which)
{
    static const char *const TEXTS[] = {
        "Tphi",
        "Tdelta",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such force";
}

const char *whipple_tyres_wheel_name(whipple_tyres_wheel_t which)
{
    static const char *const TEXTS[] = {
        "R",
        "F",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such wheel";
}

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
    const double t2 = p->zH * p->mH;
    const double t7 = p->rR * p->mR;
    const double K_phi_phi_ = (p->zH * t2) + (p->IBxx + (p->rR * t7));
    const double t14 = p->zB * p->mB;
    const double t20 = p->rF * p->mF;
    const double t23 = p->IHxx + (p->IFxx + (p->rF * t20));
    const double M_11 = K_phi_phi_ + (p->IRxx + ((p->zB * t14) + t23));
    double wx_delta2_delta = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &wx_delta2_delta, &cos_lam);
    const double t31 = p->w + p->c;
    const double t36 = 1.0 / p->w;
    const double yaw_per_v_delta = cos_lam * t36;
    const double yaw_by_delta = p->c * yaw_per_v_delta;
    const double wz_delta2_delta = cos_lam + yaw_by_delta;
    const double t42 = (p->xH * wz_delta2_delta) - (p->zH * wx_delta2_delta) - (cos_lam * t31);
    const double t47 = (t14 * p->xB) - p->IBxz;
    const double t50 = wz_delta2_delta * p->IHxz;
    const double t52 = t50 + (t23 * wx_delta2_delta);
    const double M_12 = t52 - (yaw_by_delta * t47) - (t2 * t42);
    const double t57 = wz_delta2_delta * (p->IFxx + p->IHzz);
    const double t59 = p->mB * p->xB;
    const double t64 = yaw_by_delta * (p->IRxx + (p->xB * t59) + p->IBzz);
    const double t67 = p->mH * t42;
    const double M_22 = (wz_delta2_delta * t57) + (yaw_by_delta * t64) + (t42 * t67) +
        (wx_delta2_delta * (t50 + t52));
    const double ay_all1_delta = p->mH * p->xH;
    const double t77 = t7 - t2 - t14;
    const double h_spin_R = p->IRyy / p->rR;
    const double h_spin_F = p->IFyy / p->rF;
    const double h_wheels_all = h_spin_R + h_spin_F;
    const double t83 = t77 + h_wheels_all;
    const double vy_delta2_delta = t20 * t31;
    const double t88 = p->IHxz + vy_delta2_delta;
    const double t91 = cos_lam * h_spin_F;
    const double t97 = t67 + (yaw_by_delta * t59);
    const double C1_22 = yaw_per_v_delta * (t57 + (t64 + (wx_delta2_delta * t88) + (p->c * t97) +
        (p->xH * t67)));
    const double t107 = t36 * (ay_all1_delta + t59);
    const double t114 = ((p->mF + t107) * p->rhoF) - t20;
    const double K0_12 = (wx_delta2_delta * t114) - t97;
    const double K0_22 = wx_delta2_delta * K0_12;
    const double vy_all1_delta = t20 + t83;
    const double K2_12 = yaw_per_v_delta * vy_all1_delta;
    const double K2_22 = yaw_per_v_delta * (t97 + (wx_delta2_delta * (t20 + h_spin_F)));
    const double C1_12 = t91 - (yaw_per_v_delta * ((p->zH * ay_all1_delta) + (t47 - (p->c * t83)) -
        t88));
    const double C1_21 = -((yaw_by_delta * h_wheels_all) + t91);
    const double K0_11 = ((p->mB + (p->mH + p->mR) - t107) * p->rhoR) + t114 - t77;
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
    double wx_delta2_delta = 0.0;
    double wx_delta2_delta_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const double t29 = p->rR * p->mR;
    const double t30 = p->rF * p->mF;
    const double C1_22_wz_delta2_delta = p->rF * t30;
    const double t33 = p->IFxx + p->IHxx + C1_22_wz_delta2_delta;
    const double M_11_mH = p->zH * p->zH;
    const double M_11_mB = p->zB * p->zB;
    const double M_11_rR = t29 + t29;
    const double M_11_mR = p->rR * p->rR;
    const double M_11 = (p->rR * t29) + p->IRxx + p->IBxx + t33 + (p->mH * M_11_mH) + (p->mB *
        M_11_mB);
    const double t46 = p->mB * p->zB;
    const double t48 = p->IBxz - (t46 * p->xB);
    const double K0_11_mR = p->rhoR - p->rR;
    const double M_11_zB = t46 + t46;
    const double M_11_rF = t30 + t30;
    const double K0_11_mF = p->rhoF - p->rF;
    const double t53 = 1.0 / p->w;
    const double t54 = p->mH * p->zH;
    const double t57 = t29 + t30 - t46 - t54;
    const double M_11_zH = t54 + t54;
    const double t59 = p->c + p->w;
    const double t60 = p->IFxx + p->IHzz;
    const double ay_all1_delta = p->mH * p->xH;
    const double t62 = p->c * t53;
    const double t63 = p->mB * p->xB;
    const double t64 = t48 + p->IHxz;
    const double t66 = t64 - (t54 * p->xH);
    const double t67 = 1.0 / p->rF;
    const double t68 = 1.0 / p->rR;
    const double t69 = t30 * t59;
    const double t71 = t53 * (ay_all1_delta + t63);
    const double h_spin_F = p->IFyy * t67;
    const double t73 = p->IRyy * t68;
    const double t74 = p->c + p->xH;
    const double t76 = t53 * (p->rhoF - p->rhoR);
    const double t77 = p->xB + p->c;
    const double t78 = t71 * t76;
    const double K0_11_xB = p->mB * t76;
    const double K0_11_mB = p->zB + p->rhoR + (p->xB * t76);
    const double K0_11_xH = p->mH * t76;
    const double K0_11_mH = p->zH + p->rhoR + (p->xH * t76);
    const double t87 = p->mF * wx_delta2_delta;
    const double yaw_per_v_delta = wx_delta2_delta_lam * t53;
    const double t89 = p->zH * wx_delta2_delta;
    const double t90 = p->IHxz * wx_delta2_delta;
    const double h_wheels_all = h_spin_F + t73;
    const double t92 = wx_delta2_delta_lam * h_spin_F;
    const double vy_all1_delta = h_wheels_all + t57;
    const double t94 = t53 * wx_delta2_delta;
    const double K0_11_rhoF = p->mF + t71;
    const double t96 = p->rhoF * K0_11_rhoF;
    const double K0_12_rhoF = wx_delta2_delta * K0_11_rhoF;
    const double t98 = yaw_per_v_delta * t54;
    const double K0_22_rhoF = wx_delta2_delta * K0_12_rhoF;
    const double t100 = p->rhoF * K0_12_rhoF;
    const double yaw_by_delta = p->c * yaw_per_v_delta;
    const double t103 = t89 + (wx_delta2_delta_lam * t59);
    const double t104 = vy_all1_delta * t94;
    const double t108 = yaw_per_v_delta * (p->IRxx + p->IBzz + (p->xB * t63));
    const double t109 = t46 * yaw_by_delta;
    const double C1_21 = -(t92 + (yaw_by_delta * h_wheels_all));
    const double wz_delta2_delta = wx_delta2_delta_lam + yaw_by_delta;
    const double t117 = (t30 * p->w) + t66 + (p->c * vy_all1_delta);
    const double K2_12 = yaw_per_v_delta * vy_all1_delta;
    const double t119 = t53 * K2_12;
    const double t120 = yaw_per_v_delta * t66;
    const double t121 = wz_delta2_delta * t54;
    const double t123 = t103 - (wz_delta2_delta * p->xH);
    const double t124 = p->xB * yaw_by_delta;
    const double t125 = p->zB * t124;
    const double M_22_mB = t124 * t124;
    const double t127 = p->mB * t124;
    const double t128 = p->mH - t71;
    const double K0_11_rhoR = p->mR + p->mB + t128;
    const double K0_12_c = wx_delta2_delta_lam * t128;
    const double K0_22_c = wx_delta2_delta * K0_12_c;
    const double t133 = yaw_per_v_delta * K0_12_c;
    const double t134 = yaw_per_v_delta * t117;
    const double t135 = t30 * wx_delta2_delta;
    const double K0_11 = t96 + (p->rhoR * K0_11_rhoR) - t57;
    const double t139 = t30 * wx_delta2_delta_lam;
    const double M_12_mH = p->zH * t123;
    const double M_22_mH = t123 * t123;
    const double M_12_rF = t135 + t135;
    const double C1_12 = t134 + t92;
    const double t145 = t53 * (t134 - t139);
    const double t150 = (p->IHxz * wz_delta2_delta) + (t33 * wx_delta2_delta) + (t54 * t123);
    const double t151 = wx_delta2_delta_lam * t54;
    const double M_12_w = t151 - (t62 * t120);
    const double M_12_c = t120 + t151;
    const double t158 = (wz_delta2_delta * t60) + t90 - (t123 * ay_all1_delta);
    const double t159 = yaw_per_v_delta * t60;
    const double t160 = p->mH * t123;
    const double M_12_zH = t160 + (p->mH * t89);
    const double t163 = yaw_per_v_delta * t123;
    const double t164 = t74 * t163;
    const double t165 = t160 - t127;
    const double t166 = t135 - t165;
    const double M_12 = (t48 * yaw_by_delta) + t150;
    const double K0_12 = t100 - t166;
    const double t170 = t166 - t100;
    const double t172 = t158 + (p->c * t108);
    const double t174 = t108 + t127 + t159;
    const double t175 = yaw_by_delta * t127;
    const double M_22_xB = t175 + t175;
    const double t177 = wx_delta2_delta * h_spin_F;
    const double t179 = t177 + (t117 * t94);
    const double t180 = t166 + t177;
    const double K2_22 = yaw_per_v_delta * t180;
    const double t182 = t53 * t180;
    const double K0_22 = -(wx_delta2_delta * t170);
    const double t185 = wx_delta2_delta_lam + wx_delta2_delta_lam;
    const double t186 = yaw_per_v_delta * h_wheels_all;
    const double C1_21_w = t62 * t186;
    const double t191 = t158 + (t59 * t160) + (t62 * t172);
    const double t192 = t53 * t172;
    const double t193 = p->mH * wx_delta2_delta_lam;
    const double t197 = yaw_per_v_delta * (t193 + t182 + (yaw_by_delta * t71));
    const double t200 = t185 * ((t62 * t192) - t160);
    const double M_22_c = t185 * (t160 + t192);
    const double t206 = (t69 * t94) + t192 - (t62 * t165);
    const double t207 = t74 * t193;
    const double t208 = t135 - t207;
    const double t209 = t53 * t207;
    const double t210 = t53 * t193;
    const double K2_22_xH = wz_delta2_delta * t210;
    const double t212 = wx_delta2_delta * t210;
    const double t213 = wx_delta2_delta * t209;
    const double t214 = p->xH * t209;
    const double C1_22_c = yaw_per_v_delta * (t208 + t174 + t214 - t165);
    const double M_22 = (wx_delta2_delta_lam * t191) + (wx_delta2_delta * t150);
    const double t223 = yaw_by_delta - (t94 * p->rhoF);
    const double K0_12_w = t193 + (t71 * t223);
    const double t226 = p->c * t94;
    const double C1_21_lam = t177 + (h_wheels_all * t226);
    const double C1_22 = wx_delta2_delta_lam * t206;
    const double t231 = t206 + (t62 * t174);
    const double K2_22_h_spin_F = wx_delta2_delta_lam * t94;
    const double K2_22_mF = p->rF * K2_22_h_spin_F;
    const double K2_22_IFyy = t67 * K2_22_h_spin_F;
    const double K0_12_zH = p->mH * wx_delta2_delta;
    const double t240 = t151 + (ay_all1_delta * (wx_delta2_delta + t226)) - (t59 * K0_12_zH);
    const double K0_22_w = wx_delta2_delta * K0_12_w;
    const double t242 = wx_delta2_delta + wx_delta2_delta;
    const double M_22_lam = (t150 * t185) - (t191 * t242);
    const double M_22_rF = t135 * t242;
    const double C1_22_w = yaw_per_v_delta * (t208 - t231 - (t62 * t214));
    const double M_22_zH = t160 * t242;
    const double t253 = p->mR - (t68 * t73);
    const double C1_12_rR = yaw_by_delta * t253;
    const double K2_12_rR = yaw_per_v_delta * t253;
    const double K2_12_IRyy = yaw_per_v_delta * t68;
    const double C1_12_IRyy = p->c * K2_12_IRyy;
    const double C1_21_rR = t73 * C1_12_IRyy;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double C1_12_mR = p->c * K2_12_mR;
    const double C1_22_IRxx = yaw_per_v_delta * yaw_by_delta;
    const double M_22_IRxx = p->c * C1_22_IRxx;
    const double M_12_lam = (t33 * wx_delta2_delta_lam) + (p->zH * t240) - t90 - (t64 * t226);
    const double M_22_yaw_by_delta = (wx_delta2_delta_lam * (p->IHxz + t69)) - (t74 * t240);
    const double C1_22_lam = (yaw_per_v_delta * M_22_yaw_by_delta) - (wx_delta2_delta * (t159 +
        t231));
    const double t279 = t240 + (t63 * t226) - t139;
    const double K2_22_mB = p->xB * C1_22_IRxx;
    const double C1_22_mB = t77 * K2_22_mB;
    const double t282 = p->mB * yaw_per_v_delta;
    const double t283 = p->zB * t282;
    const double K2_22_xB = yaw_by_delta * t282;
    const double C1_22_xB = (p->xB + t77) * K2_22_xB;
    const double t287 = t282 * t77;
    const double t288 = p->mB * t223;
    const double t289 = wx_delta2_delta * t288;
    const double t290 = p->zB * yaw_per_v_delta;
    const double t291 = t77 * t290;
    const double t292 = p->xB * t223;
    const double K2_22_lam = (yaw_per_v_delta * (t92 - t279)) - (wx_delta2_delta * t182);
    const double K0_12_lam = (wx_delta2_delta_lam * t96) + t279;
    const double t299 = wx_delta2_delta * t292;
    const double t300 = wx_delta2_delta_lam + t223;
    const double t301 = K0_12_zH * t300;
    const double t302 = p->mH * t300;
    const double K0_12_mH = t103 - (p->xH * t300);
    const double t305 = wz_delta2_delta + wz_delta2_delta;
    const double t306 = t160 * t305;
    const double M_22_IHxz = wx_delta2_delta * t305;
    const double K0_22_mH = wx_delta2_delta * K0_12_mH;
    const double C1_22_IHzz = yaw_per_v_delta * wz_delta2_delta;
    const double C1_22_yaw_by_delta = t74 * C1_22_IHzz;
    const double C1_22_xH = p->mH * (C1_22_yaw_by_delta - t163);
    const double K2_22_yaw_by_delta = wx_delta2_delta * K0_12_lam;
    const double K0_22_lam = K2_22_yaw_by_delta - (wx_delta2_delta_lam * t170);
    const double M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const double K0_22_zH = p->mH * M_22_IHxx;
    const double t318 = p->mF * M_22_IHxx;
    const double t319 = p->zH * yaw_per_v_delta;
    const double t320 = t74 * t319;
    const double M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double C1_12_IFyy = wz_delta2_delta * t67;
    const double C1_21_rF = h_spin_F * C1_12_IFyy;
    const double K2_12_IFyy = yaw_per_v_delta * t67;
    const double t326 = p->mF * yaw_per_v_delta;
    const double K2_12_rF = t326 - (h_spin_F * K2_12_IFyy);
    const double t329 = t59 * t326;
    const double C1_12_rF = t329 - C1_21_rF;
    const double C1_22_rF = wx_delta2_delta * t329;
    const double M_11_mF = p->rF * p->rF;
    const double M_22_mF = M_22_IHxx * M_11_mF;
    const double M_12_mF = wx_delta2_delta * M_11_mF;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double C1_12_mF = t59 * K2_12_mF;
    const double C1_22_mF = wx_delta2_delta * C1_12_mF;
    const double t339 = wx_delta2_delta * (p->rF - p->rhoF);
    const double t340 = wx_delta2_delta * t339;
    const double t342 = -(wx_delta2_delta * K2_12_rF);
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
    derivatives->values[0] = p->mR;
    derivatives->values[1] = p->mB;
    derivatives->values[2] = p->mH;
    derivatives->values[3] = p->mF;
    derivatives->values[4] = 1.0;
    derivatives->values[5] = wx_delta2_delta;
    derivatives->values[6] = M_11_mH;
    derivatives->values[7] = M_11_mB;
    derivatives->values[8] = M_11_rR;
    derivatives->values[9] = M_11_mR;
    derivatives->values[10] = K0_11_mR;
    derivatives->values[11] = M_11_zB;
    derivatives->values[12] = M_11_rF;
    derivatives->values[13] = K0_11_mF;
    derivatives->values[14] = M_11_zH;
    derivatives->values[15] = t78;
    derivatives->values[16] = K0_11_xB;
    derivatives->values[17] = K0_11_mB;
    derivatives->values[18] = K0_11_xH;
    derivatives->values[19] = K0_11_mH;
    derivatives->values[20] = t87;
    derivatives->values[21] = yaw_per_v_delta;
    derivatives->values[22] = K0_11_rhoF;
    derivatives->values[23] = K0_12_rhoF;
    derivatives->values[24] = t98;
    derivatives->values[25] = K0_22_rhoF;
    derivatives->values[26] = yaw_by_delta;
    derivatives->values[27] = t104;
    derivatives->values[28] = t109;
    derivatives->values[29] = wz_delta2_delta;
    derivatives->values[30] = K2_12;
    derivatives->values[31] = t119;
    derivatives->values[32] = t121;
    derivatives->values[33] = t125;
    derivatives->values[34] = M_22_mB;
    derivatives->values[35] = t127;
    derivatives->values[36] = K0_11_rhoR;
    derivatives->values[37] = K0_12_c;
    derivatives->values[38] = K0_22_c;
    derivatives->values[39] = t133;
    derivatives->values[40] = M_12_mH;
    derivatives->values[41] = M_22_mH;
    derivatives->values[42] = M_12_rF;
    derivatives->values[43] = t145;
    derivatives->values[44] = M_12_w;
    derivatives->values[45] = M_12_c;
    derivatives->values[46] = M_12_zH;
    derivatives->values[47] = t163;
    derivatives->values[48] = t164;
    derivatives->values[49] = M_22_xB;
    derivatives->values[50] = t179;
    derivatives->values[51] = t186;
    derivatives->values[52] = C1_21_w;
    derivatives->values[53] = t197;
    derivatives->values[54] = t200;
    derivatives->values[55] = M_22_c;
    derivatives->values[56] = t209;
    derivatives->values[57] = t210;
    derivatives->values[58] = K2_22_xH;
    derivatives->values[59] = t212;
    derivatives->values[60] = t213;
    derivatives->values[61] = C1_22_c;
    derivatives->values[62] = K0_12_w;
    derivatives->values[63] = C1_21_lam;
    derivatives->values[64] = K2_22_h_spin_F;
    derivatives->values[65] = K2_22_mF;
    derivatives->values[66] = K2_22_IFyy;
    derivatives->values[67] = K0_12_zH;
    derivatives->values[68] = K0_22_w;
    derivatives->values[69] = M_22_lam;
    derivatives->values[70] = M_22_rF;
    derivatives->values[71] = C1_22_w;
    derivatives->values[72] = M_22_zH;
    derivatives->values[73] = C1_12_rR;
    derivatives->values[74] = K2_12_rR;
    derivatives->values[75] = K2_12_IRyy;
    derivatives->values[76] = C1_12_IRyy;
    derivatives->values[77] = C1_21_rR;
    derivatives->values[78] = K2_12_mR;
    derivatives->values[79] = C1_12_mR;
    derivatives->values[80] = C1_22_IRxx;
    derivatives->values[81] = M_22_IRxx;
    derivatives->values[82] = M_12_lam;
    derivatives->values[83] = C1_22_lam;
    derivatives->values[84] = K2_22_mB;
    derivatives->values[85] = C1_22_mB;
    derivatives->values[86] = t282;
    derivatives->values[87] = t283;
    derivatives->values[88] = K2_22_xB;
    derivatives->values[89] = C1_22_xB;
    derivatives->values[90] = t287;
    derivatives->values[91] = t288;
    derivatives->values[92] = t289;
    derivatives->values[93] = t290;
    derivatives->values[94] = t291;
    derivatives->values[95] = t292;
    derivatives->values[96] = K2_22_lam;
    derivatives->values[97] = K0_12_lam;
    derivatives->values[98] = t299;
    derivatives->values[99] = t301;
    derivatives->values[100] = t302;
    derivatives->values[101] = K0_12_mH;
    derivatives->values[102] = t306;
    derivatives->values[103] = M_22_IHxz;
    derivatives->values[104] = K0_22_mH;
    derivatives->values[105] = C1_22_IHzz;
    derivatives->values[106] = C1_22_xH;
    derivatives->values[107] = K0_22_lam;
    derivatives->values[108] = M_22_IHxx;
    derivatives->values[109] = K0_22_zH;
    derivatives->values[110] = t318;
    derivatives->values[111] = t319;
    derivatives->values[112] = t320;
    derivatives->values[113] = M_22_IHzz;
    derivatives->values[114] = M_22_IFxx;
    derivatives->values[115] = C1_12_IFyy;
    derivatives->values[116] = C1_21_rF;
    derivatives->values[117] = K2_12_IFyy;
    derivatives->values[118] = K2_12_rF;
    derivatives->values[119] = C1_12_rF;
    derivatives->values[120] = C1_22_rF;
    derivatives->values[121] = M_11_mF;
    derivatives->values[122] = M_22_mF;
    derivatives->values[123] = M_12_mF;
    derivatives->values[124] = K2_12_mF;
    derivatives->values[125] = C1_12_mF;
    derivatives->values[126] = C1_22_mF;
    derivatives->values[127] = t339;
    derivatives->values[128] = t340;
    derivatives->values[129] = t342;
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

void whipple_tyres_f64_motion(const whipple_tyres_f64_t *p, whipple_tyres_f64_motion_t *motion)
{
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t24 = p->w + p->c;
    const double t27 = (cos_lam * t24) - (sin_lam * p->rR);
    const double t30 = (sin_lam * t24) + (cos_lam * p->rR);
    const double t31 = p->rR - p->rhoR;
    const double t32 = p->w - t24;
    const double t35 = (cos_lam * t32) + (sin_lam * p->rF);
    const double t38 = (sin_lam * t32) - (cos_lam * p->rF);
    const double t39 = p->rF - p->rhoF;
    const double t40 = t30 + t38;
    const double t42 = p->rR + p->zB;
    const double t44 = (cos_lam * p->xB) - (sin_lam * t42);
    const double t45 = p->mB * t44;
    const double t48 = (sin_lam * p->xB) + (cos_lam * t42);
    const double t49 = p->mB * t48;
    const double t51 = cos_lam * p->IBxz;
    const double t52 = (sin_lam * p->IBxx) + t51;
    const double t54 = sin_lam * p->IBxz;
    const double t56 = t54 + (cos_lam * p->IBzz);
    const double t60 = (cos_lam * t52) - (sin_lam * t56) - (t45 * t48);
    const double t62 = t48 * t49;
    const double t63 = t44 * t45;
    const double t65 = p->IByy + t62 + t63;
    const double t67 = p->mB + p->mR;
    const double t77 = t62 + p->IRxx + (cos_lam * ((cos_lam * p->IBxx) - t54)) - (sin_lam * (t51 -
        (sin_lam * p->IBzz)));
    const double t82 = t63 + p->IRxx + (sin_lam * t52) + (cos_lam * t56);
    const double t83 = p->mH + p->mF;
    const double t84 = p->xH - t24;
    const double t87 = (cos_lam * t84) - (sin_lam * p->zH);
    const double t88 = p->mH * t87;
    const double t89 = p->mF * t35;
    const double t90 = t88 + t89;
    const double t93 = (sin_lam * t84) + (cos_lam * p->zH);
    const double t94 = p->mH * t93;
    const double t95 = p->mF * t38;
    const double t96 = t94 + t95;
    const double t99 = sin_lam * p->IHxz;
    const double t102 = cos_lam * p->IHxz;
    const double t108 = (t93 * t94) + (t38 * t95);
    const double t111 = p->IFxx + (cos_lam * ((cos_lam * p->IHxx) - t99)) + t108 - (sin_lam *
        (t102 - (sin_lam * p->IHzz)));
    const double t113 = t102 + (sin_lam * p->IHxx);
    const double t116 = t99 + (cos_lam * p->IHzz);
    const double t122 = (cos_lam * t113) - (sin_lam * t116) - (t88 * t93) - (t38 * t89);
    const double t126 = (t87 * t88) + (t35 * t89);
    const double t128 = t108 + p->IHyy + t126;
    const double t133 = p->IFxx + t126 + (sin_lam * t113) + (cos_lam * t116);
    const double t135 = t111 - t128;
    const double t136 = t27 * t83;
    const double t137 = t30 * t96;
    const double t138 = t30 * t83;
    const double t141 = t137 + t137 + (t30 * t138);
    const double t142 = t27 * t96;
    const double t143 = t30 * t136;
    const double t144 = t27 * t136;
    const double t145 = t67 + t83;
    const double t147 = t49 + t96 + t138;
    motion->constants[0] = p->w;
    motion->constants[1] = p->c;
    motion->constants[2] = sin_lam;
    motion->constants[3] = cos_lam;
    motion->constants[4] = p->rR;
    motion->constants[5] = p->rF;
    motion->constants[6] = p->IBxx;
    motion->constants[7] = p->IBxz;
    motion->constants[8] = p->IBzz;
    motion->constants[9] = p->mB;
    motion->constants[10] = p->xB;
    motion->constants[11] = p->zB;
    motion->constants[12] = p->IHxx;
    motion->constants[13] = p->IHxz;
    motion->constants[14] = p->IHzz;
    motion->constants[15] = p->mH;
    motion->constants[16] = p->xH;
    motion->constants[17] = p->zH;
    motion->constants[18] = p->IRyy;
    motion->constants[19] = p->IFyy;
    motion->constants[20] = p->mF;
    motion->constants[21] = p->rhoR;
    motion->constants[22] = p->rhoF;
    motion->constants[23] = t27;
    motion->constants[24] = t30;
    motion->constants[25] = t31;
    motion->constants[26] = t35;
    motion->constants[27] = t38;
    motion->constants[28] = t39;
    motion->constants[29] = t40;
    motion->constants[30] = t45;
    motion->constants[31] = t49;
    motion->constants[32] = t60;
    motion->constants[33] = t65;
    motion->constants[34] = t67;
    motion->constants[35] = t77;
    motion->constants[36] = t82;
    motion->constants[37] = t83;
    motion->constants[38] = t90;
    motion->constants[39] = t96;
    motion->constants[40] = t111;
    motion->constants[41] = t122;
    motion->constants[42] = t128;
    motion->constants[43] = t133;
    motion->constants[44] = p->g;
    motion->constants[45] = t135;
    motion->constants[46] = t136;
    motion->constants[47] = t141;
    motion->constants[48] = t142;
    motion->constants[49] = t143;
    motion->constants[50] = t144;
    motion->constants[51] = t145;
    motion->constants[52] = t147;
}

static void whipple_tyres_f64_compute_rates(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    double rates[WHIPPLE_TYRES_POSITIONS])
{
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t5 = motion->constants[25] + (motion->constants[21] * cos_phi);
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t17 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t20 = cos_phi * t17;
    const double t24 = (sin_phi * sin_delta) - (cos_delta * t20);
    const double t28 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const double t29 = cos_phi * t28;
    const double t32 = sqrt((t24 * t24) + (t29 * t29));
    const double t33 = 1.0 / t32;
    const double t34 = t24 * t33;
    const double t36 = t29 * t33;
    const double t37 = cos_delta * t36;
    const double t39 = (t28 * t37) - (t17 * t34);
    const double t44 = ((sin_phi * cos_delta) + (t20 * sin_delta)) * motion->constants[28];
    const double t47 = sin_delta * motion->constants[26];
    const double t53 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const double t55 = (t28 * motion->constants[29]) - (t17 * t53);
    const double t58 = (cos_phi * t47) - (t39 * t44) - (sin_phi * t55);
    const double t59 = (motion->constants[25] * sin_phi) + t58;
    const double t66 = (cos_phi * sin_delta * t36) + (sin_phi * ((t28 * t34) + (t17 * t37)));
    const double t71 = (t44 * t66) + (t17 * motion->constants[29]) + (t28 * t53);
    const double t73 = 1.0 / (cos_phi * t71);
    const double t74 = t59 * t73;
    const double t80 = (t28 * motion->constants[24]) - (t17 * motion->constants[23]);
    const double t82 = t58 + (sin_phi * t80);
    const double t84 = sin_phi * t28;
    const double t88 = t71 - (t17 * motion->constants[24]) - (t28 * motion->constants[23]);
    const double t91 = t73 * ((t17 * t82) + (t84 * t88));
    const double t93 = (speeds[0] * t74) + (speeds[1] * t91);
    const double t95 = t5 * (speeds[2] + t93);
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t99 = motion->constants[21] * speeds[0];
    const double t105 = (cos_psi * t99) - (t95 * sin_psi);
    const double t106 = sin_phi * t71;
    const double t108 = sin_phi * t59;
    const double t110 = (t39 * t106) + (t66 * t108);
    const double t114 = 1.0 / ((t39 * t71) + (t59 * t66));
    const double t116 = t74 * t110 * t114;
    const double t127 = motion->constants[22] + (t32 * motion->constants[28]) + (sin_phi * t47) +
        (cos_phi * t55) - (cos_phi * t80);
    const double t129 = (t29 * t88) - (t17 * t127);
    const double t133 = (t84 * t127) + (t29 * t82);
    const double t138 = t114 * ((t39 * t129) + (t66 * t133) + (t91 * t110));
    const double t141 = t5 * t66 * t114;
    const double t147 = (t66 * t106) - (t39 * t108);
    const double t151 = (t66 * t71) - (t39 * t59);
    const double t156 = 1.0 / (motion->constants[28] + (t32 * motion->constants[22]));
    const double t173 = (speeds[0] * ((t116 * t151) - (t74 * t147)) * t156) + (speeds[1] * t156 *
        ((t39 * t133) + (t138 * t151) - (t66 * t129) - (t91 * t147)));
    const double t174 = t173 + (speeds[2] * t156 * ((t5 * t39) + (t141 * t151)));
    const double t175 = -((t95 * cos_psi) + (t99 * sin_psi));
    const double t176 = -((speeds[0] * t116) + (speeds[1] * t138) + (speeds[2] * t141));
    rates[0] = t175;
    rates[1] = t105;
    rates[2] = t176;
    rates[3] = speeds[0];
    rates[4] = t93;
    rates[5] = speeds[1];
    rates[6] = speeds[2];
    rates[7] = t174;
}

carvallo_motion_error_t whipple_tyres_f64_motion_rates(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    double rates[WHIPPLE_TYRES_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_TYRES_SPEEDS)) {
        whipple_tyres_f64_compute_rates(motion, positions, speeds, rates);
        error = (carvallo_are_finite_f64(rates, WHIPPLE_TYRES_POSITIONS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_tyres_f64_compute_derivatives(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES], double rates[WHIPPLE_TYRES_POSITIONS],
    double speed_rates[WHIPPLE_TYRES_SPEEDS])
{
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t5 = motion->constants[25] + (motion->constants[21] * cos_phi);
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t17 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t20 = cos_phi * t17;
    const double t24 = (sin_phi * sin_delta) - (cos_delta * t20);
    const double t28 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const double t29 = cos_phi * t28;
    const double t32 = sqrt((t24 * t24) + (t29 * t29));
    const double t33 = 1.0 / t32;
    const double t34 = t24 * t33;
    const double t36 = t29 * t33;
    const double t37 = cos_delta * t36;
    const double t39 = (t28 * t37) - (t17 * t34);
    const double t42 = (sin_phi * cos_delta) + (t20 * sin_delta);
    const double t44 = t42 * motion->constants[28];
    const double t47 = sin_delta * motion->constants[26];
    const double t53 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const double t55 = (t28 * motion->constants[29]) - (t17 * t53);
    const double t58 = (cos_phi * t47) - (t39 * t44) - (sin_phi * t55);
    const double t59 = (motion->constants[25] * sin_phi) + t58;
    const double t66 = (cos_phi * sin_delta * t36) + (sin_phi * ((t28 * t34) + (t17 * t37)));
    const double t71 = (t44 * t66) + (t17 * motion->constants[29]) + (t28 * t53);
    const double t73 = 1.0 / (cos_phi * t71);
    const double t74 = t59 * t73;
    const double t80 = (t28 * motion->constants[24]) - (t17 * motion->constants[23]);
    const double t82 = t58 + (sin_phi * t80);
    const double t84 = sin_phi * t28;
    const double t88 = t71 - (t17 * motion->constants[24]) - (t28 * motion->constants[23]);
    const double t91 = t73 * ((t17 * t82) + (t84 * t88));
    const double t93 = (speeds[0] * t74) + (speeds[1] * t91);
    const double t94 = speeds[2] + t93;
    const double t95 = t5 * t94;
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t99 = motion->constants[21] * speeds[0];
    const double t105 = (cos_psi * t99) - (t95 * sin_psi);
    const double t106 = sin_phi * t71;
    const double t108 = sin_phi * t59;
    const double t110 = (t39 * t106) + (t66 * t108);
    const double t114 = 1.0 / ((t39 * t71) + (t59 * t66));
    const double t116 = t74 * t110 * t114;
    const double t127 = motion->constants[22] + (t32 * motion->constants[28]) + (sin_phi * t47) +
        (cos_phi * t55) - (cos_phi * t80);
    const double t129 = (t29 * t88) - (t17 * t127);
    const double t133 = (t84 * t127) + (t29 * t82);
    const double t138 = t114 * ((t39 * t129) + (t66 * t133) + (t91 * t110));
    const double t141 = t5 * t66 * t114;
    const double t144 = (speeds[0] * t116) + (speeds[1] * t138) + (speeds[2] * t141);
    const double t147 = (t66 * t106) - (t39 * t108);
    const double t151 = (t66 * t71) - (t39 * t59);
    const double t155 = motion->constants[28] + (t32 * motion->constants[22]);
    const double t156 = 1.0 / t155;
    const double t157 = ((t116 * t151) - (t74 * t147)) * t156;
    const double t166 = t156 * ((t39 * t133) + (t138 * t151) - (t66 * t129) - (t91 * t147));
    const double t171 = t156 * ((t5 * t39) + (t141 * t151));
    const double t174 = (speeds[0] * t157) + (speeds[1] * t166) + (speeds[2] * t171);
    const double t177 = cos_phi * t144;
    const double t178 = t94 * t177;
    const double t180 = sin_phi * t144;
    const double t181 = motion->constants[25] * t180;
    const double t183 = (t177 * t181) - (t5 * t178);
    const double t186 = t183 + (sin_phi * motion->constants[44]);
    const double t191 = (speeds[0] * t17) - (t28 * t177);
    const double t192 = t93 * t191;
    const double t193 = speeds[0] * t180;
    const double t194 = t93 - t180;
    const double t195 = motion->constants[24] * t194;
    const double t199 = (speeds[0] * t28) + (t17 * t177);
    const double t200 = motion->constants[23] * t194;
    const double t202 = (t191 * t195) + (t199 * t200);
    const double t204 = t93 * t199;
    const double t205 = (t28 * t193) + t204;
    const double t208 = t192 + (t17 * t193);
    const double t212 = t202 + (motion->constants[23] * t205) + (motion->constants[24] * t208) -
        t183;
    const double t217 = (motion->constants[23] * t191) - (motion->constants[24] * t199);
    const double t219 = (t194 * t200) + (t191 * t217);
    const double t220 = speeds[0] * t177;
    const double t223 = motion->constants[21] * sin_phi;
    const double t224 = speeds[0] * t94;
    const double t227 = motion->constants[25] * speeds[0];
    const double t228 = t177 * t227;
    const double t230 = (t5 * t220) + (t223 * (t193 + t224)) + t228;
    const double t237 = (t178 * t223) + (t181 * (t94 - t180)) - (speeds[0] * t227);
    const double t241 = (t28 * t230) + (t17 * t237) - t219 - (motion->constants[24] * t220);
    const double t243 = speeds[1] + t191;
    const double t247 = (cos_delta * t194) - (sin_delta * t199);
    const double t248 = motion->constants[27] * t247;
    const double t252 = (cos_delta * t199) + (sin_delta * t194);
    const double t253 = motion->constants[26] * t247;
    const double t258 = speeds[1] * t247;
    const double t260 = t258 - (cos_delta * t208) - (sin_delta * t220);
    const double t262 = t34 * t155;
    const double t264 = t205 + (t174 * t252);
    const double t266 = t36 * t155;
    const double t268 = t260 - (t174 * t243);
    const double t274 = t33 * ((t34 * t252) + (t36 * t243)) * t44;
    const double t275 = t36 * t274;
    const double t277 = t34 * t274;
    const double t283 = (cos_delta * t212) + (t243 * t248) + (t252 * t253) +
        (motion->constants[26] * t205) + (t262 * t264) + (t243 * t275);
    const double t287 = t283 + (t252 * t277) - (sin_delta * t241) - (motion->constants[27] * t260) -
        (t266 * t268);
    const double t294 = (motion->constants[26] * t243) - (motion->constants[27] * t252);
    const double t298 = speeds[1] * t252;
    const double t300 = (sin_delta * t208) - (cos_delta * t220) - t298;
    const double t303 = t42 * motion->constants[22];
    const double t305 = t174 + t247;
    const double t310 = motion->constants[28] * ((t34 * t243) - (t36 * t252));
    const double t316 = (cos_delta * t241) + (sin_delta * t212) + (motion->constants[27] * t300) +
        (t266 * t300) - (t247 * t253) - (t243 * t294);
    const double t319 = t316 - (t264 * t303) - (t277 * t305) - (t243 * t310);
    const double t323 = (t199 * t217) - (t194 * t195);
    const double t338 = t323 + (motion->constants[23] * t220) + (t17 * t230) + (t252 * t294) +
        (t268 * t303) + (t252 * t310);
    const double t343 = t338 - (t28 * t237) - (t247 * t248) - (motion->constants[26] * t300) -
        (t262 * t300) - (t275 * t305);
    const double t345 = (t34 * t319) + (t36 * t343);
    const double t350 = t73 * ((t42 * t287) + (t32 * t345));
    const double t354 = t114 * ((t32 * t287) + (t110 * t350) - (t42 * t345));
    const double t356 = t193 - (cos_phi * t354);
    const double t358 = t192 + (t17 * t356);
    const double t362 = t204 + (t28 * t356);
    const double t369 = (t194 * motion->constants[33]) + (motion->constants[18] * (speeds[2] +
        t194));
    const double t374 = (t199 * motion->constants[35]) + (motion->constants[32] * t191);
    const double t381 = t202 + (motion->constants[23] * t362) + (motion->constants[24] * t358) -
        t186;
    const double t385 = t350 - t220 - (sin_phi * t354);
    const double t391 = (t5 * t385) - t228 - (t223 * (t224 + t356));
    const double t394 = t237 + (cos_phi * motion->constants[44]);
    const double t396 = (t17 * t394) - (t28 * t391);
    const double t398 = (motion->constants[24] * t385) + t396 - t219;
    const double t400 = (cos_delta * t381) - (sin_delta * t398);
    const double t406 = t258 + (sin_delta * t385) - (cos_delta * t358);
    const double t414 = (t247 * motion->constants[42]) + (t305 * motion->constants[19]);
    const double t419 = (t252 * motion->constants[40]) + (t243 * motion->constants[41]);
    const double t424 = (motion->constants[38] * t400) + (motion->constants[41] * t406) + (t362 *
        motion->constants[43]) + (t252 * t414) - (t247 * t419);
    const double t428 = (cos_delta * t398) + (sin_delta * t381);
    const double t434 = (cos_delta * t385) + (sin_delta * t358) - t298;
    const double t436 = t247 * motion->constants[38];
    const double t440 = (t243 * motion->constants[38]) - (t252 * motion->constants[39]);
    const double t444 = (motion->constants[37] * t428) + (motion->constants[39] * t434) - (t247 *
        t436) - (t243 * t440);
    const double t449 = t247 * motion->constants[39];
    const double t455 = (t400 * motion->constants[37]) + (t362 * motion->constants[38]) + (t243 *
        t449) + (t252 * t436) - (t406 * motion->constants[39]);
    const double t457 = (sin_delta * t444) + (cos_delta * t455);
    const double t463 = (motion->constants[36] * t362) + (t199 * t369) + t424 +
        (motion->constants[23] * t457) - (motion->constants[30] * t186) - (motion->constants[32] *
        t358);
    const double t464 = t463 - (t194 * t374);
    const double t472 = (motion->constants[32] * t199) + (t191 * motion->constants[36]);
    const double t480 = (t252 * motion->constants[41]) + (t243 * motion->constants[43]);
    const double t486 = (t406 * motion->constants[40]) + (t362 * motion->constants[41]) + (t247 *
        t480) - (t400 * motion->constants[39]) - (t243 * t414);
    const double t492 = (t28 * t394) + (t17 * t391);
    const double t494 = t323 - (motion->constants[23] * t385) - t492;
    const double t505 = t434 + (t156 * ((t34 * t343) + (t151 * t354) - (t36 * t319) - (t147 *
        t350)));
    const double t506 = motion->constants[19] * t505;
    const double t513 = (t428 * motion->constants[39]) + (motion->constants[42] * t434) + t506 +
        (t243 * t419) - (motion->constants[38] * t494) - (t252 * t480);
    const double t520 = (t186 * motion->constants[31]) + (motion->constants[32] * t362) + (t194 *
        t472) + (cos_delta * t486) - (t358 * motion->constants[35]) - (t191 * t369);
    const double t522 = t520 - (sin_delta * t513) - (motion->constants[24] * t457);
    const double t529 = (motion->constants[30] * t191) - (t199 * motion->constants[31]);
    const double t531 = t194 * motion->constants[31];
    const double t539 = (motion->constants[37] * t494) + (t252 * t440) - (motion->constants[38] *
        t434) - (t247 * t449);
    const double t543 = (t199 * t529) + t539 - (t492 * motion->constants[34]) -
        (motion->constants[30] * t385) - (t194 * t531);
    const double t547 = motion->constants[30] * t194;
    const double t552 = (cos_delta * t444) - (sin_delta * t455);
    const double t556 = (t396 * motion->constants[34]) + (t385 * motion->constants[31]) + t552 -
        (t194 * t547) - (t191 * t529);
    const double t569 = t457 + (motion->constants[30] * t362) + (t358 * motion->constants[31]) +
        (t191 * t531) + (t199 * t547) - (t186 * motion->constants[34]);
    const double t572 = t74 - (sin_phi * t116);
    const double t585 = (t17 * t543) + (t28 * t556);
    const double t587 = (motion->constants[18] * t385) - (t5 * t585);
    const double t592 = (t396 * motion->constants[31]) + (motion->constants[30] * t492) +
        (motion->constants[33] * t385) + (t191 * t374) + (sin_delta * t486) + (cos_delta * t513);
    const double t596 = t592 + (motion->constants[24] * t552) + t587 - (t199 * t472) -
        (motion->constants[23] * t539);
    const double t598 = cos_phi * t116;
    const double t603 = (t28 * t464) + (t223 * t585) - (t17 * t522);
    const double t608 = forces[0] + (t223 * ((t28 * t543) - (t17 * t556))) + (t598 * t603) - (t17 *
        t464);
    const double t612 = t608 - (t28 * t522) - (t5 * t569) - (t572 * t596) - (t157 * t506);
    const double t614 = sin_delta * motion->constants[45];
    const double t615 = sin_delta * t614;
    const double t619 = motion->constants[35] + motion->constants[40] + motion->constants[47] -
        t615;
    const double t620 = cos_delta * motion->constants[38];
    const double t621 = motion->constants[23] * t620;
    const double t624 = t621 + t621 + motion->constants[50];
    const double t626 = motion->constants[36] + motion->constants[43] + t624;
    const double t627 = t626 - t619;
    const double t628 = t17 * t17;
    const double t630 = t17 * t28;
    const double t635 = (cos_delta * motion->constants[41]) - (motion->constants[24] * t620);
    const double t638 = motion->constants[32] + t635 - motion->constants[48] -
        motion->constants[49];
    const double t639 = t638 + t638;
    const double t641 = (t627 * t628) + (t630 * t639);
    const double t642 = sin_delta * motion->constants[38];
    const double t643 = t223 * t642;
    const double t645 = t223 * motion->constants[51];
    const double t648 = (t223 * t645) - t643 - t643;
    const double t653 = motion->constants[30] + t620 + motion->constants[46];
    const double t655 = (t28 * motion->constants[52]) - (t17 * t653);
    const double t656 = t5 * t655;
    const double t657 = t5 * motion->constants[51];
    const double t658 = t5 * t657;
    const double t660 = t658 - t656 - t656;
    const double t663 = (sin_delta * motion->constants[41]) - (motion->constants[24] * t642);
    const double t667 = (cos_delta * t614) - (motion->constants[23] * t642);
    const double t671 = (t17 * motion->constants[52]) + (t28 * t653);
    const double t674 = (t17 * t663) + (t28 * t667) + (t223 * t671);
    const double t681 = t638 + (t627 * t630) + (t5 * t671) - (t628 * t639);
    const double t687 = motion->constants[33] + motion->constants[42] + t615 +
        motion->constants[47] + t624 + t660;
    const double t697 = (t28 * t663) + (t223 * t655) + (t5 * t642) - (t17 * t667) - (t5 * t645);
    const double t704 = t626 + t648 - t641;
    const double t709 = motion->constants[18] * t572;
    const double t713 = t17 * sin_delta;
    const double t717 = t157 + (cos_delta * t572) - (sin_delta * t28) - (t598 * t713);
    const double t718 = motion->constants[19] * t717;
    const double t725 = t619 + t641 + t648 + t660 + (t572 * t674) + (t572 * (t674 + (t572 * t687) -
        (t598 * t697))) + (t572 * t709);
    const double t728 = t725 + (t717 * t718) - (t598 * t681) - (t598 * (t681 + (t572 * t697) -
        (t598 * t704)));
    const double t729 = 1.0 / t728;
    const double t731 = motion->constants[43] + t621;
    const double t737 = t91 - (sin_phi * t138);
    const double t739 = cos_phi * t138;
    const double t741 = t28 * t642;
    const double t742 = t5 * t741;
    const double t743 = t663 + t742;
    const double t747 = t743 + (t687 * t737) - (t697 * t739);
    const double t753 = (t28 * t731) - (t17 * t635) - (t223 * t741);
    const double t757 = t753 + (t697 * t737) - (t704 * t739);
    const double t763 = t166 + (cos_delta * t737) - (t713 * t739);
    const double t769 = (t17 * t731) + (t28 * t635) + (t5 * t620) + (t674 * t737) + (t572 * t747) +
        (t709 * t737);
    const double t774 = t729 * (t769 + (t718 * t763) - (t17 * t643) - (t681 * t739) - (t598 *
        t757));
    const double t779 = motion->constants[18] * t737;
    const double t781 = motion->constants[19] * t763;
    const double t783 = t728 * t774;
    const double t789 = motion->constants[43] + (t737 * t747) + (t737 * t743) + (t737 * t779) +
        (t763 * t781) - (t739 * t757);
    const double t791 = t789 - (t739 * t753) - (t774 * t783);
    const double t792 = 1.0 / t791;
    const double t802 = forces[1] + (t603 * t739) - t424 - (t596 * t737) - (t166 * t506) - (t612 *
        t774);
    const double t805 = t5 * (t655 - t657);
    const double t806 = sin_phi * t141;
    const double t808 = cos_phi * t141;
    const double t811 = t805 + (t687 * t806) + (t697 * t808);
    const double t814 = t5 * (t642 - t645);
    const double t818 = t814 - (t697 * t806) - (t704 * t808);
    const double t823 = 1.0 - t806;
    const double t828 = t171 - (cos_delta * t806) - (t713 * t808);
    const double t840 = (t709 * t823) + (t718 * t828) - (t674 * t806) - (t681 * t808) - (t572 *
        t811) - (t598 * t818);
    const double t841 = t729 * t840;
    const double t847 = t742 + (t779 * t823) + (t781 * t828) - (t737 * t811) - (t739 * t818) -
        (t743 * t806);
    const double t850 = t792 * (t847 - (t753 * t808) - (t783 * t841));
    const double t860 = (t596 * t806) + (t603 * t808) - t587 - (t171 * t506) - (t612 * t841) -
        (t802 * t850);
    const double t877 = t658 + (t806 * t811) + (t805 * t806) + (motion->constants[18] * t823 *
        t823) + (motion->constants[19] * t828 * t828) - (t808 * t818);
    const double t881 = t860 / (t877 - (t808 * t814) - (t728 * t841 * t841) - (t791 * t850 * t850));
    const double t883 = (t792 * t802) - (t850 * t881);
    const double t887 = (t612 * t729) - (t774 * t883) - (t841 * t881);
    const double t888 = -((t95 * cos_psi) + (t99 * sin_psi));
    const double t889 = -t144;
    rates[0] = t888;
    rates[1] = t105;
    rates[2] = t889;
    rates[3] = speeds[0];
    rates[4] = t93;
    rates[5] = speeds[1];
    rates[6] = speeds[2];
    rates[7] = t174;
    speed_rates[0] = t887;
    speed_rates[1] = t883;
    speed_rates[2] = t881;
}

carvallo_motion_error_t whipple_tyres_f64_motion_derivatives(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES], double rates[WHIPPLE_TYRES_POSITIONS],
    double speed_rates[WHIPPLE_TYRES_SPEEDS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_TYRES_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_TYRES_FORCES)) {
        whipple_tyres_f64_compute_derivatives(motion, positions, speeds, forces, rates,
            speed_rates);
        error = (carvallo_are_finite_f64(rates, WHIPPLE_TYRES_POSITIONS) &&
            carvallo_are_finite_f64(speed_rates, WHIPPLE_TYRES_SPEEDS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_tyres_f64_compute_accelerations(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES], double accelerations[WHIPPLE_TYRES_POSITIONS])
{
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t15 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t19 = t15 * cos_phi;
    const double t23 = (sin_phi * sin_delta) - (cos_delta * t19);
    const double t27 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const double t28 = cos_phi * t27;
    const double t31 = sqrt((t23 * t23) + (t28 * t28));
    const double t32 = 1.0 / t31;
    const double t33 = t23 * t32;
    const double t35 = t28 * t32;
    const double t36 = cos_delta * t35;
    const double t38 = (t27 * t36) - (t15 * t33);
    const double t41 = (sin_phi * cos_delta) + (t19 * sin_delta);
    const double t43 = t41 * motion->constants[28];
    const double t46 = sin_delta * motion->constants[26];
    const double t52 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const double t54 = (t27 * motion->constants[29]) - (t15 * t52);
    const double t57 = (cos_phi * t46) - (t38 * t43) - (sin_phi * t54);
    const double t58 = (sin_phi * motion->constants[25]) + t57;
    const double t65 = (cos_phi * sin_delta * t35) + (sin_phi * ((t27 * t33) + (t15 * t36)));
    const double t70 = (t43 * t65) + (t15 * motion->constants[29]) + (t27 * t52);
    const double t72 = 1.0 / (cos_phi * t70);
    const double t73 = t58 * t72;
    const double t79 = (t27 * motion->constants[24]) - (t15 * motion->constants[23]);
    const double t81 = t57 + (sin_phi * t79);
    const double t83 = sin_phi * t27;
    const double t87 = t70 - (t15 * motion->constants[24]) - (t27 * motion->constants[23]);
    const double t90 = t72 * ((t15 * t81) + (t83 * t87));
    const double t92 = (speeds[0] * t73) + (speeds[1] * t90);
    const double t93 = speeds[2] + t92;
    const double t95 = speeds[0] * motion->constants[21];
    const double t99 = motion->constants[25] + (cos_phi * motion->constants[21]);
    const double t103 = 1.0 / ((t38 * t70) + (t58 * t65));
    const double t104 = sin_phi * t70;
    const double t106 = sin_phi * t58;
    const double t108 = (t38 * t104) + (t65 * t106);
    const double t110 = t73 * t103 * t108;
    const double t121 = motion->constants[22] + (t31 * motion->constants[28]) + (sin_phi * t46) +
        (cos_phi * t54) - (cos_phi * t79);
    const double t123 = (t28 * t87) - (t15 * t121);
    const double t127 = (t83 * t121) + (t28 * t81);
    const double t132 = t103 * ((t38 * t123) + (t65 * t127) + (t90 * t108));
    const double t135 = t65 * t99 * t103;
    const double t138 = (speeds[0] * t110) + (speeds[1] * t132) + (speeds[2] * t135);
    const double t139 = cos_phi * t138;
    const double t140 = speeds[0] * t139;
    const double t143 = (speeds[0] * t15) - (t27 * t139);
    const double t144 = sin_phi * t138;
    const double t145 = t92 - t144;
    const double t146 = motion->constants[24] * t145;
    const double t150 = (speeds[0] * t27) + (t15 * t139);
    const double t151 = motion->constants[23] * t145;
    const double t153 = (t143 * t146) + (t150 * t151);
    const double t154 = speeds[0] * t144;
    const double t156 = t92 * t150;
    const double t157 = (t27 * t154) + t156;
    const double t160 = t92 * t143;
    const double t161 = (t15 * t154) + t160;
    const double t163 = t93 * t139;
    const double t165 = motion->constants[25] * t144;
    const double t167 = (t139 * t165) - (t99 * t163);
    const double t170 = t153 + (motion->constants[23] * t157) + (motion->constants[24] * t161) -
        t167;
    const double t175 = (motion->constants[23] * t143) - (motion->constants[24] * t150);
    const double t177 = (t145 * t151) + (t143 * t175);
    const double t179 = speeds[0] * motion->constants[25];
    const double t180 = t139 * t179;
    const double t182 = sin_phi * motion->constants[21];
    const double t183 = speeds[0] * t93;
    const double t187 = t180 + (t99 * t140) + (t182 * (t154 + t183));
    const double t194 = (t163 * t182) + (t165 * (t93 - t144)) - (speeds[0] * t179);
    const double t198 = (t27 * t187) + (t15 * t194) - t177 - (motion->constants[24] * t140);
    const double t200 = speeds[1] + t143;
    const double t204 = (cos_delta * t145) - (sin_delta * t150);
    const double t205 = motion->constants[27] * t204;
    const double t209 = (cos_delta * t150) + (sin_delta * t145);
    const double t210 = motion->constants[26] * t204;
    const double t215 = speeds[1] * t204;
    const double t217 = t215 - (cos_delta * t161) - (sin_delta * t140);
    const double t220 = motion->constants[28] + (t31 * motion->constants[22]);
    const double t221 = t33 * t220;
    const double t224 = (t65 * t104) - (t38 * t106);
    const double t228 = (t65 * t70) - (t38 * t58);
    const double t231 = 1.0 / t220;
    const double t232 = ((t110 * t228) - (t73 * t224)) * t231;
    const double t241 = t231 * ((t38 * t127) + (t132 * t228) - (t65 * t123) - (t90 * t224));
    const double t246 = t231 * ((t38 * t99) + (t135 * t228));
    const double t249 = (speeds[0] * t232) + (speeds[1] * t241) + (speeds[2] * t246);
    const double t251 = t157 + (t209 * t249);
    const double t253 = t35 * t220;
    const double t255 = t217 - (t200 * t249);
    const double t261 = t32 * ((t33 * t209) + (t35 * t200)) * t43;
    const double t262 = t35 * t261;
    const double t264 = t33 * t261;
    const double t270 = (cos_delta * t170) + (t200 * t205) + (t209 * t210) +
        (motion->constants[26] * t157) + (t221 * t251) + (t200 * t262);
    const double t274 = t270 + (t209 * t264) - (sin_delta * t198) - (motion->constants[27] * t217) -
        (t253 * t255);
    const double t281 = (motion->constants[26] * t200) - (motion->constants[27] * t209);
    const double t285 = speeds[1] * t209;
    const double t287 = (sin_delta * t161) - (cos_delta * t140) - t285;
    const double t290 = t41 * motion->constants[22];
    const double t292 = t204 + t249;
    const double t297 = motion->constants[28] * ((t33 * t200) - (t35 * t209));
    const double t303 = (cos_delta * t198) + (sin_delta * t170) + (motion->constants[27] * t287) +
        (t253 * t287) - (t204 * t210) - (t200 * t281);
    const double t306 = t303 - (t251 * t290) - (t264 * t292) - (t200 * t297);
    const double t310 = (t150 * t175) - (t145 * t146);
    const double t325 = t310 + (motion->constants[23] * t140) + (t15 * t187) + (t209 * t281) +
        (t255 * t290) + (t209 * t297);
    const double t330 = t325 - (t27 * t194) - (t204 * t205) - (motion->constants[26] * t287) -
        (t221 * t287) - (t262 * t292);
    const double t332 = (t33 * t306) + (t35 * t330);
    const double t335 = t72 * ((t41 * t274) + (t31 * t332));
    const double t341 = t103 * ((t31 * t274) + (t108 * t335) - (t41 * t332));
    const double t344 = t335 - t140 - (sin_phi * t341);
    const double t349 = t194 + (cos_phi * motion->constants[44]);
    const double t353 = t154 - (cos_phi * t341);
    const double t357 = (t99 * t344) - t180 - (t182 * (t183 + t353));
    const double t359 = (t27 * t349) + (t15 * t357);
    const double t362 = t310 - t359 - (motion->constants[23] * t344);
    const double t368 = t160 + (t15 * t353);
    const double t371 = (cos_delta * t344) + (sin_delta * t368) - t285;
    const double t376 = (t200 * motion->constants[38]) - (t209 * motion->constants[39]);
    const double t378 = t204 * motion->constants[39];
    const double t382 = (t362 * motion->constants[37]) + (t209 * t376) - (motion->constants[38] *
        t371) - (t204 * t378);
    const double t390 = (t143 * motion->constants[30]) - (motion->constants[31] * t150);
    const double t392 = motion->constants[31] * t145;
    const double t397 = t382 + (t150 * t390) - (t359 * motion->constants[34]) - (t344 *
        motion->constants[30]) - (t145 * t392);
    const double t401 = (t15 * t349) - (t27 * t357);
    const double t404 = t401 + (motion->constants[24] * t344) - t177;
    const double t407 = t156 + (t27 * t353);
    const double t411 = t167 + (sin_phi * motion->constants[44]);
    const double t414 = t153 + (motion->constants[23] * t407) + (motion->constants[24] * t368) -
        t411;
    const double t416 = (cos_delta * t404) + (sin_delta * t414);
    const double t419 = t204 * motion->constants[38];
    const double t424 = (t416 * motion->constants[37]) + (motion->constants[39] * t371) - (t204 *
        t419) - (t200 * t376);
    const double t428 = (cos_delta * t414) - (sin_delta * t404);
    const double t434 = t215 + (sin_delta * t344) - (cos_delta * t368);
    const double t441 = (t428 * motion->constants[37]) + (t407 * motion->constants[38]) + (t200 *
        t378) + (t209 * t419) - (motion->constants[39] * t434);
    const double t443 = (cos_delta * t424) - (sin_delta * t441);
    const double t446 = t145 * motion->constants[30];
    const double t452 = t443 + (t401 * motion->constants[34]) + (motion->constants[31] * t344) -
        (t145 * t446) - (t143 * t390);
    const double t454 = (t15 * t397) + (t27 * t452);
    const double t456 = (t344 * motion->constants[18]) - (t99 * t454);
    const double t457 = sin_phi * t135;
    const double t466 = (t150 * motion->constants[35]) + (t143 * motion->constants[32]);
    const double t471 = (t150 * motion->constants[32]) + (t143 * motion->constants[36]);
    const double t481 = (t209 * motion->constants[41]) + (t200 * motion->constants[43]);
    const double t487 = (t204 * motion->constants[42]) + (t292 * motion->constants[19]);
    const double t492 = (motion->constants[40] * t434) + (t407 * motion->constants[41]) + (t204 *
        t481) - (motion->constants[39] * t428) - (t200 * t487);
    const double t504 = t231 * ((t33 * t330) + (t228 * t341) - (t35 * t306) - (t224 * t335));
    const double t506 = motion->constants[19] * (t371 + t504);
    const double t509 = (t209 * motion->constants[40]) + (t200 * motion->constants[41]);
    const double t516 = (motion->constants[39] * t416) + (motion->constants[42] * t371) + t506 +
        (t200 * t509) - (motion->constants[38] * t362) - (t209 * t481);
    const double t524 = (motion->constants[31] * t401) + (motion->constants[30] * t359) + (t344 *
        motion->constants[33]) + (t143 * t466) + (sin_delta * t492) + (cos_delta * t516);
    const double t528 = t524 + (motion->constants[24] * t443) + t456 - (t150 * t471) -
        (motion->constants[23] * t382);
    const double t530 = cos_phi * t135;
    const double t537 = (t145 * motion->constants[33]) + (motion->constants[18] * (speeds[2] +
        t145));
    const double t548 = (t428 * motion->constants[38]) + (t434 * motion->constants[41]) + (t407 *
        motion->constants[43]) + (t209 * t487) - (t204 * t509);
    const double t551 = (sin_delta * t424) + (cos_delta * t441);
    const double t557 = (motion->constants[36] * t407) + (t150 * t537) + t548 +
        (motion->constants[23] * t551) - (motion->constants[30] * t411) - (motion->constants[32] *
        t368);
    const double t558 = t557 - (t145 * t466);
    const double t572 = (motion->constants[31] * t411) + (motion->constants[32] * t407) + (t145 *
        t471) + (cos_delta * t492) - (motion->constants[35] * t368) - (t143 * t537);
    const double t574 = t572 - (sin_delta * t516) - (motion->constants[24] * t551);
    const double t578 = (t27 * t558) + (t182 * t454) - (t15 * t574);
    const double t597 = t551 + (motion->constants[30] * t407) + (motion->constants[31] * t368) +
        (t143 * t392) + (t150 * t446) - (t411 * motion->constants[34]);
    const double t600 = t73 - (sin_phi * t110);
    const double t602 = cos_phi * t110;
    const double t607 = forces[0] + (t182 * ((t27 * t397) - (t15 * t452))) + (t578 * t602) - (t15 *
        t558);
    const double t611 = t607 - (t27 * t574) - (t99 * t597) - (t528 * t600) - (t232 * t506);
    const double t613 = sin_delta * motion->constants[38];
    const double t615 = (sin_delta * motion->constants[41]) - (motion->constants[24] * t613);
    const double t618 = sin_delta * motion->constants[45];
    const double t621 = (cos_delta * t618) - (motion->constants[23] * t613);
    const double t625 = cos_delta * motion->constants[38];
    const double t628 = motion->constants[30] + t625 + motion->constants[46];
    const double t630 = (t15 * motion->constants[52]) + (t27 * t628);
    const double t633 = (t15 * t615) + (t27 * t621) + (t182 * t630);
    const double t639 = (cos_delta * motion->constants[41]) - (motion->constants[24] * t625);
    const double t642 = motion->constants[32] + t639 - motion->constants[48] -
        motion->constants[49];
    const double t643 = sin_delta * t618;
    const double t647 = motion->constants[35] + motion->constants[40] + motion->constants[47] -
        t643;
    const double t648 = motion->constants[23] * t625;
    const double t651 = t648 + t648 + motion->constants[50];
    const double t653 = motion->constants[36] + motion->constants[43] + t651;
    const double t654 = t653 - t647;
    const double t655 = t15 * t27;
    const double t657 = t15 * t15;
    const double t658 = t642 + t642;
    const double t663 = t642 + (t654 * t655) + (t99 * t630) - (t657 * t658);
    const double t667 = (t27 * motion->constants[52]) - (t15 * t628);
    const double t669 = t99 * motion->constants[51];
    const double t671 = t99 * (t667 - t669);
    const double t672 = t99 * t667;
    const double t673 = t99 * t669;
    const double t675 = t673 - t672 - t672;
    const double t680 = motion->constants[33] + motion->constants[42] + t643 +
        motion->constants[47] + t651 + t675;
    const double t686 = t182 * motion->constants[51];
    const double t691 = (t27 * t615) + (t182 * t667) + (t99 * t613) - (t15 * t621) - (t99 * t686);
    const double t694 = t671 + (t457 * t680) + (t530 * t691);
    const double t697 = t99 * (t613 - t686);
    const double t701 = (t654 * t657) + (t655 * t658);
    const double t702 = t182 * t613;
    const double t705 = (t182 * t686) - t702 - t702;
    const double t707 = t653 + t705 - t701;
    const double t710 = t697 - (t457 * t691) - (t530 * t707);
    const double t713 = 1.0 - t457;
    const double t714 = motion->constants[18] * t600;
    const double t717 = t15 * sin_delta;
    const double t720 = t246 - (cos_delta * t457) - (t530 * t717);
    const double t726 = t232 + (cos_delta * t600) - (sin_delta * t27) - (t602 * t717);
    const double t727 = motion->constants[19] * t726;
    const double t733 = (t713 * t714) + (t720 * t727) - (t457 * t633) - (t530 * t663) - (t600 *
        t694) - (t602 * t710);
    const double t753 = t647 + t675 + t701 + t705 + (t600 * t633) + (t600 * (t633 + (t600 * t680) -
        (t602 * t691))) + (t600 * t714);
    const double t756 = t753 + (t726 * t727) - (t602 * t663) - (t602 * (t663 + (t600 * t691) -
        (t602 * t707)));
    const double t757 = 1.0 / t756;
    const double t758 = t733 * t757;
    const double t760 = t27 * t613;
    const double t761 = t99 * t760;
    const double t763 = t90 - (sin_phi * t132);
    const double t765 = cos_phi * t132;
    const double t767 = t615 + t761;
    const double t769 = motion->constants[43] + t648;
    const double t774 = (t27 * t769) - (t15 * t639) - (t182 * t760);
    const double t776 = motion->constants[18] * t763;
    const double t781 = t241 + (cos_delta * t763) - (t717 * t765);
    const double t782 = motion->constants[19] * t781;
    const double t793 = t767 + (t680 * t763) - (t691 * t765);
    const double t798 = t774 + (t691 * t763) - (t707 * t765);
    const double t806 = (t15 * t769) + (t27 * t639) + (t99 * t625) + (t633 * t763) + (t600 * t793) +
        (t714 * t763);
    const double t811 = t757 * (t806 + (t727 * t781) - (t15 * t702) - (t663 * t765) - (t602 *
        t798));
    const double t812 = t756 * t811;
    const double t818 = t761 + (t713 * t776) + (t720 * t782) - (t694 * t763) - (t710 * t765) -
        (t457 * t767);
    const double t832 = motion->constants[43] + (t763 * t793) + (t763 * t767) + (t763 * t776) +
        (t781 * t782) - (t765 * t798);
    const double t834 = t832 - (t765 * t774) - (t811 * t812);
    const double t835 = 1.0 / t834;
    const double t836 = (t818 - (t530 * t774) - (t758 * t812)) * t835;
    const double t846 = forces[1] + (t578 * t765) - t548 - (t528 * t763) - (t241 * t506) - (t611 *
        t811);
    const double t852 = (t457 * t528) + (t530 * t578) - t456 - (t246 * t506) - (t611 * t758) -
        (t836 * t846);
    const double t869 = t673 + (t457 * t694) + (t457 * t671) + (motion->constants[18] * t713 *
        t713) + (motion->constants[19] * t720 * t720) - (t530 * t710);
    const double t873 = t852 / (t869 - (t530 * t697) - (t756 * t758 * t758) - (t834 * t836 * t836));
    const double t877 = (t835 * t846) - (t836 * t873);
    const double t881 = (t611 * t757) - (t811 * t877) - (t758 * t873);
    const double t885 = t335 + (t73 * t881) + (t90 * t877);
    const double t890 = (sin_phi * t93 * t95) + (t95 * t138) - (t99 * (t873 + t885));
    const double t896 = (motion->constants[21] * t881) + (t93 * t99 * t138);
    const double t898 = (cos_psi * t890) - (sin_psi * t896);
    const double t901 = (t890 * sin_psi) + (cos_psi * t896);
    const double t913 = t504 + (t232 * t881) + (t241 * t877) + (t246 * t873);
    const double t914 = -(t341 + (t110 * t881) + (t132 * t877) + (t135 * t873));
    accelerations[0] = t898;
    accelerations[1] = t901;
    accelerations[2] = t914;
    accelerations[3] = t881;
    accelerations[4] = t885;
    accelerations[5] = t877;
    accelerations[6] = t873;
    accelerations[7] = t913;
}

carvallo_motion_error_t whipple_tyres_f64_motion_accelerations(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES], double accelerations[WHIPPLE_TYRES_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_TYRES_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_TYRES_FORCES)) {
        whipple_tyres_f64_compute_accelerations(motion, positions, speeds, forces, accelerations);
        error = (carvallo_are_finite_f64(accelerations, WHIPPLE_TYRES_POSITIONS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_tyres_f64_compute_energy(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    double energy[2])
{
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t6 = sin_delta * motion->constants[45];
    const double t7 = sin_delta * t6;
    const double t11 = motion->constants[35] + motion->constants[40] + motion->constants[47] - t7;
    const double t17 = cos_delta * motion->constants[38];
    const double t18 = motion->constants[23] * t17;
    const double t21 = t18 + t18 + motion->constants[50];
    const double t23 = motion->constants[36] + motion->constants[43] + t21;
    const double t24 = t23 - t11;
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t32 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    const double t33 = t32 * t32;
    const double t37 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const double t38 = t32 * t37;
    const double t46 = (cos_delta * motion->constants[41]) - (t17 * motion->constants[24]);
    const double t49 = motion->constants[32] + t46 - motion->constants[48] - motion->constants[49];
    const double t50 = t49 + t49;
    const double t52 = (t24 * t33) + (t38 * t50);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t56 = motion->constants[21] * sin_phi;
    const double t57 = sin_delta * motion->constants[38];
    const double t58 = t56 * t57;
    const double t60 = t56 * motion->constants[51];
    const double t63 = (t56 * t60) - t58 - t58;
    const double t67 = motion->constants[25] + (motion->constants[21] * cos_phi);
    const double t73 = t17 + motion->constants[30] + motion->constants[46];
    const double t75 = (t37 * motion->constants[52]) - (t32 * t73);
    const double t76 = t67 * t75;
    const double t77 = motion->constants[51] * t67;
    const double t78 = t67 * t77;
    const double t80 = t78 - t76 - t76;
    const double t83 = (sin_delta * motion->constants[41]) - (motion->constants[24] * t57);
    const double t87 = (t6 * cos_delta) - (motion->constants[23] * t57);
    const double t91 = (t32 * motion->constants[52]) + (t37 * t73);
    const double t94 = (t32 * t83) + (t37 * t87) + (t56 * t91);
    const double t96 = t32 * cos_phi;
    const double t99 = (sin_delta * sin_phi) - (cos_delta * t96);
    const double t101 = t37 * cos_phi;
    const double t104 = sqrt((t99 * t99) + (t101 * t101));
    const double t105 = 1.0 / t104;
    const double t106 = t99 * t105;
    const double t108 = t101 * t105;
    const double t109 = cos_delta * t108;
    const double t111 = (t37 * t109) - (t32 * t106);
    const double t116 = ((cos_delta * sin_phi) + (sin_delta * t96)) * motion->constants[28];
    const double t119 = sin_delta * motion->constants[26];
    const double t124 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const double t126 = (t37 * motion->constants[29]) - (t32 * t124);
    const double t129 = (cos_phi * t119) - (t111 * t116) - (sin_phi * t126);
    const double t130 = (sin_phi * motion->constants[25]) + t129;
    const double t137 = (sin_delta * cos_phi * t108) + (sin_phi * ((t37 * t106) + (t32 * t109)));
    const double t142 = (t116 * t137) + (t32 * motion->constants[29]) + (t37 * t124);
    const double t144 = 1.0 / (cos_phi * t142);
    const double t145 = t130 * t144;
    const double t146 = sin_phi * t142;
    const double t148 = sin_phi * t130;
    const double t150 = (t111 * t146) + (t137 * t148);
    const double t154 = 1.0 / ((t111 * t142) + (t130 * t137));
    const double t156 = t145 * t150 * t154;
    const double t158 = t145 - (sin_phi * t156);
    const double t165 = t49 + (t24 * t38) + (t67 * t91) - (t33 * t50);
    const double t166 = cos_phi * t156;
    const double t174 = t7 + motion->constants[47] + t21 + t80 + motion->constants[33] +
        motion->constants[42];
    const double t184 = (t37 * t83) + (t56 * t75) + (t57 * t67) - (t32 * t87) - (t60 * t67);
    const double t191 = t23 + t63 - t52;
    const double t197 = t158 * motion->constants[18];
    const double t201 = (t137 * t146) - (t111 * t148);
    const double t205 = (t137 * t142) - (t111 * t130);
    const double t211 = 1.0 / (motion->constants[28] + (t104 * motion->constants[22]));
    const double t215 = sin_delta * t32;
    const double t219 = (((t156 * t205) - (t145 * t201)) * t211) + (cos_delta * t158) - (sin_delta *
        t37) - (t166 * t215);
    const double t221 = t219 * motion->constants[19];
    const double t228 = t11 + t52 + t63 + t80 + (t94 * t158) + (t158 * (t94 + (t158 * t174) -
        (t166 * t184))) + (t158 * t197);
    const double t232 = speeds[0] * (t228 + (t219 * t221) - (t165 * t166) - (t166 * (t165 + (t158 *
        t184) - (t166 * t191))));
    const double t234 = motion->constants[43] + t18;
    const double t241 = (t37 * motion->constants[24]) - (motion->constants[23] * t32);
    const double t243 = t129 + (sin_phi * t241);
    const double t245 = t37 * sin_phi;
    const double t249 = t142 - (t32 * motion->constants[24]) - (motion->constants[23] * t37);
    const double t252 = t144 * ((t32 * t243) + (t245 * t249));
    const double t261 = motion->constants[22] + (t104 * motion->constants[28]) + (sin_phi * t119) +
        (cos_phi * t126) - (cos_phi * t241);
    const double t263 = (t101 * t249) - (t32 * t261);
    const double t267 = (t245 * t261) + (t101 * t243);
    const double t272 = t154 * ((t111 * t263) + (t137 * t267) + (t150 * t252));
    const double t274 = t252 - (sin_phi * t272);
    const double t276 = cos_phi * t272;
    const double t278 = t37 * t57;
    const double t279 = t67 * t278;
    const double t280 = t83 + t279;
    const double t284 = t280 + (t174 * t274) - (t184 * t276);
    const double t290 = (t37 * t234) - (t32 * t46) - (t56 * t278);
    const double t294 = t290 + (t184 * t274) - (t191 * t276);
    const double t307 = (t211 * ((t111 * t267) + (t205 * t272) - (t137 * t263) - (t201 * t252))) +
        (cos_delta * t274);
    const double t308 = t307 - (t215 * t276);
    const double t314 = (t32 * t234) + (t37 * t46) + (t17 * t67) + (t94 * t274) + (t158 * t284) +
        (t197 * t274);
    const double t318 = t314 + (t221 * t308) - (t32 * t58) - (t165 * t276) - (t166 * t294);
    const double t322 = t67 * t137 * t154;
    const double t323 = sin_phi * t322;
    const double t325 = cos_phi * t322;
    const double t327 = t75 - t77;
    const double t328 = t67 * t327;
    const double t332 = t328 + (t174 * t323) + (t184 * t325);
    const double t334 = t57 - t60;
    const double t335 = t67 * t334;
    const double t339 = t335 - (t184 * t323) - (t191 * t325);
    const double t342 = 1.0 - t323;
    const double t351 = (t211 * ((t67 * t111) + (t205 * t322))) - (cos_delta * t323) - (t215 *
        t325);
    const double t357 = (t197 * t342) + (t221 * t351) - (t94 * t323) - (t165 * t325) - (t158 *
        t332) - (t166 * t339);
    const double t367 = motion->constants[18] * t274;
    const double t369 = motion->constants[19] * t308;
    const double t375 = motion->constants[43] + (t274 * t284) + (t274 * t280) + (t274 * t367) +
        (t308 * t369) - (t276 * t294);
    const double t388 = t279 + (t342 * t367) + (t351 * t369) - (t274 * t332) - (t276 * t339) -
        (t280 * t323);
    const double t389 = t388 - (t290 * t325);
    const double t393 = speeds[1] * ((speeds[0] * t318) + (speeds[1] * (t375 - (t276 * t290))) +
        (speeds[2] * t389));
    const double t408 = t78 + (t323 * t332) + (t323 * t328) + (motion->constants[18] * t342 *
        t342) + (motion->constants[19] * t351 * t351) - (t325 * t339);
    const double t415 = (speeds[0] * (t232 + (speeds[1] * t318) + (speeds[2] * t357))) + t393 +
        (speeds[2] * ((speeds[0] * t357) + (speeds[1] * t389) + (speeds[2] * (t408 - (t325 *
        t335)))));
    const double t417 = t415 * 0.5;
    const double t423 = -(motion->constants[44] * ((sin_phi * t334) + (cos_phi * t327)));
    energy[0] = t417;
    energy[1] = t423;
}

carvallo_motion_error_t whipple_tyres_f64_motion_energy(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    double energy[2])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_TYRES_SPEEDS)) {
        whipple_tyres_f64_compute_energy(motion, positions, speeds, energy);
        error = (carvallo_are_finite_f64(energy, 2U)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

/* How far the lowest points of the wheels behind the first are below the ground, and the steps of Newton's method. */
static void whipple_tyres_f64_compute_closure(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], double below[1U], double steps[1U])
{
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t15 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    const double t16 = cos_phi * t15;
    const double t20 = sin_phi * sin_delta;
    const double t21 = t20 - (cos_delta * t16);
    const double t25 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const double t26 = cos_phi * t25;
    const double t29 = sqrt((t21 * t21) + (t26 * t26));
    const double t38 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const double t46 = motion->constants[22] + (t29 * motion->constants[28]) + (t20 *
        motion->constants[26]) + (cos_phi * ((t25 * motion->constants[29]) - (t15 * t38))) -
        motion->constants[21] - (cos_phi * motion->constants[25]);
    const double t50 = 1.0 / t29;
    const double t51 = t26 * t50;
    const double t62 = motion->constants[28] * ((cos_delta * sin_phi) + (t16 * sin_delta)) *
        ((cos_phi * sin_delta * t51) + (sin_phi * ((t21 * t25 * t50) + (cos_delta * t15 * t51))));
    const double t68 = t46 / (cos_phi * (t62 + (t15 * motion->constants[29]) + (t25 * t38)));
    below[0] = t46;
    steps[0] = t68;
}

carvallo_motion_error_t whipple_tyres_f64_motion_close(const whipple_tyres_f64_motion_t *motion,
    double positions[WHIPPLE_TYRES_POSITIONS])
{
    /* The positions that the heights of the wheels determine. */
    static const size_t DEPENDENT[1U] = {4U};
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_TYRES_POSITIONS)) {
        double found[WHIPPLE_TYRES_POSITIONS];
        double below[1U];
        double steps[1U];
        double shortest = 1e30;
        bool is_closed = false;
        bool goes_on = true;
        for (size_t i = 0U; i < WHIPPLE_TYRES_POSITIONS; i++) {
            found[i] = positions[i];
        }
        /* With steps of the greatest length they lead around the whole circle; near a solution a handful is enough. */
        for (size_t count = 0U; goes_on && (count < 60U); count++) {
            whipple_tyres_f64_compute_closure(motion, found, below, steps);
            if (carvallo_are_finite_f64(steps, 1U)) {
                double longest = 0.0;
                double size = 1.0;
                double share = 1.0;
                for (size_t i = 0U; i < 1U; i++) {
                    longest = (fabs(steps[i]) > longest) ? fabs(steps[i]) : longest;
                }
                /* No step is longer than this, in rad or m: it keeps to the solution that is near. */
                if (longest > 0.25) {
                    share = 0.25 / longest;
                }
                for (size_t i = 0U; i < 1U; i++) {
                    found[DEPENDENT[i]] += steps[i] * share;
                }
                for (size_t i = 0U; i < 1U; i++) {
                    const double value = fabs(found[DEPENDENT[i]]);
                    size = (value > size) ? value : size;
                }
                /* Near the solution steps shrink to rounding, and then no further. */
                is_closed = (longest <= (4.0 * DBL_EPSILON * size)) || ((longest < 1e-5) &&
                    (longest >= shortest));
                goes_on = !is_closed;
                shortest = longest;
            } else {
                goes_on = false;
            }
        }
        if (is_closed) {
            error = CARVALLO_MOTION_OK;
            for (size_t i = 0U; i < 1U; i++) {
                positions[DEPENDENT[i]] = found[DEPENDENT[i]];
            }
        } else {
            double most = 0.0;
            bool is_finite = false;
            whipple_tyres_f64_compute_closure(motion, found, below, steps);
            is_finite = carvallo_is_finite_f64(below[0]);
            for (size_t i = 0U; i < 1U; i++) {
                if (carvallo_is_finite_f64(below[i]) && (fabs(below[i]) > most)) {
                    most = fabs(below[i]);
                    is_finite = true;
                }
            }
            error = is_finite ? CARVALLO_MOTION_NOT_CLOSED : CARVALLO_MOTION_SINGULAR;
        }
    }
    return error;
}

static void whipple_tyres_f64_compute_contact_forces(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES], double contact_forces[3U * WHIPPLE_TYRES_WHEELS])
{
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t9 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    const double t13 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t19 = t9 * cos_phi;
    const double t24 = (sin_phi * sin_delta) - (cos_delta * t19);
    const double t26 = t13 * cos_phi;
    const double t29 = sqrt((t24 * t24) + (t26 * t26));
    const double t30 = 1.0 / t29;
    const double t31 = t24 * t30;
    const double t33 = t26 * t30;
    const double t34 = cos_delta * t33;
    const double t36 = (t13 * t34) - (t9 * t31);
    const double t43 = (cos_phi * sin_delta * t33) + (sin_phi * ((t13 * t31) + (t9 * t34)));
    const double t46 = (cos_delta * sin_phi) + (t19 * sin_delta);
    const double t48 = t46 * motion->constants[28];
    const double t55 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const double t58 = (t43 * t48) + (t9 * motion->constants[29]) + (t13 * t55);
    const double t59 = sin_phi * t58;
    const double t64 = sin_delta * motion->constants[26];
    const double t68 = (t13 * motion->constants[29]) - (t9 * t55);
    const double t71 = (cos_phi * t64) - (t36 * t48) - (sin_phi * t68);
    const double t72 = (sin_phi * motion->constants[25]) + t71;
    const double t73 = sin_phi * t72;
    const double t75 = (t36 * t59) + (t43 * t73);
    const double t77 = 1.0 / (cos_phi * t58);
    const double t78 = t72 * t77;
    const double t82 = 1.0 / ((t36 * t58) + (t43 * t72));
    const double t84 = t75 * t78 * t82;
    const double t91 = t58 - (t9 * motion->constants[24]) - (t13 * motion->constants[23]);
    const double t99 = (t13 * motion->constants[24]) - (t9 * motion->constants[23]);
    const double t104 = motion->constants[22] + (t29 * motion->constants[28]) + (sin_phi * t64) +
        (cos_phi * t68) - (cos_phi * t99);
    const double t106 = (t26 * t91) - (t9 * t104);
    const double t108 = t13 * sin_phi;
    const double t111 = t71 + (sin_phi * t99);
    const double t113 = (t104 * t108) + (t26 * t111);
    const double t118 = t77 * ((t9 * t111) + (t91 * t108));
    const double t122 = t82 * ((t36 * t106) + (t43 * t113) + (t75 * t118));
    const double t127 = motion->constants[25] + (cos_phi * motion->constants[21]);
    const double t129 = t43 * t82 * t127;
    const double t132 = (speeds[0] * t84) + (speeds[1] * t122) + (speeds[2] * t129);
    const double t133 = cos_phi * t132;
    const double t135 = (speeds[0] * t13) + (t9 * t133);
    const double t138 = (t9 * speeds[0]) - (t13 * t133);
    const double t143 = (t138 * motion->constants[30]) - (t135 * motion->constants[31]);
    const double t147 = (speeds[0] * t78) + (speeds[1] * t118);
    const double t148 = sin_phi * t132;
    const double t149 = t147 - t148;
    const double t150 = motion->constants[31] * t149;
    const double t152 = (t135 * t143) - (t149 * t150);
    const double t154 = speeds[0] * motion->constants[25];
    const double t155 = t133 * t154;
    const double t156 = motion->constants[24] * t149;
    const double t158 = motion->constants[23] * t149;
    const double t160 = (t138 * t156) + (t135 * t158);
    const double t161 = speeds[0] * t148;
    const double t163 = t135 * t147;
    const double t164 = (t13 * t161) + t163;
    const double t167 = t138 * t147;
    const double t168 = (t9 * t161) + t167;
    const double t170 = speeds[2] + t147;
    const double t171 = t133 * t170;
    const double t173 = motion->constants[25] * t148;
    const double t174 = t133 * t173;
    const double t175 = t174 - (t127 * t171);
    const double t178 = t160 + (motion->constants[23] * t164) + (motion->constants[24] * t168) -
        t175;
    const double t183 = (motion->constants[23] * t138) - (motion->constants[24] * t135);
    const double t185 = (t149 * t158) + (t138 * t183);
    const double t186 = speeds[0] * t133;
    const double t189 = sin_phi * motion->constants[21];
    const double t190 = speeds[0] * t170;
    const double t194 = t155 + (t127 * t186) + (t189 * (t161 + t190));
    const double t200 = (t173 * (t170 - t148)) - (speeds[0] * t154);
    const double t201 = (t171 * t189) + t200;
    const double t205 = (t13 * t194) + (t9 * t201) - t185 - (motion->constants[24] * t186);
    const double t207 = speeds[1] + t138;
    const double t211 = (cos_delta * t149) - (sin_delta * t135);
    const double t212 = motion->constants[27] * t211;
    const double t216 = (cos_delta * t135) + (sin_delta * t149);
    const double t217 = motion->constants[26] * t211;
    const double t222 = speeds[1] * t211;
    const double t224 = t222 - (cos_delta * t168) - (sin_delta * t186);
    const double t227 = motion->constants[28] + (t29 * motion->constants[22]);
    const double t228 = t31 * t227;
    const double t231 = (t43 * t59) - (t36 * t73);
    const double t235 = (t43 * t58) - (t36 * t72);
    const double t238 = 1.0 / t227;
    const double t239 = ((t84 * t235) - (t78 * t231)) * t238;
    const double t248 = t238 * ((t36 * t113) + (t122 * t235) - (t43 * t106) - (t118 * t231));
    const double t253 = t238 * ((t36 * t127) + (t129 * t235));
    const double t256 = (speeds[0] * t239) + (speeds[1] * t248) + (speeds[2] * t253);
    const double t258 = t164 + (t216 * t256);
    const double t260 = t33 * t227;
    const double t262 = t224 - (t207 * t256);
    const double t268 = t30 * ((t31 * t216) + (t33 * t207)) * t48;
    const double t269 = t33 * t268;
    const double t271 = t31 * t268;
    const double t277 = (cos_delta * t178) + (t207 * t212) + (t216 * t217) +
        (motion->constants[26] * t164) + (t228 * t258) + (t207 * t269);
    const double t281 = t277 + (t216 * t271) - (sin_delta * t205) - (motion->constants[27] * t224) -
        (t260 * t262);
    const double t288 = (motion->constants[26] * t207) - (motion->constants[27] * t216);
    const double t292 = speeds[1] * t216;
    const double t294 = (sin_delta * t168) - (cos_delta * t186) - t292;
    const double t297 = t46 * motion->constants[22];
    const double t299 = t211 + t256;
    const double t304 = motion->constants[28] * ((t31 * t207) - (t33 * t216));
    const double t310 = (cos_delta * t205) + (sin_delta * t178) + (motion->constants[27] * t294) +
        (t260 * t294) - (t211 * t217) - (t207 * t288);
    const double t313 = t310 - (t258 * t297) - (t271 * t299) - (t207 * t304);
    const double t317 = (t135 * t183) - (t149 * t156);
    const double t332 = t317 + (motion->constants[23] * t186) + (t9 * t194) + (t216 * t288) +
        (t262 * t297) + (t216 * t304);
    const double t337 = t332 - (t13 * t201) - (t211 * t212) - (motion->constants[26] * t294) -
        (t228 * t294) - (t269 * t299);
    const double t339 = (t31 * t313) + (t33 * t337);
    const double t344 = t77 * ((t46 * t281) + (t29 * t339));
    const double t348 = t82 * ((t29 * t281) + (t75 * t344) - (t46 * t339));
    const double t350 = t186 - t344;
    const double t351 = (sin_phi * t348) + t350;
    const double t355 = cos_phi * motion->constants[44];
    const double t356 = t201 + t355;
    const double t360 = t161 - (cos_phi * t348);
    const double t364 = (t127 * t351) + t155 + (t189 * (t190 + t360));
    const double t366 = (t13 * t356) - (t9 * t364);
    const double t369 = t317 - t366 + (motion->constants[23] * t351);
    const double t375 = t167 + (t9 * t360);
    const double t378 = (sin_delta * t375) - (cos_delta * t351) - t292;
    const double t383 = (t207 * motion->constants[38]) - (t216 * motion->constants[39]);
    const double t385 = t211 * motion->constants[39];
    const double t387 = (t216 * t383) - (t211 * t385);
    const double t389 = (t369 * motion->constants[37]) + t387 - (motion->constants[38] * t378);
    const double t394 = t152 + t389 - (motion->constants[34] * t366) + (motion->constants[30] *
        t351);
    const double t398 = (t9 * t356) + (t13 * t364);
    const double t401 = t398 - (motion->constants[24] * t351) - t185;
    const double t404 = t163 + (t13 * t360);
    const double t407 = sin_phi * motion->constants[44];
    const double t408 = t175 + t407;
    const double t411 = t160 + (motion->constants[23] * t404) + (motion->constants[24] * t375) -
        t408;
    const double t413 = (cos_delta * t401) + (sin_delta * t411);
    const double t416 = t211 * motion->constants[38];
    const double t419 = (t211 * t416) + (t207 * t383);
    const double t421 = (t413 * motion->constants[37]) + (motion->constants[39] * t378) - t419;
    const double t425 = (cos_delta * t411) - (sin_delta * t401);
    const double t431 = t222 - (sin_delta * t351) - (cos_delta * t375);
    const double t435 = (t207 * t385) + (t216 * t416);
    const double t438 = (t425 * motion->constants[37]) + (t404 * motion->constants[38]) + t435 -
        (motion->constants[39] * t431);
    const double t440 = (cos_delta * t421) - (sin_delta * t438);
    const double t443 = motion->constants[30] * t149;
    const double t446 = (t149 * t443) + (t138 * t143);
    const double t449 = t440 + (motion->constants[34] * t398) - (motion->constants[31] * t351) -
        t446;
    const double t451 = (t9 * t394) + (t13 * t449);
    const double t453 = (t351 * motion->constants[18]) + (t127 * t451);
    const double t454 = sin_phi * t129;
    const double t463 = (t135 * motion->constants[35]) + (t138 * motion->constants[32]);
    const double t468 = (t135 * motion->constants[32]) + (t138 * motion->constants[36]);
    const double t470 = (t138 * t463) - (t135 * t468);
    const double t479 = (t216 * motion->constants[41]) + (t207 * motion->constants[43]);
    const double t485 = (t211 * motion->constants[42]) + (t299 * motion->constants[19]);
    const double t487 = (t211 * t479) - (t207 * t485);
    const double t490 = (motion->constants[40] * t431) + (t404 * motion->constants[41]) + t487 -
        (motion->constants[39] * t425);
    const double t502 = t238 * ((t31 * t337) + (t235 * t348) - (t33 * t313) - (t231 * t344));
    const double t504 = motion->constants[19] * (t378 + t502);
    const double t507 = (t216 * motion->constants[40]) + (t207 * motion->constants[41]);
    const double t510 = (t207 * t507) - (t216 * t479);
    const double t514 = (motion->constants[39] * t413) + (motion->constants[42] * t378) + t504 +
        t510 - (motion->constants[38] * t369);
    const double t522 = (motion->constants[31] * t398) + (motion->constants[30] * t366) - (t351 *
        motion->constants[33]) + t470 + (sin_delta * t490) + (cos_delta * t514);
    const double t525 = t522 + (motion->constants[24] * t440) - t453 - (motion->constants[23] *
        t389);
    const double t527 = cos_phi * t129;
    const double t534 = (t149 * motion->constants[33]) + (motion->constants[18] * (speeds[2] +
        t149));
    const double t537 = (t135 * t534) - (t149 * t463);
    const double t543 = (t216 * t485) - (t211 * t507);
    const double t546 = (t425 * motion->constants[38]) + (t431 * motion->constants[41]) + (t404 *
        motion->constants[43]) + t543;
    const double t549 = (sin_delta * t421) + (cos_delta * t438);
    const double t555 = (motion->constants[36] * t404) + t537 + t546 + (motion->constants[23] *
        t549) - (motion->constants[30] * t408) - (motion->constants[32] * t375);
    const double t562 = (t149 * t468) - (t138 * t534);
    const double t570 = (motion->constants[31] * t408) + (motion->constants[32] * t404) + t562 +
        (cos_delta * t490) - (motion->constants[35] * t375) - (sin_delta * t514);
    const double t571 = t570 - (motion->constants[24] * t549);
    const double t575 = (t13 * t555) + (t189 * t451) - (t9 * t571);
    const double t590 = (t138 * t150) + (t135 * t443);
    const double t595 = t127 * (t549 + (motion->constants[30] * t404) + (motion->constants[31] *
        t375) + t590 - (motion->constants[34] * t408));
    const double t597 = t78 - (sin_phi * t84);
    const double t599 = cos_phi * t84;
    const double t604 = forces[0] + (t189 * ((t13 * t394) - (t9 * t449))) + (t575 * t599) - (t9 *
        t555);
    const double t608 = t604 - (t13 * t571) - t595 - (t525 * t597) - (t239 * t504);
    const double t610 = sin_delta * motion->constants[38];
    const double t612 = (sin_delta * motion->constants[41]) - (motion->constants[24] * t610);
    const double t615 = sin_delta * motion->constants[45];
    const double t618 = (cos_delta * t615) - (motion->constants[23] * t610);
    const double t622 = cos_delta * motion->constants[38];
    const double t625 = motion->constants[30] + t622 + motion->constants[46];
    const double t627 = (t9 * motion->constants[52]) + (t13 * t625);
    const double t630 = (t9 * t612) + (t13 * t618) + (t189 * t627);
    const double t636 = (cos_delta * motion->constants[41]) - (motion->constants[24] * t622);
    const double t639 = motion->constants[32] + t636 - motion->constants[48] -
        motion->constants[49];
    const double t640 = sin_delta * t615;
    const double t644 = motion->constants[35] + motion->constants[40] + motion->constants[47] -
        t640;
    const double t645 = motion->constants[23] * t622;
    const double t648 = t645 + t645 + motion->constants[50];
    const double t650 = motion->constants[36] + motion->constants[43] + t648;
    const double t651 = t650 - t644;
    const double t652 = t9 * t13;
    const double t654 = t9 * t9;
    const double t655 = t639 + t639;
    const double t660 = t639 + (t651 * t652) + (t127 * t627) - (t654 * t655);
    const double t664 = (t13 * motion->constants[52]) - (t9 * t625);
    const double t666 = t127 * motion->constants[51];
    const double t668 = t127 * (t664 - t666);
    const double t669 = t127 * t664;
    const double t670 = t127 * t666;
    const double t672 = t670 - t669 - t669;
    const double t677 = motion->constants[33] + motion->constants[42] + t640 +
        motion->constants[47] + t648 + t672;
    const double t683 = t189 * motion->constants[51];
    const double t688 = (t13 * t612) + (t189 * t664) + (t127 * t610) - (t9 * t618) - (t127 * t683);
    const double t691 = t668 + (t454 * t677) + (t527 * t688);
    const double t694 = t127 * (t610 - t683);
    const double t698 = (t651 * t654) + (t652 * t655);
    const double t699 = t189 * t610;
    const double t702 = (t189 * t683) - t699 - t699;
    const double t704 = t650 + t702 - t698;
    const double t707 = t694 - (t454 * t688) - (t527 * t704);
    const double t710 = 1.0 - t454;
    const double t711 = motion->constants[18] * t597;
    const double t714 = t9 * sin_delta;
    const double t717 = t253 - (cos_delta * t454) - (t527 * t714);
    const double t723 = t239 + (cos_delta * t597) - (t13 * sin_delta) - (t599 * t714);
    const double t724 = motion->constants[19] * t723;
    const double t730 = (t710 * t711) + (t717 * t724) - (t454 * t630) - (t527 * t660) - (t597 *
        t691) - (t599 * t707);
    const double t750 = t644 + t672 + t698 + t702 + (t597 * t630) + (t597 * (t630 + (t597 * t677) -
        (t599 * t688))) + (t597 * t711);
    const double t753 = t750 + (t723 * t724) - (t599 * t660) - (t599 * (t660 + (t597 * t688) -
        (t599 * t704)));
    const double t754 = 1.0 / t753;
    const double t755 = t730 * t754;
    const double t757 = t13 * t610;
    const double t758 = t127 * t757;
    const double t760 = t118 - (sin_phi * t122);
    const double t762 = cos_phi * t122;
    const double t764 = t612 + t758;
    const double t766 = motion->constants[43] + t645;
    const double t771 = (t13 * t766) - (t9 * t636) - (t189 * t757);
    const double t773 = motion->constants[18] * t760;
    const double t778 = t248 + (cos_delta * t760) - (t714 * t762);
    const double t779 = motion->constants[19] * t778;
    const double t790 = t764 + (t677 * t760) - (t688 * t762);
    const double t795 = t771 + (t688 * t760) - (t704 * t762);
    const double t803 = (t9 * t766) + (t13 * t636) + (t127 * t622) + (t630 * t760) + (t597 * t790) +
        (t711 * t760);
    const double t808 = t754 * (t803 + (t724 * t778) - (t9 * t699) - (t660 * t762) - (t599 * t795));
    const double t809 = t753 * t808;
    const double t815 = t758 + (t710 * t773) + (t717 * t779) - (t691 * t760) - (t707 * t762) -
        (t454 * t764);
    const double t829 = motion->constants[43] + (t760 * t790) + (t760 * t764) + (t760 * t773) +
        (t778 * t779) - (t762 * t795);
    const double t831 = t829 - (t762 * t771) - (t808 * t809);
    const double t832 = 1.0 / t831;
    const double t833 = (t815 - (t527 * t771) - (t755 * t809)) * t832;
    const double t843 = forces[1] + (t575 * t762) - t546 - (t525 * t760) - (t248 * t504) - (t608 *
        t808);
    const double t849 = (t454 * t525) + (t527 * t575) + t453 - (t253 * t504) - (t608 * t755) -
        (t833 * t843);
    const double t866 = t670 + (t454 * t691) + (t454 * t668) + (motion->constants[18] * t710 *
        t710) + (motion->constants[19] * t717 * t717) - (t527 * t707);
    const double t870 = t849 / (t866 - (t527 * t694) - (t753 * t755 * t755) - (t831 * t833 * t833));
    const double t874 = (t832 * t843) - (t833 * t870);
    const double t878 = (t608 * t754) - (t808 * t874) - (t755 * t870);
    const double t886 = t348 + (t84 * t878) + (t122 * t874) + (t129 * t870);
    const double t890 = (t78 * t878) + (t118 * t874) - (sin_phi * t886) - t350;
    const double t891 = t870 + t890;
    const double t894 = t161 - (cos_phi * t886);
    const double t898 = (t127 * t891) - t155 - (t189 * (t190 + t894));
    const double t900 = t171 + t878;
    const double t903 = t200 + t355 + (t189 * t900);
    const double t905 = (t9 * t898) + (t13 * t903);
    const double t910 = t317 - t905 - (motion->constants[23] * t890);
    const double t916 = (t13 * t878) - t167 - (t9 * t894);
    const double t919 = (cos_delta * t890) - t292 - (sin_delta * t916);
    const double t922 = t387 + (motion->constants[37] * t910) - (motion->constants[38] * t919);
    const double t925 = t152 + t922 - (motion->constants[34] * t905) - (motion->constants[30] *
        t890);
    const double t929 = (t9 * t903) - (t13 * t898);
    const double t934 = t929 + (motion->constants[24] * t890) - t185;
    const double t939 = t163 + (t13 * t894) + (t9 * t878);
    const double t944 = t174 + t407 - (t127 * t900);
    const double t947 = t160 + (motion->constants[23] * t939) - (motion->constants[24] * t916) -
        t944;
    const double t949 = (cos_delta * t934) + (sin_delta * t947);
    const double t953 = (motion->constants[37] * t949) + (motion->constants[39] * t919) - t419;
    const double t957 = (cos_delta * t947) - (sin_delta * t934);
    const double t959 = t874 + t939;
    const double t964 = t222 + (cos_delta * t916) + (sin_delta * t890);
    const double t968 = t435 + (motion->constants[37] * t957) + (motion->constants[38] * t959) -
        (motion->constants[39] * t964);
    const double t970 = (cos_delta * t953) - (sin_delta * t968);
    const double t973 = (motion->constants[34] * t929) + (motion->constants[31] * t890) + t970 -
        t446;
    const double t975 = (t9 * t925) + (t13 * t973);
    const double t983 = motion->constants[19] * (t502 + t919 + (t239 * t878) + (t248 * t874) +
        (t253 * t870));
    const double t984 = t238 * t983;
    const double t995 = t487 + (motion->constants[40] * t964) + (motion->constants[41] * t959) -
        (motion->constants[39] * t957);
    const double t1003 = t510 + t983 + (motion->constants[39] * t949) + (motion->constants[42] *
        t919) - (motion->constants[38] * t910);
    const double t1012 = t470 + (motion->constants[31] * t929) + (motion->constants[30] * t905) +
        (motion->constants[33] * t890) + (motion->constants[18] * t891) + (sin_delta * t995);
    const double t1016 = t1012 + (cos_delta * t1003) + (motion->constants[24] * t970) -
        (motion->constants[23] * t922) - (t127 * t975);
    const double t1026 = (sin_delta * t953) + (cos_delta * t968);
    const double t1033 = t537 + t543 + (motion->constants[32] * t916) + (motion->constants[36] *
        t939) + (motion->constants[38] * t957) + (motion->constants[41] * t964) +
        (motion->constants[43] * t959);
    const double t1047 = t562 + (motion->constants[31] * t944) + (motion->constants[35] * t916) +
        (motion->constants[32] * t939) + (cos_delta * t995) - (sin_delta * t1003);
    const double t1052 = (t13 * (t1033 + (motion->constants[23] * t1026) - (motion->constants[30] *
        t944))) + (t189 * t975) - (t9 * (t1047 - (motion->constants[24] * t1026)));
    const double t1057 = t82 * ((sin_phi * t1016) + (cos_phi * t1052) - (t235 * t984));
    const double t1059 = (t36 * t984) - (t43 * t1057);
    const double t1060 = t975 - t1059;
    const double t1065 = (t43 * t984) + (t36 * t1057);
    const double t1072 = t590 + t1026 + (motion->constants[30] * t939) - (motion->constants[34] *
        t944) - (motion->constants[31] * t916);
    const double t1076 = (t13 * t925) - (t9 * t973);
    const double t1079 = (cos_phi * t1072) - t1065 - (sin_phi * t1076);
    const double t1081 = (cos_psi * t1060) - (sin_psi * t1079);
    const double t1084 = (t1060 * sin_psi) + (cos_psi * t1079);
    const double t1089 = t77 * (t1016 - (t75 * t1057) - (t231 * t984));
    const double t1093 = t1089 + (sin_phi * t1072) + (cos_phi * t1076);
    const double t1096 = (cos_psi * t1059) - (sin_psi * t1065);
    const double t1099 = (t1059 * sin_psi) + (cos_psi * t1065);
    const double t1100 = -t1089;
    contact_forces[0] = t1081;
    contact_forces[1] = t1084;
    contact_forces[2] = t1093;
    contact_forces[3] = t1096;
    contact_forces[4] = t1099;
    contact_forces[5] = t1100;
}

carvallo_motion_error_t whipple_tyres_f64_motion_contact_forces(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES], double contact_forces[3U * WHIPPLE_TYRES_WHEELS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_TYRES_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_TYRES_FORCES)) {
        whipple_tyres_f64_compute_contact_forces(motion, positions, speeds, forces, contact_forces);
        error = (carvallo_are_finite_f64(contact_forces, 3U * WHIPPLE_TYRES_WHEELS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_tyres_f64_compute_linearization(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES], whipple_tyres_f64_linearization_t *linearization)
{
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t6 = motion->constants[25] + (motion->constants[21] * cos_phi);
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t18 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t21 = cos_phi * t18;
    const double t24 = sin_phi * sin_delta;
    const double t25 = t24 - (cos_delta * t21);
    const double t29 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const double t30 = cos_phi * t29;
    const double t33 = sqrt((t25 * t25) + (t30 * t30));
    const double t34 = 1.0 / t33;
    const double t35 = t25 * t34;
    const double t37 = t30 * t34;
    const double t38 = cos_delta * t37;
    const double t40 = (t29 * t38) - (t18 * t35);
    const double t41 = sin_phi * cos_delta;
    const double t42 = t21 * sin_delta;
    const double t43 = t41 + t42;
    const double t45 = t43 * motion->constants[28];
    const double t48 = sin_delta * motion->constants[26];
    const double t54 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const double t56 = (t29 * motion->constants[29]) - (t18 * t54);
    const double t59 = (cos_phi * t48) - (t40 * t45) - (sin_phi * t56);
    const double t60 = (motion->constants[25] * sin_phi) + t59;
    const double t61 = sin_delta * t37;
    const double t65 = (t29 * t35) + (t18 * t38);
    const double t67 = (cos_phi * t61) + (sin_phi * t65);
    const double t72 = (t45 * t67) + (t18 * motion->constants[29]) + (t29 * t54);
    const double t74 = 1.0 / (cos_phi * t72);
    const double t75 = t60 * t74;
    const double t81 = (t29 * motion->constants[24]) - (t18 * motion->constants[23]);
    const double t83 = t59 + (sin_phi * t81);
    const double t85 = sin_phi * t29;
    const double t88 = (t18 * motion->constants[24]) + (t29 * motion->constants[23]);
    const double t89 = t72 - t88;
    const double t92 = t74 * ((t18 * t83) + (t85 * t89));
    const double t94 = (speeds[0] * t75) + (speeds[1] * t92);
    const double t95 = speeds[2] + t94;
    const double t96 = t6 * t95;
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t100 = motion->constants[21] * speeds[0];
    const double t103 = (t96 * sin_psi) - (t100 * cos_psi);
    const double t104 = motion->constants[21] * sin_phi;
    const double t105 = t95 * t104;
    const double t107 = t6 * cos_psi;
    const double t108 = motion->constants[25] * cos_phi;
    const double t110 = t74 * t75;
    const double t111 = sin_phi * t72;
    const double t115 = (sin_phi * t48) + (cos_phi * t56);
    const double t116 = t18 * t75;
    const double t117 = sin_phi * motion->constants[29];
    const double t119 = t29 * t75;
    const double t120 = sin_phi * t54;
    const double t122 = t40 * motion->constants[28];
    const double t123 = cos_phi * cos_delta;
    const double t124 = t18 * sin_delta;
    const double t126 = cos_phi * sin_delta;
    const double t129 = t123 + (t119 * t126) - (sin_phi * t124);
    const double t134 = t18 * cos_delta;
    const double t135 = sin_phi * t134;
    const double t137 = t34 * t123;
    const double t139 = t34 * t34;
    const double t140 = t25 * t139;
    const double t143 = t34 * 0.5;
    const double t144 = (t25 + t25) * t143;
    const double t147 = t143 * (t30 + t30);
    const double t152 = cos_phi * t147;
    const double t154 = t123 * t144;
    const double t158 = (t126 * t144) - (sin_phi * ((t29 * t147) - (t134 * t144))) - (t116 * t152) -
        (t119 * t154);
    const double t162 = (t34 * t126) + (t34 * t135) - (t119 * t137) - (t140 * t158);
    const double t164 = cos_delta * t29;
    const double t166 = cos_phi * t34;
    const double t168 = t30 * t139;
    const double t171 = (t34 * t85) + (t116 * t166) + (t158 * t168);
    const double t175 = (t38 * t116) + (t35 * t119) + (t18 * t162) + (t164 * t171);
    const double t180 = (t116 * t117) + (t119 * t120) + (t45 * t175) - t115 - (t122 * t129);
    const double t182 = cos_phi * t110;
    const double t185 = motion->constants[28] * t67;
    const double t189 = sin_phi * t35;
    const double t191 = sin_phi * t38;
    const double t194 = t126 + t135;
    const double t200 = (cos_phi * t65) + (t119 * t191) + (t85 * t162) - (sin_phi * t61) - (t116 *
        t189) - (t171 * t194);
    const double t204 = (motion->constants[29] * t119) + (t129 * t185) + (t45 * t200) - (t54 *
        t116);
    const double t208 = (t74 * t108) + (t110 * t111) + (t74 * t180) - (t182 * t204);
    const double t210 = t29 * t89;
    const double t212 = t18 * t74;
    const double t216 = t74 * t92;
    const double t220 = t74 * t85;
    const double t222 = sin_phi * motion->constants[24];
    const double t225 = (sin_phi * t74 * t89) + (t212 * t222) - (motion->constants[23] * t220);
    const double t229 = sin_phi * motion->constants[23];
    const double t232 = (t74 * t83) - (motion->constants[24] * t220) - (t212 * t229);
    const double t236 = t220 - (cos_phi * t216);
    const double t240 = (cos_phi * ((t74 * t210) + (t81 * t212))) + (t111 * t216) + (t119 * t232) +
        (t180 * t212);
    const double t242 = t240 + (t204 * t236) - (t116 * t225);
    const double t244 = (speeds[0] * t208) + (speeds[1] * t242);
    const double t246 = (cos_psi * t105) - (t107 * t244);
    const double t248 = t18 * motion->constants[26];
    const double t250 = t18 * t92;
    const double t252 = t29 * t92;
    const double t255 = (t126 * t252) - t25;
    const double t257 = sin_delta * t29;
    const double t270 = (t41 * t144) + (t42 * t144) - (t152 * t250) - (t154 * t252);
    const double t274 = (t34 * t41) + (t34 * t42) - (t137 * t252) - (t140 * t270);
    const double t278 = (t166 * t250) + (t168 * t270);
    const double t283 = (t37 * t257) + (t38 * t250) + (t35 * t252) + (t18 * t274) + (t164 * t278);
    const double t289 = (motion->constants[26] * t123) + (t117 * t250) + (t120 * t252) + (t45 *
        t283) - (t24 * t248) - (t122 * t255);
    const double t306 = (t37 * t123) + (t191 * t252) + (t85 * t274) - (t18 * t24 * t37) - (t189 *
        t250) - (t194 * t278);
    const double t311 = (motion->constants[29] * t252) + (t185 * t255) + (t45 * t306) -
        (motion->constants[26] * t257) - (t54 * t250);
    const double t313 = (t74 * t289) - (t182 * t311);
    const double t321 = (t232 * t252) + (t212 * t289) + (t236 * t311) - (t225 * t250);
    const double t323 = (speeds[0] * t313) + (speeds[1] * t321);
    const double t333 = t6 * sin_psi;
    const double t335 = (sin_psi * t105) - (t244 * t333);
    const double t339 = (motion->constants[21] * cos_psi) - (t75 * t333);
    const double t343 = (t40 * t72) + (t60 * t67);
    const double t344 = 1.0 / t343;
    const double t345 = t67 * t344;
    const double t347 = t6 * t344;
    const double t349 = t67 * t347;
    const double t350 = t344 * t349;
    const double t359 = (t67 * t108) + (t60 * t200) + (t67 * t180) + (t40 * t204) - (t72 * t175);
    const double t362 = (t200 * t347) - (t104 * t345) - (t350 * t359);
    const double t364 = t75 * t344;
    const double t365 = sin_phi * t67;
    const double t370 = sin_phi * t60;
    const double t373 = sin_phi * t40;
    const double t377 = (cos_phi * (t343 + (motion->constants[25] * t365))) + (t200 * t370) +
        (t180 * t365) + (t204 * t373);
    const double t378 = t377 - (t111 * t175);
    const double t382 = (t40 * t111) + (t67 * t370);
    const double t383 = t344 * t382;
    const double t384 = t75 * t383;
    const double t385 = t344 * t384;
    const double t389 = (t364 * t378) + (t208 * t383) - (t359 * t385);
    const double t396 = t115 + motion->constants[22] + (t33 * motion->constants[28]) - (cos_phi *
        t81);
    const double t399 = (t29 * t396) + (t30 * t81);
    const double t401 = t40 * t344;
    const double t404 = (t85 * t345) - (t18 * t401);
    const double t409 = t29 * t83;
    const double t411 = t56 - t81;
    const double t418 = (cos_phi * t89) - (t30 * motion->constants[23]);
    const double t424 = (sin_phi * t396) + (cos_phi * t83) + (t30 * t222);
    const double t428 = (cos_phi * motion->constants[29]) - (cos_phi * motion->constants[24]);
    const double t431 = (t401 * t418) + (t345 * t424) + (t404 * t428);
    const double t434 = t396 + (t30 * motion->constants[24]);
    const double t436 = t30 * t229;
    const double t440 = (cos_phi * motion->constants[23]) - (cos_phi * t54);
    const double t443 = (t404 * t440) - (t401 * t434) - (t345 * t436);
    const double t445 = motion->constants[28] * t404;
    const double t449 = (t30 * t89) - (t18 * t396);
    const double t450 = t344 * t449;
    const double t454 = (t85 * t396) + (t30 * t83);
    const double t455 = t344 * t454;
    const double t457 = t30 * t345;
    const double t459 = t30 * t401;
    const double t461 = t92 * t344;
    const double t468 = t344 * ((t40 * t449) + (t67 * t454) + (t92 * t382));
    const double t469 = t344 * t468;
    const double t474 = (cos_phi * ((t345 * t399) + (t48 * t404))) + (t119 * t443) + (t158 * t445) +
        (t200 * t455);
    const double t479 = t474 + (t180 * t457) + (t204 * t459) + (t378 * t461) + (t242 * t383) -
        (sin_phi * ((t210 * t401) + (t345 * t409) + (t404 * t411)));
    const double t482 = t479 - (t116 * t431) - (t175 * t450) - (t359 * t469);
    const double t485 = (speeds[2] * t362) + (speeds[0] * t389) + (speeds[1] * t482);
    const double t493 = (t60 * t306) + (t67 * t289) + (t40 * t311) - (t72 * t283);
    const double t495 = (t306 * t347) - (t350 * t493);
    const double t503 = (t306 * t370) + (t289 * t365) + (t311 * t373) - (t111 * t283);
    const double t508 = (t364 * t503) + (t313 * t383) - (t385 * t493);
    const double t510 = motion->constants[26] * t41;
    const double t512 = t248 * t126;
    const double t528 = (t404 * t510) + (t404 * t512) + (t252 * t443) + (t270 * t445) + (t306 *
        t455) + (t289 * t457);
    const double t533 = t528 + (t311 * t459) + (t461 * t503) + (t321 * t383) - (t250 * t431) -
        (t283 * t450);
    const double t534 = t533 - (t469 * t493);
    const double t537 = (speeds[2] * t495) + (speeds[0] * t508) + (speeds[1] * t534);
    const double t540 = motion->constants[28] + (t33 * motion->constants[22]);
    const double t541 = 1.0 / t540;
    const double t546 = (t67 * t111) - (t40 * t370);
    const double t550 = (t67 * t72) - (t40 * t60);
    const double t555 = t541 * ((t40 * t454) + (t468 * t550) - (t67 * t449) - (t92 * t546));
    const double t556 = t541 * t555;
    const double t557 = motion->constants[22] * t556;
    const double t558 = speeds[1] * t557;
    const double t565 = t541 * ((t6 * t40) + (t349 * t550));
    const double t566 = motion->constants[22] * t541;
    const double t567 = t565 * t566;
    const double t569 = t6 * t541;
    const double t571 = t349 * t541;
    const double t580 = (t60 * t175) + (t72 * t200) + (t67 * t204) - (t40 * t108) - (t40 * t180);
    const double t582 = t541 * t550;
    const double t587 = (t571 * t580) + (t362 * t582) - (t40 * t104 * t541) - (t158 * t567) -
        (t175 * t569);
    const double t592 = t541 * ((t384 * t550) - (t75 * t546));
    const double t593 = t566 * t592;
    const double t595 = t75 * t541;
    const double t605 = (cos_phi * (t550 - (motion->constants[25] * t373))) + (t175 * t370) +
        (t111 * t200) + (t204 * t365);
    const double t606 = t605 - (t180 * t373);
    const double t608 = t384 * t541;
    const double t610 = t541 * t546;
    const double t616 = (t580 * t608) + (t389 * t582) - (t158 * t593) - (t595 * t606) - (t208 *
        t610);
    const double t618 = speeds[1] * t541;
    const double t622 = (t18 * t67) + (t40 * t85);
    const double t636 = (t40 * t424) + (t428 * t622) - (t67 * t418);
    const double t642 = (t67 * t434) + (t440 * t622) - (t40 * t436);
    const double t644 = motion->constants[28] * t622;
    const double t648 = t30 * t40;
    const double t650 = t30 * t67;
    const double t658 = (cos_phi * ((t40 * t399) + (t48 * t622))) + (t119 * t642) + (t158 * t644) +
        (t180 * t648);
    const double t662 = t658 + (t468 * t580) + (t482 * t550) - (sin_phi * ((t40 * t409) + (t411 *
        t622) - (t67 * t210))) - (t116 * t636);
    const double t667 = t662 - (t175 * t454) - (t200 * t449) - (t204 * t650) - (t92 * t606) -
        (t242 * t546);
    const double t671 = (speeds[2] * t587) + (speeds[0] * t616) + (t618 * t667) - (t158 * t558);
    const double t681 = (t60 * t283) + (t72 * t306) + (t67 * t311) - (t40 * t289);
    const double t686 = (t571 * t681) + (t495 * t582) - (t270 * t567) - (t283 * t569);
    const double t695 = (t283 * t370) + (t111 * t306) + (t311 * t365) - (t289 * t373);
    const double t703 = (t608 * t681) + (t508 * t582) - (t270 * t593) - (t595 * t695) - (t313 *
        t610);
    const double t722 = (t510 * t622) + (t512 * t622) + (t252 * t642) + (t270 * t644) + (t289 *
        t648) + (t468 * t681);
    const double t727 = t722 + (t534 * t550) - (t250 * t636) - (t283 * t454) - (t306 * t449) -
        (t311 * t650);
    const double t729 = t727 - (t92 * t695) - (t321 * t546);
    const double t733 = (speeds[2] * t686) + (speeds[0] * t703) + (t618 * t729) - (t270 * t558);
    const double t737 = sin_delta * motion->constants[45];
    const double t738 = sin_delta * t737;
    const double t742 = motion->constants[35] + motion->constants[40] + motion->constants[47] -
        t738;
    const double t744 = cos_delta * motion->constants[38];
    const double t745 = motion->constants[23] * t744;
    const double t748 = t745 + t745 + motion->constants[50];
    const double t751 = motion->constants[36] + motion->constants[43];
    const double t752 = t748 + t751;
    const double t753 = t752 - t742;
    const double t754 = t18 * t18;
    const double t756 = t18 * t29;
    const double t758 = motion->constants[24] * t744;
    const double t762 = cos_delta * motion->constants[41];
    const double t763 = motion->constants[32] + t762;
    const double t766 = t763 - motion->constants[48] - t758 - motion->constants[49];
    const double t767 = t766 + t766;
    const double t769 = (t753 * t754) + (t756 * t767);
    const double t770 = sin_delta * motion->constants[38];
    const double t771 = t104 * t770;
    const double t773 = t104 * motion->constants[51];
    const double t776 = (t104 * t773) - t771 - t771;
    const double t781 = t744 + motion->constants[30];
    const double t782 = motion->constants[46] + t781;
    const double t784 = (t29 * motion->constants[52]) - (t18 * t782);
    const double t785 = t6 * t784;
    const double t786 = t6 * motion->constants[51];
    const double t787 = t6 * t786;
    const double t789 = t787 - t785 - t785;
    const double t790 = sin_delta * motion->constants[41];
    const double t792 = t790 - (motion->constants[24] * t770);
    const double t796 = (cos_delta * t737) - (motion->constants[23] * t770);
    const double t800 = (t18 * motion->constants[52]) + (t29 * t782);
    const double t803 = (t18 * t792) + (t29 * t796) + (t104 * t800);
    const double t805 = t75 - (sin_phi * t384);
    const double t812 = t766 + (t753 * t756) + (t6 * t800) - (t754 * t767);
    const double t813 = cos_phi * t384;
    const double t821 = t738 + motion->constants[47] + t748 + t789 + motion->constants[33] +
        motion->constants[42];
    const double t831 = (t29 * t792) + (t104 * t784) + (t6 * t770) - (t18 * t796) - (t6 * t773);
    const double t838 = t752 + t776 - t769;
    const double t844 = t805 * motion->constants[18];
    const double t850 = t592 + (cos_delta * t805) - t257 - (t124 * t813);
    const double t852 = t850 * motion->constants[19];
    const double t859 = t742 + t769 + t776 + t789 + (t803 * t805) + (t805 * (t803 + (t805 * t821) -
        (t813 * t831))) + (t805 * t844);
    const double t862 = t859 + (t850 * t852) - (t812 * t813) - (t813 * (t812 + (t805 * t831) -
        (t813 * t838)));
    const double t863 = 1.0 / t862;
    const double t868 = (speeds[0] * t384) + (speeds[1] * t468) + (speeds[2] * t349);
    const double t869 = cos_phi * t868;
    const double t871 = speeds[0] * t18;
    const double t872 = t871 - (t29 * t869);
    const double t873 = speeds[0] * t29;
    const double t875 = t873 + (t18 * t869);
    const double t877 = motion->constants[32] * t872;
    const double t878 = (motion->constants[35] * t875) + t877;
    const double t880 = motion->constants[32] * t875;
    const double t882 = t880 + (motion->constants[36] * t872);
    const double t884 = (t872 * t878) - (t875 * t882);
    const double t886 = motion->constants[25] * speeds[0];
    const double t887 = t869 * t886;
    const double t888 = sin_phi * t868;
    const double t889 = t94 - t888;
    const double t890 = motion->constants[24] * t889;
    const double t892 = motion->constants[23] * t889;
    const double t894 = (t872 * t890) + (t875 * t892);
    const double t895 = speeds[0] * t888;
    const double t897 = t94 * t875;
    const double t898 = (t29 * t895) + t897;
    const double t901 = t94 * t872;
    const double t902 = (t18 * t895) + t901;
    const double t904 = t95 * t869;
    const double t906 = motion->constants[25] * t888;
    const double t907 = t869 * t906;
    const double t908 = t907 - (t6 * t904);
    const double t911 = t894 + (motion->constants[23] * t898) + (motion->constants[24] * t902) -
        t908;
    const double t914 = motion->constants[23] * t872;
    const double t915 = motion->constants[24] * t875;
    const double t916 = t914 - t915;
    const double t918 = (t889 * t892) + (t872 * t916);
    const double t919 = speeds[0] * t869;
    const double t922 = speeds[0] * t95;
    const double t923 = t895 + t922;
    const double t926 = t887 + (t6 * t919) + (t104 * t923);
    const double t930 = t95 - t888;
    const double t932 = (t906 * t930) - (speeds[0] * t886);
    const double t933 = (t104 * t904) + t932;
    const double t937 = (t29 * t926) + (t18 * t933) - t918 - (motion->constants[24] * t919);
    const double t939 = speeds[1] + t872;
    const double t943 = (cos_delta * t889) - (sin_delta * t875);
    const double t944 = motion->constants[27] * t943;
    const double t948 = (cos_delta * t875) + (sin_delta * t889);
    const double t949 = motion->constants[26] * t943;
    const double t954 = speeds[1] * t943;
    const double t956 = t954 - (cos_delta * t902) - (sin_delta * t919);
    const double t958 = t35 * t540;
    const double t963 = (speeds[0] * t592) + (speeds[1] * t555) + (speeds[2] * t565);
    const double t965 = t898 + (t948 * t963);
    const double t967 = t37 * t540;
    const double t969 = t956 - (t939 * t963);
    const double t971 = t34 * t43;
    const double t974 = (t35 * t948) + (t37 * t939);
    const double t976 = motion->constants[28] * t971 * t974;
    const double t977 = t37 * t976;
    const double t979 = t35 * t976;
    const double t985 = (cos_delta * t911) + (t939 * t944) + (t948 * t949) +
        (motion->constants[26] * t898) + (t958 * t965) + (t939 * t977);
    const double t989 = t985 + (t948 * t979) - (sin_delta * t937) - (motion->constants[27] * t956) -
        (t967 * t969);
    const double t994 = motion->constants[26] * t939;
    const double t995 = motion->constants[27] * t948;
    const double t996 = t994 - t995;
    const double t1000 = speeds[1] * t948;
    const double t1002 = (sin_delta * t902) - (cos_delta * t919) - t1000;
    const double t1005 = t43 * motion->constants[22];
    const double t1007 = t943 + t963;
    const double t1012 = motion->constants[28] * ((t35 * t939) - (t37 * t948));
    const double t1018 = (cos_delta * t937) + (sin_delta * t911) + (motion->constants[27] * t1002) +
        (t967 * t1002) - (t943 * t949) - (t939 * t996);
    const double t1021 = t1018 - (t965 * t1005) - (t979 * t1007) - (t939 * t1012);
    const double t1025 = (t875 * t916) - (t889 * t890);
    const double t1040 = t1025 + (motion->constants[23] * t919) + (t18 * t926) + (t948 * t996) +
        (t969 * t1005) + (t948 * t1012);
    const double t1045 = t1040 - (t29 * t933) - (t943 * t944) - (motion->constants[26] * t1002) -
        (t958 * t1002) - (t977 * t1007);
    const double t1047 = (t35 * t1021) + (t37 * t1045);
    const double t1052 = t74 * ((t43 * t989) + (t33 * t1047));
    const double t1056 = t344 * ((t33 * t989) + (t382 * t1052) - (t43 * t1047));
    const double t1058 = t919 - t1052;
    const double t1059 = (sin_phi * t1056) + t1058;
    const double t1062 = cos_phi * motion->constants[44];
    const double t1063 = t933 + t1062;
    const double t1067 = t895 - (cos_phi * t1056);
    const double t1071 = (t6 * t1059) + t887 + (t104 * (t922 + t1067));
    const double t1073 = (t29 * t1063) - (t18 * t1071);
    const double t1076 = t1025 - t1073 + (motion->constants[23] * t1059);
    const double t1081 = t901 + (t18 * t1067);
    const double t1084 = (sin_delta * t1081) - (cos_delta * t1059) - t1000;
    const double t1086 = motion->constants[38] * t939;
    const double t1088 = t948 * motion->constants[39];
    const double t1089 = t1086 - t1088;
    const double t1091 = t943 * motion->constants[39];
    const double t1093 = (t948 * t1089) - (t943 * t1091);
    const double t1095 = (t1076 * motion->constants[37]) + t1093 - (motion->constants[38] * t1084);
    const double t1099 = motion->constants[30] * t872;
    const double t1100 = t875 * motion->constants[31];
    const double t1101 = t1099 - t1100;
    const double t1103 = motion->constants[31] * t889;
    const double t1105 = (t875 * t1101) - (t889 * t1103);
    const double t1108 = t1095 + t1105 - (t1073 * motion->constants[34]) + (motion->constants[30] *
        t1059);
    const double t1112 = (t18 * t1063) + (t29 * t1071);
    const double t1115 = t1112 - (motion->constants[24] * t1059) - t918;
    const double t1118 = t897 + (t29 * t1067);
    const double t1121 = sin_phi * motion->constants[44];
    const double t1122 = t908 + t1121;
    const double t1125 = t894 + (motion->constants[23] * t1118) + (motion->constants[24] * t1081) -
        t1122;
    const double t1127 = (cos_delta * t1115) + (sin_delta * t1125);
    const double t1130 = motion->constants[38] * t943;
    const double t1133 = (t943 * t1130) + (t939 * t1089);
    const double t1135 = (t1127 * motion->constants[37]) + (motion->constants[39] * t1084) - t1133;
    const double t1139 = (cos_delta * t1125) - (sin_delta * t1115);
    const double t1145 = t954 - (sin_delta * t1059) - (cos_delta * t1081);
    const double t1149 = (t939 * t1091) + (t948 * t1130);
    const double t1152 = (t1139 * motion->constants[37]) + (motion->constants[38] * t1118) + t1149 -
        (motion->constants[39] * t1145);
    const double t1154 = (cos_delta * t1135) - (sin_delta * t1152);
    const double t1157 = motion->constants[30] * t889;
    const double t1160 = (t889 * t1157) + (t872 * t1101);
    const double t1163 = t1154 + (t1112 * motion->constants[34]) - (motion->constants[31] * t1059) -
        t1160;
    const double t1165 = (t18 * t1108) + (t29 * t1163);
    const double t1167 = (motion->constants[18] * t1059) + (t6 * t1165);
    const double t1168 = sin_phi * t349;
    const double t1175 = motion->constants[41] * t948;
    const double t1177 = t1175 + (motion->constants[43] * t939);
    const double t1181 = (motion->constants[42] * t943) + (motion->constants[19] * t1007);
    const double t1183 = (t943 * t1177) - (t939 * t1181);
    const double t1186 = (motion->constants[40] * t1145) + (motion->constants[41] * t1118) + t1183 -
        (motion->constants[39] * t1139);
    const double t1198 = t541 * ((t35 * t1045) + (t550 * t1056) - (t37 * t1021) - (t546 * t1052));
    const double t1200 = motion->constants[19] * (t1084 + t1198);
    const double t1202 = motion->constants[41] * t939;
    const double t1203 = (motion->constants[40] * t948) + t1202;
    const double t1206 = (t939 * t1203) - (t948 * t1177);
    const double t1210 = (motion->constants[39] * t1127) + (motion->constants[42] * t1084) + t1200 +
        t1206 - (motion->constants[38] * t1076);
    const double t1218 = t884 + (motion->constants[31] * t1112) + (motion->constants[30] * t1073) -
        (motion->constants[33] * t1059) + (sin_delta * t1186) + (cos_delta * t1210);
    const double t1221 = t1218 + (motion->constants[24] * t1154) - t1167 - (motion->constants[23] *
        t1095);
    const double t1223 = cos_phi * t349;
    const double t1230 = (motion->constants[33] * t889) + (motion->constants[18] * (speeds[2] +
        t889));
    const double t1233 = (t875 * t1230) - (t878 * t889);
    const double t1239 = (t948 * t1181) - (t943 * t1203);
    const double t1242 = (motion->constants[38] * t1139) + (motion->constants[41] * t1145) +
        (motion->constants[43] * t1118) + t1239;
    const double t1245 = (sin_delta * t1135) + (cos_delta * t1152);
    const double t1251 = (motion->constants[36] * t1118) + t1233 + t1242 + (motion->constants[23] *
        t1245) - (motion->constants[30] * t1122) - (motion->constants[32] * t1081);
    const double t1258 = (t882 * t889) - (t872 * t1230);
    const double t1266 = (motion->constants[31] * t1122) + (motion->constants[32] * t1118) + t1258 +
        (cos_delta * t1186) - (motion->constants[35] * t1081) - (sin_delta * t1210);
    const double t1267 = t1266 - (motion->constants[24] * t1245);
    const double t1271 = (t29 * t1251) + (t104 * t1165) - (t18 * t1267);
    const double t1286 = (t872 * t1103) + (t875 * t1157);
    const double t1291 = t6 * (t1245 + (motion->constants[30] * t1118) + (motion->constants[31] *
        t1081) + t1286 - (t1122 * motion->constants[34]));
    const double t1297 = forces[0] + (t104 * ((t29 * t1108) - (t18 * t1163))) + (t813 * t1271) -
        (t18 * t1251);
    const double t1301 = t1297 - (t29 * t1267) - t1291 - (t805 * t1221) - (t592 * t1200);
    const double t1305 = t6 * (t784 - t786);
    const double t1309 = t1305 + (t821 * t1168) + (t831 * t1223);
    const double t1312 = t6 * (t770 - t773);
    const double t1316 = t1312 - (t831 * t1168) - (t838 * t1223);
    const double t1318 = 1.0 - t1168;
    const double t1323 = (t124 * t1223) + (cos_delta * t1168) - t565;
    const double t1329 = (t844 * t1318) - (t803 * t1168) - (t812 * t1223) - (t805 * t1309) - (t813 *
        t1316) - (t852 * t1323);
    const double t1330 = t863 * t1329;
    const double t1332 = t29 * t770;
    const double t1333 = t6 * t1332;
    const double t1334 = sin_phi * t468;
    const double t1335 = t92 - t1334;
    const double t1337 = cos_phi * t468;
    const double t1339 = t792 + t1333;
    const double t1341 = t745 + motion->constants[43];
    const double t1343 = t762 - t758;
    const double t1347 = (t29 * t1341) - (t18 * t1343) - (t104 * t1332);
    const double t1349 = motion->constants[18] * t1335;
    const double t1354 = (t124 * t1337) - t555 - (cos_delta * t1335);
    const double t1355 = motion->constants[19] * t1354;
    const double t1359 = t18 * t770;
    const double t1367 = t1339 + (t821 * t1335) - (t831 * t1337);
    const double t1372 = t1347 + (t831 * t1335) - (t838 * t1337);
    const double t1380 = (t18 * t1341) + (t29 * t1343) + (t6 * t744) + (t803 * t1335) + (t805 *
        t1367) + (t844 * t1335);
    const double t1385 = t863 * (t1380 - (t104 * t1359) - (t812 * t1337) - (t813 * t1372) - (t852 *
        t1354));
    const double t1386 = t862 * t1385;
    const double t1392 = t1333 + (t1318 * t1349) + (t1323 * t1355) - (t1309 * t1335) - (t1316 *
        t1337) - (t1168 * t1339);
    const double t1406 = motion->constants[43] + (t1335 * t1367) + (t1335 * t1339) + (t1335 *
        t1349) + (t1354 * t1355) - (t1337 * t1372);
    const double t1408 = t1406 - (t1337 * t1347) - (t1385 * t1386);
    const double t1409 = 1.0 / t1408;
    const double t1410 = (t1392 - (t1223 * t1347) - (t1330 * t1386)) * t1409;
    const double t1420 = forces[1] + (t1271 * t1337) - t1242 - (t1221 * t1335) - (t555 * t1200) -
        (t1301 * t1385);
    const double t1426 = (t1168 * t1221) + (t1223 * t1271) + t1167 - (t565 * t1200) - (t1301 *
        t1330) - (t1410 * t1420);
    const double t1433 = motion->constants[19] * t1323;
    const double t1443 = t787 + (t1168 * t1309) + (t1168 * t1305) + (motion->constants[18] * t1318 *
        t1318) + (t1323 * t1433) - (t1223 * t1316);
    const double t1447 = 1.0 / (t1443 - (t1223 * t1312) - (t862 * t1330 * t1330) - (t1408 * t1410 *
        t1410));
    const double t1448 = t1426 * t1447;
    const double t1452 = (t1409 * t1420) - (t1410 * t1448);
    const double t1456 = (t863 * t1301) - (t1385 * t1452) - (t1330 * t1448);
    const double t1464 = t1056 + (t384 * t1456) + (t468 * t1452) + (t349 * t1448);
    const double t1465 = sin_phi * t1464;
    const double t1468 = (t75 * t1456) + (t92 * t1452) - t1465 - t1058;
    const double t1469 = t1448 + t1468;
    const double t1471 = cos_phi * t1464;
    const double t1472 = t895 - t1471;
    const double t1473 = t922 + t1472;
    const double t1476 = (t6 * t1469) - t887 - (t104 * t1473);
    const double t1478 = t904 + t1456;
    const double t1481 = t932 + t1062 + (t104 * t1478);
    const double t1483 = (t18 * t1481) - (t29 * t1476);
    const double t1487 = (t29 * t1481) + (t18 * t1476);
    const double t1494 = t897 + (t29 * t1472) + (t18 * t1456);
    const double t1499 = (t29 * t1456) - t901 - (t18 * t1472);
    const double t1503 = t907 + t1121 - (t6 * t1478);
    const double t1506 = t894 + (motion->constants[23] * t1494) - (motion->constants[24] * t1499) -
        t1503;
    const double t1510 = t1483 + (motion->constants[24] * t1468) - t918;
    const double t1512 = (cos_delta * t1506) - (sin_delta * t1510);
    const double t1516 = (cos_delta * t1499) + (sin_delta * t1468);
    const double t1517 = t954 + t1516;
    const double t1519 = t1452 + t1494;
    const double t1523 = t1183 + (motion->constants[40] * t1517) + (motion->constants[41] * t1519) -
        (motion->constants[39] * t1512);
    const double t1527 = (cos_delta * t1510) + (sin_delta * t1506);
    const double t1531 = t1025 - t1487 - (motion->constants[23] * t1468);
    const double t1535 = (cos_delta * t1468) - (sin_delta * t1499);
    const double t1536 = t1535 - t1000;
    const double t1545 = motion->constants[19] * (t1198 + t1536 + (t592 * t1456) + (t555 * t1452) +
        (t565 * t1448));
    const double t1549 = t1206 + (motion->constants[39] * t1527) + (motion->constants[42] * t1536) +
        t1545 - (motion->constants[38] * t1531);
    const double t1551 = (sin_delta * t1523) + (cos_delta * t1549);
    const double t1555 = (motion->constants[37] * t1527) + (motion->constants[39] * t1536) - t1133;
    const double t1562 = t1149 + (motion->constants[37] * t1512) + (motion->constants[38] * t1519) -
        (motion->constants[39] * t1517);
    const double t1564 = (cos_delta * t1555) - (sin_delta * t1562);
    const double t1569 = t1093 + (motion->constants[37] * t1531) - (motion->constants[38] * t1536);
    const double t1575 = t1105 + t1569 - (motion->constants[34] * t1487) - (motion->constants[30] *
        t1468);
    const double t1581 = t1564 + (motion->constants[34] * t1483) + (motion->constants[31] * t1468) -
        t1160;
    const double t1583 = (t18 * t1575) + (t29 * t1581);
    const double t1589 = t884 + (motion->constants[31] * t1483) + (motion->constants[30] * t1487) +
        (motion->constants[33] * t1468) + (motion->constants[18] * t1469) + t1551;
    const double t1592 = t1589 + (motion->constants[24] * t1564) - (motion->constants[23] * t1569) -
        (t6 * t1583);
    const double t1608 = (sin_delta * t1555) + (cos_delta * t1562);
    const double t1615 = t1233 + t1239 + (motion->constants[32] * t1499) + (motion->constants[36] *
        t1494) + (motion->constants[38] * t1512) + (motion->constants[41] * t1517) +
        (motion->constants[43] * t1519);
    const double t1617 = t1615 + (motion->constants[23] * t1608) - (motion->constants[30] * t1503);
    const double t1624 = (cos_delta * t1523) - (sin_delta * t1549);
    const double t1630 = t1258 + (motion->constants[31] * t1503) + (motion->constants[35] * t1499) +
        (motion->constants[32] * t1494) + t1624 - (motion->constants[24] * t1608);
    const double t1634 = (t29 * t1617) + (t104 * t1583) - (t18 * t1630);
    const double t1644 = (t384 * t1634) - (motion->constants[21] * (t1286 + t1608 +
        (motion->constants[30] * t1494) - (motion->constants[34] * t1503) - (motion->constants[31] *
        t1499)));
    const double t1647 = (t104 * t1575) - t1630;
    const double t1650 = t1617 + (t104 * t1581);
    const double t1655 = (sin_phi * t1592) + (cos_phi * t1634);
    const double t1658 = motion->constants[21] * t1583;
    const double t1663 = (cos_phi * t1658) - (t116 * t1617) - (t119 * t1630);
    const double t1665 = sin_phi * t1658;
    const double t1669 = (t119 * t1575) - (t116 * t1581);
    const double t1672 = (t104 * t813) + (t6 * t805);
    const double t1674 = t344 * t1047;
    const double t1675 = t541 * motion->constants[19];
    const double t1676 = t550 * t1675;
    const double t1677 = t1674 * t1676;
    const double t1680 = motion->constants[19] * t1452;
    const double t1684 = t344 * t989;
    const double t1686 = (t1676 * t1684) - (motion->constants[22] * ((t1198 * t1675) + (t556 *
        t1680)));
    const double t1689 = t43 * t344;
    const double t1690 = t1021 * t1689;
    const double t1692 = (t1045 * t1675) - (t1676 * t1690);
    const double t1695 = t1045 * t1689;
    const double t1697 = (t1021 * t1675) + (t1676 * t1695);
    const double t1699 = t1052 * t1675;
    const double t1701 = t344 * t1052;
    const double t1702 = t1676 * t1701;
    const double t1704 = t1056 * t1675;
    const double t1706 = t344 * t1056;
    const double t1707 = t1676 * t1706;
    const double t1709 = motion->constants[19] * t1448;
    const double t1711 = motion->constants[19] * t1456;
    const double t1713 = t541 * t1680;
    const double t1719 = (t158 * t1686) + (t162 * t1692) + (t171 * t1697) + (t378 * t1702) + (t580 *
        t1704) + (t587 * t1709);
    const double t1724 = t1719 + (t616 * t1711) + (t667 * t1713) - (t129 * t1677) - (t606 * t1699) -
        (t359 * t1707);
    const double t1726 = motion->constants[21] * t1478;
    const double t1729 = (motion->constants[25] * t930) - t906;
    const double t1730 = t18 * t1729;
    const double t1734 = (motion->constants[21] * t1473) + (t6 * t1464);
    const double t1740 = t18 * t105;
    const double t1744 = t886 + (t6 * speeds[0]);
    const double t1746 = (motion->constants[21] * t1469) - (t868 * t1744);
    const double t1753 = t6 * t1456;
    const double t1754 = t29 * t1753;
    const double t1756 = t6 * t1452;
    const double t1757 = t29 * t1756;
    const double t1760 = (cos_phi * ((t18 * t1726) + (t868 * t1730) + (t29 * t1734))) + (t116 *
        t1476) + (t119 * t1481);
    const double t1762 = t1760 - (sin_phi * ((t18 * motion->constants[44]) + (t868 * t1740) - (t29 *
        t1746))) - (t208 * t1754);
    const double t1763 = t1762 - (t242 * t1757);
    const double t1764 = t18 * t104;
    const double t1767 = t29 * motion->constants[34];
    const double t1769 = cos_delta * motion->constants[39];
    const double t1770 = sin_delta * t1769;
    const double t1772 = cos_delta * motion->constants[37];
    const double t1773 = sin_delta * t1772;
    const double t1774 = t81 - t6;
    const double t1778 = (t18 * t1770) + (t88 * t1773);
    const double t1780 = cos_delta * t1769;
    const double t1782 = cos_delta * t1772;
    const double t1786 = (t29 * t1672) - t1764 - (motion->constants[24] * t805);
    const double t1795 = (t29 * motion->constants[38]) + (t18 * t1769) + (t88 * t1772);
    const double t1797 = sin_delta * motion->constants[39];
    const double t1799 = sin_delta * motion->constants[37];
    const double t1805 = (t29 * t1769) + (t1772 * t1774) + (t813 * t1795) + (t805 * t1797) - (t18 *
        motion->constants[38]) - (t1786 * t1799);
    const double t1811 = (t29 * t1770) + (t1773 * t1774) + (t813 * t1778) + (t1782 * t1786) -
        (t805 * t1780) - (sin_delta * t1805);
    const double t1814 = (t1672 * t1767) + t1811 - (motion->constants[34] * t1764) - (t805 *
        motion->constants[31]);
    const double t1817 = t29 * t1729;
    const double t1824 = t29 * t105;
    const double t1832 = t18 * t1753;
    const double t1834 = t18 * t1756;
    const double t1837 = (cos_phi * ((t29 * t1726) + (t868 * t1817) - (t18 * t1734))) + (t119 *
        t1476) + (t208 * t1832);
    const double t1840 = t1837 + (t242 * t1834) - (sin_phi * ((t29 * motion->constants[44]) +
        (t868 * t1824) + (t18 * t1746))) - (t116 * t1481);
    const double t1841 = t29 * t104;
    const double t1845 = t18 * motion->constants[34];
    const double t1850 = t1841 + (motion->constants[23] * t805) + (t18 * t1672);
    const double t1856 = t1332 + (t813 * t1359) - (motion->constants[34] * t1841) - (t781 * t805) -
        (t1672 * t1845) - (motion->constants[37] * t1850);
    const double t1858 = motion->constants[25] * t869;
    const double t1859 = t868 * t1858;
    const double t1862 = t96 - t906;
    const double t1866 = (cos_phi * (motion->constants[44] + t1859)) + (sin_phi * (t1726 + (t868 *
        t1862)));
    const double t1870 = (t29 * motion->constants[30]) + (t18 * motion->constants[31]);
    const double t1872 = sin_delta * t1797;
    const double t1874 = sin_delta * t1799;
    const double t1878 = (t18 * t1872) + (t88 * t1874);
    const double t1880 = cos_delta * t1797;
    const double t1882 = cos_delta * t1799;
    const double t1889 = (t29 * t1872) + (t1774 * t1874) + (t813 * t1878) + (t1786 * t1882) +
        (cos_delta * t1805) - (t805 * t1880);
    const double t1892 = (t29 * motion->constants[31]) - (t18 * motion->constants[30]);
    const double t1895 = (t6 * motion->constants[34]) - (t813 * t1870) - t1889 - t1892;
    const double t1899 = (t119 * t1456) - (t116 * t1472);
    const double t1908 = (t29 * t751) + (t88 * t744) - (t18 * t763);
    const double t1917 = (t744 * t1774) + (t813 * t1908) + (motion->constants[23] * t1889) - (t6 *
        motion->constants[30]) - (t18 * t751) - (t29 * t763);
    const double t1919 = t1917 - (t790 * t805) - (t770 * t1786);
    const double t1921 = speeds[0] * t868;
    const double t1927 = (sin_phi * t1921) + (t208 * t1456) + (t242 * t1452) - t1471;
    const double t1930 = motion->constants[23] * motion->constants[38];
    const double t1931 = sin_delta * t1930;
    const double t1933 = t18 * t1931;
    const double t1935 = motion->constants[33] + motion->constants[18];
    const double t1937 = t1935 + (cos_delta * t1930);
    const double t1942 = sin_delta * motion->constants[42];
    const double t1947 = (t18 * t1942) + (t88 * t1797);
    const double t1949 = cos_delta * motion->constants[42];
    const double t1957 = (t29 * t1942) + (t1774 * t1797) + (t813 * t1947) + (t1769 * t1786) - t852 -
        (t805 * t1949);
    const double t1958 = t1957 - (motion->constants[38] * t1850);
    const double t1961 = cos_delta * motion->constants[40];
    const double t1968 = (t29 * motion->constants[41]) - (t18 * t1961) - (t88 * t1769);
    const double t1970 = sin_delta * motion->constants[40];
    const double t1977 = (t813 * t1968) + (t1786 * t1797) - (t18 * motion->constants[41]) - (t29 *
        t1961) - (t1769 * t1774) - (t805 * t1970);
    const double t1983 = (t29 * t1931) + (t813 * t1933) + (t1672 * t1892) + (motion->constants[24] *
        t1811) + (cos_delta * t1958) + (sin_delta * t1977);
    const double t1987 = t1983 - (motion->constants[31] * t1764) - (motion->constants[30] * t1841) -
        (t805 * t1937) - (motion->constants[46] * t1850);
    const double t1991 = (t116 * t1456) + (t119 * t1472);
    const double t1997 = (t29 * motion->constants[32]) - (t18 * motion->constants[35]);
    const double t2006 = (t6 * motion->constants[31]) + (t813 * t1997) + (cos_delta * t1977) -
        (t18 * motion->constants[32]) - (t29 * motion->constants[35]) - (motion->constants[24] *
        t1889);
    const double t2007 = t2006 - (sin_delta * t1958);
    const double t2010 = t1465 + (cos_phi * t1921);
    const double t2017 = (t1814 * t1841) + (t29 * t1919) - (t1764 * t1856) - (t18 * t2007);
    const double t2032 = (t158 * t1684) + (t171 * t1695) + (t378 * t1701) + (t362 * t1448) + (t389 *
        t1456) + (t482 * t1452);
    const double t2035 = t2032 - (t129 * t1674) - (t162 * t1690) - (t359 * t1706);
    const double t2036 = t6 * sin_phi;
    const double t2037 = t29 * t2036;
    const double t2039 = t18 * t2036;
    const double t2045 = (t1814 * t2037) - (t1856 * t2039) - (sin_phi * t1987) - (cos_phi * t2017);
    const double t2047 = t74 * t1052;
    const double t2049 = t74 * t989;
    const double t2051 = t74 * t1047;
    const double t2053 = t33 * t74;
    const double t2054 = t1021 * t2053;
    const double t2056 = t1045 * t2053;
    const double t2058 = cos_phi * t2047;
    const double t2064 = (t111 * t2047) + (t129 * t2049) + (t158 * t2051) + (t162 * t2054) - (t171 *
        t2056) - (t204 * t2058);
    const double t2067 = (t383 * t1676) - (t546 * t1675);
    const double t2069 = t6 * t29;
    const double t2071 = t6 * t18;
    const double t2077 = t1987 + (t1856 * t2071) + (t383 * t2045) - (t850 * t2067) - (t1814 *
        t2069);
    const double t2079 = motion->constants[21] * t904;
    const double t2081 = motion->constants[21] * t923;
    const double t2083 = speeds[0] * t104;
    const double t2084 = t18 * t2083;
    const double t2085 = t2084 - t1817;
    const double t2090 = motion->constants[21] * t919;
    const double t2093 = motion->constants[23] + t2071;
    const double t2095 = sin_delta * t1005;
    const double t2097 = motion->constants[26] + t958;
    const double t2098 = speeds[0] * cos_delta;
    const double t2103 = (t18 * t886) + (speeds[0] * t2093) + (t2097 * t2098) - t1824 - (speeds[0] *
        t2095);
    const double t2109 = motion->constants[22] * t969;
    const double t2111 = motion->constants[22] * t1002;
    const double t2112 = t35 * t2111;
    const double t2114 = t540 * t1002;
    const double t2115 = motion->constants[28] * t948;
    const double t2117 = (t939 * t2115) - t2114;
    const double t2119 = t976 * t1007;
    const double t2121 = t2119 + (t948 * t2115);
    const double t2124 = (cos_phi * ((t18 * t2081) + (t868 * t2085) - (t29 * t2079))) + (t116 *
        t933) + (t119 * t926);
    const double t2129 = t2124 + (t129 * t2109) + (t162 * t2117) + (t171 * t2121) - (sin_phi *
        ((t18 * t2090) + (t868 * t2103))) - (t158 * t2112);
    const double t2131 = t37 * t1689;
    const double t2133 = (t35 * t1675) - (t1676 * t2131);
    const double t2136 = t37 * t2053;
    const double t2139 = (t2077 * t2136) - (t850 * t2133) - (t2045 * t2131);
    const double t2142 = t868 * t873;
    const double t2144 = t2097 + (cos_delta * motion->constants[23]);
    const double t2148 = t29 * t2083;
    const double t2149 = t1730 + t2148;
    const double t2152 = (t18 * t2079) + (t29 * t2081) + (t868 * t2149);
    const double t2158 = motion->constants[27] + t967;
    const double t2159 = sin_delta * t2158;
    const double t2162 = (speeds[0] * t2159) + (cos_delta * t1862);
    const double t2166 = t2069 - motion->constants[24];
    const double t2169 = t1740 + (t29 * t886) + (speeds[0] * t2166);
    const double t2171 = (t29 * t2090) + (t868 * t2169);
    const double t2178 = (t895 * t2144) - (sin_delta * t926);
    const double t2180 = sin_delta * t933;
    const double t2185 = motion->constants[22] * ((t35 * t965) - (t37 * t969));
    const double t2189 = (t540 * t965) + (t948 * t976);
    const double t2193 = (t939 * t976) - (t540 * t969);
    const double t2196 = (cos_phi * ((t2142 * t2144) - (cos_delta * t1859) - (sin_delta * t2152))) +
        (t158 * t2185) + (t162 * t2189);
    const double t2198 = t2196 - (sin_phi * ((cos_delta * t2079) + (t868 * t2162) - (sin_delta *
        t2171))) - (t116 * t2178);
    const double t2200 = t2198 - (t119 * t2180) - (t171 * t2193);
    const double t2201 = t33 * t344;
    const double t2202 = t1676 * t2201;
    const double t2205 = t43 * t74;
    const double t2208 = (t2045 * t2201) + (t2077 * t2205) - (t850 * t2202);
    const double t2212 = (sin_delta * motion->constants[23]) - t1005;
    const double t2221 = (sin_delta * t1862) - (t2098 * t2158);
    const double t2229 = (t895 * t2212) + (cos_delta * t926);
    const double t2231 = cos_delta * t933;
    const double t2233 = motion->constants[22] * t965;
    const double t2235 = t37 * t2111;
    const double t2237 = motion->constants[28] * t939;
    const double t2239 = t2119 + (t939 * t2237);
    const double t2242 = t2114 + (t948 * t2237);
    const double t2245 = (cos_phi * ((t2142 * t2212) + (cos_delta * t2152) - (sin_delta * t1859))) +
        (t119 * t2231) + (t158 * t2235);
    const double t2247 = t2245 - (sin_phi * ((sin_delta * t2079) + (t868 * t2221) + (cos_delta *
        t2171))) - (t116 * t2229);
    const double t2250 = t2247 - (t129 * t2233) - (t162 * t2239) - (t171 * t2242);
    const double t2252 = t35 * t1689;
    const double t2254 = (t37 * t1675) + (t1676 * t2252);
    const double t2257 = t35 * t2053;
    const double t2260 = (t850 * t2254) + (t2077 * t2257) - (t2045 * t2252);
    const double t2262 = t34 * t974;
    const double t2264 = t971 * t2262;
    const double t2266 = t948 * t971;
    const double t2268 = t939 * t971;
    const double t2272 = (t129 * t2262) + (t162 * t2266) - (t158 * t2264) - (t171 * t2268);
    const double t2273 = t37 * motion->constants[28];
    const double t2274 = t1007 * t2273;
    const double t2277 = t35 * motion->constants[28];
    const double t2279 = (t939 * t2273) + (t948 * t2277);
    const double t2281 = t1007 * t2277;
    const double t2284 = (t2208 * t2279) - (t2139 * t2274) - (t2260 * t2281);
    const double t2288 = (t869 * t871) + (t119 * t895);
    const double t2291 = (cos_delta * t1005) + (sin_delta * t2097);
    const double t2295 = (cos_delta * t2158) + (cos_delta * motion->constants[24]);
    const double t2298 = t2159 + (sin_delta * motion->constants[24]);
    const double t2301 = (t2208 * t2295) + (t2260 * t2298) - (t2139 * t2291);
    const double t2303 = t872 * motion->constants[31];
    const double t2304 = motion->constants[30] * t875;
    const double t2307 = t1157 + t1157;
    const double t2309 = t1103 + t1103;
    const double t2312 = (t875 * t1935) - t878;
    const double t2315 = t890 + t890;
    const double t2316 = motion->constants[38] * t2315;
    const double t2319 = t882 - (t872 * t1935) - (sin_delta * t2316);
    const double t2323 = (t29 * t2312) - (t18 * t2319);
    const double t2325 = cos_delta * t2316;
    const double t2329 = (t29 * t2307) + (t18 * t2309);
    const double t2331 = motion->constants[37] * t2315;
    const double t2333 = motion->constants[24] * t872;
    const double t2334 = motion->constants[23] * t875;
    const double t2335 = t2333 + t2334;
    const double t2337 = t892 + t892;
    const double t2342 = (cos_delta * t2335) + (sin_delta * t2337);
    const double t2346 = (sin_delta * t2335) - (cos_delta * t2337);
    const double t2349 = motion->constants[19] * t948;
    const double t2351 = (motion->constants[42] * t948) + t2349 - t1203;
    const double t2354 = motion->constants[19] * t939;
    const double t2356 = t1177 - (motion->constants[42] * t939) - t2354;
    const double t2357 = cos_delta * t2356;
    const double t2359 = t939 * motion->constants[39];
    const double t2360 = motion->constants[38] * t948;
    const double t2361 = t2359 + t2360;
    const double t2363 = t1130 + t1130;
    const double t2365 = (cos_delta * t2361) - (sin_delta * t2363);
    const double t2371 = (t29 * t2351) + (t88 * t2365) - (t18 * t2357);
    const double t2373 = sin_delta * t2356;
    const double t2377 = (sin_delta * t2361) + (cos_delta * t2363);
    const double t2379 = t1091 + t1091;
    const double t2383 = t944 + t977;
    const double t2385 = (speeds[1] * t1005) - t944 - t2383;
    const double t2387 = motion->constants[26] * t948;
    const double t2390 = (t939 * motion->constants[27]) - (speeds[1] * t2158);
    const double t2391 = t2387 + t2390;
    const double t2393 = t949 + t979;
    const double t2394 = t949 + t2393;
    const double t2400 = (t1774 * t2365) + (t813 * t2371) + (speeds[1] * t1977) + (t2139 * t2385) +
        (t2208 * t2391) - (t18 * t2351);
    const double t2405 = t2400 - (t29 * t2357) - (t805 * t2373) - (t1786 * t2377) - (t1850 *
        t2379) - (t2260 * t2394);
    const double t2408 = t1181 - (motion->constants[40] * t943);
    const double t2410 = motion->constants[41] * t943;
    const double t2414 = (motion->constants[40] * t939) - t1175 - t1177;
    const double t2416 = (cos_delta * t2410) - (sin_delta * t2414);
    const double t2420 = (cos_delta * t1130) + (sin_delta * t2359);
    const double t2426 = (t29 * t2408) + (t88 * t2420) - (t18 * t2416);
    const double t2430 = (sin_delta * t2410) + (cos_delta * t2414);
    const double t2434 = (cos_delta * t2359) - (sin_delta * t1130);
    const double t2436 = t1089 - t1088;
    const double t2441 = t996 + t1012;
    const double t2444 = (speeds[1] * t2097) + t2441 - t995 - (t37 * t2115);
    const double t2447 = t2393 + (t958 * t963);
    const double t2449 = t963 * t1005;
    const double t2452 = t2390 + (t37 * t2237) - t2449;
    const double t2454 = t35 * t971;
    const double t2460 = (t1774 * t2420) + (t813 * t2426) + (t1786 * t2434) + (t1850 * t2436) +
        (t2139 * t2444) + (t2208 * t2447);
    const double t2465 = t2460 + (t2260 * t2452) + (t2284 * t2454) - (t18 * t2408) - (t29 * t2416) -
        (t805 * t2430);
    const double t2466 = t2465 - (speeds[1] * t1958);
    const double t2472 = (t1764 * t2307) + (t813 * t2323) + (t1889 * t2335) + (t2208 * t2342) +
        (t2260 * t2346) + (cos_delta * t2405);
    const double t2477 = t2472 + (sin_delta * t2466) - (t6 * (t2303 + t2304)) - (t1841 * t2309) -
        (t18 * t2312) - (t29 * t2319);
    const double t2482 = t2477 - (t805 * t2325) - (t1672 * t2329) - (t1850 * t2331) - (t1811 *
        t2337) - (t2139 * t2315);
    const double t2484 = t18 * t888;
    const double t2488 = (t119 * t869) - t2484 - (speeds[0] * t116);
    const double t2491 = t1101 - t1100;
    const double t2494 = t1230 - (motion->constants[35] * t889);
    const double t2496 = motion->constants[32] * t889;
    const double t2497 = t916 - t915;
    const double t2498 = motion->constants[38] * t2497;
    const double t2500 = t2496 + (sin_delta * t2498);
    const double t2504 = (t29 * t2494) - (t18 * t2500);
    const double t2510 = (motion->constants[35] * t872) - t880 - t882 - (cos_delta * t2498);
    const double t2514 = (t29 * t2303) + (t18 * t2491);
    const double t2516 = motion->constants[37] * t2497;
    const double t2526 = (cos_delta * t892) + (t94 * t2144) - (sin_delta * t2333);
    const double t2532 = (sin_delta * t892) + (t94 * t2212) + (cos_delta * t2333);
    const double t2540 = (t1841 * t2491) + (t813 * t2504) + (t1672 * t2514) + (t1850 * t2516) +
        (t892 * t1889) + (t1811 * t2333);
    const double t2545 = t2540 + (t94 * t1919) + (t2139 * t2497) + (t2208 * t2526) + (t2260 *
        t2532) + (cos_delta * t2466);
    const double t2550 = t2545 - (t6 * t1157) - (t1764 * t2303) - (t18 * t2494) - (t29 * t2500) -
        (t805 * t2510);
    const double t2551 = t2550 - (sin_delta * t2405);
    const double t2557 = (t85 * t868) + (t116 * t869) + (speeds[0] * t119);
    const double t2559 = t1099 + t1101;
    const double t2562 = t2410 + t2496;
    const double t2566 = (motion->constants[43] * t943) - t1181;
    const double t2567 = cos_delta * t2566;
    const double t2570 = t1202 + t1203 - (motion->constants[43] * t948);
    const double t2572 = t2570 - (motion->constants[38] * t2334);
    const double t2576 = (motion->constants[36] * t889) + t2567 - t1230 - (sin_delta * t2572);
    const double t2581 = t1086 + t1089;
    const double t2583 = (cos_delta * t1091) - (sin_delta * t2581);
    const double t2584 = t88 * t2583;
    const double t2586 = t2584 - (t29 * t2562) - (t18 * t2576);
    const double t2589 = sin_delta * t2566;
    const double t2594 = t877 + t878 + t2589 + (cos_delta * t2572) - (motion->constants[36] * t875);
    const double t2598 = (t18 * t2304) - (t29 * t2559);
    const double t2601 = t2360 + (motion->constants[37] * t2334);
    const double t2604 = t914 + t916;
    const double t2609 = t2387 + (t35 * t2115) - t2449;
    const double t2610 = t2334 + t2609;
    const double t2614 = t2383 + (t963 * t967);
    const double t2617 = (cos_delta * t890) + t2614 + (sin_delta * t2604);
    const double t2622 = t994 + t2441 + (t35 * t2237);
    const double t2625 = (sin_delta * t890) - t2622 - (cos_delta * t2604);
    const double t2628 = t37 * t971;
    const double t2633 = (sin_delta * t1091) + (cos_delta * t2581);
    const double t2636 = (t2284 * t2628) + (t1774 * t2583) - (t1786 * t2633);
    const double t2641 = (t1764 * t2559) + (t1841 * t2304) + (t18 * t2562) + (t813 * t2586) +
        (t1672 * t2598) + (t1850 * t2601);
    const double t2646 = t2641 + (t890 * t1889) + (t2139 * t2610) + (t2208 * t2617) + (t2260 *
        t2625) + (t94 * t2301);
    const double t2652 = t2646 + t2636 - (t6 * t1103) - (t29 * t2576) - (t805 * t2594) - (t1811 *
        t2604) - (t94 * t2007);
    const double t2655 = cos_delta * t2354;
    const double t2659 = (t29 * t2349) + (t18 * t2655);
    const double t2661 = sin_delta * t2354;
    const double t2664 = t977 + (t939 * t1005);
    const double t2668 = (t939 * t967) + (t948 * t958);
    const double t2671 = t979 + (t948 * t1005);
    const double t2677 = (t29 * t2655) + (t813 * t2659) + (t805 * t2661) + (t2208 * t2668) - (t18 *
        t2349) - (t2139 * t2664);
    const double t2678 = t2677 - (t2260 * t2671);
    const double t2683 = t6 * t869;
    const double t2686 = t906 + (t104 * t869);
    const double t2688 = t2148 + (t18 * t2686);
    const double t2690 = (cos_delta * t2683) - (sin_delta * t2688);
    const double t2691 = (t875 * t2144) + t2690;
    const double t2696 = (sin_delta * t2683) + (cos_delta * t2688);
    const double t2697 = (t875 * t2212) + t2696;
    const double t2702 = t2084 - (t29 * t2686);
    const double t2708 = (t1814 * t2688) + (t2139 * t2702) - (t1856 * t2702) - (t1895 * t2683);
    const double t2713 = t2482 + (t875 * t1919) + (t2208 * t2691) + (t2260 * t2697) + (t872 *
        t2301) + t2708;
    const double t2714 = t2713 - (t872 * t2007);
    const double t2718 = cos_phi * t1744;
    const double t2721 = (sin_phi * t1730) + (cos_phi * t1740) + (t29 * t2718);
    const double t2727 = (sin_phi * t1817) + (cos_phi * t1824) - (t18 * t2718);
    const double t2729 = sin_phi * t1858;
    const double t2731 = t2729 - (cos_phi * t1862);
    const double t2733 = cos_phi * speeds[0];
    const double t2735 = speeds[0] * sin_phi;
    const double t2739 = (sin_phi * t2085) + (cos_phi * t2103);
    const double t2742 = sin_phi * t873;
    const double t2747 = (sin_phi * t2149) + (cos_phi * t2169);
    const double t2751 = (t2144 * t2742) + (cos_phi * t2162) - (cos_delta * t2729) - (sin_delta *
        t2747);
    const double t2759 = (t2212 * t2742) + (cos_phi * t2221) + (cos_delta * t2747) - (sin_delta *
        t2729);
    const double t2761 = sin_phi * t871;
    const double t2770 = (t1814 * t2721) + (t1856 * t2727) + (t1895 * t2731) + (t2017 * t2735) +
        (t2139 * t2739) + (t2208 * t2751);
    const double t2775 = t2770 + (t2260 * t2759) + (t2301 * t2761) + (t21 * t2551) - (t1987 *
        t2733) - (sin_phi * t2482);
    const double t2776 = t2775 - (t30 * t2652);
    const double t2778 = (cos_phi * ((t384 * t1592) + (motion->constants[21] * ((t29 * t1575) -
        (t18 * t1581))))) + (t389 * t1655);
    const double t2783 = t2778 + (t813 * t1663) + (t1669 * t1672) + (t1763 * t1814) + (t1840 *
        t1856) + (t1866 * t1895);
    const double t2788 = t2783 + (t1899 * t1919) + (t1927 * t1987) + (t2010 * t2017) + (t2035 *
        t2045) + (t2064 * t2077);
    const double t2793 = t2788 + (t2129 * t2139) + (t2200 * t2208) + (t2250 * t2260) + (t2272 *
        t2284) + (t2288 * t2301);
    const double t2798 = t2793 + (t2488 * t2551) + (t2557 * t2652) + (t671 * t2678) + (t244 *
        t2714) + (t485 * t2776);
    const double t2803 = t2798 - (sin_phi * t1644) - (t116 * t1647) - (t119 * t1650) - (t208 *
        t1592) - (t616 * t1545);
    const double t2807 = t2803 - (t805 * t1665) - (t850 * t1724) - (t1991 * t2007) - (t869 * t2482);
    const double t2811 = t557 * t1545;
    const double t2815 = t541 * t1545;
    const double t2821 = (t104 * t1337) + (t6 * t1335);
    const double t2830 = (t29 * t2821) - (motion->constants[24] * t1335);
    const double t2837 = (t1337 * t1795) + (t1335 * t1797) - motion->constants[38] - (t1799 *
        t2830);
    const double t2841 = (t1337 * t1778) + (t1782 * t2830) - (t1335 * t1780) - (sin_delta * t2837);
    const double t2843 = (t1767 * t2821) + t2841 - (motion->constants[31] * t1335);
    const double t2850 = (motion->constants[23] * t1335) + (t18 * t2821);
    const double t2854 = (t1337 * t1359) - (t781 * t1335) - (t1845 * t2821) -
        (motion->constants[37] * t2850);
    const double t2863 = (t1337 * t1878) + (t1882 * t2830) + (cos_delta * t2837) - (t1335 * t1880);
    const double t2864 = (t1337 * t1870) + t2863;
    const double t2873 = (t1337 * t1908) + (motion->constants[23] * t2863) - motion->constants[43] -
        (t790 * t1335) - (t770 * t2830);
    const double t2887 = t1355 + (t1337 * t1947) + (t1769 * t2830) - (t1335 * t1949) -
        (motion->constants[38] * t2850);
    const double t2894 = (t1337 * t1968) + (t1797 * t2830) - motion->constants[41] - (t1335 *
        t1970);
    const double t2900 = (t1337 * t1933) + (t1892 * t2821) + (motion->constants[24] * t2841) +
        (cos_delta * t2887) + (sin_delta * t2894) - (t1335 * t1937);
    const double t2901 = t2900 - (motion->constants[46] * t2850);
    const double t2909 = (t1337 * t1997) + (cos_delta * t2894) - (motion->constants[24] * t2863) -
        (sin_delta * t2887);
    const double t2917 = (t1841 * t2843) + (t29 * t2873) - (t1764 * t2854) - (t18 * t2909);
    const double t2925 = (t2037 * t2843) - (t2039 * t2854) - (sin_phi * t2901) - (cos_phi * t2917);
    const double t2934 = t2901 + (t1354 * t2067) + (t2071 * t2854) + (t383 * t2925) - (t2069 *
        t2843);
    const double t2940 = (t1354 * t2133) + (t2136 * t2934) - (t2131 * t2925);
    const double t2946 = (t1354 * t2202) + (t2201 * t2925) + (t2205 * t2934);
    const double t2952 = (t2257 * t2934) - (t1354 * t2254) - (t2252 * t2925);
    const double t2958 = (t2279 * t2946) - (t2274 * t2940) - (t2281 * t2952);
    const double t2964 = (t2295 * t2946) + (t2298 * t2952) - (t2291 * t2940);
    const double t2987 = (t1337 * t2371) + (speeds[1] * t2894) + (t2385 * t2940) + (t2391 * t2946) -
        t2351 - (t1335 * t2373);
    const double t2990 = t2987 - (t2377 * t2830) - (t2379 * t2850) - (t2394 * t2952);
    const double t3005 = (t1337 * t2426) + (t2434 * t2830) + (t2436 * t2850) + (t2444 * t2940) +
        (t2447 * t2946) + (t2452 * t2952);
    const double t3009 = t3005 + (t2454 * t2958) - t2408 - (t1335 * t2430) - (speeds[1] * t2887);
    const double t3015 = (t1337 * t2323) + (t2335 * t2863) + (t2342 * t2946) + (t2346 * t2952) +
        (cos_delta * t2990) + (sin_delta * t3009);
    const double t3020 = t3015 - (t1335 * t2325) - (t2329 * t2821) - (t2331 * t2850) - (t2337 *
        t2841) - (t2315 * t2940);
    const double t3038 = (t1337 * t2504) + (t2514 * t2821) + (t2516 * t2850) + (t892 * t2863) +
        (t2333 * t2841) + (t94 * t2873);
    const double t3043 = t3038 + (t2497 * t2940) + (t2526 * t2946) + (t2532 * t2952) + (cos_delta *
        t3009) - (t1335 * t2510);
    const double t3044 = t3043 - (sin_delta * t2990);
    const double t3060 = t2410 + (t2628 * t2958) - (t2633 * t2830);
    const double t3065 = (t1337 * t2586) + (t2598 * t2821) + (t2601 * t2850) + (t890 * t2863) +
        (t2610 * t2940) + (t2617 * t2946);
    const double t3070 = t3065 + (t2625 * t2952) + (t94 * t2964) + t3060 - (t1335 * t2594) -
        (t2604 * t2841);
    const double t3071 = t3070 - (t94 * t2909);
    const double t3082 = (t1337 * t2659) + (t1335 * t2661) + (t2668 * t2946) - t2349 - (t2664 *
        t2940) - (t2671 * t2952);
    const double t3095 = (t2688 * t2843) + (t2683 * t2864) + (t2702 * t2940) - (t2702 * t2854);
    const double t3100 = t3020 + (t875 * t2873) + (t2691 * t2946) + (t2697 * t2952) + (t872 *
        t2964) + t3095;
    const double t3101 = t3100 - (t872 * t2909);
    const double t3119 = (t2721 * t2843) + (t2727 * t2854) + (t2735 * t2917) + (t2739 * t2940) +
        (t2751 * t2946) + (t2759 * t2952);
    const double t3124 = t3119 + (t2761 * t2964) + (t21 * t3044) - (t2731 * t2864) - (t2733 *
        t2901) - (sin_phi * t3020);
    const double t3125 = t3124 - (t30 * t3071);
    const double t3132 = (t1337 * t1592) + (t158 * t2811) + (t482 * t1655) + (t1337 * t1663) +
        (t1669 * t2821) + (t1354 * t1724);
    const double t3137 = t3132 + (t1763 * t2843) + (t1840 * t2854) + (t1899 * t2873) + (t1927 *
        t2901) + (t2010 * t2917);
    const double t3142 = t3137 + (t2035 * t2925) + (t2064 * t2934) + (t2129 * t2940) + (t2200 *
        t2946) + (t2250 * t2952);
    const double t3147 = t3142 + (t2272 * t2958) + (t2288 * t2964) + (t2488 * t3044) + (t2557 *
        t3071) + (t671 * t3082);
    const double t3152 = t3147 + (t244 * t3101) + (t485 * t3125) - (t1334 * t1634) - (t242 *
        t1592) - (t667 * t2815);
    const double t3157 = t3152 - (t1335 * t1665) - (t1866 * t2864) - (t1991 * t2909) - (t869 *
        t3020) - (t1385 * t2807);
    const double t3170 = t6 + (t104 * t1223) - (t6 * t1168);
    const double t3179 = (motion->constants[24] * t1168) + (t29 * t3170);
    const double t3185 = (t1223 * t1795) - (t1168 * t1797) - (t1799 * t3179);
    const double t3189 = (t1223 * t1778) + (t1168 * t1780) + (t1782 * t3179) - (sin_delta * t3185);
    const double t3191 = (motion->constants[31] * t1168) + (t1767 * t3170) + t3189;
    const double t3198 = (t18 * t3170) - (motion->constants[23] * t1168);
    const double t3202 = (t1223 * t1359) + (t781 * t1168) - (t1845 * t3170) -
        (motion->constants[37] * t3198);
    const double t3211 = (t1223 * t1878) + (t1168 * t1880) + (t1882 * t3179) + (cos_delta * t3185);
    const double t3212 = (t1223 * t1870) + t3211;
    const double t3220 = (t1223 * t1908) + (t790 * t1168) + (motion->constants[23] * t3211) -
        (t770 * t3179);
    const double t3234 = t1433 + (t1223 * t1947) + (t1168 * t1949) + (t1769 * t3179) -
        (motion->constants[38] * t3198);
    const double t3240 = (t1223 * t1968) + (t1168 * t1970) + (t1797 * t3179);
    const double t3246 = (t1223 * t1933) + (t1168 * t1937) + (t1892 * t3170) +
        (motion->constants[24] * t3189) + (cos_delta * t3234) + (sin_delta * t3240);
    const double t3248 = t3246 - motion->constants[18] - (motion->constants[46] * t3198);
    const double t3256 = (t1223 * t1997) + (cos_delta * t3240) - (motion->constants[24] * t3211) -
        (sin_delta * t3234);
    const double t3264 = (t1841 * t3191) + (t29 * t3220) - (t1764 * t3202) - (t18 * t3256);
    const double t3272 = (t2037 * t3191) - (t2039 * t3202) - (sin_phi * t3248) - (cos_phi * t3264);
    const double t3281 = t3248 + (t1323 * t2067) + (t2071 * t3202) + (t383 * t3272) - (t2069 *
        t3191);
    const double t3287 = (t1323 * t2133) + (t2136 * t3281) - (t2131 * t3272);
    const double t3293 = (t1323 * t2202) + (t2201 * t3272) + (t2205 * t3281);
    const double t3299 = (t2257 * t3281) - (t1323 * t2254) - (t2252 * t3272);
    const double t3305 = (t2279 * t3293) - (t2274 * t3287) - (t2281 * t3299);
    const double t3311 = (t2295 * t3293) + (t2298 * t3299) - (t2291 * t3287);
    const double t3334 = (t1223 * t2371) + (t1168 * t2373) + (speeds[1] * t3240) + (t2385 * t3287) +
        (t2391 * t3293) - (t2377 * t3179);
    const double t3336 = t3334 - (t2379 * t3198) - (t2394 * t3299);
    const double t3351 = (t1223 * t2426) + (t1168 * t2430) + (t2434 * t3179) + (t2436 * t3198) +
        (t2444 * t3287) + (t2447 * t3293);
    const double t3354 = t3351 + (t2452 * t3299) + (t2454 * t3305) - (speeds[1] * t3234);
    const double t3360 = (t1223 * t2323) + (t1168 * t2325) + (t2335 * t3211) + (t2342 * t3293) +
        (t2346 * t3299) + (cos_delta * t3336);
    const double t3365 = t3360 + (sin_delta * t3354) - (t2329 * t3170) - (t2331 * t3198) - (t2337 *
        t3189) - (t2315 * t3287);
    const double t3383 = (t1223 * t2504) + (t1168 * t2510) + (t2514 * t3170) + (t2516 * t3198) +
        (t892 * t3211) + (t2333 * t3189);
    const double t3388 = t3383 + (t94 * t3220) + (t2497 * t3287) + (t2526 * t3293) + (t2532 *
        t3299) + (cos_delta * t3354);
    const double t3389 = t3388 - (sin_delta * t3336);
    const double t3404 = (t2633 * t3179) - (t2628 * t3305);
    const double t3409 = (t1223 * t2586) + (t1168 * t2594) + (t2598 * t3170) + (t2601 * t3198) +
        (t890 * t3211) + (t2610 * t3287);
    const double t3414 = t3409 + (t2617 * t3293) + (t2625 * t3299) + (t94 * t3311) - (t2604 *
        t3189) - (t94 * t3256);
    const double t3415 = t3414 - t3404;
    const double t3425 = (t1223 * t2659) + (t2668 * t3293) - (t1168 * t2661) - (t2664 * t3287) -
        (t2671 * t3299);
    const double t3438 = (t2688 * t3191) + (t2683 * t3212) + (t2702 * t3287) - (t2702 * t3202);
    const double t3443 = t3365 + (t875 * t3220) + (t2691 * t3293) + (t2697 * t3299) + (t872 *
        t3311) + t3438;
    const double t3444 = t3443 - (t872 * t3256);
    const double t3462 = (t2721 * t3191) + (t2727 * t3202) + (t2735 * t3264) + (t2739 * t3287) +
        (t2751 * t3293) + (t2759 * t3299);
    const double t3467 = t3462 + (t2761 * t3311) + (t21 * t3389) - (t2731 * t3212) - (t2733 *
        t3248) - (sin_phi * t3365);
    const double t3468 = t3467 - (t30 * t3415);
    const double t3476 = (t1223 * t1592) + (t362 * t1655) + (t1223 * t1663) + (t1168 * t1665) +
        (t1669 * t3170) + (t1323 * t1724);
    const double t3481 = t3476 + (t1763 * t3191) + (t1840 * t3202) + (t1899 * t3220) + (t1927 *
        t3248) + (t2010 * t3264);
    const double t3486 = t3481 + (t2035 * t3272) + (t2064 * t3281) + (t2129 * t3287) + (t2200 *
        t3293) + (t2250 * t3299);
    const double t3491 = t3486 + (t2272 * t3305) + (t2288 * t3311) + (t2488 * t3389) + (t2557 *
        t3415) + (t671 * t3425);
    const double t3496 = t3491 + (t244 * t3444) + (t485 * t3468) - (sin_phi * (t1658 + (t349 *
        t1634))) - (t587 * t1545) - (t1866 * t3212);
    const double t3501 = t1447 * (t3496 - (t1991 * t3256) - (t869 * t3365) - (t1330 * t2807) -
        (t1410 * t3157));
    const double t3503 = (t1409 * t3157) - (t1410 * t3501);
    const double t3507 = (t863 * t2807) - (t1385 * t3503) - (t1330 * t3501);
    const double t3511 = (t1506 * t1769) - (t1510 * t1797);
    const double t3513 = t1551 + (sin_delta * t3511);
    const double t3515 = motion->constants[37] * t1506;
    const double t3519 = motion->constants[37] * t1510;
    const double t3523 = (cos_delta * (t1555 + (sin_delta * t3515))) - (sin_delta * (t1562 +
        (sin_delta * t3519)));
    const double t3535 = (t18 * t3513) + (t88 * t3523) - (t250 * t1617) - (t252 * t1630);
    const double t3538 = t1624 + (cos_delta * t3511);
    const double t3542 = (t252 * t1575) - (t250 * t1581);
    const double t3550 = (cos_delta * ((cos_delta * t3515) - t1562)) - (sin_delta * (t1555 +
        (cos_delta * t3519)));
    const double t3567 = (t270 * t1686) + (t274 * t1692) + (t278 * t1697) + (t503 * t1702) + (t681 *
        t1704) + (t686 * t1709);
    const double t3572 = t3567 + (t703 * t1711) + (t729 * t1713) - (t255 * t1677) - (t695 * t1699) -
        (t493 * t1707);
    const double t3581 = (t250 * t1476) + (t252 * t1481) - (t313 * t1754) - (t321 * t1757);
    const double t3589 = (t252 * t1476) + (t313 * t1832) + (t321 * t1834) - (t250 * t1481);
    const double t3595 = (t252 * t1456) - (t250 * t1472);
    const double t3599 = (t313 * t1456) + (t321 * t1452);
    const double t3603 = (t250 * t1456) + (t252 * t1472);
    const double t3618 = (t270 * t1684) + (t278 * t1695) + (t503 * t1701) + (t495 * t1448) + (t508 *
        t1456) + (t534 * t1452);
    const double t3621 = t3618 - (t255 * t1674) - (t274 * t1690) - (t493 * t1706);
    const double t3631 = (t255 * t2049) + (t270 * t2051) + (t274 * t2054) - (t278 * t2056) - (t311 *
        t2058);
    const double t3651 = (t250 * t933) + (t252 * t926) + (t255 * t2109) + (t274 * t2117) + (t278 *
        t2121) - (cos_delta * ((t919 * t1005) + (t902 * t2097)));
    const double t3653 = t3651 - (sin_delta * ((t919 * t2097) - (t902 * t1005))) - (t270 * t2112);
    const double t3656 = (t919 * t2158) - t937;
    const double t3659 = t911 + (t902 * t2158);
    const double t3670 = (cos_delta * t3656) + (t270 * t2185) + (t274 * t2189) - (sin_delta *
        t3659) - (t250 * t2178) - (t252 * t2180);
    const double t3671 = t3670 - (t278 * t2193);
    const double t3685 = (cos_delta * t3659) + (sin_delta * t3656) + (t252 * t2231) + (t270 *
        t2235) - (t250 * t2229) - (t255 * t2233);
    const double t3687 = t3685 - (t274 * t2239) - (t278 * t2242);
    const double t3695 = (t255 * t2262) + (t274 * t2266) - (t270 * t2264) - (t278 * t2268);
    const double t3697 = t252 * t895;
    const double t3703 = (t252 * t869) - (speeds[0] * t250);
    const double t3707 = (t250 * t869) + (speeds[0] * t252);
    const double t3716 = (t29 * t3513) + (t1774 * t3523) + (t508 * t1655) + (t813 * t3535) +
        (t1672 * t3542) + (t1786 * t3550);
    const double t3721 = t3716 + (t1814 * t3581) + (t1856 * t3589) + (t1535 * t1977) + (t1919 *
        t3595) + (t1987 * t3599);
    const double t3726 = t3721 + (t2045 * t3621) + (t2077 * t3631) + (t2139 * t3653) + (t2208 *
        t3671) + (t2260 * t3687);
    const double t3731 = t3726 + (t2284 * t3695) + (t2301 * t3697) + (t943 * t2466) + (t2551 *
        t3703) + (t2652 * t3707);
    const double t3736 = t3731 + (t733 * t2678) + (t323 * t2714) + (t537 * t2776) - (t250 * t1647) -
        (t252 * t1650);
    const double t3741 = t3736 - (t313 * t1592) - (t703 * t1545) - (t805 * t3538) - (t850 * t3572) -
        (t1527 * t1805);
    const double t3744 = t3741 - (t1516 * t1958) - (t2007 * t3603) - (t948 * t2405);
    const double t3782 = (t270 * t2811) + (t534 * t1655) + (t1337 * t3535) + (t2821 * t3542) +
        (t2830 * t3550) + (t1354 * t3572);
    const double t3787 = t3782 + (t2843 * t3581) + (t2854 * t3589) + (t1535 * t2894) + (t2873 *
        t3595) + (t2901 * t3599);
    const double t3792 = t3787 + (t2925 * t3621) + (t2934 * t3631) + (t2940 * t3653) + (t2946 *
        t3671) + (t2952 * t3687);
    const double t3797 = t3792 + (t2958 * t3695) + (t2964 * t3697) + (t943 * t3009) + (t3044 *
        t3703) + (t3071 * t3707);
    const double t3802 = t3797 + (t733 * t3082) + (t323 * t3101) + (t537 * t3125) - (t321 * t1592) -
        (t729 * t2815);
    const double t3807 = t3802 - (t1335 * t3538) - (t1527 * t2837) - (t1516 * t2887) - (t2909 *
        t3603) - (t948 * t2990);
    const double t3808 = t3807 - (t1385 * t3744);
    const double t3845 = (t495 * t1655) + (t1223 * t3535) + (t1168 * t3538) + (t3170 * t3542) +
        (t3179 * t3550) + (t1323 * t3572);
    const double t3850 = t3845 + (t3191 * t3581) + (t3202 * t3589) + (t1535 * t3240) + (t3220 *
        t3595) + (t3248 * t3599);
    const double t3855 = t3850 + (t3272 * t3621) + (t3281 * t3631) + (t3287 * t3653) + (t3293 *
        t3671) + (t3299 * t3687);
    const double t3860 = t3855 + (t3305 * t3695) + (t3311 * t3697) + (t943 * t3354) + (t3389 *
        t3703) + (t3415 * t3707);
    const double t3865 = t3860 + (t733 * t3425) + (t323 * t3444) + (t537 * t3468) - (t686 * t1545) -
        (t1527 * t3185);
    const double t3870 = t3865 - (t1516 * t3234) - (t3256 * t3603) - (t948 * t3336) - (t1330 *
        t3744) - (t1410 * t3808);
    const double t3871 = t1447 * t3870;
    const double t3873 = (t1409 * t3808) - (t1410 * t3871);
    const double t3877 = (t863 * t3744) - (t1385 * t3873) - (t1330 * t3871);
    const double t3878 = t886 + t886;
    const double t3879 = t18 * t3878;
    const double t3880 = t105 + t1858;
    const double t3881 = t2683 + t3880;
    const double t3883 = (t29 * t3881) - t3879;
    const double t3885 = t29 * t3878;
    const double t3887 = t3885 + (t18 * t3881);
    const double t3892 = t3880 + (t104 * t888);
    const double t3896 = cos_delta * t869;
    const double t3901 = t3885 + (t18 * t3892) + (t869 * t2093) + (t2097 * t3896) - (t869 * t2095);
    const double t3904 = t29 * t888;
    const double t3909 = (t29 * t3892) + (t869 * t2166) - t3879;
    const double t3912 = (t869 * t2159) + (t2144 * t3904) - (sin_delta * t3909);
    const double t3918 = (t2212 * t3904) + (cos_delta * t3909) - (t2158 * t3896);
    const double t3930 = (t1814 * t3883) + (t888 * t2017) + (t2139 * t3901) + (t2208 * t3912) +
        (t2260 * t3918) + (t2301 * t2484);
    const double t3935 = t3930 + (t29 * t2551) + (t18 * t2652) + (t592 * t2678) + (t75 * t2714) +
        (t384 * t2776);
    const double t3937 = t3935 - (t1856 * t3887) - (t869 * t1987);
    const double t3957 = (t2843 * t3883) + (t888 * t2917) + (t2940 * t3901) + (t2946 * t3912) +
        (t2952 * t3918) + (t2484 * t2964);
    const double t3962 = t3957 + (t29 * t3044) + (t18 * t3071) + (t592 * t3082) + (t75 * t3101) +
        (t384 * t3125);
    const double t3965 = t3962 - (t2854 * t3887) - (t869 * t2901) - (t1385 * t3937);
    const double t3986 = (t3191 * t3883) + (t888 * t3264) + (t3287 * t3901) + (t3293 * t3912) +
        (t3299 * t3918) + (t2484 * t3311);
    const double t3991 = t3986 + (t29 * t3389) + (t18 * t3415) + (t592 * t3425) + (t75 * t3444) +
        (t384 * t3468);
    const double t3996 = t1447 * (t3991 - (t3202 * t3887) - (t869 * t3248) - (t1330 * t3937) -
        (t1410 * t3965));
    const double t3998 = (t1409 * t3965) - (t1410 * t3996);
    const double t4002 = (t863 * t3937) - (t1385 * t3998) - (t1330 * t3996);
    const double t4005 = t2567 - (sin_delta * t2570);
    const double t4010 = t2584 - (t29 * t2410) - (t18 * t4005);
    const double t4013 = t2589 + (cos_delta * t2570);
    const double t4021 = t2609 + (t943 * t1005) + (t948 * t2097);
    const double t4024 = t2614 - (t943 * t2158);
    const double t4027 = t2622 + (t948 * t2158);
    const double t4036 = t2636 + (t18 * t2410) + (t813 * t4010) + (t1850 * t2360) + (t943 * t1977) +
        (t2139 * t4021);
    const double t4041 = t4036 + (t2208 * t4024) + (t555 * t2678) + (t92 * t2714) + (t468 * t2776) -
        (t29 * t4005);
    const double t4044 = t4041 - (t805 * t4013) - (t948 * t1958) - (t2260 * t4027);
    const double t4062 = t3060 + (t1337 * t4010) + (t2360 * t2850) + (t943 * t2894) + (t2940 *
        t4021) + (t2946 * t4024);
    const double t4067 = t4062 + (t555 * t3082) + (t92 * t3101) + (t468 * t3125) - (t1335 * t4013) -
        (t948 * t2887);
    const double t4069 = t4067 - (t2952 * t4027) - (t1385 * t4044);
    const double t4088 = (t1223 * t4010) + (t1168 * t4013) + (t2360 * t3198) + (t943 * t3240) +
        (t3287 * t4021) + (t3293 * t4024);
    const double t4093 = t4088 + (t555 * t3425) + (t92 * t3444) + (t468 * t3468) - t3404 - (t948 *
        t3234);
    const double t4097 = t1447 * (t4093 - (t3299 * t4027) - (t1330 * t4044) - (t1410 * t4069));
    const double t4099 = (t1409 * t4069) - (t1410 * t4097);
    const double t4103 = (t863 * t4044) - (t1385 * t4099) - (t1330 * t4097);
    const double t4104 = motion->constants[18] * t875;
    const double t4106 = motion->constants[18] * t872;
    const double t4110 = (t29 * t4104) + (t18 * t4106);
    const double t4120 = t2708 + (t29 * t4106) + (t813 * t4110) + (t2208 * t2690) + (t2260 *
        t2696) + (t565 * t2678);
    const double t4122 = t4120 + (t349 * t2776) - (t18 * t4104);
    const double t4134 = t3095 + (t1337 * t4110) + (t2690 * t2946) + (t2696 * t2952) + (t565 *
        t3082) + (t349 * t3125);
    const double t4135 = t4134 - (t1385 * t4122);
    const double t4148 = t3438 + (t1223 * t4110) + (t2690 * t3293) + (t2696 * t3299) + (t565 *
        t3425) + (t349 * t3468);
    const double t4151 = t1447 * (t4148 - (t1330 * t4122) - (t1410 * t4135));
    const double t4153 = (t1409 * t4135) - (t1410 * t4151);
    const double t4157 = (t863 * t4122) - (t1385 * t4153) - (t1330 * t4151);
    const double t4161 = t1447 * ((t1385 * t1410) - t1330);
    const double t4163 = (t1385 * t1409) + (t1410 * t4161);
    const double t4167 = t863 + (t1385 * t4163) - (t1330 * t4161);
    const double t4168 = t1410 * t1447;
    const double t4170 = t1409 + (t1410 * t4168);
    const double t4173 = (t1330 * t4168) - (t1385 * t4170);
    const double t4174 = -(t107 * t323);
    const double t4175 = -((motion->constants[21] * sin_psi) + (t75 * t107));
    const double t4176 = -(t92 * t107);
    const double t4177 = -t107;
    const double t4178 = -((t96 * cos_psi) + (sin_psi * t100));
    const double t4179 = -(t323 * t333);
    const double t4180 = -(t92 * t333);
    const double t4181 = -t333;
    const double t4182 = -t485;
    const double t4183 = -t537;
    const double t4184 = -t384;
    const double t4185 = -t468;
    const double t4186 = -t349;
    const double t4187 = -t4163;
    const double t4188 = -t4168;
    linearization->a[0][0] = 0.0;
    linearization->a[0][1] = 0.0;
    linearization->a[0][2] = t103;
    linearization->a[0][3] = t246;
    linearization->a[0][4] = 0.0;
    linearization->a[0][5] = t4174;
    linearization->a[0][6] = 0.0;
    linearization->a[0][7] = 0.0;
    linearization->a[0][8] = t4175;
    linearization->a[0][9] = t4176;
    linearization->a[0][10] = t4177;
    linearization->b[0][0] = 0.0;
    linearization->b[0][1] = 0.0;
    linearization->a[1][0] = 0.0;
    linearization->a[1][1] = 0.0;
    linearization->a[1][2] = t4178;
    linearization->a[1][3] = t335;
    linearization->a[1][4] = 0.0;
    linearization->a[1][5] = t4179;
    linearization->a[1][6] = 0.0;
    linearization->a[1][7] = 0.0;
    linearization->a[1][8] = t339;
    linearization->a[1][9] = t4180;
    linearization->a[1][10] = t4181;
    linearization->b[1][0] = 0.0;
    linearization->b[1][1] = 0.0;
    linearization->a[2][0] = 0.0;
    linearization->a[2][1] = 0.0;
    linearization->a[2][2] = 0.0;
    linearization->a[2][3] = t4182;
    linearization->a[2][4] = 0.0;
    linearization->a[2][5] = t4183;
    linearization->a[2][6] = 0.0;
    linearization->a[2][7] = 0.0;
    linearization->a[2][8] = t4184;
    linearization->a[2][9] = t4185;
    linearization->a[2][10] = t4186;
    linearization->b[2][0] = 0.0;
    linearization->b[2][1] = 0.0;
    linearization->a[3][0] = 0.0;
    linearization->a[3][1] = 0.0;
    linearization->a[3][2] = 0.0;
    linearization->a[3][3] = 0.0;
    linearization->a[3][4] = 0.0;
    linearization->a[3][5] = 0.0;
    linearization->a[3][6] = 0.0;
    linearization->a[3][7] = 0.0;
    linearization->a[3][8] = 1.0;
    linearization->a[3][9] = 0.0;
    linearization->a[3][10] = 0.0;
    linearization->b[3][0] = 0.0;
    linearization->b[3][1] = 0.0;
    linearization->a[4][0] = 0.0;
    linearization->a[4][1] = 0.0;
    linearization->a[4][2] = 0.0;
    linearization->a[4][3] = t244;
    linearization->a[4][4] = 0.0;
    linearization->a[4][5] = t323;
    linearization->a[4][6] = 0.0;
    linearization->a[4][7] = 0.0;
    linearization->a[4][8] = t75;
    linearization->a[4][9] = t92;
    linearization->a[4][10] = 0.0;
    linearization->b[4][0] = 0.0;
    linearization->b[4][1] = 0.0;
    linearization->a[5][0] = 0.0;
    linearization->a[5][1] = 0.0;
    linearization->a[5][2] = 0.0;
    linearization->a[5][3] = 0.0;
    linearization->a[5][4] = 0.0;
    linearization->a[5][5] = 0.0;
    linearization->a[5][6] = 0.0;
    linearization->a[5][7] = 0.0;
    linearization->a[5][8] = 0.0;
    linearization->a[5][9] = 1.0;
    linearization->a[5][10] = 0.0;
    linearization->b[5][0] = 0.0;
    linearization->b[5][1] = 0.0;
    linearization->a[6][0] = 0.0;
    linearization->a[6][1] = 0.0;
    linearization->a[6][2] = 0.0;
    linearization->a[6][3] = 0.0;
    linearization->a[6][4] = 0.0;
    linearization->a[6][5] = 0.0;
    linearization->a[6][6] = 0.0;
    linearization->a[6][7] = 0.0;
    linearization->a[6][8] = 0.0;
    linearization->a[6][9] = 0.0;
    linearization->a[6][10] = 1.0;
    linearization->b[6][0] = 0.0;
    linearization->b[6][1] = 0.0;
    linearization->a[7][0] = 0.0;
    linearization->a[7][1] = 0.0;
    linearization->a[7][2] = 0.0;
    linearization->a[7][3] = t671;
    linearization->a[7][4] = 0.0;
    linearization->a[7][5] = t733;
    linearization->a[7][6] = 0.0;
    linearization->a[7][7] = 0.0;
    linearization->a[7][8] = t592;
    linearization->a[7][9] = t555;
    linearization->a[7][10] = t565;
    linearization->b[7][0] = 0.0;
    linearization->b[7][1] = 0.0;
    linearization->a[8][0] = 0.0;
    linearization->a[8][1] = 0.0;
    linearization->a[8][2] = 0.0;
    linearization->a[8][3] = t3507;
    linearization->a[8][4] = 0.0;
    linearization->a[8][5] = t3877;
    linearization->a[8][6] = 0.0;
    linearization->a[8][7] = 0.0;
    linearization->a[8][8] = t4002;
    linearization->a[8][9] = t4103;
    linearization->a[8][10] = t4157;
    linearization->b[8][0] = t4167;
    linearization->b[8][1] = t4173;
    linearization->a[9][0] = 0.0;
    linearization->a[9][1] = 0.0;
    linearization->a[9][2] = 0.0;
    linearization->a[9][3] = t3503;
    linearization->a[9][4] = 0.0;
    linearization->a[9][5] = t3873;
    linearization->a[9][6] = 0.0;
    linearization->a[9][7] = 0.0;
    linearization->a[9][8] = t3998;
    linearization->a[9][9] = t4099;
    linearization->a[9][10] = t4153;
    linearization->b[9][0] = t4187;
    linearization->b[9][1] = t4170;
    linearization->a[10][0] = 0.0;
    linearization->a[10][1] = 0.0;
    linearization->a[10][2] = 0.0;
    linearization->a[10][3] = t3501;
    linearization->a[10][4] = 0.0;
    linearization->a[10][5] = t3871;
    linearization->a[10][6] = 0.0;
    linearization->a[10][7] = 0.0;
    linearization->a[10][8] = t3996;
    linearization->a[10][9] = t4097;
    linearization->a[10][10] = t4151;
    linearization->b[10][0] = t4161;
    linearization->b[10][1] = t4188;
}

carvallo_motion_error_t whipple_tyres_f64_motion_linearize(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES], whipple_tyres_f64_linearization_t *linearization)
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_TYRES_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_TYRES_FORCES)) {
        bool are_finite = true;
        whipple_tyres_f64_compute_linearization(motion, positions, speeds, forces, linearization);
        for (size_t row = 0U; row < WHIPPLE_TYRES_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f64(linearization->a[row],
                WHIPPLE_TYRES_STATES) && carvallo_are_finite_f64(linearization->b[row],
                WHIPPLE_TYRES_FORCES);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_tyres_f64_compute_by_parameters(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES],
    double by_parameters[WHIPPLE_TYRES_STATES][WHIPPLE_TYRES_PARAMETERS])
{
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t7 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t12 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const double t13 = cos_phi * t12;
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t16 = t7 * cos_phi;
    const double t20 = sin_phi * sin_delta;
    const double t21 = t20 - (cos_delta * t16);
    const double t25 = sqrt((t21 * t21) + (t13 * t13));
    const double t26 = 1.0 / t25;
    const double t27 = t13 * t26;
    const double t28 = cos_phi * sin_delta;
    const double t30 = t21 * t26;
    const double t32 = cos_delta * t27;
    const double t36 = (t27 * t28) + (sin_phi * ((t12 * t30) + (t7 * t32)));
    const double t39 = (cos_delta * sin_phi) + (t16 * sin_delta);
    const double t41 = t39 * motion->constants[28];
    const double t48 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const double t51 = (t36 * t41) + (t7 * motion->constants[29]) + (t12 * t48);
    const double t53 = 1.0 / (cos_phi * t51);
    const double t55 = motion->constants[2] * t13;
    const double t56 = t55 - (motion->constants[3] * t16);
    const double t57 = t53 * t56;
    const double t58 = t7 * t57;
    const double t63 = t51 - (t7 * motion->constants[24]) - (t12 * motion->constants[23]);
    const double t64 = sin_phi * t53;
    const double t66 = t12 * sin_phi;
    const double t67 = t53 * t66;
    const double t69 = (t63 * t64) - (motion->constants[23] * t67);
    const double t74 = motion->constants[25] + (cos_phi * motion->constants[21]);
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t77 = t74 * cos_psi;
    const double t78 = speeds[1] * t77;
    const double t80 = t7 * sin_phi;
    const double t81 = t53 * t80;
    const double t82 = t78 * t81;
    const double t85 = t26 * t26;
    const double t86 = t21 * t85;
    const double t88 = t26 * 0.5;
    const double t90 = cos_phi * (t13 + t13);
    const double t91 = t88 * t90;
    const double t92 = t86 * t91;
    const double t94 = t12 * cos_delta;
    const double t96 = t13 * t85;
    const double t98 = (cos_phi * t26) - (t91 * t96);
    const double t101 = t32 + (t7 * t92) + (t94 * t98);
    const double t103 = (sin_phi * motion->constants[29]) + (t41 * t101);
    const double t104 = t7 * t53;
    const double t107 = t77 * speeds[0];
    const double t109 = (t78 * t104) + (t53 * t107);
    const double t113 = t7 * cos_delta;
    const double t115 = t28 + (sin_phi * t113);
    const double t118 = (sin_phi * t30) + (t98 * t115) - (t66 * t92);
    const double t120 = t48 + (t41 * t118);
    const double t123 = (t12 * t32) - (t7 * t30);
    const double t125 = sin_delta * motion->constants[26];
    const double t129 = (t12 * motion->constants[29]) - (t7 * t48);
    const double t132 = (cos_phi * t125) - (t41 * t123) - (sin_phi * t129);
    const double t135 = (t12 * motion->constants[24]) - (t7 * motion->constants[23]);
    const double t137 = t132 + (sin_phi * t135);
    const double t141 = t53 * ((t7 * t137) + (t63 * t66));
    const double t142 = cos_phi * t53;
    const double t144 = t67 - (t141 * t142);
    const double t146 = sin_phi * motion->constants[25];
    const double t147 = t132 + t146;
    const double t148 = t53 * t147;
    const double t149 = t142 * t148;
    const double t151 = (t107 * t149) - (t78 * t144);
    const double t155 = (t103 * t109) + (t120 * t151) - (t69 * t78) - (motion->constants[24] * t82);
    const double t157 = t12 * t57;
    const double t160 = (t53 * t137) - (motion->constants[24] * t67);
    const double t164 = t28 * motion->constants[28];
    const double t166 = cos_phi * cos_delta;
    const double t169 = t166 * (t21 + t21);
    const double t170 = t88 * t169;
    const double t172 = (t86 * t170) - (t26 * t166);
    const double t174 = t96 * t170;
    const double t177 = (t94 * t174) - t30 - (t7 * t172);
    const double t180 = (sin_phi * t48) - (t123 * t164) - (t41 * t177);
    const double t187 = (sin_phi * t32) + (t66 * t172) + (t115 * t174);
    const double t190 = motion->constants[29] + (t36 * t164) + (t41 * t187);
    const double t194 = (motion->constants[23] * t82) + (t151 * t190) - (t78 * t160) - (t109 *
        t180);
    const double t196 = t7 * t67;
    const double t201 = (t66 * t109) + (t7 * t151);
    const double t203 = (t78 * t196) + t201 - (t12 * t82);
    const double t205 = t12 * t67;
    const double t212 = (t78 * t205) + (t7 * t82) + (t12 * t151) - (t80 * t109);
    const double t214 = (motion->constants[2] * t203) + (motion->constants[3] * t212);
    const double t216 = (t157 * t194) + t214 - (t58 * t155);
    const double t220 = (t94 * t151) - (t109 * t115);
    const double t223 = t20 - (cos_phi * t113);
    const double t227 = t53 * (t56 - t55 - (motion->constants[3] * t223));
    const double t228 = t7 * t227;
    const double t230 = t12 * t227;
    const double t235 = t214 + (t194 * t230) - (motion->constants[2] * t201) -
        (motion->constants[3] * t220) - (t155 * t228);
    const double t239 = motion->constants[0] + motion->constants[1];
    const double t244 = (motion->constants[3] * motion->constants[5]) - (motion->constants[2] *
        (motion->constants[0] - t239));
    const double t248 = motion->constants[28] * t88;
    const double t249 = t169 * t248;
    const double t251 = t90 * t248;
    const double t255 = cos_phi * t48;
    const double t257 = cos_phi * motion->constants[29];
    const double t280 = (motion->constants[3] * ((t16 * motion->constants[4]) + (t13 * t239) -
        (cos_pitch * t255) - (sin_pitch * t257))) + (t223 * t244);
    const double t284 = t280 + (t13 * motion->constants[26]) - (motion->constants[3] * ((cos_pitch *
        t249) + (sin_pitch * t251))) - (motion->constants[2] * ((cos_pitch * t251) - (sin_pitch *
        t249))) - (motion->constants[2] * ((cos_pitch * t257) + (t13 * motion->constants[4]) -
        (sin_pitch * t255) - (t16 * t239)));
    const double t285 = t53 * t284;
    const double t287 = t7 + (t7 * t285);
    const double t290 = t12 + (t12 * t285);
    const double t296 = (motion->constants[26] * t201) + (t220 * t244) + (motion->constants[23] *
        t203) + (t194 * t290) - (motion->constants[24] * t212) - (t155 * t287);
    const double t301 = (speeds[0] * t148) + (speeds[1] * t141);
    const double t302 = speeds[2] + t301;
    const double t303 = cos_psi * t302;
    const double t304 = t64 * t107;
    const double t308 = motion->constants[3] * t13;
    const double t311 = t53 * ((motion->constants[2] * t16) + t308 - cos_phi);
    const double t312 = t7 * t311;
    const double t314 = t12 * t311;
    const double t320 = (motion->constants[3] * t203) + (t194 * t314) - t303 - t304 -
        (motion->constants[2] * t212) - (t155 * t312);
    const double t321 = t39 * t123;
    const double t323 = t36 * t39;
    const double t325 = (t109 * t321) + (t151 * t323);
    const double t331 = t53 * (t25 + (motion->constants[2] * t223) - t308);
    const double t332 = t7 * t331;
    const double t334 = t12 * t331;
    const double t339 = t325 + (motion->constants[2] * t220) + (t194 * t334) -
        (motion->constants[3] * t201) - (t155 * t332);
    const double t343 = 1.0 - cos_phi;
    const double t345 = t53 * t343;
    const double t346 = t7 * t345;
    const double t348 = t12 * t345;
    const double t353 = t304 + (t303 * t343) + (t155 * t346) - (speeds[0] * sin_psi) - (t194 *
        t348);
    const double t354 = 1.0 - t25;
    const double t355 = t53 * t354;
    const double t356 = t7 * t355;
    const double t358 = t12 * t355;
    const double t361 = (t194 * t358) - t325 - (t155 * t356);
    const double t362 = t74 * sin_psi;
    const double t363 = speeds[1] * t362;
    const double t365 = t81 * t363;
    const double t368 = speeds[0] * t362;
    const double t370 = (t104 * t363) + (t53 * t368);
    const double t374 = (t149 * t368) - (t144 * t363);
    const double t378 = (t103 * t370) + (t120 * t374) - (t69 * t363) - (motion->constants[24] *
        t365);
    const double t386 = (motion->constants[23] * t365) + (t190 * t374) - (t160 * t363) - (t180 *
        t370);
    const double t392 = (t66 * t370) + (t7 * t374);
    const double t394 = (t196 * t363) + t392 - (t12 * t365);
    const double t402 = (t205 * t363) + (t7 * t365) + (t12 * t374) - (t80 * t370);
    const double t404 = (motion->constants[2] * t394) + (motion->constants[3] * t402);
    const double t406 = (t157 * t386) + t404 - (t58 * t378);
    const double t410 = (t94 * t374) - (t115 * t370);
    const double t417 = t404 + (t230 * t386) - (motion->constants[2] * t392) -
        (motion->constants[3] * t410) - (t228 * t378);
    const double t428 = (motion->constants[26] * t392) + (t244 * t410) + (motion->constants[23] *
        t394) + (t290 * t386) - (motion->constants[24] * t402) - (t287 * t378);
    const double t429 = t302 * sin_psi;
    const double t430 = t64 * t368;
    const double t439 = (motion->constants[3] * t394) + (t314 * t386) - t429 - t430 -
        (motion->constants[2] * t402) - (t312 * t378);
    const double t442 = (t321 * t370) + (t323 * t374);
    const double t450 = t442 + (motion->constants[2] * t410) + (t334 * t386) -
        (motion->constants[3] * t392) - (t332 * t378);
    const double t458 = t430 + (cos_psi * speeds[0]) + (t343 * t429) + (t346 * t378) - (t348 *
        t386);
    const double t462 = (t358 * t386) - t442 - (t356 * t378);
    const double t466 = 1.0 / ((t51 * t123) + (t36 * t147));
    const double t467 = t74 * t466;
    const double t468 = t118 * t467;
    const double t470 = t123 * t466;
    const double t473 = (cos_phi * t63) - (t13 * motion->constants[23]);
    const double t475 = t36 * t466;
    const double t484 = motion->constants[22] + (t25 * motion->constants[28]) + (sin_phi * t125) +
        (cos_phi * t129) - (cos_phi * t135);
    const double t487 = (sin_phi * t484) + (cos_phi * t137);
    const double t491 = (t66 * t475) - (t7 * t470);
    const double t493 = t257 + (motion->constants[28] * t91);
    const double t497 = (t13 * t63) - (t7 * t484);
    const double t498 = t466 * t497;
    const double t502 = (t66 * t484) + (t13 * t137);
    const double t503 = t466 * t502;
    const double t508 = (t470 * t473) + (t475 * t487) + (t491 * t493) + (t101 * t498) + (t118 *
        t503);
    const double t510 = sin_phi * t51;
    const double t512 = sin_phi * t147;
    const double t514 = (t123 * t510) + (t36 * t512);
    const double t515 = t466 * t514;
    const double t516 = speeds[1] * t515;
    const double t520 = (t13 * sin_phi) - (cos_phi * t66);
    const double t523 = (t475 * t520) + (t16 * t470);
    const double t526 = (speeds[1] * t523) + (t81 * t516);
    const double t530 = (t51 * t101) + (t118 * t147);
    const double t531 = t36 * t467;
    const double t532 = t466 * t531;
    const double t539 = t466 * ((t123 * t497) + (t36 * t502) + (t141 * t514));
    const double t540 = t466 * t539;
    const double t542 = t148 * t515;
    const double t543 = t466 * t542;
    const double t546 = (speeds[2] * t532) + (speeds[1] * t540) + (speeds[0] * t543);
    const double t550 = (t101 * t510) + (t118 * t512);
    const double t551 = t141 * t466;
    const double t553 = t148 * t466;
    const double t555 = (speeds[1] * t551) + (speeds[0] * t553);
    const double t557 = t13 * t475;
    const double t560 = speeds[0] * t515;
    const double t563 = sin_phi * t36;
    const double t568 = (t36 * t546) - (speeds[1] * t557) - (t104 * t516) - (t53 * t560) - (t555 *
        t563);
    const double t570 = t13 * t470;
    const double t575 = sin_phi * t123;
    const double t580 = (t149 * t560) + (t123 * t546) - (speeds[1] * t570) - (t144 * t516) - (t555 *
        t575);
    const double t586 = (t530 * t546) + (t120 * t580) - (speeds[2] * t468) - (speeds[1] * t508) -
        (t69 * t516) - (motion->constants[24] * t526);
    const double t588 = t586 - (t550 * t555) - (t103 * t568);
    const double t590 = t187 * t467;
    const double t593 = t484 + (t13 * motion->constants[24]);
    const double t596 = t255 + (motion->constants[28] * t170);
    const double t602 = (t177 * t498) + (t187 * t503) - (t470 * t593) - (t491 * t596);
    const double t608 = (t51 * t177) + (t147 * t187);
    const double t612 = (t177 * t510) + (t187 * t512);
    const double t620 = (motion->constants[23] * t526) + (t546 * t608) + (t180 * t568) + (t190 *
        t580) - (speeds[2] * t590) - (speeds[1] * t602);
    const double t622 = t620 - (t160 * t516) - (t555 * t612);
    const double t624 = t7 * t13;
    const double t626 = t13 * t491;
    const double t627 = t626 - (t470 * t624);
    const double t633 = (t66 * t568) - (t7 * t580);
    const double t636 = (t196 * t516) - (speeds[1] * t627) - (t12 * t526) - t633;
    const double t638 = t12 * t13;
    const double t641 = (t470 * t638) + (t16 * t491);
    const double t650 = (speeds[1] * t641) + (t205 * t516) + (t7 * t526) + (t80 * t568) + (t12 *
        t580);
    const double t652 = (motion->constants[2] * t636) + (motion->constants[3] * t650);
    const double t654 = (t157 * t622) + t652 - (t58 * t588);
    const double t656 = t633 + (speeds[1] * t626);
    const double t658 = t223 * t491;
    const double t663 = (t115 * t568) + (t94 * t580) - (speeds[1] * t658);
    const double t670 = t652 + (motion->constants[2] * t656) + (t230 * t622) -
        (motion->constants[3] * t663) - (t228 * t588);
    const double t681 = (t244 * t663) + (motion->constants[23] * t636) + (t290 * t622) -
        (motion->constants[26] * t656) - (motion->constants[24] * t650) - (t287 * t588);
    const double t687 = sin_phi * t563;
    const double t692 = (t555 * t687) + (t64 * t560) - (t546 * t563);
    const double t697 = (motion->constants[3] * t636) + (t314 * t622) - (speeds[2] * t475) -
        (motion->constants[2] * t650) - (t312 * t588) - t692;
    const double t698 = t25 * t491;
    const double t706 = (t321 * t568) - (t323 * t580);
    const double t711 = (motion->constants[3] * t656) + (motion->constants[2] * t663) + (t334 *
        t622) - (speeds[1] * t698) - (t332 * t588) - t706;
    const double t712 = t343 * t475;
    const double t718 = t692 + (speeds[2] * t712) + (t346 * t588) - (t348 * t622);
    const double t719 = t354 * t491;
    const double t725 = t706 + (t358 * t622) - (speeds[1] * t719) - (t356 * t588);
    const double t727 = speeds[1] * t81;
    const double t731 = (speeds[1] * t104) + (t53 * speeds[0]);
    const double t735 = (speeds[1] * t144) - (speeds[0] * t149);
    const double t739 = (t69 * speeds[1]) + (motion->constants[24] * t727) + (t120 * t735) - (t103 *
        t731);
    const double t747 = (speeds[1] * t160) + (t180 * t731) + (t190 * t735) -
        (motion->constants[23] * t727);
    const double t753 = (t66 * t731) - (t7 * t735);
    const double t755 = (t12 * t727) - (speeds[1] * t196) - t753;
    const double t763 = (t80 * t731) + (t12 * t735) - (speeds[1] * t205) - (t7 * t727);
    const double t765 = (motion->constants[2] * t755) + (motion->constants[3] * t763);
    const double t767 = (t157 * t747) + t765 - (t58 * t739);
    const double t771 = (t115 * t731) + (t94 * t735);
    const double t778 = t765 + (motion->constants[2] * t753) + (t230 * t747) -
        (motion->constants[3] * t771) - (t228 * t739);
    const double t789 = (t244 * t771) + (motion->constants[23] * t755) + (t290 * t747) -
        (motion->constants[26] * t753) - (motion->constants[24] * t763) - (t287 * t739);
    const double t790 = t64 * speeds[0];
    const double t798 = t790 + (motion->constants[3] * t755) + (t314 * t747) -
        (motion->constants[2] * t763) - (t312 * t739);
    const double t801 = (t323 * t735) - (t321 * t731);
    const double t809 = t801 + (motion->constants[3] * t753) + (motion->constants[2] * t771) +
        (t334 * t747) - (t332 * t739);
    const double t813 = (t346 * t739) - t790 - (t348 * t747);
    const double t817 = (t358 * t747) - t801 - (t356 * t739);
    const double t819 = motion->constants[28] + (t25 * motion->constants[22]);
    const double t820 = 1.0 / t819;
    const double t821 = t74 * t820;
    const double t822 = t101 * t821;
    const double t824 = speeds[1] * t820;
    const double t829 = (t7 * t36) + (t66 * t123);
    const double t836 = (t123 * t487) + (t493 * t829) + (t101 * t502) - (t36 * t473) - (t118 *
        t497);
    const double t840 = (t36 * t51) - (t123 * t147);
    const double t841 = t820 * t840;
    const double t842 = speeds[2] * t841;
    const double t844 = t824 * t840;
    const double t848 = (t36 * t510) - (t123 * t512);
    const double t851 = (t515 * t844) - (t824 * t848);
    const double t855 = (t123 * t520) - (t16 * t36);
    const double t860 = (t824 * t855) + (t523 * t844) + (t81 * t851);
    const double t864 = (t51 * t118) - (t101 * t147);
    const double t865 = t531 * t820;
    const double t868 = t542 * t820;
    const double t871 = (speeds[2] * t865) + (t539 * t824) + (speeds[0] * t868);
    const double t875 = (t118 * t510) - (t101 * t512);
    const double t877 = t148 * t820;
    const double t879 = (t141 * t824) + (speeds[0] * t877);
    const double t883 = speeds[0] * t841;
    const double t886 = (t532 * t842) + (t540 * t844) + (t543 * t883);
    const double t890 = (t551 * t844) + (t553 * t883);
    const double t892 = t13 * t123;
    const double t896 = t820 * t848;
    const double t899 = (t515 * t883) - (speeds[0] * t896);
    const double t909 = (t824 * t892) + (t557 * t844) + (t104 * t851) + (t53 * t899) + (t575 *
        t879) + (t563 * t890);
    const double t911 = t909 - (t123 * t871) - (t36 * t886);
    const double t913 = t13 * t36;
    const double t926 = (t570 * t844) + (t144 * t851) + (t36 * t871) + (t575 * t890) - (t824 *
        t913) - (t149 * t899);
    const double t928 = t926 - (t563 * t879) - (t123 * t886);
    const double t930 = t91 * motion->constants[22];
    const double t938 = t820 * ((t123 * t502) + (t539 * t840) - (t36 * t497) - (t141 * t848));
    const double t939 = t820 * t938;
    const double t940 = speeds[1] * t939;
    const double t944 = t820 * ((t74 * t123) + (t531 * t840));
    const double t945 = t820 * t944;
    const double t950 = t820 * ((t542 * t840) - (t148 * t848));
    const double t951 = t820 * t950;
    const double t954 = t940 + (speeds[2] * t945) + (speeds[0] * t951);
    const double t960 = (speeds[2] * t822) + (t824 * t836) + (t468 * t842) + (t508 * t844) + (t69 *
        t851) + (motion->constants[24] * t860);
    const double t965 = t960 + (t864 * t871) + (t550 * t890) + (t120 * t928) - (t875 * t879) -
        (t530 * t886);
    const double t967 = t965 - (t103 * t911) - (t930 * t954);
    const double t969 = t177 * t821;
    const double t977 = (t36 * t593) + (t177 * t502) - (t596 * t829) - (t187 * t497);
    const double t985 = (t51 * t187) - (t147 * t177);
    const double t989 = (t187 * t510) - (t177 * t512);
    const double t995 = t170 * motion->constants[22];
    const double t1001 = (speeds[2] * t969) + (t824 * t977) + (t590 * t842) + (t602 * t844) +
        (t160 * t851) + (t871 * t985);
    const double t1006 = t1001 + (t612 * t890) + (t180 * t911) + (t190 * t928) + (t954 * t995) -
        (motion->constants[23] * t860);
    const double t1008 = t1006 - (t879 * t989) - (t608 * t886);
    const double t1011 = t13 * t829;
    const double t1012 = (t36 * t624) + t1011;
    const double t1019 = (t66 * t911) - (t7 * t928);
    const double t1023 = (t824 * t1012) + (t627 * t844) + (t12 * t860) - (t196 * t851) - t1019;
    const double t1027 = (t36 * t638) - (t16 * t829);
    const double t1038 = (t824 * t1027) + (t80 * t911) + (t12 * t928) - (t641 * t844) - (t205 *
        t851) - (t7 * t860);
    const double t1040 = (motion->constants[2] * t1023) + (motion->constants[3] * t1038);
    const double t1042 = (t157 * t1008) + t1040 - (t58 * t967);
    const double t1046 = (t824 * t1011) + (t626 * t844) - t1019;
    const double t1048 = t223 * t829;
    const double t1055 = (t824 * t1048) + (t658 * t844) + (t115 * t911) + (t94 * t928);
    const double t1062 = t1040 + (t230 * t1008) - (motion->constants[2] * t1046) -
        (motion->constants[3] * t1055) - (t228 * t967);
    const double t1073 = (motion->constants[26] * t1046) + (t244 * t1055) + (motion->constants[23] *
        t1023) + (t290 * t1008) - (motion->constants[24] * t1038) - (t287 * t967);
    const double t1074 = t123 * t820;
    const double t1081 = sin_phi * t575;
    const double t1090 = (t879 * t1081) + (t687 * t890) + (t64 * t899) - (t563 * t886) - (t575 *
        t871);
    const double t1095 = (speeds[2] * t1074) + (t475 * t842) + (motion->constants[3] * t1023) +
        (t314 * t1008) + t1090 - (motion->constants[2] * t1038);
    const double t1096 = t1095 - (t312 * t967);
    const double t1097 = t25 * t829;
    const double t1106 = (t321 * t911) - (t323 * t928);
    const double t1111 = (t824 * t1097) + (t698 * t844) + (motion->constants[2] * t1055) + (t334 *
        t1008) - t954 - (motion->constants[3] * t1046);
    const double t1113 = t1111 - (t332 * t967) - t1106;
    const double t1114 = t343 * t1074;
    const double t1122 = (t346 * t967) - t1090 - (speeds[2] * t1114) - (t712 * t842) - (t348 *
        t1008);
    const double t1123 = t354 * t829;
    const double t1133 = t1106 + (t824 * t1123) + (t719 * t844) + (t354 * t954) + (t358 * t1008) -
        (t356 * t967);
    const double t1137 = sin_delta * motion->constants[45];
    const double t1138 = sin_delta * t1137;
    const double t1142 = motion->constants[35] + motion->constants[40] + motion->constants[47] -
        t1138;
    const double t1144 = cos_delta * motion->constants[38];
    const double t1145 = motion->constants[23] * t1144;
    const double t1148 = t1145 + t1145 + motion->constants[50];
    const double t1151 = motion->constants[36] + motion->constants[43];
    const double t1152 = t1148 + t1151;
    const double t1153 = t1152 - t1142;
    const double t1154 = t7 * t7;
    const double t1156 = t7 * t12;
    const double t1158 = motion->constants[24] * t1144;
    const double t1162 = cos_delta * motion->constants[41];
    const double t1163 = motion->constants[32] + t1162;
    const double t1166 = t1163 - motion->constants[48] - t1158 - motion->constants[49];
    const double t1167 = t1166 + t1166;
    const double t1169 = (t1153 * t1154) + (t1156 * t1167);
    const double t1170 = sin_phi * motion->constants[21];
    const double t1171 = sin_delta * motion->constants[38];
    const double t1172 = t1170 * t1171;
    const double t1174 = t1170 * motion->constants[51];
    const double t1177 = (t1170 * t1174) - t1172 - t1172;
    const double t1182 = t1144 + motion->constants[30];
    const double t1183 = motion->constants[46] + t1182;
    const double t1185 = (t12 * motion->constants[52]) - (t7 * t1183);
    const double t1186 = t74 * t1185;
    const double t1187 = t74 * motion->constants[51];
    const double t1188 = t74 * t1187;
    const double t1190 = t1188 - t1186 - t1186;
    const double t1191 = sin_delta * motion->constants[41];
    const double t1193 = t1191 - (motion->constants[24] * t1171);
    const double t1197 = (cos_delta * t1137) - (motion->constants[23] * t1171);
    const double t1201 = (t7 * motion->constants[52]) + (t12 * t1183);
    const double t1204 = (t7 * t1193) + (t12 * t1197) + (t1170 * t1201);
    const double t1206 = t148 - (sin_phi * t542);
    const double t1213 = t1166 + (t1153 * t1156) + (t74 * t1201) - (t1154 * t1167);
    const double t1214 = cos_phi * t542;
    const double t1222 = t1138 + motion->constants[47] + t1148 + t1190 + motion->constants[33] +
        motion->constants[42];
    const double t1232 = (t12 * t1193) + (t1170 * t1185) + (t74 * t1171) - (t7 * t1197) - (t74 *
        t1174);
    const double t1239 = t1152 + t1177 - t1169;
    const double t1245 = t1206 * motion->constants[18];
    const double t1247 = t12 * sin_delta;
    const double t1249 = t7 * sin_delta;
    const double t1253 = t950 + (cos_delta * t1206) - t1247 - (t1214 * t1249);
    const double t1255 = t1253 * motion->constants[19];
    const double t1262 = t1142 + t1169 + t1177 + t1190 + (t1204 * t1206) + (t1206 * (t1204 +
        (t1206 * t1222) - (t1214 * t1232))) + (t1206 * t1245);
    const double t1265 = t1262 + (t1253 * t1255) - (t1213 * t1214) - (t1214 * (t1213 + (t1206 *
        t1232) - (t1214 * t1239)));
    const double t1266 = 1.0 / t1265;
    const double t1271 = (speeds[0] * t542) + (speeds[1] * t539) + (speeds[2] * t531);
    const double t1272 = sin_phi * t1271;
    const double t1273 = t301 - t1272;
    const double t1275 = cos_phi * t1271;
    const double t1277 = (t12 * speeds[0]) + (t7 * t1275);
    const double t1278 = motion->constants[32] * t1277;
    const double t1281 = (t7 * speeds[0]) - (t12 * t1275);
    const double t1283 = t1278 + (motion->constants[36] * t1281);
    const double t1286 = speeds[2] + t1273;
    const double t1288 = (motion->constants[33] * t1273) + (motion->constants[18] * t1286);
    const double t1290 = (t1273 * t1283) - (t1281 * t1288);
    const double t1292 = motion->constants[25] * t1272;
    const double t1293 = t1275 * t1292;
    const double t1295 = sin_phi * motion->constants[44];
    const double t1296 = t302 * t1275;
    const double t1299 = t1293 - (t74 * t1296);
    const double t1300 = t1295 + t1299;
    const double t1302 = t301 * t1281;
    const double t1303 = speeds[0] * t1272;
    const double t1304 = motion->constants[24] * t1273;
    const double t1306 = motion->constants[23] * t1273;
    const double t1308 = (t1281 * t1304) + (t1277 * t1306);
    const double t1310 = t301 * t1277;
    const double t1311 = (t12 * t1303) + t1310;
    const double t1314 = t1302 + (t7 * t1303);
    const double t1318 = t1308 + (motion->constants[23] * t1311) + (motion->constants[24] * t1314) -
        t1299;
    const double t1321 = motion->constants[23] * t1281;
    const double t1322 = motion->constants[24] * t1277;
    const double t1323 = t1321 - t1322;
    const double t1325 = (t1273 * t1306) + (t1281 * t1323);
    const double t1326 = speeds[0] * t1275;
    const double t1329 = speeds[0] * t302;
    const double t1330 = t1303 + t1329;
    const double t1332 = motion->constants[25] * speeds[0];
    const double t1333 = t1275 * t1332;
    const double t1335 = (t74 * t1326) + (t1170 * t1330) + t1333;
    const double t1339 = t302 - t1272;
    const double t1341 = (t1292 * t1339) - (speeds[0] * t1332);
    const double t1342 = (t1170 * t1296) + t1341;
    const double t1346 = (t12 * t1335) + (t7 * t1342) - t1325 - (motion->constants[24] * t1326);
    const double t1348 = speeds[1] + t1281;
    const double t1352 = (cos_delta * t1273) - (sin_delta * t1277);
    const double t1353 = motion->constants[27] * t1352;
    const double t1357 = (cos_delta * t1277) + (sin_delta * t1273);
    const double t1358 = motion->constants[26] * t1352;
    const double t1363 = speeds[1] * t1352;
    const double t1365 = t1363 - (cos_delta * t1314) - (sin_delta * t1326);
    const double t1367 = t30 * t819;
    const double t1372 = (speeds[0] * t950) + (speeds[1] * t938) + (speeds[2] * t944);
    const double t1374 = t1311 + (t1357 * t1372);
    const double t1376 = t27 * t819;
    const double t1378 = t1365 - (t1348 * t1372);
    const double t1380 = t26 * t39;
    const double t1383 = (t30 * t1357) + (t27 * t1348);
    const double t1384 = t1380 * t1383;
    const double t1385 = t27 * t1384;
    const double t1386 = motion->constants[28] * t1385;
    const double t1388 = t30 * t1384;
    const double t1389 = motion->constants[28] * t1388;
    const double t1395 = (cos_delta * t1318) + (t1348 * t1353) + (t1357 * t1358) +
        (motion->constants[26] * t1311) + (t1367 * t1374) + (t1348 * t1386);
    const double t1399 = t1395 + (t1357 * t1389) - (sin_delta * t1346) - (motion->constants[27] *
        t1365) - (t1376 * t1378);
    const double t1404 = motion->constants[26] * t1348;
    const double t1405 = motion->constants[27] * t1357;
    const double t1406 = t1404 - t1405;
    const double t1410 = speeds[1] * t1357;
    const double t1412 = (sin_delta * t1314) - (cos_delta * t1326) - t1410;
    const double t1415 = t39 * motion->constants[22];
    const double t1417 = t1352 + t1372;
    const double t1421 = (t30 * t1348) - (t27 * t1357);
    const double t1422 = motion->constants[28] * t1421;
    const double t1428 = (cos_delta * t1346) + (sin_delta * t1318) + (motion->constants[27] *
        t1412) + (t1376 * t1412) - (t1352 * t1358) - (t1348 * t1406);
    const double t1431 = t1428 - (t1374 * t1415) - (t1389 * t1417) - (t1348 * t1422);
    const double t1435 = (t1277 * t1323) - (t1273 * t1304);
    const double t1450 = t1435 + (motion->constants[23] * t1326) + (t7 * t1335) + (t1357 * t1406) +
        (t1378 * t1415) + (t1357 * t1422);
    const double t1455 = t1450 - (t12 * t1342) - (t1352 * t1353) - (motion->constants[26] * t1412) -
        (t1367 * t1412) - (t1386 * t1417);
    const double t1457 = (t30 * t1431) + (t27 * t1455);
    const double t1462 = t53 * ((t39 * t1399) + (t25 * t1457));
    const double t1466 = t466 * ((t25 * t1399) + (t514 * t1462) - (t39 * t1457));
    const double t1468 = t1303 - (cos_phi * t1466);
    const double t1470 = t1302 + (t7 * t1468);
    const double t1473 = t1310 + (t12 * t1468);
    const double t1477 = motion->constants[32] * t1281;
    const double t1478 = (motion->constants[35] * t1277) + t1477;
    const double t1480 = (t1277 * t1288) - (t1273 * t1478);
    const double t1485 = t1308 + (motion->constants[23] * t1473) + (motion->constants[24] * t1470) -
        t1300;
    const double t1488 = t1326 - t1462;
    const double t1489 = (sin_phi * t1466) + t1488;
    const double t1495 = (t74 * t1489) + t1333 + (t1170 * (t1329 + t1468));
    const double t1497 = cos_phi * motion->constants[44];
    const double t1498 = t1342 + t1497;
    const double t1500 = (t7 * t1498) + (t12 * t1495);
    const double t1502 = t1500 - (motion->constants[24] * t1489) - t1325;
    const double t1504 = (cos_delta * t1485) - (sin_delta * t1502);
    const double t1509 = t1363 - (sin_delta * t1489) - (cos_delta * t1470);
    const double t1514 = (motion->constants[42] * t1352) + (motion->constants[19] * t1417);
    const double t1517 = motion->constants[41] * t1348;
    const double t1518 = (motion->constants[40] * t1357) + t1517;
    const double t1520 = (t1357 * t1514) - (t1352 * t1518);
    const double t1523 = (motion->constants[38] * t1504) + (motion->constants[41] * t1509) +
        (motion->constants[43] * t1473) + t1520;
    const double t1527 = (cos_delta * t1502) + (sin_delta * t1485);
    const double t1533 = (sin_delta * t1470) - (cos_delta * t1489) - t1410;
    const double t1535 = motion->constants[38] * t1352;
    const double t1537 = motion->constants[38] * t1348;
    const double t1538 = t1357 * motion->constants[39];
    const double t1539 = t1537 - t1538;
    const double t1541 = (t1352 * t1535) + (t1348 * t1539);
    const double t1543 = (motion->constants[37] * t1527) + (motion->constants[39] * t1533) - t1541;
    const double t1548 = t1352 * motion->constants[39];
    const double t1551 = (t1348 * t1548) + (t1357 * t1535);
    const double t1554 = (t1504 * motion->constants[37]) + (motion->constants[38] * t1473) + t1551 -
        (t1509 * motion->constants[39]);
    const double t1556 = (sin_delta * t1543) + (cos_delta * t1554);
    const double t1562 = (motion->constants[36] * t1473) + t1480 + t1523 + (motion->constants[23] *
        t1556) - (motion->constants[30] * t1300) - (motion->constants[32] * t1470);
    const double t1570 = motion->constants[41] * t1357;
    const double t1572 = t1570 + (motion->constants[43] * t1348);
    const double t1575 = (t1352 * t1572) - (t1348 * t1514);
    const double t1578 = (motion->constants[40] * t1509) + (motion->constants[41] * t1473) + t1575 -
        (t1504 * motion->constants[39]);
    const double t1584 = (t12 * t1498) - (t7 * t1495);
    const double t1586 = t1435 + (motion->constants[23] * t1489) - t1584;
    const double t1596 = t820 * ((t30 * t1455) + (t840 * t1466) - (t27 * t1431) - (t848 * t1462));
    const double t1598 = motion->constants[19] * (t1533 + t1596);
    const double t1601 = (t1348 * t1518) - (t1357 * t1572);
    const double t1605 = (t1527 * motion->constants[39]) + (motion->constants[42] * t1533) + t1598 +
        t1601 - (motion->constants[38] * t1586);
    const double t1612 = t1290 + (motion->constants[31] * t1300) + (motion->constants[32] * t1473) +
        (cos_delta * t1578) - (motion->constants[35] * t1470) - (sin_delta * t1605);
    const double t1613 = t1612 - (motion->constants[24] * t1556);
    const double t1618 = motion->constants[30] * t1281;
    const double t1619 = t1277 * motion->constants[31];
    const double t1620 = t1618 - t1619;
    const double t1622 = t1273 * motion->constants[31];
    const double t1624 = (t1277 * t1620) - (t1273 * t1622);
    const double t1629 = (t1357 * t1539) - (t1352 * t1548);
    const double t1631 = (motion->constants[37] * t1586) + t1629 - (motion->constants[38] * t1533);
    const double t1634 = t1624 + t1631 - (t1584 * motion->constants[34]) + (motion->constants[30] *
        t1489);
    const double t1638 = motion->constants[30] * t1273;
    const double t1641 = (t1273 * t1638) + (t1281 * t1620);
    const double t1644 = (cos_delta * t1543) - (sin_delta * t1554);
    const double t1647 = (t1500 * motion->constants[34]) - (motion->constants[31] * t1489) + t1644 -
        t1641;
    const double t1656 = (t1281 * t1622) + (t1277 * t1638);
    const double t1661 = t74 * (t1556 + (motion->constants[30] * t1473) + (motion->constants[31] *
        t1470) + t1656 - (t1300 * motion->constants[34]));
    const double t1667 = (t1281 * t1478) - (t1277 * t1283);
    const double t1675 = (t7 * t1634) + (t12 * t1647);
    const double t1677 = (motion->constants[18] * t1489) + (t74 * t1675);
    const double t1682 = (motion->constants[31] * t1500) + (motion->constants[30] * t1584) -
        (motion->constants[33] * t1489) + t1667 + (sin_delta * t1578) + (cos_delta * t1605);
    const double t1685 = t1682 + (motion->constants[24] * t1644) - t1677 - (motion->constants[23] *
        t1631);
    const double t1691 = (t12 * t1562) + (t1170 * t1675) - (t7 * t1613);
    const double t1696 = forces[0] + (t1170 * ((t12 * t1634) - (t7 * t1647))) + (t1214 * t1691) -
        (t7 * t1562);
    const double t1700 = t1696 - (t12 * t1613) - t1661 - (t1206 * t1685) - (t950 * t1598);
    const double t1702 = t1145 + motion->constants[43];
    const double t1704 = t1162 - t1158;
    const double t1706 = t7 * t1171;
    const double t1710 = t141 - (sin_phi * t539);
    const double t1712 = cos_phi * t539;
    const double t1714 = t12 * t1171;
    const double t1715 = t74 * t1714;
    const double t1716 = t1193 + t1715;
    const double t1720 = t1716 + (t1222 * t1710) - (t1232 * t1712);
    const double t1726 = (t12 * t1702) - (t7 * t1704) - (t1170 * t1714);
    const double t1730 = t1726 + (t1232 * t1710) - (t1239 * t1712);
    const double t1736 = (t1249 * t1712) - t938 - (cos_delta * t1710);
    const double t1742 = (t7 * t1702) + (t12 * t1704) + (t74 * t1144) + (t1204 * t1710) + (t1206 *
        t1720) + (t1245 * t1710);
    const double t1747 = t1266 * (t1742 - (t1170 * t1706) - (t1213 * t1712) - (t1214 * t1730) -
        (t1255 * t1736));
    const double t1752 = motion->constants[18] * t1710;
    const double t1754 = motion->constants[19] * t1736;
    const double t1756 = t1265 * t1747;
    const double t1762 = motion->constants[43] + (t1710 * t1720) + (t1710 * t1716) + (t1710 *
        t1752) + (t1736 * t1754) - (t1712 * t1730);
    const double t1764 = t1762 - (t1712 * t1726) - (t1747 * t1756);
    const double t1765 = 1.0 / t1764;
    const double t1775 = forces[1] + (t1691 * t1712) - t1523 - (t1685 * t1710) - (t938 * t1598) -
        (t1700 * t1747);
    const double t1778 = t74 * (t1185 - t1187);
    const double t1779 = sin_phi * t531;
    const double t1781 = cos_phi * t531;
    const double t1784 = t1778 + (t1222 * t1779) + (t1232 * t1781);
    const double t1787 = t74 * (t1171 - t1174);
    const double t1791 = t1787 - (t1232 * t1779) - (t1239 * t1781);
    const double t1795 = 1.0 - t1779;
    const double t1800 = (t1249 * t1781) + (cos_delta * t1779) - t944;
    const double t1812 = (t1245 * t1795) - (t1204 * t1779) - (t1213 * t1781) - (t1206 * t1784) -
        (t1214 * t1791) - (t1255 * t1800);
    const double t1813 = t1266 * t1812;
    const double t1819 = t1715 + (t1752 * t1795) + (t1754 * t1800) - (t1710 * t1784) - (t1712 *
        t1791) - (t1716 * t1779);
    const double t1822 = t1765 * (t1819 - (t1726 * t1781) - (t1756 * t1813));
    const double t1832 = (t1685 * t1779) + (t1691 * t1781) + t1677 - (t944 * t1598) - (t1700 *
        t1813) - (t1775 * t1822);
    const double t1839 = motion->constants[19] * t1800;
    const double t1849 = t1188 + (t1779 * t1784) + (t1778 * t1779) + (motion->constants[18] *
        t1795 * t1795) + (t1800 * t1839) - (t1781 * t1791);
    const double t1853 = 1.0 / (t1849 - (t1781 * t1787) - (t1265 * t1813 * t1813) - (t1764 * t1822 *
        t1822));
    const double t1854 = t1832 * t1853;
    const double t1856 = (t1765 * t1775) - (t1822 * t1854);
    const double t1860 = (t1266 * t1700) - (t1747 * t1856) - (t1813 * t1854);
    const double t1861 = t1296 + t1860;
    const double t1864 = t1293 + t1295 - (t74 * t1861);
    const double t1872 = t1466 + (t542 * t1860) + (t539 * t1856) + (t531 * t1854);
    const double t1874 = t1303 - (cos_phi * t1872);
    const double t1877 = (t12 * t1860) - t1302 - (t7 * t1874);
    const double t1882 = t1310 + (t12 * t1874) + (t7 * t1860);
    const double t1888 = t1308 + (motion->constants[23] * t1882) - t1864 - (motion->constants[24] *
        t1877);
    const double t1895 = (t148 * t1860) + (t141 * t1856) - (sin_phi * t1872) - t1488;
    const double t1897 = t1854 + t1895;
    const double t1899 = t1329 + t1874;
    const double t1902 = (t74 * t1897) - t1333 - (t1170 * t1899);
    const double t1906 = t1341 + t1497 + (t1170 * t1861);
    const double t1908 = (t7 * t1906) - (t12 * t1902);
    const double t1910 = (motion->constants[24] * t1895) + t1908 - t1325;
    const double t1912 = (cos_delta * t1888) - (sin_delta * t1910);
    const double t1917 = t1363 + (cos_delta * t1877) + (sin_delta * t1895);
    const double t1919 = t1856 + t1882;
    const double t1923 = t1575 + (motion->constants[40] * t1917) + (motion->constants[41] * t1919) -
        (motion->constants[39] * t1912);
    const double t1927 = (cos_delta * t1910) + (sin_delta * t1888);
    const double t1932 = (t12 * t1906) + (t7 * t1902);
    const double t1934 = t1435 - (motion->constants[23] * t1895) - t1932;
    const double t1939 = (cos_delta * t1895) - t1410 - (sin_delta * t1877);
    const double t1947 = t1596 + t1939 + (t950 * t1860) + (t938 * t1856) + (t944 * t1854);
    const double t1948 = motion->constants[19] * t1947;
    const double t1952 = t1601 + (motion->constants[39] * t1927) + (motion->constants[42] * t1939) +
        t1948 - (motion->constants[38] * t1934);
    const double t1957 = (motion->constants[37] * t1927) + (motion->constants[39] * t1939) - t1541;
    const double t1964 = t1551 + (motion->constants[37] * t1912) + (motion->constants[38] * t1919) -
        (motion->constants[39] * t1917);
    const double t1966 = (sin_delta * t1957) + (cos_delta * t1964);
    const double t1972 = t1290 + (motion->constants[31] * t1864) + (motion->constants[35] * t1877) +
        (motion->constants[32] * t1882) + (cos_delta * t1923) - (sin_delta * t1952);
    const double t1973 = t1972 - (motion->constants[24] * t1966);
    const double t1979 = t1629 + (motion->constants[37] * t1934) - (motion->constants[38] * t1939);
    const double t1982 = t1624 + t1979 - (motion->constants[34] * t1932) - (motion->constants[30] *
        t1895);
    const double t1996 = t1480 + t1520 + (motion->constants[32] * t1877) + (motion->constants[36] *
        t1882) + (motion->constants[38] * t1912) + (motion->constants[41] * t1917) +
        (motion->constants[43] * t1919);
    const double t1998 = t1996 + (motion->constants[23] * t1966) - (motion->constants[30] * t1864);
    const double t2004 = (cos_delta * t1957) - (sin_delta * t1964);
    const double t2007 = (motion->constants[34] * t1908) + (motion->constants[31] * t1895) + t2004 -
        t1641;
    const double t2010 = (t1170 * t1214) + (t74 * t1206);
    const double t2012 = t820 * motion->constants[19];
    const double t2013 = t1455 * t2012;
    const double t2015 = t1431 * t2012;
    const double t2017 = t840 * t2012;
    const double t2018 = t466 * t1399;
    const double t2020 = t39 * t466;
    const double t2021 = t1431 * t2020;
    const double t2023 = t1455 * t2020;
    const double t2026 = (t91 * t2018) + (t92 * t2021) - (t98 * t2023);
    const double t2029 = (t2017 * t2026) - (t92 * t2013) - (t98 * t2015);
    const double t2031 = t7 * t1170;
    const double t2034 = t12 * motion->constants[34];
    const double t2036 = cos_delta * motion->constants[39];
    const double t2038 = sin_delta * motion->constants[39];
    const double t2040 = (cos_delta * t2038) - (sin_delta * t2036);
    const double t2043 = t1714 + (t7 * t2040);
    const double t2047 = (sin_delta * t2038) + (cos_delta * t2036);
    const double t2049 = sin_delta * motion->constants[37];
    const double t2052 = cos_delta * motion->constants[23];
    const double t2054 = cos_delta * motion->constants[24];
    const double t2058 = (t12 * t2052) + (t7 * t2054);
    const double t2060 = sin_delta * motion->constants[24];
    const double t2067 = (sin_delta * t2031) + (t12 * t2054) + (t1214 * t2058) + (t1206 * t2060) -
        (cos_delta * t74) - (t7 * t2052);
    const double t2068 = t2067 - (t1247 * t2010);
    const double t2070 = cos_delta * motion->constants[37];
    const double t2073 = sin_delta * motion->constants[23];
    const double t2078 = (t12 * t2073) + (t7 * t2060);
    const double t2086 = (t12 * t2060) + (t1214 * t2078) + (t94 * t2010) - (sin_delta * t74) -
        (cos_delta * t2031) - (t7 * t2073);
    const double t2087 = t2086 - (t1206 * t2054);
    const double t2093 = t1706 + (t2070 * t2087) - (t12 * t2040) - (t1214 * t2043) - (t1206 *
        t2047) - (t2049 * t2068);
    const double t2096 = (t2010 * t2034) + t2093 - (motion->constants[34] * t2031) - (t1206 *
        motion->constants[31]);
    const double t2098 = t12 * t1170;
    const double t2101 = t7 * motion->constants[34];
    const double t2106 = t2098 + (motion->constants[23] * t1206) + (t7 * t2010);
    const double t2110 = (motion->constants[37] * t2106) - t1714 - (t1214 * t1706);
    const double t2113 = (motion->constants[34] * t2098) + (t1182 * t1206) + (t2010 * t2101) +
        t2110;
    const double t2121 = (t12 * t1151) - (t7 * t1163);
    const double t2128 = (t12 * t1144) + (t7 * t2047);
    const double t2137 = (t12 * t2047) + (t1214 * t2128) + (t2068 * t2070) + (t2049 * t2087) - (t7 *
        t1144) - (t1206 * t2040);
    const double t2143 = (t1214 * t2121) + (motion->constants[38] * t2068) +
        (motion->constants[23] * t2137) - (t74 * motion->constants[30]) - (t7 * t1151) - (t12 *
        t1163);
    const double t2144 = t2143 - (t1191 * t1206);
    const double t2151 = (t12 * motion->constants[32]) - (t7 * motion->constants[35]);
    const double t2154 = sin_delta * motion->constants[42];
    const double t2156 = cos_delta * motion->constants[42];
    const double t2159 = t7 * t2154;
    const double t2166 = (t12 * t2154) + (t1214 * t2159) + (motion->constants[39] * t2087) - t1255 -
        (t1206 * t2156) - (motion->constants[38] * t2106);
    const double t2169 = cos_delta * motion->constants[40];
    const double t2171 = sin_delta * motion->constants[40];
    const double t2175 = (t12 * motion->constants[41]) - (t7 * t2169);
    const double t2181 = (t1214 * t2175) - (t7 * motion->constants[41]) - (t12 * t2169) - (t1206 *
        t2171) - (motion->constants[39] * t2068);
    const double t2187 = (t74 * motion->constants[31]) + (t1214 * t2151) + (cos_delta * t2181) -
        (t7 * motion->constants[32]) - (t12 * motion->constants[35]) - (motion->constants[24] *
        t2137);
    const double t2188 = t2187 - (sin_delta * t2166);
    const double t2192 = (cos_phi * t1170) - (sin_phi * t74);
    const double t2193 = t12 * t2192;
    const double t2195 = t7 * t2192;
    const double t2200 = motion->constants[23] * motion->constants[38];
    const double t2201 = sin_delta * t2200;
    const double t2203 = t7 * t2201;
    const double t2205 = motion->constants[33] + motion->constants[18];
    const double t2207 = t2205 + (cos_delta * t2200);
    const double t2211 = (t12 * motion->constants[31]) - (t7 * motion->constants[30]);
    const double t2221 = (t12 * t2201) + (t1214 * t2203) + (t2010 * t2211) +
        (motion->constants[24] * t2093) + (cos_delta * t2166) + (sin_delta * t2181);
    const double t2225 = t2221 - (motion->constants[31] * t2031) - (motion->constants[30] * t2098) -
        (t1206 * t2207) - (motion->constants[46] * t2106);
    const double t2231 = (t16 * t2188) - (t2096 * t2193) - (t2113 * t2195) - (t13 * t2144) -
        (sin_phi * t2225);
    const double t2233 = t53 * t1457;
    const double t2235 = t25 * t53;
    const double t2236 = t1431 * t2235;
    const double t2238 = t1455 * t2235;
    const double t2241 = (t91 * t2233) + (t98 * t2238) - (t92 * t2236);
    const double t2244 = (t515 * t2017) - (t848 * t2012);
    const double t2246 = t7 * t74;
    const double t2248 = t12 * t74;
    const double t2254 = t2225 + (t515 * t2231) - (t1253 * t2244) - (t2113 * t2246) - (t2096 *
        t2248);
    const double t2256 = t819 * t1412;
    const double t2257 = motion->constants[28] * t1348;
    const double t2259 = (t1357 * t2257) - t2256;
    const double t2261 = motion->constants[28] * t1384;
    const double t2262 = t1417 * t2261;
    const double t2263 = motion->constants[28] * t1357;
    const double t2265 = t2262 + (t1357 * t2263);
    const double t2268 = t1342 + (t92 * t2259) + (t98 * t2265);
    const double t2270 = t27 * t2020;
    const double t2272 = (t30 * t2012) - (t2017 * t2270);
    const double t2275 = t27 * t2235;
    const double t2278 = (t2254 * t2275) - (t1253 * t2272) - (t2231 * t2270);
    const double t2280 = motion->constants[26] + t1367;
    const double t2281 = t2052 + t2280;
    const double t2286 = (t819 * t1374) + (t1357 * t2261);
    const double t2290 = (t1348 * t2261) - (t819 * t1378);
    const double t2294 = (t1303 * t2281) + (t98 * t2290) - (sin_delta * t1335) - (t92 * t2286);
    const double t2295 = t25 * t466;
    const double t2296 = t2017 * t2295;
    const double t2299 = t39 * t53;
    const double t2302 = (t2231 * t2295) + (t2254 * t2299) - (t1253 * t2296);
    const double t2304 = t2073 - t1415;
    const double t2308 = t2262 + (t1348 * t2257);
    const double t2311 = t2256 + (t1348 * t2263);
    const double t2315 = (t1303 * t2304) + (cos_delta * t1335) + (t92 * t2308) + (t98 * t2311);
    const double t2317 = t30 * t2020;
    const double t2319 = (t27 * t2012) + (t2017 * t2317);
    const double t2322 = t30 * t2235;
    const double t2325 = (t1253 * t2319) + (t2254 * t2322) - (t2231 * t2317);
    const double t2327 = t26 * t1383;
    const double t2328 = t1380 * t2327;
    const double t2330 = t1357 * t1380;
    const double t2332 = t1348 * t1380;
    const double t2335 = (t98 * t2332) - (t91 * t2328) - (t92 * t2330);
    const double t2336 = t27 * motion->constants[28];
    const double t2337 = t1417 * t2336;
    const double t2339 = t1348 * t2336;
    const double t2340 = t30 * motion->constants[28];
    const double t2341 = t1357 * t2340;
    const double t2342 = t2339 + t2341;
    const double t2344 = t1417 * t2340;
    const double t2347 = (t2302 * t2342) - (t2278 * t2337) - (t2325 * t2344);
    const double t2350 = t1281 * motion->constants[31];
    const double t2352 = t1620 - t1619;
    const double t2356 = (t12 * t2350) + (t7 * t2352);
    const double t2359 = motion->constants[42] + motion->constants[19];
    const double t2361 = (t1357 * t2359) - t1518;
    const double t2364 = t1514 - (motion->constants[40] * t1352);
    const double t2366 = (cos_delta * t2364) - (sin_delta * t2361);
    const double t2368 = t1288 + t2366 - (motion->constants[35] * t1273);
    const double t2370 = motion->constants[32] * t1273;
    const double t2371 = motion->constants[41] * t1352;
    const double t2374 = t1572 - (t1348 * t2359);
    const double t2376 = (cos_delta * t2371) - (sin_delta * t2374);
    const double t2380 = (motion->constants[40] * t1348) - t1570 - t1572;
    const double t2381 = cos_delta * t2380;
    const double t2384 = t2370 + (cos_delta * t2376) - (sin_delta * t2381);
    const double t2388 = (t12 * t2368) - (t7 * t2384);
    const double t2396 = (motion->constants[35] * t1281) + (sin_delta * t2376) + (cos_delta *
        t2381) - t1278 - t1283;
    const double t2398 = t1548 + t1548;
    const double t2400 = t1539 - t1538;
    const double t2402 = (sin_delta * t2398) + (cos_delta * t2400);
    const double t2404 = t1348 * motion->constants[39];
    const double t2405 = motion->constants[38] * t1357;
    const double t2406 = t2404 + t2405;
    const double t2409 = (cos_delta * t1535) - (sin_delta * t2406);
    const double t2412 = t1535 + t1535;
    const double t2414 = (cos_delta * t2404) + (sin_delta * t2412);
    const double t2417 = motion->constants[24] * t1281;
    const double t2419 = cos_delta * speeds[1];
    const double t2421 = sin_delta * speeds[1];
    const double t2425 = t1353 + t1386;
    const double t2427 = (speeds[1] * t1415) - t1353 - t2425;
    const double t2431 = t1406 + t1422;
    const double t2434 = (speeds[1] * t2280) + t2431 - t1405 - (t1357 * t2336);
    const double t2436 = (cos_delta * t2434) - (sin_delta * t2427);
    const double t2441 = t1348 * motion->constants[27];
    const double t2442 = motion->constants[26] * t1357;
    const double t2447 = t2441 + t2442 - (speeds[1] * motion->constants[27]) - (speeds[1] * t1376);
    const double t2450 = t1358 + t1389;
    const double t2451 = (t1367 * t1372) + t2450;
    const double t2456 = (cos_delta * t1306) + (t301 * t2281) + (cos_delta * t2451) - (sin_delta *
        t2417) - (sin_delta * t2447);
    const double t2461 = t1358 + t2450;
    const double t2463 = t1372 * t1415;
    const double t2464 = motion->constants[27] + t1376;
    const double t2468 = t2339 + t2441 - t2463 - (speeds[1] * t2464);
    const double t2473 = (sin_delta * t1306) + (t301 * t2304) + (cos_delta * t2417) + (sin_delta *
        t2461) + (cos_delta * t2468);
    const double t2475 = t30 * t1380;
    const double t2476 = cos_delta * t2475;
    const double t2478 = t1323 - t1322;
    const double t2481 = t2110 + t2278 + (t1144 * t1206);
    const double t2487 = (t2098 * t2352) + (t2010 * t2356) + (t1214 * t2388) + (t2106 * t2402) +
        (t2068 * t2409) + (t2087 * t2414);
    const double t2492 = t2487 + (t1306 * t2137) + (t2093 * t2417) + (t301 * t2144) + (t2278 *
        t2436) + (t2302 * t2456);
    const double t2497 = t2492 + (t2325 * t2473) + (t2347 * t2476) + (t2478 * t2481) - (t74 *
        t1638) - (t2031 * t2350);
    const double t2502 = t2497 - (t7 * t2368) - (t12 * t2384) - (t1206 * t2396) - (t2166 * t2419) -
        (t2181 * t2421);
    const double t2505 = t1618 + t1620;
    const double t2507 = motion->constants[30] * t1277;
    const double t2509 = t2370 + t2371;
    const double t2513 = (t7 * t2507) - (t12 * t2505);
    const double t2518 = (motion->constants[43] * t1352) - t1514;
    const double t2522 = t1517 + t1518 - (motion->constants[43] * t1357);
    const double t2526 = (motion->constants[36] * t1273) + (cos_delta * t2518) - t1288 -
        (sin_delta * t2522);
    const double t2530 = (t12 * t2509) + (t7 * t2526);
    const double t2538 = t1477 + t1478 + (sin_delta * t2518) + (cos_delta * t2522) -
        (motion->constants[36] * t1277);
    const double t2541 = t1537 + t1539;
    const double t2544 = t1321 + t1323;
    const double t2548 = t2341 + t2442 - t2463;
    const double t2555 = t2425 + (cos_delta * t1304) + (t1372 * t1376) + (sin_delta * t2544);
    const double t2563 = (sin_delta * t1304) - t1404 - t2431 - (cos_delta * t2544) - (t1348 *
        t2340);
    const double t2565 = t27 * t1380;
    const double t2567 = motion->constants[23] * t1277;
    const double t2571 = (cos_delta * t1415) + (sin_delta * t2280);
    const double t2576 = t2054 + (cos_delta * motion->constants[27]) + (cos_delta * t1376);
    const double t2579 = t2060 + (sin_delta * t2464);
    const double t2582 = (t2302 * t2576) + (t2325 * t2579) - (t2278 * t2571);
    const double t2588 = (t2031 * t2505) + (t2098 * t2507) + (t7 * t2509) + (t2010 * t2513) +
        (t2106 * t2405) + (t1548 * t2068);
    const double t2593 = t2588 + (t1304 * t2137) + (t2278 * t2548) + (t2302 * t2555) + (t2325 *
        t2563) + (t2347 * t2565);
    const double t2598 = t2593 + (t2481 * t2567) + (t301 * t2582) - (t74 * t1622) - (t12 * t2526) -
        (t1214 * t2530);
    const double t2602 = t2598 - (t1206 * t2538) - (t2087 * t2541) - (t2093 * t2544) - (t301 *
        t2188);
    const double t2604 = motion->constants[19] * t1854;
    const double t2606 = motion->constants[19] * t1357;
    const double t2608 = motion->constants[19] * t1348;
    const double t2609 = cos_delta * t2608;
    const double t2613 = (t12 * t2606) + (t7 * t2609);
    const double t2615 = sin_delta * t2608;
    const double t2618 = t1386 + (t1348 * t1415);
    const double t2622 = (t1348 * t1376) + (t1357 * t1367);
    const double t2625 = t1389 + (t1357 * t1415);
    const double t2631 = (t12 * t2609) + (t1214 * t2613) + (t1206 * t2615) + (t2302 * t2622) - (t7 *
        t2606) - (t2278 * t2618);
    const double t2632 = t2631 - (t2325 * t2625);
    const double t2634 = (speeds[2] * t2632) - (t1253 * t2604);
    const double t2636 = motion->constants[19] * t1856;
    const double t2637 = t820 * t2636;
    const double t2640 = (t824 * t2632) - (t1253 * t2637);
    const double t2645 = cos_phi * t302;
    const double t2648 = (t146 * t1339) + (t1170 * t2645) - (sin_phi * t1292);
    const double t2650 = sin_phi * speeds[0];
    const double t2653 = cos_phi * speeds[0];
    const double t2656 = (t1170 * t2650) + (cos_phi * t1332) + (t74 * t2653);
    const double t2658 = (t7 * t2648) + (t12 * t2656);
    const double t2662 = (t12 * t2648) - (t7 * t2656);
    const double t2668 = (t74 * t2645) - (t146 * t1275) - (cos_phi * t1292);
    const double t2672 = (t12 * motion->constants[30]) + (t7 * motion->constants[31]);
    const double t2676 = (t74 * motion->constants[34]) - t2137 - t2211 - (t1214 * t2672);
    const double t2678 = t12 * t2650;
    const double t2681 = t7 * t2650;
    const double t2684 = sin_delta * t2653;
    const double t2686 = cos_delta * t2653;
    const double t2690 = (motion->constants[23] * t2653) + (t2280 * t2686) - t2662 - (t1415 *
        t2684);
    const double t2697 = t2658 - (motion->constants[24] * t2653);
    const double t2702 = (motion->constants[27] * t2684) + (t1376 * t2684) + (cos_delta * t2668) +
        (t2281 * t2678) - (sin_delta * t2697);
    const double t2710 = (sin_delta * t2668) + (t2304 * t2678) + (cos_delta * t2697) - (t2464 *
        t2686);
    const double t2715 = t1638 + t1638;
    const double t2717 = t1622 + t1622;
    const double t2721 = (t12 * t2715) + (t7 * t2717);
    const double t2726 = (cos_delta * t2361) + (sin_delta * t2364);
    const double t2728 = (t1277 * t2205) + t2726 - t1478;
    const double t2733 = (sin_delta * t2371) + (cos_delta * t2374);
    const double t2735 = sin_delta * t2380;
    const double t2739 = t1283 + (cos_delta * t2733) - (t1281 * t2205) - (sin_delta * t2735);
    const double t2743 = (t12 * t2728) - (t7 * t2739);
    const double t2747 = (sin_delta * t2733) + (cos_delta * t2735);
    const double t2751 = (sin_delta * t2400) - (cos_delta * t2398);
    const double t2755 = (sin_delta * t1535) + (cos_delta * t2406);
    const double t2759 = (sin_delta * t2404) - (cos_delta * t2412);
    const double t2761 = t2417 + t2567;
    const double t2763 = t1306 + t1306;
    const double t2769 = (cos_delta * t2427) + (sin_delta * t2434);
    const double t2777 = (cos_delta * t2761) + (sin_delta * t2763) + (cos_delta * t2447) +
        (sin_delta * t2451);
    const double t2785 = (sin_delta * t2761) + (sin_delta * t2468) - (cos_delta * t2763) -
        (cos_delta * t2461);
    const double t2787 = sin_delta * t2475;
    const double t2789 = t1304 + t1304;
    const double t2795 = (t2031 * t2715) + (t1214 * t2743) + (t2106 * t2751) + (t2068 * t2755) +
        (t2087 * t2759) + (t2137 * t2761);
    const double t2800 = t2795 + (t2181 * t2419) + (t2278 * t2769) + (t2302 * t2777) + (t2325 *
        t2785) + (t2347 * t2787);
    const double t2804 = t2800 - (t74 * (t2350 + t2507)) - (t2098 * t2717) - (t2010 * t2721) - (t7 *
        t2728);
    const double t2809 = t2804 - (t12 * t2739) - (t1206 * t2747) - (t2093 * t2763) - (t2166 *
        t2421) - (t2481 * t2789);
    const double t2817 = (t2096 * t2658) + (t2144 * t2678) + (t2278 * t2690) + (t2302 * t2702) +
        (t2325 * t2710) + (t2582 * t2681);
    const double t2822 = t2817 + (t16 * t2502) - (t2113 * t2662) - (t2668 * t2676) - (t2225 *
        t2653) - (t2188 * t2681);
    const double t2824 = t2822 - (sin_phi * t2809) - (t13 * t2602);
    const double t2828 = (t1854 * t2231) + (speeds[2] * t2824) + (t841 * t2634);
    const double t2834 = (t1856 * t2231) + (speeds[1] * t2824) + (t840 * t2640);
    const double t2836 = t74 * t1856;
    const double t2838 = speeds[0] * t1170;
    const double t2841 = t1292 + (t1170 * t1275);
    const double t2843 = (t12 * t2838) + (t7 * t2841);
    const double t2845 = (speeds[1] * t2843) - (t12 * t2836);
    const double t2850 = (t7 * t2838) - (t12 * t2841);
    const double t2851 = speeds[1] * t2850;
    const double t2852 = (t7 * t2836) - t2851;
    const double t2854 = t74 * t1275;
    const double t2855 = speeds[1] * t2854;
    const double t2857 = speeds[1] * t1277;
    const double t2860 = speeds[1] * t1281;
    const double t2867 = (cos_delta * t2854) + (t1277 * t2281) - (sin_delta * t2843);
    const double t2868 = speeds[1] * t2867;
    const double t2874 = (sin_delta * t2854) + (t1277 * t2304) + (cos_delta * t2843);
    const double t2875 = speeds[1] * t2874;
    const double t2885 = (t2096 * t2845) + (t2144 * t2857) + (t1856 * t2225) + (t2278 * t2851) +
        (t2302 * t2868) + (t2325 * t2875);
    const double t2890 = t2885 + (t2582 * t2860) + (speeds[1] * t2809) + (t515 * t2834) - (t2113 *
        t2852) - (t2676 * t2855);
    const double t2892 = t2890 - (t2188 * t2860) - (t848 * t2640);
    const double t2898 = (t855 * t2640) + (t523 * t2834) + (t81 * t2892);
    const double t2900 = t1466 * t2012;
    const double t2904 = motion->constants[19] * t1860;
    const double t2908 = (speeds[0] * t2632) - t1948 - (t1253 * t2904);
    const double t2912 = (t865 * t2634) + (t539 * t2640) + (t868 * t2908) - (t1253 * t2900);
    const double t2914 = t1462 * t2012;
    const double t2919 = (t141 * t2640) + (t877 * t2908) - (t1253 * t2914);
    const double t2921 = t466 * t1466;
    const double t2922 = t2017 * t2921;
    const double t2937 = (t7 * t1982) + (t12 * t2007);
    const double t2943 = t1667 + (motion->constants[31] * t1908) + (motion->constants[30] * t1932) +
        (motion->constants[33] * t1895) + (motion->constants[18] * t1897) + (sin_delta * t1923);
    const double t2947 = t2943 + (cos_delta * t1952) + (motion->constants[24] * t2004) -
        (motion->constants[23] * t1979) - (t74 * t2937);
    const double t2955 = (sin_phi * t2947) + (cos_phi * ((t12 * t1998) + (t1170 * t2937) - (t7 *
        t1973)));
    const double t2961 = t2955 + (t1860 * t2231) + (speeds[0] * t2824) + (t841 * t2908);
    const double t2966 = (t2231 * t2921) + (t532 * t2828) + (t540 * t2834) + (t543 * t2961) -
        (t1253 * t2922);
    const double t2968 = t466 * t1462;
    const double t2969 = t2017 * t2968;
    const double t2976 = (t2231 * t2968) + (t551 * t2834) + (t553 * t2961) - (t1253 * t2969);
    const double t2981 = t74 * t1860;
    const double t2984 = (speeds[0] * t2843) - (t12 * t2981);
    const double t2987 = speeds[0] * t2850;
    const double t2988 = (t7 * t2981) - t2987;
    const double t2990 = speeds[0] * t2854;
    const double t2992 = speeds[0] * t1277;
    const double t2995 = speeds[0] * t1281;
    const double t2998 = speeds[0] * t2867;
    const double t3000 = speeds[0] * t2874;
    const double t3010 = (t2096 * t2984) + (t2144 * t2992) + (t1860 * t2225) + (t2278 * t2987) +
        (t2302 * t2998) + (t2325 * t3000);
    const double t3015 = t3010 + (t2582 * t2995) + (speeds[0] * t2809) + (t515 * t2961) - t2947 -
        (t2113 * t2988);
    const double t3018 = t3015 - (t2676 * t2990) - (t2188 * t2995) - (t896 * t2908);
    const double t3028 = (t892 * t2640) + (t557 * t2834) + (t104 * t2892) + (t53 * t3018) + (t575 *
        t2919) + (t563 * t2976);
    const double t3030 = t3028 - (t123 * t2912) - (t36 * t2966);
    const double t3032 = t142 * t1462;
    const double t3046 = (t570 * t2834) + (t144 * t2892) + (t36 * t2912) + (t575 * t2976) - (t2254 *
        t3032) - (t913 * t2640);
    const double t3049 = t3046 - (t149 * t3018) - (t563 * t2919) - (t123 * t2966);
    const double t3053 = (t1596 * t2012) + (t939 * t2636);
    const double t3055 = t30 * t1412;
    const double t3059 = (t30 * t1374) - (t27 * t1378);
    const double t3061 = t27 * t1412;
    const double t3070 = (t1253 * t3053) + (t2302 * t3059) + (t2325 * t3061) - (t2278 * t3055) -
        (t940 * t2632) - (t945 * t2634);
    const double t3071 = t3070 - (t951 * t2908);
    const double t3077 = (t1170 * t1982) + (t1214 * t1998) + (t2007 * t2010) + (t1874 * t2144) +
        (t1860 * t2188) + (t2026 * t2231);
    const double t3082 = t3077 + (t2241 * t2254) + (t2294 * t2302) + (t2315 * t2325) + (t2335 *
        t2347) + (speeds[0] * t2502);
    const double t3087 = t3082 + (t822 * t2634) + (t836 * t2640) + (t468 * t2828) + (t508 * t2834) +
        (t69 * t2892);
    const double t3092 = t3087 + (motion->constants[24] * t2898) + (t864 * t2912) + (t550 * t2976) +
        (t120 * t3049) + (t930 * t3071);
    const double t3098 = t3092 - t1973 - (t1253 * t2029) - (t1902 * t2096) - (t1906 * t2113) -
        (t2268 * t2278) - (t1275 * t2602);
    const double t3101 = t3098 - (t875 * t2919) - (t530 * t2966) - (t103 * t3030);
    const double t3115 = (t28 * t466 * t1457) + (t170 * t2018) + (t172 * t2021) + (t174 * t2023);
    const double t3118 = (t172 * t2013) - (t174 * t2015) - (t2017 * t3115);
    const double t3132 = (t28 * t53 * t1399) + (t172 * t2236) + (t174 * t2238) - (t170 * t2233);
    const double t3134 = t28 * motion->constants[22];
    const double t3140 = t1335 + (t1378 * t3134) + (t172 * t2259) - (t174 * t2265);
    const double t3146 = (t172 * t2286) + (t174 * t2290) - (sin_delta * t1342);
    const double t3154 = (cos_delta * t1342) + (t174 * t2311) - (t1374 * t3134) - (t172 * t2308);
    const double t3162 = (t28 * t2327) + (t170 * t2328) + (t172 * t2330) + (t174 * t2332);
    const double t3184 = (t1982 * t2010) + (t1906 * t2096) + (t1860 * t2144) + (t2254 * t3132) +
        (t2278 * t3140) + (t2302 * t3146);
    const double t3189 = t3184 + (t2325 * t3154) + (t2347 * t3162) + (t1303 * t2582) + (t1275 *
        t2502) + (speeds[0] * t2602);
    const double t3194 = t3189 + (t969 * t2634) + (t977 * t2640) + (t590 * t2828) + (t602 * t2834) +
        (t160 * t2892);
    const double t3199 = t3194 + (t985 * t2912) + (t612 * t2976) + (t180 * t3030) + (t190 * t3049) -
        t1998;
    const double t3204 = t3199 - (t1170 * t2007) - (t1214 * t1973) - (t1253 * t3118) - (t1902 *
        t2113) - (t1874 * t2188);
    const double t3209 = t3204 - (t2231 * t3115) - (motion->constants[23] * t2898) - (t989 *
        t2919) - (t608 * t2966) - (t995 * t3071);
    const double t3211 = t7 * t1966;
    const double t3212 = motion->constants[38] * t1895;
    const double t3213 = sin_delta * t3212;
    const double t3215 = t12 * t1966;
    const double t3217 = t3215 + (t7 * t3213);
    const double t3220 = (cos_delta * t3212) - t1979;
    const double t3222 = motion->constants[37] * t1895;
    const double t3224 = t1273 * t1277;
    const double t3225 = t1882 + t3224;
    const double t3227 = t1273 * t1273;
    const double t3228 = t1281 * t1281;
    const double t3229 = t3227 + t3228;
    const double t3232 = t1311 + t3224;
    const double t3235 = (cos_delta * t3232) + (sin_delta * t3229);
    const double t3239 = (sin_delta * t3232) - (cos_delta * t3229);
    const double t3241 = t1277 * t1281;
    const double t3253 = (t12 * t3213) + (t1214 * t3217) + (t2137 * t3225) + (t1326 * t2278) +
        (t2302 * t3235) + (t2325 * t3239);
    const double t3258 = t3253 + (t2481 * t3241) + (t1027 * t2640) + (t80 * t3030) + (t12 * t3049) -
        t3211;
    const double t3263 = t3258 - (t1206 * t3220) - (t2106 * t3222) - (t2093 * t3229) - (t641 *
        t2834) - (t205 * t2892);
    const double t3264 = t3263 - (t7 * t2898);
    const double t3268 = motion->constants[16] - t239;
    const double t3272 = (motion->constants[2] * t3268) + (motion->constants[3] *
        motion->constants[17]);
    const double t3273 = motion->constants[15] * t3272;
    const double t3274 = t3273 + t3273;
    const double t3275 = t1352 * t1357;
    const double t3276 = t7 * t3275;
    const double t3277 = t1348 * t1352;
    const double t3278 = cos_delta * t3277;
    const double t3280 = t3278 + (sin_delta * t1939);
    const double t3282 = t12 * t3275;
    const double t3284 = t3282 + (t7 * t3280);
    const double t3286 = sin_delta * t3277;
    const double t3288 = (cos_delta * t1939) - t3286;
    const double t3292 = (t12 * t3280) + (t1214 * t3284) - t3276 - (t1206 * t3288);
    const double t3296 = (motion->constants[3] * t3268) - (motion->constants[2] *
        motion->constants[17]);
    const double t3297 = motion->constants[15] * t3296;
    const double t3298 = t3277 - t1917;
    const double t3300 = t1919 + t3275;
    const double t3302 = t1348 * t1348;
    const double t3303 = t1357 * t1357;
    const double t3304 = t3302 - t3303;
    const double t3306 = (cos_delta * t3300) - (sin_delta * t3304);
    const double t3310 = (t12 * t3298) + (t7 * t3306);
    const double t3314 = (sin_delta * t3300) + (cos_delta * t3304);
    const double t3318 = (t12 * t3306) + (t1214 * t3310) + (t1206 * t3314) - (t7 * t3298);
    const double t3321 = t1348 * t1357;
    const double t3322 = sin_delta * t3321;
    const double t3323 = (cos_delta * t1917) - t3322;
    const double t3326 = t3282 + (t7 * t3323);
    const double t3329 = cos_delta * t3321;
    const double t3330 = (sin_delta * t1917) + t3329;
    const double t3334 = t3276 - (t12 * t3323) - (t1214 * t3326) - (t1206 * t3330);
    const double t3338 = (cos_delta * t1912) + (sin_delta * t1927);
    const double t3340 = t7 * t3338;
    const double t3344 = (cos_delta * t1927) - (sin_delta * t1912);
    const double t3346 = t1352 * t1352;
    const double t3347 = t3303 + t3346;
    const double t3350 = t1939 + t3321;
    const double t3356 = (t12 * t3338) + (t1214 * t3340) + (t2068 * t3298) + (t2087 * t3350) -
        (t1206 * t3344) - (t2106 * t3347);
    const double t3360 = (t3274 * t3292) + (t3297 * t3318) + (t3274 * t3334) +
        (motion->constants[15] * t3356);
    const double t3362 = t3297 + t3297;
    const double t3364 = t3278 + t3322;
    const double t3368 = (t12 * t1919) - (t7 * t3364);
    const double t3370 = t3286 - t3329;
    const double t3374 = (t1214 * t3368) - (t7 * t1919) - (t12 * t3364) - (t1206 * t3370);
    const double t3379 = sin_delta * t1934;
    const double t3383 = (t12 * t1912) - (t7 * t3379);
    const double t3385 = cos_delta * t1934;
    const double t3387 = t3321 - t1939;
    const double t3390 = t3302 + t3346;
    const double t3396 = (t1214 * t3383) + (t1206 * t3385) + (t2106 * t3387) + (t2068 * t3300) -
        (t7 * t1912) - (t12 * t3379);
    const double t3397 = t3396 - (t2087 * t3390);
    const double t3401 = (t3362 * t3374) + (t3292 * t3362) + (t3273 * t3318) +
        (motion->constants[15] * t3397);
    const double t3403 = (motion->constants[2] * t3360) + (motion->constants[3] * t3401);
    const double t3406 = t1273 * t1281;
    const double t3407 = t3406 - t1877;
    const double t3409 = t1895 + t3241;
    const double t3411 = t1314 + t3406;
    const double t3413 = t3241 - t1326;
    const double t3415 = (cos_delta * t3411) - (sin_delta * t3413);
    const double t3419 = (sin_delta * t3411) + (cos_delta * t3413);
    const double t3421 = t1277 * t1277;
    const double t3422 = t3227 + t3421;
    const double t3430 = (t66 * t3030) - (t7 * t3049);
    const double t3435 = t3215 + (t1214 * t3211) + (t2137 * t3407) + (t2093 * t3409) + (t2302 *
        t3415) + (t2325 * t3419);
    const double t3440 = t3435 + (t1012 * t2640) + (t627 * t2834) + (t12 * t2898) - (t1206 *
        t2004) - (t2481 * t3422);
    const double t3442 = t3440 - (t196 * t2892) - t3430;
    const double t3445 = (motion->constants[3] * t3264) + (motion->constants[2] * t3442) - t3403;
    const double t3447 = (t157 * t3209) + t3445 - (t58 * t3101);
    const double t3452 = (t1170 * t1712) + (t74 * t1710);
    const double t3463 = (t1712 * t2058) + (t1710 * t2060) - (t1247 * t3452);
    const double t3469 = (t1712 * t2078) + (t94 * t3452) - (t1710 * t2054);
    const double t3474 = t1171 + (t2070 * t3469) - (t1712 * t2043) - (t1710 * t2047) - (t2049 *
        t3463);
    const double t3476 = (t2034 * t3452) + t3474 - (motion->constants[31] * t1710);
    const double t3483 = (motion->constants[23] * t1710) + (t7 * t3452);
    const double t3485 = (t1706 * t1712) - (motion->constants[37] * t3483);
    const double t3487 = t3485 - (t1182 * t1710) - (t2101 * t3452);
    const double t3499 = (t1712 * t2128) + (t2070 * t3463) + (t2049 * t3469) - t1144 - (t1710 *
        t2040);
    const double t3504 = (t1712 * t2121) + (motion->constants[38] * t3463) +
        (motion->constants[23] * t3499) - motion->constants[43] - (t1191 * t1710);
    const double t3515 = t1754 + (t1712 * t2159) + (motion->constants[39] * t3469) - (t1710 *
        t2156) - (motion->constants[38] * t3483);
    const double t3522 = (t1712 * t2175) - motion->constants[41] - (t1710 * t2171) -
        (motion->constants[39] * t3463);
    const double t3526 = (t1712 * t2151) + (cos_delta * t3522) - (motion->constants[24] * t3499) -
        (sin_delta * t3515);
    const double t3542 = (t1712 * t2203) + (t2211 * t3452) + (motion->constants[24] * t3474) +
        (cos_delta * t3515) + (sin_delta * t3522) - (t1710 * t2207);
    const double t3543 = t3542 - (motion->constants[46] * t3483);
    const double t3549 = (t2195 * t3487) + (t16 * t3526) - (t2193 * t3476) - (t13 * t3504) -
        (sin_phi * t3543);
    const double t3558 = t3543 + (t1736 * t2244) + (t2246 * t3487) + (t515 * t3549) - (t2248 *
        t3476);
    const double t3564 = (t1736 * t2272) + (t2275 * t3558) - (t2270 * t3549);
    const double t3570 = (t1736 * t2296) + (t2295 * t3549) + (t2299 * t3558);
    const double t3576 = (t2322 * t3558) - (t1736 * t2319) - (t2317 * t3549);
    const double t3582 = (t2342 * t3570) - (t2337 * t3564) - (t2344 * t3576);
    const double t3601 = t3564 + (t1144 * t1710) - t3485;
    const double t3607 = (t2356 * t3452) + (t1712 * t2388) + (t2402 * t3483) + (t2409 * t3463) +
        (t2414 * t3469) + (t1306 * t3499);
    const double t3612 = t3607 + (t2417 * t3474) + (t301 * t3504) + (t2436 * t3564) + (t2456 *
        t3570) + (t2473 * t3576);
    const double t3617 = t3612 + (t2476 * t3582) + (t2478 * t3601) - t2366 - (t1710 * t2396) -
        (t2419 * t3515);
    const double t3618 = t3617 - (t2421 * t3522);
    const double t3638 = (t2576 * t3570) + (t2579 * t3576) - (t2571 * t3564);
    const double t3644 = t2371 + (t2513 * t3452) + (t2405 * t3483) + (t1548 * t3463) + (t1304 *
        t3499) + (t2548 * t3564);
    const double t3649 = t3644 + (t2555 * t3570) + (t2563 * t3576) + (t2565 * t3582) + (t2567 *
        t3601) + (t301 * t3638);
    const double t3654 = t3649 - (t1712 * t2530) - (t1710 * t2538) - (t2541 * t3469) - (t2544 *
        t3474) - (t301 * t3526);
    const double t3666 = (t1712 * t2613) + (t1710 * t2615) + (t2622 * t3570) - t2606 - (t2618 *
        t3564) - (t2625 * t3576);
    const double t3668 = (t1736 * t2604) + (speeds[2] * t3666);
    const double t3674 = (t1736 * t2637) + (t824 * t3666) - (t820 * t1948);
    const double t3680 = t3499 + (t1712 * t2672);
    const double t3708 = (t1712 * t2743) + (t2751 * t3483) + (t2755 * t3463) + (t2759 * t3469) +
        (t2761 * t3499) + (t2419 * t3522);
    const double t3713 = t3708 + (t2769 * t3564) + (t2777 * t3570) + (t2785 * t3576) + (t2787 *
        t3582) - t2726;
    const double t3718 = t3713 - (t2721 * t3452) - (t1710 * t2747) - (t2763 * t3474) - (t2421 *
        t3515) - (t2789 * t3601);
    const double t3726 = (t2658 * t3476) + (t2662 * t3487) + (t2668 * t3680) + (t2678 * t3504) +
        (t2690 * t3564) + (t2702 * t3570);
    const double t3731 = t3726 + (t2710 * t3576) + (t2681 * t3638) + (t16 * t3618) - (t2653 *
        t3543) - (t2681 * t3526);
    const double t3733 = t3731 - (sin_phi * t3718) - (t13 * t3654);
    const double t3737 = (t1854 * t3549) + (speeds[2] * t3733) + (t841 * t3668);
    const double t3744 = t2955 + (t1856 * t3549) + (speeds[1] * t3733) + (t840 * t3674);
    const double t3763 = (t2845 * t3476) + (t2852 * t3487) + (t2855 * t3680) + (t2857 * t3504) +
        (t1856 * t3543) + (t2851 * t3564);
    const double t3768 = t3763 + (t2868 * t3570) + (t2875 * t3576) + (t2860 * t3638) + (speeds[1] *
        t3718) + (t515 * t3744);
    const double t3771 = t3768 - t2947 - (t2860 * t3526) - (t848 * t3674);
    const double t3777 = (t855 * t3674) + (t523 * t3744) + (t81 * t3771);
    const double t3784 = (t1736 * t2904) + (speeds[0] * t3666);
    const double t3788 = (t1736 * t2900) + (t865 * t3668) + (t539 * t3674) + (t868 * t3784);
    const double t3794 = (t1736 * t2914) + (t141 * t3674) + (t877 * t3784);
    const double t3804 = (t1860 * t3549) + (speeds[0] * t3733) + (t841 * t3784);
    const double t3809 = (t1736 * t2922) + (t2921 * t3549) + (t532 * t3737) + (t540 * t3744) +
        (t543 * t3804);
    const double t3817 = (t1736 * t2969) + (t2968 * t3549) + (t551 * t3744) + (t553 * t3804);
    const double t3839 = (t2984 * t3476) + (t2988 * t3487) + (t2990 * t3680) + (t2992 * t3504) +
        (t1860 * t3543) + (t2987 * t3564);
    const double t3844 = t3839 + (t2998 * t3570) + (t3000 * t3576) + (t2995 * t3638) + (speeds[0] *
        t3718) + (t515 * t3804);
    const double t3846 = t3844 - (t2995 * t3526) - (t896 * t3784);
    const double t3856 = (t892 * t3674) + (t557 * t3744) + (t104 * t3771) + (t53 * t3846) + (t575 *
        t3794) + (t563 * t3817);
    const double t3858 = t3856 - (t123 * t3788) - (t36 * t3809);
    const double t3873 = (t570 * t3744) + (t144 * t3771) + (t36 * t3788) + (t575 * t3817) - (t3032 *
        t3558) - (t913 * t3674);
    const double t3876 = t3873 - (t149 * t3846) - (t563 * t3794) - (t123 * t3809);
    const double t3890 = (t939 * t1948) + (t3059 * t3570) + (t3061 * t3576) - (t1736 * t3053) -
        (t3055 * t3564) - (t940 * t3666);
    const double t3892 = t3890 - (t945 * t3668) - (t951 * t3784);
    const double t3898 = (t1712 * t1998) + (t2007 * t3452) + (t1736 * t2029) + (t1906 * t3487) +
        (t1874 * t3504) + (t1860 * t3526);
    const double t3903 = t3898 + (t2026 * t3549) + (t2241 * t3558) + (t2294 * t3570) + (t2315 *
        t3576) + (t2335 * t3582);
    const double t3908 = t3903 + (speeds[0] * t3618) + (t822 * t3668) + (t836 * t3674) + (t468 *
        t3737) + (t508 * t3744);
    const double t3913 = t3908 + (t69 * t3771) + (motion->constants[24] * t3777) + (t864 * t3788) +
        (t550 * t3817) + (t120 * t3876);
    const double t3918 = t3913 + (t930 * t3892) - (t1902 * t3476) - (t2268 * t3564) - (t1275 *
        t3654) - (t875 * t3794);
    const double t3920 = t3918 - (t530 * t3809) - (t103 * t3858);
    const double t3955 = (t1982 * t3452) + (t1736 * t3118) + (t1906 * t3476) + (t1902 * t3487) +
        (t1860 * t3504) + (t3132 * t3558);
    const double t3960 = t3955 + (t3140 * t3564) + (t3146 * t3570) + (t3154 * t3576) + (t3162 *
        t3582) + (t1303 * t3638);
    const double t3965 = t3960 + (t1275 * t3618) + (speeds[0] * t3654) + (t969 * t3668) + (t977 *
        t3674) + (t590 * t3737);
    const double t3970 = t3965 + (t602 * t3744) + (t160 * t3771) + (t985 * t3788) + (t612 * t3817) +
        (t180 * t3858);
    const double t3975 = t3970 + (t190 * t3876) - (t1712 * t1973) - (t1874 * t3526) - (t3115 *
        t3549) - (motion->constants[23] * t3777);
    const double t3978 = t3975 - (t989 * t3794) - (t608 * t3809) - (t995 * t3892);
    const double t4000 = (t1712 * t3217) + (t3225 * t3499) + (t1326 * t3564) + (t3235 * t3570) +
        (t3239 * t3576) + (t3241 * t3601);
    const double t4005 = t4000 + (t1027 * t3674) + (t80 * t3858) + (t12 * t3876) - (t1710 * t3220) -
        (t3222 * t3483);
    const double t4009 = t4005 - (t3229 * t3474) - (t641 * t3744) - (t205 * t3771) - (t7 * t3777);
    const double t4014 = (t1712 * t3284) - t3275 - (t1710 * t3288);
    const double t4019 = t3298 - (t1712 * t3310) - (t1710 * t3314);
    const double t4024 = t3275 - (t1712 * t3326) - (t1710 * t3330);
    const double t4034 = (t1712 * t3340) + (t3298 * t3463) + (t3350 * t3469) - (t1710 * t3344) -
        (t3347 * t3483);
    const double t4038 = (t3274 * t4014) + (t3274 * t4024) + (motion->constants[15] * t4034) -
        (t3297 * t4019);
    const double t4043 = (t1712 * t3368) - t1919 - (t1710 * t3370);
    const double t4056 = (t1712 * t3383) + (t1710 * t3385) + (t3387 * t3483) + (t3300 * t3463) -
        t1912 - (t3390 * t3469);
    const double t4060 = (t3362 * t4043) + (t3362 * t4014) + (motion->constants[15] * t4056) -
        (t3273 * t4019);
    const double t4062 = (motion->constants[2] * t4038) + (motion->constants[3] * t4060);
    const double t4076 = (t66 * t3858) - (t7 * t3876);
    const double t4081 = (t1712 * t3211) + (t3407 * t3499) + (t3409 * t3474) + (t3415 * t3570) +
        (t3419 * t3576) + (t1012 * t3674);
    const double t4086 = t4081 + (t627 * t3744) + (t12 * t3777) - (t1710 * t2004) - (t3422 *
        t3601) - (t196 * t3771);
    const double t4087 = t4086 - t4076;
    const double t4090 = (motion->constants[3] * t4009) + (motion->constants[2] * t4087) - t4062;
    const double t4093 = (t157 * t3978) + t4090 - (t58 * t3920) - (t1747 * t3447);
    const double t4099 = t74 + (t1170 * t1781) - (t74 * t1779);
    const double t4110 = (t1781 * t2058) - (t1779 * t2060) - (t1247 * t4099);
    const double t4116 = (t1781 * t2078) + (t1779 * t2054) + (t94 * t4099);
    const double t4120 = (t1779 * t2047) + (t2070 * t4116) - (t1781 * t2043) - (t2049 * t4110);
    const double t4122 = (motion->constants[31] * t1779) + (t2034 * t4099) + t4120;
    const double t4129 = (t7 * t4099) - (motion->constants[23] * t1779);
    const double t4131 = (t1706 * t1781) - (motion->constants[37] * t4129);
    const double t4133 = (t1182 * t1779) + t4131 - (t2101 * t4099);
    const double t4144 = (t1781 * t2128) + (t1779 * t2040) + (t2070 * t4110) + (t2049 * t4116);
    const double t4148 = (t1191 * t1779) + (t1781 * t2121) + (motion->constants[38] * t4110) +
        (motion->constants[23] * t4144);
    const double t4159 = t1839 + (t1779 * t2156) + (t1781 * t2159) + (motion->constants[39] *
        t4116) - (motion->constants[38] * t4129);
    const double t4165 = (t1779 * t2171) + (t1781 * t2175) - (motion->constants[39] * t4110);
    const double t4169 = (t1781 * t2151) + (cos_delta * t4165) - (motion->constants[24] * t4144) -
        (sin_delta * t4159);
    const double t4185 = (t1781 * t2203) + (t1779 * t2207) + (t2211 * t4099) +
        (motion->constants[24] * t4120) + (cos_delta * t4159) + (sin_delta * t4165);
    const double t4187 = t4185 - motion->constants[18] - (motion->constants[46] * t4129);
    const double t4193 = (t2195 * t4133) + (t16 * t4169) - (t2193 * t4122) - (t13 * t4148) -
        (sin_phi * t4187);
    const double t4202 = t4187 + (t1800 * t2244) + (t2246 * t4133) + (t515 * t4193) - (t2248 *
        t4122);
    const double t4208 = (t1800 * t2272) + (t2275 * t4202) - (t2270 * t4193);
    const double t4214 = (t1800 * t2296) + (t2295 * t4193) + (t2299 * t4202);
    const double t4220 = (t2322 * t4202) - (t1800 * t2319) - (t2317 * t4193);
    const double t4226 = (t2342 * t4214) - (t2337 * t4208) - (t2344 * t4220);
    const double t4245 = t4208 - t4131 - (t1144 * t1779);
    const double t4251 = (t2356 * t4099) + (t1781 * t2388) + (t1779 * t2396) + (t2402 * t4129) +
        (t2409 * t4110) + (t2414 * t4116);
    const double t4256 = t4251 + (t1306 * t4144) + (t2417 * t4120) + (t301 * t4148) + (t2436 *
        t4208) + (t2456 * t4214);
    const double t4261 = t4256 + (t2473 * t4220) + (t2476 * t4226) + (t2478 * t4245) - (t2419 *
        t4159) - (t2421 * t4165);
    const double t4281 = (t2576 * t4214) + (t2579 * t4220) - (t2571 * t4208);
    const double t4287 = (t2513 * t4099) + (t2405 * t4129) + (t1779 * t2538) + (t1548 * t4110) +
        (t1304 * t4144) + (t2548 * t4208);
    const double t4292 = t4287 + (t2555 * t4214) + (t2563 * t4220) + (t2565 * t4226) + (t2567 *
        t4245) + (t301 * t4281);
    const double t4296 = t4292 - (t1781 * t2530) - (t2541 * t4116) - (t2544 * t4120) - (t301 *
        t4169);
    const double t4307 = (t1781 * t2613) + (t2622 * t4214) - (t1779 * t2615) - (t2618 * t4208) -
        (t2625 * t4220);
    const double t4310 = (t1800 * t2604) + (speeds[2] * t4307) - t1948;
    const double t4314 = (t1800 * t2637) + (t824 * t4307);
    const double t4320 = t4144 + (t1781 * t2672);
    const double t4348 = (t1781 * t2743) + (t1779 * t2747) + (t2751 * t4129) + (t2755 * t4110) +
        (t2759 * t4116) + (t2761 * t4144);
    const double t4353 = t4348 + (t2419 * t4165) + (t2769 * t4208) + (t2777 * t4214) + (t2785 *
        t4220) + (t2787 * t4226);
    const double t4357 = t4353 - (t2721 * t4099) - (t2763 * t4120) - (t2421 * t4159) - (t2789 *
        t4245);
    const double t4365 = (t2658 * t4122) + (t2662 * t4133) + (t2668 * t4320) + (t2678 * t4148) +
        (t2690 * t4208) + (t2702 * t4214);
    const double t4370 = t4365 + (t2710 * t4220) + (t2681 * t4281) + (t16 * t4261) - (t2653 *
        t4187) - (t2681 * t4169);
    const double t4372 = t4370 - (sin_phi * t4357) - (t13 * t4296);
    const double t4377 = t2955 + (t1854 * t4193) + (speeds[2] * t4372) + (t841 * t4310);
    const double t4383 = (t1856 * t4193) + (speeds[1] * t4372) + (t840 * t4314);
    const double t4402 = (t2845 * t4122) + (t2852 * t4133) + (t2855 * t4320) + (t2857 * t4148) +
        (t1856 * t4187) + (t2851 * t4208);
    const double t4407 = t4402 + (t2868 * t4214) + (t2875 * t4220) + (t2860 * t4281) + (speeds[1] *
        t4357) + (t515 * t4383);
    const double t4409 = t4407 - (t2860 * t4169) - (t848 * t4314);
    const double t4415 = (t855 * t4314) + (t523 * t4383) + (t81 * t4409);
    const double t4422 = (t1800 * t2904) + (speeds[0] * t4307);
    const double t4426 = (t1800 * t2900) + (t865 * t4310) + (t539 * t4314) + (t868 * t4422);
    const double t4432 = (t1800 * t2914) + (t141 * t4314) + (t877 * t4422);
    const double t4442 = (t1860 * t4193) + (speeds[0] * t4372) + (t841 * t4422);
    const double t4447 = (t1800 * t2922) + (t2921 * t4193) + (t532 * t4377) + (t540 * t4383) +
        (t543 * t4442);
    const double t4455 = (t1800 * t2969) + (t2968 * t4193) + (t551 * t4383) + (t553 * t4442);
    const double t4477 = (t2984 * t4122) + (t2988 * t4133) + (t2990 * t4320) + (t2992 * t4148) +
        (t1860 * t4187) + (t2987 * t4208);
    const double t4482 = t4477 + (t2998 * t4214) + (t3000 * t4220) + (t2995 * t4281) + (speeds[0] *
        t4357) + (t515 * t4442);
    const double t4484 = t4482 - (t2995 * t4169) - (t896 * t4422);
    const double t4494 = (t892 * t4314) + (t557 * t4383) + (t104 * t4409) + (t53 * t4484) + (t575 *
        t4432) + (t563 * t4455);
    const double t4496 = t4494 - (t123 * t4426) - (t36 * t4447);
    const double t4511 = (t570 * t4383) + (t144 * t4409) + (t36 * t4426) + (t575 * t4455) - (t3032 *
        t4202) - (t913 * t4314);
    const double t4514 = t4511 - (t149 * t4484) - (t563 * t4432) - (t123 * t4447);
    const double t4527 = (t3059 * t4214) + (t3061 * t4220) - (t1800 * t3053) - (t3055 * t4208) -
        (t940 * t4307) - (t945 * t4310);
    const double t4528 = t4527 - (t951 * t4422);
    const double t4534 = (t1781 * t1998) + (t2007 * t4099) + (t1800 * t2029) + (t1906 * t4133) +
        (t1874 * t4148) + (t1860 * t4169);
    const double t4539 = t4534 + (t2026 * t4193) + (t2241 * t4202) + (t2294 * t4214) + (t2315 *
        t4220) + (t2335 * t4226);
    const double t4544 = t4539 + (speeds[0] * t4261) + (t822 * t4310) + (t836 * t4314) + (t468 *
        t4377) + (t508 * t4383);
    const double t4549 = t4544 + (t69 * t4409) + (motion->constants[24] * t4415) + (t864 * t4426) +
        (t550 * t4455) + (t120 * t4514);
    const double t4554 = t4549 + (t930 * t4528) - (t1902 * t4122) - (t2268 * t4208) - (t1275 *
        t4296) - (t875 * t4432);
    const double t4556 = t4554 - (t530 * t4447) - (t103 * t4496);
    const double t4591 = (t1982 * t4099) + (t1800 * t3118) + (t1906 * t4122) + (t1902 * t4133) +
        (t1860 * t4148) + (t3132 * t4202);
    const double t4596 = t4591 + (t3140 * t4208) + (t3146 * t4214) + (t3154 * t4220) + (t3162 *
        t4226) + (t1303 * t4281);
    const double t4601 = t4596 + (t1275 * t4261) + (speeds[0] * t4296) + (t969 * t4310) + (t977 *
        t4314) + (t590 * t4377);
    const double t4606 = t4601 + (t602 * t4383) + (t160 * t4409) + (t985 * t4426) + (t612 * t4455) +
        (t180 * t4496);
    const double t4611 = t4606 + (t190 * t4514) - (t1781 * t1973) - (t1874 * t4169) - (t3115 *
        t4193) - (motion->constants[23] * t4415);
    const double t4614 = t4611 - (t989 * t4432) - (t608 * t4447) - (t995 * t4528);
    const double t4637 = (t1781 * t3217) + (t1779 * t3220) + (t3225 * t4144) + (t1326 * t4208) +
        (t3235 * t4214) + (t3239 * t4220);
    const double t4642 = t4637 + (t3241 * t4245) + (t1027 * t4314) + (t80 * t4496) + (t12 * t4514) -
        (t3222 * t4129);
    const double t4646 = t4642 - (t3229 * t4120) - (t641 * t4383) - (t205 * t4409) - (t7 * t4415);
    const double t4650 = (t1781 * t3284) + (t1779 * t3288);
    const double t4654 = (t1779 * t3314) - (t1781 * t3310);
    const double t4658 = (t1779 * t3330) - (t1781 * t3326);
    const double t4668 = (t1781 * t3340) + (t1779 * t3344) + (t3298 * t4110) + (t3350 * t4116) -
        (t3347 * t4129);
    const double t4672 = (t3274 * t4650) + (t3274 * t4658) + (motion->constants[15] * t4668) -
        (t3297 * t4654);
    const double t4676 = (t1781 * t3368) + (t1779 * t3370);
    const double t4688 = (t1781 * t3383) + (t3387 * t4129) + (t3300 * t4110) - (t1779 * t3385) -
        (t3390 * t4116);
    const double t4692 = (t3362 * t4676) + (t3362 * t4650) + (motion->constants[15] * t4688) -
        (t3273 * t4654);
    const double t4694 = (motion->constants[2] * t4672) + (motion->constants[3] * t4692);
    const double t4708 = (t66 * t4496) - (t7 * t4514);
    const double t4713 = (t1781 * t3211) + (t1779 * t2004) + (t3407 * t4144) + (t3409 * t4120) +
        (t3415 * t4214) + (t3419 * t4220);
    const double t4718 = t4713 + (t1012 * t4314) + (t627 * t4383) + (t12 * t4415) - (t3422 *
        t4245) - (t196 * t4409);
    const double t4719 = t4718 - t4708;
    const double t4722 = (motion->constants[3] * t4646) + (motion->constants[2] * t4719) - t4694;
    const double t4727 = t1853 * ((t157 * t4614) + t4722 - (t58 * t4556) - (t1813 * t3447) -
        (t1822 * t4093));
    const double t4729 = (t1765 * t4093) - (t1822 * t4727);
    const double t4733 = (t1266 * t3447) - (t1747 * t4729) - (t1813 * t4727);
    const double t4735 = t3277 - t1365;
    const double t4737 = t1412 + t3321;
    const double t4740 = motion->constants[27] * motion->constants[20];
    const double t4741 = t4740 + t4740;
    const double t4743 = motion->constants[26] * motion->constants[20];
    const double t4753 = (t2302 * t4735) + (t2325 * t4737) + (t3292 * t4741) + (t3318 * t4743) +
        (t3334 * t4741) + (t3356 * motion->constants[20]);
    const double t4757 = t4753 + (t1011 * t2640) + (t626 * t2834) - t3430 - (t2278 * t3347);
    const double t4759 = t3321 - t1412;
    const double t4761 = t1311 + t3275;
    const double t4764 = t4743 + t4743;
    const double t4777 = (t2278 * t4759) + (t2302 * t4761) + (t3374 * t4764) + (t3292 * t4764) +
        (t3318 * t4740) + (t3397 * motion->constants[20]);
    const double t4782 = t4777 + (t1048 * t2640) + (t658 * t2834) + (t115 * t3030) + (t94 * t3049) -
        (t2325 * t3390);
    const double t4789 = t3445 + (t230 * t3209) - (motion->constants[2] * t4757) -
        (motion->constants[3] * t4782) - (t228 * t3101);
    const double t4804 = (t3570 * t4735) + (t3576 * t4737) + (t4014 * t4741) + (t4024 * t4741) +
        (t4034 * motion->constants[20]) + (t1011 * t3674);
    const double t4808 = t4804 + (t626 * t3744) - t4076 - (t3347 * t3564) - (t4019 * t4743);
    const double t4825 = (t3564 * t4759) + (t3570 * t4761) + (t4043 * t4764) + (t4014 * t4764) +
        (t4056 * motion->constants[20]) + (t1048 * t3674);
    const double t4830 = t4825 + (t658 * t3744) + (t115 * t3858) + (t94 * t3876) - (t3390 * t3576) -
        (t4019 * t4740);
    const double t4839 = t4090 + (t230 * t3978) - (motion->constants[2] * t4808) -
        (motion->constants[3] * t4830) - (t228 * t3920) - (t1747 * t4789);
    const double t4854 = (t4214 * t4735) + (t4220 * t4737) + (t4650 * t4741) + (t4658 * t4741) +
        (t4668 * motion->constants[20]) + (t1011 * t4314);
    const double t4858 = t4854 + (t626 * t4383) - t4708 - (t3347 * t4208) - (t4654 * t4743);
    const double t4875 = (t4208 * t4759) + (t4214 * t4761) + (t4676 * t4764) + (t4650 * t4764) +
        (t4688 * motion->constants[20]) + (t1048 * t4314);
    const double t4880 = t4875 + (t658 * t4383) + (t115 * t4496) + (t94 * t4514) - (t3390 * t4220) -
        (t4654 * t4740);
    const double t4890 = t4722 + (t230 * t4614) - (motion->constants[2] * t4858) -
        (motion->constants[3] * t4880) - (t228 * t4556) - (t1813 * t4789);
    const double t4892 = t1853 * (t4890 - (t1822 * t4839));
    const double t4894 = (t1765 * t4839) - (t1822 * t4892);
    const double t4898 = (t1266 * t4789) - (t1747 * t4894) - (t1813 * t4892);
    const double t4902 = motion->constants[3] * motion->constants[13];
    const double t4903 = (motion->constants[2] * motion->constants[12]) + t4902;
    const double t4906 = motion->constants[2] * motion->constants[13];
    const double t4909 = t4906 + (motion->constants[3] * motion->constants[14]);
    const double t4912 = (motion->constants[3] * (t4903 + t4903)) - (motion->constants[2] * (t4909 +
        t4909));
    const double t4915 = (motion->constants[3] * motion->constants[12]) - t4906;
    const double t4919 = t4902 - (motion->constants[2] * motion->constants[14]);
    const double t4922 = (motion->constants[3] * (t4915 - t4909)) - (motion->constants[2] * (t4903 +
        t4919));
    const double t4928 = (motion->constants[3] * (t4919 + t4919)) + (motion->constants[2] * (t4915 +
        t4915));
    const double t4935 = motion->constants[3] * motion->constants[7];
    const double t4936 = (motion->constants[2] * motion->constants[6]) + t4935;
    const double t4939 = motion->constants[2] * motion->constants[7];
    const double t4942 = t4939 + (motion->constants[3] * motion->constants[8]);
    const double t4945 = (motion->constants[3] * (t4936 + t4936)) - (motion->constants[2] * (t4942 +
        t4942));
    const double t4947 = t12 * t3406;
    const double t4949 = t7 * t3406;
    const double t4950 = (t12 * t1882) - t4949;
    const double t4952 = t1206 * t3241;
    const double t4955 = (t1214 * t4950) + t4952 - (t7 * t1882) - t4947;
    const double t4958 = t4935 - (motion->constants[2] * motion->constants[8]);
    const double t4962 = (motion->constants[3] * motion->constants[6]) - t4939;
    const double t4965 = (motion->constants[3] * (t4958 + t4958)) + (motion->constants[2] * (t4962 +
        t4962));
    const double t4966 = t7 * t3224;
    const double t4968 = t12 * t3224;
    const double t4970 = t4968 + (t7 * t1877);
    const double t4974 = t4966 - t4952 - (t12 * t1877) - (t1214 * t4970);
    const double t4980 = (motion->constants[3] * (t4962 - t4942)) - (motion->constants[2] * (t4936 +
        t4958));
    const double t4985 = (t12 * t3407) + (t7 * t3225);
    const double t4987 = t3228 - t3421;
    const double t4991 = (t12 * t3225) + (t1214 * t4985) + (t1206 * t4987) - (t7 * t3407);
    const double t4996 = motion->constants[4] + motion->constants[11];
    const double t4998 = (motion->constants[3] * motion->constants[10]) - (motion->constants[2] *
        t4996);
    const double t5000 = t74 * t3407;
    const double t5002 = t3409 * motion->constants[9];
    const double t5004 = t3422 * motion->constants[9];
    const double t5006 = t1864 * motion->constants[9];
    const double t5007 = t12 * t5006;
    const double t5008 = t7 * t5006;
    const double t5010 = t1908 * motion->constants[9];
    const double t5014 = (t12 * t5002) - (t7 * t5004);
    const double t5016 = motion->constants[31] + motion->constants[31];
    const double t5018 = t4949 + t4968;
    const double t5023 = t4947 + (t1214 * t5018) - t4966 - (t1206 * t1895);
    const double t5030 = (t2010 * t5014) + (t4974 * t5016) + (t5016 * t5023) +
        (motion->constants[30] * t4991) - (motion->constants[9] * t5000) - (t2031 * t5002);
    const double t5034 = t5030 - (t2098 * t5004) - t5007 - (t1214 * t5008) - (t1206 * t5010);
    const double t5038 = (motion->constants[2] * motion->constants[10]) + (motion->constants[3] *
        t4996);
    const double t5039 = t74 * t3225;
    const double t5041 = t3229 * motion->constants[9];
    const double t5043 = t3241 - t1895;
    const double t5044 = motion->constants[9] * t5043;
    const double t5047 = t1932 * motion->constants[9];
    const double t5051 = (t7 * t5044) - (t12 * t5041);
    const double t5053 = motion->constants[30] + motion->constants[30];
    const double t5061 = t5008 + (t2031 * t5041) + (t2098 * t5044) + (t2010 * t5051) + (t4955 *
        t5053) + (t5023 * t5053);
    const double t5065 = t5061 + (motion->constants[31] * t4991) - (motion->constants[9] * t5039) -
        (t1214 * t5007) - (t1206 * t5047);
    const double t5077 = (t3374 * t4912) + (t3296 * t3360) + (t4945 * t4955) + (t4998 * t5034) +
        (motion->constants[26] * t4757) + (t244 * t4782);
    const double t5082 = t5077 + (motion->constants[23] * t3442) + (t290 * t3209) - (t3318 *
        t4922) - (t3334 * t4928) - (t3272 * t3401);
    const double t5087 = t5082 - (t4965 * t4974) - (t4980 * t4991) - (t5038 * t5065) -
        (motion->constants[24] * t3264) - (t287 * t3101);
    const double t5095 = t1710 * t3241;
    const double t5096 = (t1712 * t4950) + t5095;
    const double t5099 = t5095 + (t1712 * t4970);
    const double t5103 = (t1712 * t4985) + (t1710 * t4987);
    const double t5111 = (t1712 * t5018) - (t1710 * t1895);
    const double t5118 = (t3452 * t5014) + (t5016 * t5111) + (motion->constants[30] * t5103) -
        (t1712 * t5008) - (t1710 * t5010) - (t5016 * t5099);
    const double t5130 = (t3452 * t5051) + (t5053 * t5096) + (t5053 * t5111) +
        (motion->constants[31] * t5103) - (t1712 * t5007) - (t1710 * t5047);
    const double t5143 = (t4043 * t4912) + (t4019 * t4922) + (t3296 * t4038) + (t4945 * t5096) +
        (t4965 * t5099) + (t4998 * t5118);
    const double t5148 = t5143 + (motion->constants[26] * t4808) + (t244 * t4830) +
        (motion->constants[23] * t4087) + (t290 * t3978) - (t4024 * t4928);
    const double t5153 = t5148 - (t3272 * t4060) - (t4980 * t5103) - (t5038 * t5130) -
        (motion->constants[24] * t4009) - (t287 * t3920);
    const double t5154 = t5153 - (t1747 * t5087);
    const double t5162 = t1779 * t3241;
    const double t5163 = (t1781 * t4950) - t5162;
    const double t5166 = t5162 - (t1781 * t4970);
    const double t5170 = (t1779 * t4987) - (t1781 * t4985);
    const double t5178 = (t1781 * t5018) + (t1779 * t1895);
    const double t5185 = (t1779 * t5010) + (t4099 * t5014) + (t5016 * t5166) + (t5016 * t5178) -
        (t1781 * t5008) - (motion->constants[30] * t5170);
    const double t5197 = (t1779 * t5047) + (t4099 * t5051) + (t5053 * t5163) + (t5053 * t5178) -
        (t1781 * t5007) - (motion->constants[31] * t5170);
    const double t5211 = (t4676 * t4912) + (t4654 * t4922) + (t3296 * t4672) + (t4945 * t5163) +
        (t4980 * t5170) + (t4998 * t5185);
    const double t5216 = t5211 + (motion->constants[26] * t4858) + (t244 * t4880) +
        (motion->constants[23] * t4719) + (t290 * t4614) - (t4658 * t4928);
    const double t5221 = t5216 - (t3272 * t4692) - (t4965 * t5166) - (t5038 * t5197) -
        (motion->constants[24] * t4646) - (t287 * t4556);
    const double t5224 = t1853 * (t5221 - (t1813 * t5087) - (t1822 * t5154));
    const double t5226 = (t1765 * t5154) - (t1822 * t5224);
    const double t5230 = (t1266 * t5087) - (t1747 * t5226) - (t1813 * t5224);
    const double t5235 = (t16 * t2096) + (sin_phi * t2676) - (t13 * t2113);
    const double t5243 = (t16 * t3476) + (t13 * t3487) - (sin_phi * t3680) - (t1747 * t5235);
    const double t5254 = t1853 * ((t16 * t4122) + (t13 * t4133) - (sin_phi * t4320) - (t1813 *
        t5235) - (t1822 * t5243));
    const double t5256 = (t1765 * t5243) - (t1822 * t5254);
    const double t5260 = (t1266 * t5235) - (t1747 * t5256) - (t1813 * t5254);
    const double t5267 = t1656 + t1966 + (motion->constants[30] * t1882) - (motion->constants[34] *
        t1864) - (motion->constants[31] * t1877);
    const double t5271 = (t1272 * t1339) - (speeds[0] * speeds[0]);
    const double t5273 = t12 * t1326;
    const double t5274 = (t7 * t5271) + t5273;
    const double t5275 = t12 * t1897;
    const double t5276 = t5274 - t5275;
    const double t5279 = t7 * t1326;
    const double t5280 = t5279 - (t12 * t5271);
    const double t5281 = t7 * t1897;
    const double t5282 = t5281 - t5280;
    const double t5284 = t1272 * t1275;
    const double t5285 = t5284 - t1861;
    const double t5287 = t5279 + t5280;
    const double t5291 = (cos_delta * t5284) + (sin_delta * t5274);
    const double t5294 = (cos_delta * t1296) - (sin_delta * t5273);
    const double t5295 = t5294 - t5291;
    const double t5299 = (cos_delta * t5274) - (sin_delta * t5284);
    const double t5302 = (sin_delta * t1296) + (cos_delta * t5273);
    const double t5303 = t5299 + t5302;
    const double t5313 = (motion->constants[3] * t5034) - (motion->constants[2] * t5065);
    const double t5322 = (t1081 * t2919) + (t687 * t2976) + (t64 * t3018) - (t563 * t2966) - (t575 *
        t2912);
    const double t5327 = (t1206 * t2937) + (t2096 * t5276) + (t2676 * t5285) + (t2278 * t5287) +
        (t2302 * t5295) + (t2325 * t5303);
    const double t5332 = t5327 + (t1074 * t2634) + (t475 * t2828) + (motion->constants[3] * t3442) +
        (t314 * t3209) + t5313;
    const double t5337 = t5332 + t5322 - t5267 - (t2113 * t5282) - (motion->constants[2] * t3264) -
        (t312 * t3101);
    const double t5355 = (motion->constants[3] * t5118) - (motion->constants[2] * t5130);
    const double t5364 = (t1081 * t3794) + (t687 * t3817) + (t64 * t3846) - (t563 * t3809) - (t575 *
        t3788);
    const double t5369 = (t1710 * t2937) + (t3476 * t5276) + (t3487 * t5282) + (t3564 * t5287) +
        (t3570 * t5295) + (t3576 * t5303);
    const double t5374 = t5369 + (t1074 * t3668) + (t475 * t3737) + (motion->constants[3] * t4087) +
        (t314 * t3978) + t5355;
    const double t5379 = t5374 + t5364 - (t3680 * t5285) - (motion->constants[2] * t4009) - (t312 *
        t3920) - (t1747 * t5337);
    const double t5398 = (motion->constants[3] * t5185) - (motion->constants[2] * t5197);
    const double t5407 = (t1081 * t4432) + (t687 * t4455) + (t64 * t4484) - (t563 * t4447) - (t575 *
        t4426);
    const double t5412 = t2937 + (t4122 * t5276) + (t4133 * t5282) + (t4208 * t5287) + (t4214 *
        t5295) + (t4220 * t5303);
    const double t5417 = t5412 + (t1074 * t4310) + (t475 * t4377) + (motion->constants[3] * t4719) +
        (t314 * t4614) + t5398;
    const double t5423 = t5417 + t5407 - (t1779 * t2937) - (t4320 * t5285) - (motion->constants[2] *
        t4646) - (t312 * t4556) - (t1813 * t5337);
    const double t5425 = t1853 * (t5423 - (t1822 * t5379));
    const double t5427 = (t1765 * t5379) - (t1822 * t5425);
    const double t5431 = (t1266 * t5337) - (t1747 * t5427) - (t1813 * t5425);
    const double t5432 = t74 * t1864;
    const double t5437 = (t12 * t1908) - (t7 * t1932);
    const double t5441 = t5432 + (t2010 * t5437) - (t1908 * t2031) - (t1932 * t2098);
    const double t5445 = (t3452 * t5437) - (t1747 * t5441);
    const double t5452 = t1853 * ((t4099 * t5437) - (t1813 * t5441) - (t1822 * t5445));
    const double t5454 = (t1765 * t5445) - (t1822 * t5452);
    const double t5458 = (t1266 * t5441) - (t1747 * t5454) - (t1813 * t5452);
    const double t5459 = t4955 + t4974;
    const double t5463 = t5096 - t5099 - (t1747 * t5459);
    const double t5470 = t1853 * (t5163 + t5166 - (t1813 * t5459) - (t1822 * t5463));
    const double t5472 = (t1765 * t5463) - (t1822 * t5470);
    const double t5476 = (t1266 * t5459) - (t1747 * t5472) - (t1813 * t5470);
    const double t5477 = t1277 * t1286;
    const double t5479 = t1281 * t1286;
    const double t5483 = (t12 * t5477) + (t7 * t5479);
    const double t5488 = (t12 * t5479) + (t1214 * t5483) - (t7 * t5477) - (t1206 * t1897);
    const double t5494 = (t1712 * t5483) - (t1710 * t1897) - (t1747 * t5488);
    const double t5504 = t1853 * ((t1781 * t5483) + (t1779 * t1897) - t1897 - (t1813 * t5488) -
        (t1822 * t5494));
    const double t5506 = (t1765 * t5494) - (t1822 * t5504);
    const double t5510 = (t1266 * t5488) - (t1747 * t5506) - (t1813 * t5504);
    const double t5513 = (motion->constants[2] * t5034) + (motion->constants[3] * t5065);
    const double t5519 = (motion->constants[2] * t5118) + (motion->constants[3] * t5130) - (t1747 *
        t5513);
    const double t5528 = t1853 * ((motion->constants[2] * t5185) + (motion->constants[3] * t5197) -
        (t1813 * t5513) - (t1822 * t5519));
    const double t5530 = (t1765 * t5519) - (t1822 * t5528);
    const double t5534 = (t1266 * t5513) - (t1747 * t5530) - (t1813 * t5528);
    const double t5537 = t5355 - (t1747 * t5313);
    const double t5543 = t1853 * (t5398 - (t1813 * t5313) - (t1822 * t5537));
    const double t5545 = (t1765 * t5537) - (t1822 * t5543);
    const double t5549 = (t1266 * t5313) - (t1747 * t5545) - (t1813 * t5543);
    const double t5555 = t1908 + (t3409 * t5038) - (t3229 * t4998);
    const double t5560 = (t4998 * t5043) - t1932 - (t3422 * t5038);
    const double t5562 = t1864 * t4998;
    const double t5564 = t1864 * t5038;
    const double t5568 = (t12 * t5562) + (t7 * t5564);
    const double t5572 = (t1908 * t5038) + (t1932 * t4998);
    const double t5576 = (t12 * t5555) + (t7 * t5560);
    const double t5578 = t4998 * t4998;
    const double t5580 = t5038 * t5038;
    const double t5582 = t5578 + t5580;
    const double t5584 = t4998 * t5038;
    const double t5590 = t5432 + (t2098 * t5560) + (t7 * t5562) + (t2010 * t5576) + (t4955 *
        t5578) + (t4974 * t5580);
    const double t5595 = t5590 + (t5023 * t5582) + (t4991 * t5584) - (t5000 * t5038) - (t4998 *
        t5039) - (t2031 * t5555);
    const double t5598 = t5595 - (t12 * t5564) - (t1214 * t5568) - (t1206 * t5572);
    const double t5612 = (t3452 * t5576) + (t5096 * t5578) + (t5111 * t5582) + (t5103 * t5584) -
        (t1712 * t5568) - (t1710 * t5572);
    const double t5614 = t5612 - (t5099 * t5580) - (t1747 * t5598);
    const double t5629 = (t1779 * t5572) + (t4099 * t5576) + (t5163 * t5578) + (t5166 * t5580) +
        (t5178 * t5582) - (t1781 * t5568);
    const double t5633 = t1853 * (t5629 - (t5170 * t5584) - (t1813 * t5598) - (t1822 * t5614));
    const double t5635 = (t1765 * t5614) - (t1822 * t5633);
    const double t5639 = (t1266 * t5598) - (t1747 * t5635) - (t1813 * t5633);
    const double t5640 = motion->constants[2] * motion->constants[2];
    const double t5642 = motion->constants[3] * motion->constants[3];
    const double t5644 = motion->constants[3] * motion->constants[2];
    const double t5645 = t4991 * t5644;
    const double t5647 = (t4955 * t5640) + (t4974 * t5642) - t5645;
    const double t5651 = t5103 * t5644;
    const double t5655 = (t5096 * t5640) - (t5099 * t5642) - t5651 - (t1747 * t5647);
    const double t5659 = t5170 * t5644;
    const double t5666 = t1853 * ((t5163 * t5640) + (t5166 * t5642) + t5659 - (t1813 * t5647) -
        (t1822 * t5655));
    const double t5668 = (t1765 * t5655) - (t1822 * t5666);
    const double t5672 = (t1266 * t5647) - (t1747 * t5668) - (t1813 * t5666);
    const double t5675 = t5111 - (t1747 * t5023);
    const double t5681 = t1853 * (t5178 - (t1813 * t5023) - (t1822 * t5675));
    const double t5683 = (t1765 * t5675) - (t1822 * t5681);
    const double t5687 = (t1266 * t5023) - (t1747 * t5683) - (t1813 * t5681);
    const double t5691 = t5645 + (t4955 * t5642) + (t4974 * t5640);
    const double t5698 = t5651 + (t5096 * t5642) - (t5099 * t5640) - (t1747 * t5691);
    const double t5708 = t1853 * ((t5163 * t5642) + (t5166 * t5640) - t5659 - (t1813 * t5691) -
        (t1822 * t5698));
    const double t5710 = (t1765 * t5698) - (t1822 * t5708);
    const double t5714 = (t1266 * t5691) - (t1747 * t5710) - (t1813 * t5708);
    const double t5715 = t5644 + t5644;
    const double t5718 = t5642 - t5640;
    const double t5721 = (t4955 * t5715) - (t4974 * t5715) - (t4991 * t5718);
    const double t5729 = (t5096 * t5715) + (t5099 * t5715) - (t5103 * t5718) - (t1747 * t5721);
    const double t5740 = t1853 * ((t5163 * t5715) + (t5170 * t5718) - (t5166 * t5715) - (t1813 *
        t5721) - (t1822 * t5729));
    const double t5742 = (t1765 * t5729) - (t1822 * t5740);
    const double t5746 = (t1266 * t5721) - (t1747 * t5742) - (t1813 * t5740);
    const double t5749 = t4062 - (t1747 * t3403);
    const double t5755 = t1853 * (t4694 - (t1813 * t3403) - (t1822 * t5749));
    const double t5757 = (t1765 * t5749) - (t1822 * t5755);
    const double t5761 = (t1266 * t3403) - (t1747 * t5757) - (t1813 * t5755);
    const double t5764 = (motion->constants[3] * t3360) - (motion->constants[2] * t3401);
    const double t5770 = (motion->constants[3] * t4038) - (motion->constants[2] * t4060) - (t1747 *
        t5764);
    const double t5779 = t1853 * ((motion->constants[3] * t4672) - (motion->constants[2] * t4692) -
        (t1813 * t5764) - (t1822 * t5770));
    const double t5781 = (t1765 * t5770) - (t1822 * t5779);
    const double t5785 = (t1266 * t5764) - (t1747 * t5781) - (t1813 * t5779);
    const double t5790 = (t1934 * t2106) + (t1912 * t2068) + (t1927 * t2087);
    const double t5791 = t3296 * t3296;
    const double t5793 = t3272 * t3272;
    const double t5794 = t5791 + t5793;
    const double t5796 = t3272 * t3296;
    const double t5805 = t5790 + (t3374 * t5791) + (t3292 * t5794) + (t3318 * t5796) + (t3334 *
        t5793) + (t3272 * t3356);
    const double t5806 = t5805 + (t3296 * t3397);
    const double t5812 = (t1934 * t3483) + (t1912 * t3463) + (t1927 * t3469);
    const double t5824 = t5812 + (t4043 * t5791) + (t4014 * t5794) + (t4024 * t5793) + (t3272 *
        t4034) + (t3296 * t4056);
    const double t5826 = t5824 - (t4019 * t5796) - (t1747 * t5806);
    const double t5832 = (t1934 * t4129) + (t1912 * t4110) + (t1927 * t4116);
    const double t5845 = t5832 + (t4676 * t5791) + (t4650 * t5794) + (t4658 * t5793) + (t3272 *
        t4668) + (t3296 * t4688);
    const double t5849 = t1853 * (t5845 - (t4654 * t5796) - (t1813 * t5806) - (t1822 * t5826));
    const double t5851 = (t1765 * t5826) - (t1822 * t5849);
    const double t5855 = (t1266 * t5806) - (t1747 * t5851) - (t1813 * t5849);
    const double t5857 = t3318 * t5644;
    const double t5860 = (t3374 * t5640) + (t3334 * t5642) - t5857;
    const double t5863 = t4019 * t5644;
    const double t5868 = (t4043 * t5640) + t5863 + (t4024 * t5642) - (t1747 * t5860);
    const double t5871 = t4654 * t5644;
    const double t5879 = t1853 * ((t4676 * t5640) + t5871 + (t4658 * t5642) - (t1813 * t5860) -
        (t1822 * t5868));
    const double t5881 = (t1765 * t5868) - (t1822 * t5879);
    const double t5885 = (t1266 * t5860) - (t1747 * t5881) - (t1813 * t5879);
    const double t5888 = t4014 - (t1747 * t3292);
    const double t5894 = t1853 * (t4650 - (t1813 * t3292) - (t1822 * t5888));
    const double t5896 = (t1765 * t5888) - (t1822 * t5894);
    const double t5900 = (t1266 * t3292) - (t1747 * t5896) - (t1813 * t5894);
    const double t5904 = t5857 + (t3374 * t5642) + (t3334 * t5640);
    const double t5911 = (t4043 * t5642) + (t4024 * t5640) - t5863 - (t1747 * t5904);
    const double t5921 = t1853 * ((t4676 * t5642) + (t4658 * t5640) - t5871 - (t1813 * t5904) -
        (t1822 * t5911));
    const double t5923 = (t1765 * t5911) - (t1822 * t5921);
    const double t5927 = (t1266 * t5904) - (t1747 * t5923) - (t1813 * t5921);
    const double t5932 = (t3374 * t5715) - (t3318 * t5718) - (t3334 * t5715);
    const double t5940 = (t4043 * t5715) + (t4019 * t5718) - (t4024 * t5715) - (t1747 * t5932);
    const double t5951 = t1853 * ((t4676 * t5715) + (t4654 * t5718) - (t4658 * t5715) - (t1813 *
        t5932) - (t1822 * t5940));
    const double t5953 = (t1765 * t5940) - (t1822 * t5951);
    const double t5957 = (t1266 * t5932) - (t1747 * t5953) - (t1813 * t5951);
    const double t5960 = (t1357 * t1421) - (t1385 * t1417);
    const double t5964 = (t1388 * t1417) + (t1348 * t1421);
    const double t5975 = (t1348 * t1385) + (t1357 * t1388);
    const double t5979 = (t323 * t3049) + (t2302 * t5975) - (t321 * t3030);
    const double t5984 = t3071 + (t2278 * t5960) + (t1097 * t2640) + (t698 * t2834) +
        (motion->constants[2] * t4782) + (t334 * t3209);
    const double t5988 = t5984 + t5979 - (t2325 * t5964) - (motion->constants[3] * t4757) - (t332 *
        t3101);
    const double t6003 = (t323 * t3876) + (t3570 * t5975) - (t321 * t3858);
    const double t6008 = t3892 + (t3564 * t5960) + (t1097 * t3674) + (t698 * t3744) +
        (motion->constants[2] * t4830) + (t334 * t3978);
    const double t6013 = t6008 + t6003 - (t3576 * t5964) - (motion->constants[3] * t4808) - (t332 *
        t3920) - (t1747 * t5988);
    const double t6029 = (t323 * t4514) + (t4214 * t5975) - (t321 * t4496);
    const double t6034 = t4528 + (t4208 * t5960) + (t1097 * t4314) + (t698 * t4383) +
        (motion->constants[2] * t4880) + (t334 * t4614);
    const double t6040 = t6034 + t6029 - (t4220 * t5964) - (motion->constants[3] * t4858) - (t332 *
        t4556) - (t1813 * t5988) - (t1822 * t6013);
    const double t6041 = t1853 * t6040;
    const double t6043 = (t1765 * t6013) - (t1822 * t6041);
    const double t6047 = (t1266 * t5988) - (t1747 * t6043) - (t1813 * t6041);
    const double t6048 = motion->constants[26] * motion->constants[26];
    const double t6050 = motion->constants[27] * motion->constants[27];
    const double t6051 = t6048 + t6050;
    const double t6053 = motion->constants[26] * motion->constants[27];
    const double t6062 = t5790 + (t3374 * t6048) + (t3292 * t6051) + (t3318 * t6053) + (t3334 *
        t6050) + (motion->constants[27] * t3356);
    const double t6063 = t6062 + (motion->constants[26] * t3397);
    const double t6076 = t5812 + (t4043 * t6048) + (t4014 * t6051) + (t4024 * t6050) +
        (motion->constants[27] * t4034) + (motion->constants[26] * t4056);
    const double t6078 = t6076 - (t4019 * t6053) - (t1747 * t6063);
    const double t6092 = t5832 + (t4676 * t6048) + (t4650 * t6051) + (t4658 * t6050) +
        (motion->constants[27] * t4668) + (motion->constants[26] * t4688);
    const double t6096 = t1853 * (t6092 - (t4654 * t6053) - (t1813 * t6063) - (t1822 * t6078));
    const double t6098 = (t1765 * t6078) - (t1822 * t6096);
    const double t6102 = (t1266 * t6063) - (t1747 * t6098) - (t1813 * t6096);
    const double t6103 = t3334 + t3374;
    const double t6107 = t4024 + t4043 - (t1747 * t6103);
    const double t6114 = t1853 * (t4658 + t4676 - (t1813 * t6103) - (t1822 * t6107));
    const double t6116 = (t1765 * t6107) - (t1822 * t6114);
    const double t6120 = (t1266 * t6103) - (t1747 * t6116) - (t1813 * t6114);
    const double t6121 = t1357 * t1417;
    const double t6123 = t1348 * t1417;
    const double t6124 = cos_delta * t6123;
    const double t6128 = (t12 * t6121) + (t7 * t6124);
    const double t6130 = sin_delta * t6123;
    const double t6136 = (t12 * t6124) + (t1214 * t6128) + (t1206 * t6130) - (t7 * t6121) - (t1253 *
        t1947);
    const double t6145 = (t1712 * t6128) + (t1710 * t6130) + (t1736 * t1947) - t6121 - (t1747 *
        t6136);
    const double t6156 = t1853 * ((t1781 * t6128) + (t1800 * t1947) - (t1779 * t6130) - (t1813 *
        t6136) - (t1822 * t6145));
    const double t6158 = (t1765 * t6145) - (t1822 * t6156);
    const double t6162 = (t1266 * t6136) - (t1747 * t6158) - (t1813 * t6156);
    const double t6168 = sin_phi * t2937;
    const double t6170 = t343 * t2937;
    const double t6172 = sin_phi * t1861;
    const double t6174 = sin_phi * t1899;
    const double t6179 = (t7 * t6172) + (t12 * t6174) + (t343 * t5275) - t5274;
    const double t6186 = t5280 + (t12 * t6172) - (t7 * t6174) - (t343 * t5281);
    const double t6189 = t5284 - (t343 * t1861);
    const double t6191 = sin_phi * t1296;
    const double t6193 = sin_phi * t1330;
    const double t6198 = (t7 * t6193) - t5280 - (t12 * t6191) - (t343 * t5279);
    const double t6202 = (t7 * t6191) + (t12 * t6193);
    const double t6206 = t5291 - (sin_delta * t6202) - (t343 * t5294);
    const double t6211 = (cos_delta * t6202) - t5299 - (t343 * t5302);
    const double t6219 = (sin_phi * ((t12 * t1982) - (t7 * t2007))) + (t343 * t5267) + (t1214 *
        t6168) + (t2096 * t6179);
    const double t6224 = t6219 + (t2278 * t6198) + (t2302 * t6206) + (t2325 * t6211) + (t346 *
        t3101) - t5322;
    const double t6229 = t6224 - (t1206 * t6170) - (t2113 * t6186) - (t2676 * t6189) - (t1114 *
        t2634) - (t712 * t2828);
    const double t6230 = t6229 - (t348 * t3209);
    const double t6249 = (t1712 * t6168) + (t3476 * t6179) + (t3487 * t6186) + (t3680 * t6189) +
        (t3564 * t6198) + (t3570 * t6206);
    const double t6254 = t6249 + (t3576 * t6211) + (t346 * t3920) - t5364 - (t1710 * t6170) -
        (t1114 * t3668);
    const double t6257 = t6254 - (t712 * t3737) - (t348 * t3978) - (t1747 * t6230);
    const double t6277 = (t1781 * t6168) + (t1779 * t6170) + (t4122 * t6179) + (t4133 * t6186) +
        (t4320 * t6189) + (t4208 * t6198);
    const double t6282 = t6277 + (t4214 * t6206) + (t4220 * t6211) + (t346 * t4556) - t5407 - t6170;
    const double t6287 = t6282 - (t1114 * t4310) - (t712 * t4377) - (t348 * t4614) - (t1813 *
        t6230) - (t1822 * t6257);
    const double t6288 = t1853 * t6287;
    const double t6290 = (t1765 * t6257) - (t1822 * t6288);
    const double t6294 = (t1266 * t6230) - (t1747 * t6290) - (t1813 * t6288);
    const double t6296 = (t39 * t1378) - t5960;
    const double t6299 = t5964 - (t39 * t1374);
    const double t6310 = (t2278 * t6296) + (t2325 * t6299) + (t1123 * t2640) + (t719 * t2834) +
        (t358 * t3209) - t5979;
    const double t6312 = t6310 - (t354 * t3071) - (t356 * t3101);
    const double t6326 = (t3564 * t6296) + (t3576 * t6299) + (t1123 * t3674) + (t719 * t3744) +
        (t358 * t3978) - t6003;
    const double t6329 = t6326 - (t354 * t3892) - (t356 * t3920) - (t1747 * t6312);
    const double t6344 = (t4208 * t6296) + (t4220 * t6299) + (t1123 * t4314) + (t719 * t4383) +
        (t358 * t4614) - t6029;
    const double t6349 = t1853 * (t6344 - (t354 * t4528) - (t356 * t4556) - (t1813 * t6312) -
        (t1822 * t6329));
    const double t6351 = (t1765 * t6329) - (t1822 * t6349);
    const double t6355 = (t1266 * t6312) - (t1747 * t6351) - (t1813 * t6349);
    by_parameters[0][0] = t216;
    by_parameters[0][1] = t235;
    by_parameters[0][2] = t296;
    by_parameters[0][3] = 0.0;
    by_parameters[0][4] = t320;
    by_parameters[0][5] = 0.0;
    by_parameters[0][6] = 0.0;
    by_parameters[0][7] = 0.0;
    by_parameters[0][8] = 0.0;
    by_parameters[0][9] = 0.0;
    by_parameters[0][10] = 0.0;
    by_parameters[0][11] = 0.0;
    by_parameters[0][12] = 0.0;
    by_parameters[0][13] = 0.0;
    by_parameters[0][14] = 0.0;
    by_parameters[0][15] = 0.0;
    by_parameters[0][16] = 0.0;
    by_parameters[0][17] = 0.0;
    by_parameters[0][18] = 0.0;
    by_parameters[0][19] = 0.0;
    by_parameters[0][20] = 0.0;
    by_parameters[0][21] = 0.0;
    by_parameters[0][22] = t339;
    by_parameters[0][23] = 0.0;
    by_parameters[0][24] = 0.0;
    by_parameters[0][25] = 0.0;
    by_parameters[0][26] = t353;
    by_parameters[0][27] = t361;
    by_parameters[1][0] = t406;
    by_parameters[1][1] = t417;
    by_parameters[1][2] = t428;
    by_parameters[1][3] = 0.0;
    by_parameters[1][4] = t439;
    by_parameters[1][5] = 0.0;
    by_parameters[1][6] = 0.0;
    by_parameters[1][7] = 0.0;
    by_parameters[1][8] = 0.0;
    by_parameters[1][9] = 0.0;
    by_parameters[1][10] = 0.0;
    by_parameters[1][11] = 0.0;
    by_parameters[1][12] = 0.0;
    by_parameters[1][13] = 0.0;
    by_parameters[1][14] = 0.0;
    by_parameters[1][15] = 0.0;
    by_parameters[1][16] = 0.0;
    by_parameters[1][17] = 0.0;
    by_parameters[1][18] = 0.0;
    by_parameters[1][19] = 0.0;
    by_parameters[1][20] = 0.0;
    by_parameters[1][21] = 0.0;
    by_parameters[1][22] = t450;
    by_parameters[1][23] = 0.0;
    by_parameters[1][24] = 0.0;
    by_parameters[1][25] = 0.0;
    by_parameters[1][26] = t458;
    by_parameters[1][27] = t462;
    by_parameters[2][0] = t654;
    by_parameters[2][1] = t670;
    by_parameters[2][2] = t681;
    by_parameters[2][3] = 0.0;
    by_parameters[2][4] = t697;
    by_parameters[2][5] = 0.0;
    by_parameters[2][6] = 0.0;
    by_parameters[2][7] = 0.0;
    by_parameters[2][8] = 0.0;
    by_parameters[2][9] = 0.0;
    by_parameters[2][10] = 0.0;
    by_parameters[2][11] = 0.0;
    by_parameters[2][12] = 0.0;
    by_parameters[2][13] = 0.0;
    by_parameters[2][14] = 0.0;
    by_parameters[2][15] = 0.0;
    by_parameters[2][16] = 0.0;
    by_parameters[2][17] = 0.0;
    by_parameters[2][18] = 0.0;
    by_parameters[2][19] = 0.0;
    by_parameters[2][20] = 0.0;
    by_parameters[2][21] = 0.0;
    by_parameters[2][22] = t711;
    by_parameters[2][23] = 0.0;
    by_parameters[2][24] = 0.0;
    by_parameters[2][25] = 0.0;
    by_parameters[2][26] = t718;
    by_parameters[2][27] = t725;
    by_parameters[3][0] = 0.0;
    by_parameters[3][1] = 0.0;
    by_parameters[3][2] = 0.0;
    by_parameters[3][3] = 0.0;
    by_parameters[3][4] = 0.0;
    by_parameters[3][5] = 0.0;
    by_parameters[3][6] = 0.0;
    by_parameters[3][7] = 0.0;
    by_parameters[3][8] = 0.0;
    by_parameters[3][9] = 0.0;
    by_parameters[3][10] = 0.0;
    by_parameters[3][11] = 0.0;
    by_parameters[3][12] = 0.0;
    by_parameters[3][13] = 0.0;
    by_parameters[3][14] = 0.0;
    by_parameters[3][15] = 0.0;
    by_parameters[3][16] = 0.0;
    by_parameters[3][17] = 0.0;
    by_parameters[3][18] = 0.0;
    by_parameters[3][19] = 0.0;
    by_parameters[3][20] = 0.0;
    by_parameters[3][21] = 0.0;
    by_parameters[3][22] = 0.0;
    by_parameters[3][23] = 0.0;
    by_parameters[3][24] = 0.0;
    by_parameters[3][25] = 0.0;
    by_parameters[3][26] = 0.0;
    by_parameters[3][27] = 0.0;
    by_parameters[4][0] = t767;
    by_parameters[4][1] = t778;
    by_parameters[4][2] = t789;
    by_parameters[4][3] = 0.0;
    by_parameters[4][4] = t798;
    by_parameters[4][5] = 0.0;
    by_parameters[4][6] = 0.0;
    by_parameters[4][7] = 0.0;
    by_parameters[4][8] = 0.0;
    by_parameters[4][9] = 0.0;
    by_parameters[4][10] = 0.0;
    by_parameters[4][11] = 0.0;
    by_parameters[4][12] = 0.0;
    by_parameters[4][13] = 0.0;
    by_parameters[4][14] = 0.0;
    by_parameters[4][15] = 0.0;
    by_parameters[4][16] = 0.0;
    by_parameters[4][17] = 0.0;
    by_parameters[4][18] = 0.0;
    by_parameters[4][19] = 0.0;
    by_parameters[4][20] = 0.0;
    by_parameters[4][21] = 0.0;
    by_parameters[4][22] = t809;
    by_parameters[4][23] = 0.0;
    by_parameters[4][24] = 0.0;
    by_parameters[4][25] = 0.0;
    by_parameters[4][26] = t813;
    by_parameters[4][27] = t817;
    by_parameters[5][0] = 0.0;
    by_parameters[5][1] = 0.0;
    by_parameters[5][2] = 0.0;
    by_parameters[5][3] = 0.0;
    by_parameters[5][4] = 0.0;
    by_parameters[5][5] = 0.0;
    by_parameters[5][6] = 0.0;
    by_parameters[5][7] = 0.0;
    by_parameters[5][8] = 0.0;
    by_parameters[5][9] = 0.0;
    by_parameters[5][10] = 0.0;
    by_parameters[5][11] = 0.0;
    by_parameters[5][12] = 0.0;
    by_parameters[5][13] = 0.0;
    by_parameters[5][14] = 0.0;
    by_parameters[5][15] = 0.0;
    by_parameters[5][16] = 0.0;
    by_parameters[5][17] = 0.0;
    by_parameters[5][18] = 0.0;
    by_parameters[5][19] = 0.0;
    by_parameters[5][20] = 0.0;
    by_parameters[5][21] = 0.0;
    by_parameters[5][22] = 0.0;
    by_parameters[5][23] = 0.0;
    by_parameters[5][24] = 0.0;
    by_parameters[5][25] = 0.0;
    by_parameters[5][26] = 0.0;
    by_parameters[5][27] = 0.0;
    by_parameters[6][0] = 0.0;
    by_parameters[6][1] = 0.0;
    by_parameters[6][2] = 0.0;
    by_parameters[6][3] = 0.0;
    by_parameters[6][4] = 0.0;
    by_parameters[6][5] = 0.0;
    by_parameters[6][6] = 0.0;
    by_parameters[6][7] = 0.0;
    by_parameters[6][8] = 0.0;
    by_parameters[6][9] = 0.0;
    by_parameters[6][10] = 0.0;
    by_parameters[6][11] = 0.0;
    by_parameters[6][12] = 0.0;
    by_parameters[6][13] = 0.0;
    by_parameters[6][14] = 0.0;
    by_parameters[6][15] = 0.0;
    by_parameters[6][16] = 0.0;
    by_parameters[6][17] = 0.0;
    by_parameters[6][18] = 0.0;
    by_parameters[6][19] = 0.0;
    by_parameters[6][20] = 0.0;
    by_parameters[6][21] = 0.0;
    by_parameters[6][22] = 0.0;
    by_parameters[6][23] = 0.0;
    by_parameters[6][24] = 0.0;
    by_parameters[6][25] = 0.0;
    by_parameters[6][26] = 0.0;
    by_parameters[6][27] = 0.0;
    by_parameters[7][0] = t1042;
    by_parameters[7][1] = t1062;
    by_parameters[7][2] = t1073;
    by_parameters[7][3] = 0.0;
    by_parameters[7][4] = t1096;
    by_parameters[7][5] = 0.0;
    by_parameters[7][6] = 0.0;
    by_parameters[7][7] = 0.0;
    by_parameters[7][8] = 0.0;
    by_parameters[7][9] = 0.0;
    by_parameters[7][10] = 0.0;
    by_parameters[7][11] = 0.0;
    by_parameters[7][12] = 0.0;
    by_parameters[7][13] = 0.0;
    by_parameters[7][14] = 0.0;
    by_parameters[7][15] = 0.0;
    by_parameters[7][16] = 0.0;
    by_parameters[7][17] = 0.0;
    by_parameters[7][18] = 0.0;
    by_parameters[7][19] = 0.0;
    by_parameters[7][20] = 0.0;
    by_parameters[7][21] = 0.0;
    by_parameters[7][22] = t1113;
    by_parameters[7][23] = 0.0;
    by_parameters[7][24] = 0.0;
    by_parameters[7][25] = 0.0;
    by_parameters[7][26] = t1122;
    by_parameters[7][27] = t1133;
    by_parameters[8][0] = t4733;
    by_parameters[8][1] = t4898;
    by_parameters[8][2] = t5230;
    by_parameters[8][3] = t5260;
    by_parameters[8][4] = t5431;
    by_parameters[8][5] = t5458;
    by_parameters[8][6] = t5476;
    by_parameters[8][7] = t5510;
    by_parameters[8][8] = t5534;
    by_parameters[8][9] = t5549;
    by_parameters[8][10] = t5639;
    by_parameters[8][11] = t5672;
    by_parameters[8][12] = t5687;
    by_parameters[8][13] = t5714;
    by_parameters[8][14] = t5746;
    by_parameters[8][15] = t5761;
    by_parameters[8][16] = t5785;
    by_parameters[8][17] = t5855;
    by_parameters[8][18] = t5885;
    by_parameters[8][19] = t5900;
    by_parameters[8][20] = t5927;
    by_parameters[8][21] = t5957;
    by_parameters[8][22] = t6047;
    by_parameters[8][23] = t6102;
    by_parameters[8][24] = t6120;
    by_parameters[8][25] = t6162;
    by_parameters[8][26] = t6294;
    by_parameters[8][27] = t6355;
    by_parameters[9][0] = t4729;
    by_parameters[9][1] = t4894;
    by_parameters[9][2] = t5226;
    by_parameters[9][3] = t5256;
    by_parameters[9][4] = t5427;
    by_parameters[9][5] = t5454;
    by_parameters[9][6] = t5472;
    by_parameters[9][7] = t5506;
    by_parameters[9][8] = t5530;
    by_parameters[9][9] = t5545;
    by_parameters[9][10] = t5635;
    by_parameters[9][11] = t5668;
    by_parameters[9][12] = t5683;
    by_parameters[9][13] = t5710;
    by_parameters[9][14] = t5742;
    by_parameters[9][15] = t5757;
    by_parameters[9][16] = t5781;
    by_parameters[9][17] = t5851;
    by_parameters[9][18] = t5881;
    by_parameters[9][19] = t5896;
    by_parameters[9][20] = t5923;
    by_parameters[9][21] = t5953;
    by_parameters[9][22] = t6043;
    by_parameters[9][23] = t6098;
    by_parameters[9][24] = t6116;
    by_parameters[9][25] = t6158;
    by_parameters[9][26] = t6290;
    by_parameters[9][27] = t6351;
    by_parameters[10][0] = t4727;
    by_parameters[10][1] = t4892;
    by_parameters[10][2] = t5224;
    by_parameters[10][3] = t5254;
    by_parameters[10][4] = t5425;
    by_parameters[10][5] = t5452;
    by_parameters[10][6] = t5470;
    by_parameters[10][7] = t5504;
    by_parameters[10][8] = t5528;
    by_parameters[10][9] = t5543;
    by_parameters[10][10] = t5633;
    by_parameters[10][11] = t5666;
    by_parameters[10][12] = t5681;
    by_parameters[10][13] = t5708;
    by_parameters[10][14] = t5740;
    by_parameters[10][15] = t5755;
    by_parameters[10][16] = t5779;
    by_parameters[10][17] = t5849;
    by_parameters[10][18] = t5879;
    by_parameters[10][19] = t5894;
    by_parameters[10][20] = t5921;
    by_parameters[10][21] = t5951;
    by_parameters[10][22] = t6041;
    by_parameters[10][23] = t6096;
    by_parameters[10][24] = t6114;
    by_parameters[10][25] = t6156;
    by_parameters[10][26] = t6288;
    by_parameters[10][27] = t6349;
}

carvallo_motion_error_t whipple_tyres_f64_motion_by_parameters(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES],
    double by_parameters[WHIPPLE_TYRES_STATES][WHIPPLE_TYRES_PARAMETERS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_TYRES_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_TYRES_FORCES)) {
        bool are_finite = true;
        whipple_tyres_f64_compute_by_parameters(motion, positions, speeds, forces, by_parameters);
        for (size_t row = 0U; row < WHIPPLE_TYRES_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f64(by_parameters[row],
                WHIPPLE_TYRES_PARAMETERS);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
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
    const float t2 = p->zH * p->mH;
    const float t7 = p->rR * p->mR;
    const float K_phi_phi_ = (p->zH * t2) + (p->IBxx + (p->rR * t7));
    const float t14 = p->zB * p->mB;
    const float t20 = p->rF * p->mF;
    const float t23 = p->IHxx + (p->IFxx + (p->rF * t20));
    const float M_11 = K_phi_phi_ + (p->IRxx + ((p->zB * t14) + t23));
    float wx_delta2_delta = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &wx_delta2_delta, &cos_lam);
    const float t31 = p->w + p->c;
    const float t36 = 1.0F / p->w;
    const float yaw_per_v_delta = cos_lam * t36;
    const float yaw_by_delta = p->c * yaw_per_v_delta;
    const float wz_delta2_delta = cos_lam + yaw_by_delta;
    const float t42 = (p->xH * wz_delta2_delta) - (p->zH * wx_delta2_delta) - (cos_lam * t31);
    const float t47 = (t14 * p->xB) - p->IBxz;
    const float t50 = wz_delta2_delta * p->IHxz;
    const float t52 = t50 + (t23 * wx_delta2_delta);
    const float M_12 = t52 - (yaw_by_delta * t47) - (t2 * t42);
    const float t57 = wz_delta2_delta * (p->IFxx + p->IHzz);
    const float t59 = p->mB * p->xB;
    const float t64 = yaw_by_delta * (p->IRxx + (p->xB * t59) + p->IBzz);
    const float t67 = p->mH * t42;
    const float M_22 = (wz_delta2_delta * t57) + (yaw_by_delta * t64) + (t42 * t67) +
        (wx_delta2_delta * (t50 + t52));
    const float ay_all1_delta = p->mH * p->xH;
    const float t77 = t7 - t2 - t14;
    const float h_spin_R = p->IRyy / p->rR;
    const float h_spin_F = p->IFyy / p->rF;
    const float h_wheels_all = h_spin_R + h_spin_F;
    const float t83 = t77 + h_wheels_all;
    const float vy_delta2_delta = t20 * t31;
    const float t88 = p->IHxz + vy_delta2_delta;
    const float t91 = cos_lam * h_spin_F;
    const float t97 = t67 + (yaw_by_delta * t59);
    const float C1_22 = yaw_per_v_delta * (t57 + (t64 + (wx_delta2_delta * t88) + (p->c * t97) +
        (p->xH * t67)));
    const float t107 = t36 * (ay_all1_delta + t59);
    const float t114 = ((p->mF + t107) * p->rhoF) - t20;
    const float K0_12 = (wx_delta2_delta * t114) - t97;
    const float K0_22 = wx_delta2_delta * K0_12;
    const float vy_all1_delta = t20 + t83;
    const float K2_12 = yaw_per_v_delta * vy_all1_delta;
    const float K2_22 = yaw_per_v_delta * (t97 + (wx_delta2_delta * (t20 + h_spin_F)));
    const float C1_12 = t91 - (yaw_per_v_delta * ((p->zH * ay_all1_delta) + (t47 - (p->c * t83)) -
        t88));
    const float C1_21 = -((yaw_by_delta * h_wheels_all) + t91);
    const float K0_11 = ((p->mB + (p->mH + p->mR) - t107) * p->rhoR) + t114 - t77;
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
    float wx_delta2_delta = 0.0F;
    float wx_delta2_delta_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const float t29 = p->rR * p->mR;
    const float t30 = p->rF * p->mF;
    const float C1_22_wz_delta2_delta = p->rF * t30;
    const float t33 = p->IFxx + p->IHxx + C1_22_wz_delta2_delta;
    const float M_11_mH = p->zH * p->zH;
    const float M_11_mB = p->zB * p->zB;
    const float M_11_rR = t29 + t29;
    const float M_11_mR = p->rR * p->rR;
    const float M_11 = (p->rR * t29) + p->IRxx + p->IBxx + t33 + (p->mH * M_11_mH) + (p->mB *
        M_11_mB);
    const float t46 = p->mB * p->zB;
    const float t48 = p->IBxz - (t46 * p->xB);
    const float K0_11_mR = p->rhoR - p->rR;
    const float M_11_zB = t46 + t46;
    const float M_11_rF = t30 + t30;
    const float K0_11_mF = p->rhoF - p->rF;
    const float t53 = 1.0F / p->w;
    const float t54 = p->mH * p->zH;
    const float t57 = t29 + t30 - t46 - t54;
    const float M_11_zH = t54 + t54;
    const float t59 = p->c + p->w;
    const float t60 = p->IFxx + p->IHzz;
    const float ay_all1_delta = p->mH * p->xH;
    const float t62 = p->c * t53;
    const float t63 = p->mB * p->xB;
    const float t64 = t48 + p->IHxz;
    const float t66 = t64 - (t54 * p->xH);
    const float t67 = 1.0F / p->rF;
    const float t68 = 1.0F / p->rR;
    const float t69 = t30 * t59;
    const float t71 = t53 * (ay_all1_delta + t63);
    const float h_spin_F = p->IFyy * t67;
    const float t73 = p->IRyy * t68;
    const float t74 = p->c + p->xH;
    const float t76 = t53 * (p->rhoF - p->rhoR);
    const float t77 = p->xB + p->c;
    const float t78 = t71 * t76;
    const float K0_11_xB = p->mB * t76;
    const float K0_11_mB = p->zB + p->rhoR + (p->xB * t76);
    const float K0_11_xH = p->mH * t76;
    const float K0_11_mH = p->zH + p->rhoR + (p->xH * t76);
    const float t87 = p->mF * wx_delta2_delta;
    const float yaw_per_v_delta = wx_delta2_delta_lam * t53;
    const float t89 = p->zH * wx_delta2_delta;
    const float t90 = p->IHxz * wx_delta2_delta;
    const float h_wheels_all = h_spin_F + t73;
    const float t92 = wx_delta2_delta_lam * h_spin_F;
    const float vy_all1_delta = h_wheels_all + t57;
    const float t94 = t53 * wx_delta2_delta;
    const float K0_11_rhoF = p->mF + t71;
    const float t96 = p->rhoF * K0_11_rhoF;
    const float K0_12_rhoF = wx_delta2_delta * K0_11_rhoF;
    const float t98 = yaw_per_v_delta * t54;
    const float K0_22_rhoF = wx_delta2_delta * K0_12_rhoF;
    const float t100 = p->rhoF * K0_12_rhoF;
    const float yaw_by_delta = p->c * yaw_per_v_delta;
    const float t103 = t89 + (wx_delta2_delta_lam * t59);
    const float t104 = vy_all1_delta * t94;
    const float t108 = yaw_per_v_delta * (p->IRxx + p->IBzz + (p->xB * t63));
    const float t109 = t46 * yaw_by_delta;
    const float C1_21 = -(t92 + (yaw_by_delta * h_wheels_all));
    const float wz_delta2_delta = wx_delta2_delta_lam + yaw_by_delta;
    const float t117 = (t30 * p->w) + t66 + (p->c * vy_all1_delta);
    const float K2_12 = yaw_per_v_delta * vy_all1_delta;
    const float t119 = t53 * K2_12;
    const float t120 = yaw_per_v_delta * t66;
    const float t121 = wz_delta2_delta * t54;
    const float t123 = t103 - (wz_delta2_delta * p->xH);
    const float t124 = p->xB * yaw_by_delta;
    const float t125 = p->zB * t124;
    const float M_22_mB = t124 * t124;
    const float t127 = p->mB * t124;
    const float t128 = p->mH - t71;
    const float K0_11_rhoR = p->mR + p->mB + t128;
    const float K0_12_c = wx_delta2_delta_lam * t128;
    const float K0_22_c = wx_delta2_delta * K0_12_c;
    const float t133 = yaw_per_v_delta * K0_12_c;
    const float t134 = yaw_per_v_delta * t117;
    const float t135 = t30 * wx_delta2_delta;
    const float K0_11 = t96 + (p->rhoR * K0_11_rhoR) - t57;
    const float t139 = t30 * wx_delta2_delta_lam;
    const float M_12_mH = p->zH * t123;
    const float M_22_mH = t123 * t123;
    const float M_12_rF = t135 + t135;
    const float C1_12 = t134 + t92;
    const float t145 = t53 * (t134 - t139);
    const float t150 = (p->IHxz * wz_delta2_delta) + (t33 * wx_delta2_delta) + (t54 * t123);
    const float t151 = wx_delta2_delta_lam * t54;
    const float M_12_w = t151 - (t62 * t120);
    const float M_12_c = t120 + t151;
    const float t158 = (wz_delta2_delta * t60) + t90 - (t123 * ay_all1_delta);
    const float t159 = yaw_per_v_delta * t60;
    const float t160 = p->mH * t123;
    const float M_12_zH = t160 + (p->mH * t89);
    const float t163 = yaw_per_v_delta * t123;
    const float t164 = t74 * t163;
    const float t165 = t160 - t127;
    const float t166 = t135 - t165;
    const float M_12 = (t48 * yaw_by_delta) + t150;
    const float K0_12 = t100 - t166;
    const float t170 = t166 - t100;
    const float t172 = t158 + (p->c * t108);
    const float t174 = t108 + t127 + t159;
    const float t175 = yaw_by_delta * t127;
    const float M_22_xB = t175 + t175;
    const float t177 = wx_delta2_delta * h_spin_F;
    const float t179 = t177 + (t117 * t94);
    const float t180 = t166 + t177;
    const float K2_22 = yaw_per_v_delta * t180;
    const float t182 = t53 * t180;
    const float K0_22 = -(wx_delta2_delta * t170);
    const float t185 = wx_delta2_delta_lam + wx_delta2_delta_lam;
    const float t186 = yaw_per_v_delta * h_wheels_all;
    const float C1_21_w = t62 * t186;
    const float t191 = t158 + (t59 * t160) + (t62 * t172);
    const float t192 = t53 * t172;
    const float t193 = p->mH * wx_delta2_delta_lam;
    const float t197 = yaw_per_v_delta * (t193 + t182 + (yaw_by_delta * t71));
    const float t200 = t185 * ((t62 * t192) - t160);
    const float M_22_c = t185 * (t160 + t192);
    const float t206 = (t69 * t94) + t192 - (t62 * t165);
    const float t207 = t74 * t193;
    const float t208 = t135 - t207;
    const float t209 = t53 * t207;
    const float t210 = t53 * t193;
    const float K2_22_xH = wz_delta2_delta * t210;
    const float t212 = wx_delta2_delta * t210;
    const float t213 = wx_delta2_delta * t209;
    const float t214 = p->xH * t209;
    const float C1_22_c = yaw_per_v_delta * (t208 + t174 + t214 - t165);
    const float M_22 = (wx_delta2_delta_lam * t191) + (wx_delta2_delta * t150);
    const float t223 = yaw_by_delta - (t94 * p->rhoF);
    const float K0_12_w = t193 + (t71 * t223);
    const float t226 = p->c * t94;
    const float C1_21_lam = t177 + (h_wheels_all * t226);
    const float C1_22 = wx_delta2_delta_lam * t206;
    const float t231 = t206 + (t62 * t174);
    const float K2_22_h_spin_F = wx_delta2_delta_lam * t94;
    const float K2_22_mF = p->rF * K2_22_h_spin_F;
    const float K2_22_IFyy = t67 * K2_22_h_spin_F;
    const float K0_12_zH = p->mH * wx_delta2_delta;
    const float t240 = t151 + (ay_all1_delta * (wx_delta2_delta + t226)) - (t59 * K0_12_zH);
    const float K0_22_w = wx_delta2_delta * K0_12_w;
    const float t242 = wx_delta2_delta + wx_delta2_delta;
    const float M_22_lam = (t150 * t185) - (t191 * t242);
    const float M_22_rF = t135 * t242;
    const float C1_22_w = yaw_per_v_delta * (t208 - t231 - (t62 * t214));
    const float M_22_zH = t160 * t242;
    const float t253 = p->mR - (t68 * t73);
    const float C1_12_rR = yaw_by_delta * t253;
    const float K2_12_rR = yaw_per_v_delta * t253;
    const float K2_12_IRyy = yaw_per_v_delta * t68;
    const float C1_12_IRyy = p->c * K2_12_IRyy;
    const float C1_21_rR = t73 * C1_12_IRyy;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float C1_12_mR = p->c * K2_12_mR;
    const float C1_22_IRxx = yaw_per_v_delta * yaw_by_delta;
    const float M_22_IRxx = p->c * C1_22_IRxx;
    const float M_12_lam = (t33 * wx_delta2_delta_lam) + (p->zH * t240) - t90 - (t64 * t226);
    const float M_22_yaw_by_delta = (wx_delta2_delta_lam * (p->IHxz + t69)) - (t74 * t240);
    const float C1_22_lam = (yaw_per_v_delta * M_22_yaw_by_delta) - (wx_delta2_delta * (t159 +
        t231));
    const float t279 = t240 + (t63 * t226) - t139;
    const float K2_22_mB = p->xB * C1_22_IRxx;
    const float C1_22_mB = t77 * K2_22_mB;
    const float t282 = p->mB * yaw_per_v_delta;
    const float t283 = p->zB * t282;
    const float K2_22_xB = yaw_by_delta * t282;
    const float C1_22_xB = (p->xB + t77) * K2_22_xB;
    const float t287 = t282 * t77;
    const float t288 = p->mB * t223;
    const float t289 = wx_delta2_delta * t288;
    const float t290 = p->zB * yaw_per_v_delta;
    const float t291 = t77 * t290;
    const float t292 = p->xB * t223;
    const float K2_22_lam = (yaw_per_v_delta * (t92 - t279)) - (wx_delta2_delta * t182);
    const float K0_12_lam = (wx_delta2_delta_lam * t96) + t279;
    const float t299 = wx_delta2_delta * t292;
    const float t300 = wx_delta2_delta_lam + t223;
    const float t301 = K0_12_zH * t300;
    const float t302 = p->mH * t300;
    const float K0_12_mH = t103 - (p->xH * t300);
    const float t305 = wz_delta2_delta + wz_delta2_delta;
    const float t306 = t160 * t305;
    const float M_22_IHxz = wx_delta2_delta * t305;
    const float K0_22_mH = wx_delta2_delta * K0_12_mH;
    const float C1_22_IHzz = yaw_per_v_delta * wz_delta2_delta;
    const float C1_22_yaw_by_delta = t74 * C1_22_IHzz;
    const float C1_22_xH = p->mH * (C1_22_yaw_by_delta - t163);
    const float K2_22_yaw_by_delta = wx_delta2_delta * K0_12_lam;
    const float K0_22_lam = K2_22_yaw_by_delta - (wx_delta2_delta_lam * t170);
    const float M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const float K0_22_zH = p->mH * M_22_IHxx;
    const float t318 = p->mF * M_22_IHxx;
    const float t319 = p->zH * yaw_per_v_delta;
    const float t320 = t74 * t319;
    const float M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float C1_12_IFyy = wz_delta2_delta * t67;
    const float C1_21_rF = h_spin_F * C1_12_IFyy;
    const float K2_12_IFyy = yaw_per_v_delta * t67;
    const float t326 = p->mF * yaw_per_v_delta;
    const float K2_12_rF = t326 - (h_spin_F * K2_12_IFyy);
    const float t329 = t59 * t326;
    const float C1_12_rF = t329 - C1_21_rF;
    const float C1_22_rF = wx_delta2_delta * t329;
    const float M_11_mF = p->rF * p->rF;
    const float M_22_mF = M_22_IHxx * M_11_mF;
    const float M_12_mF = wx_delta2_delta * M_11_mF;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float C1_12_mF = t59 * K2_12_mF;
    const float C1_22_mF = wx_delta2_delta * C1_12_mF;
    const float t339 = wx_delta2_delta * (p->rF - p->rhoF);
    const float t340 = wx_delta2_delta * t339;
    const float t342 = -(wx_delta2_delta * K2_12_rF);
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
    derivatives->values[0] = p->mR;
    derivatives->values[1] = p->mB;
    derivatives->values[2] = p->mH;
    derivatives->values[3] = p->mF;
    derivatives->values[4] = 1.0F;
    derivatives->values[5] = wx_delta2_delta;
    derivatives->values[6] = M_11_mH;
    derivatives->values[7] = M_11_mB;
    derivatives->values[8] = M_11_rR;
    derivatives->values[9] = M_11_mR;
    derivatives->values[10] = K0_11_mR;
    derivatives->values[11] = M_11_zB;
    derivatives->values[12] = M_11_rF;
    derivatives->values[13] = K0_11_mF;
    derivatives->values[14] = M_11_zH;
    derivatives->values[15] = t78;
    derivatives->values[16] = K0_11_xB;
    derivatives->values[17] = K0_11_mB;
    derivatives->values[18] = K0_11_xH;
    derivatives->values[19] = K0_11_mH;
    derivatives->values[20] = t87;
    derivatives->values[21] = yaw_per_v_delta;
    derivatives->values[22] = K0_11_rhoF;
    derivatives->values[23] = K0_12_rhoF;
    derivatives->values[24] = t98;
    derivatives->values[25] = K0_22_rhoF;
    derivatives->values[26] = yaw_by_delta;
    derivatives->values[27] = t104;
    derivatives->values[28] = t109;
    derivatives->values[29] = wz_delta2_delta;
    derivatives->values[30] = K2_12;
    derivatives->values[31] = t119;
    derivatives->values[32] = t121;
    derivatives->values[33] = t125;
    derivatives->values[34] = M_22_mB;
    derivatives->values[35] = t127;
    derivatives->values[36] = K0_11_rhoR;
    derivatives->values[37] = K0_12_c;
    derivatives->values[38] = K0_22_c;
    derivatives->values[39] = t133;
    derivatives->values[40] = M_12_mH;
    derivatives->values[41] = M_22_mH;
    derivatives->values[42] = M_12_rF;
    derivatives->values[43] = t145;
    derivatives->values[44] = M_12_w;
    derivatives->values[45] = M_12_c;
    derivatives->values[46] = M_12_zH;
    derivatives->values[47] = t163;
    derivatives->values[48] = t164;
    derivatives->values[49] = M_22_xB;
    derivatives->values[50] = t179;
    derivatives->values[51] = t186;
    derivatives->values[52] = C1_21_w;
    derivatives->values[53] = t197;
    derivatives->values[54] = t200;
    derivatives->values[55] = M_22_c;
    derivatives->values[56] = t209;
    derivatives->values[57] = t210;
    derivatives->values[58] = K2_22_xH;
    derivatives->values[59] = t212;
    derivatives->values[60] = t213;
    derivatives->values[61] = C1_22_c;
    derivatives->values[62] = K0_12_w;
    derivatives->values[63] = C1_21_lam;
    derivatives->values[64] = K2_22_h_spin_F;
    derivatives->values[65] = K2_22_mF;
    derivatives->values[66] = K2_22_IFyy;
    derivatives->values[67] = K0_12_zH;
    derivatives->values[68] = K0_22_w;
    derivatives->values[69] = M_22_lam;
    derivatives->values[70] = M_22_rF;
    derivatives->values[71] = C1_22_w;
    derivatives->values[72] = M_22_zH;
    derivatives->values[73] = C1_12_rR;
    derivatives->values[74] = K2_12_rR;
    derivatives->values[75] = K2_12_IRyy;
    derivatives->values[76] = C1_12_IRyy;
    derivatives->values[77] = C1_21_rR;
    derivatives->values[78] = K2_12_mR;
    derivatives->values[79] = C1_12_mR;
    derivatives->values[80] = C1_22_IRxx;
    derivatives->values[81] = M_22_IRxx;
    derivatives->values[82] = M_12_lam;
    derivatives->values[83] = C1_22_lam;
    derivatives->values[84] = K2_22_mB;
    derivatives->values[85] = C1_22_mB;
    derivatives->values[86] = t282;
    derivatives->values[87] = t283;
    derivatives->values[88] = K2_22_xB;
    derivatives->values[89] = C1_22_xB;
    derivatives->values[90] = t287;
    derivatives->values[91] = t288;
    derivatives->values[92] = t289;
    derivatives->values[93] = t290;
    derivatives->values[94] = t291;
    derivatives->values[95] = t292;
    derivatives->values[96] = K2_22_lam;
    derivatives->values[97] = K0_12_lam;
    derivatives->values[98] = t299;
    derivatives->values[99] = t301;
    derivatives->values[100] = t302;
    derivatives->values[101] = K0_12_mH;
    derivatives->values[102] = t306;
    derivatives->values[103] = M_22_IHxz;
    derivatives->values[104] = K0_22_mH;
    derivatives->values[105] = C1_22_IHzz;
    derivatives->values[106] = C1_22_xH;
    derivatives->values[107] = K0_22_lam;
    derivatives->values[108] = M_22_IHxx;
    derivatives->values[109] = K0_22_zH;
    derivatives->values[110] = t318;
    derivatives->values[111] = t319;
    derivatives->values[112] = t320;
    derivatives->values[113] = M_22_IHzz;
    derivatives->values[114] = M_22_IFxx;
    derivatives->values[115] = C1_12_IFyy;
    derivatives->values[116] = C1_21_rF;
    derivatives->values[117] = K2_12_IFyy;
    derivatives->values[118] = K2_12_rF;
    derivatives->values[119] = C1_12_rF;
    derivatives->values[120] = C1_22_rF;
    derivatives->values[121] = M_11_mF;
    derivatives->values[122] = M_22_mF;
    derivatives->values[123] = M_12_mF;
    derivatives->values[124] = K2_12_mF;
    derivatives->values[125] = C1_12_mF;
    derivatives->values[126] = C1_22_mF;
    derivatives->values[127] = t339;
    derivatives->values[128] = t340;
    derivatives->values[129] = t342;
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

void whipple_tyres_f32_motion(const whipple_tyres_f32_t *p, whipple_tyres_f32_motion_t *motion)
{
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t24 = p->w + p->c;
    const float t27 = (cos_lam * t24) - (sin_lam * p->rR);
    const float t30 = (sin_lam * t24) + (cos_lam * p->rR);
    const float t31 = p->rR - p->rhoR;
    const float t32 = p->w - t24;
    const float t35 = (cos_lam * t32) + (sin_lam * p->rF);
    const float t38 = (sin_lam * t32) - (cos_lam * p->rF);
    const float t39 = p->rF - p->rhoF;
    const float t40 = t30 + t38;
    const float t42 = p->rR + p->zB;
    const float t44 = (cos_lam * p->xB) - (sin_lam * t42);
    const float t45 = p->mB * t44;
    const float t48 = (sin_lam * p->xB) + (cos_lam * t42);
    const float t49 = p->mB * t48;
    const float t51 = cos_lam * p->IBxz;
    const float t52 = (sin_lam * p->IBxx) + t51;
    const float t54 = sin_lam * p->IBxz;
    const float t56 = t54 + (cos_lam * p->IBzz);
    const float t60 = (cos_lam * t52) - (sin_lam * t56) - (t45 * t48);
    const float t62 = t48 * t49;
    const float t63 = t44 * t45;
    const float t65 = p->IByy + t62 + t63;
    const float t67 = p->mB + p->mR;
    const float t77 = t62 + p->IRxx + (cos_lam * ((cos_lam * p->IBxx) - t54)) - (sin_lam * (t51 -
        (sin_lam * p->IBzz)));
    const float t82 = t63 + p->IRxx + (sin_lam * t52) + (cos_lam * t56);
    const float t83 = p->mH + p->mF;
    const float t84 = p->xH - t24;
    const float t87 = (cos_lam * t84) - (sin_lam * p->zH);
    const float t88 = p->mH * t87;
    const float t89 = p->mF * t35;
    const float t90 = t88 + t89;
    const float t93 = (sin_lam * t84) + (cos_lam * p->zH);
    const float t94 = p->mH * t93;
    const float t95 = p->mF * t38;
    const float t96 = t94 + t95;
    const float t99 = sin_lam * p->IHxz;
    const float t102 = cos_lam * p->IHxz;
    const float t108 = (t93 * t94) + (t38 * t95);
    const float t111 = p->IFxx + (cos_lam * ((cos_lam * p->IHxx) - t99)) + t108 - (sin_lam * (t102 -
        (sin_lam * p->IHzz)));
    const float t113 = t102 + (sin_lam * p->IHxx);
    const float t116 = t99 + (cos_lam * p->IHzz);
    const float t122 = (cos_lam * t113) - (sin_lam * t116) - (t88 * t93) - (t38 * t89);
    const float t126 = (t87 * t88) + (t35 * t89);
    const float t128 = t108 + p->IHyy + t126;
    const float t133 = p->IFxx + t126 + (sin_lam * t113) + (cos_lam * t116);
    const float t135 = t111 - t128;
    const float t136 = t27 * t83;
    const float t137 = t30 * t96;
    const float t138 = t30 * t83;
    const float t141 = t137 + t137 + (t30 * t138);
    const float t142 = t27 * t96;
    const float t143 = t30 * t136;
    const float t144 = t27 * t136;
    const float t145 = t67 + t83;
    const float t147 = t49 + t96 + t138;
    motion->constants[0] = p->w;
    motion->constants[1] = p->c;
    motion->constants[2] = sin_lam;
    motion->constants[3] = cos_lam;
    motion->constants[4] = p->rR;
    motion->constants[5] = p->rF;
    motion->constants[6] = p->IBxx;
    motion->constants[7] = p->IBxz;
    motion->constants[8] = p->IBzz;
    motion->constants[9] = p->mB;
    motion->constants[10] = p->xB;
    motion->constants[11] = p->zB;
    motion->constants[12] = p->IHxx;
    motion->constants[13] = p->IHxz;
    motion->constants[14] = p->IHzz;
    motion->constants[15] = p->mH;
    motion->constants[16] = p->xH;
    motion->constants[17] = p->zH;
    motion->constants[18] = p->IRyy;
    motion->constants[19] = p->IFyy;
    motion->constants[20] = p->mF;
    motion->constants[21] = p->rhoR;
    motion->constants[22] = p->rhoF;
    motion->constants[23] = t27;
    motion->constants[24] = t30;
    motion->constants[25] = t31;
    motion->constants[26] = t35;
    motion->constants[27] = t38;
    motion->constants[28] = t39;
    motion->constants[29] = t40;
    motion->constants[30] = t45;
    motion->constants[31] = t49;
    motion->constants[32] = t60;
    motion->constants[33] = t65;
    motion->constants[34] = t67;
    motion->constants[35] = t77;
    motion->constants[36] = t82;
    motion->constants[37] = t83;
    motion->constants[38] = t90;
    motion->constants[39] = t96;
    motion->constants[40] = t111;
    motion->constants[41] = t122;
    motion->constants[42] = t128;
    motion->constants[43] = t133;
    motion->constants[44] = p->g;
    motion->constants[45] = t135;
    motion->constants[46] = t136;
    motion->constants[47] = t141;
    motion->constants[48] = t142;
    motion->constants[49] = t143;
    motion->constants[50] = t144;
    motion->constants[51] = t145;
    motion->constants[52] = t147;
}

static void whipple_tyres_f32_compute_rates(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    float rates[WHIPPLE_TYRES_POSITIONS])
{
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t5 = motion->constants[25] + (motion->constants[21] * cos_phi);
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t17 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t20 = cos_phi * t17;
    const float t24 = (sin_phi * sin_delta) - (cos_delta * t20);
    const float t28 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const float t29 = cos_phi * t28;
    const float t32 = sqrtf((t24 * t24) + (t29 * t29));
    const float t33 = 1.0F / t32;
    const float t34 = t24 * t33;
    const float t36 = t29 * t33;
    const float t37 = cos_delta * t36;
    const float t39 = (t28 * t37) - (t17 * t34);
    const float t44 = ((sin_phi * cos_delta) + (t20 * sin_delta)) * motion->constants[28];
    const float t47 = sin_delta * motion->constants[26];
    const float t53 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const float t55 = (t28 * motion->constants[29]) - (t17 * t53);
    const float t58 = (cos_phi * t47) - (t39 * t44) - (sin_phi * t55);
    const float t59 = (motion->constants[25] * sin_phi) + t58;
    const float t66 = (cos_phi * sin_delta * t36) + (sin_phi * ((t28 * t34) + (t17 * t37)));
    const float t71 = (t44 * t66) + (t17 * motion->constants[29]) + (t28 * t53);
    const float t73 = 1.0F / (cos_phi * t71);
    const float t74 = t59 * t73;
    const float t80 = (t28 * motion->constants[24]) - (t17 * motion->constants[23]);
    const float t82 = t58 + (sin_phi * t80);
    const float t84 = sin_phi * t28;
    const float t88 = t71 - (t17 * motion->constants[24]) - (t28 * motion->constants[23]);
    const float t91 = t73 * ((t17 * t82) + (t84 * t88));
    const float t93 = (speeds[0] * t74) + (speeds[1] * t91);
    const float t95 = t5 * (speeds[2] + t93);
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t99 = motion->constants[21] * speeds[0];
    const float t105 = (cos_psi * t99) - (t95 * sin_psi);
    const float t106 = sin_phi * t71;
    const float t108 = sin_phi * t59;
    const float t110 = (t39 * t106) + (t66 * t108);
    const float t114 = 1.0F / ((t39 * t71) + (t59 * t66));
    const float t116 = t74 * t110 * t114;
    const float t127 = motion->constants[22] + (t32 * motion->constants[28]) + (sin_phi * t47) +
        (cos_phi * t55) - (cos_phi * t80);
    const float t129 = (t29 * t88) - (t17 * t127);
    const float t133 = (t84 * t127) + (t29 * t82);
    const float t138 = t114 * ((t39 * t129) + (t66 * t133) + (t91 * t110));
    const float t141 = t5 * t66 * t114;
    const float t147 = (t66 * t106) - (t39 * t108);
    const float t151 = (t66 * t71) - (t39 * t59);
    const float t156 = 1.0F / (motion->constants[28] + (t32 * motion->constants[22]));
    const float t173 = (speeds[0] * ((t116 * t151) - (t74 * t147)) * t156) + (speeds[1] * t156 *
        ((t39 * t133) + (t138 * t151) - (t66 * t129) - (t91 * t147)));
    const float t174 = t173 + (speeds[2] * t156 * ((t5 * t39) + (t141 * t151)));
    const float t175 = -((t95 * cos_psi) + (t99 * sin_psi));
    const float t176 = -((speeds[0] * t116) + (speeds[1] * t138) + (speeds[2] * t141));
    rates[0] = t175;
    rates[1] = t105;
    rates[2] = t176;
    rates[3] = speeds[0];
    rates[4] = t93;
    rates[5] = speeds[1];
    rates[6] = speeds[2];
    rates[7] = t174;
}

carvallo_motion_error_t whipple_tyres_f32_motion_rates(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    float rates[WHIPPLE_TYRES_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_TYRES_SPEEDS)) {
        whipple_tyres_f32_compute_rates(motion, positions, speeds, rates);
        error = (carvallo_are_finite_f32(rates, WHIPPLE_TYRES_POSITIONS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_tyres_f32_compute_derivatives(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES], float rates[WHIPPLE_TYRES_POSITIONS],
    float speed_rates[WHIPPLE_TYRES_SPEEDS])
{
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t5 = motion->constants[25] + (motion->constants[21] * cos_phi);
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t17 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t20 = cos_phi * t17;
    const float t24 = (sin_phi * sin_delta) - (cos_delta * t20);
    const float t28 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const float t29 = cos_phi * t28;
    const float t32 = sqrtf((t24 * t24) + (t29 * t29));
    const float t33 = 1.0F / t32;
    const float t34 = t24 * t33;
    const float t36 = t29 * t33;
    const float t37 = cos_delta * t36;
    const float t39 = (t28 * t37) - (t17 * t34);
    const float t42 = (sin_phi * cos_delta) + (t20 * sin_delta);
    const float t44 = t42 * motion->constants[28];
    const float t47 = sin_delta * motion->constants[26];
    const float t53 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const float t55 = (t28 * motion->constants[29]) - (t17 * t53);
    const float t58 = (cos_phi * t47) - (t39 * t44) - (sin_phi * t55);
    const float t59 = (motion->constants[25] * sin_phi) + t58;
    const float t66 = (cos_phi * sin_delta * t36) + (sin_phi * ((t28 * t34) + (t17 * t37)));
    const float t71 = (t44 * t66) + (t17 * motion->constants[29]) + (t28 * t53);
    const float t73 = 1.0F / (cos_phi * t71);
    const float t74 = t59 * t73;
    const float t80 = (t28 * motion->constants[24]) - (t17 * motion->constants[23]);
    const float t82 = t58 + (sin_phi * t80);
    const float t84 = sin_phi * t28;
    const float t88 = t71 - (t17 * motion->constants[24]) - (t28 * motion->constants[23]);
    const float t91 = t73 * ((t17 * t82) + (t84 * t88));
    const float t93 = (speeds[0] * t74) + (speeds[1] * t91);
    const float t94 = speeds[2] + t93;
    const float t95 = t5 * t94;
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t99 = motion->constants[21] * speeds[0];
    const float t105 = (cos_psi * t99) - (t95 * sin_psi);
    const float t106 = sin_phi * t71;
    const float t108 = sin_phi * t59;
    const float t110 = (t39 * t106) + (t66 * t108);
    const float t114 = 1.0F / ((t39 * t71) + (t59 * t66));
    const float t116 = t74 * t110 * t114;
    const float t127 = motion->constants[22] + (t32 * motion->constants[28]) + (sin_phi * t47) +
        (cos_phi * t55) - (cos_phi * t80);
    const float t129 = (t29 * t88) - (t17 * t127);
    const float t133 = (t84 * t127) + (t29 * t82);
    const float t138 = t114 * ((t39 * t129) + (t66 * t133) + (t91 * t110));
    const float t141 = t5 * t66 * t114;
    const float t144 = (speeds[0] * t116) + (speeds[1] * t138) + (speeds[2] * t141);
    const float t147 = (t66 * t106) - (t39 * t108);
    const float t151 = (t66 * t71) - (t39 * t59);
    const float t155 = motion->constants[28] + (t32 * motion->constants[22]);
    const float t156 = 1.0F / t155;
    const float t157 = ((t116 * t151) - (t74 * t147)) * t156;
    const float t166 = t156 * ((t39 * t133) + (t138 * t151) - (t66 * t129) - (t91 * t147));
    const float t171 = t156 * ((t5 * t39) + (t141 * t151));
    const float t174 = (speeds[0] * t157) + (speeds[1] * t166) + (speeds[2] * t171);
    const float t177 = cos_phi * t144;
    const float t178 = t94 * t177;
    const float t180 = sin_phi * t144;
    const float t181 = motion->constants[25] * t180;
    const float t183 = (t177 * t181) - (t5 * t178);
    const float t186 = t183 + (sin_phi * motion->constants[44]);
    const float t191 = (speeds[0] * t17) - (t28 * t177);
    const float t192 = t93 * t191;
    const float t193 = speeds[0] * t180;
    const float t194 = t93 - t180;
    const float t195 = motion->constants[24] * t194;
    const float t199 = (speeds[0] * t28) + (t17 * t177);
    const float t200 = motion->constants[23] * t194;
    const float t202 = (t191 * t195) + (t199 * t200);
    const float t204 = t93 * t199;
    const float t205 = (t28 * t193) + t204;
    const float t208 = t192 + (t17 * t193);
    const float t212 = t202 + (motion->constants[23] * t205) + (motion->constants[24] * t208) -
        t183;
    const float t217 = (motion->constants[23] * t191) - (motion->constants[24] * t199);
    const float t219 = (t194 * t200) + (t191 * t217);
    const float t220 = speeds[0] * t177;
    const float t223 = motion->constants[21] * sin_phi;
    const float t224 = speeds[0] * t94;
    const float t227 = motion->constants[25] * speeds[0];
    const float t228 = t177 * t227;
    const float t230 = (t5 * t220) + (t223 * (t193 + t224)) + t228;
    const float t237 = (t178 * t223) + (t181 * (t94 - t180)) - (speeds[0] * t227);
    const float t241 = (t28 * t230) + (t17 * t237) - t219 - (motion->constants[24] * t220);
    const float t243 = speeds[1] + t191;
    const float t247 = (cos_delta * t194) - (sin_delta * t199);
    const float t248 = motion->constants[27] * t247;
    const float t252 = (cos_delta * t199) + (sin_delta * t194);
    const float t253 = motion->constants[26] * t247;
    const float t258 = speeds[1] * t247;
    const float t260 = t258 - (cos_delta * t208) - (sin_delta * t220);
    const float t262 = t34 * t155;
    const float t264 = t205 + (t174 * t252);
    const float t266 = t36 * t155;
    const float t268 = t260 - (t174 * t243);
    const float t274 = t33 * ((t34 * t252) + (t36 * t243)) * t44;
    const float t275 = t36 * t274;
    const float t277 = t34 * t274;
    const float t283 = (cos_delta * t212) + (t243 * t248) + (t252 * t253) + (motion->constants[26] *
        t205) + (t262 * t264) + (t243 * t275);
    const float t287 = t283 + (t252 * t277) - (sin_delta * t241) - (motion->constants[27] * t260) -
        (t266 * t268);
    const float t294 = (motion->constants[26] * t243) - (motion->constants[27] * t252);
    const float t298 = speeds[1] * t252;
    const float t300 = (sin_delta * t208) - (cos_delta * t220) - t298;
    const float t303 = t42 * motion->constants[22];
    const float t305 = t174 + t247;
    const float t310 = motion->constants[28] * ((t34 * t243) - (t36 * t252));
    const float t316 = (cos_delta * t241) + (sin_delta * t212) + (motion->constants[27] * t300) +
        (t266 * t300) - (t247 * t253) - (t243 * t294);
    const float t319 = t316 - (t264 * t303) - (t277 * t305) - (t243 * t310);
    const float t323 = (t199 * t217) - (t194 * t195);
    const float t338 = t323 + (motion->constants[23] * t220) + (t17 * t230) + (t252 * t294) +
        (t268 * t303) + (t252 * t310);
    const float t343 = t338 - (t28 * t237) - (t247 * t248) - (motion->constants[26] * t300) -
        (t262 * t300) - (t275 * t305);
    const float t345 = (t34 * t319) + (t36 * t343);
    const float t350 = t73 * ((t42 * t287) + (t32 * t345));
    const float t354 = t114 * ((t32 * t287) + (t110 * t350) - (t42 * t345));
    const float t356 = t193 - (cos_phi * t354);
    const float t358 = t192 + (t17 * t356);
    const float t362 = t204 + (t28 * t356);
    const float t369 = (t194 * motion->constants[33]) + (motion->constants[18] * (speeds[2] +
        t194));
    const float t374 = (t199 * motion->constants[35]) + (motion->constants[32] * t191);
    const float t381 = t202 + (motion->constants[23] * t362) + (motion->constants[24] * t358) -
        t186;
    const float t385 = t350 - t220 - (sin_phi * t354);
    const float t391 = (t5 * t385) - t228 - (t223 * (t224 + t356));
    const float t394 = t237 + (cos_phi * motion->constants[44]);
    const float t396 = (t17 * t394) - (t28 * t391);
    const float t398 = (motion->constants[24] * t385) + t396 - t219;
    const float t400 = (cos_delta * t381) - (sin_delta * t398);
    const float t406 = t258 + (sin_delta * t385) - (cos_delta * t358);
    const float t414 = (t247 * motion->constants[42]) + (t305 * motion->constants[19]);
    const float t419 = (t252 * motion->constants[40]) + (t243 * motion->constants[41]);
    const float t424 = (motion->constants[38] * t400) + (motion->constants[41] * t406) + (t362 *
        motion->constants[43]) + (t252 * t414) - (t247 * t419);
    const float t428 = (cos_delta * t398) + (sin_delta * t381);
    const float t434 = (cos_delta * t385) + (sin_delta * t358) - t298;
    const float t436 = t247 * motion->constants[38];
    const float t440 = (t243 * motion->constants[38]) - (t252 * motion->constants[39]);
    const float t444 = (motion->constants[37] * t428) + (motion->constants[39] * t434) - (t247 *
        t436) - (t243 * t440);
    const float t449 = t247 * motion->constants[39];
    const float t455 = (t400 * motion->constants[37]) + (t362 * motion->constants[38]) + (t243 *
        t449) + (t252 * t436) - (t406 * motion->constants[39]);
    const float t457 = (sin_delta * t444) + (cos_delta * t455);
    const float t463 = (motion->constants[36] * t362) + (t199 * t369) + t424 +
        (motion->constants[23] * t457) - (motion->constants[30] * t186) - (motion->constants[32] *
        t358);
    const float t464 = t463 - (t194 * t374);
    const float t472 = (motion->constants[32] * t199) + (t191 * motion->constants[36]);
    const float t480 = (t252 * motion->constants[41]) + (t243 * motion->constants[43]);
    const float t486 = (t406 * motion->constants[40]) + (t362 * motion->constants[41]) + (t247 *
        t480) - (t400 * motion->constants[39]) - (t243 * t414);
    const float t492 = (t28 * t394) + (t17 * t391);
    const float t494 = t323 - (motion->constants[23] * t385) - t492;
    const float t505 = t434 + (t156 * ((t34 * t343) + (t151 * t354) - (t36 * t319) - (t147 *
        t350)));
    const float t506 = motion->constants[19] * t505;
    const float t513 = (t428 * motion->constants[39]) + (motion->constants[42] * t434) + t506 +
        (t243 * t419) - (motion->constants[38] * t494) - (t252 * t480);
    const float t520 = (t186 * motion->constants[31]) + (motion->constants[32] * t362) + (t194 *
        t472) + (cos_delta * t486) - (t358 * motion->constants[35]) - (t191 * t369);
    const float t522 = t520 - (sin_delta * t513) - (motion->constants[24] * t457);
    const float t529 = (motion->constants[30] * t191) - (t199 * motion->constants[31]);
    const float t531 = t194 * motion->constants[31];
    const float t539 = (motion->constants[37] * t494) + (t252 * t440) - (motion->constants[38] *
        t434) - (t247 * t449);
    const float t543 = (t199 * t529) + t539 - (t492 * motion->constants[34]) -
        (motion->constants[30] * t385) - (t194 * t531);
    const float t547 = motion->constants[30] * t194;
    const float t552 = (cos_delta * t444) - (sin_delta * t455);
    const float t556 = (t396 * motion->constants[34]) + (t385 * motion->constants[31]) + t552 -
        (t194 * t547) - (t191 * t529);
    const float t569 = t457 + (motion->constants[30] * t362) + (t358 * motion->constants[31]) +
        (t191 * t531) + (t199 * t547) - (t186 * motion->constants[34]);
    const float t572 = t74 - (sin_phi * t116);
    const float t585 = (t17 * t543) + (t28 * t556);
    const float t587 = (motion->constants[18] * t385) - (t5 * t585);
    const float t592 = (t396 * motion->constants[31]) + (motion->constants[30] * t492) +
        (motion->constants[33] * t385) + (t191 * t374) + (sin_delta * t486) + (cos_delta * t513);
    const float t596 = t592 + (motion->constants[24] * t552) + t587 - (t199 * t472) -
        (motion->constants[23] * t539);
    const float t598 = cos_phi * t116;
    const float t603 = (t28 * t464) + (t223 * t585) - (t17 * t522);
    const float t608 = forces[0] + (t223 * ((t28 * t543) - (t17 * t556))) + (t598 * t603) - (t17 *
        t464);
    const float t612 = t608 - (t28 * t522) - (t5 * t569) - (t572 * t596) - (t157 * t506);
    const float t614 = sin_delta * motion->constants[45];
    const float t615 = sin_delta * t614;
    const float t619 = motion->constants[35] + motion->constants[40] + motion->constants[47] - t615;
    const float t620 = cos_delta * motion->constants[38];
    const float t621 = motion->constants[23] * t620;
    const float t624 = t621 + t621 + motion->constants[50];
    const float t626 = motion->constants[36] + motion->constants[43] + t624;
    const float t627 = t626 - t619;
    const float t628 = t17 * t17;
    const float t630 = t17 * t28;
    const float t635 = (cos_delta * motion->constants[41]) - (motion->constants[24] * t620);
    const float t638 = motion->constants[32] + t635 - motion->constants[48] - motion->constants[49];
    const float t639 = t638 + t638;
    const float t641 = (t627 * t628) + (t630 * t639);
    const float t642 = sin_delta * motion->constants[38];
    const float t643 = t223 * t642;
    const float t645 = t223 * motion->constants[51];
    const float t648 = (t223 * t645) - t643 - t643;
    const float t653 = motion->constants[30] + t620 + motion->constants[46];
    const float t655 = (t28 * motion->constants[52]) - (t17 * t653);
    const float t656 = t5 * t655;
    const float t657 = t5 * motion->constants[51];
    const float t658 = t5 * t657;
    const float t660 = t658 - t656 - t656;
    const float t663 = (sin_delta * motion->constants[41]) - (motion->constants[24] * t642);
    const float t667 = (cos_delta * t614) - (motion->constants[23] * t642);
    const float t671 = (t17 * motion->constants[52]) + (t28 * t653);
    const float t674 = (t17 * t663) + (t28 * t667) + (t223 * t671);
    const float t681 = t638 + (t627 * t630) + (t5 * t671) - (t628 * t639);
    const float t687 = motion->constants[33] + motion->constants[42] + t615 +
        motion->constants[47] + t624 + t660;
    const float t697 = (t28 * t663) + (t223 * t655) + (t5 * t642) - (t17 * t667) - (t5 * t645);
    const float t704 = t626 + t648 - t641;
    const float t709 = motion->constants[18] * t572;
    const float t713 = t17 * sin_delta;
    const float t717 = t157 + (cos_delta * t572) - (sin_delta * t28) - (t598 * t713);
    const float t718 = motion->constants[19] * t717;
    const float t725 = t619 + t641 + t648 + t660 + (t572 * t674) + (t572 * (t674 + (t572 * t687) -
        (t598 * t697))) + (t572 * t709);
    const float t728 = t725 + (t717 * t718) - (t598 * t681) - (t598 * (t681 + (t572 * t697) -
        (t598 * t704)));
    const float t729 = 1.0F / t728;
    const float t731 = motion->constants[43] + t621;
    const float t737 = t91 - (sin_phi * t138);
    const float t739 = cos_phi * t138;
    const float t741 = t28 * t642;
    const float t742 = t5 * t741;
    const float t743 = t663 + t742;
    const float t747 = t743 + (t687 * t737) - (t697 * t739);
    const float t753 = (t28 * t731) - (t17 * t635) - (t223 * t741);
    const float t757 = t753 + (t697 * t737) - (t704 * t739);
    const float t763 = t166 + (cos_delta * t737) - (t713 * t739);
    const float t769 = (t17 * t731) + (t28 * t635) + (t5 * t620) + (t674 * t737) + (t572 * t747) +
        (t709 * t737);
    const float t774 = t729 * (t769 + (t718 * t763) - (t17 * t643) - (t681 * t739) - (t598 * t757));
    const float t779 = motion->constants[18] * t737;
    const float t781 = motion->constants[19] * t763;
    const float t783 = t728 * t774;
    const float t789 = motion->constants[43] + (t737 * t747) + (t737 * t743) + (t737 * t779) +
        (t763 * t781) - (t739 * t757);
    const float t791 = t789 - (t739 * t753) - (t774 * t783);
    const float t792 = 1.0F / t791;
    const float t802 = forces[1] + (t603 * t739) - t424 - (t596 * t737) - (t166 * t506) - (t612 *
        t774);
    const float t805 = t5 * (t655 - t657);
    const float t806 = sin_phi * t141;
    const float t808 = cos_phi * t141;
    const float t811 = t805 + (t687 * t806) + (t697 * t808);
    const float t814 = t5 * (t642 - t645);
    const float t818 = t814 - (t697 * t806) - (t704 * t808);
    const float t823 = 1.0F - t806;
    const float t828 = t171 - (cos_delta * t806) - (t713 * t808);
    const float t840 = (t709 * t823) + (t718 * t828) - (t674 * t806) - (t681 * t808) - (t572 *
        t811) - (t598 * t818);
    const float t841 = t729 * t840;
    const float t847 = t742 + (t779 * t823) + (t781 * t828) - (t737 * t811) - (t739 * t818) -
        (t743 * t806);
    const float t850 = t792 * (t847 - (t753 * t808) - (t783 * t841));
    const float t860 = (t596 * t806) + (t603 * t808) - t587 - (t171 * t506) - (t612 * t841) -
        (t802 * t850);
    const float t877 = t658 + (t806 * t811) + (t805 * t806) + (motion->constants[18] * t823 *
        t823) + (motion->constants[19] * t828 * t828) - (t808 * t818);
    const float t881 = t860 / (t877 - (t808 * t814) - (t728 * t841 * t841) - (t791 * t850 * t850));
    const float t883 = (t792 * t802) - (t850 * t881);
    const float t887 = (t612 * t729) - (t774 * t883) - (t841 * t881);
    const float t888 = -((t95 * cos_psi) + (t99 * sin_psi));
    const float t889 = -t144;
    rates[0] = t888;
    rates[1] = t105;
    rates[2] = t889;
    rates[3] = speeds[0];
    rates[4] = t93;
    rates[5] = speeds[1];
    rates[6] = speeds[2];
    rates[7] = t174;
    speed_rates[0] = t887;
    speed_rates[1] = t883;
    speed_rates[2] = t881;
}

carvallo_motion_error_t whipple_tyres_f32_motion_derivatives(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES], float rates[WHIPPLE_TYRES_POSITIONS],
    float speed_rates[WHIPPLE_TYRES_SPEEDS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_TYRES_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_TYRES_FORCES)) {
        whipple_tyres_f32_compute_derivatives(motion, positions, speeds, forces, rates,
            speed_rates);
        error = (carvallo_are_finite_f32(rates, WHIPPLE_TYRES_POSITIONS) &&
            carvallo_are_finite_f32(speed_rates, WHIPPLE_TYRES_SPEEDS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_tyres_f32_compute_accelerations(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES], float accelerations[WHIPPLE_TYRES_POSITIONS])
{
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t15 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t19 = t15 * cos_phi;
    const float t23 = (sin_phi * sin_delta) - (cos_delta * t19);
    const float t27 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const float t28 = cos_phi * t27;
    const float t31 = sqrtf((t23 * t23) + (t28 * t28));
    const float t32 = 1.0F / t31;
    const float t33 = t23 * t32;
    const float t35 = t28 * t32;
    const float t36 = cos_delta * t35;
    const float t38 = (t27 * t36) - (t15 * t33);
    const float t41 = (sin_phi * cos_delta) + (t19 * sin_delta);
    const float t43 = t41 * motion->constants[28];
    const float t46 = sin_delta * motion->constants[26];
    const float t52 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const float t54 = (t27 * motion->constants[29]) - (t15 * t52);
    const float t57 = (cos_phi * t46) - (t38 * t43) - (sin_phi * t54);
    const float t58 = (sin_phi * motion->constants[25]) + t57;
    const float t65 = (cos_phi * sin_delta * t35) + (sin_phi * ((t27 * t33) + (t15 * t36)));
    const float t70 = (t43 * t65) + (t15 * motion->constants[29]) + (t27 * t52);
    const float t72 = 1.0F / (cos_phi * t70);
    const float t73 = t58 * t72;
    const float t79 = (t27 * motion->constants[24]) - (t15 * motion->constants[23]);
    const float t81 = t57 + (sin_phi * t79);
    const float t83 = sin_phi * t27;
    const float t87 = t70 - (t15 * motion->constants[24]) - (t27 * motion->constants[23]);
    const float t90 = t72 * ((t15 * t81) + (t83 * t87));
    const float t92 = (speeds[0] * t73) + (speeds[1] * t90);
    const float t93 = speeds[2] + t92;
    const float t95 = speeds[0] * motion->constants[21];
    const float t99 = motion->constants[25] + (cos_phi * motion->constants[21]);
    const float t103 = 1.0F / ((t38 * t70) + (t58 * t65));
    const float t104 = sin_phi * t70;
    const float t106 = sin_phi * t58;
    const float t108 = (t38 * t104) + (t65 * t106);
    const float t110 = t73 * t103 * t108;
    const float t121 = motion->constants[22] + (t31 * motion->constants[28]) + (sin_phi * t46) +
        (cos_phi * t54) - (cos_phi * t79);
    const float t123 = (t28 * t87) - (t15 * t121);
    const float t127 = (t83 * t121) + (t28 * t81);
    const float t132 = t103 * ((t38 * t123) + (t65 * t127) + (t90 * t108));
    const float t135 = t65 * t99 * t103;
    const float t138 = (speeds[0] * t110) + (speeds[1] * t132) + (speeds[2] * t135);
    const float t139 = cos_phi * t138;
    const float t140 = speeds[0] * t139;
    const float t143 = (speeds[0] * t15) - (t27 * t139);
    const float t144 = sin_phi * t138;
    const float t145 = t92 - t144;
    const float t146 = motion->constants[24] * t145;
    const float t150 = (speeds[0] * t27) + (t15 * t139);
    const float t151 = motion->constants[23] * t145;
    const float t153 = (t143 * t146) + (t150 * t151);
    const float t154 = speeds[0] * t144;
    const float t156 = t92 * t150;
    const float t157 = (t27 * t154) + t156;
    const float t160 = t92 * t143;
    const float t161 = (t15 * t154) + t160;
    const float t163 = t93 * t139;
    const float t165 = motion->constants[25] * t144;
    const float t167 = (t139 * t165) - (t99 * t163);
    const float t170 = t153 + (motion->constants[23] * t157) + (motion->constants[24] * t161) -
        t167;
    const float t175 = (motion->constants[23] * t143) - (motion->constants[24] * t150);
    const float t177 = (t145 * t151) + (t143 * t175);
    const float t179 = speeds[0] * motion->constants[25];
    const float t180 = t139 * t179;
    const float t182 = sin_phi * motion->constants[21];
    const float t183 = speeds[0] * t93;
    const float t187 = t180 + (t99 * t140) + (t182 * (t154 + t183));
    const float t194 = (t163 * t182) + (t165 * (t93 - t144)) - (speeds[0] * t179);
    const float t198 = (t27 * t187) + (t15 * t194) - t177 - (motion->constants[24] * t140);
    const float t200 = speeds[1] + t143;
    const float t204 = (cos_delta * t145) - (sin_delta * t150);
    const float t205 = motion->constants[27] * t204;
    const float t209 = (cos_delta * t150) + (sin_delta * t145);
    const float t210 = motion->constants[26] * t204;
    const float t215 = speeds[1] * t204;
    const float t217 = t215 - (cos_delta * t161) - (sin_delta * t140);
    const float t220 = motion->constants[28] + (t31 * motion->constants[22]);
    const float t221 = t33 * t220;
    const float t224 = (t65 * t104) - (t38 * t106);
    const float t228 = (t65 * t70) - (t38 * t58);
    const float t231 = 1.0F / t220;
    const float t232 = ((t110 * t228) - (t73 * t224)) * t231;
    const float t241 = t231 * ((t38 * t127) + (t132 * t228) - (t65 * t123) - (t90 * t224));
    const float t246 = t231 * ((t38 * t99) + (t135 * t228));
    const float t249 = (speeds[0] * t232) + (speeds[1] * t241) + (speeds[2] * t246);
    const float t251 = t157 + (t209 * t249);
    const float t253 = t35 * t220;
    const float t255 = t217 - (t200 * t249);
    const float t261 = t32 * ((t33 * t209) + (t35 * t200)) * t43;
    const float t262 = t35 * t261;
    const float t264 = t33 * t261;
    const float t270 = (cos_delta * t170) + (t200 * t205) + (t209 * t210) + (motion->constants[26] *
        t157) + (t221 * t251) + (t200 * t262);
    const float t274 = t270 + (t209 * t264) - (sin_delta * t198) - (motion->constants[27] * t217) -
        (t253 * t255);
    const float t281 = (motion->constants[26] * t200) - (motion->constants[27] * t209);
    const float t285 = speeds[1] * t209;
    const float t287 = (sin_delta * t161) - (cos_delta * t140) - t285;
    const float t290 = t41 * motion->constants[22];
    const float t292 = t204 + t249;
    const float t297 = motion->constants[28] * ((t33 * t200) - (t35 * t209));
    const float t303 = (cos_delta * t198) + (sin_delta * t170) + (motion->constants[27] * t287) +
        (t253 * t287) - (t204 * t210) - (t200 * t281);
    const float t306 = t303 - (t251 * t290) - (t264 * t292) - (t200 * t297);
    const float t310 = (t150 * t175) - (t145 * t146);
    const float t325 = t310 + (motion->constants[23] * t140) + (t15 * t187) + (t209 * t281) +
        (t255 * t290) + (t209 * t297);
    const float t330 = t325 - (t27 * t194) - (t204 * t205) - (motion->constants[26] * t287) -
        (t221 * t287) - (t262 * t292);
    const float t332 = (t33 * t306) + (t35 * t330);
    const float t335 = t72 * ((t41 * t274) + (t31 * t332));
    const float t341 = t103 * ((t31 * t274) + (t108 * t335) - (t41 * t332));
    const float t344 = t335 - t140 - (sin_phi * t341);
    const float t349 = t194 + (cos_phi * motion->constants[44]);
    const float t353 = t154 - (cos_phi * t341);
    const float t357 = (t99 * t344) - t180 - (t182 * (t183 + t353));
    const float t359 = (t27 * t349) + (t15 * t357);
    const float t362 = t310 - t359 - (motion->constants[23] * t344);
    const float t368 = t160 + (t15 * t353);
    const float t371 = (cos_delta * t344) + (sin_delta * t368) - t285;
    const float t376 = (t200 * motion->constants[38]) - (t209 * motion->constants[39]);
    const float t378 = t204 * motion->constants[39];
    const float t382 = (t362 * motion->constants[37]) + (t209 * t376) - (motion->constants[38] *
        t371) - (t204 * t378);
    const float t390 = (t143 * motion->constants[30]) - (motion->constants[31] * t150);
    const float t392 = motion->constants[31] * t145;
    const float t397 = t382 + (t150 * t390) - (t359 * motion->constants[34]) - (t344 *
        motion->constants[30]) - (t145 * t392);
    const float t401 = (t15 * t349) - (t27 * t357);
    const float t404 = t401 + (motion->constants[24] * t344) - t177;
    const float t407 = t156 + (t27 * t353);
    const float t411 = t167 + (sin_phi * motion->constants[44]);
    const float t414 = t153 + (motion->constants[23] * t407) + (motion->constants[24] * t368) -
        t411;
    const float t416 = (cos_delta * t404) + (sin_delta * t414);
    const float t419 = t204 * motion->constants[38];
    const float t424 = (t416 * motion->constants[37]) + (motion->constants[39] * t371) - (t204 *
        t419) - (t200 * t376);
    const float t428 = (cos_delta * t414) - (sin_delta * t404);
    const float t434 = t215 + (sin_delta * t344) - (cos_delta * t368);
    const float t441 = (t428 * motion->constants[37]) + (t407 * motion->constants[38]) + (t200 *
        t378) + (t209 * t419) - (motion->constants[39] * t434);
    const float t443 = (cos_delta * t424) - (sin_delta * t441);
    const float t446 = t145 * motion->constants[30];
    const float t452 = t443 + (t401 * motion->constants[34]) + (motion->constants[31] * t344) -
        (t145 * t446) - (t143 * t390);
    const float t454 = (t15 * t397) + (t27 * t452);
    const float t456 = (t344 * motion->constants[18]) - (t99 * t454);
    const float t457 = sin_phi * t135;
    const float t466 = (t150 * motion->constants[35]) + (t143 * motion->constants[32]);
    const float t471 = (t150 * motion->constants[32]) + (t143 * motion->constants[36]);
    const float t481 = (t209 * motion->constants[41]) + (t200 * motion->constants[43]);
    const float t487 = (t204 * motion->constants[42]) + (t292 * motion->constants[19]);
    const float t492 = (motion->constants[40] * t434) + (t407 * motion->constants[41]) + (t204 *
        t481) - (motion->constants[39] * t428) - (t200 * t487);
    const float t504 = t231 * ((t33 * t330) + (t228 * t341) - (t35 * t306) - (t224 * t335));
    const float t506 = motion->constants[19] * (t371 + t504);
    const float t509 = (t209 * motion->constants[40]) + (t200 * motion->constants[41]);
    const float t516 = (motion->constants[39] * t416) + (motion->constants[42] * t371) + t506 +
        (t200 * t509) - (motion->constants[38] * t362) - (t209 * t481);
    const float t524 = (motion->constants[31] * t401) + (motion->constants[30] * t359) + (t344 *
        motion->constants[33]) + (t143 * t466) + (sin_delta * t492) + (cos_delta * t516);
    const float t528 = t524 + (motion->constants[24] * t443) + t456 - (t150 * t471) -
        (motion->constants[23] * t382);
    const float t530 = cos_phi * t135;
    const float t537 = (t145 * motion->constants[33]) + (motion->constants[18] * (speeds[2] +
        t145));
    const float t548 = (t428 * motion->constants[38]) + (t434 * motion->constants[41]) + (t407 *
        motion->constants[43]) + (t209 * t487) - (t204 * t509);
    const float t551 = (sin_delta * t424) + (cos_delta * t441);
    const float t557 = (motion->constants[36] * t407) + (t150 * t537) + t548 +
        (motion->constants[23] * t551) - (motion->constants[30] * t411) - (motion->constants[32] *
        t368);
    const float t558 = t557 - (t145 * t466);
    const float t572 = (motion->constants[31] * t411) + (motion->constants[32] * t407) + (t145 *
        t471) + (cos_delta * t492) - (motion->constants[35] * t368) - (t143 * t537);
    const float t574 = t572 - (sin_delta * t516) - (motion->constants[24] * t551);
    const float t578 = (t27 * t558) + (t182 * t454) - (t15 * t574);
    const float t597 = t551 + (motion->constants[30] * t407) + (motion->constants[31] * t368) +
        (t143 * t392) + (t150 * t446) - (t411 * motion->constants[34]);
    const float t600 = t73 - (sin_phi * t110);
    const float t602 = cos_phi * t110;
    const float t607 = forces[0] + (t182 * ((t27 * t397) - (t15 * t452))) + (t578 * t602) - (t15 *
        t558);
    const float t611 = t607 - (t27 * t574) - (t99 * t597) - (t528 * t600) - (t232 * t506);
    const float t613 = sin_delta * motion->constants[38];
    const float t615 = (sin_delta * motion->constants[41]) - (motion->constants[24] * t613);
    const float t618 = sin_delta * motion->constants[45];
    const float t621 = (cos_delta * t618) - (motion->constants[23] * t613);
    const float t625 = cos_delta * motion->constants[38];
    const float t628 = motion->constants[30] + t625 + motion->constants[46];
    const float t630 = (t15 * motion->constants[52]) + (t27 * t628);
    const float t633 = (t15 * t615) + (t27 * t621) + (t182 * t630);
    const float t639 = (cos_delta * motion->constants[41]) - (motion->constants[24] * t625);
    const float t642 = motion->constants[32] + t639 - motion->constants[48] - motion->constants[49];
    const float t643 = sin_delta * t618;
    const float t647 = motion->constants[35] + motion->constants[40] + motion->constants[47] - t643;
    const float t648 = motion->constants[23] * t625;
    const float t651 = t648 + t648 + motion->constants[50];
    const float t653 = motion->constants[36] + motion->constants[43] + t651;
    const float t654 = t653 - t647;
    const float t655 = t15 * t27;
    const float t657 = t15 * t15;
    const float t658 = t642 + t642;
    const float t663 = t642 + (t654 * t655) + (t99 * t630) - (t657 * t658);
    const float t667 = (t27 * motion->constants[52]) - (t15 * t628);
    const float t669 = t99 * motion->constants[51];
    const float t671 = t99 * (t667 - t669);
    const float t672 = t99 * t667;
    const float t673 = t99 * t669;
    const float t675 = t673 - t672 - t672;
    const float t680 = motion->constants[33] + motion->constants[42] + t643 +
        motion->constants[47] + t651 + t675;
    const float t686 = t182 * motion->constants[51];
    const float t691 = (t27 * t615) + (t182 * t667) + (t99 * t613) - (t15 * t621) - (t99 * t686);
    const float t694 = t671 + (t457 * t680) + (t530 * t691);
    const float t697 = t99 * (t613 - t686);
    const float t701 = (t654 * t657) + (t655 * t658);
    const float t702 = t182 * t613;
    const float t705 = (t182 * t686) - t702 - t702;
    const float t707 = t653 + t705 - t701;
    const float t710 = t697 - (t457 * t691) - (t530 * t707);
    const float t713 = 1.0F - t457;
    const float t714 = motion->constants[18] * t600;
    const float t717 = t15 * sin_delta;
    const float t720 = t246 - (cos_delta * t457) - (t530 * t717);
    const float t726 = t232 + (cos_delta * t600) - (sin_delta * t27) - (t602 * t717);
    const float t727 = motion->constants[19] * t726;
    const float t733 = (t713 * t714) + (t720 * t727) - (t457 * t633) - (t530 * t663) - (t600 *
        t694) - (t602 * t710);
    const float t753 = t647 + t675 + t701 + t705 + (t600 * t633) + (t600 * (t633 + (t600 * t680) -
        (t602 * t691))) + (t600 * t714);
    const float t756 = t753 + (t726 * t727) - (t602 * t663) - (t602 * (t663 + (t600 * t691) -
        (t602 * t707)));
    const float t757 = 1.0F / t756;
    const float t758 = t733 * t757;
    const float t760 = t27 * t613;
    const float t761 = t99 * t760;
    const float t763 = t90 - (sin_phi * t132);
    const float t765 = cos_phi * t132;
    const float t767 = t615 + t761;
    const float t769 = motion->constants[43] + t648;
    const float t774 = (t27 * t769) - (t15 * t639) - (t182 * t760);
    const float t776 = motion->constants[18] * t763;
    const float t781 = t241 + (cos_delta * t763) - (t717 * t765);
    const float t782 = motion->constants[19] * t781;
    const float t793 = t767 + (t680 * t763) - (t691 * t765);
    const float t798 = t774 + (t691 * t763) - (t707 * t765);
    const float t806 = (t15 * t769) + (t27 * t639) + (t99 * t625) + (t633 * t763) + (t600 * t793) +
        (t714 * t763);
    const float t811 = t757 * (t806 + (t727 * t781) - (t15 * t702) - (t663 * t765) - (t602 * t798));
    const float t812 = t756 * t811;
    const float t818 = t761 + (t713 * t776) + (t720 * t782) - (t694 * t763) - (t710 * t765) -
        (t457 * t767);
    const float t832 = motion->constants[43] + (t763 * t793) + (t763 * t767) + (t763 * t776) +
        (t781 * t782) - (t765 * t798);
    const float t834 = t832 - (t765 * t774) - (t811 * t812);
    const float t835 = 1.0F / t834;
    const float t836 = (t818 - (t530 * t774) - (t758 * t812)) * t835;
    const float t846 = forces[1] + (t578 * t765) - t548 - (t528 * t763) - (t241 * t506) - (t611 *
        t811);
    const float t852 = (t457 * t528) + (t530 * t578) - t456 - (t246 * t506) - (t611 * t758) -
        (t836 * t846);
    const float t869 = t673 + (t457 * t694) + (t457 * t671) + (motion->constants[18] * t713 *
        t713) + (motion->constants[19] * t720 * t720) - (t530 * t710);
    const float t873 = t852 / (t869 - (t530 * t697) - (t756 * t758 * t758) - (t834 * t836 * t836));
    const float t877 = (t835 * t846) - (t836 * t873);
    const float t881 = (t611 * t757) - (t811 * t877) - (t758 * t873);
    const float t885 = t335 + (t73 * t881) + (t90 * t877);
    const float t890 = (sin_phi * t93 * t95) + (t95 * t138) - (t99 * (t873 + t885));
    const float t896 = (motion->constants[21] * t881) + (t93 * t99 * t138);
    const float t898 = (cos_psi * t890) - (sin_psi * t896);
    const float t901 = (t890 * sin_psi) + (cos_psi * t896);
    const float t913 = t504 + (t232 * t881) + (t241 * t877) + (t246 * t873);
    const float t914 = -(t341 + (t110 * t881) + (t132 * t877) + (t135 * t873));
    accelerations[0] = t898;
    accelerations[1] = t901;
    accelerations[2] = t914;
    accelerations[3] = t881;
    accelerations[4] = t885;
    accelerations[5] = t877;
    accelerations[6] = t873;
    accelerations[7] = t913;
}

carvallo_motion_error_t whipple_tyres_f32_motion_accelerations(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES], float accelerations[WHIPPLE_TYRES_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_TYRES_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_TYRES_FORCES)) {
        whipple_tyres_f32_compute_accelerations(motion, positions, speeds, forces, accelerations);
        error = (carvallo_are_finite_f32(accelerations, WHIPPLE_TYRES_POSITIONS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_tyres_f32_compute_energy(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    float energy[2])
{
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t6 = sin_delta * motion->constants[45];
    const float t7 = sin_delta * t6;
    const float t11 = motion->constants[35] + motion->constants[40] + motion->constants[47] - t7;
    const float t17 = cos_delta * motion->constants[38];
    const float t18 = motion->constants[23] * t17;
    const float t21 = t18 + t18 + motion->constants[50];
    const float t23 = motion->constants[36] + motion->constants[43] + t21;
    const float t24 = t23 - t11;
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t32 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    const float t33 = t32 * t32;
    const float t37 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const float t38 = t32 * t37;
    const float t46 = (cos_delta * motion->constants[41]) - (t17 * motion->constants[24]);
    const float t49 = motion->constants[32] + t46 - motion->constants[48] - motion->constants[49];
    const float t50 = t49 + t49;
    const float t52 = (t24 * t33) + (t38 * t50);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t56 = motion->constants[21] * sin_phi;
    const float t57 = sin_delta * motion->constants[38];
    const float t58 = t56 * t57;
    const float t60 = t56 * motion->constants[51];
    const float t63 = (t56 * t60) - t58 - t58;
    const float t67 = motion->constants[25] + (motion->constants[21] * cos_phi);
    const float t73 = t17 + motion->constants[30] + motion->constants[46];
    const float t75 = (t37 * motion->constants[52]) - (t32 * t73);
    const float t76 = t67 * t75;
    const float t77 = motion->constants[51] * t67;
    const float t78 = t67 * t77;
    const float t80 = t78 - t76 - t76;
    const float t83 = (sin_delta * motion->constants[41]) - (motion->constants[24] * t57);
    const float t87 = (t6 * cos_delta) - (motion->constants[23] * t57);
    const float t91 = (t32 * motion->constants[52]) + (t37 * t73);
    const float t94 = (t32 * t83) + (t37 * t87) + (t56 * t91);
    const float t96 = t32 * cos_phi;
    const float t99 = (sin_delta * sin_phi) - (cos_delta * t96);
    const float t101 = t37 * cos_phi;
    const float t104 = sqrtf((t99 * t99) + (t101 * t101));
    const float t105 = 1.0F / t104;
    const float t106 = t99 * t105;
    const float t108 = t101 * t105;
    const float t109 = cos_delta * t108;
    const float t111 = (t37 * t109) - (t32 * t106);
    const float t116 = ((cos_delta * sin_phi) + (sin_delta * t96)) * motion->constants[28];
    const float t119 = sin_delta * motion->constants[26];
    const float t124 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const float t126 = (t37 * motion->constants[29]) - (t32 * t124);
    const float t129 = (cos_phi * t119) - (t111 * t116) - (sin_phi * t126);
    const float t130 = (sin_phi * motion->constants[25]) + t129;
    const float t137 = (sin_delta * cos_phi * t108) + (sin_phi * ((t37 * t106) + (t32 * t109)));
    const float t142 = (t116 * t137) + (t32 * motion->constants[29]) + (t37 * t124);
    const float t144 = 1.0F / (cos_phi * t142);
    const float t145 = t130 * t144;
    const float t146 = sin_phi * t142;
    const float t148 = sin_phi * t130;
    const float t150 = (t111 * t146) + (t137 * t148);
    const float t154 = 1.0F / ((t111 * t142) + (t130 * t137));
    const float t156 = t145 * t150 * t154;
    const float t158 = t145 - (sin_phi * t156);
    const float t165 = t49 + (t24 * t38) + (t67 * t91) - (t33 * t50);
    const float t166 = cos_phi * t156;
    const float t174 = t7 + motion->constants[47] + t21 + t80 + motion->constants[33] +
        motion->constants[42];
    const float t184 = (t37 * t83) + (t56 * t75) + (t57 * t67) - (t32 * t87) - (t60 * t67);
    const float t191 = t23 + t63 - t52;
    const float t197 = t158 * motion->constants[18];
    const float t201 = (t137 * t146) - (t111 * t148);
    const float t205 = (t137 * t142) - (t111 * t130);
    const float t211 = 1.0F / (motion->constants[28] + (t104 * motion->constants[22]));
    const float t215 = sin_delta * t32;
    const float t219 = (((t156 * t205) - (t145 * t201)) * t211) + (cos_delta * t158) - (sin_delta *
        t37) - (t166 * t215);
    const float t221 = t219 * motion->constants[19];
    const float t228 = t11 + t52 + t63 + t80 + (t94 * t158) + (t158 * (t94 + (t158 * t174) - (t166 *
        t184))) + (t158 * t197);
    const float t232 = speeds[0] * (t228 + (t219 * t221) - (t165 * t166) - (t166 * (t165 + (t158 *
        t184) - (t166 * t191))));
    const float t234 = motion->constants[43] + t18;
    const float t241 = (t37 * motion->constants[24]) - (motion->constants[23] * t32);
    const float t243 = t129 + (sin_phi * t241);
    const float t245 = t37 * sin_phi;
    const float t249 = t142 - (t32 * motion->constants[24]) - (motion->constants[23] * t37);
    const float t252 = t144 * ((t32 * t243) + (t245 * t249));
    const float t261 = motion->constants[22] + (t104 * motion->constants[28]) + (sin_phi * t119) +
        (cos_phi * t126) - (cos_phi * t241);
    const float t263 = (t101 * t249) - (t32 * t261);
    const float t267 = (t245 * t261) + (t101 * t243);
    const float t272 = t154 * ((t111 * t263) + (t137 * t267) + (t150 * t252));
    const float t274 = t252 - (sin_phi * t272);
    const float t276 = cos_phi * t272;
    const float t278 = t37 * t57;
    const float t279 = t67 * t278;
    const float t280 = t83 + t279;
    const float t284 = t280 + (t174 * t274) - (t184 * t276);
    const float t290 = (t37 * t234) - (t32 * t46) - (t56 * t278);
    const float t294 = t290 + (t184 * t274) - (t191 * t276);
    const float t307 = (t211 * ((t111 * t267) + (t205 * t272) - (t137 * t263) - (t201 * t252))) +
        (cos_delta * t274);
    const float t308 = t307 - (t215 * t276);
    const float t314 = (t32 * t234) + (t37 * t46) + (t17 * t67) + (t94 * t274) + (t158 * t284) +
        (t197 * t274);
    const float t318 = t314 + (t221 * t308) - (t32 * t58) - (t165 * t276) - (t166 * t294);
    const float t322 = t67 * t137 * t154;
    const float t323 = sin_phi * t322;
    const float t325 = cos_phi * t322;
    const float t327 = t75 - t77;
    const float t328 = t67 * t327;
    const float t332 = t328 + (t174 * t323) + (t184 * t325);
    const float t334 = t57 - t60;
    const float t335 = t67 * t334;
    const float t339 = t335 - (t184 * t323) - (t191 * t325);
    const float t342 = 1.0F - t323;
    const float t351 = (t211 * ((t67 * t111) + (t205 * t322))) - (cos_delta * t323) - (t215 * t325);
    const float t357 = (t197 * t342) + (t221 * t351) - (t94 * t323) - (t165 * t325) - (t158 *
        t332) - (t166 * t339);
    const float t367 = motion->constants[18] * t274;
    const float t369 = motion->constants[19] * t308;
    const float t375 = motion->constants[43] + (t274 * t284) + (t274 * t280) + (t274 * t367) +
        (t308 * t369) - (t276 * t294);
    const float t388 = t279 + (t342 * t367) + (t351 * t369) - (t274 * t332) - (t276 * t339) -
        (t280 * t323);
    const float t389 = t388 - (t290 * t325);
    const float t393 = speeds[1] * ((speeds[0] * t318) + (speeds[1] * (t375 - (t276 * t290))) +
        (speeds[2] * t389));
    const float t408 = t78 + (t323 * t332) + (t323 * t328) + (motion->constants[18] * t342 * t342) +
        (motion->constants[19] * t351 * t351) - (t325 * t339);
    const float t415 = (speeds[0] * (t232 + (speeds[1] * t318) + (speeds[2] * t357))) + t393 +
        (speeds[2] * ((speeds[0] * t357) + (speeds[1] * t389) + (speeds[2] * (t408 - (t325 *
        t335)))));
    const float t417 = t415 * 0.5F;
    const float t423 = -(motion->constants[44] * ((sin_phi * t334) + (cos_phi * t327)));
    energy[0] = t417;
    energy[1] = t423;
}

carvallo_motion_error_t whipple_tyres_f32_motion_energy(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    float energy[2])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_TYRES_SPEEDS)) {
        whipple_tyres_f32_compute_energy(motion, positions, speeds, energy);
        error = (carvallo_are_finite_f32(energy, 2U)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

/* How far the lowest points of the wheels behind the first are below the ground, and the steps of Newton's method. */
static void whipple_tyres_f32_compute_closure(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], float below[1U], float steps[1U])
{
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t15 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    const float t16 = cos_phi * t15;
    const float t20 = sin_phi * sin_delta;
    const float t21 = t20 - (cos_delta * t16);
    const float t25 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const float t26 = cos_phi * t25;
    const float t29 = sqrtf((t21 * t21) + (t26 * t26));
    const float t38 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const float t46 = motion->constants[22] + (t29 * motion->constants[28]) + (t20 *
        motion->constants[26]) + (cos_phi * ((t25 * motion->constants[29]) - (t15 * t38))) -
        motion->constants[21] - (cos_phi * motion->constants[25]);
    const float t50 = 1.0F / t29;
    const float t51 = t26 * t50;
    const float t62 = motion->constants[28] * ((cos_delta * sin_phi) + (t16 * sin_delta)) *
        ((cos_phi * sin_delta * t51) + (sin_phi * ((t21 * t25 * t50) + (cos_delta * t15 * t51))));
    const float t68 = t46 / (cos_phi * (t62 + (t15 * motion->constants[29]) + (t25 * t38)));
    below[0] = t46;
    steps[0] = t68;
}

carvallo_motion_error_t whipple_tyres_f32_motion_close(const whipple_tyres_f32_motion_t *motion,
    float positions[WHIPPLE_TYRES_POSITIONS])
{
    /* The positions that the heights of the wheels determine. */
    static const size_t DEPENDENT[1U] = {4U};
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_TYRES_POSITIONS)) {
        float found[WHIPPLE_TYRES_POSITIONS];
        float below[1U];
        float steps[1U];
        float shortest = 1e30F;
        bool is_closed = false;
        bool goes_on = true;
        for (size_t i = 0U; i < WHIPPLE_TYRES_POSITIONS; i++) {
            found[i] = positions[i];
        }
        /* With steps of the greatest length they lead around the whole circle; near a solution a handful is enough. */
        for (size_t count = 0U; goes_on && (count < 60U); count++) {
            whipple_tyres_f32_compute_closure(motion, found, below, steps);
            if (carvallo_are_finite_f32(steps, 1U)) {
                float longest = 0.0F;
                float size = 1.0F;
                float share = 1.0F;
                for (size_t i = 0U; i < 1U; i++) {
                    longest = (fabsf(steps[i]) > longest) ? fabsf(steps[i]) : longest;
                }
                /* No step is longer than this, in rad or m: it keeps to the solution that is near. */
                if (longest > 0.25F) {
                    share = 0.25F / longest;
                }
                for (size_t i = 0U; i < 1U; i++) {
                    found[DEPENDENT[i]] += steps[i] * share;
                }
                for (size_t i = 0U; i < 1U; i++) {
                    const float value = fabsf(found[DEPENDENT[i]]);
                    size = (value > size) ? value : size;
                }
                /* Near the solution steps shrink to rounding, and then no further. */
                is_closed = (longest <= (4.0F * FLT_EPSILON * size)) || ((longest < 1e-5F) &&
                    (longest >= shortest));
                goes_on = !is_closed;
                shortest = longest;
            } else {
                goes_on = false;
            }
        }
        if (is_closed) {
            error = CARVALLO_MOTION_OK;
            for (size_t i = 0U; i < 1U; i++) {
                positions[DEPENDENT[i]] = found[DEPENDENT[i]];
            }
        } else {
            float most = 0.0F;
            bool is_finite = false;
            whipple_tyres_f32_compute_closure(motion, found, below, steps);
            is_finite = carvallo_is_finite_f32(below[0]);
            for (size_t i = 0U; i < 1U; i++) {
                if (carvallo_is_finite_f32(below[i]) && (fabsf(below[i]) > most)) {
                    most = fabsf(below[i]);
                    is_finite = true;
                }
            }
            error = is_finite ? CARVALLO_MOTION_NOT_CLOSED : CARVALLO_MOTION_SINGULAR;
        }
    }
    return error;
}

static void whipple_tyres_f32_compute_contact_forces(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES], float contact_forces[3U * WHIPPLE_TYRES_WHEELS])
{
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t9 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    const float t13 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t19 = t9 * cos_phi;
    const float t24 = (sin_phi * sin_delta) - (cos_delta * t19);
    const float t26 = t13 * cos_phi;
    const float t29 = sqrtf((t24 * t24) + (t26 * t26));
    const float t30 = 1.0F / t29;
    const float t31 = t24 * t30;
    const float t33 = t26 * t30;
    const float t34 = cos_delta * t33;
    const float t36 = (t13 * t34) - (t9 * t31);
    const float t43 = (cos_phi * sin_delta * t33) + (sin_phi * ((t13 * t31) + (t9 * t34)));
    const float t46 = (cos_delta * sin_phi) + (t19 * sin_delta);
    const float t48 = t46 * motion->constants[28];
    const float t55 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const float t58 = (t43 * t48) + (t9 * motion->constants[29]) + (t13 * t55);
    const float t59 = sin_phi * t58;
    const float t64 = sin_delta * motion->constants[26];
    const float t68 = (t13 * motion->constants[29]) - (t9 * t55);
    const float t71 = (cos_phi * t64) - (t36 * t48) - (sin_phi * t68);
    const float t72 = (sin_phi * motion->constants[25]) + t71;
    const float t73 = sin_phi * t72;
    const float t75 = (t36 * t59) + (t43 * t73);
    const float t77 = 1.0F / (cos_phi * t58);
    const float t78 = t72 * t77;
    const float t82 = 1.0F / ((t36 * t58) + (t43 * t72));
    const float t84 = t75 * t78 * t82;
    const float t91 = t58 - (t9 * motion->constants[24]) - (t13 * motion->constants[23]);
    const float t99 = (t13 * motion->constants[24]) - (t9 * motion->constants[23]);
    const float t104 = motion->constants[22] + (t29 * motion->constants[28]) + (sin_phi * t64) +
        (cos_phi * t68) - (cos_phi * t99);
    const float t106 = (t26 * t91) - (t9 * t104);
    const float t108 = t13 * sin_phi;
    const float t111 = t71 + (sin_phi * t99);
    const float t113 = (t104 * t108) + (t26 * t111);
    const float t118 = t77 * ((t9 * t111) + (t91 * t108));
    const float t122 = t82 * ((t36 * t106) + (t43 * t113) + (t75 * t118));
    const float t127 = motion->constants[25] + (cos_phi * motion->constants[21]);
    const float t129 = t43 * t82 * t127;
    const float t132 = (speeds[0] * t84) + (speeds[1] * t122) + (speeds[2] * t129);
    const float t133 = cos_phi * t132;
    const float t135 = (speeds[0] * t13) + (t9 * t133);
    const float t138 = (t9 * speeds[0]) - (t13 * t133);
    const float t143 = (t138 * motion->constants[30]) - (t135 * motion->constants[31]);
    const float t147 = (speeds[0] * t78) + (speeds[1] * t118);
    const float t148 = sin_phi * t132;
    const float t149 = t147 - t148;
    const float t150 = motion->constants[31] * t149;
    const float t152 = (t135 * t143) - (t149 * t150);
    const float t154 = speeds[0] * motion->constants[25];
    const float t155 = t133 * t154;
    const float t156 = motion->constants[24] * t149;
    const float t158 = motion->constants[23] * t149;
    const float t160 = (t138 * t156) + (t135 * t158);
    const float t161 = speeds[0] * t148;
    const float t163 = t135 * t147;
    const float t164 = (t13 * t161) + t163;
    const float t167 = t138 * t147;
    const float t168 = (t9 * t161) + t167;
    const float t170 = speeds[2] + t147;
    const float t171 = t133 * t170;
    const float t173 = motion->constants[25] * t148;
    const float t174 = t133 * t173;
    const float t175 = t174 - (t127 * t171);
    const float t178 = t160 + (motion->constants[23] * t164) + (motion->constants[24] * t168) -
        t175;
    const float t183 = (motion->constants[23] * t138) - (motion->constants[24] * t135);
    const float t185 = (t149 * t158) + (t138 * t183);
    const float t186 = speeds[0] * t133;
    const float t189 = sin_phi * motion->constants[21];
    const float t190 = speeds[0] * t170;
    const float t194 = t155 + (t127 * t186) + (t189 * (t161 + t190));
    const float t200 = (t173 * (t170 - t148)) - (speeds[0] * t154);
    const float t201 = (t171 * t189) + t200;
    const float t205 = (t13 * t194) + (t9 * t201) - t185 - (motion->constants[24] * t186);
    const float t207 = speeds[1] + t138;
    const float t211 = (cos_delta * t149) - (sin_delta * t135);
    const float t212 = motion->constants[27] * t211;
    const float t216 = (cos_delta * t135) + (sin_delta * t149);
    const float t217 = motion->constants[26] * t211;
    const float t222 = speeds[1] * t211;
    const float t224 = t222 - (cos_delta * t168) - (sin_delta * t186);
    const float t227 = motion->constants[28] + (t29 * motion->constants[22]);
    const float t228 = t31 * t227;
    const float t231 = (t43 * t59) - (t36 * t73);
    const float t235 = (t43 * t58) - (t36 * t72);
    const float t238 = 1.0F / t227;
    const float t239 = ((t84 * t235) - (t78 * t231)) * t238;
    const float t248 = t238 * ((t36 * t113) + (t122 * t235) - (t43 * t106) - (t118 * t231));
    const float t253 = t238 * ((t36 * t127) + (t129 * t235));
    const float t256 = (speeds[0] * t239) + (speeds[1] * t248) + (speeds[2] * t253);
    const float t258 = t164 + (t216 * t256);
    const float t260 = t33 * t227;
    const float t262 = t224 - (t207 * t256);
    const float t268 = t30 * ((t31 * t216) + (t33 * t207)) * t48;
    const float t269 = t33 * t268;
    const float t271 = t31 * t268;
    const float t277 = (cos_delta * t178) + (t207 * t212) + (t216 * t217) + (motion->constants[26] *
        t164) + (t228 * t258) + (t207 * t269);
    const float t281 = t277 + (t216 * t271) - (sin_delta * t205) - (motion->constants[27] * t224) -
        (t260 * t262);
    const float t288 = (motion->constants[26] * t207) - (motion->constants[27] * t216);
    const float t292 = speeds[1] * t216;
    const float t294 = (sin_delta * t168) - (cos_delta * t186) - t292;
    const float t297 = t46 * motion->constants[22];
    const float t299 = t211 + t256;
    const float t304 = motion->constants[28] * ((t31 * t207) - (t33 * t216));
    const float t310 = (cos_delta * t205) + (sin_delta * t178) + (motion->constants[27] * t294) +
        (t260 * t294) - (t211 * t217) - (t207 * t288);
    const float t313 = t310 - (t258 * t297) - (t271 * t299) - (t207 * t304);
    const float t317 = (t135 * t183) - (t149 * t156);
    const float t332 = t317 + (motion->constants[23] * t186) + (t9 * t194) + (t216 * t288) + (t262 *
        t297) + (t216 * t304);
    const float t337 = t332 - (t13 * t201) - (t211 * t212) - (motion->constants[26] * t294) -
        (t228 * t294) - (t269 * t299);
    const float t339 = (t31 * t313) + (t33 * t337);
    const float t344 = t77 * ((t46 * t281) + (t29 * t339));
    const float t348 = t82 * ((t29 * t281) + (t75 * t344) - (t46 * t339));
    const float t350 = t186 - t344;
    const float t351 = (sin_phi * t348) + t350;
    const float t355 = cos_phi * motion->constants[44];
    const float t356 = t201 + t355;
    const float t360 = t161 - (cos_phi * t348);
    const float t364 = (t127 * t351) + t155 + (t189 * (t190 + t360));
    const float t366 = (t13 * t356) - (t9 * t364);
    const float t369 = t317 - t366 + (motion->constants[23] * t351);
    const float t375 = t167 + (t9 * t360);
    const float t378 = (sin_delta * t375) - (cos_delta * t351) - t292;
    const float t383 = (t207 * motion->constants[38]) - (t216 * motion->constants[39]);
    const float t385 = t211 * motion->constants[39];
    const float t387 = (t216 * t383) - (t211 * t385);
    const float t389 = (t369 * motion->constants[37]) + t387 - (motion->constants[38] * t378);
    const float t394 = t152 + t389 - (motion->constants[34] * t366) + (motion->constants[30] *
        t351);
    const float t398 = (t9 * t356) + (t13 * t364);
    const float t401 = t398 - (motion->constants[24] * t351) - t185;
    const float t404 = t163 + (t13 * t360);
    const float t407 = sin_phi * motion->constants[44];
    const float t408 = t175 + t407;
    const float t411 = t160 + (motion->constants[23] * t404) + (motion->constants[24] * t375) -
        t408;
    const float t413 = (cos_delta * t401) + (sin_delta * t411);
    const float t416 = t211 * motion->constants[38];
    const float t419 = (t211 * t416) + (t207 * t383);
    const float t421 = (t413 * motion->constants[37]) + (motion->constants[39] * t378) - t419;
    const float t425 = (cos_delta * t411) - (sin_delta * t401);
    const float t431 = t222 - (sin_delta * t351) - (cos_delta * t375);
    const float t435 = (t207 * t385) + (t216 * t416);
    const float t438 = (t425 * motion->constants[37]) + (t404 * motion->constants[38]) + t435 -
        (motion->constants[39] * t431);
    const float t440 = (cos_delta * t421) - (sin_delta * t438);
    const float t443 = motion->constants[30] * t149;
    const float t446 = (t149 * t443) + (t138 * t143);
    const float t449 = t440 + (motion->constants[34] * t398) - (motion->constants[31] * t351) -
        t446;
    const float t451 = (t9 * t394) + (t13 * t449);
    const float t453 = (t351 * motion->constants[18]) + (t127 * t451);
    const float t454 = sin_phi * t129;
    const float t463 = (t135 * motion->constants[35]) + (t138 * motion->constants[32]);
    const float t468 = (t135 * motion->constants[32]) + (t138 * motion->constants[36]);
    const float t470 = (t138 * t463) - (t135 * t468);
    const float t479 = (t216 * motion->constants[41]) + (t207 * motion->constants[43]);
    const float t485 = (t211 * motion->constants[42]) + (t299 * motion->constants[19]);
    const float t487 = (t211 * t479) - (t207 * t485);
    const float t490 = (motion->constants[40] * t431) + (t404 * motion->constants[41]) + t487 -
        (motion->constants[39] * t425);
    const float t502 = t238 * ((t31 * t337) + (t235 * t348) - (t33 * t313) - (t231 * t344));
    const float t504 = motion->constants[19] * (t378 + t502);
    const float t507 = (t216 * motion->constants[40]) + (t207 * motion->constants[41]);
    const float t510 = (t207 * t507) - (t216 * t479);
    const float t514 = (motion->constants[39] * t413) + (motion->constants[42] * t378) + t504 +
        t510 - (motion->constants[38] * t369);
    const float t522 = (motion->constants[31] * t398) + (motion->constants[30] * t366) - (t351 *
        motion->constants[33]) + t470 + (sin_delta * t490) + (cos_delta * t514);
    const float t525 = t522 + (motion->constants[24] * t440) - t453 - (motion->constants[23] *
        t389);
    const float t527 = cos_phi * t129;
    const float t534 = (t149 * motion->constants[33]) + (motion->constants[18] * (speeds[2] +
        t149));
    const float t537 = (t135 * t534) - (t149 * t463);
    const float t543 = (t216 * t485) - (t211 * t507);
    const float t546 = (t425 * motion->constants[38]) + (t431 * motion->constants[41]) + (t404 *
        motion->constants[43]) + t543;
    const float t549 = (sin_delta * t421) + (cos_delta * t438);
    const float t555 = (motion->constants[36] * t404) + t537 + t546 + (motion->constants[23] *
        t549) - (motion->constants[30] * t408) - (motion->constants[32] * t375);
    const float t562 = (t149 * t468) - (t138 * t534);
    const float t570 = (motion->constants[31] * t408) + (motion->constants[32] * t404) + t562 +
        (cos_delta * t490) - (motion->constants[35] * t375) - (sin_delta * t514);
    const float t571 = t570 - (motion->constants[24] * t549);
    const float t575 = (t13 * t555) + (t189 * t451) - (t9 * t571);
    const float t590 = (t138 * t150) + (t135 * t443);
    const float t595 = t127 * (t549 + (motion->constants[30] * t404) + (motion->constants[31] *
        t375) + t590 - (motion->constants[34] * t408));
    const float t597 = t78 - (sin_phi * t84);
    const float t599 = cos_phi * t84;
    const float t604 = forces[0] + (t189 * ((t13 * t394) - (t9 * t449))) + (t575 * t599) - (t9 *
        t555);
    const float t608 = t604 - (t13 * t571) - t595 - (t525 * t597) - (t239 * t504);
    const float t610 = sin_delta * motion->constants[38];
    const float t612 = (sin_delta * motion->constants[41]) - (motion->constants[24] * t610);
    const float t615 = sin_delta * motion->constants[45];
    const float t618 = (cos_delta * t615) - (motion->constants[23] * t610);
    const float t622 = cos_delta * motion->constants[38];
    const float t625 = motion->constants[30] + t622 + motion->constants[46];
    const float t627 = (t9 * motion->constants[52]) + (t13 * t625);
    const float t630 = (t9 * t612) + (t13 * t618) + (t189 * t627);
    const float t636 = (cos_delta * motion->constants[41]) - (motion->constants[24] * t622);
    const float t639 = motion->constants[32] + t636 - motion->constants[48] - motion->constants[49];
    const float t640 = sin_delta * t615;
    const float t644 = motion->constants[35] + motion->constants[40] + motion->constants[47] - t640;
    const float t645 = motion->constants[23] * t622;
    const float t648 = t645 + t645 + motion->constants[50];
    const float t650 = motion->constants[36] + motion->constants[43] + t648;
    const float t651 = t650 - t644;
    const float t652 = t9 * t13;
    const float t654 = t9 * t9;
    const float t655 = t639 + t639;
    const float t660 = t639 + (t651 * t652) + (t127 * t627) - (t654 * t655);
    const float t664 = (t13 * motion->constants[52]) - (t9 * t625);
    const float t666 = t127 * motion->constants[51];
    const float t668 = t127 * (t664 - t666);
    const float t669 = t127 * t664;
    const float t670 = t127 * t666;
    const float t672 = t670 - t669 - t669;
    const float t677 = motion->constants[33] + motion->constants[42] + t640 +
        motion->constants[47] + t648 + t672;
    const float t683 = t189 * motion->constants[51];
    const float t688 = (t13 * t612) + (t189 * t664) + (t127 * t610) - (t9 * t618) - (t127 * t683);
    const float t691 = t668 + (t454 * t677) + (t527 * t688);
    const float t694 = t127 * (t610 - t683);
    const float t698 = (t651 * t654) + (t652 * t655);
    const float t699 = t189 * t610;
    const float t702 = (t189 * t683) - t699 - t699;
    const float t704 = t650 + t702 - t698;
    const float t707 = t694 - (t454 * t688) - (t527 * t704);
    const float t710 = 1.0F - t454;
    const float t711 = motion->constants[18] * t597;
    const float t714 = t9 * sin_delta;
    const float t717 = t253 - (cos_delta * t454) - (t527 * t714);
    const float t723 = t239 + (cos_delta * t597) - (t13 * sin_delta) - (t599 * t714);
    const float t724 = motion->constants[19] * t723;
    const float t730 = (t710 * t711) + (t717 * t724) - (t454 * t630) - (t527 * t660) - (t597 *
        t691) - (t599 * t707);
    const float t750 = t644 + t672 + t698 + t702 + (t597 * t630) + (t597 * (t630 + (t597 * t677) -
        (t599 * t688))) + (t597 * t711);
    const float t753 = t750 + (t723 * t724) - (t599 * t660) - (t599 * (t660 + (t597 * t688) -
        (t599 * t704)));
    const float t754 = 1.0F / t753;
    const float t755 = t730 * t754;
    const float t757 = t13 * t610;
    const float t758 = t127 * t757;
    const float t760 = t118 - (sin_phi * t122);
    const float t762 = cos_phi * t122;
    const float t764 = t612 + t758;
    const float t766 = motion->constants[43] + t645;
    const float t771 = (t13 * t766) - (t9 * t636) - (t189 * t757);
    const float t773 = motion->constants[18] * t760;
    const float t778 = t248 + (cos_delta * t760) - (t714 * t762);
    const float t779 = motion->constants[19] * t778;
    const float t790 = t764 + (t677 * t760) - (t688 * t762);
    const float t795 = t771 + (t688 * t760) - (t704 * t762);
    const float t803 = (t9 * t766) + (t13 * t636) + (t127 * t622) + (t630 * t760) + (t597 * t790) +
        (t711 * t760);
    const float t808 = t754 * (t803 + (t724 * t778) - (t9 * t699) - (t660 * t762) - (t599 * t795));
    const float t809 = t753 * t808;
    const float t815 = t758 + (t710 * t773) + (t717 * t779) - (t691 * t760) - (t707 * t762) -
        (t454 * t764);
    const float t829 = motion->constants[43] + (t760 * t790) + (t760 * t764) + (t760 * t773) +
        (t778 * t779) - (t762 * t795);
    const float t831 = t829 - (t762 * t771) - (t808 * t809);
    const float t832 = 1.0F / t831;
    const float t833 = (t815 - (t527 * t771) - (t755 * t809)) * t832;
    const float t843 = forces[1] + (t575 * t762) - t546 - (t525 * t760) - (t248 * t504) - (t608 *
        t808);
    const float t849 = (t454 * t525) + (t527 * t575) + t453 - (t253 * t504) - (t608 * t755) -
        (t833 * t843);
    const float t866 = t670 + (t454 * t691) + (t454 * t668) + (motion->constants[18] * t710 *
        t710) + (motion->constants[19] * t717 * t717) - (t527 * t707);
    const float t870 = t849 / (t866 - (t527 * t694) - (t753 * t755 * t755) - (t831 * t833 * t833));
    const float t874 = (t832 * t843) - (t833 * t870);
    const float t878 = (t608 * t754) - (t808 * t874) - (t755 * t870);
    const float t886 = t348 + (t84 * t878) + (t122 * t874) + (t129 * t870);
    const float t890 = (t78 * t878) + (t118 * t874) - (sin_phi * t886) - t350;
    const float t891 = t870 + t890;
    const float t894 = t161 - (cos_phi * t886);
    const float t898 = (t127 * t891) - t155 - (t189 * (t190 + t894));
    const float t900 = t171 + t878;
    const float t903 = t200 + t355 + (t189 * t900);
    const float t905 = (t9 * t898) + (t13 * t903);
    const float t910 = t317 - t905 - (motion->constants[23] * t890);
    const float t916 = (t13 * t878) - t167 - (t9 * t894);
    const float t919 = (cos_delta * t890) - t292 - (sin_delta * t916);
    const float t922 = t387 + (motion->constants[37] * t910) - (motion->constants[38] * t919);
    const float t925 = t152 + t922 - (motion->constants[34] * t905) - (motion->constants[30] *
        t890);
    const float t929 = (t9 * t903) - (t13 * t898);
    const float t934 = t929 + (motion->constants[24] * t890) - t185;
    const float t939 = t163 + (t13 * t894) + (t9 * t878);
    const float t944 = t174 + t407 - (t127 * t900);
    const float t947 = t160 + (motion->constants[23] * t939) - (motion->constants[24] * t916) -
        t944;
    const float t949 = (cos_delta * t934) + (sin_delta * t947);
    const float t953 = (motion->constants[37] * t949) + (motion->constants[39] * t919) - t419;
    const float t957 = (cos_delta * t947) - (sin_delta * t934);
    const float t959 = t874 + t939;
    const float t964 = t222 + (cos_delta * t916) + (sin_delta * t890);
    const float t968 = t435 + (motion->constants[37] * t957) + (motion->constants[38] * t959) -
        (motion->constants[39] * t964);
    const float t970 = (cos_delta * t953) - (sin_delta * t968);
    const float t973 = (motion->constants[34] * t929) + (motion->constants[31] * t890) + t970 -
        t446;
    const float t975 = (t9 * t925) + (t13 * t973);
    const float t983 = motion->constants[19] * (t502 + t919 + (t239 * t878) + (t248 * t874) +
        (t253 * t870));
    const float t984 = t238 * t983;
    const float t995 = t487 + (motion->constants[40] * t964) + (motion->constants[41] * t959) -
        (motion->constants[39] * t957);
    const float t1003 = t510 + t983 + (motion->constants[39] * t949) + (motion->constants[42] *
        t919) - (motion->constants[38] * t910);
    const float t1012 = t470 + (motion->constants[31] * t929) + (motion->constants[30] * t905) +
        (motion->constants[33] * t890) + (motion->constants[18] * t891) + (sin_delta * t995);
    const float t1016 = t1012 + (cos_delta * t1003) + (motion->constants[24] * t970) -
        (motion->constants[23] * t922) - (t127 * t975);
    const float t1026 = (sin_delta * t953) + (cos_delta * t968);
    const float t1033 = t537 + t543 + (motion->constants[32] * t916) + (motion->constants[36] *
        t939) + (motion->constants[38] * t957) + (motion->constants[41] * t964) +
        (motion->constants[43] * t959);
    const float t1047 = t562 + (motion->constants[31] * t944) + (motion->constants[35] * t916) +
        (motion->constants[32] * t939) + (cos_delta * t995) - (sin_delta * t1003);
    const float t1052 = (t13 * (t1033 + (motion->constants[23] * t1026) - (motion->constants[30] *
        t944))) + (t189 * t975) - (t9 * (t1047 - (motion->constants[24] * t1026)));
    const float t1057 = t82 * ((sin_phi * t1016) + (cos_phi * t1052) - (t235 * t984));
    const float t1059 = (t36 * t984) - (t43 * t1057);
    const float t1060 = t975 - t1059;
    const float t1065 = (t43 * t984) + (t36 * t1057);
    const float t1072 = t590 + t1026 + (motion->constants[30] * t939) - (motion->constants[34] *
        t944) - (motion->constants[31] * t916);
    const float t1076 = (t13 * t925) - (t9 * t973);
    const float t1079 = (cos_phi * t1072) - t1065 - (sin_phi * t1076);
    const float t1081 = (cos_psi * t1060) - (sin_psi * t1079);
    const float t1084 = (t1060 * sin_psi) + (cos_psi * t1079);
    const float t1089 = t77 * (t1016 - (t75 * t1057) - (t231 * t984));
    const float t1093 = t1089 + (sin_phi * t1072) + (cos_phi * t1076);
    const float t1096 = (cos_psi * t1059) - (sin_psi * t1065);
    const float t1099 = (t1059 * sin_psi) + (cos_psi * t1065);
    const float t1100 = -t1089;
    contact_forces[0] = t1081;
    contact_forces[1] = t1084;
    contact_forces[2] = t1093;
    contact_forces[3] = t1096;
    contact_forces[4] = t1099;
    contact_forces[5] = t1100;
}

carvallo_motion_error_t whipple_tyres_f32_motion_contact_forces(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES], float contact_forces[3U * WHIPPLE_TYRES_WHEELS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_TYRES_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_TYRES_FORCES)) {
        whipple_tyres_f32_compute_contact_forces(motion, positions, speeds, forces, contact_forces);
        error = (carvallo_are_finite_f32(contact_forces, 3U * WHIPPLE_TYRES_WHEELS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_tyres_f32_compute_linearization(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES], whipple_tyres_f32_linearization_t *linearization)
{
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t6 = motion->constants[25] + (motion->constants[21] * cos_phi);
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t18 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t21 = cos_phi * t18;
    const float t24 = sin_phi * sin_delta;
    const float t25 = t24 - (cos_delta * t21);
    const float t29 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const float t30 = cos_phi * t29;
    const float t33 = sqrtf((t25 * t25) + (t30 * t30));
    const float t34 = 1.0F / t33;
    const float t35 = t25 * t34;
    const float t37 = t30 * t34;
    const float t38 = cos_delta * t37;
    const float t40 = (t29 * t38) - (t18 * t35);
    const float t41 = sin_phi * cos_delta;
    const float t42 = t21 * sin_delta;
    const float t43 = t41 + t42;
    const float t45 = t43 * motion->constants[28];
    const float t48 = sin_delta * motion->constants[26];
    const float t54 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const float t56 = (t29 * motion->constants[29]) - (t18 * t54);
    const float t59 = (cos_phi * t48) - (t40 * t45) - (sin_phi * t56);
    const float t60 = (motion->constants[25] * sin_phi) + t59;
    const float t61 = sin_delta * t37;
    const float t65 = (t29 * t35) + (t18 * t38);
    const float t67 = (cos_phi * t61) + (sin_phi * t65);
    const float t72 = (t45 * t67) + (t18 * motion->constants[29]) + (t29 * t54);
    const float t74 = 1.0F / (cos_phi * t72);
    const float t75 = t60 * t74;
    const float t81 = (t29 * motion->constants[24]) - (t18 * motion->constants[23]);
    const float t83 = t59 + (sin_phi * t81);
    const float t85 = sin_phi * t29;
    const float t88 = (t18 * motion->constants[24]) + (t29 * motion->constants[23]);
    const float t89 = t72 - t88;
    const float t92 = t74 * ((t18 * t83) + (t85 * t89));
    const float t94 = (speeds[0] * t75) + (speeds[1] * t92);
    const float t95 = speeds[2] + t94;
    const float t96 = t6 * t95;
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t100 = motion->constants[21] * speeds[0];
    const float t103 = (t96 * sin_psi) - (t100 * cos_psi);
    const float t104 = motion->constants[21] * sin_phi;
    const float t105 = t95 * t104;
    const float t107 = t6 * cos_psi;
    const float t108 = motion->constants[25] * cos_phi;
    const float t110 = t74 * t75;
    const float t111 = sin_phi * t72;
    const float t115 = (sin_phi * t48) + (cos_phi * t56);
    const float t116 = t18 * t75;
    const float t117 = sin_phi * motion->constants[29];
    const float t119 = t29 * t75;
    const float t120 = sin_phi * t54;
    const float t122 = t40 * motion->constants[28];
    const float t123 = cos_phi * cos_delta;
    const float t124 = t18 * sin_delta;
    const float t126 = cos_phi * sin_delta;
    const float t129 = t123 + (t119 * t126) - (sin_phi * t124);
    const float t134 = t18 * cos_delta;
    const float t135 = sin_phi * t134;
    const float t137 = t34 * t123;
    const float t139 = t34 * t34;
    const float t140 = t25 * t139;
    const float t143 = t34 * 0.5F;
    const float t144 = (t25 + t25) * t143;
    const float t147 = t143 * (t30 + t30);
    const float t152 = cos_phi * t147;
    const float t154 = t123 * t144;
    const float t158 = (t126 * t144) - (sin_phi * ((t29 * t147) - (t134 * t144))) - (t116 * t152) -
        (t119 * t154);
    const float t162 = (t34 * t126) + (t34 * t135) - (t119 * t137) - (t140 * t158);
    const float t164 = cos_delta * t29;
    const float t166 = cos_phi * t34;
    const float t168 = t30 * t139;
    const float t171 = (t34 * t85) + (t116 * t166) + (t158 * t168);
    const float t175 = (t38 * t116) + (t35 * t119) + (t18 * t162) + (t164 * t171);
    const float t180 = (t116 * t117) + (t119 * t120) + (t45 * t175) - t115 - (t122 * t129);
    const float t182 = cos_phi * t110;
    const float t185 = motion->constants[28] * t67;
    const float t189 = sin_phi * t35;
    const float t191 = sin_phi * t38;
    const float t194 = t126 + t135;
    const float t200 = (cos_phi * t65) + (t119 * t191) + (t85 * t162) - (sin_phi * t61) - (t116 *
        t189) - (t171 * t194);
    const float t204 = (motion->constants[29] * t119) + (t129 * t185) + (t45 * t200) - (t54 * t116);
    const float t208 = (t74 * t108) + (t110 * t111) + (t74 * t180) - (t182 * t204);
    const float t210 = t29 * t89;
    const float t212 = t18 * t74;
    const float t216 = t74 * t92;
    const float t220 = t74 * t85;
    const float t222 = sin_phi * motion->constants[24];
    const float t225 = (sin_phi * t74 * t89) + (t212 * t222) - (motion->constants[23] * t220);
    const float t229 = sin_phi * motion->constants[23];
    const float t232 = (t74 * t83) - (motion->constants[24] * t220) - (t212 * t229);
    const float t236 = t220 - (cos_phi * t216);
    const float t240 = (cos_phi * ((t74 * t210) + (t81 * t212))) + (t111 * t216) + (t119 * t232) +
        (t180 * t212);
    const float t242 = t240 + (t204 * t236) - (t116 * t225);
    const float t244 = (speeds[0] * t208) + (speeds[1] * t242);
    const float t246 = (cos_psi * t105) - (t107 * t244);
    const float t248 = t18 * motion->constants[26];
    const float t250 = t18 * t92;
    const float t252 = t29 * t92;
    const float t255 = (t126 * t252) - t25;
    const float t257 = sin_delta * t29;
    const float t270 = (t41 * t144) + (t42 * t144) - (t152 * t250) - (t154 * t252);
    const float t274 = (t34 * t41) + (t34 * t42) - (t137 * t252) - (t140 * t270);
    const float t278 = (t166 * t250) + (t168 * t270);
    const float t283 = (t37 * t257) + (t38 * t250) + (t35 * t252) + (t18 * t274) + (t164 * t278);
    const float t289 = (motion->constants[26] * t123) + (t117 * t250) + (t120 * t252) + (t45 *
        t283) - (t24 * t248) - (t122 * t255);
    const float t306 = (t37 * t123) + (t191 * t252) + (t85 * t274) - (t18 * t24 * t37) - (t189 *
        t250) - (t194 * t278);
    const float t311 = (motion->constants[29] * t252) + (t185 * t255) + (t45 * t306) -
        (motion->constants[26] * t257) - (t54 * t250);
    const float t313 = (t74 * t289) - (t182 * t311);
    const float t321 = (t232 * t252) + (t212 * t289) + (t236 * t311) - (t225 * t250);
    const float t323 = (speeds[0] * t313) + (speeds[1] * t321);
    const float t333 = t6 * sin_psi;
    const float t335 = (sin_psi * t105) - (t244 * t333);
    const float t339 = (motion->constants[21] * cos_psi) - (t75 * t333);
    const float t343 = (t40 * t72) + (t60 * t67);
    const float t344 = 1.0F / t343;
    const float t345 = t67 * t344;
    const float t347 = t6 * t344;
    const float t349 = t67 * t347;
    const float t350 = t344 * t349;
    const float t359 = (t67 * t108) + (t60 * t200) + (t67 * t180) + (t40 * t204) - (t72 * t175);
    const float t362 = (t200 * t347) - (t104 * t345) - (t350 * t359);
    const float t364 = t75 * t344;
    const float t365 = sin_phi * t67;
    const float t370 = sin_phi * t60;
    const float t373 = sin_phi * t40;
    const float t377 = (cos_phi * (t343 + (motion->constants[25] * t365))) + (t200 * t370) + (t180 *
        t365) + (t204 * t373);
    const float t378 = t377 - (t111 * t175);
    const float t382 = (t40 * t111) + (t67 * t370);
    const float t383 = t344 * t382;
    const float t384 = t75 * t383;
    const float t385 = t344 * t384;
    const float t389 = (t364 * t378) + (t208 * t383) - (t359 * t385);
    const float t396 = t115 + motion->constants[22] + (t33 * motion->constants[28]) - (cos_phi *
        t81);
    const float t399 = (t29 * t396) + (t30 * t81);
    const float t401 = t40 * t344;
    const float t404 = (t85 * t345) - (t18 * t401);
    const float t409 = t29 * t83;
    const float t411 = t56 - t81;
    const float t418 = (cos_phi * t89) - (t30 * motion->constants[23]);
    const float t424 = (sin_phi * t396) + (cos_phi * t83) + (t30 * t222);
    const float t428 = (cos_phi * motion->constants[29]) - (cos_phi * motion->constants[24]);
    const float t431 = (t401 * t418) + (t345 * t424) + (t404 * t428);
    const float t434 = t396 + (t30 * motion->constants[24]);
    const float t436 = t30 * t229;
    const float t440 = (cos_phi * motion->constants[23]) - (cos_phi * t54);
    const float t443 = (t404 * t440) - (t401 * t434) - (t345 * t436);
    const float t445 = motion->constants[28] * t404;
    const float t449 = (t30 * t89) - (t18 * t396);
    const float t450 = t344 * t449;
    const float t454 = (t85 * t396) + (t30 * t83);
    const float t455 = t344 * t454;
    const float t457 = t30 * t345;
    const float t459 = t30 * t401;
    const float t461 = t92 * t344;
    const float t468 = t344 * ((t40 * t449) + (t67 * t454) + (t92 * t382));
    const float t469 = t344 * t468;
    const float t474 = (cos_phi * ((t345 * t399) + (t48 * t404))) + (t119 * t443) + (t158 * t445) +
        (t200 * t455);
    const float t479 = t474 + (t180 * t457) + (t204 * t459) + (t378 * t461) + (t242 * t383) -
        (sin_phi * ((t210 * t401) + (t345 * t409) + (t404 * t411)));
    const float t482 = t479 - (t116 * t431) - (t175 * t450) - (t359 * t469);
    const float t485 = (speeds[2] * t362) + (speeds[0] * t389) + (speeds[1] * t482);
    const float t493 = (t60 * t306) + (t67 * t289) + (t40 * t311) - (t72 * t283);
    const float t495 = (t306 * t347) - (t350 * t493);
    const float t503 = (t306 * t370) + (t289 * t365) + (t311 * t373) - (t111 * t283);
    const float t508 = (t364 * t503) + (t313 * t383) - (t385 * t493);
    const float t510 = motion->constants[26] * t41;
    const float t512 = t248 * t126;
    const float t528 = (t404 * t510) + (t404 * t512) + (t252 * t443) + (t270 * t445) + (t306 *
        t455) + (t289 * t457);
    const float t533 = t528 + (t311 * t459) + (t461 * t503) + (t321 * t383) - (t250 * t431) -
        (t283 * t450);
    const float t534 = t533 - (t469 * t493);
    const float t537 = (speeds[2] * t495) + (speeds[0] * t508) + (speeds[1] * t534);
    const float t540 = motion->constants[28] + (t33 * motion->constants[22]);
    const float t541 = 1.0F / t540;
    const float t546 = (t67 * t111) - (t40 * t370);
    const float t550 = (t67 * t72) - (t40 * t60);
    const float t555 = t541 * ((t40 * t454) + (t468 * t550) - (t67 * t449) - (t92 * t546));
    const float t556 = t541 * t555;
    const float t557 = motion->constants[22] * t556;
    const float t558 = speeds[1] * t557;
    const float t565 = t541 * ((t6 * t40) + (t349 * t550));
    const float t566 = motion->constants[22] * t541;
    const float t567 = t565 * t566;
    const float t569 = t6 * t541;
    const float t571 = t349 * t541;
    const float t580 = (t60 * t175) + (t72 * t200) + (t67 * t204) - (t40 * t108) - (t40 * t180);
    const float t582 = t541 * t550;
    const float t587 = (t571 * t580) + (t362 * t582) - (t40 * t104 * t541) - (t158 * t567) - (t175 *
        t569);
    const float t592 = t541 * ((t384 * t550) - (t75 * t546));
    const float t593 = t566 * t592;
    const float t595 = t75 * t541;
    const float t605 = (cos_phi * (t550 - (motion->constants[25] * t373))) + (t175 * t370) + (t111 *
        t200) + (t204 * t365);
    const float t606 = t605 - (t180 * t373);
    const float t608 = t384 * t541;
    const float t610 = t541 * t546;
    const float t616 = (t580 * t608) + (t389 * t582) - (t158 * t593) - (t595 * t606) - (t208 *
        t610);
    const float t618 = speeds[1] * t541;
    const float t622 = (t18 * t67) + (t40 * t85);
    const float t636 = (t40 * t424) + (t428 * t622) - (t67 * t418);
    const float t642 = (t67 * t434) + (t440 * t622) - (t40 * t436);
    const float t644 = motion->constants[28] * t622;
    const float t648 = t30 * t40;
    const float t650 = t30 * t67;
    const float t658 = (cos_phi * ((t40 * t399) + (t48 * t622))) + (t119 * t642) + (t158 * t644) +
        (t180 * t648);
    const float t662 = t658 + (t468 * t580) + (t482 * t550) - (sin_phi * ((t40 * t409) + (t411 *
        t622) - (t67 * t210))) - (t116 * t636);
    const float t667 = t662 - (t175 * t454) - (t200 * t449) - (t204 * t650) - (t92 * t606) - (t242 *
        t546);
    const float t671 = (speeds[2] * t587) + (speeds[0] * t616) + (t618 * t667) - (t158 * t558);
    const float t681 = (t60 * t283) + (t72 * t306) + (t67 * t311) - (t40 * t289);
    const float t686 = (t571 * t681) + (t495 * t582) - (t270 * t567) - (t283 * t569);
    const float t695 = (t283 * t370) + (t111 * t306) + (t311 * t365) - (t289 * t373);
    const float t703 = (t608 * t681) + (t508 * t582) - (t270 * t593) - (t595 * t695) - (t313 *
        t610);
    const float t722 = (t510 * t622) + (t512 * t622) + (t252 * t642) + (t270 * t644) + (t289 *
        t648) + (t468 * t681);
    const float t727 = t722 + (t534 * t550) - (t250 * t636) - (t283 * t454) - (t306 * t449) -
        (t311 * t650);
    const float t729 = t727 - (t92 * t695) - (t321 * t546);
    const float t733 = (speeds[2] * t686) + (speeds[0] * t703) + (t618 * t729) - (t270 * t558);
    const float t737 = sin_delta * motion->constants[45];
    const float t738 = sin_delta * t737;
    const float t742 = motion->constants[35] + motion->constants[40] + motion->constants[47] - t738;
    const float t744 = cos_delta * motion->constants[38];
    const float t745 = motion->constants[23] * t744;
    const float t748 = t745 + t745 + motion->constants[50];
    const float t751 = motion->constants[36] + motion->constants[43];
    const float t752 = t748 + t751;
    const float t753 = t752 - t742;
    const float t754 = t18 * t18;
    const float t756 = t18 * t29;
    const float t758 = motion->constants[24] * t744;
    const float t762 = cos_delta * motion->constants[41];
    const float t763 = motion->constants[32] + t762;
    const float t766 = t763 - motion->constants[48] - t758 - motion->constants[49];
    const float t767 = t766 + t766;
    const float t769 = (t753 * t754) + (t756 * t767);
    const float t770 = sin_delta * motion->constants[38];
    const float t771 = t104 * t770;
    const float t773 = t104 * motion->constants[51];
    const float t776 = (t104 * t773) - t771 - t771;
    const float t781 = t744 + motion->constants[30];
    const float t782 = motion->constants[46] + t781;
    const float t784 = (t29 * motion->constants[52]) - (t18 * t782);
    const float t785 = t6 * t784;
    const float t786 = t6 * motion->constants[51];
    const float t787 = t6 * t786;
    const float t789 = t787 - t785 - t785;
    const float t790 = sin_delta * motion->constants[41];
    const float t792 = t790 - (motion->constants[24] * t770);
    const float t796 = (cos_delta * t737) - (motion->constants[23] * t770);
    const float t800 = (t18 * motion->constants[52]) + (t29 * t782);
    const float t803 = (t18 * t792) + (t29 * t796) + (t104 * t800);
    const float t805 = t75 - (sin_phi * t384);
    const float t812 = t766 + (t753 * t756) + (t6 * t800) - (t754 * t767);
    const float t813 = cos_phi * t384;
    const float t821 = t738 + motion->constants[47] + t748 + t789 + motion->constants[33] +
        motion->constants[42];
    const float t831 = (t29 * t792) + (t104 * t784) + (t6 * t770) - (t18 * t796) - (t6 * t773);
    const float t838 = t752 + t776 - t769;
    const float t844 = t805 * motion->constants[18];
    const float t850 = t592 + (cos_delta * t805) - t257 - (t124 * t813);
    const float t852 = t850 * motion->constants[19];
    const float t859 = t742 + t769 + t776 + t789 + (t803 * t805) + (t805 * (t803 + (t805 * t821) -
        (t813 * t831))) + (t805 * t844);
    const float t862 = t859 + (t850 * t852) - (t812 * t813) - (t813 * (t812 + (t805 * t831) -
        (t813 * t838)));
    const float t863 = 1.0F / t862;
    const float t868 = (speeds[0] * t384) + (speeds[1] * t468) + (speeds[2] * t349);
    const float t869 = cos_phi * t868;
    const float t871 = speeds[0] * t18;
    const float t872 = t871 - (t29 * t869);
    const float t873 = speeds[0] * t29;
    const float t875 = t873 + (t18 * t869);
    const float t877 = motion->constants[32] * t872;
    const float t878 = (motion->constants[35] * t875) + t877;
    const float t880 = motion->constants[32] * t875;
    const float t882 = t880 + (motion->constants[36] * t872);
    const float t884 = (t872 * t878) - (t875 * t882);
    const float t886 = motion->constants[25] * speeds[0];
    const float t887 = t869 * t886;
    const float t888 = sin_phi * t868;
    const float t889 = t94 - t888;
    const float t890 = motion->constants[24] * t889;
    const float t892 = motion->constants[23] * t889;
    const float t894 = (t872 * t890) + (t875 * t892);
    const float t895 = speeds[0] * t888;
    const float t897 = t94 * t875;
    const float t898 = (t29 * t895) + t897;
    const float t901 = t94 * t872;
    const float t902 = (t18 * t895) + t901;
    const float t904 = t95 * t869;
    const float t906 = motion->constants[25] * t888;
    const float t907 = t869 * t906;
    const float t908 = t907 - (t6 * t904);
    const float t911 = t894 + (motion->constants[23] * t898) + (motion->constants[24] * t902) -
        t908;
    const float t914 = motion->constants[23] * t872;
    const float t915 = motion->constants[24] * t875;
    const float t916 = t914 - t915;
    const float t918 = (t889 * t892) + (t872 * t916);
    const float t919 = speeds[0] * t869;
    const float t922 = speeds[0] * t95;
    const float t923 = t895 + t922;
    const float t926 = t887 + (t6 * t919) + (t104 * t923);
    const float t930 = t95 - t888;
    const float t932 = (t906 * t930) - (speeds[0] * t886);
    const float t933 = (t104 * t904) + t932;
    const float t937 = (t29 * t926) + (t18 * t933) - t918 - (motion->constants[24] * t919);
    const float t939 = speeds[1] + t872;
    const float t943 = (cos_delta * t889) - (sin_delta * t875);
    const float t944 = motion->constants[27] * t943;
    const float t948 = (cos_delta * t875) + (sin_delta * t889);
    const float t949 = motion->constants[26] * t943;
    const float t954 = speeds[1] * t943;
    const float t956 = t954 - (cos_delta * t902) - (sin_delta * t919);
    const float t958 = t35 * t540;
    const float t963 = (speeds[0] * t592) + (speeds[1] * t555) + (speeds[2] * t565);
    const float t965 = t898 + (t948 * t963);
    const float t967 = t37 * t540;
    const float t969 = t956 - (t939 * t963);
    const float t971 = t34 * t43;
    const float t974 = (t35 * t948) + (t37 * t939);
    const float t976 = motion->constants[28] * t971 * t974;
    const float t977 = t37 * t976;
    const float t979 = t35 * t976;
    const float t985 = (cos_delta * t911) + (t939 * t944) + (t948 * t949) + (motion->constants[26] *
        t898) + (t958 * t965) + (t939 * t977);
    const float t989 = t985 + (t948 * t979) - (sin_delta * t937) - (motion->constants[27] * t956) -
        (t967 * t969);
    const float t994 = motion->constants[26] * t939;
    const float t995 = motion->constants[27] * t948;
    const float t996 = t994 - t995;
    const float t1000 = speeds[1] * t948;
    const float t1002 = (sin_delta * t902) - (cos_delta * t919) - t1000;
    const float t1005 = t43 * motion->constants[22];
    const float t1007 = t943 + t963;
    const float t1012 = motion->constants[28] * ((t35 * t939) - (t37 * t948));
    const float t1018 = (cos_delta * t937) + (sin_delta * t911) + (motion->constants[27] * t1002) +
        (t967 * t1002) - (t943 * t949) - (t939 * t996);
    const float t1021 = t1018 - (t965 * t1005) - (t979 * t1007) - (t939 * t1012);
    const float t1025 = (t875 * t916) - (t889 * t890);
    const float t1040 = t1025 + (motion->constants[23] * t919) + (t18 * t926) + (t948 * t996) +
        (t969 * t1005) + (t948 * t1012);
    const float t1045 = t1040 - (t29 * t933) - (t943 * t944) - (motion->constants[26] * t1002) -
        (t958 * t1002) - (t977 * t1007);
    const float t1047 = (t35 * t1021) + (t37 * t1045);
    const float t1052 = t74 * ((t43 * t989) + (t33 * t1047));
    const float t1056 = t344 * ((t33 * t989) + (t382 * t1052) - (t43 * t1047));
    const float t1058 = t919 - t1052;
    const float t1059 = (sin_phi * t1056) + t1058;
    const float t1062 = cos_phi * motion->constants[44];
    const float t1063 = t933 + t1062;
    const float t1067 = t895 - (cos_phi * t1056);
    const float t1071 = (t6 * t1059) + t887 + (t104 * (t922 + t1067));
    const float t1073 = (t29 * t1063) - (t18 * t1071);
    const float t1076 = t1025 - t1073 + (motion->constants[23] * t1059);
    const float t1081 = t901 + (t18 * t1067);
    const float t1084 = (sin_delta * t1081) - (cos_delta * t1059) - t1000;
    const float t1086 = motion->constants[38] * t939;
    const float t1088 = t948 * motion->constants[39];
    const float t1089 = t1086 - t1088;
    const float t1091 = t943 * motion->constants[39];
    const float t1093 = (t948 * t1089) - (t943 * t1091);
    const float t1095 = (t1076 * motion->constants[37]) + t1093 - (motion->constants[38] * t1084);
    const float t1099 = motion->constants[30] * t872;
    const float t1100 = t875 * motion->constants[31];
    const float t1101 = t1099 - t1100;
    const float t1103 = motion->constants[31] * t889;
    const float t1105 = (t875 * t1101) - (t889 * t1103);
    const float t1108 = t1095 + t1105 - (t1073 * motion->constants[34]) + (motion->constants[30] *
        t1059);
    const float t1112 = (t18 * t1063) + (t29 * t1071);
    const float t1115 = t1112 - (motion->constants[24] * t1059) - t918;
    const float t1118 = t897 + (t29 * t1067);
    const float t1121 = sin_phi * motion->constants[44];
    const float t1122 = t908 + t1121;
    const float t1125 = t894 + (motion->constants[23] * t1118) + (motion->constants[24] * t1081) -
        t1122;
    const float t1127 = (cos_delta * t1115) + (sin_delta * t1125);
    const float t1130 = motion->constants[38] * t943;
    const float t1133 = (t943 * t1130) + (t939 * t1089);
    const float t1135 = (t1127 * motion->constants[37]) + (motion->constants[39] * t1084) - t1133;
    const float t1139 = (cos_delta * t1125) - (sin_delta * t1115);
    const float t1145 = t954 - (sin_delta * t1059) - (cos_delta * t1081);
    const float t1149 = (t939 * t1091) + (t948 * t1130);
    const float t1152 = (t1139 * motion->constants[37]) + (motion->constants[38] * t1118) + t1149 -
        (motion->constants[39] * t1145);
    const float t1154 = (cos_delta * t1135) - (sin_delta * t1152);
    const float t1157 = motion->constants[30] * t889;
    const float t1160 = (t889 * t1157) + (t872 * t1101);
    const float t1163 = t1154 + (t1112 * motion->constants[34]) - (motion->constants[31] * t1059) -
        t1160;
    const float t1165 = (t18 * t1108) + (t29 * t1163);
    const float t1167 = (motion->constants[18] * t1059) + (t6 * t1165);
    const float t1168 = sin_phi * t349;
    const float t1175 = motion->constants[41] * t948;
    const float t1177 = t1175 + (motion->constants[43] * t939);
    const float t1181 = (motion->constants[42] * t943) + (motion->constants[19] * t1007);
    const float t1183 = (t943 * t1177) - (t939 * t1181);
    const float t1186 = (motion->constants[40] * t1145) + (motion->constants[41] * t1118) + t1183 -
        (motion->constants[39] * t1139);
    const float t1198 = t541 * ((t35 * t1045) + (t550 * t1056) - (t37 * t1021) - (t546 * t1052));
    const float t1200 = motion->constants[19] * (t1084 + t1198);
    const float t1202 = motion->constants[41] * t939;
    const float t1203 = (motion->constants[40] * t948) + t1202;
    const float t1206 = (t939 * t1203) - (t948 * t1177);
    const float t1210 = (motion->constants[39] * t1127) + (motion->constants[42] * t1084) + t1200 +
        t1206 - (motion->constants[38] * t1076);
    const float t1218 = t884 + (motion->constants[31] * t1112) + (motion->constants[30] * t1073) -
        (motion->constants[33] * t1059) + (sin_delta * t1186) + (cos_delta * t1210);
    const float t1221 = t1218 + (motion->constants[24] * t1154) - t1167 - (motion->constants[23] *
        t1095);
    const float t1223 = cos_phi * t349;
    const float t1230 = (motion->constants[33] * t889) + (motion->constants[18] * (speeds[2] +
        t889));
    const float t1233 = (t875 * t1230) - (t878 * t889);
    const float t1239 = (t948 * t1181) - (t943 * t1203);
    const float t1242 = (motion->constants[38] * t1139) + (motion->constants[41] * t1145) +
        (motion->constants[43] * t1118) + t1239;
    const float t1245 = (sin_delta * t1135) + (cos_delta * t1152);
    const float t1251 = (motion->constants[36] * t1118) + t1233 + t1242 + (motion->constants[23] *
        t1245) - (motion->constants[30] * t1122) - (motion->constants[32] * t1081);
    const float t1258 = (t882 * t889) - (t872 * t1230);
    const float t1266 = (motion->constants[31] * t1122) + (motion->constants[32] * t1118) + t1258 +
        (cos_delta * t1186) - (motion->constants[35] * t1081) - (sin_delta * t1210);
    const float t1267 = t1266 - (motion->constants[24] * t1245);
    const float t1271 = (t29 * t1251) + (t104 * t1165) - (t18 * t1267);
    const float t1286 = (t872 * t1103) + (t875 * t1157);
    const float t1291 = t6 * (t1245 + (motion->constants[30] * t1118) + (motion->constants[31] *
        t1081) + t1286 - (t1122 * motion->constants[34]));
    const float t1297 = forces[0] + (t104 * ((t29 * t1108) - (t18 * t1163))) + (t813 * t1271) -
        (t18 * t1251);
    const float t1301 = t1297 - (t29 * t1267) - t1291 - (t805 * t1221) - (t592 * t1200);
    const float t1305 = t6 * (t784 - t786);
    const float t1309 = t1305 + (t821 * t1168) + (t831 * t1223);
    const float t1312 = t6 * (t770 - t773);
    const float t1316 = t1312 - (t831 * t1168) - (t838 * t1223);
    const float t1318 = 1.0F - t1168;
    const float t1323 = (t124 * t1223) + (cos_delta * t1168) - t565;
    const float t1329 = (t844 * t1318) - (t803 * t1168) - (t812 * t1223) - (t805 * t1309) - (t813 *
        t1316) - (t852 * t1323);
    const float t1330 = t863 * t1329;
    const float t1332 = t29 * t770;
    const float t1333 = t6 * t1332;
    const float t1334 = sin_phi * t468;
    const float t1335 = t92 - t1334;
    const float t1337 = cos_phi * t468;
    const float t1339 = t792 + t1333;
    const float t1341 = t745 + motion->constants[43];
    const float t1343 = t762 - t758;
    const float t1347 = (t29 * t1341) - (t18 * t1343) - (t104 * t1332);
    const float t1349 = motion->constants[18] * t1335;
    const float t1354 = (t124 * t1337) - t555 - (cos_delta * t1335);
    const float t1355 = motion->constants[19] * t1354;
    const float t1359 = t18 * t770;
    const float t1367 = t1339 + (t821 * t1335) - (t831 * t1337);
    const float t1372 = t1347 + (t831 * t1335) - (t838 * t1337);
    const float t1380 = (t18 * t1341) + (t29 * t1343) + (t6 * t744) + (t803 * t1335) + (t805 *
        t1367) + (t844 * t1335);
    const float t1385 = t863 * (t1380 - (t104 * t1359) - (t812 * t1337) - (t813 * t1372) - (t852 *
        t1354));
    const float t1386 = t862 * t1385;
    const float t1392 = t1333 + (t1318 * t1349) + (t1323 * t1355) - (t1309 * t1335) - (t1316 *
        t1337) - (t1168 * t1339);
    const float t1406 = motion->constants[43] + (t1335 * t1367) + (t1335 * t1339) + (t1335 *
        t1349) + (t1354 * t1355) - (t1337 * t1372);
    const float t1408 = t1406 - (t1337 * t1347) - (t1385 * t1386);
    const float t1409 = 1.0F / t1408;
    const float t1410 = (t1392 - (t1223 * t1347) - (t1330 * t1386)) * t1409;
    const float t1420 = forces[1] + (t1271 * t1337) - t1242 - (t1221 * t1335) - (t555 * t1200) -
        (t1301 * t1385);
    const float t1426 = (t1168 * t1221) + (t1223 * t1271) + t1167 - (t565 * t1200) - (t1301 *
        t1330) - (t1410 * t1420);
    const float t1433 = motion->constants[19] * t1323;
    const float t1443 = t787 + (t1168 * t1309) + (t1168 * t1305) + (motion->constants[18] * t1318 *
        t1318) + (t1323 * t1433) - (t1223 * t1316);
    const float t1447 = 1.0F / (t1443 - (t1223 * t1312) - (t862 * t1330 * t1330) - (t1408 * t1410 *
        t1410));
    const float t1448 = t1426 * t1447;
    const float t1452 = (t1409 * t1420) - (t1410 * t1448);
    const float t1456 = (t863 * t1301) - (t1385 * t1452) - (t1330 * t1448);
    const float t1464 = t1056 + (t384 * t1456) + (t468 * t1452) + (t349 * t1448);
    const float t1465 = sin_phi * t1464;
    const float t1468 = (t75 * t1456) + (t92 * t1452) - t1465 - t1058;
    const float t1469 = t1448 + t1468;
    const float t1471 = cos_phi * t1464;
    const float t1472 = t895 - t1471;
    const float t1473 = t922 + t1472;
    const float t1476 = (t6 * t1469) - t887 - (t104 * t1473);
    const float t1478 = t904 + t1456;
    const float t1481 = t932 + t1062 + (t104 * t1478);
    const float t1483 = (t18 * t1481) - (t29 * t1476);
    const float t1487 = (t29 * t1481) + (t18 * t1476);
    const float t1494 = t897 + (t29 * t1472) + (t18 * t1456);
    const float t1499 = (t29 * t1456) - t901 - (t18 * t1472);
    const float t1503 = t907 + t1121 - (t6 * t1478);
    const float t1506 = t894 + (motion->constants[23] * t1494) - (motion->constants[24] * t1499) -
        t1503;
    const float t1510 = t1483 + (motion->constants[24] * t1468) - t918;
    const float t1512 = (cos_delta * t1506) - (sin_delta * t1510);
    const float t1516 = (cos_delta * t1499) + (sin_delta * t1468);
    const float t1517 = t954 + t1516;
    const float t1519 = t1452 + t1494;
    const float t1523 = t1183 + (motion->constants[40] * t1517) + (motion->constants[41] * t1519) -
        (motion->constants[39] * t1512);
    const float t1527 = (cos_delta * t1510) + (sin_delta * t1506);
    const float t1531 = t1025 - t1487 - (motion->constants[23] * t1468);
    const float t1535 = (cos_delta * t1468) - (sin_delta * t1499);
    const float t1536 = t1535 - t1000;
    const float t1545 = motion->constants[19] * (t1198 + t1536 + (t592 * t1456) + (t555 * t1452) +
        (t565 * t1448));
    const float t1549 = t1206 + (motion->constants[39] * t1527) + (motion->constants[42] * t1536) +
        t1545 - (motion->constants[38] * t1531);
    const float t1551 = (sin_delta * t1523) + (cos_delta * t1549);
    const float t1555 = (motion->constants[37] * t1527) + (motion->constants[39] * t1536) - t1133;
    const float t1562 = t1149 + (motion->constants[37] * t1512) + (motion->constants[38] * t1519) -
        (motion->constants[39] * t1517);
    const float t1564 = (cos_delta * t1555) - (sin_delta * t1562);
    const float t1569 = t1093 + (motion->constants[37] * t1531) - (motion->constants[38] * t1536);
    const float t1575 = t1105 + t1569 - (motion->constants[34] * t1487) - (motion->constants[30] *
        t1468);
    const float t1581 = t1564 + (motion->constants[34] * t1483) + (motion->constants[31] * t1468) -
        t1160;
    const float t1583 = (t18 * t1575) + (t29 * t1581);
    const float t1589 = t884 + (motion->constants[31] * t1483) + (motion->constants[30] * t1487) +
        (motion->constants[33] * t1468) + (motion->constants[18] * t1469) + t1551;
    const float t1592 = t1589 + (motion->constants[24] * t1564) - (motion->constants[23] * t1569) -
        (t6 * t1583);
    const float t1608 = (sin_delta * t1555) + (cos_delta * t1562);
    const float t1615 = t1233 + t1239 + (motion->constants[32] * t1499) + (motion->constants[36] *
        t1494) + (motion->constants[38] * t1512) + (motion->constants[41] * t1517) +
        (motion->constants[43] * t1519);
    const float t1617 = t1615 + (motion->constants[23] * t1608) - (motion->constants[30] * t1503);
    const float t1624 = (cos_delta * t1523) - (sin_delta * t1549);
    const float t1630 = t1258 + (motion->constants[31] * t1503) + (motion->constants[35] * t1499) +
        (motion->constants[32] * t1494) + t1624 - (motion->constants[24] * t1608);
    const float t1634 = (t29 * t1617) + (t104 * t1583) - (t18 * t1630);
    const float t1644 = (t384 * t1634) - (motion->constants[21] * (t1286 + t1608 +
        (motion->constants[30] * t1494) - (motion->constants[34] * t1503) - (motion->constants[31] *
        t1499)));
    const float t1647 = (t104 * t1575) - t1630;
    const float t1650 = t1617 + (t104 * t1581);
    const float t1655 = (sin_phi * t1592) + (cos_phi * t1634);
    const float t1658 = motion->constants[21] * t1583;
    const float t1663 = (cos_phi * t1658) - (t116 * t1617) - (t119 * t1630);
    const float t1665 = sin_phi * t1658;
    const float t1669 = (t119 * t1575) - (t116 * t1581);
    const float t1672 = (t104 * t813) + (t6 * t805);
    const float t1674 = t344 * t1047;
    const float t1675 = t541 * motion->constants[19];
    const float t1676 = t550 * t1675;
    const float t1677 = t1674 * t1676;
    const float t1680 = motion->constants[19] * t1452;
    const float t1684 = t344 * t989;
    const float t1686 = (t1676 * t1684) - (motion->constants[22] * ((t1198 * t1675) + (t556 *
        t1680)));
    const float t1689 = t43 * t344;
    const float t1690 = t1021 * t1689;
    const float t1692 = (t1045 * t1675) - (t1676 * t1690);
    const float t1695 = t1045 * t1689;
    const float t1697 = (t1021 * t1675) + (t1676 * t1695);
    const float t1699 = t1052 * t1675;
    const float t1701 = t344 * t1052;
    const float t1702 = t1676 * t1701;
    const float t1704 = t1056 * t1675;
    const float t1706 = t344 * t1056;
    const float t1707 = t1676 * t1706;
    const float t1709 = motion->constants[19] * t1448;
    const float t1711 = motion->constants[19] * t1456;
    const float t1713 = t541 * t1680;
    const float t1719 = (t158 * t1686) + (t162 * t1692) + (t171 * t1697) + (t378 * t1702) + (t580 *
        t1704) + (t587 * t1709);
    const float t1724 = t1719 + (t616 * t1711) + (t667 * t1713) - (t129 * t1677) - (t606 * t1699) -
        (t359 * t1707);
    const float t1726 = motion->constants[21] * t1478;
    const float t1729 = (motion->constants[25] * t930) - t906;
    const float t1730 = t18 * t1729;
    const float t1734 = (motion->constants[21] * t1473) + (t6 * t1464);
    const float t1740 = t18 * t105;
    const float t1744 = t886 + (t6 * speeds[0]);
    const float t1746 = (motion->constants[21] * t1469) - (t868 * t1744);
    const float t1753 = t6 * t1456;
    const float t1754 = t29 * t1753;
    const float t1756 = t6 * t1452;
    const float t1757 = t29 * t1756;
    const float t1760 = (cos_phi * ((t18 * t1726) + (t868 * t1730) + (t29 * t1734))) + (t116 *
        t1476) + (t119 * t1481);
    const float t1762 = t1760 - (sin_phi * ((t18 * motion->constants[44]) + (t868 * t1740) - (t29 *
        t1746))) - (t208 * t1754);
    const float t1763 = t1762 - (t242 * t1757);
    const float t1764 = t18 * t104;
    const float t1767 = t29 * motion->constants[34];
    const float t1769 = cos_delta * motion->constants[39];
    const float t1770 = sin_delta * t1769;
    const float t1772 = cos_delta * motion->constants[37];
    const float t1773 = sin_delta * t1772;
    const float t1774 = t81 - t6;
    const float t1778 = (t18 * t1770) + (t88 * t1773);
    const float t1780 = cos_delta * t1769;
    const float t1782 = cos_delta * t1772;
    const float t1786 = (t29 * t1672) - t1764 - (motion->constants[24] * t805);
    const float t1795 = (t29 * motion->constants[38]) + (t18 * t1769) + (t88 * t1772);
    const float t1797 = sin_delta * motion->constants[39];
    const float t1799 = sin_delta * motion->constants[37];
    const float t1805 = (t29 * t1769) + (t1772 * t1774) + (t813 * t1795) + (t805 * t1797) - (t18 *
        motion->constants[38]) - (t1786 * t1799);
    const float t1811 = (t29 * t1770) + (t1773 * t1774) + (t813 * t1778) + (t1782 * t1786) - (t805 *
        t1780) - (sin_delta * t1805);
    const float t1814 = (t1672 * t1767) + t1811 - (motion->constants[34] * t1764) - (t805 *
        motion->constants[31]);
    const float t1817 = t29 * t1729;
    const float t1824 = t29 * t105;
    const float t1832 = t18 * t1753;
    const float t1834 = t18 * t1756;
    const float t1837 = (cos_phi * ((t29 * t1726) + (t868 * t1817) - (t18 * t1734))) + (t119 *
        t1476) + (t208 * t1832);
    const float t1840 = t1837 + (t242 * t1834) - (sin_phi * ((t29 * motion->constants[44]) + (t868 *
        t1824) + (t18 * t1746))) - (t116 * t1481);
    const float t1841 = t29 * t104;
    const float t1845 = t18 * motion->constants[34];
    const float t1850 = t1841 + (motion->constants[23] * t805) + (t18 * t1672);
    const float t1856 = t1332 + (t813 * t1359) - (motion->constants[34] * t1841) - (t781 * t805) -
        (t1672 * t1845) - (motion->constants[37] * t1850);
    const float t1858 = motion->constants[25] * t869;
    const float t1859 = t868 * t1858;
    const float t1862 = t96 - t906;
    const float t1866 = (cos_phi * (motion->constants[44] + t1859)) + (sin_phi * (t1726 + (t868 *
        t1862)));
    const float t1870 = (t29 * motion->constants[30]) + (t18 * motion->constants[31]);
    const float t1872 = sin_delta * t1797;
    const float t1874 = sin_delta * t1799;
    const float t1878 = (t18 * t1872) + (t88 * t1874);
    const float t1880 = cos_delta * t1797;
    const float t1882 = cos_delta * t1799;
    const float t1889 = (t29 * t1872) + (t1774 * t1874) + (t813 * t1878) + (t1786 * t1882) +
        (cos_delta * t1805) - (t805 * t1880);
    const float t1892 = (t29 * motion->constants[31]) - (t18 * motion->constants[30]);
    const float t1895 = (t6 * motion->constants[34]) - (t813 * t1870) - t1889 - t1892;
    const float t1899 = (t119 * t1456) - (t116 * t1472);
    const float t1908 = (t29 * t751) + (t88 * t744) - (t18 * t763);
    const float t1917 = (t744 * t1774) + (t813 * t1908) + (motion->constants[23] * t1889) - (t6 *
        motion->constants[30]) - (t18 * t751) - (t29 * t763);
    const float t1919 = t1917 - (t790 * t805) - (t770 * t1786);
    const float t1921 = speeds[0] * t868;
    const float t1927 = (sin_phi * t1921) + (t208 * t1456) + (t242 * t1452) - t1471;
    const float t1930 = motion->constants[23] * motion->constants[38];
    const float t1931 = sin_delta * t1930;
    const float t1933 = t18 * t1931;
    const float t1935 = motion->constants[33] + motion->constants[18];
    const float t1937 = t1935 + (cos_delta * t1930);
    const float t1942 = sin_delta * motion->constants[42];
    const float t1947 = (t18 * t1942) + (t88 * t1797);
    const float t1949 = cos_delta * motion->constants[42];
    const float t1957 = (t29 * t1942) + (t1774 * t1797) + (t813 * t1947) + (t1769 * t1786) - t852 -
        (t805 * t1949);
    const float t1958 = t1957 - (motion->constants[38] * t1850);
    const float t1961 = cos_delta * motion->constants[40];
    const float t1968 = (t29 * motion->constants[41]) - (t18 * t1961) - (t88 * t1769);
    const float t1970 = sin_delta * motion->constants[40];
    const float t1977 = (t813 * t1968) + (t1786 * t1797) - (t18 * motion->constants[41]) - (t29 *
        t1961) - (t1769 * t1774) - (t805 * t1970);
    const float t1983 = (t29 * t1931) + (t813 * t1933) + (t1672 * t1892) + (motion->constants[24] *
        t1811) + (cos_delta * t1958) + (sin_delta * t1977);
    const float t1987 = t1983 - (motion->constants[31] * t1764) - (motion->constants[30] * t1841) -
        (t805 * t1937) - (motion->constants[46] * t1850);
    const float t1991 = (t116 * t1456) + (t119 * t1472);
    const float t1997 = (t29 * motion->constants[32]) - (t18 * motion->constants[35]);
    const float t2006 = (t6 * motion->constants[31]) + (t813 * t1997) + (cos_delta * t1977) - (t18 *
        motion->constants[32]) - (t29 * motion->constants[35]) - (motion->constants[24] * t1889);
    const float t2007 = t2006 - (sin_delta * t1958);
    const float t2010 = t1465 + (cos_phi * t1921);
    const float t2017 = (t1814 * t1841) + (t29 * t1919) - (t1764 * t1856) - (t18 * t2007);
    const float t2032 = (t158 * t1684) + (t171 * t1695) + (t378 * t1701) + (t362 * t1448) + (t389 *
        t1456) + (t482 * t1452);
    const float t2035 = t2032 - (t129 * t1674) - (t162 * t1690) - (t359 * t1706);
    const float t2036 = t6 * sin_phi;
    const float t2037 = t29 * t2036;
    const float t2039 = t18 * t2036;
    const float t2045 = (t1814 * t2037) - (t1856 * t2039) - (sin_phi * t1987) - (cos_phi * t2017);
    const float t2047 = t74 * t1052;
    const float t2049 = t74 * t989;
    const float t2051 = t74 * t1047;
    const float t2053 = t33 * t74;
    const float t2054 = t1021 * t2053;
    const float t2056 = t1045 * t2053;
    const float t2058 = cos_phi * t2047;
    const float t2064 = (t111 * t2047) + (t129 * t2049) + (t158 * t2051) + (t162 * t2054) - (t171 *
        t2056) - (t204 * t2058);
    const float t2067 = (t383 * t1676) - (t546 * t1675);
    const float t2069 = t6 * t29;
    const float t2071 = t6 * t18;
    const float t2077 = t1987 + (t1856 * t2071) + (t383 * t2045) - (t850 * t2067) - (t1814 * t2069);
    const float t2079 = motion->constants[21] * t904;
    const float t2081 = motion->constants[21] * t923;
    const float t2083 = speeds[0] * t104;
    const float t2084 = t18 * t2083;
    const float t2085 = t2084 - t1817;
    const float t2090 = motion->constants[21] * t919;
    const float t2093 = motion->constants[23] + t2071;
    const float t2095 = sin_delta * t1005;
    const float t2097 = motion->constants[26] + t958;
    const float t2098 = speeds[0] * cos_delta;
    const float t2103 = (t18 * t886) + (speeds[0] * t2093) + (t2097 * t2098) - t1824 - (speeds[0] *
        t2095);
    const float t2109 = motion->constants[22] * t969;
    const float t2111 = motion->constants[22] * t1002;
    const float t2112 = t35 * t2111;
    const float t2114 = t540 * t1002;
    const float t2115 = motion->constants[28] * t948;
    const float t2117 = (t939 * t2115) - t2114;
    const float t2119 = t976 * t1007;
    const float t2121 = t2119 + (t948 * t2115);
    const float t2124 = (cos_phi * ((t18 * t2081) + (t868 * t2085) - (t29 * t2079))) + (t116 *
        t933) + (t119 * t926);
    const float t2129 = t2124 + (t129 * t2109) + (t162 * t2117) + (t171 * t2121) - (sin_phi *
        ((t18 * t2090) + (t868 * t2103))) - (t158 * t2112);
    const float t2131 = t37 * t1689;
    const float t2133 = (t35 * t1675) - (t1676 * t2131);
    const float t2136 = t37 * t2053;
    const float t2139 = (t2077 * t2136) - (t850 * t2133) - (t2045 * t2131);
    const float t2142 = t868 * t873;
    const float t2144 = t2097 + (cos_delta * motion->constants[23]);
    const float t2148 = t29 * t2083;
    const float t2149 = t1730 + t2148;
    const float t2152 = (t18 * t2079) + (t29 * t2081) + (t868 * t2149);
    const float t2158 = motion->constants[27] + t967;
    const float t2159 = sin_delta * t2158;
    const float t2162 = (speeds[0] * t2159) + (cos_delta * t1862);
    const float t2166 = t2069 - motion->constants[24];
    const float t2169 = t1740 + (t29 * t886) + (speeds[0] * t2166);
    const float t2171 = (t29 * t2090) + (t868 * t2169);
    const float t2178 = (t895 * t2144) - (sin_delta * t926);
    const float t2180 = sin_delta * t933;
    const float t2185 = motion->constants[22] * ((t35 * t965) - (t37 * t969));
    const float t2189 = (t540 * t965) + (t948 * t976);
    const float t2193 = (t939 * t976) - (t540 * t969);
    const float t2196 = (cos_phi * ((t2142 * t2144) - (cos_delta * t1859) - (sin_delta * t2152))) +
        (t158 * t2185) + (t162 * t2189);
    const float t2198 = t2196 - (sin_phi * ((cos_delta * t2079) + (t868 * t2162) - (sin_delta *
        t2171))) - (t116 * t2178);
    const float t2200 = t2198 - (t119 * t2180) - (t171 * t2193);
    const float t2201 = t33 * t344;
    const float t2202 = t1676 * t2201;
    const float t2205 = t43 * t74;
    const float t2208 = (t2045 * t2201) + (t2077 * t2205) - (t850 * t2202);
    const float t2212 = (sin_delta * motion->constants[23]) - t1005;
    const float t2221 = (sin_delta * t1862) - (t2098 * t2158);
    const float t2229 = (t895 * t2212) + (cos_delta * t926);
    const float t2231 = cos_delta * t933;
    const float t2233 = motion->constants[22] * t965;
    const float t2235 = t37 * t2111;
    const float t2237 = motion->constants[28] * t939;
    const float t2239 = t2119 + (t939 * t2237);
    const float t2242 = t2114 + (t948 * t2237);
    const float t2245 = (cos_phi * ((t2142 * t2212) + (cos_delta * t2152) - (sin_delta * t1859))) +
        (t119 * t2231) + (t158 * t2235);
    const float t2247 = t2245 - (sin_phi * ((sin_delta * t2079) + (t868 * t2221) + (cos_delta *
        t2171))) - (t116 * t2229);
    const float t2250 = t2247 - (t129 * t2233) - (t162 * t2239) - (t171 * t2242);
    const float t2252 = t35 * t1689;
    const float t2254 = (t37 * t1675) + (t1676 * t2252);
    const float t2257 = t35 * t2053;
    const float t2260 = (t850 * t2254) + (t2077 * t2257) - (t2045 * t2252);
    const float t2262 = t34 * t974;
    const float t2264 = t971 * t2262;
    const float t2266 = t948 * t971;
    const float t2268 = t939 * t971;
    const float t2272 = (t129 * t2262) + (t162 * t2266) - (t158 * t2264) - (t171 * t2268);
    const float t2273 = t37 * motion->constants[28];
    const float t2274 = t1007 * t2273;
    const float t2277 = t35 * motion->constants[28];
    const float t2279 = (t939 * t2273) + (t948 * t2277);
    const float t2281 = t1007 * t2277;
    const float t2284 = (t2208 * t2279) - (t2139 * t2274) - (t2260 * t2281);
    const float t2288 = (t869 * t871) + (t119 * t895);
    const float t2291 = (cos_delta * t1005) + (sin_delta * t2097);
    const float t2295 = (cos_delta * t2158) + (cos_delta * motion->constants[24]);
    const float t2298 = t2159 + (sin_delta * motion->constants[24]);
    const float t2301 = (t2208 * t2295) + (t2260 * t2298) - (t2139 * t2291);
    const float t2303 = t872 * motion->constants[31];
    const float t2304 = motion->constants[30] * t875;
    const float t2307 = t1157 + t1157;
    const float t2309 = t1103 + t1103;
    const float t2312 = (t875 * t1935) - t878;
    const float t2315 = t890 + t890;
    const float t2316 = motion->constants[38] * t2315;
    const float t2319 = t882 - (t872 * t1935) - (sin_delta * t2316);
    const float t2323 = (t29 * t2312) - (t18 * t2319);
    const float t2325 = cos_delta * t2316;
    const float t2329 = (t29 * t2307) + (t18 * t2309);
    const float t2331 = motion->constants[37] * t2315;
    const float t2333 = motion->constants[24] * t872;
    const float t2334 = motion->constants[23] * t875;
    const float t2335 = t2333 + t2334;
    const float t2337 = t892 + t892;
    const float t2342 = (cos_delta * t2335) + (sin_delta * t2337);
    const float t2346 = (sin_delta * t2335) - (cos_delta * t2337);
    const float t2349 = motion->constants[19] * t948;
    const float t2351 = (motion->constants[42] * t948) + t2349 - t1203;
    const float t2354 = motion->constants[19] * t939;
    const float t2356 = t1177 - (motion->constants[42] * t939) - t2354;
    const float t2357 = cos_delta * t2356;
    const float t2359 = t939 * motion->constants[39];
    const float t2360 = motion->constants[38] * t948;
    const float t2361 = t2359 + t2360;
    const float t2363 = t1130 + t1130;
    const float t2365 = (cos_delta * t2361) - (sin_delta * t2363);
    const float t2371 = (t29 * t2351) + (t88 * t2365) - (t18 * t2357);
    const float t2373 = sin_delta * t2356;
    const float t2377 = (sin_delta * t2361) + (cos_delta * t2363);
    const float t2379 = t1091 + t1091;
    const float t2383 = t944 + t977;
    const float t2385 = (speeds[1] * t1005) - t944 - t2383;
    const float t2387 = motion->constants[26] * t948;
    const float t2390 = (t939 * motion->constants[27]) - (speeds[1] * t2158);
    const float t2391 = t2387 + t2390;
    const float t2393 = t949 + t979;
    const float t2394 = t949 + t2393;
    const float t2400 = (t1774 * t2365) + (t813 * t2371) + (speeds[1] * t1977) + (t2139 * t2385) +
        (t2208 * t2391) - (t18 * t2351);
    const float t2405 = t2400 - (t29 * t2357) - (t805 * t2373) - (t1786 * t2377) - (t1850 * t2379) -
        (t2260 * t2394);
    const float t2408 = t1181 - (motion->constants[40] * t943);
    const float t2410 = motion->constants[41] * t943;
    const float t2414 = (motion->constants[40] * t939) - t1175 - t1177;
    const float t2416 = (cos_delta * t2410) - (sin_delta * t2414);
    const float t2420 = (cos_delta * t1130) + (sin_delta * t2359);
    const float t2426 = (t29 * t2408) + (t88 * t2420) - (t18 * t2416);
    const float t2430 = (sin_delta * t2410) + (cos_delta * t2414);
    const float t2434 = (cos_delta * t2359) - (sin_delta * t1130);
    const float t2436 = t1089 - t1088;
    const float t2441 = t996 + t1012;
    const float t2444 = (speeds[1] * t2097) + t2441 - t995 - (t37 * t2115);
    const float t2447 = t2393 + (t958 * t963);
    const float t2449 = t963 * t1005;
    const float t2452 = t2390 + (t37 * t2237) - t2449;
    const float t2454 = t35 * t971;
    const float t2460 = (t1774 * t2420) + (t813 * t2426) + (t1786 * t2434) + (t1850 * t2436) +
        (t2139 * t2444) + (t2208 * t2447);
    const float t2465 = t2460 + (t2260 * t2452) + (t2284 * t2454) - (t18 * t2408) - (t29 * t2416) -
        (t805 * t2430);
    const float t2466 = t2465 - (speeds[1] * t1958);
    const float t2472 = (t1764 * t2307) + (t813 * t2323) + (t1889 * t2335) + (t2208 * t2342) +
        (t2260 * t2346) + (cos_delta * t2405);
    const float t2477 = t2472 + (sin_delta * t2466) - (t6 * (t2303 + t2304)) - (t1841 * t2309) -
        (t18 * t2312) - (t29 * t2319);
    const float t2482 = t2477 - (t805 * t2325) - (t1672 * t2329) - (t1850 * t2331) - (t1811 *
        t2337) - (t2139 * t2315);
    const float t2484 = t18 * t888;
    const float t2488 = (t119 * t869) - t2484 - (speeds[0] * t116);
    const float t2491 = t1101 - t1100;
    const float t2494 = t1230 - (motion->constants[35] * t889);
    const float t2496 = motion->constants[32] * t889;
    const float t2497 = t916 - t915;
    const float t2498 = motion->constants[38] * t2497;
    const float t2500 = t2496 + (sin_delta * t2498);
    const float t2504 = (t29 * t2494) - (t18 * t2500);
    const float t2510 = (motion->constants[35] * t872) - t880 - t882 - (cos_delta * t2498);
    const float t2514 = (t29 * t2303) + (t18 * t2491);
    const float t2516 = motion->constants[37] * t2497;
    const float t2526 = (cos_delta * t892) + (t94 * t2144) - (sin_delta * t2333);
    const float t2532 = (sin_delta * t892) + (t94 * t2212) + (cos_delta * t2333);
    const float t2540 = (t1841 * t2491) + (t813 * t2504) + (t1672 * t2514) + (t1850 * t2516) +
        (t892 * t1889) + (t1811 * t2333);
    const float t2545 = t2540 + (t94 * t1919) + (t2139 * t2497) + (t2208 * t2526) + (t2260 *
        t2532) + (cos_delta * t2466);
    const float t2550 = t2545 - (t6 * t1157) - (t1764 * t2303) - (t18 * t2494) - (t29 * t2500) -
        (t805 * t2510);
    const float t2551 = t2550 - (sin_delta * t2405);
    const float t2557 = (t85 * t868) + (t116 * t869) + (speeds[0] * t119);
    const float t2559 = t1099 + t1101;
    const float t2562 = t2410 + t2496;
    const float t2566 = (motion->constants[43] * t943) - t1181;
    const float t2567 = cos_delta * t2566;
    const float t2570 = t1202 + t1203 - (motion->constants[43] * t948);
    const float t2572 = t2570 - (motion->constants[38] * t2334);
    const float t2576 = (motion->constants[36] * t889) + t2567 - t1230 - (sin_delta * t2572);
    const float t2581 = t1086 + t1089;
    const float t2583 = (cos_delta * t1091) - (sin_delta * t2581);
    const float t2584 = t88 * t2583;
    const float t2586 = t2584 - (t29 * t2562) - (t18 * t2576);
    const float t2589 = sin_delta * t2566;
    const float t2594 = t877 + t878 + t2589 + (cos_delta * t2572) - (motion->constants[36] * t875);
    const float t2598 = (t18 * t2304) - (t29 * t2559);
    const float t2601 = t2360 + (motion->constants[37] * t2334);
    const float t2604 = t914 + t916;
    const float t2609 = t2387 + (t35 * t2115) - t2449;
    const float t2610 = t2334 + t2609;
    const float t2614 = t2383 + (t963 * t967);
    const float t2617 = (cos_delta * t890) + t2614 + (sin_delta * t2604);
    const float t2622 = t994 + t2441 + (t35 * t2237);
    const float t2625 = (sin_delta * t890) - t2622 - (cos_delta * t2604);
    const float t2628 = t37 * t971;
    const float t2633 = (sin_delta * t1091) + (cos_delta * t2581);
    const float t2636 = (t2284 * t2628) + (t1774 * t2583) - (t1786 * t2633);
    const float t2641 = (t1764 * t2559) + (t1841 * t2304) + (t18 * t2562) + (t813 * t2586) +
        (t1672 * t2598) + (t1850 * t2601);
    const float t2646 = t2641 + (t890 * t1889) + (t2139 * t2610) + (t2208 * t2617) + (t2260 *
        t2625) + (t94 * t2301);
    const float t2652 = t2646 + t2636 - (t6 * t1103) - (t29 * t2576) - (t805 * t2594) - (t1811 *
        t2604) - (t94 * t2007);
    const float t2655 = cos_delta * t2354;
    const float t2659 = (t29 * t2349) + (t18 * t2655);
    const float t2661 = sin_delta * t2354;
    const float t2664 = t977 + (t939 * t1005);
    const float t2668 = (t939 * t967) + (t948 * t958);
    const float t2671 = t979 + (t948 * t1005);
    const float t2677 = (t29 * t2655) + (t813 * t2659) + (t805 * t2661) + (t2208 * t2668) - (t18 *
        t2349) - (t2139 * t2664);
    const float t2678 = t2677 - (t2260 * t2671);
    const float t2683 = t6 * t869;
    const float t2686 = t906 + (t104 * t869);
    const float t2688 = t2148 + (t18 * t2686);
    const float t2690 = (cos_delta * t2683) - (sin_delta * t2688);
    const float t2691 = (t875 * t2144) + t2690;
    const float t2696 = (sin_delta * t2683) + (cos_delta * t2688);
    const float t2697 = (t875 * t2212) + t2696;
    const float t2702 = t2084 - (t29 * t2686);
    const float t2708 = (t1814 * t2688) + (t2139 * t2702) - (t1856 * t2702) - (t1895 * t2683);
    const float t2713 = t2482 + (t875 * t1919) + (t2208 * t2691) + (t2260 * t2697) + (t872 *
        t2301) + t2708;
    const float t2714 = t2713 - (t872 * t2007);
    const float t2718 = cos_phi * t1744;
    const float t2721 = (sin_phi * t1730) + (cos_phi * t1740) + (t29 * t2718);
    const float t2727 = (sin_phi * t1817) + (cos_phi * t1824) - (t18 * t2718);
    const float t2729 = sin_phi * t1858;
    const float t2731 = t2729 - (cos_phi * t1862);
    const float t2733 = cos_phi * speeds[0];
    const float t2735 = speeds[0] * sin_phi;
    const float t2739 = (sin_phi * t2085) + (cos_phi * t2103);
    const float t2742 = sin_phi * t873;
    const float t2747 = (sin_phi * t2149) + (cos_phi * t2169);
    const float t2751 = (t2144 * t2742) + (cos_phi * t2162) - (cos_delta * t2729) - (sin_delta *
        t2747);
    const float t2759 = (t2212 * t2742) + (cos_phi * t2221) + (cos_delta * t2747) - (sin_delta *
        t2729);
    const float t2761 = sin_phi * t871;
    const float t2770 = (t1814 * t2721) + (t1856 * t2727) + (t1895 * t2731) + (t2017 * t2735) +
        (t2139 * t2739) + (t2208 * t2751);
    const float t2775 = t2770 + (t2260 * t2759) + (t2301 * t2761) + (t21 * t2551) - (t1987 *
        t2733) - (sin_phi * t2482);
    const float t2776 = t2775 - (t30 * t2652);
    const float t2778 = (cos_phi * ((t384 * t1592) + (motion->constants[21] * ((t29 * t1575) -
        (t18 * t1581))))) + (t389 * t1655);
    const float t2783 = t2778 + (t813 * t1663) + (t1669 * t1672) + (t1763 * t1814) + (t1840 *
        t1856) + (t1866 * t1895);
    const float t2788 = t2783 + (t1899 * t1919) + (t1927 * t1987) + (t2010 * t2017) + (t2035 *
        t2045) + (t2064 * t2077);
    const float t2793 = t2788 + (t2129 * t2139) + (t2200 * t2208) + (t2250 * t2260) + (t2272 *
        t2284) + (t2288 * t2301);
    const float t2798 = t2793 + (t2488 * t2551) + (t2557 * t2652) + (t671 * t2678) + (t244 *
        t2714) + (t485 * t2776);
    const float t2803 = t2798 - (sin_phi * t1644) - (t116 * t1647) - (t119 * t1650) - (t208 *
        t1592) - (t616 * t1545);
    const float t2807 = t2803 - (t805 * t1665) - (t850 * t1724) - (t1991 * t2007) - (t869 * t2482);
    const float t2811 = t557 * t1545;
    const float t2815 = t541 * t1545;
    const float t2821 = (t104 * t1337) + (t6 * t1335);
    const float t2830 = (t29 * t2821) - (motion->constants[24] * t1335);
    const float t2837 = (t1337 * t1795) + (t1335 * t1797) - motion->constants[38] - (t1799 * t2830);
    const float t2841 = (t1337 * t1778) + (t1782 * t2830) - (t1335 * t1780) - (sin_delta * t2837);
    const float t2843 = (t1767 * t2821) + t2841 - (motion->constants[31] * t1335);
    const float t2850 = (motion->constants[23] * t1335) + (t18 * t2821);
    const float t2854 = (t1337 * t1359) - (t781 * t1335) - (t1845 * t2821) -
        (motion->constants[37] * t2850);
    const float t2863 = (t1337 * t1878) + (t1882 * t2830) + (cos_delta * t2837) - (t1335 * t1880);
    const float t2864 = (t1337 * t1870) + t2863;
    const float t2873 = (t1337 * t1908) + (motion->constants[23] * t2863) - motion->constants[43] -
        (t790 * t1335) - (t770 * t2830);
    const float t2887 = t1355 + (t1337 * t1947) + (t1769 * t2830) - (t1335 * t1949) -
        (motion->constants[38] * t2850);
    const float t2894 = (t1337 * t1968) + (t1797 * t2830) - motion->constants[41] - (t1335 * t1970);
    const float t2900 = (t1337 * t1933) + (t1892 * t2821) + (motion->constants[24] * t2841) +
        (cos_delta * t2887) + (sin_delta * t2894) - (t1335 * t1937);
    const float t2901 = t2900 - (motion->constants[46] * t2850);
    const float t2909 = (t1337 * t1997) + (cos_delta * t2894) - (motion->constants[24] * t2863) -
        (sin_delta * t2887);
    const float t2917 = (t1841 * t2843) + (t29 * t2873) - (t1764 * t2854) - (t18 * t2909);
    const float t2925 = (t2037 * t2843) - (t2039 * t2854) - (sin_phi * t2901) - (cos_phi * t2917);
    const float t2934 = t2901 + (t1354 * t2067) + (t2071 * t2854) + (t383 * t2925) - (t2069 *
        t2843);
    const float t2940 = (t1354 * t2133) + (t2136 * t2934) - (t2131 * t2925);
    const float t2946 = (t1354 * t2202) + (t2201 * t2925) + (t2205 * t2934);
    const float t2952 = (t2257 * t2934) - (t1354 * t2254) - (t2252 * t2925);
    const float t2958 = (t2279 * t2946) - (t2274 * t2940) - (t2281 * t2952);
    const float t2964 = (t2295 * t2946) + (t2298 * t2952) - (t2291 * t2940);
    const float t2987 = (t1337 * t2371) + (speeds[1] * t2894) + (t2385 * t2940) + (t2391 * t2946) -
        t2351 - (t1335 * t2373);
    const float t2990 = t2987 - (t2377 * t2830) - (t2379 * t2850) - (t2394 * t2952);
    const float t3005 = (t1337 * t2426) + (t2434 * t2830) + (t2436 * t2850) + (t2444 * t2940) +
        (t2447 * t2946) + (t2452 * t2952);
    const float t3009 = t3005 + (t2454 * t2958) - t2408 - (t1335 * t2430) - (speeds[1] * t2887);
    const float t3015 = (t1337 * t2323) + (t2335 * t2863) + (t2342 * t2946) + (t2346 * t2952) +
        (cos_delta * t2990) + (sin_delta * t3009);
    const float t3020 = t3015 - (t1335 * t2325) - (t2329 * t2821) - (t2331 * t2850) - (t2337 *
        t2841) - (t2315 * t2940);
    const float t3038 = (t1337 * t2504) + (t2514 * t2821) + (t2516 * t2850) + (t892 * t2863) +
        (t2333 * t2841) + (t94 * t2873);
    const float t3043 = t3038 + (t2497 * t2940) + (t2526 * t2946) + (t2532 * t2952) + (cos_delta *
        t3009) - (t1335 * t2510);
    const float t3044 = t3043 - (sin_delta * t2990);
    const float t3060 = t2410 + (t2628 * t2958) - (t2633 * t2830);
    const float t3065 = (t1337 * t2586) + (t2598 * t2821) + (t2601 * t2850) + (t890 * t2863) +
        (t2610 * t2940) + (t2617 * t2946);
    const float t3070 = t3065 + (t2625 * t2952) + (t94 * t2964) + t3060 - (t1335 * t2594) - (t2604 *
        t2841);
    const float t3071 = t3070 - (t94 * t2909);
    const float t3082 = (t1337 * t2659) + (t1335 * t2661) + (t2668 * t2946) - t2349 - (t2664 *
        t2940) - (t2671 * t2952);
    const float t3095 = (t2688 * t2843) + (t2683 * t2864) + (t2702 * t2940) - (t2702 * t2854);
    const float t3100 = t3020 + (t875 * t2873) + (t2691 * t2946) + (t2697 * t2952) + (t872 *
        t2964) + t3095;
    const float t3101 = t3100 - (t872 * t2909);
    const float t3119 = (t2721 * t2843) + (t2727 * t2854) + (t2735 * t2917) + (t2739 * t2940) +
        (t2751 * t2946) + (t2759 * t2952);
    const float t3124 = t3119 + (t2761 * t2964) + (t21 * t3044) - (t2731 * t2864) - (t2733 *
        t2901) - (sin_phi * t3020);
    const float t3125 = t3124 - (t30 * t3071);
    const float t3132 = (t1337 * t1592) + (t158 * t2811) + (t482 * t1655) + (t1337 * t1663) +
        (t1669 * t2821) + (t1354 * t1724);
    const float t3137 = t3132 + (t1763 * t2843) + (t1840 * t2854) + (t1899 * t2873) + (t1927 *
        t2901) + (t2010 * t2917);
    const float t3142 = t3137 + (t2035 * t2925) + (t2064 * t2934) + (t2129 * t2940) + (t2200 *
        t2946) + (t2250 * t2952);
    const float t3147 = t3142 + (t2272 * t2958) + (t2288 * t2964) + (t2488 * t3044) + (t2557 *
        t3071) + (t671 * t3082);
    const float t3152 = t3147 + (t244 * t3101) + (t485 * t3125) - (t1334 * t1634) - (t242 * t1592) -
        (t667 * t2815);
    const float t3157 = t3152 - (t1335 * t1665) - (t1866 * t2864) - (t1991 * t2909) - (t869 *
        t3020) - (t1385 * t2807);
    const float t3170 = t6 + (t104 * t1223) - (t6 * t1168);
    const float t3179 = (motion->constants[24] * t1168) + (t29 * t3170);
    const float t3185 = (t1223 * t1795) - (t1168 * t1797) - (t1799 * t3179);
    const float t3189 = (t1223 * t1778) + (t1168 * t1780) + (t1782 * t3179) - (sin_delta * t3185);
    const float t3191 = (motion->constants[31] * t1168) + (t1767 * t3170) + t3189;
    const float t3198 = (t18 * t3170) - (motion->constants[23] * t1168);
    const float t3202 = (t1223 * t1359) + (t781 * t1168) - (t1845 * t3170) -
        (motion->constants[37] * t3198);
    const float t3211 = (t1223 * t1878) + (t1168 * t1880) + (t1882 * t3179) + (cos_delta * t3185);
    const float t3212 = (t1223 * t1870) + t3211;
    const float t3220 = (t1223 * t1908) + (t790 * t1168) + (motion->constants[23] * t3211) - (t770 *
        t3179);
    const float t3234 = t1433 + (t1223 * t1947) + (t1168 * t1949) + (t1769 * t3179) -
        (motion->constants[38] * t3198);
    const float t3240 = (t1223 * t1968) + (t1168 * t1970) + (t1797 * t3179);
    const float t3246 = (t1223 * t1933) + (t1168 * t1937) + (t1892 * t3170) +
        (motion->constants[24] * t3189) + (cos_delta * t3234) + (sin_delta * t3240);
    const float t3248 = t3246 - motion->constants[18] - (motion->constants[46] * t3198);
    const float t3256 = (t1223 * t1997) + (cos_delta * t3240) - (motion->constants[24] * t3211) -
        (sin_delta * t3234);
    const float t3264 = (t1841 * t3191) + (t29 * t3220) - (t1764 * t3202) - (t18 * t3256);
    const float t3272 = (t2037 * t3191) - (t2039 * t3202) - (sin_phi * t3248) - (cos_phi * t3264);
    const float t3281 = t3248 + (t1323 * t2067) + (t2071 * t3202) + (t383 * t3272) - (t2069 *
        t3191);
    const float t3287 = (t1323 * t2133) + (t2136 * t3281) - (t2131 * t3272);
    const float t3293 = (t1323 * t2202) + (t2201 * t3272) + (t2205 * t3281);
    const float t3299 = (t2257 * t3281) - (t1323 * t2254) - (t2252 * t3272);
    const float t3305 = (t2279 * t3293) - (t2274 * t3287) - (t2281 * t3299);
    const float t3311 = (t2295 * t3293) + (t2298 * t3299) - (t2291 * t3287);
    const float t3334 = (t1223 * t2371) + (t1168 * t2373) + (speeds[1] * t3240) + (t2385 * t3287) +
        (t2391 * t3293) - (t2377 * t3179);
    const float t3336 = t3334 - (t2379 * t3198) - (t2394 * t3299);
    const float t3351 = (t1223 * t2426) + (t1168 * t2430) + (t2434 * t3179) + (t2436 * t3198) +
        (t2444 * t3287) + (t2447 * t3293);
    const float t3354 = t3351 + (t2452 * t3299) + (t2454 * t3305) - (speeds[1] * t3234);
    const float t3360 = (t1223 * t2323) + (t1168 * t2325) + (t2335 * t3211) + (t2342 * t3293) +
        (t2346 * t3299) + (cos_delta * t3336);
    const float t3365 = t3360 + (sin_delta * t3354) - (t2329 * t3170) - (t2331 * t3198) - (t2337 *
        t3189) - (t2315 * t3287);
    const float t3383 = (t1223 * t2504) + (t1168 * t2510) + (t2514 * t3170) + (t2516 * t3198) +
        (t892 * t3211) + (t2333 * t3189);
    const float t3388 = t3383 + (t94 * t3220) + (t2497 * t3287) + (t2526 * t3293) + (t2532 *
        t3299) + (cos_delta * t3354);
    const float t3389 = t3388 - (sin_delta * t3336);
    const float t3404 = (t2633 * t3179) - (t2628 * t3305);
    const float t3409 = (t1223 * t2586) + (t1168 * t2594) + (t2598 * t3170) + (t2601 * t3198) +
        (t890 * t3211) + (t2610 * t3287);
    const float t3414 = t3409 + (t2617 * t3293) + (t2625 * t3299) + (t94 * t3311) - (t2604 *
        t3189) - (t94 * t3256);
    const float t3415 = t3414 - t3404;
    const float t3425 = (t1223 * t2659) + (t2668 * t3293) - (t1168 * t2661) - (t2664 * t3287) -
        (t2671 * t3299);
    const float t3438 = (t2688 * t3191) + (t2683 * t3212) + (t2702 * t3287) - (t2702 * t3202);
    const float t3443 = t3365 + (t875 * t3220) + (t2691 * t3293) + (t2697 * t3299) + (t872 *
        t3311) + t3438;
    const float t3444 = t3443 - (t872 * t3256);
    const float t3462 = (t2721 * t3191) + (t2727 * t3202) + (t2735 * t3264) + (t2739 * t3287) +
        (t2751 * t3293) + (t2759 * t3299);
    const float t3467 = t3462 + (t2761 * t3311) + (t21 * t3389) - (t2731 * t3212) - (t2733 *
        t3248) - (sin_phi * t3365);
    const float t3468 = t3467 - (t30 * t3415);
    const float t3476 = (t1223 * t1592) + (t362 * t1655) + (t1223 * t1663) + (t1168 * t1665) +
        (t1669 * t3170) + (t1323 * t1724);
    const float t3481 = t3476 + (t1763 * t3191) + (t1840 * t3202) + (t1899 * t3220) + (t1927 *
        t3248) + (t2010 * t3264);
    const float t3486 = t3481 + (t2035 * t3272) + (t2064 * t3281) + (t2129 * t3287) + (t2200 *
        t3293) + (t2250 * t3299);
    const float t3491 = t3486 + (t2272 * t3305) + (t2288 * t3311) + (t2488 * t3389) + (t2557 *
        t3415) + (t671 * t3425);
    const float t3496 = t3491 + (t244 * t3444) + (t485 * t3468) - (sin_phi * (t1658 + (t349 *
        t1634))) - (t587 * t1545) - (t1866 * t3212);
    const float t3501 = t1447 * (t3496 - (t1991 * t3256) - (t869 * t3365) - (t1330 * t2807) -
        (t1410 * t3157));
    const float t3503 = (t1409 * t3157) - (t1410 * t3501);
    const float t3507 = (t863 * t2807) - (t1385 * t3503) - (t1330 * t3501);
    const float t3511 = (t1506 * t1769) - (t1510 * t1797);
    const float t3513 = t1551 + (sin_delta * t3511);
    const float t3515 = motion->constants[37] * t1506;
    const float t3519 = motion->constants[37] * t1510;
    const float t3523 = (cos_delta * (t1555 + (sin_delta * t3515))) - (sin_delta * (t1562 +
        (sin_delta * t3519)));
    const float t3535 = (t18 * t3513) + (t88 * t3523) - (t250 * t1617) - (t252 * t1630);
    const float t3538 = t1624 + (cos_delta * t3511);
    const float t3542 = (t252 * t1575) - (t250 * t1581);
    const float t3550 = (cos_delta * ((cos_delta * t3515) - t1562)) - (sin_delta * (t1555 +
        (cos_delta * t3519)));
    const float t3567 = (t270 * t1686) + (t274 * t1692) + (t278 * t1697) + (t503 * t1702) + (t681 *
        t1704) + (t686 * t1709);
    const float t3572 = t3567 + (t703 * t1711) + (t729 * t1713) - (t255 * t1677) - (t695 * t1699) -
        (t493 * t1707);
    const float t3581 = (t250 * t1476) + (t252 * t1481) - (t313 * t1754) - (t321 * t1757);
    const float t3589 = (t252 * t1476) + (t313 * t1832) + (t321 * t1834) - (t250 * t1481);
    const float t3595 = (t252 * t1456) - (t250 * t1472);
    const float t3599 = (t313 * t1456) + (t321 * t1452);
    const float t3603 = (t250 * t1456) + (t252 * t1472);
    const float t3618 = (t270 * t1684) + (t278 * t1695) + (t503 * t1701) + (t495 * t1448) + (t508 *
        t1456) + (t534 * t1452);
    const float t3621 = t3618 - (t255 * t1674) - (t274 * t1690) - (t493 * t1706);
    const float t3631 = (t255 * t2049) + (t270 * t2051) + (t274 * t2054) - (t278 * t2056) - (t311 *
        t2058);
    const float t3651 = (t250 * t933) + (t252 * t926) + (t255 * t2109) + (t274 * t2117) + (t278 *
        t2121) - (cos_delta * ((t919 * t1005) + (t902 * t2097)));
    const float t3653 = t3651 - (sin_delta * ((t919 * t2097) - (t902 * t1005))) - (t270 * t2112);
    const float t3656 = (t919 * t2158) - t937;
    const float t3659 = t911 + (t902 * t2158);
    const float t3670 = (cos_delta * t3656) + (t270 * t2185) + (t274 * t2189) - (sin_delta *
        t3659) - (t250 * t2178) - (t252 * t2180);
    const float t3671 = t3670 - (t278 * t2193);
    const float t3685 = (cos_delta * t3659) + (sin_delta * t3656) + (t252 * t2231) + (t270 *
        t2235) - (t250 * t2229) - (t255 * t2233);
    const float t3687 = t3685 - (t274 * t2239) - (t278 * t2242);
    const float t3695 = (t255 * t2262) + (t274 * t2266) - (t270 * t2264) - (t278 * t2268);
    const float t3697 = t252 * t895;
    const float t3703 = (t252 * t869) - (speeds[0] * t250);
    const float t3707 = (t250 * t869) + (speeds[0] * t252);
    const float t3716 = (t29 * t3513) + (t1774 * t3523) + (t508 * t1655) + (t813 * t3535) + (t1672 *
        t3542) + (t1786 * t3550);
    const float t3721 = t3716 + (t1814 * t3581) + (t1856 * t3589) + (t1535 * t1977) + (t1919 *
        t3595) + (t1987 * t3599);
    const float t3726 = t3721 + (t2045 * t3621) + (t2077 * t3631) + (t2139 * t3653) + (t2208 *
        t3671) + (t2260 * t3687);
    const float t3731 = t3726 + (t2284 * t3695) + (t2301 * t3697) + (t943 * t2466) + (t2551 *
        t3703) + (t2652 * t3707);
    const float t3736 = t3731 + (t733 * t2678) + (t323 * t2714) + (t537 * t2776) - (t250 * t1647) -
        (t252 * t1650);
    const float t3741 = t3736 - (t313 * t1592) - (t703 * t1545) - (t805 * t3538) - (t850 * t3572) -
        (t1527 * t1805);
    const float t3744 = t3741 - (t1516 * t1958) - (t2007 * t3603) - (t948 * t2405);
    const float t3782 = (t270 * t2811) + (t534 * t1655) + (t1337 * t3535) + (t2821 * t3542) +
        (t2830 * t3550) + (t1354 * t3572);
    const float t3787 = t3782 + (t2843 * t3581) + (t2854 * t3589) + (t1535 * t2894) + (t2873 *
        t3595) + (t2901 * t3599);
    const float t3792 = t3787 + (t2925 * t3621) + (t2934 * t3631) + (t2940 * t3653) + (t2946 *
        t3671) + (t2952 * t3687);
    const float t3797 = t3792 + (t2958 * t3695) + (t2964 * t3697) + (t943 * t3009) + (t3044 *
        t3703) + (t3071 * t3707);
    const float t3802 = t3797 + (t733 * t3082) + (t323 * t3101) + (t537 * t3125) - (t321 * t1592) -
        (t729 * t2815);
    const float t3807 = t3802 - (t1335 * t3538) - (t1527 * t2837) - (t1516 * t2887) - (t2909 *
        t3603) - (t948 * t2990);
    const float t3808 = t3807 - (t1385 * t3744);
    const float t3845 = (t495 * t1655) + (t1223 * t3535) + (t1168 * t3538) + (t3170 * t3542) +
        (t3179 * t3550) + (t1323 * t3572);
    const float t3850 = t3845 + (t3191 * t3581) + (t3202 * t3589) + (t1535 * t3240) + (t3220 *
        t3595) + (t3248 * t3599);
    const float t3855 = t3850 + (t3272 * t3621) + (t3281 * t3631) + (t3287 * t3653) + (t3293 *
        t3671) + (t3299 * t3687);
    const float t3860 = t3855 + (t3305 * t3695) + (t3311 * t3697) + (t943 * t3354) + (t3389 *
        t3703) + (t3415 * t3707);
    const float t3865 = t3860 + (t733 * t3425) + (t323 * t3444) + (t537 * t3468) - (t686 * t1545) -
        (t1527 * t3185);
    const float t3870 = t3865 - (t1516 * t3234) - (t3256 * t3603) - (t948 * t3336) - (t1330 *
        t3744) - (t1410 * t3808);
    const float t3871 = t1447 * t3870;
    const float t3873 = (t1409 * t3808) - (t1410 * t3871);
    const float t3877 = (t863 * t3744) - (t1385 * t3873) - (t1330 * t3871);
    const float t3878 = t886 + t886;
    const float t3879 = t18 * t3878;
    const float t3880 = t105 + t1858;
    const float t3881 = t2683 + t3880;
    const float t3883 = (t29 * t3881) - t3879;
    const float t3885 = t29 * t3878;
    const float t3887 = t3885 + (t18 * t3881);
    const float t3892 = t3880 + (t104 * t888);
    const float t3896 = cos_delta * t869;
    const float t3901 = t3885 + (t18 * t3892) + (t869 * t2093) + (t2097 * t3896) - (t869 * t2095);
    const float t3904 = t29 * t888;
    const float t3909 = (t29 * t3892) + (t869 * t2166) - t3879;
    const float t3912 = (t869 * t2159) + (t2144 * t3904) - (sin_delta * t3909);
    const float t3918 = (t2212 * t3904) + (cos_delta * t3909) - (t2158 * t3896);
    const float t3930 = (t1814 * t3883) + (t888 * t2017) + (t2139 * t3901) + (t2208 * t3912) +
        (t2260 * t3918) + (t2301 * t2484);
    const float t3935 = t3930 + (t29 * t2551) + (t18 * t2652) + (t592 * t2678) + (t75 * t2714) +
        (t384 * t2776);
    const float t3937 = t3935 - (t1856 * t3887) - (t869 * t1987);
    const float t3957 = (t2843 * t3883) + (t888 * t2917) + (t2940 * t3901) + (t2946 * t3912) +
        (t2952 * t3918) + (t2484 * t2964);
    const float t3962 = t3957 + (t29 * t3044) + (t18 * t3071) + (t592 * t3082) + (t75 * t3101) +
        (t384 * t3125);
    const float t3965 = t3962 - (t2854 * t3887) - (t869 * t2901) - (t1385 * t3937);
    const float t3986 = (t3191 * t3883) + (t888 * t3264) + (t3287 * t3901) + (t3293 * t3912) +
        (t3299 * t3918) + (t2484 * t3311);
    const float t3991 = t3986 + (t29 * t3389) + (t18 * t3415) + (t592 * t3425) + (t75 * t3444) +
        (t384 * t3468);
    const float t3996 = t1447 * (t3991 - (t3202 * t3887) - (t869 * t3248) - (t1330 * t3937) -
        (t1410 * t3965));
    const float t3998 = (t1409 * t3965) - (t1410 * t3996);
    const float t4002 = (t863 * t3937) - (t1385 * t3998) - (t1330 * t3996);
    const float t4005 = t2567 - (sin_delta * t2570);
    const float t4010 = t2584 - (t29 * t2410) - (t18 * t4005);
    const float t4013 = t2589 + (cos_delta * t2570);
    const float t4021 = t2609 + (t943 * t1005) + (t948 * t2097);
    const float t4024 = t2614 - (t943 * t2158);
    const float t4027 = t2622 + (t948 * t2158);
    const float t4036 = t2636 + (t18 * t2410) + (t813 * t4010) + (t1850 * t2360) + (t943 * t1977) +
        (t2139 * t4021);
    const float t4041 = t4036 + (t2208 * t4024) + (t555 * t2678) + (t92 * t2714) + (t468 * t2776) -
        (t29 * t4005);
    const float t4044 = t4041 - (t805 * t4013) - (t948 * t1958) - (t2260 * t4027);
    const float t4062 = t3060 + (t1337 * t4010) + (t2360 * t2850) + (t943 * t2894) + (t2940 *
        t4021) + (t2946 * t4024);
    const float t4067 = t4062 + (t555 * t3082) + (t92 * t3101) + (t468 * t3125) - (t1335 * t4013) -
        (t948 * t2887);
    const float t4069 = t4067 - (t2952 * t4027) - (t1385 * t4044);
    const float t4088 = (t1223 * t4010) + (t1168 * t4013) + (t2360 * t3198) + (t943 * t3240) +
        (t3287 * t4021) + (t3293 * t4024);
    const float t4093 = t4088 + (t555 * t3425) + (t92 * t3444) + (t468 * t3468) - t3404 - (t948 *
        t3234);
    const float t4097 = t1447 * (t4093 - (t3299 * t4027) - (t1330 * t4044) - (t1410 * t4069));
    const float t4099 = (t1409 * t4069) - (t1410 * t4097);
    const float t4103 = (t863 * t4044) - (t1385 * t4099) - (t1330 * t4097);
    const float t4104 = motion->constants[18] * t875;
    const float t4106 = motion->constants[18] * t872;
    const float t4110 = (t29 * t4104) + (t18 * t4106);
    const float t4120 = t2708 + (t29 * t4106) + (t813 * t4110) + (t2208 * t2690) + (t2260 * t2696) +
        (t565 * t2678);
    const float t4122 = t4120 + (t349 * t2776) - (t18 * t4104);
    const float t4134 = t3095 + (t1337 * t4110) + (t2690 * t2946) + (t2696 * t2952) + (t565 *
        t3082) + (t349 * t3125);
    const float t4135 = t4134 - (t1385 * t4122);
    const float t4148 = t3438 + (t1223 * t4110) + (t2690 * t3293) + (t2696 * t3299) + (t565 *
        t3425) + (t349 * t3468);
    const float t4151 = t1447 * (t4148 - (t1330 * t4122) - (t1410 * t4135));
    const float t4153 = (t1409 * t4135) - (t1410 * t4151);
    const float t4157 = (t863 * t4122) - (t1385 * t4153) - (t1330 * t4151);
    const float t4161 = t1447 * ((t1385 * t1410) - t1330);
    const float t4163 = (t1385 * t1409) + (t1410 * t4161);
    const float t4167 = t863 + (t1385 * t4163) - (t1330 * t4161);
    const float t4168 = t1410 * t1447;
    const float t4170 = t1409 + (t1410 * t4168);
    const float t4173 = (t1330 * t4168) - (t1385 * t4170);
    const float t4174 = -(t107 * t323);
    const float t4175 = -((motion->constants[21] * sin_psi) + (t75 * t107));
    const float t4176 = -(t92 * t107);
    const float t4177 = -t107;
    const float t4178 = -((t96 * cos_psi) + (sin_psi * t100));
    const float t4179 = -(t323 * t333);
    const float t4180 = -(t92 * t333);
    const float t4181 = -t333;
    const float t4182 = -t485;
    const float t4183 = -t537;
    const float t4184 = -t384;
    const float t4185 = -t468;
    const float t4186 = -t349;
    const float t4187 = -t4163;
    const float t4188 = -t4168;
    linearization->a[0][0] = 0.0F;
    linearization->a[0][1] = 0.0F;
    linearization->a[0][2] = t103;
    linearization->a[0][3] = t246;
    linearization->a[0][4] = 0.0F;
    linearization->a[0][5] = t4174;
    linearization->a[0][6] = 0.0F;
    linearization->a[0][7] = 0.0F;
    linearization->a[0][8] = t4175;
    linearization->a[0][9] = t4176;
    linearization->a[0][10] = t4177;
    linearization->b[0][0] = 0.0F;
    linearization->b[0][1] = 0.0F;
    linearization->a[1][0] = 0.0F;
    linearization->a[1][1] = 0.0F;
    linearization->a[1][2] = t4178;
    linearization->a[1][3] = t335;
    linearization->a[1][4] = 0.0F;
    linearization->a[1][5] = t4179;
    linearization->a[1][6] = 0.0F;
    linearization->a[1][7] = 0.0F;
    linearization->a[1][8] = t339;
    linearization->a[1][9] = t4180;
    linearization->a[1][10] = t4181;
    linearization->b[1][0] = 0.0F;
    linearization->b[1][1] = 0.0F;
    linearization->a[2][0] = 0.0F;
    linearization->a[2][1] = 0.0F;
    linearization->a[2][2] = 0.0F;
    linearization->a[2][3] = t4182;
    linearization->a[2][4] = 0.0F;
    linearization->a[2][5] = t4183;
    linearization->a[2][6] = 0.0F;
    linearization->a[2][7] = 0.0F;
    linearization->a[2][8] = t4184;
    linearization->a[2][9] = t4185;
    linearization->a[2][10] = t4186;
    linearization->b[2][0] = 0.0F;
    linearization->b[2][1] = 0.0F;
    linearization->a[3][0] = 0.0F;
    linearization->a[3][1] = 0.0F;
    linearization->a[3][2] = 0.0F;
    linearization->a[3][3] = 0.0F;
    linearization->a[3][4] = 0.0F;
    linearization->a[3][5] = 0.0F;
    linearization->a[3][6] = 0.0F;
    linearization->a[3][7] = 0.0F;
    linearization->a[3][8] = 1.0F;
    linearization->a[3][9] = 0.0F;
    linearization->a[3][10] = 0.0F;
    linearization->b[3][0] = 0.0F;
    linearization->b[3][1] = 0.0F;
    linearization->a[4][0] = 0.0F;
    linearization->a[4][1] = 0.0F;
    linearization->a[4][2] = 0.0F;
    linearization->a[4][3] = t244;
    linearization->a[4][4] = 0.0F;
    linearization->a[4][5] = t323;
    linearization->a[4][6] = 0.0F;
    linearization->a[4][7] = 0.0F;
    linearization->a[4][8] = t75;
    linearization->a[4][9] = t92;
    linearization->a[4][10] = 0.0F;
    linearization->b[4][0] = 0.0F;
    linearization->b[4][1] = 0.0F;
    linearization->a[5][0] = 0.0F;
    linearization->a[5][1] = 0.0F;
    linearization->a[5][2] = 0.0F;
    linearization->a[5][3] = 0.0F;
    linearization->a[5][4] = 0.0F;
    linearization->a[5][5] = 0.0F;
    linearization->a[5][6] = 0.0F;
    linearization->a[5][7] = 0.0F;
    linearization->a[5][8] = 0.0F;
    linearization->a[5][9] = 1.0F;
    linearization->a[5][10] = 0.0F;
    linearization->b[5][0] = 0.0F;
    linearization->b[5][1] = 0.0F;
    linearization->a[6][0] = 0.0F;
    linearization->a[6][1] = 0.0F;
    linearization->a[6][2] = 0.0F;
    linearization->a[6][3] = 0.0F;
    linearization->a[6][4] = 0.0F;
    linearization->a[6][5] = 0.0F;
    linearization->a[6][6] = 0.0F;
    linearization->a[6][7] = 0.0F;
    linearization->a[6][8] = 0.0F;
    linearization->a[6][9] = 0.0F;
    linearization->a[6][10] = 1.0F;
    linearization->b[6][0] = 0.0F;
    linearization->b[6][1] = 0.0F;
    linearization->a[7][0] = 0.0F;
    linearization->a[7][1] = 0.0F;
    linearization->a[7][2] = 0.0F;
    linearization->a[7][3] = t671;
    linearization->a[7][4] = 0.0F;
    linearization->a[7][5] = t733;
    linearization->a[7][6] = 0.0F;
    linearization->a[7][7] = 0.0F;
    linearization->a[7][8] = t592;
    linearization->a[7][9] = t555;
    linearization->a[7][10] = t565;
    linearization->b[7][0] = 0.0F;
    linearization->b[7][1] = 0.0F;
    linearization->a[8][0] = 0.0F;
    linearization->a[8][1] = 0.0F;
    linearization->a[8][2] = 0.0F;
    linearization->a[8][3] = t3507;
    linearization->a[8][4] = 0.0F;
    linearization->a[8][5] = t3877;
    linearization->a[8][6] = 0.0F;
    linearization->a[8][7] = 0.0F;
    linearization->a[8][8] = t4002;
    linearization->a[8][9] = t4103;
    linearization->a[8][10] = t4157;
    linearization->b[8][0] = t4167;
    linearization->b[8][1] = t4173;
    linearization->a[9][0] = 0.0F;
    linearization->a[9][1] = 0.0F;
    linearization->a[9][2] = 0.0F;
    linearization->a[9][3] = t3503;
    linearization->a[9][4] = 0.0F;
    linearization->a[9][5] = t3873;
    linearization->a[9][6] = 0.0F;
    linearization->a[9][7] = 0.0F;
    linearization->a[9][8] = t3998;
    linearization->a[9][9] = t4099;
    linearization->a[9][10] = t4153;
    linearization->b[9][0] = t4187;
    linearization->b[9][1] = t4170;
    linearization->a[10][0] = 0.0F;
    linearization->a[10][1] = 0.0F;
    linearization->a[10][2] = 0.0F;
    linearization->a[10][3] = t3501;
    linearization->a[10][4] = 0.0F;
    linearization->a[10][5] = t3871;
    linearization->a[10][6] = 0.0F;
    linearization->a[10][7] = 0.0F;
    linearization->a[10][8] = t3996;
    linearization->a[10][9] = t4097;
    linearization->a[10][10] = t4151;
    linearization->b[10][0] = t4161;
    linearization->b[10][1] = t4188;
}

carvallo_motion_error_t whipple_tyres_f32_motion_linearize(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES], whipple_tyres_f32_linearization_t *linearization)
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_TYRES_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_TYRES_FORCES)) {
        bool are_finite = true;
        whipple_tyres_f32_compute_linearization(motion, positions, speeds, forces, linearization);
        for (size_t row = 0U; row < WHIPPLE_TYRES_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f32(linearization->a[row],
                WHIPPLE_TYRES_STATES) && carvallo_are_finite_f32(linearization->b[row],
                WHIPPLE_TYRES_FORCES);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_tyres_f32_compute_by_parameters(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES],
    float by_parameters[WHIPPLE_TYRES_STATES][WHIPPLE_TYRES_PARAMETERS])
{
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t7 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t12 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const float t13 = cos_phi * t12;
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t16 = t7 * cos_phi;
    const float t20 = sin_phi * sin_delta;
    const float t21 = t20 - (cos_delta * t16);
    const float t25 = sqrtf((t21 * t21) + (t13 * t13));
    const float t26 = 1.0F / t25;
    const float t27 = t13 * t26;
    const float t28 = cos_phi * sin_delta;
    const float t30 = t21 * t26;
    const float t32 = cos_delta * t27;
    const float t36 = (t27 * t28) + (sin_phi * ((t12 * t30) + (t7 * t32)));
    const float t39 = (cos_delta * sin_phi) + (t16 * sin_delta);
    const float t41 = t39 * motion->constants[28];
    const float t48 = motion->constants[23] + (cos_delta * motion->constants[26]);
    const float t51 = (t36 * t41) + (t7 * motion->constants[29]) + (t12 * t48);
    const float t53 = 1.0F / (cos_phi * t51);
    const float t55 = motion->constants[2] * t13;
    const float t56 = t55 - (motion->constants[3] * t16);
    const float t57 = t53 * t56;
    const float t58 = t7 * t57;
    const float t63 = t51 - (t7 * motion->constants[24]) - (t12 * motion->constants[23]);
    const float t64 = sin_phi * t53;
    const float t66 = t12 * sin_phi;
    const float t67 = t53 * t66;
    const float t69 = (t63 * t64) - (motion->constants[23] * t67);
    const float t74 = motion->constants[25] + (cos_phi * motion->constants[21]);
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t77 = t74 * cos_psi;
    const float t78 = speeds[1] * t77;
    const float t80 = t7 * sin_phi;
    const float t81 = t53 * t80;
    const float t82 = t78 * t81;
    const float t85 = t26 * t26;
    const float t86 = t21 * t85;
    const float t88 = t26 * 0.5F;
    const float t90 = cos_phi * (t13 + t13);
    const float t91 = t88 * t90;
    const float t92 = t86 * t91;
    const float t94 = t12 * cos_delta;
    const float t96 = t13 * t85;
    const float t98 = (cos_phi * t26) - (t91 * t96);
    const float t101 = t32 + (t7 * t92) + (t94 * t98);
    const float t103 = (sin_phi * motion->constants[29]) + (t41 * t101);
    const float t104 = t7 * t53;
    const float t107 = t77 * speeds[0];
    const float t109 = (t78 * t104) + (t53 * t107);
    const float t113 = t7 * cos_delta;
    const float t115 = t28 + (sin_phi * t113);
    const float t118 = (sin_phi * t30) + (t98 * t115) - (t66 * t92);
    const float t120 = t48 + (t41 * t118);
    const float t123 = (t12 * t32) - (t7 * t30);
    const float t125 = sin_delta * motion->constants[26];
    const float t129 = (t12 * motion->constants[29]) - (t7 * t48);
    const float t132 = (cos_phi * t125) - (t41 * t123) - (sin_phi * t129);
    const float t135 = (t12 * motion->constants[24]) - (t7 * motion->constants[23]);
    const float t137 = t132 + (sin_phi * t135);
    const float t141 = t53 * ((t7 * t137) + (t63 * t66));
    const float t142 = cos_phi * t53;
    const float t144 = t67 - (t141 * t142);
    const float t146 = sin_phi * motion->constants[25];
    const float t147 = t132 + t146;
    const float t148 = t53 * t147;
    const float t149 = t142 * t148;
    const float t151 = (t107 * t149) - (t78 * t144);
    const float t155 = (t103 * t109) + (t120 * t151) - (t69 * t78) - (motion->constants[24] * t82);
    const float t157 = t12 * t57;
    const float t160 = (t53 * t137) - (motion->constants[24] * t67);
    const float t164 = t28 * motion->constants[28];
    const float t166 = cos_phi * cos_delta;
    const float t169 = t166 * (t21 + t21);
    const float t170 = t88 * t169;
    const float t172 = (t86 * t170) - (t26 * t166);
    const float t174 = t96 * t170;
    const float t177 = (t94 * t174) - t30 - (t7 * t172);
    const float t180 = (sin_phi * t48) - (t123 * t164) - (t41 * t177);
    const float t187 = (sin_phi * t32) + (t66 * t172) + (t115 * t174);
    const float t190 = motion->constants[29] + (t36 * t164) + (t41 * t187);
    const float t194 = (motion->constants[23] * t82) + (t151 * t190) - (t78 * t160) - (t109 * t180);
    const float t196 = t7 * t67;
    const float t201 = (t66 * t109) + (t7 * t151);
    const float t203 = (t78 * t196) + t201 - (t12 * t82);
    const float t205 = t12 * t67;
    const float t212 = (t78 * t205) + (t7 * t82) + (t12 * t151) - (t80 * t109);
    const float t214 = (motion->constants[2] * t203) + (motion->constants[3] * t212);
    const float t216 = (t157 * t194) + t214 - (t58 * t155);
    const float t220 = (t94 * t151) - (t109 * t115);
    const float t223 = t20 - (cos_phi * t113);
    const float t227 = t53 * (t56 - t55 - (motion->constants[3] * t223));
    const float t228 = t7 * t227;
    const float t230 = t12 * t227;
    const float t235 = t214 + (t194 * t230) - (motion->constants[2] * t201) -
        (motion->constants[3] * t220) - (t155 * t228);
    const float t239 = motion->constants[0] + motion->constants[1];
    const float t244 = (motion->constants[3] * motion->constants[5]) - (motion->constants[2] *
        (motion->constants[0] - t239));
    const float t248 = motion->constants[28] * t88;
    const float t249 = t169 * t248;
    const float t251 = t90 * t248;
    const float t255 = cos_phi * t48;
    const float t257 = cos_phi * motion->constants[29];
    const float t280 = (motion->constants[3] * ((t16 * motion->constants[4]) + (t13 * t239) -
        (cos_pitch * t255) - (sin_pitch * t257))) + (t223 * t244);
    const float t284 = t280 + (t13 * motion->constants[26]) - (motion->constants[3] * ((cos_pitch *
        t249) + (sin_pitch * t251))) - (motion->constants[2] * ((cos_pitch * t251) - (sin_pitch *
        t249))) - (motion->constants[2] * ((cos_pitch * t257) + (t13 * motion->constants[4]) -
        (sin_pitch * t255) - (t16 * t239)));
    const float t285 = t53 * t284;
    const float t287 = t7 + (t7 * t285);
    const float t290 = t12 + (t12 * t285);
    const float t296 = (motion->constants[26] * t201) + (t220 * t244) + (motion->constants[23] *
        t203) + (t194 * t290) - (motion->constants[24] * t212) - (t155 * t287);
    const float t301 = (speeds[0] * t148) + (speeds[1] * t141);
    const float t302 = speeds[2] + t301;
    const float t303 = cos_psi * t302;
    const float t304 = t64 * t107;
    const float t308 = motion->constants[3] * t13;
    const float t311 = t53 * ((motion->constants[2] * t16) + t308 - cos_phi);
    const float t312 = t7 * t311;
    const float t314 = t12 * t311;
    const float t320 = (motion->constants[3] * t203) + (t194 * t314) - t303 - t304 -
        (motion->constants[2] * t212) - (t155 * t312);
    const float t321 = t39 * t123;
    const float t323 = t36 * t39;
    const float t325 = (t109 * t321) + (t151 * t323);
    const float t331 = t53 * (t25 + (motion->constants[2] * t223) - t308);
    const float t332 = t7 * t331;
    const float t334 = t12 * t331;
    const float t339 = t325 + (motion->constants[2] * t220) + (t194 * t334) -
        (motion->constants[3] * t201) - (t155 * t332);
    const float t343 = 1.0F - cos_phi;
    const float t345 = t53 * t343;
    const float t346 = t7 * t345;
    const float t348 = t12 * t345;
    const float t353 = t304 + (t303 * t343) + (t155 * t346) - (speeds[0] * sin_psi) - (t194 * t348);
    const float t354 = 1.0F - t25;
    const float t355 = t53 * t354;
    const float t356 = t7 * t355;
    const float t358 = t12 * t355;
    const float t361 = (t194 * t358) - t325 - (t155 * t356);
    const float t362 = t74 * sin_psi;
    const float t363 = speeds[1] * t362;
    const float t365 = t81 * t363;
    const float t368 = speeds[0] * t362;
    const float t370 = (t104 * t363) + (t53 * t368);
    const float t374 = (t149 * t368) - (t144 * t363);
    const float t378 = (t103 * t370) + (t120 * t374) - (t69 * t363) - (motion->constants[24] *
        t365);
    const float t386 = (motion->constants[23] * t365) + (t190 * t374) - (t160 * t363) - (t180 *
        t370);
    const float t392 = (t66 * t370) + (t7 * t374);
    const float t394 = (t196 * t363) + t392 - (t12 * t365);
    const float t402 = (t205 * t363) + (t7 * t365) + (t12 * t374) - (t80 * t370);
    const float t404 = (motion->constants[2] * t394) + (motion->constants[3] * t402);
    const float t406 = (t157 * t386) + t404 - (t58 * t378);
    const float t410 = (t94 * t374) - (t115 * t370);
    const float t417 = t404 + (t230 * t386) - (motion->constants[2] * t392) -
        (motion->constants[3] * t410) - (t228 * t378);
    const float t428 = (motion->constants[26] * t392) + (t244 * t410) + (motion->constants[23] *
        t394) + (t290 * t386) - (motion->constants[24] * t402) - (t287 * t378);
    const float t429 = t302 * sin_psi;
    const float t430 = t64 * t368;
    const float t439 = (motion->constants[3] * t394) + (t314 * t386) - t429 - t430 -
        (motion->constants[2] * t402) - (t312 * t378);
    const float t442 = (t321 * t370) + (t323 * t374);
    const float t450 = t442 + (motion->constants[2] * t410) + (t334 * t386) -
        (motion->constants[3] * t392) - (t332 * t378);
    const float t458 = t430 + (cos_psi * speeds[0]) + (t343 * t429) + (t346 * t378) - (t348 * t386);
    const float t462 = (t358 * t386) - t442 - (t356 * t378);
    const float t466 = 1.0F / ((t51 * t123) + (t36 * t147));
    const float t467 = t74 * t466;
    const float t468 = t118 * t467;
    const float t470 = t123 * t466;
    const float t473 = (cos_phi * t63) - (t13 * motion->constants[23]);
    const float t475 = t36 * t466;
    const float t484 = motion->constants[22] + (t25 * motion->constants[28]) + (sin_phi * t125) +
        (cos_phi * t129) - (cos_phi * t135);
    const float t487 = (sin_phi * t484) + (cos_phi * t137);
    const float t491 = (t66 * t475) - (t7 * t470);
    const float t493 = t257 + (motion->constants[28] * t91);
    const float t497 = (t13 * t63) - (t7 * t484);
    const float t498 = t466 * t497;
    const float t502 = (t66 * t484) + (t13 * t137);
    const float t503 = t466 * t502;
    const float t508 = (t470 * t473) + (t475 * t487) + (t491 * t493) + (t101 * t498) + (t118 *
        t503);
    const float t510 = sin_phi * t51;
    const float t512 = sin_phi * t147;
    const float t514 = (t123 * t510) + (t36 * t512);
    const float t515 = t466 * t514;
    const float t516 = speeds[1] * t515;
    const float t520 = (t13 * sin_phi) - (cos_phi * t66);
    const float t523 = (t475 * t520) + (t16 * t470);
    const float t526 = (speeds[1] * t523) + (t81 * t516);
    const float t530 = (t51 * t101) + (t118 * t147);
    const float t531 = t36 * t467;
    const float t532 = t466 * t531;
    const float t539 = t466 * ((t123 * t497) + (t36 * t502) + (t141 * t514));
    const float t540 = t466 * t539;
    const float t542 = t148 * t515;
    const float t543 = t466 * t542;
    const float t546 = (speeds[2] * t532) + (speeds[1] * t540) + (speeds[0] * t543);
    const float t550 = (t101 * t510) + (t118 * t512);
    const float t551 = t141 * t466;
    const float t553 = t148 * t466;
    const float t555 = (speeds[1] * t551) + (speeds[0] * t553);
    const float t557 = t13 * t475;
    const float t560 = speeds[0] * t515;
    const float t563 = sin_phi * t36;
    const float t568 = (t36 * t546) - (speeds[1] * t557) - (t104 * t516) - (t53 * t560) - (t555 *
        t563);
    const float t570 = t13 * t470;
    const float t575 = sin_phi * t123;
    const float t580 = (t149 * t560) + (t123 * t546) - (speeds[1] * t570) - (t144 * t516) - (t555 *
        t575);
    const float t586 = (t530 * t546) + (t120 * t580) - (speeds[2] * t468) - (speeds[1] * t508) -
        (t69 * t516) - (motion->constants[24] * t526);
    const float t588 = t586 - (t550 * t555) - (t103 * t568);
    const float t590 = t187 * t467;
    const float t593 = t484 + (t13 * motion->constants[24]);
    const float t596 = t255 + (motion->constants[28] * t170);
    const float t602 = (t177 * t498) + (t187 * t503) - (t470 * t593) - (t491 * t596);
    const float t608 = (t51 * t177) + (t147 * t187);
    const float t612 = (t177 * t510) + (t187 * t512);
    const float t620 = (motion->constants[23] * t526) + (t546 * t608) + (t180 * t568) + (t190 *
        t580) - (speeds[2] * t590) - (speeds[1] * t602);
    const float t622 = t620 - (t160 * t516) - (t555 * t612);
    const float t624 = t7 * t13;
    const float t626 = t13 * t491;
    const float t627 = t626 - (t470 * t624);
    const float t633 = (t66 * t568) - (t7 * t580);
    const float t636 = (t196 * t516) - (speeds[1] * t627) - (t12 * t526) - t633;
    const float t638 = t12 * t13;
    const float t641 = (t470 * t638) + (t16 * t491);
    const float t650 = (speeds[1] * t641) + (t205 * t516) + (t7 * t526) + (t80 * t568) + (t12 *
        t580);
    const float t652 = (motion->constants[2] * t636) + (motion->constants[3] * t650);
    const float t654 = (t157 * t622) + t652 - (t58 * t588);
    const float t656 = t633 + (speeds[1] * t626);
    const float t658 = t223 * t491;
    const float t663 = (t115 * t568) + (t94 * t580) - (speeds[1] * t658);
    const float t670 = t652 + (motion->constants[2] * t656) + (t230 * t622) -
        (motion->constants[3] * t663) - (t228 * t588);
    const float t681 = (t244 * t663) + (motion->constants[23] * t636) + (t290 * t622) -
        (motion->constants[26] * t656) - (motion->constants[24] * t650) - (t287 * t588);
    const float t687 = sin_phi * t563;
    const float t692 = (t555 * t687) + (t64 * t560) - (t546 * t563);
    const float t697 = (motion->constants[3] * t636) + (t314 * t622) - (speeds[2] * t475) -
        (motion->constants[2] * t650) - (t312 * t588) - t692;
    const float t698 = t25 * t491;
    const float t706 = (t321 * t568) - (t323 * t580);
    const float t711 = (motion->constants[3] * t656) + (motion->constants[2] * t663) + (t334 *
        t622) - (speeds[1] * t698) - (t332 * t588) - t706;
    const float t712 = t343 * t475;
    const float t718 = t692 + (speeds[2] * t712) + (t346 * t588) - (t348 * t622);
    const float t719 = t354 * t491;
    const float t725 = t706 + (t358 * t622) - (speeds[1] * t719) - (t356 * t588);
    const float t727 = speeds[1] * t81;
    const float t731 = (speeds[1] * t104) + (t53 * speeds[0]);
    const float t735 = (speeds[1] * t144) - (speeds[0] * t149);
    const float t739 = (t69 * speeds[1]) + (motion->constants[24] * t727) + (t120 * t735) - (t103 *
        t731);
    const float t747 = (speeds[1] * t160) + (t180 * t731) + (t190 * t735) - (motion->constants[23] *
        t727);
    const float t753 = (t66 * t731) - (t7 * t735);
    const float t755 = (t12 * t727) - (speeds[1] * t196) - t753;
    const float t763 = (t80 * t731) + (t12 * t735) - (speeds[1] * t205) - (t7 * t727);
    const float t765 = (motion->constants[2] * t755) + (motion->constants[3] * t763);
    const float t767 = (t157 * t747) + t765 - (t58 * t739);
    const float t771 = (t115 * t731) + (t94 * t735);
    const float t778 = t765 + (motion->constants[2] * t753) + (t230 * t747) -
        (motion->constants[3] * t771) - (t228 * t739);
    const float t789 = (t244 * t771) + (motion->constants[23] * t755) + (t290 * t747) -
        (motion->constants[26] * t753) - (motion->constants[24] * t763) - (t287 * t739);
    const float t790 = t64 * speeds[0];
    const float t798 = t790 + (motion->constants[3] * t755) + (t314 * t747) -
        (motion->constants[2] * t763) - (t312 * t739);
    const float t801 = (t323 * t735) - (t321 * t731);
    const float t809 = t801 + (motion->constants[3] * t753) + (motion->constants[2] * t771) +
        (t334 * t747) - (t332 * t739);
    const float t813 = (t346 * t739) - t790 - (t348 * t747);
    const float t817 = (t358 * t747) - t801 - (t356 * t739);
    const float t819 = motion->constants[28] + (t25 * motion->constants[22]);
    const float t820 = 1.0F / t819;
    const float t821 = t74 * t820;
    const float t822 = t101 * t821;
    const float t824 = speeds[1] * t820;
    const float t829 = (t7 * t36) + (t66 * t123);
    const float t836 = (t123 * t487) + (t493 * t829) + (t101 * t502) - (t36 * t473) - (t118 * t497);
    const float t840 = (t36 * t51) - (t123 * t147);
    const float t841 = t820 * t840;
    const float t842 = speeds[2] * t841;
    const float t844 = t824 * t840;
    const float t848 = (t36 * t510) - (t123 * t512);
    const float t851 = (t515 * t844) - (t824 * t848);
    const float t855 = (t123 * t520) - (t16 * t36);
    const float t860 = (t824 * t855) + (t523 * t844) + (t81 * t851);
    const float t864 = (t51 * t118) - (t101 * t147);
    const float t865 = t531 * t820;
    const float t868 = t542 * t820;
    const float t871 = (speeds[2] * t865) + (t539 * t824) + (speeds[0] * t868);
    const float t875 = (t118 * t510) - (t101 * t512);
    const float t877 = t148 * t820;
    const float t879 = (t141 * t824) + (speeds[0] * t877);
    const float t883 = speeds[0] * t841;
    const float t886 = (t532 * t842) + (t540 * t844) + (t543 * t883);
    const float t890 = (t551 * t844) + (t553 * t883);
    const float t892 = t13 * t123;
    const float t896 = t820 * t848;
    const float t899 = (t515 * t883) - (speeds[0] * t896);
    const float t909 = (t824 * t892) + (t557 * t844) + (t104 * t851) + (t53 * t899) + (t575 *
        t879) + (t563 * t890);
    const float t911 = t909 - (t123 * t871) - (t36 * t886);
    const float t913 = t13 * t36;
    const float t926 = (t570 * t844) + (t144 * t851) + (t36 * t871) + (t575 * t890) - (t824 *
        t913) - (t149 * t899);
    const float t928 = t926 - (t563 * t879) - (t123 * t886);
    const float t930 = t91 * motion->constants[22];
    const float t938 = t820 * ((t123 * t502) + (t539 * t840) - (t36 * t497) - (t141 * t848));
    const float t939 = t820 * t938;
    const float t940 = speeds[1] * t939;
    const float t944 = t820 * ((t74 * t123) + (t531 * t840));
    const float t945 = t820 * t944;
    const float t950 = t820 * ((t542 * t840) - (t148 * t848));
    const float t951 = t820 * t950;
    const float t954 = t940 + (speeds[2] * t945) + (speeds[0] * t951);
    const float t960 = (speeds[2] * t822) + (t824 * t836) + (t468 * t842) + (t508 * t844) + (t69 *
        t851) + (motion->constants[24] * t860);
    const float t965 = t960 + (t864 * t871) + (t550 * t890) + (t120 * t928) - (t875 * t879) -
        (t530 * t886);
    const float t967 = t965 - (t103 * t911) - (t930 * t954);
    const float t969 = t177 * t821;
    const float t977 = (t36 * t593) + (t177 * t502) - (t596 * t829) - (t187 * t497);
    const float t985 = (t51 * t187) - (t147 * t177);
    const float t989 = (t187 * t510) - (t177 * t512);
    const float t995 = t170 * motion->constants[22];
    const float t1001 = (speeds[2] * t969) + (t824 * t977) + (t590 * t842) + (t602 * t844) + (t160 *
        t851) + (t871 * t985);
    const float t1006 = t1001 + (t612 * t890) + (t180 * t911) + (t190 * t928) + (t954 * t995) -
        (motion->constants[23] * t860);
    const float t1008 = t1006 - (t879 * t989) - (t608 * t886);
    const float t1011 = t13 * t829;
    const float t1012 = (t36 * t624) + t1011;
    const float t1019 = (t66 * t911) - (t7 * t928);
    const float t1023 = (t824 * t1012) + (t627 * t844) + (t12 * t860) - (t196 * t851) - t1019;
    const float t1027 = (t36 * t638) - (t16 * t829);
    const float t1038 = (t824 * t1027) + (t80 * t911) + (t12 * t928) - (t641 * t844) - (t205 *
        t851) - (t7 * t860);
    const float t1040 = (motion->constants[2] * t1023) + (motion->constants[3] * t1038);
    const float t1042 = (t157 * t1008) + t1040 - (t58 * t967);
    const float t1046 = (t824 * t1011) + (t626 * t844) - t1019;
    const float t1048 = t223 * t829;
    const float t1055 = (t824 * t1048) + (t658 * t844) + (t115 * t911) + (t94 * t928);
    const float t1062 = t1040 + (t230 * t1008) - (motion->constants[2] * t1046) -
        (motion->constants[3] * t1055) - (t228 * t967);
    const float t1073 = (motion->constants[26] * t1046) + (t244 * t1055) + (motion->constants[23] *
        t1023) + (t290 * t1008) - (motion->constants[24] * t1038) - (t287 * t967);
    const float t1074 = t123 * t820;
    const float t1081 = sin_phi * t575;
    const float t1090 = (t879 * t1081) + (t687 * t890) + (t64 * t899) - (t563 * t886) - (t575 *
        t871);
    const float t1095 = (speeds[2] * t1074) + (t475 * t842) + (motion->constants[3] * t1023) +
        (t314 * t1008) + t1090 - (motion->constants[2] * t1038);
    const float t1096 = t1095 - (t312 * t967);
    const float t1097 = t25 * t829;
    const float t1106 = (t321 * t911) - (t323 * t928);
    const float t1111 = (t824 * t1097) + (t698 * t844) + (motion->constants[2] * t1055) + (t334 *
        t1008) - t954 - (motion->constants[3] * t1046);
    const float t1113 = t1111 - (t332 * t967) - t1106;
    const float t1114 = t343 * t1074;
    const float t1122 = (t346 * t967) - t1090 - (speeds[2] * t1114) - (t712 * t842) - (t348 *
        t1008);
    const float t1123 = t354 * t829;
    const float t1133 = t1106 + (t824 * t1123) + (t719 * t844) + (t354 * t954) + (t358 * t1008) -
        (t356 * t967);
    const float t1137 = sin_delta * motion->constants[45];
    const float t1138 = sin_delta * t1137;
    const float t1142 = motion->constants[35] + motion->constants[40] + motion->constants[47] -
        t1138;
    const float t1144 = cos_delta * motion->constants[38];
    const float t1145 = motion->constants[23] * t1144;
    const float t1148 = t1145 + t1145 + motion->constants[50];
    const float t1151 = motion->constants[36] + motion->constants[43];
    const float t1152 = t1148 + t1151;
    const float t1153 = t1152 - t1142;
    const float t1154 = t7 * t7;
    const float t1156 = t7 * t12;
    const float t1158 = motion->constants[24] * t1144;
    const float t1162 = cos_delta * motion->constants[41];
    const float t1163 = motion->constants[32] + t1162;
    const float t1166 = t1163 - motion->constants[48] - t1158 - motion->constants[49];
    const float t1167 = t1166 + t1166;
    const float t1169 = (t1153 * t1154) + (t1156 * t1167);
    const float t1170 = sin_phi * motion->constants[21];
    const float t1171 = sin_delta * motion->constants[38];
    const float t1172 = t1170 * t1171;
    const float t1174 = t1170 * motion->constants[51];
    const float t1177 = (t1170 * t1174) - t1172 - t1172;
    const float t1182 = t1144 + motion->constants[30];
    const float t1183 = motion->constants[46] + t1182;
    const float t1185 = (t12 * motion->constants[52]) - (t7 * t1183);
    const float t1186 = t74 * t1185;
    const float t1187 = t74 * motion->constants[51];
    const float t1188 = t74 * t1187;
    const float t1190 = t1188 - t1186 - t1186;
    const float t1191 = sin_delta * motion->constants[41];
    const float t1193 = t1191 - (motion->constants[24] * t1171);
    const float t1197 = (cos_delta * t1137) - (motion->constants[23] * t1171);
    const float t1201 = (t7 * motion->constants[52]) + (t12 * t1183);
    const float t1204 = (t7 * t1193) + (t12 * t1197) + (t1170 * t1201);
    const float t1206 = t148 - (sin_phi * t542);
    const float t1213 = t1166 + (t1153 * t1156) + (t74 * t1201) - (t1154 * t1167);
    const float t1214 = cos_phi * t542;
    const float t1222 = t1138 + motion->constants[47] + t1148 + t1190 + motion->constants[33] +
        motion->constants[42];
    const float t1232 = (t12 * t1193) + (t1170 * t1185) + (t74 * t1171) - (t7 * t1197) - (t74 *
        t1174);
    const float t1239 = t1152 + t1177 - t1169;
    const float t1245 = t1206 * motion->constants[18];
    const float t1247 = t12 * sin_delta;
    const float t1249 = t7 * sin_delta;
    const float t1253 = t950 + (cos_delta * t1206) - t1247 - (t1214 * t1249);
    const float t1255 = t1253 * motion->constants[19];
    const float t1262 = t1142 + t1169 + t1177 + t1190 + (t1204 * t1206) + (t1206 * (t1204 + (t1206 *
        t1222) - (t1214 * t1232))) + (t1206 * t1245);
    const float t1265 = t1262 + (t1253 * t1255) - (t1213 * t1214) - (t1214 * (t1213 + (t1206 *
        t1232) - (t1214 * t1239)));
    const float t1266 = 1.0F / t1265;
    const float t1271 = (speeds[0] * t542) + (speeds[1] * t539) + (speeds[2] * t531);
    const float t1272 = sin_phi * t1271;
    const float t1273 = t301 - t1272;
    const float t1275 = cos_phi * t1271;
    const float t1277 = (t12 * speeds[0]) + (t7 * t1275);
    const float t1278 = motion->constants[32] * t1277;
    const float t1281 = (t7 * speeds[0]) - (t12 * t1275);
    const float t1283 = t1278 + (motion->constants[36] * t1281);
    const float t1286 = speeds[2] + t1273;
    const float t1288 = (motion->constants[33] * t1273) + (motion->constants[18] * t1286);
    const float t1290 = (t1273 * t1283) - (t1281 * t1288);
    const float t1292 = motion->constants[25] * t1272;
    const float t1293 = t1275 * t1292;
    const float t1295 = sin_phi * motion->constants[44];
    const float t1296 = t302 * t1275;
    const float t1299 = t1293 - (t74 * t1296);
    const float t1300 = t1295 + t1299;
    const float t1302 = t301 * t1281;
    const float t1303 = speeds[0] * t1272;
    const float t1304 = motion->constants[24] * t1273;
    const float t1306 = motion->constants[23] * t1273;
    const float t1308 = (t1281 * t1304) + (t1277 * t1306);
    const float t1310 = t301 * t1277;
    const float t1311 = (t12 * t1303) + t1310;
    const float t1314 = t1302 + (t7 * t1303);
    const float t1318 = t1308 + (motion->constants[23] * t1311) + (motion->constants[24] * t1314) -
        t1299;
    const float t1321 = motion->constants[23] * t1281;
    const float t1322 = motion->constants[24] * t1277;
    const float t1323 = t1321 - t1322;
    const float t1325 = (t1273 * t1306) + (t1281 * t1323);
    const float t1326 = speeds[0] * t1275;
    const float t1329 = speeds[0] * t302;
    const float t1330 = t1303 + t1329;
    const float t1332 = motion->constants[25] * speeds[0];
    const float t1333 = t1275 * t1332;
    const float t1335 = (t74 * t1326) + (t1170 * t1330) + t1333;
    const float t1339 = t302 - t1272;
    const float t1341 = (t1292 * t1339) - (speeds[0] * t1332);
    const float t1342 = (t1170 * t1296) + t1341;
    const float t1346 = (t12 * t1335) + (t7 * t1342) - t1325 - (motion->constants[24] * t1326);
    const float t1348 = speeds[1] + t1281;
    const float t1352 = (cos_delta * t1273) - (sin_delta * t1277);
    const float t1353 = motion->constants[27] * t1352;
    const float t1357 = (cos_delta * t1277) + (sin_delta * t1273);
    const float t1358 = motion->constants[26] * t1352;
    const float t1363 = speeds[1] * t1352;
    const float t1365 = t1363 - (cos_delta * t1314) - (sin_delta * t1326);
    const float t1367 = t30 * t819;
    const float t1372 = (speeds[0] * t950) + (speeds[1] * t938) + (speeds[2] * t944);
    const float t1374 = t1311 + (t1357 * t1372);
    const float t1376 = t27 * t819;
    const float t1378 = t1365 - (t1348 * t1372);
    const float t1380 = t26 * t39;
    const float t1383 = (t30 * t1357) + (t27 * t1348);
    const float t1384 = t1380 * t1383;
    const float t1385 = t27 * t1384;
    const float t1386 = motion->constants[28] * t1385;
    const float t1388 = t30 * t1384;
    const float t1389 = motion->constants[28] * t1388;
    const float t1395 = (cos_delta * t1318) + (t1348 * t1353) + (t1357 * t1358) +
        (motion->constants[26] * t1311) + (t1367 * t1374) + (t1348 * t1386);
    const float t1399 = t1395 + (t1357 * t1389) - (sin_delta * t1346) - (motion->constants[27] *
        t1365) - (t1376 * t1378);
    const float t1404 = motion->constants[26] * t1348;
    const float t1405 = motion->constants[27] * t1357;
    const float t1406 = t1404 - t1405;
    const float t1410 = speeds[1] * t1357;
    const float t1412 = (sin_delta * t1314) - (cos_delta * t1326) - t1410;
    const float t1415 = t39 * motion->constants[22];
    const float t1417 = t1352 + t1372;
    const float t1421 = (t30 * t1348) - (t27 * t1357);
    const float t1422 = motion->constants[28] * t1421;
    const float t1428 = (cos_delta * t1346) + (sin_delta * t1318) + (motion->constants[27] *
        t1412) + (t1376 * t1412) - (t1352 * t1358) - (t1348 * t1406);
    const float t1431 = t1428 - (t1374 * t1415) - (t1389 * t1417) - (t1348 * t1422);
    const float t1435 = (t1277 * t1323) - (t1273 * t1304);
    const float t1450 = t1435 + (motion->constants[23] * t1326) + (t7 * t1335) + (t1357 * t1406) +
        (t1378 * t1415) + (t1357 * t1422);
    const float t1455 = t1450 - (t12 * t1342) - (t1352 * t1353) - (motion->constants[26] * t1412) -
        (t1367 * t1412) - (t1386 * t1417);
    const float t1457 = (t30 * t1431) + (t27 * t1455);
    const float t1462 = t53 * ((t39 * t1399) + (t25 * t1457));
    const float t1466 = t466 * ((t25 * t1399) + (t514 * t1462) - (t39 * t1457));
    const float t1468 = t1303 - (cos_phi * t1466);
    const float t1470 = t1302 + (t7 * t1468);
    const float t1473 = t1310 + (t12 * t1468);
    const float t1477 = motion->constants[32] * t1281;
    const float t1478 = (motion->constants[35] * t1277) + t1477;
    const float t1480 = (t1277 * t1288) - (t1273 * t1478);
    const float t1485 = t1308 + (motion->constants[23] * t1473) + (motion->constants[24] * t1470) -
        t1300;
    const float t1488 = t1326 - t1462;
    const float t1489 = (sin_phi * t1466) + t1488;
    const float t1495 = (t74 * t1489) + t1333 + (t1170 * (t1329 + t1468));
    const float t1497 = cos_phi * motion->constants[44];
    const float t1498 = t1342 + t1497;
    const float t1500 = (t7 * t1498) + (t12 * t1495);
    const float t1502 = t1500 - (motion->constants[24] * t1489) - t1325;
    const float t1504 = (cos_delta * t1485) - (sin_delta * t1502);
    const float t1509 = t1363 - (sin_delta * t1489) - (cos_delta * t1470);
    const float t1514 = (motion->constants[42] * t1352) + (motion->constants[19] * t1417);
    const float t1517 = motion->constants[41] * t1348;
    const float t1518 = (motion->constants[40] * t1357) + t1517;
    const float t1520 = (t1357 * t1514) - (t1352 * t1518);
    const float t1523 = (motion->constants[38] * t1504) + (motion->constants[41] * t1509) +
        (motion->constants[43] * t1473) + t1520;
    const float t1527 = (cos_delta * t1502) + (sin_delta * t1485);
    const float t1533 = (sin_delta * t1470) - (cos_delta * t1489) - t1410;
    const float t1535 = motion->constants[38] * t1352;
    const float t1537 = motion->constants[38] * t1348;
    const float t1538 = t1357 * motion->constants[39];
    const float t1539 = t1537 - t1538;
    const float t1541 = (t1352 * t1535) + (t1348 * t1539);
    const float t1543 = (motion->constants[37] * t1527) + (motion->constants[39] * t1533) - t1541;
    const float t1548 = t1352 * motion->constants[39];
    const float t1551 = (t1348 * t1548) + (t1357 * t1535);
    const float t1554 = (t1504 * motion->constants[37]) + (motion->constants[38] * t1473) + t1551 -
        (t1509 * motion->constants[39]);
    const float t1556 = (sin_delta * t1543) + (cos_delta * t1554);
    const float t1562 = (motion->constants[36] * t1473) + t1480 + t1523 + (motion->constants[23] *
        t1556) - (motion->constants[30] * t1300) - (motion->constants[32] * t1470);
    const float t1570 = motion->constants[41] * t1357;
    const float t1572 = t1570 + (motion->constants[43] * t1348);
    const float t1575 = (t1352 * t1572) - (t1348 * t1514);
    const float t1578 = (motion->constants[40] * t1509) + (motion->constants[41] * t1473) + t1575 -
        (t1504 * motion->constants[39]);
    const float t1584 = (t12 * t1498) - (t7 * t1495);
    const float t1586 = t1435 + (motion->constants[23] * t1489) - t1584;
    const float t1596 = t820 * ((t30 * t1455) + (t840 * t1466) - (t27 * t1431) - (t848 * t1462));
    const float t1598 = motion->constants[19] * (t1533 + t1596);
    const float t1601 = (t1348 * t1518) - (t1357 * t1572);
    const float t1605 = (t1527 * motion->constants[39]) + (motion->constants[42] * t1533) + t1598 +
        t1601 - (motion->constants[38] * t1586);
    const float t1612 = t1290 + (motion->constants[31] * t1300) + (motion->constants[32] * t1473) +
        (cos_delta * t1578) - (motion->constants[35] * t1470) - (sin_delta * t1605);
    const float t1613 = t1612 - (motion->constants[24] * t1556);
    const float t1618 = motion->constants[30] * t1281;
    const float t1619 = t1277 * motion->constants[31];
    const float t1620 = t1618 - t1619;
    const float t1622 = t1273 * motion->constants[31];
    const float t1624 = (t1277 * t1620) - (t1273 * t1622);
    const float t1629 = (t1357 * t1539) - (t1352 * t1548);
    const float t1631 = (motion->constants[37] * t1586) + t1629 - (motion->constants[38] * t1533);
    const float t1634 = t1624 + t1631 - (t1584 * motion->constants[34]) + (motion->constants[30] *
        t1489);
    const float t1638 = motion->constants[30] * t1273;
    const float t1641 = (t1273 * t1638) + (t1281 * t1620);
    const float t1644 = (cos_delta * t1543) - (sin_delta * t1554);
    const float t1647 = (t1500 * motion->constants[34]) - (motion->constants[31] * t1489) + t1644 -
        t1641;
    const float t1656 = (t1281 * t1622) + (t1277 * t1638);
    const float t1661 = t74 * (t1556 + (motion->constants[30] * t1473) + (motion->constants[31] *
        t1470) + t1656 - (t1300 * motion->constants[34]));
    const float t1667 = (t1281 * t1478) - (t1277 * t1283);
    const float t1675 = (t7 * t1634) + (t12 * t1647);
    const float t1677 = (motion->constants[18] * t1489) + (t74 * t1675);
    const float t1682 = (motion->constants[31] * t1500) + (motion->constants[30] * t1584) -
        (motion->constants[33] * t1489) + t1667 + (sin_delta * t1578) + (cos_delta * t1605);
    const float t1685 = t1682 + (motion->constants[24] * t1644) - t1677 - (motion->constants[23] *
        t1631);
    const float t1691 = (t12 * t1562) + (t1170 * t1675) - (t7 * t1613);
    const float t1696 = forces[0] + (t1170 * ((t12 * t1634) - (t7 * t1647))) + (t1214 * t1691) -
        (t7 * t1562);
    const float t1700 = t1696 - (t12 * t1613) - t1661 - (t1206 * t1685) - (t950 * t1598);
    const float t1702 = t1145 + motion->constants[43];
    const float t1704 = t1162 - t1158;
    const float t1706 = t7 * t1171;
    const float t1710 = t141 - (sin_phi * t539);
    const float t1712 = cos_phi * t539;
    const float t1714 = t12 * t1171;
    const float t1715 = t74 * t1714;
    const float t1716 = t1193 + t1715;
    const float t1720 = t1716 + (t1222 * t1710) - (t1232 * t1712);
    const float t1726 = (t12 * t1702) - (t7 * t1704) - (t1170 * t1714);
    const float t1730 = t1726 + (t1232 * t1710) - (t1239 * t1712);
    const float t1736 = (t1249 * t1712) - t938 - (cos_delta * t1710);
    const float t1742 = (t7 * t1702) + (t12 * t1704) + (t74 * t1144) + (t1204 * t1710) + (t1206 *
        t1720) + (t1245 * t1710);
    const float t1747 = t1266 * (t1742 - (t1170 * t1706) - (t1213 * t1712) - (t1214 * t1730) -
        (t1255 * t1736));
    const float t1752 = motion->constants[18] * t1710;
    const float t1754 = motion->constants[19] * t1736;
    const float t1756 = t1265 * t1747;
    const float t1762 = motion->constants[43] + (t1710 * t1720) + (t1710 * t1716) + (t1710 *
        t1752) + (t1736 * t1754) - (t1712 * t1730);
    const float t1764 = t1762 - (t1712 * t1726) - (t1747 * t1756);
    const float t1765 = 1.0F / t1764;
    const float t1775 = forces[1] + (t1691 * t1712) - t1523 - (t1685 * t1710) - (t938 * t1598) -
        (t1700 * t1747);
    const float t1778 = t74 * (t1185 - t1187);
    const float t1779 = sin_phi * t531;
    const float t1781 = cos_phi * t531;
    const float t1784 = t1778 + (t1222 * t1779) + (t1232 * t1781);
    const float t1787 = t74 * (t1171 - t1174);
    const float t1791 = t1787 - (t1232 * t1779) - (t1239 * t1781);
    const float t1795 = 1.0F - t1779;
    const float t1800 = (t1249 * t1781) + (cos_delta * t1779) - t944;
    const float t1812 = (t1245 * t1795) - (t1204 * t1779) - (t1213 * t1781) - (t1206 * t1784) -
        (t1214 * t1791) - (t1255 * t1800);
    const float t1813 = t1266 * t1812;
    const float t1819 = t1715 + (t1752 * t1795) + (t1754 * t1800) - (t1710 * t1784) - (t1712 *
        t1791) - (t1716 * t1779);
    const float t1822 = t1765 * (t1819 - (t1726 * t1781) - (t1756 * t1813));
    const float t1832 = (t1685 * t1779) + (t1691 * t1781) + t1677 - (t944 * t1598) - (t1700 *
        t1813) - (t1775 * t1822);
    const float t1839 = motion->constants[19] * t1800;
    const float t1849 = t1188 + (t1779 * t1784) + (t1778 * t1779) + (motion->constants[18] * t1795 *
        t1795) + (t1800 * t1839) - (t1781 * t1791);
    const float t1853 = 1.0F / (t1849 - (t1781 * t1787) - (t1265 * t1813 * t1813) - (t1764 * t1822 *
        t1822));
    const float t1854 = t1832 * t1853;
    const float t1856 = (t1765 * t1775) - (t1822 * t1854);
    const float t1860 = (t1266 * t1700) - (t1747 * t1856) - (t1813 * t1854);
    const float t1861 = t1296 + t1860;
    const float t1864 = t1293 + t1295 - (t74 * t1861);
    const float t1872 = t1466 + (t542 * t1860) + (t539 * t1856) + (t531 * t1854);
    const float t1874 = t1303 - (cos_phi * t1872);
    const float t1877 = (t12 * t1860) - t1302 - (t7 * t1874);
    const float t1882 = t1310 + (t12 * t1874) + (t7 * t1860);
    const float t1888 = t1308 + (motion->constants[23] * t1882) - t1864 - (motion->constants[24] *
        t1877);
    const float t1895 = (t148 * t1860) + (t141 * t1856) - (sin_phi * t1872) - t1488;
    const float t1897 = t1854 + t1895;
    const float t1899 = t1329 + t1874;
    const float t1902 = (t74 * t1897) - t1333 - (t1170 * t1899);
    const float t1906 = t1341 + t1497 + (t1170 * t1861);
    const float t1908 = (t7 * t1906) - (t12 * t1902);
    const float t1910 = (motion->constants[24] * t1895) + t1908 - t1325;
    const float t1912 = (cos_delta * t1888) - (sin_delta * t1910);
    const float t1917 = t1363 + (cos_delta * t1877) + (sin_delta * t1895);
    const float t1919 = t1856 + t1882;
    const float t1923 = t1575 + (motion->constants[40] * t1917) + (motion->constants[41] * t1919) -
        (motion->constants[39] * t1912);
    const float t1927 = (cos_delta * t1910) + (sin_delta * t1888);
    const float t1932 = (t12 * t1906) + (t7 * t1902);
    const float t1934 = t1435 - (motion->constants[23] * t1895) - t1932;
    const float t1939 = (cos_delta * t1895) - t1410 - (sin_delta * t1877);
    const float t1947 = t1596 + t1939 + (t950 * t1860) + (t938 * t1856) + (t944 * t1854);
    const float t1948 = motion->constants[19] * t1947;
    const float t1952 = t1601 + (motion->constants[39] * t1927) + (motion->constants[42] * t1939) +
        t1948 - (motion->constants[38] * t1934);
    const float t1957 = (motion->constants[37] * t1927) + (motion->constants[39] * t1939) - t1541;
    const float t1964 = t1551 + (motion->constants[37] * t1912) + (motion->constants[38] * t1919) -
        (motion->constants[39] * t1917);
    const float t1966 = (sin_delta * t1957) + (cos_delta * t1964);
    const float t1972 = t1290 + (motion->constants[31] * t1864) + (motion->constants[35] * t1877) +
        (motion->constants[32] * t1882) + (cos_delta * t1923) - (sin_delta * t1952);
    const float t1973 = t1972 - (motion->constants[24] * t1966);
    const float t1979 = t1629 + (motion->constants[37] * t1934) - (motion->constants[38] * t1939);
    const float t1982 = t1624 + t1979 - (motion->constants[34] * t1932) - (motion->constants[30] *
        t1895);
    const float t1996 = t1480 + t1520 + (motion->constants[32] * t1877) + (motion->constants[36] *
        t1882) + (motion->constants[38] * t1912) + (motion->constants[41] * t1917) +
        (motion->constants[43] * t1919);
    const float t1998 = t1996 + (motion->constants[23] * t1966) - (motion->constants[30] * t1864);
    const float t2004 = (cos_delta * t1957) - (sin_delta * t1964);
    const float t2007 = (motion->constants[34] * t1908) + (motion->constants[31] * t1895) + t2004 -
        t1641;
    const float t2010 = (t1170 * t1214) + (t74 * t1206);
    const float t2012 = t820 * motion->constants[19];
    const float t2013 = t1455 * t2012;
    const float t2015 = t1431 * t2012;
    const float t2017 = t840 * t2012;
    const float t2018 = t466 * t1399;
    const float t2020 = t39 * t466;
    const float t2021 = t1431 * t2020;
    const float t2023 = t1455 * t2020;
    const float t2026 = (t91 * t2018) + (t92 * t2021) - (t98 * t2023);
    const float t2029 = (t2017 * t2026) - (t92 * t2013) - (t98 * t2015);
    const float t2031 = t7 * t1170;
    const float t2034 = t12 * motion->constants[34];
    const float t2036 = cos_delta * motion->constants[39];
    const float t2038 = sin_delta * motion->constants[39];
    const float t2040 = (cos_delta * t2038) - (sin_delta * t2036);
    const float t2043 = t1714 + (t7 * t2040);
    const float t2047 = (sin_delta * t2038) + (cos_delta * t2036);
    const float t2049 = sin_delta * motion->constants[37];
    const float t2052 = cos_delta * motion->constants[23];
    const float t2054 = cos_delta * motion->constants[24];
    const float t2058 = (t12 * t2052) + (t7 * t2054);
    const float t2060 = sin_delta * motion->constants[24];
    const float t2067 = (sin_delta * t2031) + (t12 * t2054) + (t1214 * t2058) + (t1206 * t2060) -
        (cos_delta * t74) - (t7 * t2052);
    const float t2068 = t2067 - (t1247 * t2010);
    const float t2070 = cos_delta * motion->constants[37];
    const float t2073 = sin_delta * motion->constants[23];
    const float t2078 = (t12 * t2073) + (t7 * t2060);
    const float t2086 = (t12 * t2060) + (t1214 * t2078) + (t94 * t2010) - (sin_delta * t74) -
        (cos_delta * t2031) - (t7 * t2073);
    const float t2087 = t2086 - (t1206 * t2054);
    const float t2093 = t1706 + (t2070 * t2087) - (t12 * t2040) - (t1214 * t2043) - (t1206 *
        t2047) - (t2049 * t2068);
    const float t2096 = (t2010 * t2034) + t2093 - (motion->constants[34] * t2031) - (t1206 *
        motion->constants[31]);
    const float t2098 = t12 * t1170;
    const float t2101 = t7 * motion->constants[34];
    const float t2106 = t2098 + (motion->constants[23] * t1206) + (t7 * t2010);
    const float t2110 = (motion->constants[37] * t2106) - t1714 - (t1214 * t1706);
    const float t2113 = (motion->constants[34] * t2098) + (t1182 * t1206) + (t2010 * t2101) + t2110;
    const float t2121 = (t12 * t1151) - (t7 * t1163);
    const float t2128 = (t12 * t1144) + (t7 * t2047);
    const float t2137 = (t12 * t2047) + (t1214 * t2128) + (t2068 * t2070) + (t2049 * t2087) - (t7 *
        t1144) - (t1206 * t2040);
    const float t2143 = (t1214 * t2121) + (motion->constants[38] * t2068) + (motion->constants[23] *
        t2137) - (t74 * motion->constants[30]) - (t7 * t1151) - (t12 * t1163);
    const float t2144 = t2143 - (t1191 * t1206);
    const float t2151 = (t12 * motion->constants[32]) - (t7 * motion->constants[35]);
    const float t2154 = sin_delta * motion->constants[42];
    const float t2156 = cos_delta * motion->constants[42];
    const float t2159 = t7 * t2154;
    const float t2166 = (t12 * t2154) + (t1214 * t2159) + (motion->constants[39] * t2087) - t1255 -
        (t1206 * t2156) - (motion->constants[38] * t2106);
    const float t2169 = cos_delta * motion->constants[40];
    const float t2171 = sin_delta * motion->constants[40];
    const float t2175 = (t12 * motion->constants[41]) - (t7 * t2169);
    const float t2181 = (t1214 * t2175) - (t7 * motion->constants[41]) - (t12 * t2169) - (t1206 *
        t2171) - (motion->constants[39] * t2068);
    const float t2187 = (t74 * motion->constants[31]) + (t1214 * t2151) + (cos_delta * t2181) -
        (t7 * motion->constants[32]) - (t12 * motion->constants[35]) - (motion->constants[24] *
        t2137);
    const float t2188 = t2187 - (sin_delta * t2166);
    const float t2192 = (cos_phi * t1170) - (sin_phi * t74);
    const float t2193 = t12 * t2192;
    const float t2195 = t7 * t2192;
    const float t2200 = motion->constants[23] * motion->constants[38];
    const float t2201 = sin_delta * t2200;
    const float t2203 = t7 * t2201;
    const float t2205 = motion->constants[33] + motion->constants[18];
    const float t2207 = t2205 + (cos_delta * t2200);
    const float t2211 = (t12 * motion->constants[31]) - (t7 * motion->constants[30]);
    const float t2221 = (t12 * t2201) + (t1214 * t2203) + (t2010 * t2211) + (motion->constants[24] *
        t2093) + (cos_delta * t2166) + (sin_delta * t2181);
    const float t2225 = t2221 - (motion->constants[31] * t2031) - (motion->constants[30] * t2098) -
        (t1206 * t2207) - (motion->constants[46] * t2106);
    const float t2231 = (t16 * t2188) - (t2096 * t2193) - (t2113 * t2195) - (t13 * t2144) -
        (sin_phi * t2225);
    const float t2233 = t53 * t1457;
    const float t2235 = t25 * t53;
    const float t2236 = t1431 * t2235;
    const float t2238 = t1455 * t2235;
    const float t2241 = (t91 * t2233) + (t98 * t2238) - (t92 * t2236);
    const float t2244 = (t515 * t2017) - (t848 * t2012);
    const float t2246 = t7 * t74;
    const float t2248 = t12 * t74;
    const float t2254 = t2225 + (t515 * t2231) - (t1253 * t2244) - (t2113 * t2246) - (t2096 *
        t2248);
    const float t2256 = t819 * t1412;
    const float t2257 = motion->constants[28] * t1348;
    const float t2259 = (t1357 * t2257) - t2256;
    const float t2261 = motion->constants[28] * t1384;
    const float t2262 = t1417 * t2261;
    const float t2263 = motion->constants[28] * t1357;
    const float t2265 = t2262 + (t1357 * t2263);
    const float t2268 = t1342 + (t92 * t2259) + (t98 * t2265);
    const float t2270 = t27 * t2020;
    const float t2272 = (t30 * t2012) - (t2017 * t2270);
    const float t2275 = t27 * t2235;
    const float t2278 = (t2254 * t2275) - (t1253 * t2272) - (t2231 * t2270);
    const float t2280 = motion->constants[26] + t1367;
    const float t2281 = t2052 + t2280;
    const float t2286 = (t819 * t1374) + (t1357 * t2261);
    const float t2290 = (t1348 * t2261) - (t819 * t1378);
    const float t2294 = (t1303 * t2281) + (t98 * t2290) - (sin_delta * t1335) - (t92 * t2286);
    const float t2295 = t25 * t466;
    const float t2296 = t2017 * t2295;
    const float t2299 = t39 * t53;
    const float t2302 = (t2231 * t2295) + (t2254 * t2299) - (t1253 * t2296);
    const float t2304 = t2073 - t1415;
    const float t2308 = t2262 + (t1348 * t2257);
    const float t2311 = t2256 + (t1348 * t2263);
    const float t2315 = (t1303 * t2304) + (cos_delta * t1335) + (t92 * t2308) + (t98 * t2311);
    const float t2317 = t30 * t2020;
    const float t2319 = (t27 * t2012) + (t2017 * t2317);
    const float t2322 = t30 * t2235;
    const float t2325 = (t1253 * t2319) + (t2254 * t2322) - (t2231 * t2317);
    const float t2327 = t26 * t1383;
    const float t2328 = t1380 * t2327;
    const float t2330 = t1357 * t1380;
    const float t2332 = t1348 * t1380;
    const float t2335 = (t98 * t2332) - (t91 * t2328) - (t92 * t2330);
    const float t2336 = t27 * motion->constants[28];
    const float t2337 = t1417 * t2336;
    const float t2339 = t1348 * t2336;
    const float t2340 = t30 * motion->constants[28];
    const float t2341 = t1357 * t2340;
    const float t2342 = t2339 + t2341;
    const float t2344 = t1417 * t2340;
    const float t2347 = (t2302 * t2342) - (t2278 * t2337) - (t2325 * t2344);
    const float t2350 = t1281 * motion->constants[31];
    const float t2352 = t1620 - t1619;
    const float t2356 = (t12 * t2350) + (t7 * t2352);
    const float t2359 = motion->constants[42] + motion->constants[19];
    const float t2361 = (t1357 * t2359) - t1518;
    const float t2364 = t1514 - (motion->constants[40] * t1352);
    const float t2366 = (cos_delta * t2364) - (sin_delta * t2361);
    const float t2368 = t1288 + t2366 - (motion->constants[35] * t1273);
    const float t2370 = motion->constants[32] * t1273;
    const float t2371 = motion->constants[41] * t1352;
    const float t2374 = t1572 - (t1348 * t2359);
    const float t2376 = (cos_delta * t2371) - (sin_delta * t2374);
    const float t2380 = (motion->constants[40] * t1348) - t1570 - t1572;
    const float t2381 = cos_delta * t2380;
    const float t2384 = t2370 + (cos_delta * t2376) - (sin_delta * t2381);
    const float t2388 = (t12 * t2368) - (t7 * t2384);
    const float t2396 = (motion->constants[35] * t1281) + (sin_delta * t2376) + (cos_delta *
        t2381) - t1278 - t1283;
    const float t2398 = t1548 + t1548;
    const float t2400 = t1539 - t1538;
    const float t2402 = (sin_delta * t2398) + (cos_delta * t2400);
    const float t2404 = t1348 * motion->constants[39];
    const float t2405 = motion->constants[38] * t1357;
    const float t2406 = t2404 + t2405;
    const float t2409 = (cos_delta * t1535) - (sin_delta * t2406);
    const float t2412 = t1535 + t1535;
    const float t2414 = (cos_delta * t2404) + (sin_delta * t2412);
    const float t2417 = motion->constants[24] * t1281;
    const float t2419 = cos_delta * speeds[1];
    const float t2421 = sin_delta * speeds[1];
    const float t2425 = t1353 + t1386;
    const float t2427 = (speeds[1] * t1415) - t1353 - t2425;
    const float t2431 = t1406 + t1422;
    const float t2434 = (speeds[1] * t2280) + t2431 - t1405 - (t1357 * t2336);
    const float t2436 = (cos_delta * t2434) - (sin_delta * t2427);
    const float t2441 = t1348 * motion->constants[27];
    const float t2442 = motion->constants[26] * t1357;
    const float t2447 = t2441 + t2442 - (speeds[1] * motion->constants[27]) - (speeds[1] * t1376);
    const float t2450 = t1358 + t1389;
    const float t2451 = (t1367 * t1372) + t2450;
    const float t2456 = (cos_delta * t1306) + (t301 * t2281) + (cos_delta * t2451) - (sin_delta *
        t2417) - (sin_delta * t2447);
    const float t2461 = t1358 + t2450;
    const float t2463 = t1372 * t1415;
    const float t2464 = motion->constants[27] + t1376;
    const float t2468 = t2339 + t2441 - t2463 - (speeds[1] * t2464);
    const float t2473 = (sin_delta * t1306) + (t301 * t2304) + (cos_delta * t2417) + (sin_delta *
        t2461) + (cos_delta * t2468);
    const float t2475 = t30 * t1380;
    const float t2476 = cos_delta * t2475;
    const float t2478 = t1323 - t1322;
    const float t2481 = t2110 + t2278 + (t1144 * t1206);
    const float t2487 = (t2098 * t2352) + (t2010 * t2356) + (t1214 * t2388) + (t2106 * t2402) +
        (t2068 * t2409) + (t2087 * t2414);
    const float t2492 = t2487 + (t1306 * t2137) + (t2093 * t2417) + (t301 * t2144) + (t2278 *
        t2436) + (t2302 * t2456);
    const float t2497 = t2492 + (t2325 * t2473) + (t2347 * t2476) + (t2478 * t2481) - (t74 *
        t1638) - (t2031 * t2350);
    const float t2502 = t2497 - (t7 * t2368) - (t12 * t2384) - (t1206 * t2396) - (t2166 * t2419) -
        (t2181 * t2421);
    const float t2505 = t1618 + t1620;
    const float t2507 = motion->constants[30] * t1277;
    const float t2509 = t2370 + t2371;
    const float t2513 = (t7 * t2507) - (t12 * t2505);
    const float t2518 = (motion->constants[43] * t1352) - t1514;
    const float t2522 = t1517 + t1518 - (motion->constants[43] * t1357);
    const float t2526 = (motion->constants[36] * t1273) + (cos_delta * t2518) - t1288 - (sin_delta *
        t2522);
    const float t2530 = (t12 * t2509) + (t7 * t2526);
    const float t2538 = t1477 + t1478 + (sin_delta * t2518) + (cos_delta * t2522) -
        (motion->constants[36] * t1277);
    const float t2541 = t1537 + t1539;
    const float t2544 = t1321 + t1323;
    const float t2548 = t2341 + t2442 - t2463;
    const float t2555 = t2425 + (cos_delta * t1304) + (t1372 * t1376) + (sin_delta * t2544);
    const float t2563 = (sin_delta * t1304) - t1404 - t2431 - (cos_delta * t2544) - (t1348 * t2340);
    const float t2565 = t27 * t1380;
    const float t2567 = motion->constants[23] * t1277;
    const float t2571 = (cos_delta * t1415) + (sin_delta * t2280);
    const float t2576 = t2054 + (cos_delta * motion->constants[27]) + (cos_delta * t1376);
    const float t2579 = t2060 + (sin_delta * t2464);
    const float t2582 = (t2302 * t2576) + (t2325 * t2579) - (t2278 * t2571);
    const float t2588 = (t2031 * t2505) + (t2098 * t2507) + (t7 * t2509) + (t2010 * t2513) +
        (t2106 * t2405) + (t1548 * t2068);
    const float t2593 = t2588 + (t1304 * t2137) + (t2278 * t2548) + (t2302 * t2555) + (t2325 *
        t2563) + (t2347 * t2565);
    const float t2598 = t2593 + (t2481 * t2567) + (t301 * t2582) - (t74 * t1622) - (t12 * t2526) -
        (t1214 * t2530);
    const float t2602 = t2598 - (t1206 * t2538) - (t2087 * t2541) - (t2093 * t2544) - (t301 *
        t2188);
    const float t2604 = motion->constants[19] * t1854;
    const float t2606 = motion->constants[19] * t1357;
    const float t2608 = motion->constants[19] * t1348;
    const float t2609 = cos_delta * t2608;
    const float t2613 = (t12 * t2606) + (t7 * t2609);
    const float t2615 = sin_delta * t2608;
    const float t2618 = t1386 + (t1348 * t1415);
    const float t2622 = (t1348 * t1376) + (t1357 * t1367);
    const float t2625 = t1389 + (t1357 * t1415);
    const float t2631 = (t12 * t2609) + (t1214 * t2613) + (t1206 * t2615) + (t2302 * t2622) - (t7 *
        t2606) - (t2278 * t2618);
    const float t2632 = t2631 - (t2325 * t2625);
    const float t2634 = (speeds[2] * t2632) - (t1253 * t2604);
    const float t2636 = motion->constants[19] * t1856;
    const float t2637 = t820 * t2636;
    const float t2640 = (t824 * t2632) - (t1253 * t2637);
    const float t2645 = cos_phi * t302;
    const float t2648 = (t146 * t1339) + (t1170 * t2645) - (sin_phi * t1292);
    const float t2650 = sin_phi * speeds[0];
    const float t2653 = cos_phi * speeds[0];
    const float t2656 = (t1170 * t2650) + (cos_phi * t1332) + (t74 * t2653);
    const float t2658 = (t7 * t2648) + (t12 * t2656);
    const float t2662 = (t12 * t2648) - (t7 * t2656);
    const float t2668 = (t74 * t2645) - (t146 * t1275) - (cos_phi * t1292);
    const float t2672 = (t12 * motion->constants[30]) + (t7 * motion->constants[31]);
    const float t2676 = (t74 * motion->constants[34]) - t2137 - t2211 - (t1214 * t2672);
    const float t2678 = t12 * t2650;
    const float t2681 = t7 * t2650;
    const float t2684 = sin_delta * t2653;
    const float t2686 = cos_delta * t2653;
    const float t2690 = (motion->constants[23] * t2653) + (t2280 * t2686) - t2662 - (t1415 * t2684);
    const float t2697 = t2658 - (motion->constants[24] * t2653);
    const float t2702 = (motion->constants[27] * t2684) + (t1376 * t2684) + (cos_delta * t2668) +
        (t2281 * t2678) - (sin_delta * t2697);
    const float t2710 = (sin_delta * t2668) + (t2304 * t2678) + (cos_delta * t2697) - (t2464 *
        t2686);
    const float t2715 = t1638 + t1638;
    const float t2717 = t1622 + t1622;
    const float t2721 = (t12 * t2715) + (t7 * t2717);
    const float t2726 = (cos_delta * t2361) + (sin_delta * t2364);
    const float t2728 = (t1277 * t2205) + t2726 - t1478;
    const float t2733 = (sin_delta * t2371) + (cos_delta * t2374);
    const float t2735 = sin_delta * t2380;
    const float t2739 = t1283 + (cos_delta * t2733) - (t1281 * t2205) - (sin_delta * t2735);
    const float t2743 = (t12 * t2728) - (t7 * t2739);
    const float t2747 = (sin_delta * t2733) + (cos_delta * t2735);
    const float t2751 = (sin_delta * t2400) - (cos_delta * t2398);
    const float t2755 = (sin_delta * t1535) + (cos_delta * t2406);
    const float t2759 = (sin_delta * t2404) - (cos_delta * t2412);
    const float t2761 = t2417 + t2567;
    const float t2763 = t1306 + t1306;
    const float t2769 = (cos_delta * t2427) + (sin_delta * t2434);
    const float t2777 = (cos_delta * t2761) + (sin_delta * t2763) + (cos_delta * t2447) +
        (sin_delta * t2451);
    const float t2785 = (sin_delta * t2761) + (sin_delta * t2468) - (cos_delta * t2763) -
        (cos_delta * t2461);
    const float t2787 = sin_delta * t2475;
    const float t2789 = t1304 + t1304;
    const float t2795 = (t2031 * t2715) + (t1214 * t2743) + (t2106 * t2751) + (t2068 * t2755) +
        (t2087 * t2759) + (t2137 * t2761);
    const float t2800 = t2795 + (t2181 * t2419) + (t2278 * t2769) + (t2302 * t2777) + (t2325 *
        t2785) + (t2347 * t2787);
    const float t2804 = t2800 - (t74 * (t2350 + t2507)) - (t2098 * t2717) - (t2010 * t2721) - (t7 *
        t2728);
    const float t2809 = t2804 - (t12 * t2739) - (t1206 * t2747) - (t2093 * t2763) - (t2166 *
        t2421) - (t2481 * t2789);
    const float t2817 = (t2096 * t2658) + (t2144 * t2678) + (t2278 * t2690) + (t2302 * t2702) +
        (t2325 * t2710) + (t2582 * t2681);
    const float t2822 = t2817 + (t16 * t2502) - (t2113 * t2662) - (t2668 * t2676) - (t2225 *
        t2653) - (t2188 * t2681);
    const float t2824 = t2822 - (sin_phi * t2809) - (t13 * t2602);
    const float t2828 = (t1854 * t2231) + (speeds[2] * t2824) + (t841 * t2634);
    const float t2834 = (t1856 * t2231) + (speeds[1] * t2824) + (t840 * t2640);
    const float t2836 = t74 * t1856;
    const float t2838 = speeds[0] * t1170;
    const float t2841 = t1292 + (t1170 * t1275);
    const float t2843 = (t12 * t2838) + (t7 * t2841);
    const float t2845 = (speeds[1] * t2843) - (t12 * t2836);
    const float t2850 = (t7 * t2838) - (t12 * t2841);
    const float t2851 = speeds[1] * t2850;
    const float t2852 = (t7 * t2836) - t2851;
    const float t2854 = t74 * t1275;
    const float t2855 = speeds[1] * t2854;
    const float t2857 = speeds[1] * t1277;
    const float t2860 = speeds[1] * t1281;
    const float t2867 = (cos_delta * t2854) + (t1277 * t2281) - (sin_delta * t2843);
    const float t2868 = speeds[1] * t2867;
    const float t2874 = (sin_delta * t2854) + (t1277 * t2304) + (cos_delta * t2843);
    const float t2875 = speeds[1] * t2874;
    const float t2885 = (t2096 * t2845) + (t2144 * t2857) + (t1856 * t2225) + (t2278 * t2851) +
        (t2302 * t2868) + (t2325 * t2875);
    const float t2890 = t2885 + (t2582 * t2860) + (speeds[1] * t2809) + (t515 * t2834) - (t2113 *
        t2852) - (t2676 * t2855);
    const float t2892 = t2890 - (t2188 * t2860) - (t848 * t2640);
    const float t2898 = (t855 * t2640) + (t523 * t2834) + (t81 * t2892);
    const float t2900 = t1466 * t2012;
    const float t2904 = motion->constants[19] * t1860;
    const float t2908 = (speeds[0] * t2632) - t1948 - (t1253 * t2904);
    const float t2912 = (t865 * t2634) + (t539 * t2640) + (t868 * t2908) - (t1253 * t2900);
    const float t2914 = t1462 * t2012;
    const float t2919 = (t141 * t2640) + (t877 * t2908) - (t1253 * t2914);
    const float t2921 = t466 * t1466;
    const float t2922 = t2017 * t2921;
    const float t2937 = (t7 * t1982) + (t12 * t2007);
    const float t2943 = t1667 + (motion->constants[31] * t1908) + (motion->constants[30] * t1932) +
        (motion->constants[33] * t1895) + (motion->constants[18] * t1897) + (sin_delta * t1923);
    const float t2947 = t2943 + (cos_delta * t1952) + (motion->constants[24] * t2004) -
        (motion->constants[23] * t1979) - (t74 * t2937);
    const float t2955 = (sin_phi * t2947) + (cos_phi * ((t12 * t1998) + (t1170 * t2937) - (t7 *
        t1973)));
    const float t2961 = t2955 + (t1860 * t2231) + (speeds[0] * t2824) + (t841 * t2908);
    const float t2966 = (t2231 * t2921) + (t532 * t2828) + (t540 * t2834) + (t543 * t2961) -
        (t1253 * t2922);
    const float t2968 = t466 * t1462;
    const float t2969 = t2017 * t2968;
    const float t2976 = (t2231 * t2968) + (t551 * t2834) + (t553 * t2961) - (t1253 * t2969);
    const float t2981 = t74 * t1860;
    const float t2984 = (speeds[0] * t2843) - (t12 * t2981);
    const float t2987 = speeds[0] * t2850;
    const float t2988 = (t7 * t2981) - t2987;
    const float t2990 = speeds[0] * t2854;
    const float t2992 = speeds[0] * t1277;
    const float t2995 = speeds[0] * t1281;
    const float t2998 = speeds[0] * t2867;
    const float t3000 = speeds[0] * t2874;
    const float t3010 = (t2096 * t2984) + (t2144 * t2992) + (t1860 * t2225) + (t2278 * t2987) +
        (t2302 * t2998) + (t2325 * t3000);
    const float t3015 = t3010 + (t2582 * t2995) + (speeds[0] * t2809) + (t515 * t2961) - t2947 -
        (t2113 * t2988);
    const float t3018 = t3015 - (t2676 * t2990) - (t2188 * t2995) - (t896 * t2908);
    const float t3028 = (t892 * t2640) + (t557 * t2834) + (t104 * t2892) + (t53 * t3018) + (t575 *
        t2919) + (t563 * t2976);
    const float t3030 = t3028 - (t123 * t2912) - (t36 * t2966);
    const float t3032 = t142 * t1462;
    const float t3046 = (t570 * t2834) + (t144 * t2892) + (t36 * t2912) + (t575 * t2976) - (t2254 *
        t3032) - (t913 * t2640);
    const float t3049 = t3046 - (t149 * t3018) - (t563 * t2919) - (t123 * t2966);
    const float t3053 = (t1596 * t2012) + (t939 * t2636);
    const float t3055 = t30 * t1412;
    const float t3059 = (t30 * t1374) - (t27 * t1378);
    const float t3061 = t27 * t1412;
    const float t3070 = (t1253 * t3053) + (t2302 * t3059) + (t2325 * t3061) - (t2278 * t3055) -
        (t940 * t2632) - (t945 * t2634);
    const float t3071 = t3070 - (t951 * t2908);
    const float t3077 = (t1170 * t1982) + (t1214 * t1998) + (t2007 * t2010) + (t1874 * t2144) +
        (t1860 * t2188) + (t2026 * t2231);
    const float t3082 = t3077 + (t2241 * t2254) + (t2294 * t2302) + (t2315 * t2325) + (t2335 *
        t2347) + (speeds[0] * t2502);
    const float t3087 = t3082 + (t822 * t2634) + (t836 * t2640) + (t468 * t2828) + (t508 * t2834) +
        (t69 * t2892);
    const float t3092 = t3087 + (motion->constants[24] * t2898) + (t864 * t2912) + (t550 * t2976) +
        (t120 * t3049) + (t930 * t3071);
    const float t3098 = t3092 - t1973 - (t1253 * t2029) - (t1902 * t2096) - (t1906 * t2113) -
        (t2268 * t2278) - (t1275 * t2602);
    const float t3101 = t3098 - (t875 * t2919) - (t530 * t2966) - (t103 * t3030);
    const float t3115 = (t28 * t466 * t1457) + (t170 * t2018) + (t172 * t2021) + (t174 * t2023);
    const float t3118 = (t172 * t2013) - (t174 * t2015) - (t2017 * t3115);
    const float t3132 = (t28 * t53 * t1399) + (t172 * t2236) + (t174 * t2238) - (t170 * t2233);
    const float t3134 = t28 * motion->constants[22];
    const float t3140 = t1335 + (t1378 * t3134) + (t172 * t2259) - (t174 * t2265);
    const float t3146 = (t172 * t2286) + (t174 * t2290) - (sin_delta * t1342);
    const float t3154 = (cos_delta * t1342) + (t174 * t2311) - (t1374 * t3134) - (t172 * t2308);
    const float t3162 = (t28 * t2327) + (t170 * t2328) + (t172 * t2330) + (t174 * t2332);
    const float t3184 = (t1982 * t2010) + (t1906 * t2096) + (t1860 * t2144) + (t2254 * t3132) +
        (t2278 * t3140) + (t2302 * t3146);
    const float t3189 = t3184 + (t2325 * t3154) + (t2347 * t3162) + (t1303 * t2582) + (t1275 *
        t2502) + (speeds[0] * t2602);
    const float t3194 = t3189 + (t969 * t2634) + (t977 * t2640) + (t590 * t2828) + (t602 * t2834) +
        (t160 * t2892);
    const float t3199 = t3194 + (t985 * t2912) + (t612 * t2976) + (t180 * t3030) + (t190 * t3049) -
        t1998;
    const float t3204 = t3199 - (t1170 * t2007) - (t1214 * t1973) - (t1253 * t3118) - (t1902 *
        t2113) - (t1874 * t2188);
    const float t3209 = t3204 - (t2231 * t3115) - (motion->constants[23] * t2898) - (t989 * t2919) -
        (t608 * t2966) - (t995 * t3071);
    const float t3211 = t7 * t1966;
    const float t3212 = motion->constants[38] * t1895;
    const float t3213 = sin_delta * t3212;
    const float t3215 = t12 * t1966;
    const float t3217 = t3215 + (t7 * t3213);
    const float t3220 = (cos_delta * t3212) - t1979;
    const float t3222 = motion->constants[37] * t1895;
    const float t3224 = t1273 * t1277;
    const float t3225 = t1882 + t3224;
    const float t3227 = t1273 * t1273;
    const float t3228 = t1281 * t1281;
    const float t3229 = t3227 + t3228;
    const float t3232 = t1311 + t3224;
    const float t3235 = (cos_delta * t3232) + (sin_delta * t3229);
    const float t3239 = (sin_delta * t3232) - (cos_delta * t3229);
    const float t3241 = t1277 * t1281;
    const float t3253 = (t12 * t3213) + (t1214 * t3217) + (t2137 * t3225) + (t1326 * t2278) +
        (t2302 * t3235) + (t2325 * t3239);
    const float t3258 = t3253 + (t2481 * t3241) + (t1027 * t2640) + (t80 * t3030) + (t12 * t3049) -
        t3211;
    const float t3263 = t3258 - (t1206 * t3220) - (t2106 * t3222) - (t2093 * t3229) - (t641 *
        t2834) - (t205 * t2892);
    const float t3264 = t3263 - (t7 * t2898);
    const float t3268 = motion->constants[16] - t239;
    const float t3272 = (motion->constants[2] * t3268) + (motion->constants[3] *
        motion->constants[17]);
    const float t3273 = motion->constants[15] * t3272;
    const float t3274 = t3273 + t3273;
    const float t3275 = t1352 * t1357;
    const float t3276 = t7 * t3275;
    const float t3277 = t1348 * t1352;
    const float t3278 = cos_delta * t3277;
    const float t3280 = t3278 + (sin_delta * t1939);
    const float t3282 = t12 * t3275;
    const float t3284 = t3282 + (t7 * t3280);
    const float t3286 = sin_delta * t3277;
    const float t3288 = (cos_delta * t1939) - t3286;
    const float t3292 = (t12 * t3280) + (t1214 * t3284) - t3276 - (t1206 * t3288);
    const float t3296 = (motion->constants[3] * t3268) - (motion->constants[2] *
        motion->constants[17]);
    const float t3297 = motion->constants[15] * t3296;
    const float t3298 = t3277 - t1917;
    const float t3300 = t1919 + t3275;
    const float t3302 = t1348 * t1348;
    const float t3303 = t1357 * t1357;
    const float t3304 = t3302 - t3303;
    const float t3306 = (cos_delta * t3300) - (sin_delta * t3304);
    const float t3310 = (t12 * t3298) + (t7 * t3306);
    const float t3314 = (sin_delta * t3300) + (cos_delta * t3304);
    const float t3318 = (t12 * t3306) + (t1214 * t3310) + (t1206 * t3314) - (t7 * t3298);
    const float t3321 = t1348 * t1357;
    const float t3322 = sin_delta * t3321;
    const float t3323 = (cos_delta * t1917) - t3322;
    const float t3326 = t3282 + (t7 * t3323);
    const float t3329 = cos_delta * t3321;
    const float t3330 = (sin_delta * t1917) + t3329;
    const float t3334 = t3276 - (t12 * t3323) - (t1214 * t3326) - (t1206 * t3330);
    const float t3338 = (cos_delta * t1912) + (sin_delta * t1927);
    const float t3340 = t7 * t3338;
    const float t3344 = (cos_delta * t1927) - (sin_delta * t1912);
    const float t3346 = t1352 * t1352;
    const float t3347 = t3303 + t3346;
    const float t3350 = t1939 + t3321;
    const float t3356 = (t12 * t3338) + (t1214 * t3340) + (t2068 * t3298) + (t2087 * t3350) -
        (t1206 * t3344) - (t2106 * t3347);
    const float t3360 = (t3274 * t3292) + (t3297 * t3318) + (t3274 * t3334) +
        (motion->constants[15] * t3356);
    const float t3362 = t3297 + t3297;
    const float t3364 = t3278 + t3322;
    const float t3368 = (t12 * t1919) - (t7 * t3364);
    const float t3370 = t3286 - t3329;
    const float t3374 = (t1214 * t3368) - (t7 * t1919) - (t12 * t3364) - (t1206 * t3370);
    const float t3379 = sin_delta * t1934;
    const float t3383 = (t12 * t1912) - (t7 * t3379);
    const float t3385 = cos_delta * t1934;
    const float t3387 = t3321 - t1939;
    const float t3390 = t3302 + t3346;
    const float t3396 = (t1214 * t3383) + (t1206 * t3385) + (t2106 * t3387) + (t2068 * t3300) -
        (t7 * t1912) - (t12 * t3379);
    const float t3397 = t3396 - (t2087 * t3390);
    const float t3401 = (t3362 * t3374) + (t3292 * t3362) + (t3273 * t3318) +
        (motion->constants[15] * t3397);
    const float t3403 = (motion->constants[2] * t3360) + (motion->constants[3] * t3401);
    const float t3406 = t1273 * t1281;
    const float t3407 = t3406 - t1877;
    const float t3409 = t1895 + t3241;
    const float t3411 = t1314 + t3406;
    const float t3413 = t3241 - t1326;
    const float t3415 = (cos_delta * t3411) - (sin_delta * t3413);
    const float t3419 = (sin_delta * t3411) + (cos_delta * t3413);
    const float t3421 = t1277 * t1277;
    const float t3422 = t3227 + t3421;
    const float t3430 = (t66 * t3030) - (t7 * t3049);
    const float t3435 = t3215 + (t1214 * t3211) + (t2137 * t3407) + (t2093 * t3409) + (t2302 *
        t3415) + (t2325 * t3419);
    const float t3440 = t3435 + (t1012 * t2640) + (t627 * t2834) + (t12 * t2898) - (t1206 * t2004) -
        (t2481 * t3422);
    const float t3442 = t3440 - (t196 * t2892) - t3430;
    const float t3445 = (motion->constants[3] * t3264) + (motion->constants[2] * t3442) - t3403;
    const float t3447 = (t157 * t3209) + t3445 - (t58 * t3101);
    const float t3452 = (t1170 * t1712) + (t74 * t1710);
    const float t3463 = (t1712 * t2058) + (t1710 * t2060) - (t1247 * t3452);
    const float t3469 = (t1712 * t2078) + (t94 * t3452) - (t1710 * t2054);
    const float t3474 = t1171 + (t2070 * t3469) - (t1712 * t2043) - (t1710 * t2047) - (t2049 *
        t3463);
    const float t3476 = (t2034 * t3452) + t3474 - (motion->constants[31] * t1710);
    const float t3483 = (motion->constants[23] * t1710) + (t7 * t3452);
    const float t3485 = (t1706 * t1712) - (motion->constants[37] * t3483);
    const float t3487 = t3485 - (t1182 * t1710) - (t2101 * t3452);
    const float t3499 = (t1712 * t2128) + (t2070 * t3463) + (t2049 * t3469) - t1144 - (t1710 *
        t2040);
    const float t3504 = (t1712 * t2121) + (motion->constants[38] * t3463) + (motion->constants[23] *
        t3499) - motion->constants[43] - (t1191 * t1710);
    const float t3515 = t1754 + (t1712 * t2159) + (motion->constants[39] * t3469) - (t1710 *
        t2156) - (motion->constants[38] * t3483);
    const float t3522 = (t1712 * t2175) - motion->constants[41] - (t1710 * t2171) -
        (motion->constants[39] * t3463);
    const float t3526 = (t1712 * t2151) + (cos_delta * t3522) - (motion->constants[24] * t3499) -
        (sin_delta * t3515);
    const float t3542 = (t1712 * t2203) + (t2211 * t3452) + (motion->constants[24] * t3474) +
        (cos_delta * t3515) + (sin_delta * t3522) - (t1710 * t2207);
    const float t3543 = t3542 - (motion->constants[46] * t3483);
    const float t3549 = (t2195 * t3487) + (t16 * t3526) - (t2193 * t3476) - (t13 * t3504) -
        (sin_phi * t3543);
    const float t3558 = t3543 + (t1736 * t2244) + (t2246 * t3487) + (t515 * t3549) - (t2248 *
        t3476);
    const float t3564 = (t1736 * t2272) + (t2275 * t3558) - (t2270 * t3549);
    const float t3570 = (t1736 * t2296) + (t2295 * t3549) + (t2299 * t3558);
    const float t3576 = (t2322 * t3558) - (t1736 * t2319) - (t2317 * t3549);
    const float t3582 = (t2342 * t3570) - (t2337 * t3564) - (t2344 * t3576);
    const float t3601 = t3564 + (t1144 * t1710) - t3485;
    const float t3607 = (t2356 * t3452) + (t1712 * t2388) + (t2402 * t3483) + (t2409 * t3463) +
        (t2414 * t3469) + (t1306 * t3499);
    const float t3612 = t3607 + (t2417 * t3474) + (t301 * t3504) + (t2436 * t3564) + (t2456 *
        t3570) + (t2473 * t3576);
    const float t3617 = t3612 + (t2476 * t3582) + (t2478 * t3601) - t2366 - (t1710 * t2396) -
        (t2419 * t3515);
    const float t3618 = t3617 - (t2421 * t3522);
    const float t3638 = (t2576 * t3570) + (t2579 * t3576) - (t2571 * t3564);
    const float t3644 = t2371 + (t2513 * t3452) + (t2405 * t3483) + (t1548 * t3463) + (t1304 *
        t3499) + (t2548 * t3564);
    const float t3649 = t3644 + (t2555 * t3570) + (t2563 * t3576) + (t2565 * t3582) + (t2567 *
        t3601) + (t301 * t3638);
    const float t3654 = t3649 - (t1712 * t2530) - (t1710 * t2538) - (t2541 * t3469) - (t2544 *
        t3474) - (t301 * t3526);
    const float t3666 = (t1712 * t2613) + (t1710 * t2615) + (t2622 * t3570) - t2606 - (t2618 *
        t3564) - (t2625 * t3576);
    const float t3668 = (t1736 * t2604) + (speeds[2] * t3666);
    const float t3674 = (t1736 * t2637) + (t824 * t3666) - (t820 * t1948);
    const float t3680 = t3499 + (t1712 * t2672);
    const float t3708 = (t1712 * t2743) + (t2751 * t3483) + (t2755 * t3463) + (t2759 * t3469) +
        (t2761 * t3499) + (t2419 * t3522);
    const float t3713 = t3708 + (t2769 * t3564) + (t2777 * t3570) + (t2785 * t3576) + (t2787 *
        t3582) - t2726;
    const float t3718 = t3713 - (t2721 * t3452) - (t1710 * t2747) - (t2763 * t3474) - (t2421 *
        t3515) - (t2789 * t3601);
    const float t3726 = (t2658 * t3476) + (t2662 * t3487) + (t2668 * t3680) + (t2678 * t3504) +
        (t2690 * t3564) + (t2702 * t3570);
    const float t3731 = t3726 + (t2710 * t3576) + (t2681 * t3638) + (t16 * t3618) - (t2653 *
        t3543) - (t2681 * t3526);
    const float t3733 = t3731 - (sin_phi * t3718) - (t13 * t3654);
    const float t3737 = (t1854 * t3549) + (speeds[2] * t3733) + (t841 * t3668);
    const float t3744 = t2955 + (t1856 * t3549) + (speeds[1] * t3733) + (t840 * t3674);
    const float t3763 = (t2845 * t3476) + (t2852 * t3487) + (t2855 * t3680) + (t2857 * t3504) +
        (t1856 * t3543) + (t2851 * t3564);
    const float t3768 = t3763 + (t2868 * t3570) + (t2875 * t3576) + (t2860 * t3638) + (speeds[1] *
        t3718) + (t515 * t3744);
    const float t3771 = t3768 - t2947 - (t2860 * t3526) - (t848 * t3674);
    const float t3777 = (t855 * t3674) + (t523 * t3744) + (t81 * t3771);
    const float t3784 = (t1736 * t2904) + (speeds[0] * t3666);
    const float t3788 = (t1736 * t2900) + (t865 * t3668) + (t539 * t3674) + (t868 * t3784);
    const float t3794 = (t1736 * t2914) + (t141 * t3674) + (t877 * t3784);
    const float t3804 = (t1860 * t3549) + (speeds[0] * t3733) + (t841 * t3784);
    const float t3809 = (t1736 * t2922) + (t2921 * t3549) + (t532 * t3737) + (t540 * t3744) +
        (t543 * t3804);
    const float t3817 = (t1736 * t2969) + (t2968 * t3549) + (t551 * t3744) + (t553 * t3804);
    const float t3839 = (t2984 * t3476) + (t2988 * t3487) + (t2990 * t3680) + (t2992 * t3504) +
        (t1860 * t3543) + (t2987 * t3564);
    const float t3844 = t3839 + (t2998 * t3570) + (t3000 * t3576) + (t2995 * t3638) + (speeds[0] *
        t3718) + (t515 * t3804);
    const float t3846 = t3844 - (t2995 * t3526) - (t896 * t3784);
    const float t3856 = (t892 * t3674) + (t557 * t3744) + (t104 * t3771) + (t53 * t3846) + (t575 *
        t3794) + (t563 * t3817);
    const float t3858 = t3856 - (t123 * t3788) - (t36 * t3809);
    const float t3873 = (t570 * t3744) + (t144 * t3771) + (t36 * t3788) + (t575 * t3817) - (t3032 *
        t3558) - (t913 * t3674);
    const float t3876 = t3873 - (t149 * t3846) - (t563 * t3794) - (t123 * t3809);
    const float t3890 = (t939 * t1948) + (t3059 * t3570) + (t3061 * t3576) - (t1736 * t3053) -
        (t3055 * t3564) - (t940 * t3666);
    const float t3892 = t3890 - (t945 * t3668) - (t951 * t3784);
    const float t3898 = (t1712 * t1998) + (t2007 * t3452) + (t1736 * t2029) + (t1906 * t3487) +
        (t1874 * t3504) + (t1860 * t3526);
    const float t3903 = t3898 + (t2026 * t3549) + (t2241 * t3558) + (t2294 * t3570) + (t2315 *
        t3576) + (t2335 * t3582);
    const float t3908 = t3903 + (speeds[0] * t3618) + (t822 * t3668) + (t836 * t3674) + (t468 *
        t3737) + (t508 * t3744);
    const float t3913 = t3908 + (t69 * t3771) + (motion->constants[24] * t3777) + (t864 * t3788) +
        (t550 * t3817) + (t120 * t3876);
    const float t3918 = t3913 + (t930 * t3892) - (t1902 * t3476) - (t2268 * t3564) - (t1275 *
        t3654) - (t875 * t3794);
    const float t3920 = t3918 - (t530 * t3809) - (t103 * t3858);
    const float t3955 = (t1982 * t3452) + (t1736 * t3118) + (t1906 * t3476) + (t1902 * t3487) +
        (t1860 * t3504) + (t3132 * t3558);
    const float t3960 = t3955 + (t3140 * t3564) + (t3146 * t3570) + (t3154 * t3576) + (t3162 *
        t3582) + (t1303 * t3638);
    const float t3965 = t3960 + (t1275 * t3618) + (speeds[0] * t3654) + (t969 * t3668) + (t977 *
        t3674) + (t590 * t3737);
    const float t3970 = t3965 + (t602 * t3744) + (t160 * t3771) + (t985 * t3788) + (t612 * t3817) +
        (t180 * t3858);
    const float t3975 = t3970 + (t190 * t3876) - (t1712 * t1973) - (t1874 * t3526) - (t3115 *
        t3549) - (motion->constants[23] * t3777);
    const float t3978 = t3975 - (t989 * t3794) - (t608 * t3809) - (t995 * t3892);
    const float t4000 = (t1712 * t3217) + (t3225 * t3499) + (t1326 * t3564) + (t3235 * t3570) +
        (t3239 * t3576) + (t3241 * t3601);
    const float t4005 = t4000 + (t1027 * t3674) + (t80 * t3858) + (t12 * t3876) - (t1710 * t3220) -
        (t3222 * t3483);
    const float t4009 = t4005 - (t3229 * t3474) - (t641 * t3744) - (t205 * t3771) - (t7 * t3777);
    const float t4014 = (t1712 * t3284) - t3275 - (t1710 * t3288);
    const float t4019 = t3298 - (t1712 * t3310) - (t1710 * t3314);
    const float t4024 = t3275 - (t1712 * t3326) - (t1710 * t3330);
    const float t4034 = (t1712 * t3340) + (t3298 * t3463) + (t3350 * t3469) - (t1710 * t3344) -
        (t3347 * t3483);
    const float t4038 = (t3274 * t4014) + (t3274 * t4024) + (motion->constants[15] * t4034) -
        (t3297 * t4019);
    const float t4043 = (t1712 * t3368) - t1919 - (t1710 * t3370);
    const float t4056 = (t1712 * t3383) + (t1710 * t3385) + (t3387 * t3483) + (t3300 * t3463) -
        t1912 - (t3390 * t3469);
    const float t4060 = (t3362 * t4043) + (t3362 * t4014) + (motion->constants[15] * t4056) -
        (t3273 * t4019);
    const float t4062 = (motion->constants[2] * t4038) + (motion->constants[3] * t4060);
    const float t4076 = (t66 * t3858) - (t7 * t3876);
    const float t4081 = (t1712 * t3211) + (t3407 * t3499) + (t3409 * t3474) + (t3415 * t3570) +
        (t3419 * t3576) + (t1012 * t3674);
    const float t4086 = t4081 + (t627 * t3744) + (t12 * t3777) - (t1710 * t2004) - (t3422 * t3601) -
        (t196 * t3771);
    const float t4087 = t4086 - t4076;
    const float t4090 = (motion->constants[3] * t4009) + (motion->constants[2] * t4087) - t4062;
    const float t4093 = (t157 * t3978) + t4090 - (t58 * t3920) - (t1747 * t3447);
    const float t4099 = t74 + (t1170 * t1781) - (t74 * t1779);
    const float t4110 = (t1781 * t2058) - (t1779 * t2060) - (t1247 * t4099);
    const float t4116 = (t1781 * t2078) + (t1779 * t2054) + (t94 * t4099);
    const float t4120 = (t1779 * t2047) + (t2070 * t4116) - (t1781 * t2043) - (t2049 * t4110);
    const float t4122 = (motion->constants[31] * t1779) + (t2034 * t4099) + t4120;
    const float t4129 = (t7 * t4099) - (motion->constants[23] * t1779);
    const float t4131 = (t1706 * t1781) - (motion->constants[37] * t4129);
    const float t4133 = (t1182 * t1779) + t4131 - (t2101 * t4099);
    const float t4144 = (t1781 * t2128) + (t1779 * t2040) + (t2070 * t4110) + (t2049 * t4116);
    const float t4148 = (t1191 * t1779) + (t1781 * t2121) + (motion->constants[38] * t4110) +
        (motion->constants[23] * t4144);
    const float t4159 = t1839 + (t1779 * t2156) + (t1781 * t2159) + (motion->constants[39] *
        t4116) - (motion->constants[38] * t4129);
    const float t4165 = (t1779 * t2171) + (t1781 * t2175) - (motion->constants[39] * t4110);
    const float t4169 = (t1781 * t2151) + (cos_delta * t4165) - (motion->constants[24] * t4144) -
        (sin_delta * t4159);
    const float t4185 = (t1781 * t2203) + (t1779 * t2207) + (t2211 * t4099) +
        (motion->constants[24] * t4120) + (cos_delta * t4159) + (sin_delta * t4165);
    const float t4187 = t4185 - motion->constants[18] - (motion->constants[46] * t4129);
    const float t4193 = (t2195 * t4133) + (t16 * t4169) - (t2193 * t4122) - (t13 * t4148) -
        (sin_phi * t4187);
    const float t4202 = t4187 + (t1800 * t2244) + (t2246 * t4133) + (t515 * t4193) - (t2248 *
        t4122);
    const float t4208 = (t1800 * t2272) + (t2275 * t4202) - (t2270 * t4193);
    const float t4214 = (t1800 * t2296) + (t2295 * t4193) + (t2299 * t4202);
    const float t4220 = (t2322 * t4202) - (t1800 * t2319) - (t2317 * t4193);
    const float t4226 = (t2342 * t4214) - (t2337 * t4208) - (t2344 * t4220);
    const float t4245 = t4208 - t4131 - (t1144 * t1779);
    const float t4251 = (t2356 * t4099) + (t1781 * t2388) + (t1779 * t2396) + (t2402 * t4129) +
        (t2409 * t4110) + (t2414 * t4116);
    const float t4256 = t4251 + (t1306 * t4144) + (t2417 * t4120) + (t301 * t4148) + (t2436 *
        t4208) + (t2456 * t4214);
    const float t4261 = t4256 + (t2473 * t4220) + (t2476 * t4226) + (t2478 * t4245) - (t2419 *
        t4159) - (t2421 * t4165);
    const float t4281 = (t2576 * t4214) + (t2579 * t4220) - (t2571 * t4208);
    const float t4287 = (t2513 * t4099) + (t2405 * t4129) + (t1779 * t2538) + (t1548 * t4110) +
        (t1304 * t4144) + (t2548 * t4208);
    const float t4292 = t4287 + (t2555 * t4214) + (t2563 * t4220) + (t2565 * t4226) + (t2567 *
        t4245) + (t301 * t4281);
    const float t4296 = t4292 - (t1781 * t2530) - (t2541 * t4116) - (t2544 * t4120) - (t301 *
        t4169);
    const float t4307 = (t1781 * t2613) + (t2622 * t4214) - (t1779 * t2615) - (t2618 * t4208) -
        (t2625 * t4220);
    const float t4310 = (t1800 * t2604) + (speeds[2] * t4307) - t1948;
    const float t4314 = (t1800 * t2637) + (t824 * t4307);
    const float t4320 = t4144 + (t1781 * t2672);
    const float t4348 = (t1781 * t2743) + (t1779 * t2747) + (t2751 * t4129) + (t2755 * t4110) +
        (t2759 * t4116) + (t2761 * t4144);
    const float t4353 = t4348 + (t2419 * t4165) + (t2769 * t4208) + (t2777 * t4214) + (t2785 *
        t4220) + (t2787 * t4226);
    const float t4357 = t4353 - (t2721 * t4099) - (t2763 * t4120) - (t2421 * t4159) - (t2789 *
        t4245);
    const float t4365 = (t2658 * t4122) + (t2662 * t4133) + (t2668 * t4320) + (t2678 * t4148) +
        (t2690 * t4208) + (t2702 * t4214);
    const float t4370 = t4365 + (t2710 * t4220) + (t2681 * t4281) + (t16 * t4261) - (t2653 *
        t4187) - (t2681 * t4169);
    const float t4372 = t4370 - (sin_phi * t4357) - (t13 * t4296);
    const float t4377 = t2955 + (t1854 * t4193) + (speeds[2] * t4372) + (t841 * t4310);
    const float t4383 = (t1856 * t4193) + (speeds[1] * t4372) + (t840 * t4314);
    const float t4402 = (t2845 * t4122) + (t2852 * t4133) + (t2855 * t4320) + (t2857 * t4148) +
        (t1856 * t4187) + (t2851 * t4208);
    const float t4407 = t4402 + (t2868 * t4214) + (t2875 * t4220) + (t2860 * t4281) + (speeds[1] *
        t4357) + (t515 * t4383);
    const float t4409 = t4407 - (t2860 * t4169) - (t848 * t4314);
    const float t4415 = (t855 * t4314) + (t523 * t4383) + (t81 * t4409);
    const float t4422 = (t1800 * t2904) + (speeds[0] * t4307);
    const float t4426 = (t1800 * t2900) + (t865 * t4310) + (t539 * t4314) + (t868 * t4422);
    const float t4432 = (t1800 * t2914) + (t141 * t4314) + (t877 * t4422);
    const float t4442 = (t1860 * t4193) + (speeds[0] * t4372) + (t841 * t4422);
    const float t4447 = (t1800 * t2922) + (t2921 * t4193) + (t532 * t4377) + (t540 * t4383) +
        (t543 * t4442);
    const float t4455 = (t1800 * t2969) + (t2968 * t4193) + (t551 * t4383) + (t553 * t4442);
    const float t4477 = (t2984 * t4122) + (t2988 * t4133) + (t2990 * t4320) + (t2992 * t4148) +
        (t1860 * t4187) + (t2987 * t4208);
    const float t4482 = t4477 + (t2998 * t4214) + (t3000 * t4220) + (t2995 * t4281) + (speeds[0] *
        t4357) + (t515 * t4442);
    const float t4484 = t4482 - (t2995 * t4169) - (t896 * t4422);
    const float t4494 = (t892 * t4314) + (t557 * t4383) + (t104 * t4409) + (t53 * t4484) + (t575 *
        t4432) + (t563 * t4455);
    const float t4496 = t4494 - (t123 * t4426) - (t36 * t4447);
    const float t4511 = (t570 * t4383) + (t144 * t4409) + (t36 * t4426) + (t575 * t4455) - (t3032 *
        t4202) - (t913 * t4314);
    const float t4514 = t4511 - (t149 * t4484) - (t563 * t4432) - (t123 * t4447);
    const float t4527 = (t3059 * t4214) + (t3061 * t4220) - (t1800 * t3053) - (t3055 * t4208) -
        (t940 * t4307) - (t945 * t4310);
    const float t4528 = t4527 - (t951 * t4422);
    const float t4534 = (t1781 * t1998) + (t2007 * t4099) + (t1800 * t2029) + (t1906 * t4133) +
        (t1874 * t4148) + (t1860 * t4169);
    const float t4539 = t4534 + (t2026 * t4193) + (t2241 * t4202) + (t2294 * t4214) + (t2315 *
        t4220) + (t2335 * t4226);
    const float t4544 = t4539 + (speeds[0] * t4261) + (t822 * t4310) + (t836 * t4314) + (t468 *
        t4377) + (t508 * t4383);
    const float t4549 = t4544 + (t69 * t4409) + (motion->constants[24] * t4415) + (t864 * t4426) +
        (t550 * t4455) + (t120 * t4514);
    const float t4554 = t4549 + (t930 * t4528) - (t1902 * t4122) - (t2268 * t4208) - (t1275 *
        t4296) - (t875 * t4432);
    const float t4556 = t4554 - (t530 * t4447) - (t103 * t4496);
    const float t4591 = (t1982 * t4099) + (t1800 * t3118) + (t1906 * t4122) + (t1902 * t4133) +
        (t1860 * t4148) + (t3132 * t4202);
    const float t4596 = t4591 + (t3140 * t4208) + (t3146 * t4214) + (t3154 * t4220) + (t3162 *
        t4226) + (t1303 * t4281);
    const float t4601 = t4596 + (t1275 * t4261) + (speeds[0] * t4296) + (t969 * t4310) + (t977 *
        t4314) + (t590 * t4377);
    const float t4606 = t4601 + (t602 * t4383) + (t160 * t4409) + (t985 * t4426) + (t612 * t4455) +
        (t180 * t4496);
    const float t4611 = t4606 + (t190 * t4514) - (t1781 * t1973) - (t1874 * t4169) - (t3115 *
        t4193) - (motion->constants[23] * t4415);
    const float t4614 = t4611 - (t989 * t4432) - (t608 * t4447) - (t995 * t4528);
    const float t4637 = (t1781 * t3217) + (t1779 * t3220) + (t3225 * t4144) + (t1326 * t4208) +
        (t3235 * t4214) + (t3239 * t4220);
    const float t4642 = t4637 + (t3241 * t4245) + (t1027 * t4314) + (t80 * t4496) + (t12 * t4514) -
        (t3222 * t4129);
    const float t4646 = t4642 - (t3229 * t4120) - (t641 * t4383) - (t205 * t4409) - (t7 * t4415);
    const float t4650 = (t1781 * t3284) + (t1779 * t3288);
    const float t4654 = (t1779 * t3314) - (t1781 * t3310);
    const float t4658 = (t1779 * t3330) - (t1781 * t3326);
    const float t4668 = (t1781 * t3340) + (t1779 * t3344) + (t3298 * t4110) + (t3350 * t4116) -
        (t3347 * t4129);
    const float t4672 = (t3274 * t4650) + (t3274 * t4658) + (motion->constants[15] * t4668) -
        (t3297 * t4654);
    const float t4676 = (t1781 * t3368) + (t1779 * t3370);
    const float t4688 = (t1781 * t3383) + (t3387 * t4129) + (t3300 * t4110) - (t1779 * t3385) -
        (t3390 * t4116);
    const float t4692 = (t3362 * t4676) + (t3362 * t4650) + (motion->constants[15] * t4688) -
        (t3273 * t4654);
    const float t4694 = (motion->constants[2] * t4672) + (motion->constants[3] * t4692);
    const float t4708 = (t66 * t4496) - (t7 * t4514);
    const float t4713 = (t1781 * t3211) + (t1779 * t2004) + (t3407 * t4144) + (t3409 * t4120) +
        (t3415 * t4214) + (t3419 * t4220);
    const float t4718 = t4713 + (t1012 * t4314) + (t627 * t4383) + (t12 * t4415) - (t3422 * t4245) -
        (t196 * t4409);
    const float t4719 = t4718 - t4708;
    const float t4722 = (motion->constants[3] * t4646) + (motion->constants[2] * t4719) - t4694;
    const float t4727 = t1853 * ((t157 * t4614) + t4722 - (t58 * t4556) - (t1813 * t3447) - (t1822 *
        t4093));
    const float t4729 = (t1765 * t4093) - (t1822 * t4727);
    const float t4733 = (t1266 * t3447) - (t1747 * t4729) - (t1813 * t4727);
    const float t4735 = t3277 - t1365;
    const float t4737 = t1412 + t3321;
    const float t4740 = motion->constants[27] * motion->constants[20];
    const float t4741 = t4740 + t4740;
    const float t4743 = motion->constants[26] * motion->constants[20];
    const float t4753 = (t2302 * t4735) + (t2325 * t4737) + (t3292 * t4741) + (t3318 * t4743) +
        (t3334 * t4741) + (t3356 * motion->constants[20]);
    const float t4757 = t4753 + (t1011 * t2640) + (t626 * t2834) - t3430 - (t2278 * t3347);
    const float t4759 = t3321 - t1412;
    const float t4761 = t1311 + t3275;
    const float t4764 = t4743 + t4743;
    const float t4777 = (t2278 * t4759) + (t2302 * t4761) + (t3374 * t4764) + (t3292 * t4764) +
        (t3318 * t4740) + (t3397 * motion->constants[20]);
    const float t4782 = t4777 + (t1048 * t2640) + (t658 * t2834) + (t115 * t3030) + (t94 * t3049) -
        (t2325 * t3390);
    const float t4789 = t3445 + (t230 * t3209) - (motion->constants[2] * t4757) -
        (motion->constants[3] * t4782) - (t228 * t3101);
    const float t4804 = (t3570 * t4735) + (t3576 * t4737) + (t4014 * t4741) + (t4024 * t4741) +
        (t4034 * motion->constants[20]) + (t1011 * t3674);
    const float t4808 = t4804 + (t626 * t3744) - t4076 - (t3347 * t3564) - (t4019 * t4743);
    const float t4825 = (t3564 * t4759) + (t3570 * t4761) + (t4043 * t4764) + (t4014 * t4764) +
        (t4056 * motion->constants[20]) + (t1048 * t3674);
    const float t4830 = t4825 + (t658 * t3744) + (t115 * t3858) + (t94 * t3876) - (t3390 * t3576) -
        (t4019 * t4740);
    const float t4839 = t4090 + (t230 * t3978) - (motion->constants[2] * t4808) -
        (motion->constants[3] * t4830) - (t228 * t3920) - (t1747 * t4789);
    const float t4854 = (t4214 * t4735) + (t4220 * t4737) + (t4650 * t4741) + (t4658 * t4741) +
        (t4668 * motion->constants[20]) + (t1011 * t4314);
    const float t4858 = t4854 + (t626 * t4383) - t4708 - (t3347 * t4208) - (t4654 * t4743);
    const float t4875 = (t4208 * t4759) + (t4214 * t4761) + (t4676 * t4764) + (t4650 * t4764) +
        (t4688 * motion->constants[20]) + (t1048 * t4314);
    const float t4880 = t4875 + (t658 * t4383) + (t115 * t4496) + (t94 * t4514) - (t3390 * t4220) -
        (t4654 * t4740);
    const float t4890 = t4722 + (t230 * t4614) - (motion->constants[2] * t4858) -
        (motion->constants[3] * t4880) - (t228 * t4556) - (t1813 * t4789);
    const float t4892 = t1853 * (t4890 - (t1822 * t4839));
    const float t4894 = (t1765 * t4839) - (t1822 * t4892);
    const float t4898 = (t1266 * t4789) - (t1747 * t4894) - (t1813 * t4892);
    const float t4902 = motion->constants[3] * motion->constants[13];
    const float t4903 = (motion->constants[2] * motion->constants[12]) + t4902;
    const float t4906 = motion->constants[2] * motion->constants[13];
    const float t4909 = t4906 + (motion->constants[3] * motion->constants[14]);
    const float t4912 = (motion->constants[3] * (t4903 + t4903)) - (motion->constants[2] * (t4909 +
        t4909));
    const float t4915 = (motion->constants[3] * motion->constants[12]) - t4906;
    const float t4919 = t4902 - (motion->constants[2] * motion->constants[14]);
    const float t4922 = (motion->constants[3] * (t4915 - t4909)) - (motion->constants[2] * (t4903 +
        t4919));
    const float t4928 = (motion->constants[3] * (t4919 + t4919)) + (motion->constants[2] * (t4915 +
        t4915));
    const float t4935 = motion->constants[3] * motion->constants[7];
    const float t4936 = (motion->constants[2] * motion->constants[6]) + t4935;
    const float t4939 = motion->constants[2] * motion->constants[7];
    const float t4942 = t4939 + (motion->constants[3] * motion->constants[8]);
    const float t4945 = (motion->constants[3] * (t4936 + t4936)) - (motion->constants[2] * (t4942 +
        t4942));
    const float t4947 = t12 * t3406;
    const float t4949 = t7 * t3406;
    const float t4950 = (t12 * t1882) - t4949;
    const float t4952 = t1206 * t3241;
    const float t4955 = (t1214 * t4950) + t4952 - (t7 * t1882) - t4947;
    const float t4958 = t4935 - (motion->constants[2] * motion->constants[8]);
    const float t4962 = (motion->constants[3] * motion->constants[6]) - t4939;
    const float t4965 = (motion->constants[3] * (t4958 + t4958)) + (motion->constants[2] * (t4962 +
        t4962));
    const float t4966 = t7 * t3224;
    const float t4968 = t12 * t3224;
    const float t4970 = t4968 + (t7 * t1877);
    const float t4974 = t4966 - t4952 - (t12 * t1877) - (t1214 * t4970);
    const float t4980 = (motion->constants[3] * (t4962 - t4942)) - (motion->constants[2] * (t4936 +
        t4958));
    const float t4985 = (t12 * t3407) + (t7 * t3225);
    const float t4987 = t3228 - t3421;
    const float t4991 = (t12 * t3225) + (t1214 * t4985) + (t1206 * t4987) - (t7 * t3407);
    const float t4996 = motion->constants[4] + motion->constants[11];
    const float t4998 = (motion->constants[3] * motion->constants[10]) - (motion->constants[2] *
        t4996);
    const float t5000 = t74 * t3407;
    const float t5002 = t3409 * motion->constants[9];
    const float t5004 = t3422 * motion->constants[9];
    const float t5006 = t1864 * motion->constants[9];
    const float t5007 = t12 * t5006;
    const float t5008 = t7 * t5006;
    const float t5010 = t1908 * motion->constants[9];
    const float t5014 = (t12 * t5002) - (t7 * t5004);
    const float t5016 = motion->constants[31] + motion->constants[31];
    const float t5018 = t4949 + t4968;
    const float t5023 = t4947 + (t1214 * t5018) - t4966 - (t1206 * t1895);
    const float t5030 = (t2010 * t5014) + (t4974 * t5016) + (t5016 * t5023) +
        (motion->constants[30] * t4991) - (motion->constants[9] * t5000) - (t2031 * t5002);
    const float t5034 = t5030 - (t2098 * t5004) - t5007 - (t1214 * t5008) - (t1206 * t5010);
    const float t5038 = (motion->constants[2] * motion->constants[10]) + (motion->constants[3] *
        t4996);
    const float t5039 = t74 * t3225;
    const float t5041 = t3229 * motion->constants[9];
    const float t5043 = t3241 - t1895;
    const float t5044 = motion->constants[9] * t5043;
    const float t5047 = t1932 * motion->constants[9];
    const float t5051 = (t7 * t5044) - (t12 * t5041);
    const float t5053 = motion->constants[30] + motion->constants[30];
    const float t5061 = t5008 + (t2031 * t5041) + (t2098 * t5044) + (t2010 * t5051) + (t4955 *
        t5053) + (t5023 * t5053);
    const float t5065 = t5061 + (motion->constants[31] * t4991) - (motion->constants[9] * t5039) -
        (t1214 * t5007) - (t1206 * t5047);
    const float t5077 = (t3374 * t4912) + (t3296 * t3360) + (t4945 * t4955) + (t4998 * t5034) +
        (motion->constants[26] * t4757) + (t244 * t4782);
    const float t5082 = t5077 + (motion->constants[23] * t3442) + (t290 * t3209) - (t3318 * t4922) -
        (t3334 * t4928) - (t3272 * t3401);
    const float t5087 = t5082 - (t4965 * t4974) - (t4980 * t4991) - (t5038 * t5065) -
        (motion->constants[24] * t3264) - (t287 * t3101);
    const float t5095 = t1710 * t3241;
    const float t5096 = (t1712 * t4950) + t5095;
    const float t5099 = t5095 + (t1712 * t4970);
    const float t5103 = (t1712 * t4985) + (t1710 * t4987);
    const float t5111 = (t1712 * t5018) - (t1710 * t1895);
    const float t5118 = (t3452 * t5014) + (t5016 * t5111) + (motion->constants[30] * t5103) -
        (t1712 * t5008) - (t1710 * t5010) - (t5016 * t5099);
    const float t5130 = (t3452 * t5051) + (t5053 * t5096) + (t5053 * t5111) +
        (motion->constants[31] * t5103) - (t1712 * t5007) - (t1710 * t5047);
    const float t5143 = (t4043 * t4912) + (t4019 * t4922) + (t3296 * t4038) + (t4945 * t5096) +
        (t4965 * t5099) + (t4998 * t5118);
    const float t5148 = t5143 + (motion->constants[26] * t4808) + (t244 * t4830) +
        (motion->constants[23] * t4087) + (t290 * t3978) - (t4024 * t4928);
    const float t5153 = t5148 - (t3272 * t4060) - (t4980 * t5103) - (t5038 * t5130) -
        (motion->constants[24] * t4009) - (t287 * t3920);
    const float t5154 = t5153 - (t1747 * t5087);
    const float t5162 = t1779 * t3241;
    const float t5163 = (t1781 * t4950) - t5162;
    const float t5166 = t5162 - (t1781 * t4970);
    const float t5170 = (t1779 * t4987) - (t1781 * t4985);
    const float t5178 = (t1781 * t5018) + (t1779 * t1895);
    const float t5185 = (t1779 * t5010) + (t4099 * t5014) + (t5016 * t5166) + (t5016 * t5178) -
        (t1781 * t5008) - (motion->constants[30] * t5170);
    const float t5197 = (t1779 * t5047) + (t4099 * t5051) + (t5053 * t5163) + (t5053 * t5178) -
        (t1781 * t5007) - (motion->constants[31] * t5170);
    const float t5211 = (t4676 * t4912) + (t4654 * t4922) + (t3296 * t4672) + (t4945 * t5163) +
        (t4980 * t5170) + (t4998 * t5185);
    const float t5216 = t5211 + (motion->constants[26] * t4858) + (t244 * t4880) +
        (motion->constants[23] * t4719) + (t290 * t4614) - (t4658 * t4928);
    const float t5221 = t5216 - (t3272 * t4692) - (t4965 * t5166) - (t5038 * t5197) -
        (motion->constants[24] * t4646) - (t287 * t4556);
    const float t5224 = t1853 * (t5221 - (t1813 * t5087) - (t1822 * t5154));
    const float t5226 = (t1765 * t5154) - (t1822 * t5224);
    const float t5230 = (t1266 * t5087) - (t1747 * t5226) - (t1813 * t5224);
    const float t5235 = (t16 * t2096) + (sin_phi * t2676) - (t13 * t2113);
    const float t5243 = (t16 * t3476) + (t13 * t3487) - (sin_phi * t3680) - (t1747 * t5235);
    const float t5254 = t1853 * ((t16 * t4122) + (t13 * t4133) - (sin_phi * t4320) - (t1813 *
        t5235) - (t1822 * t5243));
    const float t5256 = (t1765 * t5243) - (t1822 * t5254);
    const float t5260 = (t1266 * t5235) - (t1747 * t5256) - (t1813 * t5254);
    const float t5267 = t1656 + t1966 + (motion->constants[30] * t1882) - (motion->constants[34] *
        t1864) - (motion->constants[31] * t1877);
    const float t5271 = (t1272 * t1339) - (speeds[0] * speeds[0]);
    const float t5273 = t12 * t1326;
    const float t5274 = (t7 * t5271) + t5273;
    const float t5275 = t12 * t1897;
    const float t5276 = t5274 - t5275;
    const float t5279 = t7 * t1326;
    const float t5280 = t5279 - (t12 * t5271);
    const float t5281 = t7 * t1897;
    const float t5282 = t5281 - t5280;
    const float t5284 = t1272 * t1275;
    const float t5285 = t5284 - t1861;
    const float t5287 = t5279 + t5280;
    const float t5291 = (cos_delta * t5284) + (sin_delta * t5274);
    const float t5294 = (cos_delta * t1296) - (sin_delta * t5273);
    const float t5295 = t5294 - t5291;
    const float t5299 = (cos_delta * t5274) - (sin_delta * t5284);
    const float t5302 = (sin_delta * t1296) + (cos_delta * t5273);
    const float t5303 = t5299 + t5302;
    const float t5313 = (motion->constants[3] * t5034) - (motion->constants[2] * t5065);
    const float t5322 = (t1081 * t2919) + (t687 * t2976) + (t64 * t3018) - (t563 * t2966) - (t575 *
        t2912);
    const float t5327 = (t1206 * t2937) + (t2096 * t5276) + (t2676 * t5285) + (t2278 * t5287) +
        (t2302 * t5295) + (t2325 * t5303);
    const float t5332 = t5327 + (t1074 * t2634) + (t475 * t2828) + (motion->constants[3] * t3442) +
        (t314 * t3209) + t5313;
    const float t5337 = t5332 + t5322 - t5267 - (t2113 * t5282) - (motion->constants[2] * t3264) -
        (t312 * t3101);
    const float t5355 = (motion->constants[3] * t5118) - (motion->constants[2] * t5130);
    const float t5364 = (t1081 * t3794) + (t687 * t3817) + (t64 * t3846) - (t563 * t3809) - (t575 *
        t3788);
    const float t5369 = (t1710 * t2937) + (t3476 * t5276) + (t3487 * t5282) + (t3564 * t5287) +
        (t3570 * t5295) + (t3576 * t5303);
    const float t5374 = t5369 + (t1074 * t3668) + (t475 * t3737) + (motion->constants[3] * t4087) +
        (t314 * t3978) + t5355;
    const float t5379 = t5374 + t5364 - (t3680 * t5285) - (motion->constants[2] * t4009) - (t312 *
        t3920) - (t1747 * t5337);
    const float t5398 = (motion->constants[3] * t5185) - (motion->constants[2] * t5197);
    const float t5407 = (t1081 * t4432) + (t687 * t4455) + (t64 * t4484) - (t563 * t4447) - (t575 *
        t4426);
    const float t5412 = t2937 + (t4122 * t5276) + (t4133 * t5282) + (t4208 * t5287) + (t4214 *
        t5295) + (t4220 * t5303);
    const float t5417 = t5412 + (t1074 * t4310) + (t475 * t4377) + (motion->constants[3] * t4719) +
        (t314 * t4614) + t5398;
    const float t5423 = t5417 + t5407 - (t1779 * t2937) - (t4320 * t5285) - (motion->constants[2] *
        t4646) - (t312 * t4556) - (t1813 * t5337);
    const float t5425 = t1853 * (t5423 - (t1822 * t5379));
    const float t5427 = (t1765 * t5379) - (t1822 * t5425);
    const float t5431 = (t1266 * t5337) - (t1747 * t5427) - (t1813 * t5425);
    const float t5432 = t74 * t1864;
    const float t5437 = (t12 * t1908) - (t7 * t1932);
    const float t5441 = t5432 + (t2010 * t5437) - (t1908 * t2031) - (t1932 * t2098);
    const float t5445 = (t3452 * t5437) - (t1747 * t5441);
    const float t5452 = t1853 * ((t4099 * t5437) - (t1813 * t5441) - (t1822 * t5445));
    const float t5454 = (t1765 * t5445) - (t1822 * t5452);
    const float t5458 = (t1266 * t5441) - (t1747 * t5454) - (t1813 * t5452);
    const float t5459 = t4955 + t4974;
    const float t5463 = t5096 - t5099 - (t1747 * t5459);
    const float t5470 = t1853 * (t5163 + t5166 - (t1813 * t5459) - (t1822 * t5463));
    const float t5472 = (t1765 * t5463) - (t1822 * t5470);
    const float t5476 = (t1266 * t5459) - (t1747 * t5472) - (t1813 * t5470);
    const float t5477 = t1277 * t1286;
    const float t5479 = t1281 * t1286;
    const float t5483 = (t12 * t5477) + (t7 * t5479);
    const float t5488 = (t12 * t5479) + (t1214 * t5483) - (t7 * t5477) - (t1206 * t1897);
    const float t5494 = (t1712 * t5483) - (t1710 * t1897) - (t1747 * t5488);
    const float t5504 = t1853 * ((t1781 * t5483) + (t1779 * t1897) - t1897 - (t1813 * t5488) -
        (t1822 * t5494));
    const float t5506 = (t1765 * t5494) - (t1822 * t5504);
    const float t5510 = (t1266 * t5488) - (t1747 * t5506) - (t1813 * t5504);
    const float t5513 = (motion->constants[2] * t5034) + (motion->constants[3] * t5065);
    const float t5519 = (motion->constants[2] * t5118) + (motion->constants[3] * t5130) - (t1747 *
        t5513);
    const float t5528 = t1853 * ((motion->constants[2] * t5185) + (motion->constants[3] * t5197) -
        (t1813 * t5513) - (t1822 * t5519));
    const float t5530 = (t1765 * t5519) - (t1822 * t5528);
    const float t5534 = (t1266 * t5513) - (t1747 * t5530) - (t1813 * t5528);
    const float t5537 = t5355 - (t1747 * t5313);
    const float t5543 = t1853 * (t5398 - (t1813 * t5313) - (t1822 * t5537));
    const float t5545 = (t1765 * t5537) - (t1822 * t5543);
    const float t5549 = (t1266 * t5313) - (t1747 * t5545) - (t1813 * t5543);
    const float t5555 = t1908 + (t3409 * t5038) - (t3229 * t4998);
    const float t5560 = (t4998 * t5043) - t1932 - (t3422 * t5038);
    const float t5562 = t1864 * t4998;
    const float t5564 = t1864 * t5038;
    const float t5568 = (t12 * t5562) + (t7 * t5564);
    const float t5572 = (t1908 * t5038) + (t1932 * t4998);
    const float t5576 = (t12 * t5555) + (t7 * t5560);
    const float t5578 = t4998 * t4998;
    const float t5580 = t5038 * t5038;
    const float t5582 = t5578 + t5580;
    const float t5584 = t4998 * t5038;
    const float t5590 = t5432 + (t2098 * t5560) + (t7 * t5562) + (t2010 * t5576) + (t4955 * t5578) +
        (t4974 * t5580);
    const float t5595 = t5590 + (t5023 * t5582) + (t4991 * t5584) - (t5000 * t5038) - (t4998 *
        t5039) - (t2031 * t5555);
    const float t5598 = t5595 - (t12 * t5564) - (t1214 * t5568) - (t1206 * t5572);
    const float t5612 = (t3452 * t5576) + (t5096 * t5578) + (t5111 * t5582) + (t5103 * t5584) -
        (t1712 * t5568) - (t1710 * t5572);
    const float t5614 = t5612 - (t5099 * t5580) - (t1747 * t5598);
    const float t5629 = (t1779 * t5572) + (t4099 * t5576) + (t5163 * t5578) + (t5166 * t5580) +
        (t5178 * t5582) - (t1781 * t5568);
    const float t5633 = t1853 * (t5629 - (t5170 * t5584) - (t1813 * t5598) - (t1822 * t5614));
    const float t5635 = (t1765 * t5614) - (t1822 * t5633);
    const float t5639 = (t1266 * t5598) - (t1747 * t5635) - (t1813 * t5633);
    const float t5640 = motion->constants[2] * motion->constants[2];
    const float t5642 = motion->constants[3] * motion->constants[3];
    const float t5644 = motion->constants[3] * motion->constants[2];
    const float t5645 = t4991 * t5644;
    const float t5647 = (t4955 * t5640) + (t4974 * t5642) - t5645;
    const float t5651 = t5103 * t5644;
    const float t5655 = (t5096 * t5640) - (t5099 * t5642) - t5651 - (t1747 * t5647);
    const float t5659 = t5170 * t5644;
    const float t5666 = t1853 * ((t5163 * t5640) + (t5166 * t5642) + t5659 - (t1813 * t5647) -
        (t1822 * t5655));
    const float t5668 = (t1765 * t5655) - (t1822 * t5666);
    const float t5672 = (t1266 * t5647) - (t1747 * t5668) - (t1813 * t5666);
    const float t5675 = t5111 - (t1747 * t5023);
    const float t5681 = t1853 * (t5178 - (t1813 * t5023) - (t1822 * t5675));
    const float t5683 = (t1765 * t5675) - (t1822 * t5681);
    const float t5687 = (t1266 * t5023) - (t1747 * t5683) - (t1813 * t5681);
    const float t5691 = t5645 + (t4955 * t5642) + (t4974 * t5640);
    const float t5698 = t5651 + (t5096 * t5642) - (t5099 * t5640) - (t1747 * t5691);
    const float t5708 = t1853 * ((t5163 * t5642) + (t5166 * t5640) - t5659 - (t1813 * t5691) -
        (t1822 * t5698));
    const float t5710 = (t1765 * t5698) - (t1822 * t5708);
    const float t5714 = (t1266 * t5691) - (t1747 * t5710) - (t1813 * t5708);
    const float t5715 = t5644 + t5644;
    const float t5718 = t5642 - t5640;
    const float t5721 = (t4955 * t5715) - (t4974 * t5715) - (t4991 * t5718);
    const float t5729 = (t5096 * t5715) + (t5099 * t5715) - (t5103 * t5718) - (t1747 * t5721);
    const float t5740 = t1853 * ((t5163 * t5715) + (t5170 * t5718) - (t5166 * t5715) - (t1813 *
        t5721) - (t1822 * t5729));
    const float t5742 = (t1765 * t5729) - (t1822 * t5740);
    const float t5746 = (t1266 * t5721) - (t1747 * t5742) - (t1813 * t5740);
    const float t5749 = t4062 - (t1747 * t3403);
    const float t5755 = t1853 * (t4694 - (t1813 * t3403) - (t1822 * t5749));
    const float t5757 = (t1765 * t5749) - (t1822 * t5755);
    const float t5761 = (t1266 * t3403) - (t1747 * t5757) - (t1813 * t5755);
    const float t5764 = (motion->constants[3] * t3360) - (motion->constants[2] * t3401);
    const float t5770 = (motion->constants[3] * t4038) - (motion->constants[2] * t4060) - (t1747 *
        t5764);
    const float t5779 = t1853 * ((motion->constants[3] * t4672) - (motion->constants[2] * t4692) -
        (t1813 * t5764) - (t1822 * t5770));
    const float t5781 = (t1765 * t5770) - (t1822 * t5779);
    const float t5785 = (t1266 * t5764) - (t1747 * t5781) - (t1813 * t5779);
    const float t5790 = (t1934 * t2106) + (t1912 * t2068) + (t1927 * t2087);
    const float t5791 = t3296 * t3296;
    const float t5793 = t3272 * t3272;
    const float t5794 = t5791 + t5793;
    const float t5796 = t3272 * t3296;
    const float t5805 = t5790 + (t3374 * t5791) + (t3292 * t5794) + (t3318 * t5796) + (t3334 *
        t5793) + (t3272 * t3356);
    const float t5806 = t5805 + (t3296 * t3397);
    const float t5812 = (t1934 * t3483) + (t1912 * t3463) + (t1927 * t3469);
    const float t5824 = t5812 + (t4043 * t5791) + (t4014 * t5794) + (t4024 * t5793) + (t3272 *
        t4034) + (t3296 * t4056);
    const float t5826 = t5824 - (t4019 * t5796) - (t1747 * t5806);
    const float t5832 = (t1934 * t4129) + (t1912 * t4110) + (t1927 * t4116);
    const float t5845 = t5832 + (t4676 * t5791) + (t4650 * t5794) + (t4658 * t5793) + (t3272 *
        t4668) + (t3296 * t4688);
    const float t5849 = t1853 * (t5845 - (t4654 * t5796) - (t1813 * t5806) - (t1822 * t5826));
    const float t5851 = (t1765 * t5826) - (t1822 * t5849);
    const float t5855 = (t1266 * t5806) - (t1747 * t5851) - (t1813 * t5849);
    const float t5857 = t3318 * t5644;
    const float t5860 = (t3374 * t5640) + (t3334 * t5642) - t5857;
    const float t5863 = t4019 * t5644;
    const float t5868 = (t4043 * t5640) + t5863 + (t4024 * t5642) - (t1747 * t5860);
    const float t5871 = t4654 * t5644;
    const float t5879 = t1853 * ((t4676 * t5640) + t5871 + (t4658 * t5642) - (t1813 * t5860) -
        (t1822 * t5868));
    const float t5881 = (t1765 * t5868) - (t1822 * t5879);
    const float t5885 = (t1266 * t5860) - (t1747 * t5881) - (t1813 * t5879);
    const float t5888 = t4014 - (t1747 * t3292);
    const float t5894 = t1853 * (t4650 - (t1813 * t3292) - (t1822 * t5888));
    const float t5896 = (t1765 * t5888) - (t1822 * t5894);
    const float t5900 = (t1266 * t3292) - (t1747 * t5896) - (t1813 * t5894);
    const float t5904 = t5857 + (t3374 * t5642) + (t3334 * t5640);
    const float t5911 = (t4043 * t5642) + (t4024 * t5640) - t5863 - (t1747 * t5904);
    const float t5921 = t1853 * ((t4676 * t5642) + (t4658 * t5640) - t5871 - (t1813 * t5904) -
        (t1822 * t5911));
    const float t5923 = (t1765 * t5911) - (t1822 * t5921);
    const float t5927 = (t1266 * t5904) - (t1747 * t5923) - (t1813 * t5921);
    const float t5932 = (t3374 * t5715) - (t3318 * t5718) - (t3334 * t5715);
    const float t5940 = (t4043 * t5715) + (t4019 * t5718) - (t4024 * t5715) - (t1747 * t5932);
    const float t5951 = t1853 * ((t4676 * t5715) + (t4654 * t5718) - (t4658 * t5715) - (t1813 *
        t5932) - (t1822 * t5940));
    const float t5953 = (t1765 * t5940) - (t1822 * t5951);
    const float t5957 = (t1266 * t5932) - (t1747 * t5953) - (t1813 * t5951);
    const float t5960 = (t1357 * t1421) - (t1385 * t1417);
    const float t5964 = (t1388 * t1417) + (t1348 * t1421);
    const float t5975 = (t1348 * t1385) + (t1357 * t1388);
    const float t5979 = (t323 * t3049) + (t2302 * t5975) - (t321 * t3030);
    const float t5984 = t3071 + (t2278 * t5960) + (t1097 * t2640) + (t698 * t2834) +
        (motion->constants[2] * t4782) + (t334 * t3209);
    const float t5988 = t5984 + t5979 - (t2325 * t5964) - (motion->constants[3] * t4757) - (t332 *
        t3101);
    const float t6003 = (t323 * t3876) + (t3570 * t5975) - (t321 * t3858);
    const float t6008 = t3892 + (t3564 * t5960) + (t1097 * t3674) + (t698 * t3744) +
        (motion->constants[2] * t4830) + (t334 * t3978);
    const float t6013 = t6008 + t6003 - (t3576 * t5964) - (motion->constants[3] * t4808) - (t332 *
        t3920) - (t1747 * t5988);
    const float t6029 = (t323 * t4514) + (t4214 * t5975) - (t321 * t4496);
    const float t6034 = t4528 + (t4208 * t5960) + (t1097 * t4314) + (t698 * t4383) +
        (motion->constants[2] * t4880) + (t334 * t4614);
    const float t6040 = t6034 + t6029 - (t4220 * t5964) - (motion->constants[3] * t4858) - (t332 *
        t4556) - (t1813 * t5988) - (t1822 * t6013);
    const float t6041 = t1853 * t6040;
    const float t6043 = (t1765 * t6013) - (t1822 * t6041);
    const float t6047 = (t1266 * t5988) - (t1747 * t6043) - (t1813 * t6041);
    const float t6048 = motion->constants[26] * motion->constants[26];
    const float t6050 = motion->constants[27] * motion->constants[27];
    const float t6051 = t6048 + t6050;
    const float t6053 = motion->constants[26] * motion->constants[27];
    const float t6062 = t5790 + (t3374 * t6048) + (t3292 * t6051) + (t3318 * t6053) + (t3334 *
        t6050) + (motion->constants[27] * t3356);
    const float t6063 = t6062 + (motion->constants[26] * t3397);
    const float t6076 = t5812 + (t4043 * t6048) + (t4014 * t6051) + (t4024 * t6050) +
        (motion->constants[27] * t4034) + (motion->constants[26] * t4056);
    const float t6078 = t6076 - (t4019 * t6053) - (t1747 * t6063);
    const float t6092 = t5832 + (t4676 * t6048) + (t4650 * t6051) + (t4658 * t6050) +
        (motion->constants[27] * t4668) + (motion->constants[26] * t4688);
    const float t6096 = t1853 * (t6092 - (t4654 * t6053) - (t1813 * t6063) - (t1822 * t6078));
    const float t6098 = (t1765 * t6078) - (t1822 * t6096);
    const float t6102 = (t1266 * t6063) - (t1747 * t6098) - (t1813 * t6096);
    const float t6103 = t3334 + t3374;
    const float t6107 = t4024 + t4043 - (t1747 * t6103);
    const float t6114 = t1853 * (t4658 + t4676 - (t1813 * t6103) - (t1822 * t6107));
    const float t6116 = (t1765 * t6107) - (t1822 * t6114);
    const float t6120 = (t1266 * t6103) - (t1747 * t6116) - (t1813 * t6114);
    const float t6121 = t1357 * t1417;
    const float t6123 = t1348 * t1417;
    const float t6124 = cos_delta * t6123;
    const float t6128 = (t12 * t6121) + (t7 * t6124);
    const float t6130 = sin_delta * t6123;
    const float t6136 = (t12 * t6124) + (t1214 * t6128) + (t1206 * t6130) - (t7 * t6121) - (t1253 *
        t1947);
    const float t6145 = (t1712 * t6128) + (t1710 * t6130) + (t1736 * t1947) - t6121 - (t1747 *
        t6136);
    const float t6156 = t1853 * ((t1781 * t6128) + (t1800 * t1947) - (t1779 * t6130) - (t1813 *
        t6136) - (t1822 * t6145));
    const float t6158 = (t1765 * t6145) - (t1822 * t6156);
    const float t6162 = (t1266 * t6136) - (t1747 * t6158) - (t1813 * t6156);
    const float t6168 = sin_phi * t2937;
    const float t6170 = t343 * t2937;
    const float t6172 = sin_phi * t1861;
    const float t6174 = sin_phi * t1899;
    const float t6179 = (t7 * t6172) + (t12 * t6174) + (t343 * t5275) - t5274;
    const float t6186 = t5280 + (t12 * t6172) - (t7 * t6174) - (t343 * t5281);
    const float t6189 = t5284 - (t343 * t1861);
    const float t6191 = sin_phi * t1296;
    const float t6193 = sin_phi * t1330;
    const float t6198 = (t7 * t6193) - t5280 - (t12 * t6191) - (t343 * t5279);
    const float t6202 = (t7 * t6191) + (t12 * t6193);
    const float t6206 = t5291 - (sin_delta * t6202) - (t343 * t5294);
    const float t6211 = (cos_delta * t6202) - t5299 - (t343 * t5302);
    const float t6219 = (sin_phi * ((t12 * t1982) - (t7 * t2007))) + (t343 * t5267) + (t1214 *
        t6168) + (t2096 * t6179);
    const float t6224 = t6219 + (t2278 * t6198) + (t2302 * t6206) + (t2325 * t6211) + (t346 *
        t3101) - t5322;
    const float t6229 = t6224 - (t1206 * t6170) - (t2113 * t6186) - (t2676 * t6189) - (t1114 *
        t2634) - (t712 * t2828);
    const float t6230 = t6229 - (t348 * t3209);
    const float t6249 = (t1712 * t6168) + (t3476 * t6179) + (t3487 * t6186) + (t3680 * t6189) +
        (t3564 * t6198) + (t3570 * t6206);
    const float t6254 = t6249 + (t3576 * t6211) + (t346 * t3920) - t5364 - (t1710 * t6170) -
        (t1114 * t3668);
    const float t6257 = t6254 - (t712 * t3737) - (t348 * t3978) - (t1747 * t6230);
    const float t6277 = (t1781 * t6168) + (t1779 * t6170) + (t4122 * t6179) + (t4133 * t6186) +
        (t4320 * t6189) + (t4208 * t6198);
    const float t6282 = t6277 + (t4214 * t6206) + (t4220 * t6211) + (t346 * t4556) - t5407 - t6170;
    const float t6287 = t6282 - (t1114 * t4310) - (t712 * t4377) - (t348 * t4614) - (t1813 *
        t6230) - (t1822 * t6257);
    const float t6288 = t1853 * t6287;
    const float t6290 = (t1765 * t6257) - (t1822 * t6288);
    const float t6294 = (t1266 * t6230) - (t1747 * t6290) - (t1813 * t6288);
    const float t6296 = (t39 * t1378) - t5960;
    const float t6299 = t5964 - (t39 * t1374);
    const float t6310 = (t2278 * t6296) + (t2325 * t6299) + (t1123 * t2640) + (t719 * t2834) +
        (t358 * t3209) - t5979;
    const float t6312 = t6310 - (t354 * t3071) - (t356 * t3101);
    const float t6326 = (t3564 * t6296) + (t3576 * t6299) + (t1123 * t3674) + (t719 * t3744) +
        (t358 * t3978) - t6003;
    const float t6329 = t6326 - (t354 * t3892) - (t356 * t3920) - (t1747 * t6312);
    const float t6344 = (t4208 * t6296) + (t4220 * t6299) + (t1123 * t4314) + (t719 * t4383) +
        (t358 * t4614) - t6029;
    const float t6349 = t1853 * (t6344 - (t354 * t4528) - (t356 * t4556) - (t1813 * t6312) -
        (t1822 * t6329));
    const float t6351 = (t1765 * t6329) - (t1822 * t6349);
    const float t6355 = (t1266 * t6312) - (t1747 * t6351) - (t1813 * t6349);
    by_parameters[0][0] = t216;
    by_parameters[0][1] = t235;
    by_parameters[0][2] = t296;
    by_parameters[0][3] = 0.0F;
    by_parameters[0][4] = t320;
    by_parameters[0][5] = 0.0F;
    by_parameters[0][6] = 0.0F;
    by_parameters[0][7] = 0.0F;
    by_parameters[0][8] = 0.0F;
    by_parameters[0][9] = 0.0F;
    by_parameters[0][10] = 0.0F;
    by_parameters[0][11] = 0.0F;
    by_parameters[0][12] = 0.0F;
    by_parameters[0][13] = 0.0F;
    by_parameters[0][14] = 0.0F;
    by_parameters[0][15] = 0.0F;
    by_parameters[0][16] = 0.0F;
    by_parameters[0][17] = 0.0F;
    by_parameters[0][18] = 0.0F;
    by_parameters[0][19] = 0.0F;
    by_parameters[0][20] = 0.0F;
    by_parameters[0][21] = 0.0F;
    by_parameters[0][22] = t339;
    by_parameters[0][23] = 0.0F;
    by_parameters[0][24] = 0.0F;
    by_parameters[0][25] = 0.0F;
    by_parameters[0][26] = t353;
    by_parameters[0][27] = t361;
    by_parameters[1][0] = t406;
    by_parameters[1][1] = t417;
    by_parameters[1][2] = t428;
    by_parameters[1][3] = 0.0F;
    by_parameters[1][4] = t439;
    by_parameters[1][5] = 0.0F;
    by_parameters[1][6] = 0.0F;
    by_parameters[1][7] = 0.0F;
    by_parameters[1][8] = 0.0F;
    by_parameters[1][9] = 0.0F;
    by_parameters[1][10] = 0.0F;
    by_parameters[1][11] = 0.0F;
    by_parameters[1][12] = 0.0F;
    by_parameters[1][13] = 0.0F;
    by_parameters[1][14] = 0.0F;
    by_parameters[1][15] = 0.0F;
    by_parameters[1][16] = 0.0F;
    by_parameters[1][17] = 0.0F;
    by_parameters[1][18] = 0.0F;
    by_parameters[1][19] = 0.0F;
    by_parameters[1][20] = 0.0F;
    by_parameters[1][21] = 0.0F;
    by_parameters[1][22] = t450;
    by_parameters[1][23] = 0.0F;
    by_parameters[1][24] = 0.0F;
    by_parameters[1][25] = 0.0F;
    by_parameters[1][26] = t458;
    by_parameters[1][27] = t462;
    by_parameters[2][0] = t654;
    by_parameters[2][1] = t670;
    by_parameters[2][2] = t681;
    by_parameters[2][3] = 0.0F;
    by_parameters[2][4] = t697;
    by_parameters[2][5] = 0.0F;
    by_parameters[2][6] = 0.0F;
    by_parameters[2][7] = 0.0F;
    by_parameters[2][8] = 0.0F;
    by_parameters[2][9] = 0.0F;
    by_parameters[2][10] = 0.0F;
    by_parameters[2][11] = 0.0F;
    by_parameters[2][12] = 0.0F;
    by_parameters[2][13] = 0.0F;
    by_parameters[2][14] = 0.0F;
    by_parameters[2][15] = 0.0F;
    by_parameters[2][16] = 0.0F;
    by_parameters[2][17] = 0.0F;
    by_parameters[2][18] = 0.0F;
    by_parameters[2][19] = 0.0F;
    by_parameters[2][20] = 0.0F;
    by_parameters[2][21] = 0.0F;
    by_parameters[2][22] = t711;
    by_parameters[2][23] = 0.0F;
    by_parameters[2][24] = 0.0F;
    by_parameters[2][25] = 0.0F;
    by_parameters[2][26] = t718;
    by_parameters[2][27] = t725;
    by_parameters[3][0] = 0.0F;
    by_parameters[3][1] = 0.0F;
    by_parameters[3][2] = 0.0F;
    by_parameters[3][3] = 0.0F;
    by_parameters[3][4] = 0.0F;
    by_parameters[3][5] = 0.0F;
    by_parameters[3][6] = 0.0F;
    by_parameters[3][7] = 0.0F;
    by_parameters[3][8] = 0.0F;
    by_parameters[3][9] = 0.0F;
    by_parameters[3][10] = 0.0F;
    by_parameters[3][11] = 0.0F;
    by_parameters[3][12] = 0.0F;
    by_parameters[3][13] = 0.0F;
    by_parameters[3][14] = 0.0F;
    by_parameters[3][15] = 0.0F;
    by_parameters[3][16] = 0.0F;
    by_parameters[3][17] = 0.0F;
    by_parameters[3][18] = 0.0F;
    by_parameters[3][19] = 0.0F;
    by_parameters[3][20] = 0.0F;
    by_parameters[3][21] = 0.0F;
    by_parameters[3][22] = 0.0F;
    by_parameters[3][23] = 0.0F;
    by_parameters[3][24] = 0.0F;
    by_parameters[3][25] = 0.0F;
    by_parameters[3][26] = 0.0F;
    by_parameters[3][27] = 0.0F;
    by_parameters[4][0] = t767;
    by_parameters[4][1] = t778;
    by_parameters[4][2] = t789;
    by_parameters[4][3] = 0.0F;
    by_parameters[4][4] = t798;
    by_parameters[4][5] = 0.0F;
    by_parameters[4][6] = 0.0F;
    by_parameters[4][7] = 0.0F;
    by_parameters[4][8] = 0.0F;
    by_parameters[4][9] = 0.0F;
    by_parameters[4][10] = 0.0F;
    by_parameters[4][11] = 0.0F;
    by_parameters[4][12] = 0.0F;
    by_parameters[4][13] = 0.0F;
    by_parameters[4][14] = 0.0F;
    by_parameters[4][15] = 0.0F;
    by_parameters[4][16] = 0.0F;
    by_parameters[4][17] = 0.0F;
    by_parameters[4][18] = 0.0F;
    by_parameters[4][19] = 0.0F;
    by_parameters[4][20] = 0.0F;
    by_parameters[4][21] = 0.0F;
    by_parameters[4][22] = t809;
    by_parameters[4][23] = 0.0F;
    by_parameters[4][24] = 0.0F;
    by_parameters[4][25] = 0.0F;
    by_parameters[4][26] = t813;
    by_parameters[4][27] = t817;
    by_parameters[5][0] = 0.0F;
    by_parameters[5][1] = 0.0F;
    by_parameters[5][2] = 0.0F;
    by_parameters[5][3] = 0.0F;
    by_parameters[5][4] = 0.0F;
    by_parameters[5][5] = 0.0F;
    by_parameters[5][6] = 0.0F;
    by_parameters[5][7] = 0.0F;
    by_parameters[5][8] = 0.0F;
    by_parameters[5][9] = 0.0F;
    by_parameters[5][10] = 0.0F;
    by_parameters[5][11] = 0.0F;
    by_parameters[5][12] = 0.0F;
    by_parameters[5][13] = 0.0F;
    by_parameters[5][14] = 0.0F;
    by_parameters[5][15] = 0.0F;
    by_parameters[5][16] = 0.0F;
    by_parameters[5][17] = 0.0F;
    by_parameters[5][18] = 0.0F;
    by_parameters[5][19] = 0.0F;
    by_parameters[5][20] = 0.0F;
    by_parameters[5][21] = 0.0F;
    by_parameters[5][22] = 0.0F;
    by_parameters[5][23] = 0.0F;
    by_parameters[5][24] = 0.0F;
    by_parameters[5][25] = 0.0F;
    by_parameters[5][26] = 0.0F;
    by_parameters[5][27] = 0.0F;
    by_parameters[6][0] = 0.0F;
    by_parameters[6][1] = 0.0F;
    by_parameters[6][2] = 0.0F;
    by_parameters[6][3] = 0.0F;
    by_parameters[6][4] = 0.0F;
    by_parameters[6][5] = 0.0F;
    by_parameters[6][6] = 0.0F;
    by_parameters[6][7] = 0.0F;
    by_parameters[6][8] = 0.0F;
    by_parameters[6][9] = 0.0F;
    by_parameters[6][10] = 0.0F;
    by_parameters[6][11] = 0.0F;
    by_parameters[6][12] = 0.0F;
    by_parameters[6][13] = 0.0F;
    by_parameters[6][14] = 0.0F;
    by_parameters[6][15] = 0.0F;
    by_parameters[6][16] = 0.0F;
    by_parameters[6][17] = 0.0F;
    by_parameters[6][18] = 0.0F;
    by_parameters[6][19] = 0.0F;
    by_parameters[6][20] = 0.0F;
    by_parameters[6][21] = 0.0F;
    by_parameters[6][22] = 0.0F;
    by_parameters[6][23] = 0.0F;
    by_parameters[6][24] = 0.0F;
    by_parameters[6][25] = 0.0F;
    by_parameters[6][26] = 0.0F;
    by_parameters[6][27] = 0.0F;
    by_parameters[7][0] = t1042;
    by_parameters[7][1] = t1062;
    by_parameters[7][2] = t1073;
    by_parameters[7][3] = 0.0F;
    by_parameters[7][4] = t1096;
    by_parameters[7][5] = 0.0F;
    by_parameters[7][6] = 0.0F;
    by_parameters[7][7] = 0.0F;
    by_parameters[7][8] = 0.0F;
    by_parameters[7][9] = 0.0F;
    by_parameters[7][10] = 0.0F;
    by_parameters[7][11] = 0.0F;
    by_parameters[7][12] = 0.0F;
    by_parameters[7][13] = 0.0F;
    by_parameters[7][14] = 0.0F;
    by_parameters[7][15] = 0.0F;
    by_parameters[7][16] = 0.0F;
    by_parameters[7][17] = 0.0F;
    by_parameters[7][18] = 0.0F;
    by_parameters[7][19] = 0.0F;
    by_parameters[7][20] = 0.0F;
    by_parameters[7][21] = 0.0F;
    by_parameters[7][22] = t1113;
    by_parameters[7][23] = 0.0F;
    by_parameters[7][24] = 0.0F;
    by_parameters[7][25] = 0.0F;
    by_parameters[7][26] = t1122;
    by_parameters[7][27] = t1133;
    by_parameters[8][0] = t4733;
    by_parameters[8][1] = t4898;
    by_parameters[8][2] = t5230;
    by_parameters[8][3] = t5260;
    by_parameters[8][4] = t5431;
    by_parameters[8][5] = t5458;
    by_parameters[8][6] = t5476;
    by_parameters[8][7] = t5510;
    by_parameters[8][8] = t5534;
    by_parameters[8][9] = t5549;
    by_parameters[8][10] = t5639;
    by_parameters[8][11] = t5672;
    by_parameters[8][12] = t5687;
    by_parameters[8][13] = t5714;
    by_parameters[8][14] = t5746;
    by_parameters[8][15] = t5761;
    by_parameters[8][16] = t5785;
    by_parameters[8][17] = t5855;
    by_parameters[8][18] = t5885;
    by_parameters[8][19] = t5900;
    by_parameters[8][20] = t5927;
    by_parameters[8][21] = t5957;
    by_parameters[8][22] = t6047;
    by_parameters[8][23] = t6102;
    by_parameters[8][24] = t6120;
    by_parameters[8][25] = t6162;
    by_parameters[8][26] = t6294;
    by_parameters[8][27] = t6355;
    by_parameters[9][0] = t4729;
    by_parameters[9][1] = t4894;
    by_parameters[9][2] = t5226;
    by_parameters[9][3] = t5256;
    by_parameters[9][4] = t5427;
    by_parameters[9][5] = t5454;
    by_parameters[9][6] = t5472;
    by_parameters[9][7] = t5506;
    by_parameters[9][8] = t5530;
    by_parameters[9][9] = t5545;
    by_parameters[9][10] = t5635;
    by_parameters[9][11] = t5668;
    by_parameters[9][12] = t5683;
    by_parameters[9][13] = t5710;
    by_parameters[9][14] = t5742;
    by_parameters[9][15] = t5757;
    by_parameters[9][16] = t5781;
    by_parameters[9][17] = t5851;
    by_parameters[9][18] = t5881;
    by_parameters[9][19] = t5896;
    by_parameters[9][20] = t5923;
    by_parameters[9][21] = t5953;
    by_parameters[9][22] = t6043;
    by_parameters[9][23] = t6098;
    by_parameters[9][24] = t6116;
    by_parameters[9][25] = t6158;
    by_parameters[9][26] = t6290;
    by_parameters[9][27] = t6351;
    by_parameters[10][0] = t4727;
    by_parameters[10][1] = t4892;
    by_parameters[10][2] = t5224;
    by_parameters[10][3] = t5254;
    by_parameters[10][4] = t5425;
    by_parameters[10][5] = t5452;
    by_parameters[10][6] = t5470;
    by_parameters[10][7] = t5504;
    by_parameters[10][8] = t5528;
    by_parameters[10][9] = t5543;
    by_parameters[10][10] = t5633;
    by_parameters[10][11] = t5666;
    by_parameters[10][12] = t5681;
    by_parameters[10][13] = t5708;
    by_parameters[10][14] = t5740;
    by_parameters[10][15] = t5755;
    by_parameters[10][16] = t5779;
    by_parameters[10][17] = t5849;
    by_parameters[10][18] = t5879;
    by_parameters[10][19] = t5894;
    by_parameters[10][20] = t5921;
    by_parameters[10][21] = t5951;
    by_parameters[10][22] = t6041;
    by_parameters[10][23] = t6096;
    by_parameters[10][24] = t6114;
    by_parameters[10][25] = t6156;
    by_parameters[10][26] = t6288;
    by_parameters[10][27] = t6349;
}

carvallo_motion_error_t whipple_tyres_f32_motion_by_parameters(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES],
    float by_parameters[WHIPPLE_TYRES_STATES][WHIPPLE_TYRES_PARAMETERS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_TYRES_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_TYRES_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_TYRES_FORCES)) {
        bool are_finite = true;
        whipple_tyres_f32_compute_by_parameters(motion, positions, speeds, forces, by_parameters);
        for (size_t row = 0U; row < WHIPPLE_TYRES_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f32(by_parameters[row],
                WHIPPLE_TYRES_PARAMETERS);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}
