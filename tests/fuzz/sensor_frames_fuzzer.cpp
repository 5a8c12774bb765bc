// Fuzzes the height sensors' decoders. The first byte chooses the sensor. If the byte's highest
// bit is set, every report gets a valid frame CRC at its end, which a fuzzer cannot find by itself.
// The rest are reports, each after a byte with its length.

#include "drivers/height_decoders.h"
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

std::array<drivers::DeviceInfo, 6> const& sensors()
{
    static std::array<drivers::DeviceInfo, 6> const all {
        drivers::DeviceInfo { .name = "Height sensor",
                              .strings
                              = { { 4, std::string(drivers::kHeightSensorTitle) + "4095" } } },
        drivers::DeviceInfo { .name = "MCP2221, GP2", .vendor_id = 0x04D8, .product_id = 0x00DD },
        drivers::DeviceInfo { .name = "LabJack U3", .vendor_id = 0x0CD5, .product_id = 0x0003 },
        drivers::DeviceInfo { .name = "Height sensor",
                              .strings
                              = { { 4, std::string(drivers::kHeightSensorTitle) + "65535" } } },
        drivers::DeviceInfo { .name = "serial line",
                              .physical_path = "serial:/dev/ttyACM0@115200,max=500.00" },
        drivers::DeviceInfo { .name = "ads1015 voltage0",
                              .physical_path = "iio-channel:iio:device0:voltage0@max=2047" },
    };
    return all;
}

void end_with_crc(std::span<std::byte> report)
{
    if (report.size() < drivers::kHeightFrameCrcBytes)
        return;
    auto const crc
        = drivers::height_frame_crc(report.first(report.size() - drivers::kHeightFrameCrcBytes));
    report[report.size() - 2] = static_cast<std::byte>(crc & 0xFF);
    report[report.size() - 1] = static_cast<std::byte>(crc >> 8);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    auto input = std::as_bytes(std::span(data, size));
    if (input.empty())
        return 0;
    auto const& info = sensors()[data[0] % sensors().size()];
    bool const is_mended = (data[0] & 0x80) != 0;
    input = input.subspan(1);

    auto const decoder = drivers::make_height_decoder(info).value();
    std::vector<drivers::HeightSample> samples;
    Timestamp received { std::chrono::seconds(1) };
    while (!input.empty()) {
        auto const length = std::min(std::to_integer<std::size_t>(input[0]), input.size() - 1);
        std::vector<std::byte> report(input.begin() + 1,
                                      input.begin() + 1 + static_cast<std::ptrdiff_t>(length));
        if (is_mended)
            end_with_crc(report);
        (void)decoder->decode(received, report, samples);
        // An hour passes after a report of at least 200 bytes, otherwise a millisecond.
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
