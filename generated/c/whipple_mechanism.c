/* @generated from generated/models/whipple_mechanism.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: d2f6051b9c7ec604
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
 * C1_12 = mu*(ST - Sz_all) + SF*cos(lam) + yaw_per_v_delta*Jxz_all [kg*m]
 * C1_21 = -(mu*ST + SF*cos(lam)) [kg*m]
 * C1_22 = mu*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
 * K0_11 = Sz_all [kg*m]
 * K0_12 = K0_21 = K_phi_delta [kg*m]
 * K0_22 = K_delta_delta [kg*m]
 * K2_12 = yaw_per_v_delta*(ST - Sz_all) [kg]
 * K2_22 = yaw_per_v_delta*(SF*sin(lam) + P_delta_lateral) [kg]
 * @endverbatim
 */

#include "whipple_mechanism.h"

#include "carvallo_trig.h"

#include <float.h>

const char *whipple_mechanism_set_name(whipple_mechanism_set_t set)
{
    static const char *const TEXTS[] = {
        "benchmark",
        "benchmark_2005",
        "two_mass_skate",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *whipple_mechanism_validity_text(whipple_mechanism_validity_t validity)
{
    static const char *const TEXTS[] = {
        "WhippleMechanism: the parameters are valid",
        "WhippleMechanism: w in m must be finite and > 0",
        "WhippleMechanism: c in m must be finite",
        "WhippleMechanism: lam in rad must be finite and > -1.5707963267948966 and < 1.5707963267948966",
        "WhippleMechanism: g in N/kg must be finite and >= 0",
        "WhippleMechanism: rR in m must be finite and > 0",
        "WhippleMechanism: mR in kg must be finite and >= 0",
        "WhippleMechanism: IRxx in kg*m^2 must be finite and >= 0",
        "WhippleMechanism: IRyy in kg*m^2 must be finite and >= 0",
        "WhippleMechanism: xB in m must be finite",
        "WhippleMechanism: zB in m must be finite",
        "WhippleMechanism: mB in kg must be finite and >= 0",
        "WhippleMechanism: IBxx in kg*m^2 must be finite and >= 0",
        "WhippleMechanism: IByy in kg*m^2 must be finite and >= 0",
        "WhippleMechanism: IBzz in kg*m^2 must be finite and >= 0",
        "WhippleMechanism: IBxz in kg*m^2 must be finite",
        "WhippleMechanism: xH in m must be finite",
        "WhippleMechanism: zH in m must be finite",
        "WhippleMechanism: mH in kg must be finite and >= 0",
        "WhippleMechanism: IHxx in kg*m^2 must be finite and >= 0",
        "WhippleMechanism: IHyy in kg*m^2 must be finite and >= 0",
        "WhippleMechanism: IHzz in kg*m^2 must be finite and >= 0",
        "WhippleMechanism: IHxz in kg*m^2 must be finite",
        "WhippleMechanism: rF in m must be finite and > 0",
        "WhippleMechanism: mF in kg must be finite and >= 0",
        "WhippleMechanism: IFxx in kg*m^2 must be finite and >= 0",
        "WhippleMechanism: IFyy in kg*m^2 must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t whipple_mechanism_partials[WHIPPLE_MECHANISM_PARTIALS] = {
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
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 10U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 11U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 12U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 13U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 14U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 14U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 15U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 16U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 17U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 17U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 18U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 19U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 20U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 21U, false},
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
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 73U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 74U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 75U, false},
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
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 84U, false},
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
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 110U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 110U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 111U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 112U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 113U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 114U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 115U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 115U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 116U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 117U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 118U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 35U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 91U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 91U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 119U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 94U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 120U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 120U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 121U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 122U, false}
};

const whipple_mechanism_f64_t whipple_mechanism_f64_sets[WHIPPLE_MECHANISM_SETS] = {
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
        .IFyy = 0.28
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
        .IFyy = 0.28
    },
    { /* two_mass_skate */
        .w = 1.0,
        .c = 0.0,
        .lam = 0.08726646259971647,
        .g = 9.81,
        .rR = 0.1,
        .mR = 0.0,
        .IRxx = 0.0,
        .IRyy = 0.0,
        .xB = 1.2,
        .zB = (-0.4),
        .mB = 10.0,
        .IBxx = 0.0,
        .IByy = 0.0,
        .IBzz = 0.0,
        .IBxz = 0.0,
        .xH = 1.02,
        .zH = (-0.2),
        .mH = 1.0,
        .IHxx = 0.0,
        .IHyy = 0.0,
        .IHzz = 0.0,
        .IHxz = 0.0,
        .rF = 0.1,
        .mF = 0.0,
        .IFxx = 0.0,
        .IFyy = 0.0
    }
};

whipple_mechanism_validity_t whipple_mechanism_f64_validate(const whipple_mechanism_f64_t *p)
{
    whipple_mechanism_validity_t validity = WHIPPLE_MECHANISM_VALID;
    if (!((p->w > 0.0) && (p->w <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_w;
    } else if (!((p->c >= -DBL_MAX) && (p->c <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_c;
    } else if (!((p->lam > (-1.5707963267948966)) && (p->lam < 1.5707963267948966))) {
        validity = WHIPPLE_MECHANISM_INVALID_lam;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_g;
    } else if (!((p->rR > 0.0) && (p->rR <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_rR;
    } else if (!((p->mR >= 0.0) && (p->mR <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_mR;
    } else if (!((p->IRxx >= 0.0) && (p->IRxx <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0) && (p->IRyy <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IRyy;
    } else if (!((p->xB >= -DBL_MAX) && (p->xB <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_xB;
    } else if (!((p->zB >= -DBL_MAX) && (p->zB <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_zB;
    } else if (!((p->mB >= 0.0) && (p->mB <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_mB;
    } else if (!((p->IBxx >= 0.0) && (p->IBxx <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0) && (p->IByy <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0) && (p->IBzz <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IBzz;
    } else if (!((p->IBxz >= -DBL_MAX) && (p->IBxz <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IBxz;
    } else if (!((p->xH >= -DBL_MAX) && (p->xH <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_xH;
    } else if (!((p->zH >= -DBL_MAX) && (p->zH <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_zH;
    } else if (!((p->mH >= 0.0) && (p->mH <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_mH;
    } else if (!((p->IHxx >= 0.0) && (p->IHxx <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0) && (p->IHyy <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0) && (p->IHzz <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IHzz;
    } else if (!((p->IHxz >= -DBL_MAX) && (p->IHxz <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IHxz;
    } else if (!((p->rF > 0.0) && (p->rF <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_rF;
    } else if (!((p->mF >= 0.0) && (p->mF <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_mF;
    } else if (!((p->IFxx >= 0.0) && (p->IFxx <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0) && (p->IFyy <= DBL_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IFyy;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void whipple_mechanism_f64_matrices(const whipple_mechanism_f64_t *p, whipple_mechanism_f64_matrices_t *matrices)
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
    const double t100 = ST - Sz_all;
    const double t103 = cos_lam * SF;
    const double C1_12 = (mu * t100) + (yaw_per_v_delta * Jxz_all) + t103;
    const double Sx_all = t73 - t77;
    const double t109 = mu * Sx_all;
    const double P_delta_lateral = t109 - t69;
    const double C1_22 = (mu * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
    const double K2_12 = yaw_per_v_delta * t100;
    const double K2_22 = yaw_per_v_delta * (P_delta_lateral + (sin_lam * SF));
    const double C1_21 = -(t103 + (mu * ST));
    const double K0_12 = t69 - t109;
    const double K0_22 = -(sin_lam * P_delta_lateral);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
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

carvallo_system_error_t whipple_mechanism_f64_at_speed(const whipple_mechanism_f64_matrices_t *matrices,
    double speed, double gravity, whipple_mechanism_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed) && carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < WHIPPLE_MECHANISM_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_MECHANISM_N; column++) {
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

carvallo_system_error_t whipple_mechanism_f64_state_space(const whipple_mechanism_f64_system_t *system,
    whipple_mechanism_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[WHIPPLE_MECHANISM_N * WHIPPLE_MECHANISM_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * WHIPPLE_MECHANISM_N * WHIPPLE_MECHANISM_N];
    for (size_t row = 0U; row < WHIPPLE_MECHANISM_N; row++) {
        double *const solved = &x[3U * WHIPPLE_MECHANISM_N * row];
        for (size_t column = 0U; column < WHIPPLE_MECHANISM_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * WHIPPLE_MECHANISM_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHIPPLE_MECHANISM_N + column] = -system->c[row][column];
            solved[(2U * WHIPPLE_MECHANISM_N) + column] = 0.0;
        }
        solved[(2U * WHIPPLE_MECHANISM_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[WHIPPLE_MECHANISM_N * WHIPPLE_MECHANISM_N];
        error = carvallo_solve_f64(WHIPPLE_MECHANISM_N, m, terms, 3U * WHIPPLE_MECHANISM_N, x);
    }
    for (size_t row = 0U; row < (2U * WHIPPLE_MECHANISM_N); row++) {
        for (size_t column = 0U; column < (2U * WHIPPLE_MECHANISM_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < WHIPPLE_MECHANISM_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHIPPLE_MECHANISM_N; row++) {
            const size_t target = WHIPPLE_MECHANISM_N + row;
            for (size_t column = 0U; column < (2U * WHIPPLE_MECHANISM_N); column++) {
                space->a[target][column] = x[(3U * WHIPPLE_MECHANISM_N * row) + column];
            }
            for (size_t column = 0U; column < WHIPPLE_MECHANISM_N; column++) {
                space->b[target][column] = x[(3U * WHIPPLE_MECHANISM_N * row) + (2U *
                    WHIPPLE_MECHANISM_N) + column];
            }
            space->a[row][WHIPPLE_MECHANISM_N + row] = 1.0;
        }
    }
    return error;
}

double whipple_mechanism_f64_rate_at(const whipple_mechanism_f64_rate_t *rate, double v,
    const double q[WHIPPLE_MECHANISM_N], const double q_dot[WHIPPLE_MECHANISM_N], double psi)
{
    double by_coordinates = 0.0;
    double by_rates = 0.0;
    for (size_t i = 0U; i < WHIPPLE_MECHANISM_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void whipple_mechanism_f64_kinematics(const whipple_mechanism_f64_t *p, whipple_mechanism_f64_kinematics_t *kinematics)
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

void whipple_mechanism_f64_derivatives(const whipple_mechanism_f64_t *p,
    whipple_mechanism_f64_matrices_t *matrices, whipple_mechanism_f64_derivatives_t *derivatives)
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
    const double mu = p->c * yaw_per_v_delta;
    const double Sz_delta = t6 - t10;
    const double Jxz_all = Jxz_delta + p->IBxz - (t21 * p->xB) - (t34 * Sz_delta);
    const double M_12 = hx_delta + (mu * Jxz_all);
    const double t57 = sin_lam * Jxz_delta;
    const double t59 = p->mF * p->c;
    const double t61 = p->mH * t36;
    const double Jzz_delta = p->IFxx + p->IHzz + (p->c * t59) + (t36 * t61);
    const double hz_delta = t57 + (cos_lam * Jzz_delta);
    const double t70 = t59 + t61;
    const double t72 = (sin_lam * Sz_delta) + (cos_lam * t70);
    const double M_yaw_delta = hz_delta - (t34 * t72);
    const double mA = p->mH + p->mF;
    const double t78 = t70 - (t34 * mA);
    const double t79 = t70 + t78;
    const double t81 = p->mB * p->xB;
    const double P_delta_yaw_mu = p->IRxx + Jzz_delta + p->IBzz + (p->xB * t81) - (t34 * t79);
    const double t87 = mu * P_delta_yaw_mu;
    const double P_delta_yaw = M_yaw_delta + t87;
    const double t89 = M_yaw_delta + P_delta_yaw;
    const double M_22 = (sin_lam * hx_delta) + (cos_lam * hz_delta) + (mu * t89);
    const double t95 = 1.0 / p->rF;
    const double SF = p->IFyy * t95;
    const double t97 = cos_lam * SF;
    const double t99 = 1.0 / p->rR;
    const double t100 = p->IRyy * t99;
    const double ST = SF + t100;
    const double Sz_all = t21 + Sz_delta - t17;
    const double t104 = ST - Sz_all;
    const double t106 = yaw_per_v_delta * Jxz_all;
    const double C1_12 = t97 + (mu * t104) + t106;
    const double Sx_all = t81 - t78;
    const double K0_12 = t72 - (mu * Sx_all);
    const double C1_22 = (yaw_per_v_delta * P_delta_yaw) - (mu * K0_12);
    const double K0_22 = sin_lam * K0_12;
    const double K2_12 = yaw_per_v_delta * t104;
    const double t119 = sin_lam * SF;
    const double K2_22_yaw_per_v_delta = t119 - K0_12;
    const double K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
    const double t122 = t43 * yaw_per_v_delta;
    const double t123 = p->c * Jxz_all;
    const double M_12_Jxz_delta = cos_lam + mu;
    const double t127 = t6 * M_12_Jxz_delta;
    const double t128 = t127 - (mu * Sz_delta);
    const double M_12_w = t128 - (t122 * t123);
    const double M_22_mu = t87 + t89;
    const double M_22_yaw_per_v_delta = p->c * M_22_mu;
    const double t134 = t34 * mu;
    const double t137 = (mA * t134) - t72 - (mu * t79);
    const double t140 = t134 + t134;
    const double t143 = (cos_lam * t140) + (mu * t140);
    const double M_22_hz_delta = mu + M_12_Jxz_delta;
    const double M_22_IRxx = mu * mu;
    const double M_22_Jzz_delta = (cos_lam * M_22_hz_delta) + M_22_IRxx;
    const double t149 = (t36 * M_22_Jzz_delta) - t143;
    const double M_22_Jxz_delta = sin_lam * (cos_lam + M_22_hz_delta);
    const double t156 = (p->mH * t149) + (t6 * M_22_Jxz_delta) + (t61 * M_22_Jzz_delta);
    const double t157 = (mu * (t137 - t72)) + t156;
    const double M_22_w = t157 - (t122 * M_22_yaw_per_v_delta);
    const double C1_12_yaw_per_v_delta = Jxz_all + (p->c * t104);
    const double t163 = t6 * yaw_per_v_delta;
    const double t164 = t163 - (yaw_per_v_delta * Sz_delta);
    const double C1_12_w = t164 - (t122 * C1_12_yaw_per_v_delta);
    const double t166 = p->c * ST;
    const double C1_21_w = t122 * t166;
    const double t168 = mu * mA;
    const double t169 = p->c * Sx_all;
    const double t171 = t168 - (t122 * t169);
    const double t172 = p->mH * M_12_Jxz_delta;
    const double P_delta_lateral_w = t171 - t172;
    const double C1_22_mu = (yaw_per_v_delta * P_delta_yaw_mu) - K0_12;
    const double C1_22_yaw_per_v_delta = P_delta_yaw + (p->c * C1_22_mu);
    const double t181 = t34 * yaw_per_v_delta;
    const double t184 = (cos_lam * t181) + (yaw_per_v_delta * t140);
    const double C1_22_IRxx = yaw_per_v_delta * mu;
    const double C1_22_Jzz_delta = (cos_lam * yaw_per_v_delta) + C1_22_IRxx;
    const double t189 = (t36 * C1_22_Jzz_delta) - t184;
    const double C1_22_Jxz_delta = sin_lam * yaw_per_v_delta;
    const double t195 = (p->mH * t189) + (t6 * C1_22_Jxz_delta) + (t61 * C1_22_Jzz_delta);
    const double t196 = (yaw_per_v_delta * t137) + t195;
    const double C1_22_w = (mu * P_delta_lateral_w) + t196 - (t122 * C1_22_yaw_per_v_delta);
    const double t199 = sin_lam * P_delta_lateral_w;
    const double t200 = t104 * t122;
    const double K2_22_w = (yaw_per_v_delta * P_delta_lateral_w) - (K2_22_yaw_per_v_delta * t122);
    const double M_12_c = t106 + t128 - (t10 * M_12_Jxz_delta);
    const double t209 = (p->c * M_22_Jzz_delta) - t143;
    const double M_22_c = t157 + (p->mF * t209) + (yaw_per_v_delta * M_22_mu) + (t59 *
        M_22_Jzz_delta) - (t10 * M_22_Jxz_delta);
    const double C1_12_c = t164 + (yaw_per_v_delta * (t104 - t10));
    const double t220 = yaw_per_v_delta * ST;
    const double t223 = (p->c * C1_22_Jzz_delta) - t184;
    const double t228 = t168 + (yaw_per_v_delta * Sx_all) - t172;
    const double t229 = p->mF * M_12_Jxz_delta;
    const double P_delta_lateral_c = t228 - t229;
    const double C1_22_c = t196 + (p->mF * t223) + (yaw_per_v_delta * C1_22_mu) + (mu *
        P_delta_lateral_c) + (t59 * C1_22_Jzz_delta) - (t10 * C1_22_Jxz_delta);
    const double t238 = sin_lam * P_delta_lateral_c;
    const double K2_22_c = yaw_per_v_delta * P_delta_lateral_c;
    const double hx_delta_lam = (Jxx_delta * cos_lam) - t57;
    const double t242 = sin_lam * t43;
    const double M_12_lam = hx_delta_lam - (t123 * t242);
    const double hz_delta_lam = t41 - (sin_lam * Jzz_delta);
    const double t254 = (cos_lam * Sz_delta) - (sin_lam * t70);
    const double M_22_lam = (sin_lam * hx_delta_lam) + (cos_lam * hx_delta) + (M_22_hz_delta *
        hz_delta_lam) - (sin_lam * hz_delta) - (M_22_yaw_per_v_delta * t242) - (t140 * t254);
    const double t262 = t119 + (C1_12_yaw_per_v_delta * t242);
    const double C1_21_lam = t119 + (t166 * t242);
    const double K0_12_lam = t254 + (t169 * t242);
    const double C1_22_lam = (yaw_per_v_delta * hz_delta_lam) - (mu * K0_12_lam) -
        (C1_22_yaw_per_v_delta * t242) - (t181 * t254);
    const double K0_22_lam = (sin_lam * K0_12_lam) + (cos_lam * K0_12);
    const double t277 = t104 * t242;
    const double K2_22_lam = (yaw_per_v_delta * (t97 - K0_12_lam)) - (K2_22_yaw_per_v_delta * t242);
    const double M_11_rR = t17 + t17;
    const double t283 = t99 * t100;
    const double t284 = p->mR - t283;
    const double C1_12_rR = mu * t284;
    const double C1_21_rR = mu * t283;
    const double K2_12_rR = yaw_per_v_delta * t284;
    const double M_11_mR = p->rR * p->rR;
    const double C1_12_mR = p->rR * mu;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double C1_12_IRyy = mu * t99;
    const double K2_12_IRyy = yaw_per_v_delta * t99;
    const double t294 = t21 * mu;
    const double t295 = mu * p->xB;
    const double t296 = p->mB * t295;
    const double P_delta_yaw_xB = t296 + (mu * t81);
    const double M_22_xB = mu * P_delta_yaw_xB;
    const double t300 = t21 * yaw_per_v_delta;
    const double t302 = p->mB * mu;
    const double C1_22_xB = (yaw_per_v_delta * P_delta_yaw_xB) + (mu * t302);
    const double t305 = sin_lam * t302;
    const double K2_22_xB = yaw_per_v_delta * t302;
    const double M_11_zB = t21 + t21;
    const double t309 = mu + (yaw_per_v_delta * p->xB);
    const double t310 = p->mB * t309;
    const double t311 = p->mB * yaw_per_v_delta;
    const double M_11_mB = p->zB * p->zB;
    const double t313 = p->zB * t295;
    const double P_delta_yaw_mB = p->xB * t295;
    const double M_22_mB = mu * P_delta_yaw_mB;
    const double t316 = p->zB * t309;
    const double C1_22_mB = (yaw_per_v_delta * P_delta_yaw_mB) + (mu * t295);
    const double t320 = sin_lam * t295;
    const double t321 = p->zB * yaw_per_v_delta;
    const double K2_22_mB = yaw_per_v_delta * t295;
    const double C1_22_xH = (mu * t172) - t195;
    const double t325 = sin_lam * t172;
    const double K2_22_xH = yaw_per_v_delta * t172;
    const double M_11_zH = t6 + t6;
    const double K0_12_mH = (p->zH * sin_lam) + (t36 * M_12_Jxz_delta) - t134;
    const double M_12_zH = (p->mH * K0_12_mH) + (t6 * sin_lam);
    const double t335 = sin_lam * t140;
    const double M_22_Jxx_delta = sin_lam * sin_lam;
    const double t340 = (p->zH * M_22_Jxx_delta) + (t36 * M_22_Jxz_delta) - t335;
    const double M_22_zH = (p->mH * t340) + (t6 * M_22_Jxx_delta);
    const double t344 = mu + t181;
    const double t346 = (t36 * yaw_per_v_delta) - t344;
    const double C1_12_zH = p->mH * t346;
    const double t348 = sin_lam * t181;
    const double t350 = (t36 * C1_22_Jxz_delta) - t348;
    const double K0_12_zH = p->mH * sin_lam;
    const double C1_22_zH = (p->mH * t350) - (mu * K0_12_zH);
    const double K0_22_zH = sin_lam * K0_12_zH;
    const double t356 = p->mH * yaw_per_v_delta;
    const double t357 = yaw_per_v_delta * K0_12_zH;
    const double M_11_mH = p->zH * p->zH;
    const double M_12_mH = p->zH * K0_12_mH;
    const double P_delta_yaw_mA = t34 * t134;
    const double M_22_mA = mu * P_delta_yaw_mA;
    const double M_22_mH = M_22_mA + (p->zH * t340) + (t36 * t149);
    const double C1_12_mH = p->zH * t346;
    const double C1_22_mA = yaw_per_v_delta * P_delta_yaw_mA;
    const double C1_22_mH = C1_22_mA + (p->zH * t350) + (t36 * t189) - (mu * K0_12_mH);
    const double K0_22_mH = sin_lam * K0_12_mH;
    const double t375 = p->zH * yaw_per_v_delta;
    const double t376 = yaw_per_v_delta * K0_12_mH;
    const double M_11_rF = t10 + t10;
    const double K0_12_mF = (p->c * M_12_Jxz_delta) - t134 - (p->rF * sin_lam);
    const double M_12_rF = (t10 * sin_lam) - (p->mF * K0_12_mF);
    const double t388 = t335 + (p->rF * M_22_Jxx_delta) - (p->c * M_22_Jxz_delta);
    const double M_22_rF = (p->mF * t388) + (t10 * M_22_Jxx_delta);
    const double t392 = t344 - mu;
    const double t394 = t95 * SF;
    const double C1_21_rF = M_12_Jxz_delta * t394;
    const double C1_12_rF = (p->mF * t392) - C1_21_rF;
    const double t398 = t348 - (p->c * C1_22_Jxz_delta);
    const double P_delta_lateral_rF = p->mF * sin_lam;
    const double C1_22_rF = (p->mF * t398) + (mu * P_delta_lateral_rF);
    const double t403 = sin_lam * P_delta_lateral_rF;
    const double K2_12_rF = (p->mF * yaw_per_v_delta) - (yaw_per_v_delta * t394);
    const double K2_22_rF = (yaw_per_v_delta * P_delta_lateral_rF) - (C1_22_Jxz_delta * t394);
    const double M_11_mF = p->rF * p->rF;
    const double t411 = p->rF * K0_12_mF;
    const double M_22_mF = M_22_mA + (p->c * t209) + (p->rF * t388);
    const double C1_12_mF = p->rF * t392;
    const double C1_22_mF = C1_22_mA + (p->c * t223) + (p->rF * t398) - (mu * K0_12_mF);
    const double K0_22_mF = sin_lam * K0_12_mF;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double t425 = yaw_per_v_delta * K0_12_mF;
    const double M_22_IFxx = M_22_Jzz_delta + M_22_Jxx_delta;
    const double C1_12_IFyy = t95 * M_12_Jxz_delta;
    const double K2_12_IFyy = yaw_per_v_delta * t95;
    const double K2_22_IFyy = t95 * C1_22_Jxz_delta;
    const double C1_21 = -(t97 + (mu * ST));
    const double K0_12_w = t172 - t171;
    const double K0_12_c = t229 - t228;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
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
    derivatives->values[0] = M_12_w;
    derivatives->values[1] = M_22_w;
    derivatives->values[2] = C1_12_w;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = K0_12_w;
    derivatives->values[6] = t199;
    derivatives->values[7] = t200;
    derivatives->values[8] = K2_22_w;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = C1_12_c;
    derivatives->values[12] = t220;
    derivatives->values[13] = C1_22_c;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = t238;
    derivatives->values[16] = K2_22_c;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t262;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = t277;
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
    derivatives->values[40] = t294;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t300;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = t302;
    derivatives->values[45] = t305;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t296;
    derivatives->values[49] = t310;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t311;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t313;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t316;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = t295;
    derivatives->values[59] = t320;
    derivatives->values[60] = t321;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = mu;
    derivatives->values[63] = yaw_per_v_delta;
    derivatives->values[64] = t127;
    derivatives->values[65] = t156;
    derivatives->values[66] = t163;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = t172;
    derivatives->values[69] = t325;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = M_22_zH;
    derivatives->values[74] = C1_12_zH;
    derivatives->values[75] = C1_22_zH;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t356;
    derivatives->values[80] = t357;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = M_12_mH;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = C1_12_mH;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = K0_22_mH;
    derivatives->values[89] = t375;
    derivatives->values[90] = t376;
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
    derivatives->values[106] = t403;
    derivatives->values[107] = K2_12_rF;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = t411;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = C1_22_mF;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = K0_22_mF;
    derivatives->values[117] = K2_12_mF;
    derivatives->values[118] = t425;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = K2_12_IFyy;
    derivatives->values[122] = K2_22_IFyy;
}

void whipple_mechanism_f64_with_respect_to(const whipple_mechanism_f64_derivatives_t *derivatives,
    size_t parameter, whipple_mechanism_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHIPPLE_MECHANISM_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_MECHANISM_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
            matrices->k2[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < WHIPPLE_MECHANISM_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &whipple_mechanism_partials[position];
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

const whipple_mechanism_f32_t whipple_mechanism_f32_sets[WHIPPLE_MECHANISM_SETS] = {
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
        .IFyy = 0.28F
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
        .IFyy = 0.28F
    },
    { /* two_mass_skate */
        .w = 1.0F,
        .c = 0.0F,
        .lam = 0.08726646F,
        .g = 9.81F,
        .rR = 0.1F,
        .mR = 0.0F,
        .IRxx = 0.0F,
        .IRyy = 0.0F,
        .xB = 1.2F,
        .zB = (-0.4F),
        .mB = 10.0F,
        .IBxx = 0.0F,
        .IByy = 0.0F,
        .IBzz = 0.0F,
        .IBxz = 0.0F,
        .xH = 1.02F,
        .zH = (-0.2F),
        .mH = 1.0F,
        .IHxx = 0.0F,
        .IHyy = 0.0F,
        .IHzz = 0.0F,
        .IHxz = 0.0F,
        .rF = 0.1F,
        .mF = 0.0F,
        .IFxx = 0.0F,
        .IFyy = 0.0F
    }
};

whipple_mechanism_validity_t whipple_mechanism_f32_validate(const whipple_mechanism_f32_t *p)
{
    whipple_mechanism_validity_t validity = WHIPPLE_MECHANISM_VALID;
    if (!((p->w > 0.0F) && (p->w <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_w;
    } else if (!((p->c >= -FLT_MAX) && (p->c <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_c;
    } else if (!((p->lam > (-1.5707964F)) && (p->lam < 1.5707964F))) {
        validity = WHIPPLE_MECHANISM_INVALID_lam;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_g;
    } else if (!((p->rR > 0.0F) && (p->rR <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_rR;
    } else if (!((p->mR >= 0.0F) && (p->mR <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_mR;
    } else if (!((p->IRxx >= 0.0F) && (p->IRxx <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0F) && (p->IRyy <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IRyy;
    } else if (!((p->xB >= -FLT_MAX) && (p->xB <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_xB;
    } else if (!((p->zB >= -FLT_MAX) && (p->zB <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_zB;
    } else if (!((p->mB >= 0.0F) && (p->mB <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_mB;
    } else if (!((p->IBxx >= 0.0F) && (p->IBxx <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0F) && (p->IByy <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0F) && (p->IBzz <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IBzz;
    } else if (!((p->IBxz >= -FLT_MAX) && (p->IBxz <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IBxz;
    } else if (!((p->xH >= -FLT_MAX) && (p->xH <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_xH;
    } else if (!((p->zH >= -FLT_MAX) && (p->zH <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_zH;
    } else if (!((p->mH >= 0.0F) && (p->mH <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_mH;
    } else if (!((p->IHxx >= 0.0F) && (p->IHxx <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0F) && (p->IHyy <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0F) && (p->IHzz <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IHzz;
    } else if (!((p->IHxz >= -FLT_MAX) && (p->IHxz <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IHxz;
    } else if (!((p->rF > 0.0F) && (p->rF <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_rF;
    } else if (!((p->mF >= 0.0F) && (p->mF <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_mF;
    } else if (!((p->IFxx >= 0.0F) && (p->IFxx <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0F) && (p->IFyy <= FLT_MAX))) {
        validity = WHIPPLE_MECHANISM_INVALID_IFyy;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void whipple_mechanism_f32_matrices(const whipple_mechanism_f32_t *p, whipple_mechanism_f32_matrices_t *matrices)
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
    const float t100 = ST - Sz_all;
    const float t103 = cos_lam * SF;
    const float C1_12 = (mu * t100) + (yaw_per_v_delta * Jxz_all) + t103;
    const float Sx_all = t73 - t77;
    const float t109 = mu * Sx_all;
    const float P_delta_lateral = t109 - t69;
    const float C1_22 = (mu * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
    const float K2_12 = yaw_per_v_delta * t100;
    const float K2_22 = yaw_per_v_delta * (P_delta_lateral + (sin_lam * SF));
    const float C1_21 = -(t103 + (mu * ST));
    const float K0_12 = t69 - t109;
    const float K0_22 = -(sin_lam * P_delta_lateral);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
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

carvallo_system_error_t whipple_mechanism_f32_at_speed(const whipple_mechanism_f32_matrices_t *matrices,
    float speed, float gravity, whipple_mechanism_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed) && carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < WHIPPLE_MECHANISM_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_MECHANISM_N; column++) {
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

carvallo_system_error_t whipple_mechanism_f32_state_space(const whipple_mechanism_f32_system_t *system,
    whipple_mechanism_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[WHIPPLE_MECHANISM_N * WHIPPLE_MECHANISM_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * WHIPPLE_MECHANISM_N * WHIPPLE_MECHANISM_N];
    for (size_t row = 0U; row < WHIPPLE_MECHANISM_N; row++) {
        float *const solved = &x[3U * WHIPPLE_MECHANISM_N * row];
        for (size_t column = 0U; column < WHIPPLE_MECHANISM_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * WHIPPLE_MECHANISM_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHIPPLE_MECHANISM_N + column] = -system->c[row][column];
            solved[(2U * WHIPPLE_MECHANISM_N) + column] = 0.0F;
        }
        solved[(2U * WHIPPLE_MECHANISM_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[WHIPPLE_MECHANISM_N * WHIPPLE_MECHANISM_N];
        error = carvallo_solve_f32(WHIPPLE_MECHANISM_N, m, terms, 3U * WHIPPLE_MECHANISM_N, x);
    }
    for (size_t row = 0U; row < (2U * WHIPPLE_MECHANISM_N); row++) {
        for (size_t column = 0U; column < (2U * WHIPPLE_MECHANISM_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < WHIPPLE_MECHANISM_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHIPPLE_MECHANISM_N; row++) {
            const size_t target = WHIPPLE_MECHANISM_N + row;
            for (size_t column = 0U; column < (2U * WHIPPLE_MECHANISM_N); column++) {
                space->a[target][column] = x[(3U * WHIPPLE_MECHANISM_N * row) + column];
            }
            for (size_t column = 0U; column < WHIPPLE_MECHANISM_N; column++) {
                space->b[target][column] = x[(3U * WHIPPLE_MECHANISM_N * row) + (2U *
                    WHIPPLE_MECHANISM_N) + column];
            }
            space->a[row][WHIPPLE_MECHANISM_N + row] = 1.0F;
        }
    }
    return error;
}

float whipple_mechanism_f32_rate_at(const whipple_mechanism_f32_rate_t *rate, float v,
    const float q[WHIPPLE_MECHANISM_N], const float q_dot[WHIPPLE_MECHANISM_N], float psi)
{
    float by_coordinates = 0.0F;
    float by_rates = 0.0F;
    for (size_t i = 0U; i < WHIPPLE_MECHANISM_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void whipple_mechanism_f32_kinematics(const whipple_mechanism_f32_t *p, whipple_mechanism_f32_kinematics_t *kinematics)
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

void whipple_mechanism_f32_derivatives(const whipple_mechanism_f32_t *p,
    whipple_mechanism_f32_matrices_t *matrices, whipple_mechanism_f32_derivatives_t *derivatives)
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
    const float mu = p->c * yaw_per_v_delta;
    const float Sz_delta = t6 - t10;
    const float Jxz_all = Jxz_delta + p->IBxz - (t21 * p->xB) - (t34 * Sz_delta);
    const float M_12 = hx_delta + (mu * Jxz_all);
    const float t57 = sin_lam * Jxz_delta;
    const float t59 = p->mF * p->c;
    const float t61 = p->mH * t36;
    const float Jzz_delta = p->IFxx + p->IHzz + (p->c * t59) + (t36 * t61);
    const float hz_delta = t57 + (cos_lam * Jzz_delta);
    const float t70 = t59 + t61;
    const float t72 = (sin_lam * Sz_delta) + (cos_lam * t70);
    const float M_yaw_delta = hz_delta - (t34 * t72);
    const float mA = p->mH + p->mF;
    const float t78 = t70 - (t34 * mA);
    const float t79 = t70 + t78;
    const float t81 = p->mB * p->xB;
    const float P_delta_yaw_mu = p->IRxx + Jzz_delta + p->IBzz + (p->xB * t81) - (t34 * t79);
    const float t87 = mu * P_delta_yaw_mu;
    const float P_delta_yaw = M_yaw_delta + t87;
    const float t89 = M_yaw_delta + P_delta_yaw;
    const float M_22 = (sin_lam * hx_delta) + (cos_lam * hz_delta) + (mu * t89);
    const float t95 = 1.0F / p->rF;
    const float SF = p->IFyy * t95;
    const float t97 = cos_lam * SF;
    const float t99 = 1.0F / p->rR;
    const float t100 = p->IRyy * t99;
    const float ST = SF + t100;
    const float Sz_all = t21 + Sz_delta - t17;
    const float t104 = ST - Sz_all;
    const float t106 = yaw_per_v_delta * Jxz_all;
    const float C1_12 = t97 + (mu * t104) + t106;
    const float Sx_all = t81 - t78;
    const float K0_12 = t72 - (mu * Sx_all);
    const float C1_22 = (yaw_per_v_delta * P_delta_yaw) - (mu * K0_12);
    const float K0_22 = sin_lam * K0_12;
    const float K2_12 = yaw_per_v_delta * t104;
    const float t119 = sin_lam * SF;
    const float K2_22_yaw_per_v_delta = t119 - K0_12;
    const float K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
    const float t122 = t43 * yaw_per_v_delta;
    const float t123 = p->c * Jxz_all;
    const float M_12_Jxz_delta = cos_lam + mu;
    const float t127 = t6 * M_12_Jxz_delta;
    const float t128 = t127 - (mu * Sz_delta);
    const float M_12_w = t128 - (t122 * t123);
    const float M_22_mu = t87 + t89;
    const float M_22_yaw_per_v_delta = p->c * M_22_mu;
    const float t134 = t34 * mu;
    const float t137 = (mA * t134) - t72 - (mu * t79);
    const float t140 = t134 + t134;
    const float t143 = (cos_lam * t140) + (mu * t140);
    const float M_22_hz_delta = mu + M_12_Jxz_delta;
    const float M_22_IRxx = mu * mu;
    const float M_22_Jzz_delta = (cos_lam * M_22_hz_delta) + M_22_IRxx;
    const float t149 = (t36 * M_22_Jzz_delta) - t143;
    const float M_22_Jxz_delta = sin_lam * (cos_lam + M_22_hz_delta);
    const float t156 = (p->mH * t149) + (t6 * M_22_Jxz_delta) + (t61 * M_22_Jzz_delta);
    const float t157 = (mu * (t137 - t72)) + t156;
    const float M_22_w = t157 - (t122 * M_22_yaw_per_v_delta);
    const float C1_12_yaw_per_v_delta = Jxz_all + (p->c * t104);
    const float t163 = t6 * yaw_per_v_delta;
    const float t164 = t163 - (yaw_per_v_delta * Sz_delta);
    const float C1_12_w = t164 - (t122 * C1_12_yaw_per_v_delta);
    const float t166 = p->c * ST;
    const float C1_21_w = t122 * t166;
    const float t168 = mu * mA;
    const float t169 = p->c * Sx_all;
    const float t171 = t168 - (t122 * t169);
    const float t172 = p->mH * M_12_Jxz_delta;
    const float P_delta_lateral_w = t171 - t172;
    const float C1_22_mu = (yaw_per_v_delta * P_delta_yaw_mu) - K0_12;
    const float C1_22_yaw_per_v_delta = P_delta_yaw + (p->c * C1_22_mu);
    const float t181 = t34 * yaw_per_v_delta;
    const float t184 = (cos_lam * t181) + (yaw_per_v_delta * t140);
    const float C1_22_IRxx = yaw_per_v_delta * mu;
    const float C1_22_Jzz_delta = (cos_lam * yaw_per_v_delta) + C1_22_IRxx;
    const float t189 = (t36 * C1_22_Jzz_delta) - t184;
    const float C1_22_Jxz_delta = sin_lam * yaw_per_v_delta;
    const float t195 = (p->mH * t189) + (t6 * C1_22_Jxz_delta) + (t61 * C1_22_Jzz_delta);
    const float t196 = (yaw_per_v_delta * t137) + t195;
    const float C1_22_w = (mu * P_delta_lateral_w) + t196 - (t122 * C1_22_yaw_per_v_delta);
    const float t199 = sin_lam * P_delta_lateral_w;
    const float t200 = t104 * t122;
    const float K2_22_w = (yaw_per_v_delta * P_delta_lateral_w) - (K2_22_yaw_per_v_delta * t122);
    const float M_12_c = t106 + t128 - (t10 * M_12_Jxz_delta);
    const float t209 = (p->c * M_22_Jzz_delta) - t143;
    const float M_22_c = t157 + (p->mF * t209) + (yaw_per_v_delta * M_22_mu) + (t59 *
        M_22_Jzz_delta) - (t10 * M_22_Jxz_delta);
    const float C1_12_c = t164 + (yaw_per_v_delta * (t104 - t10));
    const float t220 = yaw_per_v_delta * ST;
    const float t223 = (p->c * C1_22_Jzz_delta) - t184;
    const float t228 = t168 + (yaw_per_v_delta * Sx_all) - t172;
    const float t229 = p->mF * M_12_Jxz_delta;
    const float P_delta_lateral_c = t228 - t229;
    const float C1_22_c = t196 + (p->mF * t223) + (yaw_per_v_delta * C1_22_mu) + (mu *
        P_delta_lateral_c) + (t59 * C1_22_Jzz_delta) - (t10 * C1_22_Jxz_delta);
    const float t238 = sin_lam * P_delta_lateral_c;
    const float K2_22_c = yaw_per_v_delta * P_delta_lateral_c;
    const float hx_delta_lam = (Jxx_delta * cos_lam) - t57;
    const float t242 = sin_lam * t43;
    const float M_12_lam = hx_delta_lam - (t123 * t242);
    const float hz_delta_lam = t41 - (sin_lam * Jzz_delta);
    const float t254 = (cos_lam * Sz_delta) - (sin_lam * t70);
    const float M_22_lam = (sin_lam * hx_delta_lam) + (cos_lam * hx_delta) + (M_22_hz_delta *
        hz_delta_lam) - (sin_lam * hz_delta) - (M_22_yaw_per_v_delta * t242) - (t140 * t254);
    const float t262 = t119 + (C1_12_yaw_per_v_delta * t242);
    const float C1_21_lam = t119 + (t166 * t242);
    const float K0_12_lam = t254 + (t169 * t242);
    const float C1_22_lam = (yaw_per_v_delta * hz_delta_lam) - (mu * K0_12_lam) -
        (C1_22_yaw_per_v_delta * t242) - (t181 * t254);
    const float K0_22_lam = (sin_lam * K0_12_lam) + (cos_lam * K0_12);
    const float t277 = t104 * t242;
    const float K2_22_lam = (yaw_per_v_delta * (t97 - K0_12_lam)) - (K2_22_yaw_per_v_delta * t242);
    const float M_11_rR = t17 + t17;
    const float t283 = t99 * t100;
    const float t284 = p->mR - t283;
    const float C1_12_rR = mu * t284;
    const float C1_21_rR = mu * t283;
    const float K2_12_rR = yaw_per_v_delta * t284;
    const float M_11_mR = p->rR * p->rR;
    const float C1_12_mR = p->rR * mu;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float C1_12_IRyy = mu * t99;
    const float K2_12_IRyy = yaw_per_v_delta * t99;
    const float t294 = t21 * mu;
    const float t295 = mu * p->xB;
    const float t296 = p->mB * t295;
    const float P_delta_yaw_xB = t296 + (mu * t81);
    const float M_22_xB = mu * P_delta_yaw_xB;
    const float t300 = t21 * yaw_per_v_delta;
    const float t302 = p->mB * mu;
    const float C1_22_xB = (yaw_per_v_delta * P_delta_yaw_xB) + (mu * t302);
    const float t305 = sin_lam * t302;
    const float K2_22_xB = yaw_per_v_delta * t302;
    const float M_11_zB = t21 + t21;
    const float t309 = mu + (yaw_per_v_delta * p->xB);
    const float t310 = p->mB * t309;
    const float t311 = p->mB * yaw_per_v_delta;
    const float M_11_mB = p->zB * p->zB;
    const float t313 = p->zB * t295;
    const float P_delta_yaw_mB = p->xB * t295;
    const float M_22_mB = mu * P_delta_yaw_mB;
    const float t316 = p->zB * t309;
    const float C1_22_mB = (yaw_per_v_delta * P_delta_yaw_mB) + (mu * t295);
    const float t320 = sin_lam * t295;
    const float t321 = p->zB * yaw_per_v_delta;
    const float K2_22_mB = yaw_per_v_delta * t295;
    const float C1_22_xH = (mu * t172) - t195;
    const float t325 = sin_lam * t172;
    const float K2_22_xH = yaw_per_v_delta * t172;
    const float M_11_zH = t6 + t6;
    const float K0_12_mH = (p->zH * sin_lam) + (t36 * M_12_Jxz_delta) - t134;
    const float M_12_zH = (p->mH * K0_12_mH) + (t6 * sin_lam);
    const float t335 = sin_lam * t140;
    const float M_22_Jxx_delta = sin_lam * sin_lam;
    const float t340 = (p->zH * M_22_Jxx_delta) + (t36 * M_22_Jxz_delta) - t335;
    const float M_22_zH = (p->mH * t340) + (t6 * M_22_Jxx_delta);
    const float t344 = mu + t181;
    const float t346 = (t36 * yaw_per_v_delta) - t344;
    const float C1_12_zH = p->mH * t346;
    const float t348 = sin_lam * t181;
    const float t350 = (t36 * C1_22_Jxz_delta) - t348;
    const float K0_12_zH = p->mH * sin_lam;
    const float C1_22_zH = (p->mH * t350) - (mu * K0_12_zH);
    const float K0_22_zH = sin_lam * K0_12_zH;
    const float t356 = p->mH * yaw_per_v_delta;
    const float t357 = yaw_per_v_delta * K0_12_zH;
    const float M_11_mH = p->zH * p->zH;
    const float M_12_mH = p->zH * K0_12_mH;
    const float P_delta_yaw_mA = t34 * t134;
    const float M_22_mA = mu * P_delta_yaw_mA;
    const float M_22_mH = M_22_mA + (p->zH * t340) + (t36 * t149);
    const float C1_12_mH = p->zH * t346;
    const float C1_22_mA = yaw_per_v_delta * P_delta_yaw_mA;
    const float C1_22_mH = C1_22_mA + (p->zH * t350) + (t36 * t189) - (mu * K0_12_mH);
    const float K0_22_mH = sin_lam * K0_12_mH;
    const float t375 = p->zH * yaw_per_v_delta;
    const float t376 = yaw_per_v_delta * K0_12_mH;
    const float M_11_rF = t10 + t10;
    const float K0_12_mF = (p->c * M_12_Jxz_delta) - t134 - (p->rF * sin_lam);
    const float M_12_rF = (t10 * sin_lam) - (p->mF * K0_12_mF);
    const float t388 = t335 + (p->rF * M_22_Jxx_delta) - (p->c * M_22_Jxz_delta);
    const float M_22_rF = (p->mF * t388) + (t10 * M_22_Jxx_delta);
    const float t392 = t344 - mu;
    const float t394 = t95 * SF;
    const float C1_21_rF = M_12_Jxz_delta * t394;
    const float C1_12_rF = (p->mF * t392) - C1_21_rF;
    const float t398 = t348 - (p->c * C1_22_Jxz_delta);
    const float P_delta_lateral_rF = p->mF * sin_lam;
    const float C1_22_rF = (p->mF * t398) + (mu * P_delta_lateral_rF);
    const float t403 = sin_lam * P_delta_lateral_rF;
    const float K2_12_rF = (p->mF * yaw_per_v_delta) - (yaw_per_v_delta * t394);
    const float K2_22_rF = (yaw_per_v_delta * P_delta_lateral_rF) - (C1_22_Jxz_delta * t394);
    const float M_11_mF = p->rF * p->rF;
    const float t411 = p->rF * K0_12_mF;
    const float M_22_mF = M_22_mA + (p->c * t209) + (p->rF * t388);
    const float C1_12_mF = p->rF * t392;
    const float C1_22_mF = C1_22_mA + (p->c * t223) + (p->rF * t398) - (mu * K0_12_mF);
    const float K0_22_mF = sin_lam * K0_12_mF;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float t425 = yaw_per_v_delta * K0_12_mF;
    const float M_22_IFxx = M_22_Jzz_delta + M_22_Jxx_delta;
    const float C1_12_IFyy = t95 * M_12_Jxz_delta;
    const float K2_12_IFyy = yaw_per_v_delta * t95;
    const float K2_22_IFyy = t95 * C1_22_Jxz_delta;
    const float C1_21 = -(t97 + (mu * ST));
    const float K0_12_w = t172 - t171;
    const float K0_12_c = t229 - t228;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
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
    derivatives->values[0] = M_12_w;
    derivatives->values[1] = M_22_w;
    derivatives->values[2] = C1_12_w;
    derivatives->values[3] = C1_21_w;
    derivatives->values[4] = C1_22_w;
    derivatives->values[5] = K0_12_w;
    derivatives->values[6] = t199;
    derivatives->values[7] = t200;
    derivatives->values[8] = K2_22_w;
    derivatives->values[9] = M_12_c;
    derivatives->values[10] = M_22_c;
    derivatives->values[11] = C1_12_c;
    derivatives->values[12] = t220;
    derivatives->values[13] = C1_22_c;
    derivatives->values[14] = K0_12_c;
    derivatives->values[15] = t238;
    derivatives->values[16] = K2_22_c;
    derivatives->values[17] = M_12_lam;
    derivatives->values[18] = M_22_lam;
    derivatives->values[19] = t262;
    derivatives->values[20] = C1_21_lam;
    derivatives->values[21] = C1_22_lam;
    derivatives->values[22] = K0_12_lam;
    derivatives->values[23] = K0_22_lam;
    derivatives->values[24] = t277;
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
    derivatives->values[40] = t294;
    derivatives->values[41] = M_22_xB;
    derivatives->values[42] = t300;
    derivatives->values[43] = C1_22_xB;
    derivatives->values[44] = t302;
    derivatives->values[45] = t305;
    derivatives->values[46] = K2_22_xB;
    derivatives->values[47] = M_11_zB;
    derivatives->values[48] = t296;
    derivatives->values[49] = t310;
    derivatives->values[50] = p->mB;
    derivatives->values[51] = t311;
    derivatives->values[52] = M_11_mB;
    derivatives->values[53] = t313;
    derivatives->values[54] = M_22_mB;
    derivatives->values[55] = t316;
    derivatives->values[56] = C1_22_mB;
    derivatives->values[57] = p->zB;
    derivatives->values[58] = t295;
    derivatives->values[59] = t320;
    derivatives->values[60] = t321;
    derivatives->values[61] = K2_22_mB;
    derivatives->values[62] = mu;
    derivatives->values[63] = yaw_per_v_delta;
    derivatives->values[64] = t127;
    derivatives->values[65] = t156;
    derivatives->values[66] = t163;
    derivatives->values[67] = C1_22_xH;
    derivatives->values[68] = t172;
    derivatives->values[69] = t325;
    derivatives->values[70] = K2_22_xH;
    derivatives->values[71] = M_11_zH;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = M_22_zH;
    derivatives->values[74] = C1_12_zH;
    derivatives->values[75] = C1_22_zH;
    derivatives->values[76] = p->mH;
    derivatives->values[77] = K0_12_zH;
    derivatives->values[78] = K0_22_zH;
    derivatives->values[79] = t356;
    derivatives->values[80] = t357;
    derivatives->values[81] = M_11_mH;
    derivatives->values[82] = M_12_mH;
    derivatives->values[83] = M_22_mH;
    derivatives->values[84] = C1_12_mH;
    derivatives->values[85] = C1_22_mH;
    derivatives->values[86] = p->zH;
    derivatives->values[87] = K0_12_mH;
    derivatives->values[88] = K0_22_mH;
    derivatives->values[89] = t375;
    derivatives->values[90] = t376;
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
    derivatives->values[106] = t403;
    derivatives->values[107] = K2_12_rF;
    derivatives->values[108] = K2_22_rF;
    derivatives->values[109] = M_11_mF;
    derivatives->values[110] = t411;
    derivatives->values[111] = M_22_mF;
    derivatives->values[112] = C1_12_mF;
    derivatives->values[113] = C1_22_mF;
    derivatives->values[114] = p->rF;
    derivatives->values[115] = K0_12_mF;
    derivatives->values[116] = K0_22_mF;
    derivatives->values[117] = K2_12_mF;
    derivatives->values[118] = t425;
    derivatives->values[119] = M_22_IFxx;
    derivatives->values[120] = C1_12_IFyy;
    derivatives->values[121] = K2_12_IFyy;
    derivatives->values[122] = K2_22_IFyy;
}

void whipple_mechanism_f32_with_respect_to(const whipple_mechanism_f32_derivatives_t *derivatives,
    size_t parameter, whipple_mechanism_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHIPPLE_MECHANISM_N; row++) {
        for (size_t column = 0U; column < WHIPPLE_MECHANISM_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
            matrices->k2[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < WHIPPLE_MECHANISM_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &whipple_mechanism_partials[position];
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
