#pragma once

#include "app/render/camera.h"
#include "app/window/workspace.h"

namespace tractus::window {

// The direction, zoom and offset from which the plant is viewed: changed by dragging and by the
// wheel over ImGui's last item, and by the buttons of the view tool.
class Orbit {
public:
    // Applies dragging, which does `drag` or with Shift always moves, and the wheel. `height_px` is
    // the item's height. Returns true if the view changed.
    bool take_input(float scale, float height_px, ViewDrag drag);

    void zoom(double factor); // Changes the zoom; factors above 1 zoom in.
    void look_at_whole();     // Resets offset and zoom, but not the direction.

    // The camera for a view of this box.
    render::Camera camera(Bounds const& box, double aspect) const;

private:
    render::ViewAngles angles_ { .azimuth_rad = 0.45, .elevation_rad = 0.22 };
    double zoom_ = 1;
    Vec2 moved_ = Vec2::Zero(); // Offset of the picture to the right and up, in picture heights at
                                // zoom 1.
};

} // namespace tractus::window
