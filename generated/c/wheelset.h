/* @generated from generated/models/wheelset.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 37c3f8eae70bff1e
 */

/**
 * @file wheelset.h
 * @brief The model `Wheelset`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * A railway wheelset on its suspension, which hunts above a critical speed.
 *
 * Lateral displacement and yaw of a wheelset with conical wheels on straight track at the constant speed v, restrained
 * by springs to a vehicle that does not move. Forces of creep are linear; those of gravity and of spin are left out.
 * Axes: x forward, y to the right, z down. Forces of creep are divided by the speed, so there is no motion at rest to
 * speak of.
 *
 * Source: Force balance of a wheelset on springs with linear creep, as in books on railway vehicles such as Wickens (2003), Fundamentals of Rail Vehicle Dynamics
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `y` (lateral) in m: Lateral displacement, positive to the right.
 * - `psi` (yaw) in rad: Yaw, positive to the right.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_WHEELSET_H
#define CARVALLO_MODEL_WHEELSET_H

#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define WHEELSET_N 2U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `example`.
     *
     * Source: An example in round figures, of the size of a freight wagon's, of no vehicle that is
     */
    WHEELSET_SET_EXAMPLE = 0
} wheelset_set_t;

/** How many parameter sets there are. */
#define WHEELSET_SETS 1U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *wheelset_set_name(wheelset_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    WHEELSET_VALID = 0,
    /** `m` in kg must be finite and > 0. */
    WHEELSET_INVALID_m = 1,
    /** `I` in kg*m^2 must be finite and > 0. */
    WHEELSET_INVALID_I_ = 2,
    /** `f11` in N must be finite and > 0. */
    WHEELSET_INVALID_f11 = 3,
    /** `f22` in N must be finite and > 0. */
    WHEELSET_INVALID_f22 = 4,
    /** `b` in m must be finite and > 0. */
    WHEELSET_INVALID_b = 5,
    /** `lam` must be finite and > 0. */
    WHEELSET_INVALID_lam = 6,
    /** `r` in m must be finite and > 0. */
    WHEELSET_INVALID_r = 7,
    /** `ky` in N/m must be finite and >= 0. */
    WHEELSET_INVALID_ky = 8,
    /** `kpsi` in N*m/rad must be finite and >= 0. */
    WHEELSET_INVALID_kpsi = 9
} wheelset_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *wheelset_validity_text(wheelset_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define WHEELSET_PARTIALS 12U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t wheelset_partials[WHEELSET_PARTIALS];

/* ------------------------------------------------------------ double */

/** The parameters of `Wheelset`. */
typedef struct {
    /** Mass. `m`, in kg: > 0. */
    double m;
    /** Moment of inertia in yaw. `I`, in kg*m^2: > 0. */
    double I_;
    /** Longitudinal creep coefficient of a wheel. `f11`, in N: > 0. */
    double f11;
    /** Lateral creep coefficient of a wheel. `f22`, in N: > 0. */
    double f22;
    /** Half of the distance of the contact points. `b`, in m: > 0. */
    double b;
    /** Conicity of the wheels. `lam` λ, a pure number: > 0. */
    double lam;
    /** Radius of the wheels. `r`, in m: > 0. */
    double r;
    /** Lateral stiffness of the suspension. `ky`, in N/m: >= 0. */
    double ky;
    /** Stiffness of the suspension in yaw. `kpsi` kψ, in N*m/rad: >= 0. */
    double kpsi;
} wheelset_f64_t;

/** The parameter sets, such as `wheelset_f64_sets[WHEELSET_SET_EXAMPLE]`. */
extern const wheelset_f64_t wheelset_f64_sets[WHEELSET_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
wheelset_validity_t wheelset_f64_validate(const wheelset_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[WHEELSET_N][WHEELSET_N];
    /** Damping C-1, a coefficient of q'/v. */
    double cm1[WHEELSET_N][WHEELSET_N];
    /** Stiffness Kc, a coefficient of q. */
    double kc[WHEELSET_N][WHEELSET_N];
} wheelset_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 2 additions, 3 multiplications, 1 division and 1 negation: 7 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void wheelset_f64_matrices(const wheelset_f64_t *p, wheelset_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[WHEELSET_N][WHEELSET_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[WHEELSET_N][WHEELSET_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[WHEELSET_N][WHEELSET_N];
} wheelset_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s, not 0; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t wheelset_f64_at_speed(const wheelset_f64_matrices_t *matrices, double speed,
    wheelset_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * WHEELSET_N][2U * WHEELSET_N];
    /** The input matrix B. */
    double b[2U * WHEELSET_N][WHEELSET_N];
} wheelset_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t wheelset_f64_state_space(const wheelset_f64_system_t *system,
    wheelset_f64_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `wheelset_partials`.
 */
typedef struct {
    double values[9];
} wheelset_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 4 additions, 9 multiplications, 1 division and 1 negation: 15 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void wheelset_f64_derivatives(const wheelset_f64_t *p, wheelset_f64_matrices_t *matrices,
    wheelset_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void wheelset_f64_with_respect_to(const wheelset_f64_derivatives_t *derivatives, size_t parameter,
    wheelset_f64_matrices_t *matrices);

/* ------------------------------------------------------------ float */

/** The parameters of `Wheelset`. */
typedef struct {
    /** Mass. `m`, in kg: > 0. */
    float m;
    /** Moment of inertia in yaw. `I`, in kg*m^2: > 0. */
    float I_;
    /** Longitudinal creep coefficient of a wheel. `f11`, in N: > 0. */
    float f11;
    /** Lateral creep coefficient of a wheel. `f22`, in N: > 0. */
    float f22;
    /** Half of the distance of the contact points. `b`, in m: > 0. */
    float b;
    /** Conicity of the wheels. `lam` λ, a pure number: > 0. */
    float lam;
    /** Radius of the wheels. `r`, in m: > 0. */
    float r;
    /** Lateral stiffness of the suspension. `ky`, in N/m: >= 0. */
    float ky;
    /** Stiffness of the suspension in yaw. `kpsi` kψ, in N*m/rad: >= 0. */
    float kpsi;
} wheelset_f32_t;

/** The parameter sets, such as `wheelset_f32_sets[WHEELSET_SET_EXAMPLE]`. */
extern const wheelset_f32_t wheelset_f32_sets[WHEELSET_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
wheelset_validity_t wheelset_f32_validate(const wheelset_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[WHEELSET_N][WHEELSET_N];
    /** Damping C-1, a coefficient of q'/v. */
    float cm1[WHEELSET_N][WHEELSET_N];
    /** Stiffness Kc, a coefficient of q. */
    float kc[WHEELSET_N][WHEELSET_N];
} wheelset_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 2 additions, 3 multiplications, 1 division and 1 negation: 7 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void wheelset_f32_matrices(const wheelset_f32_t *p, wheelset_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[WHEELSET_N][WHEELSET_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[WHEELSET_N][WHEELSET_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[WHEELSET_N][WHEELSET_N];
} wheelset_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s, not 0; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t wheelset_f32_at_speed(const wheelset_f32_matrices_t *matrices, float speed,
    wheelset_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * WHEELSET_N][2U * WHEELSET_N];
    /** The input matrix B. */
    float b[2U * WHEELSET_N][WHEELSET_N];
} wheelset_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t wheelset_f32_state_space(const wheelset_f32_system_t *system,
    wheelset_f32_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `wheelset_partials`.
 */
typedef struct {
    float values[9];
} wheelset_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 4 additions, 9 multiplications, 1 division and 1 negation: 15 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void wheelset_f32_derivatives(const wheelset_f32_t *p, wheelset_f32_matrices_t *matrices,
    wheelset_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void wheelset_f32_with_respect_to(const wheelset_f32_derivatives_t *derivatives, size_t parameter,
    wheelset_f32_matrices_t *matrices);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_WHEELSET_H */
