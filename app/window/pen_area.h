#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/plant.h"

#include <imgui.h>

namespace tractus::window {

// Where on the window the surface's active area is shown, so that the pen's tip and what it points
// at go together: its aspect is kept, and its rotation is already in the world frame's x and y.
struct PenArea {
    ImVec2 middle_px { 0, 0 };
    double px_per_mm = 1;
    Vec2 middle_mm = Vec2::Zero(); // World frame.
    Vec2 size_mm = Vec2(254, 159);

    ImVec2 to_px(Vec2 const& place_mm) const;
    Vec2 to_mm(ImVec2 const& place_px) const;
    float left_px() const;
    float right_px() const;
};

// The area of the volume, as large as it fits into a part of the window, in its middle. `air` is
// how much larger than the area the part is, at least 1.
PenArea fit_pen_area(Bounds const& volume_mm, ImVec2 const& corner_px, ImVec2 const& size_px,
                     double air = 1);

} // namespace tractus::window
