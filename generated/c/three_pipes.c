/* @generated from generated/models/three_pipes.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 92f4761ae2f6100e
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * inertia = (m + f)*l^3 [kg*m^2]
 * weight = (m + f)*l^2 [kg*m]
 * M_11 = 7/3*inertia [kg*m^2]
 * M_12 = M_21 = 3/2*inertia [kg*m^2]
 * M_13 = M_23 = M_31 = M_32 = 1/2*inertia [kg*m^2]
 * M_22 = 4/3*inertia [kg*m^2]
 * M_33 = 1/3*inertia [kg*m^2]
 * C0_11 = C0_22 = 2*c [kg*m^2/s]
 * C0_12 = C0_21 = C0_23 = C0_32 = -c [kg*m^2/s]
 * C0_33 = c [kg*m^2/s]
 * C1_11 = C1_22 = C1_33 = f*l^2 [kg*m]
 * C1_12 = C1_13 = C1_23 = 2*f*l^2 [kg*m]
 * Kc_11 = Kc_22 = 2*k [kg*m^2/s^2]
 * Kc_12 = Kc_21 = Kc_23 = Kc_32 = -k [kg*m^2/s^2]
 * Kc_33 = k [kg*m^2/s^2]
 * K0_11 = 5/2*weight [kg*m]
 * K0_22 = 3/2*weight [kg*m]
 * K0_33 = 1/2*weight [kg*m]
 * K2_11 = K2_22 = -f*l [kg]
 * K2_13 = K2_23 = f*l [kg]
 * @endverbatim
 */

#include "three_pipes.h"

#include <float.h>

const char *three_pipes_set_name(three_pipes_set_t set)
{
    static const char *const TEXTS[] = {
        "hose",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *three_pipes_validity_text(three_pipes_validity_t validity)
{
    static const char *const TEXTS[] = {
        "ThreePipes: the parameters are valid",
        "ThreePipes: l in m must be finite and > 0",
        "ThreePipes: m in kg/m must be finite and > 0",
        "ThreePipes: f in kg/m must be finite and >= 0",
        "ThreePipes: k in N*m/rad must be finite and >= 0",
        "ThreePipes: c in N*m*s/rad must be finite and >= 0",
        "ThreePipes: g in N/kg must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t three_pipes_partials[THREE_PIPES_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 14U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 15U, false},
    {CARVALLO_MATRIX_M, 0U, 2U, 0U, 16U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 15U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 17U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 0U, 16U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 0U, 16U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 0U, 16U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 0U, 9U, false},
    {CARVALLO_MATRIX_C1, 0U, 0U, 0U, 18U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 19U, false},
    {CARVALLO_MATRIX_C1, 0U, 2U, 0U, 19U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 0U, 18U, false},
    {CARVALLO_MATRIX_C1, 1U, 2U, 0U, 19U, false},
    {CARVALLO_MATRIX_C1, 2U, 2U, 0U, 18U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 0U, 10U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 11U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 0U, 7U, false},
    {CARVALLO_MATRIX_K2, 0U, 0U, 0U, 1U, true},
    {CARVALLO_MATRIX_K2, 0U, 2U, 0U, 1U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 1U, true},
    {CARVALLO_MATRIX_K2, 1U, 2U, 0U, 1U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 1U, 6U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 20U, false},
    {CARVALLO_MATRIX_M, 0U, 2U, 1U, 22U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 20U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 12U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 1U, 22U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 1U, 22U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 1U, 22U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 1U, 13U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 1U, 23U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 8U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 1U, 21U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 2U, 6U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 20U, false},
    {CARVALLO_MATRIX_M, 0U, 2U, 2U, 22U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 20U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 12U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 2U, 22U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 2U, 22U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 2U, 22U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 2U, 13U, false},
    {CARVALLO_MATRIX_C1, 0U, 0U, 2U, 5U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 24U, false},
    {CARVALLO_MATRIX_C1, 0U, 2U, 2U, 24U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 2U, 5U, false},
    {CARVALLO_MATRIX_C1, 1U, 2U, 2U, 24U, false},
    {CARVALLO_MATRIX_C1, 2U, 2U, 2U, 5U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 2U, 23U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 2U, 8U, false},
    {CARVALLO_MATRIX_K0, 2U, 2U, 2U, 21U, false},
    {CARVALLO_MATRIX_K2, 0U, 0U, 2U, 0U, true},
    {CARVALLO_MATRIX_K2, 0U, 2U, 2U, 0U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 0U, true},
    {CARVALLO_MATRIX_K2, 1U, 2U, 2U, 0U, false},
    {CARVALLO_MATRIX_KC, 0U, 0U, 3U, 2U, false},
    {CARVALLO_MATRIX_KC, 0U, 1U, 3U, 4U, false},
    {CARVALLO_MATRIX_KC, 1U, 0U, 3U, 4U, false},
    {CARVALLO_MATRIX_KC, 1U, 1U, 3U, 2U, false},
    {CARVALLO_MATRIX_KC, 1U, 2U, 3U, 4U, false},
    {CARVALLO_MATRIX_KC, 2U, 1U, 3U, 4U, false},
    {CARVALLO_MATRIX_KC, 2U, 2U, 3U, 3U, false},
    {CARVALLO_MATRIX_C0, 0U, 0U, 4U, 2U, false},
    {CARVALLO_MATRIX_C0, 0U, 1U, 4U, 4U, false},
    {CARVALLO_MATRIX_C0, 1U, 0U, 4U, 4U, false},
    {CARVALLO_MATRIX_C0, 1U, 1U, 4U, 2U, false},
    {CARVALLO_MATRIX_C0, 1U, 2U, 4U, 4U, false},
    {CARVALLO_MATRIX_C0, 2U, 1U, 4U, 4U, false},
    {CARVALLO_MATRIX_C0, 2U, 2U, 4U, 3U, false}
};

const three_pipes_f64_t three_pipes_f64_sets[THREE_PIPES_SETS] = {
    { /* hose */
        .l = 0.5,
        .m = 0.2,
        .f = 0.3,
        .k = 0.5,
        .c = 0.01,
        .g = 9.81
    }
};

three_pipes_validity_t three_pipes_f64_validate(const three_pipes_f64_t *p)
{
    three_pipes_validity_t validity = THREE_PIPES_VALID;
    if (!((p->l > 0.0) && (p->l <= DBL_MAX))) {
        validity = THREE_PIPES_INVALID_l;
    } else if (!((p->m > 0.0) && (p->m <= DBL_MAX))) {
        validity = THREE_PIPES_INVALID_m;
    } else if (!((p->f >= 0.0) && (p->f <= DBL_MAX))) {
        validity = THREE_PIPES_INVALID_f;
    } else if (!((p->k >= 0.0) && (p->k <= DBL_MAX))) {
        validity = THREE_PIPES_INVALID_k;
    } else if (!((p->c >= 0.0) && (p->c <= DBL_MAX))) {
        validity = THREE_PIPES_INVALID_c;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = THREE_PIPES_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void three_pipes_f64_matrices(const three_pipes_f64_t *p, three_pipes_f64_matrices_t *matrices)
{
    const double t1 = p->l * p->l;
    const double weight = t1 * (p->m + p->f);
    const double inertia = p->l * weight;
    const double M_11 = inertia * 2.3333333333333335;
    const double M_12 = inertia * 1.5;
    const double M_13 = inertia * 0.5;
    const double M_22 = inertia * 1.3333333333333333;
    const double M_33 = inertia * 0.3333333333333333;
    const double C0_11 = p->c + p->c;
    const double C1_11 = t1 * p->f;
    const double C1_12 = C1_11 + C1_11;
    const double Kc_11 = p->k + p->k;
    const double K0_11 = weight * 2.5;
    const double K0_22 = weight * 1.5;
    const double K0_33 = weight * 0.5;
    const double K2_13 = p->l * p->f;
    const double C0_12 = -p->c;
    const double Kc_12 = -p->k;
    const double K2_11 = -K2_13;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = M_13;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_13;
    matrices->m[2][2] = M_33;
    matrices->c0[0][0] = C0_11;
    matrices->c0[0][1] = C0_12;
    matrices->c0[0][2] = 0.0;
    matrices->c0[1][0] = C0_12;
    matrices->c0[1][1] = C0_11;
    matrices->c0[1][2] = C0_12;
    matrices->c0[2][0] = 0.0;
    matrices->c0[2][1] = C0_12;
    matrices->c0[2][2] = p->c;
    matrices->c1[0][0] = C1_11;
    matrices->c1[0][1] = C1_12;
    matrices->c1[0][2] = C1_12;
    matrices->c1[1][0] = 0.0;
    matrices->c1[1][1] = C1_11;
    matrices->c1[1][2] = C1_12;
    matrices->c1[2][0] = 0.0;
    matrices->c1[2][1] = 0.0;
    matrices->c1[2][2] = C1_11;
    matrices->kc[0][0] = Kc_11;
    matrices->kc[0][1] = Kc_12;
    matrices->kc[0][2] = 0.0;
    matrices->kc[1][0] = Kc_12;
    matrices->kc[1][1] = Kc_11;
    matrices->kc[1][2] = Kc_12;
    matrices->kc[2][0] = 0.0;
    matrices->kc[2][1] = Kc_12;
    matrices->kc[2][2] = p->k;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = 0.0;
    matrices->k0[0][2] = 0.0;
    matrices->k0[1][0] = 0.0;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0;
    matrices->k0[2][0] = 0.0;
    matrices->k0[2][1] = 0.0;
    matrices->k0[2][2] = K0_33;
    matrices->k2[0][0] = K2_11;
    matrices->k2[0][1] = 0.0;
    matrices->k2[0][2] = K2_13;
    matrices->k2[1][0] = 0.0;
    matrices->k2[1][1] = K2_11;
    matrices->k2[1][2] = K2_13;
    matrices->k2[2][0] = 0.0;
    matrices->k2[2][1] = 0.0;
    matrices->k2[2][2] = 0.0;
}

carvallo_system_error_t three_pipes_f64_at_speed(const three_pipes_f64_matrices_t *matrices,
    double speed, double gravity, three_pipes_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed) && carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < THREE_PIPES_N; row++) {
        for (size_t column = 0U; column < THREE_PIPES_N; column++) {
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

carvallo_system_error_t three_pipes_f64_state_space(const three_pipes_f64_system_t *system,
    three_pipes_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[THREE_PIPES_N * THREE_PIPES_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * THREE_PIPES_N * THREE_PIPES_N];
    for (size_t row = 0U; row < THREE_PIPES_N; row++) {
        double *const solved = &x[3U * THREE_PIPES_N * row];
        for (size_t column = 0U; column < THREE_PIPES_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * THREE_PIPES_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[THREE_PIPES_N + column] = -system->c[row][column];
            solved[(2U * THREE_PIPES_N) + column] = 0.0;
        }
        solved[(2U * THREE_PIPES_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[THREE_PIPES_N * THREE_PIPES_N];
        error = carvallo_solve_f64(THREE_PIPES_N, m, terms, 3U * THREE_PIPES_N, x);
    }
    for (size_t row = 0U; row < (2U * THREE_PIPES_N); row++) {
        for (size_t column = 0U; column < (2U * THREE_PIPES_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < THREE_PIPES_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < THREE_PIPES_N; row++) {
            const size_t target = THREE_PIPES_N + row;
            for (size_t column = 0U; column < (2U * THREE_PIPES_N); column++) {
                space->a[target][column] = x[(3U * THREE_PIPES_N * row) + column];
            }
            for (size_t column = 0U; column < THREE_PIPES_N; column++) {
                space->b[target][column] = x[(3U * THREE_PIPES_N * row) + (2U * THREE_PIPES_N) +
                    column];
            }
            space->a[row][THREE_PIPES_N + row] = 1.0;
        }
    }
    return error;
}

void three_pipes_f64_derivatives(const three_pipes_f64_t *p, three_pipes_f64_matrices_t *matrices,
    three_pipes_f64_derivatives_t *derivatives)
{
    const double t17 = p->m + p->f;
    const double weight_m = p->l * p->l;
    const double inertia_m = p->l * weight_m;
    const double M_11_m = inertia_m * 2.3333333333333335;
    const double K0_33_l = t17 * p->l;
    const double K0_22_m = weight_m * 1.5;
    const double M_12 = K0_33_l * K0_22_m;
    const double K0_22 = t17 * K0_22_m;
    const double weight = p->l * K0_33_l;
    const double M_11 = t17 * M_11_m;
    const double K0_33 = 0.5 * weight;
    const double C0_11 = p->c + p->c;
    const double Kc_11 = p->k + p->k;
    const double K0_11 = weight * 2.5;
    const double inertia_l = weight * 3.0;
    const double weight_l = K0_33_l + K0_33_l;
    const double K0_11_l = 2.5 * weight_l;
    const double K0_22_l = 1.5 * weight_l;
    const double M_13 = p->l * K0_33;
    const double M_22_m = inertia_m * 1.3333333333333333;
    const double M_22 = t17 * M_22_m;
    const double M_33_m = inertia_m * 0.3333333333333333;
    const double M_33 = t17 * M_33_m;
    const double C1_11 = p->f * weight_m;
    const double C1_12 = C1_11 + C1_11;
    const double K2_13 = p->f * p->l;
    const double M_11_l = 2.3333333333333335 * inertia_l;
    const double M_12_l = 1.5 * inertia_l;
    const double M_13_l = 0.5 * inertia_l;
    const double M_22_l = 1.3333333333333333 * inertia_l;
    const double C1_11_l = K2_13 + K2_13;
    const double C1_12_l = K2_13 * 4.0;
    const double M_12_m = inertia_m * 1.5;
    const double K0_33_m = weight_m * 0.5;
    const double M_13_m = p->l * K0_33_m;
    const double K0_11_m = weight_m * 2.5;
    const double C1_12_f = weight_m + weight_m;
    const double C0_12 = -p->c;
    const double Kc_12 = -p->k;
    const double K2_11 = -K2_13;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = M_13;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_13;
    matrices->m[2][2] = M_33;
    matrices->c0[0][0] = C0_11;
    matrices->c0[0][1] = C0_12;
    matrices->c0[0][2] = 0.0;
    matrices->c0[1][0] = C0_12;
    matrices->c0[1][1] = C0_11;
    matrices->c0[1][2] = C0_12;
    matrices->c0[2][0] = 0.0;
    matrices->c0[2][1] = C0_12;
    matrices->c0[2][2] = p->c;
    matrices->c1[0][0] = C1_11;
    matrices->c1[0][1] = C1_12;
    matrices->c1[0][2] = C1_12;
    matrices->c1[1][0] = 0.0;
    matrices->c1[1][1] = C1_11;
    matrices->c1[1][2] = C1_12;
    matrices->c1[2][0] = 0.0;
    matrices->c1[2][1] = 0.0;
    matrices->c1[2][2] = C1_11;
    matrices->kc[0][0] = Kc_11;
    matrices->kc[0][1] = Kc_12;
    matrices->kc[0][2] = 0.0;
    matrices->kc[1][0] = Kc_12;
    matrices->kc[1][1] = Kc_11;
    matrices->kc[1][2] = Kc_12;
    matrices->kc[2][0] = 0.0;
    matrices->kc[2][1] = Kc_12;
    matrices->kc[2][2] = p->k;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = 0.0;
    matrices->k0[0][2] = 0.0;
    matrices->k0[1][0] = 0.0;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0;
    matrices->k0[2][0] = 0.0;
    matrices->k0[2][1] = 0.0;
    matrices->k0[2][2] = K0_33;
    matrices->k2[0][0] = K2_11;
    matrices->k2[0][1] = 0.0;
    matrices->k2[0][2] = K2_13;
    matrices->k2[1][0] = 0.0;
    matrices->k2[1][1] = K2_11;
    matrices->k2[1][2] = K2_13;
    matrices->k2[2][0] = 0.0;
    matrices->k2[2][1] = 0.0;
    matrices->k2[2][2] = 0.0;
    derivatives->values[0] = p->l;
    derivatives->values[1] = p->f;
    derivatives->values[2] = 2.0;
    derivatives->values[3] = 1.0;
    derivatives->values[4] = (-1.0);
    derivatives->values[5] = weight_m;
    derivatives->values[6] = M_11_m;
    derivatives->values[7] = K0_33_l;
    derivatives->values[8] = K0_22_m;
    derivatives->values[9] = weight;
    derivatives->values[10] = K0_11_l;
    derivatives->values[11] = K0_22_l;
    derivatives->values[12] = M_22_m;
    derivatives->values[13] = M_33_m;
    derivatives->values[14] = M_11_l;
    derivatives->values[15] = M_12_l;
    derivatives->values[16] = M_13_l;
    derivatives->values[17] = M_22_l;
    derivatives->values[18] = C1_11_l;
    derivatives->values[19] = C1_12_l;
    derivatives->values[20] = M_12_m;
    derivatives->values[21] = K0_33_m;
    derivatives->values[22] = M_13_m;
    derivatives->values[23] = K0_11_m;
    derivatives->values[24] = C1_12_f;
}

void three_pipes_f64_with_respect_to(const three_pipes_f64_derivatives_t *derivatives,
    size_t parameter, three_pipes_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < THREE_PIPES_N; row++) {
        for (size_t column = 0U; column < THREE_PIPES_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c0[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->kc[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
            matrices->k2[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < THREE_PIPES_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &three_pipes_partials[position];
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

const three_pipes_f32_t three_pipes_f32_sets[THREE_PIPES_SETS] = {
    { /* hose */
        .l = 0.5F,
        .m = 0.2F,
        .f = 0.3F,
        .k = 0.5F,
        .c = 0.01F,
        .g = 9.81F
    }
};

three_pipes_validity_t three_pipes_f32_validate(const three_pipes_f32_t *p)
{
    three_pipes_validity_t validity = THREE_PIPES_VALID;
    if (!((p->l > 0.0F) && (p->l <= FLT_MAX))) {
        validity = THREE_PIPES_INVALID_l;
    } else if (!((p->m > 0.0F) && (p->m <= FLT_MAX))) {
        validity = THREE_PIPES_INVALID_m;
    } else if (!((p->f >= 0.0F) && (p->f <= FLT_MAX))) {
        validity = THREE_PIPES_INVALID_f;
    } else if (!((p->k >= 0.0F) && (p->k <= FLT_MAX))) {
        validity = THREE_PIPES_INVALID_k;
    } else if (!((p->c >= 0.0F) && (p->c <= FLT_MAX))) {
        validity = THREE_PIPES_INVALID_c;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = THREE_PIPES_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void three_pipes_f32_matrices(const three_pipes_f32_t *p, three_pipes_f32_matrices_t *matrices)
{
    const float t1 = p->l * p->l;
    const float weight = t1 * (p->m + p->f);
    const float inertia = p->l * weight;
    const float M_11 = inertia * 2.3333333F;
    const float M_12 = inertia * 1.5F;
    const float M_13 = inertia * 0.5F;
    const float M_22 = inertia * 1.3333334F;
    const float M_33 = inertia * 0.33333334F;
    const float C0_11 = p->c + p->c;
    const float C1_11 = t1 * p->f;
    const float C1_12 = C1_11 + C1_11;
    const float Kc_11 = p->k + p->k;
    const float K0_11 = weight * 2.5F;
    const float K0_22 = weight * 1.5F;
    const float K0_33 = weight * 0.5F;
    const float K2_13 = p->l * p->f;
    const float C0_12 = -p->c;
    const float Kc_12 = -p->k;
    const float K2_11 = -K2_13;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = M_13;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_13;
    matrices->m[2][2] = M_33;
    matrices->c0[0][0] = C0_11;
    matrices->c0[0][1] = C0_12;
    matrices->c0[0][2] = 0.0F;
    matrices->c0[1][0] = C0_12;
    matrices->c0[1][1] = C0_11;
    matrices->c0[1][2] = C0_12;
    matrices->c0[2][0] = 0.0F;
    matrices->c0[2][1] = C0_12;
    matrices->c0[2][2] = p->c;
    matrices->c1[0][0] = C1_11;
    matrices->c1[0][1] = C1_12;
    matrices->c1[0][2] = C1_12;
    matrices->c1[1][0] = 0.0F;
    matrices->c1[1][1] = C1_11;
    matrices->c1[1][2] = C1_12;
    matrices->c1[2][0] = 0.0F;
    matrices->c1[2][1] = 0.0F;
    matrices->c1[2][2] = C1_11;
    matrices->kc[0][0] = Kc_11;
    matrices->kc[0][1] = Kc_12;
    matrices->kc[0][2] = 0.0F;
    matrices->kc[1][0] = Kc_12;
    matrices->kc[1][1] = Kc_11;
    matrices->kc[1][2] = Kc_12;
    matrices->kc[2][0] = 0.0F;
    matrices->kc[2][1] = Kc_12;
    matrices->kc[2][2] = p->k;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = 0.0F;
    matrices->k0[0][2] = 0.0F;
    matrices->k0[1][0] = 0.0F;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0F;
    matrices->k0[2][0] = 0.0F;
    matrices->k0[2][1] = 0.0F;
    matrices->k0[2][2] = K0_33;
    matrices->k2[0][0] = K2_11;
    matrices->k2[0][1] = 0.0F;
    matrices->k2[0][2] = K2_13;
    matrices->k2[1][0] = 0.0F;
    matrices->k2[1][1] = K2_11;
    matrices->k2[1][2] = K2_13;
    matrices->k2[2][0] = 0.0F;
    matrices->k2[2][1] = 0.0F;
    matrices->k2[2][2] = 0.0F;
}

carvallo_system_error_t three_pipes_f32_at_speed(const three_pipes_f32_matrices_t *matrices,
    float speed, float gravity, three_pipes_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed) && carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < THREE_PIPES_N; row++) {
        for (size_t column = 0U; column < THREE_PIPES_N; column++) {
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

carvallo_system_error_t three_pipes_f32_state_space(const three_pipes_f32_system_t *system,
    three_pipes_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[THREE_PIPES_N * THREE_PIPES_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * THREE_PIPES_N * THREE_PIPES_N];
    for (size_t row = 0U; row < THREE_PIPES_N; row++) {
        float *const solved = &x[3U * THREE_PIPES_N * row];
        for (size_t column = 0U; column < THREE_PIPES_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * THREE_PIPES_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[THREE_PIPES_N + column] = -system->c[row][column];
            solved[(2U * THREE_PIPES_N) + column] = 0.0F;
        }
        solved[(2U * THREE_PIPES_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[THREE_PIPES_N * THREE_PIPES_N];
        error = carvallo_solve_f32(THREE_PIPES_N, m, terms, 3U * THREE_PIPES_N, x);
    }
    for (size_t row = 0U; row < (2U * THREE_PIPES_N); row++) {
        for (size_t column = 0U; column < (2U * THREE_PIPES_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < THREE_PIPES_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < THREE_PIPES_N; row++) {
            const size_t target = THREE_PIPES_N + row;
            for (size_t column = 0U; column < (2U * THREE_PIPES_N); column++) {
                space->a[target][column] = x[(3U * THREE_PIPES_N * row) + column];
            }
            for (size_t column = 0U; column < THREE_PIPES_N; column++) {
                space->b[target][column] = x[(3U * THREE_PIPES_N * row) + (2U * THREE_PIPES_N) +
                    column];
            }
            space->a[row][THREE_PIPES_N + row] = 1.0F;
        }
    }
    return error;
}

void three_pipes_f32_derivatives(const three_pipes_f32_t *p, three_pipes_f32_matrices_t *matrices,
    three_pipes_f32_derivatives_t *derivatives)
{
    const float t17 = p->m + p->f;
    const float weight_m = p->l * p->l;
    const float inertia_m = p->l * weight_m;
    const float M_11_m = inertia_m * 2.3333333F;
    const float K0_33_l = t17 * p->l;
    const float K0_22_m = weight_m * 1.5F;
    const float M_12 = K0_33_l * K0_22_m;
    const float K0_22 = t17 * K0_22_m;
    const float weight = p->l * K0_33_l;
    const float M_11 = t17 * M_11_m;
    const float K0_33 = 0.5F * weight;
    const float C0_11 = p->c + p->c;
    const float Kc_11 = p->k + p->k;
    const float K0_11 = weight * 2.5F;
    const float inertia_l = weight * 3.0F;
    const float weight_l = K0_33_l + K0_33_l;
    const float K0_11_l = 2.5F * weight_l;
    const float K0_22_l = 1.5F * weight_l;
    const float M_13 = p->l * K0_33;
    const float M_22_m = inertia_m * 1.3333334F;
    const float M_22 = t17 * M_22_m;
    const float M_33_m = inertia_m * 0.33333334F;
    const float M_33 = t17 * M_33_m;
    const float C1_11 = p->f * weight_m;
    const float C1_12 = C1_11 + C1_11;
    const float K2_13 = p->f * p->l;
    const float M_11_l = 2.3333333F * inertia_l;
    const float M_12_l = 1.5F * inertia_l;
    const float M_13_l = 0.5F * inertia_l;
    const float M_22_l = 1.3333334F * inertia_l;
    const float C1_11_l = K2_13 + K2_13;
    const float C1_12_l = K2_13 * 4.0F;
    const float M_12_m = inertia_m * 1.5F;
    const float K0_33_m = weight_m * 0.5F;
    const float M_13_m = p->l * K0_33_m;
    const float K0_11_m = weight_m * 2.5F;
    const float C1_12_f = weight_m + weight_m;
    const float C0_12 = -p->c;
    const float Kc_12 = -p->k;
    const float K2_11 = -K2_13;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = M_13;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_13;
    matrices->m[2][2] = M_33;
    matrices->c0[0][0] = C0_11;
    matrices->c0[0][1] = C0_12;
    matrices->c0[0][2] = 0.0F;
    matrices->c0[1][0] = C0_12;
    matrices->c0[1][1] = C0_11;
    matrices->c0[1][2] = C0_12;
    matrices->c0[2][0] = 0.0F;
    matrices->c0[2][1] = C0_12;
    matrices->c0[2][2] = p->c;
    matrices->c1[0][0] = C1_11;
    matrices->c1[0][1] = C1_12;
    matrices->c1[0][2] = C1_12;
    matrices->c1[1][0] = 0.0F;
    matrices->c1[1][1] = C1_11;
    matrices->c1[1][2] = C1_12;
    matrices->c1[2][0] = 0.0F;
    matrices->c1[2][1] = 0.0F;
    matrices->c1[2][2] = C1_11;
    matrices->kc[0][0] = Kc_11;
    matrices->kc[0][1] = Kc_12;
    matrices->kc[0][2] = 0.0F;
    matrices->kc[1][0] = Kc_12;
    matrices->kc[1][1] = Kc_11;
    matrices->kc[1][2] = Kc_12;
    matrices->kc[2][0] = 0.0F;
    matrices->kc[2][1] = Kc_12;
    matrices->kc[2][2] = p->k;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = 0.0F;
    matrices->k0[0][2] = 0.0F;
    matrices->k0[1][0] = 0.0F;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0F;
    matrices->k0[2][0] = 0.0F;
    matrices->k0[2][1] = 0.0F;
    matrices->k0[2][2] = K0_33;
    matrices->k2[0][0] = K2_11;
    matrices->k2[0][1] = 0.0F;
    matrices->k2[0][2] = K2_13;
    matrices->k2[1][0] = 0.0F;
    matrices->k2[1][1] = K2_11;
    matrices->k2[1][2] = K2_13;
    matrices->k2[2][0] = 0.0F;
    matrices->k2[2][1] = 0.0F;
    matrices->k2[2][2] = 0.0F;
    derivatives->values[0] = p->l;
    derivatives->values[1] = p->f;
    derivatives->values[2] = 2.0F;
    derivatives->values[3] = 1.0F;
    derivatives->values[4] = (-1.0F);
    derivatives->values[5] = weight_m;
    derivatives->values[6] = M_11_m;
    derivatives->values[7] = K0_33_l;
    derivatives->values[8] = K0_22_m;
    derivatives->values[9] = weight;
    derivatives->values[10] = K0_11_l;
    derivatives->values[11] = K0_22_l;
    derivatives->values[12] = M_22_m;
    derivatives->values[13] = M_33_m;
    derivatives->values[14] = M_11_l;
    derivatives->values[15] = M_12_l;
    derivatives->values[16] = M_13_l;
    derivatives->values[17] = M_22_l;
    derivatives->values[18] = C1_11_l;
    derivatives->values[19] = C1_12_l;
    derivatives->values[20] = M_12_m;
    derivatives->values[21] = K0_33_m;
    derivatives->values[22] = M_13_m;
    derivatives->values[23] = K0_11_m;
    derivatives->values[24] = C1_12_f;
}

void three_pipes_f32_with_respect_to(const three_pipes_f32_derivatives_t *derivatives,
    size_t parameter, three_pipes_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < THREE_PIPES_N; row++) {
        for (size_t column = 0U; column < THREE_PIPES_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c0[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->kc[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
            matrices->k2[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < THREE_PIPES_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &three_pipes_partials[position];
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
