#include "calib/height_judge.h"

#include "engine/base/random.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace tractus::calib {
namespace {

using Verdict = HeightJudge::Verdict;

constexpr double kCount_mm = 0.1;

struct Judged {
    HeightJudge judge;
    std::vector<HeightJudge::Reading> believed;
    std::vector<Verdict> verdicts;

    Verdict push(double seconds, double height_mm)
    {
        Timestamp const time = timestamp_ns(std::llround(seconds * 1e9));
        verdicts.push_back(judge.judge({ time, time, height_mm }, kCount_mm, believed));
        return verdicts.back();
    }
};

// Returns the height of a surface that sways by 100 mm to either side of 250 mm, at up to 420 mm/s.
double sway_mm(double seconds)
{
    return 250 + 100 * std::sin(2 * 3.14159265 * seconds / 1.5);
}

constexpr double kRates_hz[] { 50, 100, 250, 500, 1000, 2000 };

TEST(HeightJudge, BelievesEveryReadingOfAHand)
{
    for (double const rate_hz : kRates_hz)
        for (double const noise_mm : { 0.0, 0.1, 0.5, 2.0 }) {
            Judged judged;
            Random random({ .seed = 5 });
            for (double seconds = 0; seconds < 10; seconds += 1 / rate_hz)
                judged.push(seconds, sway_mm(seconds) + noise_mm * random.normal());
            auto const doubted
                = std::count(judged.verdicts.begin() + 20, judged.verdicts.end(), Verdict::Doubted);
            EXPECT_LE(doubted, noise_mm < 1 ? 0 : static_cast<long>(rate_hz * 10 / 1000))
                << rate_hz << " Hz, " << noise_mm << " mm";
            EXPECT_GE(judged.believed.size() + 20, judged.verdicts.size());
        }
}

TEST(HeightJudge, BelievesReadingsThatComeInBundles)
{
    Judged judged;
    int index = 0;
    for (double seconds = 0; seconds < 5; seconds += 0.002, ++index)
        judged.push(0.016 * (index / 8 + 1) + 1e-5 * (index % 8), sway_mm(seconds));
    EXPECT_EQ(judged.believed.size(), judged.verdicts.size());
}

// Inserts up to ten arbitrary readings in a row, repeatedly.
TEST(HeightJudge, NeverBelievesUpToTenWrongReadingsInARow)
{
    for (double const rate_hz : kRates_hz)
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Random random({ .seed = seed });
            Judged judged;
            int wrong = 0;
            int right = 40;
            double stuck_mm = 0;
            bool is_stuck = false;
            for (double seconds = 0; seconds < 10; seconds += 1 / rate_hz) {
                double const true_mm = sway_mm(seconds);
                double read_mm = true_mm;
                if (right > 0) {
                    --right;
                } else {
                    if (wrong == 0) {
                        wrong = 1 + static_cast<int>(random.uniform() * 10);
                        is_stuck = random.uniform() < 0.5;
                        stuck_mm = true_mm
                            + (random.uniform() < 0.5 ? -1 : 1) * random.uniform(120, 200);
                    }
                    read_mm = is_stuck ? stuck_mm : stuck_mm + random.uniform(-20, 20);
                    if (--wrong == 0)
                        right = 20 + static_cast<int>(random.uniform() * 40);
                }
                judged.push(seconds, read_mm);
            }
            double worst_mm = 0;
            for (auto const& reading : judged.believed)
                worst_mm = std::max(worst_mm,
                                    std::abs(reading.height_mm
                                             - sway_mm(to_seconds(reading.arrival - Timestamp()))));
            EXPECT_LE(worst_mm, 1e-6) << rate_hz << " Hz, seed " << seed;
            EXPECT_GE(judged.believed.size(), judged.verdicts.size() * 6 / 10);
        }
}

TEST(HeightJudge, FollowsTheSurfaceToWhereItIsNow)
{
    for (double const rate_hz : kRates_hz) {
        Judged judged;
        double seconds = 0;
        for (; seconds < 1; seconds += 1 / rate_hz)
            judged.push(seconds, 100);
        for (; seconds < 2; seconds += 1 / rate_hz)
            judged.push(seconds, 180);
        EXPECT_EQ(std::count(judged.verdicts.begin(), judged.verdicts.end(), Verdict::Step), 1);
        // The believed readings include those that were in doubt at first.
        EXPECT_EQ(judged.believed.size(), judged.verdicts.size());
        EXPECT_LE(judged.judge.doubted_in_a_row(), 0u);
    }
}

TEST(HeightJudge, BelievesWhatStartsAndStopsAtOnce)
{
    for (double const rate_hz : kRates_hz)
        for (double const mm_per_s : { 50, 200, 400 }) {
            Judged judged;
            for (double seconds = 0; seconds < 2; seconds += 1 / rate_hz)
                judged.push(seconds, 100 + mm_per_s * std::clamp(seconds - 0.8037, 0.0, 0.5));
            EXPECT_EQ(judged.believed.size(), judged.verdicts.size()) << rate_hz << mm_per_s;
            EXPECT_EQ(std::count(judged.verdicts.begin(), judged.verdicts.end(), Verdict::Step), 0)
                << rate_hz << " " << mm_per_s;
        }
}

TEST(HeightJudge, FollowsAtOnceAfterAPause)
{
    Judged judged;
    for (int i = 0; i < 100; ++i)
        judged.push(0.002 * i, 100);
    EXPECT_EQ(judged.push(1.2, 300), Verdict::Believed);
}

TEST(HeightJudge, GetsOverAWrongFirstReading)
{
    Judged judged;
    judged.push(0, 400);
    for (int i = 1; i < 10; ++i)
        judged.push(0.002 * i, 100);
    EXPECT_EQ(judged.believed.size(), 10u);
    EXPECT_EQ(judged.verdicts[5], Verdict::Believed);
}

} // namespace
} // namespace tractus::calib
