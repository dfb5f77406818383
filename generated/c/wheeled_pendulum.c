/* @generated from generated/models/wheeled_pendulum.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 16f5399401874b12
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * spin_L_by_x = -1/r [1/m]
 * spin_L_by_psi = -b/r [1]
 * Jyy_all = m*(l + r)^2 + Iyy + 2*mW*r^2 + 2*Ia [kg*m^2]
 * Jzz_all = Izz + 2*mW*b^2 + 2*Ir [kg*m^2]
 * Sz_all = -m*(l + r) - 2*mW*r [kg*m]
 * m_all = m + 2*mW [kg]
 * K_theta_theta = r*m_all + Sz_all [kg*m]
 * P_x_theta = 2*Ia*spin_L_by_x + Sz_all [kg*m]
 * P_x_spin_L = Ia*spin_L_by_x [kg*m]
 * P_psi_spin_L = Ia*spin_L_by_psi [kg*m^2]
 * M_11 = 2*spin_L_by_x*P_x_spin_L + m_all [kg]
 * M_12 = M_21 = P_x_theta [kg*m]
 * M_22 = Jyy_all [kg*m^2]
 * M_33 = 2*spin_L_by_psi*P_psi_spin_L + Jzz_all [kg*m^2]
 * K0_22 = K_theta_theta [kg*m]
 * @endverbatim
 */

#include "wheeled_pendulum.h"

#include <float.h>

const char *wheeled_pendulum_set_name(wheeled_pendulum_set_t set)
{
    static const char *const TEXTS[] = {
        "robot",
        "transporter",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *wheeled_pendulum_validity_text(wheeled_pendulum_validity_t validity)
{
    static const char *const TEXTS[] = {
        "WheeledPendulum: the parameters are valid",
        "WheeledPendulum: m in kg must be finite and > 0",
        "WheeledPendulum: l in m must be finite and > 0",
        "WheeledPendulum: Iyy in kg*m^2 must be finite and >= 0",
        "WheeledPendulum: Izz in kg*m^2 must be finite and >= 0",
        "WheeledPendulum: mW in kg must be finite and >= 0",
        "WheeledPendulum: Ia in kg*m^2 must be finite and >= 0",
        "WheeledPendulum: Ir in kg*m^2 must be finite and >= 0",
        "WheeledPendulum: r in m must be finite and > 0",
        "WheeledPendulum: b in m must be finite and > 0",
        "WheeledPendulum: g in N/kg must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t wheeled_pendulum_partials[WHEELED_PENDULUM_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 0U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 1U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 1U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 2U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 3U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 4U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 4U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 5U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 4U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 0U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 3U, 0U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 6U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 4U, 7U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 4U, 7U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 4U, 8U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 4U, 9U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 10U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 5U, 11U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 5U, 11U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 5U, 6U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 5U, 12U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 6U, 6U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 7U, 13U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 7U, 14U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 7U, 14U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 7U, 15U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 7U, 16U, true},
    {CARVALLO_MATRIX_M, 2U, 2U, 8U, 17U, false}
};

const wheeled_pendulum_f64_t wheeled_pendulum_f64_sets[WHEELED_PENDULUM_SETS] = {
    { /* robot */
        .m = 0.6,
        .l = 0.07,
        .Iyy = 0.001,
        .Izz = 0.0011,
        .mW = 0.03,
        .Ia = 2.4e-5,
        .Ir = 1.2e-5,
        .r = 0.04,
        .b = 0.07,
        .g = 9.81
    },
    { /* transporter */
        .m = 110.0,
        .l = 0.9,
        .Iyy = 12.0,
        .Izz = 2.0,
        .mW = 5.0,
        .Ia = 0.08,
        .Ir = 0.045,
        .r = 0.24,
        .b = 0.28,
        .g = 9.81
    }
};

wheeled_pendulum_validity_t wheeled_pendulum_f64_validate(const wheeled_pendulum_f64_t *p)
{
    wheeled_pendulum_validity_t validity = WHEELED_PENDULUM_VALID;
    if (!((p->m > 0.0) && (p->m <= DBL_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_m;
    } else if (!((p->l > 0.0) && (p->l <= DBL_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_l;
    } else if (!((p->Iyy >= 0.0) && (p->Iyy <= DBL_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_Iyy;
    } else if (!((p->Izz >= 0.0) && (p->Izz <= DBL_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_Izz;
    } else if (!((p->mW >= 0.0) && (p->mW <= DBL_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_mW;
    } else if (!((p->Ia >= 0.0) && (p->Ia <= DBL_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_Ia;
    } else if (!((p->Ir >= 0.0) && (p->Ir <= DBL_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_Ir;
    } else if (!((p->r > 0.0) && (p->r <= DBL_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_r;
    } else if (!((p->b > 0.0) && (p->b <= DBL_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_b;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void wheeled_pendulum_f64_matrices(const wheeled_pendulum_f64_t *p, wheeled_pendulum_f64_matrices_t *matrices)
{
    const double t2 = p->mW + p->mW;
    const double m_all = p->m + t2;
    const double t5 = 1.0 / p->r;
    const double t7 = p->Ia + p->Ia;
    const double t8 = t5 * t7;
    const double t9 = t5 * t8;
    const double M_11 = m_all + t9;
    const double t11 = t2 * p->r;
    const double t13 = p->r + p->l;
    const double t14 = p->m * t13;
    const double t15 = t11 + t14;
    const double M_22 = t7 + p->Iyy + (p->r * t11) + (t13 * t14);
    const double t26 = p->b * p->b;
    const double M_33 = p->Izz + (t2 * t26) + (t9 * t26) + p->Ir + p->Ir;
    const double K0_22 = (m_all * p->r) - t15;
    const double M_12 = -(t8 + t15);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = 0.0;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = 0.0;
    matrices->m[2][0] = 0.0;
    matrices->m[2][1] = 0.0;
    matrices->m[2][2] = M_33;
    matrices->k0[0][0] = 0.0;
    matrices->k0[0][1] = 0.0;
    matrices->k0[0][2] = 0.0;
    matrices->k0[1][0] = 0.0;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0;
    matrices->k0[2][0] = 0.0;
    matrices->k0[2][1] = 0.0;
    matrices->k0[2][2] = 0.0;
}

carvallo_system_error_t wheeled_pendulum_f64_system(const wheeled_pendulum_f64_matrices_t *matrices,
    double gravity, wheeled_pendulum_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < WHEELED_PENDULUM_N; row++) {
        for (size_t column = 0U; column < WHEELED_PENDULUM_N; column++) {
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

carvallo_system_error_t wheeled_pendulum_f64_state_space(const wheeled_pendulum_f64_system_t *system,
    wheeled_pendulum_f64_state_space_t *space)
{
    /* The row of A and B for each coordinate, and whether its position is a state beside its rate. */
    static const size_t TARGETS[WHEELED_PENDULUM_N] = {WHEELED_PENDULUM_N + 0U, WHEELED_PENDULUM_N + 1U, WHEELED_PENDULUM_N + 2U};
    static const bool HAS_BOTH[WHEELED_PENDULUM_N] = {false, true, false};
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[WHEELED_PENDULUM_N * WHEELED_PENDULUM_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * WHEELED_PENDULUM_N * WHEELED_PENDULUM_N];
    for (size_t row = 0U; row < WHEELED_PENDULUM_N; row++) {
        double *const solved = &x[3U * WHEELED_PENDULUM_N * row];
        for (size_t column = 0U; column < WHEELED_PENDULUM_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * WHEELED_PENDULUM_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHEELED_PENDULUM_N + column] = -system->c[row][column];
            solved[(2U * WHEELED_PENDULUM_N) + column] = 0.0;
        }
        solved[(2U * WHEELED_PENDULUM_N) + row] = 1.0;
        solved[0] = 0.0;
        solved[2] = 0.0;
    }
    if (is_finite) {
        double terms[WHEELED_PENDULUM_N * WHEELED_PENDULUM_N];
        error = carvallo_solve_f64(WHEELED_PENDULUM_N, m, terms, 3U * WHEELED_PENDULUM_N, x);
    }
    for (size_t row = 0U; row < (2U * WHEELED_PENDULUM_N); row++) {
        for (size_t column = 0U; column < (2U * WHEELED_PENDULUM_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < WHEELED_PENDULUM_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHEELED_PENDULUM_N; row++) {
            const size_t target = TARGETS[row];
            for (size_t column = 0U; column < (2U * WHEELED_PENDULUM_N); column++) {
                space->a[target][column] = x[(3U * WHEELED_PENDULUM_N * row) + column];
            }
            for (size_t column = 0U; column < WHEELED_PENDULUM_N; column++) {
                space->b[target][column] = x[(3U * WHEELED_PENDULUM_N * row) + (2U *
                    WHEELED_PENDULUM_N) + column];
            }
            if (HAS_BOTH[row]) {
                space->a[row][WHEELED_PENDULUM_N + row] = 1.0;
            }
        }
    }
    return error;
}

double wheeled_pendulum_f64_rate_at(const wheeled_pendulum_f64_rate_t *rate, double v,
    const double q[WHEELED_PENDULUM_N], const double q_dot[WHEELED_PENDULUM_N], double psi)
{
    double by_coordinates = 0.0;
    double by_rates = 0.0;
    for (size_t i = 0U; i < WHEELED_PENDULUM_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void wheeled_pendulum_f64_kinematics(const wheeled_pendulum_f64_t *p, wheeled_pendulum_f64_kinematics_t *kinematics)
{
    const double t3 = 1.0 / p->r;
    const double t5 = t3 * p->b;
    const double t6 = -t3;
    const double t7 = -t5;
    kinematics->lateral.speed = 0.0;
    kinematics->lateral.rates[0] = 0.0;
    kinematics->lateral.rates[1] = 0.0;
    kinematics->lateral.rates[2] = 0.0;
    kinematics->lateral.coordinates[0] = 0.0;
    kinematics->lateral.coordinates[1] = 0.0;
    kinematics->lateral.coordinates[2] = 1.0;
    kinematics->lateral.heading = 0.0;
    kinematics->lean.speed = 0.0;
    kinematics->lean.rates[0] = 0.0;
    kinematics->lean.rates[1] = 0.0;
    kinematics->lean.rates[2] = 0.0;
    kinematics->lean.coordinates[0] = 0.0;
    kinematics->lean.coordinates[1] = 0.0;
    kinematics->lean.coordinates[2] = 0.0;
    kinematics->lean.heading = 0.0;
    kinematics->wheel_L.speed = t6;
    kinematics->wheel_L.rates[0] = t6;
    kinematics->wheel_L.rates[1] = 0.0;
    kinematics->wheel_L.rates[2] = t7;
    kinematics->wheel_L.coordinates[0] = 0.0;
    kinematics->wheel_L.coordinates[1] = 0.0;
    kinematics->wheel_L.coordinates[2] = 0.0;
    kinematics->wheel_L.heading = 0.0;
    kinematics->wheel_R.speed = t6;
    kinematics->wheel_R.rates[0] = t6;
    kinematics->wheel_R.rates[1] = 0.0;
    kinematics->wheel_R.rates[2] = t5;
    kinematics->wheel_R.coordinates[0] = 0.0;
    kinematics->wheel_R.coordinates[1] = 0.0;
    kinematics->wheel_R.coordinates[2] = 0.0;
    kinematics->wheel_R.heading = 0.0;
    kinematics->forces[0][0] = t6;
    kinematics->forces[0][1] = t6;
    kinematics->forces[1][0] = 0.0;
    kinematics->forces[1][1] = 0.0;
    kinematics->forces[2][0] = t7;
    kinematics->forces[2][1] = t5;
}

void wheeled_pendulum_f64_derivatives(const wheeled_pendulum_f64_t *p,
    wheeled_pendulum_f64_matrices_t *matrices, wheeled_pendulum_f64_derivatives_t *derivatives)
{
    const double t2 = p->mW + p->mW;
    const double m_all = p->m + t2;
    const double t5 = 1.0 / p->r;
    const double t7 = p->Ia + p->Ia;
    const double t8 = t5 * t7;
    const double t9 = t5 * t8;
    const double M_11 = m_all + t9;
    const double t11 = t2 * p->r;
    const double t13 = p->r + p->l;
    const double t14 = p->m * t13;
    const double t15 = t11 + t14;
    const double M_22 = t7 + p->Iyy + (p->r * t11) + (t13 * t14);
    const double t27 = p->b * p->b;
    const double t28 = t2 + t9;
    const double M_33 = p->Izz + p->Ir + p->Ir + (t27 * t28);
    const double K0_22 = (m_all * p->r) - t15;
    const double M_22_m = t13 * t13;
    const double K0_22_m = p->r - t13;
    const double M_22_l = t14 + t14;
    const double t40 = p->r + p->r;
    const double t41 = p->r * p->r;
    const double M_22_mW = t41 + t41;
    const double M_33_mW = t27 + t27;
    const double t44 = t5 * t5;
    const double M_11_Ia = t44 + t44;
    const double t46 = t5 + t5;
    const double M_33_Ia = t27 * M_11_Ia;
    const double t48 = t7 * t44;
    const double t49 = t46 * t48;
    const double M_12_r = t48 - m_all;
    const double M_22_r = t11 + t11 + M_22_l;
    const double t53 = t27 * t49;
    const double M_33_b = t28 * (p->b + p->b);
    const double M_12 = -(t8 + t15);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = 0.0;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = 0.0;
    matrices->m[2][0] = 0.0;
    matrices->m[2][1] = 0.0;
    matrices->m[2][2] = M_33;
    matrices->k0[0][0] = 0.0;
    matrices->k0[0][1] = 0.0;
    matrices->k0[0][2] = 0.0;
    matrices->k0[1][0] = 0.0;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0;
    matrices->k0[2][0] = 0.0;
    matrices->k0[2][1] = 0.0;
    matrices->k0[2][2] = 0.0;
    derivatives->values[0] = 1.0;
    derivatives->values[1] = t13;
    derivatives->values[2] = M_22_m;
    derivatives->values[3] = K0_22_m;
    derivatives->values[4] = p->m;
    derivatives->values[5] = M_22_l;
    derivatives->values[6] = 2.0;
    derivatives->values[7] = t40;
    derivatives->values[8] = M_22_mW;
    derivatives->values[9] = M_33_mW;
    derivatives->values[10] = M_11_Ia;
    derivatives->values[11] = t46;
    derivatives->values[12] = M_33_Ia;
    derivatives->values[13] = t49;
    derivatives->values[14] = M_12_r;
    derivatives->values[15] = M_22_r;
    derivatives->values[16] = t53;
    derivatives->values[17] = M_33_b;
}

void wheeled_pendulum_f64_with_respect_to(const wheeled_pendulum_f64_derivatives_t *derivatives,
    size_t parameter, wheeled_pendulum_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHEELED_PENDULUM_N; row++) {
        for (size_t column = 0U; column < WHEELED_PENDULUM_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < WHEELED_PENDULUM_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &wheeled_pendulum_partials[position];
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

const wheeled_pendulum_f32_t wheeled_pendulum_f32_sets[WHEELED_PENDULUM_SETS] = {
    { /* robot */
        .m = 0.6F,
        .l = 0.07F,
        .Iyy = 0.001F,
        .Izz = 0.0011F,
        .mW = 0.03F,
        .Ia = 2.4e-5F,
        .Ir = 1.2e-5F,
        .r = 0.04F,
        .b = 0.07F,
        .g = 9.81F
    },
    { /* transporter */
        .m = 110.0F,
        .l = 0.9F,
        .Iyy = 12.0F,
        .Izz = 2.0F,
        .mW = 5.0F,
        .Ia = 0.08F,
        .Ir = 0.045F,
        .r = 0.24F,
        .b = 0.28F,
        .g = 9.81F
    }
};

wheeled_pendulum_validity_t wheeled_pendulum_f32_validate(const wheeled_pendulum_f32_t *p)
{
    wheeled_pendulum_validity_t validity = WHEELED_PENDULUM_VALID;
    if (!((p->m > 0.0F) && (p->m <= FLT_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_m;
    } else if (!((p->l > 0.0F) && (p->l <= FLT_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_l;
    } else if (!((p->Iyy >= 0.0F) && (p->Iyy <= FLT_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_Iyy;
    } else if (!((p->Izz >= 0.0F) && (p->Izz <= FLT_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_Izz;
    } else if (!((p->mW >= 0.0F) && (p->mW <= FLT_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_mW;
    } else if (!((p->Ia >= 0.0F) && (p->Ia <= FLT_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_Ia;
    } else if (!((p->Ir >= 0.0F) && (p->Ir <= FLT_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_Ir;
    } else if (!((p->r > 0.0F) && (p->r <= FLT_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_r;
    } else if (!((p->b > 0.0F) && (p->b <= FLT_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_b;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = WHEELED_PENDULUM_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void wheeled_pendulum_f32_matrices(const wheeled_pendulum_f32_t *p, wheeled_pendulum_f32_matrices_t *matrices)
{
    const float t2 = p->mW + p->mW;
    const float m_all = p->m + t2;
    const float t5 = 1.0F / p->r;
    const float t7 = p->Ia + p->Ia;
    const float t8 = t5 * t7;
    const float t9 = t5 * t8;
    const float M_11 = m_all + t9;
    const float t11 = t2 * p->r;
    const float t13 = p->r + p->l;
    const float t14 = p->m * t13;
    const float t15 = t11 + t14;
    const float M_22 = t7 + p->Iyy + (p->r * t11) + (t13 * t14);
    const float t26 = p->b * p->b;
    const float M_33 = p->Izz + (t2 * t26) + (t9 * t26) + p->Ir + p->Ir;
    const float K0_22 = (m_all * p->r) - t15;
    const float M_12 = -(t8 + t15);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = 0.0F;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = 0.0F;
    matrices->m[2][0] = 0.0F;
    matrices->m[2][1] = 0.0F;
    matrices->m[2][2] = M_33;
    matrices->k0[0][0] = 0.0F;
    matrices->k0[0][1] = 0.0F;
    matrices->k0[0][2] = 0.0F;
    matrices->k0[1][0] = 0.0F;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0F;
    matrices->k0[2][0] = 0.0F;
    matrices->k0[2][1] = 0.0F;
    matrices->k0[2][2] = 0.0F;
}

carvallo_system_error_t wheeled_pendulum_f32_system(const wheeled_pendulum_f32_matrices_t *matrices,
    float gravity, wheeled_pendulum_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < WHEELED_PENDULUM_N; row++) {
        for (size_t column = 0U; column < WHEELED_PENDULUM_N; column++) {
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

carvallo_system_error_t wheeled_pendulum_f32_state_space(const wheeled_pendulum_f32_system_t *system,
    wheeled_pendulum_f32_state_space_t *space)
{
    /* The row of A and B for each coordinate, and whether its position is a state beside its rate. */
    static const size_t TARGETS[WHEELED_PENDULUM_N] = {WHEELED_PENDULUM_N + 0U, WHEELED_PENDULUM_N + 1U, WHEELED_PENDULUM_N + 2U};
    static const bool HAS_BOTH[WHEELED_PENDULUM_N] = {false, true, false};
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[WHEELED_PENDULUM_N * WHEELED_PENDULUM_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * WHEELED_PENDULUM_N * WHEELED_PENDULUM_N];
    for (size_t row = 0U; row < WHEELED_PENDULUM_N; row++) {
        float *const solved = &x[3U * WHEELED_PENDULUM_N * row];
        for (size_t column = 0U; column < WHEELED_PENDULUM_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * WHEELED_PENDULUM_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[WHEELED_PENDULUM_N + column] = -system->c[row][column];
            solved[(2U * WHEELED_PENDULUM_N) + column] = 0.0F;
        }
        solved[(2U * WHEELED_PENDULUM_N) + row] = 1.0F;
        solved[0] = 0.0F;
        solved[2] = 0.0F;
    }
    if (is_finite) {
        float terms[WHEELED_PENDULUM_N * WHEELED_PENDULUM_N];
        error = carvallo_solve_f32(WHEELED_PENDULUM_N, m, terms, 3U * WHEELED_PENDULUM_N, x);
    }
    for (size_t row = 0U; row < (2U * WHEELED_PENDULUM_N); row++) {
        for (size_t column = 0U; column < (2U * WHEELED_PENDULUM_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < WHEELED_PENDULUM_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < WHEELED_PENDULUM_N; row++) {
            const size_t target = TARGETS[row];
            for (size_t column = 0U; column < (2U * WHEELED_PENDULUM_N); column++) {
                space->a[target][column] = x[(3U * WHEELED_PENDULUM_N * row) + column];
            }
            for (size_t column = 0U; column < WHEELED_PENDULUM_N; column++) {
                space->b[target][column] = x[(3U * WHEELED_PENDULUM_N * row) + (2U *
                    WHEELED_PENDULUM_N) + column];
            }
            if (HAS_BOTH[row]) {
                space->a[row][WHEELED_PENDULUM_N + row] = 1.0F;
            }
        }
    }
    return error;
}

float wheeled_pendulum_f32_rate_at(const wheeled_pendulum_f32_rate_t *rate, float v,
    const float q[WHEELED_PENDULUM_N], const float q_dot[WHEELED_PENDULUM_N], float psi)
{
    float by_coordinates = 0.0F;
    float by_rates = 0.0F;
    for (size_t i = 0U; i < WHEELED_PENDULUM_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void wheeled_pendulum_f32_kinematics(const wheeled_pendulum_f32_t *p, wheeled_pendulum_f32_kinematics_t *kinematics)
{
    const float t3 = 1.0F / p->r;
    const float t5 = t3 * p->b;
    const float t6 = -t3;
    const float t7 = -t5;
    kinematics->lateral.speed = 0.0F;
    kinematics->lateral.rates[0] = 0.0F;
    kinematics->lateral.rates[1] = 0.0F;
    kinematics->lateral.rates[2] = 0.0F;
    kinematics->lateral.coordinates[0] = 0.0F;
    kinematics->lateral.coordinates[1] = 0.0F;
    kinematics->lateral.coordinates[2] = 1.0F;
    kinematics->lateral.heading = 0.0F;
    kinematics->lean.speed = 0.0F;
    kinematics->lean.rates[0] = 0.0F;
    kinematics->lean.rates[1] = 0.0F;
    kinematics->lean.rates[2] = 0.0F;
    kinematics->lean.coordinates[0] = 0.0F;
    kinematics->lean.coordinates[1] = 0.0F;
    kinematics->lean.coordinates[2] = 0.0F;
    kinematics->lean.heading = 0.0F;
    kinematics->wheel_L.speed = t6;
    kinematics->wheel_L.rates[0] = t6;
    kinematics->wheel_L.rates[1] = 0.0F;
    kinematics->wheel_L.rates[2] = t7;
    kinematics->wheel_L.coordinates[0] = 0.0F;
    kinematics->wheel_L.coordinates[1] = 0.0F;
    kinematics->wheel_L.coordinates[2] = 0.0F;
    kinematics->wheel_L.heading = 0.0F;
    kinematics->wheel_R.speed = t6;
    kinematics->wheel_R.rates[0] = t6;
    kinematics->wheel_R.rates[1] = 0.0F;
    kinematics->wheel_R.rates[2] = t5;
    kinematics->wheel_R.coordinates[0] = 0.0F;
    kinematics->wheel_R.coordinates[1] = 0.0F;
    kinematics->wheel_R.coordinates[2] = 0.0F;
    kinematics->wheel_R.heading = 0.0F;
    kinematics->forces[0][0] = t6;
    kinematics->forces[0][1] = t6;
    kinematics->forces[1][0] = 0.0F;
    kinematics->forces[1][1] = 0.0F;
    kinematics->forces[2][0] = t7;
    kinematics->forces[2][1] = t5;
}

void wheeled_pendulum_f32_derivatives(const wheeled_pendulum_f32_t *p,
    wheeled_pendulum_f32_matrices_t *matrices, wheeled_pendulum_f32_derivatives_t *derivatives)
{
    const float t2 = p->mW + p->mW;
    const float m_all = p->m + t2;
    const float t5 = 1.0F / p->r;
    const float t7 = p->Ia + p->Ia;
    const float t8 = t5 * t7;
    const float t9 = t5 * t8;
    const float M_11 = m_all + t9;
    const float t11 = t2 * p->r;
    const float t13 = p->r + p->l;
    const float t14 = p->m * t13;
    const float t15 = t11 + t14;
    const float M_22 = t7 + p->Iyy + (p->r * t11) + (t13 * t14);
    const float t27 = p->b * p->b;
    const float t28 = t2 + t9;
    const float M_33 = p->Izz + p->Ir + p->Ir + (t27 * t28);
    const float K0_22 = (m_all * p->r) - t15;
    const float M_22_m = t13 * t13;
    const float K0_22_m = p->r - t13;
    const float M_22_l = t14 + t14;
    const float t40 = p->r + p->r;
    const float t41 = p->r * p->r;
    const float M_22_mW = t41 + t41;
    const float M_33_mW = t27 + t27;
    const float t44 = t5 * t5;
    const float M_11_Ia = t44 + t44;
    const float t46 = t5 + t5;
    const float M_33_Ia = t27 * M_11_Ia;
    const float t48 = t7 * t44;
    const float t49 = t46 * t48;
    const float M_12_r = t48 - m_all;
    const float M_22_r = t11 + t11 + M_22_l;
    const float t53 = t27 * t49;
    const float M_33_b = t28 * (p->b + p->b);
    const float M_12 = -(t8 + t15);
    matrices->m[0][0] = M_11;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = 0.0F;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = M_22;
    matrices->m[1][2] = 0.0F;
    matrices->m[2][0] = 0.0F;
    matrices->m[2][1] = 0.0F;
    matrices->m[2][2] = M_33;
    matrices->k0[0][0] = 0.0F;
    matrices->k0[0][1] = 0.0F;
    matrices->k0[0][2] = 0.0F;
    matrices->k0[1][0] = 0.0F;
    matrices->k0[1][1] = K0_22;
    matrices->k0[1][2] = 0.0F;
    matrices->k0[2][0] = 0.0F;
    matrices->k0[2][1] = 0.0F;
    matrices->k0[2][2] = 0.0F;
    derivatives->values[0] = 1.0F;
    derivatives->values[1] = t13;
    derivatives->values[2] = M_22_m;
    derivatives->values[3] = K0_22_m;
    derivatives->values[4] = p->m;
    derivatives->values[5] = M_22_l;
    derivatives->values[6] = 2.0F;
    derivatives->values[7] = t40;
    derivatives->values[8] = M_22_mW;
    derivatives->values[9] = M_33_mW;
    derivatives->values[10] = M_11_Ia;
    derivatives->values[11] = t46;
    derivatives->values[12] = M_33_Ia;
    derivatives->values[13] = t49;
    derivatives->values[14] = M_12_r;
    derivatives->values[15] = M_22_r;
    derivatives->values[16] = t53;
    derivatives->values[17] = M_33_b;
}

void wheeled_pendulum_f32_with_respect_to(const wheeled_pendulum_f32_derivatives_t *derivatives,
    size_t parameter, wheeled_pendulum_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < WHEELED_PENDULUM_N; row++) {
        for (size_t column = 0U; column < WHEELED_PENDULUM_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < WHEELED_PENDULUM_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &wheeled_pendulum_partials[position];
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
