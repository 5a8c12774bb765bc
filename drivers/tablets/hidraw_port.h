#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/tablets/mode_switch.h"
#include "drivers/tablets/tablet_port.h"
#include "drivers/tablets/usb_tablet.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace tractus::drivers {

// Kinds of reports that the host sends to a tablet.
enum class HostReportKind { Feature, Output };

// Returns the index of the tablet's interface that accepts a report: an interface whose descriptor
// declares the report, preferably the interface `own`. Returns `own` if no descriptor declares it.
std::size_t find_receiver(std::vector<DeviceInfo> const& interfaces, std::size_t own,
                          HostReportKind kind, std::uint8_t report_id);

// Communicates with a tablet through the kernel's hidraw nodes. Reports go to the node for which
// the port is opened, or to another node of the same tablet if only that one accepts them. String
// descriptors, which hidraw cannot read, are requested from the USB device itself, regardless of
// its driver.
class HidrawPort final : public TabletPort {
public:
    // `all` lists all HID devices of the computer.
    HidrawPort(DeviceInfo const& info, std::vector<DeviceInfo> const& all,
               std::filesystem::path const& class_folder = "/sys/class/hidraw");

    bool is_open() const; // True if the node could be opened for reading and writing.
    SwitchedBy switched_by() const { return switched_by_; }

    Result<void> send_feature(std::span<std::byte const> report) override;
    Result<void> send_output(std::span<std::byte const> report) override;
    Result<std::string> read_string(int index) override;

private:
    Result<void> send(HostReportKind kind, std::span<std::byte const> report);

    std::vector<DeviceInfo> interfaces_; // Interfaces of this tablet.
    // Index in interfaces_ of the interface that this port opened.
    std::size_t own_ = 0;
    SwitchedBy switched_by_ = SwitchedBy::Nobody;
    UsbStrings strings_;
};

} // namespace tractus::drivers
