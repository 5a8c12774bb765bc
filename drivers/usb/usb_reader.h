#pragma once

#include "drivers/reports/report_source.h"
#include "drivers/usb/usb_context.h"
#include "engine/base/result.h"
#include "engine/base/time.h"

#include <cstdint>
#include <memory>
#include <string>

namespace tractus::drivers {

// Reads a bulk IN endpoint with several transfers pending at once, so that the device can always
// send, and gives each transfer a time stamp when it ends. Called from one thread only. No code of
// this class runs between its calls, but the system continues to fill the transfers.
class UsbReader {
public:
    // Starts reading. `device` must outlive the reader and must have claimed the endpoint's
    // interface; `who` names the device in messages. Fails with a device error if the system
    // does not accept the transfers.
    static Result<std::unique_ptr<UsbReader>> start(UsbDevice const& device, std::uint8_t endpoint,
                                                    std::string who);
    virtual ~UsbReader() = default;

    // Returns the bytes of the next transfer, at most 512. No value if none arrives within
    // `timeout`. Fails with a device error when the device is gone and all its data has been
    // read.
    virtual Result<std::optional<RawReport>> read(Duration timeout) = 0;
};

} // namespace tractus::drivers
