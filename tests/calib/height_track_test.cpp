#include "calib/height_track.h"

#include "engine/base/random.h"
#include "engine/base/vectors.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace tractus::calib {
namespace {

using namespace std::chrono_literals;

constexpr Timestamp kStart {};

// Returns a track with a reading every 2 ms from 0 to 1 s.
HeightTrack track_of(std::function<double(double seconds)> const& height_mm)
{
    HeightTrack track(10s);
    for (int i = 0; i <= 500; ++i)
        track.add(kStart + i * 2ms, height_mm(i * 0.002));
    return track;
}

TEST(HeightTrack, FollowsASteadyRiseWithoutLag)
{
    auto const track = track_of([](double t) { return 200 * t; });
    EXPECT_NEAR(track.at(kStart + 501ms, 50ms)->height_mm, 100.2, 1e-9);
    EXPECT_NEAR(track.at(kStart + 999ms, 50ms)->height_mm, 199.8, 1e-9);
    EXPECT_EQ(track.at(kStart + 501ms, 50ms)->kind, TipSample::HeightSource::Interpolated);
}

TEST(HeightTrack, CarriesARiseOnForFiveMillisecondsAndHoldsItThen)
{
    auto const track = track_of([](double t) { return 200 * t; });
    auto const ahead = track.at(kStart + 1004ms, 50ms);
    EXPECT_NEAR(ahead->height_mm, 200.8, 1e-9);
    EXPECT_EQ(ahead->kind, TipSample::HeightSource::Extrapolated);
    EXPECT_NEAR(track.at(kStart + 1030ms, 50ms)->height_mm, 201, 1e-9);
    EXPECT_EQ(track.at(kStart + 1030ms, 50ms)->kind, TipSample::HeightSource::Extrapolated);
    EXPECT_NEAR(track.newest_at(kStart + 1004ms, 50ms)->height_mm, 200.8, 1e-9);
}

// If readings arrive together every 30 ms, the height must be extrapolated until the next delivery.
TEST(HeightTrack, CarriesARiseOnUntilTheNextDelivery)
{
    auto const track = track_of([](double t) { return 200 * t; });
    EXPECT_NEAR(track.newest_at(kStart + 1020ms, 50ms, 30ms)->height_mm, 204, 1e-9);
    EXPECT_NEAR(track.newest_at(kStart + 1040ms, 50ms, 30ms)->height_mm, 206, 1e-9);
    EXPECT_NEAR(track.newest_at(kStart + 1040ms, 50ms)->height_mm, 201, 1e-9);
}

// Returns a track with sparse readings, up to one second.
HeightTrack scarce_track(int spacing_ms, std::function<double(double seconds)> const& height_mm)
{
    HeightTrack track(10s);
    for (int time_ms = 0; time_ms <= 1000; time_ms += spacing_ms)
        track.add(kStart + time_ms * 1ms, height_mm(time_ms / 1000.0));
    return track;
}

TEST(HeightTrack, CarriesScarceReadingsOnUntilTheNextOneIsDue)
{
    auto const track = scarce_track(10, [](double t) { return 200 * t; });
    EXPECT_NEAR(track.newest_at(kStart + 1010ms, 50ms)->height_mm, 202, 1e-9);
    EXPECT_NEAR(track.newest_at(kStart + 1040ms, 50ms)->height_mm, 203, 1e-9) << "half more";
}

TEST(HeightTrack, CarriesNothingOnThatHasStopped)
{
    auto const stopped = [](double t) { return 300 * std::min(t, 0.98); };
    EXPECT_NEAR(scarce_track(10, stopped).newest_at(kStart + 1005ms, 50ms)->height_mm, 294, 1e-9);
    EXPECT_NEAR(scarce_track(2, stopped).newest_at(kStart + 1003ms, 50ms)->height_mm, 294, 0.201);
}

TEST(HeightTrack, SlowsDownWithTheCarriage)
{
    // The carriage brakes steadily from 300 mm/s to rest, and will be at rest in 20 ms.
    auto const braking = [](double t) { return -1500 * std::pow(std::max(1.02 - t, 0.0), 2); };
    double const ahead = scarce_track(10, braking).newest_at(kStart + 1010ms, 50ms)->height_mm;
    EXPECT_NEAR(ahead, -0.15, 0.1) << "0.45 without braking: -0.6 + 10 ms of 45 mm/s";
    EXPECT_LT(ahead, 0);
}

TEST(HeightTrack, LeavesALonelySpikeOut)
{
    HeightTrack track(10s);
    for (int i = 0; i <= 100; ++i)
        track.add(kStart + i * 2ms, i == 50 ? 40 : 10);
    for (int time_ms = 80; time_ms < 120; ++time_ms)
        EXPECT_NEAR(track.at(kStart + time_ms * 1ms, 50ms)->height_mm, 10, 1e-9) << time_ms;
}

TEST(HeightTrack, KeepsAStepThatStays)
{
    HeightTrack track(10s);
    for (int i = 0; i <= 100; ++i)
        track.add(kStart + i * 2ms, i >= 50 ? 40 : 10);
    EXPECT_NEAR(track.at(kStart + 70ms, 50ms)->height_mm, 10, 1e-9);
    EXPECT_NEAR(track.at(kStart + 130ms, 50ms)->height_mm, 40, 1e-9);
}

TEST(HeightTrack, JoinsBothSidesOfAGap)
{
    auto const rounded = [](double t) { return 100 * std::sin(6 * t); };
    HeightTrack track(10s);
    for (int i = 0; i <= 500; ++i)
        if (i * 2 < 240 || i * 2 > 280) // The gap includes the top of the sine.
            track.add(kStart + i * 2ms, rounded(i * 0.002));
    for (int time_ms = 236; time_ms < 285; ++time_ms) {
        auto const height = track.at(kStart + time_ms * 1ms, 50ms);
        EXPECT_NEAR(height->height_mm, rounded(time_ms / 1000.0), 0.4)
            << time_ms << ": a straight line would be 0.7 mm too low";
        EXPECT_EQ(height->kind, TipSample::HeightSource::Interpolated);
    }
}

TEST(HeightTrack, HasNoHeightFarFromItsReadings)
{
    auto const track = track_of([](double) { return 5; });
    EXPECT_TRUE(track.at(kStart + 1050ms, 50ms));
    EXPECT_FALSE(track.at(kStart + 1051ms, 50ms));
    EXPECT_FALSE(track.at(kStart - 51ms, 50ms));
    EXPECT_FALSE(HeightTrack(1s).at(kStart, 50ms));
}

TEST(HeightTrack, DoesNotBridgeAGap)
{
    HeightTrack track(10s);
    track.add(kStart, 0);
    track.add(kStart + 1s, 100);
    EXPECT_FALSE(track.at(kStart + 500ms, 50ms));
    EXPECT_EQ(track.at(kStart + 40ms, 50ms)->kind, TipSample::HeightSource::Extrapolated);
    EXPECT_EQ(track.at(kStart + 40ms, 50ms)->height_mm, 0);
    EXPECT_EQ(track.at(kStart + 960ms, 50ms)->height_mm, 100);
}

TEST(HeightTrack, JoinsScarceReadingsByStraightLines)
{
    HeightTrack track(10s);
    for (int i = 0; i < 5; ++i)
        track.add(kStart + i * 40ms, i * 10.0);
    EXPECT_DOUBLE_EQ(track.at(kStart + 50ms, 50ms)->height_mm, 12.5);
    EXPECT_DOUBLE_EQ(track.at(kStart + 80ms, 50ms)->height_mm, 20);
    EXPECT_DOUBLE_EQ(track.at(kStart, 50ms)->height_mm, 0);
}

TEST(HeightTrack, SmoothesNoiseAway)
{
    Random random({ .seed = 1 });
    auto const track = track_of([&](double) { return random.normal(); });
    double sum_of_squares = 0;
    for (int i = 100; i < 400; ++i)
        sum_of_squares += std::pow(track.at(kStart + i * 2ms, 50ms)->height_mm, 2);
    // Expected: 1 / sqrt(18 readings) = 0.24, with a margin for chance.
    EXPECT_LT(std::sqrt(sum_of_squares / 300), 0.45);
}

TEST(HeightTrack, RoundsABumpOnlyAsFarAsItSays)
{
    // Swaying by +-100 mm in 1.5 s has an acceleration of 1,755 mm/s^2 at the top.
    auto const sway = [](double t) { return 100 * std::sin(2 * kPi * t / 1.5); };
    auto const track = track_of(sway);
    for (int i = 20; i < 480; ++i)
        EXPECT_NEAR(track.at(kStart + i * 2ms, 50ms)->height_mm, sway(i * 0.002), 0.06) << i;
}

TEST(HeightTrack, PutsALateReadingInItsPlace)
{
    auto const in_order = track_of([](double t) { return t * t * 300; });
    HeightTrack shuffled(10s);
    for (int i = 0; i <= 500; i += 2) { // The readings of each pair are swapped.
        if (i + 1 <= 500)
            shuffled.add(kStart + (i + 1) * 2ms, std::pow((i + 1) * 0.002, 2) * 300);
        shuffled.add(kStart + i * 2ms, std::pow(i * 0.002, 2) * 300);
    }
    for (int i = 0; i < 1000; i += 7)
        EXPECT_EQ(shuffled.at(kStart + i * 1ms, 50ms)->height_mm,
                  in_order.at(kStart + i * 1ms, 50ms)->height_mm);
}

TEST(HeightTrack, IgnoresARepeatedReading)
{
    auto track = track_of([](double t) { return t * t * 300; });
    auto const before = track.at(kStart + 500ms, 50ms)->height_mm;
    for (int i = 0; i < 100; ++i)
        track.add(kStart + 504ms, std::pow(0.002 * 252, 2) * 300);
    EXPECT_EQ(track.at(kStart + 500ms, 50ms)->height_mm, before);
}

TEST(HeightTrack, ForgetsWhatIsOlderThanItsMemory)
{
    HeightTrack track(1s);
    track.add(kStart, 1);
    track.add(kStart + 1500ms, 2);
    EXPECT_FALSE(track.at(kStart, 50ms));
    track.add(kStart + 100ms, 3);
    EXPECT_FALSE(track.at(kStart + 100ms, 50ms));
    EXPECT_EQ(track.newest(), kStart + 1500ms);
}

} // namespace
} // namespace tractus::calib
