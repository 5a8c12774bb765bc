#include "app/methods/leaves/leaf_atlas.h"
#include "app/methods/leaves/leaf_library.h"
#include "engine/export/gltf_material.h"
#include "tests/app/commands/outcome.h"
#include "tests/file_bytes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <png.h>
#include <string>
#include <string_view>
#include <tbb/global_control.h>
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
    // Measures of a leaf in a map, taken over the pixels that pass the alpha test of the mask.
    struct Seen {
        double coverage = 0;       // Share of the cell.
        Vec3 light = Vec3::Zero(); // Their mean colour in linear light.
    };
    static Seen seen_in(Picture const& map, Picture const& mask, unsigned cell)
    {
        constexpr unsigned kColumns = 4;
        auto const side = mask.side / kColumns;
        Seen seen;
        double count = 0;
        for (unsigned y = 0; y < side; ++y)
            for (unsigned x = 0; x < side; ++x) {
                auto const i = 4
                    * std::size_t((cell / kColumns * side + y) * mask.side + cell % kColumns * side
                                  + x);
                if (mask.rgba[i + 3] < 128)
                    continue;
                ++count;
                for (int c = 0; c < 3; ++c)
                    seen.light[c] += exports::linear_from_srgb(
                        map.rgba[i + static_cast<std::size_t>(c)] / 255.0);
            }
        seen.coverage = count / (double(side) * side);
        seen.light /= count;
        return seen;
    }

    // How well a leaf's mesh fits the pixels of the leaf.
    struct Fit {
        double held = 0;  // Share of the leaf's pixels that lie in its triangles.
        double empty = 0; // Share of the triangles' pixels that are none of the leaf's.
        std::size_t triangles = 0;
    };
    static Fit fit_of(nlohmann::json const& cell, Picture const& picture)
    {
        auto const& mesh = cell["mesh"];
        auto const corner = [&](std::size_t i) {
            return Vec2(picture.side * mesh["uv"][i][0].get<double>(),
                        picture.side * mesh["uv"][i][1].get<double>());
        };
        std::vector<bool> is_held(std::size_t(picture.side) * picture.side);
        for (auto const& triangle : mesh["triangles"])
            mark_triangle({ corner(triangle[0]), corner(triangle[1]), corner(triangle[2]) },
                          picture.side, is_held);
        double leaf = 0;
        double inside = 0;
        double both = 0;
        auto const x0 = cell["x"].get<unsigned>();
        auto const y0 = cell["y"].get<unsigned>();
        auto const size = cell["size"].get<unsigned>();
        for (unsigned y = y0; y < y0 + size; ++y)
            for (unsigned x = x0; x < x0 + size; ++x) {
                auto const i = std::size_t(y * picture.side + x);
                bool const is_leaf = picture.rgba[4 * i + 3] >= 128;
                leaf += is_leaf;
                inside += is_held[i];
                both += is_leaf && is_held[i];
            }
        return { both / leaf, 1 - both / inside, mesh["triangles"].size() };
    }
    // Marks the pixels whose centres lie in a triangle, clockwise with y downwards.
    static void mark_triangle(std::array<Vec2, 3> const& at, unsigned side,
                              std::vector<bool>& marks)
    {
        Eigen::AlignedBox2d box;
        for (auto const& corner : at)
            box.extend(corner);
        auto const turn_of = [](Vec2 const& a, Vec2 const& b, Vec2 const& c) {
            return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
        };
        EXPECT_LE(turn_of(at[0], at[1], at[2]), 1e-6);
        for (int y = int(box.min().y()); y <= int(box.max().y()); ++y)
            for (int x = int(box.min().x()); x <= int(box.max().x()); ++x) {
                Vec2 const pixel(x + 0.5, y + 0.5);
                if (turn_of(at[0], at[1], pixel) <= 0 && turn_of(at[1], at[2], pixel) <= 0
                    && turn_of(at[2], at[0], pixel) <= 0)
                    marks[std::size_t(unsigned(y) * side + unsigned(x))] = true;
            }
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
    // How far c is outside of the edge from a to b, in pixels.
    auto const outside_px = [](Vec2 const& a, Vec2 const& b, Vec2 const& c) {
        return ((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x()) / (b - a).norm();
    };
    for (unsigned y = 0; y < 128; ++y)
        for (unsigned x = 0; x < 128; ++x) {
            if (picture.rgba[4 * (y * 128 + x) + 3] < 128)
                continue;
            Vec2 const at(x + 0.5, y + 0.5);
            bool is_held = false;
            for (auto const& triangle : mesh["triangles"]) {
                Vec2 const a = corner(triangle[0]);
                Vec2 const b = corner(triangle[1]);
                Vec2 const c = corner(triangle[2]);
                is_held |= outside_px(a, b, at) <= 1e-6 && outside_px(b, c, at) <= 1e-6
                    && outside_px(c, a, at) <= 1e-6;
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
    std::vector<std::string> arguments { "leaves" };
    for (auto const& name : leaf_names())
        arguments.push_back(name);
    for (auto const* const more :
         { "--count", "1", "--pixels", "128", "--page", "512", "--mips", "-o" })
        arguments.emplace_back(more);
    arguments.push_back(folder("mips"));
    ASSERT_EQ(commands::run(arguments).exit_code, 0);
    auto const level_of = [&](std::string const& map, int level) {
        auto const number = level == 0 ? std::string() : "-mip" + std::to_string(level);
        return read(folder("mips/page-0-" + map + number + ".png"));
    };
    auto const mask = level_of("color", 0);
    for (int level = 1; level <= 4; ++level) { // A leaf has 8 pixels on a side at level 4.
        auto const small = level_of("color", level);
        auto const under = level_of("under-color", level);
        ASSERT_EQ(small.side, 512u >> level);
        for (unsigned cell = 0; cell < leaf_names().size(); ++cell) {
            auto const where = leaf_names()[cell] + " at level " + std::to_string(level);
            auto const whole = seen_in(mask, mask, cell);
            auto const made = seen_in(small, small, cell);
            EXPECT_NEAR(made.coverage, whole.coverage, 0.5 / std::pow(128 >> level, 2) + 1e-9)
                << where;
            auto const whole_under = seen_in(level_of("under-color", 0), mask, cell);
            auto const made_under = seen_in(under, small, cell);
            for (int i = 0; i < 3; ++i) {
                EXPECT_NEAR(made.light[i], whole.light[i], 0.01 * whole.light[i]) << where;
                EXPECT_NEAR(made_under.light[i], whole_under.light[i], 0.01 * whole_under.light[i])
                    << where;
            }
        }
    }
    EXPECT_EQ(level_of("normal", 4).side, 32u);
    EXPECT_FALSE(fs::exists(folder("mips/page-0-normal-mip5.png")));
}

TEST_F(LeafAtlas, HasColorsAllOverBothSides)
{
    ASSERT_EQ(commands::run({ "leaves", "willow", "grass", "--count", "1", "--pixels", "128",
                              "--page", "256", "-o", folder("sides") })
                  .exit_code,
              0);
    for (auto const* const map : { "color", "under-color" }) {
        auto const picture = read(folder("sides/page-0-") + map + ".png");
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
            ASSERT_GT(picture.rgba[i + 1], picture.rgba[i + 2]) << map << ": no leaf's green";
    }
}

TEST_F(LeafAtlas, HasThreeWeightsOfGeometry)
{
    for (auto const* const geometry : { "card", "cut", "modelled" }) {
        std::vector<std::string> arguments { "leaves" };
        for (auto const& name : leaf_names())
            arguments.push_back(name);
        for (auto const* const more :
             { "--count", "1", "--pixels", "256", "--page", "1024", "--geometry", geometry, "-o" })
            arguments.emplace_back(more);
        arguments.push_back(folder(geometry));
        ASSERT_EQ(commands::run(arguments).exit_code, 0);
        auto const json = nlohmann::json::parse(file_bytes(folder(geometry) + "/leaves.json"));
        auto const picture = read(folder(geometry) + "/page-0-color.png");
        for (auto const& cell : json["pages"][0]["cells"]) {
            auto const where = cell["leaf"].get<std::string>() + ", " + geometry;
            auto const found = fit_of(cell, picture);
            bool const is_card = std::string_view(geometry) == "card";
            bool const is_modelled = std::string_view(geometry) == "modelled";
            EXPECT_GE(found.held, is_modelled ? 0.95 : 0.99) << where;
            EXPECT_LE(found.empty, is_card ? 1 : 0.05) << where;
            if (is_card) {
                EXPECT_EQ(found.triangles, 2u) << where;
            }
            if (is_modelled) {
                EXPECT_GE(found.triangles, 60u) << where;
                EXPECT_LE(found.triangles, 400u) << where;
            }
            EXPECT_EQ(cell["mesh"].contains("normals"), is_modelled) << where;
            EXPECT_EQ(cell["mesh"]["positions"][0].size(), is_modelled ? 3u : 2u) << where;
        }
        auto const glb = file_bytes(folder(geometry) + "/page-0.glb");
        EXPECT_EQ(glb.find("\"MASK\"") == std::string::npos,
                  std::string_view(geometry) == "modelled");
    }
}

// A modelled leaf is folded along its midrib and bends down towards its tip.
TEST_F(LeafAtlas, ModelsLeavesInSpace)
{
    ASSERT_EQ(commands::run({ "leaves", "beech", "--count", "1", "--pixels", "256", "--page", "256",
                              "--geometry", "modelled", "-o", folder("space") })
                  .exit_code,
              0);
    auto const json = nlohmann::json::parse(file_bytes(folder("space/leaves.json")));
    auto const& mesh = json["pages"][0]["cells"][0]["mesh"];
    double left = 0;
    double right = 0;
    double low = 1;
    for (std::size_t i = 0; i < mesh["normals"].size(); ++i) {
        Vec3 const normal(mesh["normals"][i][0], mesh["normals"][i][1], mesh["normals"][i][2]);
        EXPECT_NEAR(normal.norm(), 1, 1e-6);
        double const x = mesh["positions"][i][0];
        (x < 0 ? left : right) += normal.x();
        low = std::min(low, normal.z());
    }
    EXPECT_GT(left, 1); // Each half faces the midrib.
    EXPECT_LT(right, -1);
    EXPECT_LT(low, 0.97);
}

TEST_F(LeafAtlas, IsTheSameOnAnyNumberOfThreads)
{
    auto const make = [&](std::string const& name) {
        EXPECT_EQ(commands::run({ "leaves", "maple", "fern", "--count", "3", "--pixels", "64",
                                  "--page", "128", "--mips", "--geometry", "modelled", "--larvae",
                                  "2", "-o", folder(name) })
                      .exit_code,
                  0);
    };
    make("all");
    {
        tbb::global_control const one(tbb::global_control::max_allowed_parallelism, 1);
        make("one");
    }
    std::size_t files = 0;
    for (auto const& entry : fs::directory_iterator(folder("all"))) {
        auto const name = entry.path().filename().string();
        EXPECT_EQ(file_bytes(entry.path()), file_bytes(folder("one") + "/" + name)) << name;
        ++files;
    }
    EXPECT_GT(files, 40u);
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
