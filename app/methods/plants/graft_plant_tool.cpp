#include "app/methods/plants/graft_plant_tool.h"

#include "app/methods/plants/touched_plant.h"
#include "app/tools/erase_tool.h"

#include <array>

namespace tractus::plants {

namespace {

// Option words, in the order of the enumeration Grafting.
constexpr std::array<tools::OptionWord, 2> kGraftWords { {
    { "beside", "Put on" },
    { "instead", "Put in place", "Put a plant in the place of a branch" },
} };

void visit(tools::OptionVisitor& visitor, GraftPlantTool& tool)
{
    visitor.choice({ kGraftWords }, tool.grafting);
}

Result<std::vector<scene::Edit>> graft(tools::Tool const& tool, Stroke const& stroke,
                                       scene::Scene const& scene)
{
    auto const plant = TRY(plant_under(stroke.tips.front(), scene));
    auto const id = plant->drawn->id;
    auto const place = TRY(tools::branch_at(scene, stroke.tips.back().position_mm, Vec3::UnitZ(),
                                            tool.get<GraftPlantTool>()->grafting, id));
    return tools::graft_edits(scene, place, id);
}

} // namespace

constexpr tools::ToolKind GraftPlantTool::kKind {
    .word = "graft_plant",
    .label = "Put on",
    .title = "Put a plant on a branch",
    .done = "It is a part of the plant that bears it now",
    .help = "puts the plant where the stroke begins on the branch of another where it ends, or in "
            "the place of that branch: it is a part of that plant from then on",
    .group = "Plants",
    .begins_group_of_buttons = true,
    .min_extent_mm = 5,
    .ink = { tools::InkStyle::Look::Arrow },
    .options = tools::options_type<GraftPlantTool, visit>(),
    .edits_for = graft,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::plants
