#include "app/tools/limb_tool.h"

#include "app/tools/bent_plant.h"
#include "app/tools/underground.h"
#include "engine/stroke/foot_first.h"
#include "engine/stroke/frame_rotation.h"
#include "engine/stroke/polyline.h"
#include "engine/variation/subtree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace tractus::tools {

namespace {

// Maximum distance of a limb's start from a branch's bark, as a share of the plant's height.
constexpr double kLimbReach = 0.25;

// Maximum distance of an erasing touch from the limb, horizontally and vertically.
constexpr double kBesideLimb_mm = 10;
constexpr double kAboveLimb_mm = 30;

// Option words, in the order of LimbTool::Does.
constexpr std::array<OptionWord, 2> kLimbWords { {
    { "add", "New limb" },
    { "take", "Erase limb", "Erase a drawn limb" },
} };

void visit(OptionVisitor& visitor, LimbTool& tool)
{
    visitor.choice({ kLimbWords, WordOption::Offered::InHand }, tool.does);
    visitor.number({ "thickness", "", 0.1, 4, 0.1, "Thickness" }, tool.thickness);
    visit_base(visitor, tool.base);
}

// The point of an axis that is nearest to a given place.
struct AxisPoint {
    SegmentId segment = 0;
    double share = 0;             // Position on the segment: 0 at its base, 1 at its end.
    Vec3 place_mm = Vec3::Zero(); // The point itself, world frame.
    double distance_mm = std::numeric_limits<double>::infinity();
};

// Distance of a place from the bark, if `point` is the nearest AxisPoint; negative inside the wood.
double off_wood_mm(scene::BuiltPlant const& plant, AxisPoint const& point)
{
    auto const node = nodes_of(*plant.base, point.segment);
    auto const radius = [&](NodeId id) {
        return plant.placement.scale * static_cast<double>(plant.base->node_radius_mm[id]);
    };
    return point.distance_mm
        - (radius(node.base) + point.share * (radius(node.tip) - radius(node.base)));
}

AxisPoint point_of(BentPlant const& bent, SegmentId segment, Vec3 const& near_mm)
{
    Vec3 const from_mm = bent.begin_of(segment);
    Vec3 const to_mm = bent.end_of(segment);
    double const share = nearest_share(near_mm, from_mm, to_mm);
    Vec3 const place_mm = from_mm + share * (to_mm - from_mm);
    return { segment, share, place_mm, (place_mm - near_mm).norm() };
}

// Of all axis points, the one whose bark is nearest to `near_mm`. The plant must have a segment.
AxisPoint nearest_wood(scene::BuiltPlant const& plant, BentPlant const& bent, Vec3 const& near_mm)
{
    AxisPoint nearest;
    double nearest_mm = std::numeric_limits<double>::infinity();
    for (SegmentId segment = 0; segment < plant.base->segment_count(); ++segment) {
        auto const point = point_of(bent, segment, near_mm);
        if (double const off_mm = off_wood_mm(plant, point); off_mm < nearest_mm) {
            nearest_mm = off_mm;
            nearest = point;
        }
    }
    return nearest;
}

Result<std::vector<scene::Edit>> erase_limb(Stroke const& stroke, scene::Scene const& scene)
{
    Vec3 const touch_mm = stroke.tips.front().position_mm;
    std::optional<scene::EraseLimb> nearest;
    double nearest_mm = std::numeric_limits<double>::infinity();
    for (auto const& plant : scene.plants) {
        auto const limbs = scene::limb_segments(*plant);
        if (plant->drawn->is_hidden || limbs.empty())
            continue;
        BentPlant const bent(*plant);
        for (auto const& [graft, first] : limbs)
            for (auto const& [id, begin] : variation::subtree_of(*plant->base, first)) {
                auto const& axis = plant->base->axes[id];
                for (auto segment = begin; segment < axis.first_segment + axis.segment_count;
                     ++segment) {
                    auto const point = point_of(bent, segment, touch_mm);
                    Vec3 const off_mm = point.place_mm - touch_mm;
                    if (off_mm.head<2>().norm() > kBesideLimb_mm
                        || std::abs(off_mm.z()) > kAboveLimb_mm || point.distance_mm > nearest_mm)
                        continue;
                    nearest_mm = point.distance_mm;
                    nearest = { plant->drawn->id, graft->limb->id };
                }
            }
    }
    if (!nearest)
        return fail(Fault::User, "no drawn limb is here: touch one where the pad shows it");
    return std::vector<scene::Edit> { *nearest };
}

Result<std::vector<scene::Edit>> draw_limb(Tool const& tool, Stroke const& stroke,
                                           scene::Scene const& scene)
{
    auto const& options = *tool.get<LimbTool>();
    if (options.does == LimbTool::Does::Erase)
        return erase_limb(stroke, scene);
    std::vector<scene::Edit> edits;
    edits.push_back(TRY(drawn_limb(options, stroke, scene)));
    return edits;
}

scene::BuiltPlant const& plant_with_limb(scene::Scene const& scene, scene::DrawLimb const& limb)
{
    return *scene.plants[*scene::find_plant(scene.state, limb.plant)];
}

// A limb without its stroke, as it is joined to the wood nearest to a place.
struct JoinedLimb {
    scene::DrawLimb limb;
    double off_mm = 0; // Distance of the place from the wood.
};

std::optional<JoinedLimb> joined_limb(Vec3 const& place_mm, scene::Scene const& scene)
{
    std::optional<JoinedLimb> joined;
    for (auto const& plant : scene.plants) {
        if (plant->drawn->is_hidden || plant->base->segment_count() == 0)
            continue;
        BentPlant const bent(*plant);
        auto const nearest = nearest_wood(*plant, bent, place_mm);
        double const off_mm = off_wood_mm(*plant, nearest);
        if (off_mm > kLimbReach * plant->placement.shown_height_mm
            || (joined && off_mm >= joined->off_mm))
            continue;
        Eigen::AngleAxisd const turn(bent.turn_of(nearest.segment).conjugate());
        joined = { scene::DrawLimb {
                       .plant = plant->drawn->id,
                       .at = plant->rest->addresses.address_of(*plant->base, nearest.segment),
                       .joint = nearest.share,
                       .joint_mm = nearest.place_mm,
                       .turn_rad = turn.angle() * turn.axis(),
                       .scale = plant->placement.scale,
                   },
                   off_mm };
    }
    return joined;
}

// True if a stroke was drawn from a limb's tip to the branch that is to bear the limb: it ends on
// the wood, and begins in the air. `begin` and `end` are joined at its first and last point.
bool is_drawn_to_branch(Stroke const& stroke, std::optional<JoinedLimb> const& begin,
                        std::optional<JoinedLimb> const& end)
{
    constexpr double kOnWood_mm = 2;
    // Minimum distance of a beginning in the air from the wood, as a share of the distance between
    // the stroke's ends.
    constexpr double kInAir = 0.5;
    double const reach_mm
        = (stroke.tips.back().position_mm - stroke.tips.front().position_mm).norm();
    return end && end->off_mm <= kOnWood_mm && (!begin || begin->off_mm > kInAir * reach_mm)
        && reach_mm > kOnWood_mm;
}

// ToolKind::describe of the tool: says so if the last edit has drawn a limb from its tip.
std::string limb_message(Tool const& tool, scene::Scene const& after)
{
    for (auto const& plant : after.state.plants)
        for (auto const& graft : plant->grafts)
            if (graft.limb && graft.limb->is_drawn_reversed
                && scene::edit_of_item(graft.limb->id) == after.state.last_edit)
                return "The limb was drawn from its tip to its branch and is turned round";
    return underground_message(tool, after);
}

// Previews the limb, with its twigs, while the user draws it.
class LimbPreviewer final : public StrokePreviewer {
public:
    std::vector<SkeletonLine> show(UnfinishedStroke const& stroke) override
    {
        auto tool = *stroke.tool.get<LimbTool>();
        // An unfinished stroke that comes near another branch may still leave it again.
        tool.base = StrokeBase::AsDrawn;
        if (tool.does == LimbTool::Does::Erase || stroke.ink.empty())
            return {};
        Stroke const ink { std::vector(stroke.ink.begin(), stroke.ink.end()) };
        Vec3 const begin_mm = stroke.ink.front().position_mm;
        if (scene_ != stroke.scene || begin_mm_ != begin_mm || thickness_ != tool.thickness) {
            limb_ = drawn_limb(tool, ink, *stroke.scene);
            scene_ = stroke.scene;
            begin_mm_ = begin_mm;
            thickness_ = tool.thickness;
        }
        if (!limb_)
            return {};
        limb_->stroke = ink;
        auto const points = scene::limb_points(*limb_);
        return points ? lines_of(*points, stroke.orders) : std::vector<SkeletonLine>();
    }

private:
    std::vector<SkeletonLine> lines_of(std::vector<variation::LimbPoint> const& points,
                                       std::uint32_t orders) const
    {
        auto const& bearer = plant_with_limb(*scene_, *limb_);
        auto const segment = *bearer.rest->addresses.find_segment(*bearer.base, limb_->at);
        auto const& axis = bearer.base->axes[axis_of(*bearer.base, segment)];
        auto const node = nodes_of(*bearer.base, segment);
        variation::LimbAttachment const seat {
            .order = axis.order,
            .direction = tangent_of(bearer.rest->frame[segment]),
            .radius_mm = static_cast<double>(bearer.base->node_radius_mm[node.tip]),
        };
        auto const limb = variation::make_limb(*bearer.base, *bearer.rest, points, seat);
        double const angle = limb_->turn_rad.norm();
        Quat const turn = angle > 0 ? Quat(Eigen::AngleAxisd(-angle, limb_->turn_rad / angle))
                                    : Quat(Quat::Identity());
        auto const& shown = scene_->placement; // Lines are in the active plant's frame.
        std::vector<SkeletonLine> lines;
        for (auto const& own : limb.axes) {
            bool const is_limb = own.order == 0;
            if (!is_limb && axis.order + 1 + own.order >= orders)
                continue;
            auto& line = lines.emplace_back();
            line.state = SkeletonLine::State::Assigned;
            line.width_mm = 2 * limb.node_radius_mm[own.first_node]
                * static_cast<float>(limb_->scale / shown.scale);
            for (auto const& node_mm : limb.positions(own)) {
                Vec3 const world_mm = limb_->joint_mm + limb_->scale * (turn * node_mm);
                line.points_mm.push_back(shown.plant_of_world(world_mm).cast<float>());
            }
        }
        return lines;
    }

    // Scene for which limb_ was found; shared with the document, which may go on to a newer scene.
    std::shared_ptr<scene::Scene const> scene_;
    Vec3 begin_mm_ = Vec3::Zero();
    double thickness_ = 0;
    // Limb of the current stroke; cached, because finding it visits all branches.
    Result<scene::DrawLimb> limb_;
};

} // namespace

Result<scene::DrawLimb> drawn_limb(LimbTool const& tool, Stroke const& stroke,
                                   scene::Scene const& scene)
{
    if (stroke.tips.empty())
        return fail(Fault::User, "a limb needs a stroke: draw it from where it begins to its tip");
    auto joined = joined_limb(stroke.tips.front().position_mm, scene);
    bool is_reversed = false;
    if (tool.base == StrokeBase::AtFoot) {
        auto end = joined_limb(stroke.tips.back().position_mm, scene);
        is_reversed = is_drawn_to_branch(stroke, joined, end);
        if (is_reversed)
            joined = std::move(end);
    }
    if (!joined)
        return fail(Fault::User,
                    "no branch is near where the stroke begins: begin it on a branch, or closer to "
                    "one");
    auto limb = std::move(joined->limb);
    limb.width_mm = kInkWidth_mm * tool.thickness;
    limb.stroke = is_reversed ? turned_round(stroke) : stroke;
    limb.is_drawn_reversed = is_reversed;
    return limb;
}

constexpr ToolKind LimbTool::kKind {
    .word = "draw_limb",
    .label = "New limb",
    .title = "Draw a new limb",
    .done = "A new limb stands on the branch",
    .help
    = "adds a limb along the stroke to the branch on which it begins, or that is nearest; it "
      "bears twigs like the plant's own branches, is as thick as the ink, or thicker or "
      "thinner by a factor, and is then shaped as they are; a stroke from its tip to a branch is "
      "turned round; or takes a drawn limb away that is touched, as the pen's other end does",
    .group = "Draw",
    .key = 'B',
    .min_extent_mm = 6,
    .options = options_type<LimbTool, visit>(),
    .edits_for = draw_limb,
    .describe = limb_message,
    .previewer
    = []() -> std::unique_ptr<StrokePreviewer> { return std::make_unique<LimbPreviewer>(); },
    .other_end = { &LimbTool::kKind,
                   [] {
                       return std::shared_ptr<void>(
                           std::make_shared<LimbTool>(LimbTool { LimbTool::Does::Erase }));
                   } },
};

} // namespace tractus::tools
