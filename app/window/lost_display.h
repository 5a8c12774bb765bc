#pragma once

#include "engine/base/result.h"

#include <functional>

namespace tractus::window {

// What is done when an X11 display goes away, once, before the program ends with exit code 1: Xlib
// leaves no way to go on. The action's error is printed. Null: nothing is done. Where the display
// is a Wayland compositor's, GLFW closes the window instead.
void on_lost_display(std::function<Result<void>()> action);

} // namespace tractus::window
