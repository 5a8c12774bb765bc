#include "drivers/sensors/height_frame_parser.h"

#include "drivers/reports/report_bytes.h"

#include <algorithm>
#include <iterator>

namespace tractus::drivers {

namespace {

using Bytes = std::span<std::byte const>;

// True if the bytes are the head of a frame, or could be the beginning of one.
bool may_be_frame(Bytes bytes)
{
    auto const length = std::min(bytes.size(), kHeightFrameMagic.size());
    for (std::size_t i = 0; i < length; ++i)
        if (u8(bytes, i) != kHeightFrameMagic[i])
            return false;
    if (bytes.size() < kHeightFrameHeaderBytes)
        return true;
    auto const count = std::to_integer<std::size_t>(bytes[5]);
    return count > 0 && count <= kMaxHeightFrameSamples;
}

HeightFrame read_frame(Bytes bytes)
{
    HeightFrame frame;
    frame.flags = std::to_integer<std::uint8_t>(bytes[4]);
    frame.count = std::to_integer<std::uint8_t>(bytes[5]);
    frame.sequence = u16(bytes, 6);
    frame.device_us = u16(bytes, 8) | static_cast<std::uint32_t>(u16(bytes, 10)) << 16;
    frame.period_us = u16(bytes, 12);
    for (std::size_t i = 0; i < frame.count; ++i)
        frame.counts[i] = u16(bytes, kHeightFrameHeaderBytes + 2 * i);
    return frame;
}

} // namespace

void HeightFrameParser::push(Bytes bytes, std::vector<HeightFrame>& out)
{
    if (unfinished_.empty()) { // Usual case: a transfer is exactly one frame.
        auto const used = parse(bytes, out);
        unfinished_.assign(bytes.begin() + static_cast<std::ptrdiff_t>(used), bytes.end());
        return;
    }
    std::copy(bytes.begin(), bytes.end(), std::back_inserter(unfinished_));
    auto const used = parse(unfinished_, out);
    unfinished_.erase(unfinished_.begin(), unfinished_.begin() + static_cast<std::ptrdiff_t>(used));
}

// Parses all complete frames in `bytes`. Returns how many of the bytes have been dealt with.
std::size_t HeightFrameParser::parse(Bytes bytes, std::vector<HeightFrame>& out)
{
    std::size_t at = 0;
    while (at < bytes.size()) {
        auto const rest = bytes.subspan(at);
        if (!may_be_frame(rest)) {
            ++garbage_bytes_;
            ++at;
            continue;
        }
        if (rest.size() < kHeightFrameHeaderBytes)
            break;
        std::size_t const crc_at
            = kHeightFrameHeaderBytes + 2 * std::to_integer<std::size_t>(rest[5]);
        if (rest.size() < crc_at + kHeightFrameCrcBytes)
            break;
        if (height_frame_crc(rest.first(crc_at)) != u16(rest, crc_at)) {
            ++corrupt_frames_;
            ++garbage_bytes_;
            ++at;
            continue;
        }
        out.push_back(read_frame(rest));
        at += crc_at + kHeightFrameCrcBytes;
    }
    return at;
}

} // namespace tractus::drivers
