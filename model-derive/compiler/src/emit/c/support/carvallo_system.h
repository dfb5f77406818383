/* SPDX-License-Identifier: MIT OR Apache-2.0 */

/**
 * @file carvallo_system.h
 * @brief What the models share: codes of what can be wrong, names of matrices, and the elimination of the mass matrix.
 *
 * All files here and those of the models are C99 without allocation, without data that is written to, and without
 * recursion: every function may be called from several threads or interrupts at once. `NAME_f64_…` computes in double
 * precision throughout and `NAME_f32_…` in single; one without the other is linked where functions have sections of their
 * own (`-ffunction-sections -fdata-sections`, and `--gc-sections` for the linker).
 *
 * The numbers are those of the crate `carvallo`, to the last bit in both precisions, where the compiler rounds each
 * operation: GCC and Clang with `-ffp-contract=off` (GCC contracts by default unless it is told `-std=c99`), without
 * `-ffast-math`, and not on the x87. With operations contracted, results differ in their last bits, and are no worse.
 */

#ifndef CARVALLO_SYSTEM_H
#define CARVALLO_SYSTEM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What can be wrong with the equations of motion at a speed. */
typedef enum {
    /** Nothing: the results are there. */
    CARVALLO_SYSTEM_OK = 0,
    /** The speed, the gravity or an entry of a matrix is not finite. */
    CARVALLO_SYSTEM_NOT_FINITE = 1,
    /** There is a C-1, which is divided by the speed, and the speed is zero. */
    CARVALLO_SYSTEM_AT_REST = 2,
    /** A result leaves the range of its numbers. */
    CARVALLO_SYSTEM_OUT_OF_RANGE = 3,
    /** The mass matrix is singular, as far as its numbers can tell. */
    CARVALLO_SYSTEM_SINGULAR_MASS = 4
} carvallo_system_error_t;

/** The coefficient matrices of M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f. */
typedef enum {
    CARVALLO_MATRIX_M = 0,   /**< M, the coefficient of q''. */
    CARVALLO_MATRIX_CM1 = 1, /**< C-1, a coefficient of q'/v. */
    CARVALLO_MATRIX_C0 = 2,  /**< C0, a coefficient of q'. */
    CARVALLO_MATRIX_C1 = 3,  /**< C1, a coefficient of v q'. */
    CARVALLO_MATRIX_KC = 4,  /**< Kc, a coefficient of q. */
    CARVALLO_MATRIX_K0 = 5,  /**< K0, a coefficient of g q. */
    CARVALLO_MATRIX_K1 = 6,  /**< K1, a coefficient of v q. */
    CARVALLO_MATRIX_K2 = 7   /**< K2, a coefficient of v^2 q. */
} carvallo_matrix_t;

/** One derivative: that of an entry of a matrix with respect to a parameter. */
typedef struct {
    carvallo_matrix_t matrix; /**< The matrix. */
    uint16_t row;             /**< The row of the entry, from 0. */
    uint16_t column;          /**< The column of the entry, from 0. */
    uint16_t parameter;       /**< The position of the parameter in declared order, from 0. */
    uint16_t value;           /**< The position of its value among those that are computed, from 0. */
    bool is_negative;         /**< Whether it is the negative of that value. */
} carvallo_partial_t;

/** What an error means, in English; a text of its own for what is none of them. */
const char *carvallo_system_error_text(carvallo_system_error_t error);

/** Whether a number is neither infinite nor no number. */
bool carvallo_is_finite_f64(double value);

/** Whether a number is neither infinite nor no number, in single precision. */
bool carvallo_is_finite_f32(float value);

/**
 * Solves M X = B by elimination with pivots that are the largest relative to their rows.
 *
 * M is singular if a pivot is no more than the rounding of the terms that were subtracted to form it, whatever the scale of
 * its rows and columns.
 *
 * @param[in] size The number n of rows and columns of M.
 * @param[in,out] m M, n * n entries row by row; lost.
 * @param[out] terms Room for n * n entries.
 * @param[in] columns The number k of columns of B.
 * @param[in,out] x B, n * k entries row by row; replaced by X.
 * @return Whether M is singular, or an entry of X leaves the range; then X is lost.
 */
carvallo_system_error_t carvallo_solve_f64(size_t size, double m[], double terms[], size_t columns, double x[]);

/** The same as carvallo_solve_f64(), in single precision. */
carvallo_system_error_t carvallo_solve_f32(size_t size, float m[], float terms[], size_t columns, float x[]);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_SYSTEM_H */
