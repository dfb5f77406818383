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

#include "carvallo_trig.h"

#include <float.h>
#include <math.h>

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

const char *wheeled_pendulum_position_name(wheeled_pendulum_position_t which)
{
    static const char *const TEXTS[] = {
        "x",
        "y",
        "psi",
        "phi",
        "theta",
        "thetaL",
        "thetaR",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such position";
}

const char *wheeled_pendulum_speed_name(wheeled_pendulum_speed_t which)
{
    static const char *const TEXTS[] = {
        "psi",
        "theta",
        "thetaL",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such speed";
}

const char *wheeled_pendulum_force_name(wheeled_pendulum_force_t which)
{
    static const char *const TEXTS[] = {
        "TL",
        "TR",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such force";
}

const char *wheeled_pendulum_wheel_name(wheeled_pendulum_wheel_t which)
{
    static const char *const TEXTS[] = {
        "L",
        "R",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such wheel";
}

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

void wheeled_pendulum_f64_motion(const wheeled_pendulum_f64_t *p,
    wheeled_pendulum_f64_motion_t *motion)
{
    const double t6 = p->b + p->b;
    const double t8 = p->r - p->r - p->l;
    const double t9 = p->m * t8;
    const double t11 = t8 * t9;
    const double t12 = p->Iyy + t11;
    const double t13 = p->b * p->m;
    const double t14 = t8 * t13;
    const double t16 = p->m + p->mW + p->mW;
    const double t17 = p->mW * t6;
    const double t18 = t13 + t17;
    const double t24 = p->Ir + p->Ir + (t6 * t17) + (p->b * t13);
    const double t25 = t11 + t24;
    const double t27 = t24 + p->Izz;
    const double t29 = t27 - t25;
    const double t30 = p->r * t16;
    const double t31 = p->r * t30;
    const double t32 = p->r * t18;
    const double t34 = p->Ia + p->Ia + t31;
    motion->constants[0] = p->b;
    motion->constants[1] = p->r;
    motion->constants[2] = p->m;
    motion->constants[3] = p->l;
    motion->constants[4] = p->Ia;
    motion->constants[5] = p->mW;
    motion->constants[6] = t6;
    motion->constants[7] = t9;
    motion->constants[8] = t12;
    motion->constants[9] = t14;
    motion->constants[10] = t16;
    motion->constants[11] = t18;
    motion->constants[12] = t25;
    motion->constants[13] = t27;
    motion->constants[14] = p->g;
    motion->constants[15] = t29;
    motion->constants[16] = t30;
    motion->constants[17] = t31;
    motion->constants[18] = t32;
    motion->constants[19] = t34;
}

static void wheeled_pendulum_f64_compute_rates(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], double rates[WHEELED_PENDULUM_POSITIONS])
{
    const double t4 = motion->constants[1] * (speeds[1] + speeds[2]);
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t14 = motion->constants[1] * sin_phi;
    const double t20 = (t14 + (cos_phi * motion->constants[6]) - t14) / motion->constants[1];
    const double t25 = speeds[2] + (speeds[0] * t20) + (speeds[1] * sin_phi * t20);
    const double t26 = -(t4 * cos_psi);
    const double t27 = -(t4 * sin_psi);
    rates[0] = t26;
    rates[1] = t27;
    rates[2] = speeds[0];
    rates[3] = 0.0;
    rates[4] = speeds[1];
    rates[5] = speeds[2];
    rates[6] = t25;
}

carvallo_motion_error_t wheeled_pendulum_f64_motion_rates(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], double rates[WHEELED_PENDULUM_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHEELED_PENDULUM_SPEEDS)) {
        wheeled_pendulum_f64_compute_rates(motion, positions, speeds, rates);
        error = (carvallo_are_finite_f64(rates, WHEELED_PENDULUM_POSITIONS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void wheeled_pendulum_f64_compute_derivatives(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    double rates[WHEELED_PENDULUM_POSITIONS], double speed_rates[WHEELED_PENDULUM_SPEEDS])
{
    const double t3 = speeds[1] + speeds[2];
    const double t4 = motion->constants[1] * t3;
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t14 = motion->constants[1] * sin_phi;
    const double t19 = t14 + (cos_phi * motion->constants[6]) - t14;
    const double t20 = 1.0 / motion->constants[1];
    const double t21 = t19 * t20;
    const double t23 = sin_phi * t21;
    const double t26 = speeds[2] + (speeds[0] * t21) + (speeds[1] * t23);
    double sin_theta = 0.0;
    double cos_theta = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_theta, &cos_theta);
    const double t30 = speeds[0] * sin_phi;
    const double t32 = motion->constants[1] * t30;
    const double t33 = (t3 + t30) * t32;
    const double t36 = t33 - (cos_phi * motion->constants[14]);
    const double t37 = sin_theta * t36;
    const double t40 = speeds[0] * cos_phi;
    const double t41 = sin_theta * t40;
    const double t42 = speeds[1] * t41;
    const double t43 = t3 * t40;
    const double t45 = t32 * t40;
    const double t47 = t40 * cos_theta;
    const double t48 = motion->constants[6] * t47;
    const double t50 = motion->constants[6] * t41;
    const double t52 = speeds[1] + t26;
    const double t58 = t45 + (motion->constants[1] * t40 * t52) - (motion->constants[1] * t43) -
        t45 - (t47 * t48);
    const double t62 = speeds[1] + t30;
    const double t64 = speeds[1] * t47;
    const double t67 = (t33 * cos_theta) + (t48 * t62) - (motion->constants[6] * t64);
    const double t73 = (motion->constants[6] * t42) - (sin_theta * t33) - (t50 * t62);
    const double t81 = ((sin_phi * (t58 - (t41 * t50))) + (cos_phi * ((cos_theta * t67) -
        (sin_theta * t73) - (t32 * (t30 + t52))))) / t19;
    const double t83 = t42 + (sin_theta * t81);
    const double t90 = t20 * motion->constants[4] * ((sin_theta * t67) + (cos_theta * t73));
    const double t92 = t41 * motion->constants[12];
    const double t97 = (t47 * motion->constants[13]) - (motion->constants[9] * t62);
    const double t100 = t36 * cos_theta;
    const double t104 = t64 + (cos_theta * t81);
    const double t106 = motion->constants[7] * t41;
    const double t125 = (sin_theta * ((motion->constants[10] * t100) - (motion->constants[11] *
        t104) - (t41 * t106) - (t62 * ((motion->constants[7] * t62) - (t47 *
        motion->constants[11]))))) + (cos_theta * ((t83 * motion->constants[11]) - (t37 *
        motion->constants[10]) - (t41 * t62 * motion->constants[11]) - (t47 * t106)));
    const double t126 = motion->constants[1] * t125;
    const double t131 = (motion->constants[9] * t83) + (t41 * t97) - (motion->constants[7] * t37) -
        t90 - (t47 * t92) - t126;
    const double t144 = (t62 * motion->constants[8]) + (motion->constants[4] * (speeds[2] + t62)) +
        (motion->constants[4] * (t26 + t62)) - (motion->constants[9] * t47);
    const double t162 = (t100 * motion->constants[11]) + (motion->constants[7] * (t45 + (sin_phi *
        motion->constants[14]) + (motion->constants[1] * (t43 + t81)))) + (t62 * t97);
    const double t166 = (cos_theta * ((t37 * motion->constants[11]) + (t62 * t92) - (t83 *
        motion->constants[13]) - (t41 * t144))) - (sin_theta * (t162 - (motion->constants[12] *
        t104) - (t47 * t144)));
    const double t169 = t90 + forces[1];
    const double t172 = (t21 * t169) - (sin_phi * t131) - (cos_phi * t166);
    const double t173 = motion->constants[7] * cos_theta;
    const double t174 = motion->constants[1] * t173;
    const double t178 = motion->constants[8] + motion->constants[17] - t174 - t174;
    const double t182 = motion->constants[18] - (motion->constants[9] * cos_theta);
    const double t184 = (sin_phi * t178) + (cos_phi * t182);
    const double t193 = cos_phi * ((sin_phi * t182) + (cos_phi * (motion->constants[13] -
        (sin_theta * sin_theta * motion->constants[15]))));
    const double t194 = sin_phi * motion->constants[4];
    const double t196 = sin_phi + t21;
    const double t197 = motion->constants[4] * t196;
    const double t201 = (sin_phi * t184) + t193 + (sin_phi * t194) + (t196 * t197);
    const double t202 = 1.0 / t201;
    const double t205 = t23 + 1.0;
    const double t209 = t202 * (t184 + t194 + (t197 * t205));
    const double t210 = motion->constants[4] * t205;
    const double t212 = t201 * t209;
    const double t216 = motion->constants[4] + t178 + (t205 * t210) - (t209 * t212);
    const double t217 = 1.0 / t216;
    const double t221 = (t23 * t169) - t131 - (t172 * t209);
    const double t225 = motion->constants[1] * (t173 - motion->constants[16]);
    const double t231 = t202 * (t194 + t197 + (cos_phi * motion->constants[18]) - (sin_phi * t225));
    const double t236 = t217 * (motion->constants[4] + t210 - t225 - (t212 * t231));
    const double t251 = (t126 + t169 + forces[0] - (t172 * t231) - (t221 * t236)) /
        (motion->constants[19] - (t201 * t231 * t231) - (t216 * t236 * t236));
    const double t253 = (t217 * t221) - (t236 * t251);
    const double t257 = (t172 * t202) - (t209 * t253) - (t231 * t251);
    const double t258 = -(t4 * cos_psi);
    const double t259 = -(t4 * sin_psi);
    rates[0] = t258;
    rates[1] = t259;
    rates[2] = speeds[0];
    rates[3] = 0.0;
    rates[4] = speeds[1];
    rates[5] = speeds[2];
    rates[6] = t26;
    speed_rates[0] = t257;
    speed_rates[1] = t253;
    speed_rates[2] = t251;
}

carvallo_motion_error_t wheeled_pendulum_f64_motion_derivatives(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    double rates[WHEELED_PENDULUM_POSITIONS], double speed_rates[WHEELED_PENDULUM_SPEEDS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHEELED_PENDULUM_SPEEDS) && carvallo_are_finite_f64(forces,
        WHEELED_PENDULUM_FORCES)) {
        wheeled_pendulum_f64_compute_derivatives(motion, positions, speeds, forces, rates,
            speed_rates);
        error = (carvallo_are_finite_f64(rates, WHEELED_PENDULUM_POSITIONS) &&
            carvallo_are_finite_f64(speed_rates, WHEELED_PENDULUM_SPEEDS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void wheeled_pendulum_f64_compute_accelerations(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    double accelerations[WHEELED_PENDULUM_POSITIONS])
{
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    double sin_theta = 0.0;
    double cos_theta = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_theta, &cos_theta);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t11 = speeds[0] * sin_phi;
    const double t14 = speeds[1] + speeds[2];
    const double t16 = motion->constants[1] * t11;
    const double t17 = (t11 + t14) * t16;
    const double t21 = t17 - (cos_phi * motion->constants[14]);
    const double t22 = cos_theta * t21;
    const double t25 = speeds[0] * cos_phi;
    const double t26 = cos_theta * t25;
    const double t27 = speeds[1] * t26;
    const double t28 = t14 * t25;
    const double t30 = t16 * t25;
    const double t32 = t26 * motion->constants[6];
    const double t34 = sin_theta * t25;
    const double t35 = motion->constants[6] * t34;
    const double t37 = motion->constants[1] * sin_phi;
    const double t40 = t37 + (cos_phi * motion->constants[6]) - t37;
    const double t41 = 1.0 / motion->constants[1];
    const double t42 = t40 * t41;
    const double t44 = sin_phi * t42;
    const double t47 = speeds[2] + (speeds[0] * t42) + (speeds[1] * t44);
    const double t48 = speeds[1] + t47;
    const double t54 = t30 + (motion->constants[1] * t25 * t48) - (motion->constants[1] * t28) -
        t30 - (t26 * t32);
    const double t58 = t11 + speeds[1];
    const double t62 = (cos_theta * t17) + (t32 * t58) - (t27 * motion->constants[6]);
    const double t66 = speeds[1] * t34;
    const double t69 = (motion->constants[6] * t66) - (sin_theta * t17) - (t35 * t58);
    const double t77 = ((sin_phi * (t54 - (t34 * t35))) + (cos_phi * ((cos_theta * t62) -
        (sin_theta * t69) - (t16 * (t11 + t48))))) / t40;
    const double t79 = t27 + (cos_theta * t77);
    const double t82 = t34 * motion->constants[7];
    const double t92 = sin_theta * t21;
    const double t95 = t66 + (sin_theta * t77);
    const double t104 = (sin_theta * ((motion->constants[10] * t22) - (motion->constants[11] *
        t79) - (t34 * t82) - (t58 * ((t58 * motion->constants[7]) - (motion->constants[11] *
        t26))))) + (cos_theta * ((motion->constants[11] * t95) - (motion->constants[10] * t92) -
        (motion->constants[11] * t34 * t58) - (t26 * t82)));
    const double t105 = motion->constants[1] * t104;
    const double t111 = t41 * ((sin_theta * t62) + (cos_theta * t69));
    const double t112 = motion->constants[4] * t111;
    const double t113 = forces[1] + t112;
    const double t118 = t34 * motion->constants[12];
    const double t123 = (t26 * motion->constants[13]) - (t58 * motion->constants[9]);
    const double t129 = (t95 * motion->constants[9]) + (t34 * t123) - t105 - t112 -
        (motion->constants[7] * t92) - (t26 * t118);
    const double t142 = (t58 * motion->constants[8]) + (motion->constants[4] * (speeds[2] + t58)) +
        (motion->constants[4] * (t47 + t58)) - (t26 * motion->constants[9]);
    const double t160 = (t22 * motion->constants[11]) + (motion->constants[7] * (t30 + (sin_phi *
        motion->constants[14]) + (motion->constants[1] * (t28 + t77)))) + (t58 * t123);
    const double t164 = (cos_theta * ((motion->constants[11] * t92) + (t58 * t118) - (t95 *
        motion->constants[13]) - (t34 * t142))) - (sin_theta * (t160 - (t79 *
        motion->constants[12]) - (t26 * t142)));
    const double t168 = (t42 * t113) - (sin_phi * t129) - (cos_phi * t164);
    const double t169 = sin_phi * motion->constants[4];
    const double t170 = cos_theta * motion->constants[7];
    const double t173 = motion->constants[1] * (t170 - motion->constants[16]);
    const double t177 = sin_phi + t42;
    const double t178 = motion->constants[4] * t177;
    const double t182 = motion->constants[1] * t170;
    const double t186 = motion->constants[8] + motion->constants[17] - t182 - t182;
    const double t189 = motion->constants[18] - (cos_theta * motion->constants[9]);
    const double t191 = (sin_phi * t186) + (cos_phi * t189);
    const double t200 = cos_phi * ((sin_phi * t189) + (cos_phi * (motion->constants[13] -
        (sin_theta * sin_theta * motion->constants[15]))));
    const double t205 = (sin_phi * t191) + t200 + (sin_phi * t169) + (t177 * t178);
    const double t206 = 1.0 / t205;
    const double t207 = (t169 + (cos_phi * motion->constants[18]) + t178 - (sin_phi * t173)) * t206;
    const double t210 = t44 + 1.0;
    const double t211 = motion->constants[4] * t210;
    const double t215 = t206 * (t169 + t191 + (t178 * t210));
    const double t216 = t205 * t215;
    const double t225 = motion->constants[4] + t186 + (t210 * t211) - (t215 * t216);
    const double t226 = 1.0 / t225;
    const double t227 = (motion->constants[4] + t211 - t173 - (t207 * t216)) * t226;
    const double t231 = (t44 * t113) - t129 - (t168 * t215);
    const double t244 = (forces[0] + t105 + t113 - (t168 * t207) - (t227 * t231)) /
        (motion->constants[19] - (t205 * t207 * t207) - (t225 * t227 * t227));
    const double t247 = (t226 * t231) - (t227 * t244);
    const double t249 = motion->constants[1] * (t244 + t247);
    const double t253 = motion->constants[1] * speeds[0] * t14;
    const double t255 = (sin_psi * t253) - (cos_psi * t249);
    const double t263 = (t168 * t206) - (t215 * t247) - (t207 * t244);
    const double t268 = t244 + (t42 * t263) + (t44 * t247) - t111;
    const double t269 = -((t249 * sin_psi) + (cos_psi * t253));
    const double t270 = -t77;
    accelerations[0] = t255;
    accelerations[1] = t269;
    accelerations[2] = t263;
    accelerations[3] = t270;
    accelerations[4] = t247;
    accelerations[5] = t244;
    accelerations[6] = t268;
}

carvallo_motion_error_t wheeled_pendulum_f64_motion_accelerations(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    double accelerations[WHEELED_PENDULUM_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHEELED_PENDULUM_SPEEDS) && carvallo_are_finite_f64(forces,
        WHEELED_PENDULUM_FORCES)) {
        wheeled_pendulum_f64_compute_accelerations(motion, positions, speeds, forces,
            accelerations);
        error = (carvallo_are_finite_f64(accelerations, WHEELED_PENDULUM_POSITIONS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void wheeled_pendulum_f64_compute_energy(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], double energy[2])
{
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    double sin_theta = 0.0;
    double cos_theta = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_theta, &cos_theta);
    const double t8 = cos_theta * motion->constants[7];
    const double t9 = motion->constants[1] * t8;
    const double t13 = motion->constants[8] + motion->constants[17] - t9 - t9;
    const double t19 = motion->constants[18] - (cos_theta * motion->constants[9]);
    const double t21 = (sin_phi * t13) + (cos_phi * t19);
    const double t32 = cos_phi * ((sin_phi * t19) + (cos_phi * (motion->constants[13] - (sin_theta *
        sin_theta * motion->constants[15]))));
    const double t34 = sin_phi * motion->constants[4];
    const double t36 = sin_phi * motion->constants[1];
    const double t41 = (t36 + (cos_phi * motion->constants[6]) - t36) / motion->constants[1];
    const double t42 = sin_phi + t41;
    const double t43 = motion->constants[4] * t42;
    const double t52 = 1.0 + (sin_phi * t41);
    const double t55 = t21 + t34 + (t43 * t52);
    const double t59 = t8 - motion->constants[16];
    const double t60 = motion->constants[1] * t59;
    const double t65 = t34 + t43 + (cos_phi * motion->constants[18]) - (sin_phi * t60);
    const double t67 = (speeds[0] * ((sin_phi * t21) + t32 + (sin_phi * t34) + (t42 * t43))) +
        (speeds[1] * t55);
    const double t71 = motion->constants[4] * t52;
    const double t77 = motion->constants[4] + t71 - t60;
    const double t81 = speeds[1] * ((speeds[0] * t55) + (speeds[1] * (t13 + motion->constants[4] +
        (t52 * t71))) + (speeds[2] * t77));
    const double t92 = ((speeds[0] * (t67 + (speeds[2] * t65))) + t81 + (speeds[2] * ((speeds[0] *
        t65) + (speeds[1] * t77) + (speeds[2] * motion->constants[19])))) * 0.5;
    const double t99 = -(motion->constants[14] * ((sin_phi * motion->constants[11]) + (cos_phi *
        t59)));
    energy[0] = t92;
    energy[1] = t99;
}

carvallo_motion_error_t wheeled_pendulum_f64_motion_energy(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], double energy[2])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHEELED_PENDULUM_SPEEDS)) {
        wheeled_pendulum_f64_compute_energy(motion, positions, speeds, energy);
        error = (carvallo_are_finite_f64(energy, 2U)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

/* How far the lowest points of the wheels behind the first are below the ground, and the steps of Newton's method. */
static void wheeled_pendulum_f64_compute_closure(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS], double below[1U], double steps[1U])
{
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t3 = motion->constants[1] * cos_phi;
    const double t8 = t3 + (sin_phi * motion->constants[6]) - t3;
    const double t9 = motion->constants[1] * sin_phi;
    const double t14 = -(t8 / (t9 + (cos_phi * motion->constants[6]) - t9));
    below[0] = t8;
    steps[0] = t14;
}

carvallo_motion_error_t wheeled_pendulum_f64_motion_close(const wheeled_pendulum_f64_motion_t *motion,
    double positions[WHEELED_PENDULUM_POSITIONS])
{
    /* The positions that the heights of the wheels determine. */
    static const size_t DEPENDENT[1U] = {3U};
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHEELED_PENDULUM_POSITIONS)) {
        double found[WHEELED_PENDULUM_POSITIONS];
        double below[1U];
        double steps[1U];
        double shortest = 1e30;
        bool is_closed = false;
        bool goes_on = true;
        for (size_t i = 0U; i < WHEELED_PENDULUM_POSITIONS; i++) {
            found[i] = positions[i];
        }
        /* With steps of the greatest length they lead around the whole circle; near a solution a handful is enough. */
        for (size_t count = 0U; goes_on && (count < 60U); count++) {
            wheeled_pendulum_f64_compute_closure(motion, found, below, steps);
            if (carvallo_are_finite_f64(steps, 1U)) {
                double longest = 0.0;
                double size = 1.0;
                double share = 1.0;
                for (size_t i = 0U; i < 1U; i++) {
                    longest = (fabs(steps[i]) > longest) ? fabs(steps[i]) : longest;
                }
                /* No step is longer than this, in rad or m: it keeps to the solution that is near. */
                if (longest > 0.25) {
                    share = 0.25 / longest;
                }
                for (size_t i = 0U; i < 1U; i++) {
                    found[DEPENDENT[i]] += steps[i] * share;
                }
                for (size_t i = 0U; i < 1U; i++) {
                    const double value = fabs(found[DEPENDENT[i]]);
                    size = (value > size) ? value : size;
                }
                /* Near the solution steps shrink to rounding, and then no further. */
                is_closed = (longest <= (4.0 * DBL_EPSILON * size)) || ((longest < 1e-5) &&
                    (longest >= shortest));
                goes_on = !is_closed;
                shortest = longest;
            } else {
                goes_on = false;
            }
        }
        if (is_closed) {
            error = CARVALLO_MOTION_OK;
            for (size_t i = 0U; i < 1U; i++) {
                positions[DEPENDENT[i]] = found[DEPENDENT[i]];
            }
        } else {
            double most = 0.0;
            bool is_finite = false;
            wheeled_pendulum_f64_compute_closure(motion, found, below, steps);
            is_finite = carvallo_is_finite_f64(below[0]);
            for (size_t i = 0U; i < 1U; i++) {
                if (carvallo_is_finite_f64(below[i]) && (fabs(below[i]) > most)) {
                    most = fabs(below[i]);
                    is_finite = true;
                }
            }
            error = is_finite ? CARVALLO_MOTION_NOT_CLOSED : CARVALLO_MOTION_SINGULAR;
        }
    }
    return error;
}

static void wheeled_pendulum_f64_compute_contact_forces(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    double contact_forces[3U * WHEELED_PENDULUM_WHEELS])
{
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    double sin_theta = 0.0;
    double cos_theta = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_theta, &cos_theta);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t7 = speeds[0] * cos_phi;
    const double t8 = sin_theta * t7;
    const double t10 = t8 * motion->constants[7];
    const double t14 = speeds[0] * sin_phi;
    const double t15 = speeds[1] + t14;
    const double t18 = t7 * cos_theta;
    const double t21 = (motion->constants[7] * t15) - (t18 * motion->constants[11]);
    const double t23 = (t8 * t10) + (t15 * t21);
    const double t26 = speeds[1] + speeds[2];
    const double t29 = t14 * motion->constants[1];
    const double t30 = (t14 + t26) * t29;
    const double t33 = t30 - (cos_phi * motion->constants[14]);
    const double t34 = cos_theta * t33;
    const double t37 = speeds[1] * t18;
    const double t38 = t7 * t26;
    const double t40 = t7 * t29;
    const double t42 = t18 * motion->constants[6];
    const double t44 = t8 * motion->constants[6];
    const double t46 = sin_phi * motion->constants[1];
    const double t49 = t46 + (cos_phi * motion->constants[6]) - t46;
    const double t50 = 1.0 / motion->constants[1];
    const double t51 = t49 * t50;
    const double t53 = sin_phi * t51;
    const double t56 = speeds[2] + (speeds[0] * t51) + (speeds[1] * t53);
    const double t57 = speeds[1] + t56;
    const double t63 = t40 + (t7 * motion->constants[1] * t57) - (motion->constants[1] * t38) -
        t40 - (t18 * t42);
    const double t70 = (cos_theta * t30) + (t15 * t42) - (t37 * motion->constants[6]);
    const double t74 = t8 * speeds[1];
    const double t77 = (motion->constants[6] * t74) - (sin_theta * t30) - (t15 * t44);
    const double t85 = 1.0 / t49;
    const double t86 = ((sin_phi * (t63 - (t8 * t44))) + (cos_phi * ((cos_theta * t70) -
        (sin_theta * t77) - (t29 * (t14 + t57))))) * t85;
    const double t88 = t37 + (cos_theta * t86);
    const double t93 = sin_theta * t33;
    const double t96 = t74 + (sin_theta * t86);
    const double t98 = t8 * motion->constants[11];
    const double t101 = (t15 * t98) + (t10 * t18);
    const double t106 = motion->constants[1] * ((sin_theta * ((motion->constants[10] * t34) - t23 -
        (motion->constants[11] * t88))) + (cos_theta * ((motion->constants[11] * t96) -
        (motion->constants[10] * t93) - t101)));
    const double t112 = t50 * ((sin_theta * t70) + (cos_theta * t77));
    const double t113 = motion->constants[4] * t112;
    const double t114 = forces[1] + t113;
    const double t119 = t8 * motion->constants[12];
    const double t124 = (t18 * motion->constants[13]) - (t15 * motion->constants[9]);
    const double t130 = (t96 * motion->constants[9]) + (t8 * t124) - t106 - t113 -
        (motion->constants[7] * t93) - (t18 * t119);
    const double t143 = (t15 * motion->constants[8]) + (motion->constants[4] * (t15 + speeds[2])) +
        (motion->constants[4] * (t15 + t56)) - (t18 * motion->constants[9]);
    const double t146 = (t15 * t119) - (t8 * t143);
    const double t156 = t40 + (sin_phi * motion->constants[14]) + (motion->constants[1] * (t38 +
        t86));
    const double t161 = (motion->constants[7] * t156) + (t15 * t124) - (t18 * t143);
    const double t166 = cos_phi * ((cos_theta * ((motion->constants[11] * t93) + t146 - (t96 *
        motion->constants[13]))) - (sin_theta * ((motion->constants[11] * t34) + t161 - (t88 *
        motion->constants[12]))));
    const double t169 = (t51 * t114) - (sin_phi * t130) - t166;
    const double t170 = sin_phi * motion->constants[4];
    const double t171 = motion->constants[7] * cos_theta;
    const double t174 = motion->constants[1] * (t171 - motion->constants[16]);
    const double t178 = sin_phi + t51;
    const double t179 = motion->constants[4] * t178;
    const double t183 = motion->constants[1] * t171;
    const double t187 = motion->constants[8] + motion->constants[17] - t183 - t183;
    const double t190 = motion->constants[18] - (cos_theta * motion->constants[9]);
    const double t192 = (sin_phi * t187) + (cos_phi * t190);
    const double t201 = cos_phi * ((sin_phi * t190) + (cos_phi * (motion->constants[13] -
        (sin_theta * sin_theta * motion->constants[15]))));
    const double t206 = (sin_phi * t192) + t201 + (sin_phi * t170) + (t178 * t179);
    const double t207 = 1.0 / t206;
    const double t208 = (t170 + (cos_phi * motion->constants[18]) + t179 - (sin_phi * t174)) * t207;
    const double t211 = t53 + 1.0;
    const double t212 = motion->constants[4] * t211;
    const double t216 = t207 * (t170 + t192 + (t179 * t211));
    const double t217 = t206 * t216;
    const double t226 = motion->constants[4] + t187 + (t211 * t212) - (t216 * t217);
    const double t227 = 1.0 / t226;
    const double t228 = (motion->constants[4] + t212 - t174 - (t208 * t217)) * t227;
    const double t232 = (t53 * t114) - t130 - (t169 * t216);
    const double t245 = (forces[0] + t106 + t114 - (t169 * t208) - (t228 * t232)) /
        (motion->constants[19] - (t206 * t208 * t208) - (t226 * t228 * t228));
    const double t248 = (t227 * t232) - (t228 * t245);
    const double t253 = (t169 * t207) - (t216 * t248) - (t208 * t245);
    const double t255 = t248 + (sin_phi * t253);
    const double t256 = t245 + t255;
    const double t257 = motion->constants[1] * t256;
    const double t259 = t34 - (sin_theta * t257);
    const double t261 = cos_phi * t253;
    const double t263 = t88 + (sin_theta * t261);
    const double t266 = (motion->constants[10] * t259) - t23 - (motion->constants[11] * t263);
    const double t269 = t93 + (cos_theta * t257);
    const double t273 = (cos_theta * t261) - t96;
    const double t277 = (motion->constants[7] * t255) - t101 - (motion->constants[10] * t269) -
        (motion->constants[11] * t273);
    const double t285 = (motion->constants[4] * ((t51 * t253) + (t53 * t248) + t256 - t112)) -
        forces[1];
    const double t286 = t50 * t285;
    const double t288 = (sin_theta * t266) + (cos_theta * t277) - t286;
    const double t297 = (t18 * t21) + (motion->constants[7] * t263) - (motion->constants[10] *
        t156) - (t8 * t98);
    const double t301 = (cos_theta * t266) - (sin_theta * t277);
    const double t303 = (cos_phi * t297) - (sin_phi * t301);
    const double t305 = (cos_psi * t288) - (sin_psi * t303);
    const double t308 = (t288 * sin_psi) + (cos_psi * t303);
    const double t322 = (sin_theta * (t146 + (motion->constants[11] * t269) +
        (motion->constants[13] * t273) - (motion->constants[9] * t255))) + (cos_theta * (t161 +
        (motion->constants[11] * t259) - (motion->constants[12] * t263)));
    const double t324 = t85 * (t322 + (motion->constants[1] * t297));
    const double t328 = (sin_phi * t297) + (cos_phi * t301) - t324;
    const double t329 = cos_psi * t286;
    const double t330 = t286 * sin_psi;
    contact_forces[0] = t305;
    contact_forces[1] = t308;
    contact_forces[2] = t328;
    contact_forces[3] = t329;
    contact_forces[4] = t330;
    contact_forces[5] = t324;
}

carvallo_motion_error_t wheeled_pendulum_f64_motion_contact_forces(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    double contact_forces[3U * WHEELED_PENDULUM_WHEELS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHEELED_PENDULUM_SPEEDS) && carvallo_are_finite_f64(forces,
        WHEELED_PENDULUM_FORCES)) {
        wheeled_pendulum_f64_compute_contact_forces(motion, positions, speeds, forces,
            contact_forces);
        error = (carvallo_are_finite_f64(contact_forces, 3U * WHEELED_PENDULUM_WHEELS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
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

void wheeled_pendulum_f32_motion(const wheeled_pendulum_f32_t *p,
    wheeled_pendulum_f32_motion_t *motion)
{
    const float t6 = p->b + p->b;
    const float t8 = p->r - p->r - p->l;
    const float t9 = p->m * t8;
    const float t11 = t8 * t9;
    const float t12 = p->Iyy + t11;
    const float t13 = p->b * p->m;
    const float t14 = t8 * t13;
    const float t16 = p->m + p->mW + p->mW;
    const float t17 = p->mW * t6;
    const float t18 = t13 + t17;
    const float t24 = p->Ir + p->Ir + (t6 * t17) + (p->b * t13);
    const float t25 = t11 + t24;
    const float t27 = t24 + p->Izz;
    const float t29 = t27 - t25;
    const float t30 = p->r * t16;
    const float t31 = p->r * t30;
    const float t32 = p->r * t18;
    const float t34 = p->Ia + p->Ia + t31;
    motion->constants[0] = p->b;
    motion->constants[1] = p->r;
    motion->constants[2] = p->m;
    motion->constants[3] = p->l;
    motion->constants[4] = p->Ia;
    motion->constants[5] = p->mW;
    motion->constants[6] = t6;
    motion->constants[7] = t9;
    motion->constants[8] = t12;
    motion->constants[9] = t14;
    motion->constants[10] = t16;
    motion->constants[11] = t18;
    motion->constants[12] = t25;
    motion->constants[13] = t27;
    motion->constants[14] = p->g;
    motion->constants[15] = t29;
    motion->constants[16] = t30;
    motion->constants[17] = t31;
    motion->constants[18] = t32;
    motion->constants[19] = t34;
}

static void wheeled_pendulum_f32_compute_rates(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    float rates[WHEELED_PENDULUM_POSITIONS])
{
    const float t4 = motion->constants[1] * (speeds[1] + speeds[2]);
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t14 = motion->constants[1] * sin_phi;
    const float t20 = (t14 + (cos_phi * motion->constants[6]) - t14) / motion->constants[1];
    const float t25 = speeds[2] + (speeds[0] * t20) + (speeds[1] * sin_phi * t20);
    const float t26 = -(t4 * cos_psi);
    const float t27 = -(t4 * sin_psi);
    rates[0] = t26;
    rates[1] = t27;
    rates[2] = speeds[0];
    rates[3] = 0.0F;
    rates[4] = speeds[1];
    rates[5] = speeds[2];
    rates[6] = t25;
}

carvallo_motion_error_t wheeled_pendulum_f32_motion_rates(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    float rates[WHEELED_PENDULUM_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHEELED_PENDULUM_SPEEDS)) {
        wheeled_pendulum_f32_compute_rates(motion, positions, speeds, rates);
        error = (carvallo_are_finite_f32(rates, WHEELED_PENDULUM_POSITIONS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void wheeled_pendulum_f32_compute_derivatives(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES], float rates[WHEELED_PENDULUM_POSITIONS],
    float speed_rates[WHEELED_PENDULUM_SPEEDS])
{
    const float t3 = speeds[1] + speeds[2];
    const float t4 = motion->constants[1] * t3;
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t14 = motion->constants[1] * sin_phi;
    const float t19 = t14 + (cos_phi * motion->constants[6]) - t14;
    const float t20 = 1.0F / motion->constants[1];
    const float t21 = t19 * t20;
    const float t23 = sin_phi * t21;
    const float t26 = speeds[2] + (speeds[0] * t21) + (speeds[1] * t23);
    float sin_theta = 0.0F;
    float cos_theta = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_theta, &cos_theta);
    const float t30 = speeds[0] * sin_phi;
    const float t32 = motion->constants[1] * t30;
    const float t33 = (t3 + t30) * t32;
    const float t36 = t33 - (cos_phi * motion->constants[14]);
    const float t37 = sin_theta * t36;
    const float t40 = speeds[0] * cos_phi;
    const float t41 = sin_theta * t40;
    const float t42 = speeds[1] * t41;
    const float t43 = t3 * t40;
    const float t45 = t32 * t40;
    const float t47 = t40 * cos_theta;
    const float t48 = motion->constants[6] * t47;
    const float t50 = motion->constants[6] * t41;
    const float t52 = speeds[1] + t26;
    const float t58 = t45 + (motion->constants[1] * t40 * t52) - (motion->constants[1] * t43) -
        t45 - (t47 * t48);
    const float t62 = speeds[1] + t30;
    const float t64 = speeds[1] * t47;
    const float t67 = (t33 * cos_theta) + (t48 * t62) - (motion->constants[6] * t64);
    const float t73 = (motion->constants[6] * t42) - (sin_theta * t33) - (t50 * t62);
    const float t81 = ((sin_phi * (t58 - (t41 * t50))) + (cos_phi * ((cos_theta * t67) -
        (sin_theta * t73) - (t32 * (t30 + t52))))) / t19;
    const float t83 = t42 + (sin_theta * t81);
    const float t90 = t20 * motion->constants[4] * ((sin_theta * t67) + (cos_theta * t73));
    const float t92 = t41 * motion->constants[12];
    const float t97 = (t47 * motion->constants[13]) - (motion->constants[9] * t62);
    const float t100 = t36 * cos_theta;
    const float t104 = t64 + (cos_theta * t81);
    const float t106 = motion->constants[7] * t41;
    const float t125 = (sin_theta * ((motion->constants[10] * t100) - (motion->constants[11] *
        t104) - (t41 * t106) - (t62 * ((motion->constants[7] * t62) - (t47 *
        motion->constants[11]))))) + (cos_theta * ((t83 * motion->constants[11]) - (t37 *
        motion->constants[10]) - (t41 * t62 * motion->constants[11]) - (t47 * t106)));
    const float t126 = motion->constants[1] * t125;
    const float t131 = (motion->constants[9] * t83) + (t41 * t97) - (motion->constants[7] * t37) -
        t90 - (t47 * t92) - t126;
    const float t144 = (t62 * motion->constants[8]) + (motion->constants[4] * (speeds[2] + t62)) +
        (motion->constants[4] * (t26 + t62)) - (motion->constants[9] * t47);
    const float t162 = (t100 * motion->constants[11]) + (motion->constants[7] * (t45 + (sin_phi *
        motion->constants[14]) + (motion->constants[1] * (t43 + t81)))) + (t62 * t97);
    const float t166 = (cos_theta * ((t37 * motion->constants[11]) + (t62 * t92) - (t83 *
        motion->constants[13]) - (t41 * t144))) - (sin_theta * (t162 - (motion->constants[12] *
        t104) - (t47 * t144)));
    const float t169 = t90 + forces[1];
    const float t172 = (t21 * t169) - (sin_phi * t131) - (cos_phi * t166);
    const float t173 = motion->constants[7] * cos_theta;
    const float t174 = motion->constants[1] * t173;
    const float t178 = motion->constants[8] + motion->constants[17] - t174 - t174;
    const float t182 = motion->constants[18] - (motion->constants[9] * cos_theta);
    const float t184 = (sin_phi * t178) + (cos_phi * t182);
    const float t193 = cos_phi * ((sin_phi * t182) + (cos_phi * (motion->constants[13] -
        (sin_theta * sin_theta * motion->constants[15]))));
    const float t194 = sin_phi * motion->constants[4];
    const float t196 = sin_phi + t21;
    const float t197 = motion->constants[4] * t196;
    const float t201 = (sin_phi * t184) + t193 + (sin_phi * t194) + (t196 * t197);
    const float t202 = 1.0F / t201;
    const float t205 = t23 + 1.0F;
    const float t209 = t202 * (t184 + t194 + (t197 * t205));
    const float t210 = motion->constants[4] * t205;
    const float t212 = t201 * t209;
    const float t216 = motion->constants[4] + t178 + (t205 * t210) - (t209 * t212);
    const float t217 = 1.0F / t216;
    const float t221 = (t23 * t169) - t131 - (t172 * t209);
    const float t225 = motion->constants[1] * (t173 - motion->constants[16]);
    const float t231 = t202 * (t194 + t197 + (cos_phi * motion->constants[18]) - (sin_phi * t225));
    const float t236 = t217 * (motion->constants[4] + t210 - t225 - (t212 * t231));
    const float t251 = (t126 + t169 + forces[0] - (t172 * t231) - (t221 * t236)) /
        (motion->constants[19] - (t201 * t231 * t231) - (t216 * t236 * t236));
    const float t253 = (t217 * t221) - (t236 * t251);
    const float t257 = (t172 * t202) - (t209 * t253) - (t231 * t251);
    const float t258 = -(t4 * cos_psi);
    const float t259 = -(t4 * sin_psi);
    rates[0] = t258;
    rates[1] = t259;
    rates[2] = speeds[0];
    rates[3] = 0.0F;
    rates[4] = speeds[1];
    rates[5] = speeds[2];
    rates[6] = t26;
    speed_rates[0] = t257;
    speed_rates[1] = t253;
    speed_rates[2] = t251;
}

carvallo_motion_error_t wheeled_pendulum_f32_motion_derivatives(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES], float rates[WHEELED_PENDULUM_POSITIONS],
    float speed_rates[WHEELED_PENDULUM_SPEEDS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHEELED_PENDULUM_SPEEDS) && carvallo_are_finite_f32(forces,
        WHEELED_PENDULUM_FORCES)) {
        wheeled_pendulum_f32_compute_derivatives(motion, positions, speeds, forces, rates,
            speed_rates);
        error = (carvallo_are_finite_f32(rates, WHEELED_PENDULUM_POSITIONS) &&
            carvallo_are_finite_f32(speed_rates, WHEELED_PENDULUM_SPEEDS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void wheeled_pendulum_f32_compute_accelerations(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES], float accelerations[WHEELED_PENDULUM_POSITIONS])
{
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    float sin_theta = 0.0F;
    float cos_theta = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_theta, &cos_theta);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t11 = speeds[0] * sin_phi;
    const float t14 = speeds[1] + speeds[2];
    const float t16 = motion->constants[1] * t11;
    const float t17 = (t11 + t14) * t16;
    const float t21 = t17 - (cos_phi * motion->constants[14]);
    const float t22 = cos_theta * t21;
    const float t25 = speeds[0] * cos_phi;
    const float t26 = cos_theta * t25;
    const float t27 = speeds[1] * t26;
    const float t28 = t14 * t25;
    const float t30 = t16 * t25;
    const float t32 = t26 * motion->constants[6];
    const float t34 = sin_theta * t25;
    const float t35 = motion->constants[6] * t34;
    const float t37 = motion->constants[1] * sin_phi;
    const float t40 = t37 + (cos_phi * motion->constants[6]) - t37;
    const float t41 = 1.0F / motion->constants[1];
    const float t42 = t40 * t41;
    const float t44 = sin_phi * t42;
    const float t47 = speeds[2] + (speeds[0] * t42) + (speeds[1] * t44);
    const float t48 = speeds[1] + t47;
    const float t54 = t30 + (motion->constants[1] * t25 * t48) - (motion->constants[1] * t28) -
        t30 - (t26 * t32);
    const float t58 = t11 + speeds[1];
    const float t62 = (cos_theta * t17) + (t32 * t58) - (t27 * motion->constants[6]);
    const float t66 = speeds[1] * t34;
    const float t69 = (motion->constants[6] * t66) - (sin_theta * t17) - (t35 * t58);
    const float t77 = ((sin_phi * (t54 - (t34 * t35))) + (cos_phi * ((cos_theta * t62) -
        (sin_theta * t69) - (t16 * (t11 + t48))))) / t40;
    const float t79 = t27 + (cos_theta * t77);
    const float t82 = t34 * motion->constants[7];
    const float t92 = sin_theta * t21;
    const float t95 = t66 + (sin_theta * t77);
    const float t104 = (sin_theta * ((motion->constants[10] * t22) - (motion->constants[11] * t79) -
        (t34 * t82) - (t58 * ((t58 * motion->constants[7]) - (motion->constants[11] * t26))))) +
        (cos_theta * ((motion->constants[11] * t95) - (motion->constants[10] * t92) -
        (motion->constants[11] * t34 * t58) - (t26 * t82)));
    const float t105 = motion->constants[1] * t104;
    const float t111 = t41 * ((sin_theta * t62) + (cos_theta * t69));
    const float t112 = motion->constants[4] * t111;
    const float t113 = forces[1] + t112;
    const float t118 = t34 * motion->constants[12];
    const float t123 = (t26 * motion->constants[13]) - (t58 * motion->constants[9]);
    const float t129 = (t95 * motion->constants[9]) + (t34 * t123) - t105 - t112 -
        (motion->constants[7] * t92) - (t26 * t118);
    const float t142 = (t58 * motion->constants[8]) + (motion->constants[4] * (speeds[2] + t58)) +
        (motion->constants[4] * (t47 + t58)) - (t26 * motion->constants[9]);
    const float t160 = (t22 * motion->constants[11]) + (motion->constants[7] * (t30 + (sin_phi *
        motion->constants[14]) + (motion->constants[1] * (t28 + t77)))) + (t58 * t123);
    const float t164 = (cos_theta * ((motion->constants[11] * t92) + (t58 * t118) - (t95 *
        motion->constants[13]) - (t34 * t142))) - (sin_theta * (t160 - (t79 *
        motion->constants[12]) - (t26 * t142)));
    const float t168 = (t42 * t113) - (sin_phi * t129) - (cos_phi * t164);
    const float t169 = sin_phi * motion->constants[4];
    const float t170 = cos_theta * motion->constants[7];
    const float t173 = motion->constants[1] * (t170 - motion->constants[16]);
    const float t177 = sin_phi + t42;
    const float t178 = motion->constants[4] * t177;
    const float t182 = motion->constants[1] * t170;
    const float t186 = motion->constants[8] + motion->constants[17] - t182 - t182;
    const float t189 = motion->constants[18] - (cos_theta * motion->constants[9]);
    const float t191 = (sin_phi * t186) + (cos_phi * t189);
    const float t200 = cos_phi * ((sin_phi * t189) + (cos_phi * (motion->constants[13] -
        (sin_theta * sin_theta * motion->constants[15]))));
    const float t205 = (sin_phi * t191) + t200 + (sin_phi * t169) + (t177 * t178);
    const float t206 = 1.0F / t205;
    const float t207 = (t169 + (cos_phi * motion->constants[18]) + t178 - (sin_phi * t173)) * t206;
    const float t210 = t44 + 1.0F;
    const float t211 = motion->constants[4] * t210;
    const float t215 = t206 * (t169 + t191 + (t178 * t210));
    const float t216 = t205 * t215;
    const float t225 = motion->constants[4] + t186 + (t210 * t211) - (t215 * t216);
    const float t226 = 1.0F / t225;
    const float t227 = (motion->constants[4] + t211 - t173 - (t207 * t216)) * t226;
    const float t231 = (t44 * t113) - t129 - (t168 * t215);
    const float t244 = (forces[0] + t105 + t113 - (t168 * t207) - (t227 * t231)) /
        (motion->constants[19] - (t205 * t207 * t207) - (t225 * t227 * t227));
    const float t247 = (t226 * t231) - (t227 * t244);
    const float t249 = motion->constants[1] * (t244 + t247);
    const float t253 = motion->constants[1] * speeds[0] * t14;
    const float t255 = (sin_psi * t253) - (cos_psi * t249);
    const float t263 = (t168 * t206) - (t215 * t247) - (t207 * t244);
    const float t268 = t244 + (t42 * t263) + (t44 * t247) - t111;
    const float t269 = -((t249 * sin_psi) + (cos_psi * t253));
    const float t270 = -t77;
    accelerations[0] = t255;
    accelerations[1] = t269;
    accelerations[2] = t263;
    accelerations[3] = t270;
    accelerations[4] = t247;
    accelerations[5] = t244;
    accelerations[6] = t268;
}

carvallo_motion_error_t wheeled_pendulum_f32_motion_accelerations(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES], float accelerations[WHEELED_PENDULUM_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHEELED_PENDULUM_SPEEDS) && carvallo_are_finite_f32(forces,
        WHEELED_PENDULUM_FORCES)) {
        wheeled_pendulum_f32_compute_accelerations(motion, positions, speeds, forces,
            accelerations);
        error = (carvallo_are_finite_f32(accelerations, WHEELED_PENDULUM_POSITIONS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void wheeled_pendulum_f32_compute_energy(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    float energy[2])
{
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    float sin_theta = 0.0F;
    float cos_theta = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_theta, &cos_theta);
    const float t8 = cos_theta * motion->constants[7];
    const float t9 = motion->constants[1] * t8;
    const float t13 = motion->constants[8] + motion->constants[17] - t9 - t9;
    const float t19 = motion->constants[18] - (cos_theta * motion->constants[9]);
    const float t21 = (sin_phi * t13) + (cos_phi * t19);
    const float t32 = cos_phi * ((sin_phi * t19) + (cos_phi * (motion->constants[13] - (sin_theta *
        sin_theta * motion->constants[15]))));
    const float t34 = sin_phi * motion->constants[4];
    const float t36 = sin_phi * motion->constants[1];
    const float t41 = (t36 + (cos_phi * motion->constants[6]) - t36) / motion->constants[1];
    const float t42 = sin_phi + t41;
    const float t43 = motion->constants[4] * t42;
    const float t52 = 1.0F + (sin_phi * t41);
    const float t55 = t21 + t34 + (t43 * t52);
    const float t59 = t8 - motion->constants[16];
    const float t60 = motion->constants[1] * t59;
    const float t65 = t34 + t43 + (cos_phi * motion->constants[18]) - (sin_phi * t60);
    const float t67 = (speeds[0] * ((sin_phi * t21) + t32 + (sin_phi * t34) + (t42 * t43))) +
        (speeds[1] * t55);
    const float t71 = motion->constants[4] * t52;
    const float t77 = motion->constants[4] + t71 - t60;
    const float t81 = speeds[1] * ((speeds[0] * t55) + (speeds[1] * (t13 + motion->constants[4] +
        (t52 * t71))) + (speeds[2] * t77));
    const float t92 = ((speeds[0] * (t67 + (speeds[2] * t65))) + t81 + (speeds[2] * ((speeds[0] *
        t65) + (speeds[1] * t77) + (speeds[2] * motion->constants[19])))) * 0.5F;
    const float t99 = -(motion->constants[14] * ((sin_phi * motion->constants[11]) + (cos_phi *
        t59)));
    energy[0] = t92;
    energy[1] = t99;
}

carvallo_motion_error_t wheeled_pendulum_f32_motion_energy(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    float energy[2])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHEELED_PENDULUM_SPEEDS)) {
        wheeled_pendulum_f32_compute_energy(motion, positions, speeds, energy);
        error = (carvallo_are_finite_f32(energy, 2U)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

/* How far the lowest points of the wheels behind the first are below the ground, and the steps of Newton's method. */
static void wheeled_pendulum_f32_compute_closure(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], float below[1U], float steps[1U])
{
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t3 = motion->constants[1] * cos_phi;
    const float t8 = t3 + (sin_phi * motion->constants[6]) - t3;
    const float t9 = motion->constants[1] * sin_phi;
    const float t14 = -(t8 / (t9 + (cos_phi * motion->constants[6]) - t9));
    below[0] = t8;
    steps[0] = t14;
}

carvallo_motion_error_t wheeled_pendulum_f32_motion_close(const wheeled_pendulum_f32_motion_t *motion,
    float positions[WHEELED_PENDULUM_POSITIONS])
{
    /* The positions that the heights of the wheels determine. */
    static const size_t DEPENDENT[1U] = {3U};
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHEELED_PENDULUM_POSITIONS)) {
        float found[WHEELED_PENDULUM_POSITIONS];
        float below[1U];
        float steps[1U];
        float shortest = 1e30F;
        bool is_closed = false;
        bool goes_on = true;
        for (size_t i = 0U; i < WHEELED_PENDULUM_POSITIONS; i++) {
            found[i] = positions[i];
        }
        /* With steps of the greatest length they lead around the whole circle; near a solution a handful is enough. */
        for (size_t count = 0U; goes_on && (count < 60U); count++) {
            wheeled_pendulum_f32_compute_closure(motion, found, below, steps);
            if (carvallo_are_finite_f32(steps, 1U)) {
                float longest = 0.0F;
                float size = 1.0F;
                float share = 1.0F;
                for (size_t i = 0U; i < 1U; i++) {
                    longest = (fabsf(steps[i]) > longest) ? fabsf(steps[i]) : longest;
                }
                /* No step is longer than this, in rad or m: it keeps to the solution that is near. */
                if (longest > 0.25F) {
                    share = 0.25F / longest;
                }
                for (size_t i = 0U; i < 1U; i++) {
                    found[DEPENDENT[i]] += steps[i] * share;
                }
                for (size_t i = 0U; i < 1U; i++) {
                    const float value = fabsf(found[DEPENDENT[i]]);
                    size = (value > size) ? value : size;
                }
                /* Near the solution steps shrink to rounding, and then no further. */
                is_closed = (longest <= (4.0F * FLT_EPSILON * size)) || ((longest < 1e-5F) &&
                    (longest >= shortest));
                goes_on = !is_closed;
                shortest = longest;
            } else {
                goes_on = false;
            }
        }
        if (is_closed) {
            error = CARVALLO_MOTION_OK;
            for (size_t i = 0U; i < 1U; i++) {
                positions[DEPENDENT[i]] = found[DEPENDENT[i]];
            }
        } else {
            float most = 0.0F;
            bool is_finite = false;
            wheeled_pendulum_f32_compute_closure(motion, found, below, steps);
            is_finite = carvallo_is_finite_f32(below[0]);
            for (size_t i = 0U; i < 1U; i++) {
                if (carvallo_is_finite_f32(below[i]) && (fabsf(below[i]) > most)) {
                    most = fabsf(below[i]);
                    is_finite = true;
                }
            }
            error = is_finite ? CARVALLO_MOTION_NOT_CLOSED : CARVALLO_MOTION_SINGULAR;
        }
    }
    return error;
}

static void wheeled_pendulum_f32_compute_contact_forces(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES], float contact_forces[3U * WHEELED_PENDULUM_WHEELS])
{
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    float sin_theta = 0.0F;
    float cos_theta = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_theta, &cos_theta);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t7 = speeds[0] * cos_phi;
    const float t8 = sin_theta * t7;
    const float t10 = t8 * motion->constants[7];
    const float t14 = speeds[0] * sin_phi;
    const float t15 = speeds[1] + t14;
    const float t18 = t7 * cos_theta;
    const float t21 = (motion->constants[7] * t15) - (t18 * motion->constants[11]);
    const float t23 = (t8 * t10) + (t15 * t21);
    const float t26 = speeds[1] + speeds[2];
    const float t29 = t14 * motion->constants[1];
    const float t30 = (t14 + t26) * t29;
    const float t33 = t30 - (cos_phi * motion->constants[14]);
    const float t34 = cos_theta * t33;
    const float t37 = speeds[1] * t18;
    const float t38 = t7 * t26;
    const float t40 = t7 * t29;
    const float t42 = t18 * motion->constants[6];
    const float t44 = t8 * motion->constants[6];
    const float t46 = sin_phi * motion->constants[1];
    const float t49 = t46 + (cos_phi * motion->constants[6]) - t46;
    const float t50 = 1.0F / motion->constants[1];
    const float t51 = t49 * t50;
    const float t53 = sin_phi * t51;
    const float t56 = speeds[2] + (speeds[0] * t51) + (speeds[1] * t53);
    const float t57 = speeds[1] + t56;
    const float t63 = t40 + (t7 * motion->constants[1] * t57) - (motion->constants[1] * t38) - t40 -
        (t18 * t42);
    const float t70 = (cos_theta * t30) + (t15 * t42) - (t37 * motion->constants[6]);
    const float t74 = t8 * speeds[1];
    const float t77 = (motion->constants[6] * t74) - (sin_theta * t30) - (t15 * t44);
    const float t85 = 1.0F / t49;
    const float t86 = ((sin_phi * (t63 - (t8 * t44))) + (cos_phi * ((cos_theta * t70) - (sin_theta *
        t77) - (t29 * (t14 + t57))))) * t85;
    const float t88 = t37 + (cos_theta * t86);
    const float t93 = sin_theta * t33;
    const float t96 = t74 + (sin_theta * t86);
    const float t98 = t8 * motion->constants[11];
    const float t101 = (t15 * t98) + (t10 * t18);
    const float t106 = motion->constants[1] * ((sin_theta * ((motion->constants[10] * t34) - t23 -
        (motion->constants[11] * t88))) + (cos_theta * ((motion->constants[11] * t96) -
        (motion->constants[10] * t93) - t101)));
    const float t112 = t50 * ((sin_theta * t70) + (cos_theta * t77));
    const float t113 = motion->constants[4] * t112;
    const float t114 = forces[1] + t113;
    const float t119 = t8 * motion->constants[12];
    const float t124 = (t18 * motion->constants[13]) - (t15 * motion->constants[9]);
    const float t130 = (t96 * motion->constants[9]) + (t8 * t124) - t106 - t113 -
        (motion->constants[7] * t93) - (t18 * t119);
    const float t143 = (t15 * motion->constants[8]) + (motion->constants[4] * (t15 + speeds[2])) +
        (motion->constants[4] * (t15 + t56)) - (t18 * motion->constants[9]);
    const float t146 = (t15 * t119) - (t8 * t143);
    const float t156 = t40 + (sin_phi * motion->constants[14]) + (motion->constants[1] * (t38 +
        t86));
    const float t161 = (motion->constants[7] * t156) + (t15 * t124) - (t18 * t143);
    const float t166 = cos_phi * ((cos_theta * ((motion->constants[11] * t93) + t146 - (t96 *
        motion->constants[13]))) - (sin_theta * ((motion->constants[11] * t34) + t161 - (t88 *
        motion->constants[12]))));
    const float t169 = (t51 * t114) - (sin_phi * t130) - t166;
    const float t170 = sin_phi * motion->constants[4];
    const float t171 = motion->constants[7] * cos_theta;
    const float t174 = motion->constants[1] * (t171 - motion->constants[16]);
    const float t178 = sin_phi + t51;
    const float t179 = motion->constants[4] * t178;
    const float t183 = motion->constants[1] * t171;
    const float t187 = motion->constants[8] + motion->constants[17] - t183 - t183;
    const float t190 = motion->constants[18] - (cos_theta * motion->constants[9]);
    const float t192 = (sin_phi * t187) + (cos_phi * t190);
    const float t201 = cos_phi * ((sin_phi * t190) + (cos_phi * (motion->constants[13] -
        (sin_theta * sin_theta * motion->constants[15]))));
    const float t206 = (sin_phi * t192) + t201 + (sin_phi * t170) + (t178 * t179);
    const float t207 = 1.0F / t206;
    const float t208 = (t170 + (cos_phi * motion->constants[18]) + t179 - (sin_phi * t174)) * t207;
    const float t211 = t53 + 1.0F;
    const float t212 = motion->constants[4] * t211;
    const float t216 = t207 * (t170 + t192 + (t179 * t211));
    const float t217 = t206 * t216;
    const float t226 = motion->constants[4] + t187 + (t211 * t212) - (t216 * t217);
    const float t227 = 1.0F / t226;
    const float t228 = (motion->constants[4] + t212 - t174 - (t208 * t217)) * t227;
    const float t232 = (t53 * t114) - t130 - (t169 * t216);
    const float t245 = (forces[0] + t106 + t114 - (t169 * t208) - (t228 * t232)) /
        (motion->constants[19] - (t206 * t208 * t208) - (t226 * t228 * t228));
    const float t248 = (t227 * t232) - (t228 * t245);
    const float t253 = (t169 * t207) - (t216 * t248) - (t208 * t245);
    const float t255 = t248 + (sin_phi * t253);
    const float t256 = t245 + t255;
    const float t257 = motion->constants[1] * t256;
    const float t259 = t34 - (sin_theta * t257);
    const float t261 = cos_phi * t253;
    const float t263 = t88 + (sin_theta * t261);
    const float t266 = (motion->constants[10] * t259) - t23 - (motion->constants[11] * t263);
    const float t269 = t93 + (cos_theta * t257);
    const float t273 = (cos_theta * t261) - t96;
    const float t277 = (motion->constants[7] * t255) - t101 - (motion->constants[10] * t269) -
        (motion->constants[11] * t273);
    const float t285 = (motion->constants[4] * ((t51 * t253) + (t53 * t248) + t256 - t112)) -
        forces[1];
    const float t286 = t50 * t285;
    const float t288 = (sin_theta * t266) + (cos_theta * t277) - t286;
    const float t297 = (t18 * t21) + (motion->constants[7] * t263) - (motion->constants[10] *
        t156) - (t8 * t98);
    const float t301 = (cos_theta * t266) - (sin_theta * t277);
    const float t303 = (cos_phi * t297) - (sin_phi * t301);
    const float t305 = (cos_psi * t288) - (sin_psi * t303);
    const float t308 = (t288 * sin_psi) + (cos_psi * t303);
    const float t322 = (sin_theta * (t146 + (motion->constants[11] * t269) +
        (motion->constants[13] * t273) - (motion->constants[9] * t255))) + (cos_theta * (t161 +
        (motion->constants[11] * t259) - (motion->constants[12] * t263)));
    const float t324 = t85 * (t322 + (motion->constants[1] * t297));
    const float t328 = (sin_phi * t297) + (cos_phi * t301) - t324;
    const float t329 = cos_psi * t286;
    const float t330 = t286 * sin_psi;
    contact_forces[0] = t305;
    contact_forces[1] = t308;
    contact_forces[2] = t328;
    contact_forces[3] = t329;
    contact_forces[4] = t330;
    contact_forces[5] = t324;
}

carvallo_motion_error_t wheeled_pendulum_f32_motion_contact_forces(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES], float contact_forces[3U * WHEELED_PENDULUM_WHEELS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHEELED_PENDULUM_SPEEDS) && carvallo_are_finite_f32(forces,
        WHEELED_PENDULUM_FORCES)) {
        wheeled_pendulum_f32_compute_contact_forces(motion, positions, speeds, forces,
            contact_forces);
        error = (carvallo_are_finite_f32(contact_forces, 3U * WHEELED_PENDULUM_WHEELS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}
