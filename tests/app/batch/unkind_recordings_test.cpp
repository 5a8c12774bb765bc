#include "app/files/resources.h"
#include "app/play/simulated_recording.h"
#include "app/tools/tool.h"
#include "drivers/logs/log.h"
#include "engine/base/file.h"
#include "tests/app/our_plant.h"
#include "tests/app/replayed.h"

#include <algorithm>
#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

// Tests that draw the recordings that come with the program again, with simulated faults of the
// hand, the tablet and the computer. The resulting plants must be of the same kind.
namespace tractus::batch {
namespace {

namespace fs = std::filesystem;

// Properties of a plant that a person would notice at a glance. Sizes are compared separately.
struct KindOfPlant {
    std::string name;
    std::size_t grafts = 0;
    std::size_t associations = 0;
    std::size_t indicators = 0;
    bool operator==(KindOfPlant const&) const = default;
};

void PrintTo(KindOfPlant const& kind, std::ostream* out)
{
    *out << kind.name << " with " << kind.grafts << " grafts, " << kind.associations
         << " associations and " << kind.indicators << " indicators";
}

KindOfPlant kind_of(scene::BuiltPlant const& plant)
{
    return { .name = plant.drawn ? fs::path(plant.drawn->name).filename().string() : "",
             .grafts = plant.drawn ? plant.drawn->grafts.size() : 0,
             .associations = plant.associations.size(),
             .indicators = plant.indicators.size() };
}

Vec3 size_mm(Plant const& plant)
{
    Eigen::AlignedBox3d box;
    for (auto const& place_mm : plant.node_position_mm)
        box.extend(place_mm);
    return box.sizes();
}

AxisId first_axis(scene::BuiltPlant const& plant, std::size_t association)
{
    return axis_of(*plant.base, plant.associations[association].what.path.front());
}

std::string unkind_recording(sim::GestureScript script, std::uint64_t seed,
                             scene::Scene const& scene)
{
    script.seed = seed;
    script.unkindness = sim::all_unkindness(seed);
    std::ostringstream out;
    auto const written
        = play::write_simulated_recording(out, script, scene, methods::all_methods().tools);
    EXPECT_TRUE(written) << written.error().message;
    return out.str();
}

void expect_the_same_kind(drivers::Log const& log, scene::Scene const& before,
                          Replayed const& meant)
{
    auto const drawn = replayed(log, {}, before);
    std::size_t strokes = 0;
    for (auto const& stroke : drawn.strokes)
        strokes += stroke.refusal.empty();
    EXPECT_GE(strokes, meant.strokes.size());
    ASSERT_EQ(drawn.scene.plants.size(), meant.scene.plants.size());
    for (std::size_t i = 0; i < meant.scene.plants.size(); ++i) {
        auto const& found = *drawn.scene.plants[i];
        auto const& expected = *meant.scene.plants[i];
        EXPECT_EQ(kind_of(found), kind_of(expected));
        // With a hook or a tremor, a stroke may select the branch next to the intended one. A
        // person would see that, so one such stroke is allowed.
        auto const count = std::min(found.associations.size(), expected.associations.size());
        std::size_t others = 0;
        for (std::size_t k = 0; k < count; ++k)
            others += first_axis(found, k) != first_axis(expected, k);
        EXPECT_LE(others, 1u);
        double const height_mm = size_mm(*expected.base).z();
        EXPECT_NEAR(size_mm(*found.base).z(), height_mm, 0.15 * height_mm);
        // An outlined tree has random branches that were not drawn, and their number depends on the
        // outline.
        auto const segments = static_cast<double>(found.base->segment_count());
        auto const meant_segments = static_cast<double>(expected.base->segment_count());
        EXPECT_GE(segments, 0.5 * meant_segments);
        EXPECT_LE(segments, 2 * meant_segments);
    }
}

class UnkindDemo : public ::testing::TestWithParam<char const*> { };

TEST_P(UnkindDemo, DrawsTheSameKindOfPlants)
{
    std::string const name = GetParam();
    auto const before = our_plant(name == "station" ? "birch" : name);
    auto const file = [&](char const* kind) {
        return files::find_resource(fmt::format("demo/{}.{}", name, kind)).value();
    };
    auto const script
        = sim::parse_gesture_script(read_file(file("hand.toml")).value(), name).value();
    auto const meant = replayed(drivers::read_log(file("tractus-log")).value(), {}, before);
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        auto const text = unkind_recording(script, seed, before);
        expect_the_same_kind(drivers::parse_log(text, name).value(), before, meant);
    }
}

INSTANTIATE_TEST_SUITE_P(All, UnkindDemo,
                         ::testing::Values("broadleaf", "conifer", "daisy", "shrub", "station"),
                         [](auto const& test) { return std::string(test.param); });

// Returns a script that draws the strokes of a recording again, with their tools.
sim::GestureScript script_of(drivers::Log const& log, Replayed const& drawn)
{
    sim::GestureScript script;
    // In these recordings, a single tool draws the whole plant.
    auto const& last = log.tools.back();
    // New drawings read construction lines with the option "together", which the recordings lack.
    auto const* const reading = last.tool == "construction_line" ? " together" : "";
    for (auto const& stroke : drawn.strokes) {
        sim::PolylineShape line;
        for (auto const& tip : stroke.stroke.tips)
            if (line.points_mm.empty() || (tip.position_mm - line.points_mm.back()).norm() > 1)
                line.points_mm.push_back(tip.position_mm);
        script.gestures.push_back(
            { .tool = last.tool, .words = last.arguments + reading, .path = line });
    }
    return script;
}

TEST(UnkindFirstPlants, AreOfTheSameKind)
{
    std::uint64_t count = 0;
    for (auto const& entry :
         fs::directory_iterator(files::find_resource("demo/first-plants").value())) {
        auto const name = entry.path().stem().string();
        auto const before = name.starts_with("strokes") ? our_plant("birch") : scene::Scene {};
        station::ReplayOptions options;
        if (name.ends_with("tablet"))
            options.height = calib::parse_height_scenario("100").value();
        auto const log = drivers::read_log(entry.path()).value();
        auto const meant = replayed(log, options, before);
        auto const seed = 1 + count++ % 3;
        SCOPED_TRACE(fmt::format("{}, seed {}", name, seed));
        auto const text = unkind_recording(script_of(log, meant), seed, before);
        expect_the_same_kind(drivers::parse_log(text, name).value(), before, meant);
    }
    EXPECT_EQ(count, 15u);
}

} // namespace
} // namespace tractus::batch
