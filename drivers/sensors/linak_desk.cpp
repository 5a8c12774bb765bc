#include "drivers/sensors/linak_desk.h"

#include "drivers/links/hid_link.h"
#include "drivers/sensors/polled_source.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <fmt/core.h>
#include <string>
#include <utility>
#include <vector>

namespace tractus::drivers {

using namespace std::chrono_literals;

namespace {

constexpr std::uint16_t kLinakVendorId = 0x12d3;
constexpr std::uint16_t kLinakProductId = 0x0002;
constexpr std::size_t kDeskReportBytes = 64;
using DeskReport = std::array<std::byte, kDeskReportBytes>;

constexpr std::byte kDeskStatus { 0x04 };       // Feature report of the desk's status.
constexpr std::byte kDeskStatusLength { 0x38 }; // Second byte of a valid status.
// From this offset on, all bytes of the status are zero until the desk is ready.
constexpr std::size_t kDeskFirstValueAt = 2;
constexpr std::size_t kDeskHeightAt = 4;

// Interval between two requests. The fastest rate that the cable supports is not documented.
constexpr Duration kLinakPeriod = 20ms;
constexpr int kLinakAttempts = 3;
constexpr int kLinakInitialisations = 3;

bool is_desk_status(std::span<std::byte const> packet)
{
    return packet.size() >= kDeskHeightAt + 2 && packet[0] == kDeskStatus
        && packet[1] == kDeskStatusLength;
}

bool is_desk_ready(std::span<std::byte const> packet)
{
    return std::any_of(packet.begin() + kDeskFirstValueAt, packet.end(),
                       [](std::byte byte) { return byte != std::byte {}; });
}

bool is_reading(std::span<std::byte const> packet)
{
    return is_desk_status(packet) && is_desk_ready(packet);
}

bool is_not_ready(std::span<std::byte const> packet)
{
    return is_desk_status(packet) && !is_desk_ready(packet);
}

// Feature report sent once after power-up; its meaning is not documented.
DeskReport desk_initialisation()
{
    return { std::byte { 0x03 }, std::byte { 0x04 }, std::byte { 0x00 }, std::byte { 0xfb } };
}

// Returns a report with the target positions of four motors, all of which mean "stay where you
// are". It is the only motor command in this program.
DeskReport desk_stop()
{
    DeskReport report { std::byte { 0x05 } };
    for (std::size_t at = 1; at < 9; at += 2) {
        report[at] = std::byte { 0x01 };
        report[at + 1] = std::byte { 0x80 };
    }
    return report;
}

Result<std::optional<RawReport>> ask_desk(PacketLink& link)
{
    return exchange(link, std::array { kDeskStatus }, is_desk_status, kLinakAttempts);
}

Result<void> set_up_desk(PacketLink& link, std::string const& who)
{
    for (int i = 0; i <= kLinakInitialisations; ++i) {
        auto const status = TRY(ask_desk(link));
        if (!status)
            return fail(Fault::Device,
                        fmt::format("{} does not tell its height (is it a LINAK desk?)", who));
        if (is_desk_ready(status->bytes()))
            return {};
        TRY(link.write(desk_initialisation()));
        link.sleep(10ms);
        TRY(link.write(desk_stop()));
        link.sleep(100ms);
    }
    return fail(Fault::User,
                fmt::format("{} does not know how high it is: hold its own down key until it is at "
                            "its lowest and for ten seconds more, and try again",
                            who));
}

class LinakDeskDecoder final : public HeightDecoder {
public:
    std::int32_t full_scale() const override { return kLinakFullScale; }

    using HeightDecoder::decode;
    Result<void> decode(Timestamp received, std::span<std::byte const> report,
                        std::vector<HeightSample>& out) override;
};

Result<void> LinakDeskDecoder::decode(Timestamp received, std::span<std::byte const> report,
                                      std::vector<HeightSample>& out)
{
    if (report.empty() || report[0] != kDeskStatus)
        return {};
    if (!is_desk_status(report))
        return fail(Fault::Device,
                    fmt::format("desk status: {} bytes, expected {} that begin with 04 38",
                                report.size(), kDeskReportBytes));
    if (!is_desk_ready(report))
        return fail(Fault::Device, "desk status: the desk does not know how high it is");
    auto const height = std::to_integer<std::int32_t>(report[kDeskHeightAt])
        | std::to_integer<std::int32_t>(report[kDeskHeightAt + 1]) << 8;
    auto const counts = static_cast<std::int16_t>(height) + kLinakCountsBelow;
    if (counts < 0 || counts > kLinakFullScale)
        return fail(Fault::Device,
                    fmt::format("desk status: {} tenths of a millimetre, expected {} to {}",
                                counts - kLinakCountsBelow, -kLinakCountsBelow,
                                kLinakFullScale - kLinakCountsBelow));
    out.push_back({ .time = received, .counts = counts, .full_scale = kLinakFullScale });
    return {};
}

} // namespace

bool is_linak_desk(DeviceInfo const& info)
{
    return info.vendor_id == kLinakVendorId && info.product_id == kLinakProductId;
}

Result<std::unique_ptr<ReportSource>> open_linak_desk(DeviceInfo info)
{
    auto link = TRY(open_hid_feature_link(info));
    return open_linak_desk(std::move(info), std::move(link));
}

Result<std::unique_ptr<ReportSource>> open_linak_desk(DeviceInfo info,
                                                      std::unique_ptr<PacketLink> link)
{
    auto const who = fmt::format("the desk at {}", info.location);
    return open_polled(std::move(info), std::move(link),
                       { .command = { kDeskStatus },
                         .is_reply = is_reading,
                         .period = kLinakPeriod,
                         .set_up = [who](PacketLink& to) { return set_up_desk(to, who); },
                         .spoils = is_not_ready });
}

std::unique_ptr<HeightDecoder> make_linak_desk_decoder()
{
    return std::make_unique<LinakDeskDecoder>();
}

} // namespace tractus::drivers
