/* SPDX-License-Identifier: MIT OR Apache-2.0 */

/* The benchmark bicycle, pushed sideways at 4.6 m/s: its nonlinear equations by a Runge-Kutta method of fourth order. Without
 * damping the energy stays what it was, and the program fails if it does not. */

#include "whipple_mechanism.h"

#include <math.h>
#include <stdio.h>

enum { POSITIONS = 8, SPEEDS = 3, STATES = 11 };

/* The rates of a state: positions, and then speeds. The heights of the wheels determine the pitch, which is kept so. */
static carvallo_motion_error_t differentiate(const whipple_mechanism_f64_motion_t *motion, const double state[STATES],
    double rates[STATES])
{
    static const double FORCES[WHIPPLE_MECHANISM_FORCES] = {0.0, 0.0};
    double positions[POSITIONS];
    for (int i = 0; i < POSITIONS; i++) {
        positions[i] = state[i];
    }
    carvallo_motion_error_t error = whipple_mechanism_f64_motion_close(motion, positions);
    if (error == CARVALLO_MOTION_OK) {
        error = whipple_mechanism_f64_motion_derivatives(motion, positions, &state[POSITIONS], FORCES, rates,
            &rates[POSITIONS]);
    }
    return error;
}

static carvallo_motion_error_t step(const whipple_mechanism_f64_motion_t *motion, double state[STATES], double time)
{
    static const double PARTS[4] = {0.0, 0.5, 0.5, 1.0};
    static const double WEIGHTS[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    double sum[STATES] = {0.0};
    double rates[STATES] = {0.0};
    for (int stage = 0; stage < 4; stage++) {
        double inner[STATES];
        for (int i = 0; i < STATES; i++) {
            inner[i] = state[i] + PARTS[stage] * time * rates[i];
        }
        const carvallo_motion_error_t error = differentiate(motion, inner, rates);
        if (error != CARVALLO_MOTION_OK) {
            return error;
        }
        for (int i = 0; i < STATES; i++) {
            sum[i] += WEIGHTS[stage] * rates[i];
        }
    }
    for (int i = 0; i < STATES; i++) {
        state[i] += time * sum[i];
    }
    return whipple_mechanism_f64_motion_close(motion, state);
}

int main(void)
{
    const whipple_mechanism_f64_t bicycle = whipple_mechanism_f64_sets[WHIPPLE_MECHANISM_SET_BENCHMARK];
    whipple_mechanism_f64_motion_t motion;
    whipple_mechanism_f64_motion(&bicycle, &motion);

    double state[STATES] = {0.0};
    double *const speeds = &state[POSITIONS];
    speeds[WHIPPLE_MECHANISM_SPEED_phi] = 0.5;
    speeds[WHIPPLE_MECHANISM_SPEED_thetaR] = -4.6 / bicycle.rR; /* forward: the axle points to the right */
    carvallo_motion_error_t error = whipple_mechanism_f64_motion_close(&motion, state);

    double first = 0.0;
    double worst = 0.0;
    for (int count = 0; error == CARVALLO_MOTION_OK && count <= 5000; count++) {
        double energy[2];
        error = whipple_mechanism_f64_motion_energy(&motion, state, speeds, energy);
        const double sum = energy[0] + energy[1];
        first = (count == 0) ? sum : first;
        worst = fmax(worst, fabs(sum - first) / first);
        if (count % 500 == 0) {
            printf("%4.1f s  lean %7.3f deg  steer %7.3f deg  forward speed %6.4f m/s\n", count * 1e-3,
                state[WHIPPLE_MECHANISM_POSITION_phi] * 57.29577951308232,
                state[WHIPPLE_MECHANISM_POSITION_delta] * 57.29577951308232,
                -bicycle.rR * speeds[WHIPPLE_MECHANISM_SPEED_thetaR]);
        }
        if (error == CARVALLO_MOTION_OK) {
            error = step(&motion, state, 1e-3);
        }
    }
    if (error != CARVALLO_MOTION_OK) {
        puts(carvallo_motion_error_text(error));
        return 1;
    }
    printf("the energy of %.6f J was kept to %.1e of it\n", first, worst);
    return (worst < 1e-9) ? 0 : 1;
}
