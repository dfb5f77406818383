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
#include <math.h>

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

const char *whipple_leaning_position_name(whipple_leaning_position_t which)
{
    static const char *const TEXTS[] = {
        "x",
        "y",
        "psi",
        "phi",
        "pitch",
        "delta",
        "theta",
        "thetaR",
        "thetaF",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such position";
}

const char *whipple_leaning_speed_name(whipple_leaning_speed_t which)
{
    static const char *const TEXTS[] = {
        "phi",
        "delta",
        "theta",
        "thetaR",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such speed";
}

const char *whipple_leaning_force_name(whipple_leaning_force_t which)
{
    static const char *const TEXTS[] = {
        "Tphi",
        "Tdelta",
        "Ttheta",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such force";
}

const char *whipple_leaning_wheel_name(whipple_leaning_wheel_t which)
{
    static const char *const TEXTS[] = {
        "R",
        "F",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such wheel";
}

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

void whipple_leaning_f64_motion(const whipple_leaning_f64_t *p,
    whipple_leaning_f64_motion_t *motion)
{
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t31 = p->w + p->c;
    const double t34 = (cos_lam * t31) - (sin_lam * p->rR);
    const double t37 = (sin_lam * t31) + (cos_lam * p->rR);
    const double t38 = p->zP + p->rR;
    const double t39 = sin_lam * t38;
    const double t40 = cos_lam * t38;
    const double t41 = cos_lam * cos_lam;
    const double t42 = sin_lam * cos_lam;
    const double t43 = sin_lam * sin_lam;
    const double t44 = p->w - t31;
    const double t47 = (cos_lam * t44) + (sin_lam * p->rF);
    const double t50 = (sin_lam * t44) - (cos_lam * p->rF);
    const double t51 = t37 + t50;
    const double t53 = p->rR + p->zB;
    const double t55 = (cos_lam * p->xB) - (sin_lam * t53);
    const double t56 = p->mB * t55;
    const double t59 = (sin_lam * p->xB) + (cos_lam * t53);
    const double t60 = p->mB * t59;
    const double t62 = cos_lam * p->IBxz;
    const double t63 = (sin_lam * p->IBxx) + t62;
    const double t65 = sin_lam * p->IBxz;
    const double t67 = t65 + (cos_lam * p->IBzz);
    const double t71 = (cos_lam * t63) - (sin_lam * t67) - (t56 * t59);
    const double t73 = t59 * t60;
    const double t74 = t55 * t56;
    const double t76 = p->IByy + t73 + t74;
    const double t78 = p->mB + p->mR;
    const double t88 = t73 + p->IRxx + (cos_lam * ((cos_lam * p->IBxx) - t65)) - (sin_lam * (t62 -
        (sin_lam * p->IBzz)));
    const double t93 = t74 + p->IRxx + (sin_lam * t63) + (cos_lam * t67);
    const double t94 = p->mH + p->mF;
    const double t95 = p->xH - t31;
    const double t98 = (cos_lam * t95) - (sin_lam * p->zH);
    const double t99 = p->mH * t98;
    const double t100 = p->mF * t47;
    const double t101 = t99 + t100;
    const double t104 = (sin_lam * t95) + (cos_lam * p->zH);
    const double t105 = p->mH * t104;
    const double t106 = p->mF * t50;
    const double t107 = t105 + t106;
    const double t110 = sin_lam * p->IHxz;
    const double t113 = cos_lam * p->IHxz;
    const double t119 = (t104 * t105) + (t50 * t106);
    const double t122 = p->IFxx + (cos_lam * ((cos_lam * p->IHxx) - t110)) + t119 - (sin_lam *
        (t113 - (sin_lam * p->IHzz)));
    const double t124 = t113 + (sin_lam * p->IHxx);
    const double t127 = t110 + (cos_lam * p->IHzz);
    const double t133 = (cos_lam * t124) - (sin_lam * t127) - (t99 * t104) - (t50 * t100);
    const double t137 = (t98 * t99) + (t47 * t100);
    const double t139 = t119 + p->IHyy + t137;
    const double t144 = p->IFxx + t137 + (sin_lam * t124) + (cos_lam * t127);
    const double t146 = p->zU - p->zP;
    const double t148 = (cos_lam * p->xU) - (sin_lam * t146);
    const double t149 = p->mU * t148;
    const double t152 = (sin_lam * p->xU) + (cos_lam * t146);
    const double t153 = p->mU * t152;
    const double t155 = sin_lam * p->IUxz;
    const double t158 = cos_lam * p->IUxz;
    const double t162 = t152 * t153;
    const double t164 = (cos_lam * ((cos_lam * p->IUxx) - t155)) + t162 - (sin_lam * (t158 -
        (sin_lam * p->IUzz)));
    const double t166 = t158 + (sin_lam * p->IUxx);
    const double t169 = t155 + (cos_lam * p->IUzz);
    const double t173 = (cos_lam * t166) - (sin_lam * t169) - (t149 * t152);
    const double t175 = t148 * t149;
    const double t177 = t162 + p->IUyy + t175;
    const double t181 = t175 + (sin_lam * t166) + (cos_lam * t169);
    const double t183 = p->mU * t39;
    const double t184 = p->mU * t40;
    const double t185 = t40 * t184;
    const double t186 = t40 * t183;
    const double t187 = t39 * t183;
    const double t188 = t122 - t139;
    const double t189 = t34 * t94;
    const double t190 = t37 * t107;
    const double t191 = t37 * t94;
    const double t194 = t190 + t190 + (t37 * t191);
    const double t195 = t34 * t107;
    const double t196 = t37 * t189;
    const double t197 = t34 * t189;
    const double t198 = t107 + t191;
    const double t201 = p->rR * (p->mU + t78 + t94);
    const double t202 = p->rR * t201;
    const double t205 = (sin_lam * t149) - (cos_lam * t153);
    const double t208 = (cos_lam * t164) + (sin_lam * t173);
    const double t211 = (cos_lam * t173) + (sin_lam * t181);
    const double t214 = (cos_lam * t208) + (sin_lam * t211);
    motion->constants[0] = p->w;
    motion->constants[1] = p->c;
    motion->constants[2] = sin_lam;
    motion->constants[3] = cos_lam;
    motion->constants[4] = p->zP;
    motion->constants[5] = p->kU;
    motion->constants[6] = p->dU;
    motion->constants[7] = p->rR;
    motion->constants[8] = p->rF;
    motion->constants[9] = p->IBxx;
    motion->constants[10] = p->IBxz;
    motion->constants[11] = p->IBzz;
    motion->constants[12] = p->mB;
    motion->constants[13] = p->xB;
    motion->constants[14] = p->zB;
    motion->constants[15] = p->IHxx;
    motion->constants[16] = p->IHxz;
    motion->constants[17] = p->IHzz;
    motion->constants[18] = p->mH;
    motion->constants[19] = p->xH;
    motion->constants[20] = p->zH;
    motion->constants[21] = p->IUxx;
    motion->constants[22] = p->IUxz;
    motion->constants[23] = p->IUzz;
    motion->constants[24] = p->mU;
    motion->constants[25] = p->xU;
    motion->constants[26] = p->zU;
    motion->constants[27] = p->IRyy;
    motion->constants[28] = p->IFyy;
    motion->constants[29] = p->mF;
    motion->constants[30] = t34;
    motion->constants[31] = t37;
    motion->constants[32] = t39;
    motion->constants[33] = t40;
    motion->constants[34] = t41;
    motion->constants[35] = t42;
    motion->constants[36] = t43;
    motion->constants[37] = t47;
    motion->constants[38] = t50;
    motion->constants[39] = t51;
    motion->constants[40] = t56;
    motion->constants[41] = t60;
    motion->constants[42] = t71;
    motion->constants[43] = t76;
    motion->constants[44] = t78;
    motion->constants[45] = t88;
    motion->constants[46] = t93;
    motion->constants[47] = t94;
    motion->constants[48] = t101;
    motion->constants[49] = t107;
    motion->constants[50] = t122;
    motion->constants[51] = t133;
    motion->constants[52] = t139;
    motion->constants[53] = t144;
    motion->constants[54] = t149;
    motion->constants[55] = t153;
    motion->constants[56] = t164;
    motion->constants[57] = t173;
    motion->constants[58] = t177;
    motion->constants[59] = t181;
    motion->constants[60] = p->g;
    motion->constants[61] = t183;
    motion->constants[62] = t184;
    motion->constants[63] = t185;
    motion->constants[64] = t186;
    motion->constants[65] = t187;
    motion->constants[66] = t188;
    motion->constants[67] = t189;
    motion->constants[68] = t194;
    motion->constants[69] = t195;
    motion->constants[70] = t196;
    motion->constants[71] = t197;
    motion->constants[72] = t198;
    motion->constants[73] = t201;
    motion->constants[74] = t202;
    motion->constants[75] = t205;
    motion->constants[76] = t208;
    motion->constants[77] = t211;
    motion->constants[78] = t214;
    motion->constants[79] = t202;
}

static void whipple_leaning_f64_compute_rates(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    double rates[WHIPPLE_LEANING_POSITIONS])
{
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t13 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t17 = t13 * cos_phi;
    const double t21 = (sin_phi * sin_delta) - (cos_delta * t17);
    const double t25 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const double t26 = cos_phi * t25;
    const double t29 = sqrt((t21 * t21) + (t26 * t26));
    const double t30 = 1.0 / t29;
    const double t31 = t21 * t30;
    const double t33 = t26 * t30;
    const double t34 = cos_delta * t33;
    const double t36 = (t25 * t34) - (t13 * t31);
    const double t41 = motion->constants[8] * ((sin_phi * cos_delta) + (t17 * sin_delta));
    const double t44 = sin_delta * motion->constants[37];
    const double t50 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const double t52 = (t25 * motion->constants[39]) - (t13 * t50);
    const double t55 = (cos_phi * t44) - (t36 * t41) - (sin_phi * t52);
    const double t56 = (motion->constants[7] * sin_phi) + t55;
    const double t63 = (cos_phi * sin_delta * t33) + (sin_phi * ((t25 * t31) + (t13 * t34)));
    const double t68 = (t41 * t63) + (t13 * motion->constants[39]) + (t25 * t50);
    const double t70 = 1.0 / (cos_phi * t68);
    const double t71 = t56 * t70;
    const double t77 = (t25 * motion->constants[31]) - (t13 * motion->constants[30]);
    const double t79 = t55 + (sin_phi * t77);
    const double t81 = sin_phi * t25;
    const double t85 = t68 - (t13 * motion->constants[31]) - (t25 * motion->constants[30]);
    const double t88 = t70 * ((t13 * t79) + (t81 * t85));
    const double t90 = (speeds[0] * t71) + (speeds[1] * t88);
    const double t92 = motion->constants[7] * (speeds[3] + t90);
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t98 = sin_phi * t68;
    const double t100 = sin_phi * t56;
    const double t102 = (t36 * t98) + (t63 * t100);
    const double t106 = 1.0 / ((t36 * t68) + (t56 * t63));
    const double t108 = t71 * t102 * t106;
    const double t117 = (t29 * motion->constants[8]) + (sin_phi * t44) + (cos_phi * t52) -
        (cos_phi * t77);
    const double t119 = (t26 * t85) - (t13 * t117);
    const double t123 = (t81 * t117) + (t26 * t79);
    const double t128 = t106 * ((t36 * t119) + (t63 * t123) + (t88 * t102));
    const double t131 = motion->constants[7] * t63 * t106;
    const double t138 = (t63 * t98) - (t36 * t100);
    const double t142 = (t63 * t68) - (t36 * t56);
    const double t145 = 1.0 / motion->constants[8];
    const double t162 = (speeds[0] * ((t108 * t142) - (t71 * t138)) * t145) + (speeds[1] * t145 *
        ((t36 * t123) + (t128 * t142) - (t63 * t119) - (t88 * t138)));
    const double t163 = t162 + (speeds[3] * t145 * ((motion->constants[7] * t36) + (t131 * t142)));
    const double t164 = -(t92 * cos_psi);
    const double t165 = -(t92 * sin_psi);
    const double t166 = -((speeds[0] * t108) + (speeds[1] * t128) + (speeds[3] * t131));
    rates[0] = t164;
    rates[1] = t165;
    rates[2] = t166;
    rates[3] = speeds[0];
    rates[4] = t90;
    rates[5] = speeds[1];
    rates[6] = speeds[2];
    rates[7] = speeds[3];
    rates[8] = t163;
}

carvallo_motion_error_t whipple_leaning_f64_motion_rates(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    double rates[WHIPPLE_LEANING_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_LEANING_SPEEDS)) {
        whipple_leaning_f64_compute_rates(motion, positions, speeds, rates);
        error = (carvallo_are_finite_f64(rates, WHIPPLE_LEANING_POSITIONS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_leaning_f64_compute_derivatives(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    const double forces[WHIPPLE_LEANING_FORCES], double rates[WHIPPLE_LEANING_POSITIONS],
    double speed_rates[WHIPPLE_LEANING_SPEEDS])
{
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t13 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t17 = t13 * cos_phi;
    const double t21 = (sin_phi * sin_delta) - (cos_delta * t17);
    const double t25 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const double t26 = cos_phi * t25;
    const double t29 = sqrt((t21 * t21) + (t26 * t26));
    const double t30 = 1.0 / t29;
    const double t31 = t21 * t30;
    const double t33 = t26 * t30;
    const double t34 = cos_delta * t33;
    const double t36 = (t25 * t34) - (t13 * t31);
    const double t40 = (sin_phi * cos_delta) + (t17 * sin_delta);
    const double t41 = motion->constants[8] * t40;
    const double t44 = sin_delta * motion->constants[37];
    const double t50 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const double t52 = (t25 * motion->constants[39]) - (t13 * t50);
    const double t55 = (cos_phi * t44) - (t36 * t41) - (sin_phi * t52);
    const double t56 = (motion->constants[7] * sin_phi) + t55;
    const double t63 = (cos_phi * sin_delta * t33) + (sin_phi * ((t25 * t31) + (t13 * t34)));
    const double t68 = (t41 * t63) + (t13 * motion->constants[39]) + (t25 * t50);
    const double t70 = 1.0 / (cos_phi * t68);
    const double t71 = t56 * t70;
    const double t77 = (t25 * motion->constants[31]) - (t13 * motion->constants[30]);
    const double t79 = t55 + (sin_phi * t77);
    const double t81 = sin_phi * t25;
    const double t85 = t68 - (t13 * motion->constants[31]) - (t25 * motion->constants[30]);
    const double t88 = t70 * ((t13 * t79) + (t81 * t85));
    const double t90 = (speeds[0] * t71) + (speeds[1] * t88);
    const double t91 = speeds[3] + t90;
    const double t92 = motion->constants[7] * t91;
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t98 = sin_phi * t68;
    const double t100 = sin_phi * t56;
    const double t102 = (t36 * t98) + (t63 * t100);
    const double t106 = 1.0 / ((t36 * t68) + (t56 * t63));
    const double t108 = t71 * t102 * t106;
    const double t117 = (t29 * motion->constants[8]) + (sin_phi * t44) + (cos_phi * t52) -
        (cos_phi * t77);
    const double t119 = (t26 * t85) - (t13 * t117);
    const double t123 = (t81 * t117) + (t26 * t79);
    const double t128 = t106 * ((t36 * t119) + (t63 * t123) + (t88 * t102));
    const double t131 = motion->constants[7] * t63 * t106;
    const double t134 = (speeds[0] * t108) + (speeds[1] * t128) + (speeds[3] * t131);
    const double t138 = (t63 * t98) - (t36 * t100);
    const double t142 = (t63 * t68) - (t36 * t56);
    const double t145 = 1.0 / motion->constants[8];
    const double t146 = ((t108 * t142) - (t71 * t138)) * t145;
    const double t155 = t145 * ((t36 * t123) + (t128 * t142) - (t63 * t119) - (t88 * t138));
    const double t160 = t145 * ((motion->constants[7] * t36) + (t131 * t142));
    const double t163 = (speeds[0] * t146) + (speeds[1] * t155) + (speeds[3] * t160);
    const double t166 = cos_phi * t134;
    const double t168 = sin_phi * t134;
    const double t169 = motion->constants[7] * t168;
    const double t171 = (t166 * t169) - (t92 * t166);
    const double t174 = t171 + (sin_phi * motion->constants[60]);
    const double t179 = (speeds[0] * t13) - (t25 * t166);
    const double t180 = t90 * t179;
    const double t181 = speeds[0] * t168;
    const double t182 = t90 - t168;
    const double t183 = motion->constants[31] * t182;
    const double t187 = (speeds[0] * t25) + (t13 * t166);
    const double t188 = motion->constants[30] * t182;
    const double t190 = (t179 * t183) + (t187 * t188);
    const double t192 = t90 * t187;
    const double t193 = (t25 * t181) + t192;
    const double t196 = t180 + (t13 * t181);
    const double t200 = t190 + (motion->constants[30] * t193) + (motion->constants[31] * t196) -
        t171;
    const double t205 = (motion->constants[30] * t179) - (motion->constants[31] * t187);
    const double t207 = (t182 * t188) + (t179 * t205);
    const double t208 = speeds[0] * t166;
    const double t211 = motion->constants[7] * speeds[0];
    const double t212 = t166 * t211;
    const double t213 = (motion->constants[7] * t208) + t212;
    const double t218 = (t169 * (t91 - t168)) - (speeds[0] * t211);
    const double t222 = (t25 * t213) + (t13 * t218) - t207 - (motion->constants[31] * t208);
    const double t224 = speeds[1] + t179;
    const double t228 = (cos_delta * t182) - (sin_delta * t187);
    const double t229 = motion->constants[38] * t228;
    const double t233 = (cos_delta * t187) + (sin_delta * t182);
    const double t234 = motion->constants[37] * t228;
    const double t239 = speeds[1] * t228;
    const double t241 = t239 - (cos_delta * t196) - (sin_delta * t208);
    const double t243 = t31 * motion->constants[8];
    const double t247 = t33 * motion->constants[8];
    const double t255 = t30 * t40 * ((t31 * t233) + (t33 * t224));
    const double t256 = t247 * t255;
    const double t258 = t243 * t255;
    const double t264 = (cos_delta * t200) + (t224 * t229) + (t233 * t234) +
        (motion->constants[37] * t193) + (t243 * (t193 + (t163 * t233))) + (t224 * t256);
    const double t268 = t264 + (t233 * t258) - (sin_delta * t222) - (motion->constants[38] * t241) -
        (t247 * (t241 - (t163 * t224)));
    const double t275 = (motion->constants[37] * t224) - (motion->constants[38] * t233);
    const double t279 = speeds[1] * t233;
    const double t281 = (sin_delta * t196) - (cos_delta * t208) - t279;
    const double t284 = t163 + t228;
    const double t289 = motion->constants[8] * ((t31 * t224) - (t33 * t233));
    const double t295 = (cos_delta * t222) + (sin_delta * t200) + (motion->constants[38] * t281) +
        (t247 * t281) - (t228 * t234) - (t224 * t275);
    const double t297 = t295 - (t258 * t284) - (t224 * t289);
    const double t301 = (t187 * t205) - (t182 * t183);
    const double t315 = t301 + (motion->constants[30] * t208) + (t13 * t213) + (t233 * t275) +
        (t233 * t289) - (t25 * t218);
    const double t319 = t315 - (t228 * t229) - (motion->constants[37] * t281) - (t243 * t281) -
        (t256 * t284);
    const double t321 = (t31 * t297) + (t33 * t319);
    const double t326 = t70 * ((t40 * t268) + (t29 * t321));
    const double t330 = t106 * ((t29 * t268) + (t102 * t326) - (t40 * t321));
    const double t332 = t181 - (cos_phi * t330);
    const double t334 = t180 + (t13 * t332);
    const double t338 = t192 + (t25 * t332);
    const double t345 = (t182 * motion->constants[43]) + (motion->constants[27] * (speeds[3] +
        t182));
    const double t350 = (t187 * motion->constants[45]) + (motion->constants[42] * t179);
    const double t357 = t190 + (motion->constants[30] * t338) + (motion->constants[31] * t334) -
        t174;
    const double t361 = t326 - t208 - (sin_phi * t330);
    const double t364 = (motion->constants[7] * t361) - t212;
    const double t367 = t218 + (cos_phi * motion->constants[60]);
    const double t369 = (t13 * t367) - (t25 * t364);
    const double t371 = (motion->constants[31] * t361) + t369 - t207;
    const double t373 = (cos_delta * t357) - (sin_delta * t371);
    const double t379 = t239 + (sin_delta * t361) - (cos_delta * t334);
    const double t387 = (t228 * motion->constants[52]) + (t284 * motion->constants[28]);
    const double t392 = (t233 * motion->constants[50]) + (t224 * motion->constants[51]);
    const double t397 = (motion->constants[48] * t373) + (motion->constants[51] * t379) + (t338 *
        motion->constants[53]) + (t233 * t387) - (t228 * t392);
    double sin_theta = 0.0;
    double cos_theta = 0.0;
    carvallo_sin_cos_f64(positions[6], &sin_theta, &cos_theta);
    const double t401 = 1.0 - cos_theta;
    const double t403 = t401 * motion->constants[35];
    const double t406 = motion->constants[2] * sin_theta;
    const double t408 = t182 * motion->constants[32];
    const double t413 = (t179 * motion->constants[32]) + (t187 * motion->constants[33]);
    const double t418 = t369 + (t182 * t408) + (t179 * t413) + (t361 * motion->constants[33]);
    const double t420 = t182 * motion->constants[33];
    const double t428 = (t179 * t420) + (t334 * motion->constants[33]) - t174 - (t187 * t408) -
        (t338 * motion->constants[32]);
    const double t430 = motion->constants[3] * sin_theta;
    const double t436 = (t25 * t367) + (t13 * t364);
    const double t439 = (t361 * motion->constants[32]) - (t187 * t413) - (t182 * t420) - t436;
    const double t442 = (cos_theta * t428) + (t430 * t439) - (t406 * t418);
    const double t449 = (t182 * cos_theta) + (t179 * t430) - (t187 * t406);
    const double t450 = motion->constants[2] * speeds[2];
    const double t454 = cos_theta + (t401 * motion->constants[34]);
    const double t460 = (t449 * t450) + (t361 * t406) + (t338 * t403) - (t334 * t454);
    const double t463 = motion->constants[3] * speeds[2];
    const double t469 = cos_theta + (t401 * motion->constants[36]);
    const double t473 = (t338 * t469) - (t449 * t463) - (t334 * t403) - (t361 * t430);
    const double t480 = t463 + (t187 * t454) + (t182 * t406) + (t179 * t403);
    const double t487 = t450 + (t187 * t403) + (t179 * t469) - (t182 * t430);
    const double t490 = (motion->constants[57] * t480) + (t487 * motion->constants[59]);
    const double t493 = t449 * motion->constants[58];
    const double t498 = (motion->constants[56] * t460) + (motion->constants[57] * t473) + (t449 *
        t490) - (motion->constants[55] * t442) - (t487 * t493);
    const double t504 = (t418 * t454) + (t406 * t428) + (t403 * t439);
    const double t511 = (t403 * t418) + (t439 * t469) - (t428 * t430);
    const double t522 = (speeds[2] * ((motion->constants[3] * t487) - (motion->constants[2] *
        t480))) + (t334 * t406) + (t361 * cos_theta) + (t338 * t430);
    const double t526 = (motion->constants[56] * t480) + (motion->constants[57] * t487);
    const double t532 = (motion->constants[55] * t504) + (motion->constants[58] * t522) + (t487 *
        t526) - (motion->constants[54] * t511) - (t480 * t490);
    const double t542 = (t442 * motion->constants[54]) + (t460 * motion->constants[57]) + (t473 *
        motion->constants[59]) + (t480 * t493) - (t449 * t526);
    const double t547 = t449 * motion->constants[54];
    const double t551 = (t487 * motion->constants[54]) - (motion->constants[55] * t480);
    const double t555 = (t504 * motion->constants[24]) + (motion->constants[55] * t522) - (t449 *
        t547) - (t487 * t551);
    const double t560 = motion->constants[55] * t449;
    const double t566 = (t442 * motion->constants[24]) + (t473 * motion->constants[54]) + (t487 *
        t560) + (t480 * t547) - (motion->constants[55] * t460);
    const double t574 = (t511 * motion->constants[24]) + (t480 * t551) - (motion->constants[54] *
        t522) - (t449 * t560);
    const double t577 = (t406 * t555) + (cos_theta * t566) - (t430 * t574);
    const double t582 = (cos_delta * t371) + (sin_delta * t357);
    const double t588 = (cos_delta * t361) + (sin_delta * t334) - t279;
    const double t590 = t228 * motion->constants[48];
    const double t594 = (t224 * motion->constants[48]) - (t233 * motion->constants[49]);
    const double t598 = (motion->constants[47] * t582) + (motion->constants[49] * t588) - (t228 *
        t590) - (t224 * t594);
    const double t603 = t228 * motion->constants[49];
    const double t609 = (t373 * motion->constants[47]) + (t338 * motion->constants[48]) + (t224 *
        t603) + (t233 * t590) - (t379 * motion->constants[49]);
    const double t611 = (sin_delta * t598) + (cos_delta * t609);
    const double t617 = (motion->constants[46] * t338) + (t187 * t345) + t397 + (t403 * t498) +
        (t430 * t532) + (t469 * t542);
    const double t622 = t617 + (motion->constants[30] * t611) - (motion->constants[40] * t174) -
        (motion->constants[42] * t334) - (t182 * t350) - (motion->constants[32] * t577);
    const double t630 = (motion->constants[42] * t187) + (t179 * motion->constants[46]);
    const double t642 = (t233 * motion->constants[51]) + (t224 * motion->constants[53]);
    const double t648 = (t379 * motion->constants[50]) + (t338 * motion->constants[51]) + (t228 *
        t642) - (t373 * motion->constants[49]) - (t224 * t387);
    const double t653 = t301 - t436 - (motion->constants[30] * t361);
    const double t664 = t588 + (t145 * ((t31 * t319) + (t142 * t330) - (t33 * t297) - (t138 *
        t326)));
    const double t665 = motion->constants[28] * t664;
    const double t672 = (t582 * motion->constants[49]) + (motion->constants[52] * t588) + t665 +
        (t224 * t392) - (motion->constants[48] * t653) - (t233 * t642);
    const double t679 = (t174 * motion->constants[41]) + (motion->constants[42] * t338) + (t182 *
        t630) + (t454 * t498) + (t403 * t542) + (cos_delta * t648);
    const double t684 = t679 - (t334 * motion->constants[45]) - (t179 * t345) - (t406 * t532) -
        (motion->constants[33] * t577) - (sin_delta * t672);
    const double t685 = t684 - (motion->constants[31] * t611);
    const double t691 = t182 * motion->constants[41];
    const double t693 = motion->constants[40] * t182;
    const double t700 = t577 + t611 + (motion->constants[40] * t338) + (t334 *
        motion->constants[41]) + (t179 * t691) + (t187 * t693) - (t174 * motion->constants[44]);
    const double t703 = t71 - (sin_phi * t108);
    const double t716 = (t454 * t555) + (t403 * t574) - (t406 * t566);
    const double t722 = (t403 * t555) + (t430 * t566) + (t469 * t574);
    const double t728 = (cos_delta * t598) - (sin_delta * t609);
    const double t736 = (motion->constants[47] * t653) + (t233 * t594) - (motion->constants[48] *
        t588) - (t228 * t603);
    const double t743 = (motion->constants[40] * t179) - (t187 * motion->constants[41]);
    const double t751 = t13 * (t722 + t736 + (t187 * t743) - (t436 * motion->constants[44]) -
        (motion->constants[40] * t361) - (t182 * t691));
    const double t761 = t25 * (t716 + t728 + (t369 * motion->constants[44]) + (t361 *
        motion->constants[41]) - (t182 * t693) - (t179 * t743));
    const double t764 = (motion->constants[27] * t361) - (motion->constants[7] * (t751 + t761));
    const double t769 = (t369 * motion->constants[41]) + (motion->constants[40] * t436) +
        (motion->constants[43] * t361) + (t179 * t350) + (t406 * t498) + (cos_theta * t532);
    const double t774 = t769 + (motion->constants[33] * t716) + (motion->constants[32] * t722) +
        (sin_delta * t648) + (cos_delta * t672) + (motion->constants[31] * t728);
    const double t778 = t774 + t764 - (t187 * t630) - (t430 * t542) - (motion->constants[30] *
        t736);
    const double t780 = cos_phi * t108;
    const double t783 = (t25 * t622) - (t13 * t685);
    const double t790 = forces[0] + (t780 * t783) - (t13 * t622) - (t25 * t685) -
        (motion->constants[7] * t700) - (t703 * t778);
    const double t791 = t790 - (t146 * t665);
    const double t793 = t403 * motion->constants[57];
    const double t803 = sin_delta * motion->constants[66];
    const double t804 = sin_delta * t803;
    const double t807 = (t403 * motion->constants[54]) + (motion->constants[55] * t469);
    const double t808 = motion->constants[33] * t807;
    const double t813 = t808 + t808 + motion->constants[63] + motion->constants[68];
    const double t817 = motion->constants[45] + motion->constants[50] + (t454 *
        ((motion->constants[56] * t454) + t793)) + (t406 * t406 * motion->constants[58]) + (t403 *
        ((t454 * motion->constants[57]) + (t403 * motion->constants[59])));
    const double t819 = t817 + t813 - t804;
    const double t822 = (t403 * motion->constants[56]) + (motion->constants[57] * t469);
    const double t824 = t430 * motion->constants[58];
    const double t827 = t793 + (t469 * motion->constants[59]);
    const double t833 = (t454 * motion->constants[54]) + (t403 * motion->constants[55]);
    const double t835 = cos_delta * motion->constants[48];
    const double t836 = motion->constants[30] * t835;
    const double t837 = (motion->constants[32] * t833) - t836;
    const double t840 = motion->constants[65] + motion->constants[71] - t837 - t837;
    const double t845 = motion->constants[46] + motion->constants[53] + (t403 * t822) + (t430 *
        t824) + (t469 * t827) + t840;
    const double t846 = t845 - t819;
    const double t847 = t13 * t13;
    const double t849 = t13 * t25;
    const double t860 = (cos_delta * motion->constants[51]) - (motion->constants[31] * t835);
    const double t865 = motion->constants[42] + (t454 * t822) + (t403 * t827) +
        (motion->constants[32] * t807) + motion->constants[64] + t860;
    const double t869 = t865 - (t406 * t824) - (motion->constants[33] * t833) -
        motion->constants[69] - motion->constants[70];
    const double t870 = t869 + t869;
    const double t872 = (t846 * t847) + (t849 * t870);
    const double t877 = motion->constants[41] + t807 + motion->constants[62] +
        motion->constants[72];
    const double t884 = motion->constants[40] + t833 + t835 + motion->constants[67] -
        motion->constants[61];
    const double t886 = (t25 * t877) - (t13 * t884);
    const double t887 = motion->constants[7] * t886;
    const double t890 = motion->constants[74] - t887 - t887;
    const double t896 = (t406 * motion->constants[54]) - (motion->constants[55] * t430);
    const double t899 = sin_delta * motion->constants[48];
    const double t901 = (sin_delta * motion->constants[51]) - (motion->constants[31] * t899);
    const double t905 = (t406 * t822) + (cos_theta * t824) + t901 - (t430 * t827) -
        (motion->constants[33] * t896);
    const double t909 = (t406 * motion->constants[56]) - (t430 * motion->constants[57]);
    const double t911 = cos_theta * motion->constants[58];
    const double t915 = (t406 * motion->constants[57]) - (t430 * motion->constants[59]);
    const double t924 = (t454 * t909) + (t403 * t915) + (motion->constants[32] * t896) +
        (cos_delta * t803) - (t406 * t911) - (motion->constants[30] * t899);
    const double t926 = (t13 * t905) + (t25 * t924);
    const double t936 = t869 + (t846 * t849) + (motion->constants[7] * ((t13 * t877) + (t25 *
        t884))) - (t847 * t870);
    const double t946 = motion->constants[43] + motion->constants[52] + t804 + t813 + t840 + t890 +
        (t406 * t909);
    const double t948 = t946 + (cos_theta * t911) - (t430 * t915);
    const double t953 = motion->constants[7] * (t896 + t899);
    const double t955 = (t25 * t905) + t953 - (t13 * t924);
    const double t961 = t845 - t872;
    const double t966 = motion->constants[27] * t703;
    const double t970 = t13 * sin_delta;
    const double t974 = t146 + (cos_delta * t703) - (sin_delta * t25) - (t780 * t970);
    const double t975 = motion->constants[28] * t974;
    const double t981 = t819 + t872 + t890 + (t703 * t926) + (t703 * (t926 + (t703 * t948) - (t780 *
        t955))) + (t703 * t966);
    const double t984 = t981 + (t974 * t975) - (t780 * t936) - (t780 * (t936 + (t703 * t955) -
        (t780 * t961)));
    const double t985 = 1.0 / t984;
    const double t987 = motion->constants[53] + t836;
    const double t992 = t88 - (sin_phi * t128);
    const double t994 = cos_phi * t128;
    const double t997 = motion->constants[7] * t25 * t899;
    const double t998 = t901 + t997;
    const double t1002 = t998 + (t948 * t992) - (t955 * t994);
    const double t1006 = (t25 * t987) - (t13 * t860);
    const double t1010 = t1006 + (t955 * t992) - (t961 * t994);
    const double t1016 = t155 + (cos_delta * t992) - (t970 * t994);
    const double t1022 = (t13 * t987) + (t25 * t860) + (motion->constants[7] * t835) + (t926 *
        t992) + (t703 * t1002) + (t966 * t992);
    const double t1026 = t985 * (t1022 + (t975 * t1016) - (t936 * t994) - (t780 * t1010));
    const double t1031 = motion->constants[27] * t992;
    const double t1033 = motion->constants[28] * t1016;
    const double t1035 = t984 * t1026;
    const double t1041 = motion->constants[53] + (t992 * t1002) + (t992 * t998) + (t992 * t1031) +
        (t1016 * t1033) - (t994 * t1010);
    const double t1043 = t1041 - (t994 * t1006) - (t1026 * t1035);
    const double t1044 = 1.0 / t1043;
    const double t1054 = forces[1] + (t783 * t994) - t397 - (t778 * t992) - (t155 * t665) - (t791 *
        t1026);
    const double t1061 = t406 * motion->constants[75];
    const double t1063 = t430 * motion->constants[75];
    const double t1068 = motion->constants[7] * ((t13 * t1063) - (t25 * t1061));
    const double t1072 = (t406 * motion->constants[76]) + (motion->constants[32] * t1063) - (t430 *
        motion->constants[77]) - (motion->constants[33] * t1061) - t1068;
    const double t1076 = cos_theta * motion->constants[75];
    const double t1079 = (t403 * motion->constants[76]) + (t469 * motion->constants[77]) -
        (motion->constants[32] * t1076);
    const double t1085 = (t454 * motion->constants[76]) + (t403 * motion->constants[77]) -
        (motion->constants[33] * t1076);
    const double t1087 = (t25 * t1079) - (t13 * t1085);
    const double t1098 = t985 * ((t13 * t1079) + (t25 * t1085) + (motion->constants[7] * t1076) +
        (t703 * t1072) - (t780 * t1087));
    const double t1102 = t1044 * ((t992 * t1072) - (t994 * t1087) - (t1035 * t1098));
    const double t1104 = t984 * t1098;
    const double t1106 = t1043 * t1102;
    const double t1109 = motion->constants[78] - (t1098 * t1104) - (t1102 * t1106);
    const double t1110 = 1.0 / t1109;
    const double t1124 = forces[2] - (motion->constants[3] * t498) - (motion->constants[2] * t542) -
        (positions[6] * motion->constants[5]) - (speeds[2] * motion->constants[6]) - (t791 * t1098);
    const double t1125 = t1124 - (t1054 * t1102);
    const double t1127 = sin_phi * t131;
    const double t1129 = cos_phi * t131;
    const double t1135 = motion->constants[7] * (t886 - motion->constants[73]);
    const double t1139 = t1135 + (t948 * t1127) + (t955 * t1129);
    const double t1144 = t953 - (t955 * t1127) - (t961 * t1129);
    const double t1146 = 1.0 - t1127;
    const double t1151 = t160 - (cos_delta * t1127) - (t970 * t1129);
    const double t1157 = (t966 * t1146) + (t975 * t1151) - (t926 * t1127) - (t936 * t1129) - (t703 *
        t1139) - (t780 * t1144);
    const double t1158 = t985 * t1157;
    const double t1171 = t997 + (t1031 * t1146) + (t1033 * t1151) - (t992 * t1139) - (t994 *
        t1144) - (t998 * t1127);
    const double t1174 = t1044 * (t1171 - (t1006 * t1129) - (t1035 * t1158));
    const double t1180 = t1110 * (t1068 + (t1072 * t1127) + (t1087 * t1129) + (t1104 * t1158) +
        (t1106 * t1174));
    const double t1191 = (t778 * t1127) + (t783 * t1129) + (t1125 * t1180) - t764 - (t160 * t665) -
        (t791 * t1158);
    const double t1212 = (t1127 * t1139) + (t1127 * t1135) + motion->constants[79] +
        (motion->constants[27] * t1146 * t1146) + (motion->constants[28] * t1151 * t1151) - (t1129 *
        t1144);
    const double t1217 = (t1191 - (t1054 * t1174)) / (t1212 - (t953 * t1129) - (t984 * t1158 *
        t1158) - (t1043 * t1174 * t1174) - (t1109 * t1180 * t1180));
    const double t1219 = (t1110 * t1125) + (t1180 * t1217);
    const double t1223 = (t1044 * t1054) - (t1102 * t1219) - (t1174 * t1217);
    const double t1229 = (t791 * t985) - (t1026 * t1223) - (t1098 * t1219) - (t1158 * t1217);
    const double t1230 = -(t92 * cos_psi);
    const double t1231 = -(t92 * sin_psi);
    const double t1232 = -t134;
    rates[0] = t1230;
    rates[1] = t1231;
    rates[2] = t1232;
    rates[3] = speeds[0];
    rates[4] = t90;
    rates[5] = speeds[1];
    rates[6] = speeds[2];
    rates[7] = speeds[3];
    rates[8] = t163;
    speed_rates[0] = t1229;
    speed_rates[1] = t1223;
    speed_rates[2] = t1219;
    speed_rates[3] = t1217;
}

carvallo_motion_error_t whipple_leaning_f64_motion_derivatives(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    const double forces[WHIPPLE_LEANING_FORCES], double rates[WHIPPLE_LEANING_POSITIONS],
    double speed_rates[WHIPPLE_LEANING_SPEEDS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_LEANING_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_LEANING_FORCES)) {
        whipple_leaning_f64_compute_derivatives(motion, positions, speeds, forces, rates,
            speed_rates);
        error = (carvallo_are_finite_f64(rates, WHIPPLE_LEANING_POSITIONS) &&
            carvallo_are_finite_f64(speed_rates, WHIPPLE_LEANING_SPEEDS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_leaning_f64_compute_accelerations(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    const double forces[WHIPPLE_LEANING_FORCES], double accelerations[WHIPPLE_LEANING_POSITIONS])
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
    const double t13 = (motion->constants[3] * sin_pitch) + (cos_pitch * motion->constants[2]);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t16 = cos_phi * t13;
    const double t21 = (sin_phi * sin_delta) - (cos_delta * t16);
    const double t25 = (motion->constants[3] * cos_pitch) - (motion->constants[2] * sin_pitch);
    const double t26 = cos_phi * t25;
    const double t29 = sqrt((t21 * t21) + (t26 * t26));
    const double t30 = 1.0 / t29;
    const double t31 = t21 * t30;
    const double t33 = t26 * t30;
    const double t34 = cos_delta * t33;
    const double t36 = (t25 * t34) - (t13 * t31);
    const double t43 = (cos_phi * sin_delta * t33) + (sin_phi * ((t25 * t31) + (t13 * t34)));
    const double t47 = (sin_phi * cos_delta) + (sin_delta * t16);
    const double t48 = motion->constants[8] * t47;
    const double t55 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const double t58 = (t43 * t48) + (t13 * motion->constants[39]) + (t25 * t55);
    const double t62 = sin_delta * motion->constants[37];
    const double t66 = (t25 * motion->constants[39]) - (t13 * t55);
    const double t69 = (cos_phi * t62) - (t36 * t48) - (sin_phi * t66);
    const double t70 = (motion->constants[7] * sin_phi) + t69;
    const double t73 = 1.0 / ((t36 * t58) + (t43 * t70));
    const double t74 = sin_phi * t58;
    const double t76 = sin_phi * t70;
    const double t78 = (t36 * t74) + (t43 * t76);
    const double t80 = 1.0 / (cos_phi * t58);
    const double t81 = t70 * t80;
    const double t83 = t73 * t78 * t81;
    const double t90 = t58 - (t13 * motion->constants[31]) - (t25 * motion->constants[30]);
    const double t97 = (t25 * motion->constants[31]) - (t13 * motion->constants[30]);
    const double t101 = (t29 * motion->constants[8]) + (sin_phi * t62) + (cos_phi * t66) -
        (cos_phi * t97);
    const double t103 = (t26 * t90) - (t13 * t101);
    const double t105 = sin_phi * t25;
    const double t108 = t69 + (sin_phi * t97);
    const double t110 = (t101 * t105) + (t26 * t108);
    const double t115 = t80 * ((t13 * t108) + (t90 * t105));
    const double t119 = t73 * ((t36 * t103) + (t43 * t110) + (t78 * t115));
    const double t122 = motion->constants[7] * t43 * t73;
    const double t126 = (speeds[0] * t83) + (speeds[1] * t119) + (t122 * speeds[3]);
    const double t127 = cos_phi * t126;
    const double t128 = speeds[0] * t127;
    const double t131 = (t13 * speeds[0]) - (t25 * t127);
    const double t134 = (speeds[0] * t81) + (speeds[1] * t115);
    const double t135 = sin_phi * t126;
    const double t136 = t134 - t135;
    const double t137 = motion->constants[31] * t136;
    const double t141 = (t25 * speeds[0]) + (t13 * t127);
    const double t142 = motion->constants[30] * t136;
    const double t144 = (t131 * t137) + (t141 * t142);
    const double t145 = speeds[0] * t135;
    const double t147 = t134 * t141;
    const double t148 = (t25 * t145) + t147;
    const double t151 = t131 * t134;
    const double t152 = (t13 * t145) + t151;
    const double t154 = speeds[3] + t134;
    const double t155 = motion->constants[7] * t154;
    const double t157 = motion->constants[7] * t135;
    const double t159 = (t127 * t157) - (t127 * t155);
    const double t162 = t144 + (motion->constants[30] * t148) + (motion->constants[31] * t152) -
        t159;
    const double t167 = (motion->constants[30] * t131) - (motion->constants[31] * t141);
    const double t169 = (t136 * t142) + (t131 * t167);
    const double t171 = motion->constants[7] * speeds[0];
    const double t172 = t127 * t171;
    const double t174 = t172 + (motion->constants[7] * t128);
    const double t179 = (t157 * (t154 - t135)) - (speeds[0] * t171);
    const double t183 = (t25 * t174) + (t13 * t179) - t169 - (motion->constants[31] * t128);
    const double t185 = speeds[1] + t131;
    const double t189 = (cos_delta * t136) - (sin_delta * t141);
    const double t190 = motion->constants[38] * t189;
    const double t194 = (cos_delta * t141) + (sin_delta * t136);
    const double t195 = motion->constants[37] * t189;
    const double t200 = speeds[1] * t189;
    const double t202 = t200 - (cos_delta * t152) - (sin_delta * t128);
    const double t204 = t31 * motion->constants[8];
    const double t207 = (t43 * t74) - (t36 * t76);
    const double t211 = (t43 * t58) - (t36 * t70);
    const double t214 = 1.0 / motion->constants[8];
    const double t215 = ((t83 * t211) - (t81 * t207)) * t214;
    const double t224 = t214 * ((t36 * t110) + (t119 * t211) - (t43 * t103) - (t115 * t207));
    const double t229 = t214 * ((motion->constants[7] * t36) + (t122 * t211));
    const double t232 = (speeds[0] * t215) + (speeds[1] * t224) + (speeds[3] * t229);
    const double t236 = t33 * motion->constants[8];
    const double t244 = t30 * t47 * ((t31 * t194) + (t33 * t185));
    const double t245 = t236 * t244;
    const double t247 = t204 * t244;
    const double t253 = (cos_delta * t162) + (t185 * t190) + (t194 * t195) +
        (motion->constants[37] * t148) + (t204 * (t148 + (t194 * t232))) + (t185 * t245);
    const double t257 = t253 + (t194 * t247) - (sin_delta * t183) - (motion->constants[38] * t202) -
        (t236 * (t202 - (t185 * t232)));
    const double t264 = (motion->constants[37] * t185) - (motion->constants[38] * t194);
    const double t268 = speeds[1] * t194;
    const double t270 = (sin_delta * t152) - (cos_delta * t128) - t268;
    const double t273 = t189 + t232;
    const double t278 = motion->constants[8] * ((t31 * t185) - (t33 * t194));
    const double t284 = (cos_delta * t183) + (sin_delta * t162) + (motion->constants[38] * t270) +
        (t236 * t270) - (t189 * t195) - (t185 * t264);
    const double t286 = t284 - (t247 * t273) - (t185 * t278);
    const double t290 = (t141 * t167) - (t136 * t137);
    const double t304 = t290 + (motion->constants[30] * t128) + (t13 * t174) + (t194 * t264) +
        (t194 * t278) - (t25 * t179);
    const double t308 = t304 - (t189 * t190) - (motion->constants[37] * t270) - (t204 * t270) -
        (t245 * t273);
    const double t310 = (t31 * t286) + (t33 * t308);
    const double t313 = t80 * ((t47 * t257) + (t29 * t310));
    const double t319 = t73 * ((t29 * t257) + (t78 * t313) - (t47 * t310));
    const double t322 = t313 - t128 - (sin_phi * t319);
    double sin_theta = 0.0;
    double cos_theta = 0.0;
    carvallo_sin_cos_f64(positions[6], &sin_theta, &cos_theta);
    const double t328 = 1.0 - cos_theta;
    const double t330 = t328 * motion->constants[35];
    const double t332 = (motion->constants[7] * t322) - t172;
    const double t336 = t179 + (cos_phi * motion->constants[60]);
    const double t338 = (t13 * t336) - (t25 * t332);
    const double t340 = t136 * motion->constants[32];
    const double t345 = (t131 * motion->constants[32]) + (t141 * motion->constants[33]);
    const double t350 = t338 + (t136 * t340) + (t131 * t345) + (t322 * motion->constants[33]);
    const double t353 = cos_theta + (t328 * motion->constants[34]);
    const double t356 = motion->constants[2] * sin_theta;
    const double t357 = t136 * motion->constants[33];
    const double t361 = t145 - (cos_phi * t319);
    const double t363 = t147 + (t25 * t361);
    const double t366 = t151 + (t13 * t361);
    const double t369 = t159 + (sin_phi * motion->constants[60]);
    const double t373 = (t131 * t357) + (motion->constants[33] * t366) - (t141 * t340) -
        (motion->constants[32] * t363) - t369;
    const double t377 = (t25 * t336) + (t13 * t332);
    const double t383 = (t322 * motion->constants[32]) - t377 - (t141 * t345) - (t136 * t357);
    const double t386 = (t350 * t353) + (t356 * t373) + (t383 * t330);
    const double t391 = motion->constants[2] * speeds[2];
    const double t393 = motion->constants[3] * sin_theta;
    const double t397 = cos_theta + (t328 * motion->constants[36]);
    const double t401 = t391 + (t141 * t330) + (t131 * t397) - (t136 * t393);
    const double t403 = motion->constants[3] * speeds[2];
    const double t409 = t403 + (t141 * t353) + (t136 * t356) + (t131 * t330);
    const double t418 = (speeds[2] * ((motion->constants[3] * t401) - (motion->constants[2] *
        t409))) + (t356 * t366) + (t322 * cos_theta) + (t363 * t393);
    const double t424 = (t136 * cos_theta) + (t131 * t393) - (t141 * t356);
    const double t426 = t424 * motion->constants[54];
    const double t430 = (t401 * motion->constants[54]) - (motion->constants[55] * t409);
    const double t434 = (t386 * motion->constants[24]) + (motion->constants[55] * t418) - (t424 *
        t426) - (t401 * t430);
    const double t440 = (cos_theta * t373) + (t393 * t383) - (t356 * t350);
    const double t448 = (t363 * t397) - (t424 * t403) - (t366 * t330) - (t322 * t393);
    const double t456 = (t424 * t391) + (t322 * t356) + (t363 * t330) - (t366 * t353);
    const double t458 = motion->constants[55] * t424;
    const double t464 = (t440 * motion->constants[24]) + (t448 * motion->constants[54]) + (t401 *
        t458) + (t409 * t426) - (motion->constants[55] * t456);
    const double t470 = (t350 * t330) + (t383 * t397) - (t373 * t393);
    const double t477 = (t470 * motion->constants[24]) + (t409 * t430) - (motion->constants[54] *
        t418) - (t424 * t458);
    const double t480 = (t330 * t434) + (t393 * t464) + (t397 * t477);
    const double t483 = t290 - t377 - (motion->constants[30] * t322);
    const double t490 = (cos_delta * t322) + (sin_delta * t366) - t268;
    const double t495 = (t185 * motion->constants[48]) - (t194 * motion->constants[49]);
    const double t497 = t189 * motion->constants[49];
    const double t501 = (t483 * motion->constants[47]) + (t194 * t495) - (motion->constants[48] *
        t490) - (t189 * t497);
    const double t509 = (t131 * motion->constants[40]) - (motion->constants[41] * t141);
    const double t511 = motion->constants[41] * t136;
    const double t518 = t13 * (t480 + t501 + (t141 * t509) - (t377 * motion->constants[44]) -
        (t322 * motion->constants[40]) - (t136 * t511));
    const double t523 = (t353 * t434) + (t330 * t477) - (t356 * t464);
    const double t526 = t338 + (motion->constants[31] * t322) - t169;
    const double t532 = t144 + (motion->constants[30] * t363) + (motion->constants[31] * t366) -
        t369;
    const double t534 = (cos_delta * t526) + (sin_delta * t532);
    const double t537 = t189 * motion->constants[48];
    const double t542 = (t534 * motion->constants[47]) + (motion->constants[49] * t490) - (t189 *
        t537) - (t185 * t495);
    const double t546 = (cos_delta * t532) - (sin_delta * t526);
    const double t552 = t200 + (sin_delta * t322) - (cos_delta * t366);
    const double t559 = (t546 * motion->constants[47]) + (t363 * motion->constants[48]) + (t185 *
        t497) + (t194 * t537) - (motion->constants[49] * t552);
    const double t561 = (cos_delta * t542) - (sin_delta * t559);
    const double t564 = t136 * motion->constants[40];
    const double t572 = t25 * (t523 + t561 + (t338 * motion->constants[44]) +
        (motion->constants[41] * t322) - (t136 * t564) - (t131 * t509));
    const double t575 = (t322 * motion->constants[27]) - (motion->constants[7] * (t518 + t572));
    const double t576 = sin_phi * t122;
    const double t585 = (t141 * motion->constants[45]) + (t131 * motion->constants[42]);
    const double t590 = (t141 * motion->constants[42]) + (t131 * motion->constants[46]);
    const double t600 = (motion->constants[57] * t409) + (t401 * motion->constants[59]);
    const double t603 = t424 * motion->constants[58];
    const double t608 = (motion->constants[56] * t456) + (motion->constants[57] * t448) + (t424 *
        t600) - (motion->constants[55] * t440) - (t401 * t603);
    const double t615 = (motion->constants[56] * t409) + (motion->constants[57] * t401);
    const double t621 = (motion->constants[55] * t386) + (motion->constants[58] * t418) + (t401 *
        t615) - (motion->constants[54] * t470) - (t409 * t600);
    const double t631 = (t440 * motion->constants[54]) + (t456 * motion->constants[57]) + (t448 *
        motion->constants[59]) + (t409 * t603) - (t424 * t615);
    const double t643 = (t194 * motion->constants[51]) + (t185 * motion->constants[53]);
    const double t649 = (t189 * motion->constants[52]) + (t273 * motion->constants[28]);
    const double t654 = (motion->constants[50] * t552) + (t363 * motion->constants[51]) + (t189 *
        t643) - (motion->constants[49] * t546) - (t185 * t649);
    const double t666 = t214 * ((t31 * t308) + (t211 * t319) - (t33 * t286) - (t207 * t313));
    const double t668 = motion->constants[28] * (t490 + t666);
    const double t671 = (t194 * motion->constants[50]) + (t185 * motion->constants[51]);
    const double t678 = (motion->constants[49] * t534) + (motion->constants[52] * t490) + t668 +
        (t185 * t671) - (motion->constants[48] * t483) - (t194 * t643);
    const double t686 = (motion->constants[41] * t338) + (motion->constants[40] * t377) + (t322 *
        motion->constants[43]) + (t131 * t585) + (t356 * t608) + (cos_theta * t621);
    const double t691 = t686 + (motion->constants[33] * t523) + (motion->constants[32] * t480) +
        (sin_delta * t654) + (cos_delta * t678) + (motion->constants[31] * t561);
    const double t695 = t691 + t575 - (t141 * t590) - (t393 * t631) - (motion->constants[30] *
        t501);
    const double t697 = cos_phi * t122;
    const double t704 = (t136 * motion->constants[43]) + (motion->constants[27] * (speeds[3] +
        t136));
    const double t715 = (t546 * motion->constants[48]) + (t552 * motion->constants[51]) + (t363 *
        motion->constants[53]) + (t194 * t649) - (t189 * t671);
    const double t723 = (t356 * t434) + (cos_theta * t464) - (t393 * t477);
    const double t727 = (sin_delta * t542) + (cos_delta * t559);
    const double t733 = (motion->constants[46] * t363) + (t141 * t704) + t715 + (t330 * t608) +
        (t393 * t621) + (t397 * t631);
    const double t738 = t733 + (motion->constants[30] * t727) - (motion->constants[40] * t369) -
        (motion->constants[42] * t366) - (t136 * t585) - (motion->constants[32] * t723);
    const double t756 = (motion->constants[41] * t369) + (motion->constants[42] * t363) + (t136 *
        t590) + (t353 * t608) + (t330 * t631) + (cos_delta * t654);
    const double t761 = t756 - (motion->constants[45] * t366) - (t131 * t704) - (t356 * t621) -
        (motion->constants[33] * t723) - (sin_delta * t678);
    const double t762 = t761 - (motion->constants[31] * t727);
    const double t764 = (t25 * t738) - (t13 * t762);
    const double t780 = t723 + t727 + (motion->constants[40] * t363) + (motion->constants[41] *
        t366) + (t131 * t511) + (t141 * t564) - (t369 * motion->constants[44]);
    const double t783 = t81 - (sin_phi * t83);
    const double t785 = cos_phi * t83;
    const double t792 = forces[0] + (t764 * t785) - (t13 * t738) - (t25 * t762) -
        (motion->constants[7] * t780) - (t695 * t783);
    const double t793 = t792 - (t215 * t668);
    const double t796 = (motion->constants[56] * t330) + (motion->constants[57] * t397);
    const double t798 = t393 * motion->constants[58];
    const double t800 = t330 * motion->constants[57];
    const double t802 = t800 + (t397 * motion->constants[59]);
    const double t806 = (t356 * motion->constants[54]) - (motion->constants[55] * t393);
    const double t809 = sin_delta * motion->constants[48];
    const double t811 = (sin_delta * motion->constants[51]) - (motion->constants[31] * t809);
    const double t815 = (t356 * t796) + (cos_theta * t798) + t811 - (t393 * t802) -
        (motion->constants[33] * t806);
    const double t819 = (t356 * motion->constants[56]) - (t393 * motion->constants[57]);
    const double t821 = cos_theta * motion->constants[58];
    const double t825 = (t356 * motion->constants[57]) - (t393 * motion->constants[59]);
    const double t829 = sin_delta * motion->constants[66];
    const double t836 = (t353 * t819) + (t330 * t825) + (motion->constants[32] * t806) +
        (cos_delta * t829) - (t356 * t821) - (motion->constants[30] * t809);
    const double t838 = (t13 * t815) + (t25 * t836);
    const double t845 = (t330 * motion->constants[54]) + (motion->constants[55] * t397);
    const double t849 = (t353 * motion->constants[54]) + (motion->constants[55] * t330);
    const double t855 = cos_delta * motion->constants[48];
    const double t857 = (cos_delta * motion->constants[51]) - (motion->constants[31] * t855);
    const double t862 = motion->constants[42] + (t353 * t796) + (t330 * t802) +
        (motion->constants[32] * t845) + motion->constants[64] + t857;
    const double t866 = t862 - (t356 * t798) - (motion->constants[33] * t849) -
        motion->constants[69] - motion->constants[70];
    const double t876 = sin_delta * t829;
    const double t877 = motion->constants[33] * t845;
    const double t882 = t877 + t877 + motion->constants[63] + motion->constants[68];
    const double t886 = motion->constants[45] + motion->constants[50] + (t353 * (t800 +
        (motion->constants[56] * t353))) + (t356 * t356 * motion->constants[58]) + (t330 * ((t353 *
        motion->constants[57]) + (t330 * motion->constants[59])));
    const double t888 = t886 + t882 - t876;
    const double t895 = motion->constants[30] * t855;
    const double t896 = (motion->constants[32] * t849) - t895;
    const double t899 = motion->constants[65] + motion->constants[71] - t896 - t896;
    const double t904 = motion->constants[46] + motion->constants[53] + (t330 * t796) + (t393 *
        t798) + (t397 * t802) + t899;
    const double t905 = t904 - t888;
    const double t906 = t25 * t13;
    const double t908 = t13 * t13;
    const double t909 = t866 + t866;
    const double t915 = motion->constants[41] + t845 + motion->constants[62] +
        motion->constants[72];
    const double t922 = motion->constants[40] + t849 + t855 + motion->constants[67] -
        motion->constants[61];
    const double t928 = t866 + (t905 * t906) + (motion->constants[7] * ((t13 * t915) + (t25 *
        t922))) - (t908 * t909);
    const double t932 = (t25 * t915) - (t13 * t922);
    const double t935 = motion->constants[7] * (t932 - motion->constants[73]);
    const double t939 = motion->constants[7] * t932;
    const double t942 = motion->constants[74] - t939 - t939;
    const double t948 = motion->constants[43] + motion->constants[52] + t876 + t882 + t899 + (t356 *
        t819) + (cos_theta * t821);
    const double t950 = t948 + t942 - (t393 * t825);
    const double t955 = motion->constants[7] * (t806 + t809);
    const double t957 = (t25 * t815) + t955 - (t13 * t836);
    const double t960 = t935 + (t576 * t950) + (t697 * t957);
    const double t965 = (t905 * t908) + (t906 * t909);
    const double t966 = t904 - t965;
    const double t969 = t955 - (t576 * t957) - (t697 * t966);
    const double t971 = 1.0 - t576;
    const double t972 = motion->constants[27] * t783;
    const double t975 = sin_delta * t13;
    const double t978 = t229 - (cos_delta * t576) - (t697 * t975);
    const double t984 = t215 + (cos_delta * t783) - (sin_delta * t25) - (t785 * t975);
    const double t985 = motion->constants[28] * t984;
    const double t991 = (t971 * t972) + (t978 * t985) - (t576 * t838) - (t697 * t928) - (t783 *
        t960) - (t785 * t969);
    const double t1010 = t888 + t942 + t965 + (t783 * t838) + (t783 * (t838 + (t783 * t950) -
        (t785 * t957))) + (t783 * t972);
    const double t1013 = t1010 + (t984 * t985) - (t785 * t928) - (t785 * (t928 + (t783 * t957) -
        (t785 * t966)));
    const double t1014 = 1.0 / t1013;
    const double t1015 = t991 * t1014;
    const double t1018 = t115 - (sin_phi * t119);
    const double t1020 = motion->constants[7] * t25 * t809;
    const double t1021 = t811 + t1020;
    const double t1023 = cos_phi * t119;
    const double t1026 = t1021 + (t950 * t1018) - (t957 * t1023);
    const double t1028 = motion->constants[53] + t895;
    const double t1031 = (t25 * t1028) - (t13 * t857);
    const double t1035 = t1031 + (t957 * t1018) - (t966 * t1023);
    const double t1039 = motion->constants[27] * t1018;
    const double t1044 = t224 + (cos_delta * t1018) - (t975 * t1023);
    const double t1045 = motion->constants[28] * t1044;
    const double t1060 = (t13 * t1028) + (t25 * t857) + (motion->constants[7] * t855) + (t838 *
        t1018) + (t783 * t1026) + (t972 * t1018);
    const double t1064 = t1014 * (t1060 + (t985 * t1044) - (t928 * t1023) - (t785 * t1035));
    const double t1065 = t1013 * t1064;
    const double t1071 = motion->constants[53] + (t1018 * t1026) + (t1018 * t1021) + (t1018 *
        t1039) + (t1044 * t1045) - (t1023 * t1035);
    const double t1073 = t1071 - (t1023 * t1031) - (t1064 * t1065);
    const double t1074 = 1.0 / t1073;
    const double t1086 = t1020 + (t971 * t1039) + (t978 * t1045) - (t960 * t1018) - (t969 * t1023) -
        (t576 * t1021);
    const double t1089 = t1074 * (t1086 - (t697 * t1031) - (t1015 * t1065));
    const double t1099 = forces[1] + (t764 * t1023) - t715 - (t695 * t1018) - (t224 * t668) -
        (t793 * t1064);
    const double t1102 = t393 * motion->constants[75];
    const double t1104 = t356 * motion->constants[75];
    const double t1107 = motion->constants[7] * ((t13 * t1102) - (t25 * t1104));
    const double t1117 = (t356 * motion->constants[76]) + (motion->constants[32] * t1102) - t1107 -
        (t393 * motion->constants[77]) - (motion->constants[33] * t1104);
    const double t1121 = cos_theta * motion->constants[75];
    const double t1124 = (t330 * motion->constants[76]) + (t397 * motion->constants[77]) -
        (motion->constants[32] * t1121);
    const double t1130 = (t353 * motion->constants[76]) + (t330 * motion->constants[77]) -
        (motion->constants[33] * t1121);
    const double t1132 = (t25 * t1124) - (t13 * t1130);
    const double t1143 = t1014 * ((t13 * t1124) + (t25 * t1130) + (motion->constants[7] * t1121) +
        (t783 * t1117) - (t785 * t1132));
    const double t1144 = t1013 * t1143;
    const double t1151 = t1074 * ((t1018 * t1117) - (t1023 * t1132) - (t1065 * t1143));
    const double t1152 = t1073 * t1151;
    const double t1162 = motion->constants[78] - (t1143 * t1144) - (t1151 * t1152);
    const double t1163 = 1.0 / t1162;
    const double t1164 = (t1107 + (t576 * t1117) + (t697 * t1132) + (t1015 * t1144) + (t1089 *
        t1152)) * t1163;
    const double t1178 = forces[2] - (motion->constants[3] * t608) - (motion->constants[2] * t631) -
        (positions[6] * motion->constants[5]) - (speeds[2] * motion->constants[6]) - (t793 * t1143);
    const double t1179 = t1178 - (t1099 * t1151);
    const double t1185 = (t576 * t695) + (t697 * t764) + (t1164 * t1179) - t575 - (t229 * t668) -
        (t793 * t1015);
    const double t1206 = (t576 * t960) + (t576 * t935) + motion->constants[79] +
        (motion->constants[27] * t971 * t971) + (motion->constants[28] * t978 * t978) - (t697 *
        t969);
    const double t1211 = (t1185 - (t1089 * t1099)) / (t1206 - (t697 * t955) - (t1013 * t1015 *
        t1015) - (t1073 * t1089 * t1089) - (t1162 * t1164 * t1164));
    const double t1216 = (t1163 * t1179) + (t1164 * t1211);
    const double t1220 = (t1074 * t1099) - (t1151 * t1216) - (t1089 * t1211);
    const double t1226 = (t793 * t1014) - (t1064 * t1220) - (t1143 * t1216) - (t1015 * t1211);
    const double t1230 = t313 + (t81 * t1226) + (t115 * t1220);
    const double t1232 = motion->constants[7] * (t1211 + t1230);
    const double t1235 = t126 * t155;
    const double t1240 = (cos_psi * t1235) - (t1232 * sin_psi);
    const double t1252 = t666 + (t215 * t1226) + (t224 * t1220) + (t229 * t1211);
    const double t1253 = -((cos_psi * t1232) + (sin_psi * t1235));
    const double t1254 = -(t319 + (t83 * t1226) + (t119 * t1220) + (t122 * t1211));
    accelerations[0] = t1253;
    accelerations[1] = t1240;
    accelerations[2] = t1254;
    accelerations[3] = t1226;
    accelerations[4] = t1230;
    accelerations[5] = t1220;
    accelerations[6] = t1216;
    accelerations[7] = t1211;
    accelerations[8] = t1252;
}

carvallo_motion_error_t whipple_leaning_f64_motion_accelerations(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    const double forces[WHIPPLE_LEANING_FORCES], double accelerations[WHIPPLE_LEANING_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_LEANING_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_LEANING_FORCES)) {
        whipple_leaning_f64_compute_accelerations(motion, positions, speeds, forces, accelerations);
        error = (carvallo_are_finite_f64(accelerations, WHIPPLE_LEANING_POSITIONS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_leaning_f64_compute_energy(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    double energy[2])
{
    double sin_theta = 0.0;
    double cos_theta = 0.0;
    carvallo_sin_cos_f64(positions[6], &sin_theta, &cos_theta);
    const double t6 = 1.0 - cos_theta;
    const double t9 = cos_theta + (t6 * motion->constants[34]);
    const double t13 = t6 * motion->constants[35];
    const double t15 = t13 * motion->constants[57];
    const double t20 = motion->constants[2] * sin_theta;
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t32 = sin_delta * motion->constants[66];
    const double t33 = sin_delta * t32;
    const double t39 = cos_theta + (t6 * motion->constants[36]);
    const double t42 = (t13 * motion->constants[54]) + (t39 * motion->constants[55]);
    const double t43 = motion->constants[33] * t42;
    const double t48 = t43 + t43 + motion->constants[63] + motion->constants[68];
    const double t52 = motion->constants[45] + motion->constants[50] + (t9 * ((t9 *
        motion->constants[56]) + t15)) + (t20 * t20 * motion->constants[58]) + (t13 * ((t9 *
        motion->constants[57]) + (t13 * motion->constants[59])));
    const double t54 = t52 + t48 - t33;
    const double t59 = (motion->constants[56] * t13) + (motion->constants[57] * t39);
    const double t62 = sin_theta * motion->constants[3];
    const double t63 = motion->constants[58] * t62;
    const double t66 = t15 + (motion->constants[59] * t39);
    const double t73 = (t9 * motion->constants[54]) + (t13 * motion->constants[55]);
    const double t78 = cos_delta * motion->constants[48];
    const double t79 = motion->constants[30] * t78;
    const double t80 = (motion->constants[32] * t73) - t79;
    const double t83 = motion->constants[65] + motion->constants[71] - t80 - t80;
    const double t88 = motion->constants[46] + motion->constants[53] + (t13 * t59) + (t62 * t63) +
        (t39 * t66) + t83;
    const double t89 = t88 - t54;
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t95 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    const double t96 = t95 * t95;
    const double t100 = (motion->constants[3] * cos_pitch) - (motion->constants[2] * sin_pitch);
    const double t101 = t95 * t100;
    const double t115 = (cos_delta * motion->constants[51]) - (t78 * motion->constants[31]);
    const double t120 = motion->constants[42] + (t9 * t59) + (t13 * t66) + (t42 *
        motion->constants[32]) + motion->constants[64] + t115;
    const double t124 = t120 - (t20 * t63) - (motion->constants[33] * t73) - motion->constants[69] -
        motion->constants[70];
    const double t125 = t124 + t124;
    const double t127 = (t89 * t96) + (t101 * t125);
    const double t134 = t42 + motion->constants[41] + motion->constants[62] + motion->constants[72];
    const double t142 = t73 + t78 + motion->constants[40] + motion->constants[67] -
        motion->constants[61];
    const double t144 = (t100 * t134) - (t95 * t142);
    const double t145 = motion->constants[7] * t144;
    const double t148 = motion->constants[74] - t145 - t145;
    const double t154 = (t20 * motion->constants[54]) - (motion->constants[55] * t62);
    const double t157 = sin_delta * motion->constants[48];
    const double t159 = (sin_delta * motion->constants[51]) - (motion->constants[31] * t157);
    const double t163 = (t20 * t59) + (cos_theta * t63) + t159 - (t62 * t66) -
        (motion->constants[33] * t154);
    const double t167 = (motion->constants[56] * t20) - (motion->constants[57] * t62);
    const double t169 = cos_theta * motion->constants[58];
    const double t173 = (motion->constants[57] * t20) - (motion->constants[59] * t62);
    const double t182 = (t9 * t167) + (t13 * t173) + (motion->constants[32] * t154) + (t32 *
        cos_delta) - (t20 * t169) - (motion->constants[30] * t157);
    const double t184 = (t95 * t163) + (t100 * t182);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t189 = t95 * cos_phi;
    const double t192 = (sin_delta * sin_phi) - (cos_delta * t189);
    const double t194 = t100 * cos_phi;
    const double t197 = sqrt((t192 * t192) + (t194 * t194));
    const double t198 = 1.0 / t197;
    const double t199 = t192 * t198;
    const double t201 = t194 * t198;
    const double t202 = cos_delta * t201;
    const double t204 = (t100 * t202) - (t95 * t199);
    const double t209 = motion->constants[8] * ((cos_delta * sin_phi) + (sin_delta * t189));
    const double t212 = sin_delta * motion->constants[37];
    const double t217 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const double t219 = (t100 * motion->constants[39]) - (t95 * t217);
    const double t222 = (cos_phi * t212) - (t204 * t209) - (sin_phi * t219);
    const double t223 = (motion->constants[7] * sin_phi) + t222;
    const double t230 = (sin_delta * cos_phi * t201) + (sin_phi * ((t100 * t199) + (t95 * t202)));
    const double t235 = (t209 * t230) + (t95 * motion->constants[39]) + (t100 * t217);
    const double t237 = 1.0 / (cos_phi * t235);
    const double t238 = t223 * t237;
    const double t239 = sin_phi * t235;
    const double t241 = sin_phi * t223;
    const double t243 = (t204 * t239) + (t230 * t241);
    const double t247 = 1.0 / ((t204 * t235) + (t223 * t230));
    const double t249 = t238 * t243 * t247;
    const double t251 = t238 - (sin_phi * t249);
    const double t261 = t124 + (t89 * t101) + (motion->constants[7] * ((t95 * t134) + (t100 *
        t142))) - (t96 * t125);
    const double t262 = cos_phi * t249;
    const double t274 = t33 + t48 + t83 + t148 + motion->constants[43] + motion->constants[52] +
        (t20 * t167);
    const double t276 = t274 + (cos_theta * t169) - (t62 * t173);
    const double t280 = t154 + t157;
    const double t281 = motion->constants[7] * t280;
    const double t283 = (t100 * t163) + t281 - (t95 * t182);
    const double t289 = t88 - t127;
    const double t295 = t251 * motion->constants[27];
    const double t299 = (t230 * t239) - (t204 * t241);
    const double t303 = (t230 * t235) - (t204 * t223);
    const double t306 = 1.0 / motion->constants[8];
    const double t310 = sin_delta * t95;
    const double t314 = (((t249 * t303) - (t238 * t299)) * t306) + (cos_delta * t251) - (sin_delta *
        t100) - (t262 * t310);
    const double t316 = t314 * motion->constants[28];
    const double t322 = t54 + t127 + t148 + (t184 * t251) + (t251 * (t184 + (t251 * t276) - (t262 *
        t283))) + (t251 * t295);
    const double t326 = speeds[0] * (t322 + (t314 * t316) - (t261 * t262) - (t262 * (t261 + (t251 *
        t283) - (t262 * t289))));
    const double t328 = motion->constants[53] + t79;
    const double t334 = (t100 * motion->constants[31]) - (motion->constants[30] * t95);
    const double t336 = t222 + (sin_phi * t334);
    const double t338 = t100 * sin_phi;
    const double t342 = t235 - (t95 * motion->constants[31]) - (motion->constants[30] * t100);
    const double t345 = t237 * ((t95 * t336) + (t338 * t342));
    const double t353 = (t197 * motion->constants[8]) + (sin_phi * t212) + (cos_phi * t219) -
        (cos_phi * t334);
    const double t355 = (t194 * t342) - (t95 * t353);
    const double t359 = (t338 * t353) + (t194 * t336);
    const double t364 = t247 * ((t204 * t355) + (t230 * t359) + (t243 * t345));
    const double t366 = t345 - (sin_phi * t364);
    const double t368 = cos_phi * t364;
    const double t371 = t100 * motion->constants[7] * t157;
    const double t372 = t159 + t371;
    const double t376 = t372 + (t276 * t366) - (t283 * t368);
    const double t380 = (t100 * t328) - (t95 * t115);
    const double t384 = t380 + (t283 * t366) - (t289 * t368);
    const double t397 = (t306 * ((t204 * t359) + (t303 * t364) - (t230 * t355) - (t299 * t345))) +
        (cos_delta * t366);
    const double t398 = t397 - (t310 * t368);
    const double t404 = (t95 * t328) + (t100 * t115) + (t78 * motion->constants[7]) + (t184 *
        t366) + (t251 * t376) + (t295 * t366);
    const double t407 = t404 + (t316 * t398) - (t261 * t368) - (t262 * t384);
    const double t415 = cos_theta * motion->constants[75];
    const double t418 = (t13 * motion->constants[76]) + (t39 * motion->constants[77]) -
        (motion->constants[32] * t415);
    const double t424 = (t9 * motion->constants[76]) + (t13 * motion->constants[77]) -
        (motion->constants[33] * t415);
    const double t429 = t20 * motion->constants[75];
    const double t431 = t62 * motion->constants[75];
    const double t436 = motion->constants[7] * ((t95 * t431) - (t100 * t429));
    const double t440 = (t20 * motion->constants[76]) + (motion->constants[32] * t431) - (t62 *
        motion->constants[77]) - (motion->constants[33] * t429) - t436;
    const double t444 = (t100 * t418) - (t95 * t424);
    const double t449 = (t95 * t418) + (t100 * t424) + (motion->constants[7] * t415) + (t251 *
        t440) - (t262 * t444);
    const double t453 = motion->constants[7] * t230 * t247;
    const double t454 = sin_phi * t453;
    const double t456 = cos_phi * t453;
    const double t459 = t144 - motion->constants[73];
    const double t460 = motion->constants[7] * t459;
    const double t464 = t460 + (t276 * t454) + (t283 * t456);
    const double t469 = t281 - (t283 * t454) - (t289 * t456);
    const double t471 = 1.0 - t454;
    const double t480 = (t306 * ((motion->constants[7] * t204) + (t303 * t453))) - (cos_delta *
        t454) - (t310 * t456);
    const double t486 = (t295 * t471) + (t316 * t480) - (t184 * t454) - (t261 * t456) - (t251 *
        t464) - (t262 * t469);
    const double t497 = motion->constants[27] * t366;
    const double t499 = motion->constants[28] * t398;
    const double t505 = motion->constants[53] + (t366 * t376) + (t366 * t372) + (t366 * t497) +
        (t398 * t499) - (t368 * t384);
    const double t510 = (t366 * t440) - (t368 * t444);
    const double t522 = t371 + (t471 * t497) + (t480 * t499) - (t366 * t464) - (t368 * t469) -
        (t372 * t454);
    const double t523 = t522 - (t380 * t456);
    const double t527 = (speeds[0] * t407) + (speeds[1] * (t505 - (t368 * t380))) + (speeds[2] *
        t510) + (speeds[3] * t523);
    const double t536 = t436 + (t440 * t454) + (t444 * t456);
    const double t558 = (t454 * t464) + (t454 * t460) + motion->constants[79] +
        (motion->constants[27] * t471 * t471) + (motion->constants[28] * t480 * t480) - (t456 *
        t469);
    const double t564 = speeds[3] * ((speeds[0] * t486) + (speeds[1] * t523) + (speeds[3] * (t558 -
        (t281 * t456))) - (speeds[2] * t536));
    const double t565 = (speeds[0] * (t326 + (speeds[1] * t407) + (speeds[2] * t449) + (speeds[3] *
        t486))) + (speeds[1] * t527);
    const double t566 = t565 + (speeds[2] * ((speeds[0] * t449) + (speeds[1] * t510) + (speeds[2] *
        motion->constants[78]) - (speeds[3] * t536)));
    const double t569 = (t566 + t564) * 0.5;
    const double t579 = (positions[6] * positions[6] * 0.5 * motion->constants[5]) -
        (motion->constants[60] * ((sin_phi * t280) + (cos_phi * t459)));
    energy[0] = t569;
    energy[1] = t579;
}

carvallo_motion_error_t whipple_leaning_f64_motion_energy(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    double energy[2])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_LEANING_SPEEDS)) {
        whipple_leaning_f64_compute_energy(motion, positions, speeds, energy);
        error = (carvallo_are_finite_f64(energy, 2U)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

/* How far the lowest points of the wheels behind the first are below the ground, and the steps of Newton's method. */
static void whipple_leaning_f64_compute_closure(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], double below[1U], double steps[1U])
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
    const double t14 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    const double t15 = cos_phi * t14;
    const double t19 = sin_phi * sin_delta;
    const double t20 = t19 - (cos_delta * t15);
    const double t24 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const double t25 = cos_phi * t24;
    const double t28 = sqrt((t20 * t20) + (t25 * t25));
    const double t36 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const double t42 = (motion->constants[8] * t28) + (t19 * motion->constants[37]) + (cos_phi *
        ((t24 * motion->constants[39]) - (t14 * t36))) - (motion->constants[7] * cos_phi);
    const double t46 = 1.0 / t28;
    const double t47 = t25 * t46;
    const double t58 = motion->constants[8] * ((cos_delta * sin_phi) + (t15 * sin_delta)) *
        ((cos_phi * sin_delta * t47) + (sin_phi * ((t20 * t24 * t46) + (cos_delta * t14 * t47))));
    const double t64 = t42 / (cos_phi * (t58 + (t14 * motion->constants[39]) + (t24 * t36)));
    below[0] = t42;
    steps[0] = t64;
}

carvallo_motion_error_t whipple_leaning_f64_motion_close(const whipple_leaning_f64_motion_t *motion,
    double positions[WHIPPLE_LEANING_POSITIONS])
{
    /* The positions that the heights of the wheels determine. */
    static const size_t DEPENDENT[1U] = {4U};
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_LEANING_POSITIONS)) {
        double found[WHIPPLE_LEANING_POSITIONS];
        double below[1U];
        double steps[1U];
        double shortest = 1e30;
        bool is_closed = false;
        bool goes_on = true;
        for (size_t i = 0U; i < WHIPPLE_LEANING_POSITIONS; i++) {
            found[i] = positions[i];
        }
        /* With steps of the greatest length they lead around the whole circle; near a solution a handful is enough. */
        for (size_t count = 0U; goes_on && (count < 60U); count++) {
            whipple_leaning_f64_compute_closure(motion, found, below, steps);
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
            whipple_leaning_f64_compute_closure(motion, found, below, steps);
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

static void whipple_leaning_f64_compute_contact_forces(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    const double forces[WHIPPLE_LEANING_FORCES], double contact_forces[3U * WHIPPLE_LEANING_WHEELS])
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
    const double t47 = (cos_delta * sin_phi) + (t19 * sin_delta);
    const double t48 = motion->constants[8] * t47;
    const double t55 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const double t58 = (t43 * t48) + (t9 * motion->constants[39]) + (t13 * t55);
    const double t59 = sin_phi * t58;
    const double t64 = sin_delta * motion->constants[37];
    const double t68 = (t13 * motion->constants[39]) - (t9 * t55);
    const double t71 = (cos_phi * t64) - (t36 * t48) - (sin_phi * t68);
    const double t72 = (sin_phi * motion->constants[7]) + t71;
    const double t73 = sin_phi * t72;
    const double t75 = (t36 * t59) + (t43 * t73);
    const double t77 = 1.0 / (cos_phi * t58);
    const double t78 = t72 * t77;
    const double t82 = 1.0 / ((t36 * t58) + (t43 * t72));
    const double t84 = t75 * t78 * t82;
    const double t91 = t58 - (t9 * motion->constants[31]) - (t13 * motion->constants[30]);
    const double t98 = (t13 * motion->constants[31]) - (t9 * motion->constants[30]);
    const double t102 = (t29 * motion->constants[8]) + (sin_phi * t64) + (cos_phi * t68) -
        (cos_phi * t98);
    const double t104 = (t26 * t91) - (t9 * t102);
    const double t106 = t13 * sin_phi;
    const double t109 = t71 + (sin_phi * t98);
    const double t111 = (t102 * t106) + (t26 * t109);
    const double t116 = t77 * ((t9 * t109) + (t91 * t106));
    const double t120 = t82 * ((t36 * t104) + (t43 * t111) + (t75 * t116));
    const double t124 = t43 * motion->constants[7] * t82;
    const double t127 = (speeds[0] * t84) + (speeds[1] * t120) + (speeds[3] * t124);
    const double t128 = cos_phi * t127;
    const double t130 = (speeds[0] * t13) + (t9 * t128);
    const double t133 = (t9 * speeds[0]) - (t13 * t128);
    const double t138 = (t133 * motion->constants[40]) - (t130 * motion->constants[41]);
    const double t142 = (speeds[0] * t78) + (speeds[1] * t116);
    const double t143 = sin_phi * t127;
    const double t144 = t142 - t143;
    const double t145 = motion->constants[41] * t144;
    const double t147 = (t130 * t138) - (t144 * t145);
    const double t149 = speeds[0] * motion->constants[7];
    const double t151 = speeds[3] + t142;
    const double t153 = motion->constants[7] * t143;
    const double t155 = ((t151 - t143) * t153) - (speeds[0] * t149);
    const double t158 = t155 + (cos_phi * motion->constants[60]);
    const double t159 = t13 * t158;
    const double t160 = t128 * t149;
    const double t161 = motion->constants[31] * t144;
    const double t163 = motion->constants[30] * t144;
    const double t165 = (t133 * t161) + (t130 * t163);
    const double t166 = speeds[0] * t143;
    const double t168 = t130 * t142;
    const double t169 = (t13 * t166) + t168;
    const double t172 = t133 * t142;
    const double t173 = (t9 * t166) + t172;
    const double t175 = t128 * t151;
    const double t177 = t128 * t153;
    const double t178 = t177 - (motion->constants[7] * t175);
    const double t181 = t165 + (motion->constants[30] * t169) + (motion->constants[31] * t173) -
        t178;
    const double t186 = (motion->constants[30] * t133) - (motion->constants[31] * t130);
    const double t188 = (t144 * t163) + (t133 * t186);
    const double t189 = speeds[0] * t128;
    const double t192 = t160 + (motion->constants[7] * t189);
    const double t197 = (t13 * t192) + (t9 * t155) - t188 - (motion->constants[31] * t189);
    const double t199 = speeds[1] + t133;
    const double t203 = (cos_delta * t144) - (sin_delta * t130);
    const double t204 = motion->constants[38] * t203;
    const double t208 = (cos_delta * t130) + (sin_delta * t144);
    const double t209 = motion->constants[37] * t203;
    const double t214 = speeds[1] * t203;
    const double t216 = t214 - (cos_delta * t173) - (sin_delta * t189);
    const double t218 = t31 * motion->constants[8];
    const double t221 = (t43 * t59) - (t36 * t73);
    const double t225 = (t43 * t58) - (t36 * t72);
    const double t228 = 1.0 / motion->constants[8];
    const double t229 = ((t84 * t225) - (t78 * t221)) * t228;
    const double t238 = t228 * ((t36 * t111) + (t120 * t225) - (t43 * t104) - (t116 * t221));
    const double t243 = t228 * ((t36 * motion->constants[7]) + (t124 * t225));
    const double t246 = (speeds[0] * t229) + (speeds[1] * t238) + (speeds[3] * t243);
    const double t250 = t33 * motion->constants[8];
    const double t258 = t30 * t47 * ((t31 * t208) + (t33 * t199));
    const double t259 = t250 * t258;
    const double t261 = t218 * t258;
    const double t267 = (cos_delta * t181) + (t199 * t204) + (t208 * t209) +
        (motion->constants[37] * t169) + (t218 * (t169 + (t208 * t246))) + (t199 * t259);
    const double t271 = t267 + (t208 * t261) - (sin_delta * t197) - (motion->constants[38] * t216) -
        (t250 * (t216 - (t199 * t246)));
    const double t278 = (motion->constants[37] * t199) - (motion->constants[38] * t208);
    const double t282 = speeds[1] * t208;
    const double t284 = (sin_delta * t173) - (cos_delta * t189) - t282;
    const double t287 = t203 + t246;
    const double t292 = motion->constants[8] * ((t31 * t199) - (t33 * t208));
    const double t298 = (cos_delta * t197) + (sin_delta * t181) + (motion->constants[38] * t284) +
        (t250 * t284) - (t203 * t209) - (t199 * t278);
    const double t300 = t298 - (t261 * t287) - (t199 * t292);
    const double t304 = (t130 * t186) - (t144 * t161);
    const double t318 = t304 + (motion->constants[30] * t189) + (t9 * t192) + (t208 * t278) +
        (t208 * t292) - (t13 * t155);
    const double t322 = t318 - (t203 * t204) - (motion->constants[37] * t284) - (t218 * t284) -
        (t259 * t287);
    const double t324 = (t31 * t300) + (t33 * t322);
    const double t329 = t77 * ((t47 * t271) + (t29 * t324));
    const double t333 = t82 * ((t29 * t271) + (t75 * t329) - (t47 * t324));
    const double t335 = t189 - t329;
    const double t336 = (sin_phi * t333) + t335;
    double sin_theta = 0.0;
    double cos_theta = 0.0;
    carvallo_sin_cos_f64(positions[6], &sin_theta, &cos_theta);
    const double t342 = 1.0 - cos_theta;
    const double t344 = t342 * motion->constants[35];
    const double t346 = (motion->constants[7] * t336) + t160;
    const double t348 = t9 * t158;
    const double t349 = t348 + (t13 * t346);
    const double t351 = t144 * motion->constants[32];
    const double t356 = (t133 * motion->constants[32]) + (t130 * motion->constants[33]);
    const double t358 = (t144 * t351) + (t133 * t356);
    const double t361 = t349 + t358 - (t336 * motion->constants[33]);
    const double t364 = cos_theta + (t342 * motion->constants[34]);
    const double t367 = motion->constants[2] * sin_theta;
    const double t368 = t144 * motion->constants[33];
    const double t371 = (t133 * t368) - (t130 * t351);
    const double t373 = t166 - (cos_phi * t333);
    const double t375 = t168 + (t13 * t373);
    const double t378 = t172 + (t9 * t373);
    const double t380 = sin_phi * motion->constants[60];
    const double t381 = t178 + t380;
    const double t384 = t371 + (motion->constants[33] * t378) - (motion->constants[32] * t375) -
        t381;
    const double t387 = t159 - (t9 * t346);
    const double t390 = (t130 * t356) + (t144 * t368);
    const double t393 = (t336 * motion->constants[32]) + t387 + t390;
    const double t396 = (t361 * t364) + (t367 * t384) - (t393 * t344);
    const double t401 = motion->constants[2] * speeds[2];
    const double t403 = motion->constants[3] * sin_theta;
    const double t407 = cos_theta + (t342 * motion->constants[36]);
    const double t411 = t401 + (t130 * t344) + (t133 * t407) - (t144 * t403);
    const double t413 = motion->constants[3] * speeds[2];
    const double t419 = t413 + (t130 * t364) + (t144 * t367) + (t133 * t344);
    const double t422 = speeds[2] * ((motion->constants[3] * t411) - (motion->constants[2] * t419));
    const double t428 = t422 + (t367 * t378) - (t336 * cos_theta) + (t375 * t403);
    const double t434 = (t144 * cos_theta) + (t133 * t403) - (t130 * t367);
    const double t436 = t434 * motion->constants[54];
    const double t440 = (t411 * motion->constants[54]) - (motion->constants[55] * t419);
    const double t442 = (t434 * t436) + (t411 * t440);
    const double t444 = (t396 * motion->constants[24]) + (motion->constants[55] * t428) - t442;
    const double t450 = (cos_theta * t384) - (t403 * t393) - (t367 * t361);
    const double t452 = t434 * t413;
    const double t458 = (t375 * t407) - t452 - (t378 * t344) + (t336 * t403);
    const double t460 = t434 * t401;
    const double t466 = t460 - (t336 * t367) + (t375 * t344) - (t378 * t364);
    const double t468 = motion->constants[55] * t434;
    const double t471 = (t411 * t468) + (t419 * t436);
    const double t474 = (t450 * motion->constants[24]) + (t458 * motion->constants[54]) + t471 -
        (motion->constants[55] * t466);
    const double t480 = (t361 * t344) - (t393 * t407) - (t384 * t403);
    const double t485 = (t419 * t440) - (t434 * t468);
    const double t487 = (t480 * motion->constants[24]) + t485 - (motion->constants[54] * t428);
    const double t490 = (t344 * t444) + (t403 * t474) + (t407 * t487);
    const double t493 = t304 - t387 + (motion->constants[30] * t336);
    const double t500 = (sin_delta * t378) - (cos_delta * t336) - t282;
    const double t505 = (t199 * motion->constants[48]) - (t208 * motion->constants[49]);
    const double t507 = t203 * motion->constants[49];
    const double t509 = (t208 * t505) - (t203 * t507);
    const double t511 = (t493 * motion->constants[47]) + t509 - (motion->constants[48] * t500);
    const double t523 = (t364 * t444) + (t344 * t487) - (t367 * t474);
    const double t526 = t349 - (motion->constants[31] * t336) - t188;
    const double t532 = t165 + (motion->constants[30] * t375) + (motion->constants[31] * t378) -
        t381;
    const double t534 = (cos_delta * t526) + (sin_delta * t532);
    const double t537 = t203 * motion->constants[48];
    const double t540 = (t203 * t537) + (t199 * t505);
    const double t542 = (t534 * motion->constants[47]) + (motion->constants[49] * t500) - t540;
    const double t546 = (cos_delta * t532) - (sin_delta * t526);
    const double t552 = t214 - (sin_delta * t336) - (cos_delta * t378);
    const double t556 = (t199 * t507) + (t208 * t537);
    const double t559 = (t546 * motion->constants[47]) + (t375 * motion->constants[48]) + t556 -
        (motion->constants[49] * t552);
    const double t561 = (cos_delta * t542) - (sin_delta * t559);
    const double t564 = motion->constants[40] * t144;
    const double t567 = (t144 * t564) + (t133 * t138);
    const double t573 = (t9 * (t147 + t490 + t511 - (motion->constants[44] * t387) +
        (motion->constants[40] * t336))) + (t13 * (t523 + t561 + (motion->constants[44] * t349) -
        (motion->constants[41] * t336) - t567));
    const double t575 = (t336 * motion->constants[27]) + (motion->constants[7] * t573);
    const double t576 = sin_phi * t124;
    const double t585 = (t130 * motion->constants[45]) + (t133 * motion->constants[42]);
    const double t590 = (t130 * motion->constants[42]) + (t133 * motion->constants[46]);
    const double t592 = (t133 * t585) - (t130 * t590);
    const double t601 = (motion->constants[57] * t419) + (t411 * motion->constants[59]);
    const double t604 = t434 * motion->constants[58];
    const double t606 = (t434 * t601) - (t411 * t604);
    const double t609 = (motion->constants[56] * t466) + (motion->constants[57] * t458) + t606 -
        (motion->constants[55] * t450);
    const double t616 = (motion->constants[56] * t419) + (motion->constants[57] * t411);
    const double t619 = (t411 * t616) - (t419 * t601);
    const double t622 = (motion->constants[55] * t396) + (motion->constants[58] * t428) + t619 -
        (motion->constants[54] * t480);
    const double t629 = (t419 * t604) - (t434 * t616);
    const double t632 = (t450 * motion->constants[54]) + (t466 * motion->constants[57]) + (t458 *
        motion->constants[59]) + t629;
    const double t644 = (t208 * motion->constants[51]) + (t199 * motion->constants[53]);
    const double t650 = (t203 * motion->constants[52]) + (t287 * motion->constants[28]);
    const double t652 = (t203 * t644) - (t199 * t650);
    const double t655 = (motion->constants[50] * t552) + (t375 * motion->constants[51]) + t652 -
        (motion->constants[49] * t546);
    const double t667 = t228 * ((t31 * t322) + (t225 * t333) - (t33 * t300) - (t221 * t329));
    const double t669 = motion->constants[28] * (t500 + t667);
    const double t672 = (t208 * motion->constants[50]) + (t199 * motion->constants[51]);
    const double t675 = (t199 * t672) - (t208 * t644);
    const double t679 = (motion->constants[49] * t534) + (motion->constants[52] * t500) + t669 +
        t675 - (motion->constants[48] * t493);
    const double t687 = (motion->constants[41] * t349) + (motion->constants[40] * t387) - (t336 *
        motion->constants[43]) + t592 + (t367 * t609) + (cos_theta * t622);
    const double t692 = t687 + (motion->constants[33] * t523) + (motion->constants[32] * t490) +
        (sin_delta * t655) + (cos_delta * t679) + (motion->constants[31] * t561);
    const double t695 = t692 - t575 - (t403 * t632) - (motion->constants[30] * t511);
    const double t697 = cos_phi * t124;
    const double t704 = (t144 * motion->constants[43]) + (motion->constants[27] * (speeds[3] +
        t144));
    const double t707 = (t130 * t704) - (t144 * t585);
    const double t713 = (t208 * t650) - (t203 * t672);
    const double t716 = (t546 * motion->constants[48]) + (t552 * motion->constants[51]) + (t375 *
        motion->constants[53]) + t713;
    const double t724 = (t367 * t444) + (cos_theta * t474) - (t403 * t487);
    const double t728 = (sin_delta * t542) + (cos_delta * t559);
    const double t734 = (motion->constants[46] * t375) + t707 + t716 + (t344 * t609) + (t403 *
        t622) + (t407 * t632);
    const double t738 = t734 + (motion->constants[30] * t728) - (motion->constants[40] * t381) -
        (motion->constants[42] * t378) - (motion->constants[32] * t724);
    const double t745 = (t144 * t590) - (t133 * t704);
    const double t757 = (motion->constants[41] * t381) + (motion->constants[42] * t375) + t745 +
        (t364 * t609) + (t344 * t632) + (cos_delta * t655);
    const double t762 = t757 - (motion->constants[45] * t378) - (t367 * t622) -
        (motion->constants[33] * t724) - (sin_delta * t679) - (motion->constants[31] * t728);
    const double t764 = (t13 * t738) - (t9 * t762);
    const double t775 = (t133 * t145) + (t130 * t564);
    const double t781 = motion->constants[7] * (t724 + t728 + (motion->constants[40] * t375) +
        (motion->constants[41] * t378) + t775 - (motion->constants[44] * t381));
    const double t783 = t78 - (sin_phi * t84);
    const double t785 = cos_phi * t84;
    const double t792 = forces[0] + (t764 * t785) - (t9 * t738) - (t13 * t762) - t781 - (t695 *
        t783);
    const double t793 = t792 - (t229 * t669);
    const double t796 = (motion->constants[56] * t344) + (motion->constants[57] * t407);
    const double t798 = t403 * motion->constants[58];
    const double t800 = t344 * motion->constants[57];
    const double t802 = t800 + (t407 * motion->constants[59]);
    const double t806 = (t367 * motion->constants[54]) - (motion->constants[55] * t403);
    const double t809 = sin_delta * motion->constants[48];
    const double t811 = (sin_delta * motion->constants[51]) - (motion->constants[31] * t809);
    const double t815 = (t367 * t796) + (cos_theta * t798) + t811 - (t403 * t802) -
        (motion->constants[33] * t806);
    const double t819 = (t367 * motion->constants[56]) - (t403 * motion->constants[57]);
    const double t821 = cos_theta * motion->constants[58];
    const double t825 = (t367 * motion->constants[57]) - (t403 * motion->constants[59]);
    const double t829 = sin_delta * motion->constants[66];
    const double t836 = (t364 * t819) + (t344 * t825) + (motion->constants[32] * t806) +
        (cos_delta * t829) - (t367 * t821) - (motion->constants[30] * t809);
    const double t838 = (t9 * t815) + (t13 * t836);
    const double t845 = (t344 * motion->constants[54]) + (motion->constants[55] * t407);
    const double t849 = (t364 * motion->constants[54]) + (motion->constants[55] * t344);
    const double t855 = cos_delta * motion->constants[48];
    const double t857 = (cos_delta * motion->constants[51]) - (motion->constants[31] * t855);
    const double t862 = motion->constants[42] + (t364 * t796) + (t344 * t802) +
        (motion->constants[32] * t845) + motion->constants[64] + t857;
    const double t866 = t862 - (t367 * t798) - (motion->constants[33] * t849) -
        motion->constants[69] - motion->constants[70];
    const double t876 = sin_delta * t829;
    const double t877 = motion->constants[33] * t845;
    const double t882 = t877 + t877 + motion->constants[63] + motion->constants[68];
    const double t886 = motion->constants[45] + motion->constants[50] + (t364 * (t800 +
        (motion->constants[56] * t364))) + (t367 * t367 * motion->constants[58]) + (t344 * ((t364 *
        motion->constants[57]) + (t344 * motion->constants[59])));
    const double t888 = t886 + t882 - t876;
    const double t895 = motion->constants[30] * t855;
    const double t896 = (motion->constants[32] * t849) - t895;
    const double t899 = motion->constants[65] + motion->constants[71] - t896 - t896;
    const double t904 = motion->constants[46] + motion->constants[53] + (t344 * t796) + (t403 *
        t798) + (t407 * t802) + t899;
    const double t905 = t904 - t888;
    const double t906 = t9 * t13;
    const double t908 = t9 * t9;
    const double t909 = t866 + t866;
    const double t915 = motion->constants[41] + t845 + motion->constants[62] +
        motion->constants[72];
    const double t922 = motion->constants[40] + t849 + t855 + motion->constants[67] -
        motion->constants[61];
    const double t928 = t866 + (t905 * t906) + (motion->constants[7] * ((t9 * t915) + (t13 *
        t922))) - (t908 * t909);
    const double t932 = (t13 * t915) - (t9 * t922);
    const double t935 = motion->constants[7] * (t932 - motion->constants[73]);
    const double t939 = motion->constants[7] * t932;
    const double t942 = motion->constants[74] - t939 - t939;
    const double t948 = motion->constants[43] + motion->constants[52] + t876 + t882 + t899 + (t367 *
        t819) + (cos_theta * t821);
    const double t950 = t948 + t942 - (t403 * t825);
    const double t955 = motion->constants[7] * (t806 + t809);
    const double t957 = (t13 * t815) + t955 - (t9 * t836);
    const double t960 = t935 + (t576 * t950) + (t697 * t957);
    const double t965 = (t905 * t908) + (t906 * t909);
    const double t966 = t904 - t965;
    const double t969 = t955 - (t576 * t957) - (t697 * t966);
    const double t971 = 1.0 - t576;
    const double t972 = motion->constants[27] * t783;
    const double t975 = t9 * sin_delta;
    const double t978 = t243 - (cos_delta * t576) - (t697 * t975);
    const double t984 = t229 + (cos_delta * t783) - (t13 * sin_delta) - (t785 * t975);
    const double t985 = motion->constants[28] * t984;
    const double t991 = (t971 * t972) + (t978 * t985) - (t576 * t838) - (t697 * t928) - (t783 *
        t960) - (t785 * t969);
    const double t1010 = t888 + t942 + t965 + (t783 * t838) + (t783 * (t838 + (t783 * t950) -
        (t785 * t957))) + (t783 * t972);
    const double t1013 = t1010 + (t984 * t985) - (t785 * t928) - (t785 * (t928 + (t783 * t957) -
        (t785 * t966)));
    const double t1014 = 1.0 / t1013;
    const double t1015 = t991 * t1014;
    const double t1018 = t116 - (sin_phi * t120);
    const double t1020 = t13 * motion->constants[7] * t809;
    const double t1021 = t811 + t1020;
    const double t1023 = cos_phi * t120;
    const double t1026 = t1021 + (t950 * t1018) - (t957 * t1023);
    const double t1028 = motion->constants[53] + t895;
    const double t1031 = (t13 * t1028) - (t9 * t857);
    const double t1035 = t1031 + (t957 * t1018) - (t966 * t1023);
    const double t1039 = motion->constants[27] * t1018;
    const double t1044 = t238 + (cos_delta * t1018) - (t975 * t1023);
    const double t1045 = motion->constants[28] * t1044;
    const double t1060 = (t9 * t1028) + (t13 * t857) + (motion->constants[7] * t855) + (t838 *
        t1018) + (t783 * t1026) + (t972 * t1018);
    const double t1064 = t1014 * (t1060 + (t985 * t1044) - (t928 * t1023) - (t785 * t1035));
    const double t1065 = t1013 * t1064;
    const double t1071 = motion->constants[53] + (t1018 * t1026) + (t1018 * t1021) + (t1018 *
        t1039) + (t1044 * t1045) - (t1023 * t1035);
    const double t1073 = t1071 - (t1023 * t1031) - (t1064 * t1065);
    const double t1074 = 1.0 / t1073;
    const double t1086 = t1020 + (t971 * t1039) + (t978 * t1045) - (t960 * t1018) - (t969 * t1023) -
        (t576 * t1021);
    const double t1089 = t1074 * (t1086 - (t697 * t1031) - (t1015 * t1065));
    const double t1099 = forces[1] + (t764 * t1023) - t716 - (t695 * t1018) - (t238 * t669) -
        (t793 * t1064);
    const double t1102 = t403 * motion->constants[75];
    const double t1104 = t367 * motion->constants[75];
    const double t1107 = motion->constants[7] * ((t9 * t1102) - (t13 * t1104));
    const double t1117 = (t367 * motion->constants[76]) + (motion->constants[32] * t1102) - t1107 -
        (t403 * motion->constants[77]) - (motion->constants[33] * t1104);
    const double t1121 = cos_theta * motion->constants[75];
    const double t1124 = (t344 * motion->constants[76]) + (t407 * motion->constants[77]) -
        (motion->constants[32] * t1121);
    const double t1130 = (t364 * motion->constants[76]) + (t344 * motion->constants[77]) -
        (motion->constants[33] * t1121);
    const double t1132 = (t13 * t1124) - (t9 * t1130);
    const double t1143 = t1014 * ((t9 * t1124) + (t13 * t1130) + (motion->constants[7] * t1121) +
        (t783 * t1117) - (t785 * t1132));
    const double t1144 = t1013 * t1143;
    const double t1151 = t1074 * ((t1018 * t1117) - (t1023 * t1132) - (t1065 * t1143));
    const double t1152 = t1073 * t1151;
    const double t1162 = motion->constants[78] - (t1143 * t1144) - (t1151 * t1152);
    const double t1163 = 1.0 / t1162;
    const double t1164 = (t1107 + (t576 * t1117) + (t697 * t1132) + (t1015 * t1144) + (t1089 *
        t1152)) * t1163;
    const double t1178 = forces[2] - (motion->constants[3] * t609) - (motion->constants[2] * t632) -
        (positions[6] * motion->constants[5]) - (speeds[2] * motion->constants[6]) - (t793 * t1143);
    const double t1179 = t1178 - (t1099 * t1151);
    const double t1185 = (t576 * t695) + (t697 * t764) + (t1164 * t1179) + t575 - (t243 * t669) -
        (t793 * t1015);
    const double t1206 = (t576 * t960) + (t576 * t935) + motion->constants[79] +
        (motion->constants[27] * t971 * t971) + (motion->constants[28] * t978 * t978) - (t697 *
        t969);
    const double t1211 = (t1185 - (t1089 * t1099)) / (t1206 - (t697 * t955) - (t1013 * t1015 *
        t1015) - (t1073 * t1089 * t1089) - (t1162 * t1164 * t1164));
    const double t1216 = (t1163 * t1179) + (t1164 * t1211);
    const double t1220 = (t1074 * t1099) - (t1151 * t1216) - (t1089 * t1211);
    const double t1226 = (t793 * t1014) - (t1064 * t1220) - (t1143 * t1216) - (t1015 * t1211);
    const double t1234 = t333 + (t84 * t1226) + (t120 * t1220) + (t124 * t1211);
    const double t1238 = (t78 * t1226) + (t116 * t1220) - (sin_phi * t1234) - t335;
    const double t1239 = t1211 + t1238;
    const double t1241 = (motion->constants[7] * t1239) - t160;
    const double t1243 = t159 + (t9 * t1241);
    const double t1248 = t304 - t1243 - (motion->constants[30] * t1238);
    const double t1253 = t166 - (cos_phi * t1234);
    const double t1256 = (t13 * t1226) - t172 - (t9 * t1253);
    const double t1259 = (cos_delta * t1238) - t282 - (sin_delta * t1256);
    const double t1262 = t509 + (motion->constants[47] * t1248) - (motion->constants[48] * t1259);
    const double t1265 = t348 - (t13 * t1241);
    const double t1267 = t358 + (motion->constants[33] * t1238) + t1265;
    const double t1272 = t168 + (t13 * t1253) + (t9 * t1226);
    const double t1278 = t177 + t380 - (motion->constants[7] * (t175 + t1226));
    const double t1281 = t371 - (motion->constants[32] * t1272) - (motion->constants[33] * t1256) -
        t1278;
    const double t1285 = (motion->constants[32] * t1238) - t390 - t1243;
    const double t1288 = (t364 * t1267) + (t367 * t1281) + (t344 * t1285);
    const double t1295 = t422 + (cos_theta * t1238) + (t403 * t1272) - (t367 * t1256);
    const double t1298 = (motion->constants[24] * t1288) + (motion->constants[55] * t1295) - t442;
    const double t1304 = (cos_theta * t1281) + (t403 * t1285) - (t367 * t1267);
    const double t1313 = (t344 * t1256) + (t407 * t1272) + (motion->constants[2] * t1216) - t452 -
        (t403 * t1238);
    const double t1322 = t460 + (t364 * t1256) + (t367 * t1238) + (t344 * t1272) +
        (motion->constants[3] * t1216);
    const double t1326 = t471 + (motion->constants[24] * t1304) + (motion->constants[54] * t1313) -
        (motion->constants[55] * t1322);
    const double t1332 = (t344 * t1267) + (t407 * t1285) - (t403 * t1281);
    const double t1336 = t485 + (motion->constants[24] * t1332) - (motion->constants[54] * t1295);
    const double t1339 = (t344 * t1298) + (t403 * t1326) + (t407 * t1336);
    const double t1343 = t147 + t1262 + t1339 - (motion->constants[44] * t1243) -
        (motion->constants[40] * t1238);
    const double t1351 = (t364 * t1298) + (t344 * t1336) - (t367 * t1326);
    const double t1354 = t1265 + (motion->constants[31] * t1238) - t188;
    const double t1360 = t165 + (motion->constants[30] * t1272) - t1278 - (motion->constants[31] *
        t1256);
    const double t1362 = (cos_delta * t1354) + (sin_delta * t1360);
    const double t1366 = (motion->constants[47] * t1362) + (motion->constants[49] * t1259) - t540;
    const double t1370 = (cos_delta * t1360) - (sin_delta * t1354);
    const double t1372 = t1220 + t1272;
    const double t1377 = t214 + (cos_delta * t1256) + (sin_delta * t1238);
    const double t1381 = t556 + (motion->constants[47] * t1370) + (motion->constants[48] * t1372) -
        (motion->constants[49] * t1377);
    const double t1383 = (cos_delta * t1366) - (sin_delta * t1381);
    const double t1387 = (motion->constants[44] * t1265) + (motion->constants[41] * t1238) + t1351 +
        t1383 - t567;
    const double t1389 = (t9 * t1343) + (t13 * t1387);
    const double t1397 = motion->constants[28] * (t667 + t1259 + (t229 * t1226) + (t238 * t1220) +
        (t243 * t1211));
    const double t1398 = t228 * t1397;
    const double t1409 = t606 + (motion->constants[56] * t1322) + (motion->constants[57] * t1313) -
        (motion->constants[55] * t1304);
    const double t1416 = t619 + (motion->constants[55] * t1288) + (motion->constants[58] * t1295) -
        (motion->constants[54] * t1332);
    const double t1423 = t629 + (motion->constants[54] * t1304) + (motion->constants[57] * t1322) +
        (motion->constants[59] * t1313);
    const double t1432 = t652 + (motion->constants[50] * t1377) + (motion->constants[51] * t1372) -
        (motion->constants[49] * t1370);
    const double t1440 = t675 + t1397 + (motion->constants[49] * t1362) + (motion->constants[52] *
        t1259) - (motion->constants[48] * t1248);
    const double t1449 = t592 + (motion->constants[41] * t1265) + (motion->constants[40] * t1243) +
        (motion->constants[43] * t1238) + (motion->constants[27] * t1239) + (t367 * t1409);
    const double t1454 = t1449 + (cos_theta * t1416) + (motion->constants[33] * t1351) +
        (motion->constants[32] * t1339) + (sin_delta * t1432) + (cos_delta * t1440);
    const double t1458 = t1454 + (motion->constants[31] * t1383) - (t403 * t1423) -
        (motion->constants[30] * t1262) - (motion->constants[7] * t1389);
    const double t1473 = (t367 * t1298) + (cos_theta * t1326) - (t403 * t1336);
    const double t1477 = (sin_delta * t1366) + (cos_delta * t1381);
    const double t1484 = t707 + t713 + (motion->constants[42] * t1256) + (motion->constants[46] *
        t1272) + (motion->constants[48] * t1370) + (motion->constants[51] * t1377) +
        (motion->constants[53] * t1372);
    const double t1489 = t1484 + (t344 * t1409) + (t403 * t1416) + (t407 * t1423) +
        (motion->constants[30] * t1477) - (motion->constants[40] * t1278);
    const double t1506 = t745 + (motion->constants[41] * t1278) + (motion->constants[45] * t1256) +
        (motion->constants[42] * t1272) + (t364 * t1409) + (t344 * t1423);
    const double t1511 = t1506 + (cos_delta * t1432) - (t367 * t1416) - (motion->constants[33] *
        t1473) - (sin_delta * t1440) - (motion->constants[31] * t1477);
    const double t1516 = (sin_phi * t1458) + (cos_phi * ((t13 * (t1489 - (motion->constants[32] *
        t1473))) - (t9 * t1511)));
    const double t1518 = t82 * (t1516 - (t225 * t1398));
    const double t1520 = (t36 * t1398) - (t43 * t1518);
    const double t1521 = t1389 - t1520;
    const double t1526 = (t43 * t1398) + (t36 * t1518);
    const double t1534 = t775 + t1473 + t1477 + (motion->constants[40] * t1272) -
        (motion->constants[44] * t1278) - (motion->constants[41] * t1256);
    const double t1538 = (t13 * t1343) - (t9 * t1387);
    const double t1541 = (cos_phi * t1534) - t1526 - (sin_phi * t1538);
    const double t1543 = (cos_psi * t1521) - (sin_psi * t1541);
    const double t1546 = (t1521 * sin_psi) + (cos_psi * t1541);
    const double t1551 = t77 * (t1458 - (t75 * t1518) - (t221 * t1398));
    const double t1555 = t1551 + (sin_phi * t1534) + (cos_phi * t1538);
    const double t1558 = (cos_psi * t1520) - (sin_psi * t1526);
    const double t1561 = (t1520 * sin_psi) + (cos_psi * t1526);
    const double t1562 = -t1551;
    contact_forces[0] = t1543;
    contact_forces[1] = t1546;
    contact_forces[2] = t1555;
    contact_forces[3] = t1558;
    contact_forces[4] = t1561;
    contact_forces[5] = t1562;
}

carvallo_motion_error_t whipple_leaning_f64_motion_contact_forces(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    const double forces[WHIPPLE_LEANING_FORCES], double contact_forces[3U * WHIPPLE_LEANING_WHEELS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_LEANING_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_LEANING_FORCES)) {
        whipple_leaning_f64_compute_contact_forces(motion, positions, speeds, forces,
            contact_forces);
        error = (carvallo_are_finite_f64(contact_forces, 3U * WHIPPLE_LEANING_WHEELS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
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

void whipple_leaning_f32_motion(const whipple_leaning_f32_t *p,
    whipple_leaning_f32_motion_t *motion)
{
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t31 = p->w + p->c;
    const float t34 = (cos_lam * t31) - (sin_lam * p->rR);
    const float t37 = (sin_lam * t31) + (cos_lam * p->rR);
    const float t38 = p->zP + p->rR;
    const float t39 = sin_lam * t38;
    const float t40 = cos_lam * t38;
    const float t41 = cos_lam * cos_lam;
    const float t42 = sin_lam * cos_lam;
    const float t43 = sin_lam * sin_lam;
    const float t44 = p->w - t31;
    const float t47 = (cos_lam * t44) + (sin_lam * p->rF);
    const float t50 = (sin_lam * t44) - (cos_lam * p->rF);
    const float t51 = t37 + t50;
    const float t53 = p->rR + p->zB;
    const float t55 = (cos_lam * p->xB) - (sin_lam * t53);
    const float t56 = p->mB * t55;
    const float t59 = (sin_lam * p->xB) + (cos_lam * t53);
    const float t60 = p->mB * t59;
    const float t62 = cos_lam * p->IBxz;
    const float t63 = (sin_lam * p->IBxx) + t62;
    const float t65 = sin_lam * p->IBxz;
    const float t67 = t65 + (cos_lam * p->IBzz);
    const float t71 = (cos_lam * t63) - (sin_lam * t67) - (t56 * t59);
    const float t73 = t59 * t60;
    const float t74 = t55 * t56;
    const float t76 = p->IByy + t73 + t74;
    const float t78 = p->mB + p->mR;
    const float t88 = t73 + p->IRxx + (cos_lam * ((cos_lam * p->IBxx) - t65)) - (sin_lam * (t62 -
        (sin_lam * p->IBzz)));
    const float t93 = t74 + p->IRxx + (sin_lam * t63) + (cos_lam * t67);
    const float t94 = p->mH + p->mF;
    const float t95 = p->xH - t31;
    const float t98 = (cos_lam * t95) - (sin_lam * p->zH);
    const float t99 = p->mH * t98;
    const float t100 = p->mF * t47;
    const float t101 = t99 + t100;
    const float t104 = (sin_lam * t95) + (cos_lam * p->zH);
    const float t105 = p->mH * t104;
    const float t106 = p->mF * t50;
    const float t107 = t105 + t106;
    const float t110 = sin_lam * p->IHxz;
    const float t113 = cos_lam * p->IHxz;
    const float t119 = (t104 * t105) + (t50 * t106);
    const float t122 = p->IFxx + (cos_lam * ((cos_lam * p->IHxx) - t110)) + t119 - (sin_lam *
        (t113 - (sin_lam * p->IHzz)));
    const float t124 = t113 + (sin_lam * p->IHxx);
    const float t127 = t110 + (cos_lam * p->IHzz);
    const float t133 = (cos_lam * t124) - (sin_lam * t127) - (t99 * t104) - (t50 * t100);
    const float t137 = (t98 * t99) + (t47 * t100);
    const float t139 = t119 + p->IHyy + t137;
    const float t144 = p->IFxx + t137 + (sin_lam * t124) + (cos_lam * t127);
    const float t146 = p->zU - p->zP;
    const float t148 = (cos_lam * p->xU) - (sin_lam * t146);
    const float t149 = p->mU * t148;
    const float t152 = (sin_lam * p->xU) + (cos_lam * t146);
    const float t153 = p->mU * t152;
    const float t155 = sin_lam * p->IUxz;
    const float t158 = cos_lam * p->IUxz;
    const float t162 = t152 * t153;
    const float t164 = (cos_lam * ((cos_lam * p->IUxx) - t155)) + t162 - (sin_lam * (t158 -
        (sin_lam * p->IUzz)));
    const float t166 = t158 + (sin_lam * p->IUxx);
    const float t169 = t155 + (cos_lam * p->IUzz);
    const float t173 = (cos_lam * t166) - (sin_lam * t169) - (t149 * t152);
    const float t175 = t148 * t149;
    const float t177 = t162 + p->IUyy + t175;
    const float t181 = t175 + (sin_lam * t166) + (cos_lam * t169);
    const float t183 = p->mU * t39;
    const float t184 = p->mU * t40;
    const float t185 = t40 * t184;
    const float t186 = t40 * t183;
    const float t187 = t39 * t183;
    const float t188 = t122 - t139;
    const float t189 = t34 * t94;
    const float t190 = t37 * t107;
    const float t191 = t37 * t94;
    const float t194 = t190 + t190 + (t37 * t191);
    const float t195 = t34 * t107;
    const float t196 = t37 * t189;
    const float t197 = t34 * t189;
    const float t198 = t107 + t191;
    const float t201 = p->rR * (p->mU + t78 + t94);
    const float t202 = p->rR * t201;
    const float t205 = (sin_lam * t149) - (cos_lam * t153);
    const float t208 = (cos_lam * t164) + (sin_lam * t173);
    const float t211 = (cos_lam * t173) + (sin_lam * t181);
    const float t214 = (cos_lam * t208) + (sin_lam * t211);
    motion->constants[0] = p->w;
    motion->constants[1] = p->c;
    motion->constants[2] = sin_lam;
    motion->constants[3] = cos_lam;
    motion->constants[4] = p->zP;
    motion->constants[5] = p->kU;
    motion->constants[6] = p->dU;
    motion->constants[7] = p->rR;
    motion->constants[8] = p->rF;
    motion->constants[9] = p->IBxx;
    motion->constants[10] = p->IBxz;
    motion->constants[11] = p->IBzz;
    motion->constants[12] = p->mB;
    motion->constants[13] = p->xB;
    motion->constants[14] = p->zB;
    motion->constants[15] = p->IHxx;
    motion->constants[16] = p->IHxz;
    motion->constants[17] = p->IHzz;
    motion->constants[18] = p->mH;
    motion->constants[19] = p->xH;
    motion->constants[20] = p->zH;
    motion->constants[21] = p->IUxx;
    motion->constants[22] = p->IUxz;
    motion->constants[23] = p->IUzz;
    motion->constants[24] = p->mU;
    motion->constants[25] = p->xU;
    motion->constants[26] = p->zU;
    motion->constants[27] = p->IRyy;
    motion->constants[28] = p->IFyy;
    motion->constants[29] = p->mF;
    motion->constants[30] = t34;
    motion->constants[31] = t37;
    motion->constants[32] = t39;
    motion->constants[33] = t40;
    motion->constants[34] = t41;
    motion->constants[35] = t42;
    motion->constants[36] = t43;
    motion->constants[37] = t47;
    motion->constants[38] = t50;
    motion->constants[39] = t51;
    motion->constants[40] = t56;
    motion->constants[41] = t60;
    motion->constants[42] = t71;
    motion->constants[43] = t76;
    motion->constants[44] = t78;
    motion->constants[45] = t88;
    motion->constants[46] = t93;
    motion->constants[47] = t94;
    motion->constants[48] = t101;
    motion->constants[49] = t107;
    motion->constants[50] = t122;
    motion->constants[51] = t133;
    motion->constants[52] = t139;
    motion->constants[53] = t144;
    motion->constants[54] = t149;
    motion->constants[55] = t153;
    motion->constants[56] = t164;
    motion->constants[57] = t173;
    motion->constants[58] = t177;
    motion->constants[59] = t181;
    motion->constants[60] = p->g;
    motion->constants[61] = t183;
    motion->constants[62] = t184;
    motion->constants[63] = t185;
    motion->constants[64] = t186;
    motion->constants[65] = t187;
    motion->constants[66] = t188;
    motion->constants[67] = t189;
    motion->constants[68] = t194;
    motion->constants[69] = t195;
    motion->constants[70] = t196;
    motion->constants[71] = t197;
    motion->constants[72] = t198;
    motion->constants[73] = t201;
    motion->constants[74] = t202;
    motion->constants[75] = t205;
    motion->constants[76] = t208;
    motion->constants[77] = t211;
    motion->constants[78] = t214;
    motion->constants[79] = t202;
}

static void whipple_leaning_f32_compute_rates(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    float rates[WHIPPLE_LEANING_POSITIONS])
{
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t13 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t17 = t13 * cos_phi;
    const float t21 = (sin_phi * sin_delta) - (cos_delta * t17);
    const float t25 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const float t26 = cos_phi * t25;
    const float t29 = sqrtf((t21 * t21) + (t26 * t26));
    const float t30 = 1.0F / t29;
    const float t31 = t21 * t30;
    const float t33 = t26 * t30;
    const float t34 = cos_delta * t33;
    const float t36 = (t25 * t34) - (t13 * t31);
    const float t41 = motion->constants[8] * ((sin_phi * cos_delta) + (t17 * sin_delta));
    const float t44 = sin_delta * motion->constants[37];
    const float t50 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const float t52 = (t25 * motion->constants[39]) - (t13 * t50);
    const float t55 = (cos_phi * t44) - (t36 * t41) - (sin_phi * t52);
    const float t56 = (motion->constants[7] * sin_phi) + t55;
    const float t63 = (cos_phi * sin_delta * t33) + (sin_phi * ((t25 * t31) + (t13 * t34)));
    const float t68 = (t41 * t63) + (t13 * motion->constants[39]) + (t25 * t50);
    const float t70 = 1.0F / (cos_phi * t68);
    const float t71 = t56 * t70;
    const float t77 = (t25 * motion->constants[31]) - (t13 * motion->constants[30]);
    const float t79 = t55 + (sin_phi * t77);
    const float t81 = sin_phi * t25;
    const float t85 = t68 - (t13 * motion->constants[31]) - (t25 * motion->constants[30]);
    const float t88 = t70 * ((t13 * t79) + (t81 * t85));
    const float t90 = (speeds[0] * t71) + (speeds[1] * t88);
    const float t92 = motion->constants[7] * (speeds[3] + t90);
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t98 = sin_phi * t68;
    const float t100 = sin_phi * t56;
    const float t102 = (t36 * t98) + (t63 * t100);
    const float t106 = 1.0F / ((t36 * t68) + (t56 * t63));
    const float t108 = t71 * t102 * t106;
    const float t117 = (t29 * motion->constants[8]) + (sin_phi * t44) + (cos_phi * t52) - (cos_phi *
        t77);
    const float t119 = (t26 * t85) - (t13 * t117);
    const float t123 = (t81 * t117) + (t26 * t79);
    const float t128 = t106 * ((t36 * t119) + (t63 * t123) + (t88 * t102));
    const float t131 = motion->constants[7] * t63 * t106;
    const float t138 = (t63 * t98) - (t36 * t100);
    const float t142 = (t63 * t68) - (t36 * t56);
    const float t145 = 1.0F / motion->constants[8];
    const float t162 = (speeds[0] * ((t108 * t142) - (t71 * t138)) * t145) + (speeds[1] * t145 *
        ((t36 * t123) + (t128 * t142) - (t63 * t119) - (t88 * t138)));
    const float t163 = t162 + (speeds[3] * t145 * ((motion->constants[7] * t36) + (t131 * t142)));
    const float t164 = -(t92 * cos_psi);
    const float t165 = -(t92 * sin_psi);
    const float t166 = -((speeds[0] * t108) + (speeds[1] * t128) + (speeds[3] * t131));
    rates[0] = t164;
    rates[1] = t165;
    rates[2] = t166;
    rates[3] = speeds[0];
    rates[4] = t90;
    rates[5] = speeds[1];
    rates[6] = speeds[2];
    rates[7] = speeds[3];
    rates[8] = t163;
}

carvallo_motion_error_t whipple_leaning_f32_motion_rates(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    float rates[WHIPPLE_LEANING_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_LEANING_SPEEDS)) {
        whipple_leaning_f32_compute_rates(motion, positions, speeds, rates);
        error = (carvallo_are_finite_f32(rates, WHIPPLE_LEANING_POSITIONS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_leaning_f32_compute_derivatives(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    const float forces[WHIPPLE_LEANING_FORCES], float rates[WHIPPLE_LEANING_POSITIONS],
    float speed_rates[WHIPPLE_LEANING_SPEEDS])
{
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t13 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t17 = t13 * cos_phi;
    const float t21 = (sin_phi * sin_delta) - (cos_delta * t17);
    const float t25 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const float t26 = cos_phi * t25;
    const float t29 = sqrtf((t21 * t21) + (t26 * t26));
    const float t30 = 1.0F / t29;
    const float t31 = t21 * t30;
    const float t33 = t26 * t30;
    const float t34 = cos_delta * t33;
    const float t36 = (t25 * t34) - (t13 * t31);
    const float t40 = (sin_phi * cos_delta) + (t17 * sin_delta);
    const float t41 = motion->constants[8] * t40;
    const float t44 = sin_delta * motion->constants[37];
    const float t50 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const float t52 = (t25 * motion->constants[39]) - (t13 * t50);
    const float t55 = (cos_phi * t44) - (t36 * t41) - (sin_phi * t52);
    const float t56 = (motion->constants[7] * sin_phi) + t55;
    const float t63 = (cos_phi * sin_delta * t33) + (sin_phi * ((t25 * t31) + (t13 * t34)));
    const float t68 = (t41 * t63) + (t13 * motion->constants[39]) + (t25 * t50);
    const float t70 = 1.0F / (cos_phi * t68);
    const float t71 = t56 * t70;
    const float t77 = (t25 * motion->constants[31]) - (t13 * motion->constants[30]);
    const float t79 = t55 + (sin_phi * t77);
    const float t81 = sin_phi * t25;
    const float t85 = t68 - (t13 * motion->constants[31]) - (t25 * motion->constants[30]);
    const float t88 = t70 * ((t13 * t79) + (t81 * t85));
    const float t90 = (speeds[0] * t71) + (speeds[1] * t88);
    const float t91 = speeds[3] + t90;
    const float t92 = motion->constants[7] * t91;
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t98 = sin_phi * t68;
    const float t100 = sin_phi * t56;
    const float t102 = (t36 * t98) + (t63 * t100);
    const float t106 = 1.0F / ((t36 * t68) + (t56 * t63));
    const float t108 = t71 * t102 * t106;
    const float t117 = (t29 * motion->constants[8]) + (sin_phi * t44) + (cos_phi * t52) - (cos_phi *
        t77);
    const float t119 = (t26 * t85) - (t13 * t117);
    const float t123 = (t81 * t117) + (t26 * t79);
    const float t128 = t106 * ((t36 * t119) + (t63 * t123) + (t88 * t102));
    const float t131 = motion->constants[7] * t63 * t106;
    const float t134 = (speeds[0] * t108) + (speeds[1] * t128) + (speeds[3] * t131);
    const float t138 = (t63 * t98) - (t36 * t100);
    const float t142 = (t63 * t68) - (t36 * t56);
    const float t145 = 1.0F / motion->constants[8];
    const float t146 = ((t108 * t142) - (t71 * t138)) * t145;
    const float t155 = t145 * ((t36 * t123) + (t128 * t142) - (t63 * t119) - (t88 * t138));
    const float t160 = t145 * ((motion->constants[7] * t36) + (t131 * t142));
    const float t163 = (speeds[0] * t146) + (speeds[1] * t155) + (speeds[3] * t160);
    const float t166 = cos_phi * t134;
    const float t168 = sin_phi * t134;
    const float t169 = motion->constants[7] * t168;
    const float t171 = (t166 * t169) - (t92 * t166);
    const float t174 = t171 + (sin_phi * motion->constants[60]);
    const float t179 = (speeds[0] * t13) - (t25 * t166);
    const float t180 = t90 * t179;
    const float t181 = speeds[0] * t168;
    const float t182 = t90 - t168;
    const float t183 = motion->constants[31] * t182;
    const float t187 = (speeds[0] * t25) + (t13 * t166);
    const float t188 = motion->constants[30] * t182;
    const float t190 = (t179 * t183) + (t187 * t188);
    const float t192 = t90 * t187;
    const float t193 = (t25 * t181) + t192;
    const float t196 = t180 + (t13 * t181);
    const float t200 = t190 + (motion->constants[30] * t193) + (motion->constants[31] * t196) -
        t171;
    const float t205 = (motion->constants[30] * t179) - (motion->constants[31] * t187);
    const float t207 = (t182 * t188) + (t179 * t205);
    const float t208 = speeds[0] * t166;
    const float t211 = motion->constants[7] * speeds[0];
    const float t212 = t166 * t211;
    const float t213 = (motion->constants[7] * t208) + t212;
    const float t218 = (t169 * (t91 - t168)) - (speeds[0] * t211);
    const float t222 = (t25 * t213) + (t13 * t218) - t207 - (motion->constants[31] * t208);
    const float t224 = speeds[1] + t179;
    const float t228 = (cos_delta * t182) - (sin_delta * t187);
    const float t229 = motion->constants[38] * t228;
    const float t233 = (cos_delta * t187) + (sin_delta * t182);
    const float t234 = motion->constants[37] * t228;
    const float t239 = speeds[1] * t228;
    const float t241 = t239 - (cos_delta * t196) - (sin_delta * t208);
    const float t243 = t31 * motion->constants[8];
    const float t247 = t33 * motion->constants[8];
    const float t255 = t30 * t40 * ((t31 * t233) + (t33 * t224));
    const float t256 = t247 * t255;
    const float t258 = t243 * t255;
    const float t264 = (cos_delta * t200) + (t224 * t229) + (t233 * t234) + (motion->constants[37] *
        t193) + (t243 * (t193 + (t163 * t233))) + (t224 * t256);
    const float t268 = t264 + (t233 * t258) - (sin_delta * t222) - (motion->constants[38] * t241) -
        (t247 * (t241 - (t163 * t224)));
    const float t275 = (motion->constants[37] * t224) - (motion->constants[38] * t233);
    const float t279 = speeds[1] * t233;
    const float t281 = (sin_delta * t196) - (cos_delta * t208) - t279;
    const float t284 = t163 + t228;
    const float t289 = motion->constants[8] * ((t31 * t224) - (t33 * t233));
    const float t295 = (cos_delta * t222) + (sin_delta * t200) + (motion->constants[38] * t281) +
        (t247 * t281) - (t228 * t234) - (t224 * t275);
    const float t297 = t295 - (t258 * t284) - (t224 * t289);
    const float t301 = (t187 * t205) - (t182 * t183);
    const float t315 = t301 + (motion->constants[30] * t208) + (t13 * t213) + (t233 * t275) +
        (t233 * t289) - (t25 * t218);
    const float t319 = t315 - (t228 * t229) - (motion->constants[37] * t281) - (t243 * t281) -
        (t256 * t284);
    const float t321 = (t31 * t297) + (t33 * t319);
    const float t326 = t70 * ((t40 * t268) + (t29 * t321));
    const float t330 = t106 * ((t29 * t268) + (t102 * t326) - (t40 * t321));
    const float t332 = t181 - (cos_phi * t330);
    const float t334 = t180 + (t13 * t332);
    const float t338 = t192 + (t25 * t332);
    const float t345 = (t182 * motion->constants[43]) + (motion->constants[27] * (speeds[3] +
        t182));
    const float t350 = (t187 * motion->constants[45]) + (motion->constants[42] * t179);
    const float t357 = t190 + (motion->constants[30] * t338) + (motion->constants[31] * t334) -
        t174;
    const float t361 = t326 - t208 - (sin_phi * t330);
    const float t364 = (motion->constants[7] * t361) - t212;
    const float t367 = t218 + (cos_phi * motion->constants[60]);
    const float t369 = (t13 * t367) - (t25 * t364);
    const float t371 = (motion->constants[31] * t361) + t369 - t207;
    const float t373 = (cos_delta * t357) - (sin_delta * t371);
    const float t379 = t239 + (sin_delta * t361) - (cos_delta * t334);
    const float t387 = (t228 * motion->constants[52]) + (t284 * motion->constants[28]);
    const float t392 = (t233 * motion->constants[50]) + (t224 * motion->constants[51]);
    const float t397 = (motion->constants[48] * t373) + (motion->constants[51] * t379) + (t338 *
        motion->constants[53]) + (t233 * t387) - (t228 * t392);
    float sin_theta = 0.0F;
    float cos_theta = 0.0F;
    carvallo_sin_cos_f32(positions[6], &sin_theta, &cos_theta);
    const float t401 = 1.0F - cos_theta;
    const float t403 = t401 * motion->constants[35];
    const float t406 = motion->constants[2] * sin_theta;
    const float t408 = t182 * motion->constants[32];
    const float t413 = (t179 * motion->constants[32]) + (t187 * motion->constants[33]);
    const float t418 = t369 + (t182 * t408) + (t179 * t413) + (t361 * motion->constants[33]);
    const float t420 = t182 * motion->constants[33];
    const float t428 = (t179 * t420) + (t334 * motion->constants[33]) - t174 - (t187 * t408) -
        (t338 * motion->constants[32]);
    const float t430 = motion->constants[3] * sin_theta;
    const float t436 = (t25 * t367) + (t13 * t364);
    const float t439 = (t361 * motion->constants[32]) - (t187 * t413) - (t182 * t420) - t436;
    const float t442 = (cos_theta * t428) + (t430 * t439) - (t406 * t418);
    const float t449 = (t182 * cos_theta) + (t179 * t430) - (t187 * t406);
    const float t450 = motion->constants[2] * speeds[2];
    const float t454 = cos_theta + (t401 * motion->constants[34]);
    const float t460 = (t449 * t450) + (t361 * t406) + (t338 * t403) - (t334 * t454);
    const float t463 = motion->constants[3] * speeds[2];
    const float t469 = cos_theta + (t401 * motion->constants[36]);
    const float t473 = (t338 * t469) - (t449 * t463) - (t334 * t403) - (t361 * t430);
    const float t480 = t463 + (t187 * t454) + (t182 * t406) + (t179 * t403);
    const float t487 = t450 + (t187 * t403) + (t179 * t469) - (t182 * t430);
    const float t490 = (motion->constants[57] * t480) + (t487 * motion->constants[59]);
    const float t493 = t449 * motion->constants[58];
    const float t498 = (motion->constants[56] * t460) + (motion->constants[57] * t473) + (t449 *
        t490) - (motion->constants[55] * t442) - (t487 * t493);
    const float t504 = (t418 * t454) + (t406 * t428) + (t403 * t439);
    const float t511 = (t403 * t418) + (t439 * t469) - (t428 * t430);
    const float t522 = (speeds[2] * ((motion->constants[3] * t487) - (motion->constants[2] *
        t480))) + (t334 * t406) + (t361 * cos_theta) + (t338 * t430);
    const float t526 = (motion->constants[56] * t480) + (motion->constants[57] * t487);
    const float t532 = (motion->constants[55] * t504) + (motion->constants[58] * t522) + (t487 *
        t526) - (motion->constants[54] * t511) - (t480 * t490);
    const float t542 = (t442 * motion->constants[54]) + (t460 * motion->constants[57]) + (t473 *
        motion->constants[59]) + (t480 * t493) - (t449 * t526);
    const float t547 = t449 * motion->constants[54];
    const float t551 = (t487 * motion->constants[54]) - (motion->constants[55] * t480);
    const float t555 = (t504 * motion->constants[24]) + (motion->constants[55] * t522) - (t449 *
        t547) - (t487 * t551);
    const float t560 = motion->constants[55] * t449;
    const float t566 = (t442 * motion->constants[24]) + (t473 * motion->constants[54]) + (t487 *
        t560) + (t480 * t547) - (motion->constants[55] * t460);
    const float t574 = (t511 * motion->constants[24]) + (t480 * t551) - (motion->constants[54] *
        t522) - (t449 * t560);
    const float t577 = (t406 * t555) + (cos_theta * t566) - (t430 * t574);
    const float t582 = (cos_delta * t371) + (sin_delta * t357);
    const float t588 = (cos_delta * t361) + (sin_delta * t334) - t279;
    const float t590 = t228 * motion->constants[48];
    const float t594 = (t224 * motion->constants[48]) - (t233 * motion->constants[49]);
    const float t598 = (motion->constants[47] * t582) + (motion->constants[49] * t588) - (t228 *
        t590) - (t224 * t594);
    const float t603 = t228 * motion->constants[49];
    const float t609 = (t373 * motion->constants[47]) + (t338 * motion->constants[48]) + (t224 *
        t603) + (t233 * t590) - (t379 * motion->constants[49]);
    const float t611 = (sin_delta * t598) + (cos_delta * t609);
    const float t617 = (motion->constants[46] * t338) + (t187 * t345) + t397 + (t403 * t498) +
        (t430 * t532) + (t469 * t542);
    const float t622 = t617 + (motion->constants[30] * t611) - (motion->constants[40] * t174) -
        (motion->constants[42] * t334) - (t182 * t350) - (motion->constants[32] * t577);
    const float t630 = (motion->constants[42] * t187) + (t179 * motion->constants[46]);
    const float t642 = (t233 * motion->constants[51]) + (t224 * motion->constants[53]);
    const float t648 = (t379 * motion->constants[50]) + (t338 * motion->constants[51]) + (t228 *
        t642) - (t373 * motion->constants[49]) - (t224 * t387);
    const float t653 = t301 - t436 - (motion->constants[30] * t361);
    const float t664 = t588 + (t145 * ((t31 * t319) + (t142 * t330) - (t33 * t297) - (t138 *
        t326)));
    const float t665 = motion->constants[28] * t664;
    const float t672 = (t582 * motion->constants[49]) + (motion->constants[52] * t588) + t665 +
        (t224 * t392) - (motion->constants[48] * t653) - (t233 * t642);
    const float t679 = (t174 * motion->constants[41]) + (motion->constants[42] * t338) + (t182 *
        t630) + (t454 * t498) + (t403 * t542) + (cos_delta * t648);
    const float t684 = t679 - (t334 * motion->constants[45]) - (t179 * t345) - (t406 * t532) -
        (motion->constants[33] * t577) - (sin_delta * t672);
    const float t685 = t684 - (motion->constants[31] * t611);
    const float t691 = t182 * motion->constants[41];
    const float t693 = motion->constants[40] * t182;
    const float t700 = t577 + t611 + (motion->constants[40] * t338) + (t334 *
        motion->constants[41]) + (t179 * t691) + (t187 * t693) - (t174 * motion->constants[44]);
    const float t703 = t71 - (sin_phi * t108);
    const float t716 = (t454 * t555) + (t403 * t574) - (t406 * t566);
    const float t722 = (t403 * t555) + (t430 * t566) + (t469 * t574);
    const float t728 = (cos_delta * t598) - (sin_delta * t609);
    const float t736 = (motion->constants[47] * t653) + (t233 * t594) - (motion->constants[48] *
        t588) - (t228 * t603);
    const float t743 = (motion->constants[40] * t179) - (t187 * motion->constants[41]);
    const float t751 = t13 * (t722 + t736 + (t187 * t743) - (t436 * motion->constants[44]) -
        (motion->constants[40] * t361) - (t182 * t691));
    const float t761 = t25 * (t716 + t728 + (t369 * motion->constants[44]) + (t361 *
        motion->constants[41]) - (t182 * t693) - (t179 * t743));
    const float t764 = (motion->constants[27] * t361) - (motion->constants[7] * (t751 + t761));
    const float t769 = (t369 * motion->constants[41]) + (motion->constants[40] * t436) +
        (motion->constants[43] * t361) + (t179 * t350) + (t406 * t498) + (cos_theta * t532);
    const float t774 = t769 + (motion->constants[33] * t716) + (motion->constants[32] * t722) +
        (sin_delta * t648) + (cos_delta * t672) + (motion->constants[31] * t728);
    const float t778 = t774 + t764 - (t187 * t630) - (t430 * t542) - (motion->constants[30] * t736);
    const float t780 = cos_phi * t108;
    const float t783 = (t25 * t622) - (t13 * t685);
    const float t790 = forces[0] + (t780 * t783) - (t13 * t622) - (t25 * t685) -
        (motion->constants[7] * t700) - (t703 * t778);
    const float t791 = t790 - (t146 * t665);
    const float t793 = t403 * motion->constants[57];
    const float t803 = sin_delta * motion->constants[66];
    const float t804 = sin_delta * t803;
    const float t807 = (t403 * motion->constants[54]) + (motion->constants[55] * t469);
    const float t808 = motion->constants[33] * t807;
    const float t813 = t808 + t808 + motion->constants[63] + motion->constants[68];
    const float t817 = motion->constants[45] + motion->constants[50] + (t454 *
        ((motion->constants[56] * t454) + t793)) + (t406 * t406 * motion->constants[58]) + (t403 *
        ((t454 * motion->constants[57]) + (t403 * motion->constants[59])));
    const float t819 = t817 + t813 - t804;
    const float t822 = (t403 * motion->constants[56]) + (motion->constants[57] * t469);
    const float t824 = t430 * motion->constants[58];
    const float t827 = t793 + (t469 * motion->constants[59]);
    const float t833 = (t454 * motion->constants[54]) + (t403 * motion->constants[55]);
    const float t835 = cos_delta * motion->constants[48];
    const float t836 = motion->constants[30] * t835;
    const float t837 = (motion->constants[32] * t833) - t836;
    const float t840 = motion->constants[65] + motion->constants[71] - t837 - t837;
    const float t845 = motion->constants[46] + motion->constants[53] + (t403 * t822) + (t430 *
        t824) + (t469 * t827) + t840;
    const float t846 = t845 - t819;
    const float t847 = t13 * t13;
    const float t849 = t13 * t25;
    const float t860 = (cos_delta * motion->constants[51]) - (motion->constants[31] * t835);
    const float t865 = motion->constants[42] + (t454 * t822) + (t403 * t827) +
        (motion->constants[32] * t807) + motion->constants[64] + t860;
    const float t869 = t865 - (t406 * t824) - (motion->constants[33] * t833) -
        motion->constants[69] - motion->constants[70];
    const float t870 = t869 + t869;
    const float t872 = (t846 * t847) + (t849 * t870);
    const float t877 = motion->constants[41] + t807 + motion->constants[62] + motion->constants[72];
    const float t884 = motion->constants[40] + t833 + t835 + motion->constants[67] -
        motion->constants[61];
    const float t886 = (t25 * t877) - (t13 * t884);
    const float t887 = motion->constants[7] * t886;
    const float t890 = motion->constants[74] - t887 - t887;
    const float t896 = (t406 * motion->constants[54]) - (motion->constants[55] * t430);
    const float t899 = sin_delta * motion->constants[48];
    const float t901 = (sin_delta * motion->constants[51]) - (motion->constants[31] * t899);
    const float t905 = (t406 * t822) + (cos_theta * t824) + t901 - (t430 * t827) -
        (motion->constants[33] * t896);
    const float t909 = (t406 * motion->constants[56]) - (t430 * motion->constants[57]);
    const float t911 = cos_theta * motion->constants[58];
    const float t915 = (t406 * motion->constants[57]) - (t430 * motion->constants[59]);
    const float t924 = (t454 * t909) + (t403 * t915) + (motion->constants[32] * t896) + (cos_delta *
        t803) - (t406 * t911) - (motion->constants[30] * t899);
    const float t926 = (t13 * t905) + (t25 * t924);
    const float t936 = t869 + (t846 * t849) + (motion->constants[7] * ((t13 * t877) + (t25 *
        t884))) - (t847 * t870);
    const float t946 = motion->constants[43] + motion->constants[52] + t804 + t813 + t840 + t890 +
        (t406 * t909);
    const float t948 = t946 + (cos_theta * t911) - (t430 * t915);
    const float t953 = motion->constants[7] * (t896 + t899);
    const float t955 = (t25 * t905) + t953 - (t13 * t924);
    const float t961 = t845 - t872;
    const float t966 = motion->constants[27] * t703;
    const float t970 = t13 * sin_delta;
    const float t974 = t146 + (cos_delta * t703) - (sin_delta * t25) - (t780 * t970);
    const float t975 = motion->constants[28] * t974;
    const float t981 = t819 + t872 + t890 + (t703 * t926) + (t703 * (t926 + (t703 * t948) - (t780 *
        t955))) + (t703 * t966);
    const float t984 = t981 + (t974 * t975) - (t780 * t936) - (t780 * (t936 + (t703 * t955) -
        (t780 * t961)));
    const float t985 = 1.0F / t984;
    const float t987 = motion->constants[53] + t836;
    const float t992 = t88 - (sin_phi * t128);
    const float t994 = cos_phi * t128;
    const float t997 = motion->constants[7] * t25 * t899;
    const float t998 = t901 + t997;
    const float t1002 = t998 + (t948 * t992) - (t955 * t994);
    const float t1006 = (t25 * t987) - (t13 * t860);
    const float t1010 = t1006 + (t955 * t992) - (t961 * t994);
    const float t1016 = t155 + (cos_delta * t992) - (t970 * t994);
    const float t1022 = (t13 * t987) + (t25 * t860) + (motion->constants[7] * t835) + (t926 *
        t992) + (t703 * t1002) + (t966 * t992);
    const float t1026 = t985 * (t1022 + (t975 * t1016) - (t936 * t994) - (t780 * t1010));
    const float t1031 = motion->constants[27] * t992;
    const float t1033 = motion->constants[28] * t1016;
    const float t1035 = t984 * t1026;
    const float t1041 = motion->constants[53] + (t992 * t1002) + (t992 * t998) + (t992 * t1031) +
        (t1016 * t1033) - (t994 * t1010);
    const float t1043 = t1041 - (t994 * t1006) - (t1026 * t1035);
    const float t1044 = 1.0F / t1043;
    const float t1054 = forces[1] + (t783 * t994) - t397 - (t778 * t992) - (t155 * t665) - (t791 *
        t1026);
    const float t1061 = t406 * motion->constants[75];
    const float t1063 = t430 * motion->constants[75];
    const float t1068 = motion->constants[7] * ((t13 * t1063) - (t25 * t1061));
    const float t1072 = (t406 * motion->constants[76]) + (motion->constants[32] * t1063) - (t430 *
        motion->constants[77]) - (motion->constants[33] * t1061) - t1068;
    const float t1076 = cos_theta * motion->constants[75];
    const float t1079 = (t403 * motion->constants[76]) + (t469 * motion->constants[77]) -
        (motion->constants[32] * t1076);
    const float t1085 = (t454 * motion->constants[76]) + (t403 * motion->constants[77]) -
        (motion->constants[33] * t1076);
    const float t1087 = (t25 * t1079) - (t13 * t1085);
    const float t1098 = t985 * ((t13 * t1079) + (t25 * t1085) + (motion->constants[7] * t1076) +
        (t703 * t1072) - (t780 * t1087));
    const float t1102 = t1044 * ((t992 * t1072) - (t994 * t1087) - (t1035 * t1098));
    const float t1104 = t984 * t1098;
    const float t1106 = t1043 * t1102;
    const float t1109 = motion->constants[78] - (t1098 * t1104) - (t1102 * t1106);
    const float t1110 = 1.0F / t1109;
    const float t1124 = forces[2] - (motion->constants[3] * t498) - (motion->constants[2] * t542) -
        (positions[6] * motion->constants[5]) - (speeds[2] * motion->constants[6]) - (t791 * t1098);
    const float t1125 = t1124 - (t1054 * t1102);
    const float t1127 = sin_phi * t131;
    const float t1129 = cos_phi * t131;
    const float t1135 = motion->constants[7] * (t886 - motion->constants[73]);
    const float t1139 = t1135 + (t948 * t1127) + (t955 * t1129);
    const float t1144 = t953 - (t955 * t1127) - (t961 * t1129);
    const float t1146 = 1.0F - t1127;
    const float t1151 = t160 - (cos_delta * t1127) - (t970 * t1129);
    const float t1157 = (t966 * t1146) + (t975 * t1151) - (t926 * t1127) - (t936 * t1129) - (t703 *
        t1139) - (t780 * t1144);
    const float t1158 = t985 * t1157;
    const float t1171 = t997 + (t1031 * t1146) + (t1033 * t1151) - (t992 * t1139) - (t994 * t1144) -
        (t998 * t1127);
    const float t1174 = t1044 * (t1171 - (t1006 * t1129) - (t1035 * t1158));
    const float t1180 = t1110 * (t1068 + (t1072 * t1127) + (t1087 * t1129) + (t1104 * t1158) +
        (t1106 * t1174));
    const float t1191 = (t778 * t1127) + (t783 * t1129) + (t1125 * t1180) - t764 - (t160 * t665) -
        (t791 * t1158);
    const float t1212 = (t1127 * t1139) + (t1127 * t1135) + motion->constants[79] +
        (motion->constants[27] * t1146 * t1146) + (motion->constants[28] * t1151 * t1151) - (t1129 *
        t1144);
    const float t1217 = (t1191 - (t1054 * t1174)) / (t1212 - (t953 * t1129) - (t984 * t1158 *
        t1158) - (t1043 * t1174 * t1174) - (t1109 * t1180 * t1180));
    const float t1219 = (t1110 * t1125) + (t1180 * t1217);
    const float t1223 = (t1044 * t1054) - (t1102 * t1219) - (t1174 * t1217);
    const float t1229 = (t791 * t985) - (t1026 * t1223) - (t1098 * t1219) - (t1158 * t1217);
    const float t1230 = -(t92 * cos_psi);
    const float t1231 = -(t92 * sin_psi);
    const float t1232 = -t134;
    rates[0] = t1230;
    rates[1] = t1231;
    rates[2] = t1232;
    rates[3] = speeds[0];
    rates[4] = t90;
    rates[5] = speeds[1];
    rates[6] = speeds[2];
    rates[7] = speeds[3];
    rates[8] = t163;
    speed_rates[0] = t1229;
    speed_rates[1] = t1223;
    speed_rates[2] = t1219;
    speed_rates[3] = t1217;
}

carvallo_motion_error_t whipple_leaning_f32_motion_derivatives(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    const float forces[WHIPPLE_LEANING_FORCES], float rates[WHIPPLE_LEANING_POSITIONS],
    float speed_rates[WHIPPLE_LEANING_SPEEDS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_LEANING_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_LEANING_FORCES)) {
        whipple_leaning_f32_compute_derivatives(motion, positions, speeds, forces, rates,
            speed_rates);
        error = (carvallo_are_finite_f32(rates, WHIPPLE_LEANING_POSITIONS) &&
            carvallo_are_finite_f32(speed_rates, WHIPPLE_LEANING_SPEEDS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_leaning_f32_compute_accelerations(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    const float forces[WHIPPLE_LEANING_FORCES], float accelerations[WHIPPLE_LEANING_POSITIONS])
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
    const float t13 = (motion->constants[3] * sin_pitch) + (cos_pitch * motion->constants[2]);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t16 = cos_phi * t13;
    const float t21 = (sin_phi * sin_delta) - (cos_delta * t16);
    const float t25 = (motion->constants[3] * cos_pitch) - (motion->constants[2] * sin_pitch);
    const float t26 = cos_phi * t25;
    const float t29 = sqrtf((t21 * t21) + (t26 * t26));
    const float t30 = 1.0F / t29;
    const float t31 = t21 * t30;
    const float t33 = t26 * t30;
    const float t34 = cos_delta * t33;
    const float t36 = (t25 * t34) - (t13 * t31);
    const float t43 = (cos_phi * sin_delta * t33) + (sin_phi * ((t25 * t31) + (t13 * t34)));
    const float t47 = (sin_phi * cos_delta) + (sin_delta * t16);
    const float t48 = motion->constants[8] * t47;
    const float t55 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const float t58 = (t43 * t48) + (t13 * motion->constants[39]) + (t25 * t55);
    const float t62 = sin_delta * motion->constants[37];
    const float t66 = (t25 * motion->constants[39]) - (t13 * t55);
    const float t69 = (cos_phi * t62) - (t36 * t48) - (sin_phi * t66);
    const float t70 = (motion->constants[7] * sin_phi) + t69;
    const float t73 = 1.0F / ((t36 * t58) + (t43 * t70));
    const float t74 = sin_phi * t58;
    const float t76 = sin_phi * t70;
    const float t78 = (t36 * t74) + (t43 * t76);
    const float t80 = 1.0F / (cos_phi * t58);
    const float t81 = t70 * t80;
    const float t83 = t73 * t78 * t81;
    const float t90 = t58 - (t13 * motion->constants[31]) - (t25 * motion->constants[30]);
    const float t97 = (t25 * motion->constants[31]) - (t13 * motion->constants[30]);
    const float t101 = (t29 * motion->constants[8]) + (sin_phi * t62) + (cos_phi * t66) - (cos_phi *
        t97);
    const float t103 = (t26 * t90) - (t13 * t101);
    const float t105 = sin_phi * t25;
    const float t108 = t69 + (sin_phi * t97);
    const float t110 = (t101 * t105) + (t26 * t108);
    const float t115 = t80 * ((t13 * t108) + (t90 * t105));
    const float t119 = t73 * ((t36 * t103) + (t43 * t110) + (t78 * t115));
    const float t122 = motion->constants[7] * t43 * t73;
    const float t126 = (speeds[0] * t83) + (speeds[1] * t119) + (t122 * speeds[3]);
    const float t127 = cos_phi * t126;
    const float t128 = speeds[0] * t127;
    const float t131 = (t13 * speeds[0]) - (t25 * t127);
    const float t134 = (speeds[0] * t81) + (speeds[1] * t115);
    const float t135 = sin_phi * t126;
    const float t136 = t134 - t135;
    const float t137 = motion->constants[31] * t136;
    const float t141 = (t25 * speeds[0]) + (t13 * t127);
    const float t142 = motion->constants[30] * t136;
    const float t144 = (t131 * t137) + (t141 * t142);
    const float t145 = speeds[0] * t135;
    const float t147 = t134 * t141;
    const float t148 = (t25 * t145) + t147;
    const float t151 = t131 * t134;
    const float t152 = (t13 * t145) + t151;
    const float t154 = speeds[3] + t134;
    const float t155 = motion->constants[7] * t154;
    const float t157 = motion->constants[7] * t135;
    const float t159 = (t127 * t157) - (t127 * t155);
    const float t162 = t144 + (motion->constants[30] * t148) + (motion->constants[31] * t152) -
        t159;
    const float t167 = (motion->constants[30] * t131) - (motion->constants[31] * t141);
    const float t169 = (t136 * t142) + (t131 * t167);
    const float t171 = motion->constants[7] * speeds[0];
    const float t172 = t127 * t171;
    const float t174 = t172 + (motion->constants[7] * t128);
    const float t179 = (t157 * (t154 - t135)) - (speeds[0] * t171);
    const float t183 = (t25 * t174) + (t13 * t179) - t169 - (motion->constants[31] * t128);
    const float t185 = speeds[1] + t131;
    const float t189 = (cos_delta * t136) - (sin_delta * t141);
    const float t190 = motion->constants[38] * t189;
    const float t194 = (cos_delta * t141) + (sin_delta * t136);
    const float t195 = motion->constants[37] * t189;
    const float t200 = speeds[1] * t189;
    const float t202 = t200 - (cos_delta * t152) - (sin_delta * t128);
    const float t204 = t31 * motion->constants[8];
    const float t207 = (t43 * t74) - (t36 * t76);
    const float t211 = (t43 * t58) - (t36 * t70);
    const float t214 = 1.0F / motion->constants[8];
    const float t215 = ((t83 * t211) - (t81 * t207)) * t214;
    const float t224 = t214 * ((t36 * t110) + (t119 * t211) - (t43 * t103) - (t115 * t207));
    const float t229 = t214 * ((motion->constants[7] * t36) + (t122 * t211));
    const float t232 = (speeds[0] * t215) + (speeds[1] * t224) + (speeds[3] * t229);
    const float t236 = t33 * motion->constants[8];
    const float t244 = t30 * t47 * ((t31 * t194) + (t33 * t185));
    const float t245 = t236 * t244;
    const float t247 = t204 * t244;
    const float t253 = (cos_delta * t162) + (t185 * t190) + (t194 * t195) + (motion->constants[37] *
        t148) + (t204 * (t148 + (t194 * t232))) + (t185 * t245);
    const float t257 = t253 + (t194 * t247) - (sin_delta * t183) - (motion->constants[38] * t202) -
        (t236 * (t202 - (t185 * t232)));
    const float t264 = (motion->constants[37] * t185) - (motion->constants[38] * t194);
    const float t268 = speeds[1] * t194;
    const float t270 = (sin_delta * t152) - (cos_delta * t128) - t268;
    const float t273 = t189 + t232;
    const float t278 = motion->constants[8] * ((t31 * t185) - (t33 * t194));
    const float t284 = (cos_delta * t183) + (sin_delta * t162) + (motion->constants[38] * t270) +
        (t236 * t270) - (t189 * t195) - (t185 * t264);
    const float t286 = t284 - (t247 * t273) - (t185 * t278);
    const float t290 = (t141 * t167) - (t136 * t137);
    const float t304 = t290 + (motion->constants[30] * t128) + (t13 * t174) + (t194 * t264) +
        (t194 * t278) - (t25 * t179);
    const float t308 = t304 - (t189 * t190) - (motion->constants[37] * t270) - (t204 * t270) -
        (t245 * t273);
    const float t310 = (t31 * t286) + (t33 * t308);
    const float t313 = t80 * ((t47 * t257) + (t29 * t310));
    const float t319 = t73 * ((t29 * t257) + (t78 * t313) - (t47 * t310));
    const float t322 = t313 - t128 - (sin_phi * t319);
    float sin_theta = 0.0F;
    float cos_theta = 0.0F;
    carvallo_sin_cos_f32(positions[6], &sin_theta, &cos_theta);
    const float t328 = 1.0F - cos_theta;
    const float t330 = t328 * motion->constants[35];
    const float t332 = (motion->constants[7] * t322) - t172;
    const float t336 = t179 + (cos_phi * motion->constants[60]);
    const float t338 = (t13 * t336) - (t25 * t332);
    const float t340 = t136 * motion->constants[32];
    const float t345 = (t131 * motion->constants[32]) + (t141 * motion->constants[33]);
    const float t350 = t338 + (t136 * t340) + (t131 * t345) + (t322 * motion->constants[33]);
    const float t353 = cos_theta + (t328 * motion->constants[34]);
    const float t356 = motion->constants[2] * sin_theta;
    const float t357 = t136 * motion->constants[33];
    const float t361 = t145 - (cos_phi * t319);
    const float t363 = t147 + (t25 * t361);
    const float t366 = t151 + (t13 * t361);
    const float t369 = t159 + (sin_phi * motion->constants[60]);
    const float t373 = (t131 * t357) + (motion->constants[33] * t366) - (t141 * t340) -
        (motion->constants[32] * t363) - t369;
    const float t377 = (t25 * t336) + (t13 * t332);
    const float t383 = (t322 * motion->constants[32]) - t377 - (t141 * t345) - (t136 * t357);
    const float t386 = (t350 * t353) + (t356 * t373) + (t383 * t330);
    const float t391 = motion->constants[2] * speeds[2];
    const float t393 = motion->constants[3] * sin_theta;
    const float t397 = cos_theta + (t328 * motion->constants[36]);
    const float t401 = t391 + (t141 * t330) + (t131 * t397) - (t136 * t393);
    const float t403 = motion->constants[3] * speeds[2];
    const float t409 = t403 + (t141 * t353) + (t136 * t356) + (t131 * t330);
    const float t418 = (speeds[2] * ((motion->constants[3] * t401) - (motion->constants[2] *
        t409))) + (t356 * t366) + (t322 * cos_theta) + (t363 * t393);
    const float t424 = (t136 * cos_theta) + (t131 * t393) - (t141 * t356);
    const float t426 = t424 * motion->constants[54];
    const float t430 = (t401 * motion->constants[54]) - (motion->constants[55] * t409);
    const float t434 = (t386 * motion->constants[24]) + (motion->constants[55] * t418) - (t424 *
        t426) - (t401 * t430);
    const float t440 = (cos_theta * t373) + (t393 * t383) - (t356 * t350);
    const float t448 = (t363 * t397) - (t424 * t403) - (t366 * t330) - (t322 * t393);
    const float t456 = (t424 * t391) + (t322 * t356) + (t363 * t330) - (t366 * t353);
    const float t458 = motion->constants[55] * t424;
    const float t464 = (t440 * motion->constants[24]) + (t448 * motion->constants[54]) + (t401 *
        t458) + (t409 * t426) - (motion->constants[55] * t456);
    const float t470 = (t350 * t330) + (t383 * t397) - (t373 * t393);
    const float t477 = (t470 * motion->constants[24]) + (t409 * t430) - (motion->constants[54] *
        t418) - (t424 * t458);
    const float t480 = (t330 * t434) + (t393 * t464) + (t397 * t477);
    const float t483 = t290 - t377 - (motion->constants[30] * t322);
    const float t490 = (cos_delta * t322) + (sin_delta * t366) - t268;
    const float t495 = (t185 * motion->constants[48]) - (t194 * motion->constants[49]);
    const float t497 = t189 * motion->constants[49];
    const float t501 = (t483 * motion->constants[47]) + (t194 * t495) - (motion->constants[48] *
        t490) - (t189 * t497);
    const float t509 = (t131 * motion->constants[40]) - (motion->constants[41] * t141);
    const float t511 = motion->constants[41] * t136;
    const float t518 = t13 * (t480 + t501 + (t141 * t509) - (t377 * motion->constants[44]) - (t322 *
        motion->constants[40]) - (t136 * t511));
    const float t523 = (t353 * t434) + (t330 * t477) - (t356 * t464);
    const float t526 = t338 + (motion->constants[31] * t322) - t169;
    const float t532 = t144 + (motion->constants[30] * t363) + (motion->constants[31] * t366) -
        t369;
    const float t534 = (cos_delta * t526) + (sin_delta * t532);
    const float t537 = t189 * motion->constants[48];
    const float t542 = (t534 * motion->constants[47]) + (motion->constants[49] * t490) - (t189 *
        t537) - (t185 * t495);
    const float t546 = (cos_delta * t532) - (sin_delta * t526);
    const float t552 = t200 + (sin_delta * t322) - (cos_delta * t366);
    const float t559 = (t546 * motion->constants[47]) + (t363 * motion->constants[48]) + (t185 *
        t497) + (t194 * t537) - (motion->constants[49] * t552);
    const float t561 = (cos_delta * t542) - (sin_delta * t559);
    const float t564 = t136 * motion->constants[40];
    const float t572 = t25 * (t523 + t561 + (t338 * motion->constants[44]) +
        (motion->constants[41] * t322) - (t136 * t564) - (t131 * t509));
    const float t575 = (t322 * motion->constants[27]) - (motion->constants[7] * (t518 + t572));
    const float t576 = sin_phi * t122;
    const float t585 = (t141 * motion->constants[45]) + (t131 * motion->constants[42]);
    const float t590 = (t141 * motion->constants[42]) + (t131 * motion->constants[46]);
    const float t600 = (motion->constants[57] * t409) + (t401 * motion->constants[59]);
    const float t603 = t424 * motion->constants[58];
    const float t608 = (motion->constants[56] * t456) + (motion->constants[57] * t448) + (t424 *
        t600) - (motion->constants[55] * t440) - (t401 * t603);
    const float t615 = (motion->constants[56] * t409) + (motion->constants[57] * t401);
    const float t621 = (motion->constants[55] * t386) + (motion->constants[58] * t418) + (t401 *
        t615) - (motion->constants[54] * t470) - (t409 * t600);
    const float t631 = (t440 * motion->constants[54]) + (t456 * motion->constants[57]) + (t448 *
        motion->constants[59]) + (t409 * t603) - (t424 * t615);
    const float t643 = (t194 * motion->constants[51]) + (t185 * motion->constants[53]);
    const float t649 = (t189 * motion->constants[52]) + (t273 * motion->constants[28]);
    const float t654 = (motion->constants[50] * t552) + (t363 * motion->constants[51]) + (t189 *
        t643) - (motion->constants[49] * t546) - (t185 * t649);
    const float t666 = t214 * ((t31 * t308) + (t211 * t319) - (t33 * t286) - (t207 * t313));
    const float t668 = motion->constants[28] * (t490 + t666);
    const float t671 = (t194 * motion->constants[50]) + (t185 * motion->constants[51]);
    const float t678 = (motion->constants[49] * t534) + (motion->constants[52] * t490) + t668 +
        (t185 * t671) - (motion->constants[48] * t483) - (t194 * t643);
    const float t686 = (motion->constants[41] * t338) + (motion->constants[40] * t377) + (t322 *
        motion->constants[43]) + (t131 * t585) + (t356 * t608) + (cos_theta * t621);
    const float t691 = t686 + (motion->constants[33] * t523) + (motion->constants[32] * t480) +
        (sin_delta * t654) + (cos_delta * t678) + (motion->constants[31] * t561);
    const float t695 = t691 + t575 - (t141 * t590) - (t393 * t631) - (motion->constants[30] * t501);
    const float t697 = cos_phi * t122;
    const float t704 = (t136 * motion->constants[43]) + (motion->constants[27] * (speeds[3] +
        t136));
    const float t715 = (t546 * motion->constants[48]) + (t552 * motion->constants[51]) + (t363 *
        motion->constants[53]) + (t194 * t649) - (t189 * t671);
    const float t723 = (t356 * t434) + (cos_theta * t464) - (t393 * t477);
    const float t727 = (sin_delta * t542) + (cos_delta * t559);
    const float t733 = (motion->constants[46] * t363) + (t141 * t704) + t715 + (t330 * t608) +
        (t393 * t621) + (t397 * t631);
    const float t738 = t733 + (motion->constants[30] * t727) - (motion->constants[40] * t369) -
        (motion->constants[42] * t366) - (t136 * t585) - (motion->constants[32] * t723);
    const float t756 = (motion->constants[41] * t369) + (motion->constants[42] * t363) + (t136 *
        t590) + (t353 * t608) + (t330 * t631) + (cos_delta * t654);
    const float t761 = t756 - (motion->constants[45] * t366) - (t131 * t704) - (t356 * t621) -
        (motion->constants[33] * t723) - (sin_delta * t678);
    const float t762 = t761 - (motion->constants[31] * t727);
    const float t764 = (t25 * t738) - (t13 * t762);
    const float t780 = t723 + t727 + (motion->constants[40] * t363) + (motion->constants[41] *
        t366) + (t131 * t511) + (t141 * t564) - (t369 * motion->constants[44]);
    const float t783 = t81 - (sin_phi * t83);
    const float t785 = cos_phi * t83;
    const float t792 = forces[0] + (t764 * t785) - (t13 * t738) - (t25 * t762) -
        (motion->constants[7] * t780) - (t695 * t783);
    const float t793 = t792 - (t215 * t668);
    const float t796 = (motion->constants[56] * t330) + (motion->constants[57] * t397);
    const float t798 = t393 * motion->constants[58];
    const float t800 = t330 * motion->constants[57];
    const float t802 = t800 + (t397 * motion->constants[59]);
    const float t806 = (t356 * motion->constants[54]) - (motion->constants[55] * t393);
    const float t809 = sin_delta * motion->constants[48];
    const float t811 = (sin_delta * motion->constants[51]) - (motion->constants[31] * t809);
    const float t815 = (t356 * t796) + (cos_theta * t798) + t811 - (t393 * t802) -
        (motion->constants[33] * t806);
    const float t819 = (t356 * motion->constants[56]) - (t393 * motion->constants[57]);
    const float t821 = cos_theta * motion->constants[58];
    const float t825 = (t356 * motion->constants[57]) - (t393 * motion->constants[59]);
    const float t829 = sin_delta * motion->constants[66];
    const float t836 = (t353 * t819) + (t330 * t825) + (motion->constants[32] * t806) + (cos_delta *
        t829) - (t356 * t821) - (motion->constants[30] * t809);
    const float t838 = (t13 * t815) + (t25 * t836);
    const float t845 = (t330 * motion->constants[54]) + (motion->constants[55] * t397);
    const float t849 = (t353 * motion->constants[54]) + (motion->constants[55] * t330);
    const float t855 = cos_delta * motion->constants[48];
    const float t857 = (cos_delta * motion->constants[51]) - (motion->constants[31] * t855);
    const float t862 = motion->constants[42] + (t353 * t796) + (t330 * t802) +
        (motion->constants[32] * t845) + motion->constants[64] + t857;
    const float t866 = t862 - (t356 * t798) - (motion->constants[33] * t849) -
        motion->constants[69] - motion->constants[70];
    const float t876 = sin_delta * t829;
    const float t877 = motion->constants[33] * t845;
    const float t882 = t877 + t877 + motion->constants[63] + motion->constants[68];
    const float t886 = motion->constants[45] + motion->constants[50] + (t353 * (t800 +
        (motion->constants[56] * t353))) + (t356 * t356 * motion->constants[58]) + (t330 * ((t353 *
        motion->constants[57]) + (t330 * motion->constants[59])));
    const float t888 = t886 + t882 - t876;
    const float t895 = motion->constants[30] * t855;
    const float t896 = (motion->constants[32] * t849) - t895;
    const float t899 = motion->constants[65] + motion->constants[71] - t896 - t896;
    const float t904 = motion->constants[46] + motion->constants[53] + (t330 * t796) + (t393 *
        t798) + (t397 * t802) + t899;
    const float t905 = t904 - t888;
    const float t906 = t25 * t13;
    const float t908 = t13 * t13;
    const float t909 = t866 + t866;
    const float t915 = motion->constants[41] + t845 + motion->constants[62] + motion->constants[72];
    const float t922 = motion->constants[40] + t849 + t855 + motion->constants[67] -
        motion->constants[61];
    const float t928 = t866 + (t905 * t906) + (motion->constants[7] * ((t13 * t915) + (t25 *
        t922))) - (t908 * t909);
    const float t932 = (t25 * t915) - (t13 * t922);
    const float t935 = motion->constants[7] * (t932 - motion->constants[73]);
    const float t939 = motion->constants[7] * t932;
    const float t942 = motion->constants[74] - t939 - t939;
    const float t948 = motion->constants[43] + motion->constants[52] + t876 + t882 + t899 + (t356 *
        t819) + (cos_theta * t821);
    const float t950 = t948 + t942 - (t393 * t825);
    const float t955 = motion->constants[7] * (t806 + t809);
    const float t957 = (t25 * t815) + t955 - (t13 * t836);
    const float t960 = t935 + (t576 * t950) + (t697 * t957);
    const float t965 = (t905 * t908) + (t906 * t909);
    const float t966 = t904 - t965;
    const float t969 = t955 - (t576 * t957) - (t697 * t966);
    const float t971 = 1.0F - t576;
    const float t972 = motion->constants[27] * t783;
    const float t975 = sin_delta * t13;
    const float t978 = t229 - (cos_delta * t576) - (t697 * t975);
    const float t984 = t215 + (cos_delta * t783) - (sin_delta * t25) - (t785 * t975);
    const float t985 = motion->constants[28] * t984;
    const float t991 = (t971 * t972) + (t978 * t985) - (t576 * t838) - (t697 * t928) - (t783 *
        t960) - (t785 * t969);
    const float t1010 = t888 + t942 + t965 + (t783 * t838) + (t783 * (t838 + (t783 * t950) - (t785 *
        t957))) + (t783 * t972);
    const float t1013 = t1010 + (t984 * t985) - (t785 * t928) - (t785 * (t928 + (t783 * t957) -
        (t785 * t966)));
    const float t1014 = 1.0F / t1013;
    const float t1015 = t991 * t1014;
    const float t1018 = t115 - (sin_phi * t119);
    const float t1020 = motion->constants[7] * t25 * t809;
    const float t1021 = t811 + t1020;
    const float t1023 = cos_phi * t119;
    const float t1026 = t1021 + (t950 * t1018) - (t957 * t1023);
    const float t1028 = motion->constants[53] + t895;
    const float t1031 = (t25 * t1028) - (t13 * t857);
    const float t1035 = t1031 + (t957 * t1018) - (t966 * t1023);
    const float t1039 = motion->constants[27] * t1018;
    const float t1044 = t224 + (cos_delta * t1018) - (t975 * t1023);
    const float t1045 = motion->constants[28] * t1044;
    const float t1060 = (t13 * t1028) + (t25 * t857) + (motion->constants[7] * t855) + (t838 *
        t1018) + (t783 * t1026) + (t972 * t1018);
    const float t1064 = t1014 * (t1060 + (t985 * t1044) - (t928 * t1023) - (t785 * t1035));
    const float t1065 = t1013 * t1064;
    const float t1071 = motion->constants[53] + (t1018 * t1026) + (t1018 * t1021) + (t1018 *
        t1039) + (t1044 * t1045) - (t1023 * t1035);
    const float t1073 = t1071 - (t1023 * t1031) - (t1064 * t1065);
    const float t1074 = 1.0F / t1073;
    const float t1086 = t1020 + (t971 * t1039) + (t978 * t1045) - (t960 * t1018) - (t969 * t1023) -
        (t576 * t1021);
    const float t1089 = t1074 * (t1086 - (t697 * t1031) - (t1015 * t1065));
    const float t1099 = forces[1] + (t764 * t1023) - t715 - (t695 * t1018) - (t224 * t668) - (t793 *
        t1064);
    const float t1102 = t393 * motion->constants[75];
    const float t1104 = t356 * motion->constants[75];
    const float t1107 = motion->constants[7] * ((t13 * t1102) - (t25 * t1104));
    const float t1117 = (t356 * motion->constants[76]) + (motion->constants[32] * t1102) - t1107 -
        (t393 * motion->constants[77]) - (motion->constants[33] * t1104);
    const float t1121 = cos_theta * motion->constants[75];
    const float t1124 = (t330 * motion->constants[76]) + (t397 * motion->constants[77]) -
        (motion->constants[32] * t1121);
    const float t1130 = (t353 * motion->constants[76]) + (t330 * motion->constants[77]) -
        (motion->constants[33] * t1121);
    const float t1132 = (t25 * t1124) - (t13 * t1130);
    const float t1143 = t1014 * ((t13 * t1124) + (t25 * t1130) + (motion->constants[7] * t1121) +
        (t783 * t1117) - (t785 * t1132));
    const float t1144 = t1013 * t1143;
    const float t1151 = t1074 * ((t1018 * t1117) - (t1023 * t1132) - (t1065 * t1143));
    const float t1152 = t1073 * t1151;
    const float t1162 = motion->constants[78] - (t1143 * t1144) - (t1151 * t1152);
    const float t1163 = 1.0F / t1162;
    const float t1164 = (t1107 + (t576 * t1117) + (t697 * t1132) + (t1015 * t1144) + (t1089 *
        t1152)) * t1163;
    const float t1178 = forces[2] - (motion->constants[3] * t608) - (motion->constants[2] * t631) -
        (positions[6] * motion->constants[5]) - (speeds[2] * motion->constants[6]) - (t793 * t1143);
    const float t1179 = t1178 - (t1099 * t1151);
    const float t1185 = (t576 * t695) + (t697 * t764) + (t1164 * t1179) - t575 - (t229 * t668) -
        (t793 * t1015);
    const float t1206 = (t576 * t960) + (t576 * t935) + motion->constants[79] +
        (motion->constants[27] * t971 * t971) + (motion->constants[28] * t978 * t978) - (t697 *
        t969);
    const float t1211 = (t1185 - (t1089 * t1099)) / (t1206 - (t697 * t955) - (t1013 * t1015 *
        t1015) - (t1073 * t1089 * t1089) - (t1162 * t1164 * t1164));
    const float t1216 = (t1163 * t1179) + (t1164 * t1211);
    const float t1220 = (t1074 * t1099) - (t1151 * t1216) - (t1089 * t1211);
    const float t1226 = (t793 * t1014) - (t1064 * t1220) - (t1143 * t1216) - (t1015 * t1211);
    const float t1230 = t313 + (t81 * t1226) + (t115 * t1220);
    const float t1232 = motion->constants[7] * (t1211 + t1230);
    const float t1235 = t126 * t155;
    const float t1240 = (cos_psi * t1235) - (t1232 * sin_psi);
    const float t1252 = t666 + (t215 * t1226) + (t224 * t1220) + (t229 * t1211);
    const float t1253 = -((cos_psi * t1232) + (sin_psi * t1235));
    const float t1254 = -(t319 + (t83 * t1226) + (t119 * t1220) + (t122 * t1211));
    accelerations[0] = t1253;
    accelerations[1] = t1240;
    accelerations[2] = t1254;
    accelerations[3] = t1226;
    accelerations[4] = t1230;
    accelerations[5] = t1220;
    accelerations[6] = t1216;
    accelerations[7] = t1211;
    accelerations[8] = t1252;
}

carvallo_motion_error_t whipple_leaning_f32_motion_accelerations(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    const float forces[WHIPPLE_LEANING_FORCES], float accelerations[WHIPPLE_LEANING_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_LEANING_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_LEANING_FORCES)) {
        whipple_leaning_f32_compute_accelerations(motion, positions, speeds, forces, accelerations);
        error = (carvallo_are_finite_f32(accelerations, WHIPPLE_LEANING_POSITIONS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_leaning_f32_compute_energy(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    float energy[2])
{
    float sin_theta = 0.0F;
    float cos_theta = 0.0F;
    carvallo_sin_cos_f32(positions[6], &sin_theta, &cos_theta);
    const float t6 = 1.0F - cos_theta;
    const float t9 = cos_theta + (t6 * motion->constants[34]);
    const float t13 = t6 * motion->constants[35];
    const float t15 = t13 * motion->constants[57];
    const float t20 = motion->constants[2] * sin_theta;
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t32 = sin_delta * motion->constants[66];
    const float t33 = sin_delta * t32;
    const float t39 = cos_theta + (t6 * motion->constants[36]);
    const float t42 = (t13 * motion->constants[54]) + (t39 * motion->constants[55]);
    const float t43 = motion->constants[33] * t42;
    const float t48 = t43 + t43 + motion->constants[63] + motion->constants[68];
    const float t52 = motion->constants[45] + motion->constants[50] + (t9 * ((t9 *
        motion->constants[56]) + t15)) + (t20 * t20 * motion->constants[58]) + (t13 * ((t9 *
        motion->constants[57]) + (t13 * motion->constants[59])));
    const float t54 = t52 + t48 - t33;
    const float t59 = (motion->constants[56] * t13) + (motion->constants[57] * t39);
    const float t62 = sin_theta * motion->constants[3];
    const float t63 = motion->constants[58] * t62;
    const float t66 = t15 + (motion->constants[59] * t39);
    const float t73 = (t9 * motion->constants[54]) + (t13 * motion->constants[55]);
    const float t78 = cos_delta * motion->constants[48];
    const float t79 = motion->constants[30] * t78;
    const float t80 = (motion->constants[32] * t73) - t79;
    const float t83 = motion->constants[65] + motion->constants[71] - t80 - t80;
    const float t88 = motion->constants[46] + motion->constants[53] + (t13 * t59) + (t62 * t63) +
        (t39 * t66) + t83;
    const float t89 = t88 - t54;
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t95 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    const float t96 = t95 * t95;
    const float t100 = (motion->constants[3] * cos_pitch) - (motion->constants[2] * sin_pitch);
    const float t101 = t95 * t100;
    const float t115 = (cos_delta * motion->constants[51]) - (t78 * motion->constants[31]);
    const float t120 = motion->constants[42] + (t9 * t59) + (t13 * t66) + (t42 *
        motion->constants[32]) + motion->constants[64] + t115;
    const float t124 = t120 - (t20 * t63) - (motion->constants[33] * t73) - motion->constants[69] -
        motion->constants[70];
    const float t125 = t124 + t124;
    const float t127 = (t89 * t96) + (t101 * t125);
    const float t134 = t42 + motion->constants[41] + motion->constants[62] + motion->constants[72];
    const float t142 = t73 + t78 + motion->constants[40] + motion->constants[67] -
        motion->constants[61];
    const float t144 = (t100 * t134) - (t95 * t142);
    const float t145 = motion->constants[7] * t144;
    const float t148 = motion->constants[74] - t145 - t145;
    const float t154 = (t20 * motion->constants[54]) - (motion->constants[55] * t62);
    const float t157 = sin_delta * motion->constants[48];
    const float t159 = (sin_delta * motion->constants[51]) - (motion->constants[31] * t157);
    const float t163 = (t20 * t59) + (cos_theta * t63) + t159 - (t62 * t66) -
        (motion->constants[33] * t154);
    const float t167 = (motion->constants[56] * t20) - (motion->constants[57] * t62);
    const float t169 = cos_theta * motion->constants[58];
    const float t173 = (motion->constants[57] * t20) - (motion->constants[59] * t62);
    const float t182 = (t9 * t167) + (t13 * t173) + (motion->constants[32] * t154) + (t32 *
        cos_delta) - (t20 * t169) - (motion->constants[30] * t157);
    const float t184 = (t95 * t163) + (t100 * t182);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t189 = t95 * cos_phi;
    const float t192 = (sin_delta * sin_phi) - (cos_delta * t189);
    const float t194 = t100 * cos_phi;
    const float t197 = sqrtf((t192 * t192) + (t194 * t194));
    const float t198 = 1.0F / t197;
    const float t199 = t192 * t198;
    const float t201 = t194 * t198;
    const float t202 = cos_delta * t201;
    const float t204 = (t100 * t202) - (t95 * t199);
    const float t209 = motion->constants[8] * ((cos_delta * sin_phi) + (sin_delta * t189));
    const float t212 = sin_delta * motion->constants[37];
    const float t217 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const float t219 = (t100 * motion->constants[39]) - (t95 * t217);
    const float t222 = (cos_phi * t212) - (t204 * t209) - (sin_phi * t219);
    const float t223 = (motion->constants[7] * sin_phi) + t222;
    const float t230 = (sin_delta * cos_phi * t201) + (sin_phi * ((t100 * t199) + (t95 * t202)));
    const float t235 = (t209 * t230) + (t95 * motion->constants[39]) + (t100 * t217);
    const float t237 = 1.0F / (cos_phi * t235);
    const float t238 = t223 * t237;
    const float t239 = sin_phi * t235;
    const float t241 = sin_phi * t223;
    const float t243 = (t204 * t239) + (t230 * t241);
    const float t247 = 1.0F / ((t204 * t235) + (t223 * t230));
    const float t249 = t238 * t243 * t247;
    const float t251 = t238 - (sin_phi * t249);
    const float t261 = t124 + (t89 * t101) + (motion->constants[7] * ((t95 * t134) + (t100 *
        t142))) - (t96 * t125);
    const float t262 = cos_phi * t249;
    const float t274 = t33 + t48 + t83 + t148 + motion->constants[43] + motion->constants[52] +
        (t20 * t167);
    const float t276 = t274 + (cos_theta * t169) - (t62 * t173);
    const float t280 = t154 + t157;
    const float t281 = motion->constants[7] * t280;
    const float t283 = (t100 * t163) + t281 - (t95 * t182);
    const float t289 = t88 - t127;
    const float t295 = t251 * motion->constants[27];
    const float t299 = (t230 * t239) - (t204 * t241);
    const float t303 = (t230 * t235) - (t204 * t223);
    const float t306 = 1.0F / motion->constants[8];
    const float t310 = sin_delta * t95;
    const float t314 = (((t249 * t303) - (t238 * t299)) * t306) + (cos_delta * t251) - (sin_delta *
        t100) - (t262 * t310);
    const float t316 = t314 * motion->constants[28];
    const float t322 = t54 + t127 + t148 + (t184 * t251) + (t251 * (t184 + (t251 * t276) - (t262 *
        t283))) + (t251 * t295);
    const float t326 = speeds[0] * (t322 + (t314 * t316) - (t261 * t262) - (t262 * (t261 + (t251 *
        t283) - (t262 * t289))));
    const float t328 = motion->constants[53] + t79;
    const float t334 = (t100 * motion->constants[31]) - (motion->constants[30] * t95);
    const float t336 = t222 + (sin_phi * t334);
    const float t338 = t100 * sin_phi;
    const float t342 = t235 - (t95 * motion->constants[31]) - (motion->constants[30] * t100);
    const float t345 = t237 * ((t95 * t336) + (t338 * t342));
    const float t353 = (t197 * motion->constants[8]) + (sin_phi * t212) + (cos_phi * t219) -
        (cos_phi * t334);
    const float t355 = (t194 * t342) - (t95 * t353);
    const float t359 = (t338 * t353) + (t194 * t336);
    const float t364 = t247 * ((t204 * t355) + (t230 * t359) + (t243 * t345));
    const float t366 = t345 - (sin_phi * t364);
    const float t368 = cos_phi * t364;
    const float t371 = t100 * motion->constants[7] * t157;
    const float t372 = t159 + t371;
    const float t376 = t372 + (t276 * t366) - (t283 * t368);
    const float t380 = (t100 * t328) - (t95 * t115);
    const float t384 = t380 + (t283 * t366) - (t289 * t368);
    const float t397 = (t306 * ((t204 * t359) + (t303 * t364) - (t230 * t355) - (t299 * t345))) +
        (cos_delta * t366);
    const float t398 = t397 - (t310 * t368);
    const float t404 = (t95 * t328) + (t100 * t115) + (t78 * motion->constants[7]) + (t184 * t366) +
        (t251 * t376) + (t295 * t366);
    const float t407 = t404 + (t316 * t398) - (t261 * t368) - (t262 * t384);
    const float t415 = cos_theta * motion->constants[75];
    const float t418 = (t13 * motion->constants[76]) + (t39 * motion->constants[77]) -
        (motion->constants[32] * t415);
    const float t424 = (t9 * motion->constants[76]) + (t13 * motion->constants[77]) -
        (motion->constants[33] * t415);
    const float t429 = t20 * motion->constants[75];
    const float t431 = t62 * motion->constants[75];
    const float t436 = motion->constants[7] * ((t95 * t431) - (t100 * t429));
    const float t440 = (t20 * motion->constants[76]) + (motion->constants[32] * t431) - (t62 *
        motion->constants[77]) - (motion->constants[33] * t429) - t436;
    const float t444 = (t100 * t418) - (t95 * t424);
    const float t449 = (t95 * t418) + (t100 * t424) + (motion->constants[7] * t415) + (t251 *
        t440) - (t262 * t444);
    const float t453 = motion->constants[7] * t230 * t247;
    const float t454 = sin_phi * t453;
    const float t456 = cos_phi * t453;
    const float t459 = t144 - motion->constants[73];
    const float t460 = motion->constants[7] * t459;
    const float t464 = t460 + (t276 * t454) + (t283 * t456);
    const float t469 = t281 - (t283 * t454) - (t289 * t456);
    const float t471 = 1.0F - t454;
    const float t480 = (t306 * ((motion->constants[7] * t204) + (t303 * t453))) - (cos_delta *
        t454) - (t310 * t456);
    const float t486 = (t295 * t471) + (t316 * t480) - (t184 * t454) - (t261 * t456) - (t251 *
        t464) - (t262 * t469);
    const float t497 = motion->constants[27] * t366;
    const float t499 = motion->constants[28] * t398;
    const float t505 = motion->constants[53] + (t366 * t376) + (t366 * t372) + (t366 * t497) +
        (t398 * t499) - (t368 * t384);
    const float t510 = (t366 * t440) - (t368 * t444);
    const float t522 = t371 + (t471 * t497) + (t480 * t499) - (t366 * t464) - (t368 * t469) -
        (t372 * t454);
    const float t523 = t522 - (t380 * t456);
    const float t527 = (speeds[0] * t407) + (speeds[1] * (t505 - (t368 * t380))) + (speeds[2] *
        t510) + (speeds[3] * t523);
    const float t536 = t436 + (t440 * t454) + (t444 * t456);
    const float t558 = (t454 * t464) + (t454 * t460) + motion->constants[79] +
        (motion->constants[27] * t471 * t471) + (motion->constants[28] * t480 * t480) - (t456 *
        t469);
    const float t564 = speeds[3] * ((speeds[0] * t486) + (speeds[1] * t523) + (speeds[3] * (t558 -
        (t281 * t456))) - (speeds[2] * t536));
    const float t565 = (speeds[0] * (t326 + (speeds[1] * t407) + (speeds[2] * t449) + (speeds[3] *
        t486))) + (speeds[1] * t527);
    const float t566 = t565 + (speeds[2] * ((speeds[0] * t449) + (speeds[1] * t510) + (speeds[2] *
        motion->constants[78]) - (speeds[3] * t536)));
    const float t569 = (t566 + t564) * 0.5F;
    const float t579 = (positions[6] * positions[6] * 0.5F * motion->constants[5]) -
        (motion->constants[60] * ((sin_phi * t280) + (cos_phi * t459)));
    energy[0] = t569;
    energy[1] = t579;
}

carvallo_motion_error_t whipple_leaning_f32_motion_energy(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    float energy[2])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_LEANING_SPEEDS)) {
        whipple_leaning_f32_compute_energy(motion, positions, speeds, energy);
        error = (carvallo_are_finite_f32(energy, 2U)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

/* How far the lowest points of the wheels behind the first are below the ground, and the steps of Newton's method. */
static void whipple_leaning_f32_compute_closure(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], float below[1U], float steps[1U])
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
    const float t14 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    const float t15 = cos_phi * t14;
    const float t19 = sin_phi * sin_delta;
    const float t20 = t19 - (cos_delta * t15);
    const float t24 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const float t25 = cos_phi * t24;
    const float t28 = sqrtf((t20 * t20) + (t25 * t25));
    const float t36 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const float t42 = (motion->constants[8] * t28) + (t19 * motion->constants[37]) + (cos_phi *
        ((t24 * motion->constants[39]) - (t14 * t36))) - (motion->constants[7] * cos_phi);
    const float t46 = 1.0F / t28;
    const float t47 = t25 * t46;
    const float t58 = motion->constants[8] * ((cos_delta * sin_phi) + (t15 * sin_delta)) *
        ((cos_phi * sin_delta * t47) + (sin_phi * ((t20 * t24 * t46) + (cos_delta * t14 * t47))));
    const float t64 = t42 / (cos_phi * (t58 + (t14 * motion->constants[39]) + (t24 * t36)));
    below[0] = t42;
    steps[0] = t64;
}

carvallo_motion_error_t whipple_leaning_f32_motion_close(const whipple_leaning_f32_motion_t *motion,
    float positions[WHIPPLE_LEANING_POSITIONS])
{
    /* The positions that the heights of the wheels determine. */
    static const size_t DEPENDENT[1U] = {4U};
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_LEANING_POSITIONS)) {
        float found[WHIPPLE_LEANING_POSITIONS];
        float below[1U];
        float steps[1U];
        float shortest = 1e30F;
        bool is_closed = false;
        bool goes_on = true;
        for (size_t i = 0U; i < WHIPPLE_LEANING_POSITIONS; i++) {
            found[i] = positions[i];
        }
        /* With steps of the greatest length they lead around the whole circle; near a solution a handful is enough. */
        for (size_t count = 0U; goes_on && (count < 60U); count++) {
            whipple_leaning_f32_compute_closure(motion, found, below, steps);
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
            whipple_leaning_f32_compute_closure(motion, found, below, steps);
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

static void whipple_leaning_f32_compute_contact_forces(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    const float forces[WHIPPLE_LEANING_FORCES], float contact_forces[3U * WHIPPLE_LEANING_WHEELS])
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
    const float t47 = (cos_delta * sin_phi) + (t19 * sin_delta);
    const float t48 = motion->constants[8] * t47;
    const float t55 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const float t58 = (t43 * t48) + (t9 * motion->constants[39]) + (t13 * t55);
    const float t59 = sin_phi * t58;
    const float t64 = sin_delta * motion->constants[37];
    const float t68 = (t13 * motion->constants[39]) - (t9 * t55);
    const float t71 = (cos_phi * t64) - (t36 * t48) - (sin_phi * t68);
    const float t72 = (sin_phi * motion->constants[7]) + t71;
    const float t73 = sin_phi * t72;
    const float t75 = (t36 * t59) + (t43 * t73);
    const float t77 = 1.0F / (cos_phi * t58);
    const float t78 = t72 * t77;
    const float t82 = 1.0F / ((t36 * t58) + (t43 * t72));
    const float t84 = t75 * t78 * t82;
    const float t91 = t58 - (t9 * motion->constants[31]) - (t13 * motion->constants[30]);
    const float t98 = (t13 * motion->constants[31]) - (t9 * motion->constants[30]);
    const float t102 = (t29 * motion->constants[8]) + (sin_phi * t64) + (cos_phi * t68) - (cos_phi *
        t98);
    const float t104 = (t26 * t91) - (t9 * t102);
    const float t106 = t13 * sin_phi;
    const float t109 = t71 + (sin_phi * t98);
    const float t111 = (t102 * t106) + (t26 * t109);
    const float t116 = t77 * ((t9 * t109) + (t91 * t106));
    const float t120 = t82 * ((t36 * t104) + (t43 * t111) + (t75 * t116));
    const float t124 = t43 * motion->constants[7] * t82;
    const float t127 = (speeds[0] * t84) + (speeds[1] * t120) + (speeds[3] * t124);
    const float t128 = cos_phi * t127;
    const float t130 = (speeds[0] * t13) + (t9 * t128);
    const float t133 = (t9 * speeds[0]) - (t13 * t128);
    const float t138 = (t133 * motion->constants[40]) - (t130 * motion->constants[41]);
    const float t142 = (speeds[0] * t78) + (speeds[1] * t116);
    const float t143 = sin_phi * t127;
    const float t144 = t142 - t143;
    const float t145 = motion->constants[41] * t144;
    const float t147 = (t130 * t138) - (t144 * t145);
    const float t149 = speeds[0] * motion->constants[7];
    const float t151 = speeds[3] + t142;
    const float t153 = motion->constants[7] * t143;
    const float t155 = ((t151 - t143) * t153) - (speeds[0] * t149);
    const float t158 = t155 + (cos_phi * motion->constants[60]);
    const float t159 = t13 * t158;
    const float t160 = t128 * t149;
    const float t161 = motion->constants[31] * t144;
    const float t163 = motion->constants[30] * t144;
    const float t165 = (t133 * t161) + (t130 * t163);
    const float t166 = speeds[0] * t143;
    const float t168 = t130 * t142;
    const float t169 = (t13 * t166) + t168;
    const float t172 = t133 * t142;
    const float t173 = (t9 * t166) + t172;
    const float t175 = t128 * t151;
    const float t177 = t128 * t153;
    const float t178 = t177 - (motion->constants[7] * t175);
    const float t181 = t165 + (motion->constants[30] * t169) + (motion->constants[31] * t173) -
        t178;
    const float t186 = (motion->constants[30] * t133) - (motion->constants[31] * t130);
    const float t188 = (t144 * t163) + (t133 * t186);
    const float t189 = speeds[0] * t128;
    const float t192 = t160 + (motion->constants[7] * t189);
    const float t197 = (t13 * t192) + (t9 * t155) - t188 - (motion->constants[31] * t189);
    const float t199 = speeds[1] + t133;
    const float t203 = (cos_delta * t144) - (sin_delta * t130);
    const float t204 = motion->constants[38] * t203;
    const float t208 = (cos_delta * t130) + (sin_delta * t144);
    const float t209 = motion->constants[37] * t203;
    const float t214 = speeds[1] * t203;
    const float t216 = t214 - (cos_delta * t173) - (sin_delta * t189);
    const float t218 = t31 * motion->constants[8];
    const float t221 = (t43 * t59) - (t36 * t73);
    const float t225 = (t43 * t58) - (t36 * t72);
    const float t228 = 1.0F / motion->constants[8];
    const float t229 = ((t84 * t225) - (t78 * t221)) * t228;
    const float t238 = t228 * ((t36 * t111) + (t120 * t225) - (t43 * t104) - (t116 * t221));
    const float t243 = t228 * ((t36 * motion->constants[7]) + (t124 * t225));
    const float t246 = (speeds[0] * t229) + (speeds[1] * t238) + (speeds[3] * t243);
    const float t250 = t33 * motion->constants[8];
    const float t258 = t30 * t47 * ((t31 * t208) + (t33 * t199));
    const float t259 = t250 * t258;
    const float t261 = t218 * t258;
    const float t267 = (cos_delta * t181) + (t199 * t204) + (t208 * t209) + (motion->constants[37] *
        t169) + (t218 * (t169 + (t208 * t246))) + (t199 * t259);
    const float t271 = t267 + (t208 * t261) - (sin_delta * t197) - (motion->constants[38] * t216) -
        (t250 * (t216 - (t199 * t246)));
    const float t278 = (motion->constants[37] * t199) - (motion->constants[38] * t208);
    const float t282 = speeds[1] * t208;
    const float t284 = (sin_delta * t173) - (cos_delta * t189) - t282;
    const float t287 = t203 + t246;
    const float t292 = motion->constants[8] * ((t31 * t199) - (t33 * t208));
    const float t298 = (cos_delta * t197) + (sin_delta * t181) + (motion->constants[38] * t284) +
        (t250 * t284) - (t203 * t209) - (t199 * t278);
    const float t300 = t298 - (t261 * t287) - (t199 * t292);
    const float t304 = (t130 * t186) - (t144 * t161);
    const float t318 = t304 + (motion->constants[30] * t189) + (t9 * t192) + (t208 * t278) + (t208 *
        t292) - (t13 * t155);
    const float t322 = t318 - (t203 * t204) - (motion->constants[37] * t284) - (t218 * t284) -
        (t259 * t287);
    const float t324 = (t31 * t300) + (t33 * t322);
    const float t329 = t77 * ((t47 * t271) + (t29 * t324));
    const float t333 = t82 * ((t29 * t271) + (t75 * t329) - (t47 * t324));
    const float t335 = t189 - t329;
    const float t336 = (sin_phi * t333) + t335;
    float sin_theta = 0.0F;
    float cos_theta = 0.0F;
    carvallo_sin_cos_f32(positions[6], &sin_theta, &cos_theta);
    const float t342 = 1.0F - cos_theta;
    const float t344 = t342 * motion->constants[35];
    const float t346 = (motion->constants[7] * t336) + t160;
    const float t348 = t9 * t158;
    const float t349 = t348 + (t13 * t346);
    const float t351 = t144 * motion->constants[32];
    const float t356 = (t133 * motion->constants[32]) + (t130 * motion->constants[33]);
    const float t358 = (t144 * t351) + (t133 * t356);
    const float t361 = t349 + t358 - (t336 * motion->constants[33]);
    const float t364 = cos_theta + (t342 * motion->constants[34]);
    const float t367 = motion->constants[2] * sin_theta;
    const float t368 = t144 * motion->constants[33];
    const float t371 = (t133 * t368) - (t130 * t351);
    const float t373 = t166 - (cos_phi * t333);
    const float t375 = t168 + (t13 * t373);
    const float t378 = t172 + (t9 * t373);
    const float t380 = sin_phi * motion->constants[60];
    const float t381 = t178 + t380;
    const float t384 = t371 + (motion->constants[33] * t378) - (motion->constants[32] * t375) -
        t381;
    const float t387 = t159 - (t9 * t346);
    const float t390 = (t130 * t356) + (t144 * t368);
    const float t393 = (t336 * motion->constants[32]) + t387 + t390;
    const float t396 = (t361 * t364) + (t367 * t384) - (t393 * t344);
    const float t401 = motion->constants[2] * speeds[2];
    const float t403 = motion->constants[3] * sin_theta;
    const float t407 = cos_theta + (t342 * motion->constants[36]);
    const float t411 = t401 + (t130 * t344) + (t133 * t407) - (t144 * t403);
    const float t413 = motion->constants[3] * speeds[2];
    const float t419 = t413 + (t130 * t364) + (t144 * t367) + (t133 * t344);
    const float t422 = speeds[2] * ((motion->constants[3] * t411) - (motion->constants[2] * t419));
    const float t428 = t422 + (t367 * t378) - (t336 * cos_theta) + (t375 * t403);
    const float t434 = (t144 * cos_theta) + (t133 * t403) - (t130 * t367);
    const float t436 = t434 * motion->constants[54];
    const float t440 = (t411 * motion->constants[54]) - (motion->constants[55] * t419);
    const float t442 = (t434 * t436) + (t411 * t440);
    const float t444 = (t396 * motion->constants[24]) + (motion->constants[55] * t428) - t442;
    const float t450 = (cos_theta * t384) - (t403 * t393) - (t367 * t361);
    const float t452 = t434 * t413;
    const float t458 = (t375 * t407) - t452 - (t378 * t344) + (t336 * t403);
    const float t460 = t434 * t401;
    const float t466 = t460 - (t336 * t367) + (t375 * t344) - (t378 * t364);
    const float t468 = motion->constants[55] * t434;
    const float t471 = (t411 * t468) + (t419 * t436);
    const float t474 = (t450 * motion->constants[24]) + (t458 * motion->constants[54]) + t471 -
        (motion->constants[55] * t466);
    const float t480 = (t361 * t344) - (t393 * t407) - (t384 * t403);
    const float t485 = (t419 * t440) - (t434 * t468);
    const float t487 = (t480 * motion->constants[24]) + t485 - (motion->constants[54] * t428);
    const float t490 = (t344 * t444) + (t403 * t474) + (t407 * t487);
    const float t493 = t304 - t387 + (motion->constants[30] * t336);
    const float t500 = (sin_delta * t378) - (cos_delta * t336) - t282;
    const float t505 = (t199 * motion->constants[48]) - (t208 * motion->constants[49]);
    const float t507 = t203 * motion->constants[49];
    const float t509 = (t208 * t505) - (t203 * t507);
    const float t511 = (t493 * motion->constants[47]) + t509 - (motion->constants[48] * t500);
    const float t523 = (t364 * t444) + (t344 * t487) - (t367 * t474);
    const float t526 = t349 - (motion->constants[31] * t336) - t188;
    const float t532 = t165 + (motion->constants[30] * t375) + (motion->constants[31] * t378) -
        t381;
    const float t534 = (cos_delta * t526) + (sin_delta * t532);
    const float t537 = t203 * motion->constants[48];
    const float t540 = (t203 * t537) + (t199 * t505);
    const float t542 = (t534 * motion->constants[47]) + (motion->constants[49] * t500) - t540;
    const float t546 = (cos_delta * t532) - (sin_delta * t526);
    const float t552 = t214 - (sin_delta * t336) - (cos_delta * t378);
    const float t556 = (t199 * t507) + (t208 * t537);
    const float t559 = (t546 * motion->constants[47]) + (t375 * motion->constants[48]) + t556 -
        (motion->constants[49] * t552);
    const float t561 = (cos_delta * t542) - (sin_delta * t559);
    const float t564 = motion->constants[40] * t144;
    const float t567 = (t144 * t564) + (t133 * t138);
    const float t573 = (t9 * (t147 + t490 + t511 - (motion->constants[44] * t387) +
        (motion->constants[40] * t336))) + (t13 * (t523 + t561 + (motion->constants[44] * t349) -
        (motion->constants[41] * t336) - t567));
    const float t575 = (t336 * motion->constants[27]) + (motion->constants[7] * t573);
    const float t576 = sin_phi * t124;
    const float t585 = (t130 * motion->constants[45]) + (t133 * motion->constants[42]);
    const float t590 = (t130 * motion->constants[42]) + (t133 * motion->constants[46]);
    const float t592 = (t133 * t585) - (t130 * t590);
    const float t601 = (motion->constants[57] * t419) + (t411 * motion->constants[59]);
    const float t604 = t434 * motion->constants[58];
    const float t606 = (t434 * t601) - (t411 * t604);
    const float t609 = (motion->constants[56] * t466) + (motion->constants[57] * t458) + t606 -
        (motion->constants[55] * t450);
    const float t616 = (motion->constants[56] * t419) + (motion->constants[57] * t411);
    const float t619 = (t411 * t616) - (t419 * t601);
    const float t622 = (motion->constants[55] * t396) + (motion->constants[58] * t428) + t619 -
        (motion->constants[54] * t480);
    const float t629 = (t419 * t604) - (t434 * t616);
    const float t632 = (t450 * motion->constants[54]) + (t466 * motion->constants[57]) + (t458 *
        motion->constants[59]) + t629;
    const float t644 = (t208 * motion->constants[51]) + (t199 * motion->constants[53]);
    const float t650 = (t203 * motion->constants[52]) + (t287 * motion->constants[28]);
    const float t652 = (t203 * t644) - (t199 * t650);
    const float t655 = (motion->constants[50] * t552) + (t375 * motion->constants[51]) + t652 -
        (motion->constants[49] * t546);
    const float t667 = t228 * ((t31 * t322) + (t225 * t333) - (t33 * t300) - (t221 * t329));
    const float t669 = motion->constants[28] * (t500 + t667);
    const float t672 = (t208 * motion->constants[50]) + (t199 * motion->constants[51]);
    const float t675 = (t199 * t672) - (t208 * t644);
    const float t679 = (motion->constants[49] * t534) + (motion->constants[52] * t500) + t669 +
        t675 - (motion->constants[48] * t493);
    const float t687 = (motion->constants[41] * t349) + (motion->constants[40] * t387) - (t336 *
        motion->constants[43]) + t592 + (t367 * t609) + (cos_theta * t622);
    const float t692 = t687 + (motion->constants[33] * t523) + (motion->constants[32] * t490) +
        (sin_delta * t655) + (cos_delta * t679) + (motion->constants[31] * t561);
    const float t695 = t692 - t575 - (t403 * t632) - (motion->constants[30] * t511);
    const float t697 = cos_phi * t124;
    const float t704 = (t144 * motion->constants[43]) + (motion->constants[27] * (speeds[3] +
        t144));
    const float t707 = (t130 * t704) - (t144 * t585);
    const float t713 = (t208 * t650) - (t203 * t672);
    const float t716 = (t546 * motion->constants[48]) + (t552 * motion->constants[51]) + (t375 *
        motion->constants[53]) + t713;
    const float t724 = (t367 * t444) + (cos_theta * t474) - (t403 * t487);
    const float t728 = (sin_delta * t542) + (cos_delta * t559);
    const float t734 = (motion->constants[46] * t375) + t707 + t716 + (t344 * t609) + (t403 *
        t622) + (t407 * t632);
    const float t738 = t734 + (motion->constants[30] * t728) - (motion->constants[40] * t381) -
        (motion->constants[42] * t378) - (motion->constants[32] * t724);
    const float t745 = (t144 * t590) - (t133 * t704);
    const float t757 = (motion->constants[41] * t381) + (motion->constants[42] * t375) + t745 +
        (t364 * t609) + (t344 * t632) + (cos_delta * t655);
    const float t762 = t757 - (motion->constants[45] * t378) - (t367 * t622) -
        (motion->constants[33] * t724) - (sin_delta * t679) - (motion->constants[31] * t728);
    const float t764 = (t13 * t738) - (t9 * t762);
    const float t775 = (t133 * t145) + (t130 * t564);
    const float t781 = motion->constants[7] * (t724 + t728 + (motion->constants[40] * t375) +
        (motion->constants[41] * t378) + t775 - (motion->constants[44] * t381));
    const float t783 = t78 - (sin_phi * t84);
    const float t785 = cos_phi * t84;
    const float t792 = forces[0] + (t764 * t785) - (t9 * t738) - (t13 * t762) - t781 - (t695 *
        t783);
    const float t793 = t792 - (t229 * t669);
    const float t796 = (motion->constants[56] * t344) + (motion->constants[57] * t407);
    const float t798 = t403 * motion->constants[58];
    const float t800 = t344 * motion->constants[57];
    const float t802 = t800 + (t407 * motion->constants[59]);
    const float t806 = (t367 * motion->constants[54]) - (motion->constants[55] * t403);
    const float t809 = sin_delta * motion->constants[48];
    const float t811 = (sin_delta * motion->constants[51]) - (motion->constants[31] * t809);
    const float t815 = (t367 * t796) + (cos_theta * t798) + t811 - (t403 * t802) -
        (motion->constants[33] * t806);
    const float t819 = (t367 * motion->constants[56]) - (t403 * motion->constants[57]);
    const float t821 = cos_theta * motion->constants[58];
    const float t825 = (t367 * motion->constants[57]) - (t403 * motion->constants[59]);
    const float t829 = sin_delta * motion->constants[66];
    const float t836 = (t364 * t819) + (t344 * t825) + (motion->constants[32] * t806) + (cos_delta *
        t829) - (t367 * t821) - (motion->constants[30] * t809);
    const float t838 = (t9 * t815) + (t13 * t836);
    const float t845 = (t344 * motion->constants[54]) + (motion->constants[55] * t407);
    const float t849 = (t364 * motion->constants[54]) + (motion->constants[55] * t344);
    const float t855 = cos_delta * motion->constants[48];
    const float t857 = (cos_delta * motion->constants[51]) - (motion->constants[31] * t855);
    const float t862 = motion->constants[42] + (t364 * t796) + (t344 * t802) +
        (motion->constants[32] * t845) + motion->constants[64] + t857;
    const float t866 = t862 - (t367 * t798) - (motion->constants[33] * t849) -
        motion->constants[69] - motion->constants[70];
    const float t876 = sin_delta * t829;
    const float t877 = motion->constants[33] * t845;
    const float t882 = t877 + t877 + motion->constants[63] + motion->constants[68];
    const float t886 = motion->constants[45] + motion->constants[50] + (t364 * (t800 +
        (motion->constants[56] * t364))) + (t367 * t367 * motion->constants[58]) + (t344 * ((t364 *
        motion->constants[57]) + (t344 * motion->constants[59])));
    const float t888 = t886 + t882 - t876;
    const float t895 = motion->constants[30] * t855;
    const float t896 = (motion->constants[32] * t849) - t895;
    const float t899 = motion->constants[65] + motion->constants[71] - t896 - t896;
    const float t904 = motion->constants[46] + motion->constants[53] + (t344 * t796) + (t403 *
        t798) + (t407 * t802) + t899;
    const float t905 = t904 - t888;
    const float t906 = t9 * t13;
    const float t908 = t9 * t9;
    const float t909 = t866 + t866;
    const float t915 = motion->constants[41] + t845 + motion->constants[62] + motion->constants[72];
    const float t922 = motion->constants[40] + t849 + t855 + motion->constants[67] -
        motion->constants[61];
    const float t928 = t866 + (t905 * t906) + (motion->constants[7] * ((t9 * t915) + (t13 *
        t922))) - (t908 * t909);
    const float t932 = (t13 * t915) - (t9 * t922);
    const float t935 = motion->constants[7] * (t932 - motion->constants[73]);
    const float t939 = motion->constants[7] * t932;
    const float t942 = motion->constants[74] - t939 - t939;
    const float t948 = motion->constants[43] + motion->constants[52] + t876 + t882 + t899 + (t367 *
        t819) + (cos_theta * t821);
    const float t950 = t948 + t942 - (t403 * t825);
    const float t955 = motion->constants[7] * (t806 + t809);
    const float t957 = (t13 * t815) + t955 - (t9 * t836);
    const float t960 = t935 + (t576 * t950) + (t697 * t957);
    const float t965 = (t905 * t908) + (t906 * t909);
    const float t966 = t904 - t965;
    const float t969 = t955 - (t576 * t957) - (t697 * t966);
    const float t971 = 1.0F - t576;
    const float t972 = motion->constants[27] * t783;
    const float t975 = t9 * sin_delta;
    const float t978 = t243 - (cos_delta * t576) - (t697 * t975);
    const float t984 = t229 + (cos_delta * t783) - (t13 * sin_delta) - (t785 * t975);
    const float t985 = motion->constants[28] * t984;
    const float t991 = (t971 * t972) + (t978 * t985) - (t576 * t838) - (t697 * t928) - (t783 *
        t960) - (t785 * t969);
    const float t1010 = t888 + t942 + t965 + (t783 * t838) + (t783 * (t838 + (t783 * t950) - (t785 *
        t957))) + (t783 * t972);
    const float t1013 = t1010 + (t984 * t985) - (t785 * t928) - (t785 * (t928 + (t783 * t957) -
        (t785 * t966)));
    const float t1014 = 1.0F / t1013;
    const float t1015 = t991 * t1014;
    const float t1018 = t116 - (sin_phi * t120);
    const float t1020 = t13 * motion->constants[7] * t809;
    const float t1021 = t811 + t1020;
    const float t1023 = cos_phi * t120;
    const float t1026 = t1021 + (t950 * t1018) - (t957 * t1023);
    const float t1028 = motion->constants[53] + t895;
    const float t1031 = (t13 * t1028) - (t9 * t857);
    const float t1035 = t1031 + (t957 * t1018) - (t966 * t1023);
    const float t1039 = motion->constants[27] * t1018;
    const float t1044 = t238 + (cos_delta * t1018) - (t975 * t1023);
    const float t1045 = motion->constants[28] * t1044;
    const float t1060 = (t9 * t1028) + (t13 * t857) + (motion->constants[7] * t855) + (t838 *
        t1018) + (t783 * t1026) + (t972 * t1018);
    const float t1064 = t1014 * (t1060 + (t985 * t1044) - (t928 * t1023) - (t785 * t1035));
    const float t1065 = t1013 * t1064;
    const float t1071 = motion->constants[53] + (t1018 * t1026) + (t1018 * t1021) + (t1018 *
        t1039) + (t1044 * t1045) - (t1023 * t1035);
    const float t1073 = t1071 - (t1023 * t1031) - (t1064 * t1065);
    const float t1074 = 1.0F / t1073;
    const float t1086 = t1020 + (t971 * t1039) + (t978 * t1045) - (t960 * t1018) - (t969 * t1023) -
        (t576 * t1021);
    const float t1089 = t1074 * (t1086 - (t697 * t1031) - (t1015 * t1065));
    const float t1099 = forces[1] + (t764 * t1023) - t716 - (t695 * t1018) - (t238 * t669) - (t793 *
        t1064);
    const float t1102 = t403 * motion->constants[75];
    const float t1104 = t367 * motion->constants[75];
    const float t1107 = motion->constants[7] * ((t9 * t1102) - (t13 * t1104));
    const float t1117 = (t367 * motion->constants[76]) + (motion->constants[32] * t1102) - t1107 -
        (t403 * motion->constants[77]) - (motion->constants[33] * t1104);
    const float t1121 = cos_theta * motion->constants[75];
    const float t1124 = (t344 * motion->constants[76]) + (t407 * motion->constants[77]) -
        (motion->constants[32] * t1121);
    const float t1130 = (t364 * motion->constants[76]) + (t344 * motion->constants[77]) -
        (motion->constants[33] * t1121);
    const float t1132 = (t13 * t1124) - (t9 * t1130);
    const float t1143 = t1014 * ((t9 * t1124) + (t13 * t1130) + (motion->constants[7] * t1121) +
        (t783 * t1117) - (t785 * t1132));
    const float t1144 = t1013 * t1143;
    const float t1151 = t1074 * ((t1018 * t1117) - (t1023 * t1132) - (t1065 * t1143));
    const float t1152 = t1073 * t1151;
    const float t1162 = motion->constants[78] - (t1143 * t1144) - (t1151 * t1152);
    const float t1163 = 1.0F / t1162;
    const float t1164 = (t1107 + (t576 * t1117) + (t697 * t1132) + (t1015 * t1144) + (t1089 *
        t1152)) * t1163;
    const float t1178 = forces[2] - (motion->constants[3] * t609) - (motion->constants[2] * t632) -
        (positions[6] * motion->constants[5]) - (speeds[2] * motion->constants[6]) - (t793 * t1143);
    const float t1179 = t1178 - (t1099 * t1151);
    const float t1185 = (t576 * t695) + (t697 * t764) + (t1164 * t1179) + t575 - (t243 * t669) -
        (t793 * t1015);
    const float t1206 = (t576 * t960) + (t576 * t935) + motion->constants[79] +
        (motion->constants[27] * t971 * t971) + (motion->constants[28] * t978 * t978) - (t697 *
        t969);
    const float t1211 = (t1185 - (t1089 * t1099)) / (t1206 - (t697 * t955) - (t1013 * t1015 *
        t1015) - (t1073 * t1089 * t1089) - (t1162 * t1164 * t1164));
    const float t1216 = (t1163 * t1179) + (t1164 * t1211);
    const float t1220 = (t1074 * t1099) - (t1151 * t1216) - (t1089 * t1211);
    const float t1226 = (t793 * t1014) - (t1064 * t1220) - (t1143 * t1216) - (t1015 * t1211);
    const float t1234 = t333 + (t84 * t1226) + (t120 * t1220) + (t124 * t1211);
    const float t1238 = (t78 * t1226) + (t116 * t1220) - (sin_phi * t1234) - t335;
    const float t1239 = t1211 + t1238;
    const float t1241 = (motion->constants[7] * t1239) - t160;
    const float t1243 = t159 + (t9 * t1241);
    const float t1248 = t304 - t1243 - (motion->constants[30] * t1238);
    const float t1253 = t166 - (cos_phi * t1234);
    const float t1256 = (t13 * t1226) - t172 - (t9 * t1253);
    const float t1259 = (cos_delta * t1238) - t282 - (sin_delta * t1256);
    const float t1262 = t509 + (motion->constants[47] * t1248) - (motion->constants[48] * t1259);
    const float t1265 = t348 - (t13 * t1241);
    const float t1267 = t358 + (motion->constants[33] * t1238) + t1265;
    const float t1272 = t168 + (t13 * t1253) + (t9 * t1226);
    const float t1278 = t177 + t380 - (motion->constants[7] * (t175 + t1226));
    const float t1281 = t371 - (motion->constants[32] * t1272) - (motion->constants[33] * t1256) -
        t1278;
    const float t1285 = (motion->constants[32] * t1238) - t390 - t1243;
    const float t1288 = (t364 * t1267) + (t367 * t1281) + (t344 * t1285);
    const float t1295 = t422 + (cos_theta * t1238) + (t403 * t1272) - (t367 * t1256);
    const float t1298 = (motion->constants[24] * t1288) + (motion->constants[55] * t1295) - t442;
    const float t1304 = (cos_theta * t1281) + (t403 * t1285) - (t367 * t1267);
    const float t1313 = (t344 * t1256) + (t407 * t1272) + (motion->constants[2] * t1216) - t452 -
        (t403 * t1238);
    const float t1322 = t460 + (t364 * t1256) + (t367 * t1238) + (t344 * t1272) +
        (motion->constants[3] * t1216);
    const float t1326 = t471 + (motion->constants[24] * t1304) + (motion->constants[54] * t1313) -
        (motion->constants[55] * t1322);
    const float t1332 = (t344 * t1267) + (t407 * t1285) - (t403 * t1281);
    const float t1336 = t485 + (motion->constants[24] * t1332) - (motion->constants[54] * t1295);
    const float t1339 = (t344 * t1298) + (t403 * t1326) + (t407 * t1336);
    const float t1343 = t147 + t1262 + t1339 - (motion->constants[44] * t1243) -
        (motion->constants[40] * t1238);
    const float t1351 = (t364 * t1298) + (t344 * t1336) - (t367 * t1326);
    const float t1354 = t1265 + (motion->constants[31] * t1238) - t188;
    const float t1360 = t165 + (motion->constants[30] * t1272) - t1278 - (motion->constants[31] *
        t1256);
    const float t1362 = (cos_delta * t1354) + (sin_delta * t1360);
    const float t1366 = (motion->constants[47] * t1362) + (motion->constants[49] * t1259) - t540;
    const float t1370 = (cos_delta * t1360) - (sin_delta * t1354);
    const float t1372 = t1220 + t1272;
    const float t1377 = t214 + (cos_delta * t1256) + (sin_delta * t1238);
    const float t1381 = t556 + (motion->constants[47] * t1370) + (motion->constants[48] * t1372) -
        (motion->constants[49] * t1377);
    const float t1383 = (cos_delta * t1366) - (sin_delta * t1381);
    const float t1387 = (motion->constants[44] * t1265) + (motion->constants[41] * t1238) + t1351 +
        t1383 - t567;
    const float t1389 = (t9 * t1343) + (t13 * t1387);
    const float t1397 = motion->constants[28] * (t667 + t1259 + (t229 * t1226) + (t238 * t1220) +
        (t243 * t1211));
    const float t1398 = t228 * t1397;
    const float t1409 = t606 + (motion->constants[56] * t1322) + (motion->constants[57] * t1313) -
        (motion->constants[55] * t1304);
    const float t1416 = t619 + (motion->constants[55] * t1288) + (motion->constants[58] * t1295) -
        (motion->constants[54] * t1332);
    const float t1423 = t629 + (motion->constants[54] * t1304) + (motion->constants[57] * t1322) +
        (motion->constants[59] * t1313);
    const float t1432 = t652 + (motion->constants[50] * t1377) + (motion->constants[51] * t1372) -
        (motion->constants[49] * t1370);
    const float t1440 = t675 + t1397 + (motion->constants[49] * t1362) + (motion->constants[52] *
        t1259) - (motion->constants[48] * t1248);
    const float t1449 = t592 + (motion->constants[41] * t1265) + (motion->constants[40] * t1243) +
        (motion->constants[43] * t1238) + (motion->constants[27] * t1239) + (t367 * t1409);
    const float t1454 = t1449 + (cos_theta * t1416) + (motion->constants[33] * t1351) +
        (motion->constants[32] * t1339) + (sin_delta * t1432) + (cos_delta * t1440);
    const float t1458 = t1454 + (motion->constants[31] * t1383) - (t403 * t1423) -
        (motion->constants[30] * t1262) - (motion->constants[7] * t1389);
    const float t1473 = (t367 * t1298) + (cos_theta * t1326) - (t403 * t1336);
    const float t1477 = (sin_delta * t1366) + (cos_delta * t1381);
    const float t1484 = t707 + t713 + (motion->constants[42] * t1256) + (motion->constants[46] *
        t1272) + (motion->constants[48] * t1370) + (motion->constants[51] * t1377) +
        (motion->constants[53] * t1372);
    const float t1489 = t1484 + (t344 * t1409) + (t403 * t1416) + (t407 * t1423) +
        (motion->constants[30] * t1477) - (motion->constants[40] * t1278);
    const float t1506 = t745 + (motion->constants[41] * t1278) + (motion->constants[45] * t1256) +
        (motion->constants[42] * t1272) + (t364 * t1409) + (t344 * t1423);
    const float t1511 = t1506 + (cos_delta * t1432) - (t367 * t1416) - (motion->constants[33] *
        t1473) - (sin_delta * t1440) - (motion->constants[31] * t1477);
    const float t1516 = (sin_phi * t1458) + (cos_phi * ((t13 * (t1489 - (motion->constants[32] *
        t1473))) - (t9 * t1511)));
    const float t1518 = t82 * (t1516 - (t225 * t1398));
    const float t1520 = (t36 * t1398) - (t43 * t1518);
    const float t1521 = t1389 - t1520;
    const float t1526 = (t43 * t1398) + (t36 * t1518);
    const float t1534 = t775 + t1473 + t1477 + (motion->constants[40] * t1272) -
        (motion->constants[44] * t1278) - (motion->constants[41] * t1256);
    const float t1538 = (t13 * t1343) - (t9 * t1387);
    const float t1541 = (cos_phi * t1534) - t1526 - (sin_phi * t1538);
    const float t1543 = (cos_psi * t1521) - (sin_psi * t1541);
    const float t1546 = (t1521 * sin_psi) + (cos_psi * t1541);
    const float t1551 = t77 * (t1458 - (t75 * t1518) - (t221 * t1398));
    const float t1555 = t1551 + (sin_phi * t1534) + (cos_phi * t1538);
    const float t1558 = (cos_psi * t1520) - (sin_psi * t1526);
    const float t1561 = (t1520 * sin_psi) + (cos_psi * t1526);
    const float t1562 = -t1551;
    contact_forces[0] = t1543;
    contact_forces[1] = t1546;
    contact_forces[2] = t1555;
    contact_forces[3] = t1558;
    contact_forces[4] = t1561;
    contact_forces[5] = t1562;
}

carvallo_motion_error_t whipple_leaning_f32_motion_contact_forces(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    const float forces[WHIPPLE_LEANING_FORCES], float contact_forces[3U * WHIPPLE_LEANING_WHEELS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_LEANING_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_LEANING_FORCES)) {
        whipple_leaning_f32_compute_contact_forces(motion, positions, speeds, forces,
            contact_forces);
        error = (carvallo_are_finite_f32(contact_forces, 3U * WHIPPLE_LEANING_WHEELS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}
