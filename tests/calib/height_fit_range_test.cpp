#include "calib/height_fit_range.h"

#include "calib/calibrate.h"
#include "calib/height_fit_doubt.h"
#include "calib/rig_file.h"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <random>

namespace tractus::calib {
namespace {

std::vector<double> const kFiveHeights_mm { 0, 60, 160, 280, 400 };

std::vector<HeightCapture> exact_captures(HeightModel const& sensor,
                                          std::vector<double> const& heights_mm)
{
    std::vector<HeightCapture> captures;
    for (double const mm : heights_mm)
        captures.push_back(
            { .ruler_mm = mm, .counts = counts_at_height(sensor, mm).value(), .readings = 100 });
    assign_directions(captures);
    return captures;
}

std::string refused_range(HeightFit const& fit, std::vector<HeightCapture> const& captures)
{
    auto const checked = check_range(fit, captures, {});
    return checked ? "" : checked.error().message;
}

StringHeight const kAslantString {
    .mm_per_count = 0.15, .zero_length_mm = 100, .offset_mm = 120, .base_mm = 90
};

TEST(HeightFitRange, HasNothingAgainstAStringThatGoesOnBeyondTheCaptures)
{
    auto const captures = exact_captures(kAslantString, kFiveHeights_mm);
    EXPECT_EQ(refused_range(fit_height(captures).value(), captures), "");
}

TEST(HeightFitRange, RefusesALawThatEndsLessThanATenthBeyondTheCaptures)
{
    auto const captures = exact_captures(kAslantString, kFiveHeights_mm);
    auto fit = fit_height(captures, { .kind = HeightModelKind::String }).value();
    auto& string = std::get<StringHeight>(fit.model);
    string.base_mm = 39; // The string's law then ends at a height of -39 mm.
    EXPECT_NE(refused_range(fit, captures).find("law ends before -40 mm"), std::string::npos)
        << refused_range(fit, captures);
    string.base_mm = 41;
    EXPECT_EQ(refused_range(fit, captures), "");
}

TEST(HeightFitRange, RefusesALawThatHasNoHeightForACapture)
{
    auto const captures = exact_captures(kAslantString, kFiveHeights_mm);
    auto fit = fit_height(captures, { .kind = HeightModelKind::String }).value();
    std::get<StringHeight>(fit.model).offset_mm = 170;
    EXPECT_NE(refused_range(fit, captures).find("ends at a reading of"), std::string::npos)
        << refused_range(fit, captures);
}

TEST(HeightFitRange, RefusesHeightsThatTheCapturesLeaveOpen)
{
    auto const captures = exact_captures(kAslantString, kFiveHeights_mm);
    auto fit = fit_height(captures, { .kind = HeightModelKind::String }).value();
    fit.covariance *= 1e4;
    EXPECT_NE(refused_range(fit, captures).find("capture more heights near it"), std::string::npos)
        << refused_range(fit, captures);
}

// True if a rig has heights throughout its calibrated range and a tenth of its length beyond each
// end.
bool has_all_heights(Rig const& rig)
{
    auto const span = rig.calibration.height->heights_mm;
    double const beyond_mm = 0.099 * (span.y() - span.x());
    for (double mm = span.x() - beyond_mm; mm <= span.y() + beyond_mm; mm += 5) {
        auto const counts = counts_at_height(rig.height_model, mm);
        if (!counts || std::abs(height_mm(rig.height_model, *counts).value_or(1e9) - mm) > 1e-3)
            return false;
    }
    return check_calibrated_range(rig).has_value();
}

// Returns a random sensor: strings from vertical to far to the side, spools below and above,
// converters that count up and down.
HeightModel random_sensor(std::mt19937_64& dice)
{
    auto const uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(dice);
    };
    bool const is_above = uniform(0, 1) < 0.5;
    double const sign = uniform(0, 1) < 0.3 ? -1 : 1;
    double const offset_mm = uniform(0, 1) < 0.5 ? 0 : uniform(0, 150);
    return StringHeight { .mm_per_count = sign * uniform(0.1, 0.25),
                          .zero_length_mm = sign > 0 ? 0 : 1000.0,
                          .offset_mm = offset_mm,
                          .base_mm = is_above ? -uniform(460, 700) : uniform(60, 300),
                          .spool
                          = is_above ? StringHeight::Spool::Above : StringHeight::Spool::Below };
}

// Returns captures with a ruler's error of 0.3 mm, and with a track that one or two sine waves bend
// by a millimetre.
std::vector<HeightCapture> measured_captures(HeightModel const& sensor, std::mt19937_64& dice)
{
    auto captures = exact_captures(sensor, kFiveHeights_mm);
    std::normal_distribution<double> normal;
    double const first = 5 * normal(dice);
    double const second = 3 * normal(dice);
    for (auto& capture : captures) {
        double const part = capture.counts / 4095;
        capture.ruler_mm = std::round((capture.ruler_mm + 0.3 * normal(dice)) * 10) / 10;
        capture.counts += first * std::sin(3 * part) + second * std::sin(6 * part);
    }
    return captures;
}

TEST(HeightFitRange, IsWholeInEveryRigThatIsKept)
{
    int kept = 0;
    constexpr unsigned kDrawnRigs = 60;
    for (unsigned seed = 1; seed <= kDrawnRigs; ++seed) {
        std::mt19937_64 dice(seed);
        auto const captures = measured_captures(random_sensor(dice), dice);
        auto const fit = fit_height(captures);
        if (!fit || doubt_about(*fit, captures, {}) || !check_range(*fit, captures, {}))
            continue;
        auto const rig = with_height(
            {}, { .fit = *fit, .captures = captures, .full_scale_counts = 8191 }, "2026-11-29");
        auto const again = parse_rig(print_rig(rig), "some.rig.toml");
        ASSERT_TRUE(again) << "seed " << seed << ": " << again.error().message;
        EXPECT_TRUE(has_all_heights(*again)) << "seed " << seed;
        ++kept;
    }
    // Some rigs with a bent track may be refused.
    EXPECT_GE(kept, static_cast<int>(kDrawnRigs * 8 / 10));
}

TEST(HeightFitRange, NothingIsWrittenThatNobodyCouldRead)
{
    auto const path = std::filesystem::path(::testing::TempDir()) / "tractus-unreadable.rig.toml";
    std::filesystem::remove(path);
    Rig rig;
    rig.height_model = StringHeight { .mm_per_count = 0.1, .offset_mm = 100, .base_mm = 0 };
    // At this reading the string is 90 mm long, shorter than its offset.
    rig.calibrated_min_counts = 900;
    rig.calibrated_max_counts = 3000;
    auto const saved = save_rig(rig, path);
    ASSERT_FALSE(saved);
    EXPECT_NE(saved.error().message.find("was not written"), std::string::npos)
        << saved.error().message;
    EXPECT_FALSE(std::filesystem::exists(path));
}

} // namespace
} // namespace tractus::calib
