// Parsers must return a result for any content of a device or a file, without reading or writing
// out of bounds; the sanitizers check this while these tests run.

#include "drivers/height_decoders.h"
#include "drivers/logs/log.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/report_descriptor.h"
#include "drivers/tablets/pen_decoders.h"
#include "engine/base/random.h"
#include "tests/drivers/decode_one.h"
#include "tests/drivers/devices.h"

#include <gtest/gtest.h>
#include <string>

namespace tractus::drivers {
namespace {

constexpr int kCases = 10'000;

// Replaces, inserts or removes a few elements at random positions.
template<typename Container> Container mutated(Container bytes, Random& random)
{
    using Value = typename Container::value_type;
    auto const changes = 1 + random.next_u32() % 8;
    for (unsigned i = 0; i < changes && !bytes.empty(); ++i) {
        auto const at = static_cast<std::ptrdiff_t>(random.next_u32() % bytes.size());
        auto const value = static_cast<Value>(random.next_u32() & 0xFF);
        switch (random.next_u32() % 4) {
        case 0:
            bytes.insert(bytes.begin() + at, value);
            break;
        case 1:
            bytes.erase(bytes.begin() + at);
            break;
        default:
            bytes[static_cast<std::size_t>(at)] = value;
            break;
        }
    }
    return bytes;
}

std::vector<std::byte> noise(Random& random, std::size_t size)
{
    std::vector<std::byte> bytes(size);
    for (auto& byte : bytes)
        byte = static_cast<std::byte>(random.next_u32() & 0xFF);
    return bytes;
}

TEST(HostileInput, MutatedDescriptorsGiveADecoderOrAnError)
{
    Random random({ .seed = 1 });
    int decoders = 0;
    int refused = 0;
    for (int i = 0; i < kCases; ++i) {
        auto info = i % 8 == 0 ? simple_height_sensor() : simple_pen();
        info.report_descriptor = mutated(std::move(info.report_descriptor), random);
        auto const report = noise(random, random.next_u32() % 32);
        std::vector<HeightSample> heights;
        if (auto const height = make_height_decoder(info))
            (void)(*height)->decode({}, report, heights);
        auto pen = make_pen_decoder(info);
        if (!pen) {
            ++refused;
            continue;
        }
        ++decoders;
        auto const sample = decode_one(**pen, {}, report);
        if (sample && *sample) {
            EXPECT_TRUE((*sample)->position_mm.allFinite());
        }
    }
    // The mutations must produce both valid and invalid descriptors.
    EXPECT_GT(decoders, kCases / 100);
    EXPECT_GT(refused, kCases / 100);
}

TEST(HostileInput, NoiseIsNoDescriptor)
{
    Random random({ .seed = 2 });
    for (int i = 0; i < kCases; ++i)
        (void)parse_report_descriptor(noise(random, random.next_u32() % 256));
}

TEST(HostileInput, MutatedLogsGiveALogOrAnError)
{
    std::string const whole
        = "D: 0\nR: 3 05 0d c0\nN: pen\nI: 3 056a 037a\nE: 000000.000000 2 02 80\n"
          "D: 1\nR: 1 c0\nC: a = 1\nT: 0.5 draw tip\nE: 000001.250000 1 01\n";
    Random random({ .seed = 3 });
    int logs = 0;
    int refused = 0;
    for (int i = 0; i < kCases; ++i) {
        auto const log = parse_log(mutated(whole, random), "mutated.hid");
        if (!log) {
            ++refused;
            continue;
        }
        ++logs;
        for (auto const& record : log->records) {
            EXPECT_LT(record.device, log->devices.size());
            EXPECT_LE(record.offset + record.size, log->bytes.size());
        }
    }
    EXPECT_GT(logs, kCases / 100);
    EXPECT_GT(refused, kCases / 100);
}

} // namespace
} // namespace tractus::drivers
