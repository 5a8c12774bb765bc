#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"
#include "engine/stroke/derived_tips.h"
#include "engine/stroke/oversketch.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace tractus {

namespace {

// In the order of the enumerations' values.
constexpr std::array kPropagations { "selected", "descendants", "both" };
constexpr std::array kFits { "start", "chord", "world" };

// After hours of drawing each branch has been drawn many times: its path and place are held once.
void share_with_earlier(Scene const& scene, Association& association,
                        std::shared_ptr<PathAddress const>& place)
{
    for (auto i = scene.associations.size(); i-- > 0;) {
        auto const& earlier = *scene.places[i];
        if (scene.associations[i].path != association.path || earlier.first != place->first
            || earlier.last != place->last)
            continue;
        association.path = scene.associations[i].path;
        place = scene.places[i];
        return;
    }
}

// Refuses numbers that no association has, and none at all.
Result<void> check_numbers(Scene const& scene, std::span<std::size_t const> numbers)
{
    if (numbers.empty())
        return fail(Fault::User, "no stroke is chosen: select a branch that has been drawn");
    for (auto const number : numbers)
        if (number >= scene.associations.size())
            return fail(Fault::User,
                        fmt::format("there is no stroke {}: the scene has {}", number + 1,
                                    scene.associations.size()));
    return {};
}

// Each once, the last first: the others keep their numbers when it goes.
std::vector<std::size_t> each_once(std::vector<std::size_t> numbers)
{
    std::sort(numbers.begin(), numbers.end(), std::greater<> {});
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

// Puts what `change` makes of them in the place of the strokes with these numbers. One stroke for
// several branches stays one: its tips are held once.
Result<Scene> with_changed_strokes(Scene scene, std::vector<std::size_t> const& numbers,
                                   std::function<Result<Stroke>(Stroke const& drawn)> const& change)
{
    TRY(check_numbers(scene, numbers));
    Stroke drawn;
    Stroke changed;
    for (auto const number : each_once(numbers)) {
        auto association = scene.associations[number];
        if (association.stroke.tips.id() != drawn.tips.id()) {
            drawn = association.stroke;
            changed = TRY(change(drawn));
        }
        association.stroke = changed;
        TRY(check_association(*scene.base, association));
        scene.associations.replace(number, std::move(association));
    }
    return scene;
}

void list(Fields& fields, Associate& edit)
{
    fields.word("propagation", edit.propagation, kPropagations);
    fields.word("fit", edit.fit, kFits);
    fields.field("kept_hand", &edit.detail_weight);
    fields.numbers(edit.stroke);
}

Result<Scene> applied(Scene scene, Associate const& edit, LoadOptions const&)
{
    if (scene.selection.empty())
        return fail(Fault::User,
                    "nothing is selected for the stroke to shape: select a branch first");
    for (auto const& path : scene.selection) {
        Association association { .path = path,
                                  .stroke = edit.stroke,
                                  .propagation = edit.propagation,
                                  .fit = edit.fit,
                                  .detail_weight = edit.detail_weight };
        // Refused here, at its own edit, rather than later when the plant is grown.
        TRY(check_association(*scene.base, association));
        auto place = std::make_shared<PathAddress const>(address_of(*scene.base, path));
        share_with_earlier(scene, association, place);
        scene.associations.push_back(std::move(association));
        scene.places.push_back(std::move(place));
    }
    return scene;
}

std::string described(Associate const& edit)
{
    static constexpr std::array kWhat { "what is selected", "what the selected bears",
                                        "what is selected and bears" };
    static constexpr std::array kHow { "", ", tip where it was", ", as in the world" };
    return fmt::format("shapes {} by a stroke: {}{}",
                       kWhat[static_cast<std::size_t>(edit.propagation)],
                       describe_stroke(edit.stroke), kHow[static_cast<std::size_t>(edit.fit)]);
}

void list(Fields& fields, Oversketch& edit)
{
    fields.field("associations", &edit.associations);
    fields.numbers(edit.over);
}

Result<Scene> applied(Scene scene, Oversketch const& edit, LoadOptions const&)
{
    return with_changed_strokes(
        std::move(scene), edit.associations, [&](Stroke const& drawn) -> Result<Stroke> {
            auto const tips = TRY(drawn.tips.in_memory());
            auto const redrawn = TRY(oversketch({ tips }, edit.over));
            return Stroke { { redrawn.tips.vector(),
                              redrawn_source(drawn.tips.source(), edit.over.tips.source()) } };
        });
}

std::string described(Oversketch const& edit)
{
    return fmt::format("redraws a part of stroke {}: {}", list_numbers(edit.associations),
                       describe_stroke(edit.over));
}

void list(Fields& fields, SmoothStroke& edit)
{
    fields.field("associations", &edit.associations);
    fields.field("kept_hand", &edit.detail_weight);
}

Result<Scene> applied(Scene scene, SmoothStroke const& edit, LoadOptions const&)
{
    TRY(check_numbers(scene, edit.associations));
    for (auto const number : edit.associations) {
        auto association = scene.associations[number];
        association.detail_weight = edit.detail_weight;
        TRY(check_association(*scene.base, association));
        scene.associations.replace(number, std::move(association));
    }
    return scene;
}

std::string described(SmoothStroke const& edit)
{
    return fmt::format("smooths stroke {}, keeping {:.0f} % of the hand",
                       list_numbers(edit.associations), 100 * edit.detail_weight);
}

void list(Fields& fields, DeleteStroke& edit)
{
    fields.field("associations", &edit.associations);
}

Result<Scene> applied(Scene scene, DeleteStroke const& edit, LoadOptions const&)
{
    TRY(check_numbers(scene, edit.associations));
    for (auto const number : each_once(edit.associations)) {
        scene.associations.erase(number);
        scene.places.erase(number);
    }
    return scene;
}

std::string described(DeleteStroke const& edit)
{
    return fmt::format("takes stroke {} away", list_numbers(edit.associations));
}

void list(Fields& fields, EraseTips& edit)
{
    fields.field("associations", &edit.associations);
    fields.field("ranges", &edit.ranges);
}

Result<Scene> applied(Scene scene, EraseTips const& edit, LoadOptions const&)
{
    return with_changed_strokes(
        std::move(scene), edit.associations, [&](Stroke const& drawn) -> Result<Stroke> {
            auto const tips = TRY(drawn.tips.in_memory());
            auto const rest = TRY(erase_tips({ tips }, edit.ranges));
            return Stroke { { rest.tips.vector(),
                              erased_source(drawn.tips.source(), edit.ranges) } };
        });
}

std::string described(EraseTips const& edit)
{
    std::size_t count = 0;
    for (auto const& [first, last] : edit.ranges)
        count += last + 1 - first;
    return fmt::format("erases {} of stroke {}", counted(count, "tip"),
                       list_numbers(edit.associations));
}

} // namespace

constexpr EditKind Associate::kKind
    = make_edit_kind<Associate, list, applied, described>("associate");

constexpr EditKind Oversketch::kKind
    = make_edit_kind<Oversketch, list, applied, described>("oversketch");

constexpr EditKind SmoothStroke::kKind
    = make_edit_kind<SmoothStroke, list, applied, described>("smooth_stroke");

constexpr EditKind DeleteStroke::kKind
    = make_edit_kind<DeleteStroke, list, applied, described>("delete_stroke");

constexpr EditKind EraseTips::kKind
    = make_edit_kind<EraseTips, list, applied, described>("erase_tips");

} // namespace tractus
