#pragma once

#include "engine/export/texture.h"
#include "engine/plant/material.h"

namespace tractus::exports {

// The bark relief of the renderer, baked into tileable pictures: u runs once around the branch, v
// the same distance along the axis. Made on first use; always the same.

// Lightness of the bark, by which its colour is multiplied.
GreyPicture bark_color_picture();

// Normal map (glTF 2.0 section 3.9.3: green points towards -v).
TextureSlot bark_normals();

// Occlusion map: red is the visible share of the sky, reduced in the furrows; green leaves the
// roughness unchanged; blue is zero metalness.
TextureSlot bark_occlusion();

} // namespace tractus::exports
