#include "app/methods/leaves/leaf_atlas.h"
#include "tests/app/commands/outcome.h"
#include "tests/file_bytes.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <png.h>
#include <string>
#include <unistd.h>
#include <vector>

namespace tractus::leaf {
namespace {

namespace fs = std::filesystem;

class LeafAtlas : public ::testing::Test {
protected:
    void SetUp() override
    {
        folder_ = fs::temp_directory_path() / ("tractus-atlas-" + std::to_string(getpid()));
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::string folder(std::string const& name) const { return (folder_ / name).string(); }

    // A picture as decoded by libpng.
    struct Picture {
        unsigned side = 0;
        std::vector<unsigned char> rgba;
    };
    static Picture read(fs::path const& path)
    {
        png_image image {};
        image.version = PNG_IMAGE_VERSION;
        Picture made;
        EXPECT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << path;
        image.format = PNG_FORMAT_RGBA;
        made.side = image.width;
        made.rgba.resize(PNG_IMAGE_SIZE(image));
        EXPECT_NE(png_image_finish_read(&image, nullptr, made.rgba.data(), 0, nullptr), 0) << path;
        return made;
    }
    fs::path folder_;
};

TEST_F(LeafAtlas, HasPagesWithEmptyGutters)
{
    auto const outcome
        = commands::run({ "leaves", "maple", "oak", "--count", "3", "--pixels", "128", "--page",
                          "256", "--age", "0.3:0.9", "--larvae", "2", "-o", folder("page") });
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("leaves 6, pages 2"), std::string::npos) << outcome.out;
    auto const page = nlohmann::json::parse(file_bytes(folder("page/leaves.json")));
    EXPECT_EQ(page["gutter"], 8);
    ASSERT_EQ(page["pages"].size(), 2u);
    ASSERT_EQ(page["pages"][1]["cells"].size(), 2u);
    EXPECT_EQ(page["pages"][1]["cells"][1]["leaf"], "oak");
    auto const picture = read(folder("page/page-0-color.png"));
    ASSERT_EQ(picture.side, 256u);
    std::size_t there = 0;
    for (unsigned y = 0; y < 256; ++y)
        for (unsigned x = 0; x < 256; ++x) {
            auto const* const pixel = &picture.rgba[4 * (y * 256 + x)];
            bool const is_gutter = x % 128 < 8 || x % 128 >= 120 || y % 128 < 8 || y % 128 >= 120;
            there += pixel[3] >= 128;
            ASSERT_TRUE(!is_gutter || pixel[3] == 0) << x << " " << y;
            ASSERT_GT(pixel[0] + pixel[1] + pixel[2], 60) << "black goes on round a leaf";
        }
    EXPECT_GT(there, 10000u);
    // The stem, the end of the petiole, is in the middle of the cell's lower edge.
    auto const& stem = page["pages"][0]["cells"][1]["stem"];
    EXPECT_EQ(stem[0], 192);
    EXPECT_EQ(stem[1], 120);
    EXPECT_GT(picture.rgba[4 * (118 * 256 + 192) + 3], 100);
}

TEST_F(LeafAtlas, CutsShapesOutThatHoldTheirLeaves)
{
    ASSERT_EQ(commands::run({ "leaves", "maple", "--count", "1", "--pixels", "128", "--page", "128",
                              "-o", folder("shape") })
                  .exit_code,
              0);
    auto const json = nlohmann::json::parse(file_bytes(folder("shape/leaves.json")));
    auto const& cell = json["pages"][0]["cells"][0];
    auto const& mesh = cell["mesh"];
    double const pixel_m = cell["size_m"].get<double>() / 128;
    for (std::size_t i = 0; i < mesh["uv"].size(); ++i) {
        double const x = 128 * mesh["uv"][i][0].get<double>() - 64;
        double const y = 120 - 128 * mesh["uv"][i][1].get<double>();
        EXPECT_NEAR(mesh["positions"][i][0].get<double>(), x * pixel_m, 1e-6);
        EXPECT_NEAR(mesh["positions"][i][1].get<double>(), y * pixel_m, 1e-6);
    }
    auto const picture = read(folder("shape/page-0-color.png"));
    auto const corner = [&](std::size_t i) {
        return Vec2(128 * mesh["uv"][i][0].get<double>(), 128 * mesh["uv"][i][1].get<double>());
    };
    auto const side_of = [](Vec2 const& a, Vec2 const& b, Vec2 const& c) {
        return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
    };
    for (unsigned y = 0; y < 128; ++y)
        for (unsigned x = 0; x < 128; ++x) {
            if (picture.rgba[4 * (y * 128 + x) + 3] == 0)
                continue;
            Vec2 const at(x + 0.5, y + 0.5);
            bool is_held = false;
            for (auto const& triangle : mesh["triangles"]) {
                Vec2 const a = corner(triangle[0]);
                Vec2 const b = corner(triangle[1]);
                Vec2 const c = corner(triangle[2]);
                is_held |= side_of(a, b, at) <= 1e-6 && side_of(b, c, at) <= 1e-6
                    && side_of(c, a, at) <= 1e-6;
            }
            ASSERT_TRUE(is_held) << x << " " << y;
        }
}

// The green channel of a normal map points up in glTF and down in Unreal. Unity stores smoothness
// where the others store roughness.
TEST_F(LeafAtlas, PacksChannelsAsEachEngineTakesThem)
{
    auto const make = [&](std::string const& engine) {
        ASSERT_EQ(commands::run({ "leaves", "birch", "--count", "1", "--pixels", "64", "--page",
                                  "64", "--channels", engine, "-o", folder(engine) })
                      .exit_code,
                  0);
    };
    for (auto const& channels : atlas_channels())
        make(channels.engine);
    auto const up = read(folder("gltf/page-0-normal.png"));
    auto const down = read(folder("unreal/page-0-normal.png"));
    auto const orm = read(folder("godot/page-0-orm.png"));
    auto const ort = read(folder("unreal/page-0-ort.png"));
    auto const mask = read(folder("unity/page-0-mask.png"));
    auto const through = read(folder("gltf/page-0-translucency.png"));
    auto const thick = read(folder("unity/page-0-thickness.png"));
    for (std::size_t i = 0; i < up.rgba.size(); i += 4) {
        ASSERT_EQ(up.rgba[i], down.rgba[i]);
        ASSERT_EQ(up.rgba[i + 1] + down.rgba[i + 1], 255);
        ASSERT_EQ(mask.rgba[i + 3] + orm.rgba[i + 1], 255);
        ASSERT_EQ(mask.rgba[i + 1], orm.rgba[i]);
        ASSERT_EQ(ort.rgba[i + 2], through.rgba[i]);
        ASSERT_EQ(thick.rgba[i] + through.rgba[i], 255);
    }
}

TEST_F(LeafAtlas, IsTheSameHoweverManyLeavesFollow)
{
    auto const make = [&](std::string const& name, std::string const& count) {
        EXPECT_EQ(commands::run({ "leaves", "rose", "--count", count, "--pixels", "64", "--page",
                                  "64", "--age", "0.2:1", "-o", folder(name) })
                      .exit_code,
                  0);
    };
    make("few", "2");
    make("many", "4");
    for (auto const* const file : { "page-0-color.png", "page-1-color.png", "page-1-normal.png",
                                    "page-1.glb", "page-1-under-color.png" })
        EXPECT_EQ(file_bytes(folder("few") + "/" + file), file_bytes(folder("many") + "/" + file))
            << file;
}

TEST_F(LeafAtlas, WritesSmallerPicturesInWhichLeavesStay)
{
    ASSERT_EQ(commands::run({ "leaves", "fern", "--count", "1", "--pixels", "256", "--page", "256",
                              "--mips", "-o", folder("mips") })
                  .exit_code,
              0);
    auto const there = [&](std::string const& name) {
        auto const picture = read(folder("mips/" + name));
        std::size_t count = 0;
        for (std::size_t i = 3; i < picture.rgba.size(); i += 4)
            count += picture.rgba[i] >= 128;
        return double(count) / double(picture.rgba.size() / 4);
    };
    double const whole = there("page-0-color.png");
    for (int level = 1; level <= 4; ++level) // Level 4 has 16 pixels on a side.
        EXPECT_NEAR(there("page-0-color-mip" + std::to_string(level) + ".png"), whole, 0.02)
            << level;
    EXPECT_EQ(read(folder("mips/page-0-normal-mip6.png")).side, 4u);
}

TEST_F(LeafAtlas, SaysWhatItWants)
{
    EXPECT_NE(commands::run({ "leaves" }).err.find("which leaves?"), std::string::npos);
    EXPECT_NE(commands::run({ "leaves", "maple" }).err.find("-o DIR"), std::string::npos);
    EXPECT_NE(commands::run({ "leaves", "maple", "--age", "0.3:2", "-o", folder("x") })
                  .err.find("0.3:0.9"),
              std::string::npos);
    EXPECT_NE(commands::run({ "leaves", "maple", "--pixels", "100", "-o", folder("x") })
                  .err.find("power of"),
              std::string::npos);
    EXPECT_NE(
        commands::run({ "leaves", "oka", "-o", folder("x") }).err.find("there is no leaf oka"),
        std::string::npos);
    EXPECT_FALSE(fs::exists(folder("x")));
}

} // namespace
} // namespace tractus::leaf
