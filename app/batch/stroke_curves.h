#pragma once

#include "app/render/curve.h"
#include "engine/base/vectors.h"
#include "engine/scene/scene.h"
#include "engine/stroke/nib.h"

#include <cstddef>
#include <vector>

namespace tractus::batch {

// Curves that are drawn over a scene's plant, in the world frame, both in pictures and in the
// window.

// Colour of the n-th stroke and of the branches that it shapes, in sRGB from 0 to 1. There are
// seven colours that colour-blind people can tell apart (Okabe and Ito, "Color Universal Design",
// 2002); the eighth stroke has the first colour again.
Vec3f stroke_color(std::size_t n);

// Returns the curve of a stroke. Its width follows the pressure and the nib; `width_mm` is the
// width at full pressure.
render::Curve stroke_curve(std::vector<TipSample> const& tips, Vec3f const& color, float width_mm,
                           Nib nib = Nib::Point);

// Returns the base plant's skeleton in the drawing volume: one curve per axis, and one curve per
// association, in its stroke's colour, for the path of branches that the stroke shapes.
std::vector<render::Curve> skeleton_curves(scene::Scene const& scene);

// Returns the motion indicators as arrows.
std::vector<render::Curve> indicator_curves(scene::Scene const& scene);

// Returns the outline of the tablet's area at the given height, with a grid of 20 mm.
std::vector<render::Curve> desk_curves(double height_mm = 0);

} // namespace tractus::batch
