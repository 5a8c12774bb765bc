#include "engine/scene/season.h"

#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <numbers>

namespace tractus::scene {
namespace {

constexpr int kLeaves = 2000;

// Returns a stem with organs of the same shape along its whole length.
Plant leafy_plant(OrganShape shape, Material::Kind kind = Material::Kind::Leaf)
{
    Plant plant;
    plant.materials = { {}, { .name = "leaf", .kind = kind, .base_color = { 0.3f, 0.5f, 0.2f } } };
    plant.axes = { { .segment_count = 2 } };
    plant.node_position_mm = { Vec3::Zero(), { 0, 0, 400 }, { 0, 0, 1000 } };
    plant.node_radius_mm = { 5, 4, 3 };
    plant.segment_material = { 0, 0 };
    shape.material = 1;
    plant.organ_shapes = { std::move(shape) };
    for (int i = 0; i < kLeaves; ++i)
        plant.organs.push_back(
            { .segment = i % 2 ? 1u : 0u, .position_mm = { 0, 0, 1000.0 * (i + 1) / kLeaves } });
    return plant;
}

struct Count {
    int on_plant = 0;
    int on_ground = 0;
    double green = 0; // Mean ratio of green to red over all leaves.
};

Count count_of(Plant const& plant)
{
    Count count;
    for (auto const& organ : plant.organs) {
        ++(organ.segment == kNone ? count.on_ground : count.on_plant);
        auto const& color = plant.materials[plant.organ_shapes[organ.shape].material].base_color;
        count.green += double(color.y() / color.x()) / double(plant.organs.size());
    }
    return count;
}

Count at(double month, double fallen = 0.25, OrganShape const& shape = {})
{
    auto const plant = in_season(leafy_plant(shape), { month, fallen }, {});
    check_plant(plant);
    return count_of(plant);
}

TEST(Season, IsAMonthInWordsOrNumbers)
{
    EXPECT_EQ(parse_month("October"), 10.5);
    EXPECT_EQ(parse_month("october"), 10.5);
    EXPECT_EQ(parse_month("1"), 1.0);
    EXPECT_EQ(parse_month("12.99"), 12.99);
    EXPECT_EQ(parse_month("Autumn").value(), parse_month("fall").value());
    for (auto const* wrong : { "", "13", "0.99", "nan", "-1", "octo", "10.5 ", "1e400" })
        EXPECT_FALSE(parse_month(wrong)) << wrong;
    EXPECT_EQ(month_name(10.5), "mid-October");
    EXPECT_EQ(month_name(1), "early January");
    EXPECT_EQ(month_name(12.99), "late December");
}

TEST(Season, LetsLeavesAgeFromBudToFall)
{
    OrganCalendar const calendar;
    double before = 0;
    for (double month = calendar.opens; month < calendar.bare; month += 0.01) {
        auto const age = age_in_season(calendar, month);
        ASSERT_TRUE(age) << month;
        EXPECT_GE(*age, before) << month;
        EXPECT_LT(*age - before, 0.1) << month;
        before = *age;
    }
    EXPECT_GT(before, 0.99);
    EXPECT_FALSE(age_in_season(calendar, calendar.opens - 0.01));
    EXPECT_FALSE(age_in_season(calendar, calendar.bare));
    EXPECT_TRUE(age_in_season({ .is_evergreen = true }, 1));
}

TEST(Season, HasAllLeavesInSummerAndNoneInWinter)
{
    EXPECT_EQ(at(7).on_plant, kLeaves);
    EXPECT_EQ(at(7).on_ground, 0);
    EXPECT_EQ(at(1.5).on_plant, 0);
    EXPECT_EQ(at(1.5, 1).on_ground, kLeaves);
    EXPECT_EQ(at(1.5, 0).on_ground, 0);
    EXPECT_EQ(at(3.5, 1).on_ground, 0) << "the leaves of last year have gone";
    // The tolerance is three standard deviations of a binomial distribution.
    EXPECT_NEAR(at(1.5, 0.25).on_ground, 0.25 * kLeaves, 3 * std::sqrt(0.1875 * kLeaves));
}

TEST(Season, LetsLeavesFallOneByOneInAutumn)
{
    int before = kLeaves;
    int steps = 0;
    for (double month = 9; month < 11.3; month += 0.1) {
        auto const count = at(month, 1);
        EXPECT_EQ(count.on_plant + count.on_ground, kLeaves) << month;
        EXPECT_LE(count.on_plant, before) << month << ": none goes back to its branch";
        steps += count.on_plant < before ? 1 : 0;
        before = count.on_plant;
    }
    EXPECT_GE(steps, 5);
    EXPECT_LT(before, kLeaves / 20);
}

TEST(Season, TurnsGreenLeavesYellow)
{
    EXPECT_GT(at(7).green, 1.4);
    EXPECT_LT(at(10.4).green, 1.1);
    EXPECT_GT(at(4.6).green, 1.1);
}

// A leaf must keep its picture as long as it is as green as the picture. With the picture, a
// discoloured leaf would look as in summer.
TEST(Season, KeepsThePicturesOfGreenLeaves)
{
    auto plant = leafy_plant({ .kind = OrganShape::Kind::Surface });
    plant.materials[1].textures.base_color
        = std::make_shared<TexturePicture const>(TexturePicture { .bytes = "\x89PNG" });
    auto const pictured = [&](double month) {
        auto const then = in_season(plant, { month, 0.25 }, {});
        return std::count_if(then.organs.begin(), then.organs.end(), [&](Organ const& organ) {
            return then.materials[then.organ_shapes[organ.shape].material].textures.base_color
                != nullptr;
        });
    };
    EXPECT_EQ(pictured(6.5), kLeaves);
    EXPECT_EQ(pictured(10.5), 0);
}

TEST(Season, LaysFallenLeavesOnTheGroundBelow)
{
    auto const plant = in_season(leafy_plant({}), { 1.5, 1 }, {});
    double reach_mm = 0;
    for (auto const& organ : plant.organs) {
        EXPECT_EQ(organ.segment, kNone);
        EXPECT_GE(organ.position_mm.z(), 0);
        EXPECT_LT(organ.position_mm.z(), 10);
        double const lean = std::abs((organ.orientation * Vec3::UnitZ()).z());
        EXPECT_GT(lean, 0.3) << "flat, one side or the other";
        reach_mm = std::max(reach_mm, organ.position_mm.head<2>().norm());
    }
    EXPECT_GT(reach_mm, 300);
    EXPECT_LT(reach_mm, 1500);
}

TEST(Season, LeavesSegmentsAndEvergreensAsTheyAre)
{
    for (double const month : { 1.5, 4.8, 7.0, 10.4 }) {
        auto const before = leafy_plant({ .kind = OrganShape::Kind::Needle });
        auto const needles = in_season(before, { month }, {});
        EXPECT_EQ(needles.organs.size(), before.organs.size());
        EXPECT_EQ(needles.materials.size(), before.materials.size());
        EXPECT_EQ(needles.node_position_mm, before.node_position_mm);
        OrganShape shape;
        shape.calendar = OrganCalendar { .is_evergreen = true };
        EXPECT_EQ(at(month, 1, shape).on_plant, kLeaves);
    }
}

TEST(Season, ShowsPetalsInTheirMonths)
{
    OrganShape petal;
    petal.calendar = OrganCalendar { .opens = 3.5, .grown = 4, .turns = 4.7, .bare = 5 };
    auto const petals_at = [&](double month) {
        return in_season(leafy_plant(petal, Material::Kind::Petal), { month, 1 }, {}).organs.size();
    };
    EXPECT_EQ(petals_at(3), 0u);
    EXPECT_EQ(petals_at(4.2), std::size_t { kLeaves });
    EXPECT_EQ(petals_at(5), 0u) << "and they do not lie on the ground";
}

TEST(Season, IsTheSameTwice)
{
    auto const one = in_season(leafy_plant({}), { 10.4 }, {});
    auto const other = in_season(leafy_plant({}), { 10.4 }, {});
    ASSERT_EQ(one.organs.size(), other.organs.size());
    for (std::size_t i = 0; i < one.organs.size(); ++i) {
        EXPECT_EQ(one.organs[i].position_mm, other.organs[i].position_mm);
        EXPECT_EQ(one.organs[i].shape, other.organs[i].shape);
    }
}

std::shared_ptr<lsystem::LeafSheet const> sheet_of(std::string const& name, double length)
{
    auto sheet = std::make_shared<lsystem::LeafSheet>();
    sheet->mean_color = { 0.8f, 0.6f, 0.2f };
    sheet->color = lsystem::leaf_page("\x89PNG");
    sheet->normal = lsystem::leaf_page("\x89PNG");
    sheet->leaves.push_back(std::make_shared<CutLeaf const>(
        CutLeaf { .corners = { { 0, 0 }, { 0.3, 0.5 }, { 0, length } },
                  .triangles = { { 0, 1, 2 } },
                  .sheet = name }));
    return sheet;
}

TEST(Season, TakesGrownLeavesOfItsAge)
{
    OrganShape shape { .kind = OrganShape::Kind::Leaf, .length_mm = 60 };
    shape.cut = sheet_of("birch 1 0.5.leaf-sheet", 1)->leaves[0];
    auto const plant = leafy_plant(shape);
    Season const autumn { 10.4 };
    auto const missing = missing_leaves(plant, autumn, {});
    ASSERT_EQ(missing.size(), 1u);
    auto const order = lsystem::parse_leaf_sheet_name(*missing.begin());
    ASSERT_TRUE(order);
    EXPECT_EQ(order->grammar, "birch");
    EXPECT_EQ(order->variants, 1);
    EXPECT_NEAR(order->age, *age_in_season({}, autumn.month), 0.011);
    EXPECT_GT(order->spread, 0);

    LeafSheets const sheets { { *missing.begin(), sheet_of(*missing.begin(), 0.5) } };
    EXPECT_TRUE(missing_leaves(plant, autumn, sheets).empty());
    auto const aged = in_season(plant, autumn, sheets);
    check_plant(aged);
    auto const& leaf = aged.organ_shapes[0];
    EXPECT_EQ(leaf.cut, sheets.begin()->second->leaves[0]);
    EXPECT_NEAR(leaf.length_mm, 30, 1e-9) << "half as long as the blade was, as the sheet says";
    auto const& material = aged.materials[leaf.material];
    EXPECT_EQ(material.textures.base_color, sheets.begin()->second->color);
    EXPECT_EQ(material.base_color, sheets.begin()->second->mean_color);
    EXPECT_EQ(aged.materials.size(), plant.materials.size()) << "one material for all leaves";
    // Without a leaf sheet, the leaf must have the same shape in other colours.
    auto const tinted = in_season(plant, autumn, {});
    EXPECT_EQ(tinted.organ_shapes[tinted.organs[0].shape].cut, shape.cut);
    EXPECT_LT(count_of(tinted).green, 1.1);
}

TEST(LeafAge, IsSpreadAboutTheOrders)
{
    lsystem::LeafOrder const order { .variants = 64, .age = 0.5, .spread = 0.08 };
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < order.variants; ++i) {
        double const off = lsystem::leaf_age(order, i) - order.age;
        sum += off;
        squares += off * off;
        lsystem::LeafOrder const later { .variants = 64, .age = 0.6, .spread = 0.08 };
        EXPECT_NEAR(lsystem::leaf_age(later, i) - later.age, off, 1e-12);
    }
    EXPECT_NEAR(sum / order.variants, 0, 0.01);
    EXPECT_NEAR(std::sqrt(squares / order.variants), 0.08, 0.01);
    EXPECT_EQ(lsystem::leaf_age({ .age = 0.5 }, 7), 0.5);
    EXPECT_LE(lsystem::leaf_age({ .age = 1, .spread = 0.5 }, 3), 1);
}

Scene with_leaves()
{
    LoadModel load;
    load.source = { "leaves.l",
                    "lsystem: 1\nderivation length: 1\naxiom: F(10)[+(60)~l(1)]F(10)~l(1)\n"
                    "endlsystem\n" };
    load.source.view_name = "leaves.v";
    load.source.view_text = "material: 1 bark kind=bark color=0.4,0.3,0.2\n"
                            "material: 2 leaf kind=leaf color=0.3,0.5,0.2\n"
                            "organ: l leaf kind=blade material=2 length=4 width=2\n";
    return apply_edit({}, load).value();
}

TEST(Season, IsAnEditOfTheDocument)
{
    auto const before = with_leaves();
    ASSERT_EQ(before.in_season, before.base);
    auto const winter = apply_edit(before, SetSeason { .month = 1.5, .fallen = 0 }).value();
    EXPECT_EQ(winter.base->organs.size(), before.base->organs.size());
    EXPECT_TRUE(winter.in_season->organs.empty());
    EXPECT_TRUE(plan_growth(winter).value().organs.empty());
    EXPECT_EQ(winter.in_season->segment_count(), before.base->segment_count());
    auto const moved = apply_edit(winter, MovePlant { winter.state.active, { 10, 20, 0 } }).value();
    EXPECT_TRUE(moved.in_season->organs.empty());
    auto const without = apply_edit(moved, SetSeason {}).value();
    EXPECT_EQ(without.in_season, without.base);
    for (double const month : { 0.5, 13.0, -1.0, double(NAN) })
        EXPECT_FALSE(apply_edit(before, SetSeason { month })) << month;
    EXPECT_FALSE(apply_edit(before, SetSeason { 7, 1.5 }));
    EXPECT_FALSE(apply_edit(before, KeepLeaves { "x", "" }));
    auto const broken = apply_edit(before, KeepLeaves { "birch 2 0.5.leaf-sheet", "mean 1 1\n" });
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().message, "birch 2 0.5.leaf-sheet:1: expected 3 numbers behind 'mean'");
}

} // namespace
} // namespace tractus::scene
