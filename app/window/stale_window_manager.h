#pragma once

namespace tractus::window {

// Takes a note off an X11 display that a window manager has left there which was killed
// (_NET_SUPPORTING_WM_CHECK, of a window that is gone): GLFW 3.3 ends the program where it finds
// one. Returns whether there was such a note. Before glfwInit(), and from one thread.
bool remove_stale_window_manager();

} // namespace tractus::window
