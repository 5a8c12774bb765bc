#include "drivers/hid_link.h"

#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fmt/core.h>
#include <hidapi.h>
#include <limits>
#include <string>
#include <unistd.h>
#include <utility>

namespace tractus {

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

class HidLink final : public RealPacketLink {
public:
    HidLink(DeviceInfo info, Handle handle)
        : info_(std::move(info))
        , handle_(std::move(handle))
    {
    }

    Result<void> write(std::span<std::byte const> packet) override;
    Result<std::optional<RawReport>> read(Duration timeout) override;

private:
    tl::unexpected<Error> lost() const
    {
        return fail(Fault::Device,
                    fmt::format("lost {} at {}: {} (was it unplugged?)", info_.name, info_.location,
                                narrow(hid_error(handle_.get()))));
    }

    DeviceInfo info_;
    Handle handle_;
    std::array<unsigned char, sizeof(RawReport::storage) + 1>
        buffer_ {}; // One more shows what is too long, or is a report's number.
};

Result<void> HidLink::write(std::span<std::byte const> packet)
{
    CHECK(packet.size() < buffer_.size());
    buffer_[0] = 0; // No report ids.
    std::memcpy(buffer_.data() + 1, packet.data(), packet.size());
    if (hid_write(handle_.get(), buffer_.data(), packet.size() + 1) < 0)
        return lost();
    return {};
}

Result<std::optional<RawReport>> HidLink::read(Duration timeout)
{
    int const size
        = hid_read_timeout(handle_.get(), buffer_.data(), buffer_.size(), to_milliseconds(timeout));
    auto const arrival = now();
    if (size < 0)
        return lost();
    RawReport report { .received = arrival, .size = static_cast<std::size_t>(size) };
    if (size == 0 || report.size > report.storage.size())
        return std::optional<RawReport>();
    std::memcpy(report.storage.data(), buffer_.data(), report.size);
    return std::optional(report);
}

tl::unexpected<Error> cannot_open(DeviceInfo const& info, std::string const& why)
{
    return fail(Fault::User,
                fmt::format("cannot open {} at {}: {}", info.name, info.location, why));
}

} // namespace

Result<std::unique_ptr<PacketLink>> open_hid_link(DeviceInfo info)
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
    return std::make_unique<HidLink>(std::move(info), std::move(handle));
}

} // namespace tractus
