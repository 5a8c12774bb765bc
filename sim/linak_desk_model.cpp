#include "sim/linak_desk_model.h"

#include "engine/base/check.h"

#include <algorithm>

namespace tractus::sim {

namespace {

constexpr std::byte kDeskBegin { 0x03 };
constexpr std::byte kDeskMove { 0x05 };
constexpr std::uint8_t kDeskStatus = 0x04;

std::byte low_byte(std::int16_t value)
{
    return static_cast<std::byte>(static_cast<std::uint16_t>(value) & 0xff);
}

std::byte high_byte(std::int16_t value)
{
    return static_cast<std::byte>(static_cast<std::uint16_t>(value) >> 8);
}

// True if all four target positions are 0x8001, which means "stay".
bool is_stop(std::span<std::byte const> report)
{
    if (report.size() < 9)
        return false;
    for (std::size_t at = 1; at < 9; at += 2)
        if (report[at] != std::byte { 0x01 } || report[at + 1] != std::byte { 0x80 })
            return false;
    return true;
}

} // namespace

void LinakDeskModel::move_to(std::int16_t tenths_mm)
{
    CHECK(tenths_mm >= 0);
    height_ = tenths_mm;
}

std::optional<std::vector<std::byte>> LinakDeskModel::get_feature(std::uint8_t id)
{
    if (id != kDeskStatus)
        return std::nullopt;
    std::vector<std::byte> report(kReportBytes);
    report[0] = std::byte { kDeskStatus };
    report[1] = std::byte { 0x38 };
    if (!is_ready())
        return report;
    bool const is_moving = height_ != requested_height_;
    report[2] = std::byte { 0x01 };
    report[4] = low_byte(height_);
    report[5] = high_byte(height_);
    report[6] = std::byte { 0xf0 };
    if (is_moving)
        report[6] = height_ > requested_height_ ? std::byte { 0x10 } : std::byte { 0xe0 };
    report[7] = static_cast<std::byte>(is_moving);
    report[20] = std::byte { 0x01 };
    report[21] = std::byte { 0x80 };
    requested_height_ = height_;
    return report;
}

bool LinakDeskModel::set_feature(std::span<std::byte const> report)
{
    if (report.size() < 4 || (report[0] != kDeskBegin && report[0] != kDeskMove))
        return false;
    if (report[0] == kDeskBegin) {
        if (report[1] == std::byte { 0x04 } && report[3] == std::byte { 0xfb })
            initialisation_ = Initialisation::Begun;
    } else if (!is_stop(report)) {
        ++movement_count_;
    } else if (initialisation_ == Initialisation::Begun) {
        initialisation_ = Initialisation::Done;
    }
    return true;
}

std::vector<std::byte> LinakDeskModel::report_descriptor()
{
    constexpr std::array kBefore { 0x06, 0x00, 0xff, 0x09, 0x01, 0xa1, 0x01, 0x15,
                                   0x00, 0x26, 0xff, 0x00, 0x75, 0x08, 0x95, 0x3f };
    std::vector<std::byte> descriptor;
    for (int const item : kBefore)
        descriptor.push_back(static_cast<std::byte>(item));
    for (int id = 1; id <= 6; ++id)
        for (int const item : { 0x85, id, 0x09, id, 0xb1, 0x02 })
            descriptor.push_back(static_cast<std::byte>(item));
    descriptor.push_back(std::byte { 0xc0 });
    return descriptor;
}

} // namespace tractus::sim
