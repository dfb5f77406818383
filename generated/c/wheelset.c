/* @generated from generated/models/wheelset.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 37c3f8eae70bff1e
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * M_11 = m [kg]
 * M_22 = I [kg*m^2]
 * C-1_11 = 2*f22 [kg*m/s^2]
 * C-1_22 = 2*f11*b^2 [kg*m^3/s^2]
 * Kc_11 = ky [kg/s^2]
 * Kc_12 = -2*f22 [kg*m/s^2]
 * Kc_21 = 2*f11*b*lam/r [kg*m/s^2]
 * Kc_22 = kpsi [kg*m^2/s^2]
 * @endverbatim
 */

#include "wheelset.h"

#include <float.h>

const char *wheelset_set_name(wheelset_set_t set)
{
    static const char *const TEXTS[] = {
        "example",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *wheelset_validity_text(wheelset_validity_t validity)
{
    static const char *const TEXTS[] = {
        "Wheelset: the parameters are valid",
        "Wheelset: m in kg must be finite and > 0",
        "Wheelset: I in kg*m^2 must be finite and > 0",
        "Wheelset: f11 in N must be finite and > 0",
        "Wheelset: f22 in N must be finite and > 0",
        "Wheelset: b in m must be finite and > 0",
        "Wheelset: lam must be finite and > 0",
        "Wheelset: r in m must be finite and > 0",
        "Wheelset: ky in N/m must be finite and >= 0",
        "Wheelset: kpsi in N*m/rad must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t wheelset_partials[WHEELSET_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 0U, false},
    {CARVALLO_MATRIX_CM1, 1U, 1U, 2U, 3U, false},
    {CARVALLO_MATRIX_KC, 1U, 0U, 2U, 6U, false},
    {CARVALLO_MATRIX_CM1, 0U, 0U, 3U, 1U, false},
    {CARVALLO_MATRIX_KC, 0U, 1U, 3U, 2U, false},
    {CARVALLO_MATRIX_CM1, 1U, 1U, 4U, 4U, false},
    {CARVALLO_MATRIX_KC, 1U, 0U, 4U, 8U, false},
    {CARVALLO_MATRIX_KC, 1U, 0U, 5U, 5U, false},
    {CARVALLO_MATRIX_KC, 1U, 0U, 6U, 7U, true},
    {CARVALLO_MATRIX_KC, 0U, 0U, 7U, 0U, false},
    {CARVALLO_MATRIX_KC, 1U, 1U, 8U, 0U, false}
};

const wheelset_f64_t wheelset_f64_sets[WHEELSET_SETS] = {
    { /* example */
        .m = 1250.0,
        .I_ = 700.0,
        .f11 = 10000000.0,
        .f22 = 10000000.0,
        .b = 0.7,
        .lam = 0.15,
        .r = 0.45,
        .ky = 200000.0,
        .kpsi = 200000.0
    }
};

wheelset_validity_t wheelset_f64_validate(const wheelset_f64_t *p)
{
    wheelset_validity_t validity = WHEELSET_VALID;
    if (!((p->m > 0.0) && (p->m <= DBL_MAX))) {
        validity = WHEELSET_INVALID_m;
    } else if (!((p->I_ > 0.0) && (p->I_ <= DBL_MAX))) {
        validity = WHEELSET_INVALID_I_;
    } else if (!((p->f11 > 0.0) && (p->f11 <= DBL_MAX))) {
        validity = WHEELSET_INVALID_f11;
    } else if (!((p->f22 > 0.0) && (p->f22 <= DBL_MAX))) {
        validity = WHEELSET_INVALID_f22;
    } else if (!((p->b > 0.0) && (p->b <= DBL_MAX))) {
        validity = WHEELSET_INVALID_b;
    } else if (!((p->lam > 0.0) && (p->lam <= DBL_MAX))) {
        validity = WHEELSET_INVALID_lam;
    } else if (!((p->r > 0.0) && (p->r <= DBL_MAX))) {
        validity = WHEELSET_INVALID_r;
    } else if (!((p->ky >= 0.0) && (p->ky <= DBL_MAX))) {
        validity = WHEELSET_INVALID_ky;
    } else if (!((p->kpsi >= 0.0) && (p->kpsi <= DBL_MAX))) {
        validity = WHEELSET_INVALID_kpsi;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void wheelset_f64_matrices(const wheelset_f64_t *p, wheelset_f64_matrices_t *matrices)
{
    const double Cm1_11 = p->f22 + p->f22;
    const double t8 = p->b * (p->f11 + p->f11);
    const double Cm1_22 = p->b * t8;
    const double Kc_21 = t8 * p->lam / p->r;
    const double Kc_12 = -Cm1_11;
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = 0.0;
    matrices->m[1][0] = 0.0;
    matrices->m[1][1] = p->I_;
    matrices->cm1[0][0] = Cm1_11;
    matrices->cm1[0][1] = 0.0;
    matrices->cm1[1][0] = 0.0;
    matrices->cm1[1][1] = Cm1_22;
    matrices->kc[0][0] = p->ky;
    matrices->kc[0][1] = Kc_12;
    matrices->kc[1][0] = Kc_21;
    matrices->kc[1][1] = p->kpsi;
}

carvallo_system_error_t wheelset_f64_at_speed(const wheelset_f64_matrices_t *matrices, double speed,
    wheelset_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed);
    bool is_in_range = true;
    const bool moves = (speed < 0.0) || (speed > 0.0);
    bool is_at_rest = false;
    for (size_t row = 0U; row < WHEELSET_N; row++) {
        for (size_t column = 0U; column < WHEELSET_N; column++) {
            /* Where there is no C-1, nothing is divided by a speed of zero. */
            const double odd = matrices->cm1[row][column];
            const bool divides = (odd < 0.0) || (odd > 0.0);
            double divided = 0.0;
            if (divides && moves) {
                divided = odd / speed;
            } else {
                is_at_rest = is_at_rest || divides;
            }
            const double damping = divided;
            const double stiffness = matrices->kc[row][column];
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->cm1[row][column]) &&
                carvallo_is_finite_f64(matrices->kc[row][column]);
            is_in_range = is_in_range && carvallo_is_finite_f64(damping) &&
                carvallo_is_finite_f64(stiffness);
            system->m[row][column] = matrices->m[row][column];
            system->c[row][column] = damping;
            system->k[row][column] = stiffness;
        }
    }
    if (!is_finite) {
        error = CARVALLO_SYSTEM_NOT_FINITE;
    } else if (is_at_rest) {
        error = CARVALLO_SYSTEM_AT_REST;
    } else if (!is_in_range) {
        error = CARVALLO_SYSTEM_OUT_OF_RANGE;
    } else {
        /* All is well. */
    }
    return error;
}

carvallo_system_error_t wheelset_f64_state_space(const wheelset_f64_system_t *system,
    wheelset_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[WHEELSET_N * WHEELSET_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * WHEELSET_N * WHEELSET_N];
    for (size_t row = 0U; row < WHEELSET_N; row++) {
        double *const solved = &x[3U * WHEELSET_N * row];
        for (size_t column = 0U; column < WHEELSET_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * WHEELSET_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHEELSET_N + column] = -system->c[row][column];
            solved[(2U * WHEELSET_N) + column] = 0.0;
        }
        solved[(2U * WHEELSET_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[WHEELSET_N * WHEELSET_N];
        error = carvallo_solve_f64(WHEELSET_N, m, terms, 3U * WHEELSET_N, x);
    }
    for (size_t row = 0U; row < (2U * WHEELSET_N); row++) {
        for (size_t column = 0U; column < (2U * WHEELSET_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < WHEELSET_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHEELSET_N; row++) {
            const size_t target = WHEELSET_N + row;
            for (size_t column = 0U; column < (2U * WHEELSET_N); column++) {
                space->a[target][column] = x[(3U * WHEELSET_N * row) + column];
            }
            for (size_t column = 0U; column < WHEELSET_N; column++) {
                space->b[target][column] = x[(3U * WHEELSET_N * row) + (2U * WHEELSET_N) + column];
            }
            space->a[row][WHEELSET_N + row] = 1.0;
        }
    }
    return error;
}

void wheelset_f64_derivatives(const wheelset_f64_t *p, wheelset_f64_matrices_t *matrices,
    wheelset_f64_derivatives_t *derivatives)
{
    const double Cm1_11 = p->f22 + p->f22;
    const double t14 = p->b + p->b;
    const double Cm1_22_f11 = p->b * t14;
    const double Cm1_22 = p->f11 * Cm1_22_f11;
    const double t17 = p->f11 * t14;
    const double t18 = 1.0 / p->r;
    const double Cm1_22_b = t17 + t17;
    const double Kc_12 = -Cm1_11;
    const double Kc_21_lam = t17 * t18;
    const double t22 = p->lam * t18;
    const double Kc_21 = p->lam * Kc_21_lam;
    const double Kc_21_f11 = t14 * t22;
    const double t25 = p->f11 * t22;
    const double t26 = Kc_21_lam * t22;
    const double Kc_21_b = t25 + t25;
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = 0.0;
    matrices->m[1][0] = 0.0;
    matrices->m[1][1] = p->I_;
    matrices->cm1[0][0] = Cm1_11;
    matrices->cm1[0][1] = 0.0;
    matrices->cm1[1][0] = 0.0;
    matrices->cm1[1][1] = Cm1_22;
    matrices->kc[0][0] = p->ky;
    matrices->kc[0][1] = Kc_12;
    matrices->kc[1][0] = Kc_21;
    matrices->kc[1][1] = p->kpsi;
    derivatives->values[0] = 1.0;
    derivatives->values[1] = 2.0;
    derivatives->values[2] = (-2.0);
    derivatives->values[3] = Cm1_22_f11;
    derivatives->values[4] = Cm1_22_b;
    derivatives->values[5] = Kc_21_lam;
    derivatives->values[6] = Kc_21_f11;
    derivatives->values[7] = t26;
    derivatives->values[8] = Kc_21_b;
}

void wheelset_f64_with_respect_to(const wheelset_f64_derivatives_t *derivatives, size_t parameter,
    wheelset_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHEELSET_N; row++) {
        for (size_t column = 0U; column < WHEELSET_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->cm1[row][column] = 0.0;
            matrices->kc[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < WHEELSET_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &wheelset_partials[position];
        if (partial->parameter == parameter) {
            const double value = derivatives->values[partial->value];
            const double signed_value = partial->is_negative ? (-value) : value;
            switch (partial->matrix) {
            case CARVALLO_MATRIX_M:
                matrices->m[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_CM1:
                matrices->cm1[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_KC:
                matrices->kc[partial->row][partial->column] = signed_value;
                break;
            default:
                /* The model has no other matrix. */
                break;
            }
        }
    }
}

const wheelset_f32_t wheelset_f32_sets[WHEELSET_SETS] = {
    { /* example */
        .m = 1250.0F,
        .I_ = 700.0F,
        .f11 = 10000000.0F,
        .f22 = 10000000.0F,
        .b = 0.7F,
        .lam = 0.15F,
        .r = 0.45F,
        .ky = 200000.0F,
        .kpsi = 200000.0F
    }
};

wheelset_validity_t wheelset_f32_validate(const wheelset_f32_t *p)
{
    wheelset_validity_t validity = WHEELSET_VALID;
    if (!((p->m > 0.0F) && (p->m <= FLT_MAX))) {
        validity = WHEELSET_INVALID_m;
    } else if (!((p->I_ > 0.0F) && (p->I_ <= FLT_MAX))) {
        validity = WHEELSET_INVALID_I_;
    } else if (!((p->f11 > 0.0F) && (p->f11 <= FLT_MAX))) {
        validity = WHEELSET_INVALID_f11;
    } else if (!((p->f22 > 0.0F) && (p->f22 <= FLT_MAX))) {
        validity = WHEELSET_INVALID_f22;
    } else if (!((p->b > 0.0F) && (p->b <= FLT_MAX))) {
        validity = WHEELSET_INVALID_b;
    } else if (!((p->lam > 0.0F) && (p->lam <= FLT_MAX))) {
        validity = WHEELSET_INVALID_lam;
    } else if (!((p->r > 0.0F) && (p->r <= FLT_MAX))) {
        validity = WHEELSET_INVALID_r;
    } else if (!((p->ky >= 0.0F) && (p->ky <= FLT_MAX))) {
        validity = WHEELSET_INVALID_ky;
    } else if (!((p->kpsi >= 0.0F) && (p->kpsi <= FLT_MAX))) {
        validity = WHEELSET_INVALID_kpsi;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void wheelset_f32_matrices(const wheelset_f32_t *p, wheelset_f32_matrices_t *matrices)
{
    const float Cm1_11 = p->f22 + p->f22;
    const float t8 = p->b * (p->f11 + p->f11);
    const float Cm1_22 = p->b * t8;
    const float Kc_21 = t8 * p->lam / p->r;
    const float Kc_12 = -Cm1_11;
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = 0.0F;
    matrices->m[1][0] = 0.0F;
    matrices->m[1][1] = p->I_;
    matrices->cm1[0][0] = Cm1_11;
    matrices->cm1[0][1] = 0.0F;
    matrices->cm1[1][0] = 0.0F;
    matrices->cm1[1][1] = Cm1_22;
    matrices->kc[0][0] = p->ky;
    matrices->kc[0][1] = Kc_12;
    matrices->kc[1][0] = Kc_21;
    matrices->kc[1][1] = p->kpsi;
}

carvallo_system_error_t wheelset_f32_at_speed(const wheelset_f32_matrices_t *matrices, float speed,
    wheelset_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed);
    bool is_in_range = true;
    const bool moves = (speed < 0.0F) || (speed > 0.0F);
    bool is_at_rest = false;
    for (size_t row = 0U; row < WHEELSET_N; row++) {
        for (size_t column = 0U; column < WHEELSET_N; column++) {
            /* Where there is no C-1, nothing is divided by a speed of zero. */
            const float odd = matrices->cm1[row][column];
            const bool divides = (odd < 0.0F) || (odd > 0.0F);
            float divided = 0.0F;
            if (divides && moves) {
                divided = odd / speed;
            } else {
                is_at_rest = is_at_rest || divides;
            }
            const float damping = divided;
            const float stiffness = matrices->kc[row][column];
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->cm1[row][column]) &&
                carvallo_is_finite_f32(matrices->kc[row][column]);
            is_in_range = is_in_range && carvallo_is_finite_f32(damping) &&
                carvallo_is_finite_f32(stiffness);
            system->m[row][column] = matrices->m[row][column];
            system->c[row][column] = damping;
            system->k[row][column] = stiffness;
        }
    }
    if (!is_finite) {
        error = CARVALLO_SYSTEM_NOT_FINITE;
    } else if (is_at_rest) {
        error = CARVALLO_SYSTEM_AT_REST;
    } else if (!is_in_range) {
        error = CARVALLO_SYSTEM_OUT_OF_RANGE;
    } else {
        /* All is well. */
    }
    return error;
}

carvallo_system_error_t wheelset_f32_state_space(const wheelset_f32_system_t *system,
    wheelset_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[WHEELSET_N * WHEELSET_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * WHEELSET_N * WHEELSET_N];
    for (size_t row = 0U; row < WHEELSET_N; row++) {
        float *const solved = &x[3U * WHEELSET_N * row];
        for (size_t column = 0U; column < WHEELSET_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * WHEELSET_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHEELSET_N + column] = -system->c[row][column];
            solved[(2U * WHEELSET_N) + column] = 0.0F;
        }
        solved[(2U * WHEELSET_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[WHEELSET_N * WHEELSET_N];
        error = carvallo_solve_f32(WHEELSET_N, m, terms, 3U * WHEELSET_N, x);
    }
    for (size_t row = 0U; row < (2U * WHEELSET_N); row++) {
        for (size_t column = 0U; column < (2U * WHEELSET_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < WHEELSET_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHEELSET_N; row++) {
            const size_t target = WHEELSET_N + row;
            for (size_t column = 0U; column < (2U * WHEELSET_N); column++) {
                space->a[target][column] = x[(3U * WHEELSET_N * row) + column];
            }
            for (size_t column = 0U; column < WHEELSET_N; column++) {
                space->b[target][column] = x[(3U * WHEELSET_N * row) + (2U * WHEELSET_N) + column];
            }
            space->a[row][WHEELSET_N + row] = 1.0F;
        }
    }
    return error;
}

void wheelset_f32_derivatives(const wheelset_f32_t *p, wheelset_f32_matrices_t *matrices,
    wheelset_f32_derivatives_t *derivatives)
{
    const float Cm1_11 = p->f22 + p->f22;
    const float t14 = p->b + p->b;
    const float Cm1_22_f11 = p->b * t14;
    const float Cm1_22 = p->f11 * Cm1_22_f11;
    const float t17 = p->f11 * t14;
    const float t18 = 1.0F / p->r;
    const float Cm1_22_b = t17 + t17;
    const float Kc_12 = -Cm1_11;
    const float Kc_21_lam = t17 * t18;
    const float t22 = p->lam * t18;
    const float Kc_21 = p->lam * Kc_21_lam;
    const float Kc_21_f11 = t14 * t22;
    const float t25 = p->f11 * t22;
    const float t26 = Kc_21_lam * t22;
    const float Kc_21_b = t25 + t25;
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = 0.0F;
    matrices->m[1][0] = 0.0F;
    matrices->m[1][1] = p->I_;
    matrices->cm1[0][0] = Cm1_11;
    matrices->cm1[0][1] = 0.0F;
    matrices->cm1[1][0] = 0.0F;
    matrices->cm1[1][1] = Cm1_22;
    matrices->kc[0][0] = p->ky;
    matrices->kc[0][1] = Kc_12;
    matrices->kc[1][0] = Kc_21;
    matrices->kc[1][1] = p->kpsi;
    derivatives->values[0] = 1.0F;
    derivatives->values[1] = 2.0F;
    derivatives->values[2] = (-2.0F);
    derivatives->values[3] = Cm1_22_f11;
    derivatives->values[4] = Cm1_22_b;
    derivatives->values[5] = Kc_21_lam;
    derivatives->values[6] = Kc_21_f11;
    derivatives->values[7] = t26;
    derivatives->values[8] = Kc_21_b;
}

void wheelset_f32_with_respect_to(const wheelset_f32_derivatives_t *derivatives, size_t parameter,
    wheelset_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHEELSET_N; row++) {
        for (size_t column = 0U; column < WHEELSET_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->cm1[row][column] = 0.0F;
            matrices->kc[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < WHEELSET_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &wheelset_partials[position];
        if (partial->parameter == parameter) {
            const float value = derivatives->values[partial->value];
            const float signed_value = partial->is_negative ? (-value) : value;
            switch (partial->matrix) {
            case CARVALLO_MATRIX_M:
                matrices->m[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_CM1:
                matrices->cm1[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_KC:
                matrices->kc[partial->row][partial->column] = signed_value;
                break;
            default:
                /* The model has no other matrix. */
                break;
            }
        }
    }
}
