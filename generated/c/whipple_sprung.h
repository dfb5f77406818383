/* @generated from generated/models/whipple_sprung.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 578b2dd2541ebae4
 */

/**
 * @file whipple_sprung.h
 * @brief The model `WhippleSprung`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * The Whipple-Carvallo bicycle with a spring and a damper between rear frame and front frame.
 *
 * Four rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally
 * symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,
 * x forward, y to the right, z down, so that a centre of mass above the ground has z < 0.
 *
 * Source: Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3
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

#ifndef CARVALLO_MODEL_WHIPPLE_SPRUNG_H
#define CARVALLO_MODEL_WHIPPLE_SPRUNG_H

#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define WHIPPLE_SPRUNG_N 2U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `benchmark`.
     *
     * Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; spring and damper are examples
     */
    WHIPPLE_SPRUNG_SET_BENCHMARK = 0,
    /**
     * The parameter set `benchmark_2005`.
     *
     * Source: Schwab, Meijaard & Papadopoulos (2005), ENOC 2005; spring and damper are examples
     */
    WHIPPLE_SPRUNG_SET_BENCHMARK_2005 = 1
} whipple_sprung_set_t;

/** How many parameter sets there are. */
#define WHIPPLE_SPRUNG_SETS 2U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *whipple_sprung_set_name(whipple_sprung_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    WHIPPLE_SPRUNG_VALID = 0,
    /** `w` in m must be finite and > 0. */
    WHIPPLE_SPRUNG_INVALID_w = 1,
    /** `c` in m must be finite. */
    WHIPPLE_SPRUNG_INVALID_c = 2,
    /** `lam` in rad must be finite and > -1.5707963267948966 and < 1.5707963267948966. */
    WHIPPLE_SPRUNG_INVALID_lam = 3,
    /** `g` in N/kg must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_g = 4,
    /** `rR` in m must be finite and > 0. */
    WHIPPLE_SPRUNG_INVALID_rR = 5,
    /** `mR` in kg must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_mR = 6,
    /** `IRxx` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_IRxx = 7,
    /** `IRyy` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_IRyy = 8,
    /** `xB` in m must be finite. */
    WHIPPLE_SPRUNG_INVALID_xB = 9,
    /** `zB` in m must be finite. */
    WHIPPLE_SPRUNG_INVALID_zB = 10,
    /** `mB` in kg must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_mB = 11,
    /** `IBxx` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_IBxx = 12,
    /** `IByy` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_IByy = 13,
    /** `IBzz` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_IBzz = 14,
    /** `IBxz` in kg*m^2 must be finite. */
    WHIPPLE_SPRUNG_INVALID_IBxz = 15,
    /** `xH` in m must be finite. */
    WHIPPLE_SPRUNG_INVALID_xH = 16,
    /** `zH` in m must be finite. */
    WHIPPLE_SPRUNG_INVALID_zH = 17,
    /** `mH` in kg must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_mH = 18,
    /** `IHxx` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_IHxx = 19,
    /** `IHyy` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_IHyy = 20,
    /** `IHzz` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_IHzz = 21,
    /** `IHxz` in kg*m^2 must be finite. */
    WHIPPLE_SPRUNG_INVALID_IHxz = 22,
    /** `rF` in m must be finite and > 0. */
    WHIPPLE_SPRUNG_INVALID_rF = 23,
    /** `mF` in kg must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_mF = 24,
    /** `IFxx` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_IFxx = 25,
    /** `IFyy` in kg*m^2 must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_IFyy = 26,
    /** `k` in N*m must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_k = 27,
    /** `d` in N*m*s must be finite and >= 0. */
    WHIPPLE_SPRUNG_INVALID_d = 28
} whipple_sprung_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *whipple_sprung_validity_text(whipple_sprung_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define WHIPPLE_SPRUNG_PARTIALS 160U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t whipple_sprung_partials[WHIPPLE_SPRUNG_PARTIALS];

/* ------------------------------------------------------------ double */

/** The parameters of `WhippleSprung`. */
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
    /** Stiffness of the steering spring. `k`, in N*m: >= 0. */
    double k;
    /** Damping of the steering damper. `d`, in N*m*s: >= 0. */
    double d;
} whipple_sprung_f64_t;

/** The parameter sets, such as `whipple_sprung_f64_sets[WHIPPLE_SPRUNG_SET_BENCHMARK]`. */
extern const whipple_sprung_f64_t whipple_sprung_f64_sets[WHIPPLE_SPRUNG_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
whipple_sprung_validity_t whipple_sprung_f64_validate(const whipple_sprung_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Damping C0, a coefficient of q'. Symmetric, proved. */
    double c0[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Damping C1, a coefficient of v q'. */
    double c1[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Stiffness Kc, a coefficient of q. Symmetric, proved. */
    double kc[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    double k0[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    double k2[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
} whipple_sprung_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 40 additions, 43 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 89 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void whipple_sprung_f64_matrices(const whipple_sprung_f64_t *p, whipple_sprung_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
} whipple_sprung_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t whipple_sprung_f64_at_speed(const whipple_sprung_f64_matrices_t *matrices,
    double speed, double gravity, whipple_sprung_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * WHIPPLE_SPRUNG_N][2U * WHIPPLE_SPRUNG_N];
    /** The input matrix B. */
    double b[2U * WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
} whipple_sprung_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t whipple_sprung_f64_state_space(const whipple_sprung_f64_system_t *system,
    whipple_sprung_f64_state_space_t *space);

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
    double rates[WHIPPLE_SPRUNG_N];
    /** The part proportional to v and each q. */
    double coordinates[WHIPPLE_SPRUNG_N];
    /** The part proportional to v and the yaw. */
    double heading;
} whipple_sprung_f64_rate_t;

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
double whipple_sprung_f64_rate_at(const whipple_sprung_f64_rate_t *rate, double v,
    const double q[WHIPPLE_SPRUNG_N], const double q_dot[WHIPPLE_SPRUNG_N], double psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin. */
    whipple_sprung_f64_rate_t lateral;
    /** Yaw rate, to the right, in `rad/s`: of `B`. */
    whipple_sprung_f64_rate_t yaw;
    /** Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    whipple_sprung_f64_rate_t wheel_R;
    /** Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    whipple_sprung_f64_rate_t wheel_F;
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `Tphi` (lean torque) in N*m, `Tdelta` (steer torque) in N*m.
     */
    double forces[WHIPPLE_SPRUNG_N][2];
} whipple_sprung_f64_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void whipple_sprung_f64_kinematics(const whipple_sprung_f64_t *p, whipple_sprung_f64_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `whipple_sprung_partials`.
 */
typedef struct {
    double values[123];
} whipple_sprung_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 93 additions, 179 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 278 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void whipple_sprung_f64_derivatives(const whipple_sprung_f64_t *p,
    whipple_sprung_f64_matrices_t *matrices, whipple_sprung_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void whipple_sprung_f64_with_respect_to(const whipple_sprung_f64_derivatives_t *derivatives,
    size_t parameter, whipple_sprung_f64_matrices_t *matrices);

/* ------------------------------------------------------------ float */

/** The parameters of `WhippleSprung`. */
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
    /** Stiffness of the steering spring. `k`, in N*m: >= 0. */
    float k;
    /** Damping of the steering damper. `d`, in N*m*s: >= 0. */
    float d;
} whipple_sprung_f32_t;

/** The parameter sets, such as `whipple_sprung_f32_sets[WHIPPLE_SPRUNG_SET_BENCHMARK]`. */
extern const whipple_sprung_f32_t whipple_sprung_f32_sets[WHIPPLE_SPRUNG_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
whipple_sprung_validity_t whipple_sprung_f32_validate(const whipple_sprung_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Damping C0, a coefficient of q'. Symmetric, proved. */
    float c0[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Damping C1, a coefficient of v q'. */
    float c1[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Stiffness Kc, a coefficient of q. Symmetric, proved. */
    float kc[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    float k0[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    float k2[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
} whipple_sprung_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 40 additions, 43 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 89 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void whipple_sprung_f32_matrices(const whipple_sprung_f32_t *p, whipple_sprung_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
} whipple_sprung_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t whipple_sprung_f32_at_speed(const whipple_sprung_f32_matrices_t *matrices,
    float speed, float gravity, whipple_sprung_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * WHIPPLE_SPRUNG_N][2U * WHIPPLE_SPRUNG_N];
    /** The input matrix B. */
    float b[2U * WHIPPLE_SPRUNG_N][WHIPPLE_SPRUNG_N];
} whipple_sprung_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t whipple_sprung_f32_state_space(const whipple_sprung_f32_system_t *system,
    whipple_sprung_f32_state_space_t *space);

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
    float rates[WHIPPLE_SPRUNG_N];
    /** The part proportional to v and each q. */
    float coordinates[WHIPPLE_SPRUNG_N];
    /** The part proportional to v and the yaw. */
    float heading;
} whipple_sprung_f32_rate_t;

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
float whipple_sprung_f32_rate_at(const whipple_sprung_f32_rate_t *rate, float v,
    const float q[WHIPPLE_SPRUNG_N], const float q_dot[WHIPPLE_SPRUNG_N], float psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin. */
    whipple_sprung_f32_rate_t lateral;
    /** Yaw rate, to the right, in `rad/s`: of `B`. */
    whipple_sprung_f32_rate_t yaw;
    /** Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    whipple_sprung_f32_rate_t wheel_R;
    /** Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    whipple_sprung_f32_rate_t wheel_F;
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `Tphi` (lean torque) in N*m, `Tdelta` (steer torque) in N*m.
     */
    float forces[WHIPPLE_SPRUNG_N][2];
} whipple_sprung_f32_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void whipple_sprung_f32_kinematics(const whipple_sprung_f32_t *p, whipple_sprung_f32_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `whipple_sprung_partials`.
 */
typedef struct {
    float values[123];
} whipple_sprung_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 93 additions, 179 multiplications, 3 divisions, 1 negation and 2 trigonometric functions: 278 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void whipple_sprung_f32_derivatives(const whipple_sprung_f32_t *p,
    whipple_sprung_f32_matrices_t *matrices, whipple_sprung_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void whipple_sprung_f32_with_respect_to(const whipple_sprung_f32_derivatives_t *derivatives,
    size_t parameter, whipple_sprung_f32_matrices_t *matrices);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_WHIPPLE_SPRUNG_H */
