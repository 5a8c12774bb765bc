#include "engine/scene/foliated_plant.h"

#include "engine/scene/scene.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <set>

namespace tractus::scene {
namespace {

// Returns a stem with a leaf, a needle and a disc. The leaf is 50 mm long, including a petiole of
// 10 mm. The disc has the material of a leaf.
Plant small_plant()
{
    Plant plant;
    plant.axes = { {} };
    plant.axes[0].segment_count = 1;
    plant.node_position_mm = { Vec3::Zero(), Vec3(0, 0, 100) };
    plant.node_radius_mm = { 1, 1 };
    plant.segment_material = { 0 };
    plant.materials
        = { Material { .kind = Material::Kind::Bark }, Material { .kind = Material::Kind::Leaf } };
    using enum OrganShape::Kind;
    plant.organ_shapes = { OrganShape { .kind = Blade, .material = 1, .petiole_mm = 10 },
                           OrganShape { .kind = Needle, .material = 1 },
                           OrganShape { .kind = Disc, .material = 1 } };
    for (int i = 0; i < 60; ++i)
        plant.organs.push_back({ .shape = static_cast<OrganShapeId>(i % 3), .segment = 0 });
    return plant;
}

lsystem::LeafSheet small_sheet()
{
    lsystem::LeafSheet sheet;
    for (int i = 0; i < 4; ++i)
        sheet.leaves.push_back(std::make_shared<CutLeaf const>(
            CutLeaf { .corners = { { 0, -0.2 }, { 0.3, 0.5 }, { 0, 1 }, { -0.3, 0.5 } },
                      .triangles = { { 0, 1, 2 }, { 0, 2, 3 } },
                      .sheet = "ours 4 0.5.leaf-sheet",
                      .number = i }));
    sheet.mean_color = { 0.1f, 0.9f, 0.2f };
    sheet.color = lsystem::leaf_page("\x89PNG\r\n\x1a\ncolor");
    sheet.normal = lsystem::leaf_page("\x89PNG\r\n\x1a\nnormal");
    return sheet;
}

TEST(Foliated, HasGrownLeavesInThePlaceOfItsOwn)
{
    auto const plant = small_plant();
    auto const other = foliated(plant, small_sheet());
    ASSERT_EQ(other.organs.size(), plant.organs.size());
    std::set<int> numbers;
    for (std::size_t i = 0; i < plant.organs.size(); ++i) {
        auto const& shape = other.organ_shapes[other.organs[i].shape];
        if (i % 3 != 0) {
            EXPECT_EQ(other.organs[i].shape, plant.organs[i].shape) << "needles and discs stay";
            continue;
        }
        ASSERT_EQ(shape.kind, OrganShape::Kind::Leaf);
        numbers.insert(shape.cut->number);
        EXPECT_DOUBLE_EQ(shape.length_mm, 40) << "the blade's length";
        EXPECT_DOUBLE_EQ(shape.width_mm, 24);
        EXPECT_EQ(other.materials[shape.material].base_color, small_sheet().mean_color);
    }
    EXPECT_EQ(numbers.size(), 4u) << "all of the sheet's leaves";
    EXPECT_EQ(other.materials[1].base_color, plant.materials[1].base_color) << "of the needles";
}

// If grown leaves are replaced again, the length of their blades must stay.
TEST(Foliated, CanBeDressedAgain)
{
    auto const once = foliated(small_plant(), small_sheet());
    auto const twice = foliated(once, small_sheet());
    auto const& shape = twice.organ_shapes[twice.organs[0].shape];
    EXPECT_DOUBLE_EQ(shape.length_mm, 40);
    EXPECT_EQ(foliated(small_plant(), {}).organ_shapes.size(), 3u) << "by no leaves";
}

// Each leaf of a spray must be replaced where it is, at its own length.
TEST(Foliated, ReplacesEachLeafOfASpray)
{
    auto plant = small_plant();
    OrganShape spray { .kind = OrganShape::Kind::Surface, .material = 1, .length_mm = 100 };
    Quat const sideways(Eigen::AngleAxisd(-kPi / 2, Vec3::UnitZ())); // +y becomes +x.
    spray.spray
        = { { .base_mm = { 0, 20, 0 }, .length_mm = 10, .width_mm = 4 },
            { .base_mm = { 0, 60, 0 }, .orientation = sideways, .length_mm = 30, .width_mm = 12 } };
    plant.organ_shapes = { spray };
    Quat const upright(Eigen::AngleAxisd(kPi / 2, Vec3::UnitX())); // +y becomes +z.
    plant.organs = { { .shape = 0,
                       .segment = 0,
                       .position_mm = { 1, 2, 3 },
                       .orientation = upright,
                       .scale = Vec3f::Constant(2) } };
    auto const other = foliated(plant, small_sheet());
    ASSERT_EQ(other.organs.size(), 2u);
    auto const tip = [&](std::size_t i) -> Vec3 {
        auto const& organ = other.organs[i];
        double const length_mm
            = other.organ_shapes[organ.shape].length_mm * static_cast<double>(organ.scale.y());
        return organ.position_mm + organ.orientation * Vec3(0, length_mm, 0);
    };
    EXPECT_LT((other.organs[0].position_mm - Vec3(1, 2, 43)).norm(), 1e-9);
    EXPECT_LT((tip(0) - Vec3(1, 2, 63)).norm(), 1e-5);
    EXPECT_LT((other.organs[1].position_mm - Vec3(1, 2, 123)).norm(), 1e-9);
    EXPECT_LT((tip(1) - Vec3(61, 2, 123)).norm(), 1e-5);
    for (auto const& organ : other.organs) {
        EXPECT_EQ(other.organ_shapes[organ.shape].kind, OrganShape::Kind::Leaf);
        EXPECT_EQ(organ.segment, 0u);
    }
    EXPECT_EQ(foliated(other, small_sheet()).organs.size(), 2u);
}

TEST(SetFoliage, IsAnEditOfOnePlantThatAnotherModelEnds)
{
    auto scene = apply_edit({},
                            LoadModel { .source = { .name = "one.l",
                                                    .text = "Lsystem: 1\n"
                                                            "derivation length: 1\n"
                                                            "Axiom: F(10)\nendlsystem\n" } })
                     .value();
    auto const plant = scene.state.active;
    EXPECT_FALSE(apply_edit(scene, SetFoliage { plant, "ours 4 0.5.leaf-sheet" }))
        << "the document keeps none";
    EXPECT_FALSE(apply_edit(scene, SetFoliage { 77, "" }));
    auto const sheet = lsystem::print_leaf_sheet(small_sheet());
    auto const edits = std::vector<Edit> { KeepLeaves { "ours 4 0.5.leaf-sheet", sheet },
                                           SetFoliage { plant, "ours 4 0.5.leaf-sheet" } };
    auto const after = apply_edits(scene, edits).value();
    EXPECT_EQ(after.drawn->leaves, "ours 4 0.5.leaf-sheet");
    EXPECT_NE(after.foliated, after.base);
    EXPECT_EQ(after.in_season, after.foliated);
    auto const own = apply_edit(after, SetFoliage { plant, "" }).value();
    EXPECT_EQ(own.in_season, own.base);
    EXPECT_FALSE(apply_edit(scene, KeepGrammar { "", "text" }));
}

} // namespace
} // namespace tractus::scene
