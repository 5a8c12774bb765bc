#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "engine/mesh/make_mesh.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>

namespace tractus::batch {
namespace {

// Properties required of a fully grown model.
struct Expected {
    std::string name;
    int steps; // Derivation length of the model.
    std::size_t min_segments;
    std::size_t min_organs;
    // Minimum number of segments of the longest axis, so that a stroke can bend that axis.
    std::uint32_t min_axis_segments;
    double min_height_mm;
    double max_height_mm;
    // Maximum distance from the origin at which axes may leave the ground.
    double tuft_mm = 0;
    bool has_support = false; // True if the model includes a support, which does not grow.
};

void PrintTo(Expected const& expected, std::ostream* out)
{
    *out << expected.name;
}

std::vector<Expected> const kModels {
    { "birch", 12, 2500, 3000, 25, 3000, 5500 },
    { "broadleaf", 16, 3500, 5000, 40, 3500, 6000 },
    { "calla", 26, 130, 18, 10, 400, 900, 20 },
    { "conifer", 10, 2500, 12'000, 25, 2000, 3500 },
    { "daisy", 20, 50, 180, 9, 250, 500 },
    { "fern", 44, 3000, 6000, 20, 300, 1000 },
    { "frond", 32, 250, 500, 20, 400, 800 },
    { "grass", 22, 500, 1500, 20, 700, 1600, 45 },
    { "leaf", 11, 20, 11, 10, 200, 450 },
    { "magnolia", 9, 1000, 1800, 9, 1500, 3500 },
    { "palm", 74, 900, 1400, 150, 6000, 11'000 },
    { "poplar", 11, 4500, 6000, 50, 5500, 9000 },
    { "shrub", 14, 1200, 2500, 9, 800, 2000 },
    { "sunflower", 27, 35, 500, 20, 1200, 2200 },
    { "vine", 48, 150, 90, 90, 1300, 2000, 20, true },
};

class BaseModel : public testing::TestWithParam<Expected> {
protected:
    static scene::Scene grow(std::optional<int> steps = {}, std::uint64_t seed = 1)
    {
        auto edit
            = io::load_model_edit(files::find_resource("models/" + GetParam().name + ".l").value())
                  .value();
        edit.steps = steps;
        edit.seed = seed;
        return scene::apply_edit({}, edit).value();
    }
};

double height_mm(Plant const& plant)
{
    return bounds(plant).max_mm.z();
}

// Returns the sum of the areas of the organs' outlines when laid flat.
double organ_area_mm2(Plant const& plant)
{
    double sum = 0;
    for (auto const& organ : plant.organs) {
        auto const& shape = plant.organ_shapes[organ.shape];
        sum += shape.length_mm * shape.width_mm
            * static_cast<double>(organ.scale.x() * organ.scale.y());
    }
    return sum;
}

TEST(Models, AreAllTestedHere)
{
    std::set<std::string> in_folder;
    for (auto const& entry :
         std::filesystem::directory_iterator(files::find_resource("models").value()))
        if (entry.path().extension() == ".l")
            in_folder.insert(entry.path().stem().string());
    std::set<std::string> here;
    for (auto const& model : kModels)
        here.insert(model.name);
    EXPECT_EQ(in_folder, here);
}

TEST_P(BaseModel, IsUnderstoodWithoutWarnings)
{
    EXPECT_EQ(grow().model_warnings, std::vector<std::string> {});
}

TEST_P(BaseModel, IsAWholePlantOfItsSize)
{
    auto const scene = grow();
    auto const& plant = *scene.base;
    check_plant(plant);
    EXPECT_GE(plant.segment_count(), GetParam().min_segments);
    EXPECT_GE(plant.organs.size(), GetParam().min_organs);
    EXPECT_GE(height_mm(plant), GetParam().min_height_mm);
    EXPECT_LE(height_mm(plant), GetParam().max_height_mm);
}

TEST_P(BaseModel, StandsOnTheGroundAtItsOrigin)
{
    for (std::uint64_t const seed : { 1u, 2u, 3u }) {
        auto const scene = grow({}, seed);
        auto const& plant = *scene.base;
        for (auto const& axis : plant.axes)
            if (axis.parent_segment == kNone) {
                EXPECT_LE(plant.positions(axis).front().norm(), GetParam().tuft_mm + 1e-6);
                EXPECT_GT(plant.positions(axis).back().z(), 0);
            }
        EXPECT_GT(bounds(plant).min_mm.z(), -0.05 * height_mm(plant)) << "seed " << seed;
    }
}

TEST_P(BaseModel, HasAnAxisThatAStrokeCanBend)
{
    auto const scene = grow();
    auto const& axes = scene.base->axes;
    auto const longest
        = *std::max_element(axes.begin(), axes.end(), [](auto const& a, auto const& b) {
              return a.segment_count < b.segment_count;
          });
    EXPECT_GE(longest.segment_count, GetParam().min_axis_segments);
    EXPECT_EQ(longest.order, 0u);
    EXPECT_GT(axis_length_mm(*scene.base, longest), 0.6 * height_mm(*scene.base));
}

TEST_P(BaseModel, GrowsWithItsSteps)
{
    scene::Scene younger = grow(GetParam().steps / 4);
    check_plant(*younger.base);
    for (int const quarter : { 2, 3, 4 }) {
        auto const older = grow(GetParam().steps * quarter / 4);
        check_plant(*older.base);
        if (!GetParam().has_support) {
            EXPECT_GT(height_mm(*older.base), height_mm(*younger.base)) << quarter;
        }
        EXPECT_GE(older.base->segment_count(), younger.base->segment_count()) << quarter;
        EXPECT_GE(older.base->organs.size(), younger.base->organs.size()) << quarter;
        EXPECT_GT(organ_area_mm2(*older.base), organ_area_mm2(*younger.base)) << quarter;
        younger = older;
    }
    EXPECT_EQ(younger.base->node_position_mm, grow().base->node_position_mm);
}

TEST_P(BaseModel, GivesAnotherPlantOfItsKindForAnotherSeed)
{
    auto const one = grow({}, 1);
    for (std::uint64_t const seed : { 2u, 3u, 4u }) {
        auto const another = grow({}, seed);
        EXPECT_NE(another.base->node_position_mm, one.base->node_position_mm) << seed;
        EXPECT_NEAR(height_mm(*another.base) / height_mm(*one.base), 1, 0.3) << seed;
        EXPECT_NEAR(static_cast<double>(another.base->segment_count()),
                    static_cast<double>(one.base->segment_count()),
                    0.35 * static_cast<double>(one.base->segment_count()))
            << seed;
    }
}

// A computer without a graphics card must be able to draw ten plants at once.
TEST_P(BaseModel, IsNotTooHeavyToDraw)
{
    for (std::uint64_t const seed : { 1u, 2u, 3u, 4u, 5u })
        EXPECT_LE(mesh::make_mesh(*grow({}, seed).base).triangle_count(), 400'000u) << seed;
}

INSTANTIATE_TEST_SUITE_P(Ours, BaseModel, testing::ValuesIn(kModels),
                         [](auto const& model) { return model.param.name; });

} // namespace
} // namespace tractus::batch
