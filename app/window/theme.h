#pragma once

#include "app/window/palette.h"

#include <imgui.h>

// How the window looks.
namespace tractus::window::theme {

constexpr float kTextSize_px = 22; // Readable at arm's length on a 24-inch screen.
constexpr float kTitleSize_px = 26;
constexpr float kButtonHeight_px = 56; // A pen hits it without looking.

inline ImVec4 imgui_color(Vec3f const& color, float alpha = 1)
{
    return { color.x(), color.y(), color.z(), alpha };
}

inline ImU32 packed(Vec3f const& color, float alpha = 1)
{
    return ImGui::ColorConvertFloat4ToU32(imgui_color(color, alpha));
}

// For a bright room or a dark one: the palette and ImGui's colours.
void set_light(bool is_light);

// Makes items that are no buttons, such as sliders, as high as those, until ImGui::PopStyleVar().
void push_button_frame(float scale);

// Lets a drag over the current window's bare parts scroll it: a pen has no wheel.
void scroll_by_dragging();

// Sets colours, distances and the typeface of the current ImGui context, times `scale` (the
// display's). Returns the larger typeface for titles.
ImFont* apply(float scale);

} // namespace tractus::window::theme
