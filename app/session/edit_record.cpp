#include "app/session/edit_record.h"

#include "app/session/edit_fields.h"

#include <algorithm>
#include <fmt/core.h>
#include <type_traits>
#include <utility>

namespace tractus {

namespace {

// In the order of Edit's alternatives.
constexpr std::array<char const*, std::variant_size_v<Edit>> kKinds {
    "load_model",    "select",           "associate",        "indicate",
    "set_growth",    "load_skeleton",    "oversketch",       "smooth_stroke",
    "delete_stroke", "change_indicator", "delete_indicator", "erase_tips"
};

// Enumerations by words, in the order of their values.
constexpr std::array kDrawn { "forget", "keep" };
constexpr std::array kPropagations { "selected", "descendants", "both" };
constexpr std::array kFits { "start", "chord", "world" };
constexpr std::array kIndicatorKinds { "push", "light" };
constexpr std::array kGrowthSteps { "per_length", "per_segment" };

// What each kind of edit consists of, for writing and for reading.

template<typename Fields> void list(Fields& fields, LoadModel& edit)
{
    fields.field("name", edit.source.name);
    fields.field("text", edit.source.text);
    fields.field("view_name", edit.source.view_name);
    fields.field("view_text", edit.source.view_text);
    fields.field("includes", edit.includes);
    fields.field("steps", edit.steps);
    fields.field("seed", edit.seed);
    fields.word("drawn", edit.drawn, kDrawn);
}

template<typename Fields> void list(Fields& fields, LoadSkeleton& edit)
{
    fields.field("name", edit.name);
    fields.word("drawn", edit.drawn, kDrawn);
    fields.numbers(edit.lines);
}

template<typename Fields> void list(Fields& fields, Select& edit)
{
    fields.field("paths", edit.paths);
}

template<typename Fields> void list(Fields& fields, Associate& edit)
{
    fields.word("propagation", edit.propagation, kPropagations);
    fields.word("fit", edit.fit, kFits);
    fields.field("kept_hand", edit.detail_weight);
    fields.numbers(edit.stroke);
}

template<typename Fields> void list(Fields& fields, Oversketch& edit)
{
    fields.field("associations", edit.associations);
    fields.numbers(edit.over);
}

template<typename Fields> void list(Fields& fields, SmoothStroke& edit)
{
    fields.field("associations", edit.associations);
    fields.field("kept_hand", edit.detail_weight);
}

template<typename Fields> void list(Fields& fields, DeleteStroke& edit)
{
    fields.field("associations", edit.associations);
}

template<typename Fields> void list(Fields& fields, EraseTips& edit)
{
    fields.field("associations", edit.associations);
    fields.field("ranges", edit.ranges);
}

template<typename Fields> void list(Fields& fields, MotionIndicator& indicator)
{
    fields.field("start_mm", indicator.start_mm);
    fields.field("end_mm", indicator.end_mm);
    fields.word("kind", indicator.kind, kIndicatorKinds);
    fields.field("below", indicator.below);
    fields.field("reach_mm", indicator.reach_mm);
    fields.field("is_orphaned", indicator.is_orphaned);
}

template<typename Fields> void list(Fields& fields, Indicate& edit)
{
    list(fields, edit.indicator);
}

template<typename Fields> void list(Fields& fields, ChangeIndicator& edit)
{
    fields.field("number", edit.number);
    list(fields, edit.indicator);
}

template<typename Fields> void list(Fields& fields, DeleteIndicator& edit)
{
    fields.field("number", edit.number);
}

template<typename Fields> void list(Fields& fields, SetGrowth& edit)
{
    auto& growth = edit.parameters;
    fields.word("steps", growth.steps, kGrowthSteps);
    fields.field("steps_per_axis", growth.steps_per_axis);
    fields.field("strength", growth.strength);
    fields.field("gain", growth.gain);
    fields.field("delay_steps", growth.delay_steps);
    fields.field("noise_rad", growth.noise_rad);
    fields.field("noise_memory", growth.noise_memory);
    fields.field("indicator_gain", growth.indicator_gain);
    fields.field("circumnutation_rad", growth.circumnutation_rad);
    fields.field("circumnutation_period_steps", growth.circumnutation_period_steps);
    fields.field("prevailing", growth.prevailing);
    fields.field("growth_zone_steps", growth.growth_zone_steps);
    fields.field("maturation_bending", growth.maturation_bending);
    fields.field("maturation_straightening", growth.maturation_straightening);
    fields.field("sag", growth.sag);
    fields.field("seed", edit.seed);
    fields.field("liking", edit.variability);
    fields.field("age", edit.age);
}

// An edit of a kind, as it is by default.
template<std::size_t... Kind> Edit plain_edit(std::size_t kind, std::index_sequence<Kind...>)
{
    Edit edit;
    ((Kind == kind ? void(edit.emplace<Kind>()) : void()), ...);
    return edit;
}

} // namespace

EditRecord record_of(Edit edit)
{
    FieldWriter writer;
    std::visit([&](auto& kind) { list(writer, kind); }, edit);
    return { kKinds[edit.index()], writer.json(), writer.take_numbers() };
}

Result<Edit> edit_of(EditRecord const& record)
{
    auto const* const kind = std::find(kKinds.begin(), kKinds.end(), record.kind);
    if (kind == kKinds.end())
        return fail(Fault::User,
                    fmt::format("its kind \"{}\" is unknown to this tractus: a newer one has "
                                "written it",
                                record.kind));
    auto const json = Json::parse(record.fields, nullptr, false);
    if (!json.is_object())
        return fail(Fault::User, "its fields are not JSON");
    auto edit = plain_edit(static_cast<std::size_t>(kind - kKinds.begin()),
                           std::make_index_sequence<std::variant_size_v<Edit>> {});
    FieldReader reader(json, record.numbers);
    std::visit([&](auto& fields) { list(reader, fields); }, edit);
    TRY(reader.finish());
    return edit;
}

} // namespace tractus
