#pragma once

#include "app/window/workbench.h"

namespace tractus {

class PlantView;
class Renderer;

// A part of the window, in pixels.
struct WindowPart {
    float left = 0;
    float top = 0;
    float width = 0;
    float height = 0;
};

// The bar at the window's lower edge, large enough for a pen: what is going on, the tools, what the
// one in hand may mean, undo, views, and the menu.
class Controls {
public:
    explicit Controls(float scale)
        : scale_(scale)
    {
    }

    float height_px(WindowState const& state) const;

    // Shows the bar from `left_px` to `right_px`; returns where it is.
    WindowPart show(WindowModel& model, Workbench& bench, float left_px, float right_px);

    bool button(char const* text, float width, bool is_on = false) const;

private:
    void show_status(WindowState const& state) const;
    static void show_recording(RecordingView const& recording);
    void show_meanings(WindowModel& model, Workbench& bench) const;
    void show_view_meanings(Workbench& bench) const;
    void show_tools(WindowModel& model, Workbench& bench) const;
    void show_undo(WindowModel& model) const;
    void show_playing(WindowModel& model) const;
    void show_speed(WindowModel& model) const;
    void show_views(Workbench& bench) const;

    float scale_ = 1;
};

} // namespace tractus
