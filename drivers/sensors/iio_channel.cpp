#include "drivers/sensors/iio_channel.h"

#include "drivers/links/packet_link.h"
#include "drivers/links/sysfs.h"
#include "drivers/reports/device_address.h"
#include "drivers/sensors/number_line.h"
#include "drivers/sensors/polled_source.h"
#include "drivers/sensors/settings.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/core.h>
#include <string>
#include <unistd.h>
#include <utility>

namespace tractus::drivers {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr std::string_view kIioKind = "iio-channel";
constexpr std::string_view kRaw = "_raw";
constexpr std::string_view kIn = "in_";
constexpr int kUsualBits = 15; // Value bits of a signed 16-bit converter.

struct IioSettings {
    NumberFormat numbers { .full_scale = (1 << kUsualBits) - 1 };
    Duration period = 2ms;
};

Result<IioSettings> parse_iio_settings(std::string_view text)
{
    constexpr int kMaxPeriod_us = 100'000;
    IioSettings settings;
    for (auto const word : split_settings(text)) {
        auto const period_us = number_between("", word, "us");
        if (auto const numbers = TRY(parse_greatest_number(word)))
            settings.numbers = *numbers;
        else if (period_us && *period_us > 0 && *period_us <= kMaxPeriod_us)
            settings.period = std::chrono::microseconds(*period_us);
        else
            return fail(Fault::User,
                        fmt::format("\"{}\" is no setting of an industrial I/O channel: expected "
                                    "the greatest value, such as max=4095, or the time between "
                                    "readings, 1us to {}us",
                                    word, kMaxPeriod_us));
    }
    return settings;
}

// Returns the greatest value for a channel's type, such as "le:s16/16>>0" or "be:u12/16>>4".
std::optional<std::int32_t> greatest_of_type(std::string_view type)
{
    constexpr int kMaxBits = 31;
    auto const colon = type.find(':');
    if (colon == std::string_view::npos || colon + 2 >= type.size())
        return std::nullopt;
    bool const has_sign = type[colon + 1] == 's';
    auto const bits = number_between("", type.substr(colon + 2, type.find('/') - colon - 2), "");
    int const value_bits = bits.value_or(0) - (has_sign ? 1 : 0);
    if (value_bits < 1 || value_bits > kMaxBits)
        return std::nullopt;
    return static_cast<std::int32_t>((std::int64_t { 1 } << value_bits) - 1);
}

// Location of a channel's files.
struct IioPlace {
    fs::path folder;
    std::string device; // Device folder's name, such as "device0".
    std::string channel;

    fs::path raw_file() const { return folder / fmt::format("in_{}_raw", channel); }
    std::string location() const { return fmt::format("iio:{}:{}", device, channel); }
};

std::vector<fs::path> iio_device_folders(fs::path const& folder)
{
    std::vector<fs::path> folders;
    std::error_code error;
    for (auto const& entry : fs::directory_iterator(folder, error))
        if (entry.path().filename().string().starts_with("iio:device"))
            folders.push_back(entry.path());
    std::ranges::sort(folders);
    return folders;
}

std::string number_of_device(fs::path const& device)
{
    return device.filename().string().substr(std::string_view("iio:").size());
}

Result<IioPlace> find_iio_channel(std::string const& location, fs::path const& folder)
{
    auto const address = TRY(parse_device_address(location));
    auto const* const iio = std::get_if<IioAddress>(&address);
    if (!iio)
        return fail(Fault::User,
                    fmt::format("{} is not the address of an industrial I/O channel", location));
    for (auto const& device : iio_device_folders(folder)) {
        auto const number = number_of_device(device);
        if (iio->device != number && iio->device != read_sysfs_line(device / "name"))
            continue;
        IioPlace place { .folder = device, .device = iio->device, .channel = iio->channel };
        std::error_code error;
        if (fs::exists(place.raw_file(), error))
            return place;
        return fail(Fault::User,
                    fmt::format("{} has no channel {}: \"tractus devices\" lists those there are",
                                iio->device, iio->channel));
    }
    return fail(Fault::User,
                fmt::format("there is no industrial I/O device {}: \"tractus devices\" lists those "
                            "there are (is its driver loaded?)",
                            iio->device));
}

DeviceInfo describe_place(IioPlace const& place)
{
    auto const name = read_sysfs_line(place.folder / "name");
    return { .name = fmt::format("{} {}", name.empty() ? place.device : name, place.channel),
             .location = place.location(),
             .bus = 0 };
}

// A link whose request re-reads the channel's file from its beginning, which starts a new
// conversion.
class IioLink final : public RealPacketLink {
public:
    IioLink(int file, std::string who)
        : file_(file)
        , who_(std::move(who))
    {
    }
    ~IioLink() override { ::close(file_); }
    IioLink(IioLink const&) = delete;
    IioLink& operator=(IioLink const&) = delete;

    Result<void> write(std::span<std::byte const>) override
    {
        is_asked_ = true;
        return {};
    }

    Result<std::optional<RawReport>> read(Duration) override
    {
        if (!std::exchange(is_asked_, false))
            return std::optional<RawReport>();
        RawReport report;
        auto const size = ::pread(file_, report.storage.data(), report.storage.size(), 0);
        report.received = now();
        if (size < 0 && (errno == ENODEV || errno == ENXIO || errno == EBADF))
            return fail(Fault::Device, fmt::format("{} is gone: {}", who_, std::strerror(errno)));
        if (size
            <= 0) // The converter was busy or a conversion failed; the next request may succeed.
            return std::optional<RawReport>();
        report.size = static_cast<std::size_t>(size);
        while (report.size > 0 && report.storage[report.size - 1] == std::byte { '\n' })
            --report.size;
        return std::optional(report);
    }

private:
    int file_;
    std::string who_;
    bool is_asked_ = false;
};

bool may_be_height(std::string_view channel)
{
    static constexpr std::array<std::string_view, 6> kKinds {
        "voltage", "altvoltage", "distance", "proximity", "angl", "position"
    };
    return std::ranges::any_of(kKinds,
                               [&](std::string_view kind) { return channel.starts_with(kind); });
}

} // namespace

std::vector<DeviceInfo> list_iio_channels(fs::path const& folder)
{
    std::vector<DeviceInfo> channels;
    for (auto const& device : iio_device_folders(folder)) {
        std::vector<std::string> names;
        std::error_code error;
        for (auto const& entry : fs::directory_iterator(device, error)) {
            auto const file = entry.path().filename().string();
            if (!file.starts_with(kIn) || !file.ends_with(kRaw))
                continue;
            auto name = file.substr(kIn.size(), file.size() - kIn.size() - kRaw.size());
            if (may_be_height(name))
                names.push_back(std::move(name));
        }
        std::ranges::sort(names);
        for (auto const& name : names)
            channels.push_back(describe_place(
                { .folder = device, .device = number_of_device(device), .channel = name }));
    }
    return channels;
}

Result<DeviceInfo> describe_iio_channel(std::string const& address, fs::path const& folder)
{
    return describe_place(TRY(find_iio_channel(address, folder)));
}

Result<std::unique_ptr<ReportSource>> open_iio_channel(DeviceInfo info, fs::path const& folder)
{
    auto const place = TRY(find_iio_channel(info.location, folder));
    auto const type = read_sysfs_line(place.folder / "scan_elements"
                                      / fmt::format("in_{}_type", place.channel));
    // The maximum from the channel's type comes first, so that the user's setting overrides it.
    if (auto const greatest = greatest_of_type(type))
        info.settings
            = fmt::format("max={}{}{}", *greatest, info.settings.empty() ? "" : ",", info.settings);
    auto const settings = TRY(parse_iio_settings(info.settings));
    info.physical_path = number_line_path(kIioKind, info);
    auto const file = ::open(place.raw_file().c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return fail(Fault::User,
                    fmt::format("cannot read {}: {}", info.location, std::strerror(errno)));
    auto link = std::make_unique<IioLink>(file, fmt::format("{} at {}", info.name, info.location));
    return open_polled(std::move(info), std::move(link),
                       { .command = { std::byte {} },
                         .is_reply = [](std::span<std::byte const>) { return true; },
                         .period = settings.period,
                         .set_up = [](PacketLink&) { return Result<void>(); },
                         .spoils = {} });
}

bool is_iio_channel(DeviceInfo const& info)
{
    return number_line_settings(kIioKind, info).has_value();
}

Result<std::unique_ptr<HeightDecoder>> make_iio_channel_decoder(DeviceInfo const& info)
{
    auto const settings = number_line_settings(kIioKind, info).value_or(std::string());
    return make_number_decoder(TRY(parse_iio_settings(settings)).numbers);
}

} // namespace tractus::drivers
