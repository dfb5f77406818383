/* @generated from generated/models/skateboard.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 0f4f8539b65fdea9
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * pitch_by_vertical = 1/L [1/m]
 * deltaF_by_gamma = -1/cos(lamF) [1]
 * deltaR_by_gamma = -1/cos(lamR) [1]
 * yaw_per_v_deltaF = -sin(lamF)/L [1/m]
 * lateral_per_v_deltaR = sin(lamR) [1]
 * yaw_per_v_deltaR = -pitch_by_vertical*lateral_per_v_deltaR [1/m]
 * Jxx_all = m*(r + h)^2 + Ixx [kg*m^2]
 * Jxz_all = m*x*(r + h) + Ixz [kg*m^2]
 * Sx_all = m*x [kg*m]
 * Sz_all = -m*(r + h) [kg*m]
 * P_gamma_lateral = m*h [kg*m]
 * P_gamma_yaw = Jxz_all - r*Sx_all [kg*m^2]
 * P_gamma_gamma = r*Sz_all + Jxx_all [kg*m^2]
 * M_11 = P_gamma_gamma - r*P_gamma_lateral [kg*m^2]
 * C1_11 = deltaR_by_gamma*lateral_per_v_deltaR*P_gamma_lateral + P_gamma_yaw*(deltaF_by_gamma*yaw_per_v_deltaF + deltaR_by_gamma*yaw_per_v_deltaR) [kg*m]
 * Kc_11 = kF*deltaF_by_gamma^2 + kR*deltaR_by_gamma^2 [kg*m^2/s^2]
 * K0_11 = -P_gamma_lateral [kg*m]
 * K2_11 = P_gamma_lateral*(deltaF_by_gamma*yaw_per_v_deltaF + deltaR_by_gamma*yaw_per_v_deltaR) [kg]
 * @endverbatim
 */

#include "skateboard.h"

#include "carvallo_trig.h"

#include <float.h>

const char *skateboard_set_name(skateboard_set_t set)
{
    static const char *const TEXTS[] = {
        "example",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *skateboard_validity_text(skateboard_validity_t validity)
{
    static const char *const TEXTS[] = {
        "Skateboard: the parameters are valid",
        "Skateboard: L in m must be finite and > 0",
        "Skateboard: b in m must be finite and > 0",
        "Skateboard: r in m must be finite and > 0",
        "Skateboard: lamF in rad must be finite and > 0 and < 1.5707963267948966",
        "Skateboard: lamR in rad must be finite and > 0 and < 1.5707963267948966",
        "Skateboard: kF in N*m must be finite and >= 0",
        "Skateboard: kR in N*m must be finite and >= 0",
        "Skateboard: m in kg must be finite and > 0",
        "Skateboard: x in m must be finite",
        "Skateboard: h in m must be finite",
        "Skateboard: Ixx in kg*m^2 must be finite and >= 0",
        "Skateboard: Iyy in kg*m^2 must be finite and >= 0",
        "Skateboard: Izz in kg*m^2 must be finite and >= 0",
        "Skateboard: Ixz in kg*m^2 must be finite",
        "Skateboard: g in N/kg must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t skateboard_partials[SKATEBOARD_PARTIALS] = {
    {CARVALLO_MATRIX_C1, 0U, 0U, 0U, 12U, true},
    {CARVALLO_MATRIX_K2, 0U, 0U, 0U, 19U, true},
    {CARVALLO_MATRIX_C1, 0U, 0U, 3U, 16U, false},
    {CARVALLO_MATRIX_KC, 0U, 0U, 3U, 13U, false},
    {CARVALLO_MATRIX_K2, 0U, 0U, 3U, 17U, false},
    {CARVALLO_MATRIX_C1, 0U, 0U, 4U, 8U, false},
    {CARVALLO_MATRIX_KC, 0U, 0U, 4U, 9U, false},
    {CARVALLO_MATRIX_K2, 0U, 0U, 4U, 10U, false},
    {CARVALLO_MATRIX_KC, 0U, 0U, 5U, 6U, false},
    {CARVALLO_MATRIX_KC, 0U, 0U, 6U, 5U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 7U, 3U, false},
    {CARVALLO_MATRIX_C1, 0U, 0U, 7U, 18U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 7U, 1U, true},
    {CARVALLO_MATRIX_K2, 0U, 0U, 7U, 14U, false},
    {CARVALLO_MATRIX_C1, 0U, 0U, 8U, 15U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 9U, 4U, false},
    {CARVALLO_MATRIX_C1, 0U, 0U, 9U, 20U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 9U, 0U, true},
    {CARVALLO_MATRIX_K2, 0U, 0U, 9U, 11U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 10U, 2U, false},
    {CARVALLO_MATRIX_C1, 0U, 0U, 13U, 7U, false}
};

const skateboard_f64_t skateboard_f64_sets[SKATEBOARD_SETS] = {
    { /* example */
        .L = 0.8,
        .b = 0.1,
        .r = 0.03,
        .lamF = 0.7853981633974483,
        .lamR = 0.7853981633974483,
        .kF = 50.0,
        .kR = 50.0,
        .m = 75.0,
        .x = 0.42,
        .h = 0.9,
        .Ixx = 9.0,
        .Iyy = 9.0,
        .Izz = 1.0,
        .Ixz = 0.0,
        .g = 9.81
    }
};

skateboard_validity_t skateboard_f64_validate(const skateboard_f64_t *p)
{
    skateboard_validity_t validity = SKATEBOARD_VALID;
    if (!((p->L > 0.0) && (p->L <= DBL_MAX))) {
        validity = SKATEBOARD_INVALID_L;
    } else if (!((p->b > 0.0) && (p->b <= DBL_MAX))) {
        validity = SKATEBOARD_INVALID_b;
    } else if (!((p->r > 0.0) && (p->r <= DBL_MAX))) {
        validity = SKATEBOARD_INVALID_r;
    } else if (!((p->lamF > 0.0) && (p->lamF < 1.5707963267948966))) {
        validity = SKATEBOARD_INVALID_lamF;
    } else if (!((p->lamR > 0.0) && (p->lamR < 1.5707963267948966))) {
        validity = SKATEBOARD_INVALID_lamR;
    } else if (!((p->kF >= 0.0) && (p->kF <= DBL_MAX))) {
        validity = SKATEBOARD_INVALID_kF;
    } else if (!((p->kR >= 0.0) && (p->kR <= DBL_MAX))) {
        validity = SKATEBOARD_INVALID_kR;
    } else if (!((p->m > 0.0) && (p->m <= DBL_MAX))) {
        validity = SKATEBOARD_INVALID_m;
    } else if (!((p->x >= -DBL_MAX) && (p->x <= DBL_MAX))) {
        validity = SKATEBOARD_INVALID_x;
    } else if (!((p->h >= -DBL_MAX) && (p->h <= DBL_MAX))) {
        validity = SKATEBOARD_INVALID_h;
    } else if (!((p->Ixx >= 0.0) && (p->Ixx <= DBL_MAX))) {
        validity = SKATEBOARD_INVALID_Ixx;
    } else if (!((p->Iyy >= 0.0) && (p->Iyy <= DBL_MAX))) {
        validity = SKATEBOARD_INVALID_Iyy;
    } else if (!((p->Izz >= 0.0) && (p->Izz <= DBL_MAX))) {
        validity = SKATEBOARD_INVALID_Izz;
    } else if (!((p->Ixz >= -DBL_MAX) && (p->Ixz <= DBL_MAX))) {
        validity = SKATEBOARD_INVALID_Ixz;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = SKATEBOARD_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void skateboard_f64_matrices(const skateboard_f64_t *p, skateboard_f64_matrices_t *matrices)
{
    const double P_gamma_lateral = p->h * p->m;
    const double M_11 = p->Ixx + (p->h * P_gamma_lateral);
    double lateral_per_v_deltaR = 0.0;
    double cos_lamR = 0.0;
    carvallo_sin_cos_f64(p->lamR, &lateral_per_v_deltaR, &cos_lamR);
    const double t8 = 1.0 / cos_lamR;
    const double t10 = t8 * lateral_per_v_deltaR;
    const double P_gamma_yaw = p->Ixz + (P_gamma_lateral * p->x);
    double sin_lamF = 0.0;
    double cos_lamF = 0.0;
    carvallo_sin_cos_f64(p->lamF, &sin_lamF, &cos_lamF);
    const double t18 = 1.0 / cos_lamF;
    const double t21 = 1.0 / p->L;
    const double t25 = (t18 * sin_lamF * t21) + (t10 * t21);
    const double C1_11 = (P_gamma_yaw * t25) - (P_gamma_lateral * t10);
    const double Kc_11 = (t18 * t18 * p->kF) + (t8 * t8 * p->kR);
    const double K2_11 = P_gamma_lateral * t25;
    const double K0_11 = -P_gamma_lateral;
    matrices->m[0][0] = M_11;
    matrices->c1[0][0] = C1_11;
    matrices->kc[0][0] = Kc_11;
    matrices->k0[0][0] = K0_11;
    matrices->k2[0][0] = K2_11;
}

carvallo_system_error_t skateboard_f64_at_speed(const skateboard_f64_matrices_t *matrices,
    double speed, double gravity, skateboard_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed) && carvallo_is_finite_f64(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < SKATEBOARD_N; row++) {
        for (size_t column = 0U; column < SKATEBOARD_N; column++) {
            const double damping = matrices->c1[row][column] * speed;
            const double stiffness = matrices->kc[row][column] + (matrices->k0[row][column] *
                gravity) + (matrices->k2[row][column] * speed * speed);
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->c1[row][column]) &&
                carvallo_is_finite_f64(matrices->kc[row][column]) &&
                carvallo_is_finite_f64(matrices->k0[row][column]) &&
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

carvallo_system_error_t skateboard_f64_state_space(const skateboard_f64_system_t *system,
    skateboard_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[SKATEBOARD_N * SKATEBOARD_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * SKATEBOARD_N * SKATEBOARD_N];
    for (size_t row = 0U; row < SKATEBOARD_N; row++) {
        double *const solved = &x[3U * SKATEBOARD_N * row];
        for (size_t column = 0U; column < SKATEBOARD_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * SKATEBOARD_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[SKATEBOARD_N + column] = -system->c[row][column];
            solved[(2U * SKATEBOARD_N) + column] = 0.0;
        }
        solved[(2U * SKATEBOARD_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[SKATEBOARD_N * SKATEBOARD_N];
        error = carvallo_solve_f64(SKATEBOARD_N, m, terms, 3U * SKATEBOARD_N, x);
    }
    for (size_t row = 0U; row < (2U * SKATEBOARD_N); row++) {
        for (size_t column = 0U; column < (2U * SKATEBOARD_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < SKATEBOARD_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < SKATEBOARD_N; row++) {
            const size_t target = SKATEBOARD_N + row;
            for (size_t column = 0U; column < (2U * SKATEBOARD_N); column++) {
                space->a[target][column] = x[(3U * SKATEBOARD_N * row) + column];
            }
            for (size_t column = 0U; column < SKATEBOARD_N; column++) {
                space->b[target][column] = x[(3U * SKATEBOARD_N * row) + (2U * SKATEBOARD_N) +
                    column];
            }
            space->a[row][SKATEBOARD_N + row] = 1.0;
        }
    }
    return error;
}

double skateboard_f64_rate_at(const skateboard_f64_rate_t *rate, double v,
    const double q[SKATEBOARD_N], const double q_dot[SKATEBOARD_N], double psi)
{
    double by_coordinates = 0.0;
    double by_rates = 0.0;
    for (size_t i = 0U; i < SKATEBOARD_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void skateboard_f64_kinematics(const skateboard_f64_t *p, skateboard_f64_kinematics_t *kinematics)
{
    double lateral_per_v_deltaR = 0.0;
    double cos_lamR = 0.0;
    carvallo_sin_cos_f64(p->lamR, &lateral_per_v_deltaR, &cos_lamR);
    const double t4 = 1.0 / cos_lamR;
    const double t6 = t4 * lateral_per_v_deltaR;
    double sin_lamF = 0.0;
    double cos_lamF = 0.0;
    carvallo_sin_cos_f64(p->lamF, &sin_lamF, &cos_lamF);
    const double t11 = 1.0 / cos_lamF;
    const double t13 = t11 * sin_lamF;
    const double t15 = (t6 + t13) / p->L;
    const double t16 = 1.0 / p->r;
    const double t18 = t16 * p->b;
    const double t19 = t13 * t18;
    const double t20 = t15 * t18;
    const double spin_RL_by_gamma = t6 * t18;
    const double t22 = -p->r;
    const double t23 = -t6;
    const double t24 = -t11;
    const double t25 = -t4;
    const double t26 = -t16;
    const double t27 = -t19;
    const double t28 = -t20;
    const double t29 = -spin_RL_by_gamma;
    kinematics->lateral.speed = 0.0;
    kinematics->lateral.rates[0] = t22;
    kinematics->lateral.coordinates[0] = t23;
    kinematics->lateral.heading = 1.0;
    kinematics->yaw.speed = 0.0;
    kinematics->yaw.rates[0] = 0.0;
    kinematics->yaw.coordinates[0] = t15;
    kinematics->yaw.heading = 0.0;
    kinematics->deltaF.speed = 0.0;
    kinematics->deltaF.rates[0] = t24;
    kinematics->deltaF.coordinates[0] = 0.0;
    kinematics->deltaF.heading = 0.0;
    kinematics->deltaR.speed = 0.0;
    kinematics->deltaR.rates[0] = t25;
    kinematics->deltaR.coordinates[0] = 0.0;
    kinematics->deltaR.heading = 0.0;
    kinematics->wheel_FL.speed = t26;
    kinematics->wheel_FL.rates[0] = t27;
    kinematics->wheel_FL.coordinates[0] = t28;
    kinematics->wheel_FL.heading = 0.0;
    kinematics->wheel_FR.speed = t26;
    kinematics->wheel_FR.rates[0] = t19;
    kinematics->wheel_FR.coordinates[0] = t20;
    kinematics->wheel_FR.heading = 0.0;
    kinematics->wheel_RL.speed = t26;
    kinematics->wheel_RL.rates[0] = spin_RL_by_gamma;
    kinematics->wheel_RL.coordinates[0] = t28;
    kinematics->wheel_RL.heading = 0.0;
    kinematics->wheel_RR.speed = t26;
    kinematics->wheel_RR.rates[0] = t29;
    kinematics->wheel_RR.coordinates[0] = t20;
    kinematics->wheel_RR.heading = 0.0;
    kinematics->forces[0][0] = 1.0;
}

void skateboard_f64_derivatives(const skateboard_f64_t *p, skateboard_f64_matrices_t *matrices,
    skateboard_f64_derivatives_t *derivatives)
{
    double lateral_per_v_deltaR = 0.0;
    double cos_lamR = 0.0;
    carvallo_sin_cos_f64(p->lamR, &lateral_per_v_deltaR, &cos_lamR);
    double sin_lamF = 0.0;
    double cos_lamF = 0.0;
    carvallo_sin_cos_f64(p->lamF, &sin_lamF, &cos_lamF);
    const double M_11_m = p->h * p->h;
    const double M_11 = p->Ixx + (p->m * M_11_m);
    const double t18 = 1.0 / p->L;
    const double P_gamma_lateral = p->m * p->h;
    const double M_11_h = P_gamma_lateral + P_gamma_lateral;
    const double K0_11 = -P_gamma_lateral;
    const double t24 = t18 * (p->Ixz + (p->x * P_gamma_lateral));
    const double t25 = t18 * P_gamma_lateral;
    const double t26 = 1.0 / cos_lamR;
    const double t27 = 1.0 / cos_lamF;
    const double t28 = t26 * lateral_per_v_deltaR;
    const double Kc_11_kR = t26 * t26;
    const double t30 = p->kR * Kc_11_kR;
    const double t32 = 1.0 + (t28 * t28);
    const double t33 = t27 * sin_lamF;
    const double Kc_11_kF = t27 * t27;
    const double t35 = t28 * t30;
    const double C1_11_Ixz = t18 * (t28 + t33);
    const double t38 = p->kF * Kc_11_kF;
    const double t41 = t27 * (cos_lamF + (sin_lamF * t33));
    const double C1_11_lamR = t32 * (t24 - P_gamma_lateral);
    const double Kc_11_lamR = t35 + t35;
    const double K2_11_lamR = t25 * t32;
    const double Kc_11 = t38 + t30;
    const double t47 = t33 * t38;
    const double t49 = (p->x * C1_11_Ixz) - t28;
    const double K2_11_h = p->m * C1_11_Ixz;
    const double t51 = C1_11_Ixz * t24;
    const double Kc_11_lamF = t47 + t47;
    const double K2_11_m = p->h * C1_11_Ixz;
    const double K2_11 = p->h * K2_11_h;
    const double C1_11_lamF = t24 * t41;
    const double K2_11_lamF = t41 * t25;
    const double C1_11_m = p->h * t49;
    const double t58 = t18 * K2_11;
    const double C1_11_h = p->m * t49;
    const double C1_11 = (p->m * C1_11_m) + (C1_11_Ixz * p->Ixz);
    matrices->m[0][0] = M_11;
    matrices->c1[0][0] = C1_11;
    matrices->kc[0][0] = Kc_11;
    matrices->k0[0][0] = K0_11;
    matrices->k2[0][0] = K2_11;
    derivatives->values[0] = p->m;
    derivatives->values[1] = p->h;
    derivatives->values[2] = 1.0;
    derivatives->values[3] = M_11_m;
    derivatives->values[4] = M_11_h;
    derivatives->values[5] = Kc_11_kR;
    derivatives->values[6] = Kc_11_kF;
    derivatives->values[7] = C1_11_Ixz;
    derivatives->values[8] = C1_11_lamR;
    derivatives->values[9] = Kc_11_lamR;
    derivatives->values[10] = K2_11_lamR;
    derivatives->values[11] = K2_11_h;
    derivatives->values[12] = t51;
    derivatives->values[13] = Kc_11_lamF;
    derivatives->values[14] = K2_11_m;
    derivatives->values[15] = K2_11;
    derivatives->values[16] = C1_11_lamF;
    derivatives->values[17] = K2_11_lamF;
    derivatives->values[18] = C1_11_m;
    derivatives->values[19] = t58;
    derivatives->values[20] = C1_11_h;
}

void skateboard_f64_with_respect_to(const skateboard_f64_derivatives_t *derivatives,
    size_t parameter, skateboard_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < SKATEBOARD_N; row++) {
        for (size_t column = 0U; column < SKATEBOARD_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->kc[row][column] = 0.0;
            matrices->k0[row][column] = 0.0;
            matrices->k2[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < SKATEBOARD_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &skateboard_partials[position];
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
            case CARVALLO_MATRIX_KC:
                matrices->kc[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_K0:
                matrices->k0[partial->row][partial->column] = signed_value;
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

const skateboard_f32_t skateboard_f32_sets[SKATEBOARD_SETS] = {
    { /* example */
        .L = 0.8F,
        .b = 0.1F,
        .r = 0.03F,
        .lamF = 0.7853982F,
        .lamR = 0.7853982F,
        .kF = 50.0F,
        .kR = 50.0F,
        .m = 75.0F,
        .x = 0.42F,
        .h = 0.9F,
        .Ixx = 9.0F,
        .Iyy = 9.0F,
        .Izz = 1.0F,
        .Ixz = 0.0F,
        .g = 9.81F
    }
};

skateboard_validity_t skateboard_f32_validate(const skateboard_f32_t *p)
{
    skateboard_validity_t validity = SKATEBOARD_VALID;
    if (!((p->L > 0.0F) && (p->L <= FLT_MAX))) {
        validity = SKATEBOARD_INVALID_L;
    } else if (!((p->b > 0.0F) && (p->b <= FLT_MAX))) {
        validity = SKATEBOARD_INVALID_b;
    } else if (!((p->r > 0.0F) && (p->r <= FLT_MAX))) {
        validity = SKATEBOARD_INVALID_r;
    } else if (!((p->lamF > 0.0F) && (p->lamF < 1.5707964F))) {
        validity = SKATEBOARD_INVALID_lamF;
    } else if (!((p->lamR > 0.0F) && (p->lamR < 1.5707964F))) {
        validity = SKATEBOARD_INVALID_lamR;
    } else if (!((p->kF >= 0.0F) && (p->kF <= FLT_MAX))) {
        validity = SKATEBOARD_INVALID_kF;
    } else if (!((p->kR >= 0.0F) && (p->kR <= FLT_MAX))) {
        validity = SKATEBOARD_INVALID_kR;
    } else if (!((p->m > 0.0F) && (p->m <= FLT_MAX))) {
        validity = SKATEBOARD_INVALID_m;
    } else if (!((p->x >= -FLT_MAX) && (p->x <= FLT_MAX))) {
        validity = SKATEBOARD_INVALID_x;
    } else if (!((p->h >= -FLT_MAX) && (p->h <= FLT_MAX))) {
        validity = SKATEBOARD_INVALID_h;
    } else if (!((p->Ixx >= 0.0F) && (p->Ixx <= FLT_MAX))) {
        validity = SKATEBOARD_INVALID_Ixx;
    } else if (!((p->Iyy >= 0.0F) && (p->Iyy <= FLT_MAX))) {
        validity = SKATEBOARD_INVALID_Iyy;
    } else if (!((p->Izz >= 0.0F) && (p->Izz <= FLT_MAX))) {
        validity = SKATEBOARD_INVALID_Izz;
    } else if (!((p->Ixz >= -FLT_MAX) && (p->Ixz <= FLT_MAX))) {
        validity = SKATEBOARD_INVALID_Ixz;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = SKATEBOARD_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void skateboard_f32_matrices(const skateboard_f32_t *p, skateboard_f32_matrices_t *matrices)
{
    const float P_gamma_lateral = p->h * p->m;
    const float M_11 = p->Ixx + (p->h * P_gamma_lateral);
    float lateral_per_v_deltaR = 0.0F;
    float cos_lamR = 0.0F;
    carvallo_sin_cos_f32(p->lamR, &lateral_per_v_deltaR, &cos_lamR);
    const float t8 = 1.0F / cos_lamR;
    const float t10 = t8 * lateral_per_v_deltaR;
    const float P_gamma_yaw = p->Ixz + (P_gamma_lateral * p->x);
    float sin_lamF = 0.0F;
    float cos_lamF = 0.0F;
    carvallo_sin_cos_f32(p->lamF, &sin_lamF, &cos_lamF);
    const float t18 = 1.0F / cos_lamF;
    const float t21 = 1.0F / p->L;
    const float t25 = (t18 * sin_lamF * t21) + (t10 * t21);
    const float C1_11 = (P_gamma_yaw * t25) - (P_gamma_lateral * t10);
    const float Kc_11 = (t18 * t18 * p->kF) + (t8 * t8 * p->kR);
    const float K2_11 = P_gamma_lateral * t25;
    const float K0_11 = -P_gamma_lateral;
    matrices->m[0][0] = M_11;
    matrices->c1[0][0] = C1_11;
    matrices->kc[0][0] = Kc_11;
    matrices->k0[0][0] = K0_11;
    matrices->k2[0][0] = K2_11;
}

carvallo_system_error_t skateboard_f32_at_speed(const skateboard_f32_matrices_t *matrices,
    float speed, float gravity, skateboard_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed) && carvallo_is_finite_f32(gravity);
    bool is_in_range = true;
    for (size_t row = 0U; row < SKATEBOARD_N; row++) {
        for (size_t column = 0U; column < SKATEBOARD_N; column++) {
            const float damping = matrices->c1[row][column] * speed;
            const float stiffness = matrices->kc[row][column] + (matrices->k0[row][column] *
                gravity) + (matrices->k2[row][column] * speed * speed);
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->c1[row][column]) &&
                carvallo_is_finite_f32(matrices->kc[row][column]) &&
                carvallo_is_finite_f32(matrices->k0[row][column]) &&
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

carvallo_system_error_t skateboard_f32_state_space(const skateboard_f32_system_t *system,
    skateboard_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[SKATEBOARD_N * SKATEBOARD_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * SKATEBOARD_N * SKATEBOARD_N];
    for (size_t row = 0U; row < SKATEBOARD_N; row++) {
        float *const solved = &x[3U * SKATEBOARD_N * row];
        for (size_t column = 0U; column < SKATEBOARD_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * SKATEBOARD_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[SKATEBOARD_N + column] = -system->c[row][column];
            solved[(2U * SKATEBOARD_N) + column] = 0.0F;
        }
        solved[(2U * SKATEBOARD_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[SKATEBOARD_N * SKATEBOARD_N];
        error = carvallo_solve_f32(SKATEBOARD_N, m, terms, 3U * SKATEBOARD_N, x);
    }
    for (size_t row = 0U; row < (2U * SKATEBOARD_N); row++) {
        for (size_t column = 0U; column < (2U * SKATEBOARD_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < SKATEBOARD_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < SKATEBOARD_N; row++) {
            const size_t target = SKATEBOARD_N + row;
            for (size_t column = 0U; column < (2U * SKATEBOARD_N); column++) {
                space->a[target][column] = x[(3U * SKATEBOARD_N * row) + column];
            }
            for (size_t column = 0U; column < SKATEBOARD_N; column++) {
                space->b[target][column] = x[(3U * SKATEBOARD_N * row) + (2U * SKATEBOARD_N) +
                    column];
            }
            space->a[row][SKATEBOARD_N + row] = 1.0F;
        }
    }
    return error;
}

float skateboard_f32_rate_at(const skateboard_f32_rate_t *rate, float v,
    const float q[SKATEBOARD_N], const float q_dot[SKATEBOARD_N], float psi)
{
    float by_coordinates = 0.0F;
    float by_rates = 0.0F;
    for (size_t i = 0U; i < SKATEBOARD_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void skateboard_f32_kinematics(const skateboard_f32_t *p, skateboard_f32_kinematics_t *kinematics)
{
    float lateral_per_v_deltaR = 0.0F;
    float cos_lamR = 0.0F;
    carvallo_sin_cos_f32(p->lamR, &lateral_per_v_deltaR, &cos_lamR);
    const float t4 = 1.0F / cos_lamR;
    const float t6 = t4 * lateral_per_v_deltaR;
    float sin_lamF = 0.0F;
    float cos_lamF = 0.0F;
    carvallo_sin_cos_f32(p->lamF, &sin_lamF, &cos_lamF);
    const float t11 = 1.0F / cos_lamF;
    const float t13 = t11 * sin_lamF;
    const float t15 = (t6 + t13) / p->L;
    const float t16 = 1.0F / p->r;
    const float t18 = t16 * p->b;
    const float t19 = t13 * t18;
    const float t20 = t15 * t18;
    const float spin_RL_by_gamma = t6 * t18;
    const float t22 = -p->r;
    const float t23 = -t6;
    const float t24 = -t11;
    const float t25 = -t4;
    const float t26 = -t16;
    const float t27 = -t19;
    const float t28 = -t20;
    const float t29 = -spin_RL_by_gamma;
    kinematics->lateral.speed = 0.0F;
    kinematics->lateral.rates[0] = t22;
    kinematics->lateral.coordinates[0] = t23;
    kinematics->lateral.heading = 1.0F;
    kinematics->yaw.speed = 0.0F;
    kinematics->yaw.rates[0] = 0.0F;
    kinematics->yaw.coordinates[0] = t15;
    kinematics->yaw.heading = 0.0F;
    kinematics->deltaF.speed = 0.0F;
    kinematics->deltaF.rates[0] = t24;
    kinematics->deltaF.coordinates[0] = 0.0F;
    kinematics->deltaF.heading = 0.0F;
    kinematics->deltaR.speed = 0.0F;
    kinematics->deltaR.rates[0] = t25;
    kinematics->deltaR.coordinates[0] = 0.0F;
    kinematics->deltaR.heading = 0.0F;
    kinematics->wheel_FL.speed = t26;
    kinematics->wheel_FL.rates[0] = t27;
    kinematics->wheel_FL.coordinates[0] = t28;
    kinematics->wheel_FL.heading = 0.0F;
    kinematics->wheel_FR.speed = t26;
    kinematics->wheel_FR.rates[0] = t19;
    kinematics->wheel_FR.coordinates[0] = t20;
    kinematics->wheel_FR.heading = 0.0F;
    kinematics->wheel_RL.speed = t26;
    kinematics->wheel_RL.rates[0] = spin_RL_by_gamma;
    kinematics->wheel_RL.coordinates[0] = t28;
    kinematics->wheel_RL.heading = 0.0F;
    kinematics->wheel_RR.speed = t26;
    kinematics->wheel_RR.rates[0] = t29;
    kinematics->wheel_RR.coordinates[0] = t20;
    kinematics->wheel_RR.heading = 0.0F;
    kinematics->forces[0][0] = 1.0F;
}

void skateboard_f32_derivatives(const skateboard_f32_t *p, skateboard_f32_matrices_t *matrices,
    skateboard_f32_derivatives_t *derivatives)
{
    float lateral_per_v_deltaR = 0.0F;
    float cos_lamR = 0.0F;
    carvallo_sin_cos_f32(p->lamR, &lateral_per_v_deltaR, &cos_lamR);
    float sin_lamF = 0.0F;
    float cos_lamF = 0.0F;
    carvallo_sin_cos_f32(p->lamF, &sin_lamF, &cos_lamF);
    const float M_11_m = p->h * p->h;
    const float M_11 = p->Ixx + (p->m * M_11_m);
    const float t18 = 1.0F / p->L;
    const float P_gamma_lateral = p->m * p->h;
    const float M_11_h = P_gamma_lateral + P_gamma_lateral;
    const float K0_11 = -P_gamma_lateral;
    const float t24 = t18 * (p->Ixz + (p->x * P_gamma_lateral));
    const float t25 = t18 * P_gamma_lateral;
    const float t26 = 1.0F / cos_lamR;
    const float t27 = 1.0F / cos_lamF;
    const float t28 = t26 * lateral_per_v_deltaR;
    const float Kc_11_kR = t26 * t26;
    const float t30 = p->kR * Kc_11_kR;
    const float t32 = 1.0F + (t28 * t28);
    const float t33 = t27 * sin_lamF;
    const float Kc_11_kF = t27 * t27;
    const float t35 = t28 * t30;
    const float C1_11_Ixz = t18 * (t28 + t33);
    const float t38 = p->kF * Kc_11_kF;
    const float t41 = t27 * (cos_lamF + (sin_lamF * t33));
    const float C1_11_lamR = t32 * (t24 - P_gamma_lateral);
    const float Kc_11_lamR = t35 + t35;
    const float K2_11_lamR = t25 * t32;
    const float Kc_11 = t38 + t30;
    const float t47 = t33 * t38;
    const float t49 = (p->x * C1_11_Ixz) - t28;
    const float K2_11_h = p->m * C1_11_Ixz;
    const float t51 = C1_11_Ixz * t24;
    const float Kc_11_lamF = t47 + t47;
    const float K2_11_m = p->h * C1_11_Ixz;
    const float K2_11 = p->h * K2_11_h;
    const float C1_11_lamF = t24 * t41;
    const float K2_11_lamF = t41 * t25;
    const float C1_11_m = p->h * t49;
    const float t58 = t18 * K2_11;
    const float C1_11_h = p->m * t49;
    const float C1_11 = (p->m * C1_11_m) + (C1_11_Ixz * p->Ixz);
    matrices->m[0][0] = M_11;
    matrices->c1[0][0] = C1_11;
    matrices->kc[0][0] = Kc_11;
    matrices->k0[0][0] = K0_11;
    matrices->k2[0][0] = K2_11;
    derivatives->values[0] = p->m;
    derivatives->values[1] = p->h;
    derivatives->values[2] = 1.0F;
    derivatives->values[3] = M_11_m;
    derivatives->values[4] = M_11_h;
    derivatives->values[5] = Kc_11_kR;
    derivatives->values[6] = Kc_11_kF;
    derivatives->values[7] = C1_11_Ixz;
    derivatives->values[8] = C1_11_lamR;
    derivatives->values[9] = Kc_11_lamR;
    derivatives->values[10] = K2_11_lamR;
    derivatives->values[11] = K2_11_h;
    derivatives->values[12] = t51;
    derivatives->values[13] = Kc_11_lamF;
    derivatives->values[14] = K2_11_m;
    derivatives->values[15] = K2_11;
    derivatives->values[16] = C1_11_lamF;
    derivatives->values[17] = K2_11_lamF;
    derivatives->values[18] = C1_11_m;
    derivatives->values[19] = t58;
    derivatives->values[20] = C1_11_h;
}

void skateboard_f32_with_respect_to(const skateboard_f32_derivatives_t *derivatives,
    size_t parameter, skateboard_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < SKATEBOARD_N; row++) {
        for (size_t column = 0U; column < SKATEBOARD_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->kc[row][column] = 0.0F;
            matrices->k0[row][column] = 0.0F;
            matrices->k2[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < SKATEBOARD_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &skateboard_partials[position];
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
            case CARVALLO_MATRIX_KC:
                matrices->kc[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_K0:
                matrices->k0[partial->row][partial->column] = signed_value;
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
