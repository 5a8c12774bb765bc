#pragma once

#include "drivers/reports/report_source.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace tractus::drivers {

// Sends and receives whole packets of a device that answers commands, and provides the clock.
// Drivers of such devices depend on nothing else, so they also run against a simulated device in
// simulated time. Single-threaded.
class PacketLink {
public:
    virtual ~PacketLink() = default;

    // Sends a packet. Fails with a device error if the device is gone.
    virtual Result<void> write(std::span<std::byte const> packet) = 0;

    // The next packet with its arrival time; no value after `timeout`. Fails with a device error if
    // the device is gone.
    virtual Result<std::optional<RawReport>> read(Duration timeout) = 0;

    // Number of packets dropped because they are longer than a RawReport.
    virtual std::uint64_t oversized_count() const { return 0; }

    virtual Timestamp now() = 0;
    virtual void sleep(Duration duration) = 0;
};

// A link that uses the monotonic clock.
class RealPacketLink : public PacketLink {
public:
    Timestamp now() override;
    void sleep(Duration duration) override;
};

} // namespace tractus::drivers
