#pragma once

#include "engine/plant/material.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tractus::exports {

// Grey levels, 0 black to 255 white, row by row from the top. They multiply a material's colour, so
// that one picture serves every species.
struct GreyPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels; // width * height.
};

// Furrows along the axis: rows go along v, columns around along u; it tiles in both.
GreyPicture bark_picture();

// A midrib at u = 0.5 and veins that leave it towards the tip; base in the first row, tip in the
// last (engine/mesh/mesh.h says so of blades).
GreyPicture leaf_picture();

// Returns the textures that an exporter writes: a material's own pictures, and where it has none,
// the usual ones of its kind.
MaterialTextures textures_of(Material const& material);

// Returns the colour, linear, that the picture of its colour multiplies in textures_of(): white
// where that picture stands for it, and lighter than the material's own where the picture is a
// usual one of its kind, as far as white: then the surface is as light in the mean as without a
// picture.
Vec3 multiplied_color(Material const& material);

// Whether a normal map is among them.
bool has_relief(Material const& material);

// Returns a PNG file with the picture of the material's colour, in that colour; empty if it has
// none.
std::string colored_picture(Material const& material);

// The picture as a PNG file (ISO/IEC 15948), greyscale of 8 bits. Same picture, same bytes.
std::string png_bytes(GreyPicture const& picture);

} // namespace tractus::exports
