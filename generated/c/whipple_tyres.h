/* @generated from generated/models/whipple_tyres.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 0fd874e368fb3457
 */

/**
 * @file whipple_tyres.h
 * @brief The model `WhippleTyres`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * The Whipple-Carvallo bicycle on tyres whose cross-sections are circles.
 *
 * Four rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally
 * symmetric. The rims of the wheels are parts of tori that roll without slip on level ground: the radii rR and rF of
 * the wheels reach from the centre to the ground, and those of the cross-sections, rhoR and rhoF, are parts of them.
 * Axes: origin at the rear contact point, x forward, y to the right, z down.
 *
 * Source: Mechanism: a bicycle on tyres with circular cross-sections, as in Meijaard & Schwab (2006), Linearized equations for an extended bicycle model, III European Conference on Computational Mechanics
 *
 * Derived from a mechanism: body `B` (rear frame and rider), body `H` (front frame), wheel `R` (rear wheel), wheel `F` (front wheel).
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `phi` (lean) in rad: Lean of the rear frame, positive to the right.
 * - `delta` (steer) in rad: Steer of the front frame relative to the rear frame, positive to the right.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_WHIPPLE_TYRES_H
#define CARVALLO_MODEL_WHIPPLE_TYRES_H

#include "carvallo_motion.h"
#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define WHIPPLE_TYRES_N 2U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `benchmark`.
     *
     * Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; tyres are examples
     */
    WHIPPLE_TYRES_SET_BENCHMARK = 0,
    /**
     * The parameter set `benchmark_2005`.
     *
     * Source: Schwab, Meijaard & Papadopoulos (2005), ENOC 2005; tyres are examples
     */
    WHIPPLE_TYRES_SET_BENCHMARK_2005 = 1
} whipple_tyres_set_t;

/** How many parameter sets there are. */
#define WHIPPLE_TYRES_SETS 2U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *whipple_tyres_set_name(whipple_tyres_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    WHIPPLE_TYRES_VALID = 0,
    /** `w` in m must be finite and > 0. */
    WHIPPLE_TYRES_INVALID_w = 1,
    /** `c` in m must be finite. */
    WHIPPLE_TYRES_INVALID_c = 2,
    /** `lam` in rad must be finite and > -1.5707963267948966 and < 1.5707963267948966. */
    WHIPPLE_TYRES_INVALID_lam = 3,
    /** `g` in N/kg must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_g = 4,
    /** `rR` in m must be finite and > 0. */
    WHIPPLE_TYRES_INVALID_rR = 5,
    /** `mR` in kg must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_mR = 6,
    /** `IRxx` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_IRxx = 7,
    /** `IRyy` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_IRyy = 8,
    /** `xB` in m must be finite. */
    WHIPPLE_TYRES_INVALID_xB = 9,
    /** `zB` in m must be finite. */
    WHIPPLE_TYRES_INVALID_zB = 10,
    /** `mB` in kg must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_mB = 11,
    /** `IBxx` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_IBxx = 12,
    /** `IByy` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_IByy = 13,
    /** `IBzz` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_IBzz = 14,
    /** `IBxz` in kg*m^2 must be finite. */
    WHIPPLE_TYRES_INVALID_IBxz = 15,
    /** `xH` in m must be finite. */
    WHIPPLE_TYRES_INVALID_xH = 16,
    /** `zH` in m must be finite. */
    WHIPPLE_TYRES_INVALID_zH = 17,
    /** `mH` in kg must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_mH = 18,
    /** `IHxx` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_IHxx = 19,
    /** `IHyy` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_IHyy = 20,
    /** `IHzz` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_IHzz = 21,
    /** `IHxz` in kg*m^2 must be finite. */
    WHIPPLE_TYRES_INVALID_IHxz = 22,
    /** `rF` in m must be finite and > 0. */
    WHIPPLE_TYRES_INVALID_rF = 23,
    /** `mF` in kg must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_mF = 24,
    /** `IFxx` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_IFxx = 25,
    /** `IFyy` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_IFyy = 26,
    /** `rhoR` in m must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_rhoR = 27,
    /** `rhoF` in m must be finite and >= 0. */
    WHIPPLE_TYRES_INVALID_rhoF = 28,
    /** `rR - rhoR` in m must be finite and >= 0, as the radius of `R` without that of its tyre. */
    WHIPPLE_TYRES_REQUIREMENT_1 = 29,
    /** `rF - rhoF` in m must be finite and >= 0, as the radius of `F` without that of its tyre. */
    WHIPPLE_TYRES_REQUIREMENT_2 = 30
} whipple_tyres_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *whipple_tyres_validity_text(whipple_tyres_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define WHIPPLE_TYRES_PARTIALS 166U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t whipple_tyres_partials[WHIPPLE_TYRES_PARTIALS];

/** The place of a position among the positions, of which each joint has one. */
typedef enum {
    /** x of the contact point of the rear wheel, in m */
    WHIPPLE_TYRES_POSITION_x = 0,
    /** y of the contact point of the rear wheel, in m */
    WHIPPLE_TYRES_POSITION_y = 1,
    /** yaw, in rad */
    WHIPPLE_TYRES_POSITION_psi = 2,
    /** lean, in rad */
    WHIPPLE_TYRES_POSITION_phi = 3,
    /** pitch, by the heights of the wheels, in rad */
    WHIPPLE_TYRES_POSITION_pitch = 4,
    /** steer, in rad */
    WHIPPLE_TYRES_POSITION_delta = 5,
    /** angle of the rear wheel, in rad */
    WHIPPLE_TYRES_POSITION_thetaR = 6,
    /** angle of the front wheel, in rad */
    WHIPPLE_TYRES_POSITION_thetaF = 7
} whipple_tyres_position_t;

/** How many positions there are. */
#define WHIPPLE_TYRES_POSITIONS 8U

/** The name of a position; a text of its own for what is none. */
const char *whipple_tyres_position_name(whipple_tyres_position_t which);

/** The place of a speed among the speeds, the rates that rolling leaves free. */
typedef enum {
    /** The rate of `phi`, in rad/s */
    WHIPPLE_TYRES_SPEED_phi = 0,
    /** The rate of `delta`, in rad/s */
    WHIPPLE_TYRES_SPEED_delta = 1,
    /** The rate of `thetaR`, in rad/s */
    WHIPPLE_TYRES_SPEED_thetaR = 2
} whipple_tyres_speed_t;

/** How many speeds there are. */
#define WHIPPLE_TYRES_SPEEDS 3U

/** The name of a speed; a text of its own for what is none. */
const char *whipple_tyres_speed_name(whipple_tyres_speed_t which);

/** The place of a force or torque among those that may be applied. */
typedef enum {
    /** lean torque, in N*m */
    WHIPPLE_TYRES_FORCE_Tphi = 0,
    /** steer torque, in N*m */
    WHIPPLE_TYRES_FORCE_Tdelta = 1
} whipple_tyres_force_t;

/** How many forces there are. */
#define WHIPPLE_TYRES_FORCES 2U

/** The name of a force; a text of its own for what is none. */
const char *whipple_tyres_force_name(whipple_tyres_force_t which);

/** The place of a wheel among the contact forces. */
typedef enum {
    /** rear wheel */
    WHIPPLE_TYRES_WHEEL_R = 0,
    /** front wheel */
    WHIPPLE_TYRES_WHEEL_F = 1
} whipple_tyres_wheel_t;

/** How many wheels there are. */
#define WHIPPLE_TYRES_WHEELS 2U

/** The name of a wheel; a text of its own for what is none. */
const char *whipple_tyres_wheel_name(whipple_tyres_wheel_t which);

/** How many states there are: all positions, and behind them the speeds. */
#define WHIPPLE_TYRES_STATES (WHIPPLE_TYRES_POSITIONS + WHIPPLE_TYRES_SPEEDS)

/** How many parameters there are. */
#define WHIPPLE_TYRES_PARAMETERS 28U

/* ------------------------------------------------------------ double */

/** The parameters of `WhippleTyres`. */
typedef struct {
    /** Wheel base. `w`, in m: > 0. */
    double w;
    /**
     * Trail: positive when the front contact is behind the point where the steer axis meets the ground. `c`, in m: any finite value.
     */
    double c;
    /**
     * Steer axis tilt: 90 degrees minus the head angle. `lam` λ, in rad: > -1.5707963267948966 and < 1.5707963267948966.
     */
    double lam;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    double g;
    /** Radius of the rear wheel. `rR`, in m: > 0. */
    double rR;
    /** Mass of the rear wheel. `mR`, in kg: >= 0. */
    double mR;
    /** Radial moment of inertia of the rear wheel; by symmetry also about the vertical. `IRxx`, in kg*m^2: >= 0. */
    double IRxx;
    /** Axial moment of inertia of the rear wheel. `IRyy`, in kg*m^2: >= 0. */
    double IRyy;
    /** Centre of mass of the rear frame and rider, forward of the rear contact. `xB`, in m: any finite value. */
    double xB;
    /** Centre of mass of the rear frame and rider, downward. `zB`, in m: any finite value. */
    double zB;
    /** Mass of the rear frame and rider. `mB`, in kg: >= 0. */
    double mB;
    /** Moment of inertia of the rear frame and rider about its centre of mass, in roll. `IBxx`, in kg*m^2: >= 0. */
    double IBxx;
    /**
     * Moment of inertia of the rear frame and rider about its centre of mass, in pitch. `IByy`, in kg*m^2: >= 0. No matrix depends on it.
     */
    double IByy;
    /** Moment of inertia of the rear frame and rider about its centre of mass, in yaw. `IBzz`, in kg*m^2: >= 0. */
    double IBzz;
    /**
     * Product of inertia of the rear frame and rider about its centre of mass. `IBxz`, in kg*m^2: any finite value.
     */
    double IBxz;
    /** Centre of mass of the front frame, forward of the rear contact. `xH`, in m: any finite value. */
    double xH;
    /** Centre of mass of the front frame, downward. `zH`, in m: any finite value. */
    double zH;
    /** Mass of the front frame. `mH`, in kg: >= 0. */
    double mH;
    /** Moment of inertia of the front frame about its centre of mass, in roll. `IHxx`, in kg*m^2: >= 0. */
    double IHxx;
    /**
     * Moment of inertia of the front frame about its centre of mass, in pitch. `IHyy`, in kg*m^2: >= 0. No matrix depends on it.
     */
    double IHyy;
    /** Moment of inertia of the front frame about its centre of mass, in yaw. `IHzz`, in kg*m^2: >= 0. */
    double IHzz;
    /** Product of inertia of the front frame about its centre of mass. `IHxz`, in kg*m^2: any finite value. */
    double IHxz;
    /** Radius of the front wheel. `rF`, in m: > 0. */
    double rF;
    /** Mass of the front wheel. `mF`, in kg: >= 0. */
    double mF;
    /**
     * Radial moment of inertia of the front wheel; by symmetry also about the vertical. `IFxx`, in kg*m^2: >= 0.
     */
    double IFxx;
    /** Axial moment of inertia of the front wheel. `IFyy`, in kg*m^2: >= 0. */
    double IFyy;
    /** Radius of the cross-section of the rear tyre. `rhoR`, in m: >= 0. */
    double rhoR;
    /** Radius of the cross-section of the front tyre. `rhoF`, in m: >= 0. */
    double rhoF;
} whipple_tyres_f64_t;

/** The parameter sets, such as `whipple_tyres_f64_sets[WHIPPLE_TYRES_SET_BENCHMARK]`. */
extern const whipple_tyres_f64_t whipple_tyres_f64_sets[WHIPPLE_TYRES_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
whipple_tyres_validity_t whipple_tyres_f64_validate(const whipple_tyres_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
    /** Damping C1, a coefficient of v q'. */
    double c1[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    double k0[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    double k2[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
} whipple_tyres_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 49 additions, 47 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 102 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void whipple_tyres_f64_matrices(const whipple_tyres_f64_t *p, whipple_tyres_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
} whipple_tyres_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t whipple_tyres_f64_at_speed(const whipple_tyres_f64_matrices_t *matrices,
    double speed, double gravity, whipple_tyres_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * WHIPPLE_TYRES_N][2U * WHIPPLE_TYRES_N];
    /** The input matrix B. */
    double b[2U * WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
} whipple_tyres_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t whipple_tyres_f64_state_space(const whipple_tyres_f64_system_t *system,
    whipple_tyres_f64_state_space_t *space);

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
    double rates[WHIPPLE_TYRES_N];
    /** The part proportional to v and each q. */
    double coordinates[WHIPPLE_TYRES_N];
    /** The part proportional to v and the yaw. */
    double heading;
} whipple_tyres_f64_rate_t;

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
double whipple_tyres_f64_rate_at(const whipple_tyres_f64_rate_t *rate, double v,
    const double q[WHIPPLE_TYRES_N], const double q_dot[WHIPPLE_TYRES_N], double psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin. */
    whipple_tyres_f64_rate_t lateral;
    /** Yaw rate, to the right, in `rad/s`: of `B`. */
    whipple_tyres_f64_rate_t yaw;
    /** Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    whipple_tyres_f64_rate_t wheel_R;
    /** Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    whipple_tyres_f64_rate_t wheel_F;
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `Tphi` (lean torque) in N*m, `Tdelta` (steer torque) in N*m.
     */
    double forces[WHIPPLE_TYRES_N][2];
} whipple_tyres_f64_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void whipple_tyres_f64_kinematics(const whipple_tyres_f64_t *p, whipple_tyres_f64_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `whipple_tyres_partials`.
 */
typedef struct {
    double values[130];
} whipple_tyres_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 114 additions, 194 multiplications, 3 divisions, 3 negations and 2 trigonometric functions: 316 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void whipple_tyres_f64_derivatives(const whipple_tyres_f64_t *p,
    whipple_tyres_f64_matrices_t *matrices, whipple_tyres_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void whipple_tyres_f64_with_respect_to(const whipple_tyres_f64_derivatives_t *derivatives,
    size_t parameter, whipple_tyres_f64_matrices_t *matrices);

/**
 * The nonlinear equations of motion with their parameters: what does not depend on the state, computed once.
 *
 * Everything is in SI units. Positions, their rates and accelerations are arrays in the order of the constants of positions,
 * speeds and their rates in that of the speeds. Positions have to be such that every wheel touches the ground; how far they
 * are from that, so far are the results. On an error what is computed is not to be used.
 */
typedef struct {
    /** In an order of their own. */
    double constants[53U];
} whipple_tyres_f64_motion_t;

/**
 * What does not depend on the state, from one straight-line program:
 * 56 additions, 62 multiplications and 2 trigonometric functions: 120 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] motion The equations.
 */
void whipple_tyres_f64_motion(const whipple_tyres_f64_t *p, whipple_tyres_f64_motion_t *motion);

/**
 * The rates of all positions at given speeds, of which rolling determines the others:
 * 47 additions, 98 multiplications, 4 divisions, 2 negations, 1 square root and 8 trigonometric functions: 160 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] rates The rates of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f64_motion_rates(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    double rates[WHIPPLE_TYRES_POSITIONS]);

/**
 * The rates of all positions and of the speeds, which is what an integration takes:
 * 349 additions, 477 multiplications, 7 divisions, 2 negations, 1 square root and 8 trigonometric functions: 844 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] rates The rates of the positions.
 * @param[out] speed_rates The rates of the speeds.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f64_motion_derivatives(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES], double rates[WHIPPLE_TYRES_POSITIONS],
    double speed_rates[WHIPPLE_TYRES_SPEEDS]);

/**
 * The second derivatives of all positions:
 * 361 additions, 491 multiplications, 7 divisions, 1 negation, 1 square root and 8 trigonometric functions: 869 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] accelerations The accelerations of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f64_motion_accelerations(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES], double accelerations[WHIPPLE_TYRES_POSITIONS]);

/**
 * The kinetic energy, and the potential energy of gravity and springs, in J:
 * 157 additions, 216 multiplications, 4 divisions, 1 negation, 1 square root and 6 trigonometric functions: 385 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] energy The kinetic energy, then the potential energy, which is zero where the centre of mass is at the
 *             height of the ground.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f64_motion_energy(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    double energy[2]);

/**
 * Moves the positions that depend on the others until every wheel touches the ground, by Newton's method with bounded
 * steps. The search begins at what is given for them, so that it finds the solution that continues a motion.
 *
 * @param[in] motion The equations.
 * @param[in,out] positions The positions; unchanged on an error.
 * @return Whether no such positions are near, the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f64_motion_close(const whipple_tyres_f64_motion_t *motion,
    double positions[WHIPPLE_TYRES_POSITIONS]);

/**
 * For each wheel the force of the ground on it in N, along the axes of the ground: x forward at the start, y to the right and
 * z down, so that the last component of a wheel that stands on the ground is negative. Of wheels that share an axle the
 * sideways force of the first is that of all. From one straight-line program:
 * 455 additions, 583 multiplications, 7 divisions, 1 negation, 1 square root and 8 trigonometric functions: 1055 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] contact_forces The forces, three numbers for each wheel, one wheel after the other.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f64_motion_contact_forces(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES], double contact_forces[3U * WHIPPLE_TYRES_WHEELS]);

/**
 * The nonlinear equations of motion to first order about a state, x' = x0' + A (x - x0) + B (f - f0), where x are all
 * positions and then all speeds.
 *
 * Derivatives are exact, and those along motions that the conditions leave: positions that the heights of the wheels determine
 * follow the others, so a column for such a position is zero.
 */
typedef struct {
    /** The derivatives of the rates of positions and speeds, a row for each, with respect to these, a column for each. */
    double a[WHIPPLE_TYRES_STATES][WHIPPLE_TYRES_STATES];
    /** The derivatives with respect to the forces, a column for each. */
    double b[WHIPPLE_TYRES_STATES][WHIPPLE_TYRES_FORCES];
} whipple_tyres_f64_linearization_t;

/**
 * A and B about a state, which need not be one of equilibrium:
 * 1769 additions, 2341 multiplications, 7 divisions, 15 negations, 1 square root and 8 trigonometric functions: 4141 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] linearization The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f64_motion_linearize(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES], whipple_tyres_f64_linearization_t *linearization);

/**
 * The derivatives of the rates of all positions and then of the speeds, a row for each, with respect to the parameters in
 * declared order, a column for each. Free positions, speeds and forces stay what they are, and dependent positions follow:
 * 2747 additions, 3528 multiplications, 7 divisions, 1 square root and 8 trigonometric functions: 6291 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] by_parameters The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f64_motion_by_parameters(const whipple_tyres_f64_motion_t *motion,
    const double positions[WHIPPLE_TYRES_POSITIONS], const double speeds[WHIPPLE_TYRES_SPEEDS],
    const double forces[WHIPPLE_TYRES_FORCES],
    double by_parameters[WHIPPLE_TYRES_STATES][WHIPPLE_TYRES_PARAMETERS]);

/* ------------------------------------------------------------ float */

/** The parameters of `WhippleTyres`. */
typedef struct {
    /** Wheel base. `w`, in m: > 0. */
    float w;
    /**
     * Trail: positive when the front contact is behind the point where the steer axis meets the ground. `c`, in m: any finite value.
     */
    float c;
    /**
     * Steer axis tilt: 90 degrees minus the head angle. `lam` λ, in rad: > -1.5707963267948966 and < 1.5707963267948966.
     */
    float lam;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    float g;
    /** Radius of the rear wheel. `rR`, in m: > 0. */
    float rR;
    /** Mass of the rear wheel. `mR`, in kg: >= 0. */
    float mR;
    /** Radial moment of inertia of the rear wheel; by symmetry also about the vertical. `IRxx`, in kg*m^2: >= 0. */
    float IRxx;
    /** Axial moment of inertia of the rear wheel. `IRyy`, in kg*m^2: >= 0. */
    float IRyy;
    /** Centre of mass of the rear frame and rider, forward of the rear contact. `xB`, in m: any finite value. */
    float xB;
    /** Centre of mass of the rear frame and rider, downward. `zB`, in m: any finite value. */
    float zB;
    /** Mass of the rear frame and rider. `mB`, in kg: >= 0. */
    float mB;
    /** Moment of inertia of the rear frame and rider about its centre of mass, in roll. `IBxx`, in kg*m^2: >= 0. */
    float IBxx;
    /**
     * Moment of inertia of the rear frame and rider about its centre of mass, in pitch. `IByy`, in kg*m^2: >= 0. No matrix depends on it.
     */
    float IByy;
    /** Moment of inertia of the rear frame and rider about its centre of mass, in yaw. `IBzz`, in kg*m^2: >= 0. */
    float IBzz;
    /**
     * Product of inertia of the rear frame and rider about its centre of mass. `IBxz`, in kg*m^2: any finite value.
     */
    float IBxz;
    /** Centre of mass of the front frame, forward of the rear contact. `xH`, in m: any finite value. */
    float xH;
    /** Centre of mass of the front frame, downward. `zH`, in m: any finite value. */
    float zH;
    /** Mass of the front frame. `mH`, in kg: >= 0. */
    float mH;
    /** Moment of inertia of the front frame about its centre of mass, in roll. `IHxx`, in kg*m^2: >= 0. */
    float IHxx;
    /**
     * Moment of inertia of the front frame about its centre of mass, in pitch. `IHyy`, in kg*m^2: >= 0. No matrix depends on it.
     */
    float IHyy;
    /** Moment of inertia of the front frame about its centre of mass, in yaw. `IHzz`, in kg*m^2: >= 0. */
    float IHzz;
    /** Product of inertia of the front frame about its centre of mass. `IHxz`, in kg*m^2: any finite value. */
    float IHxz;
    /** Radius of the front wheel. `rF`, in m: > 0. */
    float rF;
    /** Mass of the front wheel. `mF`, in kg: >= 0. */
    float mF;
    /**
     * Radial moment of inertia of the front wheel; by symmetry also about the vertical. `IFxx`, in kg*m^2: >= 0.
     */
    float IFxx;
    /** Axial moment of inertia of the front wheel. `IFyy`, in kg*m^2: >= 0. */
    float IFyy;
    /** Radius of the cross-section of the rear tyre. `rhoR`, in m: >= 0. */
    float rhoR;
    /** Radius of the cross-section of the front tyre. `rhoF`, in m: >= 0. */
    float rhoF;
} whipple_tyres_f32_t;

/** The parameter sets, such as `whipple_tyres_f32_sets[WHIPPLE_TYRES_SET_BENCHMARK]`. */
extern const whipple_tyres_f32_t whipple_tyres_f32_sets[WHIPPLE_TYRES_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
whipple_tyres_validity_t whipple_tyres_f32_validate(const whipple_tyres_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
    /** Damping C1, a coefficient of v q'. */
    float c1[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    float k0[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    float k2[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
} whipple_tyres_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 49 additions, 47 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 102 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void whipple_tyres_f32_matrices(const whipple_tyres_f32_t *p, whipple_tyres_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
} whipple_tyres_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t whipple_tyres_f32_at_speed(const whipple_tyres_f32_matrices_t *matrices,
    float speed, float gravity, whipple_tyres_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * WHIPPLE_TYRES_N][2U * WHIPPLE_TYRES_N];
    /** The input matrix B. */
    float b[2U * WHIPPLE_TYRES_N][WHIPPLE_TYRES_N];
} whipple_tyres_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t whipple_tyres_f32_state_space(const whipple_tyres_f32_system_t *system,
    whipple_tyres_f32_state_space_t *space);

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
    float rates[WHIPPLE_TYRES_N];
    /** The part proportional to v and each q. */
    float coordinates[WHIPPLE_TYRES_N];
    /** The part proportional to v and the yaw. */
    float heading;
} whipple_tyres_f32_rate_t;

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
float whipple_tyres_f32_rate_at(const whipple_tyres_f32_rate_t *rate, float v,
    const float q[WHIPPLE_TYRES_N], const float q_dot[WHIPPLE_TYRES_N], float psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin. */
    whipple_tyres_f32_rate_t lateral;
    /** Yaw rate, to the right, in `rad/s`: of `B`. */
    whipple_tyres_f32_rate_t yaw;
    /** Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    whipple_tyres_f32_rate_t wheel_R;
    /** Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    whipple_tyres_f32_rate_t wheel_F;
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `Tphi` (lean torque) in N*m, `Tdelta` (steer torque) in N*m.
     */
    float forces[WHIPPLE_TYRES_N][2];
} whipple_tyres_f32_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void whipple_tyres_f32_kinematics(const whipple_tyres_f32_t *p, whipple_tyres_f32_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `whipple_tyres_partials`.
 */
typedef struct {
    float values[130];
} whipple_tyres_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 114 additions, 194 multiplications, 3 divisions, 3 negations and 2 trigonometric functions: 316 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void whipple_tyres_f32_derivatives(const whipple_tyres_f32_t *p,
    whipple_tyres_f32_matrices_t *matrices, whipple_tyres_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void whipple_tyres_f32_with_respect_to(const whipple_tyres_f32_derivatives_t *derivatives,
    size_t parameter, whipple_tyres_f32_matrices_t *matrices);

/**
 * The nonlinear equations of motion with their parameters: what does not depend on the state, computed once.
 *
 * Everything is in SI units. Positions, their rates and accelerations are arrays in the order of the constants of positions,
 * speeds and their rates in that of the speeds. Positions have to be such that every wheel touches the ground; how far they
 * are from that, so far are the results. On an error what is computed is not to be used.
 */
typedef struct {
    /** In an order of their own. */
    float constants[53U];
} whipple_tyres_f32_motion_t;

/**
 * What does not depend on the state, from one straight-line program:
 * 56 additions, 62 multiplications and 2 trigonometric functions: 120 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] motion The equations.
 */
void whipple_tyres_f32_motion(const whipple_tyres_f32_t *p, whipple_tyres_f32_motion_t *motion);

/**
 * The rates of all positions at given speeds, of which rolling determines the others:
 * 47 additions, 98 multiplications, 4 divisions, 2 negations, 1 square root and 8 trigonometric functions: 160 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] rates The rates of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f32_motion_rates(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    float rates[WHIPPLE_TYRES_POSITIONS]);

/**
 * The rates of all positions and of the speeds, which is what an integration takes:
 * 349 additions, 477 multiplications, 7 divisions, 2 negations, 1 square root and 8 trigonometric functions: 844 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] rates The rates of the positions.
 * @param[out] speed_rates The rates of the speeds.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f32_motion_derivatives(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES], float rates[WHIPPLE_TYRES_POSITIONS],
    float speed_rates[WHIPPLE_TYRES_SPEEDS]);

/**
 * The second derivatives of all positions:
 * 361 additions, 491 multiplications, 7 divisions, 1 negation, 1 square root and 8 trigonometric functions: 869 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] accelerations The accelerations of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f32_motion_accelerations(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES], float accelerations[WHIPPLE_TYRES_POSITIONS]);

/**
 * The kinetic energy, and the potential energy of gravity and springs, in J:
 * 157 additions, 216 multiplications, 4 divisions, 1 negation, 1 square root and 6 trigonometric functions: 385 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] energy The kinetic energy, then the potential energy, which is zero where the centre of mass is at the
 *             height of the ground.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f32_motion_energy(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    float energy[2]);

/**
 * Moves the positions that depend on the others until every wheel touches the ground, by Newton's method with bounded
 * steps. The search begins at what is given for them, so that it finds the solution that continues a motion.
 *
 * @param[in] motion The equations.
 * @param[in,out] positions The positions; unchanged on an error.
 * @return Whether no such positions are near, the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f32_motion_close(const whipple_tyres_f32_motion_t *motion,
    float positions[WHIPPLE_TYRES_POSITIONS]);

/**
 * For each wheel the force of the ground on it in N, along the axes of the ground: x forward at the start, y to the right and
 * z down, so that the last component of a wheel that stands on the ground is negative. Of wheels that share an axle the
 * sideways force of the first is that of all. From one straight-line program:
 * 455 additions, 583 multiplications, 7 divisions, 1 negation, 1 square root and 8 trigonometric functions: 1055 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] contact_forces The forces, three numbers for each wheel, one wheel after the other.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f32_motion_contact_forces(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES], float contact_forces[3U * WHIPPLE_TYRES_WHEELS]);

/**
 * The nonlinear equations of motion to first order about a state, x' = x0' + A (x - x0) + B (f - f0), where x are all
 * positions and then all speeds.
 *
 * Derivatives are exact, and those along motions that the conditions leave: positions that the heights of the wheels determine
 * follow the others, so a column for such a position is zero.
 */
typedef struct {
    /** The derivatives of the rates of positions and speeds, a row for each, with respect to these, a column for each. */
    float a[WHIPPLE_TYRES_STATES][WHIPPLE_TYRES_STATES];
    /** The derivatives with respect to the forces, a column for each. */
    float b[WHIPPLE_TYRES_STATES][WHIPPLE_TYRES_FORCES];
} whipple_tyres_f32_linearization_t;

/**
 * A and B about a state, which need not be one of equilibrium:
 * 1769 additions, 2341 multiplications, 7 divisions, 15 negations, 1 square root and 8 trigonometric functions: 4141 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] linearization The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f32_motion_linearize(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES], whipple_tyres_f32_linearization_t *linearization);

/**
 * The derivatives of the rates of all positions and then of the speeds, a row for each, with respect to the parameters in
 * declared order, a column for each. Free positions, speeds and forces stay what they are, and dependent positions follow:
 * 2747 additions, 3528 multiplications, 7 divisions, 1 square root and 8 trigonometric functions: 6291 operations.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[in] forces The applied forces, each positive as the position that it acts on.
 * @param[out] by_parameters The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t whipple_tyres_f32_motion_by_parameters(const whipple_tyres_f32_motion_t *motion,
    const float positions[WHIPPLE_TYRES_POSITIONS], const float speeds[WHIPPLE_TYRES_SPEEDS],
    const float forces[WHIPPLE_TYRES_FORCES],
    float by_parameters[WHIPPLE_TYRES_STATES][WHIPPLE_TYRES_PARAMETERS]);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_WHIPPLE_TYRES_H */
