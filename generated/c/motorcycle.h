/* @generated from generated/models/motorcycle.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 30344da47625ffae
 */

/**
 * @file motorcycle.h
 * @brief The model `Motorcycle`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * A motorcycle on tyres that slip, whose side forces follow slip and camber over a length: two bodies, of which the front
 * one steers, with wheels in their masses.
 *
 * Axes: origin on the ground below the centre of mass of the rear part, x forward, y to the right, z down. The steering takes
 * the load of the front wheel that is given with the parameters, `Zf`, and not the one that follows from the masses.
 *
 * Source: Sharp (1971), The stability and control of motorcycles, J. Mech. Eng. Sci. 13, 316-329
 *
 * Derived from a mechanism: body `rear` (rear part), body `front` (front part), wheel `R` (rear wheel), wheel `F` (front wheel).
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `y` (lateral) in m; only its rate is a state: Lateral motion of the origin, to the right; its rate is along the axes of the machine.
 * - `psi` (yaw) in rad; only its rate is a state: Yaw, to the right.
 * - `phi` (lean) in rad: Lean to the right.
 * - `delta` (steer) in rad: Steer angle of the front part, to the right.
 * - `er` (rear tyre) in m; of first order: only its position is a state: Deflection of the rear tyre.
 * - `ef` (front tyre) in m; of first order: only its position is a state: Deflection of the front tyre.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_MOTORCYCLE_H
#define CARVALLO_MODEL_MOTORCYCLE_H

#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define MOTORCYCLE_N 6U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `standard`.
     *
     * Source: Sharp (1971), case 1: in slug, ft and lb, made SI by 14.5939 kg and 0.3048 m
     */
    MOTORCYCLE_SET_STANDARD = 0
} motorcycle_set_t;

/** How many parameter sets there are. */
#define MOTORCYCLE_SETS 1U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *motorcycle_set_name(motorcycle_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    MOTORCYCLE_VALID = 0,
    /** `Mf` in kg must be finite and > 0. */
    MOTORCYCLE_INVALID_Mf = 1,
    /** `Mr` in kg must be finite and > 0. */
    MOTORCYCLE_INVALID_Mr = 2,
    /** `Irx` in kg*m^2 must be finite and >= 0. */
    MOTORCYCLE_INVALID_Irx = 3,
    /** `Irz` in kg*m^2 must be finite and >= 0. */
    MOTORCYCLE_INVALID_Irz = 4,
    /** `Crxz` in kg*m^2 must be finite. */
    MOTORCYCLE_INVALID_Crxz = 5,
    /** `Ifx` in kg*m^2 must be finite and >= 0. */
    MOTORCYCLE_INVALID_Ifx = 6,
    /** `Ifz` in kg*m^2 must be finite and >= 0. */
    MOTORCYCLE_INVALID_Ifz = 7,
    /** `ify` in kg*m^2 must be finite and >= 0. */
    MOTORCYCLE_INVALID_ify = 8,
    /** `iry` in kg*m^2 must be finite and >= 0. */
    MOTORCYCLE_INVALID_iry = 9,
    /** `a` in m must be finite and > 0. */
    MOTORCYCLE_INVALID_a = 10,
    /** `b` in m must be finite and > 0. */
    MOTORCYCLE_INVALID_b = 11,
    /** `e` in m must be finite. */
    MOTORCYCLE_INVALID_e = 12,
    /** `f` in m must be finite. */
    MOTORCYCLE_INVALID_f = 13,
    /** `h` in m must be finite and > 0. */
    MOTORCYCLE_INVALID_h = 14,
    /** `Rf` in m must be finite and > 0. */
    MOTORCYCLE_INVALID_Rf = 15,
    /** `Rr` in m must be finite and > 0. */
    MOTORCYCLE_INVALID_Rr = 16,
    /** `t` in m must be finite. */
    MOTORCYCLE_INVALID_t = 17,
    /** `eps` in rad must be finite and > -1.5707963267948966 and < 1.5707963267948966. */
    MOTORCYCLE_INVALID_eps = 18,
    /** `Cf1` in N must be finite and > 0. */
    MOTORCYCLE_INVALID_Cf1 = 19,
    /** `Cf2` in N must be finite and >= 0. */
    MOTORCYCLE_INVALID_Cf2 = 20,
    /** `Cr1` in N must be finite and > 0. */
    MOTORCYCLE_INVALID_Cr1 = 21,
    /** `Cr2` in N must be finite and >= 0. */
    MOTORCYCLE_INVALID_Cr2 = 22,
    /** `K` in N*m*s must be finite and >= 0. */
    MOTORCYCLE_INVALID_K = 23,
    /** `sigma` in m must be finite and > 0. */
    MOTORCYCLE_INVALID_sigma = 24,
    /** `Zf` in N must be finite and >= 0. */
    MOTORCYCLE_INVALID_Zf = 25,
    /** `g` in N/kg must be finite and > 0. */
    MOTORCYCLE_INVALID_g = 26,
    /** `b + l` in m must be finite and > 0. */
    MOTORCYCLE_REQUIREMENT_1 = 27
} motorcycle_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *motorcycle_validity_text(motorcycle_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define MOTORCYCLE_PARTIALS 197U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t motorcycle_partials[MOTORCYCLE_PARTIALS];

/* ------------------------------------------------------------ double */

/** The parameters of `Motorcycle`. */
typedef struct {
    /** Mass of the front part, with its wheel. `Mf`, in kg: > 0. */
    double Mf;
    /** Mass of the rear part, with its wheel and the rider. `Mr`, in kg: > 0. */
    double Mr;
    /**
     * Moment of inertia of the rear part about a longitudinal axis, at its centre of mass. `Irx`, in kg*m^2: >= 0.
     */
    double Irx;
    /** Moment of inertia of the rear part about a vertical axis. `Irz`, in kg*m^2: >= 0. */
    double Irz;
    /**
     * Product of inertia of the rear part: what the product of lean and yaw rates is multiplied by in the kinetic
     * energy, with the opposite sign. `Crxz`, in kg*m^2: any finite value.
     */
    double Crxz;
    /**
     * Moment of inertia of the front part about an axis perpendicular to the steer axis, forward. `Ifx`, in kg*m^2: >= 0.
     */
    double Ifx;
    /** Moment of inertia of the front part about an axis along the steer axis. `Ifz`, in kg*m^2: >= 0. */
    double Ifz;
    /** Moment of inertia of the front wheel about its axle. `ify`, in kg*m^2: >= 0. */
    double ify;
    /**
     * Moment of inertia of the rear wheel about its axle, with that of the engine as it is geared. `iry`, in kg*m^2: >= 0.
     */
    double iry;
    /** Distance of the origin from the steer axis. `a`, in m: > 0. */
    double a;
    /** Distance of the rear contact point behind the origin. `b`, in m: > 0. */
    double b;
    /** Distance of the centre of mass of the front part ahead of the steer axis. `e`, in m: any finite value. */
    double e;
    /**
     * Height of the centre of mass of the front part, along the steer axis, over the foot of the perpendicular from
     * the origin. `f`, in m: any finite value.
     */
    double f;
    /** Height of the centre of mass of the rear part. `h`, in m: > 0. */
    double h;
    /** Radius of the front wheel. `Rf`, in m: > 0. */
    double Rf;
    /** Radius of the rear wheel. `Rr`, in m: > 0. */
    double Rr;
    /** Distance of the front contact point behind the steer axis. `t`, in m: any finite value. */
    double t;
    /**
     * Tilt of the steer axis from the vertical. `eps` ε, in rad: > -1.5707963267948966 and < 1.5707963267948966.
     */
    double eps;
    /** Cornering stiffness of the front tyre. `Cf1`, in N: > 0. */
    double Cf1;
    /** Camber stiffness of the front tyre. `Cf2`, in N: >= 0. */
    double Cf2;
    /** Cornering stiffness of the rear tyre. `Cr1`, in N: > 0. */
    double Cr1;
    /** Camber stiffness of the rear tyre. `Cr2`, in N: >= 0. */
    double Cr2;
    /** Damping of the steering. `K`, in N*m*s: >= 0. */
    double K;
    /** Relaxation length of both tyres. `sigma` σ, in m: > 0. */
    double sigma;
    /** Load of the front wheel. `Zf`, in N: >= 0. */
    double Zf;
    /** Gravitational field strength. `g`, in N/kg: > 0. */
    double g;
} motorcycle_f64_t;

/** The parameter sets, such as `motorcycle_f64_sets[MOTORCYCLE_SET_STANDARD]`. */
extern const motorcycle_f64_t motorcycle_f64_sets[MOTORCYCLE_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
motorcycle_validity_t motorcycle_f64_validate(const motorcycle_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Damping C0, a coefficient of q'. */
    double c0[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Damping C1, a coefficient of v q'. */
    double c1[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Stiffness Kc, a coefficient of q. */
    double kc[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    double k0[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Stiffness K1, a coefficient of v q. */
    double k1[MOTORCYCLE_N][MOTORCYCLE_N];
} motorcycle_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 27 additions, 43 multiplications, 6 divisions, 10 negations and 2 trigonometric functions: 88 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void motorcycle_f64_matrices(const motorcycle_f64_t *p, motorcycle_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[MOTORCYCLE_N][MOTORCYCLE_N];
} motorcycle_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t motorcycle_f64_at_speed(const motorcycle_f64_matrices_t *matrices,
    double speed, double gravity, motorcycle_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 *
 * Where only the position or only the rate of a coordinate is a state, the row and the column of the other one are zero.
 * They are no part of the motion: leave them out before you ask for eigenvalues.
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * MOTORCYCLE_N][2U * MOTORCYCLE_N];
    /** The input matrix B. */
    double b[2U * MOTORCYCLE_N][MOTORCYCLE_N];
} motorcycle_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t motorcycle_f64_state_space(const motorcycle_f64_system_t *system,
    motorcycle_f64_state_space_t *space);

/**
 * The rate of something that rolls, to first order: in rad/s for what turns and m/s for what slides.
 *
 *     v speed + rates . q' + v (coordinates . q + heading psi)
 *
 * with the forward speed v in m/s, the coordinates q, and the yaw angle psi in rad, positive to the right, where that is no
 * coordinate.
 */
typedef struct {
    /** In steady straight motion, divided by v. */
    double speed;
    /** The part proportional to each q'. */
    double rates[MOTORCYCLE_N];
    /** The part proportional to v and each q. */
    double coordinates[MOTORCYCLE_N];
    /** The part proportional to v and the yaw. */
    double heading;
} motorcycle_f64_rate_t;

/**
 * A rate at a speed and a state.
 *
 * @param[in] rate The rate.
 * @param[in] v The forward speed in m/s.
 * @param[in] q The coordinates.
 * @param[in] q_dot Their rates.
 * @param[in] psi The yaw angle in rad, positive to the right, where that is no coordinate.
 * @return The rate, in rad/s or m/s.
 */
double motorcycle_f64_rate_at(const motorcycle_f64_rate_t *rate, double v,
    const double q[MOTORCYCLE_N], const double q_dot[MOTORCYCLE_N], double psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    motorcycle_f64_rate_t wheel_R;
    /** Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    motorcycle_f64_rate_t wheel_F;
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `Tdelta` (steer torque) in N*m.
     */
    double forces[MOTORCYCLE_N][1];
} motorcycle_f64_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 2 divisions and 2 negations: 4 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void motorcycle_f64_kinematics(const motorcycle_f64_t *p, motorcycle_f64_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `motorcycle_partials`.
 */
typedef struct {
    double values[85];
} motorcycle_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 46 additions, 106 multiplications, 7 divisions, 12 negations and 2 trigonometric functions: 173 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void motorcycle_f64_derivatives(const motorcycle_f64_t *p, motorcycle_f64_matrices_t *matrices,
    motorcycle_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void motorcycle_f64_with_respect_to(const motorcycle_f64_derivatives_t *derivatives,
    size_t parameter, motorcycle_f64_matrices_t *matrices);

/* ------------------------------------------------------------ float */

/** The parameters of `Motorcycle`. */
typedef struct {
    /** Mass of the front part, with its wheel. `Mf`, in kg: > 0. */
    float Mf;
    /** Mass of the rear part, with its wheel and the rider. `Mr`, in kg: > 0. */
    float Mr;
    /**
     * Moment of inertia of the rear part about a longitudinal axis, at its centre of mass. `Irx`, in kg*m^2: >= 0.
     */
    float Irx;
    /** Moment of inertia of the rear part about a vertical axis. `Irz`, in kg*m^2: >= 0. */
    float Irz;
    /**
     * Product of inertia of the rear part: what the product of lean and yaw rates is multiplied by in the kinetic
     * energy, with the opposite sign. `Crxz`, in kg*m^2: any finite value.
     */
    float Crxz;
    /**
     * Moment of inertia of the front part about an axis perpendicular to the steer axis, forward. `Ifx`, in kg*m^2: >= 0.
     */
    float Ifx;
    /** Moment of inertia of the front part about an axis along the steer axis. `Ifz`, in kg*m^2: >= 0. */
    float Ifz;
    /** Moment of inertia of the front wheel about its axle. `ify`, in kg*m^2: >= 0. */
    float ify;
    /**
     * Moment of inertia of the rear wheel about its axle, with that of the engine as it is geared. `iry`, in kg*m^2: >= 0.
     */
    float iry;
    /** Distance of the origin from the steer axis. `a`, in m: > 0. */
    float a;
    /** Distance of the rear contact point behind the origin. `b`, in m: > 0. */
    float b;
    /** Distance of the centre of mass of the front part ahead of the steer axis. `e`, in m: any finite value. */
    float e;
    /**
     * Height of the centre of mass of the front part, along the steer axis, over the foot of the perpendicular from
     * the origin. `f`, in m: any finite value.
     */
    float f;
    /** Height of the centre of mass of the rear part. `h`, in m: > 0. */
    float h;
    /** Radius of the front wheel. `Rf`, in m: > 0. */
    float Rf;
    /** Radius of the rear wheel. `Rr`, in m: > 0. */
    float Rr;
    /** Distance of the front contact point behind the steer axis. `t`, in m: any finite value. */
    float t;
    /**
     * Tilt of the steer axis from the vertical. `eps` ε, in rad: > -1.5707963267948966 and < 1.5707963267948966.
     */
    float eps;
    /** Cornering stiffness of the front tyre. `Cf1`, in N: > 0. */
    float Cf1;
    /** Camber stiffness of the front tyre. `Cf2`, in N: >= 0. */
    float Cf2;
    /** Cornering stiffness of the rear tyre. `Cr1`, in N: > 0. */
    float Cr1;
    /** Camber stiffness of the rear tyre. `Cr2`, in N: >= 0. */
    float Cr2;
    /** Damping of the steering. `K`, in N*m*s: >= 0. */
    float K;
    /** Relaxation length of both tyres. `sigma` σ, in m: > 0. */
    float sigma;
    /** Load of the front wheel. `Zf`, in N: >= 0. */
    float Zf;
    /** Gravitational field strength. `g`, in N/kg: > 0. */
    float g;
} motorcycle_f32_t;

/** The parameter sets, such as `motorcycle_f32_sets[MOTORCYCLE_SET_STANDARD]`. */
extern const motorcycle_f32_t motorcycle_f32_sets[MOTORCYCLE_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
motorcycle_validity_t motorcycle_f32_validate(const motorcycle_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Damping C0, a coefficient of q'. */
    float c0[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Damping C1, a coefficient of v q'. */
    float c1[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Stiffness Kc, a coefficient of q. */
    float kc[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    float k0[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Stiffness K1, a coefficient of v q. */
    float k1[MOTORCYCLE_N][MOTORCYCLE_N];
} motorcycle_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 27 additions, 43 multiplications, 6 divisions, 10 negations and 2 trigonometric functions: 88 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void motorcycle_f32_matrices(const motorcycle_f32_t *p, motorcycle_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[MOTORCYCLE_N][MOTORCYCLE_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[MOTORCYCLE_N][MOTORCYCLE_N];
} motorcycle_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t motorcycle_f32_at_speed(const motorcycle_f32_matrices_t *matrices,
    float speed, float gravity, motorcycle_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 *
 * Where only the position or only the rate of a coordinate is a state, the row and the column of the other one are zero.
 * They are no part of the motion: leave them out before you ask for eigenvalues.
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * MOTORCYCLE_N][2U * MOTORCYCLE_N];
    /** The input matrix B. */
    float b[2U * MOTORCYCLE_N][MOTORCYCLE_N];
} motorcycle_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t motorcycle_f32_state_space(const motorcycle_f32_system_t *system,
    motorcycle_f32_state_space_t *space);

/**
 * The rate of something that rolls, to first order: in rad/s for what turns and m/s for what slides.
 *
 *     v speed + rates . q' + v (coordinates . q + heading psi)
 *
 * with the forward speed v in m/s, the coordinates q, and the yaw angle psi in rad, positive to the right, where that is no
 * coordinate.
 */
typedef struct {
    /** In steady straight motion, divided by v. */
    float speed;
    /** The part proportional to each q'. */
    float rates[MOTORCYCLE_N];
    /** The part proportional to v and each q. */
    float coordinates[MOTORCYCLE_N];
    /** The part proportional to v and the yaw. */
    float heading;
} motorcycle_f32_rate_t;

/**
 * A rate at a speed and a state.
 *
 * @param[in] rate The rate.
 * @param[in] v The forward speed in m/s.
 * @param[in] q The coordinates.
 * @param[in] q_dot Their rates.
 * @param[in] psi The yaw angle in rad, positive to the right, where that is no coordinate.
 * @return The rate, in rad/s or m/s.
 */
float motorcycle_f32_rate_at(const motorcycle_f32_rate_t *rate, float v,
    const float q[MOTORCYCLE_N], const float q_dot[MOTORCYCLE_N], float psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    motorcycle_f32_rate_t wheel_R;
    /** Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    motorcycle_f32_rate_t wheel_F;
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `Tdelta` (steer torque) in N*m.
     */
    float forces[MOTORCYCLE_N][1];
} motorcycle_f32_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 2 divisions and 2 negations: 4 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void motorcycle_f32_kinematics(const motorcycle_f32_t *p, motorcycle_f32_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `motorcycle_partials`.
 */
typedef struct {
    float values[85];
} motorcycle_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 46 additions, 106 multiplications, 7 divisions, 12 negations and 2 trigonometric functions: 173 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void motorcycle_f32_derivatives(const motorcycle_f32_t *p, motorcycle_f32_matrices_t *matrices,
    motorcycle_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void motorcycle_f32_with_respect_to(const motorcycle_f32_derivatives_t *derivatives,
    size_t parameter, motorcycle_f32_matrices_t *matrices);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_MOTORCYCLE_H */
