#include "app/document/document.h"
#include "app/tools/bent_plant.h"
#include "app/tools/limb_tool.h"
#include "engine/plant/mtg.h"
#include "engine/stroke/polyline.h"
#include "tests/app/methods/pairs/document_of_all_methods.h"
#include "tests/app/methods/pairs/plant_of_each_method.h"
#include "tests/app/our_plant.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

// Tests of limbs drawn on plants of every method, and on the program's own models.

namespace tractus::methods {
namespace {

scene::Scene made_by(MethodOfPair const& method)
{
    Steps steps(scene::apply_edit({}, scene::SetScale { 0.1 }).value());
    method.make(steps, 0);
    return steps.scene();
}

// Returns a plant of one of the program's models as if it had been measured: loaded from a
// multiscale tree graph.
scene::Scene measured(std::string_view model)
{
    std::ostringstream text;
    write_mtg(text, *our_plant(model).base);
    return scene::apply_edit({}, scene::LoadMeasured { .name = "a.mtg", .text = text.str() })
        .value();
}

struct NamedScene {
    std::string name;
    scene::Scene scene;
};

std::vector<NamedScene> plants_to_draw_on()
{
    std::vector<NamedScene> all;
    for (auto const& method : kMethods)
        if (std::string_view(method.name) != "a leaf") // A leaf has no branches.
            all.push_back({ method.name, made_by(method) });
    for (auto const* const name : { "birch", "conifer", "fern", "daisy", "palm", "vine" })
        all.push_back({ name, our_plant(name) });
    all.push_back({ "a measured tree", measured("magnolia") });
    return all;
}

double height_mm(scene::Scene const& scene)
{
    return scene.placement.shown_height_mm;
}

// Returns a stroke that begins beside the middle of the plant's first axis, and rises outwards.
Stroke limb_stroke(scene::Scene const& scene)
{
    auto const& trunk = scene.base->axes[0];
    auto const nodes_mm = scene.base->positions(trunk);
    Vec3 const middle_mm = scene.placement.world_of_plant(nodes_mm[nodes_mm.size() / 2]);
    double const size_mm = height_mm(scene);
    Vec3 const from_mm = middle_mm + size_mm * Vec3(0.03, -0.02, 0.01);
    return stroke_through({ from_mm, from_mm + size_mm * Vec3(0.15, -0.05, 0.05),
                            from_mm + size_mm * Vec3(0.3, -0.05, 0.14) });
}

TEST(LimbsOfAll, AreJoinedToTheNearestWood)
{
    for (auto const& plant : plants_to_draw_on()) {
        SCOPED_TRACE(plant.name);
        auto const& scene = plant.scene;
        auto const stroke = limb_stroke(scene);
        auto const limb = tools::drawn_limb({}, stroke, scene);
        ASSERT_TRUE(limb) << limb.error().message;
        Vec3 const from_mm = stroke.tips.front().position_mm;
        auto const off_wood_mm = [&](SegmentId segment, double share) {
            auto const nodes = nodes_of(*scene.base, segment);
            auto const place = [&](NodeId node) {
                return scene.placement.world_of_plant(scene.base->node_position_mm[node]);
            };
            auto const radius_mm = [&](NodeId node) {
                return scene.placement.scale
                    * static_cast<double>(scene.base->node_radius_mm[node]);
            };
            return (place(nodes.base) + share * (place(nodes.tip) - place(nodes.base)) - from_mm)
                       .norm()
                - ((1 - share) * radius_mm(nodes.base) + share * radius_mm(nodes.tip));
        };
        auto const on = *scene.rest->addresses.find_segment(*scene.base, limb->at);
        double const joined_mm = off_wood_mm(on, limb->joint);
        for (SegmentId segment = 0; segment < scene.base->segment_count(); ++segment)
            for (double const share : { 0.0, 0.25, 0.5, 0.75, 1.0 })
                ASSERT_GE(off_wood_mm(segment, share),
                          joined_mm - 1e-9
                              - 0.25 * scene.placement.scale * scene.rest->length_mm[segment])
                    << segment;
    }
}

std::size_t laterals_of(scene::Scene const& scene, AxisId id)
{
    auto const& axes = scene.base->axes;
    return static_cast<std::size_t>(std::count_if(
        axes.begin(), axes.end(), [&](Axis const& axis) { return axis.parent_axis == id; }));
}

TEST(LimbsOfAll, AreSoundAndGrowAndAreErased)
{
    for (auto const& plant : plants_to_draw_on()) {
        SCOPED_TRACE(plant.name);
        auto const& before = plant.scene;
        auto const edits = tools::Tool(tools::LimbTool {}).edits_for(limb_stroke(before), before);
        ASSERT_TRUE(edits) << edits.error().message;
        auto const scene = scene::apply_edits(before, *edits).value();
        check_plant(*scene.base);
        auto const limbs = scene::limb_segments(scene);
        ASSERT_EQ(limbs.size(), 1u);
        auto const id = axis_of(*scene.base, limbs[0].second);
        auto const& limb = scene.base->axes[id];
        // The limb must have about as many laterals per length as some branch of the plant. `least`
        // is the smallest difference in their number, which is scaled by the ratio of lengths.
        double least = std::numeric_limits<double>::infinity();
        for (AxisId other = 0; other < before.base->axes.size(); ++other) {
            double const ratio
                = scene.rest->axis_length_mm[id] / before.rest->axis_length_mm[other];
            double const wanted = static_cast<double>(laterals_of(before, other)) * ratio;
            least = std::min(least, std::abs(static_cast<double>(laterals_of(scene, id)) - wanted));
        }
        EXPECT_LE(least, 1);
        EXPECT_GT(limb.order, 0u);
        EXPECT_TRUE(scene::plan_growth(scene));
        auto const erased
            = scene::apply_edits(scene,
                                 std::vector<scene::Edit> { scene::EraseLimb {
                                     scene.state.active, limbs[0].first->limb->id } });
        ASSERT_TRUE(erased);
        EXPECT_EQ(erased->base->node_position_mm, before.base->node_position_mm);
    }
}

using LimbSessions = session::SessionFolder;

TEST_F(LimbSessions, AreUndoneAndDoneAgainAndReadAgain)
{
    document::Document document(our_plant("shrub"), document::Document::Working::AtOnce);
    auto const before = exported(document.newest()->scene);
    document.draw({ limb_stroke(document.newest()->scene), tools::LimbTool {} });
    auto const drawn = exported(document.newest()->scene);
    EXPECT_NE(drawn, before);
    document.undo();
    EXPECT_EQ(exported(document.newest()->scene), before);
    document.redo();
    EXPECT_EQ(exported(document.newest()->scene), drawn);
    Vec3 const tip_mm = limb_stroke(document.newest()->scene).tips.back().position_mm;
    document.draw({ stroke_through({ tip_mm, tip_mm + Vec3(1, 0, 0) }),
                    tools::LimbTool { tools::LimbTool::Does::Erase } });
    EXPECT_EQ(exported(document.newest()->scene), before);
}

TEST(LimbTool, SaysWhatIsMissing)
{
    auto const scene = small_scene();
    auto const far = tools::Tool(tools::LimbTool {})
                         .edits_for(stroke_through({ { 500, 0, 50 }, { 600, 0, 50 } }), scene);
    ASSERT_FALSE(far);
    EXPECT_NE(far.error().message.find("closer"), std::string::npos);
    EXPECT_FALSE(
        tools::Tool(tools::LimbTool {}).edits_for(stroke_through({ {}, { 9, 0, 0 } }), {}));
    auto const none = tools::Tool(tools::LimbTool { tools::LimbTool::Does::Erase })
                          .edits_for(stroke_through({ { 0, 0, 50 }, { 1, 0, 50 } }), scene);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message.find("no drawn limb"), std::string::npos);
}

} // namespace
} // namespace tractus::methods
