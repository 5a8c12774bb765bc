#include "app/window/stale_window_manager.h"

#include <X11/Xatom.h>
// Included last, and in a file of its own, as Xlib's macros are short, common words.
#include <X11/Xlib.h>
#include <optional>

namespace tractus::window {

static int ignore_error(::Display* /*display*/, XErrorEvent* /*error*/)
{
    return 0;
}

// Returns the window that a property of `window` names; nullopt if the property or the named window
// does not exist.
static std::optional<::Window> named_window(::Display* display, ::Window window, ::Atom property)
{
    ::Atom type = None;
    int format = 0;
    unsigned long count = 0;
    unsigned long left = 0;
    unsigned char* bytes = nullptr;
    bool const is_read = XGetWindowProperty(display, window, property, 0, 1, False, XA_WINDOW,
                                            &type, &format, &count, &left, &bytes)
        == Success;
    std::optional<::Window> named;
    if (is_read && type == XA_WINDOW && format == 32 && count == 1)
        named = *reinterpret_cast<::Window const*>(bytes);
    if (bytes != nullptr)
        XFree(bytes);
    return named;
}

// Removes the property _NET_SUPPORTING_WM_CHECK if it is stale: if the window that it names does
// not exist or does not have the same property. Meanwhile the X server is grabbed, so that no
// window manager can start between the test and the removal.
bool remove_stale_window_manager()
{
    // The connection is never closed: when its last client disconnects, an X server resets itself
    // and refuses new connections meanwhile.
    static auto* const display = XOpenDisplay(nullptr);
    if (display == nullptr)
        return false;
    auto* const handler = XSetErrorHandler(ignore_error);
    auto const property = XInternAtom(display, "_NET_SUPPORTING_WM_CHECK", False);
    auto const root = DefaultRootWindow(display);
    XGrabServer(display);
    auto const manager = named_window(display, root, property);
    bool const is_stale = manager && !named_window(display, *manager, property);
    if (is_stale)
        XDeleteProperty(display, root, property);
    XUngrabServer(display);
    XSync(display, False);
    XSetErrorHandler(handler);
    return is_stale;
}

} // namespace tractus::window
