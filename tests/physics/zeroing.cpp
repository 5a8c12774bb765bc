#include "app/calibration/log_calibration.h"
#include "drivers/logs/log.h"
#include "tests/physics/capture_log.h"
#include "tests/physics/checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace tractus::physics {

namespace {

// A calibrated rig that is changed and then zeroed.
struct Scenario {
    char const* name = "";
    double slip_mm = 0; // Slip of the string.
    double move_mm = 0; // Movement of the table's zero.
    std::vector<double> zeroed_at_mm { 0 };
    // Required share of the rigs whose error is at most kLoss_mm greater than before.
    double min_part = 0;
};

constexpr double kLoss_mm = 0.5;

std::vector<Scenario> scenarios()
{
    return {
        { .name = "slip of 5 mm", .slip_mm = 5, .min_part = 0.9 },
        { .name = "move of 5 mm", .move_mm = 5 },
        { .name = "slip, two heights", .slip_mm = 5, .zeroed_at_mm = { 0, 350 }, .min_part = 0.95 },
        { .name = "move, two heights", .move_mm = 5, .zeroed_at_mm = { 0, 350 }, .min_part = 0.85 },
    };
}

calibration::CalibrationOutcome calibrate(Potentiometer const& sensor,
                                          std::vector<double> const& heights_mm,
                                          calibration::CalibrationController::Options options,
                                          Dice& dice)
{
    Person const person { .heights_mm = heights_mm, .stated_mm = heights_mm };
    auto const log = drivers::parse_log(capture_log(sensor, 4095, person, dice), "physics");
    auto outcome = log ? calibration::calibrate_from_log(*log, std::move(options), "2026-11-24")
                       : Result<calibration::CalibrationOutcome>(tl::unexpected(log.error()));
    if (!outcome) {
        std::fprintf(stderr, "%s\n", outcome.error().message.c_str());
        std::exit(2);
    }
    return *outcome;
}

double rms_mm(calib::Rig const& rig, Potentiometer const& sensor)
{
    double squares = 0;
    int count = 0;
    for (double height = 0; height <= 400; height += 5, ++count)
        squares += std::pow(
            calib::height_mm(rig.height_model, sensor.counts(height)).value_or(1e3) - height, 2);
    return std::sqrt(squares / count);
}

bool run_row(Scenario const& scenario, Run const& run)
{
    std::vector<double> losses;
    std::string missed;
    for (unsigned seed = run.first_seed; seed < run.end_seed(); ++seed) {
        Dice dice(seed);
        Geometry geometry { .offset_mm = uniform(dice, 0, 150), .base_mm = uniform(dice, 60, 300) };
        Potentiometer sensor(geometry, {}, dice);
        auto const rig = calibrate(sensor, { 0, 60, 200, 400, 300, 120, 20 }, {}, dice).rig;
        double const before_mm = rms_mm(rig, sensor);
        sensor.befall(scenario.slip_mm, scenario.move_mm);
        auto const after
            = calibrate(sensor, scenario.zeroed_at_mm,
                        { .procedure = calibration::CalibrationProcedure::Zero, .rig = rig }, dice)
                  .rig;
        losses.push_back(rms_mm(after, sensor) - before_mm);
        if (losses.back() > kLoss_mm)
            missed.append(1, ' ').append(std::to_string(seed));
    }
    std::sort(losses.begin(), losses.end());
    auto const good = std::upper_bound(losses.begin(), losses.end(), kLoss_mm) - losses.begin();
    double const part = static_cast<double>(good) / run.rigs;
    std::printf("%-22s loses median %5.2f  95 %% %5.2f  worst %5.2f mm  good %5.1f %%\n",
                scenario.name, losses[losses.size() / 2], losses[losses.size() * 95 / 100],
                losses.back(), 100 * part);
    if (!missed.empty())
        std::printf("  seeds that missed:%s\n", missed.c_str());
    bool const is_good = is_enough(part, scenario.min_part, run);
    if (!is_good)
        std::printf("  MISSES ITS GOAL of %.0f %%\n", 100 * scenario.min_part);
    return is_good;
}

} // namespace

bool check_zeroing(Run const& run)
{
    std::printf(
        "\nZeroing: how many millimetres RMS a rig loses by what befell it, once zeroed at 0 "
        "mm, or at 0 and 350; good is at most 0.5\n");
    bool all_good = true;
    for (auto const& scenario : scenarios())
        all_good &= run_row(scenario, run);
    return all_good;
}

} // namespace tractus::physics
