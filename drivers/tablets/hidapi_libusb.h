#pragma once

#include "drivers/links/hid_back_end.h"
#include "drivers/reports/device_address.h"
#include "drivers/reports/device_info.h"
#include "engine/base/result.h"

#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace tractus::drivers {

// Hidapi's libusb back end, used beside its hidraw back end. The two libraries use the same symbol
// names and would call each other's functions, so the libusb back end is linked from its static
// library, with symbols renamed at build time (see drivers/tablets/CMakeLists.txt). This also works
// with sanitizers, which do not support separating two shared libraries at run time.
//
// The kernel's driver is detached from the interface while it is open. After a crash the interface
// has no driver until the device is plugged in again.
class LibusbHid {
public:
    // Opens one interface of the device at info.location. Fails with a user error if there is
    // none, it may not be opened, or another program uses it.
    static Result<LibusbHid> open(LibusbAddress const& address, DeviceInfo const& info);

    // Sends a complete report, beginning with its report id. Fails with a device error.
    Result<void> send_feature(std::span<std::byte const> report);
    Result<void> send_output(std::span<std::byte const> report);

    // Turns the open interface into a source of its reports.
    std::unique_ptr<ReportSource> into_source(DeviceInfo info) &&;

private:
    explicit LibusbHid(HidHandle handle)
        : handle_(std::move(handle))
    {
    }

    Result<void> check_sent(int size, std::span<std::byte const> report) const;

    HidHandle handle_;
};

} // namespace tractus::drivers
