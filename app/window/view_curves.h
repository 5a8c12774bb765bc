#pragma once

#include "app/render/curve.h"
#include "app/render/stage.h"
#include "app/view/window_model.h"

#include <vector>

// Curves that the window's views draw. They are computed without a window.
namespace tractus::window {

// The curves of the drawing pad, in parts that change separately, so that only changed parts are
// made again: the faint skeleton; the branches that the current stroke would move; finished strokes
// and the lines of layers; and curves that follow the pen: a grid at the surface, the volume below
// the surface, the stroke in progress, the pen's tip and its drop line.
//
// For a tool that draws on paper, and for a plant that was drawn on paper by a tool that also draws
// in space, the drawing volume is shown turned: the vertical sheet of paper lies in the surface and
// is seen from its front.
std::vector<render::Curve> pad_skeleton_curves(view::WindowState const& state);
std::vector<render::Curve> pad_preview_curves(view::WindowState const& state);
std::vector<render::Curve> pad_stroke_curves(view::WindowState const& state);
std::vector<render::Curve> pad_live_curves(view::WindowState const& state);

bool draws_on_paper(view::WindowState const& state);

// Returns the transform from the world frame to the pad's frame.
Eigen::Affine3f pad_of_world(view::WindowState const& state);

// Returns how lines fade with depth below the surface. At the floor of the drawing volume they have
// faded halfway to the background.
render::Stage::Fade pad_fade(view::WindowState const& state);

// Returns the skeleton, coloured by the states of its branches, the lines of layers, and a ring on
// the ground.
std::vector<render::Curve> skeleton_curves(view::WindowState const& state);

// Returns the distance of grid lines for this extent: 1, 2 or 5 times a power of ten, about a
// twelfth of the extent.
float grid_step_mm(float extent_mm);

// States of branches for which the legend of the skeleton's view needs an entry.
struct SkeletonStates {
    bool selected = false;
    bool undetermined = false;
    bool assigned = false;
    bool next = false;
    std::vector<tools::Layer const*> layers {}; // Layers that have at least one line.
};
SkeletonStates skeleton_states(view::WindowState const& state);

Vec3f layer_color(tools::LayerStyle const& style);

// Returns the branches that the current stroke would move, for the skeleton's view.
std::vector<render::Curve> preview_curves(view::WindowState const& state);

// Returns lines along those parts of the grown plant that are below the ground, for the plant's
// view. Plant frame.
std::vector<render::Curve> underground_curves(view::WindowState const& state);

// Returns the branches that the current stroke would move, as thick as they are, for the plant's
// view.
std::vector<render::Curve> growing_curves(view::WindowState const& state);

} // namespace tractus::window
