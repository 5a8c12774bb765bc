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

// Owners for libusb's handles. Without udev, a context only sees the devices that existed when it
// was made. Each opening therefore makes a new context, owned by the device, so that hot-plug
// events are not needed.

struct CloseUsbContext {
    void operator()(libusb_context* context) const;
};
using UsbContext = std::unique_ptr<libusb_context, CloseUsbContext>;

// Makes a libusb context. Fails with a user error if the system has no USB that may be used.
Result<UsbContext> make_usb_context();

// Returns where a device is plugged in, as the kernel names its folder in /sys/bus/usb/devices:
// "1-2.3" is bus 1, port 2 of the root hub, port 3 of the hub there. "1-0" is a root hub.
std::string usb_address(libusb_device*);

// Returns libusb's description of an error code.
std::string usb_error_text(int code);

// An open USB device and the interfaces claimed on it. The destructor releases them and returns
// them to the kernel's driver.
class UsbDevice {
public:
    // Opens the device plugged in at `address` ("1-2.3"). Fails with a user error if there is
    // none or it may not be opened; the message says what to do.
    static Result<UsbDevice> open(std::string_view address);

    // A moved-from object has no device; it may only be destroyed or assigned to.
    UsbDevice(UsbDevice&&) noexcept;
    UsbDevice& operator=(UsbDevice&&) noexcept;
    ~UsbDevice();

    libusb_context* context() const { return context_.get(); }
    libusb_device_handle* handle() const { return handle_; }

    // Claims an interface exclusively, and detaches the kernel's driver if one is bound. Fails with
    // a user error if another program has claimed it.
    Result<void> claim(int interface_number);

    // Returns the bytes of a string descriptor in US English without its two-byte header; texts are
    // UTF-16LE. Fails with a device error if there is no such descriptor or the device does not
    // answer.
    Result<std::vector<std::byte>> string_bytes(std::uint8_t index) const;

    // Returns a string descriptor as UTF-8 text. Fails like string_bytes().
    Result<std::string> string(std::uint8_t index) const;

private:
    UsbDevice(UsbContext context, libusb_device_handle* handle, std::string address);
    void close();

    UsbContext context_;
    libusb_device_handle* handle_ = nullptr;
    std::string address_;
    std::vector<int> claimed_;
};

// Opens the device at `info.location`, "usb:1-2.3". Fails like UsbDevice::open(), and with a user
// error for another kind of address.
Result<UsbDevice> open_usb_device(DeviceInfo const& info);

} // namespace tractus::drivers
