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
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 12U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 12U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 13U, false},
    {CARVALLO_MATRIX_C0, 0U, 1U, 1U, 14U, false},
    {CARVALLO_MATRIX_C0, 1U, 0U, 1U, 14U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 15U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 1U, 16U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 1U, 17U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 1U, 18U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 1U, 18U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 19U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 1U, 20U, true},
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
    {CARVALLO_MATRIX_M, 1U, 1U, 15U, 72U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 15U, 73U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 15U, 74U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 15U, 75U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 15U, 75U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 15U, 76U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 15U, 77U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 16U, 78U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 16U, 79U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 16U, 79U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 16U, 80U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 81U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 82U, true},
    {CARVALLO_MATRIX_K0, 0U, 0U, 16U, 83U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 16U, 84U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 16U, 84U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 16U, 85U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 16U, 86U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 16U, 87U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 17U, 88U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 89U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 89U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 90U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 91U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 92U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 17U, 93U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 17U, 94U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 17U, 94U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 17U, 95U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 17U, 96U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 17U, 97U, false},
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
    {CARVALLO_MATRIX_M, 0U, 1U, 23U, 117U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 23U, 117U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 23U, 118U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 23U, 119U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 23U, 120U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 23U, 121U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 122U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 122U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 23U, 123U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 23U, 124U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 23U, 125U, true},
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
    const double t2 = p->zB * p->mB;
    const double t7 = p->zH * p->mH;
    const double t13 = p->rF * p->mF;
    const double Jxx_delta = p->IFxx + (p->zH * t7) + (p->IHxx + (p->rF * t13));
    const double t19 = p->rR * p->mR;
    const double M_11 = (p->zB * t2) + (Jxx_delta + ((p->rR * t19) + (p->IRxx + p->IBxx)));
    double sin_lam = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &sin_lam, &cos_lam);
    const double t31 = 1.0 / p->w;
    const double yaw_per_v_delta = cos_lam * t31;
    const double mu = p->c * yaw_per_v_delta;
    const double t36 = p->c + p->w;
    const double t37 = p->xH - t36;
    const double t41 = p->IHxz - (t7 * t37) - (t13 * p->c);
    const double Sz_delta = t7 - t13;
    const double t47 = p->mB * p->xB;
    const double mA = p->zB * t47;
    const double t50 = t41 + (p->IBxz - (t36 * Sz_delta) - mA);
    const double t55 = (Jxx_delta * sin_lam) + (t41 * cos_lam);
    const double M_12 = (mu * t50) + t55;
    const double t59 = p->mH * t37;
    const double t62 = p->mF * p->c;
    const double Jzz_delta = p->IFxx + (p->IHzz + (t37 * t59) + (p->c * t62));
    const double t67 = (sin_lam * t41) + (cos_lam * Jzz_delta);
    const double t70 = t59 - t62;
    const double t72 = (sin_lam * Sz_delta) - (cos_lam * t70);
    const double t74 = (t36 * t72) - t67;
    const double t79 = (p->mH * p->xH) + (p->mF * p->w);
    const double hx_delta = p->IRxx + Jzz_delta + ((p->xB * t47) + (t36 * (t70 + t79)));
    const double t87 = (mu * (hx_delta + p->IBzz)) - t74;
    const double t95 = p->hH + p->hB;
    const double t97 = cos_lam * p->hH;
    const double C0_12 = (mu * t95) + t97;
    const double K0_11 = Sz_delta - (t19 - t2);
    const double SF = p->IFyy / p->rF;
    const double ST = SF + (p->IRyy / p->rR);
    const double t111 = (mu * ST) + (cos_lam * SF);
    const double C1_12 = ((t50 - (p->c * K0_11)) * yaw_per_v_delta) + t111;
    const double Sx_all = t47 + t79;
    const double K0_12 = t72 - (mu * Sx_all);
    const double C1_22 = (yaw_per_v_delta * t87) - (mu * K0_12);
    const double K0_22 = sin_lam * K0_12;
    const double K1_12 = yaw_per_v_delta * t95;
    const double K1_22 = t31 * (sin_lam * t97);
    const double K2_12 = yaw_per_v_delta * (ST - K0_11);
    const double K2_22 = yaw_per_v_delta * ((sin_lam * SF) - K0_12);
    const double M_22 = (cos_lam * t67) - ((mu * (t74 - t87)) - (sin_lam * t55));
    const double C0_21 = -C0_12;
    const double C1_21 = -t111;
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
    const double t3 = p->rF * p->mF;
    const double Jzz_all_mB = p->rF * t3;
    const double Jxz_delta_w = p->zH * p->mH;
    const double Jxx_delta = Jzz_all_mB + p->IFxx + p->IHxx + (p->zH * Jxz_delta_w);
    const double M_11_mB = p->zB * p->zB;
    const double M_11_mR = p->rR * p->rR;
    const double M_11 = p->IRxx + Jxx_delta + p->IBxx + (p->mB * M_11_mB) + (p->mR * M_11_mR);
    double hx_delta_Jxx_delta = 0.0;
    double hx_delta_Jxz_delta = 0.0;
    carvallo_sin_cos_f64(p->lam, &hx_delta_Jxx_delta, &hx_delta_Jxz_delta);
    const double t31 = p->mF * p->c;
    const double Sx_all_mA = p->c + p->w;
    const double Sx_delta_mH = p->xH - Sx_all_mA;
    const double t40 = (p->rF * t31) + (Jxz_delta_w * Sx_delta_mH) - p->IHxz;
    const double t42 = t40 * hx_delta_Jxz_delta;
    const double hx_delta = (Jxx_delta * hx_delta_Jxx_delta) - t42;
    const double t44 = 1.0 / p->w;
    const double yaw_per_v_delta = hx_delta_Jxz_delta * t44;
    const double mu = p->c * yaw_per_v_delta;
    const double t48 = p->mB * p->xB;
    const double t50 = t3 - Jxz_delta_w;
    const double t55 = t40 + (p->zB * t48) - (Sx_all_mA * t50) - p->IBxz;
    const double M_12 = hx_delta - (mu * t55);
    const double t59 = hx_delta_Jxx_delta * t40;
    const double t62 = p->mH * Sx_delta_mH;
    const double Jzz_delta = p->IFxx + p->IHzz + (p->c * t31) + (Sx_delta_mH * t62);
    const double t68 = t59 - (hx_delta_Jxz_delta * Jzz_delta);
    const double t70 = hx_delta_Jxx_delta * t50;
    const double Sx_delta = t62 - t31;
    const double py_delta = t70 + (hx_delta_Jxz_delta * Sx_delta);
    const double t75 = t68 - (Sx_all_mA * py_delta);
    const double mA = p->mF + p->mH;
    const double t80 = Sx_all_mA * mA;
    const double t81 = 0.5 * t80;
    const double t82 = Sx_delta + Sx_delta;
    const double t84 = t81 + t81 + t82;
    const double t89 = p->IRxx + Jzz_delta + p->IBzz + (p->xB * t48) + (Sx_all_mA * t84);
    const double t90 = mu * t89;
    const double t91 = t75 - t90;
    const double t92 = t75 + t91;
    const double M_22 = (hx_delta_Jxx_delta * hx_delta) - (hx_delta_Jxz_delta * t68) - (mu * t92);
    const double K1_12_yaw_per_v_delta = p->hH + p->hB;
    const double t101 = hx_delta_Jxz_delta * p->hH;
    const double C0_12 = (mu * K1_12_yaw_per_v_delta) + t101;
    const double SF_IFyy = 1.0 / p->rF;
    const double SF = p->IFyy * SF_IFyy;
    const double t106 = hx_delta_Jxz_delta * SF;
    const double SR_IRyy = 1.0 / p->rR;
    const double ST = SF + (p->IRyy * SR_IRyy);
    const double t111 = p->mB * p->zB;
    const double t112 = p->mR * p->rR;
    const double t113 = t111 - t112;
    const double K2_12_yaw_per_v_delta = ST + (t50 - t113);
    const double t117 = (p->c * K2_12_yaw_per_v_delta) - t55;
    const double C1_12 = t106 + (yaw_per_v_delta * t117);
    const double Sx_all = t48 + Sx_delta + t80;
    const double t124 = mu * Sx_all;
    const double P_delta_lateral = py_delta + t124;
    const double K1_12 = yaw_per_v_delta * K1_12_yaw_per_v_delta;
    const double t131 = hx_delta_Jxx_delta * t44;
    const double C1_22_Jxz_delta = hx_delta_Jxz_delta * t131;
    const double K1_22 = p->hH * C1_22_Jxz_delta;
    const double K2_12 = yaw_per_v_delta * K2_12_yaw_per_v_delta;
    const double t135 = hx_delta_Jxx_delta * SF;
    const double K2_22_yaw_per_v_delta = P_delta_lateral + t135;
    const double K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
    const double M_12_Jxz_delta = hx_delta_Jxz_delta + mu;
    const double t140 = p->mH * M_12_Jxz_delta;
    const double t141 = p->zH * t140;
    const double t143 = hx_delta_Jxz_delta / (p->w * p->w);
    const double t144 = p->c * t143;
    const double M_12_w = (mu * t50) + t141 + (t55 * t144);
    const double t148 = Sx_delta_mH * M_12_Jxz_delta;
    const double t149 = M_12_Jxz_delta * t148;
    const double Jzz_all_Sx_delta = Sx_all_mA + Sx_all_mA;
    const double t151 = mu * Jzz_all_Sx_delta;
    const double M_22_Sx_delta = M_12_Jxz_delta * t151;
    const double M_22_Jxz_delta = M_12_Jxz_delta * (hx_delta_Jxx_delta + hx_delta_Jxx_delta);
    const double t157 = t149 + M_22_Sx_delta - (p->zH * M_22_Jxz_delta);
    const double M_22_xH = p->mH * (t149 + t157);
    const double t160 = t92 - t90;
    const double Jzz_all_w = t80 + t84;
    const double t164 = py_delta + (mu * Jzz_all_w);
    const double t166 = mu * (py_delta + t164);
    const double M_22_w = (t144 * t160) + t166 - M_22_xH;
    const double C0_21_w = K1_12_yaw_per_v_delta * t144;
    const double C1_12_w = (t3 * yaw_per_v_delta) - (t117 * t143);
    const double C1_21_w = ST * t144;
    const double t174 = mu * mA;
    const double t176 = t164 + (p->c * t174);
    const double K2_22_Sx_delta = yaw_per_v_delta * M_12_Jxz_delta;
    const double C1_22_Jzz_all = yaw_per_v_delta * mu;
    const double M_22_Jzz_all = p->c * C1_22_Jzz_all;
    const double t182 = Sx_all_mA * yaw_per_v_delta;
    const double C1_22_py_delta = mu + t182;
    const double K2_22_mA = Sx_all_mA * C1_22_Jzz_all;
    const double t187 = M_22_Jzz_all + (hx_delta_Jxz_delta * C1_22_py_delta) + K2_22_mA;
    const double M_22_mA = p->c * t182;
    const double t189 = p->zH * hx_delta_Jxx_delta;
    const double t190 = M_22_mA - t189;
    const double t191 = t148 + t190;
    const double K2_22_mH = yaw_per_v_delta * t191;
    const double t193 = t187 + K2_22_mH;
    const double C1_22_xH = (t62 * K2_22_Sx_delta) + (p->mH * t193);
    const double C1_22_mu = t124 + P_delta_lateral + (yaw_per_v_delta * t89);
    const double t200 = t91 - (p->c * C1_22_mu);
    const double C1_22_w = (yaw_per_v_delta * t176) + (t143 * t200) - C1_22_xH;
    const double K0_12_w = t140 + (Sx_all * t144) - t174;
    const double K0_22_w = hx_delta_Jxx_delta * K0_12_w;
    const double t208 = K1_12_yaw_per_v_delta * t143;
    const double K1_22_yaw_per_v_delta = hx_delta_Jxx_delta * p->hH;
    const double t210 = t143 * K1_22_yaw_per_v_delta;
    const double t211 = K2_12_yaw_per_v_delta * t143;
    const double t214 = (yaw_per_v_delta * K0_12_w) + (K2_22_yaw_per_v_delta * t143);
    const double t216 = hx_delta_Jxz_delta * t50;
    const double t217 = (yaw_per_v_delta * t55) + t216;
    const double t220 = t70 + (t82 * M_12_Jxz_delta);
    const double M_22_c = t166 - (yaw_per_v_delta * t160) - (M_12_Jxz_delta * (t70 + t220 + (mA *
        t151)));
    const double t227 = yaw_per_v_delta * ST;
    const double C1_22_Sx_delta = K2_22_mA + t187;
    const double C1_22_c = (yaw_per_v_delta * (t176 + C1_22_mu - t220)) - (mA * C1_22_Sx_delta);
    const double K0_12_c = hx_delta_Jxz_delta * (mA - (t44 * Sx_all));
    const double K0_22_c = hx_delta_Jxx_delta * K0_12_c;
    const double t238 = yaw_per_v_delta * K0_12_c;
    const double t239 = p->c * t131;
    const double hx_delta_lam = t59 + (Jxx_delta * hx_delta_Jxz_delta);
    const double M_12_lam = (t55 * t239) + hx_delta_lam;
    const double t245 = (hx_delta_Jxx_delta * Sx_delta) - t216;
    const double t248 = (M_22_mA * t245) - (t91 * t239);
    const double M_22_hz_delta = mu + M_12_Jxz_delta;
    const double t251 = t42 + (hx_delta_Jxx_delta * Jzz_delta);
    const double M_22_lam = (hx_delta_Jxz_delta * hx_delta) + (hx_delta_Jxx_delta * (t68 +
        hx_delta_lam)) - t248 - t248 - (M_22_hz_delta * t251);
    const double t260 = K1_12_yaw_per_v_delta * t131;
    const double C0_21_lam = K1_22_yaw_per_v_delta + (p->c * t260);
    const double t264 = t135 + (t117 * t131);
    const double C1_21_lam = t135 + (ST * t239);
    const double C1_22_lam = (t131 * t200) - (yaw_per_v_delta * t251) - (C1_22_py_delta * t245);
    const double K0_12_lam = t245 + (Sx_all * t239);
    const double K0_22_lam = (hx_delta_Jxx_delta * K0_12_lam) - (hx_delta_Jxz_delta *
        P_delta_lateral);
    const double K1_22_lam = (yaw_per_v_delta * t101) - (t131 * K1_22_yaw_per_v_delta);
    const double t280 = K2_12_yaw_per_v_delta * t131;
    const double K2_22_lam = (yaw_per_v_delta * (t106 - K0_12_lam)) - (t131 *
        K2_22_yaw_per_v_delta);
    const double M_11_rR = t112 + t112;
    const double t286 = p->IRyy / M_11_mR;
    const double K2_12_rR = yaw_per_v_delta * (p->mR - t286);
    const double C1_12_rR = p->c * K2_12_rR;
    const double C1_21_rR = mu * t286;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double C1_12_mR = p->c * K2_12_mR;
    const double C1_12_IRyy = mu * SR_IRyy;
    const double K2_12_IRyy = yaw_per_v_delta * SR_IRyy;
    const double t296 = yaw_per_v_delta * t111;
    const double t297 = p->c * t296;
    const double t298 = p->mB * yaw_per_v_delta;
    const double t299 = p->c * t298;
    const double t300 = yaw_per_v_delta * p->xB;
    const double t301 = p->c * t300;
    const double t302 = t299 * t301;
    const double M_22_xB = t302 + t302;
    const double t304 = mu + t300;
    const double Jzz_delta_mF = t300 + t304;
    const double C1_22_xB = t299 * Jzz_delta_mF;
    const double t307 = hx_delta_Jxx_delta * t299;
    const double K2_22_xB = yaw_per_v_delta * t299;
    const double M_11_zB = t111 + t111;
    const double t310 = p->mB * t301;
    const double t311 = p->mB * t304;
    const double t312 = p->zB * t301;
    const double M_22_mB = t301 * t301;
    const double t314 = p->zB * t304;
    const double K2_22_mB = yaw_per_v_delta * t301;
    const double C1_22_mB = p->xB * (M_22_Jzz_all + K2_22_mB);
    const double t318 = hx_delta_Jxx_delta * t301;
    const double t319 = p->zB * yaw_per_v_delta;
    const double t320 = p->mH * yaw_per_v_delta;
    const double t321 = p->zH * t320;
    const double K0_12_zH = p->mH * hx_delta_Jxx_delta;
    const double t323 = M_12_Jxz_delta * K0_12_zH;
    const double K2_22_xH = yaw_per_v_delta * t140;
    const double Jxx_delta_zH = Jxz_delta_w + Jxz_delta_w;
    const double M_12_zH = p->mH * (t189 - t191);
    const double t328 = hx_delta_Jxx_delta * t191;
    const double t330 = p->mH * (t328 + t328);
    const double t331 = p->c + p->xH;
    const double t332 = t320 * t331;
    const double t333 = hx_delta_Jxx_delta * t332;
    const double K0_22_zH = hx_delta_Jxx_delta * K0_12_zH;
    const double t335 = p->mH * C1_22_Jxz_delta;
    const double Jxx_delta_mH = p->zH * p->zH;
    const double t337 = p->zH * t191;
    const double t338 = M_22_mA * M_22_mA;
    const double M_22_mH = t338 + (Sx_delta_mH * t157) - (t189 * (M_22_mA + t190));
    const double t344 = p->zH * yaw_per_v_delta;
    const double t345 = t331 * t344;
    const double C1_22_mH = (C1_22_py_delta * t190) + (Sx_delta_mH * t193);
    const double M_delta_delta_Jxx_delta = hx_delta_Jxx_delta * hx_delta_Jxx_delta;
    const double M_22_Jzz_delta = M_12_Jxz_delta * M_12_Jxz_delta;
    const double Jxx_delta_rF = t3 + t3;
    const double py_delta_mF = p->rF * hx_delta_Jxx_delta;
    const double t353 = p->c * M_12_Jxz_delta;
    const double t354 = M_22_mA + py_delta_mF;
    const double K0_12_mF = t353 - t354;
    const double M_12_rF = p->mF * (py_delta_mF - K0_12_mF);
    const double M_22_rF = (M_delta_delta_Jxx_delta * Jxx_delta_rF) - (t31 * (M_22_Jxz_delta -
        (C1_22_Jxz_delta * Jzz_all_Sx_delta)));
    const double t363 = p->mF * t182;
    const double Jxx_delta_mF = p->rF * p->rF;
    const double t365 = p->IFyy / Jxx_delta_mF;
    const double C1_21_rF = M_12_Jxz_delta * t365;
    const double C1_12_rF = t363 - C1_21_rF;
    const double C1_22_rF = hx_delta_Jxx_delta * t363;
    const double py_delta_rF = p->mF * hx_delta_Jxx_delta;
    const double t370 = p->mF * M_delta_delta_Jxx_delta;
    const double K2_12_rF = yaw_per_v_delta * (p->mF - t365);
    const double K2_22_rF = hx_delta_Jxx_delta * K2_12_rF;
    const double t374 = p->rF * K0_12_mF;
    const double M_22_mF = t338 + (p->c * ((p->c * M_22_Jzz_delta) - M_22_Sx_delta)) -
        (py_delta_mF * (t353 + K0_12_mF - M_22_mA));
    const double C1_12_mF = p->rF * t182;
    const double t385 = yaw_per_v_delta * K0_12_mF;
    const double C1_22_mF = (C1_22_py_delta * t354) - (p->c * (t187 - t385));
    const double K0_22_mF = hx_delta_Jxx_delta * K0_12_mF;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double M_22_IFxx = M_delta_delta_Jxx_delta + M_22_Jzz_delta;
    const double C1_12_IFyy = SF_IFyy * M_12_Jxz_delta;
    const double K2_12_IFyy = yaw_per_v_delta * SF_IFyy;
    const double K2_22_IFyy = SF_IFyy * C1_22_Jxz_delta;
    const double C0_21 = -C0_12;
    const double C1_21 = -(t106 + (mu * ST));
    const double C1_22 = -(yaw_per_v_delta * (t91 - (p->c * P_delta_lateral)));
    const double K0_11 = t113 - t50;
    const double K0_12 = -P_delta_lateral;
    const double K0_22 = -(hx_delta_Jxx_delta * P_delta_lateral);
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
    derivatives->values[0] = M_12_w;
    derivatives->values[1] = M_22_w;
    derivatives->values[2] = C0_21_w;
    derivatives->values[3] = C1_12_w;
    derivatives->values[4] = C1_21_w;
    derivatives->values[5] = C1_22_w;
    derivatives->values[6] = K0_12_w;
    derivatives->values[7] = K0_22_w;
    derivatives->values[8] = t208;
    derivatives->values[9] = t210;
    derivatives->values[10] = t211;
    derivatives->values[11] = t214;
    derivatives->values[12] = t217;
    derivatives->values[13] = M_22_c;
    derivatives->values[14] = K1_12;
    derivatives->values[15] = K2_12;
    derivatives->values[16] = t227;
    derivatives->values[17] = C1_22_c;
    derivatives->values[18] = K0_12_c;
    derivatives->values[19] = K0_22_c;
    derivatives->values[20] = t238;
    derivatives->values[21] = M_12_lam;
    derivatives->values[22] = M_22_lam;
    derivatives->values[23] = C0_21_lam;
    derivatives->values[24] = t264;
    derivatives->values[25] = C1_21_lam;
    derivatives->values[26] = C1_22_lam;
    derivatives->values[27] = K0_12_lam;
    derivatives->values[28] = K0_22_lam;
    derivatives->values[29] = t260;
    derivatives->values[30] = K1_22_lam;
    derivatives->values[31] = t280;
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
    derivatives->values[43] = M_22_Jzz_all;
    derivatives->values[44] = C1_22_Jzz_all;
    derivatives->values[45] = C1_12_IRyy;
    derivatives->values[46] = K2_12_IRyy;
    derivatives->values[47] = t297;
    derivatives->values[48] = M_22_xB;
    derivatives->values[49] = t296;
    derivatives->values[50] = C1_22_xB;
    derivatives->values[51] = t299;
    derivatives->values[52] = t307;
    derivatives->values[53] = K2_22_xB;
    derivatives->values[54] = M_11_zB;
    derivatives->values[55] = t310;
    derivatives->values[56] = t311;
    derivatives->values[57] = p->mB;
    derivatives->values[58] = t298;
    derivatives->values[59] = M_11_mB;
    derivatives->values[60] = t312;
    derivatives->values[61] = M_22_mB;
    derivatives->values[62] = t314;
    derivatives->values[63] = C1_22_mB;
    derivatives->values[64] = p->zB;
    derivatives->values[65] = t301;
    derivatives->values[66] = t318;
    derivatives->values[67] = t319;
    derivatives->values[68] = K2_22_mB;
    derivatives->values[69] = mu;
    derivatives->values[70] = yaw_per_v_delta;
    derivatives->values[71] = t141;
    derivatives->values[72] = M_22_xH;
    derivatives->values[73] = t321;
    derivatives->values[74] = C1_22_xH;
    derivatives->values[75] = t140;
    derivatives->values[76] = t323;
    derivatives->values[77] = K2_22_xH;
    derivatives->values[78] = Jxx_delta_zH;
    derivatives->values[79] = M_12_zH;
    derivatives->values[80] = t330;
    derivatives->values[81] = t332;
    derivatives->values[82] = t333;
    derivatives->values[83] = p->mH;
    derivatives->values[84] = K0_12_zH;
    derivatives->values[85] = K0_22_zH;
    derivatives->values[86] = t320;
    derivatives->values[87] = t335;
    derivatives->values[88] = Jxx_delta_mH;
    derivatives->values[89] = t337;
    derivatives->values[90] = M_22_mH;
    derivatives->values[91] = t345;
    derivatives->values[92] = C1_22_mH;
    derivatives->values[93] = p->zH;
    derivatives->values[94] = t191;
    derivatives->values[95] = t328;
    derivatives->values[96] = t344;
    derivatives->values[97] = K2_22_mH;
    derivatives->values[98] = hx_delta_Jxx_delta;
    derivatives->values[99] = M_delta_delta_Jxx_delta;
    derivatives->values[100] = M_22_Jzz_delta;
    derivatives->values[101] = K2_22_Sx_delta;
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
    derivatives->values[112] = py_delta_rF;
    derivatives->values[113] = t370;
    derivatives->values[114] = K2_12_rF;
    derivatives->values[115] = K2_22_rF;
    derivatives->values[116] = Jxx_delta_mF;
    derivatives->values[117] = t374;
    derivatives->values[118] = M_22_mF;
    derivatives->values[119] = C1_12_mF;
    derivatives->values[120] = C1_22_mF;
    derivatives->values[121] = p->rF;
    derivatives->values[122] = K0_12_mF;
    derivatives->values[123] = K0_22_mF;
    derivatives->values[124] = K2_12_mF;
    derivatives->values[125] = t385;
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
    const float t2 = p->zB * p->mB;
    const float t7 = p->zH * p->mH;
    const float t13 = p->rF * p->mF;
    const float Jxx_delta = p->IFxx + (p->zH * t7) + (p->IHxx + (p->rF * t13));
    const float t19 = p->rR * p->mR;
    const float M_11 = (p->zB * t2) + (Jxx_delta + ((p->rR * t19) + (p->IRxx + p->IBxx)));
    float sin_lam = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &sin_lam, &cos_lam);
    const float t31 = 1.0F / p->w;
    const float yaw_per_v_delta = cos_lam * t31;
    const float mu = p->c * yaw_per_v_delta;
    const float t36 = p->c + p->w;
    const float t37 = p->xH - t36;
    const float t41 = p->IHxz - (t7 * t37) - (t13 * p->c);
    const float Sz_delta = t7 - t13;
    const float t47 = p->mB * p->xB;
    const float mA = p->zB * t47;
    const float t50 = t41 + (p->IBxz - (t36 * Sz_delta) - mA);
    const float t55 = (Jxx_delta * sin_lam) + (t41 * cos_lam);
    const float M_12 = (mu * t50) + t55;
    const float t59 = p->mH * t37;
    const float t62 = p->mF * p->c;
    const float Jzz_delta = p->IFxx + (p->IHzz + (t37 * t59) + (p->c * t62));
    const float t67 = (sin_lam * t41) + (cos_lam * Jzz_delta);
    const float t70 = t59 - t62;
    const float t72 = (sin_lam * Sz_delta) - (cos_lam * t70);
    const float t74 = (t36 * t72) - t67;
    const float t79 = (p->mH * p->xH) + (p->mF * p->w);
    const float hx_delta = p->IRxx + Jzz_delta + ((p->xB * t47) + (t36 * (t70 + t79)));
    const float t87 = (mu * (hx_delta + p->IBzz)) - t74;
    const float t95 = p->hH + p->hB;
    const float t97 = cos_lam * p->hH;
    const float C0_12 = (mu * t95) + t97;
    const float K0_11 = Sz_delta - (t19 - t2);
    const float SF = p->IFyy / p->rF;
    const float ST = SF + (p->IRyy / p->rR);
    const float t111 = (mu * ST) + (cos_lam * SF);
    const float C1_12 = ((t50 - (p->c * K0_11)) * yaw_per_v_delta) + t111;
    const float Sx_all = t47 + t79;
    const float K0_12 = t72 - (mu * Sx_all);
    const float C1_22 = (yaw_per_v_delta * t87) - (mu * K0_12);
    const float K0_22 = sin_lam * K0_12;
    const float K1_12 = yaw_per_v_delta * t95;
    const float K1_22 = t31 * (sin_lam * t97);
    const float K2_12 = yaw_per_v_delta * (ST - K0_11);
    const float K2_22 = yaw_per_v_delta * ((sin_lam * SF) - K0_12);
    const float M_22 = (cos_lam * t67) - ((mu * (t74 - t87)) - (sin_lam * t55));
    const float C0_21 = -C0_12;
    const float C1_21 = -t111;
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
    const float t3 = p->rF * p->mF;
    const float Jzz_all_mB = p->rF * t3;
    const float Jxz_delta_w = p->zH * p->mH;
    const float Jxx_delta = Jzz_all_mB + p->IFxx + p->IHxx + (p->zH * Jxz_delta_w);
    const float M_11_mB = p->zB * p->zB;
    const float M_11_mR = p->rR * p->rR;
    const float M_11 = p->IRxx + Jxx_delta + p->IBxx + (p->mB * M_11_mB) + (p->mR * M_11_mR);
    float hx_delta_Jxx_delta = 0.0F;
    float hx_delta_Jxz_delta = 0.0F;
    carvallo_sin_cos_f32(p->lam, &hx_delta_Jxx_delta, &hx_delta_Jxz_delta);
    const float t31 = p->mF * p->c;
    const float Sx_all_mA = p->c + p->w;
    const float Sx_delta_mH = p->xH - Sx_all_mA;
    const float t40 = (p->rF * t31) + (Jxz_delta_w * Sx_delta_mH) - p->IHxz;
    const float t42 = t40 * hx_delta_Jxz_delta;
    const float hx_delta = (Jxx_delta * hx_delta_Jxx_delta) - t42;
    const float t44 = 1.0F / p->w;
    const float yaw_per_v_delta = hx_delta_Jxz_delta * t44;
    const float mu = p->c * yaw_per_v_delta;
    const float t48 = p->mB * p->xB;
    const float t50 = t3 - Jxz_delta_w;
    const float t55 = t40 + (p->zB * t48) - (Sx_all_mA * t50) - p->IBxz;
    const float M_12 = hx_delta - (mu * t55);
    const float t59 = hx_delta_Jxx_delta * t40;
    const float t62 = p->mH * Sx_delta_mH;
    const float Jzz_delta = p->IFxx + p->IHzz + (p->c * t31) + (Sx_delta_mH * t62);
    const float t68 = t59 - (hx_delta_Jxz_delta * Jzz_delta);
    const float t70 = hx_delta_Jxx_delta * t50;
    const float Sx_delta = t62 - t31;
    const float py_delta = t70 + (hx_delta_Jxz_delta * Sx_delta);
    const float t75 = t68 - (Sx_all_mA * py_delta);
    const float mA = p->mF + p->mH;
    const float t80 = Sx_all_mA * mA;
    const float t81 = 0.5F * t80;
    const float t82 = Sx_delta + Sx_delta;
    const float t84 = t81 + t81 + t82;
    const float t89 = p->IRxx + Jzz_delta + p->IBzz + (p->xB * t48) + (Sx_all_mA * t84);
    const float t90 = mu * t89;
    const float t91 = t75 - t90;
    const float t92 = t75 + t91;
    const float M_22 = (hx_delta_Jxx_delta * hx_delta) - (hx_delta_Jxz_delta * t68) - (mu * t92);
    const float K1_12_yaw_per_v_delta = p->hH + p->hB;
    const float t101 = hx_delta_Jxz_delta * p->hH;
    const float C0_12 = (mu * K1_12_yaw_per_v_delta) + t101;
    const float SF_IFyy = 1.0F / p->rF;
    const float SF = p->IFyy * SF_IFyy;
    const float t106 = hx_delta_Jxz_delta * SF;
    const float SR_IRyy = 1.0F / p->rR;
    const float ST = SF + (p->IRyy * SR_IRyy);
    const float t111 = p->mB * p->zB;
    const float t112 = p->mR * p->rR;
    const float t113 = t111 - t112;
    const float K2_12_yaw_per_v_delta = ST + (t50 - t113);
    const float t117 = (p->c * K2_12_yaw_per_v_delta) - t55;
    const float C1_12 = t106 + (yaw_per_v_delta * t117);
    const float Sx_all = t48 + Sx_delta + t80;
    const float t124 = mu * Sx_all;
    const float P_delta_lateral = py_delta + t124;
    const float K1_12 = yaw_per_v_delta * K1_12_yaw_per_v_delta;
    const float t131 = hx_delta_Jxx_delta * t44;
    const float C1_22_Jxz_delta = hx_delta_Jxz_delta * t131;
    const float K1_22 = p->hH * C1_22_Jxz_delta;
    const float K2_12 = yaw_per_v_delta * K2_12_yaw_per_v_delta;
    const float t135 = hx_delta_Jxx_delta * SF;
    const float K2_22_yaw_per_v_delta = P_delta_lateral + t135;
    const float K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
    const float M_12_Jxz_delta = hx_delta_Jxz_delta + mu;
    const float t140 = p->mH * M_12_Jxz_delta;
    const float t141 = p->zH * t140;
    const float t143 = hx_delta_Jxz_delta / (p->w * p->w);
    const float t144 = p->c * t143;
    const float M_12_w = (mu * t50) + t141 + (t55 * t144);
    const float t148 = Sx_delta_mH * M_12_Jxz_delta;
    const float t149 = M_12_Jxz_delta * t148;
    const float Jzz_all_Sx_delta = Sx_all_mA + Sx_all_mA;
    const float t151 = mu * Jzz_all_Sx_delta;
    const float M_22_Sx_delta = M_12_Jxz_delta * t151;
    const float M_22_Jxz_delta = M_12_Jxz_delta * (hx_delta_Jxx_delta + hx_delta_Jxx_delta);
    const float t157 = t149 + M_22_Sx_delta - (p->zH * M_22_Jxz_delta);
    const float M_22_xH = p->mH * (t149 + t157);
    const float t160 = t92 - t90;
    const float Jzz_all_w = t80 + t84;
    const float t164 = py_delta + (mu * Jzz_all_w);
    const float t166 = mu * (py_delta + t164);
    const float M_22_w = (t144 * t160) + t166 - M_22_xH;
    const float C0_21_w = K1_12_yaw_per_v_delta * t144;
    const float C1_12_w = (t3 * yaw_per_v_delta) - (t117 * t143);
    const float C1_21_w = ST * t144;
    const float t174 = mu * mA;
    const float t176 = t164 + (p->c * t174);
    const float K2_22_Sx_delta = yaw_per_v_delta * M_12_Jxz_delta;
    const float C1_22_Jzz_all = yaw_per_v_delta * mu;
    const float M_22_Jzz_all = p->c * C1_22_Jzz_all;
    const float t182 = Sx_all_mA * yaw_per_v_delta;
    const float C1_22_py_delta = mu + t182;
    const float K2_22_mA = Sx_all_mA * C1_22_Jzz_all;
    const float t187 = M_22_Jzz_all + (hx_delta_Jxz_delta * C1_22_py_delta) + K2_22_mA;
    const float M_22_mA = p->c * t182;
    const float t189 = p->zH * hx_delta_Jxx_delta;
    const float t190 = M_22_mA - t189;
    const float t191 = t148 + t190;
    const float K2_22_mH = yaw_per_v_delta * t191;
    const float t193 = t187 + K2_22_mH;
    const float C1_22_xH = (t62 * K2_22_Sx_delta) + (p->mH * t193);
    const float C1_22_mu = t124 + P_delta_lateral + (yaw_per_v_delta * t89);
    const float t200 = t91 - (p->c * C1_22_mu);
    const float C1_22_w = (yaw_per_v_delta * t176) + (t143 * t200) - C1_22_xH;
    const float K0_12_w = t140 + (Sx_all * t144) - t174;
    const float K0_22_w = hx_delta_Jxx_delta * K0_12_w;
    const float t208 = K1_12_yaw_per_v_delta * t143;
    const float K1_22_yaw_per_v_delta = hx_delta_Jxx_delta * p->hH;
    const float t210 = t143 * K1_22_yaw_per_v_delta;
    const float t211 = K2_12_yaw_per_v_delta * t143;
    const float t214 = (yaw_per_v_delta * K0_12_w) + (K2_22_yaw_per_v_delta * t143);
    const float t216 = hx_delta_Jxz_delta * t50;
    const float t217 = (yaw_per_v_delta * t55) + t216;
    const float t220 = t70 + (t82 * M_12_Jxz_delta);
    const float M_22_c = t166 - (yaw_per_v_delta * t160) - (M_12_Jxz_delta * (t70 + t220 + (mA *
        t151)));
    const float t227 = yaw_per_v_delta * ST;
    const float C1_22_Sx_delta = K2_22_mA + t187;
    const float C1_22_c = (yaw_per_v_delta * (t176 + C1_22_mu - t220)) - (mA * C1_22_Sx_delta);
    const float K0_12_c = hx_delta_Jxz_delta * (mA - (t44 * Sx_all));
    const float K0_22_c = hx_delta_Jxx_delta * K0_12_c;
    const float t238 = yaw_per_v_delta * K0_12_c;
    const float t239 = p->c * t131;
    const float hx_delta_lam = t59 + (Jxx_delta * hx_delta_Jxz_delta);
    const float M_12_lam = (t55 * t239) + hx_delta_lam;
    const float t245 = (hx_delta_Jxx_delta * Sx_delta) - t216;
    const float t248 = (M_22_mA * t245) - (t91 * t239);
    const float M_22_hz_delta = mu + M_12_Jxz_delta;
    const float t251 = t42 + (hx_delta_Jxx_delta * Jzz_delta);
    const float M_22_lam = (hx_delta_Jxz_delta * hx_delta) + (hx_delta_Jxx_delta * (t68 +
        hx_delta_lam)) - t248 - t248 - (M_22_hz_delta * t251);
    const float t260 = K1_12_yaw_per_v_delta * t131;
    const float C0_21_lam = K1_22_yaw_per_v_delta + (p->c * t260);
    const float t264 = t135 + (t117 * t131);
    const float C1_21_lam = t135 + (ST * t239);
    const float C1_22_lam = (t131 * t200) - (yaw_per_v_delta * t251) - (C1_22_py_delta * t245);
    const float K0_12_lam = t245 + (Sx_all * t239);
    const float K0_22_lam = (hx_delta_Jxx_delta * K0_12_lam) - (hx_delta_Jxz_delta *
        P_delta_lateral);
    const float K1_22_lam = (yaw_per_v_delta * t101) - (t131 * K1_22_yaw_per_v_delta);
    const float t280 = K2_12_yaw_per_v_delta * t131;
    const float K2_22_lam = (yaw_per_v_delta * (t106 - K0_12_lam)) - (t131 * K2_22_yaw_per_v_delta);
    const float M_11_rR = t112 + t112;
    const float t286 = p->IRyy / M_11_mR;
    const float K2_12_rR = yaw_per_v_delta * (p->mR - t286);
    const float C1_12_rR = p->c * K2_12_rR;
    const float C1_21_rR = mu * t286;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float C1_12_mR = p->c * K2_12_mR;
    const float C1_12_IRyy = mu * SR_IRyy;
    const float K2_12_IRyy = yaw_per_v_delta * SR_IRyy;
    const float t296 = yaw_per_v_delta * t111;
    const float t297 = p->c * t296;
    const float t298 = p->mB * yaw_per_v_delta;
    const float t299 = p->c * t298;
    const float t300 = yaw_per_v_delta * p->xB;
    const float t301 = p->c * t300;
    const float t302 = t299 * t301;
    const float M_22_xB = t302 + t302;
    const float t304 = mu + t300;
    const float Jzz_delta_mF = t300 + t304;
    const float C1_22_xB = t299 * Jzz_delta_mF;
    const float t307 = hx_delta_Jxx_delta * t299;
    const float K2_22_xB = yaw_per_v_delta * t299;
    const float M_11_zB = t111 + t111;
    const float t310 = p->mB * t301;
    const float t311 = p->mB * t304;
    const float t312 = p->zB * t301;
    const float M_22_mB = t301 * t301;
    const float t314 = p->zB * t304;
    const float K2_22_mB = yaw_per_v_delta * t301;
    const float C1_22_mB = p->xB * (M_22_Jzz_all + K2_22_mB);
    const float t318 = hx_delta_Jxx_delta * t301;
    const float t319 = p->zB * yaw_per_v_delta;
    const float t320 = p->mH * yaw_per_v_delta;
    const float t321 = p->zH * t320;
    const float K0_12_zH = p->mH * hx_delta_Jxx_delta;
    const float t323 = M_12_Jxz_delta * K0_12_zH;
    const float K2_22_xH = yaw_per_v_delta * t140;
    const float Jxx_delta_zH = Jxz_delta_w + Jxz_delta_w;
    const float M_12_zH = p->mH * (t189 - t191);
    const float t328 = hx_delta_Jxx_delta * t191;
    const float t330 = p->mH * (t328 + t328);
    const float t331 = p->c + p->xH;
    const float t332 = t320 * t331;
    const float t333 = hx_delta_Jxx_delta * t332;
    const float K0_22_zH = hx_delta_Jxx_delta * K0_12_zH;
    const float t335 = p->mH * C1_22_Jxz_delta;
    const float Jxx_delta_mH = p->zH * p->zH;
    const float t337 = p->zH * t191;
    const float t338 = M_22_mA * M_22_mA;
    const float M_22_mH = t338 + (Sx_delta_mH * t157) - (t189 * (M_22_mA + t190));
    const float t344 = p->zH * yaw_per_v_delta;
    const float t345 = t331 * t344;
    const float C1_22_mH = (C1_22_py_delta * t190) + (Sx_delta_mH * t193);
    const float M_delta_delta_Jxx_delta = hx_delta_Jxx_delta * hx_delta_Jxx_delta;
    const float M_22_Jzz_delta = M_12_Jxz_delta * M_12_Jxz_delta;
    const float Jxx_delta_rF = t3 + t3;
    const float py_delta_mF = p->rF * hx_delta_Jxx_delta;
    const float t353 = p->c * M_12_Jxz_delta;
    const float t354 = M_22_mA + py_delta_mF;
    const float K0_12_mF = t353 - t354;
    const float M_12_rF = p->mF * (py_delta_mF - K0_12_mF);
    const float M_22_rF = (M_delta_delta_Jxx_delta * Jxx_delta_rF) - (t31 * (M_22_Jxz_delta -
        (C1_22_Jxz_delta * Jzz_all_Sx_delta)));
    const float t363 = p->mF * t182;
    const float Jxx_delta_mF = p->rF * p->rF;
    const float t365 = p->IFyy / Jxx_delta_mF;
    const float C1_21_rF = M_12_Jxz_delta * t365;
    const float C1_12_rF = t363 - C1_21_rF;
    const float C1_22_rF = hx_delta_Jxx_delta * t363;
    const float py_delta_rF = p->mF * hx_delta_Jxx_delta;
    const float t370 = p->mF * M_delta_delta_Jxx_delta;
    const float K2_12_rF = yaw_per_v_delta * (p->mF - t365);
    const float K2_22_rF = hx_delta_Jxx_delta * K2_12_rF;
    const float t374 = p->rF * K0_12_mF;
    const float M_22_mF = t338 + (p->c * ((p->c * M_22_Jzz_delta) - M_22_Sx_delta)) - (py_delta_mF *
        (t353 + K0_12_mF - M_22_mA));
    const float C1_12_mF = p->rF * t182;
    const float t385 = yaw_per_v_delta * K0_12_mF;
    const float C1_22_mF = (C1_22_py_delta * t354) - (p->c * (t187 - t385));
    const float K0_22_mF = hx_delta_Jxx_delta * K0_12_mF;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float M_22_IFxx = M_delta_delta_Jxx_delta + M_22_Jzz_delta;
    const float C1_12_IFyy = SF_IFyy * M_12_Jxz_delta;
    const float K2_12_IFyy = yaw_per_v_delta * SF_IFyy;
    const float K2_22_IFyy = SF_IFyy * C1_22_Jxz_delta;
    const float C0_21 = -C0_12;
    const float C1_21 = -(t106 + (mu * ST));
    const float C1_22 = -(yaw_per_v_delta * (t91 - (p->c * P_delta_lateral)));
    const float K0_11 = t113 - t50;
    const float K0_12 = -P_delta_lateral;
    const float K0_22 = -(hx_delta_Jxx_delta * P_delta_lateral);
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
    derivatives->values[0] = M_12_w;
    derivatives->values[1] = M_22_w;
    derivatives->values[2] = C0_21_w;
    derivatives->values[3] = C1_12_w;
    derivatives->values[4] = C1_21_w;
    derivatives->values[5] = C1_22_w;
    derivatives->values[6] = K0_12_w;
    derivatives->values[7] = K0_22_w;
    derivatives->values[8] = t208;
    derivatives->values[9] = t210;
    derivatives->values[10] = t211;
    derivatives->values[11] = t214;
    derivatives->values[12] = t217;
    derivatives->values[13] = M_22_c;
    derivatives->values[14] = K1_12;
    derivatives->values[15] = K2_12;
    derivatives->values[16] = t227;
    derivatives->values[17] = C1_22_c;
    derivatives->values[18] = K0_12_c;
    derivatives->values[19] = K0_22_c;
    derivatives->values[20] = t238;
    derivatives->values[21] = M_12_lam;
    derivatives->values[22] = M_22_lam;
    derivatives->values[23] = C0_21_lam;
    derivatives->values[24] = t264;
    derivatives->values[25] = C1_21_lam;
    derivatives->values[26] = C1_22_lam;
    derivatives->values[27] = K0_12_lam;
    derivatives->values[28] = K0_22_lam;
    derivatives->values[29] = t260;
    derivatives->values[30] = K1_22_lam;
    derivatives->values[31] = t280;
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
    derivatives->values[43] = M_22_Jzz_all;
    derivatives->values[44] = C1_22_Jzz_all;
    derivatives->values[45] = C1_12_IRyy;
    derivatives->values[46] = K2_12_IRyy;
    derivatives->values[47] = t297;
    derivatives->values[48] = M_22_xB;
    derivatives->values[49] = t296;
    derivatives->values[50] = C1_22_xB;
    derivatives->values[51] = t299;
    derivatives->values[52] = t307;
    derivatives->values[53] = K2_22_xB;
    derivatives->values[54] = M_11_zB;
    derivatives->values[55] = t310;
    derivatives->values[56] = t311;
    derivatives->values[57] = p->mB;
    derivatives->values[58] = t298;
    derivatives->values[59] = M_11_mB;
    derivatives->values[60] = t312;
    derivatives->values[61] = M_22_mB;
    derivatives->values[62] = t314;
    derivatives->values[63] = C1_22_mB;
    derivatives->values[64] = p->zB;
    derivatives->values[65] = t301;
    derivatives->values[66] = t318;
    derivatives->values[67] = t319;
    derivatives->values[68] = K2_22_mB;
    derivatives->values[69] = mu;
    derivatives->values[70] = yaw_per_v_delta;
    derivatives->values[71] = t141;
    derivatives->values[72] = M_22_xH;
    derivatives->values[73] = t321;
    derivatives->values[74] = C1_22_xH;
    derivatives->values[75] = t140;
    derivatives->values[76] = t323;
    derivatives->values[77] = K2_22_xH;
    derivatives->values[78] = Jxx_delta_zH;
    derivatives->values[79] = M_12_zH;
    derivatives->values[80] = t330;
    derivatives->values[81] = t332;
    derivatives->values[82] = t333;
    derivatives->values[83] = p->mH;
    derivatives->values[84] = K0_12_zH;
    derivatives->values[85] = K0_22_zH;
    derivatives->values[86] = t320;
    derivatives->values[87] = t335;
    derivatives->values[88] = Jxx_delta_mH;
    derivatives->values[89] = t337;
    derivatives->values[90] = M_22_mH;
    derivatives->values[91] = t345;
    derivatives->values[92] = C1_22_mH;
    derivatives->values[93] = p->zH;
    derivatives->values[94] = t191;
    derivatives->values[95] = t328;
    derivatives->values[96] = t344;
    derivatives->values[97] = K2_22_mH;
    derivatives->values[98] = hx_delta_Jxx_delta;
    derivatives->values[99] = M_delta_delta_Jxx_delta;
    derivatives->values[100] = M_22_Jzz_delta;
    derivatives->values[101] = K2_22_Sx_delta;
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
    derivatives->values[112] = py_delta_rF;
    derivatives->values[113] = t370;
    derivatives->values[114] = K2_12_rF;
    derivatives->values[115] = K2_22_rF;
    derivatives->values[116] = Jxx_delta_mF;
    derivatives->values[117] = t374;
    derivatives->values[118] = M_22_mF;
    derivatives->values[119] = C1_12_mF;
    derivatives->values[120] = C1_22_mF;
    derivatives->values[121] = p->rF;
    derivatives->values[122] = K0_12_mF;
    derivatives->values[123] = K0_22_mF;
    derivatives->values[124] = K2_12_mF;
    derivatives->values[125] = t385;
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
