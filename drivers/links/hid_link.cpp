#include "drivers/links/hid_link.h"

#include "drivers/links/hid_back_end.h"
#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <fmt/core.h>
#include <hidapi.h>
#include <limits>
#include <string>
#include <unistd.h>
#include <utility>

namespace tractus::drivers {

namespace {

std::string narrow(wchar_t const* text)
{
    std::string result;
    for (; text && *text; ++text)
        result += *text < 128 ? static_cast<char>(*text) : '?';
    return result;
}

// Rounds up to whole milliseconds for hidapi. Negative timeouts become 0, because hidapi would
// otherwise wait forever.
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
    std::uint64_t oversized_count() const override { return too_long_count_; }

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
    std::uint64_t too_long_count_ = 0;
    std::array<unsigned char, sizeof(RawReport::storage) + 1>
        // One byte longer than a report, for a report id or to detect reports that are too long.
        buffer_ {};
};

Result<void> HidLink::write(std::span<std::byte const> packet)
{
    CHECK(packet.size() < buffer_.size());
    buffer_[0] = 0; // Report id 0: the device uses no ids.
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
    bool const is_too_long = report.size > report.storage.size();
    too_long_count_ += is_too_long;
    if (size == 0 || is_too_long)
        return std::optional<RawReport>();
    std::memcpy(report.storage.data(), buffer_.data(), report.size);
    return std::optional(report);
}

class HidFeatureLink final : public RealPacketLink {
public:
    HidFeatureLink(HidHandle handle, DeviceInfo info)
        : info_(std::move(info))
        , handle_(std::move(handle))
    {
    }

    Result<void> write(std::span<std::byte const> packet) override;
    Result<std::optional<RawReport>> read(Duration) override
    {
        return std::exchange(answer_, std::nullopt);
    }

private:
    DeviceInfo info_;
    HidHandle handle_;
    std::optional<RawReport> answer_; // Answer that has not been read yet.
};

Result<void> HidFeatureLink::write(std::span<std::byte const> packet)
{
    std::array<unsigned char, sizeof(RawReport::storage)> buffer {};
    CHECK(!packet.empty() && packet.size() <= buffer.size());
    std::memcpy(buffer.data(), packet.data(), packet.size());
    int const size = packet.size() == 1
        ? hid_get_feature_report(handle_.get(), buffer.data(), buffer.size())
        : hid_send_feature_report(handle_.get(), buffer.data(), packet.size());
    auto const arrival = now();
    if (size < 0)
        return fail(Fault::Device,
                    fmt::format("lost {} at {}: {} (was it unplugged?)", info_.name, info_.location,
                                narrow(hid_error(handle_.get()))));
    if (packet.size() > 1)
        return {};
    RawReport report { .received = arrival, .size = static_cast<std::size_t>(size) };
    std::memcpy(report.storage.data(), buffer.data(), report.size);
    answer_ = report;
    return {};
}

std::string why(int error)
{
    switch (error) {
    case EACCES:
    case EPERM:
        return "permission denied (is drivers/70-tractus.rules in /etc/udev/rules.d?)";
    case ENOENT:
    case ENODEV:
    case ENXIO:
        return "there is no such device (was it unplugged?)";
    case EBUSY:
        return "it is busy (another program keeps it for itself: close that, and try again)";
    default:
        return std::strerror(error);
    }
}

} // namespace

std::string cannot_open_hidraw(DeviceInfo const& info, int error)
{
    return fmt::format("cannot open {} at {}: {}", info.name, info.location, why(error));
}

// Opens the node at `info.location`. Fails like open_hid_link().
static Result<HidHandle> open_hidraw(DeviceInfo const& info)
{
    // Opens the node with open() first, because hidapi does not report the reason of a failure.
    int const node = ::open(info.location.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (node < 0)
        return fail(Fault::User, cannot_open_hidraw(info, errno));
    ::close(node);
    hid_init();
    HidHandle handle(hid_open_path(info.location.c_str()), hid_close);
    if (!handle)
        return fail(Fault::User,
                    fmt::format("cannot open {} at {}: {}", info.name, info.location,
                                narrow(hid_error(nullptr))));
    return handle;
}

Result<std::unique_ptr<PacketLink>> open_hid_link(DeviceInfo info)
{
    static constexpr HidBackEnd kHidraw {
        .write = hid_write, .read_timeout = hid_read_timeout, .close = hid_close, .error = hid_error
    };
    auto handle = TRY(open_hidraw(info));
    return make_hid_link(kHidraw, std::move(handle), std::move(info));
}

Result<std::unique_ptr<PacketLink>> open_hid_feature_link(DeviceInfo info)
{
    auto handle = TRY(open_hidraw(info));
    return std::make_unique<HidFeatureLink>(std::move(handle), std::move(info));
}

std::unique_ptr<PacketLink> make_hid_link(HidBackEnd const& back_end, HidHandle handle,
                                          DeviceInfo info)
{
    return std::make_unique<HidLink>(back_end, std::move(handle), std::move(info));
}

} // namespace tractus::drivers
