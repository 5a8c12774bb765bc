#include "tests/app/command_line/workshop.h"

#include <cstring>
#include <nlohmann/json.hpp>

namespace tractus {
namespace {

class Organs : public Workshop {
protected:
    // Returns the JSON chunk of a .glb file.
    nlohmann::json json_of(std::string const& name) const
    {
        auto const glb = read(name);
        std::uint32_t size = 0;
        std::memcpy(&size, &glb.at(12), 4);
        return nlohmann::json::parse(glb.substr(20, size));
    }
};

TEST_F(Organs, AreTrianglesOfThePlantsMeshUnlessAskedOtherwise)
{
    EXPECT_EQ(run("tractus grow leaf -o plain.glb").exit_code, 0);
    auto const plain = json_of("plain.glb");
    EXPECT_EQ(plain["nodes"].size(), 1u);
    EXPECT_EQ(plain["extensionsUsed"], nlohmann::json({ "KHR_materials_diffuse_transmission" }))
        << "translucent leaves, no instances and no compression";
    EXPECT_EQ(run("tractus grow leaf --organs merged -o merged.glb").exit_code, 0);
    EXPECT_EQ(read("merged.glb"), read("plain.glb"));
}

TEST_F(Organs, AreInstancedOrNodesInEveryCommandThatIsAskedForIt)
{
    record();
    auto const commands = {
        std::pair<std::string, std::string> { "grow broadleaf -n 9 -o ", "" },
        { "vary daisy --count 2 -o ", "" },
        { "replay hand.tractus-log --plant daisy --count 2 -o folder --organs ", "folder" },
        { "demo --plant daisy -o demo --organs ", "demo" },
    };
    for (auto const& [command, folder] : commands)
        for (std::string const how : { "instanced", "nodes", "merged" }) {
            auto const file = folder.empty() ? how + ".glb" : folder + "/collection.glb";
            auto const rest = folder.empty() ? file + " --organs " + how : how;
            auto const outcome = run("tractus " + command + rest);
            ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
            auto const json = json_of(file);
            std::size_t const plants = json["scenes"][0]["nodes"].size();
            EXPECT_EQ(json.contains("extensionsRequired"), how == "instanced") << command << how;
            if (how == "nodes") {
                EXPECT_GT(json["nodes"].size(), 2 * plants) << command;
            } else if (how == "merged") {
                EXPECT_EQ(json["nodes"].size(), plants) << command;
            }
        }
}

TEST_F(Organs, AreOfSmallerVerticesWhereThatIsAskedFor)
{
    EXPECT_EQ(run("tractus grow broadleaf -n 9 -o whole.glb").exit_code, 0);
    EXPECT_EQ(run("tractus grow broadleaf -n 9 --quantized -o small.glb").exit_code, 0);
    EXPECT_EQ(json_of("small.glb")["extensionsRequired"],
              nlohmann::json({ "KHR_mesh_quantization" }));
    EXPECT_LT(read("small.glb").size(), read("whole.glb").size());
    auto const again = run("tractus render small.glb -o small.png");
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(run("tractus grow leaf --quantized --animation 3 -o moving.glb").exit_code, 2);
}

TEST_F(Organs, AreCompressedWhereThatIsAskedFor)
{
    EXPECT_EQ(run("tractus grow broadleaf -n 9 --quantized -o small.glb").exit_code, 0);
    EXPECT_EQ(run("tractus grow broadleaf -n 9 --compressed -o smaller.glb").exit_code, 0);
    EXPECT_EQ(run("tractus grow broadleaf -n 9 --compressed --quantized -o same.glb").exit_code, 0);
    EXPECT_EQ(json_of("smaller.glb")["extensionsRequired"],
              nlohmann::json({ "EXT_meshopt_compression", "KHR_mesh_quantization" }));
    EXPECT_LT(read("smaller.glb").size(), read("small.glb").size());
    EXPECT_EQ(json_of("same.glb")["extensionsRequired"],
              json_of("smaller.glb")["extensionsRequired"]);
    auto const again = run("tractus render smaller.glb -o smaller.png");
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_EQ(run("tractus grow leaf --compressed --animation 3 -o moving.glb").exit_code, 2);
}

TEST_F(Organs, OldSpellingMeansTheSame)
{
    EXPECT_EQ(run("tractus vary leaf --count 1 --nodes -o old.glb").exit_code, 0);
    EXPECT_EQ(run("tractus vary leaf --count 1 --organs nodes -o new.glb").exit_code, 0);
    EXPECT_EQ(read("old.glb"), read("new.glb"));
    EXPECT_EQ(run("tractus vary leaf --nodes --organs merged -o x.glb").exit_code, 2);
    EXPECT_EQ(run("tractus grow leaf --organs many -o x.glb").exit_code, 2);
}

TEST_F(Organs, AFileThatManyProgramsOpenSlowlySaysSoBeforeItIsWritten)
{
    // The size of files is limited so that writing fails. The note must have been printed before.
    auto const outcome
        = run("ulimit -f 64; tractus vary daisy --count 3500 --sides 64 -o large.glb");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("million triangles and"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("--organs instanced"), std::string::npos) << outcome.err;
    EXPECT_EQ(run("tractus grow daisy -o small.glb").err, "");
}

TEST_F(Organs, AnObjHasItsMaterialsAndPicturesBesideIt)
{
    EXPECT_EQ(run("mkdir out && tractus grow broadleaf -o out/tree.obj").exit_code, 0);
    auto const obj = read("out/tree.obj");
    EXPECT_NE(obj.substr(0, 200).find("mtllib tree.mtl\n"), std::string::npos);
    auto const materials = read("out/tree.mtl");
    for (auto const* const picture : { "bark-color", "bark-normal", "leaf-color" }) {
        auto const name = std::string("tree-") + picture + ".png";
        EXPECT_NE(materials.find(name), std::string::npos) << materials;
        EXPECT_EQ(read("out/" + name).substr(1, 3), "PNG");
    }
    EXPECT_EQ(count_files("out"), 5u);
}

} // namespace
} // namespace tractus
