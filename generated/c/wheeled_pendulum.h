/* @generated from generated/models/wheeled_pendulum.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: b992785cfa4d8bcd
 */

/**
 * @file wheeled_pendulum.h
 * @brief The model `WheeledPendulum`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * A pendulum upside down on two wheels, as balancing robots and the Segway are: it stands only where a motor balances it.
 *
 * Two wheels on one axle that roll without slip, and a body above it. The motors act between body and wheels; forward
 * motion, pitch and yaw take part. A positive torque, about y, drives a wheel backward and pitches the body forward.
 * In the matrices `x` is of a point of the body, as declared; in the nonlinear equations `x` and `y` are of where the left wheel
 * touches the ground, to first order `x - r*theta + b*psi` of that `x`.
 * Axes: origin on the ground below the axle, x forward, y to the right, z down.
 *
 * Source: Mechanism: Grasser, D'Arrigo, Colombi & Rufer (2002), JOE: a mobile, inverted pendulum, IEEE Trans. Ind. Electron. 49, 107-114
 *
 * Derived from a mechanism: body `B` (body), wheel `L` (left wheel), wheel `R` (right wheel).
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `x` (forward) in m; only its rate is a state: Forward motion, beside that at the speed v, of the point of the body that is on the ground when it is upright.
 * - `theta` (pitch) in rad: Pitch of the body, positive backward.
 * - `psi` (yaw) in rad; only its rate is a state: Yaw, positive to the right.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_WHEELED_PENDULUM_H
#define CARVALLO_MODEL_WHEELED_PENDULUM_H

#include "carvallo_motion.h"
#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define WHEELED_PENDULUM_N 3U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `robot`.
     *
     * Source: A robot of the size of a boot, by estimate
     */
    WHEELED_PENDULUM_SET_ROBOT = 0,
    /**
     * The parameter set `transporter`.
     *
     * Source: A transporter with a rider who stands still, by estimate
     */
    WHEELED_PENDULUM_SET_TRANSPORTER = 1
} wheeled_pendulum_set_t;

/** How many parameter sets there are. */
#define WHEELED_PENDULUM_SETS 2U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *wheeled_pendulum_set_name(wheeled_pendulum_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    WHEELED_PENDULUM_VALID = 0,
    /** `m` in kg must be finite and > 0. */
    WHEELED_PENDULUM_INVALID_m = 1,
    /** `l` in m must be finite and > 0. */
    WHEELED_PENDULUM_INVALID_l = 2,
    /** `Iyy` in kg*m^2 must be finite and >= 0. */
    WHEELED_PENDULUM_INVALID_Iyy = 3,
    /** `Izz` in kg*m^2 must be finite and >= 0. */
    WHEELED_PENDULUM_INVALID_Izz = 4,
    /** `mW` in kg must be finite and >= 0. */
    WHEELED_PENDULUM_INVALID_mW = 5,
    /** `Ia` in kg*m^2 must be finite and >= 0. */
    WHEELED_PENDULUM_INVALID_Ia = 6,
    /** `Ir` in kg*m^2 must be finite and >= 0. */
    WHEELED_PENDULUM_INVALID_Ir = 7,
    /** `r` in m must be finite and > 0. */
    WHEELED_PENDULUM_INVALID_r = 8,
    /** `b` in m must be finite and > 0. */
    WHEELED_PENDULUM_INVALID_b = 9,
    /** `g` in N/kg must be finite and >= 0. */
    WHEELED_PENDULUM_INVALID_g = 10
} wheeled_pendulum_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *wheeled_pendulum_validity_text(wheeled_pendulum_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define WHEELED_PENDULUM_PARTIALS 28U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t wheeled_pendulum_partials[WHEELED_PENDULUM_PARTIALS];

/** The place of a position among the positions, of which each joint has one. */
typedef enum {
    /** forward, in m */
    WHEELED_PENDULUM_POSITION_x = 0,
    /** y of the contact point of the left wheel, in m */
    WHEELED_PENDULUM_POSITION_y = 1,
    /** yaw, in rad */
    WHEELED_PENDULUM_POSITION_psi = 2,
    /** lean, by the heights of the wheels, in rad */
    WHEELED_PENDULUM_POSITION_phi = 3,
    /** pitch, in rad */
    WHEELED_PENDULUM_POSITION_theta = 4,
    /** angle of the left wheel, in rad */
    WHEELED_PENDULUM_POSITION_thetaL = 5,
    /** angle of the right wheel, in rad */
    WHEELED_PENDULUM_POSITION_thetaR = 6
} wheeled_pendulum_position_t;

/** How many positions there are. */
#define WHEELED_PENDULUM_POSITIONS 7U

/** The name of a position; a text of its own for what is none. */
const char *wheeled_pendulum_position_name(wheeled_pendulum_position_t which);

/** The place of a speed among the speeds, the rates that rolling leaves free. */
typedef enum {
    /** The rate of `psi`, in rad/s */
    WHEELED_PENDULUM_SPEED_psi = 0,
    /** The rate of `theta`, in rad/s */
    WHEELED_PENDULUM_SPEED_theta = 1,
    /** The rate of `thetaL`, in rad/s */
    WHEELED_PENDULUM_SPEED_thetaL = 2
} wheeled_pendulum_speed_t;

/** How many speeds there are. */
#define WHEELED_PENDULUM_SPEEDS 3U

/** The name of a speed; a text of its own for what is none. */
const char *wheeled_pendulum_speed_name(wheeled_pendulum_speed_t which);

/** The place of a force or torque among those that may be applied. */
typedef enum {
    /** torque of the left motor, in N*m */
    WHEELED_PENDULUM_FORCE_TL = 0,
    /** torque of the right motor, in N*m */
    WHEELED_PENDULUM_FORCE_TR = 1
} wheeled_pendulum_force_t;

/** How many forces there are. */
#define WHEELED_PENDULUM_FORCES 2U

/** The name of a force; a text of its own for what is none. */
const char *wheeled_pendulum_force_name(wheeled_pendulum_force_t which);

/** The place of a wheel among the contact forces. */
typedef enum {
    /** left wheel */
    WHEELED_PENDULUM_WHEEL_L = 0,
    /** right wheel */
    WHEELED_PENDULUM_WHEEL_R = 1
} wheeled_pendulum_wheel_t;

/** How many wheels there are. */
#define WHEELED_PENDULUM_WHEELS 2U

/** The name of a wheel; a text of its own for what is none. */
const char *wheeled_pendulum_wheel_name(wheeled_pendulum_wheel_t which);

/** How many states there are: all positions, and behind them the speeds. */
#define WHEELED_PENDULUM_STATES (WHEELED_PENDULUM_POSITIONS + WHEELED_PENDULUM_SPEEDS)

/** How many parameters there are. */
#define WHEELED_PENDULUM_PARAMETERS 10U

/* ------------------------------------------------------------ double */

/** The parameters of `WheeledPendulum`. */
typedef struct {
    /** Mass of the body. `m`, in kg: > 0. */
    double m;
    /** Centre of mass of the body, above the axle. `l`, in m: > 0. */
    double l;
    /** Moment of inertia of the body about its centre of mass, in pitch. `Iyy`, in kg*m^2: >= 0. */
    double Iyy;
    /** Moment of inertia of the body about its centre of mass, in yaw. `Izz`, in kg*m^2: >= 0. */
    double Izz;
    /** Mass of each wheel. `mW`, in kg: >= 0. */
    double mW;
    /** Axial moment of inertia of each wheel. `Ia`, in kg*m^2: >= 0. */
    double Ia;
    /** Radial moment of inertia of each wheel, about a diameter. `Ir`, in kg*m^2: >= 0. */
    double Ir;
    /** Radius of the wheels. `r`, in m: > 0. */
    double r;
    /** Half of the track, from the middle of the axle to a wheel. `b`, in m: > 0. */
    double b;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    double g;
} wheeled_pendulum_f64_t;

/** The parameter sets, such as `wheeled_pendulum_f64_sets[WHEELED_PENDULUM_SET_ROBOT]`. */
extern const wheeled_pendulum_f64_t wheeled_pendulum_f64_sets[WHEELED_PENDULUM_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
wheeled_pendulum_validity_t wheeled_pendulum_f64_validate(const wheeled_pendulum_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[WHEELED_PENDULUM_N][WHEELED_PENDULUM_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    double k0[WHEELED_PENDULUM_N][WHEELED_PENDULUM_N];
} wheeled_pendulum_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 13 additions, 9 multiplications, 1 division and 2 negations: 25 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void wheeled_pendulum_f64_matrices(const wheeled_pendulum_f64_t *p, wheeled_pendulum_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[WHEELED_PENDULUM_N][WHEELED_PENDULUM_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[WHEELED_PENDULUM_N][WHEELED_PENDULUM_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[WHEELED_PENDULUM_N][WHEELED_PENDULUM_N];
} wheeled_pendulum_f64_system_t;

/**
 * The equations of motion.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t wheeled_pendulum_f64_system(const wheeled_pendulum_f64_matrices_t *matrices,
    double gravity, wheeled_pendulum_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 *
 * Where only the position or only the rate of a coordinate is a state, the row and the column of the other one are zero.
 * They are no part of the motion: leave them out before you ask for eigenvalues.
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * WHEELED_PENDULUM_N][2U * WHEELED_PENDULUM_N];
    /** The input matrix B. */
    double b[2U * WHEELED_PENDULUM_N][WHEELED_PENDULUM_N];
} wheeled_pendulum_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t wheeled_pendulum_f64_state_space(const wheeled_pendulum_f64_system_t *system,
    wheeled_pendulum_f64_state_space_t *space);

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
    double rates[WHEELED_PENDULUM_N];
    /** The part proportional to v and each q. */
    double coordinates[WHEELED_PENDULUM_N];
    /** The part proportional to v and the yaw. */
    double heading;
} wheeled_pendulum_f64_rate_t;

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
double wheeled_pendulum_f64_rate_at(const wheeled_pendulum_f64_rate_t *rate, double v,
    const double q[WHEELED_PENDULUM_N], const double q_dot[WHEELED_PENDULUM_N], double psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin. */
    wheeled_pendulum_f64_rate_t lateral;
    /** Rate, in `rad/s`: of `B`. */
    wheeled_pendulum_f64_rate_t lean;
    /** Spin of the wheel `L`, left wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    wheeled_pendulum_f64_rate_t wheel_L;
    /** Spin of the wheel `R`, right wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    wheeled_pendulum_f64_rate_t wheel_R;
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `TL` (torque of the left motor) in N*m, `TR` (torque of the right motor) in N*m.
     */
    double forces[WHEELED_PENDULUM_N][2];
} wheeled_pendulum_f64_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 multiplication, 1 division and 2 negations: 4 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void wheeled_pendulum_f64_kinematics(const wheeled_pendulum_f64_t *p, wheeled_pendulum_f64_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `wheeled_pendulum_partials`.
 */
typedef struct {
    double values[18];
} wheeled_pendulum_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 21 additions, 16 multiplications, 1 division and 2 negations: 40 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void wheeled_pendulum_f64_derivatives(const wheeled_pendulum_f64_t *p,
    wheeled_pendulum_f64_matrices_t *matrices, wheeled_pendulum_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void wheeled_pendulum_f64_with_respect_to(const wheeled_pendulum_f64_derivatives_t *derivatives,
    size_t parameter, wheeled_pendulum_f64_matrices_t *matrices);

/**
 * The nonlinear equations of motion with their parameters: what does not depend on the state, computed once.
 *
 * Everything is in SI units. Positions, their rates and accelerations are arrays in the order of the constants of positions,
 * speeds and their rates in that of the speeds. Positions have to be such that every wheel touches the ground; how far they
 * are from that, so far are the results. On an error what is computed is not to be used.
 */
typedef struct {
    /** In an order of their own. */
    double constants[20U];
} wheeled_pendulum_f64_motion_t;

/**
 * What does not depend on the state, from one straight-line program:
 * 15 additions and 10 multiplications: 25 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] motion The equations.
 */
void wheeled_pendulum_f64_motion(const wheeled_pendulum_f64_t *p,
    wheeled_pendulum_f64_motion_t *motion);

/**
 * The rates of all positions at given speeds, of which rolling determines the others:
 * 5 additions, 8 multiplications, 1 division, 2 negations and 4 trigonometric functions: 20 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] rates The rates of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f64_motion_rates(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], double rates[WHEELED_PENDULUM_POSITIONS]);

/**
 * The rates of all positions and of the speeds, which is what an integration takes:
 * 93 additions, 128 multiplications, 5 divisions, 2 negations and 6 trigonometric functions: 234 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] rates The rates of the positions.
 * @param[out] speed_rates The rates of the speeds.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f64_motion_derivatives(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    double rates[WHEELED_PENDULUM_POSITIONS], double speed_rates[WHEELED_PENDULUM_SPEEDS]);

/**
 * The second derivatives of all positions:
 * 99 additions, 134 multiplications, 5 divisions, 2 negations and 6 trigonometric functions: 246 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] accelerations The accelerations of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f64_motion_accelerations(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    double accelerations[WHEELED_PENDULUM_POSITIONS]);

/**
 * The kinetic energy, and the potential energy of gravity and springs, in J:
 * 33 additions, 40 multiplications, 1 division, 1 negation and 4 trigonometric functions: 79 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] energy The kinetic energy, then the potential energy, which is zero where the centre of mass is at the
 *             height of the ground.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f64_motion_energy(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], double energy[2]);

/**
 * Moves the positions that depend on the others until every wheel touches the ground, by Newton's method with bounded
 * steps. The search begins at what is given for them, so that it finds the solution that continues a motion.
 *
 * @param[in] motion The equations.
 * @param[in,out] positions The positions; unchanged on an error.
 * @return Whether no such positions are near, the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f64_motion_close(const wheeled_pendulum_f64_motion_t *motion,
    double positions[WHEELED_PENDULUM_POSITIONS]);

/**
 * For each wheel the force of the ground on it in N, along the axes of the ground: x forward at the start, y to the right and
 * z down, so that the last component of a wheel that stands on the ground is negative. Of wheels that share an axle the
 * sideways force of the first is that of all. From one straight-line program:
 * 126 additions, 169 multiplications, 5 divisions and 6 trigonometric functions: 306 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] contact_forces The forces, three numbers for each wheel, one wheel after the other.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f64_motion_contact_forces(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    double contact_forces[3U * WHEELED_PENDULUM_WHEELS]);

/**
 * The nonlinear equations of motion to first order about a state, x' = x0' + A (x - x0) + B (f - f0), where x are all
 * positions and then all speeds.
 *
 * Derivatives are exact, and those along motions that the conditions leave: positions that the heights of the wheels determine
 * follow the others, so a column for such a position is zero.
 */
typedef struct {
    /** The derivatives of the rates of positions and speeds, a row for each, with respect to these, a column for each. */
    double a[WHEELED_PENDULUM_STATES][WHEELED_PENDULUM_STATES];
    /** The derivatives with respect to the forces, a column for each. */
    double b[WHEELED_PENDULUM_STATES][WHEELED_PENDULUM_FORCES];
} wheeled_pendulum_f64_linearization_t;

/**
 * A and B about a state, which need not be one of equilibrium:
 * 278 additions, 382 multiplications, 5 divisions, 4 negations and 6 trigonometric functions: 675 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] linearization The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f64_motion_linearize(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    wheeled_pendulum_f64_linearization_t *linearization);

/**
 * The derivatives of the rates of all positions and then of the speeds, a row for each, with respect to the parameters in
 * declared order, a column for each. Free positions, speeds and forces stay what they are, and dependent positions follow:
 * 394 additions, 568 multiplications, 5 divisions, 11 negations and 6 trigonometric functions: 984 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] by_parameters The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f64_motion_by_parameters(const wheeled_pendulum_f64_motion_t *motion,
    const double positions[WHEELED_PENDULUM_POSITIONS],
    const double speeds[WHEELED_PENDULUM_SPEEDS], const double forces[WHEELED_PENDULUM_FORCES],
    double by_parameters[WHEELED_PENDULUM_STATES][WHEELED_PENDULUM_PARAMETERS]);

/* ------------------------------------------------------------ float */

/** The parameters of `WheeledPendulum`. */
typedef struct {
    /** Mass of the body. `m`, in kg: > 0. */
    float m;
    /** Centre of mass of the body, above the axle. `l`, in m: > 0. */
    float l;
    /** Moment of inertia of the body about its centre of mass, in pitch. `Iyy`, in kg*m^2: >= 0. */
    float Iyy;
    /** Moment of inertia of the body about its centre of mass, in yaw. `Izz`, in kg*m^2: >= 0. */
    float Izz;
    /** Mass of each wheel. `mW`, in kg: >= 0. */
    float mW;
    /** Axial moment of inertia of each wheel. `Ia`, in kg*m^2: >= 0. */
    float Ia;
    /** Radial moment of inertia of each wheel, about a diameter. `Ir`, in kg*m^2: >= 0. */
    float Ir;
    /** Radius of the wheels. `r`, in m: > 0. */
    float r;
    /** Half of the track, from the middle of the axle to a wheel. `b`, in m: > 0. */
    float b;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    float g;
} wheeled_pendulum_f32_t;

/** The parameter sets, such as `wheeled_pendulum_f32_sets[WHEELED_PENDULUM_SET_ROBOT]`. */
extern const wheeled_pendulum_f32_t wheeled_pendulum_f32_sets[WHEELED_PENDULUM_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
wheeled_pendulum_validity_t wheeled_pendulum_f32_validate(const wheeled_pendulum_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[WHEELED_PENDULUM_N][WHEELED_PENDULUM_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    float k0[WHEELED_PENDULUM_N][WHEELED_PENDULUM_N];
} wheeled_pendulum_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 13 additions, 9 multiplications, 1 division and 2 negations: 25 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void wheeled_pendulum_f32_matrices(const wheeled_pendulum_f32_t *p, wheeled_pendulum_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[WHEELED_PENDULUM_N][WHEELED_PENDULUM_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[WHEELED_PENDULUM_N][WHEELED_PENDULUM_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[WHEELED_PENDULUM_N][WHEELED_PENDULUM_N];
} wheeled_pendulum_f32_system_t;

/**
 * The equations of motion.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t wheeled_pendulum_f32_system(const wheeled_pendulum_f32_matrices_t *matrices,
    float gravity, wheeled_pendulum_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 *
 * Where only the position or only the rate of a coordinate is a state, the row and the column of the other one are zero.
 * They are no part of the motion: leave them out before you ask for eigenvalues.
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * WHEELED_PENDULUM_N][2U * WHEELED_PENDULUM_N];
    /** The input matrix B. */
    float b[2U * WHEELED_PENDULUM_N][WHEELED_PENDULUM_N];
} wheeled_pendulum_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t wheeled_pendulum_f32_state_space(const wheeled_pendulum_f32_system_t *system,
    wheeled_pendulum_f32_state_space_t *space);

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
    float rates[WHEELED_PENDULUM_N];
    /** The part proportional to v and each q. */
    float coordinates[WHEELED_PENDULUM_N];
    /** The part proportional to v and the yaw. */
    float heading;
} wheeled_pendulum_f32_rate_t;

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
float wheeled_pendulum_f32_rate_at(const wheeled_pendulum_f32_rate_t *rate, float v,
    const float q[WHEELED_PENDULUM_N], const float q_dot[WHEELED_PENDULUM_N], float psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin. */
    wheeled_pendulum_f32_rate_t lateral;
    /** Rate, in `rad/s`: of `B`. */
    wheeled_pendulum_f32_rate_t lean;
    /** Spin of the wheel `L`, left wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    wheeled_pendulum_f32_rate_t wheel_L;
    /** Spin of the wheel `R`, right wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    wheeled_pendulum_f32_rate_t wheel_R;
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `TL` (torque of the left motor) in N*m, `TR` (torque of the right motor) in N*m.
     */
    float forces[WHEELED_PENDULUM_N][2];
} wheeled_pendulum_f32_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 multiplication, 1 division and 2 negations: 4 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void wheeled_pendulum_f32_kinematics(const wheeled_pendulum_f32_t *p, wheeled_pendulum_f32_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `wheeled_pendulum_partials`.
 */
typedef struct {
    float values[18];
} wheeled_pendulum_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 21 additions, 16 multiplications, 1 division and 2 negations: 40 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void wheeled_pendulum_f32_derivatives(const wheeled_pendulum_f32_t *p,
    wheeled_pendulum_f32_matrices_t *matrices, wheeled_pendulum_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void wheeled_pendulum_f32_with_respect_to(const wheeled_pendulum_f32_derivatives_t *derivatives,
    size_t parameter, wheeled_pendulum_f32_matrices_t *matrices);

/**
 * The nonlinear equations of motion with their parameters: what does not depend on the state, computed once.
 *
 * Everything is in SI units. Positions, their rates and accelerations are arrays in the order of the constants of positions,
 * speeds and their rates in that of the speeds. Positions have to be such that every wheel touches the ground; how far they
 * are from that, so far are the results. On an error what is computed is not to be used.
 */
typedef struct {
    /** In an order of their own. */
    float constants[20U];
} wheeled_pendulum_f32_motion_t;

/**
 * What does not depend on the state, from one straight-line program:
 * 15 additions and 10 multiplications: 25 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] motion The equations.
 */
void wheeled_pendulum_f32_motion(const wheeled_pendulum_f32_t *p,
    wheeled_pendulum_f32_motion_t *motion);

/**
 * The rates of all positions at given speeds, of which rolling determines the others:
 * 5 additions, 8 multiplications, 1 division, 2 negations and 4 trigonometric functions: 20 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] rates The rates of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f32_motion_rates(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    float rates[WHEELED_PENDULUM_POSITIONS]);

/**
 * The rates of all positions and of the speeds, which is what an integration takes:
 * 93 additions, 128 multiplications, 5 divisions, 2 negations and 6 trigonometric functions: 234 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] rates The rates of the positions.
 * @param[out] speed_rates The rates of the speeds.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f32_motion_derivatives(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES], float rates[WHEELED_PENDULUM_POSITIONS],
    float speed_rates[WHEELED_PENDULUM_SPEEDS]);

/**
 * The second derivatives of all positions:
 * 99 additions, 134 multiplications, 5 divisions, 2 negations and 6 trigonometric functions: 246 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] accelerations The accelerations of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f32_motion_accelerations(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES], float accelerations[WHEELED_PENDULUM_POSITIONS]);

/**
 * The kinetic energy, and the potential energy of gravity and springs, in J:
 * 33 additions, 40 multiplications, 1 division, 1 negation and 4 trigonometric functions: 79 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] energy The kinetic energy, then the potential energy, which is zero where the centre of mass is at the
 *             height of the ground.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f32_motion_energy(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    float energy[2]);

/**
 * Moves the positions that depend on the others until every wheel touches the ground, by Newton's method with bounded
 * steps. The search begins at what is given for them, so that it finds the solution that continues a motion.
 *
 * @param[in] motion The equations.
 * @param[in,out] positions The positions; unchanged on an error.
 * @return Whether no such positions are near, the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f32_motion_close(const wheeled_pendulum_f32_motion_t *motion,
    float positions[WHEELED_PENDULUM_POSITIONS]);

/**
 * For each wheel the force of the ground on it in N, along the axes of the ground: x forward at the start, y to the right and
 * z down, so that the last component of a wheel that stands on the ground is negative. Of wheels that share an axle the
 * sideways force of the first is that of all. From one straight-line program:
 * 126 additions, 169 multiplications, 5 divisions and 6 trigonometric functions: 306 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] contact_forces The forces, three numbers for each wheel, one wheel after the other.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f32_motion_contact_forces(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES], float contact_forces[3U *
    WHEELED_PENDULUM_WHEELS]);

/**
 * The nonlinear equations of motion to first order about a state, x' = x0' + A (x - x0) + B (f - f0), where x are all
 * positions and then all speeds.
 *
 * Derivatives are exact, and those along motions that the conditions leave: positions that the heights of the wheels determine
 * follow the others, so a column for such a position is zero.
 */
typedef struct {
    /** The derivatives of the rates of positions and speeds, a row for each, with respect to these, a column for each. */
    float a[WHEELED_PENDULUM_STATES][WHEELED_PENDULUM_STATES];
    /** The derivatives with respect to the forces, a column for each. */
    float b[WHEELED_PENDULUM_STATES][WHEELED_PENDULUM_FORCES];
} wheeled_pendulum_f32_linearization_t;

/**
 * A and B about a state, which need not be one of equilibrium:
 * 278 additions, 382 multiplications, 5 divisions, 4 negations and 6 trigonometric functions: 675 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] linearization The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f32_motion_linearize(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES],
    wheeled_pendulum_f32_linearization_t *linearization);

/**
 * The derivatives of the rates of all positions and then of the speeds, a row for each, with respect to the parameters in
 * declared order, a column for each. Free positions, speeds and forces stay what they are, and dependent positions follow:
 * 394 additions, 568 multiplications, 5 divisions, 11 negations and 6 trigonometric functions: 984 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] by_parameters The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t wheeled_pendulum_f32_motion_by_parameters(const wheeled_pendulum_f32_motion_t *motion,
    const float positions[WHEELED_PENDULUM_POSITIONS], const float speeds[WHEELED_PENDULUM_SPEEDS],
    const float forces[WHEELED_PENDULUM_FORCES],
    float by_parameters[WHEELED_PENDULUM_STATES][WHEELED_PENDULUM_PARAMETERS]);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_WHEELED_PENDULUM_H */
