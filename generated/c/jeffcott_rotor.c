/* @generated from generated/models/jeffcott_rotor.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: d9449eedbd9a5f5e
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * c = ce + ci [kg/s]
 * circulation = ci/R [kg/m/s]
 * M_11 = M_22 = m [kg]
 * C0_11 = C0_22 = c [kg/s]
 * Kc_11 = Kc_22 = k [kg/s^2]
 * K1_12 = circulation [kg/m/s]
 * K1_21 = -circulation [kg/m/s]
 * @endverbatim
 */

#include "jeffcott_rotor.h"

#include <float.h>

const char *jeffcott_rotor_set_name(jeffcott_rotor_set_t set)
{
    static const char *const TEXTS[] = {
        "example",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *jeffcott_rotor_validity_text(jeffcott_rotor_validity_t validity)
{
    static const char *const TEXTS[] = {
        "JeffcottRotor: the parameters are valid",
        "JeffcottRotor: m in kg must be finite and > 0",
        "JeffcottRotor: k in N/m must be finite and > 0",
        "JeffcottRotor: ce in N*s/m must be finite and >= 0",
        "JeffcottRotor: ci in N*s/m must be finite and >= 0",
        "JeffcottRotor: R in m must be finite and > 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t jeffcott_rotor_partials[JEFFCOTT_ROTOR_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 0U, false},
    {CARVALLO_MATRIX_KC, 0U, 0U, 1U, 0U, false},
    {CARVALLO_MATRIX_KC, 1U, 1U, 1U, 0U, false},
    {CARVALLO_MATRIX_C0, 0U, 0U, 2U, 0U, false},
    {CARVALLO_MATRIX_C0, 1U, 1U, 2U, 0U, false},
    {CARVALLO_MATRIX_C0, 0U, 0U, 3U, 0U, false},
    {CARVALLO_MATRIX_C0, 1U, 1U, 3U, 0U, false},
    {CARVALLO_MATRIX_K1, 0U, 1U, 3U, 1U, false},
    {CARVALLO_MATRIX_K1, 1U, 0U, 3U, 1U, true},
    {CARVALLO_MATRIX_K1, 0U, 1U, 4U, 2U, true},
    {CARVALLO_MATRIX_K1, 1U, 0U, 4U, 2U, false}
};

const jeffcott_rotor_f64_t jeffcott_rotor_f64_sets[JEFFCOTT_ROTOR_SETS] = {
    { /* example */
        .m = 1.0,
        .k = 10000.0,
        .ce = 3.0,
        .ci = 2.0,
        .R = 0.03
    }
};

jeffcott_rotor_validity_t jeffcott_rotor_f64_validate(const jeffcott_rotor_f64_t *p)
{
    jeffcott_rotor_validity_t validity = JEFFCOTT_ROTOR_VALID;
    if (!((p->m > 0.0) && (p->m <= DBL_MAX))) {
        validity = JEFFCOTT_ROTOR_INVALID_m;
    } else if (!((p->k > 0.0) && (p->k <= DBL_MAX))) {
        validity = JEFFCOTT_ROTOR_INVALID_k;
    } else if (!((p->ce >= 0.0) && (p->ce <= DBL_MAX))) {
        validity = JEFFCOTT_ROTOR_INVALID_ce;
    } else if (!((p->ci >= 0.0) && (p->ci <= DBL_MAX))) {
        validity = JEFFCOTT_ROTOR_INVALID_ci;
    } else if (!((p->R > 0.0) && (p->R <= DBL_MAX))) {
        validity = JEFFCOTT_ROTOR_INVALID_R;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void jeffcott_rotor_f64_matrices(const jeffcott_rotor_f64_t *p, jeffcott_rotor_f64_matrices_t *matrices)
{
    const double c = p->ce + p->ci;
    const double circulation = p->ci / p->R;
    const double K1_21 = -circulation;
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = 0.0;
    matrices->m[1][0] = 0.0;
    matrices->m[1][1] = p->m;
    matrices->c0[0][0] = c;
    matrices->c0[0][1] = 0.0;
    matrices->c0[1][0] = 0.0;
    matrices->c0[1][1] = c;
    matrices->kc[0][0] = p->k;
    matrices->kc[0][1] = 0.0;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = p->k;
    matrices->k1[0][0] = 0.0;
    matrices->k1[0][1] = circulation;
    matrices->k1[1][0] = K1_21;
    matrices->k1[1][1] = 0.0;
}

carvallo_system_error_t jeffcott_rotor_f64_at_speed(const jeffcott_rotor_f64_matrices_t *matrices,
    double speed, jeffcott_rotor_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed);
    bool is_in_range = true;
    for (size_t row = 0U; row < JEFFCOTT_ROTOR_N; row++) {
        for (size_t column = 0U; column < JEFFCOTT_ROTOR_N; column++) {
            const double damping = matrices->c0[row][column];
            const double stiffness = matrices->kc[row][column] + (matrices->k1[row][column] *
                speed);
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->c0[row][column]) &&
                carvallo_is_finite_f64(matrices->kc[row][column]) &&
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

carvallo_system_error_t jeffcott_rotor_f64_state_space(const jeffcott_rotor_f64_system_t *system,
    jeffcott_rotor_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[JEFFCOTT_ROTOR_N * JEFFCOTT_ROTOR_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * JEFFCOTT_ROTOR_N * JEFFCOTT_ROTOR_N];
    for (size_t row = 0U; row < JEFFCOTT_ROTOR_N; row++) {
        double *const solved = &x[3U * JEFFCOTT_ROTOR_N * row];
        for (size_t column = 0U; column < JEFFCOTT_ROTOR_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * JEFFCOTT_ROTOR_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[JEFFCOTT_ROTOR_N + column] = -system->c[row][column];
            solved[(2U * JEFFCOTT_ROTOR_N) + column] = 0.0;
        }
        solved[(2U * JEFFCOTT_ROTOR_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[JEFFCOTT_ROTOR_N * JEFFCOTT_ROTOR_N];
        error = carvallo_solve_f64(JEFFCOTT_ROTOR_N, m, terms, 3U * JEFFCOTT_ROTOR_N, x);
    }
    for (size_t row = 0U; row < (2U * JEFFCOTT_ROTOR_N); row++) {
        for (size_t column = 0U; column < (2U * JEFFCOTT_ROTOR_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < JEFFCOTT_ROTOR_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < JEFFCOTT_ROTOR_N; row++) {
            const size_t target = JEFFCOTT_ROTOR_N + row;
            for (size_t column = 0U; column < (2U * JEFFCOTT_ROTOR_N); column++) {
                space->a[target][column] = x[(3U * JEFFCOTT_ROTOR_N * row) + column];
            }
            for (size_t column = 0U; column < JEFFCOTT_ROTOR_N; column++) {
                space->b[target][column] = x[(3U * JEFFCOTT_ROTOR_N * row) + (2U *
                    JEFFCOTT_ROTOR_N) + column];
            }
            space->a[row][JEFFCOTT_ROTOR_N + row] = 1.0;
        }
    }
    return error;
}

void jeffcott_rotor_f64_derivatives(const jeffcott_rotor_f64_t *p,
    jeffcott_rotor_f64_matrices_t *matrices, jeffcott_rotor_f64_derivatives_t *derivatives)
{
    const double c = p->ce + p->ci;
    const double K1_12_ci = 1.0 / p->R;
    const double circulation = p->ci * K1_12_ci;
    const double K1_21_R = K1_12_ci * circulation;
    const double K1_21 = -circulation;
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = 0.0;
    matrices->m[1][0] = 0.0;
    matrices->m[1][1] = p->m;
    matrices->c0[0][0] = c;
    matrices->c0[0][1] = 0.0;
    matrices->c0[1][0] = 0.0;
    matrices->c0[1][1] = c;
    matrices->kc[0][0] = p->k;
    matrices->kc[0][1] = 0.0;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = p->k;
    matrices->k1[0][0] = 0.0;
    matrices->k1[0][1] = circulation;
    matrices->k1[1][0] = K1_21;
    matrices->k1[1][1] = 0.0;
    derivatives->values[0] = 1.0;
    derivatives->values[1] = K1_12_ci;
    derivatives->values[2] = K1_21_R;
}

void jeffcott_rotor_f64_with_respect_to(const jeffcott_rotor_f64_derivatives_t *derivatives,
    size_t parameter, jeffcott_rotor_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < JEFFCOTT_ROTOR_N; row++) {
        for (size_t column = 0U; column < JEFFCOTT_ROTOR_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c0[row][column] = 0.0;
            matrices->kc[row][column] = 0.0;
            matrices->k1[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < JEFFCOTT_ROTOR_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &jeffcott_rotor_partials[position];
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
            case CARVALLO_MATRIX_KC:
                matrices->kc[partial->row][partial->column] = signed_value;
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

const jeffcott_rotor_f32_t jeffcott_rotor_f32_sets[JEFFCOTT_ROTOR_SETS] = {
    { /* example */
        .m = 1.0F,
        .k = 10000.0F,
        .ce = 3.0F,
        .ci = 2.0F,
        .R = 0.03F
    }
};

jeffcott_rotor_validity_t jeffcott_rotor_f32_validate(const jeffcott_rotor_f32_t *p)
{
    jeffcott_rotor_validity_t validity = JEFFCOTT_ROTOR_VALID;
    if (!((p->m > 0.0F) && (p->m <= FLT_MAX))) {
        validity = JEFFCOTT_ROTOR_INVALID_m;
    } else if (!((p->k > 0.0F) && (p->k <= FLT_MAX))) {
        validity = JEFFCOTT_ROTOR_INVALID_k;
    } else if (!((p->ce >= 0.0F) && (p->ce <= FLT_MAX))) {
        validity = JEFFCOTT_ROTOR_INVALID_ce;
    } else if (!((p->ci >= 0.0F) && (p->ci <= FLT_MAX))) {
        validity = JEFFCOTT_ROTOR_INVALID_ci;
    } else if (!((p->R > 0.0F) && (p->R <= FLT_MAX))) {
        validity = JEFFCOTT_ROTOR_INVALID_R;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void jeffcott_rotor_f32_matrices(const jeffcott_rotor_f32_t *p, jeffcott_rotor_f32_matrices_t *matrices)
{
    const float c = p->ce + p->ci;
    const float circulation = p->ci / p->R;
    const float K1_21 = -circulation;
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = 0.0F;
    matrices->m[1][0] = 0.0F;
    matrices->m[1][1] = p->m;
    matrices->c0[0][0] = c;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[1][0] = 0.0F;
    matrices->c0[1][1] = c;
    matrices->kc[0][0] = p->k;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = p->k;
    matrices->k1[0][0] = 0.0F;
    matrices->k1[0][1] = circulation;
    matrices->k1[1][0] = K1_21;
    matrices->k1[1][1] = 0.0F;
}

carvallo_system_error_t jeffcott_rotor_f32_at_speed(const jeffcott_rotor_f32_matrices_t *matrices,
    float speed, jeffcott_rotor_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed);
    bool is_in_range = true;
    for (size_t row = 0U; row < JEFFCOTT_ROTOR_N; row++) {
        for (size_t column = 0U; column < JEFFCOTT_ROTOR_N; column++) {
            const float damping = matrices->c0[row][column];
            const float stiffness = matrices->kc[row][column] + (matrices->k1[row][column] * speed);
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->c0[row][column]) &&
                carvallo_is_finite_f32(matrices->kc[row][column]) &&
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

carvallo_system_error_t jeffcott_rotor_f32_state_space(const jeffcott_rotor_f32_system_t *system,
    jeffcott_rotor_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[JEFFCOTT_ROTOR_N * JEFFCOTT_ROTOR_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * JEFFCOTT_ROTOR_N * JEFFCOTT_ROTOR_N];
    for (size_t row = 0U; row < JEFFCOTT_ROTOR_N; row++) {
        float *const solved = &x[3U * JEFFCOTT_ROTOR_N * row];
        for (size_t column = 0U; column < JEFFCOTT_ROTOR_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * JEFFCOTT_ROTOR_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[JEFFCOTT_ROTOR_N + column] = -system->c[row][column];
            solved[(2U * JEFFCOTT_ROTOR_N) + column] = 0.0F;
        }
        solved[(2U * JEFFCOTT_ROTOR_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[JEFFCOTT_ROTOR_N * JEFFCOTT_ROTOR_N];
        error = carvallo_solve_f32(JEFFCOTT_ROTOR_N, m, terms, 3U * JEFFCOTT_ROTOR_N, x);
    }
    for (size_t row = 0U; row < (2U * JEFFCOTT_ROTOR_N); row++) {
        for (size_t column = 0U; column < (2U * JEFFCOTT_ROTOR_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < JEFFCOTT_ROTOR_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < JEFFCOTT_ROTOR_N; row++) {
            const size_t target = JEFFCOTT_ROTOR_N + row;
            for (size_t column = 0U; column < (2U * JEFFCOTT_ROTOR_N); column++) {
                space->a[target][column] = x[(3U * JEFFCOTT_ROTOR_N * row) + column];
            }
            for (size_t column = 0U; column < JEFFCOTT_ROTOR_N; column++) {
                space->b[target][column] = x[(3U * JEFFCOTT_ROTOR_N * row) + (2U *
                    JEFFCOTT_ROTOR_N) + column];
            }
            space->a[row][JEFFCOTT_ROTOR_N + row] = 1.0F;
        }
    }
    return error;
}

void jeffcott_rotor_f32_derivatives(const jeffcott_rotor_f32_t *p,
    jeffcott_rotor_f32_matrices_t *matrices, jeffcott_rotor_f32_derivatives_t *derivatives)
{
    const float c = p->ce + p->ci;
    const float K1_12_ci = 1.0F / p->R;
    const float circulation = p->ci * K1_12_ci;
    const float K1_21_R = K1_12_ci * circulation;
    const float K1_21 = -circulation;
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = 0.0F;
    matrices->m[1][0] = 0.0F;
    matrices->m[1][1] = p->m;
    matrices->c0[0][0] = c;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[1][0] = 0.0F;
    matrices->c0[1][1] = c;
    matrices->kc[0][0] = p->k;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = p->k;
    matrices->k1[0][0] = 0.0F;
    matrices->k1[0][1] = circulation;
    matrices->k1[1][0] = K1_21;
    matrices->k1[1][1] = 0.0F;
    derivatives->values[0] = 1.0F;
    derivatives->values[1] = K1_12_ci;
    derivatives->values[2] = K1_21_R;
}

void jeffcott_rotor_f32_with_respect_to(const jeffcott_rotor_f32_derivatives_t *derivatives,
    size_t parameter, jeffcott_rotor_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < JEFFCOTT_ROTOR_N; row++) {
        for (size_t column = 0U; column < JEFFCOTT_ROTOR_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c0[row][column] = 0.0F;
            matrices->kc[row][column] = 0.0F;
            matrices->k1[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < JEFFCOTT_ROTOR_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &jeffcott_rotor_partials[position];
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
            case CARVALLO_MATRIX_KC:
                matrices->kc[partial->row][partial->column] = signed_value;
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
