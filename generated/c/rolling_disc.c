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

#include "carvallo_trig.h"

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
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 4U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 7U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 0U, 6U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 0U, 1U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 1U, 5U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 1U, 0U, false},
    {CARVALLO_MATRIX_K0, 0U, 0U, 1U, 0U, true},
    {CARVALLO_MATRIX_C1, 0U, 1U, 2U, 3U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 2U, 3U, true},
    {CARVALLO_MATRIX_M, 0U, 0U, 3U, 2U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 3U, 2U, false}
};

const char *rolling_disc_position_name(rolling_disc_position_t which)
{
    static const char *const TEXTS[] = {
        "x",
        "y",
        "psi",
        "phi",
        "thetaD",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such position";
}

const char *rolling_disc_speed_name(rolling_disc_speed_t which)
{
    static const char *const TEXTS[] = {
        "psi",
        "phi",
        "thetaD",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such speed";
}

const char *rolling_disc_wheel_name(rolling_disc_wheel_t which)
{
    static const char *const TEXTS[] = {
        "D",
    };
    const size_t position = (size_t)which;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such wheel";
}

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
    const double t6 = p->r * p->m;
    const double Jxx_all = p->It + (p->r * t6);
    const double C1_12_Ia = 1.0 / p->r;
    const double M_11_r = t6 + t6;
    const double M_11_m = p->r * p->r;
    const double K0_11 = -t6;
    const double h_spin_D = p->Ia * C1_12_Ia;
    const double C1_12 = t6 + h_spin_D;
    const double C1_21_r = C1_12_Ia * h_spin_D;
    const double C1_21 = -h_spin_D;
    const double C1_12_r = p->m - C1_21_r;
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
    derivatives->values[0] = p->r;
    derivatives->values[1] = p->m;
    derivatives->values[2] = 1.0;
    derivatives->values[3] = C1_12_Ia;
    derivatives->values[4] = M_11_r;
    derivatives->values[5] = M_11_m;
    derivatives->values[6] = C1_21_r;
    derivatives->values[7] = C1_12_r;
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

void rolling_disc_f64_motion(const rolling_disc_f64_t *p, rolling_disc_f64_motion_t *motion)
{
    const double t5 = p->r * p->m;
    const double t6 = p->r * t5;
    const double t7 = p->It + t6;
    const double t8 = p->Ia + t6;
    motion->constants[0] = p->r;
    motion->constants[1] = p->It;
    motion->constants[2] = p->Ia;
    motion->constants[3] = p->m;
    motion->constants[4] = p->g;
    motion->constants[5] = t5;
    motion->constants[6] = t6;
    motion->constants[7] = t7;
    motion->constants[8] = t8;
}

static void rolling_disc_f64_compute_rates(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double rates[ROLLING_DISC_POSITIONS])
{
    const double t2 = motion->constants[0] * speeds[2];
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t10 = -(t2 * cos_psi);
    const double t11 = -(t2 * sin_psi);
    rates[0] = t10;
    rates[1] = t11;
    rates[2] = speeds[0];
    rates[3] = speeds[1];
    rates[4] = speeds[2];
}

carvallo_motion_error_t rolling_disc_f64_motion_rates(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double rates[ROLLING_DISC_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f64(speeds, ROLLING_DISC_SPEEDS)) {
        rolling_disc_f64_compute_rates(motion, positions, speeds, rates);
        error = (carvallo_are_finite_f64(rates, ROLLING_DISC_POSITIONS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void rolling_disc_f64_compute_derivatives(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double rates[ROLLING_DISC_POSITIONS], double speed_rates[ROLLING_DISC_SPEEDS])
{
    const double t2 = motion->constants[0] * speeds[2];
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t13 = speeds[0] * cos_phi;
    const double t15 = speeds[1] * motion->constants[1];
    const double t17 = t13 * motion->constants[1];
    const double t20 = speeds[1] * t13;
    const double t23 = motion->constants[0] * t13;
    const double t27 = motion->constants[0] * motion->constants[3];
    const double t29 = (motion->constants[2] * t20) + (((motion->constants[0] * t20) + (speeds[1] *
        t23)) * t27);
    const double t33 = speeds[0] * sin_phi;
    const double t34 = t15 * t33;
    const double t36 = motion->constants[2] * (speeds[2] + t33);
    const double t41 = (sin_phi * ((t13 * t15) + t29 - (speeds[1] * t17))) + (cos_phi *
        ((speeds[1] * t36) - t34 - t34));
    const double t43 = sin_phi * motion->constants[6];
    const double t47 = sin_phi * motion->constants[2];
    const double t50 = (sin_phi * t43) + (cos_phi * cos_phi * motion->constants[1]) + (sin_phi *
        t47);
    const double t51 = 1.0 / t50;
    const double t54 = t51 * (t43 + t47);
    const double t61 = ((t41 * t54) - t29) / (motion->constants[8] - (t50 * t54 * t54));
    const double t76 = ((t17 * t33) - (t13 * t36) - (t27 * ((speeds[2] * t23) + (t23 * t33) +
        (sin_phi * motion->constants[4])))) / motion->constants[7];
    const double t77 = -(t2 * cos_psi);
    const double t78 = -(t2 * sin_psi);
    const double t79 = -((t41 * t51) + (t54 * t61));
    const double t80 = -t76;
    rates[0] = t77;
    rates[1] = t78;
    rates[2] = speeds[0];
    rates[3] = speeds[1];
    rates[4] = speeds[2];
    speed_rates[0] = t79;
    speed_rates[1] = t80;
    speed_rates[2] = t61;
}

carvallo_motion_error_t rolling_disc_f64_motion_derivatives(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double rates[ROLLING_DISC_POSITIONS], double speed_rates[ROLLING_DISC_SPEEDS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f64(speeds, ROLLING_DISC_SPEEDS)) {
        rolling_disc_f64_compute_derivatives(motion, positions, speeds, rates, speed_rates);
        error = (carvallo_are_finite_f64(rates, ROLLING_DISC_POSITIONS) &&
            carvallo_are_finite_f64(speed_rates, ROLLING_DISC_SPEEDS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void rolling_disc_f64_compute_accelerations(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double accelerations[ROLLING_DISC_POSITIONS])
{
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t7 = speeds[0] * cos_phi;
    const double t9 = t7 * speeds[1];
    const double t12 = motion->constants[0] * t7;
    const double t16 = motion->constants[0] * motion->constants[3];
    const double t18 = (motion->constants[2] * t9) + (((motion->constants[0] * t9) + (speeds[1] *
        t12)) * t16);
    const double t21 = motion->constants[1] * speeds[1];
    const double t23 = t7 * motion->constants[1];
    const double t28 = sin_phi * speeds[0];
    const double t29 = t21 * t28;
    const double t32 = motion->constants[2] * (t28 + speeds[2]);
    const double t37 = (sin_phi * ((t7 * t21) + t18 - (speeds[1] * t23))) + (cos_phi * ((speeds[1] *
        t32) - t29 - t29));
    const double t39 = sin_phi * motion->constants[6];
    const double t40 = sin_phi * motion->constants[2];
    const double t47 = (sin_phi * t39) + (cos_phi * cos_phi * motion->constants[1]) + (sin_phi *
        t40);
    const double t48 = 1.0 / t47;
    const double t49 = (t39 + t40) * t48;
    const double t56 = ((t37 * t49) - t18) / (motion->constants[8] - (t47 * t49 * t49));
    const double t57 = motion->constants[0] * t56;
    const double t61 = motion->constants[0] * speeds[0] * speeds[2];
    const double t63 = (sin_psi * t61) - (cos_psi * t57);
    const double t82 = ((t23 * t28) - (t7 * t32) - (t16 * ((t12 * speeds[2]) + (t12 * t28) +
        (sin_phi * motion->constants[4])))) / motion->constants[7];
    const double t83 = -((t57 * sin_psi) + (cos_psi * t61));
    const double t84 = -((t37 * t48) + (t49 * t56));
    const double t85 = -t82;
    accelerations[0] = t63;
    accelerations[1] = t83;
    accelerations[2] = t84;
    accelerations[3] = t85;
    accelerations[4] = t56;
}

carvallo_motion_error_t rolling_disc_f64_motion_accelerations(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double accelerations[ROLLING_DISC_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f64(speeds, ROLLING_DISC_SPEEDS)) {
        rolling_disc_f64_compute_accelerations(motion, positions, speeds, accelerations);
        error = (carvallo_are_finite_f64(accelerations, ROLLING_DISC_POSITIONS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void rolling_disc_f64_compute_energy(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double energy[2])
{
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t4 = sin_phi * motion->constants[6];
    const double t11 = sin_phi * motion->constants[2];
    const double t17 = t4 + t11;
    const double t19 = (speeds[0] * ((sin_phi * t4) + (motion->constants[1] * cos_phi * cos_phi) +
        (sin_phi * t11))) + (speeds[2] * t17);
    const double t33 = ((speeds[0] * t19) + (speeds[1] * speeds[1] * motion->constants[7]) +
        (speeds[2] * ((speeds[0] * t17) + (speeds[2] * motion->constants[8])))) * 0.5;
    const double t37 = cos_phi * motion->constants[4] * motion->constants[5];
    energy[0] = t33;
    energy[1] = t37;
}

carvallo_motion_error_t rolling_disc_f64_motion_energy(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double energy[2])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f64(speeds, ROLLING_DISC_SPEEDS)) {
        rolling_disc_f64_compute_energy(motion, positions, speeds, energy);
        error = (carvallo_are_finite_f64(energy, 2U)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void rolling_disc_f64_compute_contact_forces(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double contact_forces[3U * ROLLING_DISC_WHEELS])
{
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t6 = speeds[0] * cos_phi;
    const double t9 = motion->constants[0] * speeds[1];
    const double t10 = t6 * t9;
    const double t11 = t6 * speeds[1];
    const double t16 = motion->constants[3] * motion->constants[0];
    const double t18 = (t11 * motion->constants[2]) + ((t10 + (motion->constants[0] * t11)) * t16);
    const double t21 = speeds[1] * motion->constants[1];
    const double t23 = t6 * motion->constants[1];
    const double t28 = speeds[0] * sin_phi;
    const double t29 = t21 * t28;
    const double t31 = t28 + speeds[2];
    const double t32 = motion->constants[2] * t31;
    const double t37 = (sin_phi * ((t6 * t21) + t18 - (speeds[1] * t23))) + (cos_phi * ((speeds[1] *
        t32) - t29 - t29));
    const double t39 = sin_phi * motion->constants[6];
    const double t40 = sin_phi * motion->constants[2];
    const double t47 = (sin_phi * t39) + (cos_phi * cos_phi * motion->constants[1]) + (sin_phi *
        t40);
    const double t48 = 1.0 / t47;
    const double t49 = (t39 + t40) * t48;
    const double t56 = ((t37 * t49) - t18) / (motion->constants[8] - (t47 * t49 * t49));
    const double t64 = t10 + (motion->constants[0] * (t11 + t56 - (sin_phi * ((t37 * t48) + (t49 *
        t56)))));
    const double t65 = motion->constants[3] * t64;
    const double t68 = motion->constants[0] * t28;
    const double t72 = (t6 * t68) + (sin_phi * motion->constants[4]);
    const double t73 = t6 * speeds[2];
    const double t83 = t73 + (((t23 * t28) - (t6 * t32) - (t16 * ((motion->constants[0] * t73) +
        t72))) / motion->constants[7]);
    const double t86 = motion->constants[3] * (t72 + (motion->constants[0] * t83));
    const double t93 = motion->constants[3] * ((speeds[1] * t9) + (t31 * t68) - (cos_phi *
        motion->constants[4]));
    const double t95 = (cos_phi * t86) + (sin_phi * t93);
    const double t97 = (sin_psi * t95) - (cos_psi * t65);
    const double t103 = (cos_phi * t93) - (sin_phi * t86);
    const double t104 = -((t65 * sin_psi) + (cos_psi * t95));
    contact_forces[0] = t97;
    contact_forces[1] = t104;
    contact_forces[2] = t103;
}

carvallo_motion_error_t rolling_disc_f64_motion_contact_forces(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double contact_forces[3U * ROLLING_DISC_WHEELS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f64(speeds, ROLLING_DISC_SPEEDS)) {
        rolling_disc_f64_compute_contact_forces(motion, positions, speeds, contact_forces);
        error = (carvallo_are_finite_f64(contact_forces, 3U * ROLLING_DISC_WHEELS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void rolling_disc_f64_compute_linearization(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    rolling_disc_f64_linearization_t *linearization)
{
    const double t3 = motion->constants[0] * speeds[2];
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    const double t6 = t3 * sin_psi;
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t15 = sin_phi * motion->constants[6];
    const double t19 = cos_phi * motion->constants[1];
    const double t22 = sin_phi * motion->constants[2];
    const double t25 = (sin_phi * t15) + (cos_phi * t19) + (sin_phi * t22);
    const double t26 = 1.0 / t25;
    const double t29 = sin_phi * speeds[0];
    const double t31 = motion->constants[2] * (speeds[2] + t29);
    const double t33 = motion->constants[1] * speeds[1];
    const double t35 = (speeds[1] * t31) - (t29 * t33);
    const double t36 = speeds[1] * t29;
    const double t37 = cos_phi * speeds[0];
    const double t39 = motion->constants[1] * t37;
    const double t41 = (t33 * t37) - (speeds[1] * t39);
    const double t42 = speeds[1] * t37;
    const double t45 = motion->constants[0] * speeds[1];
    const double t46 = t37 * t45;
    const double t49 = motion->constants[0] * motion->constants[3];
    const double t51 = (motion->constants[2] * t42) + (((motion->constants[0] * t42) + t46) * t49);
    const double t57 = (sin_phi * (t41 + t51)) + (cos_phi * (t35 - (motion->constants[1] * t36)));
    const double t60 = t26 * (t15 + t22);
    const double t67 = 1.0 / (motion->constants[8] - (t25 * t60 * t60));
    const double t68 = ((t57 * t60) - t51) * t67;
    const double t70 = (t26 * t57) + (t60 * t68);
    const double t72 = t36 + (cos_phi * t70);
    const double t76 = sin_phi * t70;
    const double t79 = t42 + t68 - t76;
    const double t89 = cos_phi * speeds[1];
    const double t90 = motion->constants[2] * t89;
    const double t92 = t90 - (cos_phi * t33) - (t19 * speeds[1]);
    const double t95 = sin_phi * motion->constants[5];
    const double t96 = t29 * t45;
    const double t99 = t22 + (motion->constants[0] * t95);
    const double t103 = (sin_phi * (t35 - (motion->constants[1] * t72))) + (t95 * t96) + (t72 *
        t99) - (t19 * t76);
    const double t104 = t103 - (cos_phi * (t41 + (motion->constants[2] * t79) + (t49 * (t46 +
        (motion->constants[0] * t79)))));
    const double t105 = t104 - (t37 * t92);
    const double t108 = motion->constants[6] + motion->constants[2];
    const double t113 = t67 * ((motion->constants[5] * t96) + (t72 * t108) - (t60 * t105));
    const double t115 = (t26 * t105) - (t60 * t113);
    const double t117 = cos_phi * t45;
    const double t121 = (sin_phi * t92) + (t95 * t117) + (t89 * t99);
    const double t128 = t67 * ((t60 * t121) - (motion->constants[5] * t117) - (t89 * t108));
    const double t132 = (motion->constants[1] * t29) - t31;
    const double t135 = motion->constants[0] * t37;
    const double t140 = (t95 * t135) + (t37 * t99) - (cos_phi * t132) - (t19 * t29);
    const double t142 = motion->constants[5] * t135;
    const double t147 = t67 * ((t60 * t140) - t142 - (t37 * t108));
    const double t152 = t60 * t67 * t90;
    const double t159 = t142 + (motion->constants[2] * t37);
    const double t160 = t39 - t159;
    const double t165 = t132 - (motion->constants[5] * (t3 + (motion->constants[0] * t29)));
    const double t170 = 1.0 / motion->constants[7];
    const double t171 = ((cos_phi * motion->constants[5] * motion->constants[4]) + (t29 * t165) -
        (t37 * t160)) * t170;
    const double t176 = t159 * t170;
    const double t177 = -(motion->constants[0] * cos_psi);
    const double t178 = -(t3 * cos_psi);
    const double t179 = -(motion->constants[0] * sin_psi);
    const double t180 = -((t26 * t121) + (t60 * t128));
    const double t181 = -((t26 * t140) + (t60 * t147));
    const double t182 = -((t26 * t90) + (t60 * t152));
    const double t183 = -(t170 * ((sin_phi * t160) + (cos_phi * t165)));
    linearization->a[0][0] = 0.0;
    linearization->a[0][1] = 0.0;
    linearization->a[0][2] = t6;
    linearization->a[0][3] = 0.0;
    linearization->a[0][4] = 0.0;
    linearization->a[0][5] = 0.0;
    linearization->a[0][6] = 0.0;
    linearization->a[0][7] = t177;
    linearization->a[1][0] = 0.0;
    linearization->a[1][1] = 0.0;
    linearization->a[1][2] = t178;
    linearization->a[1][3] = 0.0;
    linearization->a[1][4] = 0.0;
    linearization->a[1][5] = 0.0;
    linearization->a[1][6] = 0.0;
    linearization->a[1][7] = t179;
    linearization->a[2][0] = 0.0;
    linearization->a[2][1] = 0.0;
    linearization->a[2][2] = 0.0;
    linearization->a[2][3] = 0.0;
    linearization->a[2][4] = 0.0;
    linearization->a[2][5] = 1.0;
    linearization->a[2][6] = 0.0;
    linearization->a[2][7] = 0.0;
    linearization->a[3][0] = 0.0;
    linearization->a[3][1] = 0.0;
    linearization->a[3][2] = 0.0;
    linearization->a[3][3] = 0.0;
    linearization->a[3][4] = 0.0;
    linearization->a[3][5] = 0.0;
    linearization->a[3][6] = 1.0;
    linearization->a[3][7] = 0.0;
    linearization->a[4][0] = 0.0;
    linearization->a[4][1] = 0.0;
    linearization->a[4][2] = 0.0;
    linearization->a[4][3] = 0.0;
    linearization->a[4][4] = 0.0;
    linearization->a[4][5] = 0.0;
    linearization->a[4][6] = 0.0;
    linearization->a[4][7] = 1.0;
    linearization->a[5][0] = 0.0;
    linearization->a[5][1] = 0.0;
    linearization->a[5][2] = 0.0;
    linearization->a[5][3] = t115;
    linearization->a[5][4] = 0.0;
    linearization->a[5][5] = t180;
    linearization->a[5][6] = t181;
    linearization->a[5][7] = t182;
    linearization->a[6][0] = 0.0;
    linearization->a[6][1] = 0.0;
    linearization->a[6][2] = 0.0;
    linearization->a[6][3] = t171;
    linearization->a[6][4] = 0.0;
    linearization->a[6][5] = t183;
    linearization->a[6][6] = 0.0;
    linearization->a[6][7] = t176;
    linearization->a[7][0] = 0.0;
    linearization->a[7][1] = 0.0;
    linearization->a[7][2] = 0.0;
    linearization->a[7][3] = t113;
    linearization->a[7][4] = 0.0;
    linearization->a[7][5] = t128;
    linearization->a[7][6] = t147;
    linearization->a[7][7] = t152;
}

carvallo_motion_error_t rolling_disc_f64_motion_linearize(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    rolling_disc_f64_linearization_t *linearization)
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f64(speeds, ROLLING_DISC_SPEEDS)) {
        bool are_finite = true;
        rolling_disc_f64_compute_linearization(motion, positions, speeds, linearization);
        for (size_t row = 0U; row < ROLLING_DISC_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f64(linearization->a[row],
                ROLLING_DISC_STATES);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void rolling_disc_f64_compute_by_parameters(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double by_parameters[ROLLING_DISC_STATES][ROLLING_DISC_PARAMETERS])
{
    double sin_psi = 0.0;
    double cos_psi = 0.0;
    carvallo_sin_cos_f64(positions[2], &sin_psi, &cos_psi);
    double sin_phi = 0.0;
    double cos_phi = 0.0;
    carvallo_sin_cos_f64(positions[3], &sin_phi, &cos_phi);
    const double t10 = sin_phi * motion->constants[6];
    const double t17 = sin_phi * motion->constants[2];
    const double t20 = (sin_phi * t10) + (motion->constants[1] * cos_phi * cos_phi) + (sin_phi *
        t17);
    const double t21 = 1.0 / t20;
    const double t26 = cos_phi * speeds[0];
    const double t27 = motion->constants[0] * t26;
    const double t28 = speeds[1] * t27;
    const double t29 = speeds[1] * t26;
    const double t33 = motion->constants[3] * motion->constants[0];
    const double t35 = (motion->constants[2] * t29) + ((t28 + (motion->constants[0] * t29)) * t33);
    const double t36 = motion->constants[1] * speeds[1];
    const double t38 = motion->constants[1] * t26;
    const double t43 = sin_phi * speeds[0];
    const double t44 = speeds[1] * t43;
    const double t46 = speeds[2] + t43;
    const double t47 = motion->constants[2] * t46;
    const double t53 = (sin_phi * ((t26 * t36) + t35 - (speeds[1] * t38))) + (cos_phi *
        ((speeds[1] * t47) - (motion->constants[1] * t44) - (t36 * t43)));
    const double t55 = t21 * (t10 + t17);
    const double t62 = 1.0 / (motion->constants[8] - (t20 * t55 * t55));
    const double t63 = ((t53 * t55) - t35) * t62;
    const double t66 = (t21 * t53) + (t55 * t63);
    const double t69 = t29 + t63 - (sin_phi * t66);
    const double t71 = t28 + (motion->constants[0] * t69);
    const double t75 = (motion->constants[3] * t71) + (t33 * (t29 + t69));
    const double t76 = sin_phi * t75;
    const double t80 = t62 * ((t55 * t76) - t75);
    const double t83 = motion->constants[0] * t71;
    const double t84 = sin_phi * t83;
    const double t88 = t62 * ((t55 * t84) - t83);
    const double t94 = (cos_phi * speeds[1] * t46) + (sin_phi * t69);
    const double t98 = t62 * ((t55 * t94) - t69);
    const double t104 = cos_phi * (t44 + t44 + (cos_phi * t66));
    const double t107 = t55 * t62 * t104;
    const double t109 = (t21 * t104) + (t55 * t107);
    const double t111 = 1.0 / motion->constants[7];
    const double t115 = (t27 * t43) + (sin_phi * motion->constants[4]);
    const double t116 = speeds[2] * t26;
    const double t124 = t111 * ((t38 * t43) - (t26 * t47) - (t33 * ((motion->constants[0] * t116) +
        t115)));
    const double t125 = t116 + t124;
    const double t127 = t115 + (motion->constants[0] * t125);
    const double t129 = t26 * t43;
    const double t133 = t111 * ((motion->constants[3] * t127) + (t33 * (t125 + t129)));
    const double t135 = motion->constants[0] * t111 * t127;
    const double t137 = t26 * t46 * t111;
    const double t141 = sin_phi * t33 * t111;
    const double t142 = -(speeds[2] * cos_psi);
    const double t143 = -(speeds[2] * sin_psi);
    const double t144 = -((t21 * t76) + (t55 * t80));
    const double t145 = -((t21 * t84) + (t55 * t88));
    const double t146 = -((t21 * t94) + (t55 * t98));
    const double t147 = -(t111 * (t129 - t124));
    const double t148 = -t107;
    by_parameters[0][0] = t142;
    by_parameters[0][1] = 0.0;
    by_parameters[0][2] = 0.0;
    by_parameters[0][3] = 0.0;
    by_parameters[0][4] = 0.0;
    by_parameters[1][0] = t143;
    by_parameters[1][1] = 0.0;
    by_parameters[1][2] = 0.0;
    by_parameters[1][3] = 0.0;
    by_parameters[1][4] = 0.0;
    by_parameters[2][0] = 0.0;
    by_parameters[2][1] = 0.0;
    by_parameters[2][2] = 0.0;
    by_parameters[2][3] = 0.0;
    by_parameters[2][4] = 0.0;
    by_parameters[3][0] = 0.0;
    by_parameters[3][1] = 0.0;
    by_parameters[3][2] = 0.0;
    by_parameters[3][3] = 0.0;
    by_parameters[3][4] = 0.0;
    by_parameters[4][0] = 0.0;
    by_parameters[4][1] = 0.0;
    by_parameters[4][2] = 0.0;
    by_parameters[4][3] = 0.0;
    by_parameters[4][4] = 0.0;
    by_parameters[5][0] = t144;
    by_parameters[5][1] = t145;
    by_parameters[5][2] = t146;
    by_parameters[5][3] = t109;
    by_parameters[5][4] = 0.0;
    by_parameters[6][0] = t133;
    by_parameters[6][1] = t135;
    by_parameters[6][2] = t137;
    by_parameters[6][3] = t147;
    by_parameters[6][4] = t141;
    by_parameters[7][0] = t80;
    by_parameters[7][1] = t88;
    by_parameters[7][2] = t98;
    by_parameters[7][3] = t148;
    by_parameters[7][4] = 0.0;
}

carvallo_motion_error_t rolling_disc_f64_motion_by_parameters(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double by_parameters[ROLLING_DISC_STATES][ROLLING_DISC_PARAMETERS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f64(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f64(speeds, ROLLING_DISC_SPEEDS)) {
        bool are_finite = true;
        rolling_disc_f64_compute_by_parameters(motion, positions, speeds, by_parameters);
        for (size_t row = 0U; row < ROLLING_DISC_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f64(by_parameters[row],
                ROLLING_DISC_PARAMETERS);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
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
    const float t6 = p->r * p->m;
    const float Jxx_all = p->It + (p->r * t6);
    const float C1_12_Ia = 1.0F / p->r;
    const float M_11_r = t6 + t6;
    const float M_11_m = p->r * p->r;
    const float K0_11 = -t6;
    const float h_spin_D = p->Ia * C1_12_Ia;
    const float C1_12 = t6 + h_spin_D;
    const float C1_21_r = C1_12_Ia * h_spin_D;
    const float C1_21 = -h_spin_D;
    const float C1_12_r = p->m - C1_21_r;
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
    derivatives->values[0] = p->r;
    derivatives->values[1] = p->m;
    derivatives->values[2] = 1.0F;
    derivatives->values[3] = C1_12_Ia;
    derivatives->values[4] = M_11_r;
    derivatives->values[5] = M_11_m;
    derivatives->values[6] = C1_21_r;
    derivatives->values[7] = C1_12_r;
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

void rolling_disc_f32_motion(const rolling_disc_f32_t *p, rolling_disc_f32_motion_t *motion)
{
    const float t5 = p->r * p->m;
    const float t6 = p->r * t5;
    const float t7 = p->It + t6;
    const float t8 = p->Ia + t6;
    motion->constants[0] = p->r;
    motion->constants[1] = p->It;
    motion->constants[2] = p->Ia;
    motion->constants[3] = p->m;
    motion->constants[4] = p->g;
    motion->constants[5] = t5;
    motion->constants[6] = t6;
    motion->constants[7] = t7;
    motion->constants[8] = t8;
}

static void rolling_disc_f32_compute_rates(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float rates[ROLLING_DISC_POSITIONS])
{
    const float t2 = motion->constants[0] * speeds[2];
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t10 = -(t2 * cos_psi);
    const float t11 = -(t2 * sin_psi);
    rates[0] = t10;
    rates[1] = t11;
    rates[2] = speeds[0];
    rates[3] = speeds[1];
    rates[4] = speeds[2];
}

carvallo_motion_error_t rolling_disc_f32_motion_rates(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float rates[ROLLING_DISC_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f32(speeds, ROLLING_DISC_SPEEDS)) {
        rolling_disc_f32_compute_rates(motion, positions, speeds, rates);
        error = (carvallo_are_finite_f32(rates, ROLLING_DISC_POSITIONS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void rolling_disc_f32_compute_derivatives(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float rates[ROLLING_DISC_POSITIONS], float speed_rates[ROLLING_DISC_SPEEDS])
{
    const float t2 = motion->constants[0] * speeds[2];
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t13 = speeds[0] * cos_phi;
    const float t15 = speeds[1] * motion->constants[1];
    const float t17 = t13 * motion->constants[1];
    const float t20 = speeds[1] * t13;
    const float t23 = motion->constants[0] * t13;
    const float t27 = motion->constants[0] * motion->constants[3];
    const float t29 = (motion->constants[2] * t20) + (((motion->constants[0] * t20) + (speeds[1] *
        t23)) * t27);
    const float t33 = speeds[0] * sin_phi;
    const float t34 = t15 * t33;
    const float t36 = motion->constants[2] * (speeds[2] + t33);
    const float t41 = (sin_phi * ((t13 * t15) + t29 - (speeds[1] * t17))) + (cos_phi * ((speeds[1] *
        t36) - t34 - t34));
    const float t43 = sin_phi * motion->constants[6];
    const float t47 = sin_phi * motion->constants[2];
    const float t50 = (sin_phi * t43) + (cos_phi * cos_phi * motion->constants[1]) + (sin_phi *
        t47);
    const float t51 = 1.0F / t50;
    const float t54 = t51 * (t43 + t47);
    const float t61 = ((t41 * t54) - t29) / (motion->constants[8] - (t50 * t54 * t54));
    const float t76 = ((t17 * t33) - (t13 * t36) - (t27 * ((speeds[2] * t23) + (t23 * t33) +
        (sin_phi * motion->constants[4])))) / motion->constants[7];
    const float t77 = -(t2 * cos_psi);
    const float t78 = -(t2 * sin_psi);
    const float t79 = -((t41 * t51) + (t54 * t61));
    const float t80 = -t76;
    rates[0] = t77;
    rates[1] = t78;
    rates[2] = speeds[0];
    rates[3] = speeds[1];
    rates[4] = speeds[2];
    speed_rates[0] = t79;
    speed_rates[1] = t80;
    speed_rates[2] = t61;
}

carvallo_motion_error_t rolling_disc_f32_motion_derivatives(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float rates[ROLLING_DISC_POSITIONS], float speed_rates[ROLLING_DISC_SPEEDS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f32(speeds, ROLLING_DISC_SPEEDS)) {
        rolling_disc_f32_compute_derivatives(motion, positions, speeds, rates, speed_rates);
        error = (carvallo_are_finite_f32(rates, ROLLING_DISC_POSITIONS) &&
            carvallo_are_finite_f32(speed_rates, ROLLING_DISC_SPEEDS)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void rolling_disc_f32_compute_accelerations(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float accelerations[ROLLING_DISC_POSITIONS])
{
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t7 = speeds[0] * cos_phi;
    const float t9 = t7 * speeds[1];
    const float t12 = motion->constants[0] * t7;
    const float t16 = motion->constants[0] * motion->constants[3];
    const float t18 = (motion->constants[2] * t9) + (((motion->constants[0] * t9) + (speeds[1] *
        t12)) * t16);
    const float t21 = motion->constants[1] * speeds[1];
    const float t23 = t7 * motion->constants[1];
    const float t28 = sin_phi * speeds[0];
    const float t29 = t21 * t28;
    const float t32 = motion->constants[2] * (t28 + speeds[2]);
    const float t37 = (sin_phi * ((t7 * t21) + t18 - (speeds[1] * t23))) + (cos_phi * ((speeds[1] *
        t32) - t29 - t29));
    const float t39 = sin_phi * motion->constants[6];
    const float t40 = sin_phi * motion->constants[2];
    const float t47 = (sin_phi * t39) + (cos_phi * cos_phi * motion->constants[1]) + (sin_phi *
        t40);
    const float t48 = 1.0F / t47;
    const float t49 = (t39 + t40) * t48;
    const float t56 = ((t37 * t49) - t18) / (motion->constants[8] - (t47 * t49 * t49));
    const float t57 = motion->constants[0] * t56;
    const float t61 = motion->constants[0] * speeds[0] * speeds[2];
    const float t63 = (sin_psi * t61) - (cos_psi * t57);
    const float t82 = ((t23 * t28) - (t7 * t32) - (t16 * ((t12 * speeds[2]) + (t12 * t28) +
        (sin_phi * motion->constants[4])))) / motion->constants[7];
    const float t83 = -((t57 * sin_psi) + (cos_psi * t61));
    const float t84 = -((t37 * t48) + (t49 * t56));
    const float t85 = -t82;
    accelerations[0] = t63;
    accelerations[1] = t83;
    accelerations[2] = t84;
    accelerations[3] = t85;
    accelerations[4] = t56;
}

carvallo_motion_error_t rolling_disc_f32_motion_accelerations(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float accelerations[ROLLING_DISC_POSITIONS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f32(speeds, ROLLING_DISC_SPEEDS)) {
        rolling_disc_f32_compute_accelerations(motion, positions, speeds, accelerations);
        error = (carvallo_are_finite_f32(accelerations, ROLLING_DISC_POSITIONS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void rolling_disc_f32_compute_energy(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float energy[2])
{
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t4 = sin_phi * motion->constants[6];
    const float t11 = sin_phi * motion->constants[2];
    const float t17 = t4 + t11;
    const float t19 = (speeds[0] * ((sin_phi * t4) + (motion->constants[1] * cos_phi * cos_phi) +
        (sin_phi * t11))) + (speeds[2] * t17);
    const float t33 = ((speeds[0] * t19) + (speeds[1] * speeds[1] * motion->constants[7]) +
        (speeds[2] * ((speeds[0] * t17) + (speeds[2] * motion->constants[8])))) * 0.5F;
    const float t37 = cos_phi * motion->constants[4] * motion->constants[5];
    energy[0] = t33;
    energy[1] = t37;
}

carvallo_motion_error_t rolling_disc_f32_motion_energy(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float energy[2])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f32(speeds, ROLLING_DISC_SPEEDS)) {
        rolling_disc_f32_compute_energy(motion, positions, speeds, energy);
        error = (carvallo_are_finite_f32(energy, 2U)) ? CARVALLO_MOTION_OK :
            CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void rolling_disc_f32_compute_contact_forces(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float contact_forces[3U * ROLLING_DISC_WHEELS])
{
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t6 = speeds[0] * cos_phi;
    const float t9 = motion->constants[0] * speeds[1];
    const float t10 = t6 * t9;
    const float t11 = t6 * speeds[1];
    const float t16 = motion->constants[3] * motion->constants[0];
    const float t18 = (t11 * motion->constants[2]) + ((t10 + (motion->constants[0] * t11)) * t16);
    const float t21 = speeds[1] * motion->constants[1];
    const float t23 = t6 * motion->constants[1];
    const float t28 = speeds[0] * sin_phi;
    const float t29 = t21 * t28;
    const float t31 = t28 + speeds[2];
    const float t32 = motion->constants[2] * t31;
    const float t37 = (sin_phi * ((t6 * t21) + t18 - (speeds[1] * t23))) + (cos_phi * ((speeds[1] *
        t32) - t29 - t29));
    const float t39 = sin_phi * motion->constants[6];
    const float t40 = sin_phi * motion->constants[2];
    const float t47 = (sin_phi * t39) + (cos_phi * cos_phi * motion->constants[1]) + (sin_phi *
        t40);
    const float t48 = 1.0F / t47;
    const float t49 = (t39 + t40) * t48;
    const float t56 = ((t37 * t49) - t18) / (motion->constants[8] - (t47 * t49 * t49));
    const float t64 = t10 + (motion->constants[0] * (t11 + t56 - (sin_phi * ((t37 * t48) + (t49 *
        t56)))));
    const float t65 = motion->constants[3] * t64;
    const float t68 = motion->constants[0] * t28;
    const float t72 = (t6 * t68) + (sin_phi * motion->constants[4]);
    const float t73 = t6 * speeds[2];
    const float t83 = t73 + (((t23 * t28) - (t6 * t32) - (t16 * ((motion->constants[0] * t73) +
        t72))) / motion->constants[7]);
    const float t86 = motion->constants[3] * (t72 + (motion->constants[0] * t83));
    const float t93 = motion->constants[3] * ((speeds[1] * t9) + (t31 * t68) - (cos_phi *
        motion->constants[4]));
    const float t95 = (cos_phi * t86) + (sin_phi * t93);
    const float t97 = (sin_psi * t95) - (cos_psi * t65);
    const float t103 = (cos_phi * t93) - (sin_phi * t86);
    const float t104 = -((t65 * sin_psi) + (cos_psi * t95));
    contact_forces[0] = t97;
    contact_forces[1] = t104;
    contact_forces[2] = t103;
}

carvallo_motion_error_t rolling_disc_f32_motion_contact_forces(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float contact_forces[3U * ROLLING_DISC_WHEELS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f32(speeds, ROLLING_DISC_SPEEDS)) {
        rolling_disc_f32_compute_contact_forces(motion, positions, speeds, contact_forces);
        error = (carvallo_are_finite_f32(contact_forces, 3U * ROLLING_DISC_WHEELS)) ?
            CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void rolling_disc_f32_compute_linearization(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    rolling_disc_f32_linearization_t *linearization)
{
    const float t3 = motion->constants[0] * speeds[2];
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    const float t6 = t3 * sin_psi;
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t15 = sin_phi * motion->constants[6];
    const float t19 = cos_phi * motion->constants[1];
    const float t22 = sin_phi * motion->constants[2];
    const float t25 = (sin_phi * t15) + (cos_phi * t19) + (sin_phi * t22);
    const float t26 = 1.0F / t25;
    const float t29 = sin_phi * speeds[0];
    const float t31 = motion->constants[2] * (speeds[2] + t29);
    const float t33 = motion->constants[1] * speeds[1];
    const float t35 = (speeds[1] * t31) - (t29 * t33);
    const float t36 = speeds[1] * t29;
    const float t37 = cos_phi * speeds[0];
    const float t39 = motion->constants[1] * t37;
    const float t41 = (t33 * t37) - (speeds[1] * t39);
    const float t42 = speeds[1] * t37;
    const float t45 = motion->constants[0] * speeds[1];
    const float t46 = t37 * t45;
    const float t49 = motion->constants[0] * motion->constants[3];
    const float t51 = (motion->constants[2] * t42) + (((motion->constants[0] * t42) + t46) * t49);
    const float t57 = (sin_phi * (t41 + t51)) + (cos_phi * (t35 - (motion->constants[1] * t36)));
    const float t60 = t26 * (t15 + t22);
    const float t67 = 1.0F / (motion->constants[8] - (t25 * t60 * t60));
    const float t68 = ((t57 * t60) - t51) * t67;
    const float t70 = (t26 * t57) + (t60 * t68);
    const float t72 = t36 + (cos_phi * t70);
    const float t76 = sin_phi * t70;
    const float t79 = t42 + t68 - t76;
    const float t89 = cos_phi * speeds[1];
    const float t90 = motion->constants[2] * t89;
    const float t92 = t90 - (cos_phi * t33) - (t19 * speeds[1]);
    const float t95 = sin_phi * motion->constants[5];
    const float t96 = t29 * t45;
    const float t99 = t22 + (motion->constants[0] * t95);
    const float t103 = (sin_phi * (t35 - (motion->constants[1] * t72))) + (t95 * t96) + (t72 *
        t99) - (t19 * t76);
    const float t104 = t103 - (cos_phi * (t41 + (motion->constants[2] * t79) + (t49 * (t46 +
        (motion->constants[0] * t79)))));
    const float t105 = t104 - (t37 * t92);
    const float t108 = motion->constants[6] + motion->constants[2];
    const float t113 = t67 * ((motion->constants[5] * t96) + (t72 * t108) - (t60 * t105));
    const float t115 = (t26 * t105) - (t60 * t113);
    const float t117 = cos_phi * t45;
    const float t121 = (sin_phi * t92) + (t95 * t117) + (t89 * t99);
    const float t128 = t67 * ((t60 * t121) - (motion->constants[5] * t117) - (t89 * t108));
    const float t132 = (motion->constants[1] * t29) - t31;
    const float t135 = motion->constants[0] * t37;
    const float t140 = (t95 * t135) + (t37 * t99) - (cos_phi * t132) - (t19 * t29);
    const float t142 = motion->constants[5] * t135;
    const float t147 = t67 * ((t60 * t140) - t142 - (t37 * t108));
    const float t152 = t60 * t67 * t90;
    const float t159 = t142 + (motion->constants[2] * t37);
    const float t160 = t39 - t159;
    const float t165 = t132 - (motion->constants[5] * (t3 + (motion->constants[0] * t29)));
    const float t170 = 1.0F / motion->constants[7];
    const float t171 = ((cos_phi * motion->constants[5] * motion->constants[4]) + (t29 * t165) -
        (t37 * t160)) * t170;
    const float t176 = t159 * t170;
    const float t177 = -(motion->constants[0] * cos_psi);
    const float t178 = -(t3 * cos_psi);
    const float t179 = -(motion->constants[0] * sin_psi);
    const float t180 = -((t26 * t121) + (t60 * t128));
    const float t181 = -((t26 * t140) + (t60 * t147));
    const float t182 = -((t26 * t90) + (t60 * t152));
    const float t183 = -(t170 * ((sin_phi * t160) + (cos_phi * t165)));
    linearization->a[0][0] = 0.0F;
    linearization->a[0][1] = 0.0F;
    linearization->a[0][2] = t6;
    linearization->a[0][3] = 0.0F;
    linearization->a[0][4] = 0.0F;
    linearization->a[0][5] = 0.0F;
    linearization->a[0][6] = 0.0F;
    linearization->a[0][7] = t177;
    linearization->a[1][0] = 0.0F;
    linearization->a[1][1] = 0.0F;
    linearization->a[1][2] = t178;
    linearization->a[1][3] = 0.0F;
    linearization->a[1][4] = 0.0F;
    linearization->a[1][5] = 0.0F;
    linearization->a[1][6] = 0.0F;
    linearization->a[1][7] = t179;
    linearization->a[2][0] = 0.0F;
    linearization->a[2][1] = 0.0F;
    linearization->a[2][2] = 0.0F;
    linearization->a[2][3] = 0.0F;
    linearization->a[2][4] = 0.0F;
    linearization->a[2][5] = 1.0F;
    linearization->a[2][6] = 0.0F;
    linearization->a[2][7] = 0.0F;
    linearization->a[3][0] = 0.0F;
    linearization->a[3][1] = 0.0F;
    linearization->a[3][2] = 0.0F;
    linearization->a[3][3] = 0.0F;
    linearization->a[3][4] = 0.0F;
    linearization->a[3][5] = 0.0F;
    linearization->a[3][6] = 1.0F;
    linearization->a[3][7] = 0.0F;
    linearization->a[4][0] = 0.0F;
    linearization->a[4][1] = 0.0F;
    linearization->a[4][2] = 0.0F;
    linearization->a[4][3] = 0.0F;
    linearization->a[4][4] = 0.0F;
    linearization->a[4][5] = 0.0F;
    linearization->a[4][6] = 0.0F;
    linearization->a[4][7] = 1.0F;
    linearization->a[5][0] = 0.0F;
    linearization->a[5][1] = 0.0F;
    linearization->a[5][2] = 0.0F;
    linearization->a[5][3] = t115;
    linearization->a[5][4] = 0.0F;
    linearization->a[5][5] = t180;
    linearization->a[5][6] = t181;
    linearization->a[5][7] = t182;
    linearization->a[6][0] = 0.0F;
    linearization->a[6][1] = 0.0F;
    linearization->a[6][2] = 0.0F;
    linearization->a[6][3] = t171;
    linearization->a[6][4] = 0.0F;
    linearization->a[6][5] = t183;
    linearization->a[6][6] = 0.0F;
    linearization->a[6][7] = t176;
    linearization->a[7][0] = 0.0F;
    linearization->a[7][1] = 0.0F;
    linearization->a[7][2] = 0.0F;
    linearization->a[7][3] = t113;
    linearization->a[7][4] = 0.0F;
    linearization->a[7][5] = t128;
    linearization->a[7][6] = t147;
    linearization->a[7][7] = t152;
}

carvallo_motion_error_t rolling_disc_f32_motion_linearize(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    rolling_disc_f32_linearization_t *linearization)
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f32(speeds, ROLLING_DISC_SPEEDS)) {
        bool are_finite = true;
        rolling_disc_f32_compute_linearization(motion, positions, speeds, linearization);
        for (size_t row = 0U; row < ROLLING_DISC_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f32(linearization->a[row],
                ROLLING_DISC_STATES);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void rolling_disc_f32_compute_by_parameters(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float by_parameters[ROLLING_DISC_STATES][ROLLING_DISC_PARAMETERS])
{
    float sin_psi = 0.0F;
    float cos_psi = 0.0F;
    carvallo_sin_cos_f32(positions[2], &sin_psi, &cos_psi);
    float sin_phi = 0.0F;
    float cos_phi = 0.0F;
    carvallo_sin_cos_f32(positions[3], &sin_phi, &cos_phi);
    const float t10 = sin_phi * motion->constants[6];
    const float t17 = sin_phi * motion->constants[2];
    const float t20 = (sin_phi * t10) + (motion->constants[1] * cos_phi * cos_phi) + (sin_phi *
        t17);
    const float t21 = 1.0F / t20;
    const float t26 = cos_phi * speeds[0];
    const float t27 = motion->constants[0] * t26;
    const float t28 = speeds[1] * t27;
    const float t29 = speeds[1] * t26;
    const float t33 = motion->constants[3] * motion->constants[0];
    const float t35 = (motion->constants[2] * t29) + ((t28 + (motion->constants[0] * t29)) * t33);
    const float t36 = motion->constants[1] * speeds[1];
    const float t38 = motion->constants[1] * t26;
    const float t43 = sin_phi * speeds[0];
    const float t44 = speeds[1] * t43;
    const float t46 = speeds[2] + t43;
    const float t47 = motion->constants[2] * t46;
    const float t53 = (sin_phi * ((t26 * t36) + t35 - (speeds[1] * t38))) + (cos_phi * ((speeds[1] *
        t47) - (motion->constants[1] * t44) - (t36 * t43)));
    const float t55 = t21 * (t10 + t17);
    const float t62 = 1.0F / (motion->constants[8] - (t20 * t55 * t55));
    const float t63 = ((t53 * t55) - t35) * t62;
    const float t66 = (t21 * t53) + (t55 * t63);
    const float t69 = t29 + t63 - (sin_phi * t66);
    const float t71 = t28 + (motion->constants[0] * t69);
    const float t75 = (motion->constants[3] * t71) + (t33 * (t29 + t69));
    const float t76 = sin_phi * t75;
    const float t80 = t62 * ((t55 * t76) - t75);
    const float t83 = motion->constants[0] * t71;
    const float t84 = sin_phi * t83;
    const float t88 = t62 * ((t55 * t84) - t83);
    const float t94 = (cos_phi * speeds[1] * t46) + (sin_phi * t69);
    const float t98 = t62 * ((t55 * t94) - t69);
    const float t104 = cos_phi * (t44 + t44 + (cos_phi * t66));
    const float t107 = t55 * t62 * t104;
    const float t109 = (t21 * t104) + (t55 * t107);
    const float t111 = 1.0F / motion->constants[7];
    const float t115 = (t27 * t43) + (sin_phi * motion->constants[4]);
    const float t116 = speeds[2] * t26;
    const float t124 = t111 * ((t38 * t43) - (t26 * t47) - (t33 * ((motion->constants[0] * t116) +
        t115)));
    const float t125 = t116 + t124;
    const float t127 = t115 + (motion->constants[0] * t125);
    const float t129 = t26 * t43;
    const float t133 = t111 * ((motion->constants[3] * t127) + (t33 * (t125 + t129)));
    const float t135 = motion->constants[0] * t111 * t127;
    const float t137 = t26 * t46 * t111;
    const float t141 = sin_phi * t33 * t111;
    const float t142 = -(speeds[2] * cos_psi);
    const float t143 = -(speeds[2] * sin_psi);
    const float t144 = -((t21 * t76) + (t55 * t80));
    const float t145 = -((t21 * t84) + (t55 * t88));
    const float t146 = -((t21 * t94) + (t55 * t98));
    const float t147 = -(t111 * (t129 - t124));
    const float t148 = -t107;
    by_parameters[0][0] = t142;
    by_parameters[0][1] = 0.0F;
    by_parameters[0][2] = 0.0F;
    by_parameters[0][3] = 0.0F;
    by_parameters[0][4] = 0.0F;
    by_parameters[1][0] = t143;
    by_parameters[1][1] = 0.0F;
    by_parameters[1][2] = 0.0F;
    by_parameters[1][3] = 0.0F;
    by_parameters[1][4] = 0.0F;
    by_parameters[2][0] = 0.0F;
    by_parameters[2][1] = 0.0F;
    by_parameters[2][2] = 0.0F;
    by_parameters[2][3] = 0.0F;
    by_parameters[2][4] = 0.0F;
    by_parameters[3][0] = 0.0F;
    by_parameters[3][1] = 0.0F;
    by_parameters[3][2] = 0.0F;
    by_parameters[3][3] = 0.0F;
    by_parameters[3][4] = 0.0F;
    by_parameters[4][0] = 0.0F;
    by_parameters[4][1] = 0.0F;
    by_parameters[4][2] = 0.0F;
    by_parameters[4][3] = 0.0F;
    by_parameters[4][4] = 0.0F;
    by_parameters[5][0] = t144;
    by_parameters[5][1] = t145;
    by_parameters[5][2] = t146;
    by_parameters[5][3] = t109;
    by_parameters[5][4] = 0.0F;
    by_parameters[6][0] = t133;
    by_parameters[6][1] = t135;
    by_parameters[6][2] = t137;
    by_parameters[6][3] = t147;
    by_parameters[6][4] = t141;
    by_parameters[7][0] = t80;
    by_parameters[7][1] = t88;
    by_parameters[7][2] = t98;
    by_parameters[7][3] = t148;
    by_parameters[7][4] = 0.0F;
}

carvallo_motion_error_t rolling_disc_f32_motion_by_parameters(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float by_parameters[ROLLING_DISC_STATES][ROLLING_DISC_PARAMETERS])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if (carvallo_are_finite_f32(positions, ROLLING_DISC_POSITIONS) &&
        carvallo_are_finite_f32(speeds, ROLLING_DISC_SPEEDS)) {
        bool are_finite = true;
        rolling_disc_f32_compute_by_parameters(motion, positions, speeds, by_parameters);
        for (size_t row = 0U; row < ROLLING_DISC_STATES; row++) {
            are_finite = are_finite && carvallo_are_finite_f32(by_parameters[row],
                ROLLING_DISC_PARAMETERS);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}
