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
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 36U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 36U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 91U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 37U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 48U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 96U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 62U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 62U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 65U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 40U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 66U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 18U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 18U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 95U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 39U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 47U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 64U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 63U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 63U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 67U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 68U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 23U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 23U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 121U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 45U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 69U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 98U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 71U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 71U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 97U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 38U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 92U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 13U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 4U, 28U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 4U, 31U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 1U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 4U, 24U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 14U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 79U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 0U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 5U, 78U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 32U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 6U, 33U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 7U, 30U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 7U, 30U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 7U, 21U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 8U, 29U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 8U, 29U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 8U, 53U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 8U, 81U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 8U, 93U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 8U, 85U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 8U, 85U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 8U, 86U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 87U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 17U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 46U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 46U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 9U, 84U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 3U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 9U, 83U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 10U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 10U, 55U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 10U, 55U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 10U, 56U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 10U, 82U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 10U, 59U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 10U, 2U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 10U, 54U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 10U, 54U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 10U, 57U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 10U, 80U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 10U, 58U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 11U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 13U, 32U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 13U, 33U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 14U, 27U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 14U, 27U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 14U, 19U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 15U, 35U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 15U, 35U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 89U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 102U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 105U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 88U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 88U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 90U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 94U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 15U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 72U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 72U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 73U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 77U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 75U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 5U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 70U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 70U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 112U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 76U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 74U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 11U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 41U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 41U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 42U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 103U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 61U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 20U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 20U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 43U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 101U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 60U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 18U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 18U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 18U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 18U, 111U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 20U, 113U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 20U, 104U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 21U, 34U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 21U, 34U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 21U, 115U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 21U, 19U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 21U, 106U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 22U, 16U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 22U, 99U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 22U, 99U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 100U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 22U, 44U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 22U, 110U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 22U, 118U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 22U, 7U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 22U, 116U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 22U, 116U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 22U, 119U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 22U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 22U, 107U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 23U, 12U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 50U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 50U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 114U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 120U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 122U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 6U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 49U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 49U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 51U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 25U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 52U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 117U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 104U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 109U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 109U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 26U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 108U, false}
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
    const double t2 = p->zH * p->mH;
    const double t9 = p->rR * p->mR;
    const double t13 = p->rF * p->mF;
    const double t18 = (p->rF * t13) + (p->IHxx + p->IFxx);
    const double t21 = p->zB * p->mB;
    const double M_11 = (p->zH * t2) + (p->IRxx + p->IBxx + ((p->rR * t9) + (t18 + (p->zB * t21))));
    double wx_delta2_delta = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &wx_delta2_delta, &cos_lam);
    const double yaw_per_v_delta = cos_lam / p->w;
    const double mu = p->c * yaw_per_v_delta;
    const double wz_delta2_delta = cos_lam + mu;
    const double t38 = (wz_delta2_delta * p->IHxz) + (t18 * wx_delta2_delta);
    const double t42 = p->IBxz - (t21 * p->xB);
    const double t47 = (p->zH * wx_delta2_delta) + (cos_lam * (p->c + p->w));
    const double t51 = p->mH * (t47 - (p->xH * wz_delta2_delta));
    const double M_12 = t38 + ((mu * t42) + (p->zH * t51));
    const double t57 = p->mB * p->xB;
    const double t61 = mu * (p->IBzz + (p->IRxx + (p->xB * t57)));
    const double t71 = (wz_delta2_delta * (p->IFxx + p->IHzz)) + (wx_delta2_delta * p->IHxz) -
        (p->xH * t51);
    const double M_22 = (t47 * t51) + ((mu * t61) + (wx_delta2_delta * t38) + (wz_delta2_delta *
        t71));
    const double SF = p->IFyy / p->rF;
    const double t78 = t13 + SF;
    const double SR = p->IRyy / p->rR;
    const double t83 = t21 - (t9 - t2);
    const double ST = SR - t83;
    const double C1_12 = (wz_delta2_delta * t78) + (yaw_per_v_delta * (t42 + (p->c * ST) +
        (p->IHxz - (t2 * p->xH))));
    const double t95 = t13 * wx_delta2_delta;
    const double K0_12 = t51 - (mu * t57) - t95;
    const double C1_22 = (cos_lam * t95) - (yaw_per_v_delta * ((p->c * K0_12) - t61 - t71));
    const double K0_22 = wx_delta2_delta * K0_12;
    const double K2_12 = yaw_per_v_delta * (ST + t78);
    const double K2_22 = yaw_per_v_delta * ((wx_delta2_delta * SF) - K0_12);
    const double C1_21 = -((mu * SR) + (wz_delta2_delta * SF));
    const double K0_11 = t83 - t13;
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
    double wx_delta2_delta = 0.0;
    double wx_delta2_delta_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const double M_11_mB = p->zB * p->zB;
    const double t28 = p->rR * p->mR;
    const double M_11_mH = p->zH * p->zH;
    const double M_11_mF = p->rF * p->rF;
    const double t35 = (p->mH * M_11_mH) + p->IHxx + p->IFxx + (p->mF * M_11_mF);
    const double t36 = 1.0 / p->w;
    const double M_11_rR = t28 + t28;
    const double M_11_mR = p->rR * p->rR;
    const double t39 = p->mH * p->xH;
    const double M_12_wz_delta2_delta = p->IHxz - (p->zH * t39);
    const double t42 = p->mB * p->xB;
    const double t43 = p->mH * p->zH;
    const double M_11_zH = t43 + t43;
    const double t45 = p->c + p->w;
    const double t46 = t45 - p->xH;
    const double t50 = t36 * (p->IBxz + M_12_wz_delta2_delta - (p->zB * t42));
    const double t52 = p->IHxz + (t43 * t46);
    const double t55 = p->IFxx + p->IHzz + (p->xH * t39);
    const double t56 = p->c * t36;
    const double t57 = 1.0 / p->rF;
    const double C1_22_wz_delta2_delta = p->mB * M_11_mB;
    const double M_11 = p->IBxx + C1_22_wz_delta2_delta + (p->rR * t28) + p->IRxx + t35;
    const double SF = p->IFyy * t57;
    const double t65 = p->mF * p->rF;
    const double M_11_rF = t65 + t65;
    const double t67 = 1.0 / p->rR;
    const double t68 = p->mB * p->zB;
    const double K0_11 = t68 - (t28 + t65 - t43);
    const double M_11_zB = t68 + t68;
    const double SR = p->IRyy * t67;
    const double t74 = t39 + t42;
    const double t75 = p->c + p->xB;
    const double t76 = p->c + p->xH;
    const double t78 = (p->c * t50) + t52;
    const double t80 = p->mF - (t57 * SF);
    const double t81 = SF + SR;
    const double t83 = p->mR - (t67 * SR);
    const double t84 = t35 * wx_delta2_delta;
    const double M_12_c = wx_delta2_delta_lam * (t50 + t43);
    const double yaw_per_v_delta = wx_delta2_delta_lam * t36;
    const double K0_12_mH = (p->zH * wx_delta2_delta) + (wx_delta2_delta_lam * (t46 - (p->xH *
        t56)));
    const double t93 = t81 - K0_11;
    const double t94 = wx_delta2_delta_lam * t39;
    const double K2_12_IRyy = yaw_per_v_delta * t67;
    const double K2_12_rF = yaw_per_v_delta * t80;
    const double M_12_lam = (t35 * wx_delta2_delta_lam) - (wx_delta2_delta * t78);
    const double M_12 = t84 + (wx_delta2_delta_lam * t78);
    const double K2_12_rR = yaw_per_v_delta * t83;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double K2_12_IFyy = yaw_per_v_delta * t57;
    const double t105 = M_12_wz_delta2_delta * yaw_per_v_delta;
    const double ST = t84 + (wx_delta2_delta_lam * t52) + (p->c * t105);
    const double t110 = wx_delta2_delta * M_12_wz_delta2_delta;
    const double mu = p->c * yaw_per_v_delta;
    const double C1_12_rR = mu * t83;
    const double t113 = mu * t68;
    const double C1_12_IRyy = mu * t67;
    const double C1_21_rR = SR * C1_12_IRyy;
    const double M_22_IRxx = mu * mu;
    const double C1_22_IRxx = yaw_per_v_delta * mu;
    const double wz_delta2_delta = wx_delta2_delta_lam + mu;
    const double t119 = t43 * wz_delta2_delta;
    const double t120 = wx_delta2_delta_lam * t43;
    const double M_12_w = t120 - (t50 * mu);
    const double t124 = t50 + (t56 * t93);
    const double t125 = t36 * t93;
    const double t126 = yaw_per_v_delta * t124;
    const double t128 = SF + t65 + t124;
    const double t129 = wx_delta2_delta_lam * t65;
    const double t130 = wx_delta2_delta * t125;
    const double K2_12 = wx_delta2_delta_lam * t125;
    const double t132 = t36 * K2_12;
    const double M_12_mH = p->zH * K0_12_mH;
    const double M_22_mH = K0_12_mH * K0_12_mH;
    const double K0_22_mH = wx_delta2_delta * K0_12_mH;
    const double C1_12_rF = wz_delta2_delta * t80;
    const double t137 = p->mH * K0_12_mH;
    const double t142 = yaw_per_v_delta * (p->IRxx + t55 + p->IBzz + (p->xB * t42));
    const double C1_12 = wx_delta2_delta_lam * t128;
    const double t144 = wx_delta2_delta * t128;
    const double t145 = t42 * mu;
    const double t146 = yaw_per_v_delta * t81;
    const double t147 = p->c * t146;
    const double C1_21_w = t36 * t147;
    const double t149 = wx_delta2_delta_lam * SF;
    const double C1_21 = -(t147 + t149);
    const double t152 = p->rF * wx_delta2_delta;
    const double M_12_mF = p->rF * t152;
    const double t154 = wx_delta2_delta * t152;
    const double K2_22_mF = yaw_per_v_delta * t152;
    const double t156 = p->mF * t152;
    const double t157 = t56 * t142;
    const double K0_12 = t137 - t156 - t145;
    const double t160 = wx_delta2_delta * SF;
    const double t161 = mu + mu;
    const double M_22_xB = t145 * t161;
    const double t163 = p->xB * mu;
    const double t164 = p->zB * t163;
    const double M_22_mB = t163 * t163;
    const double t169 = t157 + (yaw_per_v_delta * (t55 - (t39 * t45)));
    const double K0_22 = wx_delta2_delta * K0_12;
    const double t171 = wx_delta2_delta * t163;
    const double K2_22_mB = yaw_per_v_delta * t163;
    const double C1_22_mB = t75 * K2_22_mB;
    const double t175 = t36 * (t160 - K0_12);
    const double t176 = p->mH * wx_delta2_delta_lam;
    const double t177 = K0_12_mH + K0_12_mH;
    const double t178 = yaw_per_v_delta * K0_12_mH;
    const double t179 = t76 * t178;
    const double t180 = yaw_per_v_delta * t74;
    const double K0_12_w = t176 + (t56 * t180);
    const double K0_12_c = t176 - t180;
    const double t188 = yaw_per_v_delta * (t94 + K0_12 + (p->c * K0_12_c) - t142);
    const double K0_22_w = wx_delta2_delta * K0_12_w;
    const double K2_22 = wx_delta2_delta_lam * t175;
    const double t192 = yaw_per_v_delta * (t175 + K0_12_w);
    const double K0_22_c = wx_delta2_delta * K0_12_c;
    const double t194 = yaw_per_v_delta * K0_12_c;
    const double t195 = wx_delta2_delta * t56;
    const double C1_21_lam = t160 + (t81 * t195);
    const double K0_12_zH = p->mH * wx_delta2_delta;
    const double t203 = t129 + (t46 * K0_12_zH) - t120 - (t74 * t195);
    const double M_12_zH = t137 + (p->zH * K0_12_zH);
    const double M_22_zH = t177 * K0_12_zH;
    const double t207 = yaw_per_v_delta * K0_12_zH;
    const double t208 = t76 * t207;
    const double t210 = (t36 * t110) + t169;
    const double t211 = t36 * t176;
    const double t212 = t76 * t211;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double C1_12_mR = p->c * K2_12_mR;
    const double t215 = p->zB * yaw_per_v_delta;
    const double t216 = p->mB * t215;
    const double t217 = t215 * t75;
    const double t218 = p->mB * yaw_per_v_delta;
    const double t219 = t75 * t218;
    const double t220 = p->c * t218;
    const double t221 = wx_delta2_delta * t220;
    const double K2_22_xB = yaw_per_v_delta * t220;
    const double t223 = p->mH * wz_delta2_delta;
    const double t224 = t177 * t223;
    const double t225 = wx_delta2_delta * t223;
    const double M_22_w = (t176 * t177) - (t210 * t161);
    const double t235 = (wz_delta2_delta * t55) + (t45 * (t137 - t94)) + t110 + (p->c * t210);
    const double K2_22_lam = (yaw_per_v_delta * (t149 + t203)) - (wx_delta2_delta * t175);
    const double C1_22_xB = (p->xB + t75) * K2_22_xB;
    const double K2_22_xH = yaw_per_v_delta * t223;
    const double t243 = t137 + t210;
    const double M_22_c = wx_delta2_delta_lam * (t243 + t243);
    const double t247 = t210 - (t56 * K0_12);
    const double t252 = yaw_per_v_delta * (t94 + t157 + t247 + (p->c * K0_12_w));
    const double K0_22_lam = (wx_delta2_delta_lam * K0_12) - (wx_delta2_delta * t203);
    const double t256 = t156 + t247;
    const double C1_22_lam = (wx_delta2_delta_lam * (t105 + t129 + (t56 * t203))) -
        (wx_delta2_delta * (t169 + t256));
    const double C1_22 = wx_delta2_delta_lam * t256;
    const double M_12_rF = t156 + t156;
    const double M_22_rF = wx_delta2_delta * M_12_rF;
    const double t267 = p->zH * yaw_per_v_delta;
    const double t268 = p->mH * t267;
    const double t269 = t267 * t76;
    const double C1_22_IHzz = yaw_per_v_delta * wz_delta2_delta;
    const double M_12_yaw_per_v_delta = t76 * C1_22_IHzz;
    const double C1_22_xH = p->mH * (M_12_yaw_per_v_delta - t178);
    const double K2_22_SF = wx_delta2_delta * yaw_per_v_delta;
    const double K2_22_rF = K2_22_SF * t80;
    const double K2_22_IFyy = t57 * K2_22_SF;
    const double M_22 = (wx_delta2_delta * ST) + (wx_delta2_delta_lam * t235);
    const double t282 = (wx_delta2_delta_lam * ST) - (wx_delta2_delta * t235);
    const double C1_12_IFyy = wz_delta2_delta * t57;
    const double C1_21_rF = SF * C1_12_IFyy;
    const double M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const double K0_22_zH = p->mH * M_22_IHxx;
    const double M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const double M_22_mF = M_11_mF * M_22_IHxx;
    const double t289 = wx_delta2_delta * wz_delta2_delta;
    const double M_22_IHxz = t289 + t289;
    const double t291 = p->mF * wx_delta2_delta;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double C1_22_rF = wz_delta2_delta * t291;
    const double t294 = wx_delta2_delta * t291;
    const double C1_12_mF = p->rF * wz_delta2_delta;
    const double M_22_lam = t282 + t282;
    const double C1_22_mF = wx_delta2_delta * C1_12_mF;
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
    derivatives->values[10] = M_11_mB;
    derivatives->values[11] = M_11_mH;
    derivatives->values[12] = M_11_mF;
    derivatives->values[13] = M_11_rR;
    derivatives->values[14] = M_11_mR;
    derivatives->values[15] = M_11_zH;
    derivatives->values[16] = M_11_rF;
    derivatives->values[17] = M_11_zB;
    derivatives->values[18] = M_12_c;
    derivatives->values[19] = yaw_per_v_delta;
    derivatives->values[20] = K0_12_mH;
    derivatives->values[21] = K2_12_IRyy;
    derivatives->values[22] = K2_12_rF;
    derivatives->values[23] = M_12_lam;
    derivatives->values[24] = K2_12_rR;
    derivatives->values[25] = K2_12_mF;
    derivatives->values[26] = K2_12_IFyy;
    derivatives->values[27] = mu;
    derivatives->values[28] = C1_12_rR;
    derivatives->values[29] = t113;
    derivatives->values[30] = C1_12_IRyy;
    derivatives->values[31] = C1_21_rR;
    derivatives->values[32] = M_22_IRxx;
    derivatives->values[33] = C1_22_IRxx;
    derivatives->values[34] = wz_delta2_delta;
    derivatives->values[35] = t119;
    derivatives->values[36] = M_12_w;
    derivatives->values[37] = t126;
    derivatives->values[38] = t130;
    derivatives->values[39] = K2_12;
    derivatives->values[40] = t132;
    derivatives->values[41] = M_12_mH;
    derivatives->values[42] = M_22_mH;
    derivatives->values[43] = K0_22_mH;
    derivatives->values[44] = C1_12_rF;
    derivatives->values[45] = t144;
    derivatives->values[46] = t145;
    derivatives->values[47] = t146;
    derivatives->values[48] = C1_21_w;
    derivatives->values[49] = t152;
    derivatives->values[50] = M_12_mF;
    derivatives->values[51] = t154;
    derivatives->values[52] = K2_22_mF;
    derivatives->values[53] = M_22_xB;
    derivatives->values[54] = t163;
    derivatives->values[55] = t164;
    derivatives->values[56] = M_22_mB;
    derivatives->values[57] = t171;
    derivatives->values[58] = K2_22_mB;
    derivatives->values[59] = C1_22_mB;
    derivatives->values[60] = t178;
    derivatives->values[61] = t179;
    derivatives->values[62] = K0_12_w;
    derivatives->values[63] = K0_12_c;
    derivatives->values[64] = t188;
    derivatives->values[65] = K0_22_w;
    derivatives->values[66] = t192;
    derivatives->values[67] = K0_22_c;
    derivatives->values[68] = t194;
    derivatives->values[69] = C1_21_lam;
    derivatives->values[70] = K0_12_zH;
    derivatives->values[71] = t203;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = M_22_zH;
    derivatives->values[74] = t207;
    derivatives->values[75] = t208;
    derivatives->values[76] = t211;
    derivatives->values[77] = t212;
    derivatives->values[78] = K2_12_mR;
    derivatives->values[79] = C1_12_mR;
    derivatives->values[80] = t215;
    derivatives->values[81] = t216;
    derivatives->values[82] = t217;
    derivatives->values[83] = t218;
    derivatives->values[84] = t219;
    derivatives->values[85] = t220;
    derivatives->values[86] = t221;
    derivatives->values[87] = K2_22_xB;
    derivatives->values[88] = t223;
    derivatives->values[89] = t224;
    derivatives->values[90] = t225;
    derivatives->values[91] = M_22_w;
    derivatives->values[92] = K2_22_lam;
    derivatives->values[93] = C1_22_xB;
    derivatives->values[94] = K2_22_xH;
    derivatives->values[95] = M_22_c;
    derivatives->values[96] = t252;
    derivatives->values[97] = K0_22_lam;
    derivatives->values[98] = C1_22_lam;
    derivatives->values[99] = M_12_rF;
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = t267;
    derivatives->values[102] = t268;
    derivatives->values[103] = t269;
    derivatives->values[104] = C1_22_IHzz;
    derivatives->values[105] = C1_22_xH;
    derivatives->values[106] = K2_22_SF;
    derivatives->values[107] = K2_22_rF;
    derivatives->values[108] = K2_22_IFyy;
    derivatives->values[109] = C1_12_IFyy;
    derivatives->values[110] = C1_21_rF;
    derivatives->values[111] = M_22_IHxx;
    derivatives->values[112] = K0_22_zH;
    derivatives->values[113] = M_22_IHzz;
    derivatives->values[114] = M_22_mF;
    derivatives->values[115] = M_22_IHxz;
    derivatives->values[116] = t291;
    derivatives->values[117] = M_22_IFxx;
    derivatives->values[118] = C1_22_rF;
    derivatives->values[119] = t294;
    derivatives->values[120] = C1_12_mF;
    derivatives->values[121] = M_22_lam;
    derivatives->values[122] = C1_22_mF;
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

static void whipple_mechanism_f64_compute_linearization(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], const double forces[WHIPPLE_MECHANISM_FORCES],
    whipple_mechanism_f64_linearization_t *linearization)
{
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t6 = motion->constants[7] * sin_phi;
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t14 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    double sin_delta = 0.0;
    double cos_delta = 0.0;
    carvallo_sin_cos_f64(positions[5], &sin_delta, &cos_delta);
    const double t18 = t14 * cos_phi;
    const double t21 = sin_phi * sin_delta;
    const double t22 = t21 - (cos_delta * t18);
    const double t26 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
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
    const double t42 = motion->constants[10] * t41;
    const double t45 = sin_delta * motion->constants[25];
    const double t51 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const double t53 = (t26 * motion->constants[27]) - (t14 * t51);
    const double t56 = (cos_phi * t45) - (t37 * t42) - (sin_phi * t53);
    const double t57 = t6 + t56;
    const double t58 = sin_delta * t34;
    const double t62 = (t26 * t32) + (t14 * t35);
    const double t64 = (cos_phi * t58) + (sin_phi * t62);
    const double t69 = (t42 * t64) + (t14 * motion->constants[27]) + (t26 * t51);
    const double t71 = 1.0 / (cos_phi * t69);
    const double t72 = t57 * t71;
    const double t78 = (t26 * motion->constants[24]) - (t14 * motion->constants[23]);
    const double t80 = t56 + (sin_phi * t78);
    const double t82 = sin_phi * t26;
    const double t85 = (t14 * motion->constants[24]) + (t26 * motion->constants[23]);
    const double t86 = t69 - t85;
    const double t89 = t71 * ((t14 * t80) + (t82 * t86));
    const double t91 = (speeds[0] * t72) + (speeds[1] * t89);
    const double t92 = speeds[2] + t91;
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
    const double t108 = sin_phi * motion->constants[27];
    const double t110 = t26 * t72;
    const double t111 = sin_phi * t51;
    const double t113 = t37 * motion->constants[10];
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
    const double t176 = motion->constants[10] * t64;
    const double t180 = sin_phi * t32;
    const double t182 = sin_phi * t35;
    const double t185 = t117 + t125;
    const double t191 = (cos_phi * t62) + (t110 * t182) + (t82 * t153) - (sin_phi * t58) - (t107 *
        t180) - (t162 * t185);
    const double t195 = (motion->constants[27] * t110) + (t120 * t176) + (t42 * t191) - (t51 *
        t107);
    const double t199 = (t99 * t100) + (motion->constants[7] * cos_phi * t71) + (t71 * t171) -
        (t173 * t195);
    const double t201 = t71 * t89;
    const double t203 = t26 * t86;
    const double t205 = t14 * t71;
    const double t211 = t71 * t82;
    const double t213 = sin_phi * motion->constants[24];
    const double t216 = (sin_phi * t71 * t86) + (t205 * t213) - (motion->constants[23] * t211);
    const double t220 = sin_phi * motion->constants[23];
    const double t223 = (t71 * t80) - (motion->constants[24] * t211) - (t205 * t220);
    const double t227 = t211 - (cos_phi * t201);
    const double t231 = (t100 * t201) + (cos_phi * ((t71 * t203) + (t78 * t205))) + (t110 * t223) +
        (t171 * t205);
    const double t233 = t231 + (t195 * t227) - (t107 * t216);
    const double t235 = (speeds[0] * t199) + (speeds[1] * t233);
    const double t238 = t14 * motion->constants[25];
    const double t240 = t14 * t89;
    const double t242 = t26 * t89;
    const double t245 = (t117 * t242) - t22;
    const double t247 = sin_delta * t26;
    const double t260 = (t39 * t138) + (t40 * t138) - (t143 * t240) - (t145 * t242);
    const double t264 = (t31 * t39) + (t31 * t40) - (t128 * t242) - (t131 * t260);
    const double t268 = (t157 * t240) + (t159 * t260);
    const double t273 = (t34 * t247) + (t35 * t240) + (t32 * t242) + (t14 * t264) + (t155 * t268);
    const double t279 = (motion->constants[25] * t114) + (t108 * t240) + (t111 * t242) + (t42 *
        t273) - (t21 * t238) - (t113 * t245);
    const double t286 = sin_phi * t14;
    const double t296 = (t34 * t114) + (t182 * t242) + (t82 * t264) - (t58 * t286) - (t180 * t240) -
        (t185 * t268);
    const double t301 = (motion->constants[27] * t242) + (t176 * t245) + (t42 * t296) -
        (motion->constants[25] * t247) - (t51 * t240);
    const double t303 = (t71 * t279) - (t173 * t301);
    const double t311 = (t223 * t242) + (t205 * t279) + (t227 * t301) - (t216 * t240);
    const double t313 = (speeds[0] * t303) + (speeds[1] * t311);
    const double t318 = motion->constants[7] * sin_psi;
    const double t325 = (t37 * t69) + (t57 * t64);
    const double t326 = 1.0 / t325;
    const double t327 = motion->constants[7] * t64;
    const double t328 = t326 * t327;
    const double t329 = t326 * t328;
    const double t330 = speeds[2] * t329;
    const double t339 = (cos_phi * t327) + (t64 * t171) + (t57 * t191) + (t37 * t195) - (t69 *
        t166);
    const double t341 = motion->constants[7] * t326;
    const double t342 = speeds[2] * t341;
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
    const double t387 = t106 + (t30 * motion->constants[10]) - (cos_phi * t78);
    const double t390 = (t26 * t387) + (t27 * t78);
    const double t397 = (cos_phi * t86) - (t27 * motion->constants[23]);
    const double t403 = (sin_phi * t387) + (cos_phi * t80) + (t27 * t213);
    const double t407 = (cos_phi * motion->constants[27]) - (cos_phi * motion->constants[24]);
    const double t410 = (t371 * t397) + (t373 * t403) + (t379 * t407);
    const double t413 = t387 + (t27 * motion->constants[24]);
    const double t415 = t27 * t220;
    const double t419 = (cos_phi * motion->constants[23]) - (cos_phi * t51);
    const double t422 = (t379 * t419) - (t371 * t413) - (t373 * t415);
    const double t424 = motion->constants[10] * t379;
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
    const double t488 = motion->constants[25] * t39;
    const double t490 = t238 * t117;
    const double t506 = (t379 * t488) + (t379 * t490) + (t242 * t422) + (t260 * t424) + (t279 *
        t431) + (t296 * t436);
    const double t511 = t506 + (t301 * t438) + (t440 * t481) + (t311 * t363) - (t240 * t410) -
        (t273 * t429);
    const double t512 = t511 - (t448 * t472);
    const double t516 = (t330 * t472) - ((t296 * t342) + (speeds[0] * t486) + (speeds[1] * t512));
    const double t518 = 1.0 / motion->constants[10];
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
    const double t594 = motion->constants[10] * t573;
    const double t597 = t27 * t37;
    const double t600 = t27 * t64;
    const double t608 = (cos_phi * ((t37 * t390) + (t45 * t573))) + (t110 * t592) + (t149 * t594) +
        (t171 * t597);
    const double t612 = t608 + (t447 * t537) + (t461 * t523) - (sin_phi * ((t37 * t374) + (t376 *
        t573) - (t64 * t203))) - (t107 * t586);
    const double t617 = t612 - (t166 * t435) - (t191 * t428) - (t195 * t600) - (t89 * t556) -
        (t233 * t561);
    const double t620 = (speeds[2] * t543) + (t545 * t566) + (t568 * t617);
    const double t629 = (t57 * t273) + (t69 * t296) + (t64 * t301) - (t37 * t279);
    const double t634 = (t296 * t525) + (t527 * t629) - (t273 * t519) - (t472 * t539);
    const double t642 = (t273 * t351) + (t100 * t296) + (t301 * t345) - (t279 * t353);
    const double t649 = (t364 * t629) + (t486 * t523) - (t72 * t642) - (t303 * t561);
    const double t668 = (t488 * t573) + (t490 * t573) + (t242 * t592) + (t260 * t594) + (t279 *
        t597) + (t447 * t629);
    const double t673 = t668 + (t512 * t523) - (t240 * t586) - (t273 * t435) - (t296 * t428) -
        (t301 * t600);
    const double t675 = t673 - (t89 * t642) - (t311 * t561);
    const double t678 = (speeds[2] * t634) + (t545 * t649) + (t568 * t675);
    const double t682 = t518 * ((t364 * t523) - (t72 * t561));
    const double t690 = t518 * ((t37 * t435) + (t447 * t523) - (t64 * t428) - (t89 * t561));
    const double t693 = t518 * (t528 + (t328 * t523));
    const double t697 = sin_delta * motion->constants[41];
    const double t698 = sin_delta * t697;
    const double t702 = motion->constants[32] + motion->constants[36] + motion->constants[43] -
        t698;
    const double t704 = cos_delta * motion->constants[34];
    const double t705 = motion->constants[23] * t704;
    const double t708 = t705 + t705 + motion->constants[46];
    const double t711 = motion->constants[33] + motion->constants[39];
    const double t712 = t708 + t711;
    const double t713 = t712 - t702;
    const double t714 = t14 * t14;
    const double t716 = t14 * t26;
    const double t718 = motion->constants[24] * t704;
    const double t722 = cos_delta * motion->constants[37];
    const double t723 = motion->constants[30] + t722;
    const double t726 = t723 - motion->constants[44] - t718 - motion->constants[45];
    const double t727 = t726 + t726;
    const double t729 = (t713 * t714) + (t716 * t727);
    const double t735 = t704 + motion->constants[42] + motion->constants[28];
    const double t737 = (t26 * motion->constants[47]) - (t14 * t735);
    const double t738 = motion->constants[7] * t737;
    const double t741 = motion->constants[49] - t738 - t738;
    const double t743 = sin_delta * motion->constants[34];
    const double t745 = (sin_delta * motion->constants[37]) - (motion->constants[24] * t743);
    const double t749 = (cos_delta * t697) - (motion->constants[23] * t743);
    const double t751 = (t14 * t745) + (t26 * t749);
    const double t753 = t72 - (sin_phi * t364);
    const double t763 = t726 + (t713 * t716) + (motion->constants[7] * ((t14 *
        motion->constants[47]) + (t26 * t735))) - (t714 * t727);
    const double t764 = cos_phi * t364;
    const double t772 = t698 + motion->constants[43] + t708 + t741 + motion->constants[31] +
        motion->constants[38];
    const double t776 = motion->constants[7] * t743;
    const double t778 = (t26 * t745) + t776 - (t14 * t749);
    const double t784 = t712 - t729;
    const double t790 = t753 * motion->constants[21];
    const double t796 = t682 + (cos_delta * t753) - t247 - (t115 * t764);
    const double t798 = t796 * motion->constants[22];
    const double t804 = t702 + t729 + t741 + (t751 * t753) + (t753 * (t751 + (t753 * t772) - (t764 *
        t778))) + (t753 * t790);
    const double t807 = t804 + (t796 * t798) - (t763 * t764) - (t764 * (t763 + (t753 * t778) -
        (t764 * t784)));
    const double t808 = 1.0 / t807;
    const double t809 = speeds[0] * t26;
    const double t814 = (speeds[0] * t364) + (speeds[1] * t447) + (speeds[2] * t328);
    const double t815 = cos_phi * t814;
    const double t817 = t809 + (t14 * t815);
    const double t818 = sin_phi * t814;
    const double t819 = t91 - t818;
    const double t823 = (motion->constants[31] * t819) + (motion->constants[21] * (speeds[2] +
        t819));
    const double t827 = speeds[0] * t14;
    const double t828 = t827 - (t26 * t815);
    const double t829 = motion->constants[30] * t828;
    const double t830 = (motion->constants[32] * t817) + t829;
    const double t832 = (t817 * t823) - (t819 * t830);
    const double t835 = (cos_delta * t817) + (sin_delta * t819);
    const double t838 = (cos_delta * t819) - (sin_delta * t817);
    const double t844 = (speeds[0] * t682) + (speeds[1] * t690) + (speeds[2] * t693);
    const double t845 = t838 + t844;
    const double t847 = (motion->constants[38] * t838) + (motion->constants[22] * t845);
    const double t850 = speeds[1] + t828;
    const double t851 = motion->constants[37] * t850;
    const double t852 = (motion->constants[36] * t835) + t851;
    const double t854 = (t835 * t847) - (t838 * t852);
    const double t855 = motion->constants[7] * t818;
    const double t856 = t815 * t855;
    const double t858 = sin_phi * motion->constants[40];
    const double t859 = t92 * t815;
    const double t862 = t856 - (motion->constants[7] * t859);
    const double t863 = t858 + t862;
    const double t865 = t91 * t828;
    const double t866 = speeds[0] * t818;
    const double t867 = motion->constants[24] * t819;
    const double t869 = motion->constants[23] * t819;
    const double t871 = (t828 * t867) + (t817 * t869);
    const double t873 = t91 * t817;
    const double t874 = (t26 * t866) + t873;
    const double t877 = t865 + (t14 * t866);
    const double t881 = t871 + (motion->constants[23] * t874) + (motion->constants[24] * t877) -
        t862;
    const double t884 = motion->constants[23] * t828;
    const double t885 = motion->constants[24] * t817;
    const double t886 = t884 - t885;
    const double t888 = (t819 * t869) + (t828 * t886);
    const double t889 = speeds[0] * t815;
    const double t892 = motion->constants[7] * speeds[0];
    const double t893 = t815 * t892;
    const double t894 = (motion->constants[7] * t889) + t893;
    const double t897 = t92 - t818;
    const double t899 = (t855 * t897) - (speeds[0] * t892);
    const double t903 = (t26 * t894) + (t14 * t899) - t888 - (motion->constants[24] * t889);
    const double t906 = t838 * motion->constants[26];
    const double t908 = motion->constants[25] * t838;
    const double t911 = cos_delta * t877;
    const double t912 = sin_delta * t889;
    const double t913 = speeds[1] * t838;
    const double t915 = t913 - t911 - t912;
    const double t917 = t32 * motion->constants[10];
    const double t919 = t874 + (t835 * t844);
    const double t921 = t34 * motion->constants[10];
    const double t923 = t915 - (t844 * t850);
    const double t925 = t31 * t41;
    const double t928 = (t32 * t835) + (t34 * t850);
    const double t930 = motion->constants[10] * t925 * t928;
    const double t931 = t34 * t930;
    const double t933 = t32 * t930;
    const double t939 = (cos_delta * t881) + (t850 * t906) + (t835 * t908) +
        (motion->constants[25] * t874) + (t917 * t919) + (t850 * t931);
    const double t943 = t939 + (t835 * t933) - (sin_delta * t903) - (motion->constants[26] * t915) -
        (t921 * t923);
    const double t948 = motion->constants[25] * t850;
    const double t949 = t835 * motion->constants[26];
    const double t950 = t948 - t949;
    const double t954 = speeds[1] * t835;
    const double t956 = (sin_delta * t877) - (cos_delta * t889) - t954;
    const double t963 = motion->constants[10] * ((t32 * t850) - (t34 * t835));
    const double t969 = (cos_delta * t903) + (sin_delta * t881) + (motion->constants[26] * t956) +
        (t921 * t956) - (t838 * t908) - (t850 * t950);
    const double t971 = t969 - (t845 * t933) - (t850 * t963);
    const double t975 = (t817 * t886) - (t819 * t867);
    const double t989 = t975 + (motion->constants[23] * t889) + (t14 * t894) + (t835 * t950) +
        (t835 * t963) - (t26 * t899);
    const double t993 = t989 - (t838 * t906) - (motion->constants[25] * t956) - (t917 * t956) -
        (t845 * t931);
    const double t995 = (t32 * t971) + (t34 * t993);
    const double t1000 = t71 * ((t41 * t943) + (t30 * t995));
    const double t1004 = t326 * ((t30 * t943) + (t362 * t1000) - (t41 * t995));
    const double t1006 = t866 - (cos_phi * t1004);
    const double t1008 = t865 + (t14 * t1006);
    const double t1011 = t873 + (t26 * t1006);
    const double t1017 = t871 + (motion->constants[23] * t1011) + (motion->constants[24] * t1008) -
        t863;
    const double t1020 = t889 - t1000;
    const double t1021 = (sin_phi * t1004) + t1020;
    const double t1024 = (motion->constants[7] * t1021) + t893;
    const double t1027 = t899 + (cos_phi * motion->constants[40]);
    const double t1028 = t14 * t1027;
    const double t1029 = t1028 + (t26 * t1024);
    const double t1031 = t1029 - (motion->constants[24] * t1021) - t888;
    const double t1033 = (cos_delta * t1017) - (sin_delta * t1031);
    const double t1038 = t913 - (sin_delta * t1021) - (cos_delta * t1008);
    const double t1043 = t854 + (motion->constants[34] * t1033) + (motion->constants[37] * t1038) +
        (motion->constants[39] * t1011);
    const double t1047 = (cos_delta * t1031) + (sin_delta * t1017);
    const double t1053 = (sin_delta * t1008) - (cos_delta * t1021) - t954;
    const double t1055 = motion->constants[34] * t838;
    const double t1057 = motion->constants[34] * t850;
    const double t1058 = t835 * motion->constants[35];
    const double t1059 = t1057 - t1058;
    const double t1061 = (t838 * t1055) + (t850 * t1059);
    const double t1063 = (motion->constants[17] * t1047) + (motion->constants[35] * t1053) - t1061;
    const double t1068 = t838 * motion->constants[35];
    const double t1071 = (t850 * t1068) + (t835 * t1055);
    const double t1074 = (t1033 * motion->constants[17]) + (motion->constants[34] * t1011) + t1071 -
        (t1038 * motion->constants[35]);
    const double t1076 = (sin_delta * t1063) + (cos_delta * t1074);
    const double t1082 = t832 + (motion->constants[33] * t1011) + t1043 + (motion->constants[23] *
        t1076) - (motion->constants[28] * t863) - (motion->constants[30] * t1008);
    const double t1088 = motion->constants[30] * t817;
    const double t1090 = t1088 + (motion->constants[33] * t828);
    const double t1093 = (t819 * t1090) - (t823 * t828);
    const double t1097 = motion->constants[37] * t835;
    const double t1099 = t1097 + (motion->constants[39] * t850);
    const double t1102 = (t838 * t1099) - (t847 * t850);
    const double t1105 = (motion->constants[36] * t1038) + (motion->constants[37] * t1011) + t1102 -
        (t1033 * motion->constants[35]);
    const double t1109 = t26 * t1027;
    const double t1111 = t1109 - (t14 * t1024);
    const double t1113 = t975 + (motion->constants[23] * t1021) - t1111;
    const double t1123 = t518 * ((t32 * t993) + (t523 * t1004) - (t34 * t971) - (t561 * t1000));
    const double t1125 = motion->constants[22] * (t1053 + t1123);
    const double t1128 = (t850 * t852) - (t835 * t1099);
    const double t1132 = (t1047 * motion->constants[35]) + (motion->constants[38] * t1053) + t1125 +
        t1128 - (motion->constants[34] * t1113);
    const double t1139 = (t863 * motion->constants[29]) + (motion->constants[30] * t1011) + t1093 +
        (cos_delta * t1105) - (motion->constants[32] * t1008) - (sin_delta * t1132);
    const double t1140 = t1139 - (motion->constants[24] * t1076);
    const double t1146 = t819 * motion->constants[29];
    const double t1148 = motion->constants[28] * t819;
    const double t1154 = t1076 + (motion->constants[28] * t1011) + (t1008 * motion->constants[29]) +
        (t828 * t1146) + (t817 * t1148) - (t863 * motion->constants[1]);
    const double t1161 = (t828 * t830) - (t817 * t1090);
    const double t1166 = (cos_delta * t1063) - (sin_delta * t1074);
    const double t1172 = (t835 * t1059) - (t838 * t1068);
    const double t1174 = (motion->constants[17] * t1113) + t1172 - (motion->constants[34] * t1053);
    const double t1179 = motion->constants[28] * t828;
    const double t1180 = t817 * motion->constants[29];
    const double t1181 = t1179 - t1180;
    const double t1184 = (t817 * t1181) - (t819 * t1146);
    const double t1193 = (t819 * t1148) + (t828 * t1181);
    const double t1198 = (t14 * (t1174 + t1184 - (t1111 * motion->constants[1]) +
        (motion->constants[28] * t1021))) + (t26 * (t1166 + (t1029 * motion->constants[1]) -
        (t1021 * motion->constants[29]) - t1193));
    const double t1200 = (motion->constants[21] * t1021) + (motion->constants[7] * t1198);
    const double t1205 = (t1029 * motion->constants[29]) + (motion->constants[28] * t1111) -
        (motion->constants[31] * t1021) + t1161 + (sin_delta * t1105) + (cos_delta * t1132);
    const double t1208 = t1205 + (motion->constants[24] * t1166) - t1200 - (motion->constants[23] *
        t1174);
    const double t1212 = (t26 * t1082) - (t14 * t1140);
    const double t1219 = forces[0] + (t764 * t1212) - (t14 * t1082) - (t26 * t1140) -
        (motion->constants[7] * t1154) - (t753 * t1208);
    const double t1220 = t1219 - (t682 * t1125);
    const double t1222 = t705 + motion->constants[39];
    const double t1224 = t722 - t718;
    const double t1228 = t89 - (sin_phi * t447);
    const double t1230 = cos_phi * t447;
    const double t1232 = t26 * t743;
    const double t1233 = motion->constants[7] * t1232;
    const double t1234 = t745 + t1233;
    const double t1238 = t1234 + (t772 * t1228) - (t778 * t1230);
    const double t1242 = (t26 * t1222) - (t14 * t1224);
    const double t1246 = t1242 + (t778 * t1228) - (t784 * t1230);
    const double t1252 = t690 + (cos_delta * t1228) - (t115 * t1230);
    const double t1258 = (t14 * t1222) + (t26 * t1224) + (motion->constants[7] * t704) + (t751 *
        t1228) + (t753 * t1238) + (t790 * t1228);
    const double t1262 = t808 * (t1258 + (t798 * t1252) - (t763 * t1230) - (t764 * t1246));
    const double t1267 = motion->constants[21] * t1228;
    const double t1269 = motion->constants[22] * t1252;
    const double t1271 = t807 * t1262;
    const double t1277 = motion->constants[39] + (t1228 * t1238) + (t1228 * t1234) + (t1228 *
        t1267) + (t1252 * t1269) - (t1230 * t1246);
    const double t1279 = t1277 - (t1230 * t1242) - (t1262 * t1271);
    const double t1280 = 1.0 / t1279;
    const double t1290 = forces[1] + (t1212 * t1230) - t1043 - (t1208 * t1228) - (t690 * t1125) -
        (t1220 * t1262);
    const double t1294 = motion->constants[7] * (t737 - motion->constants[48]);
    const double t1295 = sin_phi * t328;
    const double t1297 = cos_phi * t328;
    const double t1300 = t1294 + (t772 * t1295) + (t778 * t1297);
    const double t1305 = t776 - (t778 * t1295) - (t784 * t1297);
    const double t1309 = 1.0 - t1295;
    const double t1314 = t693 - (cos_delta * t1295) - (t115 * t1297);
    const double t1326 = (t790 * t1309) + (t798 * t1314) - (t751 * t1295) - (t763 * t1297) - (t753 *
        t1300) - (t764 * t1305);
    const double t1327 = t808 * t1326;
    const double t1333 = t1233 + (t1267 * t1309) + (t1269 * t1314) - (t1228 * t1300) - (t1230 *
        t1305) - (t1234 * t1295);
    const double t1336 = t1280 * (t1333 - (t1242 * t1297) - (t1271 * t1327));
    const double t1346 = (t1208 * t1295) + (t1212 * t1297) + t1200 - (t693 * t1125) - (t1220 *
        t1327) - (t1290 * t1336);
    const double t1364 = (t1295 * t1300) + (t1294 * t1295) + motion->constants[50] +
        (motion->constants[21] * t1309 * t1309) + (motion->constants[22] * t1314 * t1314) - (t1297 *
        t1305);
    const double t1368 = 1.0 / (t1364 - (t776 * t1297) - (t807 * t1327 * t1327) - (t1279 * t1336 *
        t1336));
    const double t1369 = t1346 * t1368;
    const double t1371 = (t1280 * t1290) - (t1336 * t1369);
    const double t1375 = (t808 * t1220) - (t1262 * t1371) - (t1327 * t1369);
    const double t1379 = t856 + t858 - (motion->constants[7] * (t859 + t1375));
    const double t1387 = t1004 + (t364 * t1375) + (t447 * t1371) + (t328 * t1369);
    const double t1389 = t866 - (cos_phi * t1387);
    const double t1392 = (t26 * t1375) - t865 - (t14 * t1389);
    const double t1397 = t873 + (t26 * t1389) + (t14 * t1375);
    const double t1403 = t871 + (motion->constants[23] * t1397) - t1379 - (motion->constants[24] *
        t1392);
    const double t1410 = (t72 * t1375) + (t89 * t1371) - (sin_phi * t1387) - t1020;
    const double t1412 = t1369 + t1410;
    const double t1414 = (motion->constants[7] * t1412) - t893;
    const double t1416 = t1028 - (t26 * t1414);
    const double t1418 = (motion->constants[24] * t1410) + t1416 - t888;
    const double t1420 = (cos_delta * t1403) - (sin_delta * t1418);
    const double t1424 = (cos_delta * t1392) + (sin_delta * t1410);
    const double t1425 = t913 + t1424;
    const double t1427 = t1371 + t1397;
    const double t1431 = (cos_delta * t1418) + (sin_delta * t1403);
    const double t1435 = (cos_delta * t1410) - (sin_delta * t1392);
    const double t1436 = t1435 - t954;
    const double t1439 = (motion->constants[17] * t1431) + (motion->constants[35] * t1436) - t1061;
    const double t1446 = t1071 + (motion->constants[17] * t1420) + (motion->constants[34] * t1427) -
        (motion->constants[35] * t1425);
    const double t1448 = (sin_delta * t1439) + (cos_delta * t1446);
    const double t1455 = t832 + t854 + (motion->constants[30] * t1392) + (motion->constants[33] *
        t1397) + (motion->constants[34] * t1420) + (motion->constants[37] * t1425) +
        (motion->constants[39] * t1427);
    const double t1457 = t1455 + (motion->constants[23] * t1448) - (motion->constants[28] * t1379);
    const double t1467 = t1102 + (motion->constants[36] * t1425) + (motion->constants[37] * t1427) -
        (motion->constants[35] * t1420);
    const double t1472 = t1109 + (t14 * t1414);
    const double t1474 = t975 - (motion->constants[23] * t1410) - t1472;
    const double t1484 = motion->constants[22] * (t1123 + t1436 + (t682 * t1375) + (t690 * t1371) +
        (t693 * t1369));
    const double t1488 = t1128 + (motion->constants[35] * t1431) + (motion->constants[38] * t1436) +
        t1484 - (motion->constants[34] * t1474);
    const double t1490 = (cos_delta * t1467) - (sin_delta * t1488);
    const double t1496 = t1093 + (motion->constants[29] * t1379) + (motion->constants[32] * t1392) +
        (motion->constants[30] * t1397) + t1490 - (motion->constants[24] * t1448);
    const double t1498 = (t26 * t1457) - (t14 * t1496);
    const double t1499 = sin_phi * t1498;
    const double t1507 = (sin_delta * t1467) + (cos_delta * t1488);
    const double t1510 = (cos_delta * t1439) - (sin_delta * t1446);
    const double t1515 = t1172 + (motion->constants[17] * t1474) - (motion->constants[34] * t1436);
    const double t1521 = t1184 + t1515 - (motion->constants[1] * t1472) - (motion->constants[28] *
        t1410);
    const double t1527 = t1510 + (motion->constants[1] * t1416) + (motion->constants[29] * t1410) -
        t1193;
    const double t1535 = t1161 + (motion->constants[29] * t1416) + (motion->constants[28] * t1472) +
        (motion->constants[31] * t1410) + (motion->constants[21] * t1412) + t1507;
    const double t1538 = t1535 + (motion->constants[24] * t1510) - (motion->constants[23] * t1515) -
        (motion->constants[7] * ((t14 * t1521) + (t26 * t1527)));
    const double t1539 = cos_phi * t1538;
    const double t1546 = (sin_phi * t1538) + (cos_phi * t1498);
    const double t1548 = t518 * t1484;
    const double t1550 = motion->constants[7] * t1527;
    const double t1552 = motion->constants[7] * t1521;
    const double t1554 = (t107 * t1550) - (t110 * t1552);
    const double t1558 = (t107 * t1457) + (t110 * t1496);
    const double t1560 = t326 * t995;
    const double t1561 = t524 * t1560;
    const double t1563 = t326 * t943;
    const double t1564 = t524 * t1563;
    const double t1567 = t41 * t326;
    const double t1568 = t971 * t1567;
    const double t1570 = (t518 * t993) - (t524 * t1568);
    const double t1573 = t993 * t1567;
    const double t1575 = (t518 * t971) + (t524 * t1573);
    const double t1577 = t518 * t1000;
    const double t1579 = t326 * t1000;
    const double t1580 = t524 * t1579;
    const double t1582 = t518 * t1004;
    const double t1584 = t326 * t1004;
    const double t1585 = t524 * t1584;
    const double t1588 = t518 * t1375;
    const double t1590 = t518 * t1371;
    const double t1596 = (t149 * t1564) + (t153 * t1570) + (t162 * t1575) + (t358 * t1580) + (t537 *
        t1582) + (t543 * t1369);
    const double t1601 = t1596 + (t566 * t1588) + (t617 * t1590) - (t120 * t1561) - (t556 * t1577) -
        (t339 * t1585);
    const double t1603 = sin_delta * motion->constants[22];
    const double t1605 = cos_delta * motion->constants[22];
    const double t1607 = t14 * t1603;
    const double t1611 = (t26 * t1603) + (t764 * t1607) - (t682 * motion->constants[22]) - (t753 *
        t1605);
    const double t1614 = t892 + t892;
    const double t1615 = t26 * t1614;
    const double t1617 = motion->constants[7] * t1387;
    const double t1621 = motion->constants[7] * t1375;
    const double t1622 = t26 * t1621;
    const double t1624 = motion->constants[7] * t1371;
    const double t1625 = t26 * t1624;
    const double t1631 = (t27 * t1617) + (t107 * t1414) + (t110 * t1027) - (t286 *
        motion->constants[40]) - (t818 * t1615) - (t199 * t1622);
    const double t1632 = t1631 - (t233 * t1625);
    const double t1633 = motion->constants[7] * t26;
    const double t1634 = motion->constants[1] * t1633;
    const double t1635 = motion->constants[29] - t1634;
    const double t1637 = cos_delta * motion->constants[35];
    const double t1638 = sin_delta * t1637;
    const double t1640 = cos_delta * motion->constants[17];
    const double t1641 = sin_delta * t1640;
    const double t1642 = t78 - motion->constants[7];
    const double t1644 = cos_delta * t1640;
    const double t1645 = t1633 * t1644;
    const double t1649 = (motion->constants[24] * t1644) + (cos_delta * t1637) - t1645;
    const double t1653 = (t14 * t1638) + (t85 * t1641);
    const double t1658 = sin_delta * motion->constants[35];
    const double t1659 = sin_delta * motion->constants[17];
    const double t1660 = t1633 * t1659;
    const double t1663 = t1660 - t1658 - (motion->constants[24] * t1659);
    const double t1669 = (t26 * motion->constants[34]) + (t14 * t1637) + (t85 * t1640);
    const double t1674 = (t26 * t1637) + (t1640 * t1642) + (t764 * t1669) - (t14 *
        motion->constants[34]) - (t753 * t1663);
    const double t1679 = (t26 * t1638) + (t1641 * t1642) + (t764 * t1653) - (t753 * t1649) -
        (sin_delta * t1674);
    const double t1680 = t1679 - (t753 * t1635);
    const double t1683 = t14 * t1614;
    const double t1688 = t14 * t1621;
    const double t1690 = t14 * t1624;
    const double t1696 = (t818 * t1683) + (t110 * t1414) + (t199 * t1688) + (t233 * t1690) - (t82 *
        motion->constants[40]) - (t18 * t1617);
    const double t1697 = t1696 - (t107 * t1027);
    const double t1698 = motion->constants[7] * t14;
    const double t1701 = (motion->constants[1] * t1698) + (motion->constants[17] * t1698);
    const double t1702 = t735 + t1701;
    const double t1704 = t14 * t743;
    const double t1707 = t1232 + (t764 * t1704) - (t753 * t1702);
    const double t1709 = t93 - t855;
    const double t1710 = t818 * t1709;
    const double t1711 = motion->constants[7] * t815;
    const double t1715 = t1710 + (cos_phi * (motion->constants[40] + (t814 * t1711)));
    const double t1721 = (t26 * motion->constants[28]) + (t14 * motion->constants[29]);
    const double t1723 = sin_delta * t1658;
    const double t1725 = sin_delta * t1659;
    const double t1727 = cos_delta * t1659;
    const double t1728 = t1633 * t1727;
    const double t1732 = (motion->constants[24] * t1727) + (cos_delta * t1658) - t1728;
    const double t1736 = (t14 * t1723) + (t85 * t1725);
    const double t1742 = (t26 * t1723) + (t1642 * t1725) + (t764 * t1736) + (cos_delta * t1674) -
        (t753 * t1732);
    const double t1746 = (motion->constants[7] * motion->constants[1]) + (t14 *
        motion->constants[28]) - (t26 * motion->constants[29]) - (t764 * t1721) - t1742;
    const double t1754 = (t82 * t1387) + (t809 * t815) + (t110 * t1375) - (t107 * t1389);
    const double t1759 = t743 * t1633;
    const double t1760 = t745 + t1759;
    const double t1766 = (t26 * t711) + (t85 * t704) - (t14 * t723);
    const double t1773 = (t704 * t1642) + (t764 * t1766) + (motion->constants[23] * t1742) -
        (motion->constants[7] * motion->constants[28]) - (t14 * t711) - (t26 * t723);
    const double t1774 = t1773 - (t753 * t1760);
    const double t1779 = t1389 + (t199 * t1375) + (t233 * t1371);
    const double t1780 = motion->constants[23] * motion->constants[34];
    const double t1781 = sin_delta * t1780;
    const double t1783 = motion->constants[31] + motion->constants[21];
    const double t1788 = (motion->constants[29] * t1633) - (motion->constants[28] * t1698) -
        (motion->constants[42] * t1698);
    const double t1792 = motion->constants[46] + t1783 + (cos_delta * t1780) - t1788;
    const double t1794 = t14 * t1781;
    const double t1797 = sin_delta * motion->constants[38];
    const double t1802 = (t1633 * t1637) - (motion->constants[34] * t1698);
    const double t1807 = t1780 + (motion->constants[24] * t1637) + (cos_delta *
        motion->constants[38]) - t1802;
    const double t1811 = (t14 * t1797) + (t85 * t1658);
    const double t1816 = t1611 + (t26 * t1797) + (t1642 * t1658) + (t764 * t1811) - (t753 * t1807);
    const double t1819 = cos_delta * motion->constants[36];
    const double t1823 = t1633 * t1658;
    const double t1826 = (sin_delta * motion->constants[36]) + (motion->constants[24] * t1658) -
        t1823;
    const double t1832 = (t26 * motion->constants[37]) - (t14 * t1819) - (t85 * t1637);
    const double t1837 = (t764 * t1832) - (t14 * motion->constants[37]) - (t26 * t1819) - (t1637 *
        t1642) - (t753 * t1826);
    const double t1843 = (t26 * t1781) + (t764 * t1794) + (motion->constants[24] * t1679) +
        (cos_delta * t1816) + (sin_delta * t1837) - (t753 * t1792);
    const double t1846 = t815 * t827;
    const double t1851 = (t286 * t1387) + t1846 + (t107 * t1375) + (t110 * t1389);
    const double t1857 = (t26 * motion->constants[30]) - (t14 * motion->constants[32]);
    const double t1866 = (motion->constants[7] * motion->constants[29]) + (t764 * t1857) +
        (cos_delta * t1837) - (t14 * motion->constants[30]) - (t26 * motion->constants[32]) -
        (motion->constants[24] * t1742);
    const double t1867 = t1866 - (sin_delta * t1816);
    const double t1873 = t341 * t1369;
    const double t1877 = t1584 + (t329 * t1369);
    const double t1885 = (t149 * t1563) + (t162 * t1573) + (t191 * t1873) + (t358 * t1579) + (t369 *
        t1375) + (t461 * t1371);
    const double t1888 = t1885 - (t120 * t1560) - (t153 * t1568) - (t339 * t1877);
    const double t1889 = t6 * t26;
    const double t1891 = t6 * t14;
    const double t1899 = (t1680 * t1889) + (t18 * t1867) - (t1707 * t1891) - (t27 * t1774) -
        (sin_phi * t1843);
    const double t1901 = t71 * t1000;
    const double t1903 = t71 * t943;
    const double t1905 = t71 * t995;
    const double t1907 = t30 * t71;
    const double t1908 = t971 * t1907;
    const double t1910 = t993 * t1907;
    const double t1912 = cos_phi * t1901;
    const double t1918 = (t100 * t1901) + (t120 * t1903) + (t149 * t1905) + (t153 * t1908) - (t162 *
        t1910) - (t195 * t1912);
    const double t1921 = (t363 * t524) - (t518 * t561);
    const double t1929 = t1843 + (t1611 * t1921) + (t1698 * t1707) + (t363 * t1899) - (t1633 *
        t1680);
    const double t1932 = motion->constants[23] + t1698;
    const double t1934 = motion->constants[25] + t917;
    const double t1935 = speeds[0] * cos_delta;
    const double t1938 = (t14 * t892) + (speeds[0] * t1932) + (t1934 * t1935);
    const double t1942 = motion->constants[10] * t956;
    const double t1943 = motion->constants[10] * t835;
    const double t1945 = (t850 * t1943) - t1942;
    const double t1947 = t845 * t930;
    const double t1949 = t1947 + (t835 * t1943);
    const double t1954 = (t107 * t899) + (t110 * t894) + (t153 * t1945) + (t162 * t1949) - (t818 *
        t1938);
    const double t1956 = t34 * t1567;
    const double t1958 = (t32 * t518) - (t524 * t1956);
    const double t1961 = t34 * t1907;
    const double t1964 = (t1611 * t1958) + (t1929 * t1961) - (t1899 * t1956);
    const double t1966 = motion->constants[26] + t921;
    const double t1967 = sin_delta * t1966;
    const double t1970 = t1633 - motion->constants[24];
    const double t1972 = (t26 * t892) + (speeds[0] * t1970);
    const double t1974 = (speeds[0] * t1967) - (sin_delta * t1972);
    const double t1977 = t809 * t1934;
    const double t1980 = (motion->constants[23] * t809) - t1711;
    const double t1981 = t814 * t1980;
    const double t1987 = motion->constants[23] * t866;
    const double t1990 = (t866 * t1934) + (cos_delta * t1987) - (sin_delta * t894);
    const double t1992 = sin_delta * t899;
    const double t1996 = (motion->constants[10] * t919) + (t835 * t930);
    const double t2000 = (t850 * t930) - (motion->constants[10] * t923);
    const double t2004 = (cos_phi * ((t814 * t1977) + (cos_delta * t1981))) + (t153 * t1996) -
        (t818 * t1974) - (cos_delta * t1710);
    const double t2007 = t2004 - (t107 * t1990) - (t110 * t1992) - (t162 * t2000);
    const double t2008 = t30 * t326;
    const double t2009 = t524 * t2008;
    const double t2012 = t41 * t71;
    const double t2015 = (t1611 * t2009) + (t1899 * t2008) + (t1929 * t2012);
    const double t2019 = (cos_delta * t1972) - (t1935 * t1966);
    const double t2025 = (cos_delta * t894) + (sin_delta * t1987);
    const double t2027 = cos_delta * t899;
    const double t2029 = motion->constants[10] * t850;
    const double t2031 = t1947 + (t850 * t2029);
    const double t2034 = t1942 + (t835 * t2029);
    const double t2040 = (t117 * t1981) + (t110 * t2027) - (t818 * t2019) - (sin_delta * t1710) -
        (t107 * t2025) - (t153 * t2031);
    const double t2041 = t2040 - (t162 * t2034);
    const double t2043 = t32 * t1567;
    const double t2045 = (t34 * t518) + (t524 * t2043);
    const double t2048 = t32 * t1907;
    const double t2051 = (t1929 * t2048) - (t1611 * t2045) - (t1899 * t2043);
    const double t2053 = t31 * t928;
    const double t2055 = t925 * t2053;
    const double t2057 = t835 * t925;
    const double t2059 = t850 * t925;
    const double t2063 = (t120 * t2053) + (t153 * t2057) - (t149 * t2055) - (t162 * t2059);
    const double t2064 = t845 * t921;
    const double t2068 = (t850 * t921) + (t835 * t917);
    const double t2069 = t2015 * t2068;
    const double t2070 = t845 * t917;
    const double t2073 = t2069 - (t1964 * t2064) - (t2051 * t2070);
    const double t2076 = (motion->constants[7] * t897) - t855;
    const double t2077 = t815 * t2076;
    const double t2086 = (t14 * t1680) + (t26 * t1707) + (t124 * t2051) - (t26 * t1964) - (t115 *
        t2015);
    const double t2089 = t1846 + (t110 * t866);
    const double t2090 = sin_delta * t1934;
    const double t2094 = (cos_delta * t1966) + (cos_delta * motion->constants[24]);
    const double t2097 = t1967 + (sin_delta * motion->constants[24]);
    const double t2100 = (t2015 * t2094) + (t2051 * t2097) - (t1964 * t2090);
    const double t2102 = t828 * motion->constants[29];
    const double t2103 = motion->constants[28] * t817;
    const double t2107 = (t817 * t1783) - t830;
    const double t2110 = t867 + t867;
    const double t2111 = motion->constants[34] * t2110;
    const double t2114 = t1090 - (t828 * t1783) - (sin_delta * t2111);
    const double t2120 = motion->constants[17] * t2110;
    const double t2123 = (t1633 * (t1148 + t1148)) + (t1698 * (t1146 + t1146)) + (t1698 * t2120);
    const double t2127 = t2123 + (motion->constants[23] * t2120) + (cos_delta * t2111);
    const double t2131 = (t26 * t2107) - (t14 * t2114);
    const double t2133 = motion->constants[24] * t828;
    const double t2134 = motion->constants[23] * t817;
    const double t2135 = t2133 + t2134;
    const double t2137 = t869 + t869;
    const double t2142 = (sin_delta * t2137) + (cos_delta * t2135);
    const double t2146 = (sin_delta * t2135) - (cos_delta * t2137);
    const double t2149 = motion->constants[22] * t835;
    const double t2151 = (motion->constants[38] * t835) + t2149 - t852;
    const double t2154 = motion->constants[22] * t850;
    const double t2156 = t1099 - (motion->constants[38] * t850) - t2154;
    const double t2157 = cos_delta * t2156;
    const double t2159 = t850 * motion->constants[35];
    const double t2160 = motion->constants[34] * t835;
    const double t2161 = t2159 + t2160;
    const double t2163 = t1055 + t1055;
    const double t2165 = (cos_delta * t2161) - (sin_delta * t2163);
    const double t2168 = t1068 + t1068;
    const double t2173 = (sin_delta * t2161) + (cos_delta * t2163);
    const double t2175 = (t1698 * t2168) + (t1633 * t2173);
    const double t2179 = (sin_delta * t2156) + (motion->constants[23] * t2168) + t2175 -
        (motion->constants[24] * t2173);
    const double t2185 = (t26 * t2151) + (t85 * t2165) - (t14 * t2157);
    const double t2188 = t906 + t931;
    const double t2189 = t906 + t2188;
    const double t2191 = motion->constants[25] * t835;
    const double t2194 = (t850 * motion->constants[26]) - (speeds[1] * t1966);
    const double t2195 = t2191 + t2194;
    const double t2197 = t908 + t933;
    const double t2198 = t908 + t2197;
    const double t2204 = (t1642 * t2165) + (t764 * t2185) + (speeds[1] * t1837) + (t2015 * t2195) -
        (t14 * t2151) - (t26 * t2157);
    const double t2207 = t2204 - (t753 * t2179) - (t1964 * t2189) - (t2051 * t2198);
    const double t2210 = t847 - (motion->constants[36] * t838);
    const double t2212 = motion->constants[37] * t838;
    const double t2216 = (motion->constants[36] * t850) - t1097 - t1099;
    const double t2218 = (cos_delta * t2212) - (sin_delta * t2216);
    const double t2222 = (cos_delta * t1055) + (sin_delta * t2159);
    const double t2225 = t1059 - t1058;
    const double t2230 = (cos_delta * t2159) - (sin_delta * t1055);
    const double t2232 = (t1698 * t2225) + (t1633 * t2230);
    const double t2238 = (sin_delta * t2212) + (motion->constants[24] * t2230) + (cos_delta *
        t2216) - (motion->constants[23] * t2225) - t2232;
    const double t2244 = (t26 * t2210) + (t85 * t2222) - (t14 * t2218);
    const double t2249 = t950 + t963;
    const double t2252 = (speeds[1] * t1934) + t2249 - t949 - (t34 * t1943);
    const double t2255 = t2197 + (t844 * t917);
    const double t2258 = t2194 + (t34 * t2029);
    const double t2260 = t32 * t925;
    const double t2266 = (t1642 * t2222) + (t764 * t2244) + (t1964 * t2252) + (t2015 * t2255) +
        (t2051 * t2258) + (t2073 * t2260);
    const double t2270 = t2266 - (t14 * t2210) - (t26 * t2218) - (t753 * t2238) - (speeds[1] *
        t1816);
    const double t2276 = (t764 * t2131) + (t1742 * t2135) + (t2015 * t2142) + (t2051 * t2146) +
        (cos_delta * t2207) + (sin_delta * t2270);
    const double t2280 = t2276 - (motion->constants[7] * (t2102 + t2103)) - (t14 * t2107) - (t26 *
        t2114) - (t753 * t2127);
    const double t2282 = t2280 - (t1679 * t2137) - (t1964 * t2110);
    const double t2284 = t14 * t818;
    const double t2288 = (t110 * t815) - t2284 - (speeds[0] * t107);
    const double t2291 = t823 - (motion->constants[32] * t819);
    const double t2293 = motion->constants[30] * t819;
    const double t2294 = t886 - t885;
    const double t2295 = motion->constants[34] * t2294;
    const double t2297 = t2293 + (sin_delta * t2295);
    const double t2303 = motion->constants[17] * t2294;
    const double t2306 = (t1633 * t2102) + (t1698 * (t1181 - t1180)) + (t1698 * t2303);
    const double t2313 = (motion->constants[32] * t828) - t1088 - t1090 - t2306 -
        (motion->constants[23] * t2303) - (cos_delta * t2295);
    const double t2317 = (t26 * t2291) - (t14 * t2297);
    const double t2326 = t869 + (motion->constants[23] * t91);
    const double t2329 = (t91 * t1934) + (cos_delta * t2326) - (sin_delta * t2133);
    const double t2333 = (cos_delta * t2133) + (sin_delta * t2326);
    const double t2341 = (t764 * t2317) + (t869 * t1742) + (t1679 * t2133) + (t91 * t1774) +
        (t1964 * t2294) + (t2015 * t2329);
    const double t2346 = t2341 + (t2051 * t2333) + (cos_delta * t2270) - (motion->constants[7] *
        t1148) - (t14 * t2291) - (t26 * t2297);
    const double t2348 = t2346 - (t753 * t2313) - (sin_delta * t2207);
    const double t2350 = t26 * t818;
    const double t2354 = t2350 + (t107 * t815) + (speeds[0] * t110);
    const double t2356 = t2212 + t2293;
    const double t2360 = (motion->constants[39] * t838) - t847;
    const double t2361 = cos_delta * t2360;
    const double t2364 = t851 + t852 - (motion->constants[39] * t835);
    const double t2366 = t2364 - (motion->constants[34] * t2134);
    const double t2370 = (motion->constants[33] * t819) + t2361 - t823 - (sin_delta * t2366);
    const double t2373 = motion->constants[17] * t2134;
    const double t2378 = t1057 + t1059;
    const double t2380 = (sin_delta * t1068) + (cos_delta * t2378);
    const double t2383 = (sin_delta * t2360) - (motion->constants[23] * t2160) -
        (motion->constants[24] * t2380);
    const double t2390 = (t1698 * t2160) - (t1633 * t2380);
    const double t2393 = (t1698 * t2103) + (t1698 * t2373) + t2390 - (t1633 * (t1179 + t1181));
    const double t2400 = t829 + t830 + t2383 + (cos_delta * t2366) - (motion->constants[33] *
        t817) - (motion->constants[23] * t2373) - t2393;
    const double t2406 = (cos_delta * t1068) - (sin_delta * t2378);
    const double t2407 = t85 * t2406;
    const double t2409 = t2407 - (t26 * t2356) - (t14 * t2370);
    const double t2412 = t884 + t886;
    const double t2416 = t2191 + (t32 * t1943);
    const double t2417 = t2134 + t2416;
    const double t2421 = t2188 + (t844 * t921);
    const double t2424 = (cos_delta * t867) + t2421 + (sin_delta * t2412);
    const double t2429 = t948 + t2249 + (t32 * t2029);
    const double t2432 = (sin_delta * t867) - t2429 - (cos_delta * t2412);
    const double t2436 = t34 * t925;
    const double t2438 = (t1642 * t2406) + (t2073 * t2436);
    const double t2443 = (t14 * t2356) + (t764 * t2409) + (t867 * t1742) + (t1964 * t2417) +
        (t2015 * t2424) + (t2051 * t2432);
    const double t2448 = t2443 + (t91 * t2100) + t2438 - (motion->constants[7] * t1146) - (t26 *
        t2370) - (t753 * t2400);
    const double t2450 = t2448 - (t1679 * t2412) - (t91 * t1867);
    const double t2453 = cos_delta * t2154;
    const double t2455 = sin_delta * t2154;
    const double t2459 = (t26 * t2149) + (t14 * t2453);
    const double t2467 = t2069 + (t26 * t2453) + (t753 * t2455) + (t764 * t2459) - (t14 * t2149) -
        (t931 * t1964);
    const double t2468 = t2467 - (t933 * t2051);
    const double t2473 = t1711 + t2134;
    const double t2475 = (t817 * t1934) + (cos_delta * t2473);
    const double t2477 = sin_delta * t2473;
    const double t2482 = (t1711 * t1746) - (t855 * t2086);
    const double t2487 = t2282 + (t817 * t1774) + (t2015 * t2475) + (t2051 * t2477) + (t828 *
        t2100) - (t828 * t1867);
    const double t2488 = t2487 - t2482;
    const double t2490 = cos_phi * t1615;
    const double t2492 = cos_phi * t1683;
    const double t2495 = cos_phi * t1709;
    const double t2496 = (sin_phi * t1711) - t2495;
    const double t2498 = sin_phi * t809;
    const double t2500 = speeds[0] * cos_phi;
    const double t2502 = sin_phi * t827;
    const double t2504 = cos_phi * t1938;
    const double t2509 = t2495 + (sin_phi * t1980);
    const double t2512 = (sin_phi * t1977) + (cos_phi * t1974) + (cos_delta * t2509);
    const double t2516 = (cos_phi * t2019) + (sin_delta * t2509);
    const double t2518 = sin_phi * t2076;
    const double t2528 = (t1680 * t2490) + (t1746 * t2496) + (t1774 * t2498) + (t1964 * t2504) +
        (t2015 * t2512) + (t2051 * t2516);
    const double t2533 = t2528 + (t2086 * t2518) + (t2100 * t2502) + (t18 * t2348) - (t1707 *
        t2492) - (t1843 * t2500);
    const double t2536 = t2533 - (t1867 * t2502) - (sin_phi * t2282) - (t27 * t2450);
    const double t2542 = (t364 * t1539) + (t107 * t1496) + (t369 * t1546) + (t1601 * t1611) +
        (t1632 * t1680) + (t1697 * t1707);
    const double t2547 = t2542 + (t1715 * t1746) + (t1754 * t1774) + (t1779 * t1843) + (t1888 *
        t1899) + (t1918 * t1929);
    const double t2552 = t2547 + (t1954 * t1964) + (t2007 * t2015) + (t2041 * t2051) + (t2063 *
        t2073) + (t2077 * t2086);
    const double t2557 = t2552 + (t2089 * t2100) + (t2288 * t2348) + (t2354 * t2450) + (t620 *
        t2468) + (t235 * t2488);
    const double t2562 = t2557 - (t465 * t2536) - (t364 * t1499) - (t110 * t1457) - (t199 * t1538) -
        (t566 * t1548);
    const double t2566 = t2562 - (t753 * t1554) - (t764 * t1558) - (t1851 * t1867) - (t815 * t2282);
    const double t2579 = (t1230 * t1607) - (t690 * motion->constants[22]) - (t1228 * t1605);
    const double t2587 = (t1230 * t1669) - motion->constants[34] - (t1228 * t1663);
    const double t2590 = (t1230 * t1653) - (t1228 * t1649) - (sin_delta * t2587);
    const double t2591 = t2590 - (t1228 * t1635);
    const double t2595 = (t1230 * t1704) - (t1228 * t1702);
    const double t2602 = (t1230 * t1736) + (cos_delta * t2587) - (t1228 * t1732);
    const double t2603 = (t1230 * t1721) + t2602;
    const double t2610 = (t1230 * t1766) + (motion->constants[23] * t2602) - motion->constants[39] -
        (t1228 * t1760);
    const double t2618 = t2579 + (t1230 * t1811) - (t1228 * t1807);
    const double t2623 = (t1230 * t1832) - motion->constants[37] - (t1228 * t1826);
    const double t2628 = (t1230 * t1794) + (motion->constants[24] * t2590) + (cos_delta * t2618) +
        (sin_delta * t2623) - (t1228 * t1792);
    const double t2636 = (t1230 * t1857) + (cos_delta * t2623) - (motion->constants[24] * t2602) -
        (sin_delta * t2618);
    const double t2646 = (t1889 * t2591) + (t18 * t2636) - (t1891 * t2595) - (t27 * t2610) -
        (sin_phi * t2628);
    const double t2655 = t2628 + (t1921 * t2579) + (t1698 * t2595) + (t363 * t2646) - (t1633 *
        t2591);
    const double t2661 = (t1958 * t2579) + (t1961 * t2655) - (t1956 * t2646);
    const double t2667 = (t2009 * t2579) + (t2008 * t2646) + (t2012 * t2655);
    const double t2673 = (t2048 * t2655) - (t2045 * t2579) - (t2043 * t2646);
    const double t2676 = t2068 * t2667;
    const double t2679 = t2676 - (t2064 * t2661) - (t2070 * t2673);
    const double t2689 = (t14 * t2591) + (t26 * t2595) + (t124 * t2673) - (t26 * t2661) - (t115 *
        t2667);
    const double t2695 = (t2094 * t2667) + (t2097 * t2673) - (t2090 * t2661);
    const double t2714 = (t1230 * t2185) + (speeds[1] * t2623) + (t2195 * t2667) - t2151 - (t1228 *
        t2179) - (t2189 * t2661);
    const double t2715 = t2714 - (t2198 * t2673);
    const double t2728 = (t1230 * t2244) + (t2252 * t2661) + (t2255 * t2667) + (t2258 * t2673) +
        (t2260 * t2679) - t2210;
    const double t2730 = t2728 - (t1228 * t2238) - (speeds[1] * t2618);
    const double t2736 = (t1230 * t2131) + (t2135 * t2602) + (t2142 * t2667) + (t2146 * t2673) +
        (cos_delta * t2715) + (sin_delta * t2730);
    const double t2739 = t2736 - (t1228 * t2127) - (t2137 * t2590) - (t2110 * t2661);
    const double t2755 = (t1230 * t2317) + (t869 * t2602) + (t2133 * t2590) + (t91 * t2610) +
        (t2294 * t2661) + (t2329 * t2667);
    const double t2759 = t2755 + (t2333 * t2673) + (cos_delta * t2730) - (t1228 * t2313) -
        (sin_delta * t2715);
    const double t2771 = t2212 + (t2436 * t2679);
    const double t2776 = (t1230 * t2409) + (t867 * t2602) + (t2417 * t2661) + (t2424 * t2667) +
        (t2432 * t2673) + (t91 * t2695);
    const double t2780 = t2776 + t2771 - (t1228 * t2400) - (t2412 * t2590) - (t91 * t2636);
    const double t2790 = t2676 + (t1228 * t2455) + (t1230 * t2459) - t2149 - (t931 * t2661) -
        (t933 * t2673);
    const double t2799 = (t1711 * t2603) + (t855 * t2689);
    const double t2804 = t2739 + (t817 * t2610) + (t2475 * t2667) + (t2477 * t2673) + (t828 *
        t2695) + t2799;
    const double t2805 = t2804 - (t828 * t2636);
    const double t2825 = (t2490 * t2591) + (t2498 * t2610) + (t2504 * t2661) + (t2512 * t2667) +
        (t2516 * t2673) + (t2518 * t2689);
    const double t2830 = t2825 + (t2502 * t2695) + (t18 * t2759) - (t2492 * t2595) - (t2496 *
        t2603) - (t2500 * t2628);
    const double t2833 = t2830 - (t2502 * t2636) - (sin_phi * t2739) - (t27 * t2780);
    const double t2840 = (t447 * t1539) + (t461 * t1546) + (t1601 * t2579) + (t1632 * t2591) +
        (t1697 * t2595) + (t1754 * t2610);
    const double t2845 = t2840 + (t1779 * t2628) + (t1888 * t2646) + (t1918 * t2655) + (t1954 *
        t2661) + (t2007 * t2667);
    const double t2850 = t2845 + (t2041 * t2673) + (t2063 * t2679) + (t2077 * t2689) + (t2089 *
        t2695) + (t2288 * t2759);
    const double t2855 = t2850 + (t2354 * t2780) + (t620 * t2790) + (t235 * t2805) - (t465 *
        t2833) - (t447 * t1499);
    const double t2860 = t2855 - (t233 * t1538) - (t617 * t1548) - (t1228 * t1554) - (t1230 *
        t1558) - (t1715 * t2603);
    const double t2863 = t2860 - (t1851 * t2636) - (t815 * t2739) - (t1262 * t2566);
    const double t2867 = t341 * t1546;
    const double t2869 = t329 * t1546;
    const double t2878 = (t1295 * t1605) + (t1297 * t1607) - (t693 * motion->constants[22]);
    const double t2886 = (t1295 * t1663) + (t1297 * t1669) - t1660;
    const double t2890 = t1645 + (t1295 * t1649) + (t1297 * t1653) - (sin_delta * t2886);
    const double t2892 = t1634 + (t1295 * t1635) + t2890;
    const double t2897 = (t1295 * t1702) + (t1297 * t1704) - t1701;
    const double t2905 = t1728 + (t1295 * t1732) + (t1297 * t1736) + (cos_delta * t2886);
    const double t2906 = (t1297 * t1721) + t2905;
    const double t2913 = (t1295 * t1760) + (t1297 * t1766) + (motion->constants[23] * t2905) -
        t1759;
    const double t2922 = t1802 + t2878 + (t1295 * t1807) + (t1297 * t1811);
    const double t2927 = t1823 + (t1295 * t1826) + (t1297 * t1832);
    const double t2933 = t1788 + (t1295 * t1792) + (t1297 * t1794) + (motion->constants[24] *
        t2890) + (cos_delta * t2922) + (sin_delta * t2927);
    const double t2934 = t2933 - motion->constants[21];
    const double t2942 = (t1297 * t1857) + (cos_delta * t2927) - (motion->constants[24] * t2905) -
        (sin_delta * t2922);
    const double t2952 = (t1889 * t2892) + (t18 * t2942) - (t1891 * t2897) - (t27 * t2913) -
        (sin_phi * t2934);
    const double t2961 = t2934 + (t1921 * t2878) + (t1698 * t2897) + (t363 * t2952) - (t1633 *
        t2892);
    const double t2967 = (t1958 * t2878) + (t1961 * t2961) - (t1956 * t2952);
    const double t2973 = (t2009 * t2878) + (t2008 * t2952) + (t2012 * t2961);
    const double t2979 = (t2048 * t2961) - (t2045 * t2878) - (t2043 * t2952);
    const double t2982 = t2068 * t2973;
    const double t2985 = t2982 - (t2064 * t2967) - (t2070 * t2979);
    const double t2995 = (t14 * t2892) + (t26 * t2897) + (t124 * t2979) - (t26 * t2967) - (t115 *
        t2973);
    const double t3001 = (t2094 * t2973) + (t2097 * t2979) - (t2090 * t2967);
    const double t3020 = (t1295 * t2179) + (t1297 * t2185) + (speeds[1] * t2927) + (t2195 * t2973) -
        t2175 - (t2189 * t2967);
    const double t3021 = t3020 - (t2198 * t2979);
    const double t3034 = t2232 + (t1295 * t2238) + (t1297 * t2244) + (t2252 * t2967) + (t2255 *
        t2973) + (t2258 * t2979);
    const double t3036 = t3034 + (t2260 * t2985) - (speeds[1] * t2922);
    const double t3042 = (t1295 * t2127) + (t1297 * t2131) + (t2135 * t2905) + (t2142 * t2973) +
        (t2146 * t2979) + (cos_delta * t3021);
    const double t3046 = t3042 + (sin_delta * t3036) - t2123 - (t2137 * t2890) - (t2110 * t2967);
    const double t3062 = t2306 + (t1295 * t2313) + (t1297 * t2317) + (t869 * t2905) + (t2133 *
        t2890) + (t91 * t2913);
    const double t3067 = t3062 + (t2294 * t2967) + (t2329 * t2973) + (t2333 * t2979) + (cos_delta *
        t3036) - (sin_delta * t3021);
    const double t3077 = t2436 * t2985;
    const double t3083 = t2393 + (t1295 * t2400) + (t1297 * t2409) + (t867 * t2905) + (t2417 *
        t2967) + (t2424 * t2973);
    const double t3088 = t3083 + (t2432 * t2979) + t3077 + (t91 * t3001) - (t2412 * t2890) - (t91 *
        t2942);
    const double t3097 = t2982 + (t1297 * t2459) - (t1295 * t2455) - (t931 * t2967) - (t933 *
        t2979);
    const double t3106 = (t1711 * t2906) + (t855 * t2995);
    const double t3111 = t3046 + (t817 * t2913) + (t2475 * t2973) + (t2477 * t2979) + (t828 *
        t3001) + t3106;
    const double t3112 = t3111 - (t828 * t2942);
    const double t3132 = (t2490 * t2892) + (t2498 * t2913) + (t2504 * t2967) + (t2512 * t2973) +
        (t2516 * t2979) + (t2518 * t2995);
    const double t3137 = t3132 + (t2502 * t3001) + (t18 * t3067) - (t2492 * t2897) - (t2496 *
        t2906) - (t2500 * t2934);
    const double t3140 = t3137 - (t2502 * t2942) - (sin_phi * t3046) - (t27 * t3088);
    const double t3148 = (t328 * t1539) + (t191 * t2867) + (t1295 * t1554) + (t1601 * t2878) +
        (t1632 * t2892) + (t1697 * t2897);
    const double t3153 = t3148 + (t1754 * t2913) + (t1779 * t2934) + (t1888 * t2952) + (t1918 *
        t2961) + (t1954 * t2967);
    const double t3158 = t3153 + (t2007 * t2973) + (t2041 * t2979) + (t2063 * t2985) + (t2077 *
        t2995) + (t2089 * t3001);
    const double t3163 = t3158 + (t2288 * t3067) + (t2354 * t3088) + (t620 * t3097) + (t235 *
        t3112) - (t465 * t3140);
    const double t3169 = t3163 - t1554 - (t328 * t1499) - (t339 * t2869) - (t543 * t1484) - (t1297 *
        t1558) - (t1715 * t2906);
    const double t3174 = t1368 * (t3169 - (t1851 * t2942) - (t815 * t3046) - (t1327 * t2566) -
        (t1336 * t2863));
    const double t3176 = (t1280 * t2863) - (t1336 * t3174);
    const double t3180 = (t808 * t2566) - (t1262 * t3176) - (t1327 * t3174);
    const double t3183 = (t1403 * t1637) - (t1418 * t1658);
    const double t3185 = t1507 + (sin_delta * t3183);
    const double t3187 = motion->constants[17] * t1403;
    const double t3191 = motion->constants[17] * t1418;
    const double t3195 = (cos_delta * (t1439 + (sin_delta * t3187))) - (sin_delta * (t1446 +
        (sin_delta * t3191)));
    const double t3208 = (cos_delta * ((cos_delta * t3187) - t1446)) - (sin_delta * (t1439 +
        (cos_delta * t3191)));
    const double t3215 = (t242 * t1552) + (t1633 * t3208) - (t240 * t1550);
    const double t3218 = t1490 + (motion->constants[24] * t3208) + (cos_delta * t3183) - t3215;
    const double t3226 = (t14 * t3185) + (t85 * t3195) - (t240 * t1457) - (t242 * t1496);
    const double t3243 = (t260 * t1564) + (t264 * t1570) + (t268 * t1575) + (t481 * t1580) + (t629 *
        t1582) + (t634 * t1369);
    const double t3248 = t3243 + (t649 * t1588) + (t675 * t1590) - (t245 * t1561) - (t642 * t1577) -
        (t472 * t1585);
    const double t3257 = (t240 * t1414) + (t242 * t1027) - (t303 * t1622) - (t311 * t1625);
    const double t3265 = (t242 * t1414) + (t303 * t1688) + (t311 * t1690) - (t240 * t1027);
    const double t3271 = (t242 * t1375) - (t240 * t1389);
    const double t3275 = (t303 * t1375) + (t311 * t1371);
    const double t3279 = (t240 * t1375) + (t242 * t1389);
    const double t3294 = (t260 * t1563) + (t268 * t1573) + (t296 * t1873) + (t481 * t1579) + (t486 *
        t1375) + (t512 * t1371);
    const double t3297 = t3294 - (t245 * t1560) - (t264 * t1568) - (t472 * t1877);
    const double t3307 = (t245 * t1903) + (t260 * t1905) + (t264 * t1908) - (t268 * t1910) - (t301 *
        t1912);
    const double t3319 = (t240 * t899) + (t242 * t894) + (t264 * t1945) + (t268 * t1949) - (t911 *
        t1934) - (t912 * t1934);
    const double t3322 = (t889 * t1966) - t903;
    const double t3325 = t881 + (t877 * t1966);
    const double t3335 = (cos_delta * t3322) + (t264 * t1996) - (sin_delta * t3325) - (t240 *
        t1990) - (t242 * t1992) - (t268 * t2000);
    const double t3347 = (cos_delta * t3325) + (sin_delta * t3322) + (t242 * t2027) - (t240 *
        t2025) - (t264 * t2031) - (t268 * t2034);
    const double t3355 = (t245 * t2053) + (t264 * t2057) - (t260 * t2055) - (t268 * t2059);
    const double t3357 = t242 * t866;
    const double t3363 = (t242 * t815) - (speeds[0] * t240);
    const double t3367 = (t240 * t815) + (speeds[0] * t242);
    const double t3376 = (t26 * t3185) + (t1642 * t3195) + (t240 * t1496) + (t486 * t1546) + (t764 *
        t3226) + (t1611 * t3248);
    const double t3381 = t3376 + (t1680 * t3257) + (t1707 * t3265) + (t1435 * t1837) + (t1774 *
        t3271) + (t1843 * t3275);
    const double t3386 = t3381 + (t1899 * t3297) + (t1929 * t3307) + (t1964 * t3319) + (t2015 *
        t3335) + (t2051 * t3347);
    const double t3391 = t3386 + (t2073 * t3355) + (t2100 * t3357) + (t838 * t2270) + (t2348 *
        t3363) + (t2450 * t3367);
    const double t3396 = t3391 + (t678 * t2468) + (t313 * t2488) - (t516 * t2536) - (t242 * t1457) -
        (t303 * t1538);
    const double t3401 = t3396 - (t649 * t1548) - (t753 * t3218) - (t1431 * t1674) - (t1424 *
        t1816) - (t1867 * t3279);
    const double t3402 = t3401 - (t835 * t2207);
    const double t3437 = (t512 * t1546) + (t1230 * t3226) + (t2579 * t3248) + (t2591 * t3257) +
        (t2595 * t3265) + (t1435 * t2623);
    const double t3442 = t3437 + (t2610 * t3271) + (t2628 * t3275) + (t2646 * t3297) + (t2655 *
        t3307) + (t2661 * t3319);
    const double t3447 = t3442 + (t2667 * t3335) + (t2673 * t3347) + (t2679 * t3355) + (t2695 *
        t3357) + (t838 * t2730);
    const double t3452 = t3447 + (t2759 * t3363) + (t2780 * t3367) + (t678 * t2790) + (t313 *
        t2805) - (t516 * t2833);
    const double t3457 = t3452 - (t311 * t1538) - (t675 * t1548) - (t1228 * t3218) - (t1431 *
        t2587) - (t1424 * t2618);
    const double t3460 = t3457 - (t2636 * t3279) - (t835 * t2715) - (t1262 * t3402);
    const double t3496 = t3215 + (t296 * t2867) + (t1295 * t3218) + (t1297 * t3226) + (t2878 *
        t3248) + (t2892 * t3257);
    const double t3501 = t3496 + (t2897 * t3265) + (t1435 * t2927) + (t2913 * t3271) + (t2934 *
        t3275) + (t2952 * t3297);
    const double t3506 = t3501 + (t2961 * t3307) + (t2967 * t3319) + (t2973 * t3335) + (t2979 *
        t3347) + (t2985 * t3355);
    const double t3511 = t3506 + (t3001 * t3357) + (t838 * t3036) + (t3067 * t3363) + (t3088 *
        t3367) + (t678 * t3097);
    const double t3516 = t3511 + (t313 * t3112) - (t516 * t3140) - (t472 * t2869) - (t634 * t1484) -
        (t1431 * t2886);
    const double t3521 = t3516 - (t1424 * t2922) - (t2942 * t3279) - (t835 * t3021) - (t1327 *
        t3402) - (t1336 * t3460);
    const double t3522 = t1368 * t3521;
    const double t3524 = (t1280 * t3460) - (t1336 * t3522);
    const double t3528 = (t808 * t3402) - (t1262 * t3524) - (t1327 * t3522);
    const double t3529 = t1711 + t1711;
    const double t3530 = t26 * t3529;
    const double t3532 = t14 * t3529;
    const double t3539 = cos_delta * t815;
    const double t3542 = (t14 * t1711) + (t815 * t1932) + (t1934 * t3539);
    const double t3548 = (t26 * t1711) + (t815 * t1970);
    const double t3550 = motion->constants[23] * t2350;
    const double t3554 = (t1934 * t2350) + (t815 * t1967) + (cos_delta * t3550) - (sin_delta *
        t3548);
    const double t3560 = (cos_delta * t3548) + (sin_delta * t3550) - (t1966 * t3539);
    const double t3573 = (t1680 * t3530) + (t1774 * t2350) + (t1964 * t3542) + (t2015 * t3554) +
        (t2051 * t3560) + (t2100 * t2284);
    const double t3578 = t3573 + (t26 * t2348) + (t14 * t2450) + (t682 * t2468) + (t72 * t2488) +
        (t364 * t2536);
    const double t3582 = t3578 - (t1707 * t3532) - (t815 * t1843) - (t1867 * t2284) - (t1614 *
        t2086);
    const double t3604 = (t2591 * t3530) + (t2350 * t2610) + (t2661 * t3542) + (t2667 * t3554) +
        (t2673 * t3560) + (t2284 * t2695);
    const double t3609 = t3604 + (t26 * t2759) + (t14 * t2780) + (t682 * t2790) + (t72 * t2805) +
        (t364 * t2833);
    const double t3614 = t3609 - (t2595 * t3532) - (t815 * t2628) - (t2284 * t2636) - (t1614 *
        t2689) - (t1262 * t3582);
    const double t3637 = (t2892 * t3530) + (t2350 * t2913) + (t2967 * t3542) + (t2973 * t3554) +
        (t2979 * t3560) + (t2284 * t3001);
    const double t3642 = t3637 + (t26 * t3067) + (t14 * t3088) + (t682 * t3097) + (t72 * t3112) +
        (t364 * t3140);
    const double t3647 = t3642 - (t2897 * t3532) - (t815 * t2934) - (t2284 * t2942) - (t1614 *
        t2995) - (t1327 * t3582);
    const double t3649 = t1368 * (t3647 - (t1336 * t3614));
    const double t3651 = (t1280 * t3614) - (t1336 * t3649);
    const double t3655 = (t808 * t3582) - (t1262 * t3651) - (t1327 * t3649);
    const double t3658 = t2361 - (sin_delta * t2364);
    const double t3662 = t2383 + (cos_delta * t2364) - t2390;
    const double t3667 = t2407 - (t26 * t2212) - (t14 * t3658);
    const double t3672 = t2416 + (t835 * t1934);
    const double t3675 = t2421 - (t838 * t1966);
    const double t3678 = t2429 + (t835 * t1966);
    const double t3687 = t2438 + (t14 * t2212) + (t764 * t3667) + (t838 * t1837) + (t1964 * t3672) +
        (t2015 * t3675);
    const double t3692 = t3687 + (t690 * t2468) + (t89 * t2488) + (t447 * t2536) - (t26 * t3658) -
        (t753 * t3662);
    const double t3694 = t3692 - (t835 * t1816) - (t2051 * t3678);
    const double t3711 = t2771 + (t1230 * t3667) + (t838 * t2623) + (t2661 * t3672) + (t2667 *
        t3675) + (t690 * t2790);
    const double t3716 = t3711 + (t89 * t2805) + (t447 * t2833) - (t1228 * t3662) - (t835 * t2618) -
        (t2673 * t3678);
    const double t3717 = t3716 - (t1262 * t3694);
    const double t3736 = t2390 + t3077 + (t1295 * t3662) + (t1297 * t3667) + (t838 * t2927) +
        (t2967 * t3672) + (t2973 * t3675);
    const double t3741 = t3736 + (t690 * t3097) + (t89 * t3112) + (t447 * t3140) - (t835 * t2922) -
        (t2979 * t3678);
    const double t3744 = t1368 * (t3741 - (t1327 * t3694) - (t1336 * t3717));
    const double t3746 = (t1280 * t3717) - (t1336 * t3744);
    const double t3750 = (t808 * t3694) - (t1262 * t3746) - (t1327 * t3744);
    const double t3751 = motion->constants[21] * t817;
    const double t3753 = motion->constants[21] * t828;
    const double t3757 = (t26 * t3751) + (t14 * t3753);
    const double t3759 = cos_delta * t1711;
    const double t3761 = sin_delta * t1711;
    const double t3769 = (t26 * t3753) + (t764 * t3757) + (t2015 * t3759) + (t2051 * t3761) +
        (t693 * t2468) + (t328 * t2536);
    const double t3771 = t3769 - t2482 - (t14 * t3751);
    const double t3783 = t2799 + (t1230 * t3757) + (t2667 * t3759) + (t2673 * t3761) + (t693 *
        t2790) + (t328 * t2833);
    const double t3784 = t3783 - (t1262 * t3771);
    const double t3797 = t3106 + (t1297 * t3757) + (t2973 * t3759) + (t2979 * t3761) + (t693 *
        t3097) + (t328 * t3140);
    const double t3800 = t1368 * (t3797 - (t1327 * t3771) - (t1336 * t3784));
    const double t3802 = (t1280 * t3784) - (t1336 * t3800);
    const double t3806 = (t808 * t3771) - (t1262 * t3802) - (t1327 * t3800);
    const double t3810 = t1368 * ((t1262 * t1336) - t1327);
    const double t3812 = (t1262 * t1280) + (t1336 * t3810);
    const double t3816 = t808 + (t1262 * t3812) - (t1327 * t3810);
    const double t3817 = t1336 * t1368;
    const double t3819 = t1280 + (t1336 * t3817);
    const double t3822 = (t1327 * t3817) - (t1262 * t3819);
    const double t3823 = -(t98 * t235);
    const double t3824 = -(t98 * t313);
    const double t3825 = -(t72 * t98);
    const double t3826 = -(t89 * t98);
    const double t3827 = -t98;
    const double t3828 = -(t93 * cos_psi);
    const double t3829 = -(t235 * t318);
    const double t3830 = -(t313 * t318);
    const double t3831 = -(t72 * t318);
    const double t3832 = -(t89 * t318);
    const double t3833 = -t318;
    const double t3834 = -t364;
    const double t3835 = -t447;
    const double t3836 = -t328;
    const double t3837 = -t3812;
    const double t3838 = -t3817;
    linearization->a[0][0] = 0.0;
    linearization->a[0][1] = 0.0;
    linearization->a[0][2] = t96;
    linearization->a[0][3] = t3823;
    linearization->a[0][4] = 0.0;
    linearization->a[0][5] = t3824;
    linearization->a[0][6] = 0.0;
    linearization->a[0][7] = 0.0;
    linearization->a[0][8] = t3825;
    linearization->a[0][9] = t3826;
    linearization->a[0][10] = t3827;
    linearization->b[0][0] = 0.0;
    linearization->b[0][1] = 0.0;
    linearization->a[1][0] = 0.0;
    linearization->a[1][1] = 0.0;
    linearization->a[1][2] = t3828;
    linearization->a[1][3] = t3829;
    linearization->a[1][4] = 0.0;
    linearization->a[1][5] = t3830;
    linearization->a[1][6] = 0.0;
    linearization->a[1][7] = 0.0;
    linearization->a[1][8] = t3831;
    linearization->a[1][9] = t3832;
    linearization->a[1][10] = t3833;
    linearization->b[1][0] = 0.0;
    linearization->b[1][1] = 0.0;
    linearization->a[2][0] = 0.0;
    linearization->a[2][1] = 0.0;
    linearization->a[2][2] = 0.0;
    linearization->a[2][3] = t465;
    linearization->a[2][4] = 0.0;
    linearization->a[2][5] = t516;
    linearization->a[2][6] = 0.0;
    linearization->a[2][7] = 0.0;
    linearization->a[2][8] = t3834;
    linearization->a[2][9] = t3835;
    linearization->a[2][10] = t3836;
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
    linearization->a[4][3] = t235;
    linearization->a[4][4] = 0.0;
    linearization->a[4][5] = t313;
    linearization->a[4][6] = 0.0;
    linearization->a[4][7] = 0.0;
    linearization->a[4][8] = t72;
    linearization->a[4][9] = t89;
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
    linearization->a[7][3] = t620;
    linearization->a[7][4] = 0.0;
    linearization->a[7][5] = t678;
    linearization->a[7][6] = 0.0;
    linearization->a[7][7] = 0.0;
    linearization->a[7][8] = t682;
    linearization->a[7][9] = t690;
    linearization->a[7][10] = t693;
    linearization->b[7][0] = 0.0;
    linearization->b[7][1] = 0.0;
    linearization->a[8][0] = 0.0;
    linearization->a[8][1] = 0.0;
    linearization->a[8][2] = 0.0;
    linearization->a[8][3] = t3180;
    linearization->a[8][4] = 0.0;
    linearization->a[8][5] = t3528;
    linearization->a[8][6] = 0.0;
    linearization->a[8][7] = 0.0;
    linearization->a[8][8] = t3655;
    linearization->a[8][9] = t3750;
    linearization->a[8][10] = t3806;
    linearization->b[8][0] = t3816;
    linearization->b[8][1] = t3822;
    linearization->a[9][0] = 0.0;
    linearization->a[9][1] = 0.0;
    linearization->a[9][2] = 0.0;
    linearization->a[9][3] = t3176;
    linearization->a[9][4] = 0.0;
    linearization->a[9][5] = t3524;
    linearization->a[9][6] = 0.0;
    linearization->a[9][7] = 0.0;
    linearization->a[9][8] = t3651;
    linearization->a[9][9] = t3746;
    linearization->a[9][10] = t3802;
    linearization->b[9][0] = t3837;
    linearization->b[9][1] = t3819;
    linearization->a[10][0] = 0.0;
    linearization->a[10][1] = 0.0;
    linearization->a[10][2] = 0.0;
    linearization->a[10][3] = t3174;
    linearization->a[10][4] = 0.0;
    linearization->a[10][5] = t3522;
    linearization->a[10][6] = 0.0;
    linearization->a[10][7] = 0.0;
    linearization->a[10][8] = t3649;
    linearization->a[10][9] = t3744;
    linearization->a[10][10] = t3800;
    linearization->b[10][0] = t3810;
    linearization->b[10][1] = t3838;
}

carvallo_motion_error_t whipple_mechanism_f64_motion_linearize(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], const double forces[WHIPPLE_MECHANISM_FORCES],
    whipple_mechanism_f64_linearization_t *linearization)
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_MECHANISM_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_MECHANISM_FORCES)) {
        bool are_finite = true;
        whipple_mechanism_f64_compute_linearization(motion, positions, speeds, forces,
            linearization);
        for (size_t row = 0U; row < WHIPPLE_MECHANISM_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f64(linearization->a[row],
                WHIPPLE_MECHANISM_STATES) && carvallo_are_finite_f64(linearization->b[row],
                WHIPPLE_MECHANISM_FORCES);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_mechanism_f64_compute_by_parameters(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], const double forces[WHIPPLE_MECHANISM_FORCES],
    double by_parameters[WHIPPLE_MECHANISM_STATES][WHIPPLE_MECHANISM_PARAMETERS])
{
    double sin_pitch = 0.0;
    double cos_pitch = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_pitch, &cos_pitch);
    const double t7 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t12 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
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
    const double t41 = motion->constants[10] * t40;
    const double t48 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const double t51 = (t36 * t41) + (t7 * motion->constants[27]) + (t12 * t48);
    const double t53 = 1.0 / (cos_phi * t51);
    const double t54 = motion->constants[20] * t13;
    const double t55 = t7 * cos_delta;
    const double t57 = t20 - (cos_phi * t55);
    const double t59 = t54 + (motion->constants[19] * t57);
    const double t62 = t54 - t59 - (motion->constants[19] * t16);
    const double t64 = t53 * (t59 + t62);
    const double t65 = t7 * t64;
    const double t70 = t51 - (t7 * motion->constants[24]) - (t12 * motion->constants[23]);
    const double t71 = sin_phi * t53;
    const double t72 = t70 * t71;
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t77 = motion->constants[7] * cos_psi;
    const double t78 = speeds[1] * t77;
    const double t80 = t12 * sin_phi;
    const double t81 = t53 * t80;
    const double t82 = t78 * t81;
    const double t84 = t7 * t71;
    const double t85 = t78 * t84;
    const double t87 = t26 * t26;
    const double t88 = t21 * t87;
    const double t90 = t26 * 0.5;
    const double t92 = cos_phi * (t13 + t13);
    const double t93 = t90 * t92;
    const double t94 = t88 * t93;
    const double t96 = t12 * cos_delta;
    const double t98 = t13 * t87;
    const double t100 = (cos_phi * t26) - (t93 * t98);
    const double t103 = t32 + (t7 * t94) + (t96 * t100);
    const double t104 = t41 * t103;
    const double t105 = t7 * t53;
    const double t108 = t77 * speeds[0];
    const double t110 = (t78 * t105) + (t53 * t108);
    const double t115 = t28 + (sin_phi * t55);
    const double t118 = (sin_phi * t30) + (t100 * t115) - (t80 * t94);
    const double t120 = t48 + (t41 * t118);
    const double t123 = (t12 * t32) - (t7 * t30);
    const double t125 = sin_delta * motion->constants[25];
    const double t129 = (t12 * motion->constants[27]) - (t7 * t48);
    const double t132 = (cos_phi * t125) - (t41 * t123) - (sin_phi * t129);
    const double t135 = (t12 * motion->constants[24]) - (t7 * motion->constants[23]);
    const double t137 = t132 + (sin_phi * t135);
    const double t141 = t53 * ((t7 * t137) + (t70 * t80));
    const double t142 = cos_phi * t53;
    const double t143 = t141 * t142;
    const double t145 = sin_phi * motion->constants[7];
    const double t146 = t132 + t145;
    const double t147 = t53 * t146;
    const double t148 = t142 * t147;
    const double t151 = (t78 * t143) + (t108 * t148) - t82;
    const double t153 = sin_phi * t110;
    const double t159 = (motion->constants[23] * t82) + (t104 * t110) + (t120 * t151) +
        (motion->constants[27] * t153) - (t72 * t78) - (motion->constants[24] * t85);
    const double t161 = t12 * t64;
    const double t162 = t53 * t137;
    const double t166 = t28 * motion->constants[10];
    const double t168 = cos_phi * cos_delta;
    const double t171 = t168 * (t21 + t21);
    const double t172 = t90 * t171;
    const double t174 = (t88 * t172) - (t26 * t168);
    const double t176 = t98 * t172;
    const double t179 = (t96 * t176) - t30 - (t7 * t174);
    const double t181 = (t123 * t166) + (t41 * t179);
    const double t188 = (sin_phi * t32) + (t80 * t174) + (t115 * t176);
    const double t191 = motion->constants[27] + (t36 * t166) + (t41 * t188);
    const double t198 = (motion->constants[24] * t82) + (motion->constants[23] * t85) + (t110 *
        t181) + (t151 * t191) - (t78 * t162) - (t48 * t153);
    const double t204 = (t7 * t151) + (t12 * t153);
    const double t206 = (t7 * t82) + t204 - (t12 * t85);
    const double t214 = (t12 * t82) + (t7 * t85) + (t12 * t151) - (t7 * t153);
    const double t216 = (motion->constants[20] * t206) + (motion->constants[19] * t214);
    const double t218 = (t161 * t198) + t216 - (t65 * t159);
    const double t224 = (t96 * t151) - (t28 * t110) - (t55 * t153);
    const double t226 = t53 * t62;
    const double t227 = t7 * t226;
    const double t229 = t12 * t226;
    const double t234 = t216 + (t198 * t229) - (motion->constants[20] * t204) -
        (motion->constants[19] * t224) - (t159 * t227);
    const double t238 = motion->constants[6] + motion->constants[18];
    const double t242 = (motion->constants[19] * motion->constants[10]) - (motion->constants[20] *
        (motion->constants[6] - t238));
    const double t246 = cos_phi * t48;
    const double t248 = cos_phi * motion->constants[27];
    const double t256 = motion->constants[10] * t90;
    const double t257 = t171 * t256;
    const double t259 = t92 * t256;
    const double t277 = (motion->constants[19] * ((t16 * motion->constants[7]) + (t13 * t238) -
        (cos_pitch * t246) - (sin_pitch * t248))) + (t57 * t242);
    const double t279 = t277 + (t13 * motion->constants[25]) - (motion->constants[20] *
        ((cos_pitch * t248) + (t13 * motion->constants[7]) - (sin_pitch * t246) - (t16 * t238)));
    const double t282 = t53 * (t279 - (motion->constants[20] * ((cos_pitch * t259) - (sin_pitch *
        t257))) - (motion->constants[19] * ((cos_pitch * t257) + (sin_pitch * t259))));
    const double t284 = t7 + (t7 * t282);
    const double t287 = t12 + (t12 * t282);
    const double t293 = (motion->constants[25] * t204) + (t224 * t242) + (motion->constants[23] *
        t206) + (t198 * t287) - (motion->constants[24] * t214) - (t159 * t284);
    const double t298 = (speeds[0] * t147) + (speeds[1] * t141);
    const double t299 = speeds[2] + t298;
    const double t305 = motion->constants[19] * t13;
    const double t308 = t53 * ((motion->constants[20] * t16) + t305 - cos_phi);
    const double t309 = t7 * t308;
    const double t311 = t12 * t308;
    const double t317 = (motion->constants[19] * t206) + (t198 * t311) - (cos_psi * t299) - (t71 *
        t108) - (motion->constants[20] * t214) - (t159 * t309);
    const double t318 = t40 * t123;
    const double t320 = t36 * t40;
    const double t327 = t53 * (t25 + (motion->constants[20] * t57) - t305);
    const double t328 = t7 * t327;
    const double t330 = t12 * t327;
    const double t336 = (t110 * t318) + (t151 * t320) + (motion->constants[20] * t224) + (t198 *
        t330) - (motion->constants[19] * t204) - (t159 * t328);
    const double t338 = motion->constants[7] * sin_psi;
    const double t339 = speeds[1] * t338;
    const double t341 = t81 * t339;
    const double t343 = t84 * t339;
    const double t346 = speeds[0] * t338;
    const double t348 = (t105 * t339) + (t53 * t346);
    const double t353 = (t143 * t339) + (t148 * t346) - t341;
    const double t355 = sin_phi * t348;
    const double t361 = (motion->constants[23] * t341) + (t104 * t348) + (t120 * t353) +
        (motion->constants[27] * t355) - (t72 * t339) - (motion->constants[24] * t343);
    const double t373 = (motion->constants[24] * t341) + (motion->constants[23] * t343) + (t181 *
        t348) + (t191 * t353) - (t162 * t339) - (t48 * t355);
    const double t379 = (t7 * t353) + (t12 * t355);
    const double t381 = (t7 * t341) + t379 - (t12 * t343);
    const double t389 = (t12 * t341) + (t7 * t343) + (t12 * t353) - (t7 * t355);
    const double t391 = (motion->constants[20] * t381) + (motion->constants[19] * t389);
    const double t393 = (t161 * t373) + t391 - (t65 * t361);
    const double t399 = (t96 * t353) - (t28 * t348) - (t55 * t355);
    const double t406 = t391 + (t229 * t373) - (motion->constants[20] * t379) -
        (motion->constants[19] * t399) - (t227 * t361);
    const double t417 = (motion->constants[25] * t379) + (t242 * t399) + (motion->constants[23] *
        t381) + (t287 * t373) - (motion->constants[24] * t389) - (t284 * t361);
    const double t428 = (motion->constants[19] * t381) + (t311 * t373) - (t299 * sin_psi) - (t71 *
        t346) - (motion->constants[20] * t389) - (t309 * t361);
    const double t439 = (t318 * t348) + (t320 * t353) + (motion->constants[20] * t399) + (t330 *
        t373) - (motion->constants[19] * t379) - (t328 * t361);
    const double t443 = 1.0 / ((t51 * t123) + (t36 * t146));
    const double t444 = motion->constants[7] * t443;
    const double t445 = t118 * t444;
    const double t447 = t36 * t443;
    const double t454 = (t25 * motion->constants[10]) + (sin_phi * t125) + (cos_phi * t129) -
        (cos_phi * t135);
    const double t457 = (sin_phi * t454) + (cos_phi * t137);
    const double t459 = t123 * t443;
    const double t460 = cos_phi * t70;
    const double t464 = (t80 * t447) - (t7 * t459);
    const double t465 = motion->constants[10] * t464;
    const double t469 = (t13 * t70) - (t7 * t454);
    const double t470 = t443 * t469;
    const double t474 = (t80 * t454) + (t13 * t137);
    const double t475 = t443 * t474;
    const double t480 = (t447 * t457) + (t459 * t460) + (t93 * t465) + (t103 * t470) + (t118 *
        t475);
    const double t482 = sin_phi * t51;
    const double t484 = sin_phi * t146;
    const double t486 = (t123 * t482) + (t36 * t484);
    const double t487 = t443 * t486;
    const double t488 = speeds[1] * t487;
    const double t490 = t13 * t459;
    const double t493 = (speeds[1] * t490) + (t81 * t488);
    const double t495 = t13 * sin_phi;
    const double t497 = cos_phi * t464;
    const double t498 = (t447 * t495) - t497;
    const double t501 = (speeds[1] * t498) + (t84 * t488);
    const double t505 = (t51 * t103) + (t118 * t146);
    const double t506 = t36 * t444;
    const double t507 = t443 * t506;
    const double t514 = t443 * ((t123 * t469) + (t36 * t474) + (t141 * t486));
    const double t515 = t443 * t514;
    const double t517 = t147 * t487;
    const double t518 = t443 * t517;
    const double t521 = (speeds[2] * t507) + (speeds[1] * t515) + (speeds[0] * t518);
    const double t525 = (t103 * t482) + (t118 * t484);
    const double t526 = t141 * t443;
    const double t528 = t147 * t443;
    const double t530 = (speeds[1] * t526) + (speeds[0] * t528);
    const double t532 = t13 * t447;
    const double t535 = speeds[0] * t487;
    const double t538 = sin_phi * t36;
    const double t543 = (t36 * t521) - (speeds[1] * t532) - (t105 * t488) - (t53 * t535) - (t530 *
        t538);
    const double t548 = sin_phi * t123;
    const double t553 = (t143 * t488) + (t148 * t535) + (t123 * t521) - t493 - (t530 * t548);
    const double t557 = (speeds[1] * t497) + (sin_phi * t543);
    const double t563 = (motion->constants[23] * t493) + (t505 * t521) + (t120 * t553) -
        (speeds[2] * t445) - (speeds[1] * t480) - (t72 * t488);
    const double t567 = t563 - (motion->constants[24] * t501) - (t525 * t530) - (t104 * t543) -
        (motion->constants[27] * t557);
    const double t569 = t188 * t444;
    const double t577 = (t179 * t470) + (t188 * t475) - (t454 * t459) - (t172 * t465);
    const double t584 = (t51 * t179) + (t146 * t188);
    const double t588 = (t179 * t482) + (t188 * t484);
    const double t597 = (motion->constants[24] * t493) + (motion->constants[23] * t501) + (t521 *
        t584) + (t191 * t553) + (t48 * t557) - (speeds[2] * t569);
    const double t601 = t597 - (speeds[1] * t577) - (t162 * t488) - (t530 * t588) - (t181 * t543);
    const double t607 = (t7 * t553) - (t12 * t557);
    const double t609 = (t7 * t493) + t607 - (t12 * t501);
    const double t617 = (t12 * t493) + (t7 * t501) + (t12 * t553) + (t7 * t557);
    const double t619 = (motion->constants[20] * t609) + (motion->constants[19] * t617);
    const double t621 = (t161 * t601) + t619 - (t65 * t567);
    const double t623 = t20 * t464;
    const double t630 = (t28 * t543) + (t96 * t553) + (t55 * t557) - (speeds[1] * t623);
    const double t637 = t619 + (t229 * t601) - (motion->constants[20] * t607) -
        (motion->constants[19] * t630) - (t227 * t567);
    const double t648 = (motion->constants[25] * t607) + (t242 * t630) + (motion->constants[23] *
        t609) + (t287 * t601) - (motion->constants[24] * t617) - (t284 * t567);
    const double t652 = sin_phi * t538;
    const double t662 = (t521 * t538) + (motion->constants[19] * t609) + (t311 * t601) -
        (speeds[2] * t447) - (t71 * t535) - (t530 * t652);
    const double t664 = t662 - (motion->constants[20] * t617) - (t309 * t567);
    const double t665 = t25 * t464;
    const double t677 = (t320 * t553) + (motion->constants[20] * t630) + (t330 * t601) -
        (speeds[1] * t665) - (t318 * t543) - (motion->constants[19] * t607);
    const double t678 = t677 - (t328 * t567);
    const double t680 = speeds[1] * t81;
    const double t682 = speeds[1] * t84;
    const double t686 = (speeds[1] * t105) + (t53 * speeds[0]);
    const double t691 = t680 - (speeds[1] * t143) - (speeds[0] * t148);
    const double t693 = sin_phi * t686;
    const double t699 = (t72 * speeds[1]) + (motion->constants[24] * t682) + (t120 * t691) -
        (motion->constants[23] * t680) - (t104 * t686) - (motion->constants[27] * t693);
    const double t711 = (speeds[1] * t162) + (t191 * t691) + (t48 * t693) - (motion->constants[24] *
        t680) - (motion->constants[23] * t682) - (t181 * t686);
    const double t717 = (t7 * t691) - (t12 * t693);
    const double t719 = (t12 * t682) + t717 - (t7 * t680);
    const double t727 = (t12 * t691) + (t7 * t693) - (t12 * t680) - (t7 * t682);
    const double t729 = (motion->constants[20] * t719) + (motion->constants[19] * t727);
    const double t731 = (t161 * t711) + t729 - (t65 * t699);
    const double t737 = (t28 * t686) + (t96 * t691) + (t55 * t693);
    const double t744 = t729 + (t229 * t711) - (motion->constants[20] * t717) -
        (motion->constants[19] * t737) - (t227 * t699);
    const double t755 = (motion->constants[25] * t717) + (t242 * t737) + (motion->constants[23] *
        t719) + (t287 * t711) - (motion->constants[24] * t727) - (t284 * t699);
    const double t764 = (t71 * speeds[0]) + (motion->constants[19] * t719) + (t311 * t711) -
        (motion->constants[20] * t727) - (t309 * t699);
    const double t775 = (t320 * t691) + (motion->constants[20] * t737) + (t330 * t711) - (t318 *
        t686) - (motion->constants[19] * t717) - (t328 * t699);
    const double t776 = 1.0 / motion->constants[10];
    const double t777 = motion->constants[7] * t776;
    const double t778 = t103 * t777;
    const double t780 = speeds[1] * t776;
    const double t785 = (t7 * t36) + (t80 * t123);
    const double t786 = motion->constants[10] * t785;
    const double t793 = (t123 * t457) + (t93 * t786) + (t103 * t474) - (t36 * t460) - (t118 * t469);
    const double t797 = (t36 * t51) - (t123 * t146);
    const double t798 = t776 * t797;
    const double t799 = speeds[2] * t798;
    const double t801 = t780 * t797;
    const double t805 = (t36 * t482) - (t123 * t484);
    const double t808 = (t487 * t801) - (t780 * t805);
    const double t810 = t13 * t36;
    const double t815 = (t490 * t801) + (t81 * t808) - (t780 * t810);
    const double t818 = cos_phi * t785;
    const double t819 = (t123 * t495) - t818;
    const double t824 = (t780 * t819) + (t498 * t801) + (t84 * t808);
    const double t828 = (t51 * t118) - (t103 * t146);
    const double t829 = t506 * t776;
    const double t832 = t517 * t776;
    const double t835 = (speeds[2] * t829) + (t514 * t780) + (speeds[0] * t832);
    const double t839 = (t118 * t482) - (t103 * t484);
    const double t841 = t147 * t776;
    const double t843 = (t141 * t780) + (speeds[0] * t841);
    const double t847 = speeds[0] * t798;
    const double t850 = (t507 * t799) + (t515 * t801) + (t518 * t847);
    const double t854 = (t526 * t801) + (t528 * t847);
    const double t856 = t13 * t123;
    const double t860 = t776 * t805;
    const double t863 = (t487 * t847) - (speeds[0] * t860);
    const double t873 = (t780 * t856) + (t532 * t801) + (t105 * t808) + (t53 * t863) + (t548 *
        t843) + (t538 * t854);
    const double t875 = t873 - (t123 * t835) - (t36 * t850);
    const double t887 = t815 + (t36 * t835) + (t548 * t854) - (t143 * t808) - (t148 * t863) -
        (t538 * t843);
    const double t888 = t887 - (t123 * t850);
    const double t894 = (t780 * t818) + (t497 * t801) - (sin_phi * t875);
    const double t900 = (speeds[2] * t778) + (t780 * t793) + (t445 * t799) + (t480 * t801) + (t72 *
        t808) + (motion->constants[24] * t824);
    const double t905 = t900 + (t828 * t835) + (t525 * t854) + (t120 * t888) +
        (motion->constants[27] * t894) - (motion->constants[23] * t815);
    const double t908 = t905 - (t839 * t843) - (t505 * t850) - (t104 * t875);
    const double t910 = t179 * t777;
    const double t918 = (t36 * t454) + (t179 * t474) - (t172 * t786) - (t188 * t469);
    const double t927 = (t51 * t188) - (t146 * t179);
    const double t931 = (t188 * t482) - (t179 * t484);
    const double t942 = (speeds[2] * t910) + (t780 * t918) + (t569 * t799) + (t577 * t801) + (t162 *
        t808) + (t835 * t927);
    const double t947 = t942 + (t588 * t854) + (t191 * t888) - (motion->constants[24] * t815) -
        (motion->constants[23] * t824) - (t843 * t931);
    const double t950 = t947 - (t584 * t850) - (t181 * t875) - (t48 * t894);
    const double t956 = (t7 * t888) + (t12 * t894);
    const double t958 = (t12 * t824) + t956 - (t7 * t815);
    const double t966 = (t12 * t888) - (t12 * t815) - (t7 * t824) - (t7 * t894);
    const double t968 = (motion->constants[20] * t958) + (motion->constants[19] * t966);
    const double t970 = (t161 * t950) + t968 - (t65 * t908);
    const double t972 = t20 * t785;
    const double t981 = (t780 * t972) + (t623 * t801) + (t28 * t875) + (t96 * t888) - (t55 * t894);
    const double t988 = t968 + (t229 * t950) - (motion->constants[20] * t956) -
        (motion->constants[19] * t981) - (t227 * t908);
    const double t999 = (motion->constants[25] * t956) + (t242 * t981) + (motion->constants[23] *
        t958) + (t287 * t950) - (motion->constants[24] * t966) - (t284 * t908);
    const double t1000 = t123 * t776;
    const double t1005 = sin_phi * t548;
    const double t1017 = (speeds[2] * t1000) + (t447 * t799) + (t71 * t863) + (t843 * t1005) +
        (t652 * t854) + (motion->constants[19] * t958);
    const double t1022 = t1017 + (t311 * t950) - (t548 * t835) - (t538 * t850) -
        (motion->constants[20] * t966) - (t309 * t908);
    const double t1030 = t776 * ((t123 * t474) + (t514 * t797) - (t36 * t469) - (t141 * t805));
    const double t1031 = t776 * t1030;
    const double t1032 = speeds[1] * t1031;
    const double t1036 = t776 * ((motion->constants[7] * t123) + (t506 * t797));
    const double t1037 = t776 * t1036;
    const double t1039 = t25 * t785;
    const double t1044 = t776 * ((t517 * t797) - (t147 * t805));
    const double t1045 = t776 * t1044;
    const double t1058 = (t780 * t1039) + (t665 * t801) + (t320 * t888) + (motion->constants[20] *
        t981) + (t330 * t950) - t1032;
    const double t1063 = t1058 - (speeds[2] * t1037) - (speeds[0] * t1045) - (t318 * t875) -
        (motion->constants[19] * t956) - (t328 * t908);
    const double t1067 = sin_delta * motion->constants[41];
    const double t1068 = sin_delta * t1067;
    const double t1072 = motion->constants[32] + motion->constants[36] + motion->constants[43] -
        t1068;
    const double t1074 = cos_delta * motion->constants[34];
    const double t1075 = motion->constants[23] * t1074;
    const double t1078 = t1075 + t1075 + motion->constants[46];
    const double t1081 = motion->constants[33] + motion->constants[39];
    const double t1082 = t1078 + t1081;
    const double t1083 = t1082 - t1072;
    const double t1084 = t7 * t7;
    const double t1086 = t7 * t12;
    const double t1088 = motion->constants[24] * t1074;
    const double t1092 = cos_delta * motion->constants[37];
    const double t1093 = motion->constants[30] + t1092;
    const double t1096 = t1093 - motion->constants[44] - t1088 - motion->constants[45];
    const double t1097 = t1096 + t1096;
    const double t1099 = (t1083 * t1084) + (t1086 * t1097);
    const double t1104 = t1074 + motion->constants[42];
    const double t1105 = motion->constants[28] + t1104;
    const double t1107 = (t12 * motion->constants[47]) - (t7 * t1105);
    const double t1108 = motion->constants[7] * t1107;
    const double t1111 = motion->constants[49] - t1108 - t1108;
    const double t1112 = sin_delta * motion->constants[37];
    const double t1113 = sin_delta * motion->constants[34];
    const double t1115 = t1112 - (motion->constants[24] * t1113);
    const double t1119 = (cos_delta * t1067) - (motion->constants[23] * t1113);
    const double t1121 = (t7 * t1115) + (t12 * t1119);
    const double t1123 = t147 - (sin_phi * t517);
    const double t1133 = t1096 + (t1083 * t1086) + (motion->constants[7] * ((t7 *
        motion->constants[47]) + (t12 * t1105))) - (t1084 * t1097);
    const double t1134 = cos_phi * t517;
    const double t1142 = t1068 + motion->constants[43] + t1078 + t1111 + motion->constants[31] +
        motion->constants[38];
    const double t1146 = motion->constants[7] * t1113;
    const double t1148 = (t12 * t1115) + t1146 - (t7 * t1119);
    const double t1154 = t1082 - t1099;
    const double t1160 = t1123 * motion->constants[21];
    const double t1164 = t7 * sin_delta;
    const double t1168 = t1044 + (cos_delta * t1123) - (t12 * sin_delta) - (t1134 * t1164);
    const double t1170 = t1168 * motion->constants[22];
    const double t1176 = t1072 + t1099 + t1111 + (t1121 * t1123) + (t1123 * (t1121 + (t1123 *
        t1142) - (t1134 * t1148))) + (t1123 * t1160);
    const double t1179 = t1176 + (t1168 * t1170) - (t1133 * t1134) - (t1134 * (t1133 + (t1123 *
        t1148) - (t1134 * t1154)));
    const double t1180 = 1.0 / t1179;
    const double t1185 = (speeds[0] * t517) + (speeds[1] * t514) + (speeds[2] * t506);
    const double t1186 = sin_phi * t1185;
    const double t1187 = t298 - t1186;
    const double t1188 = t12 * speeds[0];
    const double t1189 = cos_phi * t1185;
    const double t1191 = t1188 + (t7 * t1189);
    const double t1192 = motion->constants[30] * t1191;
    const double t1194 = t7 * speeds[0];
    const double t1195 = t1194 - (t12 * t1189);
    const double t1197 = t1192 + (motion->constants[33] * t1195);
    const double t1200 = speeds[2] + t1187;
    const double t1202 = (motion->constants[31] * t1187) + (motion->constants[21] * t1200);
    const double t1204 = (t1187 * t1197) - (t1195 * t1202);
    const double t1206 = motion->constants[7] * t1186;
    const double t1207 = t1189 * t1206;
    const double t1209 = sin_phi * motion->constants[40];
    const double t1210 = t299 * t1189;
    const double t1213 = t1207 - (motion->constants[7] * t1210);
    const double t1214 = t1209 + t1213;
    const double t1216 = t298 * t1195;
    const double t1217 = speeds[0] * t1186;
    const double t1218 = motion->constants[24] * t1187;
    const double t1220 = motion->constants[23] * t1187;
    const double t1222 = (t1195 * t1218) + (t1191 * t1220);
    const double t1224 = t298 * t1191;
    const double t1225 = (t12 * t1217) + t1224;
    const double t1228 = t1216 + (t7 * t1217);
    const double t1232 = t1222 + (motion->constants[23] * t1225) + (motion->constants[24] * t1228) -
        t1213;
    const double t1235 = motion->constants[23] * t1195;
    const double t1236 = motion->constants[24] * t1191;
    const double t1237 = t1235 - t1236;
    const double t1239 = (t1187 * t1220) + (t1195 * t1237);
    const double t1240 = speeds[0] * t1189;
    const double t1243 = motion->constants[7] * speeds[0];
    const double t1244 = t1189 * t1243;
    const double t1245 = (motion->constants[7] * t1240) + t1244;
    const double t1248 = t299 - t1186;
    const double t1250 = (t1206 * t1248) - (speeds[0] * t1243);
    const double t1254 = (t12 * t1245) + (t7 * t1250) - t1239 - (motion->constants[24] * t1240);
    const double t1256 = speeds[1] + t1195;
    const double t1260 = (cos_delta * t1187) - (sin_delta * t1191);
    const double t1261 = motion->constants[26] * t1260;
    const double t1265 = (cos_delta * t1191) + (sin_delta * t1187);
    const double t1266 = motion->constants[25] * t1260;
    const double t1271 = speeds[1] * t1260;
    const double t1273 = t1271 - (cos_delta * t1228) - (sin_delta * t1240);
    const double t1275 = t30 * motion->constants[10];
    const double t1280 = (speeds[0] * t1044) + (speeds[1] * t1030) + (speeds[2] * t1036);
    const double t1282 = t1225 + (t1265 * t1280);
    const double t1284 = t27 * motion->constants[10];
    const double t1286 = t1273 - (t1256 * t1280);
    const double t1288 = t26 * t40;
    const double t1291 = (t30 * t1265) + (t27 * t1256);
    const double t1292 = t1288 * t1291;
    const double t1293 = t27 * t1292;
    const double t1294 = motion->constants[10] * t1293;
    const double t1296 = t30 * t1292;
    const double t1297 = motion->constants[10] * t1296;
    const double t1303 = (cos_delta * t1232) + (t1256 * t1261) + (t1265 * t1266) +
        (motion->constants[25] * t1225) + (t1275 * t1282) + (t1256 * t1294);
    const double t1307 = t1303 + (t1265 * t1297) - (sin_delta * t1254) - (motion->constants[26] *
        t1273) - (t1284 * t1286);
    const double t1312 = motion->constants[25] * t1256;
    const double t1313 = motion->constants[26] * t1265;
    const double t1314 = t1312 - t1313;
    const double t1318 = speeds[1] * t1265;
    const double t1320 = (sin_delta * t1228) - (cos_delta * t1240) - t1318;
    const double t1323 = t1260 + t1280;
    const double t1327 = (t30 * t1256) - (t27 * t1265);
    const double t1328 = motion->constants[10] * t1327;
    const double t1334 = (cos_delta * t1254) + (sin_delta * t1232) + (motion->constants[26] *
        t1320) + (t1284 * t1320) - (t1260 * t1266) - (t1256 * t1314);
    const double t1336 = t1334 - (t1297 * t1323) - (t1256 * t1328);
    const double t1340 = (t1191 * t1237) - (t1187 * t1218);
    const double t1354 = t1340 + (motion->constants[23] * t1240) + (t7 * t1245) + (t1265 * t1314) +
        (t1265 * t1328) - (t12 * t1250);
    const double t1358 = t1354 - (t1260 * t1261) - (motion->constants[25] * t1320) - (t1275 *
        t1320) - (t1294 * t1323);
    const double t1360 = (t30 * t1336) + (t27 * t1358);
    const double t1365 = t53 * ((t40 * t1307) + (t25 * t1360));
    const double t1369 = t443 * ((t25 * t1307) + (t486 * t1365) - (t40 * t1360));
    const double t1371 = t1217 - (cos_phi * t1369);
    const double t1373 = t1216 + (t7 * t1371);
    const double t1376 = t1224 + (t12 * t1371);
    const double t1380 = motion->constants[30] * t1195;
    const double t1381 = (motion->constants[32] * t1191) + t1380;
    const double t1383 = (t1191 * t1202) - (t1187 * t1381);
    const double t1388 = t1222 + (motion->constants[23] * t1376) + (motion->constants[24] * t1373) -
        t1214;
    const double t1391 = t1240 - t1365;
    const double t1392 = (sin_phi * t1369) + t1391;
    const double t1395 = (motion->constants[7] * t1392) + t1244;
    const double t1398 = t1250 + (cos_phi * motion->constants[40]);
    const double t1399 = t7 * t1398;
    const double t1400 = t1399 + (t12 * t1395);
    const double t1402 = t1400 - (motion->constants[24] * t1392) - t1239;
    const double t1404 = (cos_delta * t1388) - (sin_delta * t1402);
    const double t1409 = t1271 - (sin_delta * t1392) - (cos_delta * t1373);
    const double t1414 = (motion->constants[38] * t1260) + (motion->constants[22] * t1323);
    const double t1417 = motion->constants[37] * t1256;
    const double t1418 = (motion->constants[36] * t1265) + t1417;
    const double t1420 = (t1265 * t1414) - (t1260 * t1418);
    const double t1423 = (motion->constants[34] * t1404) + (motion->constants[37] * t1409) +
        (motion->constants[39] * t1376) + t1420;
    const double t1427 = (cos_delta * t1402) + (sin_delta * t1388);
    const double t1433 = (sin_delta * t1373) - (cos_delta * t1392) - t1318;
    const double t1435 = motion->constants[34] * t1260;
    const double t1437 = motion->constants[34] * t1256;
    const double t1438 = t1265 * motion->constants[35];
    const double t1439 = t1437 - t1438;
    const double t1441 = (t1260 * t1435) + (t1256 * t1439);
    const double t1443 = (motion->constants[17] * t1427) + (motion->constants[35] * t1433) - t1441;
    const double t1448 = t1260 * motion->constants[35];
    const double t1451 = (t1256 * t1448) + (t1265 * t1435);
    const double t1454 = (t1404 * motion->constants[17]) + (motion->constants[34] * t1376) + t1451 -
        (t1409 * motion->constants[35]);
    const double t1456 = (sin_delta * t1443) + (cos_delta * t1454);
    const double t1462 = (motion->constants[33] * t1376) + t1383 + t1423 + (motion->constants[23] *
        t1456) - (motion->constants[28] * t1214) - (motion->constants[30] * t1373);
    const double t1470 = motion->constants[37] * t1265;
    const double t1472 = t1470 + (motion->constants[39] * t1256);
    const double t1475 = (t1260 * t1472) - (t1256 * t1414);
    const double t1478 = (motion->constants[36] * t1409) + (motion->constants[37] * t1376) + t1475 -
        (t1404 * motion->constants[35]);
    const double t1482 = t12 * t1398;
    const double t1484 = t1482 - (t7 * t1395);
    const double t1486 = t1340 + (motion->constants[23] * t1392) - t1484;
    const double t1496 = t776 * ((t30 * t1358) + (t797 * t1369) - (t27 * t1336) - (t805 * t1365));
    const double t1498 = motion->constants[22] * (t1433 + t1496);
    const double t1501 = (t1256 * t1418) - (t1265 * t1472);
    const double t1505 = (t1427 * motion->constants[35]) + (motion->constants[38] * t1433) + t1498 +
        t1501 - (motion->constants[34] * t1486);
    const double t1512 = t1204 + (motion->constants[29] * t1214) + (motion->constants[30] * t1376) +
        (cos_delta * t1478) - (motion->constants[32] * t1373) - (sin_delta * t1505);
    const double t1513 = t1512 - (motion->constants[24] * t1456);
    const double t1519 = t1187 * motion->constants[29];
    const double t1521 = motion->constants[28] * t1187;
    const double t1523 = (t1195 * t1519) + (t1191 * t1521);
    const double t1528 = motion->constants[7] * (t1456 + (motion->constants[28] * t1376) +
        (motion->constants[29] * t1373) + t1523 - (t1214 * motion->constants[1]));
    const double t1534 = (t1195 * t1381) - (t1191 * t1197);
    const double t1539 = (cos_delta * t1443) - (sin_delta * t1454);
    const double t1545 = (t1265 * t1439) - (t1260 * t1448);
    const double t1547 = (motion->constants[17] * t1486) + t1545 - (motion->constants[34] * t1433);
    const double t1552 = motion->constants[28] * t1195;
    const double t1553 = t1191 * motion->constants[29];
    const double t1554 = t1552 - t1553;
    const double t1557 = (t1191 * t1554) - (t1187 * t1519);
    const double t1566 = (t1187 * t1521) + (t1195 * t1554);
    const double t1571 = (t7 * (t1547 + t1557 - (t1484 * motion->constants[1]) +
        (motion->constants[28] * t1392))) + (t12 * (t1539 + (t1400 * motion->constants[1]) -
        (motion->constants[29] * t1392) - t1566));
    const double t1573 = (motion->constants[21] * t1392) + (motion->constants[7] * t1571);
    const double t1578 = (motion->constants[29] * t1400) + (motion->constants[28] * t1484) -
        (motion->constants[31] * t1392) + t1534 + (sin_delta * t1478) + (cos_delta * t1505);
    const double t1581 = t1578 + (motion->constants[24] * t1539) - t1573 - (motion->constants[23] *
        t1547);
    const double t1585 = (t12 * t1462) - (t7 * t1513);
    const double t1592 = forces[0] + (t1134 * t1585) - (t7 * t1462) - (t12 * t1513) - t1528 -
        (t1123 * t1581);
    const double t1593 = t1592 - (t1044 * t1498);
    const double t1595 = t1075 + motion->constants[39];
    const double t1597 = t1092 - t1088;
    const double t1601 = t141 - (sin_phi * t514);
    const double t1603 = cos_phi * t514;
    const double t1605 = t12 * t1113;
    const double t1606 = motion->constants[7] * t1605;
    const double t1607 = t1115 + t1606;
    const double t1611 = t1607 + (t1142 * t1601) - (t1148 * t1603);
    const double t1615 = (t12 * t1595) - (t7 * t1597);
    const double t1619 = t1615 + (t1148 * t1601) - (t1154 * t1603);
    const double t1625 = (t1164 * t1603) - t1030 - (cos_delta * t1601);
    const double t1631 = (t7 * t1595) + (t12 * t1597) + (motion->constants[7] * t1074) + (t1121 *
        t1601) + (t1123 * t1611) + (t1160 * t1601);
    const double t1635 = t1180 * (t1631 - (t1133 * t1603) - (t1134 * t1619) - (t1170 * t1625));
    const double t1640 = motion->constants[21] * t1601;
    const double t1642 = motion->constants[22] * t1625;
    const double t1644 = t1179 * t1635;
    const double t1650 = motion->constants[39] + (t1601 * t1611) + (t1601 * t1607) + (t1601 *
        t1640) + (t1625 * t1642) - (t1603 * t1619);
    const double t1652 = t1650 - (t1603 * t1615) - (t1635 * t1644);
    const double t1653 = 1.0 / t1652;
    const double t1663 = forces[1] + (t1585 * t1603) - t1423 - (t1581 * t1601) - (t1030 * t1498) -
        (t1593 * t1635);
    const double t1667 = motion->constants[7] * (t1107 - motion->constants[48]);
    const double t1668 = sin_phi * t506;
    const double t1670 = cos_phi * t506;
    const double t1673 = t1667 + (t1142 * t1668) + (t1148 * t1670);
    const double t1678 = t1146 - (t1148 * t1668) - (t1154 * t1670);
    const double t1683 = 1.0 - t1668;
    const double t1688 = (t1164 * t1670) + (cos_delta * t1668) - t1036;
    const double t1700 = (t1160 * t1683) - (t1121 * t1668) - (t1133 * t1670) - (t1123 * t1673) -
        (t1134 * t1678) - (t1170 * t1688);
    const double t1701 = t1180 * t1700;
    const double t1707 = t1606 + (t1640 * t1683) + (t1642 * t1688) - (t1601 * t1673) - (t1603 *
        t1678) - (t1607 * t1668);
    const double t1710 = t1653 * (t1707 - (t1615 * t1670) - (t1644 * t1701));
    const double t1720 = (t1581 * t1668) + (t1585 * t1670) + t1573 - (t1036 * t1498) - (t1593 *
        t1701) - (t1663 * t1710);
    const double t1728 = motion->constants[22] * t1688;
    const double t1738 = (t1668 * t1673) + (t1667 * t1668) + motion->constants[50] +
        (motion->constants[21] * t1683 * t1683) + (t1688 * t1728) - (t1670 * t1678);
    const double t1742 = 1.0 / (t1738 - (t1146 * t1670) - (t1179 * t1701 * t1701) - (t1652 * t1710 *
        t1710));
    const double t1743 = t1720 * t1742;
    const double t1745 = (t1653 * t1663) - (t1710 * t1743);
    const double t1749 = (t1180 * t1593) - (t1635 * t1745) - (t1701 * t1743);
    const double t1750 = t1210 + t1749;
    const double t1753 = t1207 + t1209 - (motion->constants[7] * t1750);
    const double t1761 = t1369 + (t517 * t1749) + (t514 * t1745) + (t506 * t1743);
    const double t1763 = t1217 - (cos_phi * t1761);
    const double t1766 = (t12 * t1749) - t1216 - (t7 * t1763);
    const double t1771 = t1224 + (t12 * t1763) + (t7 * t1749);
    const double t1777 = t1222 + (motion->constants[23] * t1771) - t1753 - (motion->constants[24] *
        t1766);
    const double t1784 = (t147 * t1749) + (t141 * t1745) - (sin_phi * t1761) - t1391;
    const double t1786 = t1743 + t1784;
    const double t1788 = (motion->constants[7] * t1786) - t1244;
    const double t1790 = t1399 - (t12 * t1788);
    const double t1792 = (motion->constants[24] * t1784) + t1790 - t1239;
    const double t1794 = (cos_delta * t1777) - (sin_delta * t1792);
    const double t1799 = t1271 + (cos_delta * t1766) + (sin_delta * t1784);
    const double t1801 = t1745 + t1771;
    const double t1805 = t1475 + (motion->constants[36] * t1799) + (motion->constants[37] * t1801) -
        (motion->constants[35] * t1794);
    const double t1809 = (cos_delta * t1792) + (sin_delta * t1777);
    const double t1813 = t1482 + (t7 * t1788);
    const double t1815 = t1340 - (motion->constants[23] * t1784) - t1813;
    const double t1820 = (cos_delta * t1784) - t1318 - (sin_delta * t1766);
    const double t1828 = t1496 + t1820 + (t1044 * t1749) + (t1030 * t1745) + (t1036 * t1743);
    const double t1829 = motion->constants[22] * t1828;
    const double t1833 = t1501 + (motion->constants[35] * t1809) + (motion->constants[38] * t1820) +
        t1829 - (motion->constants[34] * t1815);
    const double t1838 = (motion->constants[17] * t1809) + (motion->constants[35] * t1820) - t1441;
    const double t1845 = t1451 + (motion->constants[17] * t1794) + (motion->constants[34] * t1801) -
        (motion->constants[35] * t1799);
    const double t1847 = (sin_delta * t1838) + (cos_delta * t1845);
    const double t1853 = t1204 + (motion->constants[29] * t1753) + (motion->constants[32] * t1766) +
        (motion->constants[30] * t1771) + (cos_delta * t1805) - (sin_delta * t1833);
    const double t1854 = t1853 - (motion->constants[24] * t1847);
    const double t1859 = (cos_delta * t1838) - (sin_delta * t1845);
    const double t1862 = (motion->constants[1] * t1790) + (motion->constants[29] * t1784) + t1859 -
        t1566;
    const double t1863 = motion->constants[7] * t1862;
    const double t1877 = t1383 + t1420 + (motion->constants[30] * t1766) + (motion->constants[33] *
        t1771) + (motion->constants[34] * t1794) + (motion->constants[37] * t1799) +
        (motion->constants[39] * t1801);
    const double t1879 = t1877 + (motion->constants[23] * t1847) - (motion->constants[28] * t1753);
    const double t1881 = t776 * motion->constants[22];
    const double t1882 = t1358 * t1881;
    const double t1884 = t1336 * t1881;
    const double t1886 = t797 * t1881;
    const double t1887 = t443 * t1307;
    const double t1889 = t40 * t443;
    const double t1890 = t1336 * t1889;
    const double t1892 = t1358 * t1889;
    const double t1895 = (t93 * t1887) + (t94 * t1890) - (t100 * t1892);
    const double t1898 = (t1886 * t1895) - (t94 * t1882) - (t100 * t1884);
    const double t1900 = t12 * motion->constants[7];
    const double t1901 = motion->constants[1] * t1900;
    const double t1902 = motion->constants[29] - t1901;
    const double t1904 = t7 * t1113;
    const double t1905 = cos_delta * motion->constants[35];
    const double t1907 = sin_delta * motion->constants[35];
    const double t1909 = (cos_delta * t1907) - (sin_delta * t1905);
    const double t1913 = (sin_delta * t1907) + (cos_delta * t1905);
    const double t1916 = t1605 + (t7 * t1909);
    const double t1918 = sin_delta * motion->constants[17];
    const double t1920 = cos_delta * motion->constants[23];
    const double t1922 = cos_delta * motion->constants[24];
    const double t1924 = sin_delta * motion->constants[24];
    const double t1925 = sin_delta * t1900;
    const double t1926 = t1925 - t1924;
    const double t1930 = (t12 * t1920) + (t7 * t1922);
    const double t1935 = (t12 * t1922) + (t1134 * t1930) - (cos_delta * motion->constants[7]) -
        (t7 * t1920) - (t1123 * t1926);
    const double t1937 = cos_delta * motion->constants[17];
    const double t1939 = sin_delta * motion->constants[23];
    const double t1942 = cos_delta * t1900;
    const double t1943 = t1922 - t1942;
    const double t1947 = (t12 * t1939) + (t7 * t1924);
    const double t1952 = (t12 * t1924) + (t1134 * t1947) - (sin_delta * motion->constants[7]) -
        (t7 * t1939) - (t1123 * t1943);
    const double t1958 = t1904 + (t1937 * t1952) - (t12 * t1909) - (t1123 * t1913) - (t1134 *
        t1916) - (t1918 * t1935);
    const double t1959 = t1958 - (t1123 * t1902);
    const double t1961 = t7 * motion->constants[7];
    const double t1963 = motion->constants[17] * t1961;
    const double t1964 = (motion->constants[1] * t1961) + t1963;
    const double t1965 = t1964 + t1105;
    const double t1968 = t1605 + (t1134 * t1904);
    const double t1969 = t1968 - (t1123 * t1965);
    const double t1977 = (t12 * t1081) - (t7 * t1093);
    const double t1985 = (t12 * t1074) + (t7 * t1913);
    const double t1993 = (t12 * t1913) + (t1134 * t1985) + (t1935 * t1937) + (t1918 * t1952) - (t7 *
        t1074) - (t1123 * t1909);
    const double t1999 = (t1134 * t1977) + (motion->constants[34] * t1935) +
        (motion->constants[23] * t1993) - (motion->constants[7] * motion->constants[28]) - (t7 *
        t1081) - (t12 * t1093);
    const double t2000 = t1999 - (t1112 * t1123);
    const double t2007 = (t12 * motion->constants[30]) - (t7 * motion->constants[32]);
    const double t2010 = sin_delta * motion->constants[38];
    const double t2012 = motion->constants[23] * motion->constants[34];
    const double t2013 = motion->constants[34] * t1961;
    const double t2016 = t2012 + t2013 + (cos_delta * motion->constants[38]);
    const double t2018 = t7 * t2010;
    const double t2024 = (t12 * t2010) + (t1134 * t2018) + (motion->constants[35] * t1952) - t1170 -
        (t1123 * t2016);
    const double t2027 = cos_delta * motion->constants[36];
    const double t2029 = sin_delta * motion->constants[36];
    const double t2033 = (t12 * motion->constants[37]) - (t7 * t2027);
    const double t2039 = (t1134 * t2033) - (t7 * motion->constants[37]) - (t12 * t2027) - (t1123 *
        t2029) - (motion->constants[35] * t1935);
    const double t2045 = (motion->constants[7] * motion->constants[29]) + (t1134 * t2007) +
        (cos_delta * t2039) - (t7 * motion->constants[30]) - (t12 * motion->constants[32]) -
        (motion->constants[24] * t1993);
    const double t2046 = t2045 - (sin_delta * t2024);
    const double t2048 = t7 * t145;
    const double t2050 = t12 * t145;
    const double t2053 = sin_delta * t2012;
    const double t2055 = motion->constants[31] + motion->constants[21];
    const double t2060 = (motion->constants[29] * t1900) - (motion->constants[28] * t1961) -
        (motion->constants[42] * t1961);
    const double t2064 = motion->constants[46] + t2055 + (cos_delta * t2012) - t2060;
    const double t2066 = t7 * t2053;
    const double t2075 = (t12 * t2053) + (t1134 * t2066) + (motion->constants[24] * t1958) +
        (cos_delta * t2024) + (sin_delta * t2039) - (t1123 * t2064);
    const double t2081 = (t1959 * t2050) + (t16 * t2046) - (t1969 * t2048) - (t13 * t2000) -
        (sin_phi * t2075);
    const double t2083 = t53 * t1360;
    const double t2085 = t25 * t53;
    const double t2086 = t1336 * t2085;
    const double t2088 = t1358 * t2085;
    const double t2091 = (t93 * t2083) + (t100 * t2088) - (t94 * t2086);
    const double t2095 = (t487 * t1886) - (t805 * t1881);
    const double t2102 = t2075 + (t1961 * t1969) + (t487 * t2081) - (t1168 * t2095) - (t1900 *
        t1959);
    const double t2104 = motion->constants[10] * t1320;
    const double t2105 = motion->constants[10] * t1256;
    const double t2107 = (t1265 * t2105) - t2104;
    const double t2109 = motion->constants[10] * t1292;
    const double t2110 = t1323 * t2109;
    const double t2111 = motion->constants[10] * t1265;
    const double t2113 = t2110 + (t1265 * t2111);
    const double t2116 = t1250 + (t94 * t2107) + (t100 * t2113);
    const double t2118 = t27 * t1889;
    const double t2120 = (t30 * t1881) - (t1886 * t2118);
    const double t2123 = t27 * t2085;
    const double t2126 = (t2102 * t2123) - (t1168 * t2120) - (t2081 * t2118);
    const double t2128 = motion->constants[25] + t1275;
    const double t2131 = motion->constants[23] * t1217;
    const double t2135 = (motion->constants[10] * t1282) + (t1265 * t2109);
    const double t2139 = (t1256 * t2109) - (motion->constants[10] * t1286);
    const double t2144 = (t1217 * t2128) + (cos_delta * t2131) + (t100 * t2139) - (sin_delta *
        t1245) - (t94 * t2135);
    const double t2145 = t25 * t443;
    const double t2146 = t1886 * t2145;
    const double t2149 = t40 * t53;
    const double t2152 = (t2081 * t2145) + (t2102 * t2149) - (t1168 * t2146);
    const double t2157 = t2110 + (t1256 * t2105);
    const double t2160 = t2104 + (t1256 * t2111);
    const double t2164 = (cos_delta * t1245) + (sin_delta * t2131) + (t94 * t2157) + (t100 * t2160);
    const double t2166 = t30 * t1889;
    const double t2168 = (t27 * t1881) + (t1886 * t2166);
    const double t2171 = t30 * t2085;
    const double t2174 = (t1168 * t2168) + (t2102 * t2171) - (t2081 * t2166);
    const double t2176 = t26 * t1291;
    const double t2177 = t1288 * t2176;
    const double t2179 = t1265 * t1288;
    const double t2181 = t1256 * t1288;
    const double t2184 = (t100 * t2181) - (t93 * t2177) - (t94 * t2179);
    const double t2185 = t1284 * t1323;
    const double t2187 = t1256 * t1284;
    const double t2188 = t1265 * t1275;
    const double t2189 = t2187 + t2188;
    const double t2190 = t2152 * t2189;
    const double t2191 = t1275 * t1323;
    const double t2194 = t2190 - (t2126 * t2185) - (t2174 * t2191);
    const double t2198 = motion->constants[38] + motion->constants[22];
    const double t2200 = (t1265 * t2198) - t1418;
    const double t2203 = t1414 - (motion->constants[36] * t1260);
    const double t2205 = (cos_delta * t2203) - (sin_delta * t2200);
    const double t2207 = t1202 + t2205 - (motion->constants[32] * t1187);
    const double t2209 = motion->constants[30] * t1187;
    const double t2210 = motion->constants[37] * t1260;
    const double t2213 = t1472 - (t1256 * t2198);
    const double t2215 = (cos_delta * t2210) - (sin_delta * t2213);
    const double t2219 = (motion->constants[36] * t1256) - t1470 - t1472;
    const double t2220 = cos_delta * t2219;
    const double t2223 = t2209 + (cos_delta * t2215) - (sin_delta * t2220);
    const double t2226 = t1195 * motion->constants[29];
    const double t2230 = t1448 + t1448;
    const double t2232 = t1439 - t1438;
    const double t2234 = (sin_delta * t2230) + (cos_delta * t2232);
    const double t2237 = (t1900 * t2226) + (t1961 * (t1554 - t1553)) + (t1961 * t2234);
    const double t2245 = (motion->constants[32] * t1195) + (sin_delta * t2215) + (cos_delta *
        t2220) - t1192 - t1197 - t2237;
    const double t2246 = t2245 - (motion->constants[23] * t2234);
    const double t2250 = (t12 * t2207) - (t7 * t2223);
    const double t2252 = t1256 * motion->constants[35];
    const double t2253 = motion->constants[34] * t1265;
    const double t2254 = t2252 + t2253;
    const double t2257 = (cos_delta * t1435) - (sin_delta * t2254);
    const double t2260 = t1435 + t1435;
    const double t2262 = (cos_delta * t2252) + (sin_delta * t2260);
    const double t2265 = motion->constants[24] * t1195;
    const double t2267 = cos_delta * speeds[1];
    const double t2269 = sin_delta * speeds[1];
    const double t2272 = t1261 + t1294;
    const double t2273 = t1261 + t2272;
    const double t2277 = t1314 + t1328;
    const double t2280 = (speeds[1] * t2128) + t2277 - t1313 - (t1265 * t1284);
    const double t2282 = (sin_delta * t2273) + (cos_delta * t2280);
    const double t2287 = t1220 + (motion->constants[23] * t298);
    const double t2289 = t1256 * motion->constants[26];
    const double t2290 = motion->constants[25] * t1265;
    const double t2295 = t2289 + t2290 - (speeds[1] * motion->constants[26]) - (speeds[1] * t1284);
    const double t2298 = t1266 + t1297;
    const double t2299 = (t1275 * t1280) + t2298;
    const double t2304 = (t298 * t2128) + (cos_delta * t2287) + (cos_delta * t2299) - (sin_delta *
        t2265) - (sin_delta * t2295);
    const double t2308 = t1266 + t2298;
    const double t2310 = motion->constants[26] + t1284;
    const double t2313 = t2187 + t2289 - (speeds[1] * t2310);
    const double t2317 = (cos_delta * t2265) + (sin_delta * t2287) + (sin_delta * t2308) +
        (cos_delta * t2313);
    const double t2319 = t30 * t1288;
    const double t2320 = cos_delta * t2319;
    const double t2322 = t1237 - t1236;
    const double t2323 = t1104 + t1963;
    const double t2326 = t2126 + (t1123 * t2323) - t1968;
    const double t2332 = (t1134 * t2250) + (t1935 * t2257) + (t1952 * t2262) + (t1220 * t1993) +
        (t1958 * t2265) + (t298 * t2000);
    const double t2337 = t2332 + (t2126 * t2282) + (t2152 * t2304) + (t2174 * t2317) + (t2194 *
        t2320) + (t2322 * t2326);
    const double t2342 = t2337 - (motion->constants[7] * t1521) - (t7 * t2207) - (t12 * t2223) -
        (t1123 * t2246) - (t2024 * t2267);
    const double t2343 = t2342 - (t2039 * t2269);
    const double t2346 = t2209 + t2210;
    const double t2350 = (motion->constants[39] * t1260) - t1414;
    const double t2354 = t1417 + t1418 - (motion->constants[39] * t1265);
    const double t2358 = (motion->constants[33] * t1187) + (cos_delta * t2350) - t1202 -
        (sin_delta * t2354);
    const double t2366 = motion->constants[28] * t1191;
    const double t2370 = (t1961 * t2366) + (t1961 * t2253) - (t1900 * (t1552 + t1554));
    const double t2376 = t1380 + t1381 + (sin_delta * t2350) + (cos_delta * t2354) -
        (motion->constants[33] * t1191) - (motion->constants[23] * t2253) - t2370;
    const double t2380 = (t12 * t2346) + (t7 * t2358);
    const double t2383 = t1437 + t1439;
    const double t2386 = t1235 + t1237;
    const double t2389 = t2188 + t2290;
    const double t2396 = t2272 + (cos_delta * t1218) + (t1280 * t1284) + (sin_delta * t2386);
    const double t2404 = (sin_delta * t1218) - t1312 - t2277 - (cos_delta * t2386) - (t1256 *
        t1275);
    const double t2406 = t27 * t1288;
    const double t2408 = motion->constants[23] * t1191;
    const double t2410 = sin_delta * t2128;
    const double t2415 = t1922 + (cos_delta * motion->constants[26]) + (cos_delta * t1284);
    const double t2418 = t1924 + (sin_delta * t2310);
    const double t2421 = (t2152 * t2415) + (t2174 * t2418) - (t2126 * t2410);
    const double t2427 = (t7 * t2346) + (t1448 * t1935) + (t1218 * t1993) + (t2126 * t2389) +
        (t2152 * t2396) + (t2174 * t2404);
    const double t2432 = t2427 + (t2194 * t2406) + (t2326 * t2408) + (t298 * t2421) -
        (motion->constants[7] * t1519) - (t12 * t2358);
    const double t2437 = t2432 - (t1123 * t2376) - (t1134 * t2380) - (t1952 * t2383) - (t1958 *
        t2386) - (t298 * t2046);
    const double t2439 = motion->constants[22] * t1743;
    const double t2441 = motion->constants[22] * t1265;
    const double t2443 = motion->constants[22] * t1256;
    const double t2444 = cos_delta * t2443;
    const double t2446 = sin_delta * t2443;
    const double t2450 = (t12 * t2441) + (t7 * t2444);
    const double t2458 = t2190 + (t12 * t2444) + (t1123 * t2446) + (t1134 * t2450) - (t7 * t2441) -
        (t1294 * t2126);
    const double t2459 = t2458 - (t1297 * t2174);
    const double t2461 = (speeds[2] * t2459) - (t1168 * t2439);
    const double t2463 = motion->constants[22] * t1745;
    const double t2464 = t776 * t2463;
    const double t2467 = (t780 * t2459) - (t1168 * t2464);
    const double t2471 = cos_phi * (t1243 + t1243);
    const double t2472 = t12 * t2471;
    const double t2474 = t7 * t2471;
    const double t2476 = motion->constants[7] * t1189;
    const double t2481 = (sin_phi * t2476) - (cos_phi * ((motion->constants[7] * t299) - t1206));
    const double t2487 = (t12 * motion->constants[28]) + (t7 * motion->constants[29]);
    const double t2492 = (motion->constants[7] * motion->constants[1]) + (t7 *
        motion->constants[28]) - t1993 - (t12 * motion->constants[29]) - (t1134 * t2487);
    const double t2494 = sin_phi * t1188;
    const double t2496 = cos_phi * speeds[0];
    const double t2498 = sin_phi * t1194;
    const double t2505 = cos_delta * t2496;
    const double t2507 = (cos_phi * ((t7 * t1243) + (speeds[0] * (motion->constants[23] +
        t1961)))) + (t2128 * t2505);
    const double t2510 = sin_delta * speeds[0];
    const double t2519 = cos_phi * ((t12 * t1243) + (speeds[0] * (t1900 - motion->constants[24])));
    const double t2522 = (motion->constants[23] * t2494) - t2481;
    const double t2526 = (t2128 * t2494) + (cos_phi * ((motion->constants[26] * t2510) + (t1284 *
        t2510))) + (cos_delta * t2522) - (sin_delta * t2519);
    const double t2532 = (cos_delta * t2519) + (sin_delta * t2522) - (t2310 * t2505);
    const double t2536 = sin_phi * ((motion->constants[7] * t1248) - t1206);
    const double t2545 = (t12 * t1969) + (t7 * t1959) + (t55 * t2174) - (t12 * t2126) - (t1164 *
        t2152);
    const double t2553 = (cos_delta * t2200) + (sin_delta * t2203);
    const double t2555 = (t1191 * t2055) + t2553 - t1381;
    const double t2560 = (sin_delta * t2210) + (cos_delta * t2213);
    const double t2562 = sin_delta * t2219;
    const double t2566 = t1197 + (cos_delta * t2560) - (t1195 * t2055) - (sin_delta * t2562);
    const double t2574 = (sin_delta * t2232) - (cos_delta * t2230);
    const double t2577 = (t1961 * t2574) - (t1900 * (t1521 + t1521)) - (t1961 * (t1519 + t1519));
    const double t2583 = (sin_delta * t2560) + (cos_delta * t2562) - t2577 -
        (motion->constants[23] * t2574);
    const double t2587 = (t12 * t2555) - (t7 * t2566);
    const double t2591 = (sin_delta * t1435) + (cos_delta * t2254);
    const double t2595 = (sin_delta * t2252) - (cos_delta * t2260);
    const double t2597 = t2265 + t2408;
    const double t2599 = t1220 + t1220;
    const double t2605 = (sin_delta * t2280) - (cos_delta * t2273);
    const double t2613 = (sin_delta * t2599) + (cos_delta * t2597) + (cos_delta * t2295) +
        (sin_delta * t2299);
    const double t2621 = (sin_delta * t2597) + (sin_delta * t2313) - (cos_delta * t2599) -
        (cos_delta * t2308);
    const double t2623 = sin_delta * t2319;
    const double t2625 = t1218 + t1218;
    const double t2631 = (t1134 * t2587) + (t1935 * t2591) + (t1952 * t2595) + (t1993 * t2597) +
        (t2039 * t2267) + (t2126 * t2605);
    const double t2636 = t2631 + (t2152 * t2613) + (t2174 * t2621) + (t2194 * t2623) -
        (motion->constants[7] * (t2226 + t2366)) - (t7 * t2555);
    const double t2641 = t2636 - (t12 * t2566) - (t1123 * t2583) - (t1958 * t2599) - (t2024 *
        t2269) - (t2326 * t2625);
    const double t2649 = (t1959 * t2472) + (t2481 * t2492) + (t2000 * t2494) + (t2126 * t2507) +
        (t2152 * t2526) + (t2174 * t2532);
    const double t2654 = t2649 + (t2536 * t2545) + (t2421 * t2498) + (t16 * t2343) - (t1969 *
        t2474) - (t2075 * t2496);
    const double t2657 = t2654 - (t2046 * t2498) - (sin_phi * t2641) - (t13 * t2437);
    const double t2661 = (t1743 * t2081) + (speeds[2] * t2657) + (t798 * t2461);
    const double t2667 = (t1745 * t2081) + (speeds[1] * t2657) + (t797 * t2467);
    const double t2669 = motion->constants[7] * t1745;
    const double t2670 = t12 * t2669;
    const double t2672 = t7 * t2669;
    const double t2674 = speeds[1] * t2476;
    const double t2676 = speeds[1] * t1191;
    const double t2679 = speeds[1] * t1195;
    const double t2682 = t2408 + t2476;
    const double t2684 = (t1191 * t2128) + (cos_delta * t2682);
    const double t2685 = speeds[1] * t2684;
    const double t2687 = sin_delta * t2682;
    const double t2688 = speeds[1] * t2687;
    const double t2690 = speeds[1] * t1206;
    const double t2700 = (t1969 * t2672) + (t2000 * t2676) + (t1745 * t2075) + (t2152 * t2685) +
        (t2174 * t2688) + (t2545 * t2690);
    const double t2705 = t2700 + (t2421 * t2679) + (speeds[1] * t2641) + (t487 * t2667) - (t1959 *
        t2670) - (t2492 * t2674);
    const double t2707 = t2705 - (t2046 * t2679) - (t805 * t2467);
    const double t2713 = (t490 * t2667) + (t81 * t2707) - (t810 * t2467);
    const double t2719 = (t819 * t2467) + (t498 * t2667) + (t84 * t2707);
    const double t2721 = t1369 * t1881;
    const double t2725 = motion->constants[22] * t1749;
    const double t2729 = (speeds[0] * t2459) - t1829 - (t1168 * t2725);
    const double t2733 = (t829 * t2461) + (t514 * t2467) + (t832 * t2729) - (t1168 * t2721);
    const double t2735 = t1365 * t1881;
    const double t2740 = (t141 * t2467) + (t841 * t2729) - (t1168 * t2735);
    const double t2742 = t443 * t1369;
    const double t2743 = t1886 * t2742;
    const double t2758 = t1545 + (motion->constants[17] * t1815) - (motion->constants[34] * t1820);
    const double t2764 = t1557 + t2758 - (motion->constants[1] * t1813) - (motion->constants[28] *
        t1784);
    const double t2767 = (t7 * t2764) + (t12 * t1862);
    const double t2773 = t1534 + (motion->constants[29] * t1790) + (motion->constants[28] * t1813) +
        (motion->constants[31] * t1784) + (motion->constants[21] * t1786) + (sin_delta * t1805);
    const double t2777 = t2773 + (cos_delta * t1833) + (motion->constants[24] * t1859) -
        (motion->constants[23] * t2758) - (motion->constants[7] * t2767);
    const double t2783 = (sin_phi * t2777) + (cos_phi * ((t12 * t1879) - (t7 * t1854)));
    const double t2789 = t2783 + (t1749 * t2081) + (speeds[0] * t2657) + (t798 * t2729);
    const double t2794 = (t2081 * t2742) + (t507 * t2661) + (t515 * t2667) + (t518 * t2789) -
        (t1168 * t2743);
    const double t2796 = t443 * t1365;
    const double t2797 = t1886 * t2796;
    const double t2804 = (t2081 * t2796) + (t526 * t2667) + (t528 * t2789) - (t1168 * t2797);
    const double t2809 = motion->constants[7] * t1749;
    const double t2810 = t12 * t2809;
    const double t2812 = t7 * t2809;
    const double t2814 = speeds[0] * t2476;
    const double t2816 = speeds[0] * t1191;
    const double t2819 = speeds[0] * t1195;
    const double t2821 = speeds[0] * t2684;
    const double t2823 = speeds[0] * t2687;
    const double t2825 = speeds[0] * t1206;
    const double t2835 = (t1969 * t2812) + (t2000 * t2816) + (t1749 * t2075) + (t2152 * t2821) +
        (t2174 * t2823) + (t2545 * t2825);
    const double t2840 = t2835 + (t2421 * t2819) + (speeds[0] * t2641) + (t487 * t2789) - t2777 -
        (t1959 * t2810);
    const double t2843 = t2840 - (t2492 * t2814) - (t2046 * t2819) - (t860 * t2729);
    const double t2853 = (t856 * t2467) + (t532 * t2667) + (t105 * t2707) + (t53 * t2843) + (t548 *
        t2740) + (t538 * t2804);
    const double t2855 = t2853 - (t123 * t2733) - (t36 * t2794);
    const double t2857 = t142 * t1365;
    const double t2869 = t2713 + (t36 * t2733) + (t548 * t2804) - (t2102 * t2857) - (t143 * t2707) -
        (t148 * t2843);
    const double t2871 = t2869 - (t538 * t2740) - (t123 * t2794);
    const double t2877 = (t818 * t2467) + (t497 * t2667) - (sin_phi * t2855);
    const double t2883 = (t1123 * t1863) + (t1134 * t1879) + (t1398 * t1969) + (t1763 * t2000) +
        (t1749 * t2046) + (t1895 * t2081);
    const double t2888 = t2883 + (t2091 * t2102) + (t2144 * t2152) + (t2164 * t2174) + (t2184 *
        t2194) + (speeds[0] * t2343);
    const double t2893 = t2888 + (t778 * t2461) + (t793 * t2467) + (t445 * t2661) + (t480 * t2667) +
        (t72 * t2707);
    const double t2898 = t2893 + (motion->constants[24] * t2719) + (t828 * t2733) + (t525 * t2804) +
        (t120 * t2871) + (motion->constants[27] * t2877);
    const double t2904 = t2898 - t1854 - (t1168 * t1898) - (t1788 * t1959) - (t2116 * t2126) -
        (t1189 * t2437) - (motion->constants[23] * t2713);
    const double t2907 = t2904 - (t839 * t2740) - (t505 * t2794) - (t104 * t2855);
    const double t2909 = motion->constants[7] * t2764;
    const double t2921 = (t28 * t443 * t1360) + (t172 * t1887) + (t174 * t1890) + (t176 * t1892);
    const double t2924 = (t174 * t1882) - (t176 * t1884) - (t1886 * t2921);
    const double t2938 = (t28 * t53 * t1307) + (t174 * t2086) + (t176 * t2088) - (t172 * t2083);
    const double t2943 = t1245 + (t174 * t2107) - (t176 * t2113);
    const double t2949 = (t174 * t2135) + (t176 * t2139) - (sin_delta * t1250);
    const double t2955 = (cos_delta * t1250) + (t176 * t2160) - (t174 * t2157);
    const double t2963 = (t28 * t2176) + (t172 * t2177) + (t174 * t2179) + (t176 * t2181);
    const double t2986 = (t1123 * t2909) + (t1398 * t1959) + (t1788 * t1969) + (t1749 * t2000) +
        (t2102 * t2938) + (t2126 * t2943);
    const double t2991 = t2986 + (t2152 * t2949) + (t2174 * t2955) + (t2194 * t2963) + (t1217 *
        t2421) + (t1189 * t2343);
    const double t2996 = t2991 + (speeds[0] * t2437) + (t910 * t2461) + (t918 * t2467) + (t569 *
        t2661) + (t577 * t2667);
    const double t3001 = t2996 + (t162 * t2707) + (t927 * t2733) + (t588 * t2804) + (t191 * t2871) -
        t1879;
    const double t3006 = t3001 - (t1134 * t1854) - (t1168 * t2924) - (t1763 * t2046) - (t2081 *
        t2921) - (motion->constants[24] * t2713);
    const double t3011 = t3006 - (motion->constants[23] * t2719) - (t931 * t2740) - (t584 * t2794) -
        (t181 * t2855) - (t48 * t2877);
    const double t3013 = t7 * t1847;
    const double t3014 = motion->constants[34] * t1784;
    const double t3015 = sin_delta * t3014;
    const double t3017 = motion->constants[17] * t1784;
    const double t3018 = t1961 * t3017;
    const double t3023 = t3018 + (motion->constants[23] * t3017) + (cos_delta * t3014) - t2758;
    const double t3025 = t12 * t1847;
    const double t3027 = t3025 + (t7 * t3015);
    const double t3029 = t1187 * t1191;
    const double t3030 = t1771 + t3029;
    const double t3032 = t1187 * t1187;
    const double t3033 = t1195 * t1195;
    const double t3034 = t3032 + t3033;
    const double t3038 = t1225 + t3029;
    const double t3040 = (sin_delta * t3034) + (cos_delta * t3038);
    const double t3044 = (sin_delta * t3038) - (cos_delta * t3034);
    const double t3046 = t1191 * t1195;
    const double t3056 = (t12 * t3015) + (t1134 * t3027) + (t1993 * t3030) + (t1240 * t2126) +
        (t2152 * t3040) + (t2174 * t3044);
    const double t3061 = t3056 + (t2326 * t3046) + (t12 * t2871) - t3013 - (t1123 * t3023) -
        (t1958 * t3034);
    const double t3064 = t3061 - (t12 * t2713) - (t7 * t2719) - (t7 * t2877);
    const double t3068 = motion->constants[5] - t238;
    const double t3072 = (motion->constants[20] * t3068) + (motion->constants[19] *
        motion->constants[9]);
    const double t3073 = motion->constants[2] * t3072;
    const double t3074 = t3073 + t3073;
    const double t3075 = t1260 * t1265;
    const double t3076 = t7 * t3075;
    const double t3077 = t1256 * t1260;
    const double t3078 = cos_delta * t3077;
    const double t3080 = t3078 + (sin_delta * t1820);
    const double t3082 = sin_delta * t3077;
    const double t3084 = (cos_delta * t1820) - t3082;
    const double t3086 = t12 * t3075;
    const double t3088 = t3086 + (t7 * t3080);
    const double t3092 = (t12 * t3080) + (t1134 * t3088) - t3076 - (t1123 * t3084);
    const double t3096 = (motion->constants[19] * t3068) - (motion->constants[20] *
        motion->constants[9]);
    const double t3097 = motion->constants[2] * t3096;
    const double t3098 = t3077 - t1799;
    const double t3100 = t1801 + t3075;
    const double t3102 = t1256 * t1256;
    const double t3103 = t1265 * t1265;
    const double t3104 = t3102 - t3103;
    const double t3106 = (cos_delta * t3100) - (sin_delta * t3104);
    const double t3110 = (sin_delta * t3100) + (cos_delta * t3104);
    const double t3114 = (t12 * t3098) + (t7 * t3106);
    const double t3118 = (t12 * t3106) + (t1123 * t3110) + (t1134 * t3114) - (t7 * t3098);
    const double t3121 = t1256 * t1265;
    const double t3122 = sin_delta * t3121;
    const double t3123 = (cos_delta * t1799) - t3122;
    const double t3126 = cos_delta * t3121;
    const double t3127 = (sin_delta * t1799) + t3126;
    const double t3130 = t3086 + (t7 * t3123);
    const double t3134 = t3076 - (t12 * t3123) - (t1123 * t3127) - (t1134 * t3130);
    const double t3138 = (cos_delta * t1794) + (sin_delta * t1809);
    const double t3140 = t1260 * t1260;
    const double t3141 = t3103 + t3140;
    const double t3142 = t1961 * t3141;
    const double t3148 = t3142 + (motion->constants[23] * t3141) + (cos_delta * t1809) -
        (sin_delta * t1794);
    const double t3150 = t7 * t3138;
    const double t3153 = t1820 + t3121;
    const double t3158 = (t12 * t3138) + (t1134 * t3150) + (t1935 * t3098) + (t1952 * t3153) -
        (t1123 * t3148);
    const double t3162 = (t3074 * t3092) + (t3097 * t3118) + (t3074 * t3134) +
        (motion->constants[2] * t3158);
    const double t3164 = t3097 + t3097;
    const double t3166 = t3078 + t3122;
    const double t3168 = t3082 - t3126;
    const double t3172 = (t12 * t1801) - (t7 * t3166);
    const double t3176 = (t1134 * t3172) - (t7 * t1801) - (t12 * t3166) - (t1123 * t3168);
    const double t3181 = sin_delta * t1815;
    const double t3183 = t3121 - t1820;
    const double t3184 = t1961 * t3183;
    const double t3188 = t3184 + (motion->constants[23] * t3183) + (cos_delta * t1815);
    const double t3192 = (t12 * t1794) - (t7 * t3181);
    const double t3195 = t3102 + t3140;
    const double t3201 = (t1123 * t3188) + (t1134 * t3192) + (t1935 * t3100) - (t7 * t1794) - (t12 *
        t3181) - (t1952 * t3195);
    const double t3205 = (t3164 * t3176) + (t3092 * t3164) + (t3073 * t3118) +
        (motion->constants[2] * t3201);
    const double t3207 = (motion->constants[20] * t3162) + (motion->constants[19] * t3205);
    const double t3210 = t1187 * t1195;
    const double t3211 = t3210 - t1766;
    const double t3213 = t1784 + t3046;
    const double t3215 = t3046 - t1240;
    const double t3217 = t1228 + t3210;
    const double t3219 = (cos_delta * t3217) - (sin_delta * t3215);
    const double t3223 = (cos_delta * t3215) + (sin_delta * t3217);
    const double t3225 = t1191 * t1191;
    const double t3226 = t3032 + t3225;
    const double t3232 = (t7 * t2871) + (t12 * t2877);
    const double t3237 = t3025 + (t1134 * t3013) + (t1993 * t3211) + (t1958 * t3213) + (t2152 *
        t3219) + (t2174 * t3223);
    const double t3242 = t3237 + (t12 * t2719) + t3232 - (t1123 * t1859) - (t2326 * t3226) - (t7 *
        t2713);
    const double t3245 = (motion->constants[19] * t3064) + (motion->constants[20] * t3242) - t3207;
    const double t3247 = (t161 * t3011) + t3245 - (t65 * t2907);
    const double t3257 = (t1603 * t1930) - (t1601 * t1926);
    const double t3261 = (t1603 * t1947) - (t1601 * t1943);
    const double t3266 = t1113 + (t1937 * t3261) - (t1601 * t1913) - (t1603 * t1916) - (t1918 *
        t3257);
    const double t3267 = t3266 - (t1601 * t1902);
    const double t3270 = t1603 * t1904;
    const double t3271 = t3270 - (t1601 * t1965);
    const double t3283 = (t1603 * t1985) + (t1937 * t3257) + (t1918 * t3261) - t1074 - (t1601 *
        t1909);
    const double t3288 = (t1603 * t1977) + (motion->constants[34] * t3257) +
        (motion->constants[23] * t3283) - motion->constants[39] - (t1112 * t1601);
    const double t3297 = t1642 + (t1603 * t2018) + (motion->constants[35] * t3261) - (t1601 *
        t2016);
    const double t3304 = (t1603 * t2033) - motion->constants[37] - (t1601 * t2029) -
        (motion->constants[35] * t3257);
    const double t3308 = (t1603 * t2007) + (cos_delta * t3304) - (motion->constants[24] * t3283) -
        (sin_delta * t3297);
    const double t3321 = (t1603 * t2066) + (motion->constants[24] * t3266) + (cos_delta * t3297) +
        (sin_delta * t3304) - (t1601 * t2064);
    const double t3327 = (t2050 * t3267) + (t16 * t3308) - (t2048 * t3271) - (t13 * t3288) -
        (sin_phi * t3321);
    const double t3336 = t3321 + (t1961 * t3271) + (t1625 * t2095) + (t487 * t3327) - (t1900 *
        t3267);
    const double t3342 = (t1625 * t2120) + (t2123 * t3336) - (t2118 * t3327);
    const double t3348 = (t1625 * t2146) + (t2145 * t3327) + (t2149 * t3336);
    const double t3354 = (t2171 * t3336) - (t1625 * t2168) - (t2166 * t3327);
    const double t3357 = t2189 * t3348;
    const double t3360 = t3357 - (t2185 * t3342) - (t2191 * t3354);
    const double t3377 = t3342 + (t1601 * t2323) - t3270;
    const double t3383 = (t1603 * t2250) + (t2257 * t3257) + (t2262 * t3261) + (t1220 * t3283) +
        (t2265 * t3266) + (t298 * t3288);
    const double t3388 = t3383 + (t2282 * t3342) + (t2304 * t3348) + (t2317 * t3354) + (t2320 *
        t3360) + (t2322 * t3377);
    const double t3392 = t3388 - t2205 - (t1601 * t2246) - (t2267 * t3297) - (t2269 * t3304);
    const double t3410 = (t2415 * t3348) + (t2418 * t3354) - (t2410 * t3342);
    const double t3416 = t2210 + (t1448 * t3257) + (t1218 * t3283) + (t2389 * t3342) + (t2396 *
        t3348) + (t2404 * t3354);
    const double t3421 = t3416 + (t2406 * t3360) + (t2408 * t3377) + (t298 * t3410) - (t1601 *
        t2376) - (t1603 * t2380);
    const double t3424 = t3421 - (t2383 * t3261) - (t2386 * t3266) - (t298 * t3308);
    const double t3435 = t3357 + (t1601 * t2446) + (t1603 * t2450) - t2441 - (t1294 * t3342) -
        (t1297 * t3354);
    const double t3437 = (t1625 * t2439) + (speeds[2] * t3435);
    const double t3443 = (t1625 * t2464) + (t780 * t3435) - (t776 * t1829);
    const double t3449 = t3283 + (t1603 * t2487);
    const double t3465 = (t12 * t3271) + (t7 * t3267) + (t55 * t3354) - (t12 * t3342) - (t1164 *
        t3348);
    const double t3485 = (t1603 * t2587) + (t2591 * t3257) + (t2595 * t3261) + (t2597 * t3283) +
        (t2267 * t3304) + (t2605 * t3342);
    const double t3490 = t3485 + (t2613 * t3348) + (t2621 * t3354) + (t2623 * t3360) - t2553 -
        (t1601 * t2583);
    const double t3493 = t3490 - (t2599 * t3266) - (t2269 * t3297) - (t2625 * t3377);
    const double t3501 = (t2472 * t3267) + (t2494 * t3288) + (t2507 * t3342) + (t2526 * t3348) +
        (t2532 * t3354) + (t2536 * t3465);
    const double t3506 = t3501 + (t2498 * t3410) + (t16 * t3392) - (t2474 * t3271) - (t2481 *
        t3449) - (t2496 * t3321);
    const double t3509 = t3506 - (t2498 * t3308) - (sin_phi * t3493) - (t13 * t3424);
    const double t3513 = (t1743 * t3327) + (speeds[2] * t3509) + (t798 * t3437);
    const double t3520 = t2783 + (t1745 * t3327) + (speeds[1] * t3509) + (t797 * t3443);
    const double t3539 = (t2672 * t3271) + (t2674 * t3449) + (t2676 * t3288) + (t1745 * t3321) +
        (t2685 * t3348) + (t2688 * t3354);
    const double t3544 = t3539 + (t2690 * t3465) + (t2679 * t3410) + (speeds[1] * t3493) + (t487 *
        t3520) - t2777;
    const double t3547 = t3544 - (t2670 * t3267) - (t2679 * t3308) - (t805 * t3443);
    const double t3553 = (t490 * t3520) + (t81 * t3547) - (t810 * t3443);
    const double t3559 = (t819 * t3443) + (t498 * t3520) + (t84 * t3547);
    const double t3566 = (t1625 * t2725) + (speeds[0] * t3435);
    const double t3570 = (t1625 * t2721) + (t829 * t3437) + (t514 * t3443) + (t832 * t3566);
    const double t3576 = (t1625 * t2735) + (t141 * t3443) + (t841 * t3566);
    const double t3586 = (t1749 * t3327) + (speeds[0] * t3509) + (t798 * t3566);
    const double t3591 = (t1625 * t2743) + (t2742 * t3327) + (t507 * t3513) + (t515 * t3520) +
        (t518 * t3586);
    const double t3599 = (t1625 * t2797) + (t2796 * t3327) + (t526 * t3520) + (t528 * t3586);
    const double t3621 = (t2812 * t3271) + (t2814 * t3449) + (t2816 * t3288) + (t1749 * t3321) +
        (t2821 * t3348) + (t2823 * t3354);
    const double t3626 = t3621 + (t2825 * t3465) + (t2819 * t3410) + (speeds[0] * t3493) + (t487 *
        t3586) - (t2810 * t3267);
    const double t3628 = t3626 - (t2819 * t3308) - (t860 * t3566);
    const double t3638 = (t856 * t3443) + (t532 * t3520) + (t105 * t3547) + (t53 * t3628) + (t548 *
        t3576) + (t538 * t3599);
    const double t3640 = t3638 - (t123 * t3570) - (t36 * t3591);
    const double t3653 = t3553 + (t36 * t3570) + (t548 * t3599) - (t2857 * t3336) - (t143 * t3547) -
        (t148 * t3628);
    const double t3655 = t3653 - (t538 * t3576) - (t123 * t3591);
    const double t3661 = (t818 * t3443) + (t497 * t3520) - (sin_phi * t3640);
    const double t3667 = (t1601 * t1863) + (t1603 * t1879) + (t1625 * t1898) + (t1398 * t3271) +
        (t1763 * t3288) + (t1749 * t3308);
    const double t3672 = t3667 + (t1895 * t3327) + (t2091 * t3336) + (t2144 * t3348) + (t2164 *
        t3354) + (t2184 * t3360);
    const double t3677 = t3672 + (speeds[0] * t3392) + (t778 * t3437) + (t793 * t3443) + (t445 *
        t3513) + (t480 * t3520);
    const double t3682 = t3677 + (t72 * t3547) + (motion->constants[24] * t3559) + (t828 * t3570) +
        (t525 * t3599) + (t120 * t3655);
    const double t3687 = t3682 + (motion->constants[27] * t3661) - (t1788 * t3267) - (t2116 *
        t3342) - (t1189 * t3424) - (motion->constants[23] * t3553);
    const double t3690 = t3687 - (t839 * t3576) - (t505 * t3591) - (t104 * t3640);
    const double t3726 = (t1601 * t2909) + (t1625 * t2924) + (t1398 * t3267) + (t1788 * t3271) +
        (t1749 * t3288) + (t2938 * t3336);
    const double t3731 = t3726 + (t2943 * t3342) + (t2949 * t3348) + (t2955 * t3354) + (t2963 *
        t3360) + (t1217 * t3410);
    const double t3736 = t3731 + (t1189 * t3392) + (speeds[0] * t3424) + (t910 * t3437) + (t918 *
        t3443) + (t569 * t3513);
    const double t3741 = t3736 + (t577 * t3520) + (t162 * t3547) + (t927 * t3570) + (t588 * t3599) +
        (t191 * t3655);
    const double t3746 = t3741 - (t1603 * t1854) - (t1763 * t3308) - (t2921 * t3327) -
        (motion->constants[24] * t3553) - (motion->constants[23] * t3559);
    const double t3750 = t3746 - (t931 * t3576) - (t584 * t3591) - (t181 * t3640) - (t48 * t3661);
    const double t3769 = (t1603 * t3027) + (t3030 * t3283) + (t1240 * t3342) + (t3040 * t3348) +
        (t3044 * t3354) + (t3046 * t3377);
    const double t3774 = t3769 + (t12 * t3655) - (t1601 * t3023) - (t3034 * t3266) - (t12 * t3553) -
        (t7 * t3559);
    const double t3775 = t3774 - (t7 * t3661);
    const double t3780 = (t1603 * t3088) - t3075 - (t1601 * t3084);
    const double t3785 = (t1601 * t3110) + (t1603 * t3114) - t3098;
    const double t3790 = t3075 - (t1601 * t3127) - (t1603 * t3130);
    const double t3798 = (t1603 * t3150) + (t3098 * t3257) + (t3153 * t3261) - (t1601 * t3148);
    const double t3802 = (t3074 * t3780) + (t3097 * t3785) + (t3074 * t3790) +
        (motion->constants[2] * t3798);
    const double t3807 = (t1603 * t3172) - t1801 - (t1601 * t3168);
    const double t3818 = (t1601 * t3188) + (t1603 * t3192) + (t3100 * t3257) - t1794 - (t3195 *
        t3261);
    const double t3822 = (t3164 * t3807) + (t3164 * t3780) + (t3073 * t3785) +
        (motion->constants[2] * t3818);
    const double t3824 = (motion->constants[20] * t3802) + (motion->constants[19] * t3822);
    const double t3836 = (t7 * t3655) + (t12 * t3661);
    const double t3841 = (t1603 * t3013) + (t3211 * t3283) + (t3213 * t3266) + (t3219 * t3348) +
        (t3223 * t3354) + (t12 * t3559);
    const double t3845 = t3841 + t3836 - (t1601 * t1859) - (t3226 * t3377) - (t7 * t3553);
    const double t3848 = (motion->constants[19] * t3775) + (motion->constants[20] * t3845) - t3824;
    const double t3851 = (t161 * t3750) + t3848 - (t65 * t3690) - (t1635 * t3247);
    const double t3862 = (t1668 * t1926) + (t1670 * t1930) - t1925;
    const double t3867 = t1942 + (t1668 * t1943) + (t1670 * t1947);
    const double t3871 = (t1668 * t1913) + (t1937 * t3867) - (t1670 * t1916) - (t1918 * t3862);
    const double t3873 = t1901 + (t1668 * t1902) + t3871;
    const double t3876 = t1670 * t1904;
    const double t3878 = (t1668 * t1965) + t3876 - t1964;
    const double t3889 = (t1668 * t1909) + (t1670 * t1985) + (t1937 * t3862) + (t1918 * t3867);
    const double t3893 = (t1112 * t1668) + (t1670 * t1977) + (motion->constants[34] * t3862) +
        (motion->constants[23] * t3889);
    const double t3903 = t1728 + (t1668 * t2016) + (t1670 * t2018) + (motion->constants[35] *
        t3867) - t2013;
    const double t3909 = (t1668 * t2029) + (t1670 * t2033) - (motion->constants[35] * t3862);
    const double t3913 = (t1670 * t2007) + (cos_delta * t3909) - (motion->constants[24] * t3889) -
        (sin_delta * t3903);
    const double t3927 = t2060 + (t1668 * t2064) + (t1670 * t2066) + (motion->constants[24] *
        t3871) + (cos_delta * t3903) + (sin_delta * t3909);
    const double t3928 = t3927 - motion->constants[21];
    const double t3934 = (t2050 * t3873) + (t16 * t3913) - (t2048 * t3878) - (t13 * t3893) -
        (sin_phi * t3928);
    const double t3943 = t3928 + (t1961 * t3878) + (t1688 * t2095) + (t487 * t3934) - (t1900 *
        t3873);
    const double t3949 = (t1688 * t2120) + (t2123 * t3943) - (t2118 * t3934);
    const double t3955 = (t1688 * t2146) + (t2145 * t3934) + (t2149 * t3943);
    const double t3961 = (t2171 * t3943) - (t1688 * t2168) - (t2166 * t3934);
    const double t3964 = t2189 * t3955;
    const double t3967 = t3964 - (t2185 * t3949) - (t2191 * t3961);
    const double t3985 = t1963 + t3949 - t3876 - (t1668 * t2323);
    const double t3991 = t2237 + (t1668 * t2246) + (t1670 * t2250) + (t2257 * t3862) + (t2262 *
        t3867) + (t1220 * t3889);
    const double t3996 = t3991 + (t2265 * t3871) + (t298 * t3893) + (t2282 * t3949) + (t2304 *
        t3955) + (t2317 * t3961);
    const double t4000 = t3996 + (t2320 * t3967) + (t2322 * t3985) - (t2267 * t3903) - (t2269 *
        t3909);
    const double t4018 = (t2415 * t3955) + (t2418 * t3961) - (t2410 * t3949);
    const double t4024 = t2370 + (t1668 * t2376) + (t1448 * t3862) + (t1218 * t3889) + (t2389 *
        t3949) + (t2396 * t3955);
    const double t4029 = t4024 + (t2404 * t3961) + (t2406 * t3967) + (t2408 * t3985) + (t298 *
        t4018) - (t1670 * t2380);
    const double t4032 = t4029 - (t2383 * t3867) - (t2386 * t3871) - (t298 * t3913);
    const double t4042 = t3964 + (t1670 * t2450) - (t1668 * t2446) - (t1294 * t3949) - (t1297 *
        t3961);
    const double t4045 = (t1688 * t2439) + (speeds[2] * t4042) - t1829;
    const double t4049 = (t1688 * t2464) + (t780 * t4042);
    const double t4055 = t3889 + (t1670 * t2487);
    const double t4071 = (t12 * t3878) + (t7 * t3873) + (t55 * t3961) - (t12 * t3949) - (t1164 *
        t3955);
    const double t4091 = t2577 + (t1668 * t2583) + (t1670 * t2587) + (t2591 * t3862) + (t2595 *
        t3867) + (t2597 * t3889);
    const double t4096 = t4091 + (t2267 * t3909) + (t2605 * t3949) + (t2613 * t3955) + (t2621 *
        t3961) + (t2623 * t3967);
    const double t4099 = t4096 - (t2599 * t3871) - (t2269 * t3903) - (t2625 * t3985);
    const double t4107 = (t2472 * t3873) + (t2494 * t3893) + (t2507 * t3949) + (t2526 * t3955) +
        (t2532 * t3961) + (t2536 * t4071);
    const double t4112 = t4107 + (t2498 * t4018) + (t16 * t4000) - (t2474 * t3878) - (t2481 *
        t4055) - (t2496 * t3928);
    const double t4115 = t4112 - (t2498 * t3913) - (sin_phi * t4099) - (t13 * t4032);
    const double t4120 = t2783 + (t1743 * t3934) + (speeds[2] * t4115) + (t798 * t4045);
    const double t4126 = (t1745 * t3934) + (speeds[1] * t4115) + (t797 * t4049);
    const double t4145 = (t2672 * t3878) + (t2674 * t4055) + (t2676 * t3893) + (t1745 * t3928) +
        (t2685 * t3955) + (t2688 * t3961);
    const double t4150 = t4145 + (t2690 * t4071) + (t2679 * t4018) + (speeds[1] * t4099) + (t487 *
        t4126) - (t2670 * t3873);
    const double t4152 = t4150 - (t2679 * t3913) - (t805 * t4049);
    const double t4158 = (t490 * t4126) + (t81 * t4152) - (t810 * t4049);
    const double t4164 = (t819 * t4049) + (t498 * t4126) + (t84 * t4152);
    const double t4171 = (t1688 * t2725) + (speeds[0] * t4042);
    const double t4175 = (t1688 * t2721) + (t829 * t4045) + (t514 * t4049) + (t832 * t4171);
    const double t4181 = (t1688 * t2735) + (t141 * t4049) + (t841 * t4171);
    const double t4191 = (t1749 * t3934) + (speeds[0] * t4115) + (t798 * t4171);
    const double t4196 = (t1688 * t2743) + (t2742 * t3934) + (t507 * t4120) + (t515 * t4126) +
        (t518 * t4191);
    const double t4204 = (t1688 * t2797) + (t2796 * t3934) + (t526 * t4126) + (t528 * t4191);
    const double t4226 = (t2812 * t3878) + (t2814 * t4055) + (t2816 * t3893) + (t1749 * t3928) +
        (t2821 * t3955) + (t2823 * t3961);
    const double t4231 = t4226 + (t2825 * t4071) + (t2819 * t4018) + (speeds[0] * t4099) + (t487 *
        t4191) - (t2810 * t3873);
    const double t4233 = t4231 - (t2819 * t3913) - (t860 * t4171);
    const double t4243 = (t856 * t4049) + (t532 * t4126) + (t105 * t4152) + (t53 * t4233) + (t548 *
        t4181) + (t538 * t4204);
    const double t4245 = t4243 - (t123 * t4175) - (t36 * t4196);
    const double t4258 = t4158 + (t36 * t4175) + (t548 * t4204) - (t2857 * t3943) - (t143 * t4152) -
        (t148 * t4233);
    const double t4260 = t4258 - (t538 * t4181) - (t123 * t4196);
    const double t4266 = (t818 * t4049) + (t497 * t4126) - (sin_phi * t4245);
    const double t4272 = t1863 + (t1670 * t1879) + (t1688 * t1898) + (t1398 * t3878) + (t1763 *
        t3893) + (t1749 * t3913);
    const double t4277 = t4272 + (t1895 * t3934) + (t2091 * t3943) + (t2144 * t3955) + (t2164 *
        t3961) + (t2184 * t3967);
    const double t4282 = t4277 + (speeds[0] * t4000) + (t778 * t4045) + (t793 * t4049) + (t445 *
        t4120) + (t480 * t4126);
    const double t4287 = t4282 + (t72 * t4152) + (motion->constants[24] * t4164) + (t828 * t4175) +
        (t525 * t4204) + (t120 * t4260);
    const double t4292 = t4287 + (motion->constants[27] * t4266) - (t1668 * t1863) - (t1788 *
        t3873) - (t2116 * t3949) - (t1189 * t4032);
    const double t4296 = t4292 - (motion->constants[23] * t4158) - (t839 * t4181) - (t505 * t4196) -
        (t104 * t4245);
    const double t4332 = t2909 + (t1688 * t2924) + (t1398 * t3873) + (t1788 * t3878) + (t1749 *
        t3893) + (t2938 * t3943);
    const double t4337 = t4332 + (t2943 * t3949) + (t2949 * t3955) + (t2955 * t3961) + (t2963 *
        t3967) + (t1217 * t4018);
    const double t4342 = t4337 + (t1189 * t4000) + (speeds[0] * t4032) + (t910 * t4045) + (t918 *
        t4049) + (t569 * t4120);
    const double t4347 = t4342 + (t577 * t4126) + (t162 * t4152) + (t927 * t4175) + (t588 * t4204) +
        (t191 * t4260);
    const double t4352 = t4347 - (t1668 * t2909) - (t1670 * t1854) - (t1763 * t3913) - (t2921 *
        t3934) - (motion->constants[24] * t4158);
    const double t4357 = t4352 - (motion->constants[23] * t4164) - (t931 * t4181) - (t584 * t4196) -
        (t181 * t4245) - (t48 * t4266);
    const double t4377 = (t1668 * t3023) + (t1670 * t3027) + (t3030 * t3889) + (t1240 * t3949) +
        (t3040 * t3955) + (t3044 * t3961);
    const double t4382 = t4377 + (t3046 * t3985) + (t12 * t4260) - t3018 - (t3034 * t3871) - (t12 *
        t4158);
    const double t4384 = t4382 - (t7 * t4164) - (t7 * t4266);
    const double t4388 = (t1668 * t3084) + (t1670 * t3088);
    const double t4392 = (t1668 * t3110) - (t1670 * t3114);
    const double t4396 = (t1668 * t3127) - (t1670 * t3130);
    const double t4405 = (t1668 * t3148) + (t1670 * t3150) + (t3098 * t3862) + (t3153 * t3867) -
        t3142;
    const double t4409 = (t3074 * t4388) + (t3074 * t4396) + (motion->constants[2] * t4405) -
        (t3097 * t4392);
    const double t4413 = (t1668 * t3168) + (t1670 * t3172);
    const double t4424 = t3184 + (t1670 * t3192) + (t3100 * t3862) - (t1668 * t3188) - (t3195 *
        t3867);
    const double t4428 = (t3164 * t4413) + (t3164 * t4388) + (motion->constants[2] * t4424) -
        (t3073 * t4392);
    const double t4430 = (motion->constants[20] * t4409) + (motion->constants[19] * t4428);
    const double t4442 = (t7 * t4260) + (t12 * t4266);
    const double t4447 = (t1668 * t1859) + (t1670 * t3013) + (t3211 * t3889) + (t3213 * t3871) +
        (t3219 * t3955) + (t3223 * t3961);
    const double t4451 = t4447 + (t12 * t4164) + t4442 - (t3226 * t3985) - (t7 * t4158);
    const double t4454 = (motion->constants[19] * t4384) + (motion->constants[20] * t4451) - t4430;
    const double t4459 = t1742 * ((t161 * t4357) + t4454 - (t65 * t4296) - (t1701 * t3247) -
        (t1710 * t3851));
    const double t4461 = (t1653 * t3851) - (t1710 * t4459);
    const double t4465 = (t1180 * t3247) - (t1635 * t4461) - (t1701 * t4459);
    const double t4467 = t3077 - t1273;
    const double t4469 = t1320 + t3121;
    const double t4472 = motion->constants[26] * motion->constants[3];
    const double t4473 = t4472 + t4472;
    const double t4475 = motion->constants[25] * motion->constants[3];
    const double t4483 = t3232 + (t2152 * t4467) + (t2174 * t4469) + (t3092 * t4473) + (t3118 *
        t4475) + (t3134 * t4473);
    const double t4485 = t4483 + (t3158 * motion->constants[3]) - (t2126 * t3141);
    const double t4487 = t3121 - t1320;
    const double t4489 = t1225 + t3075;
    const double t4492 = t4475 + t4475;
    const double t4506 = (t2126 * t4487) + (t2152 * t4489) + (t3176 * t4492) + (t3092 * t4492) +
        (t3118 * t4472) + (t3201 * motion->constants[3]);
    const double t4511 = t4506 + (t972 * t2467) + (t623 * t2667) + (t28 * t2855) + (t96 * t2871) -
        (t2174 * t3195);
    const double t4512 = t4511 - (t55 * t2877);
    const double t4519 = t3245 + (t229 * t3011) - (motion->constants[20] * t4485) -
        (motion->constants[19] * t4512) - (t227 * t2907);
    const double t4532 = t3836 + (t3348 * t4467) + (t3354 * t4469) + (t3780 * t4473) + (t3785 *
        t4475) + (t3790 * t4473);
    const double t4534 = t4532 + (t3798 * motion->constants[3]) - (t3141 * t3342);
    const double t4552 = (t3342 * t4487) + (t3348 * t4489) + (t3807 * t4492) + (t3780 * t4492) +
        (t3785 * t4472) + (t3818 * motion->constants[3]);
    const double t4557 = t4552 + (t972 * t3443) + (t623 * t3520) + (t28 * t3640) + (t96 * t3655) -
        (t3195 * t3354);
    const double t4558 = t4557 - (t55 * t3661);
    const double t4567 = t3848 + (t229 * t3750) - (motion->constants[20] * t4534) -
        (motion->constants[19] * t4558) - (t227 * t3690) - (t1635 * t4519);
    const double t4580 = t4442 + (t3955 * t4467) + (t3961 * t4469) + (t4388 * t4473) + (t4396 *
        t4473) + (t4405 * motion->constants[3]);
    const double t4582 = t4580 - (t3141 * t3949) - (t4392 * t4475);
    const double t4600 = (t3949 * t4487) + (t3955 * t4489) + (t4413 * t4492) + (t4388 * t4492) +
        (t4424 * motion->constants[3]) + (t972 * t4049);
    const double t4605 = t4600 + (t623 * t4126) + (t28 * t4245) + (t96 * t4260) - (t3195 * t3961) -
        (t4392 * t4472);
    const double t4606 = t4605 - (t55 * t4266);
    const double t4616 = t4454 + (t229 * t4357) - (motion->constants[20] * t4582) -
        (motion->constants[19] * t4606) - (t227 * t4296) - (t1701 * t4519);
    const double t4618 = t1742 * (t4616 - (t1710 * t4567));
    const double t4620 = (t1653 * t4567) - (t1710 * t4618);
    const double t4624 = (t1180 * t4519) - (t1635 * t4620) - (t1701 * t4618);
    const double t4626 = motion->constants[20] * motion->constants[14];
    const double t4629 = t4626 + (motion->constants[19] * motion->constants[16]);
    const double t4634 = motion->constants[19] * motion->constants[14];
    const double t4635 = (motion->constants[20] * motion->constants[12]) + t4634;
    const double t4638 = (motion->constants[19] * (t4635 + t4635)) - (motion->constants[20] *
        (t4629 + t4629));
    const double t4641 = t4634 - (motion->constants[20] * motion->constants[16]);
    const double t4645 = (motion->constants[19] * motion->constants[12]) - t4626;
    const double t4648 = (motion->constants[19] * (t4645 - t4629)) - (motion->constants[20] *
        (t4635 + t4641));
    const double t4654 = (motion->constants[20] * (t4645 + t4645)) + (motion->constants[19] *
        (t4641 + t4641));
    const double t4659 = motion->constants[20] * motion->constants[13];
    const double t4662 = t4659 + (motion->constants[19] * motion->constants[15]);
    const double t4667 = motion->constants[19] * motion->constants[13];
    const double t4668 = (motion->constants[20] * motion->constants[11]) + t4667;
    const double t4671 = (motion->constants[19] * (t4668 + t4668)) - (motion->constants[20] *
        (t4662 + t4662));
    const double t4673 = t12 * t3210;
    const double t4674 = t1123 * t3046;
    const double t4676 = t7 * t3210;
    const double t4677 = (t12 * t1771) - t4676;
    const double t4681 = t4674 + (t1134 * t4677) - (t7 * t1771) - t4673;
    const double t4684 = (motion->constants[19] * motion->constants[11]) - t4659;
    const double t4688 = t4667 - (motion->constants[20] * motion->constants[15]);
    const double t4691 = (motion->constants[20] * (t4684 + t4684)) + (motion->constants[19] *
        (t4688 + t4688));
    const double t4692 = t7 * t3029;
    const double t4694 = t12 * t3029;
    const double t4696 = t4694 + (t7 * t1766);
    const double t4700 = t4692 - t4674 - (t12 * t1766) - (t1134 * t4696);
    const double t4706 = (motion->constants[19] * (t4684 - t4662)) - (motion->constants[20] *
        (t4668 + t4688));
    const double t4709 = t3033 - t3225;
    const double t4713 = (t12 * t3211) + (t7 * t3030);
    const double t4717 = (t12 * t3030) + (t1123 * t4709) + (t1134 * t4713) - (t7 * t3211);
    const double t4722 = motion->constants[7] + motion->constants[8];
    const double t4724 = (motion->constants[19] * motion->constants[4]) - (motion->constants[20] *
        t4722);
    const double t4726 = motion->constants[7] * t3211;
    const double t4728 = t1753 * motion->constants[0];
    const double t4729 = t12 * t4728;
    const double t4733 = (t1900 * t3213) - (t1961 * t3226);
    const double t4734 = motion->constants[0] * t4733;
    const double t4735 = (t1790 * motion->constants[0]) - t4734;
    const double t4737 = t7 * t4728;
    const double t4739 = motion->constants[29] + motion->constants[29];
    const double t4742 = t4676 + t4694;
    const double t4746 = t4673 + (t1134 * t4742) - t4692 - (t1123 * t1784);
    const double t4753 = (t4700 * t4739) + (t4739 * t4746) + (motion->constants[28] * t4717) -
        (motion->constants[0] * t4726) - t4729 - (t1123 * t4735);
    const double t4754 = t4753 - (t1134 * t4737);
    const double t4758 = (motion->constants[20] * motion->constants[4]) + (motion->constants[19] *
        t4722);
    const double t4759 = motion->constants[7] * t3030;
    const double t4764 = (t1961 * (t3046 - t1784)) - (t1900 * t3034);
    const double t4765 = motion->constants[0] * t4764;
    const double t4767 = (t1813 * motion->constants[0]) - t4765;
    const double t4770 = motion->constants[28] + motion->constants[28];
    const double t4778 = t4737 + (t4681 * t4770) + (t4746 * t4770) + (motion->constants[29] *
        t4717) - (motion->constants[0] * t4759) - (t1123 * t4767);
    const double t4779 = t4778 - (t1134 * t4729);
    const double t4791 = (t3176 * t4638) + (t3096 * t3162) + (t4671 * t4681) + (t4724 * t4754) +
        (motion->constants[25] * t4485) + (t242 * t4512);
    const double t4796 = t4791 + (motion->constants[23] * t3242) + (t287 * t3011) - (t3118 *
        t4648) - (t3134 * t4654) - (t3072 * t3205);
    const double t4801 = t4796 - (t4691 * t4700) - (t4706 * t4717) - (t4758 * t4779) -
        (motion->constants[24] * t3064) - (t284 * t2907);
    const double t4808 = t1601 * t3046;
    const double t4810 = t4808 + (t1603 * t4677);
    const double t4813 = t4808 + (t1603 * t4696);
    const double t4817 = (t1601 * t4709) + (t1603 * t4713);
    const double t4824 = (t1603 * t4742) - (t1601 * t1784);
    const double t4830 = (t4739 * t4824) + (motion->constants[28] * t4817) - (t1601 * t4735) -
        (t1603 * t4737) - (t4739 * t4813);
    const double t4840 = (t4770 * t4810) + (t4770 * t4824) + (motion->constants[29] * t4817) -
        (t1601 * t4767) - (t1603 * t4729);
    const double t4853 = (t3807 * t4638) + (t3096 * t3802) + (t4671 * t4810) + (t4691 * t4813) +
        (t4724 * t4830) + (motion->constants[25] * t4534);
    const double t4858 = t4853 + (t242 * t4558) + (motion->constants[23] * t3845) + (t287 * t3750) -
        (t3785 * t4648) - (t3790 * t4654);
    const double t4863 = t4858 - (t3072 * t3822) - (t4706 * t4817) - (t4758 * t4840) -
        (motion->constants[24] * t3775) - (t284 * t3690);
    const double t4864 = t4863 - (t1635 * t4801);
    const double t4871 = t1668 * t3046;
    const double t4873 = (t1670 * t4677) - t4871;
    const double t4876 = t4871 - (t1670 * t4696);
    const double t4880 = (t1668 * t4709) - (t1670 * t4713);
    const double t4887 = (t1668 * t1784) + (t1670 * t4742);
    const double t4894 = t4734 + (t1668 * t4735) + (t4739 * t4876) + (t4739 * t4887) - (t1670 *
        t4737) - (motion->constants[28] * t4880);
    const double t4905 = t4765 + (t1668 * t4767) + (t4770 * t4873) + (t4770 * t4887) - (t1670 *
        t4729) - (motion->constants[29] * t4880);
    const double t4919 = (t4413 * t4638) + (t4392 * t4648) + (t3096 * t4409) + (t4671 * t4873) +
        (t4706 * t4880) + (t4724 * t4894);
    const double t4924 = t4919 + (motion->constants[25] * t4582) + (t242 * t4606) +
        (motion->constants[23] * t4451) + (t287 * t4357) - (t4396 * t4654);
    const double t4929 = t4924 - (t3072 * t4428) - (t4691 * t4876) - (t4758 * t4905) -
        (motion->constants[24] * t4384) - (t284 * t4296);
    const double t4932 = t1742 * (t4929 - (t1701 * t4801) - (t1710 * t4864));
    const double t4934 = (t1653 * t4864) - (t1710 * t4932);
    const double t4938 = (t1180 * t4801) - (t1635 * t4934) - (t1701 * t4932);
    const double t4943 = (t16 * t1959) + (t13 * t1969) + (sin_phi * t2492);
    const double t4951 = (t16 * t3267) + (t13 * t3271) - (sin_phi * t3449) - (t1635 * t4943);
    const double t4962 = t1742 * ((t16 * t3873) + (t13 * t3878) - (sin_phi * t4055) - (t1701 *
        t4943) - (t1710 * t4951));
    const double t4964 = (t1653 * t4951) - (t1710 * t4962);
    const double t4968 = (t1180 * t4943) - (t1635 * t4964) - (t1701 * t4962);
    const double t4973 = t1786 - t1240;
    const double t4974 = t12 * t4973;
    const double t4976 = t7 * t4973;
    const double t4978 = t1186 * t1189;
    const double t4979 = t4978 - t1750;
    const double t4981 = t1240 + t1240;
    const double t4982 = t7 * t4981;
    const double t4984 = t12 * t4981;
    const double t4986 = t1210 - t4978;
    const double t4988 = (cos_delta * t4986) - (sin_delta * t4984);
    const double t4992 = (cos_delta * t4984) + (sin_delta * t4986);
    const double t4996 = (t1186 * t1248) - (speeds[0] * speeds[0]);
    const double t5011 = (motion->constants[19] * t4754) - (motion->constants[20] * t4779);
    const double t5016 = (motion->constants[1] * t1753) + (motion->constants[29] * t1766) + (t1123 *
        t2767) + (t1969 * t4976) + (t2492 * t4979) + (t2126 * t4982);
    const double t5021 = t5016 + (t2152 * t4988) + (t2174 * t4992) + (t2545 * t4996) + (t1000 *
        t2461) + (t447 * t2661);
    const double t5026 = t5021 + (t71 * t2843) + (t1005 * t2740) + (t652 * t2804) +
        (motion->constants[19] * t3242) + (t311 * t3011);
    const double t5032 = t5026 + t5011 - t1523 - t1847 - (motion->constants[28] * t1771) - (t1959 *
        t4974) - (t548 * t2733);
    const double t5035 = t5032 - (t538 * t2794) - (motion->constants[20] * t3064) - (t309 * t2907);
    const double t5059 = (motion->constants[19] * t4830) - (motion->constants[20] * t4840);
    const double t5064 = (t1601 * t2767) + (t3271 * t4976) + (t3342 * t4982) + (t3348 * t4988) +
        (t3354 * t4992) + (t3465 * t4996);
    const double t5069 = t5064 + (t1000 * t3437) + (t447 * t3513) + (t71 * t3628) + (t1005 *
        t3576) + (t652 * t3599);
    const double t5074 = t5069 + (motion->constants[19] * t3845) + (t311 * t3750) + t5059 - (t3267 *
        t4974) - (t3449 * t4979);
    const double t5079 = t5074 - (t548 * t3570) - (t538 * t3591) - (motion->constants[20] * t3775) -
        (t309 * t3690) - (t1635 * t5035);
    const double t5104 = (motion->constants[19] * t4894) - (motion->constants[20] * t4905);
    const double t5109 = t2767 + (t3878 * t4976) + (t3949 * t4982) + (t3955 * t4988) + (t3961 *
        t4992) + (t4071 * t4996);
    const double t5114 = t5109 + (t1000 * t4045) + (t447 * t4120) + (t71 * t4233) + (t1005 *
        t4181) + (t652 * t4204);
    const double t5119 = t5114 + (motion->constants[19] * t4451) + (t311 * t4357) + t5104 - (t1668 *
        t2767) - (t3873 * t4974);
    const double t5124 = t5119 - (t4055 * t4979) - (t548 * t4175) - (t538 * t4196) -
        (motion->constants[20] * t4384) - (t309 * t4296);
    const double t5127 = t1742 * (t5124 - (t1701 * t5035) - (t1710 * t5079));
    const double t5129 = (t1653 * t5079) - (t1710 * t5127);
    const double t5133 = (t1180 * t5035) - (t1635 * t5129) - (t1701 * t5127);
    const double t5134 = motion->constants[7] * t1753;
    const double t5137 = (t1790 * t1900) - (t1813 * t1961);
    const double t5139 = t5134 + (t1123 * t5137);
    const double t5143 = (t1601 * t5137) - (t1635 * t5139);
    const double t5151 = t1742 * (t5137 - (t1668 * t5137) - (t1701 * t5139) - (t1710 * t5143));
    const double t5153 = (t1653 * t5143) - (t1710 * t5151);
    const double t5157 = (t1180 * t5139) - (t1635 * t5153) - (t1701 * t5151);
    const double t5158 = t4681 + t4700;
    const double t5162 = t4810 - t4813 - (t1635 * t5158);
    const double t5169 = t1742 * (t4873 + t4876 - (t1701 * t5158) - (t1710 * t5162));
    const double t5171 = (t1653 * t5162) - (t1710 * t5169);
    const double t5175 = (t1180 * t5158) - (t1635 * t5171) - (t1701 * t5169);
    const double t5176 = t1191 * t1200;
    const double t5178 = t1195 * t1200;
    const double t5183 = (t12 * t5176) + (t7 * t5178);
    const double t5187 = (t12 * t5178) + (t1134 * t5183) - (t7 * t5176) - (t1123 * t1786);
    const double t5193 = (t1603 * t5183) - (t1601 * t1786) - (t1635 * t5187);
    const double t5203 = t1742 * ((t1668 * t1786) + (t1670 * t5183) - t1786 - (t1701 * t5187) -
        (t1710 * t5193));
    const double t5205 = (t1653 * t5193) - (t1710 * t5203);
    const double t5209 = (t1180 * t5187) - (t1635 * t5205) - (t1701 * t5203);
    const double t5212 = (motion->constants[20] * t4754) + (motion->constants[19] * t4779);
    const double t5218 = (motion->constants[20] * t4830) + (motion->constants[19] * t4840) -
        (t1635 * t5212);
    const double t5227 = t1742 * ((motion->constants[20] * t4894) + (motion->constants[19] *
        t4905) - (t1701 * t5212) - (t1710 * t5218));
    const double t5229 = (t1653 * t5218) - (t1710 * t5227);
    const double t5233 = (t1180 * t5212) - (t1635 * t5229) - (t1701 * t5227);
    const double t5236 = t5059 - (t1635 * t5011);
    const double t5242 = t1742 * (t5104 - (t1701 * t5011) - (t1710 * t5236));
    const double t5244 = (t1653 * t5236) - (t1710 * t5242);
    const double t5248 = (t1180 * t5011) - (t1635 * t5244) - (t1701 * t5242);
    const double t5251 = t1753 * t4724;
    const double t5253 = t1753 * t4758;
    const double t5259 = t5137 + (t4733 * t4758) + (t4724 * t4764);
    const double t5262 = (t1790 * t4758) + (t1813 * t4724) - t5259;
    const double t5266 = (t12 * t5251) + (t7 * t5253);
    const double t5268 = t4724 * t4724;
    const double t5270 = t4758 * t4758;
    const double t5272 = t5268 + t5270;
    const double t5274 = t4724 * t4758;
    const double t5280 = t5134 + (t7 * t5251) + (t4681 * t5268) + (t4700 * t5270) + (t4746 *
        t5272) + (t4717 * t5274);
    const double t5285 = t5280 - (t4726 * t4758) - (t4724 * t4759) - (t12 * t5253) - (t1123 *
        t5262) - (t1134 * t5266);
    const double t5298 = (t4810 * t5268) + (t4824 * t5272) + (t4817 * t5274) - (t1601 * t5262) -
        (t1603 * t5266) - (t4813 * t5270);
    const double t5299 = t5298 - (t1635 * t5285);
    const double t5313 = t5259 + (t1668 * t5262) + (t4873 * t5268) + (t4876 * t5270) + (t4887 *
        t5272) - (t1670 * t5266);
    const double t5317 = t1742 * (t5313 - (t4880 * t5274) - (t1701 * t5285) - (t1710 * t5299));
    const double t5319 = (t1653 * t5299) - (t1710 * t5317);
    const double t5323 = (t1180 * t5285) - (t1635 * t5319) - (t1701 * t5317);
    const double t5324 = motion->constants[20] * motion->constants[20];
    const double t5326 = motion->constants[19] * motion->constants[19];
    const double t5328 = motion->constants[19] * motion->constants[20];
    const double t5329 = t4717 * t5328;
    const double t5331 = (t4681 * t5324) + (t4700 * t5326) - t5329;
    const double t5335 = t4817 * t5328;
    const double t5339 = (t4810 * t5324) - (t4813 * t5326) - t5335 - (t1635 * t5331);
    const double t5343 = t4880 * t5328;
    const double t5350 = t1742 * ((t4873 * t5324) + (t4876 * t5326) + t5343 - (t1701 * t5331) -
        (t1710 * t5339));
    const double t5352 = (t1653 * t5339) - (t1710 * t5350);
    const double t5356 = (t1180 * t5331) - (t1635 * t5352) - (t1701 * t5350);
    const double t5359 = t4824 - (t1635 * t4746);
    const double t5365 = t1742 * (t4887 - (t1701 * t4746) - (t1710 * t5359));
    const double t5367 = (t1653 * t5359) - (t1710 * t5365);
    const double t5371 = (t1180 * t4746) - (t1635 * t5367) - (t1701 * t5365);
    const double t5375 = t5329 + (t4681 * t5326) + (t4700 * t5324);
    const double t5382 = t5335 + (t4810 * t5326) - (t4813 * t5324) - (t1635 * t5375);
    const double t5392 = t1742 * ((t4873 * t5326) + (t4876 * t5324) - t5343 - (t1701 * t5375) -
        (t1710 * t5382));
    const double t5394 = (t1653 * t5382) - (t1710 * t5392);
    const double t5398 = (t1180 * t5375) - (t1635 * t5394) - (t1701 * t5392);
    const double t5399 = t5328 + t5328;
    const double t5402 = t5326 - t5324;
    const double t5405 = (t4681 * t5399) - (t4700 * t5399) - (t4717 * t5402);
    const double t5413 = (t4810 * t5399) + (t4813 * t5399) - (t4817 * t5402) - (t1635 * t5405);
    const double t5424 = t1742 * ((t4873 * t5399) + (t4880 * t5402) - (t4876 * t5399) - (t1701 *
        t5405) - (t1710 * t5413));
    const double t5426 = (t1653 * t5413) - (t1710 * t5424);
    const double t5430 = (t1180 * t5405) - (t1635 * t5426) - (t1701 * t5424);
    const double t5433 = t3824 - (t1635 * t3207);
    const double t5439 = t1742 * (t4430 - (t1701 * t3207) - (t1710 * t5433));
    const double t5441 = (t1653 * t5433) - (t1710 * t5439);
    const double t5445 = (t1180 * t3207) - (t1635 * t5441) - (t1701 * t5439);
    const double t5448 = (motion->constants[19] * t3162) - (motion->constants[20] * t3205);
    const double t5454 = (motion->constants[19] * t3802) - (motion->constants[20] * t3822) -
        (t1635 * t5448);
    const double t5463 = t1742 * ((motion->constants[19] * t4409) - (motion->constants[20] *
        t4428) - (t1701 * t5448) - (t1710 * t5454));
    const double t5465 = (t1653 * t5454) - (t1710 * t5463);
    const double t5469 = (t1180 * t5448) - (t1635 * t5465) - (t1701 * t5463);
    const double t5470 = t1815 * t1961;
    const double t5472 = t5470 + (motion->constants[23] * t1815);
    const double t5477 = (t1123 * t5472) + (t1794 * t1935) + (t1809 * t1952);
    const double t5478 = t3096 * t3096;
    const double t5480 = t3072 * t3072;
    const double t5481 = t5478 + t5480;
    const double t5483 = t3072 * t3096;
    const double t5492 = t5477 + (t3176 * t5478) + (t3092 * t5481) + (t3118 * t5483) + (t3134 *
        t5480) + (t3072 * t3158);
    const double t5493 = t5492 + (t3096 * t3201);
    const double t5499 = (t1601 * t5472) + (t1794 * t3257) + (t1809 * t3261);
    const double t5511 = t5499 + (t3807 * t5478) + (t3780 * t5481) + (t3785 * t5483) + (t3790 *
        t5480) + (t3072 * t3798);
    const double t5513 = t5511 + (t3096 * t3818) - (t1635 * t5493);
    const double t5520 = t5470 + (t1794 * t3862) + (t1809 * t3867) - (t1668 * t5472);
    const double t5533 = t5520 + (t4413 * t5478) + (t4388 * t5481) + (t4396 * t5480) + (t3072 *
        t4405) + (t3096 * t4424);
    const double t5537 = t1742 * (t5533 - (t4392 * t5483) - (t1701 * t5493) - (t1710 * t5513));
    const double t5539 = (t1653 * t5513) - (t1710 * t5537);
    const double t5543 = (t1180 * t5493) - (t1635 * t5539) - (t1701 * t5537);
    const double t5545 = t3118 * t5328;
    const double t5548 = (t3176 * t5324) + (t3134 * t5326) - t5545;
    const double t5551 = t3785 * t5328;
    const double t5556 = (t3807 * t5324) + (t3790 * t5326) - t5551 - (t1635 * t5548);
    const double t5559 = t4392 * t5328;
    const double t5567 = t1742 * ((t4413 * t5324) + t5559 + (t4396 * t5326) - (t1701 * t5548) -
        (t1710 * t5556));
    const double t5569 = (t1653 * t5556) - (t1710 * t5567);
    const double t5573 = (t1180 * t5548) - (t1635 * t5569) - (t1701 * t5567);
    const double t5576 = t3780 - (t1635 * t3092);
    const double t5582 = t1742 * (t4388 - (t1701 * t3092) - (t1710 * t5576));
    const double t5584 = (t1653 * t5576) - (t1710 * t5582);
    const double t5588 = (t1180 * t3092) - (t1635 * t5584) - (t1701 * t5582);
    const double t5592 = t5545 + (t3176 * t5326) + (t3134 * t5324);
    const double t5599 = t5551 + (t3807 * t5326) + (t3790 * t5324) - (t1635 * t5592);
    const double t5609 = t1742 * ((t4413 * t5326) + (t4396 * t5324) - t5559 - (t1701 * t5592) -
        (t1710 * t5599));
    const double t5611 = (t1653 * t5599) - (t1710 * t5609);
    const double t5615 = (t1180 * t5592) - (t1635 * t5611) - (t1701 * t5609);
    const double t5620 = (t3176 * t5399) - (t3118 * t5402) - (t3134 * t5399);
    const double t5628 = (t3807 * t5399) - (t3785 * t5402) - (t3790 * t5399) - (t1635 * t5620);
    const double t5639 = t1742 * ((t4413 * t5399) + (t4392 * t5402) - (t4396 * t5399) - (t1701 *
        t5620) - (t1710 * t5628));
    const double t5641 = (t1653 * t5628) - (t1710 * t5639);
    const double t5645 = (t1180 * t5620) - (t1635 * t5641) - (t1701 * t5639);
    const double t5648 = (t1496 * t1881) + (t1031 * t2463);
    const double t5654 = (t1265 * t1327) - (t30 * t1320) - (t1293 * t1323);
    const double t5662 = (t30 * t1282) + (t1256 * t1293) + (t1265 * t1296) - (t27 * t1286);
    const double t5668 = (t27 * t1320) - (t1296 * t1323) - (t1256 * t1327);
    const double t5685 = (t1168 * t5648) + (t2126 * t5654) + (t2152 * t5662) + (t2174 * t5668) +
        (t1039 * t2467) + (t665 * t2667);
    const double t5690 = t5685 + (t320 * t2871) + (motion->constants[20] * t4512) + (t330 * t3011) -
        (t1032 * t2459) - (t1037 * t2461);
    const double t5694 = t5690 - (t1045 * t2729) - (t318 * t2855) - (motion->constants[19] *
        t4485) - (t328 * t2907);
    const double t5717 = (t1031 * t1829) + (t3342 * t5654) + (t3348 * t5662) + (t3354 * t5668) +
        (t1039 * t3443) + (t665 * t3520);
    const double t5722 = t5717 + (t320 * t3655) + (motion->constants[20] * t4558) + (t330 * t3750) -
        (t1625 * t5648) - (t1032 * t3435);
    const double t5727 = t5722 - (t1037 * t3437) - (t1045 * t3566) - (t318 * t3640) -
        (motion->constants[19] * t4534) - (t328 * t3690);
    const double t5728 = t5727 - (t1635 * t5694);
    const double t5751 = (t3949 * t5654) + (t3955 * t5662) + (t3961 * t5668) + (t1039 * t4049) +
        (t665 * t4126) + (t320 * t4260);
    const double t5756 = t5751 + (motion->constants[20] * t4606) + (t330 * t4357) - (t1688 *
        t5648) - (t1032 * t4042) - (t1037 * t4045);
    const double t5761 = t5756 - (t1045 * t4171) - (t318 * t4245) - (motion->constants[19] *
        t4582) - (t328 * t4296) - (t1701 * t5694);
    const double t5763 = t1742 * (t5761 - (t1710 * t5728));
    const double t5765 = (t1653 * t5728) - (t1710 * t5763);
    const double t5769 = (t1180 * t5694) - (t1635 * t5765) - (t1701 * t5763);
    const double t5770 = motion->constants[25] * motion->constants[25];
    const double t5772 = motion->constants[26] * motion->constants[26];
    const double t5773 = t5770 + t5772;
    const double t5775 = motion->constants[25] * motion->constants[26];
    const double t5784 = t5477 + (t3176 * t5770) + (t3092 * t5773) + (t3118 * t5775) + (t3134 *
        t5772) + (motion->constants[26] * t3158);
    const double t5785 = t5784 + (motion->constants[25] * t3201);
    const double t5798 = t5499 + (t3807 * t5770) + (t3780 * t5773) + (t3785 * t5775) + (t3790 *
        t5772) + (motion->constants[26] * t3798);
    const double t5800 = t5798 + (motion->constants[25] * t3818) - (t1635 * t5785);
    const double t5814 = t5520 + (t4413 * t5770) + (t4388 * t5773) + (t4396 * t5772) +
        (motion->constants[26] * t4405) + (motion->constants[25] * t4424);
    const double t5818 = t1742 * (t5814 - (t4392 * t5775) - (t1701 * t5785) - (t1710 * t5800));
    const double t5820 = (t1653 * t5800) - (t1710 * t5818);
    const double t5824 = (t1180 * t5785) - (t1635 * t5820) - (t1701 * t5818);
    const double t5825 = t3134 + t3176;
    const double t5829 = t3790 + t3807 - (t1635 * t5825);
    const double t5836 = t1742 * (t4396 + t4413 - (t1701 * t5825) - (t1710 * t5829));
    const double t5838 = (t1653 * t5829) - (t1710 * t5836);
    const double t5842 = (t1180 * t5825) - (t1635 * t5838) - (t1701 * t5836);
    const double t5843 = t1265 * t1323;
    const double t5845 = t1256 * t1323;
    const double t5846 = cos_delta * t5845;
    const double t5848 = sin_delta * t5845;
    const double t5852 = (t12 * t5843) + (t7 * t5846);
    const double t5858 = (t12 * t5846) + (t1123 * t5848) + (t1134 * t5852) - (t7 * t5843) - (t1168 *
        t1828);
    const double t5867 = (t1601 * t5848) + (t1603 * t5852) + (t1625 * t1828) - t5843 - (t1635 *
        t5858);
    const double t5878 = t1742 * ((t1670 * t5852) + (t1688 * t1828) - (t1668 * t5848) - (t1701 *
        t5858) - (t1710 * t5867));
    const double t5880 = (t1653 * t5867) - (t1710 * t5878);
    const double t5884 = (t1180 * t5858) - (t1635 * t5880) - (t1701 * t5878);
    by_parameters[0][0] = t218;
    by_parameters[0][1] = t234;
    by_parameters[0][2] = t293;
    by_parameters[0][3] = 0.0;
    by_parameters[0][4] = t317;
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
    by_parameters[0][22] = t336;
    by_parameters[0][23] = 0.0;
    by_parameters[0][24] = 0.0;
    by_parameters[0][25] = 0.0;
    by_parameters[1][0] = t393;
    by_parameters[1][1] = t406;
    by_parameters[1][2] = t417;
    by_parameters[1][3] = 0.0;
    by_parameters[1][4] = t428;
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
    by_parameters[1][22] = t439;
    by_parameters[1][23] = 0.0;
    by_parameters[1][24] = 0.0;
    by_parameters[1][25] = 0.0;
    by_parameters[2][0] = t621;
    by_parameters[2][1] = t637;
    by_parameters[2][2] = t648;
    by_parameters[2][3] = 0.0;
    by_parameters[2][4] = t664;
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
    by_parameters[2][22] = t678;
    by_parameters[2][23] = 0.0;
    by_parameters[2][24] = 0.0;
    by_parameters[2][25] = 0.0;
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
    by_parameters[4][0] = t731;
    by_parameters[4][1] = t744;
    by_parameters[4][2] = t755;
    by_parameters[4][3] = 0.0;
    by_parameters[4][4] = t764;
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
    by_parameters[4][22] = t775;
    by_parameters[4][23] = 0.0;
    by_parameters[4][24] = 0.0;
    by_parameters[4][25] = 0.0;
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
    by_parameters[7][0] = t970;
    by_parameters[7][1] = t988;
    by_parameters[7][2] = t999;
    by_parameters[7][3] = 0.0;
    by_parameters[7][4] = t1022;
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
    by_parameters[7][22] = t1063;
    by_parameters[7][23] = 0.0;
    by_parameters[7][24] = 0.0;
    by_parameters[7][25] = 0.0;
    by_parameters[8][0] = t4465;
    by_parameters[8][1] = t4624;
    by_parameters[8][2] = t4938;
    by_parameters[8][3] = t4968;
    by_parameters[8][4] = t5133;
    by_parameters[8][5] = t5157;
    by_parameters[8][6] = t5175;
    by_parameters[8][7] = t5209;
    by_parameters[8][8] = t5233;
    by_parameters[8][9] = t5248;
    by_parameters[8][10] = t5323;
    by_parameters[8][11] = t5356;
    by_parameters[8][12] = t5371;
    by_parameters[8][13] = t5398;
    by_parameters[8][14] = t5430;
    by_parameters[8][15] = t5445;
    by_parameters[8][16] = t5469;
    by_parameters[8][17] = t5543;
    by_parameters[8][18] = t5573;
    by_parameters[8][19] = t5588;
    by_parameters[8][20] = t5615;
    by_parameters[8][21] = t5645;
    by_parameters[8][22] = t5769;
    by_parameters[8][23] = t5824;
    by_parameters[8][24] = t5842;
    by_parameters[8][25] = t5884;
    by_parameters[9][0] = t4461;
    by_parameters[9][1] = t4620;
    by_parameters[9][2] = t4934;
    by_parameters[9][3] = t4964;
    by_parameters[9][4] = t5129;
    by_parameters[9][5] = t5153;
    by_parameters[9][6] = t5171;
    by_parameters[9][7] = t5205;
    by_parameters[9][8] = t5229;
    by_parameters[9][9] = t5244;
    by_parameters[9][10] = t5319;
    by_parameters[9][11] = t5352;
    by_parameters[9][12] = t5367;
    by_parameters[9][13] = t5394;
    by_parameters[9][14] = t5426;
    by_parameters[9][15] = t5441;
    by_parameters[9][16] = t5465;
    by_parameters[9][17] = t5539;
    by_parameters[9][18] = t5569;
    by_parameters[9][19] = t5584;
    by_parameters[9][20] = t5611;
    by_parameters[9][21] = t5641;
    by_parameters[9][22] = t5765;
    by_parameters[9][23] = t5820;
    by_parameters[9][24] = t5838;
    by_parameters[9][25] = t5880;
    by_parameters[10][0] = t4459;
    by_parameters[10][1] = t4618;
    by_parameters[10][2] = t4932;
    by_parameters[10][3] = t4962;
    by_parameters[10][4] = t5127;
    by_parameters[10][5] = t5151;
    by_parameters[10][6] = t5169;
    by_parameters[10][7] = t5203;
    by_parameters[10][8] = t5227;
    by_parameters[10][9] = t5242;
    by_parameters[10][10] = t5317;
    by_parameters[10][11] = t5350;
    by_parameters[10][12] = t5365;
    by_parameters[10][13] = t5392;
    by_parameters[10][14] = t5424;
    by_parameters[10][15] = t5439;
    by_parameters[10][16] = t5463;
    by_parameters[10][17] = t5537;
    by_parameters[10][18] = t5567;
    by_parameters[10][19] = t5582;
    by_parameters[10][20] = t5609;
    by_parameters[10][21] = t5639;
    by_parameters[10][22] = t5763;
    by_parameters[10][23] = t5818;
    by_parameters[10][24] = t5836;
    by_parameters[10][25] = t5878;
}

carvallo_motion_error_t whipple_mechanism_f64_motion_by_parameters(const whipple_mechanism_f64_motion_t *motion,
    const double positions[WHIPPLE_MECHANISM_POSITIONS],
    const double speeds[WHIPPLE_MECHANISM_SPEEDS], const double forces[WHIPPLE_MECHANISM_FORCES],
    double by_parameters[WHIPPLE_MECHANISM_STATES][WHIPPLE_MECHANISM_PARAMETERS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHIPPLE_MECHANISM_SPEEDS) && carvallo_are_finite_f64(forces,
        WHIPPLE_MECHANISM_FORCES)) {
        bool are_finite = true;
        whipple_mechanism_f64_compute_by_parameters(motion, positions, speeds, forces,
            by_parameters);
        for (size_t row = 0U; row < WHIPPLE_MECHANISM_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f64(by_parameters[row],
                WHIPPLE_MECHANISM_PARAMETERS);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
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
    const float t2 = p->zH * p->mH;
    const float t9 = p->rR * p->mR;
    const float t13 = p->rF * p->mF;
    const float t18 = (p->rF * t13) + (p->IHxx + p->IFxx);
    const float t21 = p->zB * p->mB;
    const float M_11 = (p->zH * t2) + (p->IRxx + p->IBxx + ((p->rR * t9) + (t18 + (p->zB * t21))));
    float wx_delta2_delta = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &wx_delta2_delta, &cos_lam);
    const float yaw_per_v_delta = cos_lam / p->w;
    const float mu = p->c * yaw_per_v_delta;
    const float wz_delta2_delta = cos_lam + mu;
    const float t38 = (wz_delta2_delta * p->IHxz) + (t18 * wx_delta2_delta);
    const float t42 = p->IBxz - (t21 * p->xB);
    const float t47 = (p->zH * wx_delta2_delta) + (cos_lam * (p->c + p->w));
    const float t51 = p->mH * (t47 - (p->xH * wz_delta2_delta));
    const float M_12 = t38 + ((mu * t42) + (p->zH * t51));
    const float t57 = p->mB * p->xB;
    const float t61 = mu * (p->IBzz + (p->IRxx + (p->xB * t57)));
    const float t71 = (wz_delta2_delta * (p->IFxx + p->IHzz)) + (wx_delta2_delta * p->IHxz) -
        (p->xH * t51);
    const float M_22 = (t47 * t51) + ((mu * t61) + (wx_delta2_delta * t38) + (wz_delta2_delta *
        t71));
    const float SF = p->IFyy / p->rF;
    const float t78 = t13 + SF;
    const float SR = p->IRyy / p->rR;
    const float t83 = t21 - (t9 - t2);
    const float ST = SR - t83;
    const float C1_12 = (wz_delta2_delta * t78) + (yaw_per_v_delta * (t42 + (p->c * ST) + (p->IHxz -
        (t2 * p->xH))));
    const float t95 = t13 * wx_delta2_delta;
    const float K0_12 = t51 - (mu * t57) - t95;
    const float C1_22 = (cos_lam * t95) - (yaw_per_v_delta * ((p->c * K0_12) - t61 - t71));
    const float K0_22 = wx_delta2_delta * K0_12;
    const float K2_12 = yaw_per_v_delta * (ST + t78);
    const float K2_22 = yaw_per_v_delta * ((wx_delta2_delta * SF) - K0_12);
    const float C1_21 = -((mu * SR) + (wz_delta2_delta * SF));
    const float K0_11 = t83 - t13;
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
    float wx_delta2_delta = 0.0F;
    float wx_delta2_delta_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const float M_11_mB = p->zB * p->zB;
    const float t28 = p->rR * p->mR;
    const float M_11_mH = p->zH * p->zH;
    const float M_11_mF = p->rF * p->rF;
    const float t35 = (p->mH * M_11_mH) + p->IHxx + p->IFxx + (p->mF * M_11_mF);
    const float t36 = 1.0F / p->w;
    const float M_11_rR = t28 + t28;
    const float M_11_mR = p->rR * p->rR;
    const float t39 = p->mH * p->xH;
    const float M_12_wz_delta2_delta = p->IHxz - (p->zH * t39);
    const float t42 = p->mB * p->xB;
    const float t43 = p->mH * p->zH;
    const float M_11_zH = t43 + t43;
    const float t45 = p->c + p->w;
    const float t46 = t45 - p->xH;
    const float t50 = t36 * (p->IBxz + M_12_wz_delta2_delta - (p->zB * t42));
    const float t52 = p->IHxz + (t43 * t46);
    const float t55 = p->IFxx + p->IHzz + (p->xH * t39);
    const float t56 = p->c * t36;
    const float t57 = 1.0F / p->rF;
    const float C1_22_wz_delta2_delta = p->mB * M_11_mB;
    const float M_11 = p->IBxx + C1_22_wz_delta2_delta + (p->rR * t28) + p->IRxx + t35;
    const float SF = p->IFyy * t57;
    const float t65 = p->mF * p->rF;
    const float M_11_rF = t65 + t65;
    const float t67 = 1.0F / p->rR;
    const float t68 = p->mB * p->zB;
    const float K0_11 = t68 - (t28 + t65 - t43);
    const float M_11_zB = t68 + t68;
    const float SR = p->IRyy * t67;
    const float t74 = t39 + t42;
    const float t75 = p->c + p->xB;
    const float t76 = p->c + p->xH;
    const float t78 = (p->c * t50) + t52;
    const float t80 = p->mF - (t57 * SF);
    const float t81 = SF + SR;
    const float t83 = p->mR - (t67 * SR);
    const float t84 = t35 * wx_delta2_delta;
    const float M_12_c = wx_delta2_delta_lam * (t50 + t43);
    const float yaw_per_v_delta = wx_delta2_delta_lam * t36;
    const float K0_12_mH = (p->zH * wx_delta2_delta) + (wx_delta2_delta_lam * (t46 - (p->xH *
        t56)));
    const float t93 = t81 - K0_11;
    const float t94 = wx_delta2_delta_lam * t39;
    const float K2_12_IRyy = yaw_per_v_delta * t67;
    const float K2_12_rF = yaw_per_v_delta * t80;
    const float M_12_lam = (t35 * wx_delta2_delta_lam) - (wx_delta2_delta * t78);
    const float M_12 = t84 + (wx_delta2_delta_lam * t78);
    const float K2_12_rR = yaw_per_v_delta * t83;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float K2_12_IFyy = yaw_per_v_delta * t57;
    const float t105 = M_12_wz_delta2_delta * yaw_per_v_delta;
    const float ST = t84 + (wx_delta2_delta_lam * t52) + (p->c * t105);
    const float t110 = wx_delta2_delta * M_12_wz_delta2_delta;
    const float mu = p->c * yaw_per_v_delta;
    const float C1_12_rR = mu * t83;
    const float t113 = mu * t68;
    const float C1_12_IRyy = mu * t67;
    const float C1_21_rR = SR * C1_12_IRyy;
    const float M_22_IRxx = mu * mu;
    const float C1_22_IRxx = yaw_per_v_delta * mu;
    const float wz_delta2_delta = wx_delta2_delta_lam + mu;
    const float t119 = t43 * wz_delta2_delta;
    const float t120 = wx_delta2_delta_lam * t43;
    const float M_12_w = t120 - (t50 * mu);
    const float t124 = t50 + (t56 * t93);
    const float t125 = t36 * t93;
    const float t126 = yaw_per_v_delta * t124;
    const float t128 = SF + t65 + t124;
    const float t129 = wx_delta2_delta_lam * t65;
    const float t130 = wx_delta2_delta * t125;
    const float K2_12 = wx_delta2_delta_lam * t125;
    const float t132 = t36 * K2_12;
    const float M_12_mH = p->zH * K0_12_mH;
    const float M_22_mH = K0_12_mH * K0_12_mH;
    const float K0_22_mH = wx_delta2_delta * K0_12_mH;
    const float C1_12_rF = wz_delta2_delta * t80;
    const float t137 = p->mH * K0_12_mH;
    const float t142 = yaw_per_v_delta * (p->IRxx + t55 + p->IBzz + (p->xB * t42));
    const float C1_12 = wx_delta2_delta_lam * t128;
    const float t144 = wx_delta2_delta * t128;
    const float t145 = t42 * mu;
    const float t146 = yaw_per_v_delta * t81;
    const float t147 = p->c * t146;
    const float C1_21_w = t36 * t147;
    const float t149 = wx_delta2_delta_lam * SF;
    const float C1_21 = -(t147 + t149);
    const float t152 = p->rF * wx_delta2_delta;
    const float M_12_mF = p->rF * t152;
    const float t154 = wx_delta2_delta * t152;
    const float K2_22_mF = yaw_per_v_delta * t152;
    const float t156 = p->mF * t152;
    const float t157 = t56 * t142;
    const float K0_12 = t137 - t156 - t145;
    const float t160 = wx_delta2_delta * SF;
    const float t161 = mu + mu;
    const float M_22_xB = t145 * t161;
    const float t163 = p->xB * mu;
    const float t164 = p->zB * t163;
    const float M_22_mB = t163 * t163;
    const float t169 = t157 + (yaw_per_v_delta * (t55 - (t39 * t45)));
    const float K0_22 = wx_delta2_delta * K0_12;
    const float t171 = wx_delta2_delta * t163;
    const float K2_22_mB = yaw_per_v_delta * t163;
    const float C1_22_mB = t75 * K2_22_mB;
    const float t175 = t36 * (t160 - K0_12);
    const float t176 = p->mH * wx_delta2_delta_lam;
    const float t177 = K0_12_mH + K0_12_mH;
    const float t178 = yaw_per_v_delta * K0_12_mH;
    const float t179 = t76 * t178;
    const float t180 = yaw_per_v_delta * t74;
    const float K0_12_w = t176 + (t56 * t180);
    const float K0_12_c = t176 - t180;
    const float t188 = yaw_per_v_delta * (t94 + K0_12 + (p->c * K0_12_c) - t142);
    const float K0_22_w = wx_delta2_delta * K0_12_w;
    const float K2_22 = wx_delta2_delta_lam * t175;
    const float t192 = yaw_per_v_delta * (t175 + K0_12_w);
    const float K0_22_c = wx_delta2_delta * K0_12_c;
    const float t194 = yaw_per_v_delta * K0_12_c;
    const float t195 = wx_delta2_delta * t56;
    const float C1_21_lam = t160 + (t81 * t195);
    const float K0_12_zH = p->mH * wx_delta2_delta;
    const float t203 = t129 + (t46 * K0_12_zH) - t120 - (t74 * t195);
    const float M_12_zH = t137 + (p->zH * K0_12_zH);
    const float M_22_zH = t177 * K0_12_zH;
    const float t207 = yaw_per_v_delta * K0_12_zH;
    const float t208 = t76 * t207;
    const float t210 = (t36 * t110) + t169;
    const float t211 = t36 * t176;
    const float t212 = t76 * t211;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float C1_12_mR = p->c * K2_12_mR;
    const float t215 = p->zB * yaw_per_v_delta;
    const float t216 = p->mB * t215;
    const float t217 = t215 * t75;
    const float t218 = p->mB * yaw_per_v_delta;
    const float t219 = t75 * t218;
    const float t220 = p->c * t218;
    const float t221 = wx_delta2_delta * t220;
    const float K2_22_xB = yaw_per_v_delta * t220;
    const float t223 = p->mH * wz_delta2_delta;
    const float t224 = t177 * t223;
    const float t225 = wx_delta2_delta * t223;
    const float M_22_w = (t176 * t177) - (t210 * t161);
    const float t235 = (wz_delta2_delta * t55) + (t45 * (t137 - t94)) + t110 + (p->c * t210);
    const float K2_22_lam = (yaw_per_v_delta * (t149 + t203)) - (wx_delta2_delta * t175);
    const float C1_22_xB = (p->xB + t75) * K2_22_xB;
    const float K2_22_xH = yaw_per_v_delta * t223;
    const float t243 = t137 + t210;
    const float M_22_c = wx_delta2_delta_lam * (t243 + t243);
    const float t247 = t210 - (t56 * K0_12);
    const float t252 = yaw_per_v_delta * (t94 + t157 + t247 + (p->c * K0_12_w));
    const float K0_22_lam = (wx_delta2_delta_lam * K0_12) - (wx_delta2_delta * t203);
    const float t256 = t156 + t247;
    const float C1_22_lam = (wx_delta2_delta_lam * (t105 + t129 + (t56 * t203))) -
        (wx_delta2_delta * (t169 + t256));
    const float C1_22 = wx_delta2_delta_lam * t256;
    const float M_12_rF = t156 + t156;
    const float M_22_rF = wx_delta2_delta * M_12_rF;
    const float t267 = p->zH * yaw_per_v_delta;
    const float t268 = p->mH * t267;
    const float t269 = t267 * t76;
    const float C1_22_IHzz = yaw_per_v_delta * wz_delta2_delta;
    const float M_12_yaw_per_v_delta = t76 * C1_22_IHzz;
    const float C1_22_xH = p->mH * (M_12_yaw_per_v_delta - t178);
    const float K2_22_SF = wx_delta2_delta * yaw_per_v_delta;
    const float K2_22_rF = K2_22_SF * t80;
    const float K2_22_IFyy = t57 * K2_22_SF;
    const float M_22 = (wx_delta2_delta * ST) + (wx_delta2_delta_lam * t235);
    const float t282 = (wx_delta2_delta_lam * ST) - (wx_delta2_delta * t235);
    const float C1_12_IFyy = wz_delta2_delta * t57;
    const float C1_21_rF = SF * C1_12_IFyy;
    const float M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const float K0_22_zH = p->mH * M_22_IHxx;
    const float M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const float M_22_mF = M_11_mF * M_22_IHxx;
    const float t289 = wx_delta2_delta * wz_delta2_delta;
    const float M_22_IHxz = t289 + t289;
    const float t291 = p->mF * wx_delta2_delta;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float C1_22_rF = wz_delta2_delta * t291;
    const float t294 = wx_delta2_delta * t291;
    const float C1_12_mF = p->rF * wz_delta2_delta;
    const float M_22_lam = t282 + t282;
    const float C1_22_mF = wx_delta2_delta * C1_12_mF;
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
    derivatives->values[10] = M_11_mB;
    derivatives->values[11] = M_11_mH;
    derivatives->values[12] = M_11_mF;
    derivatives->values[13] = M_11_rR;
    derivatives->values[14] = M_11_mR;
    derivatives->values[15] = M_11_zH;
    derivatives->values[16] = M_11_rF;
    derivatives->values[17] = M_11_zB;
    derivatives->values[18] = M_12_c;
    derivatives->values[19] = yaw_per_v_delta;
    derivatives->values[20] = K0_12_mH;
    derivatives->values[21] = K2_12_IRyy;
    derivatives->values[22] = K2_12_rF;
    derivatives->values[23] = M_12_lam;
    derivatives->values[24] = K2_12_rR;
    derivatives->values[25] = K2_12_mF;
    derivatives->values[26] = K2_12_IFyy;
    derivatives->values[27] = mu;
    derivatives->values[28] = C1_12_rR;
    derivatives->values[29] = t113;
    derivatives->values[30] = C1_12_IRyy;
    derivatives->values[31] = C1_21_rR;
    derivatives->values[32] = M_22_IRxx;
    derivatives->values[33] = C1_22_IRxx;
    derivatives->values[34] = wz_delta2_delta;
    derivatives->values[35] = t119;
    derivatives->values[36] = M_12_w;
    derivatives->values[37] = t126;
    derivatives->values[38] = t130;
    derivatives->values[39] = K2_12;
    derivatives->values[40] = t132;
    derivatives->values[41] = M_12_mH;
    derivatives->values[42] = M_22_mH;
    derivatives->values[43] = K0_22_mH;
    derivatives->values[44] = C1_12_rF;
    derivatives->values[45] = t144;
    derivatives->values[46] = t145;
    derivatives->values[47] = t146;
    derivatives->values[48] = C1_21_w;
    derivatives->values[49] = t152;
    derivatives->values[50] = M_12_mF;
    derivatives->values[51] = t154;
    derivatives->values[52] = K2_22_mF;
    derivatives->values[53] = M_22_xB;
    derivatives->values[54] = t163;
    derivatives->values[55] = t164;
    derivatives->values[56] = M_22_mB;
    derivatives->values[57] = t171;
    derivatives->values[58] = K2_22_mB;
    derivatives->values[59] = C1_22_mB;
    derivatives->values[60] = t178;
    derivatives->values[61] = t179;
    derivatives->values[62] = K0_12_w;
    derivatives->values[63] = K0_12_c;
    derivatives->values[64] = t188;
    derivatives->values[65] = K0_22_w;
    derivatives->values[66] = t192;
    derivatives->values[67] = K0_22_c;
    derivatives->values[68] = t194;
    derivatives->values[69] = C1_21_lam;
    derivatives->values[70] = K0_12_zH;
    derivatives->values[71] = t203;
    derivatives->values[72] = M_12_zH;
    derivatives->values[73] = M_22_zH;
    derivatives->values[74] = t207;
    derivatives->values[75] = t208;
    derivatives->values[76] = t211;
    derivatives->values[77] = t212;
    derivatives->values[78] = K2_12_mR;
    derivatives->values[79] = C1_12_mR;
    derivatives->values[80] = t215;
    derivatives->values[81] = t216;
    derivatives->values[82] = t217;
    derivatives->values[83] = t218;
    derivatives->values[84] = t219;
    derivatives->values[85] = t220;
    derivatives->values[86] = t221;
    derivatives->values[87] = K2_22_xB;
    derivatives->values[88] = t223;
    derivatives->values[89] = t224;
    derivatives->values[90] = t225;
    derivatives->values[91] = M_22_w;
    derivatives->values[92] = K2_22_lam;
    derivatives->values[93] = C1_22_xB;
    derivatives->values[94] = K2_22_xH;
    derivatives->values[95] = M_22_c;
    derivatives->values[96] = t252;
    derivatives->values[97] = K0_22_lam;
    derivatives->values[98] = C1_22_lam;
    derivatives->values[99] = M_12_rF;
    derivatives->values[100] = M_22_rF;
    derivatives->values[101] = t267;
    derivatives->values[102] = t268;
    derivatives->values[103] = t269;
    derivatives->values[104] = C1_22_IHzz;
    derivatives->values[105] = C1_22_xH;
    derivatives->values[106] = K2_22_SF;
    derivatives->values[107] = K2_22_rF;
    derivatives->values[108] = K2_22_IFyy;
    derivatives->values[109] = C1_12_IFyy;
    derivatives->values[110] = C1_21_rF;
    derivatives->values[111] = M_22_IHxx;
    derivatives->values[112] = K0_22_zH;
    derivatives->values[113] = M_22_IHzz;
    derivatives->values[114] = M_22_mF;
    derivatives->values[115] = M_22_IHxz;
    derivatives->values[116] = t291;
    derivatives->values[117] = M_22_IFxx;
    derivatives->values[118] = C1_22_rF;
    derivatives->values[119] = t294;
    derivatives->values[120] = C1_12_mF;
    derivatives->values[121] = M_22_lam;
    derivatives->values[122] = C1_22_mF;
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

static void whipple_mechanism_f32_compute_linearization(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], const float forces[WHIPPLE_MECHANISM_FORCES],
    whipple_mechanism_f32_linearization_t *linearization)
{
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t6 = motion->constants[7] * sin_phi;
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t14 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    float sin_delta = 0.0F;
    float cos_delta = 0.0F;
    carvallo_sin_cos_f32(positions[5], &sin_delta, &cos_delta);
    const float t18 = t14 * cos_phi;
    const float t21 = sin_phi * sin_delta;
    const float t22 = t21 - (cos_delta * t18);
    const float t26 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
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
    const float t42 = motion->constants[10] * t41;
    const float t45 = sin_delta * motion->constants[25];
    const float t51 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const float t53 = (t26 * motion->constants[27]) - (t14 * t51);
    const float t56 = (cos_phi * t45) - (t37 * t42) - (sin_phi * t53);
    const float t57 = t6 + t56;
    const float t58 = sin_delta * t34;
    const float t62 = (t26 * t32) + (t14 * t35);
    const float t64 = (cos_phi * t58) + (sin_phi * t62);
    const float t69 = (t42 * t64) + (t14 * motion->constants[27]) + (t26 * t51);
    const float t71 = 1.0F / (cos_phi * t69);
    const float t72 = t57 * t71;
    const float t78 = (t26 * motion->constants[24]) - (t14 * motion->constants[23]);
    const float t80 = t56 + (sin_phi * t78);
    const float t82 = sin_phi * t26;
    const float t85 = (t14 * motion->constants[24]) + (t26 * motion->constants[23]);
    const float t86 = t69 - t85;
    const float t89 = t71 * ((t14 * t80) + (t82 * t86));
    const float t91 = (speeds[0] * t72) + (speeds[1] * t89);
    const float t92 = speeds[2] + t91;
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
    const float t108 = sin_phi * motion->constants[27];
    const float t110 = t26 * t72;
    const float t111 = sin_phi * t51;
    const float t113 = t37 * motion->constants[10];
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
    const float t176 = motion->constants[10] * t64;
    const float t180 = sin_phi * t32;
    const float t182 = sin_phi * t35;
    const float t185 = t117 + t125;
    const float t191 = (cos_phi * t62) + (t110 * t182) + (t82 * t153) - (sin_phi * t58) - (t107 *
        t180) - (t162 * t185);
    const float t195 = (motion->constants[27] * t110) + (t120 * t176) + (t42 * t191) - (t51 * t107);
    const float t199 = (t99 * t100) + (motion->constants[7] * cos_phi * t71) + (t71 * t171) -
        (t173 * t195);
    const float t201 = t71 * t89;
    const float t203 = t26 * t86;
    const float t205 = t14 * t71;
    const float t211 = t71 * t82;
    const float t213 = sin_phi * motion->constants[24];
    const float t216 = (sin_phi * t71 * t86) + (t205 * t213) - (motion->constants[23] * t211);
    const float t220 = sin_phi * motion->constants[23];
    const float t223 = (t71 * t80) - (motion->constants[24] * t211) - (t205 * t220);
    const float t227 = t211 - (cos_phi * t201);
    const float t231 = (t100 * t201) + (cos_phi * ((t71 * t203) + (t78 * t205))) + (t110 * t223) +
        (t171 * t205);
    const float t233 = t231 + (t195 * t227) - (t107 * t216);
    const float t235 = (speeds[0] * t199) + (speeds[1] * t233);
    const float t238 = t14 * motion->constants[25];
    const float t240 = t14 * t89;
    const float t242 = t26 * t89;
    const float t245 = (t117 * t242) - t22;
    const float t247 = sin_delta * t26;
    const float t260 = (t39 * t138) + (t40 * t138) - (t143 * t240) - (t145 * t242);
    const float t264 = (t31 * t39) + (t31 * t40) - (t128 * t242) - (t131 * t260);
    const float t268 = (t157 * t240) + (t159 * t260);
    const float t273 = (t34 * t247) + (t35 * t240) + (t32 * t242) + (t14 * t264) + (t155 * t268);
    const float t279 = (motion->constants[25] * t114) + (t108 * t240) + (t111 * t242) + (t42 *
        t273) - (t21 * t238) - (t113 * t245);
    const float t286 = sin_phi * t14;
    const float t296 = (t34 * t114) + (t182 * t242) + (t82 * t264) - (t58 * t286) - (t180 * t240) -
        (t185 * t268);
    const float t301 = (motion->constants[27] * t242) + (t176 * t245) + (t42 * t296) -
        (motion->constants[25] * t247) - (t51 * t240);
    const float t303 = (t71 * t279) - (t173 * t301);
    const float t311 = (t223 * t242) + (t205 * t279) + (t227 * t301) - (t216 * t240);
    const float t313 = (speeds[0] * t303) + (speeds[1] * t311);
    const float t318 = motion->constants[7] * sin_psi;
    const float t325 = (t37 * t69) + (t57 * t64);
    const float t326 = 1.0F / t325;
    const float t327 = motion->constants[7] * t64;
    const float t328 = t326 * t327;
    const float t329 = t326 * t328;
    const float t330 = speeds[2] * t329;
    const float t339 = (cos_phi * t327) + (t64 * t171) + (t57 * t191) + (t37 * t195) - (t69 * t166);
    const float t341 = motion->constants[7] * t326;
    const float t342 = speeds[2] * t341;
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
    const float t387 = t106 + (t30 * motion->constants[10]) - (cos_phi * t78);
    const float t390 = (t26 * t387) + (t27 * t78);
    const float t397 = (cos_phi * t86) - (t27 * motion->constants[23]);
    const float t403 = (sin_phi * t387) + (cos_phi * t80) + (t27 * t213);
    const float t407 = (cos_phi * motion->constants[27]) - (cos_phi * motion->constants[24]);
    const float t410 = (t371 * t397) + (t373 * t403) + (t379 * t407);
    const float t413 = t387 + (t27 * motion->constants[24]);
    const float t415 = t27 * t220;
    const float t419 = (cos_phi * motion->constants[23]) - (cos_phi * t51);
    const float t422 = (t379 * t419) - (t371 * t413) - (t373 * t415);
    const float t424 = motion->constants[10] * t379;
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
    const float t488 = motion->constants[25] * t39;
    const float t490 = t238 * t117;
    const float t506 = (t379 * t488) + (t379 * t490) + (t242 * t422) + (t260 * t424) + (t279 *
        t431) + (t296 * t436);
    const float t511 = t506 + (t301 * t438) + (t440 * t481) + (t311 * t363) - (t240 * t410) -
        (t273 * t429);
    const float t512 = t511 - (t448 * t472);
    const float t516 = (t330 * t472) - ((t296 * t342) + (speeds[0] * t486) + (speeds[1] * t512));
    const float t518 = 1.0F / motion->constants[10];
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
    const float t594 = motion->constants[10] * t573;
    const float t597 = t27 * t37;
    const float t600 = t27 * t64;
    const float t608 = (cos_phi * ((t37 * t390) + (t45 * t573))) + (t110 * t592) + (t149 * t594) +
        (t171 * t597);
    const float t612 = t608 + (t447 * t537) + (t461 * t523) - (sin_phi * ((t37 * t374) + (t376 *
        t573) - (t64 * t203))) - (t107 * t586);
    const float t617 = t612 - (t166 * t435) - (t191 * t428) - (t195 * t600) - (t89 * t556) - (t233 *
        t561);
    const float t620 = (speeds[2] * t543) + (t545 * t566) + (t568 * t617);
    const float t629 = (t57 * t273) + (t69 * t296) + (t64 * t301) - (t37 * t279);
    const float t634 = (t296 * t525) + (t527 * t629) - (t273 * t519) - (t472 * t539);
    const float t642 = (t273 * t351) + (t100 * t296) + (t301 * t345) - (t279 * t353);
    const float t649 = (t364 * t629) + (t486 * t523) - (t72 * t642) - (t303 * t561);
    const float t668 = (t488 * t573) + (t490 * t573) + (t242 * t592) + (t260 * t594) + (t279 *
        t597) + (t447 * t629);
    const float t673 = t668 + (t512 * t523) - (t240 * t586) - (t273 * t435) - (t296 * t428) -
        (t301 * t600);
    const float t675 = t673 - (t89 * t642) - (t311 * t561);
    const float t678 = (speeds[2] * t634) + (t545 * t649) + (t568 * t675);
    const float t682 = t518 * ((t364 * t523) - (t72 * t561));
    const float t690 = t518 * ((t37 * t435) + (t447 * t523) - (t64 * t428) - (t89 * t561));
    const float t693 = t518 * (t528 + (t328 * t523));
    const float t697 = sin_delta * motion->constants[41];
    const float t698 = sin_delta * t697;
    const float t702 = motion->constants[32] + motion->constants[36] + motion->constants[43] - t698;
    const float t704 = cos_delta * motion->constants[34];
    const float t705 = motion->constants[23] * t704;
    const float t708 = t705 + t705 + motion->constants[46];
    const float t711 = motion->constants[33] + motion->constants[39];
    const float t712 = t708 + t711;
    const float t713 = t712 - t702;
    const float t714 = t14 * t14;
    const float t716 = t14 * t26;
    const float t718 = motion->constants[24] * t704;
    const float t722 = cos_delta * motion->constants[37];
    const float t723 = motion->constants[30] + t722;
    const float t726 = t723 - motion->constants[44] - t718 - motion->constants[45];
    const float t727 = t726 + t726;
    const float t729 = (t713 * t714) + (t716 * t727);
    const float t735 = t704 + motion->constants[42] + motion->constants[28];
    const float t737 = (t26 * motion->constants[47]) - (t14 * t735);
    const float t738 = motion->constants[7] * t737;
    const float t741 = motion->constants[49] - t738 - t738;
    const float t743 = sin_delta * motion->constants[34];
    const float t745 = (sin_delta * motion->constants[37]) - (motion->constants[24] * t743);
    const float t749 = (cos_delta * t697) - (motion->constants[23] * t743);
    const float t751 = (t14 * t745) + (t26 * t749);
    const float t753 = t72 - (sin_phi * t364);
    const float t763 = t726 + (t713 * t716) + (motion->constants[7] * ((t14 *
        motion->constants[47]) + (t26 * t735))) - (t714 * t727);
    const float t764 = cos_phi * t364;
    const float t772 = t698 + motion->constants[43] + t708 + t741 + motion->constants[31] +
        motion->constants[38];
    const float t776 = motion->constants[7] * t743;
    const float t778 = (t26 * t745) + t776 - (t14 * t749);
    const float t784 = t712 - t729;
    const float t790 = t753 * motion->constants[21];
    const float t796 = t682 + (cos_delta * t753) - t247 - (t115 * t764);
    const float t798 = t796 * motion->constants[22];
    const float t804 = t702 + t729 + t741 + (t751 * t753) + (t753 * (t751 + (t753 * t772) - (t764 *
        t778))) + (t753 * t790);
    const float t807 = t804 + (t796 * t798) - (t763 * t764) - (t764 * (t763 + (t753 * t778) -
        (t764 * t784)));
    const float t808 = 1.0F / t807;
    const float t809 = speeds[0] * t26;
    const float t814 = (speeds[0] * t364) + (speeds[1] * t447) + (speeds[2] * t328);
    const float t815 = cos_phi * t814;
    const float t817 = t809 + (t14 * t815);
    const float t818 = sin_phi * t814;
    const float t819 = t91 - t818;
    const float t823 = (motion->constants[31] * t819) + (motion->constants[21] * (speeds[2] +
        t819));
    const float t827 = speeds[0] * t14;
    const float t828 = t827 - (t26 * t815);
    const float t829 = motion->constants[30] * t828;
    const float t830 = (motion->constants[32] * t817) + t829;
    const float t832 = (t817 * t823) - (t819 * t830);
    const float t835 = (cos_delta * t817) + (sin_delta * t819);
    const float t838 = (cos_delta * t819) - (sin_delta * t817);
    const float t844 = (speeds[0] * t682) + (speeds[1] * t690) + (speeds[2] * t693);
    const float t845 = t838 + t844;
    const float t847 = (motion->constants[38] * t838) + (motion->constants[22] * t845);
    const float t850 = speeds[1] + t828;
    const float t851 = motion->constants[37] * t850;
    const float t852 = (motion->constants[36] * t835) + t851;
    const float t854 = (t835 * t847) - (t838 * t852);
    const float t855 = motion->constants[7] * t818;
    const float t856 = t815 * t855;
    const float t858 = sin_phi * motion->constants[40];
    const float t859 = t92 * t815;
    const float t862 = t856 - (motion->constants[7] * t859);
    const float t863 = t858 + t862;
    const float t865 = t91 * t828;
    const float t866 = speeds[0] * t818;
    const float t867 = motion->constants[24] * t819;
    const float t869 = motion->constants[23] * t819;
    const float t871 = (t828 * t867) + (t817 * t869);
    const float t873 = t91 * t817;
    const float t874 = (t26 * t866) + t873;
    const float t877 = t865 + (t14 * t866);
    const float t881 = t871 + (motion->constants[23] * t874) + (motion->constants[24] * t877) -
        t862;
    const float t884 = motion->constants[23] * t828;
    const float t885 = motion->constants[24] * t817;
    const float t886 = t884 - t885;
    const float t888 = (t819 * t869) + (t828 * t886);
    const float t889 = speeds[0] * t815;
    const float t892 = motion->constants[7] * speeds[0];
    const float t893 = t815 * t892;
    const float t894 = (motion->constants[7] * t889) + t893;
    const float t897 = t92 - t818;
    const float t899 = (t855 * t897) - (speeds[0] * t892);
    const float t903 = (t26 * t894) + (t14 * t899) - t888 - (motion->constants[24] * t889);
    const float t906 = t838 * motion->constants[26];
    const float t908 = motion->constants[25] * t838;
    const float t911 = cos_delta * t877;
    const float t912 = sin_delta * t889;
    const float t913 = speeds[1] * t838;
    const float t915 = t913 - t911 - t912;
    const float t917 = t32 * motion->constants[10];
    const float t919 = t874 + (t835 * t844);
    const float t921 = t34 * motion->constants[10];
    const float t923 = t915 - (t844 * t850);
    const float t925 = t31 * t41;
    const float t928 = (t32 * t835) + (t34 * t850);
    const float t930 = motion->constants[10] * t925 * t928;
    const float t931 = t34 * t930;
    const float t933 = t32 * t930;
    const float t939 = (cos_delta * t881) + (t850 * t906) + (t835 * t908) + (motion->constants[25] *
        t874) + (t917 * t919) + (t850 * t931);
    const float t943 = t939 + (t835 * t933) - (sin_delta * t903) - (motion->constants[26] * t915) -
        (t921 * t923);
    const float t948 = motion->constants[25] * t850;
    const float t949 = t835 * motion->constants[26];
    const float t950 = t948 - t949;
    const float t954 = speeds[1] * t835;
    const float t956 = (sin_delta * t877) - (cos_delta * t889) - t954;
    const float t963 = motion->constants[10] * ((t32 * t850) - (t34 * t835));
    const float t969 = (cos_delta * t903) + (sin_delta * t881) + (motion->constants[26] * t956) +
        (t921 * t956) - (t838 * t908) - (t850 * t950);
    const float t971 = t969 - (t845 * t933) - (t850 * t963);
    const float t975 = (t817 * t886) - (t819 * t867);
    const float t989 = t975 + (motion->constants[23] * t889) + (t14 * t894) + (t835 * t950) +
        (t835 * t963) - (t26 * t899);
    const float t993 = t989 - (t838 * t906) - (motion->constants[25] * t956) - (t917 * t956) -
        (t845 * t931);
    const float t995 = (t32 * t971) + (t34 * t993);
    const float t1000 = t71 * ((t41 * t943) + (t30 * t995));
    const float t1004 = t326 * ((t30 * t943) + (t362 * t1000) - (t41 * t995));
    const float t1006 = t866 - (cos_phi * t1004);
    const float t1008 = t865 + (t14 * t1006);
    const float t1011 = t873 + (t26 * t1006);
    const float t1017 = t871 + (motion->constants[23] * t1011) + (motion->constants[24] * t1008) -
        t863;
    const float t1020 = t889 - t1000;
    const float t1021 = (sin_phi * t1004) + t1020;
    const float t1024 = (motion->constants[7] * t1021) + t893;
    const float t1027 = t899 + (cos_phi * motion->constants[40]);
    const float t1028 = t14 * t1027;
    const float t1029 = t1028 + (t26 * t1024);
    const float t1031 = t1029 - (motion->constants[24] * t1021) - t888;
    const float t1033 = (cos_delta * t1017) - (sin_delta * t1031);
    const float t1038 = t913 - (sin_delta * t1021) - (cos_delta * t1008);
    const float t1043 = t854 + (motion->constants[34] * t1033) + (motion->constants[37] * t1038) +
        (motion->constants[39] * t1011);
    const float t1047 = (cos_delta * t1031) + (sin_delta * t1017);
    const float t1053 = (sin_delta * t1008) - (cos_delta * t1021) - t954;
    const float t1055 = motion->constants[34] * t838;
    const float t1057 = motion->constants[34] * t850;
    const float t1058 = t835 * motion->constants[35];
    const float t1059 = t1057 - t1058;
    const float t1061 = (t838 * t1055) + (t850 * t1059);
    const float t1063 = (motion->constants[17] * t1047) + (motion->constants[35] * t1053) - t1061;
    const float t1068 = t838 * motion->constants[35];
    const float t1071 = (t850 * t1068) + (t835 * t1055);
    const float t1074 = (t1033 * motion->constants[17]) + (motion->constants[34] * t1011) + t1071 -
        (t1038 * motion->constants[35]);
    const float t1076 = (sin_delta * t1063) + (cos_delta * t1074);
    const float t1082 = t832 + (motion->constants[33] * t1011) + t1043 + (motion->constants[23] *
        t1076) - (motion->constants[28] * t863) - (motion->constants[30] * t1008);
    const float t1088 = motion->constants[30] * t817;
    const float t1090 = t1088 + (motion->constants[33] * t828);
    const float t1093 = (t819 * t1090) - (t823 * t828);
    const float t1097 = motion->constants[37] * t835;
    const float t1099 = t1097 + (motion->constants[39] * t850);
    const float t1102 = (t838 * t1099) - (t847 * t850);
    const float t1105 = (motion->constants[36] * t1038) + (motion->constants[37] * t1011) + t1102 -
        (t1033 * motion->constants[35]);
    const float t1109 = t26 * t1027;
    const float t1111 = t1109 - (t14 * t1024);
    const float t1113 = t975 + (motion->constants[23] * t1021) - t1111;
    const float t1123 = t518 * ((t32 * t993) + (t523 * t1004) - (t34 * t971) - (t561 * t1000));
    const float t1125 = motion->constants[22] * (t1053 + t1123);
    const float t1128 = (t850 * t852) - (t835 * t1099);
    const float t1132 = (t1047 * motion->constants[35]) + (motion->constants[38] * t1053) + t1125 +
        t1128 - (motion->constants[34] * t1113);
    const float t1139 = (t863 * motion->constants[29]) + (motion->constants[30] * t1011) + t1093 +
        (cos_delta * t1105) - (motion->constants[32] * t1008) - (sin_delta * t1132);
    const float t1140 = t1139 - (motion->constants[24] * t1076);
    const float t1146 = t819 * motion->constants[29];
    const float t1148 = motion->constants[28] * t819;
    const float t1154 = t1076 + (motion->constants[28] * t1011) + (t1008 * motion->constants[29]) +
        (t828 * t1146) + (t817 * t1148) - (t863 * motion->constants[1]);
    const float t1161 = (t828 * t830) - (t817 * t1090);
    const float t1166 = (cos_delta * t1063) - (sin_delta * t1074);
    const float t1172 = (t835 * t1059) - (t838 * t1068);
    const float t1174 = (motion->constants[17] * t1113) + t1172 - (motion->constants[34] * t1053);
    const float t1179 = motion->constants[28] * t828;
    const float t1180 = t817 * motion->constants[29];
    const float t1181 = t1179 - t1180;
    const float t1184 = (t817 * t1181) - (t819 * t1146);
    const float t1193 = (t819 * t1148) + (t828 * t1181);
    const float t1198 = (t14 * (t1174 + t1184 - (t1111 * motion->constants[1]) +
        (motion->constants[28] * t1021))) + (t26 * (t1166 + (t1029 * motion->constants[1]) -
        (t1021 * motion->constants[29]) - t1193));
    const float t1200 = (motion->constants[21] * t1021) + (motion->constants[7] * t1198);
    const float t1205 = (t1029 * motion->constants[29]) + (motion->constants[28] * t1111) -
        (motion->constants[31] * t1021) + t1161 + (sin_delta * t1105) + (cos_delta * t1132);
    const float t1208 = t1205 + (motion->constants[24] * t1166) - t1200 - (motion->constants[23] *
        t1174);
    const float t1212 = (t26 * t1082) - (t14 * t1140);
    const float t1219 = forces[0] + (t764 * t1212) - (t14 * t1082) - (t26 * t1140) -
        (motion->constants[7] * t1154) - (t753 * t1208);
    const float t1220 = t1219 - (t682 * t1125);
    const float t1222 = t705 + motion->constants[39];
    const float t1224 = t722 - t718;
    const float t1228 = t89 - (sin_phi * t447);
    const float t1230 = cos_phi * t447;
    const float t1232 = t26 * t743;
    const float t1233 = motion->constants[7] * t1232;
    const float t1234 = t745 + t1233;
    const float t1238 = t1234 + (t772 * t1228) - (t778 * t1230);
    const float t1242 = (t26 * t1222) - (t14 * t1224);
    const float t1246 = t1242 + (t778 * t1228) - (t784 * t1230);
    const float t1252 = t690 + (cos_delta * t1228) - (t115 * t1230);
    const float t1258 = (t14 * t1222) + (t26 * t1224) + (motion->constants[7] * t704) + (t751 *
        t1228) + (t753 * t1238) + (t790 * t1228);
    const float t1262 = t808 * (t1258 + (t798 * t1252) - (t763 * t1230) - (t764 * t1246));
    const float t1267 = motion->constants[21] * t1228;
    const float t1269 = motion->constants[22] * t1252;
    const float t1271 = t807 * t1262;
    const float t1277 = motion->constants[39] + (t1228 * t1238) + (t1228 * t1234) + (t1228 *
        t1267) + (t1252 * t1269) - (t1230 * t1246);
    const float t1279 = t1277 - (t1230 * t1242) - (t1262 * t1271);
    const float t1280 = 1.0F / t1279;
    const float t1290 = forces[1] + (t1212 * t1230) - t1043 - (t1208 * t1228) - (t690 * t1125) -
        (t1220 * t1262);
    const float t1294 = motion->constants[7] * (t737 - motion->constants[48]);
    const float t1295 = sin_phi * t328;
    const float t1297 = cos_phi * t328;
    const float t1300 = t1294 + (t772 * t1295) + (t778 * t1297);
    const float t1305 = t776 - (t778 * t1295) - (t784 * t1297);
    const float t1309 = 1.0F - t1295;
    const float t1314 = t693 - (cos_delta * t1295) - (t115 * t1297);
    const float t1326 = (t790 * t1309) + (t798 * t1314) - (t751 * t1295) - (t763 * t1297) - (t753 *
        t1300) - (t764 * t1305);
    const float t1327 = t808 * t1326;
    const float t1333 = t1233 + (t1267 * t1309) + (t1269 * t1314) - (t1228 * t1300) - (t1230 *
        t1305) - (t1234 * t1295);
    const float t1336 = t1280 * (t1333 - (t1242 * t1297) - (t1271 * t1327));
    const float t1346 = (t1208 * t1295) + (t1212 * t1297) + t1200 - (t693 * t1125) - (t1220 *
        t1327) - (t1290 * t1336);
    const float t1364 = (t1295 * t1300) + (t1294 * t1295) + motion->constants[50] +
        (motion->constants[21] * t1309 * t1309) + (motion->constants[22] * t1314 * t1314) - (t1297 *
        t1305);
    const float t1368 = 1.0F / (t1364 - (t776 * t1297) - (t807 * t1327 * t1327) - (t1279 * t1336 *
        t1336));
    const float t1369 = t1346 * t1368;
    const float t1371 = (t1280 * t1290) - (t1336 * t1369);
    const float t1375 = (t808 * t1220) - (t1262 * t1371) - (t1327 * t1369);
    const float t1379 = t856 + t858 - (motion->constants[7] * (t859 + t1375));
    const float t1387 = t1004 + (t364 * t1375) + (t447 * t1371) + (t328 * t1369);
    const float t1389 = t866 - (cos_phi * t1387);
    const float t1392 = (t26 * t1375) - t865 - (t14 * t1389);
    const float t1397 = t873 + (t26 * t1389) + (t14 * t1375);
    const float t1403 = t871 + (motion->constants[23] * t1397) - t1379 - (motion->constants[24] *
        t1392);
    const float t1410 = (t72 * t1375) + (t89 * t1371) - (sin_phi * t1387) - t1020;
    const float t1412 = t1369 + t1410;
    const float t1414 = (motion->constants[7] * t1412) - t893;
    const float t1416 = t1028 - (t26 * t1414);
    const float t1418 = (motion->constants[24] * t1410) + t1416 - t888;
    const float t1420 = (cos_delta * t1403) - (sin_delta * t1418);
    const float t1424 = (cos_delta * t1392) + (sin_delta * t1410);
    const float t1425 = t913 + t1424;
    const float t1427 = t1371 + t1397;
    const float t1431 = (cos_delta * t1418) + (sin_delta * t1403);
    const float t1435 = (cos_delta * t1410) - (sin_delta * t1392);
    const float t1436 = t1435 - t954;
    const float t1439 = (motion->constants[17] * t1431) + (motion->constants[35] * t1436) - t1061;
    const float t1446 = t1071 + (motion->constants[17] * t1420) + (motion->constants[34] * t1427) -
        (motion->constants[35] * t1425);
    const float t1448 = (sin_delta * t1439) + (cos_delta * t1446);
    const float t1455 = t832 + t854 + (motion->constants[30] * t1392) + (motion->constants[33] *
        t1397) + (motion->constants[34] * t1420) + (motion->constants[37] * t1425) +
        (motion->constants[39] * t1427);
    const float t1457 = t1455 + (motion->constants[23] * t1448) - (motion->constants[28] * t1379);
    const float t1467 = t1102 + (motion->constants[36] * t1425) + (motion->constants[37] * t1427) -
        (motion->constants[35] * t1420);
    const float t1472 = t1109 + (t14 * t1414);
    const float t1474 = t975 - (motion->constants[23] * t1410) - t1472;
    const float t1484 = motion->constants[22] * (t1123 + t1436 + (t682 * t1375) + (t690 * t1371) +
        (t693 * t1369));
    const float t1488 = t1128 + (motion->constants[35] * t1431) + (motion->constants[38] * t1436) +
        t1484 - (motion->constants[34] * t1474);
    const float t1490 = (cos_delta * t1467) - (sin_delta * t1488);
    const float t1496 = t1093 + (motion->constants[29] * t1379) + (motion->constants[32] * t1392) +
        (motion->constants[30] * t1397) + t1490 - (motion->constants[24] * t1448);
    const float t1498 = (t26 * t1457) - (t14 * t1496);
    const float t1499 = sin_phi * t1498;
    const float t1507 = (sin_delta * t1467) + (cos_delta * t1488);
    const float t1510 = (cos_delta * t1439) - (sin_delta * t1446);
    const float t1515 = t1172 + (motion->constants[17] * t1474) - (motion->constants[34] * t1436);
    const float t1521 = t1184 + t1515 - (motion->constants[1] * t1472) - (motion->constants[28] *
        t1410);
    const float t1527 = t1510 + (motion->constants[1] * t1416) + (motion->constants[29] * t1410) -
        t1193;
    const float t1535 = t1161 + (motion->constants[29] * t1416) + (motion->constants[28] * t1472) +
        (motion->constants[31] * t1410) + (motion->constants[21] * t1412) + t1507;
    const float t1538 = t1535 + (motion->constants[24] * t1510) - (motion->constants[23] * t1515) -
        (motion->constants[7] * ((t14 * t1521) + (t26 * t1527)));
    const float t1539 = cos_phi * t1538;
    const float t1546 = (sin_phi * t1538) + (cos_phi * t1498);
    const float t1548 = t518 * t1484;
    const float t1550 = motion->constants[7] * t1527;
    const float t1552 = motion->constants[7] * t1521;
    const float t1554 = (t107 * t1550) - (t110 * t1552);
    const float t1558 = (t107 * t1457) + (t110 * t1496);
    const float t1560 = t326 * t995;
    const float t1561 = t524 * t1560;
    const float t1563 = t326 * t943;
    const float t1564 = t524 * t1563;
    const float t1567 = t41 * t326;
    const float t1568 = t971 * t1567;
    const float t1570 = (t518 * t993) - (t524 * t1568);
    const float t1573 = t993 * t1567;
    const float t1575 = (t518 * t971) + (t524 * t1573);
    const float t1577 = t518 * t1000;
    const float t1579 = t326 * t1000;
    const float t1580 = t524 * t1579;
    const float t1582 = t518 * t1004;
    const float t1584 = t326 * t1004;
    const float t1585 = t524 * t1584;
    const float t1588 = t518 * t1375;
    const float t1590 = t518 * t1371;
    const float t1596 = (t149 * t1564) + (t153 * t1570) + (t162 * t1575) + (t358 * t1580) + (t537 *
        t1582) + (t543 * t1369);
    const float t1601 = t1596 + (t566 * t1588) + (t617 * t1590) - (t120 * t1561) - (t556 * t1577) -
        (t339 * t1585);
    const float t1603 = sin_delta * motion->constants[22];
    const float t1605 = cos_delta * motion->constants[22];
    const float t1607 = t14 * t1603;
    const float t1611 = (t26 * t1603) + (t764 * t1607) - (t682 * motion->constants[22]) - (t753 *
        t1605);
    const float t1614 = t892 + t892;
    const float t1615 = t26 * t1614;
    const float t1617 = motion->constants[7] * t1387;
    const float t1621 = motion->constants[7] * t1375;
    const float t1622 = t26 * t1621;
    const float t1624 = motion->constants[7] * t1371;
    const float t1625 = t26 * t1624;
    const float t1631 = (t27 * t1617) + (t107 * t1414) + (t110 * t1027) - (t286 *
        motion->constants[40]) - (t818 * t1615) - (t199 * t1622);
    const float t1632 = t1631 - (t233 * t1625);
    const float t1633 = motion->constants[7] * t26;
    const float t1634 = motion->constants[1] * t1633;
    const float t1635 = motion->constants[29] - t1634;
    const float t1637 = cos_delta * motion->constants[35];
    const float t1638 = sin_delta * t1637;
    const float t1640 = cos_delta * motion->constants[17];
    const float t1641 = sin_delta * t1640;
    const float t1642 = t78 - motion->constants[7];
    const float t1644 = cos_delta * t1640;
    const float t1645 = t1633 * t1644;
    const float t1649 = (motion->constants[24] * t1644) + (cos_delta * t1637) - t1645;
    const float t1653 = (t14 * t1638) + (t85 * t1641);
    const float t1658 = sin_delta * motion->constants[35];
    const float t1659 = sin_delta * motion->constants[17];
    const float t1660 = t1633 * t1659;
    const float t1663 = t1660 - t1658 - (motion->constants[24] * t1659);
    const float t1669 = (t26 * motion->constants[34]) + (t14 * t1637) + (t85 * t1640);
    const float t1674 = (t26 * t1637) + (t1640 * t1642) + (t764 * t1669) - (t14 *
        motion->constants[34]) - (t753 * t1663);
    const float t1679 = (t26 * t1638) + (t1641 * t1642) + (t764 * t1653) - (t753 * t1649) -
        (sin_delta * t1674);
    const float t1680 = t1679 - (t753 * t1635);
    const float t1683 = t14 * t1614;
    const float t1688 = t14 * t1621;
    const float t1690 = t14 * t1624;
    const float t1696 = (t818 * t1683) + (t110 * t1414) + (t199 * t1688) + (t233 * t1690) - (t82 *
        motion->constants[40]) - (t18 * t1617);
    const float t1697 = t1696 - (t107 * t1027);
    const float t1698 = motion->constants[7] * t14;
    const float t1701 = (motion->constants[1] * t1698) + (motion->constants[17] * t1698);
    const float t1702 = t735 + t1701;
    const float t1704 = t14 * t743;
    const float t1707 = t1232 + (t764 * t1704) - (t753 * t1702);
    const float t1709 = t93 - t855;
    const float t1710 = t818 * t1709;
    const float t1711 = motion->constants[7] * t815;
    const float t1715 = t1710 + (cos_phi * (motion->constants[40] + (t814 * t1711)));
    const float t1721 = (t26 * motion->constants[28]) + (t14 * motion->constants[29]);
    const float t1723 = sin_delta * t1658;
    const float t1725 = sin_delta * t1659;
    const float t1727 = cos_delta * t1659;
    const float t1728 = t1633 * t1727;
    const float t1732 = (motion->constants[24] * t1727) + (cos_delta * t1658) - t1728;
    const float t1736 = (t14 * t1723) + (t85 * t1725);
    const float t1742 = (t26 * t1723) + (t1642 * t1725) + (t764 * t1736) + (cos_delta * t1674) -
        (t753 * t1732);
    const float t1746 = (motion->constants[7] * motion->constants[1]) + (t14 *
        motion->constants[28]) - (t26 * motion->constants[29]) - (t764 * t1721) - t1742;
    const float t1754 = (t82 * t1387) + (t809 * t815) + (t110 * t1375) - (t107 * t1389);
    const float t1759 = t743 * t1633;
    const float t1760 = t745 + t1759;
    const float t1766 = (t26 * t711) + (t85 * t704) - (t14 * t723);
    const float t1773 = (t704 * t1642) + (t764 * t1766) + (motion->constants[23] * t1742) -
        (motion->constants[7] * motion->constants[28]) - (t14 * t711) - (t26 * t723);
    const float t1774 = t1773 - (t753 * t1760);
    const float t1779 = t1389 + (t199 * t1375) + (t233 * t1371);
    const float t1780 = motion->constants[23] * motion->constants[34];
    const float t1781 = sin_delta * t1780;
    const float t1783 = motion->constants[31] + motion->constants[21];
    const float t1788 = (motion->constants[29] * t1633) - (motion->constants[28] * t1698) -
        (motion->constants[42] * t1698);
    const float t1792 = motion->constants[46] + t1783 + (cos_delta * t1780) - t1788;
    const float t1794 = t14 * t1781;
    const float t1797 = sin_delta * motion->constants[38];
    const float t1802 = (t1633 * t1637) - (motion->constants[34] * t1698);
    const float t1807 = t1780 + (motion->constants[24] * t1637) + (cos_delta *
        motion->constants[38]) - t1802;
    const float t1811 = (t14 * t1797) + (t85 * t1658);
    const float t1816 = t1611 + (t26 * t1797) + (t1642 * t1658) + (t764 * t1811) - (t753 * t1807);
    const float t1819 = cos_delta * motion->constants[36];
    const float t1823 = t1633 * t1658;
    const float t1826 = (sin_delta * motion->constants[36]) + (motion->constants[24] * t1658) -
        t1823;
    const float t1832 = (t26 * motion->constants[37]) - (t14 * t1819) - (t85 * t1637);
    const float t1837 = (t764 * t1832) - (t14 * motion->constants[37]) - (t26 * t1819) - (t1637 *
        t1642) - (t753 * t1826);
    const float t1843 = (t26 * t1781) + (t764 * t1794) + (motion->constants[24] * t1679) +
        (cos_delta * t1816) + (sin_delta * t1837) - (t753 * t1792);
    const float t1846 = t815 * t827;
    const float t1851 = (t286 * t1387) + t1846 + (t107 * t1375) + (t110 * t1389);
    const float t1857 = (t26 * motion->constants[30]) - (t14 * motion->constants[32]);
    const float t1866 = (motion->constants[7] * motion->constants[29]) + (t764 * t1857) +
        (cos_delta * t1837) - (t14 * motion->constants[30]) - (t26 * motion->constants[32]) -
        (motion->constants[24] * t1742);
    const float t1867 = t1866 - (sin_delta * t1816);
    const float t1873 = t341 * t1369;
    const float t1877 = t1584 + (t329 * t1369);
    const float t1885 = (t149 * t1563) + (t162 * t1573) + (t191 * t1873) + (t358 * t1579) + (t369 *
        t1375) + (t461 * t1371);
    const float t1888 = t1885 - (t120 * t1560) - (t153 * t1568) - (t339 * t1877);
    const float t1889 = t6 * t26;
    const float t1891 = t6 * t14;
    const float t1899 = (t1680 * t1889) + (t18 * t1867) - (t1707 * t1891) - (t27 * t1774) -
        (sin_phi * t1843);
    const float t1901 = t71 * t1000;
    const float t1903 = t71 * t943;
    const float t1905 = t71 * t995;
    const float t1907 = t30 * t71;
    const float t1908 = t971 * t1907;
    const float t1910 = t993 * t1907;
    const float t1912 = cos_phi * t1901;
    const float t1918 = (t100 * t1901) + (t120 * t1903) + (t149 * t1905) + (t153 * t1908) - (t162 *
        t1910) - (t195 * t1912);
    const float t1921 = (t363 * t524) - (t518 * t561);
    const float t1929 = t1843 + (t1611 * t1921) + (t1698 * t1707) + (t363 * t1899) - (t1633 *
        t1680);
    const float t1932 = motion->constants[23] + t1698;
    const float t1934 = motion->constants[25] + t917;
    const float t1935 = speeds[0] * cos_delta;
    const float t1938 = (t14 * t892) + (speeds[0] * t1932) + (t1934 * t1935);
    const float t1942 = motion->constants[10] * t956;
    const float t1943 = motion->constants[10] * t835;
    const float t1945 = (t850 * t1943) - t1942;
    const float t1947 = t845 * t930;
    const float t1949 = t1947 + (t835 * t1943);
    const float t1954 = (t107 * t899) + (t110 * t894) + (t153 * t1945) + (t162 * t1949) - (t818 *
        t1938);
    const float t1956 = t34 * t1567;
    const float t1958 = (t32 * t518) - (t524 * t1956);
    const float t1961 = t34 * t1907;
    const float t1964 = (t1611 * t1958) + (t1929 * t1961) - (t1899 * t1956);
    const float t1966 = motion->constants[26] + t921;
    const float t1967 = sin_delta * t1966;
    const float t1970 = t1633 - motion->constants[24];
    const float t1972 = (t26 * t892) + (speeds[0] * t1970);
    const float t1974 = (speeds[0] * t1967) - (sin_delta * t1972);
    const float t1977 = t809 * t1934;
    const float t1980 = (motion->constants[23] * t809) - t1711;
    const float t1981 = t814 * t1980;
    const float t1987 = motion->constants[23] * t866;
    const float t1990 = (t866 * t1934) + (cos_delta * t1987) - (sin_delta * t894);
    const float t1992 = sin_delta * t899;
    const float t1996 = (motion->constants[10] * t919) + (t835 * t930);
    const float t2000 = (t850 * t930) - (motion->constants[10] * t923);
    const float t2004 = (cos_phi * ((t814 * t1977) + (cos_delta * t1981))) + (t153 * t1996) -
        (t818 * t1974) - (cos_delta * t1710);
    const float t2007 = t2004 - (t107 * t1990) - (t110 * t1992) - (t162 * t2000);
    const float t2008 = t30 * t326;
    const float t2009 = t524 * t2008;
    const float t2012 = t41 * t71;
    const float t2015 = (t1611 * t2009) + (t1899 * t2008) + (t1929 * t2012);
    const float t2019 = (cos_delta * t1972) - (t1935 * t1966);
    const float t2025 = (cos_delta * t894) + (sin_delta * t1987);
    const float t2027 = cos_delta * t899;
    const float t2029 = motion->constants[10] * t850;
    const float t2031 = t1947 + (t850 * t2029);
    const float t2034 = t1942 + (t835 * t2029);
    const float t2040 = (t117 * t1981) + (t110 * t2027) - (t818 * t2019) - (sin_delta * t1710) -
        (t107 * t2025) - (t153 * t2031);
    const float t2041 = t2040 - (t162 * t2034);
    const float t2043 = t32 * t1567;
    const float t2045 = (t34 * t518) + (t524 * t2043);
    const float t2048 = t32 * t1907;
    const float t2051 = (t1929 * t2048) - (t1611 * t2045) - (t1899 * t2043);
    const float t2053 = t31 * t928;
    const float t2055 = t925 * t2053;
    const float t2057 = t835 * t925;
    const float t2059 = t850 * t925;
    const float t2063 = (t120 * t2053) + (t153 * t2057) - (t149 * t2055) - (t162 * t2059);
    const float t2064 = t845 * t921;
    const float t2068 = (t850 * t921) + (t835 * t917);
    const float t2069 = t2015 * t2068;
    const float t2070 = t845 * t917;
    const float t2073 = t2069 - (t1964 * t2064) - (t2051 * t2070);
    const float t2076 = (motion->constants[7] * t897) - t855;
    const float t2077 = t815 * t2076;
    const float t2086 = (t14 * t1680) + (t26 * t1707) + (t124 * t2051) - (t26 * t1964) - (t115 *
        t2015);
    const float t2089 = t1846 + (t110 * t866);
    const float t2090 = sin_delta * t1934;
    const float t2094 = (cos_delta * t1966) + (cos_delta * motion->constants[24]);
    const float t2097 = t1967 + (sin_delta * motion->constants[24]);
    const float t2100 = (t2015 * t2094) + (t2051 * t2097) - (t1964 * t2090);
    const float t2102 = t828 * motion->constants[29];
    const float t2103 = motion->constants[28] * t817;
    const float t2107 = (t817 * t1783) - t830;
    const float t2110 = t867 + t867;
    const float t2111 = motion->constants[34] * t2110;
    const float t2114 = t1090 - (t828 * t1783) - (sin_delta * t2111);
    const float t2120 = motion->constants[17] * t2110;
    const float t2123 = (t1633 * (t1148 + t1148)) + (t1698 * (t1146 + t1146)) + (t1698 * t2120);
    const float t2127 = t2123 + (motion->constants[23] * t2120) + (cos_delta * t2111);
    const float t2131 = (t26 * t2107) - (t14 * t2114);
    const float t2133 = motion->constants[24] * t828;
    const float t2134 = motion->constants[23] * t817;
    const float t2135 = t2133 + t2134;
    const float t2137 = t869 + t869;
    const float t2142 = (sin_delta * t2137) + (cos_delta * t2135);
    const float t2146 = (sin_delta * t2135) - (cos_delta * t2137);
    const float t2149 = motion->constants[22] * t835;
    const float t2151 = (motion->constants[38] * t835) + t2149 - t852;
    const float t2154 = motion->constants[22] * t850;
    const float t2156 = t1099 - (motion->constants[38] * t850) - t2154;
    const float t2157 = cos_delta * t2156;
    const float t2159 = t850 * motion->constants[35];
    const float t2160 = motion->constants[34] * t835;
    const float t2161 = t2159 + t2160;
    const float t2163 = t1055 + t1055;
    const float t2165 = (cos_delta * t2161) - (sin_delta * t2163);
    const float t2168 = t1068 + t1068;
    const float t2173 = (sin_delta * t2161) + (cos_delta * t2163);
    const float t2175 = (t1698 * t2168) + (t1633 * t2173);
    const float t2179 = (sin_delta * t2156) + (motion->constants[23] * t2168) + t2175 -
        (motion->constants[24] * t2173);
    const float t2185 = (t26 * t2151) + (t85 * t2165) - (t14 * t2157);
    const float t2188 = t906 + t931;
    const float t2189 = t906 + t2188;
    const float t2191 = motion->constants[25] * t835;
    const float t2194 = (t850 * motion->constants[26]) - (speeds[1] * t1966);
    const float t2195 = t2191 + t2194;
    const float t2197 = t908 + t933;
    const float t2198 = t908 + t2197;
    const float t2204 = (t1642 * t2165) + (t764 * t2185) + (speeds[1] * t1837) + (t2015 * t2195) -
        (t14 * t2151) - (t26 * t2157);
    const float t2207 = t2204 - (t753 * t2179) - (t1964 * t2189) - (t2051 * t2198);
    const float t2210 = t847 - (motion->constants[36] * t838);
    const float t2212 = motion->constants[37] * t838;
    const float t2216 = (motion->constants[36] * t850) - t1097 - t1099;
    const float t2218 = (cos_delta * t2212) - (sin_delta * t2216);
    const float t2222 = (cos_delta * t1055) + (sin_delta * t2159);
    const float t2225 = t1059 - t1058;
    const float t2230 = (cos_delta * t2159) - (sin_delta * t1055);
    const float t2232 = (t1698 * t2225) + (t1633 * t2230);
    const float t2238 = (sin_delta * t2212) + (motion->constants[24] * t2230) + (cos_delta *
        t2216) - (motion->constants[23] * t2225) - t2232;
    const float t2244 = (t26 * t2210) + (t85 * t2222) - (t14 * t2218);
    const float t2249 = t950 + t963;
    const float t2252 = (speeds[1] * t1934) + t2249 - t949 - (t34 * t1943);
    const float t2255 = t2197 + (t844 * t917);
    const float t2258 = t2194 + (t34 * t2029);
    const float t2260 = t32 * t925;
    const float t2266 = (t1642 * t2222) + (t764 * t2244) + (t1964 * t2252) + (t2015 * t2255) +
        (t2051 * t2258) + (t2073 * t2260);
    const float t2270 = t2266 - (t14 * t2210) - (t26 * t2218) - (t753 * t2238) - (speeds[1] *
        t1816);
    const float t2276 = (t764 * t2131) + (t1742 * t2135) + (t2015 * t2142) + (t2051 * t2146) +
        (cos_delta * t2207) + (sin_delta * t2270);
    const float t2280 = t2276 - (motion->constants[7] * (t2102 + t2103)) - (t14 * t2107) - (t26 *
        t2114) - (t753 * t2127);
    const float t2282 = t2280 - (t1679 * t2137) - (t1964 * t2110);
    const float t2284 = t14 * t818;
    const float t2288 = (t110 * t815) - t2284 - (speeds[0] * t107);
    const float t2291 = t823 - (motion->constants[32] * t819);
    const float t2293 = motion->constants[30] * t819;
    const float t2294 = t886 - t885;
    const float t2295 = motion->constants[34] * t2294;
    const float t2297 = t2293 + (sin_delta * t2295);
    const float t2303 = motion->constants[17] * t2294;
    const float t2306 = (t1633 * t2102) + (t1698 * (t1181 - t1180)) + (t1698 * t2303);
    const float t2313 = (motion->constants[32] * t828) - t1088 - t1090 - t2306 -
        (motion->constants[23] * t2303) - (cos_delta * t2295);
    const float t2317 = (t26 * t2291) - (t14 * t2297);
    const float t2326 = t869 + (motion->constants[23] * t91);
    const float t2329 = (t91 * t1934) + (cos_delta * t2326) - (sin_delta * t2133);
    const float t2333 = (cos_delta * t2133) + (sin_delta * t2326);
    const float t2341 = (t764 * t2317) + (t869 * t1742) + (t1679 * t2133) + (t91 * t1774) + (t1964 *
        t2294) + (t2015 * t2329);
    const float t2346 = t2341 + (t2051 * t2333) + (cos_delta * t2270) - (motion->constants[7] *
        t1148) - (t14 * t2291) - (t26 * t2297);
    const float t2348 = t2346 - (t753 * t2313) - (sin_delta * t2207);
    const float t2350 = t26 * t818;
    const float t2354 = t2350 + (t107 * t815) + (speeds[0] * t110);
    const float t2356 = t2212 + t2293;
    const float t2360 = (motion->constants[39] * t838) - t847;
    const float t2361 = cos_delta * t2360;
    const float t2364 = t851 + t852 - (motion->constants[39] * t835);
    const float t2366 = t2364 - (motion->constants[34] * t2134);
    const float t2370 = (motion->constants[33] * t819) + t2361 - t823 - (sin_delta * t2366);
    const float t2373 = motion->constants[17] * t2134;
    const float t2378 = t1057 + t1059;
    const float t2380 = (sin_delta * t1068) + (cos_delta * t2378);
    const float t2383 = (sin_delta * t2360) - (motion->constants[23] * t2160) -
        (motion->constants[24] * t2380);
    const float t2390 = (t1698 * t2160) - (t1633 * t2380);
    const float t2393 = (t1698 * t2103) + (t1698 * t2373) + t2390 - (t1633 * (t1179 + t1181));
    const float t2400 = t829 + t830 + t2383 + (cos_delta * t2366) - (motion->constants[33] * t817) -
        (motion->constants[23] * t2373) - t2393;
    const float t2406 = (cos_delta * t1068) - (sin_delta * t2378);
    const float t2407 = t85 * t2406;
    const float t2409 = t2407 - (t26 * t2356) - (t14 * t2370);
    const float t2412 = t884 + t886;
    const float t2416 = t2191 + (t32 * t1943);
    const float t2417 = t2134 + t2416;
    const float t2421 = t2188 + (t844 * t921);
    const float t2424 = (cos_delta * t867) + t2421 + (sin_delta * t2412);
    const float t2429 = t948 + t2249 + (t32 * t2029);
    const float t2432 = (sin_delta * t867) - t2429 - (cos_delta * t2412);
    const float t2436 = t34 * t925;
    const float t2438 = (t1642 * t2406) + (t2073 * t2436);
    const float t2443 = (t14 * t2356) + (t764 * t2409) + (t867 * t1742) + (t1964 * t2417) + (t2015 *
        t2424) + (t2051 * t2432);
    const float t2448 = t2443 + (t91 * t2100) + t2438 - (motion->constants[7] * t1146) - (t26 *
        t2370) - (t753 * t2400);
    const float t2450 = t2448 - (t1679 * t2412) - (t91 * t1867);
    const float t2453 = cos_delta * t2154;
    const float t2455 = sin_delta * t2154;
    const float t2459 = (t26 * t2149) + (t14 * t2453);
    const float t2467 = t2069 + (t26 * t2453) + (t753 * t2455) + (t764 * t2459) - (t14 * t2149) -
        (t931 * t1964);
    const float t2468 = t2467 - (t933 * t2051);
    const float t2473 = t1711 + t2134;
    const float t2475 = (t817 * t1934) + (cos_delta * t2473);
    const float t2477 = sin_delta * t2473;
    const float t2482 = (t1711 * t1746) - (t855 * t2086);
    const float t2487 = t2282 + (t817 * t1774) + (t2015 * t2475) + (t2051 * t2477) + (t828 *
        t2100) - (t828 * t1867);
    const float t2488 = t2487 - t2482;
    const float t2490 = cos_phi * t1615;
    const float t2492 = cos_phi * t1683;
    const float t2495 = cos_phi * t1709;
    const float t2496 = (sin_phi * t1711) - t2495;
    const float t2498 = sin_phi * t809;
    const float t2500 = speeds[0] * cos_phi;
    const float t2502 = sin_phi * t827;
    const float t2504 = cos_phi * t1938;
    const float t2509 = t2495 + (sin_phi * t1980);
    const float t2512 = (sin_phi * t1977) + (cos_phi * t1974) + (cos_delta * t2509);
    const float t2516 = (cos_phi * t2019) + (sin_delta * t2509);
    const float t2518 = sin_phi * t2076;
    const float t2528 = (t1680 * t2490) + (t1746 * t2496) + (t1774 * t2498) + (t1964 * t2504) +
        (t2015 * t2512) + (t2051 * t2516);
    const float t2533 = t2528 + (t2086 * t2518) + (t2100 * t2502) + (t18 * t2348) - (t1707 *
        t2492) - (t1843 * t2500);
    const float t2536 = t2533 - (t1867 * t2502) - (sin_phi * t2282) - (t27 * t2450);
    const float t2542 = (t364 * t1539) + (t107 * t1496) + (t369 * t1546) + (t1601 * t1611) +
        (t1632 * t1680) + (t1697 * t1707);
    const float t2547 = t2542 + (t1715 * t1746) + (t1754 * t1774) + (t1779 * t1843) + (t1888 *
        t1899) + (t1918 * t1929);
    const float t2552 = t2547 + (t1954 * t1964) + (t2007 * t2015) + (t2041 * t2051) + (t2063 *
        t2073) + (t2077 * t2086);
    const float t2557 = t2552 + (t2089 * t2100) + (t2288 * t2348) + (t2354 * t2450) + (t620 *
        t2468) + (t235 * t2488);
    const float t2562 = t2557 - (t465 * t2536) - (t364 * t1499) - (t110 * t1457) - (t199 * t1538) -
        (t566 * t1548);
    const float t2566 = t2562 - (t753 * t1554) - (t764 * t1558) - (t1851 * t1867) - (t815 * t2282);
    const float t2579 = (t1230 * t1607) - (t690 * motion->constants[22]) - (t1228 * t1605);
    const float t2587 = (t1230 * t1669) - motion->constants[34] - (t1228 * t1663);
    const float t2590 = (t1230 * t1653) - (t1228 * t1649) - (sin_delta * t2587);
    const float t2591 = t2590 - (t1228 * t1635);
    const float t2595 = (t1230 * t1704) - (t1228 * t1702);
    const float t2602 = (t1230 * t1736) + (cos_delta * t2587) - (t1228 * t1732);
    const float t2603 = (t1230 * t1721) + t2602;
    const float t2610 = (t1230 * t1766) + (motion->constants[23] * t2602) - motion->constants[39] -
        (t1228 * t1760);
    const float t2618 = t2579 + (t1230 * t1811) - (t1228 * t1807);
    const float t2623 = (t1230 * t1832) - motion->constants[37] - (t1228 * t1826);
    const float t2628 = (t1230 * t1794) + (motion->constants[24] * t2590) + (cos_delta * t2618) +
        (sin_delta * t2623) - (t1228 * t1792);
    const float t2636 = (t1230 * t1857) + (cos_delta * t2623) - (motion->constants[24] * t2602) -
        (sin_delta * t2618);
    const float t2646 = (t1889 * t2591) + (t18 * t2636) - (t1891 * t2595) - (t27 * t2610) -
        (sin_phi * t2628);
    const float t2655 = t2628 + (t1921 * t2579) + (t1698 * t2595) + (t363 * t2646) - (t1633 *
        t2591);
    const float t2661 = (t1958 * t2579) + (t1961 * t2655) - (t1956 * t2646);
    const float t2667 = (t2009 * t2579) + (t2008 * t2646) + (t2012 * t2655);
    const float t2673 = (t2048 * t2655) - (t2045 * t2579) - (t2043 * t2646);
    const float t2676 = t2068 * t2667;
    const float t2679 = t2676 - (t2064 * t2661) - (t2070 * t2673);
    const float t2689 = (t14 * t2591) + (t26 * t2595) + (t124 * t2673) - (t26 * t2661) - (t115 *
        t2667);
    const float t2695 = (t2094 * t2667) + (t2097 * t2673) - (t2090 * t2661);
    const float t2714 = (t1230 * t2185) + (speeds[1] * t2623) + (t2195 * t2667) - t2151 - (t1228 *
        t2179) - (t2189 * t2661);
    const float t2715 = t2714 - (t2198 * t2673);
    const float t2728 = (t1230 * t2244) + (t2252 * t2661) + (t2255 * t2667) + (t2258 * t2673) +
        (t2260 * t2679) - t2210;
    const float t2730 = t2728 - (t1228 * t2238) - (speeds[1] * t2618);
    const float t2736 = (t1230 * t2131) + (t2135 * t2602) + (t2142 * t2667) + (t2146 * t2673) +
        (cos_delta * t2715) + (sin_delta * t2730);
    const float t2739 = t2736 - (t1228 * t2127) - (t2137 * t2590) - (t2110 * t2661);
    const float t2755 = (t1230 * t2317) + (t869 * t2602) + (t2133 * t2590) + (t91 * t2610) +
        (t2294 * t2661) + (t2329 * t2667);
    const float t2759 = t2755 + (t2333 * t2673) + (cos_delta * t2730) - (t1228 * t2313) -
        (sin_delta * t2715);
    const float t2771 = t2212 + (t2436 * t2679);
    const float t2776 = (t1230 * t2409) + (t867 * t2602) + (t2417 * t2661) + (t2424 * t2667) +
        (t2432 * t2673) + (t91 * t2695);
    const float t2780 = t2776 + t2771 - (t1228 * t2400) - (t2412 * t2590) - (t91 * t2636);
    const float t2790 = t2676 + (t1228 * t2455) + (t1230 * t2459) - t2149 - (t931 * t2661) - (t933 *
        t2673);
    const float t2799 = (t1711 * t2603) + (t855 * t2689);
    const float t2804 = t2739 + (t817 * t2610) + (t2475 * t2667) + (t2477 * t2673) + (t828 *
        t2695) + t2799;
    const float t2805 = t2804 - (t828 * t2636);
    const float t2825 = (t2490 * t2591) + (t2498 * t2610) + (t2504 * t2661) + (t2512 * t2667) +
        (t2516 * t2673) + (t2518 * t2689);
    const float t2830 = t2825 + (t2502 * t2695) + (t18 * t2759) - (t2492 * t2595) - (t2496 *
        t2603) - (t2500 * t2628);
    const float t2833 = t2830 - (t2502 * t2636) - (sin_phi * t2739) - (t27 * t2780);
    const float t2840 = (t447 * t1539) + (t461 * t1546) + (t1601 * t2579) + (t1632 * t2591) +
        (t1697 * t2595) + (t1754 * t2610);
    const float t2845 = t2840 + (t1779 * t2628) + (t1888 * t2646) + (t1918 * t2655) + (t1954 *
        t2661) + (t2007 * t2667);
    const float t2850 = t2845 + (t2041 * t2673) + (t2063 * t2679) + (t2077 * t2689) + (t2089 *
        t2695) + (t2288 * t2759);
    const float t2855 = t2850 + (t2354 * t2780) + (t620 * t2790) + (t235 * t2805) - (t465 * t2833) -
        (t447 * t1499);
    const float t2860 = t2855 - (t233 * t1538) - (t617 * t1548) - (t1228 * t1554) - (t1230 *
        t1558) - (t1715 * t2603);
    const float t2863 = t2860 - (t1851 * t2636) - (t815 * t2739) - (t1262 * t2566);
    const float t2867 = t341 * t1546;
    const float t2869 = t329 * t1546;
    const float t2878 = (t1295 * t1605) + (t1297 * t1607) - (t693 * motion->constants[22]);
    const float t2886 = (t1295 * t1663) + (t1297 * t1669) - t1660;
    const float t2890 = t1645 + (t1295 * t1649) + (t1297 * t1653) - (sin_delta * t2886);
    const float t2892 = t1634 + (t1295 * t1635) + t2890;
    const float t2897 = (t1295 * t1702) + (t1297 * t1704) - t1701;
    const float t2905 = t1728 + (t1295 * t1732) + (t1297 * t1736) + (cos_delta * t2886);
    const float t2906 = (t1297 * t1721) + t2905;
    const float t2913 = (t1295 * t1760) + (t1297 * t1766) + (motion->constants[23] * t2905) - t1759;
    const float t2922 = t1802 + t2878 + (t1295 * t1807) + (t1297 * t1811);
    const float t2927 = t1823 + (t1295 * t1826) + (t1297 * t1832);
    const float t2933 = t1788 + (t1295 * t1792) + (t1297 * t1794) + (motion->constants[24] *
        t2890) + (cos_delta * t2922) + (sin_delta * t2927);
    const float t2934 = t2933 - motion->constants[21];
    const float t2942 = (t1297 * t1857) + (cos_delta * t2927) - (motion->constants[24] * t2905) -
        (sin_delta * t2922);
    const float t2952 = (t1889 * t2892) + (t18 * t2942) - (t1891 * t2897) - (t27 * t2913) -
        (sin_phi * t2934);
    const float t2961 = t2934 + (t1921 * t2878) + (t1698 * t2897) + (t363 * t2952) - (t1633 *
        t2892);
    const float t2967 = (t1958 * t2878) + (t1961 * t2961) - (t1956 * t2952);
    const float t2973 = (t2009 * t2878) + (t2008 * t2952) + (t2012 * t2961);
    const float t2979 = (t2048 * t2961) - (t2045 * t2878) - (t2043 * t2952);
    const float t2982 = t2068 * t2973;
    const float t2985 = t2982 - (t2064 * t2967) - (t2070 * t2979);
    const float t2995 = (t14 * t2892) + (t26 * t2897) + (t124 * t2979) - (t26 * t2967) - (t115 *
        t2973);
    const float t3001 = (t2094 * t2973) + (t2097 * t2979) - (t2090 * t2967);
    const float t3020 = (t1295 * t2179) + (t1297 * t2185) + (speeds[1] * t2927) + (t2195 * t2973) -
        t2175 - (t2189 * t2967);
    const float t3021 = t3020 - (t2198 * t2979);
    const float t3034 = t2232 + (t1295 * t2238) + (t1297 * t2244) + (t2252 * t2967) + (t2255 *
        t2973) + (t2258 * t2979);
    const float t3036 = t3034 + (t2260 * t2985) - (speeds[1] * t2922);
    const float t3042 = (t1295 * t2127) + (t1297 * t2131) + (t2135 * t2905) + (t2142 * t2973) +
        (t2146 * t2979) + (cos_delta * t3021);
    const float t3046 = t3042 + (sin_delta * t3036) - t2123 - (t2137 * t2890) - (t2110 * t2967);
    const float t3062 = t2306 + (t1295 * t2313) + (t1297 * t2317) + (t869 * t2905) + (t2133 *
        t2890) + (t91 * t2913);
    const float t3067 = t3062 + (t2294 * t2967) + (t2329 * t2973) + (t2333 * t2979) + (cos_delta *
        t3036) - (sin_delta * t3021);
    const float t3077 = t2436 * t2985;
    const float t3083 = t2393 + (t1295 * t2400) + (t1297 * t2409) + (t867 * t2905) + (t2417 *
        t2967) + (t2424 * t2973);
    const float t3088 = t3083 + (t2432 * t2979) + t3077 + (t91 * t3001) - (t2412 * t2890) - (t91 *
        t2942);
    const float t3097 = t2982 + (t1297 * t2459) - (t1295 * t2455) - (t931 * t2967) - (t933 * t2979);
    const float t3106 = (t1711 * t2906) + (t855 * t2995);
    const float t3111 = t3046 + (t817 * t2913) + (t2475 * t2973) + (t2477 * t2979) + (t828 *
        t3001) + t3106;
    const float t3112 = t3111 - (t828 * t2942);
    const float t3132 = (t2490 * t2892) + (t2498 * t2913) + (t2504 * t2967) + (t2512 * t2973) +
        (t2516 * t2979) + (t2518 * t2995);
    const float t3137 = t3132 + (t2502 * t3001) + (t18 * t3067) - (t2492 * t2897) - (t2496 *
        t2906) - (t2500 * t2934);
    const float t3140 = t3137 - (t2502 * t2942) - (sin_phi * t3046) - (t27 * t3088);
    const float t3148 = (t328 * t1539) + (t191 * t2867) + (t1295 * t1554) + (t1601 * t2878) +
        (t1632 * t2892) + (t1697 * t2897);
    const float t3153 = t3148 + (t1754 * t2913) + (t1779 * t2934) + (t1888 * t2952) + (t1918 *
        t2961) + (t1954 * t2967);
    const float t3158 = t3153 + (t2007 * t2973) + (t2041 * t2979) + (t2063 * t2985) + (t2077 *
        t2995) + (t2089 * t3001);
    const float t3163 = t3158 + (t2288 * t3067) + (t2354 * t3088) + (t620 * t3097) + (t235 *
        t3112) - (t465 * t3140);
    const float t3169 = t3163 - t1554 - (t328 * t1499) - (t339 * t2869) - (t543 * t1484) - (t1297 *
        t1558) - (t1715 * t2906);
    const float t3174 = t1368 * (t3169 - (t1851 * t2942) - (t815 * t3046) - (t1327 * t2566) -
        (t1336 * t2863));
    const float t3176 = (t1280 * t2863) - (t1336 * t3174);
    const float t3180 = (t808 * t2566) - (t1262 * t3176) - (t1327 * t3174);
    const float t3183 = (t1403 * t1637) - (t1418 * t1658);
    const float t3185 = t1507 + (sin_delta * t3183);
    const float t3187 = motion->constants[17] * t1403;
    const float t3191 = motion->constants[17] * t1418;
    const float t3195 = (cos_delta * (t1439 + (sin_delta * t3187))) - (sin_delta * (t1446 +
        (sin_delta * t3191)));
    const float t3208 = (cos_delta * ((cos_delta * t3187) - t1446)) - (sin_delta * (t1439 +
        (cos_delta * t3191)));
    const float t3215 = (t242 * t1552) + (t1633 * t3208) - (t240 * t1550);
    const float t3218 = t1490 + (motion->constants[24] * t3208) + (cos_delta * t3183) - t3215;
    const float t3226 = (t14 * t3185) + (t85 * t3195) - (t240 * t1457) - (t242 * t1496);
    const float t3243 = (t260 * t1564) + (t264 * t1570) + (t268 * t1575) + (t481 * t1580) + (t629 *
        t1582) + (t634 * t1369);
    const float t3248 = t3243 + (t649 * t1588) + (t675 * t1590) - (t245 * t1561) - (t642 * t1577) -
        (t472 * t1585);
    const float t3257 = (t240 * t1414) + (t242 * t1027) - (t303 * t1622) - (t311 * t1625);
    const float t3265 = (t242 * t1414) + (t303 * t1688) + (t311 * t1690) - (t240 * t1027);
    const float t3271 = (t242 * t1375) - (t240 * t1389);
    const float t3275 = (t303 * t1375) + (t311 * t1371);
    const float t3279 = (t240 * t1375) + (t242 * t1389);
    const float t3294 = (t260 * t1563) + (t268 * t1573) + (t296 * t1873) + (t481 * t1579) + (t486 *
        t1375) + (t512 * t1371);
    const float t3297 = t3294 - (t245 * t1560) - (t264 * t1568) - (t472 * t1877);
    const float t3307 = (t245 * t1903) + (t260 * t1905) + (t264 * t1908) - (t268 * t1910) - (t301 *
        t1912);
    const float t3319 = (t240 * t899) + (t242 * t894) + (t264 * t1945) + (t268 * t1949) - (t911 *
        t1934) - (t912 * t1934);
    const float t3322 = (t889 * t1966) - t903;
    const float t3325 = t881 + (t877 * t1966);
    const float t3335 = (cos_delta * t3322) + (t264 * t1996) - (sin_delta * t3325) - (t240 *
        t1990) - (t242 * t1992) - (t268 * t2000);
    const float t3347 = (cos_delta * t3325) + (sin_delta * t3322) + (t242 * t2027) - (t240 *
        t2025) - (t264 * t2031) - (t268 * t2034);
    const float t3355 = (t245 * t2053) + (t264 * t2057) - (t260 * t2055) - (t268 * t2059);
    const float t3357 = t242 * t866;
    const float t3363 = (t242 * t815) - (speeds[0] * t240);
    const float t3367 = (t240 * t815) + (speeds[0] * t242);
    const float t3376 = (t26 * t3185) + (t1642 * t3195) + (t240 * t1496) + (t486 * t1546) + (t764 *
        t3226) + (t1611 * t3248);
    const float t3381 = t3376 + (t1680 * t3257) + (t1707 * t3265) + (t1435 * t1837) + (t1774 *
        t3271) + (t1843 * t3275);
    const float t3386 = t3381 + (t1899 * t3297) + (t1929 * t3307) + (t1964 * t3319) + (t2015 *
        t3335) + (t2051 * t3347);
    const float t3391 = t3386 + (t2073 * t3355) + (t2100 * t3357) + (t838 * t2270) + (t2348 *
        t3363) + (t2450 * t3367);
    const float t3396 = t3391 + (t678 * t2468) + (t313 * t2488) - (t516 * t2536) - (t242 * t1457) -
        (t303 * t1538);
    const float t3401 = t3396 - (t649 * t1548) - (t753 * t3218) - (t1431 * t1674) - (t1424 *
        t1816) - (t1867 * t3279);
    const float t3402 = t3401 - (t835 * t2207);
    const float t3437 = (t512 * t1546) + (t1230 * t3226) + (t2579 * t3248) + (t2591 * t3257) +
        (t2595 * t3265) + (t1435 * t2623);
    const float t3442 = t3437 + (t2610 * t3271) + (t2628 * t3275) + (t2646 * t3297) + (t2655 *
        t3307) + (t2661 * t3319);
    const float t3447 = t3442 + (t2667 * t3335) + (t2673 * t3347) + (t2679 * t3355) + (t2695 *
        t3357) + (t838 * t2730);
    const float t3452 = t3447 + (t2759 * t3363) + (t2780 * t3367) + (t678 * t2790) + (t313 *
        t2805) - (t516 * t2833);
    const float t3457 = t3452 - (t311 * t1538) - (t675 * t1548) - (t1228 * t3218) - (t1431 *
        t2587) - (t1424 * t2618);
    const float t3460 = t3457 - (t2636 * t3279) - (t835 * t2715) - (t1262 * t3402);
    const float t3496 = t3215 + (t296 * t2867) + (t1295 * t3218) + (t1297 * t3226) + (t2878 *
        t3248) + (t2892 * t3257);
    const float t3501 = t3496 + (t2897 * t3265) + (t1435 * t2927) + (t2913 * t3271) + (t2934 *
        t3275) + (t2952 * t3297);
    const float t3506 = t3501 + (t2961 * t3307) + (t2967 * t3319) + (t2973 * t3335) + (t2979 *
        t3347) + (t2985 * t3355);
    const float t3511 = t3506 + (t3001 * t3357) + (t838 * t3036) + (t3067 * t3363) + (t3088 *
        t3367) + (t678 * t3097);
    const float t3516 = t3511 + (t313 * t3112) - (t516 * t3140) - (t472 * t2869) - (t634 * t1484) -
        (t1431 * t2886);
    const float t3521 = t3516 - (t1424 * t2922) - (t2942 * t3279) - (t835 * t3021) - (t1327 *
        t3402) - (t1336 * t3460);
    const float t3522 = t1368 * t3521;
    const float t3524 = (t1280 * t3460) - (t1336 * t3522);
    const float t3528 = (t808 * t3402) - (t1262 * t3524) - (t1327 * t3522);
    const float t3529 = t1711 + t1711;
    const float t3530 = t26 * t3529;
    const float t3532 = t14 * t3529;
    const float t3539 = cos_delta * t815;
    const float t3542 = (t14 * t1711) + (t815 * t1932) + (t1934 * t3539);
    const float t3548 = (t26 * t1711) + (t815 * t1970);
    const float t3550 = motion->constants[23] * t2350;
    const float t3554 = (t1934 * t2350) + (t815 * t1967) + (cos_delta * t3550) - (sin_delta *
        t3548);
    const float t3560 = (cos_delta * t3548) + (sin_delta * t3550) - (t1966 * t3539);
    const float t3573 = (t1680 * t3530) + (t1774 * t2350) + (t1964 * t3542) + (t2015 * t3554) +
        (t2051 * t3560) + (t2100 * t2284);
    const float t3578 = t3573 + (t26 * t2348) + (t14 * t2450) + (t682 * t2468) + (t72 * t2488) +
        (t364 * t2536);
    const float t3582 = t3578 - (t1707 * t3532) - (t815 * t1843) - (t1867 * t2284) - (t1614 *
        t2086);
    const float t3604 = (t2591 * t3530) + (t2350 * t2610) + (t2661 * t3542) + (t2667 * t3554) +
        (t2673 * t3560) + (t2284 * t2695);
    const float t3609 = t3604 + (t26 * t2759) + (t14 * t2780) + (t682 * t2790) + (t72 * t2805) +
        (t364 * t2833);
    const float t3614 = t3609 - (t2595 * t3532) - (t815 * t2628) - (t2284 * t2636) - (t1614 *
        t2689) - (t1262 * t3582);
    const float t3637 = (t2892 * t3530) + (t2350 * t2913) + (t2967 * t3542) + (t2973 * t3554) +
        (t2979 * t3560) + (t2284 * t3001);
    const float t3642 = t3637 + (t26 * t3067) + (t14 * t3088) + (t682 * t3097) + (t72 * t3112) +
        (t364 * t3140);
    const float t3647 = t3642 - (t2897 * t3532) - (t815 * t2934) - (t2284 * t2942) - (t1614 *
        t2995) - (t1327 * t3582);
    const float t3649 = t1368 * (t3647 - (t1336 * t3614));
    const float t3651 = (t1280 * t3614) - (t1336 * t3649);
    const float t3655 = (t808 * t3582) - (t1262 * t3651) - (t1327 * t3649);
    const float t3658 = t2361 - (sin_delta * t2364);
    const float t3662 = t2383 + (cos_delta * t2364) - t2390;
    const float t3667 = t2407 - (t26 * t2212) - (t14 * t3658);
    const float t3672 = t2416 + (t835 * t1934);
    const float t3675 = t2421 - (t838 * t1966);
    const float t3678 = t2429 + (t835 * t1966);
    const float t3687 = t2438 + (t14 * t2212) + (t764 * t3667) + (t838 * t1837) + (t1964 * t3672) +
        (t2015 * t3675);
    const float t3692 = t3687 + (t690 * t2468) + (t89 * t2488) + (t447 * t2536) - (t26 * t3658) -
        (t753 * t3662);
    const float t3694 = t3692 - (t835 * t1816) - (t2051 * t3678);
    const float t3711 = t2771 + (t1230 * t3667) + (t838 * t2623) + (t2661 * t3672) + (t2667 *
        t3675) + (t690 * t2790);
    const float t3716 = t3711 + (t89 * t2805) + (t447 * t2833) - (t1228 * t3662) - (t835 * t2618) -
        (t2673 * t3678);
    const float t3717 = t3716 - (t1262 * t3694);
    const float t3736 = t2390 + t3077 + (t1295 * t3662) + (t1297 * t3667) + (t838 * t2927) +
        (t2967 * t3672) + (t2973 * t3675);
    const float t3741 = t3736 + (t690 * t3097) + (t89 * t3112) + (t447 * t3140) - (t835 * t2922) -
        (t2979 * t3678);
    const float t3744 = t1368 * (t3741 - (t1327 * t3694) - (t1336 * t3717));
    const float t3746 = (t1280 * t3717) - (t1336 * t3744);
    const float t3750 = (t808 * t3694) - (t1262 * t3746) - (t1327 * t3744);
    const float t3751 = motion->constants[21] * t817;
    const float t3753 = motion->constants[21] * t828;
    const float t3757 = (t26 * t3751) + (t14 * t3753);
    const float t3759 = cos_delta * t1711;
    const float t3761 = sin_delta * t1711;
    const float t3769 = (t26 * t3753) + (t764 * t3757) + (t2015 * t3759) + (t2051 * t3761) + (t693 *
        t2468) + (t328 * t2536);
    const float t3771 = t3769 - t2482 - (t14 * t3751);
    const float t3783 = t2799 + (t1230 * t3757) + (t2667 * t3759) + (t2673 * t3761) + (t693 *
        t2790) + (t328 * t2833);
    const float t3784 = t3783 - (t1262 * t3771);
    const float t3797 = t3106 + (t1297 * t3757) + (t2973 * t3759) + (t2979 * t3761) + (t693 *
        t3097) + (t328 * t3140);
    const float t3800 = t1368 * (t3797 - (t1327 * t3771) - (t1336 * t3784));
    const float t3802 = (t1280 * t3784) - (t1336 * t3800);
    const float t3806 = (t808 * t3771) - (t1262 * t3802) - (t1327 * t3800);
    const float t3810 = t1368 * ((t1262 * t1336) - t1327);
    const float t3812 = (t1262 * t1280) + (t1336 * t3810);
    const float t3816 = t808 + (t1262 * t3812) - (t1327 * t3810);
    const float t3817 = t1336 * t1368;
    const float t3819 = t1280 + (t1336 * t3817);
    const float t3822 = (t1327 * t3817) - (t1262 * t3819);
    const float t3823 = -(t98 * t235);
    const float t3824 = -(t98 * t313);
    const float t3825 = -(t72 * t98);
    const float t3826 = -(t89 * t98);
    const float t3827 = -t98;
    const float t3828 = -(t93 * cos_psi);
    const float t3829 = -(t235 * t318);
    const float t3830 = -(t313 * t318);
    const float t3831 = -(t72 * t318);
    const float t3832 = -(t89 * t318);
    const float t3833 = -t318;
    const float t3834 = -t364;
    const float t3835 = -t447;
    const float t3836 = -t328;
    const float t3837 = -t3812;
    const float t3838 = -t3817;
    linearization->a[0][0] = 0.0F;
    linearization->a[0][1] = 0.0F;
    linearization->a[0][2] = t96;
    linearization->a[0][3] = t3823;
    linearization->a[0][4] = 0.0F;
    linearization->a[0][5] = t3824;
    linearization->a[0][6] = 0.0F;
    linearization->a[0][7] = 0.0F;
    linearization->a[0][8] = t3825;
    linearization->a[0][9] = t3826;
    linearization->a[0][10] = t3827;
    linearization->b[0][0] = 0.0F;
    linearization->b[0][1] = 0.0F;
    linearization->a[1][0] = 0.0F;
    linearization->a[1][1] = 0.0F;
    linearization->a[1][2] = t3828;
    linearization->a[1][3] = t3829;
    linearization->a[1][4] = 0.0F;
    linearization->a[1][5] = t3830;
    linearization->a[1][6] = 0.0F;
    linearization->a[1][7] = 0.0F;
    linearization->a[1][8] = t3831;
    linearization->a[1][9] = t3832;
    linearization->a[1][10] = t3833;
    linearization->b[1][0] = 0.0F;
    linearization->b[1][1] = 0.0F;
    linearization->a[2][0] = 0.0F;
    linearization->a[2][1] = 0.0F;
    linearization->a[2][2] = 0.0F;
    linearization->a[2][3] = t465;
    linearization->a[2][4] = 0.0F;
    linearization->a[2][5] = t516;
    linearization->a[2][6] = 0.0F;
    linearization->a[2][7] = 0.0F;
    linearization->a[2][8] = t3834;
    linearization->a[2][9] = t3835;
    linearization->a[2][10] = t3836;
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
    linearization->a[4][3] = t235;
    linearization->a[4][4] = 0.0F;
    linearization->a[4][5] = t313;
    linearization->a[4][6] = 0.0F;
    linearization->a[4][7] = 0.0F;
    linearization->a[4][8] = t72;
    linearization->a[4][9] = t89;
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
    linearization->a[7][3] = t620;
    linearization->a[7][4] = 0.0F;
    linearization->a[7][5] = t678;
    linearization->a[7][6] = 0.0F;
    linearization->a[7][7] = 0.0F;
    linearization->a[7][8] = t682;
    linearization->a[7][9] = t690;
    linearization->a[7][10] = t693;
    linearization->b[7][0] = 0.0F;
    linearization->b[7][1] = 0.0F;
    linearization->a[8][0] = 0.0F;
    linearization->a[8][1] = 0.0F;
    linearization->a[8][2] = 0.0F;
    linearization->a[8][3] = t3180;
    linearization->a[8][4] = 0.0F;
    linearization->a[8][5] = t3528;
    linearization->a[8][6] = 0.0F;
    linearization->a[8][7] = 0.0F;
    linearization->a[8][8] = t3655;
    linearization->a[8][9] = t3750;
    linearization->a[8][10] = t3806;
    linearization->b[8][0] = t3816;
    linearization->b[8][1] = t3822;
    linearization->a[9][0] = 0.0F;
    linearization->a[9][1] = 0.0F;
    linearization->a[9][2] = 0.0F;
    linearization->a[9][3] = t3176;
    linearization->a[9][4] = 0.0F;
    linearization->a[9][5] = t3524;
    linearization->a[9][6] = 0.0F;
    linearization->a[9][7] = 0.0F;
    linearization->a[9][8] = t3651;
    linearization->a[9][9] = t3746;
    linearization->a[9][10] = t3802;
    linearization->b[9][0] = t3837;
    linearization->b[9][1] = t3819;
    linearization->a[10][0] = 0.0F;
    linearization->a[10][1] = 0.0F;
    linearization->a[10][2] = 0.0F;
    linearization->a[10][3] = t3174;
    linearization->a[10][4] = 0.0F;
    linearization->a[10][5] = t3522;
    linearization->a[10][6] = 0.0F;
    linearization->a[10][7] = 0.0F;
    linearization->a[10][8] = t3649;
    linearization->a[10][9] = t3744;
    linearization->a[10][10] = t3800;
    linearization->b[10][0] = t3810;
    linearization->b[10][1] = t3838;
}

carvallo_motion_error_t whipple_mechanism_f32_motion_linearize(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], const float forces[WHIPPLE_MECHANISM_FORCES],
    whipple_mechanism_f32_linearization_t *linearization)
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_MECHANISM_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_MECHANISM_FORCES)) {
        bool are_finite = true;
        whipple_mechanism_f32_compute_linearization(motion, positions, speeds, forces,
            linearization);
        for (size_t row = 0U; row < WHIPPLE_MECHANISM_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f32(linearization->a[row],
                WHIPPLE_MECHANISM_STATES) && carvallo_are_finite_f32(linearization->b[row],
                WHIPPLE_MECHANISM_FORCES);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void whipple_mechanism_f32_compute_by_parameters(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], const float forces[WHIPPLE_MECHANISM_FORCES],
    float by_parameters[WHIPPLE_MECHANISM_STATES][WHIPPLE_MECHANISM_PARAMETERS])
{
    float sin_pitch = 0.0F;
    float cos_pitch = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_pitch, &cos_pitch);
    const float t7 = (motion->constants[19] * sin_pitch) + (motion->constants[20] * cos_pitch);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t12 = (motion->constants[19] * cos_pitch) - (sin_pitch * motion->constants[20]);
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
    const float t41 = motion->constants[10] * t40;
    const float t48 = motion->constants[23] + (cos_delta * motion->constants[25]);
    const float t51 = (t36 * t41) + (t7 * motion->constants[27]) + (t12 * t48);
    const float t53 = 1.0F / (cos_phi * t51);
    const float t54 = motion->constants[20] * t13;
    const float t55 = t7 * cos_delta;
    const float t57 = t20 - (cos_phi * t55);
    const float t59 = t54 + (motion->constants[19] * t57);
    const float t62 = t54 - t59 - (motion->constants[19] * t16);
    const float t64 = t53 * (t59 + t62);
    const float t65 = t7 * t64;
    const float t70 = t51 - (t7 * motion->constants[24]) - (t12 * motion->constants[23]);
    const float t71 = sin_phi * t53;
    const float t72 = t70 * t71;
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t77 = motion->constants[7] * cos_psi;
    const float t78 = speeds[1] * t77;
    const float t80 = t12 * sin_phi;
    const float t81 = t53 * t80;
    const float t82 = t78 * t81;
    const float t84 = t7 * t71;
    const float t85 = t78 * t84;
    const float t87 = t26 * t26;
    const float t88 = t21 * t87;
    const float t90 = t26 * 0.5F;
    const float t92 = cos_phi * (t13 + t13);
    const float t93 = t90 * t92;
    const float t94 = t88 * t93;
    const float t96 = t12 * cos_delta;
    const float t98 = t13 * t87;
    const float t100 = (cos_phi * t26) - (t93 * t98);
    const float t103 = t32 + (t7 * t94) + (t96 * t100);
    const float t104 = t41 * t103;
    const float t105 = t7 * t53;
    const float t108 = t77 * speeds[0];
    const float t110 = (t78 * t105) + (t53 * t108);
    const float t115 = t28 + (sin_phi * t55);
    const float t118 = (sin_phi * t30) + (t100 * t115) - (t80 * t94);
    const float t120 = t48 + (t41 * t118);
    const float t123 = (t12 * t32) - (t7 * t30);
    const float t125 = sin_delta * motion->constants[25];
    const float t129 = (t12 * motion->constants[27]) - (t7 * t48);
    const float t132 = (cos_phi * t125) - (t41 * t123) - (sin_phi * t129);
    const float t135 = (t12 * motion->constants[24]) - (t7 * motion->constants[23]);
    const float t137 = t132 + (sin_phi * t135);
    const float t141 = t53 * ((t7 * t137) + (t70 * t80));
    const float t142 = cos_phi * t53;
    const float t143 = t141 * t142;
    const float t145 = sin_phi * motion->constants[7];
    const float t146 = t132 + t145;
    const float t147 = t53 * t146;
    const float t148 = t142 * t147;
    const float t151 = (t78 * t143) + (t108 * t148) - t82;
    const float t153 = sin_phi * t110;
    const float t159 = (motion->constants[23] * t82) + (t104 * t110) + (t120 * t151) +
        (motion->constants[27] * t153) - (t72 * t78) - (motion->constants[24] * t85);
    const float t161 = t12 * t64;
    const float t162 = t53 * t137;
    const float t166 = t28 * motion->constants[10];
    const float t168 = cos_phi * cos_delta;
    const float t171 = t168 * (t21 + t21);
    const float t172 = t90 * t171;
    const float t174 = (t88 * t172) - (t26 * t168);
    const float t176 = t98 * t172;
    const float t179 = (t96 * t176) - t30 - (t7 * t174);
    const float t181 = (t123 * t166) + (t41 * t179);
    const float t188 = (sin_phi * t32) + (t80 * t174) + (t115 * t176);
    const float t191 = motion->constants[27] + (t36 * t166) + (t41 * t188);
    const float t198 = (motion->constants[24] * t82) + (motion->constants[23] * t85) + (t110 *
        t181) + (t151 * t191) - (t78 * t162) - (t48 * t153);
    const float t204 = (t7 * t151) + (t12 * t153);
    const float t206 = (t7 * t82) + t204 - (t12 * t85);
    const float t214 = (t12 * t82) + (t7 * t85) + (t12 * t151) - (t7 * t153);
    const float t216 = (motion->constants[20] * t206) + (motion->constants[19] * t214);
    const float t218 = (t161 * t198) + t216 - (t65 * t159);
    const float t224 = (t96 * t151) - (t28 * t110) - (t55 * t153);
    const float t226 = t53 * t62;
    const float t227 = t7 * t226;
    const float t229 = t12 * t226;
    const float t234 = t216 + (t198 * t229) - (motion->constants[20] * t204) -
        (motion->constants[19] * t224) - (t159 * t227);
    const float t238 = motion->constants[6] + motion->constants[18];
    const float t242 = (motion->constants[19] * motion->constants[10]) - (motion->constants[20] *
        (motion->constants[6] - t238));
    const float t246 = cos_phi * t48;
    const float t248 = cos_phi * motion->constants[27];
    const float t256 = motion->constants[10] * t90;
    const float t257 = t171 * t256;
    const float t259 = t92 * t256;
    const float t277 = (motion->constants[19] * ((t16 * motion->constants[7]) + (t13 * t238) -
        (cos_pitch * t246) - (sin_pitch * t248))) + (t57 * t242);
    const float t279 = t277 + (t13 * motion->constants[25]) - (motion->constants[20] * ((cos_pitch *
        t248) + (t13 * motion->constants[7]) - (sin_pitch * t246) - (t16 * t238)));
    const float t282 = t53 * (t279 - (motion->constants[20] * ((cos_pitch * t259) - (sin_pitch *
        t257))) - (motion->constants[19] * ((cos_pitch * t257) + (sin_pitch * t259))));
    const float t284 = t7 + (t7 * t282);
    const float t287 = t12 + (t12 * t282);
    const float t293 = (motion->constants[25] * t204) + (t224 * t242) + (motion->constants[23] *
        t206) + (t198 * t287) - (motion->constants[24] * t214) - (t159 * t284);
    const float t298 = (speeds[0] * t147) + (speeds[1] * t141);
    const float t299 = speeds[2] + t298;
    const float t305 = motion->constants[19] * t13;
    const float t308 = t53 * ((motion->constants[20] * t16) + t305 - cos_phi);
    const float t309 = t7 * t308;
    const float t311 = t12 * t308;
    const float t317 = (motion->constants[19] * t206) + (t198 * t311) - (cos_psi * t299) - (t71 *
        t108) - (motion->constants[20] * t214) - (t159 * t309);
    const float t318 = t40 * t123;
    const float t320 = t36 * t40;
    const float t327 = t53 * (t25 + (motion->constants[20] * t57) - t305);
    const float t328 = t7 * t327;
    const float t330 = t12 * t327;
    const float t336 = (t110 * t318) + (t151 * t320) + (motion->constants[20] * t224) + (t198 *
        t330) - (motion->constants[19] * t204) - (t159 * t328);
    const float t338 = motion->constants[7] * sin_psi;
    const float t339 = speeds[1] * t338;
    const float t341 = t81 * t339;
    const float t343 = t84 * t339;
    const float t346 = speeds[0] * t338;
    const float t348 = (t105 * t339) + (t53 * t346);
    const float t353 = (t143 * t339) + (t148 * t346) - t341;
    const float t355 = sin_phi * t348;
    const float t361 = (motion->constants[23] * t341) + (t104 * t348) + (t120 * t353) +
        (motion->constants[27] * t355) - (t72 * t339) - (motion->constants[24] * t343);
    const float t373 = (motion->constants[24] * t341) + (motion->constants[23] * t343) + (t181 *
        t348) + (t191 * t353) - (t162 * t339) - (t48 * t355);
    const float t379 = (t7 * t353) + (t12 * t355);
    const float t381 = (t7 * t341) + t379 - (t12 * t343);
    const float t389 = (t12 * t341) + (t7 * t343) + (t12 * t353) - (t7 * t355);
    const float t391 = (motion->constants[20] * t381) + (motion->constants[19] * t389);
    const float t393 = (t161 * t373) + t391 - (t65 * t361);
    const float t399 = (t96 * t353) - (t28 * t348) - (t55 * t355);
    const float t406 = t391 + (t229 * t373) - (motion->constants[20] * t379) -
        (motion->constants[19] * t399) - (t227 * t361);
    const float t417 = (motion->constants[25] * t379) + (t242 * t399) + (motion->constants[23] *
        t381) + (t287 * t373) - (motion->constants[24] * t389) - (t284 * t361);
    const float t428 = (motion->constants[19] * t381) + (t311 * t373) - (t299 * sin_psi) - (t71 *
        t346) - (motion->constants[20] * t389) - (t309 * t361);
    const float t439 = (t318 * t348) + (t320 * t353) + (motion->constants[20] * t399) + (t330 *
        t373) - (motion->constants[19] * t379) - (t328 * t361);
    const float t443 = 1.0F / ((t51 * t123) + (t36 * t146));
    const float t444 = motion->constants[7] * t443;
    const float t445 = t118 * t444;
    const float t447 = t36 * t443;
    const float t454 = (t25 * motion->constants[10]) + (sin_phi * t125) + (cos_phi * t129) -
        (cos_phi * t135);
    const float t457 = (sin_phi * t454) + (cos_phi * t137);
    const float t459 = t123 * t443;
    const float t460 = cos_phi * t70;
    const float t464 = (t80 * t447) - (t7 * t459);
    const float t465 = motion->constants[10] * t464;
    const float t469 = (t13 * t70) - (t7 * t454);
    const float t470 = t443 * t469;
    const float t474 = (t80 * t454) + (t13 * t137);
    const float t475 = t443 * t474;
    const float t480 = (t447 * t457) + (t459 * t460) + (t93 * t465) + (t103 * t470) + (t118 * t475);
    const float t482 = sin_phi * t51;
    const float t484 = sin_phi * t146;
    const float t486 = (t123 * t482) + (t36 * t484);
    const float t487 = t443 * t486;
    const float t488 = speeds[1] * t487;
    const float t490 = t13 * t459;
    const float t493 = (speeds[1] * t490) + (t81 * t488);
    const float t495 = t13 * sin_phi;
    const float t497 = cos_phi * t464;
    const float t498 = (t447 * t495) - t497;
    const float t501 = (speeds[1] * t498) + (t84 * t488);
    const float t505 = (t51 * t103) + (t118 * t146);
    const float t506 = t36 * t444;
    const float t507 = t443 * t506;
    const float t514 = t443 * ((t123 * t469) + (t36 * t474) + (t141 * t486));
    const float t515 = t443 * t514;
    const float t517 = t147 * t487;
    const float t518 = t443 * t517;
    const float t521 = (speeds[2] * t507) + (speeds[1] * t515) + (speeds[0] * t518);
    const float t525 = (t103 * t482) + (t118 * t484);
    const float t526 = t141 * t443;
    const float t528 = t147 * t443;
    const float t530 = (speeds[1] * t526) + (speeds[0] * t528);
    const float t532 = t13 * t447;
    const float t535 = speeds[0] * t487;
    const float t538 = sin_phi * t36;
    const float t543 = (t36 * t521) - (speeds[1] * t532) - (t105 * t488) - (t53 * t535) - (t530 *
        t538);
    const float t548 = sin_phi * t123;
    const float t553 = (t143 * t488) + (t148 * t535) + (t123 * t521) - t493 - (t530 * t548);
    const float t557 = (speeds[1] * t497) + (sin_phi * t543);
    const float t563 = (motion->constants[23] * t493) + (t505 * t521) + (t120 * t553) - (speeds[2] *
        t445) - (speeds[1] * t480) - (t72 * t488);
    const float t567 = t563 - (motion->constants[24] * t501) - (t525 * t530) - (t104 * t543) -
        (motion->constants[27] * t557);
    const float t569 = t188 * t444;
    const float t577 = (t179 * t470) + (t188 * t475) - (t454 * t459) - (t172 * t465);
    const float t584 = (t51 * t179) + (t146 * t188);
    const float t588 = (t179 * t482) + (t188 * t484);
    const float t597 = (motion->constants[24] * t493) + (motion->constants[23] * t501) + (t521 *
        t584) + (t191 * t553) + (t48 * t557) - (speeds[2] * t569);
    const float t601 = t597 - (speeds[1] * t577) - (t162 * t488) - (t530 * t588) - (t181 * t543);
    const float t607 = (t7 * t553) - (t12 * t557);
    const float t609 = (t7 * t493) + t607 - (t12 * t501);
    const float t617 = (t12 * t493) + (t7 * t501) + (t12 * t553) + (t7 * t557);
    const float t619 = (motion->constants[20] * t609) + (motion->constants[19] * t617);
    const float t621 = (t161 * t601) + t619 - (t65 * t567);
    const float t623 = t20 * t464;
    const float t630 = (t28 * t543) + (t96 * t553) + (t55 * t557) - (speeds[1] * t623);
    const float t637 = t619 + (t229 * t601) - (motion->constants[20] * t607) -
        (motion->constants[19] * t630) - (t227 * t567);
    const float t648 = (motion->constants[25] * t607) + (t242 * t630) + (motion->constants[23] *
        t609) + (t287 * t601) - (motion->constants[24] * t617) - (t284 * t567);
    const float t652 = sin_phi * t538;
    const float t662 = (t521 * t538) + (motion->constants[19] * t609) + (t311 * t601) - (speeds[2] *
        t447) - (t71 * t535) - (t530 * t652);
    const float t664 = t662 - (motion->constants[20] * t617) - (t309 * t567);
    const float t665 = t25 * t464;
    const float t677 = (t320 * t553) + (motion->constants[20] * t630) + (t330 * t601) - (speeds[1] *
        t665) - (t318 * t543) - (motion->constants[19] * t607);
    const float t678 = t677 - (t328 * t567);
    const float t680 = speeds[1] * t81;
    const float t682 = speeds[1] * t84;
    const float t686 = (speeds[1] * t105) + (t53 * speeds[0]);
    const float t691 = t680 - (speeds[1] * t143) - (speeds[0] * t148);
    const float t693 = sin_phi * t686;
    const float t699 = (t72 * speeds[1]) + (motion->constants[24] * t682) + (t120 * t691) -
        (motion->constants[23] * t680) - (t104 * t686) - (motion->constants[27] * t693);
    const float t711 = (speeds[1] * t162) + (t191 * t691) + (t48 * t693) - (motion->constants[24] *
        t680) - (motion->constants[23] * t682) - (t181 * t686);
    const float t717 = (t7 * t691) - (t12 * t693);
    const float t719 = (t12 * t682) + t717 - (t7 * t680);
    const float t727 = (t12 * t691) + (t7 * t693) - (t12 * t680) - (t7 * t682);
    const float t729 = (motion->constants[20] * t719) + (motion->constants[19] * t727);
    const float t731 = (t161 * t711) + t729 - (t65 * t699);
    const float t737 = (t28 * t686) + (t96 * t691) + (t55 * t693);
    const float t744 = t729 + (t229 * t711) - (motion->constants[20] * t717) -
        (motion->constants[19] * t737) - (t227 * t699);
    const float t755 = (motion->constants[25] * t717) + (t242 * t737) + (motion->constants[23] *
        t719) + (t287 * t711) - (motion->constants[24] * t727) - (t284 * t699);
    const float t764 = (t71 * speeds[0]) + (motion->constants[19] * t719) + (t311 * t711) -
        (motion->constants[20] * t727) - (t309 * t699);
    const float t775 = (t320 * t691) + (motion->constants[20] * t737) + (t330 * t711) - (t318 *
        t686) - (motion->constants[19] * t717) - (t328 * t699);
    const float t776 = 1.0F / motion->constants[10];
    const float t777 = motion->constants[7] * t776;
    const float t778 = t103 * t777;
    const float t780 = speeds[1] * t776;
    const float t785 = (t7 * t36) + (t80 * t123);
    const float t786 = motion->constants[10] * t785;
    const float t793 = (t123 * t457) + (t93 * t786) + (t103 * t474) - (t36 * t460) - (t118 * t469);
    const float t797 = (t36 * t51) - (t123 * t146);
    const float t798 = t776 * t797;
    const float t799 = speeds[2] * t798;
    const float t801 = t780 * t797;
    const float t805 = (t36 * t482) - (t123 * t484);
    const float t808 = (t487 * t801) - (t780 * t805);
    const float t810 = t13 * t36;
    const float t815 = (t490 * t801) + (t81 * t808) - (t780 * t810);
    const float t818 = cos_phi * t785;
    const float t819 = (t123 * t495) - t818;
    const float t824 = (t780 * t819) + (t498 * t801) + (t84 * t808);
    const float t828 = (t51 * t118) - (t103 * t146);
    const float t829 = t506 * t776;
    const float t832 = t517 * t776;
    const float t835 = (speeds[2] * t829) + (t514 * t780) + (speeds[0] * t832);
    const float t839 = (t118 * t482) - (t103 * t484);
    const float t841 = t147 * t776;
    const float t843 = (t141 * t780) + (speeds[0] * t841);
    const float t847 = speeds[0] * t798;
    const float t850 = (t507 * t799) + (t515 * t801) + (t518 * t847);
    const float t854 = (t526 * t801) + (t528 * t847);
    const float t856 = t13 * t123;
    const float t860 = t776 * t805;
    const float t863 = (t487 * t847) - (speeds[0] * t860);
    const float t873 = (t780 * t856) + (t532 * t801) + (t105 * t808) + (t53 * t863) + (t548 *
        t843) + (t538 * t854);
    const float t875 = t873 - (t123 * t835) - (t36 * t850);
    const float t887 = t815 + (t36 * t835) + (t548 * t854) - (t143 * t808) - (t148 * t863) - (t538 *
        t843);
    const float t888 = t887 - (t123 * t850);
    const float t894 = (t780 * t818) + (t497 * t801) - (sin_phi * t875);
    const float t900 = (speeds[2] * t778) + (t780 * t793) + (t445 * t799) + (t480 * t801) + (t72 *
        t808) + (motion->constants[24] * t824);
    const float t905 = t900 + (t828 * t835) + (t525 * t854) + (t120 * t888) +
        (motion->constants[27] * t894) - (motion->constants[23] * t815);
    const float t908 = t905 - (t839 * t843) - (t505 * t850) - (t104 * t875);
    const float t910 = t179 * t777;
    const float t918 = (t36 * t454) + (t179 * t474) - (t172 * t786) - (t188 * t469);
    const float t927 = (t51 * t188) - (t146 * t179);
    const float t931 = (t188 * t482) - (t179 * t484);
    const float t942 = (speeds[2] * t910) + (t780 * t918) + (t569 * t799) + (t577 * t801) + (t162 *
        t808) + (t835 * t927);
    const float t947 = t942 + (t588 * t854) + (t191 * t888) - (motion->constants[24] * t815) -
        (motion->constants[23] * t824) - (t843 * t931);
    const float t950 = t947 - (t584 * t850) - (t181 * t875) - (t48 * t894);
    const float t956 = (t7 * t888) + (t12 * t894);
    const float t958 = (t12 * t824) + t956 - (t7 * t815);
    const float t966 = (t12 * t888) - (t12 * t815) - (t7 * t824) - (t7 * t894);
    const float t968 = (motion->constants[20] * t958) + (motion->constants[19] * t966);
    const float t970 = (t161 * t950) + t968 - (t65 * t908);
    const float t972 = t20 * t785;
    const float t981 = (t780 * t972) + (t623 * t801) + (t28 * t875) + (t96 * t888) - (t55 * t894);
    const float t988 = t968 + (t229 * t950) - (motion->constants[20] * t956) -
        (motion->constants[19] * t981) - (t227 * t908);
    const float t999 = (motion->constants[25] * t956) + (t242 * t981) + (motion->constants[23] *
        t958) + (t287 * t950) - (motion->constants[24] * t966) - (t284 * t908);
    const float t1000 = t123 * t776;
    const float t1005 = sin_phi * t548;
    const float t1017 = (speeds[2] * t1000) + (t447 * t799) + (t71 * t863) + (t843 * t1005) +
        (t652 * t854) + (motion->constants[19] * t958);
    const float t1022 = t1017 + (t311 * t950) - (t548 * t835) - (t538 * t850) -
        (motion->constants[20] * t966) - (t309 * t908);
    const float t1030 = t776 * ((t123 * t474) + (t514 * t797) - (t36 * t469) - (t141 * t805));
    const float t1031 = t776 * t1030;
    const float t1032 = speeds[1] * t1031;
    const float t1036 = t776 * ((motion->constants[7] * t123) + (t506 * t797));
    const float t1037 = t776 * t1036;
    const float t1039 = t25 * t785;
    const float t1044 = t776 * ((t517 * t797) - (t147 * t805));
    const float t1045 = t776 * t1044;
    const float t1058 = (t780 * t1039) + (t665 * t801) + (t320 * t888) + (motion->constants[20] *
        t981) + (t330 * t950) - t1032;
    const float t1063 = t1058 - (speeds[2] * t1037) - (speeds[0] * t1045) - (t318 * t875) -
        (motion->constants[19] * t956) - (t328 * t908);
    const float t1067 = sin_delta * motion->constants[41];
    const float t1068 = sin_delta * t1067;
    const float t1072 = motion->constants[32] + motion->constants[36] + motion->constants[43] -
        t1068;
    const float t1074 = cos_delta * motion->constants[34];
    const float t1075 = motion->constants[23] * t1074;
    const float t1078 = t1075 + t1075 + motion->constants[46];
    const float t1081 = motion->constants[33] + motion->constants[39];
    const float t1082 = t1078 + t1081;
    const float t1083 = t1082 - t1072;
    const float t1084 = t7 * t7;
    const float t1086 = t7 * t12;
    const float t1088 = motion->constants[24] * t1074;
    const float t1092 = cos_delta * motion->constants[37];
    const float t1093 = motion->constants[30] + t1092;
    const float t1096 = t1093 - motion->constants[44] - t1088 - motion->constants[45];
    const float t1097 = t1096 + t1096;
    const float t1099 = (t1083 * t1084) + (t1086 * t1097);
    const float t1104 = t1074 + motion->constants[42];
    const float t1105 = motion->constants[28] + t1104;
    const float t1107 = (t12 * motion->constants[47]) - (t7 * t1105);
    const float t1108 = motion->constants[7] * t1107;
    const float t1111 = motion->constants[49] - t1108 - t1108;
    const float t1112 = sin_delta * motion->constants[37];
    const float t1113 = sin_delta * motion->constants[34];
    const float t1115 = t1112 - (motion->constants[24] * t1113);
    const float t1119 = (cos_delta * t1067) - (motion->constants[23] * t1113);
    const float t1121 = (t7 * t1115) + (t12 * t1119);
    const float t1123 = t147 - (sin_phi * t517);
    const float t1133 = t1096 + (t1083 * t1086) + (motion->constants[7] * ((t7 *
        motion->constants[47]) + (t12 * t1105))) - (t1084 * t1097);
    const float t1134 = cos_phi * t517;
    const float t1142 = t1068 + motion->constants[43] + t1078 + t1111 + motion->constants[31] +
        motion->constants[38];
    const float t1146 = motion->constants[7] * t1113;
    const float t1148 = (t12 * t1115) + t1146 - (t7 * t1119);
    const float t1154 = t1082 - t1099;
    const float t1160 = t1123 * motion->constants[21];
    const float t1164 = t7 * sin_delta;
    const float t1168 = t1044 + (cos_delta * t1123) - (t12 * sin_delta) - (t1134 * t1164);
    const float t1170 = t1168 * motion->constants[22];
    const float t1176 = t1072 + t1099 + t1111 + (t1121 * t1123) + (t1123 * (t1121 + (t1123 *
        t1142) - (t1134 * t1148))) + (t1123 * t1160);
    const float t1179 = t1176 + (t1168 * t1170) - (t1133 * t1134) - (t1134 * (t1133 + (t1123 *
        t1148) - (t1134 * t1154)));
    const float t1180 = 1.0F / t1179;
    const float t1185 = (speeds[0] * t517) + (speeds[1] * t514) + (speeds[2] * t506);
    const float t1186 = sin_phi * t1185;
    const float t1187 = t298 - t1186;
    const float t1188 = t12 * speeds[0];
    const float t1189 = cos_phi * t1185;
    const float t1191 = t1188 + (t7 * t1189);
    const float t1192 = motion->constants[30] * t1191;
    const float t1194 = t7 * speeds[0];
    const float t1195 = t1194 - (t12 * t1189);
    const float t1197 = t1192 + (motion->constants[33] * t1195);
    const float t1200 = speeds[2] + t1187;
    const float t1202 = (motion->constants[31] * t1187) + (motion->constants[21] * t1200);
    const float t1204 = (t1187 * t1197) - (t1195 * t1202);
    const float t1206 = motion->constants[7] * t1186;
    const float t1207 = t1189 * t1206;
    const float t1209 = sin_phi * motion->constants[40];
    const float t1210 = t299 * t1189;
    const float t1213 = t1207 - (motion->constants[7] * t1210);
    const float t1214 = t1209 + t1213;
    const float t1216 = t298 * t1195;
    const float t1217 = speeds[0] * t1186;
    const float t1218 = motion->constants[24] * t1187;
    const float t1220 = motion->constants[23] * t1187;
    const float t1222 = (t1195 * t1218) + (t1191 * t1220);
    const float t1224 = t298 * t1191;
    const float t1225 = (t12 * t1217) + t1224;
    const float t1228 = t1216 + (t7 * t1217);
    const float t1232 = t1222 + (motion->constants[23] * t1225) + (motion->constants[24] * t1228) -
        t1213;
    const float t1235 = motion->constants[23] * t1195;
    const float t1236 = motion->constants[24] * t1191;
    const float t1237 = t1235 - t1236;
    const float t1239 = (t1187 * t1220) + (t1195 * t1237);
    const float t1240 = speeds[0] * t1189;
    const float t1243 = motion->constants[7] * speeds[0];
    const float t1244 = t1189 * t1243;
    const float t1245 = (motion->constants[7] * t1240) + t1244;
    const float t1248 = t299 - t1186;
    const float t1250 = (t1206 * t1248) - (speeds[0] * t1243);
    const float t1254 = (t12 * t1245) + (t7 * t1250) - t1239 - (motion->constants[24] * t1240);
    const float t1256 = speeds[1] + t1195;
    const float t1260 = (cos_delta * t1187) - (sin_delta * t1191);
    const float t1261 = motion->constants[26] * t1260;
    const float t1265 = (cos_delta * t1191) + (sin_delta * t1187);
    const float t1266 = motion->constants[25] * t1260;
    const float t1271 = speeds[1] * t1260;
    const float t1273 = t1271 - (cos_delta * t1228) - (sin_delta * t1240);
    const float t1275 = t30 * motion->constants[10];
    const float t1280 = (speeds[0] * t1044) + (speeds[1] * t1030) + (speeds[2] * t1036);
    const float t1282 = t1225 + (t1265 * t1280);
    const float t1284 = t27 * motion->constants[10];
    const float t1286 = t1273 - (t1256 * t1280);
    const float t1288 = t26 * t40;
    const float t1291 = (t30 * t1265) + (t27 * t1256);
    const float t1292 = t1288 * t1291;
    const float t1293 = t27 * t1292;
    const float t1294 = motion->constants[10] * t1293;
    const float t1296 = t30 * t1292;
    const float t1297 = motion->constants[10] * t1296;
    const float t1303 = (cos_delta * t1232) + (t1256 * t1261) + (t1265 * t1266) +
        (motion->constants[25] * t1225) + (t1275 * t1282) + (t1256 * t1294);
    const float t1307 = t1303 + (t1265 * t1297) - (sin_delta * t1254) - (motion->constants[26] *
        t1273) - (t1284 * t1286);
    const float t1312 = motion->constants[25] * t1256;
    const float t1313 = motion->constants[26] * t1265;
    const float t1314 = t1312 - t1313;
    const float t1318 = speeds[1] * t1265;
    const float t1320 = (sin_delta * t1228) - (cos_delta * t1240) - t1318;
    const float t1323 = t1260 + t1280;
    const float t1327 = (t30 * t1256) - (t27 * t1265);
    const float t1328 = motion->constants[10] * t1327;
    const float t1334 = (cos_delta * t1254) + (sin_delta * t1232) + (motion->constants[26] *
        t1320) + (t1284 * t1320) - (t1260 * t1266) - (t1256 * t1314);
    const float t1336 = t1334 - (t1297 * t1323) - (t1256 * t1328);
    const float t1340 = (t1191 * t1237) - (t1187 * t1218);
    const float t1354 = t1340 + (motion->constants[23] * t1240) + (t7 * t1245) + (t1265 * t1314) +
        (t1265 * t1328) - (t12 * t1250);
    const float t1358 = t1354 - (t1260 * t1261) - (motion->constants[25] * t1320) - (t1275 *
        t1320) - (t1294 * t1323);
    const float t1360 = (t30 * t1336) + (t27 * t1358);
    const float t1365 = t53 * ((t40 * t1307) + (t25 * t1360));
    const float t1369 = t443 * ((t25 * t1307) + (t486 * t1365) - (t40 * t1360));
    const float t1371 = t1217 - (cos_phi * t1369);
    const float t1373 = t1216 + (t7 * t1371);
    const float t1376 = t1224 + (t12 * t1371);
    const float t1380 = motion->constants[30] * t1195;
    const float t1381 = (motion->constants[32] * t1191) + t1380;
    const float t1383 = (t1191 * t1202) - (t1187 * t1381);
    const float t1388 = t1222 + (motion->constants[23] * t1376) + (motion->constants[24] * t1373) -
        t1214;
    const float t1391 = t1240 - t1365;
    const float t1392 = (sin_phi * t1369) + t1391;
    const float t1395 = (motion->constants[7] * t1392) + t1244;
    const float t1398 = t1250 + (cos_phi * motion->constants[40]);
    const float t1399 = t7 * t1398;
    const float t1400 = t1399 + (t12 * t1395);
    const float t1402 = t1400 - (motion->constants[24] * t1392) - t1239;
    const float t1404 = (cos_delta * t1388) - (sin_delta * t1402);
    const float t1409 = t1271 - (sin_delta * t1392) - (cos_delta * t1373);
    const float t1414 = (motion->constants[38] * t1260) + (motion->constants[22] * t1323);
    const float t1417 = motion->constants[37] * t1256;
    const float t1418 = (motion->constants[36] * t1265) + t1417;
    const float t1420 = (t1265 * t1414) - (t1260 * t1418);
    const float t1423 = (motion->constants[34] * t1404) + (motion->constants[37] * t1409) +
        (motion->constants[39] * t1376) + t1420;
    const float t1427 = (cos_delta * t1402) + (sin_delta * t1388);
    const float t1433 = (sin_delta * t1373) - (cos_delta * t1392) - t1318;
    const float t1435 = motion->constants[34] * t1260;
    const float t1437 = motion->constants[34] * t1256;
    const float t1438 = t1265 * motion->constants[35];
    const float t1439 = t1437 - t1438;
    const float t1441 = (t1260 * t1435) + (t1256 * t1439);
    const float t1443 = (motion->constants[17] * t1427) + (motion->constants[35] * t1433) - t1441;
    const float t1448 = t1260 * motion->constants[35];
    const float t1451 = (t1256 * t1448) + (t1265 * t1435);
    const float t1454 = (t1404 * motion->constants[17]) + (motion->constants[34] * t1376) + t1451 -
        (t1409 * motion->constants[35]);
    const float t1456 = (sin_delta * t1443) + (cos_delta * t1454);
    const float t1462 = (motion->constants[33] * t1376) + t1383 + t1423 + (motion->constants[23] *
        t1456) - (motion->constants[28] * t1214) - (motion->constants[30] * t1373);
    const float t1470 = motion->constants[37] * t1265;
    const float t1472 = t1470 + (motion->constants[39] * t1256);
    const float t1475 = (t1260 * t1472) - (t1256 * t1414);
    const float t1478 = (motion->constants[36] * t1409) + (motion->constants[37] * t1376) + t1475 -
        (t1404 * motion->constants[35]);
    const float t1482 = t12 * t1398;
    const float t1484 = t1482 - (t7 * t1395);
    const float t1486 = t1340 + (motion->constants[23] * t1392) - t1484;
    const float t1496 = t776 * ((t30 * t1358) + (t797 * t1369) - (t27 * t1336) - (t805 * t1365));
    const float t1498 = motion->constants[22] * (t1433 + t1496);
    const float t1501 = (t1256 * t1418) - (t1265 * t1472);
    const float t1505 = (t1427 * motion->constants[35]) + (motion->constants[38] * t1433) + t1498 +
        t1501 - (motion->constants[34] * t1486);
    const float t1512 = t1204 + (motion->constants[29] * t1214) + (motion->constants[30] * t1376) +
        (cos_delta * t1478) - (motion->constants[32] * t1373) - (sin_delta * t1505);
    const float t1513 = t1512 - (motion->constants[24] * t1456);
    const float t1519 = t1187 * motion->constants[29];
    const float t1521 = motion->constants[28] * t1187;
    const float t1523 = (t1195 * t1519) + (t1191 * t1521);
    const float t1528 = motion->constants[7] * (t1456 + (motion->constants[28] * t1376) +
        (motion->constants[29] * t1373) + t1523 - (t1214 * motion->constants[1]));
    const float t1534 = (t1195 * t1381) - (t1191 * t1197);
    const float t1539 = (cos_delta * t1443) - (sin_delta * t1454);
    const float t1545 = (t1265 * t1439) - (t1260 * t1448);
    const float t1547 = (motion->constants[17] * t1486) + t1545 - (motion->constants[34] * t1433);
    const float t1552 = motion->constants[28] * t1195;
    const float t1553 = t1191 * motion->constants[29];
    const float t1554 = t1552 - t1553;
    const float t1557 = (t1191 * t1554) - (t1187 * t1519);
    const float t1566 = (t1187 * t1521) + (t1195 * t1554);
    const float t1571 = (t7 * (t1547 + t1557 - (t1484 * motion->constants[1]) +
        (motion->constants[28] * t1392))) + (t12 * (t1539 + (t1400 * motion->constants[1]) -
        (motion->constants[29] * t1392) - t1566));
    const float t1573 = (motion->constants[21] * t1392) + (motion->constants[7] * t1571);
    const float t1578 = (motion->constants[29] * t1400) + (motion->constants[28] * t1484) -
        (motion->constants[31] * t1392) + t1534 + (sin_delta * t1478) + (cos_delta * t1505);
    const float t1581 = t1578 + (motion->constants[24] * t1539) - t1573 - (motion->constants[23] *
        t1547);
    const float t1585 = (t12 * t1462) - (t7 * t1513);
    const float t1592 = forces[0] + (t1134 * t1585) - (t7 * t1462) - (t12 * t1513) - t1528 -
        (t1123 * t1581);
    const float t1593 = t1592 - (t1044 * t1498);
    const float t1595 = t1075 + motion->constants[39];
    const float t1597 = t1092 - t1088;
    const float t1601 = t141 - (sin_phi * t514);
    const float t1603 = cos_phi * t514;
    const float t1605 = t12 * t1113;
    const float t1606 = motion->constants[7] * t1605;
    const float t1607 = t1115 + t1606;
    const float t1611 = t1607 + (t1142 * t1601) - (t1148 * t1603);
    const float t1615 = (t12 * t1595) - (t7 * t1597);
    const float t1619 = t1615 + (t1148 * t1601) - (t1154 * t1603);
    const float t1625 = (t1164 * t1603) - t1030 - (cos_delta * t1601);
    const float t1631 = (t7 * t1595) + (t12 * t1597) + (motion->constants[7] * t1074) + (t1121 *
        t1601) + (t1123 * t1611) + (t1160 * t1601);
    const float t1635 = t1180 * (t1631 - (t1133 * t1603) - (t1134 * t1619) - (t1170 * t1625));
    const float t1640 = motion->constants[21] * t1601;
    const float t1642 = motion->constants[22] * t1625;
    const float t1644 = t1179 * t1635;
    const float t1650 = motion->constants[39] + (t1601 * t1611) + (t1601 * t1607) + (t1601 *
        t1640) + (t1625 * t1642) - (t1603 * t1619);
    const float t1652 = t1650 - (t1603 * t1615) - (t1635 * t1644);
    const float t1653 = 1.0F / t1652;
    const float t1663 = forces[1] + (t1585 * t1603) - t1423 - (t1581 * t1601) - (t1030 * t1498) -
        (t1593 * t1635);
    const float t1667 = motion->constants[7] * (t1107 - motion->constants[48]);
    const float t1668 = sin_phi * t506;
    const float t1670 = cos_phi * t506;
    const float t1673 = t1667 + (t1142 * t1668) + (t1148 * t1670);
    const float t1678 = t1146 - (t1148 * t1668) - (t1154 * t1670);
    const float t1683 = 1.0F - t1668;
    const float t1688 = (t1164 * t1670) + (cos_delta * t1668) - t1036;
    const float t1700 = (t1160 * t1683) - (t1121 * t1668) - (t1133 * t1670) - (t1123 * t1673) -
        (t1134 * t1678) - (t1170 * t1688);
    const float t1701 = t1180 * t1700;
    const float t1707 = t1606 + (t1640 * t1683) + (t1642 * t1688) - (t1601 * t1673) - (t1603 *
        t1678) - (t1607 * t1668);
    const float t1710 = t1653 * (t1707 - (t1615 * t1670) - (t1644 * t1701));
    const float t1720 = (t1581 * t1668) + (t1585 * t1670) + t1573 - (t1036 * t1498) - (t1593 *
        t1701) - (t1663 * t1710);
    const float t1728 = motion->constants[22] * t1688;
    const float t1738 = (t1668 * t1673) + (t1667 * t1668) + motion->constants[50] +
        (motion->constants[21] * t1683 * t1683) + (t1688 * t1728) - (t1670 * t1678);
    const float t1742 = 1.0F / (t1738 - (t1146 * t1670) - (t1179 * t1701 * t1701) - (t1652 * t1710 *
        t1710));
    const float t1743 = t1720 * t1742;
    const float t1745 = (t1653 * t1663) - (t1710 * t1743);
    const float t1749 = (t1180 * t1593) - (t1635 * t1745) - (t1701 * t1743);
    const float t1750 = t1210 + t1749;
    const float t1753 = t1207 + t1209 - (motion->constants[7] * t1750);
    const float t1761 = t1369 + (t517 * t1749) + (t514 * t1745) + (t506 * t1743);
    const float t1763 = t1217 - (cos_phi * t1761);
    const float t1766 = (t12 * t1749) - t1216 - (t7 * t1763);
    const float t1771 = t1224 + (t12 * t1763) + (t7 * t1749);
    const float t1777 = t1222 + (motion->constants[23] * t1771) - t1753 - (motion->constants[24] *
        t1766);
    const float t1784 = (t147 * t1749) + (t141 * t1745) - (sin_phi * t1761) - t1391;
    const float t1786 = t1743 + t1784;
    const float t1788 = (motion->constants[7] * t1786) - t1244;
    const float t1790 = t1399 - (t12 * t1788);
    const float t1792 = (motion->constants[24] * t1784) + t1790 - t1239;
    const float t1794 = (cos_delta * t1777) - (sin_delta * t1792);
    const float t1799 = t1271 + (cos_delta * t1766) + (sin_delta * t1784);
    const float t1801 = t1745 + t1771;
    const float t1805 = t1475 + (motion->constants[36] * t1799) + (motion->constants[37] * t1801) -
        (motion->constants[35] * t1794);
    const float t1809 = (cos_delta * t1792) + (sin_delta * t1777);
    const float t1813 = t1482 + (t7 * t1788);
    const float t1815 = t1340 - (motion->constants[23] * t1784) - t1813;
    const float t1820 = (cos_delta * t1784) - t1318 - (sin_delta * t1766);
    const float t1828 = t1496 + t1820 + (t1044 * t1749) + (t1030 * t1745) + (t1036 * t1743);
    const float t1829 = motion->constants[22] * t1828;
    const float t1833 = t1501 + (motion->constants[35] * t1809) + (motion->constants[38] * t1820) +
        t1829 - (motion->constants[34] * t1815);
    const float t1838 = (motion->constants[17] * t1809) + (motion->constants[35] * t1820) - t1441;
    const float t1845 = t1451 + (motion->constants[17] * t1794) + (motion->constants[34] * t1801) -
        (motion->constants[35] * t1799);
    const float t1847 = (sin_delta * t1838) + (cos_delta * t1845);
    const float t1853 = t1204 + (motion->constants[29] * t1753) + (motion->constants[32] * t1766) +
        (motion->constants[30] * t1771) + (cos_delta * t1805) - (sin_delta * t1833);
    const float t1854 = t1853 - (motion->constants[24] * t1847);
    const float t1859 = (cos_delta * t1838) - (sin_delta * t1845);
    const float t1862 = (motion->constants[1] * t1790) + (motion->constants[29] * t1784) + t1859 -
        t1566;
    const float t1863 = motion->constants[7] * t1862;
    const float t1877 = t1383 + t1420 + (motion->constants[30] * t1766) + (motion->constants[33] *
        t1771) + (motion->constants[34] * t1794) + (motion->constants[37] * t1799) +
        (motion->constants[39] * t1801);
    const float t1879 = t1877 + (motion->constants[23] * t1847) - (motion->constants[28] * t1753);
    const float t1881 = t776 * motion->constants[22];
    const float t1882 = t1358 * t1881;
    const float t1884 = t1336 * t1881;
    const float t1886 = t797 * t1881;
    const float t1887 = t443 * t1307;
    const float t1889 = t40 * t443;
    const float t1890 = t1336 * t1889;
    const float t1892 = t1358 * t1889;
    const float t1895 = (t93 * t1887) + (t94 * t1890) - (t100 * t1892);
    const float t1898 = (t1886 * t1895) - (t94 * t1882) - (t100 * t1884);
    const float t1900 = t12 * motion->constants[7];
    const float t1901 = motion->constants[1] * t1900;
    const float t1902 = motion->constants[29] - t1901;
    const float t1904 = t7 * t1113;
    const float t1905 = cos_delta * motion->constants[35];
    const float t1907 = sin_delta * motion->constants[35];
    const float t1909 = (cos_delta * t1907) - (sin_delta * t1905);
    const float t1913 = (sin_delta * t1907) + (cos_delta * t1905);
    const float t1916 = t1605 + (t7 * t1909);
    const float t1918 = sin_delta * motion->constants[17];
    const float t1920 = cos_delta * motion->constants[23];
    const float t1922 = cos_delta * motion->constants[24];
    const float t1924 = sin_delta * motion->constants[24];
    const float t1925 = sin_delta * t1900;
    const float t1926 = t1925 - t1924;
    const float t1930 = (t12 * t1920) + (t7 * t1922);
    const float t1935 = (t12 * t1922) + (t1134 * t1930) - (cos_delta * motion->constants[7]) - (t7 *
        t1920) - (t1123 * t1926);
    const float t1937 = cos_delta * motion->constants[17];
    const float t1939 = sin_delta * motion->constants[23];
    const float t1942 = cos_delta * t1900;
    const float t1943 = t1922 - t1942;
    const float t1947 = (t12 * t1939) + (t7 * t1924);
    const float t1952 = (t12 * t1924) + (t1134 * t1947) - (sin_delta * motion->constants[7]) - (t7 *
        t1939) - (t1123 * t1943);
    const float t1958 = t1904 + (t1937 * t1952) - (t12 * t1909) - (t1123 * t1913) - (t1134 *
        t1916) - (t1918 * t1935);
    const float t1959 = t1958 - (t1123 * t1902);
    const float t1961 = t7 * motion->constants[7];
    const float t1963 = motion->constants[17] * t1961;
    const float t1964 = (motion->constants[1] * t1961) + t1963;
    const float t1965 = t1964 + t1105;
    const float t1968 = t1605 + (t1134 * t1904);
    const float t1969 = t1968 - (t1123 * t1965);
    const float t1977 = (t12 * t1081) - (t7 * t1093);
    const float t1985 = (t12 * t1074) + (t7 * t1913);
    const float t1993 = (t12 * t1913) + (t1134 * t1985) + (t1935 * t1937) + (t1918 * t1952) - (t7 *
        t1074) - (t1123 * t1909);
    const float t1999 = (t1134 * t1977) + (motion->constants[34] * t1935) + (motion->constants[23] *
        t1993) - (motion->constants[7] * motion->constants[28]) - (t7 * t1081) - (t12 * t1093);
    const float t2000 = t1999 - (t1112 * t1123);
    const float t2007 = (t12 * motion->constants[30]) - (t7 * motion->constants[32]);
    const float t2010 = sin_delta * motion->constants[38];
    const float t2012 = motion->constants[23] * motion->constants[34];
    const float t2013 = motion->constants[34] * t1961;
    const float t2016 = t2012 + t2013 + (cos_delta * motion->constants[38]);
    const float t2018 = t7 * t2010;
    const float t2024 = (t12 * t2010) + (t1134 * t2018) + (motion->constants[35] * t1952) - t1170 -
        (t1123 * t2016);
    const float t2027 = cos_delta * motion->constants[36];
    const float t2029 = sin_delta * motion->constants[36];
    const float t2033 = (t12 * motion->constants[37]) - (t7 * t2027);
    const float t2039 = (t1134 * t2033) - (t7 * motion->constants[37]) - (t12 * t2027) - (t1123 *
        t2029) - (motion->constants[35] * t1935);
    const float t2045 = (motion->constants[7] * motion->constants[29]) + (t1134 * t2007) +
        (cos_delta * t2039) - (t7 * motion->constants[30]) - (t12 * motion->constants[32]) -
        (motion->constants[24] * t1993);
    const float t2046 = t2045 - (sin_delta * t2024);
    const float t2048 = t7 * t145;
    const float t2050 = t12 * t145;
    const float t2053 = sin_delta * t2012;
    const float t2055 = motion->constants[31] + motion->constants[21];
    const float t2060 = (motion->constants[29] * t1900) - (motion->constants[28] * t1961) -
        (motion->constants[42] * t1961);
    const float t2064 = motion->constants[46] + t2055 + (cos_delta * t2012) - t2060;
    const float t2066 = t7 * t2053;
    const float t2075 = (t12 * t2053) + (t1134 * t2066) + (motion->constants[24] * t1958) +
        (cos_delta * t2024) + (sin_delta * t2039) - (t1123 * t2064);
    const float t2081 = (t1959 * t2050) + (t16 * t2046) - (t1969 * t2048) - (t13 * t2000) -
        (sin_phi * t2075);
    const float t2083 = t53 * t1360;
    const float t2085 = t25 * t53;
    const float t2086 = t1336 * t2085;
    const float t2088 = t1358 * t2085;
    const float t2091 = (t93 * t2083) + (t100 * t2088) - (t94 * t2086);
    const float t2095 = (t487 * t1886) - (t805 * t1881);
    const float t2102 = t2075 + (t1961 * t1969) + (t487 * t2081) - (t1168 * t2095) - (t1900 *
        t1959);
    const float t2104 = motion->constants[10] * t1320;
    const float t2105 = motion->constants[10] * t1256;
    const float t2107 = (t1265 * t2105) - t2104;
    const float t2109 = motion->constants[10] * t1292;
    const float t2110 = t1323 * t2109;
    const float t2111 = motion->constants[10] * t1265;
    const float t2113 = t2110 + (t1265 * t2111);
    const float t2116 = t1250 + (t94 * t2107) + (t100 * t2113);
    const float t2118 = t27 * t1889;
    const float t2120 = (t30 * t1881) - (t1886 * t2118);
    const float t2123 = t27 * t2085;
    const float t2126 = (t2102 * t2123) - (t1168 * t2120) - (t2081 * t2118);
    const float t2128 = motion->constants[25] + t1275;
    const float t2131 = motion->constants[23] * t1217;
    const float t2135 = (motion->constants[10] * t1282) + (t1265 * t2109);
    const float t2139 = (t1256 * t2109) - (motion->constants[10] * t1286);
    const float t2144 = (t1217 * t2128) + (cos_delta * t2131) + (t100 * t2139) - (sin_delta *
        t1245) - (t94 * t2135);
    const float t2145 = t25 * t443;
    const float t2146 = t1886 * t2145;
    const float t2149 = t40 * t53;
    const float t2152 = (t2081 * t2145) + (t2102 * t2149) - (t1168 * t2146);
    const float t2157 = t2110 + (t1256 * t2105);
    const float t2160 = t2104 + (t1256 * t2111);
    const float t2164 = (cos_delta * t1245) + (sin_delta * t2131) + (t94 * t2157) + (t100 * t2160);
    const float t2166 = t30 * t1889;
    const float t2168 = (t27 * t1881) + (t1886 * t2166);
    const float t2171 = t30 * t2085;
    const float t2174 = (t1168 * t2168) + (t2102 * t2171) - (t2081 * t2166);
    const float t2176 = t26 * t1291;
    const float t2177 = t1288 * t2176;
    const float t2179 = t1265 * t1288;
    const float t2181 = t1256 * t1288;
    const float t2184 = (t100 * t2181) - (t93 * t2177) - (t94 * t2179);
    const float t2185 = t1284 * t1323;
    const float t2187 = t1256 * t1284;
    const float t2188 = t1265 * t1275;
    const float t2189 = t2187 + t2188;
    const float t2190 = t2152 * t2189;
    const float t2191 = t1275 * t1323;
    const float t2194 = t2190 - (t2126 * t2185) - (t2174 * t2191);
    const float t2198 = motion->constants[38] + motion->constants[22];
    const float t2200 = (t1265 * t2198) - t1418;
    const float t2203 = t1414 - (motion->constants[36] * t1260);
    const float t2205 = (cos_delta * t2203) - (sin_delta * t2200);
    const float t2207 = t1202 + t2205 - (motion->constants[32] * t1187);
    const float t2209 = motion->constants[30] * t1187;
    const float t2210 = motion->constants[37] * t1260;
    const float t2213 = t1472 - (t1256 * t2198);
    const float t2215 = (cos_delta * t2210) - (sin_delta * t2213);
    const float t2219 = (motion->constants[36] * t1256) - t1470 - t1472;
    const float t2220 = cos_delta * t2219;
    const float t2223 = t2209 + (cos_delta * t2215) - (sin_delta * t2220);
    const float t2226 = t1195 * motion->constants[29];
    const float t2230 = t1448 + t1448;
    const float t2232 = t1439 - t1438;
    const float t2234 = (sin_delta * t2230) + (cos_delta * t2232);
    const float t2237 = (t1900 * t2226) + (t1961 * (t1554 - t1553)) + (t1961 * t2234);
    const float t2245 = (motion->constants[32] * t1195) + (sin_delta * t2215) + (cos_delta *
        t2220) - t1192 - t1197 - t2237;
    const float t2246 = t2245 - (motion->constants[23] * t2234);
    const float t2250 = (t12 * t2207) - (t7 * t2223);
    const float t2252 = t1256 * motion->constants[35];
    const float t2253 = motion->constants[34] * t1265;
    const float t2254 = t2252 + t2253;
    const float t2257 = (cos_delta * t1435) - (sin_delta * t2254);
    const float t2260 = t1435 + t1435;
    const float t2262 = (cos_delta * t2252) + (sin_delta * t2260);
    const float t2265 = motion->constants[24] * t1195;
    const float t2267 = cos_delta * speeds[1];
    const float t2269 = sin_delta * speeds[1];
    const float t2272 = t1261 + t1294;
    const float t2273 = t1261 + t2272;
    const float t2277 = t1314 + t1328;
    const float t2280 = (speeds[1] * t2128) + t2277 - t1313 - (t1265 * t1284);
    const float t2282 = (sin_delta * t2273) + (cos_delta * t2280);
    const float t2287 = t1220 + (motion->constants[23] * t298);
    const float t2289 = t1256 * motion->constants[26];
    const float t2290 = motion->constants[25] * t1265;
    const float t2295 = t2289 + t2290 - (speeds[1] * motion->constants[26]) - (speeds[1] * t1284);
    const float t2298 = t1266 + t1297;
    const float t2299 = (t1275 * t1280) + t2298;
    const float t2304 = (t298 * t2128) + (cos_delta * t2287) + (cos_delta * t2299) - (sin_delta *
        t2265) - (sin_delta * t2295);
    const float t2308 = t1266 + t2298;
    const float t2310 = motion->constants[26] + t1284;
    const float t2313 = t2187 + t2289 - (speeds[1] * t2310);
    const float t2317 = (cos_delta * t2265) + (sin_delta * t2287) + (sin_delta * t2308) +
        (cos_delta * t2313);
    const float t2319 = t30 * t1288;
    const float t2320 = cos_delta * t2319;
    const float t2322 = t1237 - t1236;
    const float t2323 = t1104 + t1963;
    const float t2326 = t2126 + (t1123 * t2323) - t1968;
    const float t2332 = (t1134 * t2250) + (t1935 * t2257) + (t1952 * t2262) + (t1220 * t1993) +
        (t1958 * t2265) + (t298 * t2000);
    const float t2337 = t2332 + (t2126 * t2282) + (t2152 * t2304) + (t2174 * t2317) + (t2194 *
        t2320) + (t2322 * t2326);
    const float t2342 = t2337 - (motion->constants[7] * t1521) - (t7 * t2207) - (t12 * t2223) -
        (t1123 * t2246) - (t2024 * t2267);
    const float t2343 = t2342 - (t2039 * t2269);
    const float t2346 = t2209 + t2210;
    const float t2350 = (motion->constants[39] * t1260) - t1414;
    const float t2354 = t1417 + t1418 - (motion->constants[39] * t1265);
    const float t2358 = (motion->constants[33] * t1187) + (cos_delta * t2350) - t1202 - (sin_delta *
        t2354);
    const float t2366 = motion->constants[28] * t1191;
    const float t2370 = (t1961 * t2366) + (t1961 * t2253) - (t1900 * (t1552 + t1554));
    const float t2376 = t1380 + t1381 + (sin_delta * t2350) + (cos_delta * t2354) -
        (motion->constants[33] * t1191) - (motion->constants[23] * t2253) - t2370;
    const float t2380 = (t12 * t2346) + (t7 * t2358);
    const float t2383 = t1437 + t1439;
    const float t2386 = t1235 + t1237;
    const float t2389 = t2188 + t2290;
    const float t2396 = t2272 + (cos_delta * t1218) + (t1280 * t1284) + (sin_delta * t2386);
    const float t2404 = (sin_delta * t1218) - t1312 - t2277 - (cos_delta * t2386) - (t1256 * t1275);
    const float t2406 = t27 * t1288;
    const float t2408 = motion->constants[23] * t1191;
    const float t2410 = sin_delta * t2128;
    const float t2415 = t1922 + (cos_delta * motion->constants[26]) + (cos_delta * t1284);
    const float t2418 = t1924 + (sin_delta * t2310);
    const float t2421 = (t2152 * t2415) + (t2174 * t2418) - (t2126 * t2410);
    const float t2427 = (t7 * t2346) + (t1448 * t1935) + (t1218 * t1993) + (t2126 * t2389) +
        (t2152 * t2396) + (t2174 * t2404);
    const float t2432 = t2427 + (t2194 * t2406) + (t2326 * t2408) + (t298 * t2421) -
        (motion->constants[7] * t1519) - (t12 * t2358);
    const float t2437 = t2432 - (t1123 * t2376) - (t1134 * t2380) - (t1952 * t2383) - (t1958 *
        t2386) - (t298 * t2046);
    const float t2439 = motion->constants[22] * t1743;
    const float t2441 = motion->constants[22] * t1265;
    const float t2443 = motion->constants[22] * t1256;
    const float t2444 = cos_delta * t2443;
    const float t2446 = sin_delta * t2443;
    const float t2450 = (t12 * t2441) + (t7 * t2444);
    const float t2458 = t2190 + (t12 * t2444) + (t1123 * t2446) + (t1134 * t2450) - (t7 * t2441) -
        (t1294 * t2126);
    const float t2459 = t2458 - (t1297 * t2174);
    const float t2461 = (speeds[2] * t2459) - (t1168 * t2439);
    const float t2463 = motion->constants[22] * t1745;
    const float t2464 = t776 * t2463;
    const float t2467 = (t780 * t2459) - (t1168 * t2464);
    const float t2471 = cos_phi * (t1243 + t1243);
    const float t2472 = t12 * t2471;
    const float t2474 = t7 * t2471;
    const float t2476 = motion->constants[7] * t1189;
    const float t2481 = (sin_phi * t2476) - (cos_phi * ((motion->constants[7] * t299) - t1206));
    const float t2487 = (t12 * motion->constants[28]) + (t7 * motion->constants[29]);
    const float t2492 = (motion->constants[7] * motion->constants[1]) + (t7 *
        motion->constants[28]) - t1993 - (t12 * motion->constants[29]) - (t1134 * t2487);
    const float t2494 = sin_phi * t1188;
    const float t2496 = cos_phi * speeds[0];
    const float t2498 = sin_phi * t1194;
    const float t2505 = cos_delta * t2496;
    const float t2507 = (cos_phi * ((t7 * t1243) + (speeds[0] * (motion->constants[23] + t1961)))) +
        (t2128 * t2505);
    const float t2510 = sin_delta * speeds[0];
    const float t2519 = cos_phi * ((t12 * t1243) + (speeds[0] * (t1900 - motion->constants[24])));
    const float t2522 = (motion->constants[23] * t2494) - t2481;
    const float t2526 = (t2128 * t2494) + (cos_phi * ((motion->constants[26] * t2510) + (t1284 *
        t2510))) + (cos_delta * t2522) - (sin_delta * t2519);
    const float t2532 = (cos_delta * t2519) + (sin_delta * t2522) - (t2310 * t2505);
    const float t2536 = sin_phi * ((motion->constants[7] * t1248) - t1206);
    const float t2545 = (t12 * t1969) + (t7 * t1959) + (t55 * t2174) - (t12 * t2126) - (t1164 *
        t2152);
    const float t2553 = (cos_delta * t2200) + (sin_delta * t2203);
    const float t2555 = (t1191 * t2055) + t2553 - t1381;
    const float t2560 = (sin_delta * t2210) + (cos_delta * t2213);
    const float t2562 = sin_delta * t2219;
    const float t2566 = t1197 + (cos_delta * t2560) - (t1195 * t2055) - (sin_delta * t2562);
    const float t2574 = (sin_delta * t2232) - (cos_delta * t2230);
    const float t2577 = (t1961 * t2574) - (t1900 * (t1521 + t1521)) - (t1961 * (t1519 + t1519));
    const float t2583 = (sin_delta * t2560) + (cos_delta * t2562) - t2577 - (motion->constants[23] *
        t2574);
    const float t2587 = (t12 * t2555) - (t7 * t2566);
    const float t2591 = (sin_delta * t1435) + (cos_delta * t2254);
    const float t2595 = (sin_delta * t2252) - (cos_delta * t2260);
    const float t2597 = t2265 + t2408;
    const float t2599 = t1220 + t1220;
    const float t2605 = (sin_delta * t2280) - (cos_delta * t2273);
    const float t2613 = (sin_delta * t2599) + (cos_delta * t2597) + (cos_delta * t2295) +
        (sin_delta * t2299);
    const float t2621 = (sin_delta * t2597) + (sin_delta * t2313) - (cos_delta * t2599) -
        (cos_delta * t2308);
    const float t2623 = sin_delta * t2319;
    const float t2625 = t1218 + t1218;
    const float t2631 = (t1134 * t2587) + (t1935 * t2591) + (t1952 * t2595) + (t1993 * t2597) +
        (t2039 * t2267) + (t2126 * t2605);
    const float t2636 = t2631 + (t2152 * t2613) + (t2174 * t2621) + (t2194 * t2623) -
        (motion->constants[7] * (t2226 + t2366)) - (t7 * t2555);
    const float t2641 = t2636 - (t12 * t2566) - (t1123 * t2583) - (t1958 * t2599) - (t2024 *
        t2269) - (t2326 * t2625);
    const float t2649 = (t1959 * t2472) + (t2481 * t2492) + (t2000 * t2494) + (t2126 * t2507) +
        (t2152 * t2526) + (t2174 * t2532);
    const float t2654 = t2649 + (t2536 * t2545) + (t2421 * t2498) + (t16 * t2343) - (t1969 *
        t2474) - (t2075 * t2496);
    const float t2657 = t2654 - (t2046 * t2498) - (sin_phi * t2641) - (t13 * t2437);
    const float t2661 = (t1743 * t2081) + (speeds[2] * t2657) + (t798 * t2461);
    const float t2667 = (t1745 * t2081) + (speeds[1] * t2657) + (t797 * t2467);
    const float t2669 = motion->constants[7] * t1745;
    const float t2670 = t12 * t2669;
    const float t2672 = t7 * t2669;
    const float t2674 = speeds[1] * t2476;
    const float t2676 = speeds[1] * t1191;
    const float t2679 = speeds[1] * t1195;
    const float t2682 = t2408 + t2476;
    const float t2684 = (t1191 * t2128) + (cos_delta * t2682);
    const float t2685 = speeds[1] * t2684;
    const float t2687 = sin_delta * t2682;
    const float t2688 = speeds[1] * t2687;
    const float t2690 = speeds[1] * t1206;
    const float t2700 = (t1969 * t2672) + (t2000 * t2676) + (t1745 * t2075) + (t2152 * t2685) +
        (t2174 * t2688) + (t2545 * t2690);
    const float t2705 = t2700 + (t2421 * t2679) + (speeds[1] * t2641) + (t487 * t2667) - (t1959 *
        t2670) - (t2492 * t2674);
    const float t2707 = t2705 - (t2046 * t2679) - (t805 * t2467);
    const float t2713 = (t490 * t2667) + (t81 * t2707) - (t810 * t2467);
    const float t2719 = (t819 * t2467) + (t498 * t2667) + (t84 * t2707);
    const float t2721 = t1369 * t1881;
    const float t2725 = motion->constants[22] * t1749;
    const float t2729 = (speeds[0] * t2459) - t1829 - (t1168 * t2725);
    const float t2733 = (t829 * t2461) + (t514 * t2467) + (t832 * t2729) - (t1168 * t2721);
    const float t2735 = t1365 * t1881;
    const float t2740 = (t141 * t2467) + (t841 * t2729) - (t1168 * t2735);
    const float t2742 = t443 * t1369;
    const float t2743 = t1886 * t2742;
    const float t2758 = t1545 + (motion->constants[17] * t1815) - (motion->constants[34] * t1820);
    const float t2764 = t1557 + t2758 - (motion->constants[1] * t1813) - (motion->constants[28] *
        t1784);
    const float t2767 = (t7 * t2764) + (t12 * t1862);
    const float t2773 = t1534 + (motion->constants[29] * t1790) + (motion->constants[28] * t1813) +
        (motion->constants[31] * t1784) + (motion->constants[21] * t1786) + (sin_delta * t1805);
    const float t2777 = t2773 + (cos_delta * t1833) + (motion->constants[24] * t1859) -
        (motion->constants[23] * t2758) - (motion->constants[7] * t2767);
    const float t2783 = (sin_phi * t2777) + (cos_phi * ((t12 * t1879) - (t7 * t1854)));
    const float t2789 = t2783 + (t1749 * t2081) + (speeds[0] * t2657) + (t798 * t2729);
    const float t2794 = (t2081 * t2742) + (t507 * t2661) + (t515 * t2667) + (t518 * t2789) -
        (t1168 * t2743);
    const float t2796 = t443 * t1365;
    const float t2797 = t1886 * t2796;
    const float t2804 = (t2081 * t2796) + (t526 * t2667) + (t528 * t2789) - (t1168 * t2797);
    const float t2809 = motion->constants[7] * t1749;
    const float t2810 = t12 * t2809;
    const float t2812 = t7 * t2809;
    const float t2814 = speeds[0] * t2476;
    const float t2816 = speeds[0] * t1191;
    const float t2819 = speeds[0] * t1195;
    const float t2821 = speeds[0] * t2684;
    const float t2823 = speeds[0] * t2687;
    const float t2825 = speeds[0] * t1206;
    const float t2835 = (t1969 * t2812) + (t2000 * t2816) + (t1749 * t2075) + (t2152 * t2821) +
        (t2174 * t2823) + (t2545 * t2825);
    const float t2840 = t2835 + (t2421 * t2819) + (speeds[0] * t2641) + (t487 * t2789) - t2777 -
        (t1959 * t2810);
    const float t2843 = t2840 - (t2492 * t2814) - (t2046 * t2819) - (t860 * t2729);
    const float t2853 = (t856 * t2467) + (t532 * t2667) + (t105 * t2707) + (t53 * t2843) + (t548 *
        t2740) + (t538 * t2804);
    const float t2855 = t2853 - (t123 * t2733) - (t36 * t2794);
    const float t2857 = t142 * t1365;
    const float t2869 = t2713 + (t36 * t2733) + (t548 * t2804) - (t2102 * t2857) - (t143 * t2707) -
        (t148 * t2843);
    const float t2871 = t2869 - (t538 * t2740) - (t123 * t2794);
    const float t2877 = (t818 * t2467) + (t497 * t2667) - (sin_phi * t2855);
    const float t2883 = (t1123 * t1863) + (t1134 * t1879) + (t1398 * t1969) + (t1763 * t2000) +
        (t1749 * t2046) + (t1895 * t2081);
    const float t2888 = t2883 + (t2091 * t2102) + (t2144 * t2152) + (t2164 * t2174) + (t2184 *
        t2194) + (speeds[0] * t2343);
    const float t2893 = t2888 + (t778 * t2461) + (t793 * t2467) + (t445 * t2661) + (t480 * t2667) +
        (t72 * t2707);
    const float t2898 = t2893 + (motion->constants[24] * t2719) + (t828 * t2733) + (t525 * t2804) +
        (t120 * t2871) + (motion->constants[27] * t2877);
    const float t2904 = t2898 - t1854 - (t1168 * t1898) - (t1788 * t1959) - (t2116 * t2126) -
        (t1189 * t2437) - (motion->constants[23] * t2713);
    const float t2907 = t2904 - (t839 * t2740) - (t505 * t2794) - (t104 * t2855);
    const float t2909 = motion->constants[7] * t2764;
    const float t2921 = (t28 * t443 * t1360) + (t172 * t1887) + (t174 * t1890) + (t176 * t1892);
    const float t2924 = (t174 * t1882) - (t176 * t1884) - (t1886 * t2921);
    const float t2938 = (t28 * t53 * t1307) + (t174 * t2086) + (t176 * t2088) - (t172 * t2083);
    const float t2943 = t1245 + (t174 * t2107) - (t176 * t2113);
    const float t2949 = (t174 * t2135) + (t176 * t2139) - (sin_delta * t1250);
    const float t2955 = (cos_delta * t1250) + (t176 * t2160) - (t174 * t2157);
    const float t2963 = (t28 * t2176) + (t172 * t2177) + (t174 * t2179) + (t176 * t2181);
    const float t2986 = (t1123 * t2909) + (t1398 * t1959) + (t1788 * t1969) + (t1749 * t2000) +
        (t2102 * t2938) + (t2126 * t2943);
    const float t2991 = t2986 + (t2152 * t2949) + (t2174 * t2955) + (t2194 * t2963) + (t1217 *
        t2421) + (t1189 * t2343);
    const float t2996 = t2991 + (speeds[0] * t2437) + (t910 * t2461) + (t918 * t2467) + (t569 *
        t2661) + (t577 * t2667);
    const float t3001 = t2996 + (t162 * t2707) + (t927 * t2733) + (t588 * t2804) + (t191 * t2871) -
        t1879;
    const float t3006 = t3001 - (t1134 * t1854) - (t1168 * t2924) - (t1763 * t2046) - (t2081 *
        t2921) - (motion->constants[24] * t2713);
    const float t3011 = t3006 - (motion->constants[23] * t2719) - (t931 * t2740) - (t584 * t2794) -
        (t181 * t2855) - (t48 * t2877);
    const float t3013 = t7 * t1847;
    const float t3014 = motion->constants[34] * t1784;
    const float t3015 = sin_delta * t3014;
    const float t3017 = motion->constants[17] * t1784;
    const float t3018 = t1961 * t3017;
    const float t3023 = t3018 + (motion->constants[23] * t3017) + (cos_delta * t3014) - t2758;
    const float t3025 = t12 * t1847;
    const float t3027 = t3025 + (t7 * t3015);
    const float t3029 = t1187 * t1191;
    const float t3030 = t1771 + t3029;
    const float t3032 = t1187 * t1187;
    const float t3033 = t1195 * t1195;
    const float t3034 = t3032 + t3033;
    const float t3038 = t1225 + t3029;
    const float t3040 = (sin_delta * t3034) + (cos_delta * t3038);
    const float t3044 = (sin_delta * t3038) - (cos_delta * t3034);
    const float t3046 = t1191 * t1195;
    const float t3056 = (t12 * t3015) + (t1134 * t3027) + (t1993 * t3030) + (t1240 * t2126) +
        (t2152 * t3040) + (t2174 * t3044);
    const float t3061 = t3056 + (t2326 * t3046) + (t12 * t2871) - t3013 - (t1123 * t3023) - (t1958 *
        t3034);
    const float t3064 = t3061 - (t12 * t2713) - (t7 * t2719) - (t7 * t2877);
    const float t3068 = motion->constants[5] - t238;
    const float t3072 = (motion->constants[20] * t3068) + (motion->constants[19] *
        motion->constants[9]);
    const float t3073 = motion->constants[2] * t3072;
    const float t3074 = t3073 + t3073;
    const float t3075 = t1260 * t1265;
    const float t3076 = t7 * t3075;
    const float t3077 = t1256 * t1260;
    const float t3078 = cos_delta * t3077;
    const float t3080 = t3078 + (sin_delta * t1820);
    const float t3082 = sin_delta * t3077;
    const float t3084 = (cos_delta * t1820) - t3082;
    const float t3086 = t12 * t3075;
    const float t3088 = t3086 + (t7 * t3080);
    const float t3092 = (t12 * t3080) + (t1134 * t3088) - t3076 - (t1123 * t3084);
    const float t3096 = (motion->constants[19] * t3068) - (motion->constants[20] *
        motion->constants[9]);
    const float t3097 = motion->constants[2] * t3096;
    const float t3098 = t3077 - t1799;
    const float t3100 = t1801 + t3075;
    const float t3102 = t1256 * t1256;
    const float t3103 = t1265 * t1265;
    const float t3104 = t3102 - t3103;
    const float t3106 = (cos_delta * t3100) - (sin_delta * t3104);
    const float t3110 = (sin_delta * t3100) + (cos_delta * t3104);
    const float t3114 = (t12 * t3098) + (t7 * t3106);
    const float t3118 = (t12 * t3106) + (t1123 * t3110) + (t1134 * t3114) - (t7 * t3098);
    const float t3121 = t1256 * t1265;
    const float t3122 = sin_delta * t3121;
    const float t3123 = (cos_delta * t1799) - t3122;
    const float t3126 = cos_delta * t3121;
    const float t3127 = (sin_delta * t1799) + t3126;
    const float t3130 = t3086 + (t7 * t3123);
    const float t3134 = t3076 - (t12 * t3123) - (t1123 * t3127) - (t1134 * t3130);
    const float t3138 = (cos_delta * t1794) + (sin_delta * t1809);
    const float t3140 = t1260 * t1260;
    const float t3141 = t3103 + t3140;
    const float t3142 = t1961 * t3141;
    const float t3148 = t3142 + (motion->constants[23] * t3141) + (cos_delta * t1809) - (sin_delta *
        t1794);
    const float t3150 = t7 * t3138;
    const float t3153 = t1820 + t3121;
    const float t3158 = (t12 * t3138) + (t1134 * t3150) + (t1935 * t3098) + (t1952 * t3153) -
        (t1123 * t3148);
    const float t3162 = (t3074 * t3092) + (t3097 * t3118) + (t3074 * t3134) +
        (motion->constants[2] * t3158);
    const float t3164 = t3097 + t3097;
    const float t3166 = t3078 + t3122;
    const float t3168 = t3082 - t3126;
    const float t3172 = (t12 * t1801) - (t7 * t3166);
    const float t3176 = (t1134 * t3172) - (t7 * t1801) - (t12 * t3166) - (t1123 * t3168);
    const float t3181 = sin_delta * t1815;
    const float t3183 = t3121 - t1820;
    const float t3184 = t1961 * t3183;
    const float t3188 = t3184 + (motion->constants[23] * t3183) + (cos_delta * t1815);
    const float t3192 = (t12 * t1794) - (t7 * t3181);
    const float t3195 = t3102 + t3140;
    const float t3201 = (t1123 * t3188) + (t1134 * t3192) + (t1935 * t3100) - (t7 * t1794) - (t12 *
        t3181) - (t1952 * t3195);
    const float t3205 = (t3164 * t3176) + (t3092 * t3164) + (t3073 * t3118) +
        (motion->constants[2] * t3201);
    const float t3207 = (motion->constants[20] * t3162) + (motion->constants[19] * t3205);
    const float t3210 = t1187 * t1195;
    const float t3211 = t3210 - t1766;
    const float t3213 = t1784 + t3046;
    const float t3215 = t3046 - t1240;
    const float t3217 = t1228 + t3210;
    const float t3219 = (cos_delta * t3217) - (sin_delta * t3215);
    const float t3223 = (cos_delta * t3215) + (sin_delta * t3217);
    const float t3225 = t1191 * t1191;
    const float t3226 = t3032 + t3225;
    const float t3232 = (t7 * t2871) + (t12 * t2877);
    const float t3237 = t3025 + (t1134 * t3013) + (t1993 * t3211) + (t1958 * t3213) + (t2152 *
        t3219) + (t2174 * t3223);
    const float t3242 = t3237 + (t12 * t2719) + t3232 - (t1123 * t1859) - (t2326 * t3226) - (t7 *
        t2713);
    const float t3245 = (motion->constants[19] * t3064) + (motion->constants[20] * t3242) - t3207;
    const float t3247 = (t161 * t3011) + t3245 - (t65 * t2907);
    const float t3257 = (t1603 * t1930) - (t1601 * t1926);
    const float t3261 = (t1603 * t1947) - (t1601 * t1943);
    const float t3266 = t1113 + (t1937 * t3261) - (t1601 * t1913) - (t1603 * t1916) - (t1918 *
        t3257);
    const float t3267 = t3266 - (t1601 * t1902);
    const float t3270 = t1603 * t1904;
    const float t3271 = t3270 - (t1601 * t1965);
    const float t3283 = (t1603 * t1985) + (t1937 * t3257) + (t1918 * t3261) - t1074 - (t1601 *
        t1909);
    const float t3288 = (t1603 * t1977) + (motion->constants[34] * t3257) + (motion->constants[23] *
        t3283) - motion->constants[39] - (t1112 * t1601);
    const float t3297 = t1642 + (t1603 * t2018) + (motion->constants[35] * t3261) - (t1601 * t2016);
    const float t3304 = (t1603 * t2033) - motion->constants[37] - (t1601 * t2029) -
        (motion->constants[35] * t3257);
    const float t3308 = (t1603 * t2007) + (cos_delta * t3304) - (motion->constants[24] * t3283) -
        (sin_delta * t3297);
    const float t3321 = (t1603 * t2066) + (motion->constants[24] * t3266) + (cos_delta * t3297) +
        (sin_delta * t3304) - (t1601 * t2064);
    const float t3327 = (t2050 * t3267) + (t16 * t3308) - (t2048 * t3271) - (t13 * t3288) -
        (sin_phi * t3321);
    const float t3336 = t3321 + (t1961 * t3271) + (t1625 * t2095) + (t487 * t3327) - (t1900 *
        t3267);
    const float t3342 = (t1625 * t2120) + (t2123 * t3336) - (t2118 * t3327);
    const float t3348 = (t1625 * t2146) + (t2145 * t3327) + (t2149 * t3336);
    const float t3354 = (t2171 * t3336) - (t1625 * t2168) - (t2166 * t3327);
    const float t3357 = t2189 * t3348;
    const float t3360 = t3357 - (t2185 * t3342) - (t2191 * t3354);
    const float t3377 = t3342 + (t1601 * t2323) - t3270;
    const float t3383 = (t1603 * t2250) + (t2257 * t3257) + (t2262 * t3261) + (t1220 * t3283) +
        (t2265 * t3266) + (t298 * t3288);
    const float t3388 = t3383 + (t2282 * t3342) + (t2304 * t3348) + (t2317 * t3354) + (t2320 *
        t3360) + (t2322 * t3377);
    const float t3392 = t3388 - t2205 - (t1601 * t2246) - (t2267 * t3297) - (t2269 * t3304);
    const float t3410 = (t2415 * t3348) + (t2418 * t3354) - (t2410 * t3342);
    const float t3416 = t2210 + (t1448 * t3257) + (t1218 * t3283) + (t2389 * t3342) + (t2396 *
        t3348) + (t2404 * t3354);
    const float t3421 = t3416 + (t2406 * t3360) + (t2408 * t3377) + (t298 * t3410) - (t1601 *
        t2376) - (t1603 * t2380);
    const float t3424 = t3421 - (t2383 * t3261) - (t2386 * t3266) - (t298 * t3308);
    const float t3435 = t3357 + (t1601 * t2446) + (t1603 * t2450) - t2441 - (t1294 * t3342) -
        (t1297 * t3354);
    const float t3437 = (t1625 * t2439) + (speeds[2] * t3435);
    const float t3443 = (t1625 * t2464) + (t780 * t3435) - (t776 * t1829);
    const float t3449 = t3283 + (t1603 * t2487);
    const float t3465 = (t12 * t3271) + (t7 * t3267) + (t55 * t3354) - (t12 * t3342) - (t1164 *
        t3348);
    const float t3485 = (t1603 * t2587) + (t2591 * t3257) + (t2595 * t3261) + (t2597 * t3283) +
        (t2267 * t3304) + (t2605 * t3342);
    const float t3490 = t3485 + (t2613 * t3348) + (t2621 * t3354) + (t2623 * t3360) - t2553 -
        (t1601 * t2583);
    const float t3493 = t3490 - (t2599 * t3266) - (t2269 * t3297) - (t2625 * t3377);
    const float t3501 = (t2472 * t3267) + (t2494 * t3288) + (t2507 * t3342) + (t2526 * t3348) +
        (t2532 * t3354) + (t2536 * t3465);
    const float t3506 = t3501 + (t2498 * t3410) + (t16 * t3392) - (t2474 * t3271) - (t2481 *
        t3449) - (t2496 * t3321);
    const float t3509 = t3506 - (t2498 * t3308) - (sin_phi * t3493) - (t13 * t3424);
    const float t3513 = (t1743 * t3327) + (speeds[2] * t3509) + (t798 * t3437);
    const float t3520 = t2783 + (t1745 * t3327) + (speeds[1] * t3509) + (t797 * t3443);
    const float t3539 = (t2672 * t3271) + (t2674 * t3449) + (t2676 * t3288) + (t1745 * t3321) +
        (t2685 * t3348) + (t2688 * t3354);
    const float t3544 = t3539 + (t2690 * t3465) + (t2679 * t3410) + (speeds[1] * t3493) + (t487 *
        t3520) - t2777;
    const float t3547 = t3544 - (t2670 * t3267) - (t2679 * t3308) - (t805 * t3443);
    const float t3553 = (t490 * t3520) + (t81 * t3547) - (t810 * t3443);
    const float t3559 = (t819 * t3443) + (t498 * t3520) + (t84 * t3547);
    const float t3566 = (t1625 * t2725) + (speeds[0] * t3435);
    const float t3570 = (t1625 * t2721) + (t829 * t3437) + (t514 * t3443) + (t832 * t3566);
    const float t3576 = (t1625 * t2735) + (t141 * t3443) + (t841 * t3566);
    const float t3586 = (t1749 * t3327) + (speeds[0] * t3509) + (t798 * t3566);
    const float t3591 = (t1625 * t2743) + (t2742 * t3327) + (t507 * t3513) + (t515 * t3520) +
        (t518 * t3586);
    const float t3599 = (t1625 * t2797) + (t2796 * t3327) + (t526 * t3520) + (t528 * t3586);
    const float t3621 = (t2812 * t3271) + (t2814 * t3449) + (t2816 * t3288) + (t1749 * t3321) +
        (t2821 * t3348) + (t2823 * t3354);
    const float t3626 = t3621 + (t2825 * t3465) + (t2819 * t3410) + (speeds[0] * t3493) + (t487 *
        t3586) - (t2810 * t3267);
    const float t3628 = t3626 - (t2819 * t3308) - (t860 * t3566);
    const float t3638 = (t856 * t3443) + (t532 * t3520) + (t105 * t3547) + (t53 * t3628) + (t548 *
        t3576) + (t538 * t3599);
    const float t3640 = t3638 - (t123 * t3570) - (t36 * t3591);
    const float t3653 = t3553 + (t36 * t3570) + (t548 * t3599) - (t2857 * t3336) - (t143 * t3547) -
        (t148 * t3628);
    const float t3655 = t3653 - (t538 * t3576) - (t123 * t3591);
    const float t3661 = (t818 * t3443) + (t497 * t3520) - (sin_phi * t3640);
    const float t3667 = (t1601 * t1863) + (t1603 * t1879) + (t1625 * t1898) + (t1398 * t3271) +
        (t1763 * t3288) + (t1749 * t3308);
    const float t3672 = t3667 + (t1895 * t3327) + (t2091 * t3336) + (t2144 * t3348) + (t2164 *
        t3354) + (t2184 * t3360);
    const float t3677 = t3672 + (speeds[0] * t3392) + (t778 * t3437) + (t793 * t3443) + (t445 *
        t3513) + (t480 * t3520);
    const float t3682 = t3677 + (t72 * t3547) + (motion->constants[24] * t3559) + (t828 * t3570) +
        (t525 * t3599) + (t120 * t3655);
    const float t3687 = t3682 + (motion->constants[27] * t3661) - (t1788 * t3267) - (t2116 *
        t3342) - (t1189 * t3424) - (motion->constants[23] * t3553);
    const float t3690 = t3687 - (t839 * t3576) - (t505 * t3591) - (t104 * t3640);
    const float t3726 = (t1601 * t2909) + (t1625 * t2924) + (t1398 * t3267) + (t1788 * t3271) +
        (t1749 * t3288) + (t2938 * t3336);
    const float t3731 = t3726 + (t2943 * t3342) + (t2949 * t3348) + (t2955 * t3354) + (t2963 *
        t3360) + (t1217 * t3410);
    const float t3736 = t3731 + (t1189 * t3392) + (speeds[0] * t3424) + (t910 * t3437) + (t918 *
        t3443) + (t569 * t3513);
    const float t3741 = t3736 + (t577 * t3520) + (t162 * t3547) + (t927 * t3570) + (t588 * t3599) +
        (t191 * t3655);
    const float t3746 = t3741 - (t1603 * t1854) - (t1763 * t3308) - (t2921 * t3327) -
        (motion->constants[24] * t3553) - (motion->constants[23] * t3559);
    const float t3750 = t3746 - (t931 * t3576) - (t584 * t3591) - (t181 * t3640) - (t48 * t3661);
    const float t3769 = (t1603 * t3027) + (t3030 * t3283) + (t1240 * t3342) + (t3040 * t3348) +
        (t3044 * t3354) + (t3046 * t3377);
    const float t3774 = t3769 + (t12 * t3655) - (t1601 * t3023) - (t3034 * t3266) - (t12 * t3553) -
        (t7 * t3559);
    const float t3775 = t3774 - (t7 * t3661);
    const float t3780 = (t1603 * t3088) - t3075 - (t1601 * t3084);
    const float t3785 = (t1601 * t3110) + (t1603 * t3114) - t3098;
    const float t3790 = t3075 - (t1601 * t3127) - (t1603 * t3130);
    const float t3798 = (t1603 * t3150) + (t3098 * t3257) + (t3153 * t3261) - (t1601 * t3148);
    const float t3802 = (t3074 * t3780) + (t3097 * t3785) + (t3074 * t3790) +
        (motion->constants[2] * t3798);
    const float t3807 = (t1603 * t3172) - t1801 - (t1601 * t3168);
    const float t3818 = (t1601 * t3188) + (t1603 * t3192) + (t3100 * t3257) - t1794 - (t3195 *
        t3261);
    const float t3822 = (t3164 * t3807) + (t3164 * t3780) + (t3073 * t3785) +
        (motion->constants[2] * t3818);
    const float t3824 = (motion->constants[20] * t3802) + (motion->constants[19] * t3822);
    const float t3836 = (t7 * t3655) + (t12 * t3661);
    const float t3841 = (t1603 * t3013) + (t3211 * t3283) + (t3213 * t3266) + (t3219 * t3348) +
        (t3223 * t3354) + (t12 * t3559);
    const float t3845 = t3841 + t3836 - (t1601 * t1859) - (t3226 * t3377) - (t7 * t3553);
    const float t3848 = (motion->constants[19] * t3775) + (motion->constants[20] * t3845) - t3824;
    const float t3851 = (t161 * t3750) + t3848 - (t65 * t3690) - (t1635 * t3247);
    const float t3862 = (t1668 * t1926) + (t1670 * t1930) - t1925;
    const float t3867 = t1942 + (t1668 * t1943) + (t1670 * t1947);
    const float t3871 = (t1668 * t1913) + (t1937 * t3867) - (t1670 * t1916) - (t1918 * t3862);
    const float t3873 = t1901 + (t1668 * t1902) + t3871;
    const float t3876 = t1670 * t1904;
    const float t3878 = (t1668 * t1965) + t3876 - t1964;
    const float t3889 = (t1668 * t1909) + (t1670 * t1985) + (t1937 * t3862) + (t1918 * t3867);
    const float t3893 = (t1112 * t1668) + (t1670 * t1977) + (motion->constants[34] * t3862) +
        (motion->constants[23] * t3889);
    const float t3903 = t1728 + (t1668 * t2016) + (t1670 * t2018) + (motion->constants[35] *
        t3867) - t2013;
    const float t3909 = (t1668 * t2029) + (t1670 * t2033) - (motion->constants[35] * t3862);
    const float t3913 = (t1670 * t2007) + (cos_delta * t3909) - (motion->constants[24] * t3889) -
        (sin_delta * t3903);
    const float t3927 = t2060 + (t1668 * t2064) + (t1670 * t2066) + (motion->constants[24] *
        t3871) + (cos_delta * t3903) + (sin_delta * t3909);
    const float t3928 = t3927 - motion->constants[21];
    const float t3934 = (t2050 * t3873) + (t16 * t3913) - (t2048 * t3878) - (t13 * t3893) -
        (sin_phi * t3928);
    const float t3943 = t3928 + (t1961 * t3878) + (t1688 * t2095) + (t487 * t3934) - (t1900 *
        t3873);
    const float t3949 = (t1688 * t2120) + (t2123 * t3943) - (t2118 * t3934);
    const float t3955 = (t1688 * t2146) + (t2145 * t3934) + (t2149 * t3943);
    const float t3961 = (t2171 * t3943) - (t1688 * t2168) - (t2166 * t3934);
    const float t3964 = t2189 * t3955;
    const float t3967 = t3964 - (t2185 * t3949) - (t2191 * t3961);
    const float t3985 = t1963 + t3949 - t3876 - (t1668 * t2323);
    const float t3991 = t2237 + (t1668 * t2246) + (t1670 * t2250) + (t2257 * t3862) + (t2262 *
        t3867) + (t1220 * t3889);
    const float t3996 = t3991 + (t2265 * t3871) + (t298 * t3893) + (t2282 * t3949) + (t2304 *
        t3955) + (t2317 * t3961);
    const float t4000 = t3996 + (t2320 * t3967) + (t2322 * t3985) - (t2267 * t3903) - (t2269 *
        t3909);
    const float t4018 = (t2415 * t3955) + (t2418 * t3961) - (t2410 * t3949);
    const float t4024 = t2370 + (t1668 * t2376) + (t1448 * t3862) + (t1218 * t3889) + (t2389 *
        t3949) + (t2396 * t3955);
    const float t4029 = t4024 + (t2404 * t3961) + (t2406 * t3967) + (t2408 * t3985) + (t298 *
        t4018) - (t1670 * t2380);
    const float t4032 = t4029 - (t2383 * t3867) - (t2386 * t3871) - (t298 * t3913);
    const float t4042 = t3964 + (t1670 * t2450) - (t1668 * t2446) - (t1294 * t3949) - (t1297 *
        t3961);
    const float t4045 = (t1688 * t2439) + (speeds[2] * t4042) - t1829;
    const float t4049 = (t1688 * t2464) + (t780 * t4042);
    const float t4055 = t3889 + (t1670 * t2487);
    const float t4071 = (t12 * t3878) + (t7 * t3873) + (t55 * t3961) - (t12 * t3949) - (t1164 *
        t3955);
    const float t4091 = t2577 + (t1668 * t2583) + (t1670 * t2587) + (t2591 * t3862) + (t2595 *
        t3867) + (t2597 * t3889);
    const float t4096 = t4091 + (t2267 * t3909) + (t2605 * t3949) + (t2613 * t3955) + (t2621 *
        t3961) + (t2623 * t3967);
    const float t4099 = t4096 - (t2599 * t3871) - (t2269 * t3903) - (t2625 * t3985);
    const float t4107 = (t2472 * t3873) + (t2494 * t3893) + (t2507 * t3949) + (t2526 * t3955) +
        (t2532 * t3961) + (t2536 * t4071);
    const float t4112 = t4107 + (t2498 * t4018) + (t16 * t4000) - (t2474 * t3878) - (t2481 *
        t4055) - (t2496 * t3928);
    const float t4115 = t4112 - (t2498 * t3913) - (sin_phi * t4099) - (t13 * t4032);
    const float t4120 = t2783 + (t1743 * t3934) + (speeds[2] * t4115) + (t798 * t4045);
    const float t4126 = (t1745 * t3934) + (speeds[1] * t4115) + (t797 * t4049);
    const float t4145 = (t2672 * t3878) + (t2674 * t4055) + (t2676 * t3893) + (t1745 * t3928) +
        (t2685 * t3955) + (t2688 * t3961);
    const float t4150 = t4145 + (t2690 * t4071) + (t2679 * t4018) + (speeds[1] * t4099) + (t487 *
        t4126) - (t2670 * t3873);
    const float t4152 = t4150 - (t2679 * t3913) - (t805 * t4049);
    const float t4158 = (t490 * t4126) + (t81 * t4152) - (t810 * t4049);
    const float t4164 = (t819 * t4049) + (t498 * t4126) + (t84 * t4152);
    const float t4171 = (t1688 * t2725) + (speeds[0] * t4042);
    const float t4175 = (t1688 * t2721) + (t829 * t4045) + (t514 * t4049) + (t832 * t4171);
    const float t4181 = (t1688 * t2735) + (t141 * t4049) + (t841 * t4171);
    const float t4191 = (t1749 * t3934) + (speeds[0] * t4115) + (t798 * t4171);
    const float t4196 = (t1688 * t2743) + (t2742 * t3934) + (t507 * t4120) + (t515 * t4126) +
        (t518 * t4191);
    const float t4204 = (t1688 * t2797) + (t2796 * t3934) + (t526 * t4126) + (t528 * t4191);
    const float t4226 = (t2812 * t3878) + (t2814 * t4055) + (t2816 * t3893) + (t1749 * t3928) +
        (t2821 * t3955) + (t2823 * t3961);
    const float t4231 = t4226 + (t2825 * t4071) + (t2819 * t4018) + (speeds[0] * t4099) + (t487 *
        t4191) - (t2810 * t3873);
    const float t4233 = t4231 - (t2819 * t3913) - (t860 * t4171);
    const float t4243 = (t856 * t4049) + (t532 * t4126) + (t105 * t4152) + (t53 * t4233) + (t548 *
        t4181) + (t538 * t4204);
    const float t4245 = t4243 - (t123 * t4175) - (t36 * t4196);
    const float t4258 = t4158 + (t36 * t4175) + (t548 * t4204) - (t2857 * t3943) - (t143 * t4152) -
        (t148 * t4233);
    const float t4260 = t4258 - (t538 * t4181) - (t123 * t4196);
    const float t4266 = (t818 * t4049) + (t497 * t4126) - (sin_phi * t4245);
    const float t4272 = t1863 + (t1670 * t1879) + (t1688 * t1898) + (t1398 * t3878) + (t1763 *
        t3893) + (t1749 * t3913);
    const float t4277 = t4272 + (t1895 * t3934) + (t2091 * t3943) + (t2144 * t3955) + (t2164 *
        t3961) + (t2184 * t3967);
    const float t4282 = t4277 + (speeds[0] * t4000) + (t778 * t4045) + (t793 * t4049) + (t445 *
        t4120) + (t480 * t4126);
    const float t4287 = t4282 + (t72 * t4152) + (motion->constants[24] * t4164) + (t828 * t4175) +
        (t525 * t4204) + (t120 * t4260);
    const float t4292 = t4287 + (motion->constants[27] * t4266) - (t1668 * t1863) - (t1788 *
        t3873) - (t2116 * t3949) - (t1189 * t4032);
    const float t4296 = t4292 - (motion->constants[23] * t4158) - (t839 * t4181) - (t505 * t4196) -
        (t104 * t4245);
    const float t4332 = t2909 + (t1688 * t2924) + (t1398 * t3873) + (t1788 * t3878) + (t1749 *
        t3893) + (t2938 * t3943);
    const float t4337 = t4332 + (t2943 * t3949) + (t2949 * t3955) + (t2955 * t3961) + (t2963 *
        t3967) + (t1217 * t4018);
    const float t4342 = t4337 + (t1189 * t4000) + (speeds[0] * t4032) + (t910 * t4045) + (t918 *
        t4049) + (t569 * t4120);
    const float t4347 = t4342 + (t577 * t4126) + (t162 * t4152) + (t927 * t4175) + (t588 * t4204) +
        (t191 * t4260);
    const float t4352 = t4347 - (t1668 * t2909) - (t1670 * t1854) - (t1763 * t3913) - (t2921 *
        t3934) - (motion->constants[24] * t4158);
    const float t4357 = t4352 - (motion->constants[23] * t4164) - (t931 * t4181) - (t584 * t4196) -
        (t181 * t4245) - (t48 * t4266);
    const float t4377 = (t1668 * t3023) + (t1670 * t3027) + (t3030 * t3889) + (t1240 * t3949) +
        (t3040 * t3955) + (t3044 * t3961);
    const float t4382 = t4377 + (t3046 * t3985) + (t12 * t4260) - t3018 - (t3034 * t3871) - (t12 *
        t4158);
    const float t4384 = t4382 - (t7 * t4164) - (t7 * t4266);
    const float t4388 = (t1668 * t3084) + (t1670 * t3088);
    const float t4392 = (t1668 * t3110) - (t1670 * t3114);
    const float t4396 = (t1668 * t3127) - (t1670 * t3130);
    const float t4405 = (t1668 * t3148) + (t1670 * t3150) + (t3098 * t3862) + (t3153 * t3867) -
        t3142;
    const float t4409 = (t3074 * t4388) + (t3074 * t4396) + (motion->constants[2] * t4405) -
        (t3097 * t4392);
    const float t4413 = (t1668 * t3168) + (t1670 * t3172);
    const float t4424 = t3184 + (t1670 * t3192) + (t3100 * t3862) - (t1668 * t3188) - (t3195 *
        t3867);
    const float t4428 = (t3164 * t4413) + (t3164 * t4388) + (motion->constants[2] * t4424) -
        (t3073 * t4392);
    const float t4430 = (motion->constants[20] * t4409) + (motion->constants[19] * t4428);
    const float t4442 = (t7 * t4260) + (t12 * t4266);
    const float t4447 = (t1668 * t1859) + (t1670 * t3013) + (t3211 * t3889) + (t3213 * t3871) +
        (t3219 * t3955) + (t3223 * t3961);
    const float t4451 = t4447 + (t12 * t4164) + t4442 - (t3226 * t3985) - (t7 * t4158);
    const float t4454 = (motion->constants[19] * t4384) + (motion->constants[20] * t4451) - t4430;
    const float t4459 = t1742 * ((t161 * t4357) + t4454 - (t65 * t4296) - (t1701 * t3247) - (t1710 *
        t3851));
    const float t4461 = (t1653 * t3851) - (t1710 * t4459);
    const float t4465 = (t1180 * t3247) - (t1635 * t4461) - (t1701 * t4459);
    const float t4467 = t3077 - t1273;
    const float t4469 = t1320 + t3121;
    const float t4472 = motion->constants[26] * motion->constants[3];
    const float t4473 = t4472 + t4472;
    const float t4475 = motion->constants[25] * motion->constants[3];
    const float t4483 = t3232 + (t2152 * t4467) + (t2174 * t4469) + (t3092 * t4473) + (t3118 *
        t4475) + (t3134 * t4473);
    const float t4485 = t4483 + (t3158 * motion->constants[3]) - (t2126 * t3141);
    const float t4487 = t3121 - t1320;
    const float t4489 = t1225 + t3075;
    const float t4492 = t4475 + t4475;
    const float t4506 = (t2126 * t4487) + (t2152 * t4489) + (t3176 * t4492) + (t3092 * t4492) +
        (t3118 * t4472) + (t3201 * motion->constants[3]);
    const float t4511 = t4506 + (t972 * t2467) + (t623 * t2667) + (t28 * t2855) + (t96 * t2871) -
        (t2174 * t3195);
    const float t4512 = t4511 - (t55 * t2877);
    const float t4519 = t3245 + (t229 * t3011) - (motion->constants[20] * t4485) -
        (motion->constants[19] * t4512) - (t227 * t2907);
    const float t4532 = t3836 + (t3348 * t4467) + (t3354 * t4469) + (t3780 * t4473) + (t3785 *
        t4475) + (t3790 * t4473);
    const float t4534 = t4532 + (t3798 * motion->constants[3]) - (t3141 * t3342);
    const float t4552 = (t3342 * t4487) + (t3348 * t4489) + (t3807 * t4492) + (t3780 * t4492) +
        (t3785 * t4472) + (t3818 * motion->constants[3]);
    const float t4557 = t4552 + (t972 * t3443) + (t623 * t3520) + (t28 * t3640) + (t96 * t3655) -
        (t3195 * t3354);
    const float t4558 = t4557 - (t55 * t3661);
    const float t4567 = t3848 + (t229 * t3750) - (motion->constants[20] * t4534) -
        (motion->constants[19] * t4558) - (t227 * t3690) - (t1635 * t4519);
    const float t4580 = t4442 + (t3955 * t4467) + (t3961 * t4469) + (t4388 * t4473) + (t4396 *
        t4473) + (t4405 * motion->constants[3]);
    const float t4582 = t4580 - (t3141 * t3949) - (t4392 * t4475);
    const float t4600 = (t3949 * t4487) + (t3955 * t4489) + (t4413 * t4492) + (t4388 * t4492) +
        (t4424 * motion->constants[3]) + (t972 * t4049);
    const float t4605 = t4600 + (t623 * t4126) + (t28 * t4245) + (t96 * t4260) - (t3195 * t3961) -
        (t4392 * t4472);
    const float t4606 = t4605 - (t55 * t4266);
    const float t4616 = t4454 + (t229 * t4357) - (motion->constants[20] * t4582) -
        (motion->constants[19] * t4606) - (t227 * t4296) - (t1701 * t4519);
    const float t4618 = t1742 * (t4616 - (t1710 * t4567));
    const float t4620 = (t1653 * t4567) - (t1710 * t4618);
    const float t4624 = (t1180 * t4519) - (t1635 * t4620) - (t1701 * t4618);
    const float t4626 = motion->constants[20] * motion->constants[14];
    const float t4629 = t4626 + (motion->constants[19] * motion->constants[16]);
    const float t4634 = motion->constants[19] * motion->constants[14];
    const float t4635 = (motion->constants[20] * motion->constants[12]) + t4634;
    const float t4638 = (motion->constants[19] * (t4635 + t4635)) - (motion->constants[20] *
        (t4629 + t4629));
    const float t4641 = t4634 - (motion->constants[20] * motion->constants[16]);
    const float t4645 = (motion->constants[19] * motion->constants[12]) - t4626;
    const float t4648 = (motion->constants[19] * (t4645 - t4629)) - (motion->constants[20] *
        (t4635 + t4641));
    const float t4654 = (motion->constants[20] * (t4645 + t4645)) + (motion->constants[19] *
        (t4641 + t4641));
    const float t4659 = motion->constants[20] * motion->constants[13];
    const float t4662 = t4659 + (motion->constants[19] * motion->constants[15]);
    const float t4667 = motion->constants[19] * motion->constants[13];
    const float t4668 = (motion->constants[20] * motion->constants[11]) + t4667;
    const float t4671 = (motion->constants[19] * (t4668 + t4668)) - (motion->constants[20] *
        (t4662 + t4662));
    const float t4673 = t12 * t3210;
    const float t4674 = t1123 * t3046;
    const float t4676 = t7 * t3210;
    const float t4677 = (t12 * t1771) - t4676;
    const float t4681 = t4674 + (t1134 * t4677) - (t7 * t1771) - t4673;
    const float t4684 = (motion->constants[19] * motion->constants[11]) - t4659;
    const float t4688 = t4667 - (motion->constants[20] * motion->constants[15]);
    const float t4691 = (motion->constants[20] * (t4684 + t4684)) + (motion->constants[19] *
        (t4688 + t4688));
    const float t4692 = t7 * t3029;
    const float t4694 = t12 * t3029;
    const float t4696 = t4694 + (t7 * t1766);
    const float t4700 = t4692 - t4674 - (t12 * t1766) - (t1134 * t4696);
    const float t4706 = (motion->constants[19] * (t4684 - t4662)) - (motion->constants[20] *
        (t4668 + t4688));
    const float t4709 = t3033 - t3225;
    const float t4713 = (t12 * t3211) + (t7 * t3030);
    const float t4717 = (t12 * t3030) + (t1123 * t4709) + (t1134 * t4713) - (t7 * t3211);
    const float t4722 = motion->constants[7] + motion->constants[8];
    const float t4724 = (motion->constants[19] * motion->constants[4]) - (motion->constants[20] *
        t4722);
    const float t4726 = motion->constants[7] * t3211;
    const float t4728 = t1753 * motion->constants[0];
    const float t4729 = t12 * t4728;
    const float t4733 = (t1900 * t3213) - (t1961 * t3226);
    const float t4734 = motion->constants[0] * t4733;
    const float t4735 = (t1790 * motion->constants[0]) - t4734;
    const float t4737 = t7 * t4728;
    const float t4739 = motion->constants[29] + motion->constants[29];
    const float t4742 = t4676 + t4694;
    const float t4746 = t4673 + (t1134 * t4742) - t4692 - (t1123 * t1784);
    const float t4753 = (t4700 * t4739) + (t4739 * t4746) + (motion->constants[28] * t4717) -
        (motion->constants[0] * t4726) - t4729 - (t1123 * t4735);
    const float t4754 = t4753 - (t1134 * t4737);
    const float t4758 = (motion->constants[20] * motion->constants[4]) + (motion->constants[19] *
        t4722);
    const float t4759 = motion->constants[7] * t3030;
    const float t4764 = (t1961 * (t3046 - t1784)) - (t1900 * t3034);
    const float t4765 = motion->constants[0] * t4764;
    const float t4767 = (t1813 * motion->constants[0]) - t4765;
    const float t4770 = motion->constants[28] + motion->constants[28];
    const float t4778 = t4737 + (t4681 * t4770) + (t4746 * t4770) + (motion->constants[29] *
        t4717) - (motion->constants[0] * t4759) - (t1123 * t4767);
    const float t4779 = t4778 - (t1134 * t4729);
    const float t4791 = (t3176 * t4638) + (t3096 * t3162) + (t4671 * t4681) + (t4724 * t4754) +
        (motion->constants[25] * t4485) + (t242 * t4512);
    const float t4796 = t4791 + (motion->constants[23] * t3242) + (t287 * t3011) - (t3118 * t4648) -
        (t3134 * t4654) - (t3072 * t3205);
    const float t4801 = t4796 - (t4691 * t4700) - (t4706 * t4717) - (t4758 * t4779) -
        (motion->constants[24] * t3064) - (t284 * t2907);
    const float t4808 = t1601 * t3046;
    const float t4810 = t4808 + (t1603 * t4677);
    const float t4813 = t4808 + (t1603 * t4696);
    const float t4817 = (t1601 * t4709) + (t1603 * t4713);
    const float t4824 = (t1603 * t4742) - (t1601 * t1784);
    const float t4830 = (t4739 * t4824) + (motion->constants[28] * t4817) - (t1601 * t4735) -
        (t1603 * t4737) - (t4739 * t4813);
    const float t4840 = (t4770 * t4810) + (t4770 * t4824) + (motion->constants[29] * t4817) -
        (t1601 * t4767) - (t1603 * t4729);
    const float t4853 = (t3807 * t4638) + (t3096 * t3802) + (t4671 * t4810) + (t4691 * t4813) +
        (t4724 * t4830) + (motion->constants[25] * t4534);
    const float t4858 = t4853 + (t242 * t4558) + (motion->constants[23] * t3845) + (t287 * t3750) -
        (t3785 * t4648) - (t3790 * t4654);
    const float t4863 = t4858 - (t3072 * t3822) - (t4706 * t4817) - (t4758 * t4840) -
        (motion->constants[24] * t3775) - (t284 * t3690);
    const float t4864 = t4863 - (t1635 * t4801);
    const float t4871 = t1668 * t3046;
    const float t4873 = (t1670 * t4677) - t4871;
    const float t4876 = t4871 - (t1670 * t4696);
    const float t4880 = (t1668 * t4709) - (t1670 * t4713);
    const float t4887 = (t1668 * t1784) + (t1670 * t4742);
    const float t4894 = t4734 + (t1668 * t4735) + (t4739 * t4876) + (t4739 * t4887) - (t1670 *
        t4737) - (motion->constants[28] * t4880);
    const float t4905 = t4765 + (t1668 * t4767) + (t4770 * t4873) + (t4770 * t4887) - (t1670 *
        t4729) - (motion->constants[29] * t4880);
    const float t4919 = (t4413 * t4638) + (t4392 * t4648) + (t3096 * t4409) + (t4671 * t4873) +
        (t4706 * t4880) + (t4724 * t4894);
    const float t4924 = t4919 + (motion->constants[25] * t4582) + (t242 * t4606) +
        (motion->constants[23] * t4451) + (t287 * t4357) - (t4396 * t4654);
    const float t4929 = t4924 - (t3072 * t4428) - (t4691 * t4876) - (t4758 * t4905) -
        (motion->constants[24] * t4384) - (t284 * t4296);
    const float t4932 = t1742 * (t4929 - (t1701 * t4801) - (t1710 * t4864));
    const float t4934 = (t1653 * t4864) - (t1710 * t4932);
    const float t4938 = (t1180 * t4801) - (t1635 * t4934) - (t1701 * t4932);
    const float t4943 = (t16 * t1959) + (t13 * t1969) + (sin_phi * t2492);
    const float t4951 = (t16 * t3267) + (t13 * t3271) - (sin_phi * t3449) - (t1635 * t4943);
    const float t4962 = t1742 * ((t16 * t3873) + (t13 * t3878) - (sin_phi * t4055) - (t1701 *
        t4943) - (t1710 * t4951));
    const float t4964 = (t1653 * t4951) - (t1710 * t4962);
    const float t4968 = (t1180 * t4943) - (t1635 * t4964) - (t1701 * t4962);
    const float t4973 = t1786 - t1240;
    const float t4974 = t12 * t4973;
    const float t4976 = t7 * t4973;
    const float t4978 = t1186 * t1189;
    const float t4979 = t4978 - t1750;
    const float t4981 = t1240 + t1240;
    const float t4982 = t7 * t4981;
    const float t4984 = t12 * t4981;
    const float t4986 = t1210 - t4978;
    const float t4988 = (cos_delta * t4986) - (sin_delta * t4984);
    const float t4992 = (cos_delta * t4984) + (sin_delta * t4986);
    const float t4996 = (t1186 * t1248) - (speeds[0] * speeds[0]);
    const float t5011 = (motion->constants[19] * t4754) - (motion->constants[20] * t4779);
    const float t5016 = (motion->constants[1] * t1753) + (motion->constants[29] * t1766) + (t1123 *
        t2767) + (t1969 * t4976) + (t2492 * t4979) + (t2126 * t4982);
    const float t5021 = t5016 + (t2152 * t4988) + (t2174 * t4992) + (t2545 * t4996) + (t1000 *
        t2461) + (t447 * t2661);
    const float t5026 = t5021 + (t71 * t2843) + (t1005 * t2740) + (t652 * t2804) +
        (motion->constants[19] * t3242) + (t311 * t3011);
    const float t5032 = t5026 + t5011 - t1523 - t1847 - (motion->constants[28] * t1771) - (t1959 *
        t4974) - (t548 * t2733);
    const float t5035 = t5032 - (t538 * t2794) - (motion->constants[20] * t3064) - (t309 * t2907);
    const float t5059 = (motion->constants[19] * t4830) - (motion->constants[20] * t4840);
    const float t5064 = (t1601 * t2767) + (t3271 * t4976) + (t3342 * t4982) + (t3348 * t4988) +
        (t3354 * t4992) + (t3465 * t4996);
    const float t5069 = t5064 + (t1000 * t3437) + (t447 * t3513) + (t71 * t3628) + (t1005 * t3576) +
        (t652 * t3599);
    const float t5074 = t5069 + (motion->constants[19] * t3845) + (t311 * t3750) + t5059 - (t3267 *
        t4974) - (t3449 * t4979);
    const float t5079 = t5074 - (t548 * t3570) - (t538 * t3591) - (motion->constants[20] * t3775) -
        (t309 * t3690) - (t1635 * t5035);
    const float t5104 = (motion->constants[19] * t4894) - (motion->constants[20] * t4905);
    const float t5109 = t2767 + (t3878 * t4976) + (t3949 * t4982) + (t3955 * t4988) + (t3961 *
        t4992) + (t4071 * t4996);
    const float t5114 = t5109 + (t1000 * t4045) + (t447 * t4120) + (t71 * t4233) + (t1005 * t4181) +
        (t652 * t4204);
    const float t5119 = t5114 + (motion->constants[19] * t4451) + (t311 * t4357) + t5104 - (t1668 *
        t2767) - (t3873 * t4974);
    const float t5124 = t5119 - (t4055 * t4979) - (t548 * t4175) - (t538 * t4196) -
        (motion->constants[20] * t4384) - (t309 * t4296);
    const float t5127 = t1742 * (t5124 - (t1701 * t5035) - (t1710 * t5079));
    const float t5129 = (t1653 * t5079) - (t1710 * t5127);
    const float t5133 = (t1180 * t5035) - (t1635 * t5129) - (t1701 * t5127);
    const float t5134 = motion->constants[7] * t1753;
    const float t5137 = (t1790 * t1900) - (t1813 * t1961);
    const float t5139 = t5134 + (t1123 * t5137);
    const float t5143 = (t1601 * t5137) - (t1635 * t5139);
    const float t5151 = t1742 * (t5137 - (t1668 * t5137) - (t1701 * t5139) - (t1710 * t5143));
    const float t5153 = (t1653 * t5143) - (t1710 * t5151);
    const float t5157 = (t1180 * t5139) - (t1635 * t5153) - (t1701 * t5151);
    const float t5158 = t4681 + t4700;
    const float t5162 = t4810 - t4813 - (t1635 * t5158);
    const float t5169 = t1742 * (t4873 + t4876 - (t1701 * t5158) - (t1710 * t5162));
    const float t5171 = (t1653 * t5162) - (t1710 * t5169);
    const float t5175 = (t1180 * t5158) - (t1635 * t5171) - (t1701 * t5169);
    const float t5176 = t1191 * t1200;
    const float t5178 = t1195 * t1200;
    const float t5183 = (t12 * t5176) + (t7 * t5178);
    const float t5187 = (t12 * t5178) + (t1134 * t5183) - (t7 * t5176) - (t1123 * t1786);
    const float t5193 = (t1603 * t5183) - (t1601 * t1786) - (t1635 * t5187);
    const float t5203 = t1742 * ((t1668 * t1786) + (t1670 * t5183) - t1786 - (t1701 * t5187) -
        (t1710 * t5193));
    const float t5205 = (t1653 * t5193) - (t1710 * t5203);
    const float t5209 = (t1180 * t5187) - (t1635 * t5205) - (t1701 * t5203);
    const float t5212 = (motion->constants[20] * t4754) + (motion->constants[19] * t4779);
    const float t5218 = (motion->constants[20] * t4830) + (motion->constants[19] * t4840) - (t1635 *
        t5212);
    const float t5227 = t1742 * ((motion->constants[20] * t4894) + (motion->constants[19] * t4905) -
        (t1701 * t5212) - (t1710 * t5218));
    const float t5229 = (t1653 * t5218) - (t1710 * t5227);
    const float t5233 = (t1180 * t5212) - (t1635 * t5229) - (t1701 * t5227);
    const float t5236 = t5059 - (t1635 * t5011);
    const float t5242 = t1742 * (t5104 - (t1701 * t5011) - (t1710 * t5236));
    const float t5244 = (t1653 * t5236) - (t1710 * t5242);
    const float t5248 = (t1180 * t5011) - (t1635 * t5244) - (t1701 * t5242);
    const float t5251 = t1753 * t4724;
    const float t5253 = t1753 * t4758;
    const float t5259 = t5137 + (t4733 * t4758) + (t4724 * t4764);
    const float t5262 = (t1790 * t4758) + (t1813 * t4724) - t5259;
    const float t5266 = (t12 * t5251) + (t7 * t5253);
    const float t5268 = t4724 * t4724;
    const float t5270 = t4758 * t4758;
    const float t5272 = t5268 + t5270;
    const float t5274 = t4724 * t4758;
    const float t5280 = t5134 + (t7 * t5251) + (t4681 * t5268) + (t4700 * t5270) + (t4746 * t5272) +
        (t4717 * t5274);
    const float t5285 = t5280 - (t4726 * t4758) - (t4724 * t4759) - (t12 * t5253) - (t1123 *
        t5262) - (t1134 * t5266);
    const float t5298 = (t4810 * t5268) + (t4824 * t5272) + (t4817 * t5274) - (t1601 * t5262) -
        (t1603 * t5266) - (t4813 * t5270);
    const float t5299 = t5298 - (t1635 * t5285);
    const float t5313 = t5259 + (t1668 * t5262) + (t4873 * t5268) + (t4876 * t5270) + (t4887 *
        t5272) - (t1670 * t5266);
    const float t5317 = t1742 * (t5313 - (t4880 * t5274) - (t1701 * t5285) - (t1710 * t5299));
    const float t5319 = (t1653 * t5299) - (t1710 * t5317);
    const float t5323 = (t1180 * t5285) - (t1635 * t5319) - (t1701 * t5317);
    const float t5324 = motion->constants[20] * motion->constants[20];
    const float t5326 = motion->constants[19] * motion->constants[19];
    const float t5328 = motion->constants[19] * motion->constants[20];
    const float t5329 = t4717 * t5328;
    const float t5331 = (t4681 * t5324) + (t4700 * t5326) - t5329;
    const float t5335 = t4817 * t5328;
    const float t5339 = (t4810 * t5324) - (t4813 * t5326) - t5335 - (t1635 * t5331);
    const float t5343 = t4880 * t5328;
    const float t5350 = t1742 * ((t4873 * t5324) + (t4876 * t5326) + t5343 - (t1701 * t5331) -
        (t1710 * t5339));
    const float t5352 = (t1653 * t5339) - (t1710 * t5350);
    const float t5356 = (t1180 * t5331) - (t1635 * t5352) - (t1701 * t5350);
    const float t5359 = t4824 - (t1635 * t4746);
    const float t5365 = t1742 * (t4887 - (t1701 * t4746) - (t1710 * t5359));
    const float t5367 = (t1653 * t5359) - (t1710 * t5365);
    const float t5371 = (t1180 * t4746) - (t1635 * t5367) - (t1701 * t5365);
    const float t5375 = t5329 + (t4681 * t5326) + (t4700 * t5324);
    const float t5382 = t5335 + (t4810 * t5326) - (t4813 * t5324) - (t1635 * t5375);
    const float t5392 = t1742 * ((t4873 * t5326) + (t4876 * t5324) - t5343 - (t1701 * t5375) -
        (t1710 * t5382));
    const float t5394 = (t1653 * t5382) - (t1710 * t5392);
    const float t5398 = (t1180 * t5375) - (t1635 * t5394) - (t1701 * t5392);
    const float t5399 = t5328 + t5328;
    const float t5402 = t5326 - t5324;
    const float t5405 = (t4681 * t5399) - (t4700 * t5399) - (t4717 * t5402);
    const float t5413 = (t4810 * t5399) + (t4813 * t5399) - (t4817 * t5402) - (t1635 * t5405);
    const float t5424 = t1742 * ((t4873 * t5399) + (t4880 * t5402) - (t4876 * t5399) - (t1701 *
        t5405) - (t1710 * t5413));
    const float t5426 = (t1653 * t5413) - (t1710 * t5424);
    const float t5430 = (t1180 * t5405) - (t1635 * t5426) - (t1701 * t5424);
    const float t5433 = t3824 - (t1635 * t3207);
    const float t5439 = t1742 * (t4430 - (t1701 * t3207) - (t1710 * t5433));
    const float t5441 = (t1653 * t5433) - (t1710 * t5439);
    const float t5445 = (t1180 * t3207) - (t1635 * t5441) - (t1701 * t5439);
    const float t5448 = (motion->constants[19] * t3162) - (motion->constants[20] * t3205);
    const float t5454 = (motion->constants[19] * t3802) - (motion->constants[20] * t3822) - (t1635 *
        t5448);
    const float t5463 = t1742 * ((motion->constants[19] * t4409) - (motion->constants[20] * t4428) -
        (t1701 * t5448) - (t1710 * t5454));
    const float t5465 = (t1653 * t5454) - (t1710 * t5463);
    const float t5469 = (t1180 * t5448) - (t1635 * t5465) - (t1701 * t5463);
    const float t5470 = t1815 * t1961;
    const float t5472 = t5470 + (motion->constants[23] * t1815);
    const float t5477 = (t1123 * t5472) + (t1794 * t1935) + (t1809 * t1952);
    const float t5478 = t3096 * t3096;
    const float t5480 = t3072 * t3072;
    const float t5481 = t5478 + t5480;
    const float t5483 = t3072 * t3096;
    const float t5492 = t5477 + (t3176 * t5478) + (t3092 * t5481) + (t3118 * t5483) + (t3134 *
        t5480) + (t3072 * t3158);
    const float t5493 = t5492 + (t3096 * t3201);
    const float t5499 = (t1601 * t5472) + (t1794 * t3257) + (t1809 * t3261);
    const float t5511 = t5499 + (t3807 * t5478) + (t3780 * t5481) + (t3785 * t5483) + (t3790 *
        t5480) + (t3072 * t3798);
    const float t5513 = t5511 + (t3096 * t3818) - (t1635 * t5493);
    const float t5520 = t5470 + (t1794 * t3862) + (t1809 * t3867) - (t1668 * t5472);
    const float t5533 = t5520 + (t4413 * t5478) + (t4388 * t5481) + (t4396 * t5480) + (t3072 *
        t4405) + (t3096 * t4424);
    const float t5537 = t1742 * (t5533 - (t4392 * t5483) - (t1701 * t5493) - (t1710 * t5513));
    const float t5539 = (t1653 * t5513) - (t1710 * t5537);
    const float t5543 = (t1180 * t5493) - (t1635 * t5539) - (t1701 * t5537);
    const float t5545 = t3118 * t5328;
    const float t5548 = (t3176 * t5324) + (t3134 * t5326) - t5545;
    const float t5551 = t3785 * t5328;
    const float t5556 = (t3807 * t5324) + (t3790 * t5326) - t5551 - (t1635 * t5548);
    const float t5559 = t4392 * t5328;
    const float t5567 = t1742 * ((t4413 * t5324) + t5559 + (t4396 * t5326) - (t1701 * t5548) -
        (t1710 * t5556));
    const float t5569 = (t1653 * t5556) - (t1710 * t5567);
    const float t5573 = (t1180 * t5548) - (t1635 * t5569) - (t1701 * t5567);
    const float t5576 = t3780 - (t1635 * t3092);
    const float t5582 = t1742 * (t4388 - (t1701 * t3092) - (t1710 * t5576));
    const float t5584 = (t1653 * t5576) - (t1710 * t5582);
    const float t5588 = (t1180 * t3092) - (t1635 * t5584) - (t1701 * t5582);
    const float t5592 = t5545 + (t3176 * t5326) + (t3134 * t5324);
    const float t5599 = t5551 + (t3807 * t5326) + (t3790 * t5324) - (t1635 * t5592);
    const float t5609 = t1742 * ((t4413 * t5326) + (t4396 * t5324) - t5559 - (t1701 * t5592) -
        (t1710 * t5599));
    const float t5611 = (t1653 * t5599) - (t1710 * t5609);
    const float t5615 = (t1180 * t5592) - (t1635 * t5611) - (t1701 * t5609);
    const float t5620 = (t3176 * t5399) - (t3118 * t5402) - (t3134 * t5399);
    const float t5628 = (t3807 * t5399) - (t3785 * t5402) - (t3790 * t5399) - (t1635 * t5620);
    const float t5639 = t1742 * ((t4413 * t5399) + (t4392 * t5402) - (t4396 * t5399) - (t1701 *
        t5620) - (t1710 * t5628));
    const float t5641 = (t1653 * t5628) - (t1710 * t5639);
    const float t5645 = (t1180 * t5620) - (t1635 * t5641) - (t1701 * t5639);
    const float t5648 = (t1496 * t1881) + (t1031 * t2463);
    const float t5654 = (t1265 * t1327) - (t30 * t1320) - (t1293 * t1323);
    const float t5662 = (t30 * t1282) + (t1256 * t1293) + (t1265 * t1296) - (t27 * t1286);
    const float t5668 = (t27 * t1320) - (t1296 * t1323) - (t1256 * t1327);
    const float t5685 = (t1168 * t5648) + (t2126 * t5654) + (t2152 * t5662) + (t2174 * t5668) +
        (t1039 * t2467) + (t665 * t2667);
    const float t5690 = t5685 + (t320 * t2871) + (motion->constants[20] * t4512) + (t330 * t3011) -
        (t1032 * t2459) - (t1037 * t2461);
    const float t5694 = t5690 - (t1045 * t2729) - (t318 * t2855) - (motion->constants[19] * t4485) -
        (t328 * t2907);
    const float t5717 = (t1031 * t1829) + (t3342 * t5654) + (t3348 * t5662) + (t3354 * t5668) +
        (t1039 * t3443) + (t665 * t3520);
    const float t5722 = t5717 + (t320 * t3655) + (motion->constants[20] * t4558) + (t330 * t3750) -
        (t1625 * t5648) - (t1032 * t3435);
    const float t5727 = t5722 - (t1037 * t3437) - (t1045 * t3566) - (t318 * t3640) -
        (motion->constants[19] * t4534) - (t328 * t3690);
    const float t5728 = t5727 - (t1635 * t5694);
    const float t5751 = (t3949 * t5654) + (t3955 * t5662) + (t3961 * t5668) + (t1039 * t4049) +
        (t665 * t4126) + (t320 * t4260);
    const float t5756 = t5751 + (motion->constants[20] * t4606) + (t330 * t4357) - (t1688 * t5648) -
        (t1032 * t4042) - (t1037 * t4045);
    const float t5761 = t5756 - (t1045 * t4171) - (t318 * t4245) - (motion->constants[19] * t4582) -
        (t328 * t4296) - (t1701 * t5694);
    const float t5763 = t1742 * (t5761 - (t1710 * t5728));
    const float t5765 = (t1653 * t5728) - (t1710 * t5763);
    const float t5769 = (t1180 * t5694) - (t1635 * t5765) - (t1701 * t5763);
    const float t5770 = motion->constants[25] * motion->constants[25];
    const float t5772 = motion->constants[26] * motion->constants[26];
    const float t5773 = t5770 + t5772;
    const float t5775 = motion->constants[25] * motion->constants[26];
    const float t5784 = t5477 + (t3176 * t5770) + (t3092 * t5773) + (t3118 * t5775) + (t3134 *
        t5772) + (motion->constants[26] * t3158);
    const float t5785 = t5784 + (motion->constants[25] * t3201);
    const float t5798 = t5499 + (t3807 * t5770) + (t3780 * t5773) + (t3785 * t5775) + (t3790 *
        t5772) + (motion->constants[26] * t3798);
    const float t5800 = t5798 + (motion->constants[25] * t3818) - (t1635 * t5785);
    const float t5814 = t5520 + (t4413 * t5770) + (t4388 * t5773) + (t4396 * t5772) +
        (motion->constants[26] * t4405) + (motion->constants[25] * t4424);
    const float t5818 = t1742 * (t5814 - (t4392 * t5775) - (t1701 * t5785) - (t1710 * t5800));
    const float t5820 = (t1653 * t5800) - (t1710 * t5818);
    const float t5824 = (t1180 * t5785) - (t1635 * t5820) - (t1701 * t5818);
    const float t5825 = t3134 + t3176;
    const float t5829 = t3790 + t3807 - (t1635 * t5825);
    const float t5836 = t1742 * (t4396 + t4413 - (t1701 * t5825) - (t1710 * t5829));
    const float t5838 = (t1653 * t5829) - (t1710 * t5836);
    const float t5842 = (t1180 * t5825) - (t1635 * t5838) - (t1701 * t5836);
    const float t5843 = t1265 * t1323;
    const float t5845 = t1256 * t1323;
    const float t5846 = cos_delta * t5845;
    const float t5848 = sin_delta * t5845;
    const float t5852 = (t12 * t5843) + (t7 * t5846);
    const float t5858 = (t12 * t5846) + (t1123 * t5848) + (t1134 * t5852) - (t7 * t5843) - (t1168 *
        t1828);
    const float t5867 = (t1601 * t5848) + (t1603 * t5852) + (t1625 * t1828) - t5843 - (t1635 *
        t5858);
    const float t5878 = t1742 * ((t1670 * t5852) + (t1688 * t1828) - (t1668 * t5848) - (t1701 *
        t5858) - (t1710 * t5867));
    const float t5880 = (t1653 * t5867) - (t1710 * t5878);
    const float t5884 = (t1180 * t5858) - (t1635 * t5880) - (t1701 * t5878);
    by_parameters[0][0] = t218;
    by_parameters[0][1] = t234;
    by_parameters[0][2] = t293;
    by_parameters[0][3] = 0.0F;
    by_parameters[0][4] = t317;
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
    by_parameters[0][22] = t336;
    by_parameters[0][23] = 0.0F;
    by_parameters[0][24] = 0.0F;
    by_parameters[0][25] = 0.0F;
    by_parameters[1][0] = t393;
    by_parameters[1][1] = t406;
    by_parameters[1][2] = t417;
    by_parameters[1][3] = 0.0F;
    by_parameters[1][4] = t428;
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
    by_parameters[1][22] = t439;
    by_parameters[1][23] = 0.0F;
    by_parameters[1][24] = 0.0F;
    by_parameters[1][25] = 0.0F;
    by_parameters[2][0] = t621;
    by_parameters[2][1] = t637;
    by_parameters[2][2] = t648;
    by_parameters[2][3] = 0.0F;
    by_parameters[2][4] = t664;
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
    by_parameters[2][22] = t678;
    by_parameters[2][23] = 0.0F;
    by_parameters[2][24] = 0.0F;
    by_parameters[2][25] = 0.0F;
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
    by_parameters[4][0] = t731;
    by_parameters[4][1] = t744;
    by_parameters[4][2] = t755;
    by_parameters[4][3] = 0.0F;
    by_parameters[4][4] = t764;
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
    by_parameters[4][22] = t775;
    by_parameters[4][23] = 0.0F;
    by_parameters[4][24] = 0.0F;
    by_parameters[4][25] = 0.0F;
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
    by_parameters[7][0] = t970;
    by_parameters[7][1] = t988;
    by_parameters[7][2] = t999;
    by_parameters[7][3] = 0.0F;
    by_parameters[7][4] = t1022;
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
    by_parameters[7][22] = t1063;
    by_parameters[7][23] = 0.0F;
    by_parameters[7][24] = 0.0F;
    by_parameters[7][25] = 0.0F;
    by_parameters[8][0] = t4465;
    by_parameters[8][1] = t4624;
    by_parameters[8][2] = t4938;
    by_parameters[8][3] = t4968;
    by_parameters[8][4] = t5133;
    by_parameters[8][5] = t5157;
    by_parameters[8][6] = t5175;
    by_parameters[8][7] = t5209;
    by_parameters[8][8] = t5233;
    by_parameters[8][9] = t5248;
    by_parameters[8][10] = t5323;
    by_parameters[8][11] = t5356;
    by_parameters[8][12] = t5371;
    by_parameters[8][13] = t5398;
    by_parameters[8][14] = t5430;
    by_parameters[8][15] = t5445;
    by_parameters[8][16] = t5469;
    by_parameters[8][17] = t5543;
    by_parameters[8][18] = t5573;
    by_parameters[8][19] = t5588;
    by_parameters[8][20] = t5615;
    by_parameters[8][21] = t5645;
    by_parameters[8][22] = t5769;
    by_parameters[8][23] = t5824;
    by_parameters[8][24] = t5842;
    by_parameters[8][25] = t5884;
    by_parameters[9][0] = t4461;
    by_parameters[9][1] = t4620;
    by_parameters[9][2] = t4934;
    by_parameters[9][3] = t4964;
    by_parameters[9][4] = t5129;
    by_parameters[9][5] = t5153;
    by_parameters[9][6] = t5171;
    by_parameters[9][7] = t5205;
    by_parameters[9][8] = t5229;
    by_parameters[9][9] = t5244;
    by_parameters[9][10] = t5319;
    by_parameters[9][11] = t5352;
    by_parameters[9][12] = t5367;
    by_parameters[9][13] = t5394;
    by_parameters[9][14] = t5426;
    by_parameters[9][15] = t5441;
    by_parameters[9][16] = t5465;
    by_parameters[9][17] = t5539;
    by_parameters[9][18] = t5569;
    by_parameters[9][19] = t5584;
    by_parameters[9][20] = t5611;
    by_parameters[9][21] = t5641;
    by_parameters[9][22] = t5765;
    by_parameters[9][23] = t5820;
    by_parameters[9][24] = t5838;
    by_parameters[9][25] = t5880;
    by_parameters[10][0] = t4459;
    by_parameters[10][1] = t4618;
    by_parameters[10][2] = t4932;
    by_parameters[10][3] = t4962;
    by_parameters[10][4] = t5127;
    by_parameters[10][5] = t5151;
    by_parameters[10][6] = t5169;
    by_parameters[10][7] = t5203;
    by_parameters[10][8] = t5227;
    by_parameters[10][9] = t5242;
    by_parameters[10][10] = t5317;
    by_parameters[10][11] = t5350;
    by_parameters[10][12] = t5365;
    by_parameters[10][13] = t5392;
    by_parameters[10][14] = t5424;
    by_parameters[10][15] = t5439;
    by_parameters[10][16] = t5463;
    by_parameters[10][17] = t5537;
    by_parameters[10][18] = t5567;
    by_parameters[10][19] = t5582;
    by_parameters[10][20] = t5609;
    by_parameters[10][21] = t5639;
    by_parameters[10][22] = t5763;
    by_parameters[10][23] = t5818;
    by_parameters[10][24] = t5836;
    by_parameters[10][25] = t5878;
}

carvallo_motion_error_t whipple_mechanism_f32_motion_by_parameters(const whipple_mechanism_f32_motion_t *motion,
    const float positions[WHIPPLE_MECHANISM_POSITIONS],
    const float speeds[WHIPPLE_MECHANISM_SPEEDS], const float forces[WHIPPLE_MECHANISM_FORCES],
    float by_parameters[WHIPPLE_MECHANISM_STATES][WHIPPLE_MECHANISM_PARAMETERS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHIPPLE_MECHANISM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHIPPLE_MECHANISM_SPEEDS) && carvallo_are_finite_f32(forces,
        WHIPPLE_MECHANISM_FORCES)) {
        bool are_finite = true;
        whipple_mechanism_f32_compute_by_parameters(motion, positions, speeds, forces,
            by_parameters);
        for (size_t row = 0U; row < WHIPPLE_MECHANISM_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f32(by_parameters[row],
                WHIPPLE_MECHANISM_PARAMETERS);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}
