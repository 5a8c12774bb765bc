#include "drivers/usb/usb_link.h"

#include "drivers/usb/usb_context.h"

#include <algorithm>
#include <chrono>
#include <fmt/core.h>
#include <libusb.h>
#include <utility>

namespace tractus::drivers {

namespace {

constexpr unsigned kWriteTimeoutMs = 200;

class UsbLink final : public RealPacketLink {
public:
    UsbLink(UsbDevice device, UsbPipes const& pipes, std::string who)
        : device_(std::move(device))
        , pipes_(pipes)
        , who_(std::move(who))
    {
    }

    Result<void> write(std::span<std::byte const> packet) override;
    Result<std::optional<RawReport>> read(Duration timeout) override;

private:
    tl::unexpected<Error> lost(int code) const
    {
        return fail(Fault::Device,
                    fmt::format("lost {}: {} (was it unplugged?)", who_, usb_error_text(code)));
    }

    UsbDevice device_;
    UsbPipes pipes_;
    std::string who_;
};

Result<void> UsbLink::write(std::span<std::byte const> packet)
{
    // Libusb takes a pointer to mutable memory for either direction.
    std::vector<unsigned char> bytes(packet.size());
    std::transform(packet.begin(), packet.end(), bytes.begin(),
                   [](std::byte byte) { return std::to_integer<unsigned char>(byte); });
    int sent = 0;
    int const code = libusb_bulk_transfer(device_.handle(), pipes_.out_endpoint, bytes.data(),
                                          static_cast<int>(bytes.size()), &sent, kWriteTimeoutMs);
    // A timeout means that the device is busy, not that it is gone.
    if (code != LIBUSB_SUCCESS && code != LIBUSB_ERROR_TIMEOUT)
        return lost(code);
    return {};
}

Result<std::optional<RawReport>> UsbLink::read(Duration timeout)
{
    RawReport report;
    int size = 0;
    // libusb takes a timeout of 0 as no limit.
    auto const timeout_ms
        = std::max<std::int64_t>(std::chrono::ceil<std::chrono::milliseconds>(timeout).count(), 1);
    int const code = libusb_bulk_transfer(device_.handle(), pipes_.in_endpoint,
                                          reinterpret_cast<unsigned char*>(report.storage.data()),
                                          static_cast<int>(report.storage.size()), &size,
                                          static_cast<unsigned>(timeout_ms));
    report.received = now();
    report.size = static_cast<std::size_t>(size);
    bool const is_late = code == LIBUSB_ERROR_TIMEOUT || code == LIBUSB_ERROR_INTERRUPTED;
    // Unplugging is reported as IO, NO_DEVICE, PIPE or another error, at random.
    if (code != LIBUSB_SUCCESS && !is_late)
        return lost(code);
    if (size == 0)
        return std::optional<RawReport>();
    return std::optional(report);
}

} // namespace

Result<std::unique_ptr<PacketLink>> open_usb_link(DeviceInfo const& info, UsbPipes const& pipes)
{
    auto device = TRY(open_usb_device(info));
    TRY(device.claim(pipes.interface_number));
    auto who = fmt::format("{} at {}", info.name, info.location);
    return std::make_unique<UsbLink>(std::move(device), pipes, std::move(who));
}

} // namespace tractus::drivers
