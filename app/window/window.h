#pragma once

#include "app/view/window_model.h"
#include "engine/base/result.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace tractus::window {

// The user's choices for the appearance of the window.
struct WindowLook {
    bool is_light = false;       // True: colours for a bright room. False: colours for a dark room.
    bool is_left_handed = false; // True: layout for left-handed use; see Workspace::is_left_handed.

    bool operator==(WindowLook const&) const = default;
};

struct WindowOptions {
    std::string title = "tractus";
    int width = 1600; // Initial width in pixels; the user may change the size.
    int height = 900;

    // Number of frames after which the window closes; each frame then advances the model's time by
    // 1/60 s. 0: the window stays open, and the model's time follows the clock.
    int frames = 0;

    // Display that the window fills, as a text for find_display(). Empty text: the tablet's own
    // display, otherwise the display on which the window is. nullopt: the window is not full
    // screen.
    std::optional<std::string> full_screen {};

    // View with which a drawing begins, one of shown_words() (workspace.h). Empty: the pad if there
    // is a pen tablet, otherwise all views.
    std::string view {};

    bool is_on_stage = false; // True: the window opens in the stage view (Workspace::is_on_stage).

    WindowLook look {}; // Initial appearance of the window.
    double scale = 0;   // Scale factor of text and buttons; 0: the display's scale factor.

    // Called whenever the user changes the window's appearance. May be empty.
    std::function<void(WindowLook const&)> keep_look {};

    // Called before each frame. If it returns true, the window closes. May be empty.
    std::function<bool()> should_close {};

    // Called once whenever the window has been at rest for ten seconds: what it shows has not
    // changed, and there was no input. May be empty.
    std::function<void()> when_at_rest {};

    // Called when the display was lost and the model has been closed, just before the program ends.
    // May be empty.
    std::function<void()> when_display_has_gone {};

    // Path for a PNG picture of the last frame; empty: none.
    std::filesystem::path screenshot {};

    // Folder for a film of the window, as pictures 00001.png and so on; empty: no film. For a film
    // the model's time advances by frames, as with `frames`. The film has `film_rate` pictures per
    // second of this time. Without `frames` the window closes when playback ends.
    std::filesystem::path film {};
    int film_rate = 12; // Pictures of the film per second of the model's time, 1 to 60.
};

// Opens the station's window, which shows the drawing pad, the skeleton and the plant side by side
// (Streit 2006 section 3). Shows `model` until the window is closed (by its button, Escape or q, or
// as the options say), and then closes the model. If the display is lost, the model is closed and
// the program ends with exit code 1, because the X library does not return. Runs on the calling
// thread. Fails with a user error without a display, if the display to fill is not found, without
// OpenGL 3.3, and in a build without a window (TRACTUS_WINDOW=OFF).
Result<void> run_window(view::WindowModel& model, WindowOptions const& options = {});

} // namespace tractus::window
