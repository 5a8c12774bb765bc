#pragma once

namespace tractus::window {

// Removes a property that a killed window manager has left on the X11 display:
// _NET_SUPPORTING_WM_CHECK, naming a window that no longer exists. GLFW 3.3 would end the program
// if it found this. Returns true if the property was removed. Call this before glfwInit(), on the
// same thread.
bool remove_stale_window_manager();

} // namespace tractus::window
