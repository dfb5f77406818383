/* @generated from generated/models/cantilevered_pipe.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 0185b6c845d15a5e
 */

/**
 * @file
 * The programs below are made of these formulas, which are those of the matrices:
 *
 * @verbatim
 * mass = (m + f)*l [kg]
 * stiffness = EI/l^3 [kg/s^2]
 * flow = f/l [kg/m^2]
 * lam1 = 1.875104068711961166445308 [1]
 * lam2 = 4.694091132974174576436392 [1]
 * lam3 = 7.854757438237612564861009 [1]
 * lam4 = 10.99554073487546699066735 [1]
 * n1 = 0.7340955137589127558287828*lam1 [1]
 * n2 = 1.018467318759219405032741*lam2 [1]
 * n3 = 0.9992244965174282872163576*lam3 [1]
 * n4 = 1.000033553251713398399016*lam4 [1]
 * M_11 = M_22 = M_33 = M_44 = mass [kg]
 * C1_11 = C1_22 = C1_33 = C1_44 = 4*f [kg/m]
 * C1_12 = 8*f/((lam1/lam2)^2 - 1) [kg/m]
 * C1_13 = 8*f/((lam1/lam3)^2 + 1) [kg/m]
 * C1_14 = 8*f/((lam1/lam4)^2 - 1) [kg/m]
 * C1_21 = 8*f/((lam2/lam1)^2 - 1) [kg/m]
 * C1_23 = 8*f/((lam2/lam3)^2 - 1) [kg/m]
 * C1_24 = 8*f/((lam2/lam4)^2 + 1) [kg/m]
 * C1_31 = 8*f/((lam3/lam1)^2 + 1) [kg/m]
 * C1_32 = 8*f/((lam3/lam2)^2 - 1) [kg/m]
 * C1_34 = 8*f/((lam3/lam4)^2 - 1) [kg/m]
 * C1_41 = 8*f/((lam4/lam1)^2 - 1) [kg/m]
 * C1_42 = 8*f/((lam4/lam2)^2 + 1) [kg/m]
 * C1_43 = 8*f/((lam4/lam3)^2 - 1) [kg/m]
 * Kc_11 = stiffness*lam1^4 [kg/s^2]
 * Kc_22 = stiffness*lam2^4 [kg/s^2]
 * Kc_33 = stiffness*lam3^4 [kg/s^2]
 * Kc_44 = stiffness*lam4^4 [kg/s^2]
 * K2_11 = flow*n1*(2 - n1) [kg/m^2]
 * K2_12 = 4*flow*(n2 - n1)/(-1 - (lam1/lam2)^2) [kg/m^2]
 * K2_13 = 4*flow*(n3 - n1)/(1 - (lam1/lam3)^2) [kg/m^2]
 * K2_14 = 4*flow*(n4 - n1)/(-1 - (lam1/lam4)^2) [kg/m^2]
 * K2_21 = 4*flow*(n1 - n2)/(-1 - (lam2/lam1)^2) [kg/m^2]
 * K2_22 = flow*n2*(2 - n2) [kg/m^2]
 * K2_23 = 4*flow*(n3 - n2)/(-1 - (lam2/lam3)^2) [kg/m^2]
 * K2_24 = 4*flow*(n4 - n2)/(1 - (lam2/lam4)^2) [kg/m^2]
 * K2_31 = 4*flow*(n1 - n3)/(1 - (lam3/lam1)^2) [kg/m^2]
 * K2_32 = 4*flow*(n2 - n3)/(-1 - (lam3/lam2)^2) [kg/m^2]
 * K2_33 = flow*n3*(2 - n3) [kg/m^2]
 * K2_34 = 4*flow*(n4 - n3)/(-1 - (lam3/lam4)^2) [kg/m^2]
 * K2_41 = 4*flow*(n1 - n4)/(-1 - (lam4/lam1)^2) [kg/m^2]
 * K2_42 = 4*flow*(n2 - n4)/(1 - (lam4/lam2)^2) [kg/m^2]
 * K2_43 = 4*flow*(n3 - n4)/(-1 - (lam4/lam3)^2) [kg/m^2]
 * K2_44 = flow*n4*(2 - n4) [kg/m^2]
 * @endverbatim
 */

#include "cantilevered_pipe.h"

#include <float.h>

const char *cantilevered_pipe_set_name(cantilevered_pipe_set_t set)
{
    static const char *const TEXTS[] = {
        "beta_02",
        "beta_05",
        "beta_07",
    };
    const size_t position = (size_t)set;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such set";
}

const char *cantilevered_pipe_validity_text(cantilevered_pipe_validity_t validity)
{
    static const char *const TEXTS[] = {
        "CantileveredPipe: the parameters are valid",
        "CantileveredPipe: l in m must be finite and > 0",
        "CantileveredPipe: EI in N*m^2 must be finite and > 0",
        "CantileveredPipe: m in kg/m must be finite and > 0",
        "CantileveredPipe: f in kg/m must be finite and >= 0",
    };
    const size_t position = (size_t)validity;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such code";
}

const carvallo_partial_t cantilevered_pipe_partials[CANTILEVERED_PIPE_PARTIALS] = {
    {CARVALLO_MATRIX_M, 0U, 0U, 0U, 14U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 0U, 14U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 0U, 14U, false},
    {CARVALLO_MATRIX_M, 3U, 3U, 0U, 14U, false},
    {CARVALLO_MATRIX_KC, 0U, 0U, 0U, 23U, true},
    {CARVALLO_MATRIX_KC, 1U, 1U, 0U, 24U, true},
    {CARVALLO_MATRIX_KC, 2U, 2U, 0U, 25U, true},
    {CARVALLO_MATRIX_KC, 3U, 3U, 0U, 26U, true},
    {CARVALLO_MATRIX_K2, 0U, 0U, 0U, 27U, true},
    {CARVALLO_MATRIX_K2, 0U, 1U, 0U, 28U, false},
    {CARVALLO_MATRIX_K2, 0U, 2U, 0U, 29U, true},
    {CARVALLO_MATRIX_K2, 0U, 3U, 0U, 30U, false},
    {CARVALLO_MATRIX_K2, 1U, 0U, 0U, 31U, true},
    {CARVALLO_MATRIX_K2, 1U, 1U, 0U, 32U, false},
    {CARVALLO_MATRIX_K2, 1U, 2U, 0U, 33U, false},
    {CARVALLO_MATRIX_K2, 1U, 3U, 0U, 34U, true},
    {CARVALLO_MATRIX_K2, 2U, 0U, 0U, 35U, true},
    {CARVALLO_MATRIX_K2, 2U, 1U, 0U, 36U, true},
    {CARVALLO_MATRIX_K2, 2U, 2U, 0U, 37U, false},
    {CARVALLO_MATRIX_K2, 2U, 3U, 0U, 38U, false},
    {CARVALLO_MATRIX_K2, 3U, 0U, 0U, 39U, true},
    {CARVALLO_MATRIX_K2, 3U, 1U, 0U, 40U, true},
    {CARVALLO_MATRIX_K2, 3U, 2U, 0U, 41U, true},
    {CARVALLO_MATRIX_K2, 3U, 3U, 0U, 42U, false},
    {CARVALLO_MATRIX_KC, 0U, 0U, 1U, 43U, false},
    {CARVALLO_MATRIX_KC, 1U, 1U, 1U, 44U, false},
    {CARVALLO_MATRIX_KC, 2U, 2U, 1U, 45U, false},
    {CARVALLO_MATRIX_KC, 3U, 3U, 1U, 46U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 2U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 2U, 0U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 2U, 0U, false},
    {CARVALLO_MATRIX_M, 3U, 3U, 2U, 0U, false},
    {CARVALLO_MATRIX_M, 0U, 0U, 3U, 0U, false},
    {CARVALLO_MATRIX_M, 1U, 1U, 3U, 0U, false},
    {CARVALLO_MATRIX_M, 2U, 2U, 3U, 0U, false},
    {CARVALLO_MATRIX_M, 3U, 3U, 3U, 0U, false},
    {CARVALLO_MATRIX_C1, 0U, 0U, 3U, 1U, false},
    {CARVALLO_MATRIX_C1, 0U, 1U, 3U, 10U, false},
    {CARVALLO_MATRIX_C1, 0U, 2U, 3U, 2U, false},
    {CARVALLO_MATRIX_C1, 0U, 3U, 3U, 11U, false},
    {CARVALLO_MATRIX_C1, 1U, 0U, 3U, 3U, false},
    {CARVALLO_MATRIX_C1, 1U, 1U, 3U, 1U, false},
    {CARVALLO_MATRIX_C1, 1U, 2U, 3U, 12U, false},
    {CARVALLO_MATRIX_C1, 1U, 3U, 3U, 4U, false},
    {CARVALLO_MATRIX_C1, 2U, 0U, 3U, 5U, false},
    {CARVALLO_MATRIX_C1, 2U, 1U, 3U, 6U, false},
    {CARVALLO_MATRIX_C1, 2U, 2U, 3U, 1U, false},
    {CARVALLO_MATRIX_C1, 2U, 3U, 3U, 13U, false},
    {CARVALLO_MATRIX_C1, 3U, 0U, 3U, 7U, false},
    {CARVALLO_MATRIX_C1, 3U, 1U, 3U, 8U, false},
    {CARVALLO_MATRIX_C1, 3U, 2U, 3U, 9U, false},
    {CARVALLO_MATRIX_C1, 3U, 3U, 3U, 1U, false},
    {CARVALLO_MATRIX_K2, 0U, 0U, 3U, 15U, false},
    {CARVALLO_MATRIX_K2, 0U, 1U, 3U, 16U, true},
    {CARVALLO_MATRIX_K2, 0U, 2U, 3U, 17U, false},
    {CARVALLO_MATRIX_K2, 0U, 3U, 3U, 18U, true},
    {CARVALLO_MATRIX_K2, 1U, 0U, 3U, 19U, false},
    {CARVALLO_MATRIX_K2, 1U, 1U, 3U, 20U, true},
    {CARVALLO_MATRIX_K2, 1U, 2U, 3U, 21U, true},
    {CARVALLO_MATRIX_K2, 1U, 3U, 3U, 22U, false},
    {CARVALLO_MATRIX_K2, 2U, 0U, 3U, 47U, false},
    {CARVALLO_MATRIX_K2, 2U, 1U, 3U, 48U, false},
    {CARVALLO_MATRIX_K2, 2U, 2U, 3U, 49U, true},
    {CARVALLO_MATRIX_K2, 2U, 3U, 3U, 50U, true},
    {CARVALLO_MATRIX_K2, 3U, 0U, 3U, 51U, false},
    {CARVALLO_MATRIX_K2, 3U, 1U, 3U, 52U, false},
    {CARVALLO_MATRIX_K2, 3U, 2U, 3U, 53U, false},
    {CARVALLO_MATRIX_K2, 3U, 3U, 3U, 54U, true}
};

const cantilevered_pipe_f64_t cantilevered_pipe_f64_sets[CANTILEVERED_PIPE_SETS] = {
    { /* beta_02 */
        .l = 1.0,
        .EI = 1.0,
        .m = 4.0,
        .f = 1.0
    },
    { /* beta_05 */
        .l = 1.0,
        .EI = 1.0,
        .m = 1.0,
        .f = 1.0
    },
    { /* beta_07 */
        .l = 1.0,
        .EI = 1.0,
        .m = 0.42857142857142855,
        .f = 1.0
    }
};

cantilevered_pipe_validity_t cantilevered_pipe_f64_validate(const cantilevered_pipe_f64_t *p)
{
    cantilevered_pipe_validity_t validity = CANTILEVERED_PIPE_VALID;
    if (!((p->l > 0.0) && (p->l <= DBL_MAX))) {
        validity = CANTILEVERED_PIPE_INVALID_l;
    } else if (!((p->EI > 0.0) && (p->EI <= DBL_MAX))) {
        validity = CANTILEVERED_PIPE_INVALID_EI;
    } else if (!((p->m > 0.0) && (p->m <= DBL_MAX))) {
        validity = CANTILEVERED_PIPE_INVALID_m;
    } else if (!((p->f >= 0.0) && (p->f <= DBL_MAX))) {
        validity = CANTILEVERED_PIPE_INVALID_f;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void cantilevered_pipe_f64_matrices(const cantilevered_pipe_f64_t *p, cantilevered_pipe_f64_matrices_t *matrices)
{
    const double mass = p->l * (p->m + p->f);
    const double C1_11 = p->f * 4.0;
    const double C1_13 = p->f * 7.568674603525367;
    const double C1_21 = p->f * 1.5189220591449966;
    const double C1_24 = p->f * 6.766752743711723;
    const double C1_31 = p->f * 0.43132539647463314;
    const double C1_32 = p->f * 4.4443729491027995;
    const double C1_41 = p->f * 0.2396209592479588;
    const double C1_42 = p->f * 1.2332472562882775;
    const double C1_43 = p->f * 8.336799302190666;
    const double stiffness = p->EI / (p->l * p->l * p->l);
    const double Kc_11 = stiffness * 12.362363368326191;
    const double Kc_22 = stiffness * 485.51881851337106;
    const double Kc_33 = stiffness * 3806.546266391451;
    const double Kc_44 = stiffness * 14617.27330511878;
    const double flow = p->f / p->l;
    const double K2_11 = flow * 0.8582436200114997;
    const double K2_13 = flow * 27.45314869883141;
    const double K2_21 = flow * 1.8738533309718404;
    const double K2_24 = flow * 30.40116729418553;
    const double K2_31 = flow * 1.564506451563535;
    const double K2_32 = flow * 3.229330799040317;
    const double K2_41 = flow * 1.087366479542848;
    const double K2_42 = flow * 5.540642250946188;
    const double K2_43 = flow * 4.253605462830704;
    const double C1_12 = -(p->f * 9.518922059144996);
    const double C1_14 = -(p->f * 8.23962095924796);
    const double C1_23 = -(p->f * 12.4443729491028);
    const double C1_34 = -(p->f * 16.336799302190666);
    const double K2_12 = -(flow * 11.743238371184557);
    const double K2_14 = -(flow * 37.39025026585289);
    const double K2_22 = -(flow * 13.294285387122411);
    const double K2_23 = -(flow * 9.04221974607116);
    const double K2_33 = -(flow * 45.904226616338164);
    const double K2_34 = -(flow * 8.33536903529716);
    const double K2_44 = -(flow * 98.91821015122053);
    matrices->m[0][0] = mass;
    matrices->m[0][1] = 0.0;
    matrices->m[0][2] = 0.0;
    matrices->m[0][3] = 0.0;
    matrices->m[1][0] = 0.0;
    matrices->m[1][1] = mass;
    matrices->m[1][2] = 0.0;
    matrices->m[1][3] = 0.0;
    matrices->m[2][0] = 0.0;
    matrices->m[2][1] = 0.0;
    matrices->m[2][2] = mass;
    matrices->m[2][3] = 0.0;
    matrices->m[3][0] = 0.0;
    matrices->m[3][1] = 0.0;
    matrices->m[3][2] = 0.0;
    matrices->m[3][3] = mass;
    matrices->c1[0][0] = C1_11;
    matrices->c1[0][1] = C1_12;
    matrices->c1[0][2] = C1_13;
    matrices->c1[0][3] = C1_14;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_11;
    matrices->c1[1][2] = C1_23;
    matrices->c1[1][3] = C1_24;
    matrices->c1[2][0] = C1_31;
    matrices->c1[2][1] = C1_32;
    matrices->c1[2][2] = C1_11;
    matrices->c1[2][3] = C1_34;
    matrices->c1[3][0] = C1_41;
    matrices->c1[3][1] = C1_42;
    matrices->c1[3][2] = C1_43;
    matrices->c1[3][3] = C1_11;
    matrices->kc[0][0] = Kc_11;
    matrices->kc[0][1] = 0.0;
    matrices->kc[0][2] = 0.0;
    matrices->kc[0][3] = 0.0;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = Kc_22;
    matrices->kc[1][2] = 0.0;
    matrices->kc[1][3] = 0.0;
    matrices->kc[2][0] = 0.0;
    matrices->kc[2][1] = 0.0;
    matrices->kc[2][2] = Kc_33;
    matrices->kc[2][3] = 0.0;
    matrices->kc[3][0] = 0.0;
    matrices->kc[3][1] = 0.0;
    matrices->kc[3][2] = 0.0;
    matrices->kc[3][3] = Kc_44;
    matrices->k2[0][0] = K2_11;
    matrices->k2[0][1] = K2_12;
    matrices->k2[0][2] = K2_13;
    matrices->k2[0][3] = K2_14;
    matrices->k2[1][0] = K2_21;
    matrices->k2[1][1] = K2_22;
    matrices->k2[1][2] = K2_23;
    matrices->k2[1][3] = K2_24;
    matrices->k2[2][0] = K2_31;
    matrices->k2[2][1] = K2_32;
    matrices->k2[2][2] = K2_33;
    matrices->k2[2][3] = K2_34;
    matrices->k2[3][0] = K2_41;
    matrices->k2[3][1] = K2_42;
    matrices->k2[3][2] = K2_43;
    matrices->k2[3][3] = K2_44;
}

carvallo_system_error_t cantilevered_pipe_f64_at_speed(const cantilevered_pipe_f64_matrices_t *matrices,
    double speed, cantilevered_pipe_f64_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f64(speed);
    bool is_in_range = true;
    for (size_t row = 0U; row < CANTILEVERED_PIPE_N; row++) {
        for (size_t column = 0U; column < CANTILEVERED_PIPE_N; column++) {
            const double damping = matrices->c1[row][column] * speed;
            const double stiffness = matrices->kc[row][column] + (matrices->k2[row][column] *
                speed * speed);
            is_finite = is_finite && carvallo_is_finite_f64(matrices->m[row][column]) &&
                carvallo_is_finite_f64(matrices->c1[row][column]) &&
                carvallo_is_finite_f64(matrices->kc[row][column]) &&
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

carvallo_system_error_t cantilevered_pipe_f64_state_space(const cantilevered_pipe_f64_system_t *system,
    cantilevered_pipe_f64_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    double m[CANTILEVERED_PIPE_N * CANTILEVERED_PIPE_N];
    /* The columns of -K, -C and the identity matrix. */
    double x[3U * CANTILEVERED_PIPE_N * CANTILEVERED_PIPE_N];
    for (size_t row = 0U; row < CANTILEVERED_PIPE_N; row++) {
        double *const solved = &x[3U * CANTILEVERED_PIPE_N * row];
        for (size_t column = 0U; column < CANTILEVERED_PIPE_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f64(system->m[row][column]) &&
                carvallo_is_finite_f64(system->c[row][column]) &&
                carvallo_is_finite_f64(system->k[row][column]);
            m[(row * CANTILEVERED_PIPE_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[CANTILEVERED_PIPE_N + column] = -system->c[row][column];
            solved[(2U * CANTILEVERED_PIPE_N) + column] = 0.0;
        }
        solved[(2U * CANTILEVERED_PIPE_N) + row] = 1.0;
    }
    if (is_finite) {
        double terms[CANTILEVERED_PIPE_N * CANTILEVERED_PIPE_N];
        error = carvallo_solve_f64(CANTILEVERED_PIPE_N, m, terms, 3U * CANTILEVERED_PIPE_N, x);
    }
    for (size_t row = 0U; row < (2U * CANTILEVERED_PIPE_N); row++) {
        for (size_t column = 0U; column < (2U * CANTILEVERED_PIPE_N); column++) {
            space->a[row][column] = 0.0;
        }
        for (size_t column = 0U; column < CANTILEVERED_PIPE_N; column++) {
            space->b[row][column] = 0.0;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < CANTILEVERED_PIPE_N; row++) {
            const size_t target = CANTILEVERED_PIPE_N + row;
            for (size_t column = 0U; column < (2U * CANTILEVERED_PIPE_N); column++) {
                space->a[target][column] = x[(3U * CANTILEVERED_PIPE_N * row) + column];
            }
            for (size_t column = 0U; column < CANTILEVERED_PIPE_N; column++) {
                space->b[target][column] = x[(3U * CANTILEVERED_PIPE_N * row) + (2U *
                    CANTILEVERED_PIPE_N) + column];
            }
            space->a[row][CANTILEVERED_PIPE_N + row] = 1.0;
        }
    }
    return error;
}

void cantilevered_pipe_f64_derivatives(const cantilevered_pipe_f64_t *p,
    cantilevered_pipe_f64_matrices_t *matrices, cantilevered_pipe_f64_derivatives_t *derivatives)
{
    const double M_11_l = p->m + p->f;
    const double mass = p->l * M_11_l;
    const double C1_11 = p->f * 4.0;
    const double C1_13 = p->f * 7.568674603525367;
    const double C1_21 = p->f * 1.5189220591449966;
    const double C1_24 = p->f * 6.766752743711723;
    const double C1_31 = p->f * 0.43132539647463314;
    const double C1_32 = p->f * 4.4443729491027995;
    const double C1_41 = p->f * 0.2396209592479588;
    const double C1_42 = p->f * 1.2332472562882775;
    const double C1_43 = p->f * 8.336799302190666;
    const double t54 = p->l * p->l;
    const double t56 = 1.0 / (p->l * t54);
    const double t57 = 1.0 / p->l;
    const double t60 = p->EI * 3.0 / (t54 * t54);
    const double C1_12 = -(p->f * 9.518922059144996);
    const double flow = p->f * t57;
    const double K2_11_f = t57 * 0.8582436200114997;
    const double t65 = t57 * 11.743238371184557;
    const double K2_13_f = t57 * 27.45314869883141;
    const double t67 = t57 * 37.39025026585289;
    const double K2_21_f = t57 * 1.8738533309718404;
    const double t69 = t57 * 13.294285387122413;
    const double t70 = t57 * 9.04221974607116;
    const double K2_24_f = t57 * 30.40116729418553;
    const double K2_11 = flow * 0.8582436200114997;
    const double K2_13 = flow * 27.45314869883141;
    const double K2_21 = flow * 1.8738533309718404;
    const double K2_24 = flow * 30.40116729418553;
    const double K2_31 = flow * 1.564506451563535;
    const double K2_32 = flow * 3.229330799040317;
    const double K2_41 = flow * 1.087366479542848;
    const double stiffness = p->EI * t56;
    const double K2_42 = flow * 5.540642250946188;
    const double K2_43 = flow * 4.253605462830704;
    const double t82 = 12.362363368326193 * t60;
    const double t83 = 485.51881851337106 * t60;
    const double t84 = 3806.546266391451 * t60;
    const double t85 = 14617.27330511878 * t60;
    const double t86 = t57 * flow;
    const double t87 = 0.8582436200114997 * t86;
    const double K2_12_l = 11.743238371184557 * t86;
    const double Kc_11 = stiffness * 12.362363368326193;
    const double Kc_22 = stiffness * 485.51881851337106;
    const double Kc_33 = stiffness * 3806.546266391451;
    const double Kc_44 = stiffness * 14617.27330511878;
    const double t93 = 27.45314869883141 * t86;
    const double K2_14_l = 37.39025026585289 * t86;
    const double t95 = 1.8738533309718404 * t86;
    const double K2_22_l = 13.294285387122413 * t86;
    const double K2_23_l = 9.04221974607116 * t86;
    const double t98 = 30.40116729418553 * t86;
    const double t99 = 1.564506451563535 * t86;
    const double t100 = 3.229330799040317 * t86;
    const double K2_33_l = 45.90422661633816 * t86;
    const double K2_34_l = 8.33536903529716 * t86;
    const double t103 = 1.087366479542848 * t86;
    const double t104 = 5.540642250946188 * t86;
    const double t105 = 4.253605462830704 * t86;
    const double K2_44_l = 98.91821015122052 * t86;
    const double Kc_11_EI = t56 * 12.362363368326193;
    const double Kc_22_EI = t56 * 485.51881851337106;
    const double Kc_33_EI = t56 * 3806.546266391451;
    const double Kc_44_EI = t56 * 14617.27330511878;
    const double K2_31_f = t57 * 1.564506451563535;
    const double K2_32_f = t57 * 3.229330799040317;
    const double t113 = t57 * 45.90422661633816;
    const double t114 = t57 * 8.33536903529716;
    const double K2_41_f = t57 * 1.087366479542848;
    const double K2_42_f = t57 * 5.540642250946188;
    const double K2_43_f = t57 * 4.253605462830704;
    const double t118 = t57 * 98.91821015122052;
    const double C1_14 = -(p->f * 8.23962095924796);
    const double C1_23 = -(p->f * 12.4443729491028);
    const double C1_34 = -(p->f * 16.336799302190666);
    const double K2_12 = -(flow * 11.743238371184557);
    const double K2_14 = -(flow * 37.39025026585289);
    const double K2_22 = -(flow * 13.294285387122413);
    const double K2_23 = -(flow * 9.04221974607116);
    const double K2_33 = -(flow * 45.90422661633816);
    const double K2_34 = -(flow * 8.33536903529716);
    const double K2_44 = -(flow * 98.91821015122052);
    matrices->m[0][0] = mass;
    matrices->m[0][1] = 0.0;
    matrices->m[0][2] = 0.0;
    matrices->m[0][3] = 0.0;
    matrices->m[1][0] = 0.0;
    matrices->m[1][1] = mass;
    matrices->m[1][2] = 0.0;
    matrices->m[1][3] = 0.0;
    matrices->m[2][0] = 0.0;
    matrices->m[2][1] = 0.0;
    matrices->m[2][2] = mass;
    matrices->m[2][3] = 0.0;
    matrices->m[3][0] = 0.0;
    matrices->m[3][1] = 0.0;
    matrices->m[3][2] = 0.0;
    matrices->m[3][3] = mass;
    matrices->c1[0][0] = C1_11;
    matrices->c1[0][1] = C1_12;
    matrices->c1[0][2] = C1_13;
    matrices->c1[0][3] = C1_14;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_11;
    matrices->c1[1][2] = C1_23;
    matrices->c1[1][3] = C1_24;
    matrices->c1[2][0] = C1_31;
    matrices->c1[2][1] = C1_32;
    matrices->c1[2][2] = C1_11;
    matrices->c1[2][3] = C1_34;
    matrices->c1[3][0] = C1_41;
    matrices->c1[3][1] = C1_42;
    matrices->c1[3][2] = C1_43;
    matrices->c1[3][3] = C1_11;
    matrices->kc[0][0] = Kc_11;
    matrices->kc[0][1] = 0.0;
    matrices->kc[0][2] = 0.0;
    matrices->kc[0][3] = 0.0;
    matrices->kc[1][0] = 0.0;
    matrices->kc[1][1] = Kc_22;
    matrices->kc[1][2] = 0.0;
    matrices->kc[1][3] = 0.0;
    matrices->kc[2][0] = 0.0;
    matrices->kc[2][1] = 0.0;
    matrices->kc[2][2] = Kc_33;
    matrices->kc[2][3] = 0.0;
    matrices->kc[3][0] = 0.0;
    matrices->kc[3][1] = 0.0;
    matrices->kc[3][2] = 0.0;
    matrices->kc[3][3] = Kc_44;
    matrices->k2[0][0] = K2_11;
    matrices->k2[0][1] = K2_12;
    matrices->k2[0][2] = K2_13;
    matrices->k2[0][3] = K2_14;
    matrices->k2[1][0] = K2_21;
    matrices->k2[1][1] = K2_22;
    matrices->k2[1][2] = K2_23;
    matrices->k2[1][3] = K2_24;
    matrices->k2[2][0] = K2_31;
    matrices->k2[2][1] = K2_32;
    matrices->k2[2][2] = K2_33;
    matrices->k2[2][3] = K2_34;
    matrices->k2[3][0] = K2_41;
    matrices->k2[3][1] = K2_42;
    matrices->k2[3][2] = K2_43;
    matrices->k2[3][3] = K2_44;
    derivatives->values[0] = p->l;
    derivatives->values[1] = 4.0;
    derivatives->values[2] = 7.568674603525367;
    derivatives->values[3] = 1.5189220591449966;
    derivatives->values[4] = 6.766752743711723;
    derivatives->values[5] = 0.43132539647463314;
    derivatives->values[6] = 4.4443729491027995;
    derivatives->values[7] = 0.2396209592479588;
    derivatives->values[8] = 1.2332472562882775;
    derivatives->values[9] = 8.336799302190666;
    derivatives->values[10] = (-9.518922059144996);
    derivatives->values[11] = (-8.23962095924796);
    derivatives->values[12] = (-12.4443729491028);
    derivatives->values[13] = (-16.336799302190666);
    derivatives->values[14] = M_11_l;
    derivatives->values[15] = K2_11_f;
    derivatives->values[16] = t65;
    derivatives->values[17] = K2_13_f;
    derivatives->values[18] = t67;
    derivatives->values[19] = K2_21_f;
    derivatives->values[20] = t69;
    derivatives->values[21] = t70;
    derivatives->values[22] = K2_24_f;
    derivatives->values[23] = t82;
    derivatives->values[24] = t83;
    derivatives->values[25] = t84;
    derivatives->values[26] = t85;
    derivatives->values[27] = t87;
    derivatives->values[28] = K2_12_l;
    derivatives->values[29] = t93;
    derivatives->values[30] = K2_14_l;
    derivatives->values[31] = t95;
    derivatives->values[32] = K2_22_l;
    derivatives->values[33] = K2_23_l;
    derivatives->values[34] = t98;
    derivatives->values[35] = t99;
    derivatives->values[36] = t100;
    derivatives->values[37] = K2_33_l;
    derivatives->values[38] = K2_34_l;
    derivatives->values[39] = t103;
    derivatives->values[40] = t104;
    derivatives->values[41] = t105;
    derivatives->values[42] = K2_44_l;
    derivatives->values[43] = Kc_11_EI;
    derivatives->values[44] = Kc_22_EI;
    derivatives->values[45] = Kc_33_EI;
    derivatives->values[46] = Kc_44_EI;
    derivatives->values[47] = K2_31_f;
    derivatives->values[48] = K2_32_f;
    derivatives->values[49] = t113;
    derivatives->values[50] = t114;
    derivatives->values[51] = K2_41_f;
    derivatives->values[52] = K2_42_f;
    derivatives->values[53] = K2_43_f;
    derivatives->values[54] = t118;
}

void cantilevered_pipe_f64_with_respect_to(const cantilevered_pipe_f64_derivatives_t *derivatives,
    size_t parameter, cantilevered_pipe_f64_matrices_t *matrices)
{
    for (size_t row = 0U; row < CANTILEVERED_PIPE_N; row++) {
        for (size_t column = 0U; column < CANTILEVERED_PIPE_N; column++) {
            matrices->m[row][column] = 0.0;
            matrices->c1[row][column] = 0.0;
            matrices->kc[row][column] = 0.0;
            matrices->k2[row][column] = 0.0;
        }
    }
    for (size_t position = 0U; position < CANTILEVERED_PIPE_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &cantilevered_pipe_partials[position];
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

const cantilevered_pipe_f32_t cantilevered_pipe_f32_sets[CANTILEVERED_PIPE_SETS] = {
    { /* beta_02 */
        .l = 1.0F,
        .EI = 1.0F,
        .m = 4.0F,
        .f = 1.0F
    },
    { /* beta_05 */
        .l = 1.0F,
        .EI = 1.0F,
        .m = 1.0F,
        .f = 1.0F
    },
    { /* beta_07 */
        .l = 1.0F,
        .EI = 1.0F,
        .m = 0.42857143F,
        .f = 1.0F
    }
};

cantilevered_pipe_validity_t cantilevered_pipe_f32_validate(const cantilevered_pipe_f32_t *p)
{
    cantilevered_pipe_validity_t validity = CANTILEVERED_PIPE_VALID;
    if (!((p->l > 0.0F) && (p->l <= FLT_MAX))) {
        validity = CANTILEVERED_PIPE_INVALID_l;
    } else if (!((p->EI > 0.0F) && (p->EI <= FLT_MAX))) {
        validity = CANTILEVERED_PIPE_INVALID_EI;
    } else if (!((p->m > 0.0F) && (p->m <= FLT_MAX))) {
        validity = CANTILEVERED_PIPE_INVALID_m;
    } else if (!((p->f >= 0.0F) && (p->f <= FLT_MAX))) {
        validity = CANTILEVERED_PIPE_INVALID_f;
    } else {
        /* All are in their domains. */
    }
    return validity;
}

void cantilevered_pipe_f32_matrices(const cantilevered_pipe_f32_t *p, cantilevered_pipe_f32_matrices_t *matrices)
{
    const float mass = p->l * (p->m + p->f);
    const float C1_11 = p->f * 4.0F;
    const float C1_13 = p->f * 7.5686746F;
    const float C1_21 = p->f * 1.5189221F;
    const float C1_24 = p->f * 6.7667527F;
    const float C1_31 = p->f * 0.4313254F;
    const float C1_32 = p->f * 4.444373F;
    const float C1_41 = p->f * 0.23962095F;
    const float C1_42 = p->f * 1.2332473F;
    const float C1_43 = p->f * 8.3368F;
    const float stiffness = p->EI / (p->l * p->l * p->l);
    const float Kc_11 = stiffness * 12.362364F;
    const float Kc_22 = stiffness * 485.51883F;
    const float Kc_33 = stiffness * 3806.5464F;
    const float Kc_44 = stiffness * 14617.273F;
    const float flow = p->f / p->l;
    const float K2_11 = flow * 0.85824364F;
    const float K2_13 = flow * 27.453148F;
    const float K2_21 = flow * 1.8738533F;
    const float K2_24 = flow * 30.401167F;
    const float K2_31 = flow * 1.5645064F;
    const float K2_32 = flow * 3.2293308F;
    const float K2_41 = flow * 1.0873665F;
    const float K2_42 = flow * 5.5406423F;
    const float K2_43 = flow * 4.2536054F;
    const float C1_12 = -(p->f * 9.518922F);
    const float C1_14 = -(p->f * 8.239621F);
    const float C1_23 = -(p->f * 12.444373F);
    const float C1_34 = -(p->f * 16.3368F);
    const float K2_12 = -(flow * 11.743238F);
    const float K2_14 = -(flow * 37.39025F);
    const float K2_22 = -(flow * 13.294286F);
    const float K2_23 = -(flow * 9.04222F);
    const float K2_33 = -(flow * 45.90423F);
    const float K2_34 = -(flow * 8.335369F);
    const float K2_44 = -(flow * 98.91821F);
    matrices->m[0][0] = mass;
    matrices->m[0][1] = 0.0F;
    matrices->m[0][2] = 0.0F;
    matrices->m[0][3] = 0.0F;
    matrices->m[1][0] = 0.0F;
    matrices->m[1][1] = mass;
    matrices->m[1][2] = 0.0F;
    matrices->m[1][3] = 0.0F;
    matrices->m[2][0] = 0.0F;
    matrices->m[2][1] = 0.0F;
    matrices->m[2][2] = mass;
    matrices->m[2][3] = 0.0F;
    matrices->m[3][0] = 0.0F;
    matrices->m[3][1] = 0.0F;
    matrices->m[3][2] = 0.0F;
    matrices->m[3][3] = mass;
    matrices->c1[0][0] = C1_11;
    matrices->c1[0][1] = C1_12;
    matrices->c1[0][2] = C1_13;
    matrices->c1[0][3] = C1_14;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_11;
    matrices->c1[1][2] = C1_23;
    matrices->c1[1][3] = C1_24;
    matrices->c1[2][0] = C1_31;
    matrices->c1[2][1] = C1_32;
    matrices->c1[2][2] = C1_11;
    matrices->c1[2][3] = C1_34;
    matrices->c1[3][0] = C1_41;
    matrices->c1[3][1] = C1_42;
    matrices->c1[3][2] = C1_43;
    matrices->c1[3][3] = C1_11;
    matrices->kc[0][0] = Kc_11;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[0][2] = 0.0F;
    matrices->kc[0][3] = 0.0F;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = Kc_22;
    matrices->kc[1][2] = 0.0F;
    matrices->kc[1][3] = 0.0F;
    matrices->kc[2][0] = 0.0F;
    matrices->kc[2][1] = 0.0F;
    matrices->kc[2][2] = Kc_33;
    matrices->kc[2][3] = 0.0F;
    matrices->kc[3][0] = 0.0F;
    matrices->kc[3][1] = 0.0F;
    matrices->kc[3][2] = 0.0F;
    matrices->kc[3][3] = Kc_44;
    matrices->k2[0][0] = K2_11;
    matrices->k2[0][1] = K2_12;
    matrices->k2[0][2] = K2_13;
    matrices->k2[0][3] = K2_14;
    matrices->k2[1][0] = K2_21;
    matrices->k2[1][1] = K2_22;
    matrices->k2[1][2] = K2_23;
    matrices->k2[1][3] = K2_24;
    matrices->k2[2][0] = K2_31;
    matrices->k2[2][1] = K2_32;
    matrices->k2[2][2] = K2_33;
    matrices->k2[2][3] = K2_34;
    matrices->k2[3][0] = K2_41;
    matrices->k2[3][1] = K2_42;
    matrices->k2[3][2] = K2_43;
    matrices->k2[3][3] = K2_44;
}

carvallo_system_error_t cantilevered_pipe_f32_at_speed(const cantilevered_pipe_f32_matrices_t *matrices,
    float speed, cantilevered_pipe_f32_system_t *system)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = carvallo_is_finite_f32(speed);
    bool is_in_range = true;
    for (size_t row = 0U; row < CANTILEVERED_PIPE_N; row++) {
        for (size_t column = 0U; column < CANTILEVERED_PIPE_N; column++) {
            const float damping = matrices->c1[row][column] * speed;
            const float stiffness = matrices->kc[row][column] + (matrices->k2[row][column] * speed *
                speed);
            is_finite = is_finite && carvallo_is_finite_f32(matrices->m[row][column]) &&
                carvallo_is_finite_f32(matrices->c1[row][column]) &&
                carvallo_is_finite_f32(matrices->kc[row][column]) &&
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

carvallo_system_error_t cantilevered_pipe_f32_state_space(const cantilevered_pipe_f32_system_t *system,
    cantilevered_pipe_f32_state_space_t *space)
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    float m[CANTILEVERED_PIPE_N * CANTILEVERED_PIPE_N];
    /* The columns of -K, -C and the identity matrix. */
    float x[3U * CANTILEVERED_PIPE_N * CANTILEVERED_PIPE_N];
    for (size_t row = 0U; row < CANTILEVERED_PIPE_N; row++) {
        float *const solved = &x[3U * CANTILEVERED_PIPE_N * row];
        for (size_t column = 0U; column < CANTILEVERED_PIPE_N; column++) {
            is_finite = is_finite && carvallo_is_finite_f32(system->m[row][column]) &&
                carvallo_is_finite_f32(system->c[row][column]) &&
                carvallo_is_finite_f32(system->k[row][column]);
            m[(row * CANTILEVERED_PIPE_N) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[CANTILEVERED_PIPE_N + column] = -system->c[row][column];
            solved[(2U * CANTILEVERED_PIPE_N) + column] = 0.0F;
        }
        solved[(2U * CANTILEVERED_PIPE_N) + row] = 1.0F;
    }
    if (is_finite) {
        float terms[CANTILEVERED_PIPE_N * CANTILEVERED_PIPE_N];
        error = carvallo_solve_f32(CANTILEVERED_PIPE_N, m, terms, 3U * CANTILEVERED_PIPE_N, x);
    }
    for (size_t row = 0U; row < (2U * CANTILEVERED_PIPE_N); row++) {
        for (size_t column = 0U; column < (2U * CANTILEVERED_PIPE_N); column++) {
            space->a[row][column] = 0.0F;
        }
        for (size_t column = 0U; column < CANTILEVERED_PIPE_N; column++) {
            space->b[row][column] = 0.0F;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < CANTILEVERED_PIPE_N; row++) {
            const size_t target = CANTILEVERED_PIPE_N + row;
            for (size_t column = 0U; column < (2U * CANTILEVERED_PIPE_N); column++) {
                space->a[target][column] = x[(3U * CANTILEVERED_PIPE_N * row) + column];
            }
            for (size_t column = 0U; column < CANTILEVERED_PIPE_N; column++) {
                space->b[target][column] = x[(3U * CANTILEVERED_PIPE_N * row) + (2U *
                    CANTILEVERED_PIPE_N) + column];
            }
            space->a[row][CANTILEVERED_PIPE_N + row] = 1.0F;
        }
    }
    return error;
}

void cantilevered_pipe_f32_derivatives(const cantilevered_pipe_f32_t *p,
    cantilevered_pipe_f32_matrices_t *matrices, cantilevered_pipe_f32_derivatives_t *derivatives)
{
    const float M_11_l = p->m + p->f;
    const float mass = p->l * M_11_l;
    const float C1_11 = p->f * 4.0F;
    const float C1_13 = p->f * 7.5686746F;
    const float C1_21 = p->f * 1.5189221F;
    const float C1_24 = p->f * 6.7667527F;
    const float C1_31 = p->f * 0.4313254F;
    const float C1_32 = p->f * 4.444373F;
    const float C1_41 = p->f * 0.23962095F;
    const float C1_42 = p->f * 1.2332473F;
    const float C1_43 = p->f * 8.3368F;
    const float t54 = p->l * p->l;
    const float t56 = 1.0F / (p->l * t54);
    const float t57 = 1.0F / p->l;
    const float t60 = p->EI * 3.0F / (t54 * t54);
    const float C1_12 = -(p->f * 9.518922F);
    const float flow = p->f * t57;
    const float K2_11_f = t57 * 0.85824364F;
    const float t65 = t57 * 11.743238F;
    const float K2_13_f = t57 * 27.453148F;
    const float t67 = t57 * 37.39025F;
    const float K2_21_f = t57 * 1.8738533F;
    const float t69 = t57 * 13.294286F;
    const float t70 = t57 * 9.04222F;
    const float K2_24_f = t57 * 30.401167F;
    const float K2_11 = flow * 0.85824364F;
    const float K2_13 = flow * 27.453148F;
    const float K2_21 = flow * 1.8738533F;
    const float K2_24 = flow * 30.401167F;
    const float K2_31 = flow * 1.5645064F;
    const float K2_32 = flow * 3.2293308F;
    const float K2_41 = flow * 1.0873665F;
    const float stiffness = p->EI * t56;
    const float K2_42 = flow * 5.5406423F;
    const float K2_43 = flow * 4.2536054F;
    const float t82 = 12.362364F * t60;
    const float t83 = 485.51883F * t60;
    const float t84 = 3806.5464F * t60;
    const float t85 = 14617.273F * t60;
    const float t86 = t57 * flow;
    const float t87 = 0.85824364F * t86;
    const float K2_12_l = 11.743238F * t86;
    const float Kc_11 = stiffness * 12.362364F;
    const float Kc_22 = stiffness * 485.51883F;
    const float Kc_33 = stiffness * 3806.5464F;
    const float Kc_44 = stiffness * 14617.273F;
    const float t93 = 27.453148F * t86;
    const float K2_14_l = 37.39025F * t86;
    const float t95 = 1.8738533F * t86;
    const float K2_22_l = 13.294286F * t86;
    const float K2_23_l = 9.04222F * t86;
    const float t98 = 30.401167F * t86;
    const float t99 = 1.5645064F * t86;
    const float t100 = 3.2293308F * t86;
    const float K2_33_l = 45.90423F * t86;
    const float K2_34_l = 8.335369F * t86;
    const float t103 = 1.0873665F * t86;
    const float t104 = 5.5406423F * t86;
    const float t105 = 4.2536054F * t86;
    const float K2_44_l = 98.91821F * t86;
    const float Kc_11_EI = t56 * 12.362364F;
    const float Kc_22_EI = t56 * 485.51883F;
    const float Kc_33_EI = t56 * 3806.5464F;
    const float Kc_44_EI = t56 * 14617.273F;
    const float K2_31_f = t57 * 1.5645064F;
    const float K2_32_f = t57 * 3.2293308F;
    const float t113 = t57 * 45.90423F;
    const float t114 = t57 * 8.335369F;
    const float K2_41_f = t57 * 1.0873665F;
    const float K2_42_f = t57 * 5.5406423F;
    const float K2_43_f = t57 * 4.2536054F;
    const float t118 = t57 * 98.91821F;
    const float C1_14 = -(p->f * 8.239621F);
    const float C1_23 = -(p->f * 12.444373F);
    const float C1_34 = -(p->f * 16.3368F);
    const float K2_12 = -(flow * 11.743238F);
    const float K2_14 = -(flow * 37.39025F);
    const float K2_22 = -(flow * 13.294286F);
    const float K2_23 = -(flow * 9.04222F);
    const float K2_33 = -(flow * 45.90423F);
    const float K2_34 = -(flow * 8.335369F);
    const float K2_44 = -(flow * 98.91821F);
    matrices->m[0][0] = mass;
    matrices->m[0][1] = 0.0F;
    matrices->m[0][2] = 0.0F;
    matrices->m[0][3] = 0.0F;
    matrices->m[1][0] = 0.0F;
    matrices->m[1][1] = mass;
    matrices->m[1][2] = 0.0F;
    matrices->m[1][3] = 0.0F;
    matrices->m[2][0] = 0.0F;
    matrices->m[2][1] = 0.0F;
    matrices->m[2][2] = mass;
    matrices->m[2][3] = 0.0F;
    matrices->m[3][0] = 0.0F;
    matrices->m[3][1] = 0.0F;
    matrices->m[3][2] = 0.0F;
    matrices->m[3][3] = mass;
    matrices->c1[0][0] = C1_11;
    matrices->c1[0][1] = C1_12;
    matrices->c1[0][2] = C1_13;
    matrices->c1[0][3] = C1_14;
    matrices->c1[1][0] = C1_21;
    matrices->c1[1][1] = C1_11;
    matrices->c1[1][2] = C1_23;
    matrices->c1[1][3] = C1_24;
    matrices->c1[2][0] = C1_31;
    matrices->c1[2][1] = C1_32;
    matrices->c1[2][2] = C1_11;
    matrices->c1[2][3] = C1_34;
    matrices->c1[3][0] = C1_41;
    matrices->c1[3][1] = C1_42;
    matrices->c1[3][2] = C1_43;
    matrices->c1[3][3] = C1_11;
    matrices->kc[0][0] = Kc_11;
    matrices->kc[0][1] = 0.0F;
    matrices->kc[0][2] = 0.0F;
    matrices->kc[0][3] = 0.0F;
    matrices->kc[1][0] = 0.0F;
    matrices->kc[1][1] = Kc_22;
    matrices->kc[1][2] = 0.0F;
    matrices->kc[1][3] = 0.0F;
    matrices->kc[2][0] = 0.0F;
    matrices->kc[2][1] = 0.0F;
    matrices->kc[2][2] = Kc_33;
    matrices->kc[2][3] = 0.0F;
    matrices->kc[3][0] = 0.0F;
    matrices->kc[3][1] = 0.0F;
    matrices->kc[3][2] = 0.0F;
    matrices->kc[3][3] = Kc_44;
    matrices->k2[0][0] = K2_11;
    matrices->k2[0][1] = K2_12;
    matrices->k2[0][2] = K2_13;
    matrices->k2[0][3] = K2_14;
    matrices->k2[1][0] = K2_21;
    matrices->k2[1][1] = K2_22;
    matrices->k2[1][2] = K2_23;
    matrices->k2[1][3] = K2_24;
    matrices->k2[2][0] = K2_31;
    matrices->k2[2][1] = K2_32;
    matrices->k2[2][2] = K2_33;
    matrices->k2[2][3] = K2_34;
    matrices->k2[3][0] = K2_41;
    matrices->k2[3][1] = K2_42;
    matrices->k2[3][2] = K2_43;
    matrices->k2[3][3] = K2_44;
    derivatives->values[0] = p->l;
    derivatives->values[1] = 4.0F;
    derivatives->values[2] = 7.5686746F;
    derivatives->values[3] = 1.5189221F;
    derivatives->values[4] = 6.7667527F;
    derivatives->values[5] = 0.4313254F;
    derivatives->values[6] = 4.444373F;
    derivatives->values[7] = 0.23962095F;
    derivatives->values[8] = 1.2332473F;
    derivatives->values[9] = 8.3368F;
    derivatives->values[10] = (-9.518922F);
    derivatives->values[11] = (-8.239621F);
    derivatives->values[12] = (-12.444373F);
    derivatives->values[13] = (-16.3368F);
    derivatives->values[14] = M_11_l;
    derivatives->values[15] = K2_11_f;
    derivatives->values[16] = t65;
    derivatives->values[17] = K2_13_f;
    derivatives->values[18] = t67;
    derivatives->values[19] = K2_21_f;
    derivatives->values[20] = t69;
    derivatives->values[21] = t70;
    derivatives->values[22] = K2_24_f;
    derivatives->values[23] = t82;
    derivatives->values[24] = t83;
    derivatives->values[25] = t84;
    derivatives->values[26] = t85;
    derivatives->values[27] = t87;
    derivatives->values[28] = K2_12_l;
    derivatives->values[29] = t93;
    derivatives->values[30] = K2_14_l;
    derivatives->values[31] = t95;
    derivatives->values[32] = K2_22_l;
    derivatives->values[33] = K2_23_l;
    derivatives->values[34] = t98;
    derivatives->values[35] = t99;
    derivatives->values[36] = t100;
    derivatives->values[37] = K2_33_l;
    derivatives->values[38] = K2_34_l;
    derivatives->values[39] = t103;
    derivatives->values[40] = t104;
    derivatives->values[41] = t105;
    derivatives->values[42] = K2_44_l;
    derivatives->values[43] = Kc_11_EI;
    derivatives->values[44] = Kc_22_EI;
    derivatives->values[45] = Kc_33_EI;
    derivatives->values[46] = Kc_44_EI;
    derivatives->values[47] = K2_31_f;
    derivatives->values[48] = K2_32_f;
    derivatives->values[49] = t113;
    derivatives->values[50] = t114;
    derivatives->values[51] = K2_41_f;
    derivatives->values[52] = K2_42_f;
    derivatives->values[53] = K2_43_f;
    derivatives->values[54] = t118;
}

void cantilevered_pipe_f32_with_respect_to(const cantilevered_pipe_f32_derivatives_t *derivatives,
    size_t parameter, cantilevered_pipe_f32_matrices_t *matrices)
{
    for (size_t row = 0U; row < CANTILEVERED_PIPE_N; row++) {
        for (size_t column = 0U; column < CANTILEVERED_PIPE_N; column++) {
            matrices->m[row][column] = 0.0F;
            matrices->c1[row][column] = 0.0F;
            matrices->kc[row][column] = 0.0F;
            matrices->k2[row][column] = 0.0F;
        }
    }
    for (size_t position = 0U; position < CANTILEVERED_PIPE_PARTIALS; position++) {
        const carvallo_partial_t *const partial = &cantilevered_pipe_partials[position];
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
