#pragma once

#include "engine/base/result.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tractus::drivers {

// Addresses of devices, as DeviceInfo::location contains them and the command line accepts them.

// "/dev/hidraw3": a HID device through the kernel's hidraw driver. Other programs can read it at
// the same time.
struct HidrawAddress {
    std::string node {};

    bool operator==(HidrawAddress const&) const = default;
};

// Location of a USB device: its bus and the ports that lead to it, "1-2.3", as in the names of
// /sys/bus/usb/devices.
struct UsbPort {
    int bus = 0;               // Bus number, from 1.
    std::vector<int> ports {}; // Port numbers from 1; one to seven of them.

    bool operator==(UsbPort const&) const = default;
};

// "libusb:1-2.3:0": one interface of a HID device through hidapi's libusb back end, which detaches
// the kernel's driver while the interface is open.
struct LibusbAddress {
    UsbPort port {};
    int interface_number = 0;

    bool operator==(LibusbAddress const&) const = default;
};

// "usb:1-2.3": a USB device that is not a HID device, through libusb.
struct UsbAddress {
    UsbPort port {};

    bool operator==(UsbAddress const&) const = default;
};

// "gpio:gpiochip0:11,10,9,8:mcp3208:0": an analogue-to-digital converter on four lines of a GPIO
// chip.
struct GpioAddress {
    std::string chip {}; // The chip's name ("gpiochip0") or label ("pinctrl-bcm2711").

    // Line offsets on the chip, named after the converter's pins. DIN is the converter's data
    // input.
    unsigned clk_line = 0;
    unsigned din_line = 0;
    unsigned dout_line = 0;
    unsigned cs_line = 0;

    // "mcp3008" or "mcp3208". Other names are refused when the device is opened.
    std::string converter {};
    unsigned channel = 0;

    bool operator==(GpioAddress const&) const = default;
};

// "gpio:gpiochip0:17,27:quadrature": a quadrature encoder on two lines of a GPIO chip.
struct GpioEncoderAddress {
    std::string chip {}; // The chip's name or label.
    unsigned a_line = 0;
    unsigned b_line = 0;

    bool operator==(GpioEncoderAddress const&) const = default;
};

// "/dev/ttyACM0", "/dev/serial/by-id/usb-…": a serial port; or a pseudo-terminal, "/dev/pts/3".
struct SerialAddress {
    std::string node {};

    bool operator==(SerialAddress const&) const = default;
};

// "iio:device0:voltage1": a channel of the kernel's industrial I/O (IIO).
struct IioAddress {
    std::string device {};  // The device's number, "device0", or its name, "ads1115".
    std::string channel {}; // The channel's name in sysfs, such as "voltage1" or "distance".

    bool operator==(IioAddress const&) const = default;
};

// "/dev/input/event5": a pen that Linux provides only as input events.
struct EventAddress {
    std::string node {};

    bool operator==(EventAddress const&) const = default;
};

using DeviceAddress = std::variant<HidrawAddress, LibusbAddress, UsbAddress, GpioAddress,
                                   GpioEncoderAddress, SerialAddress, IioAddress, EventAddress>;

// True for devices that are read only if the user names them. The reason is that nobody can tell
// what is connected to a GPIO chip's lines, to a serial port or to an analogue input.
inline bool needs_explicit_name(DeviceAddress const& address)
{
    return !std::holds_alternative<HidrawAddress>(address)
        && !std::holds_alternative<EventAddress>(address)
        && !std::holds_alternative<LibusbAddress>(address)
        && !std::holds_alternative<UsbAddress>(address);
}

// True for devices on lines of a GPIO chip, which cannot be discovered, only named.
inline bool is_on_gpio(DeviceAddress const& address)
{
    return std::holds_alternative<GpioAddress>(address)
        || std::holds_alternative<GpioEncoderAddress>(address);
}

// Parses an address. Fails with a user error that names the form that was expected.
Result<DeviceAddress> parse_device_address(std::string_view text);

// Prints an address as parse_device_address() reads it.
std::string print_device_address(DeviceAddress const& address);
std::string print_usb_port(UsbPort const& port); // Prints a port such as "1-2.3".

} // namespace tractus::drivers
