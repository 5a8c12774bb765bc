#include "calib/slow_slip.h"

#include "engine/base/random.h"
#include "engine/base/vectors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

namespace tractus::calib {
namespace {

using Movement = std::function<double(double seconds)>;

constexpr double kReadingNoise_mm = 0.1;
constexpr double kConverterCount_mm = 0.1;

// A minimum-jerk movement.
double reach(double seconds, double begin_s, double lasts_s, double way_mm)
{
    double const u = std::clamp((seconds - begin_s) / lasts_s, 0.0, 1.0);
    return way_mm * u * u * u * (10 + u * (6 * u - 15));
}

// A slip at a constant speed.
double slip(double seconds, double begin_s, double lasts_s, double way_mm)
{
    return way_mm * std::clamp((seconds - begin_s) / lasts_s, 0.0, 1.0);
}

// Returns the slips that are found in a movement's readings, 500 a second.
std::vector<SlowSlip::Slip> find(Movement const& movement, double seconds, std::uint64_t seed)
{
    Random random({ .seed = seed, .stream = 1 });
    SlowSlip slips;
    std::vector<SlowSlip::Slip> found;
    for (int i = 0; i * 0.002 < seconds; ++i) {
        double const mm = movement(i * 0.002) + kReadingNoise_mm * random.normal();
        auto const time = timestamp_ns(std::int64_t(i) * 2'000'000);
        if (auto const one = slips.push(
                time, std::round(mm / kConverterCount_mm) * kConverterCount_mm, kConverterCount_mm))
            found.push_back(*one);
    }
    return found;
}

// Pushes of a hand with rests in between, and tremor: about two a second.
Movement hasty_hand(std::uint64_t seed)
{
    struct Push {
        double begin_s = 0;
        double lasts_s = 0;
        double way_mm = 0;
    };
    Random random({ .seed = seed, .stream = 2 });
    std::vector<Push> pushes;
    double height_mm = 0;
    for (double end_s = 0.3; end_s < 60;) {
        double way_mm
            = 2 * std::pow(40.0, random.uniform(0, 1)) * (random.uniform(0, 1) < 0.5 ? 1 : -1);
        if (std::abs(height_mm + way_mm) > 150)
            way_mm = -way_mm;
        height_mm += way_mm;
        double const lasts_s
            = std::max(std::abs(way_mm) < 10 ? 0.12 : 0.2, 1.875 * std::abs(way_mm) / 400)
            + random.uniform(0, 0.2);
        pushes.push_back({ end_s, lasts_s, way_mm });
        end_s += lasts_s + random.uniform(0, 0.5);
    }
    double const phase = random.uniform(0, 6);
    return [pushes, phase](double seconds) {
        double mm = 0.2 * std::sin(2 * kPi * 9 * seconds + phase);
        for (auto const& push : pushes) {
            if (push.begin_s > seconds)
                break;
            mm += reach(seconds, push.begin_s, push.lasts_s, push.way_mm);
        }
        return mm;
    };
}

struct Kind {
    double mm = 0;
    double lasts_s = 0;
};

TEST(SlowSlip, IsFoundWhenItIsMoreAbruptThanAHand)
{
    for (auto const& kind :
         { Kind { 5, 0.03 }, Kind { -5, 0.05 }, Kind { 10, 0.1 }, Kind { -20, 0.05 },
           Kind { 20, 0.2 }, Kind { -40, 0.2 }, Kind { 60, 0.1 }, Kind { 60, 0.2 } }) {
        int found = 0;
        constexpr int kRuns = 20;
        for (int seed = 1; seed <= kRuns; ++seed) {
            // The hand rests in a quarter of the runs.
            double const way_mm = seed % 4 == 0 ? 0 : 20.0 * (seed % 7 - 3);
            auto const slips = find(
                [&](double s) {
                    return reach(s, 0.8 + 0.02 * seed, 0.8, way_mm)
                        + slip(s, 1.2, kind.lasts_s, kind.mm);
                },
                2, std::uint64_t(seed));
            EXPECT_LE(slips.size(), 1U);
            if (slips.empty())
                continue;
            ++found;
            // The movement and the slip explain the same heights in part.
            EXPECT_NEAR(slips[0].step_mm, kind.mm, 1 + 0.08 * std::abs(kind.mm));
            EXPECT_NEAR(to_seconds(slips[0].begin), 1.2, 0.01);
            EXPECT_NEAR(to_seconds(slips[0].end), 1.2 + kind.lasts_s, 0.01);
        }
        EXPECT_GE(found, 0.9 * kRuns) << kind.mm << " mm in " << kind.lasts_s << " s";
    }
}

TEST(SlowSlip, IsNotAHandThatPushesQuickly)
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
        EXPECT_TRUE(find(hasty_hand(seed), 60, seed).empty()) << seed;
}

TEST(SlowSlip, IsNotAMotorThatRunsBriefly)
{
    // A motor that runs at 40 mm/s for 0.25 s, and reaches that speed at once.
    EXPECT_TRUE(find([](double s) { return slip(s, 1, 0.25, 10); }, 2, 1).empty());
    // At 80 mm/s, which it reaches in 60 ms.
    EXPECT_TRUE(find(
                    [](double s) {
                        double mm = 0;
                        for (int i = 0; i < 60; ++i)
                            mm += slip(s, 1 + 0.001 * i, 0.2, 16.0 / 60);
                        return mm;
                    },
                    2, 1)
                    .empty());
}

TEST(SlowSlip, IsNoStopThatTheSurfaceMeets)
{
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        double const speed = 20.0 * static_cast<double>(seed);
        // The surface falls ever faster upon a stop, and bounces from it once.
        auto const falling = [&](double s) {
            double const fallen_s = std::clamp(s - 0.7, 0.0, 0.3);
            double const bounced_s = std::clamp(s - 1, 0.0, 0.1);
            return 200 - speed * fallen_s * fallen_s / 0.6
                + 0.3 * speed * bounced_s * (1 - bounced_s / 0.1);
        };
        EXPECT_TRUE(find(falling, 2, seed).empty()) << speed;
    }
}

TEST(SlowSlip, IsNotSeenAcrossAGap)
{
    SlowSlip slips;
    for (int i = 0; i < 1000; ++i) {
        bool const is_read = i < 490 || i > 530;
        double const mm = std::round(slip(i * 0.002, 1, 0.05, 20) * 10) / 10;
        EXPECT_FALSE(is_read && slips.push(timestamp_ns(std::int64_t(i) * 2'000'000), mm, 0.1));
    }
}

} // namespace
} // namespace tractus::calib
