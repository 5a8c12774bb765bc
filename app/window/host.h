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

// GLFW's library, its window with an OpenGL 3.3 core context, and ImGui in it, in the order in
// which they come and, backwards, go.
class Host {
public:
    Host() = default;
    Host(Host const&) = delete;
    Host& operator=(Host const&) = delete;
    ~Host();

    // Fails like run_window(). Once.
    Result<void> open(WindowOptions const& options);

    void set_title(std::string const& title); // Empty: as it is.
    bool take_wish_to_close();                // Since the last call, by the window's button or key.
    // `step_s`: how long after the last one, where that is not the clock's. Returns what mouse and
    // keyboard did up to this frame.
    HandInput begin_frame(std::optional<float> step_s);
    void end_frame(); // Draws; the picture is in the back buffer.
    render::Image back_buffer() const;
    void show_frame();

    float scale() const { return scale_; }
    ImFont* title_font() const { return title_font_; }

    // Lets events come in, those that are there already or, for `wait_s` at most, the next ones
    // too. True if any of them concerned the window, or still waits for a frame.
    bool take_events();
    bool wait_for_events(double wait_s);

    // The displays there are, in the system's order, the first one its main one. They may come and
    // go while events are taken.
    std::vector<Display> displays() const;

    // The one that most of the window is on.
    std::size_t own_display() const;

    // The one that it fills; none while it is a window among others.
    std::optional<std::size_t> filled_display() const;

    // Fills it, or is a window again where it was before.
    void fill_display(std::optional<std::size_t> display);

private:
    struct Place {
        int left = 0, top = 0, width = 0, height = 0;
    };

    static Host& stirred(GLFWwindow* window); // The one whose window an event concerns.
    void watch_mouse();
    void watch_window();
    void watch_keyboard();
    void take_key(int key, int scancode, bool is_pressed, int modifiers);
    void fill_monitor(GLFWmonitor* monitor);
    Place place() const;

    MouseQueue mouse_;
    MouseMoment last_mouse_; // Pushed into it.
    std::vector<KeyPress> presses_;
    std::vector<std::filesystem::path> dropped_; // Since the last frame.
    bool has_stirred_ = false;                   // Since events were last taken.
    std::string lately_held_;                    // Since the last frame.
    std::string held_;                           // The letters of the keys that are down now.
    bool library_ = false;
    GLFWwindow* window_ = nullptr;
    std::string title_; // Set last; empty: as it was opened.
    Place last_place_;  // As a window among others.
    bool imgui_ = false;
    float scale_ = 1;
    ImFont* title_font_ = nullptr;
};

} // namespace tractus::window
