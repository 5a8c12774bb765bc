#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "engine/base/result.h"

#include <memory>

namespace tractus::drivers {

// Whether the device is the station's own height sensor: one of its strings says so.
bool is_height_frame_device(DeviceInfo const&);

// Makes a decoder for the station's own height sensor (firmware-notes/height-sensor-protocol.md):
// for its frames, as they came over the wire, in pieces of any length. Each reading has the time at
// which it was taken, by the sensor's clock mapped to the host's, so that a frame that comes late
// does not move the height; of the latency only the least transmission time remains. Times never go
// back.
//
// Fails, as the device's fault, if its string does not tell the greatest reading. Decoding fails
// for reports with corrupt frames, bytes between frames or impossible readings, and goes on with
// the next frame.
Result<std::unique_ptr<HeightDecoder>> make_height_frame_decoder(DeviceInfo const&);

} // namespace tractus::drivers
