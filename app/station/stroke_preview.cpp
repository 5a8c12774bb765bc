#include "app/station/stroke_preview.h"

#include "app/document/draw.h"
#include "engine/scene/scene_builder.h"
#include "engine/variation/place_nodes.h"

#include <utility>

namespace tractus {

static bool shapes_branches(Tool const& tool)
{
    switch (tool.kind) {
    case Tool::Kind::Draw:
    case Tool::Kind::DrawInOrder:
    case Tool::Kind::Oversketch:
    case Tool::Kind::Erase:
        return true;
    case Tool::Kind::Select:
    case Tool::Kind::Indicate:
    case Tool::Kind::Smooth:
    case Tool::Kind::Delete:
    case Tool::Kind::MoveIndicator:
    case Tool::Kind::DeleteIndicator:
    case Tool::Kind::Press:
    case Tool::Kind::Unknown:
        break;
    }
    return false;
}

void StrokePreview::lay(std::shared_ptr<Scene const> scene)
{
    scene_ = std::move(scene);
    readable_.reset();
    (void)shaper_.set_plant(*scene_); // Each stroke was checked when it was made.
    place_nodes(*scene_->base, *scene_->rest, shaper_.shape(), before_mm_);
}

std::vector<SkeletonLine> StrokePreview::moved_by(WantedPreview const& wanted)
{
    if (!shapes_branches(wanted.tool))
        return {};
    if (scene_ != wanted.scene)
        lay(wanted.scene);
    auto scene = readable_scene(wanted.tool);
    if (!draw(Stroke { wanted.ink }, wanted.tool, scene).refusal.empty()
        || !shaper_.set_plant(scene))
        return {};
    place_nodes(*scene_->base, *scene_->rest, shaper_.shape(), after_mm_);
    return moved_lines(wanted.orders);
}

// The eraser looks at all strokes that shape something, each time: they are read once.
Scene const& StrokePreview::readable_scene(Tool const& tool)
{
    if (tool.kind != Tool::Kind::Erase) {
        readable_.reset();
        return *scene_;
    }
    if (!readable_) {
        auto state = scene_->state;
        if (auto const active = find_plant(state, state.active))
            change_plant(state, *active, [&](PlantState& plant) {
                for (auto const number : shaping_numbers(*scene_)) {
                    auto stroke = plant.strokes[number];
                    auto& tips = stroke.what.stroke.tips;
                    if (auto read = tips.in_memory())
                        tips = *std::move(read); // Else the stroke itself will say why.
                    plant.strokes.replace(number, std::move(stroke));
                }
            });
        readable_ = SceneBuilder(*scene_, {}).build(std::move(state)).value_or(*scene_);
    }
    return *readable_;
}

std::vector<SkeletonLine> StrokePreview::moved_lines(std::uint32_t orders) const
{
    constexpr double kMoved_mm = 1e-3;
    auto const& plant = *scene_->base;
    std::vector<SkeletonLine> lines;
    for (auto const& axis : plant.axes) {
        if (axis.order >= orders)
            continue;
        bool has_moved = false;
        for (auto node = axis.first_node; node <= axis.first_node + axis.segment_count; ++node)
            has_moved |= (after_mm_[node] - before_mm_[node]).squaredNorm() > kMoved_mm * kMoved_mm;
        if (!has_moved)
            continue;
        auto& line = lines.emplace_back();
        line.state = SkeletonLine::State::Assigned;
        line.width_mm = 2 * plant.node_radius_mm[axis.first_node];
        for (auto node = axis.first_node; node <= axis.first_node + axis.segment_count; ++node)
            line.points_mm.push_back(after_mm_[node].cast<float>());
    }
    return lines;
}

} // namespace tractus
