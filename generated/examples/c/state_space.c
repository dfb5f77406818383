/* Prints A and B of the benchmark bicycle at a speed in m/s: state_space [SPEED] */

#include "whipple.h"

#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv)
{
    const double speed = (argc > 1) ? strtod(argv[1], NULL) : 5.0;
    const whipple_f64_t *const bicycle = &whipple_f64_sets[WHIPPLE_SET_BENCHMARK];
    const whipple_validity_t validity = whipple_f64_validate(bicycle);
    if (validity != WHIPPLE_VALID) {
        fprintf(stderr, "error: %s\n", whipple_validity_text(validity));
        return 1;
    }

    whipple_f64_matrices_t matrices;
    whipple_f64_system_t system;
    whipple_f64_state_space_t space;
    whipple_f64_matrices(bicycle, &matrices);
    carvallo_system_error_t error = whipple_f64_at_speed(&matrices, speed, bicycle->g, &system);
    if (error == CARVALLO_SYSTEM_OK) {
        error = whipple_f64_state_space(&system, &space);
    }
    if (error != CARVALLO_SYSTEM_OK) {
        fprintf(stderr, "error: %s\n", carvallo_system_error_text(error));
        return 1;
    }

    printf("%s at %g m/s: x' = A x + B f, with x = (lean, steer, lean rate, steer rate)\n",
        whipple_set_name(WHIPPLE_SET_BENCHMARK), speed);
    for (size_t row = 0U; row < (2U * WHIPPLE_N); row++) {
        for (size_t column = 0U; column < (2U * WHIPPLE_N); column++) {
            printf("%12.5f", space.a[row][column]);
        }
        printf("   |");
        for (size_t column = 0U; column < WHIPPLE_N; column++) {
            printf("%12.6f", space.b[row][column]);
        }
        printf("\n");
    }
    return 0;
}
