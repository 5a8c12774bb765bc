#include "app/view/skeleton_picture.h"

#include "engine/variation/place_nodes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace tractus::view {

using State = tools::SkeletonLine::State;

static std::uint32_t orders_to_show(Plant const& plant)
{
    constexpr std::size_t kMaxSegments = 40'000;
    std::vector<std::size_t> segments;
    for (auto const& axis : plant.axes) {
        segments.resize(std::max<std::size_t>(segments.size(), axis.order + 1));
        segments[axis.order] += axis.segment_count;
    }
    auto const chosen
        = std::min<std::size_t>(scene::fit_selection_view(plant).max_order, segments.size());
    std::size_t sum = 0;
    std::size_t order = 0;
    for (; order < segments.size(); ++order) {
        sum += segments[order];
        if (order > chosen && sum > kMaxSegments)
            break;
    }
    return static_cast<std::uint32_t>(order);
}

// Returns a line along successive segments of an axis that have the same state.
static tools::SkeletonLine skeleton_line(Plant const& plant, std::span<Vec3 const> nodes_mm,
                                         Axis const& axis, std::uint32_t from, std::uint32_t to,
                                         State state)
{
    tools::SkeletonLine line;
    line.state = state;
    line.width_mm = 2 * plant.node_radius_mm[axis.first_node + from];
    line.points_mm.reserve(to - from + 1);
    for (std::uint32_t i = from; i <= to; ++i)
        line.points_mm.push_back(nodes_mm[axis.first_node + i].cast<float>());
    return line;
}

// Adds the skeleton of a plant that is not active. Of a large plant only the lowest branching
// orders are added.
static void add_other(scene::BuiltPlant const& plant, scene::DeskPlacement const& active,
                      std::vector<tools::SkeletonLine>& lines)
{
    auto const orders = orders_to_show(*plant.base);
    auto const scale = static_cast<float>(plant.placement.scale / active.scale);
    scene::SceneShaper shaper;
    // Errors can be ignored: each stroke was checked when it was drawn.
    static_cast<void>(shaper.set_plant(plant));
    std::vector<Vec3> nodes_mm;
    variation::place_nodes(*plant.base, *plant.rest, shaper.shape(), nodes_mm);
    for (auto const& axis : plant.base->axes) {
        if (axis.order >= orders)
            continue;
        auto line = skeleton_line(*plant.base, nodes_mm, axis, 0, axis.segment_count, State::Other);
        line.width_mm *= scale;
        for (auto& point_mm : line.points_mm)
            point_mm
                = active.plant_of_world(plant.placement.world_of_plant(point_mm.cast<double>()))
                      .cast<float>();
        lines.push_back(std::move(line));
    }
}

void SkeletonPicture::show_others()
{
    std::vector<std::shared_ptr<scene::BuiltPlant const>> plants;
    for (auto const& plant : scene_->plants)
        if (plant->drawn->id != scene_->drawn->id && !plant->drawn->is_hidden)
            plants.push_back(plant);
    auto const& active = scene_->placement;
    if (plants == other_plants_ && active.origin_mm == seen_from_.origin_mm
        && active.scale == seen_from_.scale)
        return;
    other_plants_ = std::move(plants);
    seen_from_ = active;
    others_.clear();
    for (auto const& plant : other_plants_)
        add_other(*plant, active, others_);
}

void SkeletonPicture::set_scene(std::shared_ptr<scene::Scene const> scene)
{
    bool const is_same_plant = scene_ && scene_->base == scene->base;
    scene_ = std::move(scene);
    show_others();
    // Errors can be ignored: each stroke was checked when it was drawn.
    static_cast<void>(shaper_.set_plant(*scene_));
    variation::place_nodes(*scene_->base, *scene_->rest, shaper_.shape(), nodes_mm_);
    if (is_same_plant)
        return;
    auto const& plant = *scene_->base;
    orders_ = orders_to_show(plant);
    box_mm_ = bounds(plant);
    states_.assign(plant.segment_count(), State::Unselected);
    shown_axes_.clear();
    for (AxisId id = 0; id < plant.axes.size(); ++id)
        if (plant.axes[id].order < orders_)
            shown_axes_.push_back(id);
}

void SkeletonPicture::mark(std::span<SegmentId const> segments, State state)
{
    for (auto const segment : segments)
        states_[segment] = state;
    marked_.insert(marked_.end(), segments.begin(), segments.end());
}

// Marks branches whose shape was changed by propagation. Their rotation relative to their parent
// segment differs from that at rest. Branches that only move along with a bent branch are not
// marked.
void SkeletonPicture::mark_propagated()
{
    // Cosine of half the maximum angle by which rotations that count as equal differ.
    constexpr double kSame = 1 - 1e-9;
    auto const& plant = *scene_->base;
    auto const& rest = scene_->rest->frame;
    auto const& bent = shaper_.shape().frame;
    auto const is_shaped = [&](SegmentId segment, SegmentId parent) {
        Quat const before
            = parent == kNone ? rest[segment] : rest[parent].conjugate() * rest[segment];
        Quat const now = parent == kNone ? bent[segment] : bent[parent].conjugate() * bent[segment];
        return std::abs(before.dot(now)) < kSame;
    };
    for (auto const id : shown_axes_) {
        auto const& axis = plant.axes[id];
        auto parent = axis.parent_segment;
        bool shaped = false;
        bool drawn = false;
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            auto const segment = axis.first_segment + i;
            shaped = shaped || is_shaped(segment, parent);
            drawn = drawn || states_[segment] == State::Assigned;
            parent = segment;
        }
        if (!shaped || drawn)
            continue;
        std::vector<SegmentId> segments(axis.segment_count);
        std::iota(segments.begin(), segments.end(), axis.first_segment);
        mark(segments, State::Assigned);
    }
}

std::vector<tools::SkeletonLine>
SkeletonPicture::lines(tools::ShownSkeleton::Touched const& touched,
                       std::span<SegmentId const> next)
{
    // Only strokes whose effect is not overridden by later strokes on the same branches are marked.
    for (auto const number : scene::shaping_numbers(*scene_))
        mark(scene_->associations[number].what.path, State::Assigned);
    if (!scene_->associations.empty())
        mark_propagated();
    if (next.empty())
        for (auto const& path : scene_->selection)
            mark(path, State::Selected);
    mark(next, State::Next);
    mark(touched.selected, State::Selected);
    mark(touched.undetermined, State::Undetermined);

    auto lines = others_;
    for (auto const id : shown_axes_) {
        auto const& axis = scene_->base->axes[id];
        std::uint32_t from = 0;
        for (std::uint32_t i = 1; i <= axis.segment_count; ++i) {
            auto const state = states_[axis.first_segment + from];
            if (i < axis.segment_count && states_[axis.first_segment + i] == state)
                continue;
            lines.push_back(skeleton_line(*scene_->base, nodes_mm_, axis, from, i, state));
            from = i;
        }
    }
    for (auto const segment : marked_)
        states_[segment] = State::Unselected;
    marked_.clear();
    return lines;
}

} // namespace tractus::view
