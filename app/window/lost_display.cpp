#include "app/window/lost_display.h"

#include "app/terminal/console.h"

// Included last, and in a file of its own, as Xlib's macros are short, common words.
#include <X11/Xlib.h>
#include <cstdlib>
#include <fmt/core.h>
#include <utility>

namespace tractus::window {

static std::function<Result<void>()>& lost_display_action()
{
    static std::function<Result<void>()> action;
    return action;
}

// Called by Xlib on the window's thread when it notices the broken connection. This happens during
// a call that concerns the window, but never while the model is working.
static int end_without_display(::Display* /*display*/)
{
    if (auto const action = std::exchange(lost_display_action(), nullptr)) {
        auto const done = action();
        terminal::print_error(
            done ? std::string("error: the display has gone\n")
                 : fmt::format("error: the display has gone; {}\n", done.error().message));
    }
    std::_Exit(1); // Ends without running destructors, which would use the lost display.
}

void on_lost_display(std::function<Result<void>()> action)
{
    lost_display_action() = std::move(action);
    XSetIOErrorHandler(end_without_display);
}

} // namespace tractus::window
