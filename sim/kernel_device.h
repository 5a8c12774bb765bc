#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <poll.h>
#include <span>
#include <vector>

namespace tractus::sim {

// A device that this program emulates for the kernel, through uhid or as a function of a USB
// gadget. It has no thread and no clock: the caller waits for its files with poll(2) and calls
// serve(). No function blocks.
class KernelDevice {
public:
    virtual ~KernelDevice() = default;

    // Adds the files to wait for, which may change with each serve() and send().
    virtual void add_files_to(std::vector<pollfd>& files) const = 0;

    // Answers the kernel's requests and passes on waiting reports. Fails if the device no longer
    // exists; an absent host is not a failure.
    virtual Result<void> serve() = 0;

    // Sends a report to the kernel, or drops it (lost_count()). Fails like serve().
    virtual Result<void> send(std::span<std::byte const> report) = 0;

    // True if a program reads the device at present, as far as this can be known.
    virtual bool is_read() const = 0;

    // True if is_read() changes to true only when a report is taken.
    virtual bool detects_readers_by_reports() const = 0;

    // Number of reports dropped because nobody read them in time or there was no host; reports
    // before the first reader do not count.
    virtual std::uint64_t lost_count() const = 0;

    // Number of reports sent and not yet known to have been taken.
    virtual std::size_t waiting_count() const = 0;
};

} // namespace tractus::sim
