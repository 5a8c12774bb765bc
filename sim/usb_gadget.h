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

// Identity of an emulated USB device.
struct UsbGadgetIdentity {
    // Name of the gadget's folder in configfs; there can be only one gadget of a name at a time.
    std::string name = "tractus";
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    std::uint16_t release = 0x0100; // Release number, binary-coded decimal.
    std::string manufacturer {};
    std::string product {};
    std::string serial_number {};
};

// Folders of the kernel's gadget interface. Only tests use other folders.
struct UsbGadgetPlace {
    std::filesystem::path configfs = "/sys/kernel/config";
    std::filesystem::path ports = "/sys/class/udc"; // USB device controllers.
    std::filesystem::path mounts = "/run";          // Parent folder of FunctionFS mounts.
};

// A USB device that this computer emulates on one of its own device ports: a Raspberry Pi's, or on
// any PC the kernel's dummy_hcd, which is device port and host at once. It is made in configfs (the
// kernel's Documentation/usb/gadget_configfs.rst) and has one configuration with the functions that
// are added to it. It is invisible until it is plugged in.
//
// The destructor removes the gadget in any state. A gadget of the same name that a killed program
// has left behind is removed first. Needs root.
class UsbGadget {
public:
    // Creates a gadget. Fails with a user error that names the remedy if the kernel does not
    // support gadgets, if the user lacks permission, or if another program has a gadget of that
    // name.
    static Result<std::unique_ptr<UsbGadget>> create(UsbGadgetIdentity const& identity,
                                                     UsbGadgetPlace const& place = {});
    ~UsbGadget();

    UsbGadget(UsbGadget const&) = delete;
    UsbGadget& operator=(UsbGadget const&) = delete;

    struct Attribute {
        std::string name;
        std::string value;
    };

    // Adds a function, named KIND.NAME in configfs ("hid.pen"), with its attributes, and returns
    // its folder. Fails with a user error if configfs refuses it.
    Result<std::filesystem::path> add_function(std::string const& function,
                                               std::vector<Attribute> const& attributes = {});

    // Adds a FunctionFS function, mounts its file system and returns the mount point; the function
    // is complete when its descriptors have been written to the file "ep0" there. Fails with a
    // user error if the kernel refuses it.
    Result<std::filesystem::path> add_file_system_function();

    // Binds the gadget to a port in /sys/class/udc (default: the first free one), so that the host
    // sees the device arrive. Fails if there is no port.
    Result<void> plug_in(std::string const& port = {});

    // Unbinds the gadget, so that the host sees the device leave. Fails with a user error if
    // configfs refuses it.
    Result<void> unplug();

private:
    UsbGadget(UsbGadgetPlace place, std::filesystem::path folder, FileDescriptor lock);

    Result<void> fill(UsbGadgetIdentity const&);

    UsbGadgetPlace place_;
    std::filesystem::path folder_;
    FileDescriptor lock_; // Lock on the folder, held as long as the gadget exists.
};

// Writes an attribute of configfs or sysfs in one call. Fails with a user error naming the
// attribute.
Result<void> write_attribute(std::filesystem::path const& path, std::string_view value);

} // namespace tractus::sim
