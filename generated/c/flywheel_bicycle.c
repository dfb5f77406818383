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
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 1U, false},
    {CARVALLO_MATRIX_C0, 0U, 1U, 0U, 2U, true},
    {CARVALLO_MATRIX_C0, 1U, 0U, 0U, 2U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 3U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 4U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 5U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 0U, 6U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 0U, 6U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 7U, false},
    {CARVALLO_MATRIX_K1, 0U, 1U, 0U, 8U, true},
    {CARVALLO_MATRIX_K1, 1U, 1U, 0U, 9U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 10U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 11U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 12U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 12U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 13U, false},
    {CARVALLO_MATRIX_C0, 0U, 1U, 1U, 14U, false},
    {CARVALLO_MATRIX_C0, 1U, 0U, 1U, 14U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 15U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 16U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 17U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 18U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 18U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 19U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 20U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 21U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 21U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 22U, false},
    {CARVALLO_MATRIX_C0, 0U, 1U, 2U, 23U, true},
    {CARVALLO_MATRIX_C0, 1U, 0U, 2U, 23U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 24U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 25U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 26U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 27U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 27U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 28U, false},
    {CARVALLO_MATRIX_K1, 0U, 1U, 2U, 29U, true},
    {CARVALLO_MATRIX_K1, 1U, 1U, 2U, 30U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 31U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 32U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 33U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 4U, 34U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 4U, 35U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 36U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 4U, 37U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 38U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 39U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 40U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 5U, 41U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 42U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 43U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 6U, 44U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 7U, 45U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 7U, 45U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 7U, 46U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 8U, 47U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 8U, 47U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 8U, 48U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 8U, 49U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 8U, 50U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 8U, 51U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 8U, 51U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 8U, 52U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 53U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 54U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 55U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 55U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 9U, 56U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 57U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 9U, 58U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 59U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 10U, 60U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 10U, 60U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 10U, 61U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 10U, 62U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 10U, 63U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 10U, 64U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 10U, 65U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 10U, 65U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 10U, 66U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 10U, 67U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 10U, 68U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 11U, 42U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 13U, 43U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 13U, 44U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 14U, 69U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 14U, 69U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 14U, 70U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 15U, 71U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 15U, 71U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 72U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 73U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 74U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 75U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 75U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 76U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 77U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 78U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 79U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 79U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 80U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 81U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 82U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 83U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 84U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 84U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 85U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 86U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 87U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 88U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 89U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 89U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 90U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 91U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 92U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 93U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 94U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 94U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 95U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 96U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 97U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 18U, 42U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 18U, 98U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 18U, 98U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 18U, 99U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 20U, 100U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 20U, 101U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 21U, 102U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 21U, 102U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 21U, 103U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 21U, 70U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 21U, 104U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 22U, 105U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 22U, 106U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 22U, 106U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 22U, 107U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 22U, 108U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 22U, 109U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 22U, 110U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 22U, 111U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 22U, 112U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 22U, 112U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 22U, 113U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 22U, 114U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 22U, 115U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 23U, 116U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 117U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 117U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 118U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 119U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 120U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 121U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 122U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 122U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 123U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 124U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 125U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 24U, 42U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 24U, 98U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 24U, 98U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 24U, 126U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 24U, 101U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 25U, 127U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 25U, 127U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 25U, 128U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 25U, 129U, false},
    {CARVALLO_MATRIX_C0, 0U, 1U, 26U, 69U, false},
    {CARVALLO_MATRIX_C0, 1U, 0U, 26U, 69U, true},
    {CARVALLO_MATRIX_K1, 0U, 1U, 26U, 70U, false},
    {CARVALLO_MATRIX_C0, 0U, 1U, 27U, 102U, false},
    {CARVALLO_MATRIX_C0, 1U, 0U, 27U, 102U, true},
    {CARVALLO_MATRIX_K1, 0U, 1U, 27U, 70U, false},
    {CARVALLO_MATRIX_K1, 1U, 1U, 27U, 104U, false}
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
    const double t96 = p->hH + p->hB;
    const double C0_12 = (cos_lam * p->hH) + (mu * t96);
    const double SF = p->IFyy / p->rF;
    const double ST = SF + (p->IRyy / p->rR);
    const double Sz_all = t21 + Sz_delta - t17;
    const double t106 = ST - Sz_all;
    const double t109 = cos_lam * SF;
    const double C1_12 = (mu * t106) + (yaw_per_v_delta * Jxz_all) + t109;
    const double Sx_all = t73 - t77;
    const double t115 = mu * Sx_all;
    const double P_delta_lateral = t115 - t69;
    const double C1_22 = (mu * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
    const double K1_12 = yaw_per_v_delta * t96;
    const double K1_22 = sin_lam * yaw_per_v_delta * p->hH;
    const double K2_12 = yaw_per_v_delta * t106;
    const double K2_22 = yaw_per_v_delta * (P_delta_lateral + (sin_lam * SF));
    const double C0_21 = -C0_12;
    const double C1_21 = -(t109 + (mu * ST));
    const double K0_12 = t69 - t115;
    const double K0_22 = -(sin_lam * P_delta_lateral);
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
    matrices->k0[0][0] = Sz_all;
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
    const double t97 = p->hH + p->hB;
    const double C0_12 = (cos_lam * p->hH) + (mu * t97);
    const double t101 = 1.0 / p->rF;
    const double SF = p->IFyy * t101;
    const double t103 = cos_lam * SF;
    const double t105 = 1.0 / p->rR;
    const double t106 = p->IRyy * t105;
    const double ST = SF + t106;
    const double Sz_all = t21 + Sz_delta - t17;
    const double t110 = ST - Sz_all;
    const double t112 = yaw_per_v_delta * Jxz_all;
    const double C1_12 = t103 + (mu * t110) + t112;
    const double Sx_all = t81 - t78;
    const double K0_12 = t72 - (mu * Sx_all);
    const double C1_22 = (yaw_per_v_delta * P_delta_yaw) - (mu * K0_12);
    const double K0_22 = sin_lam * K0_12;
    const double K1_12 = yaw_per_v_delta * t97;
    const double C1_22_Jxz_delta = sin_lam * yaw_per_v_delta;
    const double K1_22 = p->hH * C1_22_Jxz_delta;
    const double K2_12 = yaw_per_v_delta * t110;
    const double t128 = sin_lam * SF;
    const double K2_22_yaw_per_v_delta = t128 - K0_12;
    const double K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
    const double M_12_Jxz_delta = cos_lam + mu;
    const double t132 = t6 * M_12_Jxz_delta;
    const double t134 = t132 - (mu * Sz_delta);
    const double t135 = t43 * yaw_per_v_delta;
    const double M_12_yaw_per_v_delta = p->c * Jxz_all;
    const double M_12_w = t134 - (t135 * M_12_yaw_per_v_delta);
    const double t139 = t34 * mu;
    const double t140 = t139 + t139;
    const double t143 = (cos_lam * t140) + (mu * t140);
    const double M_22_hz_delta = mu + M_12_Jxz_delta;
    const double M_22_IRxx = mu * mu;
    const double M_22_Jzz_delta = (cos_lam * M_22_hz_delta) + M_22_IRxx;
    const double t149 = (t36 * M_22_Jzz_delta) - t143;
    const double M_22_Jxz_delta = (sin_lam * cos_lam) + (sin_lam * M_22_hz_delta);
    const double t157 = (p->mH * t149) + (t6 * M_22_Jxz_delta) + (t61 * M_22_Jzz_delta);
    const double t161 = (mA * t139) - t72 - (mu * t79);
    const double t164 = t157 + (mu * (t161 - t72));
    const double M_22_mu = t87 + t89;
    const double M_22_yaw_per_v_delta = p->c * M_22_mu;
    const double M_22_w = t164 - (t135 * M_22_yaw_per_v_delta);
    const double t169 = p->c * t97;
    const double C0_21_w = t135 * t169;
    const double t171 = t6 * yaw_per_v_delta;
    const double t173 = t171 - (yaw_per_v_delta * Sz_delta);
    const double C1_12_yaw_per_v_delta = Jxz_all + (p->c * t110);
    const double C1_12_w = t173 - (t135 * C1_12_yaw_per_v_delta);
    const double t178 = p->c * ST;
    const double C1_21_w = t135 * t178;
    const double t180 = t34 * yaw_per_v_delta;
    const double t183 = (cos_lam * t180) + (yaw_per_v_delta * t140);
    const double t184 = cos_lam * yaw_per_v_delta;
    const double C1_22_IRxx = yaw_per_v_delta * mu;
    const double C1_22_Jzz_delta = t184 + C1_22_IRxx;
    const double t188 = (t36 * C1_22_Jzz_delta) - t183;
    const double t193 = (p->mH * t188) + (t6 * C1_22_Jxz_delta) + (t61 * C1_22_Jzz_delta);
    const double t195 = t193 + (yaw_per_v_delta * t161);
    const double t196 = p->c * Sx_all;
    const double t199 = p->mH * M_12_Jxz_delta;
    const double t200 = (mu * mA) - t199;
    const double K0_12_w = (t135 * t196) - t200;
    const double C1_22_mu = (yaw_per_v_delta * P_delta_yaw_mu) - K0_12;
    const double C1_22_yaw_per_v_delta = P_delta_yaw + (p->c * C1_22_mu);
    const double C1_22_w = t195 - (mu * K0_12_w) - (t135 * C1_22_yaw_per_v_delta);
    const double K0_22_w = sin_lam * K0_12_w;
    const double t211 = t97 * t135;
    const double K1_22_yaw_per_v_delta = sin_lam * p->hH;
    const double t213 = t135 * K1_22_yaw_per_v_delta;
    const double t214 = t110 * t135;
    const double t217 = (yaw_per_v_delta * K0_12_w) + (K2_22_yaw_per_v_delta * t135);
    const double M_12_c = t112 + t134 - (t10 * M_12_Jxz_delta);
    const double t223 = (p->c * M_22_Jzz_delta) - t143;
    const double M_22_c = t164 + (p->mF * t223) + (yaw_per_v_delta * M_22_mu) + (t59 *
        M_22_Jzz_delta) - (t10 * M_22_Jxz_delta);
    const double C1_12_c = t173 + (yaw_per_v_delta * (t110 - t10));
    const double t234 = yaw_per_v_delta * ST;
    const double t237 = (p->c * C1_22_Jzz_delta) - t183;
    const double t241 = t200 + (yaw_per_v_delta * Sx_all);
    const double t242 = p->mF * M_12_Jxz_delta;
    const double P_delta_lateral_c = t241 - t242;
    const double C1_22_c = t195 + (p->mF * t237) + (yaw_per_v_delta * C1_22_mu) + (mu *
        P_delta_lateral_c) + (t59 * C1_22_Jzz_delta) - (t10 * C1_22_Jxz_delta);
    const double t251 = sin_lam * P_delta_lateral_c;
    const double K2_22_c = yaw_per_v_delta * P_delta_lateral_c;
    const double hx_delta_lam = (Jxx_delta * cos_lam) - t57;
    const double t255 = sin_lam * t43;
    const double M_12_lam = hx_delta_lam - (M_12_yaw_per_v_delta * t255);
    const double hz_delta_lam = t41 - (sin_lam * Jzz_delta);
    const double t266 = (cos_lam * Sz_delta) - (sin_lam * t70);
    const double M_22_lam = (sin_lam * hx_delta_lam) + (cos_lam * hx_delta) + (M_22_hz_delta *
        hz_delta_lam) - (sin_lam * hz_delta) - (t140 * t266) - (M_22_yaw_per_v_delta * t255);
    const double C0_21_lam = K1_22_yaw_per_v_delta + (t169 * t255);
    const double t277 = t128 + (C1_12_yaw_per_v_delta * t255);
    const double C1_21_lam = t128 + (t178 * t255);
    const double K0_12_lam = t266 + (t196 * t255);
    const double C1_22_lam = (yaw_per_v_delta * hz_delta_lam) - (mu * K0_12_lam) - (t180 * t266) -
        (C1_22_yaw_per_v_delta * t255);
    const double K0_22_lam = (sin_lam * K0_12_lam) + (cos_lam * K0_12);
    const double t292 = t97 * t255;
    const double K1_22_lam = (p->hH * t184) - (K1_22_yaw_per_v_delta * t255);
    const double t296 = t110 * t255;
    const double K2_22_lam = (yaw_per_v_delta * (t103 - K0_12_lam)) - (K2_22_yaw_per_v_delta *
        t255);
    const double M_11_rR = t17 + t17;
    const double t302 = t105 * t106;
    const double t303 = p->mR - t302;
    const double C1_12_rR = mu * t303;
    const double C1_21_rR = mu * t302;
    const double K2_12_rR = yaw_per_v_delta * t303;
    const double M_11_mR = p->rR * p->rR;
    const double C1_12_mR = p->rR * mu;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double C1_12_IRyy = mu * t105;
    const double K2_12_IRyy = yaw_per_v_delta * t105;
    const double t313 = t21 * mu;
    const double t314 = mu * p->xB;
    const double t315 = p->mB * t314;
    const double P_delta_yaw_xB = t315 + (mu * t81);
    const double M_22_xB = mu * P_delta_yaw_xB;
    const double t319 = t21 * yaw_per_v_delta;
    const double t321 = p->mB * mu;
    const double C1_22_xB = (yaw_per_v_delta * P_delta_yaw_xB) + (mu * t321);
    const double t324 = sin_lam * t321;
    const double K2_22_xB = yaw_per_v_delta * t321;
    const double M_11_zB = t21 + t21;
    const double t328 = mu + (yaw_per_v_delta * p->xB);
    const double t329 = p->mB * t328;
    const double t330 = p->mB * yaw_per_v_delta;
    const double M_11_mB = p->zB * p->zB;
    const double t332 = p->zB * t314;
    const double P_delta_yaw_mB = p->xB * t314;
    const double M_22_mB = mu * P_delta_yaw_mB;
    const double t335 = p->zB * t328;
    const double C1_22_mB = (yaw_per_v_delta * P_delta_yaw_mB) + (mu * t314);
    const double t339 = sin_lam * t314;
    const double t340 = p->zB * yaw_per_v_delta;
    const double K2_22_mB = yaw_per_v_delta * t314;
    const double C1_22_xH = (mu * t199) - t193;
    const double t344 = sin_lam * t199;
    const double K2_22_xH = yaw_per_v_delta * t199;
    const double M_11_zH = t6 + t6;
    const double K0_12_mH = (p->zH * sin_lam) + (t36 * M_12_Jxz_delta) - t139;
    const double M_12_zH = (p->mH * K0_12_mH) + (t6 * sin_lam);
    const double M_22_Jxx_delta = sin_lam * sin_lam;
    const double t359 = (p->zH * M_22_Jxx_delta) + (t36 * M_22_Jxz_delta) - (sin_lam * t140);
    const double M_22_zH = (p->mH * t359) + (t6 * M_22_Jxx_delta);
    const double t363 = mu + t180;
    const double t365 = (t36 * yaw_per_v_delta) - t363;
    const double C1_12_zH = p->mH * t365;
    const double t367 = sin_lam * t180;
    const double t369 = (t36 * C1_22_Jxz_delta) - t367;
    const double K0_12_zH = p->mH * sin_lam;
    const double C1_22_zH = (p->mH * t369) - (mu * K0_12_zH);
    const double K0_22_zH = sin_lam * K0_12_zH;
    const double t375 = p->mH * yaw_per_v_delta;
    const double t376 = yaw_per_v_delta * K0_12_zH;
    const double M_11_mH = p->zH * p->zH;
    const double M_12_mH = p->zH * K0_12_mH;
    const double P_delta_yaw_mA = t34 * t139;
    const double M_22_mA = mu * P_delta_yaw_mA;
    const double M_22_mH = M_22_mA + (p->zH * t359) + (t36 * t149);
    const double C1_12_mH = p->zH * t365;
    const double C1_22_mA = yaw_per_v_delta * P_delta_yaw_mA;
    const double C1_22_mH = C1_22_mA + (p->zH * t369) + (t36 * t188) - (mu * K0_12_mH);
    const double K0_22_mH = sin_lam * K0_12_mH;
    const double t394 = p->zH * yaw_per_v_delta;
    const double t395 = yaw_per_v_delta * K0_12_mH;
    const double Jxx_delta_rF = t10 + t10;
    const double M_12_rF = sin_lam * Jxx_delta_rF;
    const double M_22_rF = M_22_Jxx_delta * Jxx_delta_rF;
    const double t399 = t363 - mu;
    const double t401 = t101 * SF;
    const double C1_21_rF = M_12_Jxz_delta * t401;
    const double C1_12_rF = (p->mF * t399) - C1_21_rF;
    const double t405 = t367 - (p->c * C1_22_Jxz_delta);
    const double P_delta_lateral_rF = p->mF * sin_lam;
    const double C1_22_rF = (p->mF * t405) + (mu * P_delta_lateral_rF);
    const double t410 = sin_lam * P_delta_lateral_rF;
    const double K2_12_rF = (p->mF * yaw_per_v_delta) - (yaw_per_v_delta * t401);
    const double K2_22_rF = (yaw_per_v_delta * P_delta_lateral_rF) - (C1_22_Jxz_delta * t401);
    const double Jxx_delta_mF = p->rF * p->rF;
    const double M_12_mF = sin_lam * Jxx_delta_mF;
    const double M_22_mF = M_22_mA + (p->c * t223) + (M_22_Jxx_delta * Jxx_delta_mF);
    const double C1_12_mF = p->rF * t399;
    const double K0_12_mF = (p->c * M_12_Jxz_delta) - t139 - (p->rF * sin_lam);
    const double C1_22_mF = C1_22_mA + (p->c * t237) + (p->rF * t405) - (mu * K0_12_mF);
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double M_22_IFxx = M_22_Jzz_delta + M_22_Jxx_delta;
    const double C1_12_IFyy = t101 * M_12_Jxz_delta;
    const double K2_12_IFyy = yaw_per_v_delta * t101;
    const double K2_22_IFyy = t101 * C1_22_Jxz_delta;
    const double C0_21 = -C0_12;
    const double C1_21 = -(t103 + (mu * ST));
    const double K0_12_c = t242 - t241;
    const double t444 = -(sin_lam * K0_12_mF);
    const double K2_22_mF = -(yaw_per_v_delta * K0_12_mF);
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
    matrices->k0[0][0] = Sz_all;
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
    derivatives->values[0] = M_12_w;
    derivatives->values[1] = M_22_w;
    derivatives->values[2] = C0_21_w;
    derivatives->values[3] = C1_12_w;
    derivatives->values[4] = C1_21_w;
    derivatives->values[5] = C1_22_w;
    derivatives->values[6] = K0_12_w;
    derivatives->values[7] = K0_22_w;
    derivatives->values[8] = t211;
    derivatives->values[9] = t213;
    derivatives->values[10] = t214;
    derivatives->values[11] = t217;
    derivatives->values[12] = M_12_c;
    derivatives->values[13] = M_22_c;
    derivatives->values[14] = K1_12;
    derivatives->values[15] = C1_12_c;
    derivatives->values[16] = t234;
    derivatives->values[17] = C1_22_c;
    derivatives->values[18] = K0_12_c;
    derivatives->values[19] = t251;
    derivatives->values[20] = K2_22_c;
    derivatives->values[21] = M_12_lam;
    derivatives->values[22] = M_22_lam;
    derivatives->values[23] = C0_21_lam;
    derivatives->values[24] = t277;
    derivatives->values[25] = C1_21_lam;
    derivatives->values[26] = C1_22_lam;
    derivatives->values[27] = K0_12_lam;
    derivatives->values[28] = K0_22_lam;
    derivatives->values[29] = t292;
    derivatives->values[30] = K1_22_lam;
    derivatives->values[31] = t296;
    derivatives->values[32] = K2_22_lam;
    derivatives->values[33] = M_11_rR;
    derivatives->values[34] = C1_12_rR;
    derivatives->values[35] = C1_21_rR;
    derivatives->values[36] = p->mR;
    derivatives->values[37] = K2_12_rR;
    derivatives->values[38] = M_11_mR;
    derivatives->values[39] = C1_12_mR;
    derivatives->values[40] = p->rR;
    derivatives->values[41] = K2_12_mR;
    derivatives->values[42] = 1.0;
    derivatives->values[43] = M_22_IRxx;
    derivatives->values[44] = C1_22_IRxx;
    derivatives->values[45] = C1_12_IRyy;
    derivatives->values[46] = K2_12_IRyy;
    derivatives->values[47] = t313;
    derivatives->values[48] = M_22_xB;
    derivatives->values[49] = t319;
    derivatives->values[50] = C1_22_xB;
    derivatives->values[51] = t321;
    derivatives->values[52] = t324;
    derivatives->values[53] = K2_22_xB;
    derivatives->values[54] = M_11_zB;
    derivatives->values[55] = t315;
    derivatives->values[56] = t329;
    derivatives->values[57] = p->mB;
    derivatives->values[58] = t330;
    derivatives->values[59] = M_11_mB;
    derivatives->values[60] = t332;
    derivatives->values[61] = M_22_mB;
    derivatives->values[62] = t335;
    derivatives->values[63] = C1_22_mB;
    derivatives->values[64] = p->zB;
    derivatives->values[65] = t314;
    derivatives->values[66] = t339;
    derivatives->values[67] = t340;
    derivatives->values[68] = K2_22_mB;
    derivatives->values[69] = mu;
    derivatives->values[70] = yaw_per_v_delta;
    derivatives->values[71] = t132;
    derivatives->values[72] = t157;
    derivatives->values[73] = t171;
    derivatives->values[74] = C1_22_xH;
    derivatives->values[75] = t199;
    derivatives->values[76] = t344;
    derivatives->values[77] = K2_22_xH;
    derivatives->values[78] = M_11_zH;
    derivatives->values[79] = M_12_zH;
    derivatives->values[80] = M_22_zH;
    derivatives->values[81] = C1_12_zH;
    derivatives->values[82] = C1_22_zH;
    derivatives->values[83] = p->mH;
    derivatives->values[84] = K0_12_zH;
    derivatives->values[85] = K0_22_zH;
    derivatives->values[86] = t375;
    derivatives->values[87] = t376;
    derivatives->values[88] = M_11_mH;
    derivatives->values[89] = M_12_mH;
    derivatives->values[90] = M_22_mH;
    derivatives->values[91] = C1_12_mH;
    derivatives->values[92] = C1_22_mH;
    derivatives->values[93] = p->zH;
    derivatives->values[94] = K0_12_mH;
    derivatives->values[95] = K0_22_mH;
    derivatives->values[96] = t394;
    derivatives->values[97] = t395;
    derivatives->values[98] = sin_lam;
    derivatives->values[99] = M_22_Jxx_delta;
    derivatives->values[100] = M_22_Jzz_delta;
    derivatives->values[101] = C1_22_Jzz_delta;
    derivatives->values[102] = M_12_Jxz_delta;
    derivatives->values[103] = M_22_Jxz_delta;
    derivatives->values[104] = C1_22_Jxz_delta;
    derivatives->values[105] = Jxx_delta_rF;
    derivatives->values[106] = M_12_rF;
    derivatives->values[107] = M_22_rF;
    derivatives->values[108] = C1_12_rF;
    derivatives->values[109] = C1_21_rF;
    derivatives->values[110] = C1_22_rF;
    derivatives->values[111] = p->mF;
    derivatives->values[112] = P_delta_lateral_rF;
    derivatives->values[113] = t410;
    derivatives->values[114] = K2_12_rF;
    derivatives->values[115] = K2_22_rF;
    derivatives->values[116] = Jxx_delta_mF;
    derivatives->values[117] = M_12_mF;
    derivatives->values[118] = M_22_mF;
    derivatives->values[119] = C1_12_mF;
    derivatives->values[120] = C1_22_mF;
    derivatives->values[121] = p->rF;
    derivatives->values[122] = K0_12_mF;
    derivatives->values[123] = t444;
    derivatives->values[124] = K2_12_mF;
    derivatives->values[125] = K2_22_mF;
    derivatives->values[126] = M_22_IFxx;
    derivatives->values[127] = C1_12_IFyy;
    derivatives->values[128] = K2_12_IFyy;
    derivatives->values[129] = K2_22_IFyy;
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
    const float t96 = p->hH + p->hB;
    const float C0_12 = (cos_lam * p->hH) + (mu * t96);
    const float SF = p->IFyy / p->rF;
    const float ST = SF + (p->IRyy / p->rR);
    const float Sz_all = t21 + Sz_delta - t17;
    const float t106 = ST - Sz_all;
    const float t109 = cos_lam * SF;
    const float C1_12 = (mu * t106) + (yaw_per_v_delta * Jxz_all) + t109;
    const float Sx_all = t73 - t77;
    const float t115 = mu * Sx_all;
    const float P_delta_lateral = t115 - t69;
    const float C1_22 = (mu * P_delta_lateral) + (yaw_per_v_delta * P_delta_yaw);
    const float K1_12 = yaw_per_v_delta * t96;
    const float K1_22 = sin_lam * yaw_per_v_delta * p->hH;
    const float K2_12 = yaw_per_v_delta * t106;
    const float K2_22 = yaw_per_v_delta * (P_delta_lateral + (sin_lam * SF));
    const float C0_21 = -C0_12;
    const float C1_21 = -(t109 + (mu * ST));
    const float K0_12 = t69 - t115;
    const float K0_22 = -(sin_lam * P_delta_lateral);
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
    matrices->k0[0][0] = Sz_all;
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
    const float t97 = p->hH + p->hB;
    const float C0_12 = (cos_lam * p->hH) + (mu * t97);
    const float t101 = 1.0F / p->rF;
    const float SF = p->IFyy * t101;
    const float t103 = cos_lam * SF;
    const float t105 = 1.0F / p->rR;
    const float t106 = p->IRyy * t105;
    const float ST = SF + t106;
    const float Sz_all = t21 + Sz_delta - t17;
    const float t110 = ST - Sz_all;
    const float t112 = yaw_per_v_delta * Jxz_all;
    const float C1_12 = t103 + (mu * t110) + t112;
    const float Sx_all = t81 - t78;
    const float K0_12 = t72 - (mu * Sx_all);
    const float C1_22 = (yaw_per_v_delta * P_delta_yaw) - (mu * K0_12);
    const float K0_22 = sin_lam * K0_12;
    const float K1_12 = yaw_per_v_delta * t97;
    const float C1_22_Jxz_delta = sin_lam * yaw_per_v_delta;
    const float K1_22 = p->hH * C1_22_Jxz_delta;
    const float K2_12 = yaw_per_v_delta * t110;
    const float t128 = sin_lam * SF;
    const float K2_22_yaw_per_v_delta = t128 - K0_12;
    const float K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
    const float M_12_Jxz_delta = cos_lam + mu;
    const float t132 = t6 * M_12_Jxz_delta;
    const float t134 = t132 - (mu * Sz_delta);
    const float t135 = t43 * yaw_per_v_delta;
    const float M_12_yaw_per_v_delta = p->c * Jxz_all;
    const float M_12_w = t134 - (t135 * M_12_yaw_per_v_delta);
    const float t139 = t34 * mu;
    const float t140 = t139 + t139;
    const float t143 = (cos_lam * t140) + (mu * t140);
    const float M_22_hz_delta = mu + M_12_Jxz_delta;
    const float M_22_IRxx = mu * mu;
    const float M_22_Jzz_delta = (cos_lam * M_22_hz_delta) + M_22_IRxx;
    const float t149 = (t36 * M_22_Jzz_delta) - t143;
    const float M_22_Jxz_delta = (sin_lam * cos_lam) + (sin_lam * M_22_hz_delta);
    const float t157 = (p->mH * t149) + (t6 * M_22_Jxz_delta) + (t61 * M_22_Jzz_delta);
    const float t161 = (mA * t139) - t72 - (mu * t79);
    const float t164 = t157 + (mu * (t161 - t72));
    const float M_22_mu = t87 + t89;
    const float M_22_yaw_per_v_delta = p->c * M_22_mu;
    const float M_22_w = t164 - (t135 * M_22_yaw_per_v_delta);
    const float t169 = p->c * t97;
    const float C0_21_w = t135 * t169;
    const float t171 = t6 * yaw_per_v_delta;
    const float t173 = t171 - (yaw_per_v_delta * Sz_delta);
    const float C1_12_yaw_per_v_delta = Jxz_all + (p->c * t110);
    const float C1_12_w = t173 - (t135 * C1_12_yaw_per_v_delta);
    const float t178 = p->c * ST;
    const float C1_21_w = t135 * t178;
    const float t180 = t34 * yaw_per_v_delta;
    const float t183 = (cos_lam * t180) + (yaw_per_v_delta * t140);
    const float t184 = cos_lam * yaw_per_v_delta;
    const float C1_22_IRxx = yaw_per_v_delta * mu;
    const float C1_22_Jzz_delta = t184 + C1_22_IRxx;
    const float t188 = (t36 * C1_22_Jzz_delta) - t183;
    const float t193 = (p->mH * t188) + (t6 * C1_22_Jxz_delta) + (t61 * C1_22_Jzz_delta);
    const float t195 = t193 + (yaw_per_v_delta * t161);
    const float t196 = p->c * Sx_all;
    const float t199 = p->mH * M_12_Jxz_delta;
    const float t200 = (mu * mA) - t199;
    const float K0_12_w = (t135 * t196) - t200;
    const float C1_22_mu = (yaw_per_v_delta * P_delta_yaw_mu) - K0_12;
    const float C1_22_yaw_per_v_delta = P_delta_yaw + (p->c * C1_22_mu);
    const float C1_22_w = t195 - (mu * K0_12_w) - (t135 * C1_22_yaw_per_v_delta);
    const float K0_22_w = sin_lam * K0_12_w;
    const float t211 = t97 * t135;
    const float K1_22_yaw_per_v_delta = sin_lam * p->hH;
    const float t213 = t135 * K1_22_yaw_per_v_delta;
    const float t214 = t110 * t135;
    const float t217 = (yaw_per_v_delta * K0_12_w) + (K2_22_yaw_per_v_delta * t135);
    const float M_12_c = t112 + t134 - (t10 * M_12_Jxz_delta);
    const float t223 = (p->c * M_22_Jzz_delta) - t143;
    const float M_22_c = t164 + (p->mF * t223) + (yaw_per_v_delta * M_22_mu) + (t59 *
        M_22_Jzz_delta) - (t10 * M_22_Jxz_delta);
    const float C1_12_c = t173 + (yaw_per_v_delta * (t110 - t10));
    const float t234 = yaw_per_v_delta * ST;
    const float t237 = (p->c * C1_22_Jzz_delta) - t183;
    const float t241 = t200 + (yaw_per_v_delta * Sx_all);
    const float t242 = p->mF * M_12_Jxz_delta;
    const float P_delta_lateral_c = t241 - t242;
    const float C1_22_c = t195 + (p->mF * t237) + (yaw_per_v_delta * C1_22_mu) + (mu *
        P_delta_lateral_c) + (t59 * C1_22_Jzz_delta) - (t10 * C1_22_Jxz_delta);
    const float t251 = sin_lam * P_delta_lateral_c;
    const float K2_22_c = yaw_per_v_delta * P_delta_lateral_c;
    const float hx_delta_lam = (Jxx_delta * cos_lam) - t57;
    const float t255 = sin_lam * t43;
    const float M_12_lam = hx_delta_lam - (M_12_yaw_per_v_delta * t255);
    const float hz_delta_lam = t41 - (sin_lam * Jzz_delta);
    const float t266 = (cos_lam * Sz_delta) - (sin_lam * t70);
    const float M_22_lam = (sin_lam * hx_delta_lam) + (cos_lam * hx_delta) + (M_22_hz_delta *
        hz_delta_lam) - (sin_lam * hz_delta) - (t140 * t266) - (M_22_yaw_per_v_delta * t255);
    const float C0_21_lam = K1_22_yaw_per_v_delta + (t169 * t255);
    const float t277 = t128 + (C1_12_yaw_per_v_delta * t255);
    const float C1_21_lam = t128 + (t178 * t255);
    const float K0_12_lam = t266 + (t196 * t255);
    const float C1_22_lam = (yaw_per_v_delta * hz_delta_lam) - (mu * K0_12_lam) - (t180 * t266) -
        (C1_22_yaw_per_v_delta * t255);
    const float K0_22_lam = (sin_lam * K0_12_lam) + (cos_lam * K0_12);
    const float t292 = t97 * t255;
    const float K1_22_lam = (p->hH * t184) - (K1_22_yaw_per_v_delta * t255);
    const float t296 = t110 * t255;
    const float K2_22_lam = (yaw_per_v_delta * (t103 - K0_12_lam)) - (K2_22_yaw_per_v_delta * t255);
    const float M_11_rR = t17 + t17;
    const float t302 = t105 * t106;
    const float t303 = p->mR - t302;
    const float C1_12_rR = mu * t303;
    const float C1_21_rR = mu * t302;
    const float K2_12_rR = yaw_per_v_delta * t303;
    const float M_11_mR = p->rR * p->rR;
    const float C1_12_mR = p->rR * mu;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float C1_12_IRyy = mu * t105;
    const float K2_12_IRyy = yaw_per_v_delta * t105;
    const float t313 = t21 * mu;
    const float t314 = mu * p->xB;
    const float t315 = p->mB * t314;
    const float P_delta_yaw_xB = t315 + (mu * t81);
    const float M_22_xB = mu * P_delta_yaw_xB;
    const float t319 = t21 * yaw_per_v_delta;
    const float t321 = p->mB * mu;
    const float C1_22_xB = (yaw_per_v_delta * P_delta_yaw_xB) + (mu * t321);
    const float t324 = sin_lam * t321;
    const float K2_22_xB = yaw_per_v_delta * t321;
    const float M_11_zB = t21 + t21;
    const float t328 = mu + (yaw_per_v_delta * p->xB);
    const float t329 = p->mB * t328;
    const float t330 = p->mB * yaw_per_v_delta;
    const float M_11_mB = p->zB * p->zB;
    const float t332 = p->zB * t314;
    const float P_delta_yaw_mB = p->xB * t314;
    const float M_22_mB = mu * P_delta_yaw_mB;
    const float t335 = p->zB * t328;
    const float C1_22_mB = (yaw_per_v_delta * P_delta_yaw_mB) + (mu * t314);
    const float t339 = sin_lam * t314;
    const float t340 = p->zB * yaw_per_v_delta;
    const float K2_22_mB = yaw_per_v_delta * t314;
    const float C1_22_xH = (mu * t199) - t193;
    const float t344 = sin_lam * t199;
    const float K2_22_xH = yaw_per_v_delta * t199;
    const float M_11_zH = t6 + t6;
    const float K0_12_mH = (p->zH * sin_lam) + (t36 * M_12_Jxz_delta) - t139;
    const float M_12_zH = (p->mH * K0_12_mH) + (t6 * sin_lam);
    const float M_22_Jxx_delta = sin_lam * sin_lam;
    const float t359 = (p->zH * M_22_Jxx_delta) + (t36 * M_22_Jxz_delta) - (sin_lam * t140);
    const float M_22_zH = (p->mH * t359) + (t6 * M_22_Jxx_delta);
    const float t363 = mu + t180;
    const float t365 = (t36 * yaw_per_v_delta) - t363;
    const float C1_12_zH = p->mH * t365;
    const float t367 = sin_lam * t180;
    const float t369 = (t36 * C1_22_Jxz_delta) - t367;
    const float K0_12_zH = p->mH * sin_lam;
    const float C1_22_zH = (p->mH * t369) - (mu * K0_12_zH);
    const float K0_22_zH = sin_lam * K0_12_zH;
    const float t375 = p->mH * yaw_per_v_delta;
    const float t376 = yaw_per_v_delta * K0_12_zH;
    const float M_11_mH = p->zH * p->zH;
    const float M_12_mH = p->zH * K0_12_mH;
    const float P_delta_yaw_mA = t34 * t139;
    const float M_22_mA = mu * P_delta_yaw_mA;
    const float M_22_mH = M_22_mA + (p->zH * t359) + (t36 * t149);
    const float C1_12_mH = p->zH * t365;
    const float C1_22_mA = yaw_per_v_delta * P_delta_yaw_mA;
    const float C1_22_mH = C1_22_mA + (p->zH * t369) + (t36 * t188) - (mu * K0_12_mH);
    const float K0_22_mH = sin_lam * K0_12_mH;
    const float t394 = p->zH * yaw_per_v_delta;
    const float t395 = yaw_per_v_delta * K0_12_mH;
    const float Jxx_delta_rF = t10 + t10;
    const float M_12_rF = sin_lam * Jxx_delta_rF;
    const float M_22_rF = M_22_Jxx_delta * Jxx_delta_rF;
    const float t399 = t363 - mu;
    const float t401 = t101 * SF;
    const float C1_21_rF = M_12_Jxz_delta * t401;
    const float C1_12_rF = (p->mF * t399) - C1_21_rF;
    const float t405 = t367 - (p->c * C1_22_Jxz_delta);
    const float P_delta_lateral_rF = p->mF * sin_lam;
    const float C1_22_rF = (p->mF * t405) + (mu * P_delta_lateral_rF);
    const float t410 = sin_lam * P_delta_lateral_rF;
    const float K2_12_rF = (p->mF * yaw_per_v_delta) - (yaw_per_v_delta * t401);
    const float K2_22_rF = (yaw_per_v_delta * P_delta_lateral_rF) - (C1_22_Jxz_delta * t401);
    const float Jxx_delta_mF = p->rF * p->rF;
    const float M_12_mF = sin_lam * Jxx_delta_mF;
    const float M_22_mF = M_22_mA + (p->c * t223) + (M_22_Jxx_delta * Jxx_delta_mF);
    const float C1_12_mF = p->rF * t399;
    const float K0_12_mF = (p->c * M_12_Jxz_delta) - t139 - (p->rF * sin_lam);
    const float C1_22_mF = C1_22_mA + (p->c * t237) + (p->rF * t405) - (mu * K0_12_mF);
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float M_22_IFxx = M_22_Jzz_delta + M_22_Jxx_delta;
    const float C1_12_IFyy = t101 * M_12_Jxz_delta;
    const float K2_12_IFyy = yaw_per_v_delta * t101;
    const float K2_22_IFyy = t101 * C1_22_Jxz_delta;
    const float C0_21 = -C0_12;
    const float C1_21 = -(t103 + (mu * ST));
    const float K0_12_c = t242 - t241;
    const float t444 = -(sin_lam * K0_12_mF);
    const float K2_22_mF = -(yaw_per_v_delta * K0_12_mF);
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
    matrices->k0[0][0] = Sz_all;
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
    derivatives->values[0] = M_12_w;
    derivatives->values[1] = M_22_w;
    derivatives->values[2] = C0_21_w;
    derivatives->values[3] = C1_12_w;
    derivatives->values[4] = C1_21_w;
    derivatives->values[5] = C1_22_w;
    derivatives->values[6] = K0_12_w;
    derivatives->values[7] = K0_22_w;
    derivatives->values[8] = t211;
    derivatives->values[9] = t213;
    derivatives->values[10] = t214;
    derivatives->values[11] = t217;
    derivatives->values[12] = M_12_c;
    derivatives->values[13] = M_22_c;
    derivatives->values[14] = K1_12;
    derivatives->values[15] = C1_12_c;
    derivatives->values[16] = t234;
    derivatives->values[17] = C1_22_c;
    derivatives->values[18] = K0_12_c;
    derivatives->values[19] = t251;
    derivatives->values[20] = K2_22_c;
    derivatives->values[21] = M_12_lam;
    derivatives->values[22] = M_22_lam;
    derivatives->values[23] = C0_21_lam;
    derivatives->values[24] = t277;
    derivatives->values[25] = C1_21_lam;
    derivatives->values[26] = C1_22_lam;
    derivatives->values[27] = K0_12_lam;
    derivatives->values[28] = K0_22_lam;
    derivatives->values[29] = t292;
    derivatives->values[30] = K1_22_lam;
    derivatives->values[31] = t296;
    derivatives->values[32] = K2_22_lam;
    derivatives->values[33] = M_11_rR;
    derivatives->values[34] = C1_12_rR;
    derivatives->values[35] = C1_21_rR;
    derivatives->values[36] = p->mR;
    derivatives->values[37] = K2_12_rR;
    derivatives->values[38] = M_11_mR;
    derivatives->values[39] = C1_12_mR;
    derivatives->values[40] = p->rR;
    derivatives->values[41] = K2_12_mR;
    derivatives->values[42] = 1.0F;
    derivatives->values[43] = M_22_IRxx;
    derivatives->values[44] = C1_22_IRxx;
    derivatives->values[45] = C1_12_IRyy;
    derivatives->values[46] = K2_12_IRyy;
    derivatives->values[47] = t313;
    derivatives->values[48] = M_22_xB;
    derivatives->values[49] = t319;
    derivatives->values[50] = C1_22_xB;
    derivatives->values[51] = t321;
    derivatives->values[52] = t324;
    derivatives->values[53] = K2_22_xB;
    derivatives->values[54] = M_11_zB;
    derivatives->values[55] = t315;
    derivatives->values[56] = t329;
    derivatives->values[57] = p->mB;
    derivatives->values[58] = t330;
    derivatives->values[59] = M_11_mB;
    derivatives->values[60] = t332;
    derivatives->values[61] = M_22_mB;
    derivatives->values[62] = t335;
    derivatives->values[63] = C1_22_mB;
    derivatives->values[64] = p->zB;
    derivatives->values[65] = t314;
    derivatives->values[66] = t339;
    derivatives->values[67] = t340;
    derivatives->values[68] = K2_22_mB;
    derivatives->values[69] = mu;
    derivatives->values[70] = yaw_per_v_delta;
    derivatives->values[71] = t132;
    derivatives->values[72] = t157;
    derivatives->values[73] = t171;
    derivatives->values[74] = C1_22_xH;
    derivatives->values[75] = t199;
    derivatives->values[76] = t344;
    derivatives->values[77] = K2_22_xH;
    derivatives->values[78] = M_11_zH;
    derivatives->values[79] = M_12_zH;
    derivatives->values[80] = M_22_zH;
    derivatives->values[81] = C1_12_zH;
    derivatives->values[82] = C1_22_zH;
    derivatives->values[83] = p->mH;
    derivatives->values[84] = K0_12_zH;
    derivatives->values[85] = K0_22_zH;
    derivatives->values[86] = t375;
    derivatives->values[87] = t376;
    derivatives->values[88] = M_11_mH;
    derivatives->values[89] = M_12_mH;
    derivatives->values[90] = M_22_mH;
    derivatives->values[91] = C1_12_mH;
    derivatives->values[92] = C1_22_mH;
    derivatives->values[93] = p->zH;
    derivatives->values[94] = K0_12_mH;
    derivatives->values[95] = K0_22_mH;
    derivatives->values[96] = t394;
    derivatives->values[97] = t395;
    derivatives->values[98] = sin_lam;
    derivatives->values[99] = M_22_Jxx_delta;
    derivatives->values[100] = M_22_Jzz_delta;
    derivatives->values[101] = C1_22_Jzz_delta;
    derivatives->values[102] = M_12_Jxz_delta;
    derivatives->values[103] = M_22_Jxz_delta;
    derivatives->values[104] = C1_22_Jxz_delta;
    derivatives->values[105] = Jxx_delta_rF;
    derivatives->values[106] = M_12_rF;
    derivatives->values[107] = M_22_rF;
    derivatives->values[108] = C1_12_rF;
    derivatives->values[109] = C1_21_rF;
    derivatives->values[110] = C1_22_rF;
    derivatives->values[111] = p->mF;
    derivatives->values[112] = P_delta_lateral_rF;
    derivatives->values[113] = t410;
    derivatives->values[114] = K2_12_rF;
    derivatives->values[115] = K2_22_rF;
    derivatives->values[116] = Jxx_delta_mF;
    derivatives->values[117] = M_12_mF;
    derivatives->values[118] = M_22_mF;
    derivatives->values[119] = C1_12_mF;
    derivatives->values[120] = C1_22_mF;
    derivatives->values[121] = p->rF;
    derivatives->values[122] = K0_12_mF;
    derivatives->values[123] = t444;
    derivatives->values[124] = K2_12_mF;
    derivatives->values[125] = K2_22_mF;
    derivatives->values[126] = M_22_IFxx;
    derivatives->values[127] = C1_12_IFyy;
    derivatives->values[128] = K2_12_IFyy;
    derivatives->values[129] = K2_22_IFyy;
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
