#include "drivers/gpio/gpio_encoder.h"

#include "drivers/reports/device_address.h"

#include <algorithm>
#include <fmt/core.h>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace tractus::drivers {

namespace {

constexpr std::uint16_t kBusHost = 0x19; // Value of BUS_HOST in linux/input.h.
constexpr std::size_t kEncoderReportSize = 8;
constexpr std::string_view kEncoderName = "Quadrature encoder";

Result<GpioEncoderAddress> parse_encoder_place(std::string const& location)
{
    auto const address = TRY(parse_device_address(location));
    if (auto const* const encoder = std::get_if<GpioEncoderAddress>(&address))
        return *encoder;
    return fail(Fault::User,
                fmt::format("{} is not the address of an encoder on GPIO lines", location));
}

void put_encoder_bytes(RawReport& report, std::size_t at, std::uint32_t value, std::size_t bytes)
{
    for (std::size_t i = 0; i < bytes; ++i)
        report.storage[at + i] = static_cast<std::byte>(value >> 8 * i & 0xff);
}

class GpioEncoderSource final : public ReportSource {
public:
    GpioEncoderSource(DeviceInfo info, std::unique_ptr<GpioEdges> edges)
        : info_(std::move(info))
        , edges_(std::move(edges))
        , quadrature_(edges_->beginning())
        , last_report_(edges_->now())
    {
    }

    DeviceInfo const& info() const override { return info_; }
    Result<std::optional<RawReport>> read(Duration timeout) override;

private:
    Result<void> take(Duration timeout);
    RawReport report();

    DeviceInfo info_;
    std::unique_ptr<GpioEdges> edges_;
    Quadrature quadrature_;
    std::vector<QuadratureEdge> new_edges_; // Edges just read. A member only to reuse its memory.
    Timestamp last_report_;                 // Time at which the last report was made.
    Timestamp last_time_ {};                // Time stamp of the last report.
    Timestamp last_edge_ {};
    std::uint32_t edge_count_ = 0; // Number of edges since the last report.
    std::uint32_t reported_lost_ = 0;
};

Result<void> GpioEncoderSource::take(Duration timeout)
{
    new_edges_.clear();
    TRY(edges_->read(timeout, new_edges_));
    for (auto const& edge : new_edges_) {
        quadrature_.push(edge);
        last_edge_ = edge.time;
        ++edge_count_;
    }
    return {};
}

// Makes a report. Its time does not go back, although an edge can be delivered after a report of
// rest that has a later time.
RawReport GpioEncoderSource::report()
{
    auto const now = edges_->now();
    auto const time = edge_count_ > 0 ? last_edge_ : now;
    last_time_ = std::max(time, last_time_ + Duration(1));
    last_report_ = now;
    auto const lost
        = quadrature_.lost_count() - std::exchange(reported_lost_, quadrature_.lost_count());
    RawReport report { .received = last_time_, .size = kEncoderReportSize };
    put_encoder_bytes(report, 0, lost > 0 ? 1 : 0, 1);
    put_encoder_bytes(report, 1, std::min<std::uint32_t>(lost, 0xff), 1);
    put_encoder_bytes(report, 2, std::min<std::uint32_t>(std::exchange(edge_count_, 0), 0xffff), 2);
    put_encoder_bytes(report, 4, static_cast<std::uint32_t>(quadrature_.count()), 4);
    return report;
}

Result<std::optional<RawReport>> GpioEncoderSource::read(Duration timeout)
{
    constexpr Duration kForEver = std::chrono::hours(24);
    auto const end = edges_->now() + std::min(timeout, kForEver);
    for (;;) {
        auto const due = last_report_ + (edge_count_ > 0 ? kEncoderPeriod : kEncoderRestingPeriod);
        auto const now = edges_->now();
        if (now >= due)
            return std::optional(report());
        if (now >= end)
            return std::optional<RawReport>();
        TRY(take(std::min(due, end) - now));
    }
}

class GpioEncoderDecoder final : public HeightDecoder {
public:
    std::int32_t full_scale() const override { return kEncoderFullScale; }
    HeightStreamCounts stream_counts() const override { return counts_; }

    using HeightDecoder::decode;
    Result<void> decode(Timestamp received, std::span<std::byte const> report,
                        std::vector<HeightSample>& out) override;

private:
    HeightStreamCounts counts_;
};

Result<void> GpioEncoderDecoder::decode(Timestamp received, std::span<std::byte const> report,
                                        std::vector<HeightSample>& out)
{
    if (report.size() != kEncoderReportSize)
        return fail(Fault::Device,
                    fmt::format("encoder report: {} bytes, expected {}", report.size(),
                                kEncoderReportSize));
    auto const byte = [&](std::size_t i) { return std::to_integer<std::uint32_t>(report[i]); };
    auto const count
        = static_cast<std::int32_t>(byte(4) | byte(5) << 8 | byte(6) << 16 | byte(7) << 24);
    if (count < -kEncoderCountsBelow || count > kEncoderFullScale - kEncoderCountsBelow)
        return fail(Fault::Device,
                    fmt::format("encoder report: it has counted {}, expected {} to {}", count,
                                -kEncoderCountsBelow, kEncoderFullScale - kEncoderCountsBelow));
    ++counts_.frames;
    if ((byte(0) & 1) != 0) {
        ++counts_.overruns;
        return fail(Fault::Device,
                    fmt::format("the encoder has lost {} edges, so its height is no longer true: "
                                "set the surface to where it was at the beginning, and calibrate "
                                "zero",
                                byte(1)));
    }
    out.push_back({ .time = received,
                    .counts = count + kEncoderCountsBelow,
                    .full_scale = kEncoderFullScale });
    return {};
}

} // namespace

Result<DeviceInfo> describe_gpio_encoder(std::string const& address)
{
    auto const place = TRY(parse_encoder_place(address));
    return DeviceInfo { .name = fmt::format("{} on {}", kEncoderName, place.chip),
                        .location = address,
                        .physical_path = address, // Logs store this path, but not the location.
                        .bus = kBusHost };
}

Result<std::unique_ptr<ReportSource>> open_gpio_encoder(DeviceInfo const& info)
{
    auto const place = TRY(parse_encoder_place(info.location));
    auto edges = TRY(open_gpio_edges(place.chip, place.a_line, place.b_line));
    return open_gpio_encoder(info, std::move(edges));
}

Result<std::unique_ptr<ReportSource>> open_gpio_encoder(DeviceInfo const& info,
                                                        std::unique_ptr<GpioEdges> edges)
{
    return std::make_unique<GpioEncoderSource>(TRY(describe_gpio_encoder(info.location)),
                                               std::move(edges));
}

bool is_gpio_encoder(DeviceInfo const& info)
{
    return info.bus == kBusHost && info.name.starts_with(kEncoderName);
}

std::unique_ptr<HeightDecoder> make_gpio_encoder_decoder()
{
    return std::make_unique<GpioEncoderDecoder>();
}

} // namespace tractus::drivers
