// What the height sensors' decoders make of anything. The first byte chooses the sensor; what
// follows is cut into reports: a byte of length, then so many bytes.

#include "drivers/height_decoder.h"
#include "drivers/sensors/height_sensor_protocol.h"
#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace tractus;

std::array<DeviceInfo, 4> const& sensors()
{
    static std::array<DeviceInfo, 4> const all {
        DeviceInfo { .name = "Height sensor",
                     .strings = { { 4, std::string(kHeightSensorTitle) + "4095" } } },
        DeviceInfo { .name = "MCP2221, GP2", .vendor_id = 0x04D8, .product_id = 0x00DD },
        DeviceInfo { .name = "LabJack U3", .vendor_id = 0x0CD5, .product_id = 0x0003 },
        DeviceInfo { .name = "Height sensor",
                     .strings = { { 4, std::string(kHeightSensorTitle) + "65535" } } },
    };
    return all;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    auto input = std::as_bytes(std::span(data, size));
    if (input.empty())
        return 0;
    auto const& info = sensors()[data[0] % sensors().size()];
    input = input.subspan(1);

    auto const decoder = make_height_decoder(info).value();
    std::vector<HeightSample> samples;
    Timestamp received { std::chrono::seconds(1) };
    while (!input.empty()) {
        auto const length = std::min(std::to_integer<std::size_t>(input[0]), input.size() - 1);
        auto const report = input.subspan(1, length);
        (void)decoder->decode(received, report, samples);
        // Now and then much later: an hour for the longest reports.
        received += std::chrono::milliseconds(1) * (length < 200 ? 1 : 3'600'000);
        input = input.subspan(1 + length);
    }

    bool const is_framed = info.name == "Height sensor";
    for (std::size_t i = 0; i < samples.size(); ++i) {
        CHECK(samples[i].counts >= 0 && samples[i].counts <= decoder->full_scale());
        CHECK(!is_framed || i == 0 || samples[i].time > samples[i - 1].time);
    }
    return 0;
}
