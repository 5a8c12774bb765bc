#pragma once

#include "app/render/curve.h"
#include "engine/base/vectors.h"
#include "engine/scene/scene.h"
#include "engine/stroke/nib.h"

#include <cstddef>
#include <vector>

namespace tractus::batch {

// Curves shown with a scene's plant, in the world frame; the same in pictures and in the window.

// Colour of the n-th stroke and of what it shapes: seven colours that colour-blind people can tell
// apart (Okabe and Ito, "Color Universal Design", 2002), then repeated. sRGB, 0 to 1.
Vec3f stroke_color(std::size_t n);

// A stroke whose width follows the pressure and the nib. `width_mm` is the width at full pressure.
render::Curve stroke_curve(std::vector<TipSample> const& tips, Vec3f const& color, float width_mm,
                           Nib nib = Nib::Point);

// The base plant's skeleton in the drawing volume: one curve per axis, and one per association for
// the path that it shapes, in its stroke's colour.
std::vector<render::Curve> skeleton_curves(scene::Scene const& scene);

// The motion indicators as arrows.
std::vector<render::Curve> indicator_curves(scene::Scene const& scene);

// The tablet's area at the given height, with a grid of 20 mm.
std::vector<render::Curve> desk_curves(double height_mm = 0);

} // namespace tractus::batch
