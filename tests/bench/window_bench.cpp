// Measures the work of the station's window, without the graphics card, at 60 frames a second,
// while plants grow in the background. "ink" is the elapsed time from a frame's reports to the
// vertices of their ink in the draw list; the machine must be idle for it. "cpu" is the processor
// time of a whole frame.
//
// The times are the 99th percentile of the frames (p99) or the median. A minute of drawing also
// shows rare delays: the 99.9th percentile of the time from the moment at which a frame's reports
// were due to their ink. Beside it stands the delay of a thread that only sleeps until the same
// moments, because such delays are due to the system and not to the station.
#include "app/batch/malloc_tuning.h"
#include "app/view/station_view.h"
#include "app/window/view_curves.h"
#include "tests/app/simple_rig.h"
#include "tests/bench/report.h"
#include "tests/engine/mesh/sample_plants.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <memory>
#include <sys/resource.h>
#include <thread>
#include <vector>

namespace tractus {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kFrames = 240;
constexpr int kFramesPerStroke = 60;
constexpr int kPenReports = 4;     // Number of reports in a frame, from a pen with 250 Hz.
constexpr int kHeightReports = 16; // Number of readings in a frame, from a sensor with 1 kHz.

// Returns a plant of a trunk with limbs and twigs, with the given number of segments in axes of a
// hundred.
Plant big_plant(std::size_t segments)
{
    constexpr std::uint32_t kAxis = 100;
    Random random({ .seed = 1 });
    Plant plant;
    plant.materials = { {} };
    mesh::AxisSketch sketch {
        .segment_mm = 20, .segment_count = kAxis, .radius_mm = 60, .bend_rad = 0.05
    };
    mesh::append_axis(plant, sketch, random);
    for (AxisId parent = 0; plant.segment_count() < segments; ++parent) {
        auto const axis = plant.axes[parent];
        for (std::uint32_t i = 10; i < kAxis && plant.segment_count() < segments; i += 4) {
            sketch.base_mm = plant.node_position_mm[axis.first_node + i + 1];
            sketch.direction = Vec3(random.normal(), random.normal(), 0.5 + random.normal());
            sketch.segment_mm = 20.0 / (2 + axis.order);
            sketch.radius_mm = 0.4 * static_cast<double>(plant.node_radius_mm[axis.first_node + i]);
            sketch.tip_radius_mm = 0.4 * sketch.radius_mm;
            sketch.parent_segment = axis.first_segment + i;
            sketch.parent_axis = parent;
            sketch.order = axis.order + 1;
            mesh::append_axis(plant, sketch, random);
        }
    }
    return plant;
}

scene::Scene scene_of(std::size_t segments)
{
    scene::Scene scene;
    auto plant = big_plant(segments);
    scene.placement = scene::place_on_desk(plant);
    scene.base = std::make_shared<Plant const>(std::move(plant));
    scene.rest = variation::SharedRestShape(scene.base);
    return scene;
}

// When the plant grows: always, as while a slider moves, or when a stroke has changed it.
enum class Growing { Always, AfterStrokes };

// A hand that draws circles, one stroke a second. Each stroke is for the next branch.
class Drawing {
public:
    explicit Drawing(scene::Scene scene, Growing growing = Growing::Always)
        : growing_(growing)
        , document_(std::move(scene), document::Document::Working::OnItsThread)
        , view_(station_, document_)
    {
        batch::keep_freed_memory(); // The program's window calls this, too.
    }

    struct Took {
        double ink_s = 0; // Elapsed time from taking the reports to the vertices of their ink.
        double cpu_s = 0; // Processor time of the thread for the whole frame.
    };

    Took frame()
    {
        if (growing_ == Growing::Always && !view_.state().is_growing)
            view_.preview({ {}, ++seed_ });
        auto const begin = Clock::now();
        double const begin_s = cpu_s();
        push_reports();
        for (auto& stroke : station_.take_strokes())
            document_.draw(std::move(stroke));
        (void)document_.take_finished_strokes();
        view_.show(station_, document_);
        benchmark::DoNotOptimize(window::pad_live_curves(view_.state()).data());
        std::chrono::duration<double> const ink = Clock::now() - begin;
        if (follow(view_.state().strokes_revision, strokes_))
            benchmark::DoNotOptimize(window::pad_stroke_curves(view_.state()).data());
        if (follow(view_.state().preview_revision, preview_)) {
            benchmark::DoNotOptimize(window::pad_preview_curves(view_.state()).data());
            benchmark::DoNotOptimize(window::preview_curves(view_.state()).data());
        }
        if (follow(view_.state().skeleton_revision, skeleton_)) {
            benchmark::DoNotOptimize(window::pad_skeleton_curves(view_.state()).data());
            benchmark::DoNotOptimize(window::skeleton_curves(view_.state()).data());
        }
        return { ink.count(), cpu_s() - begin_s };
    }

private:
    static double cpu_s()
    {
        timespec time {};
        ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    static bool follow(std::uint64_t revision, std::uint64_t& seen)
    {
        return std::exchange(seen, revision) != revision;
    }

    void push_reports()
    {
        for (int i = 0; i < kHeightReports; ++i) {
            now_us_ += 1000;
            station_.push(kHeight, timestamp_ns(now_us_ * 1000), height_report(2000 + i % 3));
            if (i % (kHeightReports / kPenReports) != 0)
                continue;
            double const turn = 0.02 * static_cast<double>(++samples_);
            bool const touches = samples_ % (kPenReports * kFramesPerStroke) != 0;
            station_.push(kPen, timestamp_ns(now_us_ * 1000),
                          pen_report(100 + 40 * std::cos(turn), 70 + 40 * std::sin(turn), touches));
        }
    }

    Growing growing_;
    station::Station station_ = station::Station::create(simple_rig(), {}).value();
    document::Document document_;
    view::StationView view_;
    std::int64_t now_us_ = 0;
    std::int64_t samples_ = 0;
    std::uint64_t seed_ = 0;
    std::uint64_t strokes_ = 0;
    std::uint64_t preview_ = 0;
    std::uint64_t skeleton_ = 0;
};

void frames_while_drawing(benchmark::State& state, double Drawing::Took::*part, double percentile)
{
    Drawing drawing(scene_of(static_cast<std::size_t>(state.range(0))));
    drawing.frame(); // The first frame includes one-time work.
    for (auto _ : state) {
        std::vector<double> took_s;
        auto next = Clock::now();
        for (int i = 0; i < kFrames; ++i) {
            std::this_thread::sleep_until(next += std::chrono::microseconds(16'667));
            took_s.push_back(drawing.frame().*part);
        }
        auto const at = static_cast<std::ptrdiff_t>(percentile * (kFrames - 1));
        std::nth_element(took_s.begin(), took_s.begin() + at, took_s.end());
        state.SetIterationTime(took_s[static_cast<std::size_t>(at)]);
    }
    report(state, { .items = 1, .item = "frames" });
}

void ink_p99(benchmark::State& state)
{
    frames_while_drawing(state, &Drawing::Took::ink_s, 0.99);
}
void frame_cpu_median(benchmark::State& state)
{
    frames_while_drawing(state, &Drawing::Took::cpu_s, 0.5);
}
void frame_cpu_p99(benchmark::State& state)
{
    frames_while_drawing(state, &Drawing::Took::cpu_s, 0.99);
}

// Measures the pages of memory that are touched for the first time while somebody draws, after a
// few seconds in which the program has taken what it needs.
void faults_while_drawing(benchmark::State& state)
{
    constexpr int kFramesPerSecond = 60;
    constexpr int kWarmUp_s = 5;
    constexpr int kMeasured_s = 20;
    Drawing drawing(scene_of(static_cast<std::size_t>(state.range(0))), Growing::AfterStrokes);
    auto next = Clock::now();
    auto const draw_for = [&](int seconds) {
        for (int i = 0; i < seconds * kFramesPerSecond; ++i) {
            std::this_thread::sleep_until(next += std::chrono::microseconds(16'667));
            drawing.frame();
        }
    };
    auto const faults = [] {
        rusage usage {};
        ::getrusage(RUSAGE_SELF, &usage);
        return static_cast<double>(usage.ru_minflt);
    };
    draw_for(kWarmUp_s);
    double counted = 0;
    for (auto _ : state) {
        auto const before = faults();
        draw_for(kMeasured_s);
        counted = faults() - before;
        state.SetIterationTime(kMeasured_s);
    }
    report(state, { .items = counted, .item = "faults", .faults = counted });
}
BENCHMARK(faults_while_drawing)->Arg(2'000)->Arg(50'000)->Iterations(1)->UseManualTime();

struct Minute {
    std::vector<double> ink_s {}; // Time from waking up until the ink's vertices are ready.
    // Time from the moment at which the reports were due until the ink's vertices are ready.
    std::vector<double> late_ink_s {};
    std::vector<double> late_idle_s {}; // Delay with which the idle thread wakes up.
};

// Returns the measurements of a minute of drawing while a plant of 1.3 million segments grows on
// all cores. The first call makes them.
Minute const& minute_of_drawing()
{
    static Minute const minute = [] {
        constexpr int kMinute = 60 * 60;
        constexpr auto kFrame = std::chrono::microseconds(16'667);
        auto const seconds_since = [](Clock::time_point moment) {
            return std::chrono::duration<double>(Clock::now() - moment).count();
        };
        Drawing drawing(scene_of(1'300'000));
        drawing.frame(); // The first frame includes one-time work.
        Minute result;
        auto const begin = Clock::now();
        std::thread idle([&] {
            for (int i = 1; i <= kMinute; ++i) {
                std::this_thread::sleep_until(begin + i * kFrame);
                result.late_idle_s.push_back(seconds_since(begin + i * kFrame));
            }
        });
        for (int i = 1; i <= kMinute; ++i) {
            std::this_thread::sleep_until(begin + i * kFrame);
            auto const late_s = seconds_since(begin + i * kFrame);
            auto const ink_s = drawing.frame().ink_s;
            result.ink_s.push_back(ink_s);
            result.late_ink_s.push_back(late_s + ink_s);
        }
        idle.join();
        return result;
    }();
    return minute;
}

void minute_of_ink(benchmark::State& state, std::vector<double> Minute::*part, double percentile)
{
    auto times_s = minute_of_drawing().*part;
    auto const at
        = static_cast<std::ptrdiff_t>(percentile * static_cast<double>(times_s.size() - 1));
    std::nth_element(times_s.begin(), times_s.begin() + at, times_s.end());
    for (auto _ : state)
        state.SetIterationTime(times_s[static_cast<std::size_t>(at)]);
    report(state, { .items = 1, .item = "frames" });
}
BENCHMARK_CAPTURE(minute_of_ink, ink_p99, &Minute::ink_s, 0.99)->Iterations(1)->UseManualTime();
BENCHMARK_CAPTURE(minute_of_ink, late_ink_p999, &Minute::late_ink_s, 0.999)
    ->Iterations(1)
    ->UseManualTime();
BENCHMARK_CAPTURE(minute_of_ink, late_idle_p999, &Minute::late_idle_s, 0.999)
    ->Iterations(1)
    ->UseManualTime();

// Measures closing the window while a plant grows and is prepared for display. The result is the
// longest time over many moments of closing.
void close_while_growing(benchmark::State& state)
{
    auto scene = scene_of(static_cast<std::size_t>(state.range(0)));
    scene.growth.parameters.sag = 1;
    auto const closed_after_s = [&](Clock::duration moment) {
        auto drawing = std::make_unique<Drawing>(scene);
        std::this_thread::sleep_for(moment);
        auto const begin = Clock::now();
        drawing.reset();
        return std::chrono::duration<double>(Clock::now() - begin).count();
    };
    constexpr auto kEvery = std::chrono::milliseconds(100);
    constexpr int kMoments = 40;
    for (auto _ : state) {
        double longest_s = 0;
        for (int i = 0; i < kMoments; ++i)
            longest_s = std::max(longest_s, closed_after_s(i * kEvery));
        state.SetIterationTime(longest_s);
    }
    report(state, { .items = 1, .item = "closings" });
}
BENCHMARK(close_while_growing)->Arg(1'300'000)->Iterations(1)->UseManualTime();
BENCHMARK(ink_p99)->Arg(50'000)->Arg(1'300'000)->Iterations(1)->UseManualTime();
BENCHMARK(frame_cpu_median)->Arg(50'000)->Arg(1'300'000)->Iterations(1)->UseManualTime();
BENCHMARK(frame_cpu_p99)->Arg(50'000)->Arg(1'300'000)->Iterations(1)->UseManualTime();

} // namespace
} // namespace tractus
