#include "app/methods/plants/move_plant_tool.h"

#include "app/methods/plants/touched_plant.h"
#include "app/tools/erase_tool.h"
#include "engine/scene/edit.h"

namespace tractus::plants {

static Result<std::vector<scene::Edit>> move(tools::Tool const&, Stroke const& stroke,
                                             scene::Scene const& scene)
{
    auto const plant = TRY(plant_under(stroke.tips.front(), scene));
    Vec3 way_mm = stroke.tips.back().position_mm - stroke.tips.front().position_mm;
    way_mm.z() = 0;
    return std::vector<scene::Edit> { scene::MovePlant { plant->drawn->id,
                                                         plant->placement.origin_mm + way_mm } };
}

constexpr tools::ToolKind MovePlantTool::kKind {
    .word = "move_plant",
    .label = "Move",
    .title = "Move a plant",
    .done = "The plant stands there now",
    .help = "moves the plant where the stroke begins along with it, over the ground",
    .group = "Plants",
    .min_extent_mm = 2,
    .ink = { tools::InkStyle::Look::Arrow },
    .options = tools::options_type<MovePlantTool>(),
    .edits_for = move,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::plants
