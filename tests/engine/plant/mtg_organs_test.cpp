#include "engine/base/random.h"
#include "engine/plant/mtg.h"
#include "tests/engine/plant/small_plant.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>
#include <sstream>
#include <string>

namespace tractus {
namespace {

std::string graph_of(Plant const& plant)
{
    std::ostringstream out;
    write_mtg(out, plant);
    return out.str();
}

// Returns a plant with shapes and materials of all kinds. Its organs have random positions,
// rotations and scales, and are on random segments or on the ground.
Plant plant_with_organs(std::uint64_t seed, std::size_t organ_count)
{
    Random random({ .seed = seed });
    auto const below = [&](std::uint64_t limit) {
        return static_cast<std::uint32_t>(random.next_u64() % limit);
    };
    auto plant = small_plant();
    plant.organ_shapes.clear();
    for (std::uint32_t i = 0; i < 5; ++i)
        plant.materials.push_back({ .kind = static_cast<Material::Kind>(i) });
    for (std::uint32_t i = 0; i < 8; ++i)
        plant.organ_shapes.push_back({ .kind = static_cast<OrganShape::Kind>(below(6)),
                                       .material = static_cast<MaterialId>(2 + below(5)),
                                       .length_mm = random.uniform(0.1, 200),
                                       .width_mm = random.uniform(0.1, 90) });
    for (auto& shape : plant.organ_shapes)
        if (shape.kind == OrganShape::Kind::Blade)
            shape.petiole_mm = random.uniform(0, 0.5) * shape.length_mm;
    for (std::size_t i = 0; i < organ_count; ++i) {
        auto const size = static_cast<float>(random.uniform(0.1, 3));
        Organ organ { .shape = static_cast<OrganShapeId>(below(8)),
                      .segment = below(6) == 0 ? kNone : below(5),
                      .position_mm
                      = { random.normal() * 100, random.normal() * 100, static_cast<double>(i) },
                      .orientation
                      = { random.normal(), random.normal(), random.normal(), random.normal() },
                      .scale = Vec3f::Constant(size) };
        organ.orientation.normalize();
        if (below(3) == 0)
            organ.scale = { size, static_cast<float>(random.uniform(0.1, 3)),
                            static_cast<float>(random.uniform(0.1, 3)) };
        plant.organs.push_back(organ);
    }
    Vec3 const moved_mm(700, -30, 50);
    for (auto& position_mm : plant.node_position_mm)
        position_mm += moved_mm;
    for (auto& organ : plant.organs)
        organ.position_mm += moved_mm;
    check_plant(plant);
    return plant;
}

// Returns the length, width, depth and petiole length of an organ, in millimetres.
Eigen::Vector4d sizes_of(Plant const& plant, Organ const& organ)
{
    auto const& shape = plant.organ_shapes[organ.shape];
    Vec3 const scale = organ.scale.cast<double>();
    return { shape.length_mm * scale.y(), shape.width_mm * scale.x(), shape.width_mm * scale.z(),
             shape.petiole_mm * scale.y() };
}

// Returns a point relative to the base of the plant. The base becomes the origin when a plant is
// read.
Vec3 from_base(Plant const& plant, Vec3 const& point_mm)
{
    return point_mm - plant.node_position_mm.front();
}

Vec3 end_of_segment(Plant const& plant, SegmentId segment)
{
    constexpr double kNowhere = -1;
    if (segment == kNone)
        return Vec3::Constant(kNowhere);
    return from_base(plant, plant.node_position_mm[nodes_of(plant, segment).tip]);
}

bool is_round(OrganShape::Kind kind)
{
    return kind == OrganShape::Kind::Ball;
}

void check_same(Plant const& before, Organ const& one, Plant const& after, Organ const& other)
{
    RC_ASSERT((from_base(before, one.position_mm) - from_base(after, other.position_mm)).norm()
              < 1e-5);
    RC_ASSERT(one.orientation.angularDistance(other.orientation) < 1e-5);
    RC_ASSERT(end_of_segment(before, one.segment) == end_of_segment(after, other.segment));
    auto const& shape = before.organ_shapes[one.shape];
    auto const& read = after.organ_shapes[other.shape];
    auto sizes = sizes_of(before, one);
    if (read.kind != OrganShape::Kind::Blade)
        sizes[3] = 0;
    RC_ASSERT((sizes - sizes_of(after, other)).cwiseAbs().maxCoeff() < 1e-5 * sizes.maxCoeff());
    bool const is_told
        = shape.kind != OrganShape::Kind::Surface && shape.kind != OrganShape::Kind::Leaf;
    RC_ASSERT(!is_told || read.kind == shape.kind);
    auto const wanted = before.materials[shape.material].kind;
    auto const found = after.materials[read.material].kind;
    if (wanted == Material::Kind::Leaf || wanted == Material::Kind::Petal)
        RC_ASSERT(found == wanted);
    RC_ASSERT(is_told || is_round(read.kind) == (found == Material::Kind::Solid));
}

// Returns the organ of `after` that corresponds to an organ of `before`. It is found by its height,
// which is unique, since reading orders organs by their axes.
Organ const& same_organ(Plant const& before, Organ const& organ, Plant const& after)
{
    double const height_mm = from_base(before, organ.position_mm).z();
    auto const far = [&](Organ const& other) {
        return std::abs(from_base(after, other.position_mm).z() - height_mm);
    };
    return *std::min_element(after.organs.begin(), after.organs.end(),
                             [&](auto& a, auto& b) { return far(a) < far(b); });
}

RC_GTEST_PROP(MtgOrgans, AreGivenBack, (std::uint64_t seed))
{
    auto const before = plant_with_organs(seed, *rc::gen::inRange<std::size_t>(1, 60));
    auto const read = parse_mtg_with_warnings("tree.mtg", graph_of(before));
    RC_ASSERT(read.has_value());
    RC_ASSERT(read->warnings.empty());
    auto const& after = read->plant;
    check_plant(after);
    RC_ASSERT(after.organs.size() == before.organs.size());
    for (auto const& organ : before.organs)
        check_same(before, organ, after, same_organ(before, organ, after));
    // Writing and reading the plant again must not lose anything more.
    auto const again = parse_mtg("tree.mtg", graph_of(after));
    RC_ASSERT(again.has_value());
    RC_ASSERT(again->organs.size() == after.organs.size());
    for (auto const& organ : after.organs)
        check_same(after, organ, *again, same_organ(after, organ, *again));
}

TEST(MtgOrgans, OfOneFormShareAShapeAndAreNotStretched)
{
    auto plant = small_plant();
    plant.organ_shapes.push_back({ .material = 1, .length_mm = 30, .width_mm = 30 });
    for (float const scale : { 0.5F, 2.0F })
        for (OrganShapeId shape = 0; shape < 2; ++shape)
            plant.organs.push_back(
                { .shape = shape, .segment = 0, .scale = Vec3f::Constant(scale) });
    auto const read = parse_mtg("tree.mtg", graph_of(plant));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->organ_shapes.size(), 2u);
    for (auto const& organ : read->organs)
        EXPECT_LT((organ.scale - Vec3f::Constant(organ.scale.x())).norm(), 1e-5F);
    EXPECT_EQ(read->materials.size(), 2u);
}

// Reads a plant with a table of organs. The columns follow those of the position.
MtgPlant with_table(std::string const& lines,
                    std::string const& columns = "Length\tDirectionX\tDirectionY\tDirectionZ\t"
                                                 "Width\tDepth\tPetiole\tShape")
{
    auto const text
        = "CODE: FORM-A\nCLASSES:\nSYMBOL\tSCALE\n$\t0\nP\t1\nS\t2\nL\t2\nO\t2\nLeaf\t2\nFruit\t2\n"
          "MTG:\nENTITY-CODE\t\tXX\tYY\tZZ\t"
        + columns + "\n/P1/S1\t\t0\t0\t0\n^<S2\t\t0\t0\t2\n" + lines;
    auto read = parse_mtg_with_warnings("tree.mtg", text);
    EXPECT_TRUE(read) << read.error().message;
    if (!read)
        return {};
    check_plant(read->plant);
    return *std::move(read);
}

TEST(MtgOrgans, AreReadInTheFilesUnitAndWithoutWhatMayBeLeftOut)
{
    auto const read = with_table("\t+L1\t1\t0\t2\t0.5\t2\t0\t0\n");
    EXPECT_TRUE(read.warnings.empty());
    ASSERT_EQ(read.plant.organs.size(), 1u);
    auto const& organ = read.plant.organs[0];
    EXPECT_EQ(organ.segment, 0u);
    EXPECT_LT((organ.position_mm - Vec3(1000, 0, 2000)).norm(), 1e-9);
    EXPECT_LT((organ.orientation * Vec3::UnitY() - Vec3::UnitX()).norm(), 1e-12);
    EXPECT_LT((organ.orientation * Vec3::UnitZ() - Vec3::UnitZ()).norm(), 1e-12);
    auto const& shape = read.plant.organ_shapes[organ.shape];
    EXPECT_EQ(shape.kind, OrganShape::Kind::Blade);
    EXPECT_EQ(shape.length_mm, 500);
    EXPECT_EQ(shape.width_mm, 250);
}

TEST(MtgOrgans, StandOnTheGroundWhereNoSegmentEnds)
{
    auto const read = parse_mtg("tree.mtg", [] {
        auto plant = small_plant();
        plant.organs[0].segment = kNone;
        return graph_of(plant);
    }());
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_EQ(read->organs.size(), 1u);
    EXPECT_EQ(read->organs[0].segment, kNone);
}

TEST(MtgOrgans, ThatCannotBePlacedAreCountedAndNamed)
{
    // Leaf1 has neither direction nor length.
    auto const read = with_table("\t+Leaf1\t1\t0\t2\n"
                                 "\t+Leaf2\t\t\t\t1\t0\t0\t1\n" // Leaf2 has no position.
                                 // Leaf3 and Fruit1 have incomplete positions.
                                 "\t+Leaf3\t1\t\t2\t1\t0\t0\t1\n"
                                 "\t+Fruit1\t1\tNA\t2\t1\t0\t0\t1\n"
                                 "\t+Fruit2\t1\t0\t2\t1\t0\t0\t0\n" // Fruit2 has no direction.
                                 "\t+L1\t1\t0\t2\t1\t0\t0\t1\n");
    EXPECT_EQ(read.plant.organs.size(), 1u);
    ASSERT_EQ(read.warnings.size(), 1u);
    EXPECT_EQ(read.warnings[0],
              "tree.mtg: left out organs that have no place, direction and length in it: "
              "3 Leaf, 2 Fruit");
}

// Without these columns, L and O may be internodes in files of other programs, and must be read as
// such.
TEST(MtgOrgans, AreOnlyThoseOfFilesWithTheirColumns)
{
    auto const read = with_table("^<L3\t\t0\t0\t3\n\t+O1\t1\t0\t2\n\t+Leaf1\t1\t0\t2\n", "diam");
    EXPECT_EQ(read.plant.segment_count(), 3u);
    EXPECT_TRUE(read.plant.organs.empty());
    ASSERT_EQ(read.warnings.size(), 1u);
    EXPECT_NE(read.warnings[0].find(": 1 Leaf"), std::string::npos) << read.warnings[0];
}

TEST(MtgOrgans, AreLeftOutWhereTheirSizesAreNone)
{
    auto const read = with_table("\t+L1\t1\t0\t2\t1e300\t0\t0\t1\n"
                                 "\t+L2\t1\t0\t2\tinf\t0\t0\t1\n"
                                 "\t+L3\t1\t0\t2\tnan\t0\t0\t1\n"
                                 "\t+L4\t1\t0\t2\t1\t1e300\t0\t1\n"
                                 "\t+L5\t1\t0\t1e9\t1\t0\t0\t1\n"
                                 "\t+L6\t1\t0\t2\t1\t0\t0\t1\t1\t-inf\n");
    EXPECT_TRUE(read.plant.organs.empty());
    ASSERT_EQ(read.warnings.size(), 1u);
    EXPECT_NE(read.warnings[0].find(": 6 L"), std::string::npos) << read.warnings[0];
    // Very small organs must not get infinite scales, which check_plant() would find.
    auto const small = with_table("\t+L1\t1\t0\t2\t0\t0\t0\t1\t1e-300\t9\n"
                                  "\t+L2\t1\t0\t2\t-1\t0\t0\t1\t0\t0\t9\n");
    EXPECT_EQ(small.plant.organs.size(), 2u);
    EXPECT_EQ(with_table("\t+L1\t1\t0\t2\t1\t0\t0\t1\t1e-45\t9\n").plant.organs.size(), 1u);
}

TEST(MtgOrgans, CostNoMoreMeshesThanPlantsHave)
{
    std::string lines;
    for (int i = 0; i < 70'000; ++i)
        lines += fmt::format("\t+L{0}\t1\t0\t2\t1\t0\t0\t1\t1\t\t\tblade-{0}\n", i);
    auto const read = with_table(lines);
    EXPECT_EQ(read.plant.organs.size(), 70'000u);
    EXPECT_EQ(read.plant.organ_shapes.size(), 1001u);
}

} // namespace
} // namespace tractus
