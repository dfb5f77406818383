/* @generated from generated/models/rolling_disc.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 8da020cde61b723e
 */

/**
 * @file rolling_disc.h
 * @brief The model `RollingDisc`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * A disc that rolls without slip on level ground, upright and straight but for small lean and yaw.
 *
 * Its spin balances it: it falls over, slowly, unless v^2 > g r It m r^2/(Ia (Ia + m r^2)), which is g r/3 for a
 * uniform disc and g r/4 for a hoop. Axes: origin at the contact point, x forward, y to the right, z down.
 *
 * Source: Mechanism: Neimark & Fufaev (1972), Dynamics of Nonholonomic Systems
 *
 * Derived from a mechanism: wheel `D` (disc).
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `phi` (lean) in rad: Lean, positive to the right.
 * - `psi` (yaw) in rad: Yaw, positive to the right.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_ROLLING_DISC_H
#define CARVALLO_MODEL_ROLLING_DISC_H

#include "carvallo_motion.h"
#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define ROLLING_DISC_N 2U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `uniform`.
     *
     * Source: A uniform disc of 1 kg: Ia = m r^2/2, It = m r^2/4
     */
    ROLLING_DISC_SET_UNIFORM = 0,
    /**
     * The parameter set `hoop`.
     *
     * Source: A hoop of 1 kg: Ia = m r^2, It = m r^2/2
     */
    ROLLING_DISC_SET_HOOP = 1
} rolling_disc_set_t;

/** How many parameter sets there are. */
#define ROLLING_DISC_SETS 2U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *rolling_disc_set_name(rolling_disc_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    ROLLING_DISC_VALID = 0,
    /** `r` in m must be finite and > 0. */
    ROLLING_DISC_INVALID_r = 1,
    /** `m` in kg must be finite and > 0. */
    ROLLING_DISC_INVALID_m = 2,
    /** `Ia` in kg*m^2 must be finite and >= 0. */
    ROLLING_DISC_INVALID_Ia = 3,
    /** `It` in kg*m^2 must be finite and > 0. */
    ROLLING_DISC_INVALID_It = 4,
    /** `g` in N/kg must be finite and >= 0. */
    ROLLING_DISC_INVALID_g = 5
} rolling_disc_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *rolling_disc_validity_text(rolling_disc_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define ROLLING_DISC_PARTIALS 11U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t rolling_disc_partials[ROLLING_DISC_PARTIALS];

/** The place of a position among the positions, of which each joint has one. */
typedef enum {
    /** x of the contact point of the disc, in m */
    ROLLING_DISC_POSITION_x = 0,
    /** y of the contact point of the disc, in m */
    ROLLING_DISC_POSITION_y = 1,
    /** yaw, in rad */
    ROLLING_DISC_POSITION_psi = 2,
    /** lean, in rad */
    ROLLING_DISC_POSITION_phi = 3,
    /** angle of the disc, in rad */
    ROLLING_DISC_POSITION_thetaD = 4
} rolling_disc_position_t;

/** How many positions there are. */
#define ROLLING_DISC_POSITIONS 5U

/** The name of a position; a text of its own for what is none. */
const char *rolling_disc_position_name(rolling_disc_position_t which);

/** The place of a speed among the speeds, the rates that rolling leaves free. */
typedef enum {
    /** The rate of `psi`, in rad/s */
    ROLLING_DISC_SPEED_psi = 0,
    /** The rate of `phi`, in rad/s */
    ROLLING_DISC_SPEED_phi = 1,
    /** The rate of `thetaD`, in rad/s */
    ROLLING_DISC_SPEED_thetaD = 2
} rolling_disc_speed_t;

/** How many speeds there are. */
#define ROLLING_DISC_SPEEDS 3U

/** The name of a speed; a text of its own for what is none. */
const char *rolling_disc_speed_name(rolling_disc_speed_t which);

/** The place of a wheel among the contact forces. */
typedef enum {
    /** disc */
    ROLLING_DISC_WHEEL_D = 0
} rolling_disc_wheel_t;

/** How many wheels there are. */
#define ROLLING_DISC_WHEELS 1U

/** The name of a wheel; a text of its own for what is none. */
const char *rolling_disc_wheel_name(rolling_disc_wheel_t which);

/** How many states there are: all positions, and behind them the speeds. */
#define ROLLING_DISC_STATES (ROLLING_DISC_POSITIONS + ROLLING_DISC_SPEEDS)

/** How many parameters there are. */
#define ROLLING_DISC_PARAMETERS 5U

/* ------------------------------------------------------------ double */

/** The parameters of `RollingDisc`. */
typedef struct {
    /** Radius. `r`, in m: > 0. */
    double r;
    /** Mass. `m`, in kg: > 0. */
    double m;
    /** Axial moment of inertia, about the axle. `Ia`, in kg*m^2: >= 0. */
    double Ia;
    /** Transverse moment of inertia, about a diameter. `It`, in kg*m^2: > 0. */
    double It;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    double g;
} rolling_disc_f64_t;

/** The parameter sets, such as `rolling_disc_f64_sets[ROLLING_DISC_SET_UNIFORM]`. */
extern const rolling_disc_f64_t rolling_disc_f64_sets[ROLLING_DISC_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
rolling_disc_validity_t rolling_disc_f64_validate(const rolling_disc_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[ROLLING_DISC_N][ROLLING_DISC_N];
    /** Damping C1, a coefficient of v q'. */
    double c1[ROLLING_DISC_N][ROLLING_DISC_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    double k0[ROLLING_DISC_N][ROLLING_DISC_N];
} rolling_disc_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 2 additions, 2 multiplications, 1 division and 2 negations: 7 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void rolling_disc_f64_matrices(const rolling_disc_f64_t *p, rolling_disc_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[ROLLING_DISC_N][ROLLING_DISC_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[ROLLING_DISC_N][ROLLING_DISC_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[ROLLING_DISC_N][ROLLING_DISC_N];
} rolling_disc_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t rolling_disc_f64_at_speed(const rolling_disc_f64_matrices_t *matrices,
    double speed, double gravity, rolling_disc_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * ROLLING_DISC_N][2U * ROLLING_DISC_N];
    /** The input matrix B. */
    double b[2U * ROLLING_DISC_N][ROLLING_DISC_N];
} rolling_disc_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t rolling_disc_f64_state_space(const rolling_disc_f64_system_t *system,
    rolling_disc_f64_state_space_t *space);

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
    double rates[ROLLING_DISC_N];
    /** The part proportional to v and each q. */
    double coordinates[ROLLING_DISC_N];
    /** The part proportional to v and the yaw. */
    double heading;
} rolling_disc_f64_rate_t;

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
double rolling_disc_f64_rate_at(const rolling_disc_f64_rate_t *rate, double v,
    const double q[ROLLING_DISC_N], const double q_dot[ROLLING_DISC_N], double psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Lateral velocity, to the right, in `m/s`: of the point of `D` that is at the origin. */
    rolling_disc_f64_rate_t lateral;
    /** Spin of the wheel `D`, disc: about the y axis, so negative in forward motion, in `rad/s`. */
    rolling_disc_f64_rate_t wheel_D;
} rolling_disc_f64_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 division and 1 negation: 2 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void rolling_disc_f64_kinematics(const rolling_disc_f64_t *p, rolling_disc_f64_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `rolling_disc_partials`.
 */
typedef struct {
    double values[8];
} rolling_disc_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 4 additions, 5 multiplications, 1 division and 2 negations: 12 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void rolling_disc_f64_derivatives(const rolling_disc_f64_t *p,
    rolling_disc_f64_matrices_t *matrices, rolling_disc_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void rolling_disc_f64_with_respect_to(const rolling_disc_f64_derivatives_t *derivatives,
    size_t parameter, rolling_disc_f64_matrices_t *matrices);

/**
 * The nonlinear equations of motion with their parameters: what does not depend on the state, computed once.
 *
 * Everything is in SI units. Positions, their rates and accelerations are arrays in the order of the constants of positions,
 * speeds and their rates in that of the speeds. Positions have to be such that every wheel touches the ground; how far they
 * are from that, so far are the results. On an error what is computed is not to be used.
 */
typedef struct {
    /** In an order of their own. */
    double constants[9U];
} rolling_disc_f64_motion_t;

/**
 * What does not depend on the state, from one straight-line program:
 * 2 additions and 2 multiplications: 4 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] motion The equations.
 */
void rolling_disc_f64_motion(const rolling_disc_f64_t *p, rolling_disc_f64_motion_t *motion);

/**
 * The rates of all positions at given speeds, of which rolling determines the others:
 * 3 multiplications, 2 negations and 2 trigonometric functions: 7 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] rates The rates of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f64_motion_rates(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double rates[ROLLING_DISC_POSITIONS]);

/**
 * The rates of all positions and of the speeds, which is what an integration takes:
 * 18 additions, 39 multiplications, 3 divisions, 4 negations and 4 trigonometric functions: 68 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] rates The rates of the positions.
 * @param[out] speed_rates The rates of the speeds.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f64_motion_derivatives(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double rates[ROLLING_DISC_POSITIONS], double speed_rates[ROLLING_DISC_SPEEDS]);

/**
 * The second derivatives of all positions:
 * 20 additions, 43 multiplications, 3 divisions, 3 negations and 4 trigonometric functions: 73 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] accelerations The accelerations of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f64_motion_accelerations(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double accelerations[ROLLING_DISC_POSITIONS]);

/**
 * The kinetic energy, and the potential energy of gravity and springs, in J:
 * 7 additions, 17 multiplications and 2 trigonometric functions: 26 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] energy The kinetic energy, then the potential energy, which is zero where the centre of mass is at the
 *             height of the ground.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f64_motion_energy(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double energy[2]);

/**
 * For each wheel the force of the ground on it in N, along the axes of the ground: x forward at the start, y to the right and
 * z down, so that the last component of a wheel that stands on the ground is negative. Of wheels that share an axle the
 * sideways force of the first is that of all. From one straight-line program:
 * 29 additions, 55 multiplications, 3 divisions, 1 negation and 4 trigonometric functions: 92 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] contact_forces The forces, three numbers for each wheel, one wheel after the other.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f64_motion_contact_forces(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double contact_forces[3U * ROLLING_DISC_WHEELS]);

/**
 * The nonlinear equations of motion to first order about a state, x' = x0' + A (x - x0), where x are all
 * positions and then all speeds.
 *
 * Derivatives are exact, and those along motions that the conditions leave: positions that the heights of the wheels determine
 * follow the others, so a column for such a position is zero.
 */
typedef struct {
    /** The derivatives of the rates of positions and speeds, a row for each, with respect to these, a column for each. */
    double a[ROLLING_DISC_STATES][ROLLING_DISC_STATES];
} rolling_disc_f64_linearization_t;

/**
 * A about a state, which need not be one of equilibrium:
 * 53 additions, 101 multiplications, 3 divisions, 7 negations and 4 trigonometric functions: 168 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] linearization The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f64_motion_linearize(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    rolling_disc_f64_linearization_t *linearization);

/**
 * The derivatives of the rates of all positions and then of the speeds, a row for each, with respect to the parameters in
 * declared order, a column for each. Free positions, speeds and forces stay what they are, and dependent positions follow:
 * 38 additions, 83 multiplications, 3 divisions, 7 negations and 4 trigonometric functions: 135 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] by_parameters The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f64_motion_by_parameters(const rolling_disc_f64_motion_t *motion,
    const double positions[ROLLING_DISC_POSITIONS], const double speeds[ROLLING_DISC_SPEEDS],
    double by_parameters[ROLLING_DISC_STATES][ROLLING_DISC_PARAMETERS]);

/* ------------------------------------------------------------ float */

/** The parameters of `RollingDisc`. */
typedef struct {
    /** Radius. `r`, in m: > 0. */
    float r;
    /** Mass. `m`, in kg: > 0. */
    float m;
    /** Axial moment of inertia, about the axle. `Ia`, in kg*m^2: >= 0. */
    float Ia;
    /** Transverse moment of inertia, about a diameter. `It`, in kg*m^2: > 0. */
    float It;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    float g;
} rolling_disc_f32_t;

/** The parameter sets, such as `rolling_disc_f32_sets[ROLLING_DISC_SET_UNIFORM]`. */
extern const rolling_disc_f32_t rolling_disc_f32_sets[ROLLING_DISC_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
rolling_disc_validity_t rolling_disc_f32_validate(const rolling_disc_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[ROLLING_DISC_N][ROLLING_DISC_N];
    /** Damping C1, a coefficient of v q'. */
    float c1[ROLLING_DISC_N][ROLLING_DISC_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    float k0[ROLLING_DISC_N][ROLLING_DISC_N];
} rolling_disc_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 2 additions, 2 multiplications, 1 division and 2 negations: 7 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void rolling_disc_f32_matrices(const rolling_disc_f32_t *p, rolling_disc_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[ROLLING_DISC_N][ROLLING_DISC_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[ROLLING_DISC_N][ROLLING_DISC_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[ROLLING_DISC_N][ROLLING_DISC_N];
} rolling_disc_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t rolling_disc_f32_at_speed(const rolling_disc_f32_matrices_t *matrices,
    float speed, float gravity, rolling_disc_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * ROLLING_DISC_N][2U * ROLLING_DISC_N];
    /** The input matrix B. */
    float b[2U * ROLLING_DISC_N][ROLLING_DISC_N];
} rolling_disc_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t rolling_disc_f32_state_space(const rolling_disc_f32_system_t *system,
    rolling_disc_f32_state_space_t *space);

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
    float rates[ROLLING_DISC_N];
    /** The part proportional to v and each q. */
    float coordinates[ROLLING_DISC_N];
    /** The part proportional to v and the yaw. */
    float heading;
} rolling_disc_f32_rate_t;

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
float rolling_disc_f32_rate_at(const rolling_disc_f32_rate_t *rate, float v,
    const float q[ROLLING_DISC_N], const float q_dot[ROLLING_DISC_N], float psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Lateral velocity, to the right, in `m/s`: of the point of `D` that is at the origin. */
    rolling_disc_f32_rate_t lateral;
    /** Spin of the wheel `D`, disc: about the y axis, so negative in forward motion, in `rad/s`. */
    rolling_disc_f32_rate_t wheel_D;
} rolling_disc_f32_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 division and 1 negation: 2 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void rolling_disc_f32_kinematics(const rolling_disc_f32_t *p, rolling_disc_f32_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `rolling_disc_partials`.
 */
typedef struct {
    float values[8];
} rolling_disc_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 4 additions, 5 multiplications, 1 division and 2 negations: 12 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void rolling_disc_f32_derivatives(const rolling_disc_f32_t *p,
    rolling_disc_f32_matrices_t *matrices, rolling_disc_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void rolling_disc_f32_with_respect_to(const rolling_disc_f32_derivatives_t *derivatives,
    size_t parameter, rolling_disc_f32_matrices_t *matrices);

/**
 * The nonlinear equations of motion with their parameters: what does not depend on the state, computed once.
 *
 * Everything is in SI units. Positions, their rates and accelerations are arrays in the order of the constants of positions,
 * speeds and their rates in that of the speeds. Positions have to be such that every wheel touches the ground; how far they
 * are from that, so far are the results. On an error what is computed is not to be used.
 */
typedef struct {
    /** In an order of their own. */
    float constants[9U];
} rolling_disc_f32_motion_t;

/**
 * What does not depend on the state, from one straight-line program:
 * 2 additions and 2 multiplications: 4 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] motion The equations.
 */
void rolling_disc_f32_motion(const rolling_disc_f32_t *p, rolling_disc_f32_motion_t *motion);

/**
 * The rates of all positions at given speeds, of which rolling determines the others:
 * 3 multiplications, 2 negations and 2 trigonometric functions: 7 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] rates The rates of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f32_motion_rates(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float rates[ROLLING_DISC_POSITIONS]);

/**
 * The rates of all positions and of the speeds, which is what an integration takes:
 * 18 additions, 39 multiplications, 3 divisions, 4 negations and 4 trigonometric functions: 68 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] rates The rates of the positions.
 * @param[out] speed_rates The rates of the speeds.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f32_motion_derivatives(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float rates[ROLLING_DISC_POSITIONS], float speed_rates[ROLLING_DISC_SPEEDS]);

/**
 * The second derivatives of all positions:
 * 20 additions, 43 multiplications, 3 divisions, 3 negations and 4 trigonometric functions: 73 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] accelerations The accelerations of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f32_motion_accelerations(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float accelerations[ROLLING_DISC_POSITIONS]);

/**
 * The kinetic energy, and the potential energy of gravity and springs, in J:
 * 7 additions, 17 multiplications and 2 trigonometric functions: 26 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] energy The kinetic energy, then the potential energy, which is zero where the centre of mass is at the
 *             height of the ground.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f32_motion_energy(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float energy[2]);

/**
 * For each wheel the force of the ground on it in N, along the axes of the ground: x forward at the start, y to the right and
 * z down, so that the last component of a wheel that stands on the ground is negative. Of wheels that share an axle the
 * sideways force of the first is that of all. From one straight-line program:
 * 29 additions, 55 multiplications, 3 divisions, 1 negation and 4 trigonometric functions: 92 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] contact_forces The forces, three numbers for each wheel, one wheel after the other.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f32_motion_contact_forces(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float contact_forces[3U * ROLLING_DISC_WHEELS]);

/**
 * The nonlinear equations of motion to first order about a state, x' = x0' + A (x - x0), where x are all
 * positions and then all speeds.
 *
 * Derivatives are exact, and those along motions that the conditions leave: positions that the heights of the wheels determine
 * follow the others, so a column for such a position is zero.
 */
typedef struct {
    /** The derivatives of the rates of positions and speeds, a row for each, with respect to these, a column for each. */
    float a[ROLLING_DISC_STATES][ROLLING_DISC_STATES];
} rolling_disc_f32_linearization_t;

/**
 * A about a state, which need not be one of equilibrium:
 * 53 additions, 101 multiplications, 3 divisions, 7 negations and 4 trigonometric functions: 168 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] linearization The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f32_motion_linearize(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    rolling_disc_f32_linearization_t *linearization);

/**
 * The derivatives of the rates of all positions and then of the speeds, a row for each, with respect to the parameters in
 * declared order, a column for each. Free positions, speeds and forces stay what they are, and dependent positions follow:
 * 38 additions, 83 multiplications, 3 divisions, 7 negations and 4 trigonometric functions: 135 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] by_parameters The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t rolling_disc_f32_motion_by_parameters(const rolling_disc_f32_motion_t *motion,
    const float positions[ROLLING_DISC_POSITIONS], const float speeds[ROLLING_DISC_SPEEDS],
    float by_parameters[ROLLING_DISC_STATES][ROLLING_DISC_PARAMETERS]);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_ROLLING_DISC_H */
