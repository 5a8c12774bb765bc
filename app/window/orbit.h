#pragma once

#include "app/render/camera.h"
#include "app/window/workspace.h"

namespace tractus::window {

// Direction, zoom and offset from which the plant is viewed. They change by dragging and the wheel
// over ImGui's last item, and by the buttons of the view tool.
class Orbit {
public:
    // Changes the view by dragging and the wheel. A drag does what `drag` says; with Shift it
    // always moves the view. `height_px` is the height of ImGui's last item. Returns true if the
    // view changed.
    bool take_input(float scale, float height_px, ViewDrag drag);

    void zoom(double factor); // Changes the zoom; factors above 1 zoom in.
    void look_at_whole();     // Resets the offset and the zoom, but keeps the direction.

    // Returns the camera that views this box.
    render::Camera camera(Bounds const& box, double aspect) const;

private:
    render::ViewAngles angles_ { .azimuth_rad = 0.45, .elevation_rad = 0.22 };
    double zoom_ = 1;
    // Offset of the picture to the right and upwards, as a multiple of the picture's height at zoom
    // 1.
    Vec2 moved_ = Vec2::Zero();
};

} // namespace tractus::window
