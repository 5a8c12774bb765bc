#include "app/window/imgui_mouse.h"

namespace tractus::window {

#if IMGUI_VERSION_NUM >= 18700 // Debian 13 has such a version of ImGui; Debian 12 has an older one.

void put_imgui_mouse(ImVec2 const& place_px, bool is_down)
{
    auto& io = ImGui::GetIO();
    io.ClearEventsQueue(); // Drops the events of the window system's mouse.
    io.AddMousePosEvent(place_px.x, place_px.y);
    io.AddMouseButtonEvent(ImGuiMouseButton_Left, is_down);
}

void show_imgui_press(MouseMoment const&)
{
    // Nothing to do here: newer versions of ImGui queue presses themselves.
}

#else

void put_imgui_mouse(ImVec2 const& place_px, bool is_down)
{
    auto& io = ImGui::GetIO();
    io.MousePos = place_px;
    for (auto& down : io.MouseDown)
        down = false;
    io.MouseDown[ImGuiMouseButton_Left] = is_down;
    io.MouseWheel = 0;
}

void show_imgui_press(MouseMoment const& change)
{
    auto& io = ImGui::GetIO();
    io.MousePos = change.place_px;
    io.MouseDown[ImGuiMouseButton_Left] = change.is_down;
}

#endif

} // namespace tractus::window
