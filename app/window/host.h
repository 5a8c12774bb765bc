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

// Owns GLFW, a GLFW window with an OpenGL 3.3 core context, and ImGui. They are initialised in this
// order and closed in reverse order.
class Host {
public:
    Host() = default;
    Host(Host const&) = delete;
    Host& operator=(Host const&) = delete;
    ~Host();

    // Opens the window; call this once. Fails like run_window().
    Result<void> open(WindowOptions const& options);

    // Sets the window's title; an empty title changes nothing.
    void set_title(std::string const& title);
    // True if the user has asked to close the window, by its button or by a key, since the last
    // call.
    bool take_close_request();
    // Begins a frame. `step_s` is the time since the previous frame; without a value it is measured
    // by the clock. Returns the events of mouse and keyboard up to this frame.
    HandInput begin_frame(std::optional<float> step_s);
    void end_frame(); // Ends and renders the frame. Its picture is then in the back buffer.
    render::Image back_buffer() const;
    void show_frame();

    float scale() const { return scale_; }
    ImFont* title_font() const { return title_font_; }

    // Process pending events; wait_for_events() first waits for an event, for at most `wait_s`.
    // They return true if an event concerned the window, or if events of earlier calls still need a
    // frame.
    bool take_events();
    bool wait_for_events(double wait_s);

    // Returns the connected displays in the system's order, the main one first. Processing events
    // may change the list.
    std::vector<Display> displays() const;

    // Returns the index of the display that shows most of the window.
    std::size_t own_display() const;

    // Returns the index of the display that the window fills; nullopt if the window is not full
    // screen.
    std::optional<std::size_t> filled_display() const;

    // Makes the window fill a display. nullopt returns it to its earlier position and size.
    void fill_display(std::optional<std::size_t> display);

private:
    struct Place {
        int left = 0, top = 0, width = 0, height = 0;
    };

    // Returns the host whose window received an event, and records that the window needs a frame.
    static Host& stirred(GLFWwindow* window);
    void watch_mouse();
    void watch_window();
    void watch_keyboard();
    void take_key(int key, int scancode, bool is_pressed, int modifiers);
    void fill_monitor(GLFWmonitor* monitor);
    Place place() const;

    MouseQueue mouse_;
    MouseMoment last_mouse_; // State that was last added to mouse_.
    std::vector<KeyPress> presses_;
    // Files that were dropped on the window since the last frame.
    std::vector<std::filesystem::path> dropped_;
    // True if an event has arrived since the last take_events() or wait_for_events().
    bool has_stirred_ = false;
    std::string lately_held_; // Letters of keys that were held at any time since the last frame.
    std::string held_;        // Letters of the keys that are held now.
    bool library_ = false;
    GLFWwindow* window_ = nullptr;
    std::string title_; // Title that was set last; empty: the window has its initial title.
    Place last_place_;  // Position and size of the window before it became full screen.
    bool imgui_ = false;
    float scale_ = 1;
    ImFont* title_font_ = nullptr;
};

} // namespace tractus::window
