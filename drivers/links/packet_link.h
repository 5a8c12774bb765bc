#pragma once

#include "drivers/reports/report_source.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace tractus::drivers {

// The way of whole packets to and from a device that answers commands, and the clock beside it. The
// drivers of such devices know nothing else of the world, so they run against a simulated device,
// in its time, as they do against a real one. Called from one thread only.
class PacketLink {
public:
    virtual ~PacketLink() = default;

    // Fails, as the device's fault, when the device is gone.
    virtual Result<void> write(std::span<std::byte const> packet) = 0;

    // The next packet, stamped when it came. No value if none comes within `timeout`. Fails, as the
    // device's fault, when the device is gone.
    virtual Result<std::optional<RawReport>> read(Duration timeout) = 0;

    // How many packets were left out since they are longer than a RawReport holds.
    virtual std::uint64_t too_long_count() const { return 0; }

    virtual Timestamp now() = 0;
    virtual void sleep(Duration duration) = 0;
};

// A link in the world's time: that of the monotonic clock.
class RealPacketLink : public PacketLink {
public:
    Timestamp now() override;
    void sleep(Duration duration) override;
};

} // namespace tractus::drivers
