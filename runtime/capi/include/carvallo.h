/* Carvallo as a C library, in C99 and C++. Written by cbindgen; do not edit.
 *
 * All numbers are in SI units, and angles are in rad. Every function may be called from several threads at once, but for one
 * machine that one of them changes or frees. Every pointer may be NULL where its function says so, and is answered with
 * CARVALLO_STATUS_NULL_POINTER elsewhere. No panic of the library leaves it: it is answered with CARVALLO_STATUS_PANICKED.
 *
 * Arrays are read and written for exactly as many elements as the argument beside them says. Arrays that are written may hold
 * anything before, must not overlap others, and are left as they were if the answer is not CARVALLO_STATUS_OK.
 */


#ifndef CARVALLO_H
#define CARVALLO_H

#include <stddef.h>
#include <stdint.h>

/**
 * What became of a call. carvallo_message() says more.
 */
typedef enum {
  /**
   * The answer is there.
   */
  CARVALLO_STATUS_OK = 0,
  /**
   * A pointer is NULL that must not be, or is not aligned.
   */
  CARVALLO_STATUS_NULL_POINTER = 1,
  /**
   * An array has not the right number of elements, or an index is too large.
   */
  CARVALLO_STATUS_WRONG_SIZE = 2,
  /**
   * There is no model, parameter set, file, parameter or matrix of that name.
   */
  CARVALLO_STATUS_UNKNOWN_NAME = 3,
  /**
   * A parameter, a requirement of the model or a matrix is not what it must be.
   */
  CARVALLO_STATUS_INVALID = 4,
  /**
   * There is no answer: such as with a mass matrix that is singular, or where a number leaves the range of doubles.
   */
  CARVALLO_STATUS_NO_ANSWER = 5,
  /**
   * A mistake in the library, which you should report.
   */
  CARVALLO_STATUS_PANICKED = 6,
} carvallo_status_t;

/**
 * What happens at a critical speed.
 */
typedef enum {
  /**
   * A conjugate pair of eigenvalues is on the imaginary axis: weave, wobble, flutter.
   */
  CARVALLO_KIND_WEAVE = 0,
  /**
   * A real eigenvalue is zero: capsize, divergence.
   */
  CARVALLO_KIND_CAPSIZE = 1,
  /**
   * Two eigenvalues coincide that do not coincide at neighbouring speeds.
   */
  CARVALLO_KIND_DOUBLE_ROOT = 2,
} carvallo_kind_t;

/**
 * What changes at a critical speed as the speed grows, of the eigenvalue or the pair.
 */
typedef enum {
  /**
   * It leaves the right half-plane.
   */
  CARVALLO_CHANGE_STABILIZES = 0,
  /**
   * It enters the right half-plane.
   */
  CARVALLO_CHANGE_DESTABILIZES = 1,
  /**
   * Two real eigenvalues become a conjugate pair.
   */
  CARVALLO_CHANGE_MERGES = 2,
  /**
   * A conjugate pair becomes two real eigenvalues.
   */
  CARVALLO_CHANGE_SPLITS = 3,
  /**
   * As many are on each side, or real, before and after.
   */
  CARVALLO_CHANGE_TOUCHES = 4,
} carvallo_change_t;

/**
 * Whether the motion is stable at one speed.
 */
typedef enum {
  /**
   * Every eigenvalue has a negative real part.
   */
  CARVALLO_VERDICT_STABLE = 0,
  /**
   * No eigenvalue has a positive real part, and one has a real part of zero.
   */
  CARVALLO_VERDICT_MARGINAL = 1,
  /**
   * An eigenvalue has a positive real part.
   */
  CARVALLO_VERDICT_UNSTABLE = 2,
} carvallo_verdict_t;

/**
 * Which of the position and the rate of a coordinate are states.
 */
typedef enum {
  /**
   * Both.
   */
  CARVALLO_STATES_BOTH = 0,
  /**
   * Its position alone: a coordinate of first order, whose column of M is zero.
   */
  CARVALLO_STATES_POSITION = 1,
  /**
   * Its rate alone: its columns of all stiffness matrices are zero.
   */
  CARVALLO_STATES_RATE = 2,
} carvallo_states_t;

/**
 * A machine: a model that ships with values of its parameters, or matrices that are given. The parameters of the latter are
 * the entries, such as `M_12`, and `g`.
 */
typedef struct carvallo_machine_t carvallo_machine_t;

/**
 * Critical speeds and stable ranges of a machine, as it was when they were asked for.
 */
typedef struct carvallo_stability_t carvallo_stability_t;

/**
 * The coefficient matrices of M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f, each with n * n entries
 * row by row; NULL for those that are zero. Set all of it to zero first: carvallo_matrices_t matrices = {0};
 */
typedef struct {
  /**
   * The number of coordinates, from 1 to 12.
   */
  size_t n;
  /**
   * Mass matrix M; not NULL.
   */
  const double *m;
  /**
   * Damping C-1, divided by v.
   */
  const double *cm1;
  /**
   * Damping C0.
   */
  const double *c0;
  /**
   * Damping C1, multiplied by v.
   */
  const double *c1;
  /**
   * Stiffness Kc.
   */
  const double *kc;
  /**
   * Stiffness K0, multiplied by the gravity.
   */
  const double *k0;
  /**
   * Stiffness K1, multiplied by v.
   */
  const double *k1;
  /**
   * Stiffness K2, multiplied by v^2.
   */
  const double *k2;
  /**
   * The gravitational field strength g in N/kg.
   */
  double gravity;
  /**
   * For each coordinate one of carvallo_states_t; NULL if both position and rate of all are states.
   */
  const int32_t *states;
} carvallo_matrices_t;

/**
 * A complex number; an array of them is one of `double complex` and of `std::complex<double>`.
 */
typedef struct {
  /**
   * The real part.
   */
  double re;
  /**
   * The imaginary part.
   */
  double im;
} carvallo_complex_t;

/**
 * A speed above zero at which the kind of motion changes.
 */
typedef struct {
  /**
   * What happens there.
   */
  carvallo_kind_t kind;
  /**
   * What changes as the speed grows.
   */
  carvallo_change_t change;
  /**
   * The speed in m/s.
   */
  double speed;
  /**
   * An estimate of its error in m/s, by rounding of the matrices and of its own.
   */
  double error;
  /**
   * The eigenvalue in 1/s: zero, on the upper imaginary axis, or double.
   */
  carvallo_complex_t eigenvalue;
} carvallo_critical_speed_t;

/**
 * An open range of speeds.
 */
typedef struct {
  /**
   * The lower end in m/s.
   */
  double from;
  /**
   * The upper end in m/s; HUGE_VAL, which is infinite, if it has none.
   */
  double to;
} carvallo_range_t;

/**
 * The values of one parameter, for many designs.
 */
typedef struct {
  /**
   * The name of the parameter.
   */
  const char *name;
  /**
   * Its value in each design, in its unit.
   */
  const double *values;
} carvallo_column_t;

/**
 * Stability of one of many designs.
 */
typedef struct {
  /**
   * Whether there is an answer; else all that follows is zero.
   */
  carvallo_status_t status;
  /**
   * How many critical speeds there are, double roots among them.
   */
  size_t critical_speeds;
  /**
   * How many stable ranges there are.
   */
  size_t stable_ranges;
  /**
   * How many ranges are undecided: where rounding decides.
   */
  size_t undecided;
  /**
   * The first of the stable ranges; both ends zero if there is none.
   */
  carvallo_range_t stable;
} carvallo_summary_t;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * The version of the library, such as "0.1.0".
 */
const char *carvallo_version(void);

/**
 * What was wrong in the last call of this thread that had no answer, in English; empty if there was none. It is valid until the
 * next call in this thread.
 */
const char *carvallo_message(void);

/**
 * The name of a model that ships, by its index from 0; NULL beyond the last. It is valid as long as the program runs.
 */
const char *carvallo_model_name(size_t index);

/**
 * The name of a parameter set that ships for a model, or of a bicycle, by its index from 0; NULL beyond the last, and for a
 * model that there is not. It is valid as long as the program runs.
 *
 * # Safety
 * The text ends with a zero.
 */
const char *carvallo_parameters_name(const char *model,
                                     size_t index);

/**
 * A machine that ships, or from a file.
 *
 * @param[in] model The name of a model, such as "Whipple" or "Motorcycle"; NULL for that which the file names, or else
 * "Whipple".
 * @param[in] parameters The name of what ships for the model, such as "benchmark" or "pista", or the path of a file in any of the
 * forms that the command line reads; NULL for the first that ships.
 * @param[out] machine The machine, which carvallo_machine_free() frees; NULL without an answer.
 *
 * # Safety
 * Texts end with a zero; `machine` points to a pointer.
 */
carvallo_status_t carvallo_machine_new(const char *model,
                                       const char *parameters,
                                       carvallo_machine_t **machine);

/**
 * A machine of given matrices, which are copied. Its parameters are their entries, such as "M_12" (with more than nine
 * coordinates "M_1_12"), and "g".
 *
 * @param[in] matrices The matrices.
 * @param[out] machine The machine, which carvallo_machine_free() frees; NULL without an answer.
 *
 * # Safety
 * Each matrix points to n * n numbers, and the states to n; `machine` points to a pointer.
 */
carvallo_status_t carvallo_machine_of_matrices(const carvallo_matrices_t *matrices,
                                               carvallo_machine_t **machine);

/**
 * Frees a machine; NULL is none.
 *
 * # Safety
 * It is NULL or a machine that was not freed.
 */
void carvallo_machine_free(carvallo_machine_t *machine);

/**
 * The number n of coordinates, and of rows and columns of each matrix; 0 for NULL.
 *
 * # Safety
 * It is NULL or a machine.
 */
size_t carvallo_machine_coordinates(const carvallo_machine_t *machine);

/**
 * The name of a coordinate, such as "phi", by its index from 0; NULL beyond the last. It is valid as long as the machine.
 *
 * # Safety
 * It is NULL or a machine.
 */
const char *carvallo_machine_coordinate_name(const carvallo_machine_t *machine,
                                             size_t index);

/**
 * The number of states, and of eigenvalues; 0 for NULL.
 *
 * # Safety
 * It is NULL or a machine.
 */
size_t carvallo_machine_states(const carvallo_machine_t *machine);

/**
 * The number of parameters; 0 for NULL.
 *
 * # Safety
 * It is NULL or a machine.
 */
size_t carvallo_machine_parameters(const carvallo_machine_t *machine);

/**
 * The name of a parameter, by its index from 0; NULL beyond the last. It is valid as long as the machine.
 *
 * # Safety
 * It is NULL or a machine.
 */
const char *carvallo_machine_parameter_name(const carvallo_machine_t *machine, size_t index);

/**
 * The unit of a parameter, such as "kg*m^2", or "1" for pure numbers; NULL beyond the last. It is valid as long as the machine.
 *
 * # Safety
 * It is NULL or a machine.
 */
const char *carvallo_machine_parameter_unit(const carvallo_machine_t *machine,
                                            size_t index);

/**
 * The value of a parameter.
 *
 * @param[in] name Its name.
 * @param[out] value Its value, in its unit.
 *
 * # Safety
 * It is NULL or a machine; the text ends with a zero; `value` points to a number.
 */
carvallo_status_t carvallo_machine_get(const carvallo_machine_t *machine, const char *name, double *value);

/**
 * Sets a parameter. It is judged with all others by the next function that computes something, so that several can be set one
 * after the other.
 *
 * @param[in] name Its name.
 * @param[in] value Its value, in its unit.
 *
 * # Safety
 * It is NULL or a machine that nothing else looks at; the text ends with a zero.
 */
carvallo_status_t carvallo_machine_set(carvallo_machine_t *machine,
                                       const char *name,
                                       double value);

/**
 * One of the matrices.
 *
 * @param[in] name "M", "C-1", "C0", "C1", "Kc", "K0", "K1" or "K2".
 * @param[out] entries Its entries, row by row; zero for a matrix that the machine has not.
 * @param[in] count How many: n * n.
 *
 * # Safety
 * It is NULL or a machine; the text ends with a zero; `entries` has room for `count` numbers.
 */
carvallo_status_t carvallo_machine_matrix(const carvallo_machine_t *machine,
                                          const char *name,
                                          double *entries,
                                          size_t count);

/**
 * The matrices A and B of the state-space form x' = A x + B f at one speed. The states x are the positions, then the rates, of
 * those coordinates that have them; the inputs f are the forces of all coordinates. With p states and n coordinates:
 *
 * @param[in] speed The forward speed in m/s.
 * @param[out] a The entries of A, p rows of p; NULL if they are not wanted.
 * @param[in] a_count How many: p * p.
 * @param[out] b The entries of B, p rows of n; NULL if they are not wanted.
 * @param[in] b_count How many: p * n.
 *
 * # Safety
 * It is NULL or a machine; `a` and `b` are NULL or have room for so many numbers.
 */
carvallo_status_t carvallo_state_space(const carvallo_machine_t *machine,
                                       double speed,
                                       double *a,
                                       size_t a_count,
                                       double *b,
                                       size_t b_count);

/**
 * The eigenvalues at one speed, in 1/s, sorted by real part, then by imaginary part.
 *
 * @param[in] speed The forward speed in m/s; below 0 it runs backwards.
 * @param[out] values The eigenvalues.
 * @param[in] count How many: carvallo_machine_states().
 *
 * # Safety
 * It is NULL or a machine; `values` has room for `count` of them.
 */
carvallo_status_t carvallo_eigenvalues(const carvallo_machine_t *machine,
                                       double speed,
                                       carvallo_complex_t *values,
                                       size_t count);

/**
 * The eigenvalues at many speeds, which takes less time than one call for each.
 *
 * @param[in] speeds The forward speeds in m/s.
 * @param[in] speed_count How many.
 * @param[out] values The eigenvalues, a row for each speed, sorted as those of carvallo_eigenvalues().
 * @param[in] count How many in all: speed_count * carvallo_machine_states().
 * @return Of the first speed without an answer what is wrong.
 *
 * # Safety
 * It is NULL or a machine; `speeds` has `speed_count` numbers; `values` has room for `count` of them.
 */
carvallo_status_t carvallo_eigenvalues_along(const carvallo_machine_t *machine,
                                             const double *speeds,
                                             size_t speed_count,
                                             carvallo_complex_t *values,
                                             size_t count);

/**
 * The eigenvectors of eigenvalues at one speed: of each, a row with a component for each coordinate.
 *
 * The largest component of a right one is 1, and the others are relative to it in size and phase. A left one y is scaled by
 * y^H (2 s M + C) x = 1, so that an impulse f excites the mode by y^H f; of multiple eigenvalues its largest component is 1.
 *
 * @param[in] speed The forward speed in m/s.
 * @param[in] values Eigenvalues at this speed, all of them, in any order.
 * @param[in] value_count How many: carvallo_machine_states().
 * @param[out] right The right eigenvectors; NULL if they are not wanted.
 * @param[out] left The left eigenvectors; NULL if they are not wanted.
 * @param[in] count How many components in each of them: value_count * carvallo_machine_coordinates().
 *
 * # Safety
 * It is NULL or a machine; `values` has `value_count` numbers; `right` and `left` are NULL or have room for `count` of them.
 */
carvallo_status_t carvallo_eigenvectors(const carvallo_machine_t *machine,
                                        double speed,
                                        const carvallo_complex_t *values,
                                        size_t value_count,
                                        carvallo_complex_t *right,
                                        carvallo_complex_t *left,
                                        size_t count);

/**
 * All critical speeds and stable ranges of a machine, for any number of coordinates. They are not scanned for: see the page on
 * stability of the guide.
 *
 * @param[out] stability The answer, which carvallo_stability_free() frees, and which does not change with the machine; NULL without
 * one.
 *
 * # Safety
 * It is NULL or a machine; `stability` points to a pointer.
 */
carvallo_status_t carvallo_stability_new(const carvallo_machine_t *machine,
                                         carvallo_stability_t **stability);

/**
 * Frees an answer; NULL is none.
 *
 * # Safety
 * It is NULL or one that was not freed.
 */
void carvallo_stability_free(carvallo_stability_t *stability);

/**
 * All critical speeds above zero, ascending, those of double roots among them. They are valid as long as the answer.
 *
 * @param[out] count How many.
 * @return The first of them; NULL if there is none.
 *
 * # Safety
 * It is NULL or an answer; `count` points to a number.
 */
const carvallo_critical_speed_t *carvallo_stability_critical_speeds(const carvallo_stability_t *stability,
                                                                    size_t *count);

/**
 * The ranges of speed in which the motion is stable, ascending. They are valid as long as the answer.
 *
 * @param[out] count How many.
 * @return The first of them; NULL if there is none.
 *
 * # Safety
 * It is NULL or an answer; `count` points to a number.
 */
const carvallo_range_t *carvallo_stability_stable_ranges(const carvallo_stability_t *stability,
                                                         size_t *count);

/**
 * The ranges of speed in which a critical speed may be missing, ascending: none, but where eigenvalues are so close to the
 * imaginary axis that rounding decides. They are valid as long as the answer.
 *
 * @param[out] count How many.
 * @return The first of them; NULL if there is none.
 *
 * # Safety
 * It is NULL or an answer; `count` points to a number.
 */
const carvallo_range_t *carvallo_stability_undecided(const carvallo_stability_t *stability,
                                                     size_t *count);

/**
 * Whether the motion is stable at a speed: stable in stable ranges, marginal at their ends.
 *
 * @param[in] speed The forward speed in m/s, from 0.
 * @param[out] verdict The answer.
 *
 * # Safety
 * It is NULL or an answer; `verdict` points to one.
 */
carvallo_status_t carvallo_stability_verdict(const carvallo_stability_t *stability,
                                             double speed,
                                             carvallo_verdict_t *verdict);

/**
 * The derivatives of a critical speed with respect to each parameter, exact: in m/s by the unit of the parameter.
 *
 * @param[in] stability The stability of a machine; what was set of the machine since then does not count.
 * @param[in] index Which of its critical speeds, from 0.
 * @param[out] derivatives The derivatives, in the order of the parameters.
 * @param[in] count How many: carvallo_machine_parameters().
 * @return CARVALLO_STATUS_NO_ANSWER if there are none: for a model without derivatives, or where two critical speeds meet.
 *
 * # Safety
 * It is NULL or an answer; `derivatives` has room for `count` numbers.
 */
carvallo_status_t carvallo_critical_speed_derivatives(const carvallo_stability_t *stability,
                                                      size_t index,
                                                      double *derivatives,
                                                      size_t count);

/**
 * The eigenvalues of many designs at one speed.
 *
 * @param[in] machine What the designs have for the parameters without a column.
 * @param[in] columns The parameters that differ.
 * @param[in] column_count How many.
 * @param[in] designs How many designs there are: the length of each column.
 * @param[in] speed The forward speed in m/s.
 * @param[in] threads How many threads compute; 0 for as many as there are cores. The answers are the same with any number.
 * @param[out] values The eigenvalues, a row for each design; zero where it has no answer.
 * @param[in] count How many in all: designs * carvallo_machine_states().
 * @param[out] statuses For each design whether it has an answer.
 *
 * # Safety
 * It is NULL or a machine; each column has a name and `designs` numbers; `values` has room for `count` of them, and `statuses` for
 * `designs`.
 */
carvallo_status_t carvallo_batch_eigenvalues(const carvallo_machine_t *machine,
                                             const carvallo_column_t *columns,
                                             size_t column_count,
                                             size_t designs,
                                             double speed,
                                             size_t threads,
                                             carvallo_complex_t *values,
                                             size_t count,
                                             carvallo_status_t *statuses);

/**
 * The stability of many designs.
 *
 * @param[in] machine What the designs have for the parameters without a column.
 * @param[in] columns The parameters that differ.
 * @param[in] column_count How many.
 * @param[in] designs How many designs there are: the length of each column.
 * @param[in] threads How many threads compute; 0 for as many as there are cores. The answers are the same with any number.
 * @param[out] summaries For each design how many critical speeds and stable ranges it has, and the first of these.
 * @param[out] critical_speeds The first critical speeds, a row for each design; all zero beyond those that there are. NULL if they
 * are not wanted.
 * @param[in] most How many there are in a row.
 *
 * # Safety
 * It is NULL or a machine; each column has a name and `designs` numbers; `summaries` has room for `designs` of them, and
 * `critical_speeds` is NULL or has it for designs * most.
 */
carvallo_status_t carvallo_batch_stability(const carvallo_machine_t *machine,
                                           const carvallo_column_t *columns,
                                           size_t column_count,
                                           size_t designs,
                                           size_t threads,
                                           carvallo_summary_t *summaries,
                                           carvallo_critical_speed_t *critical_speeds,
                                           size_t most);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* CARVALLO_H */
