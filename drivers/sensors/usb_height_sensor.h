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

// Options of the station's own height sensor; members without a value leave the sensor's setting
// unchanged.
struct UsbHeightSensorOptions {
    std::optional<std::uint16_t> period_us {}; // Time between readings in microseconds.
    // Number of readings per frame, 1 to kMaxHeightFrameSamples.
    std::optional<std::uint8_t> samples_per_frame {};
    std::optional<HeightReference> reference {};
};

// Parses "2000us,internal": the period, and supply or internal; an empty text gives the defaults.
// Fails with a user error for other words.
Result<UsbHeightSensorOptions> parse_usb_height_sensor_options(std::string_view settings);

// Opens the station's own height sensor (firmware-notes/height-sensor-protocol.md) at
// `info.location` ("usb:1-2.3") through libusb with the options in `info.settings`, stops the
// stream, discards earlier frames, and starts it. A report is one transfer, normally one frame.
// Destroying the source stops the sensor.
//
// Fails with a user error if the sensor cannot be opened or refuses the options, and with a device
// error if it is another device or has another protocol version. A read fails with a device error
// when the sensor was unplugged, regardless of the error that libusb reports.
Result<std::unique_ptr<ReportSource>> open_usb_height_sensor(DeviceInfo info);

// Communication with the project's own height sensor. Requests go to the sensor's USB interface.
class HeightSensorLink {
public:
    virtual ~HeightSensorLink() = default;

    // Sends a control request. Fails if the sensor stalls or is gone.
    virtual Result<std::vector<std::byte>> get(HeightSensorRequest request, std::size_t bytes) = 0;
    virtual Result<void> set(HeightSensorRequest request, std::uint16_t value,
                             std::span<std::byte const> data)
        = 0;

    // Reads the next transfer of the endpoint, like ReportSource::read().
    virtual Result<std::optional<RawReport>> read(Duration timeout) = 0;
};

// Opens a sensor over any link. Fails like the overload for a DeviceInfo, except for opening the
// device.
Result<std::unique_ptr<ReportSource>> open_usb_height_sensor(DeviceInfo info,
                                                             std::unique_ptr<HeightSensorLink> link,
                                                             UsbHeightSensorOptions const& options);

} // namespace tractus::drivers
