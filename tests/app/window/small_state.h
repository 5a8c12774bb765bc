#pragma once

#include "app/methods/indicators/indicator_layer.h"
#include "app/view/window_model.h"
#include "tests/app/render/small_mesh.h"

namespace tractus::window {

// Returns the state of a window. The drawing volume is 200 x 150 x 300 mm, with its surface half
// way up. There is a stroke that rises through the surface, a pen on the surface, and the skeleton
// of a trunk and two branches in two states.
inline view::WindowState small_state()
{
    view::WindowState state;
    state.volume_mm.add(Vec3(-100, -75, 0));
    state.volume_mm.add(Vec3(100, 75, 300));
    state.surface_height_mm = 150;
    state.pen = { .in_range = true, .touching = true, .tip_mm = { 40, 30, 150 } };
    state.strokes
        = { { .points
              = { { { -60, -40, 20 }, 6 }, { { -60, 0, 150 }, 6 }, { { -60, 40, 280 }, 6 } } } };
    state.live_ink = { { .points = { { { 0, 30, 150 }, 5 }, { { 40, 30, 150 }, 5 } } } };
    state.skeleton = {
        { .points_mm = { { 0, 0, 0 }, { 0, 0, 200 }, { 0, 0, 400 } }, .width_mm = 30 },
        { .points_mm = { { 0, 0, 200 }, { -200, 0, 400 } },
          .width_mm = 15,
          .state = tools::SkeletonLine::State::Selected },
        { .points_mm = { { 0, 0, 200 }, { 200, 0, 400 } },
          .width_mm = 15,
          .state = tools::SkeletonLine::State::Assigned },
    };
    for (auto const& line : state.skeleton)
        for (auto const& point : line.points_mm)
            state.skeleton_box_mm.add(point.cast<double>());
    state.layers = { { &indicators::kIndicatorLayer, { { { -60, 0, 24 }, { -24, 0, 48 } } } } };
    state.T_world_plant.linear() *= 0.4f;
    state.export_endings = { ".glb", ".obj", ".usda", ".ply", ".stl", ".mtg" };
    state.tool = "Draw";
    state.status = "Drawing stroke 1 of 3";
    state.progress = 0.4;
    return state;
}

} // namespace tractus::window
