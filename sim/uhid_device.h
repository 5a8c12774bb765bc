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

struct uhid_event; // linux/uhid.h

namespace tractus::sim {

// Answers of a device. Reports begin with their id if the device numbers them. Each may be left
// out: then features are an input/output error to the kernel, and output reports are ignored.
struct UhidAnswers {
    // An output report has come; what this gives, unless it is empty, is sent as an input report.
    // A program's report begins with 0 if the device does not number them, a driver's does not.
    std::function<std::vector<std::byte>(std::span<std::byte const> report)> output {};
    // The feature report of this id; no value is an input/output error.
    std::function<std::optional<std::vector<std::byte>>(std::uint8_t id)> get_feature {};
    // A report, feature or output, is set by a control request. False is an input/output error.
    std::function<bool(std::span<std::byte const> report)> set_feature {};
};

// A HID device made with the kernel's uhid: its drivers take it for one that is plugged in, and it
// has a hidraw node. It goes with the value.
class UhidDevice final : public KernelDevice {
public:
    // Name, path, bus, ids and report descriptor are those of `info`. Fails, as the user's fault,
    // if /dev/uhid may not be used or the kernel refuses the descriptor.
    static Result<std::unique_ptr<UhidDevice>> create(drivers::DeviceInfo const& info,
                                                      UhidAnswers answers = {});

    void add_files_to(std::vector<pollfd>& files) const override;
    Result<void> serve() override;

    // Always taken: the kernel drops what no program reads, without saying so.
    Result<void> send(std::span<std::byte const> report) override;

    bool is_read() const override { return is_open_; }
    bool tells_readers_by_reports() const override { return false; }
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
