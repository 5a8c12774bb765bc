#include "calib/latency_fit.h"
#include "tests/physics/checks.h"
#include "tests/physics/potentiometer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

namespace tractus::physics {

namespace {

struct Scenario {
    char const* name = "";
    double drag_mm = 0;       // Play within which the pen's tip lags.
    double hysteresis_mm = 0; // Play within which the string's end lags.
    double most_ms = 0.5;
    double min_part = 0.99;
};

std::vector<Scenario> scenarios()
{
    return {
        { .name = "neither", .most_ms = 0.2, .min_part = 0.9 },
        { .name = "drag of 0.5 mm", .drag_mm = 0.5 },
        { .name = "drag of 1 mm", .drag_mm = 1, .min_part = 0.9 },
        { .name = "hysteresis of 0.8 mm", .hysteresis_mm = 0.8 },
        { .name = "both", .drag_mm = 0.5, .hysteresis_mm = 0.8, .min_part = 0.95 },
    };
}

// Follows a position like a part with play of the given width.
class Follower {
public:
    explicit Follower(double width)
        : half_(width / 2)
    {
    }
    double follow(double leader)
    {
        place_ = is_first_ ? leader : std::clamp(place_, leader - half_, leader + half_);
        is_first_ = false;
        return place_;
    }

private:
    double half_ = 0;
    double place_ = 0;
    bool is_first_ = true;
};

// Returns the height of a table that a hand moves up and down at varying speed.
double hand_mm(double seconds, double phase)
{
    double const slow = std::sin(2 * std::numbers::pi * 0.11 * seconds + phase);
    return 200 + (90 + 30 * slow) * std::sin(2 * std::numbers::pi * 0.45 * seconds + 2 * slow);
}

Timestamp at(double seconds)
{
    return Timestamp(std::chrono::nanoseconds(std::llround(seconds * 1e9)));
}

struct Recording {
    std::vector<drivers::PenSample> pens {};
    std::vector<drivers::HeightSample> heights {};
};

// Records twenty seconds along an inclined edge, with the pen delayed relative to the height.
Recording record(Scenario const& scenario, double delay_s, Dice& dice)
{
    constexpr double kSeconds = 20;
    constexpr double kStep_s = 0.0005;
    Follower tip(scenario.drag_mm);
    Follower string(scenario.hysteresis_mm);
    double const phase = uniform(dice, 0, 6);
    double const run = uniform(dice, 0.4, 0.9);
    double tremor_mm = 0;
    double next_height_s = 1;
    double next_pen_s = 1;
    Recording recording;
    for (double t = 1; t < 1 + kSeconds; t += kStep_s) {
        double const height = hand_mm(t, phase);
        tremor_mm
            += -tremor_mm * kStep_s / 0.05 + normal(dice, 0.1 * std::sqrt(2 * kStep_s / 0.05));
        double const x = tip.follow(20 + run * (height - 50)) + tremor_mm;
        double const end = string.follow(height);
        if (t >= next_height_s) {
            next_height_s += 0.002;
            recording.heights.push_back(
                { .time = at(t),
                  .counts = static_cast<int>(std::lround(10 * end + normal(dice, 1))),
                  .full_scale = 4095 });
        }
        if (t >= next_pen_s) {
            next_pen_s += 0.0075;
            recording.pens.push_back({ .time = at(t + delay_s),
                                       .position_mm = { x, 80 },
                                       .pressure = 1,
                                       .in_range = true,
                                       .touching = true });
        }
    }
    return recording;
}

bool run_row(Scenario const& scenario, Run const& run)
{
    std::vector<double> errors;
    std::string missed;
    unsigned good = 0;
    unsigned within = 0;
    for (unsigned seed = run.first_seed; seed < run.end_seed(); ++seed) {
        Dice dice(seed);
        double const delay_s = uniform(dice, -0.01, 0.03);
        auto const recording = record(scenario, delay_s, dice);
        calib::Rig rig;
        rig.height_model = calib::LinearHeight { .mm_per_count = 0.1, .zero_counts = 0 };
        auto const fit = calib::fit_latency(recording.pens, recording.heights, rig);
        double const error = fit ? fit->delay_ms - 1000 * delay_s : 1e3;
        errors.push_back(std::abs(error));
        bool const is_good = std::abs(error) <= scenario.most_ms;
        good += is_good;
        within += fit && std::abs(error) <= 3 * fit->error_ms;
        if (!is_good)
            missed.append(1, ' ').append(std::to_string(seed));
    }
    std::sort(errors.begin(), errors.end());
    double const part = static_cast<double>(good) / run.rigs;
    std::printf("%-22s off by median %5.2f  95 %% %5.2f  worst %5.2f ms  within %.1f ms %5.1f %%  "
                "within 3 SE %5.1f %%\n",
                scenario.name, errors[errors.size() / 2], errors[errors.size() * 95 / 100],
                errors.back(), scenario.most_ms, 100 * part, 100.0 * within / run.rigs);
    if (!missed.empty())
        std::printf("  seeds that missed:%s\n", missed.c_str());
    bool const is_good = is_enough(part, scenario.min_part, run);
    if (!is_good)
        std::printf("  MISSES ITS GOAL of %.0f %%\n", 100 * scenario.min_part);
    return is_good;
}

} // namespace

bool check_latency(Run const& run)
{
    std::printf("\nLatency: of a pen against a height sensor, along a leaning edge for 20 s\n");
    bool all_good = true;
    for (auto const& scenario : scenarios())
        all_good &= run_row(scenario, run);
    return all_good;
}

} // namespace tractus::physics
