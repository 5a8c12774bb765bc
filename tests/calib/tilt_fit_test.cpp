#include "calib/tilt_fit.h"

#include "calib/fuser.h"
#include "calib/lean_track.h"
#include "engine/base/random.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace tractus::calib {
namespace {

using namespace std::chrono_literals;

// For a pen along the diagonal of a cube, both tilts are 45 degrees, and a point 1 mm up the pen is
// displaced by 1/sqrt(3) mm along each axis.
TEST(LeanOf, IsWhatAMillimetreUpThePenIsAside)
{
    double const side = 1 / std::sqrt(3.0);
    EXPECT_NEAR((lean_of({ kPi / 4, kPi / 4 }) - Vec2(side, side)).norm(), 0, 1e-12);
    EXPECT_NEAR((lean_of({ kPi / 6, 0 }) - Vec2(0.5, 0)).norm(), 0, 1e-12);
    EXPECT_NEAR((lean_of({ 0, -kPi / 6 }) - Vec2(0, -0.5)).norm(), 0, 1e-12);
    EXPECT_LE(lean_of({ kPi / 2, kPi / 2 }).norm(), 1 + 1e-12) << "a pen that lies down";
}

// Returns samples with the nib at (60, 40) while the pen is leaned in all directions by up to
// `farthest_deg`.
std::vector<drivers::PenSample> leaned_around(double coil_mm, double farthest_deg,
                                              double for_s = 20)
{
    Random random({ .seed = 5, .stream = 1 });
    std::vector<drivers::PenSample> pens;
    for (double t = 0; t < for_s; t += 0.005) {
        Vec2 const tilt_deg(farthest_deg * std::sin(1.3 * t), farthest_deg * std::cos(1.1 * t));
        Vec2 const slope(std::tan(radians(tilt_deg.x())), std::tan(radians(tilt_deg.y())));
        Vec2 const noise(0.05 * random.normal(), 0.05 * random.normal());
        pens.push_back({ .time = Timestamp(from_seconds(t)),
                         .position_mm = Vec2(60, 40) + noise
                             + coil_mm * slope / std::sqrt(1 + slope.squaredNorm()),
                         .pressure = 0.5,
                         .tilt_rad = Vec2(radians(std::round(tilt_deg.x())),
                                          radians(std::round(tilt_deg.y()))),
                         .in_range = true,
                         .touching = true });
    }
    return pens;
}

std::string refusal_of(std::vector<drivers::PenSample> const& pens)
{
    auto const fit = fit_tilt(pens);
    return fit ? "no error" : fit.error().message;
}

TEST(TiltFit, FindsTheCoilsHeight)
{
    auto const fit = fit_tilt(leaned_around(9.5, 40)).value();
    EXPECT_NEAR(fit.coil_height_mm.x(), 9.5, 0.05);
    EXPECT_NEAR(fit.coil_height_mm.y(), 9.5, 0.05);
    EXPECT_LT(fit.coil_height_error_mm.maxCoeff(), 0.07);
    EXPECT_GT(fit.coil_height_error_mm.minCoeff(), 0.06) << "the dent's play";
    EXPECT_NEAR(degrees(fit.most_tilt_rad.x()), 40, 1);
    EXPECT_FALSE(fit.is_corrected());
    EXPECT_EQ(with_coil_height({}, fit).coil_height_mm, fit.coil_height_mm);
}

TEST(TiltFit, LeavesATabletAloneThatCorrects)
{
    auto const fit = fit_tilt(leaned_around(0, 40)).value();
    EXPECT_TRUE(fit.is_corrected());
    Rig rig;
    rig.coil_height_mm = { 5, 5 };
    EXPECT_EQ(with_coil_height(rig, fit).coil_height_mm, Vec2(0, 0));
}

TEST(TiltFit, FindsATiltThatCountsTheOtherWayRound)
{
    auto pens = leaned_around(9.5, 40);
    for (auto& pen : pens)
        pen.tilt_rad->y() *= -1;
    auto const fit = fit_tilt(pens).value();
    EXPECT_NEAR(fit.coil_height_mm.x(), 9.5, 0.05);
    EXPECT_NEAR(fit.coil_height_mm.y(), -9.5, 0.05);
}

TEST(TiltFit, SaysWhatIsMissing)
{
    EXPECT_EQ(refusal_of(leaned_around(9, 12)),
              "the pen leaned over only 24 degrees to the left and right, expected at least 40: "
              "lean it farther to either side");
    EXPECT_EQ(refusal_of(leaned_around(9, 40, 0.5)),
              "the pen touched in only 100 reports, expected at least 200: keep its nib on the "
              "tablet and lean it around for ten seconds or more");
    auto moved = leaned_around(9, 40);
    for (std::size_t i = moved.size() / 2; i < moved.size(); ++i)
        moved[i].position_mm.x() += 6;
    EXPECT_EQ(refusal_of(moved).substr(0, 22), "the nib moved by 3.0 m") << refusal_of(moved);
    auto dull = leaned_around(9, 40);
    for (auto& pen : dull)
        pen.tilt_rad.reset();
    EXPECT_EQ(refusal_of(dull),
              "the tablet tells no tilt for this pen, so there is nothing to calibrate, and "
              "nothing that tips could be corrected by");
    auto stuck = leaned_around(9, 40);
    for (auto& pen : stuck)
        pen.tilt_rad = Vec2::Zero();
    EXPECT_EQ(refusal_of(stuck),
              "the tilt that the tablet tells never changed: lean the pen around, and if it was, "
              "the tablet tells none for this pen");
}

// A pen that leans by 30 degrees to the right, with a coil ten millimetres up the pen. The tablet
// reports it five millimetres beside its nib.
struct Leaning {
    Rig rig;
    std::vector<drivers::PenSample> pens;

    Leaning()
    {
        rig.tablet_size_mm = { 200, 100 };
        rig.coil_height_mm = { 10, 10 };
        for (int i = 0; i < 20; ++i)
            pens.push_back({ .time = Timestamp(i * 5ms),
                             .position_mm = { 150, 50 },
                             .pressure = 0.5,
                             .tilt_rad = Vec2(kPi / 6, 0),
                             .in_range = true,
                             .touching = true });
    }

    TipSample last_tip() const
    {
        Fuser fuser(rig);
        std::optional<TipSample> tip;
        for (auto const& pen : pens) {
            fuser.push(
                drivers::HeightSample { .time = pen.time, .counts = 100, .full_scale = 4095 });
            tip = fuser.push(pen);
        }
        fuser.flush();
        EXPECT_NEAR(fuser.take_settled().back().position_mm.x(), tip->position_mm.x(), 1e-9);
        return tip.value();
    }
};

TEST(Fuser, PutsATipUnderItsCoil)
{
    EXPECT_NEAR(Leaning().last_tip().position_mm.x(), 45, 1e-9);
    EXPECT_NEAR(Leaning().last_tip().position_mm.y(), 0, 1e-9);
}

// With the tablet rotated by 90 degrees, the pen leans to the tablet's right, and away from the
// user in the world.
TEST(Fuser, PutsATipUnderItsCoilBeforeItTurnsTheTablet)
{
    Leaning turned;
    turned.rig.rotation_deg = 90;
    EXPECT_NEAR(turned.last_tip().position_mm.x(), 0, 1e-9);
    EXPECT_NEAR(turned.last_tip().position_mm.y(), 45, 1e-9);
}

TEST(Fuser, LeavesATipWithoutATiltWhereItIs)
{
    Leaning dull;
    for (auto& pen : dull.pens)
        pen.tilt_rad.reset();
    EXPECT_NEAR(dull.last_tip().position_mm.x(), 50, 1e-9);
}

// The lean changes by half a degree every 5 ms, and the tablet rounds tilts to three degrees.
TEST(LeanTrack, SmoothsWhatTheTabletRounds)
{
    LeanTrack track(1s);
    double squares = 0;
    double rounded_squares = 0;
    auto const tilt_deg = [](int i) { return -30 + 0.5 * i; };
    auto const rounded = [&](int i) { return 3 * std::round(tilt_deg(i) / 3); };
    for (int i = 0; i < 120; ++i)
        track.add({ .time = Timestamp(i * 5ms), .tilt_rad = Vec2(radians(rounded(i)), 0) });
    for (int i = 20; i < 100; ++i) {
        double const truth = std::sin(radians(tilt_deg(i)));
        squares += std::pow(track.at(Timestamp(i * 5ms))->x() - truth, 2);
        rounded_squares += std::pow(std::sin(radians(rounded(i))) - truth, 2);
    }
    EXPECT_LT(squares, rounded_squares / 9);
}

TEST(LeanTrack, KnowsNothingOfSamplesWithoutATilt)
{
    LeanTrack track(1s);
    track.add({ .time = Timestamp(5ms) });
    EXPECT_FALSE(track.at(Timestamp(5ms)));
    track.add({ .time = Timestamp(10ms), .tilt_rad = Vec2(0.3, 0) });
    EXPECT_TRUE(track.at(Timestamp(10ms)));
    EXPECT_FALSE(track.at(Timestamp(7ms)));
}

} // namespace
} // namespace tractus::calib
