#pragma once

#include "drivers/log.h"
#include "engine/base/result.h"
#include "sim/kernel_device.h"

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tractus {

// One device of a log, and what plays it to the kernel.
struct PlayedDevice {
    std::size_t log_device = 0; // In Log::devices.
    std::unique_ptr<KernelDevice> device;
};

// When a log's reports are sent. The times between them stay as they were recorded, unless one of
// these says otherwise.
struct PlaybackOptions {
    std::optional<double> rate_hz {}; // All reports, of all devices, in even steps.
    bool at_once = false;             // Each as soon as the one before is on its way.
    bool stay = false;                // After the last report stay plugged in until asked to stop.
};

struct PlaybackCounts {
    std::size_t reports = 0; // Sent, whether somebody read them or not.
    std::size_t lost = 0;    // Of these, what the devices know to be lost.
};

// Plays a log's devices to the kernel: waits until each of them is read by somebody, sends the
// reports, and stays until they have been taken. Whatever the kernel asks of the devices is
// answered all the while. Ends when `stop` becomes true, too, or at a signal once it has.
// Fails with the devices' errors.
Result<PlaybackCounts> play_devices(Log const& log, std::span<PlayedDevice const> devices,
                                    PlaybackOptions const& options, std::atomic<bool> const& stop);

} // namespace tractus
