#include "drivers/packet_link.h"

#include "drivers/clock.h"

#include <thread>

namespace tractus {

Timestamp RealPacketLink::now()
{
    return monotonic_now();
}

void RealPacketLink::sleep(Duration duration)
{
    std::this_thread::sleep_for(duration);
}

} // namespace tractus
