#pragma once

#include "drivers/device_info.h"
#include "drivers/height_sample.h"
#include "drivers/report_descriptor.h"
#include "drivers/report_source.h"
#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace tractus {

// Turns the reports of a height sensor into samples: a HID device with one absolute Generic Desktop
// "Slider" (HID Usage Tables, page 0x01, usage 0x36) whose logical range is 0 to the converter's
// full scale. See firmware-notes/height-sensor.md for a descriptor and a report byte by byte.
//
// Without state: the same report always gives the same sample.
class HeightDecoder {
public:
    // Fails, as the user's fault, if the device has no such field, and as the device's if its
    // descriptor is broken. Joysticks and game pads have sliders too, and are refused.
    static Result<HeightDecoder> create(DeviceInfo const&);

    // The converter's greatest reading.
    std::int32_t full_scale() const { return static_cast<std::int32_t>(field_.logical_maximum); }

    // No value for another report id. Fails, as the device's fault, if the report is too short or
    // its value lies outside 0 to full scale.
    Result<std::optional<HeightSample>> decode(Timestamp received,
                                               std::span<std::byte const> report) const;

    Result<std::optional<HeightSample>> decode(RawReport const& report) const
    {
        return decode(report.received, report.bytes());
    }

private:
    explicit HeightDecoder(HidField const& field, std::size_t report_size)
        : field_(field)
        , report_size_(report_size)
    {
    }

    HidField field_;
    std::size_t report_size_; // As the descriptor says.
};

} // namespace tractus
