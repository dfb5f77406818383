/* @generated from generated/models/rolling_disc.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 8da020cde61b723e
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * Jxx_all = It + r^2*m [kg*m^2]
 * Sz_all = -r*m [kg*m]
 * h_spin_D = Ia/r [kg*m]
 * M_11 = Jxx_all [kg*m^2]
 * M_22 = It [kg*m^2]
 * C1_12 = h_spin_D - Sz_all [kg*m]
 * C1_21 = -h_spin_D [kg*m]
 * K0_11 = Sz_all [kg*m]
 * @endverbatim
 */

#include "rolling_disc.h"

#include <float.h>

const char *rolling_disc_set_name(rolling_disc_set_t set)
{
    static const char *const TEXTS[] = {
        "uniform",
        "hoop",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *rolling_disc_validity_text(rolling_disc_validity_t validity)
{
    static const char *const TEXTS[] = {
        "RollingDisc: the parameters are valid",
        "RollingDisc: r in m must be finite and > 0",
        "RollingDisc: m in kg must be finite and > 0",
        "RollingDisc: Ia in kg*m^2 must be finite and >= 0",
        "RollingDisc: It in kg*m^2 must be finite and > 0",
        "RollingDisc: g in N/kg must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t rolling_disc_partials[ROLLING_DISC_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 0U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 1U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 2U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 0U, 3U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 1U, 4U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 5U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 1U, 5U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 6U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 6U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 3U, 7U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 3U, 7U, false}
};

const rolling_disc_f64_t rolling_disc_f64_sets[ROLLING_DISC_SETS] = {
    { /* uniform */
        .r = 0.3,
        .m = 1.0,
        .Ia = 0.045,
        .It = 0.0225,
        .g = 9.81
    },
    { /* hoop */
        .r = 0.3,
        .m = 1.0,
        .Ia = 0.09,
        .It = 0.045,
        .g = 9.81
    }
};

rolling_disc_validity_t rolling_disc_f64_validate(const rolling_disc_f64_t *p)
{
    rolling_disc_validity_t validity = ROLLING_DISC_VALID;
    if (!((p->r > 0.0) && (p->r <= DBL_MAX))) {
        validity = ROLLING_DISC_INVALID_r;
    } else if (!((p->m > 0.0) && (p->m <= DBL_MAX))) {
        validity = ROLLING_DISC_INVALID_m;
    } else if (!((p->Ia >= 0.0) && (p->Ia <= DBL_MAX))) {
        validity = ROLLING_DISC_INVALID_Ia;
    } else if (!((p->It > 0.0) && (p->It <= DBL_MAX))) {
        validity = ROLLING_DISC_INVALID_It;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = ROLLING_DISC_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void rolling_disc_f64_matrices(const rolling_disc_f64_t *p, rolling_disc_f64_matrices_t *matrices)
{
    const double t3 = p->r * p->m;
    const double Jxx_all = p->It + (p->r * t3);
    const double h_spin_D = p->Ia / p->r;
    const double C1_12 = t3 + h_spin_D;
    const double C1_21 = -h_spin_D;
    const double K0_11 = -t3;
    matrices->m[0][0] = Jxx_all;
    matrices->m[0][1] = 0.0;
    matrices->m[1][0] = 0.0;
    matrices->m[1][1] = p->It;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = 0.0;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = 0.0;
    matrices->k0[1][0] = 0.0;
    matrices->k0[1][1] = 0.0;
}

carvallo_system_error_t rolling_disc_f64_at_speed(const rolling_disc_f64_matrices_t *matrices,
    double speed, double gravity, rolling_disc_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed) && carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < ROLLING_DISC_N; row++) {
        for (size_t column = 0U; column < ROLLING_DISC_N; column++) {
            const double damping = matrices->c1[row][column] * speed;
            const double stiffness = matrices->k0[row][column] * gravity;
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->c1[row][column]) &&
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

carvallo_system_error_t rolling_disc_f64_state_space(const rolling_disc_f64_system_t *system,
    rolling_disc_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[ROLLING_DISC_N * ROLLING_DISC_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * ROLLING_DISC_N * ROLLING_DISC_N];
    for (size_t row = 0U; row < ROLLING_DISC_N; row++) {
        double *const solved = &x[3U * ROLLING_DISC_N * row];
        for (size_t column = 0U; column < ROLLING_DISC_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * ROLLING_DISC_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[ROLLING_DISC_N + column] = -system->c[row][column];
            solved[(2U * ROLLING_DISC_N) + column] = 0.0;
        }
        solved[(2U * ROLLING_DISC_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[ROLLING_DISC_N * ROLLING_DISC_N];
        error = carvallo_solve_f64(ROLLING_DISC_N, m, terms, 3U * ROLLING_DISC_N, x);
    }
    for (size_t row = 0U; row < (2U * ROLLING_DISC_N); row++) {
        for (size_t column = 0U; column < (2U * ROLLING_DISC_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < ROLLING_DISC_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < ROLLING_DISC_N; row++) {
            const size_t target = ROLLING_DISC_N + row;
            for (size_t column = 0U; column < (2U * ROLLING_DISC_N); column++) {
                space->a[target][column] = x[(3U * ROLLING_DISC_N * row) + column];
            }
            for (size_t column = 0U; column < ROLLING_DISC_N; column++) {
                space->b[target][column] = x[(3U * ROLLING_DISC_N * row) + (2U * ROLLING_DISC_N) +
                    column];
            }
            space->a[row][ROLLING_DISC_N + row] = 1.0;
        }
    }
    return error;
}

double rolling_disc_f64_rate_at(const rolling_disc_f64_rate_t *rate, double v,
    const double q[ROLLING_DISC_N], const double q_dot[ROLLING_DISC_N], double psi)
{
    double by_coordinates = 0.0;
    double by_rates = 0.0;
    for (size_t i = 0U; i < ROLLING_DISC_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void rolling_disc_f64_kinematics(const rolling_disc_f64_t *p, rolling_disc_f64_kinematics_t *kinematics)
{
    const double t4 = -(1.0 / p->r);
    kinematics->lateral.speed = 0.0;
    kinematics->lateral.rates[0] = 0.0;
    kinematics->lateral.rates[1] = 0.0;
    kinematics->lateral.coordinates[0] = 0.0;
    kinematics->lateral.coordinates[1] = 1.0;
    kinematics->lateral.heading = 0.0;
    kinematics->wheel_D.speed = t4;
    kinematics->wheel_D.rates[0] = 0.0;
    kinematics->wheel_D.rates[1] = 0.0;
    kinematics->wheel_D.coordinates[0] = 0.0;
    kinematics->wheel_D.coordinates[1] = 0.0;
    kinematics->wheel_D.heading = 0.0;
}

void rolling_disc_f64_derivatives(const rolling_disc_f64_t *p,
    rolling_disc_f64_matrices_t *matrices, rolling_disc_f64_derivatives_t *derivatives)
{
    const double t3 = p->r * p->m;
    const double Jxx_all = p->It + (p->r * t3);
    const double C1_12_Ia = 1.0 / p->r;
    const double h_spin_D = p->Ia * C1_12_Ia;
    const double C1_12 = t3 + h_spin_D;
    const double M_11_r = t3 + t3;
    const double C1_21_r = C1_12_Ia * h_spin_D;
    const double C1_12_r = p->m - C1_21_r;
    const double M_11_m = p->r * p->r;
    const double C1_21 = -h_spin_D;
    const double K0_11 = -t3;
    matrices->m[0][0] = Jxx_all;
    matrices->m[0][1] = 0.0;
    matrices->m[1][0] = 0.0;
    matrices->m[1][1] = p->It;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = 0.0;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = 0.0;
    matrices->k0[1][0] = 0.0;
    matrices->k0[1][1] = 0.0;
    derivatives->values[0] = M_11_r;
    derivatives->values[1] = C1_12_r;
    derivatives->values[2] = C1_21_r;
    derivatives->values[3] = p->m;
    derivatives->values[4] = M_11_m;
    derivatives->values[5] = p->r;
    derivatives->values[6] = C1_12_Ia;
    derivatives->values[7] = 1.0;
}

void rolling_disc_f64_with_respect_to(const rolling_disc_f64_derivatives_t *derivatives,
    size_t parameter, rolling_disc_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < ROLLING_DISC_N; row++) {
        for (size_t column = 0U; column < ROLLING_DISC_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < ROLLING_DISC_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &rolling_disc_partials[position];
        if (partial->parameter == parameter) {
            const double value = derivatives->values[partial->value];
            const double signed_value = partial->is_negative ? (-value) : value;
            switch (partial->matrix) {
            case CARVALLO_MATRIX_M:
                matrices->m[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_C1:
                matrices->c1[partial->row][partial->column] = signed_value;
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

const rolling_disc_f32_t rolling_disc_f32_sets[ROLLING_DISC_SETS] = {
    { /* uniform */
        .r = 0.3F,
        .m = 1.0F,
        .Ia = 0.045F,
        .It = 0.0225F,
        .g = 9.81F
    },
    { /* hoop */
        .r = 0.3F,
        .m = 1.0F,
        .Ia = 0.09F,
        .It = 0.045F,
        .g = 9.81F
    }
};

rolling_disc_validity_t rolling_disc_f32_validate(const rolling_disc_f32_t *p)
{
    rolling_disc_validity_t validity = ROLLING_DISC_VALID;
    if (!((p->r > 0.0F) && (p->r <= FLT_MAX))) {
        validity = ROLLING_DISC_INVALID_r;
    } else if (!((p->m > 0.0F) && (p->m <= FLT_MAX))) {
        validity = ROLLING_DISC_INVALID_m;
    } else if (!((p->Ia >= 0.0F) && (p->Ia <= FLT_MAX))) {
        validity = ROLLING_DISC_INVALID_Ia;
    } else if (!((p->It > 0.0F) && (p->It <= FLT_MAX))) {
        validity = ROLLING_DISC_INVALID_It;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = ROLLING_DISC_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void rolling_disc_f32_matrices(const rolling_disc_f32_t *p, rolling_disc_f32_matrices_t *matrices)
{
    const float t3 = p->r * p->m;
    const float Jxx_all = p->It + (p->r * t3);
    const float h_spin_D = p->Ia / p->r;
    const float C1_12 = t3 + h_spin_D;
    const float C1_21 = -h_spin_D;
    const float K0_11 = -t3;
    matrices->m[0][0] = Jxx_all;
    matrices->m[0][1] = 0.0F;
    matrices->m[1][0] = 0.0F;
    matrices->m[1][1] = p->It;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = 0.0F;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = 0.0F;
    matrices->k0[1][0] = 0.0F;
    matrices->k0[1][1] = 0.0F;
}

carvallo_system_error_t rolling_disc_f32_at_speed(const rolling_disc_f32_matrices_t *matrices,
    float speed, float gravity, rolling_disc_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed) && carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < ROLLING_DISC_N; row++) {
        for (size_t column = 0U; column < ROLLING_DISC_N; column++) {
            const float damping = matrices->c1[row][column] * speed;
            const float stiffness = matrices->k0[row][column] * gravity;
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->c1[row][column]) &&
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

carvallo_system_error_t rolling_disc_f32_state_space(const rolling_disc_f32_system_t *system,
    rolling_disc_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[ROLLING_DISC_N * ROLLING_DISC_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * ROLLING_DISC_N * ROLLING_DISC_N];
    for (size_t row = 0U; row < ROLLING_DISC_N; row++) {
        float *const solved = &x[3U * ROLLING_DISC_N * row];
        for (size_t column = 0U; column < ROLLING_DISC_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * ROLLING_DISC_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[ROLLING_DISC_N + column] = -system->c[row][column];
            solved[(2U * ROLLING_DISC_N) + column] = 0.0F;
        }
        solved[(2U * ROLLING_DISC_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[ROLLING_DISC_N * ROLLING_DISC_N];
        error = carvallo_solve_f32(ROLLING_DISC_N, m, terms, 3U * ROLLING_DISC_N, x);
    }
    for (size_t row = 0U; row < (2U * ROLLING_DISC_N); row++) {
        for (size_t column = 0U; column < (2U * ROLLING_DISC_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < ROLLING_DISC_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < ROLLING_DISC_N; row++) {
            const size_t target = ROLLING_DISC_N + row;
            for (size_t column = 0U; column < (2U * ROLLING_DISC_N); column++) {
                space->a[target][column] = x[(3U * ROLLING_DISC_N * row) + column];
            }
            for (size_t column = 0U; column < ROLLING_DISC_N; column++) {
                space->b[target][column] = x[(3U * ROLLING_DISC_N * row) + (2U * ROLLING_DISC_N) +
                    column];
            }
            space->a[row][ROLLING_DISC_N + row] = 1.0F;
        }
    }
    return error;
}

float rolling_disc_f32_rate_at(const rolling_disc_f32_rate_t *rate, float v,
    const float q[ROLLING_DISC_N], const float q_dot[ROLLING_DISC_N], float psi)
{
    float by_coordinates = 0.0F;
    float by_rates = 0.0F;
    for (size_t i = 0U; i < ROLLING_DISC_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void rolling_disc_f32_kinematics(const rolling_disc_f32_t *p, rolling_disc_f32_kinematics_t *kinematics)
{
    const float t4 = -(1.0F / p->r);
    kinematics->lateral.speed = 0.0F;
    kinematics->lateral.rates[0] = 0.0F;
    kinematics->lateral.rates[1] = 0.0F;
    kinematics->lateral.coordinates[0] = 0.0F;
    kinematics->lateral.coordinates[1] = 1.0F;
    kinematics->lateral.heading = 0.0F;
    kinematics->wheel_D.speed = t4;
    kinematics->wheel_D.rates[0] = 0.0F;
    kinematics->wheel_D.rates[1] = 0.0F;
    kinematics->wheel_D.coordinates[0] = 0.0F;
    kinematics->wheel_D.coordinates[1] = 0.0F;
    kinematics->wheel_D.heading = 0.0F;
}

void rolling_disc_f32_derivatives(const rolling_disc_f32_t *p,
    rolling_disc_f32_matrices_t *matrices, rolling_disc_f32_derivatives_t *derivatives)
{
    const float t3 = p->r * p->m;
    const float Jxx_all = p->It + (p->r * t3);
    const float C1_12_Ia = 1.0F / p->r;
    const float h_spin_D = p->Ia * C1_12_Ia;
    const float C1_12 = t3 + h_spin_D;
    const float M_11_r = t3 + t3;
    const float C1_21_r = C1_12_Ia * h_spin_D;
    const float C1_12_r = p->m - C1_21_r;
    const float M_11_m = p->r * p->r;
    const float C1_21 = -h_spin_D;
    const float K0_11 = -t3;
    matrices->m[0][0] = Jxx_all;
    matrices->m[0][1] = 0.0F;
    matrices->m[1][0] = 0.0F;
    matrices->m[1][1] = p->It;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = C1_12;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = 0.0F;
    matrices->k0[0][0] = K0_11;
    matrices->k0[0][1] = 0.0F;
    matrices->k0[1][0] = 0.0F;
    matrices->k0[1][1] = 0.0F;
    derivatives->values[0] = M_11_r;
    derivatives->values[1] = C1_12_r;
    derivatives->values[2] = C1_21_r;
    derivatives->values[3] = p->m;
    derivatives->values[4] = M_11_m;
    derivatives->values[5] = p->r;
    derivatives->values[6] = C1_12_Ia;
    derivatives->values[7] = 1.0F;
}

void rolling_disc_f32_with_respect_to(const rolling_disc_f32_derivatives_t *derivatives,
    size_t parameter, rolling_disc_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < ROLLING_DISC_N; row++) {
        for (size_t column = 0U; column < ROLLING_DISC_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < ROLLING_DISC_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &rolling_disc_partials[position];
        if (partial->parameter == parameter) {
            const float value = derivatives->values[partial->value];
            const float signed_value = partial->is_negative ? (-value) : value;
            switch (partial->matrix) {
            case CARVALLO_MATRIX_M:
                matrices->m[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_C1:
                matrices->c1[partial->row][partial->column] = signed_value;
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
