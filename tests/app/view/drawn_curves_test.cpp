#include "app/view/drawn_curves.h"

#include "app/methods/indicators/indicator_curves.h"
#include "app/view/branch_words.h"
#include "app/view/ink_line.h"
#include "engine/scene/edit.h"
#include "tests/app/small_model.h"
#include "tests/engine/scene/edits.h"
#include "tests/engine/scene/limbs.h"

#include <array>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tractus::view {
namespace {

using variation::Propagation;

constexpr std::array kLists { &indicators::indicator_curves };

// Returns the curves of a scene in which every stroke has ink, as in the view of the station.
std::vector<DrawnCurveView> curves_of(scene::Scene const& scene)
{
    std::vector<SharedVector<TipSample>> strokes;
    std::vector<InkLine> lines;
    for (auto const& [id, association, at] : scene.associations) {
        strokes.push_back(association.stroke.tips);
        lines.push_back(ink_line(association.stroke.tips.vector(), {}));
    }
    return drawn_curves(scene, { strokes, lines }, kLists);
}

std::string names_of(std::vector<DrawnCurveView> const& curves)
{
    std::string names;
    for (auto const& curve : curves)
        names += curve.name + "\n";
    return names;
}

scene::Edit drawn(Vec3 const& end_mm, Propagation propagation = Propagation::Selected)
{
    return scene::Associate { .stroke = scene::stroke_towards(end_mm), .propagation = propagation };
}

// Returns an edit that selects paths. The trunk has the segments 0 to 5; its two branches have the
// segments 6 and 7, and 8 to 11.
scene::Edit selected(variation::Selection paths)
{
    return scene::Select { std::move(paths) };
}

TEST(DrawnCurves, AreNoneOfAnEmptyDocument)
{
    EXPECT_TRUE(curves_of({}).empty());
    EXPECT_TRUE(curves_of(small_scene()).empty());
    EXPECT_TRUE(drawn_curves(small_scene(), {}, {}).empty());
}

TEST(DrawnCurves, ComeInOrderWithTheNamesOfWhatTheyDid)
{
    scene::Edit const wind
        = scene::Indicate { .indicator = { { 0, 0, 100 }, { 30, 0, 100 } }, .below = {} };
    auto const scene = scene::after(
        { selected({ { 8, 9, 10, 11 } }), drawn({ 20, 0, 0 }, Propagation::Both), wind,
          selected({ { 0, 1, 2, 3, 4, 5 } }), drawn({ 0, 20, 0 }, Propagation::Descendants) },
        small_scene());
    auto const curves = curves_of(scene);
    EXPECT_EQ(names_of(curves),
              "Draw: branch 1 at segment 3 of stem 1, with all it bears\n"
              "Lean: the whole plant\n"
              "Draw: stem 1, all it bears\n");
    ASSERT_EQ(curves.size(), 3u);
    EXPECT_EQ(curves[0].line.points.size(), 21u);
    EXPECT_TRUE(curves[0].line.points.back().position_mm.isApprox(Vec3f(20, 0, 100)));
    EXPECT_EQ(curves[1].line.look, tools::InkStyle::Look::Arrow);
    EXPECT_TRUE(curves[1].paths.empty());
    EXPECT_FALSE(curves[0].is_selected);
    EXPECT_TRUE(curves[2].is_selected) << "the trunk is selected";
    EXPECT_LT(curves[0].edit, curves[1].edit);
    EXPECT_LT(curves[1].edit, curves[2].edit);
}

// Each curve must know the paths that it shapes, since picking a curve selects them.
TEST(DrawnCurves, KnowThePathsThatTheyShape)
{
    auto scene = scene::after({ selected({ { 6, 7 }, { 8, 9, 10, 11 } }), drawn({ 20, 0, 0 }),
                                selected({ { 0, 1, 2 } }) },
                              small_scene());
    auto const curves = curves_of(scene);
    ASSERT_EQ(curves.size(), 1u) << "one stroke, though it shapes two branches";
    EXPECT_EQ(curves[0].name, "Draw: 2 branches");
    EXPECT_FALSE(curves[0].is_selected);
    scene = scene::after({ scene::Select { .at = curves[0].paths } }, std::move(scene));
    EXPECT_EQ(scene.selection.size(), 2u);
    EXPECT_EQ(scene.selection[1], (std::vector<SegmentId> { 8, 9, 10, 11 }));
    EXPECT_TRUE(curves_of(scene)[0].is_selected);
}

TEST(DrawnCurves, LeaveOutWhatALaterStrokeOverrides)
{
    auto scene = scene::after(
        { selected({ { 0, 1, 2 } }), drawn({ 20, 0, 0 }), drawn({ -20, 0, 0 }) }, small_scene());
    auto const curves = curves_of(scene);
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_LT(curves[0].line.points.back().position_mm.x(), 0);
    scene = scene::after({ scene::DeleteStroke { { .ids = { scene.associations[1].id } } } },
                         std::move(scene));
    auto const before = curves_of(scene);
    ASSERT_EQ(before.size(), 1u) << "the earlier one shapes it again";
    EXPECT_GT(before[0].line.points.back().position_mm.x(), 0);
}

// A tall trunk has a thousand branches, and each of them is shaped by a stroke.
TEST(DrawnCurves, AreAsManyAsAThousand)
{
    constexpr int kBranches = 1000;
    std::string axiom;
    for (int i = 0; i < kBranches; ++i)
        axiom += "F(10)[+(60)F(8)]";
    scene::LoadModel const model { .source = { .name = "tall.l",
                                               .text = "Lsystem: 1\nderivation length: 0\nAxiom: "
                                                   + axiom + "F(10)\nA --> A\nendlsystem\n" } };
    auto scene = scene::apply_edit({}, model).value();
    std::vector<scene::Edit> edits;
    for (SegmentId i = 0; i < kBranches; ++i) {
        edits.push_back(selected({ { kBranches + 1 + i } }));
        edits.push_back(drawn({ static_cast<double>(i) - 500, 20, 0 }));
    }
    scene = scene::apply_edits(std::move(scene), edits).value();
    auto const curves = curves_of(scene);
    ASSERT_EQ(curves.size(), std::size_t { kBranches });
    std::set<std::string> names;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        names.insert(curves[i].name);
        ASSERT_TRUE(i == 0 || curves[i - 1].edit < curves[i].edit);
    }
    EXPECT_EQ(names.size(), std::size_t { kBranches });
    EXPECT_EQ(curves.back().name, "Draw: branch 1 at segment 1000 of stem 1");
}

TEST(BranchWords, NameTheBranchThatASegmentIsOn)
{
    EXPECT_EQ(branch_in_words({ 0, 4 }), "stem 1");
    EXPECT_EQ(branch_in_words({ 2, 4, 1, 0 }), "branch 2 at segment 5 of stem 3");
    EXPECT_EQ(branch_in_words({ 0, 4, 1, 0, 0, 7 }),
              "branch 1 at segment 1 of branch 2 at segment 5 of stem 1");
    EXPECT_EQ(branch_in_words({ kKeyedAxis, 77, 0, 1u << 30 }), "a branch");
    EXPECT_EQ(branch_in_words({ kKeyedAxis, 77, 0, 1u << 30, 0, 2 }),
              "branch 1 at 50 % of a branch");
    EXPECT_EQ(branch_in_words({}), "a branch");
}

TEST(DrawnCurves, AreLimbsToo)
{
    auto const tree = scene::tree_scene();
    auto const places_mm
        = scene::winding(tree.placement.world_of_plant(tree.base->node_position_mm[3]), 300);
    auto const limb = scene::on_segment(tree, 2, places_mm);
    auto scene = scene::after({ limb }, tree);
    auto curves = curves_of(scene);
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_EQ(curves[0].name, "New limb: on stem 1");
    EXPECT_EQ(curves[0].edit, scene.state.last_edit);
    EXPECT_FALSE(curves[0].is_selected);
    for (bool const is_end : { false, true }) {
        auto const& points = curves[0].line.points;
        Vec3 const shown_mm = (is_end ? points.back() : points.front()).position_mm.cast<double>();
        EXPECT_LT((shown_mm - (is_end ? places_mm.back() : places_mm.front())).norm(), 1e-3);
    }
    // Picking the curve selects the limb. The curve moves with the branch that carries the limb,
    // and is listed after the strokes drawn earlier.
    scene = scene::after({ scene::Select { .at = curves[0].paths } }, scene);
    EXPECT_EQ(scene.selection.vector().front(), segments_of(scene::limb_axis(scene)));
    EXPECT_TRUE(curves_of(scene)[0].is_selected);
    scene
        = scene::after({ scene::select_paths(scene, { segments_of(scene.base->axes[0]) }),
                         scene::Associate { .stroke = scene::stroke_towards({ 200, 0, 300 }),
                                            .laying = variation::StrokeLaying::HeadingAndPitch } },
                       scene);
    curves = curves_of(scene);
    ASSERT_EQ(curves.size(), 2u);
    EXPECT_EQ(curves[0].name, "New limb: on stem 1");
    EXPECT_GT((curves[0].line.points.front().position_mm.cast<double>() - places_mm.front()).norm(),
              10);
    scene = scene::after(
        { scene::EraseLimb { scene.state.active, scene::limb_segments(scene)[0].first->limb->id } },
        scene);
    EXPECT_EQ(curves_of(scene).size(), 1u);
}

} // namespace
} // namespace tractus::view
