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

// Sends `command` and waits for the packet that `is_reply` takes, passing over others: some devices
// answer to several masters. Asks again when none comes in 50 ms, `attempts` times in all; no value
// if none ever comes. Fails when the link does.
Result<std::optional<RawReport>> exchange(PacketLink& link, std::span<std::byte const> command,
                                          PacketTest const& is_reply, int attempts);

// How a sensor that speaks only when it is asked becomes a source.
struct Polling {
    std::vector<std::byte> command {}; // Asks for one reading.
    PacketTest is_reply {};            // Whether a packet is the answer to it.
    Duration period {};                // Time between two questions; the answers may be slower.

    // Prepares the sensor: called first of all, and again after a packet that `spoils` takes, since
    // somebody else has changed its settings.
    std::function<Result<void>(PacketLink&)> set_up {};
    PacketTest spoils {}; // Spoiling packets; none if it is empty.
};

// Asks in read(), so whoever reads from a thread of its own polls from that thread. An answer that
// is lost is asked for again with the next reading; reading fails, as the device's fault, when none
// has come for a second.
//
// Opening fails when the set-up does.
Result<std::unique_ptr<ReportSource>> open_polled(DeviceInfo info, std::unique_ptr<PacketLink> link,
                                                  Polling polling);

} // namespace tractus::drivers
