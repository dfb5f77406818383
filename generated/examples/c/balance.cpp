// Steers a bicycle into its fall at a speed at which it falls by itself, in single precision as a microcontroller does:
// the torque is proportional to the lean rate, with a gain that falls with the speed.

#include "whipple.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace {

using State = std::array<float, 2 * WHIPPLE_N>; // lean and steer in rad, and their rates

// The torque on the steering in N m, to the side to which the bicycle falls: nothing from 5 m/s on.
float steer_torque(const State &x, float speed)
{
    return 6.0F * (5.0F - speed) * x[2];
}

State derivative(const whipple_f32_state_space_t &space, const State &x, float torque)
{
    State rate{};
    for (std::size_t row = 0; row < rate.size(); row++) {
        for (std::size_t column = 0; column < x.size(); column++) {
            rate[row] += space.a[row][column] * x[column];
        }
        rate[row] += space.b[row][1] * torque;
    }
    return rate;
}

// The largest lean in rad of the last second of five, after a push.
float largest_lean(const whipple_f32_state_space_t &space, float speed, bool is_controlled)
{
    const float step = 0.001F;
    State x{0.0F, 0.0F, 0.1F, 0.0F};
    float largest = 0.0F;
    for (int i = 0; i < 5000; i++) {
        const float torque = is_controlled ? steer_torque(x, speed) : 0.0F;
        // By the midpoint.
        State middle = x;
        const State first = derivative(space, x, torque);
        for (std::size_t k = 0; k < x.size(); k++) {
            middle[k] += 0.5F * step * first[k];
        }
        const State second = derivative(space, middle, torque);
        for (std::size_t k = 0; k < x.size(); k++) {
            x[k] += step * second[k];
        }
        if (i >= 4000) {
            largest = std::fmax(largest, std::fabs(x[0]));
        }
    }
    return largest;
}

} // namespace

int main()
{
    const whipple_f32_t &bicycle = whipple_f32_sets[WHIPPLE_SET_BENCHMARK];
    whipple_f32_matrices_t matrices;
    whipple_f32_matrices(&bicycle, &matrices);
    std::puts("speed in m/s   largest lean after 4 s in rad, alone and steered");
    bool is_balanced = true;
    for (const float speed : {3.0F, 3.5F, 4.0F}) {
        whipple_f32_system_t system;
        whipple_f32_state_space_t space;
        carvallo_system_error_t error = whipple_f32_at_speed(&matrices, speed, bicycle.g, &system);
        if (error == CARVALLO_SYSTEM_OK) {
            error = whipple_f32_state_space(&system, &space);
        }
        if (error != CARVALLO_SYSTEM_OK) {
            std::fprintf(stderr, "error: %s\n", carvallo_system_error_text(error));
            return 1;
        }
        const float alone = largest_lean(space, speed, false);
        const float steered = largest_lean(space, speed, true);
        std::printf("%12.1f   %10.3g %10.3g\n", double{speed}, double{alone}, double{steered});
        is_balanced = is_balanced && (steered < alone);
    }
    return is_balanced ? 0 : 1;
}
