#include "app/tools/branch_previewer.h"

#include "app/tools/tool.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene_builder.h"
#include "engine/scene/scene_shaper.h"
#include "engine/variation/place_nodes.h"

#include <optional>
#include <utility>

namespace tractus::tools {

namespace {

Result<scene::Scene> drawn_scene(UnfinishedStroke const& stroke, scene::Scene scene)
{
    auto const edits = TRY(
        stroke.tool.edits_for(Stroke { std::vector(stroke.ink.begin(), stroke.ink.end()) }, scene));
    return scene::apply_edits(std::move(scene), edits);
}

class BranchPreviewer final : public StrokePreviewer {
public:
    enum class Reads { NoStrokes, Strokes };
    explicit BranchPreviewer(Reads reads)
        : reads_(reads)
    {
    }

    std::vector<SkeletonLine> show(UnfinishedStroke const& stroke) override;

private:
    void lay(std::shared_ptr<scene::Scene const> scene);
    scene::Scene const& readable_scene();
    std::vector<SkeletonLine> moved_lines(std::uint32_t orders) const;

    Reads reads_;
    // Scene for which lay() was last called; shared with the window.
    std::shared_ptr<scene::Scene const> scene_;
    // Copy of scene_ with the tips of all shaping strokes in memory.
    std::optional<scene::Scene> readable_;
    scene::SceneShaper shaper_;
    std::vector<Vec3> before_mm_;
    // Node positions after the stroke; a member so that its memory is reused.
    std::vector<Vec3> after_mm_;
};

void BranchPreviewer::lay(std::shared_ptr<scene::Scene const> scene)
{
    scene_ = std::move(scene);
    readable_.reset();
    // The result can be ignored: each stroke of the scene was checked when it was drawn.
    (void)shaper_.set_plant(*scene_);
    variation::place_nodes(*scene_->base, *scene_->rest, shaper_.shape(), before_mm_);
}

std::vector<SkeletonLine> BranchPreviewer::show(UnfinishedStroke const& stroke)
{
    if (scene_ != stroke.scene)
        lay(stroke.scene);
    auto const scene = drawn_scene(stroke, readable_scene());
    if (!scene || !shaper_.set_plant(*scene))
        return {};
    variation::place_nodes(*scene_->base, *scene_->rest, shaper_.shape(), after_mm_);
    return moved_lines(stroke.orders);
}

scene::Scene const& BranchPreviewer::readable_scene()
{
    if (reads_ == Reads::NoStrokes)
        return *scene_;
    if (!readable_) {
        auto state = scene_->state;
        if (auto const active = scene::find_plant(state, state.active))
            scene::change_plant(state, *active, [&](scene::PlantState& plant) {
                for (auto const number : scene::shaping_numbers(*scene_)) {
                    auto shaping = plant.strokes[number];
                    auto& tips = shaping.what.stroke.tips;
                    if (auto read = tips.in_memory())
                        // If reading fails, the finished stroke reports the error.
                        tips = *std::move(read);
                    plant.strokes.replace(number, std::move(shaping));
                }
            });
        readable_ = scene::SceneBuilder(*scene_, {}).build(std::move(state)).value_or(*scene_);
    }
    return *readable_;
}

std::vector<SkeletonLine> BranchPreviewer::moved_lines(std::uint32_t orders) const
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

} // namespace

std::unique_ptr<StrokePreviewer> branch_previewer()
{
    return std::make_unique<BranchPreviewer>(BranchPreviewer::Reads::NoStrokes);
}

std::unique_ptr<StrokePreviewer> stroke_reading_previewer()
{
    return std::make_unique<BranchPreviewer>(BranchPreviewer::Reads::Strokes);
}

} // namespace tractus::tools
