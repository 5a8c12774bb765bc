#include "drivers/hid_link.h"

#include "drivers/hid_back_end.h"
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
    HidLink(HidBackEnd const& back_end, HidHandle handle, DeviceInfo info)
        : back_end_(back_end)
        , info_(std::move(info))
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
                                narrow(back_end_.error(handle_.get()))));
    }

    HidBackEnd const& back_end_;
    DeviceInfo info_;
    HidHandle handle_;
    std::array<unsigned char, sizeof(RawReport::storage) + 1>
        buffer_ {}; // One more shows what is too long, or is a report's number.
};

Result<void> HidLink::write(std::span<std::byte const> packet)
{
    CHECK(packet.size() < buffer_.size());
    buffer_[0] = 0; // No report ids.
    std::memcpy(buffer_.data() + 1, packet.data(), packet.size());
    if (back_end_.write(handle_.get(), buffer_.data(), packet.size() + 1) < 0)
        return lost();
    return {};
}

Result<std::optional<RawReport>> HidLink::read(Duration timeout)
{
    int const size = back_end_.read_timeout(handle_.get(), buffer_.data(), buffer_.size(),
                                            to_milliseconds(timeout));
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
    static constexpr HidBackEnd kHidraw {
        .write = hid_write, .read_timeout = hid_read_timeout, .close = hid_close, .error = hid_error
    };
    hid_init();
    HidHandle handle(hid_open_path(info.location.c_str()), kHidraw.close);
    if (!handle)
        return cannot_open(info, narrow(hid_error(nullptr)));
    return make_hid_link(kHidraw, std::move(handle), std::move(info));
}

std::unique_ptr<PacketLink> make_hid_link(HidBackEnd const& back_end, HidHandle handle,
                                          DeviceInfo info)
{
    return std::make_unique<HidLink>(back_end, std::move(handle), std::move(info));
}

} // namespace tractus
