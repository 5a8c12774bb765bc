// Replays eight hours of drawing as fast as possible: strokes of one second, pauses of three
// seconds, and an occasional undo. After each hour, reports the memory of the idle program, which
// should stay constant. The drawing is kept in a session, which must be complete at the end.
#include "app/batch/malloc_tuning.h"
#include "app/batch/session_plant.h"
#include "app/controllers/station_controller.h"
#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "tests/app/simple_rig.h"
#include "tests/bench/report.h"

#include <cmath>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <malloc.h>
#include <thread>
#include <unistd.h>

namespace tractus {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kHours = 8;
constexpr std::int64_t kCycle_ms = 4000;
constexpr std::int64_t kStroke_ms = 1000;
constexpr std::int64_t kFrame_ms = 16;
constexpr std::int64_t kStrokesPerUndo = 10;

double resident_mb()
{
    std::size_t all = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> all >> resident;
    return static_cast<double>(resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE))) / 1e6;
}

class Day {
public:
    explicit Day(fs::path const& path)
        : controller_(station_,
                      batch::begin_session(path, { model() }, scene::core_edit_kinds()).value(), {},
                      ".")
    {
    }

    // Draws one stroke and makes the pause after it.
    void cycle()
    {
        for (std::int64_t ms = 0; ms < kCycle_ms; ++ms, ++now_ms_) {
            station_.push(kHeight, at_ms(now_ms_),
                          height_report(2000 + static_cast<int>(ms % 300)));
            if (ms % 5 == 0 && ms < 2 * kStroke_ms) {
                double const turn = static_cast<double>(ms) * 0.002 + static_cast<double>(strokes_);
                station_.push(kPen, at_ms(now_ms_),
                              pen_report(100 + 30 * std::cos(turn),
                                         50 + 0.02 * static_cast<double>(ms), ms < kStroke_ms));
            }
            if (ms % kFrame_ms == 0)
                controller_.show(station_, at_ms(now_ms_));
        }
        if (++strokes_ % kStrokesPerUndo != 0)
            return;
        controller_.perform(view::Undo {}, station_);
        controller_.settle(station_,
                           // Waits for the plant's growth, which is fast enough for a hand, but not
                           // for this replay.
                           at_ms(now_ms_));
    }

    void settle()
    {
        controller_.settle(station_, at_ms(now_ms_));
        // Plants are freed on another thread, and nothing else waits for it.
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }

    std::size_t kept() const { return controller_.document().newest()->scene.associations.size(); }

    // True if the session contains exactly the strokes that were drawn and not undone.
    bool has_lost_nothing(fs::path const& path) const
    {
        auto const session = session::read_session(path, scene::core_edit_kinds());
        if (!session)
            return false;
        std::int64_t stroke = 0;
        for (auto const& edit : session->edits) {
            auto const* const drawn = edit.edit.get<scene::Associate>();
            if (!drawn || edit.step > session->step)
                continue;
            stroke += (stroke + 1) % kStrokesPerUndo == 0;
            auto const since = drawn->stroke.tips.front().time - at_ms(kCycle_ms * stroke++);
            if (since < Duration::zero() || since > std::chrono::milliseconds(kStroke_ms))
                return false;
        }
        return stroke + 1 == strokes_;
    }

private:
    static scene::Edit model()
    {
        return io::load_plant_edit(files::find_model("broadleaf").value()).value();
    }

    static station::Station new_station()
    {
        return station::Station::create(simple_rig(), {}).value();
    }

    station::Station station_ = new_station();
    controllers::StationController controller_;
    std::int64_t now_ms_ = 0;
    std::int64_t strokes_ = 0;
};

void draw_for_eight_hours(benchmark::State& state)
{
    batch::keep_freed_memory();
    auto const path
        = fs::temp_directory_path() / fmt::format("tractus-bench-{}.tractus", ::getpid());
    constexpr std::int64_t kCycles = 3'600'000 / kCycle_ms;
    for (auto _ : state) {
        fs::remove(path);
        Day day(path);
        for (std::int64_t hour = 1; hour <= kHours; ++hour) {
            for (std::int64_t i = 0; i < kCycles; ++i)
                day.cycle();
            day.settle();
            batch::return_freed_memory(); // The program's window calls this in pauses, too.
            auto const heap = ::mallinfo2();
            fmt::print(stderr, "# hour {}: {} strokes, {:.1f} MB resident, {:.1f} MB in use\n",
                       hour, day.kept(), resident_mb(),
                       static_cast<double>(heap.uordblks + heap.hblkhd) / 1e6);
        }
        if (!day.has_lost_nothing(path))
            state.SkipWithError("the session has not what was drawn");
    }
    fs::remove(path);
    report(state, { .items = kHours * kCycles, .item = "strokes" });
}
BENCHMARK(draw_for_eight_hours)->Iterations(1)->Unit(benchmark::kSecond);

} // namespace
} // namespace tractus
