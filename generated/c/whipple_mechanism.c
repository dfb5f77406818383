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
#include <math.h>

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

const char *whipple_mechanism_position_name(whipple_mechanism_position_t which)
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

const char *whipple_mechanism_speed_name(whipple_mechanism_speed_t which)
{
    static const char *const TEXTS[] = {
        "phi",
        "delta",
        "thetaR",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such speed";
}

const char *whipple_mechanism_force_name(whipple_mechanism_force_t which)
{
    static const char *const TEXTS[] = {
        "Tphi",
        "Tdelta",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such force";
}

const char *whipple_mechanism_wheel_name(whipple_mechanism_wheel_t which)
{
    static const char *const TEXTS[] = {
        "R",
        "F",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such wheel";
}

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

void whipple_mechanism_f64_motion(const whipple_mechanism_f64_t *p,
    whipple_mechanism_f64_motion_t *motion)
{
    const double t2 = p->mB + p->mR;
    const double t18 = p->mH + p->mF;
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t25 = p->w + p->c;
    const double t28 = (cos_lam * t25) - (p->rR * sin_lam);
    const double t31 = (sin_lam * t25) + (p->rR * cos_lam);
    const double t32 = p->w - t25;
    const double t35 = (cos_lam * t32) + (p->rF * sin_lam);
    const double t38 = (sin_lam * t32) - (p->rF * cos_lam);
    const double t39 = t31 + t38;
    const double t41 = p->rR + p->zB;
    const double t43 = (p->xB * cos_lam) - (sin_lam * t41);
    const double t44 = p->mB * t43;
    const double t47 = (p->xB * sin_lam) + (cos_lam * t41);
    const double t48 = p->mB * t47;
    const double t50 = p->IBxz * cos_lam;
    const double t51 = (p->IBxx * sin_lam) + t50;
    const double t53 = p->IBxz * sin_lam;
    const double t55 = t53 + (p->IBzz * cos_lam);
    const double t59 = (cos_lam * t51) - (sin_lam * t55) - (t44 * t47);
    const double t61 = t47 * t48;
    const double t62 = t43 * t44;
    const double t64 = p->IByy + t61 + t62;
    const double t74 = t61 + p->IRxx + (cos_lam * ((p->IBxx * cos_lam) - t53)) - (sin_lam * (t50 -
        (p->IBzz * sin_lam)));
    const double t79 = t62 + p->IRxx + (sin_lam * t51) + (cos_lam * t55);
    const double t80 = p->xH - t25;
    const double t83 = (cos_lam * t80) - (p->zH * sin_lam);
    const double t84 = p->mH * t83;
    const double t85 = p->mF * t35;
    const double t86 = t84 + t85;
    const double t89 = (sin_lam * t80) + (p->zH * cos_lam);
    const double t90 = p->mH * t89;
    const double t91 = p->mF * t38;
    const double t92 = t90 + t91;
    const double t95 = p->IHxz * sin_lam;
    const double t98 = p->IHxz * cos_lam;
    const double t104 = (t89 * t90) + (t38 * t91);
    const double t107 = p->IFxx + (cos_lam * ((p->IHxx * cos_lam) - t95)) + t104 - (sin_lam * (t98 -
        (p->IHzz * sin_lam)));
    const double t109 = t98 + (p->IHxx * sin_lam);
    const double t112 = t95 + (p->IHzz * cos_lam);
    const double t118 = (cos_lam * t109) - (sin_lam * t112) - (t84 * t89) - (t38 * t85);
    const double t122 = (t83 * t84) + (t35 * t85);
    const double t124 = t104 + p->IHyy + t122;
    const double t129 = p->IFxx + t122 + (sin_lam * t109) + (cos_lam * t112);
    const double t131 = t107 - t124;
    const double t132 = t18 * t28;
    const double t133 = t31 * t92;
    const double t134 = t18 * t31;
    const double t137 = t133 + t133 + (t31 * t134);
    const double t138 = t28 * t92;
    const double t139 = t31 * t132;
    const double t140 = t28 * t132;
    const double t142 = t48 + t92 + t134;
    const double t144 = p->rR * (t2 + t18);
    const double t145 = p->rR * t144;
    motion->constants[0] = p->mB;
    motion->constants[1] = t2;
    motion->constants[2] = p->mH;
    motion->constants[3] = p->mF;
    motion->constants[4] = p->xB;
    motion->constants[5] = p->xH;
    motion->constants[6] = p->w;
    motion->constants[7] = p->rR;
    motion->constants[8] = p->zB;
    motion->constants[9] = p->zH;
    motion->constants[10] = p->rF;
    motion->constants[11] = p->IBxx;
    motion->constants[12] = p->IHxx;
    motion->constants[13] = p->IBxz;
    motion->constants[14] = p->IHxz;
    motion->constants[15] = p->IBzz;
    motion->constants[16] = p->IHzz;
    motion->constants[17] = t18;
    motion->constants[18] = p->c;
    motion->constants[19] = cos_lam;
    motion->constants[20] = sin_lam;
    motion->constants[21] = p->IRyy;
    motion->constants[22] = p->IFyy;
    motion->constants[23] = t28;
    motion->constants[24] = t31;
    motion->constants[25] = t35;
    motion->constants[26] = t38;
    motion->constants[27] = t39;
    motion->constants[28] = t44;
    motion->constants[29] = t48;
    motion->constants[30] = t59;
    motion->constants[31] = t64;
    motion->constants[32] = t74;
    motion->constants[33] = t79;
    motion->constants[34] = t86;
    motion->constants[35] = t92;
    motion->constants[36] = t107;
    motion->constants[37] = t118;
    motion->constants[38] = t124;
    motion->constants[39] = t129;
    motion->constants[40] = p->g;
    motion->constants[41] = t131;
    motion->constants[42] = t132;
    motion->constants[43] = t137;
    motion->constants[44] = t138;
    motion->constants[45] = t139;
    motion->constants[46] = t140;
    motion->constants[47] = t142;
    motion->constants[48] = t144;
    motion->constants[49] = t145;
    motion->constants[50] = t145;
}

static void whipple_mechanism_f64_compute_rates(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], double rates[WHIPPLE_MECHANISM_POSITIONS])
{
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t13 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t17 = t13 * cos_phi;
    const double t21 = (sin_phi * sin_delta) - (cos_delta * t17);
    const double t25 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
    const double t26 = cos_phi * t25;
    const double t29 = sqrt((t21 * t21) + (t26 * t26));
    const double t30 = 1.0 / t29;
    const double t31 = t21 * t30;
    const double t33 = t26 * t30;
    const double t34 = cos_delta * t33;
    const double t36 = (t25 * t34) - (t13 * t31);
    const double t41 = motion->constants[10] * ((sin_phi * cos_delta) + (t17 * sin_delta));
    const double t44 = sin_delta * motion->constants[25];
    const double t50 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const double t52 = (t25 * motion->constants[27]) - (t13 * t50);
    const double t55 = (cos_phi * t44) - (t36 * t41) - (sin_phi * t52);
    const double t56 = (motion->constants[7] * sin_phi) + t55;
    const double t63 = (cos_phi * sin_delta * t33) + (sin_phi * ((t25 * t31) + (t13 * t34)));
    const double t68 = (t41 * t63) + (t13 * motion->constants[27]) + (t25 * t50);
    const double t70 = 1.0 / (cos_phi * t68);
    const double t71 = t56 * t70;
    const double t77 = (t25 * motion->constants[24]) - (t13 * motion->constants[23]);
    const double t79 = t55 + (sin_phi * t77);
    const double t81 = sin_phi * t25;
    const double t85 = t68 - (t13 * motion->constants[24]) - (t25 * motion->constants[23]);
    const double t88 = t70 * ((t13 * t79) + (t81 * t85));
    const double t90 = (speeds[0] * t71) + (speeds[1] * t88);
    const double t92 = motion->constants[7] * (speeds[2] + t90);
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t98 = sin_phi * t68;
    const double t100 = sin_phi * t56;
    const double t102 = (t36 * t98) + (t63 * t100);
    const double t106 = 1.0 / ((t36 * t68) + (t56 * t63));
    const double t108 = t71 * t102 * t106;
    const double t117 = (t29 * motion->constants[10]) + (sin_phi * t44) + (cos_phi * t52) -
        (cos_phi * t77);
    const double t119 = (t26 * t85) - (t13 * t117);
    const double t123 = (t81 * t117) + (t26 * t79);
    const double t128 = t106 * ((t36 * t119) + (t63 * t123) + (t88 * t102));
    const double t131 = motion->constants[7] * t63 * t106;
    const double t137 = (t63 * t98) - (t36 * t100);
    const double t141 = (t63 * t68) - (t36 * t56);
    const double t144 = 1.0 / motion->constants[10];
    const double t161 = (speeds[0] * ((t108 * t141) - (t71 * t137)) * t144) + (speeds[1] * t144 *
        ((t36 * t123) + (t128 * t141) - (t63 * t119) - (t88 * t137)));
    const double t162 = t161 + (speeds[2] * t144 * ((motion->constants[7] * t36) + (t131 * t141)));
    const double t163 = -(t92 * cos_psi);
    const double t164 = -(t92 * sin_psi);
    const double t165 = -((speeds[0] * t108) + (speeds[1] * t128) + (speeds[2] * t131));
    rates[0] = t163;
    rates[1] = t164;
    rates[2] = t165;
    rates[3] = speeds[0];
    rates[4] = t90;
    rates[5] = speeds[1];
    rates[6] = speeds[2];
    rates[7] = t162;
}

carvallo_motion_error_t whipple_mechanism_f64_motion_rates(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], double rates[WHIPPLE_MECHANISM_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_MECHANISM_SPEEDS)) {
        whipple_mechanism_f64_compute_rates(motion, positions, speeds, rates);
        error = (carvallo_are_finite_f64(rates, WHIPPLE_MECHANISM_POSITIONS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_mechanism_f64_compute_derivatives(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], const double forces[WHIPPLE_MECHANISM_FORCES],
    double rates[WHIPPLE_MECHANISM_POSITIONS], double speed_rates[WHIPPLE_MECHANISM_SPEEDS])
{
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t13 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t17 = t13 * cos_phi;
    const double t21 = (sin_phi * sin_delta) - (cos_delta * t17);
    const double t25 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
    const double t26 = cos_phi * t25;
    const double t29 = sqrt((t21 * t21) + (t26 * t26));
    const double t30 = 1.0 / t29;
    const double t31 = t21 * t30;
    const double t33 = t26 * t30;
    const double t34 = cos_delta * t33;
    const double t36 = (t25 * t34) - (t13 * t31);
    const double t40 = (sin_phi * cos_delta) + (t17 * sin_delta);
    const double t41 = motion->constants[10] * t40;
    const double t44 = sin_delta * motion->constants[25];
    const double t50 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const double t52 = (t25 * motion->constants[27]) - (t13 * t50);
    const double t55 = (cos_phi * t44) - (t36 * t41) - (sin_phi * t52);
    const double t56 = (motion->constants[7] * sin_phi) + t55;
    const double t63 = (cos_phi * sin_delta * t33) + (sin_phi * ((t25 * t31) + (t13 * t34)));
    const double t68 = (t41 * t63) + (t13 * motion->constants[27]) + (t25 * t50);
    const double t70 = 1.0 / (cos_phi * t68);
    const double t71 = t56 * t70;
    const double t77 = (t25 * motion->constants[24]) - (t13 * motion->constants[23]);
    const double t79 = t55 + (sin_phi * t77);
    const double t81 = sin_phi * t25;
    const double t85 = t68 - (t13 * motion->constants[24]) - (t25 * motion->constants[23]);
    const double t88 = t70 * ((t13 * t79) + (t81 * t85));
    const double t90 = (speeds[0] * t71) + (speeds[1] * t88);
    const double t91 = speeds[2] + t90;
    const double t92 = motion->constants[7] * t91;
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t98 = sin_phi * t68;
    const double t100 = sin_phi * t56;
    const double t102 = (t36 * t98) + (t63 * t100);
    const double t106 = 1.0 / ((t36 * t68) + (t56 * t63));
    const double t108 = t71 * t102 * t106;
    const double t117 = (t29 * motion->constants[10]) + (sin_phi * t44) + (cos_phi * t52) -
        (cos_phi * t77);
    const double t119 = (t26 * t85) - (t13 * t117);
    const double t123 = (t81 * t117) + (t26 * t79);
    const double t128 = t106 * ((t36 * t119) + (t63 * t123) + (t88 * t102));
    const double t131 = motion->constants[7] * t63 * t106;
    const double t134 = (speeds[0] * t108) + (speeds[1] * t128) + (speeds[2] * t131);
    const double t137 = (t63 * t98) - (t36 * t100);
    const double t141 = (t63 * t68) - (t36 * t56);
    const double t144 = 1.0 / motion->constants[10];
    const double t145 = ((t108 * t141) - (t71 * t137)) * t144;
    const double t154 = t144 * ((t36 * t123) + (t128 * t141) - (t63 * t119) - (t88 * t137));
    const double t159 = t144 * ((motion->constants[7] * t36) + (t131 * t141));
    const double t162 = (speeds[0] * t145) + (speeds[1] * t154) + (speeds[2] * t159);
    const double t165 = cos_phi * t134;
    const double t167 = sin_phi * t134;
    const double t168 = motion->constants[7] * t167;
    const double t170 = (t165 * t168) - (t92 * t165);
    const double t173 = t170 + (sin_phi * motion->constants[40]);
    const double t178 = (speeds[0] * t13) - (t25 * t165);
    const double t179 = t90 * t178;
    const double t180 = speeds[0] * t167;
    const double t181 = t90 - t167;
    const double t182 = motion->constants[24] * t181;
    const double t186 = (speeds[0] * t25) + (t13 * t165);
    const double t187 = motion->constants[23] * t181;
    const double t189 = (t178 * t182) + (t186 * t187);
    const double t191 = t90 * t186;
    const double t192 = (t25 * t180) + t191;
    const double t195 = t179 + (t13 * t180);
    const double t199 = t189 + (motion->constants[23] * t192) + (motion->constants[24] * t195) -
        t170;
    const double t204 = (motion->constants[23] * t178) - (motion->constants[24] * t186);
    const double t206 = (t181 * t187) + (t178 * t204);
    const double t207 = speeds[0] * t165;
    const double t210 = motion->constants[7] * speeds[0];
    const double t211 = t165 * t210;
    const double t212 = (motion->constants[7] * t207) + t211;
    const double t217 = (t168 * (t91 - t167)) - (speeds[0] * t210);
    const double t221 = (t25 * t212) + (t13 * t217) - t206 - (motion->constants[24] * t207);
    const double t223 = speeds[1] + t178;
    const double t227 = (cos_delta * t181) - (sin_delta * t186);
    const double t228 = motion->constants[26] * t227;
    const double t232 = (cos_delta * t186) + (sin_delta * t181);
    const double t233 = motion->constants[25] * t227;
    const double t238 = speeds[1] * t227;
    const double t240 = t238 - (cos_delta * t195) - (sin_delta * t207);
    const double t242 = t31 * motion->constants[10];
    const double t246 = t33 * motion->constants[10];
    const double t254 = t30 * t40 * ((t31 * t232) + (t33 * t223));
    const double t255 = t246 * t254;
    const double t257 = t242 * t254;
    const double t263 = (cos_delta * t199) + (t223 * t228) + (t232 * t233) +
        (motion->constants[25] * t192) + (t242 * (t192 + (t162 * t232))) + (t223 * t255);
    const double t267 = t263 + (t232 * t257) - (sin_delta * t221) - (motion->constants[26] * t240) -
        (t246 * (t240 - (t162 * t223)));
    const double t274 = (motion->constants[25] * t223) - (motion->constants[26] * t232);
    const double t278 = speeds[1] * t232;
    const double t280 = (sin_delta * t195) - (cos_delta * t207) - t278;
    const double t283 = t162 + t227;
    const double t288 = motion->constants[10] * ((t31 * t223) - (t33 * t232));
    const double t294 = (cos_delta * t221) + (sin_delta * t199) + (motion->constants[26] * t280) +
        (t246 * t280) - (t227 * t233) - (t223 * t274);
    const double t296 = t294 - (t257 * t283) - (t223 * t288);
    const double t300 = (t186 * t204) - (t181 * t182);
    const double t314 = t300 + (motion->constants[23] * t207) + (t13 * t212) + (t232 * t274) +
        (t232 * t288) - (t25 * t217);
    const double t318 = t314 - (t227 * t228) - (motion->constants[25] * t280) - (t242 * t280) -
        (t255 * t283);
    const double t320 = (t31 * t296) + (t33 * t318);
    const double t325 = t70 * ((t40 * t267) + (t29 * t320));
    const double t329 = t106 * ((t29 * t267) + (t102 * t325) - (t40 * t320));
    const double t331 = t180 - (cos_phi * t329);
    const double t333 = t179 + (t13 * t331);
    const double t337 = t191 + (t25 * t331);
    const double t344 = (t181 * motion->constants[31]) + (motion->constants[21] * (speeds[2] +
        t181));
    const double t349 = (t186 * motion->constants[32]) + (motion->constants[30] * t178);
    const double t356 = t189 + (motion->constants[23] * t337) + (motion->constants[24] * t333) -
        t173;
    const double t360 = t325 - t207 - (sin_phi * t329);
    const double t363 = (motion->constants[7] * t360) - t211;
    const double t366 = t217 + (cos_phi * motion->constants[40]);
    const double t368 = (t13 * t366) - (t25 * t363);
    const double t370 = (motion->constants[24] * t360) + t368 - t206;
    const double t372 = (cos_delta * t356) - (sin_delta * t370);
    const double t378 = t238 + (sin_delta * t360) - (cos_delta * t333);
    const double t386 = (t227 * motion->constants[38]) + (t283 * motion->constants[22]);
    const double t391 = (t232 * motion->constants[36]) + (t223 * motion->constants[37]);
    const double t396 = (motion->constants[34] * t372) + (motion->constants[37] * t378) + (t337 *
        motion->constants[39]) + (t232 * t386) - (t227 * t391);
    const double t400 = (cos_delta * t370) + (sin_delta * t356);
    const double t406 = (cos_delta * t360) + (sin_delta * t333) - t278;
    const double t408 = t227 * motion->constants[34];
    const double t412 = (t223 * motion->constants[34]) - (t232 * motion->constants[35]);
    const double t416 = (motion->constants[17] * t400) + (motion->constants[35] * t406) - (t227 *
        t408) - (t223 * t412);
    const double t421 = t227 * motion->constants[35];
    const double t427 = (t372 * motion->constants[17]) + (t337 * motion->constants[34]) + (t223 *
        t421) + (t232 * t408) - (t378 * motion->constants[35]);
    const double t429 = (sin_delta * t416) + (cos_delta * t427);
    const double t435 = (motion->constants[33] * t337) + (t186 * t344) + t396 +
        (motion->constants[23] * t429) - (motion->constants[28] * t173) - (motion->constants[30] *
        t333);
    const double t436 = t435 - (t181 * t349);
    const double t444 = (motion->constants[30] * t186) + (t178 * motion->constants[33]);
    const double t452 = (t232 * motion->constants[37]) + (t223 * motion->constants[39]);
    const double t458 = (t378 * motion->constants[36]) + (t337 * motion->constants[37]) + (t227 *
        t452) - (t372 * motion->constants[35]) - (t223 * t386);
    const double t464 = (t25 * t366) + (t13 * t363);
    const double t466 = t300 - (motion->constants[23] * t360) - t464;
    const double t477 = t406 + (t144 * ((t31 * t318) + (t141 * t329) - (t33 * t296) - (t137 *
        t325)));
    const double t478 = motion->constants[22] * t477;
    const double t485 = (t400 * motion->constants[35]) + (motion->constants[38] * t406) + t478 +
        (t223 * t391) - (motion->constants[34] * t466) - (t232 * t452);
    const double t492 = (t173 * motion->constants[29]) + (motion->constants[30] * t337) + (t181 *
        t444) + (cos_delta * t458) - (t333 * motion->constants[32]) - (t178 * t344);
    const double t494 = t492 - (sin_delta * t485) - (motion->constants[24] * t429);
    const double t500 = t181 * motion->constants[29];
    const double t502 = motion->constants[28] * t181;
    const double t508 = t429 + (motion->constants[28] * t337) + (t333 * motion->constants[29]) +
        (t178 * t500) + (t186 * t502) - (t173 * motion->constants[1]);
    const double t511 = t71 - (sin_phi * t108);
    const double t521 = (cos_delta * t416) - (sin_delta * t427);
    const double t529 = (motion->constants[17] * t466) + (t232 * t412) - (motion->constants[34] *
        t406) - (t227 * t421);
    const double t536 = (motion->constants[28] * t178) - (t186 * motion->constants[29]);
    const double t543 = t13 * (t529 + (t186 * t536) - (t464 * motion->constants[1]) -
        (motion->constants[28] * t360) - (t181 * t500));
    const double t552 = t25 * (t521 + (t368 * motion->constants[1]) + (t360 *
        motion->constants[29]) - (t181 * t502) - (t178 * t536));
    const double t555 = (motion->constants[21] * t360) - (motion->constants[7] * (t543 + t552));
    const double t560 = (t368 * motion->constants[29]) + (motion->constants[28] * t464) +
        (motion->constants[31] * t360) + (t178 * t349) + (sin_delta * t458) + (cos_delta * t485);
    const double t564 = t560 + (motion->constants[24] * t521) + t555 - (t186 * t444) -
        (motion->constants[23] * t529);
    const double t566 = cos_phi * t108;
    const double t569 = (t25 * t436) - (t13 * t494);
    const double t576 = forces[0] + (t566 * t569) - (t13 * t436) - (t25 * t494) -
        (motion->constants[7] * t508) - (t511 * t564);
    const double t577 = t576 - (t145 * t478);
    const double t579 = sin_delta * motion->constants[41];
    const double t580 = sin_delta * t579;
    const double t584 = motion->constants[32] + motion->constants[36] + motion->constants[43] -
        t580;
    const double t585 = cos_delta * motion->constants[34];
    const double t586 = motion->constants[23] * t585;
    const double t589 = t586 + t586 + motion->constants[46];
    const double t591 = motion->constants[33] + motion->constants[39] + t589;
    const double t592 = t591 - t584;
    const double t593 = t13 * t13;
    const double t595 = t13 * t25;
    const double t600 = (cos_delta * motion->constants[37]) - (motion->constants[24] * t585);
    const double t603 = motion->constants[30] + t600 - motion->constants[44] -
        motion->constants[45];
    const double t604 = t603 + t603;
    const double t606 = (t592 * t593) + (t595 * t604);
    const double t611 = motion->constants[28] + t585 + motion->constants[42];
    const double t613 = (t25 * motion->constants[47]) - (t13 * t611);
    const double t614 = motion->constants[7] * t613;
    const double t617 = motion->constants[49] - t614 - t614;
    const double t619 = sin_delta * motion->constants[34];
    const double t621 = (sin_delta * motion->constants[37]) - (motion->constants[24] * t619);
    const double t625 = (cos_delta * t579) - (motion->constants[23] * t619);
    const double t627 = (t13 * t621) + (t25 * t625);
    const double t637 = t603 + (t592 * t595) + (motion->constants[7] * ((t13 *
        motion->constants[47]) + (t25 * t611))) - (t593 * t604);
    const double t643 = motion->constants[31] + motion->constants[38] + t580 +
        motion->constants[43] + t589 + t617;
    const double t647 = motion->constants[7] * t619;
    const double t649 = (t25 * t621) + t647 - (t13 * t625);
    const double t655 = t591 - t606;
    const double t660 = motion->constants[21] * t511;
    const double t664 = t13 * sin_delta;
    const double t668 = t145 + (cos_delta * t511) - (sin_delta * t25) - (t566 * t664);
    const double t669 = motion->constants[22] * t668;
    const double t675 = t584 + t606 + t617 + (t511 * t627) + (t511 * (t627 + (t511 * t643) - (t566 *
        t649))) + (t511 * t660);
    const double t678 = t675 + (t668 * t669) - (t566 * t637) - (t566 * (t637 + (t511 * t649) -
        (t566 * t655)));
    const double t679 = 1.0 / t678;
    const double t681 = motion->constants[39] + t586;
    const double t686 = t88 - (sin_phi * t128);
    const double t688 = cos_phi * t128;
    const double t690 = t25 * t647;
    const double t691 = t621 + t690;
    const double t695 = t691 + (t643 * t686) - (t649 * t688);
    const double t699 = (t25 * t681) - (t13 * t600);
    const double t703 = t699 + (t649 * t686) - (t655 * t688);
    const double t709 = t154 + (cos_delta * t686) - (t664 * t688);
    const double t715 = (t13 * t681) + (t25 * t600) + (motion->constants[7] * t585) + (t627 *
        t686) + (t511 * t695) + (t660 * t686);
    const double t719 = t679 * (t715 + (t669 * t709) - (t637 * t688) - (t566 * t703));
    const double t724 = motion->constants[21] * t686;
    const double t726 = motion->constants[22] * t709;
    const double t728 = t678 * t719;
    const double t734 = motion->constants[39] + (t686 * t695) + (t686 * t691) + (t686 * t724) +
        (t709 * t726) - (t688 * t703);
    const double t736 = t734 - (t688 * t699) - (t719 * t728);
    const double t737 = 1.0 / t736;
    const double t747 = forces[1] + (t569 * t688) - t396 - (t564 * t686) - (t154 * t478) - (t577 *
        t719);
    const double t751 = motion->constants[7] * (t613 - motion->constants[48]);
    const double t752 = sin_phi * t131;
    const double t754 = cos_phi * t131;
    const double t757 = t751 + (t643 * t752) + (t649 * t754);
    const double t762 = t647 - (t649 * t752) - (t655 * t754);
    const double t767 = 1.0 - t752;
    const double t772 = t159 - (cos_delta * t752) - (t664 * t754);
    const double t784 = (t660 * t767) + (t669 * t772) - (t627 * t752) - (t637 * t754) - (t511 *
        t757) - (t566 * t762);
    const double t785 = t679 * t784;
    const double t791 = t690 + (t724 * t767) + (t726 * t772) - (t686 * t757) - (t688 * t762) -
        (t691 * t752);
    const double t794 = t737 * (t791 - (t699 * t754) - (t728 * t785));
    const double t804 = (t564 * t752) + (t569 * t754) - t555 - (t159 * t478) - (t577 * t785) -
        (t747 * t794);
    const double t822 = (t752 * t757) + (t751 * t752) + motion->constants[50] +
        (motion->constants[21] * t767 * t767) + (motion->constants[22] * t772 * t772) - (t754 *
        t762);
    const double t826 = t804 / (t822 - (t647 * t754) - (t678 * t785 * t785) - (t736 * t794 * t794));
    const double t828 = (t737 * t747) - (t794 * t826);
    const double t832 = (t577 * t679) - (t719 * t828) - (t785 * t826);
    const double t833 = -(t92 * cos_psi);
    const double t834 = -(t92 * sin_psi);
    const double t835 = -t134;
    rates[0] = t833;
    rates[1] = t834;
    rates[2] = t835;
    rates[3] = speeds[0];
    rates[4] = t90;
    rates[5] = speeds[1];
    rates[6] = speeds[2];
    rates[7] = t162;
    speed_rates[0] = t832;
    speed_rates[1] = t828;
    speed_rates[2] = t826;
}

carvallo_motion_error_t whipple_mechanism_f64_motion_derivatives(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], const double forces[WHIPPLE_MECHANISM_FORCES],
    double rates[WHIPPLE_MECHANISM_POSITIONS], double speed_rates[WHIPPLE_MECHANISM_SPEEDS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_MECHANISM_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_MECHANISM_FORCES)) {
        whipple_mechanism_f64_compute_derivatives(motion, positions, speeds, forces, rates,
            speed_rates);
        error = (carvallo_are_finite_f64(rates, WHIPPLE_MECHANISM_POSITIONS) &&
            carvallo_are_finite_f64(speed_rates, WHIPPLE_MECHANISM_SPEEDS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_mechanism_f64_compute_accelerations(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], const double forces[WHIPPLE_MECHANISM_FORCES],
    double accelerations[WHIPPLE_MECHANISM_POSITIONS])
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
    const double t13 = (motion->constants[19] * sin_pitch) + (cos_pitch * motion->constants[20]);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t16 = cos_phi * t13;
    const double t21 = (sin_phi * sin_delta) - (cos_delta * t16);
    const double t25 = (motion->constants[19] * cos_pitch) - (motion->constants[20] * sin_pitch);
    const double t26 = cos_phi * t25;
    const double t29 = sqrt((t21 * t21) + (t26 * t26));
    const double t30 = 1.0 / t29;
    const double t31 = t21 * t30;
    const double t33 = t26 * t30;
    const double t34 = cos_delta * t33;
    const double t36 = (t25 * t34) - (t13 * t31);
    const double t43 = (cos_phi * sin_delta * t33) + (sin_phi * ((t25 * t31) + (t13 * t34)));
    const double t47 = (sin_phi * cos_delta) + (sin_delta * t16);
    const double t48 = motion->constants[10] * t47;
    const double t55 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const double t58 = (t43 * t48) + (t13 * motion->constants[27]) + (t25 * t55);
    const double t62 = sin_delta * motion->constants[25];
    const double t66 = (t25 * motion->constants[27]) - (t13 * t55);
    const double t69 = (cos_phi * t62) - (t36 * t48) - (sin_phi * t66);
    const double t70 = (motion->constants[7] * sin_phi) + t69;
    const double t73 = 1.0 / ((t36 * t58) + (t43 * t70));
    const double t74 = sin_phi * t58;
    const double t76 = sin_phi * t70;
    const double t78 = (t36 * t74) + (t43 * t76);
    const double t80 = 1.0 / (cos_phi * t58);
    const double t81 = t70 * t80;
    const double t83 = t73 * t78 * t81;
    const double t90 = t58 - (t13 * motion->constants[24]) - (t25 * motion->constants[23]);
    const double t97 = (t25 * motion->constants[24]) - (t13 * motion->constants[23]);
    const double t101 = (t29 * motion->constants[10]) + (sin_phi * t62) + (cos_phi * t66) -
        (cos_phi * t97);
    const double t103 = (t26 * t90) - (t13 * t101);
    const double t105 = sin_phi * t25;
    const double t108 = t69 + (sin_phi * t97);
    const double t110 = (t101 * t105) + (t26 * t108);
    const double t115 = t80 * ((t13 * t108) + (t90 * t105));
    const double t119 = t73 * ((t36 * t103) + (t43 * t110) + (t78 * t115));
    const double t122 = motion->constants[7] * t43 * t73;
    const double t126 = (speeds[0] * t83) + (speeds[1] * t119) + (t122 * speeds[2]);
    const double t127 = cos_phi * t126;
    const double t128 = speeds[0] * t127;
    const double t131 = (t13 * speeds[0]) - (t25 * t127);
    const double t134 = (speeds[0] * t81) + (speeds[1] * t115);
    const double t135 = sin_phi * t126;
    const double t136 = t134 - t135;
    const double t137 = motion->constants[24] * t136;
    const double t141 = (t25 * speeds[0]) + (t13 * t127);
    const double t142 = motion->constants[23] * t136;
    const double t144 = (t131 * t137) + (t141 * t142);
    const double t145 = speeds[0] * t135;
    const double t147 = t134 * t141;
    const double t148 = (t25 * t145) + t147;
    const double t151 = t131 * t134;
    const double t152 = (t13 * t145) + t151;
    const double t154 = speeds[2] + t134;
    const double t155 = motion->constants[7] * t154;
    const double t157 = motion->constants[7] * t135;
    const double t159 = (t127 * t157) - (t127 * t155);
    const double t162 = t144 + (motion->constants[23] * t148) + (motion->constants[24] * t152) -
        t159;
    const double t167 = (motion->constants[23] * t131) - (motion->constants[24] * t141);
    const double t169 = (t136 * t142) + (t131 * t167);
    const double t171 = motion->constants[7] * speeds[0];
    const double t172 = t127 * t171;
    const double t174 = t172 + (motion->constants[7] * t128);
    const double t179 = (t157 * (t154 - t135)) - (speeds[0] * t171);
    const double t183 = (t25 * t174) + (t13 * t179) - t169 - (motion->constants[24] * t128);
    const double t185 = speeds[1] + t131;
    const double t189 = (cos_delta * t136) - (sin_delta * t141);
    const double t190 = motion->constants[26] * t189;
    const double t194 = (cos_delta * t141) + (sin_delta * t136);
    const double t195 = motion->constants[25] * t189;
    const double t200 = speeds[1] * t189;
    const double t202 = t200 - (cos_delta * t152) - (sin_delta * t128);
    const double t204 = t31 * motion->constants[10];
    const double t207 = (t43 * t74) - (t36 * t76);
    const double t211 = (t43 * t58) - (t36 * t70);
    const double t214 = 1.0 / motion->constants[10];
    const double t215 = ((t83 * t211) - (t81 * t207)) * t214;
    const double t224 = t214 * ((t36 * t110) + (t119 * t211) - (t43 * t103) - (t115 * t207));
    const double t229 = t214 * ((motion->constants[7] * t36) + (t122 * t211));
    const double t232 = (speeds[0] * t215) + (speeds[1] * t224) + (speeds[2] * t229);
    const double t236 = t33 * motion->constants[10];
    const double t244 = t30 * t47 * ((t31 * t194) + (t33 * t185));
    const double t245 = t236 * t244;
    const double t247 = t204 * t244;
    const double t253 = (cos_delta * t162) + (t185 * t190) + (t194 * t195) +
        (motion->constants[25] * t148) + (t204 * (t148 + (t194 * t232))) + (t185 * t245);
    const double t257 = t253 + (t194 * t247) - (sin_delta * t183) - (motion->constants[26] * t202) -
        (t236 * (t202 - (t185 * t232)));
    const double t264 = (motion->constants[25] * t185) - (motion->constants[26] * t194);
    const double t268 = speeds[1] * t194;
    const double t270 = (sin_delta * t152) - (cos_delta * t128) - t268;
    const double t273 = t189 + t232;
    const double t278 = motion->constants[10] * ((t31 * t185) - (t33 * t194));
    const double t284 = (cos_delta * t183) + (sin_delta * t162) + (motion->constants[26] * t270) +
        (t236 * t270) - (t189 * t195) - (t185 * t264);
    const double t286 = t284 - (t247 * t273) - (t185 * t278);
    const double t290 = (t141 * t167) - (t136 * t137);
    const double t304 = t290 + (motion->constants[23] * t128) + (t13 * t174) + (t194 * t264) +
        (t194 * t278) - (t25 * t179);
    const double t308 = t304 - (t189 * t190) - (motion->constants[25] * t270) - (t204 * t270) -
        (t245 * t273);
    const double t310 = (t31 * t286) + (t33 * t308);
    const double t313 = t80 * ((t47 * t257) + (t29 * t310));
    const double t319 = t73 * ((t29 * t257) + (t78 * t313) - (t47 * t310));
    const double t322 = t313 - t128 - (sin_phi * t319);
    const double t327 = t179 + (cos_phi * motion->constants[40]);
    const double t330 = (motion->constants[7] * t322) - t172;
    const double t332 = (t25 * t327) + (t13 * t330);
    const double t335 = t290 - t332 - (motion->constants[23] * t322);
    const double t341 = t145 - (cos_phi * t319);
    const double t343 = t151 + (t13 * t341);
    const double t346 = (cos_delta * t322) + (sin_delta * t343) - t268;
    const double t351 = (t185 * motion->constants[34]) - (t194 * motion->constants[35]);
    const double t353 = t189 * motion->constants[35];
    const double t357 = (t335 * motion->constants[17]) + (t194 * t351) - (motion->constants[34] *
        t346) - (t189 * t353);
    const double t365 = (t131 * motion->constants[28]) - (motion->constants[29] * t141);
    const double t367 = motion->constants[29] * t136;
    const double t373 = t13 * (t357 + (t141 * t365) - (t332 * motion->constants[1]) - (t322 *
        motion->constants[28]) - (t136 * t367));
    const double t376 = (t13 * t327) - (t25 * t330);
    const double t379 = t376 + (motion->constants[24] * t322) - t169;
    const double t382 = t147 + (t25 * t341);
    const double t386 = t159 + (sin_phi * motion->constants[40]);
    const double t389 = t144 + (motion->constants[23] * t382) + (motion->constants[24] * t343) -
        t386;
    const double t391 = (cos_delta * t379) + (sin_delta * t389);
    const double t394 = t189 * motion->constants[34];
    const double t399 = (t391 * motion->constants[17]) + (motion->constants[35] * t346) - (t189 *
        t394) - (t185 * t351);
    const double t403 = (cos_delta * t389) - (sin_delta * t379);
    const double t409 = t200 + (sin_delta * t322) - (cos_delta * t343);
    const double t416 = (t403 * motion->constants[17]) + (t382 * motion->constants[34]) + (t185 *
        t353) + (t194 * t394) - (motion->constants[35] * t409);
    const double t418 = (cos_delta * t399) - (sin_delta * t416);
    const double t421 = t136 * motion->constants[28];
    const double t428 = t25 * (t418 + (t376 * motion->constants[1]) + (motion->constants[29] *
        t322) - (t136 * t421) - (t131 * t365));
    const double t431 = (t322 * motion->constants[21]) - (motion->constants[7] * (t373 + t428));
    const double t432 = sin_phi * t122;
    const double t441 = (t141 * motion->constants[32]) + (t131 * motion->constants[30]);
    const double t446 = (t141 * motion->constants[30]) + (t131 * motion->constants[33]);
    const double t456 = (t194 * motion->constants[37]) + (t185 * motion->constants[39]);
    const double t462 = (t189 * motion->constants[38]) + (t273 * motion->constants[22]);
    const double t467 = (motion->constants[36] * t409) + (t382 * motion->constants[37]) + (t189 *
        t456) - (motion->constants[35] * t403) - (t185 * t462);
    const double t479 = t214 * ((t31 * t308) + (t211 * t319) - (t33 * t286) - (t207 * t313));
    const double t481 = motion->constants[22] * (t346 + t479);
    const double t484 = (t194 * motion->constants[36]) + (t185 * motion->constants[37]);
    const double t491 = (motion->constants[35] * t391) + (motion->constants[38] * t346) + t481 +
        (t185 * t484) - (motion->constants[34] * t335) - (t194 * t456);
    const double t499 = (motion->constants[29] * t376) + (motion->constants[28] * t332) + (t322 *
        motion->constants[31]) + (t131 * t441) + (sin_delta * t467) + (cos_delta * t491);
    const double t503 = t499 + (motion->constants[24] * t418) + t431 - (t141 * t446) -
        (motion->constants[23] * t357);
    const double t505 = cos_phi * t122;
    const double t512 = (t136 * motion->constants[31]) + (motion->constants[21] * (speeds[2] +
        t136));
    const double t523 = (t403 * motion->constants[34]) + (t409 * motion->constants[37]) + (t382 *
        motion->constants[39]) + (t194 * t462) - (t189 * t484);
    const double t526 = (sin_delta * t399) + (cos_delta * t416);
    const double t532 = (motion->constants[33] * t382) + (t141 * t512) + t523 +
        (motion->constants[23] * t526) - (motion->constants[28] * t386) - (motion->constants[30] *
        t343);
    const double t533 = t532 - (t136 * t441);
    const double t547 = (motion->constants[29] * t386) + (motion->constants[30] * t382) + (t136 *
        t446) + (cos_delta * t467) - (motion->constants[32] * t343) - (t131 * t512);
    const double t549 = t547 - (sin_delta * t491) - (motion->constants[24] * t526);
    const double t551 = (t25 * t533) - (t13 * t549);
    const double t566 = t526 + (motion->constants[28] * t382) + (motion->constants[29] * t343) +
        (t131 * t367) + (t141 * t421) - (t386 * motion->constants[1]);
    const double t569 = t81 - (sin_phi * t83);
    const double t571 = cos_phi * t83;
    const double t578 = forces[0] + (t551 * t571) - (t13 * t533) - (t25 * t549) -
        (motion->constants[7] * t566) - (t503 * t569);
    const double t579 = t578 - (t215 * t481);
    const double t581 = sin_delta * motion->constants[34];
    const double t583 = (sin_delta * motion->constants[37]) - (motion->constants[24] * t581);
    const double t586 = sin_delta * motion->constants[41];
    const double t589 = (cos_delta * t586) - (motion->constants[23] * t581);
    const double t591 = (t13 * t583) + (t25 * t589);
    const double t596 = cos_delta * motion->constants[34];
    const double t598 = (cos_delta * motion->constants[37]) - (motion->constants[24] * t596);
    const double t601 = motion->constants[30] + t598 - motion->constants[44] -
        motion->constants[45];
    const double t602 = sin_delta * t586;
    const double t606 = motion->constants[32] + motion->constants[36] + motion->constants[43] -
        t602;
    const double t607 = motion->constants[23] * t596;
    const double t610 = t607 + t607 + motion->constants[46];
    const double t612 = motion->constants[33] + motion->constants[39] + t610;
    const double t613 = t612 - t606;
    const double t614 = t25 * t13;
    const double t616 = t13 * t13;
    const double t617 = t601 + t601;
    const double t623 = motion->constants[28] + t596 + motion->constants[42];
    const double t629 = t601 + (t613 * t614) + (motion->constants[7] * ((t13 *
        motion->constants[47]) + (t25 * t623))) - (t616 * t617);
    const double t633 = (t25 * motion->constants[47]) - (t13 * t623);
    const double t636 = motion->constants[7] * (t633 - motion->constants[48]);
    const double t637 = motion->constants[7] * t633;
    const double t640 = motion->constants[49] - t637 - t637;
    const double t645 = motion->constants[31] + motion->constants[38] + t602 +
        motion->constants[43] + t610 + t640;
    const double t649 = motion->constants[7] * t581;
    const double t651 = (t25 * t583) + t649 - (t13 * t589);
    const double t654 = t636 + (t432 * t645) + (t505 * t651);
    const double t659 = (t613 * t616) + (t614 * t617);
    const double t660 = t612 - t659;
    const double t663 = t649 - (t432 * t651) - (t505 * t660);
    const double t666 = 1.0 - t432;
    const double t667 = motion->constants[21] * t569;
    const double t670 = sin_delta * t13;
    const double t673 = t229 - (cos_delta * t432) - (t505 * t670);
    const double t679 = t215 + (cos_delta * t569) - (sin_delta * t25) - (t571 * t670);
    const double t680 = motion->constants[22] * t679;
    const double t686 = (t666 * t667) + (t673 * t680) - (t432 * t591) - (t505 * t629) - (t569 *
        t654) - (t571 * t663);
    const double t705 = t606 + t640 + t659 + (t569 * t591) + (t569 * (t591 + (t569 * t645) - (t571 *
        t651))) + (t569 * t667);
    const double t708 = t705 + (t679 * t680) - (t571 * t629) - (t571 * (t629 + (t569 * t651) -
        (t571 * t660)));
    const double t709 = 1.0 / t708;
    const double t710 = t686 * t709;
    const double t712 = t25 * t649;
    const double t714 = t115 - (sin_phi * t119);
    const double t716 = cos_phi * t119;
    const double t718 = t583 + t712;
    const double t720 = motion->constants[39] + t607;
    const double t723 = (t25 * t720) - (t13 * t598);
    const double t725 = motion->constants[21] * t714;
    const double t730 = t224 + (cos_delta * t714) - (t670 * t716);
    const double t731 = motion->constants[22] * t730;
    const double t741 = t718 + (t645 * t714) - (t651 * t716);
    const double t746 = t723 + (t651 * t714) - (t660 * t716);
    const double t754 = (t13 * t720) + (t25 * t598) + (motion->constants[7] * t596) + (t591 *
        t714) + (t569 * t741) + (t667 * t714);
    const double t758 = t709 * (t754 + (t680 * t730) - (t629 * t716) - (t571 * t746));
    const double t759 = t708 * t758;
    const double t765 = t712 + (t666 * t725) + (t673 * t731) - (t654 * t714) - (t663 * t716) -
        (t432 * t718);
    const double t779 = motion->constants[39] + (t714 * t741) + (t714 * t718) + (t714 * t725) +
        (t730 * t731) - (t716 * t746);
    const double t781 = t779 - (t716 * t723) - (t758 * t759);
    const double t782 = 1.0 / t781;
    const double t783 = (t765 - (t505 * t723) - (t710 * t759)) * t782;
    const double t793 = forces[1] + (t551 * t716) - t523 - (t503 * t714) - (t224 * t481) - (t579 *
        t758);
    const double t799 = (t432 * t503) + (t505 * t551) - t431 - (t229 * t481) - (t579 * t710) -
        (t783 * t793);
    const double t817 = (t432 * t654) + (t432 * t636) + motion->constants[50] +
        (motion->constants[21] * t666 * t666) + (motion->constants[22] * t673 * t673) - (t505 *
        t663);
    const double t821 = t799 / (t817 - (t505 * t649) - (t708 * t710 * t710) - (t781 * t783 * t783));
    const double t825 = (t782 * t793) - (t783 * t821);
    const double t829 = (t579 * t709) - (t758 * t825) - (t710 * t821);
    const double t833 = t313 + (t81 * t829) + (t115 * t825);
    const double t835 = motion->constants[7] * (t821 + t833);
    const double t838 = t126 * t155;
    const double t843 = (cos_psi * t838) - (t835 * sin_psi);
    const double t855 = t479 + (t215 * t829) + (t224 * t825) + (t229 * t821);
    const double t856 = -((cos_psi * t835) + (sin_psi * t838));
    const double t857 = -(t319 + (t83 * t829) + (t119 * t825) + (t122 * t821));
    accelerations[0] = t856;
    accelerations[1] = t843;
    accelerations[2] = t857;
    accelerations[3] = t829;
    accelerations[4] = t833;
    accelerations[5] = t825;
    accelerations[6] = t821;
    accelerations[7] = t855;
}

carvallo_motion_error_t whipple_mechanism_f64_motion_accelerations(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], const double forces[WHIPPLE_MECHANISM_FORCES],
    double accelerations[WHIPPLE_MECHANISM_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_MECHANISM_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_MECHANISM_FORCES)) {
        whipple_mechanism_f64_compute_accelerations(motion, positions, speeds, forces,
            accelerations);
        error = (carvallo_are_finite_f64(accelerations, WHIPPLE_MECHANISM_POSITIONS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_mechanism_f64_compute_energy(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], double energy[2])
{
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t6 = sin_delta * motion->constants[41];
    const double t7 = sin_delta * t6;
    const double t11 = motion->constants[32] + motion->constants[36] + motion->constants[43] - t7;
    const double t17 = cos_delta * motion->constants[34];
    const double t18 = motion->constants[23] * t17;
    const double t21 = t18 + t18 + motion->constants[46];
    const double t23 = motion->constants[33] + motion->constants[39] + t21;
    const double t24 = t23 - t11;
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t32 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    const double t33 = t32 * t32;
    const double t37 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
    const double t38 = t32 * t37;
    const double t46 = (cos_delta * motion->constants[37]) - (t17 * motion->constants[24]);
    const double t49 = motion->constants[30] + t46 - motion->constants[44] - motion->constants[45];
    const double t50 = t49 + t49;
    const double t52 = (t24 * t33) + (t38 * t50);
    const double t59 = t17 + motion->constants[28] + motion->constants[42];
    const double t61 = (t37 * motion->constants[47]) - (t32 * t59);
    const double t62 = motion->constants[7] * t61;
    const double t65 = motion->constants[49] - t62 - t62;
    const double t67 = sin_delta * motion->constants[34];
    const double t69 = (sin_delta * motion->constants[37]) - (motion->constants[24] * t67);
    const double t73 = (t6 * cos_delta) - (motion->constants[23] * t67);
    const double t75 = (t32 * t69) + (t37 * t73);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t80 = t32 * cos_phi;
    const double t83 = (sin_delta * sin_phi) - (cos_delta * t80);
    const double t85 = t37 * cos_phi;
    const double t88 = sqrt((t83 * t83) + (t85 * t85));
    const double t89 = 1.0 / t88;
    const double t90 = t83 * t89;
    const double t92 = t85 * t89;
    const double t93 = cos_delta * t92;
    const double t95 = (t37 * t93) - (t32 * t90);
    const double t100 = motion->constants[10] * ((cos_delta * sin_phi) + (sin_delta * t80));
    const double t103 = sin_delta * motion->constants[25];
    const double t108 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const double t110 = (t37 * motion->constants[27]) - (t32 * t108);
    const double t113 = (cos_phi * t103) - (t95 * t100) - (sin_phi * t110);
    const double t114 = (motion->constants[7] * sin_phi) + t113;
    const double t121 = (sin_delta * cos_phi * t92) + (sin_phi * ((t37 * t90) + (t32 * t93)));
    const double t126 = (t100 * t121) + (t32 * motion->constants[27]) + (t37 * t108);
    const double t128 = 1.0 / (cos_phi * t126);
    const double t129 = t114 * t128;
    const double t130 = sin_phi * t126;
    const double t132 = sin_phi * t114;
    const double t134 = (t95 * t130) + (t121 * t132);
    const double t138 = 1.0 / ((t95 * t126) + (t114 * t121));
    const double t140 = t129 * t134 * t138;
    const double t142 = t129 - (sin_phi * t140);
    const double t152 = t49 + (t24 * t38) + (motion->constants[7] * ((t32 * motion->constants[47]) +
        (t37 * t59))) - (t33 * t50);
    const double t153 = cos_phi * t140;
    const double t161 = t7 + motion->constants[43] + t21 + t65 + motion->constants[31] +
        motion->constants[38];
    const double t165 = motion->constants[7] * t67;
    const double t167 = (t37 * t69) + t165 - (t32 * t73);
    const double t173 = t23 - t52;
    const double t179 = t142 * motion->constants[21];
    const double t183 = (t121 * t130) - (t95 * t132);
    const double t187 = (t121 * t126) - (t95 * t114);
    const double t190 = 1.0 / motion->constants[10];
    const double t194 = sin_delta * t32;
    const double t198 = (((t140 * t187) - (t129 * t183)) * t190) + (cos_delta * t142) - (sin_delta *
        t37) - (t153 * t194);
    const double t200 = t198 * motion->constants[22];
    const double t206 = t11 + t52 + t65 + (t75 * t142) + (t142 * (t75 + (t142 * t161) - (t153 *
        t167))) + (t142 * t179);
    const double t210 = speeds[0] * (t206 + (t198 * t200) - (t152 * t153) - (t153 * (t152 + (t142 *
        t167) - (t153 * t173))));
    const double t212 = motion->constants[39] + t18;
    const double t218 = (t37 * motion->constants[24]) - (motion->constants[23] * t32);
    const double t220 = t113 + (sin_phi * t218);
    const double t222 = t37 * sin_phi;
    const double t226 = t126 - (t32 * motion->constants[24]) - (motion->constants[23] * t37);
    const double t229 = t128 * ((t32 * t220) + (t222 * t226));
    const double t237 = (t88 * motion->constants[10]) + (sin_phi * t103) + (cos_phi * t110) -
        (cos_phi * t218);
    const double t239 = (t85 * t226) - (t32 * t237);
    const double t243 = (t222 * t237) + (t85 * t220);
    const double t248 = t138 * ((t95 * t239) + (t121 * t243) + (t134 * t229));
    const double t250 = t229 - (sin_phi * t248);
    const double t252 = cos_phi * t248;
    const double t254 = t37 * t165;
    const double t255 = t69 + t254;
    const double t259 = t255 + (t161 * t250) - (t167 * t252);
    const double t263 = (t37 * t212) - (t32 * t46);
    const double t267 = t263 + (t167 * t250) - (t173 * t252);
    const double t280 = (t190 * ((t95 * t243) + (t187 * t248) - (t121 * t239) - (t183 * t229))) +
        (cos_delta * t250);
    const double t281 = t280 - (t194 * t252);
    const double t287 = (t32 * t212) + (t37 * t46) + (t17 * motion->constants[7]) + (t75 * t250) +
        (t142 * t259) + (t179 * t250);
    const double t290 = t287 + (t200 * t281) - (t152 * t252) - (t153 * t267);
    const double t294 = motion->constants[7] * t121 * t138;
    const double t295 = sin_phi * t294;
    const double t297 = cos_phi * t294;
    const double t300 = t61 - motion->constants[48];
    const double t301 = motion->constants[7] * t300;
    const double t305 = t301 + (t161 * t295) + (t167 * t297);
    const double t310 = t165 - (t167 * t295) - (t173 * t297);
    const double t313 = 1.0 - t295;
    const double t322 = (t190 * ((motion->constants[7] * t95) + (t187 * t294))) - (cos_delta *
        t295) - (t194 * t297);
    const double t328 = (t179 * t313) + (t200 * t322) - (t75 * t295) - (t152 * t297) - (t142 *
        t305) - (t153 * t310);
    const double t338 = motion->constants[21] * t250;
    const double t340 = motion->constants[22] * t281;
    const double t346 = motion->constants[39] + (t250 * t259) + (t250 * t255) + (t250 * t338) +
        (t281 * t340) - (t252 * t267);
    const double t359 = t254 + (t313 * t338) + (t322 * t340) - (t250 * t305) - (t252 * t310) -
        (t255 * t295);
    const double t360 = t359 - (t263 * t297);
    const double t364 = speeds[1] * ((speeds[0] * t290) + (speeds[1] * (t346 - (t252 * t263))) +
        (speeds[2] * t360));
    const double t380 = (t295 * t305) + (t295 * t301) + motion->constants[50] +
        (motion->constants[21] * t313 * t313) + (motion->constants[22] * t322 * t322) - (t297 *
        t310);
    const double t387 = (speeds[0] * (t210 + (speeds[1] * t290) + (speeds[2] * t328))) + t364 +
        (speeds[2] * ((speeds[0] * t328) + (speeds[1] * t360) + (speeds[2] * (t380 - (t165 *
        t297)))));
    const double t389 = t387 * 0.5;
    const double t395 = -(motion->constants[40] * ((t67 * sin_phi) + (cos_phi * t300)));
    energy[0] = t389;
    energy[1] = t395;
}

carvallo_motion_error_t whipple_mechanism_f64_motion_energy(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], double energy[2])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_MECHANISM_SPEEDS)) {
        whipple_mechanism_f64_compute_energy(motion, positions, speeds, energy);
        error = (carvallo_are_finite_f64(energy, 2U)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

/* How far the lowest points of the wheels behind the first are below the ground, and the steps of Newton's method. */
static void whipple_mechanism_f64_compute_closure(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS], double below[1U], double steps[1U])
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
    const double t14 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    const double t15 = cos_phi * t14;
    const double t19 = sin_phi * sin_delta;
    const double t20 = t19 - (cos_delta * t15);
    const double t24 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
    const double t25 = cos_phi * t24;
    const double t28 = sqrt((t20 * t20) + (t25 * t25));
    const double t36 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const double t42 = (motion->constants[10] * t28) + (t19 * motion->constants[25]) + (cos_phi *
        ((t24 * motion->constants[27]) - (t14 * t36))) - (motion->constants[7] * cos_phi);
    const double t46 = 1.0 / t28;
    const double t47 = t25 * t46;
    const double t58 = motion->constants[10] * ((cos_delta * sin_phi) + (t15 * sin_delta)) *
        ((cos_phi * sin_delta * t47) + (sin_phi * ((t20 * t24 * t46) + (cos_delta * t14 * t47))));
    const double t64 = t42 / (cos_phi * (t58 + (t14 * motion->constants[27]) + (t24 * t36)));
    below[0] = t42;
    steps[0] = t64;
}

carvallo_motion_error_t whipple_mechanism_f64_motion_close(const whipple_mechanism_f64_motion_t *motion,
    double positions[WHIPPLE_MECHANISM_POSITIONS])
{
    /* The positions that the heights of the wheels determine. */
    static const size_t DEPENDENT[1U] = {4U};
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_MECHANISM_POSITIONS)) {
        double found[WHIPPLE_MECHANISM_POSITIONS];
        double below[1U];
        double steps[1U];
        double shortest = 1e30;
        bool is_closed = false;
        bool goes_on = true;
        for (size_t i = 0U; i < WHIPPLE_MECHANISM_POSITIONS; i++) {
            found[i] = positions[i];
        }
        /* With steps of the greatest length they lead around the whole circle; near a solution a handful is enough. */
        for (size_t count = 0U; goes_on && (count < 60U); count++) {
            whipple_mechanism_f64_compute_closure(motion, found, below, steps);
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
            whipple_mechanism_f64_compute_closure(motion, found, below, steps);
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

static void whipple_mechanism_f64_compute_contact_forces(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], const double forces[WHIPPLE_MECHANISM_FORCES],
    double contact_forces[3U * WHIPPLE_MECHANISM_WHEELS])
{
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t9 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    const double t13 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
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
    const double t48 = motion->constants[10] * t47;
    const double t55 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const double t58 = (t43 * t48) + (t9 * motion->constants[27]) + (t13 * t55);
    const double t59 = sin_phi * t58;
    const double t64 = sin_delta * motion->constants[25];
    const double t68 = (t13 * motion->constants[27]) - (t9 * t55);
    const double t71 = (cos_phi * t64) - (t36 * t48) - (sin_phi * t68);
    const double t72 = (sin_phi * motion->constants[7]) + t71;
    const double t73 = sin_phi * t72;
    const double t75 = (t36 * t59) + (t43 * t73);
    const double t77 = 1.0 / (cos_phi * t58);
    const double t78 = t72 * t77;
    const double t82 = 1.0 / ((t36 * t58) + (t43 * t72));
    const double t84 = t75 * t78 * t82;
    const double t91 = t58 - (t9 * motion->constants[24]) - (t13 * motion->constants[23]);
    const double t98 = (t13 * motion->constants[24]) - (t9 * motion->constants[23]);
    const double t102 = (t29 * motion->constants[10]) + (sin_phi * t64) + (cos_phi * t68) -
        (cos_phi * t98);
    const double t104 = (t26 * t91) - (t9 * t102);
    const double t106 = t13 * sin_phi;
    const double t109 = t71 + (sin_phi * t98);
    const double t111 = (t102 * t106) + (t26 * t109);
    const double t116 = t77 * ((t9 * t109) + (t91 * t106));
    const double t120 = t82 * ((t36 * t104) + (t43 * t111) + (t75 * t116));
    const double t124 = t43 * motion->constants[7] * t82;
    const double t127 = (speeds[0] * t84) + (speeds[1] * t120) + (speeds[2] * t124);
    const double t128 = cos_phi * t127;
    const double t130 = (speeds[0] * t13) + (t9 * t128);
    const double t133 = (t9 * speeds[0]) - (t13 * t128);
    const double t138 = (t133 * motion->constants[28]) - (t130 * motion->constants[29]);
    const double t142 = (speeds[0] * t78) + (speeds[1] * t116);
    const double t143 = sin_phi * t127;
    const double t144 = t142 - t143;
    const double t145 = motion->constants[29] * t144;
    const double t147 = (t130 * t138) - (t144 * t145);
    const double t149 = speeds[0] * motion->constants[7];
    const double t151 = speeds[2] + t142;
    const double t153 = motion->constants[7] * t143;
    const double t155 = ((t151 - t143) * t153) - (speeds[0] * t149);
    const double t158 = t155 + (cos_phi * motion->constants[40]);
    const double t159 = t13 * t158;
    const double t160 = t128 * t149;
    const double t161 = motion->constants[24] * t144;
    const double t163 = motion->constants[23] * t144;
    const double t165 = (t133 * t161) + (t130 * t163);
    const double t166 = speeds[0] * t143;
    const double t168 = t130 * t142;
    const double t169 = (t13 * t166) + t168;
    const double t172 = t133 * t142;
    const double t173 = (t9 * t166) + t172;
    const double t175 = t128 * t151;
    const double t177 = t128 * t153;
    const double t178 = t177 - (motion->constants[7] * t175);
    const double t181 = t165 + (motion->constants[23] * t169) + (motion->constants[24] * t173) -
        t178;
    const double t186 = (motion->constants[23] * t133) - (motion->constants[24] * t130);
    const double t188 = (t144 * t163) + (t133 * t186);
    const double t189 = speeds[0] * t128;
    const double t192 = t160 + (motion->constants[7] * t189);
    const double t197 = (t13 * t192) + (t9 * t155) - t188 - (motion->constants[24] * t189);
    const double t199 = speeds[1] + t133;
    const double t203 = (cos_delta * t144) - (sin_delta * t130);
    const double t204 = motion->constants[26] * t203;
    const double t208 = (cos_delta * t130) + (sin_delta * t144);
    const double t209 = motion->constants[25] * t203;
    const double t214 = speeds[1] * t203;
    const double t216 = t214 - (cos_delta * t173) - (sin_delta * t189);
    const double t218 = t31 * motion->constants[10];
    const double t221 = (t43 * t59) - (t36 * t73);
    const double t225 = (t43 * t58) - (t36 * t72);
    const double t228 = 1.0 / motion->constants[10];
    const double t229 = ((t84 * t225) - (t78 * t221)) * t228;
    const double t238 = t228 * ((t36 * t111) + (t120 * t225) - (t43 * t104) - (t116 * t221));
    const double t243 = t228 * ((t36 * motion->constants[7]) + (t124 * t225));
    const double t246 = (speeds[0] * t229) + (speeds[1] * t238) + (speeds[2] * t243);
    const double t250 = t33 * motion->constants[10];
    const double t258 = t30 * t47 * ((t31 * t208) + (t33 * t199));
    const double t259 = t250 * t258;
    const double t261 = t218 * t258;
    const double t267 = (cos_delta * t181) + (t199 * t204) + (t208 * t209) +
        (motion->constants[25] * t169) + (t218 * (t169 + (t208 * t246))) + (t199 * t259);
    const double t271 = t267 + (t208 * t261) - (sin_delta * t197) - (motion->constants[26] * t216) -
        (t250 * (t216 - (t199 * t246)));
    const double t278 = (motion->constants[25] * t199) - (motion->constants[26] * t208);
    const double t282 = speeds[1] * t208;
    const double t284 = (sin_delta * t173) - (cos_delta * t189) - t282;
    const double t287 = t203 + t246;
    const double t292 = motion->constants[10] * ((t31 * t199) - (t33 * t208));
    const double t298 = (cos_delta * t197) + (sin_delta * t181) + (motion->constants[26] * t284) +
        (t250 * t284) - (t203 * t209) - (t199 * t278);
    const double t300 = t298 - (t261 * t287) - (t199 * t292);
    const double t304 = (t130 * t186) - (t144 * t161);
    const double t318 = t304 + (motion->constants[23] * t189) + (t9 * t192) + (t208 * t278) +
        (t208 * t292) - (t13 * t155);
    const double t322 = t318 - (t203 * t204) - (motion->constants[25] * t284) - (t218 * t284) -
        (t259 * t287);
    const double t324 = (t31 * t300) + (t33 * t322);
    const double t329 = t77 * ((t47 * t271) + (t29 * t324));
    const double t333 = t82 * ((t29 * t271) + (t75 * t329) - (t47 * t324));
    const double t335 = t189 - t329;
    const double t336 = (sin_phi * t333) + t335;
    const double t340 = (motion->constants[7] * t336) + t160;
    const double t342 = t159 - (t9 * t340);
    const double t345 = t304 - t342 + (motion->constants[23] * t336);
    const double t351 = t166 - (cos_phi * t333);
    const double t353 = t172 + (t9 * t351);
    const double t356 = (sin_delta * t353) - (cos_delta * t336) - t282;
    const double t361 = (t199 * motion->constants[34]) - (t208 * motion->constants[35]);
    const double t363 = t203 * motion->constants[35];
    const double t365 = (t208 * t361) - (t203 * t363);
    const double t367 = (t345 * motion->constants[17]) + t365 - (motion->constants[34] * t356);
    const double t375 = t9 * t158;
    const double t376 = t375 + (t13 * t340);
    const double t379 = t376 - (motion->constants[24] * t336) - t188;
    const double t382 = t168 + (t13 * t351);
    const double t385 = sin_phi * motion->constants[40];
    const double t386 = t178 + t385;
    const double t389 = t165 + (motion->constants[23] * t382) + (motion->constants[24] * t353) -
        t386;
    const double t391 = (cos_delta * t379) + (sin_delta * t389);
    const double t394 = t203 * motion->constants[34];
    const double t397 = (t203 * t394) + (t199 * t361);
    const double t399 = (t391 * motion->constants[17]) + (motion->constants[35] * t356) - t397;
    const double t403 = (cos_delta * t389) - (sin_delta * t379);
    const double t409 = t214 - (sin_delta * t336) - (cos_delta * t353);
    const double t413 = (t199 * t363) + (t208 * t394);
    const double t416 = (t403 * motion->constants[17]) + (t382 * motion->constants[34]) + t413 -
        (motion->constants[35] * t409);
    const double t418 = (cos_delta * t399) - (sin_delta * t416);
    const double t421 = motion->constants[28] * t144;
    const double t424 = (t144 * t421) + (t133 * t138);
    const double t429 = (t9 * (t147 + t367 - (motion->constants[1] * t342) +
        (motion->constants[28] * t336))) + (t13 * (t418 + (motion->constants[1] * t376) -
        (motion->constants[29] * t336) - t424));
    const double t431 = (t336 * motion->constants[21]) + (motion->constants[7] * t429);
    const double t432 = sin_phi * t124;
    const double t441 = (t130 * motion->constants[32]) + (t133 * motion->constants[30]);
    const double t446 = (t130 * motion->constants[30]) + (t133 * motion->constants[33]);
    const double t448 = (t133 * t441) - (t130 * t446);
    const double t457 = (t208 * motion->constants[37]) + (t199 * motion->constants[39]);
    const double t463 = (t203 * motion->constants[38]) + (t287 * motion->constants[22]);
    const double t465 = (t203 * t457) - (t199 * t463);
    const double t468 = (motion->constants[36] * t409) + (t382 * motion->constants[37]) + t465 -
        (motion->constants[35] * t403);
    const double t480 = t228 * ((t31 * t322) + (t225 * t333) - (t33 * t300) - (t221 * t329));
    const double t482 = motion->constants[22] * (t356 + t480);
    const double t485 = (t208 * motion->constants[36]) + (t199 * motion->constants[37]);
    const double t488 = (t199 * t485) - (t208 * t457);
    const double t492 = (motion->constants[35] * t391) + (motion->constants[38] * t356) + t482 +
        t488 - (motion->constants[34] * t345);
    const double t500 = (motion->constants[29] * t376) + (motion->constants[28] * t342) - (t336 *
        motion->constants[31]) + t448 + (sin_delta * t468) + (cos_delta * t492);
    const double t503 = t500 + (motion->constants[24] * t418) - t431 - (motion->constants[23] *
        t367);
    const double t505 = cos_phi * t124;
    const double t512 = (t144 * motion->constants[31]) + (motion->constants[21] * (speeds[2] +
        t144));
    const double t515 = (t130 * t512) - (t144 * t441);
    const double t521 = (t208 * t463) - (t203 * t485);
    const double t524 = (t403 * motion->constants[34]) + (t409 * motion->constants[37]) + (t382 *
        motion->constants[39]) + t521;
    const double t527 = (sin_delta * t399) + (cos_delta * t416);
    const double t533 = (motion->constants[33] * t382) + t515 + t524 + (motion->constants[23] *
        t527) - (motion->constants[28] * t386) - (motion->constants[30] * t353);
    const double t540 = (t144 * t446) - (t133 * t512);
    const double t548 = (motion->constants[29] * t386) + (motion->constants[30] * t382) + t540 +
        (cos_delta * t468) - (motion->constants[32] * t353) - (sin_delta * t492);
    const double t549 = t548 - (motion->constants[24] * t527);
    const double t551 = (t13 * t533) - (t9 * t549);
    const double t562 = (t133 * t145) + (t130 * t421);
    const double t567 = motion->constants[7] * (t527 + (motion->constants[28] * t382) +
        (motion->constants[29] * t353) + t562 - (motion->constants[1] * t386));
    const double t569 = t78 - (sin_phi * t84);
    const double t571 = cos_phi * t84;
    const double t578 = forces[0] + (t551 * t571) - (t9 * t533) - (t13 * t549) - t567 - (t503 *
        t569);
    const double t579 = t578 - (t229 * t482);
    const double t581 = sin_delta * motion->constants[34];
    const double t583 = (sin_delta * motion->constants[37]) - (motion->constants[24] * t581);
    const double t586 = sin_delta * motion->constants[41];
    const double t589 = (cos_delta * t586) - (motion->constants[23] * t581);
    const double t591 = (t9 * t583) + (t13 * t589);
    const double t596 = cos_delta * motion->constants[34];
    const double t598 = (cos_delta * motion->constants[37]) - (motion->constants[24] * t596);
    const double t601 = motion->constants[30] + t598 - motion->constants[44] -
        motion->constants[45];
    const double t602 = sin_delta * t586;
    const double t606 = motion->constants[32] + motion->constants[36] + motion->constants[43] -
        t602;
    const double t607 = motion->constants[23] * t596;
    const double t610 = t607 + t607 + motion->constants[46];
    const double t612 = motion->constants[33] + motion->constants[39] + t610;
    const double t613 = t612 - t606;
    const double t614 = t9 * t13;
    const double t616 = t9 * t9;
    const double t617 = t601 + t601;
    const double t623 = motion->constants[28] + t596 + motion->constants[42];
    const double t629 = t601 + (t613 * t614) + (motion->constants[7] * ((t9 *
        motion->constants[47]) + (t13 * t623))) - (t616 * t617);
    const double t633 = (t13 * motion->constants[47]) - (t9 * t623);
    const double t636 = motion->constants[7] * (t633 - motion->constants[48]);
    const double t637 = motion->constants[7] * t633;
    const double t640 = motion->constants[49] - t637 - t637;
    const double t645 = motion->constants[31] + motion->constants[38] + t602 +
        motion->constants[43] + t610 + t640;
    const double t649 = motion->constants[7] * t581;
    const double t651 = (t13 * t583) + t649 - (t9 * t589);
    const double t654 = t636 + (t432 * t645) + (t505 * t651);
    const double t659 = (t613 * t616) + (t614 * t617);
    const double t660 = t612 - t659;
    const double t663 = t649 - (t432 * t651) - (t505 * t660);
    const double t666 = 1.0 - t432;
    const double t667 = motion->constants[21] * t569;
    const double t670 = t9 * sin_delta;
    const double t673 = t243 - (cos_delta * t432) - (t505 * t670);
    const double t679 = t229 + (cos_delta * t569) - (t13 * sin_delta) - (t571 * t670);
    const double t680 = motion->constants[22] * t679;
    const double t686 = (t666 * t667) + (t673 * t680) - (t432 * t591) - (t505 * t629) - (t569 *
        t654) - (t571 * t663);
    const double t705 = t606 + t640 + t659 + (t569 * t591) + (t569 * (t591 + (t569 * t645) - (t571 *
        t651))) + (t569 * t667);
    const double t708 = t705 + (t679 * t680) - (t571 * t629) - (t571 * (t629 + (t569 * t651) -
        (t571 * t660)));
    const double t709 = 1.0 / t708;
    const double t710 = t686 * t709;
    const double t712 = t13 * t649;
    const double t714 = t116 - (sin_phi * t120);
    const double t716 = cos_phi * t120;
    const double t718 = t583 + t712;
    const double t720 = motion->constants[39] + t607;
    const double t723 = (t13 * t720) - (t9 * t598);
    const double t725 = motion->constants[21] * t714;
    const double t730 = t238 + (cos_delta * t714) - (t670 * t716);
    const double t731 = motion->constants[22] * t730;
    const double t741 = t718 + (t645 * t714) - (t651 * t716);
    const double t746 = t723 + (t651 * t714) - (t660 * t716);
    const double t754 = (t9 * t720) + (t13 * t598) + (motion->constants[7] * t596) + (t591 * t714) +
        (t569 * t741) + (t667 * t714);
    const double t758 = t709 * (t754 + (t680 * t730) - (t629 * t716) - (t571 * t746));
    const double t759 = t708 * t758;
    const double t765 = t712 + (t666 * t725) + (t673 * t731) - (t654 * t714) - (t663 * t716) -
        (t432 * t718);
    const double t779 = motion->constants[39] + (t714 * t741) + (t714 * t718) + (t714 * t725) +
        (t730 * t731) - (t716 * t746);
    const double t781 = t779 - (t716 * t723) - (t758 * t759);
    const double t782 = 1.0 / t781;
    const double t783 = (t765 - (t505 * t723) - (t710 * t759)) * t782;
    const double t793 = forces[1] + (t551 * t716) - t524 - (t503 * t714) - (t238 * t482) - (t579 *
        t758);
    const double t799 = (t432 * t503) + (t505 * t551) + t431 - (t243 * t482) - (t579 * t710) -
        (t783 * t793);
    const double t817 = (t432 * t654) + (t432 * t636) + motion->constants[50] +
        (motion->constants[21] * t666 * t666) + (motion->constants[22] * t673 * t673) - (t505 *
        t663);
    const double t821 = t799 / (t817 - (t505 * t649) - (t708 * t710 * t710) - (t781 * t783 * t783));
    const double t825 = (t782 * t793) - (t783 * t821);
    const double t829 = (t579 * t709) - (t758 * t825) - (t710 * t821);
    const double t837 = t333 + (t84 * t829) + (t120 * t825) + (t124 * t821);
    const double t841 = (t78 * t829) + (t116 * t825) - (sin_phi * t837) - t335;
    const double t842 = t821 + t841;
    const double t844 = (motion->constants[7] * t842) - t160;
    const double t846 = t159 + (t9 * t844);
    const double t851 = t304 - t846 - (motion->constants[23] * t841);
    const double t856 = t166 - (cos_phi * t837);
    const double t859 = (t13 * t829) - t172 - (t9 * t856);
    const double t862 = (cos_delta * t841) - t282 - (sin_delta * t859);
    const double t865 = t365 + (motion->constants[17] * t851) - (motion->constants[34] * t862);
    const double t868 = t147 + t865 - (motion->constants[1] * t846) - (motion->constants[28] *
        t841);
    const double t871 = t375 - (t13 * t844);
    const double t876 = t871 + (motion->constants[24] * t841) - t188;
    const double t881 = t168 + (t13 * t856) + (t9 * t829);
    const double t887 = t177 + t385 - (motion->constants[7] * (t175 + t829));
    const double t890 = t165 + (motion->constants[23] * t881) - (motion->constants[24] * t859) -
        t887;
    const double t892 = (cos_delta * t876) + (sin_delta * t890);
    const double t896 = (motion->constants[17] * t892) + (motion->constants[35] * t862) - t397;
    const double t900 = (cos_delta * t890) - (sin_delta * t876);
    const double t902 = t825 + t881;
    const double t907 = t214 + (cos_delta * t859) + (sin_delta * t841);
    const double t911 = t413 + (motion->constants[17] * t900) + (motion->constants[34] * t902) -
        (motion->constants[35] * t907);
    const double t913 = (cos_delta * t896) - (sin_delta * t911);
    const double t916 = (motion->constants[1] * t871) + (motion->constants[29] * t841) + t913 -
        t424;
    const double t918 = (t9 * t868) + (t13 * t916);
    const double t926 = motion->constants[22] * (t480 + t862 + (t229 * t829) + (t238 * t825) +
        (t243 * t821));
    const double t927 = t228 * t926;
    const double t938 = t465 + (motion->constants[36] * t907) + (motion->constants[37] * t902) -
        (motion->constants[35] * t900);
    const double t946 = t488 + t926 + (motion->constants[35] * t892) + (motion->constants[38] *
        t862) - (motion->constants[34] * t851);
    const double t955 = t448 + (motion->constants[29] * t871) + (motion->constants[28] * t846) +
        (motion->constants[31] * t841) + (motion->constants[21] * t842) + (sin_delta * t938);
    const double t959 = t955 + (cos_delta * t946) + (motion->constants[24] * t913) -
        (motion->constants[23] * t865) - (motion->constants[7] * t918);
    const double t969 = (sin_delta * t896) + (cos_delta * t911);
    const double t976 = t515 + t521 + (motion->constants[30] * t859) + (motion->constants[33] *
        t881) + (motion->constants[34] * t900) + (motion->constants[37] * t907) +
        (motion->constants[39] * t902);
    const double t990 = t540 + (motion->constants[29] * t887) + (motion->constants[32] * t859) +
        (motion->constants[30] * t881) + (cos_delta * t938) - (sin_delta * t946);
    const double t994 = cos_phi * ((t13 * (t976 + (motion->constants[23] * t969) -
        (motion->constants[28] * t887))) - (t9 * (t990 - (motion->constants[24] * t969))));
    const double t998 = t82 * ((sin_phi * t959) + t994 - (t225 * t927));
    const double t1000 = (t36 * t927) - (t43 * t998);
    const double t1001 = t918 - t1000;
    const double t1006 = (t43 * t927) + (t36 * t998);
    const double t1013 = t562 + t969 + (motion->constants[28] * t881) - (motion->constants[1] *
        t887) - (motion->constants[29] * t859);
    const double t1017 = (t13 * t868) - (t9 * t916);
    const double t1020 = (cos_phi * t1013) - t1006 - (sin_phi * t1017);
    const double t1022 = (cos_psi * t1001) - (sin_psi * t1020);
    const double t1025 = (t1001 * sin_psi) + (cos_psi * t1020);
    const double t1030 = t77 * (t959 - (t75 * t998) - (t221 * t927));
    const double t1034 = t1030 + (sin_phi * t1013) + (cos_phi * t1017);
    const double t1037 = (cos_psi * t1000) - (sin_psi * t1006);
    const double t1040 = (t1000 * sin_psi) + (cos_psi * t1006);
    const double t1041 = -t1030;
    contact_forces[0] = t1022;
    contact_forces[1] = t1025;
    contact_forces[2] = t1034;
    contact_forces[3] = t1037;
    contact_forces[4] = t1040;
    contact_forces[5] = t1041;
}

carvallo_motion_error_t whipple_mechanism_f64_motion_contact_forces(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], const double forces[WHIPPLE_MECHANISM_FORCES],
    double contact_forces[3U * WHIPPLE_MECHANISM_WHEELS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_MECHANISM_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_MECHANISM_FORCES)) {
        whipple_mechanism_f64_compute_contact_forces(motion, positions, speeds, forces,
            contact_forces);
        error = (carvallo_are_finite_f64(contact_forces, 3U * WHIPPLE_MECHANISM_WHEELS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
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

void whipple_mechanism_f32_motion(const whipple_mechanism_f32_t *p,
    whipple_mechanism_f32_motion_t *motion)
{
    const float t2 = p->mB + p->mR;
    const float t18 = p->mH + p->mF;
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t25 = p->w + p->c;
    const float t28 = (cos_lam * t25) - (p->rR * sin_lam);
    const float t31 = (sin_lam * t25) + (p->rR * cos_lam);
    const float t32 = p->w - t25;
    const float t35 = (cos_lam * t32) + (p->rF * sin_lam);
    const float t38 = (sin_lam * t32) - (p->rF * cos_lam);
    const float t39 = t31 + t38;
    const float t41 = p->rR + p->zB;
    const float t43 = (p->xB * cos_lam) - (sin_lam * t41);
    const float t44 = p->mB * t43;
    const float t47 = (p->xB * sin_lam) + (cos_lam * t41);
    const float t48 = p->mB * t47;
    const float t50 = p->IBxz * cos_lam;
    const float t51 = (p->IBxx * sin_lam) + t50;
    const float t53 = p->IBxz * sin_lam;
    const float t55 = t53 + (p->IBzz * cos_lam);
    const float t59 = (cos_lam * t51) - (sin_lam * t55) - (t44 * t47);
    const float t61 = t47 * t48;
    const float t62 = t43 * t44;
    const float t64 = p->IByy + t61 + t62;
    const float t74 = t61 + p->IRxx + (cos_lam * ((p->IBxx * cos_lam) - t53)) - (sin_lam * (t50 -
        (p->IBzz * sin_lam)));
    const float t79 = t62 + p->IRxx + (sin_lam * t51) + (cos_lam * t55);
    const float t80 = p->xH - t25;
    const float t83 = (cos_lam * t80) - (p->zH * sin_lam);
    const float t84 = p->mH * t83;
    const float t85 = p->mF * t35;
    const float t86 = t84 + t85;
    const float t89 = (sin_lam * t80) + (p->zH * cos_lam);
    const float t90 = p->mH * t89;
    const float t91 = p->mF * t38;
    const float t92 = t90 + t91;
    const float t95 = p->IHxz * sin_lam;
    const float t98 = p->IHxz * cos_lam;
    const float t104 = (t89 * t90) + (t38 * t91);
    const float t107 = p->IFxx + (cos_lam * ((p->IHxx * cos_lam) - t95)) + t104 - (sin_lam * (t98 -
        (p->IHzz * sin_lam)));
    const float t109 = t98 + (p->IHxx * sin_lam);
    const float t112 = t95 + (p->IHzz * cos_lam);
    const float t118 = (cos_lam * t109) - (sin_lam * t112) - (t84 * t89) - (t38 * t85);
    const float t122 = (t83 * t84) + (t35 * t85);
    const float t124 = t104 + p->IHyy + t122;
    const float t129 = p->IFxx + t122 + (sin_lam * t109) + (cos_lam * t112);
    const float t131 = t107 - t124;
    const float t132 = t18 * t28;
    const float t133 = t31 * t92;
    const float t134 = t18 * t31;
    const float t137 = t133 + t133 + (t31 * t134);
    const float t138 = t28 * t92;
    const float t139 = t31 * t132;
    const float t140 = t28 * t132;
    const float t142 = t48 + t92 + t134;
    const float t144 = p->rR * (t2 + t18);
    const float t145 = p->rR * t144;
    motion->constants[0] = p->mB;
    motion->constants[1] = t2;
    motion->constants[2] = p->mH;
    motion->constants[3] = p->mF;
    motion->constants[4] = p->xB;
    motion->constants[5] = p->xH;
    motion->constants[6] = p->w;
    motion->constants[7] = p->rR;
    motion->constants[8] = p->zB;
    motion->constants[9] = p->zH;
    motion->constants[10] = p->rF;
    motion->constants[11] = p->IBxx;
    motion->constants[12] = p->IHxx;
    motion->constants[13] = p->IBxz;
    motion->constants[14] = p->IHxz;
    motion->constants[15] = p->IBzz;
    motion->constants[16] = p->IHzz;
    motion->constants[17] = t18;
    motion->constants[18] = p->c;
    motion->constants[19] = cos_lam;
    motion->constants[20] = sin_lam;
    motion->constants[21] = p->IRyy;
    motion->constants[22] = p->IFyy;
    motion->constants[23] = t28;
    motion->constants[24] = t31;
    motion->constants[25] = t35;
    motion->constants[26] = t38;
    motion->constants[27] = t39;
    motion->constants[28] = t44;
    motion->constants[29] = t48;
    motion->constants[30] = t59;
    motion->constants[31] = t64;
    motion->constants[32] = t74;
    motion->constants[33] = t79;
    motion->constants[34] = t86;
    motion->constants[35] = t92;
    motion->constants[36] = t107;
    motion->constants[37] = t118;
    motion->constants[38] = t124;
    motion->constants[39] = t129;
    motion->constants[40] = p->g;
    motion->constants[41] = t131;
    motion->constants[42] = t132;
    motion->constants[43] = t137;
    motion->constants[44] = t138;
    motion->constants[45] = t139;
    motion->constants[46] = t140;
    motion->constants[47] = t142;
    motion->constants[48] = t144;
    motion->constants[49] = t145;
    motion->constants[50] = t145;
}

static void whipple_mechanism_f32_compute_rates(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], float rates[WHIPPLE_MECHANISM_POSITIONS])
{
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t13 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t17 = t13 * cos_phi;
    const float t21 = (sin_phi * sin_delta) - (cos_delta * t17);
    const float t25 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
    const float t26 = cos_phi * t25;
    const float t29 = sqrtf((t21 * t21) + (t26 * t26));
    const float t30 = 1.0F / t29;
    const float t31 = t21 * t30;
    const float t33 = t26 * t30;
    const float t34 = cos_delta * t33;
    const float t36 = (t25 * t34) - (t13 * t31);
    const float t41 = motion->constants[10] * ((sin_phi * cos_delta) + (t17 * sin_delta));
    const float t44 = sin_delta * motion->constants[25];
    const float t50 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const float t52 = (t25 * motion->constants[27]) - (t13 * t50);
    const float t55 = (cos_phi * t44) - (t36 * t41) - (sin_phi * t52);
    const float t56 = (motion->constants[7] * sin_phi) + t55;
    const float t63 = (cos_phi * sin_delta * t33) + (sin_phi * ((t25 * t31) + (t13 * t34)));
    const float t68 = (t41 * t63) + (t13 * motion->constants[27]) + (t25 * t50);
    const float t70 = 1.0F / (cos_phi * t68);
    const float t71 = t56 * t70;
    const float t77 = (t25 * motion->constants[24]) - (t13 * motion->constants[23]);
    const float t79 = t55 + (sin_phi * t77);
    const float t81 = sin_phi * t25;
    const float t85 = t68 - (t13 * motion->constants[24]) - (t25 * motion->constants[23]);
    const float t88 = t70 * ((t13 * t79) + (t81 * t85));
    const float t90 = (speeds[0] * t71) + (speeds[1] * t88);
    const float t92 = motion->constants[7] * (speeds[2] + t90);
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t98 = sin_phi * t68;
    const float t100 = sin_phi * t56;
    const float t102 = (t36 * t98) + (t63 * t100);
    const float t106 = 1.0F / ((t36 * t68) + (t56 * t63));
    const float t108 = t71 * t102 * t106;
    const float t117 = (t29 * motion->constants[10]) + (sin_phi * t44) + (cos_phi * t52) -
        (cos_phi * t77);
    const float t119 = (t26 * t85) - (t13 * t117);
    const float t123 = (t81 * t117) + (t26 * t79);
    const float t128 = t106 * ((t36 * t119) + (t63 * t123) + (t88 * t102));
    const float t131 = motion->constants[7] * t63 * t106;
    const float t137 = (t63 * t98) - (t36 * t100);
    const float t141 = (t63 * t68) - (t36 * t56);
    const float t144 = 1.0F / motion->constants[10];
    const float t161 = (speeds[0] * ((t108 * t141) - (t71 * t137)) * t144) + (speeds[1] * t144 *
        ((t36 * t123) + (t128 * t141) - (t63 * t119) - (t88 * t137)));
    const float t162 = t161 + (speeds[2] * t144 * ((motion->constants[7] * t36) + (t131 * t141)));
    const float t163 = -(t92 * cos_psi);
    const float t164 = -(t92 * sin_psi);
    const float t165 = -((speeds[0] * t108) + (speeds[1] * t128) + (speeds[2] * t131));
    rates[0] = t163;
    rates[1] = t164;
    rates[2] = t165;
    rates[3] = speeds[0];
    rates[4] = t90;
    rates[5] = speeds[1];
    rates[6] = speeds[2];
    rates[7] = t162;
}

carvallo_motion_error_t whipple_mechanism_f32_motion_rates(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], float rates[WHIPPLE_MECHANISM_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_MECHANISM_SPEEDS)) {
        whipple_mechanism_f32_compute_rates(motion, positions, speeds, rates);
        error = (carvallo_are_finite_f32(rates, WHIPPLE_MECHANISM_POSITIONS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_mechanism_f32_compute_derivatives(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], const float forces[WHIPPLE_MECHANISM_FORCES],
    float rates[WHIPPLE_MECHANISM_POSITIONS], float speed_rates[WHIPPLE_MECHANISM_SPEEDS])
{
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t13 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t17 = t13 * cos_phi;
    const float t21 = (sin_phi * sin_delta) - (cos_delta * t17);
    const float t25 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
    const float t26 = cos_phi * t25;
    const float t29 = sqrtf((t21 * t21) + (t26 * t26));
    const float t30 = 1.0F / t29;
    const float t31 = t21 * t30;
    const float t33 = t26 * t30;
    const float t34 = cos_delta * t33;
    const float t36 = (t25 * t34) - (t13 * t31);
    const float t40 = (sin_phi * cos_delta) + (t17 * sin_delta);
    const float t41 = motion->constants[10] * t40;
    const float t44 = sin_delta * motion->constants[25];
    const float t50 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const float t52 = (t25 * motion->constants[27]) - (t13 * t50);
    const float t55 = (cos_phi * t44) - (t36 * t41) - (sin_phi * t52);
    const float t56 = (motion->constants[7] * sin_phi) + t55;
    const float t63 = (cos_phi * sin_delta * t33) + (sin_phi * ((t25 * t31) + (t13 * t34)));
    const float t68 = (t41 * t63) + (t13 * motion->constants[27]) + (t25 * t50);
    const float t70 = 1.0F / (cos_phi * t68);
    const float t71 = t56 * t70;
    const float t77 = (t25 * motion->constants[24]) - (t13 * motion->constants[23]);
    const float t79 = t55 + (sin_phi * t77);
    const float t81 = sin_phi * t25;
    const float t85 = t68 - (t13 * motion->constants[24]) - (t25 * motion->constants[23]);
    const float t88 = t70 * ((t13 * t79) + (t81 * t85));
    const float t90 = (speeds[0] * t71) + (speeds[1] * t88);
    const float t91 = speeds[2] + t90;
    const float t92 = motion->constants[7] * t91;
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t98 = sin_phi * t68;
    const float t100 = sin_phi * t56;
    const float t102 = (t36 * t98) + (t63 * t100);
    const float t106 = 1.0F / ((t36 * t68) + (t56 * t63));
    const float t108 = t71 * t102 * t106;
    const float t117 = (t29 * motion->constants[10]) + (sin_phi * t44) + (cos_phi * t52) -
        (cos_phi * t77);
    const float t119 = (t26 * t85) - (t13 * t117);
    const float t123 = (t81 * t117) + (t26 * t79);
    const float t128 = t106 * ((t36 * t119) + (t63 * t123) + (t88 * t102));
    const float t131 = motion->constants[7] * t63 * t106;
    const float t134 = (speeds[0] * t108) + (speeds[1] * t128) + (speeds[2] * t131);
    const float t137 = (t63 * t98) - (t36 * t100);
    const float t141 = (t63 * t68) - (t36 * t56);
    const float t144 = 1.0F / motion->constants[10];
    const float t145 = ((t108 * t141) - (t71 * t137)) * t144;
    const float t154 = t144 * ((t36 * t123) + (t128 * t141) - (t63 * t119) - (t88 * t137));
    const float t159 = t144 * ((motion->constants[7] * t36) + (t131 * t141));
    const float t162 = (speeds[0] * t145) + (speeds[1] * t154) + (speeds[2] * t159);
    const float t165 = cos_phi * t134;
    const float t167 = sin_phi * t134;
    const float t168 = motion->constants[7] * t167;
    const float t170 = (t165 * t168) - (t92 * t165);
    const float t173 = t170 + (sin_phi * motion->constants[40]);
    const float t178 = (speeds[0] * t13) - (t25 * t165);
    const float t179 = t90 * t178;
    const float t180 = speeds[0] * t167;
    const float t181 = t90 - t167;
    const float t182 = motion->constants[24] * t181;
    const float t186 = (speeds[0] * t25) + (t13 * t165);
    const float t187 = motion->constants[23] * t181;
    const float t189 = (t178 * t182) + (t186 * t187);
    const float t191 = t90 * t186;
    const float t192 = (t25 * t180) + t191;
    const float t195 = t179 + (t13 * t180);
    const float t199 = t189 + (motion->constants[23] * t192) + (motion->constants[24] * t195) -
        t170;
    const float t204 = (motion->constants[23] * t178) - (motion->constants[24] * t186);
    const float t206 = (t181 * t187) + (t178 * t204);
    const float t207 = speeds[0] * t165;
    const float t210 = motion->constants[7] * speeds[0];
    const float t211 = t165 * t210;
    const float t212 = (motion->constants[7] * t207) + t211;
    const float t217 = (t168 * (t91 - t167)) - (speeds[0] * t210);
    const float t221 = (t25 * t212) + (t13 * t217) - t206 - (motion->constants[24] * t207);
    const float t223 = speeds[1] + t178;
    const float t227 = (cos_delta * t181) - (sin_delta * t186);
    const float t228 = motion->constants[26] * t227;
    const float t232 = (cos_delta * t186) + (sin_delta * t181);
    const float t233 = motion->constants[25] * t227;
    const float t238 = speeds[1] * t227;
    const float t240 = t238 - (cos_delta * t195) - (sin_delta * t207);
    const float t242 = t31 * motion->constants[10];
    const float t246 = t33 * motion->constants[10];
    const float t254 = t30 * t40 * ((t31 * t232) + (t33 * t223));
    const float t255 = t246 * t254;
    const float t257 = t242 * t254;
    const float t263 = (cos_delta * t199) + (t223 * t228) + (t232 * t233) + (motion->constants[25] *
        t192) + (t242 * (t192 + (t162 * t232))) + (t223 * t255);
    const float t267 = t263 + (t232 * t257) - (sin_delta * t221) - (motion->constants[26] * t240) -
        (t246 * (t240 - (t162 * t223)));
    const float t274 = (motion->constants[25] * t223) - (motion->constants[26] * t232);
    const float t278 = speeds[1] * t232;
    const float t280 = (sin_delta * t195) - (cos_delta * t207) - t278;
    const float t283 = t162 + t227;
    const float t288 = motion->constants[10] * ((t31 * t223) - (t33 * t232));
    const float t294 = (cos_delta * t221) + (sin_delta * t199) + (motion->constants[26] * t280) +
        (t246 * t280) - (t227 * t233) - (t223 * t274);
    const float t296 = t294 - (t257 * t283) - (t223 * t288);
    const float t300 = (t186 * t204) - (t181 * t182);
    const float t314 = t300 + (motion->constants[23] * t207) + (t13 * t212) + (t232 * t274) +
        (t232 * t288) - (t25 * t217);
    const float t318 = t314 - (t227 * t228) - (motion->constants[25] * t280) - (t242 * t280) -
        (t255 * t283);
    const float t320 = (t31 * t296) + (t33 * t318);
    const float t325 = t70 * ((t40 * t267) + (t29 * t320));
    const float t329 = t106 * ((t29 * t267) + (t102 * t325) - (t40 * t320));
    const float t331 = t180 - (cos_phi * t329);
    const float t333 = t179 + (t13 * t331);
    const float t337 = t191 + (t25 * t331);
    const float t344 = (t181 * motion->constants[31]) + (motion->constants[21] * (speeds[2] +
        t181));
    const float t349 = (t186 * motion->constants[32]) + (motion->constants[30] * t178);
    const float t356 = t189 + (motion->constants[23] * t337) + (motion->constants[24] * t333) -
        t173;
    const float t360 = t325 - t207 - (sin_phi * t329);
    const float t363 = (motion->constants[7] * t360) - t211;
    const float t366 = t217 + (cos_phi * motion->constants[40]);
    const float t368 = (t13 * t366) - (t25 * t363);
    const float t370 = (motion->constants[24] * t360) + t368 - t206;
    const float t372 = (cos_delta * t356) - (sin_delta * t370);
    const float t378 = t238 + (sin_delta * t360) - (cos_delta * t333);
    const float t386 = (t227 * motion->constants[38]) + (t283 * motion->constants[22]);
    const float t391 = (t232 * motion->constants[36]) + (t223 * motion->constants[37]);
    const float t396 = (motion->constants[34] * t372) + (motion->constants[37] * t378) + (t337 *
        motion->constants[39]) + (t232 * t386) - (t227 * t391);
    const float t400 = (cos_delta * t370) + (sin_delta * t356);
    const float t406 = (cos_delta * t360) + (sin_delta * t333) - t278;
    const float t408 = t227 * motion->constants[34];
    const float t412 = (t223 * motion->constants[34]) - (t232 * motion->constants[35]);
    const float t416 = (motion->constants[17] * t400) + (motion->constants[35] * t406) - (t227 *
        t408) - (t223 * t412);
    const float t421 = t227 * motion->constants[35];
    const float t427 = (t372 * motion->constants[17]) + (t337 * motion->constants[34]) + (t223 *
        t421) + (t232 * t408) - (t378 * motion->constants[35]);
    const float t429 = (sin_delta * t416) + (cos_delta * t427);
    const float t435 = (motion->constants[33] * t337) + (t186 * t344) + t396 +
        (motion->constants[23] * t429) - (motion->constants[28] * t173) - (motion->constants[30] *
        t333);
    const float t436 = t435 - (t181 * t349);
    const float t444 = (motion->constants[30] * t186) + (t178 * motion->constants[33]);
    const float t452 = (t232 * motion->constants[37]) + (t223 * motion->constants[39]);
    const float t458 = (t378 * motion->constants[36]) + (t337 * motion->constants[37]) + (t227 *
        t452) - (t372 * motion->constants[35]) - (t223 * t386);
    const float t464 = (t25 * t366) + (t13 * t363);
    const float t466 = t300 - (motion->constants[23] * t360) - t464;
    const float t477 = t406 + (t144 * ((t31 * t318) + (t141 * t329) - (t33 * t296) - (t137 *
        t325)));
    const float t478 = motion->constants[22] * t477;
    const float t485 = (t400 * motion->constants[35]) + (motion->constants[38] * t406) + t478 +
        (t223 * t391) - (motion->constants[34] * t466) - (t232 * t452);
    const float t492 = (t173 * motion->constants[29]) + (motion->constants[30] * t337) + (t181 *
        t444) + (cos_delta * t458) - (t333 * motion->constants[32]) - (t178 * t344);
    const float t494 = t492 - (sin_delta * t485) - (motion->constants[24] * t429);
    const float t500 = t181 * motion->constants[29];
    const float t502 = motion->constants[28] * t181;
    const float t508 = t429 + (motion->constants[28] * t337) + (t333 * motion->constants[29]) +
        (t178 * t500) + (t186 * t502) - (t173 * motion->constants[1]);
    const float t511 = t71 - (sin_phi * t108);
    const float t521 = (cos_delta * t416) - (sin_delta * t427);
    const float t529 = (motion->constants[17] * t466) + (t232 * t412) - (motion->constants[34] *
        t406) - (t227 * t421);
    const float t536 = (motion->constants[28] * t178) - (t186 * motion->constants[29]);
    const float t543 = t13 * (t529 + (t186 * t536) - (t464 * motion->constants[1]) -
        (motion->constants[28] * t360) - (t181 * t500));
    const float t552 = t25 * (t521 + (t368 * motion->constants[1]) + (t360 *
        motion->constants[29]) - (t181 * t502) - (t178 * t536));
    const float t555 = (motion->constants[21] * t360) - (motion->constants[7] * (t543 + t552));
    const float t560 = (t368 * motion->constants[29]) + (motion->constants[28] * t464) +
        (motion->constants[31] * t360) + (t178 * t349) + (sin_delta * t458) + (cos_delta * t485);
    const float t564 = t560 + (motion->constants[24] * t521) + t555 - (t186 * t444) -
        (motion->constants[23] * t529);
    const float t566 = cos_phi * t108;
    const float t569 = (t25 * t436) - (t13 * t494);
    const float t576 = forces[0] + (t566 * t569) - (t13 * t436) - (t25 * t494) -
        (motion->constants[7] * t508) - (t511 * t564);
    const float t577 = t576 - (t145 * t478);
    const float t579 = sin_delta * motion->constants[41];
    const float t580 = sin_delta * t579;
    const float t584 = motion->constants[32] + motion->constants[36] + motion->constants[43] - t580;
    const float t585 = cos_delta * motion->constants[34];
    const float t586 = motion->constants[23] * t585;
    const float t589 = t586 + t586 + motion->constants[46];
    const float t591 = motion->constants[33] + motion->constants[39] + t589;
    const float t592 = t591 - t584;
    const float t593 = t13 * t13;
    const float t595 = t13 * t25;
    const float t600 = (cos_delta * motion->constants[37]) - (motion->constants[24] * t585);
    const float t603 = motion->constants[30] + t600 - motion->constants[44] - motion->constants[45];
    const float t604 = t603 + t603;
    const float t606 = (t592 * t593) + (t595 * t604);
    const float t611 = motion->constants[28] + t585 + motion->constants[42];
    const float t613 = (t25 * motion->constants[47]) - (t13 * t611);
    const float t614 = motion->constants[7] * t613;
    const float t617 = motion->constants[49] - t614 - t614;
    const float t619 = sin_delta * motion->constants[34];
    const float t621 = (sin_delta * motion->constants[37]) - (motion->constants[24] * t619);
    const float t625 = (cos_delta * t579) - (motion->constants[23] * t619);
    const float t627 = (t13 * t621) + (t25 * t625);
    const float t637 = t603 + (t592 * t595) + (motion->constants[7] * ((t13 *
        motion->constants[47]) + (t25 * t611))) - (t593 * t604);
    const float t643 = motion->constants[31] + motion->constants[38] + t580 +
        motion->constants[43] + t589 + t617;
    const float t647 = motion->constants[7] * t619;
    const float t649 = (t25 * t621) + t647 - (t13 * t625);
    const float t655 = t591 - t606;
    const float t660 = motion->constants[21] * t511;
    const float t664 = t13 * sin_delta;
    const float t668 = t145 + (cos_delta * t511) - (sin_delta * t25) - (t566 * t664);
    const float t669 = motion->constants[22] * t668;
    const float t675 = t584 + t606 + t617 + (t511 * t627) + (t511 * (t627 + (t511 * t643) - (t566 *
        t649))) + (t511 * t660);
    const float t678 = t675 + (t668 * t669) - (t566 * t637) - (t566 * (t637 + (t511 * t649) -
        (t566 * t655)));
    const float t679 = 1.0F / t678;
    const float t681 = motion->constants[39] + t586;
    const float t686 = t88 - (sin_phi * t128);
    const float t688 = cos_phi * t128;
    const float t690 = t25 * t647;
    const float t691 = t621 + t690;
    const float t695 = t691 + (t643 * t686) - (t649 * t688);
    const float t699 = (t25 * t681) - (t13 * t600);
    const float t703 = t699 + (t649 * t686) - (t655 * t688);
    const float t709 = t154 + (cos_delta * t686) - (t664 * t688);
    const float t715 = (t13 * t681) + (t25 * t600) + (motion->constants[7] * t585) + (t627 * t686) +
        (t511 * t695) + (t660 * t686);
    const float t719 = t679 * (t715 + (t669 * t709) - (t637 * t688) - (t566 * t703));
    const float t724 = motion->constants[21] * t686;
    const float t726 = motion->constants[22] * t709;
    const float t728 = t678 * t719;
    const float t734 = motion->constants[39] + (t686 * t695) + (t686 * t691) + (t686 * t724) +
        (t709 * t726) - (t688 * t703);
    const float t736 = t734 - (t688 * t699) - (t719 * t728);
    const float t737 = 1.0F / t736;
    const float t747 = forces[1] + (t569 * t688) - t396 - (t564 * t686) - (t154 * t478) - (t577 *
        t719);
    const float t751 = motion->constants[7] * (t613 - motion->constants[48]);
    const float t752 = sin_phi * t131;
    const float t754 = cos_phi * t131;
    const float t757 = t751 + (t643 * t752) + (t649 * t754);
    const float t762 = t647 - (t649 * t752) - (t655 * t754);
    const float t767 = 1.0F - t752;
    const float t772 = t159 - (cos_delta * t752) - (t664 * t754);
    const float t784 = (t660 * t767) + (t669 * t772) - (t627 * t752) - (t637 * t754) - (t511 *
        t757) - (t566 * t762);
    const float t785 = t679 * t784;
    const float t791 = t690 + (t724 * t767) + (t726 * t772) - (t686 * t757) - (t688 * t762) -
        (t691 * t752);
    const float t794 = t737 * (t791 - (t699 * t754) - (t728 * t785));
    const float t804 = (t564 * t752) + (t569 * t754) - t555 - (t159 * t478) - (t577 * t785) -
        (t747 * t794);
    const float t822 = (t752 * t757) + (t751 * t752) + motion->constants[50] +
        (motion->constants[21] * t767 * t767) + (motion->constants[22] * t772 * t772) - (t754 *
        t762);
    const float t826 = t804 / (t822 - (t647 * t754) - (t678 * t785 * t785) - (t736 * t794 * t794));
    const float t828 = (t737 * t747) - (t794 * t826);
    const float t832 = (t577 * t679) - (t719 * t828) - (t785 * t826);
    const float t833 = -(t92 * cos_psi);
    const float t834 = -(t92 * sin_psi);
    const float t835 = -t134;
    rates[0] = t833;
    rates[1] = t834;
    rates[2] = t835;
    rates[3] = speeds[0];
    rates[4] = t90;
    rates[5] = speeds[1];
    rates[6] = speeds[2];
    rates[7] = t162;
    speed_rates[0] = t832;
    speed_rates[1] = t828;
    speed_rates[2] = t826;
}

carvallo_motion_error_t whipple_mechanism_f32_motion_derivatives(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], const float forces[WHIPPLE_MECHANISM_FORCES],
    float rates[WHIPPLE_MECHANISM_POSITIONS], float speed_rates[WHIPPLE_MECHANISM_SPEEDS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_MECHANISM_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_MECHANISM_FORCES)) {
        whipple_mechanism_f32_compute_derivatives(motion, positions, speeds, forces, rates,
            speed_rates);
        error = (carvallo_are_finite_f32(rates, WHIPPLE_MECHANISM_POSITIONS) &&
            carvallo_are_finite_f32(speed_rates, WHIPPLE_MECHANISM_SPEEDS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_mechanism_f32_compute_accelerations(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], const float forces[WHIPPLE_MECHANISM_FORCES],
    float accelerations[WHIPPLE_MECHANISM_POSITIONS])
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
    const float t13 = (motion->constants[19] * sin_pitch) + (cos_pitch * motion->constants[20]);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t16 = cos_phi * t13;
    const float t21 = (sin_phi * sin_delta) - (cos_delta * t16);
    const float t25 = (motion->constants[19] * cos_pitch) - (motion->constants[20] * sin_pitch);
    const float t26 = cos_phi * t25;
    const float t29 = sqrtf((t21 * t21) + (t26 * t26));
    const float t30 = 1.0F / t29;
    const float t31 = t21 * t30;
    const float t33 = t26 * t30;
    const float t34 = cos_delta * t33;
    const float t36 = (t25 * t34) - (t13 * t31);
    const float t43 = (cos_phi * sin_delta * t33) + (sin_phi * ((t25 * t31) + (t13 * t34)));
    const float t47 = (sin_phi * cos_delta) + (sin_delta * t16);
    const float t48 = motion->constants[10] * t47;
    const float t55 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const float t58 = (t43 * t48) + (t13 * motion->constants[27]) + (t25 * t55);
    const float t62 = sin_delta * motion->constants[25];
    const float t66 = (t25 * motion->constants[27]) - (t13 * t55);
    const float t69 = (cos_phi * t62) - (t36 * t48) - (sin_phi * t66);
    const float t70 = (motion->constants[7] * sin_phi) + t69;
    const float t73 = 1.0F / ((t36 * t58) + (t43 * t70));
    const float t74 = sin_phi * t58;
    const float t76 = sin_phi * t70;
    const float t78 = (t36 * t74) + (t43 * t76);
    const float t80 = 1.0F / (cos_phi * t58);
    const float t81 = t70 * t80;
    const float t83 = t73 * t78 * t81;
    const float t90 = t58 - (t13 * motion->constants[24]) - (t25 * motion->constants[23]);
    const float t97 = (t25 * motion->constants[24]) - (t13 * motion->constants[23]);
    const float t101 = (t29 * motion->constants[10]) + (sin_phi * t62) + (cos_phi * t66) -
        (cos_phi * t97);
    const float t103 = (t26 * t90) - (t13 * t101);
    const float t105 = sin_phi * t25;
    const float t108 = t69 + (sin_phi * t97);
    const float t110 = (t101 * t105) + (t26 * t108);
    const float t115 = t80 * ((t13 * t108) + (t90 * t105));
    const float t119 = t73 * ((t36 * t103) + (t43 * t110) + (t78 * t115));
    const float t122 = motion->constants[7] * t43 * t73;
    const float t126 = (speeds[0] * t83) + (speeds[1] * t119) + (t122 * speeds[2]);
    const float t127 = cos_phi * t126;
    const float t128 = speeds[0] * t127;
    const float t131 = (t13 * speeds[0]) - (t25 * t127);
    const float t134 = (speeds[0] * t81) + (speeds[1] * t115);
    const float t135 = sin_phi * t126;
    const float t136 = t134 - t135;
    const float t137 = motion->constants[24] * t136;
    const float t141 = (t25 * speeds[0]) + (t13 * t127);
    const float t142 = motion->constants[23] * t136;
    const float t144 = (t131 * t137) + (t141 * t142);
    const float t145 = speeds[0] * t135;
    const float t147 = t134 * t141;
    const float t148 = (t25 * t145) + t147;
    const float t151 = t131 * t134;
    const float t152 = (t13 * t145) + t151;
    const float t154 = speeds[2] + t134;
    const float t155 = motion->constants[7] * t154;
    const float t157 = motion->constants[7] * t135;
    const float t159 = (t127 * t157) - (t127 * t155);
    const float t162 = t144 + (motion->constants[23] * t148) + (motion->constants[24] * t152) -
        t159;
    const float t167 = (motion->constants[23] * t131) - (motion->constants[24] * t141);
    const float t169 = (t136 * t142) + (t131 * t167);
    const float t171 = motion->constants[7] * speeds[0];
    const float t172 = t127 * t171;
    const float t174 = t172 + (motion->constants[7] * t128);
    const float t179 = (t157 * (t154 - t135)) - (speeds[0] * t171);
    const float t183 = (t25 * t174) + (t13 * t179) - t169 - (motion->constants[24] * t128);
    const float t185 = speeds[1] + t131;
    const float t189 = (cos_delta * t136) - (sin_delta * t141);
    const float t190 = motion->constants[26] * t189;
    const float t194 = (cos_delta * t141) + (sin_delta * t136);
    const float t195 = motion->constants[25] * t189;
    const float t200 = speeds[1] * t189;
    const float t202 = t200 - (cos_delta * t152) - (sin_delta * t128);
    const float t204 = t31 * motion->constants[10];
    const float t207 = (t43 * t74) - (t36 * t76);
    const float t211 = (t43 * t58) - (t36 * t70);
    const float t214 = 1.0F / motion->constants[10];
    const float t215 = ((t83 * t211) - (t81 * t207)) * t214;
    const float t224 = t214 * ((t36 * t110) + (t119 * t211) - (t43 * t103) - (t115 * t207));
    const float t229 = t214 * ((motion->constants[7] * t36) + (t122 * t211));
    const float t232 = (speeds[0] * t215) + (speeds[1] * t224) + (speeds[2] * t229);
    const float t236 = t33 * motion->constants[10];
    const float t244 = t30 * t47 * ((t31 * t194) + (t33 * t185));
    const float t245 = t236 * t244;
    const float t247 = t204 * t244;
    const float t253 = (cos_delta * t162) + (t185 * t190) + (t194 * t195) + (motion->constants[25] *
        t148) + (t204 * (t148 + (t194 * t232))) + (t185 * t245);
    const float t257 = t253 + (t194 * t247) - (sin_delta * t183) - (motion->constants[26] * t202) -
        (t236 * (t202 - (t185 * t232)));
    const float t264 = (motion->constants[25] * t185) - (motion->constants[26] * t194);
    const float t268 = speeds[1] * t194;
    const float t270 = (sin_delta * t152) - (cos_delta * t128) - t268;
    const float t273 = t189 + t232;
    const float t278 = motion->constants[10] * ((t31 * t185) - (t33 * t194));
    const float t284 = (cos_delta * t183) + (sin_delta * t162) + (motion->constants[26] * t270) +
        (t236 * t270) - (t189 * t195) - (t185 * t264);
    const float t286 = t284 - (t247 * t273) - (t185 * t278);
    const float t290 = (t141 * t167) - (t136 * t137);
    const float t304 = t290 + (motion->constants[23] * t128) + (t13 * t174) + (t194 * t264) +
        (t194 * t278) - (t25 * t179);
    const float t308 = t304 - (t189 * t190) - (motion->constants[25] * t270) - (t204 * t270) -
        (t245 * t273);
    const float t310 = (t31 * t286) + (t33 * t308);
    const float t313 = t80 * ((t47 * t257) + (t29 * t310));
    const float t319 = t73 * ((t29 * t257) + (t78 * t313) - (t47 * t310));
    const float t322 = t313 - t128 - (sin_phi * t319);
    const float t327 = t179 + (cos_phi * motion->constants[40]);
    const float t330 = (motion->constants[7] * t322) - t172;
    const float t332 = (t25 * t327) + (t13 * t330);
    const float t335 = t290 - t332 - (motion->constants[23] * t322);
    const float t341 = t145 - (cos_phi * t319);
    const float t343 = t151 + (t13 * t341);
    const float t346 = (cos_delta * t322) + (sin_delta * t343) - t268;
    const float t351 = (t185 * motion->constants[34]) - (t194 * motion->constants[35]);
    const float t353 = t189 * motion->constants[35];
    const float t357 = (t335 * motion->constants[17]) + (t194 * t351) - (motion->constants[34] *
        t346) - (t189 * t353);
    const float t365 = (t131 * motion->constants[28]) - (motion->constants[29] * t141);
    const float t367 = motion->constants[29] * t136;
    const float t373 = t13 * (t357 + (t141 * t365) - (t332 * motion->constants[1]) - (t322 *
        motion->constants[28]) - (t136 * t367));
    const float t376 = (t13 * t327) - (t25 * t330);
    const float t379 = t376 + (motion->constants[24] * t322) - t169;
    const float t382 = t147 + (t25 * t341);
    const float t386 = t159 + (sin_phi * motion->constants[40]);
    const float t389 = t144 + (motion->constants[23] * t382) + (motion->constants[24] * t343) -
        t386;
    const float t391 = (cos_delta * t379) + (sin_delta * t389);
    const float t394 = t189 * motion->constants[34];
    const float t399 = (t391 * motion->constants[17]) + (motion->constants[35] * t346) - (t189 *
        t394) - (t185 * t351);
    const float t403 = (cos_delta * t389) - (sin_delta * t379);
    const float t409 = t200 + (sin_delta * t322) - (cos_delta * t343);
    const float t416 = (t403 * motion->constants[17]) + (t382 * motion->constants[34]) + (t185 *
        t353) + (t194 * t394) - (motion->constants[35] * t409);
    const float t418 = (cos_delta * t399) - (sin_delta * t416);
    const float t421 = t136 * motion->constants[28];
    const float t428 = t25 * (t418 + (t376 * motion->constants[1]) + (motion->constants[29] *
        t322) - (t136 * t421) - (t131 * t365));
    const float t431 = (t322 * motion->constants[21]) - (motion->constants[7] * (t373 + t428));
    const float t432 = sin_phi * t122;
    const float t441 = (t141 * motion->constants[32]) + (t131 * motion->constants[30]);
    const float t446 = (t141 * motion->constants[30]) + (t131 * motion->constants[33]);
    const float t456 = (t194 * motion->constants[37]) + (t185 * motion->constants[39]);
    const float t462 = (t189 * motion->constants[38]) + (t273 * motion->constants[22]);
    const float t467 = (motion->constants[36] * t409) + (t382 * motion->constants[37]) + (t189 *
        t456) - (motion->constants[35] * t403) - (t185 * t462);
    const float t479 = t214 * ((t31 * t308) + (t211 * t319) - (t33 * t286) - (t207 * t313));
    const float t481 = motion->constants[22] * (t346 + t479);
    const float t484 = (t194 * motion->constants[36]) + (t185 * motion->constants[37]);
    const float t491 = (motion->constants[35] * t391) + (motion->constants[38] * t346) + t481 +
        (t185 * t484) - (motion->constants[34] * t335) - (t194 * t456);
    const float t499 = (motion->constants[29] * t376) + (motion->constants[28] * t332) + (t322 *
        motion->constants[31]) + (t131 * t441) + (sin_delta * t467) + (cos_delta * t491);
    const float t503 = t499 + (motion->constants[24] * t418) + t431 - (t141 * t446) -
        (motion->constants[23] * t357);
    const float t505 = cos_phi * t122;
    const float t512 = (t136 * motion->constants[31]) + (motion->constants[21] * (speeds[2] +
        t136));
    const float t523 = (t403 * motion->constants[34]) + (t409 * motion->constants[37]) + (t382 *
        motion->constants[39]) + (t194 * t462) - (t189 * t484);
    const float t526 = (sin_delta * t399) + (cos_delta * t416);
    const float t532 = (motion->constants[33] * t382) + (t141 * t512) + t523 +
        (motion->constants[23] * t526) - (motion->constants[28] * t386) - (motion->constants[30] *
        t343);
    const float t533 = t532 - (t136 * t441);
    const float t547 = (motion->constants[29] * t386) + (motion->constants[30] * t382) + (t136 *
        t446) + (cos_delta * t467) - (motion->constants[32] * t343) - (t131 * t512);
    const float t549 = t547 - (sin_delta * t491) - (motion->constants[24] * t526);
    const float t551 = (t25 * t533) - (t13 * t549);
    const float t566 = t526 + (motion->constants[28] * t382) + (motion->constants[29] * t343) +
        (t131 * t367) + (t141 * t421) - (t386 * motion->constants[1]);
    const float t569 = t81 - (sin_phi * t83);
    const float t571 = cos_phi * t83;
    const float t578 = forces[0] + (t551 * t571) - (t13 * t533) - (t25 * t549) -
        (motion->constants[7] * t566) - (t503 * t569);
    const float t579 = t578 - (t215 * t481);
    const float t581 = sin_delta * motion->constants[34];
    const float t583 = (sin_delta * motion->constants[37]) - (motion->constants[24] * t581);
    const float t586 = sin_delta * motion->constants[41];
    const float t589 = (cos_delta * t586) - (motion->constants[23] * t581);
    const float t591 = (t13 * t583) + (t25 * t589);
    const float t596 = cos_delta * motion->constants[34];
    const float t598 = (cos_delta * motion->constants[37]) - (motion->constants[24] * t596);
    const float t601 = motion->constants[30] + t598 - motion->constants[44] - motion->constants[45];
    const float t602 = sin_delta * t586;
    const float t606 = motion->constants[32] + motion->constants[36] + motion->constants[43] - t602;
    const float t607 = motion->constants[23] * t596;
    const float t610 = t607 + t607 + motion->constants[46];
    const float t612 = motion->constants[33] + motion->constants[39] + t610;
    const float t613 = t612 - t606;
    const float t614 = t25 * t13;
    const float t616 = t13 * t13;
    const float t617 = t601 + t601;
    const float t623 = motion->constants[28] + t596 + motion->constants[42];
    const float t629 = t601 + (t613 * t614) + (motion->constants[7] * ((t13 *
        motion->constants[47]) + (t25 * t623))) - (t616 * t617);
    const float t633 = (t25 * motion->constants[47]) - (t13 * t623);
    const float t636 = motion->constants[7] * (t633 - motion->constants[48]);
    const float t637 = motion->constants[7] * t633;
    const float t640 = motion->constants[49] - t637 - t637;
    const float t645 = motion->constants[31] + motion->constants[38] + t602 +
        motion->constants[43] + t610 + t640;
    const float t649 = motion->constants[7] * t581;
    const float t651 = (t25 * t583) + t649 - (t13 * t589);
    const float t654 = t636 + (t432 * t645) + (t505 * t651);
    const float t659 = (t613 * t616) + (t614 * t617);
    const float t660 = t612 - t659;
    const float t663 = t649 - (t432 * t651) - (t505 * t660);
    const float t666 = 1.0F - t432;
    const float t667 = motion->constants[21] * t569;
    const float t670 = sin_delta * t13;
    const float t673 = t229 - (cos_delta * t432) - (t505 * t670);
    const float t679 = t215 + (cos_delta * t569) - (sin_delta * t25) - (t571 * t670);
    const float t680 = motion->constants[22] * t679;
    const float t686 = (t666 * t667) + (t673 * t680) - (t432 * t591) - (t505 * t629) - (t569 *
        t654) - (t571 * t663);
    const float t705 = t606 + t640 + t659 + (t569 * t591) + (t569 * (t591 + (t569 * t645) - (t571 *
        t651))) + (t569 * t667);
    const float t708 = t705 + (t679 * t680) - (t571 * t629) - (t571 * (t629 + (t569 * t651) -
        (t571 * t660)));
    const float t709 = 1.0F / t708;
    const float t710 = t686 * t709;
    const float t712 = t25 * t649;
    const float t714 = t115 - (sin_phi * t119);
    const float t716 = cos_phi * t119;
    const float t718 = t583 + t712;
    const float t720 = motion->constants[39] + t607;
    const float t723 = (t25 * t720) - (t13 * t598);
    const float t725 = motion->constants[21] * t714;
    const float t730 = t224 + (cos_delta * t714) - (t670 * t716);
    const float t731 = motion->constants[22] * t730;
    const float t741 = t718 + (t645 * t714) - (t651 * t716);
    const float t746 = t723 + (t651 * t714) - (t660 * t716);
    const float t754 = (t13 * t720) + (t25 * t598) + (motion->constants[7] * t596) + (t591 * t714) +
        (t569 * t741) + (t667 * t714);
    const float t758 = t709 * (t754 + (t680 * t730) - (t629 * t716) - (t571 * t746));
    const float t759 = t708 * t758;
    const float t765 = t712 + (t666 * t725) + (t673 * t731) - (t654 * t714) - (t663 * t716) -
        (t432 * t718);
    const float t779 = motion->constants[39] + (t714 * t741) + (t714 * t718) + (t714 * t725) +
        (t730 * t731) - (t716 * t746);
    const float t781 = t779 - (t716 * t723) - (t758 * t759);
    const float t782 = 1.0F / t781;
    const float t783 = (t765 - (t505 * t723) - (t710 * t759)) * t782;
    const float t793 = forces[1] + (t551 * t716) - t523 - (t503 * t714) - (t224 * t481) - (t579 *
        t758);
    const float t799 = (t432 * t503) + (t505 * t551) - t431 - (t229 * t481) - (t579 * t710) -
        (t783 * t793);
    const float t817 = (t432 * t654) + (t432 * t636) + motion->constants[50] +
        (motion->constants[21] * t666 * t666) + (motion->constants[22] * t673 * t673) - (t505 *
        t663);
    const float t821 = t799 / (t817 - (t505 * t649) - (t708 * t710 * t710) - (t781 * t783 * t783));
    const float t825 = (t782 * t793) - (t783 * t821);
    const float t829 = (t579 * t709) - (t758 * t825) - (t710 * t821);
    const float t833 = t313 + (t81 * t829) + (t115 * t825);
    const float t835 = motion->constants[7] * (t821 + t833);
    const float t838 = t126 * t155;
    const float t843 = (cos_psi * t838) - (t835 * sin_psi);
    const float t855 = t479 + (t215 * t829) + (t224 * t825) + (t229 * t821);
    const float t856 = -((cos_psi * t835) + (sin_psi * t838));
    const float t857 = -(t319 + (t83 * t829) + (t119 * t825) + (t122 * t821));
    accelerations[0] = t856;
    accelerations[1] = t843;
    accelerations[2] = t857;
    accelerations[3] = t829;
    accelerations[4] = t833;
    accelerations[5] = t825;
    accelerations[6] = t821;
    accelerations[7] = t855;
}

carvallo_motion_error_t whipple_mechanism_f32_motion_accelerations(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], const float forces[WHIPPLE_MECHANISM_FORCES],
    float accelerations[WHIPPLE_MECHANISM_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_MECHANISM_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_MECHANISM_FORCES)) {
        whipple_mechanism_f32_compute_accelerations(motion, positions, speeds, forces,
            accelerations);
        error = (carvallo_are_finite_f32(accelerations, WHIPPLE_MECHANISM_POSITIONS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_mechanism_f32_compute_energy(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], float energy[2])
{
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t6 = sin_delta * motion->constants[41];
    const float t7 = sin_delta * t6;
    const float t11 = motion->constants[32] + motion->constants[36] + motion->constants[43] - t7;
    const float t17 = cos_delta * motion->constants[34];
    const float t18 = motion->constants[23] * t17;
    const float t21 = t18 + t18 + motion->constants[46];
    const float t23 = motion->constants[33] + motion->constants[39] + t21;
    const float t24 = t23 - t11;
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t32 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    const float t33 = t32 * t32;
    const float t37 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
    const float t38 = t32 * t37;
    const float t46 = (cos_delta * motion->constants[37]) - (t17 * motion->constants[24]);
    const float t49 = motion->constants[30] + t46 - motion->constants[44] - motion->constants[45];
    const float t50 = t49 + t49;
    const float t52 = (t24 * t33) + (t38 * t50);
    const float t59 = t17 + motion->constants[28] + motion->constants[42];
    const float t61 = (t37 * motion->constants[47]) - (t32 * t59);
    const float t62 = motion->constants[7] * t61;
    const float t65 = motion->constants[49] - t62 - t62;
    const float t67 = sin_delta * motion->constants[34];
    const float t69 = (sin_delta * motion->constants[37]) - (motion->constants[24] * t67);
    const float t73 = (t6 * cos_delta) - (motion->constants[23] * t67);
    const float t75 = (t32 * t69) + (t37 * t73);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t80 = t32 * cos_phi;
    const float t83 = (sin_delta * sin_phi) - (cos_delta * t80);
    const float t85 = t37 * cos_phi;
    const float t88 = sqrtf((t83 * t83) + (t85 * t85));
    const float t89 = 1.0F / t88;
    const float t90 = t83 * t89;
    const float t92 = t85 * t89;
    const float t93 = cos_delta * t92;
    const float t95 = (t37 * t93) - (t32 * t90);
    const float t100 = motion->constants[10] * ((cos_delta * sin_phi) + (sin_delta * t80));
    const float t103 = sin_delta * motion->constants[25];
    const float t108 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const float t110 = (t37 * motion->constants[27]) - (t32 * t108);
    const float t113 = (cos_phi * t103) - (t95 * t100) - (sin_phi * t110);
    const float t114 = (motion->constants[7] * sin_phi) + t113;
    const float t121 = (sin_delta * cos_phi * t92) + (sin_phi * ((t37 * t90) + (t32 * t93)));
    const float t126 = (t100 * t121) + (t32 * motion->constants[27]) + (t37 * t108);
    const float t128 = 1.0F / (cos_phi * t126);
    const float t129 = t114 * t128;
    const float t130 = sin_phi * t126;
    const float t132 = sin_phi * t114;
    const float t134 = (t95 * t130) + (t121 * t132);
    const float t138 = 1.0F / ((t95 * t126) + (t114 * t121));
    const float t140 = t129 * t134 * t138;
    const float t142 = t129 - (sin_phi * t140);
    const float t152 = t49 + (t24 * t38) + (motion->constants[7] * ((t32 * motion->constants[47]) +
        (t37 * t59))) - (t33 * t50);
    const float t153 = cos_phi * t140;
    const float t161 = t7 + motion->constants[43] + t21 + t65 + motion->constants[31] +
        motion->constants[38];
    const float t165 = motion->constants[7] * t67;
    const float t167 = (t37 * t69) + t165 - (t32 * t73);
    const float t173 = t23 - t52;
    const float t179 = t142 * motion->constants[21];
    const float t183 = (t121 * t130) - (t95 * t132);
    const float t187 = (t121 * t126) - (t95 * t114);
    const float t190 = 1.0F / motion->constants[10];
    const float t194 = sin_delta * t32;
    const float t198 = (((t140 * t187) - (t129 * t183)) * t190) + (cos_delta * t142) - (sin_delta *
        t37) - (t153 * t194);
    const float t200 = t198 * motion->constants[22];
    const float t206 = t11 + t52 + t65 + (t75 * t142) + (t142 * (t75 + (t142 * t161) - (t153 *
        t167))) + (t142 * t179);
    const float t210 = speeds[0] * (t206 + (t198 * t200) - (t152 * t153) - (t153 * (t152 + (t142 *
        t167) - (t153 * t173))));
    const float t212 = motion->constants[39] + t18;
    const float t218 = (t37 * motion->constants[24]) - (motion->constants[23] * t32);
    const float t220 = t113 + (sin_phi * t218);
    const float t222 = t37 * sin_phi;
    const float t226 = t126 - (t32 * motion->constants[24]) - (motion->constants[23] * t37);
    const float t229 = t128 * ((t32 * t220) + (t222 * t226));
    const float t237 = (t88 * motion->constants[10]) + (sin_phi * t103) + (cos_phi * t110) -
        (cos_phi * t218);
    const float t239 = (t85 * t226) - (t32 * t237);
    const float t243 = (t222 * t237) + (t85 * t220);
    const float t248 = t138 * ((t95 * t239) + (t121 * t243) + (t134 * t229));
    const float t250 = t229 - (sin_phi * t248);
    const float t252 = cos_phi * t248;
    const float t254 = t37 * t165;
    const float t255 = t69 + t254;
    const float t259 = t255 + (t161 * t250) - (t167 * t252);
    const float t263 = (t37 * t212) - (t32 * t46);
    const float t267 = t263 + (t167 * t250) - (t173 * t252);
    const float t280 = (t190 * ((t95 * t243) + (t187 * t248) - (t121 * t239) - (t183 * t229))) +
        (cos_delta * t250);
    const float t281 = t280 - (t194 * t252);
    const float t287 = (t32 * t212) + (t37 * t46) + (t17 * motion->constants[7]) + (t75 * t250) +
        (t142 * t259) + (t179 * t250);
    const float t290 = t287 + (t200 * t281) - (t152 * t252) - (t153 * t267);
    const float t294 = motion->constants[7] * t121 * t138;
    const float t295 = sin_phi * t294;
    const float t297 = cos_phi * t294;
    const float t300 = t61 - motion->constants[48];
    const float t301 = motion->constants[7] * t300;
    const float t305 = t301 + (t161 * t295) + (t167 * t297);
    const float t310 = t165 - (t167 * t295) - (t173 * t297);
    const float t313 = 1.0F - t295;
    const float t322 = (t190 * ((motion->constants[7] * t95) + (t187 * t294))) - (cos_delta *
        t295) - (t194 * t297);
    const float t328 = (t179 * t313) + (t200 * t322) - (t75 * t295) - (t152 * t297) - (t142 *
        t305) - (t153 * t310);
    const float t338 = motion->constants[21] * t250;
    const float t340 = motion->constants[22] * t281;
    const float t346 = motion->constants[39] + (t250 * t259) + (t250 * t255) + (t250 * t338) +
        (t281 * t340) - (t252 * t267);
    const float t359 = t254 + (t313 * t338) + (t322 * t340) - (t250 * t305) - (t252 * t310) -
        (t255 * t295);
    const float t360 = t359 - (t263 * t297);
    const float t364 = speeds[1] * ((speeds[0] * t290) + (speeds[1] * (t346 - (t252 * t263))) +
        (speeds[2] * t360));
    const float t380 = (t295 * t305) + (t295 * t301) + motion->constants[50] +
        (motion->constants[21] * t313 * t313) + (motion->constants[22] * t322 * t322) - (t297 *
        t310);
    const float t387 = (speeds[0] * (t210 + (speeds[1] * t290) + (speeds[2] * t328))) + t364 +
        (speeds[2] * ((speeds[0] * t328) + (speeds[1] * t360) + (speeds[2] * (t380 - (t165 *
        t297)))));
    const float t389 = t387 * 0.5F;
    const float t395 = -(motion->constants[40] * ((t67 * sin_phi) + (cos_phi * t300)));
    energy[0] = t389;
    energy[1] = t395;
}

carvallo_motion_error_t whipple_mechanism_f32_motion_energy(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], float energy[2])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_MECHANISM_SPEEDS)) {
        whipple_mechanism_f32_compute_energy(motion, positions, speeds, energy);
        error = (carvallo_are_finite_f32(energy, 2U)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

/* How far the lowest points of the wheels behind the first are below the ground, and the steps of Newton's method. */
static void whipple_mechanism_f32_compute_closure(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS], float below[1U], float steps[1U])
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
    const float t14 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    const float t15 = cos_phi * t14;
    const float t19 = sin_phi * sin_delta;
    const float t20 = t19 - (cos_delta * t15);
    const float t24 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
    const float t25 = cos_phi * t24;
    const float t28 = sqrtf((t20 * t20) + (t25 * t25));
    const float t36 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const float t42 = (motion->constants[10] * t28) + (t19 * motion->constants[25]) + (cos_phi *
        ((t24 * motion->constants[27]) - (t14 * t36))) - (motion->constants[7] * cos_phi);
    const float t46 = 1.0F / t28;
    const float t47 = t25 * t46;
    const float t58 = motion->constants[10] * ((cos_delta * sin_phi) + (t15 * sin_delta)) *
        ((cos_phi * sin_delta * t47) + (sin_phi * ((t20 * t24 * t46) + (cos_delta * t14 * t47))));
    const float t64 = t42 / (cos_phi * (t58 + (t14 * motion->constants[27]) + (t24 * t36)));
    below[0] = t42;
    steps[0] = t64;
}

carvallo_motion_error_t whipple_mechanism_f32_motion_close(const whipple_mechanism_f32_motion_t *motion,
    float positions[WHIPPLE_MECHANISM_POSITIONS])
{
    /* The positions that the heights of the wheels determine. */
    static const size_t DEPENDENT[1U] = {4U};
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_MECHANISM_POSITIONS)) {
        float found[WHIPPLE_MECHANISM_POSITIONS];
        float below[1U];
        float steps[1U];
        float shortest = 1e30F;
        bool is_closed = false;
        bool goes_on = true;
        for (size_t i = 0U; i < WHIPPLE_MECHANISM_POSITIONS; i++) {
            found[i] = positions[i];
        }
        /* With steps of the greatest length they lead around the whole circle; near a solution a handful is enough. */
        for (size_t count = 0U; goes_on && (count < 60U); count++) {
            whipple_mechanism_f32_compute_closure(motion, found, below, steps);
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
            whipple_mechanism_f32_compute_closure(motion, found, below, steps);
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

static void whipple_mechanism_f32_compute_contact_forces(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], const float forces[WHIPPLE_MECHANISM_FORCES],
    float contact_forces[3U * WHIPPLE_MECHANISM_WHEELS])
{
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t9 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    const float t13 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
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
    const float t48 = motion->constants[10] * t47;
    const float t55 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const float t58 = (t43 * t48) + (t9 * motion->constants[27]) + (t13 * t55);
    const float t59 = sin_phi * t58;
    const float t64 = sin_delta * motion->constants[25];
    const float t68 = (t13 * motion->constants[27]) - (t9 * t55);
    const float t71 = (cos_phi * t64) - (t36 * t48) - (sin_phi * t68);
    const float t72 = (sin_phi * motion->constants[7]) + t71;
    const float t73 = sin_phi * t72;
    const float t75 = (t36 * t59) + (t43 * t73);
    const float t77 = 1.0F / (cos_phi * t58);
    const float t78 = t72 * t77;
    const float t82 = 1.0F / ((t36 * t58) + (t43 * t72));
    const float t84 = t75 * t78 * t82;
    const float t91 = t58 - (t9 * motion->constants[24]) - (t13 * motion->constants[23]);
    const float t98 = (t13 * motion->constants[24]) - (t9 * motion->constants[23]);
    const float t102 = (t29 * motion->constants[10]) + (sin_phi * t64) + (cos_phi * t68) -
        (cos_phi * t98);
    const float t104 = (t26 * t91) - (t9 * t102);
    const float t106 = t13 * sin_phi;
    const float t109 = t71 + (sin_phi * t98);
    const float t111 = (t102 * t106) + (t26 * t109);
    const float t116 = t77 * ((t9 * t109) + (t91 * t106));
    const float t120 = t82 * ((t36 * t104) + (t43 * t111) + (t75 * t116));
    const float t124 = t43 * motion->constants[7] * t82;
    const float t127 = (speeds[0] * t84) + (speeds[1] * t120) + (speeds[2] * t124);
    const float t128 = cos_phi * t127;
    const float t130 = (speeds[0] * t13) + (t9 * t128);
    const float t133 = (t9 * speeds[0]) - (t13 * t128);
    const float t138 = (t133 * motion->constants[28]) - (t130 * motion->constants[29]);
    const float t142 = (speeds[0] * t78) + (speeds[1] * t116);
    const float t143 = sin_phi * t127;
    const float t144 = t142 - t143;
    const float t145 = motion->constants[29] * t144;
    const float t147 = (t130 * t138) - (t144 * t145);
    const float t149 = speeds[0] * motion->constants[7];
    const float t151 = speeds[2] + t142;
    const float t153 = motion->constants[7] * t143;
    const float t155 = ((t151 - t143) * t153) - (speeds[0] * t149);
    const float t158 = t155 + (cos_phi * motion->constants[40]);
    const float t159 = t13 * t158;
    const float t160 = t128 * t149;
    const float t161 = motion->constants[24] * t144;
    const float t163 = motion->constants[23] * t144;
    const float t165 = (t133 * t161) + (t130 * t163);
    const float t166 = speeds[0] * t143;
    const float t168 = t130 * t142;
    const float t169 = (t13 * t166) + t168;
    const float t172 = t133 * t142;
    const float t173 = (t9 * t166) + t172;
    const float t175 = t128 * t151;
    const float t177 = t128 * t153;
    const float t178 = t177 - (motion->constants[7] * t175);
    const float t181 = t165 + (motion->constants[23] * t169) + (motion->constants[24] * t173) -
        t178;
    const float t186 = (motion->constants[23] * t133) - (motion->constants[24] * t130);
    const float t188 = (t144 * t163) + (t133 * t186);
    const float t189 = speeds[0] * t128;
    const float t192 = t160 + (motion->constants[7] * t189);
    const float t197 = (t13 * t192) + (t9 * t155) - t188 - (motion->constants[24] * t189);
    const float t199 = speeds[1] + t133;
    const float t203 = (cos_delta * t144) - (sin_delta * t130);
    const float t204 = motion->constants[26] * t203;
    const float t208 = (cos_delta * t130) + (sin_delta * t144);
    const float t209 = motion->constants[25] * t203;
    const float t214 = speeds[1] * t203;
    const float t216 = t214 - (cos_delta * t173) - (sin_delta * t189);
    const float t218 = t31 * motion->constants[10];
    const float t221 = (t43 * t59) - (t36 * t73);
    const float t225 = (t43 * t58) - (t36 * t72);
    const float t228 = 1.0F / motion->constants[10];
    const float t229 = ((t84 * t225) - (t78 * t221)) * t228;
    const float t238 = t228 * ((t36 * t111) + (t120 * t225) - (t43 * t104) - (t116 * t221));
    const float t243 = t228 * ((t36 * motion->constants[7]) + (t124 * t225));
    const float t246 = (speeds[0] * t229) + (speeds[1] * t238) + (speeds[2] * t243);
    const float t250 = t33 * motion->constants[10];
    const float t258 = t30 * t47 * ((t31 * t208) + (t33 * t199));
    const float t259 = t250 * t258;
    const float t261 = t218 * t258;
    const float t267 = (cos_delta * t181) + (t199 * t204) + (t208 * t209) + (motion->constants[25] *
        t169) + (t218 * (t169 + (t208 * t246))) + (t199 * t259);
    const float t271 = t267 + (t208 * t261) - (sin_delta * t197) - (motion->constants[26] * t216) -
        (t250 * (t216 - (t199 * t246)));
    const float t278 = (motion->constants[25] * t199) - (motion->constants[26] * t208);
    const float t282 = speeds[1] * t208;
    const float t284 = (sin_delta * t173) - (cos_delta * t189) - t282;
    const float t287 = t203 + t246;
    const float t292 = motion->constants[10] * ((t31 * t199) - (t33 * t208));
    const float t298 = (cos_delta * t197) + (sin_delta * t181) + (motion->constants[26] * t284) +
        (t250 * t284) - (t203 * t209) - (t199 * t278);
    const float t300 = t298 - (t261 * t287) - (t199 * t292);
    const float t304 = (t130 * t186) - (t144 * t161);
    const float t318 = t304 + (motion->constants[23] * t189) + (t9 * t192) + (t208 * t278) + (t208 *
        t292) - (t13 * t155);
    const float t322 = t318 - (t203 * t204) - (motion->constants[25] * t284) - (t218 * t284) -
        (t259 * t287);
    const float t324 = (t31 * t300) + (t33 * t322);
    const float t329 = t77 * ((t47 * t271) + (t29 * t324));
    const float t333 = t82 * ((t29 * t271) + (t75 * t329) - (t47 * t324));
    const float t335 = t189 - t329;
    const float t336 = (sin_phi * t333) + t335;
    const float t340 = (motion->constants[7] * t336) + t160;
    const float t342 = t159 - (t9 * t340);
    const float t345 = t304 - t342 + (motion->constants[23] * t336);
    const float t351 = t166 - (cos_phi * t333);
    const float t353 = t172 + (t9 * t351);
    const float t356 = (sin_delta * t353) - (cos_delta * t336) - t282;
    const float t361 = (t199 * motion->constants[34]) - (t208 * motion->constants[35]);
    const float t363 = t203 * motion->constants[35];
    const float t365 = (t208 * t361) - (t203 * t363);
    const float t367 = (t345 * motion->constants[17]) + t365 - (motion->constants[34] * t356);
    const float t375 = t9 * t158;
    const float t376 = t375 + (t13 * t340);
    const float t379 = t376 - (motion->constants[24] * t336) - t188;
    const float t382 = t168 + (t13 * t351);
    const float t385 = sin_phi * motion->constants[40];
    const float t386 = t178 + t385;
    const float t389 = t165 + (motion->constants[23] * t382) + (motion->constants[24] * t353) -
        t386;
    const float t391 = (cos_delta * t379) + (sin_delta * t389);
    const float t394 = t203 * motion->constants[34];
    const float t397 = (t203 * t394) + (t199 * t361);
    const float t399 = (t391 * motion->constants[17]) + (motion->constants[35] * t356) - t397;
    const float t403 = (cos_delta * t389) - (sin_delta * t379);
    const float t409 = t214 - (sin_delta * t336) - (cos_delta * t353);
    const float t413 = (t199 * t363) + (t208 * t394);
    const float t416 = (t403 * motion->constants[17]) + (t382 * motion->constants[34]) + t413 -
        (motion->constants[35] * t409);
    const float t418 = (cos_delta * t399) - (sin_delta * t416);
    const float t421 = motion->constants[28] * t144;
    const float t424 = (t144 * t421) + (t133 * t138);
    const float t429 = (t9 * (t147 + t367 - (motion->constants[1] * t342) + (motion->constants[28] *
        t336))) + (t13 * (t418 + (motion->constants[1] * t376) - (motion->constants[29] * t336) -
        t424));
    const float t431 = (t336 * motion->constants[21]) + (motion->constants[7] * t429);
    const float t432 = sin_phi * t124;
    const float t441 = (t130 * motion->constants[32]) + (t133 * motion->constants[30]);
    const float t446 = (t130 * motion->constants[30]) + (t133 * motion->constants[33]);
    const float t448 = (t133 * t441) - (t130 * t446);
    const float t457 = (t208 * motion->constants[37]) + (t199 * motion->constants[39]);
    const float t463 = (t203 * motion->constants[38]) + (t287 * motion->constants[22]);
    const float t465 = (t203 * t457) - (t199 * t463);
    const float t468 = (motion->constants[36] * t409) + (t382 * motion->constants[37]) + t465 -
        (motion->constants[35] * t403);
    const float t480 = t228 * ((t31 * t322) + (t225 * t333) - (t33 * t300) - (t221 * t329));
    const float t482 = motion->constants[22] * (t356 + t480);
    const float t485 = (t208 * motion->constants[36]) + (t199 * motion->constants[37]);
    const float t488 = (t199 * t485) - (t208 * t457);
    const float t492 = (motion->constants[35] * t391) + (motion->constants[38] * t356) + t482 +
        t488 - (motion->constants[34] * t345);
    const float t500 = (motion->constants[29] * t376) + (motion->constants[28] * t342) - (t336 *
        motion->constants[31]) + t448 + (sin_delta * t468) + (cos_delta * t492);
    const float t503 = t500 + (motion->constants[24] * t418) - t431 - (motion->constants[23] *
        t367);
    const float t505 = cos_phi * t124;
    const float t512 = (t144 * motion->constants[31]) + (motion->constants[21] * (speeds[2] +
        t144));
    const float t515 = (t130 * t512) - (t144 * t441);
    const float t521 = (t208 * t463) - (t203 * t485);
    const float t524 = (t403 * motion->constants[34]) + (t409 * motion->constants[37]) + (t382 *
        motion->constants[39]) + t521;
    const float t527 = (sin_delta * t399) + (cos_delta * t416);
    const float t533 = (motion->constants[33] * t382) + t515 + t524 + (motion->constants[23] *
        t527) - (motion->constants[28] * t386) - (motion->constants[30] * t353);
    const float t540 = (t144 * t446) - (t133 * t512);
    const float t548 = (motion->constants[29] * t386) + (motion->constants[30] * t382) + t540 +
        (cos_delta * t468) - (motion->constants[32] * t353) - (sin_delta * t492);
    const float t549 = t548 - (motion->constants[24] * t527);
    const float t551 = (t13 * t533) - (t9 * t549);
    const float t562 = (t133 * t145) + (t130 * t421);
    const float t567 = motion->constants[7] * (t527 + (motion->constants[28] * t382) +
        (motion->constants[29] * t353) + t562 - (motion->constants[1] * t386));
    const float t569 = t78 - (sin_phi * t84);
    const float t571 = cos_phi * t84;
    const float t578 = forces[0] + (t551 * t571) - (t9 * t533) - (t13 * t549) - t567 - (t503 *
        t569);
    const float t579 = t578 - (t229 * t482);
    const float t581 = sin_delta * motion->constants[34];
    const float t583 = (sin_delta * motion->constants[37]) - (motion->constants[24] * t581);
    const float t586 = sin_delta * motion->constants[41];
    const float t589 = (cos_delta * t586) - (motion->constants[23] * t581);
    const float t591 = (t9 * t583) + (t13 * t589);
    const float t596 = cos_delta * motion->constants[34];
    const float t598 = (cos_delta * motion->constants[37]) - (motion->constants[24] * t596);
    const float t601 = motion->constants[30] + t598 - motion->constants[44] - motion->constants[45];
    const float t602 = sin_delta * t586;
    const float t606 = motion->constants[32] + motion->constants[36] + motion->constants[43] - t602;
    const float t607 = motion->constants[23] * t596;
    const float t610 = t607 + t607 + motion->constants[46];
    const float t612 = motion->constants[33] + motion->constants[39] + t610;
    const float t613 = t612 - t606;
    const float t614 = t9 * t13;
    const float t616 = t9 * t9;
    const float t617 = t601 + t601;
    const float t623 = motion->constants[28] + t596 + motion->constants[42];
    const float t629 = t601 + (t613 * t614) + (motion->constants[7] * ((t9 *
        motion->constants[47]) + (t13 * t623))) - (t616 * t617);
    const float t633 = (t13 * motion->constants[47]) - (t9 * t623);
    const float t636 = motion->constants[7] * (t633 - motion->constants[48]);
    const float t637 = motion->constants[7] * t633;
    const float t640 = motion->constants[49] - t637 - t637;
    const float t645 = motion->constants[31] + motion->constants[38] + t602 +
        motion->constants[43] + t610 + t640;
    const float t649 = motion->constants[7] * t581;
    const float t651 = (t13 * t583) + t649 - (t9 * t589);
    const float t654 = t636 + (t432 * t645) + (t505 * t651);
    const float t659 = (t613 * t616) + (t614 * t617);
    const float t660 = t612 - t659;
    const float t663 = t649 - (t432 * t651) - (t505 * t660);
    const float t666 = 1.0F - t432;
    const float t667 = motion->constants[21] * t569;
    const float t670 = t9 * sin_delta;
    const float t673 = t243 - (cos_delta * t432) - (t505 * t670);
    const float t679 = t229 + (cos_delta * t569) - (t13 * sin_delta) - (t571 * t670);
    const float t680 = motion->constants[22] * t679;
    const float t686 = (t666 * t667) + (t673 * t680) - (t432 * t591) - (t505 * t629) - (t569 *
        t654) - (t571 * t663);
    const float t705 = t606 + t640 + t659 + (t569 * t591) + (t569 * (t591 + (t569 * t645) - (t571 *
        t651))) + (t569 * t667);
    const float t708 = t705 + (t679 * t680) - (t571 * t629) - (t571 * (t629 + (t569 * t651) -
        (t571 * t660)));
    const float t709 = 1.0F / t708;
    const float t710 = t686 * t709;
    const float t712 = t13 * t649;
    const float t714 = t116 - (sin_phi * t120);
    const float t716 = cos_phi * t120;
    const float t718 = t583 + t712;
    const float t720 = motion->constants[39] + t607;
    const float t723 = (t13 * t720) - (t9 * t598);
    const float t725 = motion->constants[21] * t714;
    const float t730 = t238 + (cos_delta * t714) - (t670 * t716);
    const float t731 = motion->constants[22] * t730;
    const float t741 = t718 + (t645 * t714) - (t651 * t716);
    const float t746 = t723 + (t651 * t714) - (t660 * t716);
    const float t754 = (t9 * t720) + (t13 * t598) + (motion->constants[7] * t596) + (t591 * t714) +
        (t569 * t741) + (t667 * t714);
    const float t758 = t709 * (t754 + (t680 * t730) - (t629 * t716) - (t571 * t746));
    const float t759 = t708 * t758;
    const float t765 = t712 + (t666 * t725) + (t673 * t731) - (t654 * t714) - (t663 * t716) -
        (t432 * t718);
    const float t779 = motion->constants[39] + (t714 * t741) + (t714 * t718) + (t714 * t725) +
        (t730 * t731) - (t716 * t746);
    const float t781 = t779 - (t716 * t723) - (t758 * t759);
    const float t782 = 1.0F / t781;
    const float t783 = (t765 - (t505 * t723) - (t710 * t759)) * t782;
    const float t793 = forces[1] + (t551 * t716) - t524 - (t503 * t714) - (t238 * t482) - (t579 *
        t758);
    const float t799 = (t432 * t503) + (t505 * t551) + t431 - (t243 * t482) - (t579 * t710) -
        (t783 * t793);
    const float t817 = (t432 * t654) + (t432 * t636) + motion->constants[50] +
        (motion->constants[21] * t666 * t666) + (motion->constants[22] * t673 * t673) - (t505 *
        t663);
    const float t821 = t799 / (t817 - (t505 * t649) - (t708 * t710 * t710) - (t781 * t783 * t783));
    const float t825 = (t782 * t793) - (t783 * t821);
    const float t829 = (t579 * t709) - (t758 * t825) - (t710 * t821);
    const float t837 = t333 + (t84 * t829) + (t120 * t825) + (t124 * t821);
    const float t841 = (t78 * t829) + (t116 * t825) - (sin_phi * t837) - t335;
    const float t842 = t821 + t841;
    const float t844 = (motion->constants[7] * t842) - t160;
    const float t846 = t159 + (t9 * t844);
    const float t851 = t304 - t846 - (motion->constants[23] * t841);
    const float t856 = t166 - (cos_phi * t837);
    const float t859 = (t13 * t829) - t172 - (t9 * t856);
    const float t862 = (cos_delta * t841) - t282 - (sin_delta * t859);
    const float t865 = t365 + (motion->constants[17] * t851) - (motion->constants[34] * t862);
    const float t868 = t147 + t865 - (motion->constants[1] * t846) - (motion->constants[28] * t841);
    const float t871 = t375 - (t13 * t844);
    const float t876 = t871 + (motion->constants[24] * t841) - t188;
    const float t881 = t168 + (t13 * t856) + (t9 * t829);
    const float t887 = t177 + t385 - (motion->constants[7] * (t175 + t829));
    const float t890 = t165 + (motion->constants[23] * t881) - (motion->constants[24] * t859) -
        t887;
    const float t892 = (cos_delta * t876) + (sin_delta * t890);
    const float t896 = (motion->constants[17] * t892) + (motion->constants[35] * t862) - t397;
    const float t900 = (cos_delta * t890) - (sin_delta * t876);
    const float t902 = t825 + t881;
    const float t907 = t214 + (cos_delta * t859) + (sin_delta * t841);
    const float t911 = t413 + (motion->constants[17] * t900) + (motion->constants[34] * t902) -
        (motion->constants[35] * t907);
    const float t913 = (cos_delta * t896) - (sin_delta * t911);
    const float t916 = (motion->constants[1] * t871) + (motion->constants[29] * t841) + t913 - t424;
    const float t918 = (t9 * t868) + (t13 * t916);
    const float t926 = motion->constants[22] * (t480 + t862 + (t229 * t829) + (t238 * t825) +
        (t243 * t821));
    const float t927 = t228 * t926;
    const float t938 = t465 + (motion->constants[36] * t907) + (motion->constants[37] * t902) -
        (motion->constants[35] * t900);
    const float t946 = t488 + t926 + (motion->constants[35] * t892) + (motion->constants[38] *
        t862) - (motion->constants[34] * t851);
    const float t955 = t448 + (motion->constants[29] * t871) + (motion->constants[28] * t846) +
        (motion->constants[31] * t841) + (motion->constants[21] * t842) + (sin_delta * t938);
    const float t959 = t955 + (cos_delta * t946) + (motion->constants[24] * t913) -
        (motion->constants[23] * t865) - (motion->constants[7] * t918);
    const float t969 = (sin_delta * t896) + (cos_delta * t911);
    const float t976 = t515 + t521 + (motion->constants[30] * t859) + (motion->constants[33] *
        t881) + (motion->constants[34] * t900) + (motion->constants[37] * t907) +
        (motion->constants[39] * t902);
    const float t990 = t540 + (motion->constants[29] * t887) + (motion->constants[32] * t859) +
        (motion->constants[30] * t881) + (cos_delta * t938) - (sin_delta * t946);
    const float t994 = cos_phi * ((t13 * (t976 + (motion->constants[23] * t969) -
        (motion->constants[28] * t887))) - (t9 * (t990 - (motion->constants[24] * t969))));
    const float t998 = t82 * ((sin_phi * t959) + t994 - (t225 * t927));
    const float t1000 = (t36 * t927) - (t43 * t998);
    const float t1001 = t918 - t1000;
    const float t1006 = (t43 * t927) + (t36 * t998);
    const float t1013 = t562 + t969 + (motion->constants[28] * t881) - (motion->constants[1] *
        t887) - (motion->constants[29] * t859);
    const float t1017 = (t13 * t868) - (t9 * t916);
    const float t1020 = (cos_phi * t1013) - t1006 - (sin_phi * t1017);
    const float t1022 = (cos_psi * t1001) - (sin_psi * t1020);
    const float t1025 = (t1001 * sin_psi) + (cos_psi * t1020);
    const float t1030 = t77 * (t959 - (t75 * t998) - (t221 * t927));
    const float t1034 = t1030 + (sin_phi * t1013) + (cos_phi * t1017);
    const float t1037 = (cos_psi * t1000) - (sin_psi * t1006);
    const float t1040 = (t1000 * sin_psi) + (cos_psi * t1006);
    const float t1041 = -t1030;
    contact_forces[0] = t1022;
    contact_forces[1] = t1025;
    contact_forces[2] = t1034;
    contact_forces[3] = t1037;
    contact_forces[4] = t1040;
    contact_forces[5] = t1041;
}

carvallo_motion_error_t whipple_mechanism_f32_motion_contact_forces(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], const float forces[WHIPPLE_MECHANISM_FORCES],
    float contact_forces[3U * WHIPPLE_MECHANISM_WHEELS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_MECHANISM_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_MECHANISM_FORCES)) {
        whipple_mechanism_f32_compute_contact_forces(motion, positions, speeds, forces,
            contact_forces);
        error = (carvallo_are_finite_f32(contact_forces, 3U * WHIPPLE_MECHANISM_WHEELS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}
