#include "sim/cp2112_model.h"

#include "sim/cp2112_bus.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace tractus::sim {

namespace {

// Ids of the CP2112's feature reports, their contents, and their lengths including the id (AN495,
// section 5). Report 2 has the outputs, push-pull outputs, special functions and clock.
constexpr std::uint8_t kGpioConfiguration = 2;
constexpr std::uint8_t kGetLines = 3; // Report with the levels of the lines.
constexpr std::uint8_t kSetLines = 4; // Report with levels and a mask.
constexpr std::uint8_t kVersion = 5;  // Report with part number and version.
constexpr std::uint8_t kBusConfiguration = 6;
constexpr std::size_t kSetLinesBytes = 3;
constexpr std::size_t kOutputs = 1; // Offset of the outputs in report 2.

template<std::size_t Size> std::array<std::byte, Size> report(std::initializer_list<int> values)
{
    std::array<std::byte, Size> bytes {};
    std::transform(values.begin(), values.end(), bytes.begin(),
                   [](int value) { return static_cast<std::byte>(value); });
    return bytes;
}

// Appends one feature report of a vendor-defined page with the given id and size.
void append_feature(std::vector<std::byte>& descriptor, int id, std::size_t report_bytes)
{
    auto const data_bytes = static_cast<int>(report_bytes) - 1;
    for (int const item : { 0x85, id, 0x95, data_bytes, 0x75, 8, 0x09, 1, 0xb1, 2 })
        descriptor.push_back(static_cast<std::byte>(item));
}

} // namespace

Cp2112Model::Cp2112Model(Wiring wiring)
    : wiring_(std::move(wiring))
    , configuration_(report<5>({ kGpioConfiguration }))
    // Bus clock of 100 kHz, most significant byte first; the other bytes are as after power-up.
    , bus_(report<14>({ kBusConfiguration, 0, 1, 0x86, 0xa0, 2 }))
{
}

drivers::DeviceInfo Cp2112Model::info()
{
    drivers::DeviceInfo info {
        .name = "Simulated CP2112 HID USB-to-SMBus Bridge",
        .location = "simulated",
        .physical_path = "simulated/cp2112",
        .vendor_id = 0x10c4,
        .product_id = 0xea90,
    };
    auto& descriptor = info.report_descriptor;
    for (int const item : { 0x06, 0x00, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x15, 0, 0x26, 0xff, 0 })
        descriptor.push_back(static_cast<std::byte>(item));
    append_feature(descriptor, kGpioConfiguration, 5);
    append_feature(descriptor, kGetLines, 2);
    append_feature(descriptor, kSetLines, kSetLinesBytes);
    append_feature(descriptor, kVersion, 3);
    append_feature(descriptor, kBusConfiguration, 14);
    Cp2112Bus::append_reports(descriptor);
    descriptor.push_back(std::byte { 0xc0 });
    return info;
}

std::optional<std::vector<std::byte>> Cp2112Model::get_feature(std::uint8_t id) const
{
    auto const copy = [](auto const& bytes) { return std::vector(bytes.begin(), bytes.end()); };
    switch (id) {
    case kGpioConfiguration:
        return copy(configuration_);
    case kGetLines:
        if (is_failing_)
            return std::nullopt;
        return copy(report<2>({ kGetLines, read_lines() }));
    case kVersion:
        return copy(report<3>({ kVersion, 0x0c, 3 }));
    case kBusConfiguration:
        return copy(bus_);
    default:
        return std::nullopt;
    }
}

bool Cp2112Model::set_feature(std::span<std::byte const> set)
{
    auto const id = set.empty() ? 0 : std::to_integer<int>(set[0]);
    if (id == kGpioConfiguration && set.size() >= configuration_.size()) {
        std::copy_n(set.begin(), configuration_.size(), configuration_.begin());
        drive();
    } else if (id == kSetLines && set.size() >= kSetLinesBytes) {
        auto const mask = std::to_integer<unsigned>(set[2]);
        auto const levels = std::to_integer<unsigned>(set[1]);
        latch_ = static_cast<std::uint8_t>((latch_ & ~mask) | (levels & mask));
        drive();
    } else if (id == kBusConfiguration && set.size() >= bus_.size()) {
        std::copy_n(set.begin(), bus_.size(), bus_.begin());
    } else {
        return false;
    }
    return true;
}

std::uint8_t Cp2112Model::read_lines() const
{
    auto const outputs = std::to_integer<unsigned>(configuration_[kOutputs]);
    unsigned const others = wiring_.levels ? wiring_.levels() : 0;
    return static_cast<std::uint8_t>((latch_ & outputs) | (others & ~outputs));
}

void Cp2112Model::drive()
{
    auto const outputs = std::to_integer<unsigned>(configuration_[kOutputs]);
    if (wiring_.driven)
        wiring_.driven(static_cast<std::uint8_t>(latch_ & outputs));
}

} // namespace tractus::sim
