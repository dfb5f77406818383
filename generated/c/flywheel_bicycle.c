/* @generated from generated/models/flywheel_bicycle.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 79e8bfc3e5c2959e
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
 * C0_12 = hH*cos(lam) + mu*(hB + hH) [kg*m^2/s]
 * C0_21 = -(hH*cos(lam) + mu*(hB + hH)) [kg*m^2/s]
 * C1_12 = mu*(ST - Sz_all) + SF*cos(lam) + yaw_per_v_delta*Jxz_all [kg*m]
 * C1_21 = -(mu*ST + SF*cos(lam)) [kg*m]
 * C1_22 = mu*P_delta_lateral + yaw_per_v_delta*P_delta_yaw [kg*m]
 * K0_11 = Sz_all [kg*m]
 * K0_12 = K0_21 = K_phi_delta [kg*m]
 * K0_22 = K_delta_delta [kg*m]
 * K1_12 = yaw_per_v_delta*(hB + hH) [kg*m/s]
 * K1_22 = hH*yaw_per_v_delta*sin(lam) [kg*m/s]
 * K2_12 = yaw_per_v_delta*(ST - Sz_all) [kg]
 * K2_22 = yaw_per_v_delta*(SF*sin(lam) + P_delta_lateral) [kg]
 * @endverbatim
 */

#include "flywheel_bicycle.h"

#include "carvallo_trig.h"

#include <float.h>

const char *flywheel_bicycle_set_name(flywheel_bicycle_set_t set)
{
    static const char *const TEXTS[] = {
        "benchmark",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *flywheel_bicycle_validity_text(flywheel_bicycle_validity_t validity)
{
    static const char *const TEXTS[] = {
        "FlywheelBicycle: the parameters are valid",
        "FlywheelBicycle: w in m must be finite and > 0",
        "FlywheelBicycle: c in m must be finite",
        "FlywheelBicycle: lam in rad must be finite and > -1.5707963267948966 and < 1.5707963267948966",
        "FlywheelBicycle: g in N/kg must be finite and >= 0",
        "FlywheelBicycle: rR in m must be finite and > 0",
        "FlywheelBicycle: mR in kg must be finite and >= 0",
        "FlywheelBicycle: IRxx in kg*m^2 must be finite and >= 0",
        "FlywheelBicycle: IRyy in kg*m^2 must be finite and >= 0",
        "FlywheelBicycle: xB in m must be finite",
        "FlywheelBicycle: zB in m must be finite",
        "FlywheelBicycle: mB in kg must be finite and >= 0",
        "FlywheelBicycle: IBxx in kg*m^2 must be finite and >= 0",
        "FlywheelBicycle: IByy in kg*m^2 must be finite and >= 0",
        "FlywheelBicycle: IBzz in kg*m^2 must be finite and >= 0",
        "FlywheelBicycle: IBxz in kg*m^2 must be finite",
        "FlywheelBicycle: xH in m must be finite",
        "FlywheelBicycle: zH in m must be finite",
        "FlywheelBicycle: mH in kg must be finite and >= 0",
        "FlywheelBicycle: IHxx in kg*m^2 must be finite and >= 0",
        "FlywheelBicycle: IHyy in kg*m^2 must be finite and >= 0",
        "FlywheelBicycle: IHzz in kg*m^2 must be finite and >= 0",
        "FlywheelBicycle: IHxz in kg*m^2 must be finite",
        "FlywheelBicycle: rF in m must be finite and > 0",
        "FlywheelBicycle: mF in kg must be finite and >= 0",
        "FlywheelBicycle: IFxx in kg*m^2 must be finite and >= 0",
        "FlywheelBicycle: IFyy in kg*m^2 must be finite and >= 0",
        "FlywheelBicycle: hB in N*m*s must be finite",
        "FlywheelBicycle: hH in N*m*s must be finite",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t flywheel_bicycle_partials[FLYWHEEL_BICYCLE_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 52U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 52U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 87U, true},
    {CARVALLO_MATRIX_C0, 0U, 1U, 0U, 23U, true},
    {CARVALLO_MATRIX_C0, 1U, 0U, 0U, 23U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 54U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 85U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 96U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 92U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 92U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 99U, false},
    {CARVALLO_MATRIX_K1, 0U, 1U, 0U, 72U, true},
    {CARVALLO_MATRIX_K1, 1U, 1U, 0U, 75U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 79U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 98U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 53U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 53U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 82U, false},
    {CARVALLO_MATRIX_C0, 0U, 1U, 1U, 71U, false},
    {CARVALLO_MATRIX_C0, 1U, 0U, 1U, 71U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 78U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 84U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 81U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 86U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 86U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 88U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 89U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 101U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 101U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 83U, false},
    {CARVALLO_MATRIX_C0, 0U, 1U, 2U, 20U, true},
    {CARVALLO_MATRIX_C0, 1U, 0U, 2U, 20U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 66U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 93U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 106U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 113U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 113U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 115U, true},
    {CARVALLO_MATRIX_K1, 0U, 1U, 2U, 102U, true},
    {CARVALLO_MATRIX_K1, 1U, 1U, 2U, 107U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 103U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 114U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 11U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 4U, 39U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 4U, 25U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 1U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 4U, 26U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 12U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 27U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 0U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 5U, 28U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 95U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 6U, 94U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 7U, 30U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 7U, 30U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 7U, 29U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 8U, 32U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 8U, 32U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 8U, 65U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 8U, 31U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 8U, 91U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 8U, 60U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 8U, 60U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 8U, 61U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 62U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 13U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 63U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 63U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 9U, 90U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 3U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 9U, 59U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 14U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 10U, 56U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 10U, 56U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 10U, 57U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 10U, 117U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 10U, 110U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 10U, 2U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 10U, 55U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 10U, 55U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 10U, 58U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 10U, 116U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 10U, 109U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 11U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 13U, 95U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 13U, 94U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 14U, 18U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 14U, 18U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 14U, 19U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 15U, 47U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 15U, 47U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 119U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 33U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 120U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 118U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 118U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 121U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 122U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 15U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 41U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 41U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 100U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 69U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 105U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 5U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 97U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 97U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 124U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 80U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 104U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 16U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 45U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 45U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 42U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 70U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 68U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 40U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 40U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 43U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 34U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 44U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 18U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 18U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 18U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 18U, 123U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 20U, 125U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 20U, 108U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 21U, 46U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 21U, 46U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 21U, 64U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 21U, 19U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 21U, 73U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 22U, 17U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 22U, 111U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 22U, 111U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 112U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 22U, 48U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 22U, 77U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 22U, 127U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 22U, 7U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 22U, 126U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 22U, 126U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 22U, 128U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 49U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 22U, 50U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 23U, 10U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 21U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 21U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 24U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 51U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 67U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 6U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 22U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 22U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 35U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 36U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 37U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 9U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 129U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 108U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 76U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 76U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 38U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 74U, false},
    {CARVALLO_MATRIX_C0, 0U, 1U, 26U, 18U, false},
    {CARVALLO_MATRIX_C0, 1U, 0U, 26U, 18U, true},
    {CARVALLO_MATRIX_K1, 0U, 1U, 26U, 19U, false},
    {CARVALLO_MATRIX_C0, 0U, 1U, 27U, 46U, false},
    {CARVALLO_MATRIX_C0, 1U, 0U, 27U, 46U, true},
    {CARVALLO_MATRIX_K1, 0U, 1U, 27U, 19U, false},
    {CARVALLO_MATRIX_K1, 1U, 1U, 27U, 73U, false}
};

const flywheel_bicycle_f64_t flywheel_bicycle_f64_sets[FLYWHEEL_BICYCLE_SETS] = {
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
        .hB = 0.0,
        .hH = 5.0
    }
};

flywheel_bicycle_validity_t flywheel_bicycle_f64_validate(const flywheel_bicycle_f64_t *p)
{
    flywheel_bicycle_validity_t validity = FLYWHEEL_BICYCLE_VALID;
    if (!((p->w > 0.0) && (p->w <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_w;
    } else if (!((p->c >= -DBL_MAX) && (p->c <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_c;
    } else if (!((p->lam > (-1.5707963267948966)) && (p->lam < 1.5707963267948966))) {
        validity = FLYWHEEL_BICYCLE_INVALID_lam;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_g;
    } else if (!((p->rR > 0.0) && (p->rR <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_rR;
    } else if (!((p->mR >= 0.0) && (p->mR <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_mR;
    } else if (!((p->IRxx >= 0.0) && (p->IRxx <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0) && (p->IRyy <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IRyy;
    } else if (!((p->xB >= -DBL_MAX) && (p->xB <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_xB;
    } else if (!((p->zB >= -DBL_MAX) && (p->zB <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_zB;
    } else if (!((p->mB >= 0.0) && (p->mB <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_mB;
    } else if (!((p->IBxx >= 0.0) && (p->IBxx <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0) && (p->IByy <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0) && (p->IBzz <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IBzz;
    } else if (!((p->IBxz >= -DBL_MAX) && (p->IBxz <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IBxz;
    } else if (!((p->xH >= -DBL_MAX) && (p->xH <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_xH;
    } else if (!((p->zH >= -DBL_MAX) && (p->zH <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_zH;
    } else if (!((p->mH >= 0.0) && (p->mH <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_mH;
    } else if (!((p->IHxx >= 0.0) && (p->IHxx <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0) && (p->IHyy <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0) && (p->IHzz <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IHzz;
    } else if (!((p->IHxz >= -DBL_MAX) && (p->IHxz <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IHxz;
    } else if (!((p->rF > 0.0) && (p->rF <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_rF;
    } else if (!((p->mF >= 0.0) && (p->mF <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_mF;
    } else if (!((p->IFxx >= 0.0) && (p->IFxx <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0) && (p->IFyy <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IFyy;
    } else if (!((p->hB >= -DBL_MAX) && (p->hB <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_hB;
    } else if (!((p->hH >= -DBL_MAX) && (p->hH <= DBL_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_hH;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void flywheel_bicycle_f64_matrices(const flywheel_bicycle_f64_t *p, flywheel_bicycle_f64_matrices_t *matrices)
{
    const double t2 = p->zB * p->mB;
    const double t10 = p->rF * p->mF;
    const double t13 = p->IHxx + (p->IFxx + (p->rF * t10));
    const double t19 = p->zH * p->mH;
    const double t23 = p->rR * p->mR;
    const double M_11 = (p->zB * t2) + (p->IBxx + (p->IRxx + t13)) + ((p->zH * t19) + (p->rR *
        t23));
    double wx_delta2_delta = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &wx_delta2_delta, &cos_lam);
    const double t33 = 1.0 / p->w;
    const double yaw_per_v_delta = cos_lam * t33;
    const double mu = p->c * yaw_per_v_delta;
    const double wz_delta2_delta = cos_lam + mu;
    const double t39 = (t13 * wx_delta2_delta) + (wz_delta2_delta * p->IHxz);
    const double t42 = p->mB * p->xB;
    const double t44 = (p->zB * t42) - p->IBxz;
    const double t52 = (p->zH * wx_delta2_delta) + ((cos_lam * (p->c + p->w)) - (p->xH *
        wz_delta2_delta));
    const double t53 = p->mH * t52;
    const double M_12 = t39 + ((p->zH * t53) - (mu * t44));
    const double t62 = (wz_delta2_delta * (p->IFxx + p->IHzz)) + (wx_delta2_delta * p->IHxz);
    const double ay_delta2_delta = mu * (p->IBzz + (p->IRxx + (p->xB * t42)));
    const double M_22 = (t52 * t53) + (wz_delta2_delta * t62) + ((mu * ay_delta2_delta) +
        (wx_delta2_delta * t39));
    const double t76 = cos_lam * p->hH;
    const double K1_12 = yaw_per_v_delta * (p->hH + p->hB);
    const double C0_12 = t76 + (p->c * K1_12);
    const double SF = p->IFyy / p->rF;
    const double SR = p->IRyy / p->rR;
    const double K0_11 = t19 + t2 - (t23 + t10);
    const double t91 = SF - (K0_11 - SR);
    const double t98 = t10 + SF - (t33 * (t44 + ((t19 * p->xH) - (p->c * t91)) - p->IHxz));
    const double C1_12 = cos_lam * t98;
    const double t103 = t10 * wx_delta2_delta;
    const double t106 = t53 - (mu * t42);
    const double K0_12 = t106 - t103;
    const double K0_22 = wx_delta2_delta * K0_12;
    const double K1_22 = wx_delta2_delta * (t33 * t76);
    const double K2_12 = yaw_per_v_delta * t91;
    const double K2_22 = ((wx_delta2_delta * SF) - K0_12) * yaw_per_v_delta;
    const double C0_21 = -C0_12;
    const double C1_21 = -((mu * SR) + (wz_delta2_delta * SF));
    const double C1_22 = (wz_delta2_delta * t103) - (((p->c * t106) + ((p->xH * t53) - t62) -
        ay_delta2_delta) * yaw_per_v_delta);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = C0_12;
    matrices->c0[1][0] = C0_21;
    matrices->c0[1][1] = 0.0;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k1[0][0] = 0.0;
    matrices->k1[0][1] = K1_12;
    matrices->k1[1][0] = 0.0;
    matrices->k1[1][1] = K1_22;
    matrices->k2[0][0] = 0.0;
    matrices->k2[0][1] = K2_12;
    matrices->k2[1][0] = 0.0;
    matrices->k2[1][1] = K2_22;
}

carvallo_system_error_t flywheel_bicycle_f64_at_speed(const flywheel_bicycle_f64_matrices_t *matrices,
    double speed, double gravity, flywheel_bicycle_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed) && carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < FLYWHEEL_BICYCLE_N; row++) {
        for (size_t column = 0U; column < FLYWHEEL_BICYCLE_N; column++) {
            const double damping = matrices->c0[row][column] + (matrices->c1[row][column] * speed);
            const double stiffness = (matrices->k0[row][column] * gravity) +
                (matrices->k2[row][column] * speed * speed) + (matrices->k1[row][column] * speed);
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->c0[row][column]) &&
                carvallo_is_finite_f64(matrices->c1[row][column]) &&
                carvallo_is_finite_f64(matrices->k0[row][column]) &&
                carvallo_is_finite_f64(matrices->k1[row][column]) &&
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

carvallo_system_error_t flywheel_bicycle_f64_state_space(const flywheel_bicycle_f64_system_t *system,
    flywheel_bicycle_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[FLYWHEEL_BICYCLE_N * FLYWHEEL_BICYCLE_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * FLYWHEEL_BICYCLE_N * FLYWHEEL_BICYCLE_N];
    for (size_t row = 0U; row < FLYWHEEL_BICYCLE_N; row++) {
        double *const solved = &x[3U * FLYWHEEL_BICYCLE_N * row];
        for (size_t column = 0U; column < FLYWHEEL_BICYCLE_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * FLYWHEEL_BICYCLE_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[FLYWHEEL_BICYCLE_N + column] = -system->c[row][column];
            solved[(2U * FLYWHEEL_BICYCLE_N) + column] = 0.0;
        }
        solved[(2U * FLYWHEEL_BICYCLE_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[FLYWHEEL_BICYCLE_N * FLYWHEEL_BICYCLE_N];
        error = carvallo_solve_f64(FLYWHEEL_BICYCLE_N, m, terms, 3U * FLYWHEEL_BICYCLE_N, x);
    }
    for (size_t row = 0U; row < (2U * FLYWHEEL_BICYCLE_N); row++) {
        for (size_t column = 0U; column < (2U * FLYWHEEL_BICYCLE_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < FLYWHEEL_BICYCLE_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < FLYWHEEL_BICYCLE_N; row++) {
            const size_t target = FLYWHEEL_BICYCLE_N + row;
            for (size_t column = 0U; column < (2U * FLYWHEEL_BICYCLE_N); column++) {
                space->a[target][column] = x[(3U * FLYWHEEL_BICYCLE_N * row) + column];
            }
            for (size_t column = 0U; column < FLYWHEEL_BICYCLE_N; column++) {
                space->b[target][column] = x[(3U * FLYWHEEL_BICYCLE_N * row) + (2U *
                    FLYWHEEL_BICYCLE_N) + column];
            }
            space->a[row][FLYWHEEL_BICYCLE_N + row] = 1.0;
        }
    }
    return error;
}

double flywheel_bicycle_f64_rate_at(const flywheel_bicycle_f64_rate_t *rate, double v,
    const double q[FLYWHEEL_BICYCLE_N], const double q_dot[FLYWHEEL_BICYCLE_N], double psi)
{
    double by_coordinates = 0.0;
    double by_rates = 0.0;
    for (size_t i = 0U; i < FLYWHEEL_BICYCLE_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void flywheel_bicycle_f64_kinematics(const flywheel_bicycle_f64_t *p, flywheel_bicycle_f64_kinematics_t *kinematics)
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

void flywheel_bicycle_f64_derivatives(const flywheel_bicycle_f64_t *p,
    flywheel_bicycle_f64_matrices_t *matrices, flywheel_bicycle_f64_derivatives_t *derivatives)
{
    double wx_delta2_delta = 0.0;
    double wx_delta2_delta_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const double t29 = p->rR * p->mR;
    const double t30 = p->zH * p->mH;
    const double M_11_mF = p->rF * p->rF;
    const double t34 = p->IHxx + p->IFxx + (p->mF * M_11_mF);
    const double t35 = p->zB * p->mB;
    const double M_11_rR = t29 + t29;
    const double M_11_mR = p->rR * p->rR;
    const double M_11_zB = t35 + t35;
    const double M_11 = p->IBxx + (p->rR * t29) + (p->zH * t30) + t34 + p->IRxx + (p->zB * t35);
    const double M_11_mB = p->zB * p->zB;
    const double M_11_zH = t30 + t30;
    const double M_11_mH = p->zH * p->zH;
    const double t51 = p->xH - p->c - p->w;
    const double t52 = 1.0 / p->w;
    const double t54 = p->IBxz - (t35 * p->xB);
    const double t55 = p->IFxx + p->IHzz;
    const double t56 = p->mB * p->xB;
    const double t57 = p->c * t52;
    const double t60 = p->IRxx + p->IBzz + (p->xB * t56);
    const double t61 = p->hH + p->hB;
    const double t62 = 1.0 / p->rF;
    const double t63 = p->mF * p->rF;
    const double K0_11 = t35 - (t29 + t63 - t30);
    const double M_11_rF = t63 + t63;
    const double t69 = t51 + (p->xH * t57);
    const double t70 = t57 * t61;
    const double SF = p->IFyy * t62;
    const double t72 = 1.0 / p->rR;
    const double M_12_mu = p->IHxz + t54;
    const double t75 = (t30 * p->xH) - M_12_mu;
    const double t76 = p->xH + p->c;
    const double t77 = p->hH + t70;
    const double SR = p->IRyy * t72;
    const double t79 = p->c + p->xB;
    const double t81 = p->mF - (t62 * SF);
    const double t82 = p->zH * wx_delta2_delta;
    const double mu = wx_delta2_delta_lam * t57;
    const double t84 = wx_delta2_delta * p->IHxz;
    const double t85 = wx_delta2_delta_lam * SF;
    const double yaw_per_v_delta = wx_delta2_delta_lam * t52;
    const double C0_21_lam = wx_delta2_delta * t77;
    const double C0_12 = wx_delta2_delta_lam * t77;
    const double M_12_mF = M_11_mF * wx_delta2_delta;
    const double t90 = wx_delta2_delta_lam * t69;
    const double t91 = SF + SR;
    const double t92 = t72 * SR;
    const double t93 = p->rF * wx_delta2_delta;
    const double t94 = wx_delta2_delta * SF;
    const double t95 = t30 * wx_delta2_delta_lam;
    const double t96 = p->mH * wx_delta2_delta_lam;
    const double C0_21_w = t70 * yaw_per_v_delta;
    const double M_22_mF = wx_delta2_delta * M_12_mF;
    const double C0_21 = -C0_12;
    const double t100 = t91 - K0_11;
    const double C1_21_rR = mu * t92;
    const double C1_22_mu = p->mR - t92;
    const double K2_12_rR = yaw_per_v_delta * C1_22_mu;
    const double C1_12_mR = p->rR * mu;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double K2_12_IRyy = t72 * yaw_per_v_delta;
    const double C1_12_IRyy = p->c * K2_12_IRyy;
    const double t108 = t35 * yaw_per_v_delta;
    const double t109 = p->c * t108;
    const double t110 = t52 * t95;
    const double t111 = p->zH * yaw_per_v_delta;
    const double t112 = wx_delta2_delta * t93;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double K2_22_mF = yaw_per_v_delta * t93;
    const double t115 = p->mF * t93;
    const double K2_12_IFyy = t62 * yaw_per_v_delta;
    const double C1_12_rR = p->c * K2_12_rR;
    const double C1_21 = -(t85 + (mu * t91));
    const double K0_12_mH = t82 - t90;
    const double t122 = t82 + K0_12_mH;
    const double t123 = t90 - t122;
    const double M_12_zH = p->mH * t122;
    const double M_22_mH = K0_12_mH * K0_12_mH;
    const double K0_22_mH = wx_delta2_delta * K0_12_mH;
    const double t127 = K0_12_mH * yaw_per_v_delta;
    const double M_12_mH = p->zH * K0_12_mH;
    const double wz_delta2_delta = wx_delta2_delta_lam + mu;
    const double t130 = t30 * wz_delta2_delta;
    const double t135 = (p->mH * M_12_mH) + (p->IHxz * wz_delta2_delta) + (t34 * wx_delta2_delta);
    const double C1_12_rF = wz_delta2_delta * t81;
    const double K2_12_rF = yaw_per_v_delta * t81;
    const double K2_22_rF = wx_delta2_delta * K2_12_rF;
    const double C1_12_mF = p->rF * wz_delta2_delta;
    const double t141 = t84 + (wz_delta2_delta * t55);
    const double ay_delta2_delta = t141 + (mu * t60);
    const double t144 = p->mH * K0_12_mH;
    const double t147 = t52 * ((p->c * t100) - t75);
    const double t148 = t75 * yaw_per_v_delta;
    const double M_12 = t135 + (mu * t54);
    const double M_12_w = t95 + (t57 * t148);
    const double M_12_c = t95 - t148;
    const double t154 = t147 * yaw_per_v_delta;
    const double t156 = SF + t63 + t147;
    const double t157 = mu * p->xB;
    const double t158 = p->zB * t157;
    const double M_22_mB = t157 * t157;
    const double t160 = wx_delta2_delta * t157;
    const double t162 = ay_delta2_delta - (p->xH * t144);
    const double t163 = ay_delta2_delta * yaw_per_v_delta;
    const double t164 = p->mB * yaw_per_v_delta;
    const double t165 = p->c * t164;
    const double t166 = wx_delta2_delta * t165;
    const double K2_22_xB = yaw_per_v_delta * t165;
    const double ay_delta2_delta_xB = t157 * t165;
    const double t169 = p->mB * t157;
    const double t170 = wx_delta2_delta * wz_delta2_delta;
    const double M_22_IHxz = t170 + t170;
    const double M_22_xB = ay_delta2_delta_xB + ay_delta2_delta_xB;
    const double C1_12 = wx_delta2_delta_lam * t156;
    const double t174 = wx_delta2_delta * t156;
    const double C1_22_mF = p->rF * t170;
    const double t176 = yaw_per_v_delta * t76;
    const double C1_22 = ay_delta2_delta_xB + t163 + (t63 * t170) - (t144 * t176);
    const double t185 = t141 + (t57 * t162) - (t51 * t144);
    const double t186 = K0_12_mH * t176;
    const double t187 = t163 + t163;
    const double t188 = wx_delta2_delta_lam * t63;
    const double t189 = p->mH * t176;
    const double t190 = p->zH * t176;
    const double K0_12 = t144 - (t169 + t115);
    const double t196 = t169 - K0_12 + (yaw_per_v_delta * (t55 + t60));
    const double K0_22 = wx_delta2_delta * K0_12;
    const double K1_12 = t61 * yaw_per_v_delta;
    const double t199 = t52 * K1_12;
    const double K2_22_SF = wx_delta2_delta * yaw_per_v_delta;
    const double K2_22_IFyy = t62 * K2_22_SF;
    const double K1_22 = p->hH * K2_22_SF;
    const double t203 = t52 * K1_22;
    const double C1_12_IFyy = wz_delta2_delta * t62;
    const double C1_21_rF = SF * C1_12_IFyy;
    const double K2_12 = t100 * yaw_per_v_delta;
    const double t207 = t52 * K2_12;
    const double M_22 = (wx_delta2_delta_lam * t185) + (wx_delta2_delta * t135);
    const double t213 = (wx_delta2_delta_lam * t135) - (wx_delta2_delta * t185);
    const double K2_22_yaw_per_v_delta = t94 - K0_12;
    const double K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
    const double t216 = p->mH * yaw_per_v_delta;
    const double t217 = p->xH * t216;
    const double t219 = t96 + (t57 * t217);
    const double M_22_mu = p->c * t196;
    const double t222 = t52 * (t162 + M_22_mu);
    const double t223 = t96 - t217;
    const double M_22_wz_delta2_delta = t196 - (t76 * t223);
    const double C1_22_c = yaw_per_v_delta * M_22_wz_delta2_delta;
    const double ay_delta2_delta_mB = t123 * t223;
    const double M_22_c = t187 - ay_delta2_delta_mB;
    const double M_22_lam = t213 + t213;
    const double t230 = t91 * yaw_per_v_delta;
    const double C1_21_w = t57 * t230;
    const double t232 = t56 * yaw_per_v_delta;
    const double K0_12_c = t223 - t232;
    const double t236 = (t57 * t187) + (t219 * t123);
    const double K0_22_c = wx_delta2_delta * K0_12_c;
    const double t238 = yaw_per_v_delta * K0_12_c;
    const double t239 = t165 + t232;
    const double C1_22_xB = mu * (t232 + t239);
    const double K0_12_w = t219 + (t57 * t232);
    const double t244 = wx_delta2_delta * t57;
    const double C1_21_lam = t94 + (t91 * t244);
    const double C1_22_IRxx = mu * yaw_per_v_delta;
    const double M_22_IRxx = p->c * C1_22_IRxx;
    const double t251 = yaw_per_v_delta * ((t76 * t219) + t222);
    const double K0_12_zH = p->mH * wx_delta2_delta;
    const double t254 = t95 + (t69 * K0_12_zH);
    const double t257 = (t52 * K2_22) + (yaw_per_v_delta * K0_12_w);
    const double K0_22_w = wx_delta2_delta * K0_12_w;
    const double t259 = t123 * K0_12_zH;
    const double t265 = t84 + (M_12_mu * t244) - (t34 * wx_delta2_delta_lam) - (p->zH * t254);
    const double t267 = t254 + (t56 * t244);
    const double t268 = wx_delta2_delta * t52;
    const double t269 = t61 * t268;
    const double t270 = t100 * t268;
    const double t271 = t96 * t268;
    const double t272 = t76 * t271;
    const double t273 = wx_delta2_delta_lam * yaw_per_v_delta;
    const double C1_22_lam = (wz_delta2_delta * t188) + (p->IHxz * t273) - (wx_delta2_delta *
        (t115 + t222 + (t55 * yaw_per_v_delta))) - (t176 * t254);
    const double t286 = p->hH * ((wx_delta2_delta * t268) - t273);
    const double C1_22_IHzz = t273 + C1_22_IRxx;
    const double K2_22_mB = p->xB * C1_22_IRxx;
    const double C1_22_mB = t79 * K2_22_mB;
    const double M_12_rF = t115 + t115;
    const double M_22_rF = wx_delta2_delta * M_12_rF;
    const double K0_12_lam = t267 - t188;
    const double t293 = t188 - t267;
    const double K2_22_lam = (yaw_per_v_delta * (t85 + t293)) - (K2_22_yaw_per_v_delta * t268);
    const double t300 = (wx_delta2_delta * t293) - (wx_delta2_delta_lam * K0_12);
    const double t301 = p->zB * yaw_per_v_delta;
    const double t302 = t79 * t301;
    const double t303 = p->mH * wz_delta2_delta;
    const double M_22_xH = t123 * t303;
    const double C1_22_xH = yaw_per_v_delta * ((t76 * t303) - t144);
    const double t308 = wx_delta2_delta * t303;
    const double K2_22_xH = yaw_per_v_delta * t303;
    const double M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const double K0_22_zH = p->mH * M_22_IHxx;
    const double M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const double t313 = p->mF * wx_delta2_delta;
    const double C1_22_rF = wz_delta2_delta * t313;
    const double t315 = p->mF * M_22_IHxx;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = C0_12;
    matrices->c0[1][0] = C0_21;
    matrices->c0[1][1] = 0.0;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k1[0][0] = 0.0;
    matrices->k1[0][1] = K1_12;
    matrices->k1[1][0] = 0.0;
    matrices->k1[1][1] = K1_22;
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
    derivatives->values[10] = M_11_mF;
    derivatives->values[11] = M_11_rR;
    derivatives->values[12] = M_11_mR;
    derivatives->values[13] = M_11_zB;
    derivatives->values[14] = M_11_mB;
    derivatives->values[15] = M_11_zH;
    derivatives->values[16] = M_11_mH;
    derivatives->values[17] = M_11_rF;
    derivatives->values[18] = mu;
    derivatives->values[19] = yaw_per_v_delta;
    derivatives->values[20] = C0_21_lam;
    derivatives->values[21] = M_12_mF;
    derivatives->values[22] = t93;
    derivatives->values[23] = C0_21_w;
    derivatives->values[24] = M_22_mF;
    derivatives->values[25] = C1_21_rR;
    derivatives->values[26] = K2_12_rR;
    derivatives->values[27] = C1_12_mR;
    derivatives->values[28] = K2_12_mR;
    derivatives->values[29] = K2_12_IRyy;
    derivatives->values[30] = C1_12_IRyy;
    derivatives->values[31] = t108;
    derivatives->values[32] = t109;
    derivatives->values[33] = t110;
    derivatives->values[34] = t111;
    derivatives->values[35] = t112;
    derivatives->values[36] = K2_12_mF;
    derivatives->values[37] = K2_22_mF;
    derivatives->values[38] = K2_12_IFyy;
    derivatives->values[39] = C1_12_rR;
    derivatives->values[40] = K0_12_mH;
    derivatives->values[41] = M_12_zH;
    derivatives->values[42] = M_22_mH;
    derivatives->values[43] = K0_22_mH;
    derivatives->values[44] = t127;
    derivatives->values[45] = M_12_mH;
    derivatives->values[46] = wz_delta2_delta;
    derivatives->values[47] = t130;
    derivatives->values[48] = C1_12_rF;
    derivatives->values[49] = K2_12_rF;
    derivatives->values[50] = K2_22_rF;
    derivatives->values[51] = C1_12_mF;
    derivatives->values[52] = M_12_w;
    derivatives->values[53] = M_12_c;
    derivatives->values[54] = t154;
    derivatives->values[55] = t157;
    derivatives->values[56] = t158;
    derivatives->values[57] = M_22_mB;
    derivatives->values[58] = t160;
    derivatives->values[59] = t164;
    derivatives->values[60] = t165;
    derivatives->values[61] = t166;
    derivatives->values[62] = K2_22_xB;
    derivatives->values[63] = t169;
    derivatives->values[64] = M_22_IHxz;
    derivatives->values[65] = M_22_xB;
    derivatives->values[66] = t174;
    derivatives->values[67] = C1_22_mF;
    derivatives->values[68] = t186;
    derivatives->values[69] = t189;
    derivatives->values[70] = t190;
    derivatives->values[71] = K1_12;
    derivatives->values[72] = t199;
    derivatives->values[73] = K2_22_SF;
    derivatives->values[74] = K2_22_IFyy;
    derivatives->values[75] = t203;
    derivatives->values[76] = C1_12_IFyy;
    derivatives->values[77] = C1_21_rF;
    derivatives->values[78] = K2_12;
    derivatives->values[79] = t207;
    derivatives->values[80] = t216;
    derivatives->values[81] = C1_22_c;
    derivatives->values[82] = M_22_c;
    derivatives->values[83] = M_22_lam;
    derivatives->values[84] = t230;
    derivatives->values[85] = C1_21_w;
    derivatives->values[86] = K0_12_c;
    derivatives->values[87] = t236;
    derivatives->values[88] = K0_22_c;
    derivatives->values[89] = t238;
    derivatives->values[90] = t239;
    derivatives->values[91] = C1_22_xB;
    derivatives->values[92] = K0_12_w;
    derivatives->values[93] = C1_21_lam;
    derivatives->values[94] = C1_22_IRxx;
    derivatives->values[95] = M_22_IRxx;
    derivatives->values[96] = t251;
    derivatives->values[97] = K0_12_zH;
    derivatives->values[98] = t257;
    derivatives->values[99] = K0_22_w;
    derivatives->values[100] = t259;
    derivatives->values[101] = t265;
    derivatives->values[102] = t269;
    derivatives->values[103] = t270;
    derivatives->values[104] = t271;
    derivatives->values[105] = t272;
    derivatives->values[106] = C1_22_lam;
    derivatives->values[107] = t286;
    derivatives->values[108] = C1_22_IHzz;
    derivatives->values[109] = K2_22_mB;
    derivatives->values[110] = C1_22_mB;
    derivatives->values[111] = M_12_rF;
    derivatives->values[112] = M_22_rF;
    derivatives->values[113] = K0_12_lam;
    derivatives->values[114] = K2_22_lam;
    derivatives->values[115] = t300;
    derivatives->values[116] = t301;
    derivatives->values[117] = t302;
    derivatives->values[118] = t303;
    derivatives->values[119] = M_22_xH;
    derivatives->values[120] = C1_22_xH;
    derivatives->values[121] = t308;
    derivatives->values[122] = K2_22_xH;
    derivatives->values[123] = M_22_IHxx;
    derivatives->values[124] = K0_22_zH;
    derivatives->values[125] = M_22_IHzz;
    derivatives->values[126] = t313;
    derivatives->values[127] = C1_22_rF;
    derivatives->values[128] = t315;
    derivatives->values[129] = M_22_IFxx;
}

void flywheel_bicycle_f64_with_respect_to(const flywheel_bicycle_f64_derivatives_t *derivatives,
    size_t parameter, flywheel_bicycle_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < FLYWHEEL_BICYCLE_N; row++) {
        for (size_t column = 0U; column < FLYWHEEL_BICYCLE_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c0[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
            matrices->k1[row][column] = 0.0;
            matrices->k2[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < FLYWHEEL_BICYCLE_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &flywheel_bicycle_partials[position];
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
            case CARVALLO_MATRIX_K0:
                matrices->k0[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_K1:
                matrices->k1[partial->row][partial->column] = signed_value;
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

const flywheel_bicycle_f32_t flywheel_bicycle_f32_sets[FLYWHEEL_BICYCLE_SETS] = {
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
        .hB = 0.0F,
        .hH = 5.0F
    }
};

flywheel_bicycle_validity_t flywheel_bicycle_f32_validate(const flywheel_bicycle_f32_t *p)
{
    flywheel_bicycle_validity_t validity = FLYWHEEL_BICYCLE_VALID;
    if (!((p->w > 0.0F) && (p->w <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_w;
    } else if (!((p->c >= -FLT_MAX) && (p->c <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_c;
    } else if (!((p->lam > (-1.5707964F)) && (p->lam < 1.5707964F))) {
        validity = FLYWHEEL_BICYCLE_INVALID_lam;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_g;
    } else if (!((p->rR > 0.0F) && (p->rR <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_rR;
    } else if (!((p->mR >= 0.0F) && (p->mR <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_mR;
    } else if (!((p->IRxx >= 0.0F) && (p->IRxx <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IRxx;
    } else if (!((p->IRyy >= 0.0F) && (p->IRyy <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IRyy;
    } else if (!((p->xB >= -FLT_MAX) && (p->xB <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_xB;
    } else if (!((p->zB >= -FLT_MAX) && (p->zB <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_zB;
    } else if (!((p->mB >= 0.0F) && (p->mB <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_mB;
    } else if (!((p->IBxx >= 0.0F) && (p->IBxx <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IBxx;
    } else if (!((p->IByy >= 0.0F) && (p->IByy <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IByy;
    } else if (!((p->IBzz >= 0.0F) && (p->IBzz <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IBzz;
    } else if (!((p->IBxz >= -FLT_MAX) && (p->IBxz <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IBxz;
    } else if (!((p->xH >= -FLT_MAX) && (p->xH <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_xH;
    } else if (!((p->zH >= -FLT_MAX) && (p->zH <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_zH;
    } else if (!((p->mH >= 0.0F) && (p->mH <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_mH;
    } else if (!((p->IHxx >= 0.0F) && (p->IHxx <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IHxx;
    } else if (!((p->IHyy >= 0.0F) && (p->IHyy <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IHyy;
    } else if (!((p->IHzz >= 0.0F) && (p->IHzz <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IHzz;
    } else if (!((p->IHxz >= -FLT_MAX) && (p->IHxz <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IHxz;
    } else if (!((p->rF > 0.0F) && (p->rF <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_rF;
    } else if (!((p->mF >= 0.0F) && (p->mF <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_mF;
    } else if (!((p->IFxx >= 0.0F) && (p->IFxx <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IFxx;
    } else if (!((p->IFyy >= 0.0F) && (p->IFyy <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_IFyy;
    } else if (!((p->hB >= -FLT_MAX) && (p->hB <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_hB;
    } else if (!((p->hH >= -FLT_MAX) && (p->hH <= FLT_MAX))) {
        validity = FLYWHEEL_BICYCLE_INVALID_hH;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void flywheel_bicycle_f32_matrices(const flywheel_bicycle_f32_t *p, flywheel_bicycle_f32_matrices_t *matrices)
{
    const float t2 = p->zB * p->mB;
    const float t10 = p->rF * p->mF;
    const float t13 = p->IHxx + (p->IFxx + (p->rF * t10));
    const float t19 = p->zH * p->mH;
    const float t23 = p->rR * p->mR;
    const float M_11 = (p->zB * t2) + (p->IBxx + (p->IRxx + t13)) + ((p->zH * t19) + (p->rR * t23));
    float wx_delta2_delta = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &wx_delta2_delta, &cos_lam);
    const float t33 = 1.0F / p->w;
    const float yaw_per_v_delta = cos_lam * t33;
    const float mu = p->c * yaw_per_v_delta;
    const float wz_delta2_delta = cos_lam + mu;
    const float t39 = (t13 * wx_delta2_delta) + (wz_delta2_delta * p->IHxz);
    const float t42 = p->mB * p->xB;
    const float t44 = (p->zB * t42) - p->IBxz;
    const float t52 = (p->zH * wx_delta2_delta) + ((cos_lam * (p->c + p->w)) - (p->xH *
        wz_delta2_delta));
    const float t53 = p->mH * t52;
    const float M_12 = t39 + ((p->zH * t53) - (mu * t44));
    const float t62 = (wz_delta2_delta * (p->IFxx + p->IHzz)) + (wx_delta2_delta * p->IHxz);
    const float ay_delta2_delta = mu * (p->IBzz + (p->IRxx + (p->xB * t42)));
    const float M_22 = (t52 * t53) + (wz_delta2_delta * t62) + ((mu * ay_delta2_delta) +
        (wx_delta2_delta * t39));
    const float t76 = cos_lam * p->hH;
    const float K1_12 = yaw_per_v_delta * (p->hH + p->hB);
    const float C0_12 = t76 + (p->c * K1_12);
    const float SF = p->IFyy / p->rF;
    const float SR = p->IRyy / p->rR;
    const float K0_11 = t19 + t2 - (t23 + t10);
    const float t91 = SF - (K0_11 - SR);
    const float t98 = t10 + SF - (t33 * (t44 + ((t19 * p->xH) - (p->c * t91)) - p->IHxz));
    const float C1_12 = cos_lam * t98;
    const float t103 = t10 * wx_delta2_delta;
    const float t106 = t53 - (mu * t42);
    const float K0_12 = t106 - t103;
    const float K0_22 = wx_delta2_delta * K0_12;
    const float K1_22 = wx_delta2_delta * (t33 * t76);
    const float K2_12 = yaw_per_v_delta * t91;
    const float K2_22 = ((wx_delta2_delta * SF) - K0_12) * yaw_per_v_delta;
    const float C0_21 = -C0_12;
    const float C1_21 = -((mu * SR) + (wz_delta2_delta * SF));
    const float C1_22 = (wz_delta2_delta * t103) - (((p->c * t106) + ((p->xH * t53) - t62) -
        ay_delta2_delta) * yaw_per_v_delta);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = C0_12;
    matrices->c0[1][0] = C0_21;
    matrices->c0[1][1] = 0.0F;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k1[0][0] = 0.0F;
    matrices->k1[0][1] = K1_12;
    matrices->k1[1][0] = 0.0F;
    matrices->k1[1][1] = K1_22;
    matrices->k2[0][0] = 0.0F;
    matrices->k2[0][1] = K2_12;
    matrices->k2[1][0] = 0.0F;
    matrices->k2[1][1] = K2_22;
}

carvallo_system_error_t flywheel_bicycle_f32_at_speed(const flywheel_bicycle_f32_matrices_t *matrices,
    float speed, float gravity, flywheel_bicycle_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed) && carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < FLYWHEEL_BICYCLE_N; row++) {
        for (size_t column = 0U; column < FLYWHEEL_BICYCLE_N; column++) {
            const float damping = matrices->c0[row][column] + (matrices->c1[row][column] * speed);
            const float stiffness = (matrices->k0[row][column] * gravity) +
                (matrices->k2[row][column] * speed * speed) + (matrices->k1[row][column] * speed);
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->c0[row][column]) &&
                carvallo_is_finite_f32(matrices->c1[row][column]) &&
                carvallo_is_finite_f32(matrices->k0[row][column]) &&
                carvallo_is_finite_f32(matrices->k1[row][column]) &&
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

carvallo_system_error_t flywheel_bicycle_f32_state_space(const flywheel_bicycle_f32_system_t *system,
    flywheel_bicycle_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[FLYWHEEL_BICYCLE_N * FLYWHEEL_BICYCLE_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * FLYWHEEL_BICYCLE_N * FLYWHEEL_BICYCLE_N];
    for (size_t row = 0U; row < FLYWHEEL_BICYCLE_N; row++) {
        float *const solved = &x[3U * FLYWHEEL_BICYCLE_N * row];
        for (size_t column = 0U; column < FLYWHEEL_BICYCLE_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * FLYWHEEL_BICYCLE_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[FLYWHEEL_BICYCLE_N + column] = -system->c[row][column];
            solved[(2U * FLYWHEEL_BICYCLE_N) + column] = 0.0F;
        }
        solved[(2U * FLYWHEEL_BICYCLE_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[FLYWHEEL_BICYCLE_N * FLYWHEEL_BICYCLE_N];
        error = carvallo_solve_f32(FLYWHEEL_BICYCLE_N, m, terms, 3U * FLYWHEEL_BICYCLE_N, x);
    }
    for (size_t row = 0U; row < (2U * FLYWHEEL_BICYCLE_N); row++) {
        for (size_t column = 0U; column < (2U * FLYWHEEL_BICYCLE_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < FLYWHEEL_BICYCLE_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < FLYWHEEL_BICYCLE_N; row++) {
            const size_t target = FLYWHEEL_BICYCLE_N + row;
            for (size_t column = 0U; column < (2U * FLYWHEEL_BICYCLE_N); column++) {
                space->a[target][column] = x[(3U * FLYWHEEL_BICYCLE_N * row) + column];
            }
            for (size_t column = 0U; column < FLYWHEEL_BICYCLE_N; column++) {
                space->b[target][column] = x[(3U * FLYWHEEL_BICYCLE_N * row) + (2U *
                    FLYWHEEL_BICYCLE_N) + column];
            }
            space->a[row][FLYWHEEL_BICYCLE_N + row] = 1.0F;
        }
    }
    return error;
}

float flywheel_bicycle_f32_rate_at(const flywheel_bicycle_f32_rate_t *rate, float v,
    const float q[FLYWHEEL_BICYCLE_N], const float q_dot[FLYWHEEL_BICYCLE_N], float psi)
{
    float by_coordinates = 0.0F;
    float by_rates = 0.0F;
    for (size_t i = 0U; i < FLYWHEEL_BICYCLE_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void flywheel_bicycle_f32_kinematics(const flywheel_bicycle_f32_t *p, flywheel_bicycle_f32_kinematics_t *kinematics)
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

void flywheel_bicycle_f32_derivatives(const flywheel_bicycle_f32_t *p,
    flywheel_bicycle_f32_matrices_t *matrices, flywheel_bicycle_f32_derivatives_t *derivatives)
{
    float wx_delta2_delta = 0.0F;
    float wx_delta2_delta_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const float t29 = p->rR * p->mR;
    const float t30 = p->zH * p->mH;
    const float M_11_mF = p->rF * p->rF;
    const float t34 = p->IHxx + p->IFxx + (p->mF * M_11_mF);
    const float t35 = p->zB * p->mB;
    const float M_11_rR = t29 + t29;
    const float M_11_mR = p->rR * p->rR;
    const float M_11_zB = t35 + t35;
    const float M_11 = p->IBxx + (p->rR * t29) + (p->zH * t30) + t34 + p->IRxx + (p->zB * t35);
    const float M_11_mB = p->zB * p->zB;
    const float M_11_zH = t30 + t30;
    const float M_11_mH = p->zH * p->zH;
    const float t51 = p->xH - p->c - p->w;
    const float t52 = 1.0F / p->w;
    const float t54 = p->IBxz - (t35 * p->xB);
    const float t55 = p->IFxx + p->IHzz;
    const float t56 = p->mB * p->xB;
    const float t57 = p->c * t52;
    const float t60 = p->IRxx + p->IBzz + (p->xB * t56);
    const float t61 = p->hH + p->hB;
    const float t62 = 1.0F / p->rF;
    const float t63 = p->mF * p->rF;
    const float K0_11 = t35 - (t29 + t63 - t30);
    const float M_11_rF = t63 + t63;
    const float t69 = t51 + (p->xH * t57);
    const float t70 = t57 * t61;
    const float SF = p->IFyy * t62;
    const float t72 = 1.0F / p->rR;
    const float M_12_mu = p->IHxz + t54;
    const float t75 = (t30 * p->xH) - M_12_mu;
    const float t76 = p->xH + p->c;
    const float t77 = p->hH + t70;
    const float SR = p->IRyy * t72;
    const float t79 = p->c + p->xB;
    const float t81 = p->mF - (t62 * SF);
    const float t82 = p->zH * wx_delta2_delta;
    const float mu = wx_delta2_delta_lam * t57;
    const float t84 = wx_delta2_delta * p->IHxz;
    const float t85 = wx_delta2_delta_lam * SF;
    const float yaw_per_v_delta = wx_delta2_delta_lam * t52;
    const float C0_21_lam = wx_delta2_delta * t77;
    const float C0_12 = wx_delta2_delta_lam * t77;
    const float M_12_mF = M_11_mF * wx_delta2_delta;
    const float t90 = wx_delta2_delta_lam * t69;
    const float t91 = SF + SR;
    const float t92 = t72 * SR;
    const float t93 = p->rF * wx_delta2_delta;
    const float t94 = wx_delta2_delta * SF;
    const float t95 = t30 * wx_delta2_delta_lam;
    const float t96 = p->mH * wx_delta2_delta_lam;
    const float C0_21_w = t70 * yaw_per_v_delta;
    const float M_22_mF = wx_delta2_delta * M_12_mF;
    const float C0_21 = -C0_12;
    const float t100 = t91 - K0_11;
    const float C1_21_rR = mu * t92;
    const float C1_22_mu = p->mR - t92;
    const float K2_12_rR = yaw_per_v_delta * C1_22_mu;
    const float C1_12_mR = p->rR * mu;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float K2_12_IRyy = t72 * yaw_per_v_delta;
    const float C1_12_IRyy = p->c * K2_12_IRyy;
    const float t108 = t35 * yaw_per_v_delta;
    const float t109 = p->c * t108;
    const float t110 = t52 * t95;
    const float t111 = p->zH * yaw_per_v_delta;
    const float t112 = wx_delta2_delta * t93;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float K2_22_mF = yaw_per_v_delta * t93;
    const float t115 = p->mF * t93;
    const float K2_12_IFyy = t62 * yaw_per_v_delta;
    const float C1_12_rR = p->c * K2_12_rR;
    const float C1_21 = -(t85 + (mu * t91));
    const float K0_12_mH = t82 - t90;
    const float t122 = t82 + K0_12_mH;
    const float t123 = t90 - t122;
    const float M_12_zH = p->mH * t122;
    const float M_22_mH = K0_12_mH * K0_12_mH;
    const float K0_22_mH = wx_delta2_delta * K0_12_mH;
    const float t127 = K0_12_mH * yaw_per_v_delta;
    const float M_12_mH = p->zH * K0_12_mH;
    const float wz_delta2_delta = wx_delta2_delta_lam + mu;
    const float t130 = t30 * wz_delta2_delta;
    const float t135 = (p->mH * M_12_mH) + (p->IHxz * wz_delta2_delta) + (t34 * wx_delta2_delta);
    const float C1_12_rF = wz_delta2_delta * t81;
    const float K2_12_rF = yaw_per_v_delta * t81;
    const float K2_22_rF = wx_delta2_delta * K2_12_rF;
    const float C1_12_mF = p->rF * wz_delta2_delta;
    const float t141 = t84 + (wz_delta2_delta * t55);
    const float ay_delta2_delta = t141 + (mu * t60);
    const float t144 = p->mH * K0_12_mH;
    const float t147 = t52 * ((p->c * t100) - t75);
    const float t148 = t75 * yaw_per_v_delta;
    const float M_12 = t135 + (mu * t54);
    const float M_12_w = t95 + (t57 * t148);
    const float M_12_c = t95 - t148;
    const float t154 = t147 * yaw_per_v_delta;
    const float t156 = SF + t63 + t147;
    const float t157 = mu * p->xB;
    const float t158 = p->zB * t157;
    const float M_22_mB = t157 * t157;
    const float t160 = wx_delta2_delta * t157;
    const float t162 = ay_delta2_delta - (p->xH * t144);
    const float t163 = ay_delta2_delta * yaw_per_v_delta;
    const float t164 = p->mB * yaw_per_v_delta;
    const float t165 = p->c * t164;
    const float t166 = wx_delta2_delta * t165;
    const float K2_22_xB = yaw_per_v_delta * t165;
    const float ay_delta2_delta_xB = t157 * t165;
    const float t169 = p->mB * t157;
    const float t170 = wx_delta2_delta * wz_delta2_delta;
    const float M_22_IHxz = t170 + t170;
    const float M_22_xB = ay_delta2_delta_xB + ay_delta2_delta_xB;
    const float C1_12 = wx_delta2_delta_lam * t156;
    const float t174 = wx_delta2_delta * t156;
    const float C1_22_mF = p->rF * t170;
    const float t176 = yaw_per_v_delta * t76;
    const float C1_22 = ay_delta2_delta_xB + t163 + (t63 * t170) - (t144 * t176);
    const float t185 = t141 + (t57 * t162) - (t51 * t144);
    const float t186 = K0_12_mH * t176;
    const float t187 = t163 + t163;
    const float t188 = wx_delta2_delta_lam * t63;
    const float t189 = p->mH * t176;
    const float t190 = p->zH * t176;
    const float K0_12 = t144 - (t169 + t115);
    const float t196 = t169 - K0_12 + (yaw_per_v_delta * (t55 + t60));
    const float K0_22 = wx_delta2_delta * K0_12;
    const float K1_12 = t61 * yaw_per_v_delta;
    const float t199 = t52 * K1_12;
    const float K2_22_SF = wx_delta2_delta * yaw_per_v_delta;
    const float K2_22_IFyy = t62 * K2_22_SF;
    const float K1_22 = p->hH * K2_22_SF;
    const float t203 = t52 * K1_22;
    const float C1_12_IFyy = wz_delta2_delta * t62;
    const float C1_21_rF = SF * C1_12_IFyy;
    const float K2_12 = t100 * yaw_per_v_delta;
    const float t207 = t52 * K2_12;
    const float M_22 = (wx_delta2_delta_lam * t185) + (wx_delta2_delta * t135);
    const float t213 = (wx_delta2_delta_lam * t135) - (wx_delta2_delta * t185);
    const float K2_22_yaw_per_v_delta = t94 - K0_12;
    const float K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
    const float t216 = p->mH * yaw_per_v_delta;
    const float t217 = p->xH * t216;
    const float t219 = t96 + (t57 * t217);
    const float M_22_mu = p->c * t196;
    const float t222 = t52 * (t162 + M_22_mu);
    const float t223 = t96 - t217;
    const float M_22_wz_delta2_delta = t196 - (t76 * t223);
    const float C1_22_c = yaw_per_v_delta * M_22_wz_delta2_delta;
    const float ay_delta2_delta_mB = t123 * t223;
    const float M_22_c = t187 - ay_delta2_delta_mB;
    const float M_22_lam = t213 + t213;
    const float t230 = t91 * yaw_per_v_delta;
    const float C1_21_w = t57 * t230;
    const float t232 = t56 * yaw_per_v_delta;
    const float K0_12_c = t223 - t232;
    const float t236 = (t57 * t187) + (t219 * t123);
    const float K0_22_c = wx_delta2_delta * K0_12_c;
    const float t238 = yaw_per_v_delta * K0_12_c;
    const float t239 = t165 + t232;
    const float C1_22_xB = mu * (t232 + t239);
    const float K0_12_w = t219 + (t57 * t232);
    const float t244 = wx_delta2_delta * t57;
    const float C1_21_lam = t94 + (t91 * t244);
    const float C1_22_IRxx = mu * yaw_per_v_delta;
    const float M_22_IRxx = p->c * C1_22_IRxx;
    const float t251 = yaw_per_v_delta * ((t76 * t219) + t222);
    const float K0_12_zH = p->mH * wx_delta2_delta;
    const float t254 = t95 + (t69 * K0_12_zH);
    const float t257 = (t52 * K2_22) + (yaw_per_v_delta * K0_12_w);
    const float K0_22_w = wx_delta2_delta * K0_12_w;
    const float t259 = t123 * K0_12_zH;
    const float t265 = t84 + (M_12_mu * t244) - (t34 * wx_delta2_delta_lam) - (p->zH * t254);
    const float t267 = t254 + (t56 * t244);
    const float t268 = wx_delta2_delta * t52;
    const float t269 = t61 * t268;
    const float t270 = t100 * t268;
    const float t271 = t96 * t268;
    const float t272 = t76 * t271;
    const float t273 = wx_delta2_delta_lam * yaw_per_v_delta;
    const float C1_22_lam = (wz_delta2_delta * t188) + (p->IHxz * t273) - (wx_delta2_delta * (t115 +
        t222 + (t55 * yaw_per_v_delta))) - (t176 * t254);
    const float t286 = p->hH * ((wx_delta2_delta * t268) - t273);
    const float C1_22_IHzz = t273 + C1_22_IRxx;
    const float K2_22_mB = p->xB * C1_22_IRxx;
    const float C1_22_mB = t79 * K2_22_mB;
    const float M_12_rF = t115 + t115;
    const float M_22_rF = wx_delta2_delta * M_12_rF;
    const float K0_12_lam = t267 - t188;
    const float t293 = t188 - t267;
    const float K2_22_lam = (yaw_per_v_delta * (t85 + t293)) - (K2_22_yaw_per_v_delta * t268);
    const float t300 = (wx_delta2_delta * t293) - (wx_delta2_delta_lam * K0_12);
    const float t301 = p->zB * yaw_per_v_delta;
    const float t302 = t79 * t301;
    const float t303 = p->mH * wz_delta2_delta;
    const float M_22_xH = t123 * t303;
    const float C1_22_xH = yaw_per_v_delta * ((t76 * t303) - t144);
    const float t308 = wx_delta2_delta * t303;
    const float K2_22_xH = yaw_per_v_delta * t303;
    const float M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const float K0_22_zH = p->mH * M_22_IHxx;
    const float M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const float t313 = p->mF * wx_delta2_delta;
    const float C1_22_rF = wz_delta2_delta * t313;
    const float t315 = p->mF * M_22_IHxx;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = C0_12;
    matrices->c0[1][0] = C0_21;
    matrices->c0[1][1] = 0.0F;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_22;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_22;
    matrices->k1[0][0] = 0.0F;
    matrices->k1[0][1] = K1_12;
    matrices->k1[1][0] = 0.0F;
    matrices->k1[1][1] = K1_22;
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
    derivatives->values[10] = M_11_mF;
    derivatives->values[11] = M_11_rR;
    derivatives->values[12] = M_11_mR;
    derivatives->values[13] = M_11_zB;
    derivatives->values[14] = M_11_mB;
    derivatives->values[15] = M_11_zH;
    derivatives->values[16] = M_11_mH;
    derivatives->values[17] = M_11_rF;
    derivatives->values[18] = mu;
    derivatives->values[19] = yaw_per_v_delta;
    derivatives->values[20] = C0_21_lam;
    derivatives->values[21] = M_12_mF;
    derivatives->values[22] = t93;
    derivatives->values[23] = C0_21_w;
    derivatives->values[24] = M_22_mF;
    derivatives->values[25] = C1_21_rR;
    derivatives->values[26] = K2_12_rR;
    derivatives->values[27] = C1_12_mR;
    derivatives->values[28] = K2_12_mR;
    derivatives->values[29] = K2_12_IRyy;
    derivatives->values[30] = C1_12_IRyy;
    derivatives->values[31] = t108;
    derivatives->values[32] = t109;
    derivatives->values[33] = t110;
    derivatives->values[34] = t111;
    derivatives->values[35] = t112;
    derivatives->values[36] = K2_12_mF;
    derivatives->values[37] = K2_22_mF;
    derivatives->values[38] = K2_12_IFyy;
    derivatives->values[39] = C1_12_rR;
    derivatives->values[40] = K0_12_mH;
    derivatives->values[41] = M_12_zH;
    derivatives->values[42] = M_22_mH;
    derivatives->values[43] = K0_22_mH;
    derivatives->values[44] = t127;
    derivatives->values[45] = M_12_mH;
    derivatives->values[46] = wz_delta2_delta;
    derivatives->values[47] = t130;
    derivatives->values[48] = C1_12_rF;
    derivatives->values[49] = K2_12_rF;
    derivatives->values[50] = K2_22_rF;
    derivatives->values[51] = C1_12_mF;
    derivatives->values[52] = M_12_w;
    derivatives->values[53] = M_12_c;
    derivatives->values[54] = t154;
    derivatives->values[55] = t157;
    derivatives->values[56] = t158;
    derivatives->values[57] = M_22_mB;
    derivatives->values[58] = t160;
    derivatives->values[59] = t164;
    derivatives->values[60] = t165;
    derivatives->values[61] = t166;
    derivatives->values[62] = K2_22_xB;
    derivatives->values[63] = t169;
    derivatives->values[64] = M_22_IHxz;
    derivatives->values[65] = M_22_xB;
    derivatives->values[66] = t174;
    derivatives->values[67] = C1_22_mF;
    derivatives->values[68] = t186;
    derivatives->values[69] = t189;
    derivatives->values[70] = t190;
    derivatives->values[71] = K1_12;
    derivatives->values[72] = t199;
    derivatives->values[73] = K2_22_SF;
    derivatives->values[74] = K2_22_IFyy;
    derivatives->values[75] = t203;
    derivatives->values[76] = C1_12_IFyy;
    derivatives->values[77] = C1_21_rF;
    derivatives->values[78] = K2_12;
    derivatives->values[79] = t207;
    derivatives->values[80] = t216;
    derivatives->values[81] = C1_22_c;
    derivatives->values[82] = M_22_c;
    derivatives->values[83] = M_22_lam;
    derivatives->values[84] = t230;
    derivatives->values[85] = C1_21_w;
    derivatives->values[86] = K0_12_c;
    derivatives->values[87] = t236;
    derivatives->values[88] = K0_22_c;
    derivatives->values[89] = t238;
    derivatives->values[90] = t239;
    derivatives->values[91] = C1_22_xB;
    derivatives->values[92] = K0_12_w;
    derivatives->values[93] = C1_21_lam;
    derivatives->values[94] = C1_22_IRxx;
    derivatives->values[95] = M_22_IRxx;
    derivatives->values[96] = t251;
    derivatives->values[97] = K0_12_zH;
    derivatives->values[98] = t257;
    derivatives->values[99] = K0_22_w;
    derivatives->values[100] = t259;
    derivatives->values[101] = t265;
    derivatives->values[102] = t269;
    derivatives->values[103] = t270;
    derivatives->values[104] = t271;
    derivatives->values[105] = t272;
    derivatives->values[106] = C1_22_lam;
    derivatives->values[107] = t286;
    derivatives->values[108] = C1_22_IHzz;
    derivatives->values[109] = K2_22_mB;
    derivatives->values[110] = C1_22_mB;
    derivatives->values[111] = M_12_rF;
    derivatives->values[112] = M_22_rF;
    derivatives->values[113] = K0_12_lam;
    derivatives->values[114] = K2_22_lam;
    derivatives->values[115] = t300;
    derivatives->values[116] = t301;
    derivatives->values[117] = t302;
    derivatives->values[118] = t303;
    derivatives->values[119] = M_22_xH;
    derivatives->values[120] = C1_22_xH;
    derivatives->values[121] = t308;
    derivatives->values[122] = K2_22_xH;
    derivatives->values[123] = M_22_IHxx;
    derivatives->values[124] = K0_22_zH;
    derivatives->values[125] = M_22_IHzz;
    derivatives->values[126] = t313;
    derivatives->values[127] = C1_22_rF;
    derivatives->values[128] = t315;
    derivatives->values[129] = M_22_IFxx;
}

void flywheel_bicycle_f32_with_respect_to(const flywheel_bicycle_f32_derivatives_t *derivatives,
    size_t parameter, flywheel_bicycle_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < FLYWHEEL_BICYCLE_N; row++) {
        for (size_t column = 0U; column < FLYWHEEL_BICYCLE_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c0[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
            matrices->k1[row][column] = 0.0F;
            matrices->k2[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < FLYWHEEL_BICYCLE_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &flywheel_bicycle_partials[position];
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
            case CARVALLO_MATRIX_K0:
                matrices->k0[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_K1:
                matrices->k1[partial->row][partial->column] = signed_value;
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
