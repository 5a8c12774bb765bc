#include "app/methods/leaves/leaf_previewer.h"

#include "app/methods/leaves/leaf_line_tool.h"
#include "app/tools/coming_back.h"
#include "engine/methods/leaves/leaf_lines.h"
#include "engine/methods/leaves/leaf_sketch_edits.h"
#include "engine/scene/paper.h"

#include <utility>
#include <vector>

namespace tractus::leaf {

namespace {

class LeafPreviewer final : public tools::StrokePreviewer {
public:
    std::vector<tools::SkeletonLine> show(tools::UnfinishedStroke const& stroke) override
    {
        if (stroke.ink.size() < 2)
            return {};
        auto const sketch = sketch_with(stroke);
        if (!sketch || !sketch->seen || !sketch->seen->left_out.empty())
            return {};
        auto const lines = leaf::lines_of_leaf(*sketch);
        if (!lines)
            return {};
        std::vector<tools::SkeletonLine> shown;
        for (auto const& line : *lines)
            shown.push_back(shown_line(line, *stroke.scene));
        return shown;
    }

private:
    // Returns the leaf's sketch with the unfinished stroke added.
    static Result<leaf::LeafSketch> sketch_with(tools::UnfinishedStroke const& stroke)
    {
        auto const edits = stroke.tool.edits_for(
            Stroke { std::vector(stroke.ink.begin(), stroke.ink.end()) }, *stroke.scene);
        if (!edits || edits->empty())
            return fail(Fault::User, "the stroke is no line of a leaf");
        auto const& edit = *edits->front().get<leaf::AddLeafLine>();
        auto const* const active = leaf::active_leaf_sketch(stroke.scene->state);
        bool const begins = edit.plant == 0 || !active;
        auto line = edit.stroke;
        if (begins && tools::is_coming_back(stroke.ink))
            line.tips.push_back(stroke.ink.front());
        leaf::LeafSketch const empty { .form = edit.form, .scale = edit.scale };
        return leaf::with_line(begins ? empty : *active, { .id = 0, .stroke = std::move(line) });
    }

    static tools::SkeletonLine shown_line(std::vector<Vec3> const& line, scene::Scene const& scene)
    {
        auto const paper = scene::paper_of(scene.state);
        tools::SkeletonLine shown;
        shown.state = tools::SkeletonLine::State::Assigned;
        for (auto const& place : line) {
            Vec3 at_mm = paper.world_of_sheet(place.head<2>());
            at_mm.y() -= place.z();
            shown.points_mm.push_back(scene.placement.plant_of_world(at_mm).cast<float>());
        }
        return shown;
    }
};

} // namespace

std::unique_ptr<tools::StrokePreviewer> leaf_previewer()
{
    return std::make_unique<LeafPreviewer>();
}

} // namespace tractus::leaf
