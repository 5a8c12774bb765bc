#pragma once

#include "drivers/device_kind.h"
#include "drivers/reports/device_info.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tractus::diagnosis {

// A device that list_devices() has found, and what the system says of it.
struct DeviceFacts {
    drivers::DeviceInfo info {};
    drivers::DeviceDescription description {};
    std::string tablet {}; // Its model, if it is known: "Huion HS610"; else empty.
    std::string family {}; // The format of that model's reports (drivers/pens/families.h).
    std::string driver {}; // The kernel's, bound to it: "wacom", "hid-generic"; may be empty.
    int open_error = 0;    // Why it may not be opened, an errno; 0 if it may.
    std::optional<double> poll_hz; // How often USB asks it at most; no value if that is not known.
};

// An interface of a USB device.
struct UsbInterfaceFacts {
    int number = 0;
    int usb_class = 0;     // 3: HID, 255: its maker's own.
    std::string driver {}; // Bound to it; empty: none.
    bool has_node = false; // A hidraw node belongs to it.
};

// A USB device, whatever it is.
struct UsbDeviceFacts {
    std::string port {}; // "1-2.3"
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    std::string name {}; // The device's own name.
    std::vector<UsbInterfaceFacts> interfaces {};
};

// A HID device that no hidraw node belongs to.
struct HiddenHidFacts {
    std::string name {}; // The kernel's name: "0003:04D8:00DD.0001".
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    std::string driver {}; // The kernel's, bound to it; empty: none.
};

struct LibraryFacts {
    std::string name {};
    std::string version {};
    std::string needed {}; // The oldest version that does all we ask of it.
};

// Description of the system, as values: everything that diagnose_system() judges.
struct SystemFacts {
    std::vector<DeviceFacts> devices {};
    std::vector<UsbDeviceFacts> usb {};
    std::vector<HiddenHidFacts> hidden {};
    std::vector<LibraryFacts> libraries {};
    bool has_hidraw = true;    // The kernel has hidraw at all.
    bool has_our_rules = true; // 70-tractus.rules is where udev finds it.
};

// Looks at this machine. Needs no permission, opens no device and changes nothing. `root` is where
// its files are.
SystemFacts gather_system_facts(std::filesystem::path const& root = "/");

// Whether a device may be opened: 0, or an errno.
int opening_error(drivers::DeviceInfo const& info, std::filesystem::path const& root = "/");

} // namespace tractus::diagnosis
