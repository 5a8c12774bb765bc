#pragma once

#include "app/window/calibration_panel.h"
#include "app/window/views.h"

namespace tractus {

// The window's contents: three views side by side and a bar of large controls below them. Draws one
// ImGui frame at a time; what a person asks for goes to the model at once.
class Layout {
public:
    // `title_font` is theme::apply()'s; `scale` the display's.
    Layout(ImFont* title_font, float scale)
        : title_font_(title_font)
        , scale_(scale)
        , calibration_(title_font, scale)
    {
    }

    void show(WindowModel& model, Renderer& renderer);

private:
    void show_pad(WindowState const& state, Renderer& renderer, ImVec2 const& size_px);
    void show_skeleton(WindowState const& state, Renderer& renderer, ImVec2 const& size_px);
    void show_plant(WindowState const& state, Renderer& renderer, ImVec2 const& size_px);
    void show_controls(WindowModel& model, Renderer& renderer);
    void show_playing_buttons(WindowModel& model) const;
    void show_tool_buttons(WindowModel& model) const;
    void show_undo_buttons(WindowModel& model) const; // And Ctrl+Z, Ctrl+Shift+Z.
    void show_speed(WindowModel& model) const;
    bool button(char const* text, float width) const;
    void show_title(char const* title, char const* detail) const;

    ImFont* title_font_ = nullptr;
    float scale_ = 1;
    CalibrationPanel calibration_;
    PadView pad_;
    SkeletonView skeleton_;
    PlantView plant_;
};

} // namespace tractus
