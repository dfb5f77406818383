/* SPDX-License-Identifier: MIT OR Apache-2.0 */

#include "carvallo_motion.h"

#include "carvallo_system.h"

const char *carvallo_motion_error_text(carvallo_motion_error_t error)
{
    static const char *const TEXTS[] = {
        "no error",
        "a position, a speed or a force is not finite",
        "no positions were found in which all wheels touch the ground",
        "the state is singular: a wheel lies flat, or the contacts do not determine the motion",
    };
    const size_t position = (size_t)error;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such error";
}

bool carvallo_are_finite_f64(const double values[], size_t count)
{
    bool are_finite = true;
    for (size_t i = 0U; i < count; i++) {
        are_finite = are_finite && carvallo_is_finite_f64(values[i]);
    }
    return are_finite;
}

bool carvallo_are_finite_f32(const float values[], size_t count)
{
    bool are_finite = true;
    for (size_t i = 0U; i < count; i++) {
        are_finite = are_finite && carvallo_is_finite_f32(values[i]);
    }
    return are_finite;
}
