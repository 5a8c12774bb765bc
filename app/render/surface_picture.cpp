#include "app/render/surface_picture.h"

#include "app/render/read_picture.h"
#include "engine/export/gltf_material.h"

#include <array>
#include <cstddef>

namespace tractus::render {

namespace {

Vec3f mean_color(Image const& image)
{
    std::array<double, 256> linear {};
    for (std::size_t i = 0; i < linear.size(); ++i)
        linear[i] = exports::linear_from_srgb(static_cast<double>(i) / 255);
    Vec3 sum = Vec3::Zero();
    std::size_t count = 0;
    for (auto const& pixel : image.pixels()) {
        if (pixel.alpha < 128)
            continue;
        ++count;
        sum += Vec3(linear[pixel.red], linear[pixel.green], linear[pixel.blue]);
    }
    return count > 0 ? (sum / static_cast<double>(count)).cast<float>().eval() : Vec3f::Ones();
}

void upload(SurfacePicture const& picture, Image const& image, GLint format,
            TexturePicture::Edges edges)
{
    glBindTexture(GL_TEXTURE_2D, picture.texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, format, image.width(), image.height(), 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, image.pixels().data());
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
            bool const is_color = meaning == Meaning::Color;
            if (is_color)
                place->second->mean_color = mean_color(*image);
            upload(*place->second, *image, is_color ? GL_SRGB8_ALPHA8 : GL_RGBA8, slot->edges);
        }
    }
    return place->second.get();
}

} // namespace tractus::render
