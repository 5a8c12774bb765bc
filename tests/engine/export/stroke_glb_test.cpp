#include "engine/export/stroke_glb.h"

#include "engine/export/glb_lines.h"
#include "tests/engine/export/glb_of.h"
#include "tests/engine/stroke/strokes.h"

#include <array>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

namespace tractus::exports {
namespace {

std::string glb_of(std::vector<Stroke> const& strokes)
{
    std::ostringstream out;
    auto const written = write_strokes_glb(out, strokes);
    EXPECT_TRUE(written) << written.error().message;
    return out.str();
}

TEST(StrokeGlb, IsReadBackAsTheSameLines)
{
    auto const first = stroke_of({ { 10, 20, 30 }, { 40, 50, 60 }, { -70, 80, 90 } });
    auto const second = stroke_of({ { 0, 0, 0 }, { 0, 0, 250 } });
    auto const lines = read_glb_lines("strokes.glb", glb_of({ first, second })).value();
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_TRUE(lines[0].from_mm.isApprox(Vec3(10, 20, 30), 1e-6));
    EXPECT_TRUE(lines[1].from_mm.isApprox(Vec3(40, 50, 60), 1e-6));
    EXPECT_TRUE(lines[1].to_mm.isApprox(Vec3(-70, 80, 90), 1e-6));
    EXPECT_TRUE(lines[2].to_mm.isApprox(Vec3(0, 0, 250), 1e-6));
}

TEST(StrokeGlb, SaysPressureTimeAndBegin)
{
    Stroke stroke;
    for (auto tip : stroke_of({ { 0, 0, 0 }, { 1, 0, 0 } }).tips) {
        tip.time += std::chrono::milliseconds(2500);
        stroke.tips.push_back(tip);
    }
    auto const glb = glb_of({ stroke });
    auto const json = json_of(glb);
    auto const& primitive = json["meshes"][0]["primitives"][0];
    EXPECT_EQ(primitive["mode"], 3);
    EXPECT_EQ(json["nodes"][0]["name"], "stroke 1");
    EXPECT_EQ(json["nodes"][0]["extras"]["begin_s"], 2.5);
    auto const numbers = [&](char const* name) {
        auto const view
            = json["accessors"][primitive["attributes"][name].get<std::size_t>()]["bufferView"]
                  .get<std::size_t>();
        std::array<float, 2> read {};
        std::uint32_t json_size = 0;
        std::memcpy(&json_size, glb.data() + 12, 4);
        std::memcpy(read.data(),
                    glb.data() + 28 + json_size
                        + json["bufferViews"][view]["byteOffset"].get<std::size_t>(),
                    sizeof read);
        return read;
    };
    EXPECT_EQ(numbers("_PRESSURE"), (std::array { 0.5f, 0.5f }));
    EXPECT_EQ(numbers("_TIME"), (std::array { 0.0f, 0.005f }));
}

TEST(StrokeGlb, KeepsNumbersWhereATapIsLeftOut)
{
    auto const tap = stroke_of({ { 1, 2, 3 } });
    auto const json = json_of(glb_of({ tap, stroke_of({ { 0, 0, 0 }, { 0, 1, 0 } }) }));
    ASSERT_EQ(json["nodes"].size(), 1u);
    EXPECT_EQ(json["nodes"][0]["name"], "stroke 2");
}

TEST(StrokeGlb, RefusesATipThatIsNowhere)
{
    auto const nowhere
        = stroke_of({ { 0, 0, 0 }, { 0, 0, std::numeric_limits<double>::quiet_NaN() } });
    std::ostringstream out;
    auto const written = write_strokes_glb(out, std::vector { nowhere });
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().message, "a stroke has a tip that is nowhere");
    EXPECT_EQ(out.str(), "");
}

} // namespace
} // namespace tractus::exports
