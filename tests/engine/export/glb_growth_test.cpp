#include "engine/export/glb_growth.h"

#include "engine/export/glb_reader.h"
#include "engine/mesh/mesh_measures.h"
#include "engine/variation/growth.h"
#include "tests/engine/mesh/random_plants.h"
#include "tests/engine/variation/plans.h"

#include <cstring>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace tractus::exports {
namespace {

constexpr std::size_t kAges = 5;

// Fixture with a growing tree and the film of it that is written to a .glb file.
class GlbGrowth : public testing::Test {
protected:
    void SetUp() override
    {
        film_.mesh = &mesh_;
        for (std::size_t i = 1; i <= kAges; ++i)
            film_.ages.push_back(static_cast<double>(i) / kAges);
        film_.plant_at = [this](double age) -> Plant const& { return grower_.grow(kKey, age); };
        film_.seconds = 8;
    }

    std::string write()
    {
        std::ostringstream out;
        auto const summary = write_glb(out, film_);
        EXPECT_TRUE(summary) << summary.error().message;
        EXPECT_EQ(summary->bytes, out.str().size());
        return out.str();
    }

    static nlohmann::json json_of(std::string const& glb)
    {
        return nlohmann::json::parse(glb.substr(20, u32_at(glb, 12)));
    }

    // Returns the numbers of an accessor; all of them are 0 if the accessor has no bytes.
    static std::vector<float> floats_of(std::string const& glb, nlohmann::json const& json,
                                        nlohmann::json const& index)
    {
        auto const& accessor = json["accessors"][index.get<std::size_t>()];
        EXPECT_EQ(accessor["componentType"], 5126);
        std::size_t const components = accessor["type"] == "SCALAR" ? 1 : 3;
        std::vector<float> values(accessor["count"].get<std::size_t>() * components);
        if (!accessor.contains("bufferView"))
            return values;
        auto const& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        EXPECT_EQ(view["byteLength"], values.size() * sizeof(float));
        std::memcpy(values.data(),
                    glb.data() + 28 + u32_at(glb, 12) + view["byteOffset"].get<std::size_t>(),
                    values.size() * sizeof(float));
        return values;
    }

    static constexpr variation::PlantKey kKey { 1, 0 };
    variation::GrowthPlan plan_
        = variation::plan_of(mesh::sample_tree(1), { .sag = 2 }, { 0.5, 0, 0 });
    variation::Grower grower_ { plan_ };
    Plant whole_ = grower_.grow(kKey);
    mesh::AgedMesh mesh_ { whole_ };
    GrowthFilm film_;

private:
    static std::uint32_t u32_at(std::string const& bytes, std::size_t offset)
    {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + offset, sizeof value);
        return value;
    }
};

TEST_F(GlbGrowth, ShowsTheWholePlantWhereItIsNotPlayed)
{
    auto const glb = write();
    auto const json = json_of(glb);
    EXPECT_FALSE(json.contains("extensionsRequired"));
    auto const& mesh = json["meshes"][0];
    EXPECT_EQ(mesh["weights"], nlohmann::json(std::vector<int>(kAges - 1, 0)));
    EXPECT_EQ(mesh["extras"]["targetNames"],
              nlohmann::json({ "age 0.2", "age 0.4", "age 0.6", "age 0.8" }));
    auto const read = read_glb(glb);
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->surfaces.size(), 2u); // Bark, and leaves that are given as triangles.
    EXPECT_TRUE(read->organs.empty());
    EXPECT_EQ(read->triangle_count(), mesh_.whole().triangle_count());
    EXPECT_LT((mesh::bounds(*read).max_mm - mesh::bounds(mesh_.whole()).max_mm).norm(), 0.1);
}

TEST_F(GlbGrowth, HasATargetForEachAge)
{
    auto const glb = write();
    auto const json = json_of(glb);
    auto const& primitives = json["meshes"][0]["primitives"];
    ASSERT_EQ(primitives.size(), 2u);
    std::vector<mesh::AgedMesh::Vertices> expected;
    for (std::size_t age = 0; age + 1 < kAges; ++age) {
        mesh_.at(grower_.grow(kKey, film_.ages[age]), expected);
        for (std::size_t s = 0; s < 2; ++s) {
            ASSERT_EQ(primitives[s]["targets"].size(), kAges - 1);
            auto const& target = primitives[s]["targets"][age];
            auto const& limits = json["accessors"][target["POSITION"].get<std::size_t>()];
            auto const base = floats_of(glb, json, primitives[s]["attributes"]["POSITION"]);
            auto const step = floats_of(glb, json, target["POSITION"]);
            auto const normal = floats_of(glb, json, primitives[s]["attributes"]["NORMAL"]);
            auto const turn = floats_of(glb, json, target["NORMAL"]);
            auto const& positions = expected[s].positions_mm;
            auto const& normals = expected[s].normals;
            ASSERT_EQ(step.size(), 3 * positions.size());
            ASSERT_EQ(turn.size(), step.size());
            for (std::size_t v = 0; v < positions.size(); ++v) {
                Vec3f const position(base[3 * v] + step[3 * v], base[3 * v + 1] + step[3 * v + 1],
                                     base[3 * v + 2] + step[3 * v + 2]);
                ASSERT_NEAR(1000 * position.x(), positions[v].x(), 0.01);
                ASSERT_NEAR(1000 * position.y(), positions[v].z(), 0.01);
                ASSERT_NEAR(-1000 * position.z(), positions[v].y(), 0.01);
                ASSERT_NEAR(normal[3 * v] + turn[3 * v], normals[v].x(), 1e-5);
                ASSERT_NEAR(normal[3 * v + 1] + turn[3 * v + 1], normals[v].z(), 1e-5);
                for (std::size_t k = 0; k < 3; ++k) {
                    ASSERT_GE(step[3 * v + k], limits["min"][k].get<float>());
                    ASSERT_LE(step[3 * v + k], limits["max"][k].get<float>());
                }
            }
        }
    }
}

// The tolerance is the greatest distance of a ring from a bend of its axis. The young plant's own
// mesh would round these bends differently.
TEST_F(GlbGrowth, LooksAtEachAgeAsTheYoungPlantItselfDoes)
{
    std::vector<mesh::AgedMesh::Vertices> vertices;
    for (double const age : { 0.1, 0.35, 0.6, 0.9 }) {
        Plant const young = grower_.grow(kKey, age);
        mesh_.at(young, vertices);
        Bounds box;
        for (auto const& surface : vertices)
            for (auto const& position : surface.positions_mm)
                box.add(position.cast<double>());
        Plant const alone = variation::without_unborn(young);
        // Bounds of the mesh made for the young plant alone, with leaves as triangles.
        Bounds expected;
        mesh::AgedMesh const own(alone);
        for (auto const& surface : own.whole().surfaces)
            for (auto const& position : surface.positions_mm)
                expected.add(position.cast<double>());
        double const size = (expected.max_mm - expected.min_mm).norm();
        EXPECT_LT((box.min_mm - expected.min_mm).norm(), 0.02 * size + 5) << age;
        EXPECT_LT((box.max_mm - expected.max_mm).norm(), 0.02 * size + 5) << age;
    }
}

TEST_F(GlbGrowth, GoesEvenlyFromAgeToAge)
{
    auto const glb = write();
    auto const json = json_of(glb);
    ASSERT_EQ(json["animations"].size(), 1u);
    auto const& animation = json["animations"][0];
    EXPECT_EQ(animation["name"], "growth");
    EXPECT_EQ(animation["channels"][0]["target"]["path"], "weights");
    auto const node = animation["channels"][0]["target"]["node"].get<std::size_t>();
    EXPECT_EQ(json["nodes"][node]["mesh"], 0);
    auto const& sampler = animation["samplers"][0];
    EXPECT_EQ(sampler["interpolation"], "LINEAR");
    auto const times = floats_of(glb, json, sampler["input"]);
    EXPECT_EQ(times, (std::vector<float> { 0, 2, 4, 6, 8 }));
    auto const& input = json["accessors"][sampler["input"].get<std::size_t>()];
    EXPECT_EQ(input["min"][0], 0);
    EXPECT_EQ(input["max"][0], 8);
    EXPECT_EQ(floats_of(glb, json, sampler["output"]), (std::vector<float> { 1, 0, 0, 0, //
                                                                             0, 1, 0, 0, //
                                                                             0, 0, 1, 0, //
                                                                             0, 0, 0, 1, //
                                                                             0, 0, 0, 0 }));
}

TEST_F(GlbGrowth, TakesNoBytesForNormalsThatDoNotTurn)
{
    // The branches have no weight, so that parts that are fully grown do not move.
    auto const plan = variation::plan_of(mesh::sample_tree(1), {});
    variation::Grower grower(plan);
    Plant const whole = grower.grow(kKey);
    mesh::AgedMesh const mesh(whole);
    film_.mesh = &mesh;
    film_.plant_at = [&](double age) -> Plant const& { return grower.grow(kKey, age); };
    auto const json = json_of(write());
    for (auto const& primitive : json["meshes"][0]["primitives"])
        for (auto const& target : primitive["targets"]) {
            auto const& accessor = json["accessors"][target["NORMAL"].get<std::size_t>()];
            EXPECT_FALSE(accessor.contains("bufferView"));
        }
}

TEST_F(GlbGrowth, IsTheSameOnAnyNumberOfThreads)
{
    auto const expected = mesh::on_threads(1, [&] { return write(); });
    for (int const threads : { 2, 5 })
        EXPECT_EQ(mesh::on_threads(threads, [&] { return write(); }), expected) << threads;
}

TEST_F(GlbGrowth, OfOneAgeIsThePlantAlone)
{
    film_.ages = { 1 };
    auto const json = json_of(write());
    EXPECT_FALSE(json.contains("animations"));
    EXPECT_FALSE(json["meshes"][0]["primitives"][0].contains("targets"));
}

TEST_F(GlbGrowth, RefusesAFileBeyondFourGibibytesBeforeItStarts)
{
    film_.ages.clear();
    for (int i = 1; i <= 10'000; ++i)
        film_.ages.push_back(i / 10'000.0);
    std::ostringstream out;
    auto const summary = write_glb(out, film_);
    ASSERT_FALSE(summary);
    EXPECT_NE(summary.error().message.find("10000 ages"), std::string::npos)
        << summary.error().message;
    EXPECT_TRUE(out.str().empty());
}

TEST_F(GlbGrowth, RefusesACoordinateThatIsNotFinite)
{
    Plant odd = whole_;
    odd.node_position_mm[3].y() = std::numeric_limits<double>::quiet_NaN();
    film_.plant_at = [&](double) -> Plant const& { return odd; };
    std::ostringstream out;
    auto const summary = write_glb(out, film_);
    ASSERT_FALSE(summary);
    EXPECT_NE(summary.error().message.find("not a finite number"), std::string::npos);
}

} // namespace
} // namespace tractus::exports
