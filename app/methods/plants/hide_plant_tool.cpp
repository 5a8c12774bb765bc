#include "app/methods/plants/hide_plant_tool.h"

#include "app/methods/plants/touched_plant.h"
#include "app/tools/erase_tool.h"
#include "engine/scene/edit.h"

#include <array>

namespace tractus::plants {

namespace {

// Option words, in the order of the enumeration What.
constexpr std::array<tools::OptionWord, 2> kWords { {
    { "active", "Hide", nullptr, true },
    { "none", "Show all", nullptr, true },
} };

void visit(tools::OptionVisitor& visitor, HidePlantTool& tool)
{
    visitor.choice({ kWords }, tool.what);
}

Result<std::vector<scene::Edit>> hide(tools::Tool const& tool, Stroke const&,
                                      scene::Scene const& scene)
{
    if (tool.get<HidePlantTool>()->what == HidePlantTool::What::Active)
        return std::vector<scene::Edit> { scene::HidePlant { TRY(active_plant_of(scene)), true } };
    std::vector<scene::Edit> edits;
    for (auto const& plant : scene.plants)
        if (plant->drawn->is_hidden)
            edits.push_back(scene::HidePlant { plant->drawn->id, false });
    if (edits.empty())
        return fail(Fault::User, "no plant is hidden");
    return edits;
}

} // namespace

constexpr tools::ToolKind HidePlantTool::kKind {
    .word = "hide_plant",
    .label = "Hide",
    .title = "Hide a plant",
    .done = "It is neither shown nor exported while it is hidden",
    .help = "hides the plant that takes what is drawn, or shows all that are hidden",
    .group = "Plants",
    .at_once = true,
    .options = tools::options_type<HidePlantTool, visit>(),
    .edits_for = hide,
    .other_end = { &tools::EraseTool::kKind },
};

} // namespace tractus::plants
