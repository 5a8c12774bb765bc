#include "app/methods/plants/copy_plant_tool.h"

#include "app/methods/plants/touched_plant.h"
#include "app/tools/erase_tool.h"
#include "engine/scene/edit.h"

#include <algorithm>

namespace tractus::plants {

namespace {

// World x coordinate for the origin of a plant's copy: the copy's bounding box is then to the right
// of all plants.
double free_x_mm(scene::BuiltPlant const& copied, scene::Scene const& scene)
{
    constexpr double kGap_mm = 10;
    double right_mm = 0;
    for (auto const& plant : scene.plants)
        if (auto const box = bounds(*plant->base); !box.empty())
            right_mm = std::max(right_mm, plant->placement.world_of_plant(box.max_mm).x());
    auto const box = bounds(*copied.base);
    double const left_mm = box.empty() ? 0 : copied.placement.scale * box.min_mm.x();
    return right_mm + kGap_mm - left_mm;
}

Result<std::vector<scene::Edit>> copy(tools::Tool const&, Stroke const&, scene::Scene const& scene)
{
    auto const plant = TRY(active_plant_of(scene));
    Vec3 at_mm = scene.placement.origin_mm;
    at_mm.x() = free_x_mm(scene, scene);
    return std::vector<scene::Edit> { scene::CopyPlant { plant, at_mm } };
}

} // namespace

constexpr tools::ToolKind CopyPlantTool::kKind {
    .word = "copy_plant",
    .label = "Copy",
    .title = "Copy a plant",
    .done = "The copy stands to the right",
    .help = "adds a copy of the plant that takes what is drawn, to the right of all others",
    .group = "Plants",
    .begins_group_of_buttons = true,
    .at_once = true,
    .options = tools::options_type<CopyPlantTool>(),
    .edits_for = copy,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::plants
