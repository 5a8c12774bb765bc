#pragma once

#include "drivers/device_kind.h"
#include "drivers/reports/device_info.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus::diagnosis {

// A device found by list_devices(), and what the system knows about it.
struct DeviceFacts {
    drivers::DeviceInfo info {};
    drivers::DeviceDescription description {};
    std::string tablet {}; // Name of the tablet's model, such as "Huion HS610"; empty if unknown.
    std::string family {}; // Report format of the tablet's model (drivers/pens/families.h).
    // Kernel driver bound to the device, such as "wacom" or "hid-generic"; may be empty.
    std::string driver {};
    int open_error = 0; // Error number (errno) that prevents opening the device; 0: none.
    // Rate at which the computer polls the device by USB; no value if unknown.
    std::optional<double> poll_hz;
};

// An interface of a USB device.
struct UsbInterfaceFacts {
    int number = 0;
    int usb_class = 0; // USB class of the interface, such as 3 for HID and 255 for vendor-specific.
    std::string driver {}; // Kernel driver bound to the interface; empty: none.
    bool has_node = false; // True if the interface has a hidraw node.
};

// A USB device of any kind.
struct UsbDeviceFacts {
    std::string port {}; // USB port, such as "1-2.3".
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    std::string name {}; // Name that the device reports for itself.
    std::vector<UsbInterfaceFacts> interfaces {};
};

// A HID device without a hidraw node.
struct HiddenHidFacts {
    std::string name {}; // The kernel's name for the device, such as "0003:04D8:00DD.0001".
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    std::string driver {}; // Kernel driver bound to the device; empty: none.
};

struct LibraryFacts {
    std::string name {};
    std::string version {};
    std::string needed {}; // Oldest version of the library that has all features the program uses.
};

// Description of the computer. diagnose_system() uses no other input.
struct SystemFacts {
    std::vector<DeviceFacts> devices {};
    std::vector<UsbDeviceFacts> usb {};
    std::vector<HiddenHidFacts> hidden {};
    std::vector<LibraryFacts> libraries {};
    bool has_hidraw = true; // True if the kernel supports hidraw.
    // True if the program's rules, 70-tractus.rules, are installed where udev finds them.
    bool has_our_rules = true;
};

// Examines this machine. Needs no permissions, opens no devices and changes nothing. `root` is the
// root of the file system to examine.
SystemFacts gather_system_facts(std::filesystem::path const& root = "/");

// Returns the error number (errno) that prevents opening a device, or 0.
int opening_error(drivers::DeviceInfo const& info, std::filesystem::path const& root = "/");

} // namespace tractus::diagnosis
