#pragma once

#include "engine/base/result.h"
#include "sim/file_descriptor.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::sim {

// Identity of a USB device that this computer plays.
struct UsbGadgetIdentity {
    // Name of its folder in configfs: one gadget of a name at a time.
    std::string name = "tractus";
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    std::uint16_t release = 0x0100; // Binary coded decimal.
    std::string manufacturer {};
    std::string product {};
    std::string serial_number {};
};

// Where the kernel shows its gadgets; elsewhere in tests alone.
struct UsbGadgetPlace {
    std::filesystem::path configfs = "/sys/kernel/config";
    std::filesystem::path ports = "/sys/class/udc"; // USB device controllers.
    std::filesystem::path mounts = "/run";          // Folder for FunctionFS.
};

// A USB device that this computer plays on a port of its own: that of a Raspberry Pi, say, or on
// any PC the kernel's dummy_hcd, which is port and host at once. It is made in configfs (the
// kernel's Documentation/usb/gadget_configfs.rst) and has one configuration with the functions that
// are added to it. Nobody sees it until it is plugged in.
//
// The gadget goes with the value, whatever state it is in. What an earlier program that was killed
// has left behind under the same name is removed first. Needs root.
class UsbGadget {
public:
    // Fails, as the user's fault and with the remedy, if the kernel cannot play devices, if this
    // may not be done, or if another program plays a gadget of that name.
    static Result<std::unique_ptr<UsbGadget>> create(UsbGadgetIdentity const& identity,
                                                     UsbGadgetPlace const& place = {});
    ~UsbGadget();

    UsbGadget(UsbGadget const&) = delete;
    UsbGadget& operator=(UsbGadget const&) = delete;

    struct Attribute {
        std::string name;
        std::string value;
    };

    // Adds a function, KIND.NAME in configfs's words ("hid.pen"), with its attributes, and returns
    // its folder. Fails, as the user's fault, if configfs refuses it.
    Result<std::filesystem::path> add_function(std::string const& function,
                                               std::vector<Attribute> const& attributes = {});

    // Adds a FunctionFS function and mounts its file system, which is returned; the function is
    // complete when its descriptors have been written to the file "ep0" there. Fails, as the user's
    // fault, if the kernel does not let it.
    Result<std::filesystem::path> add_file_system_function();

    // Binds the gadget to a port, `port` in /sys/class/udc or else the first that is free: the host
    // sees the device arrive. Fails if there is none.
    Result<void> plug_in(std::string const& port = {});

    // The host sees it go. Fails, as the user's fault, if configfs refuses it.
    Result<void> unplug();

private:
    UsbGadget(UsbGadgetPlace place, std::filesystem::path folder, FileDescriptor lock);

    Result<void> fill(UsbGadgetIdentity const&);

    UsbGadgetPlace place_;
    std::filesystem::path folder_;
    FileDescriptor lock_; // Held on the folder while the gadget is somebody's.
};

// Writes an attribute of configfs or sysfs at once. Fails, as the user's fault, naming it.
Result<void> write_attribute(std::filesystem::path const& path, std::string_view value);

} // namespace tractus::sim
