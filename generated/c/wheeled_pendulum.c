/* @generated from generated/models/wheeled_pendulum.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: b992785cfa4d8bcd
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
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 2U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 0U, 5U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 0U, 5U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 6U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 0U, 1U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 1U, 0U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 1U, 0U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 7U, false},
    {CARVALLO_MATRIX_K0, 1U, 1U, 1U, 0U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 2U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 3U, 2U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 4U, 3U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 4U, 8U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 4U, 8U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 4U, 9U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 4U, 10U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 11U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 5U, 4U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 5U, 4U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 5U, 3U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 5U, 13U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 6U, 3U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 7U, 14U, true},
    {CARVALLO_MATRIX_M, 0U, 1U, 7U, 15U, false},
    {CARVALLO_MATRIX_M, 1U, 0U, 7U, 15U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 7U, 12U, false},
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
    const double t4 = 1.0 / p->r;
    const double t6 = p->Ia + p->Ia;
    const double t7 = t4 * t6;
    const double t9 = t2 + (t4 * t7);
    const double M_11 = p->m + t9;
    const double t11 = t2 * p->r;
    const double t13 = p->r + p->l;
    const double t14 = p->m * t13;
    const double m_all = t6 + (t13 * t14);
    const double M_22 = (p->r * t11) + (m_all + p->Iyy);
    const double M_33 = p->Izz + ((p->b * t9 * p->b) + p->Ir) + p->Ir;
    const double M_12 = -(t11 + (t7 + t14));
    const double K0_22 = -(p->m * p->l);
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
    const double t12 = p->mW + p->mW;
    const double t13 = 1.0 / p->r;
    const double t14 = p->m * p->l;
    const double t15 = p->m + t12;
    const double t17 = t14 + (p->r * t15);
    const double t18 = t13 + t13;
    const double K0_22 = -t14;
    const double t20 = p->r + p->l;
    const double M_22_m = t20 * t20;
    const double t22 = p->m * t20;
    const double M_22_l = t22 + t22;
    const double t24 = p->r + p->r;
    const double M_22_mW = p->r * t24;
    const double t26 = p->b * p->b;
    const double M_33_mW = t26 + t26;
    const double M_11_Ia = t13 * t18;
    const double t29 = p->Ia * t18;
    const double M_22 = p->Ia + p->Ia + (t14 * t20) + (p->r * t17) + p->Iyy;
    const double M_22_r = t17 + t17;
    const double t37 = p->Ia * M_11_Ia;
    const double M_12 = -(t17 + t29);
    const double M_33_Ia = M_11_Ia * t26;
    const double t41 = M_11_Ia * t29;
    const double t42 = t12 + t37;
    const double M_12_r = t37 - t15;
    const double t44 = t26 * t41;
    const double M_11 = p->m + t42;
    const double t46 = t42 * p->b;
    const double M_33 = p->Ir + p->Ir + (p->b * t46) + p->Izz;
    const double M_33_b = t46 + t46;
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
    derivatives->values[0] = p->m;
    derivatives->values[1] = p->l;
    derivatives->values[2] = 1.0;
    derivatives->values[3] = 2.0;
    derivatives->values[4] = t18;
    derivatives->values[5] = t20;
    derivatives->values[6] = M_22_m;
    derivatives->values[7] = M_22_l;
    derivatives->values[8] = t24;
    derivatives->values[9] = M_22_mW;
    derivatives->values[10] = M_33_mW;
    derivatives->values[11] = M_11_Ia;
    derivatives->values[12] = M_22_r;
    derivatives->values[13] = M_33_Ia;
    derivatives->values[14] = t41;
    derivatives->values[15] = M_12_r;
    derivatives->values[16] = t44;
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

static void wheeled_pendulum_f64_compute_linearization(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    wheeled_pendulum_f64_linearization_t *linearization)
{
    const double t4 = speeds[1] + speeds[2];
    const double t5 = motion->constants[1] * t4;
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t8 = t5 * sin_psi;
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t16 = motion->constants[1] * sin_phi;
    const double t21 = t16 + (cos_phi * motion->constants[6]) - t16;
    const double t22 = 1.0 / motion->constants[1];
    const double t23 = t21 * t22;
    const double t24 = sin_phi * t23;
    double sin_theta = 0.0;
    double cos_theta = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_theta, &cos_theta);
    const double t29 = cos_theta * motion->constants[7];
    const double t30 = motion->constants[1] * t29;
    const double t34 = motion->constants[8] + motion->constants[17] - t30 - t30;
    const double t39 = motion->constants[18] - (cos_theta * motion->constants[9]);
    const double t41 = (sin_phi * t34) + (cos_phi * t39);
    const double t52 = cos_phi * ((sin_phi * t39) + (cos_phi * (motion->constants[13] - (sin_theta *
        sin_theta * motion->constants[15]))));
    const double t54 = sin_phi * motion->constants[4];
    const double t56 = sin_phi + t23;
    const double t57 = motion->constants[4] * t56;
    const double t61 = (sin_phi * t41) + t52 + (sin_phi * t54) + (t56 * t57);
    const double t62 = 1.0 / t61;
    const double t64 = sin_phi * speeds[0];
    const double t65 = motion->constants[1] * t64;
    const double t66 = cos_phi * speeds[0];
    const double t67 = t65 * t66;
    const double t70 = t4 * t66;
    const double t72 = cos_theta * t66;
    const double t73 = motion->constants[6] * t72;
    const double t75 = sin_theta * t66;
    const double t76 = motion->constants[6] * t75;
    const double t81 = speeds[2] + (t23 * speeds[0]) + (speeds[1] * t24);
    const double t82 = speeds[1] + t81;
    const double t88 = t67 + (motion->constants[1] * t66 * t82) - (motion->constants[1] * t70) -
        t67 - (t72 * t73);
    const double t91 = t4 + t64;
    const double t92 = t91 * t65;
    const double t93 = cos_theta * t92;
    const double t94 = speeds[1] + t64;
    const double t96 = speeds[1] * t72;
    const double t99 = t93 + (t73 * t94) - (motion->constants[6] * t96);
    const double t101 = sin_theta * t92;
    const double t103 = speeds[1] * t75;
    const double t106 = (motion->constants[6] * t103) - t101 - (t76 * t94);
    const double t108 = (cos_theta * t99) - (sin_theta * t106);
    const double t109 = t64 + t82;
    const double t114 = 1.0 / t21;
    const double t115 = ((sin_phi * (t88 - (t75 * t76))) + (cos_phi * (t108 - (t65 * t109)))) *
        t114;
    const double t121 = motion->constants[9] * t94;
    const double t123 = (motion->constants[13] * t72) - t121;
    const double t133 = (motion->constants[8] * t94) + (motion->constants[4] * (speeds[2] + t94)) +
        (motion->constants[4] * (t81 + t94)) - (motion->constants[9] * t72);
    const double t136 = (motion->constants[7] * (t67 + (sin_phi * motion->constants[14]) +
        (motion->constants[1] * (t70 + t115)))) + (t94 * t123) - (t72 * t133);
    const double t139 = t92 - (cos_phi * motion->constants[14]);
    const double t140 = cos_theta * t139;
    const double t145 = t96 + (cos_theta * t115);
    const double t147 = motion->constants[7] * t75;
    const double t149 = motion->constants[7] * t94;
    const double t151 = t149 - (motion->constants[11] * t72);
    const double t153 = (t75 * t147) + (t94 * t151);
    const double t157 = sin_theta * t139;
    const double t159 = sin_theta * t115;
    const double t160 = t103 + t159;
    const double t162 = motion->constants[11] * t75;
    const double t165 = (t94 * t162) + (t72 * t147);
    const double t170 = motion->constants[1] * ((sin_theta * ((t140 * motion->constants[10]) -
        (motion->constants[11] * t145) - t153)) + (cos_theta * ((motion->constants[11] * t160) -
        (motion->constants[10] * t157) - t165)));
    const double t175 = t22 * motion->constants[4];
    const double t176 = ((sin_theta * t99) + (cos_theta * t106)) * t175;
    const double t177 = forces[1] + t176;
    const double t181 = t75 * motion->constants[12];
    const double t188 = (motion->constants[9] * t160) + (t75 * t123) - t170 - t176 -
        (motion->constants[7] * t157) - (t72 * t181);
    const double t194 = (t94 * t181) - (t75 * t133);
    const double t204 = cos_phi * ((cos_theta * ((motion->constants[11] * t157) + t194 -
        (motion->constants[13] * t160))) - (sin_theta * ((motion->constants[11] * t140) + t136 -
        (t145 * motion->constants[12]))));
    const double t207 = (t23 * t177) - (sin_phi * t188) - t204;
    const double t210 = motion->constants[1] * (t29 - motion->constants[16]);
    const double t216 = t62 * (t54 + t57 + (cos_phi * motion->constants[18]) - (sin_phi * t210));
    const double t218 = 1.0 + t24;
    const double t219 = motion->constants[4] * t218;
    const double t223 = t62 * (t41 + t54 + (t57 * t218));
    const double t224 = t61 * t223;
    const double t233 = t34 + motion->constants[4] + (t218 * t219) - (t223 * t224);
    const double t234 = 1.0 / t233;
    const double t235 = (motion->constants[4] + t219 - t210 - (t216 * t224)) * t234;
    const double t239 = (t24 * t177) - t188 - (t207 * t223);
    const double t252 = 1.0 / (motion->constants[19] - (t61 * t216 * t216) - (t233 * t235 * t235));
    const double t253 = (forces[0] + t170 + t177 - (t207 * t216) - (t235 * t239)) * t252;
    const double t256 = (t234 * t239) - (t235 * t253);
    const double t261 = (t62 * t207) - (t223 * t256) - (t216 * t253);
    const double t263 = t256 + (sin_phi * t261);
    const double t265 = motion->constants[1] * (t253 + t263);
    const double t267 = t140 - (sin_theta * t265);
    const double t269 = cos_phi * t261;
    const double t271 = t145 + (sin_theta * t269);
    const double t273 = sin_theta * motion->constants[11];
    const double t280 = t157 + (cos_theta * t265);
    const double t284 = (cos_theta * t269) - t159;
    const double t285 = t284 - t103;
    const double t292 = sin_theta * (t194 + (motion->constants[11] * t280) +
        (motion->constants[13] * t285) - (motion->constants[9] * t263) - (t139 * t273));
    const double t293 = cos_theta * motion->constants[11];
    const double t295 = sin_theta * motion->constants[12];
    const double t302 = (sin_theta * t72) - (cos_theta * t75);
    const double t306 = (speeds[1] * t295) - (sin_theta * ((motion->constants[13] * t94) - t133)) -
        (motion->constants[9] * t302);
    const double t308 = (cos_theta * ((motion->constants[12] * t271) + (t265 * t273) - t136 -
        (motion->constants[11] * t267))) + (t267 * t293);
    const double t315 = cos_phi * cos_theta;
    const double t316 = ((t94 * motion->constants[12]) - t133) * t315;
    const double t318 = t23 * t175;
    const double t322 = (motion->constants[6] * t94) - (speeds[1] * motion->constants[6]);
    const double t324 = t101 + (t75 * t322);
    const double t326 = cos_theta * t322;
    const double t330 = t108 - (cos_theta * t93) - (sin_theta * t324) - (t72 * t326);
    const double t334 = (motion->constants[13] * t75) - t181;
    const double t337 = t123 - (t72 * motion->constants[12]);
    const double t342 = sin_theta * motion->constants[10];
    const double t356 = sin_theta * ((motion->constants[7] * t263) + (t139 * t342) - t165 -
        (motion->constants[10] * t280) - (motion->constants[11] * t285));
    const double t357 = cos_theta * motion->constants[10];
    const double t361 = motion->constants[11] * t94;
    const double t365 = (sin_theta * t361) - (cos_theta * t147) - (speeds[1] * t273);
    const double t372 = (cos_theta * (t361 + (motion->constants[7] * t72))) + (sin_theta * (t147 +
        t147));
    const double t374 = (cos_theta * ((motion->constants[10] * t267) - t153 -
        (motion->constants[11] * t271) - (t265 * t342))) - t356;
    const double t379 = motion->constants[1] * (t374 - (t267 * t357) - (t273 * t284) - (t75 *
        t365) - (t72 * t372));
    const double t380 = (t175 * t330) + t379;
    const double t383 = (t72 * t337) - (motion->constants[7] * t267) - (t75 * t334) - t380;
    const double t386 = motion->constants[1] * t293;
    const double t387 = t386 - motion->constants[9];
    const double t389 = (motion->constants[13] * t315) + (sin_phi * t387);
    const double t392 = cos_phi * sin_theta;
    const double t395 = sin_phi * (t73 + t73);
    const double t402 = (sin_phi * (t76 + t76)) - (t322 * t392);
    const double t408 = (t75 * t395) + (t93 * t392) - (t106 * t315) - (t99 * t392) - (t315 * t324) -
        (t72 * t402);
    const double t409 = motion->constants[1] * motion->constants[7];
    const double t410 = sin_theta * t114;
    const double t412 = cos_theta * t114;
    const double t417 = motion->constants[1] * t273 * t412;
    const double t421 = (t389 * t410) - (cos_phi * ((t295 * t412) - (t409 * t410))) - (sin_phi *
        t417);
    const double t425 = (t318 * t330) + (t271 * t389) + (t408 * t421) - (cos_phi * (t308 + (t284 *
        t295) - t292 - (t75 * t306)));
    const double t427 = t425 - (t72 * t316) - (sin_phi * t383);
    const double t429 = t24 * t175;
    const double t433 = (t387 * t410) - t417;
    const double t439 = (t330 * t429) + (t271 * t387) + (t408 * t433) - t383 - (t223 * t427);
    const double t443 = (t386 * t410) - t417;
    const double t451 = t252 * (t380 + (t271 * t386) + (t408 * t443) - (t216 * t427) - (t235 *
        t439));
    const double t453 = (t234 * t439) - (t235 * t451);
    const double t457 = (t62 * t427) - (t223 * t453) - (t216 * t451);
    const double t458 = t16 * t66;
    const double t474 = (cos_theta * t181) + (t302 * (motion->constants[8] + motion->constants[4] +
        motion->constants[4])) - (sin_theta * (t123 - t121));
    const double t478 = sin_phi * (t65 + (motion->constants[1] * t91));
    const double t481 = (sin_theta * t293) - (cos_theta * t273);
    const double t485 = (t306 * t315) + (sin_phi * t474) + (t478 * t481) - (sin_theta *
        ((motion->constants[7] * t458) + (cos_phi * ((t4 * t409) + (motion->constants[7] * t65)))));
    const double t490 = (t315 * t322) + (sin_phi * t73);
    const double t492 = sin_phi * t76;
    const double t496 = (sin_theta * t490) - (cos_theta * t492) - (t326 * t392);
    const double t499 = motion->constants[9] * t75;
    const double t501 = motion->constants[7] * sin_theta;
    const double t509 = (cos_theta * t162) + (sin_theta * (t149 + t151));
    const double t513 = (cos_theta * t342) - (sin_theta * t357);
    const double t520 = (t175 * t496) + (motion->constants[1] * ((t315 * t365) + (t478 * t513) -
        (sin_phi * t509) - (t372 * t392)));
    const double t524 = (t315 * t334) + (t337 * t392) - (sin_phi * t499) - (t478 * t501) - t520;
    const double t526 = speeds[1] * t392;
    const double t541 = (cos_theta * t315) + (sin_theta * t392);
    const double t546 = (cos_phi * ((t16 * t82) - (t5 * sin_phi))) + (t315 * t490) + (t392 * t492) +
        (t478 * t541);
    const double t549 = t546 - (sin_phi * cos_phi * (t65 + (motion->constants[1] * t109))) - (t315 *
        t395) - (t392 * t402);
    const double t552 = cos_phi * motion->constants[4] * t302;
    const double t554 = t458 - (cos_phi * t65);
    const double t556 = (t421 * t554) - t552;
    const double t562 = (t318 * t496) + (t389 * t526) + (t421 * t549) + (t23 * t556) - (cos_phi *
        t485) - (t316 * t392);
    const double t563 = t562 - (sin_phi * t524);
    const double t568 = t433 * t554;
    const double t575 = (t429 * t496) + (t387 * t526) + (t433 * t549) + (t23 * t568) - t524 -
        (t223 * t563);
    const double t579 = t443 * t554;
    const double t587 = t520 + (t386 * t526) + (t443 * t549) + (t23 * t579) - (t216 * t563) -
        (t235 * t575);
    const double t588 = t252 * t587;
    const double t590 = (t234 * t575) - (t235 * t588);
    const double t594 = (t62 * t563) - (t223 * t590) - (t216 * t588);
    const double t601 = cos_phi * ((t65 * t481) - (t75 * t409));
    const double t602 = t65 * t501;
    const double t604 = t65 * t513;
    const double t607 = motion->constants[1] * (t604 - t509 - (t72 * t273));
    const double t609 = t499 + t602 + t607;
    const double t613 = (t65 * t541) - t458;
    const double t614 = t554 + t613;
    const double t621 = (sin_phi * t609) + (t75 * t389) + (t421 * t614) + (t24 * t556) - (cos_phi *
        (t474 + (t72 * t295))) - t601;
    const double t630 = t609 + (t75 * t387) + (t433 * t614) + (t24 * t568) - (t223 * t621);
    const double t641 = t607 + (t75 * t386) + (t443 * t614) + (t24 * t579) - (t216 * t621) - (t235 *
        t630);
    const double t642 = t252 * t641;
    const double t644 = (t234 * t630) - (t235 * t642);
    const double t648 = (t62 * t621) - (t223 * t644) - (t216 * t642);
    const double t649 = motion->constants[1] * t604;
    const double t650 = t602 + t649;
    const double t656 = t556 + (sin_phi * t650) + (t421 * t613) - t552 - t601;
    const double t662 = t568 + t650 + (t433 * t613) - (t223 * t656);
    const double t671 = t252 * (t579 + t649 + (t443 * t613) - (t216 * t656) - (t235 * t662));
    const double t673 = (t234 * t662) - (t235 * t671);
    const double t677 = (t62 * t656) - (t223 * t673) - (t216 * t671);
    const double t678 = t235 * t252;
    const double t681 = (t223 * t678) - (t216 * t252);
    const double t684 = t24 - (t23 * t223);
    const double t690 = t252 * (1.0 - (t23 * t216) - (t235 * t684));
    const double t692 = (t234 * t684) - (t235 * t690);
    const double t696 = (t23 * t62) - (t223 * t692) - (t216 * t690);
    const double t697 = -(motion->constants[1] * cos_psi);
    const double t698 = -(t5 * cos_psi);
    const double t699 = -(motion->constants[1] * sin_psi);
    const double t700 = -t678;
    linearization->a[0][0] = 0.0;
    linearization->a[0][1] = 0.0;
    linearization->a[0][2] = t8;
    linearization->a[0][3] = 0.0;
    linearization->a[0][4] = 0.0;
    linearization->a[0][5] = 0.0;
    linearization->a[0][6] = 0.0;
    linearization->a[0][7] = 0.0;
    linearization->a[0][8] = t697;
    linearization->a[0][9] = t697;
    linearization->b[0][0] = 0.0;
    linearization->b[0][1] = 0.0;
    linearization->a[1][0] = 0.0;
    linearization->a[1][1] = 0.0;
    linearization->a[1][2] = t698;
    linearization->a[1][3] = 0.0;
    linearization->a[1][4] = 0.0;
    linearization->a[1][5] = 0.0;
    linearization->a[1][6] = 0.0;
    linearization->a[1][7] = 0.0;
    linearization->a[1][8] = t699;
    linearization->a[1][9] = t699;
    linearization->b[1][0] = 0.0;
    linearization->b[1][1] = 0.0;
    linearization->a[2][0] = 0.0;
    linearization->a[2][1] = 0.0;
    linearization->a[2][2] = 0.0;
    linearization->a[2][3] = 0.0;
    linearization->a[2][4] = 0.0;
    linearization->a[2][5] = 0.0;
    linearization->a[2][6] = 0.0;
    linearization->a[2][7] = 1.0;
    linearization->a[2][8] = 0.0;
    linearization->a[2][9] = 0.0;
    linearization->b[2][0] = 0.0;
    linearization->b[2][1] = 0.0;
    linearization->a[3][0] = 0.0;
    linearization->a[3][1] = 0.0;
    linearization->a[3][2] = 0.0;
    linearization->a[3][3] = 0.0;
    linearization->a[3][4] = 0.0;
    linearization->a[3][5] = 0.0;
    linearization->a[3][6] = 0.0;
    linearization->a[3][7] = 0.0;
    linearization->a[3][8] = 0.0;
    linearization->a[3][9] = 0.0;
    linearization->b[3][0] = 0.0;
    linearization->b[3][1] = 0.0;
    linearization->a[4][0] = 0.0;
    linearization->a[4][1] = 0.0;
    linearization->a[4][2] = 0.0;
    linearization->a[4][3] = 0.0;
    linearization->a[4][4] = 0.0;
    linearization->a[4][5] = 0.0;
    linearization->a[4][6] = 0.0;
    linearization->a[4][7] = 0.0;
    linearization->a[4][8] = 1.0;
    linearization->a[4][9] = 0.0;
    linearization->b[4][0] = 0.0;
    linearization->b[4][1] = 0.0;
    linearization->a[5][0] = 0.0;
    linearization->a[5][1] = 0.0;
    linearization->a[5][2] = 0.0;
    linearization->a[5][3] = 0.0;
    linearization->a[5][4] = 0.0;
    linearization->a[5][5] = 0.0;
    linearization->a[5][6] = 0.0;
    linearization->a[5][7] = 0.0;
    linearization->a[5][8] = 0.0;
    linearization->a[5][9] = 1.0;
    linearization->b[5][0] = 0.0;
    linearization->b[5][1] = 0.0;
    linearization->a[6][0] = 0.0;
    linearization->a[6][1] = 0.0;
    linearization->a[6][2] = 0.0;
    linearization->a[6][3] = 0.0;
    linearization->a[6][4] = 0.0;
    linearization->a[6][5] = 0.0;
    linearization->a[6][6] = 0.0;
    linearization->a[6][7] = t23;
    linearization->a[6][8] = t24;
    linearization->a[6][9] = 1.0;
    linearization->b[6][0] = 0.0;
    linearization->b[6][1] = 0.0;
    linearization->a[7][0] = 0.0;
    linearization->a[7][1] = 0.0;
    linearization->a[7][2] = 0.0;
    linearization->a[7][3] = 0.0;
    linearization->a[7][4] = t457;
    linearization->a[7][5] = 0.0;
    linearization->a[7][6] = 0.0;
    linearization->a[7][7] = t594;
    linearization->a[7][8] = t648;
    linearization->a[7][9] = t677;
    linearization->b[7][0] = t681;
    linearization->b[7][1] = t696;
    linearization->a[8][0] = 0.0;
    linearization->a[8][1] = 0.0;
    linearization->a[8][2] = 0.0;
    linearization->a[8][3] = 0.0;
    linearization->a[8][4] = t453;
    linearization->a[8][5] = 0.0;
    linearization->a[8][6] = 0.0;
    linearization->a[8][7] = t590;
    linearization->a[8][8] = t644;
    linearization->a[8][9] = t673;
    linearization->b[8][0] = t700;
    linearization->b[8][1] = t692;
    linearization->a[9][0] = 0.0;
    linearization->a[9][1] = 0.0;
    linearization->a[9][2] = 0.0;
    linearization->a[9][3] = 0.0;
    linearization->a[9][4] = t451;
    linearization->a[9][5] = 0.0;
    linearization->a[9][6] = 0.0;
    linearization->a[9][7] = t588;
    linearization->a[9][8] = t642;
    linearization->a[9][9] = t671;
    linearization->b[9][0] = t252;
    linearization->b[9][1] = t690;
}

carvallo_motion_error_t wheeled_pendulum_f64_motion_linearize(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    wheeled_pendulum_f64_linearization_t *linearization)
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHEELED_PENDULUM_SPEEDS) && carvallo_are_finite_f64(forces,
        WHEELED_PENDULUM_FORCES)) {
        bool are_finite = true;
        wheeled_pendulum_f64_compute_linearization(motion, positions, speeds, forces,
            linearization);
        for (size_t row = 0U; row < WHEELED_PENDULUM_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f64(linearization->a[row],
                WHEELED_PENDULUM_STATES) && carvallo_are_finite_f64(linearization->b[row],
                WHEELED_PENDULUM_FORCES);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void wheeled_pendulum_f64_compute_by_parameters(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    double by_parameters[WHEELED_PENDULUM_STATES][WHEELED_PENDULUM_PARAMETERS])
{
    const double t3 = speeds[1] + speeds[2];
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t11 = 1.0 / motion->constants[1];
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t14 = motion->constants[1] * sin_phi;
    const double t19 = t14 + (cos_phi * motion->constants[6]) - t14;
    const double t20 = t11 * t19;
    const double t21 = t11 * t20;
    const double t23 = sin_phi * t20;
    const double t24 = t11 * t23;
    const double t27 = cos_phi + cos_phi;
    const double t29 = 1.0 / t19;
    const double t31 = t29 * (sin_phi + sin_phi);
    const double t32 = sin_phi * t31;
    const double t33 = motion->constants[6] * t32;
    const double t35 = (t11 * t27) + (t11 * t33);
    const double t37 = t11 * sin_phi;
    const double t40 = cos_phi * t31;
    const double t43 = (t27 * t37) + (t33 * t37) - (t20 * t40);
    const double t45 = (speeds[0] * t35) + (speeds[1] * t43);
    double sin_theta = 0.0;
    double cos_theta = 0.0;
    carvallo_sin_cos_f64(positions[4], &sin_theta, &cos_theta);
    const double t50 = cos_theta * motion->constants[7];
    const double t51 = motion->constants[1] * t50;
    const double t55 = motion->constants[8] + motion->constants[17] - t51 - t51;
    const double t58 = cos_theta * motion->constants[9];
    const double t60 = motion->constants[18] - t58;
    const double t62 = (sin_phi * t55) + (cos_phi * t60);
    const double t73 = cos_phi * ((sin_phi * t60) + (cos_phi * (motion->constants[13] - (sin_theta *
        sin_theta * motion->constants[15]))));
    const double t75 = sin_phi * motion->constants[4];
    const double t77 = sin_phi + t20;
    const double t78 = motion->constants[4] * t77;
    const double t82 = (sin_phi * t62) + t73 + (sin_phi * t75) + (t77 * t78);
    const double t83 = 1.0 / t82;
    const double t86 = motion->constants[1] - motion->constants[1] - motion->constants[3];
    const double t87 = speeds[0] * cos_phi;
    const double t88 = speeds[0] * sin_phi;
    const double t89 = motion->constants[1] * t88;
    const double t90 = t87 * t89;
    const double t93 = t3 * t87;
    const double t95 = cos_theta * t87;
    const double t96 = motion->constants[6] * t95;
    const double t98 = sin_theta * t87;
    const double t99 = motion->constants[6] * t98;
    const double t104 = speeds[2] + (speeds[0] * t20) + (speeds[1] * t23);
    const double t105 = speeds[1] + t104;
    const double t106 = t87 * t105;
    const double t112 = t90 + (motion->constants[1] * t106) - t90 - (motion->constants[1] * t93) -
        (t95 * t96) - (t98 * t99);
    const double t114 = t3 + t88;
    const double t115 = t89 * t114;
    const double t117 = speeds[1] + t88;
    const double t119 = speeds[1] * t95;
    const double t122 = (cos_theta * t115) + (t96 * t117) - (motion->constants[6] * t119);
    const double t126 = speeds[1] * t98;
    const double t129 = (motion->constants[6] * t126) - (sin_theta * t115) - (t99 * t117);
    const double t131 = t88 + t105;
    const double t134 = (cos_theta * t122) - (sin_theta * t129) - (t89 * t131);
    const double t137 = t29 * ((sin_phi * t112) + (cos_phi * t134));
    const double t138 = t93 + t137;
    const double t141 = t90 + (sin_phi * motion->constants[14]) + (motion->constants[1] * t138);
    const double t145 = (sin_theta * t95) - (cos_theta * t98);
    const double t148 = (t86 * t117 * t145) - (sin_theta * t141);
    const double t151 = t119 + (cos_theta * t137);
    const double t153 = t115 - (cos_phi * motion->constants[14]);
    const double t154 = sin_theta * t153;
    const double t157 = t126 + (sin_theta * t137);
    const double t162 = t11 * ((sin_theta * t122) + (cos_theta * t129));
    const double t163 = motion->constants[4] * t162;
    const double t165 = t98 * motion->constants[12];
    const double t169 = (motion->constants[13] * t95) - (motion->constants[9] * t117);
    const double t171 = (t98 * t169) - (t95 * t165);
    const double t173 = cos_theta * t153;
    const double t177 = motion->constants[7] * t98;
    const double t179 = motion->constants[7] * t117;
    const double t181 = t179 - (t95 * motion->constants[11]);
    const double t183 = (t98 * t177) + (t117 * t181);
    const double t189 = t98 * motion->constants[11];
    const double t192 = (t117 * t189) + (t95 * t177);
    const double t197 = motion->constants[1] * ((sin_theta * ((motion->constants[10] * t173) -
        (motion->constants[11] * t151) - t183)) + (cos_theta * ((t157 * motion->constants[11]) -
        (t154 * motion->constants[10]) - t192)));
    const double t201 = (motion->constants[9] * t157) + t171 - (motion->constants[7] * t154) -
        t163 - t197;
    const double t207 = speeds[2] + t117;
    const double t209 = t104 + t117;
    const double t213 = (motion->constants[8] * t117) + (motion->constants[4] * t207) +
        (motion->constants[4] * t209) - (motion->constants[9] * t95);
    const double t216 = (t117 * t165) - (t98 * t213);
    const double t226 = (motion->constants[7] * t141) + (t117 * t169) - (t95 * t213);
    const double t231 = cos_phi * ((cos_theta * ((t154 * motion->constants[11]) + t216 -
        (motion->constants[13] * t157))) - (sin_theta * ((t173 * motion->constants[11]) + t226 -
        (motion->constants[12] * t151))));
    const double t233 = t163 + forces[1];
    const double t236 = (t20 * t233) - (sin_phi * t201) - t231;
    const double t239 = t23 + 1.0;
    const double t243 = t83 * (t62 + t75 + (t78 * t239));
    const double t244 = motion->constants[4] * t239;
    const double t246 = t82 * t243;
    const double t250 = t55 + motion->constants[4] + (t239 * t244) - (t243 * t246);
    const double t251 = 1.0 / t250;
    const double t255 = (t23 * t233) - t201 - (t236 * t243);
    const double t259 = motion->constants[1] * (t50 - motion->constants[16]);
    const double t265 = t83 * (t75 + t78 + (cos_phi * motion->constants[18]) - (sin_phi * t259));
    const double t270 = t251 * (motion->constants[4] + t244 - t259 - (t246 * t265));
    const double t285 = 1.0 / (motion->constants[19] - (t82 * t265 * t265) - (t250 * t270 * t270));
    const double t286 = (t197 + t233 + forces[0] - (t236 * t265) - (t255 * t270)) * t285;
    const double t288 = (t251 * t255) - (t270 * t286);
    const double t292 = (t83 * t236) - (t243 * t288) - (t265 * t286);
    const double t293 = cos_phi * t292;
    const double t295 = t151 + (sin_theta * t293);
    const double t297 = t98 * t117;
    const double t299 = (sin_theta * t295) + (cos_theta * t297);
    const double t301 = motion->constants[0] * motion->constants[0];
    const double t303 = t301 + (t86 * t86);
    const double t306 = (cos_theta * t293) - t157;
    const double t308 = sin_theta * t117;
    const double t310 = (cos_theta * t306) - (t95 * t308);
    const double t312 = t86 * motion->constants[0];
    const double t314 = t288 + (sin_phi * t292);
    const double t319 = (t117 * t308) - (cos_theta * t314) - (t95 * t145);
    const double t325 = t286 + t314;
    const double t326 = motion->constants[1] * t325;
    const double t328 = t154 + (cos_theta * t326);
    const double t330 = (t86 * t314) - t328;
    const double t332 = t95 * t98;
    const double t335 = t297 + t306;
    const double t337 = motion->constants[1] * cos_theta;
    const double t338 = t314 - t332;
    const double t342 = motion->constants[1] * sin_theta;
    const double t344 = t173 - (sin_theta * t326);
    const double t345 = t98 * t98;
    const double t347 = t345 + (t117 * t117);
    const double t351 = (t337 * ((t86 * t338) - t328)) + (t342 * (t344 - (t86 * t347)));
    const double t355 = (t86 * t330) + (t301 * t332) - (t303 * t332) - (t312 * t335) - t351;
    const double t362 = t95 * t117;
    const double t365 = (t335 * t337) - (t342 * (t362 - t295));
    const double t367 = (cos_phi * ((cos_theta * t328) - (sin_theta * t344))) + (sin_phi * t365);
    const double t369 = (cos_phi * ((t86 * t148) + (t299 * t303) + (t301 * t310) + (t312 * t319))) +
        (sin_phi * t355);
    const double t370 = t369 + (motion->constants[0] * t367);
    const double t372 = motion->constants[0] * t365;
    const double t375 = (t243 * t370) - t355 - t372;
    const double t382 = t285 * (t351 + (t265 * t370) - t372 - (t270 * t375));
    const double t384 = (t251 * t375) - (t270 * t382);
    const double t392 = motion->constants[7] + motion->constants[7];
    const double t394 = motion->constants[0] * motion->constants[2];
    const double t400 = motion->constants[7] * t314;
    const double t408 = (t337 * t338 * motion->constants[2]) - (t342 * t347 * motion->constants[2]);
    const double t412 = (t332 * t392) + (t335 * t394) + t408 - t400 - (t330 * motion->constants[2]);
    const double t414 = (cos_phi * ((t145 * t179) + (t148 * motion->constants[2]) + (t299 * t392) +
        (t319 * t394))) - (sin_phi * t412);
    const double t417 = t412 + (t243 * t414);
    const double t423 = t285 * ((t270 * t417) - t408 - (t265 * t414));
    const double t425 = (t251 * t417) + (t270 * t423);
    const double t429 = (t83 * t414) + (t243 * t425) - (t265 * t423);
    const double t430 = cos_phi * t145;
    const double t433 = (t117 * t430) + (sin_phi * t314);
    const double t436 = (t243 * t433) - t314;
    const double t441 = t285 * ((t265 * t433) - (t270 * t436));
    const double t443 = (t251 * t436) - (t270 * t441);
    const double t450 = (cos_phi * t310) + (sin_phi * t332);
    const double t453 = (t243 * t450) - t332;
    const double t458 = t285 * ((t265 * t450) - (t270 * t453));
    const double t460 = (t251 * t453) - (t270 * t458);
    const double t465 = motion->constants[6] * motion->constants[6];
    const double t474 = (t337 * (t328 + t328)) - (t342 * (t344 + t344));
    const double t478 = (cos_phi * ((t299 * t465) + (t310 * t465))) + (sin_phi * t474) +
        (motion->constants[6] * t367);
    const double t481 = t474 + (motion->constants[6] * t365);
    const double t483 = (t243 * t478) - t481;
    const double t489 = t285 * ((t265 * t478) - t481 - (t270 * t483));
    const double t491 = (t251 * t483) - (t270 * t489);
    const double t503 = t325 + (t20 * t292) + (t23 * t288) - t162;
    const double t506 = (t430 * (t207 + t209)) + (sin_phi * t325) + (t77 * t503);
    const double t511 = (t243 * t506) - t325 - (t239 * t503);
    const double t518 = t285 * ((t265 * t506) - t325 - t503 - (t270 * t511));
    const double t520 = (t251 * t511) - (t270 * t518);
    const double t525 = t299 + t310;
    const double t527 = cos_phi * (t525 + t525);
    const double t529 = t243 * t527;
    const double t534 = t285 * ((t265 * t527) - (t270 * t529));
    const double t536 = (t251 * t529) - (t270 * t534);
    const double t541 = motion->constants[4] * t503;
    const double t542 = forces[1] - t541;
    const double t544 = motion->constants[7] * sin_theta;
    const double t548 = sin_theta * motion->constants[11];
    const double t549 = sin_theta * t325;
    const double t551 = motion->constants[4] * t145;
    const double t552 = speeds[0] * t551;
    const double t554 = speeds[1] * t551;
    const double t557 = sin_theta * motion->constants[12];
    const double t559 = cos_theta * motion->constants[13];
    const double t562 = (cos_theta * t557) - (motion->constants[1] * t544) - (sin_theta * t559);
    const double t563 = cos_phi * t29;
    const double t564 = t131 * t563;
    const double t567 = sin_phi * t29;
    const double t569 = sin_theta * t563;
    const double t570 = t88 * t114;
    const double t571 = sin_theta * t570;
    const double t573 = cos_theta * t563;
    const double t574 = cos_theta * t570;
    const double t579 = (motion->constants[1] * t87 * t567) - (t89 * t563);
    const double t580 = speeds[0] * t579;
    const double t582 = speeds[1] * t579;
    const double t587 = ((t106 - t93) * t567) + (t569 * t571) + (t573 * t574) - (t88 * t564) -
        (t21 * t580);
    const double t588 = t587 - (t24 * t582);
    const double t593 = (t548 * t549) + (t562 * t588) - (t544 * (t138 + (t87 * t88))) - (t21 *
        t552) - (t24 * t554);
    const double t595 = motion->constants[9] * sin_theta;
    const double t598 = cos_theta * motion->constants[11];
    const double t613 = (sin_theta * ((motion->constants[10] * t344) - t183 -
        (motion->constants[11] * t295))) + (cos_theta * (t400 - t192 - (motion->constants[10] *
        t328) - (motion->constants[11] * t306)));
    const double t617 = (t342 * ((motion->constants[10] * t549) + (t588 * t598))) - t613 - (t337 *
        t548 * t588);
    const double t618 = (t588 * t595) + t617;
    const double t620 = t11 * motion->constants[4];
    const double t622 = cos_theta * t620;
    const double t624 = sin_theta * t620;
    const double t626 = motion->constants[4] * t292;
    const double t628 = motion->constants[4] * t288;
    const double t633 = (t162 * t620) + (t571 * t622) - (t574 * t624) - (t21 * t626) - (t24 * t628);
    const double t635 = cos_theta * t325;
    const double t637 = motion->constants[10] * t337;
    const double t638 = t637 - motion->constants[7];
    const double t640 = (cos_phi * t598) + (sin_phi * t638);
    const double t645 = cos_theta * motion->constants[10] * t342;
    const double t649 = (cos_phi * cos_theta * t548) + (sin_phi * t645) - (sin_theta * t640);
    const double t655 = (t570 * t649) - (t21 * t542) - (cos_phi * t593) - (sin_phi * t618) - (t77 *
        t633) - (t635 * t640);
    const double t661 = t645 - (sin_theta * t638);
    const double t668 = (t570 * t661) - t618 - (t24 * t542) - (t239 * t633) - (t635 * t638) -
        (t243 * t655);
    const double t672 = t645 - (sin_theta * t637);
    const double t680 = (t570 * t672) - t617 - t633 - (t635 * t637) - (t265 * t655) - (t270 * t668);
    const double t681 = t285 * t680;
    const double t683 = (t251 * t668) - (t270 * t681);
    const double t687 = (t83 * t655) - (t243 * t683) - (t265 * t681);
    const double t700 = (cos_theta * (t216 + (motion->constants[11] * t328) +
        (motion->constants[13] * t306) - (motion->constants[9] * t314))) - (sin_theta * (t226 +
        (motion->constants[11] * t344) - (motion->constants[12] * t295)));
    const double t713 = t171 + t541 + (motion->constants[8] * t314) + (motion->constants[4] *
        t325) - (motion->constants[7] * t328) - (motion->constants[9] * t306) -
        (motion->constants[1] * t613);
    const double t716 = motion->constants[6] * motion->constants[5];
    const double t718 = t394 + t716 + t716;
    const double t719 = t718 + t718;
    const double t723 = t3 * motion->constants[1];
    const double t727 = sin_theta * t292;
    const double t731 = speeds[0] * sin_theta;
    const double t736 = (cos_theta * t292) - (speeds[1] * t731);
    const double t738 = speeds[0] * cos_theta;
    const double t743 = motion->constants[13] * t738;
    const double t748 = (t557 * t727) + (cos_theta * ((t117 * motion->constants[12]) - t213) *
        t731) + (t559 * t736);
    const double t751 = t748 + (t738 * ((speeds[1] * t557) + (sin_theta * t213))) - (speeds[0] *
        t544 * (t89 + t723)) - (t308 * t743);
    const double t756 = speeds[0] * motion->constants[1];
    const double t760 = motion->constants[1] * t292;
    const double t761 = sin_theta * t760;
    const double t767 = speeds[0] * motion->constants[9];
    const double t769 = motion->constants[8] + motion->constants[4];
    const double t775 = (t548 * t761) + (speeds[0] * ((cos_theta * t165) - (sin_theta * t169))) +
        (t308 * t767) + (speeds[0] * t145 * (motion->constants[4] + t769));
    const double t780 = t29 * t137;
    const double t783 = t345 + (t95 * t95);
    const double t786 = t126 - t297;
    const double t787 = t786 + t786;
    const double t789 = t362 - t119;
    const double t790 = t789 + t789;
    const double t806 = (motion->constants[6] * t117) - (speeds[1] * motion->constants[6]);
    const double t807 = t731 * t806;
    const double t809 = t738 * t806;
    const double t813 = (t29 * t134) + (speeds[0] * t567 * ((motion->constants[1] * t105) - t723)) +
        (t569 * t807) + (t573 * t809);
    const double t820 = speeds[0] * t89;
    const double t824 = t820 + (t114 * t756);
    const double t827 = (sin_theta * t824) + (speeds[0] * t99);
    const double t831 = (cos_theta * t824) + (speeds[0] * t96);
    const double t837 = t40 * ((t29 * t112) + (t569 * t827) + (t573 * t831) - (t563 * t820) -
        (t564 * t756));
    const double t839 = (t573 * t790) + (t32 * (t813 - (motion->constants[6] * t780) - (t567 *
        t731 * (t99 + t99)) - (t567 * t738 * (t96 + t96))));
    const double t844 = t839 + (t35 * t580) + (t43 * t582) - (t27 * t780) - (t567 * (t783 + t783)) -
        (t569 * t787);
    const double t845 = t844 - t837;
    const double t850 = (t299 * t719) + (t310 * t719) + (motion->constants[7] * t319) + (t32 *
        (t751 - (motion->constants[9] * t145 * t738))) + (t35 * t552);
    const double t853 = t850 + (t43 * t554) + (t562 * t845) - (t40 * (t775 - (t58 * t292) - (t544 *
        (motion->constants[14] + (t87 * t756)))));
    const double t864 = (t731 * (t169 - (t95 * motion->constants[12]))) + (t98 * t743) -
        (motion->constants[9] * t736) - (t165 * t738);
    const double t871 = t117 * motion->constants[11];
    const double t879 = t32 * ((t731 * (t871 + (motion->constants[7] * t95))) +
        (motion->constants[11] * t736) + (t177 * t738));
    const double t896 = t32 * ((t738 * (t871 - (speeds[1] * motion->constants[11]))) -
        (motion->constants[11] * t727) - (t731 * (t177 + t177)));
    const double t904 = t896 + (t40 * ((motion->constants[10] * t761) + (speeds[0] * (t179 +
        t181)))) - (t598 * t845);
    const double t906 = (t337 * ((t548 * t845) - t879 - (t40 * ((motion->constants[7] * t292) -
        (speeds[0] * t189))))) + (t342 * t904);
    const double t910 = (t32 * t864) + (t595 * t845) - (motion->constants[7] * t335) - (t40 *
        ((t292 * t769) - (t98 * t767))) - t906;
    const double t929 = (t35 * t626) + (t43 * t628) - (t622 * t787) - (t624 * t790) - (t32 *
        ((t624 * t809) - (t622 * t807))) - (t40 * (t626 + (t622 * t827) - (t624 * t831)));
    const double t932 = t40 * cos_theta * t760;
    const double t936 = (t32 * motion->constants[14]) + (t40 * t824);
    const double t939 = motion->constants[2] + motion->constants[5] + motion->constants[5];
    const double t945 = (t35 * t542) + (t40 * t713) + (t640 * t932) - (t32 * t700) - (cos_phi *
        t853) - (sin_phi * t910);
    const double t948 = t945 - (t77 * t929) - (t649 * t936) - (t367 * t939);
    const double t954 = t365 * t939;
    const double t960 = (t43 * t542) + (t638 * t932) - t910 - (t239 * t929) - (t661 * t936) - t954;
    const double t961 = t960 - (t243 * t948);
    const double t972 = t906 + (t40 * t626) + (t637 * t932) - t929 - t954 - (t672 * t936);
    const double t975 = t285 * (t972 - (t265 * t948) - (t270 * t961));
    const double t977 = (t251 * t961) - (t270 * t975);
    const double t981 = (t83 * t948) - (t243 * t977) - (t265 * t975);
    const double t985 = (sin_phi * cos_phi * t544) - (cos_phi * t649);
    const double t989 = (cos_phi * t661) + (t243 * t985);
    const double t996 = t285 * ((t270 * t989) - (cos_phi * t672) - (t265 * t985));
    const double t998 = (t251 * t989) + (t270 * t996);
    const double t1002 = (t83 * t985) + (t243 * t998) - (t265 * t996);
    const double t1003 = -(t3 * cos_psi);
    const double t1004 = -(t3 * sin_psi);
    const double t1005 = -((speeds[0] * t21) + (speeds[1] * t24));
    const double t1006 = -((t83 * t370) + (t243 * t384) + (t265 * t382));
    const double t1007 = -((t83 * t433) + (t243 * t443) + (t265 * t441));
    const double t1008 = -((t83 * t450) + (t243 * t460) + (t265 * t458));
    const double t1009 = -((t83 * t478) + (t243 * t491) + (t265 * t489));
    const double t1010 = -((t83 * t506) + (t243 * t520) + (t265 * t518));
    const double t1011 = -((t83 * t527) + (t243 * t536) + (t265 * t534));
    const double t1012 = -t425;
    const double t1013 = -t998;
    by_parameters[0][0] = 0.0;
    by_parameters[0][1] = 0.0;
    by_parameters[0][2] = 0.0;
    by_parameters[0][3] = 0.0;
    by_parameters[0][4] = 0.0;
    by_parameters[0][5] = 0.0;
    by_parameters[0][6] = 0.0;
    by_parameters[0][7] = t1003;
    by_parameters[0][8] = 0.0;
    by_parameters[0][9] = 0.0;
    by_parameters[1][0] = 0.0;
    by_parameters[1][1] = 0.0;
    by_parameters[1][2] = 0.0;
    by_parameters[1][3] = 0.0;
    by_parameters[1][4] = 0.0;
    by_parameters[1][5] = 0.0;
    by_parameters[1][6] = 0.0;
    by_parameters[1][7] = t1004;
    by_parameters[1][8] = 0.0;
    by_parameters[1][9] = 0.0;
    by_parameters[2][0] = 0.0;
    by_parameters[2][1] = 0.0;
    by_parameters[2][2] = 0.0;
    by_parameters[2][3] = 0.0;
    by_parameters[2][4] = 0.0;
    by_parameters[2][5] = 0.0;
    by_parameters[2][6] = 0.0;
    by_parameters[2][7] = 0.0;
    by_parameters[2][8] = 0.0;
    by_parameters[2][9] = 0.0;
    by_parameters[3][0] = 0.0;
    by_parameters[3][1] = 0.0;
    by_parameters[3][2] = 0.0;
    by_parameters[3][3] = 0.0;
    by_parameters[3][4] = 0.0;
    by_parameters[3][5] = 0.0;
    by_parameters[3][6] = 0.0;
    by_parameters[3][7] = 0.0;
    by_parameters[3][8] = 0.0;
    by_parameters[3][9] = 0.0;
    by_parameters[4][0] = 0.0;
    by_parameters[4][1] = 0.0;
    by_parameters[4][2] = 0.0;
    by_parameters[4][3] = 0.0;
    by_parameters[4][4] = 0.0;
    by_parameters[4][5] = 0.0;
    by_parameters[4][6] = 0.0;
    by_parameters[4][7] = 0.0;
    by_parameters[4][8] = 0.0;
    by_parameters[4][9] = 0.0;
    by_parameters[5][0] = 0.0;
    by_parameters[5][1] = 0.0;
    by_parameters[5][2] = 0.0;
    by_parameters[5][3] = 0.0;
    by_parameters[5][4] = 0.0;
    by_parameters[5][5] = 0.0;
    by_parameters[5][6] = 0.0;
    by_parameters[5][7] = 0.0;
    by_parameters[5][8] = 0.0;
    by_parameters[5][9] = 0.0;
    by_parameters[6][0] = 0.0;
    by_parameters[6][1] = 0.0;
    by_parameters[6][2] = 0.0;
    by_parameters[6][3] = 0.0;
    by_parameters[6][4] = 0.0;
    by_parameters[6][5] = 0.0;
    by_parameters[6][6] = 0.0;
    by_parameters[6][7] = t1005;
    by_parameters[6][8] = t45;
    by_parameters[6][9] = 0.0;
    by_parameters[7][0] = t1006;
    by_parameters[7][1] = t429;
    by_parameters[7][2] = t1007;
    by_parameters[7][3] = t1008;
    by_parameters[7][4] = t1009;
    by_parameters[7][5] = t1010;
    by_parameters[7][6] = t1011;
    by_parameters[7][7] = t687;
    by_parameters[7][8] = t981;
    by_parameters[7][9] = t1002;
    by_parameters[8][0] = t384;
    by_parameters[8][1] = t1012;
    by_parameters[8][2] = t443;
    by_parameters[8][3] = t460;
    by_parameters[8][4] = t491;
    by_parameters[8][5] = t520;
    by_parameters[8][6] = t536;
    by_parameters[8][7] = t683;
    by_parameters[8][8] = t977;
    by_parameters[8][9] = t1013;
    by_parameters[9][0] = t382;
    by_parameters[9][1] = t423;
    by_parameters[9][2] = t441;
    by_parameters[9][3] = t458;
    by_parameters[9][4] = t489;
    by_parameters[9][5] = t518;
    by_parameters[9][6] = t534;
    by_parameters[9][7] = t681;
    by_parameters[9][8] = t975;
    by_parameters[9][9] = t996;
}

carvallo_motion_error_t wheeled_pendulum_f64_motion_by_parameters(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    double by_parameters[WHEELED_PENDULUM_STATES][WHEELED_PENDULUM_PARAMETERS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f64(speeds, WHEELED_PENDULUM_SPEEDS) && carvallo_are_finite_f64(forces,
        WHEELED_PENDULUM_FORCES)) {
        bool are_finite = true;
        wheeled_pendulum_f64_compute_by_parameters(motion, positions, speeds, forces,
            by_parameters);
        for (size_t row = 0U; row < WHEELED_PENDULUM_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f64(by_parameters[row],
                WHEELED_PENDULUM_PARAMETERS);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
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
    const float t4 = 1.0F / p->r;
    const float t6 = p->Ia + p->Ia;
    const float t7 = t4 * t6;
    const float t9 = t2 + (t4 * t7);
    const float M_11 = p->m + t9;
    const float t11 = t2 * p->r;
    const float t13 = p->r + p->l;
    const float t14 = p->m * t13;
    const float m_all = t6 + (t13 * t14);
    const float M_22 = (p->r * t11) + (m_all + p->Iyy);
    const float M_33 = p->Izz + ((p->b * t9 * p->b) + p->Ir) + p->Ir;
    const float M_12 = -(t11 + (t7 + t14));
    const float K0_22 = -(p->m * p->l);
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
    const float t12 = p->mW + p->mW;
    const float t13 = 1.0F / p->r;
    const float t14 = p->m * p->l;
    const float t15 = p->m + t12;
    const float t17 = t14 + (p->r * t15);
    const float t18 = t13 + t13;
    const float K0_22 = -t14;
    const float t20 = p->r + p->l;
    const float M_22_m = t20 * t20;
    const float t22 = p->m * t20;
    const float M_22_l = t22 + t22;
    const float t24 = p->r + p->r;
    const float M_22_mW = p->r * t24;
    const float t26 = p->b * p->b;
    const float M_33_mW = t26 + t26;
    const float M_11_Ia = t13 * t18;
    const float t29 = p->Ia * t18;
    const float M_22 = p->Ia + p->Ia + (t14 * t20) + (p->r * t17) + p->Iyy;
    const float M_22_r = t17 + t17;
    const float t37 = p->Ia * M_11_Ia;
    const float M_12 = -(t17 + t29);
    const float M_33_Ia = M_11_Ia * t26;
    const float t41 = M_11_Ia * t29;
    const float t42 = t12 + t37;
    const float M_12_r = t37 - t15;
    const float t44 = t26 * t41;
    const float M_11 = p->m + t42;
    const float t46 = t42 * p->b;
    const float M_33 = p->Ir + p->Ir + (p->b * t46) + p->Izz;
    const float M_33_b = t46 + t46;
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
    derivatives->values[0] = p->m;
    derivatives->values[1] = p->l;
    derivatives->values[2] = 1.0F;
    derivatives->values[3] = 2.0F;
    derivatives->values[4] = t18;
    derivatives->values[5] = t20;
    derivatives->values[6] = M_22_m;
    derivatives->values[7] = M_22_l;
    derivatives->values[8] = t24;
    derivatives->values[9] = M_22_mW;
    derivatives->values[10] = M_33_mW;
    derivatives->values[11] = M_11_Ia;
    derivatives->values[12] = M_22_r;
    derivatives->values[13] = M_33_Ia;
    derivatives->values[14] = t41;
    derivatives->values[15] = M_12_r;
    derivatives->values[16] = t44;
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

static void wheeled_pendulum_f32_compute_linearization(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES],
    wheeled_pendulum_f32_linearization_t *linearization)
{
    const float t4 = speeds[1] + speeds[2];
    const float t5 = motion->constants[1] * t4;
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t8 = t5 * sin_psi;
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t16 = motion->constants[1] * sin_phi;
    const float t21 = t16 + (cos_phi * motion->constants[6]) - t16;
    const float t22 = 1.0F / motion->constants[1];
    const float t23 = t21 * t22;
    const float t24 = sin_phi * t23;
    float sin_theta = 0.0F;
    float cos_theta = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_theta, &cos_theta);
    const float t29 = cos_theta * motion->constants[7];
    const float t30 = motion->constants[1] * t29;
    const float t34 = motion->constants[8] + motion->constants[17] - t30 - t30;
    const float t39 = motion->constants[18] - (cos_theta * motion->constants[9]);
    const float t41 = (sin_phi * t34) + (cos_phi * t39);
    const float t52 = cos_phi * ((sin_phi * t39) + (cos_phi * (motion->constants[13] - (sin_theta *
        sin_theta * motion->constants[15]))));
    const float t54 = sin_phi * motion->constants[4];
    const float t56 = sin_phi + t23;
    const float t57 = motion->constants[4] * t56;
    const float t61 = (sin_phi * t41) + t52 + (sin_phi * t54) + (t56 * t57);
    const float t62 = 1.0F / t61;
    const float t64 = sin_phi * speeds[0];
    const float t65 = motion->constants[1] * t64;
    const float t66 = cos_phi * speeds[0];
    const float t67 = t65 * t66;
    const float t70 = t4 * t66;
    const float t72 = cos_theta * t66;
    const float t73 = motion->constants[6] * t72;
    const float t75 = sin_theta * t66;
    const float t76 = motion->constants[6] * t75;
    const float t81 = speeds[2] + (t23 * speeds[0]) + (speeds[1] * t24);
    const float t82 = speeds[1] + t81;
    const float t88 = t67 + (motion->constants[1] * t66 * t82) - (motion->constants[1] * t70) -
        t67 - (t72 * t73);
    const float t91 = t4 + t64;
    const float t92 = t91 * t65;
    const float t93 = cos_theta * t92;
    const float t94 = speeds[1] + t64;
    const float t96 = speeds[1] * t72;
    const float t99 = t93 + (t73 * t94) - (motion->constants[6] * t96);
    const float t101 = sin_theta * t92;
    const float t103 = speeds[1] * t75;
    const float t106 = (motion->constants[6] * t103) - t101 - (t76 * t94);
    const float t108 = (cos_theta * t99) - (sin_theta * t106);
    const float t109 = t64 + t82;
    const float t114 = 1.0F / t21;
    const float t115 = ((sin_phi * (t88 - (t75 * t76))) + (cos_phi * (t108 - (t65 * t109)))) * t114;
    const float t121 = motion->constants[9] * t94;
    const float t123 = (motion->constants[13] * t72) - t121;
    const float t133 = (motion->constants[8] * t94) + (motion->constants[4] * (speeds[2] + t94)) +
        (motion->constants[4] * (t81 + t94)) - (motion->constants[9] * t72);
    const float t136 = (motion->constants[7] * (t67 + (sin_phi * motion->constants[14]) +
        (motion->constants[1] * (t70 + t115)))) + (t94 * t123) - (t72 * t133);
    const float t139 = t92 - (cos_phi * motion->constants[14]);
    const float t140 = cos_theta * t139;
    const float t145 = t96 + (cos_theta * t115);
    const float t147 = motion->constants[7] * t75;
    const float t149 = motion->constants[7] * t94;
    const float t151 = t149 - (motion->constants[11] * t72);
    const float t153 = (t75 * t147) + (t94 * t151);
    const float t157 = sin_theta * t139;
    const float t159 = sin_theta * t115;
    const float t160 = t103 + t159;
    const float t162 = motion->constants[11] * t75;
    const float t165 = (t94 * t162) + (t72 * t147);
    const float t170 = motion->constants[1] * ((sin_theta * ((t140 * motion->constants[10]) -
        (motion->constants[11] * t145) - t153)) + (cos_theta * ((motion->constants[11] * t160) -
        (motion->constants[10] * t157) - t165)));
    const float t175 = t22 * motion->constants[4];
    const float t176 = ((sin_theta * t99) + (cos_theta * t106)) * t175;
    const float t177 = forces[1] + t176;
    const float t181 = t75 * motion->constants[12];
    const float t188 = (motion->constants[9] * t160) + (t75 * t123) - t170 - t176 -
        (motion->constants[7] * t157) - (t72 * t181);
    const float t194 = (t94 * t181) - (t75 * t133);
    const float t204 = cos_phi * ((cos_theta * ((motion->constants[11] * t157) + t194 -
        (motion->constants[13] * t160))) - (sin_theta * ((motion->constants[11] * t140) + t136 -
        (t145 * motion->constants[12]))));
    const float t207 = (t23 * t177) - (sin_phi * t188) - t204;
    const float t210 = motion->constants[1] * (t29 - motion->constants[16]);
    const float t216 = t62 * (t54 + t57 + (cos_phi * motion->constants[18]) - (sin_phi * t210));
    const float t218 = 1.0F + t24;
    const float t219 = motion->constants[4] * t218;
    const float t223 = t62 * (t41 + t54 + (t57 * t218));
    const float t224 = t61 * t223;
    const float t233 = t34 + motion->constants[4] + (t218 * t219) - (t223 * t224);
    const float t234 = 1.0F / t233;
    const float t235 = (motion->constants[4] + t219 - t210 - (t216 * t224)) * t234;
    const float t239 = (t24 * t177) - t188 - (t207 * t223);
    const float t252 = 1.0F / (motion->constants[19] - (t61 * t216 * t216) - (t233 * t235 * t235));
    const float t253 = (forces[0] + t170 + t177 - (t207 * t216) - (t235 * t239)) * t252;
    const float t256 = (t234 * t239) - (t235 * t253);
    const float t261 = (t62 * t207) - (t223 * t256) - (t216 * t253);
    const float t263 = t256 + (sin_phi * t261);
    const float t265 = motion->constants[1] * (t253 + t263);
    const float t267 = t140 - (sin_theta * t265);
    const float t269 = cos_phi * t261;
    const float t271 = t145 + (sin_theta * t269);
    const float t273 = sin_theta * motion->constants[11];
    const float t280 = t157 + (cos_theta * t265);
    const float t284 = (cos_theta * t269) - t159;
    const float t285 = t284 - t103;
    const float t292 = sin_theta * (t194 + (motion->constants[11] * t280) + (motion->constants[13] *
        t285) - (motion->constants[9] * t263) - (t139 * t273));
    const float t293 = cos_theta * motion->constants[11];
    const float t295 = sin_theta * motion->constants[12];
    const float t302 = (sin_theta * t72) - (cos_theta * t75);
    const float t306 = (speeds[1] * t295) - (sin_theta * ((motion->constants[13] * t94) - t133)) -
        (motion->constants[9] * t302);
    const float t308 = (cos_theta * ((motion->constants[12] * t271) + (t265 * t273) - t136 -
        (motion->constants[11] * t267))) + (t267 * t293);
    const float t315 = cos_phi * cos_theta;
    const float t316 = ((t94 * motion->constants[12]) - t133) * t315;
    const float t318 = t23 * t175;
    const float t322 = (motion->constants[6] * t94) - (speeds[1] * motion->constants[6]);
    const float t324 = t101 + (t75 * t322);
    const float t326 = cos_theta * t322;
    const float t330 = t108 - (cos_theta * t93) - (sin_theta * t324) - (t72 * t326);
    const float t334 = (motion->constants[13] * t75) - t181;
    const float t337 = t123 - (t72 * motion->constants[12]);
    const float t342 = sin_theta * motion->constants[10];
    const float t356 = sin_theta * ((motion->constants[7] * t263) + (t139 * t342) - t165 -
        (motion->constants[10] * t280) - (motion->constants[11] * t285));
    const float t357 = cos_theta * motion->constants[10];
    const float t361 = motion->constants[11] * t94;
    const float t365 = (sin_theta * t361) - (cos_theta * t147) - (speeds[1] * t273);
    const float t372 = (cos_theta * (t361 + (motion->constants[7] * t72))) + (sin_theta * (t147 +
        t147));
    const float t374 = (cos_theta * ((motion->constants[10] * t267) - t153 -
        (motion->constants[11] * t271) - (t265 * t342))) - t356;
    const float t379 = motion->constants[1] * (t374 - (t267 * t357) - (t273 * t284) - (t75 * t365) -
        (t72 * t372));
    const float t380 = (t175 * t330) + t379;
    const float t383 = (t72 * t337) - (motion->constants[7] * t267) - (t75 * t334) - t380;
    const float t386 = motion->constants[1] * t293;
    const float t387 = t386 - motion->constants[9];
    const float t389 = (motion->constants[13] * t315) + (sin_phi * t387);
    const float t392 = cos_phi * sin_theta;
    const float t395 = sin_phi * (t73 + t73);
    const float t402 = (sin_phi * (t76 + t76)) - (t322 * t392);
    const float t408 = (t75 * t395) + (t93 * t392) - (t106 * t315) - (t99 * t392) - (t315 * t324) -
        (t72 * t402);
    const float t409 = motion->constants[1] * motion->constants[7];
    const float t410 = sin_theta * t114;
    const float t412 = cos_theta * t114;
    const float t417 = motion->constants[1] * t273 * t412;
    const float t421 = (t389 * t410) - (cos_phi * ((t295 * t412) - (t409 * t410))) - (sin_phi *
        t417);
    const float t425 = (t318 * t330) + (t271 * t389) + (t408 * t421) - (cos_phi * (t308 + (t284 *
        t295) - t292 - (t75 * t306)));
    const float t427 = t425 - (t72 * t316) - (sin_phi * t383);
    const float t429 = t24 * t175;
    const float t433 = (t387 * t410) - t417;
    const float t439 = (t330 * t429) + (t271 * t387) + (t408 * t433) - t383 - (t223 * t427);
    const float t443 = (t386 * t410) - t417;
    const float t451 = t252 * (t380 + (t271 * t386) + (t408 * t443) - (t216 * t427) - (t235 *
        t439));
    const float t453 = (t234 * t439) - (t235 * t451);
    const float t457 = (t62 * t427) - (t223 * t453) - (t216 * t451);
    const float t458 = t16 * t66;
    const float t474 = (cos_theta * t181) + (t302 * (motion->constants[8] + motion->constants[4] +
        motion->constants[4])) - (sin_theta * (t123 - t121));
    const float t478 = sin_phi * (t65 + (motion->constants[1] * t91));
    const float t481 = (sin_theta * t293) - (cos_theta * t273);
    const float t485 = (t306 * t315) + (sin_phi * t474) + (t478 * t481) - (sin_theta *
        ((motion->constants[7] * t458) + (cos_phi * ((t4 * t409) + (motion->constants[7] * t65)))));
    const float t490 = (t315 * t322) + (sin_phi * t73);
    const float t492 = sin_phi * t76;
    const float t496 = (sin_theta * t490) - (cos_theta * t492) - (t326 * t392);
    const float t499 = motion->constants[9] * t75;
    const float t501 = motion->constants[7] * sin_theta;
    const float t509 = (cos_theta * t162) + (sin_theta * (t149 + t151));
    const float t513 = (cos_theta * t342) - (sin_theta * t357);
    const float t520 = (t175 * t496) + (motion->constants[1] * ((t315 * t365) + (t478 * t513) -
        (sin_phi * t509) - (t372 * t392)));
    const float t524 = (t315 * t334) + (t337 * t392) - (sin_phi * t499) - (t478 * t501) - t520;
    const float t526 = speeds[1] * t392;
    const float t541 = (cos_theta * t315) + (sin_theta * t392);
    const float t546 = (cos_phi * ((t16 * t82) - (t5 * sin_phi))) + (t315 * t490) + (t392 * t492) +
        (t478 * t541);
    const float t549 = t546 - (sin_phi * cos_phi * (t65 + (motion->constants[1] * t109))) - (t315 *
        t395) - (t392 * t402);
    const float t552 = cos_phi * motion->constants[4] * t302;
    const float t554 = t458 - (cos_phi * t65);
    const float t556 = (t421 * t554) - t552;
    const float t562 = (t318 * t496) + (t389 * t526) + (t421 * t549) + (t23 * t556) - (cos_phi *
        t485) - (t316 * t392);
    const float t563 = t562 - (sin_phi * t524);
    const float t568 = t433 * t554;
    const float t575 = (t429 * t496) + (t387 * t526) + (t433 * t549) + (t23 * t568) - t524 - (t223 *
        t563);
    const float t579 = t443 * t554;
    const float t587 = t520 + (t386 * t526) + (t443 * t549) + (t23 * t579) - (t216 * t563) - (t235 *
        t575);
    const float t588 = t252 * t587;
    const float t590 = (t234 * t575) - (t235 * t588);
    const float t594 = (t62 * t563) - (t223 * t590) - (t216 * t588);
    const float t601 = cos_phi * ((t65 * t481) - (t75 * t409));
    const float t602 = t65 * t501;
    const float t604 = t65 * t513;
    const float t607 = motion->constants[1] * (t604 - t509 - (t72 * t273));
    const float t609 = t499 + t602 + t607;
    const float t613 = (t65 * t541) - t458;
    const float t614 = t554 + t613;
    const float t621 = (sin_phi * t609) + (t75 * t389) + (t421 * t614) + (t24 * t556) - (cos_phi *
        (t474 + (t72 * t295))) - t601;
    const float t630 = t609 + (t75 * t387) + (t433 * t614) + (t24 * t568) - (t223 * t621);
    const float t641 = t607 + (t75 * t386) + (t443 * t614) + (t24 * t579) - (t216 * t621) - (t235 *
        t630);
    const float t642 = t252 * t641;
    const float t644 = (t234 * t630) - (t235 * t642);
    const float t648 = (t62 * t621) - (t223 * t644) - (t216 * t642);
    const float t649 = motion->constants[1] * t604;
    const float t650 = t602 + t649;
    const float t656 = t556 + (sin_phi * t650) + (t421 * t613) - t552 - t601;
    const float t662 = t568 + t650 + (t433 * t613) - (t223 * t656);
    const float t671 = t252 * (t579 + t649 + (t443 * t613) - (t216 * t656) - (t235 * t662));
    const float t673 = (t234 * t662) - (t235 * t671);
    const float t677 = (t62 * t656) - (t223 * t673) - (t216 * t671);
    const float t678 = t235 * t252;
    const float t681 = (t223 * t678) - (t216 * t252);
    const float t684 = t24 - (t23 * t223);
    const float t690 = t252 * (1.0F - (t23 * t216) - (t235 * t684));
    const float t692 = (t234 * t684) - (t235 * t690);
    const float t696 = (t23 * t62) - (t223 * t692) - (t216 * t690);
    const float t697 = -(motion->constants[1] * cos_psi);
    const float t698 = -(t5 * cos_psi);
    const float t699 = -(motion->constants[1] * sin_psi);
    const float t700 = -t678;
    linearization->a[0][0] = 0.0F;
    linearization->a[0][1] = 0.0F;
    linearization->a[0][2] = t8;
    linearization->a[0][3] = 0.0F;
    linearization->a[0][4] = 0.0F;
    linearization->a[0][5] = 0.0F;
    linearization->a[0][6] = 0.0F;
    linearization->a[0][7] = 0.0F;
    linearization->a[0][8] = t697;
    linearization->a[0][9] = t697;
    linearization->b[0][0] = 0.0F;
    linearization->b[0][1] = 0.0F;
    linearization->a[1][0] = 0.0F;
    linearization->a[1][1] = 0.0F;
    linearization->a[1][2] = t698;
    linearization->a[1][3] = 0.0F;
    linearization->a[1][4] = 0.0F;
    linearization->a[1][5] = 0.0F;
    linearization->a[1][6] = 0.0F;
    linearization->a[1][7] = 0.0F;
    linearization->a[1][8] = t699;
    linearization->a[1][9] = t699;
    linearization->b[1][0] = 0.0F;
    linearization->b[1][1] = 0.0F;
    linearization->a[2][0] = 0.0F;
    linearization->a[2][1] = 0.0F;
    linearization->a[2][2] = 0.0F;
    linearization->a[2][3] = 0.0F;
    linearization->a[2][4] = 0.0F;
    linearization->a[2][5] = 0.0F;
    linearization->a[2][6] = 0.0F;
    linearization->a[2][7] = 1.0F;
    linearization->a[2][8] = 0.0F;
    linearization->a[2][9] = 0.0F;
    linearization->b[2][0] = 0.0F;
    linearization->b[2][1] = 0.0F;
    linearization->a[3][0] = 0.0F;
    linearization->a[3][1] = 0.0F;
    linearization->a[3][2] = 0.0F;
    linearization->a[3][3] = 0.0F;
    linearization->a[3][4] = 0.0F;
    linearization->a[3][5] = 0.0F;
    linearization->a[3][6] = 0.0F;
    linearization->a[3][7] = 0.0F;
    linearization->a[3][8] = 0.0F;
    linearization->a[3][9] = 0.0F;
    linearization->b[3][0] = 0.0F;
    linearization->b[3][1] = 0.0F;
    linearization->a[4][0] = 0.0F;
    linearization->a[4][1] = 0.0F;
    linearization->a[4][2] = 0.0F;
    linearization->a[4][3] = 0.0F;
    linearization->a[4][4] = 0.0F;
    linearization->a[4][5] = 0.0F;
    linearization->a[4][6] = 0.0F;
    linearization->a[4][7] = 0.0F;
    linearization->a[4][8] = 1.0F;
    linearization->a[4][9] = 0.0F;
    linearization->b[4][0] = 0.0F;
    linearization->b[4][1] = 0.0F;
    linearization->a[5][0] = 0.0F;
    linearization->a[5][1] = 0.0F;
    linearization->a[5][2] = 0.0F;
    linearization->a[5][3] = 0.0F;
    linearization->a[5][4] = 0.0F;
    linearization->a[5][5] = 0.0F;
    linearization->a[5][6] = 0.0F;
    linearization->a[5][7] = 0.0F;
    linearization->a[5][8] = 0.0F;
    linearization->a[5][9] = 1.0F;
    linearization->b[5][0] = 0.0F;
    linearization->b[5][1] = 0.0F;
    linearization->a[6][0] = 0.0F;
    linearization->a[6][1] = 0.0F;
    linearization->a[6][2] = 0.0F;
    linearization->a[6][3] = 0.0F;
    linearization->a[6][4] = 0.0F;
    linearization->a[6][5] = 0.0F;
    linearization->a[6][6] = 0.0F;
    linearization->a[6][7] = t23;
    linearization->a[6][8] = t24;
    linearization->a[6][9] = 1.0F;
    linearization->b[6][0] = 0.0F;
    linearization->b[6][1] = 0.0F;
    linearization->a[7][0] = 0.0F;
    linearization->a[7][1] = 0.0F;
    linearization->a[7][2] = 0.0F;
    linearization->a[7][3] = 0.0F;
    linearization->a[7][4] = t457;
    linearization->a[7][5] = 0.0F;
    linearization->a[7][6] = 0.0F;
    linearization->a[7][7] = t594;
    linearization->a[7][8] = t648;
    linearization->a[7][9] = t677;
    linearization->b[7][0] = t681;
    linearization->b[7][1] = t696;
    linearization->a[8][0] = 0.0F;
    linearization->a[8][1] = 0.0F;
    linearization->a[8][2] = 0.0F;
    linearization->a[8][3] = 0.0F;
    linearization->a[8][4] = t453;
    linearization->a[8][5] = 0.0F;
    linearization->a[8][6] = 0.0F;
    linearization->a[8][7] = t590;
    linearization->a[8][8] = t644;
    linearization->a[8][9] = t673;
    linearization->b[8][0] = t700;
    linearization->b[8][1] = t692;
    linearization->a[9][0] = 0.0F;
    linearization->a[9][1] = 0.0F;
    linearization->a[9][2] = 0.0F;
    linearization->a[9][3] = 0.0F;
    linearization->a[9][4] = t451;
    linearization->a[9][5] = 0.0F;
    linearization->a[9][6] = 0.0F;
    linearization->a[9][7] = t588;
    linearization->a[9][8] = t642;
    linearization->a[9][9] = t671;
    linearization->b[9][0] = t252;
    linearization->b[9][1] = t690;
}

carvallo_motion_error_t wheeled_pendulum_f32_motion_linearize(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES],
    wheeled_pendulum_f32_linearization_t *linearization)
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHEELED_PENDULUM_SPEEDS) && carvallo_are_finite_f32(forces,
        WHEELED_PENDULUM_FORCES)) {
        bool are_finite = true;
        wheeled_pendulum_f32_compute_linearization(motion, positions, speeds, forces,
            linearization);
        for (size_t row = 0U; row < WHEELED_PENDULUM_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f32(linearization->a[row],
                WHEELED_PENDULUM_STATES) && carvallo_are_finite_f32(linearization->b[row],
                WHEELED_PENDULUM_FORCES);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void wheeled_pendulum_f32_compute_by_parameters(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES],
    float by_parameters[WHEELED_PENDULUM_STATES][WHEELED_PENDULUM_PARAMETERS])
{
    const float t3 = speeds[1] + speeds[2];
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t11 = 1.0F / motion->constants[1];
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t14 = motion->constants[1] * sin_phi;
    const float t19 = t14 + (cos_phi * motion->constants[6]) - t14;
    const float t20 = t11 * t19;
    const float t21 = t11 * t20;
    const float t23 = sin_phi * t20;
    const float t24 = t11 * t23;
    const float t27 = cos_phi + cos_phi;
    const float t29 = 1.0F / t19;
    const float t31 = t29 * (sin_phi + sin_phi);
    const float t32 = sin_phi * t31;
    const float t33 = motion->constants[6] * t32;
    const float t35 = (t11 * t27) + (t11 * t33);
    const float t37 = t11 * sin_phi;
    const float t40 = cos_phi * t31;
    const float t43 = (t27 * t37) + (t33 * t37) - (t20 * t40);
    const float t45 = (speeds[0] * t35) + (speeds[1] * t43);
    float sin_theta = 0.0F;
    float cos_theta = 0.0F;
    carvallo_sin_cos_f32(positions[4], &sin_theta, &cos_theta);
    const float t50 = cos_theta * motion->constants[7];
    const float t51 = motion->constants[1] * t50;
    const float t55 = motion->constants[8] + motion->constants[17] - t51 - t51;
    const float t58 = cos_theta * motion->constants[9];
    const float t60 = motion->constants[18] - t58;
    const float t62 = (sin_phi * t55) + (cos_phi * t60);
    const float t73 = cos_phi * ((sin_phi * t60) + (cos_phi * (motion->constants[13] - (sin_theta *
        sin_theta * motion->constants[15]))));
    const float t75 = sin_phi * motion->constants[4];
    const float t77 = sin_phi + t20;
    const float t78 = motion->constants[4] * t77;
    const float t82 = (sin_phi * t62) + t73 + (sin_phi * t75) + (t77 * t78);
    const float t83 = 1.0F / t82;
    const float t86 = motion->constants[1] - motion->constants[1] - motion->constants[3];
    const float t87 = speeds[0] * cos_phi;
    const float t88 = speeds[0] * sin_phi;
    const float t89 = motion->constants[1] * t88;
    const float t90 = t87 * t89;
    const float t93 = t3 * t87;
    const float t95 = cos_theta * t87;
    const float t96 = motion->constants[6] * t95;
    const float t98 = sin_theta * t87;
    const float t99 = motion->constants[6] * t98;
    const float t104 = speeds[2] + (speeds[0] * t20) + (speeds[1] * t23);
    const float t105 = speeds[1] + t104;
    const float t106 = t87 * t105;
    const float t112 = t90 + (motion->constants[1] * t106) - t90 - (motion->constants[1] * t93) -
        (t95 * t96) - (t98 * t99);
    const float t114 = t3 + t88;
    const float t115 = t89 * t114;
    const float t117 = speeds[1] + t88;
    const float t119 = speeds[1] * t95;
    const float t122 = (cos_theta * t115) + (t96 * t117) - (motion->constants[6] * t119);
    const float t126 = speeds[1] * t98;
    const float t129 = (motion->constants[6] * t126) - (sin_theta * t115) - (t99 * t117);
    const float t131 = t88 + t105;
    const float t134 = (cos_theta * t122) - (sin_theta * t129) - (t89 * t131);
    const float t137 = t29 * ((sin_phi * t112) + (cos_phi * t134));
    const float t138 = t93 + t137;
    const float t141 = t90 + (sin_phi * motion->constants[14]) + (motion->constants[1] * t138);
    const float t145 = (sin_theta * t95) - (cos_theta * t98);
    const float t148 = (t86 * t117 * t145) - (sin_theta * t141);
    const float t151 = t119 + (cos_theta * t137);
    const float t153 = t115 - (cos_phi * motion->constants[14]);
    const float t154 = sin_theta * t153;
    const float t157 = t126 + (sin_theta * t137);
    const float t162 = t11 * ((sin_theta * t122) + (cos_theta * t129));
    const float t163 = motion->constants[4] * t162;
    const float t165 = t98 * motion->constants[12];
    const float t169 = (motion->constants[13] * t95) - (motion->constants[9] * t117);
    const float t171 = (t98 * t169) - (t95 * t165);
    const float t173 = cos_theta * t153;
    const float t177 = motion->constants[7] * t98;
    const float t179 = motion->constants[7] * t117;
    const float t181 = t179 - (t95 * motion->constants[11]);
    const float t183 = (t98 * t177) + (t117 * t181);
    const float t189 = t98 * motion->constants[11];
    const float t192 = (t117 * t189) + (t95 * t177);
    const float t197 = motion->constants[1] * ((sin_theta * ((motion->constants[10] * t173) -
        (motion->constants[11] * t151) - t183)) + (cos_theta * ((t157 * motion->constants[11]) -
        (t154 * motion->constants[10]) - t192)));
    const float t201 = (motion->constants[9] * t157) + t171 - (motion->constants[7] * t154) - t163 -
        t197;
    const float t207 = speeds[2] + t117;
    const float t209 = t104 + t117;
    const float t213 = (motion->constants[8] * t117) + (motion->constants[4] * t207) +
        (motion->constants[4] * t209) - (motion->constants[9] * t95);
    const float t216 = (t117 * t165) - (t98 * t213);
    const float t226 = (motion->constants[7] * t141) + (t117 * t169) - (t95 * t213);
    const float t231 = cos_phi * ((cos_theta * ((t154 * motion->constants[11]) + t216 -
        (motion->constants[13] * t157))) - (sin_theta * ((t173 * motion->constants[11]) + t226 -
        (motion->constants[12] * t151))));
    const float t233 = t163 + forces[1];
    const float t236 = (t20 * t233) - (sin_phi * t201) - t231;
    const float t239 = t23 + 1.0F;
    const float t243 = t83 * (t62 + t75 + (t78 * t239));
    const float t244 = motion->constants[4] * t239;
    const float t246 = t82 * t243;
    const float t250 = t55 + motion->constants[4] + (t239 * t244) - (t243 * t246);
    const float t251 = 1.0F / t250;
    const float t255 = (t23 * t233) - t201 - (t236 * t243);
    const float t259 = motion->constants[1] * (t50 - motion->constants[16]);
    const float t265 = t83 * (t75 + t78 + (cos_phi * motion->constants[18]) - (sin_phi * t259));
    const float t270 = t251 * (motion->constants[4] + t244 - t259 - (t246 * t265));
    const float t285 = 1.0F / (motion->constants[19] - (t82 * t265 * t265) - (t250 * t270 * t270));
    const float t286 = (t197 + t233 + forces[0] - (t236 * t265) - (t255 * t270)) * t285;
    const float t288 = (t251 * t255) - (t270 * t286);
    const float t292 = (t83 * t236) - (t243 * t288) - (t265 * t286);
    const float t293 = cos_phi * t292;
    const float t295 = t151 + (sin_theta * t293);
    const float t297 = t98 * t117;
    const float t299 = (sin_theta * t295) + (cos_theta * t297);
    const float t301 = motion->constants[0] * motion->constants[0];
    const float t303 = t301 + (t86 * t86);
    const float t306 = (cos_theta * t293) - t157;
    const float t308 = sin_theta * t117;
    const float t310 = (cos_theta * t306) - (t95 * t308);
    const float t312 = t86 * motion->constants[0];
    const float t314 = t288 + (sin_phi * t292);
    const float t319 = (t117 * t308) - (cos_theta * t314) - (t95 * t145);
    const float t325 = t286 + t314;
    const float t326 = motion->constants[1] * t325;
    const float t328 = t154 + (cos_theta * t326);
    const float t330 = (t86 * t314) - t328;
    const float t332 = t95 * t98;
    const float t335 = t297 + t306;
    const float t337 = motion->constants[1] * cos_theta;
    const float t338 = t314 - t332;
    const float t342 = motion->constants[1] * sin_theta;
    const float t344 = t173 - (sin_theta * t326);
    const float t345 = t98 * t98;
    const float t347 = t345 + (t117 * t117);
    const float t351 = (t337 * ((t86 * t338) - t328)) + (t342 * (t344 - (t86 * t347)));
    const float t355 = (t86 * t330) + (t301 * t332) - (t303 * t332) - (t312 * t335) - t351;
    const float t362 = t95 * t117;
    const float t365 = (t335 * t337) - (t342 * (t362 - t295));
    const float t367 = (cos_phi * ((cos_theta * t328) - (sin_theta * t344))) + (sin_phi * t365);
    const float t369 = (cos_phi * ((t86 * t148) + (t299 * t303) + (t301 * t310) + (t312 * t319))) +
        (sin_phi * t355);
    const float t370 = t369 + (motion->constants[0] * t367);
    const float t372 = motion->constants[0] * t365;
    const float t375 = (t243 * t370) - t355 - t372;
    const float t382 = t285 * (t351 + (t265 * t370) - t372 - (t270 * t375));
    const float t384 = (t251 * t375) - (t270 * t382);
    const float t392 = motion->constants[7] + motion->constants[7];
    const float t394 = motion->constants[0] * motion->constants[2];
    const float t400 = motion->constants[7] * t314;
    const float t408 = (t337 * t338 * motion->constants[2]) - (t342 * t347 * motion->constants[2]);
    const float t412 = (t332 * t392) + (t335 * t394) + t408 - t400 - (t330 * motion->constants[2]);
    const float t414 = (cos_phi * ((t145 * t179) + (t148 * motion->constants[2]) + (t299 * t392) +
        (t319 * t394))) - (sin_phi * t412);
    const float t417 = t412 + (t243 * t414);
    const float t423 = t285 * ((t270 * t417) - t408 - (t265 * t414));
    const float t425 = (t251 * t417) + (t270 * t423);
    const float t429 = (t83 * t414) + (t243 * t425) - (t265 * t423);
    const float t430 = cos_phi * t145;
    const float t433 = (t117 * t430) + (sin_phi * t314);
    const float t436 = (t243 * t433) - t314;
    const float t441 = t285 * ((t265 * t433) - (t270 * t436));
    const float t443 = (t251 * t436) - (t270 * t441);
    const float t450 = (cos_phi * t310) + (sin_phi * t332);
    const float t453 = (t243 * t450) - t332;
    const float t458 = t285 * ((t265 * t450) - (t270 * t453));
    const float t460 = (t251 * t453) - (t270 * t458);
    const float t465 = motion->constants[6] * motion->constants[6];
    const float t474 = (t337 * (t328 + t328)) - (t342 * (t344 + t344));
    const float t478 = (cos_phi * ((t299 * t465) + (t310 * t465))) + (sin_phi * t474) +
        (motion->constants[6] * t367);
    const float t481 = t474 + (motion->constants[6] * t365);
    const float t483 = (t243 * t478) - t481;
    const float t489 = t285 * ((t265 * t478) - t481 - (t270 * t483));
    const float t491 = (t251 * t483) - (t270 * t489);
    const float t503 = t325 + (t20 * t292) + (t23 * t288) - t162;
    const float t506 = (t430 * (t207 + t209)) + (sin_phi * t325) + (t77 * t503);
    const float t511 = (t243 * t506) - t325 - (t239 * t503);
    const float t518 = t285 * ((t265 * t506) - t325 - t503 - (t270 * t511));
    const float t520 = (t251 * t511) - (t270 * t518);
    const float t525 = t299 + t310;
    const float t527 = cos_phi * (t525 + t525);
    const float t529 = t243 * t527;
    const float t534 = t285 * ((t265 * t527) - (t270 * t529));
    const float t536 = (t251 * t529) - (t270 * t534);
    const float t541 = motion->constants[4] * t503;
    const float t542 = forces[1] - t541;
    const float t544 = motion->constants[7] * sin_theta;
    const float t548 = sin_theta * motion->constants[11];
    const float t549 = sin_theta * t325;
    const float t551 = motion->constants[4] * t145;
    const float t552 = speeds[0] * t551;
    const float t554 = speeds[1] * t551;
    const float t557 = sin_theta * motion->constants[12];
    const float t559 = cos_theta * motion->constants[13];
    const float t562 = (cos_theta * t557) - (motion->constants[1] * t544) - (sin_theta * t559);
    const float t563 = cos_phi * t29;
    const float t564 = t131 * t563;
    const float t567 = sin_phi * t29;
    const float t569 = sin_theta * t563;
    const float t570 = t88 * t114;
    const float t571 = sin_theta * t570;
    const float t573 = cos_theta * t563;
    const float t574 = cos_theta * t570;
    const float t579 = (motion->constants[1] * t87 * t567) - (t89 * t563);
    const float t580 = speeds[0] * t579;
    const float t582 = speeds[1] * t579;
    const float t587 = ((t106 - t93) * t567) + (t569 * t571) + (t573 * t574) - (t88 * t564) - (t21 *
        t580);
    const float t588 = t587 - (t24 * t582);
    const float t593 = (t548 * t549) + (t562 * t588) - (t544 * (t138 + (t87 * t88))) - (t21 *
        t552) - (t24 * t554);
    const float t595 = motion->constants[9] * sin_theta;
    const float t598 = cos_theta * motion->constants[11];
    const float t613 = (sin_theta * ((motion->constants[10] * t344) - t183 -
        (motion->constants[11] * t295))) + (cos_theta * (t400 - t192 - (motion->constants[10] *
        t328) - (motion->constants[11] * t306)));
    const float t617 = (t342 * ((motion->constants[10] * t549) + (t588 * t598))) - t613 - (t337 *
        t548 * t588);
    const float t618 = (t588 * t595) + t617;
    const float t620 = t11 * motion->constants[4];
    const float t622 = cos_theta * t620;
    const float t624 = sin_theta * t620;
    const float t626 = motion->constants[4] * t292;
    const float t628 = motion->constants[4] * t288;
    const float t633 = (t162 * t620) + (t571 * t622) - (t574 * t624) - (t21 * t626) - (t24 * t628);
    const float t635 = cos_theta * t325;
    const float t637 = motion->constants[10] * t337;
    const float t638 = t637 - motion->constants[7];
    const float t640 = (cos_phi * t598) + (sin_phi * t638);
    const float t645 = cos_theta * motion->constants[10] * t342;
    const float t649 = (cos_phi * cos_theta * t548) + (sin_phi * t645) - (sin_theta * t640);
    const float t655 = (t570 * t649) - (t21 * t542) - (cos_phi * t593) - (sin_phi * t618) - (t77 *
        t633) - (t635 * t640);
    const float t661 = t645 - (sin_theta * t638);
    const float t668 = (t570 * t661) - t618 - (t24 * t542) - (t239 * t633) - (t635 * t638) - (t243 *
        t655);
    const float t672 = t645 - (sin_theta * t637);
    const float t680 = (t570 * t672) - t617 - t633 - (t635 * t637) - (t265 * t655) - (t270 * t668);
    const float t681 = t285 * t680;
    const float t683 = (t251 * t668) - (t270 * t681);
    const float t687 = (t83 * t655) - (t243 * t683) - (t265 * t681);
    const float t700 = (cos_theta * (t216 + (motion->constants[11] * t328) +
        (motion->constants[13] * t306) - (motion->constants[9] * t314))) - (sin_theta * (t226 +
        (motion->constants[11] * t344) - (motion->constants[12] * t295)));
    const float t713 = t171 + t541 + (motion->constants[8] * t314) + (motion->constants[4] * t325) -
        (motion->constants[7] * t328) - (motion->constants[9] * t306) - (motion->constants[1] *
        t613);
    const float t716 = motion->constants[6] * motion->constants[5];
    const float t718 = t394 + t716 + t716;
    const float t719 = t718 + t718;
    const float t723 = t3 * motion->constants[1];
    const float t727 = sin_theta * t292;
    const float t731 = speeds[0] * sin_theta;
    const float t736 = (cos_theta * t292) - (speeds[1] * t731);
    const float t738 = speeds[0] * cos_theta;
    const float t743 = motion->constants[13] * t738;
    const float t748 = (t557 * t727) + (cos_theta * ((t117 * motion->constants[12]) - t213) *
        t731) + (t559 * t736);
    const float t751 = t748 + (t738 * ((speeds[1] * t557) + (sin_theta * t213))) - (speeds[0] *
        t544 * (t89 + t723)) - (t308 * t743);
    const float t756 = speeds[0] * motion->constants[1];
    const float t760 = motion->constants[1] * t292;
    const float t761 = sin_theta * t760;
    const float t767 = speeds[0] * motion->constants[9];
    const float t769 = motion->constants[8] + motion->constants[4];
    const float t775 = (t548 * t761) + (speeds[0] * ((cos_theta * t165) - (sin_theta * t169))) +
        (t308 * t767) + (speeds[0] * t145 * (motion->constants[4] + t769));
    const float t780 = t29 * t137;
    const float t783 = t345 + (t95 * t95);
    const float t786 = t126 - t297;
    const float t787 = t786 + t786;
    const float t789 = t362 - t119;
    const float t790 = t789 + t789;
    const float t806 = (motion->constants[6] * t117) - (speeds[1] * motion->constants[6]);
    const float t807 = t731 * t806;
    const float t809 = t738 * t806;
    const float t813 = (t29 * t134) + (speeds[0] * t567 * ((motion->constants[1] * t105) - t723)) +
        (t569 * t807) + (t573 * t809);
    const float t820 = speeds[0] * t89;
    const float t824 = t820 + (t114 * t756);
    const float t827 = (sin_theta * t824) + (speeds[0] * t99);
    const float t831 = (cos_theta * t824) + (speeds[0] * t96);
    const float t837 = t40 * ((t29 * t112) + (t569 * t827) + (t573 * t831) - (t563 * t820) - (t564 *
        t756));
    const float t839 = (t573 * t790) + (t32 * (t813 - (motion->constants[6] * t780) - (t567 * t731 *
        (t99 + t99)) - (t567 * t738 * (t96 + t96))));
    const float t844 = t839 + (t35 * t580) + (t43 * t582) - (t27 * t780) - (t567 * (t783 + t783)) -
        (t569 * t787);
    const float t845 = t844 - t837;
    const float t850 = (t299 * t719) + (t310 * t719) + (motion->constants[7] * t319) + (t32 *
        (t751 - (motion->constants[9] * t145 * t738))) + (t35 * t552);
    const float t853 = t850 + (t43 * t554) + (t562 * t845) - (t40 * (t775 - (t58 * t292) - (t544 *
        (motion->constants[14] + (t87 * t756)))));
    const float t864 = (t731 * (t169 - (t95 * motion->constants[12]))) + (t98 * t743) -
        (motion->constants[9] * t736) - (t165 * t738);
    const float t871 = t117 * motion->constants[11];
    const float t879 = t32 * ((t731 * (t871 + (motion->constants[7] * t95))) +
        (motion->constants[11] * t736) + (t177 * t738));
    const float t896 = t32 * ((t738 * (t871 - (speeds[1] * motion->constants[11]))) -
        (motion->constants[11] * t727) - (t731 * (t177 + t177)));
    const float t904 = t896 + (t40 * ((motion->constants[10] * t761) + (speeds[0] * (t179 +
        t181)))) - (t598 * t845);
    const float t906 = (t337 * ((t548 * t845) - t879 - (t40 * ((motion->constants[7] * t292) -
        (speeds[0] * t189))))) + (t342 * t904);
    const float t910 = (t32 * t864) + (t595 * t845) - (motion->constants[7] * t335) - (t40 *
        ((t292 * t769) - (t98 * t767))) - t906;
    const float t929 = (t35 * t626) + (t43 * t628) - (t622 * t787) - (t624 * t790) - (t32 * ((t624 *
        t809) - (t622 * t807))) - (t40 * (t626 + (t622 * t827) - (t624 * t831)));
    const float t932 = t40 * cos_theta * t760;
    const float t936 = (t32 * motion->constants[14]) + (t40 * t824);
    const float t939 = motion->constants[2] + motion->constants[5] + motion->constants[5];
    const float t945 = (t35 * t542) + (t40 * t713) + (t640 * t932) - (t32 * t700) - (cos_phi *
        t853) - (sin_phi * t910);
    const float t948 = t945 - (t77 * t929) - (t649 * t936) - (t367 * t939);
    const float t954 = t365 * t939;
    const float t960 = (t43 * t542) + (t638 * t932) - t910 - (t239 * t929) - (t661 * t936) - t954;
    const float t961 = t960 - (t243 * t948);
    const float t972 = t906 + (t40 * t626) + (t637 * t932) - t929 - t954 - (t672 * t936);
    const float t975 = t285 * (t972 - (t265 * t948) - (t270 * t961));
    const float t977 = (t251 * t961) - (t270 * t975);
    const float t981 = (t83 * t948) - (t243 * t977) - (t265 * t975);
    const float t985 = (sin_phi * cos_phi * t544) - (cos_phi * t649);
    const float t989 = (cos_phi * t661) + (t243 * t985);
    const float t996 = t285 * ((t270 * t989) - (cos_phi * t672) - (t265 * t985));
    const float t998 = (t251 * t989) + (t270 * t996);
    const float t1002 = (t83 * t985) + (t243 * t998) - (t265 * t996);
    const float t1003 = -(t3 * cos_psi);
    const float t1004 = -(t3 * sin_psi);
    const float t1005 = -((speeds[0] * t21) + (speeds[1] * t24));
    const float t1006 = -((t83 * t370) + (t243 * t384) + (t265 * t382));
    const float t1007 = -((t83 * t433) + (t243 * t443) + (t265 * t441));
    const float t1008 = -((t83 * t450) + (t243 * t460) + (t265 * t458));
    const float t1009 = -((t83 * t478) + (t243 * t491) + (t265 * t489));
    const float t1010 = -((t83 * t506) + (t243 * t520) + (t265 * t518));
    const float t1011 = -((t83 * t527) + (t243 * t536) + (t265 * t534));
    const float t1012 = -t425;
    const float t1013 = -t998;
    by_parameters[0][0] = 0.0F;
    by_parameters[0][1] = 0.0F;
    by_parameters[0][2] = 0.0F;
    by_parameters[0][3] = 0.0F;
    by_parameters[0][4] = 0.0F;
    by_parameters[0][5] = 0.0F;
    by_parameters[0][6] = 0.0F;
    by_parameters[0][7] = t1003;
    by_parameters[0][8] = 0.0F;
    by_parameters[0][9] = 0.0F;
    by_parameters[1][0] = 0.0F;
    by_parameters[1][1] = 0.0F;
    by_parameters[1][2] = 0.0F;
    by_parameters[1][3] = 0.0F;
    by_parameters[1][4] = 0.0F;
    by_parameters[1][5] = 0.0F;
    by_parameters[1][6] = 0.0F;
    by_parameters[1][7] = t1004;
    by_parameters[1][8] = 0.0F;
    by_parameters[1][9] = 0.0F;
    by_parameters[2][0] = 0.0F;
    by_parameters[2][1] = 0.0F;
    by_parameters[2][2] = 0.0F;
    by_parameters[2][3] = 0.0F;
    by_parameters[2][4] = 0.0F;
    by_parameters[2][5] = 0.0F;
    by_parameters[2][6] = 0.0F;
    by_parameters[2][7] = 0.0F;
    by_parameters[2][8] = 0.0F;
    by_parameters[2][9] = 0.0F;
    by_parameters[3][0] = 0.0F;
    by_parameters[3][1] = 0.0F;
    by_parameters[3][2] = 0.0F;
    by_parameters[3][3] = 0.0F;
    by_parameters[3][4] = 0.0F;
    by_parameters[3][5] = 0.0F;
    by_parameters[3][6] = 0.0F;
    by_parameters[3][7] = 0.0F;
    by_parameters[3][8] = 0.0F;
    by_parameters[3][9] = 0.0F;
    by_parameters[4][0] = 0.0F;
    by_parameters[4][1] = 0.0F;
    by_parameters[4][2] = 0.0F;
    by_parameters[4][3] = 0.0F;
    by_parameters[4][4] = 0.0F;
    by_parameters[4][5] = 0.0F;
    by_parameters[4][6] = 0.0F;
    by_parameters[4][7] = 0.0F;
    by_parameters[4][8] = 0.0F;
    by_parameters[4][9] = 0.0F;
    by_parameters[5][0] = 0.0F;
    by_parameters[5][1] = 0.0F;
    by_parameters[5][2] = 0.0F;
    by_parameters[5][3] = 0.0F;
    by_parameters[5][4] = 0.0F;
    by_parameters[5][5] = 0.0F;
    by_parameters[5][6] = 0.0F;
    by_parameters[5][7] = 0.0F;
    by_parameters[5][8] = 0.0F;
    by_parameters[5][9] = 0.0F;
    by_parameters[6][0] = 0.0F;
    by_parameters[6][1] = 0.0F;
    by_parameters[6][2] = 0.0F;
    by_parameters[6][3] = 0.0F;
    by_parameters[6][4] = 0.0F;
    by_parameters[6][5] = 0.0F;
    by_parameters[6][6] = 0.0F;
    by_parameters[6][7] = t1005;
    by_parameters[6][8] = t45;
    by_parameters[6][9] = 0.0F;
    by_parameters[7][0] = t1006;
    by_parameters[7][1] = t429;
    by_parameters[7][2] = t1007;
    by_parameters[7][3] = t1008;
    by_parameters[7][4] = t1009;
    by_parameters[7][5] = t1010;
    by_parameters[7][6] = t1011;
    by_parameters[7][7] = t687;
    by_parameters[7][8] = t981;
    by_parameters[7][9] = t1002;
    by_parameters[8][0] = t384;
    by_parameters[8][1] = t1012;
    by_parameters[8][2] = t443;
    by_parameters[8][3] = t460;
    by_parameters[8][4] = t491;
    by_parameters[8][5] = t520;
    by_parameters[8][6] = t536;
    by_parameters[8][7] = t683;
    by_parameters[8][8] = t977;
    by_parameters[8][9] = t1013;
    by_parameters[9][0] = t382;
    by_parameters[9][1] = t423;
    by_parameters[9][2] = t441;
    by_parameters[9][3] = t458;
    by_parameters[9][4] = t489;
    by_parameters[9][5] = t518;
    by_parameters[9][6] = t534;
    by_parameters[9][7] = t681;
    by_parameters[9][8] = t975;
    by_parameters[9][9] = t996;
}

carvallo_motion_error_t wheeled_pendulum_f32_motion_by_parameters(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES],
    float by_parameters[WHEELED_PENDULUM_STATES][WHEELED_PENDULUM_PARAMETERS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, WHEELED_PENDULUM_POSITIONS) &&
        carvallo_are_finite_f32(speeds, WHEELED_PENDULUM_SPEEDS) && carvallo_are_finite_f32(forces,
        WHEELED_PENDULUM_FORCES)) {
        bool are_finite = true;
        wheeled_pendulum_f32_compute_by_parameters(motion, positions, speeds, forces,
            by_parameters);
        for (size_t row = 0U; row < WHEELED_PENDULUM_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f32(by_parameters[row],
                WHEELED_PENDULUM_PARAMETERS);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}
