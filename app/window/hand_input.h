#pragma once

#include <filesystem>
#include <imgui.h>
#include <string>
#include <vector>

namespace tractus::window {

// The window system's mouse at one moment.
struct MouseMoment {
    ImVec2 place_px { 0, 0 };
    bool is_down = false; // Its left button.
};

struct KeyPress {
    static constexpr char kEscape = '\x1b';
    static constexpr char kEnter = '\r';
    static constexpr char kBackspace = '\b'; // Repeats as long as it is held.
    static constexpr char kLeft = '\x11';    // Arrows.
    static constexpr char kRight = '\x12';
    static constexpr char kUp = '\x13';
    static constexpr char kDown = '\x14';

    char key = 0; // The letter that the key bears, as a capital; what is typed by it, '?'; or one
                  // of the above.
    bool has_control = false;
    bool has_shift = false;
};

// What the window system's mouse and keyboard did since the last frame, in its order: more than
// ImGui tells, which knows where they are at each frame. However long a frame takes, nothing that
// was done in it is lost.
struct HandInput {
    std::vector<MouseMoment> mouse;
    std::vector<KeyPress> presses;
    std::string held; // The letters of keys that were down at any time, without Ctrl.
    std::vector<std::filesystem::path> dropped {}; // Files that were dropped on the window.

    bool holds(char letter) const { return held.find(letter) != std::string::npos; }
};

} // namespace tractus::window
