#include "sim/cp2112_bus.h"

#include <algorithm>
#include <utility>

namespace tractus::sim {

namespace {

// Ids of the CP2112's reports for its I²C bus (AN495, section 4).
constexpr int kReadRequest = 0x10; // Contains address, length.
// Contains address, length, number of bytes to write, and these bytes.
constexpr int kWriteReadRequest = 0x11;
constexpr int kForceRead = 0x12;    // Contains a length.
constexpr int kReadResponse = 0x13; // Contains status, length, and the bytes read.
constexpr int kWriteRequest = 0x14; // Contains address, length, and the bytes to write.
constexpr int kStatusRequest = 0x15;
constexpr int kStatusResponse = 0x16; // Contains two bytes of status, retries, length.
constexpr int kCancel = 0x17;

constexpr std::size_t kReportBytes = 64;
constexpr std::size_t kDataBytes = 61; // Maximum number of data bytes in one report.

// Values of the status byte in a kStatusResponse report.
constexpr int kIdle = 0;
constexpr int kComplete = 2;
constexpr int kFailed = 3;
constexpr int kNotAcknowledged = 0; // Reason of a failure: no chip acknowledged the address.
constexpr int kSucceeded = 5;

int byte_at(std::span<std::byte const> bytes, std::size_t at)
{
    return at < bytes.size() ? std::to_integer<int>(bytes[at]) : 0;
}

std::size_t length_at(std::span<std::byte const> bytes, std::size_t at)
{
    return static_cast<std::size_t>(byte_at(bytes, at) << 8 | byte_at(bytes, at + 1));
}

std::span<std::byte const> part_of(std::span<std::byte const> bytes, std::size_t from,
                                   std::size_t size)
{
    from = std::min(from, bytes.size());
    return bytes.subspan(from, std::min(size, bytes.size() - from));
}

} // namespace

Cp2112Bus::Cp2112Bus(I2cChip chip)
    : chip_(std::move(chip))
{
}

void Cp2112Bus::append_reports(std::vector<std::byte>& descriptor)
{
    constexpr int kInput = 0x81;
    constexpr int kOutput = 0x91;
    for (int id = kReadRequest; id <= kCancel; ++id) {
        bool const is_input = id == kReadResponse || id == kStatusResponse;
        for (int const item : { 0x85, id, 0x95, static_cast<int>(kReportBytes) - 1, 0x75, 8, 0x09,
                                1, is_input ? kInput : kOutput, 2 })
            descriptor.push_back(static_cast<std::byte>(item));
    }
}

std::vector<std::byte> Cp2112Bus::output(std::span<std::byte const> report)
{
    auto const address = static_cast<std::uint8_t>(byte_at(report, 1) >> 1);
    switch (byte_at(report, 0)) {
    case kReadRequest:
        start_read(length_at(report, 2), address);
        break;
    case kWriteReadRequest:
        start_write(part_of(report, 5, static_cast<std::size_t>(byte_at(report, 4))), address);
        start_read(length_at(report, 2), address);
        break;
    case kWriteRequest:
        start_write(part_of(report, 3, static_cast<std::size_t>(byte_at(report, 2))), address);
        break;
    case kForceRead:
        return next_data();
    case kStatusRequest:
        return status();
    case kCancel:
        has_started_ = false;
        unread_.clear();
        break;
    default:
        break;
    }
    return {};
}

void Cp2112Bus::start_write(std::span<std::byte const> bytes, std::uint8_t address)
{
    has_started_ = true;
    is_acknowledged_ = address == chip_.address;
    transferred_ = is_acknowledged_ ? bytes.size() : 0;
    unread_.clear();
    if (is_acknowledged_ && chip_.write)
        chip_.write(bytes);
}

void Cp2112Bus::start_read(std::size_t size, std::uint8_t address)
{
    has_started_ = true;
    is_acknowledged_ = address == chip_.address;
    unread_.clear();
    if (is_acknowledged_ && chip_.read)
        unread_ = chip_.read(size);
    transferred_ = unread_.size();
}

std::vector<std::byte> Cp2112Bus::status() const
{
    std::vector<std::byte> report(kReportBytes);
    report[0] = std::byte { kStatusResponse };
    auto const state = !has_started_ ? kIdle : is_acknowledged_ ? kComplete : kFailed;
    report[1] = static_cast<std::byte>(state);
    report[2] = static_cast<std::byte>(is_acknowledged_ ? kSucceeded : kNotAcknowledged);
    report[5] = static_cast<std::byte>(transferred_ >> 8);
    report[6] = static_cast<std::byte>(transferred_);
    return report;
}

std::vector<std::byte> Cp2112Bus::next_data()
{
    auto const size = std::min(unread_.size(), kDataBytes);
    std::vector<std::byte> report(kReportBytes);
    report[0] = std::byte { kReadResponse };
    report[1] = static_cast<std::byte>(kComplete);
    report[2] = static_cast<std::byte>(size);
    std::copy_n(unread_.begin(), size, report.begin() + 3);
    unread_.erase(unread_.begin(), unread_.begin() + static_cast<std::ptrdiff_t>(size));
    return report;
}

} // namespace tractus::sim
