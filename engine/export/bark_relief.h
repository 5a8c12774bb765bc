#pragma once

#include "engine/export/texture.h"
#include "engine/plant/material.h"

namespace tractus::exports {

// The bark relief of the renderer, baked into tileable pictures. u runs once around the branch, v
// over the same distance along the axis. The relief is computed on first use and is always the
// same.

// Returns the lightness of the bark, by which the colour of its material is multiplied.
GreyPicture bark_color_picture();

// Returns the bark's normal map (glTF 2.0 section 3.9.3: green points towards -v).
TextureSlot bark_normals();

// Returns the bark's occlusion map. Red is the visible share of the sky, reduced in the furrows;
// green leaves the material's roughness unchanged; blue means no metalness.
TextureSlot bark_occlusion();

} // namespace tractus::exports
