#include "app/methods/plants/take_off_tool.h"

#include "app/tools/branch_place.h"
#include "app/tools/erase_tool.h"
#include "engine/plant/plant_addresses.h"

#include <algorithm>

namespace tractus::plants {

static Result<std::vector<scene::Edit>> take_off(tools::Tool const&, Stroke const& stroke,
                                                 scene::Scene const& scene)
{
    auto const place = TRY(tools::branch_at(scene, stroke.tips.front().position_mm, Vec3::UnitZ(),
                                            tools::Grafting::Beside));
    auto const& plant = *scene.plants[*scene::find_plant(scene.state, place.plant)];
    auto const part = part_of(plant.rest->addresses.address_of(*plant.base, place.touched));
    if (part == 0)
        return fail(Fault::User, "what the stroke touches was not put on: touch a plant that was");
    Vec3 stands_at_mm = place.base_mm;
    stands_at_mm.z() = 0;
    return std::vector<scene::Edit> { scene::TakeOffGraft { place.plant, part, stands_at_mm } };
}

constexpr tools::ToolKind TakeOffTool::kKind {
    .word = "take_off",
    .label = "Take off",
    .title = "Take a plant off its branch",
    .done = "It stands on the ground, and takes what is drawn",
    .help = "takes the plant that is touched off the branch that it was put on: it stands on the "
            "ground then",
    .group = "Plants",
    .options = tools::options_type<TakeOffTool>(),
    .edits_for = take_off,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::plants
