#include "drivers/packet_link.h"

#include <chrono>
#include <thread>

namespace tractus {

Timestamp RealPacketLink::now()
{
    return Timestamp(std::chrono::steady_clock::now().time_since_epoch());
}

void RealPacketLink::sleep(Duration duration)
{
    std::this_thread::sleep_for(duration);
}

} // namespace tractus
