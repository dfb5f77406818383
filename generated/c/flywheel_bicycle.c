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
    const double t7 = p->rF * p->mF;
    const double t11 = p->IHxx + ((p->rF * t7) + p->IFxx);
    const double t16 = p->rR * p->mR;
    const double t22 = p->zH * p->mH;
    const double M_11 = (p->zB * t2) + t11 + (p->IBxx + (p->rR * t16) + (p->IRxx + (p->zH * t22)));
    double wx_delta2_delta = 0.0;
    double cos_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &wx_delta2_delta, &cos_lam);
    const double t31 = 1.0 / p->w;
    const double yaw_per_v_delta = cos_lam * t31;
    const double mu = p->c * yaw_per_v_delta;
    const double wz_delta2_delta = cos_lam + mu;
    const double t36 = wz_delta2_delta * p->IHxz;
    const double t39 = t36 + (t11 * wx_delta2_delta);
    const double t43 = (t2 * p->xB) - p->IBxz;
    const double t52 = (cos_lam * (p->c + p->w)) - ((p->xH * wz_delta2_delta) - (p->zH *
        wx_delta2_delta));
    const double t56 = p->mB * p->xB;
    const double t61 = mu * (p->IRxx + ((p->xB * t56) + p->IBzz));
    const double t64 = p->mH * t52;
    const double t68 = wz_delta2_delta * (p->IFxx + p->IHzz);
    const double M_22 = (wx_delta2_delta * (t36 + t39)) + (mu * t61) + ((t52 * t64) +
        (wz_delta2_delta * t68));
    const double ay_delta2_delta = cos_lam * p->hH;
    const double t76 = p->hH + p->hB;
    const double C0_12 = ay_delta2_delta + (mu * t76);
    const double t80 = t22 + (t2 - t16);
    const double SR = p->IRyy / p->rR;
    const double SF = p->IFyy / p->rF;
    const double t92 = (mu * SR) + (wz_delta2_delta * SF);
    const double t96 = (t7 * wz_delta2_delta) + (yaw_per_v_delta * p->IHxz);
    const double t100 = t64 - (mu * t56);
    const double C1_22 = ((t68 + (t61 - (p->xH * t64) - (p->c * t100))) * yaw_per_v_delta) +
        (wx_delta2_delta * t96);
    const double K0_11 = t80 - t7;
    const double K0_12 = t100 - (t7 * wx_delta2_delta);
    const double K0_22 = wx_delta2_delta * K0_12;
    const double K1_12 = yaw_per_v_delta * t76;
    const double K1_22 = t31 * (wx_delta2_delta * ay_delta2_delta);
    const double vy_all1_delta = SR - K0_11 + SF;
    const double K2_12 = yaw_per_v_delta * vy_all1_delta;
    const double K2_22 = yaw_per_v_delta * ((wx_delta2_delta * SF) - K0_12);
    const double M_12 = (t22 * t52) - ((mu * t43) - t39);
    const double C0_21 = -C0_12;
    const double C1_12 = t96 - ((yaw_per_v_delta * (t43 + (p->c * t80) + (t22 * p->xH))) - t92);
    const double C1_21 = -t92;
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
    const double t11 = p->rR * p->mR;
    const double t15 = p->zB * p->mB;
    const double t20 = p->zH * p->mH;
    const double M_11 = t7 + p->IBxx + (p->rR * t11) + (p->zB * t15) + p->IRxx + (p->zH * t20);
    double wx_delta2_delta = 0.0;
    double wx_delta2_delta_lam = 0.0;
    carvallo_sin_cos_f64(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const double t32 = 1.0 / p->w;
    const double t33 = p->c * t32;
    const double mu = wx_delta2_delta_lam * t33;
    const double wz_delta2_delta = wx_delta2_delta_lam + mu;
    const double t39 = (p->IHxz * wz_delta2_delta) + (t7 * wx_delta2_delta);
    const double t42 = p->mB * p->xB;
    const double t44 = p->IBxz - (p->zB * t42);
    const double t51 = p->c + p->w - p->xH - (t33 * p->xH);
    const double K0_12_mH = (p->zH * wx_delta2_delta) + (wx_delta2_delta_lam * t51);
    const double t54 = p->mH * K0_12_mH;
    const double M_12 = t39 + (mu * t44) + (p->zH * t54);
    const double K1_22_ay_delta2_delta = t32 * wx_delta2_delta;
    const double t59 = p->c * K1_22_ay_delta2_delta;
    const double t61 = p->IHxz * (wx_delta2_delta + t59);
    const double t63 = p->IFxx + p->IHzz;
    const double t66 = (wz_delta2_delta * t63) + (p->IHxz * wx_delta2_delta);
    const double t70 = p->IRxx + (p->xB * t42) + p->IBzz;
    const double t72 = t66 + (mu * t70);
    const double t74 = t66 + (t33 * t72);
    const double M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const double M_22 = (wx_delta2_delta_lam * (t61 + t74)) + (K0_12_mH * t54) + (t7 * M_22_IHxx);
    const double t85 = p->hH + p->hB;
    const double t87 = p->hH + (t33 * t85);
    const double C0_12 = wx_delta2_delta_lam * t87;
    const double t90 = 1.0 / p->rF;
    const double SF = p->IFyy * t90;
    const double t92 = wx_delta2_delta_lam * SF;
    const double yaw_per_v_delta = wx_delta2_delta_lam * t32;
    const double t95 = 1.0 / p->rR;
    const double SR = p->IRyy * t95;
    const double t97 = SF + SR;
    const double K0_11 = t15 + t20 - t4 - t11;
    const double vy_all1_delta = t97 - K0_11;
    const double t105 = p->IHxz + t44 - (t20 * p->xH);
    const double t106 = (p->c * vy_all1_delta) + t105;
    const double M_22_wz_delta2_delta = yaw_per_v_delta * t106;
    const double t108 = t4 * wx_delta2_delta_lam;
    const double C1_12 = t92 + M_22_wz_delta2_delta + t108;
    const double t111 = mu * t97;
    const double t113 = mu * p->xB;
    const double t114 = p->mB * t113;
    const double t115 = t54 - t114;
    const double t119 = t32 * (t72 - (p->xH * t54));
    const double t122 = wz_delta2_delta * wx_delta2_delta;
    const double C1_22 = (t4 * t122) - (wx_delta2_delta_lam * ((t33 * t115) - t119));
    const double t125 = t4 * wx_delta2_delta;
    const double K0_12 = t115 - t125;
    const double K0_22 = wx_delta2_delta * K0_12;
    const double K1_12 = t85 * yaw_per_v_delta;
    const double K2_22_SF = wx_delta2_delta_lam * K1_22_ay_delta2_delta;
    const double K1_22 = p->hH * K2_22_SF;
    const double K2_12 = yaw_per_v_delta * vy_all1_delta;
    const double t132 = wx_delta2_delta * SF;
    const double ay_delta2_delta = t125 + t132;
    const double t134 = ay_delta2_delta - t115;
    const double t135 = t32 * t134;
    const double K2_22 = wx_delta2_delta_lam * t135;
    const double t137 = p->zH * wx_delta2_delta_lam;
    const double t138 = p->mH * t137;
    const double t139 = yaw_per_v_delta * t105;
    const double M_12_w = t138 - (t33 * t139);
    const double t142 = t72 * yaw_per_v_delta;
    const double t143 = t33 * t142;
    const double t144 = p->xH * yaw_per_v_delta;
    const double t146 = wx_delta2_delta_lam + (t33 * t144);
    const double t147 = p->mH * t146;
    const double t148 = K0_12_mH + K0_12_mH;
    const double M_22_w = (t147 * t148) - t143 - t143;
    const double C0_21_w = t33 * K1_12;
    const double t153 = t32 * M_22_wz_delta2_delta;
    const double C1_21_w = t32 * t111;
    const double t155 = mu + t144;
    const double t156 = p->mH * t155;
    const double t159 = t63 * yaw_per_v_delta;
    const double t162 = t114 + (t70 * yaw_per_v_delta) + t159 - K0_12;
    const double t164 = t119 + (t33 * t162);
    const double t166 = (t146 * t156) + (yaw_per_v_delta * t164);
    const double K0_12_w = t147 + (t32 * t114);
    const double K0_22_w = wx_delta2_delta * K0_12_w;
    const double t170 = t32 * K1_12;
    const double t171 = t32 * K1_22;
    const double t172 = t32 * K2_12;
    const double t174 = yaw_per_v_delta * (t135 + K0_12_w);
    const double M_12_c = t138 + t139;
    const double t176 = wx_delta2_delta_lam - t144;
    const double t177 = p->mH * t176;
    const double C1_12_mu = t142 + (K0_12_mH * t177);
    const double M_22_c = C1_12_mu + C1_12_mu;
    const double t181 = yaw_per_v_delta * t97;
    const double C1_22_c = (yaw_per_v_delta * t162) - (t156 * t176);
    const double t185 = t42 * yaw_per_v_delta;
    const double K0_12_c = t177 - t185;
    const double K0_22_c = wx_delta2_delta * K0_12_c;
    const double t188 = yaw_per_v_delta * K0_12_c;
    const double t192 = t137 - (wx_delta2_delta * t51);
    const double t193 = p->mH * t192;
    const double M_12_lam = (t7 * wx_delta2_delta_lam) + (p->zH * t193) - t61 - (t44 * t59);
    const double t202 = (K0_12_mH * t193) + (wx_delta2_delta_lam * t39) - (wx_delta2_delta * t74);
    const double M_22_lam = t202 + t202;
    const double C0_21_lam = wx_delta2_delta * t87;
    const double t206 = ay_delta2_delta + (K1_22_ay_delta2_delta * t106);
    const double C1_21_lam = t132 + (t59 * t97);
    const double t213 = wx_delta2_delta_lam * yaw_per_v_delta;
    const double C1_22_lam = (wz_delta2_delta * t108) + (p->IHxz * t213) - (wx_delta2_delta *
        (t125 + t159 + t164)) - (t156 * t192);
    const double K0_12_lam = t193 + (t42 * t59) - t108;
    const double K0_22_lam = (wx_delta2_delta * K0_12_lam) + (wx_delta2_delta_lam * K0_12);
    const double t225 = K1_22_ay_delta2_delta * t85;
    const double t228 = p->hH * ((wx_delta2_delta * K1_22_ay_delta2_delta) - t213);
    const double t229 = K1_22_ay_delta2_delta * vy_all1_delta;
    const double K2_22_lam = (yaw_per_v_delta * (t92 - K0_12_lam)) - (K1_22_ay_delta2_delta * t134);
    const double M_11_rR = t11 + t11;
    const double t235 = t95 * SR;
    const double K2_12_rR = yaw_per_v_delta * (p->mR - t235);
    const double C1_12_rR = p->c * K2_12_rR;
    const double C1_21_rR = mu * t235;
    const double M_11_mR = p->rR * p->rR;
    const double K2_12_mR = p->rR * yaw_per_v_delta;
    const double C1_12_mR = p->c * K2_12_mR;
    const double M_22_IRxx = mu * mu;
    const double C1_22_IRxx = t33 * t213;
    const double K2_12_IRyy = yaw_per_v_delta * t95;
    const double C1_12_IRyy = p->c * K2_12_IRyy;
    const double t248 = t15 * mu;
    const double M_22_xB = t114 * (mu + mu);
    const double t251 = p->zB * yaw_per_v_delta;
    const double t252 = p->mB * t251;
    const double t253 = p->mB * yaw_per_v_delta;
    const double t254 = p->c * t253;
    const double t255 = t185 + t254;
    const double C1_22_xB = mu * (t185 + t255);
    const double t258 = wx_delta2_delta * t254;
    const double K2_22_xB = yaw_per_v_delta * t254;
    const double M_11_zB = t15 + t15;
    const double M_11_mB = p->zB * p->zB;
    const double t262 = p->zB * t113;
    const double M_22_mB = t113 * t113;
    const double t265 = mu + (p->xB * yaw_per_v_delta);
    const double t266 = p->zB * t265;
    const double C1_22_mB = t113 * t265;
    const double t268 = wx_delta2_delta * t113;
    const double K2_22_mB = p->xB * C1_22_IRxx;
    const double t270 = t20 * wz_delta2_delta;
    const double t271 = p->mH * wz_delta2_delta;
    const double t272 = t148 * t271;
    const double t273 = t20 * yaw_per_v_delta;
    const double t275 = K0_12_mH * yaw_per_v_delta;
    const double C1_22_xH = p->mH * ((wz_delta2_delta * t155) - t275);
    const double t278 = p->mH * t122;
    const double K2_22_xH = yaw_per_v_delta * t271;
    const double M_11_zH = t20 + t20;
    const double K0_12_zH = p->mH * wx_delta2_delta;
    const double M_12_zH = t54 + (p->zH * K0_12_zH);
    const double M_22_zH = wx_delta2_delta * (t54 + t54);
    const double t286 = wx_delta2_delta * t156;
    const double K0_22_zH = p->mH * M_22_IHxx;
    const double t288 = p->mH * yaw_per_v_delta;
    const double t289 = p->mH * K2_22_SF;
    const double M_11_mH = p->zH * p->zH;
    const double M_12_mH = p->zH * K0_12_mH;
    const double M_22_mH = K0_12_mH * K0_12_mH;
    const double t293 = p->zH * t155;
    const double t294 = K0_12_mH * t155;
    const double K0_22_mH = wx_delta2_delta * K0_12_mH;
    const double t296 = p->zH * yaw_per_v_delta;
    const double M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const double C1_22_IHzz = t213 + C1_22_IRxx;
    const double M_22_IHxz = t122 + t122;
    const double M_11_rF = t4 + t4;
    const double M_12_rF = t125 + t125;
    const double M_22_rF = M_22_IHxx * M_11_rF;
    const double t304 = p->mF - (t90 * SF);
    const double C1_12_rF = wz_delta2_delta * t304;
    const double C1_12_IFyy = wz_delta2_delta * t90;
    const double C1_21_rF = SF * C1_12_IFyy;
    const double t308 = p->mF * wx_delta2_delta;
    const double C1_22_rF = wz_delta2_delta * t308;
    const double t310 = wx_delta2_delta * t308;
    const double K2_12_rF = yaw_per_v_delta * t304;
    const double K2_22_rF = K2_22_SF * t304;
    const double M_11_mF = p->rF * p->rF;
    const double t314 = p->rF * wx_delta2_delta;
    const double M_12_mF = p->rF * t314;
    const double t316 = p->rF * M_22_IHxx;
    const double M_22_mF = p->rF * t316;
    const double C1_12_mF = p->rF * wz_delta2_delta;
    const double C1_22_mF = wx_delta2_delta * C1_12_mF;
    const double K2_12_mF = p->rF * yaw_per_v_delta;
    const double K2_22_mF = yaw_per_v_delta * t314;
    const double M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const double K2_12_IFyy = t90 * yaw_per_v_delta;
    const double K2_22_IFyy = t90 * K2_22_SF;
    const double C0_21 = -C0_12;
    const double C1_21 = -(t92 + t111);
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
    derivatives->values[3] = t153;
    derivatives->values[4] = C1_21_w;
    derivatives->values[5] = t166;
    derivatives->values[6] = K0_12_w;
    derivatives->values[7] = K0_22_w;
    derivatives->values[8] = t170;
    derivatives->values[9] = t171;
    derivatives->values[10] = t172;
    derivatives->values[11] = t174;
    derivatives->values[12] = M_12_c;
    derivatives->values[13] = M_22_c;
    derivatives->values[14] = K1_12;
    derivatives->values[15] = K2_12;
    derivatives->values[16] = t181;
    derivatives->values[17] = C1_22_c;
    derivatives->values[18] = K0_12_c;
    derivatives->values[19] = K0_22_c;
    derivatives->values[20] = t188;
    derivatives->values[21] = M_12_lam;
    derivatives->values[22] = M_22_lam;
    derivatives->values[23] = C0_21_lam;
    derivatives->values[24] = t206;
    derivatives->values[25] = C1_21_lam;
    derivatives->values[26] = C1_22_lam;
    derivatives->values[27] = K0_12_lam;
    derivatives->values[28] = K0_22_lam;
    derivatives->values[29] = t225;
    derivatives->values[30] = t228;
    derivatives->values[31] = t229;
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
    derivatives->values[47] = t248;
    derivatives->values[48] = M_22_xB;
    derivatives->values[49] = t252;
    derivatives->values[50] = C1_22_xB;
    derivatives->values[51] = t254;
    derivatives->values[52] = t258;
    derivatives->values[53] = K2_22_xB;
    derivatives->values[54] = M_11_zB;
    derivatives->values[55] = t114;
    derivatives->values[56] = t255;
    derivatives->values[57] = p->mB;
    derivatives->values[58] = t253;
    derivatives->values[59] = M_11_mB;
    derivatives->values[60] = t262;
    derivatives->values[61] = M_22_mB;
    derivatives->values[62] = t266;
    derivatives->values[63] = C1_22_mB;
    derivatives->values[64] = p->zB;
    derivatives->values[65] = t113;
    derivatives->values[66] = t268;
    derivatives->values[67] = t251;
    derivatives->values[68] = K2_22_mB;
    derivatives->values[69] = mu;
    derivatives->values[70] = yaw_per_v_delta;
    derivatives->values[71] = t270;
    derivatives->values[72] = t272;
    derivatives->values[73] = t273;
    derivatives->values[74] = C1_22_xH;
    derivatives->values[75] = t271;
    derivatives->values[76] = t278;
    derivatives->values[77] = K2_22_xH;
    derivatives->values[78] = M_11_zH;
    derivatives->values[79] = M_12_zH;
    derivatives->values[80] = M_22_zH;
    derivatives->values[81] = t156;
    derivatives->values[82] = t286;
    derivatives->values[83] = p->mH;
    derivatives->values[84] = K0_12_zH;
    derivatives->values[85] = K0_22_zH;
    derivatives->values[86] = t288;
    derivatives->values[87] = t289;
    derivatives->values[88] = M_11_mH;
    derivatives->values[89] = M_12_mH;
    derivatives->values[90] = M_22_mH;
    derivatives->values[91] = t293;
    derivatives->values[92] = t294;
    derivatives->values[93] = p->zH;
    derivatives->values[94] = K0_12_mH;
    derivatives->values[95] = K0_22_mH;
    derivatives->values[96] = t296;
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
    derivatives->values[112] = t308;
    derivatives->values[113] = t310;
    derivatives->values[114] = K2_12_rF;
    derivatives->values[115] = K2_22_rF;
    derivatives->values[116] = M_11_mF;
    derivatives->values[117] = M_12_mF;
    derivatives->values[118] = M_22_mF;
    derivatives->values[119] = C1_12_mF;
    derivatives->values[120] = C1_22_mF;
    derivatives->values[121] = p->rF;
    derivatives->values[122] = t314;
    derivatives->values[123] = t316;
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
    const float t7 = p->rF * p->mF;
    const float t11 = p->IHxx + ((p->rF * t7) + p->IFxx);
    const float t16 = p->rR * p->mR;
    const float t22 = p->zH * p->mH;
    const float M_11 = (p->zB * t2) + t11 + (p->IBxx + (p->rR * t16) + (p->IRxx + (p->zH * t22)));
    float wx_delta2_delta = 0.0F;
    float cos_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &wx_delta2_delta, &cos_lam);
    const float t31 = 1.0F / p->w;
    const float yaw_per_v_delta = cos_lam * t31;
    const float mu = p->c * yaw_per_v_delta;
    const float wz_delta2_delta = cos_lam + mu;
    const float t36 = wz_delta2_delta * p->IHxz;
    const float t39 = t36 + (t11 * wx_delta2_delta);
    const float t43 = (t2 * p->xB) - p->IBxz;
    const float t52 = (cos_lam * (p->c + p->w)) - ((p->xH * wz_delta2_delta) - (p->zH *
        wx_delta2_delta));
    const float t56 = p->mB * p->xB;
    const float t61 = mu * (p->IRxx + ((p->xB * t56) + p->IBzz));
    const float t64 = p->mH * t52;
    const float t68 = wz_delta2_delta * (p->IFxx + p->IHzz);
    const float M_22 = (wx_delta2_delta * (t36 + t39)) + (mu * t61) + ((t52 * t64) +
        (wz_delta2_delta * t68));
    const float ay_delta2_delta = cos_lam * p->hH;
    const float t76 = p->hH + p->hB;
    const float C0_12 = ay_delta2_delta + (mu * t76);
    const float t80 = t22 + (t2 - t16);
    const float SR = p->IRyy / p->rR;
    const float SF = p->IFyy / p->rF;
    const float t92 = (mu * SR) + (wz_delta2_delta * SF);
    const float t96 = (t7 * wz_delta2_delta) + (yaw_per_v_delta * p->IHxz);
    const float t100 = t64 - (mu * t56);
    const float C1_22 = ((t68 + (t61 - (p->xH * t64) - (p->c * t100))) * yaw_per_v_delta) +
        (wx_delta2_delta * t96);
    const float K0_11 = t80 - t7;
    const float K0_12 = t100 - (t7 * wx_delta2_delta);
    const float K0_22 = wx_delta2_delta * K0_12;
    const float K1_12 = yaw_per_v_delta * t76;
    const float K1_22 = t31 * (wx_delta2_delta * ay_delta2_delta);
    const float vy_all1_delta = SR - K0_11 + SF;
    const float K2_12 = yaw_per_v_delta * vy_all1_delta;
    const float K2_22 = yaw_per_v_delta * ((wx_delta2_delta * SF) - K0_12);
    const float M_12 = (t22 * t52) - ((mu * t43) - t39);
    const float C0_21 = -C0_12;
    const float C1_12 = t96 - ((yaw_per_v_delta * (t43 + (p->c * t80) + (t22 * p->xH))) - t92);
    const float C1_21 = -t92;
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
    const float t11 = p->rR * p->mR;
    const float t15 = p->zB * p->mB;
    const float t20 = p->zH * p->mH;
    const float M_11 = t7 + p->IBxx + (p->rR * t11) + (p->zB * t15) + p->IRxx + (p->zH * t20);
    float wx_delta2_delta = 0.0F;
    float wx_delta2_delta_lam = 0.0F;
    carvallo_sin_cos_f32(p->lam, &wx_delta2_delta, &wx_delta2_delta_lam);
    const float t32 = 1.0F / p->w;
    const float t33 = p->c * t32;
    const float mu = wx_delta2_delta_lam * t33;
    const float wz_delta2_delta = wx_delta2_delta_lam + mu;
    const float t39 = (p->IHxz * wz_delta2_delta) + (t7 * wx_delta2_delta);
    const float t42 = p->mB * p->xB;
    const float t44 = p->IBxz - (p->zB * t42);
    const float t51 = p->c + p->w - p->xH - (t33 * p->xH);
    const float K0_12_mH = (p->zH * wx_delta2_delta) + (wx_delta2_delta_lam * t51);
    const float t54 = p->mH * K0_12_mH;
    const float M_12 = t39 + (mu * t44) + (p->zH * t54);
    const float K1_22_ay_delta2_delta = t32 * wx_delta2_delta;
    const float t59 = p->c * K1_22_ay_delta2_delta;
    const float t61 = p->IHxz * (wx_delta2_delta + t59);
    const float t63 = p->IFxx + p->IHzz;
    const float t66 = (wz_delta2_delta * t63) + (p->IHxz * wx_delta2_delta);
    const float t70 = p->IRxx + (p->xB * t42) + p->IBzz;
    const float t72 = t66 + (mu * t70);
    const float t74 = t66 + (t33 * t72);
    const float M_22_IHxx = wx_delta2_delta * wx_delta2_delta;
    const float M_22 = (wx_delta2_delta_lam * (t61 + t74)) + (K0_12_mH * t54) + (t7 * M_22_IHxx);
    const float t85 = p->hH + p->hB;
    const float t87 = p->hH + (t33 * t85);
    const float C0_12 = wx_delta2_delta_lam * t87;
    const float t90 = 1.0F / p->rF;
    const float SF = p->IFyy * t90;
    const float t92 = wx_delta2_delta_lam * SF;
    const float yaw_per_v_delta = wx_delta2_delta_lam * t32;
    const float t95 = 1.0F / p->rR;
    const float SR = p->IRyy * t95;
    const float t97 = SF + SR;
    const float K0_11 = t15 + t20 - t4 - t11;
    const float vy_all1_delta = t97 - K0_11;
    const float t105 = p->IHxz + t44 - (t20 * p->xH);
    const float t106 = (p->c * vy_all1_delta) + t105;
    const float M_22_wz_delta2_delta = yaw_per_v_delta * t106;
    const float t108 = t4 * wx_delta2_delta_lam;
    const float C1_12 = t92 + M_22_wz_delta2_delta + t108;
    const float t111 = mu * t97;
    const float t113 = mu * p->xB;
    const float t114 = p->mB * t113;
    const float t115 = t54 - t114;
    const float t119 = t32 * (t72 - (p->xH * t54));
    const float t122 = wz_delta2_delta * wx_delta2_delta;
    const float C1_22 = (t4 * t122) - (wx_delta2_delta_lam * ((t33 * t115) - t119));
    const float t125 = t4 * wx_delta2_delta;
    const float K0_12 = t115 - t125;
    const float K0_22 = wx_delta2_delta * K0_12;
    const float K1_12 = t85 * yaw_per_v_delta;
    const float K2_22_SF = wx_delta2_delta_lam * K1_22_ay_delta2_delta;
    const float K1_22 = p->hH * K2_22_SF;
    const float K2_12 = yaw_per_v_delta * vy_all1_delta;
    const float t132 = wx_delta2_delta * SF;
    const float ay_delta2_delta = t125 + t132;
    const float t134 = ay_delta2_delta - t115;
    const float t135 = t32 * t134;
    const float K2_22 = wx_delta2_delta_lam * t135;
    const float t137 = p->zH * wx_delta2_delta_lam;
    const float t138 = p->mH * t137;
    const float t139 = yaw_per_v_delta * t105;
    const float M_12_w = t138 - (t33 * t139);
    const float t142 = t72 * yaw_per_v_delta;
    const float t143 = t33 * t142;
    const float t144 = p->xH * yaw_per_v_delta;
    const float t146 = wx_delta2_delta_lam + (t33 * t144);
    const float t147 = p->mH * t146;
    const float t148 = K0_12_mH + K0_12_mH;
    const float M_22_w = (t147 * t148) - t143 - t143;
    const float C0_21_w = t33 * K1_12;
    const float t153 = t32 * M_22_wz_delta2_delta;
    const float C1_21_w = t32 * t111;
    const float t155 = mu + t144;
    const float t156 = p->mH * t155;
    const float t159 = t63 * yaw_per_v_delta;
    const float t162 = t114 + (t70 * yaw_per_v_delta) + t159 - K0_12;
    const float t164 = t119 + (t33 * t162);
    const float t166 = (t146 * t156) + (yaw_per_v_delta * t164);
    const float K0_12_w = t147 + (t32 * t114);
    const float K0_22_w = wx_delta2_delta * K0_12_w;
    const float t170 = t32 * K1_12;
    const float t171 = t32 * K1_22;
    const float t172 = t32 * K2_12;
    const float t174 = yaw_per_v_delta * (t135 + K0_12_w);
    const float M_12_c = t138 + t139;
    const float t176 = wx_delta2_delta_lam - t144;
    const float t177 = p->mH * t176;
    const float C1_12_mu = t142 + (K0_12_mH * t177);
    const float M_22_c = C1_12_mu + C1_12_mu;
    const float t181 = yaw_per_v_delta * t97;
    const float C1_22_c = (yaw_per_v_delta * t162) - (t156 * t176);
    const float t185 = t42 * yaw_per_v_delta;
    const float K0_12_c = t177 - t185;
    const float K0_22_c = wx_delta2_delta * K0_12_c;
    const float t188 = yaw_per_v_delta * K0_12_c;
    const float t192 = t137 - (wx_delta2_delta * t51);
    const float t193 = p->mH * t192;
    const float M_12_lam = (t7 * wx_delta2_delta_lam) + (p->zH * t193) - t61 - (t44 * t59);
    const float t202 = (K0_12_mH * t193) + (wx_delta2_delta_lam * t39) - (wx_delta2_delta * t74);
    const float M_22_lam = t202 + t202;
    const float C0_21_lam = wx_delta2_delta * t87;
    const float t206 = ay_delta2_delta + (K1_22_ay_delta2_delta * t106);
    const float C1_21_lam = t132 + (t59 * t97);
    const float t213 = wx_delta2_delta_lam * yaw_per_v_delta;
    const float C1_22_lam = (wz_delta2_delta * t108) + (p->IHxz * t213) - (wx_delta2_delta * (t125 +
        t159 + t164)) - (t156 * t192);
    const float K0_12_lam = t193 + (t42 * t59) - t108;
    const float K0_22_lam = (wx_delta2_delta * K0_12_lam) + (wx_delta2_delta_lam * K0_12);
    const float t225 = K1_22_ay_delta2_delta * t85;
    const float t228 = p->hH * ((wx_delta2_delta * K1_22_ay_delta2_delta) - t213);
    const float t229 = K1_22_ay_delta2_delta * vy_all1_delta;
    const float K2_22_lam = (yaw_per_v_delta * (t92 - K0_12_lam)) - (K1_22_ay_delta2_delta * t134);
    const float M_11_rR = t11 + t11;
    const float t235 = t95 * SR;
    const float K2_12_rR = yaw_per_v_delta * (p->mR - t235);
    const float C1_12_rR = p->c * K2_12_rR;
    const float C1_21_rR = mu * t235;
    const float M_11_mR = p->rR * p->rR;
    const float K2_12_mR = p->rR * yaw_per_v_delta;
    const float C1_12_mR = p->c * K2_12_mR;
    const float M_22_IRxx = mu * mu;
    const float C1_22_IRxx = t33 * t213;
    const float K2_12_IRyy = yaw_per_v_delta * t95;
    const float C1_12_IRyy = p->c * K2_12_IRyy;
    const float t248 = t15 * mu;
    const float M_22_xB = t114 * (mu + mu);
    const float t251 = p->zB * yaw_per_v_delta;
    const float t252 = p->mB * t251;
    const float t253 = p->mB * yaw_per_v_delta;
    const float t254 = p->c * t253;
    const float t255 = t185 + t254;
    const float C1_22_xB = mu * (t185 + t255);
    const float t258 = wx_delta2_delta * t254;
    const float K2_22_xB = yaw_per_v_delta * t254;
    const float M_11_zB = t15 + t15;
    const float M_11_mB = p->zB * p->zB;
    const float t262 = p->zB * t113;
    const float M_22_mB = t113 * t113;
    const float t265 = mu + (p->xB * yaw_per_v_delta);
    const float t266 = p->zB * t265;
    const float C1_22_mB = t113 * t265;
    const float t268 = wx_delta2_delta * t113;
    const float K2_22_mB = p->xB * C1_22_IRxx;
    const float t270 = t20 * wz_delta2_delta;
    const float t271 = p->mH * wz_delta2_delta;
    const float t272 = t148 * t271;
    const float t273 = t20 * yaw_per_v_delta;
    const float t275 = K0_12_mH * yaw_per_v_delta;
    const float C1_22_xH = p->mH * ((wz_delta2_delta * t155) - t275);
    const float t278 = p->mH * t122;
    const float K2_22_xH = yaw_per_v_delta * t271;
    const float M_11_zH = t20 + t20;
    const float K0_12_zH = p->mH * wx_delta2_delta;
    const float M_12_zH = t54 + (p->zH * K0_12_zH);
    const float M_22_zH = wx_delta2_delta * (t54 + t54);
    const float t286 = wx_delta2_delta * t156;
    const float K0_22_zH = p->mH * M_22_IHxx;
    const float t288 = p->mH * yaw_per_v_delta;
    const float t289 = p->mH * K2_22_SF;
    const float M_11_mH = p->zH * p->zH;
    const float M_12_mH = p->zH * K0_12_mH;
    const float M_22_mH = K0_12_mH * K0_12_mH;
    const float t293 = p->zH * t155;
    const float t294 = K0_12_mH * t155;
    const float K0_22_mH = wx_delta2_delta * K0_12_mH;
    const float t296 = p->zH * yaw_per_v_delta;
    const float M_22_IHzz = wz_delta2_delta * wz_delta2_delta;
    const float C1_22_IHzz = t213 + C1_22_IRxx;
    const float M_22_IHxz = t122 + t122;
    const float M_11_rF = t4 + t4;
    const float M_12_rF = t125 + t125;
    const float M_22_rF = M_22_IHxx * M_11_rF;
    const float t304 = p->mF - (t90 * SF);
    const float C1_12_rF = wz_delta2_delta * t304;
    const float C1_12_IFyy = wz_delta2_delta * t90;
    const float C1_21_rF = SF * C1_12_IFyy;
    const float t308 = p->mF * wx_delta2_delta;
    const float C1_22_rF = wz_delta2_delta * t308;
    const float t310 = wx_delta2_delta * t308;
    const float K2_12_rF = yaw_per_v_delta * t304;
    const float K2_22_rF = K2_22_SF * t304;
    const float M_11_mF = p->rF * p->rF;
    const float t314 = p->rF * wx_delta2_delta;
    const float M_12_mF = p->rF * t314;
    const float t316 = p->rF * M_22_IHxx;
    const float M_22_mF = p->rF * t316;
    const float C1_12_mF = p->rF * wz_delta2_delta;
    const float C1_22_mF = wx_delta2_delta * C1_12_mF;
    const float K2_12_mF = p->rF * yaw_per_v_delta;
    const float K2_22_mF = yaw_per_v_delta * t314;
    const float M_22_IFxx = M_22_IHxx + M_22_IHzz;
    const float K2_12_IFyy = t90 * yaw_per_v_delta;
    const float K2_22_IFyy = t90 * K2_22_SF;
    const float C0_21 = -C0_12;
    const float C1_21 = -(t92 + t111);
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
    derivatives->values[3] = t153;
    derivatives->values[4] = C1_21_w;
    derivatives->values[5] = t166;
    derivatives->values[6] = K0_12_w;
    derivatives->values[7] = K0_22_w;
    derivatives->values[8] = t170;
    derivatives->values[9] = t171;
    derivatives->values[10] = t172;
    derivatives->values[11] = t174;
    derivatives->values[12] = M_12_c;
    derivatives->values[13] = M_22_c;
    derivatives->values[14] = K1_12;
    derivatives->values[15] = K2_12;
    derivatives->values[16] = t181;
    derivatives->values[17] = C1_22_c;
    derivatives->values[18] = K0_12_c;
    derivatives->values[19] = K0_22_c;
    derivatives->values[20] = t188;
    derivatives->values[21] = M_12_lam;
    derivatives->values[22] = M_22_lam;
    derivatives->values[23] = C0_21_lam;
    derivatives->values[24] = t206;
    derivatives->values[25] = C1_21_lam;
    derivatives->values[26] = C1_22_lam;
    derivatives->values[27] = K0_12_lam;
    derivatives->values[28] = K0_22_lam;
    derivatives->values[29] = t225;
    derivatives->values[30] = t228;
    derivatives->values[31] = t229;
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
    derivatives->values[47] = t248;
    derivatives->values[48] = M_22_xB;
    derivatives->values[49] = t252;
    derivatives->values[50] = C1_22_xB;
    derivatives->values[51] = t254;
    derivatives->values[52] = t258;
    derivatives->values[53] = K2_22_xB;
    derivatives->values[54] = M_11_zB;
    derivatives->values[55] = t114;
    derivatives->values[56] = t255;
    derivatives->values[57] = p->mB;
    derivatives->values[58] = t253;
    derivatives->values[59] = M_11_mB;
    derivatives->values[60] = t262;
    derivatives->values[61] = M_22_mB;
    derivatives->values[62] = t266;
    derivatives->values[63] = C1_22_mB;
    derivatives->values[64] = p->zB;
    derivatives->values[65] = t113;
    derivatives->values[66] = t268;
    derivatives->values[67] = t251;
    derivatives->values[68] = K2_22_mB;
    derivatives->values[69] = mu;
    derivatives->values[70] = yaw_per_v_delta;
    derivatives->values[71] = t270;
    derivatives->values[72] = t272;
    derivatives->values[73] = t273;
    derivatives->values[74] = C1_22_xH;
    derivatives->values[75] = t271;
    derivatives->values[76] = t278;
    derivatives->values[77] = K2_22_xH;
    derivatives->values[78] = M_11_zH;
    derivatives->values[79] = M_12_zH;
    derivatives->values[80] = M_22_zH;
    derivatives->values[81] = t156;
    derivatives->values[82] = t286;
    derivatives->values[83] = p->mH;
    derivatives->values[84] = K0_12_zH;
    derivatives->values[85] = K0_22_zH;
    derivatives->values[86] = t288;
    derivatives->values[87] = t289;
    derivatives->values[88] = M_11_mH;
    derivatives->values[89] = M_12_mH;
    derivatives->values[90] = M_22_mH;
    derivatives->values[91] = t293;
    derivatives->values[92] = t294;
    derivatives->values[93] = p->zH;
    derivatives->values[94] = K0_12_mH;
    derivatives->values[95] = K0_22_mH;
    derivatives->values[96] = t296;
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
    derivatives->values[112] = t308;
    derivatives->values[113] = t310;
    derivatives->values[114] = K2_12_rF;
    derivatives->values[115] = K2_22_rF;
    derivatives->values[116] = M_11_mF;
    derivatives->values[117] = M_12_mF;
    derivatives->values[118] = M_22_mF;
    derivatives->values[119] = C1_12_mF;
    derivatives->values[120] = C1_22_mF;
    derivatives->values[121] = p->rF;
    derivatives->values[122] = t314;
    derivatives->values[123] = t316;
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
