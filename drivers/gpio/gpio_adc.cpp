#include "drivers/gpio/gpio_adc.h"

#include "drivers/gpio/mcp3208.h"
#include "drivers/reports/device_address.h"
#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>
#include <variant>

namespace tractus::drivers {

namespace {

constexpr std::uint16_t kBusSpi = 0x1c; // Value of BUS_SPI in linux/input.h.
constexpr std::size_t kReportSize = 4;
constexpr unsigned kNoAnswer = 1;
constexpr unsigned kHeldTooLong = 2;

struct Converter {
    std::string_view address_word;
    std::string_view name;
    unsigned bits = 0;
};
constexpr std::array<Converter, 2> kConverters { {
    { "mcp3008", "MCP3008", 10 },
    { "mcp3208", "MCP3208", 12 },
} };
constexpr unsigned kChannels = 8;

// The validated parts of an address.
struct Place {
    GpioAddress address;
    Converter const* converter = nullptr;
};

Result<Place> parse_place(std::string const& location)
{
    auto const parsed = TRY(parse_device_address(location));
    auto const* const address = std::get_if<GpioAddress>(&parsed);
    if (!address)
        return fail(Fault::User,
                    fmt::format("{} is not the address of a converter on GPIO lines", location));
    auto const converter = std::find_if(kConverters.begin(), kConverters.end(), [&](auto const& c) {
        return c.address_word == address->converter;
    });
    if (converter == kConverters.end())
        return fail(Fault::User,
                    fmt::format("{}: there is no converter '{}': mcp3008 and mcp3208 can be read",
                                location, address->converter));
    if (address->channel >= kChannels)
        return fail(Fault::User,
                    fmt::format("{}: the {} has the channels 0 to {}", location, converter->name,
                                kChannels - 1));
    return Place { *address, &*converter };
}

void describe(DeviceInfo& info, GpioAddress const& address, Converter const& converter)
{
    info.name = fmt::format("{} channel {} on {}", converter.name, address.channel, address.chip);
    info.bus = kBusSpi;
    info.physical_path = info.location; // Logs store this path, but not the location.
}

// Returns the converter type of a live or recorded device, found by its name; null if the device is
// not a converter on GPIO lines.
Converter const* find_converter(DeviceInfo const& info)
{
    if (info.bus != kBusSpi)
        return nullptr;
    for (auto const& converter : kConverters)
        if (info.name.starts_with(converter.name))
            return &converter;
    return nullptr;
}

std::int32_t full_scale_of(Converter const& converter)
{
    return (1 << converter.bits) - 1;
}

class GpioAdcSource final : public ReportSource {
public:
    GpioAdcSource(DeviceInfo info, Mcp3208Channel channel, std::unique_ptr<GpioLines> lines,
                  GpioClock clock)
        : info_(std::move(info))
        , channel_(channel)
        , lines_(std::move(lines))
        , clock_(std::move(clock))
    {
    }

    DeviceInfo const& info() const override { return info_; }
    Result<std::optional<RawReport>> read(Duration timeout) override;

    // Measures the speed of the lines. Fails if no converter answers.
    Result<void> try_out();

private:
    Result<Mcp3208Reading> convert() { return convert_mcp3208(*lines_, channel_, clock_.now); }

    DeviceInfo info_;
    Mcp3208Channel channel_;
    std::unique_ptr<GpioLines> lines_;
    GpioClock clock_;
    Timestamp due_ {}; // Time of the next reading.
    Duration hold_limit_ = kMcp3208HoldLimit;
};

Result<void> GpioAdcSource::try_out()
{
    constexpr int kTrials = 3;
    auto quickest = Duration::max();
    for (int i = 0; i < kTrials; ++i) {
        auto const reading = TRY(convert());
        if (!reading.is_answered)
            return fail(Fault::Device,
                        fmt::format("nothing answers at {}: DOUT is high where the converter sends "
                                    "a zero (check the order of the lines, CS, and its supply)",
                                    info_.location));
        quickest = std::min(quickest, reading.held);
    }
    hold_limit_ = std::max(kMcp3208HoldLimit, 2 * quickest);
    due_ = clock_.now();
    return {};
}

RawReport encode(Mcp3208Reading const& reading, unsigned repeats)
{
    unsigned const flags = (reading.is_answered ? 0 : kNoAnswer)
        | (reading.held > kMcp3208HoldLimit ? kHeldTooLong : 0);
    RawReport report { .received = reading.sampled, .size = kReportSize };
    report.storage[0] = static_cast<std::byte>(flags);
    report.storage[1] = static_cast<std::byte>(repeats);
    report.storage[2] = static_cast<std::byte>(reading.counts & 0xff);
    report.storage[3] = static_cast<std::byte>(reading.counts >> 8);
    return report;
}

Result<std::optional<RawReport>> GpioAdcSource::read(Duration timeout)
{
    // Greatest number of repetitions of an interrupted conversion. After this many interruptions in
    // a row, further repetitions would hardly succeed.
    constexpr unsigned kMaxRepeats = 7;
    constexpr Duration kForEver = std::chrono::hours(24);
    auto const deadline = clock_.now() + std::min(timeout, kForEver);
    clock_.sleep_until(std::min(due_, deadline));
    if (due_ > deadline)
        return std::optional<RawReport>();
    unsigned repeats = 0;
    auto reading = TRY(convert());
    for (; reading.held > hold_limit_ && repeats < kMaxRepeats; ++repeats)
        reading = TRY(convert());
    due_ = std::max(due_ + kGpioAdcPeriod, clock_.now()); // Missed readings are skipped.
    return std::optional(encode(reading, repeats));
}

class GpioAdcDecoder final : public HeightDecoder {
public:
    explicit GpioAdcDecoder(Converter const& converter)
        : converter_(converter)
    {
    }

    std::int32_t full_scale() const override { return full_scale_of(converter_); }

    Result<void> decode(Timestamp received, std::span<std::byte const> report,
                        std::vector<HeightSample>& out) override;

private:
    Converter const& converter_;
};

Result<void> GpioAdcDecoder::decode(Timestamp received, std::span<std::byte const> report,
                                    std::vector<HeightSample>& out)
{
    if (report.size() != kReportSize)
        return fail(Fault::Device,
                    fmt::format("{} report: {} bytes, expected {}", converter_.name, report.size(),
                                kReportSize));
    auto const byte = [&](std::size_t i) { return std::to_integer<std::int32_t>(report[i]); };
    if ((byte(0) & static_cast<std::int32_t>(kNoAnswer)) != 0)
        return fail(Fault::Device,
                    fmt::format("{}: nothing answers on DOUT (check its wires and its supply)",
                                converter_.name));
    auto const counts = byte(2) | byte(3) << 8;
    if (counts > full_scale())
        return fail(Fault::Device,
                    fmt::format("{} report: {} counts, expected 0 to {}", converter_.name, counts,
                                full_scale()));
    out.push_back({ .time = received, .counts = counts, .full_scale = full_scale() });
    return {};
}

GpioClock steady_clock()
{
    using Clock = std::chrono::steady_clock;
    return { .now = [] { return Timestamp(Clock::now().time_since_epoch()); },
             .sleep_until =
                 [](Timestamp time) {
                     std::this_thread::sleep_until(Clock::time_point(time.time_since_epoch()));
                 } };
}

} // namespace

Result<DeviceInfo> describe_gpio_adc(std::string const& address)
{
    auto const place = TRY(parse_place(address));
    DeviceInfo info { .location = address };
    describe(info, place.address, *place.converter);
    return info;
}

Result<std::unique_ptr<ReportSource>> open_gpio_adc(DeviceInfo info)
{
    auto const [address, converter] = TRY(parse_place(info.location));
    auto const lines = mcp3208_lines({ .clk = address.clk_line,
                                       .din = address.din_line,
                                       .dout = address.dout_line,
                                       .cs = address.cs_line });
    return open_gpio_adc(std::move(info), TRY(open_gpio_lines(address.chip, lines)),
                         steady_clock());
}

Result<std::unique_ptr<ReportSource>>
open_gpio_adc(DeviceInfo info, std::unique_ptr<GpioLines> lines, GpioClock clock)
{
    auto const [address, converter] = TRY(parse_place(info.location));
    describe(info, address, *converter);
    auto source = std::make_unique<GpioAdcSource>(
        std::move(info), Mcp3208Channel { .bits = converter->bits, .channel = address.channel },
        std::move(lines), std::move(clock));
    TRY(source->try_out());
    return source;
}

bool is_gpio_adc(DeviceInfo const& info)
{
    return find_converter(info) != nullptr;
}

std::unique_ptr<HeightDecoder> make_gpio_adc_decoder(DeviceInfo const& info)
{
    auto const* const converter = find_converter(info);
    CHECK(converter != nullptr);
    return std::make_unique<GpioAdcDecoder>(*converter);
}

} // namespace tractus::drivers
