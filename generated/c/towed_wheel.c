/* @generated from generated/models/towed_wheel.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 7f4879efbc67535d
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * M_11 = I + m*a^2 [kg*m^2]
 * C0_22 = 1 [1]
 * C1_11 = m*a [kg*m]
 * Kc_11 = l^2*k [kg*m^2/s^2]
 * Kc_12 = l*k [kg*m/s^2]
 * K1_21 = -1 [1]
 * @endverbatim
 */

#include "towed_wheel.h"

#include <float.h>

const char *towed_wheel_set_name(towed_wheel_set_t set)
{
    static const char *const TEXTS[] = {
        "example",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *towed_wheel_validity_text(towed_wheel_validity_t validity)
{
    static const char *const TEXTS[] = {
        "TowedWheel: the parameters are valid",
        "TowedWheel: m in kg must be finite and > 0",
        "TowedWheel: I in kg*m^2 must be finite and > 0",
        "TowedWheel: l in m must be finite and > 0",
        "TowedWheel: a in m must be finite",
        "TowedWheel: k in N/m must be finite and > 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t towed_wheel_partials[TOWED_WHEEL_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 5U, false},
    {CARVALLO_MATRIX_C1, 0U, 0U, 0U, 2U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 1U, 4U, false},
    {CARVALLO_MATRIX_KC, 0U, 0U, 2U, 7U, false},
    {CARVALLO_MATRIX_KC, 0U, 1U, 2U, 3U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 3U, 8U, false},
    {CARVALLO_MATRIX_C1, 0U, 0U, 3U, 0U, false},
    {CARVALLO_MATRIX_KC, 0U, 0U, 4U, 6U, false},
    {CARVALLO_MATRIX_KC, 0U, 1U, 4U, 1U, false}
};

const towed_wheel_f64_t towed_wheel_f64_sets[TOWED_WHEEL_SETS] = {
    { /* example */
        .m = 5.0,
        .I_ = 1.05,
        .l = 1.0,
        .a = 0.5,
        .k = 1.5
    }
};

towed_wheel_validity_t towed_wheel_f64_validate(const towed_wheel_f64_t *p)
{
    towed_wheel_validity_t validity = TOWED_WHEEL_VALID;
    if (!((p->m > 0.0) && (p->m <= DBL_MAX))) {
        validity = TOWED_WHEEL_INVALID_m;
    } else if (!((p->I_ > 0.0) && (p->I_ <= DBL_MAX))) {
        validity = TOWED_WHEEL_INVALID_I_;
    } else if (!((p->l > 0.0) && (p->l <= DBL_MAX))) {
        validity = TOWED_WHEEL_INVALID_l;
    } else if (!((p->a >= -DBL_MAX) && (p->a <= DBL_MAX))) {
        validity = TOWED_WHEEL_INVALID_a;
    } else if (!((p->k > 0.0) && (p->k <= DBL_MAX))) {
        validity = TOWED_WHEEL_INVALID_k;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void towed_wheel_f64_matrices(const towed_wheel_f64_t *p, towed_wheel_f64_matrices_t *matrices)
{
    const double C1_11 = p->a * p->m;
    const double M_11 = p->I_ + (p->a * C1_11);
    const double Kc_12 = p->l * p->k;
    const double Kc_11 = p->l * Kc_12;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = 0.0;
    matrices->m[1][0] = 0.0;
    matrices->m[1][1] = 0.0;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = 0.0;
    matrices->c0[1][0] = 0.0;
    matrices->c0[1][1] = 1.0;
    matrices->c1[0][0] = C1_11;
    matrices->c1[0][1] = 0.0;
    matrices->c1[1][0] = 0.0;
    matrices->c1[1][1] = 0.0;
    matrices->kc[0][0] = Kc_11;
    matrices->kc[0][1] = Kc_12;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = 0.0;
    matrices->k1[0][0] = 0.0;
    matrices->k1[0][1] = 0.0;
    matrices->k1[1][0] = (-1.0);
    matrices->k1[1][1] = 0.0;
}

carvallo_system_error_t towed_wheel_f64_at_speed(const towed_wheel_f64_matrices_t *matrices,
    double speed, towed_wheel_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed);
    bool is_in_range = true;
    for (size_t row = 0U; row < TOWED_WHEEL_N; row++) {
        for (size_t column = 0U; column < TOWED_WHEEL_N; column++) {
            const double damping = matrices->c0[row][column] + (matrices->c1[row][column] * speed);
            const double stiffness = matrices->kc[row][column] + (matrices->k1[row][column] *
                speed);
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->c0[row][column]) &&
                carvallo_is_finite_f64(matrices->c1[row][column]) &&
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

carvallo_system_error_t towed_wheel_f64_state_space(const towed_wheel_f64_system_t *system,
    towed_wheel_f64_state_space_t *space)
{
    /* The row of A and B for each coordinate, and whether its position is a state beside its rate. */
    static const size_t TARGETS[TOWED_WHEEL_N] = {TOWED_WHEEL_N + 0U, 1U};
    static const bool HAS_BOTH[TOWED_WHEEL_N] = {true, false};
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[TOWED_WHEEL_N * TOWED_WHEEL_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * TOWED_WHEEL_N * TOWED_WHEEL_N];
    for (size_t row = 0U; row < TOWED_WHEEL_N; row++) {
        double *const solved = &x[3U * TOWED_WHEEL_N * row];
        for (size_t column = 0U; column < TOWED_WHEEL_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * TOWED_WHEEL_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[TOWED_WHEEL_N + column] = -system->c[row][column];
            solved[(2U * TOWED_WHEEL_N) + column] = 0.0;
        }
        solved[(2U * TOWED_WHEEL_N) + row] = 1.0;
        m[(row * TOWED_WHEEL_N) + 1U] = system->c[row][1];
        solved[TOWED_WHEEL_N + 1U] = 0.0;
    }
    if (is_finite) {
        double terms[TOWED_WHEEL_N * TOWED_WHEEL_N];
        error = carvallo_solve_f64(TOWED_WHEEL_N, m, terms, 3U * TOWED_WHEEL_N, x);
    }
    for (size_t row = 0U; row < (2U * TOWED_WHEEL_N); row++) {
        for (size_t column = 0U; column < (2U * TOWED_WHEEL_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < TOWED_WHEEL_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < TOWED_WHEEL_N; row++) {
            const size_t target = TARGETS[row];
            for (size_t column = 0U; column < (2U * TOWED_WHEEL_N); column++) {
                space->a[target][column] = x[(3U * TOWED_WHEEL_N * row) + column];
            }
            for (size_t column = 0U; column < TOWED_WHEEL_N; column++) {
                space->b[target][column] = x[(3U * TOWED_WHEEL_N * row) + (2U * TOWED_WHEEL_N) +
                    column];
            }
            if (HAS_BOTH[row]) {
                space->a[row][TOWED_WHEEL_N + row] = 1.0;
            }
        }
    }
    return error;
}

void towed_wheel_f64_derivatives(const towed_wheel_f64_t *p, towed_wheel_f64_matrices_t *matrices,
    towed_wheel_f64_derivatives_t *derivatives)
{
    const double M_11_m = p->a * p->a;
    const double M_11 = p->I_ + (p->m * M_11_m);
    const double C1_11 = p->m * p->a;
    const double Kc_11_k = p->l * p->l;
    const double Kc_11 = p->k * Kc_11_k;
    const double Kc_12 = p->k * p->l;
    const double Kc_11_l = Kc_12 + Kc_12;
    const double M_11_a = C1_11 + C1_11;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = 0.0;
    matrices->m[1][0] = 0.0;
    matrices->m[1][1] = 0.0;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = 0.0;
    matrices->c0[1][0] = 0.0;
    matrices->c0[1][1] = 1.0;
    matrices->c1[0][0] = C1_11;
    matrices->c1[0][1] = 0.0;
    matrices->c1[1][0] = 0.0;
    matrices->c1[1][1] = 0.0;
    matrices->kc[0][0] = Kc_11;
    matrices->kc[0][1] = Kc_12;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = 0.0;
    matrices->k1[0][0] = 0.0;
    matrices->k1[0][1] = 0.0;
    matrices->k1[1][0] = (-1.0);
    matrices->k1[1][1] = 0.0;
    derivatives->values[0] = p->m;
    derivatives->values[1] = p->l;
    derivatives->values[2] = p->a;
    derivatives->values[3] = p->k;
    derivatives->values[4] = 1.0;
    derivatives->values[5] = M_11_m;
    derivatives->values[6] = Kc_11_k;
    derivatives->values[7] = Kc_11_l;
    derivatives->values[8] = M_11_a;
}

void towed_wheel_f64_with_respect_to(const towed_wheel_f64_derivatives_t *derivatives,
    size_t parameter, towed_wheel_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < TOWED_WHEEL_N; row++) {
        for (size_t column = 0U; column < TOWED_WHEEL_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c0[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->kc[row][column] = 0.0;
            matrices->k1[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < TOWED_WHEEL_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &towed_wheel_partials[position];
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

const towed_wheel_f32_t towed_wheel_f32_sets[TOWED_WHEEL_SETS] = {
    { /* example */
        .m = 5.0F,
        .I_ = 1.05F,
        .l = 1.0F,
        .a = 0.5F,
        .k = 1.5F
    }
};

towed_wheel_validity_t towed_wheel_f32_validate(const towed_wheel_f32_t *p)
{
    towed_wheel_validity_t validity = TOWED_WHEEL_VALID;
    if (!((p->m > 0.0F) && (p->m <= FLT_MAX))) {
        validity = TOWED_WHEEL_INVALID_m;
    } else if (!((p->I_ > 0.0F) && (p->I_ <= FLT_MAX))) {
        validity = TOWED_WHEEL_INVALID_I_;
    } else if (!((p->l > 0.0F) && (p->l <= FLT_MAX))) {
        validity = TOWED_WHEEL_INVALID_l;
    } else if (!((p->a >= -FLT_MAX) && (p->a <= FLT_MAX))) {
        validity = TOWED_WHEEL_INVALID_a;
    } else if (!((p->k > 0.0F) && (p->k <= FLT_MAX))) {
        validity = TOWED_WHEEL_INVALID_k;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void towed_wheel_f32_matrices(const towed_wheel_f32_t *p, towed_wheel_f32_matrices_t *matrices)
{
    const float C1_11 = p->a * p->m;
    const float M_11 = p->I_ + (p->a * C1_11);
    const float Kc_12 = p->l * p->k;
    const float Kc_11 = p->l * Kc_12;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = 0.0F;
    matrices->m[1][0] = 0.0F;
    matrices->m[1][1] = 0.0F;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[1][0] = 0.0F;
    matrices->c0[1][1] = 1.0F;
    matrices->c1[0][0] = C1_11;
    matrices->c1[0][1] = 0.0F;
    matrices->c1[1][0] = 0.0F;
    matrices->c1[1][1] = 0.0F;
    matrices->kc[0][0] = Kc_11;
    matrices->kc[0][1] = Kc_12;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = 0.0F;
    matrices->k1[0][0] = 0.0F;
    matrices->k1[0][1] = 0.0F;
    matrices->k1[1][0] = (-1.0F);
    matrices->k1[1][1] = 0.0F;
}

carvallo_system_error_t towed_wheel_f32_at_speed(const towed_wheel_f32_matrices_t *matrices,
    float speed, towed_wheel_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed);
    bool is_in_range = true;
    for (size_t row = 0U; row < TOWED_WHEEL_N; row++) {
        for (size_t column = 0U; column < TOWED_WHEEL_N; column++) {
            const float damping = matrices->c0[row][column] + (matrices->c1[row][column] * speed);
            const float stiffness = matrices->kc[row][column] + (matrices->k1[row][column] * speed);
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->c0[row][column]) &&
                carvallo_is_finite_f32(matrices->c1[row][column]) &&
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

carvallo_system_error_t towed_wheel_f32_state_space(const towed_wheel_f32_system_t *system,
    towed_wheel_f32_state_space_t *space)
{
    /* The row of A and B for each coordinate, and whether its position is a state beside its rate. */
    static const size_t TARGETS[TOWED_WHEEL_N] = {TOWED_WHEEL_N + 0U, 1U};
    static const bool HAS_BOTH[TOWED_WHEEL_N] = {true, false};
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[TOWED_WHEEL_N * TOWED_WHEEL_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * TOWED_WHEEL_N * TOWED_WHEEL_N];
    for (size_t row = 0U; row < TOWED_WHEEL_N; row++) {
        float *const solved = &x[3U * TOWED_WHEEL_N * row];
        for (size_t column = 0U; column < TOWED_WHEEL_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * TOWED_WHEEL_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[TOWED_WHEEL_N + column] = -system->c[row][column];
            solved[(2U * TOWED_WHEEL_N) + column] = 0.0F;
        }
        solved[(2U * TOWED_WHEEL_N) + row] = 1.0F;
        m[(row * TOWED_WHEEL_N) + 1U] = system->c[row][1];
        solved[TOWED_WHEEL_N + 1U] = 0.0F;
    }
    if (is_finite) {
        float terms[TOWED_WHEEL_N * TOWED_WHEEL_N];
        error = carvallo_solve_f32(TOWED_WHEEL_N, m, terms, 3U * TOWED_WHEEL_N, x);
    }
    for (size_t row = 0U; row < (2U * TOWED_WHEEL_N); row++) {
        for (size_t column = 0U; column < (2U * TOWED_WHEEL_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < TOWED_WHEEL_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < TOWED_WHEEL_N; row++) {
            const size_t target = TARGETS[row];
            for (size_t column = 0U; column < (2U * TOWED_WHEEL_N); column++) {
                space->a[target][column] = x[(3U * TOWED_WHEEL_N * row) + column];
            }
            for (size_t column = 0U; column < TOWED_WHEEL_N; column++) {
                space->b[target][column] = x[(3U * TOWED_WHEEL_N * row) + (2U * TOWED_WHEEL_N) +
                    column];
            }
            if (HAS_BOTH[row]) {
                space->a[row][TOWED_WHEEL_N + row] = 1.0F;
            }
        }
    }
    return error;
}

void towed_wheel_f32_derivatives(const towed_wheel_f32_t *p, towed_wheel_f32_matrices_t *matrices,
    towed_wheel_f32_derivatives_t *derivatives)
{
    const float M_11_m = p->a * p->a;
    const float M_11 = p->I_ + (p->m * M_11_m);
    const float C1_11 = p->m * p->a;
    const float Kc_11_k = p->l * p->l;
    const float Kc_11 = p->k * Kc_11_k;
    const float Kc_12 = p->k * p->l;
    const float Kc_11_l = Kc_12 + Kc_12;
    const float M_11_a = C1_11 + C1_11;
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = 0.0F;
    matrices->m[1][0] = 0.0F;
    matrices->m[1][1] = 0.0F;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[1][0] = 0.0F;
    matrices->c0[1][1] = 1.0F;
    matrices->c1[0][0] = C1_11;
    matrices->c1[0][1] = 0.0F;
    matrices->c1[1][0] = 0.0F;
    matrices->c1[1][1] = 0.0F;
    matrices->kc[0][0] = Kc_11;
    matrices->kc[0][1] = Kc_12;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = 0.0F;
    matrices->k1[0][0] = 0.0F;
    matrices->k1[0][1] = 0.0F;
    matrices->k1[1][0] = (-1.0F);
    matrices->k1[1][1] = 0.0F;
    derivatives->values[0] = p->m;
    derivatives->values[1] = p->l;
    derivatives->values[2] = p->a;
    derivatives->values[3] = p->k;
    derivatives->values[4] = 1.0F;
    derivatives->values[5] = M_11_m;
    derivatives->values[6] = Kc_11_k;
    derivatives->values[7] = Kc_11_l;
    derivatives->values[8] = M_11_a;
}

void towed_wheel_f32_with_respect_to(const towed_wheel_f32_derivatives_t *derivatives,
    size_t parameter, towed_wheel_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < TOWED_WHEEL_N; row++) {
        for (size_t column = 0U; column < TOWED_WHEEL_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c0[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->kc[row][column] = 0.0F;
            matrices->k1[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < TOWED_WHEEL_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &towed_wheel_partials[position];
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
