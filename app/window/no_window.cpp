#include "app/window/window.h"

namespace tractus::window {

Result<void> run_window(view::WindowModel&, WindowOptions const&)
{
    return fail(Fault::User,
                "this build of tractus has no window (it was configured with TRACTUS_WINDOW=OFF); "
                "use `tractus demo -o DIR` or `tractus replay`, which write pictures");
}

} // namespace tractus::window
