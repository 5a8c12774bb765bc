#pragma once

#include "engine/plant/material.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tractus::exports {

// Grey levels from 0 (black) to 255 (white), row by row from the top. They are multiplied with a
// material's colour, so that one picture serves every species.
struct GreyPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels; // Size width * height.
};

// Bark with furrows along the axis: rows along v, columns along u around the branch; tileable in
// both directions.
GreyPicture bark_picture();

// A leaf with a midrib at u = 0.5 and lateral veins that run towards the tip; the first row is the
// base, the last the tip, as for blades in engine/mesh/mesh.h.
GreyPicture leaf_picture();

// Returns the textures to export for a material: its own pictures, and the default ones of its kind
// for those it lacks.
MaterialTextures textures_of(Material const& material);

// Returns the linear colour with which the colour picture of textures_of() is multiplied: white if
// the picture replaces the material's colour. For a default picture it is lighter than the
// material's own colour, up to white, so that the mean lightness is the same as without a picture.
Vec3 multiplied_color(Material const& material);

// True if textures_of() the material include a normal map.
bool has_relief(Material const& material);

// Returns a PNG file of the material's colour picture, multiplied with its colour; empty if the
// material has no colour picture.
std::string colored_picture(Material const& material);

// Returns the picture as a PNG file (ISO/IEC 15948), 8-bit greyscale. Deterministic.
std::string png_bytes(GreyPicture const& picture);

} // namespace tractus::exports
