#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::drivers {

// True if one of the device's strings identifies it as the station's own height sensor.
bool is_height_frame_device(DeviceInfo const&);

// Makes a decoder for the station's own height sensor (firmware-notes/height-sensor-protocol.md).
// It accepts the sensor's frames in pieces of any length. Each reading gets the time at which it
// was taken: the sensor's clock is mapped to the host's, so a late frame does not shift the height.
// The times contain the minimum transmission time as their only latency, and never go back.
//
// Fails with a device error if the greatest reading is missing from the device's string.
// Decoding fails for reports with corrupt frames, bytes between frames or impossible readings, and
// continues with the next frame.
Result<std::unique_ptr<HeightDecoder>> make_height_frame_decoder(DeviceInfo const&);

} // namespace tractus::drivers
