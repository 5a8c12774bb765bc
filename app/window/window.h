#pragma once

#include "app/view/window_model.h"
#include "engine/base/result.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace tractus::window {

// The user's choices for the window's look.
struct WindowLook {
    bool is_light = false;       // True for colours for a bright room; false for a dark one.
    bool is_left_handed = false; // True for the left-handed layout; see Workspace::is_left_handed.

    bool operator==(WindowLook const&) const = default;
};

struct WindowOptions {
    std::string title = "tractus";
    int width = 1600; // Initial width in pixels; the user may change it.
    int height = 900;

    // Number of frames after which the window closes; each then advances the model's time by 1/60
    // s. 0: stays open, with the model's time by the clock.
    int frames = 0;

    // Display to fill, as find_display() reads it; "": the tablet's own, otherwise the one that the
    // window is on. nullopt: not full screen.
    std::optional<std::string> full_screen {};

    // The view that a drawing begins with, one of shown_words() (workspace.h). Empty: the pad for a
    // pen tablet, otherwise all.
    std::string view {};

    bool is_on_stage = false; // True: the window opens in the stage view (Workspace::is_on_stage).

    WindowLook look {}; // Initial look of the window.
    double scale = 0;   // Scale of text and buttons; 0: the display's scale factor.

    // Called with every look that the user chooses. May be empty.
    std::function<void(WindowLook const&)> keep_look {};

    // Polled before each frame; true closes the window. May be empty.
    std::function<bool()> should_close {};

    // Called after the display has gone away and the model was closed, as the program's last
    // action. May be empty.
    std::function<void()> when_display_has_gone {};

    // Path of a PNG of the last frame; empty: none.
    std::filesystem::path screenshot {};

    // Folder for a film of the window as pictures 00001.png and so on, `film_rate` per second of
    // the model's time, which advances by frames as with `frames`. Without `frames` the window
    // closes at the end of what it plays. Empty: no film.
    std::filesystem::path film {};
    int film_rate = 12; // Pictures of the film per second, 1 to 60.
};

// Opens the station's window with the drawing pad, the skeleton and the plant side by side (Streit
// 2006 section 3), shows `model` until the window is closed (by its button, Escape or q, or as the
// options say), and closes the model. If the display goes away, the model is closed and the program
// ends with exit code 1, because the X library does not return.  Runs on the calling thread. Fails
// with a user error without a display, if the display to fill is not found, without OpenGL 3.3, and
// in a build without a window (TRACTUS_WINDOW=OFF).
Result<void> run_window(view::WindowModel& model, WindowOptions const& options = {});

} // namespace tractus::window
