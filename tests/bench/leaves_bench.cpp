// Measures leaves of all species that come with the program, all different: a thousand of them
// painted and packed as three maps of 512 pixels each, one by one, and ten thousand grown and
// triangulated. Also reports the number of memory pages touched for the first time ("minor
// faults"), and the peak memory use.
#include "app/methods/leaves/leaf_library.h"
#include "app/methods/leaves/leaf_maps.h"
#include "app/methods/leaves/leaf_study.h"
#include "engine/base/parallel.h"
#include "tests/bench/report.h"

#include <fmt/core.h>
#include <sys/resource.h>

namespace tractus {
namespace {

constexpr int kSide = 512;

std::vector<leaf::Grammar> grammars()
{
    std::vector<leaf::Grammar> made;
    for (auto const& name : leaf::leaf_names())
        made.push_back(leaf::load_leaf_grammar(name).value());
    return made;
}

leaf::LeafLife life_of(std::size_t i)
{
    return { .age = 0.3 + 0.6 * double(i % 97) / 96, .seed = i };
}

leaf::PaintOptions paint_of(leaf::Grammar const& grammar, std::size_t i)
{
    auto options = leaf::paint_options(grammar, life_of(i));
    options.side = kSide;
    options.larvae.count = i % 4 == 0 ? 3 : 0;
    options.spots = i % 5 == 0 ? 0.3 : 0;
    return options;
}

struct Used {
    Used() { ::getrusage(RUSAGE_SELF, &usage); }
    rusage usage {};
};

// Prints the time and memory used since `before`. Peak memory counts from the program's start.
void say(char const* what, Used const& before, double items)
{
    Used const now;
    fmt::print(stderr, "# {}: {:.1f} minor faults each, {:.0f} MB at most\n", what,
               double(now.usage.ru_minflt - before.usage.ru_minflt) / items,
               double(now.usage.ru_maxrss) / 1024);
}

std::size_t packed_bytes(leaf::LeafPicture const& picture)
{
    return leaf::packed_map(picture.color).size() + leaf::packed_map(picture.normal).size()
        + leaf::packed_map(picture.roughness).size();
}

void leaves_with_maps(benchmark::State& state)
{
    constexpr std::size_t kLeaves = 1000;
    auto const species = grammars();
    double bytes = 0;
    for (auto _ : state) {
        Used const before;
        std::size_t next = 0;
        auto const slots = static_cast<std::size_t>(thread_count()) + 1;
        std::vector<leaf::LeafPainter> painters(slots);
        std::vector<std::size_t> number(slots);
        std::vector<std::size_t> packed(slots);
        bytes = 0;
        parallel_in_order(slots,
                          { .next =
                                [&](std::size_t slot) {
                                    number[slot] = next;
                                    return next++ < kLeaves;
                                },
                            .make =
                                [&](std::size_t slot) {
                                    auto const i = number[slot];
                                    auto const& grammar = species[i % species.size()];
                                    auto const grown = leaf::grow_leaf(grammar, life_of(i)).value();
                                    packed[slot] = packed_bytes(painters[slot].paint(
                                        grown.leaf, grown.triangles, paint_of(grammar, i)));
                                },
                            .use =
                                [&](std::size_t slot) {
                                    bytes += double(packed[slot]);
                                    return true;
                                } });
        say("leaves with three maps", before, kLeaves);
    }
    report(state, { .items = kLeaves, .item = "leaves" });
    state.counters["bytes_each"] = bytes / kLeaves;
}
BENCHMARK(leaves_with_maps)->Unit(benchmark::kSecond)->UseRealTime();

// Measures the update of a leaf in the window while the user drags a slider.
void leaf_with_maps(benchmark::State& state)
{
    auto const grammar = leaf::load_leaf_grammar("maple").value();
    leaf::LeafPainter painter;
    std::size_t i = 0;
    for (auto _ : state) {
        auto const grown = leaf::grow_leaf(grammar, life_of(++i)).value();
        benchmark::DoNotOptimize(
            painter.paint(grown.leaf, grown.triangles, paint_of(grammar, i)).color.data());
    }
    report(state, { .item = "leaves" });
}
BENCHMARK(leaf_with_maps)->Unit(benchmark::kMillisecond)->UseRealTime();

// Measures the update of the window's page of leaves while the user drags a slider. The page has
// one leaf with four maps, and six other leaves.
void leaf_study(benchmark::State& state)
{
    auto const grammar = leaf::load_leaf_grammar("maple").value();
    double age = 0;
    for (auto _ : state) {
        age = age < 0.99 ? age + 0.01 : 0;
        benchmark::DoNotOptimize(leaf::study_leaf(
            grammar, { .age = age, .damage = { .spots = 0.3, .larvae = 2 } }, { 250, 250, 248 }));
    }
    report(state, { .item = "pages" });
}
BENCHMARK(leaf_study)->Unit(benchmark::kMillisecond)->UseRealTime();

void leaf_meshes(benchmark::State& state)
{
    constexpr std::size_t kLeaves = 10'000;
    auto const species = grammars();
    for (auto _ : state) {
        Used const before;
        parallel_for(kLeaves, 32, [&](std::size_t begin, std::size_t end) {
            for (auto i = begin; i < end; ++i)
                benchmark::DoNotOptimize(leaf::grow_leaf(species[i % species.size()], life_of(i)));
        });
        say("leaf meshes", before, kLeaves);
    }
    report(state, { .items = kLeaves, .item = "leaves" });
}
BENCHMARK(leaf_meshes)->Unit(benchmark::kSecond)->UseRealTime();

} // namespace
} // namespace tractus
