#include "app/window/window.h"

#include "app/window/host.h"
#include "app/window/layout.h"
#include "app/window/lost_display.h"
#include "app/window/theme.h"
#include "engine/base/file.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fmt/core.h>
#include <optional>
#include <string>
#include <utility>

namespace tractus::window {

namespace {

// Frames per second of the model's time, if its time advances by frames.
constexpr int kFramesPerSecond = 60;
constexpr Duration kFrameStep { 1'000'000'000 / kFramesPerSecond };
// Number of frames that ImGui and the views need to show the effects of an event completely.
constexpr int kSettlingFrames = 3;
// Maximum sleep in an idle window. It limits the delay of an event that arrived during the last
// frame.
constexpr double kIdleWait_s = 1;
constexpr double kLiveWait_s = 1.0 / 120; // Maximum sleep while devices may send.
// Maximum time step of a frame; the whole machine may have been suspended.
constexpr double kLongestStep_s = 0.25;

// True if the model's time advances by frames instead of by the clock.
bool counts_frames(WindowOptions const& options)
{
    return options.frames > 0 || !options.film.empty();
}

Duration step_since(double& last_s, WindowOptions const& options)
{
    double const now_s = glfwGetTime();
    double const step_s = std::clamp(now_s - last_s, 0.0, kLongestStep_s);
    last_s = now_s;
    return counts_frames(options) ? kFrameStep : from_seconds(step_s);
}

// True if the window should be closed before this frame.
bool is_over(int frame, view::WindowModel const& model, WindowOptions const& options)
{
    if (options.frames > 0)
        return frame >= options.frames;
    return !options.film.empty() && frame > 0 && !model.state().playing;
}

Result<void> write_picture(Host const& host, std::filesystem::path const& path)
{
    auto const picture = host.back_buffer();
    return write_file(path, [&](std::ostream& out) { return render::write_png(out, picture); });
}

// Returns the path of the film's picture for a frame; nullopt if the film has no picture for it.
std::optional<std::filesystem::path> picture_of_film(std::int64_t frame,
                                                     WindowOptions const& options)
{
    auto const number = (frame + 1) * options.film_rate / kFramesPerSecond;
    if (options.film.empty() || number == frame * options.film_rate / kFramesPerSecond)
        return std::nullopt;
    return options.film / fmt::format("{:05}.png", number);
}

bool mouse_is_used()
{
    auto const& delta = ImGui::GetIO().MouseDelta;
    return delta.x != 0 || delta.y != 0 || ImGui::IsAnyMouseDown();
}

// Processes events. If nothing is being played, only events and connected devices can change the
// window, so the program sleeps until the next event.
class Events {
public:
    bool is_still() const { return still_frames_ >= kSettlingFrames; }

    // Returns true if the window may look different now, even if its model has not changed.
    bool take(Host& host, view::WindowModel const& model, WindowOptions const& options)
    {
        bool const stirs = counts_frames(options) || model.state().playing || mouse_is_used();
        if (stirs || !is_still()) {
            still_frames_ = host.take_events() || stirs ? 0 : still_frames_ + 1;
            return true;
        }
        bool const may_change = model.state().is_live || model.state().is_growing;
        if (host.wait_for_events(may_change ? kLiveWait_s : kIdleWait_s))
            still_frames_ = 0;
        return still_frames_ == 0 || !may_change;
    }

private:
    int still_frames_ = 0; // Number of frames in which nothing happened, since the last event.
};

// Detects if the model shows anything different from the last call.
class Changes {
public:
    bool any(view::WindowModel& model)
    {
        auto const& state = model.state();
        auto const* const start = model.start_page();
        auto const of_start = start ? 1 + start->state().revision : 0;
        std::array const revisions {
            state.live_revision,    state.strokes_revision,    state.skeleton_revision,
            state.plant_revision,   state.collection_revision, state.preview_revision,
            state.devices_revision, state.picture_revision,    of_start
        };
        bool const same_revisions = std::exchange(revisions_, revisions) == revisions;
        bool const same_status = std::exchange(status_, state.status) == state.status;
        bool const same_trouble = std::exchange(trouble_, state.trouble) == state.trouble;
        auto const recorded = state.recording.is_on ? 1 + state.recording.bytes / 100'000 : 0;
        // Sizes of the recording are compared as they are displayed, in steps of 100 kB.
        bool const same_recording = std::exchange(recorded_, recorded) == recorded;
        bool const same_unkept = std::exchange(unkept_, state.unsaved_steps) == state.unsaved_steps;
        return !same_revisions || !same_status || !same_trouble || !same_recording || !same_unkept;
    }

private:
    std::array<std::uint64_t, 9> revisions_ {};
    std::string status_;
    std::string trouble_;
    std::uint64_t recorded_ = 0;
    std::size_t unkept_ = 0;
};

// Calls WindowOptions::when_at_rest.
class Rest {
public:
    explicit Rest(WindowOptions const& options)
        : begins_(counts_frames(options) ? nullptr : options.when_at_rest)
    {
    }

    // Call this once per turn of the window's loop. `is_still`: nothing has changed since the last
    // call.
    void follow(bool is_still, double now_s)
    {
        constexpr double kRest_s = 10;
        if (!is_still) {
            since_s_ = now_s;
            has_begun_ = false;
        } else if (begins_ && !has_begun_ && now_s - since_s_ >= kRest_s) {
            has_begun_ = true;
            begins_();
        }
    }

private:
    std::function<void()> begins_;
    double since_s_ = 0;
    bool has_begun_ = false;
};

// Returns the index of the display that `which` names. If it is empty, that is the tablet's own
// display, otherwise the one with most of the window.
Result<std::size_t> wished_display(Host const& host, view::WindowState const& state,
                                   std::string const& which)
{
    auto const displays = host.displays();
    if (!which.empty())
        return find_display(displays, which);
    auto const own
        = state.has_pen() ? tablet_display(displays, state.surface_size_mm()) : std::nullopt;
    return own.value_or(host.own_display());
}

Result<void> fill_at_first(Host& host, view::WindowState const& state, WindowOptions const& options)
{
    if (options.full_screen)
        host.fill_display(TRY(wished_display(host, state, *options.full_screen)));
    return {};
}

// Enters or leaves full screen if the workspace requests it, and updates the workspace.
void fill_as_wished(Host& host, view::WindowState const& state, Workspace& workspace)
{
    if (auto const wish = std::exchange(workspace.requested_full_screen, std::nullopt)) {
        auto const number = wish->display ? std::to_string(*wish->display + 1) : std::string();
        auto const display = wished_display(host, state, number);
        host.fill_display(wish->is_on && display ? std::optional(*display) : std::nullopt);
    }
    workspace.displays = host.displays();
    workspace.filled_display = host.filled_display();
}

WindowLook look_of(Layout& layout)
{
    return { theme::palette().is_light, layout.workspace().is_left_handed };
}

} // namespace

// Shows the model until the window is closed, and writes the requested pictures.
static Result<void> show_window(Host& host, view::WindowModel& model, WindowOptions const& options)
{
    TRY(host.open(options));
    auto renderer = TRY(render::Renderer::create());
    TRY(fill_at_first(host, model.state(), options));
    Layout layout(host.title_font(), host.scale());
    layout.workspace().is_left_handed = options.look.is_left_handed;
    layout.workspace().is_on_stage = options.is_on_stage;
    layout.workspace().shown_first = parse_shown(options.view);
    PenPointer pen;
    auto const draw_frame = [&] {
        auto const step_s = counts_frames(options)
            ? std::optional(static_cast<float>(to_seconds(kFrameStep)))
            : std::nullopt;
        fill_as_wished(host, model.state(), layout.workspace());
        host.set_title(model.state().title);
        auto const input = host.begin_frame(step_s);
        pen.feed(model.state(), layout.pen_area(), ImGui::GetIO().DeltaTime);
        ImGui::NewFrame();
        layout.show(model, renderer, pen, input);
        host.end_frame();
    };
    Events events;
    Changes changes;
    Rest rest(options);
    auto kept_look = options.look;
    double last_s = glfwGetTime();
    auto const closes = [&] {
        bool const of_desktop = host.take_close_request();
        bool const of_person = layout.take_close_request() || of_desktop;
        return (options.should_close && options.should_close()) || (of_person && model.may_close());
    };
    for (int frame = 0; !closes() && !is_over(frame, model, options); ++frame) {
        bool const may_differ = events.take(host, model, options);
        model.advance(step_since(last_s, options));
        if (counts_frames(options))
            model.settle();
        bool const has_changed = changes.any(model) || pen.has_more();
        rest.follow(!has_changed && events.is_still(), glfwGetTime());
        if (!has_changed && !may_differ)
            continue;
        draw_frame();
        if (auto const look = look_of(layout); options.keep_look && look != kept_look)
            options.keep_look(kept_look = look);
        if (auto const path = picture_of_film(frame, options))
            TRY(write_picture(host, *path));
        host.show_frame();
    }
    if (options.screenshot.empty())
        return {};
    // The frame is rendered again, because the back buffer is undefined after a swap of buffers.
    draw_frame();
    return write_picture(host, options.screenshot);
}

Result<void> run_window(view::WindowModel& model, WindowOptions const& options)
{
    on_lost_display([&] {
        auto const closed = model.close();
        if (options.when_display_has_gone)
            options.when_display_has_gone();
        return closed;
    });
    Result<void> shown;
    {
        Host host;
        shown = show_window(host, model, options);
    }
    on_lost_display(nullptr);
    auto closed = model.close();
    // If both showing and closing have failed, the first error is the cause.
    return shown ? closed : shown;
}

} // namespace tractus::window
