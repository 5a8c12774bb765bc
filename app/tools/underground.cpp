#include "app/tools/underground.h"

#include "app/tools/bent_plant.h"
#include "app/tools/tool.h"
#include "engine/variation/ground.h"

#include <fmt/core.h>
#include <vector>

namespace tractus::tools {

namespace {

// Copy of the base plant whose nodes are moved as strokes have bent them; all else is left at rest,
// because the callers do not use it.
Plant bent_copy(scene::BuiltPlant const& plant)
{
    Plant bent = *plant.base;
    bent.node_position_mm = BentPlant(plant).nodes_mm();
    return bent;
}

std::vector<std::vector<Vec3f>> underground_lines(scene::BuiltPlant const& plant)
{
    if (plant.associations.empty())
        return {};
    auto const bent = bent_copy(plant);
    std::vector<std::vector<Vec3f>> lines;
    auto const world = [&](NodeId node) {
        return Vec3f(plant.placement.world_of_plant(bent.node_position_mm[node]).cast<float>());
    };
    for (auto const segment : variation::segments_underground(bent, *plant.base)) {
        auto const nodes = nodes_of(bent, segment);
        lines.push_back({ world(nodes.base), world(nodes.tip) });
    }
    return lines;
}

} // namespace

std::vector<SegmentId> segments_bent_underground(scene::BuiltPlant const& plant)
{
    if (plant.associations.empty())
        return {};
    return variation::segments_underground(bent_copy(plant), *plant.base);
}

constexpr Layer kUndergroundLayer {
    .label = "underground",
    .style = { .color = LayerStyle::Color::Orange,
               .pattern = LayerStyle::Pattern::Dotted,
               .width_mm = 2.5 },
    .lines = underground_lines,
};

constexpr Layer kGrownUndergroundLayer {
    .label = "underground by growth",
    .style = { .color = LayerStyle::Color::Orange,
               .pattern = LayerStyle::Pattern::Dashed,
               .width_mm = 2.5 },
    .lines = nullptr,
};

std::string underground_message(Tool const& tool, scene::Scene const& after)
{
    auto const below
        = variation::describe_underground(segments_bent_underground(after).size(), *after.base);
    return below.empty() ? "" : fmt::format("{}; {}", tool.kind().done, below);
}

} // namespace tractus::tools
