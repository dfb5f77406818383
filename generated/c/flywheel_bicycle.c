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
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 3U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 4U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 5U, true},
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
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 21U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 21U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 22U, true},
    {CARVALLO_MATRIX_C0, 0U, 1U, 2U, 23U, true},
    {CARVALLO_MATRIX_C0, 1U, 0U, 2U, 23U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 24U, true},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 25U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 26U, false},
    {CARVALLO_MATRIX_K0, 0U, 1U, 2U, 27U, false},
    {CARVALLO_MATRIX_K0, 1U, 0U, 2U, 27U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 28U, false},
    {CARVALLO_MATRIX_K1, 0U, 1U, 2U, 29U, true},
    {CARVALLO_MATRIX_K1, 1U, 1U, 2U, 30U, true},
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
    {CARVALLO_MATRIX_C1, 0U, 1U, 16U, 81U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 16U, 82U, true},
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
    {CARVALLO_MATRIX_C1, 0U, 1U, 17U, 91U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 92U, true},
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
    {CARVALLO_MATRIX_K0, 0U, 1U, 23U, 122U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 23U, 122U, true},
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
    const double t4 = p->rF * p->mF;
    const double t7 = p->IHxx + p->IFxx + (p->rF * t4);
    const double t10 = p->zB * p->mB;
    const double M_22_mu = p->zB * t10;
    const double t14 = p->rR * p->mR;
    const double M_11_mH = p->zH * p->zH;
    const double M_11 = t7 + M_22_mu + (p->rR * t14) + p->IBxx + p->IRxx + (p->mH * M_11_mH);
    double wx_delta2_delta = 0.0;
    double wx_delta2_delta_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const double t31 = 1.0 / p->w;
    const double yaw_per_v_delta = wx_delta2_delta_lam * t31;
    const double mu = p->c * yaw_per_v_delta;
    const double ay_delta2_delta = t10 * p->xB;
    const double t37 = p->IBxz - ay_delta2_delta;
    const double wz_delta2_delta = wx_delta2_delta_lam + mu;
    const double t44 = (p->IHxz * wz_delta2_delta) + (t7 * wx_delta2_delta);
    const double t45 = p->zH * wx_delta2_delta;
    const double t47 = p->c * t31;
    const double t51 = p->xH + (p->xH * t47) - p->c - p->w;
    const double K0_12_mH = t45 - (wx_delta2_delta_lam * t51);
    const double M_12_mH = p->zH * K0_12_mH;
    const double t56 = t44 + (p->mH * M_12_mH);
    const double M_12 = (mu * t37) + t56;
    const double M_22_mH = K0_12_mH * K0_12_mH;
    const double t62 = p->mB * p->xB;
    const double t66 = yaw_per_v_delta * (p->IRxx + p->IBzz + (p->xB * t62));
    const double t67 = p->c * t66;
    const double t69 = p->IHxz * wx_delta2_delta;
    const double t71 = p->IFxx + p->IHzz;
    const double t73 = t69 + (wz_delta2_delta * t71);
    const double M_22 = (wx_delta2_delta * t44) + (p->mH * M_22_mH) + (mu * t67) +
        (wz_delta2_delta * t73);
    const double t81 = p->hH + p->hB;
    const double t83 = p->hH + (t47 * t81);
    const double C0_12 = wx_delta2_delta_lam * t83;
    const double t86 = 1.0 / p->rF;
    const double SF = p->IFyy * t86;
    const double t88 = p->mH * p->zH;
    const double K0_11 = t10 + t88 - t4 - t14;
    const double t93 = 1.0 / p->rR;
    const double SR = p->IRyy * t93;
    const double t95 = SF + SR;
    const double t96 = t95 - K0_11;
    const double M_12_mu = t37 + p->IHxz;
    const double t100 = (p->xH * t88) - M_12_mu;
    const double t102 = t31 * ((p->c * t96) - t100);
    const double t104 = t4 + SF + t102;
    const double C1_12 = wx_delta2_delta_lam * t104;
    const double t106 = wx_delta2_delta_lam * SF;
    const double t109 = t67 + t73;
    const double t110 = p->mH * K0_12_mH;
    const double t111 = p->mB * mu;
    const double t112 = p->xB * t111;
    const double t113 = t112 - t110;
    const double t117 = t109 + (p->c * t113) - (p->xH * t110);
    const double t119 = p->mF * wx_delta2_delta;
    const double t120 = p->rF * t119;
    const double M_22_wz_delta2_delta = wz_delta2_delta * t120;
    const double C1_22 = (yaw_per_v_delta * t117) + M_22_wz_delta2_delta;
    const double t123 = t113 + t120;
    const double K1_12 = yaw_per_v_delta * t81;
    const double t126 = t31 * wx_delta2_delta;
    const double K2_22_SF = wx_delta2_delta_lam * t126;
    const double K1_22 = p->hH * K2_22_SF;
    const double K2_12 = yaw_per_v_delta * t96;
    const double t130 = wx_delta2_delta * SF;
    const double K2_22_yaw_per_v_delta = t123 + t130;
    const double K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
    const double t133 = wx_delta2_delta_lam * t88;
    const double t134 = yaw_per_v_delta * t100;
    const double M_12_w = t133 + (t47 * t134);
    const double t137 = yaw_per_v_delta * p->xH;
    const double t139 = wx_delta2_delta_lam + (t47 * t137);
    const double t140 = t110 + t110;
    const double t142 = yaw_per_v_delta * t109;
    const double t143 = t142 + t142;
    const double M_22_w = (t139 * t140) - (t47 * t143);
    const double C0_21_w = t47 * K1_12;
    const double t147 = yaw_per_v_delta * t102;
    const double t148 = yaw_per_v_delta * t95;
    const double C1_21_w = t47 * t148;
    const double t151 = t120 + (yaw_per_v_delta * t71);
    const double C1_22_mu = t66 + t112 + t151;
    const double ay_delta2_delta_mu = t117 + (p->c * C1_22_mu);
    const double t156 = t31 * ay_delta2_delta_mu;
    const double t157 = p->c + p->xH;
    const double t158 = p->mH * t139;
    const double t161 = yaw_per_v_delta * (t156 + (t157 * t158));
    const double K0_12_w = t158 + (t31 * t112);
    const double K0_22_w = wx_delta2_delta * K0_12_w;
    const double t165 = t31 * K1_12;
    const double t166 = t31 * K1_22;
    const double t167 = t31 * K2_12;
    const double t170 = t31 * (K2_22 + (wx_delta2_delta_lam * K0_12_w));
    const double M_12_c = t133 - t134;
    const double t172 = wx_delta2_delta_lam - t137;
    const double M_22_c = t143 + (t140 * t172);
    const double t175 = p->mH * t172;
    const double C1_22_c = yaw_per_v_delta * (t113 + C1_22_mu - (t157 * t175));
    const double t180 = yaw_per_v_delta * t62;
    const double K0_12_c = t175 - t180;
    const double t184 = wx_delta2_delta * t47;
    const double K0_12_zH = p->mH * wx_delta2_delta;
    const double t189 = t133 + (t51 * K0_12_zH);
    const double t193 = t69 + (M_12_mu * t184) - (t7 * wx_delta2_delta_lam) - (p->zH * t189);
    const double t200 = (wx_delta2_delta * (t73 + (t47 * t109) - (t51 * t110))) -
        (wx_delta2_delta_lam * t56);
    const double t201 = t200 + t200;
    const double C0_21_lam = wx_delta2_delta * t83;
    const double t203 = wx_delta2_delta * t104;
    const double C1_21_lam = t130 + (t95 * t184);
    const double t206 = t4 * wx_delta2_delta_lam;
    const double ay_delta2_delta_xB = wx_delta2_delta_lam * yaw_per_v_delta;
    const double t212 = mu + t137;
    const double C1_22_lam = (wz_delta2_delta * t206) + (p->IHxz * ay_delta2_delta_xB) -
        (wx_delta2_delta * (t151 + t156)) - (t189 * t212);
    const double K0_12_lam = t189 + (t62 * t184) - t206;
    const double K0_22_lam = (wx_delta2_delta * K0_12_lam) - (wx_delta2_delta_lam * t123);
    const double t223 = t81 * t126;
    const double t226 = p->hH * ((wx_delta2_delta * t126) - ay_delta2_delta_xB);
    const double t227 = t96 * t126;
    const double K2_22_lam = (yaw_per_v_delta * (t106 - K0_12_lam)) - (t126 *
        K2_22_yaw_per_v_delta);
    const double M_11_rR = t14 + t14;
    const double K2_12_IRyy = yaw_per_v_delta * t93;
    const double K2_12_rR = (p->mR * yaw_per_v_delta) - (SR * K2_12_IRyy);
    const double C1_12_rR = p->c * K2_12_rR;
    const double C1_12_IRyy = p->c * K2_12_IRyy;
    const double C1_21_rR = SR * C1_12_IRyy;
    const double M_11_mR = p->rR * p->rR;
    const double C1_12_mR = p->rR * mu;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double C1_22_IRxx = yaw_per_v_delta * mu;
    const double M_22_IRxx = p->c * C1_22_IRxx;
    const double t246 = t10 * mu;
    const double t247 = t62 * M_22_IRxx;
    const double M_22_xB = t247 + t247;
    const double t249 = t10 * yaw_per_v_delta;
    const double K2_22_xB = yaw_per_v_delta * t111;
    const double t251 = p->c + p->xB;
    const double C1_22_xB = K2_22_xB * (p->xB + t251);
    const double t254 = wx_delta2_delta * t111;
    const double M_11_zB = t10 + t10;
    const double t256 = t111 + t180;
    const double t257 = p->mB * yaw_per_v_delta;
    const double M_11_mB = p->zB * p->zB;
    const double t259 = mu * p->xB;
    const double t260 = p->zB * t259;
    const double M_22_mB = t259 * t259;
    const double t262 = p->zB * yaw_per_v_delta;
    const double t263 = t251 * t262;
    const double K2_22_mB = p->xB * C1_22_IRxx;
    const double C1_22_mB = t251 * K2_22_mB;
    const double t266 = wx_delta2_delta * t259;
    const double t267 = p->mH * wz_delta2_delta;
    const double t268 = p->zH * t267;
    const double t269 = wz_delta2_delta * t110;
    const double t270 = t269 + t269;
    const double t271 = p->zH * yaw_per_v_delta;
    const double t272 = p->mH * t271;
    const double C1_22_IHzz = ay_delta2_delta_xB + C1_22_IRxx;
    const double t275 = yaw_per_v_delta * K0_12_mH;
    const double C1_22_xH = p->mH * ((t157 * C1_22_IHzz) - t275);
    const double t278 = wx_delta2_delta * t267;
    const double K2_22_xH = p->mH * C1_22_IHzz;
    const double M_11_zH = t88 + t88;
    const double M_12_zH = t110 + (p->mH * t45);
    const double M_22_zH = wx_delta2_delta * t140;
    const double t284 = p->mH * t212;
    const double t285 = K0_12_zH * t212;
    const double M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const double K0_22_zH = p->mH * M_22_IHxx;
    const double t288 = p->mH * yaw_per_v_delta;
    const double t289 = wx_delta2_delta * t288;
    const double t290 = t157 * t271;
    const double t291 = K0_12_mH * t212;
    const double K0_22_mH = wx_delta2_delta * K0_12_mH;
    const double M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const double t294 = wz_delta2_delta * wx_delta2_delta;
    const double M_22_IHxz = t294 + t294;
    const double M_11_rF = t4 + t4;
    const double M_12_rF = t120 + t120;
    const double t298 = wx_delta2_delta * t120;
    const double M_22_rF = t298 + t298;
    const double t301 = p->mF - (t86 * SF);
    const double C1_12_rF = wz_delta2_delta * t301;
    const double C1_12_IFyy = wz_delta2_delta * t86;
    const double C1_21_rF = SF * C1_12_IFyy;
    const double C1_22_rF = wz_delta2_delta * t119;
    const double t306 = wx_delta2_delta * t119;
    const double K2_12_rF = yaw_per_v_delta * t301;
    const double K2_22_rF = K2_22_SF * t301;
    const double M_11_mF = p->rF * p->rF;
    const double M_12_mF = wx_delta2_delta * M_11_mF;
    const double M_22_mF = M_22_IHxx * M_11_mF;
    const double C1_12_mF = p->rF * wz_delta2_delta;
    const double C1_22_mF = p->rF * t294;
    const double t314 = p->rF * wx_delta2_delta;
    const double t315 = wx_delta2_delta * t314;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double K2_22_mF = p->rF * K2_22_SF;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double K2_12_IFyy = yaw_per_v_delta * t86;
    const double K2_22_IFyy = t86 * K2_22_SF;
    const double C0_21 = -C0_12;
    const double C1_21 = -(t106 + (mu * t95));
    const double K0_12 = -t123;
    const double K0_22 = -(wx_delta2_delta * t123);
    const double t325 = -(wx_delta2_delta * K0_12_c);
    const double K2_22_c = -(yaw_per_v_delta * K0_12_c);
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
    derivatives->values[3] = t147;
    derivatives->values[4] = C1_21_w;
    derivatives->values[5] = t161;
    derivatives->values[6] = K0_12_w;
    derivatives->values[7] = K0_22_w;
    derivatives->values[8] = t165;
    derivatives->values[9] = t166;
    derivatives->values[10] = t167;
    derivatives->values[11] = t170;
    derivatives->values[12] = M_12_c;
    derivatives->values[13] = M_22_c;
    derivatives->values[14] = K1_12;
    derivatives->values[15] = K2_12;
    derivatives->values[16] = t148;
    derivatives->values[17] = C1_22_c;
    derivatives->values[18] = K0_12_c;
    derivatives->values[19] = t325;
    derivatives->values[20] = K2_22_c;
    derivatives->values[21] = t193;
    derivatives->values[22] = t201;
    derivatives->values[23] = C0_21_lam;
    derivatives->values[24] = t203;
    derivatives->values[25] = C1_21_lam;
    derivatives->values[26] = C1_22_lam;
    derivatives->values[27] = K0_12_lam;
    derivatives->values[28] = K0_22_lam;
    derivatives->values[29] = t223;
    derivatives->values[30] = t226;
    derivatives->values[31] = t227;
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
    derivatives->values[47] = t246;
    derivatives->values[48] = M_22_xB;
    derivatives->values[49] = t249;
    derivatives->values[50] = C1_22_xB;
    derivatives->values[51] = t111;
    derivatives->values[52] = t254;
    derivatives->values[53] = K2_22_xB;
    derivatives->values[54] = M_11_zB;
    derivatives->values[55] = t112;
    derivatives->values[56] = t256;
    derivatives->values[57] = p->mB;
    derivatives->values[58] = t257;
    derivatives->values[59] = M_11_mB;
    derivatives->values[60] = t260;
    derivatives->values[61] = M_22_mB;
    derivatives->values[62] = t263;
    derivatives->values[63] = C1_22_mB;
    derivatives->values[64] = p->zB;
    derivatives->values[65] = t259;
    derivatives->values[66] = t266;
    derivatives->values[67] = t262;
    derivatives->values[68] = K2_22_mB;
    derivatives->values[69] = mu;
    derivatives->values[70] = yaw_per_v_delta;
    derivatives->values[71] = t268;
    derivatives->values[72] = t270;
    derivatives->values[73] = t272;
    derivatives->values[74] = C1_22_xH;
    derivatives->values[75] = t267;
    derivatives->values[76] = t278;
    derivatives->values[77] = K2_22_xH;
    derivatives->values[78] = M_11_zH;
    derivatives->values[79] = M_12_zH;
    derivatives->values[80] = M_22_zH;
    derivatives->values[81] = t284;
    derivatives->values[82] = t285;
    derivatives->values[83] = p->mH;
    derivatives->values[84] = K0_12_zH;
    derivatives->values[85] = K0_22_zH;
    derivatives->values[86] = t288;
    derivatives->values[87] = t289;
    derivatives->values[88] = M_11_mH;
    derivatives->values[89] = M_12_mH;
    derivatives->values[90] = M_22_mH;
    derivatives->values[91] = t290;
    derivatives->values[92] = t291;
    derivatives->values[93] = p->zH;
    derivatives->values[94] = K0_12_mH;
    derivatives->values[95] = K0_22_mH;
    derivatives->values[96] = t271;
    derivatives->values[97] = t275;
    derivatives->values[98] = wx_delta2_delta;
    derivatives->values[99] = M_22_IHxx;
    derivatives->values[100] = M_22_IHzz;
    derivatives->values[101] = C1_22_IHzz;
    derivatives->values[102] = wz_delta2_delta;
    derivatives->values[103] = M_22_IHxz;
    derivatives->values[104] = K2_22_SF;
    derivatives->values[105] = M_11_rF;
    derivatives->values[106] = M_12_rF;
    derivatives->values[107] = M_22_rF;
    derivatives->values[108] = C1_12_rF;
    derivatives->values[109] = C1_21_rF;
    derivatives->values[110] = C1_22_rF;
    derivatives->values[111] = p->mF;
    derivatives->values[112] = t119;
    derivatives->values[113] = t306;
    derivatives->values[114] = K2_12_rF;
    derivatives->values[115] = K2_22_rF;
    derivatives->values[116] = M_11_mF;
    derivatives->values[117] = M_12_mF;
    derivatives->values[118] = M_22_mF;
    derivatives->values[119] = C1_12_mF;
    derivatives->values[120] = C1_22_mF;
    derivatives->values[121] = p->rF;
    derivatives->values[122] = t314;
    derivatives->values[123] = t315;
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
    const float t4 = p->rF * p->mF;
    const float t7 = p->IHxx + p->IFxx + (p->rF * t4);
    const float t10 = p->zB * p->mB;
    const float M_22_mu = p->zB * t10;
    const float t14 = p->rR * p->mR;
    const float M_11_mH = p->zH * p->zH;
    const float M_11 = t7 + M_22_mu + (p->rR * t14) + p->IBxx + p->IRxx + (p->mH * M_11_mH);
    float wx_delta2_delta = 0.0F;
    float wx_delta2_delta_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const float t31 = 1.0F / p->w;
    const float yaw_per_v_delta = wx_delta2_delta_lam * t31;
    const float mu = p->c * yaw_per_v_delta;
    const float ay_delta2_delta = t10 * p->xB;
    const float t37 = p->IBxz - ay_delta2_delta;
    const float wz_delta2_delta = wx_delta2_delta_lam + mu;
    const float t44 = (p->IHxz * wz_delta2_delta) + (t7 * wx_delta2_delta);
    const float t45 = p->zH * wx_delta2_delta;
    const float t47 = p->c * t31;
    const float t51 = p->xH + (p->xH * t47) - p->c - p->w;
    const float K0_12_mH = t45 - (wx_delta2_delta_lam * t51);
    const float M_12_mH = p->zH * K0_12_mH;
    const float t56 = t44 + (p->mH * M_12_mH);
    const float M_12 = (mu * t37) + t56;
    const float M_22_mH = K0_12_mH * K0_12_mH;
    const float t62 = p->mB * p->xB;
    const float t66 = yaw_per_v_delta * (p->IRxx + p->IBzz + (p->xB * t62));
    const float t67 = p->c * t66;
    const float t69 = p->IHxz * wx_delta2_delta;
    const float t71 = p->IFxx + p->IHzz;
    const float t73 = t69 + (wz_delta2_delta * t71);
    const float M_22 = (wx_delta2_delta * t44) + (p->mH * M_22_mH) + (mu * t67) + (wz_delta2_delta *
        t73);
    const float t81 = p->hH + p->hB;
    const float t83 = p->hH + (t47 * t81);
    const float C0_12 = wx_delta2_delta_lam * t83;
    const float t86 = 1.0F / p->rF;
    const float SF = p->IFyy * t86;
    const float t88 = p->mH * p->zH;
    const float K0_11 = t10 + t88 - t4 - t14;
    const float t93 = 1.0F / p->rR;
    const float SR = p->IRyy * t93;
    const float t95 = SF + SR;
    const float t96 = t95 - K0_11;
    const float M_12_mu = t37 + p->IHxz;
    const float t100 = (p->xH * t88) - M_12_mu;
    const float t102 = t31 * ((p->c * t96) - t100);
    const float t104 = t4 + SF + t102;
    const float C1_12 = wx_delta2_delta_lam * t104;
    const float t106 = wx_delta2_delta_lam * SF;
    const float t109 = t67 + t73;
    const float t110 = p->mH * K0_12_mH;
    const float t111 = p->mB * mu;
    const float t112 = p->xB * t111;
    const float t113 = t112 - t110;
    const float t117 = t109 + (p->c * t113) - (p->xH * t110);
    const float t119 = p->mF * wx_delta2_delta;
    const float t120 = p->rF * t119;
    const float M_22_wz_delta2_delta = wz_delta2_delta * t120;
    const float C1_22 = (yaw_per_v_delta * t117) + M_22_wz_delta2_delta;
    const float t123 = t113 + t120;
    const float K1_12 = yaw_per_v_delta * t81;
    const float t126 = t31 * wx_delta2_delta;
    const float K2_22_SF = wx_delta2_delta_lam * t126;
    const float K1_22 = p->hH * K2_22_SF;
    const float K2_12 = yaw_per_v_delta * t96;
    const float t130 = wx_delta2_delta * SF;
    const float K2_22_yaw_per_v_delta = t123 + t130;
    const float K2_22 = yaw_per_v_delta * K2_22_yaw_per_v_delta;
    const float t133 = wx_delta2_delta_lam * t88;
    const float t134 = yaw_per_v_delta * t100;
    const float M_12_w = t133 + (t47 * t134);
    const float t137 = yaw_per_v_delta * p->xH;
    const float t139 = wx_delta2_delta_lam + (t47 * t137);
    const float t140 = t110 + t110;
    const float t142 = yaw_per_v_delta * t109;
    const float t143 = t142 + t142;
    const float M_22_w = (t139 * t140) - (t47 * t143);
    const float C0_21_w = t47 * K1_12;
    const float t147 = yaw_per_v_delta * t102;
    const float t148 = yaw_per_v_delta * t95;
    const float C1_21_w = t47 * t148;
    const float t151 = t120 + (yaw_per_v_delta * t71);
    const float C1_22_mu = t66 + t112 + t151;
    const float ay_delta2_delta_mu = t117 + (p->c * C1_22_mu);
    const float t156 = t31 * ay_delta2_delta_mu;
    const float t157 = p->c + p->xH;
    const float t158 = p->mH * t139;
    const float t161 = yaw_per_v_delta * (t156 + (t157 * t158));
    const float K0_12_w = t158 + (t31 * t112);
    const float K0_22_w = wx_delta2_delta * K0_12_w;
    const float t165 = t31 * K1_12;
    const float t166 = t31 * K1_22;
    const float t167 = t31 * K2_12;
    const float t170 = t31 * (K2_22 + (wx_delta2_delta_lam * K0_12_w));
    const float M_12_c = t133 - t134;
    const float t172 = wx_delta2_delta_lam - t137;
    const float M_22_c = t143 + (t140 * t172);
    const float t175 = p->mH * t172;
    const float C1_22_c = yaw_per_v_delta * (t113 + C1_22_mu - (t157 * t175));
    const float t180 = yaw_per_v_delta * t62;
    const float K0_12_c = t175 - t180;
    const float t184 = wx_delta2_delta * t47;
    const float K0_12_zH = p->mH * wx_delta2_delta;
    const float t189 = t133 + (t51 * K0_12_zH);
    const float t193 = t69 + (M_12_mu * t184) - (t7 * wx_delta2_delta_lam) - (p->zH * t189);
    const float t200 = (wx_delta2_delta * (t73 + (t47 * t109) - (t51 * t110))) -
        (wx_delta2_delta_lam * t56);
    const float t201 = t200 + t200;
    const float C0_21_lam = wx_delta2_delta * t83;
    const float t203 = wx_delta2_delta * t104;
    const float C1_21_lam = t130 + (t95 * t184);
    const float t206 = t4 * wx_delta2_delta_lam;
    const float ay_delta2_delta_xB = wx_delta2_delta_lam * yaw_per_v_delta;
    const float t212 = mu + t137;
    const float C1_22_lam = (wz_delta2_delta * t206) + (p->IHxz * ay_delta2_delta_xB) -
        (wx_delta2_delta * (t151 + t156)) - (t189 * t212);
    const float K0_12_lam = t189 + (t62 * t184) - t206;
    const float K0_22_lam = (wx_delta2_delta * K0_12_lam) - (wx_delta2_delta_lam * t123);
    const float t223 = t81 * t126;
    const float t226 = p->hH * ((wx_delta2_delta * t126) - ay_delta2_delta_xB);
    const float t227 = t96 * t126;
    const float K2_22_lam = (yaw_per_v_delta * (t106 - K0_12_lam)) - (t126 * K2_22_yaw_per_v_delta);
    const float M_11_rR = t14 + t14;
    const float K2_12_IRyy = yaw_per_v_delta * t93;
    const float K2_12_rR = (p->mR * yaw_per_v_delta) - (SR * K2_12_IRyy);
    const float C1_12_rR = p->c * K2_12_rR;
    const float C1_12_IRyy = p->c * K2_12_IRyy;
    const float C1_21_rR = SR * C1_12_IRyy;
    const float M_11_mR = p->rR * p->rR;
    const float C1_12_mR = p->rR * mu;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float C1_22_IRxx = yaw_per_v_delta * mu;
    const float M_22_IRxx = p->c * C1_22_IRxx;
    const float t246 = t10 * mu;
    const float t247 = t62 * M_22_IRxx;
    const float M_22_xB = t247 + t247;
    const float t249 = t10 * yaw_per_v_delta;
    const float K2_22_xB = yaw_per_v_delta * t111;
    const float t251 = p->c + p->xB;
    const float C1_22_xB = K2_22_xB * (p->xB + t251);
    const float t254 = wx_delta2_delta * t111;
    const float M_11_zB = t10 + t10;
    const float t256 = t111 + t180;
    const float t257 = p->mB * yaw_per_v_delta;
    const float M_11_mB = p->zB * p->zB;
    const float t259 = mu * p->xB;
    const float t260 = p->zB * t259;
    const float M_22_mB = t259 * t259;
    const float t262 = p->zB * yaw_per_v_delta;
    const float t263 = t251 * t262;
    const float K2_22_mB = p->xB * C1_22_IRxx;
    const float C1_22_mB = t251 * K2_22_mB;
    const float t266 = wx_delta2_delta * t259;
    const float t267 = p->mH * wz_delta2_delta;
    const float t268 = p->zH * t267;
    const float t269 = wz_delta2_delta * t110;
    const float t270 = t269 + t269;
    const float t271 = p->zH * yaw_per_v_delta;
    const float t272 = p->mH * t271;
    const float C1_22_IHzz = ay_delta2_delta_xB + C1_22_IRxx;
    const float t275 = yaw_per_v_delta * K0_12_mH;
    const float C1_22_xH = p->mH * ((t157 * C1_22_IHzz) - t275);
    const float t278 = wx_delta2_delta * t267;
    const float K2_22_xH = p->mH * C1_22_IHzz;
    const float M_11_zH = t88 + t88;
    const float M_12_zH = t110 + (p->mH * t45);
    const float M_22_zH = wx_delta2_delta * t140;
    const float t284 = p->mH * t212;
    const float t285 = K0_12_zH * t212;
    const float M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const float K0_22_zH = p->mH * M_22_IHxx;
    const float t288 = p->mH * yaw_per_v_delta;
    const float t289 = wx_delta2_delta * t288;
    const float t290 = t157 * t271;
    const float t291 = K0_12_mH * t212;
    const float K0_22_mH = wx_delta2_delta * K0_12_mH;
    const float M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const float t294 = wz_delta2_delta * wx_delta2_delta;
    const float M_22_IHxz = t294 + t294;
    const float M_11_rF = t4 + t4;
    const float M_12_rF = t120 + t120;
    const float t298 = wx_delta2_delta * t120;
    const float M_22_rF = t298 + t298;
    const float t301 = p->mF - (t86 * SF);
    const float C1_12_rF = wz_delta2_delta * t301;
    const float C1_12_IFyy = wz_delta2_delta * t86;
    const float C1_21_rF = SF * C1_12_IFyy;
    const float C1_22_rF = wz_delta2_delta * t119;
    const float t306 = wx_delta2_delta * t119;
    const float K2_12_rF = yaw_per_v_delta * t301;
    const float K2_22_rF = K2_22_SF * t301;
    const float M_11_mF = p->rF * p->rF;
    const float M_12_mF = wx_delta2_delta * M_11_mF;
    const float M_22_mF = M_22_IHxx * M_11_mF;
    const float C1_12_mF = p->rF * wz_delta2_delta;
    const float C1_22_mF = p->rF * t294;
    const float t314 = p->rF * wx_delta2_delta;
    const float t315 = wx_delta2_delta * t314;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float K2_22_mF = p->rF * K2_22_SF;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float K2_12_IFyy = yaw_per_v_delta * t86;
    const float K2_22_IFyy = t86 * K2_22_SF;
    const float C0_21 = -C0_12;
    const float C1_21 = -(t106 + (mu * t95));
    const float K0_12 = -t123;
    const float K0_22 = -(wx_delta2_delta * t123);
    const float t325 = -(wx_delta2_delta * K0_12_c);
    const float K2_22_c = -(yaw_per_v_delta * K0_12_c);
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
    derivatives->values[3] = t147;
    derivatives->values[4] = C1_21_w;
    derivatives->values[5] = t161;
    derivatives->values[6] = K0_12_w;
    derivatives->values[7] = K0_22_w;
    derivatives->values[8] = t165;
    derivatives->values[9] = t166;
    derivatives->values[10] = t167;
    derivatives->values[11] = t170;
    derivatives->values[12] = M_12_c;
    derivatives->values[13] = M_22_c;
    derivatives->values[14] = K1_12;
    derivatives->values[15] = K2_12;
    derivatives->values[16] = t148;
    derivatives->values[17] = C1_22_c;
    derivatives->values[18] = K0_12_c;
    derivatives->values[19] = t325;
    derivatives->values[20] = K2_22_c;
    derivatives->values[21] = t193;
    derivatives->values[22] = t201;
    derivatives->values[23] = C0_21_lam;
    derivatives->values[24] = t203;
    derivatives->values[25] = C1_21_lam;
    derivatives->values[26] = C1_22_lam;
    derivatives->values[27] = K0_12_lam;
    derivatives->values[28] = K0_22_lam;
    derivatives->values[29] = t223;
    derivatives->values[30] = t226;
    derivatives->values[31] = t227;
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
    derivatives->values[47] = t246;
    derivatives->values[48] = M_22_xB;
    derivatives->values[49] = t249;
    derivatives->values[50] = C1_22_xB;
    derivatives->values[51] = t111;
    derivatives->values[52] = t254;
    derivatives->values[53] = K2_22_xB;
    derivatives->values[54] = M_11_zB;
    derivatives->values[55] = t112;
    derivatives->values[56] = t256;
    derivatives->values[57] = p->mB;
    derivatives->values[58] = t257;
    derivatives->values[59] = M_11_mB;
    derivatives->values[60] = t260;
    derivatives->values[61] = M_22_mB;
    derivatives->values[62] = t263;
    derivatives->values[63] = C1_22_mB;
    derivatives->values[64] = p->zB;
    derivatives->values[65] = t259;
    derivatives->values[66] = t266;
    derivatives->values[67] = t262;
    derivatives->values[68] = K2_22_mB;
    derivatives->values[69] = mu;
    derivatives->values[70] = yaw_per_v_delta;
    derivatives->values[71] = t268;
    derivatives->values[72] = t270;
    derivatives->values[73] = t272;
    derivatives->values[74] = C1_22_xH;
    derivatives->values[75] = t267;
    derivatives->values[76] = t278;
    derivatives->values[77] = K2_22_xH;
    derivatives->values[78] = M_11_zH;
    derivatives->values[79] = M_12_zH;
    derivatives->values[80] = M_22_zH;
    derivatives->values[81] = t284;
    derivatives->values[82] = t285;
    derivatives->values[83] = p->mH;
    derivatives->values[84] = K0_12_zH;
    derivatives->values[85] = K0_22_zH;
    derivatives->values[86] = t288;
    derivatives->values[87] = t289;
    derivatives->values[88] = M_11_mH;
    derivatives->values[89] = M_12_mH;
    derivatives->values[90] = M_22_mH;
    derivatives->values[91] = t290;
    derivatives->values[92] = t291;
    derivatives->values[93] = p->zH;
    derivatives->values[94] = K0_12_mH;
    derivatives->values[95] = K0_22_mH;
    derivatives->values[96] = t271;
    derivatives->values[97] = t275;
    derivatives->values[98] = wx_delta2_delta;
    derivatives->values[99] = M_22_IHxx;
    derivatives->values[100] = M_22_IHzz;
    derivatives->values[101] = C1_22_IHzz;
    derivatives->values[102] = wz_delta2_delta;
    derivatives->values[103] = M_22_IHxz;
    derivatives->values[104] = K2_22_SF;
    derivatives->values[105] = M_11_rF;
    derivatives->values[106] = M_12_rF;
    derivatives->values[107] = M_22_rF;
    derivatives->values[108] = C1_12_rF;
    derivatives->values[109] = C1_21_rF;
    derivatives->values[110] = C1_22_rF;
    derivatives->values[111] = p->mF;
    derivatives->values[112] = t119;
    derivatives->values[113] = t306;
    derivatives->values[114] = K2_12_rF;
    derivatives->values[115] = K2_22_rF;
    derivatives->values[116] = M_11_mF;
    derivatives->values[117] = M_12_mF;
    derivatives->values[118] = M_22_mF;
    derivatives->values[119] = C1_12_mF;
    derivatives->values[120] = C1_22_mF;
    derivatives->values[121] = p->rF;
    derivatives->values[122] = t314;
    derivatives->values[123] = t315;
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
