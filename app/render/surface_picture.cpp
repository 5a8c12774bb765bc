#include "app/render/surface_picture.h"

#include "app/render/read_picture.h"
#include "engine/base/mips.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

namespace tractus::render {

namespace {

// Uploads the smaller levels of a picture with a mask to the texture that is bound.
void upload_masked_levels(Image const& image)
{
    PixelMap picture { .width = image.width(), .height = image.height() };
    std::vector<std::uint8_t> alpha;
    alpha.reserve(image.pixels().size());
    picture.pixels.reserve(4 * image.pixels().size());
    for (auto const& pixel : image.pixels()) {
        picture.pixels.insert(picture.pixels.end(),
                              { pixel.red, pixel.green, pixel.blue, pixel.alpha });
        alpha.push_back(pixel.alpha);
    }
    GLint level = 0;
    AlphaMips const mask(alpha, image.width(), image.height(), 1);
    for (auto const& made : mip_levels(picture, MapKind::Color, mask))
        glTexImage2D(GL_TEXTURE_2D, ++level, GL_SRGB8_ALPHA8, made.width, made.height, 0, GL_RGBA,
                     GL_UNSIGNED_BYTE, made.pixels.data());
}

void upload(SurfacePicture const& picture, Image const& image, SurfacePictures::Meaning meaning,
            TexturePicture::Edges edges)
{
    bool const is_color = meaning == SurfacePictures::Meaning::Color;
    glBindTexture(GL_TEXTURE_2D, picture.texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, is_color ? GL_SRGB8_ALPHA8 : GL_RGBA8, image.width(),
                 image.height(), 0, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels().data());
    bool const has_mask = is_color && std::ranges::any_of(image.pixels(), [](Color const& pixel) {
                              return pixel.alpha < 255;
                          });
    if (has_mask)
        upload_masked_levels(image);
    else
        glGenerateMipmap(GL_TEXTURE_2D);
    GLint const wrap = edges == TexturePicture::Edges::Repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
}

} // namespace

SurfacePicture const* SurfacePictures::find_or_add(TextureSlot const& slot, Meaning meaning)
{
    if (!slot)
        return nullptr;
    auto const [place, is_new] = pictures_.try_emplace({ slot, meaning });
    if (is_new) {
        auto const image = read_picture(slot->bytes);
        GLint most = 0;
        glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
        if (image && image->width() <= most && image->height() <= most) {
            place->second = std::make_unique<SurfacePicture>();
            upload(*place->second, *image, meaning, slot->edges);
        }
    }
    return place->second.get();
}

void SurfacePictures::drop_unused()
{
    // Each meaning of a picture has an entry of its own, which refers to the picture, too.
    for (auto entry = pictures_.begin(); entry != pictures_.end();) {
        auto const& slot = entry->first.first;
        auto const entries = static_cast<long>(pictures_.count({ slot, Meaning::Color })
                                               + pictures_.count({ slot, Meaning::Numbers }));
        entry = slot.use_count() == entries ? pictures_.erase(entry) : std::next(entry);
    }
}

} // namespace tractus::render
