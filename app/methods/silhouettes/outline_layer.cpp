#include "app/methods/silhouettes/outline_layer.h"

#include "app/methods/silhouettes/outline_tool.h"
#include "engine/methods/silhouettes/chordal_axis.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/paper.h"

#include <optional>
#include <utility>

namespace tractus::silhouette {

namespace {

using Lines = std::vector<std::vector<Vec3f>>;

// Whether a stroke is on the sheet, or in space with z as the distance behind the sheet.
enum class Lies { OnSheet, InSpace };

void add(Stroke const& stroke, scene::BuiltPlant const& plant, Lines& lines,
         Lies lies = Lies::OnSheet)
{
    constexpr float kApart_mm = 0.5f; // Points closer together than this are left out.
    auto const tips = stroke.tips.in_memory();
    if (!tips || tips->size() < 2 || !plant.drawn->paper_mm)
        return;
    auto const paper = *scene::paper_of(*plant.drawn);
    std::vector<Vec3f> line;
    for (auto const& tip : *tips) {
        Vec3 world_mm = paper.world_of_sheet(tip.position_mm.head<2>());
        if (lies == Lies::InSpace)
            world_mm.y() += paper.unit * tip.position_mm.z();
        auto const at_mm = world_mm.cast<float>().eval();
        if (line.empty() || (at_mm - line.back()).norm() >= kApart_mm)
            line.push_back(at_mm);
    }
    if (line.size() > 1)
        lines.push_back(std::move(line));
}

Lines outline_of(scene::BuiltPlant const& plant)
{
    Lines lines;
    if (auto const* const tree = silhouette::outlined_tree(*plant.drawn)) {
        add(tree->outline, plant, lines);
        for (auto const& own : tree->own_outlines)
            add(own.stroke, plant, lines);
        for (auto& line : lines)
            line.push_back(Vec3f(line.front()));
        for (auto const& drawn : tree->crown_lines)
            add(drawn.stroke, plant, lines, Lies::InSpace);
    }
    return lines;
}

// Marks a touch by a cross if it splits a bump, or by a bar if it joins two bumps.
void add_mark(silhouette::DrawnTouch const& touch, scene::BuiltPlant const& plant, Lines& lines)
{
    constexpr double kArm_mm = 2;
    auto const place = silhouette::place_of(touch);
    if (!place || !plant.drawn->paper_mm)
        return;
    auto const paper = *scene::paper_of(*plant.drawn);
    auto const add_arm = [&](Vec2 const& arm) {
        lines.push_back({ paper.world_of_sheet(*place - arm).cast<float>(),
                          paper.world_of_sheet(*place + arm).cast<float>() });
    };
    if (touch.kind == silhouette::BumpTouch::Kind::Join) {
        add_arm({ kArm_mm, 0 });
        return;
    }
    add_arm({ kArm_mm, kArm_mm });
    add_arm({ kArm_mm, -kArm_mm });
}

Lines trunk_of(scene::BuiltPlant const& plant)
{
    Lines lines;
    if (auto const* const tree = silhouette::outlined_tree(*plant.drawn)) {
        add(tree->trunk, plant, lines);
        for (auto const& branch : tree->branches)
            add(branch.stroke, plant, lines);
        for (auto const& own : tree->own_branches)
            add(own.stroke, plant, lines);
        for (auto const& touch : tree->touches)
            add_mark(touch, plant, lines);
    }
    return lines;
}

// Infers only the trunk's branches, which is quick.
std::optional<silhouette::BranchingSystem> system_of(scene::BuiltPlant const& plant)
{
    auto const* const tree = silhouette::outlined_tree(*plant.drawn);
    if (!tree || !tree->has_crown() || !plant.drawn->paper_mm)
        return std::nullopt;
    auto on_trunk = *tree;
    on_trunk.form.levels = 1;
    auto skeleton = silhouette::skeleton_of(on_trunk);
    if (!skeleton)
        return std::nullopt;
    return std::move(skeleton->systems.front());
}

void add_closed(std::vector<Vec2> const& line, scene::BuiltPlant const& plant, Lines& lines)
{
    if (line.size() < 2)
        return;
    auto const paper = *scene::paper_of(*plant.drawn);
    auto& closed = lines.emplace_back();
    for (auto const& point : line)
        closed.push_back(paper.world_of_sheet(point).cast<float>());
    closed.push_back(Vec3f(closed.front()));
}

Lines seen_of(scene::BuiltPlant const& plant)
{
    constexpr int kSteps = 16;
    // Radius of the mark at a bump's centre, as a share of the diagonal of the outline's bounding
    // box.
    constexpr double kSize = 0.012;
    Lines lines;
    auto const system = system_of(plant);
    if (!system)
        return lines;
    double const size = kSize * silhouette::box_of(system->outline).diagonal();
    for (auto const& bump : system->bumps) {
        if (bump.role != silhouette::Role::Lateral)
            continue;
        std::vector<Vec2> ring;
        for (int i = 0; i < kSteps; ++i)
            ring.emplace_back(bump.end + silhouette::turned(Vec2(size, 0), 2 * kPi * i / kSteps));
        add_closed(ring, plant, lines);
        add_closed({ system->outline[bump.arc.first], system->outline[bump.arc.last] }, plant,
                   lines);
    }
    for (auto const& branch : system->branches)
        add_closed(branch.crown, plant, lines);
    return lines;
}

Lines triangles_of(scene::BuiltPlant const& plant)
{
    Lines lines;
    auto const system = system_of(plant);
    if (!system || system->leaf)
        return lines;
    silhouette::ChordalAxis const axis(system->outline);
    for (auto const& triangle : axis.triangles()) {
        std::vector<Vec2> corners;
        for (auto const corner : triangle.corner)
            corners.push_back(axis.outline()[corner]);
        add_closed(corners, plant, lines);
    }
    return lines;
}

OutlineTool::SeenFor seen_for(tools::Tool const& in_hand)
{
    auto const* const tool = in_hand.get<OutlineTool>();
    return tool ? tool->seen : OutlineTool::SeenFor::AWhile;
}

} // namespace

constexpr tools::Layer kOutlineLayer { .label = "outline",
                                       .style = { .color = tools::LayerStyle::Color::Purple },
                                       .lines = outline_of };
constexpr tools::Layer kTrunkLayer { .label = "drawn trunk and branches",
                                     .style = { .color = tools::LayerStyle::Color::Purple,
                                                .pattern = tools::LayerStyle::Pattern::Dashed },
                                     .lines = trunk_of };

constexpr tools::Layer kSeenLayer { .label = "bumps and parts of the crown",
                                    .style = { .color = tools::LayerStyle::Color::Grey,
                                               .pattern = tools::LayerStyle::Pattern::Dotted,
                                               .width_mm = 0.8 },
                                    .lines = seen_of,
                                    .seen = tools::Layer::Seen::AWhile,
                                    .is_asked_for = [](tools::Tool const& in_hand) {
                                        return seen_for(in_hand) != OutlineTool::SeenFor::AWhile;
                                    } };
constexpr tools::Layer kTrianglesLayer { .label = "triangles",
                                         .style = { .color = tools::LayerStyle::Color::Grey,
                                                    .width_mm = 0.3 },
                                         .lines = triangles_of,
                                         .seen = tools::Layer::Seen::WhenAskedFor,
                                         .is_asked_for = [](tools::Tool const& in_hand) {
                                             return seen_for(in_hand)
                                                 == OutlineTool::SeenFor::WithTriangles;
                                         } };

} // namespace tractus::silhouette
