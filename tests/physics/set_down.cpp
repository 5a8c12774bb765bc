#include "calib/height_monitor.h"
#include "tests/physics/checks.h"
#include "tests/physics/potentiometer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace tractus::physics {

namespace {

constexpr double kSeconds = 60;
constexpr double kRow_s = 10; // The string slips in the middle of it.
constexpr double kLowest_mm = 50;

// A hand that draws: rests and minimum-jerk movements, one after the other. Occasionally it may let
// the surface down to its stop. There the surface stays for one or two seconds, within a tenth of a
// millimetre.
class Hand {
public:
    explicit Hand(Dice& dice, double sets_down_part = 0)
        : dice_(dice)
        , sets_down_part_(sets_down_part)
    {
    }

    double height_mm(double seconds)
    {
        while (seconds >= ends_s_)
            begin_next();
        double const u = (seconds - begins_s_) / (ends_s_ - begins_s_);
        return from_mm_ + (to_mm_ - from_mm_) * u * u * u * (10 + u * (6 * u - 15));
    }

private:
    void begin_next()
    {
        begins_s_ = ends_s_;
        from_mm_ = to_mm_;
        bool const was_set_down = std::exchange(is_set_down_, false);
        if (sets_down_part_ > 0 && !was_set_down && uniform(dice_, 0, 1) < sets_down_part_) {
            is_set_down_ = true;
        }
        if (was_set_down) {
            ends_s_ += uniform(dice_, 1, 2); // The surface rests at its stop.
            return;
        }
        if (is_set_down_) {
            to_mm_ = kLowest_mm + normal(dice_, 0.1);
            ends_s_ += std::max(0.25, 1.875 * std::abs(to_mm_ - from_mm_) / 400);
            return;
        }
        bool const rests = uniform(dice_, 0, 1) < 0.3;
        if (!rests)
            to_mm_ = std::clamp(to_mm_ + uniform(dice_, -150, 150), kLowest_mm, 350.0);
        // The maximum speed is 400 mm/s.
        double const min_s = 1.875 * std::abs(to_mm_ - from_mm_) / 400;
        ends_s_ = begins_s_ + std::max(0.25, min_s) + uniform(dice_, 0, 1);
    }

    Dice& dice_;
    double sets_down_part_ = 0;
    bool is_set_down_ = false;
    double begins_s_ = 0;
    double ends_s_ = 0;
    double from_mm_ = 200;
    double to_mm_ = 200;
};

struct Slip {
    double mm = 0;
    double lasts_s = 0;
};

// Returns a monitor that has watched a hand whose string slips halfway through.
calib::HeightMonitor watch(Slip const& slip, Hand hand, double seconds, Dice& dice)
{
    calib::Rig rig;
    rig.height_model = calib::LinearHeight { .mm_per_count = 0.1, .zero_counts = 0 };
    calib::HeightMonitor monitor(rig);
    for (double t = 0; t < seconds; t += 0.002) {
        double const part = (t - seconds / 2) / std::max(slip.lasts_s, 1e-9);
        double const slipped_mm = slip.mm * std::clamp(part, 0.0, 1.0);
        double const counts = 10 * (hand.height_mm(t) + slipped_mm) + normal(dice, 1);
        monitor.push({ .time = Timestamp(std::chrono::nanoseconds(std::llround(t * 1e9))),
                       .counts = static_cast<int>(std::lround(counts)),
                       .full_scale = 4095 });
    }
    return monitor;
}

std::size_t jumps(Slip const& slip, double seconds, Dice& dice)
{
    return watch(slip, Hand(dice), seconds, dice).total(calib::HeightFaultKind::Jump).count;
}

// Returns how often a moved stop is reported for a surface that is let down occasionally.
std::size_t moved_stops(Slip const& slip, double sets_down_part, double seconds, Dice& dice)
{
    return watch(slip, Hand(dice, sets_down_part), seconds, dice)
        .total(calib::HeightFaultKind::Stop)
        .count;
}

bool run_row(double mm, double lasts_s, double goal, Run const& run)
{
    unsigned found = 0;
    std::string missed;
    for (unsigned seed = run.first_seed; seed < run.end_seed(); ++seed) {
        Dice dice(seed);
        if (jumps({ .mm = uniform(dice, 0, 1) < 0.5 ? -mm : mm, .lasts_s = lasts_s }, kRow_s, dice)
            > 0)
            ++found;
        else
            missed.append(1, ' ').append(std::to_string(seed));
    }
    double const part = static_cast<double>(found) / run.rigs;
    std::printf("slip of %2.0f mm in %3.0f ms: found %5.1f %%\n", mm, 1000 * lasts_s, 100 * part);
    if (!missed.empty() && missed.size() < 400)
        std::printf("  seeds that missed:%s\n", missed.c_str());
    bool const is_good = is_enough(part, goal, run);
    if (!is_good)
        std::printf("  MISSES ITS GOAL of %.0f %%\n", 100 * goal);
    return is_good;
}

// Checks slips that only a change of the surface's lowest stop reveals. A run takes ten minutes, in
// which the surface is let down about twenty times before the slip and twenty times after it. Then
// checks runs without a slip, and runs in which the surface is not let down.
bool check_moved_stops(Run const& run)
{
    constexpr double kLong_s = 600;
    constexpr double kSetsDown = 0.1;
    unsigned const rigs = std::max(1U, run.rigs / 10);
    Run const fewer { .rigs = rigs, .first_seed = run.first_seed };
    bool all_good = true;
    for (double const mm : { -5.0, 5.0 }) {
        unsigned found = 0;
        for (unsigned seed = fewer.first_seed; seed < fewer.end_seed(); ++seed) {
            Dice dice(seed);
            found += moved_stops({ .mm = mm, .lasts_s = 0.2 }, kSetsDown, kLong_s, dice) > 0;
        }
        std::printf("slip of %+2.0f mm in 200 ms, surface set down: found by its stop %5.1f %%\n",
                    mm, 100.0 * found / rigs);
        all_good &= is_enough(static_cast<double>(found) / rigs, 0.9, fewer);
    }
    std::size_t alarms = 0;
    for (unsigned seed = fewer.first_seed; seed < fewer.end_seed(); ++seed)
        for (double const sets_down : { 0.0, kSetsDown }) {
            Dice dice(seed);
            alarms += moved_stops({}, sets_down, kLong_s, dice);
        }
    std::printf("no slip: %zu stops told to have moved in %.1f hours\n", alarms,
                2 * rigs * kLong_s / 3600);
    if (!all_good)
        std::printf("  MISSES ITS GOAL of 90 %%\n");
    return all_good && alarms == 0;
}

bool check_false_alarms(Run const& run)
{
    std::size_t alarms = 0;
    for (unsigned seed = run.first_seed; seed < run.end_seed(); ++seed) {
        Dice dice(seed);
        alarms += jumps({}, kSeconds, dice);
    }
    std::printf("no slip: %zu alarms in %.1f hours\n", alarms, run.rigs * kSeconds / 3600);
    return alarms == 0;
}

} // namespace

bool check_set_down(Run const& run)
{
    std::printf("\nSurface set down: slips of a string while a hand moves the table, 0.1 mm of "
                "noise at 500 Hz\n");
    bool all_good = check_false_alarms(run);
    all_good &= check_moved_stops(run);
    for (double const mm : { 5.0, 20.0 })
        for (double const lasts_s : { 0.0, 0.01, 0.03 })
            all_good &= run_row(mm, lasts_s, 0.9, run);
    for (double const lasts_s : { 0.1, 0.2 })
        all_good &= run_row(20, lasts_s, 0, run);
    return all_good;
}

} // namespace tractus::physics
