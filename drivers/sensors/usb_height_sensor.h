#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/report_source.h"
#include "drivers/sensors/height_sensor_protocol.h"
#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace tractus::drivers {

// Wishes for the station's own height sensor; what has no value stays as the sensor has it.
struct UsbHeightSensorOptions {
    std::optional<std::uint16_t> period_us {};        // Time between readings.
    std::optional<std::uint8_t> samples_per_frame {}; // 1 to kMaxHeightFrameSamples.
    std::optional<HeightReference> reference {};
};

// "2000us,internal": the period, and supply or internal; nothing for the defaults. Fails, as the
// user's fault, for other words.
Result<UsbHeightSensorOptions> parse_usb_height_sensor_options(std::string_view settings);

// Opens the station's own height sensor (firmware-notes/height-sensor-protocol.md) at
// `info.location` ("usb:1-2.3") through libusb, with `info.settings` as options, has it stop,
// forgets what it had sent before, and has it start: a report is one transfer as it came, as a rule
// one frame. It stops when the source goes.
//
// Fails, as the user's fault, if it cannot be opened or refuses the options, and as the device's if
// it is no such sensor or speaks another version. A read fails, as the device's fault, when it was
// unplugged, whatever libusb calls that.
Result<std::unique_ptr<ReportSource>> open_usb_height_sensor(DeviceInfo info);

// The way to such a sensor. The requests are those to its interface.
class HeightSensorLink {
public:
    virtual ~HeightSensorLink() = default;

    // Fail if the sensor stalls or is gone.
    virtual Result<std::vector<std::byte>> get(HeightSensorRequest request, std::size_t bytes) = 0;
    virtual Result<void> set(HeightSensorRequest request, std::uint16_t value,
                             std::span<std::byte const> data)
        = 0;

    // The next transfer of its endpoint, as a source reads.
    virtual Result<std::optional<RawReport>> read(Duration timeout) = 0;
};

// Opens one over any link. Fails likewise, but for opening the device.
Result<std::unique_ptr<ReportSource>> open_usb_height_sensor(DeviceInfo info,
                                                             std::unique_ptr<HeightSensorLink> link,
                                                             UsbHeightSensorOptions const& options);

} // namespace tractus::drivers
