#include "engine/scene/make_edit_kind.h"
#include "engine/variation/growth_preset.h"

#include <fmt/core.h>

namespace tractus::scene {

namespace {

// Words for GrowthParameters::Steps in sessions, in the order of the enumeration.
constexpr std::array kGrowthSteps { "per_length", "per_segment" };

void list(Fields& fields, SetGrowth& edit)
{
    auto& growth = edit.parameters;
    fields.word("steps", growth.steps, kGrowthSteps);
    fields.field("steps_per_axis", &growth.steps_per_axis);
    fields.field("strength", &growth.strength);
    fields.field("gain", &growth.gain);
    fields.field("delay_steps", &growth.delay_steps);
    fields.field("noise_rad", &growth.noise_rad);
    fields.field("noise_memory", &growth.noise_memory);
    fields.field("indicator_gain", &growth.indicator_gain);
    fields.field("circumnutation_rad", &growth.circumnutation_rad);
    fields.field("circumnutation_period_steps", &growth.circumnutation_period_steps);
    fields.field("prevailing", &growth.prevailing);
    fields.field("growth_zone_steps", &growth.growth_zone_steps);
    fields.field("maturation_bending", &growth.maturation_bending);
    fields.field("maturation_straightening", &growth.maturation_straightening);
    fields.field("sag", &growth.sag);
    fields.field("seed", &edit.seed);
    fields.field("liking", &edit.variability);
    fields.field("age", &edit.age);
}

Result<DocumentState> applied(DocumentState state, SetGrowth const& edit, SceneBuilder&)
{
    TRY(variation::check_growth_parameters(edit.parameters));
    TRY(variation::at_variability(edit.parameters, edit.variability));
    if (!(edit.age >= 0 && edit.age <= 1))
        return fail(Fault::User,
                    fmt::format("a plant cannot be {} of its age: give 0 (a seed) to "
                                "1 (full-grown)",
                                edit.age));
    change_active(state, [&](PlantState& plant) { plant.growth = edit; });
    return state;
}

std::string described(SetGrowth const& edit)
{
    auto const preset = variation::growth_preset_of(edit.parameters);
    auto text = preset.empty() ? fmt::format("grows with strength {:.3g}, gain {:.3g}",
                                             edit.parameters.strength, edit.parameters.gain)
                               : fmt::format("grows as \"{}\"", preset);
    if (edit.variability != 1)
        text += fmt::format(", {:.3g} as it likes", edit.variability);
    if (edit.age != 1)
        text += fmt::format(", to age {:.3g}", edit.age);
    return text + fmt::format(", seed {}", edit.seed);
}

} // namespace

constexpr EditKind SetGrowth::kKind
    = make_edit_kind<SetGrowth, list, applied, described>("set_growth");

} // namespace tractus::scene
