#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"

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

std::vector<SegmentAddress> places_of(Scene const& scene, MotionIndicator const& indicator)
{
    std::vector<SegmentAddress> places;
    for (auto const segment : indicator.below)
        places.push_back(address_of(*scene.base, segment));
    return places;
}

Result<void> check_number(Scene const& scene, std::size_t indicator)
{
    if (indicator >= scene.indicators.size())
        return fail(Fault::User,
                    fmt::format("there is no motion indicator {}: the scene has {}", indicator + 1,
                                scene.indicators.size()));
    return {};
}

std::string describe_indicator(MotionIndicator const& indicator)
{
    Vec3 const way_mm = indicator.end_mm - indicator.start_mm;
    auto const whole = [](double mm) { return std::round(mm) + 0.0; }; // Never -0.
    auto text
        = fmt::format("({}, {}, {}) mm{}", whole(way_mm.x()), whole(way_mm.y()), whole(way_mm.z()),
                      indicator.kind == MotionIndicator::Kind::Light ? ", light" : "");
    if (!indicator.below.empty())
        text += fmt::format(", on {} and what they bear",
                            counted(indicator.below.size(), "segment"));
    if (indicator.reach_mm)
        text += fmt::format(", as far as {:.0f} mm", *indicator.reach_mm);
    return text;
}

void list(Fields& fields, Indicate& edit)
{
    list(fields, edit.indicator);
}

Result<Scene> applied(Scene scene, Indicate const& edit, LoadOptions const&)
{
    TRY(check_indicator(*scene.base, edit.indicator));
    scene.indicators.push_back(edit.indicator);
    scene.indicator_places.push_back(places_of(scene, edit.indicator));
    return scene;
}

std::string described(Indicate const& edit)
{
    return fmt::format("leans the plant by {}", describe_indicator(edit.indicator));
}

void list(Fields& fields, ChangeIndicator& edit)
{
    fields.field("number", &edit.number);
    list(fields, edit.indicator);
}

Result<Scene> applied(Scene scene, ChangeIndicator const& edit, LoadOptions const&)
{
    TRY(check_number(scene, edit.number));
    TRY(check_indicator(*scene.base, edit.indicator));
    // An orphan that is only moved still waits for its branch.
    if (!edit.indicator.is_orphaned)
        scene.indicator_places[edit.number] = places_of(scene, edit.indicator);
    scene.indicators[edit.number] = edit.indicator;
    return scene;
}

std::string described(ChangeIndicator const& edit)
{
    return fmt::format("changes motion indicator {}: {}", edit.number + 1,
                       describe_indicator(edit.indicator));
}

void list(Fields& fields, DeleteIndicator& edit)
{
    fields.field("number", &edit.number);
}

Result<Scene> applied(Scene scene, DeleteIndicator const& edit, LoadOptions const&)
{
    TRY(check_number(scene, edit.number));
    auto const at = static_cast<std::ptrdiff_t>(edit.number);
    scene.indicators.erase(scene.indicators.begin() + at);
    scene.indicator_places.erase(scene.indicator_places.begin() + at);
    return scene;
}

std::string described(DeleteIndicator const& edit)
{
    return fmt::format("takes motion indicator {} away", edit.number + 1);
}

} // namespace

constexpr EditKind Indicate::kKind = make_edit_kind<Indicate, list, applied, described>("indicate");

constexpr EditKind ChangeIndicator::kKind
    = make_edit_kind<ChangeIndicator, list, applied, described>("change_indicator");

constexpr EditKind DeleteIndicator::kKind
    = make_edit_kind<DeleteIndicator, list, applied, described>("delete_indicator");

} // namespace tractus
