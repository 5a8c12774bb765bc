#pragma once

#include "drivers/sensors/height_sensor_protocol.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::drivers {

// Finds frames of the station's own height sensor in a byte stream that arrives in pieces of any
// length, with anything between the frames. After a frame with a wrong CRC, the search continues
// one byte after its beginning. At most one unfinished frame is held back.
class HeightFrameParser {
public:
    // Appends the frames that end in `bytes` to `out`, in order.
    void push(std::span<std::byte const> bytes, std::vector<HeightFrame>& out);

    // Number of frames with a wrong CRC.
    std::uint64_t corrupt_frames() const { return corrupt_frames_; }
    // Number of bytes outside valid frames, including those of corrupt frames.
    std::uint64_t garbage_bytes() const { return garbage_bytes_; }

private:
    std::size_t parse(std::span<std::byte const> bytes, std::vector<HeightFrame>& out);

    std::vector<std::byte> unfinished_;
    std::uint64_t corrupt_frames_ = 0;
    std::uint64_t garbage_bytes_ = 0;
};

} // namespace tractus::drivers
