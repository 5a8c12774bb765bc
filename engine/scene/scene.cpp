#include "engine/scene/scene.h"

#include "engine/base/check.h"
#include "engine/lsystem/derive.h"
#include "engine/lsystem/interpret.h"
#include "engine/plant/join_axes.h"
#include "engine/stroke/oversketch.h"
#include "engine/variation/place_nodes.h"

#include <algorithm>
#include <fmt/core.h>
#include <functional>
#include <map>
#include <set>
#include <type_traits>
#include <utility>

namespace tractus {

namespace {

// Finds the branches that something was drawn for again, by where they were.
void keep_drawn(Scene const& before, Scene& now)
{
    now.places = before.places;
    std::map<PathAddress const*, SharedVector<SegmentId>> paths; // Empty: there is none.
    for (std::size_t i = 0; i < now.places.size(); ++i) {
        auto const& place = now.places[i];
        auto const [found, is_new] = paths.try_emplace(place.get());
        if (is_new)
            if (auto path = find_path(*now.base, *place))
                found->second = *std::move(path);
        auto association = before.associations[i];
        association.path = found->second;
        association.is_orphaned = association.path.empty();
        now.associations.push_back(std::move(association));
    }
    now.indicator_places = before.indicator_places;
    now.indicators = before.indicators;
    for (std::size_t i = 0; i < now.indicators.size(); ++i) {
        auto& indicator = now.indicators[i];
        indicator.below.clear();
        for (auto const& place : now.indicator_places[i])
            if (auto const segment = find_segment(*now.base, place))
                indicator.below.push_back(*segment);
        indicator.is_orphaned = indicator.below.empty() && !now.indicator_places[i].empty();
    }
}

// The scene with another base plant.
Scene with_plant(Scene const& scene, std::string const& name, Plant plant, Drawn drawn)
{
    Scene loaded;
    loaded.model_name = name;
    loaded.placement = place_on_desk(plant);
    loaded.base = std::make_shared<Plant const>(std::move(plant));
    loaded.rest = std::make_shared<RestShape const>(find_rest_shape(*loaded.base));
    loaded.growth = scene.growth;
    if (drawn == Drawn::Keep)
        keep_drawn(scene, loaded);
    return loaded;
}

Result<Scene> applied(Scene const& scene, LoadModel const& edit, LoadOptions const& options)
{
    auto const include = [&](std::string const& name) -> Result<std::string> {
        auto const found = edit.includes.find(name);
        if (found == edit.includes.end())
            return fail(Fault::User,
                        fmt::format("{} includes {}, which is missing", edit.source.name, name));
        return found->second;
    };
    auto const model = TRY(compile_model(edit.source, include));
    auto const string = TRY(derive(model,
                                   { .steps = edit.steps,
                                     .seed = edit.seed,
                                     .limits = options.limits,
                                     .print = options.print }));
    auto turtle = TRY(interpret_with_warnings(
        model, string, { .time = options.limits.time, .print = options.print }));
    auto loaded = with_plant(scene, edit.source.name, join_axes(turtle.plant), edit.drawn);
    loaded.model_warnings = model.warnings;
    loaded.model_warnings.insert(loaded.model_warnings.end(), turtle.warnings.begin(),
                                 turtle.warnings.end());
    return loaded;
}

Result<Scene> applied(Scene const& scene, LoadSkeleton const& edit)
{
    auto plant = TRY(plant_from_lines(edit.name, edit.lines));
    return with_plant(scene, edit.name, std::move(plant), edit.drawn);
}

Result<Scene> applied(Scene scene, Select const& edit)
{
    for (auto const& path : edit.paths)
        for (auto const segment : path)
            if (segment >= scene.base->segment_count())
                return fail(Fault::User,
                            fmt::format("segment {} cannot be selected: the plant has {}", segment,
                                        scene.base->segment_count()));
    scene.selection = edit.paths;
    return scene;
}

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

Result<Scene> applied(Scene scene, Associate const& edit)
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

Result<Scene> applied(Scene scene, Oversketch const& edit)
{
    TRY(check_numbers(scene, edit.associations));
    for (auto const number : edit.associations) {
        auto association = scene.associations[number];
        auto drawn = TRY(association.stroke.tips.in_memory());
        association.stroke = TRY(oversketch({ std::move(drawn) }, edit.over));
        TRY(check_association(*scene.base, association));
        scene.associations.replace(number, std::move(association));
    }
    return scene;
}

Result<Scene> applied(Scene scene, SmoothStroke const& edit)
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

// Each once, the last first: the others keep their numbers when it goes.
std::vector<std::size_t> each_once(std::vector<std::size_t> numbers)
{
    std::sort(numbers.begin(), numbers.end(), std::greater<> {});
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    return numbers;
}

// One stroke for several branches stays one: its tips are held once.
Result<Scene> applied(Scene scene, EraseTips const& edit)
{
    TRY(check_numbers(scene, edit.associations));
    Stroke drawn;
    Stroke rest;
    for (auto const number : each_once(edit.associations)) {
        auto association = scene.associations[number];
        if (association.stroke.tips.id() != drawn.tips.id()) {
            drawn = association.stroke;
            auto tips = TRY(drawn.tips.in_memory());
            rest = TRY(erase_tips({ std::move(tips) }, edit.ranges));
        }
        association.stroke = rest;
        TRY(check_association(*scene.base, association));
        scene.associations.replace(number, std::move(association));
    }
    return scene;
}

Result<Scene> applied(Scene scene, DeleteStroke const& edit)
{
    TRY(check_numbers(scene, edit.associations));
    for (auto const number : each_once(edit.associations)) {
        scene.associations.erase(number);
        scene.places.erase(number);
    }
    return scene;
}

std::vector<SegmentAddress> places_of(Scene const& scene, MotionIndicator const& indicator)
{
    std::vector<SegmentAddress> places;
    for (auto const segment : indicator.below)
        places.push_back(address_of(*scene.base, segment));
    return places;
}

Result<Scene> applied(Scene scene, Indicate const& edit)
{
    TRY(check_indicator(*scene.base, edit.indicator));
    scene.indicators.push_back(edit.indicator);
    scene.indicator_places.push_back(places_of(scene, edit.indicator));
    return scene;
}

Result<void> check_number(Scene const& scene, std::size_t indicator)
{
    if (indicator >= scene.indicators.size())
        return fail(Fault::User,
                    fmt::format("there is no motion indicator {}: the scene has {}", indicator + 1,
                                scene.indicators.size()));
    return {};
}

Result<Scene> applied(Scene scene, ChangeIndicator const& edit)
{
    TRY(check_number(scene, edit.number));
    TRY(check_indicator(*scene.base, edit.indicator));
    // An orphan that is only moved still waits for its branch.
    if (!edit.indicator.is_orphaned)
        scene.indicator_places[edit.number] = places_of(scene, edit.indicator);
    scene.indicators[edit.number] = edit.indicator;
    return scene;
}

Result<Scene> applied(Scene scene, DeleteIndicator const& edit)
{
    TRY(check_number(scene, edit.number));
    auto const at = static_cast<std::ptrdiff_t>(edit.number);
    scene.indicators.erase(scene.indicators.begin() + at);
    scene.indicator_places.erase(scene.indicator_places.begin() + at);
    return scene;
}

Result<Scene> applied(Scene scene, SetGrowth const& edit)
{
    TRY(check_growth_parameters(edit.parameters));
    TRY(at_variability(edit.parameters, edit.variability));
    if (!(edit.age >= 0 && edit.age <= 1))
        return fail(Fault::User,
                    fmt::format("a plant cannot be {} of its age: give 0 (a seed) to "
                                "1 (full-grown)",
                                edit.age));
    scene.growth = edit;
    return scene;
}

} // namespace

std::vector<std::size_t> shaping_numbers(Scene const& scene)
{
    // Whether two are for the same path and propagation; most that are share the path itself.
    auto const before = [&](std::size_t one, std::size_t other) {
        auto const& a = scene.associations[one];
        auto const& b = scene.associations[other];
        if (a.propagation != b.propagation)
            return a.propagation < b.propagation;
        return a.path.data() != b.path.data() && a.path.vector() < b.path.vector();
    };
    std::set<std::size_t, decltype(before)> later(before);
    std::vector<std::size_t> numbers;
    for (auto i = scene.associations.size(); i-- > 0;)
        if (!scene.associations[i].is_orphaned && later.insert(i).second)
            numbers.push_back(i);
    std::reverse(numbers.begin(), numbers.end());
    return numbers;
}

std::vector<Association> shaping_associations(Scene const& scene)
{
    std::vector<Association> shaping;
    for (auto const number : shaping_numbers(scene))
        shaping.push_back(scene.associations[number]);
    return shaping;
}

std::vector<std::size_t> selected_associations(Scene const& scene)
{
    std::vector<bool> is_selected(scene.base->segment_count());
    for (auto const& path : scene.selection)
        for (auto const segment : path)
            is_selected[segment] = true;
    auto numbers = shaping_numbers(scene);
    std::erase_if(numbers, [&](std::size_t number) {
        auto const& path = scene.associations[number].path;
        return std::none_of(path.begin(), path.end(),
                            [&](SegmentId segment) { return is_selected[segment]; });
    });
    return numbers;
}

Result<Scene> apply_edit(Scene scene, Edit const& edit, LoadOptions const& options)
{
    if (auto const* const model = std::get_if<LoadModel>(&edit))
        return applied(scene, *model, options);
    return std::visit(
        [&]<typename Kind>(Kind const& kind) -> Result<Scene> {
            if constexpr (std::is_same_v<Kind, LoadModel>)
                CHECK(false);
            else
                return applied(std::move(scene), kind);
        },
        edit);
}

Result<Scene> fold(std::span<Edit const> edits)
{
    Scene scene;
    for (auto const& edit : edits)
        scene = TRY(apply_edit(std::move(scene), edit));
    return scene;
}

} // namespace tractus
