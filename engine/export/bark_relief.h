#pragma once

#include "engine/export/texture.h"
#include "engine/plant/material.h"

namespace tractus::exports {

// Bark's relief as the renderer shows it, baked into pictures that tile: once around the branch
// along u, and as far along the axis along v. Made when they are first asked for; always the same.

// How light the bark is: multiplies its colour.
GreyPicture bark_color_picture();

// Normals (glTF 2.0 section 3.9.3: green points against v).
TextureSlot bark_normals();

// Occlusion: red holds how much of the sky the furrows hide, green the roughness as it is, and blue
// no metal.
TextureSlot bark_occlusion();

} // namespace tractus::exports
