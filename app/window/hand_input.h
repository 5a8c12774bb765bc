#pragma once

#include <filesystem>
#include <imgui.h>
#include <string>
#include <vector>

namespace tractus::window {

// State of the mouse at a certain moment.
struct MouseMoment {
    ImVec2 place_px { 0, 0 };
    bool is_down = false; // True if the left button is pressed.
};

struct KeyPress {
    static constexpr char kEscape = '\x1b';
    static constexpr char kEnter = '\r';
    static constexpr char kBackspace = '\b'; // Backspace key; repeated while it is held.
    // Code of the left arrow key. The codes of the other arrow keys follow.
    static constexpr char kLeft = '\x11';
    static constexpr char kRight = '\x12';
    static constexpr char kUp = '\x13';
    static constexpr char kDown = '\x14';

    // Letter of the key in upper case; '?' if this character was typed, on whichever key; or one of
    // the constants above.
    char key = 0;
    bool has_control = false;
    bool has_shift = false;
};

// Events of mouse and keyboard since the last frame, in order. ImGui only knows their state at each
// frame; here no event is lost, however long a frame takes.
struct HandInput {
    std::vector<MouseMoment> mouse;
    std::vector<KeyPress> presses;
    // Letters of the keys that were held at any time since the last frame, without those held with
    // Ctrl.
    std::string held;
    // Paths of files that were dropped on the window.
    std::vector<std::filesystem::path> dropped {};

    bool holds(char letter) const { return held.find(letter) != std::string::npos; }
};

} // namespace tractus::window
