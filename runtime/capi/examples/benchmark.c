/* The eigenvalues and critical speeds of the benchmark bicycle, by its name and from its printed matrices, beside those that
 * Meijaard, Papadopoulos, Ruina & Schwab (2007) print. */

#include "carvallo.h"

#include <math.h>
#include <stdio.h>

/* Table 2 at 5 m/s. */
static const carvallo_complex_t printed[4] = {
    { -14.07838969279822, 0.0 },
    { -0.77534188219585, -4.46486771378823 },
    { -0.77534188219585, 4.46486771378823 },
    { -0.32286642900409, 0.0 }
};
static const double printed_stable_from = 4.29238253634111;
static const double printed_stable_to = 6.02426201538837;

/* Section 7.1. */
static const double m[4] = { 80.81722, 2.31941332208709, 2.31941332208709, 0.29784188199686 };
static const double c1[4] = { 0.0, 33.86641391492494, -0.85035641456978, 1.68540397397560 };
static const double k0[4] = { -80.95, -2.59951685249872, -2.59951685249872, -0.80329488458618 };
static const double k2[4] = { 0.0, 76.59734589573222, 0.0, 2.65431523794604 };

/* The largest difference from print, or a negative number if there is no answer. */
static double compare(const carvallo_machine_t *machine)
{
    carvallo_complex_t values[4];
    carvallo_stability_t *stability = NULL;
    if ((carvallo_eigenvalues(machine, 5.0, values, 4) != CARVALLO_STATUS_OK) ||
        (carvallo_stability_new(machine, &stability) != CARVALLO_STATUS_OK)) {
        fprintf(stderr, "error: %s\n", carvallo_message());
        return -1.0;
    }
    double difference = 0.0;
    puts("  eigenvalues at 5 m/s, in 1/s:");
    for (size_t i = 0; i < 4; i++) {
        printf("  %20.14f %+.14fi\n", values[i].re, values[i].im);
        difference = fmax(difference, fabs(values[i].re - printed[i].re));
        difference = fmax(difference, fabs(values[i].im - printed[i].im));
    }
    size_t count = 0;
    const carvallo_critical_speed_t *const speeds = carvallo_stability_critical_speeds(stability, &count);
    puts("  critical speeds, in m/s:");
    for (size_t i = 0; i < count; i++) {
        static const char *const names[] = { "weave", "capsize", "double root" };
        printf("  %20.14f %s\n", speeds[i].speed, names[speeds[i].kind]);
    }
    const carvallo_range_t *const ranges = carvallo_stability_stable_ranges(stability, &count);
    if (count == 1) {
        printf("  stable from %.14f to %.14f m/s\n", ranges[0].from, ranges[0].to);
        difference = fmax(difference, fabs(ranges[0].from - printed_stable_from));
        difference = fmax(difference, fabs(ranges[0].to - printed_stable_to));
    } else {
        difference = HUGE_VAL;
    }
    carvallo_stability_free(stability);
    return difference;
}

static int report(const char *name, carvallo_machine_t *machine)
{
    if (machine == NULL) {
        fprintf(stderr, "error: %s\n", carvallo_message());
        return 1;
    }
    puts(name);
    const double difference = compare(machine);
    printf("  largest difference from print: %.1e\n", difference);
    carvallo_machine_free(machine);
    return ((difference >= 0.0) && (difference < 1e-10)) ? 0 : 1;
}

int main(void)
{
    /* Without an answer the machine is NULL. */
    carvallo_machine_t *machine = NULL;
    (void)carvallo_machine_new("Whipple", "benchmark", &machine);
    int failed = report("The benchmark bicycle, by its name", machine);

    carvallo_matrices_t matrices = { 0 };
    matrices.n = 2;
    matrices.m = m;
    matrices.c1 = c1;
    matrices.k0 = k0;
    matrices.k2 = k2;
    matrices.gravity = 9.81;
    (void)carvallo_machine_of_matrices(&matrices, &machine);
    failed |= report("From its printed matrices", machine);
    return failed;
}
