#pragma once

#include "drivers/sensors/height_sensor_protocol.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::drivers {

// Finds the frames of the station's own height sensor in whatever comes over the wire: pieces of
// any length, with anything between the frames. A frame whose CRC is wrong is left out, and the
// next one is looked for right behind its first byte. It holds back at most one unfinished frame.
class HeightFrameParser {
public:
    // Appends the frames that end in `bytes` to `out`, in order.
    void push(std::span<std::byte const> bytes, std::vector<HeightFrame>& out);

    std::uint64_t corrupt_frames() const { return corrupt_frames_; } // Their CRC was wrong.
    // Includes those of corrupt frames.
    std::uint64_t garbage_bytes() const { return garbage_bytes_; }

private:
    std::size_t parse(std::span<std::byte const> bytes, std::vector<HeightFrame>& out);

    std::vector<std::byte> unfinished_;
    std::uint64_t corrupt_frames_ = 0;
    std::uint64_t garbage_bytes_ = 0;
};

} // namespace tractus::drivers
