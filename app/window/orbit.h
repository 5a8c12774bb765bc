#pragma once

#include "app/render/camera.h"
#include "app/window/workbench.h"

namespace tractus::window {

// Where a person looks at the plant from: changed by dragging and the wheel over the last drawn
// item, and by what the view tool's buttons wish for.
class Orbit {
public:
    // True if the person has changed it by a drag, which means `drag` without Shift, or the wheel.
    // The item is `height_px` high.
    bool take_input(float scale, float height_px, ViewDrag drag);

    void zoom(double factor); // Above 1: nearer.
    void look_at_whole();     // Neither moved nor zoomed; from the same side.

    // A view of the box from there.
    render::Camera camera(Bounds const& box, double aspect) const;

private:
    render::ViewAngles angles_ { .azimuth_rad = 0.45, .elevation_rad = 0.22 };
    double zoom_ = 1;
    Vec2 moved_ = Vec2::Zero(); // The picture, right and up, in heights of it at zoom 1.
};

} // namespace tractus::window
