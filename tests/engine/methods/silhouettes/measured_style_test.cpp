#include "engine/methods/silhouettes/measured_style.h"

#include "engine/scene/scene.h"
#include "tests/corpus.h"
#include "tests/engine/methods/silhouettes/outlines.h"
#include "tests/file_bytes.h"

#include <cmath>
#include <iterator>

namespace tractus::silhouette {
namespace {

// A branch of a plant that the test builds itself.
struct Twig {
    int node = 0; // Index of the trunk's node with the branch.
    double angle_deg = 60;
    double azimuth_deg = 0;
    double length_mm = 100;
};

// Returns a vertical trunk with segments of 10 mm, and with branches of one segment.
Plant plant_of(int segments, std::vector<Twig> const& twigs)
{
    Plant plant;
    plant.materials.emplace_back();
    auto const add_axis = [&](std::vector<Vec3> const& nodes, SegmentId parent) {
        auto const count = static_cast<std::uint32_t>(nodes.size() - 1);
        bool const is_trunk = parent == kNone;
        plant.axes.push_back({ .first_node = static_cast<NodeId>(plant.node_position_mm.size()),
                               .first_segment = static_cast<SegmentId>(plant.segment_count()),
                               .segment_count = count,
                               .parent_segment = parent,
                               .parent_axis = is_trunk ? kNone : 0,
                               .order = is_trunk ? 0u : 1u });
        for (auto const& node : nodes) {
            plant.node_position_mm.push_back(node);
            plant.node_radius_mm.push_back(1);
        }
        plant.segment_material.resize(plant.segment_count() + count, 0);
    };
    std::vector<Vec3> trunk;
    for (int i = 0; i <= segments; ++i)
        trunk.emplace_back(0, 0, 10 * i);
    add_axis(trunk, kNone);
    for (auto const& twig : twigs) {
        double const lean = radians(twig.angle_deg);
        double const turn = radians(twig.azimuth_deg);
        Vec3 const base(0, 0, 10 * twig.node);
        Vec3 const way(std::sin(lean) * std::cos(turn), std::sin(lean) * std::sin(turn),
                       std::cos(lean));
        add_axis({ base, base + twig.length_mm * way }, static_cast<SegmentId>(twig.node - 1));
    }
    check_plant(plant);
    return plant;
}

MeasuredStyle style_of(Plant const& plant)
{
    auto style = measure_style(plant);
    EXPECT_TRUE(style) << style.error().message;
    return style.value_or(MeasuredStyle { .levels = { {} } });
}

TEST(SilhouetteStyle, HasWhatAPlantHas)
{
    auto const plant = plant_of(100,
                                { { 20, 70, 0, 500 },
                                  { 40, 65, 180, 400 },
                                  { 60, 60, 0, 300 },
                                  { 80, 55, 180, 200 },
                                  { 100, 50, 0, 100 } });
    auto const style = style_of(plant);
    ASSERT_EQ(style.levels.size(), 1u);
    auto const& level = style.levels[0];
    EXPECT_EQ(level.parents, 1u);
    EXPECT_EQ(level.children, 5u);
    EXPECT_NEAR(level.style.children, 5, 1e-9);
    EXPECT_NEAR(level.style.unbranched, 0.2, 1e-9);
    EXPECT_NEAR(level.style.spacing, 0.2, 1e-9);
    EXPECT_NEAR(level.style.unevenness, 0, 1e-9);
    EXPECT_NEAR(level.style.spacing_deviation, 0, 1e-9);
    EXPECT_NEAR(level.style.first_angle_deg, 70, 1e-6);
    EXPECT_NEAR(level.style.last_angle_deg, 50, 1e-6);
    EXPECT_NEAR(level.mean_angle_deg, 60, 1e-6);
    EXPECT_NEAR(level.style.angle_deviation_deg, 0, 1e-6);
    EXPECT_EQ(level.pattern, Pattern::TwoRows);
    EXPECT_NEAR(level.divergence_deg, 180, 1e-6);
    EXPECT_NEAR(level.lengths[0], 0.45, 1e-9);
    EXPECT_NEAR(level.lengths[2], 0.15, 1e-9);
}

// Returns the measured pattern of nodes with `size` branches each. From node to node, the branches
// are rotated by `turn_deg`.
Pattern pattern_of_nodes(int size, double turn_deg)
{
    std::vector<Twig> twigs;
    for (int node = 0; node < 12; ++node)
        for (int i = 0; i < size; ++i)
            twigs.push_back({ 5 * node + 5, 60, node * turn_deg + i * 360.0 / size, 50 });
    return style_of(plant_of(60, twigs)).levels[0].pattern;
}

TEST(SilhouetteStyle, KnowsPatterns)
{
    EXPECT_EQ(pattern_of_nodes(1, 137.5), Pattern::Spiral);
    EXPECT_EQ(pattern_of_nodes(1, -144), Pattern::Spiral);
    EXPECT_EQ(pattern_of_nodes(1, 180), Pattern::TwoRows);
    EXPECT_EQ(pattern_of_nodes(2, 90), Pattern::Decussate);
    EXPECT_EQ(pattern_of_nodes(2, 0), Pattern::Horizontal);
    EXPECT_EQ(pattern_of_nodes(3, 60), Pattern::whorls_of(3));
    EXPECT_EQ(pattern_of_nodes(5, 36), Pattern::whorls_of(5));
    EXPECT_EQ(pattern_of_nodes(1, 20), Pattern::Even) << "no pattern has such a turn";
}

TEST(SilhouetteStyle, LeavesTheTrunksContinuationOut)
{
    auto const style = style_of(plant_of(10, { { 5, 60, 0, 50 }, { 10, 8, 0, 50 } }));
    EXPECT_EQ(style.levels[0].children, 1u);
    EXPECT_NEAR(style.levels[0].style.unbranched, 0.5, 1e-9);
    EXPECT_EQ(style.levels[0].style.spacing, 0);
}

TEST(SilhouetteStyle, RefusesWhatHasNoBranches)
{
    for (auto const& plant : { plant_of(1, {}), plant_of(3, { { 3, 2, 0, 50 } }), Plant {} }) {
        auto const style = measure_style(plant);
        ASSERT_FALSE(style);
        EXPECT_EQ(style.error().fault, Fault::User);
        EXPECT_NE(style.error().message.find("no branches"), std::string::npos);
    }
}

TEST(SilhouetteStyle, OfAnyPlantIsAFormThatCanBeBuilt)
{
    std::vector<Twig> many;
    for (int i = 0; i < 5000; ++i)
        many.push_back({ 1 + i % 40, 1.0 + i % 178, 137.5 * i, 0.001 + i % 7 });
    auto const skeleton = infer_skeleton(ellipse(40, 80), { .levels = 1 }).value();
    for (auto const& plant : { plant_of(40, many), plant_of(1, { { 1, 90, 0, 50 } }),
                               plant_of(2, { { 1, 179, 0, 0 }, { 2, 179, 0, 1e6 } }) }) {
        auto const form = form_of(style_of(plant));
        auto const check = check_form(form);
        EXPECT_TRUE(check) << check.error().message;
        check_plant(make_tree(skeleton, tree_options(form, 8000)).plant);
    }
}

Plant tree_of(Drawing const& drawing, TreeForm const& form)
{
    auto const skeleton = infer_skeleton(drawing, skeleton_options(form));
    EXPECT_TRUE(skeleton) << skeleton.error().message;
    return make_tree(*skeleton, tree_options(form, 8000)).plant;
}

// Expects similar numbers of children, distances and angles on a level of two styles.
void expect_near(MeasuredLevel const& given, MeasuredLevel const& wanted, std::string const& what)
{
    constexpr double kNear = 0.1;
    auto const expect = [&](double one, double other, char const* name) {
        EXPECT_NEAR(one, other, kNear * other) << what << ": " << name;
    };
    expect(given.style.children, wanted.style.children, "number of children");
    expect(given.style.spacing, wanted.style.spacing, "spacing");
    expect(given.style.spacing_deviation, wanted.style.spacing_deviation, "spacing's deviation");
    expect(given.mean_angle_deg, wanted.mean_angle_deg, "angle");
}

// Builds a tree, measures its style, applies the style to the same outline with other seeds, and
// compares the styles.
void expect_style_again(Drawing const& drawing, int levels, std::string const& name)
{
    TreeForm usual;
    usual.levels = levels;
    auto const wanted = style_of(tree_of(drawing, usual));
    ASSERT_EQ(wanted.levels.size(), static_cast<std::size_t>(levels)) << name;
    for (std::uint64_t const seed : { 2U, 3U, 4U }) {
        auto form = form_of(wanted);
        EXPECT_EQ(form.levels, levels);
        EXPECT_EQ(form.leaves, usual.leaves);
        EXPECT_NEAR(form.leaf_width, usual.leaf_width, 1e-6);
        form.seed = seed;
        auto const tree = tree_of(drawing, form);
        check_plant(tree);
        auto const given = style_of(tree);
        ASSERT_EQ(given.levels.size(), wanted.levels.size()) << name;
        for (std::size_t level = 0; level < wanted.levels.size(); ++level)
            expect_near(given.levels[level], wanted.levels[level],
                        name + ", seed " + std::to_string(seed) + ", level "
                            + std::to_string(level + 1));
    }
}

TEST(SilhouetteStyle, IsTheSameOnTheSameOutline)
{
    expect_style_again(lobed_crown(7), 2, "lobes");
    expect_style_again(ellipse(40, 80), 2, "ellipse");
}

TEST(SilhouetteStyle, GoesAsDeepAsTheTree)
{
    expect_style_again(lobed_crown(5), 3, "three levels");
}

TEST(SilhouetteStyleCorpus, IsTheSameOnThePublishedOutlines)
{
    REQUIRE_CORPUS();
    for (auto const& published : published_outlines())
        expect_style_again(published.drawing, 2, published.name);
}

TEST(SilhouetteStyle, TheSameSeedGivesTheSameTree)
{
    auto form = form_of(style_of(tree_of(lobed_crown(7), {})));
    auto const one = tree_of(lobed_crown(7), form);
    EXPECT_EQ(one.node_position_mm, tree_of(lobed_crown(7), form).node_position_mm);
    form.seed = 2;
    EXPECT_NE(one.node_position_mm, tree_of(lobed_crown(7), form).node_position_mm);
}

// Grows a model that comes with the program.
Plant grown(std::string const& name)
{
    auto const folder = shipped("../../app/models");
    auto const text = [&](std::string const& file) { return file_bytes(folder / file); };
    lsystem::ModelSource const source { .name = name + ".l",
                                        .text = text(name + ".l"),
                                        .view_name = name + ".v",
                                        .view_text = text(name + ".v") };
    auto const scene = scene::apply_edit({}, scene::LoadModel { .source = source });
    EXPECT_TRUE(scene) << scene.error().message;
    return scene ? *scene->base : Plant();
}

// The crown reaches down to the base of the trunk, so there is room for a style with low branches.
TEST(SilhouetteStyle, GoesFromModelsToAnOutline)
{
    auto drawing = ellipse(40, 80);
    drawing.trunk = upright(-79, 60);
    for (auto const* const name : { "poplar", "conifer", "broadleaf", "shrub", "palm" }) {
        auto const wanted = style_of(grown(name));
        auto form = form_of(wanted);
        for (std::uint64_t const seed : { 1U, 2U, 3U }) {
            form.seed = seed;
            auto const given = style_of(tree_of(drawing, form));
            expect_near(given.levels[0], wanted.levels[0],
                        name + std::string(", seed ") + std::to_string(seed));
        }
    }
}

// Drawn branches must stay in their places, even if the style has fewer branches.
TEST(SilhouetteStyle, KeepsWhatWasDrawn)
{
    auto drawing = lobed_crown(5);
    drawing.branches = { { { 0, -10 }, { 25, 5 }, { 45, 10 }, { 60, 12 } },
                         { { 0, 5 }, { -25, 15 }, { -50, 30 } },
                         { { 0, 20 }, { 15, 35 }, { 30, 60 } } };
    auto form = form_of(style_of(grown("poplar")));
    for (double const children : { form.styles[0].children, 2.0 }) {
        form.styles[0].children = children;
        auto const skeleton = infer_skeleton(drawing, skeleton_options(form)).value();
        auto const placed = make_tree(skeleton, tree_options(form, 8000)).arrangements[0];
        int drawn = 0;
        for (auto const& branch : skeleton.systems[0].branches) {
            if (branch.origin != Branch::Origin::Drawn)
                continue;
            ++drawn;
            auto const found
                = std::find_if(placed.begin(), placed.end(), [&](PlacedBranch const& one) {
                      return one.name == name_of(branch);
                  });
            ASSERT_NE(found, placed.end()) << name_of(branch);
            EXPECT_NEAR(found->place.u, branch.path.t, 0.05) << name_of(branch);
        }
        EXPECT_EQ(drawn, 3);
    }
}

TEST(SilhouetteStyle, RefusesWhatNoTreeHas)
{
    TreeForm form;
    form.styles[0] = { .children = 10, .first_angle_deg = 45, .last_angle_deg = 45 };
    EXPECT_TRUE(check_form(form));
    auto nameless = form;
    nameless.styles[0].children = std::nan("");
    EXPECT_FALSE(check_form(nameless));
    auto wide = form;
    wide.styles[0].last_angle_deg = 200;
    EXPECT_NE(check_form(wide).error().message.find("angle of the last branch"), std::string::npos);
    auto dense = form;
    dense.levels = 3;
    for (auto& style : dense.styles)
        style = { .children = 400, .first_angle_deg = 45, .last_angle_deg = 45 };
    EXPECT_NE(check_form(dense).error().message.find("take fewer levels"), std::string::npos);
}

} // namespace
} // namespace tractus::silhouette
