#pragma once

#include "engine/base/time.h"

#include <cstdint>

namespace tractus::drivers {

// One reading of the height sensor, in counts of its converter; calib converts it to a height.
struct HeightSample {
    Timestamp time {};       // Arrival time of the report; the sensor's latency is not subtracted.
    std::int32_t counts = 0; // Reading, from 0 to full_scale.
    std::int32_t full_scale = 0; // Greatest reading of the converter, such as 4095 for 12 bits.
};

} // namespace tractus::drivers
