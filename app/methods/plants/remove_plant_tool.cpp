#include "app/methods/plants/remove_plant_tool.h"

#include "app/methods/plants/touched_plant.h"
#include "app/tools/erase_tool.h"
#include "engine/scene/edit.h"

namespace tractus::plants {

static Result<std::vector<scene::Edit>> remove(tools::Tool const&, Stroke const&,
                                               scene::Scene const& scene)
{
    return std::vector<scene::Edit> { scene::RemovePlant { TRY(active_plant_of(scene)) } };
}

constexpr tools::ToolKind RemovePlantTool::kKind {
    .word = "remove_plant",
    .label = "Remove",
    .title = "Remove a plant",
    .done = "The plant is gone",
    .help = "takes the plant away that takes what is drawn, with all that was drawn on it",
    .group = "Plants",
    .at_once = true,
    .options = tools::options_type<RemovePlantTool>(),
    .edits_for = remove,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::plants
