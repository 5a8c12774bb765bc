#include "app/batch/session_export.h"

#include "app/batch/session_plant.h"
#include "app/io/model_file.h"
#include "app/methods/all_methods.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "engine/plant/mtg.h"
#include "tests/app/small_model.h"
#include "tests/file_bytes.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tractus::batch {
namespace {

// A session file may come from an untrusted author.
TEST(SessionExport, WritesNothingOutsideOfItsFolder)
{
    auto const folder = std::filesystem::temp_directory_path()
        / ("tractus_session_export_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    for (std::string const name : { "../escaped", "/tmp/tractus_escaped", "a/../../escaped", "" }) {
        auto model = small_model();
        model.source.name = "../../..";
        model.includes[name] = "harm";
        auto const path = folder / "a.tractus";
        std::filesystem::remove(path);
        ASSERT_TRUE(begin_session(path, { model }, scene::core_edit_kinds()));
        auto const written = export_session(path, folder / "inner", scene::core_edit_kinds());
        ASSERT_FALSE(written) << name;
        EXPECT_NE(written.error().message.find("outside the model's folder"), std::string::npos);
        EXPECT_TRUE(std::filesystem::exists(folder / "inner" / "model.l"));
        EXPECT_FALSE(std::filesystem::exists(folder / "escaped"));
    }
    EXPECT_FALSE(std::filesystem::exists("/tmp/tractus_escaped"));
    std::filesystem::remove_all(folder);
}

// The exported models of plants and parts that were made by methods must derive to the same plants.
TEST(SessionExport, GivesEachPlantAndPartItsFiles)
{
    auto const folder = std::filesystem::temp_directory_path()
        / ("tractus_session_export_parts_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    sketch::GrowAlongStroke sketch { .rule = { .shortest_mm = 8 } };
    sketch.stroke = stroke_through({ { 60, 0, 0 }, { 80, 10, 70 }, { 60, 20, 150 } });
    silhouette::DrawTree const stem { .part = silhouette::DrawTree::Part::Trunk,
                                      .stroke = stroke_through({ { 99, -60, 9 }, { 99, 5, 9 } }),
                                      .stands_at_mm = { 99, 0, 0 } };
    std::vector<scene::Edit> edits { small_model(), sketch, stem };
    auto const before = scene::apply_edits({}, edits).value();
    auto const& host = *before.plants[0];
    auto const part = before.plants[1]->drawn->id;
    edits.push_back(
        scene::GraftPlant { part, host.drawn->id, host.rest->addresses.address_of(*host.base, 2) });
    auto const kinds = methods::all_methods().edits;
    ASSERT_TRUE(begin_session(folder / "a.tractus", edits, kinds));
    auto const written = export_session(folder / "a.tractus", folder / "files", kinds).value();
    EXPECT_EQ(file_bytes(folder / "files" / "small.l"), small_model().source.text);
    auto const model = folder / "files" / "sketch-2" / "sketch.l";
    auto const alone
        = scene::apply_edits({}, std::vector<scene::Edit> { io::load_model_edit(model).value() })
              .value();
    EXPECT_EQ(alone.base->node_position_mm, before.plants[1]->base->node_position_mm);
    EXPECT_EQ(alone.base->organs.size(), before.plants[1]->base->organs.size());
    auto const graph = file_bytes(folder / "files" / "tree-3" / "tree.mtg");
    EXPECT_EQ(parse_mtg("tree.mtg", graph).value().axes.size(), 1u);
    EXPECT_EQ(file_bytes(folder / "files" / "plants.txt"),
              "plant 1: small.l at 0.0, 0.0, 0.0 mm\n"
              "part 2: sketch on plant 1\n"
              "plant 3: tree at 99.0, 0.0, 0.0 mm, takes what is drawn\n");
    for (auto const& file : written)
        EXPECT_TRUE(std::filesystem::exists(file)) << file;
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace tractus::batch
