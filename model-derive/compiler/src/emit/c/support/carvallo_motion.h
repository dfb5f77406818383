/* SPDX-License-Identifier: MIT OR Apache-2.0 */

/**
 * @file carvallo_motion.h
 * @brief What the models with nonlinear equations of motion share: codes of what can be wrong with a state.
 */

#ifndef CARVALLO_MOTION_H
#define CARVALLO_MOTION_H

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What can keep a mechanism from moving. */
typedef enum {
    /** Nothing: the results are there. */
    CARVALLO_MOTION_OK = 0,
    /** A position, a speed or a force is not finite. */
    CARVALLO_MOTION_NOT_FINITE = 1,
    /** No positions were found in which every wheel touches the ground. */
    CARVALLO_MOTION_NOT_CLOSED = 2,
    /** The machine is singular in this state: a wheel lies flat, or the contacts no longer determine how it moves. */
    CARVALLO_MOTION_SINGULAR = 3
} carvallo_motion_error_t;

/** What an error means, in English; a text of its own for what is none of them. */
const char *carvallo_motion_error_text(carvallo_motion_error_t error);

/** Whether none of so many numbers is infinite or no number. */
bool carvallo_are_finite_f64(const double values[], size_t count);

/** The same as carvallo_are_finite_f64(), in single precision. */
bool carvallo_are_finite_f32(const float values[], size_t count);

#ifdef __cplusplus
}
#endif

#endif /* CARVALLO_MOTION_H */
