#include "app/methods/sketch_lsystem/sketch_previewer.h"

#include "app/methods/sketch_lsystem/sketch_tool.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

namespace tractus::sketch {

namespace {

constexpr double kMaxInternodes = 4000;
// Maximum number of modules of a model in a preview, because it is regrown for each frame.
constexpr std::size_t kMaxModules = 200'000;

tools::SkeletonLine line_of(Plant const& plant, Axis const& axis, scene::DeskPlacement const& from,
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

// A plant that consists only of the axis along the stroke: the preview of a model that is too
// large.
Result<scene::BuiltSource> drawn_axis_of(sketch::GrowAlongStroke const& edit)
{
    // Radius of all nodes of this plant.
    constexpr float kRadius_mm = 8;
    auto const nodes_mm = TRY(sketch::drawn_nodes_mm(edit));
    Plant plant;
    for (auto const& node_mm : nodes_mm) {
        plant.node_position_mm.push_back((node_mm - nodes_mm.front()) / edit.scale);
        plant.node_radius_mm.push_back(kRadius_mm);
    }
    Axis axis;
    axis.segment_count = static_cast<std::uint32_t>(nodes_mm.size() - 1);
    plant.axes.push_back(axis);
    return scene::BuiltSource { std::move(plant) };
}

// Note for the user: how often laterals fork if the rule's limit cuts off further forks, and
// whether the preview leaves out more forks than that.
std::string note_of_depth(sketch::Rule const& whole, sketch::Rule const& shown, Plant const& plant)
{
    auto const segments = static_cast<int>(plant.axes.front().segment_count);
    int const depth = sketch::depth_within_limit(whole, segments);
    std::string note;
    if (depth < sketch::kUncutDepth)
        note = fmt::format("Laterals fork at most {} times: more were over {:.0f} internodes",
                           depth, whole.most_internodes);
    if (sketch::depth_within_limit(shown, segments) < depth)
        note += note.empty() ? "The finest forks come when the pen is lifted"
                             : "; the finest come when the pen is lifted";
    return note;
}

class SketchPreviewer final : public tools::StrokePreviewer {
public:
    std::string note() const override { return note_; }
    std::optional<scene::Paper> paper() const override { return paper_; }

    std::vector<tools::SkeletonLine> show(tools::UnfinishedStroke const& stroke) override
    {
        note_.clear();
        paper_.reset();
        auto lines = show_if_grown(stroke);
        if (lines.empty())
            shown_.reset();
        return lines;
    }

private:
    // Everything on which the cached preview depends, except the stroke's path between its nodes.
    // While these values stay equal, the preview does not change: most pen samples add no node.
    struct Shown {
        sketch::Rule rule {};
        sketch::ModelRule model {};
        StrokeSurface surface = StrokeSurface::Decided;
        double scale = 1;
        SketchTool::Place place = SketchTool::Place::Ground;
        std::shared_ptr<scene::Scene const> scene {};
        std::vector<Vec3> nodes_mm {};

        bool operator==(Shown const&) const = default;
    };

    std::vector<tools::SkeletonLine> show_if_grown(tools::UnfinishedStroke const& stroke)
    {
        auto const& tool = *stroke.tool.get<SketchTool>();
        Stroke const ink { std::vector(stroke.ink.begin(), stroke.ink.end()) };
        auto const again = tool.place == SketchTool::Place::Again
            ? regrown_along(tool, ink, *stroke.scene)
            : grown_along(tool, ink, *stroke.scene);
        if (!again)
            return {};
        auto edit = *again;
        auto const rule = edit.rule;
        edit.leaves = sketch::Leaves::Bare;
        scene::LoadOptions options;
        if (edit.model.is_set())
            options.limits.max_modules = kMaxModules;
        else
            edit.rule.most_internodes = std::max<double>(edit.rule.most_segments, kMaxInternodes);
        auto const& place = find_place(tool, edit, stroke.scene);
        if (place && *place)
            fit_to_branch(edit, **place);
        auto nodes_mm = sketch::drawn_nodes_mm(edit);
        if (!place || !nodes_mm)
            return {};
        if (auto const base_mm = sketch::paper_position_mm(edit); base_mm && !*place)
            paper_ = { .base_mm = *base_mm, .world_point_mm = sketch::stands_at_mm(edit) };
        Shown shown { rule,       edit.model,   edit.surface,        edit.scale,
                      tool.place, stroke.scene, *std::move(nodes_mm) };
        if (shown_ == shown) {
            note_ = shown_note_;
            return shown_lines_;
        }
        auto built = sketch::build_sketch(edit, options);
        if (!built && edit.model.is_set()) {
            built = drawn_axis_of(edit);
            note_ = "The axis alone is shown while you draw";
        }
        if (!built)
            return {};
        if (!edit.model.is_set())
            note_ = note_of_depth(rule, edit.rule, built->plant);
        auto const& branch = *place;
        scene::DeskPlacement const placement { .scale = edit.scale,
                                               .origin_mm = branch ? branch->base_mm
                                                                   : sketch::stands_at_mm(edit) };
        std::vector<tools::SkeletonLine> lines;
        for (auto const& axis : built->plant.axes)
            lines.push_back(line_of(built->plant, axis, placement, stroke.scene->placement));
        shown_ = std::move(shown);
        shown_lines_ = lines;
        shown_note_ = note_;
        return lines;
    }

    // The place on a branch is found only once per stroke, because the search visits all plants.
    Result<std::optional<tools::BranchPlace>> const&
    find_place(SketchTool const& tool, sketch::GrowAlongStroke const& edit,
               std::shared_ptr<scene::Scene const> const& scene)
    {
        Vec3 const begin_mm
            = edit.stroke.tips.empty() ? Vec3::Zero() : edit.stroke.tips.front().position_mm;
        if (!place_ || surface_ != edit.surface || begin_mm_ != begin_mm || scene_ != scene
            || grows_ != tool.place) {
            place_ = place_of(tool, edit, *scene);
            surface_ = edit.surface;
            begin_mm_ = begin_mm;
            scene_ = scene;
            grows_ = tool.place;
        }
        return *place_;
    }

    std::string note_;
    std::optional<scene::Paper> paper_;
    std::optional<Shown> shown_; // What shown_lines_ and shown_note_ were made from.
    std::vector<tools::SkeletonLine> shown_lines_;
    std::string shown_note_;
    // Cached result of place_of() for the values of surface_, begin_mm_, scene_ and grows_.
    std::optional<Result<std::optional<tools::BranchPlace>>> place_;
    StrokeSurface surface_ = StrokeSurface::Decided;
    Vec3 begin_mm_ = Vec3::Zero();
    // Shared with the document, which may go on to a newer scene.
    std::shared_ptr<scene::Scene const> scene_;
    SketchTool::Place grows_ = SketchTool::Place::Ground;
};

} // namespace

std::unique_ptr<tools::StrokePreviewer> sketch_previewer()
{
    return std::make_unique<SketchPreviewer>();
}

} // namespace tractus::sketch
