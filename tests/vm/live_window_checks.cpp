#include "app/devices/live_devices.h"
#include "app/live/live_window.h"
#include "app/methods/all_methods.h"
#include "app/plants/model_file.h"
#include "app/verbs/device_sources.h"
#include "calib/rig_file.h"
#include "drivers/file.h"
#include "tests/vm/checks.h"

#include <chrono>
#include <cstdio>
#include <fmt/core.h>
#include <thread>
#include <utility>

namespace tractus {

namespace {

constexpr auto kFrame = std::chrono::milliseconds(16);

Result<LiveWindow> open_window(std::string const& model, std::string const& rig_file)
{
    auto const rig_text = TRY(read_file(rig_file));
    auto const edit = TRY(load_model_edit(model));
    LiveWindowOptions options { .methods = all_methods() };
    options.rig = TRY(parse_rig(rig_text, rig_file));
    options.scene = TRY(apply_edit({}, edit));
    options.now = [] { return Timestamp(std::chrono::steady_clock::now().time_since_epoch()); };
    auto devices = TRY(open_found(find_pens_and_height_sensors()));
    return LiveWindow::create(std::move(devices), std::move(options));
}

// Says what the window shows that it did not show before.
class Teller {
public:
    void look_at(LiveWindow const& window)
    {
        auto const& state = window.state();
        auto const strokes = window.station().counts().strokes;
        if (std::exchange(strokes_, strokes) != strokes)
            tell(fmt::format("stroke {}", strokes));
        bool const touches = state.pen.in_range && state.pen.touching;
        if (std::exchange(touches_, touches) != touches)
            tell(touches ? "the pen touches" : "the pen does not touch");
        if (std::exchange(trouble_, state.trouble) != state.trouble)
            tell(state.trouble.empty() ? "nothing is wrong" : state.trouble);
    }

private:
    static void tell(std::string const& what)
    {
        fmt::print("{}\n", what);
        std::fflush(stdout);
    }

    std::size_t strokes_ = 0;
    bool touches_ = false;
    std::string trouble_;
};

} // namespace

Result<void> watch_live_window(std::string const& model, std::string const& rig_file)
{
    auto const& stop = stop_on_signals();
    auto window = TRY(open_window(model, rig_file));
    Teller teller;
    while (!stop) {
        window.advance(kFrame);
        teller.look_at(window);
        std::this_thread::sleep_for(kFrame);
    }
    return {};
}

} // namespace tractus
