#pragma once

#include "app/render/curve.h"
#include "app/render/stage.h"
#include "app/view/window_model.h"

#include <vector>

// The curves that the views draw, computed without a window.
namespace tractus::window {

// The drawing pad's picture in parts that change separately, so that only changed ones are rebuilt:
// the faint skeleton; the branches that the current stroke would move; finished strokes and the
// layers' lines; and what follows the hand: a grid at the surface, the volume below it, the stroke,
// the pen's tip and its drop line.
//
// For a tool that draws on paper the drawing volume is shown turned: the vertical sheet lies in the
// surface, seen from its front.
std::vector<render::Curve> pad_skeleton_curves(view::WindowState const& state);
std::vector<render::Curve> pad_preview_curves(view::WindowState const& state);
std::vector<render::Curve> pad_stroke_curves(view::WindowState const& state);
std::vector<render::Curve> pad_live_curves(view::WindowState const& state);

bool draws_on_paper(view::WindowState const& state);

// Transform from the world frame to the pad's.
Eigen::Affine3f pad_of_world(view::WindowState const& state);

// Lines fade with depth below the surface, halfway to the background at the volume's floor.
render::Stage::Fade pad_fade(view::WindowState const& state);

// The skeleton coloured by its states, the layers' lines, and a ring on the ground.
std::vector<render::Curve> skeleton_curves(view::WindowState const& state);

// The spacing of grid lines: 1, 2 or 5 times a power of ten, about a twelfth of the extent.
float grid_step_mm(float extent_mm);

// The states for which the skeleton view's legend needs an entry.
struct SkeletonStates {
    bool selected = false;
    bool undetermined = false;
    bool assigned = false;
    bool next = false;
    std::vector<tools::Layer const*> layers {}; // Layers that have lines.
};
SkeletonStates skeleton_states(view::WindowState const& state);

Vec3f layer_color(tools::LayerStyle const& style);

// The branches that the current stroke would move, for the skeleton's view.
std::vector<render::Curve> preview_curves(view::WindowState const& state);

// Lines for the parts of the grown plant below the ground, for the plant's view, in the plant's
// frame.
std::vector<render::Curve> underground_curves(view::WindowState const& state);

// The branches that the current stroke would move, at their thickness, for the plant's view.
std::vector<render::Curve> growing_curves(view::WindowState const& state);

} // namespace tractus::window
