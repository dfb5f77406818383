/* @generated from generated/models/double_pendulum.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 159450b9b3aa9cf1
 */

/**
 * @file double_pendulum.h
 * @brief The model `DoublePendulum`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * An inverted double pendulum: two links, one standing on the other, which lean to the right about axes along x.
 *
 * Axes: origin at the lower hinge, x forward, y to the right, z down, so that what is above it has z < 0. The second
 * angle is that between the links.
 *
 * Source: Mechanism: Kibble & Berkshire (2004), Classical Mechanics, section 11.3, turned upside down
 *
 * Derived from a mechanism: body `lower`, body `upper`.
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `theta1` (lower link) in rad: Lean of the lower link, to the right.
 * - `theta2` (upper link) in rad: Lean of the upper link relative to the lower one, to the right.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_DOUBLE_PENDULUM_H
#define CARVALLO_MODEL_DOUBLE_PENDULUM_H

#include "carvallo_motion.h"
#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define DOUBLE_PENDULUM_N 2U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `rods`.
     *
     * Source: Two slender rods of 1 m and 1 kg
     */
    DOUBLE_PENDULUM_SET_RODS = 0
} double_pendulum_set_t;

/** How many parameter sets there are. */
#define DOUBLE_PENDULUM_SETS 1U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *double_pendulum_set_name(double_pendulum_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    DOUBLE_PENDULUM_VALID = 0,
    /** `l1` in m must be finite and > 0. */
    DOUBLE_PENDULUM_INVALID_l1 = 1,
    /** `a1` in m must be finite. */
    DOUBLE_PENDULUM_INVALID_a1 = 2,
    /** `m1` in kg must be finite and >= 0. */
    DOUBLE_PENDULUM_INVALID_m1 = 3,
    /** `I1` in kg*m^2 must be finite and >= 0. */
    DOUBLE_PENDULUM_INVALID_I1 = 4,
    /** `a2` in m must be finite. */
    DOUBLE_PENDULUM_INVALID_a2 = 5,
    /** `m2` in kg must be finite and >= 0. */
    DOUBLE_PENDULUM_INVALID_m2 = 6,
    /** `I2` in kg*m^2 must be finite and >= 0. */
    DOUBLE_PENDULUM_INVALID_I2 = 7,
    /** `g` in N/kg must be finite and >= 0. */
    DOUBLE_PENDULUM_INVALID_g = 8
} double_pendulum_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *double_pendulum_validity_text(double_pendulum_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define DOUBLE_PENDULUM_PARTIALS 29U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t double_pendulum_partials[DOUBLE_PENDULUM_PARTIALS];

/** The place of a position among the positions, of which each joint has one. */
typedef enum {
    /** lower link, in rad */
    DOUBLE_PENDULUM_POSITION_theta1 = 0,
    /** upper link, in rad */
    DOUBLE_PENDULUM_POSITION_theta2 = 1
} double_pendulum_position_t;

/** How many positions there are. */
#define DOUBLE_PENDULUM_POSITIONS 2U

/** The name of a position; a text of its own for what is none. */
const char *double_pendulum_position_name(double_pendulum_position_t which);

/** The place of a speed among the speeds, the rates that rolling leaves free. */
typedef enum {
    /** The rate of `theta1`, in rad/s */
    DOUBLE_PENDULUM_SPEED_theta1 = 0,
    /** The rate of `theta2`, in rad/s */
    DOUBLE_PENDULUM_SPEED_theta2 = 1
} double_pendulum_speed_t;

/** How many speeds there are. */
#define DOUBLE_PENDULUM_SPEEDS 2U

/** The name of a speed; a text of its own for what is none. */
const char *double_pendulum_speed_name(double_pendulum_speed_t which);

/** The place of a force or torque among those that may be applied. */
typedef enum {
    /** torque at the lower hinge, in N*m */
    DOUBLE_PENDULUM_FORCE_T1 = 0,
    /** torque between the links, in N*m */
    DOUBLE_PENDULUM_FORCE_T2 = 1
} double_pendulum_force_t;

/** How many forces there are. */
#define DOUBLE_PENDULUM_FORCES 2U

/** The name of a force; a text of its own for what is none. */
const char *double_pendulum_force_name(double_pendulum_force_t which);

/** How many states there are: all positions, and behind them the speeds. */
#define DOUBLE_PENDULUM_STATES (DOUBLE_PENDULUM_POSITIONS + DOUBLE_PENDULUM_SPEEDS)

/** How many parameters there are. */
#define DOUBLE_PENDULUM_PARAMETERS 8U

/* ------------------------------------------------------------ double */

/** The parameters of `DoublePendulum`. */
typedef struct {
    /** Length of the lower link, from hinge to hinge. `l1`, in m: > 0. */
    double l1;
    /** Centre of mass of the lower link, above its hinge. `a1`, in m: any finite value. */
    double a1;
    /** Mass of the lower link. `m1`, in kg: >= 0. */
    double m1;
    /** Moment of inertia of the lower link about its centre of mass. `I1`, in kg*m^2: >= 0. */
    double I1;
    /** Centre of mass of the upper link, above its hinge. `a2`, in m: any finite value. */
    double a2;
    /** Mass of the upper link. `m2`, in kg: >= 0. */
    double m2;
    /** Moment of inertia of the upper link about its centre of mass. `I2`, in kg*m^2: >= 0. */
    double I2;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    double g;
} double_pendulum_f64_t;

/** The parameter sets, such as `double_pendulum_f64_sets[DOUBLE_PENDULUM_SET_RODS]`. */
extern const double_pendulum_f64_t double_pendulum_f64_sets[DOUBLE_PENDULUM_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
double_pendulum_validity_t double_pendulum_f64_validate(const double_pendulum_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[DOUBLE_PENDULUM_N][DOUBLE_PENDULUM_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    double k0[DOUBLE_PENDULUM_N][DOUBLE_PENDULUM_N];
} double_pendulum_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 7 additions, 7 multiplications and 2 negations: 16 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void double_pendulum_f64_matrices(const double_pendulum_f64_t *p, double_pendulum_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[DOUBLE_PENDULUM_N][DOUBLE_PENDULUM_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[DOUBLE_PENDULUM_N][DOUBLE_PENDULUM_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[DOUBLE_PENDULUM_N][DOUBLE_PENDULUM_N];
} double_pendulum_f64_system_t;

/**
 * The equations of motion.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t double_pendulum_f64_system(const double_pendulum_f64_matrices_t *matrices,
    double gravity, double_pendulum_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * DOUBLE_PENDULUM_N][2U * DOUBLE_PENDULUM_N];
    /** The input matrix B. */
    double b[2U * DOUBLE_PENDULUM_N][DOUBLE_PENDULUM_N];
} double_pendulum_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t double_pendulum_f64_state_space(const double_pendulum_f64_system_t *system,
    double_pendulum_f64_state_space_t *space);

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
    double rates[DOUBLE_PENDULUM_N];
    /** The part proportional to v and each q. */
    double coordinates[DOUBLE_PENDULUM_N];
    /** The part proportional to v and the yaw. */
    double heading;
} double_pendulum_f64_rate_t;

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
double double_pendulum_f64_rate_at(const double_pendulum_f64_rate_t *rate, double v,
    const double q[DOUBLE_PENDULUM_N], const double q_dot[DOUBLE_PENDULUM_N], double psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `T1` (torque at the lower hinge) in N*m, `T2` (torque between the links) in N*m.
     */
    double forces[DOUBLE_PENDULUM_N][2];
} double_pendulum_f64_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * no operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void double_pendulum_f64_kinematics(const double_pendulum_f64_t *p, double_pendulum_f64_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `double_pendulum_partials`.
 */
typedef struct {
    double values[15];
} double_pendulum_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 11 additions, 11 multiplications and 2 negations: 24 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void double_pendulum_f64_derivatives(const double_pendulum_f64_t *p,
    double_pendulum_f64_matrices_t *matrices, double_pendulum_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void double_pendulum_f64_with_respect_to(const double_pendulum_f64_derivatives_t *derivatives,
    size_t parameter, double_pendulum_f64_matrices_t *matrices);

/**
 * The nonlinear equations of motion with their parameters: what does not depend on the state, computed once.
 *
 * Everything is in SI units. Positions, their rates and accelerations are arrays in the order of the constants of positions,
 * speeds and their rates in that of the speeds. Positions have to be such that every wheel touches the ground; how far they
 * are from that, so far are the results. On an error what is computed is not to be used.
 */
typedef struct {
    /** In an order of their own. */
    double constants[12U];
} double_pendulum_f64_motion_t;

/**
 * What does not depend on the state, from one straight-line program:
 * 4 additions and 6 multiplications: 10 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] motion The equations.
 */
void double_pendulum_f64_motion(const double_pendulum_f64_t *p,
    double_pendulum_f64_motion_t *motion);

/**
 * The rates of all positions at given speeds, of which rolling determines the others:
 * no operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] rates The rates of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t double_pendulum_f64_motion_rates(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    double rates[DOUBLE_PENDULUM_POSITIONS]);

/**
 * The rates of all positions and of the speeds, which is what an integration takes:
 * 17 additions, 25 multiplications, 2 divisions and 4 trigonometric functions: 48 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] rates The rates of the positions.
 * @param[out] speed_rates The rates of the speeds.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t double_pendulum_f64_motion_derivatives(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    const double forces[DOUBLE_PENDULUM_FORCES], double rates[DOUBLE_PENDULUM_POSITIONS],
    double speed_rates[DOUBLE_PENDULUM_SPEEDS]);

/**
 * The second derivatives of all positions:
 * 17 additions, 25 multiplications, 2 divisions and 4 trigonometric functions: 48 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] accelerations The accelerations of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t double_pendulum_f64_motion_accelerations(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    const double forces[DOUBLE_PENDULUM_FORCES], double accelerations[DOUBLE_PENDULUM_POSITIONS]);

/**
 * The kinetic energy, and the potential energy of gravity and springs, in J:
 * 10 additions, 13 multiplications, 1 negation and 4 trigonometric functions: 28 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] energy The kinetic energy, then the potential energy, which is zero where the centre of mass is at the
 *             height of the ground.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t double_pendulum_f64_motion_energy(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    double energy[2]);

/**
 * The nonlinear equations of motion to first order about a state, x' = x0' + A (x - x0) + B (f - f0), where x are all
 * positions and then all speeds.
 *
 * Derivatives are exact, and those along motions that the conditions leave: positions that the heights of the wheels determine
 * follow the others, so a column for such a position is zero.
 */
typedef struct {
    /** The derivatives of the rates of positions and speeds, a row for each, with respect to these, a column for each. */
    double a[DOUBLE_PENDULUM_STATES][DOUBLE_PENDULUM_STATES];
    /** The derivatives with respect to the forces, a column for each. */
    double b[DOUBLE_PENDULUM_STATES][DOUBLE_PENDULUM_FORCES];
} double_pendulum_f64_linearization_t;

/**
 * A and B about a state, which need not be one of equilibrium:
 * 43 additions, 71 multiplications, 2 divisions, 3 negations and 4 trigonometric functions: 123 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] linearization The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t double_pendulum_f64_motion_linearize(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    const double forces[DOUBLE_PENDULUM_FORCES],
    double_pendulum_f64_linearization_t *linearization);

/**
 * The derivatives of the rates of all positions and then of the speeds, a row for each, with respect to the parameters in
 * declared order, a column for each. Free positions, speeds and forces stay what they are, and dependent positions follow:
 * 58 additions, 97 multiplications, 2 divisions, 6 negations and 4 trigonometric functions: 167 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] by_parameters The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t double_pendulum_f64_motion_by_parameters(const double_pendulum_f64_motion_t *motion,
    const double positions[DOUBLE_PENDULUM_POSITIONS], const double speeds[DOUBLE_PENDULUM_SPEEDS],
    const double forces[DOUBLE_PENDULUM_FORCES],
    double by_parameters[DOUBLE_PENDULUM_STATES][DOUBLE_PENDULUM_PARAMETERS]);

/* ------------------------------------------------------------ float */

/** The parameters of `DoublePendulum`. */
typedef struct {
    /** Length of the lower link, from hinge to hinge. `l1`, in m: > 0. */
    float l1;
    /** Centre of mass of the lower link, above its hinge. `a1`, in m: any finite value. */
    float a1;
    /** Mass of the lower link. `m1`, in kg: >= 0. */
    float m1;
    /** Moment of inertia of the lower link about its centre of mass. `I1`, in kg*m^2: >= 0. */
    float I1;
    /** Centre of mass of the upper link, above its hinge. `a2`, in m: any finite value. */
    float a2;
    /** Mass of the upper link. `m2`, in kg: >= 0. */
    float m2;
    /** Moment of inertia of the upper link about its centre of mass. `I2`, in kg*m^2: >= 0. */
    float I2;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    float g;
} double_pendulum_f32_t;

/** The parameter sets, such as `double_pendulum_f32_sets[DOUBLE_PENDULUM_SET_RODS]`. */
extern const double_pendulum_f32_t double_pendulum_f32_sets[DOUBLE_PENDULUM_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
double_pendulum_validity_t double_pendulum_f32_validate(const double_pendulum_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[DOUBLE_PENDULUM_N][DOUBLE_PENDULUM_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    float k0[DOUBLE_PENDULUM_N][DOUBLE_PENDULUM_N];
} double_pendulum_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 7 additions, 7 multiplications and 2 negations: 16 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void double_pendulum_f32_matrices(const double_pendulum_f32_t *p, double_pendulum_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[DOUBLE_PENDULUM_N][DOUBLE_PENDULUM_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[DOUBLE_PENDULUM_N][DOUBLE_PENDULUM_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[DOUBLE_PENDULUM_N][DOUBLE_PENDULUM_N];
} double_pendulum_f32_system_t;

/**
 * The equations of motion.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t double_pendulum_f32_system(const double_pendulum_f32_matrices_t *matrices,
    float gravity, double_pendulum_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * DOUBLE_PENDULUM_N][2U * DOUBLE_PENDULUM_N];
    /** The input matrix B. */
    float b[2U * DOUBLE_PENDULUM_N][DOUBLE_PENDULUM_N];
} double_pendulum_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t double_pendulum_f32_state_space(const double_pendulum_f32_system_t *system,
    double_pendulum_f32_state_space_t *space);

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
    float rates[DOUBLE_PENDULUM_N];
    /** The part proportional to v and each q. */
    float coordinates[DOUBLE_PENDULUM_N];
    /** The part proportional to v and the yaw. */
    float heading;
} double_pendulum_f32_rate_t;

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
float double_pendulum_f32_rate_at(const double_pendulum_f32_rate_t *rate, float v,
    const float q[DOUBLE_PENDULUM_N], const float q_dot[DOUBLE_PENDULUM_N], float psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `T1` (torque at the lower hinge) in N*m, `T2` (torque between the links) in N*m.
     */
    float forces[DOUBLE_PENDULUM_N][2];
} double_pendulum_f32_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * no operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void double_pendulum_f32_kinematics(const double_pendulum_f32_t *p, double_pendulum_f32_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `double_pendulum_partials`.
 */
typedef struct {
    float values[15];
} double_pendulum_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 11 additions, 11 multiplications and 2 negations: 24 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void double_pendulum_f32_derivatives(const double_pendulum_f32_t *p,
    double_pendulum_f32_matrices_t *matrices, double_pendulum_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void double_pendulum_f32_with_respect_to(const double_pendulum_f32_derivatives_t *derivatives,
    size_t parameter, double_pendulum_f32_matrices_t *matrices);

/**
 * The nonlinear equations of motion with their parameters: what does not depend on the state, computed once.
 *
 * Everything is in SI units. Positions, their rates and accelerations are arrays in the order of the constants of positions,
 * speeds and their rates in that of the speeds. Positions have to be such that every wheel touches the ground; how far they
 * are from that, so far are the results. On an error what is computed is not to be used.
 */
typedef struct {
    /** In an order of their own. */
    float constants[12U];
} double_pendulum_f32_motion_t;

/**
 * What does not depend on the state, from one straight-line program:
 * 4 additions and 6 multiplications: 10 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] motion The equations.
 */
void double_pendulum_f32_motion(const double_pendulum_f32_t *p,
    double_pendulum_f32_motion_t *motion);

/**
 * The rates of all positions at given speeds, of which rolling determines the others:
 * no operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] rates The rates of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t double_pendulum_f32_motion_rates(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    float rates[DOUBLE_PENDULUM_POSITIONS]);

/**
 * The rates of all positions and of the speeds, which is what an integration takes:
 * 17 additions, 25 multiplications, 2 divisions and 4 trigonometric functions: 48 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] rates The rates of the positions.
 * @param[out] speed_rates The rates of the speeds.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t double_pendulum_f32_motion_derivatives(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    const float forces[DOUBLE_PENDULUM_FORCES], float rates[DOUBLE_PENDULUM_POSITIONS],
    float speed_rates[DOUBLE_PENDULUM_SPEEDS]);

/**
 * The second derivatives of all positions:
 * 17 additions, 25 multiplications, 2 divisions and 4 trigonometric functions: 48 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] accelerations The accelerations of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t double_pendulum_f32_motion_accelerations(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    const float forces[DOUBLE_PENDULUM_FORCES], float accelerations[DOUBLE_PENDULUM_POSITIONS]);

/**
 * The kinetic energy, and the potential energy of gravity and springs, in J:
 * 10 additions, 13 multiplications, 1 negation and 4 trigonometric functions: 28 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] energy The kinetic energy, then the potential energy, which is zero where the centre of mass is at the
 *             height of the ground.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t double_pendulum_f32_motion_energy(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    float energy[2]);

/**
 * The nonlinear equations of motion to first order about a state, x' = x0' + A (x - x0) + B (f - f0), where x are all
 * positions and then all speeds.
 *
 * Derivatives are exact, and those along motions that the conditions leave: positions that the heights of the wheels determine
 * follow the others, so a column for such a position is zero.
 */
typedef struct {
    /** The derivatives of the rates of positions and speeds, a row for each, with respect to these, a column for each. */
    float a[DOUBLE_PENDULUM_STATES][DOUBLE_PENDULUM_STATES];
    /** The derivatives with respect to the forces, a column for each. */
    float b[DOUBLE_PENDULUM_STATES][DOUBLE_PENDULUM_FORCES];
} double_pendulum_f32_linearization_t;

/**
 * A and B about a state, which need not be one of equilibrium:
 * 43 additions, 71 multiplications, 2 divisions, 3 negations and 4 trigonometric functions: 123 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] linearization The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t double_pendulum_f32_motion_linearize(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    const float forces[DOUBLE_PENDULUM_FORCES], double_pendulum_f32_linearization_t *linearization);

/**
 * The derivatives of the rates of all positions and then of the speeds, a row for each, with respect to the parameters in
 * declared order, a column for each. Free positions, speeds and forces stay what they are, and dependent positions follow:
 * 58 additions, 97 multiplications, 2 divisions, 6 negations and 4 trigonometric functions: 167 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] by_parameters The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t double_pendulum_f32_motion_by_parameters(const double_pendulum_f32_motion_t *motion,
    const float positions[DOUBLE_PENDULUM_POSITIONS], const float speeds[DOUBLE_PENDULUM_SPEEDS],
    const float forces[DOUBLE_PENDULUM_FORCES],
    float by_parameters[DOUBLE_PENDULUM_STATES][DOUBLE_PENDULUM_PARAMETERS]);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_DOUBLE_PENDULUM_H */
