/* Calls every function, with arrays that are exactly as long as they must be and with what is wrong, for valgrind and for the
 * sanitizers: nothing is read or written beside them, and nothing is left behind. Prints nothing if all is right. */

#include "carvallo.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

static void expect(const char *what, carvallo_status_t status, carvallo_status_t expected)
{
    if (status != expected) {
        printf("%s: %d instead of %d: %s\n", what, (int)status, (int)expected, carvallo_message());
        failures++;
    }
}

#define EXPECT(expected, call) expect(#call, (call), CARVALLO_STATUS_##expected)

static void *room(size_t count, size_t size)
{
    void *const found = malloc((count * size) + (size_t)(count == 0U));
    if (found == NULL) {
        abort();
    }
    return found;
}

static void ask(carvallo_machine_t *machine)
{
    const size_t n = carvallo_machine_coordinates(machine);
    const size_t states = carvallo_machine_states(machine);
    const size_t parameters = carvallo_machine_parameters(machine);
    const double speeds[2] = { 3.0, 4.0 };
    const size_t designs = 70;

    double *const entries = room(n * n, sizeof *entries);
    EXPECT(OK, carvallo_machine_matrix(machine, "M", entries, n * n));
    EXPECT(WRONG_SIZE, carvallo_machine_matrix(machine, "M", entries, (n * n) + 1U));
    EXPECT(UNKNOWN_NAME, carvallo_machine_matrix(machine, "Q", entries, n * n));
    free(entries);

    carvallo_complex_t *const values = room(states, sizeof *values);
    carvallo_complex_t *const along = room(2U * states, sizeof *along);
    carvallo_complex_t *const right = room(states * n, sizeof *right);
    carvallo_complex_t *const left = room(states * n, sizeof *left);
    EXPECT(OK, carvallo_eigenvalues(machine, 3.0, values, states));
    EXPECT(NO_ANSWER, carvallo_eigenvalues(machine, HUGE_VAL, values, states));
    EXPECT(OK, carvallo_eigenvalues_along(machine, speeds, 2, along, 2U * states));
    EXPECT(WRONG_SIZE, carvallo_eigenvalues_along(machine, speeds, 1, along, 2U * states));
    EXPECT(OK, carvallo_eigenvalues_along(machine, NULL, 0, NULL, 0));
    EXPECT(OK, carvallo_eigenvectors(machine, 3.0, values, states, right, left, states * n));
    EXPECT(OK, carvallo_eigenvectors(machine, 3.0, values, states, NULL, NULL, states * n));
    EXPECT(WRONG_SIZE, carvallo_eigenvectors(machine, 3.0, values, 1, right, left, states * n));
    double *const a = room(states * states, sizeof *a);
    double *const b = room(states * n, sizeof *b);
    EXPECT(OK, carvallo_state_space(machine, 3.0, a, states * states, b, states * n));
    EXPECT(OK, carvallo_state_space(machine, 3.0, NULL, 0, b, states * n));
    EXPECT(OK, carvallo_state_space(machine, 3.0, a, states * states, NULL, 0));
    EXPECT(WRONG_SIZE, carvallo_state_space(machine, 3.0, a, states, b, states * n));
    EXPECT(WRONG_SIZE, carvallo_state_space(machine, 3.0, a, states * states, b, (states * n) + 1U));
    EXPECT(NO_ANSWER, carvallo_state_space(machine, HUGE_VAL, a, states * states, b, states * n));
    /* The sum of the eigenvalues is the trace of A. */
    double sum = 0.0;
    double size = 1.0;
    for (size_t i = 0; i < states; i++) {
        sum += a[(i * states) + i] - values[i].re;
        size += fabs(a[(i * states) + i]) + fabs(values[i].re) + fabs(values[i].im);
    }
    if (!(fabs(sum) < (1e-9 * size))) {
        printf("the trace of A is off by %g\n", sum);
        failures++;
    }
    free(a);
    free(b);
    if ((carvallo_machine_coordinate_name(machine, n - 1U) == NULL) || (carvallo_machine_coordinate_name(machine, n) != NULL)) {
        puts("not as many names of coordinates as coordinates");
        failures++;
    }
    if (memcmp(values, along, states * sizeof *values) != 0) {
        puts("eigenvalues along speeds are others than at one");
        failures++;
    }

    carvallo_stability_t *stability = NULL;
    double *const derivatives = room(parameters, sizeof *derivatives);
    size_t count = 0;
    EXPECT(OK, carvallo_stability_new(machine, &stability));
    (void)carvallo_stability_undecided(stability, &count);
    const carvallo_range_t *const ranges = carvallo_stability_stable_ranges(stability, &count);
    carvallo_verdict_t verdict;
    if (count > 0U) {
        const double inside = isfinite(ranges[0].to) ? (0.5 * (ranges[0].from + ranges[0].to)) : (ranges[0].from + 1.0);
        EXPECT(OK, carvallo_stability_verdict(stability, inside, &verdict));
        if (verdict != CARVALLO_VERDICT_STABLE) {
            puts("not stable in a stable range");
            failures++;
        }
    }
    EXPECT(NO_ANSWER, carvallo_stability_verdict(stability, -1.0, &verdict));
    const carvallo_critical_speed_t *const critical = carvallo_stability_critical_speeds(stability, &count);
    for (size_t i = 0; i < count; i++) {
        const carvallo_status_t status = carvallo_critical_speed_derivatives(stability, i, derivatives, parameters);
        if (!isfinite(critical[i].speed) || ((status != CARVALLO_STATUS_OK) && (status != CARVALLO_STATUS_NO_ANSWER))) {
            printf("critical speed %g: %s\n", critical[i].speed, carvallo_message());
            failures++;
        }
    }
    EXPECT(WRONG_SIZE, carvallo_critical_speed_derivatives(stability, count, derivatives, parameters));
    carvallo_stability_free(stability);
    free(derivatives);

    const char *const name = carvallo_machine_parameter_name(machine, 0);
    double value = 0.0;
    EXPECT(OK, carvallo_machine_get(machine, name, &value));
    double *const column_values = room(designs, sizeof *column_values);
    for (size_t i = 0; i < designs; i++) {
        column_values[i] = value * (1.0 + (1e-4 * (double)i));
    }
    const carvallo_column_t column = { name, column_values };
    carvallo_complex_t *const all = room(designs * states, sizeof *all);
    carvallo_status_t *const statuses = room(designs, sizeof *statuses);
    EXPECT(OK, carvallo_batch_eigenvalues(machine, &column, 1, designs, 3.0, 2, all, designs * states, statuses));
    EXPECT(WRONG_SIZE, carvallo_batch_eigenvalues(machine, &column, 1, designs, 3.0, 2, all, 1, statuses));
    if (memcmp(values, all, states * sizeof *values) != 0) {
        puts("eigenvalues of a batch are others than alone");
        failures++;
    }
    /* Of many coordinates they take milliseconds, under valgrind as many seconds. */
    const size_t few = (states > 4U) ? 1U : designs;
    carvallo_summary_t *const summaries = room(few, sizeof *summaries);
    carvallo_critical_speed_t *const rows = room(few * 3U, sizeof *rows);
    EXPECT(OK, carvallo_batch_stability(machine, &column, 1, few, 0, summaries, rows, 3));
    EXPECT(OK, carvallo_batch_stability(machine, NULL, 0, few, 1, summaries, NULL, 3));
    EXPECT(NULL_POINTER, carvallo_batch_stability(machine, NULL, 1, few, 1, summaries, NULL, 0));
    EXPECT(OK, carvallo_machine_set(machine, name, -HUGE_VAL));
    EXPECT(INVALID, carvallo_eigenvalues(machine, 3.0, values, states));

    free(rows);
    free(summaries);
    free(statuses);
    free(all);
    free(column_values);
    free(left);
    free(right);
    free(along);
    free(values);
}

static void ask_nobody(void)
{
    carvallo_machine_t *machine = NULL;
    carvallo_stability_t *stability = NULL;
    size_t count = 0;
    double number = 0.0;
    carvallo_verdict_t verdict;
    EXPECT(NULL_POINTER, carvallo_machine_new(NULL, NULL, NULL));
    EXPECT(UNKNOWN_NAME, carvallo_machine_new("Whipple", "nobody", &machine));
    EXPECT(NULL_POINTER, carvallo_machine_of_matrices(NULL, &machine));
    EXPECT(NULL_POINTER, carvallo_machine_get(NULL, "w", &number));
    EXPECT(NULL_POINTER, carvallo_machine_set(NULL, "w", 1.0));
    EXPECT(NULL_POINTER, carvallo_machine_matrix(NULL, "M", &number, 1));
    EXPECT(NULL_POINTER, carvallo_eigenvalues(NULL, 1.0, NULL, 0));
    EXPECT(NULL_POINTER, carvallo_eigenvalues_along(NULL, NULL, 0, NULL, 0));
    EXPECT(NULL_POINTER, carvallo_eigenvectors(NULL, 1.0, NULL, 0, NULL, NULL, 0));
    EXPECT(NULL_POINTER, carvallo_state_space(NULL, 1.0, NULL, 0, NULL, 0));
    EXPECT(NULL_POINTER, carvallo_stability_new(NULL, &stability));
    EXPECT(NULL_POINTER, carvallo_stability_verdict(NULL, 1.0, &verdict));
    EXPECT(NULL_POINTER, carvallo_critical_speed_derivatives(NULL, 0, NULL, 0));
    EXPECT(NULL_POINTER, carvallo_batch_eigenvalues(NULL, NULL, 0, 0, 1.0, 0, NULL, 0, NULL));
    EXPECT(NULL_POINTER, carvallo_batch_stability(NULL, NULL, 0, 0, 0, NULL, NULL, 0));
    if ((carvallo_machine_coordinates(NULL) != 0U) || (carvallo_machine_states(NULL) != 0U) ||
        (carvallo_machine_parameters(NULL) != 0U) || (carvallo_machine_parameter_name(NULL, 0) != NULL) ||
        (carvallo_machine_parameter_unit(NULL, 0) != NULL) || (carvallo_machine_coordinate_name(NULL, 0) != NULL) ||
        (carvallo_parameters_name(NULL, 0) != NULL) || (carvallo_parameters_name("Wipple", 0) != NULL) ||
        (carvallo_stability_critical_speeds(NULL, &count) != NULL) ||
        (carvallo_stability_stable_ranges(NULL, NULL) != NULL) ||
        (carvallo_stability_undecided(NULL, &count) != NULL) || (strlen(carvallo_version()) == 0U)) {
        puts("something is had of NULL");
        failures++;
    }
    carvallo_machine_free(NULL);
    carvallo_stability_free(NULL);
}

static void ask_matrices(size_t n)
{
    double *const m = room(n * n, sizeof *m);
    double *const c0 = room(n * n, sizeof *c0);
    double *const kc = room(n * n, sizeof *kc);
    int32_t *const states = room(n, sizeof *states);
    for (size_t i = 0; i < (n * n); i++) {
        const size_t row = i / n;
        const size_t column = i % n;
        m[i] = (row == column) ? 1.0 : 0.0;
        c0[i] = (row == column) ? 0.5 : (0.01 * (double)(row + (2U * column)));
        kc[i] = (row == column) ? (double)(row + 1U) : 0.0;
        states[column] = CARVALLO_STATES_BOTH;
    }
    carvallo_matrices_t matrices = { 0 };
    matrices.n = n;
    matrices.m = m;
    matrices.c0 = c0;
    matrices.kc = kc;
    matrices.states = states;
    carvallo_machine_t *machine = NULL;
    EXPECT(OK, carvallo_machine_of_matrices(&matrices, &machine));
    free(m);
    free(c0);
    free(kc);
    free(states);
    ask(machine);
    carvallo_machine_free(machine);
    matrices.n = 13;
    EXPECT(WRONG_SIZE, carvallo_machine_of_matrices(&matrices, &machine));
}

int main(void)
{
    ask_nobody();
    for (size_t i = 0; carvallo_model_name(i) != NULL; i++) {
        carvallo_machine_t *machine = NULL;
        EXPECT(OK, carvallo_machine_new(carvallo_model_name(i), NULL, &machine));
        ask(machine);
        carvallo_machine_free(machine);
        /* What is listed can be had. */
        for (size_t j = 0; carvallo_parameters_name(carvallo_model_name(i), j) != NULL; j++) {
            EXPECT(OK, carvallo_machine_new(carvallo_model_name(i), carvallo_parameters_name(carvallo_model_name(i), j), &machine));
            carvallo_machine_free(machine);
        }
    }
    ask_matrices(1);
    ask_matrices(2);
    ask_matrices(3);
    return (failures == 0) ? 0 : 1;
}
