#pragma once

#include "app/window/controls.h"
#include "app/window/gizmo_picture.h"

#include <cstddef>
#include <imgui.h>
#include <optional>

namespace tractus::window {

// The gizmo (a small drawing) of the current tool, or of an object drawn with it, in a corner of
// the viewport, with handles to drag by pen or mouse (app/tools/gizmo.h). While a handle is
// dragged, a preview is shown; the object changes when it is released.
class GizmoPanel {
public:
    explicit GizmoPanel(float scale)
        : scale_(scale)
    {
    }

    // Shows the gizmo in the upper right corner of `pad`, if the tool has one and there is room.
    // Returns its rectangle, or nullopt if it is not shown.
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
    std::optional<std::size_t> held_ {};  // Id of the handle being dragged.
    std::optional<std::size_t> shown_ {}; // Id of the handle that was last dragged or hovered over.
    ImVec2 grab_offset_px_ {
        0, 0
    }; // Vector from the point where the handle was grabbed to its centre.
    std::optional<Vec2> moved_to_ {}; // New position of the dragged handle, if it has moved.
};

} // namespace tractus::window
