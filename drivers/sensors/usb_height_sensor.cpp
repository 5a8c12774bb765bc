#include "drivers/sensors/usb_height_sensor.h"

#include "drivers/reports/report_bytes.h"
#include "drivers/sensors/settings.h"
#include "drivers/usb/usb_context.h"
#include "drivers/usb/usb_reader.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <libusb.h>
#include <utility>

namespace tractus::drivers {

using namespace std::chrono_literals;

namespace {

constexpr unsigned kControlTimeoutMs = 500;
constexpr std::uint8_t kProtocolMajor = 1;

using Bytes = std::span<std::byte const>;

std::byte low(unsigned value)
{
    return static_cast<std::byte>(value & 0xFF);
}

// The device's interface that belongs to the sensor: its number, its endpoint, and the index of its
// string.
struct SensorInterface {
    int interface_number = 0;
    std::uint8_t endpoint = 0;
    std::uint8_t string = 0;
};

std::optional<SensorInterface> sensor_interface_of(libusb_interface_descriptor const& interface)
{
    if (interface.bInterfaceClass != kHeightSensorClass
        || interface.bInterfaceSubClass != kHeightSensorSubclass
        || interface.bInterfaceProtocol != kHeightSensorProtocol)
        return std::nullopt;
    for (auto const& endpoint : std::span(interface.endpoint, interface.bNumEndpoints))
        if ((endpoint.bmAttributes & LIBUSB_TRANSFER_TYPE_MASK) == LIBUSB_TRANSFER_TYPE_BULK
            && (endpoint.bEndpointAddress & LIBUSB_ENDPOINT_IN) != 0)
            return SensorInterface { interface.bInterfaceNumber, endpoint.bEndpointAddress,
                                     interface.iInterface };
    return std::nullopt;
}

std::optional<SensorInterface> find_sensor_interface(UsbDevice const& device)
{
    libusb_config_descriptor* config = nullptr;
    if (libusb_get_active_config_descriptor(libusb_get_device(device.handle()), &config)
        != LIBUSB_SUCCESS)
        return std::nullopt;
    std::optional<SensorInterface> found;
    for (auto const& interface : std::span(config->interface, config->bNumInterfaces))
        if (!found && interface.num_altsetting > 0)
            found = sensor_interface_of(interface.altsetting[0]);
    libusb_free_config_descriptor(config);
    return found;
}

class UsbHeightSensorLink final : public HeightSensorLink {
public:
    UsbHeightSensorLink(UsbDevice device, int interface_number, std::string who)
        : device_(std::move(device))
        , interface_(static_cast<std::uint16_t>(interface_number))
        , who_(std::move(who))
    {
    }

    Result<void> start(std::uint8_t endpoint)
    {
        reader_ = TRY(UsbReader::start(device_, endpoint, who_));
        return {};
    }

    Result<std::vector<std::byte>> get(HeightSensorRequest request, std::size_t bytes) override;
    Result<void> set(HeightSensorRequest request, std::uint16_t value, Bytes data) override;

    Result<std::optional<RawReport>> read(Duration timeout) override
    {
        return reader_->read(timeout);
    }

private:
    tl::unexpected<Error> refused(HeightSensorRequest request, int code) const
    {
        return fail(Fault::Device,
                    fmt::format("{} does not do request {:02x}: {}", who_,
                                static_cast<unsigned>(request), usb_error_text(code)));
    }

    UsbDevice device_;
    std::uint16_t interface_;
    std::string who_;
    // Declared last, since it must be destroyed before the device.
    std::unique_ptr<UsbReader> reader_;
};

Result<std::vector<std::byte>> UsbHeightSensorLink::get(HeightSensorRequest request,
                                                        std::size_t bytes)
{
    std::vector<std::byte> data(bytes);
    int const size = libusb_control_transfer(device_.handle(), kVendorInterfaceIn,
                                             static_cast<std::uint8_t>(request), 0, interface_,
                                             reinterpret_cast<unsigned char*>(data.data()),
                                             static_cast<std::uint16_t>(bytes), kControlTimeoutMs);
    if (size < 0)
        return refused(request, size);
    data.resize(static_cast<std::size_t>(size));
    return data;
}

Result<void> UsbHeightSensorLink::set(HeightSensorRequest request, std::uint16_t value, Bytes data)
{
    std::vector<std::byte> bytes(
        data.begin(), data.end()); // A copy, because libusb takes a pointer to mutable memory.
    int const code = libusb_control_transfer(
        device_.handle(), kVendorInterfaceOut, static_cast<std::uint8_t>(request), value,
        interface_, reinterpret_cast<unsigned char*>(bytes.data()),
        static_cast<std::uint16_t>(bytes.size()), kControlTimeoutMs);
    if (code < 0)
        return refused(request, code);
    return {};
}

class UsbHeightSensor final : public ReportSource {
public:
    UsbHeightSensor(DeviceInfo info, std::unique_ptr<HeightSensorLink> link)
        : info_(std::move(info))
        , link_(std::move(link))
    {
    }
    ~UsbHeightSensor() override
    {
        (void)link_->set(HeightSensorRequest::SetStreaming, 0,
                         {}); // Fails for an unplugged sensor, which does not matter.
    }

    DeviceInfo const& info() const override { return info_; }
    Result<std::optional<RawReport>> read(Duration timeout) override
    {
        return link_->read(timeout);
    }

private:
    DeviceInfo info_;
    std::unique_ptr<HeightSensorLink> link_;
};

Result<void> check_identity(HeightSensorLink& link, std::string const& who)
{
    auto const identity = TRY(link.get(HeightSensorRequest::GetIdentity, kHeightIdentityBytes));
    if (identity.size() < kHeightIdentityBytes)
        return fail(Fault::Device,
                    fmt::format("{} tells {} bytes of identity, expected {}", who, identity.size(),
                                kHeightIdentityBytes));
    auto const major = std::to_integer<unsigned>(identity[0]);
    if (major != kProtocolMajor)
        return fail(Fault::Device,
                    fmt::format("{} speaks version {} of the height sensor's protocol, expected {}",
                                who, major, kProtocolMajor));
    return {};
}

// Stops the stream and discards frames that were sent before, since they would later be taken for
// new ones.
Result<void> stop_and_forget(HeightSensorLink& link)
{
    constexpr int kMaxFrames = 256;
    TRY(link.set(HeightSensorRequest::SetStreaming, 0, {}));
    for (int i = 0; i < kMaxFrames; ++i)
        if (!TRY(link.read(20ms)))
            break;
    return {};
}

tl::unexpected<Error> as_users_fault(Error error, std::string const& what)
{
    return fail(Fault::User, fmt::format("{} ({})", what, error.message));
}

Result<void> apply(HeightSensorLink& link, UsbHeightSensorOptions const& options,
                   std::string const& who)
{
    if (options.reference) {
        std::array const data { static_cast<std::byte>(*options.reference) };
        if (auto set = link.set(HeightSensorRequest::SetReference, 0, data); !set)
            return as_users_fault(set.error(), who + " has no such reference");
    }
    if (!options.period_us && !options.samples_per_frame)
        return {};
    auto const rate = TRY(link.get(HeightSensorRequest::GetRate, kHeightRateBytes));
    if (rate.size() < kHeightRateBytes)
        return fail(Fault::Device,
                    fmt::format("{} tells {} bytes of its rate, expected {}", who, rate.size(),
                                kHeightRateBytes));
    auto const period_us = options.period_us.value_or(u16(rate, 0));
    auto const samples = options.samples_per_frame.value_or(std::to_integer<std::uint8_t>(rate[2]));
    std::array const data { low(period_us), low(period_us >> 8u), std::byte { samples },
                            std::byte {} };
    if (auto set = link.set(HeightSensorRequest::SetRate, 0, data); !set)
        return as_users_fault(
            set.error(),
            fmt::format("{} does not read every {} us with {} readings to a frame", who, period_us,
                        samples));
    return {};
}

} // namespace

Result<UsbHeightSensorOptions> parse_usb_height_sensor_options(std::string_view settings)
{
    UsbHeightSensorOptions options;
    for (auto const word : split_settings(settings)) {
        auto const period_us = number_between("", word, "us");
        if (word == "supply")
            options.reference = HeightReference::Supply;
        else if (word == "internal")
            options.reference = HeightReference::Internal;
        else if (period_us && *period_us > 0 && *period_us <= 0xFFFF)
            options.period_us = static_cast<std::uint16_t>(*period_us);
        else
            return fail(Fault::User,
                        fmt::format("'{}' is no setting of the height sensor: expected "
                                    "a period such as 2000us, supply or internal",
                                    word));
    }
    return options;
}

Result<std::unique_ptr<ReportSource>> open_usb_height_sensor(DeviceInfo info)
{
    auto const options = TRY(parse_usb_height_sensor_options(info.settings));
    auto device = TRY(open_usb_device(info));
    auto const found = find_sensor_interface(device);
    if (!found)
        return fail(Fault::User,
                    fmt::format("{} at {} is no height sensor of the station's own kind: it has no "
                                "interface of class {:02x}, subclass {:02x}, protocol {:02x}",
                                info.name, info.location, kHeightSensorClass, kHeightSensorSubclass,
                                kHeightSensorProtocol));
    TRY(device.claim(found->interface_number));
    info.interface_number = found->interface_number;
    info.strings[found->string] = TRY(device.string(found->string));
    auto link
        = std::make_unique<UsbHeightSensorLink>(std::move(device), found->interface_number,
                                                fmt::format("{} at {}", info.name, info.location));
    TRY(link->start(found->endpoint));
    return open_usb_height_sensor(std::move(info), std::move(link), options);
}

Result<std::unique_ptr<ReportSource>> open_usb_height_sensor(DeviceInfo info,
                                                             std::unique_ptr<HeightSensorLink> link,
                                                             UsbHeightSensorOptions const& options)
{
    auto const who = fmt::format("{} at {}", info.name, info.location);
    TRY(check_identity(*link, who));
    TRY(stop_and_forget(*link));
    TRY(apply(*link, options, who));
    TRY(link->set(HeightSensorRequest::SetStreaming, 1, {}));
    return std::make_unique<UsbHeightSensor>(std::move(info), std::move(link));
}

} // namespace tractus::drivers
