#include "engine/variation/growth.h"
#include "engine/variation/selection.h"

#include "engine/plant/join_axes.h"
#include "tests/corpus.h"
#include "tests/engine/stroke/corpus_strokes.h"
#include "tests/engine/stroke/strokes.h"
#include "tests/engine/variation/plans.h"
#include "tests/engine/variation/plants.h"

#include <gtest/gtest.h>

namespace tractus::variation {
namespace {

// Returns the segments that a pen selects in the front view of `plant` when it moves up from `from`
// to `to`.
std::vector<SegmentId> select(Plant const& plant, Vec2 const& from, Vec2 const& to)
{
    SkeletonProjection view;
    view.to_plane << 1, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1;
    view.min = Vec2::Constant(-5000);
    view.max = Vec2::Constant(5000);
    ProjectedSkeleton const skeleton(plant, view);
    auto const tree = build_branch_tree(plant);
    PathSelection selection(tree);
    SelectionPen pen(skeleton, tree, selection);
    pen.move_to(from);
    pen.move_to(to);
    auto const paths = selection.finish();
    return paths.empty() ? std::vector<SegmentId> {} : paths.front();
}

TEST(EndToEnd, AHundredThousandSegmentsFromPenToCollection)
{
    auto const plant = forking_tree(14, 7);
    ASSERT_GT(plant.segment_count(), 100'000u);
    auto const path = select(plant, { 0, 100 }, { 0, 990 });
    ASSERT_EQ(path.size(), 7u);

    std::vector<Association> const associations { { .path = path,
                                                    .stroke
                                                    = stroke_of(trembling(s_curve(150), 0.5)),
                                                    .propagation = Propagation::Both } };
    std::vector<MotionIndicator> const wind { { { 0, 0, 0 }, { 80, 0, 0 } } };
    auto const influence
        = influence_of(plant, plant.node_position_mm, wind, { .height_mm = 200 }).value();
    auto const plan = plan_of(plant, {}, influence.everywhere, associations);
    Grower grower(plan);
    std::vector<Vec3> last_tips;
    for (std::uint32_t i = 0; i < 3; ++i) {
        auto const& varied = grower.grow({ .seed = 1, .plant_index = i });
        check_plant(varied);
        EXPECT_EQ(varied.segment_count(), plant.segment_count());
        for (auto const& tip : last_tips)
            EXPECT_GT((tip - varied.node_position_mm.back()).norm(), 1);
        last_tips.push_back(varied.node_position_mm.back());
    }
}

TEST(EndToEnd, StrokesThatPeopleDrewBendAPlant)
{
    auto const plant = forking_tree(7, 12);
    for (char const* name : { "Wire.strokes.txt", "Blue_Tit.strokes.txt" }) {
        auto const strokes = read_strokes(shipped("strokes") / name);
        ASSERT_FALSE(strokes.empty());
        for (auto const& points : strokes) {
            std::vector<Association> const associations { { .path = segments_of(plant.axes[0]),
                                                            .stroke = stroke_of(points),
                                                            .propagation = Propagation::Both,
                                                            .detail_weight = 0.7 } };
            auto const varied = grow({ .plant = plant, .associations = associations });
            ASSERT_TRUE(varied) << name << ": " << varied.error().message;
            check_plant(*varied);
        }
    }
}

} // namespace
} // namespace tractus::variation
