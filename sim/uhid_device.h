#pragma once

#include "drivers/reports/device_info.h"
#include "engine/base/result.h"
#include "sim/file_descriptor.h"
#include "sim/kernel_device.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

struct uhid_event; // Declared in linux/uhid.h.

namespace tractus::sim {

// Replies of an emulated device. Reports begin with their id if the device uses ids. If a function
// is missing, feature requests fail with an input/output error, and output reports are ignored.
struct UhidAnswers {
    // Handles an output report; a non-empty result is sent as an input report. If the device uses
    // no ids, reports from programs begin with a 0, those from drivers do not.
    std::function<std::vector<std::byte>(std::span<std::byte const> report)> output {};
    // Returns the feature report with this id; without a value, the request fails with an
    // input/output error.
    std::function<std::optional<std::vector<std::byte>>(std::uint8_t id)> get_feature {};
    // Handles a feature or output report set by a control request. If it returns false, the request
    // fails with an input/output error.
    std::function<bool(std::span<std::byte const> report)> set_feature {};
};

// A HID device emulated with the kernel's uhid: the kernel's drivers treat it as plugged in, and it
// has a hidraw node. It disappears with this object.
class UhidDevice final : public KernelDevice {
public:
    // Creates a device with the name, path, bus, ids and report descriptor of `info`. Fails with a
    // user error if /dev/uhid may not be used or the kernel refuses the descriptor.
    static Result<std::unique_ptr<UhidDevice>> create(drivers::DeviceInfo const& info,
                                                      UhidAnswers answers = {});

    void add_files_to(std::vector<pollfd>& files) const override;
    Result<void> serve() override;

    // Sends a report, which the kernel always accepts: reports that no program reads are dropped
    // silently.
    Result<void> send(std::span<std::byte const> report) override;

    bool is_read() const override { return is_open_; }
    bool detects_readers_by_reports() const override { return false; }
    std::uint64_t lost_count() const override { return 0; }
    std::size_t waiting_count() const override { return 0; }

private:
    UhidDevice(FileDescriptor file, UhidAnswers answers);

    Result<void> serve(uhid_event const& event);
    Result<void> reply_to(std::span<std::byte const> output);

    FileDescriptor file_;
    UhidAnswers answers_;
    bool is_open_ = false;
};

} // namespace tractus::sim
