#pragma once

#include "drivers/reports/device_info.h"
#include "drivers/tablets/mode_switch.h"
#include "drivers/tablets/tablet_port.h"
#include "drivers/tablets/usb_tablet.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace tractus::drivers {

// Returns which of a tablet's interfaces takes a report: `own` if its descriptor has the report or
// none of the others has, else the other one.
enum class HostReportKind { Feature, Output };
std::size_t find_receiver(std::vector<DeviceInfo> const& interfaces, std::size_t own,
                          HostReportKind kind, std::uint8_t report_id);

// Speaks to a tablet through the kernel's hidraw nodes: to the one it is opened for and to the
// others of the same tablet, where those take a report. Hidraw reads no strings; for those the USB
// device itself is asked, whichever driver it has.
class HidrawPort final : public TabletPort {
public:
    // `all` are the HID devices that there are.
    HidrawPort(DeviceInfo const& info, std::vector<DeviceInfo> const& all,
               std::filesystem::path const& class_folder = "/sys/class/hidraw");

    bool is_open() const; // Whether the node may be read and written.
    SwitchedBy switched_by() const { return switched_by_; }

    Result<void> send_feature(std::span<std::byte const> report) override;
    Result<void> send_output(std::span<std::byte const> report) override;
    Result<std::string> read_string(int index) override;

private:
    Result<void> send(HostReportKind kind, std::span<std::byte const> report);

    std::vector<DeviceInfo> interfaces_; // Interfaces of this tablet.
    std::size_t own_ = 0;                // Index of the one it is opened for.
    SwitchedBy switched_by_ = SwitchedBy::Nobody;
    UsbStrings strings_;
};

} // namespace tractus::drivers
