#include "engine/export/gltf_json.h"

#include "engine/base/vectors.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <random>

namespace tractus::exports {
namespace {

TEST(GltfJson, FloatsAreWrittenWithTheDigitsOfFloats)
{
    EXPECT_EQ(json_text(json_number(0.1f)), "0.1");
    EXPECT_EQ(json_text(json_number(-0.33979845f)), "-0.33979845");
    EXPECT_EQ(json_text(json_number(1e-9f)), "1e-09");
    EXPECT_EQ(json_text(json_number(double { 0.1f })), "0.10000000149011612");
}

TEST(GltfJson, WholeNumbersHaveNoPointAndZeroNoSign)
{
    EXPECT_EQ(json_text(json_number(3.0f)), "3");
    EXPECT_EQ(json_text(json_number(-2.0)), "-2");
    EXPECT_EQ(json_text(json_number(-0.0)), "0");
    EXPECT_EQ(json_text(json_number(-0.0f)), "0");
    EXPECT_EQ(json_text(json_number(0x1p53)), "9007199254740992");
}

TEST(GltfJson, EveryFloatIsReadBackAsItWas)
{
    std::mt19937 bits;
    for (int i = 0; i < 100000; ++i) {
        auto const number = static_cast<std::uint32_t>(bits());
        float value = 0;
        std::memcpy(&value, &number, sizeof value);
        if (!std::isfinite(value))
            continue;
        auto const text = json_text(json_number(value));
        EXPECT_EQ(Json::parse(text).get<float>(), value) << text;
    }
}

TEST(GltfJson, NumbersOfAVectorAreAnArray)
{
    EXPECT_EQ(json_text(json_numbers(Vec3f(0.1f, 2, -0.5f))), "[0.1,2,-0.5]");
}

TEST(GltfJson, ReplacesWhatIsNotUtf8)
{
    EXPECT_EQ(json_text("a \xff \"b\""), "\"a \xef\xbf\xbd \\\"b\\\"\"");
}

TEST(GltfJson, ADocumentHasOnlyArraysThatHaveElements)
{
    GltfJson json;
    EXPECT_EQ(json.text(0),
              R"({"asset":{"version":"2.0","generator":"tractus"},"scene":0,"scenes":[{}]})");
}

TEST(GltfJson, ADocumentNamesItsExtensionsNodesAndBuffer)
{
    GltfJson json;
    json.required_extensions.insert("A");
    json.optional_extensions.insert("B");
    EXPECT_EQ(json.nodes.add({ { "mesh", 0 } }), 0u);
    EXPECT_EQ(json.nodes.add({ { "mesh", 1 } }), 1u);
    json.scene = { 0, 1 };
    EXPECT_EQ(json.text(8),
              R"({"asset":{"version":"2.0","generator":"tractus"},"scene":0,)"
              R"("extensionsUsed":["A","B"],"extensionsRequired":["A"],)"
              R"("scenes":[{"nodes":[0,1]}],"nodes":[{"mesh":0},{"mesh":1}],)"
              R"("buffers":[{"byteLength":8}]})");
}

} // namespace
} // namespace tractus::exports
