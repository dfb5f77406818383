/* @generated from generated/models/motorcycle.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 30344da47625ffae
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * s = sin(eps) [1]
 * c = cos(eps) [1]
 * l = (a - t)/c [m]
 * k = (a + e)*c - f*s [m]
 * j = (a + e)*s + f*c [m]
 * load = (b*(Mf + Mr) + k*Mf)/(b + l) [kg]
 * rest = load - Zf/g [kg]
 * Jxx_delta = Mf*j^2 + Ifx*c^2 + Ifz*s^2 [kg*m^2]
 * Jxz_delta = Mf*j*(k - a/c) + s*c*(Ifz - Ifx) [kg*m^2]
 * Jzz_delta = Mf*(k - a/c)^2 + Ifx*s^2 + Ifz*c^2 [kg*m^2]
 * Sx_delta = Mf*(k - a/c) [kg*m]
 * Sz_delta = -Mf*j [kg*m]
 * py_delta = c*Sx_delta - s*Sz_delta [kg*m]
 * hx_delta = s*Jxx_delta + c*Jxz_delta [kg*m^2]
 * hz_delta = s*Jxz_delta + c*Jzz_delta [kg*m^2]
 * Jxx_all = Mr*h^2 + Irx + Jxx_delta [kg*m^2]
 * Jxz_all = Jxz_delta - Crxz - a*Sz_delta/c [kg*m^2]
 * Jzz_all = Mf*k^2 + Irz + Ifx*s^2 + Ifz*c^2 [kg*m^2]
 * Sx_all = Mf*k [kg*m]
 * Sz_all = Sz_delta - Mr*h [kg*m]
 * m_all = Mf + Mr [kg]
 * load_spin_F = -(b*m_all + Sx_all)/(b + l) [kg]
 * h_spin_R = iry/Rr [kg*m]
 * h_spin_F = ify/Rf [kg*m]
 * h_wheels_all = h_spin_R + h_spin_F [kg*m]
 * M_psi_delta = a*py_delta/c + hz_delta [kg*m^2]
 * M_delta_delta = s*hx_delta + c*hz_delta [kg*m^2]
 * K_phi_delta = -(py_delta + load_spin_F*(c*l - a)) [kg*m]
 * K_delta_delta = -s*(py_delta + load_spin_F*(c*l - a)) [kg*m]
 * M_11 = m_all [kg]
 * M_12 = M_21 = Sx_all [kg*m]
 * M_13 = M_31 = -Sz_all [kg*m]
 * M_14 = M_41 = py_delta [kg*m]
 * M_22 = Jzz_all [kg*m^2]
 * M_23 = M_32 = Jxz_all [kg*m^2]
 * M_24 = M_42 = M_psi_delta [kg*m^2]
 * M_33 = Jxx_all [kg*m^2]
 * M_34 = M_43 = hx_delta [kg*m^2]
 * M_44 = M_delta_delta [kg*m^2]
 * C0_44 = K [kg*m^2/s]
 * C0_51 = -Cr1/sigma [kg/s^2]
 * C0_52 = b*Cr1/sigma [kg*m/s^2]
 * C0_55 = Cr1/sigma [kg/s^2]
 * C0_61 = -Cf1/sigma [kg/s^2]
 * C0_62 = -Cf1*l/sigma [kg*m/s^2]
 * C0_64 = Cf1*(a - c*l)/sigma [kg*m/s^2]
 * C0_66 = Cf1/sigma [kg/s^2]
 * C1_12 = m_all [kg]
 * C1_22 = Sx_all [kg*m]
 * C1_23 = -h_wheels_all [kg*m]
 * C1_24 = -s*h_spin_F [kg*m]
 * C1_32 = h_wheels_all - Sz_all [kg*m]
 * C1_34 = c*h_spin_F [kg*m]
 * C1_42 = s*h_spin_F + py_delta [kg*m]
 * C1_43 = -c*h_spin_F [kg*m]
 * Kc_15 = Cr1/sigma [kg/s^2]
 * Kc_16 = Cf1/sigma [kg/s^2]
 * Kc_25 = -b*Cr1/sigma [kg*m/s^2]
 * Kc_26 = Cf1*l/sigma [kg*m/s^2]
 * Kc_46 = Cf1*(c*l - a)/sigma [kg*m/s^2]
 * K0_33 = Sz_all [kg*m]
 * K0_34 = K0_43 = t*rest + K_phi_delta [kg*m]
 * K0_44 = t*s*rest + K_delta_delta [kg*m]
 * K1_53 = Cr2/sigma [kg/s^2]
 * K1_55 = Cr1/sigma^2 [kg/m/s^2]
 * K1_63 = Cf2/sigma [kg/s^2]
 * K1_64 = (Cf1*c + Cf2*s)/sigma [kg/s^2]
 * K1_66 = Cf1/sigma^2 [kg/m/s^2]
 * @endverbatim
 */

#include "motorcycle.h"

#include "carvallo_trig.h"

#include <float.h>

const char *motorcycle_set_name(motorcycle_set_t set)
{
    static const char *const TEXTS[] = {
        "standard",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *motorcycle_validity_text(motorcycle_validity_t validity)
{
    static const char *const TEXTS[] = {
        "Motorcycle: the parameters are valid",
        "Motorcycle: Mf in kg must be finite and > 0",
        "Motorcycle: Mr in kg must be finite and > 0",
        "Motorcycle: Irx in kg*m^2 must be finite and >= 0",
        "Motorcycle: Irz in kg*m^2 must be finite and >= 0",
        "Motorcycle: Crxz in kg*m^2 must be finite",
        "Motorcycle: Ifx in kg*m^2 must be finite and >= 0",
        "Motorcycle: Ifz in kg*m^2 must be finite and >= 0",
        "Motorcycle: ify in kg*m^2 must be finite and >= 0",
        "Motorcycle: iry in kg*m^2 must be finite and >= 0",
        "Motorcycle: a in m must be finite and > 0",
        "Motorcycle: b in m must be finite and > 0",
        "Motorcycle: e in m must be finite",
        "Motorcycle: f in m must be finite",
        "Motorcycle: h in m must be finite and > 0",
        "Motorcycle: Rf in m must be finite and > 0",
        "Motorcycle: Rr in m must be finite and > 0",
        "Motorcycle: t in m must be finite",
        "Motorcycle: eps in rad must be finite and > -1.5707963267948966 and < 1.5707963267948966",
        "Motorcycle: Cf1 in N must be finite and > 0",
        "Motorcycle: Cf2 in N must be finite and >= 0",
        "Motorcycle: Cr1 in N must be finite and > 0",
        "Motorcycle: Cr2 in N must be finite and >= 0",
        "Motorcycle: K in N*m*s must be finite and >= 0",
        "Motorcycle: sigma in m must be finite and > 0",
        "Motorcycle: Zf in N must be finite and >= 0",
        "Motorcycle: g in N/kg must be finite and > 0",
        "Motorcycle: b + l in m must be finite and > 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t motorcycle_partials[MOTORCYCLE_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 2U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 41U, false},
    {CARVALLO_MATRIX_M, 0U, 2U, 0U, 26U, false},
    {CARVALLO_MATRIX_M, 0U, 3U, 0U, 54U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 41U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 48U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 0U, 49U, true},
    {CARVALLO_MATRIX_M, 1U, 3U, 0U, 55U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 0U, 26U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 0U, 49U, true},
    {CARVALLO_MATRIX_M, 2U, 2U, 0U, 47U, false},
    {CARVALLO_MATRIX_M, 2U, 3U, 0U, 56U, true},
    {CARVALLO_MATRIX_M, 3U, 0U, 0U, 54U, false},
    {CARVALLO_MATRIX_M, 3U, 1U, 0U, 55U, false},
    {CARVALLO_MATRIX_M, 3U, 2U, 0U, 56U, true},
    {CARVALLO_MATRIX_M, 3U, 3U, 0U, 68U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 2U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 41U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 0U, 26U, false},
    {CARVALLO_MATRIX_C1, 3U, 1U, 0U, 54U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 0U, 26U, true},
    {CARVALLO_MATRIX_K0, 2U, 3U, 0U, 69U, false},
    {CARVALLO_MATRIX_K0, 3U, 2U, 0U, 69U, false},
    {CARVALLO_MATRIX_K0, 3U, 3U, 0U, 70U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 1U, 2U, false},
    {CARVALLO_MATRIX_M, 0U, 2U, 1U, 1U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 1U, 1U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 1U, 7U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 2U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 1U, 1U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 1U, 1U, true},
    {CARVALLO_MATRIX_M, 2U, 2U, 2U, 2U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 3U, 2U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 4U, 3U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 4U, 3U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 5U, 27U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 5U, 29U, true},
    {CARVALLO_MATRIX_M, 2U, 1U, 5U, 29U, true},
    {CARVALLO_MATRIX_M, 2U, 2U, 5U, 28U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 28U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 6U, 29U, false},
    {CARVALLO_MATRIX_M, 1U, 3U, 6U, 61U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 6U, 29U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 6U, 27U, false},
    {CARVALLO_MATRIX_M, 2U, 3U, 6U, 63U, false},
    {CARVALLO_MATRIX_M, 3U, 1U, 6U, 61U, false},
    {CARVALLO_MATRIX_M, 3U, 2U, 6U, 63U, false},
    {CARVALLO_MATRIX_M, 3U, 3U, 6U, 2U, false},
    {CARVALLO_MATRIX_C1, 1U, 2U, 7U, 5U, true},
    {CARVALLO_MATRIX_C1, 1U, 3U, 7U, 30U, true},
    {CARVALLO_MATRIX_C1, 2U, 1U, 7U, 5U, false},
    {CARVALLO_MATRIX_C1, 2U, 3U, 7U, 32U, false},
    {CARVALLO_MATRIX_C1, 3U, 1U, 7U, 30U, false},
    {CARVALLO_MATRIX_C1, 3U, 2U, 7U, 32U, true},
    {CARVALLO_MATRIX_C1, 1U, 2U, 8U, 6U, true},
    {CARVALLO_MATRIX_C1, 2U, 1U, 8U, 6U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 9U, 37U, false},
    {CARVALLO_MATRIX_M, 0U, 2U, 9U, 38U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 9U, 37U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 9U, 72U, true},
    {CARVALLO_MATRIX_M, 1U, 2U, 9U, 65U, false},
    {CARVALLO_MATRIX_M, 1U, 3U, 9U, 82U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 9U, 38U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 9U, 65U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 9U, 67U, false},
    {CARVALLO_MATRIX_M, 2U, 3U, 9U, 83U, false},
    {CARVALLO_MATRIX_M, 3U, 1U, 9U, 82U, false},
    {CARVALLO_MATRIX_M, 3U, 2U, 9U, 83U, false},
    {CARVALLO_MATRIX_C0, 5U, 1U, 9U, 51U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 9U, 37U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 9U, 38U, false},
    {CARVALLO_MATRIX_KC, 1U, 5U, 9U, 51U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 9U, 38U, true},
    {CARVALLO_MATRIX_C0, 4U, 1U, 10U, 10U, false},
    {CARVALLO_MATRIX_KC, 1U, 4U, 10U, 10U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 11U, 37U, false},
    {CARVALLO_MATRIX_M, 0U, 2U, 11U, 38U, false},
    {CARVALLO_MATRIX_M, 0U, 3U, 11U, 75U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 11U, 37U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 11U, 72U, true},
    {CARVALLO_MATRIX_M, 1U, 2U, 11U, 65U, false},
    {CARVALLO_MATRIX_M, 1U, 3U, 11U, 79U, true},
    {CARVALLO_MATRIX_M, 2U, 0U, 11U, 38U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 11U, 65U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 11U, 67U, false},
    {CARVALLO_MATRIX_M, 2U, 3U, 11U, 81U, false},
    {CARVALLO_MATRIX_M, 3U, 0U, 11U, 75U, false},
    {CARVALLO_MATRIX_M, 3U, 1U, 11U, 79U, true},
    {CARVALLO_MATRIX_M, 3U, 2U, 11U, 81U, false},
    {CARVALLO_MATRIX_M, 3U, 3U, 11U, 59U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 11U, 37U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 11U, 38U, false},
    {CARVALLO_MATRIX_C1, 3U, 1U, 11U, 75U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 11U, 38U, true},
    {CARVALLO_MATRIX_K0, 2U, 3U, 11U, 76U, true},
    {CARVALLO_MATRIX_K0, 3U, 2U, 11U, 76U, true},
    {CARVALLO_MATRIX_K0, 3U, 3U, 11U, 77U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 12U, 38U, true},
    {CARVALLO_MATRIX_M, 0U, 2U, 12U, 37U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 12U, 38U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 12U, 66U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 12U, 71U, true},
    {CARVALLO_MATRIX_M, 1U, 3U, 12U, 80U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 12U, 37U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 12U, 71U, true},
    {CARVALLO_MATRIX_M, 2U, 2U, 12U, 52U, false},
    {CARVALLO_MATRIX_M, 2U, 3U, 12U, 78U, true},
    {CARVALLO_MATRIX_M, 3U, 1U, 12U, 80U, false},
    {CARVALLO_MATRIX_M, 3U, 2U, 12U, 78U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 12U, 38U, true},
    {CARVALLO_MATRIX_C1, 2U, 1U, 12U, 37U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 12U, 37U, true},
    {CARVALLO_MATRIX_M, 0U, 2U, 13U, 0U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 13U, 0U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 13U, 8U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 13U, 0U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 13U, 0U, true},
    {CARVALLO_MATRIX_C1, 1U, 2U, 14U, 22U, false},
    {CARVALLO_MATRIX_C1, 1U, 3U, 14U, 42U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 14U, 22U, true},
    {CARVALLO_MATRIX_C1, 2U, 3U, 14U, 33U, true},
    {CARVALLO_MATRIX_C1, 3U, 1U, 14U, 42U, true},
    {CARVALLO_MATRIX_C1, 3U, 2U, 14U, 33U, false},
    {CARVALLO_MATRIX_C1, 1U, 2U, 15U, 15U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 15U, 15U, true},
    {CARVALLO_MATRIX_C0, 5U, 1U, 16U, 51U, false},
    {CARVALLO_MATRIX_C0, 5U, 3U, 16U, 12U, false},
    {CARVALLO_MATRIX_KC, 1U, 5U, 16U, 51U, true},
    {CARVALLO_MATRIX_KC, 3U, 5U, 16U, 12U, true},
    {CARVALLO_MATRIX_K0, 2U, 3U, 16U, 23U, true},
    {CARVALLO_MATRIX_K0, 3U, 2U, 16U, 23U, true},
    {CARVALLO_MATRIX_K0, 3U, 3U, 16U, 34U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 17U, 45U, true},
    {CARVALLO_MATRIX_M, 0U, 2U, 17U, 44U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 17U, 45U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 17U, 60U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 17U, 58U, false},
    {CARVALLO_MATRIX_M, 1U, 3U, 17U, 64U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 17U, 44U, true},
    {CARVALLO_MATRIX_M, 2U, 1U, 17U, 58U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 17U, 60U, true},
    {CARVALLO_MATRIX_M, 2U, 3U, 17U, 62U, false},
    {CARVALLO_MATRIX_M, 3U, 1U, 17U, 64U, false},
    {CARVALLO_MATRIX_M, 3U, 2U, 17U, 62U, false},
    {CARVALLO_MATRIX_C0, 5U, 1U, 17U, 57U, true},
    {CARVALLO_MATRIX_C1, 1U, 1U, 17U, 45U, true},
    {CARVALLO_MATRIX_C1, 1U, 3U, 17U, 31U, true},
    {CARVALLO_MATRIX_C1, 2U, 1U, 17U, 44U, true},
    {CARVALLO_MATRIX_C1, 2U, 3U, 17U, 43U, true},
    {CARVALLO_MATRIX_C1, 3U, 1U, 17U, 31U, false},
    {CARVALLO_MATRIX_C1, 3U, 2U, 17U, 43U, false},
    {CARVALLO_MATRIX_KC, 1U, 5U, 17U, 57U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 17U, 44U, false},
    {CARVALLO_MATRIX_K0, 3U, 3U, 17U, 73U, false},
    {CARVALLO_MATRIX_K1, 5U, 3U, 17U, 40U, false},
    {CARVALLO_MATRIX_C0, 5U, 0U, 18U, 4U, true},
    {CARVALLO_MATRIX_C0, 5U, 1U, 18U, 50U, true},
    {CARVALLO_MATRIX_C0, 5U, 3U, 18U, 9U, false},
    {CARVALLO_MATRIX_C0, 5U, 5U, 18U, 4U, false},
    {CARVALLO_MATRIX_KC, 0U, 5U, 18U, 4U, false},
    {CARVALLO_MATRIX_KC, 1U, 5U, 18U, 50U, false},
    {CARVALLO_MATRIX_KC, 3U, 5U, 18U, 9U, true},
    {CARVALLO_MATRIX_K1, 5U, 3U, 18U, 35U, false},
    {CARVALLO_MATRIX_K1, 5U, 5U, 18U, 13U, false},
    {CARVALLO_MATRIX_K1, 5U, 2U, 19U, 4U, false},
    {CARVALLO_MATRIX_K1, 5U, 3U, 19U, 39U, false},
    {CARVALLO_MATRIX_C0, 4U, 0U, 20U, 4U, true},
    {CARVALLO_MATRIX_C0, 4U, 1U, 20U, 11U, false},
    {CARVALLO_MATRIX_C0, 4U, 4U, 20U, 4U, false},
    {CARVALLO_MATRIX_KC, 0U, 4U, 20U, 4U, false},
    {CARVALLO_MATRIX_KC, 1U, 4U, 20U, 11U, true},
    {CARVALLO_MATRIX_K1, 4U, 4U, 20U, 13U, false},
    {CARVALLO_MATRIX_K1, 4U, 2U, 21U, 4U, false},
    {CARVALLO_MATRIX_C0, 3U, 3U, 22U, 2U, false},
    {CARVALLO_MATRIX_C0, 4U, 0U, 23U, 17U, false},
    {CARVALLO_MATRIX_C0, 4U, 1U, 23U, 18U, true},
    {CARVALLO_MATRIX_C0, 4U, 4U, 23U, 17U, true},
    {CARVALLO_MATRIX_C0, 5U, 0U, 23U, 16U, false},
    {CARVALLO_MATRIX_C0, 5U, 1U, 23U, 53U, false},
    {CARVALLO_MATRIX_C0, 5U, 3U, 23U, 19U, true},
    {CARVALLO_MATRIX_C0, 5U, 5U, 23U, 16U, true},
    {CARVALLO_MATRIX_KC, 0U, 4U, 23U, 17U, true},
    {CARVALLO_MATRIX_KC, 0U, 5U, 23U, 16U, true},
    {CARVALLO_MATRIX_KC, 1U, 4U, 23U, 18U, false},
    {CARVALLO_MATRIX_KC, 1U, 5U, 23U, 53U, true},
    {CARVALLO_MATRIX_KC, 3U, 5U, 23U, 19U, false},
    {CARVALLO_MATRIX_K1, 4U, 2U, 23U, 14U, true},
    {CARVALLO_MATRIX_K1, 4U, 4U, 23U, 24U, true},
    {CARVALLO_MATRIX_K1, 5U, 2U, 23U, 21U, true},
    {CARVALLO_MATRIX_K1, 5U, 3U, 23U, 46U, true},
    {CARVALLO_MATRIX_K1, 5U, 5U, 23U, 25U, true},
    {CARVALLO_MATRIX_K0, 2U, 3U, 24U, 20U, true},
    {CARVALLO_MATRIX_K0, 3U, 2U, 24U, 20U, true},
    {CARVALLO_MATRIX_K0, 3U, 3U, 24U, 36U, true},
    {CARVALLO_MATRIX_K0, 2U, 3U, 25U, 74U, false},
    {CARVALLO_MATRIX_K0, 3U, 2U, 25U, 74U, false},
    {CARVALLO_MATRIX_K0, 3U, 3U, 25U, 84U, false}
};

const motorcycle_f64_t motorcycle_f64_sets[MOTORCYCLE_SETS] = {
    { /* standard */
        .Mf = 30.64719,
        .Mr = 217.44911,
        .Irx = 31.183806535488,
        .Irz = 21.06940667658624,
        .Crxz = 1.73544662458368,
        .Ifx = 1.23379408466496,
        .Ifz = 0.441996562198656,
        .ify = 0.71858336799168,
        .iry = 1.0507586984784,
        .a = 0.9485376,
        .b = 0.4797552,
        .e = 0.024384,
        .f = 0.0283464,
        .h = 0.615696,
        .Rf = 0.3048,
        .Rr = 0.3048,
        .t = 0.115824,
        .eps = 0.4715,
        .Cf1 = 11173.93044864,
        .Cf2 = 938.57457192,
        .Cr1 = 15831.21754248,
        .Cr2 = 1325.56977456,
        .K = 6.77908837728,
        .sigma = 0.24384,
        .Zf = 1005.29788272,
        .g = 9.81456
    }
};

motorcycle_validity_t motorcycle_f64_validate(const motorcycle_f64_t *p)
{
    motorcycle_validity_t validity = MOTORCYCLE_VALID;
    if (!((p->Mf > 0.0) && (p->Mf <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Mf;
    } else if (!((p->Mr > 0.0) && (p->Mr <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Mr;
    } else if (!((p->Irx >= 0.0) && (p->Irx <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Irx;
    } else if (!((p->Irz >= 0.0) && (p->Irz <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Irz;
    } else if (!((p->Crxz >= -DBL_MAX) && (p->Crxz <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Crxz;
    } else if (!((p->Ifx >= 0.0) && (p->Ifx <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Ifx;
    } else if (!((p->Ifz >= 0.0) && (p->Ifz <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Ifz;
    } else if (!((p->ify >= 0.0) && (p->ify <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_ify;
    } else if (!((p->iry >= 0.0) && (p->iry <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_iry;
    } else if (!((p->a > 0.0) && (p->a <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_a;
    } else if (!((p->b > 0.0) && (p->b <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_b;
    } else if (!((p->e >= -DBL_MAX) && (p->e <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_e;
    } else if (!((p->f >= -DBL_MAX) && (p->f <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_f;
    } else if (!((p->h > 0.0) && (p->h <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_h;
    } else if (!((p->Rf > 0.0) && (p->Rf <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Rf;
    } else if (!((p->Rr > 0.0) && (p->Rr <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Rr;
    } else if (!((p->t >= -DBL_MAX) && (p->t <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_t;
    } else if (!((p->eps > (-1.5707963267948966)) && (p->eps < 1.5707963267948966))) {
        validity = MOTORCYCLE_INVALID_eps;
    } else if (!((p->Cf1 > 0.0) && (p->Cf1 <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Cf1;
    } else if (!((p->Cf2 >= 0.0) && (p->Cf2 <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Cf2;
    } else if (!((p->Cr1 > 0.0) && (p->Cr1 <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Cr1;
    } else if (!((p->Cr2 >= 0.0) && (p->Cr2 <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Cr2;
    } else if (!((p->K >= 0.0) && (p->K <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_K;
    } else if (!((p->sigma > 0.0) && (p->sigma <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_sigma;
    } else if (!((p->Zf >= 0.0) && (p->Zf <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_Zf;
    } else if (!((p->g > 0.0) && (p->g <= DBL_MAX))) {
        validity = MOTORCYCLE_INVALID_g;
    } else {
        const double c = carvallo_cos_f64(p->eps);
        const double l = (p->a - p->t) / c;
        const double t7 = p->b + l;
        if (!((t7 > 0.0) && (t7 <= DBL_MAX))) {
            validity = MOTORCYCLE_REQUIREMENT_1;
        } else {
            /* All requirements hold. */
        }
    }
    return validity;
}

void motorcycle_f64_matrices(const motorcycle_f64_t *p, motorcycle_f64_matrices_t *matrices)
{
    const double M_11 = p->Mf + p->Mr;
    double s = 0.0;
    double cos_eps = 0.0;
    carvallo_sin_cos_f64(p->eps, &s, &cos_eps);
    const double t10 = p->a + p->e;
    const double t12 = (cos_eps * t10) - (p->f * s);
    const double M_12 = p->Mf * t12;
    const double t15 = p->Mr * p->h;
    const double j = (p->f * cos_eps) + (s * t10);
    const double t19 = p->Mf * j;
    const double M_13 = t15 + t19;
    const double t21 = s * s;
    const double t22 = cos_eps * cos_eps;
    const double t25 = p->a - (t10 * (t21 + t22));
    const double t26 = p->Mf * t25;
    const double t34 = p->Ifz * t22;
    const double M_22 = p->Irz + (p->Ifx * t21) + ((t12 * M_12) + t34);
    const double t44 = t21 * p->Ifz;
    const double t45 = t34 + t44;
    const double M_24 = (cos_eps * t45) - (M_12 * t25);
    const double M_33 = t44 + ((p->Ifx * t22) + ((p->h * t15) + (p->Irx + (j * t19))));
    const double M_44 = p->Ifz + (t25 * t26);
    const double t63 = 1.0 / p->sigma;
    const double C0_55 = p->Cr1 * t63;
    const double C0_52 = C0_55 * p->b;
    const double C0_66 = t63 * p->Cf1;
    const double C0_64 = C0_66 * p->t;
    const double Kc_26 = ((p->a * C0_66) - C0_64) / cos_eps;
    const double h_spin_R = p->iry / p->Rr;
    const double h_spin_F = p->ify / p->Rf;
    const double h_wheels_all = h_spin_R + h_spin_F;
    const double t81 = s * h_spin_F;
    const double C1_32 = M_13 + h_wheels_all;
    const double C1_34 = cos_eps * h_spin_F;
    const double K0_34 = ((t26 * p->g) - (p->t * p->Zf)) / p->g;
    const double K0_44 = s * K0_34;
    const double K1_53 = t63 * p->Cr2;
    const double t94 = 1.0 / (p->sigma * p->sigma);
    const double K1_55 = p->Cr1 * t94;
    const double K1_63 = t63 * p->Cf2;
    const double K1_64 = (s * K1_63) + (cos_eps * C0_66);
    const double K1_66 = p->Cf1 * t94;
    const double M_14 = -t26;
    const double M_23 = (t12 * t19) - (p->Crxz + (cos_eps * (s * (p->Ifx - p->Ifz))));
    const double M_34 = (s * t45) - (j * t26);
    const double C0_51 = -C0_55;
    const double C0_61 = -C0_66;
    const double C0_62 = -Kc_26;
    const double C1_23 = -h_wheels_all;
    const double C1_24 = -t81;
    const double C1_42 = t81 - t26;
    const double C1_43 = -C1_34;
    const double Kc_25 = -C0_52;
    const double Kc_46 = -C0_64;
    const double K0_33 = -M_13;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[0][3] = M_14;
    matrices->m[0][4] = 0.0;
    matrices->m[0][5] = 0.0;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = M_23;
    matrices->m[1][3] = M_24;
    matrices->m[1][4] = 0.0;
    matrices->m[1][5] = 0.0;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_23;
    matrices->m[2][2] = M_33;
    matrices->m[2][3] = M_34;
    matrices->m[2][4] = 0.0;
    matrices->m[2][5] = 0.0;
    matrices->m[3][0] = M_14;
    matrices->m[3][1] = M_24;
    matrices->m[3][2] = M_34;
    matrices->m[3][3] = M_44;
    matrices->m[3][4] = 0.0;
    matrices->m[3][5] = 0.0;
    matrices->m[4][0] = 0.0;
    matrices->m[4][1] = 0.0;
    matrices->m[4][2] = 0.0;
    matrices->m[4][3] = 0.0;
    matrices->m[4][4] = 0.0;
    matrices->m[4][5] = 0.0;
    matrices->m[5][0] = 0.0;
    matrices->m[5][1] = 0.0;
    matrices->m[5][2] = 0.0;
    matrices->m[5][3] = 0.0;
    matrices->m[5][4] = 0.0;
    matrices->m[5][5] = 0.0;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = 0.0;
    matrices->c0[0][2] = 0.0;
    matrices->c0[0][3] = 0.0;
    matrices->c0[0][4] = 0.0;
    matrices->c0[0][5] = 0.0;
    matrices->c0[1][0] = 0.0;
    matrices->c0[1][1] = 0.0;
    matrices->c0[1][2] = 0.0;
    matrices->c0[1][3] = 0.0;
    matrices->c0[1][4] = 0.0;
    matrices->c0[1][5] = 0.0;
    matrices->c0[2][0] = 0.0;
    matrices->c0[2][1] = 0.0;
    matrices->c0[2][2] = 0.0;
    matrices->c0[2][3] = 0.0;
    matrices->c0[2][4] = 0.0;
    matrices->c0[2][5] = 0.0;
    matrices->c0[3][0] = 0.0;
    matrices->c0[3][1] = 0.0;
    matrices->c0[3][2] = 0.0;
    matrices->c0[3][3] = p->K;
    matrices->c0[3][4] = 0.0;
    matrices->c0[3][5] = 0.0;
    matrices->c0[4][0] = C0_51;
    matrices->c0[4][1] = C0_52;
    matrices->c0[4][2] = 0.0;
    matrices->c0[4][3] = 0.0;
    matrices->c0[4][4] = C0_55;
    matrices->c0[4][5] = 0.0;
    matrices->c0[5][0] = C0_61;
    matrices->c0[5][1] = C0_62;
    matrices->c0[5][2] = 0.0;
    matrices->c0[5][3] = C0_64;
    matrices->c0[5][4] = 0.0;
    matrices->c0[5][5] = C0_66;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = M_11;
    matrices->c1[0][2] = 0.0;
    matrices->c1[0][3] = 0.0;
    matrices->c1[0][4] = 0.0;
    matrices->c1[0][5] = 0.0;
    matrices->c1[1][0] = 0.0;
    matrices->c1[1][1] = M_12;
    matrices->c1[1][2] = C1_23;
    matrices->c1[1][3] = C1_24;
    matrices->c1[1][4] = 0.0;
    matrices->c1[1][5] = 0.0;
    matrices->c1[2][0] = 0.0;
    matrices->c1[2][1] = C1_32;
    matrices->c1[2][2] = 0.0;
    matrices->c1[2][3] = C1_34;
    matrices->c1[2][4] = 0.0;
    matrices->c1[2][5] = 0.0;
    matrices->c1[3][0] = 0.0;
    matrices->c1[3][1] = C1_42;
    matrices->c1[3][2] = C1_43;
    matrices->c1[3][3] = 0.0;
    matrices->c1[3][4] = 0.0;
    matrices->c1[3][5] = 0.0;
    matrices->c1[4][0] = 0.0;
    matrices->c1[4][1] = 0.0;
    matrices->c1[4][2] = 0.0;
    matrices->c1[4][3] = 0.0;
    matrices->c1[4][4] = 0.0;
    matrices->c1[4][5] = 0.0;
    matrices->c1[5][0] = 0.0;
    matrices->c1[5][1] = 0.0;
    matrices->c1[5][2] = 0.0;
    matrices->c1[5][3] = 0.0;
    matrices->c1[5][4] = 0.0;
    matrices->c1[5][5] = 0.0;
    matrices->kc[0][0] = 0.0;
    matrices->kc[0][1] = 0.0;
    matrices->kc[0][2] = 0.0;
    matrices->kc[0][3] = 0.0;
    matrices->kc[0][4] = C0_55;
    matrices->kc[0][5] = C0_66;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = 0.0;
    matrices->kc[1][2] = 0.0;
    matrices->kc[1][3] = 0.0;
    matrices->kc[1][4] = Kc_25;
    matrices->kc[1][5] = Kc_26;
    matrices->kc[2][0] = 0.0;
    matrices->kc[2][1] = 0.0;
    matrices->kc[2][2] = 0.0;
    matrices->kc[2][3] = 0.0;
    matrices->kc[2][4] = 0.0;
    matrices->kc[2][5] = 0.0;
    matrices->kc[3][0] = 0.0;
    matrices->kc[3][1] = 0.0;
    matrices->kc[3][2] = 0.0;
    matrices->kc[3][3] = 0.0;
    matrices->kc[3][4] = 0.0;
    matrices->kc[3][5] = Kc_46;
    matrices->kc[4][0] = 0.0;
    matrices->kc[4][1] = 0.0;
    matrices->kc[4][2] = 0.0;
    matrices->kc[4][3] = 0.0;
    matrices->kc[4][4] = 0.0;
    matrices->kc[4][5] = 0.0;
    matrices->kc[5][0] = 0.0;
    matrices->kc[5][1] = 0.0;
    matrices->kc[5][2] = 0.0;
    matrices->kc[5][3] = 0.0;
    matrices->kc[5][4] = 0.0;
    matrices->kc[5][5] = 0.0;
    matrices->k0[0][0] = 0.0;
    matrices->k0[0][1] = 0.0;
    matrices->k0[0][2] = 0.0;
    matrices->k0[0][3] = 0.0;
    matrices->k0[0][4] = 0.0;
    matrices->k0[0][5] = 0.0;
    matrices->k0[1][0] = 0.0;
    matrices->k0[1][1] = 0.0;
    matrices->k0[1][2] = 0.0;
    matrices->k0[1][3] = 0.0;
    matrices->k0[1][4] = 0.0;
    matrices->k0[1][5] = 0.0;
    matrices->k0[2][0] = 0.0;
    matrices->k0[2][1] = 0.0;
    matrices->k0[2][2] = K0_33;
    matrices->k0[2][3] = K0_34;
    matrices->k0[2][4] = 0.0;
    matrices->k0[2][5] = 0.0;
    matrices->k0[3][0] = 0.0;
    matrices->k0[3][1] = 0.0;
    matrices->k0[3][2] = K0_34;
    matrices->k0[3][3] = K0_44;
    matrices->k0[3][4] = 0.0;
    matrices->k0[3][5] = 0.0;
    matrices->k0[4][0] = 0.0;
    matrices->k0[4][1] = 0.0;
    matrices->k0[4][2] = 0.0;
    matrices->k0[4][3] = 0.0;
    matrices->k0[4][4] = 0.0;
    matrices->k0[4][5] = 0.0;
    matrices->k0[5][0] = 0.0;
    matrices->k0[5][1] = 0.0;
    matrices->k0[5][2] = 0.0;
    matrices->k0[5][3] = 0.0;
    matrices->k0[5][4] = 0.0;
    matrices->k0[5][5] = 0.0;
    matrices->k1[0][0] = 0.0;
    matrices->k1[0][1] = 0.0;
    matrices->k1[0][2] = 0.0;
    matrices->k1[0][3] = 0.0;
    matrices->k1[0][4] = 0.0;
    matrices->k1[0][5] = 0.0;
    matrices->k1[1][0] = 0.0;
    matrices->k1[1][1] = 0.0;
    matrices->k1[1][2] = 0.0;
    matrices->k1[1][3] = 0.0;
    matrices->k1[1][4] = 0.0;
    matrices->k1[1][5] = 0.0;
    matrices->k1[2][0] = 0.0;
    matrices->k1[2][1] = 0.0;
    matrices->k1[2][2] = 0.0;
    matrices->k1[2][3] = 0.0;
    matrices->k1[2][4] = 0.0;
    matrices->k1[2][5] = 0.0;
    matrices->k1[3][0] = 0.0;
    matrices->k1[3][1] = 0.0;
    matrices->k1[3][2] = 0.0;
    matrices->k1[3][3] = 0.0;
    matrices->k1[3][4] = 0.0;
    matrices->k1[3][5] = 0.0;
    matrices->k1[4][0] = 0.0;
    matrices->k1[4][1] = 0.0;
    matrices->k1[4][2] = K1_53;
    matrices->k1[4][3] = 0.0;
    matrices->k1[4][4] = K1_55;
    matrices->k1[4][5] = 0.0;
    matrices->k1[5][0] = 0.0;
    matrices->k1[5][1] = 0.0;
    matrices->k1[5][2] = K1_63;
    matrices->k1[5][3] = K1_64;
    matrices->k1[5][4] = 0.0;
    matrices->k1[5][5] = K1_66;
}

carvallo_system_error_t motorcycle_f64_at_speed(const motorcycle_f64_matrices_t *matrices,
    double speed, double gravity, motorcycle_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed) && carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < MOTORCYCLE_N; row++) {
        for (size_t column = 0U; column < MOTORCYCLE_N; column++) {
            const double damping = matrices->c0[row][column] + (matrices->c1[row][column] * speed);
            const double stiffness = matrices->kc[row][column] + (matrices->k0[row][column] *
                gravity) + (matrices->k1[row][column] * speed);
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->c0[row][column]) &&
                carvallo_is_finite_f64(matrices->c1[row][column]) &&
                carvallo_is_finite_f64(matrices->kc[row][column]) &&
                carvallo_is_finite_f64(matrices->k0[row][column]) &&
                carvallo_is_finite_f64(matrices->k1[row][column]);
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

carvallo_system_error_t motorcycle_f64_state_space(const motorcycle_f64_system_t *system,
    motorcycle_f64_state_space_t *space)
{
    /* The row of A and B for each coordinate, and whether its position is a state beside its rate. */
    static const size_t TARGETS[MOTORCYCLE_N] = {MOTORCYCLE_N + 0U, MOTORCYCLE_N + 1U, MOTORCYCLE_N + 2U, MOTORCYCLE_N + 3U, 4U, 5U};
    static const bool HAS_BOTH[MOTORCYCLE_N] = {false, false, true, true, false, false};
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[MOTORCYCLE_N * MOTORCYCLE_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * MOTORCYCLE_N * MOTORCYCLE_N];
    for (size_t row = 0U; row < MOTORCYCLE_N; row++) {
        double *const solved = &x[3U * MOTORCYCLE_N * row];
        for (size_t column = 0U; column < MOTORCYCLE_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * MOTORCYCLE_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[MOTORCYCLE_N + column] = -system->c[row][column];
            solved[(2U * MOTORCYCLE_N) + column] = 0.0;
        }
        solved[(2U * MOTORCYCLE_N) + row] = 1.0;
        solved[0] = 0.0;
        solved[1] = 0.0;
        m[(row * MOTORCYCLE_N) + 4U] = system->c[row][4];
        solved[MOTORCYCLE_N + 4U] = 0.0;
        m[(row * MOTORCYCLE_N) + 5U] = system->c[row][5];
        solved[MOTORCYCLE_N + 5U] = 0.0;
    }
    if (is_finite) {
        double terms[MOTORCYCLE_N * MOTORCYCLE_N];
        error = carvallo_solve_f64(MOTORCYCLE_N, m, terms, 3U * MOTORCYCLE_N, x);
    }
    for (size_t row = 0U; row < (2U * MOTORCYCLE_N); row++) {
        for (size_t column = 0U; column < (2U * MOTORCYCLE_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < MOTORCYCLE_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < MOTORCYCLE_N; row++) {
            const size_t target = TARGETS[row];
            for (size_t column = 0U; column < (2U * MOTORCYCLE_N); column++) {
                space->a[target][column] = x[(3U * MOTORCYCLE_N * row) + column];
            }
            for (size_t column = 0U; column < MOTORCYCLE_N; column++) {
                space->b[target][column] = x[(3U * MOTORCYCLE_N * row) + (2U * MOTORCYCLE_N) +
                    column];
            }
            if (HAS_BOTH[row]) {
                space->a[row][MOTORCYCLE_N + row] = 1.0;
            }
        }
    }
    return error;
}

double motorcycle_f64_rate_at(const motorcycle_f64_rate_t *rate, double v,
    const double q[MOTORCYCLE_N], const double q_dot[MOTORCYCLE_N], double psi)
{
    double by_coordinates = 0.0;
    double by_rates = 0.0;
    for (size_t i = 0U; i < MOTORCYCLE_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void motorcycle_f64_kinematics(const motorcycle_f64_t *p, motorcycle_f64_kinematics_t *kinematics)
{
    const double t6 = -(1.0 / p->Rr);
    const double t7 = -(1.0 / p->Rf);
    kinematics->wheel_R.speed = t6;
    kinematics->wheel_R.rates[0] = 0.0;
    kinematics->wheel_R.rates[1] = 0.0;
    kinematics->wheel_R.rates[2] = 0.0;
    kinematics->wheel_R.rates[3] = 0.0;
    kinematics->wheel_R.rates[4] = 0.0;
    kinematics->wheel_R.rates[5] = 0.0;
    kinematics->wheel_R.coordinates[0] = 0.0;
    kinematics->wheel_R.coordinates[1] = 0.0;
    kinematics->wheel_R.coordinates[2] = 0.0;
    kinematics->wheel_R.coordinates[3] = 0.0;
    kinematics->wheel_R.coordinates[4] = 0.0;
    kinematics->wheel_R.coordinates[5] = 0.0;
    kinematics->wheel_R.heading = 0.0;
    kinematics->wheel_F.speed = t7;
    kinematics->wheel_F.rates[0] = 0.0;
    kinematics->wheel_F.rates[1] = 0.0;
    kinematics->wheel_F.rates[2] = 0.0;
    kinematics->wheel_F.rates[3] = 0.0;
    kinematics->wheel_F.rates[4] = 0.0;
    kinematics->wheel_F.rates[5] = 0.0;
    kinematics->wheel_F.coordinates[0] = 0.0;
    kinematics->wheel_F.coordinates[1] = 0.0;
    kinematics->wheel_F.coordinates[2] = 0.0;
    kinematics->wheel_F.coordinates[3] = 0.0;
    kinematics->wheel_F.coordinates[4] = 0.0;
    kinematics->wheel_F.coordinates[5] = 0.0;
    kinematics->wheel_F.heading = 0.0;
    kinematics->forces[0][0] = 0.0;
    kinematics->forces[1][0] = 0.0;
    kinematics->forces[2][0] = 0.0;
    kinematics->forces[3][0] = 1.0;
    kinematics->forces[4][0] = 0.0;
    kinematics->forces[5][0] = 0.0;
}

void motorcycle_f64_derivatives(const motorcycle_f64_t *p, motorcycle_f64_matrices_t *matrices,
    motorcycle_f64_derivatives_t *derivatives)
{
    double s = 0.0;
    double s_eps = 0.0;
    carvallo_sin_cos_f64(p->eps, &s, &s_eps);
    const double M_11 = p->Mf + p->Mr;
    const double t32 = p->a + p->e;
    const double t33 = p->Mr * p->h;
    const double C0_66_Cf1 = 1.0 / p->sigma;
    const double C1_32_ify = 1.0 / p->Rf;
    const double C1_32_iry = 1.0 / p->Rr;
    const double M_33_Mr = p->h * p->h;
    const double M_33_h = t33 + t33;
    const double C0_64_Cf1 = C0_66_Cf1 * p->t;
    const double C0_55 = p->Cr1 * C0_66_Cf1;
    const double C0_52_Cr1 = C0_66_Cf1 * p->b;
    const double C0_66 = C0_66_Cf1 * p->Cf1;
    const double h_spin_F = p->ify * C1_32_ify;
    const double t44 = p->iry * C1_32_iry;
    const double t45 = 1.0 / p->g;
    const double K1_53 = C0_66_Cf1 * p->Cr2;
    const double t47 = p->sigma * p->sigma;
    const double K1_66_Cf1 = 1.0 / t47;
    const double t49 = C0_66_Cf1 * K1_53;
    const double C0_52 = p->Cr1 * C0_52_Cr1;
    const double C1_23_Rr = C1_32_iry * t44;
    const double h_wheels_all = h_spin_F + t44;
    const double C0_61_sigma = C0_66_Cf1 * C0_66;
    const double t55 = 1.0 / (p->sigma * t47);
    const double C0_51 = -C0_55;
    const double C0_51_sigma = C0_66_Cf1 * C0_55;
    const double C0_61 = -C0_66;
    const double Kc_25_sigma = p->b * C0_51_sigma;
    const double Kc_25 = -C0_52;
    const double C1_23 = -h_wheels_all;
    const double K1_55 = p->Cr1 * K1_66_Cf1;
    const double K1_66 = p->Cf1 * K1_66_Cf1;
    const double C0_64 = C0_66 * p->t;
    const double Kc_46_sigma = C0_66_Cf1 * C0_64;
    const double Kc_46 = -C0_64;
    const double t67 = p->g * t45;
    const double t68 = p->t * t45;
    const double K1_63 = C0_66_Cf1 * p->Cf2;
    const double t70 = C0_66_Cf1 * K1_63;
    const double C1_23_Rf = C1_32_ify * h_spin_F;
    const double t72 = t55 + t55;
    const double t73 = t45 * p->Zf;
    const double t74 = p->Cr1 * t72;
    const double t75 = p->Cf1 * t72;
    const double t76 = s * p->f;
    const double t77 = s_eps * t32;
    const double j = (p->f * s_eps) + (s * t32);
    const double M_22_Ifx = s * s;
    const double M_33_Ifx = s_eps * s_eps;
    const double M_23_Ifz = s * s_eps;
    const double t84 = 1.0 / s_eps;
    const double C1_42_ify = s * C1_32_ify;
    const double C1_34 = s_eps * h_spin_F;
    const double K1_64 = (s * K1_63) + (s_eps * C0_66);
    const double C1_34_ify = s_eps * C1_32_ify;
    const double C1_43_Rf = s_eps * C1_23_Rf;
    const double t92 = s * t73;
    const double K1_64_Cf1 = s_eps * C0_66_Cf1;
    const double t94 = s * t68;
    const double M_12_a = p->Mf * s_eps;
    const double M_13_a = p->Mf * s;
    const double K1_64_Cf2 = s * C0_66_Cf1;
    const double t98 = t76 - t77;
    const double K1_64_eps = (s_eps * K1_63) - (p->Cf1 * K1_64_Cf2);
    const double M_12_Mf = t77 - t76;
    const double C1_24_Rf = h_spin_F * C1_42_ify;
    const double C1_43 = -C1_34;
    const double C1_43_eps = p->ify * C1_42_ify;
    const double t106 = M_22_Ifx + M_33_Ifx;
    const double K0_33_eps = p->Mf * t98;
    const double t108 = p->Mf * j;
    const double t109 = C0_66_Cf1 * K1_64;
    const double t110 = t32 * t106;
    const double M_33_Mf = j * j;
    const double t112 = j * M_12_a;
    const double C1_24 = -C1_43_eps;
    const double M_22_Mf = t98 * t98;
    const double t115 = t98 * j;
    const double Kc_26_Cf1 = C0_66_Cf1 * t84 * (p->a - p->t);
    const double t122 = (M_23_Ifz * (p->Ifx - p->Ifz)) + (p->Mf * t115);
    const double t127 = (p->Mf * M_22_Mf) + (M_33_Ifx * p->Ifz) + (M_22_Ifx * p->Ifx);
    const double t132 = (j * t108) + (M_33_Ifx * p->Ifx) + (M_22_Ifx * p->Ifz);
    const double Kc_26_a = C0_66 * t84;
    const double M_33_f = t112 + t112;
    const double M_12 = -K0_33_eps;
    const double C0_62_sigma = C0_66 * Kc_26_Cf1;
    const double Kc_26 = p->Cf1 * Kc_26_Cf1;
    const double M_14_Mf = t110 - p->a;
    const double t139 = p->a - t110;
    const double M_24_Mf = t98 * t139;
    const double t141 = j * t139;
    const double M_13 = t33 + t108;
    const double C1_32 = M_13 + h_wheels_all;
    const double K0_33 = -M_13;
    const double t145 = p->Mf * t139;
    const double C1_42 = C1_43_eps - t145;
    const double Kc_26_eps = s * t84 * Kc_26;
    const double M_33 = p->Irx + t132 + (p->h * t33);
    const double M_23_eps = t127 - t132;
    const double M_22 = p->Irz + t127;
    const double C0_62 = -Kc_26;
    const double t156 = t106 * (t145 + t145);
    const double M_22_eps = t122 + t122;
    const double M_23 = -(p->Crxz + t122);
    const double M_14 = -t145;
    const double M_24_Ifz = s_eps * t106;
    const double M_24 = (p->Ifz * M_24_Ifz) + (K0_33_eps * t139);
    const double M_34_Ifz = s * t106;
    const double t166 = p->Ifz * M_34_Ifz;
    const double t167 = j * t145;
    const double M_34 = t166 - t167;
    const double M_24_eps = t167 - t166;
    const double t170 = j * M_13_a;
    const double t171 = t98 * M_13_a;
    const double M_23_a = t112 - t171;
    const double M_22_f = t171 + t171;
    const double M_33_a = t170 + t170;
    const double M_44_Mf = t139 * t139;
    const double M_44 = p->Ifz + (p->Mf * M_44_Mf);
    const double K0_34_Mf = t139 * t67;
    const double K0_34 = (p->Mf * K0_34_Mf) - (p->Zf * t68);
    const double K0_44_Mf = s * K0_34_Mf;
    const double t183 = s_eps * K0_33_eps;
    const double t184 = t183 + t170;
    const double t185 = t183 + t183;
    const double K0_44 = s * K0_34;
    const double K0_44_eps = s_eps * K0_34;
    const double K0_34_g = t45 * (t145 - K0_34);
    const double M_14_e = p->Mf * t106;
    const double t191 = t67 * M_14_e;
    const double t192 = s * t191;
    const double t193 = s_eps * t145;
    const double t195 = (t98 * M_14_e) + t193;
    const double M_24_f = s * t145;
    const double M_34_e = (t108 * t106) - M_24_f;
    const double M_24_a = K0_33_eps - t195;
    const double M_34_a = M_34_e - t108;
    const double K0_44_g = s * K0_34_g;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[0][3] = M_14;
    matrices->m[0][4] = 0.0;
    matrices->m[0][5] = 0.0;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = M_23;
    matrices->m[1][3] = M_24;
    matrices->m[1][4] = 0.0;
    matrices->m[1][5] = 0.0;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_23;
    matrices->m[2][2] = M_33;
    matrices->m[2][3] = M_34;
    matrices->m[2][4] = 0.0;
    matrices->m[2][5] = 0.0;
    matrices->m[3][0] = M_14;
    matrices->m[3][1] = M_24;
    matrices->m[3][2] = M_34;
    matrices->m[3][3] = M_44;
    matrices->m[3][4] = 0.0;
    matrices->m[3][5] = 0.0;
    matrices->m[4][0] = 0.0;
    matrices->m[4][1] = 0.0;
    matrices->m[4][2] = 0.0;
    matrices->m[4][3] = 0.0;
    matrices->m[4][4] = 0.0;
    matrices->m[4][5] = 0.0;
    matrices->m[5][0] = 0.0;
    matrices->m[5][1] = 0.0;
    matrices->m[5][2] = 0.0;
    matrices->m[5][3] = 0.0;
    matrices->m[5][4] = 0.0;
    matrices->m[5][5] = 0.0;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = 0.0;
    matrices->c0[0][2] = 0.0;
    matrices->c0[0][3] = 0.0;
    matrices->c0[0][4] = 0.0;
    matrices->c0[0][5] = 0.0;
    matrices->c0[1][0] = 0.0;
    matrices->c0[1][1] = 0.0;
    matrices->c0[1][2] = 0.0;
    matrices->c0[1][3] = 0.0;
    matrices->c0[1][4] = 0.0;
    matrices->c0[1][5] = 0.0;
    matrices->c0[2][0] = 0.0;
    matrices->c0[2][1] = 0.0;
    matrices->c0[2][2] = 0.0;
    matrices->c0[2][3] = 0.0;
    matrices->c0[2][4] = 0.0;
    matrices->c0[2][5] = 0.0;
    matrices->c0[3][0] = 0.0;
    matrices->c0[3][1] = 0.0;
    matrices->c0[3][2] = 0.0;
    matrices->c0[3][3] = p->K;
    matrices->c0[3][4] = 0.0;
    matrices->c0[3][5] = 0.0;
    matrices->c0[4][0] = C0_51;
    matrices->c0[4][1] = C0_52;
    matrices->c0[4][2] = 0.0;
    matrices->c0[4][3] = 0.0;
    matrices->c0[4][4] = C0_55;
    matrices->c0[4][5] = 0.0;
    matrices->c0[5][0] = C0_61;
    matrices->c0[5][1] = C0_62;
    matrices->c0[5][2] = 0.0;
    matrices->c0[5][3] = C0_64;
    matrices->c0[5][4] = 0.0;
    matrices->c0[5][5] = C0_66;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = M_11;
    matrices->c1[0][2] = 0.0;
    matrices->c1[0][3] = 0.0;
    matrices->c1[0][4] = 0.0;
    matrices->c1[0][5] = 0.0;
    matrices->c1[1][0] = 0.0;
    matrices->c1[1][1] = M_12;
    matrices->c1[1][2] = C1_23;
    matrices->c1[1][3] = C1_24;
    matrices->c1[1][4] = 0.0;
    matrices->c1[1][5] = 0.0;
    matrices->c1[2][0] = 0.0;
    matrices->c1[2][1] = C1_32;
    matrices->c1[2][2] = 0.0;
    matrices->c1[2][3] = C1_34;
    matrices->c1[2][4] = 0.0;
    matrices->c1[2][5] = 0.0;
    matrices->c1[3][0] = 0.0;
    matrices->c1[3][1] = C1_42;
    matrices->c1[3][2] = C1_43;
    matrices->c1[3][3] = 0.0;
    matrices->c1[3][4] = 0.0;
    matrices->c1[3][5] = 0.0;
    matrices->c1[4][0] = 0.0;
    matrices->c1[4][1] = 0.0;
    matrices->c1[4][2] = 0.0;
    matrices->c1[4][3] = 0.0;
    matrices->c1[4][4] = 0.0;
    matrices->c1[4][5] = 0.0;
    matrices->c1[5][0] = 0.0;
    matrices->c1[5][1] = 0.0;
    matrices->c1[5][2] = 0.0;
    matrices->c1[5][3] = 0.0;
    matrices->c1[5][4] = 0.0;
    matrices->c1[5][5] = 0.0;
    matrices->kc[0][0] = 0.0;
    matrices->kc[0][1] = 0.0;
    matrices->kc[0][2] = 0.0;
    matrices->kc[0][3] = 0.0;
    matrices->kc[0][4] = C0_55;
    matrices->kc[0][5] = C0_66;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = 0.0;
    matrices->kc[1][2] = 0.0;
    matrices->kc[1][3] = 0.0;
    matrices->kc[1][4] = Kc_25;
    matrices->kc[1][5] = Kc_26;
    matrices->kc[2][0] = 0.0;
    matrices->kc[2][1] = 0.0;
    matrices->kc[2][2] = 0.0;
    matrices->kc[2][3] = 0.0;
    matrices->kc[2][4] = 0.0;
    matrices->kc[2][5] = 0.0;
    matrices->kc[3][0] = 0.0;
    matrices->kc[3][1] = 0.0;
    matrices->kc[3][2] = 0.0;
    matrices->kc[3][3] = 0.0;
    matrices->kc[3][4] = 0.0;
    matrices->kc[3][5] = Kc_46;
    matrices->kc[4][0] = 0.0;
    matrices->kc[4][1] = 0.0;
    matrices->kc[4][2] = 0.0;
    matrices->kc[4][3] = 0.0;
    matrices->kc[4][4] = 0.0;
    matrices->kc[4][5] = 0.0;
    matrices->kc[5][0] = 0.0;
    matrices->kc[5][1] = 0.0;
    matrices->kc[5][2] = 0.0;
    matrices->kc[5][3] = 0.0;
    matrices->kc[5][4] = 0.0;
    matrices->kc[5][5] = 0.0;
    matrices->k0[0][0] = 0.0;
    matrices->k0[0][1] = 0.0;
    matrices->k0[0][2] = 0.0;
    matrices->k0[0][3] = 0.0;
    matrices->k0[0][4] = 0.0;
    matrices->k0[0][5] = 0.0;
    matrices->k0[1][0] = 0.0;
    matrices->k0[1][1] = 0.0;
    matrices->k0[1][2] = 0.0;
    matrices->k0[1][3] = 0.0;
    matrices->k0[1][4] = 0.0;
    matrices->k0[1][5] = 0.0;
    matrices->k0[2][0] = 0.0;
    matrices->k0[2][1] = 0.0;
    matrices->k0[2][2] = K0_33;
    matrices->k0[2][3] = K0_34;
    matrices->k0[2][4] = 0.0;
    matrices->k0[2][5] = 0.0;
    matrices->k0[3][0] = 0.0;
    matrices->k0[3][1] = 0.0;
    matrices->k0[3][2] = K0_34;
    matrices->k0[3][3] = K0_44;
    matrices->k0[3][4] = 0.0;
    matrices->k0[3][5] = 0.0;
    matrices->k0[4][0] = 0.0;
    matrices->k0[4][1] = 0.0;
    matrices->k0[4][2] = 0.0;
    matrices->k0[4][3] = 0.0;
    matrices->k0[4][4] = 0.0;
    matrices->k0[4][5] = 0.0;
    matrices->k0[5][0] = 0.0;
    matrices->k0[5][1] = 0.0;
    matrices->k0[5][2] = 0.0;
    matrices->k0[5][3] = 0.0;
    matrices->k0[5][4] = 0.0;
    matrices->k0[5][5] = 0.0;
    matrices->k1[0][0] = 0.0;
    matrices->k1[0][1] = 0.0;
    matrices->k1[0][2] = 0.0;
    matrices->k1[0][3] = 0.0;
    matrices->k1[0][4] = 0.0;
    matrices->k1[0][5] = 0.0;
    matrices->k1[1][0] = 0.0;
    matrices->k1[1][1] = 0.0;
    matrices->k1[1][2] = 0.0;
    matrices->k1[1][3] = 0.0;
    matrices->k1[1][4] = 0.0;
    matrices->k1[1][5] = 0.0;
    matrices->k1[2][0] = 0.0;
    matrices->k1[2][1] = 0.0;
    matrices->k1[2][2] = 0.0;
    matrices->k1[2][3] = 0.0;
    matrices->k1[2][4] = 0.0;
    matrices->k1[2][5] = 0.0;
    matrices->k1[3][0] = 0.0;
    matrices->k1[3][1] = 0.0;
    matrices->k1[3][2] = 0.0;
    matrices->k1[3][3] = 0.0;
    matrices->k1[3][4] = 0.0;
    matrices->k1[3][5] = 0.0;
    matrices->k1[4][0] = 0.0;
    matrices->k1[4][1] = 0.0;
    matrices->k1[4][2] = K1_53;
    matrices->k1[4][3] = 0.0;
    matrices->k1[4][4] = K1_55;
    matrices->k1[4][5] = 0.0;
    matrices->k1[5][0] = 0.0;
    matrices->k1[5][1] = 0.0;
    matrices->k1[5][2] = K1_63;
    matrices->k1[5][3] = K1_64;
    matrices->k1[5][4] = 0.0;
    matrices->k1[5][5] = K1_66;
    derivatives->values[0] = p->Mr;
    derivatives->values[1] = p->h;
    derivatives->values[2] = 1.0;
    derivatives->values[3] = (-1.0);
    derivatives->values[4] = C0_66_Cf1;
    derivatives->values[5] = C1_32_ify;
    derivatives->values[6] = C1_32_iry;
    derivatives->values[7] = M_33_Mr;
    derivatives->values[8] = M_33_h;
    derivatives->values[9] = C0_64_Cf1;
    derivatives->values[10] = C0_55;
    derivatives->values[11] = C0_52_Cr1;
    derivatives->values[12] = C0_66;
    derivatives->values[13] = K1_66_Cf1;
    derivatives->values[14] = t49;
    derivatives->values[15] = C1_23_Rr;
    derivatives->values[16] = C0_61_sigma;
    derivatives->values[17] = C0_51_sigma;
    derivatives->values[18] = Kc_25_sigma;
    derivatives->values[19] = Kc_46_sigma;
    derivatives->values[20] = t68;
    derivatives->values[21] = t70;
    derivatives->values[22] = C1_23_Rf;
    derivatives->values[23] = t73;
    derivatives->values[24] = t74;
    derivatives->values[25] = t75;
    derivatives->values[26] = j;
    derivatives->values[27] = M_22_Ifx;
    derivatives->values[28] = M_33_Ifx;
    derivatives->values[29] = M_23_Ifz;
    derivatives->values[30] = C1_42_ify;
    derivatives->values[31] = C1_34;
    derivatives->values[32] = C1_34_ify;
    derivatives->values[33] = C1_43_Rf;
    derivatives->values[34] = t92;
    derivatives->values[35] = K1_64_Cf1;
    derivatives->values[36] = t94;
    derivatives->values[37] = M_12_a;
    derivatives->values[38] = M_13_a;
    derivatives->values[39] = K1_64_Cf2;
    derivatives->values[40] = K1_64_eps;
    derivatives->values[41] = M_12_Mf;
    derivatives->values[42] = C1_24_Rf;
    derivatives->values[43] = C1_43_eps;
    derivatives->values[44] = K0_33_eps;
    derivatives->values[45] = t108;
    derivatives->values[46] = t109;
    derivatives->values[47] = M_33_Mf;
    derivatives->values[48] = M_22_Mf;
    derivatives->values[49] = t115;
    derivatives->values[50] = Kc_26_Cf1;
    derivatives->values[51] = Kc_26_a;
    derivatives->values[52] = M_33_f;
    derivatives->values[53] = C0_62_sigma;
    derivatives->values[54] = M_14_Mf;
    derivatives->values[55] = M_24_Mf;
    derivatives->values[56] = t141;
    derivatives->values[57] = Kc_26_eps;
    derivatives->values[58] = M_23_eps;
    derivatives->values[59] = t156;
    derivatives->values[60] = M_22_eps;
    derivatives->values[61] = M_24_Ifz;
    derivatives->values[62] = M_24;
    derivatives->values[63] = M_34_Ifz;
    derivatives->values[64] = M_24_eps;
    derivatives->values[65] = M_23_a;
    derivatives->values[66] = M_22_f;
    derivatives->values[67] = M_33_a;
    derivatives->values[68] = M_44_Mf;
    derivatives->values[69] = K0_34_Mf;
    derivatives->values[70] = K0_44_Mf;
    derivatives->values[71] = t184;
    derivatives->values[72] = t185;
    derivatives->values[73] = K0_44_eps;
    derivatives->values[74] = K0_34_g;
    derivatives->values[75] = M_14_e;
    derivatives->values[76] = t191;
    derivatives->values[77] = t192;
    derivatives->values[78] = t193;
    derivatives->values[79] = t195;
    derivatives->values[80] = M_24_f;
    derivatives->values[81] = M_34_e;
    derivatives->values[82] = M_24_a;
    derivatives->values[83] = M_34_a;
    derivatives->values[84] = K0_44_g;
}

void motorcycle_f64_with_respect_to(const motorcycle_f64_derivatives_t *derivatives,
    size_t parameter, motorcycle_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < MOTORCYCLE_N; row++) {
        for (size_t column = 0U; column < MOTORCYCLE_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c0[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->kc[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
            matrices->k1[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < MOTORCYCLE_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &motorcycle_partials[position];
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
            case CARVALLO_MATRIX_K1:
                matrices->k1[partial->row][partial->column] = signed_value;
                break;
            default:
                /* The model has no other matrix. */
                break;
            }
        }
    }
}

const motorcycle_f32_t motorcycle_f32_sets[MOTORCYCLE_SETS] = {
    { /* standard */
        .Mf = 30.64719F,
        .Mr = 217.44911F,
        .Irx = 31.183807F,
        .Irz = 21.069407F,
        .Crxz = 1.7354466F,
        .Ifx = 1.2337941F,
        .Ifz = 0.44199657F,
        .ify = 0.71858335F,
        .iry = 1.0507587F,
        .a = 0.9485376F,
        .b = 0.4797552F,
        .e = 0.024384F,
        .f = 0.0283464F,
        .h = 0.615696F,
        .Rf = 0.3048F,
        .Rr = 0.3048F,
        .t = 0.115824F,
        .eps = 0.4715F,
        .Cf1 = 11173.931F,
        .Cf2 = 938.5746F,
        .Cr1 = 15831.218F,
        .Cr2 = 1325.5698F,
        .K = 6.7790885F,
        .sigma = 0.24384F,
        .Zf = 1005.2979F,
        .g = 9.81456F
    }
};

motorcycle_validity_t motorcycle_f32_validate(const motorcycle_f32_t *p)
{
    motorcycle_validity_t validity = MOTORCYCLE_VALID;
    if (!((p->Mf > 0.0F) && (p->Mf <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Mf;
    } else if (!((p->Mr > 0.0F) && (p->Mr <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Mr;
    } else if (!((p->Irx >= 0.0F) && (p->Irx <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Irx;
    } else if (!((p->Irz >= 0.0F) && (p->Irz <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Irz;
    } else if (!((p->Crxz >= -FLT_MAX) && (p->Crxz <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Crxz;
    } else if (!((p->Ifx >= 0.0F) && (p->Ifx <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Ifx;
    } else if (!((p->Ifz >= 0.0F) && (p->Ifz <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Ifz;
    } else if (!((p->ify >= 0.0F) && (p->ify <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_ify;
    } else if (!((p->iry >= 0.0F) && (p->iry <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_iry;
    } else if (!((p->a > 0.0F) && (p->a <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_a;
    } else if (!((p->b > 0.0F) && (p->b <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_b;
    } else if (!((p->e >= -FLT_MAX) && (p->e <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_e;
    } else if (!((p->f >= -FLT_MAX) && (p->f <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_f;
    } else if (!((p->h > 0.0F) && (p->h <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_h;
    } else if (!((p->Rf > 0.0F) && (p->Rf <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Rf;
    } else if (!((p->Rr > 0.0F) && (p->Rr <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Rr;
    } else if (!((p->t >= -FLT_MAX) && (p->t <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_t;
    } else if (!((p->eps > (-1.5707964F)) && (p->eps < 1.5707964F))) {
        validity = MOTORCYCLE_INVALID_eps;
    } else if (!((p->Cf1 > 0.0F) && (p->Cf1 <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Cf1;
    } else if (!((p->Cf2 >= 0.0F) && (p->Cf2 <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Cf2;
    } else if (!((p->Cr1 > 0.0F) && (p->Cr1 <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Cr1;
    } else if (!((p->Cr2 >= 0.0F) && (p->Cr2 <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Cr2;
    } else if (!((p->K >= 0.0F) && (p->K <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_K;
    } else if (!((p->sigma > 0.0F) && (p->sigma <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_sigma;
    } else if (!((p->Zf >= 0.0F) && (p->Zf <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_Zf;
    } else if (!((p->g > 0.0F) && (p->g <= FLT_MAX))) {
        validity = MOTORCYCLE_INVALID_g;
    } else {
        const float c = carvallo_cos_f32(p->eps);
        const float l = (p->a - p->t) / c;
        const float t7 = p->b + l;
        if (!((t7 > 0.0F) && (t7 <= FLT_MAX))) {
            validity = MOTORCYCLE_REQUIREMENT_1;
        } else {
            /* All requirements hold. */
        }
    }
    return validity;
}

void motorcycle_f32_matrices(const motorcycle_f32_t *p, motorcycle_f32_matrices_t *matrices)
{
    const float M_11 = p->Mf + p->Mr;
    float s = 0.0F;
    float cos_eps = 0.0F;
    carvallo_sin_cos_f32(p->eps, &s, &cos_eps);
    const float t10 = p->a + p->e;
    const float t12 = (cos_eps * t10) - (p->f * s);
    const float M_12 = p->Mf * t12;
    const float t15 = p->Mr * p->h;
    const float j = (p->f * cos_eps) + (s * t10);
    const float t19 = p->Mf * j;
    const float M_13 = t15 + t19;
    const float t21 = s * s;
    const float t22 = cos_eps * cos_eps;
    const float t25 = p->a - (t10 * (t21 + t22));
    const float t26 = p->Mf * t25;
    const float t34 = p->Ifz * t22;
    const float M_22 = p->Irz + (p->Ifx * t21) + ((t12 * M_12) + t34);
    const float t44 = t21 * p->Ifz;
    const float t45 = t34 + t44;
    const float M_24 = (cos_eps * t45) - (M_12 * t25);
    const float M_33 = t44 + ((p->Ifx * t22) + ((p->h * t15) + (p->Irx + (j * t19))));
    const float M_44 = p->Ifz + (t25 * t26);
    const float t63 = 1.0F / p->sigma;
    const float C0_55 = p->Cr1 * t63;
    const float C0_52 = C0_55 * p->b;
    const float C0_66 = t63 * p->Cf1;
    const float C0_64 = C0_66 * p->t;
    const float Kc_26 = ((p->a * C0_66) - C0_64) / cos_eps;
    const float h_spin_R = p->iry / p->Rr;
    const float h_spin_F = p->ify / p->Rf;
    const float h_wheels_all = h_spin_R + h_spin_F;
    const float t81 = s * h_spin_F;
    const float C1_32 = M_13 + h_wheels_all;
    const float C1_34 = cos_eps * h_spin_F;
    const float K0_34 = ((t26 * p->g) - (p->t * p->Zf)) / p->g;
    const float K0_44 = s * K0_34;
    const float K1_53 = t63 * p->Cr2;
    const float t94 = 1.0F / (p->sigma * p->sigma);
    const float K1_55 = p->Cr1 * t94;
    const float K1_63 = t63 * p->Cf2;
    const float K1_64 = (s * K1_63) + (cos_eps * C0_66);
    const float K1_66 = p->Cf1 * t94;
    const float M_14 = -t26;
    const float M_23 = (t12 * t19) - (p->Crxz + (cos_eps * (s * (p->Ifx - p->Ifz))));
    const float M_34 = (s * t45) - (j * t26);
    const float C0_51 = -C0_55;
    const float C0_61 = -C0_66;
    const float C0_62 = -Kc_26;
    const float C1_23 = -h_wheels_all;
    const float C1_24 = -t81;
    const float C1_42 = t81 - t26;
    const float C1_43 = -C1_34;
    const float Kc_25 = -C0_52;
    const float Kc_46 = -C0_64;
    const float K0_33 = -M_13;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[0][3] = M_14;
    matrices->m[0][4] = 0.0F;
    matrices->m[0][5] = 0.0F;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = M_23;
    matrices->m[1][3] = M_24;
    matrices->m[1][4] = 0.0F;
    matrices->m[1][5] = 0.0F;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_23;
    matrices->m[2][2] = M_33;
    matrices->m[2][3] = M_34;
    matrices->m[2][4] = 0.0F;
    matrices->m[2][5] = 0.0F;
    matrices->m[3][0] = M_14;
    matrices->m[3][1] = M_24;
    matrices->m[3][2] = M_34;
    matrices->m[3][3] = M_44;
    matrices->m[3][4] = 0.0F;
    matrices->m[3][5] = 0.0F;
    matrices->m[4][0] = 0.0F;
    matrices->m[4][1] = 0.0F;
    matrices->m[4][2] = 0.0F;
    matrices->m[4][3] = 0.0F;
    matrices->m[4][4] = 0.0F;
    matrices->m[4][5] = 0.0F;
    matrices->m[5][0] = 0.0F;
    matrices->m[5][1] = 0.0F;
    matrices->m[5][2] = 0.0F;
    matrices->m[5][3] = 0.0F;
    matrices->m[5][4] = 0.0F;
    matrices->m[5][5] = 0.0F;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[0][2] = 0.0F;
    matrices->c0[0][3] = 0.0F;
    matrices->c0[0][4] = 0.0F;
    matrices->c0[0][5] = 0.0F;
    matrices->c0[1][0] = 0.0F;
    matrices->c0[1][1] = 0.0F;
    matrices->c0[1][2] = 0.0F;
    matrices->c0[1][3] = 0.0F;
    matrices->c0[1][4] = 0.0F;
    matrices->c0[1][5] = 0.0F;
    matrices->c0[2][0] = 0.0F;
    matrices->c0[2][1] = 0.0F;
    matrices->c0[2][2] = 0.0F;
    matrices->c0[2][3] = 0.0F;
    matrices->c0[2][4] = 0.0F;
    matrices->c0[2][5] = 0.0F;
    matrices->c0[3][0] = 0.0F;
    matrices->c0[3][1] = 0.0F;
    matrices->c0[3][2] = 0.0F;
    matrices->c0[3][3] = p->K;
    matrices->c0[3][4] = 0.0F;
    matrices->c0[3][5] = 0.0F;
    matrices->c0[4][0] = C0_51;
    matrices->c0[4][1] = C0_52;
    matrices->c0[4][2] = 0.0F;
    matrices->c0[4][3] = 0.0F;
    matrices->c0[4][4] = C0_55;
    matrices->c0[4][5] = 0.0F;
    matrices->c0[5][0] = C0_61;
    matrices->c0[5][1] = C0_62;
    matrices->c0[5][2] = 0.0F;
    matrices->c0[5][3] = C0_64;
    matrices->c0[5][4] = 0.0F;
    matrices->c0[5][5] = C0_66;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = M_11;
    matrices->c1[0][2] = 0.0F;
    matrices->c1[0][3] = 0.0F;
    matrices->c1[0][4] = 0.0F;
    matrices->c1[0][5] = 0.0F;
    matrices->c1[1][0] = 0.0F;
    matrices->c1[1][1] = M_12;
    matrices->c1[1][2] = C1_23;
    matrices->c1[1][3] = C1_24;
    matrices->c1[1][4] = 0.0F;
    matrices->c1[1][5] = 0.0F;
    matrices->c1[2][0] = 0.0F;
    matrices->c1[2][1] = C1_32;
    matrices->c1[2][2] = 0.0F;
    matrices->c1[2][3] = C1_34;
    matrices->c1[2][4] = 0.0F;
    matrices->c1[2][5] = 0.0F;
    matrices->c1[3][0] = 0.0F;
    matrices->c1[3][1] = C1_42;
    matrices->c1[3][2] = C1_43;
    matrices->c1[3][3] = 0.0F;
    matrices->c1[3][4] = 0.0F;
    matrices->c1[3][5] = 0.0F;
    matrices->c1[4][0] = 0.0F;
    matrices->c1[4][1] = 0.0F;
    matrices->c1[4][2] = 0.0F;
    matrices->c1[4][3] = 0.0F;
    matrices->c1[4][4] = 0.0F;
    matrices->c1[4][5] = 0.0F;
    matrices->c1[5][0] = 0.0F;
    matrices->c1[5][1] = 0.0F;
    matrices->c1[5][2] = 0.0F;
    matrices->c1[5][3] = 0.0F;
    matrices->c1[5][4] = 0.0F;
    matrices->c1[5][5] = 0.0F;
    matrices->kc[0][0] = 0.0F;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[0][2] = 0.0F;
    matrices->kc[0][3] = 0.0F;
    matrices->kc[0][4] = C0_55;
    matrices->kc[0][5] = C0_66;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = 0.0F;
    matrices->kc[1][2] = 0.0F;
    matrices->kc[1][3] = 0.0F;
    matrices->kc[1][4] = Kc_25;
    matrices->kc[1][5] = Kc_26;
    matrices->kc[2][0] = 0.0F;
    matrices->kc[2][1] = 0.0F;
    matrices->kc[2][2] = 0.0F;
    matrices->kc[2][3] = 0.0F;
    matrices->kc[2][4] = 0.0F;
    matrices->kc[2][5] = 0.0F;
    matrices->kc[3][0] = 0.0F;
    matrices->kc[3][1] = 0.0F;
    matrices->kc[3][2] = 0.0F;
    matrices->kc[3][3] = 0.0F;
    matrices->kc[3][4] = 0.0F;
    matrices->kc[3][5] = Kc_46;
    matrices->kc[4][0] = 0.0F;
    matrices->kc[4][1] = 0.0F;
    matrices->kc[4][2] = 0.0F;
    matrices->kc[4][3] = 0.0F;
    matrices->kc[4][4] = 0.0F;
    matrices->kc[4][5] = 0.0F;
    matrices->kc[5][0] = 0.0F;
    matrices->kc[5][1] = 0.0F;
    matrices->kc[5][2] = 0.0F;
    matrices->kc[5][3] = 0.0F;
    matrices->kc[5][4] = 0.0F;
    matrices->kc[5][5] = 0.0F;
    matrices->k0[0][0] = 0.0F;
    matrices->k0[0][1] = 0.0F;
    matrices->k0[0][2] = 0.0F;
    matrices->k0[0][3] = 0.0F;
    matrices->k0[0][4] = 0.0F;
    matrices->k0[0][5] = 0.0F;
    matrices->k0[1][0] = 0.0F;
    matrices->k0[1][1] = 0.0F;
    matrices->k0[1][2] = 0.0F;
    matrices->k0[1][3] = 0.0F;
    matrices->k0[1][4] = 0.0F;
    matrices->k0[1][5] = 0.0F;
    matrices->k0[2][0] = 0.0F;
    matrices->k0[2][1] = 0.0F;
    matrices->k0[2][2] = K0_33;
    matrices->k0[2][3] = K0_34;
    matrices->k0[2][4] = 0.0F;
    matrices->k0[2][5] = 0.0F;
    matrices->k0[3][0] = 0.0F;
    matrices->k0[3][1] = 0.0F;
    matrices->k0[3][2] = K0_34;
    matrices->k0[3][3] = K0_44;
    matrices->k0[3][4] = 0.0F;
    matrices->k0[3][5] = 0.0F;
    matrices->k0[4][0] = 0.0F;
    matrices->k0[4][1] = 0.0F;
    matrices->k0[4][2] = 0.0F;
    matrices->k0[4][3] = 0.0F;
    matrices->k0[4][4] = 0.0F;
    matrices->k0[4][5] = 0.0F;
    matrices->k0[5][0] = 0.0F;
    matrices->k0[5][1] = 0.0F;
    matrices->k0[5][2] = 0.0F;
    matrices->k0[5][3] = 0.0F;
    matrices->k0[5][4] = 0.0F;
    matrices->k0[5][5] = 0.0F;
    matrices->k1[0][0] = 0.0F;
    matrices->k1[0][1] = 0.0F;
    matrices->k1[0][2] = 0.0F;
    matrices->k1[0][3] = 0.0F;
    matrices->k1[0][4] = 0.0F;
    matrices->k1[0][5] = 0.0F;
    matrices->k1[1][0] = 0.0F;
    matrices->k1[1][1] = 0.0F;
    matrices->k1[1][2] = 0.0F;
    matrices->k1[1][3] = 0.0F;
    matrices->k1[1][4] = 0.0F;
    matrices->k1[1][5] = 0.0F;
    matrices->k1[2][0] = 0.0F;
    matrices->k1[2][1] = 0.0F;
    matrices->k1[2][2] = 0.0F;
    matrices->k1[2][3] = 0.0F;
    matrices->k1[2][4] = 0.0F;
    matrices->k1[2][5] = 0.0F;
    matrices->k1[3][0] = 0.0F;
    matrices->k1[3][1] = 0.0F;
    matrices->k1[3][2] = 0.0F;
    matrices->k1[3][3] = 0.0F;
    matrices->k1[3][4] = 0.0F;
    matrices->k1[3][5] = 0.0F;
    matrices->k1[4][0] = 0.0F;
    matrices->k1[4][1] = 0.0F;
    matrices->k1[4][2] = K1_53;
    matrices->k1[4][3] = 0.0F;
    matrices->k1[4][4] = K1_55;
    matrices->k1[4][5] = 0.0F;
    matrices->k1[5][0] = 0.0F;
    matrices->k1[5][1] = 0.0F;
    matrices->k1[5][2] = K1_63;
    matrices->k1[5][3] = K1_64;
    matrices->k1[5][4] = 0.0F;
    matrices->k1[5][5] = K1_66;
}

carvallo_system_error_t motorcycle_f32_at_speed(const motorcycle_f32_matrices_t *matrices,
    float speed, float gravity, motorcycle_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed) && carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < MOTORCYCLE_N; row++) {
        for (size_t column = 0U; column < MOTORCYCLE_N; column++) {
            const float damping = matrices->c0[row][column] + (matrices->c1[row][column] * speed);
            const float stiffness = matrices->kc[row][column] + (matrices->k0[row][column] *
                gravity) + (matrices->k1[row][column] * speed);
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->c0[row][column]) &&
                carvallo_is_finite_f32(matrices->c1[row][column]) &&
                carvallo_is_finite_f32(matrices->kc[row][column]) &&
                carvallo_is_finite_f32(matrices->k0[row][column]) &&
                carvallo_is_finite_f32(matrices->k1[row][column]);
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

carvallo_system_error_t motorcycle_f32_state_space(const motorcycle_f32_system_t *system,
    motorcycle_f32_state_space_t *space)
{
    /* The row of A and B for each coordinate, and whether its position is a state beside its rate. */
    static const size_t TARGETS[MOTORCYCLE_N] = {MOTORCYCLE_N + 0U, MOTORCYCLE_N + 1U, MOTORCYCLE_N + 2U, MOTORCYCLE_N + 3U, 4U, 5U};
    static const bool HAS_BOTH[MOTORCYCLE_N] = {false, false, true, true, false, false};
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[MOTORCYCLE_N * MOTORCYCLE_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * MOTORCYCLE_N * MOTORCYCLE_N];
    for (size_t row = 0U; row < MOTORCYCLE_N; row++) {
        float *const solved = &x[3U * MOTORCYCLE_N * row];
        for (size_t column = 0U; column < MOTORCYCLE_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * MOTORCYCLE_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[MOTORCYCLE_N + column] = -system->c[row][column];
            solved[(2U * MOTORCYCLE_N) + column] = 0.0F;
        }
        solved[(2U * MOTORCYCLE_N) + row] = 1.0F;
        solved[0] = 0.0F;
        solved[1] = 0.0F;
        m[(row * MOTORCYCLE_N) + 4U] = system->c[row][4];
        solved[MOTORCYCLE_N + 4U] = 0.0F;
        m[(row * MOTORCYCLE_N) + 5U] = system->c[row][5];
        solved[MOTORCYCLE_N + 5U] = 0.0F;
    }
    if (is_finite) {
        float terms[MOTORCYCLE_N * MOTORCYCLE_N];
        error = carvallo_solve_f32(MOTORCYCLE_N, m, terms, 3U * MOTORCYCLE_N, x);
    }
    for (size_t row = 0U; row < (2U * MOTORCYCLE_N); row++) {
        for (size_t column = 0U; column < (2U * MOTORCYCLE_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < MOTORCYCLE_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < MOTORCYCLE_N; row++) {
            const size_t target = TARGETS[row];
            for (size_t column = 0U; column < (2U * MOTORCYCLE_N); column++) {
                space->a[target][column] = x[(3U * MOTORCYCLE_N * row) + column];
            }
            for (size_t column = 0U; column < MOTORCYCLE_N; column++) {
                space->b[target][column] = x[(3U * MOTORCYCLE_N * row) + (2U * MOTORCYCLE_N) +
                    column];
            }
            if (HAS_BOTH[row]) {
                space->a[row][MOTORCYCLE_N + row] = 1.0F;
            }
        }
    }
    return error;
}

float motorcycle_f32_rate_at(const motorcycle_f32_rate_t *rate, float v,
    const float q[MOTORCYCLE_N], const float q_dot[MOTORCYCLE_N], float psi)
{
    float by_coordinates = 0.0F;
    float by_rates = 0.0F;
    for (size_t i = 0U; i < MOTORCYCLE_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void motorcycle_f32_kinematics(const motorcycle_f32_t *p, motorcycle_f32_kinematics_t *kinematics)
{
    const float t6 = -(1.0F / p->Rr);
    const float t7 = -(1.0F / p->Rf);
    kinematics->wheel_R.speed = t6;
    kinematics->wheel_R.rates[0] = 0.0F;
    kinematics->wheel_R.rates[1] = 0.0F;
    kinematics->wheel_R.rates[2] = 0.0F;
    kinematics->wheel_R.rates[3] = 0.0F;
    kinematics->wheel_R.rates[4] = 0.0F;
    kinematics->wheel_R.rates[5] = 0.0F;
    kinematics->wheel_R.coordinates[0] = 0.0F;
    kinematics->wheel_R.coordinates[1] = 0.0F;
    kinematics->wheel_R.coordinates[2] = 0.0F;
    kinematics->wheel_R.coordinates[3] = 0.0F;
    kinematics->wheel_R.coordinates[4] = 0.0F;
    kinematics->wheel_R.coordinates[5] = 0.0F;
    kinematics->wheel_R.heading = 0.0F;
    kinematics->wheel_F.speed = t7;
    kinematics->wheel_F.rates[0] = 0.0F;
    kinematics->wheel_F.rates[1] = 0.0F;
    kinematics->wheel_F.rates[2] = 0.0F;
    kinematics->wheel_F.rates[3] = 0.0F;
    kinematics->wheel_F.rates[4] = 0.0F;
    kinematics->wheel_F.rates[5] = 0.0F;
    kinematics->wheel_F.coordinates[0] = 0.0F;
    kinematics->wheel_F.coordinates[1] = 0.0F;
    kinematics->wheel_F.coordinates[2] = 0.0F;
    kinematics->wheel_F.coordinates[3] = 0.0F;
    kinematics->wheel_F.coordinates[4] = 0.0F;
    kinematics->wheel_F.coordinates[5] = 0.0F;
    kinematics->wheel_F.heading = 0.0F;
    kinematics->forces[0][0] = 0.0F;
    kinematics->forces[1][0] = 0.0F;
    kinematics->forces[2][0] = 0.0F;
    kinematics->forces[3][0] = 1.0F;
    kinematics->forces[4][0] = 0.0F;
    kinematics->forces[5][0] = 0.0F;
}

void motorcycle_f32_derivatives(const motorcycle_f32_t *p, motorcycle_f32_matrices_t *matrices,
    motorcycle_f32_derivatives_t *derivatives)
{
    float s = 0.0F;
    float s_eps = 0.0F;
    carvallo_sin_cos_f32(p->eps, &s, &s_eps);
    const float M_11 = p->Mf + p->Mr;
    const float t32 = p->a + p->e;
    const float t33 = p->Mr * p->h;
    const float C0_66_Cf1 = 1.0F / p->sigma;
    const float C1_32_ify = 1.0F / p->Rf;
    const float C1_32_iry = 1.0F / p->Rr;
    const float M_33_Mr = p->h * p->h;
    const float M_33_h = t33 + t33;
    const float C0_64_Cf1 = C0_66_Cf1 * p->t;
    const float C0_55 = p->Cr1 * C0_66_Cf1;
    const float C0_52_Cr1 = C0_66_Cf1 * p->b;
    const float C0_66 = C0_66_Cf1 * p->Cf1;
    const float h_spin_F = p->ify * C1_32_ify;
    const float t44 = p->iry * C1_32_iry;
    const float t45 = 1.0F / p->g;
    const float K1_53 = C0_66_Cf1 * p->Cr2;
    const float t47 = p->sigma * p->sigma;
    const float K1_66_Cf1 = 1.0F / t47;
    const float t49 = C0_66_Cf1 * K1_53;
    const float C0_52 = p->Cr1 * C0_52_Cr1;
    const float C1_23_Rr = C1_32_iry * t44;
    const float h_wheels_all = h_spin_F + t44;
    const float C0_61_sigma = C0_66_Cf1 * C0_66;
    const float t55 = 1.0F / (p->sigma * t47);
    const float C0_51 = -C0_55;
    const float C0_51_sigma = C0_66_Cf1 * C0_55;
    const float C0_61 = -C0_66;
    const float Kc_25_sigma = p->b * C0_51_sigma;
    const float Kc_25 = -C0_52;
    const float C1_23 = -h_wheels_all;
    const float K1_55 = p->Cr1 * K1_66_Cf1;
    const float K1_66 = p->Cf1 * K1_66_Cf1;
    const float C0_64 = C0_66 * p->t;
    const float Kc_46_sigma = C0_66_Cf1 * C0_64;
    const float Kc_46 = -C0_64;
    const float t67 = p->g * t45;
    const float t68 = p->t * t45;
    const float K1_63 = C0_66_Cf1 * p->Cf2;
    const float t70 = C0_66_Cf1 * K1_63;
    const float C1_23_Rf = C1_32_ify * h_spin_F;
    const float t72 = t55 + t55;
    const float t73 = t45 * p->Zf;
    const float t74 = p->Cr1 * t72;
    const float t75 = p->Cf1 * t72;
    const float t76 = s * p->f;
    const float t77 = s_eps * t32;
    const float j = (p->f * s_eps) + (s * t32);
    const float M_22_Ifx = s * s;
    const float M_33_Ifx = s_eps * s_eps;
    const float M_23_Ifz = s * s_eps;
    const float t84 = 1.0F / s_eps;
    const float C1_42_ify = s * C1_32_ify;
    const float C1_34 = s_eps * h_spin_F;
    const float K1_64 = (s * K1_63) + (s_eps * C0_66);
    const float C1_34_ify = s_eps * C1_32_ify;
    const float C1_43_Rf = s_eps * C1_23_Rf;
    const float t92 = s * t73;
    const float K1_64_Cf1 = s_eps * C0_66_Cf1;
    const float t94 = s * t68;
    const float M_12_a = p->Mf * s_eps;
    const float M_13_a = p->Mf * s;
    const float K1_64_Cf2 = s * C0_66_Cf1;
    const float t98 = t76 - t77;
    const float K1_64_eps = (s_eps * K1_63) - (p->Cf1 * K1_64_Cf2);
    const float M_12_Mf = t77 - t76;
    const float C1_24_Rf = h_spin_F * C1_42_ify;
    const float C1_43 = -C1_34;
    const float C1_43_eps = p->ify * C1_42_ify;
    const float t106 = M_22_Ifx + M_33_Ifx;
    const float K0_33_eps = p->Mf * t98;
    const float t108 = p->Mf * j;
    const float t109 = C0_66_Cf1 * K1_64;
    const float t110 = t32 * t106;
    const float M_33_Mf = j * j;
    const float t112 = j * M_12_a;
    const float C1_24 = -C1_43_eps;
    const float M_22_Mf = t98 * t98;
    const float t115 = t98 * j;
    const float Kc_26_Cf1 = C0_66_Cf1 * t84 * (p->a - p->t);
    const float t122 = (M_23_Ifz * (p->Ifx - p->Ifz)) + (p->Mf * t115);
    const float t127 = (p->Mf * M_22_Mf) + (M_33_Ifx * p->Ifz) + (M_22_Ifx * p->Ifx);
    const float t132 = (j * t108) + (M_33_Ifx * p->Ifx) + (M_22_Ifx * p->Ifz);
    const float Kc_26_a = C0_66 * t84;
    const float M_33_f = t112 + t112;
    const float M_12 = -K0_33_eps;
    const float C0_62_sigma = C0_66 * Kc_26_Cf1;
    const float Kc_26 = p->Cf1 * Kc_26_Cf1;
    const float M_14_Mf = t110 - p->a;
    const float t139 = p->a - t110;
    const float M_24_Mf = t98 * t139;
    const float t141 = j * t139;
    const float M_13 = t33 + t108;
    const float C1_32 = M_13 + h_wheels_all;
    const float K0_33 = -M_13;
    const float t145 = p->Mf * t139;
    const float C1_42 = C1_43_eps - t145;
    const float Kc_26_eps = s * t84 * Kc_26;
    const float M_33 = p->Irx + t132 + (p->h * t33);
    const float M_23_eps = t127 - t132;
    const float M_22 = p->Irz + t127;
    const float C0_62 = -Kc_26;
    const float t156 = t106 * (t145 + t145);
    const float M_22_eps = t122 + t122;
    const float M_23 = -(p->Crxz + t122);
    const float M_14 = -t145;
    const float M_24_Ifz = s_eps * t106;
    const float M_24 = (p->Ifz * M_24_Ifz) + (K0_33_eps * t139);
    const float M_34_Ifz = s * t106;
    const float t166 = p->Ifz * M_34_Ifz;
    const float t167 = j * t145;
    const float M_34 = t166 - t167;
    const float M_24_eps = t167 - t166;
    const float t170 = j * M_13_a;
    const float t171 = t98 * M_13_a;
    const float M_23_a = t112 - t171;
    const float M_22_f = t171 + t171;
    const float M_33_a = t170 + t170;
    const float M_44_Mf = t139 * t139;
    const float M_44 = p->Ifz + (p->Mf * M_44_Mf);
    const float K0_34_Mf = t139 * t67;
    const float K0_34 = (p->Mf * K0_34_Mf) - (p->Zf * t68);
    const float K0_44_Mf = s * K0_34_Mf;
    const float t183 = s_eps * K0_33_eps;
    const float t184 = t183 + t170;
    const float t185 = t183 + t183;
    const float K0_44 = s * K0_34;
    const float K0_44_eps = s_eps * K0_34;
    const float K0_34_g = t45 * (t145 - K0_34);
    const float M_14_e = p->Mf * t106;
    const float t191 = t67 * M_14_e;
    const float t192 = s * t191;
    const float t193 = s_eps * t145;
    const float t195 = (t98 * M_14_e) + t193;
    const float M_24_f = s * t145;
    const float M_34_e = (t108 * t106) - M_24_f;
    const float M_24_a = K0_33_eps - t195;
    const float M_34_a = M_34_e - t108;
    const float K0_44_g = s * K0_34_g;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[0][3] = M_14;
    matrices->m[0][4] = 0.0F;
    matrices->m[0][5] = 0.0F;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = M_23;
    matrices->m[1][3] = M_24;
    matrices->m[1][4] = 0.0F;
    matrices->m[1][5] = 0.0F;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_23;
    matrices->m[2][2] = M_33;
    matrices->m[2][3] = M_34;
    matrices->m[2][4] = 0.0F;
    matrices->m[2][5] = 0.0F;
    matrices->m[3][0] = M_14;
    matrices->m[3][1] = M_24;
    matrices->m[3][2] = M_34;
    matrices->m[3][3] = M_44;
    matrices->m[3][4] = 0.0F;
    matrices->m[3][5] = 0.0F;
    matrices->m[4][0] = 0.0F;
    matrices->m[4][1] = 0.0F;
    matrices->m[4][2] = 0.0F;
    matrices->m[4][3] = 0.0F;
    matrices->m[4][4] = 0.0F;
    matrices->m[4][5] = 0.0F;
    matrices->m[5][0] = 0.0F;
    matrices->m[5][1] = 0.0F;
    matrices->m[5][2] = 0.0F;
    matrices->m[5][3] = 0.0F;
    matrices->m[5][4] = 0.0F;
    matrices->m[5][5] = 0.0F;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[0][2] = 0.0F;
    matrices->c0[0][3] = 0.0F;
    matrices->c0[0][4] = 0.0F;
    matrices->c0[0][5] = 0.0F;
    matrices->c0[1][0] = 0.0F;
    matrices->c0[1][1] = 0.0F;
    matrices->c0[1][2] = 0.0F;
    matrices->c0[1][3] = 0.0F;
    matrices->c0[1][4] = 0.0F;
    matrices->c0[1][5] = 0.0F;
    matrices->c0[2][0] = 0.0F;
    matrices->c0[2][1] = 0.0F;
    matrices->c0[2][2] = 0.0F;
    matrices->c0[2][3] = 0.0F;
    matrices->c0[2][4] = 0.0F;
    matrices->c0[2][5] = 0.0F;
    matrices->c0[3][0] = 0.0F;
    matrices->c0[3][1] = 0.0F;
    matrices->c0[3][2] = 0.0F;
    matrices->c0[3][3] = p->K;
    matrices->c0[3][4] = 0.0F;
    matrices->c0[3][5] = 0.0F;
    matrices->c0[4][0] = C0_51;
    matrices->c0[4][1] = C0_52;
    matrices->c0[4][2] = 0.0F;
    matrices->c0[4][3] = 0.0F;
    matrices->c0[4][4] = C0_55;
    matrices->c0[4][5] = 0.0F;
    matrices->c0[5][0] = C0_61;
    matrices->c0[5][1] = C0_62;
    matrices->c0[5][2] = 0.0F;
    matrices->c0[5][3] = C0_64;
    matrices->c0[5][4] = 0.0F;
    matrices->c0[5][5] = C0_66;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = M_11;
    matrices->c1[0][2] = 0.0F;
    matrices->c1[0][3] = 0.0F;
    matrices->c1[0][4] = 0.0F;
    matrices->c1[0][5] = 0.0F;
    matrices->c1[1][0] = 0.0F;
    matrices->c1[1][1] = M_12;
    matrices->c1[1][2] = C1_23;
    matrices->c1[1][3] = C1_24;
    matrices->c1[1][4] = 0.0F;
    matrices->c1[1][5] = 0.0F;
    matrices->c1[2][0] = 0.0F;
    matrices->c1[2][1] = C1_32;
    matrices->c1[2][2] = 0.0F;
    matrices->c1[2][3] = C1_34;
    matrices->c1[2][4] = 0.0F;
    matrices->c1[2][5] = 0.0F;
    matrices->c1[3][0] = 0.0F;
    matrices->c1[3][1] = C1_42;
    matrices->c1[3][2] = C1_43;
    matrices->c1[3][3] = 0.0F;
    matrices->c1[3][4] = 0.0F;
    matrices->c1[3][5] = 0.0F;
    matrices->c1[4][0] = 0.0F;
    matrices->c1[4][1] = 0.0F;
    matrices->c1[4][2] = 0.0F;
    matrices->c1[4][3] = 0.0F;
    matrices->c1[4][4] = 0.0F;
    matrices->c1[4][5] = 0.0F;
    matrices->c1[5][0] = 0.0F;
    matrices->c1[5][1] = 0.0F;
    matrices->c1[5][2] = 0.0F;
    matrices->c1[5][3] = 0.0F;
    matrices->c1[5][4] = 0.0F;
    matrices->c1[5][5] = 0.0F;
    matrices->kc[0][0] = 0.0F;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[0][2] = 0.0F;
    matrices->kc[0][3] = 0.0F;
    matrices->kc[0][4] = C0_55;
    matrices->kc[0][5] = C0_66;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = 0.0F;
    matrices->kc[1][2] = 0.0F;
    matrices->kc[1][3] = 0.0F;
    matrices->kc[1][4] = Kc_25;
    matrices->kc[1][5] = Kc_26;
    matrices->kc[2][0] = 0.0F;
    matrices->kc[2][1] = 0.0F;
    matrices->kc[2][2] = 0.0F;
    matrices->kc[2][3] = 0.0F;
    matrices->kc[2][4] = 0.0F;
    matrices->kc[2][5] = 0.0F;
    matrices->kc[3][0] = 0.0F;
    matrices->kc[3][1] = 0.0F;
    matrices->kc[3][2] = 0.0F;
    matrices->kc[3][3] = 0.0F;
    matrices->kc[3][4] = 0.0F;
    matrices->kc[3][5] = Kc_46;
    matrices->kc[4][0] = 0.0F;
    matrices->kc[4][1] = 0.0F;
    matrices->kc[4][2] = 0.0F;
    matrices->kc[4][3] = 0.0F;
    matrices->kc[4][4] = 0.0F;
    matrices->kc[4][5] = 0.0F;
    matrices->kc[5][0] = 0.0F;
    matrices->kc[5][1] = 0.0F;
    matrices->kc[5][2] = 0.0F;
    matrices->kc[5][3] = 0.0F;
    matrices->kc[5][4] = 0.0F;
    matrices->kc[5][5] = 0.0F;
    matrices->k0[0][0] = 0.0F;
    matrices->k0[0][1] = 0.0F;
    matrices->k0[0][2] = 0.0F;
    matrices->k0[0][3] = 0.0F;
    matrices->k0[0][4] = 0.0F;
    matrices->k0[0][5] = 0.0F;
    matrices->k0[1][0] = 0.0F;
    matrices->k0[1][1] = 0.0F;
    matrices->k0[1][2] = 0.0F;
    matrices->k0[1][3] = 0.0F;
    matrices->k0[1][4] = 0.0F;
    matrices->k0[1][5] = 0.0F;
    matrices->k0[2][0] = 0.0F;
    matrices->k0[2][1] = 0.0F;
    matrices->k0[2][2] = K0_33;
    matrices->k0[2][3] = K0_34;
    matrices->k0[2][4] = 0.0F;
    matrices->k0[2][5] = 0.0F;
    matrices->k0[3][0] = 0.0F;
    matrices->k0[3][1] = 0.0F;
    matrices->k0[3][2] = K0_34;
    matrices->k0[3][3] = K0_44;
    matrices->k0[3][4] = 0.0F;
    matrices->k0[3][5] = 0.0F;
    matrices->k0[4][0] = 0.0F;
    matrices->k0[4][1] = 0.0F;
    matrices->k0[4][2] = 0.0F;
    matrices->k0[4][3] = 0.0F;
    matrices->k0[4][4] = 0.0F;
    matrices->k0[4][5] = 0.0F;
    matrices->k0[5][0] = 0.0F;
    matrices->k0[5][1] = 0.0F;
    matrices->k0[5][2] = 0.0F;
    matrices->k0[5][3] = 0.0F;
    matrices->k0[5][4] = 0.0F;
    matrices->k0[5][5] = 0.0F;
    matrices->k1[0][0] = 0.0F;
    matrices->k1[0][1] = 0.0F;
    matrices->k1[0][2] = 0.0F;
    matrices->k1[0][3] = 0.0F;
    matrices->k1[0][4] = 0.0F;
    matrices->k1[0][5] = 0.0F;
    matrices->k1[1][0] = 0.0F;
    matrices->k1[1][1] = 0.0F;
    matrices->k1[1][2] = 0.0F;
    matrices->k1[1][3] = 0.0F;
    matrices->k1[1][4] = 0.0F;
    matrices->k1[1][5] = 0.0F;
    matrices->k1[2][0] = 0.0F;
    matrices->k1[2][1] = 0.0F;
    matrices->k1[2][2] = 0.0F;
    matrices->k1[2][3] = 0.0F;
    matrices->k1[2][4] = 0.0F;
    matrices->k1[2][5] = 0.0F;
    matrices->k1[3][0] = 0.0F;
    matrices->k1[3][1] = 0.0F;
    matrices->k1[3][2] = 0.0F;
    matrices->k1[3][3] = 0.0F;
    matrices->k1[3][4] = 0.0F;
    matrices->k1[3][5] = 0.0F;
    matrices->k1[4][0] = 0.0F;
    matrices->k1[4][1] = 0.0F;
    matrices->k1[4][2] = K1_53;
    matrices->k1[4][3] = 0.0F;
    matrices->k1[4][4] = K1_55;
    matrices->k1[4][5] = 0.0F;
    matrices->k1[5][0] = 0.0F;
    matrices->k1[5][1] = 0.0F;
    matrices->k1[5][2] = K1_63;
    matrices->k1[5][3] = K1_64;
    matrices->k1[5][4] = 0.0F;
    matrices->k1[5][5] = K1_66;
    derivatives->values[0] = p->Mr;
    derivatives->values[1] = p->h;
    derivatives->values[2] = 1.0F;
    derivatives->values[3] = (-1.0F);
    derivatives->values[4] = C0_66_Cf1;
    derivatives->values[5] = C1_32_ify;
    derivatives->values[6] = C1_32_iry;
    derivatives->values[7] = M_33_Mr;
    derivatives->values[8] = M_33_h;
    derivatives->values[9] = C0_64_Cf1;
    derivatives->values[10] = C0_55;
    derivatives->values[11] = C0_52_Cr1;
    derivatives->values[12] = C0_66;
    derivatives->values[13] = K1_66_Cf1;
    derivatives->values[14] = t49;
    derivatives->values[15] = C1_23_Rr;
    derivatives->values[16] = C0_61_sigma;
    derivatives->values[17] = C0_51_sigma;
    derivatives->values[18] = Kc_25_sigma;
    derivatives->values[19] = Kc_46_sigma;
    derivatives->values[20] = t68;
    derivatives->values[21] = t70;
    derivatives->values[22] = C1_23_Rf;
    derivatives->values[23] = t73;
    derivatives->values[24] = t74;
    derivatives->values[25] = t75;
    derivatives->values[26] = j;
    derivatives->values[27] = M_22_Ifx;
    derivatives->values[28] = M_33_Ifx;
    derivatives->values[29] = M_23_Ifz;
    derivatives->values[30] = C1_42_ify;
    derivatives->values[31] = C1_34;
    derivatives->values[32] = C1_34_ify;
    derivatives->values[33] = C1_43_Rf;
    derivatives->values[34] = t92;
    derivatives->values[35] = K1_64_Cf1;
    derivatives->values[36] = t94;
    derivatives->values[37] = M_12_a;
    derivatives->values[38] = M_13_a;
    derivatives->values[39] = K1_64_Cf2;
    derivatives->values[40] = K1_64_eps;
    derivatives->values[41] = M_12_Mf;
    derivatives->values[42] = C1_24_Rf;
    derivatives->values[43] = C1_43_eps;
    derivatives->values[44] = K0_33_eps;
    derivatives->values[45] = t108;
    derivatives->values[46] = t109;
    derivatives->values[47] = M_33_Mf;
    derivatives->values[48] = M_22_Mf;
    derivatives->values[49] = t115;
    derivatives->values[50] = Kc_26_Cf1;
    derivatives->values[51] = Kc_26_a;
    derivatives->values[52] = M_33_f;
    derivatives->values[53] = C0_62_sigma;
    derivatives->values[54] = M_14_Mf;
    derivatives->values[55] = M_24_Mf;
    derivatives->values[56] = t141;
    derivatives->values[57] = Kc_26_eps;
    derivatives->values[58] = M_23_eps;
    derivatives->values[59] = t156;
    derivatives->values[60] = M_22_eps;
    derivatives->values[61] = M_24_Ifz;
    derivatives->values[62] = M_24;
    derivatives->values[63] = M_34_Ifz;
    derivatives->values[64] = M_24_eps;
    derivatives->values[65] = M_23_a;
    derivatives->values[66] = M_22_f;
    derivatives->values[67] = M_33_a;
    derivatives->values[68] = M_44_Mf;
    derivatives->values[69] = K0_34_Mf;
    derivatives->values[70] = K0_44_Mf;
    derivatives->values[71] = t184;
    derivatives->values[72] = t185;
    derivatives->values[73] = K0_44_eps;
    derivatives->values[74] = K0_34_g;
    derivatives->values[75] = M_14_e;
    derivatives->values[76] = t191;
    derivatives->values[77] = t192;
    derivatives->values[78] = t193;
    derivatives->values[79] = t195;
    derivatives->values[80] = M_24_f;
    derivatives->values[81] = M_34_e;
    derivatives->values[82] = M_24_a;
    derivatives->values[83] = M_34_a;
    derivatives->values[84] = K0_44_g;
}

void motorcycle_f32_with_respect_to(const motorcycle_f32_derivatives_t *derivatives,
    size_t parameter, motorcycle_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < MOTORCYCLE_N; row++) {
        for (size_t column = 0U; column < MOTORCYCLE_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c0[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->kc[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
            matrices->k1[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < MOTORCYCLE_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &motorcycle_partials[position];
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
            case CARVALLO_MATRIX_K1:
                matrices->k1[partial->row][partial->column] = signed_value;
                break;
            default:
                /* The model has no other matrix. */
                break;
            }
        }
    }
}
