/* @generated from generated/models/car_trailer.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 1a935d722786e794
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * Jyy_q = mT*e^2 + IT [kg*m^2]
 * Sx_q = -mT*e [kg*m]
 * Jzz_all = I + Jyy_q - 2*h*(Sx_q - (1/2)*h*mT) [kg*m^2]
 * Sx_all = Sx_q - h*mT [kg*m]
 * m_all = m + mT [kg]
 * M_psi_q = Jyy_q - h*Sx_q [kg*m^2]
 * M_11 = m_all [kg]
 * M_12 = M_21 = Sx_all [kg*m]
 * M_13 = M_31 = Sx_q [kg*m]
 * M_22 = Jzz_all [kg*m^2]
 * M_23 = M_32 = M_psi_q [kg*m^2]
 * M_33 = Jyy_q [kg*m^2]
 * C-1_11 = Cf + Cr + CT [kg*m/s^2]
 * C-1_12 = C-1_21 = a*Cf - b*Cr - CT*(h + l) [kg*m^2/s^2]
 * C-1_13 = C-1_31 = -l*CT [kg*m^2/s^2]
 * C-1_22 = CT*(h + l)^2 + a^2*Cf + b^2*Cr [kg*m^3/s^2]
 * C-1_23 = C-1_32 = l*CT*(h + l) [kg*m^3/s^2]
 * C-1_33 = l^2*CT [kg*m^3/s^2]
 * C0_33 = d [kg*m^2/s]
 * C1_12 = m_all [kg]
 * C1_22 = Sx_all [kg*m]
 * C1_32 = Sx_q [kg*m]
 * Kc_13 = -CT [kg*m/s^2]
 * Kc_23 = CT*(h + l) [kg*m^2/s^2]
 * Kc_33 = l*CT [kg*m^2/s^2]
 * @endverbatim
 */

#include "car_trailer.h"

#include <float.h>

const char *car_trailer_set_name(car_trailer_set_t set)
{
    static const char *const TEXTS[] = {
        "caravan",
        "loaded_behind",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *car_trailer_validity_text(car_trailer_validity_t validity)
{
    static const char *const TEXTS[] = {
        "CarTrailer: the parameters are valid",
        "CarTrailer: m in kg must be finite and > 0",
        "CarTrailer: I in kg*m^2 must be finite and > 0",
        "CarTrailer: a in m must be finite and > 0",
        "CarTrailer: b in m must be finite and > 0",
        "CarTrailer: h in m must be finite and > 0",
        "CarTrailer: mT in kg must be finite and > 0",
        "CarTrailer: IT in kg*m^2 must be finite and > 0",
        "CarTrailer: e in m must be finite",
        "CarTrailer: l in m must be finite and > 0",
        "CarTrailer: Cf in N/rad must be finite and > 0",
        "CarTrailer: Cr in N/rad must be finite and > 0",
        "CarTrailer: CT in N/rad must be finite and > 0",
        "CarTrailer: d in N*m*s/rad must be finite and >= 0",
        "CarTrailer: t in m must be finite and > 0",
        "CarTrailer: r in m must be finite and > 0",
        "CarTrailer: g in N/kg must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t car_trailer_partials[CAR_TRAILER_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 8U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 0U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 1U, 8U, false},
    {CARVALLO_MATRIX_CM1, 0U, 1U, 2U, 5U, false},
    {CARVALLO_MATRIX_CM1, 1U, 0U, 2U, 5U, false},
    {CARVALLO_MATRIX_CM1, 1U, 1U, 2U, 16U, false},
    {CARVALLO_MATRIX_CM1, 0U, 1U, 3U, 6U, true},
    {CARVALLO_MATRIX_CM1, 1U, 0U, 3U, 6U, true},
    {CARVALLO_MATRIX_CM1, 1U, 1U, 3U, 18U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 4U, 2U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 4U, 2U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 4U, 21U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 4U, 11U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 4U, 11U, false},
    {CARVALLO_MATRIX_CM1, 0U, 1U, 4U, 7U, true},
    {CARVALLO_MATRIX_CM1, 1U, 0U, 4U, 7U, true},
    {CARVALLO_MATRIX_CM1, 1U, 1U, 4U, 22U, false},
    {CARVALLO_MATRIX_CM1, 1U, 2U, 4U, 17U, false},
    {CARVALLO_MATRIX_CM1, 2U, 1U, 4U, 17U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 4U, 2U, true},
    {CARVALLO_MATRIX_KC, 1U, 2U, 4U, 7U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 5U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 5U, 10U, true},
    {CARVALLO_MATRIX_M, 0U, 2U, 5U, 3U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 5U, 10U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 5U, 15U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 5U, 13U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 5U, 3U, true},
    {CARVALLO_MATRIX_M, 2U, 1U, 5U, 13U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 5U, 23U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 5U, 8U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 5U, 10U, true},
    {CARVALLO_MATRIX_C1, 2U, 1U, 5U, 3U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 6U, 8U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 6U, 8U, false},
    {CARVALLO_MATRIX_M, 2U, 1U, 6U, 8U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 6U, 8U, false},
    {CARVALLO_MATRIX_M, 0U, 1U, 7U, 2U, true},
    {CARVALLO_MATRIX_M, 0U, 2U, 7U, 2U, true},
    {CARVALLO_MATRIX_M, 1U, 0U, 7U, 2U, true},
    {CARVALLO_MATRIX_M, 1U, 1U, 7U, 21U, false},
    {CARVALLO_MATRIX_M, 1U, 2U, 7U, 12U, false},
    {CARVALLO_MATRIX_M, 2U, 0U, 7U, 2U, true},
    {CARVALLO_MATRIX_M, 2U, 1U, 7U, 12U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 7U, 24U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 7U, 2U, true},
    {CARVALLO_MATRIX_C1, 2U, 1U, 7U, 2U, true},
    {CARVALLO_MATRIX_CM1, 0U, 1U, 8U, 7U, true},
    {CARVALLO_MATRIX_CM1, 0U, 2U, 8U, 7U, true},
    {CARVALLO_MATRIX_CM1, 1U, 0U, 8U, 7U, true},
    {CARVALLO_MATRIX_CM1, 1U, 1U, 8U, 22U, false},
    {CARVALLO_MATRIX_CM1, 1U, 2U, 8U, 25U, false},
    {CARVALLO_MATRIX_CM1, 2U, 0U, 8U, 7U, true},
    {CARVALLO_MATRIX_CM1, 2U, 1U, 8U, 25U, false},
    {CARVALLO_MATRIX_CM1, 2U, 2U, 8U, 26U, false},
    {CARVALLO_MATRIX_KC, 1U, 2U, 8U, 7U, false},
    {CARVALLO_MATRIX_KC, 2U, 2U, 8U, 7U, false},
    {CARVALLO_MATRIX_CM1, 0U, 0U, 9U, 8U, false},
    {CARVALLO_MATRIX_CM1, 0U, 1U, 9U, 0U, false},
    {CARVALLO_MATRIX_CM1, 1U, 0U, 9U, 0U, false},
    {CARVALLO_MATRIX_CM1, 1U, 1U, 9U, 27U, false},
    {CARVALLO_MATRIX_CM1, 0U, 0U, 10U, 8U, false},
    {CARVALLO_MATRIX_CM1, 0U, 1U, 10U, 1U, true},
    {CARVALLO_MATRIX_CM1, 1U, 0U, 10U, 1U, true},
    {CARVALLO_MATRIX_CM1, 1U, 1U, 10U, 28U, false},
    {CARVALLO_MATRIX_CM1, 0U, 0U, 11U, 8U, false},
    {CARVALLO_MATRIX_CM1, 0U, 1U, 11U, 14U, true},
    {CARVALLO_MATRIX_CM1, 0U, 2U, 11U, 4U, true},
    {CARVALLO_MATRIX_CM1, 1U, 0U, 11U, 14U, true},
    {CARVALLO_MATRIX_CM1, 1U, 1U, 11U, 29U, false},
    {CARVALLO_MATRIX_CM1, 1U, 2U, 11U, 19U, false},
    {CARVALLO_MATRIX_CM1, 2U, 0U, 11U, 4U, true},
    {CARVALLO_MATRIX_CM1, 2U, 1U, 11U, 19U, false},
    {CARVALLO_MATRIX_CM1, 2U, 2U, 11U, 20U, false},
    {CARVALLO_MATRIX_KC, 0U, 2U, 11U, 9U, false},
    {CARVALLO_MATRIX_KC, 1U, 2U, 11U, 14U, false},
    {CARVALLO_MATRIX_KC, 2U, 2U, 11U, 4U, false},
    {CARVALLO_MATRIX_C0, 2U, 2U, 12U, 8U, false}
};

const car_trailer_f64_t car_trailer_f64_sets[CAR_TRAILER_SETS] = {
    { /* caravan */
        .m = 1500.0,
        .I_ = 2500.0,
        .a = 1.2,
        .b = 1.5,
        .h = 2.4,
        .mT = 1200.0,
        .IT = 2200.0,
        .e = 3.5,
        .l = 3.7,
        .Cf = 80000.0,
        .Cr = 100000.0,
        .CT = 70000.0,
        .d = 0.0,
        .t = 0.75,
        .r = 0.3,
        .g = 9.81
    },
    { /* loaded_behind */
        .m = 1500.0,
        .I_ = 2500.0,
        .a = 1.2,
        .b = 1.5,
        .h = 2.4,
        .mT = 1200.0,
        .IT = 3200.0,
        .e = 3.8,
        .l = 3.7,
        .Cf = 80000.0,
        .Cr = 100000.0,
        .CT = 70000.0,
        .d = 0.0,
        .t = 0.75,
        .r = 0.3,
        .g = 9.81
    }
};

car_trailer_validity_t car_trailer_f64_validate(const car_trailer_f64_t *p)
{
    car_trailer_validity_t validity = CAR_TRAILER_VALID;
    if (!((p->m > 0.0) && (p->m <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_m;
    } else if (!((p->I_ > 0.0) && (p->I_ <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_I_;
    } else if (!((p->a > 0.0) && (p->a <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_a;
    } else if (!((p->b > 0.0) && (p->b <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_b;
    } else if (!((p->h > 0.0) && (p->h <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_h;
    } else if (!((p->mT > 0.0) && (p->mT <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_mT;
    } else if (!((p->IT > 0.0) && (p->IT <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_IT;
    } else if (!((p->e >= -DBL_MAX) && (p->e <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_e;
    } else if (!((p->l > 0.0) && (p->l <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_l;
    } else if (!((p->Cf > 0.0) && (p->Cf <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_Cf;
    } else if (!((p->Cr > 0.0) && (p->Cr <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_Cr;
    } else if (!((p->CT > 0.0) && (p->CT <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_CT;
    } else if (!((p->d >= 0.0) && (p->d <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_d;
    } else if (!((p->t > 0.0) && (p->t <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_t;
    } else if (!((p->r > 0.0) && (p->r <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_r;
    } else if (!((p->g >= 0.0) && (p->g <= DBL_MAX))) {
        validity = CAR_TRAILER_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void car_trailer_f64_matrices(const car_trailer_f64_t *p, car_trailer_f64_matrices_t *matrices)
{
    const double m_all = p->m + p->mT;
    const double t6 = p->mT * (p->e + p->h);
    const double t7 = p->mT * p->e;
    const double M_psi_q = p->IT + (p->e * t6);
    const double Jzz_all = (p->h * t6) + (p->I_ + M_psi_q);
    const double Jyy_q = p->IT + (p->e * t7);
    const double Cm1_11 = p->Cf + p->Cr + p->CT;
    const double t23 = p->h + p->l;
    const double Kc_23 = p->CT * t23;
    const double t26 = p->Cf * p->a;
    const double t29 = p->Cr * p->b;
    const double Kc_33 = p->CT * p->l;
    const double Cm1_22 = (p->a * t26) + ((p->b * t29) + (t23 * Kc_23));
    const double Cm1_23 = t23 * Kc_33;
    const double Cm1_33 = p->l * Kc_33;
    const double M_12 = -t6;
    const double M_13 = -t7;
    const double Cm1_12 = t26 - Kc_23 - t29;
    const double Cm1_13 = -Kc_33;
    const double Kc_13 = -p->CT;
    matrices->m[0][0] = m_all;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = Jzz_all;
    matrices->m[1][2] = M_psi_q;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_psi_q;
    matrices->m[2][2] = Jyy_q;
    matrices->cm1[0][0] = Cm1_11;
    matrices->cm1[0][1] = Cm1_12;
    matrices->cm1[0][2] = Cm1_13;
    matrices->cm1[1][0] = Cm1_12;
    matrices->cm1[1][1] = Cm1_22;
    matrices->cm1[1][2] = Cm1_23;
    matrices->cm1[2][0] = Cm1_13;
    matrices->cm1[2][1] = Cm1_23;
    matrices->cm1[2][2] = Cm1_33;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = 0.0;
    matrices->c0[0][2] = 0.0;
    matrices->c0[1][0] = 0.0;
    matrices->c0[1][1] = 0.0;
    matrices->c0[1][2] = 0.0;
    matrices->c0[2][0] = 0.0;
    matrices->c0[2][1] = 0.0;
    matrices->c0[2][2] = p->d;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = m_all;
    matrices->c1[0][2] = 0.0;
    matrices->c1[1][0] = 0.0;
    matrices->c1[1][1] = M_12;
    matrices->c1[1][2] = 0.0;
    matrices->c1[2][0] = 0.0;
    matrices->c1[2][1] = M_13;
    matrices->c1[2][2] = 0.0;
    matrices->kc[0][0] = 0.0;
    matrices->kc[0][1] = 0.0;
    matrices->kc[0][2] = Kc_13;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = 0.0;
    matrices->kc[1][2] = Kc_23;
    matrices->kc[2][0] = 0.0;
    matrices->kc[2][1] = 0.0;
    matrices->kc[2][2] = Kc_33;
}

carvallo_system_error_t car_trailer_f64_at_speed(const car_trailer_f64_matrices_t *matrices,
    double speed, car_trailer_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed);
    bool is_in_range = true;
    const bool moves = (speed < 0.0) || (speed > 0.0);
    bool is_at_rest = false;
    for (size_t row = 0U; row < CAR_TRAILER_N; row++) {
        for (size_t column = 0U; column < CAR_TRAILER_N; column++) {
            /* Where there is no C-1, nothing is divided by a speed of zero. */
            const double odd = matrices->cm1[row][column];
            const bool divides = (odd < 0.0) || (odd > 0.0);
            double divided = 0.0;
            if (divides && moves) {
                divided = odd / speed;
            } else {
                is_at_rest = is_at_rest || divides;
            }
            const double damping = matrices->c0[row][column] + (matrices->c1[row][column] * speed) +
                divided;
            const double stiffness = matrices->kc[row][column];
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->cm1[row][column]) &&
                carvallo_is_finite_f64(matrices->c0[row][column]) &&
                carvallo_is_finite_f64(matrices->c1[row][column]) &&
                carvallo_is_finite_f64(matrices->kc[row][column]);
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

carvallo_system_error_t car_trailer_f64_state_space(const car_trailer_f64_system_t *system,
    car_trailer_f64_state_space_t *space)
{
    /* The row of A and B for each coordinate, and whether its position is a state beside its rate. */
    static const size_t TARGETS[CAR_TRAILER_N] = {CAR_TRAILER_N + 0U, CAR_TRAILER_N + 1U, CAR_TRAILER_N + 2U};
    static const bool HAS_BOTH[CAR_TRAILER_N] = {false, false, true};
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[CAR_TRAILER_N * CAR_TRAILER_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * CAR_TRAILER_N * CAR_TRAILER_N];
    for (size_t row = 0U; row < CAR_TRAILER_N; row++) {
        double *const solved = &x[3U * CAR_TRAILER_N * row];
        for (size_t column = 0U; column < CAR_TRAILER_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * CAR_TRAILER_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[CAR_TRAILER_N + column] = -system->c[row][column];
            solved[(2U * CAR_TRAILER_N) + column] = 0.0;
        }
        solved[(2U * CAR_TRAILER_N) + row] = 1.0;
        solved[0] = 0.0;
        solved[1] = 0.0;
    }
    if (is_finite) {
        double terms[CAR_TRAILER_N * CAR_TRAILER_N];
        error = carvallo_solve_f64(CAR_TRAILER_N, m, terms, 3U * CAR_TRAILER_N, x);
    }
    for (size_t row = 0U; row < (2U * CAR_TRAILER_N); row++) {
        for (size_t column = 0U; column < (2U * CAR_TRAILER_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < CAR_TRAILER_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < CAR_TRAILER_N; row++) {
            const size_t target = TARGETS[row];
            for (size_t column = 0U; column < (2U * CAR_TRAILER_N); column++) {
                space->a[target][column] = x[(3U * CAR_TRAILER_N * row) + column];
            }
            for (size_t column = 0U; column < CAR_TRAILER_N; column++) {
                space->b[target][column] = x[(3U * CAR_TRAILER_N * row) + (2U * CAR_TRAILER_N) +
                    column];
            }
            if (HAS_BOTH[row]) {
                space->a[row][CAR_TRAILER_N + row] = 1.0;
            }
        }
    }
    return error;
}

double car_trailer_f64_rate_at(const car_trailer_f64_rate_t *rate, double v,
    const double q[CAR_TRAILER_N], const double q_dot[CAR_TRAILER_N], double psi)
{
    double by_coordinates = 0.0;
    double by_rates = 0.0;
    for (size_t i = 0U; i < CAR_TRAILER_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void car_trailer_f64_kinematics(const car_trailer_f64_t *p, car_trailer_f64_kinematics_t *kinematics)
{
    const double t2 = 1.0 / p->r;
    const double t4 = t2 * p->t;
    const double t5 = -t2;
    const double t6 = -t4;
    kinematics->lean.speed = 0.0;
    kinematics->lean.rates[0] = 0.0;
    kinematics->lean.rates[1] = 0.0;
    kinematics->lean.rates[2] = 0.0;
    kinematics->lean.coordinates[0] = 0.0;
    kinematics->lean.coordinates[1] = 0.0;
    kinematics->lean.coordinates[2] = 0.0;
    kinematics->lean.heading = 0.0;
    kinematics->pitch.speed = 0.0;
    kinematics->pitch.rates[0] = 0.0;
    kinematics->pitch.rates[1] = 0.0;
    kinematics->pitch.rates[2] = 0.0;
    kinematics->pitch.coordinates[0] = 0.0;
    kinematics->pitch.coordinates[1] = 0.0;
    kinematics->pitch.coordinates[2] = 0.0;
    kinematics->pitch.heading = 0.0;
    kinematics->wheel_F.speed = t5;
    kinematics->wheel_F.rates[0] = 0.0;
    kinematics->wheel_F.rates[1] = 0.0;
    kinematics->wheel_F.rates[2] = 0.0;
    kinematics->wheel_F.coordinates[0] = 0.0;
    kinematics->wheel_F.coordinates[1] = 0.0;
    kinematics->wheel_F.coordinates[2] = 0.0;
    kinematics->wheel_F.heading = 0.0;
    kinematics->wheel_L.speed = t5;
    kinematics->wheel_L.rates[0] = 0.0;
    kinematics->wheel_L.rates[1] = t6;
    kinematics->wheel_L.rates[2] = 0.0;
    kinematics->wheel_L.coordinates[0] = 0.0;
    kinematics->wheel_L.coordinates[1] = 0.0;
    kinematics->wheel_L.coordinates[2] = 0.0;
    kinematics->wheel_L.heading = 0.0;
    kinematics->wheel_R.speed = t5;
    kinematics->wheel_R.rates[0] = 0.0;
    kinematics->wheel_R.rates[1] = t4;
    kinematics->wheel_R.rates[2] = 0.0;
    kinematics->wheel_R.coordinates[0] = 0.0;
    kinematics->wheel_R.coordinates[1] = 0.0;
    kinematics->wheel_R.coordinates[2] = 0.0;
    kinematics->wheel_R.heading = 0.0;
    kinematics->wheel_U.speed = t5;
    kinematics->wheel_U.rates[0] = 0.0;
    kinematics->wheel_U.rates[1] = 0.0;
    kinematics->wheel_U.rates[2] = 0.0;
    kinematics->wheel_U.coordinates[0] = 0.0;
    kinematics->wheel_U.coordinates[1] = 0.0;
    kinematics->wheel_U.coordinates[2] = 0.0;
    kinematics->wheel_U.heading = 0.0;
}

void car_trailer_f64_derivatives(const car_trailer_f64_t *p, car_trailer_f64_matrices_t *matrices,
    car_trailer_f64_derivatives_t *derivatives)
{
    const double m_all = p->m + p->mT;
    const double t17 = p->e + p->h;
    const double t18 = p->mT * t17;
    const double M_23_h = p->mT * p->e;
    const double M_23_e = t18 + M_23_h;
    const double Jyy_q = (p->e * M_23_h) + p->IT;
    const double M_23_mT = p->e * t17;
    const double M_psi_q = p->IT + (p->mT * M_23_mT);
    const double Cm1_11 = p->Cf + p->Cr + p->CT;
    const double Jzz_all = (p->h * M_23_e) + p->I_ + Jyy_q;
    const double t31 = p->Cr * p->b;
    const double Kc_23_CT = p->h + p->l;
    const double Kc_23 = p->CT * Kc_23_CT;
    const double M_22_mT = t17 * t17;
    const double t35 = p->Cf * p->a;
    const double Cm1_12 = t35 - t31 - Kc_23;
    const double Cm1_22 = (p->b * t31) + (Kc_23_CT * Kc_23) + (p->a * t35);
    const double Cm1_22_a = t35 + t35;
    const double Kc_33 = p->CT * p->l;
    const double Cm1_22_b = t31 + t31;
    const double Cm1_23_CT = p->l * Kc_23_CT;
    const double Cm1_23 = p->CT * Cm1_23_CT;
    const double Cm1_33_CT = p->l * p->l;
    const double Cm1_33 = p->CT * Cm1_33_CT;
    const double M_22_h = t18 + t18;
    const double Cm1_22_h = Kc_23 + Kc_23;
    const double Jyy_q_mT = p->e * p->e;
    const double Jyy_q_e = M_23_h + M_23_h;
    const double Cm1_23_l = Kc_23 + Kc_33;
    const double Cm1_33_l = Kc_33 + Kc_33;
    const double Cm1_22_Cf = p->a * p->a;
    const double Cm1_22_Cr = p->b * p->b;
    const double Cm1_22_CT = Kc_23_CT * Kc_23_CT;
    const double M_12 = -t18;
    const double M_13 = -M_23_h;
    const double Cm1_13 = -Kc_33;
    const double Kc_13 = -p->CT;
    matrices->m[0][0] = m_all;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = Jzz_all;
    matrices->m[1][2] = M_psi_q;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_psi_q;
    matrices->m[2][2] = Jyy_q;
    matrices->cm1[0][0] = Cm1_11;
    matrices->cm1[0][1] = Cm1_12;
    matrices->cm1[0][2] = Cm1_13;
    matrices->cm1[1][0] = Cm1_12;
    matrices->cm1[1][1] = Cm1_22;
    matrices->cm1[1][2] = Cm1_23;
    matrices->cm1[2][0] = Cm1_13;
    matrices->cm1[2][1] = Cm1_23;
    matrices->cm1[2][2] = Cm1_33;
    matrices->c0[0][0] = 0.0;
    matrices->c0[0][1] = 0.0;
    matrices->c0[0][2] = 0.0;
    matrices->c0[1][0] = 0.0;
    matrices->c0[1][1] = 0.0;
    matrices->c0[1][2] = 0.0;
    matrices->c0[2][0] = 0.0;
    matrices->c0[2][1] = 0.0;
    matrices->c0[2][2] = p->d;
    matrices->c1[0][0] = 0.0;
    matrices->c1[0][1] = m_all;
    matrices->c1[0][2] = 0.0;
    matrices->c1[1][0] = 0.0;
    matrices->c1[1][1] = M_12;
    matrices->c1[1][2] = 0.0;
    matrices->c1[2][0] = 0.0;
    matrices->c1[2][1] = M_13;
    matrices->c1[2][2] = 0.0;
    matrices->kc[0][0] = 0.0;
    matrices->kc[0][1] = 0.0;
    matrices->kc[0][2] = Kc_13;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = 0.0;
    matrices->kc[1][2] = Kc_23;
    matrices->kc[2][0] = 0.0;
    matrices->kc[2][1] = 0.0;
    matrices->kc[2][2] = Kc_33;
    derivatives->values[0] = p->a;
    derivatives->values[1] = p->b;
    derivatives->values[2] = p->mT;
    derivatives->values[3] = p->e;
    derivatives->values[4] = p->l;
    derivatives->values[5] = p->Cf;
    derivatives->values[6] = p->Cr;
    derivatives->values[7] = p->CT;
    derivatives->values[8] = 1.0;
    derivatives->values[9] = (-1.0);
    derivatives->values[10] = t17;
    derivatives->values[11] = M_23_h;
    derivatives->values[12] = M_23_e;
    derivatives->values[13] = M_23_mT;
    derivatives->values[14] = Kc_23_CT;
    derivatives->values[15] = M_22_mT;
    derivatives->values[16] = Cm1_22_a;
    derivatives->values[17] = Kc_33;
    derivatives->values[18] = Cm1_22_b;
    derivatives->values[19] = Cm1_23_CT;
    derivatives->values[20] = Cm1_33_CT;
    derivatives->values[21] = M_22_h;
    derivatives->values[22] = Cm1_22_h;
    derivatives->values[23] = Jyy_q_mT;
    derivatives->values[24] = Jyy_q_e;
    derivatives->values[25] = Cm1_23_l;
    derivatives->values[26] = Cm1_33_l;
    derivatives->values[27] = Cm1_22_Cf;
    derivatives->values[28] = Cm1_22_Cr;
    derivatives->values[29] = Cm1_22_CT;
}

void car_trailer_f64_with_respect_to(const car_trailer_f64_derivatives_t *derivatives,
    size_t parameter, car_trailer_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < CAR_TRAILER_N; row++) {
        for (size_t column = 0U; column < CAR_TRAILER_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->cm1[row][column] = 0.0;
            matrices->c0[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->kc[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < CAR_TRAILER_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &car_trailer_partials[position];
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
            case CARVALLO_MATRIX_C0:
                matrices->c0[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_C1:
                matrices->c1[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_KC:
                matrices->kc[partial->row][partial->column] = signed_value;
                break;
            default:
                /* The model has no other matrix. */
                break;
            }
        }
    }
}

const car_trailer_f32_t car_trailer_f32_sets[CAR_TRAILER_SETS] = {
    { /* caravan */
        .m = 1500.0F,
        .I_ = 2500.0F,
        .a = 1.2F,
        .b = 1.5F,
        .h = 2.4F,
        .mT = 1200.0F,
        .IT = 2200.0F,
        .e = 3.5F,
        .l = 3.7F,
        .Cf = 80000.0F,
        .Cr = 100000.0F,
        .CT = 70000.0F,
        .d = 0.0F,
        .t = 0.75F,
        .r = 0.3F,
        .g = 9.81F
    },
    { /* loaded_behind */
        .m = 1500.0F,
        .I_ = 2500.0F,
        .a = 1.2F,
        .b = 1.5F,
        .h = 2.4F,
        .mT = 1200.0F,
        .IT = 3200.0F,
        .e = 3.8F,
        .l = 3.7F,
        .Cf = 80000.0F,
        .Cr = 100000.0F,
        .CT = 70000.0F,
        .d = 0.0F,
        .t = 0.75F,
        .r = 0.3F,
        .g = 9.81F
    }
};

car_trailer_validity_t car_trailer_f32_validate(const car_trailer_f32_t *p)
{
    car_trailer_validity_t validity = CAR_TRAILER_VALID;
    if (!((p->m > 0.0F) && (p->m <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_m;
    } else if (!((p->I_ > 0.0F) && (p->I_ <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_I_;
    } else if (!((p->a > 0.0F) && (p->a <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_a;
    } else if (!((p->b > 0.0F) && (p->b <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_b;
    } else if (!((p->h > 0.0F) && (p->h <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_h;
    } else if (!((p->mT > 0.0F) && (p->mT <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_mT;
    } else if (!((p->IT > 0.0F) && (p->IT <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_IT;
    } else if (!((p->e >= -FLT_MAX) && (p->e <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_e;
    } else if (!((p->l > 0.0F) && (p->l <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_l;
    } else if (!((p->Cf > 0.0F) && (p->Cf <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_Cf;
    } else if (!((p->Cr > 0.0F) && (p->Cr <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_Cr;
    } else if (!((p->CT > 0.0F) && (p->CT <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_CT;
    } else if (!((p->d >= 0.0F) && (p->d <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_d;
    } else if (!((p->t > 0.0F) && (p->t <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_t;
    } else if (!((p->r > 0.0F) && (p->r <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_r;
    } else if (!((p->g >= 0.0F) && (p->g <= FLT_MAX))) {
        validity = CAR_TRAILER_INVALID_g;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void car_trailer_f32_matrices(const car_trailer_f32_t *p, car_trailer_f32_matrices_t *matrices)
{
    const float m_all = p->m + p->mT;
    const float t6 = p->mT * (p->e + p->h);
    const float t7 = p->mT * p->e;
    const float M_psi_q = p->IT + (p->e * t6);
    const float Jzz_all = (p->h * t6) + (p->I_ + M_psi_q);
    const float Jyy_q = p->IT + (p->e * t7);
    const float Cm1_11 = p->Cf + p->Cr + p->CT;
    const float t23 = p->h + p->l;
    const float Kc_23 = p->CT * t23;
    const float t26 = p->Cf * p->a;
    const float t29 = p->Cr * p->b;
    const float Kc_33 = p->CT * p->l;
    const float Cm1_22 = (p->a * t26) + ((p->b * t29) + (t23 * Kc_23));
    const float Cm1_23 = t23 * Kc_33;
    const float Cm1_33 = p->l * Kc_33;
    const float M_12 = -t6;
    const float M_13 = -t7;
    const float Cm1_12 = t26 - Kc_23 - t29;
    const float Cm1_13 = -Kc_33;
    const float Kc_13 = -p->CT;
    matrices->m[0][0] = m_all;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = Jzz_all;
    matrices->m[1][2] = M_psi_q;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_psi_q;
    matrices->m[2][2] = Jyy_q;
    matrices->cm1[0][0] = Cm1_11;
    matrices->cm1[0][1] = Cm1_12;
    matrices->cm1[0][2] = Cm1_13;
    matrices->cm1[1][0] = Cm1_12;
    matrices->cm1[1][1] = Cm1_22;
    matrices->cm1[1][2] = Cm1_23;
    matrices->cm1[2][0] = Cm1_13;
    matrices->cm1[2][1] = Cm1_23;
    matrices->cm1[2][2] = Cm1_33;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[0][2] = 0.0F;
    matrices->c0[1][0] = 0.0F;
    matrices->c0[1][1] = 0.0F;
    matrices->c0[1][2] = 0.0F;
    matrices->c0[2][0] = 0.0F;
    matrices->c0[2][1] = 0.0F;
    matrices->c0[2][2] = p->d;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = m_all;
    matrices->c1[0][2] = 0.0F;
    matrices->c1[1][0] = 0.0F;
    matrices->c1[1][1] = M_12;
    matrices->c1[1][2] = 0.0F;
    matrices->c1[2][0] = 0.0F;
    matrices->c1[2][1] = M_13;
    matrices->c1[2][2] = 0.0F;
    matrices->kc[0][0] = 0.0F;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[0][2] = Kc_13;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = 0.0F;
    matrices->kc[1][2] = Kc_23;
    matrices->kc[2][0] = 0.0F;
    matrices->kc[2][1] = 0.0F;
    matrices->kc[2][2] = Kc_33;
}

carvallo_system_error_t car_trailer_f32_at_speed(const car_trailer_f32_matrices_t *matrices,
    float speed, car_trailer_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed);
    bool is_in_range = true;
    const bool moves = (speed < 0.0F) || (speed > 0.0F);
    bool is_at_rest = false;
    for (size_t row = 0U; row < CAR_TRAILER_N; row++) {
        for (size_t column = 0U; column < CAR_TRAILER_N; column++) {
            /* Where there is no C-1, nothing is divided by a speed of zero. */
            const float odd = matrices->cm1[row][column];
            const bool divides = (odd < 0.0F) || (odd > 0.0F);
            float divided = 0.0F;
            if (divides && moves) {
                divided = odd / speed;
            } else {
                is_at_rest = is_at_rest || divides;
            }
            const float damping = matrices->c0[row][column] + (matrices->c1[row][column] * speed) +
                divided;
            const float stiffness = matrices->kc[row][column];
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->cm1[row][column]) &&
                carvallo_is_finite_f32(matrices->c0[row][column]) &&
                carvallo_is_finite_f32(matrices->c1[row][column]) &&
                carvallo_is_finite_f32(matrices->kc[row][column]);
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

carvallo_system_error_t car_trailer_f32_state_space(const car_trailer_f32_system_t *system,
    car_trailer_f32_state_space_t *space)
{
    /* The row of A and B for each coordinate, and whether its position is a state beside its rate. */
    static const size_t TARGETS[CAR_TRAILER_N] = {CAR_TRAILER_N + 0U, CAR_TRAILER_N + 1U, CAR_TRAILER_N + 2U};
    static const bool HAS_BOTH[CAR_TRAILER_N] = {false, false, true};
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[CAR_TRAILER_N * CAR_TRAILER_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * CAR_TRAILER_N * CAR_TRAILER_N];
    for (size_t row = 0U; row < CAR_TRAILER_N; row++) {
        float *const solved = &x[3U * CAR_TRAILER_N * row];
        for (size_t column = 0U; column < CAR_TRAILER_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * CAR_TRAILER_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[CAR_TRAILER_N + column] = -system->c[row][column];
            solved[(2U * CAR_TRAILER_N) + column] = 0.0F;
        }
        solved[(2U * CAR_TRAILER_N) + row] = 1.0F;
        solved[0] = 0.0F;
        solved[1] = 0.0F;
    }
    if (is_finite) {
        float terms[CAR_TRAILER_N * CAR_TRAILER_N];
        error = carvallo_solve_f32(CAR_TRAILER_N, m, terms, 3U * CAR_TRAILER_N, x);
    }
    for (size_t row = 0U; row < (2U * CAR_TRAILER_N); row++) {
        for (size_t column = 0U; column < (2U * CAR_TRAILER_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < CAR_TRAILER_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < CAR_TRAILER_N; row++) {
            const size_t target = TARGETS[row];
            for (size_t column = 0U; column < (2U * CAR_TRAILER_N); column++) {
                space->a[target][column] = x[(3U * CAR_TRAILER_N * row) + column];
            }
            for (size_t column = 0U; column < CAR_TRAILER_N; column++) {
                space->b[target][column] = x[(3U * CAR_TRAILER_N * row) + (2U * CAR_TRAILER_N) +
                    column];
            }
            if (HAS_BOTH[row]) {
                space->a[row][CAR_TRAILER_N + row] = 1.0F;
            }
        }
    }
    return error;
}

float car_trailer_f32_rate_at(const car_trailer_f32_rate_t *rate, float v,
    const float q[CAR_TRAILER_N], const float q_dot[CAR_TRAILER_N], float psi)
{
    float by_coordinates = 0.0F;
    float by_rates = 0.0F;
    for (size_t i = 0U; i < CAR_TRAILER_N; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}

void car_trailer_f32_kinematics(const car_trailer_f32_t *p, car_trailer_f32_kinematics_t *kinematics)
{
    const float t2 = 1.0F / p->r;
    const float t4 = t2 * p->t;
    const float t5 = -t2;
    const float t6 = -t4;
    kinematics->lean.speed = 0.0F;
    kinematics->lean.rates[0] = 0.0F;
    kinematics->lean.rates[1] = 0.0F;
    kinematics->lean.rates[2] = 0.0F;
    kinematics->lean.coordinates[0] = 0.0F;
    kinematics->lean.coordinates[1] = 0.0F;
    kinematics->lean.coordinates[2] = 0.0F;
    kinematics->lean.heading = 0.0F;
    kinematics->pitch.speed = 0.0F;
    kinematics->pitch.rates[0] = 0.0F;
    kinematics->pitch.rates[1] = 0.0F;
    kinematics->pitch.rates[2] = 0.0F;
    kinematics->pitch.coordinates[0] = 0.0F;
    kinematics->pitch.coordinates[1] = 0.0F;
    kinematics->pitch.coordinates[2] = 0.0F;
    kinematics->pitch.heading = 0.0F;
    kinematics->wheel_F.speed = t5;
    kinematics->wheel_F.rates[0] = 0.0F;
    kinematics->wheel_F.rates[1] = 0.0F;
    kinematics->wheel_F.rates[2] = 0.0F;
    kinematics->wheel_F.coordinates[0] = 0.0F;
    kinematics->wheel_F.coordinates[1] = 0.0F;
    kinematics->wheel_F.coordinates[2] = 0.0F;
    kinematics->wheel_F.heading = 0.0F;
    kinematics->wheel_L.speed = t5;
    kinematics->wheel_L.rates[0] = 0.0F;
    kinematics->wheel_L.rates[1] = t6;
    kinematics->wheel_L.rates[2] = 0.0F;
    kinematics->wheel_L.coordinates[0] = 0.0F;
    kinematics->wheel_L.coordinates[1] = 0.0F;
    kinematics->wheel_L.coordinates[2] = 0.0F;
    kinematics->wheel_L.heading = 0.0F;
    kinematics->wheel_R.speed = t5;
    kinematics->wheel_R.rates[0] = 0.0F;
    kinematics->wheel_R.rates[1] = t4;
    kinematics->wheel_R.rates[2] = 0.0F;
    kinematics->wheel_R.coordinates[0] = 0.0F;
    kinematics->wheel_R.coordinates[1] = 0.0F;
    kinematics->wheel_R.coordinates[2] = 0.0F;
    kinematics->wheel_R.heading = 0.0F;
    kinematics->wheel_U.speed = t5;
    kinematics->wheel_U.rates[0] = 0.0F;
    kinematics->wheel_U.rates[1] = 0.0F;
    kinematics->wheel_U.rates[2] = 0.0F;
    kinematics->wheel_U.coordinates[0] = 0.0F;
    kinematics->wheel_U.coordinates[1] = 0.0F;
    kinematics->wheel_U.coordinates[2] = 0.0F;
    kinematics->wheel_U.heading = 0.0F;
}

void car_trailer_f32_derivatives(const car_trailer_f32_t *p, car_trailer_f32_matrices_t *matrices,
    car_trailer_f32_derivatives_t *derivatives)
{
    const float m_all = p->m + p->mT;
    const float t17 = p->e + p->h;
    const float t18 = p->mT * t17;
    const float M_23_h = p->mT * p->e;
    const float M_23_e = t18 + M_23_h;
    const float Jyy_q = (p->e * M_23_h) + p->IT;
    const float M_23_mT = p->e * t17;
    const float M_psi_q = p->IT + (p->mT * M_23_mT);
    const float Cm1_11 = p->Cf + p->Cr + p->CT;
    const float Jzz_all = (p->h * M_23_e) + p->I_ + Jyy_q;
    const float t31 = p->Cr * p->b;
    const float Kc_23_CT = p->h + p->l;
    const float Kc_23 = p->CT * Kc_23_CT;
    const float M_22_mT = t17 * t17;
    const float t35 = p->Cf * p->a;
    const float Cm1_12 = t35 - t31 - Kc_23;
    const float Cm1_22 = (p->b * t31) + (Kc_23_CT * Kc_23) + (p->a * t35);
    const float Cm1_22_a = t35 + t35;
    const float Kc_33 = p->CT * p->l;
    const float Cm1_22_b = t31 + t31;
    const float Cm1_23_CT = p->l * Kc_23_CT;
    const float Cm1_23 = p->CT * Cm1_23_CT;
    const float Cm1_33_CT = p->l * p->l;
    const float Cm1_33 = p->CT * Cm1_33_CT;
    const float M_22_h = t18 + t18;
    const float Cm1_22_h = Kc_23 + Kc_23;
    const float Jyy_q_mT = p->e * p->e;
    const float Jyy_q_e = M_23_h + M_23_h;
    const float Cm1_23_l = Kc_23 + Kc_33;
    const float Cm1_33_l = Kc_33 + Kc_33;
    const float Cm1_22_Cf = p->a * p->a;
    const float Cm1_22_Cr = p->b * p->b;
    const float Cm1_22_CT = Kc_23_CT * Kc_23_CT;
    const float M_12 = -t18;
    const float M_13 = -M_23_h;
    const float Cm1_13 = -Kc_33;
    const float Kc_13 = -p->CT;
    matrices->m[0][0] = m_all;
    matrices->m[0][1] = M_12;
    matrices->m[0][2] = M_13;
    matrices->m[1][0] = M_12;
    matrices->m[1][1] = Jzz_all;
    matrices->m[1][2] = M_psi_q;
    matrices->m[2][0] = M_13;
    matrices->m[2][1] = M_psi_q;
    matrices->m[2][2] = Jyy_q;
    matrices->cm1[0][0] = Cm1_11;
    matrices->cm1[0][1] = Cm1_12;
    matrices->cm1[0][2] = Cm1_13;
    matrices->cm1[1][0] = Cm1_12;
    matrices->cm1[1][1] = Cm1_22;
    matrices->cm1[1][2] = Cm1_23;
    matrices->cm1[2][0] = Cm1_13;
    matrices->cm1[2][1] = Cm1_23;
    matrices->cm1[2][2] = Cm1_33;
    matrices->c0[0][0] = 0.0F;
    matrices->c0[0][1] = 0.0F;
    matrices->c0[0][2] = 0.0F;
    matrices->c0[1][0] = 0.0F;
    matrices->c0[1][1] = 0.0F;
    matrices->c0[1][2] = 0.0F;
    matrices->c0[2][0] = 0.0F;
    matrices->c0[2][1] = 0.0F;
    matrices->c0[2][2] = p->d;
    matrices->c1[0][0] = 0.0F;
    matrices->c1[0][1] = m_all;
    matrices->c1[0][2] = 0.0F;
    matrices->c1[1][0] = 0.0F;
    matrices->c1[1][1] = M_12;
    matrices->c1[1][2] = 0.0F;
    matrices->c1[2][0] = 0.0F;
    matrices->c1[2][1] = M_13;
    matrices->c1[2][2] = 0.0F;
    matrices->kc[0][0] = 0.0F;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[0][2] = Kc_13;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = 0.0F;
    matrices->kc[1][2] = Kc_23;
    matrices->kc[2][0] = 0.0F;
    matrices->kc[2][1] = 0.0F;
    matrices->kc[2][2] = Kc_33;
    derivatives->values[0] = p->a;
    derivatives->values[1] = p->b;
    derivatives->values[2] = p->mT;
    derivatives->values[3] = p->e;
    derivatives->values[4] = p->l;
    derivatives->values[5] = p->Cf;
    derivatives->values[6] = p->Cr;
    derivatives->values[7] = p->CT;
    derivatives->values[8] = 1.0F;
    derivatives->values[9] = (-1.0F);
    derivatives->values[10] = t17;
    derivatives->values[11] = M_23_h;
    derivatives->values[12] = M_23_e;
    derivatives->values[13] = M_23_mT;
    derivatives->values[14] = Kc_23_CT;
    derivatives->values[15] = M_22_mT;
    derivatives->values[16] = Cm1_22_a;
    derivatives->values[17] = Kc_33;
    derivatives->values[18] = Cm1_22_b;
    derivatives->values[19] = Cm1_23_CT;
    derivatives->values[20] = Cm1_33_CT;
    derivatives->values[21] = M_22_h;
    derivatives->values[22] = Cm1_22_h;
    derivatives->values[23] = Jyy_q_mT;
    derivatives->values[24] = Jyy_q_e;
    derivatives->values[25] = Cm1_23_l;
    derivatives->values[26] = Cm1_33_l;
    derivatives->values[27] = Cm1_22_Cf;
    derivatives->values[28] = Cm1_22_Cr;
    derivatives->values[29] = Cm1_22_CT;
}

void car_trailer_f32_with_respect_to(const car_trailer_f32_derivatives_t *derivatives,
    size_t parameter, car_trailer_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < CAR_TRAILER_N; row++) {
        for (size_t column = 0U; column < CAR_TRAILER_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->cm1[row][column] = 0.0F;
            matrices->c0[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->kc[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < CAR_TRAILER_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &car_trailer_partials[position];
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
            case CARVALLO_MATRIX_C0:
                matrices->c0[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_C1:
                matrices->c1[partial->row][partial->column] = signed_value;
                break;
            case CARVALLO_MATRIX_KC:
                matrices->kc[partial->row][partial->column] = signed_value;
                break;
            default:
                /* The model has no other matrix. */
                break;
            }
        }
    }
}
