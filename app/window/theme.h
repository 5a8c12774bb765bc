#pragma once

#include "app/window/palette.h"

#include <imgui.h>

// Appearance of the window: sizes, colours and fonts.
namespace tractus::window::theme {

constexpr float kTextSize_px = 22; // Size of text, readable at arm's length on a 24-inch screen.
constexpr float kTitleSize_px = 26;
// Height of a button, large enough to be hit with the pen without aiming.
constexpr float kButtonHeight_px = 56;

inline ImVec4 imgui_color(Vec3f const& color, float alpha = 1)
{
    return { color.x(), color.y(), color.z(), alpha };
}

inline ImU32 packed(Vec3f const& color, float alpha = 1)
{
    return ImGui::ColorConvertFloat4ToU32(imgui_color(color, alpha));
}

// Sets the palette, and the colours of ImGui, for a bright or a dark room.
void set_light(bool is_light);

// Makes items such as sliders as high as buttons. Call ImGui::PopStyleVar() to end this.
void push_button_frame(float scale);

// Scrolls the current window when the user drags an empty part of it, because a pen has no wheel.
void scroll_by_dragging();

// Sets the colours, spacing and font of the current ImGui context. `scale` is the display's scale
// factor. Returns the larger font for titles.
ImFont* apply(float scale);

} // namespace tractus::window::theme
