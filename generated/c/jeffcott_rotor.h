/* @generated from generated/models/jeffcott_rotor.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: d9449eedbd9a5f5e
 */

/**
 * @file jeffcott_rotor.h
 * @brief The model `JeffcottRotor`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * A disc in the middle of an elastic shaft whose own damping turns with it: a Jeffcott rotor.
 *
 * Two coordinates, the displacements of the disc in axes that do not turn; the shaft turns from the first to the second.
 * Damping of the surroundings always calms it, that of the shaft and of its fits drives the forward whirl above the
 * spin rate sqrt(k/m) (1 + ce/ci), whatever the balance of the disc. The speed v is the circumferential speed at the
 * radius R, so that the spin rate is v/R.
 *
 * Source: Force balance of the Jeffcott rotor with rotating and non-rotating damping, as in textbooks of rotor dynamics
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `y` in m: Displacement of the disc.
 * - `z` in m: Displacement of the disc across, to where the shaft turns from y.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_JEFFCOTT_ROTOR_H
#define CARVALLO_MODEL_JEFFCOTT_ROTOR_H

#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define JEFFCOTT_ROTOR_N 2U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `example`.
     *
     * Source: An example in round figures, with the threshold at 250 rad/s, which is 7.5 m/s at the surface of the shaft
     */
    JEFFCOTT_ROTOR_SET_EXAMPLE = 0
} jeffcott_rotor_set_t;

/** How many parameter sets there are. */
#define JEFFCOTT_ROTOR_SETS 1U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *jeffcott_rotor_set_name(jeffcott_rotor_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    JEFFCOTT_ROTOR_VALID = 0,
    /** `m` in kg must be finite and > 0. */
    JEFFCOTT_ROTOR_INVALID_m = 1,
    /** `k` in N/m must be finite and > 0. */
    JEFFCOTT_ROTOR_INVALID_k = 2,
    /** `ce` in N*s/m must be finite and >= 0. */
    JEFFCOTT_ROTOR_INVALID_ce = 3,
    /** `ci` in N*s/m must be finite and >= 0. */
    JEFFCOTT_ROTOR_INVALID_ci = 4,
    /** `R` in m must be finite and > 0. */
    JEFFCOTT_ROTOR_INVALID_R = 5
} jeffcott_rotor_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *jeffcott_rotor_validity_text(jeffcott_rotor_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define JEFFCOTT_ROTOR_PARTIALS 12U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t jeffcott_rotor_partials[JEFFCOTT_ROTOR_PARTIALS];

/* ------------------------------------------------------------ double */

/** The parameters of `JeffcottRotor`. */
typedef struct {
    /** Mass of the disc. `m`, in kg: > 0. */
    double m;
    /** Stiffness of the shaft at the disc. `k`, in N/m: > 0. */
    double k;
    /** Damping of the surroundings, external or non-rotating. `ce`, in N*s/m: >= 0. */
    double ce;
    /** Damping of the shaft, internal or rotating. `ci`, in N*s/m: >= 0. */
    double ci;
    /** Radius at which the speed is that of the circumference. `R`, in m: > 0. */
    double R;
} jeffcott_rotor_f64_t;

/** The parameter sets, such as `jeffcott_rotor_f64_sets[JEFFCOTT_ROTOR_SET_EXAMPLE]`. */
extern const jeffcott_rotor_f64_t jeffcott_rotor_f64_sets[JEFFCOTT_ROTOR_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
jeffcott_rotor_validity_t jeffcott_rotor_f64_validate(const jeffcott_rotor_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
    /** Damping C0, a coefficient of q'. Symmetric, proved. */
    double c0[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
    /** Stiffness Kc, a coefficient of q. Symmetric, proved. */
    double kc[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
    /** Stiffness K1, a coefficient of v q. */
    double k1[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
} jeffcott_rotor_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 1 addition, 1 division and 1 negation: 3 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void jeffcott_rotor_f64_matrices(const jeffcott_rotor_f64_t *p, jeffcott_rotor_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
} jeffcott_rotor_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t jeffcott_rotor_f64_at_speed(const jeffcott_rotor_f64_matrices_t *matrices,
    double speed, jeffcott_rotor_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * JEFFCOTT_ROTOR_N][2U * JEFFCOTT_ROTOR_N];
    /** The input matrix B. */
    double b[2U * JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
} jeffcott_rotor_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t jeffcott_rotor_f64_state_space(const jeffcott_rotor_f64_system_t *system,
    jeffcott_rotor_f64_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `jeffcott_rotor_partials`.
 */
typedef struct {
    double values[3];
} jeffcott_rotor_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 1 addition, 2 multiplications, 1 division and 1 negation: 5 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void jeffcott_rotor_f64_derivatives(const jeffcott_rotor_f64_t *p,
    jeffcott_rotor_f64_matrices_t *matrices, jeffcott_rotor_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void jeffcott_rotor_f64_with_respect_to(const jeffcott_rotor_f64_derivatives_t *derivatives,
    size_t parameter, jeffcott_rotor_f64_matrices_t *matrices);

/* ------------------------------------------------------------ float */

/** The parameters of `JeffcottRotor`. */
typedef struct {
    /** Mass of the disc. `m`, in kg: > 0. */
    float m;
    /** Stiffness of the shaft at the disc. `k`, in N/m: > 0. */
    float k;
    /** Damping of the surroundings, external or non-rotating. `ce`, in N*s/m: >= 0. */
    float ce;
    /** Damping of the shaft, internal or rotating. `ci`, in N*s/m: >= 0. */
    float ci;
    /** Radius at which the speed is that of the circumference. `R`, in m: > 0. */
    float R;
} jeffcott_rotor_f32_t;

/** The parameter sets, such as `jeffcott_rotor_f32_sets[JEFFCOTT_ROTOR_SET_EXAMPLE]`. */
extern const jeffcott_rotor_f32_t jeffcott_rotor_f32_sets[JEFFCOTT_ROTOR_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
jeffcott_rotor_validity_t jeffcott_rotor_f32_validate(const jeffcott_rotor_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
    /** Damping C0, a coefficient of q'. Symmetric, proved. */
    float c0[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
    /** Stiffness Kc, a coefficient of q. Symmetric, proved. */
    float kc[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
    /** Stiffness K1, a coefficient of v q. */
    float k1[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
} jeffcott_rotor_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 1 addition, 1 division and 1 negation: 3 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void jeffcott_rotor_f32_matrices(const jeffcott_rotor_f32_t *p, jeffcott_rotor_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
} jeffcott_rotor_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t jeffcott_rotor_f32_at_speed(const jeffcott_rotor_f32_matrices_t *matrices,
    float speed, jeffcott_rotor_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * JEFFCOTT_ROTOR_N][2U * JEFFCOTT_ROTOR_N];
    /** The input matrix B. */
    float b[2U * JEFFCOTT_ROTOR_N][JEFFCOTT_ROTOR_N];
} jeffcott_rotor_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t jeffcott_rotor_f32_state_space(const jeffcott_rotor_f32_system_t *system,
    jeffcott_rotor_f32_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `jeffcott_rotor_partials`.
 */
typedef struct {
    float values[3];
} jeffcott_rotor_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 1 addition, 2 multiplications, 1 division and 1 negation: 5 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void jeffcott_rotor_f32_derivatives(const jeffcott_rotor_f32_t *p,
    jeffcott_rotor_f32_matrices_t *matrices, jeffcott_rotor_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void jeffcott_rotor_f32_with_respect_to(const jeffcott_rotor_f32_derivatives_t *derivatives,
    size_t parameter, jeffcott_rotor_f32_matrices_t *matrices);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_JEFFCOTT_ROTOR_H */
