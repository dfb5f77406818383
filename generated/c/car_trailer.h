/* @generated from generated/models/car_trailer.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 1a935d722786e794
 */

/**
 * @file car_trailer.h
 * @brief The model `CarTrailer`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * A car with a trailer, which snakes above a critical speed.
 *
 * Car and trailer are one rigid body each, joined by a ball at which only yaw takes part, on tyres whose side forces are
 * linear in slip. What two front wheels do is in one, and so it is for the trailer; its load on the ball is that of its
 * centre of mass. Axes: origin on the ground below the centre of mass of the car, x forward, y to the right, z down.
 *
 * Source: Mechanism of the single-track car with a trailer, as in Hac, Fulk & Chen (2008), SAE 2008-01-1228
 *
 * Derived from a mechanism: body `B` (car), body `P` (ball), body `T` (trailer), wheel `F` (front axle), wheel `L` (rear left), wheel `R` (rear right), wheel `U` (axle of the trailer).
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `y` (lateral) in m; only its rate is a state: Lateral motion of the car, positive to the right: its rate is the velocity along the axes of the car.
 * - `psi` (yaw) in rad; only its rate is a state: Yaw of the car, positive to the right.
 * - `q` (hitch) in rad: Angle of the trailer to the car, positive to the right.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_CAR_TRAILER_H
#define CARVALLO_MODEL_CAR_TRAILER_H

#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define CAR_TRAILER_N 3U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `caravan`.
     *
     * Source: A family car with a caravan, by estimate
     */
    CAR_TRAILER_SET_CARAVAN = 0,
    /**
     * The parameter set `loaded_behind`.
     *
     * Source: The same with its load behind the axle of the caravan
     */
    CAR_TRAILER_SET_LOADED_BEHIND = 1
} car_trailer_set_t;

/** How many parameter sets there are. */
#define CAR_TRAILER_SETS 2U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *car_trailer_set_name(car_trailer_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    CAR_TRAILER_VALID = 0,
    /** `m` in kg must be finite and > 0. */
    CAR_TRAILER_INVALID_m = 1,
    /** `I` in kg*m^2 must be finite and > 0. */
    CAR_TRAILER_INVALID_I_ = 2,
    /** `a` in m must be finite and > 0. */
    CAR_TRAILER_INVALID_a = 3,
    /** `b` in m must be finite and > 0. */
    CAR_TRAILER_INVALID_b = 4,
    /** `h` in m must be finite and > 0. */
    CAR_TRAILER_INVALID_h = 5,
    /** `mT` in kg must be finite and > 0. */
    CAR_TRAILER_INVALID_mT = 6,
    /** `IT` in kg*m^2 must be finite and > 0. */
    CAR_TRAILER_INVALID_IT = 7,
    /** `e` in m must be finite. */
    CAR_TRAILER_INVALID_e = 8,
    /** `l` in m must be finite and > 0. */
    CAR_TRAILER_INVALID_l = 9,
    /** `Cf` in N/rad must be finite and > 0. */
    CAR_TRAILER_INVALID_Cf = 10,
    /** `Cr` in N/rad must be finite and > 0. */
    CAR_TRAILER_INVALID_Cr = 11,
    /** `CT` in N/rad must be finite and > 0. */
    CAR_TRAILER_INVALID_CT = 12,
    /** `d` in N*m*s/rad must be finite and >= 0. */
    CAR_TRAILER_INVALID_d = 13,
    /** `t` in m must be finite and > 0. */
    CAR_TRAILER_INVALID_t = 14,
    /** `r` in m must be finite and > 0. */
    CAR_TRAILER_INVALID_r = 15,
    /** `g` in N/kg must be finite and >= 0. */
    CAR_TRAILER_INVALID_g = 16
} car_trailer_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *car_trailer_validity_text(car_trailer_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define CAR_TRAILER_PARTIALS 78U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t car_trailer_partials[CAR_TRAILER_PARTIALS];

/* ------------------------------------------------------------ double */

/** The parameters of `CarTrailer`. */
typedef struct {
    /** Mass of the car. `m`, in kg: > 0. */
    double m;
    /** Moment of inertia of the car about its centre of mass, in yaw. `I`, in kg*m^2: > 0. */
    double I_;
    /** From the centre of mass of the car forward to the front axle. `a`, in m: > 0. */
    double a;
    /** From the centre of mass of the car backward to the rear axle. `b`, in m: > 0. */
    double b;
    /** From the centre of mass of the car backward to the ball. `h`, in m: > 0. */
    double h;
    /** Mass of the trailer. `mT`, in kg: > 0. */
    double mT;
    /** Moment of inertia of the trailer about its centre of mass, in yaw. `IT`, in kg*m^2: > 0. */
    double IT;
    /** From the ball backward to the centre of mass of the trailer. `e`, in m: any finite value. */
    double e;
    /** From the ball backward to the axle of the trailer. `l`, in m: > 0. */
    double l;
    /** Cornering stiffness of the front axle of the car. `Cf`, in N/rad: > 0. */
    double Cf;
    /** Cornering stiffness of the rear axle of the car, of both wheels. `Cr`, in N/rad: > 0. */
    double Cr;
    /** Cornering stiffness of the axle of the trailer. `CT`, in N/rad: > 0. */
    double CT;
    /** Damping of yaw at the ball. `d`, in N*m*s/rad: >= 0. */
    double d;
    /** Half of the track of the rear axle. `t`, in m: > 0. */
    double t;
    /** Radius of the wheels. `r`, in m: > 0. */
    double r;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    double g;
} car_trailer_f64_t;

/** The parameter sets, such as `car_trailer_f64_sets[CAR_TRAILER_SET_CARAVAN]`. */
extern const car_trailer_f64_t car_trailer_f64_sets[CAR_TRAILER_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
car_trailer_validity_t car_trailer_f64_validate(const car_trailer_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[CAR_TRAILER_N][CAR_TRAILER_N];
    /** Damping C-1, a coefficient of q'/v. Symmetric, proved. */
    double cm1[CAR_TRAILER_N][CAR_TRAILER_N];
    /** Damping C0, a coefficient of q'. Symmetric, proved. */
    double c0[CAR_TRAILER_N][CAR_TRAILER_N];
    /** Damping C1, a coefficient of v q'. */
    double c1[CAR_TRAILER_N][CAR_TRAILER_N];
    /** Stiffness Kc, a coefficient of q. */
    double kc[CAR_TRAILER_N][CAR_TRAILER_N];
} car_trailer_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 13 additions, 14 multiplications and 4 negations: 31 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void car_trailer_f64_matrices(const car_trailer_f64_t *p, car_trailer_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[CAR_TRAILER_N][CAR_TRAILER_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[CAR_TRAILER_N][CAR_TRAILER_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[CAR_TRAILER_N][CAR_TRAILER_N];
} car_trailer_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s, not 0; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t car_trailer_f64_at_speed(const car_trailer_f64_matrices_t *matrices,
    double speed, car_trailer_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 *
 * Where only the position or only the rate of a coordinate is a state, the row and the column of the other one are zero.
 * They are no part of the motion: leave them out before you ask for eigenvalues.
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * CAR_TRAILER_N][2U * CAR_TRAILER_N];
    /** The input matrix B. */
    double b[2U * CAR_TRAILER_N][CAR_TRAILER_N];
} car_trailer_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t car_trailer_f64_state_space(const car_trailer_f64_system_t *system,
    car_trailer_f64_state_space_t *space);

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
    double rates[CAR_TRAILER_N];
    /** The part proportional to v and each q. */
    double coordinates[CAR_TRAILER_N];
    /** The part proportional to v and the yaw. */
    double heading;
} car_trailer_f64_rate_t;

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
double car_trailer_f64_rate_at(const car_trailer_f64_rate_t *rate, double v,
    const double q[CAR_TRAILER_N], const double q_dot[CAR_TRAILER_N], double psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Rate, in `rad/s`: of `B`. */
    car_trailer_f64_rate_t lean;
    /** Rate of `pitch`, in `rad/s`. */
    car_trailer_f64_rate_t pitch;
    /** Spin of the wheel `F`, front axle: about the y axis, so negative in forward motion, in `rad/s`. */
    car_trailer_f64_rate_t wheel_F;
    /** Spin of the wheel `L`, rear left: about the y axis, so negative in forward motion, in `rad/s`. */
    car_trailer_f64_rate_t wheel_L;
    /** Spin of the wheel `R`, rear right: about the y axis, so negative in forward motion, in `rad/s`. */
    car_trailer_f64_rate_t wheel_R;
    /** Spin of the wheel `U`, axle of the trailer: about the y axis, so negative in forward motion, in `rad/s`. */
    car_trailer_f64_rate_t wheel_U;
} car_trailer_f64_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 multiplication, 1 division and 2 negations: 4 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void car_trailer_f64_kinematics(const car_trailer_f64_t *p, car_trailer_f64_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `car_trailer_partials`.
 */
typedef struct {
    double values[30];
} car_trailer_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 21 additions, 22 multiplications and 4 negations: 47 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void car_trailer_f64_derivatives(const car_trailer_f64_t *p, car_trailer_f64_matrices_t *matrices,
    car_trailer_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void car_trailer_f64_with_respect_to(const car_trailer_f64_derivatives_t *derivatives,
    size_t parameter, car_trailer_f64_matrices_t *matrices);

/* ------------------------------------------------------------ float */

/** The parameters of `CarTrailer`. */
typedef struct {
    /** Mass of the car. `m`, in kg: > 0. */
    float m;
    /** Moment of inertia of the car about its centre of mass, in yaw. `I`, in kg*m^2: > 0. */
    float I_;
    /** From the centre of mass of the car forward to the front axle. `a`, in m: > 0. */
    float a;
    /** From the centre of mass of the car backward to the rear axle. `b`, in m: > 0. */
    float b;
    /** From the centre of mass of the car backward to the ball. `h`, in m: > 0. */
    float h;
    /** Mass of the trailer. `mT`, in kg: > 0. */
    float mT;
    /** Moment of inertia of the trailer about its centre of mass, in yaw. `IT`, in kg*m^2: > 0. */
    float IT;
    /** From the ball backward to the centre of mass of the trailer. `e`, in m: any finite value. */
    float e;
    /** From the ball backward to the axle of the trailer. `l`, in m: > 0. */
    float l;
    /** Cornering stiffness of the front axle of the car. `Cf`, in N/rad: > 0. */
    float Cf;
    /** Cornering stiffness of the rear axle of the car, of both wheels. `Cr`, in N/rad: > 0. */
    float Cr;
    /** Cornering stiffness of the axle of the trailer. `CT`, in N/rad: > 0. */
    float CT;
    /** Damping of yaw at the ball. `d`, in N*m*s/rad: >= 0. */
    float d;
    /** Half of the track of the rear axle. `t`, in m: > 0. */
    float t;
    /** Radius of the wheels. `r`, in m: > 0. */
    float r;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    float g;
} car_trailer_f32_t;

/** The parameter sets, such as `car_trailer_f32_sets[CAR_TRAILER_SET_CARAVAN]`. */
extern const car_trailer_f32_t car_trailer_f32_sets[CAR_TRAILER_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
car_trailer_validity_t car_trailer_f32_validate(const car_trailer_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[CAR_TRAILER_N][CAR_TRAILER_N];
    /** Damping C-1, a coefficient of q'/v. Symmetric, proved. */
    float cm1[CAR_TRAILER_N][CAR_TRAILER_N];
    /** Damping C0, a coefficient of q'. Symmetric, proved. */
    float c0[CAR_TRAILER_N][CAR_TRAILER_N];
    /** Damping C1, a coefficient of v q'. */
    float c1[CAR_TRAILER_N][CAR_TRAILER_N];
    /** Stiffness Kc, a coefficient of q. */
    float kc[CAR_TRAILER_N][CAR_TRAILER_N];
} car_trailer_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 13 additions, 14 multiplications and 4 negations: 31 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void car_trailer_f32_matrices(const car_trailer_f32_t *p, car_trailer_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[CAR_TRAILER_N][CAR_TRAILER_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[CAR_TRAILER_N][CAR_TRAILER_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[CAR_TRAILER_N][CAR_TRAILER_N];
} car_trailer_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s, not 0; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t car_trailer_f32_at_speed(const car_trailer_f32_matrices_t *matrices,
    float speed, car_trailer_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 *
 * Where only the position or only the rate of a coordinate is a state, the row and the column of the other one are zero.
 * They are no part of the motion: leave them out before you ask for eigenvalues.
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * CAR_TRAILER_N][2U * CAR_TRAILER_N];
    /** The input matrix B. */
    float b[2U * CAR_TRAILER_N][CAR_TRAILER_N];
} car_trailer_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t car_trailer_f32_state_space(const car_trailer_f32_system_t *system,
    car_trailer_f32_state_space_t *space);

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
    float rates[CAR_TRAILER_N];
    /** The part proportional to v and each q. */
    float coordinates[CAR_TRAILER_N];
    /** The part proportional to v and the yaw. */
    float heading;
} car_trailer_f32_rate_t;

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
float car_trailer_f32_rate_at(const car_trailer_f32_rate_t *rate, float v,
    const float q[CAR_TRAILER_N], const float q_dot[CAR_TRAILER_N], float psi);

/** Rates and forces that follow from the coordinates, to first order and in SI units. */
typedef struct {
    /** Rate, in `rad/s`: of `B`. */
    car_trailer_f32_rate_t lean;
    /** Rate of `pitch`, in `rad/s`. */
    car_trailer_f32_rate_t pitch;
    /** Spin of the wheel `F`, front axle: about the y axis, so negative in forward motion, in `rad/s`. */
    car_trailer_f32_rate_t wheel_F;
    /** Spin of the wheel `L`, rear left: about the y axis, so negative in forward motion, in `rad/s`. */
    car_trailer_f32_rate_t wheel_L;
    /** Spin of the wheel `R`, rear right: about the y axis, so negative in forward motion, in `rad/s`. */
    car_trailer_f32_rate_t wheel_R;
    /** Spin of the wheel `U`, axle of the trailer: about the y axis, so negative in forward motion, in `rad/s`. */
    car_trailer_f32_rate_t wheel_U;
} car_trailer_f32_kinematics_t;

/**
 * Rates and forces that follow from the coordinates, from one straight-line program:
 * 1 multiplication, 1 division and 2 negations: 4 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] kinematics The rates and forces.
 */
void car_trailer_f32_kinematics(const car_trailer_f32_t *p, car_trailer_f32_kinematics_t *kinematics);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `car_trailer_partials`.
 */
typedef struct {
    float values[30];
} car_trailer_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 21 additions, 22 multiplications and 4 negations: 47 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void car_trailer_f32_derivatives(const car_trailer_f32_t *p, car_trailer_f32_matrices_t *matrices,
    car_trailer_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void car_trailer_f32_with_respect_to(const car_trailer_f32_derivatives_t *derivatives,
    size_t parameter, car_trailer_f32_matrices_t *matrices);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_CAR_TRAILER_H */
