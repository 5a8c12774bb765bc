#pragma once

#include "app/window/button_rows.h"
#include "app/window/workbench.h"

#include <functional>
#include <string>
#include <vector>

namespace tractus::render {
class Renderer;
}

namespace tractus::window {

class PlantView;

// A part of the window, in pixels.
struct WindowPart {
    float left = 0;
    float top = 0;
    float width = 0;
    float height = 0;
};

// A button of the bar.
struct BarButton {
    std::string text {};
    float width = 0; // At a display's scale of 1.
    bool is_on = false;
    bool begins_group = false; // The first of some that stay beside each other, if they can.
    std::function<void()> press;
};

// The bar at the window's lower edge, large enough for a pen: what is going on, the tools, what the
// one in hand may mean, undo, views, and the menu.
class Controls {
public:
    explicit Controls(float scale)
        : scale_(scale)
        , height_px_(kFirstHeight_px * scale)
    {
    }

    // As it was shown last: it has as many rows as its buttons need.
    float height_px() const { return height_px_; }

    // Shows the bar from `left_px` to `right_px`; returns where it is.
    WindowPart show(view::WindowModel& model, Workbench& bench, float left_px, float right_px);

    bool button(char const* text, float width, bool is_on = false) const;

private:
    static constexpr float kFirstHeight_px = 180; // As two rows need.

    void show_status(view::WindowState const& state) const;
    static void show_recording(view::RecordingView const& recording);
    void show_meanings(std::vector<BarButton> const& buttons, float main_height_px) const;
    float height_of(std::vector<BarButton> const& buttons) const;
    ButtonGaps gaps() const;
    std::vector<ButtonWidth> widths_of(std::vector<BarButton> const& buttons) const;
    std::vector<ButtonRow> rows_of(std::vector<BarButton> const& buttons) const;
    void show_rows(std::vector<BarButton> const& buttons) const;
    float least_width_px(BarButton const& button) const;
    void show_speed(view::WindowModel& model) const;
    static std::vector<BarButton> tool_meanings(view::WindowModel& model, Workbench& bench);
    static std::vector<BarButton> view_meanings(Workbench& bench);
    // A button for each view, or where they take too many rows one that goes to the next.
    enum class Views { Each, Next };
    static std::vector<BarButton> main_buttons(view::WindowModel& model, Workbench& bench,
                                               Views views);
    static std::vector<BarButton> tool_buttons(view::WindowModel& model, Workbench& bench);
    static std::vector<BarButton> play_buttons(view::WindowModel& model);

    float scale_ = 1;
    float height_px_ = kFirstHeight_px;
};

} // namespace tractus::window
