#include "app/window/window.h"

#include "app/render/gl_objects.h"
#include "app/window/layout.h"
#include "app/window/theme.h"
#include "drivers/file.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <array>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <cstdint>
#include <cstdlib>
#include <fmt/core.h>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tractus {

namespace {

constexpr Duration kTestStep { 1'000'000'000 / 60 };
constexpr int kSettlingFrames = 3; // ImGui and the views answer an event within so many frames.
constexpr double kIdleWait_s = 1;  // Longest sleep, should an event have come with the last one.
constexpr double kLiveWait_s = 1.0 / 120; // The same while devices may send.
constexpr double kLongestStep_s = 0.25;   // After a pause of the whole machine, time does not jump.

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

// GLFW's library, its window with an OpenGL 3.3 core context, and ImGui in it, in the order in
// which they come and, backwards, go.
class Host {
public:
    Host() = default;
    Host(Host const&) = delete;
    Host& operator=(Host const&) = delete;
    ~Host();

    Result<void> open(WindowOptions const& options);

    GLFWwindow* window() const { return window_; }
    bool wants_to_close() const;
    void begin_frame(std::optional<float> step_s);
    void end_frame(); // Draws; the picture is in the back buffer.

    float scale() const { return scale_; }
    ImFont* title_font() const { return title_font_; }

    // What the mouse did since the last call: more than ImGui tells, which knows where it is at
    // each frame.
    std::vector<MouseMoment> take_mouse() { return std::exchange(mouse_, {}); }

private:
    void watch_mouse();

    std::vector<MouseMoment> mouse_;
    bool library_ = false;
    GLFWwindow* window_ = nullptr;
    bool imgui_ = false;
    float scale_ = 1;
    ImFont* title_font_ = nullptr;
};

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
    // GLFW 3.4 tries Wayland first, whose library says on standard error that it has no folder.
    if (std::getenv("XDG_RUNTIME_DIR") == nullptr)
        glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
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
    watch_mouse(); // Before ImGui, which passes everything on.

    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr; // Leaves no file behind.
    if (options.scale > 0)
        scale_ = static_cast<float>(options.scale);
    theme::set_light(options.is_light);
    title_font_ = theme::apply(scale_);
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    imgui_ = true;
    return {};
}

void Host::watch_mouse()
{
    glfwSetWindowUserPointer(window_, this);
    glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
        auto& host = *static_cast<Host*>(glfwGetWindowUserPointer(window));
        bool const is_down = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
        host.mouse_.push_back({ { static_cast<float>(x), static_cast<float>(y) }, is_down });
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int) {
        auto& host = *static_cast<Host*>(glfwGetWindowUserPointer(window));
        if (button != GLFW_MOUSE_BUTTON_LEFT)
            return;
        double x = 0, y = 0;
        glfwGetCursorPos(window, &x, &y);
        host.mouse_.push_back(
            { { static_cast<float>(x), static_cast<float>(y) }, action == GLFW_PRESS });
    });
}

bool Host::wants_to_close() const
{
    return glfwWindowShouldClose(window_);
}

// `step`: how long after the last one, where that is not the clock's.
void Host::begin_frame(std::optional<float> step_s)
{
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    if (step_s)
        ImGui::GetIO().DeltaTime = *step_s;
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

Image back_buffer(GLFWwindow* window)
{
    int width = 0, height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    Image upside_down(width, height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.pixels().data());
    auto picture = flipped(upside_down);
    for (auto& pixel : picture.pixels())
        pixel.alpha = 255; // A window's own alpha says nothing.
    return picture;
}

Duration step_since(double& last_s, int frames)
{
    double const now_s = glfwGetTime();
    double const step_s = std::clamp(now_s - last_s, 0.0, kLongestStep_s);
    last_s = now_s;
    return frames > 0 ? kTestStep : from_seconds(step_s);
}

bool mouse_is_used()
{
    auto const& delta = ImGui::GetIO().MouseDelta;
    return delta.x != 0 || delta.y != 0 || ImGui::IsAnyMouseDown();
}

// Lets events come in. While nothing plays only they, and devices that are read, change the window,
// so it sleeps until the next one.
class Events {
public:
    // True if the window may look different now, whatever its model says.
    bool take(WindowModel const& model, WindowOptions const& options)
    {
        bool const stirs = options.frames > 0 || model.state().playing || mouse_is_used();
        if (stirs || still_frames_ < kSettlingFrames) {
            glfwPollEvents();
            still_frames_ = stirs ? 0 : still_frames_ + 1;
            return true;
        }
        bool const may_change = model.state().is_live || model.state().is_growing;
        double const wait_s = may_change ? kLiveWait_s : kIdleWait_s;
        double const begin_s = glfwGetTime();
        glfwWaitEventsTimeout(wait_s);
        if (glfwGetTime() - begin_s < wait_s)
            still_frames_ = 0;
        return still_frames_ == 0 || !may_change;
    }

private:
    int still_frames_ = 0; // Since something happened.
};

// Whether the model shows something else than at the last call.
class Changes {
public:
    bool any(WindowState const& state)
    {
        std::array const revisions { state.live_revision,       state.strokes_revision,
                                     state.skeleton_revision,   state.plant_revision,
                                     state.collection_revision, state.preview_revision,
                                     state.devices_revision };
        bool const same_revisions = std::exchange(revisions_, revisions) == revisions;
        bool const same_status = std::exchange(status_, state.status) == state.status;
        bool const same_trouble = std::exchange(trouble_, state.trouble) == state.trouble;
        auto const recorded = state.recording.is_on ? 1 + state.recording.bytes / 100'000 : 0;
        bool const same_recording = std::exchange(recorded_, recorded) == recorded; // As shown.
        return !same_revisions || !same_status || !same_trouble || !same_recording;
    }

private:
    std::array<std::uint64_t, 7> revisions_ {};
    std::string status_;
    std::string trouble_;
    std::uint64_t recorded_ = 0;
};

} // namespace

Result<void> run_window(WindowModel& model, WindowOptions const& options)
{
    Host host;
    TRY(host.open(options));
    auto renderer = TRY(Renderer::create());
    Layout layout(host.title_font(), host.scale());
    PenPointer pen;
    auto const draw_frame = [&] {
        auto const step_s = options.frames > 0
            ? std::optional(static_cast<float>(to_seconds(kTestStep)))
            : std::nullopt;
        host.begin_frame(step_s);
        pen.feed(model.state(), layout.pen_area(), ImGui::GetIO().DeltaTime);
        ImGui::NewFrame();
        layout.show(model, renderer, pen, host.take_mouse());
        host.end_frame();
    };
    Events events;
    Changes changes;
    double last_s = glfwGetTime();
    for (int frame = 0; !host.wants_to_close() && !layout.wants_to_close()
         && (options.frames == 0 || frame < options.frames);
         ++frame) {
        bool const may_differ = events.take(model, options);
        model.advance(step_since(last_s, options.frames));
        if (options.frames > 0)
            model.settle();
        if (!changes.any(model.state()) && !may_differ && !pen.has_more())
            continue;
        draw_frame();
        glfwSwapBuffers(host.window());
    }
    if (options.screenshot.empty())
        return {};
    draw_frame(); // Once more, since what a swap leaves behind is not defined.
    auto const picture = back_buffer(host.window());
    return write_file(options.screenshot,
                      [&](std::ostream& out) { return write_png(out, picture); });
}

} // namespace tractus
