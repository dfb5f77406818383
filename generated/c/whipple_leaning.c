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
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 72U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 72U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 57U, true},
    {CARVALLO_MATRIX_M, 1U, 2U, 0U, 31U, true},
    {CARVALLO_MATRIX_M, 2U, 1U, 0U, 31U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 65U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 56U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 75U, true},
    {CARVALLO_MATRIX_C1, 2U, 1U, 0U, 66U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 80U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 80U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 86U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 68U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 85U, true},
    {CARVALLO_MATRIX_K2, 2U, 1U, 0U, 71U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 73U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 73U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 58U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 1U, 59U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 1U, 59U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 67U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 50U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 76U, true},
    {CARVALLO_MATRIX_C1, 2U, 1U, 1U, 70U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 81U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 81U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 82U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 83U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 94U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 94U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 63U, true},
    {CARVALLO_MATRIX_M, 1U, 2U, 2U, 90U, true},
    {CARVALLO_MATRIX_M, 2U, 1U, 2U, 90U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 69U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 89U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 84U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 2U, 96U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 95U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 95U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 108U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 87U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 107U, false},
    {CARVALLO_MATRIX_K2, 2U, 1U, 2U, 88U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 30U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 4U, 52U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 4U, 49U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 1U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 4U, 53U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 12U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 28U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 0U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 5U, 39U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 10U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 98U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 6U, 97U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 7U, 40U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 7U, 40U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 7U, 41U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 8U, 100U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 8U, 100U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 8U, 104U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 8U, 106U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 8U, 117U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 8U, 99U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 8U, 99U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 8U, 101U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 102U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 21U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 48U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 48U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 9U, 112U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 3U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 9U, 111U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 14U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 10U, 45U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 10U, 45U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 10U, 46U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 10U, 113U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 10U, 115U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 10U, 2U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 10U, 44U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 10U, 44U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 10U, 47U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 10U, 103U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 10U, 114U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 11U, 10U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 13U, 98U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 13U, 97U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 14U, 27U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 14U, 27U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 14U, 38U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 15U, 32U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 15U, 32U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 54U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 118U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 78U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 119U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 119U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 92U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 120U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 15U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 34U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 34U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 55U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 77U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 79U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 5U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 91U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 91U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 122U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 116U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 93U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 16U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 35U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 35U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 36U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 124U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 74U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 33U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 33U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 37U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 123U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 42U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 18U, 10U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 18U, 11U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 18U, 11U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 18U, 121U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 20U, 125U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 20U, 43U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 21U, 29U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 21U, 29U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 21U, 127U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 21U, 38U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 21U, 109U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 22U, 17U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 22U, 128U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 22U, 128U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 129U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 22U, 135U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 22U, 131U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 22U, 136U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 22U, 7U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 22U, 137U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 22U, 137U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 22U, 138U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 134U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 22U, 139U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 23U, 18U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 141U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 141U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 142U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 145U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 146U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 6U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 140U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 140U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 143U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 144U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 110U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 10U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 11U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 11U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 126U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 43U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 130U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 130U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 132U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 133U, false},
    {CARVALLO_MATRIX_M, 0U, 2U, 26U, 13U, true},
    {CARVALLO_MATRIX_M, 1U, 2U, 26U, 51U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 26U, 13U, true},
    {CARVALLO_MATRIX_M, 2U, 1U, 26U, 51U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 26U, 25U, true},
    {CARVALLO_MATRIX_C1, 2U, 1U, 26U, 148U, false},
    {CARVALLO_MATRIX_K0, 0U, 2U, 26U, 8U, true},
    {CARVALLO_MATRIX_K0, 2U, 0U, 26U, 8U, true},
    {CARVALLO_MATRIX_K0, 2U, 2U, 26U, 8U, true},
    {CARVALLO_MATRIX_K2, 2U, 1U, 26U, 147U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 27U, 19U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 27U, 151U, true},
    {CARVALLO_MATRIX_M, 0U, 2U, 27U, 23U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 27U, 151U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 27U, 154U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 27U, 152U, true},
    {CARVALLO_MATRIX_M, 2U, 0U, 27U, 23U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 27U, 152U, true},
    {CARVALLO_MATRIX_M, 2U, 2U, 27U, 24U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 27U, 157U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 27U, 156U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 27U, 159U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 27U, 9U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 27U, 149U, true},
    {CARVALLO_MATRIX_K0, 0U, 2U, 27U, 22U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 27U, 149U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 27U, 150U, true},
    {CARVALLO_MATRIX_K0, 2U, 0U, 27U, 22U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 27U, 22U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 27U, 155U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 27U, 153U, false},
    {CARVALLO_MATRIX_K2, 2U, 1U, 27U, 158U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 28U, 61U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 28U, 61U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 28U, 105U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 28U, 64U, true},
    {CARVALLO_MATRIX_M, 2U, 1U, 28U, 64U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 28U, 160U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 28U, 162U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 28U, 70U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 28U, 60U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 28U, 60U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 28U, 62U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 28U, 161U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 29U, 20U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 29U, 51U, true},
    {CARVALLO_MATRIX_M, 0U, 2U, 29U, 26U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 29U, 51U, true},
    {CARVALLO_MATRIX_M, 1U, 2U, 29U, 51U, true},
    {CARVALLO_MATRIX_M, 2U, 0U, 29U, 26U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 29U, 51U, true},
    {CARVALLO_MATRIX_M, 2U, 2U, 29U, 25U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 29U, 148U, true},
    {CARVALLO_MATRIX_C1, 2U, 1U, 29U, 148U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 29U, 8U, false},
    {CARVALLO_MATRIX_K0, 0U, 2U, 29U, 8U, false},
    {CARVALLO_MATRIX_K0, 2U, 0U, 29U, 8U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 29U, 8U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 29U, 147U, true},
    {CARVALLO_MATRIX_K2, 2U, 1U, 29U, 147U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 30U, 10U, false},
    {CARVALLO_MATRIX_M, 0U, 2U, 30U, 10U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 30U, 10U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 30U, 10U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 32U, 98U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 32U, 97U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 33U, 27U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 33U, 27U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 33U, 27U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 33U, 27U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 33U, 38U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 33U, 38U, false},
    {CARVALLO_MATRIX_KC, 2U, 2U, 34U, 10U, false},
    {CARVALLO_MATRIX_C0, 2U, 2U, 35U, 10U, false}
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
    const double t2 = p->zB * p->mB;
    const double t7 = p->zH * p->mH;
    const double t15 = p->rR * p->mR;
    const double ay_theta3_delta = p->IUxx + (p->rR * t15);
    const double t21 = p->rF * p->mF;
    const double t25 = p->IFxx + ((p->rF * t21) + p->IHxx);
    const double t28 = p->zU * p->mU;
    const double M_11 = (p->zB * t2) + (p->IRxx + (p->zH * t7)) + (p->IBxx + (ay_theta3_delta +
        (t25 + (p->zU * t28))));
    double wx_delta2_delta = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &wx_delta2_delta, &cos_lam);
    const double yaw_per_v_delta = cos_lam / p->w;
    const double yaw_by_delta = p->c * yaw_per_v_delta;
    const double t48 = (t28 * p->xU) - (p->IUxz + p->IBxz - (t2 * p->xB));
    const double wz_delta2_delta = cos_lam + yaw_by_delta;
    const double t58 = (p->zH * wx_delta2_delta) + (cos_lam * (p->c + p->w)) - (p->xH *
        wz_delta2_delta);
    const double t59 = p->mH * t58;
    const double t63 = wz_delta2_delta * p->IHxz;
    const double t65 = t63 + (t25 * wx_delta2_delta);
    const double t67 = p->zP - p->zU;
    const double M_13 = p->IUxx - (t28 * t67);
    const double t72 = wz_delta2_delta * (p->IFxx + p->IHzz);
    const double h_wheels_all = p->mU * p->xU;
    const double t83 = p->mB * p->xB;
    const double vy_theta3_delta = t83 * p->xB;
    const double t88 = yaw_by_delta * ((p->xU * h_wheels_all) + p->IUzz + (p->IBzz + (p->IRxx +
        vy_theta3_delta)));
    const double M_22 = (wz_delta2_delta * t72) + (wx_delta2_delta * (t63 + t65)) + ((t58 * t59) +
        (yaw_by_delta * t88));
    const double t93 = p->IUxz + (h_wheels_all * t67);
    const double M_23 = t93 * yaw_by_delta;
    const double t95 = p->mU * t67;
    const double M_33 = p->IUxx + (t95 * t67);
    const double t101 = p->IHxz + (t21 * p->w);
    const double t105 = p->IRyy / p->rR;
    const double K0_11 = t2 + t28 + (t7 - t21) - t15;
    const double t110 = t105 - K0_11;
    const double vy_spin_F5_delta = p->c * t110;
    const double h_spin_F = p->IFyy / p->rF;
    const double t117 = wz_delta2_delta * h_spin_F;
    const double C1_12 = ((t101 - (t7 * p->xH) - (t48 - vy_spin_F5_delta)) * yaw_per_v_delta) +
        t117;
    const double ay_all1_delta = t83 + h_wheels_all;
    const double K0_12 = t59 - (yaw_by_delta * ay_all1_delta) - (t21 * wx_delta2_delta);
    const double C1_22 = yaw_per_v_delta * ((t101 * wx_delta2_delta) - (p->xH * t59) + (t72 + (t88 -
        (p->c * K0_12))));
    const double C1_32 = (t93 + (p->c * t95)) * yaw_per_v_delta;
    const double K0_22 = wx_delta2_delta * K0_12;
    const double K2_12 = yaw_per_v_delta * (h_spin_F + t110);
    const double ay_delta2_delta = (wx_delta2_delta * h_spin_F) - K0_12;
    const double K2_22 = yaw_per_v_delta * ay_delta2_delta;
    const double K2_32 = yaw_per_v_delta * t95;
    const double M_12 = t65 - ((yaw_by_delta * t48) - (p->zH * t59));
    const double C1_21 = -(t117 + (yaw_by_delta * t105));
    const double K0_13 = -t95;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = M_23;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_23;
    matrices->m[2][2] = M_33;
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
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[0][2] = K0_13;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0;
    matrices->k0[2][0] = K0_13;
    matrices->k0[2][1] = 0.0;
    matrices->k0[2][2] = K0_13;
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
    double wx_delta2_delta = 0.0;
    double wx_delta2_delta_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const double M_11_mR = p->rR * p->rR;
    const double t37 = p->zH * p->mH;
    const double t38 = p->rF * p->mF;
    const double t43 = p->IHxx + p->IFxx + (p->zH * t37) + (p->rF * t38);
    const double t44 = p->zU * p->mU;
    const double M_11_mB = p->zB * p->zB;
    const double M_11_zH = t37 + t37;
    const double M_11_mH = p->zH * p->zH;
    const double M_11_rF = t38 + t38;
    const double M_11_mF = p->rF * p->rF;
    const double M_11_mU = p->zU * p->zU;
    const double M_11_zU = t44 + t44;
    const double t52 = p->zB * p->mB;
    const double M_11_zB = t52 + t52;
    const double t54 = 1.0 / p->w;
    const double t56 = (t37 * p->xH) - p->IHxz;
    const double t63 = (p->mR * M_11_mR) + t43 + p->IRxx + p->IUxx + (p->zU * t44) + p->IBxx;
    const double M_11 = t63 + (p->zB * t52);
    const double t66 = p->c * t54;
    const double t67 = p->c + p->w;
    const double t68 = p->mB * p->xB;
    const double t73 = (p->zB * t68) + (t44 * p->xU) - p->IBxz - p->IUxz;
    const double K0_13_mU = p->zU - p->zP;
    const double M_13_mU = p->zU * K0_13_mU;
    const double M_33_mU = K0_13_mU * K0_13_mU;
    const double K0_13 = p->mU * K0_13_mU;
    const double M_13 = p->IUxx + (p->zU * K0_13);
    const double M_33 = p->IUxx + (K0_13_mU * K0_13);
    const double M_33_zU = K0_13 + K0_13;
    const double M_13_zU = t44 + K0_13;
    const double t84 = p->mH * p->xH;
    const double vy_theta3_delta = p->xH * t84;
    const double t87 = p->IFxx + p->IHzz + vy_theta3_delta;
    const double h_wheels_all = p->mU * p->xU;
    const double t94 = p->IRxx + p->IUzz + (p->xB * t68) + p->IBzz + (p->xU * h_wheels_all);
    const double yaw_by_delta = wx_delta2_delta_lam * t66;
    const double t96 = wx_delta2_delta_lam * t67;
    const double t97 = t56 * wx_delta2_delta;
    const double t98 = p->zH * wx_delta2_delta;
    const double t100 = p->IUxz - (K0_13_mU * h_wheels_all);
    const double t101 = 1.0 / p->rF;
    const double t102 = t56 + t73;
    const double t103 = t38 * p->w;
    const double C1_12_mR = p->rR * yaw_by_delta;
    const double wz_delta2_delta = wx_delta2_delta_lam + yaw_by_delta;
    const double t106 = t96 + t98;
    const double M_23 = yaw_by_delta * t100;
    const double h_spin_F = p->IFyy * t101;
    const double t109 = p->mR * p->rR;
    const double M_11_rR = t109 + t109;
    const double t111 = t37 - t38;
    const double K0_11 = t44 + t52 + t111 - t109;
    const double t115 = t54 * M_23;
    const double t118 = (wx_delta2_delta_lam * t111) + (wx_delta2_delta * t84);
    const double t119 = t37 * wz_delta2_delta;
    const double t124 = (t43 * wx_delta2_delta) + (t37 * t96) - (wz_delta2_delta * t56);
    const double t128 = t97 + (t96 * t84) - (wz_delta2_delta * t87);
    const double M_22_yaw_per_v_delta = t37 * wx_delta2_delta_lam;
    const double t131 = t68 + t84 + h_wheels_all;
    const double t132 = wz_delta2_delta * p->xH;
    const double K0_12_mH = t106 - t132;
    const double t134 = t132 - t106;
    const double M_12_zH = p->mH * (t98 - t134);
    const double t137 = p->zH * t134;
    const double M_22_mH = t134 * t134;
    const double t139 = wx_delta2_delta * t134;
    const double t140 = p->mH * t134;
    const double t141 = 1.0 / p->rR;
    const double t142 = wx_delta2_delta_lam * h_spin_F;
    const double yaw_per_v_delta = wx_delta2_delta_lam * t54;
    const double M_12 = t124 - (yaw_by_delta * t73);
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double C1_12_IRyy = yaw_by_delta * t141;
    const double K2_12_IRyy = t141 * yaw_per_v_delta;
    const double K2_22_mH = t134 * yaw_per_v_delta;
    const double C1_22_IHzz = wz_delta2_delta * yaw_per_v_delta;
    const double t152 = (yaw_by_delta * t94) - t128;
    const double t156 = yaw_per_v_delta * (t87 + t94 + (p->c * t131));
    const double t157 = p->IRyy * t141;
    const double t158 = t141 * t157;
    const double t159 = h_spin_F + t157;
    const double t160 = yaw_by_delta * p->xB;
    const double t161 = p->zB * t160;
    const double M_22_mB = t160 * t160;
    const double t163 = wx_delta2_delta * t160;
    const double M_23_yaw_per_v_delta = (t66 * t152) - t128 - (t67 * t140);
    const double t168 = K0_11 - t159;
    const double t169 = p->mB * t160;
    const double C1_21_rR = yaw_by_delta * t158;
    const double t171 = p->mR - t158;
    const double t172 = t159 * yaw_per_v_delta;
    const double t173 = t38 * wx_delta2_delta;
    const double M_23_zP = yaw_by_delta * h_wheels_all;
    const double t177 = t140 + t169 + t173 + M_23_zP;
    const double t178 = p->c * t172;
    const double t179 = t140 + t140;
    const double C1_12_rR = yaw_by_delta * t171;
    const double K2_12_rR = yaw_per_v_delta * t171;
    const double M_22_xH = wz_delta2_delta * t179;
    const double t183 = wx_delta2_delta * t179;
    const double t184 = wx_delta2_delta_lam * t179;
    const double t188 = t54 * (t102 + (p->c * t168) - t103);
    const double C1_21_w = t54 * t178;
    const double C1_21 = -(t142 + t178);
    const double K0_12 = -t177;
    const double K0_22 = -(wx_delta2_delta * t177);
    const double M_22 = (wx_delta2_delta_lam * M_23_yaw_per_v_delta) + (wx_delta2_delta * t124);
    const double t200 = (wx_delta2_delta * M_23_yaw_per_v_delta) - (wx_delta2_delta_lam * t124);
    const double t204 = t152 + (p->c * t177) + (p->w * t173);
    const double t205 = t152 * yaw_per_v_delta;
    const double t206 = t205 + t205;
    const double t208 = (t66 * t206) + t184;
    const double M_22_c = t206 - t184;
    const double M_23_c = t100 * yaw_per_v_delta;
    const double t211 = p->mU * yaw_by_delta;
    const double t212 = p->zU * t211;
    const double t213 = wx_delta2_delta * t211;
    const double t214 = t200 + t200;
    const double t215 = K0_13_mU * t211;
    const double C1_32 = M_23_c - t215;
    const double C1_12_w = yaw_per_v_delta * (t38 + t188);
    const double t219 = t54 * C1_32;
    const double ay_all1_delta = h_spin_F - t188;
    const double t221 = t168 * yaw_per_v_delta;
    const double C1_22 = yaw_per_v_delta * t204;
    const double t224 = t204 + (p->c * t156);
    const double K2_12_w = t54 * t221;
    const double K2_12 = -t221;
    const double C1_12 = wx_delta2_delta_lam * ay_all1_delta;
    const double t228 = wx_delta2_delta * ay_all1_delta;
    const double t229 = wx_delta2_delta * h_spin_F;
    const double t230 = t177 + t229;
    const double K2_22 = yaw_per_v_delta * t230;
    const double t232 = K0_13 * yaw_per_v_delta;
    const double K2_32_w = t54 * t232;
    const double K2_32 = -t232;
    const double t235 = t102 * yaw_per_v_delta;
    const double M_12_w = M_22_yaw_per_v_delta + (t66 * t235);
    const double M_12_c = M_22_yaw_per_v_delta - t235;
    const double t239 = p->mH * wx_delta2_delta_lam;
    const double t240 = p->c + p->xH;
    const double C1_22_mH = t240 * K2_22_mH;
    const double t242 = t239 * t240;
    const double t246 = yaw_per_v_delta * ((t54 * t224) + t242 - t173);
    const double t249 = yaw_per_v_delta * (t242 - t177 - t156);
    const double t250 = t54 * t242;
    const double C1_22_xH = (wz_delta2_delta * t250) + (p->mH * K2_22_mH);
    const double t254 = wx_delta2_delta * t250;
    const double t255 = yaw_per_v_delta * t131;
    const double K0_12_w = t239 + (t66 * t255);
    const double K0_12_c = t239 - t255;
    const double K0_22_c = wx_delta2_delta * K0_12_c;
    const double t260 = yaw_per_v_delta * K0_12_c;
    const double t261 = t54 * wx_delta2_delta;
    const double vy_spin_F5_delta = (wx_delta2_delta * t87) + (p->c * t118) - (wx_delta2_delta_lam *
        (t103 - t56));
    const double C1_22_lam = (t67 * t254) - (t224 * t261) - (yaw_per_v_delta * vy_spin_F5_delta);
    const double t275 = (t54 * K2_22) + (yaw_per_v_delta * K0_12_w);
    const double K0_22_w = wx_delta2_delta * K0_12_w;
    const double K2_12_lam = t168 * t261;
    const double K2_32_lam = K0_13 * t261;
    const double t279 = p->c * t261;
    const double C1_21_lam = t229 + (t159 * t279);
    const double t282 = t100 * t279;
    const double K0_12_zH = p->mH * wx_delta2_delta;
    const double t284 = wz_delta2_delta * K0_12_zH;
    const double t285 = yaw_per_v_delta * K0_12_zH;
    const double t286 = t67 * K0_12_zH;
    const double M_12_lam = t97 + (t43 * wx_delta2_delta_lam) + (t102 * t279) - (p->zH * t286);
    const double K0_12_lam = t118 + (t131 * t279) - t286;
    const double t296 = p->c + p->xU;
    const double t299 = t261 * (p->IUxz - (K0_13 * t296));
    const double C1_22_vy_theta3_delta = yaw_by_delta * yaw_per_v_delta;
    const double M_22_vy_theta3_delta = p->c * C1_22_vy_theta3_delta;
    const double t302 = M_22_vy_theta3_delta + M_22_vy_theta3_delta;
    const double t303 = p->mB * yaw_by_delta;
    const double t304 = p->zB * t303;
    const double t305 = wx_delta2_delta * t303;
    const double K2_22_xB = yaw_per_v_delta * t303;
    const double t307 = p->zB * yaw_per_v_delta;
    const double M_22_xB = t68 * t302;
    const double M_22_xU = h_wheels_all * t302;
    const double t310 = p->mB * t307;
    const double K2_22_lam = (yaw_per_v_delta * (t142 - K0_12_lam)) - (t230 * t261);
    const double K0_22_lam = (wx_delta2_delta * K0_12_lam) - (wx_delta2_delta_lam * t177);
    const double K2_22_h_spin_F = wx_delta2_delta_lam * t261;
    const double K2_22_mF = p->rF * K2_22_h_spin_F;
    const double t320 = p->mB * yaw_per_v_delta;
    const double t321 = p->xB * t320;
    const double t322 = t303 + t321;
    const double t323 = p->c + p->xB;
    const double t324 = t307 * t323;
    const double K2_22_mB = p->xB * C1_22_vy_theta3_delta;
    const double C1_22_mB = t323 * K2_22_mB;
    const double t327 = p->mH * yaw_per_v_delta;
    const double C1_22_xB = yaw_by_delta * (t321 + t322);
    const double t330 = p->zH * t327;
    const double t331 = p->mH * wz_delta2_delta;
    const double K2_22_xH = yaw_per_v_delta * t331;
    const double M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const double K0_22_zH = p->mH * M_22_IHxx;
    const double t335 = p->zH * yaw_per_v_delta;
    const double t336 = t240 * t335;
    const double M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double t339 = wx_delta2_delta + wx_delta2_delta;
    const double M_22_IHxz = wz_delta2_delta * t339;
    const double M_12_rF = t38 * t339;
    const double M_22_rF = wx_delta2_delta * M_12_rF;
    const double C1_12_IFyy = wz_delta2_delta * t101;
    const double C1_21_rF = h_spin_F * C1_12_IFyy;
    const double K2_12_IFyy = t101 * yaw_per_v_delta;
    const double K2_22_IFyy = wx_delta2_delta * K2_12_IFyy;
    const double t347 = p->mF * yaw_per_v_delta;
    const double K2_12_rF = t347 - (h_spin_F * K2_12_IFyy);
    const double t350 = t67 * t347;
    const double C1_12_rF = t350 - C1_21_rF;
    const double C1_22_rF = wx_delta2_delta * t350;
    const double t353 = p->mF * wx_delta2_delta;
    const double t354 = wx_delta2_delta * t353;
    const double K2_22_rF = wx_delta2_delta * K2_12_rF;
    const double t356 = p->rF * wx_delta2_delta;
    const double M_12_mF = p->rF * t356;
    const double M_22_mF = t356 * t356;
    const double t359 = wx_delta2_delta * t356;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double C1_12_mF = t67 * K2_12_mF;
    const double C1_22_mF = wx_delta2_delta * C1_12_mF;
    const double K2_32_zP = p->mU * yaw_per_v_delta;
    const double C1_32_zP = t296 * K2_32_zP;
    const double t365 = p->c * p->xU;
    const double t366 = yaw_per_v_delta * t365;
    const double t367 = wx_delta2_delta * t366;
    const double t368 = p->zU * t366;
    const double t369 = K0_13_mU * t366;
    const double K2_22_mU = p->xU * C1_22_vy_theta3_delta;
    const double M_22_mU = t365 * K2_22_mU;
    const double t372 = p->zU * yaw_per_v_delta;
    const double C1_22_mU = t296 * K2_22_mU;
    const double t374 = t296 * t372;
    const double t375 = K0_13_mU * yaw_per_v_delta;
    const double t376 = t296 * t375;
    const double t377 = p->mU * t372;
    const double K2_22_xU = p->mU * C1_22_vy_theta3_delta;
    const double C1_22_xU = (p->xU + t296) * K2_22_xU;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = M_23;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_23;
    matrices->m[2][2] = M_33;
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
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[0][2] = K0_13;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0;
    matrices->k0[2][0] = K0_13;
    matrices->k0[2][1] = 0.0;
    matrices->k0[2][2] = K0_13;
    matrices->k2[0][0] = 0.0;
    matrices->k2[0][1] = K2_12;
    matrices->k2[0][2] = 0.0;
    matrices->k2[1][0] = 0.0;
    matrices->k2[1][1] = K2_22;
    matrices->k2[1][2] = 0.0;
    matrices->k2[2][0] = 0.0;
    matrices->k2[2][1] = K2_32;
    matrices->k2[2][2] = 0.0;
    derivatives->values[0] = p->rR;
    derivatives->values[1] = p->mR;
    derivatives->values[2] = p->zB;
    derivatives->values[3] = p->mB;
    derivatives->values[4] = p->zH;
    derivatives->values[5] = p->mH;
    derivatives->values[6] = p->rF;
    derivatives->values[7] = p->mF;
    derivatives->values[8] = p->mU;
    derivatives->values[9] = p->zU;
    derivatives->values[10] = 1.0;
    derivatives->values[11] = wx_delta2_delta;
    derivatives->values[12] = M_11_mR;
    derivatives->values[13] = t44;
    derivatives->values[14] = M_11_mB;
    derivatives->values[15] = M_11_zH;
    derivatives->values[16] = M_11_mH;
    derivatives->values[17] = M_11_rF;
    derivatives->values[18] = M_11_mF;
    derivatives->values[19] = M_11_mU;
    derivatives->values[20] = M_11_zU;
    derivatives->values[21] = M_11_zB;
    derivatives->values[22] = K0_13_mU;
    derivatives->values[23] = M_13_mU;
    derivatives->values[24] = M_33_mU;
    derivatives->values[25] = M_33_zU;
    derivatives->values[26] = M_13_zU;
    derivatives->values[27] = yaw_by_delta;
    derivatives->values[28] = C1_12_mR;
    derivatives->values[29] = wz_delta2_delta;
    derivatives->values[30] = M_11_rR;
    derivatives->values[31] = t115;
    derivatives->values[32] = t119;
    derivatives->values[33] = K0_12_mH;
    derivatives->values[34] = M_12_zH;
    derivatives->values[35] = t137;
    derivatives->values[36] = M_22_mH;
    derivatives->values[37] = t139;
    derivatives->values[38] = yaw_per_v_delta;
    derivatives->values[39] = K2_12_mR;
    derivatives->values[40] = C1_12_IRyy;
    derivatives->values[41] = K2_12_IRyy;
    derivatives->values[42] = K2_22_mH;
    derivatives->values[43] = C1_22_IHzz;
    derivatives->values[44] = t160;
    derivatives->values[45] = t161;
    derivatives->values[46] = M_22_mB;
    derivatives->values[47] = t163;
    derivatives->values[48] = t169;
    derivatives->values[49] = C1_21_rR;
    derivatives->values[50] = t172;
    derivatives->values[51] = M_23_zP;
    derivatives->values[52] = C1_12_rR;
    derivatives->values[53] = K2_12_rR;
    derivatives->values[54] = M_22_xH;
    derivatives->values[55] = t183;
    derivatives->values[56] = C1_21_w;
    derivatives->values[57] = t208;
    derivatives->values[58] = M_22_c;
    derivatives->values[59] = M_23_c;
    derivatives->values[60] = t211;
    derivatives->values[61] = t212;
    derivatives->values[62] = t213;
    derivatives->values[63] = t214;
    derivatives->values[64] = t215;
    derivatives->values[65] = C1_12_w;
    derivatives->values[66] = t219;
    derivatives->values[67] = t221;
    derivatives->values[68] = K2_12_w;
    derivatives->values[69] = t228;
    derivatives->values[70] = t232;
    derivatives->values[71] = K2_32_w;
    derivatives->values[72] = M_12_w;
    derivatives->values[73] = M_12_c;
    derivatives->values[74] = C1_22_mH;
    derivatives->values[75] = t246;
    derivatives->values[76] = t249;
    derivatives->values[77] = t250;
    derivatives->values[78] = C1_22_xH;
    derivatives->values[79] = t254;
    derivatives->values[80] = K0_12_w;
    derivatives->values[81] = K0_12_c;
    derivatives->values[82] = K0_22_c;
    derivatives->values[83] = t260;
    derivatives->values[84] = C1_22_lam;
    derivatives->values[85] = t275;
    derivatives->values[86] = K0_22_w;
    derivatives->values[87] = K2_12_lam;
    derivatives->values[88] = K2_32_lam;
    derivatives->values[89] = C1_21_lam;
    derivatives->values[90] = t282;
    derivatives->values[91] = K0_12_zH;
    derivatives->values[92] = t284;
    derivatives->values[93] = t285;
    derivatives->values[94] = M_12_lam;
    derivatives->values[95] = K0_12_lam;
    derivatives->values[96] = t299;
    derivatives->values[97] = C1_22_vy_theta3_delta;
    derivatives->values[98] = M_22_vy_theta3_delta;
    derivatives->values[99] = t303;
    derivatives->values[100] = t304;
    derivatives->values[101] = t305;
    derivatives->values[102] = K2_22_xB;
    derivatives->values[103] = t307;
    derivatives->values[104] = M_22_xB;
    derivatives->values[105] = M_22_xU;
    derivatives->values[106] = t310;
    derivatives->values[107] = K2_22_lam;
    derivatives->values[108] = K0_22_lam;
    derivatives->values[109] = K2_22_h_spin_F;
    derivatives->values[110] = K2_22_mF;
    derivatives->values[111] = t320;
    derivatives->values[112] = t322;
    derivatives->values[113] = t324;
    derivatives->values[114] = K2_22_mB;
    derivatives->values[115] = C1_22_mB;
    derivatives->values[116] = t327;
    derivatives->values[117] = C1_22_xB;
    derivatives->values[118] = t330;
    derivatives->values[119] = t331;
    derivatives->values[120] = K2_22_xH;
    derivatives->values[121] = M_22_IHxx;
    derivatives->values[122] = K0_22_zH;
    derivatives->values[123] = t335;
    derivatives->values[124] = t336;
    derivatives->values[125] = M_22_IHzz;
    derivatives->values[126] = M_22_IFxx;
    derivatives->values[127] = M_22_IHxz;
    derivatives->values[128] = M_12_rF;
    derivatives->values[129] = M_22_rF;
    derivatives->values[130] = C1_12_IFyy;
    derivatives->values[131] = C1_21_rF;
    derivatives->values[132] = K2_12_IFyy;
    derivatives->values[133] = K2_22_IFyy;
    derivatives->values[134] = K2_12_rF;
    derivatives->values[135] = C1_12_rF;
    derivatives->values[136] = C1_22_rF;
    derivatives->values[137] = t353;
    derivatives->values[138] = t354;
    derivatives->values[139] = K2_22_rF;
    derivatives->values[140] = t356;
    derivatives->values[141] = M_12_mF;
    derivatives->values[142] = M_22_mF;
    derivatives->values[143] = t359;
    derivatives->values[144] = K2_12_mF;
    derivatives->values[145] = C1_12_mF;
    derivatives->values[146] = C1_22_mF;
    derivatives->values[147] = K2_32_zP;
    derivatives->values[148] = C1_32_zP;
    derivatives->values[149] = t366;
    derivatives->values[150] = t367;
    derivatives->values[151] = t368;
    derivatives->values[152] = t369;
    derivatives->values[153] = K2_22_mU;
    derivatives->values[154] = M_22_mU;
    derivatives->values[155] = t372;
    derivatives->values[156] = C1_22_mU;
    derivatives->values[157] = t374;
    derivatives->values[158] = t375;
    derivatives->values[159] = t376;
    derivatives->values[160] = t377;
    derivatives->values[161] = K2_22_xU;
    derivatives->values[162] = C1_22_xU;
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

static void whipple_leaning_f64_compute_linearization(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    const double forces[WHIPPLE_LEANING_FORCES], whipple_leaning_f64_linearization_t *linearization)
{
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t6 = motion->constants[7] * sin_phi;
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t14 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t18 = t14 * cos_phi;
    const double t21 = sin_phi * sin_delta;
    const double t22 = t21 - (cos_delta * t18);
    const double t26 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const double t27 = cos_phi * t26;
    const double t30 = sqrt((t22 * t22) + (t27 * t27));
    const double t31 = 1.0 / t30;
    const double t32 = t22 * t31;
    const double t34 = t27 * t31;
    const double t35 = cos_delta * t34;
    const double t37 = (t26 * t35) - (t14 * t32);
    const double t39 = sin_phi * cos_delta;
    const double t40 = t18 * sin_delta;
    const double t41 = t39 + t40;
    const double t42 = motion->constants[8] * t41;
    const double t45 = sin_delta * motion->constants[37];
    const double t51 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const double t53 = (t26 * motion->constants[39]) - (t14 * t51);
    const double t56 = (cos_phi * t45) - (t37 * t42) - (sin_phi * t53);
    const double t57 = t6 + t56;
    const double t58 = sin_delta * t34;
    const double t62 = (t26 * t32) + (t14 * t35);
    const double t64 = (cos_phi * t58) + (sin_phi * t62);
    const double t69 = (t42 * t64) + (t14 * motion->constants[39]) + (t26 * t51);
    const double t71 = 1.0 / (cos_phi * t69);
    const double t72 = t57 * t71;
    const double t78 = (t26 * motion->constants[31]) - (t14 * motion->constants[30]);
    const double t80 = t56 + (sin_phi * t78);
    const double t82 = sin_phi * t26;
    const double t85 = (t14 * motion->constants[31]) + (t26 * motion->constants[30]);
    const double t86 = t69 - t85;
    const double t89 = t71 * ((t14 * t80) + (t82 * t86));
    const double t91 = (speeds[0] * t72) + (speeds[1] * t89);
    const double t92 = speeds[3] + t91;
    const double t93 = motion->constants[7] * t92;
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t96 = t93 * sin_psi;
    const double t98 = motion->constants[7] * cos_psi;
    const double t99 = t71 * t72;
    const double t100 = sin_phi * t69;
    const double t106 = (sin_phi * t45) + (cos_phi * t53);
    const double t107 = t14 * t72;
    const double t108 = sin_phi * motion->constants[39];
    const double t110 = t26 * t72;
    const double t111 = sin_phi * t51;
    const double t113 = t37 * motion->constants[8];
    const double t114 = cos_delta * cos_phi;
    const double t115 = t14 * sin_delta;
    const double t117 = cos_phi * sin_delta;
    const double t120 = t114 + (t110 * t117) - (sin_phi * t115);
    const double t124 = t14 * cos_delta;
    const double t125 = sin_phi * t124;
    const double t128 = t31 * t114;
    const double t130 = t31 * t31;
    const double t131 = t22 * t130;
    const double t134 = t31 * 0.5;
    const double t135 = (t27 + t27) * t134;
    const double t138 = t134 * (t22 + t22);
    const double t143 = cos_phi * t135;
    const double t145 = t114 * t138;
    const double t149 = (t117 * t138) - (sin_phi * ((t26 * t135) - (t124 * t138))) - (t107 * t143) -
        (t110 * t145);
    const double t153 = (t31 * t125) + (t31 * t117) - (t110 * t128) - (t131 * t149);
    const double t155 = cos_delta * t26;
    const double t157 = cos_phi * t31;
    const double t159 = t27 * t130;
    const double t162 = (t31 * t82) + (t107 * t157) + (t149 * t159);
    const double t166 = (t35 * t107) + (t32 * t110) + (t14 * t153) + (t155 * t162);
    const double t171 = (t107 * t108) + (t110 * t111) + (t42 * t166) - t106 - (t113 * t120);
    const double t173 = cos_phi * t99;
    const double t176 = motion->constants[8] * t64;
    const double t180 = sin_phi * t32;
    const double t182 = sin_phi * t35;
    const double t185 = t117 + t125;
    const double t191 = (cos_phi * t62) + (t110 * t182) + (t82 * t153) - (sin_phi * t58) - (t107 *
        t180) - (t162 * t185);
    const double t195 = (motion->constants[39] * t110) + (t120 * t176) + (t42 * t191) - (t51 *
        t107);
    const double t199 = (t99 * t100) + (motion->constants[7] * cos_phi * t71) + (t71 * t171) -
        (t173 * t195);
    const double t201 = t71 * t89;
    const double t203 = t26 * t86;
    const double t205 = t14 * t71;
    const double t211 = t71 * t82;
    const double t213 = sin_phi * motion->constants[31];
    const double t216 = (sin_phi * t71 * t86) + (t205 * t213) - (motion->constants[30] * t211);
    const double t220 = sin_phi * motion->constants[30];
    const double t223 = (t71 * t80) - (motion->constants[31] * t211) - (t205 * t220);
    const double t227 = t211 - (cos_phi * t201);
    const double t231 = (t100 * t201) + (cos_phi * ((t71 * t203) + (t78 * t205))) + (t110 * t223) +
        (t171 * t205);
    const double t233 = t231 + (t195 * t227) - (t107 * t216);
    const double t235 = (speeds[0] * t199) + (speeds[1] * t233);
    const double t238 = t14 * motion->constants[37];
    const double t240 = t14 * t89;
    const double t242 = t26 * t89;
    const double t245 = (t117 * t242) - t22;
    const double t247 = sin_delta * t26;
    const double t260 = (t39 * t138) + (t40 * t138) - (t143 * t240) - (t145 * t242);
    const double t264 = (t31 * t39) + (t31 * t40) - (t128 * t242) - (t131 * t260);
    const double t268 = (t157 * t240) + (t159 * t260);
    const double t273 = (t34 * t247) + (t35 * t240) + (t32 * t242) + (t14 * t264) + (t155 * t268);
    const double t279 = (motion->constants[37] * t114) + (t108 * t240) + (t111 * t242) + (t42 *
        t273) - (t21 * t238) - (t113 * t245);
    const double t286 = sin_phi * t14;
    const double t296 = (t34 * t114) + (t182 * t242) + (t82 * t264) - (t58 * t286) - (t180 * t240) -
        (t185 * t268);
    const double t301 = (motion->constants[39] * t242) + (t176 * t245) + (t42 * t296) -
        (motion->constants[37] * t247) - (t51 * t240);
    const double t303 = (t71 * t279) - (t173 * t301);
    const double t311 = (t223 * t242) + (t205 * t279) + (t227 * t301) - (t216 * t240);
    const double t313 = (speeds[0] * t303) + (speeds[1] * t311);
    const double t318 = motion->constants[7] * sin_psi;
    const double t325 = (t37 * t69) + (t57 * t64);
    const double t326 = 1.0 / t325;
    const double t327 = motion->constants[7] * t64;
    const double t328 = t326 * t327;
    const double t329 = t326 * t328;
    const double t330 = speeds[3] * t329;
    const double t339 = (cos_phi * t327) + (t64 * t171) + (t57 * t191) + (t37 * t195) - (t69 *
        t166);
    const double t341 = motion->constants[7] * t326;
    const double t342 = speeds[3] * t341;
    const double t344 = t72 * t326;
    const double t345 = sin_phi * t64;
    const double t351 = sin_phi * t57;
    const double t353 = sin_phi * t37;
    const double t357 = (cos_phi * (t325 + (motion->constants[7] * t345))) + (t171 * t345) + (t191 *
        t351) + (t195 * t353);
    const double t358 = t357 - (t100 * t166);
    const double t362 = (t37 * t100) + (t64 * t351);
    const double t363 = t326 * t362;
    const double t364 = t72 * t363;
    const double t365 = t326 * t364;
    const double t369 = (t344 * t358) + (t199 * t363) - (t339 * t365);
    const double t371 = t37 * t326;
    const double t373 = t64 * t326;
    const double t374 = t26 * t80;
    const double t376 = t53 - t78;
    const double t379 = (t82 * t373) - (t14 * t371);
    const double t387 = t106 + (t30 * motion->constants[8]) - (cos_phi * t78);
    const double t390 = (t26 * t387) + (t27 * t78);
    const double t397 = (cos_phi * t86) - (t27 * motion->constants[30]);
    const double t403 = (sin_phi * t387) + (cos_phi * t80) + (t27 * t213);
    const double t407 = (cos_phi * motion->constants[39]) - (cos_phi * motion->constants[31]);
    const double t410 = (t371 * t397) + (t373 * t403) + (t379 * t407);
    const double t413 = t387 + (t27 * motion->constants[31]);
    const double t415 = t27 * t220;
    const double t419 = (cos_phi * motion->constants[30]) - (cos_phi * t51);
    const double t422 = (t379 * t419) - (t371 * t413) - (t373 * t415);
    const double t424 = motion->constants[8] * t379;
    const double t428 = (t27 * t86) - (t14 * t387);
    const double t429 = t326 * t428;
    const double t431 = t27 * t373;
    const double t435 = (t82 * t387) + (t27 * t80);
    const double t436 = t326 * t435;
    const double t438 = t27 * t371;
    const double t440 = t89 * t326;
    const double t447 = t326 * ((t37 * t428) + (t64 * t435) + (t89 * t362));
    const double t448 = t326 * t447;
    const double t453 = (cos_phi * ((t373 * t390) + (t45 * t379))) + (t110 * t422) + (t149 * t424) +
        (t171 * t431);
    const double t458 = t453 + (t191 * t436) + (t195 * t438) + (t358 * t440) + (t233 * t363) -
        (sin_phi * ((t203 * t371) + (t373 * t374) + (t376 * t379)));
    const double t461 = t458 - (t107 * t410) - (t166 * t429) - (t339 * t448);
    const double t465 = (t330 * t339) - ((t191 * t342) + (speeds[0] * t369) + (speeds[1] * t461));
    const double t472 = (t64 * t279) + (t57 * t296) + (t37 * t301) - (t69 * t273);
    const double t481 = (t279 * t345) + (t296 * t351) + (t301 * t353) - (t100 * t273);
    const double t486 = (t344 * t481) + (t303 * t363) - (t365 * t472);
    const double t488 = motion->constants[37] * t39;
    const double t490 = t238 * t117;
    const double t506 = (t379 * t488) + (t379 * t490) + (t242 * t422) + (t260 * t424) + (t279 *
        t431) + (t296 * t436);
    const double t511 = t506 + (t301 * t438) + (t440 * t481) + (t311 * t363) - (t240 * t410) -
        (t273 * t429);
    const double t512 = t511 - (t448 * t472);
    const double t516 = (t330 * t472) - ((t296 * t342) + (speeds[0] * t486) + (speeds[1] * t512));
    const double t518 = 1.0 / motion->constants[8];
    const double t519 = motion->constants[7] * t518;
    const double t523 = (t64 * t69) - (t37 * t57);
    const double t524 = t518 * t523;
    const double t525 = t341 * t524;
    const double t527 = t328 * t518;
    const double t528 = motion->constants[7] * t37;
    const double t537 = (t57 * t166) + (t69 * t191) + (t64 * t195) - (cos_phi * t528) - (t37 *
        t171);
    const double t539 = t329 * t524;
    const double t543 = (t191 * t525) + (t527 * t537) - (t166 * t519) - (t339 * t539);
    const double t545 = speeds[0] * t518;
    const double t555 = (cos_phi * (t523 - (motion->constants[7] * t353))) + (t166 * t351) + (t100 *
        t191) + (t195 * t345);
    const double t556 = t555 - (t171 * t353);
    const double t561 = (t64 * t100) - (t37 * t351);
    const double t566 = (t364 * t537) + (t369 * t523) - (t72 * t556) - (t199 * t561);
    const double t568 = speeds[1] * t518;
    const double t573 = (t14 * t64) + (t37 * t82);
    const double t586 = (t37 * t403) + (t407 * t573) - (t64 * t397);
    const double t592 = (t64 * t413) + (t419 * t573) - (t37 * t415);
    const double t594 = motion->constants[8] * t573;
    const double t597 = t27 * t37;
    const double t600 = t27 * t64;
    const double t608 = (cos_phi * ((t37 * t390) + (t45 * t573))) + (t110 * t592) + (t149 * t594) +
        (t171 * t597);
    const double t612 = t608 + (t447 * t537) + (t461 * t523) - (sin_phi * ((t37 * t374) + (t376 *
        t573) - (t64 * t203))) - (t107 * t586);
    const double t617 = t612 - (t166 * t435) - (t191 * t428) - (t195 * t600) - (t89 * t556) -
        (t233 * t561);
    const double t620 = (speeds[3] * t543) + (t545 * t566) + (t568 * t617);
    const double t629 = (t57 * t273) + (t69 * t296) + (t64 * t301) - (t37 * t279);
    const double t634 = (t296 * t525) + (t527 * t629) - (t273 * t519) - (t472 * t539);
    const double t642 = (t273 * t351) + (t100 * t296) + (t301 * t345) - (t279 * t353);
    const double t649 = (t364 * t629) + (t486 * t523) - (t72 * t642) - (t303 * t561);
    const double t668 = (t488 * t573) + (t490 * t573) + (t242 * t592) + (t260 * t594) + (t279 *
        t597) + (t447 * t629);
    const double t673 = t668 + (t512 * t523) - (t240 * t586) - (t273 * t435) - (t296 * t428) -
        (t301 * t600);
    const double t675 = t673 - (t89 * t642) - (t311 * t561);
    const double t678 = (speeds[3] * t634) + (t545 * t649) + (t568 * t675);
    const double t682 = t518 * ((t364 * t523) - (t72 * t561));
    const double t690 = t518 * ((t37 * t435) + (t447 * t523) - (t64 * t428) - (t89 * t561));
    const double t693 = t518 * (t528 + (t328 * t523));
    double sin_theta = 0.0;
    double cos_theta = 0.0;
    carvallo_sin_cos_f64(positions[6], &sin_theta, &cos_theta);
    const double t698 = 1.0 - cos_theta;
    const double t701 = cos_theta + (t698 * motion->constants[34]);
    const double t705 = t698 * motion->constants[35];
    const double t707 = t705 * motion->constants[57];
    const double t711 = motion->constants[2] * sin_theta;
    const double t721 = sin_delta * motion->constants[66];
    const double t722 = sin_delta * t721;
    const double t725 = t705 * motion->constants[54];
    const double t728 = cos_theta + (t698 * motion->constants[36]);
    const double t731 = t725 + (t728 * motion->constants[55]);
    const double t732 = motion->constants[33] * t731;
    const double t737 = t732 + t732 + motion->constants[63] + motion->constants[68];
    const double t741 = motion->constants[45] + motion->constants[50] + (t701 * ((t701 *
        motion->constants[56]) + t707)) + (t711 * t711 * motion->constants[58]) + (t705 * ((t701 *
        motion->constants[57]) + (t705 * motion->constants[59])));
    const double t743 = t741 + t737 - t722;
    const double t748 = (motion->constants[56] * t705) + (motion->constants[57] * t728);
    const double t750 = motion->constants[3] * sin_theta;
    const double t751 = motion->constants[58] * t750;
    const double t754 = t707 + (motion->constants[59] * t728);
    const double t760 = t705 * motion->constants[55];
    const double t761 = (t701 * motion->constants[54]) + t760;
    const double t764 = cos_delta * motion->constants[48];
    const double t765 = motion->constants[30] * t764;
    const double t766 = (motion->constants[32] * t761) - t765;
    const double t769 = motion->constants[65] + motion->constants[71] - t766 - t766;
    const double t774 = motion->constants[46] + motion->constants[53] + (t705 * t748) + (t750 *
        t751) + (t728 * t754) + t769;
    const double t775 = t774 - t743;
    const double t776 = t14 * t14;
    const double t778 = t14 * t26;
    const double t791 = (cos_delta * motion->constants[51]) - (motion->constants[31] * t764);
    const double t796 = motion->constants[42] + (t701 * t748) + (t705 * t754) + (t731 *
        motion->constants[32]) + motion->constants[64] + t791;
    const double t800 = t796 - (t711 * t751) - (motion->constants[33] * t761) -
        motion->constants[69] - motion->constants[70];
    const double t801 = t800 + t800;
    const double t803 = (t775 * t776) + (t778 * t801);
    const double t809 = t731 + motion->constants[41] + motion->constants[62] +
        motion->constants[72];
    const double t814 = motion->constants[40] + motion->constants[67];
    const double t817 = t761 + t764 + t814 - motion->constants[61];
    const double t819 = (t26 * t809) - (t14 * t817);
    const double t820 = motion->constants[7] * t819;
    const double t823 = motion->constants[74] - t820 - t820;
    const double t829 = (t711 * motion->constants[54]) - (motion->constants[55] * t750);
    const double t832 = sin_delta * motion->constants[48];
    const double t833 = motion->constants[31] * t832;
    const double t834 = (sin_delta * motion->constants[51]) - t833;
    const double t838 = (t711 * t748) + (cos_theta * t751) + t834 - (t750 * t754) -
        (motion->constants[33] * t829);
    const double t842 = (motion->constants[56] * t711) - (motion->constants[57] * t750);
    const double t844 = cos_theta * motion->constants[58];
    const double t848 = (motion->constants[57] * t711) - (motion->constants[59] * t750);
    const double t857 = (t701 * t842) + (t705 * t848) + (motion->constants[32] * t829) +
        (cos_delta * t721) - (t711 * t844) - (motion->constants[30] * t832);
    const double t859 = (t14 * t838) + (t26 * t857);
    const double t861 = t72 - (sin_phi * t364);
    const double t871 = t800 + (t775 * t778) + (motion->constants[7] * ((t14 * t809) + (t26 *
        t817))) - (t776 * t801);
    const double t872 = cos_phi * t364;
    const double t884 = t722 + t737 + t769 + t823 + motion->constants[43] + motion->constants[52] +
        (t711 * t842);
    const double t886 = t884 + (cos_theta * t844) - (t750 * t848);
    const double t891 = motion->constants[7] * (t829 + t832);
    const double t893 = (t26 * t838) + t891 - (t14 * t857);
    const double t899 = t774 - t803;
    const double t905 = t861 * motion->constants[27];
    const double t910 = t247 + (t115 * t872) - (cos_delta * t861);
    const double t911 = t682 - t910;
    const double t913 = t911 * motion->constants[28];
    const double t919 = t743 + t803 + t823 + (t859 * t861) + (t861 * (t859 + (t861 * t886) - (t872 *
        t893))) + (t861 * t905);
    const double t922 = t919 + (t911 * t913) - (t871 * t872) - (t872 * (t871 + (t861 * t893) -
        (t872 * t899)));
    const double t923 = 1.0 / t922;
    const double t924 = speeds[0] * t26;
    const double t929 = (speeds[0] * t364) + (speeds[1] * t447) + (speeds[3] * t328);
    const double t930 = cos_phi * t929;
    const double t932 = t924 + (t14 * t930);
    const double t933 = sin_phi * t929;
    const double t934 = t91 - t933;
    const double t938 = (motion->constants[43] * t934) + (motion->constants[27] * (speeds[3] +
        t934));
    const double t942 = speeds[0] * t14;
    const double t943 = t942 - (t26 * t930);
    const double t944 = motion->constants[42] * t943;
    const double t945 = (motion->constants[45] * t932) + t944;
    const double t947 = (t932 * t938) - (t934 * t945);
    const double t950 = (cos_delta * t932) + (sin_delta * t934);
    const double t953 = (cos_delta * t934) - (sin_delta * t932);
    const double t959 = (speeds[0] * t682) + (speeds[1] * t690) + (speeds[3] * t693);
    const double t960 = t953 + t959;
    const double t962 = (motion->constants[52] * t953) + (motion->constants[28] * t960);
    const double t965 = speeds[1] + t943;
    const double t966 = motion->constants[51] * t965;
    const double t967 = (motion->constants[50] * t950) + t966;
    const double t969 = (t950 * t962) - (t953 * t967);
    const double t970 = motion->constants[7] * t933;
    const double t971 = t930 * t970;
    const double t973 = sin_phi * motion->constants[60];
    const double t974 = t92 * t930;
    const double t977 = t971 - (motion->constants[7] * t974);
    const double t978 = t973 + t977;
    const double t980 = t91 * t943;
    const double t981 = speeds[0] * t933;
    const double t982 = motion->constants[31] * t934;
    const double t984 = motion->constants[30] * t934;
    const double t986 = (t943 * t982) + (t932 * t984);
    const double t988 = t91 * t932;
    const double t989 = (t26 * t981) + t988;
    const double t992 = t980 + (t14 * t981);
    const double t996 = t986 + (motion->constants[30] * t989) + (motion->constants[31] * t992) -
        t977;
    const double t999 = motion->constants[30] * t943;
    const double t1000 = motion->constants[31] * t932;
    const double t1001 = t999 - t1000;
    const double t1003 = (t934 * t984) + (t943 * t1001);
    const double t1004 = speeds[0] * t930;
    const double t1007 = motion->constants[7] * speeds[0];
    const double t1008 = t930 * t1007;
    const double t1009 = (motion->constants[7] * t1004) + t1008;
    const double t1012 = t92 - t933;
    const double t1014 = (t970 * t1012) - (speeds[0] * t1007);
    const double t1018 = (t26 * t1009) + (t14 * t1014) - t1003 - (motion->constants[31] * t1004);
    const double t1021 = t953 * motion->constants[38];
    const double t1023 = motion->constants[37] * t953;
    const double t1026 = cos_delta * t992;
    const double t1027 = sin_delta * t1004;
    const double t1028 = speeds[1] * t953;
    const double t1030 = t1028 - t1026 - t1027;
    const double t1032 = t32 * motion->constants[8];
    const double t1034 = t989 + (t950 * t959);
    const double t1036 = t34 * motion->constants[8];
    const double t1038 = t1030 - (t959 * t965);
    const double t1040 = t31 * t41;
    const double t1043 = (t32 * t950) + (t34 * t965);
    const double t1045 = motion->constants[8] * t1040 * t1043;
    const double t1046 = t34 * t1045;
    const double t1048 = t32 * t1045;
    const double t1054 = (cos_delta * t996) + (t965 * t1021) + (t950 * t1023) +
        (motion->constants[37] * t989) + (t1032 * t1034) + (t965 * t1046);
    const double t1058 = t1054 + (t950 * t1048) - (sin_delta * t1018) - (motion->constants[38] *
        t1030) - (t1036 * t1038);
    const double t1063 = motion->constants[37] * t965;
    const double t1064 = t950 * motion->constants[38];
    const double t1065 = t1063 - t1064;
    const double t1069 = speeds[1] * t950;
    const double t1071 = (sin_delta * t992) - (cos_delta * t1004) - t1069;
    const double t1078 = motion->constants[8] * ((t32 * t965) - (t34 * t950));
    const double t1084 = (cos_delta * t1018) + (sin_delta * t996) + (motion->constants[38] *
        t1071) + (t1036 * t1071) - (t953 * t1023) - (t965 * t1065);
    const double t1086 = t1084 - (t960 * t1048) - (t965 * t1078);
    const double t1090 = (t932 * t1001) - (t934 * t982);
    const double t1104 = t1090 + (motion->constants[30] * t1004) + (t14 * t1009) + (t950 * t1065) +
        (t950 * t1078) - (t26 * t1014);
    const double t1108 = t1104 - (t953 * t1021) - (motion->constants[37] * t1071) - (t1032 *
        t1071) - (t960 * t1046);
    const double t1110 = (t32 * t1086) + (t34 * t1108);
    const double t1115 = t71 * ((t41 * t1058) + (t30 * t1110));
    const double t1119 = t326 * ((t30 * t1058) + (t362 * t1115) - (t41 * t1110));
    const double t1121 = t981 - (cos_phi * t1119);
    const double t1123 = t980 + (t14 * t1121);
    const double t1126 = t988 + (t26 * t1121);
    const double t1132 = t986 + (motion->constants[30] * t1126) + (motion->constants[31] * t1123) -
        t978;
    const double t1135 = t1004 - t1115;
    const double t1136 = (sin_phi * t1119) + t1135;
    const double t1139 = (motion->constants[7] * t1136) + t1008;
    const double t1142 = t1014 + (cos_phi * motion->constants[60]);
    const double t1143 = t14 * t1142;
    const double t1144 = t1143 + (t26 * t1139);
    const double t1146 = t1144 - (motion->constants[31] * t1136) - t1003;
    const double t1148 = (cos_delta * t1132) - (sin_delta * t1146);
    const double t1153 = t1028 - (sin_delta * t1136) - (cos_delta * t1123);
    const double t1158 = t969 + (motion->constants[48] * t1148) + (motion->constants[51] * t1153) +
        (motion->constants[53] * t1126);
    const double t1159 = motion->constants[32] * t934;
    const double t1161 = motion->constants[32] * t943;
    const double t1162 = motion->constants[33] * t932;
    const double t1163 = t1161 + t1162;
    const double t1165 = (t934 * t1159) + (t943 * t1163);
    const double t1168 = t1144 + t1165 - (motion->constants[33] * t1136);
    const double t1170 = motion->constants[33] * t934;
    const double t1173 = (t943 * t1170) - (t932 * t1159);
    const double t1178 = t1173 + (motion->constants[33] * t1123) - t978 - (motion->constants[32] *
        t1126);
    const double t1182 = (t932 * t1163) + (t934 * t1170);
    const double t1184 = t26 * t1142;
    const double t1186 = t1184 - (t14 * t1139);
    const double t1188 = (motion->constants[32] * t1136) + t1182 + t1186;
    const double t1191 = (cos_theta * t1178) - (t750 * t1188) - (t711 * t1168);
    const double t1198 = (cos_theta * t934) + (t750 * t943) - (t711 * t932);
    const double t1199 = motion->constants[2] * t1198;
    const double t1200 = speeds[2] * t1199;
    const double t1206 = t1200 - (t711 * t1136) + (t705 * t1126) - (t701 * t1123);
    const double t1208 = motion->constants[3] * t1198;
    const double t1209 = speeds[2] * t1208;
    const double t1215 = (t728 * t1126) - t1209 - (t705 * t1123) + (t750 * t1136);
    const double t1220 = motion->constants[3] * speeds[2];
    const double t1223 = (t701 * t932) + (t711 * t934) + (t705 * t943) + t1220;
    const double t1224 = motion->constants[57] * t1223;
    const double t1228 = motion->constants[2] * speeds[2];
    const double t1231 = (t705 * t932) + (t728 * t943) + t1228 - (t750 * t934);
    const double t1233 = t1224 + (motion->constants[59] * t1231);
    const double t1235 = motion->constants[58] * t1198;
    const double t1237 = (t1198 * t1233) - (t1231 * t1235);
    const double t1240 = (motion->constants[56] * t1206) + (motion->constants[57] * t1215) + t1237 -
        (motion->constants[55] * t1191);
    const double t1246 = (t701 * t1168) + (t711 * t1178) - (t705 * t1188);
    const double t1252 = (t705 * t1168) - (t728 * t1188) - (t750 * t1178);
    const double t1256 = (motion->constants[3] * t1231) - (motion->constants[2] * t1223);
    const double t1257 = speeds[2] * t1256;
    const double t1263 = t1257 + (t711 * t1123) - (cos_theta * t1136) + (t750 * t1126);
    const double t1266 = motion->constants[57] * t1231;
    const double t1267 = (motion->constants[56] * t1223) + t1266;
    const double t1270 = (t1231 * t1267) - (t1223 * t1233);
    const double t1273 = (motion->constants[55] * t1246) + (motion->constants[58] * t1263) + t1270 -
        (motion->constants[54] * t1252);
    const double t1280 = (t1223 * t1235) - (t1198 * t1267);
    const double t1283 = (motion->constants[54] * t1191) + (motion->constants[57] * t1206) +
        (motion->constants[59] * t1215) + t1280;
    const double t1288 = motion->constants[54] * t1198;
    const double t1290 = motion->constants[54] * t1231;
    const double t1291 = motion->constants[55] * t1223;
    const double t1292 = t1290 - t1291;
    const double t1294 = (t1198 * t1288) + (t1231 * t1292);
    const double t1296 = (t1246 * motion->constants[24]) + (motion->constants[55] * t1263) - t1294;
    const double t1301 = motion->constants[55] * t1198;
    const double t1304 = (t1231 * t1301) + (t1223 * t1288);
    const double t1307 = (t1191 * motion->constants[24]) + (motion->constants[54] * t1215) + t1304 -
        (motion->constants[55] * t1206);
    const double t1313 = (t1223 * t1292) - (t1198 * t1301);
    const double t1315 = (t1252 * motion->constants[24]) + t1313 - (motion->constants[54] * t1263);
    const double t1318 = (t711 * t1296) + (cos_theta * t1307) - (t750 * t1315);
    const double t1323 = (cos_delta * t1146) + (sin_delta * t1132);
    const double t1329 = (sin_delta * t1123) - (cos_delta * t1136) - t1069;
    const double t1331 = motion->constants[48] * t953;
    const double t1333 = motion->constants[48] * t965;
    const double t1334 = t950 * motion->constants[49];
    const double t1335 = t1333 - t1334;
    const double t1337 = (t953 * t1331) + (t965 * t1335);
    const double t1339 = (motion->constants[47] * t1323) + (motion->constants[49] * t1329) - t1337;
    const double t1344 = t953 * motion->constants[49];
    const double t1347 = (t965 * t1344) + (t950 * t1331);
    const double t1350 = (t1148 * motion->constants[47]) + (motion->constants[48] * t1126) + t1347 -
        (t1153 * motion->constants[49]);
    const double t1352 = (sin_delta * t1339) + (cos_delta * t1350);
    const double t1358 = t947 + (motion->constants[46] * t1126) + t1158 + (t705 * t1240) + (t750 *
        t1273) + (t728 * t1283);
    const double t1362 = t1358 + (motion->constants[30] * t1352) - (motion->constants[40] * t978) -
        (motion->constants[42] * t1123) - (motion->constants[32] * t1318);
    const double t1367 = motion->constants[42] * t932;
    const double t1369 = t1367 + (motion->constants[46] * t943);
    const double t1372 = (t934 * t1369) - (t938 * t943);
    const double t1380 = motion->constants[51] * t950;
    const double t1382 = t1380 + (motion->constants[53] * t965);
    const double t1385 = (t953 * t1382) - (t962 * t965);
    const double t1388 = (motion->constants[50] * t1153) + (motion->constants[51] * t1126) + t1385 -
        (t1148 * motion->constants[49]);
    const double t1393 = t1090 - t1186 + (motion->constants[30] * t1136);
    const double t1403 = t518 * ((t32 * t1108) + (t523 * t1119) - (t34 * t1086) - (t561 * t1115));
    const double t1405 = motion->constants[28] * (t1329 + t1403);
    const double t1408 = (t965 * t967) - (t950 * t1382);
    const double t1412 = (t1323 * motion->constants[49]) + (motion->constants[52] * t1329) + t1405 +
        t1408 - (motion->constants[48] * t1393);
    const double t1419 = (motion->constants[41] * t978) + (motion->constants[42] * t1126) + t1372 +
        (t701 * t1240) + (t705 * t1283) + (cos_delta * t1388);
    const double t1424 = t1419 - (motion->constants[45] * t1123) - (t711 * t1273) -
        (motion->constants[33] * t1318) - (sin_delta * t1412) - (motion->constants[31] * t1352);
    const double t1430 = motion->constants[41] * t934;
    const double t1432 = motion->constants[40] * t934;
    const double t1439 = t1318 + t1352 + (motion->constants[40] * t1126) + (motion->constants[41] *
        t1123) + (t943 * t1430) + (t932 * t1432) - (t978 * motion->constants[44]);
    const double t1446 = (t943 * t945) - (t932 * t1369);
    const double t1454 = (t701 * t1296) + (t705 * t1315) - (t711 * t1307);
    const double t1460 = (t705 * t1296) + (t750 * t1307) + (t728 * t1315);
    const double t1466 = (cos_delta * t1339) - (sin_delta * t1350);
    const double t1472 = (t950 * t1335) - (t953 * t1344);
    const double t1474 = (motion->constants[47] * t1393) + t1472 - (motion->constants[48] * t1329);
    const double t1479 = motion->constants[40] * t943;
    const double t1480 = motion->constants[41] * t932;
    const double t1481 = t1479 - t1480;
    const double t1484 = (t932 * t1481) - (t934 * t1430);
    const double t1494 = (t934 * t1432) + (t943 * t1481);
    const double t1500 = (t14 * (t1460 + t1474 + t1484 - (t1186 * motion->constants[44]) +
        (motion->constants[40] * t1136))) + (t26 * (t1454 + t1466 + (t1144 *
        motion->constants[44]) - (motion->constants[41] * t1136) - t1494));
    const double t1502 = (motion->constants[27] * t1136) + (motion->constants[7] * t1500);
    const double t1507 = (motion->constants[41] * t1144) + (motion->constants[40] * t1186) -
        (motion->constants[43] * t1136) + t1446 + (t711 * t1240) + (cos_theta * t1273);
    const double t1512 = t1507 + (motion->constants[33] * t1454) + (motion->constants[32] * t1460) +
        (sin_delta * t1388) + (cos_delta * t1412) + (motion->constants[31] * t1466);
    const double t1515 = t1512 - t1502 - (t750 * t1283) - (motion->constants[30] * t1474);
    const double t1519 = (t26 * t1362) - (t14 * t1424);
    const double t1526 = forces[0] + (t872 * t1519) - (t14 * t1362) - (t26 * t1424) -
        (motion->constants[7] * t1439) - (t861 * t1515);
    const double t1527 = t1526 - (t682 * t1405);
    const double t1529 = motion->constants[53] + t765;
    const double t1534 = t89 - (sin_phi * t447);
    const double t1536 = cos_phi * t447;
    const double t1538 = t26 * t832;
    const double t1539 = motion->constants[7] * t1538;
    const double t1540 = t834 + t1539;
    const double t1544 = t1540 + (t886 * t1534) - (t893 * t1536);
    const double t1548 = (t26 * t1529) - (t14 * t791);
    const double t1552 = t1548 + (t893 * t1534) - (t899 * t1536);
    const double t1557 = (cos_delta * t1534) - (t115 * t1536);
    const double t1558 = t690 + t1557;
    const double t1564 = (t14 * t1529) + (t26 * t791) + (motion->constants[7] * t764) + (t859 *
        t1534) + (t861 * t1544) + (t905 * t1534);
    const double t1568 = t923 * (t1564 + (t913 * t1558) - (t871 * t1536) - (t872 * t1552));
    const double t1573 = motion->constants[27] * t1534;
    const double t1575 = motion->constants[28] * t1558;
    const double t1577 = t922 * t1568;
    const double t1583 = motion->constants[53] + (t1534 * t1544) + (t1534 * t1540) + (t1534 *
        t1573) + (t1558 * t1575) - (t1536 * t1552);
    const double t1585 = t1583 - (t1536 * t1548) - (t1568 * t1577);
    const double t1586 = 1.0 / t1585;
    const double t1596 = forces[1] + (t1519 * t1536) - t1158 - (t1515 * t1534) - (t690 * t1405) -
        (t1527 * t1568);
    const double t1599 = t711 * motion->constants[75];
    const double t1601 = t750 * motion->constants[75];
    const double t1606 = motion->constants[7] * ((t14 * t1601) - (t26 * t1599));
    const double t1611 = (t711 * motion->constants[76]) - (t750 * motion->constants[77]);
    const double t1614 = (motion->constants[32] * t1601) + t1611 - (motion->constants[33] * t1599) -
        t1606;
    const double t1616 = cos_theta * motion->constants[75];
    const double t1620 = (t705 * motion->constants[76]) + (t728 * motion->constants[77]);
    const double t1621 = t1620 - (motion->constants[32] * t1616);
    const double t1626 = (t701 * motion->constants[76]) + (t705 * motion->constants[77]);
    const double t1627 = t1626 - (motion->constants[33] * t1616);
    const double t1629 = (t26 * t1621) - (t14 * t1627);
    const double t1640 = t923 * ((t14 * t1621) + (t26 * t1627) + (motion->constants[7] * t1616) +
        (t861 * t1614) - (t872 * t1629));
    const double t1644 = t1586 * ((t1534 * t1614) - (t1536 * t1629) - (t1577 * t1640));
    const double t1646 = t922 * t1640;
    const double t1648 = t1585 * t1644;
    const double t1651 = motion->constants[78] - (t1640 * t1646) - (t1644 * t1648);
    const double t1652 = 1.0 / t1651;
    const double t1666 = forces[2] - (motion->constants[3] * t1240) - (motion->constants[2] *
        t1283) - (positions[6] * motion->constants[5]) - (speeds[2] * motion->constants[6]) -
        (t1527 * t1640);
    const double t1667 = t1666 - (t1596 * t1644);
    const double t1669 = sin_phi * t328;
    const double t1671 = cos_phi * t328;
    const double t1677 = motion->constants[7] * (t819 - motion->constants[73]);
    const double t1681 = t1677 + (t886 * t1669) + (t893 * t1671);
    const double t1686 = t891 - (t893 * t1669) - (t899 * t1671);
    const double t1688 = 1.0 - t1669;
    const double t1692 = (cos_delta * t1669) + (t115 * t1671);
    const double t1693 = t693 - t1692;
    const double t1699 = (t905 * t1688) + (t913 * t1693) - (t859 * t1669) - (t871 * t1671) - (t861 *
        t1681) - (t872 * t1686);
    const double t1700 = t923 * t1699;
    const double t1713 = t1539 + (t1573 * t1688) + (t1575 * t1693) - (t1534 * t1681) - (t1536 *
        t1686) - (t1540 * t1669);
    const double t1716 = t1586 * (t1713 - (t1548 * t1671) - (t1577 * t1700));
    const double t1722 = t1652 * (t1606 + (t1614 * t1669) + (t1629 * t1671) + (t1646 * t1700) +
        (t1648 * t1716));
    const double t1733 = (t1515 * t1669) + (t1519 * t1671) + (t1667 * t1722) + t1502 - (t693 *
        t1405) - (t1527 * t1700);
    const double t1754 = (t1669 * t1681) + (t1669 * t1677) + motion->constants[79] +
        (motion->constants[27] * t1688 * t1688) + (motion->constants[28] * t1693 * t1693) - (t1671 *
        t1686);
    const double t1759 = 1.0 / (t1754 - (t891 * t1671) - (t922 * t1700 * t1700) - (t1585 * t1716 *
        t1716) - (t1651 * t1722 * t1722));
    const double t1760 = (t1733 - (t1596 * t1716)) * t1759;
    const double t1762 = (t1652 * t1667) + (t1722 * t1760);
    const double t1766 = (t1586 * t1596) - (t1644 * t1762) - (t1716 * t1760);
    const double t1772 = (t923 * t1527) - (t1568 * t1766) - (t1640 * t1762) - (t1700 * t1760);
    const double t1776 = t971 + t973 - (motion->constants[7] * (t974 + t1772));
    const double t1784 = t1119 + (t364 * t1772) + (t447 * t1766) + (t328 * t1760);
    const double t1786 = t981 - (cos_phi * t1784);
    const double t1789 = (t26 * t1772) - t980 - (t14 * t1786);
    const double t1794 = t988 + (t26 * t1786) + (t14 * t1772);
    const double t1800 = t986 + (motion->constants[30] * t1794) - t1776 - (motion->constants[31] *
        t1789);
    const double t1807 = (t72 * t1772) + (t89 * t1766) - (sin_phi * t1784) - t1135;
    const double t1809 = t1760 + t1807;
    const double t1811 = (motion->constants[7] * t1809) - t1008;
    const double t1813 = t1143 - (t26 * t1811);
    const double t1815 = (motion->constants[31] * t1807) + t1813 - t1003;
    const double t1817 = (cos_delta * t1800) - (sin_delta * t1815);
    const double t1821 = (cos_delta * t1789) + (sin_delta * t1807);
    const double t1822 = t1028 + t1821;
    const double t1824 = t1766 + t1794;
    const double t1828 = t1165 + t1813 + (motion->constants[33] * t1807);
    const double t1834 = t1173 - t1776 - (motion->constants[32] * t1794) - (motion->constants[33] *
        t1789);
    const double t1838 = t1184 + (t14 * t1811);
    const double t1840 = (motion->constants[32] * t1807) - t1182 - t1838;
    const double t1843 = (cos_theta * t1834) + (t750 * t1840) - (t711 * t1828);
    const double t1852 = t1200 + (t701 * t1789) + (t711 * t1807) + (t705 * t1794) +
        (motion->constants[3] * t1762);
    const double t1861 = (t705 * t1789) + (t728 * t1794) + (motion->constants[2] * t1762) - t1209 -
        (t750 * t1807);
    const double t1865 = t1237 + (motion->constants[56] * t1852) + (motion->constants[57] * t1861) -
        (motion->constants[55] * t1843);
    const double t1871 = (t701 * t1828) + (t711 * t1834) + (t705 * t1840);
    const double t1877 = (t705 * t1828) + (t728 * t1840) - (t750 * t1834);
    const double t1884 = t1257 + (cos_theta * t1807) + (t750 * t1794) - (t711 * t1789);
    const double t1888 = t1270 + (motion->constants[55] * t1871) + (motion->constants[58] * t1884) -
        (motion->constants[54] * t1877);
    const double t1895 = t1280 + (motion->constants[54] * t1843) + (motion->constants[57] * t1852) +
        (motion->constants[59] * t1861);
    const double t1900 = (motion->constants[24] * t1871) + (motion->constants[55] * t1884) - t1294;
    const double t1907 = t1304 + (motion->constants[24] * t1843) + (motion->constants[54] * t1861) -
        (motion->constants[55] * t1852);
    const double t1912 = t1313 + (motion->constants[24] * t1877) - (motion->constants[54] * t1884);
    const double t1915 = (t711 * t1900) + (cos_theta * t1907) - (t750 * t1912);
    const double t1919 = (cos_delta * t1815) + (sin_delta * t1800);
    const double t1923 = (cos_delta * t1807) - (sin_delta * t1789);
    const double t1924 = t1923 - t1069;
    const double t1927 = (motion->constants[47] * t1919) + (motion->constants[49] * t1924) - t1337;
    const double t1934 = t1347 + (motion->constants[47] * t1817) + (motion->constants[48] * t1824) -
        (motion->constants[49] * t1822);
    const double t1936 = (sin_delta * t1927) + (cos_delta * t1934);
    const double t1943 = t947 + t969 + (motion->constants[42] * t1789) + (motion->constants[46] *
        t1794) + (motion->constants[48] * t1817) + (motion->constants[51] * t1822) +
        (motion->constants[53] * t1824);
    const double t1948 = t1943 + (t705 * t1865) + (t750 * t1888) + (t728 * t1895) +
        (motion->constants[30] * t1936) - (motion->constants[40] * t1776);
    const double t1949 = t1948 - (motion->constants[32] * t1915);
    const double t1963 = t1385 + (motion->constants[50] * t1822) + (motion->constants[51] * t1824) -
        (motion->constants[49] * t1817);
    const double t1968 = t1090 - t1838 - (motion->constants[30] * t1807);
    const double t1978 = motion->constants[28] * (t1403 + t1924 + (t682 * t1772) + (t690 * t1766) +
        (t693 * t1760));
    const double t1982 = t1408 + (motion->constants[49] * t1919) + (motion->constants[52] * t1924) +
        t1978 - (motion->constants[48] * t1968);
    const double t1984 = (cos_delta * t1963) - (sin_delta * t1982);
    const double t1990 = t1372 + (motion->constants[41] * t1776) + (motion->constants[45] * t1789) +
        (motion->constants[42] * t1794) + (t701 * t1865) + (t705 * t1895);
    const double t1994 = t1990 + t1984 - (t711 * t1888) - (motion->constants[33] * t1915) -
        (motion->constants[31] * t1936);
    const double t1996 = (t26 * t1949) - (t14 * t1994);
    const double t1997 = sin_phi * t1996;
    const double t2010 = (t701 * t1900) + (t705 * t1912) - (t711 * t1907);
    const double t2016 = (t705 * t1900) + (t750 * t1907) + (t728 * t1912);
    const double t2019 = cos_delta * t1982;
    const double t2022 = (cos_delta * t1927) - (sin_delta * t1934);
    const double t2027 = t1472 + (motion->constants[47] * t1968) - (motion->constants[48] * t1924);
    const double t2034 = t1484 + t2016 + t2027 - (motion->constants[44] * t1838) -
        (motion->constants[40] * t1807);
    const double t2041 = t2010 + t2022 + (motion->constants[44] * t1813) + (motion->constants[41] *
        t1807) - t1494;
    const double t2049 = t1446 + (motion->constants[41] * t1813) + (motion->constants[40] * t1838) +
        (motion->constants[43] * t1807) + (motion->constants[27] * t1809) + (t711 * t1865);
    const double t2054 = t2049 + (cos_theta * t1888) + (motion->constants[33] * t2010) +
        (motion->constants[32] * t2016) + (sin_delta * t1963) + t2019;
    const double t2058 = t2054 + (motion->constants[31] * t2022) - (t750 * t1895) -
        (motion->constants[30] * t2027) - (motion->constants[7] * ((t14 * t2034) + (t26 * t2041)));
    const double t2059 = cos_phi * t2058;
    const double t2066 = (sin_phi * t2058) + (cos_phi * t1996);
    const double t2068 = t518 * t1978;
    const double t2072 = (t107 * t1949) + (t110 * t1994);
    const double t2074 = motion->constants[7] * t861;
    const double t2077 = (t110 * t2034) - (t107 * t2041);
    const double t2079 = t326 * t1110;
    const double t2080 = t524 * t2079;
    const double t2082 = t326 * t1058;
    const double t2083 = t524 * t2082;
    const double t2086 = t41 * t326;
    const double t2087 = t1086 * t2086;
    const double t2089 = (t518 * t1108) - (t524 * t2087);
    const double t2092 = t1108 * t2086;
    const double t2094 = (t518 * t1086) + (t524 * t2092);
    const double t2096 = t518 * t1115;
    const double t2098 = t326 * t1115;
    const double t2099 = t524 * t2098;
    const double t2101 = t518 * t1119;
    const double t2103 = t326 * t1119;
    const double t2104 = t524 * t2103;
    const double t2107 = t518 * t1772;
    const double t2109 = t518 * t1766;
    const double t2115 = (t149 * t2083) + (t153 * t2089) + (t162 * t2094) + (t358 * t2099) + (t537 *
        t2101) + (t543 * t1760);
    const double t2120 = t2115 + (t566 * t2107) + (t617 * t2109) - (t120 * t2080) - (t556 * t2096) -
        (t339 * t2104);
    const double t2123 = (t910 * motion->constants[28]) - (t682 * motion->constants[28]);
    const double t2126 = t1007 + t1007;
    const double t2127 = t26 * t2126;
    const double t2129 = motion->constants[7] * t1784;
    const double t2133 = motion->constants[7] * t1772;
    const double t2134 = t26 * t2133;
    const double t2136 = motion->constants[7] * t1766;
    const double t2137 = t26 * t2136;
    const double t2143 = (t27 * t2129) + (t107 * t1811) + (t110 * t1142) - (t286 *
        motion->constants[60]) - (t933 * t2127) - (t199 * t2134);
    const double t2144 = t2143 - (t233 * t2137);
    const double t2145 = t26 * motion->constants[44];
    const double t2149 = (t701 * motion->constants[55]) - t725;
    const double t2152 = (t14 * t750) - (t26 * t711);
    const double t2155 = (t14 * t711) + (t26 * t750);
    const double t2159 = (t872 * t2155) - t2152 - (cos_theta * t861);
    const double t2161 = t705 * motion->constants[24];
    const double t2165 = (t26 * motion->constants[33]) + (t14 * motion->constants[32]) -
        motion->constants[7];
    const double t2169 = (t14 * motion->constants[33]) - (t26 * motion->constants[32]);
    const double t2170 = t750 * t2169;
    const double t2172 = t26 * t705;
    const double t2174 = t2172 + (t14 * t728);
    const double t2178 = (t705 * motion->constants[33]) + (t728 * motion->constants[32]);
    const double t2182 = (t2074 * t2174) - (t750 * t2165) - (t872 * t2170) - (t861 * t2178);
    const double t2184 = t701 * motion->constants[24];
    const double t2186 = t711 * t2169;
    const double t2189 = t14 * t705;
    const double t2190 = (t26 * t701) + t2189;
    const double t2194 = (t701 * motion->constants[33]) + (t705 * motion->constants[32]);
    const double t2198 = (t711 * t2165) + (t872 * t2186) + (t2074 * t2190) - (t861 * t2194);
    const double t2201 = (t26 * t728) - t2189;
    const double t2205 = (t872 * t2201) + (t750 * t861) - t2174;
    const double t2208 = t2172 - (t14 * t701);
    const double t2212 = (t872 * t2208) - t2190 - (t711 * t861);
    const double t2215 = cos_theta * t2169;
    const double t2220 = (t750 * motion->constants[32]) - (t711 * motion->constants[33]);
    const double t2224 = (cos_theta * t2165) + (t872 * t2215) + (t2074 * t2152) - (t861 * t2220);
    const double t2227 = (motion->constants[54] * t2205) + (motion->constants[24] * t2224) -
        (motion->constants[55] * t2212);
    const double t2231 = (t2149 * t2159) + (t2161 * t2182) + (t2184 * t2198) - (t711 * t2227);
    const double t2232 = motion->constants[7] - t78;
    const double t2233 = cos_delta * motion->constants[47];
    const double t2234 = sin_delta * t2233;
    const double t2236 = t85 * t2234;
    const double t2238 = cos_delta * t2233;
    const double t2239 = t26 * t2238;
    const double t2241 = motion->constants[31] * t2238;
    const double t2243 = cos_delta * motion->constants[49];
    const double t2246 = t85 * t2233;
    const double t2248 = sin_delta * motion->constants[47];
    const double t2249 = t26 * t2248;
    const double t2251 = motion->constants[31] * t2248;
    const double t2254 = (t26 * t872) - t14;
    const double t2259 = t155 + (t124 * t872) + (sin_delta * t861);
    const double t2265 = (t872 * t2246) + (t861 * t2251) + (motion->constants[48] * t2254) +
        (motion->constants[49] * t2259) - (t2232 * t2233) - (t2074 * t2249);
    const double t2271 = (t872 * t2236) + (t2074 * t2239) + (t910 * t2243) - (t2232 * t2234) -
        (t861 * t2241) - (sin_delta * t2265);
    const double t2274 = (t2074 * t2145) + t2231 + t2271 - (motion->constants[41] * t861);
    const double t2277 = t14 * t2126;
    const double t2282 = t14 * t2133;
    const double t2284 = t14 * t2136;
    const double t2290 = (t933 * t2277) + (t110 * t1811) + (t199 * t2282) + (t233 * t2284) - (t82 *
        motion->constants[60]) - (t18 * t2129);
    const double t2291 = t2290 - (t107 * t1142);
    const double t2294 = (t14 * motion->constants[44]) + (t14 * motion->constants[47]);
    const double t2299 = t760 - (motion->constants[54] * t728);
    const double t2301 = t728 * motion->constants[24];
    const double t2307 = (t2159 * t2299) + (t2182 * t2301) + (t2161 * t2198) + (t750 * t2227);
    const double t2310 = (motion->constants[48] * t910) - (t2074 * t2294) - (t814 * t861) - t2307;
    const double t2312 = t93 - t970;
    const double t2313 = t933 * t2312;
    const double t2314 = motion->constants[7] * t930;
    const double t2318 = t2313 + (cos_phi * (motion->constants[60] + (t929 * t2314)));
    const double t2322 = (t14 * motion->constants[41]) + (t26 * motion->constants[40]);
    const double t2326 = (t711 * motion->constants[55]) + (motion->constants[54] * t750);
    const double t2328 = t750 * motion->constants[24];
    const double t2330 = t711 * motion->constants[24];
    const double t2335 = (t2159 * t2326) + (t2198 * t2330) + (cos_theta * t2227) - (t2182 * t2328);
    const double t2336 = sin_delta * t2248;
    const double t2338 = t85 * t2336;
    const double t2340 = cos_delta * t2248;
    const double t2341 = t26 * t2340;
    const double t2343 = motion->constants[31] * t2340;
    const double t2345 = sin_delta * motion->constants[49];
    const double t2352 = (t872 * t2338) + (t2074 * t2341) + (t910 * t2345) + (cos_delta * t2265) -
        (t2232 * t2336) - (t861 * t2343);
    const double t2355 = (t26 * motion->constants[41]) - (t14 * motion->constants[40]);
    const double t2359 = (motion->constants[7] * motion->constants[44]) - (t872 * t2322) - t2335 -
        t2352 - t2355;
    const double t2367 = (t82 * t1784) + (t924 * t930) + (t110 * t1772) - (t107 * t1786);
    const double t2370 = t26 * motion->constants[42];
    const double t2373 = t14 * motion->constants[42];
    const double t2376 = (t85 * t764) + (t26 * motion->constants[46]) - t2373;
    const double t2388 = (motion->constants[59] * t2205) + (motion->constants[57] * t2212) +
        (motion->constants[54] * t2224);
    const double t2394 = (motion->constants[58] * t2159) + (motion->constants[55] * t2198) -
        (motion->constants[54] * t2182);
    const double t2400 = (motion->constants[57] * t2205) + (motion->constants[56] * t2212) -
        (motion->constants[55] * t2224);
    const double t2406 = (t872 * t2376) + (t833 * t861) + (motion->constants[53] * t2254) +
        (motion->constants[30] * t2352) + (t728 * t2388) + (t750 * t2394);
    const double t2411 = t2406 + (t705 * t2400) - (motion->constants[7] * motion->constants[40]) -
        (t764 * t2232) - t2370 - (t14 * motion->constants[46]);
    const double t2414 = t2411 - (t1538 * t2074) - (motion->constants[51] * t2259) -
        (motion->constants[32] * t2335);
    const double t2419 = t1786 + (t199 * t1772) + (t233 * t1766);
    const double t2421 = t2355 - (t14 * motion->constants[67]);
    const double t2423 = motion->constants[43] + motion->constants[27];
    const double t2424 = motion->constants[71] + t2423;
    const double t2426 = motion->constants[30] * motion->constants[48];
    const double t2435 = t85 * t2345;
    const double t2439 = (t26 * t2243) - (t14 * motion->constants[48]);
    const double t2442 = t2426 + (motion->constants[31] * t2243);
    const double t2449 = t2123 + (t872 * t2435) + (t2074 * t2439) + (motion->constants[52] * t910) -
        (t2232 * t2345) - (t861 * t2442);
    const double t2452 = t85 * t2243;
    const double t2454 = t26 * t2345;
    const double t2456 = motion->constants[31] * t2345;
    const double t2464 = (t2232 * t2243) + (t2074 * t2454) + (motion->constants[51] * t2254) -
        (t872 * t2452) - (t861 * t2456) - (motion->constants[50] * t2259);
    const double t2470 = (t2074 * t2421) + (t910 * t2426) + (motion->constants[32] * t2307) +
        (motion->constants[33] * t2231) + (motion->constants[31] * t2271) + (cos_theta * t2394);
    const double t2475 = t2470 + (t711 * t2400) + (cos_delta * t2449) + (sin_delta * t2464) -
        (t861 * t2424) - (t750 * t2388);
    const double t2478 = t930 * t942;
    const double t2483 = (t286 * t1784) + t2478 + (t107 * t1772) + (t110 * t1786);
    const double t2487 = t2370 - (t14 * motion->constants[45]);
    const double t2500 = (motion->constants[7] * motion->constants[41]) + (t872 * t2487) + (t705 *
        t2388) + (t701 * t2400) + (cos_delta * t2464) - t2373;
    const double t2505 = t2500 - (t26 * motion->constants[45]) - (motion->constants[33] * t2335) -
        (motion->constants[31] * t2352) - (t711 * t2394) - (sin_delta * t2449);
    const double t2511 = t341 * t1760;
    const double t2515 = t2103 + (t329 * t1760);
    const double t2523 = (t149 * t2082) + (t162 * t2092) + (t191 * t2511) + (t358 * t2098) + (t369 *
        t1772) + (t461 * t1766);
    const double t2526 = t2523 - (t120 * t2079) - (t153 * t2087) - (t339 * t2515);
    const double t2527 = t6 * t26;
    const double t2529 = t6 * t14;
    const double t2537 = (t2274 * t2527) + (t18 * t2505) - (t2310 * t2529) - (t27 * t2414) -
        (sin_phi * t2475);
    const double t2539 = t71 * t1115;
    const double t2541 = t71 * t1058;
    const double t2543 = t71 * t1110;
    const double t2545 = t30 * t71;
    const double t2546 = t1086 * t2545;
    const double t2548 = t1108 * t2545;
    const double t2550 = cos_phi * t2539;
    const double t2556 = (t100 * t2539) + (t120 * t2541) + (t149 * t2543) + (t153 * t2546) - (t162 *
        t2548) - (t195 * t2550);
    const double t2559 = (t363 * t524) - (t518 * t561);
    const double t2561 = motion->constants[7] * t26;
    const double t2563 = motion->constants[7] * t14;
    const double t2569 = t2475 + (t2123 * t2559) + (t2310 * t2563) + (t363 * t2537) - (t2274 *
        t2561);
    const double t2572 = motion->constants[30] + t2563;
    const double t2574 = motion->constants[37] + t1032;
    const double t2575 = speeds[0] * cos_delta;
    const double t2578 = (t14 * t1007) + (speeds[0] * t2572) + (t2574 * t2575);
    const double t2582 = motion->constants[8] * t1071;
    const double t2583 = motion->constants[8] * t950;
    const double t2585 = (t965 * t2583) - t2582;
    const double t2587 = t960 * t1045;
    const double t2589 = t2587 + (t950 * t2583);
    const double t2594 = (t107 * t1014) + (t110 * t1009) + (t153 * t2585) + (t162 * t2589) - (t933 *
        t2578);
    const double t2596 = t34 * t2086;
    const double t2598 = (t32 * t518) - (t524 * t2596);
    const double t2601 = t34 * t2545;
    const double t2604 = (t2123 * t2598) + (t2569 * t2601) - (t2537 * t2596);
    const double t2606 = motion->constants[38] + t1036;
    const double t2607 = sin_delta * t2606;
    const double t2610 = t2561 - motion->constants[31];
    const double t2612 = (t26 * t1007) + (speeds[0] * t2610);
    const double t2614 = (speeds[0] * t2607) - (sin_delta * t2612);
    const double t2617 = t924 * t2574;
    const double t2620 = (motion->constants[30] * t924) - t2314;
    const double t2621 = t929 * t2620;
    const double t2627 = motion->constants[30] * t981;
    const double t2630 = (t981 * t2574) + (cos_delta * t2627) - (sin_delta * t1009);
    const double t2632 = sin_delta * t1014;
    const double t2636 = (motion->constants[8] * t1034) + (t950 * t1045);
    const double t2640 = (t965 * t1045) - (motion->constants[8] * t1038);
    const double t2644 = (cos_phi * ((t929 * t2617) + (cos_delta * t2621))) + (t153 * t2636) -
        (t933 * t2614) - (cos_delta * t2313);
    const double t2647 = t2644 - (t107 * t2630) - (t110 * t2632) - (t162 * t2640);
    const double t2648 = t30 * t326;
    const double t2649 = t524 * t2648;
    const double t2652 = t41 * t71;
    const double t2655 = (t2123 * t2649) + (t2537 * t2648) + (t2569 * t2652);
    const double t2659 = (cos_delta * t2612) - (t2575 * t2606);
    const double t2665 = (cos_delta * t1009) + (sin_delta * t2627);
    const double t2667 = cos_delta * t1014;
    const double t2669 = motion->constants[8] * t965;
    const double t2671 = t2587 + (t965 * t2669);
    const double t2674 = t2582 + (t950 * t2669);
    const double t2680 = (t117 * t2621) + (t110 * t2667) - (t933 * t2659) - (sin_delta * t2313) -
        (t107 * t2665) - (t153 * t2671);
    const double t2681 = t2680 - (t162 * t2674);
    const double t2683 = t32 * t2086;
    const double t2685 = (t34 * t518) + (t524 * t2683);
    const double t2688 = t32 * t2545;
    const double t2691 = (t2569 * t2688) - (t2123 * t2685) - (t2537 * t2683);
    const double t2693 = t31 * t1043;
    const double t2695 = t1040 * t2693;
    const double t2697 = t950 * t1040;
    const double t2699 = t965 * t1040;
    const double t2703 = (t120 * t2693) + (t153 * t2697) - (t149 * t2695) - (t162 * t2699);
    const double t2704 = t960 * t1036;
    const double t2708 = (t965 * t1036) + (t950 * t1032);
    const double t2709 = t2655 * t2708;
    const double t2710 = t960 * t1032;
    const double t2713 = t2709 - (t2604 * t2704) - (t2691 * t2710);
    const double t2716 = (motion->constants[7] * t1012) - t970;
    const double t2717 = t930 * t2716;
    const double t2726 = (t14 * t2274) + (t26 * t2310) + (t124 * t2691) - (t26 * t2604) - (t115 *
        t2655);
    const double t2729 = t2478 + (t110 * t981);
    const double t2730 = sin_delta * t2574;
    const double t2734 = (cos_delta * t2606) + (cos_delta * motion->constants[31]);
    const double t2737 = t2607 + (sin_delta * motion->constants[31]);
    const double t2740 = (t2655 * t2734) + (t2691 * t2737) - (t2604 * t2730);
    const double t2742 = motion->constants[41] * t943;
    const double t2743 = motion->constants[40] * t932;
    const double t2747 = t1369 - (t943 * t2423);
    const double t2750 = (t932 * t2423) - t945;
    const double t2754 = (t26 * t2750) - (t14 * t2747);
    const double t2760 = t982 + t982;
    const double t2761 = motion->constants[47] * t2760;
    const double t2764 = (t26 * (t1432 + t1432)) + (t14 * (t1430 + t1430)) + (t14 * t2761);
    const double t2766 = motion->constants[30] * t2761;
    const double t2768 = motion->constants[48] * t2760;
    const double t2770 = t1170 + t1170;
    const double t2772 = motion->constants[33] * t943;
    const double t2773 = motion->constants[32] * t932;
    const double t2774 = t2772 - t2773;
    const double t2776 = t1159 + t1159;
    const double t2778 = motion->constants[31] * t943;
    const double t2779 = motion->constants[30] * t932;
    const double t2780 = t2778 + t2779;
    const double t2782 = t984 + t984;
    const double t2787 = (sin_delta * t2782) + (cos_delta * t2780);
    const double t2791 = (sin_delta * t2780) - (cos_delta * t2782);
    const double t2793 = motion->constants[57] * t1198;
    const double t2797 = t1266 + t1267 - (motion->constants[59] * t1223);
    const double t2800 = (motion->constants[59] * t1198) - t1235;
    const double t2802 = motion->constants[54] * t1223;
    const double t2805 = t1290 + t1292;
    const double t2812 = (t2159 * t2797) + (t2212 * t2800) + (t2182 * t2802) + (t1301 * t2224) +
        (t1220 * t2394) - (t2205 * t2793);
    const double t2813 = t2812 - (t2198 * t2805);
    const double t2816 = t1235 - (motion->constants[56] * t1198);
    const double t2820 = (motion->constants[56] * t1231) - t1224 - t1233;
    const double t2823 = t1292 - t1291;
    const double t2826 = motion->constants[55] * t1231;
    const double t2833 = (t2205 * t2816) + (t2159 * t2820) + (t2212 * t2793) + (t2182 * t2823) +
        (t1288 * t2224) + (t2198 * t2826);
    const double t2834 = t2833 - (t1228 * t2394);
    const double t2837 = (motion->constants[58] * t1223) - t1267;
    const double t2840 = t1233 - (motion->constants[58] * t1231);
    const double t2842 = t1301 + t1301;
    const double t2844 = t2802 + t2826;
    const double t2846 = t1288 + t1288;
    const double t2854 = (t2205 * t2837) + (t2212 * t2840) + (t2224 * t2844) + (t1228 * t2400) -
        (t2182 * t2842) - (t2198 * t2846);
    const double t2855 = t2854 - (t1220 * t2388);
    const double t2857 = t965 * motion->constants[49];
    const double t2858 = motion->constants[48] * t950;
    const double t2859 = t2857 + t2858;
    const double t2861 = t1331 + t1331;
    const double t2863 = (cos_delta * t2859) - (sin_delta * t2861);
    const double t2865 = t85 * t2863;
    const double t2867 = t1344 + t1344;
    const double t2871 = (sin_delta * t2859) + (cos_delta * t2861);
    const double t2873 = (t14 * t2867) + (t26 * t2871);
    const double t2877 = (motion->constants[30] * t2867) - (motion->constants[31] * t2871);
    const double t2880 = motion->constants[28] * t950;
    const double t2882 = (motion->constants[52] * t950) + t2880 - t967;
    const double t2885 = motion->constants[28] * t965;
    const double t2887 = t1382 - (motion->constants[52] * t965) - t2885;
    const double t2890 = t1021 + t1046;
    const double t2891 = t1021 + t2890;
    const double t2893 = motion->constants[37] * t950;
    const double t2896 = (t965 * motion->constants[38]) - (speeds[1] * t2606);
    const double t2897 = t2893 + t2896;
    const double t2899 = t1023 + t1048;
    const double t2900 = t1023 + t2899;
    const double t2906 = (t872 * t2865) + (t2254 * t2882) + (speeds[1] * t2464) + (t2655 * t2897) -
        (t2232 * t2863) - (t2074 * t2873);
    const double t2910 = t2906 - (t861 * t2877) - (t2259 * t2887) - (t2604 * t2891) - (t2691 *
        t2900);
    const double t2914 = (cos_delta * t1331) + (sin_delta * t2857);
    const double t2916 = t85 * t2914;
    const double t2918 = t1335 - t1334;
    const double t2922 = (cos_delta * t2857) - (sin_delta * t1331);
    const double t2924 = (t14 * t2918) + (t26 * t2922);
    const double t2928 = (motion->constants[31] * t2922) - (motion->constants[30] * t2918);
    const double t2931 = t962 - (motion->constants[50] * t953);
    const double t2935 = (motion->constants[50] * t965) - t1380 - t1382;
    const double t2937 = motion->constants[51] * t953;
    const double t2942 = t1065 + t1078;
    const double t2945 = (speeds[1] * t2574) + t2942 - t1064 - (t34 * t2583);
    const double t2948 = t2899 + (t959 * t1032);
    const double t2951 = t2896 + (t34 * t2669);
    const double t2953 = t32 * t1040;
    const double t2959 = (t872 * t2916) + (t2074 * t2924) + (t2254 * t2931) + (t910 * t2935) +
        (t2604 * t2945) + (t2655 * t2948);
    const double t2964 = t2959 + (t2691 * t2951) + (t2713 * t2953) - (t2232 * t2914) - (t861 *
        t2928) - (t2259 * t2937);
    const double t2965 = t2964 - (speeds[1] * t2449);
    const double t2971 = (t872 * t2754) + (t910 * t2768) + (t2335 * t2774) + (t2231 * t2776) +
        (t2352 * t2780) + (t2655 * t2787);
    const double t2976 = t2971 + (t2691 * t2791) + (t711 * t2834) + (cos_theta * t2855) +
        (cos_delta * t2910) + (sin_delta * t2965);
    const double t2980 = t2976 - (motion->constants[7] * (t2742 + t2743)) - (t26 * t2747) - (t14 *
        t2750) - (t2074 * t2764);
    const double t2985 = t2980 - (t861 * t2766) - (t2307 * t2770) - (t2271 * t2782) - (t2604 *
        t2760) - (t750 * t2813);
    const double t2987 = t14 * t933;
    const double t2991 = (t110 * t930) - t2987 - (speeds[0] * t107);
    const double t2993 = motion->constants[42] * t934;
    const double t2994 = t26 * t2993;
    const double t2996 = t938 - (motion->constants[45] * t934);
    const double t2998 = t14 * t2993;
    const double t3000 = (t26 * t2996) - t2998;
    const double t3005 = t1001 - t1000;
    const double t3006 = motion->constants[47] * t3005;
    const double t3009 = (t26 * t2742) + (t14 * (t1481 - t1480)) + (t14 * t3006);
    const double t3015 = (motion->constants[45] * t943) - t1367 - t1369 - (motion->constants[30] *
        t3006);
    const double t3017 = motion->constants[48] * t3005;
    const double t3019 = t1162 + t1163;
    const double t3030 = t984 + (motion->constants[30] * t91);
    const double t3033 = (t91 * t2574) + (cos_delta * t3030) - (sin_delta * t2778);
    const double t3037 = (cos_delta * t2778) + (sin_delta * t3030);
    const double t3048 = (t872 * t3000) + (t2074 * t3009) + (t2231 * t2772) + (t984 * t2352) +
        (t2271 * t2778) + (t91 * t2414);
    const double t3053 = t3048 + (t2604 * t3005) + (t2655 * t3033) + (t2691 * t3037) + (t705 *
        t2813) + (t701 * t2834);
    const double t3058 = t3053 + (cos_delta * t2965) - (motion->constants[7] * t1432) - t2994 -
        (t14 * t2996) - (t861 * t3015);
    const double t3063 = t3058 - (t910 * t3017) - (t2307 * t3019) - (t1159 * t2335) - (t711 *
        t2855) - (sin_delta * t2910);
    const double t3065 = t26 * t933;
    const double t3069 = t3065 + (t107 * t930) + (speeds[0] * t110);
    const double t3072 = (motion->constants[46] * t934) - t938;
    const double t3075 = t1333 + t1335;
    const double t3077 = (cos_delta * t1344) - (sin_delta * t3075);
    const double t3078 = t85 * t3077;
    const double t3081 = t3078 - t2994 - (t14 * t3072);
    const double t3086 = motion->constants[47] * t2779;
    const double t3091 = (sin_delta * t1344) + (cos_delta * t3075);
    const double t3093 = (t14 * t2858) - (t26 * t3091);
    const double t3096 = (t14 * t2743) + (t14 * t3086) + t3093 - (t26 * (t1479 + t1481));
    const double t3102 = (motion->constants[30] * t2858) + (motion->constants[31] * t3091);
    const double t3106 = t944 + t945 - (motion->constants[46] * t932) - (motion->constants[30] *
        t3086) - t3102;
    const double t3110 = t966 + t967 - (motion->constants[53] * t950);
    const double t3112 = t3110 - (motion->constants[48] * t2779);
    const double t3116 = t1161 + t1163;
    const double t3119 = t999 + t1001;
    const double t3123 = t2893 + (t32 * t2583);
    const double t3124 = t2779 + t3123;
    const double t3128 = t2890 + (t959 * t1036);
    const double t3131 = (cos_delta * t982) + t3128 + (sin_delta * t3119);
    const double t3136 = t1063 + t2942 + (t32 * t2669);
    const double t3139 = (sin_delta * t982) - t3136 - (cos_delta * t3119);
    const double t3148 = (motion->constants[53] * t953) - t962;
    const double t3150 = t34 * t1040;
    const double t3154 = (t2232 * t3077) + (t2254 * t2937) + (t2259 * t3148) - (t2713 * t3150);
    const double t3159 = t2998 + (t872 * t3081) + (t2074 * t3096) + (t910 * t3112) + (t1170 *
        t2335) + (t2231 * t3116);
    const double t3164 = t3159 + (t982 * t2352) + (t2604 * t3124) + (t2655 * t3131) + (t2691 *
        t3139) + (t91 * t2740);
    const double t3169 = t3164 + (t728 * t2813) + (t705 * t2834) + (t750 * t2855) -
        (motion->constants[7] * t1430) - (t26 * t3072);
    const double t3174 = t3169 - (t861 * t3106) - (t2307 * t2773) - (t2271 * t3119) - (t91 *
        t2505) - t3154;
    const double t3183 = t2709 + (t2254 * t2880) + (t2259 * t2885) - (t1046 * t2604) - (t1048 *
        t2691);
    const double t3188 = t2314 + t2779;
    const double t3190 = (t932 * t2574) + (cos_delta * t3188);
    const double t3192 = sin_delta * t3188;
    const double t3197 = (t2314 * t2359) - (t970 * t2726);
    const double t3202 = t2985 + (t932 * t2414) + (t2655 * t3190) + (t2691 * t3192) + (t943 *
        t2740) - (t943 * t2505);
    const double t3203 = t3202 - t3197;
    const double t3205 = cos_phi * t2127;
    const double t3207 = cos_phi * t2277;
    const double t3210 = cos_phi * t2312;
    const double t3211 = (sin_phi * t2314) - t3210;
    const double t3213 = sin_phi * t924;
    const double t3215 = speeds[0] * cos_phi;
    const double t3217 = sin_phi * t942;
    const double t3219 = cos_phi * t2578;
    const double t3224 = t3210 + (sin_phi * t2620);
    const double t3227 = (sin_phi * t2617) + (cos_phi * t2614) + (cos_delta * t3224);
    const double t3231 = (cos_phi * t2659) + (sin_delta * t3224);
    const double t3233 = sin_phi * t2716;
    const double t3243 = (t2274 * t3205) + (t2359 * t3211) + (t2414 * t3213) + (t2604 * t3219) +
        (t2655 * t3227) + (t2691 * t3231);
    const double t3248 = t3243 + (t2726 * t3233) + (t2740 * t3217) + (t18 * t3063) - (t2310 *
        t3207) - (t2475 * t3215);
    const double t3251 = t3248 - (t2505 * t3217) - (sin_phi * t2985) - (t27 * t3174);
    const double t3257 = (t364 * t2059) + (t107 * t1994) + (t369 * t2066) + (t2074 * t2077) +
        (t2120 * t2123) + (t2144 * t2274);
    const double t3262 = t3257 + (t2291 * t2310) + (t2318 * t2359) + (t2367 * t2414) + (t2419 *
        t2475) + (t2526 * t2537);
    const double t3267 = t3262 + (t2556 * t2569) + (t2594 * t2604) + (t2647 * t2655) + (t2681 *
        t2691) + (t2703 * t2713);
    const double t3272 = t3267 + (t2717 * t2726) + (t2729 * t2740) + (t2991 * t3063) + (t3069 *
        t3174) + (t620 * t3183);
    const double t3277 = t3272 + (t235 * t3203) - (t465 * t3251) - (t364 * t1997) - (t110 * t1949) -
        (t199 * t2058);
    const double t3281 = t3277 - (t566 * t2068) - (t872 * t2072) - (t2483 * t2505) - (t930 * t2985);
    const double t3289 = motion->constants[7] * t1534;
    const double t3293 = (t690 * motion->constants[28]) + (motion->constants[28] * t1557);
    const double t3299 = (t1536 * t2155) - (cos_theta * t1534);
    const double t3305 = (t2174 * t3289) - (t1536 * t2170) - (t1534 * t2178);
    const double t3311 = (t1536 * t2186) + (t2190 * t3289) - (t1534 * t2194);
    const double t3315 = (t1536 * t2201) + (t750 * t1534);
    const double t3319 = (t1536 * t2208) - (t711 * t1534);
    const double t3325 = (t1536 * t2215) + (t2152 * t3289) - (t1534 * t2220);
    const double t3328 = (motion->constants[54] * t3315) + (motion->constants[24] * t3325) -
        (motion->constants[55] * t3319);
    const double t3332 = (t2149 * t3299) + (t2161 * t3305) + (t2184 * t3311) - (t711 * t3328);
    const double t3341 = (t26 * t1536) - 1.0;
    const double t3345 = (t124 * t1536) + (sin_delta * t1534);
    const double t3350 = (t1536 * t2246) + (t1534 * t2251) + (motion->constants[48] * t3341) +
        (motion->constants[49] * t3345) - (t2249 * t3289);
    const double t3355 = (t1536 * t2236) + (t2239 * t3289) - (t1534 * t2241) - (t1557 * t2243) -
        (sin_delta * t3350);
    const double t3358 = (t2145 * t3289) + t3332 + t3355 - (motion->constants[41] * t1534);
    const double t3369 = (t2299 * t3299) + (t2301 * t3305) + (t2161 * t3311) + (t750 * t3328);
    const double t3372 = (t2294 * t3289) + (t814 * t1534) + (motion->constants[48] * t1557) + t3369;
    const double t3381 = (t2326 * t3299) + (t2330 * t3311) + (cos_theta * t3328) - (t2328 * t3305);
    const double t3390 = (t1536 * t2338) + (t2341 * t3289) + (cos_delta * t3350) - (t1534 * t2343) -
        (t1557 * t2345);
    const double t3392 = (t1536 * t2322) + t3381 + t3390;
    const double t3405 = (motion->constants[59] * t3315) + (motion->constants[57] * t3319) +
        (motion->constants[54] * t3325);
    const double t3411 = (motion->constants[58] * t3299) + (motion->constants[55] * t3311) -
        (motion->constants[54] * t3305);
    const double t3417 = (motion->constants[57] * t3315) + (motion->constants[56] * t3319) -
        (motion->constants[55] * t3325);
    const double t3423 = (t1536 * t2376) + (t833 * t1534) + (motion->constants[53] * t3341) +
        (motion->constants[30] * t3390) + (t728 * t3405) + (t750 * t3411);
    const double t3427 = t3423 + (t705 * t3417) - (t1538 * t3289) - (motion->constants[51] *
        t3345) - (motion->constants[32] * t3381);
    const double t3445 = (t1536 * t2435) + (t2439 * t3289) - t3293 - (t1534 * t2442) -
        (motion->constants[52] * t1557);
    const double t3455 = (t2454 * t3289) + (motion->constants[51] * t3341) - (t1536 * t2452) -
        (t1534 * t2456) - (motion->constants[50] * t3345);
    const double t3461 = (t2421 * t3289) + (motion->constants[32] * t3369) +
        (motion->constants[33] * t3332) + (motion->constants[31] * t3355) + (cos_theta * t3411) +
        (t711 * t3417);
    const double t3466 = t3461 + (cos_delta * t3445) + (sin_delta * t3455) - (t1534 * t2424) -
        (t1557 * t2426) - (t750 * t3405);
    const double t3480 = (t1536 * t2487) + (t705 * t3405) + (t701 * t3417) + (cos_delta * t3455) -
        (motion->constants[33] * t3381) - (motion->constants[31] * t3390);
    const double t3482 = t3480 - (t711 * t3411) - (sin_delta * t3445);
    const double t3492 = (t2527 * t3358) + (t2529 * t3372) + (t18 * t3482) - (t27 * t3427) -
        (sin_phi * t3466);
    const double t3501 = t3466 + (t363 * t3492) - (t2559 * t3293) - (t2561 * t3358) - (t2563 *
        t3372);
    const double t3507 = (t2601 * t3501) - (t2598 * t3293) - (t2596 * t3492);
    const double t3513 = (t2648 * t3492) + (t2652 * t3501) - (t2649 * t3293);
    const double t3519 = (t2685 * t3293) + (t2688 * t3501) - (t2683 * t3492);
    const double t3522 = t2708 * t3513;
    const double t3525 = t3522 - (t2704 * t3507) - (t2710 * t3519);
    const double t3535 = (t14 * t3358) + (t124 * t3519) - (t26 * t3372) - (t26 * t3507) - (t115 *
        t3513);
    const double t3541 = (t2734 * t3513) + (t2737 * t3519) - (t2730 * t3507);
    const double t3566 = (t2797 * t3299) + (t2800 * t3319) + (t2802 * t3305) + (t1301 * t3325) +
        (t1220 * t3411) - (t2793 * t3315);
    const double t3567 = t3566 - (t2805 * t3311);
    const double t3580 = (t2816 * t3315) + (t2820 * t3299) + (t2793 * t3319) + (t2823 * t3305) +
        (t1288 * t3325) + (t2826 * t3311);
    const double t3581 = t3580 - (t1228 * t3411);
    const double t3594 = (t2837 * t3315) + (t2840 * t3319) + (t2844 * t3325) + (t1228 * t3417) -
        (t2842 * t3305) - (t2846 * t3311);
    const double t3595 = t3594 - (t1220 * t3405);
    const double t3610 = (t1536 * t2865) + (t2882 * t3341) + (speeds[1] * t3455) + (t2897 * t3513) -
        (t2873 * t3289) - (t1534 * t2877);
    const double t3613 = t3610 - (t2887 * t3345) - (t2891 * t3507) - (t2900 * t3519);
    const double t3630 = (t1536 * t2916) + (t2924 * t3289) + (t2931 * t3341) + (t2945 * t3507) +
        (t2948 * t3513) + (t2951 * t3519);
    const double t3635 = t3630 + (t2953 * t3525) - (t1534 * t2928) - (t1557 * t2935) - (t2937 *
        t3345) - (speeds[1] * t3445);
    const double t3641 = (t1536 * t2754) + (t2774 * t3381) + (t2776 * t3332) + (t2780 * t3390) +
        (t2787 * t3513) + (t2791 * t3519);
    const double t3646 = t3641 + (t711 * t3581) + (cos_theta * t3595) + (cos_delta * t3613) +
        (sin_delta * t3635) - (t2764 * t3289);
    const double t3651 = t3646 - (t1534 * t2766) - (t1557 * t2768) - (t2770 * t3369) - (t2782 *
        t3355) - (t2760 * t3507);
    const double t3652 = t3651 - (t750 * t3567);
    const double t3676 = (t1536 * t3000) + (t3009 * t3289) + (t1557 * t3017) + (t2772 * t3332) +
        (t984 * t3390) + (t2778 * t3355);
    const double t3681 = t3676 + (t91 * t3427) + (t3005 * t3507) + (t3033 * t3513) + (t3037 *
        t3519) + (t705 * t3567);
    const double t3686 = t3681 + (t701 * t3581) + (cos_delta * t3635) - (t1534 * t3015) - (t3019 *
        t3369) - (t1159 * t3381);
    const double t3688 = t3686 - (t711 * t3595) - (sin_delta * t3613);
    const double t3711 = (t3150 * t3525) - (t2937 * t3341) - (t3148 * t3345);
    const double t3716 = (t1536 * t3081) + (t3096 * t3289) + (t1170 * t3381) + (t3116 * t3332) +
        (t982 * t3390) + (t3124 * t3507);
    const double t3721 = t3716 + (t3131 * t3513) + (t3139 * t3519) + (t91 * t3541) + (t728 *
        t3567) + (t705 * t3581);
    const double t3726 = t3721 + (t750 * t3595) + t3711 - (t1534 * t3106) - (t1557 * t3112) -
        (t2773 * t3369);
    const double t3728 = t3726 - (t3119 * t3355) - (t91 * t3482);
    const double t3737 = t3522 + (t2880 * t3341) + (t2885 * t3345) - (t1046 * t3507) - (t1048 *
        t3519);
    const double t3746 = (t2314 * t3392) + (t970 * t3535);
    const double t3751 = t3652 + (t932 * t3427) + (t3190 * t3513) + (t3192 * t3519) + (t943 *
        t3541) + t3746;
    const double t3752 = t3751 - (t943 * t3482);
    const double t3772 = (t3205 * t3358) + (t3207 * t3372) + (t3213 * t3427) + (t3219 * t3507) +
        (t3227 * t3513) + (t3231 * t3519);
    const double t3777 = t3772 + (t3233 * t3535) + (t3217 * t3541) + (t18 * t3688) - (t3211 *
        t3392) - (t3215 * t3466);
    const double t3780 = t3777 - (t3217 * t3482) - (sin_phi * t3652) - (t27 * t3728);
    const double t3787 = (t447 * t2059) + (t461 * t2066) + (t2077 * t3289) + (t2144 * t3358) +
        (t2367 * t3427) + (t2419 * t3466);
    const double t3792 = t3787 + (t2526 * t3492) + (t2556 * t3501) + (t2594 * t3507) + (t2647 *
        t3513) + (t2681 * t3519);
    const double t3797 = t3792 + (t2703 * t3525) + (t2717 * t3535) + (t2729 * t3541) + (t2991 *
        t3688) + (t3069 * t3728);
    const double t3802 = t3797 + (t620 * t3737) + (t235 * t3752) - (t465 * t3780) - (t447 * t1997) -
        (t233 * t2058);
    const double t3807 = t3802 - (t617 * t2068) - (t1536 * t2072) - (t2120 * t3293) - (t2291 *
        t3372) - (t2318 * t3392);
    const double t3810 = t3807 - (t2483 * t3482) - (t930 * t3652) - (t1568 * t3281);
    const double t3814 = (motion->constants[3] * motion->constants[55]) - (motion->constants[2] *
        motion->constants[54]);
    const double t3815 = t711 * t3814;
    const double t3817 = t750 * t3814;
    const double t3819 = cos_theta * t3814;
    const double t3822 = t1620 + (motion->constants[32] * t3819);
    const double t3827 = (motion->constants[32] * t3817) - t1611 - (motion->constants[33] * t3815);
    const double t3830 = t1626 + (motion->constants[33] * t3819);
    const double t3840 = (t2529 * t3817) + (t27 * t3822) - (t2527 * t3815) - (sin_phi * t3827) -
        (t18 * t3830);
    const double t3847 = t3827 + (t2561 * t3815) + (t363 * t3840) - (t2563 * t3817);
    const double t3851 = (t2601 * t3847) - (t2596 * t3840);
    const double t3855 = (t2648 * t3840) + (t2652 * t3847);
    const double t3859 = (t2688 * t3847) - (t2683 * t3840);
    const double t3862 = t2708 * t3855;
    const double t3865 = t3862 - (t2704 * t3851) - (t2710 * t3859);
    const double t3875 = (t124 * t3859) - (t14 * t3815) - (t26 * t3817) - (t26 * t3851) - (t115 *
        t3855);
    const double t3881 = (t2734 * t3855) + (t2737 * t3859) - (t2730 * t3851);
    const double t3891 = (motion->constants[2] * t2793) - (motion->constants[3] * t2800);
    const double t3895 = (motion->constants[2] * t2816) + (motion->constants[3] * t2793);
    const double t3903 = (t1220 * motion->constants[77]) - (motion->constants[2] * t2837) -
        (motion->constants[3] * t2840) - (t1228 * motion->constants[76]);
    const double t3909 = (t2897 * t3855) - (t2891 * t3851) - (t2900 * t3859);
    const double t3917 = (t2945 * t3851) + (t2948 * t3855) + (t2951 * t3859) + (t2953 * t3865);
    const double t3923 = (t2774 * t3819) + (t2787 * t3855) + (t2791 * t3859) + (cos_theta * t3903) +
        (cos_delta * t3909) + (sin_delta * t3917);
    const double t3928 = t3923 - (t2770 * t3817) - (t2776 * t3815) - (t2760 * t3851) - (t750 *
        t3891) - (t711 * t3895);
    const double t3946 = (t3005 * t3851) + (t3033 * t3855) + (t3037 * t3859) + (t705 * t3891) +
        (cos_delta * t3917) - (t3019 * t3817);
    const double t3951 = t3946 - (t1159 * t3819) - (t2772 * t3815) - (t91 * t3822) - (t701 *
        t3895) - (t711 * t3903);
    const double t3952 = t3951 - (sin_delta * t3909);
    const double t3961 = t3150 * t3865;
    const double t3970 = (t1170 * t3819) + (t91 * t3830) + (t3124 * t3851) + (t3131 * t3855) +
        (t3139 * t3859) + t3961;
    const double t3975 = t3970 + (t91 * t3881) + (t728 * t3891) + (t750 * t3903) - (t2773 * t3817) -
        (t3116 * t3815);
    const double t3976 = t3975 - (t705 * t3895);
    const double t3981 = t3862 - (t1046 * t3851) - (t1048 * t3859);
    const double t3990 = (t2314 * t3819) + (t970 * t3875);
    const double t3995 = t3928 + (t943 * t3830) + (t3190 * t3855) + (t3192 * t3859) + (t943 *
        t3881) + t3990;
    const double t3996 = t3995 - (t932 * t3822);
    const double t4016 = (t3207 * t3817) + (t3217 * t3830) + (t3219 * t3851) + (t3227 * t3855) +
        (t3231 * t3859) + (t3233 * t3875);
    const double t4021 = t4016 + (t3217 * t3881) + (t18 * t3952) - (t3205 * t3815) - (t3211 *
        t3819) - (t3213 * t3822);
    const double t4024 = t4021 - (t3215 * t3827) - (sin_phi * t3928) - (t27 * t3976);
    const double t4032 = (t2419 * t3827) + (t2483 * t3830) + (t2526 * t3840) + (t2556 * t3847) +
        (t2594 * t3851) + (t2647 * t3855);
    const double t4037 = t4032 + (t2681 * t3859) + (t2703 * t3865) + (t2717 * t3875) + (t2729 *
        t3881) + (t2991 * t3952);
    const double t4042 = t4037 + (t3069 * t3976) + (t620 * t3981) + (t235 * t3996) - (t465 *
        t4024) - (t2144 * t3815);
    const double t4047 = t4042 - (t2291 * t3817) - (t2318 * t3819) - (t2367 * t3822) - (t930 *
        t3928) - (t1640 * t3281);
    const double t4048 = t4047 - (t1644 * t3810);
    const double t4052 = t341 * t2066;
    const double t4054 = t329 * t2066;
    const double t4059 = motion->constants[7] - (motion->constants[7] * t1669);
    const double t4063 = (motion->constants[28] * t1692) - (t693 * motion->constants[28]);
    const double t4069 = (t1671 * t2155) + (cos_theta * t1669);
    const double t4075 = (t2174 * t4059) + (t1669 * t2178) - (t1671 * t2170);
    const double t4081 = (t1671 * t2186) + (t2190 * t4059) + (t1669 * t2194);
    const double t4085 = (t1671 * t2201) - (t750 * t1669);
    const double t4089 = (t1671 * t2208) + (t711 * t1669);
    const double t4095 = (t1671 * t2215) + (t2152 * t4059) + (t1669 * t2220);
    const double t4098 = (motion->constants[54] * t4085) + (motion->constants[24] * t4095) -
        (motion->constants[55] * t4089);
    const double t4102 = (t2149 * t4069) + (t2161 * t4075) + (t2184 * t4081) - (t711 * t4098);
    const double t4110 = t26 * t1671;
    const double t4114 = (sin_delta * t1669) - (t124 * t1671);
    const double t4119 = (t1671 * t2246) + (motion->constants[48] * t4110) - (t2249 * t4059) -
        (t1669 * t2251) - (motion->constants[49] * t4114);
    const double t4124 = (t1671 * t2236) + (t2239 * t4059) + (t1669 * t2241) + (t1692 * t2243) -
        (sin_delta * t4119);
    const double t4127 = (t2145 * t4059) + (motion->constants[41] * t1669) + t4102 + t4124;
    const double t4138 = (t2299 * t4069) + (t2301 * t4075) + (t2161 * t4081) + (t750 * t4098);
    const double t4141 = (t814 * t1669) + (motion->constants[48] * t1692) - (t2294 * t4059) - t4138;
    const double t4150 = (t2326 * t4069) + (t2330 * t4081) + (cos_theta * t4098) - (t2328 * t4075);
    const double t4159 = (t1671 * t2338) + (t2341 * t4059) + (t1669 * t2343) + (t1692 * t2345) +
        (cos_delta * t4119);
    const double t4161 = (t1671 * t2322) + t4150 + t4159;
    const double t4174 = (motion->constants[59] * t4085) + (motion->constants[57] * t4089) +
        (motion->constants[54] * t4095);
    const double t4180 = (motion->constants[58] * t4069) + (motion->constants[55] * t4081) -
        (motion->constants[54] * t4075);
    const double t4186 = (motion->constants[57] * t4085) + (motion->constants[56] * t4089) -
        (motion->constants[55] * t4095);
    const double t4192 = (t1671 * t2376) + (motion->constants[53] * t4110) +
        (motion->constants[51] * t4114) + (motion->constants[30] * t4159) + (t728 * t4174) + (t750 *
        t4180);
    const double t4196 = t4192 + (t705 * t4186) - (t1538 * t4059) - (t833 * t1669) -
        (motion->constants[32] * t4150);
    const double t4214 = t4063 + (t1671 * t2435) + (t2439 * t4059) + (t1669 * t2442) +
        (motion->constants[52] * t1692);
    const double t4224 = (t2454 * t4059) + (t1669 * t2456) + (motion->constants[51] * t4110) +
        (motion->constants[50] * t4114) - (t1671 * t2452);
    const double t4230 = (t2421 * t4059) + (t1669 * t2424) + (t1692 * t2426) +
        (motion->constants[32] * t4138) + (motion->constants[33] * t4102) + (motion->constants[31] *
        t4124);
    const double t4235 = t4230 + (cos_theta * t4180) + (t711 * t4186) + (cos_delta * t4214) +
        (sin_delta * t4224) - motion->constants[27];
    const double t4236 = t4235 - (t750 * t4174);
    const double t4250 = (t1671 * t2487) + (t705 * t4174) + (t701 * t4186) + (cos_delta * t4224) -
        (motion->constants[33] * t4150) - (motion->constants[31] * t4159);
    const double t4252 = t4250 - (t711 * t4180) - (sin_delta * t4214);
    const double t4262 = (t2527 * t4127) + (t18 * t4252) - (t2529 * t4141) - (t27 * t4196) -
        (sin_phi * t4236);
    const double t4271 = t4236 + (t2559 * t4063) + (t2563 * t4141) + (t363 * t4262) - (t2561 *
        t4127);
    const double t4277 = (t2598 * t4063) + (t2601 * t4271) - (t2596 * t4262);
    const double t4283 = (t2649 * t4063) + (t2648 * t4262) + (t2652 * t4271);
    const double t4289 = (t2688 * t4271) - (t2685 * t4063) - (t2683 * t4262);
    const double t4292 = t2708 * t4283;
    const double t4295 = t4292 - (t2704 * t4277) - (t2710 * t4289);
    const double t4305 = (t14 * t4127) + (t26 * t4141) + (t124 * t4289) - (t26 * t4277) - (t115 *
        t4283);
    const double t4311 = (t2734 * t4283) + (t2737 * t4289) - (t2730 * t4277);
    const double t4336 = (t2797 * t4069) + (t2800 * t4089) + (t2802 * t4075) + (t1301 * t4095) +
        (t1220 * t4180) - (t2793 * t4085);
    const double t4337 = t4336 - (t2805 * t4081);
    const double t4350 = (t2816 * t4085) + (t2820 * t4069) + (t2793 * t4089) + (t2823 * t4075) +
        (t1288 * t4095) + (t2826 * t4081);
    const double t4351 = t4350 - (t1228 * t4180);
    const double t4364 = (t2837 * t4085) + (t2840 * t4089) + (t2844 * t4095) + (t1228 * t4186) -
        (t2842 * t4075) - (t2846 * t4081);
    const double t4365 = t4364 - (t1220 * t4174);
    const double t4380 = (t1671 * t2865) + (t1669 * t2877) + (t2882 * t4110) + (t2887 * t4114) +
        (speeds[1] * t4224) + (t2897 * t4283);
    const double t4383 = t4380 - (t2873 * t4059) - (t2891 * t4277) - (t2900 * t4289);
    const double t4400 = (t1671 * t2916) + (t2924 * t4059) + (t1669 * t2928) + (t2931 * t4110) +
        (t1692 * t2935) + (t2937 * t4114);
    const double t4405 = t4400 + (t2945 * t4277) + (t2948 * t4283) + (t2951 * t4289) + (t2953 *
        t4295) - (speeds[1] * t4214);
    const double t4411 = (t1671 * t2754) + (t1669 * t2766) + (t1692 * t2768) + (t2774 * t4150) +
        (t2776 * t4102) + (t2780 * t4159);
    const double t4416 = t4411 + (t2787 * t4283) + (t2791 * t4289) + (t711 * t4351) + (cos_theta *
        t4365) + (cos_delta * t4383);
    const double t4421 = t4416 + (sin_delta * t4405) - (t2764 * t4059) - (t2770 * t4138) - (t2782 *
        t4124) - (t2760 * t4277);
    const double t4422 = t4421 - (t750 * t4337);
    const double t4446 = (t1671 * t3000) + (t3009 * t4059) + (t1669 * t3015) + (t2772 * t4102) +
        (t984 * t4159) + (t2778 * t4124);
    const double t4451 = t4446 + (t91 * t4196) + (t3005 * t4277) + (t3033 * t4283) + (t3037 *
        t4289) + (t705 * t4337);
    const double t4456 = t4451 + (t701 * t4351) + (cos_delta * t4405) - (t1692 * t3017) - (t3019 *
        t4138) - (t1159 * t4150);
    const double t4458 = t4456 - (t711 * t4365) - (sin_delta * t4383);
    const double t4481 = (t3150 * t4295) + (t3148 * t4114) - (t2937 * t4110);
    const double t4486 = (t1671 * t3081) + (t3096 * t4059) + (t1669 * t3106) + (t1692 * t3112) +
        (t1170 * t4150) + (t3116 * t4102);
    const double t4491 = t4486 + (t982 * t4159) + (t3124 * t4277) + (t3131 * t4283) + (t3139 *
        t4289) + (t91 * t4311);
    const double t4496 = t4491 + (t728 * t4337) + (t705 * t4351) + (t750 * t4365) + t4481 - (t2773 *
        t4138);
    const double t4498 = t4496 - (t3119 * t4124) - (t91 * t4252);
    const double t4507 = t4292 + (t2880 * t4110) - (t2885 * t4114) - (t1046 * t4277) - (t1048 *
        t4289);
    const double t4516 = (t2314 * t4161) + (t970 * t4305);
    const double t4521 = t4422 + (t932 * t4196) + (t3190 * t4283) + (t3192 * t4289) + (t943 *
        t4311) + t4516;
    const double t4522 = t4521 - (t943 * t4252);
    const double t4542 = (t3205 * t4127) + (t3213 * t4196) + (t3219 * t4277) + (t3227 * t4283) +
        (t3231 * t4289) + (t3233 * t4305);
    const double t4547 = t4542 + (t3217 * t4311) + (t18 * t4458) - (t3207 * t4141) - (t3211 *
        t4161) - (t3215 * t4236);
    const double t4550 = t4547 - (t3217 * t4252) - (sin_phi * t4422) - (t27 * t4498);
    const double t4559 = (t328 * t2059) + (t191 * t4052) + (t2077 * t4059) + (t2120 * t4063) +
        (t2144 * t4127) + (t2291 * t4141);
    const double t4564 = t4559 + (t2367 * t4196) + (t2419 * t4236) + (t2526 * t4262) + (t2556 *
        t4271) + (t2594 * t4277);
    const double t4569 = t4564 + (t2647 * t4283) + (t2681 * t4289) + (t2703 * t4295) + (t2717 *
        t4305) + (t2729 * t4311);
    const double t4574 = t4569 + (t2991 * t4458) + (t3069 * t4498) + (t620 * t4507) + (t235 *
        t4522) - (t465 * t4550);
    const double t4579 = t4574 + (t1722 * t4048) - (t328 * t1997) - (t339 * t4054) - (t543 *
        t1978) - (t1671 * t2072);
    const double t4584 = t4579 - (t2318 * t4161) - (t2483 * t4252) - (t930 * t4422) - (t1700 *
        t3281) - (t1716 * t3810);
    const double t4585 = t1759 * t4584;
    const double t4587 = (t1652 * t4048) + (t1722 * t4585);
    const double t4591 = (t1586 * t3810) - (t1644 * t4587) - (t1716 * t4585);
    const double t4597 = (t923 * t3281) - (t1568 * t4591) - (t1640 * t4587) - (t1700 * t4585);
    const double t4600 = motion->constants[47] * t1800;
    const double t4604 = motion->constants[47] * t1815;
    const double t4608 = (cos_delta * (t1927 + (sin_delta * t4600))) - (sin_delta * (t1934 +
        (sin_delta * t4604)));
    const double t4623 = (t14 * t2019) + (t115 * t1963) + (t85 * t4608) - (t240 * t1949) - (t242 *
        t1994);
    const double t4631 = (cos_delta * ((cos_delta * t4600) - t1934)) - (sin_delta * (t1927 +
        (cos_delta * t4604)));
    const double t4636 = (t26 * t4631) + (t242 * t2034) - (t240 * t2041);
    const double t4639 = t1984 + (motion->constants[31] * t4631);
    const double t4643 = (t1800 * t2243) - (t1815 * t2345);
    const double t4660 = (t260 * t2083) + (t264 * t2089) + (t268 * t2094) + (t481 * t2099) + (t629 *
        t2101) + (t634 * t1760);
    const double t4665 = t4660 + (t649 * t2107) + (t675 * t2109) - (t245 * t2080) - (t642 * t2096) -
        (t472 * t2104);
    const double t4674 = (t240 * t1811) + (t242 * t1142) - (t303 * t2134) - (t311 * t2137);
    const double t4682 = (t242 * t1811) + (t303 * t2282) + (t311 * t2284) - (t240 * t1142);
    const double t4688 = (t242 * t1772) - (t240 * t1786);
    const double t4692 = (t303 * t1772) + (t311 * t1766);
    const double t4696 = (t240 * t1772) + (t242 * t1786);
    const double t4711 = (t260 * t2082) + (t268 * t2092) + (t296 * t2511) + (t481 * t2098) + (t486 *
        t1772) + (t512 * t1766);
    const double t4714 = t4711 - (t245 * t2079) - (t264 * t2087) - (t472 * t2515);
    const double t4724 = (t245 * t2541) + (t260 * t2543) + (t264 * t2546) - (t268 * t2548) - (t301 *
        t2550);
    const double t4736 = (t240 * t1014) + (t242 * t1009) + (t264 * t2585) + (t268 * t2589) -
        (t1026 * t2574) - (t1027 * t2574);
    const double t4739 = (t1004 * t2606) - t1018;
    const double t4742 = t996 + (t992 * t2606);
    const double t4752 = (cos_delta * t4739) + (t264 * t2636) - (sin_delta * t4742) - (t240 *
        t2630) - (t242 * t2632) - (t268 * t2640);
    const double t4764 = (cos_delta * t4742) + (sin_delta * t4739) + (t242 * t2667) - (t240 *
        t2665) - (t264 * t2671) - (t268 * t2674);
    const double t4772 = (t245 * t2693) + (t264 * t2697) - (t260 * t2695) - (t268 * t2699);
    const double t4774 = t242 * t981;
    const double t4780 = (t242 * t930) - (speeds[0] * t240);
    const double t4784 = (t240 * t930) + (speeds[0] * t242);
    const double t4793 = (t26 * t2019) + (t247 * t1963) + (t240 * t1994) + (t486 * t2066) + (t872 *
        t4623) + (t2074 * t4636);
    const double t4798 = t4793 + (t910 * t4643) + (t2123 * t4665) + (t2274 * t4674) + (t2310 *
        t4682) + (t1923 * t2464);
    const double t4803 = t4798 + (t2414 * t4688) + (t2475 * t4692) + (t2537 * t4714) + (t2569 *
        t4724) + (t2604 * t4736);
    const double t4808 = t4803 + (t2655 * t4752) + (t2691 * t4764) + (t2713 * t4772) + (t2740 *
        t4774) + (t953 * t2965);
    const double t4813 = t4808 + (t3063 * t4780) + (t3174 * t4784) + (t678 * t3183) + (t313 *
        t3203) - (t516 * t3251);
    const double t4818 = t4813 - (t2232 * t4608) - (t242 * t1949) - (t303 * t2058) - (t649 *
        t2068) - (t861 * t4639);
    const double t4822 = t4818 - (t1919 * t2265) - (t1821 * t2449) - (t2505 * t4696) - (t950 *
        t2910);
    const double t4859 = (t512 * t2066) + (t1536 * t4623) + (t3289 * t4636) + (t3358 * t4674) +
        (t1923 * t3455) + (t3427 * t4688);
    const double t4864 = t4859 + (t3466 * t4692) + (t3492 * t4714) + (t3501 * t4724) + (t3507 *
        t4736) + (t3513 * t4752);
    const double t4869 = t4864 + (t3519 * t4764) + (t3525 * t4772) + (t3541 * t4774) + (t953 *
        t3635) + (t3688 * t4780);
    const double t4874 = t4869 + (t3728 * t4784) + (t678 * t3737) + (t313 * t3752) - (t516 *
        t3780) - (t311 * t2058);
    const double t4879 = t4874 - (t675 * t2068) - (t1534 * t4639) - (t1557 * t4643) - (t3293 *
        t4665) - (t1919 * t3350);
    const double t4884 = t4879 - (t3372 * t4682) - (t1821 * t3445) - (t3482 * t4696) - (t950 *
        t3613) - (t1568 * t4822);
    const double t4911 = (t3827 * t4692) + (t3830 * t4696) + (t3840 * t4714) + (t3847 * t4724) +
        (t3851 * t4736) + (t3855 * t4752);
    const double t4916 = t4911 + (t3859 * t4764) + (t3865 * t4772) + (t3881 * t4774) + (t953 *
        t3917) + (t3952 * t4780);
    const double t4921 = t4916 + (t3976 * t4784) + (t678 * t3981) + (t313 * t3996) - (t516 *
        t4024) - (t3815 * t4674);
    const double t4926 = t4921 - (t3817 * t4682) - (t3822 * t4688) - (t950 * t3909) - (t1640 *
        t4822) - (t1644 * t4884);
    const double t4965 = (t296 * t4052) + (t1671 * t4623) + (t4059 * t4636) + (t1669 * t4639) +
        (t1692 * t4643) + (t4063 * t4665);
    const double t4970 = t4965 + (t4127 * t4674) + (t4141 * t4682) + (t1923 * t4224) + (t4196 *
        t4688) + (t4236 * t4692);
    const double t4975 = t4970 + (t4262 * t4714) + (t4271 * t4724) + (t4277 * t4736) + (t4283 *
        t4752) + (t4289 * t4764);
    const double t4980 = t4975 + (t4295 * t4772) + (t4311 * t4774) + (t953 * t4405) + (t4458 *
        t4780) + (t4498 * t4784);
    const double t4985 = t4980 + (t678 * t4507) + (t313 * t4522) - (t516 * t4550) + (t1722 *
        t4926) - (t472 * t4054);
    const double t4990 = t4985 - (t634 * t1978) - (t1919 * t4119) - (t1821 * t4214) - (t4252 *
        t4696) - (t950 * t4383);
    const double t4993 = t1759 * (t4990 - (t1700 * t4822) - (t1716 * t4884));
    const double t4995 = (t1652 * t4926) + (t1722 * t4993);
    const double t4999 = (t1586 * t4884) - (t1644 * t4995) - (t1716 * t4993);
    const double t5005 = (t923 * t4822) - (t1568 * t4999) - (t1640 * t4995) - (t1700 * t4993);
    const double t5006 = motion->constants[2] * cos_theta;
    const double t5008 = 1.0 - motion->constants[34];
    const double t5013 = (t1888 * t5006) + (sin_theta * ((t1865 * t5008) - (motion->constants[35] *
        t1895)));
    const double t5015 = motion->constants[3] * cos_theta;
    const double t5017 = 1.0 - motion->constants[36];
    const double t5022 = (t1888 * t5015) - (sin_theta * ((t1895 * t5017) - (motion->constants[35] *
        t1865)));
    const double t5028 = (t1900 * t5006) - (t1912 * t5015) - (sin_theta * t1907);
    const double t5034 = (t14 * t5013) + (t26 * t5022) + (t2169 * t5028);
    const double t5036 = t1907 * t5006;
    const double t5038 = t1907 * t5015;
    const double t5042 = (t1900 * t5008) - (motion->constants[35] * t1912);
    const double t5046 = (t1912 * t5017) - (motion->constants[35] * t1900);
    const double t5051 = (t14 * t5038) - (t26 * t5036) - (sin_theta * ((t26 * t5042) + (t14 *
        t5046)));
    const double t5065 = (t1865 * t5006) + (motion->constants[32] * t5038) - (t1895 * t5015) -
        (motion->constants[33] * t5036) - (sin_theta * (t1888 + (motion->constants[33] * t5042) +
        (motion->constants[32] * t5046)));
    const double t5067 = t1834 * t5006;
    const double t5069 = t1834 * t5015;
    const double t5073 = (t1828 * t5008) - (motion->constants[35] * t1840);
    const double t5077 = (t1840 * t5017) - (motion->constants[35] * t1828);
    const double t5082 = (motion->constants[55] * t5067) + (motion->constants[54] * t5069) -
        (sin_theta * ((motion->constants[55] * t5073) - (motion->constants[54] * t5077)));
    const double t5085 = sin_theta * motion->constants[24];
    const double t5087 = (motion->constants[24] * t5069) + (t5077 * t5085);
    const double t5091 = (motion->constants[24] * t5067) - (t5073 * t5085);
    const double t5097 = (t1840 * t5015) - (t1828 * t5006) - (sin_theta * t1834);
    const double t5104 = (t1807 * t5015) + (sin_theta * ((t1794 * t5017) - (motion->constants[35] *
        t1789)));
    const double t5110 = (t1794 * t5015) - (t1789 * t5006) - (sin_theta * t1807);
    const double t5117 = (t1807 * t5006) - (sin_theta * ((t1789 * t5008) - (motion->constants[35] *
        t1794)));
    const double t5124 = (t934 * t5015) + (sin_theta * ((t943 * t5017) - (motion->constants[35] *
        t932)));
    const double t5131 = (t934 * t5006) - (sin_theta * ((t932 * t5008) - (motion->constants[35] *
        t943)));
    const double t5137 = (t943 * t5015) - (t932 * t5006) - (sin_theta * t934);
    const double t5143 = (t26 * t5013) + (t2165 * t5028) + (t872 * t5034) + (t2074 * t5051) +
        (t2159 * t5082) + (t2198 * t5091);
    const double t5148 = t5143 + (t2227 * t5097) + (t2394 * t5110) + (t2400 * t5117) + (t2834 *
        t5131) + (t2855 * t5137);
    const double t5153 = t5148 - (t14 * t5022) - (t861 * t5065) - (t2182 * t5087) - (t2388 *
        t5104) - (t2813 * t5124);
    const double t5173 = (t1536 * t5034) + (t3289 * t5051) + (t3299 * t5082) + (t3311 * t5091) +
        (t3328 * t5097) + (t3411 * t5110);
    const double t5178 = t5173 + (t3417 * t5117) + (t3581 * t5131) + (t3595 * t5137) - (t1534 *
        t5065) - (t3305 * t5087);
    const double t5181 = t5178 - (t3405 * t5104) - (t3567 * t5124) - (t1568 * t5153);
    const double t5195 = (t3814 * t5097) + (motion->constants[77] * t5104) + (t3903 * t5137) -
        motion->constants[5] - (motion->constants[76] * t5117) - (t3891 * t5124);
    const double t5198 = t5195 - (t3895 * t5131) - (t1640 * t5153) - (t1644 * t5181);
    const double t5220 = (t1671 * t5034) + (t4059 * t5051) + (t1669 * t5065) + (t4069 * t5082) +
        (t4081 * t5091) + (t4098 * t5097);
    const double t5225 = t5220 + (t4180 * t5110) + (t4186 * t5117) + (t4351 * t5131) + (t4365 *
        t5137) + (t1722 * t5198);
    const double t5230 = t5225 - (t4075 * t5087) - (t4174 * t5104) - (t4337 * t5124) - (t1700 *
        t5153) - (t1716 * t5181);
    const double t5231 = t1759 * t5230;
    const double t5233 = (t1652 * t5198) + (t1722 * t5231);
    const double t5237 = (t1586 * t5181) - (t1644 * t5233) - (t1716 * t5231);
    const double t5243 = (t923 * t5153) - (t1568 * t5237) - (t1640 * t5233) - (t1700 * t5231);
    const double t5244 = t2314 + t2314;
    const double t5245 = t26 * t5244;
    const double t5247 = t14 * t5244;
    const double t5254 = cos_delta * t930;
    const double t5257 = (t14 * t2314) + (t930 * t2572) + (t2574 * t5254);
    const double t5263 = (t26 * t2314) + (t930 * t2610);
    const double t5265 = motion->constants[30] * t3065;
    const double t5269 = (t2574 * t3065) + (t930 * t2607) + (cos_delta * t5265) - (sin_delta *
        t5263);
    const double t5275 = (cos_delta * t5263) + (sin_delta * t5265) - (t2606 * t5254);
    const double t5288 = (t2274 * t5245) + (t2414 * t3065) + (t2604 * t5257) + (t2655 * t5269) +
        (t2691 * t5275) + (t2740 * t2987);
    const double t5293 = t5288 + (t26 * t3063) + (t14 * t3174) + (t682 * t3183) + (t72 * t3203) +
        (t364 * t3251);
    const double t5297 = t5293 - (t2310 * t5247) - (t930 * t2475) - (t2505 * t2987) - (t2126 *
        t2726);
    const double t5319 = (t3358 * t5245) + (t3372 * t5247) + (t3065 * t3427) + (t3507 * t5257) +
        (t3513 * t5269) + (t3519 * t5275);
    const double t5324 = t5319 + (t2987 * t3541) + (t26 * t3688) + (t14 * t3728) + (t682 * t3737) +
        (t72 * t3752);
    const double t5329 = t5324 + (t364 * t3780) - (t930 * t3466) - (t2987 * t3482) - (t2126 *
        t3535) - (t1568 * t5297);
    const double t5352 = (t3817 * t5247) + (t2987 * t3830) + (t3851 * t5257) + (t3855 * t5269) +
        (t3859 * t5275) + (t2987 * t3881);
    const double t5357 = t5352 + (t26 * t3952) + (t14 * t3976) + (t682 * t3981) + (t72 * t3996) +
        (t364 * t4024);
    const double t5362 = t5357 - (t3815 * t5245) - (t3065 * t3822) - (t930 * t3827) - (t2126 *
        t3875) - (t1640 * t5297);
    const double t5363 = t5362 - (t1644 * t5329);
    const double t5387 = (t4127 * t5245) + (t3065 * t4196) + (t4277 * t5257) + (t4283 * t5269) +
        (t4289 * t5275) + (t2987 * t4311);
    const double t5392 = t5387 + (t26 * t4458) + (t14 * t4498) + (t682 * t4507) + (t72 * t4522) +
        (t364 * t4550);
    const double t5397 = t5392 + (t1722 * t5363) - (t4141 * t5247) - (t930 * t4236) - (t2987 *
        t4252) - (t2126 * t4305);
    const double t5400 = t1759 * (t5397 - (t1700 * t5297) - (t1716 * t5329));
    const double t5402 = (t1652 * t5363) + (t1722 * t5400);
    const double t5406 = (t1586 * t5329) - (t1644 * t5402) - (t1716 * t5400);
    const double t5412 = (t923 * t5297) - (t1568 * t5406) - (t1640 * t5402) - (t1700 * t5400);
    const double t5420 = t3123 + (t950 * t2574);
    const double t5423 = t3128 - (t953 * t2606);
    const double t5426 = t3136 + (t950 * t2606);
    const double t5435 = (t872 * t3078) + (t2074 * t3093) + (t861 * t3102) + (t910 * t3110) +
        (t953 * t2464) + (t2604 * t5420);
    const double t5440 = t5435 + (t2655 * t5423) + (t690 * t3183) + (t89 * t3203) + (t447 * t3251) -
        t3154;
    const double t5442 = t5440 - (t950 * t2449) - (t2691 * t5426);
    const double t5461 = t3711 + (t1536 * t3078) + (t3093 * t3289) + (t1534 * t3102) + (t953 *
        t3455) + (t3507 * t5420);
    const double t5466 = t5461 + (t3513 * t5423) + (t690 * t3737) + (t89 * t3752) + (t447 * t3780) -
        (t1557 * t3110);
    const double t5469 = t5466 - (t950 * t3445) - (t3519 * t5426) - (t1568 * t5442);
    const double t5483 = t3961 + (t3851 * t5420) + (t3855 * t5423) + (t690 * t3981) + (t89 *
        t3996) + (t447 * t4024);
    const double t5486 = t5483 - (t3859 * t5426) - (t1640 * t5442) - (t1644 * t5469);
    const double t5507 = t4481 + (t1671 * t3078) + (t3093 * t4059) + (t1692 * t3110) + (t953 *
        t4224) + (t4277 * t5420);
    const double t5512 = t5507 + (t4283 * t5423) + (t690 * t4507) + (t89 * t4522) + (t447 * t4550) +
        (t1722 * t5486);
    const double t5517 = t5512 - (t1669 * t3102) - (t950 * t4214) - (t4289 * t5426) - (t1700 *
        t5442) - (t1716 * t5469);
    const double t5518 = t1759 * t5517;
    const double t5520 = (t1652 * t5486) + (t1722 * t5518);
    const double t5524 = (t1586 * t5469) - (t1644 * t5520) - (t1716 * t5518);
    const double t5530 = (t923 * t5442) - (t1568 * t5524) - (t1640 * t5520) - (t1700 * t5518);
    const double t5539 = (t1256 * t2394) + (t1199 * t2400) + (motion->constants[2] * t2813) +
        (motion->constants[3] * t2834) - (t1208 * t2388);
    const double t5551 = (t1256 * t3411) + (t1199 * t3417) + (motion->constants[2] * t3567) +
        (motion->constants[3] * t3581) - (t1208 * t3405) - (t1568 * t5539);
    const double t5563 = (t1208 * motion->constants[77]) + (motion->constants[2] * t3891) -
        motion->constants[6] - (t1199 * motion->constants[76]) - (motion->constants[3] * t3895) -
        (t1640 * t5539);
    const double t5564 = t5563 - (t1644 * t5551);
    const double t5578 = (t1256 * t4180) + (t1199 * t4186) + (motion->constants[2] * t4337) +
        (motion->constants[3] * t4351) + (t1722 * t5564) - (t1208 * t4174);
    const double t5581 = t1759 * (t5578 - (t1700 * t5539) - (t1716 * t5551));
    const double t5583 = (t1652 * t5564) + (t1722 * t5581);
    const double t5587 = (t1586 * t5551) - (t1644 * t5583) - (t1716 * t5581);
    const double t5593 = (t923 * t5539) - (t1568 * t5587) - (t1640 * t5583) - (t1700 * t5581);
    const double t5594 = motion->constants[27] * t943;
    const double t5596 = motion->constants[27] * t932;
    const double t5600 = (t14 * t5594) + (t26 * t5596);
    const double t5602 = cos_delta * t2314;
    const double t5604 = sin_delta * t2314;
    const double t5612 = (t26 * t5594) + (t872 * t5600) + (t2655 * t5602) + (t2691 * t5604) +
        (t693 * t3183) + (t328 * t3251);
    const double t5614 = t5612 - t3197 - (t14 * t5596);
    const double t5626 = t3746 + (t1536 * t5600) + (t3513 * t5602) + (t3519 * t5604) + (t693 *
        t3737) + (t328 * t3780);
    const double t5627 = t5626 - (t1568 * t5614);
    const double t5639 = t3990 + (t3855 * t5602) + (t3859 * t5604) + (t693 * t3981) + (t328 *
        t4024) - (t1640 * t5614);
    const double t5640 = t5639 - (t1644 * t5627);
    const double t5654 = t4516 + (t1671 * t5600) + (t4283 * t5602) + (t4289 * t5604) + (t693 *
        t4507) + (t328 * t4550);
    const double t5658 = t1759 * (t5654 + (t1722 * t5640) - (t1700 * t5614) - (t1716 * t5627));
    const double t5660 = (t1652 * t5640) + (t1722 * t5658);
    const double t5664 = (t1586 * t5627) - (t1644 * t5660) - (t1716 * t5658);
    const double t5670 = (t923 * t5614) - (t1568 * t5664) - (t1640 * t5660) - (t1700 * t5658);
    const double t5673 = (t1568 * t1644) - t1640;
    const double t5679 = t1759 * ((t1568 * t1716) + (t1722 * t5673) - t1700);
    const double t5681 = (t1652 * t5673) + (t1722 * t5679);
    const double t5685 = (t1568 * t1586) + (t1644 * t5681) + (t1716 * t5679);
    const double t5691 = t923 + (t1568 * t5685) - (t1640 * t5681) - (t1700 * t5679);
    const double t5695 = t1759 * (t1716 + (t1644 * t1722));
    const double t5697 = (t1644 * t1652) + (t1722 * t5695);
    const double t5701 = t1586 + (t1644 * t5697) + (t1716 * t5695);
    const double t5706 = (t1640 * t5697) + (t1700 * t5695) - (t1568 * t5701);
    const double t5707 = t1722 * t1759;
    const double t5709 = t1652 + (t1722 * t5707);
    const double t5712 = (t1644 * t5709) + (t1716 * t5707);
    const double t5717 = (t1568 * t5712) - (t1640 * t5709) - (t1700 * t5707);
    const double t5718 = -(t98 * t235);
    const double t5719 = -(t98 * t313);
    const double t5720 = -(t72 * t98);
    const double t5721 = -(t89 * t98);
    const double t5722 = -t98;
    const double t5723 = -(t93 * cos_psi);
    const double t5724 = -(t235 * t318);
    const double t5725 = -(t313 * t318);
    const double t5726 = -(t72 * t318);
    const double t5727 = -(t89 * t318);
    const double t5728 = -t318;
    const double t5729 = -t364;
    const double t5730 = -t447;
    const double t5731 = -t328;
    const double t5732 = -t5685;
    const double t5733 = -t5712;
    const double t5734 = -t5697;
    const double t5735 = -t5695;
    linearization->a[0][0] = 0.0;
    linearization->a[0][1] = 0.0;
    linearization->a[0][2] = t96;
    linearization->a[0][3] = t5718;
    linearization->a[0][4] = 0.0;
    linearization->a[0][5] = t5719;
    linearization->a[0][6] = 0.0;
    linearization->a[0][7] = 0.0;
    linearization->a[0][8] = 0.0;
    linearization->a[0][9] = t5720;
    linearization->a[0][10] = t5721;
    linearization->a[0][11] = 0.0;
    linearization->a[0][12] = t5722;
    linearization->b[0][0] = 0.0;
    linearization->b[0][1] = 0.0;
    linearization->b[0][2] = 0.0;
    linearization->a[1][0] = 0.0;
    linearization->a[1][1] = 0.0;
    linearization->a[1][2] = t5723;
    linearization->a[1][3] = t5724;
    linearization->a[1][4] = 0.0;
    linearization->a[1][5] = t5725;
    linearization->a[1][6] = 0.0;
    linearization->a[1][7] = 0.0;
    linearization->a[1][8] = 0.0;
    linearization->a[1][9] = t5726;
    linearization->a[1][10] = t5727;
    linearization->a[1][11] = 0.0;
    linearization->a[1][12] = t5728;
    linearization->b[1][0] = 0.0;
    linearization->b[1][1] = 0.0;
    linearization->b[1][2] = 0.0;
    linearization->a[2][0] = 0.0;
    linearization->a[2][1] = 0.0;
    linearization->a[2][2] = 0.0;
    linearization->a[2][3] = t465;
    linearization->a[2][4] = 0.0;
    linearization->a[2][5] = t516;
    linearization->a[2][6] = 0.0;
    linearization->a[2][7] = 0.0;
    linearization->a[2][8] = 0.0;
    linearization->a[2][9] = t5729;
    linearization->a[2][10] = t5730;
    linearization->a[2][11] = 0.0;
    linearization->a[2][12] = t5731;
    linearization->b[2][0] = 0.0;
    linearization->b[2][1] = 0.0;
    linearization->b[2][2] = 0.0;
    linearization->a[3][0] = 0.0;
    linearization->a[3][1] = 0.0;
    linearization->a[3][2] = 0.0;
    linearization->a[3][3] = 0.0;
    linearization->a[3][4] = 0.0;
    linearization->a[3][5] = 0.0;
    linearization->a[3][6] = 0.0;
    linearization->a[3][7] = 0.0;
    linearization->a[3][8] = 0.0;
    linearization->a[3][9] = 1.0;
    linearization->a[3][10] = 0.0;
    linearization->a[3][11] = 0.0;
    linearization->a[3][12] = 0.0;
    linearization->b[3][0] = 0.0;
    linearization->b[3][1] = 0.0;
    linearization->b[3][2] = 0.0;
    linearization->a[4][0] = 0.0;
    linearization->a[4][1] = 0.0;
    linearization->a[4][2] = 0.0;
    linearization->a[4][3] = t235;
    linearization->a[4][4] = 0.0;
    linearization->a[4][5] = t313;
    linearization->a[4][6] = 0.0;
    linearization->a[4][7] = 0.0;
    linearization->a[4][8] = 0.0;
    linearization->a[4][9] = t72;
    linearization->a[4][10] = t89;
    linearization->a[4][11] = 0.0;
    linearization->a[4][12] = 0.0;
    linearization->b[4][0] = 0.0;
    linearization->b[4][1] = 0.0;
    linearization->b[4][2] = 0.0;
    linearization->a[5][0] = 0.0;
    linearization->a[5][1] = 0.0;
    linearization->a[5][2] = 0.0;
    linearization->a[5][3] = 0.0;
    linearization->a[5][4] = 0.0;
    linearization->a[5][5] = 0.0;
    linearization->a[5][6] = 0.0;
    linearization->a[5][7] = 0.0;
    linearization->a[5][8] = 0.0;
    linearization->a[5][9] = 0.0;
    linearization->a[5][10] = 1.0;
    linearization->a[5][11] = 0.0;
    linearization->a[5][12] = 0.0;
    linearization->b[5][0] = 0.0;
    linearization->b[5][1] = 0.0;
    linearization->b[5][2] = 0.0;
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
    linearization->a[6][10] = 0.0;
    linearization->a[6][11] = 1.0;
    linearization->a[6][12] = 0.0;
    linearization->b[6][0] = 0.0;
    linearization->b[6][1] = 0.0;
    linearization->b[6][2] = 0.0;
    linearization->a[7][0] = 0.0;
    linearization->a[7][1] = 0.0;
    linearization->a[7][2] = 0.0;
    linearization->a[7][3] = 0.0;
    linearization->a[7][4] = 0.0;
    linearization->a[7][5] = 0.0;
    linearization->a[7][6] = 0.0;
    linearization->a[7][7] = 0.0;
    linearization->a[7][8] = 0.0;
    linearization->a[7][9] = 0.0;
    linearization->a[7][10] = 0.0;
    linearization->a[7][11] = 0.0;
    linearization->a[7][12] = 1.0;
    linearization->b[7][0] = 0.0;
    linearization->b[7][1] = 0.0;
    linearization->b[7][2] = 0.0;
    linearization->a[8][0] = 0.0;
    linearization->a[8][1] = 0.0;
    linearization->a[8][2] = 0.0;
    linearization->a[8][3] = t620;
    linearization->a[8][4] = 0.0;
    linearization->a[8][5] = t678;
    linearization->a[8][6] = 0.0;
    linearization->a[8][7] = 0.0;
    linearization->a[8][8] = 0.0;
    linearization->a[8][9] = t682;
    linearization->a[8][10] = t690;
    linearization->a[8][11] = 0.0;
    linearization->a[8][12] = t693;
    linearization->b[8][0] = 0.0;
    linearization->b[8][1] = 0.0;
    linearization->b[8][2] = 0.0;
    linearization->a[9][0] = 0.0;
    linearization->a[9][1] = 0.0;
    linearization->a[9][2] = 0.0;
    linearization->a[9][3] = t4597;
    linearization->a[9][4] = 0.0;
    linearization->a[9][5] = t5005;
    linearization->a[9][6] = t5243;
    linearization->a[9][7] = 0.0;
    linearization->a[9][8] = 0.0;
    linearization->a[9][9] = t5412;
    linearization->a[9][10] = t5530;
    linearization->a[9][11] = t5593;
    linearization->a[9][12] = t5670;
    linearization->b[9][0] = t5691;
    linearization->b[9][1] = t5706;
    linearization->b[9][2] = t5717;
    linearization->a[10][0] = 0.0;
    linearization->a[10][1] = 0.0;
    linearization->a[10][2] = 0.0;
    linearization->a[10][3] = t4591;
    linearization->a[10][4] = 0.0;
    linearization->a[10][5] = t4999;
    linearization->a[10][6] = t5237;
    linearization->a[10][7] = 0.0;
    linearization->a[10][8] = 0.0;
    linearization->a[10][9] = t5406;
    linearization->a[10][10] = t5524;
    linearization->a[10][11] = t5587;
    linearization->a[10][12] = t5664;
    linearization->b[10][0] = t5732;
    linearization->b[10][1] = t5701;
    linearization->b[10][2] = t5733;
    linearization->a[11][0] = 0.0;
    linearization->a[11][1] = 0.0;
    linearization->a[11][2] = 0.0;
    linearization->a[11][3] = t4587;
    linearization->a[11][4] = 0.0;
    linearization->a[11][5] = t4995;
    linearization->a[11][6] = t5233;
    linearization->a[11][7] = 0.0;
    linearization->a[11][8] = 0.0;
    linearization->a[11][9] = t5402;
    linearization->a[11][10] = t5520;
    linearization->a[11][11] = t5583;
    linearization->a[11][12] = t5660;
    linearization->b[11][0] = t5681;
    linearization->b[11][1] = t5734;
    linearization->b[11][2] = t5709;
    linearization->a[12][0] = 0.0;
    linearization->a[12][1] = 0.0;
    linearization->a[12][2] = 0.0;
    linearization->a[12][3] = t4585;
    linearization->a[12][4] = 0.0;
    linearization->a[12][5] = t4993;
    linearization->a[12][6] = t5231;
    linearization->a[12][7] = 0.0;
    linearization->a[12][8] = 0.0;
    linearization->a[12][9] = t5400;
    linearization->a[12][10] = t5518;
    linearization->a[12][11] = t5581;
    linearization->a[12][12] = t5658;
    linearization->b[12][0] = t5679;
    linearization->b[12][1] = t5735;
    linearization->b[12][2] = t5707;
}

carvallo_motion_error_t whipple_leaning_f64_motion_linearize(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    const double forces[WHIPPLE_LEANING_FORCES], whipple_leaning_f64_linearization_t *linearization)
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_LEANING_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_LEANING_FORCES)) {
        bool are_finite = true;
        whipple_leaning_f64_compute_linearization(motion, positions, speeds, forces, linearization);
        for (size_t row = 0U; row < WHIPPLE_LEANING_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f64(linearization->a[row],
                WHIPPLE_LEANING_STATES) && carvallo_are_finite_f64(linearization->b[row],
                WHIPPLE_LEANING_FORCES);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_leaning_f64_compute_by_parameters(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    const double forces[WHIPPLE_LEANING_FORCES],
    double by_parameters[WHIPPLE_LEANING_STATES][WHIPPLE_LEANING_PARAMETERS])
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
    const double t40 = (cos_delta * sin_phi) + (t16 * sin_delta);
    const double t41 = motion->constants[8] * t40;
    const double t48 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const double t51 = (t36 * t41) + (t7 * motion->constants[39]) + (t12 * t48);
    const double t53 = 1.0 / (cos_phi * t51);
    const double t55 = motion->constants[2] * t13;
    const double t56 = t55 - (motion->constants[3] * t16);
    const double t57 = t53 * t56;
    const double t58 = t7 * t57;
    const double t63 = t51 - (t7 * motion->constants[31]) - (t12 * motion->constants[30]);
    const double t64 = sin_phi * t53;
    const double t65 = t63 * t64;
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t70 = motion->constants[7] * cos_psi;
    const double t71 = speeds[1] * t70;
    const double t73 = t12 * sin_phi;
    const double t74 = t53 * t73;
    const double t75 = t71 * t74;
    const double t77 = t7 * t64;
    const double t78 = t71 * t77;
    const double t80 = t26 * t26;
    const double t81 = t21 * t80;
    const double t83 = t26 * 0.5;
    const double t85 = cos_phi * (t13 + t13);
    const double t86 = t83 * t85;
    const double t87 = t81 * t86;
    const double t89 = t12 * cos_delta;
    const double t91 = t13 * t80;
    const double t93 = (cos_phi * t26) - (t86 * t91);
    const double t96 = t32 + (t7 * t87) + (t89 * t93);
    const double t97 = t41 * t96;
    const double t98 = t7 * t53;
    const double t101 = t70 * speeds[0];
    const double t103 = (t71 * t98) + (t53 * t101);
    const double t107 = t7 * cos_delta;
    const double t109 = t28 + (sin_phi * t107);
    const double t112 = (sin_phi * t30) + (t93 * t109) - (t73 * t87);
    const double t114 = t48 + (t41 * t112);
    const double t117 = (t12 * t32) - (t7 * t30);
    const double t119 = sin_delta * motion->constants[37];
    const double t123 = (t12 * motion->constants[39]) - (t7 * t48);
    const double t126 = (cos_phi * t119) - (t41 * t117) - (sin_phi * t123);
    const double t129 = (t12 * motion->constants[31]) - (t7 * motion->constants[30]);
    const double t131 = t126 + (sin_phi * t129);
    const double t135 = t53 * ((t7 * t131) + (t63 * t73));
    const double t136 = cos_phi * t53;
    const double t137 = t135 * t136;
    const double t139 = sin_phi * motion->constants[7];
    const double t140 = t126 + t139;
    const double t141 = t53 * t140;
    const double t142 = t136 * t141;
    const double t145 = (t71 * t137) + (t101 * t142) - t75;
    const double t147 = sin_phi * t103;
    const double t153 = (motion->constants[30] * t75) + (t97 * t103) + (t114 * t145) +
        (motion->constants[39] * t147) - (t65 * t71) - (motion->constants[31] * t78);
    const double t155 = t12 * t57;
    const double t156 = t53 * t131;
    const double t160 = t28 * motion->constants[8];
    const double t162 = cos_phi * cos_delta;
    const double t165 = t162 * (t21 + t21);
    const double t166 = t83 * t165;
    const double t168 = (t81 * t166) - (t26 * t162);
    const double t170 = t91 * t166;
    const double t173 = (t89 * t170) - t30 - (t7 * t168);
    const double t175 = (t117 * t160) + (t41 * t173);
    const double t182 = (sin_phi * t32) + (t73 * t168) + (t109 * t170);
    const double t185 = motion->constants[39] + (t36 * t160) + (t41 * t182);
    const double t192 = (motion->constants[31] * t75) + (motion->constants[30] * t78) + (t103 *
        t175) + (t145 * t185) - (t71 * t156) - (t48 * t147);
    const double t198 = (t7 * t145) + (t12 * t147);
    const double t200 = (t7 * t75) + t198 - (t12 * t78);
    const double t208 = (t12 * t75) + (t7 * t78) + (t12 * t145) - (t7 * t147);
    const double t210 = (motion->constants[2] * t200) + (motion->constants[3] * t208);
    const double t212 = (t155 * t192) + t210 - (t58 * t153);
    const double t218 = (t89 * t145) - (t28 * t103) - (t107 * t147);
    const double t221 = t20 - (cos_phi * t107);
    const double t225 = t53 * (t56 - t55 - (motion->constants[3] * t221));
    const double t226 = t7 * t225;
    const double t228 = t12 * t225;
    const double t233 = t210 + (t192 * t228) - (motion->constants[2] * t198) -
        (motion->constants[3] * t218) - (t153 * t226);
    const double t237 = motion->constants[0] + motion->constants[1];
    const double t241 = (motion->constants[3] * motion->constants[8]) - (motion->constants[2] *
        (motion->constants[0] - t237));
    const double t245 = cos_phi * t48;
    const double t247 = cos_phi * motion->constants[39];
    const double t255 = motion->constants[8] * t83;
    const double t256 = t165 * t255;
    const double t258 = t85 * t255;
    const double t276 = (motion->constants[3] * ((t16 * motion->constants[7]) + (t13 * t237) -
        (cos_pitch * t245) - (sin_pitch * t247))) + (t221 * t241);
    const double t279 = t276 + (t13 * motion->constants[37]) - (motion->constants[3] * ((cos_pitch *
        t256) + (sin_pitch * t258))) - (motion->constants[2] * ((cos_pitch * t247) + (t13 *
        motion->constants[7]) - (sin_pitch * t245) - (t16 * t237)));
    const double t281 = t53 * (t279 - (motion->constants[2] * ((cos_pitch * t258) - (sin_pitch *
        t256))));
    const double t283 = t7 + (t7 * t281);
    const double t286 = t12 + (t12 * t281);
    const double t292 = (motion->constants[37] * t198) + (t218 * t241) + (motion->constants[30] *
        t200) + (t192 * t286) - (motion->constants[31] * t208) - (t153 * t283);
    const double t297 = (speeds[0] * t141) + (speeds[1] * t135);
    const double t298 = speeds[3] + t297;
    const double t304 = motion->constants[3] * t13;
    const double t307 = t53 * ((motion->constants[2] * t16) + t304 - cos_phi);
    const double t308 = t7 * t307;
    const double t310 = t12 * t307;
    const double t316 = (motion->constants[3] * t200) + (t192 * t310) - (cos_psi * t298) - (t64 *
        t101) - (motion->constants[2] * t208) - (t153 * t308);
    const double t317 = t40 * t117;
    const double t319 = t36 * t40;
    const double t326 = t53 * (t25 + (motion->constants[2] * t221) - t304);
    const double t327 = t7 * t326;
    const double t329 = t12 * t326;
    const double t335 = (t103 * t317) + (t145 * t319) + (motion->constants[2] * t218) + (t192 *
        t329) - (motion->constants[3] * t198) - (t153 * t327);
    const double t337 = motion->constants[7] * sin_psi;
    const double t338 = speeds[1] * t337;
    const double t340 = t74 * t338;
    const double t342 = t77 * t338;
    const double t345 = speeds[0] * t337;
    const double t347 = (t98 * t338) + (t53 * t345);
    const double t352 = (t137 * t338) + (t142 * t345) - t340;
    const double t354 = sin_phi * t347;
    const double t360 = (motion->constants[30] * t340) + (t97 * t347) + (t114 * t352) +
        (motion->constants[39] * t354) - (t65 * t338) - (motion->constants[31] * t342);
    const double t372 = (motion->constants[31] * t340) + (motion->constants[30] * t342) + (t175 *
        t347) + (t185 * t352) - (t156 * t338) - (t48 * t354);
    const double t378 = (t7 * t352) + (t12 * t354);
    const double t380 = (t7 * t340) + t378 - (t12 * t342);
    const double t388 = (t12 * t340) + (t7 * t342) + (t12 * t352) - (t7 * t354);
    const double t390 = (motion->constants[2] * t380) + (motion->constants[3] * t388);
    const double t392 = (t155 * t372) + t390 - (t58 * t360);
    const double t398 = (t89 * t352) - (t28 * t347) - (t107 * t354);
    const double t405 = t390 + (t228 * t372) - (motion->constants[2] * t378) -
        (motion->constants[3] * t398) - (t226 * t360);
    const double t416 = (motion->constants[37] * t378) + (t241 * t398) + (motion->constants[30] *
        t380) + (t286 * t372) - (motion->constants[31] * t388) - (t283 * t360);
    const double t427 = (motion->constants[3] * t380) + (t310 * t372) - (t298 * sin_psi) - (t64 *
        t345) - (motion->constants[2] * t388) - (t308 * t360);
    const double t438 = (t317 * t347) + (t319 * t352) + (motion->constants[2] * t398) + (t329 *
        t372) - (motion->constants[3] * t378) - (t327 * t360);
    const double t442 = 1.0 / ((t51 * t117) + (t36 * t140));
    const double t443 = motion->constants[7] * t442;
    const double t444 = t112 * t443;
    const double t446 = t36 * t442;
    const double t453 = (t25 * motion->constants[8]) + (sin_phi * t119) + (cos_phi * t123) -
        (cos_phi * t129);
    const double t456 = (sin_phi * t453) + (cos_phi * t131);
    const double t458 = t117 * t442;
    const double t459 = cos_phi * t63;
    const double t463 = (t73 * t446) - (t7 * t458);
    const double t464 = motion->constants[8] * t463;
    const double t468 = (t13 * t63) - (t7 * t453);
    const double t469 = t442 * t468;
    const double t473 = (t73 * t453) + (t13 * t131);
    const double t474 = t442 * t473;
    const double t479 = (t446 * t456) + (t458 * t459) + (t86 * t464) + (t96 * t469) + (t112 * t474);
    const double t481 = sin_phi * t51;
    const double t483 = sin_phi * t140;
    const double t485 = (t117 * t481) + (t36 * t483);
    const double t486 = t442 * t485;
    const double t487 = speeds[1] * t486;
    const double t489 = t13 * t458;
    const double t492 = (speeds[1] * t489) + (t74 * t487);
    const double t494 = t13 * sin_phi;
    const double t496 = cos_phi * t463;
    const double t497 = (t446 * t494) - t496;
    const double t500 = (speeds[1] * t497) + (t77 * t487);
    const double t504 = (t51 * t96) + (t112 * t140);
    const double t505 = t36 * t443;
    const double t506 = t442 * t505;
    const double t513 = t442 * ((t117 * t468) + (t36 * t473) + (t135 * t485));
    const double t514 = t442 * t513;
    const double t516 = t141 * t486;
    const double t517 = t442 * t516;
    const double t520 = (speeds[3] * t506) + (speeds[1] * t514) + (speeds[0] * t517);
    const double t524 = (t96 * t481) + (t112 * t483);
    const double t525 = t135 * t442;
    const double t527 = t141 * t442;
    const double t529 = (speeds[1] * t525) + (speeds[0] * t527);
    const double t531 = t13 * t446;
    const double t534 = speeds[0] * t486;
    const double t537 = sin_phi * t36;
    const double t542 = (t36 * t520) - (speeds[1] * t531) - (t98 * t487) - (t53 * t534) - (t529 *
        t537);
    const double t547 = sin_phi * t117;
    const double t552 = (t137 * t487) + (t142 * t534) + (t117 * t520) - t492 - (t529 * t547);
    const double t556 = (speeds[1] * t496) + (sin_phi * t542);
    const double t562 = (motion->constants[30] * t492) + (t504 * t520) + (t114 * t552) -
        (speeds[3] * t444) - (speeds[1] * t479) - (t65 * t487);
    const double t566 = t562 - (motion->constants[31] * t500) - (t524 * t529) - (t97 * t542) -
        (motion->constants[39] * t556);
    const double t568 = t182 * t443;
    const double t576 = (t173 * t469) + (t182 * t474) - (t453 * t458) - (t166 * t464);
    const double t583 = (t51 * t173) + (t140 * t182);
    const double t587 = (t173 * t481) + (t182 * t483);
    const double t596 = (motion->constants[31] * t492) + (motion->constants[30] * t500) + (t520 *
        t583) + (t185 * t552) + (t48 * t556) - (speeds[3] * t568);
    const double t600 = t596 - (speeds[1] * t576) - (t156 * t487) - (t529 * t587) - (t175 * t542);
    const double t606 = (t7 * t552) - (t12 * t556);
    const double t608 = (t7 * t492) + t606 - (t12 * t500);
    const double t616 = (t12 * t492) + (t7 * t500) + (t12 * t552) + (t7 * t556);
    const double t618 = (motion->constants[2] * t608) + (motion->constants[3] * t616);
    const double t620 = (t155 * t600) + t618 - (t58 * t566);
    const double t622 = t20 * t463;
    const double t629 = (t28 * t542) + (t89 * t552) + (t107 * t556) - (speeds[1] * t622);
    const double t636 = t618 + (t228 * t600) - (motion->constants[2] * t606) -
        (motion->constants[3] * t629) - (t226 * t566);
    const double t647 = (motion->constants[37] * t606) + (t241 * t629) + (motion->constants[30] *
        t608) + (t286 * t600) - (motion->constants[31] * t616) - (t283 * t566);
    const double t651 = sin_phi * t537;
    const double t661 = (t520 * t537) + (motion->constants[3] * t608) + (t310 * t600) - (speeds[3] *
        t446) - (t64 * t534) - (t529 * t651);
    const double t663 = t661 - (motion->constants[2] * t616) - (t308 * t566);
    const double t664 = t25 * t463;
    const double t676 = (t319 * t552) + (motion->constants[2] * t629) + (t329 * t600) - (speeds[1] *
        t664) - (t317 * t542) - (motion->constants[3] * t606);
    const double t677 = t676 - (t327 * t566);
    const double t679 = speeds[1] * t74;
    const double t681 = speeds[1] * t77;
    const double t685 = (speeds[1] * t98) + (t53 * speeds[0]);
    const double t690 = t679 - (speeds[1] * t137) - (speeds[0] * t142);
    const double t692 = sin_phi * t685;
    const double t698 = (t65 * speeds[1]) + (motion->constants[31] * t681) + (t114 * t690) -
        (motion->constants[30] * t679) - (t97 * t685) - (motion->constants[39] * t692);
    const double t710 = (speeds[1] * t156) + (t185 * t690) + (t48 * t692) - (motion->constants[31] *
        t679) - (motion->constants[30] * t681) - (t175 * t685);
    const double t716 = (t7 * t690) - (t12 * t692);
    const double t718 = (t12 * t681) + t716 - (t7 * t679);
    const double t726 = (t12 * t690) + (t7 * t692) - (t12 * t679) - (t7 * t681);
    const double t728 = (motion->constants[2] * t718) + (motion->constants[3] * t726);
    const double t730 = (t155 * t710) + t728 - (t58 * t698);
    const double t736 = (t28 * t685) + (t89 * t690) + (t107 * t692);
    const double t743 = t728 + (t228 * t710) - (motion->constants[2] * t716) -
        (motion->constants[3] * t736) - (t226 * t698);
    const double t754 = (motion->constants[37] * t716) + (t241 * t736) + (motion->constants[30] *
        t718) + (t286 * t710) - (motion->constants[31] * t726) - (t283 * t698);
    const double t763 = (t64 * speeds[0]) + (motion->constants[3] * t718) + (t310 * t710) -
        (motion->constants[2] * t726) - (t308 * t698);
    const double t774 = (t319 * t690) + (motion->constants[2] * t736) + (t329 * t710) - (t317 *
        t685) - (motion->constants[3] * t716) - (t327 * t698);
    const double t775 = 1.0 / motion->constants[8];
    const double t776 = motion->constants[7] * t775;
    const double t777 = t96 * t776;
    const double t779 = speeds[1] * t775;
    const double t784 = (t7 * t36) + (t73 * t117);
    const double t785 = motion->constants[8] * t784;
    const double t792 = (t117 * t456) + (t86 * t785) + (t96 * t473) - (t36 * t459) - (t112 * t468);
    const double t796 = (t36 * t51) - (t117 * t140);
    const double t797 = t775 * t796;
    const double t798 = speeds[3] * t797;
    const double t800 = t779 * t796;
    const double t804 = (t36 * t481) - (t117 * t483);
    const double t807 = (t486 * t800) - (t779 * t804);
    const double t809 = t13 * t36;
    const double t814 = (t489 * t800) + (t74 * t807) - (t779 * t809);
    const double t817 = cos_phi * t784;
    const double t818 = (t117 * t494) - t817;
    const double t823 = (t779 * t818) + (t497 * t800) + (t77 * t807);
    const double t827 = (t51 * t112) - (t96 * t140);
    const double t828 = t505 * t775;
    const double t831 = t516 * t775;
    const double t834 = (speeds[3] * t828) + (t513 * t779) + (speeds[0] * t831);
    const double t838 = (t112 * t481) - (t96 * t483);
    const double t840 = t141 * t775;
    const double t842 = (t135 * t779) + (speeds[0] * t840);
    const double t846 = speeds[0] * t797;
    const double t849 = (t506 * t798) + (t514 * t800) + (t517 * t846);
    const double t853 = (t525 * t800) + (t527 * t846);
    const double t855 = t13 * t117;
    const double t859 = t775 * t804;
    const double t862 = (t486 * t846) - (speeds[0] * t859);
    const double t872 = (t779 * t855) + (t531 * t800) + (t98 * t807) + (t53 * t862) + (t547 *
        t842) + (t537 * t853);
    const double t874 = t872 - (t117 * t834) - (t36 * t849);
    const double t886 = t814 + (t36 * t834) + (t547 * t853) - (t137 * t807) - (t142 * t862) -
        (t537 * t842);
    const double t887 = t886 - (t117 * t849);
    const double t893 = (t779 * t817) + (t496 * t800) - (sin_phi * t874);
    const double t899 = (speeds[3] * t777) + (t779 * t792) + (t444 * t798) + (t479 * t800) + (t65 *
        t807) + (motion->constants[31] * t823);
    const double t904 = t899 + (t827 * t834) + (t524 * t853) + (t114 * t887) +
        (motion->constants[39] * t893) - (motion->constants[30] * t814);
    const double t907 = t904 - (t838 * t842) - (t504 * t849) - (t97 * t874);
    const double t909 = t173 * t776;
    const double t917 = (t36 * t453) + (t173 * t473) - (t166 * t785) - (t182 * t468);
    const double t926 = (t51 * t182) - (t140 * t173);
    const double t930 = (t182 * t481) - (t173 * t483);
    const double t941 = (speeds[3] * t909) + (t779 * t917) + (t568 * t798) + (t576 * t800) + (t156 *
        t807) + (t834 * t926);
    const double t946 = t941 + (t587 * t853) + (t185 * t887) - (motion->constants[31] * t814) -
        (motion->constants[30] * t823) - (t842 * t930);
    const double t949 = t946 - (t583 * t849) - (t175 * t874) - (t48 * t893);
    const double t955 = (t7 * t887) + (t12 * t893);
    const double t957 = (t12 * t823) + t955 - (t7 * t814);
    const double t965 = (t12 * t887) - (t12 * t814) - (t7 * t823) - (t7 * t893);
    const double t967 = (motion->constants[2] * t957) + (motion->constants[3] * t965);
    const double t969 = (t155 * t949) + t967 - (t58 * t907);
    const double t971 = t20 * t784;
    const double t980 = (t779 * t971) + (t622 * t800) + (t28 * t874) + (t89 * t887) - (t107 * t893);
    const double t987 = t967 + (t228 * t949) - (motion->constants[2] * t955) -
        (motion->constants[3] * t980) - (t226 * t907);
    const double t998 = (motion->constants[37] * t955) + (t241 * t980) + (motion->constants[30] *
        t957) + (t286 * t949) - (motion->constants[31] * t965) - (t283 * t907);
    const double t999 = t117 * t775;
    const double t1004 = sin_phi * t547;
    const double t1016 = (speeds[3] * t999) + (t446 * t798) + (t64 * t862) + (t842 * t1004) +
        (t651 * t853) + (motion->constants[3] * t957);
    const double t1021 = t1016 + (t310 * t949) - (t547 * t834) - (t537 * t849) -
        (motion->constants[2] * t965) - (t308 * t907);
    const double t1029 = t775 * ((t117 * t473) + (t513 * t796) - (t36 * t468) - (t135 * t804));
    const double t1030 = t775 * t1029;
    const double t1031 = speeds[1] * t1030;
    const double t1035 = t775 * ((motion->constants[7] * t117) + (t505 * t796));
    const double t1036 = t775 * t1035;
    const double t1038 = t25 * t784;
    const double t1043 = t775 * ((t516 * t796) - (t141 * t804));
    const double t1044 = t775 * t1043;
    const double t1057 = (t779 * t1038) + (t664 * t800) + (t319 * t887) + (motion->constants[2] *
        t980) + (t329 * t949) - t1031;
    const double t1062 = t1057 - (speeds[3] * t1036) - (speeds[0] * t1044) - (t317 * t874) -
        (motion->constants[3] * t955) - (t327 * t907);
    double sin_theta = 0.0;
    double cos_theta = 0.0;
    carvallo_sin_cos_f64(positions[6], &sin_theta, &cos_theta);
    const double t1068 = 1.0 - cos_theta;
    const double t1071 = cos_theta + (t1068 * motion->constants[34]);
    const double t1075 = t1068 * motion->constants[35];
    const double t1077 = t1075 * motion->constants[57];
    const double t1081 = motion->constants[2] * sin_theta;
    const double t1091 = sin_delta * motion->constants[66];
    const double t1092 = sin_delta * t1091;
    const double t1095 = t1075 * motion->constants[54];
    const double t1098 = cos_theta + (t1068 * motion->constants[36]);
    const double t1101 = t1095 + (t1098 * motion->constants[55]);
    const double t1102 = motion->constants[33] * t1101;
    const double t1107 = t1102 + t1102 + motion->constants[63] + motion->constants[68];
    const double t1111 = motion->constants[45] + motion->constants[50] + (t1071 * ((t1071 *
        motion->constants[56]) + t1077)) + (t1081 * t1081 * motion->constants[58]) + (t1075 *
        ((t1071 * motion->constants[57]) + (t1075 * motion->constants[59])));
    const double t1113 = t1111 + t1107 - t1092;
    const double t1118 = (motion->constants[56] * t1075) + (motion->constants[57] * t1098);
    const double t1120 = motion->constants[3] * sin_theta;
    const double t1121 = motion->constants[58] * t1120;
    const double t1124 = t1077 + (motion->constants[59] * t1098);
    const double t1130 = t1075 * motion->constants[55];
    const double t1131 = (t1071 * motion->constants[54]) + t1130;
    const double t1134 = cos_delta * motion->constants[48];
    const double t1135 = motion->constants[30] * t1134;
    const double t1136 = (motion->constants[32] * t1131) - t1135;
    const double t1139 = motion->constants[65] + motion->constants[71] - t1136 - t1136;
    const double t1144 = motion->constants[46] + motion->constants[53] + (t1075 * t1118) + (t1120 *
        t1121) + (t1098 * t1124) + t1139;
    const double t1145 = t1144 - t1113;
    const double t1146 = t7 * t7;
    const double t1148 = t7 * t12;
    const double t1161 = (cos_delta * motion->constants[51]) - (motion->constants[31] * t1134);
    const double t1166 = motion->constants[42] + (t1071 * t1118) + (t1075 * t1124) + (t1101 *
        motion->constants[32]) + motion->constants[64] + t1161;
    const double t1170 = t1166 - (t1081 * t1121) - (motion->constants[33] * t1131) -
        motion->constants[69] - motion->constants[70];
    const double t1171 = t1170 + t1170;
    const double t1173 = (t1145 * t1146) + (t1148 * t1171);
    const double t1179 = t1101 + motion->constants[41] + motion->constants[62] +
        motion->constants[72];
    const double t1184 = motion->constants[40] + motion->constants[67];
    const double t1187 = t1131 + t1134 + t1184 - motion->constants[61];
    const double t1189 = (t12 * t1179) - (t7 * t1187);
    const double t1190 = motion->constants[7] * t1189;
    const double t1193 = motion->constants[74] - t1190 - t1190;
    const double t1199 = (t1081 * motion->constants[54]) - (motion->constants[55] * t1120);
    const double t1202 = sin_delta * motion->constants[48];
    const double t1204 = (sin_delta * motion->constants[51]) - (motion->constants[31] * t1202);
    const double t1208 = (t1081 * t1118) + (cos_theta * t1121) + t1204 - (t1120 * t1124) -
        (motion->constants[33] * t1199);
    const double t1212 = (motion->constants[56] * t1081) - (motion->constants[57] * t1120);
    const double t1214 = cos_theta * motion->constants[58];
    const double t1218 = (motion->constants[57] * t1081) - (motion->constants[59] * t1120);
    const double t1227 = (t1071 * t1212) + (t1075 * t1218) + (motion->constants[32] * t1199) +
        (cos_delta * t1091) - (t1081 * t1214) - (motion->constants[30] * t1202);
    const double t1229 = (t7 * t1208) + (t12 * t1227);
    const double t1231 = t141 - (sin_phi * t516);
    const double t1241 = t1170 + (t1145 * t1148) + (motion->constants[7] * ((t7 * t1179) + (t12 *
        t1187))) - (t1146 * t1171);
    const double t1242 = cos_phi * t516;
    const double t1254 = t1092 + t1107 + t1139 + t1193 + motion->constants[43] +
        motion->constants[52] + (t1081 * t1212);
    const double t1256 = t1254 + (cos_theta * t1214) - (t1120 * t1218);
    const double t1261 = motion->constants[7] * (t1199 + t1202);
    const double t1263 = (t12 * t1208) + t1261 - (t7 * t1227);
    const double t1269 = t1144 - t1173;
    const double t1275 = t1231 * motion->constants[27];
    const double t1277 = t12 * sin_delta;
    const double t1279 = t7 * sin_delta;
    const double t1282 = (cos_delta * t1231) - t1277 - (t1242 * t1279);
    const double t1283 = t1043 + t1282;
    const double t1285 = t1283 * motion->constants[28];
    const double t1291 = t1113 + t1173 + t1193 + (t1229 * t1231) + (t1231 * (t1229 + (t1231 *
        t1256) - (t1242 * t1263))) + (t1231 * t1275);
    const double t1294 = t1291 + (t1283 * t1285) - (t1241 * t1242) - (t1242 * (t1241 + (t1231 *
        t1263) - (t1242 * t1269)));
    const double t1295 = 1.0 / t1294;
    const double t1300 = (speeds[0] * t516) + (speeds[1] * t513) + (speeds[3] * t505);
    const double t1301 = sin_phi * t1300;
    const double t1302 = t297 - t1301;
    const double t1303 = t12 * speeds[0];
    const double t1304 = cos_phi * t1300;
    const double t1306 = t1303 + (t7 * t1304);
    const double t1307 = motion->constants[42] * t1306;
    const double t1309 = t7 * speeds[0];
    const double t1310 = t1309 - (t12 * t1304);
    const double t1312 = t1307 + (motion->constants[46] * t1310);
    const double t1315 = speeds[3] + t1302;
    const double t1317 = (motion->constants[43] * t1302) + (motion->constants[27] * t1315);
    const double t1319 = (t1302 * t1312) - (t1310 * t1317);
    const double t1320 = motion->constants[7] * t1301;
    const double t1321 = t1304 * t1320;
    const double t1323 = sin_phi * motion->constants[60];
    const double t1324 = t298 * t1304;
    const double t1327 = t1321 - (motion->constants[7] * t1324);
    const double t1328 = t1323 + t1327;
    const double t1330 = t297 * t1310;
    const double t1331 = speeds[0] * t1301;
    const double t1332 = motion->constants[31] * t1302;
    const double t1334 = motion->constants[30] * t1302;
    const double t1336 = (t1310 * t1332) + (t1306 * t1334);
    const double t1338 = t297 * t1306;
    const double t1339 = (t12 * t1331) + t1338;
    const double t1342 = t1330 + (t7 * t1331);
    const double t1346 = t1336 + (motion->constants[30] * t1339) + (motion->constants[31] * t1342) -
        t1327;
    const double t1349 = motion->constants[30] * t1310;
    const double t1350 = motion->constants[31] * t1306;
    const double t1351 = t1349 - t1350;
    const double t1353 = (t1302 * t1334) + (t1310 * t1351);
    const double t1354 = speeds[0] * t1304;
    const double t1357 = motion->constants[7] * speeds[0];
    const double t1358 = t1304 * t1357;
    const double t1359 = (motion->constants[7] * t1354) + t1358;
    const double t1362 = t298 - t1301;
    const double t1364 = (t1320 * t1362) - (speeds[0] * t1357);
    const double t1368 = (t12 * t1359) + (t7 * t1364) - t1353 - (motion->constants[31] * t1354);
    const double t1370 = speeds[1] + t1310;
    const double t1374 = (cos_delta * t1302) - (sin_delta * t1306);
    const double t1375 = motion->constants[38] * t1374;
    const double t1379 = (cos_delta * t1306) + (sin_delta * t1302);
    const double t1380 = motion->constants[37] * t1374;
    const double t1385 = speeds[1] * t1374;
    const double t1387 = t1385 - (cos_delta * t1342) - (sin_delta * t1354);
    const double t1389 = t30 * motion->constants[8];
    const double t1394 = (speeds[0] * t1043) + (speeds[1] * t1029) + (speeds[3] * t1035);
    const double t1396 = t1339 + (t1379 * t1394);
    const double t1398 = t27 * motion->constants[8];
    const double t1400 = t1387 - (t1370 * t1394);
    const double t1402 = t26 * t40;
    const double t1405 = (t30 * t1379) + (t27 * t1370);
    const double t1406 = t1402 * t1405;
    const double t1407 = t27 * t1406;
    const double t1408 = motion->constants[8] * t1407;
    const double t1410 = t30 * t1406;
    const double t1411 = motion->constants[8] * t1410;
    const double t1417 = (cos_delta * t1346) + (t1370 * t1375) + (t1379 * t1380) +
        (motion->constants[37] * t1339) + (t1389 * t1396) + (t1370 * t1408);
    const double t1421 = t1417 + (t1379 * t1411) - (sin_delta * t1368) - (motion->constants[38] *
        t1387) - (t1398 * t1400);
    const double t1426 = motion->constants[37] * t1370;
    const double t1427 = motion->constants[38] * t1379;
    const double t1428 = t1426 - t1427;
    const double t1432 = speeds[1] * t1379;
    const double t1434 = (sin_delta * t1342) - (cos_delta * t1354) - t1432;
    const double t1437 = t1374 + t1394;
    const double t1441 = (t30 * t1370) - (t27 * t1379);
    const double t1442 = motion->constants[8] * t1441;
    const double t1448 = (cos_delta * t1368) + (sin_delta * t1346) + (motion->constants[38] *
        t1434) + (t1398 * t1434) - (t1374 * t1380) - (t1370 * t1428);
    const double t1450 = t1448 - (t1411 * t1437) - (t1370 * t1442);
    const double t1454 = (t1306 * t1351) - (t1302 * t1332);
    const double t1468 = t1454 + (motion->constants[30] * t1354) + (t7 * t1359) + (t1379 * t1428) +
        (t1379 * t1442) - (t12 * t1364);
    const double t1472 = t1468 - (t1374 * t1375) - (motion->constants[37] * t1434) - (t1389 *
        t1434) - (t1408 * t1437);
    const double t1474 = (t30 * t1450) + (t27 * t1472);
    const double t1479 = t53 * ((t40 * t1421) + (t25 * t1474));
    const double t1483 = t442 * ((t25 * t1421) + (t485 * t1479) - (t40 * t1474));
    const double t1485 = t1331 - (cos_phi * t1483);
    const double t1487 = t1330 + (t7 * t1485);
    const double t1490 = t1338 + (t12 * t1485);
    const double t1494 = motion->constants[42] * t1310;
    const double t1495 = (motion->constants[45] * t1306) + t1494;
    const double t1497 = (t1306 * t1317) - (t1302 * t1495);
    const double t1502 = t1336 + (motion->constants[30] * t1490) + (motion->constants[31] * t1487) -
        t1328;
    const double t1505 = t1354 - t1479;
    const double t1506 = (sin_phi * t1483) + t1505;
    const double t1509 = (motion->constants[7] * t1506) + t1358;
    const double t1512 = t1364 + (cos_phi * motion->constants[60]);
    const double t1513 = t7 * t1512;
    const double t1514 = t1513 + (t12 * t1509);
    const double t1516 = t1514 - (motion->constants[31] * t1506) - t1353;
    const double t1518 = (cos_delta * t1502) - (sin_delta * t1516);
    const double t1523 = t1385 - (sin_delta * t1506) - (cos_delta * t1487);
    const double t1528 = (motion->constants[52] * t1374) + (motion->constants[28] * t1437);
    const double t1531 = motion->constants[51] * t1370;
    const double t1532 = (motion->constants[50] * t1379) + t1531;
    const double t1534 = (t1379 * t1528) - (t1374 * t1532);
    const double t1537 = (motion->constants[48] * t1518) + (motion->constants[51] * t1523) +
        (motion->constants[53] * t1490) + t1534;
    const double t1538 = motion->constants[32] * t1302;
    const double t1540 = motion->constants[32] * t1310;
    const double t1541 = motion->constants[33] * t1306;
    const double t1542 = t1540 + t1541;
    const double t1544 = (t1302 * t1538) + (t1310 * t1542);
    const double t1547 = t1514 + t1544 - (motion->constants[33] * t1506);
    const double t1549 = motion->constants[33] * t1302;
    const double t1552 = (t1310 * t1549) - (t1306 * t1538);
    const double t1557 = t1552 + (motion->constants[33] * t1487) - t1328 - (motion->constants[32] *
        t1490);
    const double t1561 = (t1306 * t1542) + (t1302 * t1549);
    const double t1563 = t12 * t1512;
    const double t1565 = t1563 - (t7 * t1509);
    const double t1567 = (motion->constants[32] * t1506) + t1561 + t1565;
    const double t1570 = (cos_theta * t1557) - (t1120 * t1567) - (t1081 * t1547);
    const double t1577 = (cos_theta * t1302) + (t1120 * t1310) - (t1081 * t1306);
    const double t1578 = speeds[2] * t1577;
    const double t1579 = motion->constants[2] * t1578;
    const double t1585 = t1579 - (t1081 * t1506) + (t1075 * t1490) - (t1071 * t1487);
    const double t1587 = motion->constants[3] * t1578;
    const double t1593 = (t1098 * t1490) - t1587 - (t1075 * t1487) + (t1120 * t1506);
    const double t1598 = motion->constants[3] * speeds[2];
    const double t1601 = (t1071 * t1306) + (t1081 * t1302) + (t1075 * t1310) + t1598;
    const double t1602 = motion->constants[57] * t1601;
    const double t1606 = motion->constants[2] * speeds[2];
    const double t1609 = (t1075 * t1306) + (t1098 * t1310) + t1606 - (t1120 * t1302);
    const double t1611 = t1602 + (motion->constants[59] * t1609);
    const double t1613 = motion->constants[58] * t1577;
    const double t1615 = (t1577 * t1611) - (t1609 * t1613);
    const double t1618 = (motion->constants[56] * t1585) + (motion->constants[57] * t1593) + t1615 -
        (motion->constants[55] * t1570);
    const double t1624 = (t1071 * t1547) + (t1081 * t1557) - (t1075 * t1567);
    const double t1630 = (t1075 * t1547) - (t1098 * t1567) - (t1120 * t1557);
    const double t1635 = speeds[2] * ((motion->constants[3] * t1609) - (motion->constants[2] *
        t1601));
    const double t1641 = t1635 + (t1081 * t1487) - (cos_theta * t1506) + (t1120 * t1490);
    const double t1644 = motion->constants[57] * t1609;
    const double t1645 = (motion->constants[56] * t1601) + t1644;
    const double t1648 = (t1609 * t1645) - (t1601 * t1611);
    const double t1651 = (motion->constants[55] * t1624) + (motion->constants[58] * t1641) + t1648 -
        (motion->constants[54] * t1630);
    const double t1658 = (t1601 * t1613) - (t1577 * t1645);
    const double t1661 = (motion->constants[54] * t1570) + (motion->constants[57] * t1585) +
        (motion->constants[59] * t1593) + t1658;
    const double t1666 = motion->constants[54] * t1577;
    const double t1668 = motion->constants[54] * t1609;
    const double t1669 = motion->constants[55] * t1601;
    const double t1670 = t1668 - t1669;
    const double t1672 = (t1577 * t1666) + (t1609 * t1670);
    const double t1674 = (t1624 * motion->constants[24]) + (motion->constants[55] * t1641) - t1672;
    const double t1679 = motion->constants[55] * t1577;
    const double t1682 = (t1609 * t1679) + (t1601 * t1666);
    const double t1685 = (t1570 * motion->constants[24]) + (motion->constants[54] * t1593) + t1682 -
        (motion->constants[55] * t1585);
    const double t1691 = (t1601 * t1670) - (t1577 * t1679);
    const double t1693 = (t1630 * motion->constants[24]) + t1691 - (motion->constants[54] * t1641);
    const double t1696 = (t1081 * t1674) + (cos_theta * t1685) - (t1120 * t1693);
    const double t1701 = (cos_delta * t1516) + (sin_delta * t1502);
    const double t1707 = (sin_delta * t1487) - (cos_delta * t1506) - t1432;
    const double t1709 = motion->constants[48] * t1374;
    const double t1711 = motion->constants[48] * t1370;
    const double t1712 = t1379 * motion->constants[49];
    const double t1713 = t1711 - t1712;
    const double t1715 = (t1374 * t1709) + (t1370 * t1713);
    const double t1717 = (motion->constants[47] * t1701) + (motion->constants[49] * t1707) - t1715;
    const double t1722 = t1374 * motion->constants[49];
    const double t1725 = (t1370 * t1722) + (t1379 * t1709);
    const double t1728 = (t1518 * motion->constants[47]) + (motion->constants[48] * t1490) + t1725 -
        (t1523 * motion->constants[49]);
    const double t1730 = (sin_delta * t1717) + (cos_delta * t1728);
    const double t1736 = (motion->constants[46] * t1490) + t1497 + t1537 + (t1075 * t1618) +
        (t1120 * t1651) + (t1098 * t1661);
    const double t1740 = t1736 + (motion->constants[30] * t1730) - (motion->constants[40] * t1328) -
        (motion->constants[42] * t1487) - (motion->constants[32] * t1696);
    const double t1752 = motion->constants[51] * t1379;
    const double t1754 = t1752 + (motion->constants[53] * t1370);
    const double t1757 = (t1374 * t1754) - (t1370 * t1528);
    const double t1760 = (motion->constants[50] * t1523) + (motion->constants[51] * t1490) + t1757 -
        (t1518 * motion->constants[49]);
    const double t1765 = t1454 - t1565 + (motion->constants[30] * t1506);
    const double t1775 = t775 * ((t30 * t1472) + (t796 * t1483) - (t27 * t1450) - (t804 * t1479));
    const double t1777 = motion->constants[28] * (t1707 + t1775);
    const double t1780 = (t1370 * t1532) - (t1379 * t1754);
    const double t1784 = (t1701 * motion->constants[49]) + (motion->constants[52] * t1707) + t1777 +
        t1780 - (motion->constants[48] * t1765);
    const double t1791 = t1319 + (motion->constants[41] * t1328) + (motion->constants[42] * t1490) +
        (t1071 * t1618) + (t1075 * t1661) + (cos_delta * t1760);
    const double t1796 = t1791 - (motion->constants[45] * t1487) - (t1081 * t1651) -
        (motion->constants[33] * t1696) - (sin_delta * t1784) - (motion->constants[31] * t1730);
    const double t1802 = motion->constants[41] * t1302;
    const double t1804 = motion->constants[40] * t1302;
    const double t1806 = (t1310 * t1802) + (t1306 * t1804);
    const double t1812 = motion->constants[7] * (t1696 + t1730 + (motion->constants[40] * t1490) +
        (motion->constants[41] * t1487) + t1806 - (t1328 * motion->constants[44]));
    const double t1818 = (t1310 * t1495) - (t1306 * t1312);
    const double t1826 = (t1071 * t1674) + (t1075 * t1693) - (t1081 * t1685);
    const double t1832 = (t1075 * t1674) + (t1120 * t1685) + (t1098 * t1693);
    const double t1838 = (cos_delta * t1717) - (sin_delta * t1728);
    const double t1844 = (t1379 * t1713) - (t1374 * t1722);
    const double t1846 = (motion->constants[47] * t1765) + t1844 - (motion->constants[48] * t1707);
    const double t1851 = motion->constants[40] * t1310;
    const double t1852 = motion->constants[41] * t1306;
    const double t1853 = t1851 - t1852;
    const double t1856 = (t1306 * t1853) - (t1302 * t1802);
    const double t1866 = (t1302 * t1804) + (t1310 * t1853);
    const double t1872 = (t7 * (t1832 + t1846 + t1856 - (t1565 * motion->constants[44]) +
        (motion->constants[40] * t1506))) + (t12 * (t1826 + t1838 + (t1514 *
        motion->constants[44]) - (motion->constants[41] * t1506) - t1866));
    const double t1874 = (motion->constants[27] * t1506) + (motion->constants[7] * t1872);
    const double t1879 = (motion->constants[41] * t1514) + (motion->constants[40] * t1565) -
        (motion->constants[43] * t1506) + t1818 + (t1081 * t1618) + (cos_theta * t1651);
    const double t1884 = t1879 + (motion->constants[33] * t1826) + (motion->constants[32] * t1832) +
        (sin_delta * t1760) + (cos_delta * t1784) + (motion->constants[31] * t1838);
    const double t1887 = t1884 - t1874 - (t1120 * t1661) - (motion->constants[30] * t1846);
    const double t1891 = (t12 * t1740) - (t7 * t1796);
    const double t1898 = forces[0] + (t1242 * t1891) - (t7 * t1740) - (t12 * t1796) - t1812 -
        (t1231 * t1887);
    const double t1899 = t1898 - (t1043 * t1777);
    const double t1901 = motion->constants[53] + t1135;
    const double t1906 = t135 - (sin_phi * t513);
    const double t1908 = cos_phi * t513;
    const double t1910 = t12 * motion->constants[7];
    const double t1911 = t1202 * t1910;
    const double t1912 = t1204 + t1911;
    const double t1916 = t1912 + (t1256 * t1906) - (t1263 * t1908);
    const double t1920 = (t12 * t1901) - (t7 * t1161);
    const double t1924 = t1920 + (t1263 * t1906) - (t1269 * t1908);
    const double t1929 = (cos_delta * t1906) - (t1279 * t1908);
    const double t1930 = t1029 + t1929;
    const double t1936 = (t7 * t1901) + (t12 * t1161) + (motion->constants[7] * t1134) + (t1229 *
        t1906) + (t1231 * t1916) + (t1275 * t1906);
    const double t1940 = t1295 * (t1936 + (t1285 * t1930) - (t1241 * t1908) - (t1242 * t1924));
    const double t1945 = motion->constants[27] * t1906;
    const double t1947 = motion->constants[28] * t1930;
    const double t1949 = t1294 * t1940;
    const double t1955 = motion->constants[53] + (t1906 * t1916) + (t1906 * t1912) + (t1906 *
        t1945) + (t1930 * t1947) - (t1908 * t1924);
    const double t1957 = t1955 - (t1908 * t1920) - (t1940 * t1949);
    const double t1958 = 1.0 / t1957;
    const double t1968 = forces[1] + (t1891 * t1908) - t1537 - (t1887 * t1906) - (t1029 * t1777) -
        (t1899 * t1940);
    const double t1971 = t1081 * motion->constants[75];
    const double t1973 = t1120 * motion->constants[75];
    const double t1978 = motion->constants[7] * ((t7 * t1973) - (t12 * t1971));
    const double t1983 = (t1081 * motion->constants[76]) - (t1120 * motion->constants[77]);
    const double t1986 = (motion->constants[32] * t1973) + t1983 - (motion->constants[33] * t1971) -
        t1978;
    const double t1988 = cos_theta * motion->constants[75];
    const double t1992 = (t1075 * motion->constants[76]) + (t1098 * motion->constants[77]);
    const double t1993 = t1992 - (motion->constants[32] * t1988);
    const double t1998 = (t1071 * motion->constants[76]) + (t1075 * motion->constants[77]);
    const double t1999 = t1998 - (motion->constants[33] * t1988);
    const double t2001 = (t12 * t1993) - (t7 * t1999);
    const double t2012 = t1295 * ((t7 * t1993) + (t12 * t1999) + (motion->constants[7] * t1988) +
        (t1231 * t1986) - (t1242 * t2001));
    const double t2016 = t1958 * ((t1906 * t1986) - (t1908 * t2001) - (t1949 * t2012));
    const double t2018 = t1294 * t2012;
    const double t2020 = t1957 * t2016;
    const double t2023 = motion->constants[78] - (t2012 * t2018) - (t2016 * t2020);
    const double t2024 = 1.0 / t2023;
    const double t2038 = forces[2] - (motion->constants[3] * t1618) - (motion->constants[2] *
        t1661) - (positions[6] * motion->constants[5]) - (speeds[2] * motion->constants[6]) -
        (t1899 * t2012);
    const double t2039 = t2038 - (t1968 * t2016);
    const double t2041 = sin_phi * t505;
    const double t2043 = cos_phi * t505;
    const double t2049 = motion->constants[7] * (t1189 - motion->constants[73]);
    const double t2053 = t2049 + (t1256 * t2041) + (t1263 * t2043);
    const double t2058 = t1261 - (t1263 * t2041) - (t1269 * t2043);
    const double t2060 = 1.0 - t2041;
    const double t2064 = (cos_delta * t2041) + (t1279 * t2043);
    const double t2065 = t1035 - t2064;
    const double t2071 = (t1275 * t2060) + (t1285 * t2065) - (t1229 * t2041) - (t1241 * t2043) -
        (t1231 * t2053) - (t1242 * t2058);
    const double t2072 = t1295 * t2071;
    const double t2085 = t1911 + (t1945 * t2060) + (t1947 * t2065) - (t1906 * t2053) - (t1908 *
        t2058) - (t1912 * t2041);
    const double t2088 = t1958 * (t2085 - (t1920 * t2043) - (t1949 * t2072));
    const double t2094 = t2024 * (t1978 + (t1986 * t2041) + (t2001 * t2043) + (t2018 * t2072) +
        (t2020 * t2088));
    const double t2105 = (t1887 * t2041) + (t1891 * t2043) + (t2039 * t2094) + t1874 - (t1035 *
        t1777) - (t1899 * t2072);
    const double t2114 = motion->constants[28] * t2065;
    const double t2126 = (t2041 * t2053) + (t2041 * t2049) + motion->constants[79] +
        (motion->constants[27] * t2060 * t2060) + (t2065 * t2114) - (t2043 * t2058);
    const double t2131 = 1.0 / (t2126 - (t1261 * t2043) - (t1294 * t2072 * t2072) - (t1957 * t2088 *
        t2088) - (t2023 * t2094 * t2094));
    const double t2132 = (t2105 - (t1968 * t2088)) * t2131;
    const double t2134 = (t2024 * t2039) + (t2094 * t2132);
    const double t2138 = (t1958 * t1968) - (t2016 * t2134) - (t2088 * t2132);
    const double t2144 = (t1295 * t1899) - (t1940 * t2138) - (t2012 * t2134) - (t2072 * t2132);
    const double t2145 = t1324 + t2144;
    const double t2148 = t1321 + t1323 - (motion->constants[7] * t2145);
    const double t2156 = t1483 + (t516 * t2144) + (t513 * t2138) + (t505 * t2132);
    const double t2158 = t1331 - (cos_phi * t2156);
    const double t2161 = (t12 * t2144) - t1330 - (t7 * t2158);
    const double t2166 = t1338 + (t12 * t2158) + (t7 * t2144);
    const double t2173 = (t141 * t2144) + (t135 * t2138) - (sin_phi * t2156) - t1505;
    const double t2175 = t2132 + t2173;
    const double t2177 = (motion->constants[7] * t2175) - t1358;
    const double t2179 = t1513 - (t12 * t2177);
    const double t2181 = t1544 + (motion->constants[33] * t2173) + t2179;
    const double t2187 = t1552 - t2148 - (motion->constants[32] * t2166) - (motion->constants[33] *
        t2161);
    const double t2191 = t1563 + (t7 * t2177);
    const double t2193 = (motion->constants[32] * t2173) - t1561 - t2191;
    const double t2196 = (cos_theta * t2187) + (t1120 * t2193) - (t1081 * t2181);
    const double t2205 = t1579 + (t1071 * t2161) + (t1081 * t2173) + (t1075 * t2166) +
        (motion->constants[3] * t2134);
    const double t2214 = (t1075 * t2161) + (t1098 * t2166) + (motion->constants[2] * t2134) -
        t1587 - (t1120 * t2173);
    const double t2218 = t1615 + (motion->constants[56] * t2205) + (motion->constants[57] * t2214) -
        (motion->constants[55] * t2196);
    const double t2224 = (t1071 * t2181) + (t1081 * t2187) + (t1075 * t2193);
    const double t2230 = (t1075 * t2181) + (t1098 * t2193) - (t1120 * t2187);
    const double t2237 = t1635 + (cos_theta * t2173) + (t1120 * t2166) - (t1081 * t2161);
    const double t2241 = t1648 + (motion->constants[55] * t2224) + (motion->constants[58] * t2237) -
        (motion->constants[54] * t2230);
    const double t2248 = t1658 + (motion->constants[54] * t2196) + (motion->constants[57] * t2205) +
        (motion->constants[59] * t2214);
    const double t2250 = motion->constants[24] * t2224;
    const double t2253 = t2250 + (motion->constants[55] * t2237) - t1672;
    const double t2255 = motion->constants[24] * t2196;
    const double t2260 = t1682 + t2255 + (motion->constants[54] * t2214) - (motion->constants[55] *
        t2205);
    const double t2262 = motion->constants[24] * t2230;
    const double t2265 = t1691 + t2262 - (motion->constants[54] * t2237);
    const double t2268 = (t1081 * t2253) + (cos_theta * t2260) - (t1120 * t2265);
    const double t2274 = t1336 + (motion->constants[30] * t2166) - t2148 - (motion->constants[31] *
        t2161);
    const double t2278 = t2179 + (motion->constants[31] * t2173) - t1353;
    const double t2280 = (cos_delta * t2274) - (sin_delta * t2278);
    const double t2285 = t1385 + (cos_delta * t2161) + (sin_delta * t2173);
    const double t2287 = t2138 + t2166;
    const double t2291 = t1757 + (motion->constants[50] * t2285) + (motion->constants[51] * t2287) -
        (motion->constants[49] * t2280);
    const double t2295 = (cos_delta * t2278) + (sin_delta * t2274);
    const double t2299 = t1454 - t2191 - (motion->constants[30] * t2173);
    const double t2304 = (cos_delta * t2173) - t1432 - (sin_delta * t2161);
    const double t2312 = t1775 + t2304 + (t1043 * t2144) + (t1029 * t2138) + (t1035 * t2132);
    const double t2313 = motion->constants[28] * t2312;
    const double t2317 = t1780 + (motion->constants[49] * t2295) + (motion->constants[52] * t2304) +
        t2313 - (motion->constants[48] * t2299);
    const double t2322 = (motion->constants[47] * t2295) + (motion->constants[49] * t2304) - t1715;
    const double t2329 = t1725 + (motion->constants[47] * t2280) + (motion->constants[48] * t2287) -
        (motion->constants[49] * t2285);
    const double t2331 = (sin_delta * t2322) + (cos_delta * t2329);
    const double t2337 = t1319 + (motion->constants[41] * t2148) + (motion->constants[45] * t2161) +
        (motion->constants[42] * t2166) + (t1071 * t2218) + (t1075 * t2248);
    const double t2342 = t2337 + (cos_delta * t2291) - (t1081 * t2241) - (motion->constants[33] *
        t2268) - (sin_delta * t2317) - (motion->constants[31] * t2331);
    const double t2349 = (t1071 * t2253) + (t1075 * t2265) - (t1081 * t2260);
    const double t2352 = (cos_delta * t2322) - (sin_delta * t2329);
    const double t2356 = (motion->constants[44] * t2179) + (motion->constants[41] * t2173) + t2349 +
        t2352 - t1866;
    const double t2357 = motion->constants[7] * t2356;
    const double t2375 = t1497 + t1534 + (motion->constants[42] * t2161) + (motion->constants[46] *
        t2166) + (motion->constants[48] * t2280) + (motion->constants[51] * t2285) +
        (motion->constants[53] * t2287);
    const double t2380 = t2375 + (t1075 * t2218) + (t1120 * t2241) + (t1098 * t2248) +
        (motion->constants[30] * t2331) - (motion->constants[40] * t2148);
    const double t2381 = t2380 - (motion->constants[32] * t2268);
    const double t2383 = t775 * motion->constants[28];
    const double t2384 = t1472 * t2383;
    const double t2386 = t1450 * t2383;
    const double t2388 = t796 * t2383;
    const double t2389 = t442 * t1421;
    const double t2391 = t40 * t442;
    const double t2392 = t1450 * t2391;
    const double t2394 = t1472 * t2391;
    const double t2397 = (t86 * t2389) + (t87 * t2392) - (t93 * t2394);
    const double t2400 = (t2388 * t2397) - (t87 * t2384) - (t93 * t2386);
    const double t2402 = motion->constants[44] * t1910;
    const double t2403 = motion->constants[41] - t2402;
    const double t2406 = (t12 * t1242) - t7;
    const double t2408 = cos_delta * motion->constants[49];
    const double t2410 = sin_delta * motion->constants[49];
    const double t2414 = t89 + (t107 * t1242) + (sin_delta * t1231);
    const double t2416 = sin_delta * motion->constants[47];
    const double t2418 = cos_delta * motion->constants[30];
    const double t2420 = cos_delta * motion->constants[31];
    const double t2422 = sin_delta * motion->constants[31];
    const double t2423 = motion->constants[7] * t1277;
    const double t2424 = t2423 - t2422;
    const double t2428 = (t12 * t2418) + (t7 * t2420);
    const double t2433 = (t12 * t2420) + (t1242 * t2428) - (cos_delta * motion->constants[7]) -
        (t7 * t2418) - (t1231 * t2424);
    const double t2435 = cos_delta * motion->constants[47];
    const double t2437 = sin_delta * motion->constants[30];
    const double t2440 = motion->constants[7] * t89;
    const double t2441 = t2420 - t2440;
    const double t2445 = (t12 * t2437) + (t7 * t2422);
    const double t2450 = (t12 * t2422) + (t1242 * t2445) - (sin_delta * motion->constants[7]) -
        (t7 * t2437) - (t1231 * t2441);
    const double t2455 = (t2435 * t2450) - (t1202 * t2406) - (t1282 * t2408) - (t2410 * t2414) -
        (t2416 * t2433);
    const double t2457 = (t1071 * motion->constants[55]) - t1095;
    const double t2460 = (t7 * t1120) - (t12 * t1081);
    const double t2463 = (t7 * t1081) + (t12 * t1120);
    const double t2467 = (t1242 * t2463) - t2460 - (cos_theta * t1231);
    const double t2469 = t1075 * motion->constants[24];
    const double t2473 = (t12 * motion->constants[33]) + (t7 * motion->constants[32]) -
        motion->constants[7];
    const double t2477 = (t7 * motion->constants[33]) - (t12 * motion->constants[32]);
    const double t2478 = t1120 * t2477;
    const double t2482 = t12 * t1075;
    const double t2484 = t2482 + (t7 * t1098);
    const double t2485 = motion->constants[7] * t2484;
    const double t2487 = (t1075 * motion->constants[33]) + (t1098 * motion->constants[32]) - t2485;
    const double t2490 = (t1120 * t2473) + (t1242 * t2478) + (t1231 * t2487);
    const double t2492 = t1071 * motion->constants[24];
    const double t2494 = t1081 * t2477;
    const double t2499 = t7 * t1075;
    const double t2500 = (t12 * t1071) + t2499;
    const double t2501 = motion->constants[7] * t2500;
    const double t2503 = (t1071 * motion->constants[33]) + (t1075 * motion->constants[32]) - t2501;
    const double t2506 = (t1081 * t2473) + (t1242 * t2494) - (t1231 * t2503);
    const double t2509 = (t12 * t1098) - t2499;
    const double t2513 = (t1242 * t2509) + (t1120 * t1231) - t2484;
    const double t2516 = t2482 - (t7 * t1071);
    const double t2520 = (t1242 * t2516) - t2500 - (t1081 * t1231);
    const double t2523 = cos_theta * t2477;
    const double t2527 = motion->constants[7] * t2460;
    const double t2529 = (t1120 * motion->constants[32]) - (t1081 * motion->constants[33]) - t2527;
    const double t2532 = (cos_theta * t2473) + (t1242 * t2523) - (t1231 * t2529);
    const double t2535 = (motion->constants[54] * t2513) + (motion->constants[24] * t2532) -
        (motion->constants[55] * t2520);
    const double t2539 = (t2457 * t2467) + (t2492 * t2506) - (t2469 * t2490) - (t1081 * t2535);
    const double t2541 = t2455 + t2539 - (t1231 * t2403);
    const double t2544 = t7 * motion->constants[47];
    const double t2546 = motion->constants[7] * ((t7 * motion->constants[44]) + t2544);
    const double t2547 = t1184 + t2546;
    const double t2549 = motion->constants[48] * t1282;
    const double t2551 = t1130 - (motion->constants[54] * t1098);
    const double t2553 = t1098 * motion->constants[24];
    const double t2559 = (t2467 * t2551) + (t2469 * t2506) + (t1120 * t2535) - (t2490 * t2553);
    const double t2561 = (t1231 * t2547) + t2549 + t2559;
    const double t2564 = t12 * motion->constants[42];
    const double t2567 = t7 * motion->constants[42];
    const double t2569 = (t12 * motion->constants[46]) - t2567;
    const double t2575 = (t1081 * motion->constants[55]) + (motion->constants[54] * t1120);
    const double t2577 = t1120 * motion->constants[24];
    const double t2579 = t1081 * motion->constants[24];
    const double t2584 = (t2467 * t2575) + (t2490 * t2577) + (t2506 * t2579) + (cos_theta * t2535);
    const double t2594 = (t1134 * t2406) + (t2408 * t2414) + (t2433 * t2435) + (t2416 * t2450) -
        (t1282 * t2410);
    const double t2600 = (motion->constants[59] * t2513) + (motion->constants[57] * t2520) +
        (motion->constants[54] * t2532);
    const double t2606 = (motion->constants[58] * t2467) + (motion->constants[54] * t2490) +
        (motion->constants[55] * t2506);
    const double t2612 = (motion->constants[57] * t2513) + (motion->constants[56] * t2520) -
        (motion->constants[55] * t2532);
    const double t2618 = (motion->constants[53] * t2406) + (t1242 * t2569) +
        (motion->constants[48] * t2433) + (motion->constants[30] * t2594) + (t1098 * t2600) +
        (t1120 * t2606);
    const double t2623 = t2618 + (t1075 * t2612) - (motion->constants[7] * motion->constants[40]) -
        t2564 - (t7 * motion->constants[46]) - (motion->constants[51] * t2414);
    const double t2624 = t2623 - (motion->constants[32] * t2584);
    const double t2629 = t2564 - (t7 * motion->constants[45]);
    const double t2636 = motion->constants[30] * motion->constants[48];
    const double t2637 = t7 * motion->constants[7];
    const double t2638 = motion->constants[48] * t2637;
    const double t2639 = t2636 + t2638;
    const double t2645 = (motion->constants[49] * t2450) - t1285 - (t1231 * t2639) -
        (motion->constants[52] * t1282);
    const double t2651 = (motion->constants[51] * t2406) - (motion->constants[50] * t2414) -
        (motion->constants[49] * t2433);
    const double t2657 = (motion->constants[7] * motion->constants[41]) + (t1242 * t2629) + (t1075 *
        t2600) + (t1071 * t2612) + (cos_delta * t2651) - t2567;
    const double t2662 = t2657 - (t12 * motion->constants[45]) - (motion->constants[33] * t2584) -
        (motion->constants[31] * t2594) - (t1081 * t2606) - (sin_delta * t2645);
    const double t2664 = t12 * t139;
    const double t2666 = t7 * t139;
    const double t2669 = motion->constants[43] + motion->constants[27];
    const double t2673 = (t12 * motion->constants[41]) - (t7 * motion->constants[40]);
    const double t2675 = motion->constants[7] * (t2673 - (t7 * motion->constants[67]));
    const double t2677 = motion->constants[71] + t2669 - t2675;
    const double t2692 = (motion->constants[32] * t2559) + (motion->constants[33] * t2539) +
        (motion->constants[31] * t2455) + (cos_theta * t2606) + (t1081 * t2612) + (cos_delta *
        t2645);
    const double t2696 = t2692 + (sin_delta * t2651) - (t1231 * t2677) - (t1282 * t2636) - (t1120 *
        t2600);
    const double t2702 = (t2541 * t2664) + (t2561 * t2666) + (t16 * t2662) - (t13 * t2624) -
        (sin_phi * t2696);
    const double t2704 = t53 * t1474;
    const double t2706 = t25 * t53;
    const double t2707 = t1450 * t2706;
    const double t2709 = t1472 * t2706;
    const double t2712 = (t86 * t2704) + (t93 * t2709) - (t87 * t2707);
    const double t2715 = (t486 * t2388) - (t804 * t2383);
    const double t2723 = t2696 + (t486 * t2702) - (t1283 * t2715) - (t1910 * t2541) - (t2561 *
        t2637);
    const double t2725 = motion->constants[8] * t1434;
    const double t2726 = motion->constants[8] * t1370;
    const double t2728 = (t1379 * t2726) - t2725;
    const double t2730 = motion->constants[8] * t1406;
    const double t2731 = t1437 * t2730;
    const double t2732 = motion->constants[8] * t1379;
    const double t2734 = t2731 + (t1379 * t2732);
    const double t2737 = t1364 + (t87 * t2728) + (t93 * t2734);
    const double t2739 = t27 * t2391;
    const double t2741 = (t30 * t2383) - (t2388 * t2739);
    const double t2744 = t27 * t2706;
    const double t2747 = (t2723 * t2744) - (t1283 * t2741) - (t2702 * t2739);
    const double t2749 = motion->constants[37] + t1389;
    const double t2752 = motion->constants[30] * t1331;
    const double t2756 = (motion->constants[8] * t1396) + (t1379 * t2730);
    const double t2760 = (t1370 * t2730) - (motion->constants[8] * t1400);
    const double t2765 = (t1331 * t2749) + (cos_delta * t2752) + (t93 * t2760) - (sin_delta *
        t1359) - (t87 * t2756);
    const double t2766 = t25 * t442;
    const double t2767 = t2388 * t2766;
    const double t2770 = t40 * t53;
    const double t2773 = (t2702 * t2766) + (t2723 * t2770) - (t1283 * t2767);
    const double t2778 = t2731 + (t1370 * t2726);
    const double t2781 = t2725 + (t1370 * t2732);
    const double t2785 = (cos_delta * t1359) + (sin_delta * t2752) + (t87 * t2778) + (t93 * t2781);
    const double t2787 = t30 * t2391;
    const double t2789 = (t27 * t2383) + (t2388 * t2787);
    const double t2792 = t30 * t2706;
    const double t2795 = (t1283 * t2789) + (t2723 * t2792) - (t2702 * t2787);
    const double t2797 = t26 * t1405;
    const double t2798 = t1402 * t2797;
    const double t2800 = t1379 * t1402;
    const double t2802 = t1370 * t1402;
    const double t2805 = (t93 * t2802) - (t86 * t2798) - (t87 * t2800);
    const double t2806 = t1398 * t1437;
    const double t2808 = t1370 * t1398;
    const double t2809 = t1379 * t1389;
    const double t2810 = t2808 + t2809;
    const double t2811 = t2773 * t2810;
    const double t2812 = t1389 * t1437;
    const double t2815 = t2811 - (t2747 * t2806) - (t2795 * t2812);
    const double t2818 = motion->constants[42] * t1302;
    const double t2819 = t12 * t2818;
    const double t2821 = t1317 - (motion->constants[45] * t1302);
    const double t2823 = t7 * t2818;
    const double t2825 = (t12 * t2821) - t2823;
    const double t2828 = t1722 + t1722;
    const double t2830 = t1713 - t1712;
    const double t2832 = (sin_delta * t2828) + (cos_delta * t2830);
    const double t2834 = motion->constants[41] * t1310;
    const double t2841 = motion->constants[7] * ((t12 * t2834) + (t7 * (t1853 - t1852)) + (t7 *
        t2832));
    const double t2845 = (motion->constants[45] * t1310) - t1307 - t1312 - (motion->constants[30] *
        t2832) - t2841;
    const double t2847 = motion->constants[52] + motion->constants[28];
    const double t2849 = (t1379 * t2847) - t1532;
    const double t2852 = t1528 - (motion->constants[50] * t1374);
    const double t2854 = (cos_delta * t2852) - (sin_delta * t2849);
    const double t2858 = (motion->constants[50] * t1370) - t1752 - t1754;
    const double t2859 = cos_delta * t2858;
    const double t2862 = t1754 - (t1370 * t2847);
    const double t2864 = motion->constants[51] * t1374;
    const double t2866 = (cos_delta * t2864) - (sin_delta * t2862);
    const double t2868 = t1370 * motion->constants[49];
    const double t2869 = motion->constants[48] * t1379;
    const double t2870 = t2868 + t2869;
    const double t2873 = (cos_delta * t1709) - (sin_delta * t2870);
    const double t2876 = t1709 + t1709;
    const double t2878 = (cos_delta * t2868) + (sin_delta * t2876);
    const double t2880 = t1541 + t1542;
    const double t2883 = motion->constants[33] * t1310;
    const double t2886 = motion->constants[31] * t1310;
    const double t2888 = cos_delta * speeds[1];
    const double t2890 = sin_delta * speeds[1];
    const double t2893 = t1375 + t1408;
    const double t2894 = t1375 + t2893;
    const double t2898 = t1428 + t1442;
    const double t2901 = (speeds[1] * t2749) + t2898 - t1427 - (t1379 * t1398);
    const double t2903 = (sin_delta * t2894) + (cos_delta * t2901);
    const double t2908 = t1334 + (motion->constants[30] * t297);
    const double t2910 = t1370 * motion->constants[38];
    const double t2911 = motion->constants[37] * t1379;
    const double t2916 = t2910 + t2911 - (speeds[1] * motion->constants[38]) - (speeds[1] * t1398);
    const double t2919 = t1380 + t1411;
    const double t2920 = (t1389 * t1394) + t2919;
    const double t2925 = (t297 * t2749) + (cos_delta * t2908) + (cos_delta * t2920) - (sin_delta *
        t2886) - (sin_delta * t2916);
    const double t2929 = t1380 + t2919;
    const double t2931 = motion->constants[38] + t1398;
    const double t2934 = t2808 + t2910 - (speeds[1] * t2931);
    const double t2938 = (cos_delta * t2886) + (sin_delta * t2908) + (sin_delta * t2929) +
        (cos_delta * t2934);
    const double t2940 = t30 * t1402;
    const double t2941 = cos_delta * t2940;
    const double t2943 = t1351 - t1350;
    const double t2944 = motion->constants[7] * t2544;
    const double t2945 = motion->constants[67] + t2944;
    const double t2948 = t2549 + t2747 + (t1231 * t2945);
    const double t2950 = motion->constants[57] * t1577;
    const double t2954 = t1644 + t1645 - (motion->constants[59] * t1601);
    const double t2957 = (motion->constants[59] * t1577) - t1613;
    const double t2959 = motion->constants[54] * t1601;
    const double t2962 = t1668 + t1670;
    const double t2969 = (t2467 * t2954) + (t2520 * t2957) + (t1679 * t2532) + (t1598 * t2606) -
        (t2513 * t2950) - (t2490 * t2959);
    const double t2970 = t2969 - (t2506 * t2962);
    const double t2973 = t1613 - (motion->constants[56] * t1577);
    const double t2977 = (motion->constants[56] * t1609) - t1602 - t1611;
    const double t2980 = t1670 - t1669;
    const double t2983 = motion->constants[55] * t1609;
    const double t2990 = (t2513 * t2973) + (t2467 * t2977) + (t2520 * t2950) + (t1666 * t2532) +
        (t2506 * t2983) - (t2490 * t2980);
    const double t2991 = t2990 - (t1606 * t2606);
    const double t2994 = (motion->constants[58] * t1601) - t1645;
    const double t2997 = t1611 - (motion->constants[58] * t1609);
    const double t2999 = t1679 + t1679;
    const double t3001 = t2959 + t2983;
    const double t3003 = t1666 + t1666;
    const double t3011 = (t2513 * t2994) + (t2520 * t2997) + (t2490 * t2999) + (t2532 * t3001) +
        (t1606 * t2612) - (t2506 * t3003);
    const double t3012 = t3011 - (t1598 * t2600);
    const double t3018 = (t1242 * t2825) + (t2406 * t2854) + (t2433 * t2873) + (t2450 * t2878) +
        (t2539 * t2883) + (t1334 * t2594);
    const double t3023 = t3018 + (t2455 * t2886) + (t297 * t2624) + (t2747 * t2903) + (t2773 *
        t2925) + (t2795 * t2938);
    const double t3028 = t3023 + (t2815 * t2941) + (t2943 * t2948) + (t1075 * t2970) + (t1071 *
        t2991) - (motion->constants[7] * t1804);
    const double t3034 = t3028 - t2819 - (t7 * t2821) - (t1231 * t2845) - (t1282 * t2859) - (t2414 *
        t2866) - (t2559 * t2880);
    const double t3038 = t3034 - (t1538 * t2584) - (t2645 * t2888) - (t2651 * t2890) - (t1081 *
        t3012);
    const double t3042 = (motion->constants[46] * t1302) - t1317;
    const double t3049 = motion->constants[40] * t1306;
    const double t3054 = motion->constants[7] * ((t7 * t3049) + (t7 * t2869) - (t12 * (t1851 +
        t1853)));
    const double t3058 = t1494 + t1495 - (motion->constants[46] * t1306) - (motion->constants[30] *
        t2869) - t3054;
    const double t3061 = t2819 + (t7 * t3042);
    const double t3065 = t1531 + t1532 - (motion->constants[53] * t1379);
    const double t3068 = (motion->constants[53] * t1374) - t1528;
    const double t3071 = t1711 + t1713;
    const double t3073 = motion->constants[32] * t1306;
    const double t3076 = t1540 + t1542;
    const double t3079 = t1349 + t1351;
    const double t3082 = t2809 + t2911;
    const double t3089 = t2893 + (cos_delta * t1332) + (t1394 * t1398) + (sin_delta * t3079);
    const double t3097 = (sin_delta * t1332) - t1426 - t2898 - (cos_delta * t3079) - (t1370 *
        t1389);
    const double t3099 = t27 * t1402;
    const double t3101 = motion->constants[30] * t1306;
    const double t3103 = sin_delta * t2749;
    const double t3108 = t2420 + (cos_delta * motion->constants[38]) + (cos_delta * t1398);
    const double t3111 = t2422 + (sin_delta * t2931);
    const double t3114 = (t2773 * t3108) + (t2795 * t3111) - (t2747 * t3103);
    const double t3123 = t2823 + (t1722 * t2433) + (t1549 * t2584) + (t2539 * t3076) + (t1332 *
        t2594) + (t2747 * t3082);
    const double t3128 = t3123 + (t2773 * t3089) + (t2795 * t3097) + (t2815 * t3099) + (t2948 *
        t3101) + (t297 * t3114);
    const double t3133 = t3128 + (t1098 * t2970) + (t1075 * t2991) + (t1120 * t3012) -
        (motion->constants[7] * t1802) - (t12 * t3042);
    const double t3138 = t3133 - (t2406 * t2864) - (t1231 * t3058) - (t1242 * t3061) - (t1282 *
        t3065) - (t2414 * t3068);
    const double t3142 = t3138 - (t2450 * t3071) - (t2559 * t3073) - (t2455 * t3079) - (t297 *
        t2662);
    const double t3144 = motion->constants[28] * t2132;
    const double t3146 = motion->constants[28] * t1379;
    const double t3148 = motion->constants[28] * t1370;
    const double t3155 = t2811 + (t2406 * t3146) + (t2414 * t3148) - (t1408 * t2747) - (t1411 *
        t2795);
    const double t3157 = (speeds[3] * t3155) - (t1283 * t3144);
    const double t3159 = motion->constants[28] * t2138;
    const double t3160 = t775 * t3159;
    const double t3163 = (t779 * t3155) - (t1283 * t3160);
    const double t3167 = cos_phi * (t1357 + t1357);
    const double t3168 = t12 * t3167;
    const double t3170 = t7 * t3167;
    const double t3172 = motion->constants[7] * t1304;
    const double t3177 = (sin_phi * t3172) - (cos_phi * ((motion->constants[7] * t298) - t1320));
    const double t3181 = (t7 * motion->constants[41]) + (t12 * motion->constants[40]);
    const double t3186 = (motion->constants[7] * motion->constants[44]) - t2584 - t2594 - t2673 -
        (t1242 * t3181);
    const double t3188 = sin_phi * t1303;
    const double t3190 = cos_phi * speeds[0];
    const double t3192 = sin_phi * t1309;
    const double t3199 = cos_delta * t3190;
    const double t3201 = (cos_phi * ((t7 * t1357) + (speeds[0] * (motion->constants[30] +
        t2637)))) + (t2749 * t3199);
    const double t3204 = sin_delta * speeds[0];
    const double t3213 = cos_phi * ((t12 * t1357) + (speeds[0] * (t1910 - motion->constants[31])));
    const double t3216 = (motion->constants[30] * t3188) - t3177;
    const double t3220 = (t2749 * t3188) + (cos_phi * ((motion->constants[38] * t3204) + (t1398 *
        t3204))) + (cos_delta * t3216) - (sin_delta * t3213);
    const double t3226 = (cos_delta * t3213) + (sin_delta * t3216) - (t2931 * t3199);
    const double t3230 = sin_phi * ((motion->constants[7] * t1362) - t1320);
    const double t3239 = (t7 * t2541) + (t107 * t2795) - (t12 * t2561) - (t12 * t2747) - (t1279 *
        t2773);
    const double t3245 = t1312 - (t1310 * t2669);
    const double t3248 = (t1306 * t2669) - t1495;
    const double t3252 = (t12 * t3248) - (t7 * t3245);
    const double t3256 = (sin_delta * t2830) - (cos_delta * t2828);
    const double t3265 = motion->constants[7] * ((t7 * t3256) - (t12 * (t1804 + t1804)) - (t7 *
        (t1802 + t1802)));
    const double t3266 = (motion->constants[30] * t3256) + t3265;
    const double t3270 = (cos_delta * t2849) + (sin_delta * t2852);
    const double t3272 = sin_delta * t2858;
    const double t3276 = (cos_delta * t2862) + (sin_delta * t2864);
    const double t3280 = (sin_delta * t1709) + (cos_delta * t2870);
    const double t3284 = (sin_delta * t2868) - (cos_delta * t2876);
    const double t3286 = t1549 + t1549;
    const double t3288 = t2883 - t3073;
    const double t3290 = t1538 + t1538;
    const double t3292 = t2886 + t3101;
    const double t3294 = t1334 + t1334;
    const double t3300 = (sin_delta * t2901) - (cos_delta * t2894);
    const double t3308 = (sin_delta * t3294) + (cos_delta * t3292) + (cos_delta * t2916) +
        (sin_delta * t2920);
    const double t3316 = (sin_delta * t3292) + (sin_delta * t2934) - (cos_delta * t3294) -
        (cos_delta * t2929);
    const double t3318 = sin_delta * t2940;
    const double t3320 = t1332 + t1332;
    const double t3329 = (t1242 * t3252) + (t1231 * t3266) + (t2406 * t3270) + (t2433 * t3280) +
        (t2450 * t3284) + (t2584 * t3288);
    const double t3334 = t3329 + (t2539 * t3290) + (t2594 * t3292) + (t2651 * t2888) + (t2747 *
        t3300) + (t2773 * t3308);
    const double t3339 = t3334 + (t2795 * t3316) + (t2815 * t3318) + (t1081 * t2991) + (cos_theta *
        t3012) - (motion->constants[7] * (t2834 + t3049));
    const double t3344 = t3339 - (t12 * t3245) - (t7 * t3248) - (t1282 * t3272) - (t2414 * t3276) -
        (t2559 * t3286);
    const double t3348 = t3344 - (t2455 * t3294) - (t2645 * t2890) - (t2948 * t3320) - (t1120 *
        t2970);
    const double t3356 = (t2541 * t3168) + (t2561 * t3170) + (t3177 * t3186) + (t2624 * t3188) +
        (t2747 * t3201) + (t2773 * t3220);
    const double t3361 = t3356 + (t2795 * t3226) + (t3230 * t3239) + (t3114 * t3192) + (t16 *
        t3038) - (t2696 * t3190);
    const double t3364 = t3361 - (t2662 * t3192) - (sin_phi * t3348) - (t13 * t3142);
    const double t3368 = (t2132 * t2702) + (speeds[3] * t3364) + (t797 * t3157);
    const double t3374 = (t2138 * t2702) + (speeds[1] * t3364) + (t796 * t3163);
    const double t3376 = motion->constants[7] * t2138;
    const double t3377 = t12 * t3376;
    const double t3379 = t7 * t3376;
    const double t3381 = speeds[1] * t3172;
    const double t3383 = speeds[1] * t1306;
    const double t3386 = speeds[1] * t1310;
    const double t3389 = t3101 + t3172;
    const double t3391 = (t1306 * t2749) + (cos_delta * t3389);
    const double t3392 = speeds[1] * t3391;
    const double t3394 = sin_delta * t3389;
    const double t3395 = speeds[1] * t3394;
    const double t3397 = speeds[1] * t1320;
    const double t3407 = (t2624 * t3383) + (t2138 * t2696) + (t2773 * t3392) + (t2795 * t3395) +
        (t3239 * t3397) + (t3114 * t3386);
    const double t3412 = t3407 + (speeds[1] * t3348) + (t486 * t3374) - (t2541 * t3377) - (t2561 *
        t3379) - (t3186 * t3381);
    const double t3414 = t3412 - (t2662 * t3386) - (t804 * t3163);
    const double t3420 = (t489 * t3374) + (t74 * t3414) - (t809 * t3163);
    const double t3426 = (t818 * t3163) + (t497 * t3374) + (t77 * t3414);
    const double t3428 = t1483 * t2383;
    const double t3432 = motion->constants[28] * t2144;
    const double t3436 = (speeds[0] * t3155) - t2313 - (t1283 * t3432);
    const double t3440 = (t828 * t3157) + (t513 * t3163) + (t831 * t3436) - (t1283 * t3428);
    const double t3442 = t1479 * t2383;
    const double t3447 = (t135 * t3163) + (t840 * t3436) - (t1283 * t3442);
    const double t3449 = t442 * t1483;
    const double t3450 = t2388 * t3449;
    const double t3467 = (t1075 * t2253) + (t1120 * t2260) + (t1098 * t2265);
    const double t3475 = t1844 + (motion->constants[47] * t2299) - (motion->constants[48] * t2304);
    const double t3482 = t1856 + t3467 + t3475 - (motion->constants[44] * t2191) -
        (motion->constants[40] * t2173);
    const double t3485 = (t7 * t3482) + (t12 * t2356);
    const double t3491 = t1818 + (motion->constants[41] * t2179) + (motion->constants[40] * t2191) +
        (motion->constants[43] * t2173) + (motion->constants[27] * t2175) + (t1081 * t2218);
    const double t3496 = t3491 + (cos_theta * t2241) + (motion->constants[33] * t2349) +
        (motion->constants[32] * t3467) + (sin_delta * t2291) + (cos_delta * t2317);
    const double t3500 = t3496 + (motion->constants[31] * t2352) - (t1120 * t2248) -
        (motion->constants[30] * t3475) - (motion->constants[7] * t3485);
    const double t3506 = (sin_phi * t3500) + (cos_phi * ((t12 * t2381) - (t7 * t2342)));
    const double t3512 = t3506 + (t2144 * t2702) + (speeds[0] * t3364) + (t797 * t3436);
    const double t3517 = (t2702 * t3449) + (t506 * t3368) + (t514 * t3374) + (t517 * t3512) -
        (t1283 * t3450);
    const double t3519 = t442 * t1479;
    const double t3520 = t2388 * t3519;
    const double t3527 = (t2702 * t3519) + (t525 * t3374) + (t527 * t3512) - (t1283 * t3520);
    const double t3532 = motion->constants[7] * t2144;
    const double t3533 = t12 * t3532;
    const double t3535 = t7 * t3532;
    const double t3537 = speeds[0] * t3172;
    const double t3539 = speeds[0] * t1306;
    const double t3542 = speeds[0] * t1310;
    const double t3544 = speeds[0] * t3391;
    const double t3546 = speeds[0] * t3394;
    const double t3548 = speeds[0] * t1320;
    const double t3558 = (t2624 * t3539) + (t2144 * t2696) + (t2773 * t3544) + (t2795 * t3546) +
        (t3239 * t3548) + (t3114 * t3542);
    const double t3563 = t3558 + (speeds[0] * t3348) + (t486 * t3512) - t3500 - (t2541 * t3533) -
        (t2561 * t3535);
    const double t3566 = t3563 - (t3186 * t3537) - (t2662 * t3542) - (t859 * t3436);
    const double t3576 = (t855 * t3163) + (t531 * t3374) + (t98 * t3414) + (t53 * t3566) + (t547 *
        t3447) + (t537 * t3527);
    const double t3578 = t3576 - (t117 * t3440) - (t36 * t3517);
    const double t3580 = t136 * t1479;
    const double t3592 = t3420 + (t36 * t3440) + (t547 * t3527) - (t2723 * t3580) - (t137 * t3414) -
        (t142 * t3566);
    const double t3594 = t3592 - (t537 * t3447) - (t117 * t3517);
    const double t3600 = (t817 * t3163) + (t496 * t3374) - (sin_phi * t3578);
    const double t3606 = (t1231 * t2357) + (t1242 * t2381) + (t2158 * t2624) + (t2144 * t2662) +
        (t2397 * t2702) + (t2712 * t2723);
    const double t3611 = t3606 + (t2765 * t2773) + (t2785 * t2795) + (t2805 * t2815) + (speeds[0] *
        t3038) + (t777 * t3157);
    const double t3616 = t3611 + (t792 * t3163) + (t444 * t3368) + (t479 * t3374) + (t65 * t3414) +
        (motion->constants[31] * t3426);
    const double t3621 = t3616 + (t827 * t3440) + (t524 * t3527) + (t114 * t3594) +
        (motion->constants[39] * t3600) - t2342;
    const double t3626 = t3621 - (t1283 * t2400) - (t2177 * t2541) - (t1512 * t2561) - (t2737 *
        t2747) - (t1304 * t3142);
    const double t3630 = t3626 - (motion->constants[30] * t3420) - (t838 * t3447) - (t504 * t3517) -
        (t97 * t3578);
    const double t3632 = motion->constants[7] * t3482;
    const double t3644 = (t28 * t442 * t1474) + (t166 * t2389) + (t168 * t2392) + (t170 * t2394);
    const double t3647 = (t168 * t2384) - (t170 * t2386) - (t2388 * t3644);
    const double t3661 = (t28 * t53 * t1421) + (t168 * t2707) + (t170 * t2709) - (t166 * t2704);
    const double t3666 = t1359 + (t168 * t2728) - (t170 * t2734);
    const double t3672 = (t168 * t2756) + (t170 * t2760) - (sin_delta * t1364);
    const double t3678 = (cos_delta * t1364) + (t170 * t2781) - (t168 * t2778);
    const double t3686 = (t28 * t2797) + (t166 * t2798) + (t168 * t2800) + (t170 * t2802);
    const double t3709 = (t1231 * t3632) + (t1512 * t2541) + (t2144 * t2624) + (t2723 * t3661) +
        (t2747 * t3666) + (t2773 * t3672);
    const double t3714 = t3709 + (t2795 * t3678) + (t2815 * t3686) + (t1331 * t3114) + (t1304 *
        t3038) + (speeds[0] * t3142);
    const double t3719 = t3714 + (t909 * t3157) + (t917 * t3163) + (t568 * t3368) + (t576 * t3374) +
        (t156 * t3414);
    const double t3724 = t3719 + (t926 * t3440) + (t587 * t3527) + (t185 * t3594) - t2381 - (t1242 *
        t2342);
    const double t3729 = t3724 - (t1283 * t3647) - (t2177 * t2561) - (t2158 * t2662) - (t2702 *
        t3644) - (motion->constants[31] * t3420);
    const double t3734 = t3729 - (motion->constants[30] * t3426) - (t930 * t3447) - (t583 * t3517) -
        (t175 * t3578) - (t48 * t3600);
    const double t3736 = t7 * t2331;
    const double t3737 = motion->constants[47] * t2173;
    const double t3739 = t2637 * t3737;
    const double t3741 = (motion->constants[30] * t3737) + t3739 - t3475;
    const double t3743 = t12 * t2331;
    const double t3745 = motion->constants[48] * t2173;
    const double t3747 = t1302 * t1306;
    const double t3748 = t2166 + t3747;
    const double t3750 = t1302 * t1302;
    const double t3751 = t1310 * t1310;
    const double t3752 = t3750 + t3751;
    const double t3756 = t1339 + t3747;
    const double t3758 = (sin_delta * t3752) + (cos_delta * t3756);
    const double t3762 = (sin_delta * t3756) - (cos_delta * t3752);
    const double t3764 = t1306 * t1310;
    const double t3774 = (t1242 * t3743) + (t2594 * t3748) + (t1354 * t2747) + (t2773 * t3758) +
        (t2795 * t3762) + (t2948 * t3764);
    const double t3779 = t3774 + (t12 * t3594) - t3736 - (t1231 * t3741) - (t1282 * t3745) -
        (t2455 * t3752);
    const double t3782 = t3779 - (t12 * t3420) - (t7 * t3426) - (t7 * t3600);
    const double t3786 = motion->constants[19] - t237;
    const double t3790 = (motion->constants[2] * t3786) + (motion->constants[3] *
        motion->constants[20]);
    const double t3791 = motion->constants[18] * t3790;
    const double t3792 = t3791 + t3791;
    const double t3793 = t1374 * t1379;
    const double t3794 = t2406 * t3793;
    const double t3796 = t1370 * t1374;
    const double t3797 = t2414 * t3796;
    const double t3799 = t3794 + t3797 - (t1282 * t2304);
    const double t3803 = (motion->constants[3] * t3786) - (motion->constants[2] *
        motion->constants[20]);
    const double t3804 = motion->constants[18] * t3803;
    const double t3805 = t3796 - t2285;
    const double t3807 = t1370 * t1370;
    const double t3808 = t1379 * t1379;
    const double t3809 = t3807 - t3808;
    const double t3811 = t2287 + t3793;
    const double t3814 = (t2406 * t3805) + (t1282 * t3809) + (t2414 * t3811);
    const double t3816 = t1370 * t1379;
    const double t3817 = t1282 * t3816;
    const double t3820 = t3794 + t3817 + (t2285 * t2414);
    const double t3822 = t1374 * t1374;
    const double t3823 = t3808 + t3822;
    const double t3825 = t2637 * t3823;
    const double t3826 = (motion->constants[30] * t3823) + t3825;
    const double t3831 = t2304 + t3816;
    const double t3836 = (t2280 * t2414) + (t2433 * t3805) + (t2450 * t3831) - (t1231 * t3826) -
        (t1282 * t2295);
    const double t3840 = (t3792 * t3799) + (t3804 * t3814) + (motion->constants[18] * t3836) -
        (t3792 * t3820);
    const double t3842 = t3804 + t3804;
    const double t3845 = t3817 + (t2287 * t2406) - t3797;
    const double t3849 = t3816 - t2304;
    const double t3851 = t2637 * t3849;
    const double t3852 = (motion->constants[30] * t3849) + t3851;
    const double t3857 = t3807 + t3822;
    const double t3862 = (t1231 * t3852) + (t2280 * t2406) + (t1282 * t2299) + (t2433 * t3811) -
        (t2450 * t3857);
    const double t3866 = (t3842 * t3845) + (t3799 * t3842) + (t3791 * t3814) +
        (motion->constants[18] * t3862);
    const double t3868 = (motion->constants[2] * t3840) + (motion->constants[3] * t3866);
    const double t3871 = t1302 * t1310;
    const double t3872 = t3871 - t2161;
    const double t3874 = t2173 + t3764;
    const double t3876 = t3764 - t1354;
    const double t3878 = t1342 + t3871;
    const double t3880 = (cos_delta * t3878) - (sin_delta * t3876);
    const double t3884 = (cos_delta * t3876) + (sin_delta * t3878);
    const double t3886 = t1306 * t1306;
    const double t3887 = t3750 + t3886;
    const double t3893 = (t7 * t3594) + (t12 * t3600);
    const double t3898 = t3743 + (t1242 * t3736) + (t2594 * t3872) + (t2455 * t3874) + (t2773 *
        t3880) + (t2795 * t3884);
    const double t3903 = t3898 + (t12 * t3426) + t3893 - (t1231 * t2352) - (t2948 * t3887) - (t7 *
        t3420);
    const double t3906 = (motion->constants[3] * t3782) + (motion->constants[2] * t3903) - t3868;
    const double t3908 = (t155 * t3734) + t3906 - (t58 * t3630);
    const double t3916 = (t12 * t1908) - 1.0;
    const double t3920 = (t107 * t1908) + (sin_delta * t1906);
    const double t3924 = (t1908 * t2428) - (t1906 * t2424);
    const double t3928 = (t1908 * t2445) - (t1906 * t2441);
    const double t3933 = (t2435 * t3928) - (t1929 * t2408) - (t1202 * t3916) - (t2410 * t3920) -
        (t2416 * t3924);
    const double t3936 = (t1908 * t2463) - (cos_theta * t1906);
    const double t3940 = (t1908 * t2478) + (t1906 * t2487);
    const double t3944 = (t1908 * t2494) - (t1906 * t2503);
    const double t3948 = (t1908 * t2509) + (t1120 * t1906);
    const double t3952 = (t1908 * t2516) - (t1081 * t1906);
    const double t3956 = (t1908 * t2523) - (t1906 * t2529);
    const double t3959 = (motion->constants[54] * t3948) + (motion->constants[24] * t3956) -
        (motion->constants[55] * t3952);
    const double t3963 = (t2457 * t3936) + (t2492 * t3944) - (t2469 * t3940) - (t1081 * t3959);
    const double t3965 = t3933 + t3963 - (t1906 * t2403);
    const double t3967 = motion->constants[48] * t1929;
    const double t3975 = (t2551 * t3936) + (t2469 * t3944) + (t1120 * t3959) - (t2553 * t3940);
    const double t3977 = t3967 + (t1906 * t2547) + t3975;
    const double t3989 = (t2575 * t3936) + (t2577 * t3940) + (t2579 * t3944) + (cos_theta * t3959);
    const double t3999 = (t1134 * t3916) + (t2408 * t3920) + (t2435 * t3924) + (t2416 * t3928) -
        (t1929 * t2410);
    const double t4005 = (motion->constants[59] * t3948) + (motion->constants[57] * t3952) +
        (motion->constants[54] * t3956);
    const double t4011 = (motion->constants[58] * t3936) + (motion->constants[54] * t3940) +
        (motion->constants[55] * t3944);
    const double t4017 = (motion->constants[57] * t3948) + (motion->constants[56] * t3952) -
        (motion->constants[55] * t3956);
    const double t4023 = (motion->constants[53] * t3916) + (t1908 * t2569) +
        (motion->constants[48] * t3924) + (motion->constants[30] * t3999) + (t1098 * t4005) +
        (t1120 * t4011);
    const double t4026 = t4023 + (t1075 * t4017) - (motion->constants[51] * t3920) -
        (motion->constants[32] * t3989);
    const double t4039 = (motion->constants[49] * t3928) - t1947 - (motion->constants[52] * t1929) -
        (t1906 * t2639);
    const double t4045 = (motion->constants[51] * t3916) - (motion->constants[50] * t3920) -
        (motion->constants[49] * t3924);
    const double t4051 = (t1908 * t2629) + (t1075 * t4005) + (t1071 * t4017) + (cos_delta * t4045) -
        (motion->constants[33] * t3989) - (motion->constants[31] * t3999);
    const double t4053 = t4051 - (t1081 * t4011) - (sin_delta * t4039);
    const double t4072 = (motion->constants[32] * t3975) + (motion->constants[33] * t3963) +
        (motion->constants[31] * t3933) + (cos_theta * t4011) + (t1081 * t4017) + (cos_delta *
        t4039);
    const double t4076 = t4072 + (sin_delta * t4045) - (t1929 * t2636) - (t1906 * t2677) - (t1120 *
        t4005);
    const double t4082 = (t2664 * t3965) + (t2666 * t3977) + (t16 * t4053) - (t13 * t4026) -
        (sin_phi * t4076);
    const double t4091 = t4076 + (t486 * t4082) - (t1930 * t2715) - (t1910 * t3965) - (t2637 *
        t3977);
    const double t4097 = (t2744 * t4091) - (t1930 * t2741) - (t2739 * t4082);
    const double t4103 = (t2766 * t4082) + (t2770 * t4091) - (t1930 * t2767);
    const double t4109 = (t1930 * t2789) + (t2792 * t4091) - (t2787 * t4082);
    const double t4112 = t2810 * t4103;
    const double t4115 = t4112 - (t2806 * t4097) - (t2812 * t4109);
    const double t4138 = t3967 + t4097 + (t1906 * t2945);
    const double t4151 = (t2954 * t3936) + (t2957 * t3952) + (t1679 * t3956) + (t1598 * t4011) -
        (t2950 * t3948) - (t2959 * t3940);
    const double t4152 = t4151 - (t2962 * t3944);
    const double t4165 = (t2973 * t3948) + (t2977 * t3936) + (t2950 * t3952) + (t1666 * t3956) +
        (t2983 * t3944) - (t2980 * t3940);
    const double t4166 = t4165 - (t1606 * t4011);
    const double t4179 = (t2994 * t3948) + (t2997 * t3952) + (t2999 * t3940) + (t3001 * t3956) +
        (t1606 * t4017) - (t3003 * t3944);
    const double t4180 = t4179 - (t1598 * t4005);
    const double t4186 = (t1908 * t2825) + (t2854 * t3916) + (t2873 * t3924) + (t2878 * t3928) +
        (t2883 * t3963) + (t1334 * t3999);
    const double t4191 = t4186 + (t2886 * t3933) + (t297 * t4026) + (t2903 * t4097) + (t2925 *
        t4103) + (t2938 * t4109);
    const double t4196 = t4191 + (t2941 * t4115) + (t2943 * t4138) + (t1075 * t4152) + (t1071 *
        t4166) - (t1906 * t2845);
    const double t4201 = t4196 - (t1929 * t2859) - (t2866 * t3920) - (t2880 * t3975) - (t1538 *
        t3989) - (t2888 * t4039);
    const double t4203 = t4201 - (t2890 * t4045) - (t1081 * t4180);
    const double t4227 = (t3108 * t4103) + (t3111 * t4109) - (t3103 * t4097);
    const double t4236 = (t1722 * t3924) + (t1549 * t3989) + (t3076 * t3963) + (t1332 * t3999) +
        (t3082 * t4097) + (t3089 * t4103);
    const double t4241 = t4236 + (t3097 * t4109) + (t3099 * t4115) + (t3101 * t4138) + (t297 *
        t4227) + (t1098 * t4152);
    const double t4246 = t4241 + (t1075 * t4166) + (t1120 * t4180) - (t2864 * t3916) - (t1929 *
        t3065) - (t3068 * t3920);
    const double t4251 = t4246 - (t1906 * t3058) - (t1908 * t3061) - (t3071 * t3928) - (t3073 *
        t3975) - (t3079 * t3933);
    const double t4252 = t4251 - (t297 * t4053);
    const double t4262 = t4112 + (t3146 * t3916) + (t3148 * t3920) - (t1408 * t4097) - (t1411 *
        t4109);
    const double t4264 = (speeds[3] * t4262) - (t1930 * t3144);
    const double t4270 = (t779 * t4262) - (t775 * t2313) - (t1930 * t3160);
    const double t4277 = t3989 + t3999 + (t1908 * t3181);
    const double t4293 = (t7 * t3965) + (t107 * t4109) - (t12 * t3977) - (t12 * t4097) - (t1279 *
        t4103);
    const double t4322 = (t1908 * t3252) + (t1906 * t3266) + (t3270 * t3916) + (t3280 * t3924) +
        (t3284 * t3928) + (t3288 * t3989);
    const double t4327 = t4322 + (t3290 * t3963) + (t3292 * t3999) + (t2888 * t4045) + (t3300 *
        t4097) + (t3308 * t4103);
    const double t4332 = t4327 + (t3316 * t4109) + (t3318 * t4115) + (t1081 * t4166) + (cos_theta *
        t4180) - (t1929 * t3272);
    const double t4337 = t4332 - (t3276 * t3920) - (t3286 * t3975) - (t3294 * t3933) - (t2890 *
        t4039) - (t3320 * t4138);
    const double t4338 = t4337 - (t1120 * t4152);
    const double t4346 = (t3168 * t3965) + (t3170 * t3977) + (t3188 * t4026) + (t3201 * t4097) +
        (t3220 * t4103) + (t3226 * t4109);
    const double t4351 = t4346 + (t3230 * t4293) + (t3192 * t4227) + (t16 * t4203) - (t3177 *
        t4277) - (t3190 * t4076);
    const double t4354 = t4351 - (t3192 * t4053) - (sin_phi * t4338) - (t13 * t4252);
    const double t4358 = (t2132 * t4082) + (speeds[3] * t4354) + (t797 * t4264);
    const double t4365 = t3506 + (t2138 * t4082) + (speeds[1] * t4354) + (t796 * t4270);
    const double t4384 = (t3381 * t4277) + (t3383 * t4026) + (t2138 * t4076) + (t3392 * t4103) +
        (t3395 * t4109) + (t3397 * t4293);
    const double t4389 = t4384 + (t3386 * t4227) + (speeds[1] * t4338) + (t486 * t4365) - t3500 -
        (t3377 * t3965);
    const double t4392 = t4389 - (t3379 * t3977) - (t3386 * t4053) - (t804 * t4270);
    const double t4398 = (t489 * t4365) + (t74 * t4392) - (t809 * t4270);
    const double t4404 = (t818 * t4270) + (t497 * t4365) + (t77 * t4392);
    const double t4411 = (speeds[0] * t4262) - (t1930 * t3432);
    const double t4415 = (t828 * t4264) + (t513 * t4270) + (t831 * t4411) - (t1930 * t3428);
    const double t4421 = (t135 * t4270) + (t840 * t4411) - (t1930 * t3442);
    const double t4431 = (t2144 * t4082) + (speeds[0] * t4354) + (t797 * t4411);
    const double t4436 = (t3449 * t4082) + (t506 * t4358) + (t514 * t4365) + (t517 * t4431) -
        (t1930 * t3450);
    const double t4444 = (t3519 * t4082) + (t525 * t4365) + (t527 * t4431) - (t1930 * t3520);
    const double t4466 = (t3537 * t4277) + (t3539 * t4026) + (t2144 * t4076) + (t3544 * t4103) +
        (t3546 * t4109) + (t3548 * t4293);
    const double t4471 = t4466 + (t3542 * t4227) + (speeds[0] * t4338) + (t486 * t4431) - (t3533 *
        t3965) - (t3535 * t3977);
    const double t4473 = t4471 - (t3542 * t4053) - (t859 * t4411);
    const double t4483 = (t855 * t4270) + (t531 * t4365) + (t98 * t4392) + (t53 * t4473) + (t547 *
        t4421) + (t537 * t4444);
    const double t4485 = t4483 - (t117 * t4415) - (t36 * t4436);
    const double t4498 = t4398 + (t36 * t4415) + (t547 * t4444) - (t3580 * t4091) - (t137 * t4392) -
        (t142 * t4473);
    const double t4500 = t4498 - (t537 * t4421) - (t117 * t4436);
    const double t4506 = (t817 * t4270) + (t496 * t4365) - (sin_phi * t4485);
    const double t4512 = (t1906 * t2357) + (t1908 * t2381) + (t2158 * t4026) + (t2144 * t4053) +
        (t2397 * t4082) + (t2712 * t4091);
    const double t4517 = t4512 + (t2765 * t4103) + (t2785 * t4109) + (t2805 * t4115) + (speeds[0] *
        t4203) + (t777 * t4264);
    const double t4522 = t4517 + (t792 * t4270) + (t444 * t4358) + (t479 * t4365) + (t65 * t4392) +
        (motion->constants[31] * t4404);
    const double t4527 = t4522 + (t827 * t4415) + (t524 * t4444) + (t114 * t4500) +
        (motion->constants[39] * t4506) - (t1930 * t2400);
    const double t4532 = t4527 - (t2177 * t3965) - (t1512 * t3977) - (t2737 * t4097) - (t1304 *
        t4252) - (motion->constants[30] * t4398);
    const double t4535 = t4532 - (t838 * t4421) - (t504 * t4436) - (t97 * t4485);
    const double t4571 = (t1906 * t3632) + (t1512 * t3965) + (t2144 * t4026) + (t3661 * t4091) +
        (t3666 * t4097) + (t3672 * t4103);
    const double t4576 = t4571 + (t3678 * t4109) + (t3686 * t4115) + (t1331 * t4227) + (t1304 *
        t4203) + (speeds[0] * t4252);
    const double t4581 = t4576 + (t909 * t4264) + (t917 * t4270) + (t568 * t4358) + (t576 * t4365) +
        (t156 * t4392);
    const double t4586 = t4581 + (t926 * t4415) + (t587 * t4444) + (t185 * t4500) - (t1908 *
        t2342) - (t1930 * t3647);
    const double t4591 = t4586 - (t2177 * t3977) - (t2158 * t4053) - (t3644 * t4082) -
        (motion->constants[31] * t4398) - (motion->constants[30] * t4404);
    const double t4595 = t4591 - (t930 * t4421) - (t583 * t4436) - (t175 * t4485) - (t48 * t4506);
    const double t4615 = (t1908 * t3743) + (t3748 * t3999) + (t1354 * t4097) + (t3758 * t4103) +
        (t3762 * t4109) + (t3764 * t4138);
    const double t4620 = t4615 + (t12 * t4500) - (t1906 * t3741) - (t1929 * t3745) - (t3752 *
        t3933) - (t12 * t4398);
    const double t4622 = t4620 - (t7 * t4404) - (t7 * t4506);
    const double t4624 = t3793 * t3916;
    const double t4626 = t3796 * t3920;
    const double t4628 = t4624 + t4626 - (t1929 * t2304);
    const double t4634 = (t3805 * t3916) + (t1929 * t3809) + (t3811 * t3920);
    const double t4636 = t1929 * t3816;
    const double t4639 = t4624 + t4636 + (t2285 * t3920);
    const double t4649 = (t2280 * t3920) + (t3805 * t3924) + (t3831 * t3928) - (t1906 * t3826) -
        (t1929 * t2295);
    const double t4653 = (t3792 * t4628) + (t3804 * t4634) + (motion->constants[18] * t4649) -
        (t3792 * t4639);
    const double t4657 = t4636 + (t2287 * t3916) - t4626;
    const double t4669 = (t1906 * t3852) + (t2280 * t3916) + (t1929 * t2299) + (t3811 * t3924) -
        (t3857 * t3928);
    const double t4673 = (t3842 * t4657) + (t3842 * t4628) + (t3791 * t4634) +
        (motion->constants[18] * t4669);
    const double t4675 = (motion->constants[2] * t4653) + (motion->constants[3] * t4673);
    const double t4687 = (t7 * t4500) + (t12 * t4506);
    const double t4692 = (t1908 * t3736) + (t3872 * t3999) + (t3874 * t3933) + (t3880 * t4103) +
        (t3884 * t4109) + (t12 * t4404);
    const double t4696 = t4692 + t4687 - (t1906 * t2352) - (t3887 * t4138) - (t7 * t4398);
    const double t4699 = (motion->constants[3] * t4622) + (motion->constants[2] * t4696) - t4675;
    const double t4702 = (t155 * t4595) + t4699 - (t58 * t4535) - (t1940 * t3908);
    const double t4706 = (motion->constants[3] * motion->constants[55]) - (motion->constants[2] *
        motion->constants[54]);
    const double t4707 = t1081 * t4706;
    const double t4709 = t1120 * t4706;
    const double t4711 = cos_theta * t4706;
    const double t4713 = t1992 + (motion->constants[32] * t4711);
    const double t4716 = t1998 + (motion->constants[33] * t4711);
    const double t4724 = (motion->constants[32] * t4709) - t1983 - (motion->constants[33] * t4707);
    const double t4730 = (t2666 * t4709) + (t13 * t4713) - (t2664 * t4707) - (sin_phi * t4724) -
        (t16 * t4716);
    const double t4737 = t4724 + (t1910 * t4707) + (t486 * t4730) - (t2637 * t4709);
    const double t4741 = (t2744 * t4737) - (t2739 * t4730);
    const double t4745 = (t2766 * t4730) + (t2770 * t4737);
    const double t4749 = (t2792 * t4737) - (t2787 * t4730);
    const double t4752 = t2810 * t4745;
    const double t4755 = t4752 - (t2806 * t4741) - (t2812 * t4749);
    const double t4764 = (motion->constants[2] * t2950) - (motion->constants[3] * t2957);
    const double t4768 = (motion->constants[2] * t2973) + (motion->constants[3] * t2950);
    const double t4776 = (t1598 * motion->constants[77]) - (motion->constants[2] * t2994) -
        (motion->constants[3] * t2997) - (t1606 * motion->constants[76]);
    const double t4786 = (t2943 * t4741) + (t1075 * t4764) + (t2903 * t4741) + (t2925 * t4745) +
        (t2938 * t4749) + (t2941 * t4755);
    const double t4791 = t4786 - (t2880 * t4709) - (t1538 * t4711) - (t2883 * t4707) - (t297 *
        t4713) - (t1071 * t4768);
    const double t4792 = t4791 - (t1081 * t4776);
    const double t4810 = (t3111 * t4749) + (t3108 * t4745) - (t3103 * t4741);
    const double t4816 = (t1549 * t4711) + (t297 * t4716) + (t3089 * t4745) + (t3099 * t4755) +
        (t1098 * t4764) + (t1120 * t4776);
    const double t4821 = t4816 + (t3082 * t4741) + (t3097 * t4749) + (t3101 * t4741) + (t297 *
        t4810) - (t3073 * t4709);
    const double t4823 = t4821 - (t3076 * t4707) - (t1075 * t4768);
    const double t4828 = t4752 - (t1408 * t4741) - (t1411 * t4749);
    const double t4829 = speeds[3] * t4828;
    const double t4831 = t779 * t4828;
    const double t4846 = (t107 * t4749) - (t7 * t4707) - (t12 * t4709) - (t12 * t4741) - (t1279 *
        t4745);
    const double t4869 = (t3288 * t4711) + (cos_theta * t4776) + (t3300 * t4741) + (t3308 * t4745) +
        (t3316 * t4749) + (t3318 * t4755);
    const double t4874 = t4869 - (t3286 * t4709) - (t3290 * t4707) - (t3320 * t4741) - (t1120 *
        t4764) - (t1081 * t4768);
    const double t4882 = (t3192 * t4716) + (t3230 * t4846) + (t3170 * t4709) + (t3201 * t4741) +
        (t3220 * t4745) + (t3226 * t4749);
    const double t4887 = t4882 + (t3192 * t4810) + (t16 * t4792) - (t3177 * t4711) - (t3188 *
        t4713) - (t3190 * t4724);
    const double t4890 = t4887 - (t3168 * t4707) - (sin_phi * t4874) - (t13 * t4823);
    const double t4894 = (t2132 * t4730) + (speeds[3] * t4890) + (t797 * t4829);
    const double t4900 = (t2138 * t4730) + (speeds[1] * t4890) + (t796 * t4831);
    const double t4919 = (t3377 * t4707) + (t3381 * t4711) + (t2138 * t4724) + (t3386 * t4716) +
        (t3392 * t4745) + (t3395 * t4749);
    const double t4924 = t4919 + (t3397 * t4846) + (t3386 * t4810) + (speeds[1] * t4874) + (t486 *
        t4900) - (t3379 * t4709);
    const double t4926 = t4924 - (t3383 * t4713) - (t804 * t4831);
    const double t4932 = (t489 * t4900) + (t74 * t4926) - (t809 * t4831);
    const double t4938 = (t818 * t4831) + (t497 * t4900) + (t77 * t4926);
    const double t4942 = speeds[0] * t4828;
    const double t4945 = (t828 * t4829) + (t513 * t4831) + (t831 * t4942);
    const double t4949 = (t135 * t4831) + (t840 * t4942);
    const double t4958 = (t2144 * t4730) + (speeds[0] * t4890) + (t797 * t4942);
    const double t4962 = (t3449 * t4730) + (t506 * t4894) + (t514 * t4900) + (t517 * t4958);
    const double t4968 = (t3519 * t4730) + (t525 * t4900) + (t527 * t4958);
    const double t4990 = (t3533 * t4707) + (t3537 * t4711) + (t2144 * t4724) + (t3542 * t4716) +
        (t3544 * t4745) + (t3546 * t4749);
    const double t4995 = t4990 + (t3548 * t4846) + (t3542 * t4810) + (speeds[0] * t4874) + (t486 *
        t4958) - (t3535 * t4709);
    const double t4997 = t4995 - (t3539 * t4713) - (t859 * t4942);
    const double t5007 = (t855 * t4831) + (t531 * t4900) + (t98 * t4926) + (t53 * t4997) + (t547 *
        t4949) + (t537 * t4968);
    const double t5009 = t5007 - (t117 * t4945) - (t36 * t4962);
    const double t5022 = t4932 + (t36 * t4945) + (t547 * t4968) - (t3580 * t4737) - (t137 * t4926) -
        (t142 * t4997);
    const double t5024 = t5022 - (t537 * t4949) - (t117 * t4962);
    const double t5030 = (t817 * t4831) + (t496 * t4900) - (sin_phi * t5009);
    const double t5036 = (t2177 * t4707) + (t2397 * t4730) + (t2712 * t4737) + (t2765 * t4745) +
        (t2785 * t4749) + (t2805 * t4755);
    const double t5041 = t5036 + (speeds[0] * t4792) + (t777 * t4829) + (t792 * t4831) + (t444 *
        t4894) + (t479 * t4900);
    const double t5046 = t5041 + (t65 * t4926) + (motion->constants[31] * t4938) + (t827 * t4945) +
        (t524 * t4968) + (t114 * t5024);
    const double t5051 = t5046 + (motion->constants[39] * t5030) - (t1512 * t4709) - (t2158 *
        t4713) - (t2144 * t4716) - (t2737 * t4741);
    const double t5056 = t5051 - (t1304 * t4823) - (motion->constants[30] * t4932) - (t838 *
        t4949) - (t504 * t4962) - (t97 * t5009);
    const double t5089 = (t2158 * t4716) + (t3661 * t4737) + (t3666 * t4741) + (t3672 * t4745) +
        (t3678 * t4749) + (t3686 * t4755);
    const double t5094 = t5089 + (t1331 * t4810) + (t1304 * t4792) + (speeds[0] * t4823) + (t909 *
        t4829) + (t917 * t4831);
    const double t5099 = t5094 + (t568 * t4894) + (t576 * t4900) + (t156 * t4926) + (t926 * t4945) +
        (t587 * t4968);
    const double t5104 = t5099 + (t185 * t5024) - (t1512 * t4707) - (t2177 * t4709) - (t2144 *
        t4713) - (t3644 * t4730);
    const double t5109 = t5104 - (motion->constants[31] * t4932) - (motion->constants[30] * t4938) -
        (t930 * t4949) - (t583 * t4962) - (t175 * t5009);
    const double t5110 = t5109 - (t48 * t5030);
    const double t5121 = (t7 * t5024) + (t12 * t5030);
    const double t5126 = (t3880 * t4745) + (t3884 * t4749) + (t12 * t4938) + t5121 - (t3887 *
        t4741) - (t7 * t4932);
    const double t5140 = (t1354 * t4741) + (t3758 * t4745) + (t3762 * t4749) + (t3764 * t4741) +
        (t12 * t5024) - (t12 * t4932);
    const double t5142 = t5140 - (t7 * t4938) - (t7 * t5030);
    const double t5144 = (motion->constants[2] * t5126) + (motion->constants[3] * t5142);
    const double t5148 = (t155 * t5110) + t5144 - (t58 * t5056) - (t2012 * t3908) - (t2016 * t4702);
    const double t5155 = t12 * t2043;
    const double t5159 = (sin_delta * t2041) - (t107 * t2043);
    const double t5164 = (t2041 * t2424) + (t2043 * t2428) - t2423;
    const double t5169 = t2440 + (t2041 * t2441) + (t2043 * t2445);
    const double t5174 = (t2064 * t2408) + (t2410 * t5159) + (t2435 * t5169) - (t1202 * t5155) -
        (t2416 * t5164);
    const double t5177 = (t2043 * t2463) + (cos_theta * t2041);
    const double t5182 = t2485 + (t2041 * t2487) - (t2043 * t2478);
    const double t5187 = t2501 + (t2043 * t2494) + (t2041 * t2503);
    const double t5191 = (t2043 * t2509) - (t1120 * t2041);
    const double t5195 = (t2043 * t2516) + (t1081 * t2041);
    const double t5200 = t2527 + (t2043 * t2523) + (t2041 * t2529);
    const double t5203 = (motion->constants[54] * t5191) + (motion->constants[24] * t5200) -
        (motion->constants[55] * t5195);
    const double t5207 = (t2457 * t5177) + (t2469 * t5182) + (t2492 * t5187) - (t1081 * t5203);
    const double t5210 = t2402 + (t2041 * t2403) + t5174 + t5207;
    const double t5212 = motion->constants[48] * t2064;
    const double t5220 = (t2551 * t5177) + (t2553 * t5182) + (t2469 * t5187) + (t1120 * t5203);
    const double t5223 = t5212 + (t2041 * t2547) - t2546 - t5220;
    const double t5235 = (t2575 * t5177) + (t2579 * t5187) + (cos_theta * t5203) - (t2577 * t5182);
    const double t5245 = (t2064 * t2410) + (t1134 * t5155) + (t2435 * t5164) + (t2416 * t5169) -
        (t2408 * t5159);
    const double t5251 = (motion->constants[59] * t5191) + (motion->constants[57] * t5195) +
        (motion->constants[54] * t5200);
    const double t5257 = (motion->constants[58] * t5177) + (motion->constants[55] * t5187) -
        (motion->constants[54] * t5182);
    const double t5263 = (motion->constants[57] * t5191) + (motion->constants[56] * t5195) -
        (motion->constants[55] * t5200);
    const double t5269 = (motion->constants[53] * t5155) + (motion->constants[51] * t5159) +
        (t2043 * t2569) + (motion->constants[48] * t5164) + (motion->constants[30] * t5245) +
        (t1098 * t5251);
    const double t5272 = t5269 + (t1120 * t5257) + (t1075 * t5263) - (motion->constants[32] *
        t5235);
    const double t5286 = (motion->constants[52] * t2064) + (t2041 * t2639) +
        (motion->constants[49] * t5169) - t2114 - t2638;
    const double t5292 = (motion->constants[51] * t5155) + (motion->constants[50] * t5159) -
        (motion->constants[49] * t5164);
    const double t5298 = (t2043 * t2629) + (t1075 * t5251) + (t1071 * t5263) + (cos_delta * t5292) -
        (motion->constants[33] * t5235) - (motion->constants[31] * t5245);
    const double t5300 = t5298 - (t1081 * t5257) - (sin_delta * t5286);
    const double t5319 = t2675 + (t2064 * t2636) + (t2041 * t2677) + (motion->constants[32] *
        t5220) + (motion->constants[33] * t5207) + (motion->constants[31] * t5174);
    const double t5324 = t5319 + (cos_theta * t5257) + (t1081 * t5263) + (cos_delta * t5286) +
        (sin_delta * t5292) - motion->constants[27];
    const double t5325 = t5324 - (t1120 * t5251);
    const double t5331 = (t2664 * t5210) + (t16 * t5300) - (t2666 * t5223) - (t13 * t5272) -
        (sin_phi * t5325);
    const double t5340 = t5325 + (t2637 * t5223) + (t486 * t5331) - (t2065 * t2715) - (t1910 *
        t5210);
    const double t5346 = (t2744 * t5340) - (t2065 * t2741) - (t2739 * t5331);
    const double t5352 = (t2766 * t5331) + (t2770 * t5340) - (t2065 * t2767);
    const double t5358 = (t2065 * t2789) + (t2792 * t5340) - (t2787 * t5331);
    const double t5361 = t2810 * t5352;
    const double t5364 = t5361 - (t2806 * t5346) - (t2812 * t5358);
    const double t5388 = t2944 + t5346 - t5212 - (t2041 * t2945);
    const double t5401 = (t2954 * t5177) + (t2957 * t5195) + (t2959 * t5182) + (t1679 * t5200) +
        (t1598 * t5257) - (t2950 * t5191);
    const double t5402 = t5401 - (t2962 * t5187);
    const double t5415 = (t2973 * t5191) + (t2977 * t5177) + (t2950 * t5195) + (t2980 * t5182) +
        (t1666 * t5200) + (t2983 * t5187);
    const double t5416 = t5415 - (t1606 * t5257);
    const double t5429 = (t2994 * t5191) + (t2997 * t5195) + (t3001 * t5200) + (t1606 * t5263) -
        (t2999 * t5182) - (t3003 * t5187);
    const double t5430 = t5429 - (t1598 * t5251);
    const double t5436 = t2841 + (t2043 * t2825) + (t2041 * t2845) + (t2854 * t5155) + (t2064 *
        t2859) + (t2866 * t5159);
    const double t5441 = t5436 + (t2873 * t5164) + (t2878 * t5169) + (t2883 * t5207) + (t1334 *
        t5245) + (t2886 * t5174);
    const double t5446 = t5441 + (t297 * t5272) + (t2903 * t5346) + (t2925 * t5352) + (t2938 *
        t5358) + (t2941 * t5364);
    const double t5451 = t5446 + (t2943 * t5388) + (t1075 * t5402) + (t1071 * t5416) - (t2880 *
        t5220) - (t1538 * t5235);
    const double t5454 = t5451 - (t2888 * t5286) - (t2890 * t5292) - (t1081 * t5430);
    const double t5478 = (t3108 * t5352) + (t3111 * t5358) - (t3103 * t5346);
    const double t5487 = t3054 + (t2064 * t3065) + (t3068 * t5159) + (t2041 * t3058) + (t1722 *
        t5164) + (t1549 * t5235);
    const double t5492 = t5487 + (t3076 * t5207) + (t1332 * t5245) + (t3082 * t5346) + (t3089 *
        t5352) + (t3097 * t5358);
    const double t5497 = t5492 + (t3099 * t5364) + (t3101 * t5388) + (t297 * t5478) + (t1098 *
        t5402) + (t1075 * t5416);
    const double t5502 = t5497 + (t1120 * t5430) - (t2864 * t5155) - (t2043 * t3061) - (t3071 *
        t5169) - (t3073 * t5220);
    const double t5504 = t5502 - (t3079 * t5174) - (t297 * t5300);
    const double t5514 = t5361 + (t3146 * t5155) - (t3148 * t5159) - (t1408 * t5346) - (t1411 *
        t5358);
    const double t5517 = (speeds[3] * t5514) - t2313 - (t2065 * t3144);
    const double t5521 = (t779 * t5514) - (t2065 * t3160);
    const double t5528 = t5235 + t5245 + (t2043 * t3181);
    const double t5544 = (t7 * t5210) + (t12 * t5223) + (t107 * t5358) - (t12 * t5346) - (t1279 *
        t5352);
    const double t5573 = t3265 + (t2043 * t3252) + (t3270 * t5155) + (t2064 * t3272) + (t3276 *
        t5159) + (t3280 * t5164);
    const double t5578 = t5573 + (t3284 * t5169) + (t3288 * t5235) + (t3290 * t5207) + (t3292 *
        t5245) + (t2888 * t5292);
    const double t5583 = t5578 + (t3300 * t5346) + (t3308 * t5352) + (t3316 * t5358) + (t3318 *
        t5364) + (t1081 * t5416);
    const double t5588 = t5583 + (cos_theta * t5430) - (t2041 * t3266) - (t3286 * t5220) - (t3294 *
        t5174) - (t2890 * t5286);
    const double t5590 = t5588 - (t3320 * t5388) - (t1120 * t5402);
    const double t5598 = (t3168 * t5210) + (t3188 * t5272) + (t3201 * t5346) + (t3220 * t5352) +
        (t3226 * t5358) + (t3230 * t5544);
    const double t5603 = t5598 + (t3192 * t5478) + (t16 * t5454) - (t3170 * t5223) - (t3177 *
        t5528) - (t3190 * t5325);
    const double t5606 = t5603 - (t3192 * t5300) - (sin_phi * t5590) - (t13 * t5504);
    const double t5611 = t3506 + (t2132 * t5331) + (speeds[3] * t5606) + (t797 * t5517);
    const double t5617 = (t2138 * t5331) + (speeds[1] * t5606) + (t796 * t5521);
    const double t5636 = (t3379 * t5223) + (t3381 * t5528) + (t3383 * t5272) + (t2138 * t5325) +
        (t3392 * t5352) + (t3395 * t5358);
    const double t5641 = t5636 + (t3397 * t5544) + (t3386 * t5478) + (speeds[1] * t5590) + (t486 *
        t5617) - (t3377 * t5210);
    const double t5643 = t5641 - (t3386 * t5300) - (t804 * t5521);
    const double t5649 = (t489 * t5617) + (t74 * t5643) - (t809 * t5521);
    const double t5655 = (t818 * t5521) + (t497 * t5617) + (t77 * t5643);
    const double t5662 = (speeds[0] * t5514) - (t2065 * t3432);
    const double t5666 = (t828 * t5517) + (t513 * t5521) + (t831 * t5662) - (t2065 * t3428);
    const double t5672 = (t135 * t5521) + (t840 * t5662) - (t2065 * t3442);
    const double t5682 = (t2144 * t5331) + (speeds[0] * t5606) + (t797 * t5662);
    const double t5687 = (t3449 * t5331) + (t506 * t5611) + (t514 * t5617) + (t517 * t5682) -
        (t2065 * t3450);
    const double t5695 = (t3519 * t5331) + (t525 * t5617) + (t527 * t5682) - (t2065 * t3520);
    const double t5717 = (t3535 * t5223) + (t3537 * t5528) + (t3539 * t5272) + (t2144 * t5325) +
        (t3544 * t5352) + (t3546 * t5358);
    const double t5722 = t5717 + (t3548 * t5544) + (t3542 * t5478) + (speeds[0] * t5590) + (t486 *
        t5682) - (t3533 * t5210);
    const double t5724 = t5722 - (t3542 * t5300) - (t859 * t5662);
    const double t5734 = (t855 * t5521) + (t531 * t5617) + (t98 * t5643) + (t53 * t5724) + (t547 *
        t5672) + (t537 * t5695);
    const double t5736 = t5734 - (t117 * t5666) - (t36 * t5687);
    const double t5749 = t5649 + (t36 * t5666) + (t547 * t5695) - (t3580 * t5340) - (t137 * t5643) -
        (t142 * t5724);
    const double t5751 = t5749 - (t537 * t5672) - (t117 * t5687);
    const double t5757 = (t817 * t5521) + (t496 * t5617) - (sin_phi * t5736);
    const double t5763 = t2357 + (t2043 * t2381) + (t1512 * t5223) + (t2158 * t5272) + (t2144 *
        t5300) + (t2397 * t5331);
    const double t5768 = t5763 + (t2712 * t5340) + (t2765 * t5352) + (t2785 * t5358) + (t2805 *
        t5364) + (speeds[0] * t5454);
    const double t5773 = t5768 + (t777 * t5517) + (t792 * t5521) + (t444 * t5611) + (t479 * t5617) +
        (t65 * t5643);
    const double t5778 = t5773 + (motion->constants[31] * t5655) + (t827 * t5666) + (t524 * t5695) +
        (t114 * t5751) + (motion->constants[39] * t5757);
    const double t5783 = t5778 - (t2041 * t2357) - (t2065 * t2400) - (t2177 * t5210) - (t2737 *
        t5346) - (t1304 * t5504);
    const double t5787 = t5783 - (motion->constants[30] * t5649) - (t838 * t5672) - (t504 * t5687) -
        (t97 * t5736);
    const double t5823 = t3632 + (t1512 * t5210) + (t2177 * t5223) + (t2144 * t5272) + (t3661 *
        t5340) + (t3666 * t5346);
    const double t5828 = t5823 + (t3672 * t5352) + (t3678 * t5358) + (t3686 * t5364) + (t1331 *
        t5478) + (t1304 * t5454);
    const double t5833 = t5828 + (speeds[0] * t5504) + (t909 * t5517) + (t917 * t5521) + (t568 *
        t5611) + (t576 * t5617);
    const double t5838 = t5833 + (t156 * t5643) + (t926 * t5666) + (t587 * t5695) + (t185 * t5751) -
        (t2041 * t3632);
    const double t5843 = t5838 - (t2043 * t2342) - (t2065 * t3647) - (t2158 * t5300) - (t3644 *
        t5331) - (motion->constants[31] * t5649);
    const double t5848 = t5843 - (motion->constants[30] * t5655) - (t930 * t5672) - (t583 * t5687) -
        (t175 * t5736) - (t48 * t5757);
    const double t5870 = (t2041 * t3741) + (t2043 * t3743) + (t2064 * t3745) + (t3748 * t5245) +
        (t1354 * t5346) + (t3758 * t5352);
    const double t5875 = t5870 + (t3762 * t5358) + (t3764 * t5388) + (t12 * t5751) - t3739 -
        (t3752 * t5174);
    const double t5878 = t5875 - (t12 * t5649) - (t7 * t5655) - (t7 * t5757);
    const double t5880 = t3793 * t5155;
    const double t5882 = t3796 * t5159;
    const double t5884 = t5880 + (t2064 * t2304) - t5882;
    const double t5890 = (t2064 * t3809) + (t3811 * t5159) - (t3805 * t5155);
    const double t5892 = t2064 * t3816;
    const double t5895 = t5892 + (t2285 * t5159) - t5880;
    const double t5906 = (t2041 * t3826) + (t2064 * t2295) + (t3805 * t5164) + (t3831 * t5169) -
        t3825 - (t2280 * t5159);
    const double t5910 = (t3792 * t5884) + (t3792 * t5895) + (motion->constants[18] * t5906) -
        (t3804 * t5890);
    const double t5914 = t5882 + (t2287 * t5155) - t5892;
    const double t5927 = t3851 + (t2280 * t5155) + (t3811 * t5164) - (t2041 * t3852) - (t2064 *
        t2299) - (t3857 * t5169);
    const double t5931 = (t3842 * t5914) + (t3842 * t5884) + (motion->constants[18] * t5927) -
        (t3791 * t5890);
    const double t5933 = (motion->constants[2] * t5910) + (motion->constants[3] * t5931);
    const double t5945 = (t7 * t5751) + (t12 * t5757);
    const double t5950 = (t2041 * t2352) + (t2043 * t3736) + (t3872 * t5245) + (t3874 * t5174) +
        (t3880 * t5352) + (t3884 * t5358);
    const double t5954 = t5950 + (t12 * t5655) + t5945 - (t3887 * t5388) - (t7 * t5649);
    const double t5957 = (motion->constants[3] * t5878) + (motion->constants[2] * t5954) - t5933;
    const double t5962 = (t155 * t5848) + (t2094 * t5148) + t5957 - (t58 * t5787) - (t2072 *
        t3908) - (t2088 * t4702);
    const double t5963 = t2131 * t5962;
    const double t5965 = (t2024 * t5148) + (t2094 * t5963);
    const double t5969 = (t1958 * t4702) - (t2016 * t5965) - (t2088 * t5963);
    const double t5975 = (t1295 * t3908) - (t1940 * t5969) - (t2012 * t5965) - (t2072 * t5963);
    const double t5977 = t3796 - t1387;
    const double t5979 = t1434 + t3816;
    const double t5982 = motion->constants[38] * motion->constants[29];
    const double t5983 = t5982 + t5982;
    const double t5985 = motion->constants[37] * motion->constants[29];
    const double t5993 = t3893 + (t2773 * t5977) + (t2795 * t5979) + (t3799 * t5983) + (t3814 *
        t5985) + (t3836 * motion->constants[29]);
    const double t5995 = t5993 - (t2747 * t3823) - (t3820 * t5983);
    const double t5997 = t3816 - t1434;
    const double t5999 = t1339 + t3793;
    const double t6002 = t5985 + t5985;
    const double t6016 = (t2747 * t5997) + (t2773 * t5999) + (t3845 * t6002) + (t3799 * t6002) +
        (t3814 * t5982) + (t3862 * motion->constants[29]);
    const double t6021 = t6016 + (t971 * t3163) + (t622 * t3374) + (t28 * t3578) + (t89 * t3594) -
        (t2795 * t3857);
    const double t6022 = t6021 - (t107 * t3600);
    const double t6029 = t3906 + (t228 * t3734) - (motion->constants[2] * t5995) -
        (motion->constants[3] * t6022) - (t226 * t3630);
    const double t6042 = t4687 + (t4103 * t5977) + (t4109 * t5979) + (t4628 * t5983) + (t4634 *
        t5985) + (t4649 * motion->constants[29]);
    const double t6044 = t6042 - (t3823 * t4097) - (t4639 * t5983);
    const double t6062 = (t4097 * t5997) + (t4103 * t5999) + (t4657 * t6002) + (t4628 * t6002) +
        (t4634 * t5982) + (t4669 * motion->constants[29]);
    const double t6067 = t6062 + (t971 * t4270) + (t622 * t4365) + (t28 * t4485) + (t89 * t4500) -
        (t3857 * t4109);
    const double t6068 = t6067 - (t107 * t4506);
    const double t6077 = t4699 + (t228 * t4595) - (motion->constants[2] * t6044) -
        (motion->constants[3] * t6068) - (t226 * t4535) - (t1940 * t6029);
    const double t6084 = t5121 + (t4745 * t5977) + (t4749 * t5979) - (t3823 * t4741);
    const double t6098 = (t4741 * t5997) + (t4745 * t5999) + (t971 * t4831) + (t622 * t4900) +
        (t28 * t5009) + (t89 * t5024);
    const double t6100 = t6098 - (t3857 * t4749) - (t107 * t5030);
    const double t6110 = t5144 + (t228 * t5110) - (motion->constants[2] * t6084) -
        (motion->constants[3] * t6100) - (t226 * t5056) - (t2012 * t6029);
    const double t6111 = t6110 - (t2016 * t6077);
    const double t6124 = t5945 + (t5352 * t5977) + (t5358 * t5979) + (t5884 * t5983) + (t5895 *
        t5983) + (t5906 * motion->constants[29]);
    const double t6126 = t6124 - (t3823 * t5346) - (t5890 * t5985);
    const double t6144 = (t5346 * t5997) + (t5352 * t5999) + (t5914 * t6002) + (t5884 * t6002) +
        (t5927 * motion->constants[29]) + (t971 * t5521);
    const double t6149 = t6144 + (t622 * t5617) + (t28 * t5736) + (t89 * t5751) - (t3857 * t5358) -
        (t5890 * t5982);
    const double t6150 = t6149 - (t107 * t5757);
    const double t6161 = t5957 + (t228 * t5848) + (t2094 * t6111) - (motion->constants[2] * t6126) -
        (motion->constants[3] * t6150) - (t226 * t5787);
    const double t6164 = t2131 * (t6161 - (t2072 * t6029) - (t2088 * t6077));
    const double t6166 = (t2024 * t6111) + (t2094 * t6164);
    const double t6170 = (t1958 * t6077) - (t2016 * t6166) - (t2088 * t6164);
    const double t6176 = (t1295 * t6029) - (t1940 * t6170) - (t2012 * t6166) - (t2072 * t6164);
    const double t6177 = sin_theta * t2241;
    const double t6178 = motion->constants[3] * t1068;
    const double t6183 = t1068 * (motion->constants[3] + motion->constants[3]);
    const double t6185 = motion->constants[2] * t1068;
    const double t6189 = (motion->constants[3] * ((t2248 * t6178) - t6177)) -
        (motion->constants[2] * ((t2218 * t6183) + (t2248 * t6185)));
    const double t6192 = t1068 * (motion->constants[2] + motion->constants[2]);
    const double t6200 = (motion->constants[3] * ((t2248 * t6192) + (t2218 * t6178))) -
        (motion->constants[2] * (t6177 + (t2218 * t6185)));
    const double t6204 = (t1120 * t2253) + (t1081 * t2265);
    const double t6207 = sin_theta * t2260;
    const double t6209 = t2265 * t6192;
    const double t6213 = (motion->constants[33] * t2265) + (motion->constants[32] * t2253);
    const double t6220 = t2253 * t6183;
    const double t6232 = (t12 * t2265) + (t7 * t2253);
    const double t6244 = motion->constants[7] * ((motion->constants[3] * ((t7 * t6209) + (t6178 *
        t6232) - (t12 * t6207))) - (motion->constants[2] * ((t12 * t6220) + (t7 * t6207) + (t6185 *
        t6232))));
    const double t6245 = (motion->constants[3] * ((sin_theta * t2218) + (motion->constants[32] *
        t6209) + (t6178 * t6213) - (motion->constants[33] * t6207))) - (motion->constants[2] *
        ((motion->constants[33] * t6220) + (motion->constants[32] * t6207) + (t6185 * t6213) -
        (sin_theta * t2248)));
    const double t6246 = t6245 - t6244;
    const double t6252 = (t12 * t6200) + (t2477 * t6204) - (t7 * t6189);
    const double t6254 = sin_theta * t2187;
    const double t6256 = t2193 * t6192;
    const double t6260 = (motion->constants[55] * t2193) - (motion->constants[54] * t2181);
    const double t6265 = t2181 * t6183;
    const double t6272 = (motion->constants[3] * ((motion->constants[55] * t6254) + (t6178 *
        t6260) - (motion->constants[54] * t6256))) - (motion->constants[2] *
        ((motion->constants[55] * t6265) + (motion->constants[54] * t6254) + (t6185 * t6260)));
    const double t6275 = motion->constants[24] * t2181;
    const double t6279 = motion->constants[24] * t6254;
    const double t6283 = (motion->constants[3] * ((motion->constants[24] * t6256) + (t6178 *
        t6275))) - (motion->constants[2] * ((t6185 * t6275) - t6279));
    const double t6285 = motion->constants[24] * t2193;
    const double t6293 = (motion->constants[3] * (t6279 + (t6178 * t6285))) -
        (motion->constants[2] * ((motion->constants[24] * t6265) + (t6185 * t6285)));
    const double t6297 = (t1120 * t2181) + (t1081 * t2193);
    const double t6305 = t1578 + (sin_theta * t2173);
    const double t6309 = (motion->constants[3] * (t2134 + (t2166 * t6192) + (t2161 * t6178))) -
        (motion->constants[2] * ((t2161 * t6185) - t6305));
    const double t6319 = (motion->constants[3] * ((speeds[2] * t1601) + (sin_theta * t2161))) +
        (motion->constants[2] * ((speeds[2] * t1609) + (sin_theta * t2166)));
    const double t6329 = (motion->constants[3] * (t6305 + (t2166 * t6178))) -
        (motion->constants[2] * (t2134 + (t2161 * t6183) + (t2166 * t6185)));
    const double t6334 = motion->constants[3] * motion->constants[22];
    const double t6335 = (motion->constants[2] * motion->constants[21]) + t6334;
    const double t6338 = motion->constants[2] * motion->constants[22];
    const double t6341 = t6338 + (motion->constants[3] * motion->constants[23]);
    const double t6344 = (motion->constants[3] * (t6335 + t6335)) - (motion->constants[2] * (t6341 +
        t6341));
    const double t6346 = t1601 * t1609;
    const double t6347 = t2467 * t6346;
    const double t6348 = t1577 * t1609;
    const double t6349 = t2520 * t6348;
    const double t6351 = (t2214 * t2513) + t6349 - t6347;
    const double t6354 = (motion->constants[3] * motion->constants[21]) - t6338;
    const double t6358 = t6334 - (motion->constants[2] * motion->constants[23]);
    const double t6361 = (motion->constants[3] * (t6354 - t6341)) - (motion->constants[2] * (t6335 +
        t6358));
    const double t6362 = t6348 - t2205;
    const double t6364 = t1609 * t1609;
    const double t6365 = t1601 * t1601;
    const double t6366 = t6364 - t6365;
    const double t6368 = t1577 * t1601;
    const double t6369 = t2214 + t6368;
    const double t6372 = (t2467 * t6366) + (t2520 * t6369) - (t2513 * t6362);
    const double t6378 = (motion->constants[3] * (t6358 + t6358)) + (motion->constants[2] * (t6354 +
        t6354));
    const double t6379 = t2513 * t6368;
    const double t6382 = t6347 + (t2205 * t2520) - t6379;
    const double t6388 = motion->constants[26] - motion->constants[4];
    const double t6390 = (motion->constants[3] * motion->constants[25]) - (motion->constants[2] *
        t6388);
    const double t6393 = t1577 * t1577;
    const double t6394 = t6365 + t6393;
    const double t6395 = motion->constants[24] * t6394;
    const double t6397 = motion->constants[24] * t6362;
    const double t6399 = t2237 + t6346;
    const double t6400 = motion->constants[24] * t6399;
    const double t6402 = motion->constants[55] + motion->constants[55];
    const double t6405 = t6379 + (t2237 * t2467) - t6349;
    const double t6413 = (t2250 * t2467) + (t2490 * t6395) + (t2532 * t6397) + (t2506 * t6400) +
        (t6402 * t6405) + (t6382 * t6402);
    const double t6415 = t6413 - (t2255 * t2520) - (motion->constants[54] * t6372);
    const double t6419 = (motion->constants[2] * motion->constants[25]) + (motion->constants[3] *
        t6388);
    const double t6422 = t6346 - t2237;
    const double t6423 = motion->constants[24] * t6422;
    const double t6425 = motion->constants[24] * t6369;
    const double t6427 = t6364 + t6393;
    const double t6428 = motion->constants[24] * t6427;
    const double t6430 = motion->constants[54] + motion->constants[54];
    const double t6438 = (t2255 * t2513) + (t2532 * t6425) + (t6351 * t6430) + (t6405 * t6430) -
        (t2262 * t2467) - (t2490 * t6423);
    const double t6440 = t6438 - (t2506 * t6428) - (motion->constants[55] * t6372);
    const double t6445 = motion->constants[3] * motion->constants[16];
    const double t6446 = (motion->constants[2] * motion->constants[15]) + t6445;
    const double t6449 = motion->constants[2] * motion->constants[16];
    const double t6452 = t6449 + (motion->constants[3] * motion->constants[17]);
    const double t6455 = (motion->constants[3] * (t6446 + t6446)) - (motion->constants[2] * (t6452 +
        t6452));
    const double t6458 = (motion->constants[3] * motion->constants[15]) - t6449;
    const double t6462 = t6445 - (motion->constants[2] * motion->constants[17]);
    const double t6465 = (motion->constants[3] * (t6458 - t6452)) - (motion->constants[2] * (t6446 +
        t6462));
    const double t6471 = (motion->constants[3] * (t6462 + t6462)) + (motion->constants[2] * (t6458 +
        t6458));
    const double t6478 = motion->constants[3] * motion->constants[10];
    const double t6479 = (motion->constants[2] * motion->constants[9]) + t6478;
    const double t6482 = motion->constants[2] * motion->constants[10];
    const double t6485 = t6482 + (motion->constants[3] * motion->constants[11]);
    const double t6488 = (motion->constants[3] * (t6479 + t6479)) - (motion->constants[2] * (t6485 +
        t6485));
    const double t6489 = t12 * t3871;
    const double t6491 = t1231 * t3764;
    const double t6492 = t7 * t3871;
    const double t6494 = (t12 * t2166) - t6492;
    const double t6498 = t6491 + (t1242 * t6494) - t6489 - (t7 * t2166);
    const double t6501 = t6478 - (motion->constants[2] * motion->constants[11]);
    const double t6505 = (motion->constants[3] * motion->constants[9]) - t6482;
    const double t6508 = (motion->constants[3] * (t6501 + t6501)) + (motion->constants[2] * (t6505 +
        t6505));
    const double t6510 = t7 * t3747;
    const double t6512 = t12 * t3747;
    const double t6513 = (t7 * t2161) + t6512;
    const double t6517 = t6510 - t6491 - (t12 * t2161) - (t1242 * t6513);
    const double t6523 = (motion->constants[3] * (t6505 - t6485)) - (motion->constants[2] * (t6479 +
        t6501));
    const double t6526 = t3751 - t3886;
    const double t6530 = (t7 * t3748) + (t12 * t3872);
    const double t6534 = (t12 * t3748) + (t1231 * t6526) + (t1242 * t6530) - (t7 * t3872);
    const double t6539 = motion->constants[7] + motion->constants[14];
    const double t6541 = (motion->constants[3] * motion->constants[13]) - (motion->constants[2] *
        t6539);
    const double t6543 = motion->constants[7] * t3872;
    const double t6545 = t2148 * motion->constants[12];
    const double t6546 = t12 * t6545;
    const double t6550 = (t12 * t3874) - (t7 * t3887);
    const double t6551 = motion->constants[7] * motion->constants[12];
    const double t6552 = t6550 * t6551;
    const double t6553 = (t2179 * motion->constants[12]) - t6552;
    const double t6555 = t7 * t6545;
    const double t6557 = motion->constants[41] + motion->constants[41];
    const double t6560 = t6492 + t6512;
    const double t6564 = t6489 + (t1242 * t6560) - t6510 - (t1231 * t2173);
    const double t6571 = (t6517 * t6557) + (t6557 * t6564) + (motion->constants[40] * t6534) -
        (motion->constants[12] * t6543) - t6546 - (t1231 * t6553);
    const double t6572 = t6571 - (t1242 * t6555);
    const double t6576 = (motion->constants[2] * motion->constants[13]) + (motion->constants[3] *
        t6539);
    const double t6577 = motion->constants[7] * t3748;
    const double t6581 = t2173 - t3764;
    const double t6583 = (t12 * t3752) + (t7 * t6581);
    const double t6584 = t6551 * t6583;
    const double t6585 = (t2191 * motion->constants[12]) + t6584;
    const double t6588 = motion->constants[40] + motion->constants[40];
    const double t6596 = t6555 + (t6498 * t6588) + (t6564 * t6588) + (motion->constants[41] *
        t6534) - (motion->constants[12] * t6577) - (t1231 * t6585);
    const double t6597 = t6596 - (t1242 * t6546);
    const double t6604 = sin_theta * t1302;
    const double t6608 = (motion->constants[3] * (speeds[2] + (t1310 * t6192) + (t1306 * t6178))) -
        (motion->constants[2] * ((t1306 * t6185) - t6604));
    const double t6618 = (motion->constants[3] * (t6604 + (t1310 * t6178))) -
        (motion->constants[2] * (speeds[2] + (t1306 * t6183) + (t1310 * t6185)));
    const double t6622 = (t1120 * t1306) + (t1081 * t1310);
    const double t6626 = t12 * t2268;
    const double t6628 = t7 * t2268;
    const double t6637 = t6626 + (t1242 * t6628) + (t2584 * t3872) + (t2539 * t3874) - (t1231 *
        t2349) - (t2559 * t3887);
    const double t6648 = t6628 + (t2559 * t6581) + (t2539 * t3752) - (t1231 * t3467) - (t1242 *
        t6626) - (t2584 * t3748);
    const double t6658 = (t2473 * t6204) + (t1242 * t6252) + (t2467 * t6272) + (t2506 * t6293) +
        (t2600 * t6309) + (t2612 * t6329);
    const double t6663 = t6658 + (t6344 * t6351) + (t6361 * t6372) + (t6390 * t6415) + (t3845 *
        t6455) + (t3820 * t6471);
    const double t6668 = t6663 + (t3803 * t3840) + (t6488 * t6498) + (t6541 * t6572) + (t2970 *
        t6608) + (t2991 * t6618);
    const double t6673 = t6668 + (motion->constants[37] * t5995) + (t241 * t6022) +
        (motion->constants[33] * t6648) + (motion->constants[30] * t3903) + (t286 * t3734);
    const double t6678 = t6673 - (t12 * t6189) - (t7 * t6200) - (t1231 * t6246) - (t2490 * t6283) -
        (t2535 * t6297);
    const double t6683 = t6678 - (t2606 * t6319) - (t6378 * t6382) - (t6419 * t6440) - (t3814 *
        t6465) - (t3790 * t3866);
    const double t6688 = t6683 - (t6508 * t6517) - (t6523 * t6534) - (t6576 * t6597) - (t3012 *
        t6622) - (motion->constants[32] * t6637);
    const double t6690 = t6688 - (motion->constants[31] * t3782) - (t283 * t3630);
    const double t6702 = t3936 * t6346;
    const double t6703 = t3952 * t6348;
    const double t6705 = (t2214 * t3948) + t6703 - t6702;
    const double t6711 = (t3936 * t6366) + (t3952 * t6369) - (t3948 * t6362);
    const double t6713 = t3948 * t6368;
    const double t6716 = t6702 + (t2205 * t3952) - t6713;
    const double t6725 = t6713 + (t2237 * t3936) - t6703;
    const double t6733 = (t2250 * t3936) + (t3940 * t6395) + (t3956 * t6397) + (t3944 * t6400) +
        (t6402 * t6725) + (t6402 * t6716);
    const double t6735 = t6733 - (t2255 * t3952) - (motion->constants[54] * t6711);
    const double t6749 = (t2255 * t3948) + (t3956 * t6425) + (t6430 * t6705) + (t6430 * t6725) -
        (t2262 * t3936) - (t3940 * t6423);
    const double t6751 = t6749 - (t3944 * t6428) - (motion->constants[55] * t6711);
    const double t6758 = t1906 * t3764;
    const double t6760 = t6758 + (t1908 * t6494);
    const double t6763 = t6758 + (t1908 * t6513);
    const double t6767 = (t1906 * t6526) + (t1908 * t6530);
    const double t6774 = (t1908 * t6560) - (t1906 * t2173);
    const double t6780 = (t6557 * t6774) + (motion->constants[40] * t6767) - (t1906 * t6553) -
        (t1908 * t6555) - (t6557 * t6763);
    const double t6790 = (t6588 * t6760) + (t6588 * t6774) + (motion->constants[41] * t6767) -
        (t1906 * t6585) - (t1908 * t6546);
    const double t6805 = (t1908 * t6628) + (t3872 * t3989) + (t3874 * t3963) - (t1906 * t2349) -
        (t3887 * t3975);
    const double t6815 = (t3975 * t6581) + (t3752 * t3963) - (t1906 * t3467) - (t1908 * t6626) -
        (t3748 * t3989);
    const double t6826 = (t1908 * t6252) + (t3936 * t6272) + (t3944 * t6293) + (t4005 * t6309) +
        (t4017 * t6329) + (t6344 * t6705);
    const double t6831 = t6826 + (t6361 * t6711) + (t6390 * t6735) + (t4657 * t6455) + (t4639 *
        t6471) + (t3803 * t4653);
    const double t6836 = t6831 + (t6488 * t6760) + (t6508 * t6763) + (t6541 * t6780) + (t4152 *
        t6608) + (t4166 * t6618);
    const double t6841 = t6836 + (motion->constants[37] * t6044) + (t241 * t6068) +
        (motion->constants[33] * t6815) + (motion->constants[30] * t4696) + (t286 * t4595);
    const double t6846 = t6841 - (t1906 * t6246) - (t3940 * t6283) - (t3959 * t6297) - (t4011 *
        t6319) - (t6378 * t6716);
    const double t6851 = t6846 - (t6419 * t6751) - (t4634 * t6465) - (t3790 * t4673) - (t6523 *
        t6767) - (t6576 * t6790);
    const double t6856 = t6851 - (t4180 * t6622) - (motion->constants[32] * t6805) -
        (motion->constants[31] * t4622) - (t283 * t4535) - (t1940 * t6690);
    const double t6864 = motion->constants[3] * t6348;
    const double t6865 = (motion->constants[2] * t2214) + t6864;
    const double t6869 = (motion->constants[3] * t6369) - (motion->constants[2] * t6362);
    const double t6871 = motion->constants[2] * t6368;
    const double t6873 = t6871 - (motion->constants[3] * t2205);
    const double t6876 = t6864 - t6871;
    const double t6882 = (motion->constants[3] * t2255) + (t6402 * t6876) + (motion->constants[54] *
        t6869) + (t6402 * t6873);
    const double t6890 = (t6430 * t6876) + (motion->constants[55] * t6869) - (motion->constants[2] *
        t2255) - (t6430 * t6865);
    const double t6901 = (t3872 * t4711) - (t3887 * t4709) - (t3874 * t4707);
    const double t6907 = (t4709 * t6581) - (t3748 * t4711) - (t3752 * t4707);
    const double t6919 = (motion->constants[2] * t2218) + (t6390 * t6882) + (t4764 * t6608) +
        (motion->constants[37] * t6084) + (t241 * t6100) + (motion->constants[33] * t6907);
    const double t6924 = t6919 + (motion->constants[30] * t5126) + (t286 * t5110) -
        (motion->constants[3] * t2248) - (t4706 * t6297) - (motion->constants[77] * t6309);
    const double t6929 = t6924 - (motion->constants[76] * t6329) - (t6344 * t6865) - (t6361 *
        t6869) - (t6378 * t6873) - (t6419 * t6890);
    const double t6934 = t6929 - (t4768 * t6618) - (t4776 * t6622) - (motion->constants[32] *
        t6901) - (motion->constants[31] * t5142) - (t283 * t5056);
    const double t6936 = t6934 - (t2012 * t6690) - (t2016 * t6856);
    const double t6948 = t5177 * t6346;
    const double t6949 = t5195 * t6348;
    const double t6951 = (t2214 * t5191) + t6949 - t6948;
    const double t6957 = (t5177 * t6366) + (t5195 * t6369) - (t5191 * t6362);
    const double t6959 = t5191 * t6368;
    const double t6962 = t6948 + (t2205 * t5195) - t6959;
    const double t6971 = t6959 + (t2237 * t5177) - t6949;
    const double t6979 = (t2250 * t5177) + (t5200 * t6397) + (t5187 * t6400) + (t6402 * t6971) +
        (t6402 * t6962) - (t2255 * t5195);
    const double t6981 = t6979 - (t5182 * t6395) - (motion->constants[54] * t6957);
    const double t6995 = (t2255 * t5191) + (t5182 * t6423) + (t5200 * t6425) + (t6430 * t6951) +
        (t6430 * t6971) - (t2262 * t5177);
    const double t6997 = t6995 - (t5187 * t6428) - (motion->constants[55] * t6957);
    const double t7004 = t2041 * t3764;
    const double t7006 = (t2043 * t6494) - t7004;
    const double t7009 = t7004 - (t2043 * t6513);
    const double t7013 = (t2041 * t6526) - (t2043 * t6530);
    const double t7020 = (t2041 * t2173) + (t2043 * t6560);
    const double t7027 = t6552 + (t2041 * t6553) + (t6557 * t7009) + (t6557 * t7020) - (t2043 *
        t6555) - (motion->constants[40] * t7013);
    const double t7038 = (t2041 * t6585) + (t6588 * t7006) + (t6588 * t7020) - t6584 - (t2043 *
        t6546) - (motion->constants[41] * t7013);
    const double t7053 = (t2041 * t2349) + (t2043 * t6628) + (t3872 * t5235) + (t3874 * t5207) -
        (t3887 * t5220);
    const double t7063 = (t2041 * t3467) + (t5220 * t6581) + (t3752 * t5207) - (t2043 * t6626) -
        (t3748 * t5235);
    const double t7076 = t6244 + (t2041 * t6246) + (t2043 * t6252) + (t5177 * t6272) + (t5182 *
        t6283) + (t5187 * t6293);
    const double t7081 = t7076 + (t5251 * t6309) + (t5263 * t6329) + (t6344 * t6951) + (t6361 *
        t6957) + (t6390 * t6981);
    const double t7086 = t7081 + (t5914 * t6455) + (t5890 * t6465) + (t3803 * t5910) + (t6488 *
        t7006) + (t6523 * t7013);
    const double t7091 = t7086 + (t6541 * t7027) + (t5402 * t6608) + (t5416 * t6618) +
        (motion->constants[37] * t6126) + (t241 * t6150);
    const double t7096 = t7091 + (motion->constants[33] * t7063) + (motion->constants[30] * t5954) +
        (t286 * t5848) + (t2094 * t6936) - (t5203 * t6297);
    const double t7101 = t7096 - (t5257 * t6319) - (t6378 * t6962) - (t6419 * t6997) - (t5895 *
        t6471) - (t3790 * t5931);
    const double t7106 = t7101 - (t6508 * t7009) - (t6576 * t7038) - (t5430 * t6622) -
        (motion->constants[32] * t7053) - (motion->constants[31] * t5878);
    const double t7110 = t2131 * (t7106 - (t283 * t5787) - (t2072 * t6690) - (t2088 * t6856));
    const double t7112 = (t2024 * t6936) + (t2094 * t7110);
    const double t7116 = (t1958 * t6856) - (t2016 * t7112) - (t2088 * t7110);
    const double t7122 = (t1295 * t6690) - (t1940 * t7116) - (t2012 * t7112) - (t2072 * t7110);
    const double t7127 = (t16 * t2541) + (sin_phi * t3186) - (t13 * t2561);
    const double t7135 = (t16 * t3965) - (t13 * t3977) - (sin_phi * t4277) - (t1940 * t7127);
    const double t7145 = (t16 * t4707) + (t13 * t4709) + (sin_phi * t4711) + (t2012 * t7127) +
        (t2016 * t7135);
    const double t7157 = (t16 * t5210) + (t13 * t5223) - (sin_phi * t5528) - (t2072 * t7127) -
        (t2088 * t7135) - (t2094 * t7145);
    const double t7158 = t2131 * t7157;
    const double t7160 = (t2094 * t7158) - (t2024 * t7145);
    const double t7164 = (t1958 * t7135) - (t2016 * t7160) - (t2088 * t7158);
    const double t7170 = (t1295 * t7127) - (t1940 * t7164) - (t2012 * t7160) - (t2072 * t7158);
    const double t7175 = t2175 - t1354;
    const double t7176 = t12 * t7175;
    const double t7178 = t7 * t7175;
    const double t7180 = t1301 * t1304;
    const double t7181 = t7180 - t2145;
    const double t7183 = t1354 + t1354;
    const double t7184 = t7 * t7183;
    const double t7186 = t12 * t7183;
    const double t7188 = t1324 - t7180;
    const double t7190 = (cos_delta * t7188) - (sin_delta * t7186);
    const double t7194 = (cos_delta * t7186) + (sin_delta * t7188);
    const double t7198 = (t1301 * t1362) - (speeds[0] * speeds[0]);
    const double t7213 = (motion->constants[3] * t6572) - (motion->constants[2] * t6597);
    const double t7216 = (motion->constants[3] * t6637) + (motion->constants[2] * t6648);
    const double t7221 = (motion->constants[44] * t2148) + (motion->constants[41] * t2161) +
        (t1231 * t3485) + (t3186 * t7181) + (t2747 * t7184) + (t2773 * t7190);
    const double t7226 = t7221 + (t2795 * t7194) + (t3239 * t7198) + (t999 * t3157) + (t446 *
        t3368) + (t64 * t3566);
    const double t7231 = t7226 + (t1004 * t3447) + (t651 * t3527) + (motion->constants[3] * t3903) +
        (t310 * t3734) + t7213;
    const double t7237 = t7231 + t7216 - t1806 - t2268 - t2331 - (motion->constants[40] * t2166) -
        (t2541 * t7176);
    const double t7242 = t7237 - (t2561 * t7178) - (t547 * t3440) - (t537 * t3517) -
        (motion->constants[2] * t3782) - (t308 * t3630);
    const double t7266 = (motion->constants[3] * t6780) - (motion->constants[2] * t6790);
    const double t7269 = (motion->constants[3] * t6805) + (motion->constants[2] * t6815);
    const double t7274 = (t1906 * t3485) + (t4097 * t7184) + (t4103 * t7190) + (t4109 * t7194) +
        (t4293 * t7198) + (t999 * t4264);
    const double t7279 = t7274 + (t446 * t4358) + (t64 * t4473) + (t1004 * t4421) + (t651 * t4444) +
        (motion->constants[3] * t4696);
    const double t7284 = t7279 + (t310 * t4595) + t7266 + t7269 - (t3965 * t7176) - (t3977 * t7178);
    const double t7289 = t7284 - (t4277 * t7181) - (t547 * t4415) - (t537 * t4436) -
        (motion->constants[2] * t4622) - (t308 * t4535);
    const double t7290 = t7289 - (t1940 * t7242);
    const double t7314 = (motion->constants[3] * t6901) + (motion->constants[2] * t6907);
    const double t7319 = (t4707 * t7176) + (t4741 * t7184) + (t4745 * t7190) + (t4749 * t7194) +
        (t4846 * t7198) + (t999 * t4829);
    const double t7324 = t7319 + (t446 * t4894) + (t64 * t4997) + (t1004 * t4949) + (t651 * t4968) +
        (motion->constants[3] * t5126);
    const double t7329 = t7324 + (t310 * t5110) + t7314 - (t4709 * t7178) - (t4711 * t7181) -
        (t547 * t4945);
    const double t7334 = t7329 - (t537 * t4962) - (motion->constants[2] * t5142) - (t308 * t5056) -
        (t2012 * t7242) - (t2016 * t7290);
    const double t7360 = (motion->constants[3] * t7027) - (motion->constants[2] * t7038);
    const double t7363 = (motion->constants[3] * t7053) + (motion->constants[2] * t7063);
    const double t7368 = t3485 + (t5223 * t7178) + (t5346 * t7184) + (t5352 * t7190) + (t5358 *
        t7194) + (t5544 * t7198);
    const double t7373 = t7368 + (t999 * t5517) + (t446 * t5611) + (t64 * t5724) + (t1004 * t5672) +
        (t651 * t5695);
    const double t7378 = t7373 + (motion->constants[3] * t5954) + (t310 * t5848) + (t2094 * t7334) +
        t7360 + t7363;
    const double t7383 = t7378 - (t2041 * t3485) - (t5210 * t7176) - (t5528 * t7181) - (t547 *
        t5666) - (t537 * t5687);
    const double t7388 = t2131 * (t7383 - (motion->constants[2] * t5878) - (t308 * t5787) - (t2072 *
        t7242) - (t2088 * t7290));
    const double t7390 = (t2024 * t7334) + (t2094 * t7388);
    const double t7394 = (t1958 * t7290) - (t2016 * t7390) - (t2088 * t7388);
    const double t7400 = (t1295 * t7242) - (t1940 * t7394) - (t2012 * t7390) - (t2072 * t7388);
    const double t7401 = motion->constants[7] * t2148;
    const double t7404 = (t12 * t2179) - (t7 * t2191);
    const double t7405 = motion->constants[7] * t7404;
    const double t7407 = t7401 + (t1231 * t7405);
    const double t7411 = (t1906 * t7405) - (t1940 * t7407);
    const double t7415 = (t2012 * t7407) + (t2016 * t7411);
    const double t7425 = t2131 * (t7405 - (t2041 * t7405) - (t2072 * t7407) - (t2088 * t7411) -
        (t2094 * t7415));
    const double t7427 = (t2094 * t7425) - (t2024 * t7415);
    const double t7431 = (t1958 * t7411) - (t2016 * t7427) - (t2088 * t7425);
    const double t7437 = (t1295 * t7407) - (t1940 * t7431) - (t2012 * t7427) - (t2072 * t7425);
    const double t7438 = t6498 + t6517;
    const double t7442 = t6760 - t6763 - (t1940 * t7438);
    const double t7446 = (t2012 * t7438) + (t2016 * t7442);
    const double t7455 = t2131 * (t7006 + t7009 - (t2072 * t7438) - (t2088 * t7442) - (t2094 *
        t7446));
    const double t7457 = (t2094 * t7455) - (t2024 * t7446);
    const double t7461 = (t1958 * t7442) - (t2016 * t7457) - (t2088 * t7455);
    const double t7467 = (t1295 * t7438) - (t1940 * t7461) - (t2012 * t7457) - (t2072 * t7455);
    const double t7468 = t1310 * t1315;
    const double t7470 = t1306 * t1315;
    const double t7475 = (t7 * t7468) + (t12 * t7470);
    const double t7479 = (t12 * t7468) + (t1242 * t7475) - (t7 * t7470) - (t1231 * t2175);
    const double t7485 = (t1908 * t7475) - (t1906 * t2175) - (t1940 * t7479);
    const double t7489 = (t2012 * t7479) + (t2016 * t7485);
    const double t7500 = (t2041 * t2175) + (t2043 * t7475) - t2175 - (t2072 * t7479) - (t2088 *
        t7485) - (t2094 * t7489);
    const double t7501 = t2131 * t7500;
    const double t7503 = (t2094 * t7501) - (t2024 * t7489);
    const double t7507 = (t1958 * t7485) - (t2016 * t7503) - (t2088 * t7501);
    const double t7513 = (t1295 * t7479) - (t1940 * t7507) - (t2012 * t7503) - (t2072 * t7501);
    const double t7516 = (motion->constants[2] * t6572) + (motion->constants[3] * t6597);
    const double t7522 = (motion->constants[2] * t6780) + (motion->constants[3] * t6790) - (t1940 *
        t7516);
    const double t7526 = (t2012 * t7516) + (t2016 * t7522);
    const double t7537 = t2131 * ((motion->constants[2] * t7027) + (motion->constants[3] * t7038) -
        (t2072 * t7516) - (t2088 * t7522) - (t2094 * t7526));
    const double t7539 = (t2094 * t7537) - (t2024 * t7526);
    const double t7543 = (t1958 * t7522) - (t2016 * t7539) - (t2088 * t7537);
    const double t7549 = (t1295 * t7516) - (t1940 * t7543) - (t2012 * t7539) - (t2072 * t7537);
    const double t7552 = t7266 - (t1940 * t7213);
    const double t7556 = (t2012 * t7213) + (t2016 * t7552);
    const double t7564 = t2131 * (t7360 - (t2072 * t7213) - (t2088 * t7552) - (t2094 * t7556));
    const double t7566 = (t2094 * t7564) - (t2024 * t7556);
    const double t7570 = (t1958 * t7552) - (t2016 * t7566) - (t2088 * t7564);
    const double t7576 = (t1295 * t7213) - (t1940 * t7570) - (t2012 * t7566) - (t2072 * t7564);
    const double t7579 = t2148 * t6576;
    const double t7581 = t2148 * t6541;
    const double t7589 = motion->constants[7] * (t7404 + (t6550 * t6576) - (t6541 * t6583));
    const double t7591 = (t2179 * t6576) + (t2191 * t6541) - t7589;
    const double t7595 = (t7 * t7579) + (t12 * t7581);
    const double t7597 = t6541 * t6541;
    const double t7599 = t6576 * t6576;
    const double t7601 = t7597 + t7599;
    const double t7603 = t6541 * t6576;
    const double t7609 = t7401 + (t7 * t7581) + (t6498 * t7597) + (t6517 * t7599) + (t6564 *
        t7601) + (t6534 * t7603);
    const double t7614 = t7609 - (t6543 * t6576) - (t6541 * t6577) - (t12 * t7579) - (t1231 *
        t7591) - (t1242 * t7595);
    const double t7627 = (t6760 * t7597) + (t6774 * t7601) + (t6767 * t7603) - (t1906 * t7591) -
        (t1908 * t7595) - (t6763 * t7599);
    const double t7628 = t7627 - (t1940 * t7614);
    const double t7632 = (t2012 * t7614) + (t2016 * t7628);
    const double t7647 = t7589 + (t2041 * t7591) + (t7006 * t7597) + (t7009 * t7599) + (t7020 *
        t7601) - (t2043 * t7595);
    const double t7652 = t2131 * (t7647 - (t7013 * t7603) - (t2072 * t7614) - (t2088 * t7628) -
        (t2094 * t7632));
    const double t7654 = (t2094 * t7652) - (t2024 * t7632);
    const double t7658 = (t1958 * t7628) - (t2016 * t7654) - (t2088 * t7652);
    const double t7664 = (t1295 * t7614) - (t1940 * t7658) - (t2012 * t7654) - (t2072 * t7652);
    const double t7667 = motion->constants[35] * t6534;
    const double t7669 = (motion->constants[36] * t6498) + (motion->constants[34] * t6517) - t7667;
    const double t7673 = motion->constants[35] * t6767;
    const double t7677 = (motion->constants[36] * t6760) - (motion->constants[34] * t6763) - t7673 -
        (t1940 * t7669);
    const double t7681 = (t2012 * t7669) + (t2016 * t7677);
    const double t7685 = motion->constants[35] * t7013;
    const double t7693 = (motion->constants[36] * t7006) + (motion->constants[34] * t7009) + t7685 -
        (t2072 * t7669) - (t2088 * t7677) - (t2094 * t7681);
    const double t7694 = t2131 * t7693;
    const double t7696 = (t2094 * t7694) - (t2024 * t7681);
    const double t7700 = (t1958 * t7677) - (t2016 * t7696) - (t2088 * t7694);
    const double t7706 = (t1295 * t7669) - (t1940 * t7700) - (t2012 * t7696) - (t2072 * t7694);
    const double t7709 = t6774 - (t1940 * t6564);
    const double t7713 = (t2012 * t6564) + (t2016 * t7709);
    const double t7721 = t2131 * (t7020 - (t2072 * t6564) - (t2088 * t7709) - (t2094 * t7713));
    const double t7723 = (t2094 * t7721) - (t2024 * t7713);
    const double t7727 = (t1958 * t7709) - (t2016 * t7723) - (t2088 * t7721);
    const double t7733 = (t1295 * t6564) - (t1940 * t7727) - (t2012 * t7723) - (t2072 * t7721);
    const double t7737 = t7667 + (motion->constants[34] * t6498) + (motion->constants[36] * t6517);
    const double t7744 = t7673 + (motion->constants[34] * t6760) - (motion->constants[36] * t6763) -
        (t1940 * t7737);
    const double t7748 = (t2012 * t7737) + (t2016 * t7744);
    const double t7759 = (motion->constants[34] * t7006) + (motion->constants[36] * t7009) - t7685 -
        (t2072 * t7737) - (t2088 * t7744) - (t2094 * t7748);
    const double t7760 = t2131 * t7759;
    const double t7762 = (t2094 * t7760) - (t2024 * t7748);
    const double t7766 = (t1958 * t7744) - (t2016 * t7762) - (t2088 * t7760);
    const double t7772 = (t1295 * t7737) - (t1940 * t7766) - (t2012 * t7762) - (t2072 * t7760);
    const double t7773 = motion->constants[35] + motion->constants[35];
    const double t7776 = motion->constants[34] - motion->constants[36];
    const double t7779 = (t6498 * t7773) - (t6517 * t7773) - (t6534 * t7776);
    const double t7787 = (t6760 * t7773) + (t6763 * t7773) - (t6767 * t7776) - (t1940 * t7779);
    const double t7791 = (t2012 * t7779) + (t2016 * t7787);
    const double t7803 = (t7006 * t7773) + (t7013 * t7776) - (t7009 * t7773) - (t2072 * t7779) -
        (t2088 * t7787) - (t2094 * t7791);
    const double t7804 = t2131 * t7803;
    const double t7806 = (t2094 * t7804) - (t2024 * t7791);
    const double t7810 = (t1958 * t7787) - (t2016 * t7806) - (t2088 * t7804);
    const double t7816 = (t1295 * t7779) - (t1940 * t7810) - (t2012 * t7806) - (t2072 * t7804);
    const double t7819 = t4675 - (t1940 * t3868);
    const double t7823 = (t2012 * t3868) + (t2016 * t7819);
    const double t7831 = t2131 * (t5933 - (t2072 * t3868) - (t2088 * t7819) - (t2094 * t7823));
    const double t7833 = (t2094 * t7831) - (t2024 * t7823);
    const double t7837 = (t1958 * t7819) - (t2016 * t7833) - (t2088 * t7831);
    const double t7843 = (t1295 * t3868) - (t1940 * t7837) - (t2012 * t7833) - (t2072 * t7831);
    const double t7846 = (motion->constants[3] * t3840) - (motion->constants[2] * t3866);
    const double t7852 = (motion->constants[3] * t4653) - (motion->constants[2] * t4673) - (t1940 *
        t7846);
    const double t7856 = (t2012 * t7846) + (t2016 * t7852);
    const double t7867 = t2131 * ((motion->constants[3] * t5910) - (motion->constants[2] * t5931) -
        (t2072 * t7846) - (t2088 * t7852) - (t2094 * t7856));
    const double t7869 = (t2094 * t7867) - (t2024 * t7856);
    const double t7873 = (t1958 * t7852) - (t2016 * t7869) - (t2088 * t7867);
    const double t7879 = (t1295 * t7846) - (t1940 * t7873) - (t2012 * t7869) - (t2072 * t7867);
    const double t7881 = t2299 * t2637;
    const double t7882 = (motion->constants[30] * t2299) + t7881;
    const double t7887 = (t1231 * t7882) + (t2280 * t2433) + (t2295 * t2450);
    const double t7888 = t3803 * t3803;
    const double t7890 = t3790 * t3790;
    const double t7891 = t7888 + t7890;
    const double t7893 = t3790 * t3803;
    const double t7902 = t7887 + (t3845 * t7888) + (t3799 * t7891) + (t3814 * t7893) + (t3790 *
        t3836) + (t3803 * t3862);
    const double t7903 = t7902 - (t3820 * t7890);
    const double t7909 = (t1906 * t7882) + (t2280 * t3924) + (t2295 * t3928);
    const double t7921 = t7909 + (t4657 * t7888) + (t4628 * t7891) + (t4634 * t7893) + (t3790 *
        t4649) + (t3803 * t4669);
    const double t7923 = t7921 - (t4639 * t7890) - (t1940 * t7903);
    const double t7927 = (t2012 * t7903) + (t2016 * t7923);
    const double t7934 = t7881 + (t2280 * t5164) + (t2295 * t5169) - (t2041 * t7882);
    const double t7948 = t7934 + (t5914 * t7888) + (t5884 * t7891) + (t5895 * t7890) + (t3790 *
        t5906) + (t3803 * t5927);
    const double t7953 = t2131 * (t7948 - (t5890 * t7893) - (t2072 * t7903) - (t2088 * t7923) -
        (t2094 * t7927));
    const double t7955 = (t2094 * t7953) - (t2024 * t7927);
    const double t7959 = (t1958 * t7923) - (t2016 * t7955) - (t2088 * t7953);
    const double t7965 = (t1295 * t7903) - (t1940 * t7959) - (t2012 * t7955) - (t2072 * t7953);
    const double t7967 = motion->constants[35] * t3814;
    const double t7970 = (motion->constants[36] * t3845) - t7967 - (motion->constants[34] * t3820);
    const double t7973 = motion->constants[35] * t4634;
    const double t7978 = (motion->constants[36] * t4657) - t7973 - (motion->constants[34] * t4639) -
        (t1940 * t7970);
    const double t7982 = (t2012 * t7970) + (t2016 * t7978);
    const double t7985 = motion->constants[35] * t5890;
    const double t7994 = (motion->constants[36] * t5914) + t7985 + (motion->constants[34] * t5895) -
        (t2072 * t7970) - (t2088 * t7978) - (t2094 * t7982);
    const double t7995 = t2131 * t7994;
    const double t7997 = (t2094 * t7995) - (t2024 * t7982);
    const double t8001 = (t1958 * t7978) - (t2016 * t7997) - (t2088 * t7995);
    const double t8007 = (t1295 * t7970) - (t1940 * t8001) - (t2012 * t7997) - (t2072 * t7995);
    const double t8010 = t4628 - (t1940 * t3799);
    const double t8014 = (t2012 * t3799) + (t2016 * t8010);
    const double t8022 = t2131 * (t5884 - (t2072 * t3799) - (t2088 * t8010) - (t2094 * t8014));
    const double t8024 = (t2094 * t8022) - (t2024 * t8014);
    const double t8028 = (t1958 * t8010) - (t2016 * t8024) - (t2088 * t8022);
    const double t8034 = (t1295 * t3799) - (t1940 * t8028) - (t2012 * t8024) - (t2072 * t8022);
    const double t8038 = t7967 + (motion->constants[34] * t3845) - (motion->constants[36] * t3820);
    const double t8045 = t7973 + (motion->constants[34] * t4657) - (motion->constants[36] * t4639) -
        (t1940 * t8038);
    const double t8049 = (t2012 * t8038) + (t2016 * t8045);
    const double t8060 = (motion->constants[34] * t5914) + (motion->constants[36] * t5895) - t7985 -
        (t2072 * t8038) - (t2088 * t8045) - (t2094 * t8049);
    const double t8061 = t2131 * t8060;
    const double t8063 = (t2094 * t8061) - (t2024 * t8049);
    const double t8067 = (t1958 * t8045) - (t2016 * t8063) - (t2088 * t8061);
    const double t8073 = (t1295 * t8038) - (t1940 * t8067) - (t2012 * t8063) - (t2072 * t8061);
    const double t8078 = (t3845 * t7773) + (t3820 * t7773) - (t3814 * t7776);
    const double t8086 = (t4657 * t7773) + (t4639 * t7773) - (t4634 * t7776) - (t1940 * t8078);
    const double t8090 = (t2012 * t8078) + (t2016 * t8086);
    const double t8102 = (t5914 * t7773) + (t5890 * t7776) - (t5895 * t7773) - (t2072 * t8078) -
        (t2088 * t8086) - (t2094 * t8090);
    const double t8103 = t2131 * t8102;
    const double t8105 = (t2094 * t8103) - (t2024 * t8090);
    const double t8109 = (t1958 * t8086) - (t2016 * t8105) - (t2088 * t8103);
    const double t8115 = (t1295 * t8078) - (t1940 * t8109) - (t2012 * t8105) - (t2072 * t8103);
    const double t8118 = (t1775 * t2383) + (t1030 * t3159);
    const double t8124 = (t1379 * t1441) - (t30 * t1434) - (t1407 * t1437);
    const double t8132 = (t30 * t1396) + (t1370 * t1407) + (t1379 * t1410) - (t27 * t1400);
    const double t8138 = (t27 * t1434) - (t1410 * t1437) - (t1370 * t1441);
    const double t8155 = (t1283 * t8118) + (t2747 * t8124) + (t2773 * t8132) + (t2795 * t8138) +
        (t1038 * t3163) + (t664 * t3374);
    const double t8160 = t8155 + (t319 * t3594) + (motion->constants[2] * t6022) + (t329 * t3734) -
        (t1031 * t3155) - (t1036 * t3157);
    const double t8164 = t8160 - (t1044 * t3436) - (t317 * t3578) - (motion->constants[3] * t5995) -
        (t327 * t3630);
    const double t8187 = (t1030 * t2313) + (t1930 * t8118) + (t4097 * t8124) + (t4103 * t8132) +
        (t4109 * t8138) + (t1038 * t4270);
    const double t8192 = t8187 + (t664 * t4365) + (t319 * t4500) + (motion->constants[2] * t6068) +
        (t329 * t4595) - (t1031 * t4262);
    const double t8197 = t8192 - (t1036 * t4264) - (t1044 * t4411) - (t317 * t4485) -
        (motion->constants[3] * t6044) - (t327 * t4535);
    const double t8198 = t8197 - (t1940 * t8164);
    const double t8220 = (t4741 * t8124) + (t4745 * t8132) + (t4749 * t8138) + (t1038 * t4831) +
        (t664 * t4900) + (t319 * t5024);
    const double t8225 = t8220 + (motion->constants[2] * t6100) + (t329 * t5110) - (t1031 * t4828) -
        (t1036 * t4829) - (t1044 * t4942);
    const double t8230 = t8225 - (t317 * t5009) - (motion->constants[3] * t6084) - (t327 * t5056) -
        (t2012 * t8164) - (t2016 * t8198);
    const double t8254 = (t2065 * t8118) + (t5346 * t8124) + (t5352 * t8132) + (t5358 * t8138) +
        (t1038 * t5521) + (t664 * t5617);
    const double t8259 = t8254 + (t319 * t5751) + (motion->constants[2] * t6150) + (t329 * t5848) +
        (t2094 * t8230) - (t1031 * t5514);
    const double t8264 = t8259 - (t1036 * t5517) - (t1044 * t5662) - (t317 * t5736) -
        (motion->constants[3] * t6126) - (t327 * t5787);
    const double t8267 = t2131 * (t8264 - (t2072 * t8164) - (t2088 * t8198));
    const double t8269 = (t2024 * t8230) + (t2094 * t8267);
    const double t8273 = (t1958 * t8198) - (t2016 * t8269) - (t2088 * t8267);
    const double t8279 = (t1295 * t8164) - (t1940 * t8273) - (t2012 * t8269) - (t2072 * t8267);
    const double t8280 = motion->constants[37] * motion->constants[37];
    const double t8282 = motion->constants[38] * motion->constants[38];
    const double t8283 = t8280 + t8282;
    const double t8285 = motion->constants[37] * motion->constants[38];
    const double t8294 = t7887 + (t3845 * t8280) + (t3799 * t8283) + (t3814 * t8285) +
        (motion->constants[38] * t3836) + (motion->constants[37] * t3862);
    const double t8295 = t8294 - (t3820 * t8282);
    const double t8308 = t7909 + (t4657 * t8280) + (t4628 * t8283) + (t4634 * t8285) +
        (motion->constants[38] * t4649) + (motion->constants[37] * t4669);
    const double t8310 = t8308 - (t4639 * t8282) - (t1940 * t8295);
    const double t8314 = (t2012 * t8295) + (t2016 * t8310);
    const double t8329 = t7934 + (t5914 * t8280) + (t5884 * t8283) + (t5895 * t8282) +
        (motion->constants[38] * t5906) + (motion->constants[37] * t5927);
    const double t8334 = t2131 * (t8329 - (t5890 * t8285) - (t2072 * t8295) - (t2088 * t8310) -
        (t2094 * t8314));
    const double t8336 = (t2094 * t8334) - (t2024 * t8314);
    const double t8340 = (t1958 * t8310) - (t2016 * t8336) - (t2088 * t8334);
    const double t8346 = (t1295 * t8295) - (t1940 * t8340) - (t2012 * t8336) - (t2072 * t8334);
    const double t8347 = t3845 - t3820;
    const double t8351 = t4657 - t4639 - (t1940 * t8347);
    const double t8355 = (t2012 * t8347) + (t2016 * t8351);
    const double t8364 = t2131 * (t5895 + t5914 - (t2072 * t8347) - (t2088 * t8351) - (t2094 *
        t8355));
    const double t8366 = (t2094 * t8364) - (t2024 * t8355);
    const double t8370 = (t1958 * t8351) - (t2016 * t8366) - (t2088 * t8364);
    const double t8376 = (t1295 * t8347) - (t1940 * t8370) - (t2012 * t8366) - (t2072 * t8364);
    const double t8377 = t1379 * t1437;
    const double t8379 = t1370 * t1437;
    const double t8383 = (t2406 * t8377) + (t2414 * t8379) - (t1283 * t2312);
    const double t8391 = (t3916 * t8377) + (t3920 * t8379) - (t1930 * t2312) - (t1940 * t8383);
    const double t8395 = (t2012 * t8383) + (t2016 * t8391);
    const double t8407 = (t5155 * t8377) - (t5159 * t8379) - (t2065 * t2312) - (t2072 * t8383) -
        (t2088 * t8391) - (t2094 * t8395);
    const double t8408 = t2131 * t8407;
    const double t8410 = (t2094 * t8408) - (t2024 * t8395);
    const double t8414 = (t1958 * t8391) - (t2016 * t8410) - (t2088 * t8408);
    const double t8420 = (t1295 * t8383) - (t1940 * t8414) - (t2012 * t8410) - (t2072 * t8408);
    const double t8423 = (motion->constants[2] * t6440) - (motion->constants[3] * t6415);
    const double t8424 = t7216 + t8423;
    const double t8428 = (motion->constants[2] * t6751) - (motion->constants[3] * t6735);
    const double t8431 = t7269 + t8428 - (t1940 * t8424);
    const double t8435 = (motion->constants[2] * t6890) - (motion->constants[3] * t6882);
    const double t8440 = t7314 + t8435 - (t2012 * t8424) - (t2016 * t8431);
    const double t8444 = (motion->constants[2] * t6997) - (motion->constants[3] * t6981);
    const double t8452 = t2131 * (t7363 + t8444 + (t2094 * t8440) - (t2072 * t8424) - (t2088 *
        t8431));
    const double t8454 = (t2024 * t8440) + (t2094 * t8452);
    const double t8458 = (t1958 * t8431) - (t2016 * t8454) - (t2088 * t8452);
    const double t8464 = (t1295 * t8424) - (t1940 * t8458) - (t2012 * t8454) - (t2072 * t8452);
    const double t8465 = t2196 * t6390;
    const double t8469 = (t2224 * t6419) - (t2230 * t6390);
    const double t8471 = t2196 * t6419;
    const double t8476 = t2230 + (t6390 * t6422) - (t6394 * t6419);
    const double t8481 = t2196 + (t6362 * t6419) + (t6369 * t6390);
    const double t8486 = t2224 + (t6399 * t6419) - (t6390 * t6427);
    const double t8488 = t6390 * t6390;
    const double t8490 = t6419 * t6419;
    const double t8491 = t8488 + t8490;
    const double t8493 = t6390 * t6419;
    const double t8500 = (t2513 * t8465) + (t2467 * t8469) + (t2532 * t8481) + (t2506 * t8486) +
        (t6351 * t8488) + (t6405 * t8491);
    const double t8504 = t8500 + (t6382 * t8490) - (t2520 * t8471) - (t2490 * t8476) - (t6372 *
        t8493);
    const double t8521 = (t3948 * t8465) + (t3936 * t8469) + (t3956 * t8481) + (t3944 * t8486) +
        (t6705 * t8488) + (t6725 * t8491);
    const double t8526 = t8521 + (t6716 * t8490) - (t3952 * t8471) - (t3940 * t8476) - (t6711 *
        t8493) - (t1940 * t8504);
    const double t8540 = (motion->constants[3] * t8471) + (t6876 * t8491) + (t6869 * t8493) +
        (t6873 * t8490) - (motion->constants[2] * t8465) - (t6865 * t8488);
    const double t8542 = t8540 - (t2012 * t8504) - (t2016 * t8526);
    const double t8561 = (t5191 * t8465) + (t5177 * t8469) + (t5182 * t8476) + (t5200 * t8481) +
        (t5187 * t8486) + (t6951 * t8488);
    const double t8566 = t8561 + (t6971 * t8491) + (t6962 * t8490) + (t2094 * t8542) - (t5195 *
        t8471) - (t6957 * t8493);
    const double t8569 = t2131 * (t8566 - (t2072 * t8504) - (t2088 * t8526));
    const double t8571 = (t2024 * t8542) + (t2094 * t8569);
    const double t8575 = (t1958 * t8526) - (t2016 * t8571) - (t2088 * t8569);
    const double t8581 = (t1295 * t8504) - (t1940 * t8575) - (t2012 * t8571) - (t2072 * t8569);
    const double t8584 = (motion->constants[2] * t6415) + (motion->constants[3] * t6440);
    const double t8590 = (motion->constants[2] * t6735) + (motion->constants[3] * t6751) - (t1940 *
        t8584);
    const double t8598 = (motion->constants[2] * t6882) + (motion->constants[3] * t6890) - (t2012 *
        t8584) - (t2016 * t8590);
    const double t8609 = t2131 * ((motion->constants[2] * t6981) + (motion->constants[3] * t6997) +
        (t2094 * t8598) - (t2072 * t8584) - (t2088 * t8590));
    const double t8611 = (t2024 * t8598) + (t2094 * t8609);
    const double t8615 = (t1958 * t8590) - (t2016 * t8611) - (t2088 * t8609);
    const double t8621 = (t1295 * t8584) - (t1940 * t8615) - (t2012 * t8611) - (t2072 * t8609);
    const double t8624 = (t1940 * t8423) - t8428;
    const double t8629 = (t2012 * t8423) - t8435 - (t2016 * t8624);
    const double t8637 = t2131 * ((t2072 * t8423) + (t2094 * t8629) - t8444 - (t2088 * t8624));
    const double t8639 = (t2024 * t8629) + (t2094 * t8637);
    const double t8643 = (t1958 * t8624) - (t2016 * t8639) - (t2088 * t8637);
    const double t8651 = motion->constants[35] * t6372;
    const double t8654 = (motion->constants[36] * t6351) + t8651 + (motion->constants[34] * t6382);
    const double t8657 = motion->constants[35] * t6711;
    const double t8662 = (motion->constants[36] * t6705) + t8657 + (motion->constants[34] * t6716) -
        (t1940 * t8654);
    const double t8665 = motion->constants[35] * t6869;
    const double t8672 = (motion->constants[34] * t6873) - (motion->constants[36] * t6865) - t8665 -
        (t2012 * t8654) - (t2016 * t8662);
    const double t8675 = motion->constants[35] * t6957;
    const double t8684 = (motion->constants[36] * t6951) + t8675 + (motion->constants[34] * t6962) +
        (t2094 * t8672) - (t2072 * t8654) - (t2088 * t8662);
    const double t8685 = t2131 * t8684;
    const double t8687 = (t2024 * t8672) + (t2094 * t8685);
    const double t8691 = (t1958 * t8662) - (t2016 * t8687) - (t2088 * t8685);
    const double t8697 = (t1295 * t8654) - (t1940 * t8691) - (t2012 * t8687) - (t2072 * t8685);
    const double t8700 = t6725 - (t1940 * t6405);
    const double t8705 = t6876 - (t2012 * t6405) - (t2016 * t8700);
    const double t8713 = t2131 * (t6971 + (t2094 * t8705) - (t2072 * t6405) - (t2088 * t8700));
    const double t8715 = (t2024 * t8705) + (t2094 * t8713);
    const double t8719 = (t1958 * t8700) - (t2016 * t8715) - (t2088 * t8713);
    const double t8725 = (t1295 * t6405) - (t1940 * t8719) - (t2012 * t8715) - (t2072 * t8713);
    const double t8729 = (motion->constants[34] * t6351) + (motion->constants[36] * t6382) - t8651;
    const double t8736 = (motion->constants[34] * t6705) + (motion->constants[36] * t6716) - t8657 -
        (t1940 * t8729);
    const double t8745 = t8665 + (motion->constants[36] * t6873) - (motion->constants[34] * t6865) -
        (t2012 * t8729) - (t2016 * t8736);
    const double t8756 = (motion->constants[34] * t6951) + (motion->constants[36] * t6962) +
        (t2094 * t8745) - t8675 - (t2072 * t8729) - (t2088 * t8736);
    const double t8757 = t2131 * t8756;
    const double t8759 = (t2024 * t8745) + (t2094 * t8757);
    const double t8763 = (t1958 * t8736) - (t2016 * t8759) - (t2088 * t8757);
    const double t8769 = (t1295 * t8729) - (t1940 * t8763) - (t2012 * t8759) - (t2072 * t8757);
    const double t8774 = (t6351 * t7773) + (t6372 * t7776) - (t6382 * t7773);
    const double t8782 = (t6705 * t7773) + (t6711 * t7776) - (t6716 * t7773) - (t1940 * t8774);
    const double t8792 = (t6865 * t7773) + (t6869 * t7776) + (t6873 * t7773) + (t2012 * t8774) +
        (t2016 * t8782);
    const double t8804 = (t6951 * t7773) + (t6957 * t7776) - (t6962 * t7773) - (t2072 * t8774) -
        (t2088 * t8782) - (t2094 * t8792);
    const double t8805 = t2131 * t8804;
    const double t8807 = (t2094 * t8805) - (t2024 * t8792);
    const double t8811 = (t1958 * t8782) - (t2016 * t8807) - (t2088 * t8805);
    const double t8817 = (t1295 * t8774) - (t1940 * t8811) - (t2012 * t8807) - (t2072 * t8805);
    const double t8819 = t2094 * t2131;
    const double t8820 = positions[6] * t8819;
    const double t8822 = (positions[6] * t2024) + (t2094 * t8820);
    const double t8825 = (t2016 * t8822) + (t2088 * t8820);
    const double t8830 = (t2012 * t8822) + (t2072 * t8820) - (t1940 * t8825);
    const double t8832 = speeds[2] * t8819;
    const double t8834 = (speeds[2] * t2024) + (t2094 * t8832);
    const double t8837 = (t2016 * t8834) + (t2088 * t8832);
    const double t8842 = (t2012 * t8834) + (t2072 * t8832) - (t1940 * t8837);
    const double t8843 = -((t1295 * t8423) + (t1940 * t8643) + (t2012 * t8639) + (t2072 * t8637));
    const double t8844 = -t8822;
    const double t8845 = -t8834;
    const double t8846 = -t8820;
    const double t8847 = -t8832;
    by_parameters[0][0] = t212;
    by_parameters[0][1] = t233;
    by_parameters[0][2] = t292;
    by_parameters[0][3] = 0.0;
    by_parameters[0][4] = t316;
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
    by_parameters[0][22] = t335;
    by_parameters[0][23] = 0.0;
    by_parameters[0][24] = 0.0;
    by_parameters[0][25] = 0.0;
    by_parameters[0][26] = 0.0;
    by_parameters[0][27] = 0.0;
    by_parameters[0][28] = 0.0;
    by_parameters[0][29] = 0.0;
    by_parameters[0][30] = 0.0;
    by_parameters[0][31] = 0.0;
    by_parameters[0][32] = 0.0;
    by_parameters[0][33] = 0.0;
    by_parameters[0][34] = 0.0;
    by_parameters[0][35] = 0.0;
    by_parameters[1][0] = t392;
    by_parameters[1][1] = t405;
    by_parameters[1][2] = t416;
    by_parameters[1][3] = 0.0;
    by_parameters[1][4] = t427;
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
    by_parameters[1][22] = t438;
    by_parameters[1][23] = 0.0;
    by_parameters[1][24] = 0.0;
    by_parameters[1][25] = 0.0;
    by_parameters[1][26] = 0.0;
    by_parameters[1][27] = 0.0;
    by_parameters[1][28] = 0.0;
    by_parameters[1][29] = 0.0;
    by_parameters[1][30] = 0.0;
    by_parameters[1][31] = 0.0;
    by_parameters[1][32] = 0.0;
    by_parameters[1][33] = 0.0;
    by_parameters[1][34] = 0.0;
    by_parameters[1][35] = 0.0;
    by_parameters[2][0] = t620;
    by_parameters[2][1] = t636;
    by_parameters[2][2] = t647;
    by_parameters[2][3] = 0.0;
    by_parameters[2][4] = t663;
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
    by_parameters[2][22] = t677;
    by_parameters[2][23] = 0.0;
    by_parameters[2][24] = 0.0;
    by_parameters[2][25] = 0.0;
    by_parameters[2][26] = 0.0;
    by_parameters[2][27] = 0.0;
    by_parameters[2][28] = 0.0;
    by_parameters[2][29] = 0.0;
    by_parameters[2][30] = 0.0;
    by_parameters[2][31] = 0.0;
    by_parameters[2][32] = 0.0;
    by_parameters[2][33] = 0.0;
    by_parameters[2][34] = 0.0;
    by_parameters[2][35] = 0.0;
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
    by_parameters[3][28] = 0.0;
    by_parameters[3][29] = 0.0;
    by_parameters[3][30] = 0.0;
    by_parameters[3][31] = 0.0;
    by_parameters[3][32] = 0.0;
    by_parameters[3][33] = 0.0;
    by_parameters[3][34] = 0.0;
    by_parameters[3][35] = 0.0;
    by_parameters[4][0] = t730;
    by_parameters[4][1] = t743;
    by_parameters[4][2] = t754;
    by_parameters[4][3] = 0.0;
    by_parameters[4][4] = t763;
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
    by_parameters[4][22] = t774;
    by_parameters[4][23] = 0.0;
    by_parameters[4][24] = 0.0;
    by_parameters[4][25] = 0.0;
    by_parameters[4][26] = 0.0;
    by_parameters[4][27] = 0.0;
    by_parameters[4][28] = 0.0;
    by_parameters[4][29] = 0.0;
    by_parameters[4][30] = 0.0;
    by_parameters[4][31] = 0.0;
    by_parameters[4][32] = 0.0;
    by_parameters[4][33] = 0.0;
    by_parameters[4][34] = 0.0;
    by_parameters[4][35] = 0.0;
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
    by_parameters[5][28] = 0.0;
    by_parameters[5][29] = 0.0;
    by_parameters[5][30] = 0.0;
    by_parameters[5][31] = 0.0;
    by_parameters[5][32] = 0.0;
    by_parameters[5][33] = 0.0;
    by_parameters[5][34] = 0.0;
    by_parameters[5][35] = 0.0;
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
    by_parameters[6][28] = 0.0;
    by_parameters[6][29] = 0.0;
    by_parameters[6][30] = 0.0;
    by_parameters[6][31] = 0.0;
    by_parameters[6][32] = 0.0;
    by_parameters[6][33] = 0.0;
    by_parameters[6][34] = 0.0;
    by_parameters[6][35] = 0.0;
    by_parameters[7][0] = 0.0;
    by_parameters[7][1] = 0.0;
    by_parameters[7][2] = 0.0;
    by_parameters[7][3] = 0.0;
    by_parameters[7][4] = 0.0;
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
    by_parameters[7][22] = 0.0;
    by_parameters[7][23] = 0.0;
    by_parameters[7][24] = 0.0;
    by_parameters[7][25] = 0.0;
    by_parameters[7][26] = 0.0;
    by_parameters[7][27] = 0.0;
    by_parameters[7][28] = 0.0;
    by_parameters[7][29] = 0.0;
    by_parameters[7][30] = 0.0;
    by_parameters[7][31] = 0.0;
    by_parameters[7][32] = 0.0;
    by_parameters[7][33] = 0.0;
    by_parameters[7][34] = 0.0;
    by_parameters[7][35] = 0.0;
    by_parameters[8][0] = t969;
    by_parameters[8][1] = t987;
    by_parameters[8][2] = t998;
    by_parameters[8][3] = 0.0;
    by_parameters[8][4] = t1021;
    by_parameters[8][5] = 0.0;
    by_parameters[8][6] = 0.0;
    by_parameters[8][7] = 0.0;
    by_parameters[8][8] = 0.0;
    by_parameters[8][9] = 0.0;
    by_parameters[8][10] = 0.0;
    by_parameters[8][11] = 0.0;
    by_parameters[8][12] = 0.0;
    by_parameters[8][13] = 0.0;
    by_parameters[8][14] = 0.0;
    by_parameters[8][15] = 0.0;
    by_parameters[8][16] = 0.0;
    by_parameters[8][17] = 0.0;
    by_parameters[8][18] = 0.0;
    by_parameters[8][19] = 0.0;
    by_parameters[8][20] = 0.0;
    by_parameters[8][21] = 0.0;
    by_parameters[8][22] = t1062;
    by_parameters[8][23] = 0.0;
    by_parameters[8][24] = 0.0;
    by_parameters[8][25] = 0.0;
    by_parameters[8][26] = 0.0;
    by_parameters[8][27] = 0.0;
    by_parameters[8][28] = 0.0;
    by_parameters[8][29] = 0.0;
    by_parameters[8][30] = 0.0;
    by_parameters[8][31] = 0.0;
    by_parameters[8][32] = 0.0;
    by_parameters[8][33] = 0.0;
    by_parameters[8][34] = 0.0;
    by_parameters[8][35] = 0.0;
    by_parameters[9][0] = t5975;
    by_parameters[9][1] = t6176;
    by_parameters[9][2] = t7122;
    by_parameters[9][3] = t7170;
    by_parameters[9][4] = t7400;
    by_parameters[9][5] = t7437;
    by_parameters[9][6] = t7467;
    by_parameters[9][7] = t7513;
    by_parameters[9][8] = t7549;
    by_parameters[9][9] = t7576;
    by_parameters[9][10] = t7664;
    by_parameters[9][11] = t7706;
    by_parameters[9][12] = t7733;
    by_parameters[9][13] = t7772;
    by_parameters[9][14] = t7816;
    by_parameters[9][15] = t7843;
    by_parameters[9][16] = t7879;
    by_parameters[9][17] = t7965;
    by_parameters[9][18] = t8007;
    by_parameters[9][19] = t8034;
    by_parameters[9][20] = t8073;
    by_parameters[9][21] = t8115;
    by_parameters[9][22] = t8279;
    by_parameters[9][23] = t8346;
    by_parameters[9][24] = t8376;
    by_parameters[9][25] = t8420;
    by_parameters[9][26] = t8464;
    by_parameters[9][27] = t8581;
    by_parameters[9][28] = t8621;
    by_parameters[9][29] = t8843;
    by_parameters[9][30] = t8697;
    by_parameters[9][31] = t8725;
    by_parameters[9][32] = t8769;
    by_parameters[9][33] = t8817;
    by_parameters[9][34] = t8830;
    by_parameters[9][35] = t8842;
    by_parameters[10][0] = t5969;
    by_parameters[10][1] = t6170;
    by_parameters[10][2] = t7116;
    by_parameters[10][3] = t7164;
    by_parameters[10][4] = t7394;
    by_parameters[10][5] = t7431;
    by_parameters[10][6] = t7461;
    by_parameters[10][7] = t7507;
    by_parameters[10][8] = t7543;
    by_parameters[10][9] = t7570;
    by_parameters[10][10] = t7658;
    by_parameters[10][11] = t7700;
    by_parameters[10][12] = t7727;
    by_parameters[10][13] = t7766;
    by_parameters[10][14] = t7810;
    by_parameters[10][15] = t7837;
    by_parameters[10][16] = t7873;
    by_parameters[10][17] = t7959;
    by_parameters[10][18] = t8001;
    by_parameters[10][19] = t8028;
    by_parameters[10][20] = t8067;
    by_parameters[10][21] = t8109;
    by_parameters[10][22] = t8273;
    by_parameters[10][23] = t8340;
    by_parameters[10][24] = t8370;
    by_parameters[10][25] = t8414;
    by_parameters[10][26] = t8458;
    by_parameters[10][27] = t8575;
    by_parameters[10][28] = t8615;
    by_parameters[10][29] = t8643;
    by_parameters[10][30] = t8691;
    by_parameters[10][31] = t8719;
    by_parameters[10][32] = t8763;
    by_parameters[10][33] = t8811;
    by_parameters[10][34] = t8825;
    by_parameters[10][35] = t8837;
    by_parameters[11][0] = t5965;
    by_parameters[11][1] = t6166;
    by_parameters[11][2] = t7112;
    by_parameters[11][3] = t7160;
    by_parameters[11][4] = t7390;
    by_parameters[11][5] = t7427;
    by_parameters[11][6] = t7457;
    by_parameters[11][7] = t7503;
    by_parameters[11][8] = t7539;
    by_parameters[11][9] = t7566;
    by_parameters[11][10] = t7654;
    by_parameters[11][11] = t7696;
    by_parameters[11][12] = t7723;
    by_parameters[11][13] = t7762;
    by_parameters[11][14] = t7806;
    by_parameters[11][15] = t7833;
    by_parameters[11][16] = t7869;
    by_parameters[11][17] = t7955;
    by_parameters[11][18] = t7997;
    by_parameters[11][19] = t8024;
    by_parameters[11][20] = t8063;
    by_parameters[11][21] = t8105;
    by_parameters[11][22] = t8269;
    by_parameters[11][23] = t8336;
    by_parameters[11][24] = t8366;
    by_parameters[11][25] = t8410;
    by_parameters[11][26] = t8454;
    by_parameters[11][27] = t8571;
    by_parameters[11][28] = t8611;
    by_parameters[11][29] = t8639;
    by_parameters[11][30] = t8687;
    by_parameters[11][31] = t8715;
    by_parameters[11][32] = t8759;
    by_parameters[11][33] = t8807;
    by_parameters[11][34] = t8844;
    by_parameters[11][35] = t8845;
    by_parameters[12][0] = t5963;
    by_parameters[12][1] = t6164;
    by_parameters[12][2] = t7110;
    by_parameters[12][3] = t7158;
    by_parameters[12][4] = t7388;
    by_parameters[12][5] = t7425;
    by_parameters[12][6] = t7455;
    by_parameters[12][7] = t7501;
    by_parameters[12][8] = t7537;
    by_parameters[12][9] = t7564;
    by_parameters[12][10] = t7652;
    by_parameters[12][11] = t7694;
    by_parameters[12][12] = t7721;
    by_parameters[12][13] = t7760;
    by_parameters[12][14] = t7804;
    by_parameters[12][15] = t7831;
    by_parameters[12][16] = t7867;
    by_parameters[12][17] = t7953;
    by_parameters[12][18] = t7995;
    by_parameters[12][19] = t8022;
    by_parameters[12][20] = t8061;
    by_parameters[12][21] = t8103;
    by_parameters[12][22] = t8267;
    by_parameters[12][23] = t8334;
    by_parameters[12][24] = t8364;
    by_parameters[12][25] = t8408;
    by_parameters[12][26] = t8452;
    by_parameters[12][27] = t8569;
    by_parameters[12][28] = t8609;
    by_parameters[12][29] = t8637;
    by_parameters[12][30] = t8685;
    by_parameters[12][31] = t8713;
    by_parameters[12][32] = t8757;
    by_parameters[12][33] = t8805;
    by_parameters[12][34] = t8846;
    by_parameters[12][35] = t8847;
}

carvallo_motion_error_t whipple_leaning_f64_motion_by_parameters(const whipple_leaning_f64_motion_t *motion,
    const double positions[WHIPPLE_LEANING_POSITIONS], const double speeds[WHIPPLE_LEANING_SPEEDS],
    const double forces[WHIPPLE_LEANING_FORCES],
    double by_parameters[WHIPPLE_LEANING_STATES][WHIPPLE_LEANING_PARAMETERS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_LEANING_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_LEANING_FORCES)) {
        bool are_finite = true;
        whipple_leaning_f64_compute_by_parameters(motion, positions, speeds, forces, by_parameters);
        for (size_t row = 0U; row < WHIPPLE_LEANING_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f64(by_parameters[row],
                WHIPPLE_LEANING_PARAMETERS);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
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
    const float t2 = p->zB * p->mB;
    const float t7 = p->zH * p->mH;
    const float t15 = p->rR * p->mR;
    const float ay_theta3_delta = p->IUxx + (p->rR * t15);
    const float t21 = p->rF * p->mF;
    const float t25 = p->IFxx + ((p->rF * t21) + p->IHxx);
    const float t28 = p->zU * p->mU;
    const float M_11 = (p->zB * t2) + (p->IRxx + (p->zH * t7)) + (p->IBxx + (ay_theta3_delta +
        (t25 + (p->zU * t28))));
    float wx_delta2_delta = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &wx_delta2_delta, &cos_lam);
    const float yaw_per_v_delta = cos_lam / p->w;
    const float yaw_by_delta = p->c * yaw_per_v_delta;
    const float t48 = (t28 * p->xU) - (p->IUxz + p->IBxz - (t2 * p->xB));
    const float wz_delta2_delta = cos_lam + yaw_by_delta;
    const float t58 = (p->zH * wx_delta2_delta) + (cos_lam * (p->c + p->w)) - (p->xH *
        wz_delta2_delta);
    const float t59 = p->mH * t58;
    const float t63 = wz_delta2_delta * p->IHxz;
    const float t65 = t63 + (t25 * wx_delta2_delta);
    const float t67 = p->zP - p->zU;
    const float M_13 = p->IUxx - (t28 * t67);
    const float t72 = wz_delta2_delta * (p->IFxx + p->IHzz);
    const float h_wheels_all = p->mU * p->xU;
    const float t83 = p->mB * p->xB;
    const float vy_theta3_delta = t83 * p->xB;
    const float t88 = yaw_by_delta * ((p->xU * h_wheels_all) + p->IUzz + (p->IBzz + (p->IRxx +
        vy_theta3_delta)));
    const float M_22 = (wz_delta2_delta * t72) + (wx_delta2_delta * (t63 + t65)) + ((t58 * t59) +
        (yaw_by_delta * t88));
    const float t93 = p->IUxz + (h_wheels_all * t67);
    const float M_23 = t93 * yaw_by_delta;
    const float t95 = p->mU * t67;
    const float M_33 = p->IUxx + (t95 * t67);
    const float t101 = p->IHxz + (t21 * p->w);
    const float t105 = p->IRyy / p->rR;
    const float K0_11 = t2 + t28 + (t7 - t21) - t15;
    const float t110 = t105 - K0_11;
    const float vy_spin_F5_delta = p->c * t110;
    const float h_spin_F = p->IFyy / p->rF;
    const float t117 = wz_delta2_delta * h_spin_F;
    const float C1_12 = ((t101 - (t7 * p->xH) - (t48 - vy_spin_F5_delta)) * yaw_per_v_delta) + t117;
    const float ay_all1_delta = t83 + h_wheels_all;
    const float K0_12 = t59 - (yaw_by_delta * ay_all1_delta) - (t21 * wx_delta2_delta);
    const float C1_22 = yaw_per_v_delta * ((t101 * wx_delta2_delta) - (p->xH * t59) + (t72 + (t88 -
        (p->c * K0_12))));
    const float C1_32 = (t93 + (p->c * t95)) * yaw_per_v_delta;
    const float K0_22 = wx_delta2_delta * K0_12;
    const float K2_12 = yaw_per_v_delta * (h_spin_F + t110);
    const float ay_delta2_delta = (wx_delta2_delta * h_spin_F) - K0_12;
    const float K2_22 = yaw_per_v_delta * ay_delta2_delta;
    const float K2_32 = yaw_per_v_delta * t95;
    const float M_12 = t65 - ((yaw_by_delta * t48) - (p->zH * t59));
    const float C1_21 = -(t117 + (yaw_by_delta * t105));
    const float K0_13 = -t95;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = M_23;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_23;
    matrices->m[2][2] = M_33;
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
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[0][2] = K0_13;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0F;
    matrices->k0[2][0] = K0_13;
    matrices->k0[2][1] = 0.0F;
    matrices->k0[2][2] = K0_13;
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
    float wx_delta2_delta = 0.0F;
    float wx_delta2_delta_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const float M_11_mR = p->rR * p->rR;
    const float t37 = p->zH * p->mH;
    const float t38 = p->rF * p->mF;
    const float t43 = p->IHxx + p->IFxx + (p->zH * t37) + (p->rF * t38);
    const float t44 = p->zU * p->mU;
    const float M_11_mB = p->zB * p->zB;
    const float M_11_zH = t37 + t37;
    const float M_11_mH = p->zH * p->zH;
    const float M_11_rF = t38 + t38;
    const float M_11_mF = p->rF * p->rF;
    const float M_11_mU = p->zU * p->zU;
    const float M_11_zU = t44 + t44;
    const float t52 = p->zB * p->mB;
    const float M_11_zB = t52 + t52;
    const float t54 = 1.0F / p->w;
    const float t56 = (t37 * p->xH) - p->IHxz;
    const float t63 = (p->mR * M_11_mR) + t43 + p->IRxx + p->IUxx + (p->zU * t44) + p->IBxx;
    const float M_11 = t63 + (p->zB * t52);
    const float t66 = p->c * t54;
    const float t67 = p->c + p->w;
    const float t68 = p->mB * p->xB;
    const float t73 = (p->zB * t68) + (t44 * p->xU) - p->IBxz - p->IUxz;
    const float K0_13_mU = p->zU - p->zP;
    const float M_13_mU = p->zU * K0_13_mU;
    const float M_33_mU = K0_13_mU * K0_13_mU;
    const float K0_13 = p->mU * K0_13_mU;
    const float M_13 = p->IUxx + (p->zU * K0_13);
    const float M_33 = p->IUxx + (K0_13_mU * K0_13);
    const float M_33_zU = K0_13 + K0_13;
    const float M_13_zU = t44 + K0_13;
    const float t84 = p->mH * p->xH;
    const float vy_theta3_delta = p->xH * t84;
    const float t87 = p->IFxx + p->IHzz + vy_theta3_delta;
    const float h_wheels_all = p->mU * p->xU;
    const float t94 = p->IRxx + p->IUzz + (p->xB * t68) + p->IBzz + (p->xU * h_wheels_all);
    const float yaw_by_delta = wx_delta2_delta_lam * t66;
    const float t96 = wx_delta2_delta_lam * t67;
    const float t97 = t56 * wx_delta2_delta;
    const float t98 = p->zH * wx_delta2_delta;
    const float t100 = p->IUxz - (K0_13_mU * h_wheels_all);
    const float t101 = 1.0F / p->rF;
    const float t102 = t56 + t73;
    const float t103 = t38 * p->w;
    const float C1_12_mR = p->rR * yaw_by_delta;
    const float wz_delta2_delta = wx_delta2_delta_lam + yaw_by_delta;
    const float t106 = t96 + t98;
    const float M_23 = yaw_by_delta * t100;
    const float h_spin_F = p->IFyy * t101;
    const float t109 = p->mR * p->rR;
    const float M_11_rR = t109 + t109;
    const float t111 = t37 - t38;
    const float K0_11 = t44 + t52 + t111 - t109;
    const float t115 = t54 * M_23;
    const float t118 = (wx_delta2_delta_lam * t111) + (wx_delta2_delta * t84);
    const float t119 = t37 * wz_delta2_delta;
    const float t124 = (t43 * wx_delta2_delta) + (t37 * t96) - (wz_delta2_delta * t56);
    const float t128 = t97 + (t96 * t84) - (wz_delta2_delta * t87);
    const float M_22_yaw_per_v_delta = t37 * wx_delta2_delta_lam;
    const float t131 = t68 + t84 + h_wheels_all;
    const float t132 = wz_delta2_delta * p->xH;
    const float K0_12_mH = t106 - t132;
    const float t134 = t132 - t106;
    const float M_12_zH = p->mH * (t98 - t134);
    const float t137 = p->zH * t134;
    const float M_22_mH = t134 * t134;
    const float t139 = wx_delta2_delta * t134;
    const float t140 = p->mH * t134;
    const float t141 = 1.0F / p->rR;
    const float t142 = wx_delta2_delta_lam * h_spin_F;
    const float yaw_per_v_delta = wx_delta2_delta_lam * t54;
    const float M_12 = t124 - (yaw_by_delta * t73);
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float C1_12_IRyy = yaw_by_delta * t141;
    const float K2_12_IRyy = t141 * yaw_per_v_delta;
    const float K2_22_mH = t134 * yaw_per_v_delta;
    const float C1_22_IHzz = wz_delta2_delta * yaw_per_v_delta;
    const float t152 = (yaw_by_delta * t94) - t128;
    const float t156 = yaw_per_v_delta * (t87 + t94 + (p->c * t131));
    const float t157 = p->IRyy * t141;
    const float t158 = t141 * t157;
    const float t159 = h_spin_F + t157;
    const float t160 = yaw_by_delta * p->xB;
    const float t161 = p->zB * t160;
    const float M_22_mB = t160 * t160;
    const float t163 = wx_delta2_delta * t160;
    const float M_23_yaw_per_v_delta = (t66 * t152) - t128 - (t67 * t140);
    const float t168 = K0_11 - t159;
    const float t169 = p->mB * t160;
    const float C1_21_rR = yaw_by_delta * t158;
    const float t171 = p->mR - t158;
    const float t172 = t159 * yaw_per_v_delta;
    const float t173 = t38 * wx_delta2_delta;
    const float M_23_zP = yaw_by_delta * h_wheels_all;
    const float t177 = t140 + t169 + t173 + M_23_zP;
    const float t178 = p->c * t172;
    const float t179 = t140 + t140;
    const float C1_12_rR = yaw_by_delta * t171;
    const float K2_12_rR = yaw_per_v_delta * t171;
    const float M_22_xH = wz_delta2_delta * t179;
    const float t183 = wx_delta2_delta * t179;
    const float t184 = wx_delta2_delta_lam * t179;
    const float t188 = t54 * (t102 + (p->c * t168) - t103);
    const float C1_21_w = t54 * t178;
    const float C1_21 = -(t142 + t178);
    const float K0_12 = -t177;
    const float K0_22 = -(wx_delta2_delta * t177);
    const float M_22 = (wx_delta2_delta_lam * M_23_yaw_per_v_delta) + (wx_delta2_delta * t124);
    const float t200 = (wx_delta2_delta * M_23_yaw_per_v_delta) - (wx_delta2_delta_lam * t124);
    const float t204 = t152 + (p->c * t177) + (p->w * t173);
    const float t205 = t152 * yaw_per_v_delta;
    const float t206 = t205 + t205;
    const float t208 = (t66 * t206) + t184;
    const float M_22_c = t206 - t184;
    const float M_23_c = t100 * yaw_per_v_delta;
    const float t211 = p->mU * yaw_by_delta;
    const float t212 = p->zU * t211;
    const float t213 = wx_delta2_delta * t211;
    const float t214 = t200 + t200;
    const float t215 = K0_13_mU * t211;
    const float C1_32 = M_23_c - t215;
    const float C1_12_w = yaw_per_v_delta * (t38 + t188);
    const float t219 = t54 * C1_32;
    const float ay_all1_delta = h_spin_F - t188;
    const float t221 = t168 * yaw_per_v_delta;
    const float C1_22 = yaw_per_v_delta * t204;
    const float t224 = t204 + (p->c * t156);
    const float K2_12_w = t54 * t221;
    const float K2_12 = -t221;
    const float C1_12 = wx_delta2_delta_lam * ay_all1_delta;
    const float t228 = wx_delta2_delta * ay_all1_delta;
    const float t229 = wx_delta2_delta * h_spin_F;
    const float t230 = t177 + t229;
    const float K2_22 = yaw_per_v_delta * t230;
    const float t232 = K0_13 * yaw_per_v_delta;
    const float K2_32_w = t54 * t232;
    const float K2_32 = -t232;
    const float t235 = t102 * yaw_per_v_delta;
    const float M_12_w = M_22_yaw_per_v_delta + (t66 * t235);
    const float M_12_c = M_22_yaw_per_v_delta - t235;
    const float t239 = p->mH * wx_delta2_delta_lam;
    const float t240 = p->c + p->xH;
    const float C1_22_mH = t240 * K2_22_mH;
    const float t242 = t239 * t240;
    const float t246 = yaw_per_v_delta * ((t54 * t224) + t242 - t173);
    const float t249 = yaw_per_v_delta * (t242 - t177 - t156);
    const float t250 = t54 * t242;
    const float C1_22_xH = (wz_delta2_delta * t250) + (p->mH * K2_22_mH);
    const float t254 = wx_delta2_delta * t250;
    const float t255 = yaw_per_v_delta * t131;
    const float K0_12_w = t239 + (t66 * t255);
    const float K0_12_c = t239 - t255;
    const float K0_22_c = wx_delta2_delta * K0_12_c;
    const float t260 = yaw_per_v_delta * K0_12_c;
    const float t261 = t54 * wx_delta2_delta;
    const float vy_spin_F5_delta = (wx_delta2_delta * t87) + (p->c * t118) - (wx_delta2_delta_lam *
        (t103 - t56));
    const float C1_22_lam = (t67 * t254) - (t224 * t261) - (yaw_per_v_delta * vy_spin_F5_delta);
    const float t275 = (t54 * K2_22) + (yaw_per_v_delta * K0_12_w);
    const float K0_22_w = wx_delta2_delta * K0_12_w;
    const float K2_12_lam = t168 * t261;
    const float K2_32_lam = K0_13 * t261;
    const float t279 = p->c * t261;
    const float C1_21_lam = t229 + (t159 * t279);
    const float t282 = t100 * t279;
    const float K0_12_zH = p->mH * wx_delta2_delta;
    const float t284 = wz_delta2_delta * K0_12_zH;
    const float t285 = yaw_per_v_delta * K0_12_zH;
    const float t286 = t67 * K0_12_zH;
    const float M_12_lam = t97 + (t43 * wx_delta2_delta_lam) + (t102 * t279) - (p->zH * t286);
    const float K0_12_lam = t118 + (t131 * t279) - t286;
    const float t296 = p->c + p->xU;
    const float t299 = t261 * (p->IUxz - (K0_13 * t296));
    const float C1_22_vy_theta3_delta = yaw_by_delta * yaw_per_v_delta;
    const float M_22_vy_theta3_delta = p->c * C1_22_vy_theta3_delta;
    const float t302 = M_22_vy_theta3_delta + M_22_vy_theta3_delta;
    const float t303 = p->mB * yaw_by_delta;
    const float t304 = p->zB * t303;
    const float t305 = wx_delta2_delta * t303;
    const float K2_22_xB = yaw_per_v_delta * t303;
    const float t307 = p->zB * yaw_per_v_delta;
    const float M_22_xB = t68 * t302;
    const float M_22_xU = h_wheels_all * t302;
    const float t310 = p->mB * t307;
    const float K2_22_lam = (yaw_per_v_delta * (t142 - K0_12_lam)) - (t230 * t261);
    const float K0_22_lam = (wx_delta2_delta * K0_12_lam) - (wx_delta2_delta_lam * t177);
    const float K2_22_h_spin_F = wx_delta2_delta_lam * t261;
    const float K2_22_mF = p->rF * K2_22_h_spin_F;
    const float t320 = p->mB * yaw_per_v_delta;
    const float t321 = p->xB * t320;
    const float t322 = t303 + t321;
    const float t323 = p->c + p->xB;
    const float t324 = t307 * t323;
    const float K2_22_mB = p->xB * C1_22_vy_theta3_delta;
    const float C1_22_mB = t323 * K2_22_mB;
    const float t327 = p->mH * yaw_per_v_delta;
    const float C1_22_xB = yaw_by_delta * (t321 + t322);
    const float t330 = p->zH * t327;
    const float t331 = p->mH * wz_delta2_delta;
    const float K2_22_xH = yaw_per_v_delta * t331;
    const float M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const float K0_22_zH = p->mH * M_22_IHxx;
    const float t335 = p->zH * yaw_per_v_delta;
    const float t336 = t240 * t335;
    const float M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float t339 = wx_delta2_delta + wx_delta2_delta;
    const float M_22_IHxz = wz_delta2_delta * t339;
    const float M_12_rF = t38 * t339;
    const float M_22_rF = wx_delta2_delta * M_12_rF;
    const float C1_12_IFyy = wz_delta2_delta * t101;
    const float C1_21_rF = h_spin_F * C1_12_IFyy;
    const float K2_12_IFyy = t101 * yaw_per_v_delta;
    const float K2_22_IFyy = wx_delta2_delta * K2_12_IFyy;
    const float t347 = p->mF * yaw_per_v_delta;
    const float K2_12_rF = t347 - (h_spin_F * K2_12_IFyy);
    const float t350 = t67 * t347;
    const float C1_12_rF = t350 - C1_21_rF;
    const float C1_22_rF = wx_delta2_delta * t350;
    const float t353 = p->mF * wx_delta2_delta;
    const float t354 = wx_delta2_delta * t353;
    const float K2_22_rF = wx_delta2_delta * K2_12_rF;
    const float t356 = p->rF * wx_delta2_delta;
    const float M_12_mF = p->rF * t356;
    const float M_22_mF = t356 * t356;
    const float t359 = wx_delta2_delta * t356;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float C1_12_mF = t67 * K2_12_mF;
    const float C1_22_mF = wx_delta2_delta * C1_12_mF;
    const float K2_32_zP = p->mU * yaw_per_v_delta;
    const float C1_32_zP = t296 * K2_32_zP;
    const float t365 = p->c * p->xU;
    const float t366 = yaw_per_v_delta * t365;
    const float t367 = wx_delta2_delta * t366;
    const float t368 = p->zU * t366;
    const float t369 = K0_13_mU * t366;
    const float K2_22_mU = p->xU * C1_22_vy_theta3_delta;
    const float M_22_mU = t365 * K2_22_mU;
    const float t372 = p->zU * yaw_per_v_delta;
    const float C1_22_mU = t296 * K2_22_mU;
    const float t374 = t296 * t372;
    const float t375 = K0_13_mU * yaw_per_v_delta;
    const float t376 = t296 * t375;
    const float t377 = p->mU * t372;
    const float K2_22_xU = p->mU * C1_22_vy_theta3_delta;
    const float C1_22_xU = (p->xU + t296) * K2_22_xU;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = M_23;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_23;
    matrices->m[2][2] = M_33;
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
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[0][2] = K0_13;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0F;
    matrices->k0[2][0] = K0_13;
    matrices->k0[2][1] = 0.0F;
    matrices->k0[2][2] = K0_13;
    matrices->k2[0][0] = 0.0F;
    matrices->k2[0][1] = K2_12;
    matrices->k2[0][2] = 0.0F;
    matrices->k2[1][0] = 0.0F;
    matrices->k2[1][1] = K2_22;
    matrices->k2[1][2] = 0.0F;
    matrices->k2[2][0] = 0.0F;
    matrices->k2[2][1] = K2_32;
    matrices->k2[2][2] = 0.0F;
    derivatives->values[0] = p->rR;
    derivatives->values[1] = p->mR;
    derivatives->values[2] = p->zB;
    derivatives->values[3] = p->mB;
    derivatives->values[4] = p->zH;
    derivatives->values[5] = p->mH;
    derivatives->values[6] = p->rF;
    derivatives->values[7] = p->mF;
    derivatives->values[8] = p->mU;
    derivatives->values[9] = p->zU;
    derivatives->values[10] = 1.0F;
    derivatives->values[11] = wx_delta2_delta;
    derivatives->values[12] = M_11_mR;
    derivatives->values[13] = t44;
    derivatives->values[14] = M_11_mB;
    derivatives->values[15] = M_11_zH;
    derivatives->values[16] = M_11_mH;
    derivatives->values[17] = M_11_rF;
    derivatives->values[18] = M_11_mF;
    derivatives->values[19] = M_11_mU;
    derivatives->values[20] = M_11_zU;
    derivatives->values[21] = M_11_zB;
    derivatives->values[22] = K0_13_mU;
    derivatives->values[23] = M_13_mU;
    derivatives->values[24] = M_33_mU;
    derivatives->values[25] = M_33_zU;
    derivatives->values[26] = M_13_zU;
    derivatives->values[27] = yaw_by_delta;
    derivatives->values[28] = C1_12_mR;
    derivatives->values[29] = wz_delta2_delta;
    derivatives->values[30] = M_11_rR;
    derivatives->values[31] = t115;
    derivatives->values[32] = t119;
    derivatives->values[33] = K0_12_mH;
    derivatives->values[34] = M_12_zH;
    derivatives->values[35] = t137;
    derivatives->values[36] = M_22_mH;
    derivatives->values[37] = t139;
    derivatives->values[38] = yaw_per_v_delta;
    derivatives->values[39] = K2_12_mR;
    derivatives->values[40] = C1_12_IRyy;
    derivatives->values[41] = K2_12_IRyy;
    derivatives->values[42] = K2_22_mH;
    derivatives->values[43] = C1_22_IHzz;
    derivatives->values[44] = t160;
    derivatives->values[45] = t161;
    derivatives->values[46] = M_22_mB;
    derivatives->values[47] = t163;
    derivatives->values[48] = t169;
    derivatives->values[49] = C1_21_rR;
    derivatives->values[50] = t172;
    derivatives->values[51] = M_23_zP;
    derivatives->values[52] = C1_12_rR;
    derivatives->values[53] = K2_12_rR;
    derivatives->values[54] = M_22_xH;
    derivatives->values[55] = t183;
    derivatives->values[56] = C1_21_w;
    derivatives->values[57] = t208;
    derivatives->values[58] = M_22_c;
    derivatives->values[59] = M_23_c;
    derivatives->values[60] = t211;
    derivatives->values[61] = t212;
    derivatives->values[62] = t213;
    derivatives->values[63] = t214;
    derivatives->values[64] = t215;
    derivatives->values[65] = C1_12_w;
    derivatives->values[66] = t219;
    derivatives->values[67] = t221;
    derivatives->values[68] = K2_12_w;
    derivatives->values[69] = t228;
    derivatives->values[70] = t232;
    derivatives->values[71] = K2_32_w;
    derivatives->values[72] = M_12_w;
    derivatives->values[73] = M_12_c;
    derivatives->values[74] = C1_22_mH;
    derivatives->values[75] = t246;
    derivatives->values[76] = t249;
    derivatives->values[77] = t250;
    derivatives->values[78] = C1_22_xH;
    derivatives->values[79] = t254;
    derivatives->values[80] = K0_12_w;
    derivatives->values[81] = K0_12_c;
    derivatives->values[82] = K0_22_c;
    derivatives->values[83] = t260;
    derivatives->values[84] = C1_22_lam;
    derivatives->values[85] = t275;
    derivatives->values[86] = K0_22_w;
    derivatives->values[87] = K2_12_lam;
    derivatives->values[88] = K2_32_lam;
    derivatives->values[89] = C1_21_lam;
    derivatives->values[90] = t282;
    derivatives->values[91] = K0_12_zH;
    derivatives->values[92] = t284;
    derivatives->values[93] = t285;
    derivatives->values[94] = M_12_lam;
    derivatives->values[95] = K0_12_lam;
    derivatives->values[96] = t299;
    derivatives->values[97] = C1_22_vy_theta3_delta;
    derivatives->values[98] = M_22_vy_theta3_delta;
    derivatives->values[99] = t303;
    derivatives->values[100] = t304;
    derivatives->values[101] = t305;
    derivatives->values[102] = K2_22_xB;
    derivatives->values[103] = t307;
    derivatives->values[104] = M_22_xB;
    derivatives->values[105] = M_22_xU;
    derivatives->values[106] = t310;
    derivatives->values[107] = K2_22_lam;
    derivatives->values[108] = K0_22_lam;
    derivatives->values[109] = K2_22_h_spin_F;
    derivatives->values[110] = K2_22_mF;
    derivatives->values[111] = t320;
    derivatives->values[112] = t322;
    derivatives->values[113] = t324;
    derivatives->values[114] = K2_22_mB;
    derivatives->values[115] = C1_22_mB;
    derivatives->values[116] = t327;
    derivatives->values[117] = C1_22_xB;
    derivatives->values[118] = t330;
    derivatives->values[119] = t331;
    derivatives->values[120] = K2_22_xH;
    derivatives->values[121] = M_22_IHxx;
    derivatives->values[122] = K0_22_zH;
    derivatives->values[123] = t335;
    derivatives->values[124] = t336;
    derivatives->values[125] = M_22_IHzz;
    derivatives->values[126] = M_22_IFxx;
    derivatives->values[127] = M_22_IHxz;
    derivatives->values[128] = M_12_rF;
    derivatives->values[129] = M_22_rF;
    derivatives->values[130] = C1_12_IFyy;
    derivatives->values[131] = C1_21_rF;
    derivatives->values[132] = K2_12_IFyy;
    derivatives->values[133] = K2_22_IFyy;
    derivatives->values[134] = K2_12_rF;
    derivatives->values[135] = C1_12_rF;
    derivatives->values[136] = C1_22_rF;
    derivatives->values[137] = t353;
    derivatives->values[138] = t354;
    derivatives->values[139] = K2_22_rF;
    derivatives->values[140] = t356;
    derivatives->values[141] = M_12_mF;
    derivatives->values[142] = M_22_mF;
    derivatives->values[143] = t359;
    derivatives->values[144] = K2_12_mF;
    derivatives->values[145] = C1_12_mF;
    derivatives->values[146] = C1_22_mF;
    derivatives->values[147] = K2_32_zP;
    derivatives->values[148] = C1_32_zP;
    derivatives->values[149] = t366;
    derivatives->values[150] = t367;
    derivatives->values[151] = t368;
    derivatives->values[152] = t369;
    derivatives->values[153] = K2_22_mU;
    derivatives->values[154] = M_22_mU;
    derivatives->values[155] = t372;
    derivatives->values[156] = C1_22_mU;
    derivatives->values[157] = t374;
    derivatives->values[158] = t375;
    derivatives->values[159] = t376;
    derivatives->values[160] = t377;
    derivatives->values[161] = K2_22_xU;
    derivatives->values[162] = C1_22_xU;
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

static void whipple_leaning_f32_compute_linearization(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    const float forces[WHIPPLE_LEANING_FORCES], whipple_leaning_f32_linearization_t *linearization)
{
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t6 = motion->constants[7] * sin_phi;
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t14 = (motion->constants[3] * sin_pitch) + (motion->constants[2] * cos_pitch);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t18 = t14 * cos_phi;
    const float t21 = sin_phi * sin_delta;
    const float t22 = t21 - (cos_delta * t18);
    const float t26 = (motion->constants[3] * cos_pitch) - (sin_pitch * motion->constants[2]);
    const float t27 = cos_phi * t26;
    const float t30 = sqrtf((t22 * t22) + (t27 * t27));
    const float t31 = 1.0F / t30;
    const float t32 = t22 * t31;
    const float t34 = t27 * t31;
    const float t35 = cos_delta * t34;
    const float t37 = (t26 * t35) - (t14 * t32);
    const float t39 = sin_phi * cos_delta;
    const float t40 = t18 * sin_delta;
    const float t41 = t39 + t40;
    const float t42 = motion->constants[8] * t41;
    const float t45 = sin_delta * motion->constants[37];
    const float t51 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const float t53 = (t26 * motion->constants[39]) - (t14 * t51);
    const float t56 = (cos_phi * t45) - (t37 * t42) - (sin_phi * t53);
    const float t57 = t6 + t56;
    const float t58 = sin_delta * t34;
    const float t62 = (t26 * t32) + (t14 * t35);
    const float t64 = (cos_phi * t58) + (sin_phi * t62);
    const float t69 = (t42 * t64) + (t14 * motion->constants[39]) + (t26 * t51);
    const float t71 = 1.0F / (cos_phi * t69);
    const float t72 = t57 * t71;
    const float t78 = (t26 * motion->constants[31]) - (t14 * motion->constants[30]);
    const float t80 = t56 + (sin_phi * t78);
    const float t82 = sin_phi * t26;
    const float t85 = (t14 * motion->constants[31]) + (t26 * motion->constants[30]);
    const float t86 = t69 - t85;
    const float t89 = t71 * ((t14 * t80) + (t82 * t86));
    const float t91 = (speeds[0] * t72) + (speeds[1] * t89);
    const float t92 = speeds[3] + t91;
    const float t93 = motion->constants[7] * t92;
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t96 = t93 * sin_psi;
    const float t98 = motion->constants[7] * cos_psi;
    const float t99 = t71 * t72;
    const float t100 = sin_phi * t69;
    const float t106 = (sin_phi * t45) + (cos_phi * t53);
    const float t107 = t14 * t72;
    const float t108 = sin_phi * motion->constants[39];
    const float t110 = t26 * t72;
    const float t111 = sin_phi * t51;
    const float t113 = t37 * motion->constants[8];
    const float t114 = cos_delta * cos_phi;
    const float t115 = t14 * sin_delta;
    const float t117 = cos_phi * sin_delta;
    const float t120 = t114 + (t110 * t117) - (sin_phi * t115);
    const float t124 = t14 * cos_delta;
    const float t125 = sin_phi * t124;
    const float t128 = t31 * t114;
    const float t130 = t31 * t31;
    const float t131 = t22 * t130;
    const float t134 = t31 * 0.5F;
    const float t135 = (t27 + t27) * t134;
    const float t138 = t134 * (t22 + t22);
    const float t143 = cos_phi * t135;
    const float t145 = t114 * t138;
    const float t149 = (t117 * t138) - (sin_phi * ((t26 * t135) - (t124 * t138))) - (t107 * t143) -
        (t110 * t145);
    const float t153 = (t31 * t125) + (t31 * t117) - (t110 * t128) - (t131 * t149);
    const float t155 = cos_delta * t26;
    const float t157 = cos_phi * t31;
    const float t159 = t27 * t130;
    const float t162 = (t31 * t82) + (t107 * t157) + (t149 * t159);
    const float t166 = (t35 * t107) + (t32 * t110) + (t14 * t153) + (t155 * t162);
    const float t171 = (t107 * t108) + (t110 * t111) + (t42 * t166) - t106 - (t113 * t120);
    const float t173 = cos_phi * t99;
    const float t176 = motion->constants[8] * t64;
    const float t180 = sin_phi * t32;
    const float t182 = sin_phi * t35;
    const float t185 = t117 + t125;
    const float t191 = (cos_phi * t62) + (t110 * t182) + (t82 * t153) - (sin_phi * t58) - (t107 *
        t180) - (t162 * t185);
    const float t195 = (motion->constants[39] * t110) + (t120 * t176) + (t42 * t191) - (t51 * t107);
    const float t199 = (t99 * t100) + (motion->constants[7] * cos_phi * t71) + (t71 * t171) -
        (t173 * t195);
    const float t201 = t71 * t89;
    const float t203 = t26 * t86;
    const float t205 = t14 * t71;
    const float t211 = t71 * t82;
    const float t213 = sin_phi * motion->constants[31];
    const float t216 = (sin_phi * t71 * t86) + (t205 * t213) - (motion->constants[30] * t211);
    const float t220 = sin_phi * motion->constants[30];
    const float t223 = (t71 * t80) - (motion->constants[31] * t211) - (t205 * t220);
    const float t227 = t211 - (cos_phi * t201);
    const float t231 = (t100 * t201) + (cos_phi * ((t71 * t203) + (t78 * t205))) + (t110 * t223) +
        (t171 * t205);
    const float t233 = t231 + (t195 * t227) - (t107 * t216);
    const float t235 = (speeds[0] * t199) + (speeds[1] * t233);
    const float t238 = t14 * motion->constants[37];
    const float t240 = t14 * t89;
    const float t242 = t26 * t89;
    const float t245 = (t117 * t242) - t22;
    const float t247 = sin_delta * t26;
    const float t260 = (t39 * t138) + (t40 * t138) - (t143 * t240) - (t145 * t242);
    const float t264 = (t31 * t39) + (t31 * t40) - (t128 * t242) - (t131 * t260);
    const float t268 = (t157 * t240) + (t159 * t260);
    const float t273 = (t34 * t247) + (t35 * t240) + (t32 * t242) + (t14 * t264) + (t155 * t268);
    const float t279 = (motion->constants[37] * t114) + (t108 * t240) + (t111 * t242) + (t42 *
        t273) - (t21 * t238) - (t113 * t245);
    const float t286 = sin_phi * t14;
    const float t296 = (t34 * t114) + (t182 * t242) + (t82 * t264) - (t58 * t286) - (t180 * t240) -
        (t185 * t268);
    const float t301 = (motion->constants[39] * t242) + (t176 * t245) + (t42 * t296) -
        (motion->constants[37] * t247) - (t51 * t240);
    const float t303 = (t71 * t279) - (t173 * t301);
    const float t311 = (t223 * t242) + (t205 * t279) + (t227 * t301) - (t216 * t240);
    const float t313 = (speeds[0] * t303) + (speeds[1] * t311);
    const float t318 = motion->constants[7] * sin_psi;
    const float t325 = (t37 * t69) + (t57 * t64);
    const float t326 = 1.0F / t325;
    const float t327 = motion->constants[7] * t64;
    const float t328 = t326 * t327;
    const float t329 = t326 * t328;
    const float t330 = speeds[3] * t329;
    const float t339 = (cos_phi * t327) + (t64 * t171) + (t57 * t191) + (t37 * t195) - (t69 * t166);
    const float t341 = motion->constants[7] * t326;
    const float t342 = speeds[3] * t341;
    const float t344 = t72 * t326;
    const float t345 = sin_phi * t64;
    const float t351 = sin_phi * t57;
    const float t353 = sin_phi * t37;
    const float t357 = (cos_phi * (t325 + (motion->constants[7] * t345))) + (t171 * t345) + (t191 *
        t351) + (t195 * t353);
    const float t358 = t357 - (t100 * t166);
    const float t362 = (t37 * t100) + (t64 * t351);
    const float t363 = t326 * t362;
    const float t364 = t72 * t363;
    const float t365 = t326 * t364;
    const float t369 = (t344 * t358) + (t199 * t363) - (t339 * t365);
    const float t371 = t37 * t326;
    const float t373 = t64 * t326;
    const float t374 = t26 * t80;
    const float t376 = t53 - t78;
    const float t379 = (t82 * t373) - (t14 * t371);
    const float t387 = t106 + (t30 * motion->constants[8]) - (cos_phi * t78);
    const float t390 = (t26 * t387) + (t27 * t78);
    const float t397 = (cos_phi * t86) - (t27 * motion->constants[30]);
    const float t403 = (sin_phi * t387) + (cos_phi * t80) + (t27 * t213);
    const float t407 = (cos_phi * motion->constants[39]) - (cos_phi * motion->constants[31]);
    const float t410 = (t371 * t397) + (t373 * t403) + (t379 * t407);
    const float t413 = t387 + (t27 * motion->constants[31]);
    const float t415 = t27 * t220;
    const float t419 = (cos_phi * motion->constants[30]) - (cos_phi * t51);
    const float t422 = (t379 * t419) - (t371 * t413) - (t373 * t415);
    const float t424 = motion->constants[8] * t379;
    const float t428 = (t27 * t86) - (t14 * t387);
    const float t429 = t326 * t428;
    const float t431 = t27 * t373;
    const float t435 = (t82 * t387) + (t27 * t80);
    const float t436 = t326 * t435;
    const float t438 = t27 * t371;
    const float t440 = t89 * t326;
    const float t447 = t326 * ((t37 * t428) + (t64 * t435) + (t89 * t362));
    const float t448 = t326 * t447;
    const float t453 = (cos_phi * ((t373 * t390) + (t45 * t379))) + (t110 * t422) + (t149 * t424) +
        (t171 * t431);
    const float t458 = t453 + (t191 * t436) + (t195 * t438) + (t358 * t440) + (t233 * t363) -
        (sin_phi * ((t203 * t371) + (t373 * t374) + (t376 * t379)));
    const float t461 = t458 - (t107 * t410) - (t166 * t429) - (t339 * t448);
    const float t465 = (t330 * t339) - ((t191 * t342) + (speeds[0] * t369) + (speeds[1] * t461));
    const float t472 = (t64 * t279) + (t57 * t296) + (t37 * t301) - (t69 * t273);
    const float t481 = (t279 * t345) + (t296 * t351) + (t301 * t353) - (t100 * t273);
    const float t486 = (t344 * t481) + (t303 * t363) - (t365 * t472);
    const float t488 = motion->constants[37] * t39;
    const float t490 = t238 * t117;
    const float t506 = (t379 * t488) + (t379 * t490) + (t242 * t422) + (t260 * t424) + (t279 *
        t431) + (t296 * t436);
    const float t511 = t506 + (t301 * t438) + (t440 * t481) + (t311 * t363) - (t240 * t410) -
        (t273 * t429);
    const float t512 = t511 - (t448 * t472);
    const float t516 = (t330 * t472) - ((t296 * t342) + (speeds[0] * t486) + (speeds[1] * t512));
    const float t518 = 1.0F / motion->constants[8];
    const float t519 = motion->constants[7] * t518;
    const float t523 = (t64 * t69) - (t37 * t57);
    const float t524 = t518 * t523;
    const float t525 = t341 * t524;
    const float t527 = t328 * t518;
    const float t528 = motion->constants[7] * t37;
    const float t537 = (t57 * t166) + (t69 * t191) + (t64 * t195) - (cos_phi * t528) - (t37 * t171);
    const float t539 = t329 * t524;
    const float t543 = (t191 * t525) + (t527 * t537) - (t166 * t519) - (t339 * t539);
    const float t545 = speeds[0] * t518;
    const float t555 = (cos_phi * (t523 - (motion->constants[7] * t353))) + (t166 * t351) + (t100 *
        t191) + (t195 * t345);
    const float t556 = t555 - (t171 * t353);
    const float t561 = (t64 * t100) - (t37 * t351);
    const float t566 = (t364 * t537) + (t369 * t523) - (t72 * t556) - (t199 * t561);
    const float t568 = speeds[1] * t518;
    const float t573 = (t14 * t64) + (t37 * t82);
    const float t586 = (t37 * t403) + (t407 * t573) - (t64 * t397);
    const float t592 = (t64 * t413) + (t419 * t573) - (t37 * t415);
    const float t594 = motion->constants[8] * t573;
    const float t597 = t27 * t37;
    const float t600 = t27 * t64;
    const float t608 = (cos_phi * ((t37 * t390) + (t45 * t573))) + (t110 * t592) + (t149 * t594) +
        (t171 * t597);
    const float t612 = t608 + (t447 * t537) + (t461 * t523) - (sin_phi * ((t37 * t374) + (t376 *
        t573) - (t64 * t203))) - (t107 * t586);
    const float t617 = t612 - (t166 * t435) - (t191 * t428) - (t195 * t600) - (t89 * t556) - (t233 *
        t561);
    const float t620 = (speeds[3] * t543) + (t545 * t566) + (t568 * t617);
    const float t629 = (t57 * t273) + (t69 * t296) + (t64 * t301) - (t37 * t279);
    const float t634 = (t296 * t525) + (t527 * t629) - (t273 * t519) - (t472 * t539);
    const float t642 = (t273 * t351) + (t100 * t296) + (t301 * t345) - (t279 * t353);
    const float t649 = (t364 * t629) + (t486 * t523) - (t72 * t642) - (t303 * t561);
    const float t668 = (t488 * t573) + (t490 * t573) + (t242 * t592) + (t260 * t594) + (t279 *
        t597) + (t447 * t629);
    const float t673 = t668 + (t512 * t523) - (t240 * t586) - (t273 * t435) - (t296 * t428) -
        (t301 * t600);
    const float t675 = t673 - (t89 * t642) - (t311 * t561);
    const float t678 = (speeds[3] * t634) + (t545 * t649) + (t568 * t675);
    const float t682 = t518 * ((t364 * t523) - (t72 * t561));
    const float t690 = t518 * ((t37 * t435) + (t447 * t523) - (t64 * t428) - (t89 * t561));
    const float t693 = t518 * (t528 + (t328 * t523));
    float sin_theta = 0.0F;
    float cos_theta = 0.0F;
    carvallo_sin_cos_f32(positions[6], &sin_theta, &cos_theta);
    const float t698 = 1.0F - cos_theta;
    const float t701 = cos_theta + (t698 * motion->constants[34]);
    const float t705 = t698 * motion->constants[35];
    const float t707 = t705 * motion->constants[57];
    const float t711 = motion->constants[2] * sin_theta;
    const float t721 = sin_delta * motion->constants[66];
    const float t722 = sin_delta * t721;
    const float t725 = t705 * motion->constants[54];
    const float t728 = cos_theta + (t698 * motion->constants[36]);
    const float t731 = t725 + (t728 * motion->constants[55]);
    const float t732 = motion->constants[33] * t731;
    const float t737 = t732 + t732 + motion->constants[63] + motion->constants[68];
    const float t741 = motion->constants[45] + motion->constants[50] + (t701 * ((t701 *
        motion->constants[56]) + t707)) + (t711 * t711 * motion->constants[58]) + (t705 * ((t701 *
        motion->constants[57]) + (t705 * motion->constants[59])));
    const float t743 = t741 + t737 - t722;
    const float t748 = (motion->constants[56] * t705) + (motion->constants[57] * t728);
    const float t750 = motion->constants[3] * sin_theta;
    const float t751 = motion->constants[58] * t750;
    const float t754 = t707 + (motion->constants[59] * t728);
    const float t760 = t705 * motion->constants[55];
    const float t761 = (t701 * motion->constants[54]) + t760;
    const float t764 = cos_delta * motion->constants[48];
    const float t765 = motion->constants[30] * t764;
    const float t766 = (motion->constants[32] * t761) - t765;
    const float t769 = motion->constants[65] + motion->constants[71] - t766 - t766;
    const float t774 = motion->constants[46] + motion->constants[53] + (t705 * t748) + (t750 *
        t751) + (t728 * t754) + t769;
    const float t775 = t774 - t743;
    const float t776 = t14 * t14;
    const float t778 = t14 * t26;
    const float t791 = (cos_delta * motion->constants[51]) - (motion->constants[31] * t764);
    const float t796 = motion->constants[42] + (t701 * t748) + (t705 * t754) + (t731 *
        motion->constants[32]) + motion->constants[64] + t791;
    const float t800 = t796 - (t711 * t751) - (motion->constants[33] * t761) -
        motion->constants[69] - motion->constants[70];
    const float t801 = t800 + t800;
    const float t803 = (t775 * t776) + (t778 * t801);
    const float t809 = t731 + motion->constants[41] + motion->constants[62] + motion->constants[72];
    const float t814 = motion->constants[40] + motion->constants[67];
    const float t817 = t761 + t764 + t814 - motion->constants[61];
    const float t819 = (t26 * t809) - (t14 * t817);
    const float t820 = motion->constants[7] * t819;
    const float t823 = motion->constants[74] - t820 - t820;
    const float t829 = (t711 * motion->constants[54]) - (motion->constants[55] * t750);
    const float t832 = sin_delta * motion->constants[48];
    const float t833 = motion->constants[31] * t832;
    const float t834 = (sin_delta * motion->constants[51]) - t833;
    const float t838 = (t711 * t748) + (cos_theta * t751) + t834 - (t750 * t754) -
        (motion->constants[33] * t829);
    const float t842 = (motion->constants[56] * t711) - (motion->constants[57] * t750);
    const float t844 = cos_theta * motion->constants[58];
    const float t848 = (motion->constants[57] * t711) - (motion->constants[59] * t750);
    const float t857 = (t701 * t842) + (t705 * t848) + (motion->constants[32] * t829) + (cos_delta *
        t721) - (t711 * t844) - (motion->constants[30] * t832);
    const float t859 = (t14 * t838) + (t26 * t857);
    const float t861 = t72 - (sin_phi * t364);
    const float t871 = t800 + (t775 * t778) + (motion->constants[7] * ((t14 * t809) + (t26 *
        t817))) - (t776 * t801);
    const float t872 = cos_phi * t364;
    const float t884 = t722 + t737 + t769 + t823 + motion->constants[43] + motion->constants[52] +
        (t711 * t842);
    const float t886 = t884 + (cos_theta * t844) - (t750 * t848);
    const float t891 = motion->constants[7] * (t829 + t832);
    const float t893 = (t26 * t838) + t891 - (t14 * t857);
    const float t899 = t774 - t803;
    const float t905 = t861 * motion->constants[27];
    const float t910 = t247 + (t115 * t872) - (cos_delta * t861);
    const float t911 = t682 - t910;
    const float t913 = t911 * motion->constants[28];
    const float t919 = t743 + t803 + t823 + (t859 * t861) + (t861 * (t859 + (t861 * t886) - (t872 *
        t893))) + (t861 * t905);
    const float t922 = t919 + (t911 * t913) - (t871 * t872) - (t872 * (t871 + (t861 * t893) -
        (t872 * t899)));
    const float t923 = 1.0F / t922;
    const float t924 = speeds[0] * t26;
    const float t929 = (speeds[0] * t364) + (speeds[1] * t447) + (speeds[3] * t328);
    const float t930 = cos_phi * t929;
    const float t932 = t924 + (t14 * t930);
    const float t933 = sin_phi * t929;
    const float t934 = t91 - t933;
    const float t938 = (motion->constants[43] * t934) + (motion->constants[27] * (speeds[3] +
        t934));
    const float t942 = speeds[0] * t14;
    const float t943 = t942 - (t26 * t930);
    const float t944 = motion->constants[42] * t943;
    const float t945 = (motion->constants[45] * t932) + t944;
    const float t947 = (t932 * t938) - (t934 * t945);
    const float t950 = (cos_delta * t932) + (sin_delta * t934);
    const float t953 = (cos_delta * t934) - (sin_delta * t932);
    const float t959 = (speeds[0] * t682) + (speeds[1] * t690) + (speeds[3] * t693);
    const float t960 = t953 + t959;
    const float t962 = (motion->constants[52] * t953) + (motion->constants[28] * t960);
    const float t965 = speeds[1] + t943;
    const float t966 = motion->constants[51] * t965;
    const float t967 = (motion->constants[50] * t950) + t966;
    const float t969 = (t950 * t962) - (t953 * t967);
    const float t970 = motion->constants[7] * t933;
    const float t971 = t930 * t970;
    const float t973 = sin_phi * motion->constants[60];
    const float t974 = t92 * t930;
    const float t977 = t971 - (motion->constants[7] * t974);
    const float t978 = t973 + t977;
    const float t980 = t91 * t943;
    const float t981 = speeds[0] * t933;
    const float t982 = motion->constants[31] * t934;
    const float t984 = motion->constants[30] * t934;
    const float t986 = (t943 * t982) + (t932 * t984);
    const float t988 = t91 * t932;
    const float t989 = (t26 * t981) + t988;
    const float t992 = t980 + (t14 * t981);
    const float t996 = t986 + (motion->constants[30] * t989) + (motion->constants[31] * t992) -
        t977;
    const float t999 = motion->constants[30] * t943;
    const float t1000 = motion->constants[31] * t932;
    const float t1001 = t999 - t1000;
    const float t1003 = (t934 * t984) + (t943 * t1001);
    const float t1004 = speeds[0] * t930;
    const float t1007 = motion->constants[7] * speeds[0];
    const float t1008 = t930 * t1007;
    const float t1009 = (motion->constants[7] * t1004) + t1008;
    const float t1012 = t92 - t933;
    const float t1014 = (t970 * t1012) - (speeds[0] * t1007);
    const float t1018 = (t26 * t1009) + (t14 * t1014) - t1003 - (motion->constants[31] * t1004);
    const float t1021 = t953 * motion->constants[38];
    const float t1023 = motion->constants[37] * t953;
    const float t1026 = cos_delta * t992;
    const float t1027 = sin_delta * t1004;
    const float t1028 = speeds[1] * t953;
    const float t1030 = t1028 - t1026 - t1027;
    const float t1032 = t32 * motion->constants[8];
    const float t1034 = t989 + (t950 * t959);
    const float t1036 = t34 * motion->constants[8];
    const float t1038 = t1030 - (t959 * t965);
    const float t1040 = t31 * t41;
    const float t1043 = (t32 * t950) + (t34 * t965);
    const float t1045 = motion->constants[8] * t1040 * t1043;
    const float t1046 = t34 * t1045;
    const float t1048 = t32 * t1045;
    const float t1054 = (cos_delta * t996) + (t965 * t1021) + (t950 * t1023) +
        (motion->constants[37] * t989) + (t1032 * t1034) + (t965 * t1046);
    const float t1058 = t1054 + (t950 * t1048) - (sin_delta * t1018) - (motion->constants[38] *
        t1030) - (t1036 * t1038);
    const float t1063 = motion->constants[37] * t965;
    const float t1064 = t950 * motion->constants[38];
    const float t1065 = t1063 - t1064;
    const float t1069 = speeds[1] * t950;
    const float t1071 = (sin_delta * t992) - (cos_delta * t1004) - t1069;
    const float t1078 = motion->constants[8] * ((t32 * t965) - (t34 * t950));
    const float t1084 = (cos_delta * t1018) + (sin_delta * t996) + (motion->constants[38] * t1071) +
        (t1036 * t1071) - (t953 * t1023) - (t965 * t1065);
    const float t1086 = t1084 - (t960 * t1048) - (t965 * t1078);
    const float t1090 = (t932 * t1001) - (t934 * t982);
    const float t1104 = t1090 + (motion->constants[30] * t1004) + (t14 * t1009) + (t950 * t1065) +
        (t950 * t1078) - (t26 * t1014);
    const float t1108 = t1104 - (t953 * t1021) - (motion->constants[37] * t1071) - (t1032 * t1071) -
        (t960 * t1046);
    const float t1110 = (t32 * t1086) + (t34 * t1108);
    const float t1115 = t71 * ((t41 * t1058) + (t30 * t1110));
    const float t1119 = t326 * ((t30 * t1058) + (t362 * t1115) - (t41 * t1110));
    const float t1121 = t981 - (cos_phi * t1119);
    const float t1123 = t980 + (t14 * t1121);
    const float t1126 = t988 + (t26 * t1121);
    const float t1132 = t986 + (motion->constants[30] * t1126) + (motion->constants[31] * t1123) -
        t978;
    const float t1135 = t1004 - t1115;
    const float t1136 = (sin_phi * t1119) + t1135;
    const float t1139 = (motion->constants[7] * t1136) + t1008;
    const float t1142 = t1014 + (cos_phi * motion->constants[60]);
    const float t1143 = t14 * t1142;
    const float t1144 = t1143 + (t26 * t1139);
    const float t1146 = t1144 - (motion->constants[31] * t1136) - t1003;
    const float t1148 = (cos_delta * t1132) - (sin_delta * t1146);
    const float t1153 = t1028 - (sin_delta * t1136) - (cos_delta * t1123);
    const float t1158 = t969 + (motion->constants[48] * t1148) + (motion->constants[51] * t1153) +
        (motion->constants[53] * t1126);
    const float t1159 = motion->constants[32] * t934;
    const float t1161 = motion->constants[32] * t943;
    const float t1162 = motion->constants[33] * t932;
    const float t1163 = t1161 + t1162;
    const float t1165 = (t934 * t1159) + (t943 * t1163);
    const float t1168 = t1144 + t1165 - (motion->constants[33] * t1136);
    const float t1170 = motion->constants[33] * t934;
    const float t1173 = (t943 * t1170) - (t932 * t1159);
    const float t1178 = t1173 + (motion->constants[33] * t1123) - t978 - (motion->constants[32] *
        t1126);
    const float t1182 = (t932 * t1163) + (t934 * t1170);
    const float t1184 = t26 * t1142;
    const float t1186 = t1184 - (t14 * t1139);
    const float t1188 = (motion->constants[32] * t1136) + t1182 + t1186;
    const float t1191 = (cos_theta * t1178) - (t750 * t1188) - (t711 * t1168);
    const float t1198 = (cos_theta * t934) + (t750 * t943) - (t711 * t932);
    const float t1199 = motion->constants[2] * t1198;
    const float t1200 = speeds[2] * t1199;
    const float t1206 = t1200 - (t711 * t1136) + (t705 * t1126) - (t701 * t1123);
    const float t1208 = motion->constants[3] * t1198;
    const float t1209 = speeds[2] * t1208;
    const float t1215 = (t728 * t1126) - t1209 - (t705 * t1123) + (t750 * t1136);
    const float t1220 = motion->constants[3] * speeds[2];
    const float t1223 = (t701 * t932) + (t711 * t934) + (t705 * t943) + t1220;
    const float t1224 = motion->constants[57] * t1223;
    const float t1228 = motion->constants[2] * speeds[2];
    const float t1231 = (t705 * t932) + (t728 * t943) + t1228 - (t750 * t934);
    const float t1233 = t1224 + (motion->constants[59] * t1231);
    const float t1235 = motion->constants[58] * t1198;
    const float t1237 = (t1198 * t1233) - (t1231 * t1235);
    const float t1240 = (motion->constants[56] * t1206) + (motion->constants[57] * t1215) + t1237 -
        (motion->constants[55] * t1191);
    const float t1246 = (t701 * t1168) + (t711 * t1178) - (t705 * t1188);
    const float t1252 = (t705 * t1168) - (t728 * t1188) - (t750 * t1178);
    const float t1256 = (motion->constants[3] * t1231) - (motion->constants[2] * t1223);
    const float t1257 = speeds[2] * t1256;
    const float t1263 = t1257 + (t711 * t1123) - (cos_theta * t1136) + (t750 * t1126);
    const float t1266 = motion->constants[57] * t1231;
    const float t1267 = (motion->constants[56] * t1223) + t1266;
    const float t1270 = (t1231 * t1267) - (t1223 * t1233);
    const float t1273 = (motion->constants[55] * t1246) + (motion->constants[58] * t1263) + t1270 -
        (motion->constants[54] * t1252);
    const float t1280 = (t1223 * t1235) - (t1198 * t1267);
    const float t1283 = (motion->constants[54] * t1191) + (motion->constants[57] * t1206) +
        (motion->constants[59] * t1215) + t1280;
    const float t1288 = motion->constants[54] * t1198;
    const float t1290 = motion->constants[54] * t1231;
    const float t1291 = motion->constants[55] * t1223;
    const float t1292 = t1290 - t1291;
    const float t1294 = (t1198 * t1288) + (t1231 * t1292);
    const float t1296 = (t1246 * motion->constants[24]) + (motion->constants[55] * t1263) - t1294;
    const float t1301 = motion->constants[55] * t1198;
    const float t1304 = (t1231 * t1301) + (t1223 * t1288);
    const float t1307 = (t1191 * motion->constants[24]) + (motion->constants[54] * t1215) + t1304 -
        (motion->constants[55] * t1206);
    const float t1313 = (t1223 * t1292) - (t1198 * t1301);
    const float t1315 = (t1252 * motion->constants[24]) + t1313 - (motion->constants[54] * t1263);
    const float t1318 = (t711 * t1296) + (cos_theta * t1307) - (t750 * t1315);
    const float t1323 = (cos_delta * t1146) + (sin_delta * t1132);
    const float t1329 = (sin_delta * t1123) - (cos_delta * t1136) - t1069;
    const float t1331 = motion->constants[48] * t953;
    const float t1333 = motion->constants[48] * t965;
    const float t1334 = t950 * motion->constants[49];
    const float t1335 = t1333 - t1334;
    const float t1337 = (t953 * t1331) + (t965 * t1335);
    const float t1339 = (motion->constants[47] * t1323) + (motion->constants[49] * t1329) - t1337;
    const float t1344 = t953 * motion->constants[49];
    const float t1347 = (t965 * t1344) + (t950 * t1331);
    const float t1350 = (t1148 * motion->constants[47]) + (motion->constants[48] * t1126) + t1347 -
        (t1153 * motion->constants[49]);
    const float t1352 = (sin_delta * t1339) + (cos_delta * t1350);
    const float t1358 = t947 + (motion->constants[46] * t1126) + t1158 + (t705 * t1240) + (t750 *
        t1273) + (t728 * t1283);
    const float t1362 = t1358 + (motion->constants[30] * t1352) - (motion->constants[40] * t978) -
        (motion->constants[42] * t1123) - (motion->constants[32] * t1318);
    const float t1367 = motion->constants[42] * t932;
    const float t1369 = t1367 + (motion->constants[46] * t943);
    const float t1372 = (t934 * t1369) - (t938 * t943);
    const float t1380 = motion->constants[51] * t950;
    const float t1382 = t1380 + (motion->constants[53] * t965);
    const float t1385 = (t953 * t1382) - (t962 * t965);
    const float t1388 = (motion->constants[50] * t1153) + (motion->constants[51] * t1126) + t1385 -
        (t1148 * motion->constants[49]);
    const float t1393 = t1090 - t1186 + (motion->constants[30] * t1136);
    const float t1403 = t518 * ((t32 * t1108) + (t523 * t1119) - (t34 * t1086) - (t561 * t1115));
    const float t1405 = motion->constants[28] * (t1329 + t1403);
    const float t1408 = (t965 * t967) - (t950 * t1382);
    const float t1412 = (t1323 * motion->constants[49]) + (motion->constants[52] * t1329) + t1405 +
        t1408 - (motion->constants[48] * t1393);
    const float t1419 = (motion->constants[41] * t978) + (motion->constants[42] * t1126) + t1372 +
        (t701 * t1240) + (t705 * t1283) + (cos_delta * t1388);
    const float t1424 = t1419 - (motion->constants[45] * t1123) - (t711 * t1273) -
        (motion->constants[33] * t1318) - (sin_delta * t1412) - (motion->constants[31] * t1352);
    const float t1430 = motion->constants[41] * t934;
    const float t1432 = motion->constants[40] * t934;
    const float t1439 = t1318 + t1352 + (motion->constants[40] * t1126) + (motion->constants[41] *
        t1123) + (t943 * t1430) + (t932 * t1432) - (t978 * motion->constants[44]);
    const float t1446 = (t943 * t945) - (t932 * t1369);
    const float t1454 = (t701 * t1296) + (t705 * t1315) - (t711 * t1307);
    const float t1460 = (t705 * t1296) + (t750 * t1307) + (t728 * t1315);
    const float t1466 = (cos_delta * t1339) - (sin_delta * t1350);
    const float t1472 = (t950 * t1335) - (t953 * t1344);
    const float t1474 = (motion->constants[47] * t1393) + t1472 - (motion->constants[48] * t1329);
    const float t1479 = motion->constants[40] * t943;
    const float t1480 = motion->constants[41] * t932;
    const float t1481 = t1479 - t1480;
    const float t1484 = (t932 * t1481) - (t934 * t1430);
    const float t1494 = (t934 * t1432) + (t943 * t1481);
    const float t1500 = (t14 * (t1460 + t1474 + t1484 - (t1186 * motion->constants[44]) +
        (motion->constants[40] * t1136))) + (t26 * (t1454 + t1466 + (t1144 *
        motion->constants[44]) - (motion->constants[41] * t1136) - t1494));
    const float t1502 = (motion->constants[27] * t1136) + (motion->constants[7] * t1500);
    const float t1507 = (motion->constants[41] * t1144) + (motion->constants[40] * t1186) -
        (motion->constants[43] * t1136) + t1446 + (t711 * t1240) + (cos_theta * t1273);
    const float t1512 = t1507 + (motion->constants[33] * t1454) + (motion->constants[32] * t1460) +
        (sin_delta * t1388) + (cos_delta * t1412) + (motion->constants[31] * t1466);
    const float t1515 = t1512 - t1502 - (t750 * t1283) - (motion->constants[30] * t1474);
    const float t1519 = (t26 * t1362) - (t14 * t1424);
    const float t1526 = forces[0] + (t872 * t1519) - (t14 * t1362) - (t26 * t1424) -
        (motion->constants[7] * t1439) - (t861 * t1515);
    const float t1527 = t1526 - (t682 * t1405);
    const float t1529 = motion->constants[53] + t765;
    const float t1534 = t89 - (sin_phi * t447);
    const float t1536 = cos_phi * t447;
    const float t1538 = t26 * t832;
    const float t1539 = motion->constants[7] * t1538;
    const float t1540 = t834 + t1539;
    const float t1544 = t1540 + (t886 * t1534) - (t893 * t1536);
    const float t1548 = (t26 * t1529) - (t14 * t791);
    const float t1552 = t1548 + (t893 * t1534) - (t899 * t1536);
    const float t1557 = (cos_delta * t1534) - (t115 * t1536);
    const float t1558 = t690 + t1557;
    const float t1564 = (t14 * t1529) + (t26 * t791) + (motion->constants[7] * t764) + (t859 *
        t1534) + (t861 * t1544) + (t905 * t1534);
    const float t1568 = t923 * (t1564 + (t913 * t1558) - (t871 * t1536) - (t872 * t1552));
    const float t1573 = motion->constants[27] * t1534;
    const float t1575 = motion->constants[28] * t1558;
    const float t1577 = t922 * t1568;
    const float t1583 = motion->constants[53] + (t1534 * t1544) + (t1534 * t1540) + (t1534 *
        t1573) + (t1558 * t1575) - (t1536 * t1552);
    const float t1585 = t1583 - (t1536 * t1548) - (t1568 * t1577);
    const float t1586 = 1.0F / t1585;
    const float t1596 = forces[1] + (t1519 * t1536) - t1158 - (t1515 * t1534) - (t690 * t1405) -
        (t1527 * t1568);
    const float t1599 = t711 * motion->constants[75];
    const float t1601 = t750 * motion->constants[75];
    const float t1606 = motion->constants[7] * ((t14 * t1601) - (t26 * t1599));
    const float t1611 = (t711 * motion->constants[76]) - (t750 * motion->constants[77]);
    const float t1614 = (motion->constants[32] * t1601) + t1611 - (motion->constants[33] * t1599) -
        t1606;
    const float t1616 = cos_theta * motion->constants[75];
    const float t1620 = (t705 * motion->constants[76]) + (t728 * motion->constants[77]);
    const float t1621 = t1620 - (motion->constants[32] * t1616);
    const float t1626 = (t701 * motion->constants[76]) + (t705 * motion->constants[77]);
    const float t1627 = t1626 - (motion->constants[33] * t1616);
    const float t1629 = (t26 * t1621) - (t14 * t1627);
    const float t1640 = t923 * ((t14 * t1621) + (t26 * t1627) + (motion->constants[7] * t1616) +
        (t861 * t1614) - (t872 * t1629));
    const float t1644 = t1586 * ((t1534 * t1614) - (t1536 * t1629) - (t1577 * t1640));
    const float t1646 = t922 * t1640;
    const float t1648 = t1585 * t1644;
    const float t1651 = motion->constants[78] - (t1640 * t1646) - (t1644 * t1648);
    const float t1652 = 1.0F / t1651;
    const float t1666 = forces[2] - (motion->constants[3] * t1240) - (motion->constants[2] *
        t1283) - (positions[6] * motion->constants[5]) - (speeds[2] * motion->constants[6]) -
        (t1527 * t1640);
    const float t1667 = t1666 - (t1596 * t1644);
    const float t1669 = sin_phi * t328;
    const float t1671 = cos_phi * t328;
    const float t1677 = motion->constants[7] * (t819 - motion->constants[73]);
    const float t1681 = t1677 + (t886 * t1669) + (t893 * t1671);
    const float t1686 = t891 - (t893 * t1669) - (t899 * t1671);
    const float t1688 = 1.0F - t1669;
    const float t1692 = (cos_delta * t1669) + (t115 * t1671);
    const float t1693 = t693 - t1692;
    const float t1699 = (t905 * t1688) + (t913 * t1693) - (t859 * t1669) - (t871 * t1671) - (t861 *
        t1681) - (t872 * t1686);
    const float t1700 = t923 * t1699;
    const float t1713 = t1539 + (t1573 * t1688) + (t1575 * t1693) - (t1534 * t1681) - (t1536 *
        t1686) - (t1540 * t1669);
    const float t1716 = t1586 * (t1713 - (t1548 * t1671) - (t1577 * t1700));
    const float t1722 = t1652 * (t1606 + (t1614 * t1669) + (t1629 * t1671) + (t1646 * t1700) +
        (t1648 * t1716));
    const float t1733 = (t1515 * t1669) + (t1519 * t1671) + (t1667 * t1722) + t1502 - (t693 *
        t1405) - (t1527 * t1700);
    const float t1754 = (t1669 * t1681) + (t1669 * t1677) + motion->constants[79] +
        (motion->constants[27] * t1688 * t1688) + (motion->constants[28] * t1693 * t1693) - (t1671 *
        t1686);
    const float t1759 = 1.0F / (t1754 - (t891 * t1671) - (t922 * t1700 * t1700) - (t1585 * t1716 *
        t1716) - (t1651 * t1722 * t1722));
    const float t1760 = (t1733 - (t1596 * t1716)) * t1759;
    const float t1762 = (t1652 * t1667) + (t1722 * t1760);
    const float t1766 = (t1586 * t1596) - (t1644 * t1762) - (t1716 * t1760);
    const float t1772 = (t923 * t1527) - (t1568 * t1766) - (t1640 * t1762) - (t1700 * t1760);
    const float t1776 = t971 + t973 - (motion->constants[7] * (t974 + t1772));
    const float t1784 = t1119 + (t364 * t1772) + (t447 * t1766) + (t328 * t1760);
    const float t1786 = t981 - (cos_phi * t1784);
    const float t1789 = (t26 * t1772) - t980 - (t14 * t1786);
    const float t1794 = t988 + (t26 * t1786) + (t14 * t1772);
    const float t1800 = t986 + (motion->constants[30] * t1794) - t1776 - (motion->constants[31] *
        t1789);
    const float t1807 = (t72 * t1772) + (t89 * t1766) - (sin_phi * t1784) - t1135;
    const float t1809 = t1760 + t1807;
    const float t1811 = (motion->constants[7] * t1809) - t1008;
    const float t1813 = t1143 - (t26 * t1811);
    const float t1815 = (motion->constants[31] * t1807) + t1813 - t1003;
    const float t1817 = (cos_delta * t1800) - (sin_delta * t1815);
    const float t1821 = (cos_delta * t1789) + (sin_delta * t1807);
    const float t1822 = t1028 + t1821;
    const float t1824 = t1766 + t1794;
    const float t1828 = t1165 + t1813 + (motion->constants[33] * t1807);
    const float t1834 = t1173 - t1776 - (motion->constants[32] * t1794) - (motion->constants[33] *
        t1789);
    const float t1838 = t1184 + (t14 * t1811);
    const float t1840 = (motion->constants[32] * t1807) - t1182 - t1838;
    const float t1843 = (cos_theta * t1834) + (t750 * t1840) - (t711 * t1828);
    const float t1852 = t1200 + (t701 * t1789) + (t711 * t1807) + (t705 * t1794) +
        (motion->constants[3] * t1762);
    const float t1861 = (t705 * t1789) + (t728 * t1794) + (motion->constants[2] * t1762) - t1209 -
        (t750 * t1807);
    const float t1865 = t1237 + (motion->constants[56] * t1852) + (motion->constants[57] * t1861) -
        (motion->constants[55] * t1843);
    const float t1871 = (t701 * t1828) + (t711 * t1834) + (t705 * t1840);
    const float t1877 = (t705 * t1828) + (t728 * t1840) - (t750 * t1834);
    const float t1884 = t1257 + (cos_theta * t1807) + (t750 * t1794) - (t711 * t1789);
    const float t1888 = t1270 + (motion->constants[55] * t1871) + (motion->constants[58] * t1884) -
        (motion->constants[54] * t1877);
    const float t1895 = t1280 + (motion->constants[54] * t1843) + (motion->constants[57] * t1852) +
        (motion->constants[59] * t1861);
    const float t1900 = (motion->constants[24] * t1871) + (motion->constants[55] * t1884) - t1294;
    const float t1907 = t1304 + (motion->constants[24] * t1843) + (motion->constants[54] * t1861) -
        (motion->constants[55] * t1852);
    const float t1912 = t1313 + (motion->constants[24] * t1877) - (motion->constants[54] * t1884);
    const float t1915 = (t711 * t1900) + (cos_theta * t1907) - (t750 * t1912);
    const float t1919 = (cos_delta * t1815) + (sin_delta * t1800);
    const float t1923 = (cos_delta * t1807) - (sin_delta * t1789);
    const float t1924 = t1923 - t1069;
    const float t1927 = (motion->constants[47] * t1919) + (motion->constants[49] * t1924) - t1337;
    const float t1934 = t1347 + (motion->constants[47] * t1817) + (motion->constants[48] * t1824) -
        (motion->constants[49] * t1822);
    const float t1936 = (sin_delta * t1927) + (cos_delta * t1934);
    const float t1943 = t947 + t969 + (motion->constants[42] * t1789) + (motion->constants[46] *
        t1794) + (motion->constants[48] * t1817) + (motion->constants[51] * t1822) +
        (motion->constants[53] * t1824);
    const float t1948 = t1943 + (t705 * t1865) + (t750 * t1888) + (t728 * t1895) +
        (motion->constants[30] * t1936) - (motion->constants[40] * t1776);
    const float t1949 = t1948 - (motion->constants[32] * t1915);
    const float t1963 = t1385 + (motion->constants[50] * t1822) + (motion->constants[51] * t1824) -
        (motion->constants[49] * t1817);
    const float t1968 = t1090 - t1838 - (motion->constants[30] * t1807);
    const float t1978 = motion->constants[28] * (t1403 + t1924 + (t682 * t1772) + (t690 * t1766) +
        (t693 * t1760));
    const float t1982 = t1408 + (motion->constants[49] * t1919) + (motion->constants[52] * t1924) +
        t1978 - (motion->constants[48] * t1968);
    const float t1984 = (cos_delta * t1963) - (sin_delta * t1982);
    const float t1990 = t1372 + (motion->constants[41] * t1776) + (motion->constants[45] * t1789) +
        (motion->constants[42] * t1794) + (t701 * t1865) + (t705 * t1895);
    const float t1994 = t1990 + t1984 - (t711 * t1888) - (motion->constants[33] * t1915) -
        (motion->constants[31] * t1936);
    const float t1996 = (t26 * t1949) - (t14 * t1994);
    const float t1997 = sin_phi * t1996;
    const float t2010 = (t701 * t1900) + (t705 * t1912) - (t711 * t1907);
    const float t2016 = (t705 * t1900) + (t750 * t1907) + (t728 * t1912);
    const float t2019 = cos_delta * t1982;
    const float t2022 = (cos_delta * t1927) - (sin_delta * t1934);
    const float t2027 = t1472 + (motion->constants[47] * t1968) - (motion->constants[48] * t1924);
    const float t2034 = t1484 + t2016 + t2027 - (motion->constants[44] * t1838) -
        (motion->constants[40] * t1807);
    const float t2041 = t2010 + t2022 + (motion->constants[44] * t1813) + (motion->constants[41] *
        t1807) - t1494;
    const float t2049 = t1446 + (motion->constants[41] * t1813) + (motion->constants[40] * t1838) +
        (motion->constants[43] * t1807) + (motion->constants[27] * t1809) + (t711 * t1865);
    const float t2054 = t2049 + (cos_theta * t1888) + (motion->constants[33] * t2010) +
        (motion->constants[32] * t2016) + (sin_delta * t1963) + t2019;
    const float t2058 = t2054 + (motion->constants[31] * t2022) - (t750 * t1895) -
        (motion->constants[30] * t2027) - (motion->constants[7] * ((t14 * t2034) + (t26 * t2041)));
    const float t2059 = cos_phi * t2058;
    const float t2066 = (sin_phi * t2058) + (cos_phi * t1996);
    const float t2068 = t518 * t1978;
    const float t2072 = (t107 * t1949) + (t110 * t1994);
    const float t2074 = motion->constants[7] * t861;
    const float t2077 = (t110 * t2034) - (t107 * t2041);
    const float t2079 = t326 * t1110;
    const float t2080 = t524 * t2079;
    const float t2082 = t326 * t1058;
    const float t2083 = t524 * t2082;
    const float t2086 = t41 * t326;
    const float t2087 = t1086 * t2086;
    const float t2089 = (t518 * t1108) - (t524 * t2087);
    const float t2092 = t1108 * t2086;
    const float t2094 = (t518 * t1086) + (t524 * t2092);
    const float t2096 = t518 * t1115;
    const float t2098 = t326 * t1115;
    const float t2099 = t524 * t2098;
    const float t2101 = t518 * t1119;
    const float t2103 = t326 * t1119;
    const float t2104 = t524 * t2103;
    const float t2107 = t518 * t1772;
    const float t2109 = t518 * t1766;
    const float t2115 = (t149 * t2083) + (t153 * t2089) + (t162 * t2094) + (t358 * t2099) + (t537 *
        t2101) + (t543 * t1760);
    const float t2120 = t2115 + (t566 * t2107) + (t617 * t2109) - (t120 * t2080) - (t556 * t2096) -
        (t339 * t2104);
    const float t2123 = (t910 * motion->constants[28]) - (t682 * motion->constants[28]);
    const float t2126 = t1007 + t1007;
    const float t2127 = t26 * t2126;
    const float t2129 = motion->constants[7] * t1784;
    const float t2133 = motion->constants[7] * t1772;
    const float t2134 = t26 * t2133;
    const float t2136 = motion->constants[7] * t1766;
    const float t2137 = t26 * t2136;
    const float t2143 = (t27 * t2129) + (t107 * t1811) + (t110 * t1142) - (t286 *
        motion->constants[60]) - (t933 * t2127) - (t199 * t2134);
    const float t2144 = t2143 - (t233 * t2137);
    const float t2145 = t26 * motion->constants[44];
    const float t2149 = (t701 * motion->constants[55]) - t725;
    const float t2152 = (t14 * t750) - (t26 * t711);
    const float t2155 = (t14 * t711) + (t26 * t750);
    const float t2159 = (t872 * t2155) - t2152 - (cos_theta * t861);
    const float t2161 = t705 * motion->constants[24];
    const float t2165 = (t26 * motion->constants[33]) + (t14 * motion->constants[32]) -
        motion->constants[7];
    const float t2169 = (t14 * motion->constants[33]) - (t26 * motion->constants[32]);
    const float t2170 = t750 * t2169;
    const float t2172 = t26 * t705;
    const float t2174 = t2172 + (t14 * t728);
    const float t2178 = (t705 * motion->constants[33]) + (t728 * motion->constants[32]);
    const float t2182 = (t2074 * t2174) - (t750 * t2165) - (t872 * t2170) - (t861 * t2178);
    const float t2184 = t701 * motion->constants[24];
    const float t2186 = t711 * t2169;
    const float t2189 = t14 * t705;
    const float t2190 = (t26 * t701) + t2189;
    const float t2194 = (t701 * motion->constants[33]) + (t705 * motion->constants[32]);
    const float t2198 = (t711 * t2165) + (t872 * t2186) + (t2074 * t2190) - (t861 * t2194);
    const float t2201 = (t26 * t728) - t2189;
    const float t2205 = (t872 * t2201) + (t750 * t861) - t2174;
    const float t2208 = t2172 - (t14 * t701);
    const float t2212 = (t872 * t2208) - t2190 - (t711 * t861);
    const float t2215 = cos_theta * t2169;
    const float t2220 = (t750 * motion->constants[32]) - (t711 * motion->constants[33]);
    const float t2224 = (cos_theta * t2165) + (t872 * t2215) + (t2074 * t2152) - (t861 * t2220);
    const float t2227 = (motion->constants[54] * t2205) + (motion->constants[24] * t2224) -
        (motion->constants[55] * t2212);
    const float t2231 = (t2149 * t2159) + (t2161 * t2182) + (t2184 * t2198) - (t711 * t2227);
    const float t2232 = motion->constants[7] - t78;
    const float t2233 = cos_delta * motion->constants[47];
    const float t2234 = sin_delta * t2233;
    const float t2236 = t85 * t2234;
    const float t2238 = cos_delta * t2233;
    const float t2239 = t26 * t2238;
    const float t2241 = motion->constants[31] * t2238;
    const float t2243 = cos_delta * motion->constants[49];
    const float t2246 = t85 * t2233;
    const float t2248 = sin_delta * motion->constants[47];
    const float t2249 = t26 * t2248;
    const float t2251 = motion->constants[31] * t2248;
    const float t2254 = (t26 * t872) - t14;
    const float t2259 = t155 + (t124 * t872) + (sin_delta * t861);
    const float t2265 = (t872 * t2246) + (t861 * t2251) + (motion->constants[48] * t2254) +
        (motion->constants[49] * t2259) - (t2232 * t2233) - (t2074 * t2249);
    const float t2271 = (t872 * t2236) + (t2074 * t2239) + (t910 * t2243) - (t2232 * t2234) -
        (t861 * t2241) - (sin_delta * t2265);
    const float t2274 = (t2074 * t2145) + t2231 + t2271 - (motion->constants[41] * t861);
    const float t2277 = t14 * t2126;
    const float t2282 = t14 * t2133;
    const float t2284 = t14 * t2136;
    const float t2290 = (t933 * t2277) + (t110 * t1811) + (t199 * t2282) + (t233 * t2284) - (t82 *
        motion->constants[60]) - (t18 * t2129);
    const float t2291 = t2290 - (t107 * t1142);
    const float t2294 = (t14 * motion->constants[44]) + (t14 * motion->constants[47]);
    const float t2299 = t760 - (motion->constants[54] * t728);
    const float t2301 = t728 * motion->constants[24];
    const float t2307 = (t2159 * t2299) + (t2182 * t2301) + (t2161 * t2198) + (t750 * t2227);
    const float t2310 = (motion->constants[48] * t910) - (t2074 * t2294) - (t814 * t861) - t2307;
    const float t2312 = t93 - t970;
    const float t2313 = t933 * t2312;
    const float t2314 = motion->constants[7] * t930;
    const float t2318 = t2313 + (cos_phi * (motion->constants[60] + (t929 * t2314)));
    const float t2322 = (t14 * motion->constants[41]) + (t26 * motion->constants[40]);
    const float t2326 = (t711 * motion->constants[55]) + (motion->constants[54] * t750);
    const float t2328 = t750 * motion->constants[24];
    const float t2330 = t711 * motion->constants[24];
    const float t2335 = (t2159 * t2326) + (t2198 * t2330) + (cos_theta * t2227) - (t2182 * t2328);
    const float t2336 = sin_delta * t2248;
    const float t2338 = t85 * t2336;
    const float t2340 = cos_delta * t2248;
    const float t2341 = t26 * t2340;
    const float t2343 = motion->constants[31] * t2340;
    const float t2345 = sin_delta * motion->constants[49];
    const float t2352 = (t872 * t2338) + (t2074 * t2341) + (t910 * t2345) + (cos_delta * t2265) -
        (t2232 * t2336) - (t861 * t2343);
    const float t2355 = (t26 * motion->constants[41]) - (t14 * motion->constants[40]);
    const float t2359 = (motion->constants[7] * motion->constants[44]) - (t872 * t2322) - t2335 -
        t2352 - t2355;
    const float t2367 = (t82 * t1784) + (t924 * t930) + (t110 * t1772) - (t107 * t1786);
    const float t2370 = t26 * motion->constants[42];
    const float t2373 = t14 * motion->constants[42];
    const float t2376 = (t85 * t764) + (t26 * motion->constants[46]) - t2373;
    const float t2388 = (motion->constants[59] * t2205) + (motion->constants[57] * t2212) +
        (motion->constants[54] * t2224);
    const float t2394 = (motion->constants[58] * t2159) + (motion->constants[55] * t2198) -
        (motion->constants[54] * t2182);
    const float t2400 = (motion->constants[57] * t2205) + (motion->constants[56] * t2212) -
        (motion->constants[55] * t2224);
    const float t2406 = (t872 * t2376) + (t833 * t861) + (motion->constants[53] * t2254) +
        (motion->constants[30] * t2352) + (t728 * t2388) + (t750 * t2394);
    const float t2411 = t2406 + (t705 * t2400) - (motion->constants[7] * motion->constants[40]) -
        (t764 * t2232) - t2370 - (t14 * motion->constants[46]);
    const float t2414 = t2411 - (t1538 * t2074) - (motion->constants[51] * t2259) -
        (motion->constants[32] * t2335);
    const float t2419 = t1786 + (t199 * t1772) + (t233 * t1766);
    const float t2421 = t2355 - (t14 * motion->constants[67]);
    const float t2423 = motion->constants[43] + motion->constants[27];
    const float t2424 = motion->constants[71] + t2423;
    const float t2426 = motion->constants[30] * motion->constants[48];
    const float t2435 = t85 * t2345;
    const float t2439 = (t26 * t2243) - (t14 * motion->constants[48]);
    const float t2442 = t2426 + (motion->constants[31] * t2243);
    const float t2449 = t2123 + (t872 * t2435) + (t2074 * t2439) + (motion->constants[52] * t910) -
        (t2232 * t2345) - (t861 * t2442);
    const float t2452 = t85 * t2243;
    const float t2454 = t26 * t2345;
    const float t2456 = motion->constants[31] * t2345;
    const float t2464 = (t2232 * t2243) + (t2074 * t2454) + (motion->constants[51] * t2254) -
        (t872 * t2452) - (t861 * t2456) - (motion->constants[50] * t2259);
    const float t2470 = (t2074 * t2421) + (t910 * t2426) + (motion->constants[32] * t2307) +
        (motion->constants[33] * t2231) + (motion->constants[31] * t2271) + (cos_theta * t2394);
    const float t2475 = t2470 + (t711 * t2400) + (cos_delta * t2449) + (sin_delta * t2464) - (t861 *
        t2424) - (t750 * t2388);
    const float t2478 = t930 * t942;
    const float t2483 = (t286 * t1784) + t2478 + (t107 * t1772) + (t110 * t1786);
    const float t2487 = t2370 - (t14 * motion->constants[45]);
    const float t2500 = (motion->constants[7] * motion->constants[41]) + (t872 * t2487) + (t705 *
        t2388) + (t701 * t2400) + (cos_delta * t2464) - t2373;
    const float t2505 = t2500 - (t26 * motion->constants[45]) - (motion->constants[33] * t2335) -
        (motion->constants[31] * t2352) - (t711 * t2394) - (sin_delta * t2449);
    const float t2511 = t341 * t1760;
    const float t2515 = t2103 + (t329 * t1760);
    const float t2523 = (t149 * t2082) + (t162 * t2092) + (t191 * t2511) + (t358 * t2098) + (t369 *
        t1772) + (t461 * t1766);
    const float t2526 = t2523 - (t120 * t2079) - (t153 * t2087) - (t339 * t2515);
    const float t2527 = t6 * t26;
    const float t2529 = t6 * t14;
    const float t2537 = (t2274 * t2527) + (t18 * t2505) - (t2310 * t2529) - (t27 * t2414) -
        (sin_phi * t2475);
    const float t2539 = t71 * t1115;
    const float t2541 = t71 * t1058;
    const float t2543 = t71 * t1110;
    const float t2545 = t30 * t71;
    const float t2546 = t1086 * t2545;
    const float t2548 = t1108 * t2545;
    const float t2550 = cos_phi * t2539;
    const float t2556 = (t100 * t2539) + (t120 * t2541) + (t149 * t2543) + (t153 * t2546) - (t162 *
        t2548) - (t195 * t2550);
    const float t2559 = (t363 * t524) - (t518 * t561);
    const float t2561 = motion->constants[7] * t26;
    const float t2563 = motion->constants[7] * t14;
    const float t2569 = t2475 + (t2123 * t2559) + (t2310 * t2563) + (t363 * t2537) - (t2274 *
        t2561);
    const float t2572 = motion->constants[30] + t2563;
    const float t2574 = motion->constants[37] + t1032;
    const float t2575 = speeds[0] * cos_delta;
    const float t2578 = (t14 * t1007) + (speeds[0] * t2572) + (t2574 * t2575);
    const float t2582 = motion->constants[8] * t1071;
    const float t2583 = motion->constants[8] * t950;
    const float t2585 = (t965 * t2583) - t2582;
    const float t2587 = t960 * t1045;
    const float t2589 = t2587 + (t950 * t2583);
    const float t2594 = (t107 * t1014) + (t110 * t1009) + (t153 * t2585) + (t162 * t2589) - (t933 *
        t2578);
    const float t2596 = t34 * t2086;
    const float t2598 = (t32 * t518) - (t524 * t2596);
    const float t2601 = t34 * t2545;
    const float t2604 = (t2123 * t2598) + (t2569 * t2601) - (t2537 * t2596);
    const float t2606 = motion->constants[38] + t1036;
    const float t2607 = sin_delta * t2606;
    const float t2610 = t2561 - motion->constants[31];
    const float t2612 = (t26 * t1007) + (speeds[0] * t2610);
    const float t2614 = (speeds[0] * t2607) - (sin_delta * t2612);
    const float t2617 = t924 * t2574;
    const float t2620 = (motion->constants[30] * t924) - t2314;
    const float t2621 = t929 * t2620;
    const float t2627 = motion->constants[30] * t981;
    const float t2630 = (t981 * t2574) + (cos_delta * t2627) - (sin_delta * t1009);
    const float t2632 = sin_delta * t1014;
    const float t2636 = (motion->constants[8] * t1034) + (t950 * t1045);
    const float t2640 = (t965 * t1045) - (motion->constants[8] * t1038);
    const float t2644 = (cos_phi * ((t929 * t2617) + (cos_delta * t2621))) + (t153 * t2636) -
        (t933 * t2614) - (cos_delta * t2313);
    const float t2647 = t2644 - (t107 * t2630) - (t110 * t2632) - (t162 * t2640);
    const float t2648 = t30 * t326;
    const float t2649 = t524 * t2648;
    const float t2652 = t41 * t71;
    const float t2655 = (t2123 * t2649) + (t2537 * t2648) + (t2569 * t2652);
    const float t2659 = (cos_delta * t2612) - (t2575 * t2606);
    const float t2665 = (cos_delta * t1009) + (sin_delta * t2627);
    const float t2667 = cos_delta * t1014;
    const float t2669 = motion->constants[8] * t965;
    const float t2671 = t2587 + (t965 * t2669);
    const float t2674 = t2582 + (t950 * t2669);
    const float t2680 = (t117 * t2621) + (t110 * t2667) - (t933 * t2659) - (sin_delta * t2313) -
        (t107 * t2665) - (t153 * t2671);
    const float t2681 = t2680 - (t162 * t2674);
    const float t2683 = t32 * t2086;
    const float t2685 = (t34 * t518) + (t524 * t2683);
    const float t2688 = t32 * t2545;
    const float t2691 = (t2569 * t2688) - (t2123 * t2685) - (t2537 * t2683);
    const float t2693 = t31 * t1043;
    const float t2695 = t1040 * t2693;
    const float t2697 = t950 * t1040;
    const float t2699 = t965 * t1040;
    const float t2703 = (t120 * t2693) + (t153 * t2697) - (t149 * t2695) - (t162 * t2699);
    const float t2704 = t960 * t1036;
    const float t2708 = (t965 * t1036) + (t950 * t1032);
    const float t2709 = t2655 * t2708;
    const float t2710 = t960 * t1032;
    const float t2713 = t2709 - (t2604 * t2704) - (t2691 * t2710);
    const float t2716 = (motion->constants[7] * t1012) - t970;
    const float t2717 = t930 * t2716;
    const float t2726 = (t14 * t2274) + (t26 * t2310) + (t124 * t2691) - (t26 * t2604) - (t115 *
        t2655);
    const float t2729 = t2478 + (t110 * t981);
    const float t2730 = sin_delta * t2574;
    const float t2734 = (cos_delta * t2606) + (cos_delta * motion->constants[31]);
    const float t2737 = t2607 + (sin_delta * motion->constants[31]);
    const float t2740 = (t2655 * t2734) + (t2691 * t2737) - (t2604 * t2730);
    const float t2742 = motion->constants[41] * t943;
    const float t2743 = motion->constants[40] * t932;
    const float t2747 = t1369 - (t943 * t2423);
    const float t2750 = (t932 * t2423) - t945;
    const float t2754 = (t26 * t2750) - (t14 * t2747);
    const float t2760 = t982 + t982;
    const float t2761 = motion->constants[47] * t2760;
    const float t2764 = (t26 * (t1432 + t1432)) + (t14 * (t1430 + t1430)) + (t14 * t2761);
    const float t2766 = motion->constants[30] * t2761;
    const float t2768 = motion->constants[48] * t2760;
    const float t2770 = t1170 + t1170;
    const float t2772 = motion->constants[33] * t943;
    const float t2773 = motion->constants[32] * t932;
    const float t2774 = t2772 - t2773;
    const float t2776 = t1159 + t1159;
    const float t2778 = motion->constants[31] * t943;
    const float t2779 = motion->constants[30] * t932;
    const float t2780 = t2778 + t2779;
    const float t2782 = t984 + t984;
    const float t2787 = (sin_delta * t2782) + (cos_delta * t2780);
    const float t2791 = (sin_delta * t2780) - (cos_delta * t2782);
    const float t2793 = motion->constants[57] * t1198;
    const float t2797 = t1266 + t1267 - (motion->constants[59] * t1223);
    const float t2800 = (motion->constants[59] * t1198) - t1235;
    const float t2802 = motion->constants[54] * t1223;
    const float t2805 = t1290 + t1292;
    const float t2812 = (t2159 * t2797) + (t2212 * t2800) + (t2182 * t2802) + (t1301 * t2224) +
        (t1220 * t2394) - (t2205 * t2793);
    const float t2813 = t2812 - (t2198 * t2805);
    const float t2816 = t1235 - (motion->constants[56] * t1198);
    const float t2820 = (motion->constants[56] * t1231) - t1224 - t1233;
    const float t2823 = t1292 - t1291;
    const float t2826 = motion->constants[55] * t1231;
    const float t2833 = (t2205 * t2816) + (t2159 * t2820) + (t2212 * t2793) + (t2182 * t2823) +
        (t1288 * t2224) + (t2198 * t2826);
    const float t2834 = t2833 - (t1228 * t2394);
    const float t2837 = (motion->constants[58] * t1223) - t1267;
    const float t2840 = t1233 - (motion->constants[58] * t1231);
    const float t2842 = t1301 + t1301;
    const float t2844 = t2802 + t2826;
    const float t2846 = t1288 + t1288;
    const float t2854 = (t2205 * t2837) + (t2212 * t2840) + (t2224 * t2844) + (t1228 * t2400) -
        (t2182 * t2842) - (t2198 * t2846);
    const float t2855 = t2854 - (t1220 * t2388);
    const float t2857 = t965 * motion->constants[49];
    const float t2858 = motion->constants[48] * t950;
    const float t2859 = t2857 + t2858;
    const float t2861 = t1331 + t1331;
    const float t2863 = (cos_delta * t2859) - (sin_delta * t2861);
    const float t2865 = t85 * t2863;
    const float t2867 = t1344 + t1344;
    const float t2871 = (sin_delta * t2859) + (cos_delta * t2861);
    const float t2873 = (t14 * t2867) + (t26 * t2871);
    const float t2877 = (motion->constants[30] * t2867) - (motion->constants[31] * t2871);
    const float t2880 = motion->constants[28] * t950;
    const float t2882 = (motion->constants[52] * t950) + t2880 - t967;
    const float t2885 = motion->constants[28] * t965;
    const float t2887 = t1382 - (motion->constants[52] * t965) - t2885;
    const float t2890 = t1021 + t1046;
    const float t2891 = t1021 + t2890;
    const float t2893 = motion->constants[37] * t950;
    const float t2896 = (t965 * motion->constants[38]) - (speeds[1] * t2606);
    const float t2897 = t2893 + t2896;
    const float t2899 = t1023 + t1048;
    const float t2900 = t1023 + t2899;
    const float t2906 = (t872 * t2865) + (t2254 * t2882) + (speeds[1] * t2464) + (t2655 * t2897) -
        (t2232 * t2863) - (t2074 * t2873);
    const float t2910 = t2906 - (t861 * t2877) - (t2259 * t2887) - (t2604 * t2891) - (t2691 *
        t2900);
    const float t2914 = (cos_delta * t1331) + (sin_delta * t2857);
    const float t2916 = t85 * t2914;
    const float t2918 = t1335 - t1334;
    const float t2922 = (cos_delta * t2857) - (sin_delta * t1331);
    const float t2924 = (t14 * t2918) + (t26 * t2922);
    const float t2928 = (motion->constants[31] * t2922) - (motion->constants[30] * t2918);
    const float t2931 = t962 - (motion->constants[50] * t953);
    const float t2935 = (motion->constants[50] * t965) - t1380 - t1382;
    const float t2937 = motion->constants[51] * t953;
    const float t2942 = t1065 + t1078;
    const float t2945 = (speeds[1] * t2574) + t2942 - t1064 - (t34 * t2583);
    const float t2948 = t2899 + (t959 * t1032);
    const float t2951 = t2896 + (t34 * t2669);
    const float t2953 = t32 * t1040;
    const float t2959 = (t872 * t2916) + (t2074 * t2924) + (t2254 * t2931) + (t910 * t2935) +
        (t2604 * t2945) + (t2655 * t2948);
    const float t2964 = t2959 + (t2691 * t2951) + (t2713 * t2953) - (t2232 * t2914) - (t861 *
        t2928) - (t2259 * t2937);
    const float t2965 = t2964 - (speeds[1] * t2449);
    const float t2971 = (t872 * t2754) + (t910 * t2768) + (t2335 * t2774) + (t2231 * t2776) +
        (t2352 * t2780) + (t2655 * t2787);
    const float t2976 = t2971 + (t2691 * t2791) + (t711 * t2834) + (cos_theta * t2855) +
        (cos_delta * t2910) + (sin_delta * t2965);
    const float t2980 = t2976 - (motion->constants[7] * (t2742 + t2743)) - (t26 * t2747) - (t14 *
        t2750) - (t2074 * t2764);
    const float t2985 = t2980 - (t861 * t2766) - (t2307 * t2770) - (t2271 * t2782) - (t2604 *
        t2760) - (t750 * t2813);
    const float t2987 = t14 * t933;
    const float t2991 = (t110 * t930) - t2987 - (speeds[0] * t107);
    const float t2993 = motion->constants[42] * t934;
    const float t2994 = t26 * t2993;
    const float t2996 = t938 - (motion->constants[45] * t934);
    const float t2998 = t14 * t2993;
    const float t3000 = (t26 * t2996) - t2998;
    const float t3005 = t1001 - t1000;
    const float t3006 = motion->constants[47] * t3005;
    const float t3009 = (t26 * t2742) + (t14 * (t1481 - t1480)) + (t14 * t3006);
    const float t3015 = (motion->constants[45] * t943) - t1367 - t1369 - (motion->constants[30] *
        t3006);
    const float t3017 = motion->constants[48] * t3005;
    const float t3019 = t1162 + t1163;
    const float t3030 = t984 + (motion->constants[30] * t91);
    const float t3033 = (t91 * t2574) + (cos_delta * t3030) - (sin_delta * t2778);
    const float t3037 = (cos_delta * t2778) + (sin_delta * t3030);
    const float t3048 = (t872 * t3000) + (t2074 * t3009) + (t2231 * t2772) + (t984 * t2352) +
        (t2271 * t2778) + (t91 * t2414);
    const float t3053 = t3048 + (t2604 * t3005) + (t2655 * t3033) + (t2691 * t3037) + (t705 *
        t2813) + (t701 * t2834);
    const float t3058 = t3053 + (cos_delta * t2965) - (motion->constants[7] * t1432) - t2994 -
        (t14 * t2996) - (t861 * t3015);
    const float t3063 = t3058 - (t910 * t3017) - (t2307 * t3019) - (t1159 * t2335) - (t711 *
        t2855) - (sin_delta * t2910);
    const float t3065 = t26 * t933;
    const float t3069 = t3065 + (t107 * t930) + (speeds[0] * t110);
    const float t3072 = (motion->constants[46] * t934) - t938;
    const float t3075 = t1333 + t1335;
    const float t3077 = (cos_delta * t1344) - (sin_delta * t3075);
    const float t3078 = t85 * t3077;
    const float t3081 = t3078 - t2994 - (t14 * t3072);
    const float t3086 = motion->constants[47] * t2779;
    const float t3091 = (sin_delta * t1344) + (cos_delta * t3075);
    const float t3093 = (t14 * t2858) - (t26 * t3091);
    const float t3096 = (t14 * t2743) + (t14 * t3086) + t3093 - (t26 * (t1479 + t1481));
    const float t3102 = (motion->constants[30] * t2858) + (motion->constants[31] * t3091);
    const float t3106 = t944 + t945 - (motion->constants[46] * t932) - (motion->constants[30] *
        t3086) - t3102;
    const float t3110 = t966 + t967 - (motion->constants[53] * t950);
    const float t3112 = t3110 - (motion->constants[48] * t2779);
    const float t3116 = t1161 + t1163;
    const float t3119 = t999 + t1001;
    const float t3123 = t2893 + (t32 * t2583);
    const float t3124 = t2779 + t3123;
    const float t3128 = t2890 + (t959 * t1036);
    const float t3131 = (cos_delta * t982) + t3128 + (sin_delta * t3119);
    const float t3136 = t1063 + t2942 + (t32 * t2669);
    const float t3139 = (sin_delta * t982) - t3136 - (cos_delta * t3119);
    const float t3148 = (motion->constants[53] * t953) - t962;
    const float t3150 = t34 * t1040;
    const float t3154 = (t2232 * t3077) + (t2254 * t2937) + (t2259 * t3148) - (t2713 * t3150);
    const float t3159 = t2998 + (t872 * t3081) + (t2074 * t3096) + (t910 * t3112) + (t1170 *
        t2335) + (t2231 * t3116);
    const float t3164 = t3159 + (t982 * t2352) + (t2604 * t3124) + (t2655 * t3131) + (t2691 *
        t3139) + (t91 * t2740);
    const float t3169 = t3164 + (t728 * t2813) + (t705 * t2834) + (t750 * t2855) -
        (motion->constants[7] * t1430) - (t26 * t3072);
    const float t3174 = t3169 - (t861 * t3106) - (t2307 * t2773) - (t2271 * t3119) - (t91 * t2505) -
        t3154;
    const float t3183 = t2709 + (t2254 * t2880) + (t2259 * t2885) - (t1046 * t2604) - (t1048 *
        t2691);
    const float t3188 = t2314 + t2779;
    const float t3190 = (t932 * t2574) + (cos_delta * t3188);
    const float t3192 = sin_delta * t3188;
    const float t3197 = (t2314 * t2359) - (t970 * t2726);
    const float t3202 = t2985 + (t932 * t2414) + (t2655 * t3190) + (t2691 * t3192) + (t943 *
        t2740) - (t943 * t2505);
    const float t3203 = t3202 - t3197;
    const float t3205 = cos_phi * t2127;
    const float t3207 = cos_phi * t2277;
    const float t3210 = cos_phi * t2312;
    const float t3211 = (sin_phi * t2314) - t3210;
    const float t3213 = sin_phi * t924;
    const float t3215 = speeds[0] * cos_phi;
    const float t3217 = sin_phi * t942;
    const float t3219 = cos_phi * t2578;
    const float t3224 = t3210 + (sin_phi * t2620);
    const float t3227 = (sin_phi * t2617) + (cos_phi * t2614) + (cos_delta * t3224);
    const float t3231 = (cos_phi * t2659) + (sin_delta * t3224);
    const float t3233 = sin_phi * t2716;
    const float t3243 = (t2274 * t3205) + (t2359 * t3211) + (t2414 * t3213) + (t2604 * t3219) +
        (t2655 * t3227) + (t2691 * t3231);
    const float t3248 = t3243 + (t2726 * t3233) + (t2740 * t3217) + (t18 * t3063) - (t2310 *
        t3207) - (t2475 * t3215);
    const float t3251 = t3248 - (t2505 * t3217) - (sin_phi * t2985) - (t27 * t3174);
    const float t3257 = (t364 * t2059) + (t107 * t1994) + (t369 * t2066) + (t2074 * t2077) +
        (t2120 * t2123) + (t2144 * t2274);
    const float t3262 = t3257 + (t2291 * t2310) + (t2318 * t2359) + (t2367 * t2414) + (t2419 *
        t2475) + (t2526 * t2537);
    const float t3267 = t3262 + (t2556 * t2569) + (t2594 * t2604) + (t2647 * t2655) + (t2681 *
        t2691) + (t2703 * t2713);
    const float t3272 = t3267 + (t2717 * t2726) + (t2729 * t2740) + (t2991 * t3063) + (t3069 *
        t3174) + (t620 * t3183);
    const float t3277 = t3272 + (t235 * t3203) - (t465 * t3251) - (t364 * t1997) - (t110 * t1949) -
        (t199 * t2058);
    const float t3281 = t3277 - (t566 * t2068) - (t872 * t2072) - (t2483 * t2505) - (t930 * t2985);
    const float t3289 = motion->constants[7] * t1534;
    const float t3293 = (t690 * motion->constants[28]) + (motion->constants[28] * t1557);
    const float t3299 = (t1536 * t2155) - (cos_theta * t1534);
    const float t3305 = (t2174 * t3289) - (t1536 * t2170) - (t1534 * t2178);
    const float t3311 = (t1536 * t2186) + (t2190 * t3289) - (t1534 * t2194);
    const float t3315 = (t1536 * t2201) + (t750 * t1534);
    const float t3319 = (t1536 * t2208) - (t711 * t1534);
    const float t3325 = (t1536 * t2215) + (t2152 * t3289) - (t1534 * t2220);
    const float t3328 = (motion->constants[54] * t3315) + (motion->constants[24] * t3325) -
        (motion->constants[55] * t3319);
    const float t3332 = (t2149 * t3299) + (t2161 * t3305) + (t2184 * t3311) - (t711 * t3328);
    const float t3341 = (t26 * t1536) - 1.0F;
    const float t3345 = (t124 * t1536) + (sin_delta * t1534);
    const float t3350 = (t1536 * t2246) + (t1534 * t2251) + (motion->constants[48] * t3341) +
        (motion->constants[49] * t3345) - (t2249 * t3289);
    const float t3355 = (t1536 * t2236) + (t2239 * t3289) - (t1534 * t2241) - (t1557 * t2243) -
        (sin_delta * t3350);
    const float t3358 = (t2145 * t3289) + t3332 + t3355 - (motion->constants[41] * t1534);
    const float t3369 = (t2299 * t3299) + (t2301 * t3305) + (t2161 * t3311) + (t750 * t3328);
    const float t3372 = (t2294 * t3289) + (t814 * t1534) + (motion->constants[48] * t1557) + t3369;
    const float t3381 = (t2326 * t3299) + (t2330 * t3311) + (cos_theta * t3328) - (t2328 * t3305);
    const float t3390 = (t1536 * t2338) + (t2341 * t3289) + (cos_delta * t3350) - (t1534 * t2343) -
        (t1557 * t2345);
    const float t3392 = (t1536 * t2322) + t3381 + t3390;
    const float t3405 = (motion->constants[59] * t3315) + (motion->constants[57] * t3319) +
        (motion->constants[54] * t3325);
    const float t3411 = (motion->constants[58] * t3299) + (motion->constants[55] * t3311) -
        (motion->constants[54] * t3305);
    const float t3417 = (motion->constants[57] * t3315) + (motion->constants[56] * t3319) -
        (motion->constants[55] * t3325);
    const float t3423 = (t1536 * t2376) + (t833 * t1534) + (motion->constants[53] * t3341) +
        (motion->constants[30] * t3390) + (t728 * t3405) + (t750 * t3411);
    const float t3427 = t3423 + (t705 * t3417) - (t1538 * t3289) - (motion->constants[51] * t3345) -
        (motion->constants[32] * t3381);
    const float t3445 = (t1536 * t2435) + (t2439 * t3289) - t3293 - (t1534 * t2442) -
        (motion->constants[52] * t1557);
    const float t3455 = (t2454 * t3289) + (motion->constants[51] * t3341) - (t1536 * t2452) -
        (t1534 * t2456) - (motion->constants[50] * t3345);
    const float t3461 = (t2421 * t3289) + (motion->constants[32] * t3369) + (motion->constants[33] *
        t3332) + (motion->constants[31] * t3355) + (cos_theta * t3411) + (t711 * t3417);
    const float t3466 = t3461 + (cos_delta * t3445) + (sin_delta * t3455) - (t1534 * t2424) -
        (t1557 * t2426) - (t750 * t3405);
    const float t3480 = (t1536 * t2487) + (t705 * t3405) + (t701 * t3417) + (cos_delta * t3455) -
        (motion->constants[33] * t3381) - (motion->constants[31] * t3390);
    const float t3482 = t3480 - (t711 * t3411) - (sin_delta * t3445);
    const float t3492 = (t2527 * t3358) + (t2529 * t3372) + (t18 * t3482) - (t27 * t3427) -
        (sin_phi * t3466);
    const float t3501 = t3466 + (t363 * t3492) - (t2559 * t3293) - (t2561 * t3358) - (t2563 *
        t3372);
    const float t3507 = (t2601 * t3501) - (t2598 * t3293) - (t2596 * t3492);
    const float t3513 = (t2648 * t3492) + (t2652 * t3501) - (t2649 * t3293);
    const float t3519 = (t2685 * t3293) + (t2688 * t3501) - (t2683 * t3492);
    const float t3522 = t2708 * t3513;
    const float t3525 = t3522 - (t2704 * t3507) - (t2710 * t3519);
    const float t3535 = (t14 * t3358) + (t124 * t3519) - (t26 * t3372) - (t26 * t3507) - (t115 *
        t3513);
    const float t3541 = (t2734 * t3513) + (t2737 * t3519) - (t2730 * t3507);
    const float t3566 = (t2797 * t3299) + (t2800 * t3319) + (t2802 * t3305) + (t1301 * t3325) +
        (t1220 * t3411) - (t2793 * t3315);
    const float t3567 = t3566 - (t2805 * t3311);
    const float t3580 = (t2816 * t3315) + (t2820 * t3299) + (t2793 * t3319) + (t2823 * t3305) +
        (t1288 * t3325) + (t2826 * t3311);
    const float t3581 = t3580 - (t1228 * t3411);
    const float t3594 = (t2837 * t3315) + (t2840 * t3319) + (t2844 * t3325) + (t1228 * t3417) -
        (t2842 * t3305) - (t2846 * t3311);
    const float t3595 = t3594 - (t1220 * t3405);
    const float t3610 = (t1536 * t2865) + (t2882 * t3341) + (speeds[1] * t3455) + (t2897 * t3513) -
        (t2873 * t3289) - (t1534 * t2877);
    const float t3613 = t3610 - (t2887 * t3345) - (t2891 * t3507) - (t2900 * t3519);
    const float t3630 = (t1536 * t2916) + (t2924 * t3289) + (t2931 * t3341) + (t2945 * t3507) +
        (t2948 * t3513) + (t2951 * t3519);
    const float t3635 = t3630 + (t2953 * t3525) - (t1534 * t2928) - (t1557 * t2935) - (t2937 *
        t3345) - (speeds[1] * t3445);
    const float t3641 = (t1536 * t2754) + (t2774 * t3381) + (t2776 * t3332) + (t2780 * t3390) +
        (t2787 * t3513) + (t2791 * t3519);
    const float t3646 = t3641 + (t711 * t3581) + (cos_theta * t3595) + (cos_delta * t3613) +
        (sin_delta * t3635) - (t2764 * t3289);
    const float t3651 = t3646 - (t1534 * t2766) - (t1557 * t2768) - (t2770 * t3369) - (t2782 *
        t3355) - (t2760 * t3507);
    const float t3652 = t3651 - (t750 * t3567);
    const float t3676 = (t1536 * t3000) + (t3009 * t3289) + (t1557 * t3017) + (t2772 * t3332) +
        (t984 * t3390) + (t2778 * t3355);
    const float t3681 = t3676 + (t91 * t3427) + (t3005 * t3507) + (t3033 * t3513) + (t3037 *
        t3519) + (t705 * t3567);
    const float t3686 = t3681 + (t701 * t3581) + (cos_delta * t3635) - (t1534 * t3015) - (t3019 *
        t3369) - (t1159 * t3381);
    const float t3688 = t3686 - (t711 * t3595) - (sin_delta * t3613);
    const float t3711 = (t3150 * t3525) - (t2937 * t3341) - (t3148 * t3345);
    const float t3716 = (t1536 * t3081) + (t3096 * t3289) + (t1170 * t3381) + (t3116 * t3332) +
        (t982 * t3390) + (t3124 * t3507);
    const float t3721 = t3716 + (t3131 * t3513) + (t3139 * t3519) + (t91 * t3541) + (t728 * t3567) +
        (t705 * t3581);
    const float t3726 = t3721 + (t750 * t3595) + t3711 - (t1534 * t3106) - (t1557 * t3112) -
        (t2773 * t3369);
    const float t3728 = t3726 - (t3119 * t3355) - (t91 * t3482);
    const float t3737 = t3522 + (t2880 * t3341) + (t2885 * t3345) - (t1046 * t3507) - (t1048 *
        t3519);
    const float t3746 = (t2314 * t3392) + (t970 * t3535);
    const float t3751 = t3652 + (t932 * t3427) + (t3190 * t3513) + (t3192 * t3519) + (t943 *
        t3541) + t3746;
    const float t3752 = t3751 - (t943 * t3482);
    const float t3772 = (t3205 * t3358) + (t3207 * t3372) + (t3213 * t3427) + (t3219 * t3507) +
        (t3227 * t3513) + (t3231 * t3519);
    const float t3777 = t3772 + (t3233 * t3535) + (t3217 * t3541) + (t18 * t3688) - (t3211 *
        t3392) - (t3215 * t3466);
    const float t3780 = t3777 - (t3217 * t3482) - (sin_phi * t3652) - (t27 * t3728);
    const float t3787 = (t447 * t2059) + (t461 * t2066) + (t2077 * t3289) + (t2144 * t3358) +
        (t2367 * t3427) + (t2419 * t3466);
    const float t3792 = t3787 + (t2526 * t3492) + (t2556 * t3501) + (t2594 * t3507) + (t2647 *
        t3513) + (t2681 * t3519);
    const float t3797 = t3792 + (t2703 * t3525) + (t2717 * t3535) + (t2729 * t3541) + (t2991 *
        t3688) + (t3069 * t3728);
    const float t3802 = t3797 + (t620 * t3737) + (t235 * t3752) - (t465 * t3780) - (t447 * t1997) -
        (t233 * t2058);
    const float t3807 = t3802 - (t617 * t2068) - (t1536 * t2072) - (t2120 * t3293) - (t2291 *
        t3372) - (t2318 * t3392);
    const float t3810 = t3807 - (t2483 * t3482) - (t930 * t3652) - (t1568 * t3281);
    const float t3814 = (motion->constants[3] * motion->constants[55]) - (motion->constants[2] *
        motion->constants[54]);
    const float t3815 = t711 * t3814;
    const float t3817 = t750 * t3814;
    const float t3819 = cos_theta * t3814;
    const float t3822 = t1620 + (motion->constants[32] * t3819);
    const float t3827 = (motion->constants[32] * t3817) - t1611 - (motion->constants[33] * t3815);
    const float t3830 = t1626 + (motion->constants[33] * t3819);
    const float t3840 = (t2529 * t3817) + (t27 * t3822) - (t2527 * t3815) - (sin_phi * t3827) -
        (t18 * t3830);
    const float t3847 = t3827 + (t2561 * t3815) + (t363 * t3840) - (t2563 * t3817);
    const float t3851 = (t2601 * t3847) - (t2596 * t3840);
    const float t3855 = (t2648 * t3840) + (t2652 * t3847);
    const float t3859 = (t2688 * t3847) - (t2683 * t3840);
    const float t3862 = t2708 * t3855;
    const float t3865 = t3862 - (t2704 * t3851) - (t2710 * t3859);
    const float t3875 = (t124 * t3859) - (t14 * t3815) - (t26 * t3817) - (t26 * t3851) - (t115 *
        t3855);
    const float t3881 = (t2734 * t3855) + (t2737 * t3859) - (t2730 * t3851);
    const float t3891 = (motion->constants[2] * t2793) - (motion->constants[3] * t2800);
    const float t3895 = (motion->constants[2] * t2816) + (motion->constants[3] * t2793);
    const float t3903 = (t1220 * motion->constants[77]) - (motion->constants[2] * t2837) -
        (motion->constants[3] * t2840) - (t1228 * motion->constants[76]);
    const float t3909 = (t2897 * t3855) - (t2891 * t3851) - (t2900 * t3859);
    const float t3917 = (t2945 * t3851) + (t2948 * t3855) + (t2951 * t3859) + (t2953 * t3865);
    const float t3923 = (t2774 * t3819) + (t2787 * t3855) + (t2791 * t3859) + (cos_theta * t3903) +
        (cos_delta * t3909) + (sin_delta * t3917);
    const float t3928 = t3923 - (t2770 * t3817) - (t2776 * t3815) - (t2760 * t3851) - (t750 *
        t3891) - (t711 * t3895);
    const float t3946 = (t3005 * t3851) + (t3033 * t3855) + (t3037 * t3859) + (t705 * t3891) +
        (cos_delta * t3917) - (t3019 * t3817);
    const float t3951 = t3946 - (t1159 * t3819) - (t2772 * t3815) - (t91 * t3822) - (t701 * t3895) -
        (t711 * t3903);
    const float t3952 = t3951 - (sin_delta * t3909);
    const float t3961 = t3150 * t3865;
    const float t3970 = (t1170 * t3819) + (t91 * t3830) + (t3124 * t3851) + (t3131 * t3855) +
        (t3139 * t3859) + t3961;
    const float t3975 = t3970 + (t91 * t3881) + (t728 * t3891) + (t750 * t3903) - (t2773 * t3817) -
        (t3116 * t3815);
    const float t3976 = t3975 - (t705 * t3895);
    const float t3981 = t3862 - (t1046 * t3851) - (t1048 * t3859);
    const float t3990 = (t2314 * t3819) + (t970 * t3875);
    const float t3995 = t3928 + (t943 * t3830) + (t3190 * t3855) + (t3192 * t3859) + (t943 *
        t3881) + t3990;
    const float t3996 = t3995 - (t932 * t3822);
    const float t4016 = (t3207 * t3817) + (t3217 * t3830) + (t3219 * t3851) + (t3227 * t3855) +
        (t3231 * t3859) + (t3233 * t3875);
    const float t4021 = t4016 + (t3217 * t3881) + (t18 * t3952) - (t3205 * t3815) - (t3211 *
        t3819) - (t3213 * t3822);
    const float t4024 = t4021 - (t3215 * t3827) - (sin_phi * t3928) - (t27 * t3976);
    const float t4032 = (t2419 * t3827) + (t2483 * t3830) + (t2526 * t3840) + (t2556 * t3847) +
        (t2594 * t3851) + (t2647 * t3855);
    const float t4037 = t4032 + (t2681 * t3859) + (t2703 * t3865) + (t2717 * t3875) + (t2729 *
        t3881) + (t2991 * t3952);
    const float t4042 = t4037 + (t3069 * t3976) + (t620 * t3981) + (t235 * t3996) - (t465 * t4024) -
        (t2144 * t3815);
    const float t4047 = t4042 - (t2291 * t3817) - (t2318 * t3819) - (t2367 * t3822) - (t930 *
        t3928) - (t1640 * t3281);
    const float t4048 = t4047 - (t1644 * t3810);
    const float t4052 = t341 * t2066;
    const float t4054 = t329 * t2066;
    const float t4059 = motion->constants[7] - (motion->constants[7] * t1669);
    const float t4063 = (motion->constants[28] * t1692) - (t693 * motion->constants[28]);
    const float t4069 = (t1671 * t2155) + (cos_theta * t1669);
    const float t4075 = (t2174 * t4059) + (t1669 * t2178) - (t1671 * t2170);
    const float t4081 = (t1671 * t2186) + (t2190 * t4059) + (t1669 * t2194);
    const float t4085 = (t1671 * t2201) - (t750 * t1669);
    const float t4089 = (t1671 * t2208) + (t711 * t1669);
    const float t4095 = (t1671 * t2215) + (t2152 * t4059) + (t1669 * t2220);
    const float t4098 = (motion->constants[54] * t4085) + (motion->constants[24] * t4095) -
        (motion->constants[55] * t4089);
    const float t4102 = (t2149 * t4069) + (t2161 * t4075) + (t2184 * t4081) - (t711 * t4098);
    const float t4110 = t26 * t1671;
    const float t4114 = (sin_delta * t1669) - (t124 * t1671);
    const float t4119 = (t1671 * t2246) + (motion->constants[48] * t4110) - (t2249 * t4059) -
        (t1669 * t2251) - (motion->constants[49] * t4114);
    const float t4124 = (t1671 * t2236) + (t2239 * t4059) + (t1669 * t2241) + (t1692 * t2243) -
        (sin_delta * t4119);
    const float t4127 = (t2145 * t4059) + (motion->constants[41] * t1669) + t4102 + t4124;
    const float t4138 = (t2299 * t4069) + (t2301 * t4075) + (t2161 * t4081) + (t750 * t4098);
    const float t4141 = (t814 * t1669) + (motion->constants[48] * t1692) - (t2294 * t4059) - t4138;
    const float t4150 = (t2326 * t4069) + (t2330 * t4081) + (cos_theta * t4098) - (t2328 * t4075);
    const float t4159 = (t1671 * t2338) + (t2341 * t4059) + (t1669 * t2343) + (t1692 * t2345) +
        (cos_delta * t4119);
    const float t4161 = (t1671 * t2322) + t4150 + t4159;
    const float t4174 = (motion->constants[59] * t4085) + (motion->constants[57] * t4089) +
        (motion->constants[54] * t4095);
    const float t4180 = (motion->constants[58] * t4069) + (motion->constants[55] * t4081) -
        (motion->constants[54] * t4075);
    const float t4186 = (motion->constants[57] * t4085) + (motion->constants[56] * t4089) -
        (motion->constants[55] * t4095);
    const float t4192 = (t1671 * t2376) + (motion->constants[53] * t4110) + (motion->constants[51] *
        t4114) + (motion->constants[30] * t4159) + (t728 * t4174) + (t750 * t4180);
    const float t4196 = t4192 + (t705 * t4186) - (t1538 * t4059) - (t833 * t1669) -
        (motion->constants[32] * t4150);
    const float t4214 = t4063 + (t1671 * t2435) + (t2439 * t4059) + (t1669 * t2442) +
        (motion->constants[52] * t1692);
    const float t4224 = (t2454 * t4059) + (t1669 * t2456) + (motion->constants[51] * t4110) +
        (motion->constants[50] * t4114) - (t1671 * t2452);
    const float t4230 = (t2421 * t4059) + (t1669 * t2424) + (t1692 * t2426) +
        (motion->constants[32] * t4138) + (motion->constants[33] * t4102) + (motion->constants[31] *
        t4124);
    const float t4235 = t4230 + (cos_theta * t4180) + (t711 * t4186) + (cos_delta * t4214) +
        (sin_delta * t4224) - motion->constants[27];
    const float t4236 = t4235 - (t750 * t4174);
    const float t4250 = (t1671 * t2487) + (t705 * t4174) + (t701 * t4186) + (cos_delta * t4224) -
        (motion->constants[33] * t4150) - (motion->constants[31] * t4159);
    const float t4252 = t4250 - (t711 * t4180) - (sin_delta * t4214);
    const float t4262 = (t2527 * t4127) + (t18 * t4252) - (t2529 * t4141) - (t27 * t4196) -
        (sin_phi * t4236);
    const float t4271 = t4236 + (t2559 * t4063) + (t2563 * t4141) + (t363 * t4262) - (t2561 *
        t4127);
    const float t4277 = (t2598 * t4063) + (t2601 * t4271) - (t2596 * t4262);
    const float t4283 = (t2649 * t4063) + (t2648 * t4262) + (t2652 * t4271);
    const float t4289 = (t2688 * t4271) - (t2685 * t4063) - (t2683 * t4262);
    const float t4292 = t2708 * t4283;
    const float t4295 = t4292 - (t2704 * t4277) - (t2710 * t4289);
    const float t4305 = (t14 * t4127) + (t26 * t4141) + (t124 * t4289) - (t26 * t4277) - (t115 *
        t4283);
    const float t4311 = (t2734 * t4283) + (t2737 * t4289) - (t2730 * t4277);
    const float t4336 = (t2797 * t4069) + (t2800 * t4089) + (t2802 * t4075) + (t1301 * t4095) +
        (t1220 * t4180) - (t2793 * t4085);
    const float t4337 = t4336 - (t2805 * t4081);
    const float t4350 = (t2816 * t4085) + (t2820 * t4069) + (t2793 * t4089) + (t2823 * t4075) +
        (t1288 * t4095) + (t2826 * t4081);
    const float t4351 = t4350 - (t1228 * t4180);
    const float t4364 = (t2837 * t4085) + (t2840 * t4089) + (t2844 * t4095) + (t1228 * t4186) -
        (t2842 * t4075) - (t2846 * t4081);
    const float t4365 = t4364 - (t1220 * t4174);
    const float t4380 = (t1671 * t2865) + (t1669 * t2877) + (t2882 * t4110) + (t2887 * t4114) +
        (speeds[1] * t4224) + (t2897 * t4283);
    const float t4383 = t4380 - (t2873 * t4059) - (t2891 * t4277) - (t2900 * t4289);
    const float t4400 = (t1671 * t2916) + (t2924 * t4059) + (t1669 * t2928) + (t2931 * t4110) +
        (t1692 * t2935) + (t2937 * t4114);
    const float t4405 = t4400 + (t2945 * t4277) + (t2948 * t4283) + (t2951 * t4289) + (t2953 *
        t4295) - (speeds[1] * t4214);
    const float t4411 = (t1671 * t2754) + (t1669 * t2766) + (t1692 * t2768) + (t2774 * t4150) +
        (t2776 * t4102) + (t2780 * t4159);
    const float t4416 = t4411 + (t2787 * t4283) + (t2791 * t4289) + (t711 * t4351) + (cos_theta *
        t4365) + (cos_delta * t4383);
    const float t4421 = t4416 + (sin_delta * t4405) - (t2764 * t4059) - (t2770 * t4138) - (t2782 *
        t4124) - (t2760 * t4277);
    const float t4422 = t4421 - (t750 * t4337);
    const float t4446 = (t1671 * t3000) + (t3009 * t4059) + (t1669 * t3015) + (t2772 * t4102) +
        (t984 * t4159) + (t2778 * t4124);
    const float t4451 = t4446 + (t91 * t4196) + (t3005 * t4277) + (t3033 * t4283) + (t3037 *
        t4289) + (t705 * t4337);
    const float t4456 = t4451 + (t701 * t4351) + (cos_delta * t4405) - (t1692 * t3017) - (t3019 *
        t4138) - (t1159 * t4150);
    const float t4458 = t4456 - (t711 * t4365) - (sin_delta * t4383);
    const float t4481 = (t3150 * t4295) + (t3148 * t4114) - (t2937 * t4110);
    const float t4486 = (t1671 * t3081) + (t3096 * t4059) + (t1669 * t3106) + (t1692 * t3112) +
        (t1170 * t4150) + (t3116 * t4102);
    const float t4491 = t4486 + (t982 * t4159) + (t3124 * t4277) + (t3131 * t4283) + (t3139 *
        t4289) + (t91 * t4311);
    const float t4496 = t4491 + (t728 * t4337) + (t705 * t4351) + (t750 * t4365) + t4481 - (t2773 *
        t4138);
    const float t4498 = t4496 - (t3119 * t4124) - (t91 * t4252);
    const float t4507 = t4292 + (t2880 * t4110) - (t2885 * t4114) - (t1046 * t4277) - (t1048 *
        t4289);
    const float t4516 = (t2314 * t4161) + (t970 * t4305);
    const float t4521 = t4422 + (t932 * t4196) + (t3190 * t4283) + (t3192 * t4289) + (t943 *
        t4311) + t4516;
    const float t4522 = t4521 - (t943 * t4252);
    const float t4542 = (t3205 * t4127) + (t3213 * t4196) + (t3219 * t4277) + (t3227 * t4283) +
        (t3231 * t4289) + (t3233 * t4305);
    const float t4547 = t4542 + (t3217 * t4311) + (t18 * t4458) - (t3207 * t4141) - (t3211 *
        t4161) - (t3215 * t4236);
    const float t4550 = t4547 - (t3217 * t4252) - (sin_phi * t4422) - (t27 * t4498);
    const float t4559 = (t328 * t2059) + (t191 * t4052) + (t2077 * t4059) + (t2120 * t4063) +
        (t2144 * t4127) + (t2291 * t4141);
    const float t4564 = t4559 + (t2367 * t4196) + (t2419 * t4236) + (t2526 * t4262) + (t2556 *
        t4271) + (t2594 * t4277);
    const float t4569 = t4564 + (t2647 * t4283) + (t2681 * t4289) + (t2703 * t4295) + (t2717 *
        t4305) + (t2729 * t4311);
    const float t4574 = t4569 + (t2991 * t4458) + (t3069 * t4498) + (t620 * t4507) + (t235 *
        t4522) - (t465 * t4550);
    const float t4579 = t4574 + (t1722 * t4048) - (t328 * t1997) - (t339 * t4054) - (t543 * t1978) -
        (t1671 * t2072);
    const float t4584 = t4579 - (t2318 * t4161) - (t2483 * t4252) - (t930 * t4422) - (t1700 *
        t3281) - (t1716 * t3810);
    const float t4585 = t1759 * t4584;
    const float t4587 = (t1652 * t4048) + (t1722 * t4585);
    const float t4591 = (t1586 * t3810) - (t1644 * t4587) - (t1716 * t4585);
    const float t4597 = (t923 * t3281) - (t1568 * t4591) - (t1640 * t4587) - (t1700 * t4585);
    const float t4600 = motion->constants[47] * t1800;
    const float t4604 = motion->constants[47] * t1815;
    const float t4608 = (cos_delta * (t1927 + (sin_delta * t4600))) - (sin_delta * (t1934 +
        (sin_delta * t4604)));
    const float t4623 = (t14 * t2019) + (t115 * t1963) + (t85 * t4608) - (t240 * t1949) - (t242 *
        t1994);
    const float t4631 = (cos_delta * ((cos_delta * t4600) - t1934)) - (sin_delta * (t1927 +
        (cos_delta * t4604)));
    const float t4636 = (t26 * t4631) + (t242 * t2034) - (t240 * t2041);
    const float t4639 = t1984 + (motion->constants[31] * t4631);
    const float t4643 = (t1800 * t2243) - (t1815 * t2345);
    const float t4660 = (t260 * t2083) + (t264 * t2089) + (t268 * t2094) + (t481 * t2099) + (t629 *
        t2101) + (t634 * t1760);
    const float t4665 = t4660 + (t649 * t2107) + (t675 * t2109) - (t245 * t2080) - (t642 * t2096) -
        (t472 * t2104);
    const float t4674 = (t240 * t1811) + (t242 * t1142) - (t303 * t2134) - (t311 * t2137);
    const float t4682 = (t242 * t1811) + (t303 * t2282) + (t311 * t2284) - (t240 * t1142);
    const float t4688 = (t242 * t1772) - (t240 * t1786);
    const float t4692 = (t303 * t1772) + (t311 * t1766);
    const float t4696 = (t240 * t1772) + (t242 * t1786);
    const float t4711 = (t260 * t2082) + (t268 * t2092) + (t296 * t2511) + (t481 * t2098) + (t486 *
        t1772) + (t512 * t1766);
    const float t4714 = t4711 - (t245 * t2079) - (t264 * t2087) - (t472 * t2515);
    const float t4724 = (t245 * t2541) + (t260 * t2543) + (t264 * t2546) - (t268 * t2548) - (t301 *
        t2550);
    const float t4736 = (t240 * t1014) + (t242 * t1009) + (t264 * t2585) + (t268 * t2589) - (t1026 *
        t2574) - (t1027 * t2574);
    const float t4739 = (t1004 * t2606) - t1018;
    const float t4742 = t996 + (t992 * t2606);
    const float t4752 = (cos_delta * t4739) + (t264 * t2636) - (sin_delta * t4742) - (t240 *
        t2630) - (t242 * t2632) - (t268 * t2640);
    const float t4764 = (cos_delta * t4742) + (sin_delta * t4739) + (t242 * t2667) - (t240 *
        t2665) - (t264 * t2671) - (t268 * t2674);
    const float t4772 = (t245 * t2693) + (t264 * t2697) - (t260 * t2695) - (t268 * t2699);
    const float t4774 = t242 * t981;
    const float t4780 = (t242 * t930) - (speeds[0] * t240);
    const float t4784 = (t240 * t930) + (speeds[0] * t242);
    const float t4793 = (t26 * t2019) + (t247 * t1963) + (t240 * t1994) + (t486 * t2066) + (t872 *
        t4623) + (t2074 * t4636);
    const float t4798 = t4793 + (t910 * t4643) + (t2123 * t4665) + (t2274 * t4674) + (t2310 *
        t4682) + (t1923 * t2464);
    const float t4803 = t4798 + (t2414 * t4688) + (t2475 * t4692) + (t2537 * t4714) + (t2569 *
        t4724) + (t2604 * t4736);
    const float t4808 = t4803 + (t2655 * t4752) + (t2691 * t4764) + (t2713 * t4772) + (t2740 *
        t4774) + (t953 * t2965);
    const float t4813 = t4808 + (t3063 * t4780) + (t3174 * t4784) + (t678 * t3183) + (t313 *
        t3203) - (t516 * t3251);
    const float t4818 = t4813 - (t2232 * t4608) - (t242 * t1949) - (t303 * t2058) - (t649 * t2068) -
        (t861 * t4639);
    const float t4822 = t4818 - (t1919 * t2265) - (t1821 * t2449) - (t2505 * t4696) - (t950 *
        t2910);
    const float t4859 = (t512 * t2066) + (t1536 * t4623) + (t3289 * t4636) + (t3358 * t4674) +
        (t1923 * t3455) + (t3427 * t4688);
    const float t4864 = t4859 + (t3466 * t4692) + (t3492 * t4714) + (t3501 * t4724) + (t3507 *
        t4736) + (t3513 * t4752);
    const float t4869 = t4864 + (t3519 * t4764) + (t3525 * t4772) + (t3541 * t4774) + (t953 *
        t3635) + (t3688 * t4780);
    const float t4874 = t4869 + (t3728 * t4784) + (t678 * t3737) + (t313 * t3752) - (t516 * t3780) -
        (t311 * t2058);
    const float t4879 = t4874 - (t675 * t2068) - (t1534 * t4639) - (t1557 * t4643) - (t3293 *
        t4665) - (t1919 * t3350);
    const float t4884 = t4879 - (t3372 * t4682) - (t1821 * t3445) - (t3482 * t4696) - (t950 *
        t3613) - (t1568 * t4822);
    const float t4911 = (t3827 * t4692) + (t3830 * t4696) + (t3840 * t4714) + (t3847 * t4724) +
        (t3851 * t4736) + (t3855 * t4752);
    const float t4916 = t4911 + (t3859 * t4764) + (t3865 * t4772) + (t3881 * t4774) + (t953 *
        t3917) + (t3952 * t4780);
    const float t4921 = t4916 + (t3976 * t4784) + (t678 * t3981) + (t313 * t3996) - (t516 * t4024) -
        (t3815 * t4674);
    const float t4926 = t4921 - (t3817 * t4682) - (t3822 * t4688) - (t950 * t3909) - (t1640 *
        t4822) - (t1644 * t4884);
    const float t4965 = (t296 * t4052) + (t1671 * t4623) + (t4059 * t4636) + (t1669 * t4639) +
        (t1692 * t4643) + (t4063 * t4665);
    const float t4970 = t4965 + (t4127 * t4674) + (t4141 * t4682) + (t1923 * t4224) + (t4196 *
        t4688) + (t4236 * t4692);
    const float t4975 = t4970 + (t4262 * t4714) + (t4271 * t4724) + (t4277 * t4736) + (t4283 *
        t4752) + (t4289 * t4764);
    const float t4980 = t4975 + (t4295 * t4772) + (t4311 * t4774) + (t953 * t4405) + (t4458 *
        t4780) + (t4498 * t4784);
    const float t4985 = t4980 + (t678 * t4507) + (t313 * t4522) - (t516 * t4550) + (t1722 * t4926) -
        (t472 * t4054);
    const float t4990 = t4985 - (t634 * t1978) - (t1919 * t4119) - (t1821 * t4214) - (t4252 *
        t4696) - (t950 * t4383);
    const float t4993 = t1759 * (t4990 - (t1700 * t4822) - (t1716 * t4884));
    const float t4995 = (t1652 * t4926) + (t1722 * t4993);
    const float t4999 = (t1586 * t4884) - (t1644 * t4995) - (t1716 * t4993);
    const float t5005 = (t923 * t4822) - (t1568 * t4999) - (t1640 * t4995) - (t1700 * t4993);
    const float t5006 = motion->constants[2] * cos_theta;
    const float t5008 = 1.0F - motion->constants[34];
    const float t5013 = (t1888 * t5006) + (sin_theta * ((t1865 * t5008) - (motion->constants[35] *
        t1895)));
    const float t5015 = motion->constants[3] * cos_theta;
    const float t5017 = 1.0F - motion->constants[36];
    const float t5022 = (t1888 * t5015) - (sin_theta * ((t1895 * t5017) - (motion->constants[35] *
        t1865)));
    const float t5028 = (t1900 * t5006) - (t1912 * t5015) - (sin_theta * t1907);
    const float t5034 = (t14 * t5013) + (t26 * t5022) + (t2169 * t5028);
    const float t5036 = t1907 * t5006;
    const float t5038 = t1907 * t5015;
    const float t5042 = (t1900 * t5008) - (motion->constants[35] * t1912);
    const float t5046 = (t1912 * t5017) - (motion->constants[35] * t1900);
    const float t5051 = (t14 * t5038) - (t26 * t5036) - (sin_theta * ((t26 * t5042) + (t14 *
        t5046)));
    const float t5065 = (t1865 * t5006) + (motion->constants[32] * t5038) - (t1895 * t5015) -
        (motion->constants[33] * t5036) - (sin_theta * (t1888 + (motion->constants[33] * t5042) +
        (motion->constants[32] * t5046)));
    const float t5067 = t1834 * t5006;
    const float t5069 = t1834 * t5015;
    const float t5073 = (t1828 * t5008) - (motion->constants[35] * t1840);
    const float t5077 = (t1840 * t5017) - (motion->constants[35] * t1828);
    const float t5082 = (motion->constants[55] * t5067) + (motion->constants[54] * t5069) -
        (sin_theta * ((motion->constants[55] * t5073) - (motion->constants[54] * t5077)));
    const float t5085 = sin_theta * motion->constants[24];
    const float t5087 = (motion->constants[24] * t5069) + (t5077 * t5085);
    const float t5091 = (motion->constants[24] * t5067) - (t5073 * t5085);
    const float t5097 = (t1840 * t5015) - (t1828 * t5006) - (sin_theta * t1834);
    const float t5104 = (t1807 * t5015) + (sin_theta * ((t1794 * t5017) - (motion->constants[35] *
        t1789)));
    const float t5110 = (t1794 * t5015) - (t1789 * t5006) - (sin_theta * t1807);
    const float t5117 = (t1807 * t5006) - (sin_theta * ((t1789 * t5008) - (motion->constants[35] *
        t1794)));
    const float t5124 = (t934 * t5015) + (sin_theta * ((t943 * t5017) - (motion->constants[35] *
        t932)));
    const float t5131 = (t934 * t5006) - (sin_theta * ((t932 * t5008) - (motion->constants[35] *
        t943)));
    const float t5137 = (t943 * t5015) - (t932 * t5006) - (sin_theta * t934);
    const float t5143 = (t26 * t5013) + (t2165 * t5028) + (t872 * t5034) + (t2074 * t5051) +
        (t2159 * t5082) + (t2198 * t5091);
    const float t5148 = t5143 + (t2227 * t5097) + (t2394 * t5110) + (t2400 * t5117) + (t2834 *
        t5131) + (t2855 * t5137);
    const float t5153 = t5148 - (t14 * t5022) - (t861 * t5065) - (t2182 * t5087) - (t2388 * t5104) -
        (t2813 * t5124);
    const float t5173 = (t1536 * t5034) + (t3289 * t5051) + (t3299 * t5082) + (t3311 * t5091) +
        (t3328 * t5097) + (t3411 * t5110);
    const float t5178 = t5173 + (t3417 * t5117) + (t3581 * t5131) + (t3595 * t5137) - (t1534 *
        t5065) - (t3305 * t5087);
    const float t5181 = t5178 - (t3405 * t5104) - (t3567 * t5124) - (t1568 * t5153);
    const float t5195 = (t3814 * t5097) + (motion->constants[77] * t5104) + (t3903 * t5137) -
        motion->constants[5] - (motion->constants[76] * t5117) - (t3891 * t5124);
    const float t5198 = t5195 - (t3895 * t5131) - (t1640 * t5153) - (t1644 * t5181);
    const float t5220 = (t1671 * t5034) + (t4059 * t5051) + (t1669 * t5065) + (t4069 * t5082) +
        (t4081 * t5091) + (t4098 * t5097);
    const float t5225 = t5220 + (t4180 * t5110) + (t4186 * t5117) + (t4351 * t5131) + (t4365 *
        t5137) + (t1722 * t5198);
    const float t5230 = t5225 - (t4075 * t5087) - (t4174 * t5104) - (t4337 * t5124) - (t1700 *
        t5153) - (t1716 * t5181);
    const float t5231 = t1759 * t5230;
    const float t5233 = (t1652 * t5198) + (t1722 * t5231);
    const float t5237 = (t1586 * t5181) - (t1644 * t5233) - (t1716 * t5231);
    const float t5243 = (t923 * t5153) - (t1568 * t5237) - (t1640 * t5233) - (t1700 * t5231);
    const float t5244 = t2314 + t2314;
    const float t5245 = t26 * t5244;
    const float t5247 = t14 * t5244;
    const float t5254 = cos_delta * t930;
    const float t5257 = (t14 * t2314) + (t930 * t2572) + (t2574 * t5254);
    const float t5263 = (t26 * t2314) + (t930 * t2610);
    const float t5265 = motion->constants[30] * t3065;
    const float t5269 = (t2574 * t3065) + (t930 * t2607) + (cos_delta * t5265) - (sin_delta *
        t5263);
    const float t5275 = (cos_delta * t5263) + (sin_delta * t5265) - (t2606 * t5254);
    const float t5288 = (t2274 * t5245) + (t2414 * t3065) + (t2604 * t5257) + (t2655 * t5269) +
        (t2691 * t5275) + (t2740 * t2987);
    const float t5293 = t5288 + (t26 * t3063) + (t14 * t3174) + (t682 * t3183) + (t72 * t3203) +
        (t364 * t3251);
    const float t5297 = t5293 - (t2310 * t5247) - (t930 * t2475) - (t2505 * t2987) - (t2126 *
        t2726);
    const float t5319 = (t3358 * t5245) + (t3372 * t5247) + (t3065 * t3427) + (t3507 * t5257) +
        (t3513 * t5269) + (t3519 * t5275);
    const float t5324 = t5319 + (t2987 * t3541) + (t26 * t3688) + (t14 * t3728) + (t682 * t3737) +
        (t72 * t3752);
    const float t5329 = t5324 + (t364 * t3780) - (t930 * t3466) - (t2987 * t3482) - (t2126 *
        t3535) - (t1568 * t5297);
    const float t5352 = (t3817 * t5247) + (t2987 * t3830) + (t3851 * t5257) + (t3855 * t5269) +
        (t3859 * t5275) + (t2987 * t3881);
    const float t5357 = t5352 + (t26 * t3952) + (t14 * t3976) + (t682 * t3981) + (t72 * t3996) +
        (t364 * t4024);
    const float t5362 = t5357 - (t3815 * t5245) - (t3065 * t3822) - (t930 * t3827) - (t2126 *
        t3875) - (t1640 * t5297);
    const float t5363 = t5362 - (t1644 * t5329);
    const float t5387 = (t4127 * t5245) + (t3065 * t4196) + (t4277 * t5257) + (t4283 * t5269) +
        (t4289 * t5275) + (t2987 * t4311);
    const float t5392 = t5387 + (t26 * t4458) + (t14 * t4498) + (t682 * t4507) + (t72 * t4522) +
        (t364 * t4550);
    const float t5397 = t5392 + (t1722 * t5363) - (t4141 * t5247) - (t930 * t4236) - (t2987 *
        t4252) - (t2126 * t4305);
    const float t5400 = t1759 * (t5397 - (t1700 * t5297) - (t1716 * t5329));
    const float t5402 = (t1652 * t5363) + (t1722 * t5400);
    const float t5406 = (t1586 * t5329) - (t1644 * t5402) - (t1716 * t5400);
    const float t5412 = (t923 * t5297) - (t1568 * t5406) - (t1640 * t5402) - (t1700 * t5400);
    const float t5420 = t3123 + (t950 * t2574);
    const float t5423 = t3128 - (t953 * t2606);
    const float t5426 = t3136 + (t950 * t2606);
    const float t5435 = (t872 * t3078) + (t2074 * t3093) + (t861 * t3102) + (t910 * t3110) + (t953 *
        t2464) + (t2604 * t5420);
    const float t5440 = t5435 + (t2655 * t5423) + (t690 * t3183) + (t89 * t3203) + (t447 * t3251) -
        t3154;
    const float t5442 = t5440 - (t950 * t2449) - (t2691 * t5426);
    const float t5461 = t3711 + (t1536 * t3078) + (t3093 * t3289) + (t1534 * t3102) + (t953 *
        t3455) + (t3507 * t5420);
    const float t5466 = t5461 + (t3513 * t5423) + (t690 * t3737) + (t89 * t3752) + (t447 * t3780) -
        (t1557 * t3110);
    const float t5469 = t5466 - (t950 * t3445) - (t3519 * t5426) - (t1568 * t5442);
    const float t5483 = t3961 + (t3851 * t5420) + (t3855 * t5423) + (t690 * t3981) + (t89 * t3996) +
        (t447 * t4024);
    const float t5486 = t5483 - (t3859 * t5426) - (t1640 * t5442) - (t1644 * t5469);
    const float t5507 = t4481 + (t1671 * t3078) + (t3093 * t4059) + (t1692 * t3110) + (t953 *
        t4224) + (t4277 * t5420);
    const float t5512 = t5507 + (t4283 * t5423) + (t690 * t4507) + (t89 * t4522) + (t447 * t4550) +
        (t1722 * t5486);
    const float t5517 = t5512 - (t1669 * t3102) - (t950 * t4214) - (t4289 * t5426) - (t1700 *
        t5442) - (t1716 * t5469);
    const float t5518 = t1759 * t5517;
    const float t5520 = (t1652 * t5486) + (t1722 * t5518);
    const float t5524 = (t1586 * t5469) - (t1644 * t5520) - (t1716 * t5518);
    const float t5530 = (t923 * t5442) - (t1568 * t5524) - (t1640 * t5520) - (t1700 * t5518);
    const float t5539 = (t1256 * t2394) + (t1199 * t2400) + (motion->constants[2] * t2813) +
        (motion->constants[3] * t2834) - (t1208 * t2388);
    const float t5551 = (t1256 * t3411) + (t1199 * t3417) + (motion->constants[2] * t3567) +
        (motion->constants[3] * t3581) - (t1208 * t3405) - (t1568 * t5539);
    const float t5563 = (t1208 * motion->constants[77]) + (motion->constants[2] * t3891) -
        motion->constants[6] - (t1199 * motion->constants[76]) - (motion->constants[3] * t3895) -
        (t1640 * t5539);
    const float t5564 = t5563 - (t1644 * t5551);
    const float t5578 = (t1256 * t4180) + (t1199 * t4186) + (motion->constants[2] * t4337) +
        (motion->constants[3] * t4351) + (t1722 * t5564) - (t1208 * t4174);
    const float t5581 = t1759 * (t5578 - (t1700 * t5539) - (t1716 * t5551));
    const float t5583 = (t1652 * t5564) + (t1722 * t5581);
    const float t5587 = (t1586 * t5551) - (t1644 * t5583) - (t1716 * t5581);
    const float t5593 = (t923 * t5539) - (t1568 * t5587) - (t1640 * t5583) - (t1700 * t5581);
    const float t5594 = motion->constants[27] * t943;
    const float t5596 = motion->constants[27] * t932;
    const float t5600 = (t14 * t5594) + (t26 * t5596);
    const float t5602 = cos_delta * t2314;
    const float t5604 = sin_delta * t2314;
    const float t5612 = (t26 * t5594) + (t872 * t5600) + (t2655 * t5602) + (t2691 * t5604) + (t693 *
        t3183) + (t328 * t3251);
    const float t5614 = t5612 - t3197 - (t14 * t5596);
    const float t5626 = t3746 + (t1536 * t5600) + (t3513 * t5602) + (t3519 * t5604) + (t693 *
        t3737) + (t328 * t3780);
    const float t5627 = t5626 - (t1568 * t5614);
    const float t5639 = t3990 + (t3855 * t5602) + (t3859 * t5604) + (t693 * t3981) + (t328 *
        t4024) - (t1640 * t5614);
    const float t5640 = t5639 - (t1644 * t5627);
    const float t5654 = t4516 + (t1671 * t5600) + (t4283 * t5602) + (t4289 * t5604) + (t693 *
        t4507) + (t328 * t4550);
    const float t5658 = t1759 * (t5654 + (t1722 * t5640) - (t1700 * t5614) - (t1716 * t5627));
    const float t5660 = (t1652 * t5640) + (t1722 * t5658);
    const float t5664 = (t1586 * t5627) - (t1644 * t5660) - (t1716 * t5658);
    const float t5670 = (t923 * t5614) - (t1568 * t5664) - (t1640 * t5660) - (t1700 * t5658);
    const float t5673 = (t1568 * t1644) - t1640;
    const float t5679 = t1759 * ((t1568 * t1716) + (t1722 * t5673) - t1700);
    const float t5681 = (t1652 * t5673) + (t1722 * t5679);
    const float t5685 = (t1568 * t1586) + (t1644 * t5681) + (t1716 * t5679);
    const float t5691 = t923 + (t1568 * t5685) - (t1640 * t5681) - (t1700 * t5679);
    const float t5695 = t1759 * (t1716 + (t1644 * t1722));
    const float t5697 = (t1644 * t1652) + (t1722 * t5695);
    const float t5701 = t1586 + (t1644 * t5697) + (t1716 * t5695);
    const float t5706 = (t1640 * t5697) + (t1700 * t5695) - (t1568 * t5701);
    const float t5707 = t1722 * t1759;
    const float t5709 = t1652 + (t1722 * t5707);
    const float t5712 = (t1644 * t5709) + (t1716 * t5707);
    const float t5717 = (t1568 * t5712) - (t1640 * t5709) - (t1700 * t5707);
    const float t5718 = -(t98 * t235);
    const float t5719 = -(t98 * t313);
    const float t5720 = -(t72 * t98);
    const float t5721 = -(t89 * t98);
    const float t5722 = -t98;
    const float t5723 = -(t93 * cos_psi);
    const float t5724 = -(t235 * t318);
    const float t5725 = -(t313 * t318);
    const float t5726 = -(t72 * t318);
    const float t5727 = -(t89 * t318);
    const float t5728 = -t318;
    const float t5729 = -t364;
    const float t5730 = -t447;
    const float t5731 = -t328;
    const float t5732 = -t5685;
    const float t5733 = -t5712;
    const float t5734 = -t5697;
    const float t5735 = -t5695;
    linearization->a[0][0] = 0.0F;
    linearization->a[0][1] = 0.0F;
    linearization->a[0][2] = t96;
    linearization->a[0][3] = t5718;
    linearization->a[0][4] = 0.0F;
    linearization->a[0][5] = t5719;
    linearization->a[0][6] = 0.0F;
    linearization->a[0][7] = 0.0F;
    linearization->a[0][8] = 0.0F;
    linearization->a[0][9] = t5720;
    linearization->a[0][10] = t5721;
    linearization->a[0][11] = 0.0F;
    linearization->a[0][12] = t5722;
    linearization->b[0][0] = 0.0F;
    linearization->b[0][1] = 0.0F;
    linearization->b[0][2] = 0.0F;
    linearization->a[1][0] = 0.0F;
    linearization->a[1][1] = 0.0F;
    linearization->a[1][2] = t5723;
    linearization->a[1][3] = t5724;
    linearization->a[1][4] = 0.0F;
    linearization->a[1][5] = t5725;
    linearization->a[1][6] = 0.0F;
    linearization->a[1][7] = 0.0F;
    linearization->a[1][8] = 0.0F;
    linearization->a[1][9] = t5726;
    linearization->a[1][10] = t5727;
    linearization->a[1][11] = 0.0F;
    linearization->a[1][12] = t5728;
    linearization->b[1][0] = 0.0F;
    linearization->b[1][1] = 0.0F;
    linearization->b[1][2] = 0.0F;
    linearization->a[2][0] = 0.0F;
    linearization->a[2][1] = 0.0F;
    linearization->a[2][2] = 0.0F;
    linearization->a[2][3] = t465;
    linearization->a[2][4] = 0.0F;
    linearization->a[2][5] = t516;
    linearization->a[2][6] = 0.0F;
    linearization->a[2][7] = 0.0F;
    linearization->a[2][8] = 0.0F;
    linearization->a[2][9] = t5729;
    linearization->a[2][10] = t5730;
    linearization->a[2][11] = 0.0F;
    linearization->a[2][12] = t5731;
    linearization->b[2][0] = 0.0F;
    linearization->b[2][1] = 0.0F;
    linearization->b[2][2] = 0.0F;
    linearization->a[3][0] = 0.0F;
    linearization->a[3][1] = 0.0F;
    linearization->a[3][2] = 0.0F;
    linearization->a[3][3] = 0.0F;
    linearization->a[3][4] = 0.0F;
    linearization->a[3][5] = 0.0F;
    linearization->a[3][6] = 0.0F;
    linearization->a[3][7] = 0.0F;
    linearization->a[3][8] = 0.0F;
    linearization->a[3][9] = 1.0F;
    linearization->a[3][10] = 0.0F;
    linearization->a[3][11] = 0.0F;
    linearization->a[3][12] = 0.0F;
    linearization->b[3][0] = 0.0F;
    linearization->b[3][1] = 0.0F;
    linearization->b[3][2] = 0.0F;
    linearization->a[4][0] = 0.0F;
    linearization->a[4][1] = 0.0F;
    linearization->a[4][2] = 0.0F;
    linearization->a[4][3] = t235;
    linearization->a[4][4] = 0.0F;
    linearization->a[4][5] = t313;
    linearization->a[4][6] = 0.0F;
    linearization->a[4][7] = 0.0F;
    linearization->a[4][8] = 0.0F;
    linearization->a[4][9] = t72;
    linearization->a[4][10] = t89;
    linearization->a[4][11] = 0.0F;
    linearization->a[4][12] = 0.0F;
    linearization->b[4][0] = 0.0F;
    linearization->b[4][1] = 0.0F;
    linearization->b[4][2] = 0.0F;
    linearization->a[5][0] = 0.0F;
    linearization->a[5][1] = 0.0F;
    linearization->a[5][2] = 0.0F;
    linearization->a[5][3] = 0.0F;
    linearization->a[5][4] = 0.0F;
    linearization->a[5][5] = 0.0F;
    linearization->a[5][6] = 0.0F;
    linearization->a[5][7] = 0.0F;
    linearization->a[5][8] = 0.0F;
    linearization->a[5][9] = 0.0F;
    linearization->a[5][10] = 1.0F;
    linearization->a[5][11] = 0.0F;
    linearization->a[5][12] = 0.0F;
    linearization->b[5][0] = 0.0F;
    linearization->b[5][1] = 0.0F;
    linearization->b[5][2] = 0.0F;
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
    linearization->a[6][10] = 0.0F;
    linearization->a[6][11] = 1.0F;
    linearization->a[6][12] = 0.0F;
    linearization->b[6][0] = 0.0F;
    linearization->b[6][1] = 0.0F;
    linearization->b[6][2] = 0.0F;
    linearization->a[7][0] = 0.0F;
    linearization->a[7][1] = 0.0F;
    linearization->a[7][2] = 0.0F;
    linearization->a[7][3] = 0.0F;
    linearization->a[7][4] = 0.0F;
    linearization->a[7][5] = 0.0F;
    linearization->a[7][6] = 0.0F;
    linearization->a[7][7] = 0.0F;
    linearization->a[7][8] = 0.0F;
    linearization->a[7][9] = 0.0F;
    linearization->a[7][10] = 0.0F;
    linearization->a[7][11] = 0.0F;
    linearization->a[7][12] = 1.0F;
    linearization->b[7][0] = 0.0F;
    linearization->b[7][1] = 0.0F;
    linearization->b[7][2] = 0.0F;
    linearization->a[8][0] = 0.0F;
    linearization->a[8][1] = 0.0F;
    linearization->a[8][2] = 0.0F;
    linearization->a[8][3] = t620;
    linearization->a[8][4] = 0.0F;
    linearization->a[8][5] = t678;
    linearization->a[8][6] = 0.0F;
    linearization->a[8][7] = 0.0F;
    linearization->a[8][8] = 0.0F;
    linearization->a[8][9] = t682;
    linearization->a[8][10] = t690;
    linearization->a[8][11] = 0.0F;
    linearization->a[8][12] = t693;
    linearization->b[8][0] = 0.0F;
    linearization->b[8][1] = 0.0F;
    linearization->b[8][2] = 0.0F;
    linearization->a[9][0] = 0.0F;
    linearization->a[9][1] = 0.0F;
    linearization->a[9][2] = 0.0F;
    linearization->a[9][3] = t4597;
    linearization->a[9][4] = 0.0F;
    linearization->a[9][5] = t5005;
    linearization->a[9][6] = t5243;
    linearization->a[9][7] = 0.0F;
    linearization->a[9][8] = 0.0F;
    linearization->a[9][9] = t5412;
    linearization->a[9][10] = t5530;
    linearization->a[9][11] = t5593;
    linearization->a[9][12] = t5670;
    linearization->b[9][0] = t5691;
    linearization->b[9][1] = t5706;
    linearization->b[9][2] = t5717;
    linearization->a[10][0] = 0.0F;
    linearization->a[10][1] = 0.0F;
    linearization->a[10][2] = 0.0F;
    linearization->a[10][3] = t4591;
    linearization->a[10][4] = 0.0F;
    linearization->a[10][5] = t4999;
    linearization->a[10][6] = t5237;
    linearization->a[10][7] = 0.0F;
    linearization->a[10][8] = 0.0F;
    linearization->a[10][9] = t5406;
    linearization->a[10][10] = t5524;
    linearization->a[10][11] = t5587;
    linearization->a[10][12] = t5664;
    linearization->b[10][0] = t5732;
    linearization->b[10][1] = t5701;
    linearization->b[10][2] = t5733;
    linearization->a[11][0] = 0.0F;
    linearization->a[11][1] = 0.0F;
    linearization->a[11][2] = 0.0F;
    linearization->a[11][3] = t4587;
    linearization->a[11][4] = 0.0F;
    linearization->a[11][5] = t4995;
    linearization->a[11][6] = t5233;
    linearization->a[11][7] = 0.0F;
    linearization->a[11][8] = 0.0F;
    linearization->a[11][9] = t5402;
    linearization->a[11][10] = t5520;
    linearization->a[11][11] = t5583;
    linearization->a[11][12] = t5660;
    linearization->b[11][0] = t5681;
    linearization->b[11][1] = t5734;
    linearization->b[11][2] = t5709;
    linearization->a[12][0] = 0.0F;
    linearization->a[12][1] = 0.0F;
    linearization->a[12][2] = 0.0F;
    linearization->a[12][3] = t4585;
    linearization->a[12][4] = 0.0F;
    linearization->a[12][5] = t4993;
    linearization->a[12][6] = t5231;
    linearization->a[12][7] = 0.0F;
    linearization->a[12][8] = 0.0F;
    linearization->a[12][9] = t5400;
    linearization->a[12][10] = t5518;
    linearization->a[12][11] = t5581;
    linearization->a[12][12] = t5658;
    linearization->b[12][0] = t5679;
    linearization->b[12][1] = t5735;
    linearization->b[12][2] = t5707;
}

carvallo_motion_error_t whipple_leaning_f32_motion_linearize(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    const float forces[WHIPPLE_LEANING_FORCES], whipple_leaning_f32_linearization_t *linearization)
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_LEANING_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_LEANING_FORCES)) {
        bool are_finite = true;
        whipple_leaning_f32_compute_linearization(motion, positions, speeds, forces, linearization);
        for (size_t row = 0U; row < WHIPPLE_LEANING_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f32(linearization->a[row],
                WHIPPLE_LEANING_STATES) && carvallo_are_finite_f32(linearization->b[row],
                WHIPPLE_LEANING_FORCES);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_leaning_f32_compute_by_parameters(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    const float forces[WHIPPLE_LEANING_FORCES],
    float by_parameters[WHIPPLE_LEANING_STATES][WHIPPLE_LEANING_PARAMETERS])
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
    const float t40 = (cos_delta * sin_phi) + (t16 * sin_delta);
    const float t41 = motion->constants[8] * t40;
    const float t48 = motion->constants[30] + (cos_delta * motion->constants[37]);
    const float t51 = (t36 * t41) + (t7 * motion->constants[39]) + (t12 * t48);
    const float t53 = 1.0F / (cos_phi * t51);
    const float t55 = motion->constants[2] * t13;
    const float t56 = t55 - (motion->constants[3] * t16);
    const float t57 = t53 * t56;
    const float t58 = t7 * t57;
    const float t63 = t51 - (t7 * motion->constants[31]) - (t12 * motion->constants[30]);
    const float t64 = sin_phi * t53;
    const float t65 = t63 * t64;
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t70 = motion->constants[7] * cos_psi;
    const float t71 = speeds[1] * t70;
    const float t73 = t12 * sin_phi;
    const float t74 = t53 * t73;
    const float t75 = t71 * t74;
    const float t77 = t7 * t64;
    const float t78 = t71 * t77;
    const float t80 = t26 * t26;
    const float t81 = t21 * t80;
    const float t83 = t26 * 0.5F;
    const float t85 = cos_phi * (t13 + t13);
    const float t86 = t83 * t85;
    const float t87 = t81 * t86;
    const float t89 = t12 * cos_delta;
    const float t91 = t13 * t80;
    const float t93 = (cos_phi * t26) - (t86 * t91);
    const float t96 = t32 + (t7 * t87) + (t89 * t93);
    const float t97 = t41 * t96;
    const float t98 = t7 * t53;
    const float t101 = t70 * speeds[0];
    const float t103 = (t71 * t98) + (t53 * t101);
    const float t107 = t7 * cos_delta;
    const float t109 = t28 + (sin_phi * t107);
    const float t112 = (sin_phi * t30) + (t93 * t109) - (t73 * t87);
    const float t114 = t48 + (t41 * t112);
    const float t117 = (t12 * t32) - (t7 * t30);
    const float t119 = sin_delta * motion->constants[37];
    const float t123 = (t12 * motion->constants[39]) - (t7 * t48);
    const float t126 = (cos_phi * t119) - (t41 * t117) - (sin_phi * t123);
    const float t129 = (t12 * motion->constants[31]) - (t7 * motion->constants[30]);
    const float t131 = t126 + (sin_phi * t129);
    const float t135 = t53 * ((t7 * t131) + (t63 * t73));
    const float t136 = cos_phi * t53;
    const float t137 = t135 * t136;
    const float t139 = sin_phi * motion->constants[7];
    const float t140 = t126 + t139;
    const float t141 = t53 * t140;
    const float t142 = t136 * t141;
    const float t145 = (t71 * t137) + (t101 * t142) - t75;
    const float t147 = sin_phi * t103;
    const float t153 = (motion->constants[30] * t75) + (t97 * t103) + (t114 * t145) +
        (motion->constants[39] * t147) - (t65 * t71) - (motion->constants[31] * t78);
    const float t155 = t12 * t57;
    const float t156 = t53 * t131;
    const float t160 = t28 * motion->constants[8];
    const float t162 = cos_phi * cos_delta;
    const float t165 = t162 * (t21 + t21);
    const float t166 = t83 * t165;
    const float t168 = (t81 * t166) - (t26 * t162);
    const float t170 = t91 * t166;
    const float t173 = (t89 * t170) - t30 - (t7 * t168);
    const float t175 = (t117 * t160) + (t41 * t173);
    const float t182 = (sin_phi * t32) + (t73 * t168) + (t109 * t170);
    const float t185 = motion->constants[39] + (t36 * t160) + (t41 * t182);
    const float t192 = (motion->constants[31] * t75) + (motion->constants[30] * t78) + (t103 *
        t175) + (t145 * t185) - (t71 * t156) - (t48 * t147);
    const float t198 = (t7 * t145) + (t12 * t147);
    const float t200 = (t7 * t75) + t198 - (t12 * t78);
    const float t208 = (t12 * t75) + (t7 * t78) + (t12 * t145) - (t7 * t147);
    const float t210 = (motion->constants[2] * t200) + (motion->constants[3] * t208);
    const float t212 = (t155 * t192) + t210 - (t58 * t153);
    const float t218 = (t89 * t145) - (t28 * t103) - (t107 * t147);
    const float t221 = t20 - (cos_phi * t107);
    const float t225 = t53 * (t56 - t55 - (motion->constants[3] * t221));
    const float t226 = t7 * t225;
    const float t228 = t12 * t225;
    const float t233 = t210 + (t192 * t228) - (motion->constants[2] * t198) -
        (motion->constants[3] * t218) - (t153 * t226);
    const float t237 = motion->constants[0] + motion->constants[1];
    const float t241 = (motion->constants[3] * motion->constants[8]) - (motion->constants[2] *
        (motion->constants[0] - t237));
    const float t245 = cos_phi * t48;
    const float t247 = cos_phi * motion->constants[39];
    const float t255 = motion->constants[8] * t83;
    const float t256 = t165 * t255;
    const float t258 = t85 * t255;
    const float t276 = (motion->constants[3] * ((t16 * motion->constants[7]) + (t13 * t237) -
        (cos_pitch * t245) - (sin_pitch * t247))) + (t221 * t241);
    const float t279 = t276 + (t13 * motion->constants[37]) - (motion->constants[3] * ((cos_pitch *
        t256) + (sin_pitch * t258))) - (motion->constants[2] * ((cos_pitch * t247) + (t13 *
        motion->constants[7]) - (sin_pitch * t245) - (t16 * t237)));
    const float t281 = t53 * (t279 - (motion->constants[2] * ((cos_pitch * t258) - (sin_pitch *
        t256))));
    const float t283 = t7 + (t7 * t281);
    const float t286 = t12 + (t12 * t281);
    const float t292 = (motion->constants[37] * t198) + (t218 * t241) + (motion->constants[30] *
        t200) + (t192 * t286) - (motion->constants[31] * t208) - (t153 * t283);
    const float t297 = (speeds[0] * t141) + (speeds[1] * t135);
    const float t298 = speeds[3] + t297;
    const float t304 = motion->constants[3] * t13;
    const float t307 = t53 * ((motion->constants[2] * t16) + t304 - cos_phi);
    const float t308 = t7 * t307;
    const float t310 = t12 * t307;
    const float t316 = (motion->constants[3] * t200) + (t192 * t310) - (cos_psi * t298) - (t64 *
        t101) - (motion->constants[2] * t208) - (t153 * t308);
    const float t317 = t40 * t117;
    const float t319 = t36 * t40;
    const float t326 = t53 * (t25 + (motion->constants[2] * t221) - t304);
    const float t327 = t7 * t326;
    const float t329 = t12 * t326;
    const float t335 = (t103 * t317) + (t145 * t319) + (motion->constants[2] * t218) + (t192 *
        t329) - (motion->constants[3] * t198) - (t153 * t327);
    const float t337 = motion->constants[7] * sin_psi;
    const float t338 = speeds[1] * t337;
    const float t340 = t74 * t338;
    const float t342 = t77 * t338;
    const float t345 = speeds[0] * t337;
    const float t347 = (t98 * t338) + (t53 * t345);
    const float t352 = (t137 * t338) + (t142 * t345) - t340;
    const float t354 = sin_phi * t347;
    const float t360 = (motion->constants[30] * t340) + (t97 * t347) + (t114 * t352) +
        (motion->constants[39] * t354) - (t65 * t338) - (motion->constants[31] * t342);
    const float t372 = (motion->constants[31] * t340) + (motion->constants[30] * t342) + (t175 *
        t347) + (t185 * t352) - (t156 * t338) - (t48 * t354);
    const float t378 = (t7 * t352) + (t12 * t354);
    const float t380 = (t7 * t340) + t378 - (t12 * t342);
    const float t388 = (t12 * t340) + (t7 * t342) + (t12 * t352) - (t7 * t354);
    const float t390 = (motion->constants[2] * t380) + (motion->constants[3] * t388);
    const float t392 = (t155 * t372) + t390 - (t58 * t360);
    const float t398 = (t89 * t352) - (t28 * t347) - (t107 * t354);
    const float t405 = t390 + (t228 * t372) - (motion->constants[2] * t378) -
        (motion->constants[3] * t398) - (t226 * t360);
    const float t416 = (motion->constants[37] * t378) + (t241 * t398) + (motion->constants[30] *
        t380) + (t286 * t372) - (motion->constants[31] * t388) - (t283 * t360);
    const float t427 = (motion->constants[3] * t380) + (t310 * t372) - (t298 * sin_psi) - (t64 *
        t345) - (motion->constants[2] * t388) - (t308 * t360);
    const float t438 = (t317 * t347) + (t319 * t352) + (motion->constants[2] * t398) + (t329 *
        t372) - (motion->constants[3] * t378) - (t327 * t360);
    const float t442 = 1.0F / ((t51 * t117) + (t36 * t140));
    const float t443 = motion->constants[7] * t442;
    const float t444 = t112 * t443;
    const float t446 = t36 * t442;
    const float t453 = (t25 * motion->constants[8]) + (sin_phi * t119) + (cos_phi * t123) -
        (cos_phi * t129);
    const float t456 = (sin_phi * t453) + (cos_phi * t131);
    const float t458 = t117 * t442;
    const float t459 = cos_phi * t63;
    const float t463 = (t73 * t446) - (t7 * t458);
    const float t464 = motion->constants[8] * t463;
    const float t468 = (t13 * t63) - (t7 * t453);
    const float t469 = t442 * t468;
    const float t473 = (t73 * t453) + (t13 * t131);
    const float t474 = t442 * t473;
    const float t479 = (t446 * t456) + (t458 * t459) + (t86 * t464) + (t96 * t469) + (t112 * t474);
    const float t481 = sin_phi * t51;
    const float t483 = sin_phi * t140;
    const float t485 = (t117 * t481) + (t36 * t483);
    const float t486 = t442 * t485;
    const float t487 = speeds[1] * t486;
    const float t489 = t13 * t458;
    const float t492 = (speeds[1] * t489) + (t74 * t487);
    const float t494 = t13 * sin_phi;
    const float t496 = cos_phi * t463;
    const float t497 = (t446 * t494) - t496;
    const float t500 = (speeds[1] * t497) + (t77 * t487);
    const float t504 = (t51 * t96) + (t112 * t140);
    const float t505 = t36 * t443;
    const float t506 = t442 * t505;
    const float t513 = t442 * ((t117 * t468) + (t36 * t473) + (t135 * t485));
    const float t514 = t442 * t513;
    const float t516 = t141 * t486;
    const float t517 = t442 * t516;
    const float t520 = (speeds[3] * t506) + (speeds[1] * t514) + (speeds[0] * t517);
    const float t524 = (t96 * t481) + (t112 * t483);
    const float t525 = t135 * t442;
    const float t527 = t141 * t442;
    const float t529 = (speeds[1] * t525) + (speeds[0] * t527);
    const float t531 = t13 * t446;
    const float t534 = speeds[0] * t486;
    const float t537 = sin_phi * t36;
    const float t542 = (t36 * t520) - (speeds[1] * t531) - (t98 * t487) - (t53 * t534) - (t529 *
        t537);
    const float t547 = sin_phi * t117;
    const float t552 = (t137 * t487) + (t142 * t534) + (t117 * t520) - t492 - (t529 * t547);
    const float t556 = (speeds[1] * t496) + (sin_phi * t542);
    const float t562 = (motion->constants[30] * t492) + (t504 * t520) + (t114 * t552) - (speeds[3] *
        t444) - (speeds[1] * t479) - (t65 * t487);
    const float t566 = t562 - (motion->constants[31] * t500) - (t524 * t529) - (t97 * t542) -
        (motion->constants[39] * t556);
    const float t568 = t182 * t443;
    const float t576 = (t173 * t469) + (t182 * t474) - (t453 * t458) - (t166 * t464);
    const float t583 = (t51 * t173) + (t140 * t182);
    const float t587 = (t173 * t481) + (t182 * t483);
    const float t596 = (motion->constants[31] * t492) + (motion->constants[30] * t500) + (t520 *
        t583) + (t185 * t552) + (t48 * t556) - (speeds[3] * t568);
    const float t600 = t596 - (speeds[1] * t576) - (t156 * t487) - (t529 * t587) - (t175 * t542);
    const float t606 = (t7 * t552) - (t12 * t556);
    const float t608 = (t7 * t492) + t606 - (t12 * t500);
    const float t616 = (t12 * t492) + (t7 * t500) + (t12 * t552) + (t7 * t556);
    const float t618 = (motion->constants[2] * t608) + (motion->constants[3] * t616);
    const float t620 = (t155 * t600) + t618 - (t58 * t566);
    const float t622 = t20 * t463;
    const float t629 = (t28 * t542) + (t89 * t552) + (t107 * t556) - (speeds[1] * t622);
    const float t636 = t618 + (t228 * t600) - (motion->constants[2] * t606) -
        (motion->constants[3] * t629) - (t226 * t566);
    const float t647 = (motion->constants[37] * t606) + (t241 * t629) + (motion->constants[30] *
        t608) + (t286 * t600) - (motion->constants[31] * t616) - (t283 * t566);
    const float t651 = sin_phi * t537;
    const float t661 = (t520 * t537) + (motion->constants[3] * t608) + (t310 * t600) - (speeds[3] *
        t446) - (t64 * t534) - (t529 * t651);
    const float t663 = t661 - (motion->constants[2] * t616) - (t308 * t566);
    const float t664 = t25 * t463;
    const float t676 = (t319 * t552) + (motion->constants[2] * t629) + (t329 * t600) - (speeds[1] *
        t664) - (t317 * t542) - (motion->constants[3] * t606);
    const float t677 = t676 - (t327 * t566);
    const float t679 = speeds[1] * t74;
    const float t681 = speeds[1] * t77;
    const float t685 = (speeds[1] * t98) + (t53 * speeds[0]);
    const float t690 = t679 - (speeds[1] * t137) - (speeds[0] * t142);
    const float t692 = sin_phi * t685;
    const float t698 = (t65 * speeds[1]) + (motion->constants[31] * t681) + (t114 * t690) -
        (motion->constants[30] * t679) - (t97 * t685) - (motion->constants[39] * t692);
    const float t710 = (speeds[1] * t156) + (t185 * t690) + (t48 * t692) - (motion->constants[31] *
        t679) - (motion->constants[30] * t681) - (t175 * t685);
    const float t716 = (t7 * t690) - (t12 * t692);
    const float t718 = (t12 * t681) + t716 - (t7 * t679);
    const float t726 = (t12 * t690) + (t7 * t692) - (t12 * t679) - (t7 * t681);
    const float t728 = (motion->constants[2] * t718) + (motion->constants[3] * t726);
    const float t730 = (t155 * t710) + t728 - (t58 * t698);
    const float t736 = (t28 * t685) + (t89 * t690) + (t107 * t692);
    const float t743 = t728 + (t228 * t710) - (motion->constants[2] * t716) -
        (motion->constants[3] * t736) - (t226 * t698);
    const float t754 = (motion->constants[37] * t716) + (t241 * t736) + (motion->constants[30] *
        t718) + (t286 * t710) - (motion->constants[31] * t726) - (t283 * t698);
    const float t763 = (t64 * speeds[0]) + (motion->constants[3] * t718) + (t310 * t710) -
        (motion->constants[2] * t726) - (t308 * t698);
    const float t774 = (t319 * t690) + (motion->constants[2] * t736) + (t329 * t710) - (t317 *
        t685) - (motion->constants[3] * t716) - (t327 * t698);
    const float t775 = 1.0F / motion->constants[8];
    const float t776 = motion->constants[7] * t775;
    const float t777 = t96 * t776;
    const float t779 = speeds[1] * t775;
    const float t784 = (t7 * t36) + (t73 * t117);
    const float t785 = motion->constants[8] * t784;
    const float t792 = (t117 * t456) + (t86 * t785) + (t96 * t473) - (t36 * t459) - (t112 * t468);
    const float t796 = (t36 * t51) - (t117 * t140);
    const float t797 = t775 * t796;
    const float t798 = speeds[3] * t797;
    const float t800 = t779 * t796;
    const float t804 = (t36 * t481) - (t117 * t483);
    const float t807 = (t486 * t800) - (t779 * t804);
    const float t809 = t13 * t36;
    const float t814 = (t489 * t800) + (t74 * t807) - (t779 * t809);
    const float t817 = cos_phi * t784;
    const float t818 = (t117 * t494) - t817;
    const float t823 = (t779 * t818) + (t497 * t800) + (t77 * t807);
    const float t827 = (t51 * t112) - (t96 * t140);
    const float t828 = t505 * t775;
    const float t831 = t516 * t775;
    const float t834 = (speeds[3] * t828) + (t513 * t779) + (speeds[0] * t831);
    const float t838 = (t112 * t481) - (t96 * t483);
    const float t840 = t141 * t775;
    const float t842 = (t135 * t779) + (speeds[0] * t840);
    const float t846 = speeds[0] * t797;
    const float t849 = (t506 * t798) + (t514 * t800) + (t517 * t846);
    const float t853 = (t525 * t800) + (t527 * t846);
    const float t855 = t13 * t117;
    const float t859 = t775 * t804;
    const float t862 = (t486 * t846) - (speeds[0] * t859);
    const float t872 = (t779 * t855) + (t531 * t800) + (t98 * t807) + (t53 * t862) + (t547 * t842) +
        (t537 * t853);
    const float t874 = t872 - (t117 * t834) - (t36 * t849);
    const float t886 = t814 + (t36 * t834) + (t547 * t853) - (t137 * t807) - (t142 * t862) - (t537 *
        t842);
    const float t887 = t886 - (t117 * t849);
    const float t893 = (t779 * t817) + (t496 * t800) - (sin_phi * t874);
    const float t899 = (speeds[3] * t777) + (t779 * t792) + (t444 * t798) + (t479 * t800) + (t65 *
        t807) + (motion->constants[31] * t823);
    const float t904 = t899 + (t827 * t834) + (t524 * t853) + (t114 * t887) +
        (motion->constants[39] * t893) - (motion->constants[30] * t814);
    const float t907 = t904 - (t838 * t842) - (t504 * t849) - (t97 * t874);
    const float t909 = t173 * t776;
    const float t917 = (t36 * t453) + (t173 * t473) - (t166 * t785) - (t182 * t468);
    const float t926 = (t51 * t182) - (t140 * t173);
    const float t930 = (t182 * t481) - (t173 * t483);
    const float t941 = (speeds[3] * t909) + (t779 * t917) + (t568 * t798) + (t576 * t800) + (t156 *
        t807) + (t834 * t926);
    const float t946 = t941 + (t587 * t853) + (t185 * t887) - (motion->constants[31] * t814) -
        (motion->constants[30] * t823) - (t842 * t930);
    const float t949 = t946 - (t583 * t849) - (t175 * t874) - (t48 * t893);
    const float t955 = (t7 * t887) + (t12 * t893);
    const float t957 = (t12 * t823) + t955 - (t7 * t814);
    const float t965 = (t12 * t887) - (t12 * t814) - (t7 * t823) - (t7 * t893);
    const float t967 = (motion->constants[2] * t957) + (motion->constants[3] * t965);
    const float t969 = (t155 * t949) + t967 - (t58 * t907);
    const float t971 = t20 * t784;
    const float t980 = (t779 * t971) + (t622 * t800) + (t28 * t874) + (t89 * t887) - (t107 * t893);
    const float t987 = t967 + (t228 * t949) - (motion->constants[2] * t955) -
        (motion->constants[3] * t980) - (t226 * t907);
    const float t998 = (motion->constants[37] * t955) + (t241 * t980) + (motion->constants[30] *
        t957) + (t286 * t949) - (motion->constants[31] * t965) - (t283 * t907);
    const float t999 = t117 * t775;
    const float t1004 = sin_phi * t547;
    const float t1016 = (speeds[3] * t999) + (t446 * t798) + (t64 * t862) + (t842 * t1004) + (t651 *
        t853) + (motion->constants[3] * t957);
    const float t1021 = t1016 + (t310 * t949) - (t547 * t834) - (t537 * t849) -
        (motion->constants[2] * t965) - (t308 * t907);
    const float t1029 = t775 * ((t117 * t473) + (t513 * t796) - (t36 * t468) - (t135 * t804));
    const float t1030 = t775 * t1029;
    const float t1031 = speeds[1] * t1030;
    const float t1035 = t775 * ((motion->constants[7] * t117) + (t505 * t796));
    const float t1036 = t775 * t1035;
    const float t1038 = t25 * t784;
    const float t1043 = t775 * ((t516 * t796) - (t141 * t804));
    const float t1044 = t775 * t1043;
    const float t1057 = (t779 * t1038) + (t664 * t800) + (t319 * t887) + (motion->constants[2] *
        t980) + (t329 * t949) - t1031;
    const float t1062 = t1057 - (speeds[3] * t1036) - (speeds[0] * t1044) - (t317 * t874) -
        (motion->constants[3] * t955) - (t327 * t907);
    float sin_theta = 0.0F;
    float cos_theta = 0.0F;
    carvallo_sin_cos_f32(positions[6], &sin_theta, &cos_theta);
    const float t1068 = 1.0F - cos_theta;
    const float t1071 = cos_theta + (t1068 * motion->constants[34]);
    const float t1075 = t1068 * motion->constants[35];
    const float t1077 = t1075 * motion->constants[57];
    const float t1081 = motion->constants[2] * sin_theta;
    const float t1091 = sin_delta * motion->constants[66];
    const float t1092 = sin_delta * t1091;
    const float t1095 = t1075 * motion->constants[54];
    const float t1098 = cos_theta + (t1068 * motion->constants[36]);
    const float t1101 = t1095 + (t1098 * motion->constants[55]);
    const float t1102 = motion->constants[33] * t1101;
    const float t1107 = t1102 + t1102 + motion->constants[63] + motion->constants[68];
    const float t1111 = motion->constants[45] + motion->constants[50] + (t1071 * ((t1071 *
        motion->constants[56]) + t1077)) + (t1081 * t1081 * motion->constants[58]) + (t1075 *
        ((t1071 * motion->constants[57]) + (t1075 * motion->constants[59])));
    const float t1113 = t1111 + t1107 - t1092;
    const float t1118 = (motion->constants[56] * t1075) + (motion->constants[57] * t1098);
    const float t1120 = motion->constants[3] * sin_theta;
    const float t1121 = motion->constants[58] * t1120;
    const float t1124 = t1077 + (motion->constants[59] * t1098);
    const float t1130 = t1075 * motion->constants[55];
    const float t1131 = (t1071 * motion->constants[54]) + t1130;
    const float t1134 = cos_delta * motion->constants[48];
    const float t1135 = motion->constants[30] * t1134;
    const float t1136 = (motion->constants[32] * t1131) - t1135;
    const float t1139 = motion->constants[65] + motion->constants[71] - t1136 - t1136;
    const float t1144 = motion->constants[46] + motion->constants[53] + (t1075 * t1118) + (t1120 *
        t1121) + (t1098 * t1124) + t1139;
    const float t1145 = t1144 - t1113;
    const float t1146 = t7 * t7;
    const float t1148 = t7 * t12;
    const float t1161 = (cos_delta * motion->constants[51]) - (motion->constants[31] * t1134);
    const float t1166 = motion->constants[42] + (t1071 * t1118) + (t1075 * t1124) + (t1101 *
        motion->constants[32]) + motion->constants[64] + t1161;
    const float t1170 = t1166 - (t1081 * t1121) - (motion->constants[33] * t1131) -
        motion->constants[69] - motion->constants[70];
    const float t1171 = t1170 + t1170;
    const float t1173 = (t1145 * t1146) + (t1148 * t1171);
    const float t1179 = t1101 + motion->constants[41] + motion->constants[62] +
        motion->constants[72];
    const float t1184 = motion->constants[40] + motion->constants[67];
    const float t1187 = t1131 + t1134 + t1184 - motion->constants[61];
    const float t1189 = (t12 * t1179) - (t7 * t1187);
    const float t1190 = motion->constants[7] * t1189;
    const float t1193 = motion->constants[74] - t1190 - t1190;
    const float t1199 = (t1081 * motion->constants[54]) - (motion->constants[55] * t1120);
    const float t1202 = sin_delta * motion->constants[48];
    const float t1204 = (sin_delta * motion->constants[51]) - (motion->constants[31] * t1202);
    const float t1208 = (t1081 * t1118) + (cos_theta * t1121) + t1204 - (t1120 * t1124) -
        (motion->constants[33] * t1199);
    const float t1212 = (motion->constants[56] * t1081) - (motion->constants[57] * t1120);
    const float t1214 = cos_theta * motion->constants[58];
    const float t1218 = (motion->constants[57] * t1081) - (motion->constants[59] * t1120);
    const float t1227 = (t1071 * t1212) + (t1075 * t1218) + (motion->constants[32] * t1199) +
        (cos_delta * t1091) - (t1081 * t1214) - (motion->constants[30] * t1202);
    const float t1229 = (t7 * t1208) + (t12 * t1227);
    const float t1231 = t141 - (sin_phi * t516);
    const float t1241 = t1170 + (t1145 * t1148) + (motion->constants[7] * ((t7 * t1179) + (t12 *
        t1187))) - (t1146 * t1171);
    const float t1242 = cos_phi * t516;
    const float t1254 = t1092 + t1107 + t1139 + t1193 + motion->constants[43] +
        motion->constants[52] + (t1081 * t1212);
    const float t1256 = t1254 + (cos_theta * t1214) - (t1120 * t1218);
    const float t1261 = motion->constants[7] * (t1199 + t1202);
    const float t1263 = (t12 * t1208) + t1261 - (t7 * t1227);
    const float t1269 = t1144 - t1173;
    const float t1275 = t1231 * motion->constants[27];
    const float t1277 = t12 * sin_delta;
    const float t1279 = t7 * sin_delta;
    const float t1282 = (cos_delta * t1231) - t1277 - (t1242 * t1279);
    const float t1283 = t1043 + t1282;
    const float t1285 = t1283 * motion->constants[28];
    const float t1291 = t1113 + t1173 + t1193 + (t1229 * t1231) + (t1231 * (t1229 + (t1231 *
        t1256) - (t1242 * t1263))) + (t1231 * t1275);
    const float t1294 = t1291 + (t1283 * t1285) - (t1241 * t1242) - (t1242 * (t1241 + (t1231 *
        t1263) - (t1242 * t1269)));
    const float t1295 = 1.0F / t1294;
    const float t1300 = (speeds[0] * t516) + (speeds[1] * t513) + (speeds[3] * t505);
    const float t1301 = sin_phi * t1300;
    const float t1302 = t297 - t1301;
    const float t1303 = t12 * speeds[0];
    const float t1304 = cos_phi * t1300;
    const float t1306 = t1303 + (t7 * t1304);
    const float t1307 = motion->constants[42] * t1306;
    const float t1309 = t7 * speeds[0];
    const float t1310 = t1309 - (t12 * t1304);
    const float t1312 = t1307 + (motion->constants[46] * t1310);
    const float t1315 = speeds[3] + t1302;
    const float t1317 = (motion->constants[43] * t1302) + (motion->constants[27] * t1315);
    const float t1319 = (t1302 * t1312) - (t1310 * t1317);
    const float t1320 = motion->constants[7] * t1301;
    const float t1321 = t1304 * t1320;
    const float t1323 = sin_phi * motion->constants[60];
    const float t1324 = t298 * t1304;
    const float t1327 = t1321 - (motion->constants[7] * t1324);
    const float t1328 = t1323 + t1327;
    const float t1330 = t297 * t1310;
    const float t1331 = speeds[0] * t1301;
    const float t1332 = motion->constants[31] * t1302;
    const float t1334 = motion->constants[30] * t1302;
    const float t1336 = (t1310 * t1332) + (t1306 * t1334);
    const float t1338 = t297 * t1306;
    const float t1339 = (t12 * t1331) + t1338;
    const float t1342 = t1330 + (t7 * t1331);
    const float t1346 = t1336 + (motion->constants[30] * t1339) + (motion->constants[31] * t1342) -
        t1327;
    const float t1349 = motion->constants[30] * t1310;
    const float t1350 = motion->constants[31] * t1306;
    const float t1351 = t1349 - t1350;
    const float t1353 = (t1302 * t1334) + (t1310 * t1351);
    const float t1354 = speeds[0] * t1304;
    const float t1357 = motion->constants[7] * speeds[0];
    const float t1358 = t1304 * t1357;
    const float t1359 = (motion->constants[7] * t1354) + t1358;
    const float t1362 = t298 - t1301;
    const float t1364 = (t1320 * t1362) - (speeds[0] * t1357);
    const float t1368 = (t12 * t1359) + (t7 * t1364) - t1353 - (motion->constants[31] * t1354);
    const float t1370 = speeds[1] + t1310;
    const float t1374 = (cos_delta * t1302) - (sin_delta * t1306);
    const float t1375 = motion->constants[38] * t1374;
    const float t1379 = (cos_delta * t1306) + (sin_delta * t1302);
    const float t1380 = motion->constants[37] * t1374;
    const float t1385 = speeds[1] * t1374;
    const float t1387 = t1385 - (cos_delta * t1342) - (sin_delta * t1354);
    const float t1389 = t30 * motion->constants[8];
    const float t1394 = (speeds[0] * t1043) + (speeds[1] * t1029) + (speeds[3] * t1035);
    const float t1396 = t1339 + (t1379 * t1394);
    const float t1398 = t27 * motion->constants[8];
    const float t1400 = t1387 - (t1370 * t1394);
    const float t1402 = t26 * t40;
    const float t1405 = (t30 * t1379) + (t27 * t1370);
    const float t1406 = t1402 * t1405;
    const float t1407 = t27 * t1406;
    const float t1408 = motion->constants[8] * t1407;
    const float t1410 = t30 * t1406;
    const float t1411 = motion->constants[8] * t1410;
    const float t1417 = (cos_delta * t1346) + (t1370 * t1375) + (t1379 * t1380) +
        (motion->constants[37] * t1339) + (t1389 * t1396) + (t1370 * t1408);
    const float t1421 = t1417 + (t1379 * t1411) - (sin_delta * t1368) - (motion->constants[38] *
        t1387) - (t1398 * t1400);
    const float t1426 = motion->constants[37] * t1370;
    const float t1427 = motion->constants[38] * t1379;
    const float t1428 = t1426 - t1427;
    const float t1432 = speeds[1] * t1379;
    const float t1434 = (sin_delta * t1342) - (cos_delta * t1354) - t1432;
    const float t1437 = t1374 + t1394;
    const float t1441 = (t30 * t1370) - (t27 * t1379);
    const float t1442 = motion->constants[8] * t1441;
    const float t1448 = (cos_delta * t1368) + (sin_delta * t1346) + (motion->constants[38] *
        t1434) + (t1398 * t1434) - (t1374 * t1380) - (t1370 * t1428);
    const float t1450 = t1448 - (t1411 * t1437) - (t1370 * t1442);
    const float t1454 = (t1306 * t1351) - (t1302 * t1332);
    const float t1468 = t1454 + (motion->constants[30] * t1354) + (t7 * t1359) + (t1379 * t1428) +
        (t1379 * t1442) - (t12 * t1364);
    const float t1472 = t1468 - (t1374 * t1375) - (motion->constants[37] * t1434) - (t1389 *
        t1434) - (t1408 * t1437);
    const float t1474 = (t30 * t1450) + (t27 * t1472);
    const float t1479 = t53 * ((t40 * t1421) + (t25 * t1474));
    const float t1483 = t442 * ((t25 * t1421) + (t485 * t1479) - (t40 * t1474));
    const float t1485 = t1331 - (cos_phi * t1483);
    const float t1487 = t1330 + (t7 * t1485);
    const float t1490 = t1338 + (t12 * t1485);
    const float t1494 = motion->constants[42] * t1310;
    const float t1495 = (motion->constants[45] * t1306) + t1494;
    const float t1497 = (t1306 * t1317) - (t1302 * t1495);
    const float t1502 = t1336 + (motion->constants[30] * t1490) + (motion->constants[31] * t1487) -
        t1328;
    const float t1505 = t1354 - t1479;
    const float t1506 = (sin_phi * t1483) + t1505;
    const float t1509 = (motion->constants[7] * t1506) + t1358;
    const float t1512 = t1364 + (cos_phi * motion->constants[60]);
    const float t1513 = t7 * t1512;
    const float t1514 = t1513 + (t12 * t1509);
    const float t1516 = t1514 - (motion->constants[31] * t1506) - t1353;
    const float t1518 = (cos_delta * t1502) - (sin_delta * t1516);
    const float t1523 = t1385 - (sin_delta * t1506) - (cos_delta * t1487);
    const float t1528 = (motion->constants[52] * t1374) + (motion->constants[28] * t1437);
    const float t1531 = motion->constants[51] * t1370;
    const float t1532 = (motion->constants[50] * t1379) + t1531;
    const float t1534 = (t1379 * t1528) - (t1374 * t1532);
    const float t1537 = (motion->constants[48] * t1518) + (motion->constants[51] * t1523) +
        (motion->constants[53] * t1490) + t1534;
    const float t1538 = motion->constants[32] * t1302;
    const float t1540 = motion->constants[32] * t1310;
    const float t1541 = motion->constants[33] * t1306;
    const float t1542 = t1540 + t1541;
    const float t1544 = (t1302 * t1538) + (t1310 * t1542);
    const float t1547 = t1514 + t1544 - (motion->constants[33] * t1506);
    const float t1549 = motion->constants[33] * t1302;
    const float t1552 = (t1310 * t1549) - (t1306 * t1538);
    const float t1557 = t1552 + (motion->constants[33] * t1487) - t1328 - (motion->constants[32] *
        t1490);
    const float t1561 = (t1306 * t1542) + (t1302 * t1549);
    const float t1563 = t12 * t1512;
    const float t1565 = t1563 - (t7 * t1509);
    const float t1567 = (motion->constants[32] * t1506) + t1561 + t1565;
    const float t1570 = (cos_theta * t1557) - (t1120 * t1567) - (t1081 * t1547);
    const float t1577 = (cos_theta * t1302) + (t1120 * t1310) - (t1081 * t1306);
    const float t1578 = speeds[2] * t1577;
    const float t1579 = motion->constants[2] * t1578;
    const float t1585 = t1579 - (t1081 * t1506) + (t1075 * t1490) - (t1071 * t1487);
    const float t1587 = motion->constants[3] * t1578;
    const float t1593 = (t1098 * t1490) - t1587 - (t1075 * t1487) + (t1120 * t1506);
    const float t1598 = motion->constants[3] * speeds[2];
    const float t1601 = (t1071 * t1306) + (t1081 * t1302) + (t1075 * t1310) + t1598;
    const float t1602 = motion->constants[57] * t1601;
    const float t1606 = motion->constants[2] * speeds[2];
    const float t1609 = (t1075 * t1306) + (t1098 * t1310) + t1606 - (t1120 * t1302);
    const float t1611 = t1602 + (motion->constants[59] * t1609);
    const float t1613 = motion->constants[58] * t1577;
    const float t1615 = (t1577 * t1611) - (t1609 * t1613);
    const float t1618 = (motion->constants[56] * t1585) + (motion->constants[57] * t1593) + t1615 -
        (motion->constants[55] * t1570);
    const float t1624 = (t1071 * t1547) + (t1081 * t1557) - (t1075 * t1567);
    const float t1630 = (t1075 * t1547) - (t1098 * t1567) - (t1120 * t1557);
    const float t1635 = speeds[2] * ((motion->constants[3] * t1609) - (motion->constants[2] *
        t1601));
    const float t1641 = t1635 + (t1081 * t1487) - (cos_theta * t1506) + (t1120 * t1490);
    const float t1644 = motion->constants[57] * t1609;
    const float t1645 = (motion->constants[56] * t1601) + t1644;
    const float t1648 = (t1609 * t1645) - (t1601 * t1611);
    const float t1651 = (motion->constants[55] * t1624) + (motion->constants[58] * t1641) + t1648 -
        (motion->constants[54] * t1630);
    const float t1658 = (t1601 * t1613) - (t1577 * t1645);
    const float t1661 = (motion->constants[54] * t1570) + (motion->constants[57] * t1585) +
        (motion->constants[59] * t1593) + t1658;
    const float t1666 = motion->constants[54] * t1577;
    const float t1668 = motion->constants[54] * t1609;
    const float t1669 = motion->constants[55] * t1601;
    const float t1670 = t1668 - t1669;
    const float t1672 = (t1577 * t1666) + (t1609 * t1670);
    const float t1674 = (t1624 * motion->constants[24]) + (motion->constants[55] * t1641) - t1672;
    const float t1679 = motion->constants[55] * t1577;
    const float t1682 = (t1609 * t1679) + (t1601 * t1666);
    const float t1685 = (t1570 * motion->constants[24]) + (motion->constants[54] * t1593) + t1682 -
        (motion->constants[55] * t1585);
    const float t1691 = (t1601 * t1670) - (t1577 * t1679);
    const float t1693 = (t1630 * motion->constants[24]) + t1691 - (motion->constants[54] * t1641);
    const float t1696 = (t1081 * t1674) + (cos_theta * t1685) - (t1120 * t1693);
    const float t1701 = (cos_delta * t1516) + (sin_delta * t1502);
    const float t1707 = (sin_delta * t1487) - (cos_delta * t1506) - t1432;
    const float t1709 = motion->constants[48] * t1374;
    const float t1711 = motion->constants[48] * t1370;
    const float t1712 = t1379 * motion->constants[49];
    const float t1713 = t1711 - t1712;
    const float t1715 = (t1374 * t1709) + (t1370 * t1713);
    const float t1717 = (motion->constants[47] * t1701) + (motion->constants[49] * t1707) - t1715;
    const float t1722 = t1374 * motion->constants[49];
    const float t1725 = (t1370 * t1722) + (t1379 * t1709);
    const float t1728 = (t1518 * motion->constants[47]) + (motion->constants[48] * t1490) + t1725 -
        (t1523 * motion->constants[49]);
    const float t1730 = (sin_delta * t1717) + (cos_delta * t1728);
    const float t1736 = (motion->constants[46] * t1490) + t1497 + t1537 + (t1075 * t1618) + (t1120 *
        t1651) + (t1098 * t1661);
    const float t1740 = t1736 + (motion->constants[30] * t1730) - (motion->constants[40] * t1328) -
        (motion->constants[42] * t1487) - (motion->constants[32] * t1696);
    const float t1752 = motion->constants[51] * t1379;
    const float t1754 = t1752 + (motion->constants[53] * t1370);
    const float t1757 = (t1374 * t1754) - (t1370 * t1528);
    const float t1760 = (motion->constants[50] * t1523) + (motion->constants[51] * t1490) + t1757 -
        (t1518 * motion->constants[49]);
    const float t1765 = t1454 - t1565 + (motion->constants[30] * t1506);
    const float t1775 = t775 * ((t30 * t1472) + (t796 * t1483) - (t27 * t1450) - (t804 * t1479));
    const float t1777 = motion->constants[28] * (t1707 + t1775);
    const float t1780 = (t1370 * t1532) - (t1379 * t1754);
    const float t1784 = (t1701 * motion->constants[49]) + (motion->constants[52] * t1707) + t1777 +
        t1780 - (motion->constants[48] * t1765);
    const float t1791 = t1319 + (motion->constants[41] * t1328) + (motion->constants[42] * t1490) +
        (t1071 * t1618) + (t1075 * t1661) + (cos_delta * t1760);
    const float t1796 = t1791 - (motion->constants[45] * t1487) - (t1081 * t1651) -
        (motion->constants[33] * t1696) - (sin_delta * t1784) - (motion->constants[31] * t1730);
    const float t1802 = motion->constants[41] * t1302;
    const float t1804 = motion->constants[40] * t1302;
    const float t1806 = (t1310 * t1802) + (t1306 * t1804);
    const float t1812 = motion->constants[7] * (t1696 + t1730 + (motion->constants[40] * t1490) +
        (motion->constants[41] * t1487) + t1806 - (t1328 * motion->constants[44]));
    const float t1818 = (t1310 * t1495) - (t1306 * t1312);
    const float t1826 = (t1071 * t1674) + (t1075 * t1693) - (t1081 * t1685);
    const float t1832 = (t1075 * t1674) + (t1120 * t1685) + (t1098 * t1693);
    const float t1838 = (cos_delta * t1717) - (sin_delta * t1728);
    const float t1844 = (t1379 * t1713) - (t1374 * t1722);
    const float t1846 = (motion->constants[47] * t1765) + t1844 - (motion->constants[48] * t1707);
    const float t1851 = motion->constants[40] * t1310;
    const float t1852 = motion->constants[41] * t1306;
    const float t1853 = t1851 - t1852;
    const float t1856 = (t1306 * t1853) - (t1302 * t1802);
    const float t1866 = (t1302 * t1804) + (t1310 * t1853);
    const float t1872 = (t7 * (t1832 + t1846 + t1856 - (t1565 * motion->constants[44]) +
        (motion->constants[40] * t1506))) + (t12 * (t1826 + t1838 + (t1514 *
        motion->constants[44]) - (motion->constants[41] * t1506) - t1866));
    const float t1874 = (motion->constants[27] * t1506) + (motion->constants[7] * t1872);
    const float t1879 = (motion->constants[41] * t1514) + (motion->constants[40] * t1565) -
        (motion->constants[43] * t1506) + t1818 + (t1081 * t1618) + (cos_theta * t1651);
    const float t1884 = t1879 + (motion->constants[33] * t1826) + (motion->constants[32] * t1832) +
        (sin_delta * t1760) + (cos_delta * t1784) + (motion->constants[31] * t1838);
    const float t1887 = t1884 - t1874 - (t1120 * t1661) - (motion->constants[30] * t1846);
    const float t1891 = (t12 * t1740) - (t7 * t1796);
    const float t1898 = forces[0] + (t1242 * t1891) - (t7 * t1740) - (t12 * t1796) - t1812 -
        (t1231 * t1887);
    const float t1899 = t1898 - (t1043 * t1777);
    const float t1901 = motion->constants[53] + t1135;
    const float t1906 = t135 - (sin_phi * t513);
    const float t1908 = cos_phi * t513;
    const float t1910 = t12 * motion->constants[7];
    const float t1911 = t1202 * t1910;
    const float t1912 = t1204 + t1911;
    const float t1916 = t1912 + (t1256 * t1906) - (t1263 * t1908);
    const float t1920 = (t12 * t1901) - (t7 * t1161);
    const float t1924 = t1920 + (t1263 * t1906) - (t1269 * t1908);
    const float t1929 = (cos_delta * t1906) - (t1279 * t1908);
    const float t1930 = t1029 + t1929;
    const float t1936 = (t7 * t1901) + (t12 * t1161) + (motion->constants[7] * t1134) + (t1229 *
        t1906) + (t1231 * t1916) + (t1275 * t1906);
    const float t1940 = t1295 * (t1936 + (t1285 * t1930) - (t1241 * t1908) - (t1242 * t1924));
    const float t1945 = motion->constants[27] * t1906;
    const float t1947 = motion->constants[28] * t1930;
    const float t1949 = t1294 * t1940;
    const float t1955 = motion->constants[53] + (t1906 * t1916) + (t1906 * t1912) + (t1906 *
        t1945) + (t1930 * t1947) - (t1908 * t1924);
    const float t1957 = t1955 - (t1908 * t1920) - (t1940 * t1949);
    const float t1958 = 1.0F / t1957;
    const float t1968 = forces[1] + (t1891 * t1908) - t1537 - (t1887 * t1906) - (t1029 * t1777) -
        (t1899 * t1940);
    const float t1971 = t1081 * motion->constants[75];
    const float t1973 = t1120 * motion->constants[75];
    const float t1978 = motion->constants[7] * ((t7 * t1973) - (t12 * t1971));
    const float t1983 = (t1081 * motion->constants[76]) - (t1120 * motion->constants[77]);
    const float t1986 = (motion->constants[32] * t1973) + t1983 - (motion->constants[33] * t1971) -
        t1978;
    const float t1988 = cos_theta * motion->constants[75];
    const float t1992 = (t1075 * motion->constants[76]) + (t1098 * motion->constants[77]);
    const float t1993 = t1992 - (motion->constants[32] * t1988);
    const float t1998 = (t1071 * motion->constants[76]) + (t1075 * motion->constants[77]);
    const float t1999 = t1998 - (motion->constants[33] * t1988);
    const float t2001 = (t12 * t1993) - (t7 * t1999);
    const float t2012 = t1295 * ((t7 * t1993) + (t12 * t1999) + (motion->constants[7] * t1988) +
        (t1231 * t1986) - (t1242 * t2001));
    const float t2016 = t1958 * ((t1906 * t1986) - (t1908 * t2001) - (t1949 * t2012));
    const float t2018 = t1294 * t2012;
    const float t2020 = t1957 * t2016;
    const float t2023 = motion->constants[78] - (t2012 * t2018) - (t2016 * t2020);
    const float t2024 = 1.0F / t2023;
    const float t2038 = forces[2] - (motion->constants[3] * t1618) - (motion->constants[2] *
        t1661) - (positions[6] * motion->constants[5]) - (speeds[2] * motion->constants[6]) -
        (t1899 * t2012);
    const float t2039 = t2038 - (t1968 * t2016);
    const float t2041 = sin_phi * t505;
    const float t2043 = cos_phi * t505;
    const float t2049 = motion->constants[7] * (t1189 - motion->constants[73]);
    const float t2053 = t2049 + (t1256 * t2041) + (t1263 * t2043);
    const float t2058 = t1261 - (t1263 * t2041) - (t1269 * t2043);
    const float t2060 = 1.0F - t2041;
    const float t2064 = (cos_delta * t2041) + (t1279 * t2043);
    const float t2065 = t1035 - t2064;
    const float t2071 = (t1275 * t2060) + (t1285 * t2065) - (t1229 * t2041) - (t1241 * t2043) -
        (t1231 * t2053) - (t1242 * t2058);
    const float t2072 = t1295 * t2071;
    const float t2085 = t1911 + (t1945 * t2060) + (t1947 * t2065) - (t1906 * t2053) - (t1908 *
        t2058) - (t1912 * t2041);
    const float t2088 = t1958 * (t2085 - (t1920 * t2043) - (t1949 * t2072));
    const float t2094 = t2024 * (t1978 + (t1986 * t2041) + (t2001 * t2043) + (t2018 * t2072) +
        (t2020 * t2088));
    const float t2105 = (t1887 * t2041) + (t1891 * t2043) + (t2039 * t2094) + t1874 - (t1035 *
        t1777) - (t1899 * t2072);
    const float t2114 = motion->constants[28] * t2065;
    const float t2126 = (t2041 * t2053) + (t2041 * t2049) + motion->constants[79] +
        (motion->constants[27] * t2060 * t2060) + (t2065 * t2114) - (t2043 * t2058);
    const float t2131 = 1.0F / (t2126 - (t1261 * t2043) - (t1294 * t2072 * t2072) - (t1957 * t2088 *
        t2088) - (t2023 * t2094 * t2094));
    const float t2132 = (t2105 - (t1968 * t2088)) * t2131;
    const float t2134 = (t2024 * t2039) + (t2094 * t2132);
    const float t2138 = (t1958 * t1968) - (t2016 * t2134) - (t2088 * t2132);
    const float t2144 = (t1295 * t1899) - (t1940 * t2138) - (t2012 * t2134) - (t2072 * t2132);
    const float t2145 = t1324 + t2144;
    const float t2148 = t1321 + t1323 - (motion->constants[7] * t2145);
    const float t2156 = t1483 + (t516 * t2144) + (t513 * t2138) + (t505 * t2132);
    const float t2158 = t1331 - (cos_phi * t2156);
    const float t2161 = (t12 * t2144) - t1330 - (t7 * t2158);
    const float t2166 = t1338 + (t12 * t2158) + (t7 * t2144);
    const float t2173 = (t141 * t2144) + (t135 * t2138) - (sin_phi * t2156) - t1505;
    const float t2175 = t2132 + t2173;
    const float t2177 = (motion->constants[7] * t2175) - t1358;
    const float t2179 = t1513 - (t12 * t2177);
    const float t2181 = t1544 + (motion->constants[33] * t2173) + t2179;
    const float t2187 = t1552 - t2148 - (motion->constants[32] * t2166) - (motion->constants[33] *
        t2161);
    const float t2191 = t1563 + (t7 * t2177);
    const float t2193 = (motion->constants[32] * t2173) - t1561 - t2191;
    const float t2196 = (cos_theta * t2187) + (t1120 * t2193) - (t1081 * t2181);
    const float t2205 = t1579 + (t1071 * t2161) + (t1081 * t2173) + (t1075 * t2166) +
        (motion->constants[3] * t2134);
    const float t2214 = (t1075 * t2161) + (t1098 * t2166) + (motion->constants[2] * t2134) - t1587 -
        (t1120 * t2173);
    const float t2218 = t1615 + (motion->constants[56] * t2205) + (motion->constants[57] * t2214) -
        (motion->constants[55] * t2196);
    const float t2224 = (t1071 * t2181) + (t1081 * t2187) + (t1075 * t2193);
    const float t2230 = (t1075 * t2181) + (t1098 * t2193) - (t1120 * t2187);
    const float t2237 = t1635 + (cos_theta * t2173) + (t1120 * t2166) - (t1081 * t2161);
    const float t2241 = t1648 + (motion->constants[55] * t2224) + (motion->constants[58] * t2237) -
        (motion->constants[54] * t2230);
    const float t2248 = t1658 + (motion->constants[54] * t2196) + (motion->constants[57] * t2205) +
        (motion->constants[59] * t2214);
    const float t2250 = motion->constants[24] * t2224;
    const float t2253 = t2250 + (motion->constants[55] * t2237) - t1672;
    const float t2255 = motion->constants[24] * t2196;
    const float t2260 = t1682 + t2255 + (motion->constants[54] * t2214) - (motion->constants[55] *
        t2205);
    const float t2262 = motion->constants[24] * t2230;
    const float t2265 = t1691 + t2262 - (motion->constants[54] * t2237);
    const float t2268 = (t1081 * t2253) + (cos_theta * t2260) - (t1120 * t2265);
    const float t2274 = t1336 + (motion->constants[30] * t2166) - t2148 - (motion->constants[31] *
        t2161);
    const float t2278 = t2179 + (motion->constants[31] * t2173) - t1353;
    const float t2280 = (cos_delta * t2274) - (sin_delta * t2278);
    const float t2285 = t1385 + (cos_delta * t2161) + (sin_delta * t2173);
    const float t2287 = t2138 + t2166;
    const float t2291 = t1757 + (motion->constants[50] * t2285) + (motion->constants[51] * t2287) -
        (motion->constants[49] * t2280);
    const float t2295 = (cos_delta * t2278) + (sin_delta * t2274);
    const float t2299 = t1454 - t2191 - (motion->constants[30] * t2173);
    const float t2304 = (cos_delta * t2173) - t1432 - (sin_delta * t2161);
    const float t2312 = t1775 + t2304 + (t1043 * t2144) + (t1029 * t2138) + (t1035 * t2132);
    const float t2313 = motion->constants[28] * t2312;
    const float t2317 = t1780 + (motion->constants[49] * t2295) + (motion->constants[52] * t2304) +
        t2313 - (motion->constants[48] * t2299);
    const float t2322 = (motion->constants[47] * t2295) + (motion->constants[49] * t2304) - t1715;
    const float t2329 = t1725 + (motion->constants[47] * t2280) + (motion->constants[48] * t2287) -
        (motion->constants[49] * t2285);
    const float t2331 = (sin_delta * t2322) + (cos_delta * t2329);
    const float t2337 = t1319 + (motion->constants[41] * t2148) + (motion->constants[45] * t2161) +
        (motion->constants[42] * t2166) + (t1071 * t2218) + (t1075 * t2248);
    const float t2342 = t2337 + (cos_delta * t2291) - (t1081 * t2241) - (motion->constants[33] *
        t2268) - (sin_delta * t2317) - (motion->constants[31] * t2331);
    const float t2349 = (t1071 * t2253) + (t1075 * t2265) - (t1081 * t2260);
    const float t2352 = (cos_delta * t2322) - (sin_delta * t2329);
    const float t2356 = (motion->constants[44] * t2179) + (motion->constants[41] * t2173) + t2349 +
        t2352 - t1866;
    const float t2357 = motion->constants[7] * t2356;
    const float t2375 = t1497 + t1534 + (motion->constants[42] * t2161) + (motion->constants[46] *
        t2166) + (motion->constants[48] * t2280) + (motion->constants[51] * t2285) +
        (motion->constants[53] * t2287);
    const float t2380 = t2375 + (t1075 * t2218) + (t1120 * t2241) + (t1098 * t2248) +
        (motion->constants[30] * t2331) - (motion->constants[40] * t2148);
    const float t2381 = t2380 - (motion->constants[32] * t2268);
    const float t2383 = t775 * motion->constants[28];
    const float t2384 = t1472 * t2383;
    const float t2386 = t1450 * t2383;
    const float t2388 = t796 * t2383;
    const float t2389 = t442 * t1421;
    const float t2391 = t40 * t442;
    const float t2392 = t1450 * t2391;
    const float t2394 = t1472 * t2391;
    const float t2397 = (t86 * t2389) + (t87 * t2392) - (t93 * t2394);
    const float t2400 = (t2388 * t2397) - (t87 * t2384) - (t93 * t2386);
    const float t2402 = motion->constants[44] * t1910;
    const float t2403 = motion->constants[41] - t2402;
    const float t2406 = (t12 * t1242) - t7;
    const float t2408 = cos_delta * motion->constants[49];
    const float t2410 = sin_delta * motion->constants[49];
    const float t2414 = t89 + (t107 * t1242) + (sin_delta * t1231);
    const float t2416 = sin_delta * motion->constants[47];
    const float t2418 = cos_delta * motion->constants[30];
    const float t2420 = cos_delta * motion->constants[31];
    const float t2422 = sin_delta * motion->constants[31];
    const float t2423 = motion->constants[7] * t1277;
    const float t2424 = t2423 - t2422;
    const float t2428 = (t12 * t2418) + (t7 * t2420);
    const float t2433 = (t12 * t2420) + (t1242 * t2428) - (cos_delta * motion->constants[7]) - (t7 *
        t2418) - (t1231 * t2424);
    const float t2435 = cos_delta * motion->constants[47];
    const float t2437 = sin_delta * motion->constants[30];
    const float t2440 = motion->constants[7] * t89;
    const float t2441 = t2420 - t2440;
    const float t2445 = (t12 * t2437) + (t7 * t2422);
    const float t2450 = (t12 * t2422) + (t1242 * t2445) - (sin_delta * motion->constants[7]) - (t7 *
        t2437) - (t1231 * t2441);
    const float t2455 = (t2435 * t2450) - (t1202 * t2406) - (t1282 * t2408) - (t2410 * t2414) -
        (t2416 * t2433);
    const float t2457 = (t1071 * motion->constants[55]) - t1095;
    const float t2460 = (t7 * t1120) - (t12 * t1081);
    const float t2463 = (t7 * t1081) + (t12 * t1120);
    const float t2467 = (t1242 * t2463) - t2460 - (cos_theta * t1231);
    const float t2469 = t1075 * motion->constants[24];
    const float t2473 = (t12 * motion->constants[33]) + (t7 * motion->constants[32]) -
        motion->constants[7];
    const float t2477 = (t7 * motion->constants[33]) - (t12 * motion->constants[32]);
    const float t2478 = t1120 * t2477;
    const float t2482 = t12 * t1075;
    const float t2484 = t2482 + (t7 * t1098);
    const float t2485 = motion->constants[7] * t2484;
    const float t2487 = (t1075 * motion->constants[33]) + (t1098 * motion->constants[32]) - t2485;
    const float t2490 = (t1120 * t2473) + (t1242 * t2478) + (t1231 * t2487);
    const float t2492 = t1071 * motion->constants[24];
    const float t2494 = t1081 * t2477;
    const float t2499 = t7 * t1075;
    const float t2500 = (t12 * t1071) + t2499;
    const float t2501 = motion->constants[7] * t2500;
    const float t2503 = (t1071 * motion->constants[33]) + (t1075 * motion->constants[32]) - t2501;
    const float t2506 = (t1081 * t2473) + (t1242 * t2494) - (t1231 * t2503);
    const float t2509 = (t12 * t1098) - t2499;
    const float t2513 = (t1242 * t2509) + (t1120 * t1231) - t2484;
    const float t2516 = t2482 - (t7 * t1071);
    const float t2520 = (t1242 * t2516) - t2500 - (t1081 * t1231);
    const float t2523 = cos_theta * t2477;
    const float t2527 = motion->constants[7] * t2460;
    const float t2529 = (t1120 * motion->constants[32]) - (t1081 * motion->constants[33]) - t2527;
    const float t2532 = (cos_theta * t2473) + (t1242 * t2523) - (t1231 * t2529);
    const float t2535 = (motion->constants[54] * t2513) + (motion->constants[24] * t2532) -
        (motion->constants[55] * t2520);
    const float t2539 = (t2457 * t2467) + (t2492 * t2506) - (t2469 * t2490) - (t1081 * t2535);
    const float t2541 = t2455 + t2539 - (t1231 * t2403);
    const float t2544 = t7 * motion->constants[47];
    const float t2546 = motion->constants[7] * ((t7 * motion->constants[44]) + t2544);
    const float t2547 = t1184 + t2546;
    const float t2549 = motion->constants[48] * t1282;
    const float t2551 = t1130 - (motion->constants[54] * t1098);
    const float t2553 = t1098 * motion->constants[24];
    const float t2559 = (t2467 * t2551) + (t2469 * t2506) + (t1120 * t2535) - (t2490 * t2553);
    const float t2561 = (t1231 * t2547) + t2549 + t2559;
    const float t2564 = t12 * motion->constants[42];
    const float t2567 = t7 * motion->constants[42];
    const float t2569 = (t12 * motion->constants[46]) - t2567;
    const float t2575 = (t1081 * motion->constants[55]) + (motion->constants[54] * t1120);
    const float t2577 = t1120 * motion->constants[24];
    const float t2579 = t1081 * motion->constants[24];
    const float t2584 = (t2467 * t2575) + (t2490 * t2577) + (t2506 * t2579) + (cos_theta * t2535);
    const float t2594 = (t1134 * t2406) + (t2408 * t2414) + (t2433 * t2435) + (t2416 * t2450) -
        (t1282 * t2410);
    const float t2600 = (motion->constants[59] * t2513) + (motion->constants[57] * t2520) +
        (motion->constants[54] * t2532);
    const float t2606 = (motion->constants[58] * t2467) + (motion->constants[54] * t2490) +
        (motion->constants[55] * t2506);
    const float t2612 = (motion->constants[57] * t2513) + (motion->constants[56] * t2520) -
        (motion->constants[55] * t2532);
    const float t2618 = (motion->constants[53] * t2406) + (t1242 * t2569) + (motion->constants[48] *
        t2433) + (motion->constants[30] * t2594) + (t1098 * t2600) + (t1120 * t2606);
    const float t2623 = t2618 + (t1075 * t2612) - (motion->constants[7] * motion->constants[40]) -
        t2564 - (t7 * motion->constants[46]) - (motion->constants[51] * t2414);
    const float t2624 = t2623 - (motion->constants[32] * t2584);
    const float t2629 = t2564 - (t7 * motion->constants[45]);
    const float t2636 = motion->constants[30] * motion->constants[48];
    const float t2637 = t7 * motion->constants[7];
    const float t2638 = motion->constants[48] * t2637;
    const float t2639 = t2636 + t2638;
    const float t2645 = (motion->constants[49] * t2450) - t1285 - (t1231 * t2639) -
        (motion->constants[52] * t1282);
    const float t2651 = (motion->constants[51] * t2406) - (motion->constants[50] * t2414) -
        (motion->constants[49] * t2433);
    const float t2657 = (motion->constants[7] * motion->constants[41]) + (t1242 * t2629) + (t1075 *
        t2600) + (t1071 * t2612) + (cos_delta * t2651) - t2567;
    const float t2662 = t2657 - (t12 * motion->constants[45]) - (motion->constants[33] * t2584) -
        (motion->constants[31] * t2594) - (t1081 * t2606) - (sin_delta * t2645);
    const float t2664 = t12 * t139;
    const float t2666 = t7 * t139;
    const float t2669 = motion->constants[43] + motion->constants[27];
    const float t2673 = (t12 * motion->constants[41]) - (t7 * motion->constants[40]);
    const float t2675 = motion->constants[7] * (t2673 - (t7 * motion->constants[67]));
    const float t2677 = motion->constants[71] + t2669 - t2675;
    const float t2692 = (motion->constants[32] * t2559) + (motion->constants[33] * t2539) +
        (motion->constants[31] * t2455) + (cos_theta * t2606) + (t1081 * t2612) + (cos_delta *
        t2645);
    const float t2696 = t2692 + (sin_delta * t2651) - (t1231 * t2677) - (t1282 * t2636) - (t1120 *
        t2600);
    const float t2702 = (t2541 * t2664) + (t2561 * t2666) + (t16 * t2662) - (t13 * t2624) -
        (sin_phi * t2696);
    const float t2704 = t53 * t1474;
    const float t2706 = t25 * t53;
    const float t2707 = t1450 * t2706;
    const float t2709 = t1472 * t2706;
    const float t2712 = (t86 * t2704) + (t93 * t2709) - (t87 * t2707);
    const float t2715 = (t486 * t2388) - (t804 * t2383);
    const float t2723 = t2696 + (t486 * t2702) - (t1283 * t2715) - (t1910 * t2541) - (t2561 *
        t2637);
    const float t2725 = motion->constants[8] * t1434;
    const float t2726 = motion->constants[8] * t1370;
    const float t2728 = (t1379 * t2726) - t2725;
    const float t2730 = motion->constants[8] * t1406;
    const float t2731 = t1437 * t2730;
    const float t2732 = motion->constants[8] * t1379;
    const float t2734 = t2731 + (t1379 * t2732);
    const float t2737 = t1364 + (t87 * t2728) + (t93 * t2734);
    const float t2739 = t27 * t2391;
    const float t2741 = (t30 * t2383) - (t2388 * t2739);
    const float t2744 = t27 * t2706;
    const float t2747 = (t2723 * t2744) - (t1283 * t2741) - (t2702 * t2739);
    const float t2749 = motion->constants[37] + t1389;
    const float t2752 = motion->constants[30] * t1331;
    const float t2756 = (motion->constants[8] * t1396) + (t1379 * t2730);
    const float t2760 = (t1370 * t2730) - (motion->constants[8] * t1400);
    const float t2765 = (t1331 * t2749) + (cos_delta * t2752) + (t93 * t2760) - (sin_delta *
        t1359) - (t87 * t2756);
    const float t2766 = t25 * t442;
    const float t2767 = t2388 * t2766;
    const float t2770 = t40 * t53;
    const float t2773 = (t2702 * t2766) + (t2723 * t2770) - (t1283 * t2767);
    const float t2778 = t2731 + (t1370 * t2726);
    const float t2781 = t2725 + (t1370 * t2732);
    const float t2785 = (cos_delta * t1359) + (sin_delta * t2752) + (t87 * t2778) + (t93 * t2781);
    const float t2787 = t30 * t2391;
    const float t2789 = (t27 * t2383) + (t2388 * t2787);
    const float t2792 = t30 * t2706;
    const float t2795 = (t1283 * t2789) + (t2723 * t2792) - (t2702 * t2787);
    const float t2797 = t26 * t1405;
    const float t2798 = t1402 * t2797;
    const float t2800 = t1379 * t1402;
    const float t2802 = t1370 * t1402;
    const float t2805 = (t93 * t2802) - (t86 * t2798) - (t87 * t2800);
    const float t2806 = t1398 * t1437;
    const float t2808 = t1370 * t1398;
    const float t2809 = t1379 * t1389;
    const float t2810 = t2808 + t2809;
    const float t2811 = t2773 * t2810;
    const float t2812 = t1389 * t1437;
    const float t2815 = t2811 - (t2747 * t2806) - (t2795 * t2812);
    const float t2818 = motion->constants[42] * t1302;
    const float t2819 = t12 * t2818;
    const float t2821 = t1317 - (motion->constants[45] * t1302);
    const float t2823 = t7 * t2818;
    const float t2825 = (t12 * t2821) - t2823;
    const float t2828 = t1722 + t1722;
    const float t2830 = t1713 - t1712;
    const float t2832 = (sin_delta * t2828) + (cos_delta * t2830);
    const float t2834 = motion->constants[41] * t1310;
    const float t2841 = motion->constants[7] * ((t12 * t2834) + (t7 * (t1853 - t1852)) + (t7 *
        t2832));
    const float t2845 = (motion->constants[45] * t1310) - t1307 - t1312 - (motion->constants[30] *
        t2832) - t2841;
    const float t2847 = motion->constants[52] + motion->constants[28];
    const float t2849 = (t1379 * t2847) - t1532;
    const float t2852 = t1528 - (motion->constants[50] * t1374);
    const float t2854 = (cos_delta * t2852) - (sin_delta * t2849);
    const float t2858 = (motion->constants[50] * t1370) - t1752 - t1754;
    const float t2859 = cos_delta * t2858;
    const float t2862 = t1754 - (t1370 * t2847);
    const float t2864 = motion->constants[51] * t1374;
    const float t2866 = (cos_delta * t2864) - (sin_delta * t2862);
    const float t2868 = t1370 * motion->constants[49];
    const float t2869 = motion->constants[48] * t1379;
    const float t2870 = t2868 + t2869;
    const float t2873 = (cos_delta * t1709) - (sin_delta * t2870);
    const float t2876 = t1709 + t1709;
    const float t2878 = (cos_delta * t2868) + (sin_delta * t2876);
    const float t2880 = t1541 + t1542;
    const float t2883 = motion->constants[33] * t1310;
    const float t2886 = motion->constants[31] * t1310;
    const float t2888 = cos_delta * speeds[1];
    const float t2890 = sin_delta * speeds[1];
    const float t2893 = t1375 + t1408;
    const float t2894 = t1375 + t2893;
    const float t2898 = t1428 + t1442;
    const float t2901 = (speeds[1] * t2749) + t2898 - t1427 - (t1379 * t1398);
    const float t2903 = (sin_delta * t2894) + (cos_delta * t2901);
    const float t2908 = t1334 + (motion->constants[30] * t297);
    const float t2910 = t1370 * motion->constants[38];
    const float t2911 = motion->constants[37] * t1379;
    const float t2916 = t2910 + t2911 - (speeds[1] * motion->constants[38]) - (speeds[1] * t1398);
    const float t2919 = t1380 + t1411;
    const float t2920 = (t1389 * t1394) + t2919;
    const float t2925 = (t297 * t2749) + (cos_delta * t2908) + (cos_delta * t2920) - (sin_delta *
        t2886) - (sin_delta * t2916);
    const float t2929 = t1380 + t2919;
    const float t2931 = motion->constants[38] + t1398;
    const float t2934 = t2808 + t2910 - (speeds[1] * t2931);
    const float t2938 = (cos_delta * t2886) + (sin_delta * t2908) + (sin_delta * t2929) +
        (cos_delta * t2934);
    const float t2940 = t30 * t1402;
    const float t2941 = cos_delta * t2940;
    const float t2943 = t1351 - t1350;
    const float t2944 = motion->constants[7] * t2544;
    const float t2945 = motion->constants[67] + t2944;
    const float t2948 = t2549 + t2747 + (t1231 * t2945);
    const float t2950 = motion->constants[57] * t1577;
    const float t2954 = t1644 + t1645 - (motion->constants[59] * t1601);
    const float t2957 = (motion->constants[59] * t1577) - t1613;
    const float t2959 = motion->constants[54] * t1601;
    const float t2962 = t1668 + t1670;
    const float t2969 = (t2467 * t2954) + (t2520 * t2957) + (t1679 * t2532) + (t1598 * t2606) -
        (t2513 * t2950) - (t2490 * t2959);
    const float t2970 = t2969 - (t2506 * t2962);
    const float t2973 = t1613 - (motion->constants[56] * t1577);
    const float t2977 = (motion->constants[56] * t1609) - t1602 - t1611;
    const float t2980 = t1670 - t1669;
    const float t2983 = motion->constants[55] * t1609;
    const float t2990 = (t2513 * t2973) + (t2467 * t2977) + (t2520 * t2950) + (t1666 * t2532) +
        (t2506 * t2983) - (t2490 * t2980);
    const float t2991 = t2990 - (t1606 * t2606);
    const float t2994 = (motion->constants[58] * t1601) - t1645;
    const float t2997 = t1611 - (motion->constants[58] * t1609);
    const float t2999 = t1679 + t1679;
    const float t3001 = t2959 + t2983;
    const float t3003 = t1666 + t1666;
    const float t3011 = (t2513 * t2994) + (t2520 * t2997) + (t2490 * t2999) + (t2532 * t3001) +
        (t1606 * t2612) - (t2506 * t3003);
    const float t3012 = t3011 - (t1598 * t2600);
    const float t3018 = (t1242 * t2825) + (t2406 * t2854) + (t2433 * t2873) + (t2450 * t2878) +
        (t2539 * t2883) + (t1334 * t2594);
    const float t3023 = t3018 + (t2455 * t2886) + (t297 * t2624) + (t2747 * t2903) + (t2773 *
        t2925) + (t2795 * t2938);
    const float t3028 = t3023 + (t2815 * t2941) + (t2943 * t2948) + (t1075 * t2970) + (t1071 *
        t2991) - (motion->constants[7] * t1804);
    const float t3034 = t3028 - t2819 - (t7 * t2821) - (t1231 * t2845) - (t1282 * t2859) - (t2414 *
        t2866) - (t2559 * t2880);
    const float t3038 = t3034 - (t1538 * t2584) - (t2645 * t2888) - (t2651 * t2890) - (t1081 *
        t3012);
    const float t3042 = (motion->constants[46] * t1302) - t1317;
    const float t3049 = motion->constants[40] * t1306;
    const float t3054 = motion->constants[7] * ((t7 * t3049) + (t7 * t2869) - (t12 * (t1851 +
        t1853)));
    const float t3058 = t1494 + t1495 - (motion->constants[46] * t1306) - (motion->constants[30] *
        t2869) - t3054;
    const float t3061 = t2819 + (t7 * t3042);
    const float t3065 = t1531 + t1532 - (motion->constants[53] * t1379);
    const float t3068 = (motion->constants[53] * t1374) - t1528;
    const float t3071 = t1711 + t1713;
    const float t3073 = motion->constants[32] * t1306;
    const float t3076 = t1540 + t1542;
    const float t3079 = t1349 + t1351;
    const float t3082 = t2809 + t2911;
    const float t3089 = t2893 + (cos_delta * t1332) + (t1394 * t1398) + (sin_delta * t3079);
    const float t3097 = (sin_delta * t1332) - t1426 - t2898 - (cos_delta * t3079) - (t1370 * t1389);
    const float t3099 = t27 * t1402;
    const float t3101 = motion->constants[30] * t1306;
    const float t3103 = sin_delta * t2749;
    const float t3108 = t2420 + (cos_delta * motion->constants[38]) + (cos_delta * t1398);
    const float t3111 = t2422 + (sin_delta * t2931);
    const float t3114 = (t2773 * t3108) + (t2795 * t3111) - (t2747 * t3103);
    const float t3123 = t2823 + (t1722 * t2433) + (t1549 * t2584) + (t2539 * t3076) + (t1332 *
        t2594) + (t2747 * t3082);
    const float t3128 = t3123 + (t2773 * t3089) + (t2795 * t3097) + (t2815 * t3099) + (t2948 *
        t3101) + (t297 * t3114);
    const float t3133 = t3128 + (t1098 * t2970) + (t1075 * t2991) + (t1120 * t3012) -
        (motion->constants[7] * t1802) - (t12 * t3042);
    const float t3138 = t3133 - (t2406 * t2864) - (t1231 * t3058) - (t1242 * t3061) - (t1282 *
        t3065) - (t2414 * t3068);
    const float t3142 = t3138 - (t2450 * t3071) - (t2559 * t3073) - (t2455 * t3079) - (t297 *
        t2662);
    const float t3144 = motion->constants[28] * t2132;
    const float t3146 = motion->constants[28] * t1379;
    const float t3148 = motion->constants[28] * t1370;
    const float t3155 = t2811 + (t2406 * t3146) + (t2414 * t3148) - (t1408 * t2747) - (t1411 *
        t2795);
    const float t3157 = (speeds[3] * t3155) - (t1283 * t3144);
    const float t3159 = motion->constants[28] * t2138;
    const float t3160 = t775 * t3159;
    const float t3163 = (t779 * t3155) - (t1283 * t3160);
    const float t3167 = cos_phi * (t1357 + t1357);
    const float t3168 = t12 * t3167;
    const float t3170 = t7 * t3167;
    const float t3172 = motion->constants[7] * t1304;
    const float t3177 = (sin_phi * t3172) - (cos_phi * ((motion->constants[7] * t298) - t1320));
    const float t3181 = (t7 * motion->constants[41]) + (t12 * motion->constants[40]);
    const float t3186 = (motion->constants[7] * motion->constants[44]) - t2584 - t2594 - t2673 -
        (t1242 * t3181);
    const float t3188 = sin_phi * t1303;
    const float t3190 = cos_phi * speeds[0];
    const float t3192 = sin_phi * t1309;
    const float t3199 = cos_delta * t3190;
    const float t3201 = (cos_phi * ((t7 * t1357) + (speeds[0] * (motion->constants[30] + t2637)))) +
        (t2749 * t3199);
    const float t3204 = sin_delta * speeds[0];
    const float t3213 = cos_phi * ((t12 * t1357) + (speeds[0] * (t1910 - motion->constants[31])));
    const float t3216 = (motion->constants[30] * t3188) - t3177;
    const float t3220 = (t2749 * t3188) + (cos_phi * ((motion->constants[38] * t3204) + (t1398 *
        t3204))) + (cos_delta * t3216) - (sin_delta * t3213);
    const float t3226 = (cos_delta * t3213) + (sin_delta * t3216) - (t2931 * t3199);
    const float t3230 = sin_phi * ((motion->constants[7] * t1362) - t1320);
    const float t3239 = (t7 * t2541) + (t107 * t2795) - (t12 * t2561) - (t12 * t2747) - (t1279 *
        t2773);
    const float t3245 = t1312 - (t1310 * t2669);
    const float t3248 = (t1306 * t2669) - t1495;
    const float t3252 = (t12 * t3248) - (t7 * t3245);
    const float t3256 = (sin_delta * t2830) - (cos_delta * t2828);
    const float t3265 = motion->constants[7] * ((t7 * t3256) - (t12 * (t1804 + t1804)) - (t7 *
        (t1802 + t1802)));
    const float t3266 = (motion->constants[30] * t3256) + t3265;
    const float t3270 = (cos_delta * t2849) + (sin_delta * t2852);
    const float t3272 = sin_delta * t2858;
    const float t3276 = (cos_delta * t2862) + (sin_delta * t2864);
    const float t3280 = (sin_delta * t1709) + (cos_delta * t2870);
    const float t3284 = (sin_delta * t2868) - (cos_delta * t2876);
    const float t3286 = t1549 + t1549;
    const float t3288 = t2883 - t3073;
    const float t3290 = t1538 + t1538;
    const float t3292 = t2886 + t3101;
    const float t3294 = t1334 + t1334;
    const float t3300 = (sin_delta * t2901) - (cos_delta * t2894);
    const float t3308 = (sin_delta * t3294) + (cos_delta * t3292) + (cos_delta * t2916) +
        (sin_delta * t2920);
    const float t3316 = (sin_delta * t3292) + (sin_delta * t2934) - (cos_delta * t3294) -
        (cos_delta * t2929);
    const float t3318 = sin_delta * t2940;
    const float t3320 = t1332 + t1332;
    const float t3329 = (t1242 * t3252) + (t1231 * t3266) + (t2406 * t3270) + (t2433 * t3280) +
        (t2450 * t3284) + (t2584 * t3288);
    const float t3334 = t3329 + (t2539 * t3290) + (t2594 * t3292) + (t2651 * t2888) + (t2747 *
        t3300) + (t2773 * t3308);
    const float t3339 = t3334 + (t2795 * t3316) + (t2815 * t3318) + (t1081 * t2991) + (cos_theta *
        t3012) - (motion->constants[7] * (t2834 + t3049));
    const float t3344 = t3339 - (t12 * t3245) - (t7 * t3248) - (t1282 * t3272) - (t2414 * t3276) -
        (t2559 * t3286);
    const float t3348 = t3344 - (t2455 * t3294) - (t2645 * t2890) - (t2948 * t3320) - (t1120 *
        t2970);
    const float t3356 = (t2541 * t3168) + (t2561 * t3170) + (t3177 * t3186) + (t2624 * t3188) +
        (t2747 * t3201) + (t2773 * t3220);
    const float t3361 = t3356 + (t2795 * t3226) + (t3230 * t3239) + (t3114 * t3192) + (t16 *
        t3038) - (t2696 * t3190);
    const float t3364 = t3361 - (t2662 * t3192) - (sin_phi * t3348) - (t13 * t3142);
    const float t3368 = (t2132 * t2702) + (speeds[3] * t3364) + (t797 * t3157);
    const float t3374 = (t2138 * t2702) + (speeds[1] * t3364) + (t796 * t3163);
    const float t3376 = motion->constants[7] * t2138;
    const float t3377 = t12 * t3376;
    const float t3379 = t7 * t3376;
    const float t3381 = speeds[1] * t3172;
    const float t3383 = speeds[1] * t1306;
    const float t3386 = speeds[1] * t1310;
    const float t3389 = t3101 + t3172;
    const float t3391 = (t1306 * t2749) + (cos_delta * t3389);
    const float t3392 = speeds[1] * t3391;
    const float t3394 = sin_delta * t3389;
    const float t3395 = speeds[1] * t3394;
    const float t3397 = speeds[1] * t1320;
    const float t3407 = (t2624 * t3383) + (t2138 * t2696) + (t2773 * t3392) + (t2795 * t3395) +
        (t3239 * t3397) + (t3114 * t3386);
    const float t3412 = t3407 + (speeds[1] * t3348) + (t486 * t3374) - (t2541 * t3377) - (t2561 *
        t3379) - (t3186 * t3381);
    const float t3414 = t3412 - (t2662 * t3386) - (t804 * t3163);
    const float t3420 = (t489 * t3374) + (t74 * t3414) - (t809 * t3163);
    const float t3426 = (t818 * t3163) + (t497 * t3374) + (t77 * t3414);
    const float t3428 = t1483 * t2383;
    const float t3432 = motion->constants[28] * t2144;
    const float t3436 = (speeds[0] * t3155) - t2313 - (t1283 * t3432);
    const float t3440 = (t828 * t3157) + (t513 * t3163) + (t831 * t3436) - (t1283 * t3428);
    const float t3442 = t1479 * t2383;
    const float t3447 = (t135 * t3163) + (t840 * t3436) - (t1283 * t3442);
    const float t3449 = t442 * t1483;
    const float t3450 = t2388 * t3449;
    const float t3467 = (t1075 * t2253) + (t1120 * t2260) + (t1098 * t2265);
    const float t3475 = t1844 + (motion->constants[47] * t2299) - (motion->constants[48] * t2304);
    const float t3482 = t1856 + t3467 + t3475 - (motion->constants[44] * t2191) -
        (motion->constants[40] * t2173);
    const float t3485 = (t7 * t3482) + (t12 * t2356);
    const float t3491 = t1818 + (motion->constants[41] * t2179) + (motion->constants[40] * t2191) +
        (motion->constants[43] * t2173) + (motion->constants[27] * t2175) + (t1081 * t2218);
    const float t3496 = t3491 + (cos_theta * t2241) + (motion->constants[33] * t2349) +
        (motion->constants[32] * t3467) + (sin_delta * t2291) + (cos_delta * t2317);
    const float t3500 = t3496 + (motion->constants[31] * t2352) - (t1120 * t2248) -
        (motion->constants[30] * t3475) - (motion->constants[7] * t3485);
    const float t3506 = (sin_phi * t3500) + (cos_phi * ((t12 * t2381) - (t7 * t2342)));
    const float t3512 = t3506 + (t2144 * t2702) + (speeds[0] * t3364) + (t797 * t3436);
    const float t3517 = (t2702 * t3449) + (t506 * t3368) + (t514 * t3374) + (t517 * t3512) -
        (t1283 * t3450);
    const float t3519 = t442 * t1479;
    const float t3520 = t2388 * t3519;
    const float t3527 = (t2702 * t3519) + (t525 * t3374) + (t527 * t3512) - (t1283 * t3520);
    const float t3532 = motion->constants[7] * t2144;
    const float t3533 = t12 * t3532;
    const float t3535 = t7 * t3532;
    const float t3537 = speeds[0] * t3172;
    const float t3539 = speeds[0] * t1306;
    const float t3542 = speeds[0] * t1310;
    const float t3544 = speeds[0] * t3391;
    const float t3546 = speeds[0] * t3394;
    const float t3548 = speeds[0] * t1320;
    const float t3558 = (t2624 * t3539) + (t2144 * t2696) + (t2773 * t3544) + (t2795 * t3546) +
        (t3239 * t3548) + (t3114 * t3542);
    const float t3563 = t3558 + (speeds[0] * t3348) + (t486 * t3512) - t3500 - (t2541 * t3533) -
        (t2561 * t3535);
    const float t3566 = t3563 - (t3186 * t3537) - (t2662 * t3542) - (t859 * t3436);
    const float t3576 = (t855 * t3163) + (t531 * t3374) + (t98 * t3414) + (t53 * t3566) + (t547 *
        t3447) + (t537 * t3527);
    const float t3578 = t3576 - (t117 * t3440) - (t36 * t3517);
    const float t3580 = t136 * t1479;
    const float t3592 = t3420 + (t36 * t3440) + (t547 * t3527) - (t2723 * t3580) - (t137 * t3414) -
        (t142 * t3566);
    const float t3594 = t3592 - (t537 * t3447) - (t117 * t3517);
    const float t3600 = (t817 * t3163) + (t496 * t3374) - (sin_phi * t3578);
    const float t3606 = (t1231 * t2357) + (t1242 * t2381) + (t2158 * t2624) + (t2144 * t2662) +
        (t2397 * t2702) + (t2712 * t2723);
    const float t3611 = t3606 + (t2765 * t2773) + (t2785 * t2795) + (t2805 * t2815) + (speeds[0] *
        t3038) + (t777 * t3157);
    const float t3616 = t3611 + (t792 * t3163) + (t444 * t3368) + (t479 * t3374) + (t65 * t3414) +
        (motion->constants[31] * t3426);
    const float t3621 = t3616 + (t827 * t3440) + (t524 * t3527) + (t114 * t3594) +
        (motion->constants[39] * t3600) - t2342;
    const float t3626 = t3621 - (t1283 * t2400) - (t2177 * t2541) - (t1512 * t2561) - (t2737 *
        t2747) - (t1304 * t3142);
    const float t3630 = t3626 - (motion->constants[30] * t3420) - (t838 * t3447) - (t504 * t3517) -
        (t97 * t3578);
    const float t3632 = motion->constants[7] * t3482;
    const float t3644 = (t28 * t442 * t1474) + (t166 * t2389) + (t168 * t2392) + (t170 * t2394);
    const float t3647 = (t168 * t2384) - (t170 * t2386) - (t2388 * t3644);
    const float t3661 = (t28 * t53 * t1421) + (t168 * t2707) + (t170 * t2709) - (t166 * t2704);
    const float t3666 = t1359 + (t168 * t2728) - (t170 * t2734);
    const float t3672 = (t168 * t2756) + (t170 * t2760) - (sin_delta * t1364);
    const float t3678 = (cos_delta * t1364) + (t170 * t2781) - (t168 * t2778);
    const float t3686 = (t28 * t2797) + (t166 * t2798) + (t168 * t2800) + (t170 * t2802);
    const float t3709 = (t1231 * t3632) + (t1512 * t2541) + (t2144 * t2624) + (t2723 * t3661) +
        (t2747 * t3666) + (t2773 * t3672);
    const float t3714 = t3709 + (t2795 * t3678) + (t2815 * t3686) + (t1331 * t3114) + (t1304 *
        t3038) + (speeds[0] * t3142);
    const float t3719 = t3714 + (t909 * t3157) + (t917 * t3163) + (t568 * t3368) + (t576 * t3374) +
        (t156 * t3414);
    const float t3724 = t3719 + (t926 * t3440) + (t587 * t3527) + (t185 * t3594) - t2381 - (t1242 *
        t2342);
    const float t3729 = t3724 - (t1283 * t3647) - (t2177 * t2561) - (t2158 * t2662) - (t2702 *
        t3644) - (motion->constants[31] * t3420);
    const float t3734 = t3729 - (motion->constants[30] * t3426) - (t930 * t3447) - (t583 * t3517) -
        (t175 * t3578) - (t48 * t3600);
    const float t3736 = t7 * t2331;
    const float t3737 = motion->constants[47] * t2173;
    const float t3739 = t2637 * t3737;
    const float t3741 = (motion->constants[30] * t3737) + t3739 - t3475;
    const float t3743 = t12 * t2331;
    const float t3745 = motion->constants[48] * t2173;
    const float t3747 = t1302 * t1306;
    const float t3748 = t2166 + t3747;
    const float t3750 = t1302 * t1302;
    const float t3751 = t1310 * t1310;
    const float t3752 = t3750 + t3751;
    const float t3756 = t1339 + t3747;
    const float t3758 = (sin_delta * t3752) + (cos_delta * t3756);
    const float t3762 = (sin_delta * t3756) - (cos_delta * t3752);
    const float t3764 = t1306 * t1310;
    const float t3774 = (t1242 * t3743) + (t2594 * t3748) + (t1354 * t2747) + (t2773 * t3758) +
        (t2795 * t3762) + (t2948 * t3764);
    const float t3779 = t3774 + (t12 * t3594) - t3736 - (t1231 * t3741) - (t1282 * t3745) - (t2455 *
        t3752);
    const float t3782 = t3779 - (t12 * t3420) - (t7 * t3426) - (t7 * t3600);
    const float t3786 = motion->constants[19] - t237;
    const float t3790 = (motion->constants[2] * t3786) + (motion->constants[3] *
        motion->constants[20]);
    const float t3791 = motion->constants[18] * t3790;
    const float t3792 = t3791 + t3791;
    const float t3793 = t1374 * t1379;
    const float t3794 = t2406 * t3793;
    const float t3796 = t1370 * t1374;
    const float t3797 = t2414 * t3796;
    const float t3799 = t3794 + t3797 - (t1282 * t2304);
    const float t3803 = (motion->constants[3] * t3786) - (motion->constants[2] *
        motion->constants[20]);
    const float t3804 = motion->constants[18] * t3803;
    const float t3805 = t3796 - t2285;
    const float t3807 = t1370 * t1370;
    const float t3808 = t1379 * t1379;
    const float t3809 = t3807 - t3808;
    const float t3811 = t2287 + t3793;
    const float t3814 = (t2406 * t3805) + (t1282 * t3809) + (t2414 * t3811);
    const float t3816 = t1370 * t1379;
    const float t3817 = t1282 * t3816;
    const float t3820 = t3794 + t3817 + (t2285 * t2414);
    const float t3822 = t1374 * t1374;
    const float t3823 = t3808 + t3822;
    const float t3825 = t2637 * t3823;
    const float t3826 = (motion->constants[30] * t3823) + t3825;
    const float t3831 = t2304 + t3816;
    const float t3836 = (t2280 * t2414) + (t2433 * t3805) + (t2450 * t3831) - (t1231 * t3826) -
        (t1282 * t2295);
    const float t3840 = (t3792 * t3799) + (t3804 * t3814) + (motion->constants[18] * t3836) -
        (t3792 * t3820);
    const float t3842 = t3804 + t3804;
    const float t3845 = t3817 + (t2287 * t2406) - t3797;
    const float t3849 = t3816 - t2304;
    const float t3851 = t2637 * t3849;
    const float t3852 = (motion->constants[30] * t3849) + t3851;
    const float t3857 = t3807 + t3822;
    const float t3862 = (t1231 * t3852) + (t2280 * t2406) + (t1282 * t2299) + (t2433 * t3811) -
        (t2450 * t3857);
    const float t3866 = (t3842 * t3845) + (t3799 * t3842) + (t3791 * t3814) +
        (motion->constants[18] * t3862);
    const float t3868 = (motion->constants[2] * t3840) + (motion->constants[3] * t3866);
    const float t3871 = t1302 * t1310;
    const float t3872 = t3871 - t2161;
    const float t3874 = t2173 + t3764;
    const float t3876 = t3764 - t1354;
    const float t3878 = t1342 + t3871;
    const float t3880 = (cos_delta * t3878) - (sin_delta * t3876);
    const float t3884 = (cos_delta * t3876) + (sin_delta * t3878);
    const float t3886 = t1306 * t1306;
    const float t3887 = t3750 + t3886;
    const float t3893 = (t7 * t3594) + (t12 * t3600);
    const float t3898 = t3743 + (t1242 * t3736) + (t2594 * t3872) + (t2455 * t3874) + (t2773 *
        t3880) + (t2795 * t3884);
    const float t3903 = t3898 + (t12 * t3426) + t3893 - (t1231 * t2352) - (t2948 * t3887) - (t7 *
        t3420);
    const float t3906 = (motion->constants[3] * t3782) + (motion->constants[2] * t3903) - t3868;
    const float t3908 = (t155 * t3734) + t3906 - (t58 * t3630);
    const float t3916 = (t12 * t1908) - 1.0F;
    const float t3920 = (t107 * t1908) + (sin_delta * t1906);
    const float t3924 = (t1908 * t2428) - (t1906 * t2424);
    const float t3928 = (t1908 * t2445) - (t1906 * t2441);
    const float t3933 = (t2435 * t3928) - (t1929 * t2408) - (t1202 * t3916) - (t2410 * t3920) -
        (t2416 * t3924);
    const float t3936 = (t1908 * t2463) - (cos_theta * t1906);
    const float t3940 = (t1908 * t2478) + (t1906 * t2487);
    const float t3944 = (t1908 * t2494) - (t1906 * t2503);
    const float t3948 = (t1908 * t2509) + (t1120 * t1906);
    const float t3952 = (t1908 * t2516) - (t1081 * t1906);
    const float t3956 = (t1908 * t2523) - (t1906 * t2529);
    const float t3959 = (motion->constants[54] * t3948) + (motion->constants[24] * t3956) -
        (motion->constants[55] * t3952);
    const float t3963 = (t2457 * t3936) + (t2492 * t3944) - (t2469 * t3940) - (t1081 * t3959);
    const float t3965 = t3933 + t3963 - (t1906 * t2403);
    const float t3967 = motion->constants[48] * t1929;
    const float t3975 = (t2551 * t3936) + (t2469 * t3944) + (t1120 * t3959) - (t2553 * t3940);
    const float t3977 = t3967 + (t1906 * t2547) + t3975;
    const float t3989 = (t2575 * t3936) + (t2577 * t3940) + (t2579 * t3944) + (cos_theta * t3959);
    const float t3999 = (t1134 * t3916) + (t2408 * t3920) + (t2435 * t3924) + (t2416 * t3928) -
        (t1929 * t2410);
    const float t4005 = (motion->constants[59] * t3948) + (motion->constants[57] * t3952) +
        (motion->constants[54] * t3956);
    const float t4011 = (motion->constants[58] * t3936) + (motion->constants[54] * t3940) +
        (motion->constants[55] * t3944);
    const float t4017 = (motion->constants[57] * t3948) + (motion->constants[56] * t3952) -
        (motion->constants[55] * t3956);
    const float t4023 = (motion->constants[53] * t3916) + (t1908 * t2569) + (motion->constants[48] *
        t3924) + (motion->constants[30] * t3999) + (t1098 * t4005) + (t1120 * t4011);
    const float t4026 = t4023 + (t1075 * t4017) - (motion->constants[51] * t3920) -
        (motion->constants[32] * t3989);
    const float t4039 = (motion->constants[49] * t3928) - t1947 - (motion->constants[52] * t1929) -
        (t1906 * t2639);
    const float t4045 = (motion->constants[51] * t3916) - (motion->constants[50] * t3920) -
        (motion->constants[49] * t3924);
    const float t4051 = (t1908 * t2629) + (t1075 * t4005) + (t1071 * t4017) + (cos_delta * t4045) -
        (motion->constants[33] * t3989) - (motion->constants[31] * t3999);
    const float t4053 = t4051 - (t1081 * t4011) - (sin_delta * t4039);
    const float t4072 = (motion->constants[32] * t3975) + (motion->constants[33] * t3963) +
        (motion->constants[31] * t3933) + (cos_theta * t4011) + (t1081 * t4017) + (cos_delta *
        t4039);
    const float t4076 = t4072 + (sin_delta * t4045) - (t1929 * t2636) - (t1906 * t2677) - (t1120 *
        t4005);
    const float t4082 = (t2664 * t3965) + (t2666 * t3977) + (t16 * t4053) - (t13 * t4026) -
        (sin_phi * t4076);
    const float t4091 = t4076 + (t486 * t4082) - (t1930 * t2715) - (t1910 * t3965) - (t2637 *
        t3977);
    const float t4097 = (t2744 * t4091) - (t1930 * t2741) - (t2739 * t4082);
    const float t4103 = (t2766 * t4082) + (t2770 * t4091) - (t1930 * t2767);
    const float t4109 = (t1930 * t2789) + (t2792 * t4091) - (t2787 * t4082);
    const float t4112 = t2810 * t4103;
    const float t4115 = t4112 - (t2806 * t4097) - (t2812 * t4109);
    const float t4138 = t3967 + t4097 + (t1906 * t2945);
    const float t4151 = (t2954 * t3936) + (t2957 * t3952) + (t1679 * t3956) + (t1598 * t4011) -
        (t2950 * t3948) - (t2959 * t3940);
    const float t4152 = t4151 - (t2962 * t3944);
    const float t4165 = (t2973 * t3948) + (t2977 * t3936) + (t2950 * t3952) + (t1666 * t3956) +
        (t2983 * t3944) - (t2980 * t3940);
    const float t4166 = t4165 - (t1606 * t4011);
    const float t4179 = (t2994 * t3948) + (t2997 * t3952) + (t2999 * t3940) + (t3001 * t3956) +
        (t1606 * t4017) - (t3003 * t3944);
    const float t4180 = t4179 - (t1598 * t4005);
    const float t4186 = (t1908 * t2825) + (t2854 * t3916) + (t2873 * t3924) + (t2878 * t3928) +
        (t2883 * t3963) + (t1334 * t3999);
    const float t4191 = t4186 + (t2886 * t3933) + (t297 * t4026) + (t2903 * t4097) + (t2925 *
        t4103) + (t2938 * t4109);
    const float t4196 = t4191 + (t2941 * t4115) + (t2943 * t4138) + (t1075 * t4152) + (t1071 *
        t4166) - (t1906 * t2845);
    const float t4201 = t4196 - (t1929 * t2859) - (t2866 * t3920) - (t2880 * t3975) - (t1538 *
        t3989) - (t2888 * t4039);
    const float t4203 = t4201 - (t2890 * t4045) - (t1081 * t4180);
    const float t4227 = (t3108 * t4103) + (t3111 * t4109) - (t3103 * t4097);
    const float t4236 = (t1722 * t3924) + (t1549 * t3989) + (t3076 * t3963) + (t1332 * t3999) +
        (t3082 * t4097) + (t3089 * t4103);
    const float t4241 = t4236 + (t3097 * t4109) + (t3099 * t4115) + (t3101 * t4138) + (t297 *
        t4227) + (t1098 * t4152);
    const float t4246 = t4241 + (t1075 * t4166) + (t1120 * t4180) - (t2864 * t3916) - (t1929 *
        t3065) - (t3068 * t3920);
    const float t4251 = t4246 - (t1906 * t3058) - (t1908 * t3061) - (t3071 * t3928) - (t3073 *
        t3975) - (t3079 * t3933);
    const float t4252 = t4251 - (t297 * t4053);
    const float t4262 = t4112 + (t3146 * t3916) + (t3148 * t3920) - (t1408 * t4097) - (t1411 *
        t4109);
    const float t4264 = (speeds[3] * t4262) - (t1930 * t3144);
    const float t4270 = (t779 * t4262) - (t775 * t2313) - (t1930 * t3160);
    const float t4277 = t3989 + t3999 + (t1908 * t3181);
    const float t4293 = (t7 * t3965) + (t107 * t4109) - (t12 * t3977) - (t12 * t4097) - (t1279 *
        t4103);
    const float t4322 = (t1908 * t3252) + (t1906 * t3266) + (t3270 * t3916) + (t3280 * t3924) +
        (t3284 * t3928) + (t3288 * t3989);
    const float t4327 = t4322 + (t3290 * t3963) + (t3292 * t3999) + (t2888 * t4045) + (t3300 *
        t4097) + (t3308 * t4103);
    const float t4332 = t4327 + (t3316 * t4109) + (t3318 * t4115) + (t1081 * t4166) + (cos_theta *
        t4180) - (t1929 * t3272);
    const float t4337 = t4332 - (t3276 * t3920) - (t3286 * t3975) - (t3294 * t3933) - (t2890 *
        t4039) - (t3320 * t4138);
    const float t4338 = t4337 - (t1120 * t4152);
    const float t4346 = (t3168 * t3965) + (t3170 * t3977) + (t3188 * t4026) + (t3201 * t4097) +
        (t3220 * t4103) + (t3226 * t4109);
    const float t4351 = t4346 + (t3230 * t4293) + (t3192 * t4227) + (t16 * t4203) - (t3177 *
        t4277) - (t3190 * t4076);
    const float t4354 = t4351 - (t3192 * t4053) - (sin_phi * t4338) - (t13 * t4252);
    const float t4358 = (t2132 * t4082) + (speeds[3] * t4354) + (t797 * t4264);
    const float t4365 = t3506 + (t2138 * t4082) + (speeds[1] * t4354) + (t796 * t4270);
    const float t4384 = (t3381 * t4277) + (t3383 * t4026) + (t2138 * t4076) + (t3392 * t4103) +
        (t3395 * t4109) + (t3397 * t4293);
    const float t4389 = t4384 + (t3386 * t4227) + (speeds[1] * t4338) + (t486 * t4365) - t3500 -
        (t3377 * t3965);
    const float t4392 = t4389 - (t3379 * t3977) - (t3386 * t4053) - (t804 * t4270);
    const float t4398 = (t489 * t4365) + (t74 * t4392) - (t809 * t4270);
    const float t4404 = (t818 * t4270) + (t497 * t4365) + (t77 * t4392);
    const float t4411 = (speeds[0] * t4262) - (t1930 * t3432);
    const float t4415 = (t828 * t4264) + (t513 * t4270) + (t831 * t4411) - (t1930 * t3428);
    const float t4421 = (t135 * t4270) + (t840 * t4411) - (t1930 * t3442);
    const float t4431 = (t2144 * t4082) + (speeds[0] * t4354) + (t797 * t4411);
    const float t4436 = (t3449 * t4082) + (t506 * t4358) + (t514 * t4365) + (t517 * t4431) -
        (t1930 * t3450);
    const float t4444 = (t3519 * t4082) + (t525 * t4365) + (t527 * t4431) - (t1930 * t3520);
    const float t4466 = (t3537 * t4277) + (t3539 * t4026) + (t2144 * t4076) + (t3544 * t4103) +
        (t3546 * t4109) + (t3548 * t4293);
    const float t4471 = t4466 + (t3542 * t4227) + (speeds[0] * t4338) + (t486 * t4431) - (t3533 *
        t3965) - (t3535 * t3977);
    const float t4473 = t4471 - (t3542 * t4053) - (t859 * t4411);
    const float t4483 = (t855 * t4270) + (t531 * t4365) + (t98 * t4392) + (t53 * t4473) + (t547 *
        t4421) + (t537 * t4444);
    const float t4485 = t4483 - (t117 * t4415) - (t36 * t4436);
    const float t4498 = t4398 + (t36 * t4415) + (t547 * t4444) - (t3580 * t4091) - (t137 * t4392) -
        (t142 * t4473);
    const float t4500 = t4498 - (t537 * t4421) - (t117 * t4436);
    const float t4506 = (t817 * t4270) + (t496 * t4365) - (sin_phi * t4485);
    const float t4512 = (t1906 * t2357) + (t1908 * t2381) + (t2158 * t4026) + (t2144 * t4053) +
        (t2397 * t4082) + (t2712 * t4091);
    const float t4517 = t4512 + (t2765 * t4103) + (t2785 * t4109) + (t2805 * t4115) + (speeds[0] *
        t4203) + (t777 * t4264);
    const float t4522 = t4517 + (t792 * t4270) + (t444 * t4358) + (t479 * t4365) + (t65 * t4392) +
        (motion->constants[31] * t4404);
    const float t4527 = t4522 + (t827 * t4415) + (t524 * t4444) + (t114 * t4500) +
        (motion->constants[39] * t4506) - (t1930 * t2400);
    const float t4532 = t4527 - (t2177 * t3965) - (t1512 * t3977) - (t2737 * t4097) - (t1304 *
        t4252) - (motion->constants[30] * t4398);
    const float t4535 = t4532 - (t838 * t4421) - (t504 * t4436) - (t97 * t4485);
    const float t4571 = (t1906 * t3632) + (t1512 * t3965) + (t2144 * t4026) + (t3661 * t4091) +
        (t3666 * t4097) + (t3672 * t4103);
    const float t4576 = t4571 + (t3678 * t4109) + (t3686 * t4115) + (t1331 * t4227) + (t1304 *
        t4203) + (speeds[0] * t4252);
    const float t4581 = t4576 + (t909 * t4264) + (t917 * t4270) + (t568 * t4358) + (t576 * t4365) +
        (t156 * t4392);
    const float t4586 = t4581 + (t926 * t4415) + (t587 * t4444) + (t185 * t4500) - (t1908 * t2342) -
        (t1930 * t3647);
    const float t4591 = t4586 - (t2177 * t3977) - (t2158 * t4053) - (t3644 * t4082) -
        (motion->constants[31] * t4398) - (motion->constants[30] * t4404);
    const float t4595 = t4591 - (t930 * t4421) - (t583 * t4436) - (t175 * t4485) - (t48 * t4506);
    const float t4615 = (t1908 * t3743) + (t3748 * t3999) + (t1354 * t4097) + (t3758 * t4103) +
        (t3762 * t4109) + (t3764 * t4138);
    const float t4620 = t4615 + (t12 * t4500) - (t1906 * t3741) - (t1929 * t3745) - (t3752 *
        t3933) - (t12 * t4398);
    const float t4622 = t4620 - (t7 * t4404) - (t7 * t4506);
    const float t4624 = t3793 * t3916;
    const float t4626 = t3796 * t3920;
    const float t4628 = t4624 + t4626 - (t1929 * t2304);
    const float t4634 = (t3805 * t3916) + (t1929 * t3809) + (t3811 * t3920);
    const float t4636 = t1929 * t3816;
    const float t4639 = t4624 + t4636 + (t2285 * t3920);
    const float t4649 = (t2280 * t3920) + (t3805 * t3924) + (t3831 * t3928) - (t1906 * t3826) -
        (t1929 * t2295);
    const float t4653 = (t3792 * t4628) + (t3804 * t4634) + (motion->constants[18] * t4649) -
        (t3792 * t4639);
    const float t4657 = t4636 + (t2287 * t3916) - t4626;
    const float t4669 = (t1906 * t3852) + (t2280 * t3916) + (t1929 * t2299) + (t3811 * t3924) -
        (t3857 * t3928);
    const float t4673 = (t3842 * t4657) + (t3842 * t4628) + (t3791 * t4634) +
        (motion->constants[18] * t4669);
    const float t4675 = (motion->constants[2] * t4653) + (motion->constants[3] * t4673);
    const float t4687 = (t7 * t4500) + (t12 * t4506);
    const float t4692 = (t1908 * t3736) + (t3872 * t3999) + (t3874 * t3933) + (t3880 * t4103) +
        (t3884 * t4109) + (t12 * t4404);
    const float t4696 = t4692 + t4687 - (t1906 * t2352) - (t3887 * t4138) - (t7 * t4398);
    const float t4699 = (motion->constants[3] * t4622) + (motion->constants[2] * t4696) - t4675;
    const float t4702 = (t155 * t4595) + t4699 - (t58 * t4535) - (t1940 * t3908);
    const float t4706 = (motion->constants[3] * motion->constants[55]) - (motion->constants[2] *
        motion->constants[54]);
    const float t4707 = t1081 * t4706;
    const float t4709 = t1120 * t4706;
    const float t4711 = cos_theta * t4706;
    const float t4713 = t1992 + (motion->constants[32] * t4711);
    const float t4716 = t1998 + (motion->constants[33] * t4711);
    const float t4724 = (motion->constants[32] * t4709) - t1983 - (motion->constants[33] * t4707);
    const float t4730 = (t2666 * t4709) + (t13 * t4713) - (t2664 * t4707) - (sin_phi * t4724) -
        (t16 * t4716);
    const float t4737 = t4724 + (t1910 * t4707) + (t486 * t4730) - (t2637 * t4709);
    const float t4741 = (t2744 * t4737) - (t2739 * t4730);
    const float t4745 = (t2766 * t4730) + (t2770 * t4737);
    const float t4749 = (t2792 * t4737) - (t2787 * t4730);
    const float t4752 = t2810 * t4745;
    const float t4755 = t4752 - (t2806 * t4741) - (t2812 * t4749);
    const float t4764 = (motion->constants[2] * t2950) - (motion->constants[3] * t2957);
    const float t4768 = (motion->constants[2] * t2973) + (motion->constants[3] * t2950);
    const float t4776 = (t1598 * motion->constants[77]) - (motion->constants[2] * t2994) -
        (motion->constants[3] * t2997) - (t1606 * motion->constants[76]);
    const float t4786 = (t2943 * t4741) + (t1075 * t4764) + (t2903 * t4741) + (t2925 * t4745) +
        (t2938 * t4749) + (t2941 * t4755);
    const float t4791 = t4786 - (t2880 * t4709) - (t1538 * t4711) - (t2883 * t4707) - (t297 *
        t4713) - (t1071 * t4768);
    const float t4792 = t4791 - (t1081 * t4776);
    const float t4810 = (t3111 * t4749) + (t3108 * t4745) - (t3103 * t4741);
    const float t4816 = (t1549 * t4711) + (t297 * t4716) + (t3089 * t4745) + (t3099 * t4755) +
        (t1098 * t4764) + (t1120 * t4776);
    const float t4821 = t4816 + (t3082 * t4741) + (t3097 * t4749) + (t3101 * t4741) + (t297 *
        t4810) - (t3073 * t4709);
    const float t4823 = t4821 - (t3076 * t4707) - (t1075 * t4768);
    const float t4828 = t4752 - (t1408 * t4741) - (t1411 * t4749);
    const float t4829 = speeds[3] * t4828;
    const float t4831 = t779 * t4828;
    const float t4846 = (t107 * t4749) - (t7 * t4707) - (t12 * t4709) - (t12 * t4741) - (t1279 *
        t4745);
    const float t4869 = (t3288 * t4711) + (cos_theta * t4776) + (t3300 * t4741) + (t3308 * t4745) +
        (t3316 * t4749) + (t3318 * t4755);
    const float t4874 = t4869 - (t3286 * t4709) - (t3290 * t4707) - (t3320 * t4741) - (t1120 *
        t4764) - (t1081 * t4768);
    const float t4882 = (t3192 * t4716) + (t3230 * t4846) + (t3170 * t4709) + (t3201 * t4741) +
        (t3220 * t4745) + (t3226 * t4749);
    const float t4887 = t4882 + (t3192 * t4810) + (t16 * t4792) - (t3177 * t4711) - (t3188 *
        t4713) - (t3190 * t4724);
    const float t4890 = t4887 - (t3168 * t4707) - (sin_phi * t4874) - (t13 * t4823);
    const float t4894 = (t2132 * t4730) + (speeds[3] * t4890) + (t797 * t4829);
    const float t4900 = (t2138 * t4730) + (speeds[1] * t4890) + (t796 * t4831);
    const float t4919 = (t3377 * t4707) + (t3381 * t4711) + (t2138 * t4724) + (t3386 * t4716) +
        (t3392 * t4745) + (t3395 * t4749);
    const float t4924 = t4919 + (t3397 * t4846) + (t3386 * t4810) + (speeds[1] * t4874) + (t486 *
        t4900) - (t3379 * t4709);
    const float t4926 = t4924 - (t3383 * t4713) - (t804 * t4831);
    const float t4932 = (t489 * t4900) + (t74 * t4926) - (t809 * t4831);
    const float t4938 = (t818 * t4831) + (t497 * t4900) + (t77 * t4926);
    const float t4942 = speeds[0] * t4828;
    const float t4945 = (t828 * t4829) + (t513 * t4831) + (t831 * t4942);
    const float t4949 = (t135 * t4831) + (t840 * t4942);
    const float t4958 = (t2144 * t4730) + (speeds[0] * t4890) + (t797 * t4942);
    const float t4962 = (t3449 * t4730) + (t506 * t4894) + (t514 * t4900) + (t517 * t4958);
    const float t4968 = (t3519 * t4730) + (t525 * t4900) + (t527 * t4958);
    const float t4990 = (t3533 * t4707) + (t3537 * t4711) + (t2144 * t4724) + (t3542 * t4716) +
        (t3544 * t4745) + (t3546 * t4749);
    const float t4995 = t4990 + (t3548 * t4846) + (t3542 * t4810) + (speeds[0] * t4874) + (t486 *
        t4958) - (t3535 * t4709);
    const float t4997 = t4995 - (t3539 * t4713) - (t859 * t4942);
    const float t5007 = (t855 * t4831) + (t531 * t4900) + (t98 * t4926) + (t53 * t4997) + (t547 *
        t4949) + (t537 * t4968);
    const float t5009 = t5007 - (t117 * t4945) - (t36 * t4962);
    const float t5022 = t4932 + (t36 * t4945) + (t547 * t4968) - (t3580 * t4737) - (t137 * t4926) -
        (t142 * t4997);
    const float t5024 = t5022 - (t537 * t4949) - (t117 * t4962);
    const float t5030 = (t817 * t4831) + (t496 * t4900) - (sin_phi * t5009);
    const float t5036 = (t2177 * t4707) + (t2397 * t4730) + (t2712 * t4737) + (t2765 * t4745) +
        (t2785 * t4749) + (t2805 * t4755);
    const float t5041 = t5036 + (speeds[0] * t4792) + (t777 * t4829) + (t792 * t4831) + (t444 *
        t4894) + (t479 * t4900);
    const float t5046 = t5041 + (t65 * t4926) + (motion->constants[31] * t4938) + (t827 * t4945) +
        (t524 * t4968) + (t114 * t5024);
    const float t5051 = t5046 + (motion->constants[39] * t5030) - (t1512 * t4709) - (t2158 *
        t4713) - (t2144 * t4716) - (t2737 * t4741);
    const float t5056 = t5051 - (t1304 * t4823) - (motion->constants[30] * t4932) - (t838 * t4949) -
        (t504 * t4962) - (t97 * t5009);
    const float t5089 = (t2158 * t4716) + (t3661 * t4737) + (t3666 * t4741) + (t3672 * t4745) +
        (t3678 * t4749) + (t3686 * t4755);
    const float t5094 = t5089 + (t1331 * t4810) + (t1304 * t4792) + (speeds[0] * t4823) + (t909 *
        t4829) + (t917 * t4831);
    const float t5099 = t5094 + (t568 * t4894) + (t576 * t4900) + (t156 * t4926) + (t926 * t4945) +
        (t587 * t4968);
    const float t5104 = t5099 + (t185 * t5024) - (t1512 * t4707) - (t2177 * t4709) - (t2144 *
        t4713) - (t3644 * t4730);
    const float t5109 = t5104 - (motion->constants[31] * t4932) - (motion->constants[30] * t4938) -
        (t930 * t4949) - (t583 * t4962) - (t175 * t5009);
    const float t5110 = t5109 - (t48 * t5030);
    const float t5121 = (t7 * t5024) + (t12 * t5030);
    const float t5126 = (t3880 * t4745) + (t3884 * t4749) + (t12 * t4938) + t5121 - (t3887 *
        t4741) - (t7 * t4932);
    const float t5140 = (t1354 * t4741) + (t3758 * t4745) + (t3762 * t4749) + (t3764 * t4741) +
        (t12 * t5024) - (t12 * t4932);
    const float t5142 = t5140 - (t7 * t4938) - (t7 * t5030);
    const float t5144 = (motion->constants[2] * t5126) + (motion->constants[3] * t5142);
    const float t5148 = (t155 * t5110) + t5144 - (t58 * t5056) - (t2012 * t3908) - (t2016 * t4702);
    const float t5155 = t12 * t2043;
    const float t5159 = (sin_delta * t2041) - (t107 * t2043);
    const float t5164 = (t2041 * t2424) + (t2043 * t2428) - t2423;
    const float t5169 = t2440 + (t2041 * t2441) + (t2043 * t2445);
    const float t5174 = (t2064 * t2408) + (t2410 * t5159) + (t2435 * t5169) - (t1202 * t5155) -
        (t2416 * t5164);
    const float t5177 = (t2043 * t2463) + (cos_theta * t2041);
    const float t5182 = t2485 + (t2041 * t2487) - (t2043 * t2478);
    const float t5187 = t2501 + (t2043 * t2494) + (t2041 * t2503);
    const float t5191 = (t2043 * t2509) - (t1120 * t2041);
    const float t5195 = (t2043 * t2516) + (t1081 * t2041);
    const float t5200 = t2527 + (t2043 * t2523) + (t2041 * t2529);
    const float t5203 = (motion->constants[54] * t5191) + (motion->constants[24] * t5200) -
        (motion->constants[55] * t5195);
    const float t5207 = (t2457 * t5177) + (t2469 * t5182) + (t2492 * t5187) - (t1081 * t5203);
    const float t5210 = t2402 + (t2041 * t2403) + t5174 + t5207;
    const float t5212 = motion->constants[48] * t2064;
    const float t5220 = (t2551 * t5177) + (t2553 * t5182) + (t2469 * t5187) + (t1120 * t5203);
    const float t5223 = t5212 + (t2041 * t2547) - t2546 - t5220;
    const float t5235 = (t2575 * t5177) + (t2579 * t5187) + (cos_theta * t5203) - (t2577 * t5182);
    const float t5245 = (t2064 * t2410) + (t1134 * t5155) + (t2435 * t5164) + (t2416 * t5169) -
        (t2408 * t5159);
    const float t5251 = (motion->constants[59] * t5191) + (motion->constants[57] * t5195) +
        (motion->constants[54] * t5200);
    const float t5257 = (motion->constants[58] * t5177) + (motion->constants[55] * t5187) -
        (motion->constants[54] * t5182);
    const float t5263 = (motion->constants[57] * t5191) + (motion->constants[56] * t5195) -
        (motion->constants[55] * t5200);
    const float t5269 = (motion->constants[53] * t5155) + (motion->constants[51] * t5159) + (t2043 *
        t2569) + (motion->constants[48] * t5164) + (motion->constants[30] * t5245) + (t1098 *
        t5251);
    const float t5272 = t5269 + (t1120 * t5257) + (t1075 * t5263) - (motion->constants[32] * t5235);
    const float t5286 = (motion->constants[52] * t2064) + (t2041 * t2639) + (motion->constants[49] *
        t5169) - t2114 - t2638;
    const float t5292 = (motion->constants[51] * t5155) + (motion->constants[50] * t5159) -
        (motion->constants[49] * t5164);
    const float t5298 = (t2043 * t2629) + (t1075 * t5251) + (t1071 * t5263) + (cos_delta * t5292) -
        (motion->constants[33] * t5235) - (motion->constants[31] * t5245);
    const float t5300 = t5298 - (t1081 * t5257) - (sin_delta * t5286);
    const float t5319 = t2675 + (t2064 * t2636) + (t2041 * t2677) + (motion->constants[32] *
        t5220) + (motion->constants[33] * t5207) + (motion->constants[31] * t5174);
    const float t5324 = t5319 + (cos_theta * t5257) + (t1081 * t5263) + (cos_delta * t5286) +
        (sin_delta * t5292) - motion->constants[27];
    const float t5325 = t5324 - (t1120 * t5251);
    const float t5331 = (t2664 * t5210) + (t16 * t5300) - (t2666 * t5223) - (t13 * t5272) -
        (sin_phi * t5325);
    const float t5340 = t5325 + (t2637 * t5223) + (t486 * t5331) - (t2065 * t2715) - (t1910 *
        t5210);
    const float t5346 = (t2744 * t5340) - (t2065 * t2741) - (t2739 * t5331);
    const float t5352 = (t2766 * t5331) + (t2770 * t5340) - (t2065 * t2767);
    const float t5358 = (t2065 * t2789) + (t2792 * t5340) - (t2787 * t5331);
    const float t5361 = t2810 * t5352;
    const float t5364 = t5361 - (t2806 * t5346) - (t2812 * t5358);
    const float t5388 = t2944 + t5346 - t5212 - (t2041 * t2945);
    const float t5401 = (t2954 * t5177) + (t2957 * t5195) + (t2959 * t5182) + (t1679 * t5200) +
        (t1598 * t5257) - (t2950 * t5191);
    const float t5402 = t5401 - (t2962 * t5187);
    const float t5415 = (t2973 * t5191) + (t2977 * t5177) + (t2950 * t5195) + (t2980 * t5182) +
        (t1666 * t5200) + (t2983 * t5187);
    const float t5416 = t5415 - (t1606 * t5257);
    const float t5429 = (t2994 * t5191) + (t2997 * t5195) + (t3001 * t5200) + (t1606 * t5263) -
        (t2999 * t5182) - (t3003 * t5187);
    const float t5430 = t5429 - (t1598 * t5251);
    const float t5436 = t2841 + (t2043 * t2825) + (t2041 * t2845) + (t2854 * t5155) + (t2064 *
        t2859) + (t2866 * t5159);
    const float t5441 = t5436 + (t2873 * t5164) + (t2878 * t5169) + (t2883 * t5207) + (t1334 *
        t5245) + (t2886 * t5174);
    const float t5446 = t5441 + (t297 * t5272) + (t2903 * t5346) + (t2925 * t5352) + (t2938 *
        t5358) + (t2941 * t5364);
    const float t5451 = t5446 + (t2943 * t5388) + (t1075 * t5402) + (t1071 * t5416) - (t2880 *
        t5220) - (t1538 * t5235);
    const float t5454 = t5451 - (t2888 * t5286) - (t2890 * t5292) - (t1081 * t5430);
    const float t5478 = (t3108 * t5352) + (t3111 * t5358) - (t3103 * t5346);
    const float t5487 = t3054 + (t2064 * t3065) + (t3068 * t5159) + (t2041 * t3058) + (t1722 *
        t5164) + (t1549 * t5235);
    const float t5492 = t5487 + (t3076 * t5207) + (t1332 * t5245) + (t3082 * t5346) + (t3089 *
        t5352) + (t3097 * t5358);
    const float t5497 = t5492 + (t3099 * t5364) + (t3101 * t5388) + (t297 * t5478) + (t1098 *
        t5402) + (t1075 * t5416);
    const float t5502 = t5497 + (t1120 * t5430) - (t2864 * t5155) - (t2043 * t3061) - (t3071 *
        t5169) - (t3073 * t5220);
    const float t5504 = t5502 - (t3079 * t5174) - (t297 * t5300);
    const float t5514 = t5361 + (t3146 * t5155) - (t3148 * t5159) - (t1408 * t5346) - (t1411 *
        t5358);
    const float t5517 = (speeds[3] * t5514) - t2313 - (t2065 * t3144);
    const float t5521 = (t779 * t5514) - (t2065 * t3160);
    const float t5528 = t5235 + t5245 + (t2043 * t3181);
    const float t5544 = (t7 * t5210) + (t12 * t5223) + (t107 * t5358) - (t12 * t5346) - (t1279 *
        t5352);
    const float t5573 = t3265 + (t2043 * t3252) + (t3270 * t5155) + (t2064 * t3272) + (t3276 *
        t5159) + (t3280 * t5164);
    const float t5578 = t5573 + (t3284 * t5169) + (t3288 * t5235) + (t3290 * t5207) + (t3292 *
        t5245) + (t2888 * t5292);
    const float t5583 = t5578 + (t3300 * t5346) + (t3308 * t5352) + (t3316 * t5358) + (t3318 *
        t5364) + (t1081 * t5416);
    const float t5588 = t5583 + (cos_theta * t5430) - (t2041 * t3266) - (t3286 * t5220) - (t3294 *
        t5174) - (t2890 * t5286);
    const float t5590 = t5588 - (t3320 * t5388) - (t1120 * t5402);
    const float t5598 = (t3168 * t5210) + (t3188 * t5272) + (t3201 * t5346) + (t3220 * t5352) +
        (t3226 * t5358) + (t3230 * t5544);
    const float t5603 = t5598 + (t3192 * t5478) + (t16 * t5454) - (t3170 * t5223) - (t3177 *
        t5528) - (t3190 * t5325);
    const float t5606 = t5603 - (t3192 * t5300) - (sin_phi * t5590) - (t13 * t5504);
    const float t5611 = t3506 + (t2132 * t5331) + (speeds[3] * t5606) + (t797 * t5517);
    const float t5617 = (t2138 * t5331) + (speeds[1] * t5606) + (t796 * t5521);
    const float t5636 = (t3379 * t5223) + (t3381 * t5528) + (t3383 * t5272) + (t2138 * t5325) +
        (t3392 * t5352) + (t3395 * t5358);
    const float t5641 = t5636 + (t3397 * t5544) + (t3386 * t5478) + (speeds[1] * t5590) + (t486 *
        t5617) - (t3377 * t5210);
    const float t5643 = t5641 - (t3386 * t5300) - (t804 * t5521);
    const float t5649 = (t489 * t5617) + (t74 * t5643) - (t809 * t5521);
    const float t5655 = (t818 * t5521) + (t497 * t5617) + (t77 * t5643);
    const float t5662 = (speeds[0] * t5514) - (t2065 * t3432);
    const float t5666 = (t828 * t5517) + (t513 * t5521) + (t831 * t5662) - (t2065 * t3428);
    const float t5672 = (t135 * t5521) + (t840 * t5662) - (t2065 * t3442);
    const float t5682 = (t2144 * t5331) + (speeds[0] * t5606) + (t797 * t5662);
    const float t5687 = (t3449 * t5331) + (t506 * t5611) + (t514 * t5617) + (t517 * t5682) -
        (t2065 * t3450);
    const float t5695 = (t3519 * t5331) + (t525 * t5617) + (t527 * t5682) - (t2065 * t3520);
    const float t5717 = (t3535 * t5223) + (t3537 * t5528) + (t3539 * t5272) + (t2144 * t5325) +
        (t3544 * t5352) + (t3546 * t5358);
    const float t5722 = t5717 + (t3548 * t5544) + (t3542 * t5478) + (speeds[0] * t5590) + (t486 *
        t5682) - (t3533 * t5210);
    const float t5724 = t5722 - (t3542 * t5300) - (t859 * t5662);
    const float t5734 = (t855 * t5521) + (t531 * t5617) + (t98 * t5643) + (t53 * t5724) + (t547 *
        t5672) + (t537 * t5695);
    const float t5736 = t5734 - (t117 * t5666) - (t36 * t5687);
    const float t5749 = t5649 + (t36 * t5666) + (t547 * t5695) - (t3580 * t5340) - (t137 * t5643) -
        (t142 * t5724);
    const float t5751 = t5749 - (t537 * t5672) - (t117 * t5687);
    const float t5757 = (t817 * t5521) + (t496 * t5617) - (sin_phi * t5736);
    const float t5763 = t2357 + (t2043 * t2381) + (t1512 * t5223) + (t2158 * t5272) + (t2144 *
        t5300) + (t2397 * t5331);
    const float t5768 = t5763 + (t2712 * t5340) + (t2765 * t5352) + (t2785 * t5358) + (t2805 *
        t5364) + (speeds[0] * t5454);
    const float t5773 = t5768 + (t777 * t5517) + (t792 * t5521) + (t444 * t5611) + (t479 * t5617) +
        (t65 * t5643);
    const float t5778 = t5773 + (motion->constants[31] * t5655) + (t827 * t5666) + (t524 * t5695) +
        (t114 * t5751) + (motion->constants[39] * t5757);
    const float t5783 = t5778 - (t2041 * t2357) - (t2065 * t2400) - (t2177 * t5210) - (t2737 *
        t5346) - (t1304 * t5504);
    const float t5787 = t5783 - (motion->constants[30] * t5649) - (t838 * t5672) - (t504 * t5687) -
        (t97 * t5736);
    const float t5823 = t3632 + (t1512 * t5210) + (t2177 * t5223) + (t2144 * t5272) + (t3661 *
        t5340) + (t3666 * t5346);
    const float t5828 = t5823 + (t3672 * t5352) + (t3678 * t5358) + (t3686 * t5364) + (t1331 *
        t5478) + (t1304 * t5454);
    const float t5833 = t5828 + (speeds[0] * t5504) + (t909 * t5517) + (t917 * t5521) + (t568 *
        t5611) + (t576 * t5617);
    const float t5838 = t5833 + (t156 * t5643) + (t926 * t5666) + (t587 * t5695) + (t185 * t5751) -
        (t2041 * t3632);
    const float t5843 = t5838 - (t2043 * t2342) - (t2065 * t3647) - (t2158 * t5300) - (t3644 *
        t5331) - (motion->constants[31] * t5649);
    const float t5848 = t5843 - (motion->constants[30] * t5655) - (t930 * t5672) - (t583 * t5687) -
        (t175 * t5736) - (t48 * t5757);
    const float t5870 = (t2041 * t3741) + (t2043 * t3743) + (t2064 * t3745) + (t3748 * t5245) +
        (t1354 * t5346) + (t3758 * t5352);
    const float t5875 = t5870 + (t3762 * t5358) + (t3764 * t5388) + (t12 * t5751) - t3739 - (t3752 *
        t5174);
    const float t5878 = t5875 - (t12 * t5649) - (t7 * t5655) - (t7 * t5757);
    const float t5880 = t3793 * t5155;
    const float t5882 = t3796 * t5159;
    const float t5884 = t5880 + (t2064 * t2304) - t5882;
    const float t5890 = (t2064 * t3809) + (t3811 * t5159) - (t3805 * t5155);
    const float t5892 = t2064 * t3816;
    const float t5895 = t5892 + (t2285 * t5159) - t5880;
    const float t5906 = (t2041 * t3826) + (t2064 * t2295) + (t3805 * t5164) + (t3831 * t5169) -
        t3825 - (t2280 * t5159);
    const float t5910 = (t3792 * t5884) + (t3792 * t5895) + (motion->constants[18] * t5906) -
        (t3804 * t5890);
    const float t5914 = t5882 + (t2287 * t5155) - t5892;
    const float t5927 = t3851 + (t2280 * t5155) + (t3811 * t5164) - (t2041 * t3852) - (t2064 *
        t2299) - (t3857 * t5169);
    const float t5931 = (t3842 * t5914) + (t3842 * t5884) + (motion->constants[18] * t5927) -
        (t3791 * t5890);
    const float t5933 = (motion->constants[2] * t5910) + (motion->constants[3] * t5931);
    const float t5945 = (t7 * t5751) + (t12 * t5757);
    const float t5950 = (t2041 * t2352) + (t2043 * t3736) + (t3872 * t5245) + (t3874 * t5174) +
        (t3880 * t5352) + (t3884 * t5358);
    const float t5954 = t5950 + (t12 * t5655) + t5945 - (t3887 * t5388) - (t7 * t5649);
    const float t5957 = (motion->constants[3] * t5878) + (motion->constants[2] * t5954) - t5933;
    const float t5962 = (t155 * t5848) + (t2094 * t5148) + t5957 - (t58 * t5787) - (t2072 * t3908) -
        (t2088 * t4702);
    const float t5963 = t2131 * t5962;
    const float t5965 = (t2024 * t5148) + (t2094 * t5963);
    const float t5969 = (t1958 * t4702) - (t2016 * t5965) - (t2088 * t5963);
    const float t5975 = (t1295 * t3908) - (t1940 * t5969) - (t2012 * t5965) - (t2072 * t5963);
    const float t5977 = t3796 - t1387;
    const float t5979 = t1434 + t3816;
    const float t5982 = motion->constants[38] * motion->constants[29];
    const float t5983 = t5982 + t5982;
    const float t5985 = motion->constants[37] * motion->constants[29];
    const float t5993 = t3893 + (t2773 * t5977) + (t2795 * t5979) + (t3799 * t5983) + (t3814 *
        t5985) + (t3836 * motion->constants[29]);
    const float t5995 = t5993 - (t2747 * t3823) - (t3820 * t5983);
    const float t5997 = t3816 - t1434;
    const float t5999 = t1339 + t3793;
    const float t6002 = t5985 + t5985;
    const float t6016 = (t2747 * t5997) + (t2773 * t5999) + (t3845 * t6002) + (t3799 * t6002) +
        (t3814 * t5982) + (t3862 * motion->constants[29]);
    const float t6021 = t6016 + (t971 * t3163) + (t622 * t3374) + (t28 * t3578) + (t89 * t3594) -
        (t2795 * t3857);
    const float t6022 = t6021 - (t107 * t3600);
    const float t6029 = t3906 + (t228 * t3734) - (motion->constants[2] * t5995) -
        (motion->constants[3] * t6022) - (t226 * t3630);
    const float t6042 = t4687 + (t4103 * t5977) + (t4109 * t5979) + (t4628 * t5983) + (t4634 *
        t5985) + (t4649 * motion->constants[29]);
    const float t6044 = t6042 - (t3823 * t4097) - (t4639 * t5983);
    const float t6062 = (t4097 * t5997) + (t4103 * t5999) + (t4657 * t6002) + (t4628 * t6002) +
        (t4634 * t5982) + (t4669 * motion->constants[29]);
    const float t6067 = t6062 + (t971 * t4270) + (t622 * t4365) + (t28 * t4485) + (t89 * t4500) -
        (t3857 * t4109);
    const float t6068 = t6067 - (t107 * t4506);
    const float t6077 = t4699 + (t228 * t4595) - (motion->constants[2] * t6044) -
        (motion->constants[3] * t6068) - (t226 * t4535) - (t1940 * t6029);
    const float t6084 = t5121 + (t4745 * t5977) + (t4749 * t5979) - (t3823 * t4741);
    const float t6098 = (t4741 * t5997) + (t4745 * t5999) + (t971 * t4831) + (t622 * t4900) + (t28 *
        t5009) + (t89 * t5024);
    const float t6100 = t6098 - (t3857 * t4749) - (t107 * t5030);
    const float t6110 = t5144 + (t228 * t5110) - (motion->constants[2] * t6084) -
        (motion->constants[3] * t6100) - (t226 * t5056) - (t2012 * t6029);
    const float t6111 = t6110 - (t2016 * t6077);
    const float t6124 = t5945 + (t5352 * t5977) + (t5358 * t5979) + (t5884 * t5983) + (t5895 *
        t5983) + (t5906 * motion->constants[29]);
    const float t6126 = t6124 - (t3823 * t5346) - (t5890 * t5985);
    const float t6144 = (t5346 * t5997) + (t5352 * t5999) + (t5914 * t6002) + (t5884 * t6002) +
        (t5927 * motion->constants[29]) + (t971 * t5521);
    const float t6149 = t6144 + (t622 * t5617) + (t28 * t5736) + (t89 * t5751) - (t3857 * t5358) -
        (t5890 * t5982);
    const float t6150 = t6149 - (t107 * t5757);
    const float t6161 = t5957 + (t228 * t5848) + (t2094 * t6111) - (motion->constants[2] * t6126) -
        (motion->constants[3] * t6150) - (t226 * t5787);
    const float t6164 = t2131 * (t6161 - (t2072 * t6029) - (t2088 * t6077));
    const float t6166 = (t2024 * t6111) + (t2094 * t6164);
    const float t6170 = (t1958 * t6077) - (t2016 * t6166) - (t2088 * t6164);
    const float t6176 = (t1295 * t6029) - (t1940 * t6170) - (t2012 * t6166) - (t2072 * t6164);
    const float t6177 = sin_theta * t2241;
    const float t6178 = motion->constants[3] * t1068;
    const float t6183 = t1068 * (motion->constants[3] + motion->constants[3]);
    const float t6185 = motion->constants[2] * t1068;
    const float t6189 = (motion->constants[3] * ((t2248 * t6178) - t6177)) - (motion->constants[2] *
        ((t2218 * t6183) + (t2248 * t6185)));
    const float t6192 = t1068 * (motion->constants[2] + motion->constants[2]);
    const float t6200 = (motion->constants[3] * ((t2248 * t6192) + (t2218 * t6178))) -
        (motion->constants[2] * (t6177 + (t2218 * t6185)));
    const float t6204 = (t1120 * t2253) + (t1081 * t2265);
    const float t6207 = sin_theta * t2260;
    const float t6209 = t2265 * t6192;
    const float t6213 = (motion->constants[33] * t2265) + (motion->constants[32] * t2253);
    const float t6220 = t2253 * t6183;
    const float t6232 = (t12 * t2265) + (t7 * t2253);
    const float t6244 = motion->constants[7] * ((motion->constants[3] * ((t7 * t6209) + (t6178 *
        t6232) - (t12 * t6207))) - (motion->constants[2] * ((t12 * t6220) + (t7 * t6207) + (t6185 *
        t6232))));
    const float t6245 = (motion->constants[3] * ((sin_theta * t2218) + (motion->constants[32] *
        t6209) + (t6178 * t6213) - (motion->constants[33] * t6207))) - (motion->constants[2] *
        ((motion->constants[33] * t6220) + (motion->constants[32] * t6207) + (t6185 * t6213) -
        (sin_theta * t2248)));
    const float t6246 = t6245 - t6244;
    const float t6252 = (t12 * t6200) + (t2477 * t6204) - (t7 * t6189);
    const float t6254 = sin_theta * t2187;
    const float t6256 = t2193 * t6192;
    const float t6260 = (motion->constants[55] * t2193) - (motion->constants[54] * t2181);
    const float t6265 = t2181 * t6183;
    const float t6272 = (motion->constants[3] * ((motion->constants[55] * t6254) + (t6178 * t6260) -
        (motion->constants[54] * t6256))) - (motion->constants[2] * ((motion->constants[55] *
        t6265) + (motion->constants[54] * t6254) + (t6185 * t6260)));
    const float t6275 = motion->constants[24] * t2181;
    const float t6279 = motion->constants[24] * t6254;
    const float t6283 = (motion->constants[3] * ((motion->constants[24] * t6256) + (t6178 *
        t6275))) - (motion->constants[2] * ((t6185 * t6275) - t6279));
    const float t6285 = motion->constants[24] * t2193;
    const float t6293 = (motion->constants[3] * (t6279 + (t6178 * t6285))) - (motion->constants[2] *
        ((motion->constants[24] * t6265) + (t6185 * t6285)));
    const float t6297 = (t1120 * t2181) + (t1081 * t2193);
    const float t6305 = t1578 + (sin_theta * t2173);
    const float t6309 = (motion->constants[3] * (t2134 + (t2166 * t6192) + (t2161 * t6178))) -
        (motion->constants[2] * ((t2161 * t6185) - t6305));
    const float t6319 = (motion->constants[3] * ((speeds[2] * t1601) + (sin_theta * t2161))) +
        (motion->constants[2] * ((speeds[2] * t1609) + (sin_theta * t2166)));
    const float t6329 = (motion->constants[3] * (t6305 + (t2166 * t6178))) - (motion->constants[2] *
        (t2134 + (t2161 * t6183) + (t2166 * t6185)));
    const float t6334 = motion->constants[3] * motion->constants[22];
    const float t6335 = (motion->constants[2] * motion->constants[21]) + t6334;
    const float t6338 = motion->constants[2] * motion->constants[22];
    const float t6341 = t6338 + (motion->constants[3] * motion->constants[23]);
    const float t6344 = (motion->constants[3] * (t6335 + t6335)) - (motion->constants[2] * (t6341 +
        t6341));
    const float t6346 = t1601 * t1609;
    const float t6347 = t2467 * t6346;
    const float t6348 = t1577 * t1609;
    const float t6349 = t2520 * t6348;
    const float t6351 = (t2214 * t2513) + t6349 - t6347;
    const float t6354 = (motion->constants[3] * motion->constants[21]) - t6338;
    const float t6358 = t6334 - (motion->constants[2] * motion->constants[23]);
    const float t6361 = (motion->constants[3] * (t6354 - t6341)) - (motion->constants[2] * (t6335 +
        t6358));
    const float t6362 = t6348 - t2205;
    const float t6364 = t1609 * t1609;
    const float t6365 = t1601 * t1601;
    const float t6366 = t6364 - t6365;
    const float t6368 = t1577 * t1601;
    const float t6369 = t2214 + t6368;
    const float t6372 = (t2467 * t6366) + (t2520 * t6369) - (t2513 * t6362);
    const float t6378 = (motion->constants[3] * (t6358 + t6358)) + (motion->constants[2] * (t6354 +
        t6354));
    const float t6379 = t2513 * t6368;
    const float t6382 = t6347 + (t2205 * t2520) - t6379;
    const float t6388 = motion->constants[26] - motion->constants[4];
    const float t6390 = (motion->constants[3] * motion->constants[25]) - (motion->constants[2] *
        t6388);
    const float t6393 = t1577 * t1577;
    const float t6394 = t6365 + t6393;
    const float t6395 = motion->constants[24] * t6394;
    const float t6397 = motion->constants[24] * t6362;
    const float t6399 = t2237 + t6346;
    const float t6400 = motion->constants[24] * t6399;
    const float t6402 = motion->constants[55] + motion->constants[55];
    const float t6405 = t6379 + (t2237 * t2467) - t6349;
    const float t6413 = (t2250 * t2467) + (t2490 * t6395) + (t2532 * t6397) + (t2506 * t6400) +
        (t6402 * t6405) + (t6382 * t6402);
    const float t6415 = t6413 - (t2255 * t2520) - (motion->constants[54] * t6372);
    const float t6419 = (motion->constants[2] * motion->constants[25]) + (motion->constants[3] *
        t6388);
    const float t6422 = t6346 - t2237;
    const float t6423 = motion->constants[24] * t6422;
    const float t6425 = motion->constants[24] * t6369;
    const float t6427 = t6364 + t6393;
    const float t6428 = motion->constants[24] * t6427;
    const float t6430 = motion->constants[54] + motion->constants[54];
    const float t6438 = (t2255 * t2513) + (t2532 * t6425) + (t6351 * t6430) + (t6405 * t6430) -
        (t2262 * t2467) - (t2490 * t6423);
    const float t6440 = t6438 - (t2506 * t6428) - (motion->constants[55] * t6372);
    const float t6445 = motion->constants[3] * motion->constants[16];
    const float t6446 = (motion->constants[2] * motion->constants[15]) + t6445;
    const float t6449 = motion->constants[2] * motion->constants[16];
    const float t6452 = t6449 + (motion->constants[3] * motion->constants[17]);
    const float t6455 = (motion->constants[3] * (t6446 + t6446)) - (motion->constants[2] * (t6452 +
        t6452));
    const float t6458 = (motion->constants[3] * motion->constants[15]) - t6449;
    const float t6462 = t6445 - (motion->constants[2] * motion->constants[17]);
    const float t6465 = (motion->constants[3] * (t6458 - t6452)) - (motion->constants[2] * (t6446 +
        t6462));
    const float t6471 = (motion->constants[3] * (t6462 + t6462)) + (motion->constants[2] * (t6458 +
        t6458));
    const float t6478 = motion->constants[3] * motion->constants[10];
    const float t6479 = (motion->constants[2] * motion->constants[9]) + t6478;
    const float t6482 = motion->constants[2] * motion->constants[10];
    const float t6485 = t6482 + (motion->constants[3] * motion->constants[11]);
    const float t6488 = (motion->constants[3] * (t6479 + t6479)) - (motion->constants[2] * (t6485 +
        t6485));
    const float t6489 = t12 * t3871;
    const float t6491 = t1231 * t3764;
    const float t6492 = t7 * t3871;
    const float t6494 = (t12 * t2166) - t6492;
    const float t6498 = t6491 + (t1242 * t6494) - t6489 - (t7 * t2166);
    const float t6501 = t6478 - (motion->constants[2] * motion->constants[11]);
    const float t6505 = (motion->constants[3] * motion->constants[9]) - t6482;
    const float t6508 = (motion->constants[3] * (t6501 + t6501)) + (motion->constants[2] * (t6505 +
        t6505));
    const float t6510 = t7 * t3747;
    const float t6512 = t12 * t3747;
    const float t6513 = (t7 * t2161) + t6512;
    const float t6517 = t6510 - t6491 - (t12 * t2161) - (t1242 * t6513);
    const float t6523 = (motion->constants[3] * (t6505 - t6485)) - (motion->constants[2] * (t6479 +
        t6501));
    const float t6526 = t3751 - t3886;
    const float t6530 = (t7 * t3748) + (t12 * t3872);
    const float t6534 = (t12 * t3748) + (t1231 * t6526) + (t1242 * t6530) - (t7 * t3872);
    const float t6539 = motion->constants[7] + motion->constants[14];
    const float t6541 = (motion->constants[3] * motion->constants[13]) - (motion->constants[2] *
        t6539);
    const float t6543 = motion->constants[7] * t3872;
    const float t6545 = t2148 * motion->constants[12];
    const float t6546 = t12 * t6545;
    const float t6550 = (t12 * t3874) - (t7 * t3887);
    const float t6551 = motion->constants[7] * motion->constants[12];
    const float t6552 = t6550 * t6551;
    const float t6553 = (t2179 * motion->constants[12]) - t6552;
    const float t6555 = t7 * t6545;
    const float t6557 = motion->constants[41] + motion->constants[41];
    const float t6560 = t6492 + t6512;
    const float t6564 = t6489 + (t1242 * t6560) - t6510 - (t1231 * t2173);
    const float t6571 = (t6517 * t6557) + (t6557 * t6564) + (motion->constants[40] * t6534) -
        (motion->constants[12] * t6543) - t6546 - (t1231 * t6553);
    const float t6572 = t6571 - (t1242 * t6555);
    const float t6576 = (motion->constants[2] * motion->constants[13]) + (motion->constants[3] *
        t6539);
    const float t6577 = motion->constants[7] * t3748;
    const float t6581 = t2173 - t3764;
    const float t6583 = (t12 * t3752) + (t7 * t6581);
    const float t6584 = t6551 * t6583;
    const float t6585 = (t2191 * motion->constants[12]) + t6584;
    const float t6588 = motion->constants[40] + motion->constants[40];
    const float t6596 = t6555 + (t6498 * t6588) + (t6564 * t6588) + (motion->constants[41] *
        t6534) - (motion->constants[12] * t6577) - (t1231 * t6585);
    const float t6597 = t6596 - (t1242 * t6546);
    const float t6604 = sin_theta * t1302;
    const float t6608 = (motion->constants[3] * (speeds[2] + (t1310 * t6192) + (t1306 * t6178))) -
        (motion->constants[2] * ((t1306 * t6185) - t6604));
    const float t6618 = (motion->constants[3] * (t6604 + (t1310 * t6178))) - (motion->constants[2] *
        (speeds[2] + (t1306 * t6183) + (t1310 * t6185)));
    const float t6622 = (t1120 * t1306) + (t1081 * t1310);
    const float t6626 = t12 * t2268;
    const float t6628 = t7 * t2268;
    const float t6637 = t6626 + (t1242 * t6628) + (t2584 * t3872) + (t2539 * t3874) - (t1231 *
        t2349) - (t2559 * t3887);
    const float t6648 = t6628 + (t2559 * t6581) + (t2539 * t3752) - (t1231 * t3467) - (t1242 *
        t6626) - (t2584 * t3748);
    const float t6658 = (t2473 * t6204) + (t1242 * t6252) + (t2467 * t6272) + (t2506 * t6293) +
        (t2600 * t6309) + (t2612 * t6329);
    const float t6663 = t6658 + (t6344 * t6351) + (t6361 * t6372) + (t6390 * t6415) + (t3845 *
        t6455) + (t3820 * t6471);
    const float t6668 = t6663 + (t3803 * t3840) + (t6488 * t6498) + (t6541 * t6572) + (t2970 *
        t6608) + (t2991 * t6618);
    const float t6673 = t6668 + (motion->constants[37] * t5995) + (t241 * t6022) +
        (motion->constants[33] * t6648) + (motion->constants[30] * t3903) + (t286 * t3734);
    const float t6678 = t6673 - (t12 * t6189) - (t7 * t6200) - (t1231 * t6246) - (t2490 * t6283) -
        (t2535 * t6297);
    const float t6683 = t6678 - (t2606 * t6319) - (t6378 * t6382) - (t6419 * t6440) - (t3814 *
        t6465) - (t3790 * t3866);
    const float t6688 = t6683 - (t6508 * t6517) - (t6523 * t6534) - (t6576 * t6597) - (t3012 *
        t6622) - (motion->constants[32] * t6637);
    const float t6690 = t6688 - (motion->constants[31] * t3782) - (t283 * t3630);
    const float t6702 = t3936 * t6346;
    const float t6703 = t3952 * t6348;
    const float t6705 = (t2214 * t3948) + t6703 - t6702;
    const float t6711 = (t3936 * t6366) + (t3952 * t6369) - (t3948 * t6362);
    const float t6713 = t3948 * t6368;
    const float t6716 = t6702 + (t2205 * t3952) - t6713;
    const float t6725 = t6713 + (t2237 * t3936) - t6703;
    const float t6733 = (t2250 * t3936) + (t3940 * t6395) + (t3956 * t6397) + (t3944 * t6400) +
        (t6402 * t6725) + (t6402 * t6716);
    const float t6735 = t6733 - (t2255 * t3952) - (motion->constants[54] * t6711);
    const float t6749 = (t2255 * t3948) + (t3956 * t6425) + (t6430 * t6705) + (t6430 * t6725) -
        (t2262 * t3936) - (t3940 * t6423);
    const float t6751 = t6749 - (t3944 * t6428) - (motion->constants[55] * t6711);
    const float t6758 = t1906 * t3764;
    const float t6760 = t6758 + (t1908 * t6494);
    const float t6763 = t6758 + (t1908 * t6513);
    const float t6767 = (t1906 * t6526) + (t1908 * t6530);
    const float t6774 = (t1908 * t6560) - (t1906 * t2173);
    const float t6780 = (t6557 * t6774) + (motion->constants[40] * t6767) - (t1906 * t6553) -
        (t1908 * t6555) - (t6557 * t6763);
    const float t6790 = (t6588 * t6760) + (t6588 * t6774) + (motion->constants[41] * t6767) -
        (t1906 * t6585) - (t1908 * t6546);
    const float t6805 = (t1908 * t6628) + (t3872 * t3989) + (t3874 * t3963) - (t1906 * t2349) -
        (t3887 * t3975);
    const float t6815 = (t3975 * t6581) + (t3752 * t3963) - (t1906 * t3467) - (t1908 * t6626) -
        (t3748 * t3989);
    const float t6826 = (t1908 * t6252) + (t3936 * t6272) + (t3944 * t6293) + (t4005 * t6309) +
        (t4017 * t6329) + (t6344 * t6705);
    const float t6831 = t6826 + (t6361 * t6711) + (t6390 * t6735) + (t4657 * t6455) + (t4639 *
        t6471) + (t3803 * t4653);
    const float t6836 = t6831 + (t6488 * t6760) + (t6508 * t6763) + (t6541 * t6780) + (t4152 *
        t6608) + (t4166 * t6618);
    const float t6841 = t6836 + (motion->constants[37] * t6044) + (t241 * t6068) +
        (motion->constants[33] * t6815) + (motion->constants[30] * t4696) + (t286 * t4595);
    const float t6846 = t6841 - (t1906 * t6246) - (t3940 * t6283) - (t3959 * t6297) - (t4011 *
        t6319) - (t6378 * t6716);
    const float t6851 = t6846 - (t6419 * t6751) - (t4634 * t6465) - (t3790 * t4673) - (t6523 *
        t6767) - (t6576 * t6790);
    const float t6856 = t6851 - (t4180 * t6622) - (motion->constants[32] * t6805) -
        (motion->constants[31] * t4622) - (t283 * t4535) - (t1940 * t6690);
    const float t6864 = motion->constants[3] * t6348;
    const float t6865 = (motion->constants[2] * t2214) + t6864;
    const float t6869 = (motion->constants[3] * t6369) - (motion->constants[2] * t6362);
    const float t6871 = motion->constants[2] * t6368;
    const float t6873 = t6871 - (motion->constants[3] * t2205);
    const float t6876 = t6864 - t6871;
    const float t6882 = (motion->constants[3] * t2255) + (t6402 * t6876) + (motion->constants[54] *
        t6869) + (t6402 * t6873);
    const float t6890 = (t6430 * t6876) + (motion->constants[55] * t6869) - (motion->constants[2] *
        t2255) - (t6430 * t6865);
    const float t6901 = (t3872 * t4711) - (t3887 * t4709) - (t3874 * t4707);
    const float t6907 = (t4709 * t6581) - (t3748 * t4711) - (t3752 * t4707);
    const float t6919 = (motion->constants[2] * t2218) + (t6390 * t6882) + (t4764 * t6608) +
        (motion->constants[37] * t6084) + (t241 * t6100) + (motion->constants[33] * t6907);
    const float t6924 = t6919 + (motion->constants[30] * t5126) + (t286 * t5110) -
        (motion->constants[3] * t2248) - (t4706 * t6297) - (motion->constants[77] * t6309);
    const float t6929 = t6924 - (motion->constants[76] * t6329) - (t6344 * t6865) - (t6361 *
        t6869) - (t6378 * t6873) - (t6419 * t6890);
    const float t6934 = t6929 - (t4768 * t6618) - (t4776 * t6622) - (motion->constants[32] *
        t6901) - (motion->constants[31] * t5142) - (t283 * t5056);
    const float t6936 = t6934 - (t2012 * t6690) - (t2016 * t6856);
    const float t6948 = t5177 * t6346;
    const float t6949 = t5195 * t6348;
    const float t6951 = (t2214 * t5191) + t6949 - t6948;
    const float t6957 = (t5177 * t6366) + (t5195 * t6369) - (t5191 * t6362);
    const float t6959 = t5191 * t6368;
    const float t6962 = t6948 + (t2205 * t5195) - t6959;
    const float t6971 = t6959 + (t2237 * t5177) - t6949;
    const float t6979 = (t2250 * t5177) + (t5200 * t6397) + (t5187 * t6400) + (t6402 * t6971) +
        (t6402 * t6962) - (t2255 * t5195);
    const float t6981 = t6979 - (t5182 * t6395) - (motion->constants[54] * t6957);
    const float t6995 = (t2255 * t5191) + (t5182 * t6423) + (t5200 * t6425) + (t6430 * t6951) +
        (t6430 * t6971) - (t2262 * t5177);
    const float t6997 = t6995 - (t5187 * t6428) - (motion->constants[55] * t6957);
    const float t7004 = t2041 * t3764;
    const float t7006 = (t2043 * t6494) - t7004;
    const float t7009 = t7004 - (t2043 * t6513);
    const float t7013 = (t2041 * t6526) - (t2043 * t6530);
    const float t7020 = (t2041 * t2173) + (t2043 * t6560);
    const float t7027 = t6552 + (t2041 * t6553) + (t6557 * t7009) + (t6557 * t7020) - (t2043 *
        t6555) - (motion->constants[40] * t7013);
    const float t7038 = (t2041 * t6585) + (t6588 * t7006) + (t6588 * t7020) - t6584 - (t2043 *
        t6546) - (motion->constants[41] * t7013);
    const float t7053 = (t2041 * t2349) + (t2043 * t6628) + (t3872 * t5235) + (t3874 * t5207) -
        (t3887 * t5220);
    const float t7063 = (t2041 * t3467) + (t5220 * t6581) + (t3752 * t5207) - (t2043 * t6626) -
        (t3748 * t5235);
    const float t7076 = t6244 + (t2041 * t6246) + (t2043 * t6252) + (t5177 * t6272) + (t5182 *
        t6283) + (t5187 * t6293);
    const float t7081 = t7076 + (t5251 * t6309) + (t5263 * t6329) + (t6344 * t6951) + (t6361 *
        t6957) + (t6390 * t6981);
    const float t7086 = t7081 + (t5914 * t6455) + (t5890 * t6465) + (t3803 * t5910) + (t6488 *
        t7006) + (t6523 * t7013);
    const float t7091 = t7086 + (t6541 * t7027) + (t5402 * t6608) + (t5416 * t6618) +
        (motion->constants[37] * t6126) + (t241 * t6150);
    const float t7096 = t7091 + (motion->constants[33] * t7063) + (motion->constants[30] * t5954) +
        (t286 * t5848) + (t2094 * t6936) - (t5203 * t6297);
    const float t7101 = t7096 - (t5257 * t6319) - (t6378 * t6962) - (t6419 * t6997) - (t5895 *
        t6471) - (t3790 * t5931);
    const float t7106 = t7101 - (t6508 * t7009) - (t6576 * t7038) - (t5430 * t6622) -
        (motion->constants[32] * t7053) - (motion->constants[31] * t5878);
    const float t7110 = t2131 * (t7106 - (t283 * t5787) - (t2072 * t6690) - (t2088 * t6856));
    const float t7112 = (t2024 * t6936) + (t2094 * t7110);
    const float t7116 = (t1958 * t6856) - (t2016 * t7112) - (t2088 * t7110);
    const float t7122 = (t1295 * t6690) - (t1940 * t7116) - (t2012 * t7112) - (t2072 * t7110);
    const float t7127 = (t16 * t2541) + (sin_phi * t3186) - (t13 * t2561);
    const float t7135 = (t16 * t3965) - (t13 * t3977) - (sin_phi * t4277) - (t1940 * t7127);
    const float t7145 = (t16 * t4707) + (t13 * t4709) + (sin_phi * t4711) + (t2012 * t7127) +
        (t2016 * t7135);
    const float t7157 = (t16 * t5210) + (t13 * t5223) - (sin_phi * t5528) - (t2072 * t7127) -
        (t2088 * t7135) - (t2094 * t7145);
    const float t7158 = t2131 * t7157;
    const float t7160 = (t2094 * t7158) - (t2024 * t7145);
    const float t7164 = (t1958 * t7135) - (t2016 * t7160) - (t2088 * t7158);
    const float t7170 = (t1295 * t7127) - (t1940 * t7164) - (t2012 * t7160) - (t2072 * t7158);
    const float t7175 = t2175 - t1354;
    const float t7176 = t12 * t7175;
    const float t7178 = t7 * t7175;
    const float t7180 = t1301 * t1304;
    const float t7181 = t7180 - t2145;
    const float t7183 = t1354 + t1354;
    const float t7184 = t7 * t7183;
    const float t7186 = t12 * t7183;
    const float t7188 = t1324 - t7180;
    const float t7190 = (cos_delta * t7188) - (sin_delta * t7186);
    const float t7194 = (cos_delta * t7186) + (sin_delta * t7188);
    const float t7198 = (t1301 * t1362) - (speeds[0] * speeds[0]);
    const float t7213 = (motion->constants[3] * t6572) - (motion->constants[2] * t6597);
    const float t7216 = (motion->constants[3] * t6637) + (motion->constants[2] * t6648);
    const float t7221 = (motion->constants[44] * t2148) + (motion->constants[41] * t2161) + (t1231 *
        t3485) + (t3186 * t7181) + (t2747 * t7184) + (t2773 * t7190);
    const float t7226 = t7221 + (t2795 * t7194) + (t3239 * t7198) + (t999 * t3157) + (t446 *
        t3368) + (t64 * t3566);
    const float t7231 = t7226 + (t1004 * t3447) + (t651 * t3527) + (motion->constants[3] * t3903) +
        (t310 * t3734) + t7213;
    const float t7237 = t7231 + t7216 - t1806 - t2268 - t2331 - (motion->constants[40] * t2166) -
        (t2541 * t7176);
    const float t7242 = t7237 - (t2561 * t7178) - (t547 * t3440) - (t537 * t3517) -
        (motion->constants[2] * t3782) - (t308 * t3630);
    const float t7266 = (motion->constants[3] * t6780) - (motion->constants[2] * t6790);
    const float t7269 = (motion->constants[3] * t6805) + (motion->constants[2] * t6815);
    const float t7274 = (t1906 * t3485) + (t4097 * t7184) + (t4103 * t7190) + (t4109 * t7194) +
        (t4293 * t7198) + (t999 * t4264);
    const float t7279 = t7274 + (t446 * t4358) + (t64 * t4473) + (t1004 * t4421) + (t651 * t4444) +
        (motion->constants[3] * t4696);
    const float t7284 = t7279 + (t310 * t4595) + t7266 + t7269 - (t3965 * t7176) - (t3977 * t7178);
    const float t7289 = t7284 - (t4277 * t7181) - (t547 * t4415) - (t537 * t4436) -
        (motion->constants[2] * t4622) - (t308 * t4535);
    const float t7290 = t7289 - (t1940 * t7242);
    const float t7314 = (motion->constants[3] * t6901) + (motion->constants[2] * t6907);
    const float t7319 = (t4707 * t7176) + (t4741 * t7184) + (t4745 * t7190) + (t4749 * t7194) +
        (t4846 * t7198) + (t999 * t4829);
    const float t7324 = t7319 + (t446 * t4894) + (t64 * t4997) + (t1004 * t4949) + (t651 * t4968) +
        (motion->constants[3] * t5126);
    const float t7329 = t7324 + (t310 * t5110) + t7314 - (t4709 * t7178) - (t4711 * t7181) - (t547 *
        t4945);
    const float t7334 = t7329 - (t537 * t4962) - (motion->constants[2] * t5142) - (t308 * t5056) -
        (t2012 * t7242) - (t2016 * t7290);
    const float t7360 = (motion->constants[3] * t7027) - (motion->constants[2] * t7038);
    const float t7363 = (motion->constants[3] * t7053) + (motion->constants[2] * t7063);
    const float t7368 = t3485 + (t5223 * t7178) + (t5346 * t7184) + (t5352 * t7190) + (t5358 *
        t7194) + (t5544 * t7198);
    const float t7373 = t7368 + (t999 * t5517) + (t446 * t5611) + (t64 * t5724) + (t1004 * t5672) +
        (t651 * t5695);
    const float t7378 = t7373 + (motion->constants[3] * t5954) + (t310 * t5848) + (t2094 * t7334) +
        t7360 + t7363;
    const float t7383 = t7378 - (t2041 * t3485) - (t5210 * t7176) - (t5528 * t7181) - (t547 *
        t5666) - (t537 * t5687);
    const float t7388 = t2131 * (t7383 - (motion->constants[2] * t5878) - (t308 * t5787) - (t2072 *
        t7242) - (t2088 * t7290));
    const float t7390 = (t2024 * t7334) + (t2094 * t7388);
    const float t7394 = (t1958 * t7290) - (t2016 * t7390) - (t2088 * t7388);
    const float t7400 = (t1295 * t7242) - (t1940 * t7394) - (t2012 * t7390) - (t2072 * t7388);
    const float t7401 = motion->constants[7] * t2148;
    const float t7404 = (t12 * t2179) - (t7 * t2191);
    const float t7405 = motion->constants[7] * t7404;
    const float t7407 = t7401 + (t1231 * t7405);
    const float t7411 = (t1906 * t7405) - (t1940 * t7407);
    const float t7415 = (t2012 * t7407) + (t2016 * t7411);
    const float t7425 = t2131 * (t7405 - (t2041 * t7405) - (t2072 * t7407) - (t2088 * t7411) -
        (t2094 * t7415));
    const float t7427 = (t2094 * t7425) - (t2024 * t7415);
    const float t7431 = (t1958 * t7411) - (t2016 * t7427) - (t2088 * t7425);
    const float t7437 = (t1295 * t7407) - (t1940 * t7431) - (t2012 * t7427) - (t2072 * t7425);
    const float t7438 = t6498 + t6517;
    const float t7442 = t6760 - t6763 - (t1940 * t7438);
    const float t7446 = (t2012 * t7438) + (t2016 * t7442);
    const float t7455 = t2131 * (t7006 + t7009 - (t2072 * t7438) - (t2088 * t7442) - (t2094 *
        t7446));
    const float t7457 = (t2094 * t7455) - (t2024 * t7446);
    const float t7461 = (t1958 * t7442) - (t2016 * t7457) - (t2088 * t7455);
    const float t7467 = (t1295 * t7438) - (t1940 * t7461) - (t2012 * t7457) - (t2072 * t7455);
    const float t7468 = t1310 * t1315;
    const float t7470 = t1306 * t1315;
    const float t7475 = (t7 * t7468) + (t12 * t7470);
    const float t7479 = (t12 * t7468) + (t1242 * t7475) - (t7 * t7470) - (t1231 * t2175);
    const float t7485 = (t1908 * t7475) - (t1906 * t2175) - (t1940 * t7479);
    const float t7489 = (t2012 * t7479) + (t2016 * t7485);
    const float t7500 = (t2041 * t2175) + (t2043 * t7475) - t2175 - (t2072 * t7479) - (t2088 *
        t7485) - (t2094 * t7489);
    const float t7501 = t2131 * t7500;
    const float t7503 = (t2094 * t7501) - (t2024 * t7489);
    const float t7507 = (t1958 * t7485) - (t2016 * t7503) - (t2088 * t7501);
    const float t7513 = (t1295 * t7479) - (t1940 * t7507) - (t2012 * t7503) - (t2072 * t7501);
    const float t7516 = (motion->constants[2] * t6572) + (motion->constants[3] * t6597);
    const float t7522 = (motion->constants[2] * t6780) + (motion->constants[3] * t6790) - (t1940 *
        t7516);
    const float t7526 = (t2012 * t7516) + (t2016 * t7522);
    const float t7537 = t2131 * ((motion->constants[2] * t7027) + (motion->constants[3] * t7038) -
        (t2072 * t7516) - (t2088 * t7522) - (t2094 * t7526));
    const float t7539 = (t2094 * t7537) - (t2024 * t7526);
    const float t7543 = (t1958 * t7522) - (t2016 * t7539) - (t2088 * t7537);
    const float t7549 = (t1295 * t7516) - (t1940 * t7543) - (t2012 * t7539) - (t2072 * t7537);
    const float t7552 = t7266 - (t1940 * t7213);
    const float t7556 = (t2012 * t7213) + (t2016 * t7552);
    const float t7564 = t2131 * (t7360 - (t2072 * t7213) - (t2088 * t7552) - (t2094 * t7556));
    const float t7566 = (t2094 * t7564) - (t2024 * t7556);
    const float t7570 = (t1958 * t7552) - (t2016 * t7566) - (t2088 * t7564);
    const float t7576 = (t1295 * t7213) - (t1940 * t7570) - (t2012 * t7566) - (t2072 * t7564);
    const float t7579 = t2148 * t6576;
    const float t7581 = t2148 * t6541;
    const float t7589 = motion->constants[7] * (t7404 + (t6550 * t6576) - (t6541 * t6583));
    const float t7591 = (t2179 * t6576) + (t2191 * t6541) - t7589;
    const float t7595 = (t7 * t7579) + (t12 * t7581);
    const float t7597 = t6541 * t6541;
    const float t7599 = t6576 * t6576;
    const float t7601 = t7597 + t7599;
    const float t7603 = t6541 * t6576;
    const float t7609 = t7401 + (t7 * t7581) + (t6498 * t7597) + (t6517 * t7599) + (t6564 * t7601) +
        (t6534 * t7603);
    const float t7614 = t7609 - (t6543 * t6576) - (t6541 * t6577) - (t12 * t7579) - (t1231 *
        t7591) - (t1242 * t7595);
    const float t7627 = (t6760 * t7597) + (t6774 * t7601) + (t6767 * t7603) - (t1906 * t7591) -
        (t1908 * t7595) - (t6763 * t7599);
    const float t7628 = t7627 - (t1940 * t7614);
    const float t7632 = (t2012 * t7614) + (t2016 * t7628);
    const float t7647 = t7589 + (t2041 * t7591) + (t7006 * t7597) + (t7009 * t7599) + (t7020 *
        t7601) - (t2043 * t7595);
    const float t7652 = t2131 * (t7647 - (t7013 * t7603) - (t2072 * t7614) - (t2088 * t7628) -
        (t2094 * t7632));
    const float t7654 = (t2094 * t7652) - (t2024 * t7632);
    const float t7658 = (t1958 * t7628) - (t2016 * t7654) - (t2088 * t7652);
    const float t7664 = (t1295 * t7614) - (t1940 * t7658) - (t2012 * t7654) - (t2072 * t7652);
    const float t7667 = motion->constants[35] * t6534;
    const float t7669 = (motion->constants[36] * t6498) + (motion->constants[34] * t6517) - t7667;
    const float t7673 = motion->constants[35] * t6767;
    const float t7677 = (motion->constants[36] * t6760) - (motion->constants[34] * t6763) - t7673 -
        (t1940 * t7669);
    const float t7681 = (t2012 * t7669) + (t2016 * t7677);
    const float t7685 = motion->constants[35] * t7013;
    const float t7693 = (motion->constants[36] * t7006) + (motion->constants[34] * t7009) + t7685 -
        (t2072 * t7669) - (t2088 * t7677) - (t2094 * t7681);
    const float t7694 = t2131 * t7693;
    const float t7696 = (t2094 * t7694) - (t2024 * t7681);
    const float t7700 = (t1958 * t7677) - (t2016 * t7696) - (t2088 * t7694);
    const float t7706 = (t1295 * t7669) - (t1940 * t7700) - (t2012 * t7696) - (t2072 * t7694);
    const float t7709 = t6774 - (t1940 * t6564);
    const float t7713 = (t2012 * t6564) + (t2016 * t7709);
    const float t7721 = t2131 * (t7020 - (t2072 * t6564) - (t2088 * t7709) - (t2094 * t7713));
    const float t7723 = (t2094 * t7721) - (t2024 * t7713);
    const float t7727 = (t1958 * t7709) - (t2016 * t7723) - (t2088 * t7721);
    const float t7733 = (t1295 * t6564) - (t1940 * t7727) - (t2012 * t7723) - (t2072 * t7721);
    const float t7737 = t7667 + (motion->constants[34] * t6498) + (motion->constants[36] * t6517);
    const float t7744 = t7673 + (motion->constants[34] * t6760) - (motion->constants[36] * t6763) -
        (t1940 * t7737);
    const float t7748 = (t2012 * t7737) + (t2016 * t7744);
    const float t7759 = (motion->constants[34] * t7006) + (motion->constants[36] * t7009) - t7685 -
        (t2072 * t7737) - (t2088 * t7744) - (t2094 * t7748);
    const float t7760 = t2131 * t7759;
    const float t7762 = (t2094 * t7760) - (t2024 * t7748);
    const float t7766 = (t1958 * t7744) - (t2016 * t7762) - (t2088 * t7760);
    const float t7772 = (t1295 * t7737) - (t1940 * t7766) - (t2012 * t7762) - (t2072 * t7760);
    const float t7773 = motion->constants[35] + motion->constants[35];
    const float t7776 = motion->constants[34] - motion->constants[36];
    const float t7779 = (t6498 * t7773) - (t6517 * t7773) - (t6534 * t7776);
    const float t7787 = (t6760 * t7773) + (t6763 * t7773) - (t6767 * t7776) - (t1940 * t7779);
    const float t7791 = (t2012 * t7779) + (t2016 * t7787);
    const float t7803 = (t7006 * t7773) + (t7013 * t7776) - (t7009 * t7773) - (t2072 * t7779) -
        (t2088 * t7787) - (t2094 * t7791);
    const float t7804 = t2131 * t7803;
    const float t7806 = (t2094 * t7804) - (t2024 * t7791);
    const float t7810 = (t1958 * t7787) - (t2016 * t7806) - (t2088 * t7804);
    const float t7816 = (t1295 * t7779) - (t1940 * t7810) - (t2012 * t7806) - (t2072 * t7804);
    const float t7819 = t4675 - (t1940 * t3868);
    const float t7823 = (t2012 * t3868) + (t2016 * t7819);
    const float t7831 = t2131 * (t5933 - (t2072 * t3868) - (t2088 * t7819) - (t2094 * t7823));
    const float t7833 = (t2094 * t7831) - (t2024 * t7823);
    const float t7837 = (t1958 * t7819) - (t2016 * t7833) - (t2088 * t7831);
    const float t7843 = (t1295 * t3868) - (t1940 * t7837) - (t2012 * t7833) - (t2072 * t7831);
    const float t7846 = (motion->constants[3] * t3840) - (motion->constants[2] * t3866);
    const float t7852 = (motion->constants[3] * t4653) - (motion->constants[2] * t4673) - (t1940 *
        t7846);
    const float t7856 = (t2012 * t7846) + (t2016 * t7852);
    const float t7867 = t2131 * ((motion->constants[3] * t5910) - (motion->constants[2] * t5931) -
        (t2072 * t7846) - (t2088 * t7852) - (t2094 * t7856));
    const float t7869 = (t2094 * t7867) - (t2024 * t7856);
    const float t7873 = (t1958 * t7852) - (t2016 * t7869) - (t2088 * t7867);
    const float t7879 = (t1295 * t7846) - (t1940 * t7873) - (t2012 * t7869) - (t2072 * t7867);
    const float t7881 = t2299 * t2637;
    const float t7882 = (motion->constants[30] * t2299) + t7881;
    const float t7887 = (t1231 * t7882) + (t2280 * t2433) + (t2295 * t2450);
    const float t7888 = t3803 * t3803;
    const float t7890 = t3790 * t3790;
    const float t7891 = t7888 + t7890;
    const float t7893 = t3790 * t3803;
    const float t7902 = t7887 + (t3845 * t7888) + (t3799 * t7891) + (t3814 * t7893) + (t3790 *
        t3836) + (t3803 * t3862);
    const float t7903 = t7902 - (t3820 * t7890);
    const float t7909 = (t1906 * t7882) + (t2280 * t3924) + (t2295 * t3928);
    const float t7921 = t7909 + (t4657 * t7888) + (t4628 * t7891) + (t4634 * t7893) + (t3790 *
        t4649) + (t3803 * t4669);
    const float t7923 = t7921 - (t4639 * t7890) - (t1940 * t7903);
    const float t7927 = (t2012 * t7903) + (t2016 * t7923);
    const float t7934 = t7881 + (t2280 * t5164) + (t2295 * t5169) - (t2041 * t7882);
    const float t7948 = t7934 + (t5914 * t7888) + (t5884 * t7891) + (t5895 * t7890) + (t3790 *
        t5906) + (t3803 * t5927);
    const float t7953 = t2131 * (t7948 - (t5890 * t7893) - (t2072 * t7903) - (t2088 * t7923) -
        (t2094 * t7927));
    const float t7955 = (t2094 * t7953) - (t2024 * t7927);
    const float t7959 = (t1958 * t7923) - (t2016 * t7955) - (t2088 * t7953);
    const float t7965 = (t1295 * t7903) - (t1940 * t7959) - (t2012 * t7955) - (t2072 * t7953);
    const float t7967 = motion->constants[35] * t3814;
    const float t7970 = (motion->constants[36] * t3845) - t7967 - (motion->constants[34] * t3820);
    const float t7973 = motion->constants[35] * t4634;
    const float t7978 = (motion->constants[36] * t4657) - t7973 - (motion->constants[34] * t4639) -
        (t1940 * t7970);
    const float t7982 = (t2012 * t7970) + (t2016 * t7978);
    const float t7985 = motion->constants[35] * t5890;
    const float t7994 = (motion->constants[36] * t5914) + t7985 + (motion->constants[34] * t5895) -
        (t2072 * t7970) - (t2088 * t7978) - (t2094 * t7982);
    const float t7995 = t2131 * t7994;
    const float t7997 = (t2094 * t7995) - (t2024 * t7982);
    const float t8001 = (t1958 * t7978) - (t2016 * t7997) - (t2088 * t7995);
    const float t8007 = (t1295 * t7970) - (t1940 * t8001) - (t2012 * t7997) - (t2072 * t7995);
    const float t8010 = t4628 - (t1940 * t3799);
    const float t8014 = (t2012 * t3799) + (t2016 * t8010);
    const float t8022 = t2131 * (t5884 - (t2072 * t3799) - (t2088 * t8010) - (t2094 * t8014));
    const float t8024 = (t2094 * t8022) - (t2024 * t8014);
    const float t8028 = (t1958 * t8010) - (t2016 * t8024) - (t2088 * t8022);
    const float t8034 = (t1295 * t3799) - (t1940 * t8028) - (t2012 * t8024) - (t2072 * t8022);
    const float t8038 = t7967 + (motion->constants[34] * t3845) - (motion->constants[36] * t3820);
    const float t8045 = t7973 + (motion->constants[34] * t4657) - (motion->constants[36] * t4639) -
        (t1940 * t8038);
    const float t8049 = (t2012 * t8038) + (t2016 * t8045);
    const float t8060 = (motion->constants[34] * t5914) + (motion->constants[36] * t5895) - t7985 -
        (t2072 * t8038) - (t2088 * t8045) - (t2094 * t8049);
    const float t8061 = t2131 * t8060;
    const float t8063 = (t2094 * t8061) - (t2024 * t8049);
    const float t8067 = (t1958 * t8045) - (t2016 * t8063) - (t2088 * t8061);
    const float t8073 = (t1295 * t8038) - (t1940 * t8067) - (t2012 * t8063) - (t2072 * t8061);
    const float t8078 = (t3845 * t7773) + (t3820 * t7773) - (t3814 * t7776);
    const float t8086 = (t4657 * t7773) + (t4639 * t7773) - (t4634 * t7776) - (t1940 * t8078);
    const float t8090 = (t2012 * t8078) + (t2016 * t8086);
    const float t8102 = (t5914 * t7773) + (t5890 * t7776) - (t5895 * t7773) - (t2072 * t8078) -
        (t2088 * t8086) - (t2094 * t8090);
    const float t8103 = t2131 * t8102;
    const float t8105 = (t2094 * t8103) - (t2024 * t8090);
    const float t8109 = (t1958 * t8086) - (t2016 * t8105) - (t2088 * t8103);
    const float t8115 = (t1295 * t8078) - (t1940 * t8109) - (t2012 * t8105) - (t2072 * t8103);
    const float t8118 = (t1775 * t2383) + (t1030 * t3159);
    const float t8124 = (t1379 * t1441) - (t30 * t1434) - (t1407 * t1437);
    const float t8132 = (t30 * t1396) + (t1370 * t1407) + (t1379 * t1410) - (t27 * t1400);
    const float t8138 = (t27 * t1434) - (t1410 * t1437) - (t1370 * t1441);
    const float t8155 = (t1283 * t8118) + (t2747 * t8124) + (t2773 * t8132) + (t2795 * t8138) +
        (t1038 * t3163) + (t664 * t3374);
    const float t8160 = t8155 + (t319 * t3594) + (motion->constants[2] * t6022) + (t329 * t3734) -
        (t1031 * t3155) - (t1036 * t3157);
    const float t8164 = t8160 - (t1044 * t3436) - (t317 * t3578) - (motion->constants[3] * t5995) -
        (t327 * t3630);
    const float t8187 = (t1030 * t2313) + (t1930 * t8118) + (t4097 * t8124) + (t4103 * t8132) +
        (t4109 * t8138) + (t1038 * t4270);
    const float t8192 = t8187 + (t664 * t4365) + (t319 * t4500) + (motion->constants[2] * t6068) +
        (t329 * t4595) - (t1031 * t4262);
    const float t8197 = t8192 - (t1036 * t4264) - (t1044 * t4411) - (t317 * t4485) -
        (motion->constants[3] * t6044) - (t327 * t4535);
    const float t8198 = t8197 - (t1940 * t8164);
    const float t8220 = (t4741 * t8124) + (t4745 * t8132) + (t4749 * t8138) + (t1038 * t4831) +
        (t664 * t4900) + (t319 * t5024);
    const float t8225 = t8220 + (motion->constants[2] * t6100) + (t329 * t5110) - (t1031 * t4828) -
        (t1036 * t4829) - (t1044 * t4942);
    const float t8230 = t8225 - (t317 * t5009) - (motion->constants[3] * t6084) - (t327 * t5056) -
        (t2012 * t8164) - (t2016 * t8198);
    const float t8254 = (t2065 * t8118) + (t5346 * t8124) + (t5352 * t8132) + (t5358 * t8138) +
        (t1038 * t5521) + (t664 * t5617);
    const float t8259 = t8254 + (t319 * t5751) + (motion->constants[2] * t6150) + (t329 * t5848) +
        (t2094 * t8230) - (t1031 * t5514);
    const float t8264 = t8259 - (t1036 * t5517) - (t1044 * t5662) - (t317 * t5736) -
        (motion->constants[3] * t6126) - (t327 * t5787);
    const float t8267 = t2131 * (t8264 - (t2072 * t8164) - (t2088 * t8198));
    const float t8269 = (t2024 * t8230) + (t2094 * t8267);
    const float t8273 = (t1958 * t8198) - (t2016 * t8269) - (t2088 * t8267);
    const float t8279 = (t1295 * t8164) - (t1940 * t8273) - (t2012 * t8269) - (t2072 * t8267);
    const float t8280 = motion->constants[37] * motion->constants[37];
    const float t8282 = motion->constants[38] * motion->constants[38];
    const float t8283 = t8280 + t8282;
    const float t8285 = motion->constants[37] * motion->constants[38];
    const float t8294 = t7887 + (t3845 * t8280) + (t3799 * t8283) + (t3814 * t8285) +
        (motion->constants[38] * t3836) + (motion->constants[37] * t3862);
    const float t8295 = t8294 - (t3820 * t8282);
    const float t8308 = t7909 + (t4657 * t8280) + (t4628 * t8283) + (t4634 * t8285) +
        (motion->constants[38] * t4649) + (motion->constants[37] * t4669);
    const float t8310 = t8308 - (t4639 * t8282) - (t1940 * t8295);
    const float t8314 = (t2012 * t8295) + (t2016 * t8310);
    const float t8329 = t7934 + (t5914 * t8280) + (t5884 * t8283) + (t5895 * t8282) +
        (motion->constants[38] * t5906) + (motion->constants[37] * t5927);
    const float t8334 = t2131 * (t8329 - (t5890 * t8285) - (t2072 * t8295) - (t2088 * t8310) -
        (t2094 * t8314));
    const float t8336 = (t2094 * t8334) - (t2024 * t8314);
    const float t8340 = (t1958 * t8310) - (t2016 * t8336) - (t2088 * t8334);
    const float t8346 = (t1295 * t8295) - (t1940 * t8340) - (t2012 * t8336) - (t2072 * t8334);
    const float t8347 = t3845 - t3820;
    const float t8351 = t4657 - t4639 - (t1940 * t8347);
    const float t8355 = (t2012 * t8347) + (t2016 * t8351);
    const float t8364 = t2131 * (t5895 + t5914 - (t2072 * t8347) - (t2088 * t8351) - (t2094 *
        t8355));
    const float t8366 = (t2094 * t8364) - (t2024 * t8355);
    const float t8370 = (t1958 * t8351) - (t2016 * t8366) - (t2088 * t8364);
    const float t8376 = (t1295 * t8347) - (t1940 * t8370) - (t2012 * t8366) - (t2072 * t8364);
    const float t8377 = t1379 * t1437;
    const float t8379 = t1370 * t1437;
    const float t8383 = (t2406 * t8377) + (t2414 * t8379) - (t1283 * t2312);
    const float t8391 = (t3916 * t8377) + (t3920 * t8379) - (t1930 * t2312) - (t1940 * t8383);
    const float t8395 = (t2012 * t8383) + (t2016 * t8391);
    const float t8407 = (t5155 * t8377) - (t5159 * t8379) - (t2065 * t2312) - (t2072 * t8383) -
        (t2088 * t8391) - (t2094 * t8395);
    const float t8408 = t2131 * t8407;
    const float t8410 = (t2094 * t8408) - (t2024 * t8395);
    const float t8414 = (t1958 * t8391) - (t2016 * t8410) - (t2088 * t8408);
    const float t8420 = (t1295 * t8383) - (t1940 * t8414) - (t2012 * t8410) - (t2072 * t8408);
    const float t8423 = (motion->constants[2] * t6440) - (motion->constants[3] * t6415);
    const float t8424 = t7216 + t8423;
    const float t8428 = (motion->constants[2] * t6751) - (motion->constants[3] * t6735);
    const float t8431 = t7269 + t8428 - (t1940 * t8424);
    const float t8435 = (motion->constants[2] * t6890) - (motion->constants[3] * t6882);
    const float t8440 = t7314 + t8435 - (t2012 * t8424) - (t2016 * t8431);
    const float t8444 = (motion->constants[2] * t6997) - (motion->constants[3] * t6981);
    const float t8452 = t2131 * (t7363 + t8444 + (t2094 * t8440) - (t2072 * t8424) - (t2088 *
        t8431));
    const float t8454 = (t2024 * t8440) + (t2094 * t8452);
    const float t8458 = (t1958 * t8431) - (t2016 * t8454) - (t2088 * t8452);
    const float t8464 = (t1295 * t8424) - (t1940 * t8458) - (t2012 * t8454) - (t2072 * t8452);
    const float t8465 = t2196 * t6390;
    const float t8469 = (t2224 * t6419) - (t2230 * t6390);
    const float t8471 = t2196 * t6419;
    const float t8476 = t2230 + (t6390 * t6422) - (t6394 * t6419);
    const float t8481 = t2196 + (t6362 * t6419) + (t6369 * t6390);
    const float t8486 = t2224 + (t6399 * t6419) - (t6390 * t6427);
    const float t8488 = t6390 * t6390;
    const float t8490 = t6419 * t6419;
    const float t8491 = t8488 + t8490;
    const float t8493 = t6390 * t6419;
    const float t8500 = (t2513 * t8465) + (t2467 * t8469) + (t2532 * t8481) + (t2506 * t8486) +
        (t6351 * t8488) + (t6405 * t8491);
    const float t8504 = t8500 + (t6382 * t8490) - (t2520 * t8471) - (t2490 * t8476) - (t6372 *
        t8493);
    const float t8521 = (t3948 * t8465) + (t3936 * t8469) + (t3956 * t8481) + (t3944 * t8486) +
        (t6705 * t8488) + (t6725 * t8491);
    const float t8526 = t8521 + (t6716 * t8490) - (t3952 * t8471) - (t3940 * t8476) - (t6711 *
        t8493) - (t1940 * t8504);
    const float t8540 = (motion->constants[3] * t8471) + (t6876 * t8491) + (t6869 * t8493) +
        (t6873 * t8490) - (motion->constants[2] * t8465) - (t6865 * t8488);
    const float t8542 = t8540 - (t2012 * t8504) - (t2016 * t8526);
    const float t8561 = (t5191 * t8465) + (t5177 * t8469) + (t5182 * t8476) + (t5200 * t8481) +
        (t5187 * t8486) + (t6951 * t8488);
    const float t8566 = t8561 + (t6971 * t8491) + (t6962 * t8490) + (t2094 * t8542) - (t5195 *
        t8471) - (t6957 * t8493);
    const float t8569 = t2131 * (t8566 - (t2072 * t8504) - (t2088 * t8526));
    const float t8571 = (t2024 * t8542) + (t2094 * t8569);
    const float t8575 = (t1958 * t8526) - (t2016 * t8571) - (t2088 * t8569);
    const float t8581 = (t1295 * t8504) - (t1940 * t8575) - (t2012 * t8571) - (t2072 * t8569);
    const float t8584 = (motion->constants[2] * t6415) + (motion->constants[3] * t6440);
    const float t8590 = (motion->constants[2] * t6735) + (motion->constants[3] * t6751) - (t1940 *
        t8584);
    const float t8598 = (motion->constants[2] * t6882) + (motion->constants[3] * t6890) - (t2012 *
        t8584) - (t2016 * t8590);
    const float t8609 = t2131 * ((motion->constants[2] * t6981) + (motion->constants[3] * t6997) +
        (t2094 * t8598) - (t2072 * t8584) - (t2088 * t8590));
    const float t8611 = (t2024 * t8598) + (t2094 * t8609);
    const float t8615 = (t1958 * t8590) - (t2016 * t8611) - (t2088 * t8609);
    const float t8621 = (t1295 * t8584) - (t1940 * t8615) - (t2012 * t8611) - (t2072 * t8609);
    const float t8624 = (t1940 * t8423) - t8428;
    const float t8629 = (t2012 * t8423) - t8435 - (t2016 * t8624);
    const float t8637 = t2131 * ((t2072 * t8423) + (t2094 * t8629) - t8444 - (t2088 * t8624));
    const float t8639 = (t2024 * t8629) + (t2094 * t8637);
    const float t8643 = (t1958 * t8624) - (t2016 * t8639) - (t2088 * t8637);
    const float t8651 = motion->constants[35] * t6372;
    const float t8654 = (motion->constants[36] * t6351) + t8651 + (motion->constants[34] * t6382);
    const float t8657 = motion->constants[35] * t6711;
    const float t8662 = (motion->constants[36] * t6705) + t8657 + (motion->constants[34] * t6716) -
        (t1940 * t8654);
    const float t8665 = motion->constants[35] * t6869;
    const float t8672 = (motion->constants[34] * t6873) - (motion->constants[36] * t6865) - t8665 -
        (t2012 * t8654) - (t2016 * t8662);
    const float t8675 = motion->constants[35] * t6957;
    const float t8684 = (motion->constants[36] * t6951) + t8675 + (motion->constants[34] * t6962) +
        (t2094 * t8672) - (t2072 * t8654) - (t2088 * t8662);
    const float t8685 = t2131 * t8684;
    const float t8687 = (t2024 * t8672) + (t2094 * t8685);
    const float t8691 = (t1958 * t8662) - (t2016 * t8687) - (t2088 * t8685);
    const float t8697 = (t1295 * t8654) - (t1940 * t8691) - (t2012 * t8687) - (t2072 * t8685);
    const float t8700 = t6725 - (t1940 * t6405);
    const float t8705 = t6876 - (t2012 * t6405) - (t2016 * t8700);
    const float t8713 = t2131 * (t6971 + (t2094 * t8705) - (t2072 * t6405) - (t2088 * t8700));
    const float t8715 = (t2024 * t8705) + (t2094 * t8713);
    const float t8719 = (t1958 * t8700) - (t2016 * t8715) - (t2088 * t8713);
    const float t8725 = (t1295 * t6405) - (t1940 * t8719) - (t2012 * t8715) - (t2072 * t8713);
    const float t8729 = (motion->constants[34] * t6351) + (motion->constants[36] * t6382) - t8651;
    const float t8736 = (motion->constants[34] * t6705) + (motion->constants[36] * t6716) - t8657 -
        (t1940 * t8729);
    const float t8745 = t8665 + (motion->constants[36] * t6873) - (motion->constants[34] * t6865) -
        (t2012 * t8729) - (t2016 * t8736);
    const float t8756 = (motion->constants[34] * t6951) + (motion->constants[36] * t6962) + (t2094 *
        t8745) - t8675 - (t2072 * t8729) - (t2088 * t8736);
    const float t8757 = t2131 * t8756;
    const float t8759 = (t2024 * t8745) + (t2094 * t8757);
    const float t8763 = (t1958 * t8736) - (t2016 * t8759) - (t2088 * t8757);
    const float t8769 = (t1295 * t8729) - (t1940 * t8763) - (t2012 * t8759) - (t2072 * t8757);
    const float t8774 = (t6351 * t7773) + (t6372 * t7776) - (t6382 * t7773);
    const float t8782 = (t6705 * t7773) + (t6711 * t7776) - (t6716 * t7773) - (t1940 * t8774);
    const float t8792 = (t6865 * t7773) + (t6869 * t7776) + (t6873 * t7773) + (t2012 * t8774) +
        (t2016 * t8782);
    const float t8804 = (t6951 * t7773) + (t6957 * t7776) - (t6962 * t7773) - (t2072 * t8774) -
        (t2088 * t8782) - (t2094 * t8792);
    const float t8805 = t2131 * t8804;
    const float t8807 = (t2094 * t8805) - (t2024 * t8792);
    const float t8811 = (t1958 * t8782) - (t2016 * t8807) - (t2088 * t8805);
    const float t8817 = (t1295 * t8774) - (t1940 * t8811) - (t2012 * t8807) - (t2072 * t8805);
    const float t8819 = t2094 * t2131;
    const float t8820 = positions[6] * t8819;
    const float t8822 = (positions[6] * t2024) + (t2094 * t8820);
    const float t8825 = (t2016 * t8822) + (t2088 * t8820);
    const float t8830 = (t2012 * t8822) + (t2072 * t8820) - (t1940 * t8825);
    const float t8832 = speeds[2] * t8819;
    const float t8834 = (speeds[2] * t2024) + (t2094 * t8832);
    const float t8837 = (t2016 * t8834) + (t2088 * t8832);
    const float t8842 = (t2012 * t8834) + (t2072 * t8832) - (t1940 * t8837);
    const float t8843 = -((t1295 * t8423) + (t1940 * t8643) + (t2012 * t8639) + (t2072 * t8637));
    const float t8844 = -t8822;
    const float t8845 = -t8834;
    const float t8846 = -t8820;
    const float t8847 = -t8832;
    by_parameters[0][0] = t212;
    by_parameters[0][1] = t233;
    by_parameters[0][2] = t292;
    by_parameters[0][3] = 0.0F;
    by_parameters[0][4] = t316;
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
    by_parameters[0][22] = t335;
    by_parameters[0][23] = 0.0F;
    by_parameters[0][24] = 0.0F;
    by_parameters[0][25] = 0.0F;
    by_parameters[0][26] = 0.0F;
    by_parameters[0][27] = 0.0F;
    by_parameters[0][28] = 0.0F;
    by_parameters[0][29] = 0.0F;
    by_parameters[0][30] = 0.0F;
    by_parameters[0][31] = 0.0F;
    by_parameters[0][32] = 0.0F;
    by_parameters[0][33] = 0.0F;
    by_parameters[0][34] = 0.0F;
    by_parameters[0][35] = 0.0F;
    by_parameters[1][0] = t392;
    by_parameters[1][1] = t405;
    by_parameters[1][2] = t416;
    by_parameters[1][3] = 0.0F;
    by_parameters[1][4] = t427;
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
    by_parameters[1][22] = t438;
    by_parameters[1][23] = 0.0F;
    by_parameters[1][24] = 0.0F;
    by_parameters[1][25] = 0.0F;
    by_parameters[1][26] = 0.0F;
    by_parameters[1][27] = 0.0F;
    by_parameters[1][28] = 0.0F;
    by_parameters[1][29] = 0.0F;
    by_parameters[1][30] = 0.0F;
    by_parameters[1][31] = 0.0F;
    by_parameters[1][32] = 0.0F;
    by_parameters[1][33] = 0.0F;
    by_parameters[1][34] = 0.0F;
    by_parameters[1][35] = 0.0F;
    by_parameters[2][0] = t620;
    by_parameters[2][1] = t636;
    by_parameters[2][2] = t647;
    by_parameters[2][3] = 0.0F;
    by_parameters[2][4] = t663;
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
    by_parameters[2][22] = t677;
    by_parameters[2][23] = 0.0F;
    by_parameters[2][24] = 0.0F;
    by_parameters[2][25] = 0.0F;
    by_parameters[2][26] = 0.0F;
    by_parameters[2][27] = 0.0F;
    by_parameters[2][28] = 0.0F;
    by_parameters[2][29] = 0.0F;
    by_parameters[2][30] = 0.0F;
    by_parameters[2][31] = 0.0F;
    by_parameters[2][32] = 0.0F;
    by_parameters[2][33] = 0.0F;
    by_parameters[2][34] = 0.0F;
    by_parameters[2][35] = 0.0F;
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
    by_parameters[3][28] = 0.0F;
    by_parameters[3][29] = 0.0F;
    by_parameters[3][30] = 0.0F;
    by_parameters[3][31] = 0.0F;
    by_parameters[3][32] = 0.0F;
    by_parameters[3][33] = 0.0F;
    by_parameters[3][34] = 0.0F;
    by_parameters[3][35] = 0.0F;
    by_parameters[4][0] = t730;
    by_parameters[4][1] = t743;
    by_parameters[4][2] = t754;
    by_parameters[4][3] = 0.0F;
    by_parameters[4][4] = t763;
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
    by_parameters[4][22] = t774;
    by_parameters[4][23] = 0.0F;
    by_parameters[4][24] = 0.0F;
    by_parameters[4][25] = 0.0F;
    by_parameters[4][26] = 0.0F;
    by_parameters[4][27] = 0.0F;
    by_parameters[4][28] = 0.0F;
    by_parameters[4][29] = 0.0F;
    by_parameters[4][30] = 0.0F;
    by_parameters[4][31] = 0.0F;
    by_parameters[4][32] = 0.0F;
    by_parameters[4][33] = 0.0F;
    by_parameters[4][34] = 0.0F;
    by_parameters[4][35] = 0.0F;
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
    by_parameters[5][28] = 0.0F;
    by_parameters[5][29] = 0.0F;
    by_parameters[5][30] = 0.0F;
    by_parameters[5][31] = 0.0F;
    by_parameters[5][32] = 0.0F;
    by_parameters[5][33] = 0.0F;
    by_parameters[5][34] = 0.0F;
    by_parameters[5][35] = 0.0F;
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
    by_parameters[6][28] = 0.0F;
    by_parameters[6][29] = 0.0F;
    by_parameters[6][30] = 0.0F;
    by_parameters[6][31] = 0.0F;
    by_parameters[6][32] = 0.0F;
    by_parameters[6][33] = 0.0F;
    by_parameters[6][34] = 0.0F;
    by_parameters[6][35] = 0.0F;
    by_parameters[7][0] = 0.0F;
    by_parameters[7][1] = 0.0F;
    by_parameters[7][2] = 0.0F;
    by_parameters[7][3] = 0.0F;
    by_parameters[7][4] = 0.0F;
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
    by_parameters[7][22] = 0.0F;
    by_parameters[7][23] = 0.0F;
    by_parameters[7][24] = 0.0F;
    by_parameters[7][25] = 0.0F;
    by_parameters[7][26] = 0.0F;
    by_parameters[7][27] = 0.0F;
    by_parameters[7][28] = 0.0F;
    by_parameters[7][29] = 0.0F;
    by_parameters[7][30] = 0.0F;
    by_parameters[7][31] = 0.0F;
    by_parameters[7][32] = 0.0F;
    by_parameters[7][33] = 0.0F;
    by_parameters[7][34] = 0.0F;
    by_parameters[7][35] = 0.0F;
    by_parameters[8][0] = t969;
    by_parameters[8][1] = t987;
    by_parameters[8][2] = t998;
    by_parameters[8][3] = 0.0F;
    by_parameters[8][4] = t1021;
    by_parameters[8][5] = 0.0F;
    by_parameters[8][6] = 0.0F;
    by_parameters[8][7] = 0.0F;
    by_parameters[8][8] = 0.0F;
    by_parameters[8][9] = 0.0F;
    by_parameters[8][10] = 0.0F;
    by_parameters[8][11] = 0.0F;
    by_parameters[8][12] = 0.0F;
    by_parameters[8][13] = 0.0F;
    by_parameters[8][14] = 0.0F;
    by_parameters[8][15] = 0.0F;
    by_parameters[8][16] = 0.0F;
    by_parameters[8][17] = 0.0F;
    by_parameters[8][18] = 0.0F;
    by_parameters[8][19] = 0.0F;
    by_parameters[8][20] = 0.0F;
    by_parameters[8][21] = 0.0F;
    by_parameters[8][22] = t1062;
    by_parameters[8][23] = 0.0F;
    by_parameters[8][24] = 0.0F;
    by_parameters[8][25] = 0.0F;
    by_parameters[8][26] = 0.0F;
    by_parameters[8][27] = 0.0F;
    by_parameters[8][28] = 0.0F;
    by_parameters[8][29] = 0.0F;
    by_parameters[8][30] = 0.0F;
    by_parameters[8][31] = 0.0F;
    by_parameters[8][32] = 0.0F;
    by_parameters[8][33] = 0.0F;
    by_parameters[8][34] = 0.0F;
    by_parameters[8][35] = 0.0F;
    by_parameters[9][0] = t5975;
    by_parameters[9][1] = t6176;
    by_parameters[9][2] = t7122;
    by_parameters[9][3] = t7170;
    by_parameters[9][4] = t7400;
    by_parameters[9][5] = t7437;
    by_parameters[9][6] = t7467;
    by_parameters[9][7] = t7513;
    by_parameters[9][8] = t7549;
    by_parameters[9][9] = t7576;
    by_parameters[9][10] = t7664;
    by_parameters[9][11] = t7706;
    by_parameters[9][12] = t7733;
    by_parameters[9][13] = t7772;
    by_parameters[9][14] = t7816;
    by_parameters[9][15] = t7843;
    by_parameters[9][16] = t7879;
    by_parameters[9][17] = t7965;
    by_parameters[9][18] = t8007;
    by_parameters[9][19] = t8034;
    by_parameters[9][20] = t8073;
    by_parameters[9][21] = t8115;
    by_parameters[9][22] = t8279;
    by_parameters[9][23] = t8346;
    by_parameters[9][24] = t8376;
    by_parameters[9][25] = t8420;
    by_parameters[9][26] = t8464;
    by_parameters[9][27] = t8581;
    by_parameters[9][28] = t8621;
    by_parameters[9][29] = t8843;
    by_parameters[9][30] = t8697;
    by_parameters[9][31] = t8725;
    by_parameters[9][32] = t8769;
    by_parameters[9][33] = t8817;
    by_parameters[9][34] = t8830;
    by_parameters[9][35] = t8842;
    by_parameters[10][0] = t5969;
    by_parameters[10][1] = t6170;
    by_parameters[10][2] = t7116;
    by_parameters[10][3] = t7164;
    by_parameters[10][4] = t7394;
    by_parameters[10][5] = t7431;
    by_parameters[10][6] = t7461;
    by_parameters[10][7] = t7507;
    by_parameters[10][8] = t7543;
    by_parameters[10][9] = t7570;
    by_parameters[10][10] = t7658;
    by_parameters[10][11] = t7700;
    by_parameters[10][12] = t7727;
    by_parameters[10][13] = t7766;
    by_parameters[10][14] = t7810;
    by_parameters[10][15] = t7837;
    by_parameters[10][16] = t7873;
    by_parameters[10][17] = t7959;
    by_parameters[10][18] = t8001;
    by_parameters[10][19] = t8028;
    by_parameters[10][20] = t8067;
    by_parameters[10][21] = t8109;
    by_parameters[10][22] = t8273;
    by_parameters[10][23] = t8340;
    by_parameters[10][24] = t8370;
    by_parameters[10][25] = t8414;
    by_parameters[10][26] = t8458;
    by_parameters[10][27] = t8575;
    by_parameters[10][28] = t8615;
    by_parameters[10][29] = t8643;
    by_parameters[10][30] = t8691;
    by_parameters[10][31] = t8719;
    by_parameters[10][32] = t8763;
    by_parameters[10][33] = t8811;
    by_parameters[10][34] = t8825;
    by_parameters[10][35] = t8837;
    by_parameters[11][0] = t5965;
    by_parameters[11][1] = t6166;
    by_parameters[11][2] = t7112;
    by_parameters[11][3] = t7160;
    by_parameters[11][4] = t7390;
    by_parameters[11][5] = t7427;
    by_parameters[11][6] = t7457;
    by_parameters[11][7] = t7503;
    by_parameters[11][8] = t7539;
    by_parameters[11][9] = t7566;
    by_parameters[11][10] = t7654;
    by_parameters[11][11] = t7696;
    by_parameters[11][12] = t7723;
    by_parameters[11][13] = t7762;
    by_parameters[11][14] = t7806;
    by_parameters[11][15] = t7833;
    by_parameters[11][16] = t7869;
    by_parameters[11][17] = t7955;
    by_parameters[11][18] = t7997;
    by_parameters[11][19] = t8024;
    by_parameters[11][20] = t8063;
    by_parameters[11][21] = t8105;
    by_parameters[11][22] = t8269;
    by_parameters[11][23] = t8336;
    by_parameters[11][24] = t8366;
    by_parameters[11][25] = t8410;
    by_parameters[11][26] = t8454;
    by_parameters[11][27] = t8571;
    by_parameters[11][28] = t8611;
    by_parameters[11][29] = t8639;
    by_parameters[11][30] = t8687;
    by_parameters[11][31] = t8715;
    by_parameters[11][32] = t8759;
    by_parameters[11][33] = t8807;
    by_parameters[11][34] = t8844;
    by_parameters[11][35] = t8845;
    by_parameters[12][0] = t5963;
    by_parameters[12][1] = t6164;
    by_parameters[12][2] = t7110;
    by_parameters[12][3] = t7158;
    by_parameters[12][4] = t7388;
    by_parameters[12][5] = t7425;
    by_parameters[12][6] = t7455;
    by_parameters[12][7] = t7501;
    by_parameters[12][8] = t7537;
    by_parameters[12][9] = t7564;
    by_parameters[12][10] = t7652;
    by_parameters[12][11] = t7694;
    by_parameters[12][12] = t7721;
    by_parameters[12][13] = t7760;
    by_parameters[12][14] = t7804;
    by_parameters[12][15] = t7831;
    by_parameters[12][16] = t7867;
    by_parameters[12][17] = t7953;
    by_parameters[12][18] = t7995;
    by_parameters[12][19] = t8022;
    by_parameters[12][20] = t8061;
    by_parameters[12][21] = t8103;
    by_parameters[12][22] = t8267;
    by_parameters[12][23] = t8334;
    by_parameters[12][24] = t8364;
    by_parameters[12][25] = t8408;
    by_parameters[12][26] = t8452;
    by_parameters[12][27] = t8569;
    by_parameters[12][28] = t8609;
    by_parameters[12][29] = t8637;
    by_parameters[12][30] = t8685;
    by_parameters[12][31] = t8713;
    by_parameters[12][32] = t8757;
    by_parameters[12][33] = t8805;
    by_parameters[12][34] = t8846;
    by_parameters[12][35] = t8847;
}

carvallo_motion_error_t whipple_leaning_f32_motion_by_parameters(const whipple_leaning_f32_motion_t *motion,
    const float positions[WHIPPLE_LEANING_POSITIONS], const float speeds[WHIPPLE_LEANING_SPEEDS],
    const float forces[WHIPPLE_LEANING_FORCES],
    float by_parameters[WHIPPLE_LEANING_STATES][WHIPPLE_LEANING_PARAMETERS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_LEANING_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_LEANING_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_LEANING_FORCES)) {
        bool are_finite = true;
        whipple_leaning_f32_compute_by_parameters(motion, positions, speeds, forces, by_parameters);
        for (size_t row = 0U; row < WHIPPLE_LEANING_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f32(by_parameters[row],
                WHIPPLE_LEANING_PARAMETERS);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}
