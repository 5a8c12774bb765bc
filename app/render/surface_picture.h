#pragma once

#include "app/render/gl_objects.h"
#include "engine/plant/material.h"

#include <map>
#include <memory>
#include <utility>

namespace tractus::render {

// A picture on the graphics card, with mipmaps, rows as texture coordinates count them.
struct SurfacePicture {
    gl::Texture texture;
    Vec3f mean_color = Vec3f::Ones(); // Linear, of what is at least half there; of colours only.
};

// The pictures of a mesh's materials, each once. Lives and dies with the context.
class SurfacePictures {
public:
    // What the bytes of a picture stand for: sRGB, or numbers as they are.
    enum class Meaning { Color, Numbers };

    // Null for no picture, and for bytes that are none: such a surface does without.
    SurfacePicture const* find_or_add(TextureSlot const& slot, Meaning meaning);

private:
    std::map<std::pair<TextureSlot, Meaning>, std::unique_ptr<SurfacePicture>> pictures_;
};

} // namespace tractus::render
