#include "app/batch/plant_group.h"
#include "app/files/resources.h"
#include "app/io/glb_size.h"
#include "app/io/model_file.h"
#include "app/methods/all_methods.h"
#include "app/play/simulated_recording.h"
#include "engine/base/file.h"
#include "engine/export/glb_writer.h"
#include "engine/mesh/make_mesh.h"
#include "tests/app/our_plant.h"
#include "tests/app/replayed.h"

#include <gtest/gtest.h>
#include <sstream>
#include <tbb/task_arena.h>

namespace tractus::batch {
namespace {

// Returns the demo recording "station", in which every method is used in one document.
drivers::Log recording()
{
    return drivers::read_log(files::find_resource("demo/station.tractus-log").value()).value();
}

TEST(StationDemo, IsRecordedFromItsScriptByteForByte)
{
    auto const path = files::find_resource("demo/station.hand.toml").value();
    auto const script = sim::parse_gesture_script(read_file(path).value(), path.string()).value();
    std::ostringstream out;
    auto const written = play::write_simulated_recording(out, script, our_plant("birch"),
                                                         methods::all_methods().tools);
    ASSERT_TRUE(written) << written.error().message;
    auto const kept = read_file(files::find_resource("demo/station.tractus-log").value()).value();
    EXPECT_TRUE(out.str() == kept) << "record it again: its script says how";
    EXPECT_LT(kept.size(), 2'000'000u);
}

TEST(GlbSize, ANoteComesBeforeManyBytesAsBeforeManyTriangles)
{
    EXPECT_FALSE(io::large_glb_note({ .bytes = 100'000'000, .triangles = 5'000'000 }, {}));
    auto const note = io::large_glb_note({ .bytes = 431'000'000, .triangles = 4'000'000 }, {});
    ASSERT_TRUE(note);
    EXPECT_NE(note->find("431 MB"), std::string::npos) << *note;
    EXPECT_TRUE(io::large_glb_note({ .bytes = 90'000'000, .triangles = 5'000'001 }, {}));
}

TEST(StationDemo, DrawsWithEveryMethodInOneDocument)
{
    auto const [counts, scene, strokes] = replayed(recording(), {}, our_plant("birch"));
    EXPECT_EQ(strokes.size(), 13u);
    for (auto const& drawn : strokes)
        EXPECT_EQ(drawn.refusal, "") << drawn.tool.title();
    ASSERT_EQ(scene.plants.size(), 3u);
    auto const& tree = *scene.plants[1];
    EXPECT_TRUE(scene.plants[0]->drawn->name.ends_with("birch.l"));
    EXPECT_EQ(tree.drawn->name, "tree");
    EXPECT_EQ(tree.drawn->grafts.size(), 1u) << "a rule along a stroke is a limb of it";
    EXPECT_TRUE(tree.model_warnings.empty());
    EXPECT_GE(scene.plants[2]->base->organs.size(), 6u) << "the layer's nodes";
    EXPECT_EQ(scene.state.active, scene.plants[0]->drawn->id);
    EXPECT_EQ(scene.associations.size(), 1u);
    EXPECT_EQ(scene.indicators.size(), 1u);
    Timestamp const first = recording().records.front().time;
    Timestamp const last = recording().records.back().time;
    EXPECT_LT(last - first, std::chrono::minutes(3));
}

TEST(StationDemo, IsTheSameOnAnyNumberOfThreads)
{
    auto const exported = [](int threads) {
        std::ostringstream out;
        tbb::task_arena(threads).execute([&] {
            auto const scene = replayed(recording(), {}, our_plant("birch")).scene;
            auto const mesh = mesh::make_mesh(shown_plants(scene).value());
            exports::PlacedMesh placed;
            placed.mesh = &mesh;
            EXPECT_TRUE(exports::write_glb(out, std::span(&placed, 1)));
        });
        return out.str();
    };
    EXPECT_TRUE(exported(1) == exported(2));
}

} // namespace
} // namespace tractus::batch
