/* @generated from generated/models/typical_section.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 648bb7d66536ca12
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * imbalance = m*b*(e - a) [kg*m]
 * lift = 2*pi*rho*b*s [kg/m]
 * arm = b*(1/2 + a) [m]
 * M_11 = m [kg]
 * M_12 = M_21 = imbalance [kg*m]
 * M_22 = I [kg*m^2]
 * Kc_11 = kh [kg/s^2]
 * Kc_22 = ktheta [kg*m^2/s^2]
 * K2_12 = lift [kg/m]
 * K2_22 = -lift*arm [kg]
 * @endverbatim
 */

#include "typical_section.h"

#include <float.h>

const char *typical_section_set_name(typical_section_set_t set)
{
    static const char *const TEXTS[] = {
        "dimensionless",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *typical_section_validity_text(typical_section_validity_t validity)
{
    static const char *const TEXTS[] = {
        "TypicalSection: the parameters are valid",
        "TypicalSection: m in kg must be finite and > 0",
        "TypicalSection: I in kg*m^2 must be finite and > 0",
        "TypicalSection: b in m must be finite and > 0",
        "TypicalSection: s in m must be finite and > 0",
        "TypicalSection: a must be finite and >= -1 and <= 1",
        "TypicalSection: e must be finite and >= -1 and <= 1",
        "TypicalSection: kh in N/m must be finite and >= 0",
        "TypicalSection: ktheta in N*m/rad must be finite and >= 0",
        "TypicalSection: rho in kg/m^3 must be finite and >= 0",
        "TypicalSection: I - m*b^2*(e - a)^2 in kg*m^2 must be finite and > 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t typical_section_partials[TYPICAL_SECTION_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 1U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 1U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 0U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 2U, 3U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 2U, 3U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 2U, 2U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 2U, 9U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 3U, 4U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 3U, 6U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 4U, 5U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 4U, 5U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 4U, 10U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 5U, 5U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 5U, 5U, false},
    {CARVALLO_MATRIX_KC, 0U, 0U, 6U, 0U, false},
    {CARVALLO_MATRIX_KC, 1U, 1U, 7U, 0U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 8U, 7U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 8U, 8U, true}
};

const typical_section_f64_t typical_section_f64_sets[TYPICAL_SECTION_SETS] = {
    { /* dimensionless */
        .m = 1.0,
        .I_ = 0.24,
        .b = 1.0,
        .s = 1.0,
        .a = (-0.2),
        .e = (-0.1),
        .kh = 0.16,
        .ktheta = 0.24,
        .rho = 0.015915494309189534
    }
};

typical_section_validity_t typical_section_f64_validate(const typical_section_f64_t *p)
{
    typical_section_validity_t validity = TYPICAL_SECTION_VALID;
    if (!((p->m > 0.0) && (p->m <= DBL_MAX))) {
        validity = TYPICAL_SECTION_INVALID_m;
    } else if (!((p->I_ > 0.0) && (p->I_ <= DBL_MAX))) {
        validity = TYPICAL_SECTION_INVALID_I_;
    } else if (!((p->b > 0.0) && (p->b <= DBL_MAX))) {
        validity = TYPICAL_SECTION_INVALID_b;
    } else if (!((p->s > 0.0) && (p->s <= DBL_MAX))) {
        validity = TYPICAL_SECTION_INVALID_s;
    } else if (!((p->a >= (-1.0)) && (p->a <= 1.0))) {
        validity = TYPICAL_SECTION_INVALID_a;
    } else if (!((p->e >= (-1.0)) && (p->e <= 1.0))) {
        validity = TYPICAL_SECTION_INVALID_e;
    } else if (!((p->kh >= 0.0) && (p->kh <= DBL_MAX))) {
        validity = TYPICAL_SECTION_INVALID_kh;
    } else if (!((p->ktheta >= 0.0) && (p->ktheta <= DBL_MAX))) {
        validity = TYPICAL_SECTION_INVALID_ktheta;
    } else if (!((p->rho >= 0.0) && (p->rho <= DBL_MAX))) {
        validity = TYPICAL_SECTION_INVALID_rho;
    } else {
        const double t6 = p->b * (p->e - p->a);
        const double t9 = p->I_ - (p->m * t6 * t6);
        if (!((t9 > 0.0) && (t9 <= DBL_MAX))) {
            validity = TYPICAL_SECTION_REQUIREMENT_1;
        } else {
            /* All requirements hold. */
        }
    }
    return validity;
}

void typical_section_f64_matrices(const typical_section_f64_t *p, typical_section_f64_matrices_t *matrices)
{
    const double imbalance = p->m * p->b * (p->e - p->a);
    const double t16 = p->b * p->s * p->rho * 3.141592653589793;
    const double lift = t16 + t16;
    const double K2_22 = -(p->b * lift * (p->a + 0.5));
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = imbalance;
    matrices->m[1][0] = imbalance;
    matrices->m[1][1] = p->I_;
    matrices->kc[0][0] = p->kh;
    matrices->kc[0][1] = 0.0;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = p->ktheta;
    matrices->k2[0][0] = 0.0;
    matrices->k2[0][1] = lift;
    matrices->k2[1][0] = 0.0;
    matrices->k2[1][1] = K2_22;
}

carvallo_system_error_t typical_section_f64_at_speed(const typical_section_f64_matrices_t *matrices,
    double speed, typical_section_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed);
    bool is_in_range = true;
    for (size_t row = 0U; row < TYPICAL_SECTION_N; row++) {
        for (size_t column = 0U; column < TYPICAL_SECTION_N; column++) {
            const double damping = 0.0;
            const double stiffness = matrices->kc[row][column] + (matrices->k2[row][column] *
                speed * speed);
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->kc[row][column]) &&
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

carvallo_system_error_t typical_section_f64_state_space(const typical_section_f64_system_t *system,
    typical_section_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[TYPICAL_SECTION_N * TYPICAL_SECTION_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * TYPICAL_SECTION_N * TYPICAL_SECTION_N];
    for (size_t row = 0U; row < TYPICAL_SECTION_N; row++) {
        double *const solved = &x[3U * TYPICAL_SECTION_N * row];
        for (size_t column = 0U; column < TYPICAL_SECTION_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * TYPICAL_SECTION_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[TYPICAL_SECTION_N + column] = -system->c[row][column];
            solved[(2U * TYPICAL_SECTION_N) + column] = 0.0;
        }
        solved[(2U * TYPICAL_SECTION_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[TYPICAL_SECTION_N * TYPICAL_SECTION_N];
        error = carvallo_solve_f64(TYPICAL_SECTION_N, m, terms, 3U * TYPICAL_SECTION_N, x);
    }
    for (size_t row = 0U; row < (2U * TYPICAL_SECTION_N); row++) {
        for (size_t column = 0U; column < (2U * TYPICAL_SECTION_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < TYPICAL_SECTION_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < TYPICAL_SECTION_N; row++) {
            const size_t target = TYPICAL_SECTION_N + row;
            for (size_t column = 0U; column < (2U * TYPICAL_SECTION_N); column++) {
                space->a[target][column] = x[(3U * TYPICAL_SECTION_N * row) + column];
            }
            for (size_t column = 0U; column < TYPICAL_SECTION_N; column++) {
                space->b[target][column] = x[(3U * TYPICAL_SECTION_N * row) + (2U *
                    TYPICAL_SECTION_N) + column];
            }
            space->a[row][TYPICAL_SECTION_N + row] = 1.0;
        }
    }
    return error;
}

void typical_section_f64_derivatives(const typical_section_f64_t *p,
    typical_section_f64_matrices_t *matrices, typical_section_f64_derivatives_t *derivatives)
{
    const double t13 = p->e - p->a;
    const double M_12_m = t13 * p->b;
    const double imbalance = p->m * M_12_m;
    const double t16 = 3.141592653589793 + 3.141592653589793;
    const double t17 = p->rho * t16;
    const double lift_b = p->s * t17;
    const double t19 = p->a + 0.5;
    const double arm = p->b * t19;
    const double M_12_b = p->m * t13;
    const double lift_s = p->b * t17;
    const double M_12_e = p->m * p->b;
    const double lift = p->b * lift_b;
    const double t25 = arm * lift_s;
    const double lift_rho = p->b * p->s * t16;
    const double t28 = arm * lift_rho;
    const double t30 = lift * (t19 + t19);
    const double t31 = p->b * lift;
    const double K2_22 = -(lift * arm);
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = imbalance;
    matrices->m[1][0] = imbalance;
    matrices->m[1][1] = p->I_;
    matrices->kc[0][0] = p->kh;
    matrices->kc[0][1] = 0.0;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = p->ktheta;
    matrices->k2[0][0] = 0.0;
    matrices->k2[0][1] = lift;
    matrices->k2[1][0] = 0.0;
    matrices->k2[1][1] = K2_22;
    derivatives->values[0] = 1.0;
    derivatives->values[1] = M_12_m;
    derivatives->values[2] = lift_b;
    derivatives->values[3] = M_12_b;
    derivatives->values[4] = lift_s;
    derivatives->values[5] = M_12_e;
    derivatives->values[6] = t25;
    derivatives->values[7] = lift_rho;
    derivatives->values[8] = t28;
    derivatives->values[9] = t30;
    derivatives->values[10] = t31;
}

void typical_section_f64_with_respect_to(const typical_section_f64_derivatives_t *derivatives,
    size_t parameter, typical_section_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < TYPICAL_SECTION_N; row++) {
        for (size_t column = 0U; column < TYPICAL_SECTION_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->kc[row][column] = 0.0;
            matrices->k2[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < TYPICAL_SECTION_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &typical_section_partials[position];
        if (partial->parameter == parameter) {
            const double value = derivatives->values[partial->value];
            const double signed_value = partial->is_negative ? (-value) : value;
            switch (partial->matrix) {
            case CARVALLO_MATRIX_M:
                matrices->m[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_KC:
                matrices->kc[partial->row][partial->column] = signed_value;
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

const typical_section_f32_t typical_section_f32_sets[TYPICAL_SECTION_SETS] = {
    { /* dimensionless */
        .m = 1.0F,
        .I_ = 0.24F,
        .b = 1.0F,
        .s = 1.0F,
        .a = (-0.2F),
        .e = (-0.1F),
        .kh = 0.16F,
        .ktheta = 0.24F,
        .rho = 0.015915494F
    }
};

typical_section_validity_t typical_section_f32_validate(const typical_section_f32_t *p)
{
    typical_section_validity_t validity = TYPICAL_SECTION_VALID;
    if (!((p->m > 0.0F) && (p->m <= FLT_MAX))) {
        validity = TYPICAL_SECTION_INVALID_m;
    } else if (!((p->I_ > 0.0F) && (p->I_ <= FLT_MAX))) {
        validity = TYPICAL_SECTION_INVALID_I_;
    } else if (!((p->b > 0.0F) && (p->b <= FLT_MAX))) {
        validity = TYPICAL_SECTION_INVALID_b;
    } else if (!((p->s > 0.0F) && (p->s <= FLT_MAX))) {
        validity = TYPICAL_SECTION_INVALID_s;
    } else if (!((p->a >= (-1.0F)) && (p->a <= 1.0F))) {
        validity = TYPICAL_SECTION_INVALID_a;
    } else if (!((p->e >= (-1.0F)) && (p->e <= 1.0F))) {
        validity = TYPICAL_SECTION_INVALID_e;
    } else if (!((p->kh >= 0.0F) && (p->kh <= FLT_MAX))) {
        validity = TYPICAL_SECTION_INVALID_kh;
    } else if (!((p->ktheta >= 0.0F) && (p->ktheta <= FLT_MAX))) {
        validity = TYPICAL_SECTION_INVALID_ktheta;
    } else if (!((p->rho >= 0.0F) && (p->rho <= FLT_MAX))) {
        validity = TYPICAL_SECTION_INVALID_rho;
    } else {
        const float t6 = p->b * (p->e - p->a);
        const float t9 = p->I_ - (p->m * t6 * t6);
        if (!((t9 > 0.0F) && (t9 <= FLT_MAX))) {
            validity = TYPICAL_SECTION_REQUIREMENT_1;
        } else {
            /* All requirements hold. */
        }
    }
    return validity;
}

void typical_section_f32_matrices(const typical_section_f32_t *p, typical_section_f32_matrices_t *matrices)
{
    const float imbalance = p->m * p->b * (p->e - p->a);
    const float t16 = p->b * p->s * p->rho * 3.1415927F;
    const float lift = t16 + t16;
    const float K2_22 = -(p->b * lift * (p->a + 0.5F));
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = imbalance;
    matrices->m[1][0] = imbalance;
    matrices->m[1][1] = p->I_;
    matrices->kc[0][0] = p->kh;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = p->ktheta;
    matrices->k2[0][0] = 0.0F;
    matrices->k2[0][1] = lift;
    matrices->k2[1][0] = 0.0F;
    matrices->k2[1][1] = K2_22;
}

carvallo_system_error_t typical_section_f32_at_speed(const typical_section_f32_matrices_t *matrices,
    float speed, typical_section_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed);
    bool is_in_range = true;
    for (size_t row = 0U; row < TYPICAL_SECTION_N; row++) {
        for (size_t column = 0U; column < TYPICAL_SECTION_N; column++) {
            const float damping = 0.0F;
            const float stiffness = matrices->kc[row][column] + (matrices->k2[row][column] * speed *
                speed);
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->kc[row][column]) &&
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

carvallo_system_error_t typical_section_f32_state_space(const typical_section_f32_system_t *system,
    typical_section_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[TYPICAL_SECTION_N * TYPICAL_SECTION_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * TYPICAL_SECTION_N * TYPICAL_SECTION_N];
    for (size_t row = 0U; row < TYPICAL_SECTION_N; row++) {
        float *const solved = &x[3U * TYPICAL_SECTION_N * row];
        for (size_t column = 0U; column < TYPICAL_SECTION_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * TYPICAL_SECTION_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[TYPICAL_SECTION_N + column] = -system->c[row][column];
            solved[(2U * TYPICAL_SECTION_N) + column] = 0.0F;
        }
        solved[(2U * TYPICAL_SECTION_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[TYPICAL_SECTION_N * TYPICAL_SECTION_N];
        error = carvallo_solve_f32(TYPICAL_SECTION_N, m, terms, 3U * TYPICAL_SECTION_N, x);
    }
    for (size_t row = 0U; row < (2U * TYPICAL_SECTION_N); row++) {
        for (size_t column = 0U; column < (2U * TYPICAL_SECTION_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < TYPICAL_SECTION_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < TYPICAL_SECTION_N; row++) {
            const size_t target = TYPICAL_SECTION_N + row;
            for (size_t column = 0U; column < (2U * TYPICAL_SECTION_N); column++) {
                space->a[target][column] = x[(3U * TYPICAL_SECTION_N * row) + column];
            }
            for (size_t column = 0U; column < TYPICAL_SECTION_N; column++) {
                space->b[target][column] = x[(3U * TYPICAL_SECTION_N * row) + (2U *
                    TYPICAL_SECTION_N) + column];
            }
            space->a[row][TYPICAL_SECTION_N + row] = 1.0F;
        }
    }
    return error;
}

void typical_section_f32_derivatives(const typical_section_f32_t *p,
    typical_section_f32_matrices_t *matrices, typical_section_f32_derivatives_t *derivatives)
{
    const float t13 = p->e - p->a;
    const float M_12_m = t13 * p->b;
    const float imbalance = p->m * M_12_m;
    const float t16 = 3.1415927F + 3.1415927F;
    const float t17 = p->rho * t16;
    const float lift_b = p->s * t17;
    const float t19 = p->a + 0.5F;
    const float arm = p->b * t19;
    const float M_12_b = p->m * t13;
    const float lift_s = p->b * t17;
    const float M_12_e = p->m * p->b;
    const float lift = p->b * lift_b;
    const float t25 = arm * lift_s;
    const float lift_rho = p->b * p->s * t16;
    const float t28 = arm * lift_rho;
    const float t30 = lift * (t19 + t19);
    const float t31 = p->b * lift;
    const float K2_22 = -(lift * arm);
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = imbalance;
    matrices->m[1][0] = imbalance;
    matrices->m[1][1] = p->I_;
    matrices->kc[0][0] = p->kh;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = p->ktheta;
    matrices->k2[0][0] = 0.0F;
    matrices->k2[0][1] = lift;
    matrices->k2[1][0] = 0.0F;
    matrices->k2[1][1] = K2_22;
    derivatives->values[0] = 1.0F;
    derivatives->values[1] = M_12_m;
    derivatives->values[2] = lift_b;
    derivatives->values[3] = M_12_b;
    derivatives->values[4] = lift_s;
    derivatives->values[5] = M_12_e;
    derivatives->values[6] = t25;
    derivatives->values[7] = lift_rho;
    derivatives->values[8] = t28;
    derivatives->values[9] = t30;
    derivatives->values[10] = t31;
}

void typical_section_f32_with_respect_to(const typical_section_f32_derivatives_t *derivatives,
    size_t parameter, typical_section_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < TYPICAL_SECTION_N; row++) {
        for (size_t column = 0U; column < TYPICAL_SECTION_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->kc[row][column] = 0.0F;
            matrices->k2[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < TYPICAL_SECTION_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &typical_section_partials[position];
        if (partial->parameter == parameter) {
            const float value = derivatives->values[partial->value];
            const float signed_value = partial->is_negative ? (-value) : value;
            switch (partial->matrix) {
            case CARVALLO_MATRIX_M:
                matrices->m[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_KC:
                matrices->kc[partial->row][partial->column] = signed_value;
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
