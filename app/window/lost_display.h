#pragma once

#include "engine/base/result.h"

#include <functional>

namespace tractus::window {

// Sets what is done, once, when the X11 display goes away. Then the program ends with exit code 1,
// because Xlib gives no way to continue. The action's error is printed. Null: nothing is done. If a
// Wayland compositor goes away, GLFW closes the window instead.
void on_lost_display(std::function<Result<void>()> action);

} // namespace tractus::window
