#pragma once

#include "drivers/reports/report_source.h"
#include "drivers/usb/usb_context.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstdint>
#include <memory>
#include <string>

namespace tractus::drivers {

// Reads a bulk IN endpoint with several transfers under way at once, so that the device can always
// send, and stamps each transfer when it ends. Called from one thread only; nothing runs between
// its calls, but the system goes on filling the transfers.
class UsbReader {
public:
    // `device` must outlive the reader, and have the endpoint's interface claimed. `who` is what
    // messages call it. Fails, as the device's fault, if the system does not take the transfers.
    static Result<std::unique_ptr<UsbReader>> start(UsbDevice const& device, std::uint8_t endpoint,
                                                    std::string who);
    virtual ~UsbReader() = default;

    // The bytes of the next transfer, at most 512. No value if none comes within `timeout`. Fails,
    // as the device's fault, when the device is gone and everything that it sent was read.
    virtual Result<std::optional<RawReport>> read(Duration timeout) = 0;
};

} // namespace tractus::drivers
