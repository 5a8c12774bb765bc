#pragma once

#include "app/window/button_rows.h"
#include "app/window/workspace.h"

#include <functional>
#include <string>
#include <vector>

namespace tractus::render {
class Renderer;
}

namespace tractus::window {

class PlantView;

// A rectangle in the window, in pixels.
struct WindowPart {
    float left = 0;
    float top = 0;
    float width = 0;
    float height = 0;
};

// A button of the bar.
struct BarButton {
    std::string text {};
    float width = 0; // Width of the button in pixels, at a display scale of 1.
    bool is_on = false;
    // True for the first button of a group. A group should stay in one row.
    bool begins_group = false;
    std::function<void()> press;
};

// The bar at the lower edge of the window, with buttons large enough for a pen: status, tools, the
// current tool's variants, undo, views, and the menu.
class Controls {
public:
    explicit Controls(float scale)
        : scale_(scale)
        , height_px_(kFirstHeight_px * scale)
    {
    }

    // Returns the bar's height in the last frame. It depends on the number of rows that the buttons
    // need.
    float height_px() const { return height_px_; }

    // Shows the bar between `left_px` and `right_px`, and returns its rectangle.
    WindowPart show(view::WindowModel& model, Workspace& workspace, float left_px, float right_px);

    bool button(char const* text, float width, bool is_on = false) const;

private:
    // Height assumed before the first frame: that of two rows.
    static constexpr float kFirstHeight_px = 180;

    void show_status(view::WindowState const& state) const;
    static void show_recording(view::RecordingView const& recording);
    void show_meanings(std::vector<BarButton> const& buttons, float main_height_px) const;
    float height_of(std::vector<BarButton> const& buttons) const;
    ButtonGaps gaps() const;
    std::vector<ButtonWidth> widths_of(std::vector<BarButton> const& buttons) const;
    std::vector<ButtonRow> rows_of(std::vector<BarButton> const& buttons) const;
    void show_rows(std::vector<BarButton> const& buttons) const;
    float min_width_px(BarButton const& button) const;
    void show_speed(view::WindowModel& model) const;
    static std::vector<BarButton> tool_meanings(view::WindowModel& model, Workspace& workspace);
    static std::vector<BarButton> view_meanings(Workspace& workspace);
    // Buttons for the views. Each: one button per view. Next: a single button that switches to the
    // next view, if one per view would need too many rows.
    enum class Views { Each, Next };
    static std::vector<BarButton> main_buttons(view::WindowModel& model, Workspace& workspace,
                                               Views views);
    static std::vector<BarButton> tool_buttons(view::WindowModel& model, Workspace& workspace);
    static std::vector<BarButton> play_buttons(view::WindowModel& model);

    float scale_ = 1;
    float height_px_ = kFirstHeight_px;
};

} // namespace tractus::window
