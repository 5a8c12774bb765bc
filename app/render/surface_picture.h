#pragma once

#include "app/render/gl_objects.h"
#include "engine/plant/material.h"

#include <map>
#include <memory>

namespace tractus {

// A picture on the graphics card, sRGB with mipmaps, rows as texture coordinates count them.
struct SurfacePicture {
    gl::Texture texture;
    Vec3f mean_color = Vec3f::Ones(); // Linear, of what is at least half there.
};

// The pictures of a mesh's materials, each once. Lives and dies with the context.
class SurfacePictures {
public:
    // Null for no picture, and for bytes that are none: such a surface has its colour alone.
    SurfacePicture const* find_or_add(TextureSlot const& slot);

private:
    std::map<TextureSlot, std::unique_ptr<SurfacePicture>> pictures_;
};

} // namespace tractus
