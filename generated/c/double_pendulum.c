/* @generated from generated/models/double_pendulum.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 159450b9b3aa9cf1
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * Jxx_theta2 = I2 + a2^2*m2 [kg*m^2]
 * Sz_theta2 = -a2*m2 [kg*m]
 * Jxx_theta1 = I1 + Jxx_theta2 + a1^2*m1 - 2*l1*(Sz_theta2 - (1/2)*l1*m2) [kg*m^2]
 * Sz_theta1 = Sz_theta2 - l1*m2 - a1*m1 [kg*m]
 * M_theta1_theta2 = Jxx_theta2 - l1*Sz_theta2 [kg*m^2]
 * M_11 = Jxx_theta1 [kg*m^2]
 * M_12 = M_21 = M_theta1_theta2 [kg*m^2]
 * M_22 = Jxx_theta2 [kg*m^2]
 * K0_11 = Sz_theta1 [kg*m]
 * K0_12 = K0_21 = K0_22 = Sz_theta2 [kg*m]
 * @endverbatim
 */

#include "double_pendulum.h"

#include <float.h>

const char *double_pendulum_set_name(double_pendulum_set_t set)
{
    static const char *const TEXTS[] = {
        "rods",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *double_pendulum_validity_text(double_pendulum_validity_t validity)
{
    static const char *const TEXTS[] = {
        "DoublePendulum: the parameters are valid",
        "DoublePendulum: l1 in m must be finite and > 0",
        "DoublePendulum: a1 in m must be finite",
        "DoublePendulum: m1 in kg must be finite and >= 0",
        "DoublePendulum: I1 in kg*m^2 must be finite and >= 0",
        "DoublePendulum: a2 in m must be finite",
        "DoublePendulum: m2 in kg must be finite and >= 0",
        "DoublePendulum: I2 in kg*m^2 must be finite and >= 0",
        "DoublePendulum: g in N/kg must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t double_pendulum_partials[DOUBLE_PENDULUM_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 1U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 1U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 0U, 2U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 1U, 3U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 1U, 4U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 2U, 5U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 2U, 6U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 3U, 7U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 0U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 4U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 4U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 4U, 9U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 2U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 4U, 2U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 4U, 2U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 4U, 2U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 10U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 5U, 11U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 5U, 11U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 5U, 12U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 13U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 5U, 14U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 5U, 14U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 5U, 14U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 7U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 6U, 7U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 6U, 7U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 7U, false}
};

const double_pendulum_f64_t double_pendulum_f64_sets[DOUBLE_PENDULUM_SETS] = {
    { /* rods */
        .l1 = 1.0,
        .a1 = 0.5,
        .m1 = 1.0,
        .I1 = 0.08333333333333333,
        .a2 = 0.5,
        .m2 = 1.0,
        .I2 = 0.08333333333333333,
        .g = 9.81
    }
};

double_pendulum_validity_t double_pendulum_f64_validate(const double_pendulum_f64_t *p)
{
    double_pendulum_validity_t validity = DOUBLE_PENDULUM_VALID;
    if (!((p->l1 > 0.0) && (p->l1 <= DBL_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_l1;
    } else if (!((p->a1 >= -DBL_MAX) && (p->a1 <= DBL_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_a1;
    } else if (!((p->m1 >= 0.0) && (p->m1 <= DBL_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_m1;
    } else if (!((p->I1 >= 0.0) && (p->I1 <= DBL_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_I1;
    } else if (!((p->a2 >= -DBL_MAX) && (p->a2 <= DBL_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_a2;
    } else if (!((p->m2 >= 0.0) && (p->m2 <= DBL_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_m2;
    } else if (!((p->I2 >= 0.0) && (p->I2 <= DBL_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_I2;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void double_pendulum_f64_matrices(const double_pendulum_f64_t *p, double_pendulum_f64_matrices_t *matrices)
{
    const double t4 = p->a2 * p->m2;
    const double Jxx_theta2 = p->I2 + (p->a2 * t4);
    const double t9 = t4 + (p->m2 * p->l1);
    const double t14 = p->a1 * p->m1;
    const double Jxx_theta1 = p->I1 + Jxx_theta2 + (p->l1 * (t4 + t9)) + (p->a1 * t14);
    const double M_theta1_theta2 = Jxx_theta2 + (t4 * p->l1);
    const double K0_11 = -(t9 + t14);
    const double K0_12 = -t4;
    matrices->m[0][0] = Jxx_theta1;
    matrices->m[0][1] = M_theta1_theta2;
    matrices->m[1][0] = M_theta1_theta2;
    matrices->m[1][1] = Jxx_theta2;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_12;
}

carvallo_system_error_t double_pendulum_f64_system(const double_pendulum_f64_matrices_t *matrices,
    double gravity, double_pendulum_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < DOUBLE_PENDULUM_N; row++) {
        for (size_t column = 0U; column < DOUBLE_PENDULUM_N; column++) {
            const double damping = 0.0;
            const double stiffness = matrices->k0[row][column] * gravity;
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
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

carvallo_system_error_t double_pendulum_f64_state_space(const double_pendulum_f64_system_t *system,
    double_pendulum_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[DOUBLE_PENDULUM_N * DOUBLE_PENDULUM_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * DOUBLE_PENDULUM_N * DOUBLE_PENDULUM_N];
    for (size_t row = 0U; row < DOUBLE_PENDULUM_N; row++) {
        double *const solved = &x[3U * DOUBLE_PENDULUM_N * row];
        for (size_t column = 0U; column < DOUBLE_PENDULUM_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * DOUBLE_PENDULUM_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[DOUBLE_PENDULUM_N + column] = -system->c[row][column];
            solved[(2U * DOUBLE_PENDULUM_N) + column] = 0.0;
        }
        solved[(2U * DOUBLE_PENDULUM_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[DOUBLE_PENDULUM_N * DOUBLE_PENDULUM_N];
        error = carvallo_solve_f64(DOUBLE_PENDULUM_N, m, terms, 3U * DOUBLE_PENDULUM_N, x);
    }
    for (size_t row = 0U; row < (2U * DOUBLE_PENDULUM_N); row++) {
        for (size_t column = 0U; column < (2U * DOUBLE_PENDULUM_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < DOUBLE_PENDULUM_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < DOUBLE_PENDULUM_N; row++) {
            const size_t target = DOUBLE_PENDULUM_N + row;
            for (size_t column = 0U; column < (2U * DOUBLE_PENDULUM_N); column++) {
                space->a[target][column] = x[(3U * DOUBLE_PENDULUM_N * row) + column];
            }
            for (size_t column = 0U; column < DOUBLE_PENDULUM_N; column++) {
                space->b[target][column] = x[(3U * DOUBLE_PENDULUM_N * row) + (2U *
                    DOUBLE_PENDULUM_N) + column];
            }
            space->a[row][DOUBLE_PENDULUM_N + row] = 1.0;
        }
    }
    return error;
}

double double_pendulum_f64_rate_at(const double_pendulum_f64_rate_t *rate, double v,
    const double q[DOUBLE_PENDULUM_N], const double q_dot[DOUBLE_PENDULUM_N], double psi)
{
    double by_coordinates = 0.0;
    double by_rates = 0.0;
    for (size_t i = 0U; i < DOUBLE_PENDULUM_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void double_pendulum_f64_kinematics(const double_pendulum_f64_t *p, double_pendulum_f64_kinematics_t *kinematics)
{
    (void)p;
    kinematics->forces[0][0] = 1.0;
    kinematics->forces[0][1] = 0.0;
    kinematics->forces[1][0] = 0.0;
    kinematics->forces[1][1] = 1.0;
}

void double_pendulum_f64_derivatives(const double_pendulum_f64_t *p,
    double_pendulum_f64_matrices_t *matrices, double_pendulum_f64_derivatives_t *derivatives)
{
    const double M_12_l1 = p->a2 * p->m2;
    const double Jxx_theta2 = p->I2 + (p->a2 * M_12_l1);
    const double t8 = p->a2 + p->l1;
    const double t9 = p->m2 * t8;
    const double M_12_a2 = M_12_l1 + t9;
    const double t14 = p->a1 * p->m1;
    const double Jxx_theta1 = p->I1 + Jxx_theta2 + (p->l1 * M_12_a2) + (p->a1 * t14);
    const double M_theta1_theta2 = Jxx_theta2 + (M_12_l1 * p->l1);
    const double M_11_l1 = t9 + t9;
    const double M_11_a1 = t14 + t14;
    const double M_11_m1 = p->a1 * p->a1;
    const double M_22_a2 = M_12_l1 + M_12_l1;
    const double M_11_m2 = t8 * t8;
    const double M_12_m2 = p->a2 * t8;
    const double M_22_m2 = p->a2 * p->a2;
    const double K0_11 = -(t9 + t14);
    const double K0_12 = -M_12_l1;
    matrices->m[0][0] = Jxx_theta1;
    matrices->m[0][1] = M_theta1_theta2;
    matrices->m[1][0] = M_theta1_theta2;
    matrices->m[1][1] = Jxx_theta2;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_12;
    derivatives->values[0] = M_11_l1;
    derivatives->values[1] = M_12_l1;
    derivatives->values[2] = p->m2;
    derivatives->values[3] = M_11_a1;
    derivatives->values[4] = p->m1;
    derivatives->values[5] = M_11_m1;
    derivatives->values[6] = p->a1;
    derivatives->values[7] = 1.0;
    derivatives->values[8] = M_12_a2;
    derivatives->values[9] = M_22_a2;
    derivatives->values[10] = M_11_m2;
    derivatives->values[11] = M_12_m2;
    derivatives->values[12] = M_22_m2;
    derivatives->values[13] = t8;
    derivatives->values[14] = p->a2;
}

void double_pendulum_f64_with_respect_to(const double_pendulum_f64_derivatives_t *derivatives,
    size_t parameter, double_pendulum_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < DOUBLE_PENDULUM_N; row++) {
        for (size_t column = 0U; column < DOUBLE_PENDULUM_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < DOUBLE_PENDULUM_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &double_pendulum_partials[position];
        if (partial->parameter == parameter) {
            const double value = derivatives->values[partial->value];
            const double signed_value = partial->is_negative ? (-value) : value;
            switch (partial->matrix) {
            case CARVALLO_MATRIX_M:
                matrices->m[partial->row][partial->column] = signed_value;
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

const double_pendulum_f32_t double_pendulum_f32_sets[DOUBLE_PENDULUM_SETS] = {
    { /* rods */
        .l1 = 1.0F,
        .a1 = 0.5F,
        .m1 = 1.0F,
        .I1 = 0.083333336F,
        .a2 = 0.5F,
        .m2 = 1.0F,
        .I2 = 0.083333336F,
        .g = 9.81F
    }
};

double_pendulum_validity_t double_pendulum_f32_validate(const double_pendulum_f32_t *p)
{
    double_pendulum_validity_t validity = DOUBLE_PENDULUM_VALID;
    if (!((p->l1 > 0.0F) && (p->l1 <= FLT_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_l1;
    } else if (!((p->a1 >= -FLT_MAX) && (p->a1 <= FLT_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_a1;
    } else if (!((p->m1 >= 0.0F) && (p->m1 <= FLT_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_m1;
    } else if (!((p->I1 >= 0.0F) && (p->I1 <= FLT_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_I1;
    } else if (!((p->a2 >= -FLT_MAX) && (p->a2 <= FLT_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_a2;
    } else if (!((p->m2 >= 0.0F) && (p->m2 <= FLT_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_m2;
    } else if (!((p->I2 >= 0.0F) && (p->I2 <= FLT_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_I2;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = DOUBLE_PENDULUM_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void double_pendulum_f32_matrices(const double_pendulum_f32_t *p, double_pendulum_f32_matrices_t *matrices)
{
    const float t4 = p->a2 * p->m2;
    const float Jxx_theta2 = p->I2 + (p->a2 * t4);
    const float t9 = t4 + (p->m2 * p->l1);
    const float t14 = p->a1 * p->m1;
    const float Jxx_theta1 = p->I1 + Jxx_theta2 + (p->l1 * (t4 + t9)) + (p->a1 * t14);
    const float M_theta1_theta2 = Jxx_theta2 + (t4 * p->l1);
    const float K0_11 = -(t9 + t14);
    const float K0_12 = -t4;
    matrices->m[0][0] = Jxx_theta1;
    matrices->m[0][1] = M_theta1_theta2;
    matrices->m[1][0] = M_theta1_theta2;
    matrices->m[1][1] = Jxx_theta2;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_12;
}

carvallo_system_error_t double_pendulum_f32_system(const double_pendulum_f32_matrices_t *matrices,
    float gravity, double_pendulum_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < DOUBLE_PENDULUM_N; row++) {
        for (size_t column = 0U; column < DOUBLE_PENDULUM_N; column++) {
            const float damping = 0.0F;
            const float stiffness = matrices->k0[row][column] * gravity;
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
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

carvallo_system_error_t double_pendulum_f32_state_space(const double_pendulum_f32_system_t *system,
    double_pendulum_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[DOUBLE_PENDULUM_N * DOUBLE_PENDULUM_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * DOUBLE_PENDULUM_N * DOUBLE_PENDULUM_N];
    for (size_t row = 0U; row < DOUBLE_PENDULUM_N; row++) {
        float *const solved = &x[3U * DOUBLE_PENDULUM_N * row];
        for (size_t column = 0U; column < DOUBLE_PENDULUM_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * DOUBLE_PENDULUM_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[DOUBLE_PENDULUM_N + column] = -system->c[row][column];
            solved[(2U * DOUBLE_PENDULUM_N) + column] = 0.0F;
        }
        solved[(2U * DOUBLE_PENDULUM_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[DOUBLE_PENDULUM_N * DOUBLE_PENDULUM_N];
        error = carvallo_solve_f32(DOUBLE_PENDULUM_N, m, terms, 3U * DOUBLE_PENDULUM_N, x);
    }
    for (size_t row = 0U; row < (2U * DOUBLE_PENDULUM_N); row++) {
        for (size_t column = 0U; column < (2U * DOUBLE_PENDULUM_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < DOUBLE_PENDULUM_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < DOUBLE_PENDULUM_N; row++) {
            const size_t target = DOUBLE_PENDULUM_N + row;
            for (size_t column = 0U; column < (2U * DOUBLE_PENDULUM_N); column++) {
                space->a[target][column] = x[(3U * DOUBLE_PENDULUM_N * row) + column];
            }
            for (size_t column = 0U; column < DOUBLE_PENDULUM_N; column++) {
                space->b[target][column] = x[(3U * DOUBLE_PENDULUM_N * row) + (2U *
                    DOUBLE_PENDULUM_N) + column];
            }
            space->a[row][DOUBLE_PENDULUM_N + row] = 1.0F;
        }
    }
    return error;
}

float double_pendulum_f32_rate_at(const double_pendulum_f32_rate_t *rate, float v,
    const float q[DOUBLE_PENDULUM_N], const float q_dot[DOUBLE_PENDULUM_N], float psi)
{
    float by_coordinates = 0.0F;
    float by_rates = 0.0F;
    for (size_t i = 0U; i < DOUBLE_PENDULUM_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void double_pendulum_f32_kinematics(const double_pendulum_f32_t *p, double_pendulum_f32_kinematics_t *kinematics)
{
    (void)p;
    kinematics->forces[0][0] = 1.0F;
    kinematics->forces[0][1] = 0.0F;
    kinematics->forces[1][0] = 0.0F;
    kinematics->forces[1][1] = 1.0F;
}

void double_pendulum_f32_derivatives(const double_pendulum_f32_t *p,
    double_pendulum_f32_matrices_t *matrices, double_pendulum_f32_derivatives_t *derivatives)
{
    const float M_12_l1 = p->a2 * p->m2;
    const float Jxx_theta2 = p->I2 + (p->a2 * M_12_l1);
    const float t8 = p->a2 + p->l1;
    const float t9 = p->m2 * t8;
    const float M_12_a2 = M_12_l1 + t9;
    const float t14 = p->a1 * p->m1;
    const float Jxx_theta1 = p->I1 + Jxx_theta2 + (p->l1 * M_12_a2) + (p->a1 * t14);
    const float M_theta1_theta2 = Jxx_theta2 + (M_12_l1 * p->l1);
    const float M_11_l1 = t9 + t9;
    const float M_11_a1 = t14 + t14;
    const float M_11_m1 = p->a1 * p->a1;
    const float M_22_a2 = M_12_l1 + M_12_l1;
    const float M_11_m2 = t8 * t8;
    const float M_12_m2 = p->a2 * t8;
    const float M_22_m2 = p->a2 * p->a2;
    const float K0_11 = -(t9 + t14);
    const float K0_12 = -M_12_l1;
    matrices->m[0][0] = Jxx_theta1;
    matrices->m[0][1] = M_theta1_theta2;
    matrices->m[1][0] = M_theta1_theta2;
    matrices->m[1][1] = Jxx_theta2;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_12;
    derivatives->values[0] = M_11_l1;
    derivatives->values[1] = M_12_l1;
    derivatives->values[2] = p->m2;
    derivatives->values[3] = M_11_a1;
    derivatives->values[4] = p->m1;
    derivatives->values[5] = M_11_m1;
    derivatives->values[6] = p->a1;
    derivatives->values[7] = 1.0F;
    derivatives->values[8] = M_12_a2;
    derivatives->values[9] = M_22_a2;
    derivatives->values[10] = M_11_m2;
    derivatives->values[11] = M_12_m2;
    derivatives->values[12] = M_22_m2;
    derivatives->values[13] = t8;
    derivatives->values[14] = p->a2;
}

void double_pendulum_f32_with_respect_to(const double_pendulum_f32_derivatives_t *derivatives,
    size_t parameter, double_pendulum_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < DOUBLE_PENDULUM_N; row++) {
        for (size_t column = 0U; column < DOUBLE_PENDULUM_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < DOUBLE_PENDULUM_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &double_pendulum_partials[position];
        if (partial->parameter == parameter) {
            const float value = derivatives->values[partial->value];
            const float signed_value = partial->is_negative ? (-value) : value;
            switch (partial->matrix) {
            case CARVALLO_MATRIX_M:
                matrices->m[partial->row][partial->column] = signed_value;
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
