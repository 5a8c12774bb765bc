#pragma once

#include "engine/base/time.h"

namespace tractus::drivers {

// The machine's monotonic clock, by which the times of reports are taken.
inline Timestamp monotonic_now()
{
    return Timestamp(std::chrono::steady_clock::now().time_since_epoch());
}

} // namespace tractus::drivers
