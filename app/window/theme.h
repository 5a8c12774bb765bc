#pragma once

#include "app/window/palette.h"

#include <imgui.h>

// The window's look: sizes, colours and typefaces.
namespace tractus::window::theme {

constexpr float kTextSize_px = 22; // Text size, readable at arm's length on a 24-inch screen.
constexpr float kTitleSize_px = 26;
// Height of a button, large enough to hit with the pen without aiming.
constexpr float kButtonHeight_px = 56;

inline ImVec4 imgui_color(Vec3f const& color, float alpha = 1)
{
    return { color.x(), color.y(), color.z(), alpha };
}

inline ImU32 packed(Vec3f const& color, float alpha = 1)
{
    return ImGui::ColorConvertFloat4ToU32(imgui_color(color, alpha));
}

// Sets the palette and ImGui's colours for a bright or a dark room.
void set_light(bool is_light);

// Makes items such as sliders as high as buttons, until ImGui::PopStyleVar().
void push_button_frame(float scale);

// Scrolls the current window when its empty parts are dragged, because a pen has no wheel.
void scroll_by_dragging();

// Sets colours, spacing and the typeface of the current ImGui context, scaled by `scale` (the
// display's). Returns the larger typeface for titles.
ImFont* apply(float scale);

} // namespace tractus::window::theme
