#include "app/methods/self_organising/growth_brush_tool.h"
#include "app/tools/stroke_previewer.h"
#include "engine/methods/self_organising/tree_plant.h"

#include <memory>
#include <utility>
#include <vector>

namespace tractus::self_organising {

namespace {

class GrowthBrushPreviewer final : public tools::StrokePreviewer {
public:
    std::vector<tools::SkeletonLine> show(tools::UnfinishedStroke const& stroke) override
    {
        auto const& tool = *stroke.tool.get<GrowthBrushTool>();
        Stroke const ink { std::vector(stroke.ink.begin(), stroke.ink.end()) };
        using What = GrowthBrushTool::What;
        bool const is_at_once
            = tool.what != What::GoOn && tool.what != What::New && tool.what != What::From;
        auto life = is_at_once ? Result<BrushStrokeLife>(BrushStrokeLife {})
                               : life_of_brush_stroke(tool, ink, *stroke.scene);
        if (is_at_once || !life)
            return {};
        // The preview changes only when a further year of growth is complete.
        if (shown_scene_ == stroke.scene && shown_years_ == life->part.years
            && began_ == ink.tips.front().time)
            return shown_lines_;
        auto lines = grow(tool, *std::move(life), *stroke.scene);
        shown_scene_ = stroke.scene;
        began_ = ink.tips.front().time;
        shown_lines_ = lines;
        return lines;
    }

private:
    std::vector<tools::SkeletonLine> grow(GrowthBrushTool const& tool, BrushStrokeLife life,
                                          scene::Scene const& scene)
    {
        shown_years_ = life.part.years;
        auto scale = scene.state.scale.value_or(LifePeriod {}.scale);
        GrownTree tree;
        Vec3 stands_at_mm = scene.drawn->stands_at_mm;
        bool const is_from = tool.what == GrowthBrushTool::What::From;
        if (is_from && scene.plants.empty())
            return {};
        if (is_from) {
            auto begun = tree_from(tool, scene);
            if (!begun)
                return {};
            tree = *std::move(begun);
            // Without a growth period so far, the tree begins with the plant as it is shown.
            if (tree.life.empty())
                scale = tree.start->scale;
        } else if (life.plant != 0) {
            tree = *grown_tree_of(scene.drawn->source);
        } else {
            tree.habit = habit_of(tool.species, tool.edition);
            tree.seed = 1 + scene.plants.size();
            stands_at_mm = life.part.stroke.tips.front().position_mm;
        }
        life.part.scale = scale;
        life.part.stands_at_mm = stands_at_mm;
        tree.life.push_back(std::move(life.part));
        // The preview shows no leaves; they appear when the pen is lifted.
        tree.habit.leaf_years = 0;
        auto const grown = grow_tree(tree);
        if (!grown)
            return {};
        auto const plant = plant_of(*grown, tree.habit, tree.seed).plant;
        scene::DeskPlacement const from { .scale = scale, .origin_mm = stands_at_mm };
        std::vector<tools::SkeletonLine> lines;
        for (auto const& axis : plant.axes)
            lines.push_back(line_of(plant, axis, from, scene.placement));
        return lines;
    }

    // Converts the active plant to a tree that can continue growing.
    static Result<GrownTree> tree_from(GrowthBrushTool const& tool, scene::Scene const& scene)
    {
        auto const edit = TRY(grow_from_active(scene, habit_of(tool.species, tool.edition), {}));
        auto const* const from = edit.get<GrowFrom>();
        if (!from)
            return *grown_tree_of(scene.drawn->source);
        scene::SceneBuilder builder(scene, {});
        auto const number = TRY(scene::plant_number(scene.state, scene.drawn->id));
        return GrownTree { .habit = from->habit,
                           .seed = from->seed,
                           .start = TRY(beginning_from(scene.state, number, {}, true, builder)) };
    }

    static tools::SkeletonLine line_of(Plant const& plant, Axis const& axis,
                                       scene::DeskPlacement const& from,
                                       scene::DeskPlacement const& to)
    {
        tools::SkeletonLine line;
        line.state = tools::SkeletonLine::State::Assigned;
        line.width_mm
            = 2 * plant.node_radius_mm[axis.first_node] * static_cast<float>(from.scale / to.scale);
        for (auto const& node_mm : plant.positions(axis))
            line.points_mm.push_back(to.plant_of_world(from.world_of_plant(node_mm)).cast<float>());
        return line;
    }

    // Scene for which shown_lines_ were made; shared with the document, which may go on to a newer
    // one.
    std::shared_ptr<scene::Scene const> shown_scene_;
    int shown_years_ = 0;
    Timestamp began_ {};
    std::vector<tools::SkeletonLine> shown_lines_;
};

} // namespace

std::unique_ptr<tools::StrokePreviewer> growth_brush_previewer()
{
    return std::make_unique<GrowthBrushPreviewer>();
}

} // namespace tractus::self_organising
