#include "calib/height_capture.h"

#include "engine/base/random.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace tractus::calib {
namespace {

// Returns readings of one second, 2 ms apart; `counts` gives the i-th reading, which is rounded.
template<typename Counts>
std::vector<drivers::HeightSample> a_second_of(Counts const& counts, std::int32_t full_scale = 4095)
{
    std::vector<drivers::HeightSample> samples;
    for (int i = 0; i < 500; ++i)
        samples.push_back({ .time = timestamp_ns(i * 2'000'000),
                            .counts = static_cast<std::int32_t>(
                                std::clamp(std::lround(counts(i)), 0L, long { full_scale })),
                            .full_scale = full_scale });
    return samples;
}

std::vector<drivers::HeightSample> noise_about(double counts, double deviation = 1)
{
    Random random({ .seed = 3 });
    return a_second_of([&](int) { return counts + deviation * random.normal(); });
}

std::string capture_refusal(std::vector<drivers::HeightSample> const& samples)
{
    auto const capture = capture_at_rest(samples, 100);
    return capture ? "captured" : capture.error().message;
}

TEST(HeightCapture, AveragesReadingsAtRest)
{
    auto const capture = capture_at_rest(noise_about(1234.4), 150).value();
    EXPECT_EQ(capture.ruler_mm, 150);
    EXPECT_NEAR(capture.counts, 1234.4, 0.15);
    EXPECT_NEAR(capture.noise_counts, 1.04, 0.1);
    EXPECT_EQ(capture.readings, 500);
}

TEST(HeightCapture, CountsHowReadingsScatter)
{
    auto const capture = capture_at_rest(noise_about(1234), 150).value();
    int sum = 0;
    for (int const bin : capture.scatter)
        sum += bin;
    EXPECT_EQ(sum, 500);
    ASSERT_EQ(capture.scatter.size() % 2, 1u);
    auto const middle = capture.scatter.size() / 2;
    EXPECT_NEAR(capture.scatter[middle], 500 * 0.38, 40) << "within half a standard deviation";
}

TEST(HeightCapture, TakesASensorWithoutAnyNoise)
{
    auto const capture = capture_at_rest(a_second_of([](int) { return 700; }), 150).value();
    EXPECT_EQ(capture.counts, 700);
    EXPECT_EQ(capture.noise_counts, 0);
    EXPECT_EQ(capture.scatter, std::vector<int> { 500 });
}

TEST(HeightCapture, RefusesASurfaceThatMoves)
{
    EXPECT_EQ(
        capture_refusal(a_second_of([](int i) { return 1000 + i * 0.02; })),
        "the surface moved during the capture, by 8.8 counts: let it rest, then capture again");
    EXPECT_NE(capture_refusal(a_second_of([](int i) {
                  return 1000 + 6 * std::sin(i * 0.02);
              })).find("the surface moved during the capture"),
              std::string::npos);
}

TEST(HeightCapture, RefusesReadingsOnARail)
{
    EXPECT_EQ(capture_refusal(noise_about(4095)),
              "the reading is at the upper end of the converter (4095 of 4095), where it says "
              "nothing: move the surface away from there, or check the wiring if it is so at every "
              "height");
    EXPECT_NE(capture_refusal(noise_about(0)).find("at the lower end of the converter (0 of 4095)"),
              std::string::npos);
}

TEST(HeightCapture, RefusesReadingsThatJumpAbout)
{
    EXPECT_NE(capture_refusal(noise_about(2000, 60)).find("check the wiper's wire"),
              std::string::npos)
        << capture_refusal(noise_about(2000, 60));
}

TEST(HeightCapture, RefusesASensorThatIsSilent)
{
    EXPECT_EQ(capture_refusal({}),
              "only 0 readings came in the time of a capture, expected at least 20: check that the "
              "height sensor is connected and sends");
    auto samples = noise_about(1000);
    for (std::size_t i = 250; i < samples.size(); ++i)
        samples[i].time += std::chrono::milliseconds(300);
    EXPECT_EQ(capture_refusal(samples),
              "the height sensor was silent for 0.30 s during the capture: check its cable and "
              "capture again");
}

TEST(RecentReadings, TellWhatMayBeCaptured)
{
    RecentReadings recent;
    EXPECT_FALSE(recent.reading());
    for (auto const& sample : noise_about(2000))
        recent.add(sample);
    EXPECT_TRUE(recent.reading()->is_at_rest);
    EXPECT_FALSE(recent.reading()->is_on_rail);
    EXPECT_NEAR(recent.reading()->counts, 2000, 0.2);
}

TEST(RecentReadings, ForgetWhatIsOlderThanASecond)
{
    RecentReadings recent;
    auto samples = noise_about(4095);
    for (auto const& sample : samples)
        recent.add(sample);
    EXPECT_TRUE(recent.reading()->is_on_rail);
    for (auto sample : noise_about(2000)) {
        sample.time += std::chrono::milliseconds(1100);
        recent.add(sample);
    }
    EXPECT_FALSE(recent.reading()->is_on_rail);
    EXPECT_NEAR(recent.reading()->counts, 2000, 0.2);
}

} // namespace
} // namespace tractus::calib
