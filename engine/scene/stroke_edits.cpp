#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"
#include "engine/stroke/derived_tips.h"
#include "engine/stroke/oversketch.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace tractus {

namespace {

// In the order of the enumerations' values.
constexpr std::array kPropagations { "selected", "descendants", "both" };
constexpr std::array kFits { "start", "chord", "world" };

// After hours of drawing each branch has been drawn many times: its path and place are held once.
void share_with_earlier(Scene const& scene, Anchored<Association>& drawn)
{
    for (auto i = scene.associations.size(); i-- > 0;) {
        auto const& earlier = scene.associations[i];
        if (earlier.what.path != drawn.what.path || earlier.at != drawn.at)
            continue;
        drawn.what.path = earlier.what.path;
        drawn.at = earlier.at;
        return;
    }
}

// Their numbers in the scene's list, each once, the last first: the others keep theirs when it
// goes. Refuses strokes that are not there, and none at all.
Result<std::vector<std::size_t>> find_strokes(Scene const& scene, Items const& strokes)
{
    if (strokes.empty())
        return fail(Fault::User, "no stroke is chosen: select a branch that has been drawn");
    std::vector<std::size_t> found(strokes.numbers.begin(), strokes.numbers.end());
    for (auto const number : found)
        if (number >= scene.associations.size())
            return fail(Fault::User,
                        fmt::format("there is no stroke {}: the scene has {}", number + 1,
                                    scene.associations.size()));
    std::map<ItemId, std::size_t> numbers; // Looked through once, however many are wanted.
    for (std::size_t i = 0; i < scene.associations.size() && !strokes.ids.empty(); ++i)
        numbers.emplace(scene.associations[i].id, i);
    for (auto const id : strokes.ids) {
        auto const number = numbers.find(id);
        if (number == numbers.end())
            return fail(Fault::User, fmt::format("there is no stroke {} any more", name_of(id)));
        found.push_back(number->second);
    }
    std::sort(found.begin(), found.end(), std::greater<> {});
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

// As find_strokes() understands them: what older sessions count from 0, people count from 1.
std::string names_of(Items const& strokes)
{
    return strokes.ids.empty() ? list_numbers(strokes.numbers) : list_names(strokes.ids);
}

void list(Fields& fields, Items& strokes)
{
    fields.sparse_field("strokes", &strokes.ids);
    fields.sparse_field("associations", &strokes.numbers);
}

// Puts what `change` makes of them in the place of strokes. One stroke for several branches stays
// one: its tips are held once.
Result<Scene> with_changed_strokes(Scene scene, Items const& strokes,
                                   std::function<Result<Stroke>(Stroke const& drawn)> const& change)
{
    auto const numbers = TRY(find_strokes(scene, strokes));
    Stroke drawn;
    Stroke changed;
    for (auto const number : numbers) {
        auto association = scene.associations[number];
        if (association.what.stroke.tips.id() != drawn.tips.id()) {
            drawn = association.what.stroke;
            changed = TRY(change(drawn));
        }
        association.what.stroke = changed;
        TRY(check_association(*scene.base, association.what));
        scene.associations.replace(number, std::move(association));
    }
    return scene;
}

void list(Fields& fields, Associate& edit)
{
    fields.word("propagation", edit.propagation, kPropagations);
    fields.word("fit", edit.fit, kFits);
    fields.field("kept_hand", &edit.detail_weight);
    fields.id(edit.id);
    fields.numbers(edit.stroke);
}

Result<Scene> applied(Scene scene, Associate const& edit, LoadOptions const&)
{
    if (scene.selection.empty())
        return fail(Fault::User,
                    "nothing is selected for the stroke to shape: select a branch first");
    auto const edit_number = edit_of_item(take_id(scene, edit.id));
    std::size_t item = 0;
    for (auto const& path : scene.selection) {
        Anchored<Association> drawn;
        drawn.id = item_id(edit_number, item++);
        drawn.what = { .path = path,
                       .stroke = edit.stroke,
                       .propagation = edit.propagation,
                       .fit = edit.fit,
                       .detail_weight = edit.detail_weight };
        drawn.at.push_back(scene.rest->addresses.address_of(*scene.base, path));
        // Refused here, at its own edit, rather than later when the plant is grown.
        TRY(check_association(*scene.base, drawn.what));
        share_with_earlier(scene, drawn);
        scene.associations.push_back(std::move(drawn));
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
    list(fields, edit.strokes);
    fields.numbers(edit.over);
}

Result<Scene> applied(Scene scene, Oversketch const& edit, LoadOptions const&)
{
    return with_changed_strokes(
        std::move(scene), edit.strokes, [&](Stroke const& drawn) -> Result<Stroke> {
            auto const tips = TRY(drawn.tips.in_memory());
            auto const redrawn = TRY(oversketch({ tips }, edit.over));
            return Stroke { { redrawn.tips.vector(),
                              redrawn_source(drawn.tips.source(), edit.over.tips.source()) } };
        });
}

std::string described(Oversketch const& edit)
{
    return fmt::format("redraws a part of stroke {}: {}", names_of(edit.strokes),
                       describe_stroke(edit.over));
}

void list(Fields& fields, SmoothStroke& edit)
{
    list(fields, edit.strokes);
    fields.field("kept_hand", &edit.detail_weight);
}

Result<Scene> applied(Scene scene, SmoothStroke const& edit, LoadOptions const&)
{
    for (auto const number : TRY(find_strokes(scene, edit.strokes))) {
        auto association = scene.associations[number];
        association.what.detail_weight = edit.detail_weight;
        TRY(check_association(*scene.base, association.what));
        scene.associations.replace(number, std::move(association));
    }
    return scene;
}

std::string described(SmoothStroke const& edit)
{
    return fmt::format("smooths stroke {}, keeping {:.0f} % of the hand", names_of(edit.strokes),
                       100 * edit.detail_weight);
}

void list(Fields& fields, DeleteStroke& edit)
{
    list(fields, edit.strokes);
}

Result<Scene> applied(Scene scene, DeleteStroke const& edit, LoadOptions const&)
{
    for (auto const number : TRY(find_strokes(scene, edit.strokes)))
        scene.associations.erase(number);
    return scene;
}

std::string described(DeleteStroke const& edit)
{
    return fmt::format("takes stroke {} away", names_of(edit.strokes));
}

void list(Fields& fields, EraseTips& edit)
{
    list(fields, edit.strokes);
    fields.field("ranges", &edit.ranges);
}

Result<Scene> applied(Scene scene, EraseTips const& edit, LoadOptions const&)
{
    return with_changed_strokes(
        std::move(scene), edit.strokes, [&](Stroke const& drawn) -> Result<Stroke> {
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
    return fmt::format("erases {} of stroke {}", counted(count, "tip"), names_of(edit.strokes));
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
