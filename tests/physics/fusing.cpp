#include "tests/physics/checks.h"
#include "tests/physics/movement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace tractus::physics {

namespace {

// Tips before this time are ignored, because the first tips have too few readings before them.
constexpr double kBegins_s = 0.2;

double rms_mm(std::vector<Tip> const& tips, double from_s = kBegins_s)
{
    double squares = 0;
    int count = 0;
    for (auto const& tip : tips)
        if (tip.seconds > from_s) {
            squares += tip.error_mm * tip.error_mm;
            ++count;
        }
    return std::sqrt(squares / std::max(count, 1));
}

double most_mm(std::vector<Tip> const& tips, double from_s, double to_s)
{
    double most = 0;
    for (auto const& tip : tips)
        if (tip.seconds > from_s && tip.seconds < to_s)
            most = std::max(most, std::abs(tip.error_mm));
    return most;
}

struct Row {
    std::vector<double> values {};
    std::string missed {};
};

// Runs a trial for each rig of a run; a rig whose result is greater than `most` is a miss.
template<typename Trial> Row measure(Run const& run, double most, Trial const& trial)
{
    Row row;
    for (unsigned seed = run.first_seed; seed < run.end_seed(); ++seed) {
        Dice dice(seed);
        row.values.push_back(trial(dice));
        if (row.values.back() > most)
            row.missed.append(1, ' ').append(std::to_string(seed));
    }
    std::sort(row.values.begin(), row.values.end());
    return row;
}

bool print(char const* name, Row const& row, double most, double goal, Run const& run)
{
    auto const& values = row.values;
    auto const good = std::upper_bound(values.begin(), values.end(), most) - values.begin();
    double const part = static_cast<double>(good) / run.rigs;
    std::printf("%-56s median %5.2f  95 %% %5.2f  worst %5.2f  at most %.2f: %5.1f %%\n", name,
                values[values.size() / 2], values[values.size() * 95 / 100], values.back(), most,
                100 * part);
    if (!row.missed.empty() && row.missed.size() < 400)
        std::printf("  seeds that missed:%s\n", row.missed.c_str());
    bool const is_good = is_enough(part, goal, run);
    if (!is_good)
        std::printf("  MISSES ITS GOAL of %.0f %%\n", 100 * goal);
    return is_good;
}

bool check_lag(Run const& run)
{
    bool all_good = true;
    for (double const rate_hz : { 73.0, 100.0, 150.0, 250.0, 500.0 })
        for (double const speed : { 50.0, 400.0 }) {
            char name[64];
            std::vector<double> settled;
            auto const row = measure(run, 0.5, [&](Dice& dice) {
                auto const tips = fuse(sway(speed), { .height_hz = rate_hz }, dice);
                settled.push_back(rms_mm(tips.settled));
                return rms_mm(tips.live);
            });
            std::sort(settled.begin(), settled.end());
            std::snprintf(name, sizeof name, "live RMS, %3.0f Hz, %3.0f mm/s (settled %.2f)",
                          rate_hz, speed, settled[settled.size() / 2]);
            all_good &= print(name, row, 0.5, 0.95, run);
        }
    return all_good;
}

// Checks how far tips overshoot when the table stops.
bool check_stops(Run const& run)
{
    bool all_good = true;
    for (double const rate_hz : { 73.0, 150.0, 500.0 })
        for (double const stopping_s : { 0.0, 0.04 }) {
            char name[64];
            std::snprintf(name, sizeof name, "overshoot, %3.0f Hz, stop in %2.0f ms, mm", rate_hz,
                          1000 * stopping_s);
            auto const row = measure(run, 0.5, [&](Dice& dice) {
                auto const tips
                    = fuse(stop(300, stopping_s), { .seconds = 1.5, .height_hz = rate_hz }, dice);
                double most = 0;
                for (auto const& tip : tips.live)
                    if (tip.seconds > 1 + stopping_s / 2)
                        most = std::max(most, tip.error_mm);
                return most;
            });
            all_good &= print(name, row, 0.5, 0, run);
        }
    return all_good;
}

bool check_gaps(Run const& run)
{
    auto const gap = [&](Movement const& movement, double noise_counts) {
        return measure(run, 0.5, [&](Dice& dice) {
            double const from_s = uniform(dice, 1, 2);
            auto const tips = fuse(
                movement,
                { .noise_counts = noise_counts, .gap_from_s = from_s, .gap_to_s = from_s + 0.03 },
                dice);
            return most_mm(tips.settled, from_s - 0.02, from_s + 0.05);
        });
    };
    bool all_good = true;
    all_good &= print("gap of 30 ms, still, mm", gap(sway(0), 1), 0.5, 0.99, run);
    all_good &= print("gap of 30 ms, still, noise of 0.3 mm, mm", gap(sway(0), 3), 0.5, 0.65, run);
    all_good &= print("gap of 30 ms, sway of 300 mm/s, mm", gap(sway(300), 1), 0.5, 0.99, run);
    auto const spikes = measure(run, 0.5, [&](Dice& dice) {
        return most_mm(fuse(sway(200), { .spike_part = 0.01 }, dice).settled, kBegins_s, 3.9);
    });
    all_good &= print("spikes of 30 mm, one in a hundred, mm", spikes, 0.5, 0.75, run);
    // The limit is the distance covered in 5 ms at 300 mm/s, plus a tenth of a millimetre.
    auto const lost = measure(run, 1.6, [&](Dice& dice) {
        auto const tips = fuse(stop(300, 0), { .gap_from_s = 0.998, .gap_to_s = 9 }, dice);
        return most_mm(tips.settled, 0.9, 1.1);
    });
    all_good &= print("sensor lost at a stop from 300 mm/s, mm", lost, 1.6, 0.95, run);
    return all_good;
}

struct Bursts {
    char const* name = "";
    double burst_s = 0;
    double most_burst_s = 0;
    double lost_part = 0;
    bool pens_come_first = false;
    double most_times = 1.5; // Limit of the median error, as a multiple of that without bursts.
    double min_part = 0.95;
};

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

// The kind of a fuser's tips, live or settled, that a check evaluates.
struct Looked {
    char const* name = "";
    std::vector<Tip> Tips::*tips = nullptr;
};

constexpr Looked kSettled { .name = "settled", .tips = &Tips::settled };
constexpr Looked kLive { .name = "live", .tips = &Tips::live };

bool check_bursts(Looked const& looked, Bursts const& bursts, double speed_mm_per_s, Run const& run)
{
    constexpr double kLearnt_s = 1;
    std::vector<double> none;
    std::vector<double> as_arrived;
    auto const row = measure(run, 0.5, [&](Dice& dice) {
        Sampling sampling { .height_hz = uniform(dice, 490, 510),
                            .pen_hz = uniform(dice, 126, 140),
                            .lost_part = bursts.lost_part,
                            .pens_come_first = bursts.pens_come_first };
        auto const off_mm = [&] {
            auto same = dice;
            return rms_mm(fuse(sway(speed_mm_per_s), sampling, same).*looked.tips, kLearnt_s);
        };
        none.push_back(off_mm());
        sampling.burst_s = bursts.burst_s;
        sampling.most_burst_s = bursts.most_burst_s;
        as_arrived.push_back(off_mm());
        sampling.sample_times = calib::SampleTimes::Evened;
        return off_mm();
    });
    char name[80];
    std::snprintf(name, sizeof name, "%s, %s, %3.0f mm/s (none %.3f, as arrived %.2f)", looked.name,
                  bursts.name, speed_mm_per_s, median(none), median(as_arrived));
    bool const is_good = print(name, row, 0.5, bursts.min_part, run);
    double const times = median(row.values) / median(none);
    if (times > bursts.most_times)
        std::printf("  MISSES ITS GOAL: %.2f times the error without bursts, not %.1f\n", times,
                    bursts.most_times);
    return is_good && times <= bursts.most_times;
}

// Checks tips of devices whose rates are unrelated to the rate of bursts, as with separate clocks.
bool check_bursts(Run const& run)
{
    bool all_good = true;
    for (Bursts const& bursts :
         { Bursts { .name = "bursts of 8 ms", .burst_s = 0.008 },
           Bursts { .name = "bursts of 16 ms", .burst_s = 0.016 },
           Bursts { .name = "bursts of 32 ms", .burst_s = 0.032, .most_times = 3 },
           Bursts { .name = "bursts of 8 to 30 ms",
                    .burst_s = 0.008,
                    .most_burst_s = 0.03,
                    .most_times = 2 },
           Bursts { .name = "16 ms, one in 1000 lost",
                    .burst_s = 0.016,
                    .lost_part = 0.001,
                    .most_times = 5,
                    .min_part = 0.85 } })
        for (double const speed : { 50.0, 200.0, 400.0 })
            all_good &= check_bursts(kSettled, bursts, speed, run);
    for (Bursts const& bursts : { Bursts { .name = "bursts of 8 ms", .burst_s = 0.008 },
                                  Bursts { .name = "bursts of 16 ms", .burst_s = 0.016 },
                                  Bursts { .name = "bursts of 32 ms", .burst_s = 0.032 },
                                  Bursts { .name = "8 ms, pens first",
                                           .burst_s = 0.008,
                                           .pens_come_first = true,
                                           .most_times = 4 },
                                  Bursts { .name = "16 ms, pens first",
                                           .burst_s = 0.016,
                                           .pens_come_first = true,
                                           .most_times = 6,
                                           .min_part = 0.8 },
                                  Bursts { .name = "32 ms, pens first",
                                           .burst_s = 0.032,
                                           .pens_come_first = true,
                                           .most_times = 12,
                                           .min_part = 0 } })
        for (double const speed : { 50.0, 400.0 })
            all_good &= check_bursts(kLive, bursts, speed, run);
    return all_good;
}

} // namespace

bool check_fusing(Run const& run)
{
    std::printf(
        "\nFusing: heights of tips, of a sensor with 0.1 mm of noise and a pen of 133 Hz\n");
    bool const is_prompt = check_lag(run);
    bool const stops = check_stops(run);
    bool const is_evened = check_bursts(run);
    return check_gaps(run) && is_prompt && stops && is_evened;
}

} // namespace tractus::physics
