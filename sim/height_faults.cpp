#include "sim/height_faults.h"

#include <algorithm>
#include <utility>

namespace tractus::sim {

HeightFaults::HeightFaults(std::vector<SimulatedHeightFault> faults)
    : faults_(std::move(faults))
{
}

std::optional<std::int32_t> HeightFaults::apply(Timestamp now, std::int32_t counts,
                                                std::int32_t full_scale)
{
    auto const fault = std::find_if(faults_.begin(), faults_.end(),
                                    [&](auto const& f) { return f.begin <= now && now < f.end; });
    if (fault != faults_.end()) {
        switch (fault->kind) {
        case calib::HeightFaultKind::Silence:
            return std::nullopt;
        case calib::HeightFaultKind::Rail:
            counts = fault->counts;
            break;
        case calib::HeightFaultKind::Jump:
        // A slip of the string shifts all later readings, whether it is later reported as a jump or
        // as a moved stop.
        case calib::HeightFaultKind::Stop:
            counts = std::clamp(counts + fault->counts, 0, full_scale);
            break;
        case calib::HeightFaultKind::Stuck:
            counts = last_.value_or(counts);
            break;
        }
    }
    last_ = counts;
    return counts;
}

} // namespace tractus::sim
