#include "app/window/imgui_mouse.h"

namespace tractus::window {

// Debian 13 has ImGui of this version or later; Debian 12 has an older one.
#if IMGUI_VERSION_NUM >= 18700

void put_imgui_mouse(ImVec2 const& place_px, bool is_down)
{
    auto& io = ImGui::GetIO();
    io.ClearEventsQueue(); // Removes events of the window system's mouse.
    io.AddMousePosEvent(place_px.x, place_px.y);
    io.AddMouseButtonEvent(ImGuiMouseButton_Left, is_down);
}

void show_imgui_press(MouseMoment const&)
{
    // Does nothing, as this version of ImGui queues presses itself.
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
