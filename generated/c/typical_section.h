/* @generated from generated/models/typical_section.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 648bb7d66536ca12
 */

/**
 * @file typical_section.h
 * @brief The model `TypicalSection`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * The typical section: a rigid wing on two springs in a flow, which diverges or flutters above a critical airspeed.
 *
 * Plunge and pitch of a wing of constant profile in a wind tunnel. The lift is that of a thin profile in a steady flow,
 * 2 pi times the angle of attack, at the quarter chord; what the motion itself does to the flow is left out, and with
 * it all damping, so that two pairs of imaginary eigenvalues meet where flutter begins. The speed v is that of the air.
 *
 * Source: Equations of the typical section with steady lift, as in textbooks of aeroelasticity such as Hodges & Pierce, Introduction to Structural Dynamics and Aeroelasticity
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `h` (plunge) in m: Plunge of the elastic axis, positive down.
 * - `theta` (pitch) in rad: Pitch, positive with the nose up.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_TYPICAL_SECTION_H
#define CARVALLO_MODEL_TYPICAL_SECTION_H

#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define TYPICAL_SECTION_N 2U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `dimensionless`.
     *
     * Source: mu = 20, r^2 = 6/25, sigma = 2/5, a = -1/5, e = -1/10; speeds are U/(b omega_theta)
     */
    TYPICAL_SECTION_SET_DIMENSIONLESS = 0
} typical_section_set_t;

/** How many parameter sets there are. */
#define TYPICAL_SECTION_SETS 1U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *typical_section_set_name(typical_section_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    TYPICAL_SECTION_VALID = 0,
    /** `m` in kg must be finite and > 0. */
    TYPICAL_SECTION_INVALID_m = 1,
    /** `I` in kg*m^2 must be finite and > 0. */
    TYPICAL_SECTION_INVALID_I_ = 2,
    /** `b` in m must be finite and > 0. */
    TYPICAL_SECTION_INVALID_b = 3,
    /** `s` in m must be finite and > 0. */
    TYPICAL_SECTION_INVALID_s = 4,
    /** `a` must be finite and >= -1 and <= 1. */
    TYPICAL_SECTION_INVALID_a = 5,
    /** `e` must be finite and >= -1 and <= 1. */
    TYPICAL_SECTION_INVALID_e = 6,
    /** `kh` in N/m must be finite and >= 0. */
    TYPICAL_SECTION_INVALID_kh = 7,
    /** `ktheta` in N*m/rad must be finite and >= 0. */
    TYPICAL_SECTION_INVALID_ktheta = 8,
    /** `rho` in kg/m^3 must be finite and >= 0. */
    TYPICAL_SECTION_INVALID_rho = 9,
    /** `I - m*b^2*(e - a)^2` in kg*m^2 must be finite and > 0. */
    TYPICAL_SECTION_REQUIREMENT_1 = 10
} typical_section_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *typical_section_validity_text(typical_section_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define TYPICAL_SECTION_PARTIALS 19U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t typical_section_partials[TYPICAL_SECTION_PARTIALS];

/* ------------------------------------------------------------ double */

/** The parameters of `TypicalSection`. */
typedef struct {
    /** Mass of the wing. `m`, in kg: > 0. */
    double m;
    /** Moment of inertia about the elastic axis. `I`, in kg*m^2: > 0. */
    double I_;
    /** Semichord, half of the chord. `b`, in m: > 0. */
    double b;
    /** Span of the wing. `s`, in m: > 0. */
    double s;
    /** Elastic axis, behind the middle of the chord, in semichords. `a`, a pure number: >= -1 and <= 1. */
    double a;
    /** Centre of mass, behind the middle of the chord, in semichords. `e`, a pure number: >= -1 and <= 1. */
    double e;
    /** Stiffness of the spring in plunge. `kh`, in N/m: >= 0. */
    double kh;
    /** Stiffness of the spring in pitch. `ktheta` kθ, in N*m/rad: >= 0. */
    double ktheta;
    /** Density of the air. `rho` ρ, in kg/m^3: >= 0. */
    double rho;
} typical_section_f64_t;

/** The parameter sets, such as `typical_section_f64_sets[TYPICAL_SECTION_SET_DIMENSIONLESS]`. */
extern const typical_section_f64_t typical_section_f64_sets[TYPICAL_SECTION_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
typical_section_validity_t typical_section_f64_validate(const typical_section_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[TYPICAL_SECTION_N][TYPICAL_SECTION_N];
    /** Stiffness Kc, a coefficient of q. Symmetric, proved. */
    double kc[TYPICAL_SECTION_N][TYPICAL_SECTION_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    double k2[TYPICAL_SECTION_N][TYPICAL_SECTION_N];
} typical_section_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 3 additions, 7 multiplications and 1 negation: 11 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void typical_section_f64_matrices(const typical_section_f64_t *p, typical_section_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[TYPICAL_SECTION_N][TYPICAL_SECTION_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[TYPICAL_SECTION_N][TYPICAL_SECTION_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[TYPICAL_SECTION_N][TYPICAL_SECTION_N];
} typical_section_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t typical_section_f64_at_speed(const typical_section_f64_matrices_t *matrices,
    double speed, typical_section_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * TYPICAL_SECTION_N][2U * TYPICAL_SECTION_N];
    /** The input matrix B. */
    double b[2U * TYPICAL_SECTION_N][TYPICAL_SECTION_N];
} typical_section_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t typical_section_f64_state_space(const typical_section_f64_system_t *system,
    typical_section_f64_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `typical_section_partials`.
 */
typedef struct {
    double values[11];
} typical_section_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 4 additions, 16 multiplications and 1 negation: 21 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void typical_section_f64_derivatives(const typical_section_f64_t *p,
    typical_section_f64_matrices_t *matrices, typical_section_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void typical_section_f64_with_respect_to(const typical_section_f64_derivatives_t *derivatives,
    size_t parameter, typical_section_f64_matrices_t *matrices);

/* ------------------------------------------------------------ float */

/** The parameters of `TypicalSection`. */
typedef struct {
    /** Mass of the wing. `m`, in kg: > 0. */
    float m;
    /** Moment of inertia about the elastic axis. `I`, in kg*m^2: > 0. */
    float I_;
    /** Semichord, half of the chord. `b`, in m: > 0. */
    float b;
    /** Span of the wing. `s`, in m: > 0. */
    float s;
    /** Elastic axis, behind the middle of the chord, in semichords. `a`, a pure number: >= -1 and <= 1. */
    float a;
    /** Centre of mass, behind the middle of the chord, in semichords. `e`, a pure number: >= -1 and <= 1. */
    float e;
    /** Stiffness of the spring in plunge. `kh`, in N/m: >= 0. */
    float kh;
    /** Stiffness of the spring in pitch. `ktheta` kθ, in N*m/rad: >= 0. */
    float ktheta;
    /** Density of the air. `rho` ρ, in kg/m^3: >= 0. */
    float rho;
} typical_section_f32_t;

/** The parameter sets, such as `typical_section_f32_sets[TYPICAL_SECTION_SET_DIMENSIONLESS]`. */
extern const typical_section_f32_t typical_section_f32_sets[TYPICAL_SECTION_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
typical_section_validity_t typical_section_f32_validate(const typical_section_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[TYPICAL_SECTION_N][TYPICAL_SECTION_N];
    /** Stiffness Kc, a coefficient of q. Symmetric, proved. */
    float kc[TYPICAL_SECTION_N][TYPICAL_SECTION_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    float k2[TYPICAL_SECTION_N][TYPICAL_SECTION_N];
} typical_section_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 3 additions, 7 multiplications and 1 negation: 11 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void typical_section_f32_matrices(const typical_section_f32_t *p, typical_section_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[TYPICAL_SECTION_N][TYPICAL_SECTION_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[TYPICAL_SECTION_N][TYPICAL_SECTION_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[TYPICAL_SECTION_N][TYPICAL_SECTION_N];
} typical_section_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t typical_section_f32_at_speed(const typical_section_f32_matrices_t *matrices,
    float speed, typical_section_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * TYPICAL_SECTION_N][2U * TYPICAL_SECTION_N];
    /** The input matrix B. */
    float b[2U * TYPICAL_SECTION_N][TYPICAL_SECTION_N];
} typical_section_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t typical_section_f32_state_space(const typical_section_f32_system_t *system,
    typical_section_f32_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `typical_section_partials`.
 */
typedef struct {
    float values[11];
} typical_section_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 4 additions, 16 multiplications and 1 negation: 21 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void typical_section_f32_derivatives(const typical_section_f32_t *p,
    typical_section_f32_matrices_t *matrices, typical_section_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void typical_section_f32_with_respect_to(const typical_section_f32_derivatives_t *derivatives,
    size_t parameter, typical_section_f32_matrices_t *matrices);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_TYPICAL_SECTION_H */
