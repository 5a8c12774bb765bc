#include "engine/variation/stroke_laying.h"

#include "engine/base/random.h"
#include "engine/plant/join_axes.h"
#include "engine/stroke/frame_rotation.h"
#include "engine/variation/place_nodes.h"
#include "tests/corpus.h"
#include "tests/engine/stroke/strokes.h"
#include "tests/engine/variation/plans.h"
#include "tests/engine/variation/plants.h"

#include <fstream>
#include <gtest/gtest.h>
#include <string>

namespace tractus::variation {
namespace {

// A stroke and the branch along which the reference script in Python laid it
// (tests/data/README.md).
struct Case {
    std::string name;
    StrokeFit fit = StrokeFit::Start;
    Vec3 branch;
    Vec3 below;
    std::vector<Vec3> points;
    std::vector<Vec3> laid;
};

Vec3 read_vector(std::istream& in)
{
    Vec3 vector;
    in >> vector.x() >> vector.y() >> vector.z();
    return vector;
}

std::vector<Case> read_cases()
{
    std::ifstream in(shipped("stroke_laying/laid_strokes.txt"));
    std::vector<Case> cases;
    std::string word;
    while (in >> word) {
        EXPECT_EQ(word, "case");
        auto& read = cases.emplace_back();
        std::getline(in >> std::ws, read.name);
        std::string fit;
        in >> word >> fit;
        read.fit = fit == "chord" ? StrokeFit::Chord
            : fit == "world"      ? StrokeFit::World
                                  : StrokeFit::Start;
        in >> word;
        read.branch = read_vector(in).normalized();
        in >> word;
        read.below = read_vector(in).normalized();
        std::size_t count = 0;
        in >> word >> count;
        for (std::size_t i = 0; i < count; ++i) {
            read.points.push_back(read_vector(in));
            read.laid.push_back(read_vector(in));
        }
    }
    return cases;
}

std::vector<Vec3> laid_nodes(Plant const& plant, std::vector<Association> const& associations)
{
    auto const rest = find_rest_shape(plant);
    std::vector<Vec3> nodes_mm;
    place_nodes(plant, rest, resolve_associations(plant, rest, associations).value(), nodes_mm);
    return nodes_mm;
}

// Returns a trunk of one segment towards `below`, with a straight branch on its end. The branch's
// segments are as long as the pieces of the stroke.
Plant plant_of(Case const& wanted)
{
    Plant plant;
    add_axis(plant, { { 0, 0, 0 }, 100 * wanted.below });
    std::vector<Vec3> nodes { 100 * wanted.below };
    for (std::size_t i = 1; i < wanted.points.size(); ++i)
        nodes.push_back(nodes.back()
                        + (wanted.points[i] - wanted.points[i - 1]).norm() * wanted.branch);
    add_axis(plant, nodes, 0, 0);
    return plant;
}

TEST(StrokeLaying, AgreesWithTheReference)
{
    auto const cases = read_cases();
    ASSERT_EQ(cases.size(), 48u);
    for (auto const& wanted : cases) {
        auto const plant = plant_of(wanted);
        for (auto const propagation : { Propagation::Selected, Propagation::Descendants }) {
            bool const is_selected = propagation == Propagation::Selected;
            Association const association { .path = segments_of(plant.axes[is_selected ? 1 : 0]),
                                            .stroke = stroke_of(wanted.points),
                                            .propagation = propagation,
                                            .fit = wanted.fit,
                                            .laying = StrokeLaying::HeadingAndPitch };
            auto const nodes = laid_nodes(plant, { association });
            for (std::size_t i = 0; i < wanted.laid.size(); ++i)
                EXPECT_LT((nodes[2 + i] - nodes[2] - wanted.laid[i]).norm(), 1e-9)
                    << wanted.name << (is_selected ? " selected " : " propagated ") << i;
        }
    }
}

// The tips of a hanging twig and of its mirror image are those in the table of the law's
// description.
TEST(StrokeLaying, GivesThePublishedTips)
{
    struct Row {
        char const* name;
        Vec3 start;
        Vec3 chord;
    };
    std::vector<Row> const rows {
        { "level to +x, hanging", { 102.881, 0, -99.577 }, { 143.178, 0, 0 } },
        { "level to +x, rising", { 102.881, 0, 99.577 }, { 143.178, 0, 0 } },
        { "level to +y, hanging", { 0, 102.881, -99.577 }, { 0, 143.178, 0 } },
        { "level to +y, rising", { 0, 102.881, 99.577 }, { 0, 143.178, 0 } },
        { "45 up to -x, hanging", { -143.159, 0, 2.336 }, { -101.242, 0, 101.242 } },
        { "45 up to -x, rising", { -2.336, 0, 143.159 }, { -101.242, 0, 101.242 } },
        { "30 down to +y, hanging", { 0, 39.309, -137.677 }, { 0, 123.996, -71.589 } },
        { "30 down to +y, rising", { 0, 138.886, 34.796 }, { 0, 123.996, -71.589 } },
        { "80 up to +x, hanging", { 110.869, 31.573, 84.918 }, { 24.863, 0, 141.003 } },
        { "80 up to +x, rising", { -75.139, -31.573, 117.717 }, { 24.863, 0, 141.003 } },
        { "upright, hanging", { 0, 99.577, 102.881 }, { 0, 0, 143.178 } },
        { "upright, rising", { 0, -99.577, 102.881 }, { 0, 0, 143.178 } },
    };
    auto const cases = read_cases();
    for (auto const& row : rows)
        for (auto const& wanted : cases) {
            if (wanted.name != row.name)
                continue;
            auto const plant = plant_of(wanted);
            auto const nodes = laid_nodes(plant,
                                          { { .path = segments_of(plant.axes[1]),
                                              .stroke = stroke_of(wanted.points),
                                              .fit = wanted.fit,
                                              .laying = StrokeLaying::HeadingAndPitch } });
            Vec3 const tip = wanted.fit == StrokeFit::Chord ? row.chord : row.start;
            EXPECT_LT((nodes.back() - nodes[2] - tip).norm(), 1e-3) << row.name;
        }
}

TEST(StrokeLaying, ATrunkTakesTheStrokeAsItLies)
{
    // The strokes are three turns of a vertical helix, and a straight line that leans by 45
    // degrees.
    std::vector<Vec3> helix;
    for (int i = 0; i <= 360; ++i)
        helix.push_back({ 35 * std::cos(radians(3 * i)), 35 * std::sin(radians(3 * i)), 0.7 * i });
    auto const plant = pole(60);
    for (auto const fit : { StrokeFit::Start, StrokeFit::Chord }) {
        auto const tip = [&](std::vector<Vec3> const& points) {
            return laid_nodes(plant,
                              { { .path = segments_of(plant.axes[0]),
                                  .stroke = stroke_of(points),
                                  .fit = fit,
                                  .laying = StrokeLaying::HeadingAndPitch } })
                .back()
                .normalized();
        };
        EXPECT_GT(tip(helix).z(), std::cos(radians(1)));
        EXPECT_LT((tip({ { 0, 0, 0 }, { 80, 0, 80 } }) - Vec3(1, 0, 1).normalized()).norm(), 1e-9);
    }
}

TEST(StrokeLaying, ATurnOfAHelixIsNoDirection)
{
    // The stroke is a horizontal helix towards -y. Its axis must follow the branch, although the
    // stroke begins across it.
    std::vector<Vec3> helix;
    for (int i = 0; i <= 360; ++i)
        helix.push_back(
            { 20 * std::cos(radians(3 * i)), -0.8 * i, 100 + 20 * std::sin(radians(3 * i)) });
    Plant plant = pole(4, 400);
    add_axis(plant, straight({ 0, 0, 400 }, { 300, 0, 700 }, 30), 0, 3);
    auto const nodes = laid_nodes(plant,
                                  { { .path = segments_of(plant.axes[1]),
                                      .stroke = stroke_of(helix),
                                      .laying = StrokeLaying::HeadingAndPitch } });
    Vec3 const along = (nodes.back() - nodes[5]).normalized();
    EXPECT_GT(along.dot(Vec3(1, 0, 1).normalized()), std::cos(radians(3)));
    EXPECT_FALSE(first_turn_share(ArcLength(s_curve(100))));
    EXPECT_NEAR(first_turn_share(ArcLength(helix)).value(), 1.0 / 3, 0.02);
}

TEST(StrokeLaying, NoBranchJumpsNearTheVertical)
{
    Aim const stroke = aim_of_stroke(Vec3(0.8, 0, 0.6), { 1, 0 });
    Vec2 const below = Vec2(0.6, 0.8);
    Vec3 const drawn = Vec3(0.3, 0.5, -0.8).normalized();
    Vec3 before = Vec3::Zero();
    for (int i = -4000; i <= 4000; ++i) {
        double const lean = radians(0.01 * i);
        Vec3 const branch(std::sin(lean), 0.1 * std::sin(lean), std::cos(lean));
        Vec3 const direction = branch.normalized();
        Vec3 const laid
            = lay_by_heading(stroke, { direction, branch_heading(direction, below) }) * drawn;
        if (i > -4000)
            EXPECT_LT((laid - before).norm(), 0.01) << i;
        before = laid;
    }
}

TEST(StrokeLaying, LaterStrokesAndRidesKeepTheirShape)
{
    auto const plant = hand_made_plant();
    std::vector<Vec3> const drawn { { 0, 0, 0 }, { 0, 40, 10 }, { 5, 70, -10 }, { 5, 80, -50 } };
    Association const branch { .path = { 4, 5, 6 },
                               .stroke = stroke_of(drawn),
                               .laying = StrokeLaying::HeadingAndPitch };
    Association const trunk { .path = { 0, 1, 2, 3 },
                              .stroke = stroke_of({ { 0, 0, 0 }, { 0, 30, 90 } }),
                              .laying = StrokeLaying::HeadingAndPitch };
    auto const before = laid_nodes(plant, { branch });
    auto const after = laid_nodes(plant, { branch, trunk });
    // A stroke makes the trunk lean to the side. The branch must move with the trunk, and must hang
    // as before.
    auto const chord = [&](std::vector<Vec3> const& nodes) {
        return Vec3(nodes[plant.axes[1].first_node + 3] - nodes[plant.axes[1].first_node]);
    };
    EXPECT_NEAR(chord(before).z(), chord(after).z(), 1e-6);
    EXPECT_LT(chord(after).z(), -30);
    // If a later stroke bends the middle of a path, the rest of the path must move with the middle.
    auto const pole_plant = pole(12);
    std::vector<Vec3> const bow { { 0, 0, 0 }, { 0, 0, 50 }, { 40, 0, 90 }, { 90, 0, 90 } };
    Association const all { .path = segments_of(pole_plant.axes[0]),
                            .stroke = stroke_of(bow),
                            .laying = StrokeLaying::HeadingAndPitch };
    Association const middle { .path = { 4, 5, 6 },
                               .stroke = stroke_of({ { 0, 0, 0 }, { 0, 9, 0 } }),
                               .laying = StrokeLaying::HeadingAndPitch };
    auto const nodes = laid_nodes(pole_plant, { all, middle });
    EXPECT_LT(((nodes[7] - nodes[4]).normalized() - Vec3::UnitY()).norm(), 1e-12);
    EXPECT_GT((nodes[8] - nodes[7]).normalized().y(), 0.9) << "rides on it";
}

} // namespace
} // namespace tractus::variation
