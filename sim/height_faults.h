#pragma once

#include "calib/height_monitor.h"
#include "engine/base/time.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::sim {

// A fault of the height sensor while a hand draws. The true heights are not affected.
struct SimulatedHeightFault {
    calib::HeightFaultKind kind = calib::HeightFaultKind::Silence;
    Timestamp begin {};
    Timestamp end {}; // Time at which the sensor works again.

    // For Rail, the reading. For Jump or Stop, the offset added to the true reading, as after a
    // slip of the string. Unused for other kinds.
    std::int32_t counts = 0;
};

// Converts the readings of a healthy sensor into those of one with faults. Readings come in time
// order.
class HeightFaults {
public:
    explicit HeightFaults(std::vector<SimulatedHeightFault> faults);

    // Returns the reading at `now` in place of `counts`; no value if the sensor is silent. Jumps
    // are clamped to 0 to `full_scale`. If faults overlap, the earlier one in the list applies.
    std::optional<std::int32_t> apply(Timestamp now, std::int32_t counts, std::int32_t full_scale);

private:
    std::vector<SimulatedHeightFault> faults_;
    std::optional<std::int32_t> last_ {}; // The last reading, which a stuck sensor repeats.
};

} // namespace tractus::sim
