#pragma once

#include "app/render/image.h"
#include "app/window/display.h"
#include "app/window/hand_input.h"
#include "app/window/mouse_queue.h"
#include "app/window/window.h"
#include "engine/base/result.h"

#include <cstddef>
#include <filesystem>
#include <imgui.h>
#include <optional>
#include <string>
#include <vector>

struct GLFWmonitor;
struct GLFWwindow;

namespace tractus::window {

// Owns GLFW, its window with an OpenGL 3.3 core context, and ImGui; initialised in this order and
// closed in reverse.
class Host {
public:
    Host() = default;
    Host(Host const&) = delete;
    Host& operator=(Host const&) = delete;
    ~Host();

    // Opens the window; call once. Fails like run_window().
    Result<void> open(WindowOptions const& options);

    // Sets the window's title; an empty title changes nothing.
    void set_title(std::string const& title);
    // True if the user has asked to close the window, by its button or a key, since the last call.
    bool take_close_request();
    // Begins a frame. `step_s` is the time since the last one; no value: by the clock. Returns
    // mouse and keyboard events up to this frame.
    HandInput begin_frame(std::optional<float> step_s);
    void end_frame(); // Ends and renders the frame; the picture is then in the back buffer.
    render::Image back_buffer() const;
    void show_frame();

    float scale() const { return scale_; }
    ImFont* title_font() const { return title_font_; }

    // Processes pending events; wait_for_events() waits up to `wait_s` for one. Returns true if any
    // of them concerned the window, or a frame is still due for earlier ones.
    bool take_events();
    bool wait_for_events(double wait_s);

    // The connected displays in the system's order, the main one first. They may change while
    // events are processed.
    std::vector<Display> displays() const;

    // Index of the display that shows most of the window.
    std::size_t own_display() const;

    // Index of the display that the window fills; nullopt if it is not full screen.
    std::optional<std::size_t> filled_display() const;

    // Makes the window fill a display; nullopt restores its earlier place.
    void fill_display(std::optional<std::size_t> display);

private:
    struct Place {
        int left = 0, top = 0, width = 0, height = 0;
    };

    static Host& stirred(GLFWwindow* window); // The host whose window received an event; notes that
                                              // it needs a frame.
    void watch_mouse();
    void watch_window();
    void watch_keyboard();
    void take_key(int key, int scancode, bool is_pressed, int modifiers);
    void fill_monitor(GLFWmonitor* monitor);
    Place place() const;

    MouseQueue mouse_;
    MouseMoment last_mouse_; // Newest state stored in mouse_.
    std::vector<KeyPress> presses_;
    std::vector<std::filesystem::path> dropped_; // Files dropped since the last frame.
    bool has_stirred_ = false; // True if an event has arrived since events were last taken.
    std::string lately_held_;  // Letters pressed since the last frame.
    std::string held_;         // Letters of the keys that are down now.
    bool library_ = false;
    GLFWwindow* window_ = nullptr;
    std::string title_; // Title set last; empty: the initial title.
    Place last_place_;  // Position and size before the window became full screen.
    bool imgui_ = false;
    float scale_ = 1;
    ImFont* title_font_ = nullptr;
};

} // namespace tractus::window
