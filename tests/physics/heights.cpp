#include "app/calibration/log_calibration.h"
#include "calib/rig_file.h"
#include "drivers/logs/log.h"
#include "tests/physics/capture_log.h"
#include "tests/physics/checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::physics {

namespace {

using Heights = std::vector<double>;

enum class Mistake { None, TwoSwapped, OneFalse, ThreeFalse, Centimetres };

enum class Desk {
    Usual, // The spool is below; the string uses 8 % of a 600 mm track at height zero.
    Plumb, // The string is vertical, from above or below; its length and share are random.
    // Everything is random: string, share, offset, rest height, side of the spool, wiring,
    // converter.
    Any,
};

// A row of the table: a kind of rig and how it is calibrated.
struct Scenario {
    char const* name = "";
    Heights heights_mm {};
    Desk desk = Desk::Usual;
    double track_mm = 600;       // String length of the usual desk.
    bool follows_advice = false; // True: the person gives the linearity named in a refusal.
    Faults faults {};
    Mistake mistake = Mistake::None;
    double linearity_percent = 0; // Linearity from the data sheet.
    // Required share of the rigs that are within kGoal_mm or are refused. 0: no share is required,
    // and the share is only printed.
    double min_part = 0;
    bool is_covered = false; // True: the standard errors must cover the errors, see is_covered().
    double ruler_error_mm = 0.3;
    double stated_ruler_error_mm = 0.3;
};

constexpr double kGoal_mm = 0.5;

Heights const kFive { 0, 60, 160, 280, 400 };
Heights const kSeven { 0, 60, 200, 400, 300, 120, 20 };
Heights const kTen { 0, 60, 200, 400, 300, 120, 20, 250, 350, 160 };

// Returns rows with rigs that deviate from the models, measured without a mistake.
std::vector<Scenario> honest_scenarios()
{
    return {
        { .name = "five captures", .heights_mm = kFive, .min_part = 0.95, .is_covered = true },
        { .name = "seven captures", .heights_mm = kSeven, .min_part = 0.95, .is_covered = true },
        { .name = "pulley of 6 mm",
          .heights_mm = kSeven,
          .faults = { .pulley_radius_mm = 6 },
          .min_part = 0.95,
          .is_covered = true },
        { .name = "noise, hum and drift",
          .heights_mm = kSeven,
          .faults = { .noise_counts = 2, .hum_counts = 3, .drift_counts_per_s = 0.05 },
          .min_part = 0.9,
          .is_covered = true },
        { .name = "hysteresis 0.8 mm",
          .heights_mm = kSeven,
          .faults = { .hysteresis_mm = 0.8 },
          .min_part = 0.9,
          .is_covered = true },
        { .name = "ruler read to 0.6 mm", .heights_mm = kSeven, .ruler_error_mm = 0.6 },
        { .name = "nonlinear by 0.25 %",
          .heights_mm = kSeven,
          .faults = { .nonlinearity = 0.0025 },
          .min_part = 0.95,
          .is_covered = true },
        { .name = "nonlinear by 1 %", .heights_mm = kSeven, .faults = { .nonlinearity = 0.01 } },
        { .name = "loading 1.5 %",
          .heights_mm = kSeven,
          .faults = { .loading = 0.015 },
          .min_part = 0.95,
          .is_covered = true },
    };
}

// Returns rows in which the linearity of the track, or the ruler's error, is given.
std::vector<Scenario> stated_scenarios()
{
    return {
        { .name = "straight, told 0.25 %",
          .heights_mm = kSeven,
          .linearity_percent = 0.25,
          .min_part = 0.95,
          .is_covered = true },
        { .name = "0.25 %, told",
          .heights_mm = kSeven,
          .faults = { .nonlinearity = 0.0025 },
          .linearity_percent = 0.25,
          .min_part = 0.95,
          .is_covered = true },
        { .name = "1 %, told",
          .heights_mm = kSeven,
          .faults = { .nonlinearity = 0.01 },
          .linearity_percent = 1,
          .min_part = 0.95,
          .is_covered = true },
        { .name = "one false of seven, told",
          .heights_mm = kSeven,
          .mistake = Mistake::OneFalse,
          .linearity_percent = 0.25 },
        { .name = "ruler of 0.6 mm, told",
          .heights_mm = kSeven,
          .is_covered = true,
          .ruler_error_mm = 0.6,
          .stated_ruler_error_mm = 0.6 },
        { .name = "loading 1.5 %, told",
          .heights_mm = kSeven,
          .faults = { .loading = 0.015 },
          .linearity_percent = 0.25,
          .min_part = 0.95,
          .is_covered = true },
    };
}

// Returns rows with typical desks and the potentiometer recommended in the parts list: a linearity
// of 0.5 %, and 10 kiloohms loaded by 100 kiloohms of the converter.
std::vector<Scenario> drawn_scenarios()
{
    Faults const recommended { .nonlinearity = 0.005, .loading = 0.1 };
    return {
        { .name = "any desk, five",
          .heights_mm = kFive,
          .desk = Desk::Any,
          .min_part = 0.95,
          .is_covered = true },
        { .name = "any desk, seven",
          .heights_mm = kSeven,
          .desk = Desk::Any,
          .min_part = 0.95,
          .is_covered = true },
        { .name = "plumb, five, 0.25 %",
          .heights_mm = kFive,
          .desk = Desk::Plumb,
          .follows_advice = true,
          .faults = { .nonlinearity = 0.0025 },
          .min_part = 0.95 },
        { .name = "plumb, seven, 0.25 %",
          .heights_mm = kSeven,
          .desk = Desk::Plumb,
          .follows_advice = true,
          .faults = { .nonlinearity = 0.0025 },
          .min_part = 0.95 },
        { .name = "440 mm, 10k into 100k",
          .heights_mm = kSeven,
          .track_mm = 440,
          .follows_advice = true,
          .faults = { .loading = 0.1 },
          .min_part = 0.95 },
        { .name = "any desk, recommended",
          .heights_mm = kSeven,
          .desk = Desk::Any,
          .follows_advice = true,
          .faults = recommended,
          .min_part = 0.95 },
        { .name = "any desk, 1 %, advised",
          .heights_mm = kSeven,
          .desk = Desk::Any,
          .follows_advice = true,
          .faults = { .nonlinearity = 0.01 } },
    };
}

std::vector<Scenario> mistaken_scenarios()
{
    return {
        { .name = "two swapped of ten",
          .heights_mm = kTen,
          .mistake = Mistake::TwoSwapped,
          .min_part = 0.99 },
        { .name = "three false of ten",
          .heights_mm = kTen,
          .mistake = Mistake::ThreeFalse,
          .min_part = 0.99 },
        { .name = "one false of five", .heights_mm = kFive, .mistake = Mistake::OneFalse },
        { .name = "one false of seven",
          .heights_mm = kSeven,
          .mistake = Mistake::OneFalse,
          .min_part = 0.9 },
        { .name = "centimetres",
          .heights_mm = kSeven,
          .mistake = Mistake::Centimetres,
          .min_part = 1 },
    };
}

std::vector<Scenario> scenarios()
{
    auto all = honest_scenarios();
    for (auto const& more : { stated_scenarios(), drawn_scenarios(), mistaken_scenarios() })
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

Heights told(Scenario const& scenario, Dice& dice)
{
    auto heights = scenario.heights_mm;
    if (scenario.mistake == Mistake::TwoSwapped) {
        auto const first = std::uniform_int_distribution<std::size_t>(0, heights.size() - 2)(dice);
        std::swap(heights[first], heights[first + 1]);
    }
    if (scenario.mistake == Mistake::Centimetres)
        for (double& height : heights)
            height /= 10;
    auto const falsify = [&](std::size_t i) {
        heights[i] += uniform(dice, 5, 20) * (uniform(dice, 0, 1) < 0.5 ? -1 : 1);
    };
    if (scenario.mistake == Mistake::ThreeFalse)
        for (std::size_t const i : { 1U, 4U, 8U })
            falsify(i);
    if (scenario.mistake == Mistake::OneFalse)
        falsify(std::uniform_int_distribution<std::size_t>(0, heights.size() - 1)(dice));
    return heights;
}

struct Trial {
    std::optional<double> rms_mm {}; // No value if the fit was refused.
    std::string refusal {};
    std::vector<double> deviations {}; // Errors divided by their standard errors.
    bool is_unreadable = false;        // True if the rig's file cannot be read.
    // True if readings of heights from 0 to 400 mm have no height.
    bool lacks_heights = false;
};

constexpr double kTravel_mm = 400;

// Chooses a string for which the track is long enough, with a margin at either end.
void draw_string(Geometry& geometry, Dice& dice)
{
    auto const string_mm = [&](double height_mm) {
        return std::hypot(geometry.offset_mm,
                          geometry.base_mm + (geometry.is_spool_above ? -height_mm : height_mm));
    };
    double const used_mm = std::abs(string_mm(kTravel_mm) - string_mm(0));
    geometry.track_mm = std::max(uniform(dice, 440, 1000), 1.05 * used_mm);
    double const share = used_mm / geometry.track_mm;
    double const shortest = uniform(dice, 0.02, 0.98 - share);
    geometry.first_part = geometry.is_spool_above ? shortest + share : shortest;
    geometry.counts_down = uniform(dice, 0, 1) < 0.3;
    double const converter = uniform(dice, 0, 1);
    geometry.full_scale = converter < 0.7 ? 4095 : converter < 0.85 ? 1023 : 65535;
}

Geometry draw_desk(Scenario const& scenario, Dice& dice)
{
    Geometry geometry { .offset_mm = uniform(dice, 0, 150),
                        .base_mm = uniform(dice, 60, 300),
                        .track_mm = scenario.track_mm };
    if (scenario.desk == Desk::Usual)
        return geometry;
    bool const is_plumb = scenario.desk == Desk::Plumb || uniform(dice, 0, 1) < 0.25;
    if (is_plumb)
        geometry.offset_mm = 0;
    geometry.is_spool_above = uniform(dice, 0, 1) < (is_plumb ? 0.5 : 0.3);
    if (geometry.is_spool_above)
        geometry.base_mm += kTravel_mm;
    draw_string(geometry, dice);
    return geometry;
}

// Returns the linearity that a refusal suggests with --linearity; no value if it suggests none.
std::optional<double> advised_linearity_percent(std::string const& refusal)
{
    static constexpr std::string_view kOption = "--linearity ";
    auto const at = refusal.find(kOption);
    if (at == std::string::npos)
        return std::nullopt;
    return std::strtod(refusal.c_str() + at + kOption.size(), nullptr);
}

Result<calibration::CalibrationOutcome> calibrate(Scenario const& scenario, drivers::Log const& log)
{
    calibration::CalibrationController::Options options;
    options.height.linearity_percent = scenario.linearity_percent;
    options.height.ruler_error_mm = scenario.stated_ruler_error_mm;
    auto outcome = calibration::calibrate_from_log(log, options, "2026-11-24");
    if (outcome || !scenario.follows_advice)
        return outcome;
    auto const advised = advised_linearity_percent(outcome.error().message);
    if (!advised)
        return outcome;
    options.height.linearity_percent = *advised;
    return calibration::calibrate_from_log(log, options, "2026-11-24");
}

// Compares the heights of the calibrated rig, as read from its file, with the sensor's.
void compare(calibration::CalibrationOutcome const& outcome, Potentiometer const& sensor,
             Trial& trial)
{
    auto const rig = calib::parse_rig(calib::print_rig(outcome.rig), "physics.rig.toml");
    if (!rig) {
        std::printf("  unreadable: %s\n", rig.error().message.c_str());
        trial.is_unreadable = true;
        return;
    }
    double squares = 0;
    int count = 0;
    for (double height = 0; height <= kTravel_mm; height += 5, ++count) {
        double const counts = sensor.counts(height);
        auto const height_mm = calib::height_mm(rig->height_model, counts);
        trial.lacks_heights |= !height_mm;
        double const error = height_mm.value_or(1e3) - height;
        squares += error * error;
        trial.deviations.push_back(
            error / std::max(1e-9, calib::height_error_mm(*outcome.height_fit, counts)));
    }
    trial.rms_mm = std::sqrt(squares / count);
}

Trial try_rig(Scenario const& scenario, unsigned seed)
{
    Dice dice(seed);
    auto const geometry = draw_desk(scenario, dice);
    Potentiometer const sensor(geometry, scenario.faults, dice);
    Person person { .heights_mm = scenario.heights_mm,
                    .stated_mm = told(scenario, dice),
                    .ruler_error_mm = scenario.ruler_error_mm };
    if (scenario.mistake == Mistake::Centimetres)
        person.ruler_error_mm /= 10;
    auto const log
        = drivers::parse_log(capture_log(sensor, geometry.full_scale, person, dice), "physics");
    if (!log) {
        std::fprintf(stderr, "seed %u: %s\n", seed, log.error().message.c_str());
        std::exit(2);
    }
    auto const outcome = calibrate(scenario, *log);
    Trial trial;
    if (outcome)
        compare(*outcome, sensor, trial);
    else
        trial.refusal = outcome.error().message;
    return trial;
}

double part_within(std::vector<double> const& values, double limit)
{
    auto const within = std::count_if(values.begin(), values.end(),
                                      [&](double value) { return std::abs(value) <= limit; });
    return values.empty() ? 0 : static_cast<double>(within) / static_cast<double>(values.size());
}

double quantile(std::vector<double>& sorted, double part)
{
    if (sorted.empty())
        return 0;
    return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

// True if the calibrated curve lies within 1, 2 and 3 standard errors of the true one as often as
// required. Errors at points of one curve are correlated, so a rig counts as two values.
bool is_covered(std::vector<double> const& deviations, Run const& run)
{
    struct Goal {
        double limit = 0;
        double least = 0;
        double most = 1;
    };
    auto const slack
        = [&](double part) { return 2 * std::sqrt(part * (1 - part) / (2 * run.rigs)); };
    for (Goal const& goal :
         { Goal { 1, 0.65, 0.75 }, Goal { 2, 0.93, 0.98 }, Goal { 3, 0.99, 1 } }) {
        double const part = part_within(deviations, goal.limit);
        if (part < goal.least - slack(goal.least) || part > goal.most + slack(goal.most))
            return false;
    }
    return true;
}

// Runs a row of the table. Returns false if the row has a goal and misses it.
bool run_row(Scenario const& scenario, Run const& run)
{
    std::vector<double> errors;
    std::vector<double> deviations;
    std::string missed;
    std::string refusal;
    unsigned good = 0;
    unsigned broken = 0; // Rigs whose files cannot be read, or that lack heights for some readings.
    for (unsigned seed = run.first_seed; seed < run.end_seed(); ++seed) {
        auto const trial = try_rig(scenario, seed);
        bool const is_good
            = trial.rms_mm ? *trial.rms_mm <= kGoal_mm : scenario.mistake != Mistake::None;
        good += is_good;
        broken += trial.is_unreadable || trial.lacks_heights;
        if (!is_good)
            missed.append(1, ' ').append(std::to_string(seed));
        if (!trial.rms_mm) {
            refusal = trial.refusal;
            continue;
        }
        errors.push_back(*trial.rms_mm);
        deviations.insert(deviations.end(), trial.deviations.begin(), trial.deviations.end());
    }
    std::sort(errors.begin(), errors.end());
    double const part = static_cast<double>(good) / run.rigs;
    std::printf("%-22s %4zu fitted %4zu refused  median %6.2f  95 %% %6.2f mm  good %5.1f %%  "
                "within 1, 2, 3 SE %3.0f %3.0f %3.0f %%\n",
                scenario.name, errors.size(), run.rigs - errors.size(), quantile(errors, 0.5),
                quantile(errors, 0.95), 100 * part, 100 * part_within(deviations, 1),
                100 * part_within(deviations, 2), 100 * part_within(deviations, 3));
    if (!refusal.empty())
        std::printf("  refused: %s\n", refusal.c_str());
    if (!missed.empty())
        std::printf("  seeds that missed:%s\n", missed.c_str());
    if (broken > 0)
        std::printf("  MISSES ITS GOAL: %u rigs cannot be read or lack heights\n", broken);
    bool const is_good = is_enough(part, scenario.min_part, run);
    if (!is_good)
        std::printf("  MISSES ITS GOAL of %.0f %%\n", 100 * scenario.min_part);
    bool const is_within_stated_error = !scenario.is_covered || is_covered(deviations, run);
    if (!is_within_stated_error)
        std::printf("  MISSES ITS GOAL of 65 to 75, 93 to 98, 99 %% within 1, 2, 3 SE\n");
    return is_good && is_within_stated_error && broken == 0;
}

} // namespace

bool check_heights(Run const& run)
{
    std::printf(
        "\nHeights: offsets of 0 to 150 mm, bases of 60 to 300 mm; good is at most 0.5 mm, or "
        "refused where captures are wrong\n");
    bool all_good = true;
    for (auto const& scenario : scenarios())
        all_good &= run_row(scenario, run);
    return all_good;
}

} // namespace tractus::physics
