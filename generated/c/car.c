/* @generated from generated/models/car.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: bdb58fbb39c088e9
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * M_11 = m [kg]
 * M_22 = I [kg*m^2]
 * C-1_11 = Cf + Cr [kg*m/s^2]
 * C-1_12 = C-1_21 = a*Cf - b*Cr [kg*m^2/s^2]
 * C-1_22 = a^2*Cf + b^2*Cr [kg*m^3/s^2]
 * C1_12 = m [kg]
 * @endverbatim
 */

#include "car.h"

#include <float.h>

const char *car_set_name(car_set_t set)
{
    static const char *const TEXTS[] = {
        "oversteering",
        "understeering",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *car_validity_text(car_validity_t validity)
{
    static const char *const TEXTS[] = {
        "Car: the parameters are valid",
        "Car: m in kg must be finite and > 0",
        "Car: I in kg*m^2 must be finite and > 0",
        "Car: a in m must be finite and > 0",
        "Car: b in m must be finite and > 0",
        "Car: Cf in N must be finite and > 0",
        "Car: Cr in N must be finite and > 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t car_partials[CAR_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 4U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 4U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 4U, false},
    {CARVALLO_MATRIX_CM1, 0U, 1U, 2U, 2U, false},
    {CARVALLO_MATRIX_CM1, 1U, 0U, 2U, 2U, false},
    {CARVALLO_MATRIX_CM1, 1U, 1U, 2U, 7U, false},
    {CARVALLO_MATRIX_CM1, 0U, 1U, 3U, 3U, true},
    {CARVALLO_MATRIX_CM1, 1U, 0U, 3U, 3U, true},
    {CARVALLO_MATRIX_CM1, 1U, 1U, 3U, 8U, false},
    {CARVALLO_MATRIX_CM1, 0U, 0U, 4U, 4U, false},
    {CARVALLO_MATRIX_CM1, 0U, 1U, 4U, 0U, false},
    {CARVALLO_MATRIX_CM1, 1U, 0U, 4U, 0U, false},
    {CARVALLO_MATRIX_CM1, 1U, 1U, 4U, 5U, false},
    {CARVALLO_MATRIX_CM1, 0U, 0U, 5U, 4U, false},
    {CARVALLO_MATRIX_CM1, 0U, 1U, 5U, 1U, true},
    {CARVALLO_MATRIX_CM1, 1U, 0U, 5U, 1U, true},
    {CARVALLO_MATRIX_CM1, 1U, 1U, 5U, 6U, false}
};

const car_f64_t car_f64_sets[CAR_SETS] = {
    { /* oversteering */
        .m = 1400.0,
        .I_ = 2420.0,
        .a = 1.14,
        .b = 1.33,
        .Cf = 25000.0,
        .Cr = 21000.0
    },
    { /* understeering */
        .m = 1400.0,
        .I_ = 2420.0,
        .a = 1.33,
        .b = 1.14,
        .Cf = 21000.0,
        .Cr = 25000.0
    }
};

car_validity_t car_f64_validate(const car_f64_t *p)
{
    car_validity_t validity = CAR_VALID;
    if (!((p->m > 0.0) && (p->m <= DBL_MAX))) {
        validity = CAR_INVALID_m;
    } else if (!((p->I_ > 0.0) && (p->I_ <= DBL_MAX))) {
        validity = CAR_INVALID_I_;
    } else if (!((p->a > 0.0) && (p->a <= DBL_MAX))) {
        validity = CAR_INVALID_a;
    } else if (!((p->b > 0.0) && (p->b <= DBL_MAX))) {
        validity = CAR_INVALID_b;
    } else if (!((p->Cf > 0.0) && (p->Cf <= DBL_MAX))) {
        validity = CAR_INVALID_Cf;
    } else if (!((p->Cr > 0.0) && (p->Cr <= DBL_MAX))) {
        validity = CAR_INVALID_Cr;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void car_f64_matrices(const car_f64_t *p, car_f64_matrices_t *matrices)
{
    const double Cm1_11 = p->Cf + p->Cr;
    const double t7 = p->Cr * p->b;
    const double t9 = p->Cf * p->a;
    const double Cm1_12 = t9 - t7;
    const double Cm1_22 = (p->a * t9) + (p->b * t7);
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = 0.0;
    matrices->m[1][0] = 0.0;
    matrices->m[1][1] = p->I_;
    matrices->cm1[0][0] = Cm1_11;
    matrices->cm1[0][1] = Cm1_12;
    matrices->cm1[1][0] = Cm1_12;
    matrices->cm1[1][1] = Cm1_22;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = p->m;
    matrices->c1[1][0] = 0.0;
    matrices->c1[1][1] = 0.0;
}

carvallo_system_error_t car_f64_at_speed(const car_f64_matrices_t *matrices, double speed,
    car_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed);
    bool is_in_range = true;
    const bool moves = (speed < 0.0) || (speed > 0.0);
    bool is_at_rest = false;
    for (size_t row = 0U; row < CAR_N; row++) {
        for (size_t column = 0U; column < CAR_N; column++) {
            /* Where there is no C-1, nothing is divided by a speed of zero. */
            const double odd = matrices->cm1[row][column];
            const bool divides = (odd < 0.0) || (odd > 0.0);
            double divided = 0.0;
            if (divides && moves) {
                divided = odd / speed;
            } else {
                is_at_rest = is_at_rest || divides;
            }
            const double damping = (matrices->c1[row][column] * speed) + divided;
            const double stiffness = 0.0;
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->cm1[row][column]) &&
                carvallo_is_finite_f64(matrices->c1[row][column]);
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

carvallo_system_error_t car_f64_state_space(const car_f64_system_t *system,
    car_f64_state_space_t *space)
{
    /* The row of A and B for each coordinate, and whether its position is a state beside its rate. */
    static const size_t TARGETS[CAR_N] = {CAR_N + 0U, CAR_N + 1U};
    static const bool HAS_BOTH[CAR_N] = {false, false};
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[CAR_N * CAR_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * CAR_N * CAR_N];
    for (size_t row = 0U; row < CAR_N; row++) {
        double *const solved = &x[3U * CAR_N * row];
        for (size_t column = 0U; column < CAR_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * CAR_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[CAR_N + column] = -system->c[row][column];
            solved[(2U * CAR_N) + column] = 0.0;
        }
        solved[(2U * CAR_N) + row] = 1.0;
        solved[0] = 0.0;
        solved[1] = 0.0;
    }
    if (is_finite) {
        double terms[CAR_N * CAR_N];
        error = carvallo_solve_f64(CAR_N, m, terms, 3U * CAR_N, x);
    }
    for (size_t row = 0U; row < (2U * CAR_N); row++) {
        for (size_t column = 0U; column < (2U * CAR_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < CAR_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < CAR_N; row++) {
            const size_t target = TARGETS[row];
            for (size_t column = 0U; column < (2U * CAR_N); column++) {
                space->a[target][column] = x[(3U * CAR_N * row) + column];
            }
            for (size_t column = 0U; column < CAR_N; column++) {
                space->b[target][column] = x[(3U * CAR_N * row) + (2U * CAR_N) + column];
            }
            if (HAS_BOTH[row]) {
                space->a[row][CAR_N + row] = 1.0;
            }
        }
    }
    return error;
}

void car_f64_derivatives(const car_f64_t *p, car_f64_matrices_t *matrices,
    car_f64_derivatives_t *derivatives)
{
    const double Cm1_11 = p->Cf + p->Cr;
    const double t9 = p->Cr * p->b;
    const double t10 = p->Cf * p->a;
    const double Cm1_12 = t10 - t9;
    const double Cm1_22_Cf = p->a * p->a;
    const double Cm1_22_Cr = p->b * p->b;
    const double Cm1_22 = (p->Cf * Cm1_22_Cf) + (p->Cr * Cm1_22_Cr);
    const double Cm1_22_a = t10 + t10;
    const double Cm1_22_b = t9 + t9;
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = 0.0;
    matrices->m[1][0] = 0.0;
    matrices->m[1][1] = p->I_;
    matrices->cm1[0][0] = Cm1_11;
    matrices->cm1[0][1] = Cm1_12;
    matrices->cm1[1][0] = Cm1_12;
    matrices->cm1[1][1] = Cm1_22;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = p->m;
    matrices->c1[1][0] = 0.0;
    matrices->c1[1][1] = 0.0;
    derivatives->values[0] = p->a;
    derivatives->values[1] = p->b;
    derivatives->values[2] = p->Cf;
    derivatives->values[3] = p->Cr;
    derivatives->values[4] = 1.0;
    derivatives->values[5] = Cm1_22_Cf;
    derivatives->values[6] = Cm1_22_Cr;
    derivatives->values[7] = Cm1_22_a;
    derivatives->values[8] = Cm1_22_b;
}

void car_f64_with_respect_to(const car_f64_derivatives_t *derivatives, size_t parameter,
    car_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < CAR_N; row++) {
        for (size_t column = 0U; column < CAR_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->cm1[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < CAR_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &car_partials[position];
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
            case CARVALLO_MATRIX_C1:
                matrices->c1[partial->row][partial->column] = signed_value;
                break;
            default:
                /* The model has no other matrix. */
                break;
            }
        }
    }
}

const car_f32_t car_f32_sets[CAR_SETS] = {
    { /* oversteering */
        .m = 1400.0F,
        .I_ = 2420.0F,
        .a = 1.14F,
        .b = 1.33F,
        .Cf = 25000.0F,
        .Cr = 21000.0F
    },
    { /* understeering */
        .m = 1400.0F,
        .I_ = 2420.0F,
        .a = 1.33F,
        .b = 1.14F,
        .Cf = 21000.0F,
        .Cr = 25000.0F
    }
};

car_validity_t car_f32_validate(const car_f32_t *p)
{
    car_validity_t validity = CAR_VALID;
    if (!((p->m > 0.0F) && (p->m <= FLT_MAX))) {
        validity = CAR_INVALID_m;
    } else if (!((p->I_ > 0.0F) && (p->I_ <= FLT_MAX))) {
        validity = CAR_INVALID_I_;
    } else if (!((p->a > 0.0F) && (p->a <= FLT_MAX))) {
        validity = CAR_INVALID_a;
    } else if (!((p->b > 0.0F) && (p->b <= FLT_MAX))) {
        validity = CAR_INVALID_b;
    } else if (!((p->Cf > 0.0F) && (p->Cf <= FLT_MAX))) {
        validity = CAR_INVALID_Cf;
    } else if (!((p->Cr > 0.0F) && (p->Cr <= FLT_MAX))) {
        validity = CAR_INVALID_Cr;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void car_f32_matrices(const car_f32_t *p, car_f32_matrices_t *matrices)
{
    const float Cm1_11 = p->Cf + p->Cr;
    const float t7 = p->Cr * p->b;
    const float t9 = p->Cf * p->a;
    const float Cm1_12 = t9 - t7;
    const float Cm1_22 = (p->a * t9) + (p->b * t7);
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = 0.0F;
    matrices->m[1][0] = 0.0F;
    matrices->m[1][1] = p->I_;
    matrices->cm1[0][0] = Cm1_11;
    matrices->cm1[0][1] = Cm1_12;
    matrices->cm1[1][0] = Cm1_12;
    matrices->cm1[1][1] = Cm1_22;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = p->m;
    matrices->c1[1][0] = 0.0F;
    matrices->c1[1][1] = 0.0F;
}

carvallo_system_error_t car_f32_at_speed(const car_f32_matrices_t *matrices, float speed,
    car_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed);
    bool is_in_range = true;
    const bool moves = (speed < 0.0F) || (speed > 0.0F);
    bool is_at_rest = false;
    for (size_t row = 0U; row < CAR_N; row++) {
        for (size_t column = 0U; column < CAR_N; column++) {
            /* Where there is no C-1, nothing is divided by a speed of zero. */
            const float odd = matrices->cm1[row][column];
            const bool divides = (odd < 0.0F) || (odd > 0.0F);
            float divided = 0.0F;
            if (divides && moves) {
                divided = odd / speed;
            } else {
                is_at_rest = is_at_rest || divides;
            }
            const float damping = (matrices->c1[row][column] * speed) + divided;
            const float stiffness = 0.0F;
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->cm1[row][column]) &&
                carvallo_is_finite_f32(matrices->c1[row][column]);
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

carvallo_system_error_t car_f32_state_space(const car_f32_system_t *system,
    car_f32_state_space_t *space)
{
    /* The row of A and B for each coordinate, and whether its position is a state beside its rate. */
    static const size_t TARGETS[CAR_N] = {CAR_N + 0U, CAR_N + 1U};
    static const bool HAS_BOTH[CAR_N] = {false, false};
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[CAR_N * CAR_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * CAR_N * CAR_N];
    for (size_t row = 0U; row < CAR_N; row++) {
        float *const solved = &x[3U * CAR_N * row];
        for (size_t column = 0U; column < CAR_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * CAR_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[CAR_N + column] = -system->c[row][column];
            solved[(2U * CAR_N) + column] = 0.0F;
        }
        solved[(2U * CAR_N) + row] = 1.0F;
        solved[0] = 0.0F;
        solved[1] = 0.0F;
    }
    if (is_finite) {
        float terms[CAR_N * CAR_N];
        error = carvallo_solve_f32(CAR_N, m, terms, 3U * CAR_N, x);
    }
    for (size_t row = 0U; row < (2U * CAR_N); row++) {
        for (size_t column = 0U; column < (2U * CAR_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < CAR_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < CAR_N; row++) {
            const size_t target = TARGETS[row];
            for (size_t column = 0U; column < (2U * CAR_N); column++) {
                space->a[target][column] = x[(3U * CAR_N * row) + column];
            }
            for (size_t column = 0U; column < CAR_N; column++) {
                space->b[target][column] = x[(3U * CAR_N * row) + (2U * CAR_N) + column];
            }
            if (HAS_BOTH[row]) {
                space->a[row][CAR_N + row] = 1.0F;
            }
        }
    }
    return error;
}

void car_f32_derivatives(const car_f32_t *p, car_f32_matrices_t *matrices,
    car_f32_derivatives_t *derivatives)
{
    const float Cm1_11 = p->Cf + p->Cr;
    const float t9 = p->Cr * p->b;
    const float t10 = p->Cf * p->a;
    const float Cm1_12 = t10 - t9;
    const float Cm1_22_Cf = p->a * p->a;
    const float Cm1_22_Cr = p->b * p->b;
    const float Cm1_22 = (p->Cf * Cm1_22_Cf) + (p->Cr * Cm1_22_Cr);
    const float Cm1_22_a = t10 + t10;
    const float Cm1_22_b = t9 + t9;
    matrices->m[0][0] = p->m;
    matrices->m[0][1] = 0.0F;
    matrices->m[1][0] = 0.0F;
    matrices->m[1][1] = p->I_;
    matrices->cm1[0][0] = Cm1_11;
    matrices->cm1[0][1] = Cm1_12;
    matrices->cm1[1][0] = Cm1_12;
    matrices->cm1[1][1] = Cm1_22;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = p->m;
    matrices->c1[1][0] = 0.0F;
    matrices->c1[1][1] = 0.0F;
    derivatives->values[0] = p->a;
    derivatives->values[1] = p->b;
    derivatives->values[2] = p->Cf;
    derivatives->values[3] = p->Cr;
    derivatives->values[4] = 1.0F;
    derivatives->values[5] = Cm1_22_Cf;
    derivatives->values[6] = Cm1_22_Cr;
    derivatives->values[7] = Cm1_22_a;
    derivatives->values[8] = Cm1_22_b;
}

void car_f32_with_respect_to(const car_f32_derivatives_t *derivatives, size_t parameter,
    car_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < CAR_N; row++) {
        for (size_t column = 0U; column < CAR_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->cm1[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < CAR_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &car_partials[position];
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
            case CARVALLO_MATRIX_C1:
                matrices->c1[partial->row][partial->column] = signed_value;
                break;
            default:
                /* The model has no other matrix. */
                break;
            }
        }
    }
}
