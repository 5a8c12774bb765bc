#include "drivers/hid_source.h"

#include "drivers/file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstring>
#include <fmt/core.h>
#include <hidapi.h>
#include <limits>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace tractus {

namespace fs = std::filesystem;

namespace {

struct CloseHid {
    void operator()(hid_device* device) const { hid_close(device); }
};
using Handle = std::unique_ptr<hid_device, CloseHid>;

std::string narrow(wchar_t const* text)
{
    std::string result;
    for (; text && *text; ++text)
        result += *text < 128 ? static_cast<char>(*text) : '?';
    return result;
}

// hidapi counts in milliseconds, and a negative timeout means for ever.
int to_milliseconds(Duration timeout)
{
    auto const count = std::chrono::ceil<std::chrono::milliseconds>(timeout).count();
    return static_cast<int>(std::clamp<std::int64_t>(count, 0, std::numeric_limits<int>::max()));
}

class HidSource final : public ReportSource {
public:
    HidSource(DeviceInfo info, Handle handle)
        : info_(std::move(info))
        , handle_(std::move(handle))
    {
    }

    DeviceInfo const& info() const override { return info_; }
    Result<std::optional<RawReport>> read(Duration timeout) override;

private:
    DeviceInfo info_;
    Handle handle_;
    std::array<unsigned char, sizeof(RawReport::storage) + 1>
        buffer_ {}; // One more shows what is too long.
};

Result<std::optional<RawReport>> HidSource::read(Duration timeout)
{
    int const size
        = hid_read_timeout(handle_.get(), buffer_.data(), buffer_.size(), to_milliseconds(timeout));
    auto const now = std::chrono::steady_clock::now().time_since_epoch();
    if (size < 0)
        return fail(Fault::Device,
                    fmt::format("lost {} at {}: {} (was it unplugged?)", info_.name, info_.location,
                                narrow(hid_error(handle_.get()))));
    RawReport report { .received = Timestamp(now), .size = static_cast<std::size_t>(size) };
    if (size == 0 || report.size > report.storage.size())
        return std::optional<RawReport>();
    std::memcpy(report.storage.data(), buffer_.data(), report.size);
    return std::optional(report);
}

// The value of KEY in lines of KEY=value; empty if there is none.
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

// HID_ID=0003:0000056A:0000037A
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
        read_ids(value_of(*event, "HID_ID"), info);
    }
    if (auto const descriptor = read_file(folder / "device" / "report_descriptor")) {
        auto const bytes = std::as_bytes(std::span(*descriptor));
        info.report_descriptor.assign(bytes.begin(), bytes.end());
    }
    return info;
}

// hidraw10 after hidraw9.
bool comes_first(DeviceInfo const& a, DeviceInfo const& b)
{
    return std::pair(a.location.size(), a.location) < std::pair(b.location.size(), b.location);
}

tl::unexpected<Error> cannot_open(DeviceInfo const& info, std::string const& why)
{
    return fail(Fault::User,
                fmt::format("cannot open {} at {}: {}", info.name, info.location, why));
}

} // namespace

std::vector<DeviceInfo> enumerate_hid(fs::path const& class_folder)
{
    std::vector<DeviceInfo> devices;
    std::error_code ignored; // No folder, no devices.
    for (fs::directory_iterator entry(class_folder, ignored); entry != fs::directory_iterator();
         entry.increment(ignored))
        devices.push_back(describe(entry->path()));
    std::sort(devices.begin(), devices.end(), comes_first);
    return devices;
}

Result<std::unique_ptr<ReportSource>> open_hid(DeviceInfo info)
{
    // hidapi does not tell these apart.
    if (::access(info.location.c_str(), R_OK | W_OK) != 0) {
        if (errno == EACCES)
            return cannot_open(
                info, "permission denied (is drivers/70-tractus.rules in /etc/udev/rules.d?)");
        if (errno == ENOENT)
            return cannot_open(info, "there is no such device (was it unplugged?)");
        return cannot_open(info, std::strerror(errno));
    }
    hid_init();
    Handle handle(hid_open_path(info.location.c_str()));
    if (!handle)
        return cannot_open(info, narrow(hid_error(nullptr)));
    return std::make_unique<HidSource>(std::move(info), std::move(handle));
}

} // namespace tractus
