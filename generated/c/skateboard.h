/* @generated from generated/models/skateboard.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 0f4f8539b65fdea9
 */

/**
 * @file skateboard.h
 * @brief The model `Skateboard`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * A skateboard with a rider who stands still on it: one degree of freedom, the tilt of the board.
 *
 * Each truck turns about its king pin, which passes through the middle of its axle, with a wheel at either end. All
 * four wheels stay on the ground and do not slip, so that tilting steers both axles. Trucks and wheels have no mass;
 * board and rider are one rigid body. Axes: origin on the ground below the rear axle, x forward, y to the right, z
 * down.
 *
 * Source: Mechanism: Hubbard (1979), J. Appl. Mech. 46, 931-936; Kremnev & Kuleshov (2010), DCDS-S 3, 85-103
 *
 * Derived from a mechanism: body `B` (board and rider), body `TF` (front truck), body `TR` (rear truck), wheel `FL` (front left), wheel `FR` (front right), wheel `RL` (rear left), wheel `RR` (rear right).
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `gamma` (tilt) in rad: Tilt of the board, to the right.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_SKATEBOARD_H
#define CARVALLO_MODEL_SKATEBOARD_H

#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define SKATEBOARD_N 1U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `example`.
     *
     * Source: An adult on a board; the figures are an example
     */
    SKATEBOARD_SET_EXAMPLE = 0
} skateboard_set_t;

/** How many parameter sets there are. */
#define SKATEBOARD_SETS 1U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *skateboard_set_name(skateboard_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    SKATEBOARD_VALID = 0,
    /** `L` in m must be finite and > 0. */
    SKATEBOARD_INVALID_L = 1,
    /** `b` in m must be finite and > 0. */
    SKATEBOARD_INVALID_b = 2,
    /** `r` in m must be finite and > 0. */
    SKATEBOARD_INVALID_r = 3,
    /** `lamF` in rad must be finite and > 0 and < 1.5707963267948966. */
    SKATEBOARD_INVALID_lamF = 4,
    /** `lamR` in rad must be finite and > 0 and < 1.5707963267948966. */
    SKATEBOARD_INVALID_lamR = 5,
    /** `kF` in N*m must be finite and >= 0. */
    SKATEBOARD_INVALID_kF = 6,
    /** `kR` in N*m must be finite and >= 0. */
    SKATEBOARD_INVALID_kR = 7,
    /** `m` in kg must be finite and > 0. */
    SKATEBOARD_INVALID_m = 8,
    /** `x` in m must be finite. */
    SKATEBOARD_INVALID_x = 9,
    /** `h` in m must be finite. */
    SKATEBOARD_INVALID_h = 10,
    /** `Ixx` in kg*m^2 must be finite and >= 0. */
    SKATEBOARD_INVALID_Ixx = 11,
    /** `Iyy` in kg*m^2 must be finite and >= 0. */
    SKATEBOARD_INVALID_Iyy = 12,
    /** `Izz` in kg*m^2 must be finite and >= 0. */
    SKATEBOARD_INVALID_Izz = 13,
    /** `Ixz` in kg*m^2 must be finite. */
    SKATEBOARD_INVALID_Ixz = 14,
    /** `g` in N/kg must be finite and >= 0. */
    SKATEBOARD_INVALID_g = 15
} skateboard_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *skateboard_validity_text(skateboard_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define SKATEBOARD_PARTIALS 21U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t skateboard_partials[SKATEBOARD_PARTIALS];

/* ------------------------------------------------------------ double */

/** The parameters of `Skateboard`. */
typedef struct {
    /** Wheel base, from axle to axle. `L`, in m: > 0. */
    double L;
    /** Half of the track, from the middle of an axle to a wheel. `b`, in m: > 0. */
    double b;
    /** Radius of the wheels. `r`, in m: > 0. */
    double r;
    /**
     * Angle of the front king pin above the horizontal, rising forward. `lamF` λF, in rad: > 0 and < 1.5707963267948966.
     */
    double lamF;
    /**
     * Angle of the rear king pin above the horizontal, rising backward. `lamR` λR, in rad: > 0 and < 1.5707963267948966.
     */
    double lamR;
    /** Stiffness of the front truck about its king pin. `kF`, in N*m: >= 0. */
    double kF;
    /** Stiffness of the rear truck about its king pin. `kR`, in N*m: >= 0. */
    double kR;
    /** Mass of board and rider. `m`, in kg: > 0. */
    double m;
    /** Centre of mass, forward of the rear axle. `x`, in m: any finite value. */
    double x;
    /** Centre of mass, above the axles. `h`, in m: any finite value. */
    double h;
    /** Moment of inertia of board and rider about their centre of mass, in roll. `Ixx`, in kg*m^2: >= 0. */
    double Ixx;
    /**
     * Moment of inertia of board and rider about their centre of mass, in pitch. `Iyy`, in kg*m^2: >= 0. No matrix depends on it.
     */
    double Iyy;
    /**
     * Moment of inertia of board and rider about their centre of mass, in yaw. `Izz`, in kg*m^2: >= 0. No matrix depends on it.
     */
    double Izz;
    /** Product of inertia of board and rider about their centre of mass. `Ixz`, in kg*m^2: any finite value. */
    double Ixz;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    double g;
} skateboard_f64_t;

/** The parameter sets, such as `skateboard_f64_sets[SKATEBOARD_SET_EXAMPLE]`. */
extern const skateboard_f64_t skateboard_f64_sets[SKATEBOARD_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
skateboard_validity_t skateboard_f64_validate(const skateboard_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. */
    double m[SKATEBOARD_N][SKATEBOARD_N];
    /** Damping C1, a coefficient of v q'. */
    double c1[SKATEBOARD_N][SKATEBOARD_N];
    /** Stiffness Kc, a coefficient of q. */
    double kc[SKATEBOARD_N][SKATEBOARD_N];
    /** Stiffness K0, a coefficient of g q. */
    double k0[SKATEBOARD_N][SKATEBOARD_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    double k2[SKATEBOARD_N][SKATEBOARD_N];
} skateboard_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 5 additions, 14 multiplications, 3 divisions, 1 negation and 4 trigonometric functions: 27 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void skateboard_f64_matrices(const skateboard_f64_t *p, skateboard_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[SKATEBOARD_N][SKATEBOARD_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[SKATEBOARD_N][SKATEBOARD_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[SKATEBOARD_N][SKATEBOARD_N];
} skateboard_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t skateboard_f64_at_speed(const skateboard_f64_matrices_t *matrices,
    double speed, double gravity, skateboard_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * SKATEBOARD_N][2U * SKATEBOARD_N];
    /** The input matrix B. */
    double b[2U * SKATEBOARD_N][SKATEBOARD_N];
} skateboard_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t skateboard_f64_state_space(const skateboard_f64_system_t *system,
    skateboard_f64_state_space_t *space);

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
    double rates[SKATEBOARD_N];
    /** The part proportional to v and each q. */
    double coordinates[SKATEBOARD_N];
    /** The part proportional to v and the yaw. */
    double heading;
} skateboard_f64_rate_t;

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
double skateboard_f64_rate_at(const skateboard_f64_rate_t *rate, double v,
    const double q[SKATEBOARD_N], const double q_dot[SKATEBOARD_N], double psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin. */
    skateboard_f64_rate_t lateral;
    /** Yaw rate, to the right, in `rad/s`: of `B`. */
    skateboard_f64_rate_t yaw;
    /** Rate of `deltaF`, in `rad/s`. */
    skateboard_f64_rate_t deltaF;
    /** Rate of `deltaR`, in `rad/s`. */
    skateboard_f64_rate_t deltaR;
    /** Spin of the wheel `FL`, front left: about the y axis, so negative in forward motion, in `rad/s`. */
    skateboard_f64_rate_t wheel_FL;
    /** Spin of the wheel `FR`, front right: about the y axis, so negative in forward motion, in `rad/s`. */
    skateboard_f64_rate_t wheel_FR;
    /** Spin of the wheel `RL`, rear left: about the y axis, so negative in forward motion, in `rad/s`. */
    skateboard_f64_rate_t wheel_RL;
    /** Spin of the wheel `RR`, rear right: about the y axis, so negative in forward motion, in `rad/s`. */
    skateboard_f64_rate_t wheel_RR;
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `T` (tilt torque) in N*m.
     */
    double forces[SKATEBOARD_N][1];
} skateboard_f64_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 addition, 6 multiplications, 4 divisions, 8 negations and 4 trigonometric functions: 23 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void skateboard_f64_kinematics(const skateboard_f64_t *p, skateboard_f64_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `skateboard_partials`.
 */
typedef struct {
    double values[21];
} skateboard_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 12 additions, 32 multiplications, 3 divisions, 1 negation and 4 trigonometric functions: 52 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void skateboard_f64_derivatives(const skateboard_f64_t *p, skateboard_f64_matrices_t *matrices,
    skateboard_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void skateboard_f64_with_respect_to(const skateboard_f64_derivatives_t *derivatives,
    size_t parameter, skateboard_f64_matrices_t *matrices);

/* ------------------------------------------------------------ float */

/** The parameters of `Skateboard`. */
typedef struct {
    /** Wheel base, from axle to axle. `L`, in m: > 0. */
    float L;
    /** Half of the track, from the middle of an axle to a wheel. `b`, in m: > 0. */
    float b;
    /** Radius of the wheels. `r`, in m: > 0. */
    float r;
    /**
     * Angle of the front king pin above the horizontal, rising forward. `lamF` λF, in rad: > 0 and < 1.5707963267948966.
     */
    float lamF;
    /**
     * Angle of the rear king pin above the horizontal, rising backward. `lamR` λR, in rad: > 0 and < 1.5707963267948966.
     */
    float lamR;
    /** Stiffness of the front truck about its king pin. `kF`, in N*m: >= 0. */
    float kF;
    /** Stiffness of the rear truck about its king pin. `kR`, in N*m: >= 0. */
    float kR;
    /** Mass of board and rider. `m`, in kg: > 0. */
    float m;
    /** Centre of mass, forward of the rear axle. `x`, in m: any finite value. */
    float x;
    /** Centre of mass, above the axles. `h`, in m: any finite value. */
    float h;
    /** Moment of inertia of board and rider about their centre of mass, in roll. `Ixx`, in kg*m^2: >= 0. */
    float Ixx;
    /**
     * Moment of inertia of board and rider about their centre of mass, in pitch. `Iyy`, in kg*m^2: >= 0. No matrix depends on it.
     */
    float Iyy;
    /**
     * Moment of inertia of board and rider about their centre of mass, in yaw. `Izz`, in kg*m^2: >= 0. No matrix depends on it.
     */
    float Izz;
    /** Product of inertia of board and rider about their centre of mass. `Ixz`, in kg*m^2: any finite value. */
    float Ixz;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    float g;
} skateboard_f32_t;

/** The parameter sets, such as `skateboard_f32_sets[SKATEBOARD_SET_EXAMPLE]`. */
extern const skateboard_f32_t skateboard_f32_sets[SKATEBOARD_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
skateboard_validity_t skateboard_f32_validate(const skateboard_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. */
    float m[SKATEBOARD_N][SKATEBOARD_N];
    /** Damping C1, a coefficient of v q'. */
    float c1[SKATEBOARD_N][SKATEBOARD_N];
    /** Stiffness Kc, a coefficient of q. */
    float kc[SKATEBOARD_N][SKATEBOARD_N];
    /** Stiffness K0, a coefficient of g q. */
    float k0[SKATEBOARD_N][SKATEBOARD_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    float k2[SKATEBOARD_N][SKATEBOARD_N];
} skateboard_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 5 additions, 14 multiplications, 3 divisions, 1 negation and 4 trigonometric functions: 27 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void skateboard_f32_matrices(const skateboard_f32_t *p, skateboard_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[SKATEBOARD_N][SKATEBOARD_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[SKATEBOARD_N][SKATEBOARD_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[SKATEBOARD_N][SKATEBOARD_N];
} skateboard_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t skateboard_f32_at_speed(const skateboard_f32_matrices_t *matrices,
    float speed, float gravity, skateboard_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * SKATEBOARD_N][2U * SKATEBOARD_N];
    /** The input matrix B. */
    float b[2U * SKATEBOARD_N][SKATEBOARD_N];
} skateboard_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t skateboard_f32_state_space(const skateboard_f32_system_t *system,
    skateboard_f32_state_space_t *space);

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
    float rates[SKATEBOARD_N];
    /** The part proportional to v and each q. */
    float coordinates[SKATEBOARD_N];
    /** The part proportional to v and the yaw. */
    float heading;
} skateboard_f32_rate_t;

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
float skateboard_f32_rate_at(const skateboard_f32_rate_t *rate, float v,
    const float q[SKATEBOARD_N], const float q_dot[SKATEBOARD_N], float psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Lateral velocity, to the right, in `m/s`: of the point of `B` that is at the origin. */
    skateboard_f32_rate_t lateral;
    /** Yaw rate, to the right, in `rad/s`: of `B`. */
    skateboard_f32_rate_t yaw;
    /** Rate of `deltaF`, in `rad/s`. */
    skateboard_f32_rate_t deltaF;
    /** Rate of `deltaR`, in `rad/s`. */
    skateboard_f32_rate_t deltaR;
    /** Spin of the wheel `FL`, front left: about the y axis, so negative in forward motion, in `rad/s`. */
    skateboard_f32_rate_t wheel_FL;
    /** Spin of the wheel `FR`, front right: about the y axis, so negative in forward motion, in `rad/s`. */
    skateboard_f32_rate_t wheel_FR;
    /** Spin of the wheel `RL`, rear left: about the y axis, so negative in forward motion, in `rad/s`. */
    skateboard_f32_rate_t wheel_RL;
    /** Spin of the wheel `RR`, rear right: about the y axis, so negative in forward motion, in `rad/s`. */
    skateboard_f32_rate_t wheel_RR;
    /**
     * The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of
     * `T` (tilt torque) in N*m.
     */
    float forces[SKATEBOARD_N][1];
} skateboard_f32_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 addition, 6 multiplications, 4 divisions, 8 negations and 4 trigonometric functions: 23 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void skateboard_f32_kinematics(const skateboard_f32_t *p, skateboard_f32_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `skateboard_partials`.
 */
typedef struct {
    float values[21];
} skateboard_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 12 additions, 32 multiplications, 3 divisions, 1 negation and 4 trigonometric functions: 52 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void skateboard_f32_derivatives(const skateboard_f32_t *p, skateboard_f32_matrices_t *matrices,
    skateboard_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void skateboard_f32_with_respect_to(const skateboard_f32_derivatives_t *derivatives,
    size_t parameter, skateboard_f32_matrices_t *matrices);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_SKATEBOARD_H */
