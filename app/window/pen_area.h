#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/plant.h"

#include <imgui.h>

namespace tractus::window {

// Where the window shows the surface's active area, so that marks on the screen correspond to
// places of the pen's tip. The area's proportions are preserved. Its rotation is already part of
// the world frame's x and y.
struct PenArea {
    ImVec2 middle_px { 0, 0 };
    double px_per_mm = 1;
    Vec2 middle_mm = Vec2::Zero(); // Centre of the active area in the world frame.
    Vec2 size_mm = Vec2(254, 159);

    ImVec2 to_px(Vec2 const& place_mm) const;
    Vec2 to_mm(ImVec2 const& place_px) const;
    float left_px() const;
    float right_px() const;
};

// Fits the active area into the middle of a part of the window. `air`, at least 1, is the size of
// this part relative to the active area.
PenArea fit_pen_area(Bounds const& volume_mm, ImVec2 const& corner_px, ImVec2 const& size_px,
                     double air = 1);

} // namespace tractus::window
