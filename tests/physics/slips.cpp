#include "calib/height_monitor.h"
#include "tests/physics/checks.h"
#include "tests/physics/surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace tractus::physics {

namespace {

struct Slip {
    double mm = 0;
    double lasts_s = 0;
    double begins_s = 0;
    bool is_smooth = false; // True: with minimum jerk; false: at a constant speed.

    double slipped_mm(double seconds) const
    {
        double const u = std::clamp((seconds - begins_s) / std::max(lasts_s, 1e-9), 0.0, 1.0);
        return mm * (is_smooth ? u * u * u * (10 + u * (6 * u - 15)) : u);
    }
};

// How a height sensor's readings arrive.
struct Sensor {
    char const* name = "";
    double period_s = 0.002;
    double noise_mm = 0.1;
    double count_mm = 0.1;
    double jitter_s = 0; // Greatest random delay.
    double lost_part = 0;
    double batch_s = 0; // Interval at which waiting readings arrive together.
    // At the end of each three seconds the computer reads nothing for this time. The kernel keeps
    // the first 64 readings, which then arrive together.
    double stall_s = 0;
};

constexpr Sensor kUsual { .name = "500/s, 0.1 mm" };
constexpr std::array kSensors {
    kUsual,
    Sensor { .name = "ragged", .jitter_s = 0.002, .lost_part = 0.1 },
    Sensor { .name = "100/s", .period_s = 0.01, .noise_mm = 0.03 },
    Sensor { .name = "fine", .noise_mm = 0.02, .count_mm = 0.02 },
    Sensor { .name = "coarse", .noise_mm = 0.1, .count_mm = 0.4 },
    Sensor { .name = "in batches", .batch_s = 0.008 },
    Sensor { .name = "stalling", .stall_s = 0.12 },
};

// Returns the time at which a reading arrives; negative if it is lost.
double arrival_s(double taken_s, Sensor const& sensor, Dice& dice)
{
    constexpr double kStallsEvery_s = 3;
    constexpr double kKept = 64;
    if (sensor.lost_part > 0 && uniform(dice, 0, 1) < sensor.lost_part)
        return -1;
    double const next_s = std::ceil(taken_s / kStallsEvery_s) * kStallsEvery_s;
    double const stalled_s = taken_s - (next_s - sensor.stall_s);
    if (stalled_s > 0)
        return stalled_s < kKept * sensor.period_s ? next_s : -1;
    if (sensor.batch_s > 0)
        return std::ceil(taken_s / sensor.batch_s) * sensor.batch_s;
    return taken_s + (sensor.jitter_s > 0 ? uniform(dice, 0, sensor.jitter_s) : 0);
}

// Returns a monitor that has watched a surface whose string slips.
calib::HeightMonitor watch(Movement const& movement, Slip const& slip, double seconds,
                           Sensor const& sensor, Dice& dice)
{
    constexpr int kZeroCounts = 1000;
    calib::Rig rig;
    rig.full_scale_counts = 65535;
    rig.height_model
        = calib::LinearHeight { .mm_per_count = sensor.count_mm, .zero_counts = kZeroCounts };
    calib::HeightMonitor monitor(rig);
    for (double t = 0; t < seconds; t += sensor.period_s) {
        double const mm = movement(t) + slip.slipped_mm(t) + normal(dice, sensor.noise_mm);
        double const arrives_s = arrival_s(t, sensor, dice);
        if (arrives_s < 0)
            continue;
        monitor.push({ .time = Timestamp(Duration(std::llround(arrives_s * 1e9))),
                       .counts = kZeroCounts + static_cast<int>(std::lround(mm / sensor.count_mm)),
                       .full_scale = rig.full_scale_counts });
    }
    return monitor;
}

std::size_t count(calib::HeightMonitor const& monitor, calib::HeightFaultKind kind)
{
    return monitor.total(kind).count;
}

// The surface rests, moves, or moves with a drawing hand's tremor while the string slips.
enum class State { Rests, Moves, Draws };
constexpr std::array kStates { State::Rests, State::Moves, State::Draws };

Movement surface_in(State state, Dice& dice)
{
    constexpr double kTremor_mm = 0.05;
    switch (state) {
    case State::Rests:
        return still();
    case State::Moves:
        return drawing_hand(dice);
    case State::Draws:
        return trembling(drawing_hand(dice), kTremor_mm, dice);
    }
    return still();
}

// Returns the share of slips that are found as they happen.
double part_found(Slip slip, State state, Run const& run)
{
    constexpr double kAfter_s = 1.5;
    unsigned found = 0;
    for (unsigned seed = run.first_seed; seed < run.end_seed(); ++seed) {
        Dice dice(seed);
        auto const movement = surface_in(state, dice);
        auto happened = slip;
        happened.begins_s = uniform(dice, 1.5, 3.5);
        happened.mm = uniform(dice, 0, 1) < 0.5 ? -slip.mm : slip.mm;
        auto const monitor = watch(movement, happened, happened.begins_s + kAfter_s, kUsual, dice);
        found += count(monitor, calib::HeightFaultKind::Jump) > 0;
    }
    return static_cast<double>(found) / run.rigs;
}

bool run_row(Slip const& slip, double goal, Run const& run)
{
    std::printf("%2.0f mm in %3.0f ms%s, %4.0f mm/s: found at rest, moving, drawing", slip.mm,
                1000 * slip.lasts_s, slip.is_smooth ? ", smooth" : "", slip.mm / slip.lasts_s);
    bool is_good = true;
    for (auto const state : kStates) {
        double const part = part_found(slip, state, run);
        std::printf(" %5.1f", 100 * part);
        is_good &= is_enough(part, goal, run);
    }
    std::printf(" %%\n");
    if (!is_good)
        std::printf("  MISSES ITS GOAL of %.0f %%\n", 100 * goal);
    return is_good;
}

// Checks slips at a constant speed. Those of 100 mm/s and more have to be found.
bool check_rows(Run const& run)
{
    constexpr double kSure_mm_per_s = 100;
    bool all_good = true;
    for (double const mm : { 5.0, 10.0, 20.0, 60.0 })
        for (double const lasts_s : { 0.03, 0.05, 0.1, 0.2 }) {
            bool const is_sure = mm / lasts_s >= kSure_mm_per_s * (1 - 1e-9);
            all_good &= run_row({ .mm = mm, .lasts_s = lasts_s }, is_sure ? 0.9 : 0, run);
        }
    for (double const lasts_s : { 0.05, 0.1, 0.2 })
        run_row({ .mm = 20, .lasts_s = lasts_s, .is_smooth = true }, 0, run);
    return all_good;
}

// Checks slips that are no more abrupt than a hand, and so revealed only by the stops of the
// surface's travel: within one more minute, after a minute in which the surface came to them. This
// hand comes to each stop three or four times a minute, which is often too seldom.
bool check_stops(Run const& run)
{
    constexpr double kMinute_s = 60;
    constexpr double kGoal = 0.6;
    bool all_good = true;
    for (double const mm : { 5.0, 20.0 })
        for (bool const is_smooth : { false, true }) {
            unsigned found = 0;
            for (unsigned seed = run.first_seed; seed < run.end_seed(); ++seed) {
                Dice dice(seed);
                Slip const slip { .mm = uniform(dice, 0, 1) < 0.5 ? -mm : mm,
                                  .lasts_s = 0.2,
                                  .begins_s = kMinute_s,
                                  .is_smooth = is_smooth };
                auto const monitor = watch(drawing_hand(dice), slip, 2 * kMinute_s, kUsual, dice);
                found += count(monitor, calib::HeightFaultKind::Jump)
                        + count(monitor, calib::HeightFaultKind::Stop)
                    > 0;
            }
            double const part = static_cast<double>(found) / run.rigs;
            std::printf("%2.0f mm in 200 ms%s, travel from stop to stop: found within a minute "
                        "%5.1f %%\n",
                        mm, is_smooth ? ", smooth" : "", 100 * part);
            all_good &= is_enough(part, kGoal, run);
        }
    if (!all_good)
        std::printf("  MISSES ITS GOAL of %.0f %%\n", 100 * kGoal);
    return all_good;
}

struct Surface {
    char const* name = "";
    Movement movement {};
};

std::vector<Surface> unkind_surfaces(Dice& dice)
{
    constexpr double kTremor_mm = 0.3;
    return { { "drawing hand", drawing_hand(dice) },
             { "hasty hand", hasty_hand(dice) },
             { "motor", motor(dice) },
             { "rubbing surface", rubbing_surface(dice) },
             { "hand with tremor", trembling(drawing_hand(dice), kTremor_mm, dice) },
             { "hasty hand with tremor", trembling(hasty_hand(dice), kTremor_mm, dice) } };
}

// Checks that no slip is reported where there is none. Each run has another surface and sensor.
bool check_false_alarms(Run const& run)
{
    constexpr double kSeconds = 60;
    std::vector<std::string> alarms;
    for (unsigned seed = run.first_seed; seed < run.end_seed(); ++seed) {
        Dice dice(seed);
        auto const surfaces = unkind_surfaces(dice);
        auto const& [name, movement] = surfaces[seed % surfaces.size()];
        auto const& sensor = kSensors[seed % kSensors.size()];
        auto const monitor = watch(movement, {}, kSeconds, sensor, dice);
        for (auto const kind : { calib::HeightFaultKind::Jump, calib::HeightFaultKind::Stop })
            if (monitor.total(kind).worst.step_mm != 0)
                alarms.push_back(std::string(name) + ", sensor " + sensor.name + ", seed "
                                 + std::to_string(seed) + ": "
                                 + calib::describe_fault(monitor.total(kind).worst));
    }
    std::printf("no slip: %zu alarms in %.1f hours\n", alarms.size(), run.rigs * kSeconds / 3600);
    for (auto const& alarm : alarms)
        std::printf("  %s\n", alarm.c_str());
    if (!alarms.empty())
        std::printf("  MISSES ITS GOAL of no alarm\n");
    return alarms.empty();
}

} // namespace

bool check_slips(Run const& run)
{
    std::printf("\nSlips: of a string, 0.1 mm of noise at 500 Hz\n");
    Run const fewer { .rigs = std::max(1U, run.rigs / 5), .first_seed = run.first_seed };
    Run const few { .rigs = std::max(1U, run.rigs / 10), .first_seed = run.first_seed };
    bool all_good = check_false_alarms(run);
    all_good &= check_stops(few);
    all_good &= check_rows(fewer);
    return all_good;
}

} // namespace tractus::physics
