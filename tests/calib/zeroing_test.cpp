#include "calib/zeroing.h"

#include <gtest/gtest.h>

namespace tractus::calib {
namespace {

Rig aslant_rig()
{
    Rig rig { .height_model = StringHeight {
                  .mm_per_count = 0.1, .zero_length_mm = 124, .offset_mm = 120, .base_mm = 80 } };
    rig.calibrated_min_counts = counts_at_height(rig.height_model, 0).value();
    rig.calibrated_max_counts = counts_at_height(rig.height_model, 400).value();
    rig.calibration.height = HeightRecord { .heights_mm = { 0, 400 } };
    return rig;
}

// Returns a capture made after the string has slipped by `slip_counts` and the table has been
// raised by `move_mm` relative to the ruler's zero.
HeightCapture capture_after(double slip_counts, double move_mm, double ruler_mm)
{
    return { .ruler_mm = ruler_mm,
             .counts = counts_at_height(aslant_rig().height_model, ruler_mm + move_mm).value()
                 + slip_counts };
}

double height_at(Zeroing const& zeroing, HeightCapture const& reading)
{
    return height_mm(zeroing.rig.height_model, reading.counts).value();
}

TEST(Zeroing, TakesTheStringToHaveSlipped)
{
    HeightCapture const captures[] { capture_after(50, 0, 0) };
    auto const zeroing = zeroed(aslant_rig(), captures, 4095).value();
    EXPECT_EQ(zeroing.cause, ZeroCause::Slipped);
    EXPECT_FALSE(zeroing.is_told);
    EXPECT_NEAR(height_at(zeroing, capture_after(50, 0, 300)), 300, 1e-3);
    EXPECT_NEAR(zeroing.rig.calibration.height->shifted_counts, 50, 1e-3);
    EXPECT_GT(zeroing.difference_if_other_cause_mm, 3) << "5 mm of string, where it runs aslant";
}

TEST(Zeroing, KeepsTheCalibratedHeightsAfterASlip)
{
    HeightCapture const captures[] { capture_after(-50, 0, 0) };
    auto const rig = zeroed(aslant_rig(), captures, 4095)->rig;
    EXPECT_NEAR(calibrated_heights(rig)->low_mm, 0, 1e-3);
    EXPECT_NEAR(calibrated_heights(rig)->high_mm, 400, 1e-3);
}

TEST(Zeroing, RaisesEachHeightAlikeAfterAMove)
{
    HeightCapture const captures[] { capture_after(0, 5, 0) };
    auto const zeroing = zeroed(aslant_rig(), captures, 4095, ZeroCause::Moved).value();
    EXPECT_TRUE(zeroing.is_told);
    EXPECT_NEAR(height_at(zeroing, capture_after(0, 5, 300)), 300, 1e-3);
    EXPECT_NEAR(zeroing.rig.calibration.height->raised_mm, -5, 1e-3);
}

TEST(Zeroing, IsToldTheCauseByTwoHeights)
{
    HeightCapture const moved[] { capture_after(0, 5, 0), capture_after(0, 5, 350) };
    EXPECT_EQ(zeroed(aslant_rig(), moved, 4095)->cause, ZeroCause::Moved);
    EXPECT_TRUE(zeroed(aslant_rig(), moved, 4095)->is_told);
    HeightCapture const slipped[] { capture_after(50, 0, 0), capture_after(50, 0, 350) };
    EXPECT_EQ(zeroed(aslant_rig(), slipped, 4095)->cause, ZeroCause::Slipped);
    EXPECT_TRUE(zeroed(aslant_rig(), slipped, 4095)->is_told);
}

TEST(Zeroing, HasNothingAtStakeForAStringThatHangsPlumb)
{
    auto rig = aslant_rig();
    rig.height_model = LinearHeight {};
    HeightCapture const captures[] { { .ruler_mm = 0, .counts = 50 } };
    EXPECT_NEAR(zeroed(rig, captures, 4095)->difference_if_other_cause_mm, 0, 1e-9);
}

TEST(Zeroing, RefusesWhatItCannotZero)
{
    EXPECT_EQ(zeroed(aslant_rig(), {}, 4095).error().message,
              "nothing was captured: set the surface to a known height, let it rest and capture "
              "it");
    HeightCapture const captures[] { capture_after(0, 0, 0) };
    EXPECT_FALSE(zeroed(aslant_rig(), captures, 1023));
}

} // namespace
} // namespace tractus::calib
