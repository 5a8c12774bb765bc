#pragma once

#include "app/render/curve.h"
#include "app/render/stage.h"
#include "app/view/window_model.h"

#include <vector>

// What the views draw, as curves. Values in, values out: no window needed.
namespace tractus::window {

// The drawing pad's picture, in parts by what they change with, so that what did not change is not
// made again: the skeleton, faintly; the branches that the ink would move; finished strokes and the
// layers' lines; and what follows the hand at once: a grid at the surface, the volume below it, the
// ink, the pen's tip and its drop line.
//
// A tool that draws on paper has the drawing volume turned: the sheet that stands in it lies on the
// surface, seen from its front.
std::vector<render::Curve> pad_skeleton_curves(view::WindowState const& state);
std::vector<render::Curve> pad_preview_curves(view::WindowState const& state);
std::vector<render::Curve> pad_stroke_curves(view::WindowState const& state);
std::vector<render::Curve> pad_live_curves(view::WindowState const& state);

bool draws_on_paper(view::WindowState const& state);

// From the world to where the pad shows it.
Eigen::Affine3f pad_of_world(view::WindowState const& state);

// Ink grows paler with the depth below the surface: half way to the background at the floor.
render::Stage::Fade pad_fade(view::WindowState const& state);

// The skeleton with its states, the layers' lines, and a ring on the ground.
std::vector<render::Curve> skeleton_curves(view::WindowState const& state);

// Which of its colours the skeleton has.
struct SkeletonStates {
    bool selected = false;
    bool undetermined = false;
    bool assigned = false;
    bool next = false;
    std::vector<tools::Layer const*> layers {}; // That have lines.
};
SkeletonStates skeleton_states(view::WindowState const& state);

Vec3f layer_color(tools::LayerStyle const& style);

// The branches that the ink would move, as the skeleton shows them.
std::vector<render::Curve> preview_curves(view::WindowState const& state);

// The branches that the ink would move, as thick as they are, for the plant's view.
std::vector<render::Curve> growing_curves(view::WindowState const& state);

} // namespace tractus::window
