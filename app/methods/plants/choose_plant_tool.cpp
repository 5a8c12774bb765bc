#include "app/methods/plants/choose_plant_tool.h"

#include "app/methods/plants/touched_plant.h"
#include "app/tools/erase_tool.h"
#include "engine/scene/edit.h"

namespace tractus::plants {

static Result<std::vector<scene::Edit>> choose(tools::Tool const&, Stroke const& stroke,
                                               scene::Scene const& scene)
{
    auto const plant = TRY(plant_under(stroke.tips.back(), scene));
    return std::vector<scene::Edit> { scene::ActivatePlant { plant->drawn->id } };
}

constexpr tools::ToolKind ChoosePlantTool::kKind {
    .word = "choose_plant",
    .label = "Choose",
    .title = "Choose a plant",
    .done = "What is drawn goes to this plant now",
    .help = "chooses the plant that takes what is drawn: the one under the stroke's end",
    .group = "Plants",
    .icon = "2090 2045 2060 3550 6090 6025 6045 8030 6055 4045",
    .key = 'P',
    .options = tools::options_type<ChoosePlantTool>(),
    .edits_for = choose,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::plants
