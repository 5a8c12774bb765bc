#pragma once

#include "engine/base/result.h"

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tractus::drivers {

// Where a device is to be found, as it stands in DeviceInfo::location and as the command line takes
// it.

// "/dev/hidraw3": a HID device through the kernel's hidraw. Other readers go on as before.
struct HidrawAddress {
    std::string node {};

    bool operator==(HidrawAddress const&) const = default;
};

// The place of a USB device: the bus and the ports on the way to it, as in the names of
// /sys/bus/usb/devices: "1-2.3".
struct UsbPort {
    int bus = 0;               // Bus number, from 1.
    std::vector<int> ports {}; // Port numbers from 1; at least one, at most seven.

    bool operator==(UsbPort const&) const = default;
};

// "libusb:1-2.3:0": one interface of a HID device through hidapi's libusb back end, which takes it
// from the kernel's driver while it is open.
struct LibusbAddress {
    UsbPort port {};
    int interface_number = 0;

    bool operator==(LibusbAddress const&) const = default;
};

// "usb:1-2.3": a USB device that is no HID device, through libusb.
struct UsbAddress {
    UsbPort port {};

    bool operator==(UsbAddress const&) const = default;
};

// "gpio:gpiochip0:11,10,9,8:mcp3208:0": a converter behind four lines of a GPIO chip.
struct GpioAddress {
    std::string chip {}; // Its name ("gpiochip0") or label ("pinctrl-bcm2711").

    // Offsets on the chip, by the converter's names of its pins: DIN is what the host sends.
    unsigned clk_line = 0;
    unsigned din_line = 0;
    unsigned dout_line = 0;
    unsigned cs_line = 0;

    std::string converter {}; // "mcp3008" or "mcp3208"; whoever opens it knows which there are.
    unsigned channel = 0;

    bool operator==(GpioAddress const&) const = default;
};

// "gpio:gpiochip0:17,27:quadrature": an encoder's two lines.
struct GpioEncoderAddress {
    std::string chip {}; // Name or path of the chip, as above.
    unsigned a_line = 0;
    unsigned b_line = 0;

    bool operator==(GpioEncoderAddress const&) const = default;
};

// "/dev/ttyACM0", "/dev/serial/by-id/usb-…": a serial line, or a pseudo-terminal, "/dev/pts/3".
struct SerialAddress {
    std::string node {};

    bool operator==(SerialAddress const&) const = default;
};

// "iio:device0:voltage1": a channel of the kernel's industrial I/O.
struct IioAddress {
    std::string device {};  // Its number, "device0", or its own name, "ads1115".
    std::string channel {}; // As its files in sysfs have it: "voltage1", "distance".

    bool operator==(IioAddress const&) const = default;
};

// "/dev/input/event5": a pen that Linux gives as input events alone.
struct EventAddress {
    std::string node {};

    bool operator==(EventAddress const&) const = default;
};

using DeviceAddress = std::variant<HidrawAddress, LibusbAddress, UsbAddress, GpioAddress,
                                   GpioEncoderAddress, SerialAddress, IioAddress, EventAddress>;

// Whether such devices are read only where they are named: of a GPIO chip's lines nobody knows what
// is on them, and a serial line or an analogue input may be anything.
inline bool is_only_named(DeviceAddress const& address)
{
    return !std::holds_alternative<HidrawAddress>(address)
        && !std::holds_alternative<EventAddress>(address)
        && !std::holds_alternative<LibusbAddress>(address)
        && !std::holds_alternative<UsbAddress>(address);
}

// Whether it is on lines of a GPIO chip: such devices cannot be found, only named.
inline bool is_on_gpio(DeviceAddress const& address)
{
    return std::holds_alternative<GpioAddress>(address)
        || std::holds_alternative<GpioEncoderAddress>(address);
}

// Fails, as the user's fault, with the form that was expected.
Result<DeviceAddress> parse_device_address(std::string_view text);

// Prints what parse_device_address reads.
std::string print_device_address(DeviceAddress const& address);
std::string print_usb_port(UsbPort const& port); // "1-2.3"

} // namespace tractus::drivers
