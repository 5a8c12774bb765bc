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

// The station's own height sensor as USB shows it (firmware-notes/height-sensor-protocol.md): its
// descriptors, its answers to control requests and its frames. Knows no clock and no USB; a gadget
// gives it the one and puts it behind the other.

// A frame as bytes, its CRC last. At least one reading, at most kMaxHeightFrameSamples.
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

    // Standard descriptors, whole. An interface's strings have the numbers of strings().
    std::vector<std::byte> device_descriptor() const;
    std::vector<std::byte> configuration_descriptor(UsbSpeed) const;
    std::vector<std::byte> bos_descriptor() const;
    std::vector<std::byte> microsoft_os_descriptors() const;
    std::vector<std::string> strings() const; // Strings from number 1 on.

    // Returns what stands behind the configuration's header: the interface and its endpoint, which
    // is all that FunctionFS wants. `string` is the number of the interface's text.
    std::vector<std::byte> interface_descriptors(UsbSpeed, std::uint8_t string) const;
    std::string interface_string() const;

    // Returns what the station knows of the sensor once it has opened it.
    drivers::DeviceInfo info() const;

    // The data of the answer, at most `setup.length` bytes; no value for a request that stalls.
    // `now_us` is the sensor's clock.
    std::optional<std::vector<std::byte>> answer(UsbSetup const& setup, std::uint32_t now_us) const;

    // A request with data to the sensor, or none. False: it stalls, and changes nothing.
    bool accept(UsbSetup const& setup, std::span<std::byte const> data);

    bool is_streaming() const { return is_streaming_; }
    std::uint16_t period_us() const { return period_us_; }
    drivers::HeightReference reference() const { return reference_; }

    // A reading at `device_us` of the sensor's clock. The frame that it fills, if it fills one and
    // streaming is on. Readings are taken every period_us().
    std::optional<std::vector<std::byte>> push(std::uint32_t device_us, std::uint16_t counts);

    // The host did not fetch frames in time: so many were lost in the sensor.
    void lose_frames(std::uint16_t count);

private:
    Options options_;
    std::uint16_t period_us_;
    std::uint8_t samples_per_frame_;
    drivers::HeightReference reference_ = drivers::HeightReference::Supply;
    bool is_streaming_ = false;
    drivers::HeightFrame frame_ {}; // The one being filled.
};

} // namespace tractus::sim
