/* SPDX-License-Identifier: MIT OR Apache-2.0 */

/* Compile with -ffp-contract=off (GCC, Clang) or the like, and without -ffast-math: see carvallo_system.h. */

#include "carvallo_system.h"

#include <float.h>
#include <math.h>

const char *carvallo_system_error_text(carvallo_system_error_t error)
{
    static const char *const TEXTS[] = {
        "no error",
        "the speed, the gravity or an entry of a matrix is not finite",
        "the speed is 0, and the matrix C-1 is divided by it",
        "a result leaves the range of its numbers",
        "the mass matrix is singular",
    };
    const size_t position = (size_t)error;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : "no such error";
}
