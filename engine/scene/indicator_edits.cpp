#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace tractus {

namespace {

// In the order of the enumerations' values.
constexpr std::array kIndicatorKinds { "push", "light" };

void list(Fields& fields, MotionIndicator& indicator)
{
    fields.field("start_mm", &indicator.start_mm);
    fields.field("end_mm", &indicator.end_mm);
    fields.word("kind", indicator.kind, kIndicatorKinds);
    fields.field("below", &indicator.below);
    fields.field("reach_mm", &indicator.reach_mm);
    fields.field("is_orphaned", &indicator.is_orphaned);
}

std::vector<PathAddress> places_of(Scene const& scene, MotionIndicator const& indicator)
{
    std::vector<PathAddress> places;
    for (auto const segment : indicator.below) {
        auto const address = scene.rest->addresses.address_of(*scene.base, segment);
        places.push_back({ address, address });
    }
    return places;
}

// Its number in the scene's list; `number` is what older sessions say in place of an id.
Result<std::size_t> find_indicator(Scene const& scene, ItemId id, std::uint64_t number)
{
    auto const& all = scene.indicators;
    if (id != 0) {
        auto const found = std::find_if(all.begin(), all.end(),
                                        [&](auto const& indicator) { return indicator.id == id; });
        if (found == all.end())
            return fail(Fault::User,
                        fmt::format("there is no motion indicator {} any more", name_of(id)));
        return static_cast<std::size_t>(found - all.begin());
    }
    if (number >= all.size())
        return fail(Fault::User,
                    fmt::format("there is no motion indicator {}: the scene has {}", number + 1,
                                all.size()));
    return number;
}

std::string name_of_indicator(ItemId id, std::uint64_t number)
{
    return id != 0 ? name_of(id) : std::to_string(number + 1);
}

std::string describe_indicator(MotionIndicator const& indicator, std::size_t places)
{
    Vec3 const way_mm = indicator.end_mm - indicator.start_mm;
    auto const whole = [](double mm) { return std::round(mm) + 0.0; }; // Never -0.
    auto text
        = fmt::format("({}, {}, {}) mm{}", whole(way_mm.x()), whole(way_mm.y()), whole(way_mm.z()),
                      indicator.kind == MotionIndicator::Kind::Light ? ", light" : "");
    if (auto const below = indicator.below.size() + places; below > 0)
        text += fmt::format(", on {} and what they bear", counted(below, "segment"));
    if (indicator.reach_mm)
        text += fmt::format(", as far as {:.0f} mm", *indicator.reach_mm);
    return text;
}

void list(Fields& fields, Indicate& edit)
{
    list(fields, edit.indicator);
    fields.sparse_field("at", &edit.below);
    fields.id(edit.id);
}

Result<Scene> applied(Scene scene, Indicate const& edit, LoadOptions const&)
{
    auto indicator = edit.indicator;
    for (auto const& address : edit.below) {
        auto const segment = scene.rest->addresses.find_segment(*scene.base, address);
        if (!segment)
            return fail(Fault::User,
                        "the motion indicator acts on nothing: the plant has no branch there");
        indicator.below.push_back(*segment);
    }
    TRY(check_indicator(*scene.base, indicator));
    auto const id = take_id(scene, edit.id);
    auto places = places_of(scene, indicator);
    scene.indicators.push_back({ id, std::move(indicator), std::move(places) });
    return scene;
}

std::string described(Indicate const& edit)
{
    return fmt::format("leans the plant by {}",
                       describe_indicator(edit.indicator, edit.below.size()));
}

void list(Fields& fields, ChangeIndicator& edit)
{
    fields.sparse_field("which", &edit.which);
    fields.sparse_field("number", &edit.number);
    list(fields, edit.indicator);
}

Result<Scene> applied(Scene scene, ChangeIndicator const& edit, LoadOptions const&)
{
    auto& changed = scene.indicators[TRY(find_indicator(scene, edit.which, edit.number))];
    auto indicator = edit.indicator;
    if (edit.which != 0) {
        indicator.below = changed.what.below;
        indicator.is_orphaned = changed.what.is_orphaned;
    }
    TRY(check_indicator(*scene.base, indicator));
    // An orphan that is only moved still waits for its branch.
    if (edit.which == 0 && !indicator.is_orphaned)
        changed.at = places_of(scene, indicator);
    changed.what = std::move(indicator);
    return scene;
}

std::string described(ChangeIndicator const& edit)
{
    return fmt::format("changes motion indicator {}: {}",
                       name_of_indicator(edit.which, edit.number),
                       describe_indicator(edit.indicator, 0));
}

void list(Fields& fields, DeleteIndicator& edit)
{
    fields.sparse_field("which", &edit.which);
    fields.sparse_field("number", &edit.number);
}

Result<Scene> applied(Scene scene, DeleteIndicator const& edit, LoadOptions const&)
{
    auto const number = TRY(find_indicator(scene, edit.which, edit.number));
    scene.indicators.erase(scene.indicators.begin() + static_cast<std::ptrdiff_t>(number));
    return scene;
}

std::string described(DeleteIndicator const& edit)
{
    return fmt::format("takes motion indicator {} away",
                       name_of_indicator(edit.which, edit.number));
}

} // namespace

constexpr EditKind Indicate::kKind = make_edit_kind<Indicate, list, applied, described>("indicate");

constexpr EditKind ChangeIndicator::kKind
    = make_edit_kind<ChangeIndicator, list, applied, described>("change_indicator");

constexpr EditKind DeleteIndicator::kKind
    = make_edit_kind<DeleteIndicator, list, applied, described>("delete_indicator");

} // namespace tractus
