#pragma once

#include "app/view/window_model.h"
#include "engine/base/result.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace tractus::window {

// What a person chooses of the window's look.
struct WindowLook {
    bool is_light = false;       // For a bright room.
    bool is_left_handed = false; // As of Workbench.

    bool operator==(WindowLook const&) const = default;
};

struct WindowOptions {
    std::string title = "tractus";
    int width = 1600; // Pixels, at first; a person may change it.
    int height = 900;

    // Closes by itself after so many frames, each 1/60 s of the model's time whatever the clock
    // says. 0: stays until closed, and the model's time is the clock's.
    int frames = 0;

    // Fills a display: the one that is named, as find_display() reads it; without a name the
    // tablet's own, else the one that the window is on. No value: a window among others.
    std::optional<std::string> full_screen {};

    bool is_on_stage = false; // At first nothing is seen but what grows: Workbench::is_on_stage.

    WindowLook look {}; // At first.
    double scale = 0;   // Of letters and buttons; 0: the display's.

    // Called with each look that the person chooses. May be empty.
    std::function<void(WindowLook const&)> keep_look {};

    // Asked before each frame: true closes the window.
    std::function<bool()> should_close {};

    // Called when the display has gone and the model is closed: the last thing that the program
    // does. May be empty.
    std::function<void()> when_display_has_gone {};

    // Where a PNG of the last frame is written; empty: nowhere.
    std::filesystem::path screenshot {};

    // A folder into which the window is written as pictures, 00001.png and on, `film_rate` for a
    // second of the model's time, which goes by frames as with `frames`. Without `frames` the
    // window closes when what it plays has ended. Empty: no film.
    std::filesystem::path film {};
    int film_rate = 12; // 1 to 60.
};

// Opens the station's window, with the drawing pad, the skeleton and the plant side by side (Streit
// 2006 section 3), and shows `model` in it until it is closed (its button, Escape or q, or
// as the options say), and closes the model. Where the display goes away meanwhile, the model is
// closed and the program ends with exit code 1: there is no way back out of the X library.
//
// Runs on the calling thread. Fails, as the user's fault, where there is no display, or not the one
// that is to be filled, or no OpenGL 3.3, and in a build without a window (TRACTUS_WINDOW=OFF).
Result<void> run_window(view::WindowModel& model, WindowOptions const& options = {});

} // namespace tractus::window
