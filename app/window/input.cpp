#include "app/window/input.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace tractus::input {

#if IMGUI_VERSION_NUM >= 18700

namespace {

ImGuiKey key_of(char letter)
{
    return static_cast<ImGuiKey>(ImGuiKey_A + (letter - 'A'));
}

} // namespace

void put_mouse(ImVec2 const& place_px, bool is_down)
{
    auto& io = ImGui::GetIO();
    io.ClearEventsQueue(); // What the window system's mouse did.
    io.AddMousePosEvent(place_px.x, place_px.y);
    io.AddMouseButtonEvent(ImGuiMouseButton_Left, is_down);
}

bool is_pressed(char letter)
{
    return ImGui::IsKeyPressed(key_of(letter), false);
}

bool is_held(char letter)
{
    return ImGui::IsKeyDown(key_of(letter));
}

bool is_escape_pressed()
{
    return ImGui::IsKeyPressed(ImGuiKey_Escape, false);
}

#else

void put_mouse(ImVec2 const& place_px, bool is_down)
{
    auto& io = ImGui::GetIO();
    io.MousePos = place_px;
    for (auto& down : io.MouseDown)
        down = false;
    io.MouseDown[ImGuiMouseButton_Left] = is_down;
    io.MouseWheel = 0;
}

// GLFW's numbers of the letters' keys are the capitals.
bool is_pressed(char letter)
{
    return ImGui::IsKeyPressed(letter, false);
}

bool is_held(char letter)
{
    return ImGui::IsKeyDown(letter);
}

bool is_escape_pressed()
{
    return ImGui::IsKeyPressed(GLFW_KEY_ESCAPE, false);
}

#endif

bool is_question_mark_typed()
{
    for (auto const letter : ImGui::GetIO().InputQueueCharacters)
        if (letter == '?')
            return true;
    return false;
}

} // namespace tractus::input
