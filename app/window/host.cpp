#include "app/window/host.h"

#include "app/render/gl_objects.h"
#include "app/terminal/error_text.h"
#include "app/window/imgui_mouse.h"
#include "app/window/stale_window_manager.h"
#include "app/window/theme.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <cctype>
#include <cstdlib>
#include <fmt/core.h>
#include <span>
#include <utility>

namespace tractus::window {

namespace {

tl::unexpected<Error> no_window(char const* what)
{
    char const* reason = nullptr;
    glfwGetError(&reason);
    return fail(
        Fault::User,
        fmt::format(
            "cannot open a window: {} ({}); start it on a display, or use `tractus demo -o DIR`, "
            "`tractus replay` or `tractus render`, which need none",
            what, reason ? reason : "no reason given"));
}

// Returns the constant of KeyPress for a key without a letter; 0 if the key has none.
char special_key(int key)
{
    switch (key) {
    case GLFW_KEY_ESCAPE:
        return KeyPress::kEscape;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
        return KeyPress::kEnter;
    case GLFW_KEY_BACKSPACE:
        return KeyPress::kBackspace;
    case GLFW_KEY_LEFT:
        return KeyPress::kLeft;
    case GLFW_KEY_RIGHT:
        return KeyPress::kRight;
    case GLFW_KEY_UP:
        return KeyPress::kUp;
    case GLFW_KEY_DOWN:
        return KeyPress::kDown;
    default:
        return 0;
    }
}

// Returns the letter on a key of the current keyboard layout, or of the US layout if the current
// one is not Latin. Returns 0 if the key has no letter.
char letter_of(int key, int scancode)
{
    auto const* const name = glfwGetKeyName(key, scancode);
    auto const first = static_cast<unsigned char>(name != nullptr ? name[0] : 0);
    bool const is_other_script = first == 0 || first >= 0x80;
    if (is_other_script)
        return key >= GLFW_KEY_A && key <= GLFW_KEY_Z ? static_cast<char>(key) : char { 0 };
    return std::isalpha(first) ? static_cast<char>(std::toupper(first)) : char { 0 };
}

std::span<GLFWmonitor* const> monitors()
{
    int count = 0;
    auto* const* const first = glfwGetMonitors(&count);
    return { first, static_cast<std::size_t>(count) };
}

} // namespace

Host::~Host()
{
    if (imgui_) {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    if (window_ != nullptr)
        glfwDestroyWindow(window_);
    if (library_)
        glfwTerminate();
}

Result<void> Host::open(WindowOptions const& options)
{
#ifdef GLFW_PLATFORM
    // GLFW 3.4 tries Wayland first. Without this variable, Wayland's library would print an error.
    if (std::getenv("XDG_RUNTIME_DIR") == nullptr)
        glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    if (remove_stale_window_manager())
        terminal::print_warning("the display names a window manager that is gone: its note is "
                                "taken away, and windows may have no frames");
    if (glfwInit() != GLFW_TRUE)
        return no_window("there is no display");
    library_ = true;
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    window_
        = glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
    if (window_ == nullptr)
        return no_window("the display has no OpenGL 3.3");
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(options.frames > 0 ? 0 : 1);
    glfwGetWindowContentScale(window_, &scale_, nullptr);
    watch_mouse(); // Installed before ImGui's callbacks, which pass events on to these.
    watch_keyboard();
    watch_window();

    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // Stops ImGui from writing the file imgui.ini.
    if (options.scale > 0)
        scale_ = static_cast<float>(options.scale);
    theme::set_light(options.look.is_light);
    title_font_ = theme::apply(scale_);
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    imgui_ = true;
    return {};
}

Host& Host::stirred(GLFWwindow* window)
{
    auto& host = *static_cast<Host*>(glfwGetWindowUserPointer(window));
    host.has_stirred_ = true;
    return host;
}

void Host::watch_mouse()
{
    glfwSetWindowUserPointer(window_, this);
    // Each event contains the position at its own time; glfwGetCursorPos() would return the newest
    // one.
    glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
        auto& host = stirred(window);
        host.last_mouse_.place_px = { static_cast<float>(x), static_cast<float>(y) };
        host.mouse_.push(host.last_mouse_);
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int) {
        auto& host = stirred(window);
        if (button != GLFW_MOUSE_BUTTON_LEFT)
            return;
        host.last_mouse_.is_down = action == GLFW_PRESS;
        host.mouse_.push(host.last_mouse_);
    });
}

void Host::watch_keyboard()
{
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int code, int action, int mods) {
        auto& host = stirred(window);
        if (action != GLFW_REPEAT || key == GLFW_KEY_BACKSPACE)
            host.take_key(key, code, action != GLFW_RELEASE, mods);
    });
    glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned int letter) {
        auto& host = stirred(window);
        // '?' is handled as a character, because its key depends on the keyboard layout.
        if (letter == '?')
            host.presses_.push_back({ '?' });
    });
}

void Host::watch_window()
{
    glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double) { stirred(window); });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int) { stirred(window); });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int) { stirred(window); });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { stirred(window); });
    glfwSetWindowPosCallback(window_, [](GLFWwindow* window, int, int) { stirred(window); });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) { stirred(window); });
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, char const** paths) {
        for (int i = 0; i < count; ++i)
            stirred(window).dropped_.emplace_back(paths[i]);
    });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* window) { stirred(window); });
}

bool Host::take_events()
{
    glfwPollEvents();
    return std::exchange(has_stirred_, false) || !mouse_.is_empty();
}

bool Host::wait_for_events(double wait_s)
{
    if (!mouse_.is_empty())
        return true;
    glfwWaitEventsTimeout(wait_s);
    return std::exchange(has_stirred_, false);
}

void Host::take_key(int key, int scancode, bool is_pressed, int modifiers)
{
    auto const special = special_key(key);
    auto const letter = special != 0 ? special : letter_of(key, scancode);
    if (letter == 0)
        return;
    held_.erase(std::remove(held_.begin(), held_.end(), letter), held_.end());
    if (!is_pressed
        || (modifiers & (GLFW_MOD_ALT | GLFW_MOD_SUPER))
            != 0) // Keys with Alt or Super are reserved for the desktop.
        return;
    bool const has_control = (modifiers & GLFW_MOD_CONTROL) != 0;
    presses_.push_back({ letter, has_control, (modifiers & GLFW_MOD_SHIFT) != 0 });
    if (has_control) // A key with Ctrl is a command, and must not also move the surface.
        return;
    held_.push_back(letter);
    lately_held_.push_back(letter);
}

void Host::set_title(std::string const& title)
{
    if (!title.empty() && std::exchange(title_, title) != title)
        glfwSetWindowTitle(window_, title.c_str());
}

bool Host::take_close_request()
{
    bool const wants = glfwWindowShouldClose(window_);
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
    return wants;
}

HandInput Host::begin_frame(std::optional<float> step_s)
{
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    if (step_s)
        ImGui::GetIO().DeltaTime = *step_s;
    auto mouse = mouse_.take_part();
    if (mouse.change)
        show_imgui_press(*mouse.change);
    return { std::move(mouse.path), std::exchange(presses_, {}), std::exchange(lately_held_, held_),
             std::exchange(dropped_, {}) };
}

void Host::end_frame()
{
    ImGui::Render();
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

render::Image Host::back_buffer() const
{
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    render::Image upside_down(width, height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.pixels().data());
    auto picture = render::flipped(upside_down);
    for (auto& pixel : picture.pixels())
        // Pixels are made opaque, as the alpha in a window's framebuffer is meaningless.
        pixel.alpha = 255;
    return picture;
}

void Host::show_frame()
{
    glfwSwapBuffers(window_);
}

std::vector<Display> Host::displays() const
{
    std::vector<Display> displays;
    for (auto* const monitor : monitors()) {
        auto& display = displays.emplace_back();
        display.name = glfwGetMonitorName(monitor);
        if (auto const* const mode = glfwGetVideoMode(monitor)) {
            display.width_px = mode->width;
            display.height_px = mode->height;
        }
        int width_mm = 0, height_mm = 0;
        glfwGetMonitorPhysicalSize(monitor, &width_mm, &height_mm);
        display.size_mm = { width_mm, height_mm };
    }
    return displays;
}

Host::Place Host::place() const
{
    Place place;
    glfwGetWindowPos(window_, &place.left, &place.top);
    glfwGetWindowSize(window_, &place.width, &place.height);
    return place;
}

std::size_t Host::own_display() const
{
    auto const own = place();
    std::size_t best = 0;
    long best_px = 0;
    auto const all = monitors();
    for (std::size_t i = 0; i < all.size(); ++i) {
        int left = 0, top = 0;
        glfwGetMonitorPos(all[i], &left, &top);
        auto const* const mode = glfwGetVideoMode(all[i]);
        if (mode == nullptr)
            continue;
        long const width
            = std::min(own.left + own.width, left + mode->width) - std::max(own.left, left);
        long const height
            = std::min(own.top + own.height, top + mode->height) - std::max(own.top, top);
        long const shared_px = std::max(width, 0L) * std::max(height, 0L);
        if (shared_px > best_px) {
            best_px = shared_px;
            best = i;
        }
    }
    return best;
}

std::optional<std::size_t> Host::filled_display() const
{
    auto* const filled = glfwGetWindowMonitor(window_);
    auto const all = monitors();
    auto const found = std::find(all.begin(), all.end(), filled);
    if (filled == nullptr || found == all.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - all.begin());
}

void Host::fill_display(std::optional<std::size_t> display)
{
    auto const filled = filled_display();
    if (display == filled)
        return;
    if (!filled)
        last_place_ = place();
    auto const all = monitors();
    if (display && *display < all.size())
        return fill_monitor(all[*display]);
    if (filled)
        glfwSetWindowMonitor(window_, nullptr, last_place_.left, last_place_.top, last_place_.width,
                             last_place_.height, GLFW_DONT_CARE);
}

// Moves the window to the monitor before the window fills it: some window managers (Openbox) always
// fill the monitor on which the window already is.
void Host::fill_monitor(GLFWmonitor* monitor)
{
    auto const* const mode = glfwGetVideoMode(monitor);
    if (mode == nullptr)
        return;
    int left = 0, top = 0;
    glfwGetMonitorPos(monitor, &left, &top);
    glfwSetWindowMonitor(window_, nullptr, left, top, last_place_.width, last_place_.height,
                         GLFW_DONT_CARE);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

} // namespace tractus::window
