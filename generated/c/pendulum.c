/* @generated from generated/models/pendulum.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 9f6bf78d3baf1a60
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * M_11 = m*l^2 [kg*m^2]
 * C0_11 = c [kg*m^2/s]
 * K0_11 = m*l [kg*m]
 * @endverbatim
 */

#include "pendulum.h"

#include <float.h>

const char *pendulum_set_name(pendulum_set_t set)
{
    static const char *const TEXTS[] = {
        "seconds",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *pendulum_validity_text(pendulum_validity_t validity)
{
    static const char *const TEXTS[] = {
        "Pendulum: the parameters are valid",
        "Pendulum: m in kg must be finite and > 0",
        "Pendulum: l in m must be finite and > 0",
        "Pendulum: c in N*m*s must be finite and >= 0",
        "Pendulum: g in N/kg must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t pendulum_partials[PENDULUM_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 3U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 0U, 1U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 1U, 4U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 1U, 0U, false},
    {CARVALLO_MATRIX_C0, 0U, 0U, 2U, 2U, false}
};

const pendulum_f64_t pendulum_f64_sets[PENDULUM_SETS] = {
    { /* seconds */
        .m = 2.0,
        .l = 0.994,
        .c = 0.1,
        .g = 9.81
    }
};

pendulum_validity_t pendulum_f64_validate(const pendulum_f64_t *p)
{
    pendulum_validity_t validity = PENDULUM_VALID;
    if (!((p->m > 0.0) && (p->m <= DBL_MAX))) {
        validity = PENDULUM_INVALID_m;
    } else if (!((p->l > 0.0) && (p->l <= DBL_MAX))) {
        validity = PENDULUM_INVALID_l;
    } else if (!((p->c >= 0.0) && (p->c <= DBL_MAX))) {
        validity = PENDULUM_INVALID_c;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = PENDULUM_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void pendulum_f64_matrices(const pendulum_f64_t *p, pendulum_f64_matrices_t *matrices)
{
    const double K0_11 = p->l * p->m;
    const double M_11 = p->l * K0_11;
    matrices->m[0][0] = M_11;
    matrices->c0[0][0] = p->c;
    matrices->k0[0][0] = K0_11;
}

carvallo_system_error_t pendulum_f64_system(const pendulum_f64_matrices_t *matrices, double gravity,
    pendulum_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < PENDULUM_N; row++) {
        for (size_t column = 0U; column < PENDULUM_N; column++) {
            const double damping = matrices->c0[row][column];
            const double stiffness = matrices->k0[row][column] * gravity;
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->c0[row][column]) &&
                carvallo_is_finite_f64(matrices->k0[row][column]);
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

carvallo_system_error_t pendulum_f64_state_space(const pendulum_f64_system_t *system,
    pendulum_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[PENDULUM_N * PENDULUM_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * PENDULUM_N * PENDULUM_N];
    for (size_t row = 0U; row < PENDULUM_N; row++) {
        double *const solved = &x[3U * PENDULUM_N * row];
        for (size_t column = 0U; column < PENDULUM_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * PENDULUM_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[PENDULUM_N + column] = -system->c[row][column];
            solved[(2U * PENDULUM_N) + column] = 0.0;
        }
        solved[(2U * PENDULUM_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[PENDULUM_N * PENDULUM_N];
        error = carvallo_solve_f64(PENDULUM_N, m, terms, 3U * PENDULUM_N, x);
    }
    for (size_t row = 0U; row < (2U * PENDULUM_N); row++) {
        for (size_t column = 0U; column < (2U * PENDULUM_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < PENDULUM_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < PENDULUM_N; row++) {
            const size_t target = PENDULUM_N + row;
            for (size_t column = 0U; column < (2U * PENDULUM_N); column++) {
                space->a[target][column] = x[(3U * PENDULUM_N * row) + column];
            }
            for (size_t column = 0U; column < PENDULUM_N; column++) {
                space->b[target][column] = x[(3U * PENDULUM_N * row) + (2U * PENDULUM_N) + column];
            }
            space->a[row][PENDULUM_N + row] = 1.0;
        }
    }
    return error;
}

void pendulum_f64_derivatives(const pendulum_f64_t *p, pendulum_f64_matrices_t *matrices,
    pendulum_f64_derivatives_t *derivatives)
{
    const double M_11_m = p->l * p->l;
    const double M_11 = p->m * M_11_m;
    const double K0_11 = p->m * p->l;
    const double M_11_l = K0_11 + K0_11;
    matrices->m[0][0] = M_11;
    matrices->c0[0][0] = p->c;
    matrices->k0[0][0] = K0_11;
    derivatives->values[0] = p->m;
    derivatives->values[1] = p->l;
    derivatives->values[2] = 1.0;
    derivatives->values[3] = M_11_m;
    derivatives->values[4] = M_11_l;
}

void pendulum_f64_with_respect_to(const pendulum_f64_derivatives_t *derivatives, size_t parameter,
    pendulum_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < PENDULUM_N; row++) {
        for (size_t column = 0U; column < PENDULUM_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c0[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < PENDULUM_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &pendulum_partials[position];
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
            case CARVALLO_MATRIX_K0:
                matrices->k0[partial->row][partial->column] = signed_value;
                break;
            default:
                /* The model has no other matrix. */
                break;
            }
        }
    }
}

const pendulum_f32_t pendulum_f32_sets[PENDULUM_SETS] = {
    { /* seconds */
        .m = 2.0F,
        .l = 0.994F,
        .c = 0.1F,
        .g = 9.81F
    }
};

pendulum_validity_t pendulum_f32_validate(const pendulum_f32_t *p)
{
    pendulum_validity_t validity = PENDULUM_VALID;
    if (!((p->m > 0.0F) && (p->m <= FLT_MAX))) {
        validity = PENDULUM_INVALID_m;
    } else if (!((p->l > 0.0F) && (p->l <= FLT_MAX))) {
        validity = PENDULUM_INVALID_l;
    } else if (!((p->c >= 0.0F) && (p->c <= FLT_MAX))) {
        validity = PENDULUM_INVALID_c;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = PENDULUM_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void pendulum_f32_matrices(const pendulum_f32_t *p, pendulum_f32_matrices_t *matrices)
{
    const float K0_11 = p->l * p->m;
    const float M_11 = p->l * K0_11;
    matrices->m[0][0] = M_11;
    matrices->c0[0][0] = p->c;
    matrices->k0[0][0] = K0_11;
}

carvallo_system_error_t pendulum_f32_system(const pendulum_f32_matrices_t *matrices, float gravity,
    pendulum_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < PENDULUM_N; row++) {
        for (size_t column = 0U; column < PENDULUM_N; column++) {
            const float damping = matrices->c0[row][column];
            const float stiffness = matrices->k0[row][column] * gravity;
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->c0[row][column]) &&
                carvallo_is_finite_f32(matrices->k0[row][column]);
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

carvallo_system_error_t pendulum_f32_state_space(const pendulum_f32_system_t *system,
    pendulum_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[PENDULUM_N * PENDULUM_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * PENDULUM_N * PENDULUM_N];
    for (size_t row = 0U; row < PENDULUM_N; row++) {
        float *const solved = &x[3U * PENDULUM_N * row];
        for (size_t column = 0U; column < PENDULUM_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * PENDULUM_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[PENDULUM_N + column] = -system->c[row][column];
            solved[(2U * PENDULUM_N) + column] = 0.0F;
        }
        solved[(2U * PENDULUM_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[PENDULUM_N * PENDULUM_N];
        error = carvallo_solve_f32(PENDULUM_N, m, terms, 3U * PENDULUM_N, x);
    }
    for (size_t row = 0U; row < (2U * PENDULUM_N); row++) {
        for (size_t column = 0U; column < (2U * PENDULUM_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < PENDULUM_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < PENDULUM_N; row++) {
            const size_t target = PENDULUM_N + row;
            for (size_t column = 0U; column < (2U * PENDULUM_N); column++) {
                space->a[target][column] = x[(3U * PENDULUM_N * row) + column];
            }
            for (size_t column = 0U; column < PENDULUM_N; column++) {
                space->b[target][column] = x[(3U * PENDULUM_N * row) + (2U * PENDULUM_N) + column];
            }
            space->a[row][PENDULUM_N + row] = 1.0F;
        }
    }
    return error;
}

void pendulum_f32_derivatives(const pendulum_f32_t *p, pendulum_f32_matrices_t *matrices,
    pendulum_f32_derivatives_t *derivatives)
{
    const float M_11_m = p->l * p->l;
    const float M_11 = p->m * M_11_m;
    const float K0_11 = p->m * p->l;
    const float M_11_l = K0_11 + K0_11;
    matrices->m[0][0] = M_11;
    matrices->c0[0][0] = p->c;
    matrices->k0[0][0] = K0_11;
    derivatives->values[0] = p->m;
    derivatives->values[1] = p->l;
    derivatives->values[2] = 1.0F;
    derivatives->values[3] = M_11_m;
    derivatives->values[4] = M_11_l;
}

void pendulum_f32_with_respect_to(const pendulum_f32_derivatives_t *derivatives, size_t parameter,
    pendulum_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < PENDULUM_N; row++) {
        for (size_t column = 0U; column < PENDULUM_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c0[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < PENDULUM_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &pendulum_partials[position];
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
            case CARVALLO_MATRIX_K0:
                matrices->k0[partial->row][partial->column] = signed_value;
                break;
            default:
                /* The model has no other matrix. */
                break;
            }
        }
    }
}
