#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <poll.h>
#include <span>
#include <vector>

namespace tractus::sim {

// A device that this program plays to the kernel: through uhid, or as a function of a USB gadget.
// It has no thread and no clock: whoever plays it waits for its files with poll(2) and calls
// serve(). Nothing here blocks.
class KernelDevice {
public:
    virtual ~KernelDevice() = default;

    // The files to wait for. May be others after each serve() and send().
    virtual void add_files_to(std::vector<pollfd>& files) const = 0;

    // Answers what the kernel asked and hands it what waits. Fails if the device is not one any
    // more; that its host is away is no failure.
    virtual Result<void> serve() = 0;

    // Takes a report for the kernel, or drops it: see lost_count(). Fails as serve() does.
    virtual Result<void> send(std::span<std::byte const> report) = 0;

    // Whether a program reads the device now, as far as can be told.
    virtual bool is_read() const = 0;

    // Whether is_read() becomes true by a report's being taken, and by nothing else.
    virtual bool tells_readers_by_reports() const = 0;

    // How many reports were dropped because nobody read them in time, or there was no host any
    // more; those from before the first reader do not count.
    virtual std::uint64_t lost_count() const = 0;

    // How many were sent and are not yet known to have been taken.
    virtual std::size_t waiting_count() const = 0;
};

} // namespace tractus::sim
