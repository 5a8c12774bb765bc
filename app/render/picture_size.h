#pragma once

#include <optional>
#include <string_view>

namespace tractus::render {

// Size of a picture in pixels.
struct PictureSize {
    static constexpr int kSmallest_px = 16;
    static constexpr int kLargest_px = 8192;

    int width_px = 1280;
    int height_px = 960;

    double aspect() const { return static_cast<double>(width_px) / height_px; }

    bool operator==(PictureSize const&) const = default;
};

// Parses "1200x900", or "900", which means 900x900. No value for any other text, and for a side
// below kSmallest_px or above kLargest_px.
std::optional<PictureSize> parse_picture_size(std::string_view text);

} // namespace tractus::render
