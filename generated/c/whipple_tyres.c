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
