// Where a bicycle with a longer or shorter wheel base is stable: many designs at once, on all cores.

#include "carvallo.h"

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <vector>

namespace {

struct Free {
    void operator()(carvallo_machine_t *machine) const { carvallo_machine_free(machine); }
};
using Machine = std::unique_ptr<carvallo_machine_t, Free>;

void require(carvallo_status_t status)
{
    if (status != CARVALLO_STATUS_OK) {
        throw std::runtime_error(carvallo_message());
    }
}

Machine shipped(const char *model, const char *parameters)
{
    carvallo_machine_t *machine = nullptr;
    require(carvallo_machine_new(model, parameters, &machine));
    return Machine(machine);
}

} // namespace

int main(int argc, char **argv)
try {
    const Machine bicycle = shipped("Whipple", (argc > 1) ? argv[1] : "benchmark");
    double wheel_base = 0.0;
    require(carvallo_machine_get(bicycle.get(), "w", &wheel_base));

    std::vector<double> wheel_bases;
    for (int percent = -10; percent <= 10; percent++) {
        wheel_bases.push_back(wheel_base * (1.0 + 0.01 * percent));
    }
    const carvallo_column_t column = {"w", wheel_bases.data()};
    std::vector<carvallo_summary_t> found(wheel_bases.size());
    require(carvallo_batch_stability(bicycle.get(), &column, 1, found.size(), 0, found.data(), nullptr, 0));

    std::puts("wheel base in m   stable from, to in m/s");
    for (std::size_t i = 0; i < found.size(); i++) {
        if (found[i].status != CARVALLO_STATUS_OK) {
            std::printf("%15.4f   has no answer\n", wheel_bases[i]);
        } else if (found[i].stable_ranges == 0) {
            std::printf("%15.4f   nowhere\n", wheel_bases[i]);
        } else {
            std::printf("%15.4f   %.6f, %.6f\n", wheel_bases[i], found[i].stable.from, found[i].stable.to);
        }
    }
    return 0;
} catch (const std::exception &error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
}
