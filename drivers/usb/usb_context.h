#pragma once

#include "drivers/reports/device_info.h"
#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct libusb_context;
struct libusb_device;
struct libusb_device_handle;

namespace tractus::drivers {

// Libusb's handles with owners. A context sees the devices that were there when it was made: where
// no udev tells of arrivals, an old context never learns of a new one. So every opening makes a
// fresh context, which the device then owns, and nothing here depends on hot-plug events.

struct CloseUsbContext {
    void operator()(libusb_context* context) const;
};
using UsbContext = std::unique_ptr<libusb_context, CloseUsbContext>;

// Fails, as the user's fault, if the system has no USB that may be used.
Result<UsbContext> make_usb_context();

// Where a device is plugged in, as the kernel names its folder in /sys/bus/usb/devices: "1-2.3" is
// bus 1, port 2 of the root hub, port 3 of the hub there. "1-0" is a root hub itself.
std::string usb_address(libusb_device*);

// Libusb's words for an error code.
std::string usb_error_text(int code);

// An open device, and the interfaces of it that were claimed: released, and given back to the
// kernel's driver, when it goes.
class UsbDevice {
public:
    // Opens the device that is plugged in at `address` ("1-2.3"). Fails, as the user's fault, if
    // there is none or it may not be opened; the message says what to do.
    static Result<UsbDevice> open(std::string_view address);

    // Leaves the other one without a device: it may only be destroyed or assigned to.
    UsbDevice(UsbDevice&&) noexcept;
    UsbDevice& operator=(UsbDevice&&) noexcept;
    ~UsbDevice();

    libusb_context* context() const { return context_.get(); }
    libusb_device_handle* handle() const { return handle_; }

    // Takes the interface from the kernel's driver, if one is bound to it, and for us alone. Fails,
    // as the user's fault, if another program has it.
    Result<void> claim(int interface_number);

    // The bytes of a string descriptor behind its two-byte header, in US English: UTF-16LE where it
    // is a text. Fails, as the device's fault, if it has none or does not answer.
    Result<std::vector<std::byte>> string_bytes(std::uint8_t index) const;

    // Returns the same as text in UTF-8. Fails likewise.
    Result<std::string> string(std::uint8_t index) const;

private:
    UsbDevice(UsbContext context, libusb_device_handle* handle, std::string address);
    void close();

    UsbContext context_;
    libusb_device_handle* handle_ = nullptr;
    std::string address_;
    std::vector<int> claimed_;
};

// Opens the device at `info.location`, "usb:1-2.3". Fails as UsbDevice::open does, and, as the
// user's fault, for another kind of address.
Result<UsbDevice> open_usb_device(DeviceInfo const& info);

} // namespace tractus::drivers
