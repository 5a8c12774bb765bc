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

// Hidapi's libusb back end beside its hidraw one. The two libraries have the same names for
// everything, and call each other's functions if both are in a process: so this one is linked from
// its static library, whose names are changed when the program is built (see the CMakeLists.txt
// here). That also works under sanitizers, which refuse the ways there are to keep apart two
// libraries that are loaded at run time.
//
// The interface is taken from the kernel's driver while it is open. A program that crashes leaves
// it without a driver, until the device is plugged in again.
class LibusbHid {
public:
    // Opens one interface of the device at info.location. Fails, as the user's fault, if there is
    // none, or it may not be opened, or another program has it.
    static Result<LibusbHid> open(LibusbAddress const& address, DeviceInfo const& info);

    // Whole reports, the report id first. Fail, as the device's fault.
    Result<void> send_feature(std::span<std::byte const> report);
    Result<void> send_output(std::span<std::byte const> report);

    // Goes on reading.
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
