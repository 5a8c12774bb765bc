#pragma once

#include "engine/base/time.h"

namespace tractus::drivers {

// Returns the time of the machine's monotonic clock, which also stamps reports.
inline Timestamp monotonic_now()
{
    return Timestamp(std::chrono::steady_clock::now().time_since_epoch());
}

} // namespace tractus::drivers
