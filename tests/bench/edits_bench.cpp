// Measures steps of all methods on plants of 50,000 segments and more. The time is from a finished
// stroke, or from an undo, to the document's next snapshot.
#include "app/batch/malloc_tuning.h"
#include "app/document/document.h"
#include "app/methods/all_methods.h"
#include "tests/app/methods/pairs/random_hand.h"
#include "tests/bench/monopodial_tree.h"
#include "tests/bench/report.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fmt/core.h>
#include <map>

namespace tractus {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kSegments = 50'000;
constexpr std::size_t kMaxSegments = 100'000;
constexpr std::size_t kSteps = 1000;
constexpr int kTreeSteps = 16; // Number of derivation steps; 16 make 2^16 - 1 segments.

std::size_t segment_count(scene::Scene const& scene)
{
    std::size_t count = 0;
    for (auto const& plant : scene.plants)
        count += plant->base->segment_count();
    return count;
}

// Durations of the steps of a simulated hand that draws at random, in seconds.
class RandomSteps {
public:
    RandomSteps()
    {
        batch::keep_freed_memory(); // The program's window calls this, too.
        while (seconds_.size() < kSteps) {
            auto const segments = segment_count(document_.newest()->scene);
            if (segments < kSegments)
                plant_tree();
            else if (segments > kMaxSegments)
                document_.undo();
            else if (hand_.happens(0.1))
                add("undo", time_of([&] { document_.undo(); }));
            else if (hand_.happens(0.05))
                add("redo", time_of([&] { document_.redo(); }));
            else
                draw();
        }
    }

    // Returns the time within which the given share of the steps was done.
    double within(double share) const
    {
        auto sorted = seconds_;
        std::ranges::sort(sorted);
        return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    }

    // Statistics of a tool, of undo or of redo: the number of steps, the longest time of a step,
    // and the number of segments at that step.
    struct Kind {
        std::size_t count = 0;
        double longest_s = 0;
        std::size_t segments = 0;
    };
    std::map<std::string, Kind> const& kinds() const { return kinds_; }

private:
    void plant_tree()
    {
        document_.make({ [](scene::Scene const&) -> Result<document::StepRequest::Change> {
            return document::StepRequest::Change {
                { scene::LoadModel { .source = { .name = "tree.l", .text = kMonopodialTree },
                                     .steps = kTreeSteps,
                                     .drawn = scene::Drawn::Beside } },
                ""
            };
        } });
    }

    // Draws a stroke. Refused strokes do not count as steps.
    void draw()
    {
        auto stroke = hand_.stroke(document_.newest()->scene);
        auto const* const word = stroke.tool.kind().word;
        auto const took = time_of([&] { document_.draw(std::move(stroke)); });
        for (auto const& drawn : document_.take_finished_strokes()) {
            if (!drawn.refusal.empty())
                continue;
            hand_.has_done(drawn.tool);
            add(word, took);
        }
    }

    template<typename Step> static double time_of(Step const& step)
    {
        auto const begin = Clock::now();
        step();
        return std::chrono::duration<double>(Clock::now() - begin).count();
    }

    // Adds a step. Steps on plants of more than kMaxSegments segments are left out, since the
    // methods' own benchmarks measure them.
    void add(std::string const& what, double took)
    {
        auto const now = segment_count(document_.newest()->scene);
        if (now > kMaxSegments)
            return;
        seconds_.push_back(took);
        auto& [count, longest, segments] = kinds_[what];
        ++count;
        if (took > longest) {
            longest = took;
            segments = now;
        }
    }

    document::Document document_ { scene::Scene {}, document::Document::Working::AtOnce };
    methods::RandomHand hand_ { 4 };
    std::vector<double> seconds_;
    std::map<std::string, Kind> kinds_;
};

void print_kinds(RandomSteps const& steps)
{
    for (auto const& [word, kind] : steps.kinds())
        fmt::print(stderr, "{:20} {:4} steps, at most {:6.1f} ms, with {} segments\n", word,
                   kind.count, 1000 * kind.longest_s, kind.segments);
}

// Runs the steps once. If the environment variable TRACTUS_BENCH_EACH_TOOL is set, prints the
// longest step of each kind.
RandomSteps const& random_steps()
{
    static RandomSteps const steps;
    static bool const is_printed
        = std::getenv("TRACTUS_BENCH_EACH_TOOL") != nullptr && (print_kinds(steps), true);
    static_cast<void>(is_printed);
    return steps;
}

void random_step(benchmark::State& state)
{
    auto const& steps = random_steps();
    for (auto _ : state)
        state.SetIterationTime(steps.within(static_cast<double>(state.range(0)) / 100));
    report(state, { .item = "steps" });
}
BENCHMARK(random_step)
    ->ArgName("percent_within")
    ->Arg(50)
    ->Arg(99)
    ->Arg(100)
    ->UseManualTime()
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace tractus
