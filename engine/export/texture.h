#pragma once

#include "engine/export/bark_pictures.h"
#include "engine/mesh/mesh.h"
#include "engine/plant/material.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tractus::exports {

// A grey picture; levels from 0 (black) to 255 (white), row by row from the top. A material's
// colour is multiplied by them, so that one picture serves every species.
struct GreyPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels; // Size width * height.
};

// Returns a picture of bark with furrows along the axis. v increases from row to row, along the
// axis; u from column to column, around the branch. Tileable in both directions.
GreyPicture bark_picture();

// Returns a picture of a leaf with a midrib at u = 0.5 and lateral veins that run towards the tip.
// The first row is at the leaf's base, the last at its tip, as for blades in engine/mesh/mesh.h.
GreyPicture leaf_picture();

// Returns the textures of a material: its own pictures, and those of its kind and bark where it has
// none. `bark_px`: width and height of pictures made for a kind of bark (bark_pictures()).
MaterialTextures textures_of(Material const& material, int bark_px = kBarkPicture_px);

// Makes the pictures of the bark of a mesh's materials, so that textures_of() finds them later.
void prepare_bark(mesh::Mesh const& mesh);

// Returns the linear colour by which the colour picture of textures_of() is multiplied: white if
// the picture replaces the material's colour. For a default picture it is lighter than the
// material's own colour, so that the mean lightness is that of the material; no component exceeds
// 1.
Vec3 multiplied_color(Material const& material, int bark_px = kBarkPicture_px);

// True if the textures from textures_of() include a normal map.
bool has_relief(Material const& material);

// Returns the file of a material's colour picture: its own picture as it is, or the default picture
// of its kind, multiplied by the material's colour, as a PNG file. Empty if it has neither.
std::string colored_picture(Material const& material);

// Returns the picture as a PNG file (ISO/IEC 15948), 8-bit greyscale. The same picture always gives
// the same bytes.
std::string png_bytes(GreyPicture const& picture);

} // namespace tractus::exports
