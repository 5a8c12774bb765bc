#pragma once

#include "drivers/reports/device_info.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace tractus::drivers {

// One report, exactly as it came off the wire, its report id first if the device uses ids. A source
// refuses a longer one.
//
// An empty one (size 0) is no report: it says that the device went away at that time, and what it
// was doing is over. Only a ReconnectingSource, and a log of one, hands out such.
struct RawReport {
    Timestamp received {};
    std::size_t size = 0;
    std::array<std::byte, 512> storage {};

    std::span<std::byte const> bytes() const { return { storage.data(), size }; }
};

// Anything that hands us reports: a tablet, the height ADC, a simulated one, a log being replayed.
// Decoding is somebody else's work, so a log made from any source replays through the same decoder.
class ReportSource {
public:
    virtual ~ReportSource() = default;

    virtual DeviceInfo const& info() const = 0;

    // Waits for the next report, at most `timeout`. No value means that nothing came in time.
    // After an error the source is dead: destroy it. Called from one thread only.
    [[nodiscard]] virtual Result<std::optional<RawReport>> read(Duration timeout) = 0;

    // How many reports came, since the start, that are longer than a RawReport holds and were left
    // out. Called from the thread that reads.
    virtual std::uint64_t too_long_count() const { return 0; }
};

} // namespace tractus::drivers
