#include "calib/height_fit.h"
#include "calib/latency_fit.h"
#include "calib/travel_fit.h"
#include "drivers/height_decoders.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/tablets/pen_decoders.h"
#include "engine/base/random.h"
#include "sim/simulated_person.h"
#include "sim/simulated_rig.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <gtest/gtest.h>

// Compares calibration with the truth in a hundred cases for each promised accuracy. The
// distributions of errors are stored as test properties and shown in failure messages.

namespace tractus::calib {
namespace {

constexpr std::uint64_t kSeeds = 100;

// Seven heights, closer together where the string of the simulated rig is farthest from vertical.
constexpr double kHeights[] { 0, 20, 60, 120, 200, 300, 400 };

class Distribution {
public:
    void add(double value) { values_.push_back(value); }

    double quantile(double part) const
    {
        auto sorted = values_;
        std::sort(sorted.begin(), sorted.end());
        return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
    }
    double greatest() const { return quantile(1); }
    double rms() const
    {
        double squares = 0;
        for (double const value : values_)
            squares += value * value;
        return std::sqrt(squares / static_cast<double>(values_.size()));
    }
    std::string text() const
    {
        return fmt::format("median {:.3g}, 95 % {:.3g}, greatest {:.3g}", quantile(0.5),
                           quantile(0.95), greatest());
    }

private:
    std::vector<double> values_;
};

struct HeightErrors {
    double rms_mm = 0;
    double max_mm = 0;
};

HeightErrors errors_of(HeightFit const& fit, HeightModel const& truth)
{
    HeightErrors errors;
    double squares = 0;
    int count = 0;
    for (double counts = fit.low_counts; counts <= fit.high_counts; counts += 4, ++count) {
        double const error = *height_mm(fit.model, counts) - *height_mm(truth, counts);
        squares += error * error;
        errors.max_mm = std::max(errors.max_mm, std::abs(error));
    }
    errors.rms_mm = std::sqrt(squares / count);
    return errors;
}

TEST(CalibrationQuality, HeightsAreRightOverTheCalibratedRange)
{
    sim::RigGeometry const geometry;
    auto const truth = sim::true_rig(geometry).height_model;
    Distribution rms;
    Distribution greatest;
    Distribution worst_parameter;
    int strings = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        auto const captures = sim::simulate_captures(geometry, kHeights, { .seed = seed });
        auto const fit = fit_height(captures).value();
        auto const errors = errors_of(fit, truth);
        rms.add(errors.rms_mm);
        greatest.add(errors.max_mm);
        strings += std::holds_alternative<StringHeight>(fit.model);
        if (!std::holds_alternative<StringHeight>(fit.model))
            continue;
        double worst = 0;
        for (std::size_t i = 0; i < 4; ++i)
            worst = std::max(worst,
                             std::abs(fit.parameters[i].value
                                      - parameters_of(truth)[static_cast<Eigen::Index>(i)])
                                 / fit.parameters[i].standard_error);
        worst_parameter.add(worst);
    }
    RecordProperty("rms_mm", rms.text());
    RecordProperty("max_mm", greatest.text());
    RecordProperty("worst_parameter_in_standard_errors", worst_parameter.text());
    EXPECT_EQ(strings, kSeeds);
    EXPECT_LE(rms.greatest(), 0.5) << rms.text();
    EXPECT_LE(greatest.greatest(), 1.2) << greatest.text();
    EXPECT_LE(worst_parameter.quantile(0.99), 3) << worst_parameter.text();
    EXPECT_GT(worst_parameter.quantile(0.5), 0.3) << "errors that are no exaggeration, either";
}

TEST(CalibrationQuality, OneSlippedCaptureIsNamedAndDoesNoHarm)
{
    sim::RigGeometry const geometry;
    auto const truth = sim::true_rig(geometry).height_model;
    int found = 0;
    Distribution clean;
    Distribution slipped;
    std::string missed;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        Random random({ .seed = seed, .stream = 1 });
        sim::Slip const slip { .capture = random.next_u32() % std::size(kHeights),
                               .wrong_by_mm = random.uniform() < 0.5 ? -20.0 : 20.0 };
        auto const good = fit_height(sim::simulate_captures(geometry, kHeights, { .seed = seed }));
        auto const bad = fit_height(
            sim::simulate_captures(geometry, kHeights, { .seed = seed, .slip = slip }));
        ASSERT_TRUE(good && bad);
        bool const is_found = bad->slipped == std::vector<std::size_t> { slip.capture };
        found += is_found;
        if (is_found) {
            clean.add(errors_of(*good, truth).rms_mm);
            slipped.add(errors_of(*bad, truth).rms_mm);
        } else {
            missed += fmt::format("seed {}: capture {} by {} mm; ", seed, slip.capture + 1,
                                  slip.wrong_by_mm);
        }
    }
    RecordProperty("found_of_100", found);
    RecordProperty("missed", missed);
    RecordProperty("clean_rms_mm", clean.text());
    RecordProperty("slipped_rms_mm", slipped.text());
    EXPECT_GE(found, 95) << missed;
    EXPECT_LE(slipped.rms(), 1.5 * clean.rms()) << slipped.text() << " / " << clean.text();
}

// Pen and height samples of a simulated run.
struct Samples {
    std::vector<drivers::PenSample> pens;
    std::vector<drivers::HeightSample> heights;
};

Samples decode(sim::SimulatedRun const& run)
{
    Samples samples;
    auto const pen = drivers::make_pen_decoder(run.tablet.info).value();
    auto const height = drivers::make_height_decoder(run.height.info).value();
    for (auto const& report : run.tablet.reports)
        EXPECT_TRUE(pen->decode(report, samples.pens));
    for (auto const& report : run.height.reports)
        EXPECT_TRUE(height->decode(report, samples.heights));
    return samples;
}

// Returns a hand that moves along a straight edge, `times` times up and `times` times down, as fast
// as a hand can move the carriage.
sim::Hand follow_edge(Vec3 const& low_mm, Vec3 const& high_mm, int times, std::uint64_t seed)
{
    std::vector<sim::HandStroke> strokes;
    for (int i = 0; i < times; ++i) {
        strokes.push_back(
            { .path = sim::make_path(sim::LineShape { low_mm, high_mm }), .speed_mm_s = 220 });
        strokes.push_back(
            { .path = sim::make_path(sim::LineShape { high_mm, low_mm }), .speed_mm_s = 220 });
    }
    return sim::Hand(std::move(strokes), { .seed = seed });
}

TEST(CalibrationQuality, ShearIsFoundToTwoMillimetresPerMetre)
{
    Distribution errors;
    Distribution in_standard_errors;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        Random random({ .seed = seed, .stream = 2 });
        sim::SimulatedRigOptions options { .seed = seed };
        options.geometry.travel_shear
            = { random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05) };
        options.geometry.rotation_deg = random.uniform(-3, 3);
        auto const hand = follow_edge({ 10, 5, 20 }, { 10, 5, 380 }, 2, seed);
        auto const run = sim::simulate_rig(hand, options);
        auto const samples = decode(run);
        auto rig = run.rig;
        rig.travel_shear = Vec2::Zero();
        auto const fit = fit_travel(samples.pens, samples.heights, rig).value();
        Vec2 const error = fit.shear - options.geometry.travel_shear;
        errors.add(error.cwiseAbs().maxCoeff());
        in_standard_errors.add(error.cwiseQuotient(fit.shear_error).cwiseAbs().maxCoeff());
    }
    RecordProperty("shear_error", errors.text());
    RecordProperty("in_standard_errors", in_standard_errors.text());
    EXPECT_LE(errors.greatest(), 0.002) << errors.text();
    EXPECT_LE(in_standard_errors.quantile(0.99), 4) << in_standard_errors.text();
}

TEST(CalibrationQuality, TheDelayIsFoundToHalfAMillisecond)
{
    Distribution errors_ms;
    Distribution in_standard_errors;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
        Random random({ .seed = seed, .stream = 3 });
        sim::SimulatedRigOptions options { .seed = seed };
        options.tablet.timing.latency = from_seconds(random.uniform(0.001, 0.030));
        options.height.timing.latency = from_seconds(random.uniform(0.001, 0.020));
        auto const hand = follow_edge({ -80, -30, 60 }, { 80, 30, 300 }, 3, seed);
        auto const run = sim::simulate_rig(hand, options);
        auto const samples = decode(run);
        auto rig = run.rig;
        rig.tablet_latency = rig.height_latency = Duration {};
        auto const fit = fit_latency(samples.pens, samples.heights, rig).value();
        double const truth_ms
            = 1000 * to_seconds(options.tablet.timing.latency - options.height.timing.latency);
        errors_ms.add(std::abs(fit.delay_ms - truth_ms));
        in_standard_errors.add(std::abs(fit.delay_ms - truth_ms) / fit.error_ms);
    }
    RecordProperty("delay_error_ms", errors_ms.text());
    RecordProperty("in_standard_errors", in_standard_errors.text());
    EXPECT_LE(errors_ms.greatest(), 0.5) << errors_ms.text();
    EXPECT_LE(in_standard_errors.quantile(0.99), 4) << in_standard_errors.text();
}

} // namespace
} // namespace tractus::calib
