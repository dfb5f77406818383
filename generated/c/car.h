/* @generated from generated/models/car.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: bdb58fbb39c088e9
 */

/**
 * @file car.h
 * @brief The model `Car`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * The single-track car of the textbooks: two axles on tyres whose side force is proportional to slip, at a constant speed.
 *
 * Axes: origin at the centre of mass, x forward, y to the right, z down. Only the rates of its coordinates are states: the
 * lateral velocity along the axes of the car, and the yaw rate.
 *
 * Source: The single-track car of the textbooks, after Riekert & Schunck (1940), Zur Fahrmechanik des gummibereiften Kraftfahrzeugs, Ingenieur-Archiv 11, 210-224
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `y` (lateral) in m; only its rate is a state: Lateral motion, to the right.
 * - `psi` (yaw) in rad; only its rate is a state: Yaw, to the right.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_CAR_H
#define CARVALLO_MODEL_CAR_H

#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define CAR_N 2U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `oversteering`.
     *
     * Source: a public exercise: m = 1400, a = 1.14, b = 1.33, Cf = 25000, Cr = 21000, Iz = 2420
     */
    CAR_SET_OVERSTEERING = 0,
    /**
     * The parameter set `understeering`.
     *
     * Source: the same with its axles exchanged
     */
    CAR_SET_UNDERSTEERING = 1
} car_set_t;

/** How many parameter sets there are. */
#define CAR_SETS 2U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *car_set_name(car_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    CAR_VALID = 0,
    /** `m` in kg must be finite and > 0. */
    CAR_INVALID_m = 1,
    /** `I` in kg*m^2 must be finite and > 0. */
    CAR_INVALID_I_ = 2,
    /** `a` in m must be finite and > 0. */
    CAR_INVALID_a = 3,
    /** `b` in m must be finite and > 0. */
    CAR_INVALID_b = 4,
    /** `Cf` in N must be finite and > 0. */
    CAR_INVALID_Cf = 5,
    /** `Cr` in N must be finite and > 0. */
    CAR_INVALID_Cr = 6
} car_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *car_validity_text(car_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define CAR_PARTIALS 17U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t car_partials[CAR_PARTIALS];

/* ------------------------------------------------------------ double */

/** The parameters of `Car`. */
typedef struct {
    /** Mass. `m`, in kg: > 0. */
    double m;
    /** Moment of inertia about the vertical axis. `I`, in kg*m^2: > 0. */
    double I_;
    /** Distance of the front axle ahead of the centre of mass. `a`, in m: > 0. */
    double a;
    /** Distance of the rear axle behind the centre of mass. `b`, in m: > 0. */
    double b;
    /** Cornering stiffness of the front axle, of both wheels together. `Cf`, in N: > 0. */
    double Cf;
    /** Cornering stiffness of the rear axle, of both wheels together. `Cr`, in N: > 0. */
    double Cr;
} car_f64_t;

/** The parameter sets, such as `car_f64_sets[CAR_SET_OVERSTEERING]`. */
extern const car_f64_t car_f64_sets[CAR_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
car_validity_t car_f64_validate(const car_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[CAR_N][CAR_N];
    /** Damping C-1, a coefficient of q'/v. */
    double cm1[CAR_N][CAR_N];
    /** Damping C1, a coefficient of v q'. */
    double c1[CAR_N][CAR_N];
} car_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 3 additions and 4 multiplications: 7 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void car_f64_matrices(const car_f64_t *p, car_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[CAR_N][CAR_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[CAR_N][CAR_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[CAR_N][CAR_N];
} car_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s, not 0; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t car_f64_at_speed(const car_f64_matrices_t *matrices, double speed,
    car_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 *
 * Where only the position or only the rate of a coordinate is a state, the row and the column of the other one are zero.
 * They are no part of the motion: leave them out before you ask for eigenvalues.
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * CAR_N][2U * CAR_N];
    /** The input matrix B. */
    double b[2U * CAR_N][CAR_N];
} car_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t car_f64_state_space(const car_f64_system_t *system,
    car_f64_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `car_partials`.
 */
typedef struct {
    double values[9];
} car_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 5 additions and 6 multiplications: 11 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void car_f64_derivatives(const car_f64_t *p, car_f64_matrices_t *matrices,
    car_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void car_f64_with_respect_to(const car_f64_derivatives_t *derivatives, size_t parameter,
    car_f64_matrices_t *matrices);

/* ------------------------------------------------------------ float */

/** The parameters of `Car`. */
typedef struct {
    /** Mass. `m`, in kg: > 0. */
    float m;
    /** Moment of inertia about the vertical axis. `I`, in kg*m^2: > 0. */
    float I_;
    /** Distance of the front axle ahead of the centre of mass. `a`, in m: > 0. */
    float a;
    /** Distance of the rear axle behind the centre of mass. `b`, in m: > 0. */
    float b;
    /** Cornering stiffness of the front axle, of both wheels together. `Cf`, in N: > 0. */
    float Cf;
    /** Cornering stiffness of the rear axle, of both wheels together. `Cr`, in N: > 0. */
    float Cr;
} car_f32_t;

/** The parameter sets, such as `car_f32_sets[CAR_SET_OVERSTEERING]`. */
extern const car_f32_t car_f32_sets[CAR_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
car_validity_t car_f32_validate(const car_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[CAR_N][CAR_N];
    /** Damping C-1, a coefficient of q'/v. */
    float cm1[CAR_N][CAR_N];
    /** Damping C1, a coefficient of v q'. */
    float c1[CAR_N][CAR_N];
} car_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 3 additions and 4 multiplications: 7 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void car_f32_matrices(const car_f32_t *p, car_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[CAR_N][CAR_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[CAR_N][CAR_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[CAR_N][CAR_N];
} car_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s, not 0; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t car_f32_at_speed(const car_f32_matrices_t *matrices, float speed,
    car_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 *
 * Where only the position or only the rate of a coordinate is a state, the row and the column of the other one are zero.
 * They are no part of the motion: leave them out before you ask for eigenvalues.
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * CAR_N][2U * CAR_N];
    /** The input matrix B. */
    float b[2U * CAR_N][CAR_N];
} car_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t car_f32_state_space(const car_f32_system_t *system,
    car_f32_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `car_partials`.
 */
typedef struct {
    float values[9];
} car_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 5 additions and 6 multiplications: 11 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void car_f32_derivatives(const car_f32_t *p, car_f32_matrices_t *matrices,
    car_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void car_f32_with_respect_to(const car_f32_derivatives_t *derivatives, size_t parameter,
    car_f32_matrices_t *matrices);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_CAR_H */
