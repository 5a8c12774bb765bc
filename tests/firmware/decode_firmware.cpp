// Tests the decoding of the reports that the firmware has sent in simavr: see usb_host.c.
#include "drivers/height_decoders.h"
#include "drivers/logs/log.h"
#include "tests/drivers/bytes.h"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <vector>

namespace tractus {
namespace {

constexpr std::size_t kHalf = 32; // Number of conversions from one reading to the next.

drivers::Log firmware_log()
{
    return drivers::read_log(TRACTUS_FIRMWARE "/slider.tractus-log").value();
}

std::vector<std::int32_t> decoded(drivers::Log const& log)
{
    auto const decoder = drivers::make_height_decoder(log.devices.at(0)).value();
    std::vector<drivers::HeightSample> samples;
    drivers::LogCursor cursor(log);
    while (auto const* const report = cursor.next().value()) {
        auto const done = decoder->decode(report->time, report->bytes, samples);
        EXPECT_TRUE(done) << done.error().message;
    }
    std::vector<std::int32_t> counts;
    for (auto const& sample : samples)
        counts.push_back(sample.counts);
    return counts;
}

// Returns the expected readings, computed from the input of the converter. Each reading is the sum
// of 64 conversions divided by 8.
std::vector<std::int32_t> expected()
{
    std::ifstream in(TRACTUS_FIRMWARE "/conversions.txt");
    std::vector<std::int32_t> const conversions(std::istream_iterator<std::int32_t>(in), {});
    std::vector<std::int32_t> readings;
    for (std::size_t i = 0; i + 2 * kHalf <= conversions.size(); i += kHalf) {
        std::int32_t sum = 0;
        for (std::size_t k = 0; k < 2 * kHalf; ++k)
            sum += conversions[i + k];
        readings.push_back(sum / 8);
    }
    return readings;
}

TEST(Firmware, DescribesItselfAsThePageSays)
{
    auto const log = firmware_log();
    EXPECT_EQ(log.devices.at(0).report_descriptor,
              drivers::bytes("05 01 09 08 a1 01 85 01 09 36 15 00 26 f8 1f 75 10 95 01 81 02 c0"));
    EXPECT_EQ(drivers::make_height_decoder(log.devices.at(0)).value()->full_scale(), 8184);
}

TEST(Firmware, SendsEachReadingToTheBit)
{
    auto const counts = decoded(firmware_log());
    auto const readings = expected();
    ASSERT_EQ(counts.size(), 400u);
    EXPECT_EQ(counts.front(), 0);
    EXPECT_EQ(*std::max_element(counts.begin(), counts.end()), 8184);
    // The first readings may be missing, since the host was not ready yet. All later readings must
    // be there.
    constexpr std::size_t kMaxBefore = 10;
    std::size_t before = 0;
    while (before < kMaxBefore
           && !std::equal(counts.begin(), counts.end(),
                          readings.begin() + static_cast<std::ptrdiff_t>(before)))
        ++before;
    EXPECT_LT(before, kMaxBefore) << "the readings are not those that were fed";
}

TEST(Firmware, SendsThreeHundredReadingsASecond)
{
    auto const log = firmware_log();
    double const seconds = to_seconds(log.end() - log.begin());
    EXPECT_NEAR(399 / seconds, 16e6 / 128 / 13 / 32, 1);
}

} // namespace
} // namespace tractus
