// Calibrates rigs with independently modelled physics, and measures their errors.
//
//   tractus_physics [RIGS [FIRST_SEED [CHECK...]]]
//
// CHECK is heights, zeroing, fusing, latency, slips, set_down or tilt; by default all checks are
// run. The rigs of a row have the seeds from FIRST_SEED on; the seeds of those that miss the row's
// goal are printed. Exit code 1 if a row with a goal misses it.

#include "tests/physics/checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace tractus::physics {

namespace {

struct Check {
    char const* name = "";
    bool (*run)(Run const&) = nullptr;
};

constexpr std::array kChecks {
    Check { "heights", check_heights }, Check { "zeroing", check_zeroing },
    Check { "fusing", check_fusing },   Check { "latency", check_latency },
    Check { "slips", check_slips },     Check { "set_down", check_set_down },
    Check { "tilt", check_tilt },
};

bool is_wanted(char const* name, int count, char** arguments)
{
    constexpr int kFirst = 3;
    return count <= kFirst
        || std::any_of(arguments + kFirst, arguments + count,
                       [&](char const* one) { return std::strcmp(one, name) == 0; });
}

} // namespace

bool is_enough(double part, double goal, Run const& run)
{
    return part >= goal - 2 * std::sqrt(goal * (1 - goal) / run.rigs);
}

} // namespace tractus::physics

int main(int count, char** arguments)
{
    auto const number = [&](int i, unsigned otherwise) {
        return count > i ? static_cast<unsigned>(std::strtoul(arguments[i], nullptr, 10))
                         : otherwise;
    };
    tractus::physics::Run const run { .rigs = std::max(1U, number(1, 60)),
                                      .first_seed = number(2, 1) };
    std::printf("%u rigs a row, seeds from %u\n", run.rigs, run.first_seed);
    bool all_good = true;
    for (auto const& check : tractus::physics::kChecks)
        if (tractus::physics::is_wanted(check.name, count, arguments))
            all_good &= check.run(run);
    return all_good ? 0 : 1;
}
