#include "app/render/read_picture.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fmt/core.h>
#include <limits>
#include <memory>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>

namespace tractus {

Result<Image> read_picture(std::string_view bytes)
{
    constexpr std::int64_t kMostPixels = 100'000'000;
    if (bytes.size() > std::numeric_limits<int>::max())
        return fail(Fault::User, "the picture is larger than 2 GiB");
    auto const* const data = reinterpret_cast<stbi_uc const*>(bytes.data());
    auto const size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0)
        return fail(Fault::User, "it is neither a PNG nor a JPEG picture");
    if (std::int64_t { width } * height > kMostPixels)
        return fail(Fault::User,
                    fmt::format("the picture has {} x {} pixels, more than 100 million: make it "
                                "smaller",
                                width, height));
    std::unique_ptr<stbi_uc, void (*)(void*)> const pixels(
        stbi_load_from_memory(data, size, &width, &height, &channels, STBI_rgb_alpha), std::free);
    if (!pixels)
        return fail(Fault::User, fmt::format("the picture is damaged: {}", stbi_failure_reason()));
    Image image(width, height);
    static_assert(sizeof(Color) == STBI_rgb_alpha);
    std::memcpy(image.pixels().data(), pixels.get(), image.pixels().size() * sizeof(Color));
    return image;
}

} // namespace tractus
