/* @generated from generated/models/towed_wheel.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 7f4879efbc67535d
 */

/**
 * @file towed_wheel.h
 * @brief The model `TowedWheel`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * A towed wheel that shimmies.
 *
 * A caster whose king pin is held by a lateral spring to a vehicle that runs straight at the speed v. The wheel does not
 * slip sideways, so its lateral place moves as its yaw says: `y' = v psi`, a coordinate of first order. Whether it
 * shimmies depends on the geometry and not on the speed: it is stable for `a (l - a) > I/m`.
 *
 * Source: Schwab & Meijaard (2003), Dynamics of flexible multibody systems with non-holonomic constraints, Multibody System Dynamics 10, 107-123
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `psi` (yaw) in rad: Yaw of the wheel, positive to the right.
 * - `y` (place) in m; of first order: only its position is a state: Lateral place of the contact point, positive to the right.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_TOWED_WHEEL_H
#define CARVALLO_MODEL_TOWED_WHEEL_H

#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define TOWED_WHEEL_N 2U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `example`.
     *
     * Source: Schwab & Meijaard (2003): k = 0.3 m/s^2, I = 0.21 m l^2, with the centre of mass in the middle
     */
    TOWED_WHEEL_SET_EXAMPLE = 0
} towed_wheel_set_t;

/** How many parameter sets there are. */
#define TOWED_WHEEL_SETS 1U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *towed_wheel_set_name(towed_wheel_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    TOWED_WHEEL_VALID = 0,
    /** `m` in kg must be finite and > 0. */
    TOWED_WHEEL_INVALID_m = 1,
    /** `I` in kg*m^2 must be finite and > 0. */
    TOWED_WHEEL_INVALID_I_ = 2,
    /** `l` in m must be finite and > 0. */
    TOWED_WHEEL_INVALID_l = 3,
    /** `a` in m must be finite. */
    TOWED_WHEEL_INVALID_a = 4,
    /** `k` in N/m must be finite and > 0. */
    TOWED_WHEEL_INVALID_k = 5
} towed_wheel_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *towed_wheel_validity_text(towed_wheel_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define TOWED_WHEEL_PARTIALS 9U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t towed_wheel_partials[TOWED_WHEEL_PARTIALS];

/* ------------------------------------------------------------ double */

/** The parameters of `TowedWheel`. */
typedef struct {
    /** Mass of wheel and fork. `m`, in kg: > 0. */
    double m;
    /** Moment of inertia of wheel and fork about their centre of mass, in yaw. `I`, in kg*m^2: > 0. */
    double I_;
    /** From the contact point of the wheel forward to the king pin. `l`, in m: > 0. */
    double l;
    /** From the contact point of the wheel forward to the centre of mass. `a`, in m: any finite value. */
    double a;
    /** Lateral stiffness of the support of the king pin. `k`, in N/m: > 0. */
    double k;
} towed_wheel_f64_t;

/** The parameter sets, such as `towed_wheel_f64_sets[TOWED_WHEEL_SET_EXAMPLE]`. */
extern const towed_wheel_f64_t towed_wheel_f64_sets[TOWED_WHEEL_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
towed_wheel_validity_t towed_wheel_f64_validate(const towed_wheel_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. */
    double m[TOWED_WHEEL_N][TOWED_WHEEL_N];
    /** Damping C0, a coefficient of q'. */
    double c0[TOWED_WHEEL_N][TOWED_WHEEL_N];
    /** Damping C1, a coefficient of v q'. */
    double c1[TOWED_WHEEL_N][TOWED_WHEEL_N];
    /** Stiffness Kc, a coefficient of q. */
    double kc[TOWED_WHEEL_N][TOWED_WHEEL_N];
    /** Stiffness K1, a coefficient of v q. */
    double k1[TOWED_WHEEL_N][TOWED_WHEEL_N];
} towed_wheel_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 1 addition and 4 multiplications: 5 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void towed_wheel_f64_matrices(const towed_wheel_f64_t *p, towed_wheel_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[TOWED_WHEEL_N][TOWED_WHEEL_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[TOWED_WHEEL_N][TOWED_WHEEL_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[TOWED_WHEEL_N][TOWED_WHEEL_N];
} towed_wheel_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t towed_wheel_f64_at_speed(const towed_wheel_f64_matrices_t *matrices,
    double speed, towed_wheel_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 *
 * Where only the position or only the rate of a coordinate is a state, the row and the column of the other one are zero.
 * They are no part of the motion: leave them out before you ask for eigenvalues.
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * TOWED_WHEEL_N][2U * TOWED_WHEEL_N];
    /** The input matrix B. */
    double b[2U * TOWED_WHEEL_N][TOWED_WHEEL_N];
} towed_wheel_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t towed_wheel_f64_state_space(const towed_wheel_f64_system_t *system,
    towed_wheel_f64_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `towed_wheel_partials`.
 */
typedef struct {
    double values[9];
} towed_wheel_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 3 additions and 6 multiplications: 9 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void towed_wheel_f64_derivatives(const towed_wheel_f64_t *p, towed_wheel_f64_matrices_t *matrices,
    towed_wheel_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void towed_wheel_f64_with_respect_to(const towed_wheel_f64_derivatives_t *derivatives,
    size_t parameter, towed_wheel_f64_matrices_t *matrices);

/* ------------------------------------------------------------ float */

/** The parameters of `TowedWheel`. */
typedef struct {
    /** Mass of wheel and fork. `m`, in kg: > 0. */
    float m;
    /** Moment of inertia of wheel and fork about their centre of mass, in yaw. `I`, in kg*m^2: > 0. */
    float I_;
    /** From the contact point of the wheel forward to the king pin. `l`, in m: > 0. */
    float l;
    /** From the contact point of the wheel forward to the centre of mass. `a`, in m: any finite value. */
    float a;
    /** Lateral stiffness of the support of the king pin. `k`, in N/m: > 0. */
    float k;
} towed_wheel_f32_t;

/** The parameter sets, such as `towed_wheel_f32_sets[TOWED_WHEEL_SET_EXAMPLE]`. */
extern const towed_wheel_f32_t towed_wheel_f32_sets[TOWED_WHEEL_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
towed_wheel_validity_t towed_wheel_f32_validate(const towed_wheel_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. */
    float m[TOWED_WHEEL_N][TOWED_WHEEL_N];
    /** Damping C0, a coefficient of q'. */
    float c0[TOWED_WHEEL_N][TOWED_WHEEL_N];
    /** Damping C1, a coefficient of v q'. */
    float c1[TOWED_WHEEL_N][TOWED_WHEEL_N];
    /** Stiffness Kc, a coefficient of q. */
    float kc[TOWED_WHEEL_N][TOWED_WHEEL_N];
    /** Stiffness K1, a coefficient of v q. */
    float k1[TOWED_WHEEL_N][TOWED_WHEEL_N];
} towed_wheel_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 1 addition and 4 multiplications: 5 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void towed_wheel_f32_matrices(const towed_wheel_f32_t *p, towed_wheel_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[TOWED_WHEEL_N][TOWED_WHEEL_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[TOWED_WHEEL_N][TOWED_WHEEL_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[TOWED_WHEEL_N][TOWED_WHEEL_N];
} towed_wheel_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t towed_wheel_f32_at_speed(const towed_wheel_f32_matrices_t *matrices,
    float speed, towed_wheel_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 *
 * Where only the position or only the rate of a coordinate is a state, the row and the column of the other one are zero.
 * They are no part of the motion: leave them out before you ask for eigenvalues.
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * TOWED_WHEEL_N][2U * TOWED_WHEEL_N];
    /** The input matrix B. */
    float b[2U * TOWED_WHEEL_N][TOWED_WHEEL_N];
} towed_wheel_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t towed_wheel_f32_state_space(const towed_wheel_f32_system_t *system,
    towed_wheel_f32_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `towed_wheel_partials`.
 */
typedef struct {
    float values[9];
} towed_wheel_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 3 additions and 6 multiplications: 9 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void towed_wheel_f32_derivatives(const towed_wheel_f32_t *p, towed_wheel_f32_matrices_t *matrices,
    towed_wheel_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void towed_wheel_f32_with_respect_to(const towed_wheel_f32_derivatives_t *derivatives,
    size_t parameter, towed_wheel_f32_matrices_t *matrices);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_TOWED_WHEEL_H */
