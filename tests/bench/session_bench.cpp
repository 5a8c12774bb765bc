// Measures a session of a thousand edits on a very large tree: the time to open it, and the time
// until one undo is visible. The tree is a published one with a million segments (ABoP figure 2.6),
// and its strokes belong to branches of all orders.
#include "app/batch/malloc_tuning.h"
#include "app/batch/session_plant.h"
#include "app/document/model_cost.h"
#include "tests/bench/monopodial_tree.h"
#include "tests/bench/report.h"

#include <cstdlib>
#include <filesystem>
#include <fmt/core.h>
#include <numeric>
#include <unistd.h>

namespace tractus {
namespace {

namespace fs = std::filesystem;

constexpr int kSteps = 20; // Number of derivation steps; 20 make 2^20 - 1 segments.
constexpr std::size_t kEdits = 1000;

Stroke bent_stroke(std::size_t number)
{
    Stroke stroke;
    for (int i = 0; i < 200; ++i) {
        double const along = i / 200.0;
        stroke.tips.push_back(
            { .time
              = timestamp_ns(static_cast<std::int64_t>(number) * 1'000'000'000 + i * 5'000'000),
              .position_mm = { 90 * along * along, 0.1 * static_cast<double>(number), 200 * along },
              .pressure = 0.5,
              .touching = true });
    }
    return stroke;
}

session::SessionOptions options()
{
    return session::session_by_the_clock(scene::core_edit_kinds(),
                                         [] { return document::load_options(); });
}

// A session in which half of the edits select a branch, and the others bend it with a stroke.
class BigSession {
public:
    BigSession()
        : path_(fs::temp_directory_path() / fmt::format("tractus-bench-{}.tractus", ::getpid()))
    {
        batch::keep_freed_memory(); // The program's window calls this, too.
        fs::remove(path_);
        scene::Edit const model
            = scene::LoadModel { .source = { .name = "tree.l", .text = kMonopodialTree },
                                 .steps = kSteps };
        auto session = batch::begin_session(path_, { model }, scene::core_edit_kinds()).value();
        auto const& plant = *session.scene().base;
        for (std::size_t i = 0; i < kEdits / 2; ++i) {
            auto const axis = plant.axes[i * plant.axes.size() / (kEdits / 2)];
            std::vector<SegmentId> path(axis.segment_count);
            std::iota(path.begin(), path.end(), axis.first_segment);
            std::vector<scene::Edit> const edits { scene::select_paths(session.scene(), { path }),
                                                   scene::Associate { bent_stroke(i) } };
            if (!session.append(edits))
                std::abort();
        }
    }
    BigSession(BigSession const&) = delete;
    BigSession& operator=(BigSession const&) = delete;
    ~BigSession()
    {
        for (char const* const ending : { "", "-wal", "-shm" })
            fs::remove(path_.string() + ending);
    }

    fs::path const& path() const { return path_; }

private:
    fs::path path_;
};

void open_a_thousand_edits(benchmark::State& state)
{
    BigSession const big;
    for (auto _ : state)
        benchmark::DoNotOptimize(session::Session::open(big.path(), options()).value().step());
    report(state, { .items = kEdits, .item = "edits" });
}
BENCHMARK(open_a_thousand_edits)->Iterations(3)->Unit(benchmark::kMillisecond)->UseRealTime();

void undo_among_a_thousand_edits(benchmark::State& state)
{
    BigSession const big;
    auto session = session::Session::open(big.path(), options()).value();
    for (auto _ : state)
        if (!session.undo())
            state.SkipWithError("it cannot be undone");
    report(state, { .items = 1, .item = "steps" });
}
BENCHMARK(undo_among_a_thousand_edits)
    ->Iterations(200)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
} // namespace tractus
