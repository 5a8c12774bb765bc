#include "sim/height_sensor_frames.h"

#include "engine/base/check.h"

#include <algorithm>
#include <fmt/core.h>
#include <initializer_list>
#include <string_view>

namespace tractus::sim {

namespace {

using Bytes = std::vector<std::byte>;

constexpr std::uint16_t kVendorId = 0x1209;
// Product id of pid.codes for tests; see firmware-notes/height-sensor-protocol.md.
constexpr std::uint16_t kProductId = 0x0002;
constexpr std::uint8_t kInterfaceString = 4;
constexpr std::uint8_t kMicrosoftRequest = 0x20;
constexpr std::uint16_t kMicrosoftDescriptorIndex = 7;
constexpr std::uint8_t kVendorDeviceIn = 0xC0;
constexpr std::string_view kInterfaceGuid = "{D2393374-6068-4913-93D5-62CC4519FEE5}";
constexpr std::uint16_t kShortestPeriodUs = 100;
constexpr std::uint16_t kLongestPeriodUs = 20'000;

void put(Bytes& bytes, std::initializer_list<unsigned> values)
{
    for (unsigned const value : values)
        bytes.push_back(static_cast<std::byte>(value));
}

void put_u16(Bytes& bytes, std::size_t value)
{
    put(bytes, { static_cast<unsigned>(value & 0xFF), static_cast<unsigned>(value >> 8 & 0xFF) });
}

void put_u32(Bytes& bytes, std::uint32_t value)
{
    put_u16(bytes, value & 0xFFFF);
    put_u16(bytes, value >> 16);
}

// Appends an ASCII text as UTF-16, followed by `zeros` zero characters.
void put_wide(Bytes& bytes, std::string_view text, std::size_t zeros)
{
    for (char const letter : text)
        put_u16(bytes, static_cast<unsigned char>(letter));
    for (std::size_t i = 0; i < zeros; ++i)
        put_u16(bytes, 0);
}

// Appends the version number of Windows 8.1, the first version that reads the Microsoft
// descriptors.
void put_windows_version(Bytes& bytes)
{
    put_u32(bytes, 0x0603'0000);
}

bool is_period(unsigned period_us)
{
    return period_us >= kShortestPeriodUs && period_us <= kLongestPeriodUs;
}

bool is_frame_size(unsigned samples)
{
    return samples >= 1 && samples <= drivers::kMaxHeightFrameSamples;
}

} // namespace

std::vector<std::byte> encode_height_frame(drivers::HeightFrame const& frame)
{
    CHECK(is_frame_size(static_cast<unsigned>(frame.count)));
    Bytes bytes;
    bytes.reserve(drivers::kMaxHeightFrameBytes);
    for (auto const letter : drivers::kHeightFrameMagic)
        put(bytes, { letter });
    put(bytes, { frame.flags, static_cast<unsigned>(frame.count) });
    put_u16(bytes, frame.sequence);
    put_u32(bytes, frame.device_us);
    put_u16(bytes, frame.period_us);
    for (auto const counts : frame.readings())
        put_u16(bytes, counts);
    put_u16(bytes, drivers::height_frame_crc(bytes));
    return bytes;
}

HeightSensorModel::HeightSensorModel()
    : HeightSensorModel(Options {})
{
}

HeightSensorModel::HeightSensorModel(Options const& options)
    : options_(options)
    , period_us_(options.period_us)
    , samples_per_frame_(options.samples_per_frame)
{
    CHECK(is_period(options.period_us) && is_frame_size(options.samples_per_frame));
}

std::vector<std::byte> HeightSensorModel::device_descriptor() const
{
    Bytes bytes;
    put(bytes, { 18, 1 });       // Length and type of the device descriptor.
    put_u16(bytes, 0x0210);      // USB 2.1, since the device has a BOS descriptor.
    put(bytes, { 0, 0, 0, 64 }); // Class defined by the interface; endpoint 0 has 64-byte packets.
    put_u16(bytes, kVendorId);
    put_u16(bytes, kProductId);
    put_u16(bytes, 0x0100);     // Version of the device.
    put(bytes, { 1, 2, 3, 1 }); // String indices; one configuration.
    return bytes;
}

std::vector<std::byte> HeightSensorModel::configuration_descriptor(UsbSpeed speed) const
{
    auto const interface = interface_descriptors(speed, kInterfaceString);
    Bytes bytes;
    put(bytes, { 9, 2 }); // Length and type of the configuration descriptor.
    put_u16(bytes, 9 + interface.size());
    put(bytes, { 1, 1, 0, 0x80, 50 }); // One interface; bus-powered, 100 mA.
    bytes.insert(bytes.end(), interface.begin(), interface.end());
    return bytes;
}

std::vector<std::byte> HeightSensorModel::interface_descriptors(UsbSpeed speed,
                                                                std::uint8_t string) const
{
    Bytes bytes;
    put(bytes,
        { 9, 4, 0, 0, 1, drivers::kHeightSensorClass, drivers::kHeightSensorSubclass,
          drivers::kHeightSensorProtocol, string }); // Interface 0 with one endpoint.
    put(bytes, { 7, 5, 0x81, 2 });                   // Endpoint 1, IN, bulk.
    put_u16(bytes, speed == UsbSpeed::High ? 512 : 64);
    put(bytes, { 0 });
    return bytes;
}

std::vector<std::byte> HeightSensorModel::microsoft_os_descriptors() const
{
    constexpr std::string_view kProperty = "DeviceInterfaceGUIDs";
    Bytes bytes;
    put_u16(bytes, 10); // Header of the descriptor set.
    put_u16(bytes, 0);
    put_windows_version(bytes);
    put_u16(bytes, 162);
    put_u16(bytes, 20); // Compatible with Windows' WinUSB driver.
    put_u16(bytes, 3);
    for (char const letter : std::string_view("WINUSB"))
        put(bytes, { static_cast<unsigned char>(letter) });
    bytes.resize(bytes.size() + 10);
    put_u16(bytes, 132); // Interface GUID by which programs find the interface.
    put_u16(bytes, 4);
    put_u16(bytes, 7);
    put_u16(bytes, 2 * (kProperty.size() + 1));
    put_wide(bytes, kProperty, 1);
    put_u16(bytes, 2 * (kInterfaceGuid.size() + 2));
    put_wide(bytes, kInterfaceGuid, 2);
    return bytes;
}

std::vector<std::byte> HeightSensorModel::bos_descriptor() const
{
    Bytes bytes;
    put(bytes, { 5, 15, 33, 0, 1 }); // Binary object store with one capability:
    // Platform capability with the UUID {D8DD60DF-4589-4CC7-9CD2-…}.
    put(bytes, { 28, 16, 5, 0 });
    put(bytes, { 0xDF, 0x60, 0xDD, 0xD8, 0x89, 0x45, 0xC7, 0x4C });
    put(bytes, { 0x9C, 0xD2, 0x65, 0x9D, 0x9E, 0x64, 0x8A, 0x9F });
    put_windows_version(bytes);
    put_u16(bytes, microsoft_os_descriptors().size());
    put(bytes, { kMicrosoftRequest, 0 });
    return bytes;
}

std::string HeightSensorModel::interface_string() const
{
    return fmt::format("{}{}", drivers::kHeightSensorTitle, options_.full_scale);
}

std::vector<std::string> HeightSensorModel::strings() const
{
    return { "tractus", "Height sensor", options_.serial_number, interface_string() };
}

drivers::DeviceInfo HeightSensorModel::info() const
{
    auto const texts = strings();
    return { .name = texts[1],
             .manufacturer = texts[0],
             .serial_number = texts[2],
             .location = "simulated",
             .physical_path = "simulated/height",
             .interface_number = 0,
             .vendor_id = kVendorId,
             .product_id = kProductId,
             .strings = { { kInterfaceString, texts[3] } } };
}

std::optional<std::vector<std::byte>> HeightSensorModel::answer(UsbSetup const& setup,
                                                                std::uint32_t now_us) const
{
    Bytes bytes;
    if (setup.request_type == kVendorDeviceIn) {
        if (setup.request != kMicrosoftRequest || setup.index != kMicrosoftDescriptorIndex)
            return std::nullopt;
        bytes = microsoft_os_descriptors();
    } else if (setup.request_type != drivers::kVendorInterfaceIn || setup.value != 0) {
        return std::nullopt;
    } else if (setup.request
               == static_cast<std::uint8_t>(drivers::HeightSensorRequest::GetIdentity)) {
        put(bytes, { 1, 0 });   // Version 1.0 of the protocol.
        put_u16(bytes, 0x0100); // Version 1.00 of the firmware.
        put_u16(bytes, options_.full_scale);
        put(bytes, { 12, 1 }); // Bits of the converter; conversions per reading.
        put_u16(bytes, kShortestPeriodUs);
        put_u16(bytes, kLongestPeriodUs);
        // Supported references, and the maximum number of readings per frame.
        put(bytes, { 0x03, drivers::kMaxHeightFrameSamples });
        put_u16(bytes, 0);
        put_u32(bytes, now_us);
    } else if (setup.request == static_cast<std::uint8_t>(drivers::HeightSensorRequest::GetRate)) {
        put_u16(bytes, period_us_);
        put(bytes, { samples_per_frame_, 0 });
    } else if (setup.request
               == static_cast<std::uint8_t>(drivers::HeightSensorRequest::GetReference)) {
        put(bytes, { static_cast<std::uint8_t>(reference_) });
    } else {
        return std::nullopt;
    }
    bytes.resize(std::min<std::size_t>(bytes.size(), setup.length));
    return bytes;
}

bool HeightSensorModel::accept(UsbSetup const& setup, std::span<std::byte const> data)
{
    auto const at = [&](std::size_t i) { return std::to_integer<unsigned>(data[i]); };
    if (setup.request_type != drivers::kVendorInterfaceOut || data.size() != setup.length)
        return false;
    switch (static_cast<drivers::HeightSensorRequest>(setup.request)) {
    case drivers::HeightSensorRequest::SetRate: {
        if (setup.value != 0 || data.size() != drivers::kHeightRateBytes || at(3) != 0
            || !is_period(at(0) | at(1) << 8) || !is_frame_size(at(2)))
            return false;
        period_us_ = static_cast<std::uint16_t>(at(0) | at(1) << 8);
        samples_per_frame_ = static_cast<std::uint8_t>(at(2));
        frame_.count = 0;
        return true;
    }
    case drivers::HeightSensorRequest::SetReference:
        if (setup.value != 0 || data.size() != 1 || at(0) > 1)
            return false;
        reference_ = static_cast<drivers::HeightReference>(at(0));
        return true;
    case drivers::HeightSensorRequest::SetStreaming:
        if (setup.value > 1 || !data.empty())
            return false;
        is_streaming_ = setup.value == 1;
        frame_ = { .flags = drivers::kHeightFrameStart };
        return true;
    default:
        return false;
    }
}

std::optional<std::vector<std::byte>> HeightSensorModel::push(std::uint32_t device_us,
                                                              std::uint16_t counts)
{
    if (!is_streaming_)
        return std::nullopt;
    if (frame_.count == 0) {
        frame_.device_us = device_us;
        frame_.period_us = period_us_;
    }
    frame_.counts[frame_.count++] = std::min(counts, options_.full_scale);
    if (frame_.count < samples_per_frame_)
        return std::nullopt;
    auto bytes = encode_height_frame(frame_);
    frame_ = { .sequence = static_cast<std::uint16_t>(frame_.sequence + 1) };
    return bytes;
}

void HeightSensorModel::lose_frames(std::uint16_t count)
{
    frame_.sequence = static_cast<std::uint16_t>(frame_.sequence + count);
    frame_.flags |= drivers::kHeightFrameOverrun;
    frame_.count = 0;
}

} // namespace tractus::sim
