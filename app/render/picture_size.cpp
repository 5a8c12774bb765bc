#include "app/render/picture_size.h"

#include <charconv>
#include <system_error>

namespace tractus::render {

std::optional<PictureSize> parse_picture_size(std::string_view text)
{
    PictureSize size;
    auto const* const end = text.data() + text.size();
    auto read = std::from_chars(text.data(), end, size.width_px);
    size.height_px = size.width_px;
    if (read.ec == std::errc() && read.ptr != end && *read.ptr == 'x')
        read = std::from_chars(read.ptr + 1, end, size.height_px);
    auto const fits
        = [](int px) { return px >= PictureSize::kSmallest_px && px <= PictureSize::kLargest_px; };
    if (read.ec != std::errc() || read.ptr != end || !fits(size.width_px) || !fits(size.height_px))
        return std::nullopt;
    return size;
}

} // namespace tractus::render
