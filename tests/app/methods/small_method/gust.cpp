#include "tests/app/methods/small_method/gust.h"

#include "app/methods/all_methods.h"
#include "engine/scene/make_edit_kind.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <vector>

namespace tractus {

namespace {

void list(Fields& fields, BlowGust& edit)
{
    fields.field("strength", &edit.strength);
    fields.numbers(edit.stroke);
}

Result<DocumentState> applied(DocumentState state, BlowGust const& edit, SceneBuilder&)
{
    auto indicator = TRY(variation::motion_indicator(edit.stroke));
    indicator.end_mm = indicator.start_mm + edit.strength * (indicator.end_mm - indicator.start_mm);
    auto const id = take_id(state, 0);
    change_active(state, [&](PlantState& plant) {
        plant.indicators.push_back({ id, indicator, {} });
    });
    return state;
}

std::string described(BlowGust const& edit)
{
    return fmt::format("blows a gust of {:g}", edit.strength);
}

constexpr std::array<OptionWord, 2> kTowardsWords { {
    { "towards_end", "Along" },
    { "towards_start", "Against" },
} };

void visit(OptionVisitor& visitor, GustTool& tool)
{
    visitor.choice({ kTowardsWords }, tool.towards);
    visitor.number({ "strength", "", 0.1, 5, 0.5 }, tool.strength);
}

Result<std::vector<Edit>> blow(Tool const& tool, Stroke const& stroke, Scene const&)
{
    auto const& options = *tool.get<GustTool>();
    auto tips = TRY(stroke.tips.in_memory()).vector();
    if (options.towards == GustTool::Towards::Start)
        std::reverse(tips.begin(), tips.end());
    return std::vector<Edit> { BlowGust { { std::move(tips) }, options.strength } };
}

// To the ground below each gust's end.
std::vector<std::vector<Vec3f>> reaches(BuiltPlant const& plant)
{
    std::vector<std::vector<Vec3f>> lines;
    for (auto const& indicator : plant.indicators) {
        Vec3f const end_mm = indicator.what.end_mm.cast<float>();
        lines.push_back({ end_mm, { end_mm.x(), end_mm.y(), 0 } });
    }
    return lines;
}

} // namespace

constexpr EditKind BlowGust::kKind
    = make_edit_kind<BlowGust, list, applied, described>("blow_gust");

constexpr ToolKind GustTool::kKind {
    .word = "gust",
    .label = "Gust",
    .title = "A gust of wind",
    .done = "The plant leans with the gust",
    .help = "leans the plant along the stroke",
    .group = "Gust",
    .key = 'G',
    .options = options_type<GustTool, visit>(),
    .mean = blow,
};

constexpr Layer kGustLayer { .label = "gusts",
                             .style = { .color = LayerStyle::Color::Blue,
                                        .pattern = LayerStyle::Pattern::Dotted },
                             .lines = reaches };

Methods methods_with_gust()
{
    static auto const edits = [] {
        auto const core = all_methods().edits;
        std::vector<EditKind const*> all(core.begin(), core.end());
        all.push_back(&BlowGust::kKind);
        return all;
    }();
    static auto const tools = [] {
        auto const core = all_methods().tools;
        std::vector<ToolKind const*> all(core.begin(), core.end());
        all.push_back(&GustTool::kKind);
        return all;
    }();
    static auto const layers = [] {
        auto const core = all_methods().layers;
        std::vector<Layer const*> all(core.begin(), core.end());
        all.push_back(&kGustLayer);
        return all;
    }();
    return { .edits = edits, .tools = tools, .layers = layers };
}

} // namespace tractus
