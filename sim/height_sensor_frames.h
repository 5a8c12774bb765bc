#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/sensors/height_sensor_protocol.h"
#include "sim/usb_setup.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus::sim {

// The station's own height sensor as seen over USB (firmware-notes/height-sensor-protocol.md): its
// descriptors, its answers to control requests and its frames. It contains neither a clock nor USB
// transport; a gadget provides both.

// Encodes a frame with 1 to kMaxHeightFrameSamples readings as bytes, and appends its CRC.
std::vector<std::byte> encode_height_frame(drivers::HeightFrame const& frame);

enum class UsbSpeed { Full, High };

class HeightSensorModel {
public:
    struct Options {
        std::uint16_t full_scale = 4095;
        std::uint16_t period_us = 1000;
        std::uint8_t samples_per_frame = 5;
        std::string serial_number = "0001";
    };

    HeightSensorModel();
    explicit HeightSensorModel(Options const& options);

    // Complete standard descriptors. String indices in them refer to strings().
    std::vector<std::byte> device_descriptor() const;
    std::vector<std::byte> configuration_descriptor(UsbSpeed) const;
    std::vector<std::byte> bos_descriptor() const;
    std::vector<std::byte> microsoft_os_descriptors() const;
    std::vector<std::string> strings() const; // Strings, beginning with index 1.

    // Returns the descriptors that follow the configuration's header: the interface and its
    // endpoint. FunctionFS needs them. `string` is the index of the interface's string.
    std::vector<std::byte> interface_descriptors(UsbSpeed, std::uint8_t string) const;
    std::string interface_string() const;

    // Returns what the station knows of the sensor after opening it.
    drivers::DeviceInfo info() const;

    // Returns the reply data, at most `setup.length` bytes; no value for a request that stalls.
    // `now_us` is the sensor's clock.
    std::optional<std::vector<std::byte>> answer(UsbSetup const& setup, std::uint32_t now_us) const;

    // Handles a request to the sensor, with or without data. Returns false, and changes nothing, if
    // the request stalls.
    bool accept(UsbSetup const& setup, std::span<std::byte const> data);

    bool is_streaming() const { return is_streaming_; }
    std::uint16_t period_us() const { return period_us_; }
    drivers::HeightReference reference() const { return reference_; }

    // Adds a reading taken at `device_us` of the sensor's clock. Readings are added every
    // period_us(). Returns the frame that the reading completes, if streaming is on.
    std::optional<std::vector<std::byte>> push(std::uint32_t device_us, std::uint16_t counts);

    // Simulates frames lost in the sensor because the host did not fetch them in time.
    void lose_frames(std::uint16_t count);

private:
    Options options_;
    std::uint16_t period_us_;
    std::uint8_t samples_per_frame_;
    drivers::HeightReference reference_ = drivers::HeightReference::Supply;
    bool is_streaming_ = false;
    drivers::HeightFrame frame_ {}; // Frame being filled.
};

} // namespace tractus::sim
