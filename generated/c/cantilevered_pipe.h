/* @generated from generated/models/cantilevered_pipe.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 0185b6c845d15a5e
 */

/**
 * @file cantilevered_pipe.h
 * @brief The model `CantileveredPipe`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * A cantilevered pipe that carries a fluid, in its first four modes: it flutters above a critical speed.
 *
 * A slender elastic pipe, clamped where the fluid enters and free where it leaves, in a horizontal plane and without
 * damping of its own. The deflection is a sum of the first four modes of the clamped beam (Galerkin), each with a
 * mean square of one over the length, so that its end is deflected by twice its coordinate. The speed v is that of the
 * fluid; textbooks have it as u = v l sqrt(f/EI), and the part of the fluid in the mass as beta = f/(m + f).
 *
 * Source: Gregory & Paidoussis (1966), Unstable oscillation of tubular cantilevers conveying fluid, Proc. R. Soc. A 293, 512-527; integrals of the modes: Paidoussis, Fluid-Structure Interactions, vol. 1
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `first` in m: Deflection in the first mode.
 * - `second` in m: Deflection in the second mode.
 * - `third` in m: Deflection in the third mode.
 * - `fourth` in m: Deflection in the fourth mode.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_CANTILEVERED_PIPE_H
#define CARVALLO_MODEL_CANTILEVERED_PIPE_H

#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define CANTILEVERED_PIPE_N 4U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `beta_02`.
     *
     * Source: beta = 0.2, with v = u
     */
    CANTILEVERED_PIPE_SET_BETA_02 = 0,
    /**
     * The parameter set `beta_05`.
     *
     * Source: beta = 0.5, with v = u
     */
    CANTILEVERED_PIPE_SET_BETA_05 = 1,
    /**
     * The parameter set `beta_07`.
     *
     * Source: beta = 0.7, with v = u: four modes lose their stability, regain and lose it
     */
    CANTILEVERED_PIPE_SET_BETA_07 = 2
} cantilevered_pipe_set_t;

/** How many parameter sets there are. */
#define CANTILEVERED_PIPE_SETS 3U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *cantilevered_pipe_set_name(cantilevered_pipe_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    CANTILEVERED_PIPE_VALID = 0,
    /** `l` in m must be finite and > 0. */
    CANTILEVERED_PIPE_INVALID_l = 1,
    /** `EI` in N*m^2 must be finite and > 0. */
    CANTILEVERED_PIPE_INVALID_EI = 2,
    /** `m` in kg/m must be finite and > 0. */
    CANTILEVERED_PIPE_INVALID_m = 3,
    /** `f` in kg/m must be finite and >= 0. */
    CANTILEVERED_PIPE_INVALID_f = 4
} cantilevered_pipe_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *cantilevered_pipe_validity_text(cantilevered_pipe_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define CANTILEVERED_PIPE_PARTIALS 68U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t cantilevered_pipe_partials[CANTILEVERED_PIPE_PARTIALS];

/* ------------------------------------------------------------ double */

/** The parameters of `CantileveredPipe`. */
typedef struct {
    /** Length. `l`, in m: > 0. */
    double l;
    /** Flexural rigidity. `EI`, in N*m^2: > 0. */
    double EI;
    /** Mass of the pipe for each metre. `m`, in kg/m: > 0. */
    double m;
    /** Mass of the fluid in it for each metre. `f`, in kg/m: >= 0. */
    double f;
} cantilevered_pipe_f64_t;

/** The parameter sets, such as `cantilevered_pipe_f64_sets[CANTILEVERED_PIPE_SET_BETA_02]`. */
extern const cantilevered_pipe_f64_t cantilevered_pipe_f64_sets[CANTILEVERED_PIPE_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
cantilevered_pipe_validity_t cantilevered_pipe_f64_validate(const cantilevered_pipe_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
    /** Damping C1, a coefficient of v q'. */
    double c1[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
    /** Stiffness Kc, a coefficient of q. Symmetric, proved. */
    double kc[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    double k2[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
} cantilevered_pipe_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 1 addition, 36 multiplications, 2 divisions and 11 negations: 50 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void cantilevered_pipe_f64_matrices(const cantilevered_pipe_f64_t *p, cantilevered_pipe_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
} cantilevered_pipe_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t cantilevered_pipe_f64_at_speed(const cantilevered_pipe_f64_matrices_t *matrices,
    double speed, cantilevered_pipe_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * CANTILEVERED_PIPE_N][2U * CANTILEVERED_PIPE_N];
    /** The input matrix B. */
    double b[2U * CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
} cantilevered_pipe_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t cantilevered_pipe_f64_state_space(const cantilevered_pipe_f64_system_t *system,
    cantilevered_pipe_f64_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `cantilevered_pipe_partials`.
 */
typedef struct {
    double values[55];
} cantilevered_pipe_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 1 addition, 81 multiplications, 3 divisions and 11 negations: 96 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void cantilevered_pipe_f64_derivatives(const cantilevered_pipe_f64_t *p,
    cantilevered_pipe_f64_matrices_t *matrices, cantilevered_pipe_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void cantilevered_pipe_f64_with_respect_to(const cantilevered_pipe_f64_derivatives_t *derivatives,
    size_t parameter, cantilevered_pipe_f64_matrices_t *matrices);

/* ------------------------------------------------------------ float */

/** The parameters of `CantileveredPipe`. */
typedef struct {
    /** Length. `l`, in m: > 0. */
    float l;
    /** Flexural rigidity. `EI`, in N*m^2: > 0. */
    float EI;
    /** Mass of the pipe for each metre. `m`, in kg/m: > 0. */
    float m;
    /** Mass of the fluid in it for each metre. `f`, in kg/m: >= 0. */
    float f;
} cantilevered_pipe_f32_t;

/** The parameter sets, such as `cantilevered_pipe_f32_sets[CANTILEVERED_PIPE_SET_BETA_02]`. */
extern const cantilevered_pipe_f32_t cantilevered_pipe_f32_sets[CANTILEVERED_PIPE_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
cantilevered_pipe_validity_t cantilevered_pipe_f32_validate(const cantilevered_pipe_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
    /** Damping C1, a coefficient of v q'. */
    float c1[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
    /** Stiffness Kc, a coefficient of q. Symmetric, proved. */
    float kc[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    float k2[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
} cantilevered_pipe_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 1 addition, 36 multiplications, 2 divisions and 11 negations: 50 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void cantilevered_pipe_f32_matrices(const cantilevered_pipe_f32_t *p, cantilevered_pipe_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
} cantilevered_pipe_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t cantilevered_pipe_f32_at_speed(const cantilevered_pipe_f32_matrices_t *matrices,
    float speed, cantilevered_pipe_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * CANTILEVERED_PIPE_N][2U * CANTILEVERED_PIPE_N];
    /** The input matrix B. */
    float b[2U * CANTILEVERED_PIPE_N][CANTILEVERED_PIPE_N];
} cantilevered_pipe_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t cantilevered_pipe_f32_state_space(const cantilevered_pipe_f32_system_t *system,
    cantilevered_pipe_f32_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `cantilevered_pipe_partials`.
 */
typedef struct {
    float values[55];
} cantilevered_pipe_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 1 addition, 81 multiplications, 3 divisions and 11 negations: 96 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void cantilevered_pipe_f32_derivatives(const cantilevered_pipe_f32_t *p,
    cantilevered_pipe_f32_matrices_t *matrices, cantilevered_pipe_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void cantilevered_pipe_f32_with_respect_to(const cantilevered_pipe_f32_derivatives_t *derivatives,
    size_t parameter, cantilevered_pipe_f32_matrices_t *matrices);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_CANTILEVERED_PIPE_H */
