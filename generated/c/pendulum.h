/* @generated from generated/models/pendulum.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 9f6bf78d3baf1a60
 */

/**
 * @file pendulum.h
 * @brief The model `Pendulum`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * A pendulum with a damped joint, hanging at rest.
 *
 * A point mass on a massless rod.
 *
 * Source: Newton's second law about the joint
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `theta` (swing) in rad: Angle of the rod from the vertical.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_PENDULUM_H
#define CARVALLO_MODEL_PENDULUM_H

#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define PENDULUM_N 1U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `seconds`.
     *
     * Source: a bob of 2 kg that passes its lowest point once a second, nearly
     */
    PENDULUM_SET_SECONDS = 0
} pendulum_set_t;

/** How many parameter sets there are. */
#define PENDULUM_SETS 1U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *pendulum_set_name(pendulum_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    PENDULUM_VALID = 0,
    /** `m` in kg must be finite and > 0. */
    PENDULUM_INVALID_m = 1,
    /** `l` in m must be finite and > 0. */
    PENDULUM_INVALID_l = 2,
    /** `c` in N*m*s must be finite and >= 0. */
    PENDULUM_INVALID_c = 3,
    /** `g` in N/kg must be finite and >= 0. */
    PENDULUM_INVALID_g = 4
} pendulum_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *pendulum_validity_text(pendulum_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define PENDULUM_PARTIALS 5U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t pendulum_partials[PENDULUM_PARTIALS];

/* ------------------------------------------------------------ double */

/** The parameters of `Pendulum`. */
typedef struct {
    /** Mass of the bob. `m`, in kg: > 0. */
    double m;
    /** Length of the rod. `l`, in m: > 0. */
    double l;
    /** Damping of the joint. `c`, in N*m*s: >= 0. */
    double c;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    double g;
} pendulum_f64_t;

/** The parameter sets, such as `pendulum_f64_sets[PENDULUM_SET_SECONDS]`. */
extern const pendulum_f64_t pendulum_f64_sets[PENDULUM_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
pendulum_validity_t pendulum_f64_validate(const pendulum_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[PENDULUM_N][PENDULUM_N];
    /** Damping C0, a coefficient of q'. */
    double c0[PENDULUM_N][PENDULUM_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    double k0[PENDULUM_N][PENDULUM_N];
} pendulum_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 2 multiplications.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void pendulum_f64_matrices(const pendulum_f64_t *p, pendulum_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[PENDULUM_N][PENDULUM_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[PENDULUM_N][PENDULUM_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[PENDULUM_N][PENDULUM_N];
} pendulum_f64_system_t;

/**
 * The equations of motion.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t pendulum_f64_system(const pendulum_f64_matrices_t *matrices, double gravity,
    pendulum_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * PENDULUM_N][2U * PENDULUM_N];
    /** The input matrix B. */
    double b[2U * PENDULUM_N][PENDULUM_N];
} pendulum_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t pendulum_f64_state_space(const pendulum_f64_system_t *system,
    pendulum_f64_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `pendulum_partials`.
 */
typedef struct {
    double values[5];
} pendulum_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 1 addition and 3 multiplications: 4 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void pendulum_f64_derivatives(const pendulum_f64_t *p, pendulum_f64_matrices_t *matrices,
    pendulum_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void pendulum_f64_with_respect_to(const pendulum_f64_derivatives_t *derivatives, size_t parameter,
    pendulum_f64_matrices_t *matrices);

/* ------------------------------------------------------------ float */

/** The parameters of `Pendulum`. */
typedef struct {
    /** Mass of the bob. `m`, in kg: > 0. */
    float m;
    /** Length of the rod. `l`, in m: > 0. */
    float l;
    /** Damping of the joint. `c`, in N*m*s: >= 0. */
    float c;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    float g;
} pendulum_f32_t;

/** The parameter sets, such as `pendulum_f32_sets[PENDULUM_SET_SECONDS]`. */
extern const pendulum_f32_t pendulum_f32_sets[PENDULUM_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
pendulum_validity_t pendulum_f32_validate(const pendulum_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[PENDULUM_N][PENDULUM_N];
    /** Damping C0, a coefficient of q'. */
    float c0[PENDULUM_N][PENDULUM_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    float k0[PENDULUM_N][PENDULUM_N];
} pendulum_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 2 multiplications.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void pendulum_f32_matrices(const pendulum_f32_t *p, pendulum_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[PENDULUM_N][PENDULUM_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[PENDULUM_N][PENDULUM_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[PENDULUM_N][PENDULUM_N];
} pendulum_f32_system_t;

/**
 * The equations of motion.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t pendulum_f32_system(const pendulum_f32_matrices_t *matrices, float gravity,
    pendulum_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * PENDULUM_N][2U * PENDULUM_N];
    /** The input matrix B. */
    float b[2U * PENDULUM_N][PENDULUM_N];
} pendulum_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t pendulum_f32_state_space(const pendulum_f32_system_t *system,
    pendulum_f32_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `pendulum_partials`.
 */
typedef struct {
    float values[5];
} pendulum_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 1 addition and 3 multiplications: 4 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void pendulum_f32_derivatives(const pendulum_f32_t *p, pendulum_f32_matrices_t *matrices,
    pendulum_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void pendulum_f32_with_respect_to(const pendulum_f32_derivatives_t *derivatives, size_t parameter,
    pendulum_f32_matrices_t *matrices);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_PENDULUM_H */
