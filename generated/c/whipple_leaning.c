/* @generated from generated/models/whipple_leaning.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 3110f099e4d2a018
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * yaw_by_delta = c*cos(lam)/w [1]
 * yaw_per_v_delta = cos(lam)/w [1/m]
 * Jxx_theta = mU*(zU - zP)^2 + IUxx [kg*m^2]
 * Jxz_theta = IUxz - mU*xU*(zU - zP) [kg*m^2]
 * Jzz_theta = mU*xU^2 + IUzz [kg*m^2]
 * Sx_theta = mU*xU [kg*m]
 * Sz_theta = mU*(zU - zP) [kg*m]
 * Jxx_delta = IHxx + IFxx + zH^2*mH + rF^2*mF [kg*m^2]
 * Jxz_delta = IHxz - c*rF*mF - zH*mH*(xH - (w + c)) [kg*m^2]
 * Jzz_delta = mH*(xH - (w + c))^2 + IHzz + IFxx + c^2*mF [kg*m^2]
 * Sx_delta = mH*(xH - (w + c)) - c*mF [kg*m]
 * Sz_delta = zH*mH - rF*mF [kg*m]
 * m_delta = mH + mF [kg]
 * py_delta = Sx_delta*cos(lam) - Sz_delta*sin(lam) [kg*m]
 * hx_delta = Jxx_delta*sin(lam) + Jxz_delta*cos(lam) [kg*m^2]
 * hz_delta = Jxz_delta*sin(lam) + Jzz_delta*cos(lam) [kg*m^2]
 * Jxx_all = IRxx + IBxx + 2*zP*((1/2)*zP*mU + Sz_theta) + Jxx_theta + Jxx_delta + rR^2*mR + zB^2*mB [kg*m^2]
 * Jxz_all = IBxz + Jxz_theta + Jxz_delta - xB*zB*mB - zP*Sx_theta - Sz_delta*(w + c) [kg*m^2]
 * Jzz_all = IRxx + IBzz + IHzz + IFxx + Jzz_theta + w^2*mF + xB^2*mB + xH^2*mH [kg*m^2]
 * Sx_all = xB*mB + Sx_theta + Sx_delta + m_delta*(w + c) [kg*m]
 * Sz_all = zB*mB + zP*mU + Sz_theta + Sz_delta - rR*mR [kg*m]
 * load_spin_F = -Sx_all/w [kg]
 * h_spin_R = IRyy/rR [kg*m]
 * h_spin_F = IFyy/rF [kg*m]
 * h_wheels_all = h_spin_R + h_spin_F [kg*m]
 * M_yaw_delta = py_delta*(w + c) + hz_delta [kg*m^2]
 * M_phi_theta = zP*Sz_theta + Jxx_theta [kg*m^2]
 * M_delta_delta = hx_delta*sin(lam) + hz_delta*cos(lam) [kg*m^2]
 * K_phi_delta = c*load_spin_F*cos(lam) - py_delta [kg*m]
 * K_delta_delta = (c*load_spin_F*cos(lam) - py_delta)*sin(lam) [kg*m]
 * P_delta_lateral = yaw_by_delta*Sx_all + py_delta [kg*m]
 * P_delta_yaw = yaw_by_delta*Jzz_all + M_yaw_delta [kg*m^2]
 * P_delta_delta = yaw_by_delta*M_yaw_delta + M_delta_delta [kg*m^2]
 * P_delta_theta = yaw_by_delta*Jxz_theta [kg*m^2]
 * M_11 = Jxx_all [kg*m^2]
 * M_12 = M_21 = yaw_by_delta*Jxz_all + hx_delta [kg*m^2]
 * M_13 = M_31 = M_phi_theta [kg*m^2]
 * M_22 = yaw_by_delta*P_delta_yaw + P_delta_delta [kg*m^2]
 * M_23 = M_32 = P_delta_theta [kg*m^2]
 * M_33 = Jxx_theta [kg*m^2]
 * C0_33 = dU [kg*m^2/s]
 * C1_12 = yaw_by_delta*(h_wheels_all - Sz_all) + yaw_per_v_delta*Jxz_all + h_spin_F*cos(lam) [kg*m]
 * C1_21 = -(yaw_by_delta*h_wheels_all + h_spin_F*cos(lam)) [kg*m]
 * C1_22 = yaw_by_delta*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
 * C1_32 = yaw_per_v_delta*Jxz_theta - yaw_by_delta*Sz_theta [kg*m]
 * Kc_33 = kU [kg*m^2/s^2]
 * K0_11 = Sz_all [kg*m]
 * K0_12 = K0_21 = K_phi_delta [kg*m]
 * K0_13 = K0_31 = K0_33 = Sz_theta [kg*m]
 * K0_22 = K_delta_delta [kg*m]
 * K2_12 = yaw_per_v_delta*(h_wheels_all - Sz_all) [kg]
 * K2_22 = yaw_per_v_delta*(h_spin_F*sin(lam) + P_delta_lateral) [kg]
 * K2_32 = -yaw_per_v_delta*Sz_theta [kg]
 * @endverbatim
 */

#include "whipple_leaning.h"

#include "carvallo_trig.h"

#include <float.h>

const char *whipple_leaning_set_name(whipple_leaning_set_t set)
{
    static const char *const TEXTS[] = {
        "example",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *whipple_leaning_validity_text(whipple_leaning_validity_t validity)
{
    static const char *const TEXTS[] = {
        "WhippleLeaning: the parameters are valid",
        "WhippleLeaning: w in m must be finite and > 0",
        "WhippleLeaning: c in m must be finite",
        "WhippleLeaning: lam in rad must be finite and > -1.5707963267948966 and < 1.5707963267948966",
        "WhippleLeaning: g in N/kg must be finite and >= 0",
        "WhippleLeaning: rR in m must be finite and > 0",
        "WhippleLeaning: mR in kg must be finite and >= 0",
        "WhippleLeaning: IRxx in kg*m^2 must be finite and >= 0",
        "WhippleLeaning: IRyy in kg*m^2 must be finite and >= 0",
        "WhippleLeaning: xB in m must be finite",
        "WhippleLeaning: zB in m must be finite",
        "WhippleLeaning: mB in kg must be finite and >= 0",
        "WhippleLeaning: IBxx in kg*m^2 must be finite and >= 0",
        "WhippleLeaning: IByy in kg*m^2 must be finite and >= 0",
        "WhippleLeaning: IBzz in kg*m^2 must be finite and >= 0",
        "WhippleLeaning: IBxz in kg*m^2 must be finite",
        "WhippleLeaning: xH in m must be finite",
        "WhippleLeaning: zH in m must be finite",
        "WhippleLeaning: mH in kg must be finite and >= 0",
        "WhippleLeaning: IHxx in kg*m^2 must be finite and >= 0",
        "WhippleLeaning: IHyy in kg*m^2 must be finite and >= 0",
        "WhippleLeaning: IHzz in kg*m^2 must be finite and >= 0",
        "WhippleLeaning: IHxz in kg*m^2 must be finite",
        "WhippleLeaning: rF in m must be finite and > 0",
        "WhippleLeaning: mF in kg must be finite and >= 0",
        "WhippleLeaning: IFxx in kg*m^2 must be finite and >= 0",
        "WhippleLeaning: IFyy in kg*m^2 must be finite and >= 0",
        "WhippleLeaning: zP in m must be finite",
        "WhippleLeaning: mU in kg must be finite and >= 0",
        "WhippleLeaning: xU in m must be finite",
        "WhippleLeaning: zU in m must be finite",
        "WhippleLeaning: IUxx in kg*m^2 must be finite and >= 0",
        "WhippleLeaning: IUyy in kg*m^2 must be finite and >= 0",
        "WhippleLeaning: IUzz in kg*m^2 must be finite and >= 0",
        "WhippleLeaning: IUxz in kg*m^2 must be finite",
        "WhippleLeaning: kU in N*m must be finite and >= 0",
        "WhippleLeaning: dU in N*m*s must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t whipple_leaning_partials[WHIPPLE_LEANING_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 1U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 0U, 2U, true},
    {CARVALLO_MATRIX_M, 2U, 1U, 0U, 2U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 3U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 4U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 5U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 0U, 6U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 7U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 7U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 8U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 9U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 10U, true},
    {CARVALLO_MATRIX_K2, 2U, 1U, 0U, 11U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 12U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 12U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 13U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 1U, 14U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 1U, 14U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 15U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 16U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 17U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 1U, 18U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 19U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 19U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 20U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 21U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 22U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 22U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 23U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 2U, 24U, true},
    {CARVALLO_MATRIX_M, 2U, 1U, 2U, 24U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 25U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 26U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 27U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 2U, 28U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 29U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 29U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 30U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 31U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 32U, false},
    {CARVALLO_MATRIX_K2, 2U, 1U, 2U, 33U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 34U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 4U, 35U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 4U, 36U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 37U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 4U, 38U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 39U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 40U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 41U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 5U, 42U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 43U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 44U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 6U, 45U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 7U, 46U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 7U, 46U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 7U, 47U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 8U, 48U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 8U, 48U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 8U, 49U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 8U, 50U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 8U, 51U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 8U, 52U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 8U, 52U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 8U, 53U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 54U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 55U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 56U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 56U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 9U, 57U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 58U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 9U, 59U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 60U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 10U, 61U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 10U, 61U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 10U, 62U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 10U, 63U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 10U, 64U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 10U, 65U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 10U, 66U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 10U, 66U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 10U, 67U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 10U, 68U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 10U, 69U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 11U, 43U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 13U, 44U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 13U, 45U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 14U, 70U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 14U, 70U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 14U, 71U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 15U, 72U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 15U, 72U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 73U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 74U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 75U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 76U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 76U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 77U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 78U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 79U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 80U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 80U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 81U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 82U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 83U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 84U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 85U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 85U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 86U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 87U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 88U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 89U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 90U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 90U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 91U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 92U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 93U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 94U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 95U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 95U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 96U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 97U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 98U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 18U, 43U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 18U, 99U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 18U, 99U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 18U, 100U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 20U, 101U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 20U, 102U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 21U, 103U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 21U, 103U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 21U, 104U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 21U, 71U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 21U, 105U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 22U, 106U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 22U, 107U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 22U, 107U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 108U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 22U, 109U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 22U, 110U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 22U, 111U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 22U, 112U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 22U, 113U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 22U, 113U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 22U, 114U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 115U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 22U, 116U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 23U, 117U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 118U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 118U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 119U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 120U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 121U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 122U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 123U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 123U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 124U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 125U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 126U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 43U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 99U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 99U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 127U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 102U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 128U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 128U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 129U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 130U, false},
    {CARVALLO_MATRIX_M, 0U, 2U, 26U, 131U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 26U, 132U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 26U, 131U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 26U, 132U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 26U, 133U, true},
    {CARVALLO_MATRIX_C1, 2U, 1U, 26U, 134U, false},
    {CARVALLO_MATRIX_K0, 0U, 2U, 26U, 135U, true},
    {CARVALLO_MATRIX_K0, 2U, 0U, 26U, 135U, true},
    {CARVALLO_MATRIX_K0, 2U, 2U, 26U, 135U, true},
    {CARVALLO_MATRIX_K2, 2U, 1U, 26U, 136U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 27U, 137U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 27U, 138U, true},
    {CARVALLO_MATRIX_M, 0U, 2U, 27U, 139U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 27U, 138U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 27U, 140U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 27U, 141U, true},
    {CARVALLO_MATRIX_M, 2U, 0U, 27U, 139U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 27U, 141U, true},
    {CARVALLO_MATRIX_M, 2U, 2U, 27U, 142U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 27U, 143U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 27U, 144U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 27U, 145U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 27U, 146U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 27U, 147U, true},
    {CARVALLO_MATRIX_K0, 0U, 2U, 27U, 148U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 27U, 147U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 27U, 149U, true},
    {CARVALLO_MATRIX_K0, 2U, 0U, 27U, 148U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 27U, 148U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 27U, 150U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 27U, 151U, false},
    {CARVALLO_MATRIX_K2, 2U, 1U, 27U, 152U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 28U, 153U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 28U, 153U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 28U, 154U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 28U, 155U, true},
    {CARVALLO_MATRIX_M, 2U, 1U, 28U, 155U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 28U, 156U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 28U, 157U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 28U, 158U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 28U, 159U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 28U, 159U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 28U, 160U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 28U, 161U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 29U, 162U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 29U, 132U, true},
    {CARVALLO_MATRIX_M, 0U, 2U, 29U, 163U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 29U, 132U, true},
    {CARVALLO_MATRIX_M, 1U, 2U, 29U, 132U, true},
    {CARVALLO_MATRIX_M, 2U, 0U, 29U, 163U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 29U, 132U, true},
    {CARVALLO_MATRIX_M, 2U, 2U, 29U, 133U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 29U, 134U, true},
    {CARVALLO_MATRIX_C1, 2U, 1U, 29U, 134U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 29U, 135U, false},
    {CARVALLO_MATRIX_K0, 0U, 2U, 29U, 135U, false},
    {CARVALLO_MATRIX_K0, 2U, 0U, 29U, 135U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 29U, 135U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 29U, 136U, true},
    {CARVALLO_MATRIX_K2, 2U, 1U, 29U, 136U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 30U, 43U, false},
    {CARVALLO_MATRIX_M, 0U, 2U, 30U, 43U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 30U, 43U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 30U, 43U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 32U, 44U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 32U, 45U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 33U, 70U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 33U, 70U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 33U, 70U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 33U, 70U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 33U, 71U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 33U, 71U, false},
    {CARVALLO_MATRIX_KC, 2U, 2U, 34U, 43U, false},
    {CARVALLO_MATRIX_C0, 2U, 2U, 35U, 43U, false}
};

const whipple_leaning_f64_t whipple_leaning_f64_sets[WHIPPLE_LEANING_SETS] = {
    { /* example */
        .w = 1.02,
        .c = 0.08,
        .lam = 0.3141592653589793,
        .g = 9.81,
        .rR = 0.3,
        .mR = 2.0,
        .IRxx = 0.0603,
        .IRyy = 0.12,
        .xB = 0.3,
        .zB = (-0.7),
        .mB = 45.0,
        .IBxx = 4.0,
        .IByy = 5.5,
        .IBzz = 1.8,
        .IBxz = 1.2,
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
        .zP = (-0.85),
        .mU = 40.0,
        .xU = 0.3,
        .zU = (-1.125),
        .IUxx = 1.6,
        .IUyy = 1.6,
        .IUzz = 0.6,
        .IUxz = 0.0,
        .kU = 600.0,
        .dU = 60.0
    }
};

whipple_leaning_validity_t whipple_leaning_f64_validate(const whipple_leaning_f64_t *p)
{
    whipple_leaning_validity_t validity = WHIPPLE_LEANING_VALID;
    if (!((p->w > 0.0) && (p->w <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_w;
    } else if (!((p->c >= -DBL_MAX) && (p->c <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_c;
    } else if (!((p->lam > (-1.5707963267948966)) && (p->lam < 1.5707963267948966))) {
        validity = WHIPPLE_LEANING_INVALID_lam;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_g;
    } else if (!((p->rR > 0.0) && (p->rR <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_rR;
    } else if (!((p->mR >= 0.0) && (p->mR <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_mR;
    } else if (!((p->IRxx >= 0.0) && (p->IRxx <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0) && (p->IRyy <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IRyy;
    } else if (!((p->xB >= -DBL_MAX) && (p->xB <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_xB;
    } else if (!((p->zB >= -DBL_MAX) && (p->zB <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_zB;
    } else if (!((p->mB >= 0.0) && (p->mB <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_mB;
    } else if (!((p->IBxx >= 0.0) && (p->IBxx <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0) && (p->IByy <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0) && (p->IBzz <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IBzz;
    } else if (!((p->IBxz >= -DBL_MAX) && (p->IBxz <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IBxz;
    } else if (!((p->xH >= -DBL_MAX) && (p->xH <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_xH;
    } else if (!((p->zH >= -DBL_MAX) && (p->zH <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_zH;
    } else if (!((p->mH >= 0.0) && (p->mH <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_mH;
    } else if (!((p->IHxx >= 0.0) && (p->IHxx <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0) && (p->IHyy <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0) && (p->IHzz <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IHzz;
    } else if (!((p->IHxz >= -DBL_MAX) && (p->IHxz <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IHxz;
    } else if (!((p->rF > 0.0) && (p->rF <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_rF;
    } else if (!((p->mF >= 0.0) && (p->mF <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_mF;
    } else if (!((p->IFxx >= 0.0) && (p->IFxx <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0) && (p->IFyy <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IFyy;
    } else if (!((p->zP >= -DBL_MAX) && (p->zP <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_zP;
    } else if (!((p->mU >= 0.0) && (p->mU <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_mU;
    } else if (!((p->xU >= -DBL_MAX) && (p->xU <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_xU;
    } else if (!((p->zU >= -DBL_MAX) && (p->zU <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_zU;
    } else if (!((p->IUxx >= 0.0) && (p->IUxx <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IUxx;
    } else if (!((p->IUyy >= 0.0) && (p->IUyy <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IUyy;
    } else if (!((p->IUzz >= 0.0) && (p->IUzz <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IUzz;
    } else if (!((p->IUxz >= -DBL_MAX) && (p->IUxz <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IUxz;
    } else if (!((p->kU >= 0.0) && (p->kU <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_kU;
    } else if (!((p->dU >= 0.0) && (p->dU <= DBL_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_dU;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void whipple_leaning_f64_matrices(const whipple_leaning_f64_t *p, whipple_leaning_f64_matrices_t *matrices)
{
    const double t5 = p->zU - p->zP;
    const double Sz_theta = t5 * p->mU;
    const double Jxx_theta = p->IUxx + (t5 * Sz_theta);
    const double t14 = p->zH * p->mH;
    const double t18 = p->rF * p->mF;
    const double Jxx_delta = p->IHxx + p->IFxx + (p->zH * t14) + (p->rF * t18);
    const double t25 = p->rR * p->mR;
    const double t29 = p->zB * p->mB;
    const double t32 = Sz_theta + (p->zP * p->mU);
    const double M_11 = p->IRxx + p->IBxx + Jxx_theta + Jxx_delta + (p->rR * t25) + (p->zB * t29) +
        (p->zP * (Sz_theta + t32));
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t49 = p->c + p->w;
    const double t50 = t49 - p->xH;
    const double Jxz_delta = p->IHxz + (t14 * t50) - (t18 * p->c);
    const double hx_delta = (Jxx_delta * sin_lam) + (Jxz_delta * cos_lam);
    const double yaw_per_v_delta = cos_lam / p->w;
    const double yaw_by_delta = p->c * yaw_per_v_delta;
    const double Sx_theta = p->mU * p->xU;
    const double Jxz_theta = p->IUxz - (t5 * Sx_theta);
    const double Sz_delta = t14 - t18;
    const double Jxz_all = Jxz_delta + p->IBxz + Jxz_theta - (t29 * p->xB) - (p->zP * Sx_theta) -
        (t49 * Sz_delta);
    const double M_12 = hx_delta + (yaw_by_delta * Jxz_all);
    const double M_phi_theta = Jxx_theta + (p->zP * Sz_theta);
    const double t80 = p->mH * t50;
    const double t82 = p->mF * p->c;
    const double t85 = p->IFxx + p->IHzz;
    const double hz_delta = (sin_lam * Jxz_delta) + (cos_lam * ((t50 * t80) + (p->c * t82) + t85));
    const double t91 = t80 + t82;
    const double t93 = (sin_lam * Sz_delta) + (cos_lam * t91);
    const double M_yaw_delta = hz_delta - (t49 * t93);
    const double t98 = p->mB * p->xB;
    const double t110 = p->IRxx + t85 + p->IBzz + p->IUzz + (p->xB * t98) + (p->mH * p->xH *
        p->xH) + (p->mF * p->w * p->w);
    const double P_delta_yaw = M_yaw_delta + (yaw_by_delta * (t110 + (p->xU * Sx_theta)));
    const double M_22 = (yaw_by_delta * (M_yaw_delta + P_delta_yaw)) + (sin_lam * hx_delta) +
        (cos_lam * hz_delta);
    const double P_delta_theta = yaw_by_delta * Jxz_theta;
    const double h_spin_F = p->IFyy / p->rF;
    const double h_wheels_all = h_spin_F + (p->IRyy / p->rR);
    const double Sz_all = t29 + t32 + Sz_delta - t25;
    const double t131 = h_wheels_all - Sz_all;
    const double t134 = cos_lam * h_spin_F;
    const double C1_12 = (yaw_by_delta * t131) + (yaw_per_v_delta * Jxz_all) + t134;
    const double Sx_all = Sx_theta + t98 + (t49 * (p->mH + p->mF)) - t91;
    const double t144 = yaw_by_delta * Sx_all;
    const double P_delta_lateral = t144 - t93;
    const double C1_22 = (yaw_by_delta * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
    const double C1_32 = (yaw_per_v_delta * Jxz_theta) - (Sz_theta * yaw_by_delta);
    const double K2_12 = yaw_per_v_delta * t131;
    const double K2_22 = yaw_per_v_delta * (P_delta_lateral + (sin_lam * h_spin_F));
    const double C1_21 = -(t134 + (yaw_by_delta * h_wheels_all));
    const double K0_12 = t93 - t144;
    const double K0_22 = -(sin_lam * P_delta_lateral);
    const double K2_32 = -(Sz_theta * yaw_per_v_delta);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_phi_theta;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = P_delta_theta;
    matrices->m[2][0] = M_phi_theta;
    matrices->m[2][1] = P_delta_theta;
    matrices->m[2][2] = Jxx_theta;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = 0.0;
    matrices->c0[0][2] = 0.0;
    matrices->c0[1][0] = 0.0;
    matrices->c0[1][1] = 0.0;
    matrices->c0[1][2] = 0.0;
    matrices->c0[2][0] = 0.0;
    matrices->c0[2][1] = 0.0;
    matrices->c0[2][2] = p->dU;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = C1_12;
    matrices->c1[0][2] = 0.0;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->c1[1][2] = 0.0;
    matrices->c1[2][0] = 0.0;
    matrices->c1[2][1] = C1_32;
    matrices->c1[2][2] = 0.0;
    matrices->kc[0][0] = 0.0;
    matrices->kc[0][1] = 0.0;
    matrices->kc[0][2] = 0.0;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = 0.0;
    matrices->kc[1][2] = 0.0;
    matrices->kc[2][0] = 0.0;
    matrices->kc[2][1] = 0.0;
    matrices->kc[2][2] = p->kU;
    matrices->k0[0][0] = Sz_all;
    matrices->k0[0][1] = K0_12;
    matrices->k0[0][2] = Sz_theta;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0;
    matrices->k0[2][0] = Sz_theta;
    matrices->k0[2][1] = 0.0;
    matrices->k0[2][2] = Sz_theta;
    matrices->k2[0][0] = 0.0;
    matrices->k2[0][1] = K2_12;
    matrices->k2[0][2] = 0.0;
    matrices->k2[1][0] = 0.0;
    matrices->k2[1][1] = K2_22;
    matrices->k2[1][2] = 0.0;
    matrices->k2[2][0] = 0.0;
    matrices->k2[2][1] = K2_32;
    matrices->k2[2][2] = 0.0;
}

carvallo_system_error_t whipple_leaning_f64_at_speed(const whipple_leaning_f64_matrices_t *matrices,
    double speed, double gravity, whipple_leaning_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed) && carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < WHIPPLE_LEANING_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_LEANING_N; column++) {
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

carvallo_system_error_t whipple_leaning_f64_state_space(const whipple_leaning_f64_system_t *system,
    whipple_leaning_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[WHIPPLE_LEANING_N * WHIPPLE_LEANING_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * WHIPPLE_LEANING_N * WHIPPLE_LEANING_N];
    for (size_t row = 0U; row < WHIPPLE_LEANING_N; row++) {
        double *const solved = &x[3U * WHIPPLE_LEANING_N * row];
        for (size_t column = 0U; column < WHIPPLE_LEANING_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * WHIPPLE_LEANING_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHIPPLE_LEANING_N + column] = -system->c[row][column];
            solved[(2U * WHIPPLE_LEANING_N) + column] = 0.0;
        }
        solved[(2U * WHIPPLE_LEANING_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[WHIPPLE_LEANING_N * WHIPPLE_LEANING_N];
        error = carvallo_solve_f64(WHIPPLE_LEANING_N, m, terms, 3U * WHIPPLE_LEANING_N, x);
    }
    for (size_t row = 0U; row < (2U * WHIPPLE_LEANING_N); row++) {
        for (size_t column = 0U; column < (2U * WHIPPLE_LEANING_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < WHIPPLE_LEANING_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHIPPLE_LEANING_N; row++) {
            const size_t target = WHIPPLE_LEANING_N + row;
            for (size_t column = 0U; column < (2U * WHIPPLE_LEANING_N); column++) {
                space->a[target][column] = x[(3U * WHIPPLE_LEANING_N * row) + column];
            }
            for (size_t column = 0U; column < WHIPPLE_LEANING_N; column++) {
                space->b[target][column] = x[(3U * WHIPPLE_LEANING_N * row) + (2U *
                    WHIPPLE_LEANING_N) + column];
            }
            space->a[row][WHIPPLE_LEANING_N + row] = 1.0;
        }
    }
    return error;
}

double whipple_leaning_f64_rate_at(const whipple_leaning_f64_rate_t *rate, double v,
    const double q[WHIPPLE_LEANING_N], const double q_dot[WHIPPLE_LEANING_N], double psi)
{
    double by_coordinates = 0.0;
    double by_rates = 0.0;
    for (size_t i = 0U; i < WHIPPLE_LEANING_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void whipple_leaning_f64_kinematics(const whipple_leaning_f64_t *p, whipple_leaning_f64_kinematics_t *kinematics)
{
    const double yaw_per_v_delta = carvallo_cos_f64(p->lam) / p->w;
    const double yaw_by_delta = p->c * yaw_per_v_delta;
    const double t12 = -(1.0 / p->rR);
    const double t13 = -(1.0 / p->rF);
    kinematics->lateral.speed = 0.0;
    kinematics->lateral.rates[0] = 0.0;
    kinematics->lateral.rates[1] = 0.0;
    kinematics->lateral.rates[2] = 0.0;
    kinematics->lateral.coordinates[0] = 0.0;
    kinematics->lateral.coordinates[1] = 0.0;
    kinematics->lateral.coordinates[2] = 0.0;
    kinematics->lateral.heading = 1.0;
    kinematics->yaw.speed = 0.0;
    kinematics->yaw.rates[0] = 0.0;
    kinematics->yaw.rates[1] = yaw_by_delta;
    kinematics->yaw.rates[2] = 0.0;
    kinematics->yaw.coordinates[0] = 0.0;
    kinematics->yaw.coordinates[1] = yaw_per_v_delta;
    kinematics->yaw.coordinates[2] = 0.0;
    kinematics->yaw.heading = 0.0;
    kinematics->wheel_R.speed = t12;
    kinematics->wheel_R.rates[0] = 0.0;
    kinematics->wheel_R.rates[1] = 0.0;
    kinematics->wheel_R.rates[2] = 0.0;
    kinematics->wheel_R.coordinates[0] = 0.0;
    kinematics->wheel_R.coordinates[1] = 0.0;
    kinematics->wheel_R.coordinates[2] = 0.0;
    kinematics->wheel_R.heading = 0.0;
    kinematics->wheel_F.speed = t13;
    kinematics->wheel_F.rates[0] = 0.0;
    kinematics->wheel_F.rates[1] = 0.0;
    kinematics->wheel_F.rates[2] = 0.0;
    kinematics->wheel_F.coordinates[0] = 0.0;
    kinematics->wheel_F.coordinates[1] = 0.0;
    kinematics->wheel_F.coordinates[2] = 0.0;
    kinematics->wheel_F.heading = 0.0;
    kinematics->forces[0][0] = 1.0;
    kinematics->forces[0][1] = 0.0;
    kinematics->forces[0][2] = 0.0;
    kinematics->forces[1][0] = 0.0;
    kinematics->forces[1][1] = 1.0;
    kinematics->forces[1][2] = 0.0;
    kinematics->forces[2][0] = 0.0;
    kinematics->forces[2][1] = 0.0;
    kinematics->forces[2][2] = 1.0;
}

void whipple_leaning_f64_derivatives(const whipple_leaning_f64_t *p,
    whipple_leaning_f64_matrices_t *matrices, whipple_leaning_f64_derivatives_t *derivatives)
{
    const double K0_13_mU = p->zU - p->zP;
    const double Sz_theta = K0_13_mU * p->mU;
    const double Jxx_theta = p->IUxx + (K0_13_mU * Sz_theta);
    const double t14 = p->zH * p->mH;
    const double t18 = p->rF * p->mF;
    const double Jxx_delta = p->IHxx + p->IFxx + (p->zH * t14) + (p->rF * t18);
    const double t25 = p->rR * p->mR;
    const double t29 = p->zB * p->mB;
    const double t31 = p->zP * p->mU;
    const double t32 = Sz_theta + t31;
    const double M_11 = p->IRxx + p->IBxx + Jxx_theta + Jxx_delta + (p->rR * t25) + (p->zB * t29) +
        (p->zP * (Sz_theta + t32));
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t48 = p->c + p->w;
    const double t50 = t48 - p->xH;
    const double Jxz_delta = p->IHxz + (t14 * t50) - (t18 * p->c);
    const double t55 = Jxz_delta * cos_lam;
    const double hx_delta = (Jxx_delta * sin_lam) + t55;
    const double t57 = 1.0 / p->w;
    const double yaw_per_v_delta = cos_lam * t57;
    const double yaw_by_delta = p->c * yaw_per_v_delta;
    const double Sx_theta = p->mU * p->xU;
    const double Jxz_theta = p->IUxz - (K0_13_mU * Sx_theta);
    const double Sz_delta = t14 - t18;
    const double Jxz_all = Jxz_delta + p->IBxz + Jxz_theta - (t29 * p->xB) - (p->zP * Sx_theta) -
        (t48 * Sz_delta);
    const double M_12 = hx_delta + (yaw_by_delta * Jxz_all);
    const double M_phi_theta = Jxx_theta + (p->zP * Sz_theta);
    const double t81 = sin_lam * Jxz_delta;
    const double t83 = p->IFxx + p->IHzz;
    const double t84 = p->mF * p->c;
    const double t86 = p->mH * t50;
    const double t89 = t83 + (p->c * t84) + (t50 * t86);
    const double hz_delta = t81 + (cos_lam * t89);
    const double t94 = t84 + t86;
    const double t96 = (sin_lam * Sz_delta) + (cos_lam * t94);
    const double M_yaw_delta = hz_delta - (t48 * t96);
    const double t101 = p->mB * p->xB;
    const double t103 = p->xH * p->xH;
    const double t105 = p->w * p->w;
    const double t113 = p->IRxx + t83 + p->IBzz + p->IUzz + (p->xB * t101) + (p->mH * t103) +
        (p->mF * t105);
    const double P_delta_yaw_yaw_by_delta = t113 + (p->xU * Sx_theta);
    const double t115 = yaw_by_delta * P_delta_yaw_yaw_by_delta;
    const double P_delta_yaw = M_yaw_delta + t115;
    const double t117 = M_yaw_delta + P_delta_yaw;
    const double M_22 = (sin_lam * hx_delta) + (cos_lam * hz_delta) + (yaw_by_delta * t117);
    const double P_delta_theta = yaw_by_delta * Jxz_theta;
    const double t125 = 1.0 / p->rF;
    const double h_spin_F = p->IFyy * t125;
    const double t127 = cos_lam * h_spin_F;
    const double t129 = 1.0 / p->rR;
    const double t130 = p->IRyy * t129;
    const double h_wheels_all = h_spin_F + t130;
    const double Sz_all = t29 + t32 + Sz_delta - t25;
    const double t135 = h_wheels_all - Sz_all;
    const double t137 = yaw_per_v_delta * Jxz_all;
    const double C1_12 = t127 + (yaw_by_delta * t135) + t137;
    const double Sx_all = Sx_theta + t101 + (t48 * (p->mH + p->mF)) - t94;
    const double K0_12 = t96 - (yaw_by_delta * Sx_all);
    const double C1_22 = (yaw_per_v_delta * P_delta_yaw) - (yaw_by_delta * K0_12);
    const double M_23_c = yaw_per_v_delta * Jxz_theta;
    const double C1_32 = M_23_c - (Sz_theta * yaw_by_delta);
    const double K0_22 = sin_lam * K0_12;
    const double K2_12 = yaw_per_v_delta * t135;
    const double t158 = sin_lam * h_spin_F;
    const double K2_22_yaw_per_v_delta = t158 - K0_12;
    const double K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
    const double t161 = Sz_theta * yaw_per_v_delta;
    const double C1_12_h_spin_F = cos_lam + yaw_by_delta;
    const double t163 = t14 * C1_12_h_spin_F;
    const double t165 = t163 - (yaw_by_delta * Sz_delta);
    const double t166 = t57 * yaw_per_v_delta;
    const double M_12_yaw_per_v_delta = p->c * Jxz_all;
    const double M_12_w = t165 - (t166 * M_12_yaw_per_v_delta);
    const double t170 = sin_lam * cos_lam;
    const double M_22_Jxz_delta = t170 + t170;
    const double t173 = t50 * cos_lam;
    const double t176 = (p->mH * t173) + (cos_lam * t86);
    const double t178 = (t14 * M_22_Jxz_delta) + (cos_lam * t176);
    const double t179 = t14 * sin_lam;
    const double t180 = t176 + t179;
    const double t181 = t180 - t96;
    const double t182 = p->mH * cos_lam;
    const double t183 = t48 * t182;
    const double M_yaw_delta_w = t181 - t183;
    const double t185 = yaw_by_delta + yaw_by_delta;
    const double P_delta_yaw_w = p->mF * p->w * t185;
    const double t188 = M_yaw_delta_w + P_delta_yaw_w;
    const double M_22_yaw_by_delta = t115 + t117;
    const double M_22_yaw_per_v_delta = p->c * M_22_yaw_by_delta;
    const double M_22_w = t178 + (yaw_by_delta * (M_yaw_delta_w + t188)) - (t166 *
        M_22_yaw_per_v_delta);
    const double P_delta_theta_yaw_per_v_delta = p->c * Jxz_theta;
    const double t197 = t166 * P_delta_theta_yaw_per_v_delta;
    const double t198 = t14 * yaw_per_v_delta;
    const double t200 = t198 - (yaw_per_v_delta * Sz_delta);
    const double C1_12_yaw_per_v_delta = Jxz_all + (p->c * t135);
    const double C1_12_w = t200 - (t166 * C1_12_yaw_per_v_delta);
    const double t205 = p->c * h_wheels_all;
    const double C1_21_w = t166 * t205;
    const double t209 = p->c * Sx_all;
    const double K0_12_w = t182 + (t166 * t209) - (p->mF * yaw_by_delta);
    const double C1_22_yaw_by_delta = (yaw_per_v_delta * P_delta_yaw_yaw_by_delta) - K0_12;
    const double C1_22_yaw_per_v_delta = P_delta_yaw + (p->c * C1_22_yaw_by_delta);
    const double C1_22_w = (yaw_per_v_delta * t188) - (yaw_by_delta * K0_12_w) - (t166 *
        C1_22_yaw_per_v_delta);
    const double C1_32_yaw_per_v_delta = Jxz_theta - (Sz_theta * p->c);
    const double t223 = t166 * C1_32_yaw_per_v_delta;
    const double K0_22_w = sin_lam * K0_12_w;
    const double t225 = t135 * t166;
    const double t228 = (yaw_per_v_delta * K0_12_w) + (K2_22_yaw_per_v_delta * t166);
    const double K2_32_w = Sz_theta * t166;
    const double M_12_c = t137 + t165 - (t18 * C1_12_h_spin_F);
    const double t234 = p->c * cos_lam;
    const double hz_delta_c = (p->mF * t234) + (cos_lam * t84);
    const double t238 = t18 * sin_lam;
    const double t240 = t182 + (p->mF * cos_lam);
    const double M_yaw_delta_c = t181 + hz_delta_c - t238 - (t48 * t240);
    const double M_22_c = t178 + (t185 * M_yaw_delta_c) + (cos_lam * hz_delta_c) +
        (yaw_per_v_delta * M_22_yaw_by_delta) - (t18 * M_22_Jxz_delta);
    const double C1_12_c = t200 + (yaw_per_v_delta * (t135 - t18));
    const double t255 = yaw_per_v_delta * h_wheels_all;
    const double K0_12_c = t240 - (yaw_per_v_delta * Sx_all);
    const double C1_22_c = (yaw_per_v_delta * (C1_22_yaw_by_delta + M_yaw_delta_c)) -
        (yaw_by_delta * K0_12_c);
    const double K0_22_c = sin_lam * K0_12_c;
    const double t263 = yaw_per_v_delta * K0_12_c;
    const double hx_delta_lam = (Jxx_delta * cos_lam) - t81;
    const double t266 = sin_lam * t57;
    const double M_12_lam = hx_delta_lam - (M_12_yaw_per_v_delta * t266);
    const double hz_delta_lam = t55 - (sin_lam * t89);
    const double t273 = (cos_lam * Sz_delta) - (sin_lam * t94);
    const double M_yaw_delta_lam = hz_delta_lam - (t48 * t273);
    const double M_22_lam = (t185 * M_yaw_delta_lam) + (sin_lam * hx_delta_lam) + (cos_lam *
        hz_delta_lam) + (cos_lam * hx_delta) - (sin_lam * hz_delta) - (M_22_yaw_per_v_delta * t266);
    const double t287 = P_delta_theta_yaw_per_v_delta * t266;
    const double t289 = t158 + (C1_12_yaw_per_v_delta * t266);
    const double C1_21_lam = t158 + (t205 * t266);
    const double K0_12_lam = t273 + (t209 * t266);
    const double C1_22_lam = (yaw_per_v_delta * M_yaw_delta_lam) - (yaw_by_delta * K0_12_lam) -
        (C1_22_yaw_per_v_delta * t266);
    const double t299 = C1_32_yaw_per_v_delta * t266;
    const double K0_22_lam = (sin_lam * K0_12_lam) + (cos_lam * K0_12);
    const double t303 = t135 * t266;
    const double K2_22_lam = (yaw_per_v_delta * (t127 - K0_12_lam)) - (K2_22_yaw_per_v_delta *
        t266);
    const double K2_32_lam = Sz_theta * t266;
    const double M_11_rR = t25 + t25;
    const double t310 = t129 * t130;
    const double t311 = p->mR - t310;
    const double C1_12_rR = yaw_by_delta * t311;
    const double C1_21_rR = yaw_by_delta * t310;
    const double K2_12_rR = yaw_per_v_delta * t311;
    const double M_11_mR = p->rR * p->rR;
    const double C1_12_mR = p->rR * yaw_by_delta;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double M_22_IRxx = yaw_by_delta * yaw_by_delta;
    const double C1_22_IRxx = yaw_per_v_delta * yaw_by_delta;
    const double C1_12_IRyy = yaw_by_delta * t129;
    const double K2_12_IRyy = yaw_per_v_delta * t129;
    const double t323 = t29 * yaw_by_delta;
    const double t324 = yaw_by_delta * p->xB;
    const double t325 = p->mB * t324;
    const double P_delta_yaw_xB = t325 + (yaw_by_delta * t101);
    const double M_22_xB = yaw_by_delta * P_delta_yaw_xB;
    const double t329 = t29 * yaw_per_v_delta;
    const double t331 = p->mB * yaw_by_delta;
    const double C1_22_xB = (yaw_per_v_delta * P_delta_yaw_xB) + (yaw_by_delta * t331);
    const double t334 = sin_lam * t331;
    const double K2_22_xB = yaw_per_v_delta * t331;
    const double M_11_zB = t29 + t29;
    const double t338 = yaw_by_delta + (yaw_per_v_delta * p->xB);
    const double t339 = p->mB * t338;
    const double t340 = p->mB * yaw_per_v_delta;
    const double M_11_mB = p->zB * p->zB;
    const double t342 = p->zB * t324;
    const double P_delta_yaw_mB = p->xB * t324;
    const double M_22_mB = yaw_by_delta * P_delta_yaw_mB;
    const double t345 = p->zB * t338;
    const double C1_22_mB = (yaw_per_v_delta * P_delta_yaw_mB) + (yaw_by_delta * t324);
    const double t349 = sin_lam * t324;
    const double t350 = p->zB * yaw_per_v_delta;
    const double K2_22_mB = yaw_per_v_delta * t324;
    const double M_yaw_delta_xH = t183 - t180;
    const double P_delta_yaw_xH = p->mH * p->xH * t185;
    const double t355 = M_yaw_delta_xH + P_delta_yaw_xH;
    const double M_22_xH = (yaw_by_delta * (M_yaw_delta_xH + t355)) - t178;
    const double P_delta_lateral_xH = t182 + (p->mH * yaw_by_delta);
    const double C1_22_xH = (yaw_per_v_delta * t355) + (yaw_by_delta * P_delta_lateral_xH);
    const double t364 = sin_lam * P_delta_lateral_xH;
    const double K2_22_xH = yaw_per_v_delta * P_delta_lateral_xH;
    const double M_11_zH = t14 + t14;
    const double t367 = t48 * yaw_by_delta;
    const double t369 = p->zH * sin_lam;
    const double t371 = (t50 * C1_12_h_spin_F) + t369 - t367;
    const double M_12_zH = t179 + (p->mH * t371);
    const double K0_12_zH = p->mH * sin_lam;
    const double t376 = sin_lam * t50;
    const double M_yaw_delta_zH = (p->mH * t376) - (t48 * K0_12_zH);
    const double M_22_Jxx_delta = sin_lam * sin_lam;
    const double t383 = (p->zH * M_22_Jxx_delta) + (t50 * M_22_Jxz_delta);
    const double M_22_zH = (t185 * M_yaw_delta_zH) + (p->mH * t383) + (t14 * M_22_Jxx_delta);
    const double t389 = yaw_by_delta + (t48 * yaw_per_v_delta);
    const double t391 = (t50 * yaw_per_v_delta) - t389;
    const double C1_12_zH = p->mH * t391;
    const double C1_22_zH = (yaw_per_v_delta * M_yaw_delta_zH) - (yaw_by_delta * K0_12_zH);
    const double K0_22_zH = sin_lam * K0_12_zH;
    const double t397 = p->mH * yaw_per_v_delta;
    const double t398 = yaw_per_v_delta * K0_12_zH;
    const double M_11_mH = p->zH * p->zH;
    const double M_12_mH = p->zH * t371;
    const double hz_delta_mH = t50 * t173;
    const double t404 = t173 + t369;
    const double M_yaw_delta_mH = hz_delta_mH + (p->zH * t376) - (t48 * t404);
    const double P_delta_yaw_mH = yaw_by_delta * t103;
    const double t410 = M_yaw_delta_mH + P_delta_yaw_mH;
    const double M_22_mH = (p->zH * t383) + (cos_lam * hz_delta_mH) + (yaw_by_delta *
        (M_yaw_delta_mH + t410));
    const double C1_12_mH = p->zH * t391;
    const double K0_12_mH = t404 - (yaw_by_delta * (t48 - t50));
    const double C1_22_mH = (yaw_per_v_delta * t410) - (yaw_by_delta * K0_12_mH);
    const double K0_22_mH = sin_lam * K0_12_mH;
    const double t423 = p->zH * yaw_per_v_delta;
    const double t424 = yaw_per_v_delta * K0_12_mH;
    const double M_22_IHzz = M_22_IRxx + (cos_lam * cos_lam) + (cos_lam * t185);
    const double C1_22_IHzz = C1_22_IRxx + (cos_lam * yaw_per_v_delta);
    const double M_22_IHxz = M_22_Jxz_delta + (sin_lam * t185);
    const double K2_22_h_spin_F = sin_lam * yaw_per_v_delta;
    const double M_11_rF = t18 + t18;
    const double t436 = p->rF * sin_lam;
    const double t438 = t367 + t436 - (p->c * C1_12_h_spin_F);
    const double M_12_rF = t238 + (p->mF * t438);
    const double t441 = p->mF * sin_lam;
    const double t443 = sin_lam * p->c;
    const double M_yaw_delta_rF = (t48 * t441) - (p->mF * t443);
    const double t449 = (p->rF * M_22_Jxx_delta) - (p->c * M_22_Jxz_delta);
    const double M_22_rF = (t185 * M_yaw_delta_rF) + (p->mF * t449) + (t18 * M_22_Jxx_delta);
    const double t454 = t389 - yaw_by_delta;
    const double t456 = t125 * h_spin_F;
    const double C1_21_rF = C1_12_h_spin_F * t456;
    const double C1_12_rF = (p->mF * t454) - C1_21_rF;
    const double C1_22_rF = (yaw_by_delta * t441) + (yaw_per_v_delta * M_yaw_delta_rF);
    const double t462 = sin_lam * t441;
    const double K2_12_rF = yaw_per_v_delta * (p->mF - t456);
    const double K2_22_rF = (yaw_per_v_delta * t441) - (K2_22_h_spin_F * t456);
    const double M_11_mF = p->rF * p->rF;
    const double M_12_mF = p->rF * t438;
    const double hz_delta_mF = p->c * t234;
    const double t473 = t234 - t436;
    const double M_yaw_delta_mF = hz_delta_mF - (t48 * t473) - (p->rF * t443);
    const double P_delta_yaw_mF = yaw_by_delta * t105;
    const double t479 = M_yaw_delta_mF + P_delta_yaw_mF;
    const double M_22_mF = (p->rF * t449) + (cos_lam * hz_delta_mF) + (yaw_by_delta *
        (M_yaw_delta_mF + t479));
    const double C1_12_mF = p->rF * t454;
    const double K0_12_mF = t473 - (yaw_by_delta * (t48 - p->c));
    const double C1_22_mF = (yaw_per_v_delta * t479) - (yaw_by_delta * K0_12_mF);
    const double K0_22_mF = sin_lam * K0_12_mF;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double t493 = yaw_per_v_delta * K0_12_mF;
    const double M_22_IFxx = M_22_Jxx_delta + M_22_IHzz;
    const double C1_12_IFyy = t125 * C1_12_h_spin_F;
    const double K2_12_IFyy = yaw_per_v_delta * t125;
    const double K2_22_IFyy = t125 * K2_22_h_spin_F;
    const double M_33_zU = Sz_theta + Sz_theta;
    const double M_13_zU = t31 + M_33_zU;
    const double M_13_zP = Sz_theta - M_13_zU;
    const double M_23_zP = yaw_by_delta * Sx_theta;
    const double t502 = p->mU * yaw_by_delta;
    const double C1_32_zP = t502 + (yaw_per_v_delta * Sx_theta);
    const double K2_32_zP = p->mU * yaw_per_v_delta;
    const double K0_11_mU = p->zP + K0_13_mU;
    const double Jxx_theta_mU = K0_13_mU * K0_13_mU;
    const double M_13_mU = Jxx_theta_mU + (p->zP * K0_13_mU);
    const double M_11_mU = (p->zP * K0_11_mU) + M_13_mU;
    const double t512 = yaw_by_delta * K0_11_mU;
    const double t513 = p->xU * t512;
    const double P_delta_yaw_Sx_theta = yaw_by_delta * p->xU;
    const double P_delta_yaw_mU = p->xU * P_delta_yaw_Sx_theta;
    const double M_22_mU = yaw_by_delta * P_delta_yaw_mU;
    const double t517 = K0_13_mU * yaw_by_delta;
    const double t518 = p->xU * t517;
    const double t519 = yaw_per_v_delta * K0_11_mU;
    const double t521 = t512 + (p->xU * t519);
    const double C1_22_mU = (yaw_per_v_delta * P_delta_yaw_mU) + (yaw_by_delta *
        P_delta_yaw_Sx_theta);
    const double t525 = K0_13_mU * yaw_per_v_delta;
    const double t527 = t517 + (p->xU * t525);
    const double t528 = sin_lam * P_delta_yaw_Sx_theta;
    const double K2_22_mU = yaw_per_v_delta * P_delta_yaw_Sx_theta;
    const double t530 = p->mU * t512;
    const double P_delta_yaw_xU = M_23_zP + (p->mU * P_delta_yaw_Sx_theta);
    const double M_22_xU = yaw_by_delta * P_delta_yaw_xU;
    const double t534 = p->mU * t517;
    const double t535 = p->mU * t519;
    const double C1_22_xU = (yaw_per_v_delta * P_delta_yaw_xU) + (yaw_by_delta * t502);
    const double t539 = p->mU * t525;
    const double t540 = sin_lam * t502;
    const double K2_22_xU = yaw_per_v_delta * t502;
    const double M_11_zU = t31 + M_13_zU;
    const double C1_21 = -(t127 + (yaw_by_delta * h_wheels_all));
    const double K2_32 = -t161;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_phi_theta;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = P_delta_theta;
    matrices->m[2][0] = M_phi_theta;
    matrices->m[2][1] = P_delta_theta;
    matrices->m[2][2] = Jxx_theta;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = 0.0;
    matrices->c0[0][2] = 0.0;
    matrices->c0[1][0] = 0.0;
    matrices->c0[1][1] = 0.0;
    matrices->c0[1][2] = 0.0;
    matrices->c0[2][0] = 0.0;
    matrices->c0[2][1] = 0.0;
    matrices->c0[2][2] = p->dU;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = C1_12;
    matrices->c1[0][2] = 0.0;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->c1[1][2] = 0.0;
    matrices->c1[2][0] = 0.0;
    matrices->c1[2][1] = C1_32;
    matrices->c1[2][2] = 0.0;
    matrices->kc[0][0] = 0.0;
    matrices->kc[0][1] = 0.0;
    matrices->kc[0][2] = 0.0;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = 0.0;
    matrices->kc[1][2] = 0.0;
    matrices->kc[2][0] = 0.0;
    matrices->kc[2][1] = 0.0;
    matrices->kc[2][2] = p->kU;
    matrices->k0[0][0] = Sz_all;
    matrices->k0[0][1] = K0_12;
    matrices->k0[0][2] = Sz_theta;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0;
    matrices->k0[2][0] = Sz_theta;
    matrices->k0[2][1] = 0.0;
    matrices->k0[2][2] = Sz_theta;
    matrices->k2[0][0] = 0.0;
    matrices->k2[0][1] = K2_12;
    matrices->k2[0][2] = 0.0;
    matrices->k2[1][0] = 0.0;
    matrices->k2[1][1] = K2_22;
    matrices->k2[1][2] = 0.0;
    matrices->k2[2][0] = 0.0;
    matrices->k2[2][1] = K2_32;
    matrices->k2[2][2] = 0.0;
    derivatives->values[0] = M_12_w;
    derivatives->values[1] = M_22_w;
    derivatives->values[2] = t197;
    derivatives->values[3] = C1_12_w;
    derivatives->values[4] = C1_21_w;
    derivatives->values[5] = C1_22_w;
    derivatives->values[6] = t223;
    derivatives->values[7] = K0_12_w;
    derivatives->values[8] = K0_22_w;
    derivatives->values[9] = t225;
    derivatives->values[10] = t228;
    derivatives->values[11] = K2_32_w;
    derivatives->values[12] = M_12_c;
    derivatives->values[13] = M_22_c;
    derivatives->values[14] = M_23_c;
    derivatives->values[15] = C1_12_c;
    derivatives->values[16] = t255;
    derivatives->values[17] = C1_22_c;
    derivatives->values[18] = t161;
    derivatives->values[19] = K0_12_c;
    derivatives->values[20] = K0_22_c;
    derivatives->values[21] = t263;
    derivatives->values[22] = M_12_lam;
    derivatives->values[23] = M_22_lam;
    derivatives->values[24] = t287;
    derivatives->values[25] = t289;
    derivatives->values[26] = C1_21_lam;
    derivatives->values[27] = C1_22_lam;
    derivatives->values[28] = t299;
    derivatives->values[29] = K0_12_lam;
    derivatives->values[30] = K0_22_lam;
    derivatives->values[31] = t303;
    derivatives->values[32] = K2_22_lam;
    derivatives->values[33] = K2_32_lam;
    derivatives->values[34] = M_11_rR;
    derivatives->values[35] = C1_12_rR;
    derivatives->values[36] = C1_21_rR;
    derivatives->values[37] = p->mR;
    derivatives->values[38] = K2_12_rR;
    derivatives->values[39] = M_11_mR;
    derivatives->values[40] = C1_12_mR;
    derivatives->values[41] = p->rR;
    derivatives->values[42] = K2_12_mR;
    derivatives->values[43] = 1.0;
    derivatives->values[44] = M_22_IRxx;
    derivatives->values[45] = C1_22_IRxx;
    derivatives->values[46] = C1_12_IRyy;
    derivatives->values[47] = K2_12_IRyy;
    derivatives->values[48] = t323;
    derivatives->values[49] = M_22_xB;
    derivatives->values[50] = t329;
    derivatives->values[51] = C1_22_xB;
    derivatives->values[52] = t331;
    derivatives->values[53] = t334;
    derivatives->values[54] = K2_22_xB;
    derivatives->values[55] = M_11_zB;
    derivatives->values[56] = t325;
    derivatives->values[57] = t339;
    derivatives->values[58] = p->mB;
    derivatives->values[59] = t340;
    derivatives->values[60] = M_11_mB;
    derivatives->values[61] = t342;
    derivatives->values[62] = M_22_mB;
    derivatives->values[63] = t345;
    derivatives->values[64] = C1_22_mB;
    derivatives->values[65] = p->zB;
    derivatives->values[66] = t324;
    derivatives->values[67] = t349;
    derivatives->values[68] = t350;
    derivatives->values[69] = K2_22_mB;
    derivatives->values[70] = yaw_by_delta;
    derivatives->values[71] = yaw_per_v_delta;
    derivatives->values[72] = t163;
    derivatives->values[73] = M_22_xH;
    derivatives->values[74] = t198;
    derivatives->values[75] = C1_22_xH;
    derivatives->values[76] = P_delta_lateral_xH;
    derivatives->values[77] = t364;
    derivatives->values[78] = K2_22_xH;
    derivatives->values[79] = M_11_zH;
    derivatives->values[80] = M_12_zH;
    derivatives->values[81] = M_22_zH;
    derivatives->values[82] = C1_12_zH;
    derivatives->values[83] = C1_22_zH;
    derivatives->values[84] = p->mH;
    derivatives->values[85] = K0_12_zH;
    derivatives->values[86] = K0_22_zH;
    derivatives->values[87] = t397;
    derivatives->values[88] = t398;
    derivatives->values[89] = M_11_mH;
    derivatives->values[90] = M_12_mH;
    derivatives->values[91] = M_22_mH;
    derivatives->values[92] = C1_12_mH;
    derivatives->values[93] = C1_22_mH;
    derivatives->values[94] = p->zH;
    derivatives->values[95] = K0_12_mH;
    derivatives->values[96] = K0_22_mH;
    derivatives->values[97] = t423;
    derivatives->values[98] = t424;
    derivatives->values[99] = sin_lam;
    derivatives->values[100] = M_22_Jxx_delta;
    derivatives->values[101] = M_22_IHzz;
    derivatives->values[102] = C1_22_IHzz;
    derivatives->values[103] = C1_12_h_spin_F;
    derivatives->values[104] = M_22_IHxz;
    derivatives->values[105] = K2_22_h_spin_F;
    derivatives->values[106] = M_11_rF;
    derivatives->values[107] = M_12_rF;
    derivatives->values[108] = M_22_rF;
    derivatives->values[109] = C1_12_rF;
    derivatives->values[110] = C1_21_rF;
    derivatives->values[111] = C1_22_rF;
    derivatives->values[112] = p->mF;
    derivatives->values[113] = t441;
    derivatives->values[114] = t462;
    derivatives->values[115] = K2_12_rF;
    derivatives->values[116] = K2_22_rF;
    derivatives->values[117] = M_11_mF;
    derivatives->values[118] = M_12_mF;
    derivatives->values[119] = M_22_mF;
    derivatives->values[120] = C1_12_mF;
    derivatives->values[121] = C1_22_mF;
    derivatives->values[122] = p->rF;
    derivatives->values[123] = K0_12_mF;
    derivatives->values[124] = K0_22_mF;
    derivatives->values[125] = K2_12_mF;
    derivatives->values[126] = t493;
    derivatives->values[127] = M_22_IFxx;
    derivatives->values[128] = C1_12_IFyy;
    derivatives->values[129] = K2_12_IFyy;
    derivatives->values[130] = K2_22_IFyy;
    derivatives->values[131] = M_13_zP;
    derivatives->values[132] = M_23_zP;
    derivatives->values[133] = M_33_zU;
    derivatives->values[134] = C1_32_zP;
    derivatives->values[135] = p->mU;
    derivatives->values[136] = K2_32_zP;
    derivatives->values[137] = M_11_mU;
    derivatives->values[138] = t513;
    derivatives->values[139] = M_13_mU;
    derivatives->values[140] = M_22_mU;
    derivatives->values[141] = t518;
    derivatives->values[142] = Jxx_theta_mU;
    derivatives->values[143] = t521;
    derivatives->values[144] = C1_22_mU;
    derivatives->values[145] = t527;
    derivatives->values[146] = K0_11_mU;
    derivatives->values[147] = P_delta_yaw_Sx_theta;
    derivatives->values[148] = K0_13_mU;
    derivatives->values[149] = t528;
    derivatives->values[150] = t519;
    derivatives->values[151] = K2_22_mU;
    derivatives->values[152] = t525;
    derivatives->values[153] = t530;
    derivatives->values[154] = M_22_xU;
    derivatives->values[155] = t534;
    derivatives->values[156] = t535;
    derivatives->values[157] = C1_22_xU;
    derivatives->values[158] = t539;
    derivatives->values[159] = t502;
    derivatives->values[160] = t540;
    derivatives->values[161] = K2_22_xU;
    derivatives->values[162] = M_11_zU;
    derivatives->values[163] = M_13_zU;
}

void whipple_leaning_f64_with_respect_to(const whipple_leaning_f64_derivatives_t *derivatives,
    size_t parameter, whipple_leaning_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHIPPLE_LEANING_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_LEANING_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c0[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->kc[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
            matrices->k2[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < WHIPPLE_LEANING_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &whipple_leaning_partials[position];
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

const whipple_leaning_f32_t whipple_leaning_f32_sets[WHIPPLE_LEANING_SETS] = {
    { /* example */
        .w = 1.02F,
        .c = 0.08F,
        .lam = 0.31415927F,
        .g = 9.81F,
        .rR = 0.3F,
        .mR = 2.0F,
        .IRxx = 0.0603F,
        .IRyy = 0.12F,
        .xB = 0.3F,
        .zB = (-0.7F),
        .mB = 45.0F,
        .IBxx = 4.0F,
        .IByy = 5.5F,
        .IBzz = 1.8F,
        .IBxz = 1.2F,
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
        .zP = (-0.85F),
        .mU = 40.0F,
        .xU = 0.3F,
        .zU = (-1.125F),
        .IUxx = 1.6F,
        .IUyy = 1.6F,
        .IUzz = 0.6F,
        .IUxz = 0.0F,
        .kU = 600.0F,
        .dU = 60.0F
    }
};

whipple_leaning_validity_t whipple_leaning_f32_validate(const whipple_leaning_f32_t *p)
{
    whipple_leaning_validity_t validity = WHIPPLE_LEANING_VALID;
    if (!((p->w > 0.0F) && (p->w <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_w;
    } else if (!((p->c >= -FLT_MAX) && (p->c <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_c;
    } else if (!((p->lam > (-1.5707964F)) && (p->lam < 1.5707964F))) {
        validity = WHIPPLE_LEANING_INVALID_lam;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_g;
    } else if (!((p->rR > 0.0F) && (p->rR <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_rR;
    } else if (!((p->mR >= 0.0F) && (p->mR <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_mR;
    } else if (!((p->IRxx >= 0.0F) && (p->IRxx <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0F) && (p->IRyy <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IRyy;
    } else if (!((p->xB >= -FLT_MAX) && (p->xB <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_xB;
    } else if (!((p->zB >= -FLT_MAX) && (p->zB <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_zB;
    } else if (!((p->mB >= 0.0F) && (p->mB <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_mB;
    } else if (!((p->IBxx >= 0.0F) && (p->IBxx <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0F) && (p->IByy <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0F) && (p->IBzz <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IBzz;
    } else if (!((p->IBxz >= -FLT_MAX) && (p->IBxz <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IBxz;
    } else if (!((p->xH >= -FLT_MAX) && (p->xH <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_xH;
    } else if (!((p->zH >= -FLT_MAX) && (p->zH <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_zH;
    } else if (!((p->mH >= 0.0F) && (p->mH <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_mH;
    } else if (!((p->IHxx >= 0.0F) && (p->IHxx <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0F) && (p->IHyy <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0F) && (p->IHzz <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IHzz;
    } else if (!((p->IHxz >= -FLT_MAX) && (p->IHxz <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IHxz;
    } else if (!((p->rF > 0.0F) && (p->rF <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_rF;
    } else if (!((p->mF >= 0.0F) && (p->mF <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_mF;
    } else if (!((p->IFxx >= 0.0F) && (p->IFxx <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0F) && (p->IFyy <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IFyy;
    } else if (!((p->zP >= -FLT_MAX) && (p->zP <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_zP;
    } else if (!((p->mU >= 0.0F) && (p->mU <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_mU;
    } else if (!((p->xU >= -FLT_MAX) && (p->xU <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_xU;
    } else if (!((p->zU >= -FLT_MAX) && (p->zU <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_zU;
    } else if (!((p->IUxx >= 0.0F) && (p->IUxx <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IUxx;
    } else if (!((p->IUyy >= 0.0F) && (p->IUyy <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IUyy;
    } else if (!((p->IUzz >= 0.0F) && (p->IUzz <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IUzz;
    } else if (!((p->IUxz >= -FLT_MAX) && (p->IUxz <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_IUxz;
    } else if (!((p->kU >= 0.0F) && (p->kU <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_kU;
    } else if (!((p->dU >= 0.0F) && (p->dU <= FLT_MAX))) {
        validity = WHIPPLE_LEANING_INVALID_dU;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void whipple_leaning_f32_matrices(const whipple_leaning_f32_t *p, whipple_leaning_f32_matrices_t *matrices)
{
    const float t5 = p->zU - p->zP;
    const float Sz_theta = t5 * p->mU;
    const float Jxx_theta = p->IUxx + (t5 * Sz_theta);
    const float t14 = p->zH * p->mH;
    const float t18 = p->rF * p->mF;
    const float Jxx_delta = p->IHxx + p->IFxx + (p->zH * t14) + (p->rF * t18);
    const float t25 = p->rR * p->mR;
    const float t29 = p->zB * p->mB;
    const float t32 = Sz_theta + (p->zP * p->mU);
    const float M_11 = p->IRxx + p->IBxx + Jxx_theta + Jxx_delta + (p->rR * t25) + (p->zB * t29) +
        (p->zP * (Sz_theta + t32));
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t49 = p->c + p->w;
    const float t50 = t49 - p->xH;
    const float Jxz_delta = p->IHxz + (t14 * t50) - (t18 * p->c);
    const float hx_delta = (Jxx_delta * sin_lam) + (Jxz_delta * cos_lam);
    const float yaw_per_v_delta = cos_lam / p->w;
    const float yaw_by_delta = p->c * yaw_per_v_delta;
    const float Sx_theta = p->mU * p->xU;
    const float Jxz_theta = p->IUxz - (t5 * Sx_theta);
    const float Sz_delta = t14 - t18;
    const float Jxz_all = Jxz_delta + p->IBxz + Jxz_theta - (t29 * p->xB) - (p->zP * Sx_theta) -
        (t49 * Sz_delta);
    const float M_12 = hx_delta + (yaw_by_delta * Jxz_all);
    const float M_phi_theta = Jxx_theta + (p->zP * Sz_theta);
    const float t80 = p->mH * t50;
    const float t82 = p->mF * p->c;
    const float t85 = p->IFxx + p->IHzz;
    const float hz_delta = (sin_lam * Jxz_delta) + (cos_lam * ((t50 * t80) + (p->c * t82) + t85));
    const float t91 = t80 + t82;
    const float t93 = (sin_lam * Sz_delta) + (cos_lam * t91);
    const float M_yaw_delta = hz_delta - (t49 * t93);
    const float t98 = p->mB * p->xB;
    const float t110 = p->IRxx + t85 + p->IBzz + p->IUzz + (p->xB * t98) + (p->mH * p->xH * p->xH) +
        (p->mF * p->w * p->w);
    const float P_delta_yaw = M_yaw_delta + (yaw_by_delta * (t110 + (p->xU * Sx_theta)));
    const float M_22 = (yaw_by_delta * (M_yaw_delta + P_delta_yaw)) + (sin_lam * hx_delta) +
        (cos_lam * hz_delta);
    const float P_delta_theta = yaw_by_delta * Jxz_theta;
    const float h_spin_F = p->IFyy / p->rF;
    const float h_wheels_all = h_spin_F + (p->IRyy / p->rR);
    const float Sz_all = t29 + t32 + Sz_delta - t25;
    const float t131 = h_wheels_all - Sz_all;
    const float t134 = cos_lam * h_spin_F;
    const float C1_12 = (yaw_by_delta * t131) + (yaw_per_v_delta * Jxz_all) + t134;
    const float Sx_all = Sx_theta + t98 + (t49 * (p->mH + p->mF)) - t91;
    const float t144 = yaw_by_delta * Sx_all;
    const float P_delta_lateral = t144 - t93;
    const float C1_22 = (yaw_by_delta * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
    const float C1_32 = (yaw_per_v_delta * Jxz_theta) - (Sz_theta * yaw_by_delta);
    const float K2_12 = yaw_per_v_delta * t131;
    const float K2_22 = yaw_per_v_delta * (P_delta_lateral + (sin_lam * h_spin_F));
    const float C1_21 = -(t134 + (yaw_by_delta * h_wheels_all));
    const float K0_12 = t93 - t144;
    const float K0_22 = -(sin_lam * P_delta_lateral);
    const float K2_32 = -(Sz_theta * yaw_per_v_delta);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_phi_theta;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = P_delta_theta;
    matrices->m[2][0] = M_phi_theta;
    matrices->m[2][1] = P_delta_theta;
    matrices->m[2][2] = Jxx_theta;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[0][2] = 0.0F;
    matrices->c0[1][0] = 0.0F;
    matrices->c0[1][1] = 0.0F;
    matrices->c0[1][2] = 0.0F;
    matrices->c0[2][0] = 0.0F;
    matrices->c0[2][1] = 0.0F;
    matrices->c0[2][2] = p->dU;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = C1_12;
    matrices->c1[0][2] = 0.0F;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->c1[1][2] = 0.0F;
    matrices->c1[2][0] = 0.0F;
    matrices->c1[2][1] = C1_32;
    matrices->c1[2][2] = 0.0F;
    matrices->kc[0][0] = 0.0F;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[0][2] = 0.0F;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = 0.0F;
    matrices->kc[1][2] = 0.0F;
    matrices->kc[2][0] = 0.0F;
    matrices->kc[2][1] = 0.0F;
    matrices->kc[2][2] = p->kU;
    matrices->k0[0][0] = Sz_all;
    matrices->k0[0][1] = K0_12;
    matrices->k0[0][2] = Sz_theta;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0F;
    matrices->k0[2][0] = Sz_theta;
    matrices->k0[2][1] = 0.0F;
    matrices->k0[2][2] = Sz_theta;
    matrices->k2[0][0] = 0.0F;
    matrices->k2[0][1] = K2_12;
    matrices->k2[0][2] = 0.0F;
    matrices->k2[1][0] = 0.0F;
    matrices->k2[1][1] = K2_22;
    matrices->k2[1][2] = 0.0F;
    matrices->k2[2][0] = 0.0F;
    matrices->k2[2][1] = K2_32;
    matrices->k2[2][2] = 0.0F;
}

carvallo_system_error_t whipple_leaning_f32_at_speed(const whipple_leaning_f32_matrices_t *matrices,
    float speed, float gravity, whipple_leaning_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed) && carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < WHIPPLE_LEANING_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_LEANING_N; column++) {
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

carvallo_system_error_t whipple_leaning_f32_state_space(const whipple_leaning_f32_system_t *system,
    whipple_leaning_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[WHIPPLE_LEANING_N * WHIPPLE_LEANING_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * WHIPPLE_LEANING_N * WHIPPLE_LEANING_N];
    for (size_t row = 0U; row < WHIPPLE_LEANING_N; row++) {
        float *const solved = &x[3U * WHIPPLE_LEANING_N * row];
        for (size_t column = 0U; column < WHIPPLE_LEANING_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * WHIPPLE_LEANING_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHIPPLE_LEANING_N + column] = -system->c[row][column];
            solved[(2U * WHIPPLE_LEANING_N) + column] = 0.0F;
        }
        solved[(2U * WHIPPLE_LEANING_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[WHIPPLE_LEANING_N * WHIPPLE_LEANING_N];
        error = carvallo_solve_f32(WHIPPLE_LEANING_N, m, terms, 3U * WHIPPLE_LEANING_N, x);
    }
    for (size_t row = 0U; row < (2U * WHIPPLE_LEANING_N); row++) {
        for (size_t column = 0U; column < (2U * WHIPPLE_LEANING_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < WHIPPLE_LEANING_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHIPPLE_LEANING_N; row++) {
            const size_t target = WHIPPLE_LEANING_N + row;
            for (size_t column = 0U; column < (2U * WHIPPLE_LEANING_N); column++) {
                space->a[target][column] = x[(3U * WHIPPLE_LEANING_N * row) + column];
            }
            for (size_t column = 0U; column < WHIPPLE_LEANING_N; column++) {
                space->b[target][column] = x[(3U * WHIPPLE_LEANING_N * row) + (2U *
                    WHIPPLE_LEANING_N) + column];
            }
            space->a[row][WHIPPLE_LEANING_N + row] = 1.0F;
        }
    }
    return error;
}

float whipple_leaning_f32_rate_at(const whipple_leaning_f32_rate_t *rate, float v,
    const float q[WHIPPLE_LEANING_N], const float q_dot[WHIPPLE_LEANING_N], float psi)
{
    float by_coordinates = 0.0F;
    float by_rates = 0.0F;
    for (size_t i = 0U; i < WHIPPLE_LEANING_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void whipple_leaning_f32_kinematics(const whipple_leaning_f32_t *p, whipple_leaning_f32_kinematics_t *kinematics)
{
    const float yaw_per_v_delta = carvallo_cos_f32(p->lam) / p->w;
    const float yaw_by_delta = p->c * yaw_per_v_delta;
    const float t12 = -(1.0F / p->rR);
    const float t13 = -(1.0F / p->rF);
    kinematics->lateral.speed = 0.0F;
    kinematics->lateral.rates[0] = 0.0F;
    kinematics->lateral.rates[1] = 0.0F;
    kinematics->lateral.rates[2] = 0.0F;
    kinematics->lateral.coordinates[0] = 0.0F;
    kinematics->lateral.coordinates[1] = 0.0F;
    kinematics->lateral.coordinates[2] = 0.0F;
    kinematics->lateral.heading = 1.0F;
    kinematics->yaw.speed = 0.0F;
    kinematics->yaw.rates[0] = 0.0F;
    kinematics->yaw.rates[1] = yaw_by_delta;
    kinematics->yaw.rates[2] = 0.0F;
    kinematics->yaw.coordinates[0] = 0.0F;
    kinematics->yaw.coordinates[1] = yaw_per_v_delta;
    kinematics->yaw.coordinates[2] = 0.0F;
    kinematics->yaw.heading = 0.0F;
    kinematics->wheel_R.speed = t12;
    kinematics->wheel_R.rates[0] = 0.0F;
    kinematics->wheel_R.rates[1] = 0.0F;
    kinematics->wheel_R.rates[2] = 0.0F;
    kinematics->wheel_R.coordinates[0] = 0.0F;
    kinematics->wheel_R.coordinates[1] = 0.0F;
    kinematics->wheel_R.coordinates[2] = 0.0F;
    kinematics->wheel_R.heading = 0.0F;
    kinematics->wheel_F.speed = t13;
    kinematics->wheel_F.rates[0] = 0.0F;
    kinematics->wheel_F.rates[1] = 0.0F;
    kinematics->wheel_F.rates[2] = 0.0F;
    kinematics->wheel_F.coordinates[0] = 0.0F;
    kinematics->wheel_F.coordinates[1] = 0.0F;
    kinematics->wheel_F.coordinates[2] = 0.0F;
    kinematics->wheel_F.heading = 0.0F;
    kinematics->forces[0][0] = 1.0F;
    kinematics->forces[0][1] = 0.0F;
    kinematics->forces[0][2] = 0.0F;
    kinematics->forces[1][0] = 0.0F;
    kinematics->forces[1][1] = 1.0F;
    kinematics->forces[1][2] = 0.0F;
    kinematics->forces[2][0] = 0.0F;
    kinematics->forces[2][1] = 0.0F;
    kinematics->forces[2][2] = 1.0F;
}

void whipple_leaning_f32_derivatives(const whipple_leaning_f32_t *p,
    whipple_leaning_f32_matrices_t *matrices, whipple_leaning_f32_derivatives_t *derivatives)
{
    const float K0_13_mU = p->zU - p->zP;
    const float Sz_theta = K0_13_mU * p->mU;
    const float Jxx_theta = p->IUxx + (K0_13_mU * Sz_theta);
    const float t14 = p->zH * p->mH;
    const float t18 = p->rF * p->mF;
    const float Jxx_delta = p->IHxx + p->IFxx + (p->zH * t14) + (p->rF * t18);
    const float t25 = p->rR * p->mR;
    const float t29 = p->zB * p->mB;
    const float t31 = p->zP * p->mU;
    const float t32 = Sz_theta + t31;
    const float M_11 = p->IRxx + p->IBxx + Jxx_theta + Jxx_delta + (p->rR * t25) + (p->zB * t29) +
        (p->zP * (Sz_theta + t32));
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t48 = p->c + p->w;
    const float t50 = t48 - p->xH;
    const float Jxz_delta = p->IHxz + (t14 * t50) - (t18 * p->c);
    const float t55 = Jxz_delta * cos_lam;
    const float hx_delta = (Jxx_delta * sin_lam) + t55;
    const float t57 = 1.0F / p->w;
    const float yaw_per_v_delta = cos_lam * t57;
    const float yaw_by_delta = p->c * yaw_per_v_delta;
    const float Sx_theta = p->mU * p->xU;
    const float Jxz_theta = p->IUxz - (K0_13_mU * Sx_theta);
    const float Sz_delta = t14 - t18;
    const float Jxz_all = Jxz_delta + p->IBxz + Jxz_theta - (t29 * p->xB) - (p->zP * Sx_theta) -
        (t48 * Sz_delta);
    const float M_12 = hx_delta + (yaw_by_delta * Jxz_all);
    const float M_phi_theta = Jxx_theta + (p->zP * Sz_theta);
    const float t81 = sin_lam * Jxz_delta;
    const float t83 = p->IFxx + p->IHzz;
    const float t84 = p->mF * p->c;
    const float t86 = p->mH * t50;
    const float t89 = t83 + (p->c * t84) + (t50 * t86);
    const float hz_delta = t81 + (cos_lam * t89);
    const float t94 = t84 + t86;
    const float t96 = (sin_lam * Sz_delta) + (cos_lam * t94);
    const float M_yaw_delta = hz_delta - (t48 * t96);
    const float t101 = p->mB * p->xB;
    const float t103 = p->xH * p->xH;
    const float t105 = p->w * p->w;
    const float t113 = p->IRxx + t83 + p->IBzz + p->IUzz + (p->xB * t101) + (p->mH * t103) +
        (p->mF * t105);
    const float P_delta_yaw_yaw_by_delta = t113 + (p->xU * Sx_theta);
    const float t115 = yaw_by_delta * P_delta_yaw_yaw_by_delta;
    const float P_delta_yaw = M_yaw_delta + t115;
    const float t117 = M_yaw_delta + P_delta_yaw;
    const float M_22 = (sin_lam * hx_delta) + (cos_lam * hz_delta) + (yaw_by_delta * t117);
    const float P_delta_theta = yaw_by_delta * Jxz_theta;
    const float t125 = 1.0F / p->rF;
    const float h_spin_F = p->IFyy * t125;
    const float t127 = cos_lam * h_spin_F;
    const float t129 = 1.0F / p->rR;
    const float t130 = p->IRyy * t129;
    const float h_wheels_all = h_spin_F + t130;
    const float Sz_all = t29 + t32 + Sz_delta - t25;
    const float t135 = h_wheels_all - Sz_all;
    const float t137 = yaw_per_v_delta * Jxz_all;
    const float C1_12 = t127 + (yaw_by_delta * t135) + t137;
    const float Sx_all = Sx_theta + t101 + (t48 * (p->mH + p->mF)) - t94;
    const float K0_12 = t96 - (yaw_by_delta * Sx_all);
    const float C1_22 = (yaw_per_v_delta * P_delta_yaw) - (yaw_by_delta * K0_12);
    const float M_23_c = yaw_per_v_delta * Jxz_theta;
    const float C1_32 = M_23_c - (Sz_theta * yaw_by_delta);
    const float K0_22 = sin_lam * K0_12;
    const float K2_12 = yaw_per_v_delta * t135;
    const float t158 = sin_lam * h_spin_F;
    const float K2_22_yaw_per_v_delta = t158 - K0_12;
    const float K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
    const float t161 = Sz_theta * yaw_per_v_delta;
    const float C1_12_h_spin_F = cos_lam + yaw_by_delta;
    const float t163 = t14 * C1_12_h_spin_F;
    const float t165 = t163 - (yaw_by_delta * Sz_delta);
    const float t166 = t57 * yaw_per_v_delta;
    const float M_12_yaw_per_v_delta = p->c * Jxz_all;
    const float M_12_w = t165 - (t166 * M_12_yaw_per_v_delta);
    const float t170 = sin_lam * cos_lam;
    const float M_22_Jxz_delta = t170 + t170;
    const float t173 = t50 * cos_lam;
    const float t176 = (p->mH * t173) + (cos_lam * t86);
    const float t178 = (t14 * M_22_Jxz_delta) + (cos_lam * t176);
    const float t179 = t14 * sin_lam;
    const float t180 = t176 + t179;
    const float t181 = t180 - t96;
    const float t182 = p->mH * cos_lam;
    const float t183 = t48 * t182;
    const float M_yaw_delta_w = t181 - t183;
    const float t185 = yaw_by_delta + yaw_by_delta;
    const float P_delta_yaw_w = p->mF * p->w * t185;
    const float t188 = M_yaw_delta_w + P_delta_yaw_w;
    const float M_22_yaw_by_delta = t115 + t117;
    const float M_22_yaw_per_v_delta = p->c * M_22_yaw_by_delta;
    const float M_22_w = t178 + (yaw_by_delta * (M_yaw_delta_w + t188)) - (t166 *
        M_22_yaw_per_v_delta);
    const float P_delta_theta_yaw_per_v_delta = p->c * Jxz_theta;
    const float t197 = t166 * P_delta_theta_yaw_per_v_delta;
    const float t198 = t14 * yaw_per_v_delta;
    const float t200 = t198 - (yaw_per_v_delta * Sz_delta);
    const float C1_12_yaw_per_v_delta = Jxz_all + (p->c * t135);
    const float C1_12_w = t200 - (t166 * C1_12_yaw_per_v_delta);
    const float t205 = p->c * h_wheels_all;
    const float C1_21_w = t166 * t205;
    const float t209 = p->c * Sx_all;
    const float K0_12_w = t182 + (t166 * t209) - (p->mF * yaw_by_delta);
    const float C1_22_yaw_by_delta = (yaw_per_v_delta * P_delta_yaw_yaw_by_delta) - K0_12;
    const float C1_22_yaw_per_v_delta = P_delta_yaw + (p->c * C1_22_yaw_by_delta);
    const float C1_22_w = (yaw_per_v_delta * t188) - (yaw_by_delta * K0_12_w) - (t166 *
        C1_22_yaw_per_v_delta);
    const float C1_32_yaw_per_v_delta = Jxz_theta - (Sz_theta * p->c);
    const float t223 = t166 * C1_32_yaw_per_v_delta;
    const float K0_22_w = sin_lam * K0_12_w;
    const float t225 = t135 * t166;
    const float t228 = (yaw_per_v_delta * K0_12_w) + (K2_22_yaw_per_v_delta * t166);
    const float K2_32_w = Sz_theta * t166;
    const float M_12_c = t137 + t165 - (t18 * C1_12_h_spin_F);
    const float t234 = p->c * cos_lam;
    const float hz_delta_c = (p->mF * t234) + (cos_lam * t84);
    const float t238 = t18 * sin_lam;
    const float t240 = t182 + (p->mF * cos_lam);
    const float M_yaw_delta_c = t181 + hz_delta_c - t238 - (t48 * t240);
    const float M_22_c = t178 + (t185 * M_yaw_delta_c) + (cos_lam * hz_delta_c) + (yaw_per_v_delta *
        M_22_yaw_by_delta) - (t18 * M_22_Jxz_delta);
    const float C1_12_c = t200 + (yaw_per_v_delta * (t135 - t18));
    const float t255 = yaw_per_v_delta * h_wheels_all;
    const float K0_12_c = t240 - (yaw_per_v_delta * Sx_all);
    const float C1_22_c = (yaw_per_v_delta * (C1_22_yaw_by_delta + M_yaw_delta_c)) - (yaw_by_delta *
        K0_12_c);
    const float K0_22_c = sin_lam * K0_12_c;
    const float t263 = yaw_per_v_delta * K0_12_c;
    const float hx_delta_lam = (Jxx_delta * cos_lam) - t81;
    const float t266 = sin_lam * t57;
    const float M_12_lam = hx_delta_lam - (M_12_yaw_per_v_delta * t266);
    const float hz_delta_lam = t55 - (sin_lam * t89);
    const float t273 = (cos_lam * Sz_delta) - (sin_lam * t94);
    const float M_yaw_delta_lam = hz_delta_lam - (t48 * t273);
    const float M_22_lam = (t185 * M_yaw_delta_lam) + (sin_lam * hx_delta_lam) + (cos_lam *
        hz_delta_lam) + (cos_lam * hx_delta) - (sin_lam * hz_delta) - (M_22_yaw_per_v_delta * t266);
    const float t287 = P_delta_theta_yaw_per_v_delta * t266;
    const float t289 = t158 + (C1_12_yaw_per_v_delta * t266);
    const float C1_21_lam = t158 + (t205 * t266);
    const float K0_12_lam = t273 + (t209 * t266);
    const float C1_22_lam = (yaw_per_v_delta * M_yaw_delta_lam) - (yaw_by_delta * K0_12_lam) -
        (C1_22_yaw_per_v_delta * t266);
    const float t299 = C1_32_yaw_per_v_delta * t266;
    const float K0_22_lam = (sin_lam * K0_12_lam) + (cos_lam * K0_12);
    const float t303 = t135 * t266;
    const float K2_22_lam = (yaw_per_v_delta * (t127 - K0_12_lam)) - (K2_22_yaw_per_v_delta * t266);
    const float K2_32_lam = Sz_theta * t266;
    const float M_11_rR = t25 + t25;
    const float t310 = t129 * t130;
    const float t311 = p->mR - t310;
    const float C1_12_rR = yaw_by_delta * t311;
    const float C1_21_rR = yaw_by_delta * t310;
    const float K2_12_rR = yaw_per_v_delta * t311;
    const float M_11_mR = p->rR * p->rR;
    const float C1_12_mR = p->rR * yaw_by_delta;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float M_22_IRxx = yaw_by_delta * yaw_by_delta;
    const float C1_22_IRxx = yaw_per_v_delta * yaw_by_delta;
    const float C1_12_IRyy = yaw_by_delta * t129;
    const float K2_12_IRyy = yaw_per_v_delta * t129;
    const float t323 = t29 * yaw_by_delta;
    const float t324 = yaw_by_delta * p->xB;
    const float t325 = p->mB * t324;
    const float P_delta_yaw_xB = t325 + (yaw_by_delta * t101);
    const float M_22_xB = yaw_by_delta * P_delta_yaw_xB;
    const float t329 = t29 * yaw_per_v_delta;
    const float t331 = p->mB * yaw_by_delta;
    const float C1_22_xB = (yaw_per_v_delta * P_delta_yaw_xB) + (yaw_by_delta * t331);
    const float t334 = sin_lam * t331;
    const float K2_22_xB = yaw_per_v_delta * t331;
    const float M_11_zB = t29 + t29;
    const float t338 = yaw_by_delta + (yaw_per_v_delta * p->xB);
    const float t339 = p->mB * t338;
    const float t340 = p->mB * yaw_per_v_delta;
    const float M_11_mB = p->zB * p->zB;
    const float t342 = p->zB * t324;
    const float P_delta_yaw_mB = p->xB * t324;
    const float M_22_mB = yaw_by_delta * P_delta_yaw_mB;
    const float t345 = p->zB * t338;
    const float C1_22_mB = (yaw_per_v_delta * P_delta_yaw_mB) + (yaw_by_delta * t324);
    const float t349 = sin_lam * t324;
    const float t350 = p->zB * yaw_per_v_delta;
    const float K2_22_mB = yaw_per_v_delta * t324;
    const float M_yaw_delta_xH = t183 - t180;
    const float P_delta_yaw_xH = p->mH * p->xH * t185;
    const float t355 = M_yaw_delta_xH + P_delta_yaw_xH;
    const float M_22_xH = (yaw_by_delta * (M_yaw_delta_xH + t355)) - t178;
    const float P_delta_lateral_xH = t182 + (p->mH * yaw_by_delta);
    const float C1_22_xH = (yaw_per_v_delta * t355) + (yaw_by_delta * P_delta_lateral_xH);
    const float t364 = sin_lam * P_delta_lateral_xH;
    const float K2_22_xH = yaw_per_v_delta * P_delta_lateral_xH;
    const float M_11_zH = t14 + t14;
    const float t367 = t48 * yaw_by_delta;
    const float t369 = p->zH * sin_lam;
    const float t371 = (t50 * C1_12_h_spin_F) + t369 - t367;
    const float M_12_zH = t179 + (p->mH * t371);
    const float K0_12_zH = p->mH * sin_lam;
    const float t376 = sin_lam * t50;
    const float M_yaw_delta_zH = (p->mH * t376) - (t48 * K0_12_zH);
    const float M_22_Jxx_delta = sin_lam * sin_lam;
    const float t383 = (p->zH * M_22_Jxx_delta) + (t50 * M_22_Jxz_delta);
    const float M_22_zH = (t185 * M_yaw_delta_zH) + (p->mH * t383) + (t14 * M_22_Jxx_delta);
    const float t389 = yaw_by_delta + (t48 * yaw_per_v_delta);
    const float t391 = (t50 * yaw_per_v_delta) - t389;
    const float C1_12_zH = p->mH * t391;
    const float C1_22_zH = (yaw_per_v_delta * M_yaw_delta_zH) - (yaw_by_delta * K0_12_zH);
    const float K0_22_zH = sin_lam * K0_12_zH;
    const float t397 = p->mH * yaw_per_v_delta;
    const float t398 = yaw_per_v_delta * K0_12_zH;
    const float M_11_mH = p->zH * p->zH;
    const float M_12_mH = p->zH * t371;
    const float hz_delta_mH = t50 * t173;
    const float t404 = t173 + t369;
    const float M_yaw_delta_mH = hz_delta_mH + (p->zH * t376) - (t48 * t404);
    const float P_delta_yaw_mH = yaw_by_delta * t103;
    const float t410 = M_yaw_delta_mH + P_delta_yaw_mH;
    const float M_22_mH = (p->zH * t383) + (cos_lam * hz_delta_mH) + (yaw_by_delta *
        (M_yaw_delta_mH + t410));
    const float C1_12_mH = p->zH * t391;
    const float K0_12_mH = t404 - (yaw_by_delta * (t48 - t50));
    const float C1_22_mH = (yaw_per_v_delta * t410) - (yaw_by_delta * K0_12_mH);
    const float K0_22_mH = sin_lam * K0_12_mH;
    const float t423 = p->zH * yaw_per_v_delta;
    const float t424 = yaw_per_v_delta * K0_12_mH;
    const float M_22_IHzz = M_22_IRxx + (cos_lam * cos_lam) + (cos_lam * t185);
    const float C1_22_IHzz = C1_22_IRxx + (cos_lam * yaw_per_v_delta);
    const float M_22_IHxz = M_22_Jxz_delta + (sin_lam * t185);
    const float K2_22_h_spin_F = sin_lam * yaw_per_v_delta;
    const float M_11_rF = t18 + t18;
    const float t436 = p->rF * sin_lam;
    const float t438 = t367 + t436 - (p->c * C1_12_h_spin_F);
    const float M_12_rF = t238 + (p->mF * t438);
    const float t441 = p->mF * sin_lam;
    const float t443 = sin_lam * p->c;
    const float M_yaw_delta_rF = (t48 * t441) - (p->mF * t443);
    const float t449 = (p->rF * M_22_Jxx_delta) - (p->c * M_22_Jxz_delta);
    const float M_22_rF = (t185 * M_yaw_delta_rF) + (p->mF * t449) + (t18 * M_22_Jxx_delta);
    const float t454 = t389 - yaw_by_delta;
    const float t456 = t125 * h_spin_F;
    const float C1_21_rF = C1_12_h_spin_F * t456;
    const float C1_12_rF = (p->mF * t454) - C1_21_rF;
    const float C1_22_rF = (yaw_by_delta * t441) + (yaw_per_v_delta * M_yaw_delta_rF);
    const float t462 = sin_lam * t441;
    const float K2_12_rF = yaw_per_v_delta * (p->mF - t456);
    const float K2_22_rF = (yaw_per_v_delta * t441) - (K2_22_h_spin_F * t456);
    const float M_11_mF = p->rF * p->rF;
    const float M_12_mF = p->rF * t438;
    const float hz_delta_mF = p->c * t234;
    const float t473 = t234 - t436;
    const float M_yaw_delta_mF = hz_delta_mF - (t48 * t473) - (p->rF * t443);
    const float P_delta_yaw_mF = yaw_by_delta * t105;
    const float t479 = M_yaw_delta_mF + P_delta_yaw_mF;
    const float M_22_mF = (p->rF * t449) + (cos_lam * hz_delta_mF) + (yaw_by_delta *
        (M_yaw_delta_mF + t479));
    const float C1_12_mF = p->rF * t454;
    const float K0_12_mF = t473 - (yaw_by_delta * (t48 - p->c));
    const float C1_22_mF = (yaw_per_v_delta * t479) - (yaw_by_delta * K0_12_mF);
    const float K0_22_mF = sin_lam * K0_12_mF;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float t493 = yaw_per_v_delta * K0_12_mF;
    const float M_22_IFxx = M_22_Jxx_delta + M_22_IHzz;
    const float C1_12_IFyy = t125 * C1_12_h_spin_F;
    const float K2_12_IFyy = yaw_per_v_delta * t125;
    const float K2_22_IFyy = t125 * K2_22_h_spin_F;
    const float M_33_zU = Sz_theta + Sz_theta;
    const float M_13_zU = t31 + M_33_zU;
    const float M_13_zP = Sz_theta - M_13_zU;
    const float M_23_zP = yaw_by_delta * Sx_theta;
    const float t502 = p->mU * yaw_by_delta;
    const float C1_32_zP = t502 + (yaw_per_v_delta * Sx_theta);
    const float K2_32_zP = p->mU * yaw_per_v_delta;
    const float K0_11_mU = p->zP + K0_13_mU;
    const float Jxx_theta_mU = K0_13_mU * K0_13_mU;
    const float M_13_mU = Jxx_theta_mU + (p->zP * K0_13_mU);
    const float M_11_mU = (p->zP * K0_11_mU) + M_13_mU;
    const float t512 = yaw_by_delta * K0_11_mU;
    const float t513 = p->xU * t512;
    const float P_delta_yaw_Sx_theta = yaw_by_delta * p->xU;
    const float P_delta_yaw_mU = p->xU * P_delta_yaw_Sx_theta;
    const float M_22_mU = yaw_by_delta * P_delta_yaw_mU;
    const float t517 = K0_13_mU * yaw_by_delta;
    const float t518 = p->xU * t517;
    const float t519 = yaw_per_v_delta * K0_11_mU;
    const float t521 = t512 + (p->xU * t519);
    const float C1_22_mU = (yaw_per_v_delta * P_delta_yaw_mU) + (yaw_by_delta *
        P_delta_yaw_Sx_theta);
    const float t525 = K0_13_mU * yaw_per_v_delta;
    const float t527 = t517 + (p->xU * t525);
    const float t528 = sin_lam * P_delta_yaw_Sx_theta;
    const float K2_22_mU = yaw_per_v_delta * P_delta_yaw_Sx_theta;
    const float t530 = p->mU * t512;
    const float P_delta_yaw_xU = M_23_zP + (p->mU * P_delta_yaw_Sx_theta);
    const float M_22_xU = yaw_by_delta * P_delta_yaw_xU;
    const float t534 = p->mU * t517;
    const float t535 = p->mU * t519;
    const float C1_22_xU = (yaw_per_v_delta * P_delta_yaw_xU) + (yaw_by_delta * t502);
    const float t539 = p->mU * t525;
    const float t540 = sin_lam * t502;
    const float K2_22_xU = yaw_per_v_delta * t502;
    const float M_11_zU = t31 + M_13_zU;
    const float C1_21 = -(t127 + (yaw_by_delta * h_wheels_all));
    const float K2_32 = -t161;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_phi_theta;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = P_delta_theta;
    matrices->m[2][0] = M_phi_theta;
    matrices->m[2][1] = P_delta_theta;
    matrices->m[2][2] = Jxx_theta;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[0][2] = 0.0F;
    matrices->c0[1][0] = 0.0F;
    matrices->c0[1][1] = 0.0F;
    matrices->c0[1][2] = 0.0F;
    matrices->c0[2][0] = 0.0F;
    matrices->c0[2][1] = 0.0F;
    matrices->c0[2][2] = p->dU;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = C1_12;
    matrices->c1[0][2] = 0.0F;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->c1[1][2] = 0.0F;
    matrices->c1[2][0] = 0.0F;
    matrices->c1[2][1] = C1_32;
    matrices->c1[2][2] = 0.0F;
    matrices->kc[0][0] = 0.0F;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[0][2] = 0.0F;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = 0.0F;
    matrices->kc[1][2] = 0.0F;
    matrices->kc[2][0] = 0.0F;
    matrices->kc[2][1] = 0.0F;
    matrices->kc[2][2] = p->kU;
    matrices->k0[0][0] = Sz_all;
    matrices->k0[0][1] = K0_12;
    matrices->k0[0][2] = Sz_theta;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0F;
    matrices->k0[2][0] = Sz_theta;
    matrices->k0[2][1] = 0.0F;
    matrices->k0[2][2] = Sz_theta;
    matrices->k2[0][0] = 0.0F;
    matrices->k2[0][1] = K2_12;
    matrices->k2[0][2] = 0.0F;
    matrices->k2[1][0] = 0.0F;
    matrices->k2[1][1] = K2_22;
    matrices->k2[1][2] = 0.0F;
    matrices->k2[2][0] = 0.0F;
    matrices->k2[2][1] = K2_32;
    matrices->k2[2][2] = 0.0F;
    derivatives->values[0] = M_12_w;
    derivatives->values[1] = M_22_w;
    derivatives->values[2] = t197;
    derivatives->values[3] = C1_12_w;
    derivatives->values[4] = C1_21_w;
    derivatives->values[5] = C1_22_w;
    derivatives->values[6] = t223;
    derivatives->values[7] = K0_12_w;
    derivatives->values[8] = K0_22_w;
    derivatives->values[9] = t225;
    derivatives->values[10] = t228;
    derivatives->values[11] = K2_32_w;
    derivatives->values[12] = M_12_c;
    derivatives->values[13] = M_22_c;
    derivatives->values[14] = M_23_c;
    derivatives->values[15] = C1_12_c;
    derivatives->values[16] = t255;
    derivatives->values[17] = C1_22_c;
    derivatives->values[18] = t161;
    derivatives->values[19] = K0_12_c;
    derivatives->values[20] = K0_22_c;
    derivatives->values[21] = t263;
    derivatives->values[22] = M_12_lam;
    derivatives->values[23] = M_22_lam;
    derivatives->values[24] = t287;
    derivatives->values[25] = t289;
    derivatives->values[26] = C1_21_lam;
    derivatives->values[27] = C1_22_lam;
    derivatives->values[28] = t299;
    derivatives->values[29] = K0_12_lam;
    derivatives->values[30] = K0_22_lam;
    derivatives->values[31] = t303;
    derivatives->values[32] = K2_22_lam;
    derivatives->values[33] = K2_32_lam;
    derivatives->values[34] = M_11_rR;
    derivatives->values[35] = C1_12_rR;
    derivatives->values[36] = C1_21_rR;
    derivatives->values[37] = p->mR;
    derivatives->values[38] = K2_12_rR;
    derivatives->values[39] = M_11_mR;
    derivatives->values[40] = C1_12_mR;
    derivatives->values[41] = p->rR;
    derivatives->values[42] = K2_12_mR;
    derivatives->values[43] = 1.0F;
    derivatives->values[44] = M_22_IRxx;
    derivatives->values[45] = C1_22_IRxx;
    derivatives->values[46] = C1_12_IRyy;
    derivatives->values[47] = K2_12_IRyy;
    derivatives->values[48] = t323;
    derivatives->values[49] = M_22_xB;
    derivatives->values[50] = t329;
    derivatives->values[51] = C1_22_xB;
    derivatives->values[52] = t331;
    derivatives->values[53] = t334;
    derivatives->values[54] = K2_22_xB;
    derivatives->values[55] = M_11_zB;
    derivatives->values[56] = t325;
    derivatives->values[57] = t339;
    derivatives->values[58] = p->mB;
    derivatives->values[59] = t340;
    derivatives->values[60] = M_11_mB;
    derivatives->values[61] = t342;
    derivatives->values[62] = M_22_mB;
    derivatives->values[63] = t345;
    derivatives->values[64] = C1_22_mB;
    derivatives->values[65] = p->zB;
    derivatives->values[66] = t324;
    derivatives->values[67] = t349;
    derivatives->values[68] = t350;
    derivatives->values[69] = K2_22_mB;
    derivatives->values[70] = yaw_by_delta;
    derivatives->values[71] = yaw_per_v_delta;
    derivatives->values[72] = t163;
    derivatives->values[73] = M_22_xH;
    derivatives->values[74] = t198;
    derivatives->values[75] = C1_22_xH;
    derivatives->values[76] = P_delta_lateral_xH;
    derivatives->values[77] = t364;
    derivatives->values[78] = K2_22_xH;
    derivatives->values[79] = M_11_zH;
    derivatives->values[80] = M_12_zH;
    derivatives->values[81] = M_22_zH;
    derivatives->values[82] = C1_12_zH;
    derivatives->values[83] = C1_22_zH;
    derivatives->values[84] = p->mH;
    derivatives->values[85] = K0_12_zH;
    derivatives->values[86] = K0_22_zH;
    derivatives->values[87] = t397;
    derivatives->values[88] = t398;
    derivatives->values[89] = M_11_mH;
    derivatives->values[90] = M_12_mH;
    derivatives->values[91] = M_22_mH;
    derivatives->values[92] = C1_12_mH;
    derivatives->values[93] = C1_22_mH;
    derivatives->values[94] = p->zH;
    derivatives->values[95] = K0_12_mH;
    derivatives->values[96] = K0_22_mH;
    derivatives->values[97] = t423;
    derivatives->values[98] = t424;
    derivatives->values[99] = sin_lam;
    derivatives->values[100] = M_22_Jxx_delta;
    derivatives->values[101] = M_22_IHzz;
    derivatives->values[102] = C1_22_IHzz;
    derivatives->values[103] = C1_12_h_spin_F;
    derivatives->values[104] = M_22_IHxz;
    derivatives->values[105] = K2_22_h_spin_F;
    derivatives->values[106] = M_11_rF;
    derivatives->values[107] = M_12_rF;
    derivatives->values[108] = M_22_rF;
    derivatives->values[109] = C1_12_rF;
    derivatives->values[110] = C1_21_rF;
    derivatives->values[111] = C1_22_rF;
    derivatives->values[112] = p->mF;
    derivatives->values[113] = t441;
    derivatives->values[114] = t462;
    derivatives->values[115] = K2_12_rF;
    derivatives->values[116] = K2_22_rF;
    derivatives->values[117] = M_11_mF;
    derivatives->values[118] = M_12_mF;
    derivatives->values[119] = M_22_mF;
    derivatives->values[120] = C1_12_mF;
    derivatives->values[121] = C1_22_mF;
    derivatives->values[122] = p->rF;
    derivatives->values[123] = K0_12_mF;
    derivatives->values[124] = K0_22_mF;
    derivatives->values[125] = K2_12_mF;
    derivatives->values[126] = t493;
    derivatives->values[127] = M_22_IFxx;
    derivatives->values[128] = C1_12_IFyy;
    derivatives->values[129] = K2_12_IFyy;
    derivatives->values[130] = K2_22_IFyy;
    derivatives->values[131] = M_13_zP;
    derivatives->values[132] = M_23_zP;
    derivatives->values[133] = M_33_zU;
    derivatives->values[134] = C1_32_zP;
    derivatives->values[135] = p->mU;
    derivatives->values[136] = K2_32_zP;
    derivatives->values[137] = M_11_mU;
    derivatives->values[138] = t513;
    derivatives->values[139] = M_13_mU;
    derivatives->values[140] = M_22_mU;
    derivatives->values[141] = t518;
    derivatives->values[142] = Jxx_theta_mU;
    derivatives->values[143] = t521;
    derivatives->values[144] = C1_22_mU;
    derivatives->values[145] = t527;
    derivatives->values[146] = K0_11_mU;
    derivatives->values[147] = P_delta_yaw_Sx_theta;
    derivatives->values[148] = K0_13_mU;
    derivatives->values[149] = t528;
    derivatives->values[150] = t519;
    derivatives->values[151] = K2_22_mU;
    derivatives->values[152] = t525;
    derivatives->values[153] = t530;
    derivatives->values[154] = M_22_xU;
    derivatives->values[155] = t534;
    derivatives->values[156] = t535;
    derivatives->values[157] = C1_22_xU;
    derivatives->values[158] = t539;
    derivatives->values[159] = t502;
    derivatives->values[160] = t540;
    derivatives->values[161] = K2_22_xU;
    derivatives->values[162] = M_11_zU;
    derivatives->values[163] = M_13_zU;
}

void whipple_leaning_f32_with_respect_to(const whipple_leaning_f32_derivatives_t *derivatives,
    size_t parameter, whipple_leaning_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHIPPLE_LEANING_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_LEANING_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c0[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->kc[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
            matrices->k2[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < WHIPPLE_LEANING_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &whipple_leaning_partials[position];
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
