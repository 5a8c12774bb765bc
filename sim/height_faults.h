#pragma once

#include "calib/height_monitor.h"
#include "engine/base/time.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::sim {

// Something that goes wrong with the height sensor while a hand draws: the truth beside the bytes.
struct SimulatedHeightFault {
    calib::HeightFaultKind kind = calib::HeightFaultKind::Silence;
    Timestamp begin {};
    Timestamp end {}; // It is well again from here on.

    // Rail: what it reads. Jump or stop: how much more than the truth it reads, as after a string's
    // slip. Of no meaning for the others.
    std::int32_t counts = 0;
};

// Turns the readings of a healthy sensor into those of one with faults. Readings come in time
// order.
class HeightFaults {
public:
    explicit HeightFaults(std::vector<SimulatedHeightFault> faults);

    // Returns what the sensor reads at `now` in place of `counts`; no value if it is silent. Jumps
    // are clamped to 0 to `full_scale`. Where faults overlap, the earlier in the list counts.
    std::optional<std::int32_t> apply(Timestamp now, std::int32_t counts, std::int32_t full_scale);

private:
    std::vector<SimulatedHeightFault> faults_;
    std::optional<std::int32_t> last_ {}; // The last reading, where a string may be stuck.
};

} // namespace tractus::sim
