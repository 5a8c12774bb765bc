#include "app/commands/device_sources.h"
#include "app/controllers/drawing_file.h"
#include "app/controllers/live_window.h"
#include "app/devices/live_devices.h"
#include "app/methods/all_methods.h"
#include "calib/rig_file.h"
#include "drivers/logs/log.h"
#include "drivers/reports/clock.h"
#include "engine/base/file.h"
#include "tests/vm/checks.h"

#include <chrono>
#include <cstdio>
#include <fmt/core.h>
#include <thread>
#include <utility>

namespace tractus {

namespace {

constexpr auto kFrame = std::chrono::milliseconds(16);

Result<controllers::LiveWindow> open_window(WatchedWindow const& watched)
{
    auto const rig_text = TRY(read_file(watched.rig_file));
    controllers::LiveWindowOptions options { .methods = methods::all_methods() };
    options.rig = TRY(calib::parse_rig(rig_text, watched.rig_file));
    if (watched.session.empty()) {
        options.scene = TRY(controllers::scene_of_plant(watched.model, options.methods.edits));
    } else {
        std::string trouble;
        options.session = TRY(controllers::open_or_begin({ watched.model, watched.session },
                                                         options.methods.edits, trouble));
        if (!trouble.empty())
            return fail(Fault::Station, trouble);
    }
    options.recording = watched.recording;
    options.now = drivers::monotonic_now;
    auto devices = TRY(commands::open_found(devices::find_pens_and_height_sensors()));
    return controllers::LiveWindow::create(std::move(devices), std::move(options));
}

// A simulated user who chooses the tools of a recording, one for each stroke.
class Chooser {
public:
    static Result<Chooser> create(std::string const& log_name)
    {
        Chooser chooser;
        if (log_name.empty())
            return chooser;
        auto const log = TRY(drivers::read_log(log_name));
        for (auto const& line : log.tools)
            chooser.tools_.push_back(
                TRY(tools::parse_tool(methods::all_methods().tools, line.tool, line.arguments)));
        return chooser;
    }

    // Chooses the next stroke's tool as soon as the previous stroke is finished.
    void look_at(controllers::LiveWindow& window)
    {
        if (next_ < tools_.size() && window.station().counts().strokes >= next_)
            window.perform(view::ChooseTool { tools_[next_++] });
    }

private:
    std::vector<tools::Tool> tools_;
    std::size_t next_ = 0;
};

// Prints each change of the window's strokes, pen contact and problems.
class Teller {
public:
    void look_at(controllers::LiveWindow const& window)
    {
        auto const& state = window.state();
        auto const strokes = window.station().counts().strokes;
        if (std::exchange(strokes_, strokes) != strokes)
            tell(fmt::format("stroke {}", strokes));
        bool const touches = state.pen.in_range && state.pen.touching;
        if (std::exchange(touches_, touches) != touches)
            tell(touches ? "the pen touches" : "the pen does not touch");
        auto const kept = kept_strokes(window.document());
        if (std::exchange(kept_, kept) != kept)
            tell(fmt::format("kept {}", kept));
        if (std::exchange(trouble_, state.trouble) != state.trouble)
            tell(state.trouble.empty() ? "nothing is wrong" : state.trouble);
    }

private:
    // Returns the number of strokes on the disk. While strokes are being written, returns the
    // previous number.
    std::size_t kept_strokes(document::Document const& document) const
    {
        return document.is_settled() ? document.stroke_count() : kept_;
    }

    static void tell(std::string const& what)
    {
        fmt::print("{}\n", what);
        std::fflush(stdout);
    }

    std::size_t strokes_ = 0;
    std::size_t kept_ = 0;
    bool touches_ = false;
    std::string trouble_;
};

} // namespace

Result<void> watch_live_window(WatchedWindow const& watched)
{
    auto const& stop = commands::stop_on_signals();
    auto chooser = TRY(Chooser::create(watched.tools));
    auto window = TRY(open_window(watched));
    Teller teller;
    while (!stop) {
        window.advance(kFrame);
        chooser.look_at(window);
        teller.look_at(window);
        std::this_thread::sleep_for(kFrame);
    }
    return window.close();
}

} // namespace tractus
