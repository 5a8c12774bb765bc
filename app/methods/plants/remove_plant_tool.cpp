#include "app/methods/plants/remove_plant_tool.h"

#include "app/methods/plants/touched_plant.h"
#include "app/tools/erase_tool.h"
#include "engine/scene/edit.h"

namespace tractus {

static Result<std::vector<Edit>> remove(Tool const&, Stroke const&, Scene const& scene)
{
    return std::vector<Edit> { RemovePlant { TRY(active_plant_of(scene)) } };
}

constexpr ToolKind RemovePlantTool::kKind {
    .word = "remove_plant",
    .label = "Remove",
    .title = "Remove a plant",
    .done = "The plant is gone",
    .help = "takes the plant away that takes what is drawn, with all that was drawn on it",
    .group = "Plants",
    .at_once = true,
    .options = options_type<RemovePlantTool>(),
    .mean = remove,
    .other_end = { &EraseTool::kKind },
};

} // namespace tractus
