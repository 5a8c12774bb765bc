#pragma once

#include "app/render/gl_objects.h"
#include "engine/plant/material.h"

#include <map>
#include <memory>
#include <utility>

namespace tractus::render {

// A picture uploaded to the GPU, with mipmaps and rows in texture coordinate order. The mipmaps of
// a colour picture with a mask keep the mask's coverage and the mean colour in it (AlphaMips).
struct SurfacePicture {
    gl::Texture texture;
};

// The pictures of all materials that are drawn in an OpenGL context, which it must not outlive.
// Each is uploaded once, however many meshes have it.
class SurfacePictures {
public:
    // What a picture's pixels contain: sRGB colours, or plain numbers.
    enum class Meaning { Color, Numbers };

    // Returns the picture of a texture slot. Null if the slot is empty or its bytes cannot be
    // decoded; the surface is then drawn without this picture.
    SurfacePicture const* find_or_add(TextureSlot const& slot, Meaning meaning);

    // Removes the pictures that nothing else refers to any more.
    void drop_unused();

private:
    std::map<std::pair<TextureSlot, Meaning>, std::unique_ptr<SurfacePicture>> pictures_;
};

} // namespace tractus::render
