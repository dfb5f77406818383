/* @generated from generated/models/three_pipes.rs by carvallo-compiler 0.1.0; do not edit.
 * To write it anew: cargo regenerate
 * Hash of the source: 92f4761ae2f6100e
 */

/**
 * @file three_pipes.h
 * @brief The model `ThreePipes`, in C99 and C++: everything is in SI units, and angles are in rad.
 *
 * Three pipes in a row that carry a fluid, hanging: a garden hose with three hinges.
 *
 * Rigid pipes of equal length, the first hinged to a wall and each other one to the one before it, each hinge with a
 * spring and a damper. The speed v is that of the fluid, which leaves at the free end along the last pipe; above a
 * critical speed the pipes buckle or flutter.
 *
 * Source: Hamilton's principle for a fluid that leaves the system, as Benjamin (1961) has it: Proc. R. Soc. A 261, 457-486
 *
 * The linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are
 *
 *     M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
 *
 * with the generalized forces f and the coordinates q, in the order of rows and columns:
 *
 * - `first` in rad: Angle of the first pipe from the vertical.
 * - `second` in rad: Angle of the second pipe from the vertical.
 * - `third` in rad: Angle of the third pipe from the vertical.
 *
 * Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the
 * same bits on every processor.
 */

#ifndef CARVALLO_MODEL_THREE_PIPES_H
#define CARVALLO_MODEL_THREE_PIPES_H

#include "carvallo_system.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number N of coordinates, and of rows and columns of each matrix. */
#define THREE_PIPES_N 3U

/** The parameter sets, by their positions in the tables of them. */
typedef enum {
    /**
     * The parameter set `hose`.
     *
     * Source: a hose of rubber, by estimate
     */
    THREE_PIPES_SET_HOSE = 0
} three_pipes_set_t;

/** How many parameter sets there are. */
#define THREE_PIPES_SETS 1U

/** The name of a parameter set, as it is declared; a text of its own for what is none. */
const char *three_pipes_set_name(three_pipes_set_t set);

/**
 * What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.
 */
typedef enum {
    /** They are valid. */
    THREE_PIPES_VALID = 0,
    /** `l` in m must be finite and > 0. */
    THREE_PIPES_INVALID_l = 1,
    /** `m` in kg/m must be finite and > 0. */
    THREE_PIPES_INVALID_m = 2,
    /** `f` in kg/m must be finite and >= 0. */
    THREE_PIPES_INVALID_f = 3,
    /** `k` in N*m/rad must be finite and >= 0. */
    THREE_PIPES_INVALID_k = 4,
    /** `c` in N*m*s/rad must be finite and >= 0. */
    THREE_PIPES_INVALID_c = 5,
    /** `g` in N/kg must be finite and >= 0. */
    THREE_PIPES_INVALID_g = 6
} three_pipes_validity_t;

/** What a code means, in English, with the values that are allowed; a text of its own for what is no code. */
const char *three_pipes_validity_text(three_pipes_validity_t validity);

/** How many derivatives are not zero for all parameters. */
#define THREE_PIPES_PARTIALS 70U

/** Which derivatives there are, by parameters, and where their values stand. */
extern const carvallo_partial_t three_pipes_partials[THREE_PIPES_PARTIALS];

/* ------------------------------------------------------------ double */

/** The parameters of `ThreePipes`. */
typedef struct {
    /** Length of each pipe. `l`, in m: > 0. */
    double l;
    /** Mass of a pipe for each metre. `m`, in kg/m: > 0. */
    double m;
    /** Mass of the fluid in it for each metre. `f`, in kg/m: >= 0. */
    double f;
    /** Stiffness of each hinge. `k`, in N*m/rad: >= 0. */
    double k;
    /** Damping of each hinge. `c`, in N*m*s/rad: >= 0. */
    double c;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    double g;
} three_pipes_f64_t;

/** The parameter sets, such as `three_pipes_f64_sets[THREE_PIPES_SET_HOSE]`. */
extern const three_pipes_f64_t three_pipes_f64_sets[THREE_PIPES_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
three_pipes_validity_t three_pipes_f64_validate(const three_pipes_f64_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    double m[THREE_PIPES_N][THREE_PIPES_N];
    /** Damping C0, a coefficient of q'. Symmetric, proved. */
    double c0[THREE_PIPES_N][THREE_PIPES_N];
    /** Damping C1, a coefficient of v q'. */
    double c1[THREE_PIPES_N][THREE_PIPES_N];
    /** Stiffness Kc, a coefficient of q. Symmetric, proved. */
    double kc[THREE_PIPES_N][THREE_PIPES_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    double k0[THREE_PIPES_N][THREE_PIPES_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    double k2[THREE_PIPES_N][THREE_PIPES_N];
} three_pipes_f64_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 4 additions, 13 multiplications and 3 negations: 20 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void three_pipes_f64_matrices(const three_pipes_f64_t *p, three_pipes_f64_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    double m[THREE_PIPES_N][THREE_PIPES_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    double c[THREE_PIPES_N][THREE_PIPES_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    double k[THREE_PIPES_N][THREE_PIPES_N];
} three_pipes_f64_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t three_pipes_f64_at_speed(const three_pipes_f64_matrices_t *matrices,
    double speed, double gravity, three_pipes_f64_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    double a[2U * THREE_PIPES_N][2U * THREE_PIPES_N];
    /** The input matrix B. */
    double b[2U * THREE_PIPES_N][THREE_PIPES_N];
} three_pipes_f64_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t three_pipes_f64_state_space(const three_pipes_f64_system_t *system,
    three_pipes_f64_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `three_pipes_partials`.
 */
typedef struct {
    double values[25];
} three_pipes_f64_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 7 additions, 30 multiplications and 3 negations: 40 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void three_pipes_f64_derivatives(const three_pipes_f64_t *p, three_pipes_f64_matrices_t *matrices,
    three_pipes_f64_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void three_pipes_f64_with_respect_to(const three_pipes_f64_derivatives_t *derivatives,
    size_t parameter, three_pipes_f64_matrices_t *matrices);

/* ------------------------------------------------------------ float */

/** The parameters of `ThreePipes`. */
typedef struct {
    /** Length of each pipe. `l`, in m: > 0. */
    float l;
    /** Mass of a pipe for each metre. `m`, in kg/m: > 0. */
    float m;
    /** Mass of the fluid in it for each metre. `f`, in kg/m: >= 0. */
    float f;
    /** Stiffness of each hinge. `k`, in N*m/rad: >= 0. */
    float k;
    /** Damping of each hinge. `c`, in N*m*s/rad: >= 0. */
    float c;
    /** Gravitational field strength. `g`, in N/kg: >= 0. */
    float g;
} three_pipes_f32_t;

/** The parameter sets, such as `three_pipes_f32_sets[THREE_PIPES_SET_HOSE]`. */
extern const three_pipes_f32_t three_pipes_f32_sets[THREE_PIPES_SETS];

/**
 * Whether parameters are valid, which no other function looks at: with those that are not, results may be infinite or
 * no numbers.
 *
 * @param[in] p The parameters.
 * @return The first thing that is wrong.
 */
three_pipes_validity_t three_pipes_f32_validate(const three_pipes_f32_t *p);

/** The coefficient matrices, row by row, in SI units. Those that are not among them are zero. */
typedef struct {
    /** Mass matrix M, the coefficient of q''. Symmetric, proved. */
    float m[THREE_PIPES_N][THREE_PIPES_N];
    /** Damping C0, a coefficient of q'. Symmetric, proved. */
    float c0[THREE_PIPES_N][THREE_PIPES_N];
    /** Damping C1, a coefficient of v q'. */
    float c1[THREE_PIPES_N][THREE_PIPES_N];
    /** Stiffness Kc, a coefficient of q. Symmetric, proved. */
    float kc[THREE_PIPES_N][THREE_PIPES_N];
    /** Stiffness K0, a coefficient of g q. Symmetric, proved. */
    float k0[THREE_PIPES_N][THREE_PIPES_N];
    /** Stiffness K2, a coefficient of v^2 q. */
    float k2[THREE_PIPES_N][THREE_PIPES_N];
} three_pipes_f32_matrices_t;

/**
 * The coefficient matrices, from one straight-line program:
 * 4 additions, 13 multiplications and 3 negations: 20 operations.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] matrices The matrices.
 */
void three_pipes_f32_matrices(const three_pipes_f32_t *p, three_pipes_f32_matrices_t *matrices);

/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    float m[THREE_PIPES_N][THREE_PIPES_N];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    float c[THREE_PIPES_N][THREE_PIPES_N];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    float k[THREE_PIPES_N][THREE_PIPES_N];
} three_pipes_f32_system_t;

/**
 * The equations of motion at one speed.
 *
 * @param[in] matrices The coefficient matrices.
 * @param[in] speed The forward speed v in m/s; below 0 it runs backwards.
 * @param[in] gravity The gravitational field strength g in N/kg.
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t three_pipes_f32_at_speed(const three_pipes_f32_matrices_t *matrices,
    float speed, float gravity, three_pipes_f32_system_t *system);

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
 */
typedef struct {
    /** The state matrix A. */
    float a[2U * THREE_PIPES_N][2U * THREE_PIPES_N];
    /** The input matrix B. */
    float b[2U * THREE_PIPES_N][THREE_PIPES_N];
} three_pipes_f32_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t three_pipes_f32_state_space(const three_pipes_f32_system_t *system,
    three_pipes_f32_state_space_t *space);

/**
 * The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all
 * parameters, each value once. Which is which is said by `three_pipes_partials`.
 */
typedef struct {
    float values[25];
} three_pipes_f32_derivatives_t;

/**
 * The coefficient matrices and their derivatives, from one straight-line program:
 * 7 additions, 30 multiplications and 3 negations: 40 operations.
 *
 * @param[in] p The parameters, which are not validated; at valid ones every derivative exists.
 * @param[out] matrices The matrices.
 * @param[out] derivatives The derivatives.
 */
void three_pipes_f32_derivatives(const three_pipes_f32_t *p, three_pipes_f32_matrices_t *matrices,
    three_pipes_f32_derivatives_t *derivatives);

/**
 * The derivatives of all matrices with respect to one parameter, with the zeros filled in.
 *
 * @param[in] derivatives The derivatives.
 * @param[in] parameter The position of the parameter in declared order, from 0; beyond the last all are zero.
 * @param[out] matrices The derivatives of the matrices.
 */
void three_pipes_f32_with_respect_to(const three_pipes_f32_derivatives_t *derivatives,
    size_t parameter, three_pipes_f32_matrices_t *matrices);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MODEL_THREE_PIPES_H */
