#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/bark.h"
#include "engine/plant/material.h"

namespace tractus::exports {

// Pictures of a kind of bark. All are square and tileable: u runs once around the branch, v over
// the same distance along its axis.
struct BarkPictures {
    TextureSlot color {};   // sRGB.
    TextureSlot normals {}; // Green points towards -v.
    // Red: visible share of the sky; green: roughness; blue: 0, as bark is not metallic.
    TextureSlot occlusion_roughness {};
    Vec3 mean_color = Vec3::Ones(); // Of the colour picture; linear, 0 to 1.
};

constexpr int kBarkPicture_px = 512;
constexpr int kMaxBarkPicture_px = 2048;

// Returns the pictures of a bark. `side_px`: their width and height, 16 to kMaxBarkPicture_px. The
// pictures are computed on first use, always with the same bytes, and kept until the program ends.
// Not for BarkKind::Furrowed, whose pictures are those of bark_relief.h. Thread-safe.
BarkPictures const& bark_pictures(Bark const& bark, int side_px = kBarkPicture_px);

} // namespace tractus::exports
