#include "engine/methods/silhouettes/sibling_style.h"

#include "engine/methods/silhouettes/own_outline.h"
#include "engine/methods/silhouettes/tree.h"
#include "tests/engine/methods/silhouettes/refined.h"

#include <algorithm>
#include <cmath>

namespace tractus::silhouette {
namespace {

Skeleton styled(StyleScope style_to, SkeletonOptions const& options = {},
                Similarity const& way = {})
{
    auto drawing = moved(lobed_crown(7), way);
    auto const added = add_own_outline(drawing, way.points(limb()), options, style_to);
    EXPECT_TRUE(added) << added.error().message;
    auto skeleton = infer_skeleton(drawing, options);
    EXPECT_TRUE(skeleton) << skeleton.error().message;
    return skeleton ? *std::move(skeleton) : Skeleton();
}

std::size_t source_of(Skeleton const& skeleton)
{
    auto const& branches = skeleton.systems[0].branches;
    auto const found = std::find_if(branches.begin(), branches.end(),
                                    [](Branch const& branch) { return branch.is_refined(); });
    EXPECT_NE(found, branches.end());
    return static_cast<std::size_t>(found - branches.begin());
}

TEST(SiblingStyle, IsTheSourcesOnAllSiblings)
{
    auto const skeleton = styled(StyleScope::Siblings);
    auto const source = source_of(skeleton);
    auto const own = seen_on(skeleton.systems[skeleton.system_of[0][source]]);
    ASSERT_GE(own.places.size(), 6U);
    double const spacing
        = (own.places.back() - own.places.front()) / static_cast<double>(own.places.size() - 1);
    double first = 0;
    double extent = 0;
    double steps = 0;
    double angle_deg = 0;
    double count = 0;
    for (std::size_t i = 0; i < skeleton.systems[0].branches.size(); ++i) {
        auto const below = skeleton.system_of[0][i];
        if (i == source || skeleton.systems[0].branches[i].origin == Branch::Origin::Apex)
            continue;
        ASSERT_NE(below, kNoSystem) << name_of(skeleton.systems[0].branches[i]);
        auto const has = seen_on(skeleton.systems[below]);
        double const reach = (own.places.back() - own.places.front()) / own.length * has.length;
        EXPECT_NEAR(static_cast<double>(has.places.size()), std::max(reach / spacing, 1.0) + 1,
                    0.75);
        count += 1;
        first += has.places.front() / has.length;
        extent += has.places.back() - has.places.front();
        steps += static_cast<double>(has.places.size() - 1);
        angle_deg += has.angle_deg;
    }
    EXPECT_GE(count, 10);
    EXPECT_NEAR(first / count, own.places.front() / own.length, 0.02);
    EXPECT_NEAR(extent / steps, spacing, 0.1 * spacing);
    EXPECT_NEAR(angle_deg / count, own.angle_deg, 0.1 * own.angle_deg);
}

// Each child of a sibling must have the shape of one of the source's children. A shape is
// recognised, whatever its size, by the straightness of the branch and by the ratio of its crown to
// its length.
TEST(SiblingStyle, GivesSiblingsTheSourcesShapes)
{
    auto const skeleton = styled(StyleScope::Siblings);
    auto const source = source_of(skeleton);
    auto const shape = [](Branch const& branch) {
        auto const& curve = branch.path.curve;
        double const span = (curve.end - curve.base).norm();
        return Vec2(span / length_of(curve.points(33)),
                    std::fabs(signed_area(branch.crown)) / (span * span));
    };
    auto const& children = skeleton.systems[skeleton.system_of[0][source]].branches;
    std::size_t tried = 0;
    for (std::size_t i = 0; i < skeleton.systems[0].branches.size(); ++i) {
        auto const below = skeleton.system_of[0][i];
        if (i == source || below == kNoSystem)
            continue;
        for (auto const& child : skeleton.systems[below].branches) {
            if (child.origin == Branch::Origin::Apex)
                continue;
            ++tried;
            EXPECT_TRUE(std::any_of(children.begin(), children.end(), [&](Branch const& one) {
                return (shape(one) - shape(child)).norm() < 1e-6;
            })) << name_of(child);
        }
    }
    EXPECT_GE(tried, 50U);
}

TEST(SiblingStyle, GoesNowhereUnlessSomebodySaysSo)
{
    auto const plain = styled(StyleScope::None);
    auto const to_all = styled(StyleScope::Siblings);
    auto const source = source_of(plain);
    auto const& own = plain.systems[plain.system_of[0][source]];
    auto const& same = to_all.systems[to_all.system_of[0][source]];
    ASSERT_EQ(own.branches.size(), same.branches.size()) << "the source keeps what it has";
    for (std::size_t k = 0; k < own.branches.size(); ++k)
        EXPECT_EQ(own.branches[k].crown, same.branches[k].crown);
    for (auto const& system : plain.systems)
        EXPECT_FALSE(system.is_in_siblings_style);
    std::size_t models = 0;
    for (auto const& branch : plain.systems[0].branches)
        models += branch.model.has_value();
    EXPECT_GT(models, 0U) << "copies are the source's without a style";
    for (auto const& branch : to_all.systems[0].branches)
        EXPECT_FALSE(branch.model);
}

// The style of a sibling between two sources must be interpolated between their styles.
TEST(SiblingStyle, IsMixedBetweenTwoSources)
{
    auto drawing = lobed_crown(7);
    auto const inferred = infer_skeleton(drawing, { .levels = 1 }).value().systems[0];
    Similarity const mirror { .turn = Vec2(-1, 0), .mirrors = true };
    ASSERT_TRUE(add_own_outline(drawing, limb(), {}, StyleScope::Siblings));
    ASSERT_TRUE(add_own_outline(drawing, mirror.points(limb()), {}, StyleScope::None));
    auto const one = infer_skeleton(drawing).value();
    drawing.own_outlines[1].style_to = StyleScope::Siblings;
    auto const two = infer_skeleton(drawing).value();
    for (auto const& own : drawing.own_outlines) {
        auto const i = *number_of(inferred, own.branch);
        auto const below = one.system_of[0][i];
        ASSERT_NE(below, kNoSystem);
        EXPECT_TRUE(one.systems[below].is_of_own_outline) << "it keeps its own";
        EXPECT_EQ(one.systems[below].branches.size(),
                  two.systems[two.system_of[0][i]].branches.size());
    }
}

TEST(SiblingStyle, IsThereWhereBranchesBearNoOthers)
{
    auto const skeleton = styled(StyleScope::Siblings, { .levels = 1 });
    EXPECT_EQ(styled(StyleScope::None, { .levels = 1 }).systems.size(), 2U);
    EXPECT_GE(skeleton.systems.size(), skeleton.systems[0].branches.size());
    check_plant(make_tree(skeleton).plant);
    check_plant(make_tree(styled(StyleScope::Siblings, { .levels = 3 })).plant);
}

TEST(SiblingStyle, TurnsWithTheDrawing)
{
    Similarity const way { .to = Vec2(40, 7), .turn = Vec2(1.3, 0.8) };
    auto const plain = styled(StyleScope::Siblings);
    auto const other = styled(StyleScope::Siblings, {}, way);
    ASSERT_EQ(plain.systems.size(), other.systems.size());
    double const close = 1e-6 * box_of(other.systems[0].outline).diagonal();
    for (std::size_t s = 0; s < plain.systems.size(); ++s) {
        ASSERT_EQ(plain.systems[s].branches.size(), other.systems[s].branches.size());
        for (std::size_t i = 0; i < plain.systems[s].branches.size(); ++i)
            EXPECT_LT((way.point(plain.systems[s].branches[i].path.curve.end)
                       - other.systems[s].branches[i].path.curve.end)
                          .norm(),
                      close);
    }
}

} // namespace
} // namespace tractus::silhouette
