#pragma once

#include <filesystem>
#include <imgui.h>
#include <string>
#include <vector>

namespace tractus::window {

// State of the mouse at one moment.
struct MouseMoment {
    ImVec2 place_px { 0, 0 };
    bool is_down = false; // State of the left button.
};

struct KeyPress {
    static constexpr char kEscape = '\x1b';
    static constexpr char kEnter = '\r';
    static constexpr char kBackspace = '\b'; // Backspace; repeated while the key is held.
    // Code of the left arrow key; the other arrow keys follow.
    static constexpr char kLeft = '\x11';
    static constexpr char kRight = '\x12';
    static constexpr char kUp = '\x13';
    static constexpr char kDown = '\x14';

    char key = 0; // The key's letter in upper case; '?' if that character was typed, by whichever
                  // key; or one of the constants above.
    bool has_control = false;
    bool has_shift = false;
};

// Mouse and keyboard events since the last frame, in order. ImGui knows only the state at each
// frame; here no event is lost, however long a frame takes.
struct HandInput {
    std::vector<MouseMoment> mouse;
    std::vector<KeyPress> presses;
    std::string held; // Letters of keys that were down at any time since the last frame, without
                      // Ctrl.
    std::vector<std::filesystem::path> dropped {}; // Files dropped on the window.

    bool holds(char letter) const { return held.find(letter) != std::string::npos; }
};

} // namespace tractus::window
