#include "calib/height_fit.h"
#include "calib/height_fit_doubt.h"

#include <cmath>
#include <gtest/gtest.h>

namespace tractus::calib {
namespace {

HeightCapture capture(double ruler_mm, double counts)
{
    return { .ruler_mm = ruler_mm, .counts = counts, .noise_counts = 1, .readings = 500 };
}

// Returns captures of a sensor by a person without error.
std::vector<HeightCapture> captures_of(HeightModel const& model, std::vector<double> const& heights)
{
    std::vector<HeightCapture> captures;
    for (double const height : heights)
        captures.push_back(capture(height, counts_at_height(model, height).value()));
    assign_directions(captures);
    return captures;
}

std::vector<double> const kRulerHeights { 0, 20, 60, 120, 200, 300, 400 };

LinearHeight const kFittedLinear { .mm_per_count = 0.12, .zero_counts = 150 };
StringHeight const kFittedString {
    .mm_per_count = 0.1, .zero_length_mm = 124, .offset_mm = 120, .base_mm = 80
};

std::string fit_refusal(std::vector<HeightCapture> const& captures,
                        HeightFitOptions const& options = {})
{
    auto const fit = fit_height(captures, options);
    if (fit)
        return "fitted";
    EXPECT_EQ(fit.error().fault, Fault::User);
    return fit.error().message;
}

TEST(HeightFit, FindsALinearSensor)
{
    auto const fit = fit_height(captures_of(kFittedLinear, kRulerHeights)).value();
    auto const& model = std::get<LinearHeight>(fit.model);
    EXPECT_NEAR(model.mm_per_count, 0.12, 1e-9);
    EXPECT_NEAR(model.zero_counts, 150, 1e-6);
    EXPECT_NEAR(fit.low_mm, 0, 1e-6);
    EXPECT_NEAR(fit.high_mm, 400, 1e-6);
    EXPECT_LT(fit.max_mm, 1e-6);
}

// Options that request a string; the track is then straight, so exact captures give the exact law.
HeightFitOptions const kStraightString { .kind = HeightModelKind::String };

TEST(HeightFit, FindsAString)
{
    auto const chosen = fit_height(captures_of(kFittedString, kRulerHeights)).value();
    ASSERT_TRUE(std::holds_alternative<StringHeight>(chosen.model));
    EXPECT_LT(chosen.max_mm, 0.01);
    auto const fit = fit_height(captures_of(kFittedString, kRulerHeights), kStraightString).value();
    auto const& model = std::get<StringHeight>(fit.model);
    EXPECT_NEAR(model.offset_mm, 120, 0.01);
    EXPECT_NEAR(model.base_mm, 80, 0.01);
    EXPECT_NEAR(model.mm_per_count, 0.1, 1e-5);
    EXPECT_EQ(model.spool, StringHeight::Spool::Below);
    EXPECT_NE(chosen.reason.find("string: it gains more than chance"), std::string::npos);
}

// Most of the evidence for a string comes from one capture, which must not be taken for a slip.
TEST(HeightFit, TakesFiveCapturesOfAStringForAString)
{
    auto captures = captures_of(kFittedString, { 0, 60, 160, 280, 400 });
    double const errors[] { 0.2, -0.3, 0.1, 0.25, -0.15 };
    for (std::size_t i = 0; i < captures.size(); ++i)
        captures[i].ruler_mm += errors[i];
    auto const fit = fit_height(captures).value();
    EXPECT_EQ(name_of(fit.model), "string");
    EXPECT_TRUE(fit.slipped.empty());
    for (double height = 0; height <= 400; height += 10)
        EXPECT_NEAR(height_mm(fit.model, *counts_at_height(kFittedString, height)).value(), height,
                    0.8);
}

// Returns the captures with the potentiometer's outer wires swapped.
std::vector<HeightCapture> counting_down(std::vector<HeightCapture> captures)
{
    for (auto& one : captures)
        one.counts = 4095 - one.counts;
    return captures;
}

TEST(HeightFit, TakesSensorsThatCountDown)
{
    for (auto const& sensor : { HeightModel(kFittedLinear), HeightModel(kFittedString) }) {
        auto const fit = fit_height(counting_down(captures_of(sensor, kRulerHeights))).value();
        EXPECT_EQ(fit.model.index(), sensor.index());
        EXPECT_LT(parameters_of(fit.model)[0], 0) << "millimetres per count";
        EXPECT_NEAR(height_mm(fit.model, 4095 - *counts_at_height(sensor, 250)).value(), 250, 1e-3);
        EXPECT_LT(fit.low_counts, fit.high_counts);
        EXPECT_LT(fit.low_mm, fit.high_mm);
    }
}

TEST(HeightFit, TakesASpoolAboveTheCarriage)
{
    StringHeight const above { .mm_per_count = 0.1,
                               .zero_length_mm = 124,
                               .offset_mm = 120,
                               .base_mm = -480,
                               .spool = StringHeight::Spool::Above };
    auto const captures = captures_of(above, kRulerHeights);
    EXPECT_GT(captures.front().counts, captures.back().counts);
    auto const chosen = fit_height(captures).value();
    ASSERT_TRUE(std::holds_alternative<StringHeight>(chosen.model));
    EXPECT_LT(chosen.max_mm, 0.01);
    auto const fit = fit_height(captures, kStraightString).value();
    auto const& model = std::get<StringHeight>(fit.model);
    EXPECT_EQ(model.spool, StringHeight::Spool::Above);
    EXPECT_NEAR(model.base_mm, -480, 0.1);
    EXPECT_NEAR(model.offset_mm, 120, 0.1);
}

TEST(HeightFit, FollowsAWornPotentiometer)
{
    std::vector<HeightCapture> captures;
    for (int i = 0; i <= 14; ++i) {
        double const height = i * 400.0 / 14;
        captures.push_back(
            capture(height, 200 + 8 * height + 120 * std::sin(height / 400 * 2 * 3.14159265)));
    }
    auto const fit = fit_height(captures).value();
    EXPECT_EQ(name_of(fit.model), "monotone");
    EXPECT_LT(fit.rms_mm, 0.3);
    for (double height = 5; height < 400; height += 10) {
        double const counts = 200 + 8 * height + 120 * std::sin(height / 400 * 2 * 3.14159265);
        EXPECT_NEAR(height_mm(fit.model, counts).value(), height, 1.5);
    }
}

TEST(HeightFit, KeepsToALineWhereOtherModelsGainNothing)
{
    auto captures = captures_of(kFittedLinear, kRulerHeights);
    double const errors[] { 0.2, -0.3, 0.1, 0.25, -0.15, -0.3, 0.2 };
    for (std::size_t i = 0; i < captures.size(); ++i)
        captures[i].ruler_mm += errors[i];
    auto const fit = fit_height(captures).value();
    EXPECT_EQ(name_of(fit.model), "linear");
    EXPECT_NE(fit.reason.find("linear: what richer models gain may be chance (F test, p = "),
              std::string::npos);
    ASSERT_EQ(fit.candidates.size(), 2u) << "seven captures are too few for a monotone curve";
    EXPECT_GT(fit.candidates[1].p_value, 0.01);
}

TEST(HeightFit, NamesACaptureThatSlipped)
{
    auto captures = captures_of(kFittedString, kRulerHeights);
    captures[3].ruler_mm += 20;
    auto const fit = fit_height(captures).value();
    EXPECT_EQ(fit.slipped, std::vector<std::size_t> { 3 });
    EXPECT_NEAR(fit.residuals_mm[3], 20, 0.1);
    EXPECT_LT(fit.max_mm, 0.1) << "of the others";
}

// Returns captures of a vertical string with slack, made on the way up and on the way down.
std::vector<HeightCapture> captures_up_and_down(double slack_mm)
{
    std::vector<HeightCapture> captures;
    for (double const height : { 0.0, 100.0, 200.0, 300.0, 400.0 })
        captures.push_back(capture(height, 150 + (height + slack_mm / 2) / 0.12));
    for (double const height : { 300.0, 200.0, 100.0, 0.0 })
        captures.push_back(capture(height, 150 + (height - slack_mm / 2) / 0.12));
    assign_directions(captures);
    return captures;
}

TEST(HeightFit, TellsHysteresis)
{
    auto const fit = fit_height(captures_up_and_down(0.8)).value();
    ASSERT_TRUE(fit.hysteresis);
    EXPECT_NEAR(fit.hysteresis->mm, 0.8, 0.1);
    EXPECT_GT(fit.hysteresis->standard_error_mm, 0.2) << "four captures to a side";
    EXPECT_LT(fit.hysteresis->standard_error_mm, 0.4);
}

// A slack with the same error each time must not increase the estimated error of the ruler.
TEST(HeightFit, TakesHysteresisForNoErrorOfTheRuler)
{
    auto const tight = fit_height(captures_up_and_down(0)).value();
    auto const slack = fit_height(captures_up_and_down(1)).value();
    EXPECT_LT(slack.capture_error_mm, 0.3) << "the ruler's";
    EXPECT_NEAR(slack.capture_error_mm, tight.capture_error_mm, 0.05);
    EXPECT_NEAR(slack.rms_mm, 0.5, 0.05) << "half of the slack";
    for (double const height : { 50.0, 150.0, 250.0, 350.0 }) {
        double const counts = 150 + height / 0.12;
        EXPECT_NEAR(*height_mm(slack.model, counts), height, 0.15);
        EXPECT_LT(height_error_mm(slack, counts), 1.25 * height_error_mm(tight, counts));
    }
}

TEST(HeightFit, DoesWhatItIsAskedFor)
{
    auto const fit
        = fit_height(captures_of(kFittedString, kRulerHeights), { .kind = HeightModelKind::Linear })
              .value();
    EXPECT_EQ(name_of(fit.model), "linear");
    EXPECT_EQ(fit.reason, "linear: as was asked for");
    auto const curve = fit_height(captures_of(kFittedString, kRulerHeights),
                                  { .kind = HeightModelKind::Monotone })
                           .value();
    EXPECT_EQ(name_of(curve.model), "monotone");
    EXPECT_LT(curve.rms_mm, 0.3);
}

TEST(HeightFit, TellsErrorsThatShrinkWithTheRulersError)
{
    auto const captures = captures_of(kFittedLinear, kRulerHeights);
    auto const line = HeightModelKind::Linear;
    auto const coarse = fit_height(captures, { .kind = line, .ruler_error_mm = 1 }).value();
    auto const fine = fit_height(captures, { .kind = line, .ruler_error_mm = 0.1 }).value();
    EXPECT_NEAR(coarse.parameters[0].standard_error, 10 * fine.parameters[0].standard_error, 1e-9);
    EXPECT_NEAR(height_error_mm(fine, fine.low_counts), 0.06, 0.02);
}

TEST(HeightFit, RefusesFewerThanTwoCaptures)
{
    EXPECT_EQ(fit_refusal({}),
              "no capture was given, and a height needs at least two (five or more are advised): "
              "capture more heights");
    EXPECT_EQ(fit_refusal({ capture(0, 100) }),
              "one capture was given, and a height needs at least two (five or more are advised): "
              "capture more heights");
}

TEST(HeightFit, RefusesFewerCapturesThanParameters)
{
    EXPECT_EQ(fit_refusal(captures_of(kFittedLinear, { 0, 100, 200 }),
                          { .kind = HeightModelKind::String }),
              "a string model has 4 parameters and there are only 3 captures: capture at least 1 "
              "more heights");
}

TEST(HeightFit, RefusesCapturesAllAtOneHeight)
{
    EXPECT_EQ(fit_refusal(captures_of(kFittedLinear, { 100, 101, 99, 100 })),
              "all 4 captures are at one height, 99 to 101 mm: move the surface over most of its "
              "travel, at least 20 mm, between captures");
}

TEST(HeightFit, RefusesASlackString)
{
    auto captures = captures_of(kFittedLinear, { 0, 60, 120, 180, 240, 300, 360 });
    captures[0].counts = captures[1].counts = 660;
    captures[2].counts = 1160;
    EXPECT_EQ(
        fit_refusal(captures),
        "the reading stayed at 660 counts while the ruler went from 0 to 60 mm: the string "
        "is slack or the sensor is stuck there; tighten it, then capture these heights again");
    for (auto& one : captures)
        one.counts = 812;
    EXPECT_EQ(fit_refusal(captures).find(
                  "the reading stayed at 812 counts while the ruler went from 0 to 360 mm: "),
              0u);
}

TEST(HeightFit, RefusesCapturesOutOfOrder)
{
    auto captures = captures_of(kFittedLinear, { 0, 60, 120, 180, 240, 300, 360 });
    std::swap(captures[1].ruler_mm, captures[5].ruler_mm);
    EXPECT_EQ(fit_refusal(captures),
              "captures 2 (300 mm), 6 (60 mm) are out of order: their readings do not lie between "
              "those of the heights next to them; check what was typed and capture these heights "
              "again");
}

// Returns exact captures of a potentiometer on a vertical string. The converter's input loads the
// potentiometer as a resistor loads a voltage divider.
std::vector<HeightCapture> captures_under_load(double load)
{
    std::vector<HeightCapture> captures;
    for (double const height : { 0.0, 60.0, 200.0, 400.0, 300.0, 120.0, 20.0 }) {
        double const part = 0.3 + height / 600;
        captures.push_back({ .ruler_mm = height,
                             .counts = 4095 * part / (1 + load * part * (1 - part)),
                             .readings = 100 });
    }
    return captures;
}

TEST(HeightFit, BendsTheTrackWhenTheDataSheetSaysSo)
{
    auto const captures = captures_under_load(0.015);
    HeightFitOptions options { .kind = HeightModelKind::Linear };
    auto const straight = fit_height(captures, options).value();
    options.linearity_percent = 0.5;
    auto const bent = fit_height(captures, options).value();
    EXPECT_TRUE(bend_of(straight.model).empty());
    EXPECT_FALSE(bend_of(bent.model).empty());
    for (double const height : { 30.0, 90.0, 160.0, 250.0, 350.0 }) {
        double const part = 0.3 + height / 600;
        double const counts = 4095 * part / (1 + 0.015 * part * (1 - part));
        EXPECT_NEAR(*height_mm(bent.model, counts), height, 0.2) << height;
    }
    EXPECT_TRUE(straight.slipped.empty());
    EXPECT_LT(bent.max_mm, straight.max_mm / 2);
    EXPECT_GT(height_error_mm(bent, 2500), height_error_mm(straight, 2500) * 0.9);
}

// The captures deviate from a straight line by twice the ruler's error, with alternating sign.
TEST(HeightFit, WidensItsErrorsForARulerThatIsReadWorseThanWasSaid)
{
    auto captures = captures_of(kFittedLinear, kRulerHeights);
    auto const as_said = fit_height(captures).value();
    for (std::size_t i = 0; i < captures.size(); ++i)
        captures[i].ruler_mm += i % 2 == 0 ? 0.6 : -0.6;
    auto const worse = fit_height(captures).value();
    EXPECT_GT(worse.capture_error_mm, 0.5);
    EXPECT_LT(worse.capture_error_mm, 1);
    EXPECT_GT(height_error_mm(worse, 2000), 1.8 * height_error_mm(as_said, 2000));
}

// The track's bend is uncertain regardless of the ruler's error, so a better ruler improves the
// curve less than proportionally.
TEST(HeightFit, KnowsOfATracksBendWithoutBeingTold)
{
    auto const captures = captures_of(kFittedLinear, kRulerHeights);
    auto const coarse = fit_height(captures, { .ruler_error_mm = 1 }).value();
    auto const fine = fit_height(captures, { .ruler_error_mm = 0.1 }).value();
    EXPECT_GT(fine.bend_percent, 0);
    EXPECT_LT(fine.bend_percent, 0.5);
    EXPECT_GT(10 * height_error_mm(fine, 2000), 1.1 * height_error_mm(coarse, 2000));
    auto const few = fit_height(std::span(captures).first(4)).value();
    EXPECT_EQ(few.bend_percent, 0);
}

TEST(HeightFit, FollowsABendWithoutBeingTold)
{
    auto const captures = captures_under_load(0.015);
    auto const straight = fit_height(captures, { .kind = HeightModelKind::Linear }).value();
    auto const bent = fit_height(captures).value();
    EXPECT_FALSE(bend_of(bent.model).empty());
    EXPECT_LT(bent.max_mm, straight.max_mm / 2);
}

// Slips must be detected as reliably as with a straight track.
TEST(HeightFit, DoesNotBendTheTrackToASlip)
{
    auto captures = captures_of(kFittedLinear, kRulerHeights);
    captures[2].ruler_mm += 3;
    auto const fit = fit_height(captures).value();
    EXPECT_EQ(fit.slipped, std::vector<std::size_t> { 2 });
    auto const told = fit_height(captures, { .linearity_percent = 2 }).value();
    EXPECT_TRUE(told.slipped.empty()) << "or the slip is plain to both";
}

TEST(HeightFit, TakesNoBendForASlip)
{
    // The load is so great that a fit with a straight track would leave out a capture.
    auto const bent = captures_under_load(0.15);
    HeightFitOptions options { .kind = HeightModelKind::Linear };
    EXPECT_TRUE(doubt_about(fit_height(bent, options).value(), bent, options));
    options.linearity_percent = 2;
    auto const fit = fit_height(bent, options).value();
    EXPECT_TRUE(fit.slipped.empty());
    EXPECT_FALSE(doubt_about(fit, bent, options));

    auto slipped = bent;
    slipped[2].ruler_mm += 25;
    EXPECT_EQ(fit_height(slipped, options).value().slipped, std::vector<std::size_t> { 2 });
}

} // namespace
} // namespace tractus::calib
