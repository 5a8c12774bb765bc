#pragma once

#include "app/window/controls.h"
#include "app/window/gizmo_picture.h"

#include <cstddef>
#include <imgui.h>
#include <optional>

namespace tractus::window {

// Shows a gizmo (a small drawing with handles; app/tools/gizmo.h) in a corner of the viewport: that
// of the current tool, or of an object that was drawn with the tool. Handles are dragged by pen or
// mouse. While a handle is dragged, the change is only previewed; it takes effect when the handle
// is released.
class GizmoPanel {
public:
    explicit GizmoPanel(float scale)
        : scale_(scale)
    {
    }

    // Shows the gizmo in a corner of `pad`, if the tool has one and there is room. The corner is
    // the upper right one, or the upper left one for left-handed use. Returns the gizmo's
    // rectangle, or nullopt if it is not shown.
    std::optional<WindowPart> show(view::WindowModel& model, Workspace& workspace,
                                   Controls const& controls, WindowPart const& pad);

private:
    void show_gizmo_message(tools::Gizmo const& gizmo) const;
    void show_gizmo(view::WindowModel& model, Workspace& workspace, tools::Gizmo const& gizmo,
                    GizmoSquare const& square);
    void take_hand(view::WindowModel& model, Workspace& workspace,
                   tools::Gizmo::Handle const& handle, GizmoSquare const& square);
    void press(view::WindowModel& model, Workspace& workspace,
               tools::Gizmo::Handle const& handle) const;
    void move(view::WindowModel& model, Workspace& workspace, tools::Gizmo::Handle const& handle,
              Vec2 const& to);
    void let_go(view::WindowModel& model, Workspace& workspace, tools::Gizmo::Handle const& handle);
    void draw_labels(tools::Gizmo const& gizmo, GizmoSquare const& square) const;
    void draw_handle(tools::Gizmo::Handle const& handle, GizmoSquare const& square) const;

    float scale_ = 1;
    std::optional<std::size_t> held_ {};  // Id of the handle that is being dragged.
    std::optional<std::size_t> shown_ {}; // Id of the handle that was last dragged or pointed at.
    // Vector from the point where the handle was grabbed to its centre.
    ImVec2 grab_offset_px_ { 0, 0 };
    std::optional<Vec2> moved_to_ {}; // New position of the dragged handle, if it has moved.
};

} // namespace tractus::window
