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

#include "carvallo_trig.h"

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
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 7U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 6U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 6U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 0U, 3U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 1U, 8U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 1U, 1U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 2U, 9U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 2U, 0U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 3U, 4U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 7U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 4U, 10U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 4U, 10U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 4U, 11U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 4U, 3U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 4U, 3U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 4U, 3U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 4U, 3U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 12U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 5U, 13U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 5U, 13U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 5U, 14U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 5U, 5U, true},
    {CARVALLO_MATRIX_K0, 0U, 1U, 5U, 2U, true},
    {CARVALLO_MATRIX_K0, 1U, 0U, 5U, 2U, true},
    {CARVALLO_MATRIX_K0, 1U, 1U, 5U, 2U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 6U, 4U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 6U, 4U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 6U, 4U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 4U, false}
};

const char *double_pendulum_position_name(double_pendulum_position_t which)
{
    static const char *const TEXTS[] = {
        "theta1",
        "theta2",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such position";
}

const char *double_pendulum_speed_name(double_pendulum_speed_t which)
{
    static const char *const TEXTS[] = {
        "theta1",
        "theta2",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such speed";
}

const char *double_pendulum_force_name(double_pendulum_force_t which)
{
    static const char *const TEXTS[] = {
        "T1",
        "T2",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such force";
}

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
    const double t5 = p->a1 * p->m1;
    const double t9 = p->a2 + p->l1;
    const double t11 = p->m2 * t9;
    const double Jxx_theta1 = p->I1 + p->I2 + ((p->a1 * t5) + (t9 * t11));
    const double t15 = p->a2 * p->m2;
    const double Jxx_theta2 = p->I2 + (p->a2 * t15);
    const double M_theta1_theta2 = Jxx_theta2 + (t15 * p->l1);
    const double K0_11 = -(t5 + t11);
    const double K0_12 = -t15;
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
    const double t8 = p->a1 * p->m1;
    const double t9 = p->l1 + p->a2;
    const double t10 = t9 * p->m2;
    const double Jxx_theta1 = (p->a1 * t8) + p->I1 + p->I2 + (t9 * t10);
    const double M_12_l1 = p->a2 * p->m2;
    const double Jxx_theta2 = p->I2 + (p->a2 * M_12_l1);
    const double M_11_l1 = t10 + t10;
    const double M_11_a1 = t8 + t8;
    const double M_11_m1 = p->a1 * p->a1;
    const double M_12_a2 = t10 + M_12_l1;
    const double Jxx_theta2_a2 = M_12_l1 + M_12_l1;
    const double M_theta1_theta2 = Jxx_theta2 + (p->l1 * M_12_l1);
    const double M_11_m2 = t9 * t9;
    const double M_12_m2 = p->a2 * t9;
    const double Jxx_theta2_m2 = p->a2 * p->a2;
    const double K0_11 = -(t8 + t10);
    const double K0_12 = -M_12_l1;
    matrices->m[0][0] = Jxx_theta1;
    matrices->m[0][1] = M_theta1_theta2;
    matrices->m[1][0] = M_theta1_theta2;
    matrices->m[1][1] = Jxx_theta2;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_12;
    derivatives->values[0] = p->a1;
    derivatives->values[1] = p->m1;
    derivatives->values[2] = p->a2;
    derivatives->values[3] = p->m2;
    derivatives->values[4] = 1.0;
    derivatives->values[5] = t9;
    derivatives->values[6] = M_12_l1;
    derivatives->values[7] = M_11_l1;
    derivatives->values[8] = M_11_a1;
    derivatives->values[9] = M_11_m1;
    derivatives->values[10] = M_12_a2;
    derivatives->values[11] = Jxx_theta2_a2;
    derivatives->values[12] = M_11_m2;
    derivatives->values[13] = M_12_m2;
    derivatives->values[14] = Jxx_theta2_m2;
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

void double_pendulum_f64_motion(const double_pendulum_f64_t *p,
    double_pendulum_f64_motion_t *motion)
{
    const double t5 = p->m1 * p->a1;
    const double t8 = p->I1 + (p->a1 * t5);
    const double t10 = p->l1 - p->l1 - p->a2;
    const double t11 = p->m2 * t10;
    const double t14 = p->I2 + (t10 * t11);
    const double t16 = p->l1 * p->m2;
    const double t17 = p->l1 * t16;
    motion->constants[0] = p->l1;
    motion->constants[1] = p->m1;
    motion->constants[2] = p->a1;
    motion->constants[3] = p->m2;
    motion->constants[4] = p->a2;
    motion->constants[5] = t5;
    motion->constants[6] = t8;
    motion->constants[7] = t11;
    motion->constants[8] = t14;
    motion->constants[9] = p->g;
    motion->constants[10] = t16;
    motion->constants[11] = t17;
}

static void double_pendulum_f64_compute_rates(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    double rates[DOUBLE_PENDULUM_POSITIONS])
{
    (void)motion;
    (void)positions;
    rates[0] = speeds[0];
    rates[1] = speeds[1];
}

carvallo_motion_error_t double_pendulum_f64_motion_rates(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    double rates[DOUBLE_PENDULUM_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, DOUBLE_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, DOUBLE_PENDULUM_SPEEDS)) {
        double_pendulum_f64_compute_rates(motion, positions, speeds, rates);
        error = (carvallo_are_finite_f64(rates, DOUBLE_PENDULUM_POSITIONS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void double_pendulum_f64_compute_derivatives(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    const double forces[DOUBLE_PENDULUM_FORCES], double rates[DOUBLE_PENDULUM_POSITIONS],
    double speed_rates[DOUBLE_PENDULUM_SPEEDS])
{
    double sin_theta1 = 0.0;
    double cos_theta1 = 0.0;
    carvallo_sin_cos_f64(positions[0], &sin_theta1, &cos_theta1);
    const double t7 = sin_theta1 * motion->constants[9];
    double sin_theta2 = 0.0;
    double cos_theta2 = 0.0;
    carvallo_sin_cos_f64(positions[1], &sin_theta2, &cos_theta2);
    const double t19 = (speeds[0] * speeds[0] * motion->constants[0]) - (motion->constants[9] *
        cos_theta1);
    const double t21 = (sin_theta2 * t19) - (t7 * cos_theta2);
    const double t22 = motion->constants[7] * t21;
    const double t30 = speeds[0] + speeds[1];
    const double t35 = (cos_theta2 * t21 * motion->constants[3]) - (sin_theta2 *
        ((motion->constants[3] * ((cos_theta2 * t19) + (t7 * sin_theta2))) - (motion->constants[7] *
        t30 * t30)));
    const double t39 = forces[0] + (motion->constants[5] * t7) + t22 - (motion->constants[0] * t35);
    const double t42 = motion->constants[7] * cos_theta2 * motion->constants[0];
    const double t45 = motion->constants[8] - t42;
    const double t48 = motion->constants[6] + motion->constants[11] + t45 - t42;
    const double t49 = 1.0 / t48;
    const double t51 = t45 * t49;
    const double t59 = (t22 + forces[1] - (t39 * t51)) / (motion->constants[8] - (t48 * t51 * t51));
    const double t61 = (t39 * t49) - (t51 * t59);
    rates[0] = speeds[0];
    rates[1] = speeds[1];
    speed_rates[0] = t61;
    speed_rates[1] = t59;
}

carvallo_motion_error_t double_pendulum_f64_motion_derivatives(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    const double forces[DOUBLE_PENDULUM_FORCES], double rates[DOUBLE_PENDULUM_POSITIONS],
    double speed_rates[DOUBLE_PENDULUM_SPEEDS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, DOUBLE_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, DOUBLE_PENDULUM_SPEEDS) && carvallo_are_finite_f64(forces,
        DOUBLE_PENDULUM_FORCES)) {
        double_pendulum_f64_compute_derivatives(motion, positions, speeds, forces, rates,
            speed_rates);
        error = (carvallo_are_finite_f64(rates, DOUBLE_PENDULUM_POSITIONS) &&
            carvallo_are_finite_f64(speed_rates, DOUBLE_PENDULUM_SPEEDS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void double_pendulum_f64_compute_accelerations(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    const double forces[DOUBLE_PENDULUM_FORCES], double accelerations[DOUBLE_PENDULUM_POSITIONS])
{
    double sin_theta1 = 0.0;
    double cos_theta1 = 0.0;
    carvallo_sin_cos_f64(positions[0], &sin_theta1, &cos_theta1);
    const double t5 = sin_theta1 * motion->constants[9];
    double sin_theta2 = 0.0;
    double cos_theta2 = 0.0;
    carvallo_sin_cos_f64(positions[1], &sin_theta2, &cos_theta2);
    const double t18 = (motion->constants[0] * speeds[0] * speeds[0]) - (motion->constants[9] *
        cos_theta1);
    const double t20 = (sin_theta2 * t18) - (t5 * cos_theta2);
    const double t21 = motion->constants[7] * t20;
    const double t30 = speeds[0] + speeds[1];
    const double t35 = (cos_theta2 * t20 * motion->constants[3]) - (sin_theta2 *
        ((motion->constants[3] * ((cos_theta2 * t18) + (t5 * sin_theta2))) - (motion->constants[7] *
        t30 * t30)));
    const double t39 = forces[0] + (motion->constants[5] * t5) + t21 - (motion->constants[0] * t35);
    const double t42 = motion->constants[7] * cos_theta2 * motion->constants[0];
    const double t45 = motion->constants[8] - t42;
    const double t48 = motion->constants[6] + motion->constants[11] + t45 - t42;
    const double t49 = 1.0 / t48;
    const double t51 = t45 * t49;
    const double t59 = (t21 + forces[1] - (t39 * t51)) / (motion->constants[8] - (t48 * t51 * t51));
    const double t61 = (t39 * t49) - (t51 * t59);
    accelerations[0] = t61;
    accelerations[1] = t59;
}

carvallo_motion_error_t double_pendulum_f64_motion_accelerations(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    const double forces[DOUBLE_PENDULUM_FORCES], double accelerations[DOUBLE_PENDULUM_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, DOUBLE_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, DOUBLE_PENDULUM_SPEEDS) && carvallo_are_finite_f64(forces,
        DOUBLE_PENDULUM_FORCES)) {
        double_pendulum_f64_compute_accelerations(motion, positions, speeds, forces, accelerations);
        error = (carvallo_are_finite_f64(accelerations, DOUBLE_PENDULUM_POSITIONS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void double_pendulum_f64_compute_energy(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    double energy[2])
{
    double sin_theta2 = 0.0;
    double cos_theta2 = 0.0;
    carvallo_sin_cos_f64(positions[1], &sin_theta2, &cos_theta2);
    const double t6 = cos_theta2 * motion->constants[7];
    const double t7 = motion->constants[0] * t6;
    const double t10 = motion->constants[8] - t7;
    const double t18 = speeds[0] * ((speeds[0] * (motion->constants[6] + motion->constants[11] +
        t10 - t7)) + (t10 * speeds[1]));
    const double t25 = (t18 + (speeds[1] * ((speeds[0] * t10) + (motion->constants[8] *
        speeds[1])))) * 0.5;
    double sin_theta1 = 0.0;
    double cos_theta1 = 0.0;
    carvallo_sin_cos_f64(positions[0], &sin_theta1, &cos_theta1);
    const double t40 = -(motion->constants[9] * ((cos_theta1 * (t6 - motion->constants[5] -
        motion->constants[10])) - (motion->constants[7] * sin_theta1 * sin_theta2)));
    energy[0] = t25;
    energy[1] = t40;
}

carvallo_motion_error_t double_pendulum_f64_motion_energy(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    double energy[2])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, DOUBLE_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, DOUBLE_PENDULUM_SPEEDS)) {
        double_pendulum_f64_compute_energy(motion, positions, speeds, energy);
        error = (carvallo_are_finite_f64(energy, 2U)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void double_pendulum_f64_compute_linearization(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    const double forces[DOUBLE_PENDULUM_FORCES], double_pendulum_f64_linearization_t *linearization)
{
    double sin_theta2 = 0.0;
    double cos_theta2 = 0.0;
    carvallo_sin_cos_f64(positions[1], &sin_theta2, &cos_theta2);
    const double t8 = motion->constants[0] * cos_theta2 * motion->constants[7];
    const double t11 = motion->constants[8] - t8;
    const double t14 = motion->constants[6] + motion->constants[11] + t11 - t8;
    const double t15 = 1.0 / t14;
    double sin_theta1 = 0.0;
    double cos_theta1 = 0.0;
    carvallo_sin_cos_f64(positions[0], &sin_theta1, &cos_theta1);
    const double t20 = cos_theta1 * motion->constants[9];
    const double t23 = motion->constants[0] * sin_theta2;
    const double t28 = motion->constants[9] * sin_theta1;
    const double t29 = cos_theta2 * motion->constants[3];
    const double t34 = (motion->constants[0] * t29) - motion->constants[7];
    const double t35 = sin_theta2 * t28;
    const double t37 = t35 - (cos_theta2 * t20);
    const double t40 = (motion->constants[5] * t20) + (t23 * ((t20 * sin_theta2 *
        motion->constants[3]) + (t28 * t29))) - (t34 * t37);
    const double t42 = t11 * t15;
    const double t46 = 1.0 / (motion->constants[8] - (t14 * t42 * t42));
    const double t50 = t46 * ((motion->constants[7] * t37) - (t40 * t42));
    const double t52 = (t15 * t40) - (t42 * t50);
    const double t54 = motion->constants[0] * speeds[0];
    const double t56 = (speeds[0] * t54) - t20;
    const double t57 = sin_theta2 * t56;
    const double t61 = t57 - (cos_theta2 * t28);
    const double t62 = motion->constants[7] * t61;
    const double t64 = cos_theta2 * t56;
    const double t68 = speeds[0] + speeds[1];
    const double t69 = motion->constants[7] * t68;
    const double t70 = t68 * t69;
    const double t74 = motion->constants[0] * ((t29 * t61) - (sin_theta2 * ((motion->constants[3] *
        (t35 + t64)) - t70)));
    const double t77 = forces[0] + (motion->constants[5] * t28) + t62 - t74;
    const double t83 = t46 * (t62 + forces[1] - (t42 * t77));
    const double t85 = (t15 * t77) - (t42 * t83);
    const double t87 = (motion->constants[0] * t85) - t28;
    const double t90 = motion->constants[3] * (t57 + (cos_theta2 * t87));
    const double t96 = t64 - (sin_theta2 * t87);
    const double t101 = motion->constants[0] * ((sin_theta2 * (t90 - (motion->constants[7] * (t83 +
        t85)))) + (cos_theta2 * ((motion->constants[3] * t96) - t70)));
    const double t105 = (t23 * t90) + (t34 * t96) - t101;
    const double t110 = t46 * ((motion->constants[7] * t96) + (t42 * t105));
    const double t113 = t69 + t69;
    const double t114 = t54 + t54;
    const double t118 = sin_theta2 * t114;
    const double t120 = (t23 * ((t29 * t114) - t113)) - (t34 * t118);
    const double t125 = t46 * ((motion->constants[7] * t118) - (t42 * t120));
    const double t127 = (t15 * t120) - (t42 * t125);
    const double t128 = t23 * t113;
    const double t130 = t42 * t46;
    const double t131 = t128 * t130;
    const double t135 = t15 + (t42 * t130);
    const double t136 = -((t15 * t105) + (t42 * t110));
    const double t137 = -((t15 * t128) + (t42 * t131));
    const double t138 = -t130;
    linearization->a[0][0] = 0.0;
    linearization->a[0][1] = 0.0;
    linearization->a[0][2] = 1.0;
    linearization->a[0][3] = 0.0;
    linearization->b[0][0] = 0.0;
    linearization->b[0][1] = 0.0;
    linearization->a[1][0] = 0.0;
    linearization->a[1][1] = 0.0;
    linearization->a[1][2] = 0.0;
    linearization->a[1][3] = 1.0;
    linearization->b[1][0] = 0.0;
    linearization->b[1][1] = 0.0;
    linearization->a[2][0] = t52;
    linearization->a[2][1] = t136;
    linearization->a[2][2] = t127;
    linearization->a[2][3] = t137;
    linearization->b[2][0] = t135;
    linearization->b[2][1] = t138;
    linearization->a[3][0] = t50;
    linearization->a[3][1] = t110;
    linearization->a[3][2] = t125;
    linearization->a[3][3] = t131;
    linearization->b[3][0] = t138;
    linearization->b[3][1] = t46;
}

carvallo_motion_error_t double_pendulum_f64_motion_linearize(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    const double forces[DOUBLE_PENDULUM_FORCES], double_pendulum_f64_linearization_t *linearization)
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, DOUBLE_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, DOUBLE_PENDULUM_SPEEDS) && carvallo_are_finite_f64(forces,
        DOUBLE_PENDULUM_FORCES)) {
        bool are_finite = true;
        double_pendulum_f64_compute_linearization(motion, positions, speeds, forces, linearization);
        for (size_t row = 0U; row < DOUBLE_PENDULUM_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f64(linearization->a[row],
                DOUBLE_PENDULUM_STATES) && carvallo_are_finite_f64(linearization->b[row],
                DOUBLE_PENDULUM_FORCES);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void double_pendulum_f64_compute_by_parameters(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    const double forces[DOUBLE_PENDULUM_FORCES],
    double by_parameters[DOUBLE_PENDULUM_STATES][DOUBLE_PENDULUM_PARAMETERS])
{
    double sin_theta2 = 0.0;
    double cos_theta2 = 0.0;
    carvallo_sin_cos_f64(positions[1], &sin_theta2, &cos_theta2);
    const double t7 = motion->constants[0] * cos_theta2 * motion->constants[7];
    const double t10 = motion->constants[8] - t7;
    const double t13 = motion->constants[6] + motion->constants[11] + t10 - t7;
    const double t14 = 1.0 / t13;
    double sin_theta1 = 0.0;
    double cos_theta1 = 0.0;
    carvallo_sin_cos_f64(positions[0], &sin_theta1, &cos_theta1);
    const double t22 = speeds[0] * speeds[0];
    const double t24 = (motion->constants[0] * t22) - (cos_theta1 * motion->constants[9]);
    const double t25 = sin_theta2 * t24;
    const double t27 = motion->constants[9] * sin_theta1;
    const double t32 = t25 - (cos_theta2 * t27);
    const double t33 = motion->constants[7] * t32;
    const double t34 = cos_theta2 * motion->constants[3];
    const double t36 = cos_theta2 * t24;
    const double t41 = speeds[0] + speeds[1];
    const double t42 = t41 * t41;
    const double t43 = motion->constants[7] * t42;
    const double t46 = (t32 * t34) - (sin_theta2 * ((motion->constants[3] * (t36 + (sin_theta2 *
        t27))) - t43));
    const double t50 = forces[0] + (t27 * motion->constants[5]) + t33 - (motion->constants[0] *
        t46);
    const double t52 = t10 * t14;
    const double t60 = 1.0 / (motion->constants[8] - (t13 * t52 * t52));
    const double t61 = (t33 + forces[1] - (t50 * t52)) * t60;
    const double t63 = (t14 * t50) - (t52 * t61);
    const double t65 = (motion->constants[0] * t63) - t27;
    const double t67 = t25 + (cos_theta2 * t65);
    const double t69 = t61 + t63;
    const double t70 = motion->constants[7] * t69;
    const double t74 = t36 - (sin_theta2 * t65);
    const double t80 = (sin_theta2 * t22) + (cos_theta2 * t63);
    const double t81 = motion->constants[7] * t80;
    const double t82 = sin_theta2 * t34;
    const double t85 = motion->constants[3] * sin_theta2 * sin_theta2;
    const double t93 = (sin_theta2 * ((motion->constants[3] * t74) - t43)) + t81 - (cos_theta2 *
        ((motion->constants[3] * t67) - t70)) - (motion->constants[0] * ((t63 * t85) + (t34 * t80) -
        (t22 * t82)));
    const double t97 = t60 * (t81 - (t52 * t93));
    const double t99 = (t14 * t93) - (t52 * t97);
    const double t104 = (t63 * motion->constants[2]) - t27;
    const double t106 = (motion->constants[5] * t63) + (motion->constants[1] * t104);
    const double t108 = t52 * t60;
    const double t109 = t106 * t108;
    const double t112 = motion->constants[2] * t104;
    const double t114 = t108 * t112;
    const double t118 = t63 * t108;
    const double t123 = motion->constants[0] - motion->constants[0] - motion->constants[4];
    const double t125 = (t69 * t123) - t67;
    const double t127 = t70 + (motion->constants[3] * t125);
    const double t130 = (sin_theta2 * t42) - (cos_theta2 * t69);
    const double t133 = t127 + (motion->constants[0] * motion->constants[3] * t130);
    const double t137 = t60 * (t127 - (t52 * t133));
    const double t139 = (t14 * t133) - (t52 * t137);
    const double t140 = t123 * t125;
    const double t147 = t140 + (motion->constants[0] * ((cos_theta2 * t67) + (t123 * t130) -
        (sin_theta2 * t74)));
    const double t151 = t60 * ((t52 * t147) - t140);
    const double t157 = t60 * ((t52 * t69) - t69);
    const double t163 = (sin_theta2 * cos_theta1) + (cos_theta2 * sin_theta1);
    const double t164 = motion->constants[7] * t163;
    const double t172 = (sin_theta1 * motion->constants[5]) - t164 - (motion->constants[0] *
        ((cos_theta1 * t82) - (sin_theta1 * t85) - (t34 * t163)));
    const double t176 = t60 * (t164 + (t52 * t172));
    const double t178 = (t14 * t172) + (t52 * t176);
    const double t179 = -((t14 * t106) + (t52 * t109));
    const double t180 = -((t14 * t112) + (t52 * t114));
    const double t181 = -((t14 * t63) + (t52 * t118));
    const double t182 = -((t14 * t147) + (t52 * t151));
    const double t183 = -((t14 * t69) + (t52 * t157));
    const double t184 = -t176;
    by_parameters[0][0] = 0.0;
    by_parameters[0][1] = 0.0;
    by_parameters[0][2] = 0.0;
    by_parameters[0][3] = 0.0;
    by_parameters[0][4] = 0.0;
    by_parameters[0][5] = 0.0;
    by_parameters[0][6] = 0.0;
    by_parameters[0][7] = 0.0;
    by_parameters[1][0] = 0.0;
    by_parameters[1][1] = 0.0;
    by_parameters[1][2] = 0.0;
    by_parameters[1][3] = 0.0;
    by_parameters[1][4] = 0.0;
    by_parameters[1][5] = 0.0;
    by_parameters[1][6] = 0.0;
    by_parameters[1][7] = 0.0;
    by_parameters[2][0] = t99;
    by_parameters[2][1] = t179;
    by_parameters[2][2] = t180;
    by_parameters[2][3] = t181;
    by_parameters[2][4] = t139;
    by_parameters[2][5] = t182;
    by_parameters[2][6] = t183;
    by_parameters[2][7] = t178;
    by_parameters[3][0] = t97;
    by_parameters[3][1] = t109;
    by_parameters[3][2] = t114;
    by_parameters[3][3] = t118;
    by_parameters[3][4] = t137;
    by_parameters[3][5] = t151;
    by_parameters[3][6] = t157;
    by_parameters[3][7] = t184;
}

carvallo_motion_error_t double_pendulum_f64_motion_by_parameters(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    const double forces[DOUBLE_PENDULUM_FORCES],
    double by_parameters[DOUBLE_PENDULUM_STATES][DOUBLE_PENDULUM_PARAMETERS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, DOUBLE_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, DOUBLE_PENDULUM_SPEEDS) && carvallo_are_finite_f64(forces,
        DOUBLE_PENDULUM_FORCES)) {
        bool are_finite = true;
        double_pendulum_f64_compute_by_parameters(motion, positions, speeds, forces, by_parameters);
        for (size_t row = 0U; row < DOUBLE_PENDULUM_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f64(by_parameters[row],
                DOUBLE_PENDULUM_PARAMETERS);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
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
    const float t5 = p->a1 * p->m1;
    const float t9 = p->a2 + p->l1;
    const float t11 = p->m2 * t9;
    const float Jxx_theta1 = p->I1 + p->I2 + ((p->a1 * t5) + (t9 * t11));
    const float t15 = p->a2 * p->m2;
    const float Jxx_theta2 = p->I2 + (p->a2 * t15);
    const float M_theta1_theta2 = Jxx_theta2 + (t15 * p->l1);
    const float K0_11 = -(t5 + t11);
    const float K0_12 = -t15;
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
    const float t8 = p->a1 * p->m1;
    const float t9 = p->l1 + p->a2;
    const float t10 = t9 * p->m2;
    const float Jxx_theta1 = (p->a1 * t8) + p->I1 + p->I2 + (t9 * t10);
    const float M_12_l1 = p->a2 * p->m2;
    const float Jxx_theta2 = p->I2 + (p->a2 * M_12_l1);
    const float M_11_l1 = t10 + t10;
    const float M_11_a1 = t8 + t8;
    const float M_11_m1 = p->a1 * p->a1;
    const float M_12_a2 = t10 + M_12_l1;
    const float Jxx_theta2_a2 = M_12_l1 + M_12_l1;
    const float M_theta1_theta2 = Jxx_theta2 + (p->l1 * M_12_l1);
    const float M_11_m2 = t9 * t9;
    const float M_12_m2 = p->a2 * t9;
    const float Jxx_theta2_m2 = p->a2 * p->a2;
    const float K0_11 = -(t8 + t10);
    const float K0_12 = -M_12_l1;
    matrices->m[0][0] = Jxx_theta1;
    matrices->m[0][1] = M_theta1_theta2;
    matrices->m[1][0] = M_theta1_theta2;
    matrices->m[1][1] = Jxx_theta2;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = K0_12;
    matrices->k0[1][0] = K0_12;
    matrices->k0[1][1] = K0_12;
    derivatives->values[0] = p->a1;
    derivatives->values[1] = p->m1;
    derivatives->values[2] = p->a2;
    derivatives->values[3] = p->m2;
    derivatives->values[4] = 1.0F;
    derivatives->values[5] = t9;
    derivatives->values[6] = M_12_l1;
    derivatives->values[7] = M_11_l1;
    derivatives->values[8] = M_11_a1;
    derivatives->values[9] = M_11_m1;
    derivatives->values[10] = M_12_a2;
    derivatives->values[11] = Jxx_theta2_a2;
    derivatives->values[12] = M_11_m2;
    derivatives->values[13] = M_12_m2;
    derivatives->values[14] = Jxx_theta2_m2;
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

void double_pendulum_f32_motion(const double_pendulum_f32_t *p,
    double_pendulum_f32_motion_t *motion)
{
    const float t5 = p->m1 * p->a1;
    const float t8 = p->I1 + (p->a1 * t5);
    const float t10 = p->l1 - p->l1 - p->a2;
    const float t11 = p->m2 * t10;
    const float t14 = p->I2 + (t10 * t11);
    const float t16 = p->l1 * p->m2;
    const float t17 = p->l1 * t16;
    motion->constants[0] = p->l1;
    motion->constants[1] = p->m1;
    motion->constants[2] = p->a1;
    motion->constants[3] = p->m2;
    motion->constants[4] = p->a2;
    motion->constants[5] = t5;
    motion->constants[6] = t8;
    motion->constants[7] = t11;
    motion->constants[8] = t14;
    motion->constants[9] = p->g;
    motion->constants[10] = t16;
    motion->constants[11] = t17;
}

static void double_pendulum_f32_compute_rates(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    float rates[DOUBLE_PENDULUM_POSITIONS])
{
    (void)motion;
    (void)positions;
    rates[0] = speeds[0];
    rates[1] = speeds[1];
}

carvallo_motion_error_t double_pendulum_f32_motion_rates(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    float rates[DOUBLE_PENDULUM_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, DOUBLE_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, DOUBLE_PENDULUM_SPEEDS)) {
        double_pendulum_f32_compute_rates(motion, positions, speeds, rates);
        error = (carvallo_are_finite_f32(rates, DOUBLE_PENDULUM_POSITIONS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void double_pendulum_f32_compute_derivatives(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    const float forces[DOUBLE_PENDULUM_FORCES], float rates[DOUBLE_PENDULUM_POSITIONS],
    float speed_rates[DOUBLE_PENDULUM_SPEEDS])
{
    float sin_theta1 = 0.0F;
    float cos_theta1 = 0.0F;
    carvallo_sin_cos_f32(positions[0], &sin_theta1, &cos_theta1);
    const float t7 = sin_theta1 * motion->constants[9];
    float sin_theta2 = 0.0F;
    float cos_theta2 = 0.0F;
    carvallo_sin_cos_f32(positions[1], &sin_theta2, &cos_theta2);
    const float t19 = (speeds[0] * speeds[0] * motion->constants[0]) - (motion->constants[9] *
        cos_theta1);
    const float t21 = (sin_theta2 * t19) - (t7 * cos_theta2);
    const float t22 = motion->constants[7] * t21;
    const float t30 = speeds[0] + speeds[1];
    const float t35 = (cos_theta2 * t21 * motion->constants[3]) - (sin_theta2 *
        ((motion->constants[3] * ((cos_theta2 * t19) + (t7 * sin_theta2))) - (motion->constants[7] *
        t30 * t30)));
    const float t39 = forces[0] + (motion->constants[5] * t7) + t22 - (motion->constants[0] * t35);
    const float t42 = motion->constants[7] * cos_theta2 * motion->constants[0];
    const float t45 = motion->constants[8] - t42;
    const float t48 = motion->constants[6] + motion->constants[11] + t45 - t42;
    const float t49 = 1.0F / t48;
    const float t51 = t45 * t49;
    const float t59 = (t22 + forces[1] - (t39 * t51)) / (motion->constants[8] - (t48 * t51 * t51));
    const float t61 = (t39 * t49) - (t51 * t59);
    rates[0] = speeds[0];
    rates[1] = speeds[1];
    speed_rates[0] = t61;
    speed_rates[1] = t59;
}

carvallo_motion_error_t double_pendulum_f32_motion_derivatives(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    const float forces[DOUBLE_PENDULUM_FORCES], float rates[DOUBLE_PENDULUM_POSITIONS],
    float speed_rates[DOUBLE_PENDULUM_SPEEDS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, DOUBLE_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, DOUBLE_PENDULUM_SPEEDS) && carvallo_are_finite_f32(forces,
        DOUBLE_PENDULUM_FORCES)) {
        double_pendulum_f32_compute_derivatives(motion, positions, speeds, forces, rates,
            speed_rates);
        error = (carvallo_are_finite_f32(rates, DOUBLE_PENDULUM_POSITIONS) &&
            carvallo_are_finite_f32(speed_rates, DOUBLE_PENDULUM_SPEEDS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void double_pendulum_f32_compute_accelerations(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    const float forces[DOUBLE_PENDULUM_FORCES], float accelerations[DOUBLE_PENDULUM_POSITIONS])
{
    float sin_theta1 = 0.0F;
    float cos_theta1 = 0.0F;
    carvallo_sin_cos_f32(positions[0], &sin_theta1, &cos_theta1);
    const float t5 = sin_theta1 * motion->constants[9];
    float sin_theta2 = 0.0F;
    float cos_theta2 = 0.0F;
    carvallo_sin_cos_f32(positions[1], &sin_theta2, &cos_theta2);
    const float t18 = (motion->constants[0] * speeds[0] * speeds[0]) - (motion->constants[9] *
        cos_theta1);
    const float t20 = (sin_theta2 * t18) - (t5 * cos_theta2);
    const float t21 = motion->constants[7] * t20;
    const float t30 = speeds[0] + speeds[1];
    const float t35 = (cos_theta2 * t20 * motion->constants[3]) - (sin_theta2 *
        ((motion->constants[3] * ((cos_theta2 * t18) + (t5 * sin_theta2))) - (motion->constants[7] *
        t30 * t30)));
    const float t39 = forces[0] + (motion->constants[5] * t5) + t21 - (motion->constants[0] * t35);
    const float t42 = motion->constants[7] * cos_theta2 * motion->constants[0];
    const float t45 = motion->constants[8] - t42;
    const float t48 = motion->constants[6] + motion->constants[11] + t45 - t42;
    const float t49 = 1.0F / t48;
    const float t51 = t45 * t49;
    const float t59 = (t21 + forces[1] - (t39 * t51)) / (motion->constants[8] - (t48 * t51 * t51));
    const float t61 = (t39 * t49) - (t51 * t59);
    accelerations[0] = t61;
    accelerations[1] = t59;
}

carvallo_motion_error_t double_pendulum_f32_motion_accelerations(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    const float forces[DOUBLE_PENDULUM_FORCES], float accelerations[DOUBLE_PENDULUM_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, DOUBLE_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, DOUBLE_PENDULUM_SPEEDS) && carvallo_are_finite_f32(forces,
        DOUBLE_PENDULUM_FORCES)) {
        double_pendulum_f32_compute_accelerations(motion, positions, speeds, forces, accelerations);
        error = (carvallo_are_finite_f32(accelerations, DOUBLE_PENDULUM_POSITIONS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void double_pendulum_f32_compute_energy(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    float energy[2])
{
    float sin_theta2 = 0.0F;
    float cos_theta2 = 0.0F;
    carvallo_sin_cos_f32(positions[1], &sin_theta2, &cos_theta2);
    const float t6 = cos_theta2 * motion->constants[7];
    const float t7 = motion->constants[0] * t6;
    const float t10 = motion->constants[8] - t7;
    const float t18 = speeds[0] * ((speeds[0] * (motion->constants[6] + motion->constants[11] +
        t10 - t7)) + (t10 * speeds[1]));
    const float t25 = (t18 + (speeds[1] * ((speeds[0] * t10) + (motion->constants[8] *
        speeds[1])))) * 0.5F;
    float sin_theta1 = 0.0F;
    float cos_theta1 = 0.0F;
    carvallo_sin_cos_f32(positions[0], &sin_theta1, &cos_theta1);
    const float t40 = -(motion->constants[9] * ((cos_theta1 * (t6 - motion->constants[5] -
        motion->constants[10])) - (motion->constants[7] * sin_theta1 * sin_theta2)));
    energy[0] = t25;
    energy[1] = t40;
}

carvallo_motion_error_t double_pendulum_f32_motion_energy(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    float energy[2])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, DOUBLE_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, DOUBLE_PENDULUM_SPEEDS)) {
        double_pendulum_f32_compute_energy(motion, positions, speeds, energy);
        error = (carvallo_are_finite_f32(energy, 2U)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void double_pendulum_f32_compute_linearization(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    const float forces[DOUBLE_PENDULUM_FORCES], double_pendulum_f32_linearization_t *linearization)
{
    float sin_theta2 = 0.0F;
    float cos_theta2 = 0.0F;
    carvallo_sin_cos_f32(positions[1], &sin_theta2, &cos_theta2);
    const float t8 = motion->constants[0] * cos_theta2 * motion->constants[7];
    const float t11 = motion->constants[8] - t8;
    const float t14 = motion->constants[6] + motion->constants[11] + t11 - t8;
    const float t15 = 1.0F / t14;
    float sin_theta1 = 0.0F;
    float cos_theta1 = 0.0F;
    carvallo_sin_cos_f32(positions[0], &sin_theta1, &cos_theta1);
    const float t20 = cos_theta1 * motion->constants[9];
    const float t23 = motion->constants[0] * sin_theta2;
    const float t28 = motion->constants[9] * sin_theta1;
    const float t29 = cos_theta2 * motion->constants[3];
    const float t34 = (motion->constants[0] * t29) - motion->constants[7];
    const float t35 = sin_theta2 * t28;
    const float t37 = t35 - (cos_theta2 * t20);
    const float t40 = (motion->constants[5] * t20) + (t23 * ((t20 * sin_theta2 *
        motion->constants[3]) + (t28 * t29))) - (t34 * t37);
    const float t42 = t11 * t15;
    const float t46 = 1.0F / (motion->constants[8] - (t14 * t42 * t42));
    const float t50 = t46 * ((motion->constants[7] * t37) - (t40 * t42));
    const float t52 = (t15 * t40) - (t42 * t50);
    const float t54 = motion->constants[0] * speeds[0];
    const float t56 = (speeds[0] * t54) - t20;
    const float t57 = sin_theta2 * t56;
    const float t61 = t57 - (cos_theta2 * t28);
    const float t62 = motion->constants[7] * t61;
    const float t64 = cos_theta2 * t56;
    const float t68 = speeds[0] + speeds[1];
    const float t69 = motion->constants[7] * t68;
    const float t70 = t68 * t69;
    const float t74 = motion->constants[0] * ((t29 * t61) - (sin_theta2 * ((motion->constants[3] *
        (t35 + t64)) - t70)));
    const float t77 = forces[0] + (motion->constants[5] * t28) + t62 - t74;
    const float t83 = t46 * (t62 + forces[1] - (t42 * t77));
    const float t85 = (t15 * t77) - (t42 * t83);
    const float t87 = (motion->constants[0] * t85) - t28;
    const float t90 = motion->constants[3] * (t57 + (cos_theta2 * t87));
    const float t96 = t64 - (sin_theta2 * t87);
    const float t101 = motion->constants[0] * ((sin_theta2 * (t90 - (motion->constants[7] * (t83 +
        t85)))) + (cos_theta2 * ((motion->constants[3] * t96) - t70)));
    const float t105 = (t23 * t90) + (t34 * t96) - t101;
    const float t110 = t46 * ((motion->constants[7] * t96) + (t42 * t105));
    const float t113 = t69 + t69;
    const float t114 = t54 + t54;
    const float t118 = sin_theta2 * t114;
    const float t120 = (t23 * ((t29 * t114) - t113)) - (t34 * t118);
    const float t125 = t46 * ((motion->constants[7] * t118) - (t42 * t120));
    const float t127 = (t15 * t120) - (t42 * t125);
    const float t128 = t23 * t113;
    const float t130 = t42 * t46;
    const float t131 = t128 * t130;
    const float t135 = t15 + (t42 * t130);
    const float t136 = -((t15 * t105) + (t42 * t110));
    const float t137 = -((t15 * t128) + (t42 * t131));
    const float t138 = -t130;
    linearization->a[0][0] = 0.0F;
    linearization->a[0][1] = 0.0F;
    linearization->a[0][2] = 1.0F;
    linearization->a[0][3] = 0.0F;
    linearization->b[0][0] = 0.0F;
    linearization->b[0][1] = 0.0F;
    linearization->a[1][0] = 0.0F;
    linearization->a[1][1] = 0.0F;
    linearization->a[1][2] = 0.0F;
    linearization->a[1][3] = 1.0F;
    linearization->b[1][0] = 0.0F;
    linearization->b[1][1] = 0.0F;
    linearization->a[2][0] = t52;
    linearization->a[2][1] = t136;
    linearization->a[2][2] = t127;
    linearization->a[2][3] = t137;
    linearization->b[2][0] = t135;
    linearization->b[2][1] = t138;
    linearization->a[3][0] = t50;
    linearization->a[3][1] = t110;
    linearization->a[3][2] = t125;
    linearization->a[3][3] = t131;
    linearization->b[3][0] = t138;
    linearization->b[3][1] = t46;
}

carvallo_motion_error_t double_pendulum_f32_motion_linearize(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    const float forces[DOUBLE_PENDULUM_FORCES], double_pendulum_f32_linearization_t *linearization)
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, DOUBLE_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, DOUBLE_PENDULUM_SPEEDS) && carvallo_are_finite_f32(forces,
        DOUBLE_PENDULUM_FORCES)) {
        bool are_finite = true;
        double_pendulum_f32_compute_linearization(motion, positions, speeds, forces, linearization);
        for (size_t row = 0U; row < DOUBLE_PENDULUM_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f32(linearization->a[row],
                DOUBLE_PENDULUM_STATES) && carvallo_are_finite_f32(linearization->b[row],
                DOUBLE_PENDULUM_FORCES);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void double_pendulum_f32_compute_by_parameters(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    const float forces[DOUBLE_PENDULUM_FORCES],
    float by_parameters[DOUBLE_PENDULUM_STATES][DOUBLE_PENDULUM_PARAMETERS])
{
    float sin_theta2 = 0.0F;
    float cos_theta2 = 0.0F;
    carvallo_sin_cos_f32(positions[1], &sin_theta2, &cos_theta2);
    const float t7 = motion->constants[0] * cos_theta2 * motion->constants[7];
    const float t10 = motion->constants[8] - t7;
    const float t13 = motion->constants[6] + motion->constants[11] + t10 - t7;
    const float t14 = 1.0F / t13;
    float sin_theta1 = 0.0F;
    float cos_theta1 = 0.0F;
    carvallo_sin_cos_f32(positions[0], &sin_theta1, &cos_theta1);
    const float t22 = speeds[0] * speeds[0];
    const float t24 = (motion->constants[0] * t22) - (cos_theta1 * motion->constants[9]);
    const float t25 = sin_theta2 * t24;
    const float t27 = motion->constants[9] * sin_theta1;
    const float t32 = t25 - (cos_theta2 * t27);
    const float t33 = motion->constants[7] * t32;
    const float t34 = cos_theta2 * motion->constants[3];
    const float t36 = cos_theta2 * t24;
    const float t41 = speeds[0] + speeds[1];
    const float t42 = t41 * t41;
    const float t43 = motion->constants[7] * t42;
    const float t46 = (t32 * t34) - (sin_theta2 * ((motion->constants[3] * (t36 + (sin_theta2 *
        t27))) - t43));
    const float t50 = forces[0] + (t27 * motion->constants[5]) + t33 - (motion->constants[0] * t46);
    const float t52 = t10 * t14;
    const float t60 = 1.0F / (motion->constants[8] - (t13 * t52 * t52));
    const float t61 = (t33 + forces[1] - (t50 * t52)) * t60;
    const float t63 = (t14 * t50) - (t52 * t61);
    const float t65 = (motion->constants[0] * t63) - t27;
    const float t67 = t25 + (cos_theta2 * t65);
    const float t69 = t61 + t63;
    const float t70 = motion->constants[7] * t69;
    const float t74 = t36 - (sin_theta2 * t65);
    const float t80 = (sin_theta2 * t22) + (cos_theta2 * t63);
    const float t81 = motion->constants[7] * t80;
    const float t82 = sin_theta2 * t34;
    const float t85 = motion->constants[3] * sin_theta2 * sin_theta2;
    const float t93 = (sin_theta2 * ((motion->constants[3] * t74) - t43)) + t81 - (cos_theta2 *
        ((motion->constants[3] * t67) - t70)) - (motion->constants[0] * ((t63 * t85) + (t34 * t80) -
        (t22 * t82)));
    const float t97 = t60 * (t81 - (t52 * t93));
    const float t99 = (t14 * t93) - (t52 * t97);
    const float t104 = (t63 * motion->constants[2]) - t27;
    const float t106 = (motion->constants[5] * t63) + (motion->constants[1] * t104);
    const float t108 = t52 * t60;
    const float t109 = t106 * t108;
    const float t112 = motion->constants[2] * t104;
    const float t114 = t108 * t112;
    const float t118 = t63 * t108;
    const float t123 = motion->constants[0] - motion->constants[0] - motion->constants[4];
    const float t125 = (t69 * t123) - t67;
    const float t127 = t70 + (motion->constants[3] * t125);
    const float t130 = (sin_theta2 * t42) - (cos_theta2 * t69);
    const float t133 = t127 + (motion->constants[0] * motion->constants[3] * t130);
    const float t137 = t60 * (t127 - (t52 * t133));
    const float t139 = (t14 * t133) - (t52 * t137);
    const float t140 = t123 * t125;
    const float t147 = t140 + (motion->constants[0] * ((cos_theta2 * t67) + (t123 * t130) -
        (sin_theta2 * t74)));
    const float t151 = t60 * ((t52 * t147) - t140);
    const float t157 = t60 * ((t52 * t69) - t69);
    const float t163 = (sin_theta2 * cos_theta1) + (cos_theta2 * sin_theta1);
    const float t164 = motion->constants[7] * t163;
    const float t172 = (sin_theta1 * motion->constants[5]) - t164 - (motion->constants[0] *
        ((cos_theta1 * t82) - (sin_theta1 * t85) - (t34 * t163)));
    const float t176 = t60 * (t164 + (t52 * t172));
    const float t178 = (t14 * t172) + (t52 * t176);
    const float t179 = -((t14 * t106) + (t52 * t109));
    const float t180 = -((t14 * t112) + (t52 * t114));
    const float t181 = -((t14 * t63) + (t52 * t118));
    const float t182 = -((t14 * t147) + (t52 * t151));
    const float t183 = -((t14 * t69) + (t52 * t157));
    const float t184 = -t176;
    by_parameters[0][0] = 0.0F;
    by_parameters[0][1] = 0.0F;
    by_parameters[0][2] = 0.0F;
    by_parameters[0][3] = 0.0F;
    by_parameters[0][4] = 0.0F;
    by_parameters[0][5] = 0.0F;
    by_parameters[0][6] = 0.0F;
    by_parameters[0][7] = 0.0F;
    by_parameters[1][0] = 0.0F;
    by_parameters[1][1] = 0.0F;
    by_parameters[1][2] = 0.0F;
    by_parameters[1][3] = 0.0F;
    by_parameters[1][4] = 0.0F;
    by_parameters[1][5] = 0.0F;
    by_parameters[1][6] = 0.0F;
    by_parameters[1][7] = 0.0F;
    by_parameters[2][0] = t99;
    by_parameters[2][1] = t179;
    by_parameters[2][2] = t180;
    by_parameters[2][3] = t181;
    by_parameters[2][4] = t139;
    by_parameters[2][5] = t182;
    by_parameters[2][6] = t183;
    by_parameters[2][7] = t178;
    by_parameters[3][0] = t97;
    by_parameters[3][1] = t109;
    by_parameters[3][2] = t114;
    by_parameters[3][3] = t118;
    by_parameters[3][4] = t137;
    by_parameters[3][5] = t151;
    by_parameters[3][6] = t157;
    by_parameters[3][7] = t184;
}

carvallo_motion_error_t double_pendulum_f32_motion_by_parameters(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    const float forces[DOUBLE_PENDULUM_FORCES],
    float by_parameters[DOUBLE_PENDULUM_STATES][DOUBLE_PENDULUM_PARAMETERS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, DOUBLE_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, DOUBLE_PENDULUM_SPEEDS) && carvallo_are_finite_f32(forces,
        DOUBLE_PENDULUM_FORCES)) {
        bool are_finite = true;
        double_pendulum_f32_compute_by_parameters(motion, positions, speeds, forces, by_parameters);
        for (size_t row = 0U; row < DOUBLE_PENDULUM_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f32(by_parameters[row],
                DOUBLE_PENDULUM_PARAMETERS);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}
