#include "drivers/tablets/hidraw_port.h"

#include "drivers/links/hid_link.h"
#include "drivers/links/hid_sysfs.h"
#include "drivers/reports/report_descriptor.h"
#include "drivers/tablets/tablet_interfaces.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/core.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace tractus::drivers {

namespace fs = std::filesystem;

namespace {

class FileDescriptor {
public:
    explicit FileDescriptor(std::string const& path)
        : number_(::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC))
        , error_(number_ < 0 ? errno : 0)
    {
    }
    FileDescriptor(FileDescriptor const&) = delete;
    FileDescriptor& operator=(FileDescriptor const&) = delete;
    ~FileDescriptor()
    {
        if (number_ >= 0)
            ::close(number_);
    }
    int number() const { return number_; }
    int error() const { return error_; } // Errno of opening; 0 if the file is open.

private:
    int number_;
    int error_;
};

bool has_report(DeviceInfo const& info, HostReportKind kind, std::uint8_t report_id)
{
    auto const descriptor = parse_report_descriptor(info.report_descriptor);
    if (!descriptor)
        return false;
    auto const hid_kind
        = kind == HostReportKind::Feature ? HidReportKind::Feature : HidReportKind::Output;
    return descriptor->report_size(hid_kind, report_id) > 0;
}

fs::path folder_of(fs::path const& class_folder, DeviceInfo const& info)
{
    return class_folder / fs::path(info.location).filename();
}

// True for the Linux drivers that switch the mode of the tablets they know.
bool is_switching_driver(std::string const& driver)
{
    return driver == "wacom" || driver == "uclogic";
}

std::string usb_address_of(fs::path const& hidraw_folder)
{
    auto const usb = find_usb_parent(hidraw_folder);
    return usb ? usb->address : std::string();
}

} // namespace

std::size_t find_receiver(std::vector<DeviceInfo> const& interfaces, std::size_t own,
                          HostReportKind kind, std::uint8_t report_id)
{
    if (has_report(interfaces[own], kind, report_id))
        return own;
    auto const other = std::find_if(interfaces.begin(), interfaces.end(), [&](auto const& info) {
        return has_report(info, kind, report_id);
    });
    return other == interfaces.end() ? own : static_cast<std::size_t>(other - interfaces.begin());
}

HidrawPort::HidrawPort(DeviceInfo const& info, std::vector<DeviceInfo> const& all,
                       fs::path const& class_folder)
    : strings_(usb_address_of(folder_of(class_folder, info)))
{
    auto const is_own = [&](DeviceInfo const& other) { return other.location == info.location; };
    for (auto& group : group_by_tablet(all))
        if (std::any_of(group.begin(), group.end(), is_own))
            interfaces_ = std::move(group);
    if (interfaces_.empty())
        interfaces_.push_back(info);
    own_ = static_cast<std::size_t>(std::find_if(interfaces_.begin(), interfaces_.end(), is_own)
                                    - interfaces_.begin());
    if (is_switching_driver(bound_driver(folder_of(class_folder, info))))
        switched_by_ = SwitchedBy::Kernel;
}

bool HidrawPort::is_open() const
{
    return FileDescriptor(interfaces_[own_].location).number() >= 0;
}

Result<void> HidrawPort::send(HostReportKind kind, std::span<std::byte const> report)
{
    auto const report_id = std::to_integer<std::uint8_t>(report.front());
    auto const& receiver = interfaces_[find_receiver(interfaces_, own_, kind, report_id)];
    auto const& node = receiver.location;
    FileDescriptor const file(node);
    if (file.number() < 0)
        return fail(Fault::User, cannot_open_hidraw(receiver, file.error()));
    std::vector<std::byte> buffer(report.begin(),
                                  report.end()); // A copy, because the ioctl writes to its buffer.
    auto const sent = kind == HostReportKind::Feature
        ? ::ioctl(file.number(), HIDIOCSFEATURE(buffer.size()), buffer.data())
        : ::write(file.number(), buffer.data(), buffer.size());
    if (sent < 0)
        return fail(Fault::Device,
                    fmt::format("{} does not take {} report {}: {}", node,
                                kind == HostReportKind::Feature ? "feature" : "output", report_id,
                                std::strerror(errno)));
    return {};
}

Result<void> HidrawPort::send_feature(std::span<std::byte const> report)
{
    return send(HostReportKind::Feature, report);
}

Result<void> HidrawPort::send_output(std::span<std::byte const> report)
{
    return send(HostReportKind::Output, report);
}

Result<std::string> HidrawPort::read_string(int index)
{
    return strings_.read(index);
}

} // namespace tractus::drivers
