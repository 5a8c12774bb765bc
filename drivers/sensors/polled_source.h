#pragma once

#include "drivers/links/packet_link.h"
#include "drivers/reports/report_source.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tractus::drivers {

using PacketTest = std::function<bool(std::span<std::byte const> packet)>;

// Sends `command` and waits for a packet that satisfies `is_reply`, skipping others, since some
// devices reply to several hosts. Repeats the command after 50 ms without a reply, up to `attempts`
// times in total; returns no value if there is no reply at all. Fails when the link does.
Result<std::optional<RawReport>> exchange(PacketLink& link, std::span<std::byte const> command,
                                          PacketTest const& is_reply, int attempts);

// Describes how a sensor that sends only on request is polled.
struct Polling {
    std::vector<std::byte> command {}; // Packet that requests one reading.
    PacketTest is_reply {};            // True for a packet that is the reply to `command`.
    Duration period {};                // Time between two requests; replies may be slower.

    // Prepares the sensor. Called first, and again after a packet that satisfies `spoils`, which
    // shows that another program has changed the settings.
    std::function<Result<void>(PacketLink&)> set_up {};
    PacketTest spoils {}; // Empty if no packet shows that settings have changed.
};

// Opens a source that polls within read(), and therefore on the thread that reads. A lost reply is
// followed by the next request; reading fails with a device error when there was no reply for a
// second.
//
// Opening fails when `set_up` does.
Result<std::unique_ptr<ReportSource>> open_polled(DeviceInfo info, std::unique_ptr<PacketLink> link,
                                                  Polling polling);

} // namespace tractus::drivers
