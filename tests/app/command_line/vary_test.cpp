#include "tests/app/command_line/workshop.h"

#include <csignal>
#include <cstring>
#include <nlohmann/json.hpp>

namespace tractus {
namespace {

class Vary : public Workshop {
protected:
    void vary(std::string const& arguments, std::string const& before = "") const
    {
        auto const outcome = run(before + " '" TRACTUS_PROGRAM "' vary " + arguments);
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    }

    // Returns the entries of the plants in a manifest.
    nlohmann::json plants(std::string const& name) const
    {
        return nlohmann::json::parse(read(name), nullptr, false)["plants"];
    }
};

TEST_F(Vary, PartsAreExactlyPartsOfTheWhole)
{
    record();
    std::string const what = "small.l --drawing hand.tractus-log --count 5 --spread scatter";
    vary(what + " -o whole");
    vary(what + " --shard 2/2 -o parts", "taskset -c 0");
    vary(what + " --shard 1/2 -o parts");
    EXPECT_EQ(count_files("whole"), 6u);
    EXPECT_EQ(count_files("parts"), 7u);
    auto const whole = plants("whole/manifest.json");
    auto parts = plants("parts/manifest-1-of-2.json");
    for (auto const& plant : plants("parts/manifest-2-of-2.json"))
        parts.push_back(plant);
    EXPECT_EQ(parts, whole);
    ASSERT_EQ(whole.size(), 5u);
    for (auto const& plant : whole) {
        std::string const file = plant["file"];
        EXPECT_EQ(read("parts/" + file), read("whole/" + file)) << file;
    }
    EXPECT_NE(read("whole/small-1.glb").size(), 0u);
}

TEST_F(Vary, NoTwoPlantsAreAlikeUnlessTheyAreAsDrawn)
{
    record();
    std::string const what = "small.l --drawing hand.tractus-log --count 4 -o ";
    auto const wild = run("tractus vary " + what + "wild --growth wild").out;
    EXPECT_EQ(wild.find(": 0.0 mm"), std::string::npos) << wild;
    auto const drawn = run("tractus vary " + what
                           + "drawn --variability 0 --branches 0 --sizes 0 --turn 0 "
                             "--younger 0 --leaf-size 0 --own-seeds 0")
                           .out;
    EXPECT_NE(drawn.find("from plant to plant: 0.0 mm, +- 0.0 mm"), std::string::npos) << drawn;
    EXPECT_NE(drawn.find("from what was drawn: 0.0 mm, +- 0.0 mm"), std::string::npos) << drawn;
}

TEST_F(Vary, ToldToMakeMoreThanOneRunCanSaysHowToShareThem)
{
    expect_error(run("tractus vary small.l --count 1000000000 -o many"), 1, "--shard 1/1000 ");
    EXPECT_FALSE(exists("many/manifest.json"));
}

TEST_F(Vary, VariabilityIsKnownByItsOlderName)
{
    record();
    std::string const what = "small.l --drawing hand.tractus-log --count 2 --growth wild -o ";
    EXPECT_EQ(run("tractus vary " + what + "plants --liking 0.5").out,
              run("tractus vary " + what + "plants --variability 0.5").out);
    EXPECT_NE(run("tractus vary " + what + "plants --variability 2").out,
              run("tractus vary " + what + "plants --liking 0.5").out);
}

TEST_F(Vary, OneFileHoldsAllPlants)
{
    vary("small.l --count 6 --seed 9 -o field.glb");
    auto const first = read("field.glb");
    EXPECT_EQ(first.substr(0, 4), "glTF");
    for (char const* const name : { "\"small 1\"", "\"small 6\"" })
        EXPECT_NE(first.find(name), std::string::npos) << name;
    EXPECT_EQ(plants("field.json").size(), 6u);
    vary("small.l --count 6 --seed 9 -o again.glb", "taskset -c 0");
    EXPECT_EQ(read("again.glb"), first);
    vary("small.l --count 6 --seed 10 -o other.glb");
    EXPECT_NE(read("other.glb"), first);
    vary("small.l --count 6 --seed 9 --quantized -o quantized.glb");
    EXPECT_LT(read("quantized.glb").size(), first.size());
    vary("small.l --count 6 --seed 9 --sides 3 -o thin.glb");
    EXPECT_LT(read("thin.glb").size(), first.size());
}

TEST_F(Vary, WhatWasSketchedDiffersIfThatIsAskedFor)
{
    write("bow.txt", "0 0 0\n0 0 60\n20 0 140\n60 0 200\n");
    ASSERT_EQ(run("tractus sketch bow.txt --session -o sketch").exit_code, 0);
    std::string const what = "sketch/bow.tractus --variability 0 --count 3 ";
    vary(what + "-o alike");
    vary(what + "--construction 0 -o alike-too");
    auto const same = [&](char const* one, char const* other) { return read(one) == read(other); };
    EXPECT_TRUE(same("alike/bow-1.glb", "alike-too/bow-1.glb"));
    vary(what + "--construction 1 -o varied");
    vary(what + "--construction 1 --shard 2/3 -o part", "taskset -c 0");
    EXPECT_FALSE(same("varied/bow-1.glb", "varied/bow-2.glb"));
    EXPECT_FALSE(same("varied/bow-1.glb", "alike/bow-1.glb"));
    EXPECT_TRUE(same("part/bow-2.glb", "varied/bow-2.glb"));
    vary("small.l --count 2 --construction 1 -o model");
    vary("small.l --count 2 -o model-too");
    EXPECT_TRUE(same("model/small-2.glb", "model-too/small-2.glb")) << "nothing was sketched";
}

TEST_F(Vary, PlantsAreAsOldAsTheManifestSays)
{
    vary("small.l --count 8 --ages 0.2..0.6 -o young");
    for (auto const& plant : plants("young/manifest.json")) {
        EXPECT_GE(plant["age"], 0.2);
        EXPECT_LT(plant["age"], 0.6);
    }
    vary("small.l --count 8 -o old");
    EXPECT_LT(read("young/small-1.glb").size(), read("old/small-1.glb").size());
}

// Returns the width and height of a PNG image, in pixels, from its first chunk (ISO/IEC 15948,
// section 11.2.2).
std::pair<int, int> picture_size(std::string const& png)
{
    auto const number = [&](std::size_t at) {
        int value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value = 256 * value + static_cast<unsigned char>(png.at(at + i));
        return value;
    };
    return { number(16), number(20) };
}

TEST_F(Vary, ASheetShowsAtMostFortyEightPlants)
{
    vary("small.l --count 60 --ages 0.3..1 -o out --sheet pictures/sheet.png");
    auto const sheet = read("pictures/sheet.png");
    EXPECT_EQ(sheet.substr(1, 3), "PNG");
    // The sheet has eight columns and six rows of pictures of 240 pixels, with gaps of 12 and
    // captions.
    auto const [width, height] = picture_size(sheet);
    EXPECT_EQ(width, 8 * 252 + 12);
    EXPECT_GT(height, 6 * 252 + 12);
    EXPECT_LT(height, 6 * 300);
    vary("small.l --count 60 --ages 0.3..1 -o field.glb --sheet again.png", "taskset -c 0");
    EXPECT_EQ(read("again.png"), sheet);
}

TEST_F(Vary, PlantsHaveCoarserLevelsBesideThem)
{
    vary("small.l --count 3 --lods 3 -o far.glb");
    auto const far = read("far.glb");
    std::uint32_t json_bytes = 0;
    std::memcpy(&json_bytes, &far.at(12), 4);
    auto const json = nlohmann::json::parse(far.substr(20, json_bytes));
    ASSERT_EQ(json["scenes"][0]["nodes"].size(), 3u);
    for (auto const& root : json["scenes"][0]["nodes"]) {
        auto const& plant = json["nodes"][root.get<std::size_t>()];
        EXPECT_EQ(plant["extensions"]["MSFT_lod"]["ids"].size(), 3u);
        EXPECT_EQ(plant["extras"]["MSFT_screencoverage"].size(), 4u);
    }
    // Images: one for each plant's billboard, and three for the bark: colour, relief and occlusion.
    EXPECT_EQ(json["images"].size(), 3u + 3);

    vary("small.l --count 3 --lods 3 -o again.glb", "taskset -c 0");
    EXPECT_EQ(read("again.glb"), far);
    vary("small.l --count 3 --lods 1 -o folder"); // Here, a single thread draws all plants.
    EXPECT_EQ(count_files("folder"), 4u);
    EXPECT_EQ(run("tractus vary small.l --lods 7 -o x").exit_code, 2);

    auto const page = run("tractus vary small.l --count 3 --lods 3 -o far.html");
    EXPECT_EQ(page.exit_code, 1);
    EXPECT_NE(page.err.find("--lods needs a .glb file or a folder"), std::string::npos) << page.err;
}

TEST_F(Vary, PlantsHaveWhatTheWindNeedsWhereItIsAskedFor)
{
    vary("small.l --count 2 -o calm.glb");
    vary("small.l --count 2 --lods 2 --wind attributes -o attributes.glb");
    vary("small.l --count 2 --wind uv -o uv.glb");
    vary("small.l --count 2 --wind colour -o colour.glb");
    auto const has = [&](char const* file, char const* name) {
        return read(file).find(name) != std::string::npos;
    };
    EXPECT_FALSE(has("calm.glb", "_PIVOT"));
    EXPECT_TRUE(has("attributes.glb", "_PIVOT"));
    EXPECT_TRUE(has("uv.glb", "TEXCOORD_4"));
    EXPECT_TRUE(has("colour.glb", "COLOR_0"));
    vary("small.l --count 2 --lods 2 --wind attributes -o again.glb", "taskset -c 0");
    EXPECT_EQ(read("again.glb"), read("attributes.glb"));
}

TEST_F(Vary, WrongUsageIsRefused)
{
    for (auto const& [arguments, reason] :
         { std::pair("small.l --count 0 -o x", "'0' is not a whole number from 1"),
           std::pair("small.l --shard 3/2 -o x", "'3/2' is not a part of at most"),
           std::pair("small.l --shard two -o x", "such as 2/8"),
           std::pair("small.l --ages 0.9..0.2 -o x", "'0.9..0.2' is not a range within 0.01..1"),
           std::pair("small.l --ages old -o x", "'old' is not a range"),
           std::pair("small.l --spread heap -o x", "heap"), std::pair("small.l", "--output"),
           std::pair("small.l --sheet x.jpg -o x", ".png"),
           std::pair("small.l --wind strong -o x", "strong"),
           std::pair("small.l --rig a.rig.toml -o x", "--drawing") }) {
        auto const outcome = run(std::string("tractus vary ") + arguments);
        EXPECT_EQ(outcome.exit_code, 2) << arguments;
        EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
    }
    EXPECT_FALSE(exists("x"));
}

TEST_F(Vary, AFullDiskLeavesWhatWasWrittenBefore)
{
    vary("small.l --count 3 -o out");
    auto const first = read("out/small-1.glb");
    // The preset "wild" gives longer branches with more mesh pieces, so the files exceed the limit.
    auto const outcome = run(
        "ulimit -f 2; tractus vary small.l --growth wild --seed 2 --sides 64 --count 3 -o out");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("0 of 3 plants are written"), std::string::npos) << outcome.err;
    EXPECT_EQ(read("out/small-1.glb"), first);
    EXPECT_EQ(count_files("out"), 4u);
}

TEST_F(Vary, ADiskThatFillsUpInTheMiddleLeavesWholeFiles)
{
    std::string const what = "small.l --count 24 --ages 0.05..1 --sides 64 -o ";
    vary(what + "whole");
    // Finds the first plant whose file is larger, in blocks, than those of all plants before it. A
    // limit at that size then stops the run at this plant.
    constexpr std::size_t kBlock = 512; // Unit of the shell command ulimit in dash, in bytes.
    auto const files = plants("whole/manifest.json");
    std::size_t too_large = 0;
    std::size_t blocks = 0;
    for (std::size_t i = 0; i < files.size() && too_large == 0; ++i) {
        auto const size = read("whole/" + std::string(files[i]["file"])).size();
        if (i > 0 && size > kBlock * blocks)
            too_large = i;
        else
            blocks = std::max(blocks, (size + kBlock - 1) / kBlock);
    }
    ASSERT_GT(too_large, 0u);
    auto const outcome
        = run("ulimit -f " + std::to_string(blocks) + "; tractus vary " + what + "part");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find(std::to_string(too_large) + " of 24 plants are written"),
              std::string::npos)
        << outcome.err;
    EXPECT_EQ(count_files("part"), too_large);
    for (std::size_t i = 0; i < too_large; ++i) {
        std::string const file = files[i]["file"];
        EXPECT_EQ(read("part/" + file), read("whole/" + file)) << file;
    }
}

TEST_F(Vary, CtrlCLeavesWholeFiles)
{
    // The number of plants is too large to finish. env restores the reaction to SIGINT, which a
    // shell's background process would ignore.
    auto const outcome = run(
        "env --default-signal=INT '" TRACTUS_PROGRAM "' vary small.l --count 400000 -o out &\n"
        "while [ ! -e out/small-000004.glb ]; do sleep 0.01; kill -0 $! || exit 3; done\n"
        "kill -INT $!\nwait $!");
    EXPECT_EQ(outcome.exit_code, 128 + SIGINT) << outcome.err;
    auto const files = count_files("out");
    EXPECT_GE(files, 4u);
    EXPECT_LT(files, 400000u);
    for (std::size_t i = 1; i <= files; ++i) { // Every file is a plant; the numbers have no gap.
        auto const number = std::to_string(i);
        auto const plant
            = read("out/small-" + std::string(6 - number.size(), '0') + number + ".glb");
        ASSERT_GE(plant.size(), 12u) << i;
        std::uint32_t length = 0; // Length of the whole file in bytes (glTF 2.0, section 4.4.2).
        std::memcpy(&length, &plant[8], 4);
        EXPECT_EQ(length, plant.size()) << i;
    }
}

TEST_F(Vary, OfASessionGrowsAsTheSessionSaysOrAsItIsTold)
{
    record();
    ASSERT_EQ(run("tractus replay hand.tractus-log --plant small.l --session kept.tractus "
                  "--growth weeping -o out")
                  .exit_code,
              0);
    auto const vary = [&](std::string const& how) {
        auto const outcome = run("tractus vary kept.tractus --count 2 -o two.glb " + how);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return read("two.glb");
    };
    auto const own = vary("");
    EXPECT_NE(read("two.json").find("as in the session"), std::string::npos);
    EXPECT_EQ(vary("--growth weeping"), own);
    EXPECT_NE(vary("--growth usual"), own);
    EXPECT_NE(read("two.json").find("\"usual\""), std::string::npos);
}

} // namespace
} // namespace tractus
