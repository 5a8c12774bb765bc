#include "tests/app/methods/small_method/gust.h"

#include "app/methods/all_methods.h"
#include "engine/scene/make_edit_kind.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <vector>

namespace tractus::methods {

namespace {

void list(scene::Fields& fields, BlowGust& edit)
{
    fields.field("strength", &edit.strength);
    fields.numbers(edit.stroke);
}

Result<scene::DocumentState> applied(scene::DocumentState state, BlowGust const& edit,
                                     scene::SceneBuilder&)
{
    auto indicator = TRY(variation::motion_indicator(edit.stroke));
    indicator.end_mm = indicator.start_mm + edit.strength * (indicator.end_mm - indicator.start_mm);
    auto const id = scene::take_id(state, 0);
    scene::change_active(state, [&](scene::PlantState& plant) {
        plant.indicators.push_back({ id, indicator, {} });
    });
    return state;
}

std::string described(BlowGust const& edit)
{
    return fmt::format("blows a gust of {:g}", edit.strength);
}

constexpr std::array<tools::OptionWord, 2> kTowardsWords { {
    { "towards_end", "Along" },
    { "towards_start", "Against" },
} };

void visit(tools::OptionVisitor& visitor, GustTool& tool)
{
    visitor.choice({ kTowardsWords }, tool.towards);
    visitor.number({ "strength", "", 0.1, 5, 0.5 }, tool.strength);
}

Result<std::vector<scene::Edit>> blow(tools::Tool const& tool, Stroke const& stroke,
                                      scene::Scene const&)
{
    auto const& options = *tool.get<GustTool>();
    auto tips = TRY(stroke.tips.in_memory()).vector();
    if (options.towards == GustTool::Towards::Start)
        std::reverse(tips.begin(), tips.end());
    return std::vector<scene::Edit> { BlowGust { { std::move(tips) }, options.strength } };
}

// Returns lines from the end of each gust down to the ground.
std::vector<std::vector<Vec3f>> reaches(scene::BuiltPlant const& plant)
{
    std::vector<std::vector<Vec3f>> lines;
    for (auto const& indicator : plant.indicators) {
        Vec3f const end_mm = indicator.what.end_mm.cast<float>();
        lines.push_back({ end_mm, { end_mm.x(), end_mm.y(), 0 } });
    }
    return lines;
}

} // namespace

constexpr scene::EditKind BlowGust::kKind
    = scene::make_edit_kind<BlowGust, list, applied, described>("blow_gust");

constexpr tools::ToolKind GustTool::kKind {
    .word = "gust",
    .label = "Gust",
    .title = "A gust of wind",
    .done = "The plant leans with the gust",
    .help = "leans the plant along the stroke",
    .group = "Gust",
    .key = 'G',
    .options = tools::options_type<GustTool, visit>(),
    .edits_for = blow,
};

constexpr tools::Layer kGustLayer { .label = "gusts",
                                    .style = { .color = tools::LayerStyle::Color::Blue,
                                               .pattern = tools::LayerStyle::Pattern::Dotted },
                                    .lines = reaches };

tools::Methods methods_with_gust()
{
    static auto const edits = [] {
        auto const core = all_methods().edits;
        std::vector<scene::EditKind const*> all(core.begin(), core.end());
        all.push_back(&BlowGust::kKind);
        return all;
    }();
    static auto const tools = [] {
        auto const core = all_methods().tools;
        std::vector<tools::ToolKind const*> all(core.begin(), core.end());
        all.push_back(&GustTool::kKind);
        return all;
    }();
    static auto const layers = [] {
        auto const core = all_methods().layers;
        std::vector<tools::Layer const*> all(core.begin(), core.end());
        all.push_back(&kGustLayer);
        return all;
    }();
    return { .edits = edits, .tools = tools, .layers = layers };
}

} // namespace tractus::methods
