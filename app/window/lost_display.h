#pragma once

#include "engine/base/result.h"

#include <functional>

namespace tractus::window {

// Sets an action that runs once when the X11 display goes away. Then the program ends with exit
// code 1, because Xlib gives no way to continue. The action's error is printed. Null: no action. If
// a Wayland compositor goes away, GLFW closes the window instead.
void on_lost_display(std::function<Result<void>()> action);

} // namespace tractus::window
