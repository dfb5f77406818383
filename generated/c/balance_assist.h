/* @generated from generated/models/balance_assist.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: a9fd1c383f4b46f9
 */

/**
 * @file balance_assist.h
 * @brief The model `BalanceAssist`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * A bicycle with a motor that steers into the fall, so that it stays up at lower speeds.
 *
 * The Whipple-Carvallo bicycle with a torque on its steer that follows from the lean rate and fades with the speed,
 * `kappa*(vo - v)` times the lean rate: up to the speed `vo`, beyond which such a motor is switched off and the bicycle is
 * [`Whipple`](crate::Whipple). Axes: origin at the rear contact point, x forward, y to the right, z down.
 *
 * The declaration asserts that the matrices are those of Appendix A of the paper, less the torque in C0 and C1.
 *
 * Source: Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3; torque: BicycleParameters, example plot_balanceassistv1.py
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

#ifndef CARVALLO_MODEL_BALANCE_ASSIST_H
#define CARVALLO_MODEL_BALANCE_ASSIST_H

#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define BALANCE_ASSIST_N 2U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `benchmark`.
     *
     * Source: Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; motor: an example of BicycleParameters, plot_balanceassistv1.py
     */
    BALANCE_ASSIST_SET_BENCHMARK = 0,
    /**
     * The parameter set `balanceassistv1`.
     *
     * Source: BicycleParameters 1.5.2 (BSD), Balanceassistv1Benchmark.txt, an electric bicycle without a rider; motor: an example of BicycleParameters, plot_balanceassistv1.py
     */
    BALANCE_ASSIST_SET_BALANCEASSISTV1 = 1
} balance_assist_set_t;

/** How many parameter sets there are. */
#define BALANCE_ASSIST_SETS 2U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *balance_assist_set_name(balance_assist_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    BALANCE_ASSIST_VALID = 0,
    /** `w` in m must be finite and > 0. */
    BALANCE_ASSIST_INVALID_w = 1,
    /** `c` in m must be finite. */
    BALANCE_ASSIST_INVALID_c = 2,
    /** `lam` in rad must be finite and > -1.5707963267948966 and < 1.5707963267948966. */
    BALANCE_ASSIST_INVALID_lam = 3,
    /** `g` in N/kg must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_g = 4,
    /** `rR` in m must be finite and > 0. */
    BALANCE_ASSIST_INVALID_rR = 5,
    /** `mR` in kg must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_mR = 6,
    /** `IRxx` in kg*m^2 must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_IRxx = 7,
    /** `IRyy` in kg*m^2 must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_IRyy = 8,
    /** `xB` in m must be finite. */
    BALANCE_ASSIST_INVALID_xB = 9,
    /** `zB` in m must be finite. */
    BALANCE_ASSIST_INVALID_zB = 10,
    /** `mB` in kg must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_mB = 11,
    /** `IBxx` in kg*m^2 must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_IBxx = 12,
    /** `IByy` in kg*m^2 must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_IByy = 13,
    /** `IBzz` in kg*m^2 must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_IBzz = 14,
    /** `IBxz` in kg*m^2 must be finite. */
    BALANCE_ASSIST_INVALID_IBxz = 15,
    /** `xH` in m must be finite. */
    BALANCE_ASSIST_INVALID_xH = 16,
    /** `zH` in m must be finite. */
    BALANCE_ASSIST_INVALID_zH = 17,
    /** `mH` in kg must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_mH = 18,
    /** `IHxx` in kg*m^2 must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_IHxx = 19,
    /** `IHyy` in kg*m^2 must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_IHyy = 20,
    /** `IHzz` in kg*m^2 must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_IHzz = 21,
    /** `IHxz` in kg*m^2 must be finite. */
    BALANCE_ASSIST_INVALID_IHxz = 22,
    /** `rF` in m must be finite and > 0. */
    BALANCE_ASSIST_INVALID_rF = 23,
    /** `mF` in kg must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_mF = 24,
    /** `IFxx` in kg*m^2 must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_IFxx = 25,
    /** `IFyy` in kg*m^2 must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_IFyy = 26,
    /** `kappa` in N*s^2 must be finite and >= 0. */
    BALANCE_ASSIST_INVALID_kappa = 27,
    /** `vo` in m/s must be finite and > 0. */
    BALANCE_ASSIST_INVALID_vo = 28
} balance_assist_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *balance_assist_validity_text(balance_assist_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define BALANCE_ASSIST_PARTIALS 161U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t balance_assist_partials[BALANCE_ASSIST_PARTIALS];

/* ------------------------------------------------------------ double */

/** The parameters of `BalanceAssist`. */
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
    /** Steer torque by lean rate, for each m/s that the bicycle is slower than `vo`. `kappa` κ, in N*s^2: >= 0. */
    double kappa;
    /** The speed from which the motor leaves the bicycle alone. `vo`, in m/s: > 0. */
    double vo;
} balance_assist_f64_t;

/** The parameter sets, such as `balance_assist_f64_sets[BALANCE_ASSIST_SET_BENCHMARK]`. */
extern const balance_assist_f64_t balance_assist_f64_sets[BALANCE_ASSIST_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
balance_assist_validity_t balance_assist_f64_validate(const balance_assist_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
    /** Damping C0, a coefficient of q'. */
    double c0[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
    /** Damping C1, a coefficient of v q'. */
    double c1[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    double k0[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    double k2[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
} balance_assist_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 48 additions, 45 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 100 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void balance_assist_f64_matrices(const balance_assist_f64_t *p, balance_assist_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
} balance_assist_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t balance_assist_f64_at_speed(const balance_assist_f64_matrices_t *matrices,
    double speed, double gravity, balance_assist_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * BALANCE_ASSIST_N][2U * BALANCE_ASSIST_N];
    /** The input matrix B. */
    double b[2U * BALANCE_ASSIST_N][BALANCE_ASSIST_N];
} balance_assist_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t balance_assist_f64_state_space(const balance_assist_f64_system_t *system,
    balance_assist_f64_state_space_t *space);

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
    double rates[BALANCE_ASSIST_N];
    /** The part proportional to v and each q. */
    double coordinates[BALANCE_ASSIST_N];
    /** The part proportional to v and the yaw. */
    double heading;
} balance_assist_f64_rate_t;

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
double balance_assist_f64_rate_at(const balance_assist_f64_rate_t *rate, double v,
    const double q[BALANCE_ASSIST_N], const double q_dot[BALANCE_ASSIST_N], double psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin. */
    balance_assist_f64_rate_t lateral;
    /** Yaw rate, to the right, in `rad/s`: of `B`. */
    balance_assist_f64_rate_t yaw;
    /** Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    balance_assist_f64_rate_t wheel_R;
    /** Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    balance_assist_f64_rate_t wheel_F;
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `Tphi` (lean torque) in N*m, `Tdelta` (steer torque) in N*m.
     */
    double forces[BALANCE_ASSIST_N][2];
} balance_assist_f64_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void balance_assist_f64_kinematics(const balance_assist_f64_t *p, balance_assist_f64_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `balance_assist_partials`.
 */
typedef struct {
    double values[125];
} balance_assist_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 114 additions, 190 multiplications, 3 divisions, 4 negations and 2 trigonometric functions: 313 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void balance_assist_f64_derivatives(const balance_assist_f64_t *p,
    balance_assist_f64_matrices_t *matrices, balance_assist_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void balance_assist_f64_with_respect_to(const balance_assist_f64_derivatives_t *derivatives,
    size_t parameter, balance_assist_f64_matrices_t *matrices);

/* ------------------------------------------------------------ float */

/** The parameters of `BalanceAssist`. */
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
    /** Steer torque by lean rate, for each m/s that the bicycle is slower than `vo`. `kappa` κ, in N*s^2: >= 0. */
    float kappa;
    /** The speed from which the motor leaves the bicycle alone. `vo`, in m/s: > 0. */
    float vo;
} balance_assist_f32_t;

/** The parameter sets, such as `balance_assist_f32_sets[BALANCE_ASSIST_SET_BENCHMARK]`. */
extern const balance_assist_f32_t balance_assist_f32_sets[BALANCE_ASSIST_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
balance_assist_validity_t balance_assist_f32_validate(const balance_assist_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
    /** Damping C0, a coefficient of q'. */
    float c0[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
    /** Damping C1, a coefficient of v q'. */
    float c1[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    float k0[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    float k2[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
} balance_assist_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 48 additions, 45 multiplications, 3 divisions, 2 negations and 2 trigonometric functions: 100 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void balance_assist_f32_matrices(const balance_assist_f32_t *p, balance_assist_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[BALANCE_ASSIST_N][BALANCE_ASSIST_N];
} balance_assist_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t balance_assist_f32_at_speed(const balance_assist_f32_matrices_t *matrices,
    float speed, float gravity, balance_assist_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * BALANCE_ASSIST_N][2U * BALANCE_ASSIST_N];
    /** The input matrix B. */
    float b[2U * BALANCE_ASSIST_N][BALANCE_ASSIST_N];
} balance_assist_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t balance_assist_f32_state_space(const balance_assist_f32_system_t *system,
    balance_assist_f32_state_space_t *space);

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
    float rates[BALANCE_ASSIST_N];
    /** The part proportional to v and each q. */
    float coordinates[BALANCE_ASSIST_N];
    /** The part proportional to v and the yaw. */
    float heading;
} balance_assist_f32_rate_t;

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
float balance_assist_f32_rate_at(const balance_assist_f32_rate_t *rate, float v,
    const float q[BALANCE_ASSIST_N], const float q_dot[BALANCE_ASSIST_N], float psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin. */
    balance_assist_f32_rate_t lateral;
    /** Yaw rate, to the right, in `rad/s`: of `B`. */
    balance_assist_f32_rate_t yaw;
    /** Spin of the wheel `R`, rear wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    balance_assist_f32_rate_t wheel_R;
    /** Spin of the wheel `F`, front wheel: about the y axis, so negative in forward motion, in `rad/s`. */
    balance_assist_f32_rate_t wheel_F;
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `Tphi` (lean torque) in N*m, `Tdelta` (steer torque) in N*m.
     */
    float forces[BALANCE_ASSIST_N][2];
} balance_assist_f32_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 multiplication, 3 divisions, 2 negations and 1 trigonometric function: 7 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void balance_assist_f32_kinematics(const balance_assist_f32_t *p, balance_assist_f32_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `balance_assist_partials`.
 */
typedef struct {
    float values[125];
} balance_assist_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 114 additions, 190 multiplications, 3 divisions, 4 negations and 2 trigonometric functions: 313 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void balance_assist_f32_derivatives(const balance_assist_f32_t *p,
    balance_assist_f32_matrices_t *matrices, balance_assist_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void balance_assist_f32_with_respect_to(const balance_assist_f32_derivatives_t *derivatives,
    size_t parameter, balance_assist_f32_matrices_t *matrices);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_BALANCE_ASSIST_H */
