#include "app/methods/silhouettes/outline_layer.h"

#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/scene/paper.h"

namespace tractus {

namespace {

using Lines = std::vector<std::vector<Vec3f>>;

enum class Lies { OnSheet, InSpace }; // Where z is how far behind the sheet it is.

void add(Stroke const& stroke, BuiltPlant const& plant, Lines& lines, Lies lies = Lies::OnSheet)
{
    constexpr float kApart_mm = 0.5f; // Points that are nearer show nothing.
    auto const tips = stroke.tips.in_memory();
    if (!tips || tips->size() < 2 || !plant.drawn->paper_mm)
        return;
    Paper const paper { *plant.drawn->paper_mm, plant.drawn->stands_at_mm };
    std::vector<Vec3f> line;
    for (auto const& tip : *tips) {
        Vec3 world_mm = paper.world_of_sheet(tip.position_mm.head<2>());
        if (lies == Lies::InSpace)
            world_mm.y() += tip.position_mm.z();
        auto const at_mm = world_mm.cast<float>().eval();
        if (line.empty() || (at_mm - line.back()).norm() >= kApart_mm)
            line.push_back(at_mm);
    }
    if (line.size() > 1)
        lines.push_back(std::move(line));
}

Lines outline_of(BuiltPlant const& plant)
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

// A cross where a bump is split, a bar where two are joined.
void add_mark(silhouette::DrawnTouch const& touch, BuiltPlant const& plant, Lines& lines)
{
    constexpr double kArm_mm = 2;
    auto const place = silhouette::place_of(touch);
    if (!place || !plant.drawn->paper_mm)
        return;
    Paper const paper { *plant.drawn->paper_mm, plant.drawn->stands_at_mm };
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

Lines trunk_of(BuiltPlant const& plant)
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

} // namespace

constexpr Layer kOutlineLayer { .label = "outline",
                                .style = { .color = LayerStyle::Color::Purple },
                                .lines = outline_of };
constexpr Layer kTrunkLayer { .label = "drawn trunk and branches",
                              .style = { .color = LayerStyle::Color::Purple,
                                         .pattern = LayerStyle::Pattern::Dashed },
                              .lines = trunk_of };

} // namespace tractus
