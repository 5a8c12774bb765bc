#pragma once

#include "engine/base/time.h"

#include <cstdint>

namespace tractus::drivers {

// One reading of the height sensor, as its converter gave it; calib knows what it means.
struct HeightSample {
    Timestamp time {};           // When the report arrived; the sensor's latency is still in it.
    std::int32_t counts = 0;     // 0 to full_scale.
    std::int32_t full_scale = 0; // The converter's greatest reading: 4095 for 12 bits.
};

} // namespace tractus::drivers
