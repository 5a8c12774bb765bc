#include "drivers/links/packet_link.h"

#include "drivers/reports/clock.h"

#include <thread>

namespace tractus::drivers {

Timestamp RealPacketLink::now()
{
    return monotonic_now();
}

void RealPacketLink::sleep(Duration duration)
{
    std::this_thread::sleep_for(duration);
}

} // namespace tractus::drivers
