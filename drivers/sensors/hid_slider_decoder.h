#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::drivers {

// Makes a decoder for a HID device with one absolute Generic Desktop "Slider" (HID Usage Tables,
// page 0x01, usage 0x36) whose logical range is 0 to the converter's full scale. See
// firmware-notes/height-sensor.md for a descriptor and a report byte by byte. Stateless: equal
// reports give equal samples.
//
// Fails with a user error if the device has no such field, and with a device error if its
// descriptor is broken. Joysticks and game pads, which have sliders too, are refused. Decoding
// skips reports with another id, and fails if the report is too short or its value lies outside 0
// to full scale.
Result<std::unique_ptr<HeightDecoder>> make_hid_slider_decoder(DeviceInfo const&);

} // namespace tractus::drivers
