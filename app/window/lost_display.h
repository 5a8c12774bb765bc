#pragma once

#include "engine/base/result.h"

#include <functional>

namespace tractus::window {

// Sets an action that runs once if the connection to the X11 display is lost. The action's error is
// printed. The program then ends with exit code 1, because Xlib cannot continue. Null: no action.
// If a Wayland compositor is lost, GLFW closes the window instead.
void on_lost_display(std::function<Result<void>()> action);

} // namespace tractus::window
