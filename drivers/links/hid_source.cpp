#include "drivers/links/hid_source.h"

#include "drivers/links/hid_back_end.h"
#include "drivers/links/hid_link.h"
#include "drivers/links/hid_sysfs.h"
#include "drivers/links/input_size.h"
#include "engine/base/file.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fmt/core.h>
#include <string>
#include <string_view>
#include <utility>

namespace tractus::drivers {

namespace fs = std::filesystem;

namespace {

class HidSource final : public ReportSource {
public:
    HidSource(DeviceInfo info, std::unique_ptr<PacketLink> link)
        : info_(std::move(info))
        , link_(std::move(link))
    {
    }

    DeviceInfo const& info() const override { return info_; }
    Result<std::optional<RawReport>> read(Duration timeout) override
    {
        return link_->read(timeout);
    }
    std::uint64_t oversized_count() const override { return link_->oversized_count(); }

private:
    DeviceInfo info_;
    std::unique_ptr<PacketLink> link_;
};

// Returns the value of KEY in lines of KEY=value; empty if there is none.
std::string_view value_of(std::string_view text, std::string_view key)
{
    while (!text.empty()) {
        auto const line = text.substr(0, text.find('\n'));
        if (line.starts_with(key) && line.substr(key.size()).starts_with('='))
            return line.substr(key.size() + 1);
        text.remove_prefix(std::min(line.size() + 1, text.size()));
    }
    return {};
}

// Reads bus, vendor and product id from the value of HID_ID, such as "0003:0000056A:0000037A".
void read_ids(std::string_view text, DeviceInfo& info)
{
    for (auto* const id : { &info.bus, &info.vendor_id, &info.product_id }) {
        std::uint32_t value = 0;
        auto const field = text.substr(0, text.find(':'));
        std::from_chars(field.data(), field.data() + field.size(), value, 16);
        *id = static_cast<std::uint16_t>(value);
        text.remove_prefix(std::min(field.size() + 1, text.size()));
    }
}

DeviceInfo describe(fs::path const& folder)
{
    DeviceInfo info { .location = fmt::format("/dev/{}", folder.filename().string()) };
    if (auto const event = read_file(folder / "device" / "uevent")) {
        info.name = value_of(*event, "HID_NAME");
        info.physical_path = value_of(*event, "HID_PHYS");
        info.serial_number = value_of(*event, "HID_UNIQ");
        read_ids(value_of(*event, "HID_ID"), info);
    }
    if (auto const usb = find_usb_parent(folder)) {
        info.manufacturer = usb->manufacturer;
        info.interface_number = usb->interface_number;
        if (info.serial_number.empty())
            info.serial_number = usb->serial_number;
    }
    if (auto const descriptor = read_file(folder / "device" / "report_descriptor")) {
        auto const bytes = std::as_bytes(std::span(*descriptor));
        info.report_descriptor.assign(bytes.begin(), bytes.end());
    }
    info.size_mm = size_known_to_udev(folder);
    return info;
}

// Orders nodes naturally: hidraw10 comes after hidraw9.
bool comes_first(DeviceInfo const& a, DeviceInfo const& b)
{
    return std::pair(a.location.size(), a.location) < std::pair(b.location.size(), b.location);
}

} // namespace

std::vector<DeviceInfo> enumerate_hid(fs::path const& class_folder)
{
    std::vector<DeviceInfo> devices;
    std::error_code ignored; // An error means that there is no folder, and so no devices.
    for (fs::directory_iterator entry(class_folder, ignored); entry != fs::directory_iterator();
         entry.increment(ignored))
        devices.push_back(describe(entry->path()));
    std::sort(devices.begin(), devices.end(), comes_first);
    return devices;
}

Result<std::unique_ptr<ReportSource>> open_hid(DeviceInfo info)
{
    auto link = TRY(open_hid_link(info));
    return make_hid_source(std::move(info), std::move(link));
}

std::unique_ptr<ReportSource> make_hid_source(DeviceInfo info, std::unique_ptr<PacketLink> link)
{
    return std::make_unique<HidSource>(std::move(info), std::move(link));
}

} // namespace tractus::drivers
