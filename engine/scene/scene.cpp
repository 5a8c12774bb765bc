#include "engine/scene/scene.h"

#include "engine/scene/limb_edits.h"
#include "engine/scene/scene_builder.h"

#include <algorithm>
#include <set>
#include <utility>

namespace tractus::scene {

std::vector<variation::MotionIndicator> motion_indicators(BuiltPlant const& plant)
{
    std::vector<variation::MotionIndicator> indicators;
    for (auto const& indicator : plant.indicators)
        indicators.push_back(indicator.what);
    return indicators;
}

std::vector<std::size_t> shaping_numbers(BuiltPlant const& plant)
{
    // Orders associations by path and propagation. Most associations with equal paths share one
    // list of segments, so comparing the lists' ids is usually sufficient.
    auto const before = [&](std::size_t one, std::size_t other) {
        auto const& a = plant.associations[one].what;
        auto const& b = plant.associations[other].what;
        if (a.propagation != b.propagation)
            return a.propagation < b.propagation;
        return a.path.data() != b.path.data() && a.path.vector() < b.path.vector();
    };
    std::set<std::size_t, decltype(before)> later(before);
    std::vector<std::size_t> numbers;
    for (auto i = plant.associations.size(); i-- > 0;)
        if (!plant.associations[i].what.is_orphaned && later.insert(i).second)
            numbers.push_back(i);
    std::reverse(numbers.begin(), numbers.end());
    return numbers;
}

std::vector<variation::Association> shaping_associations(BuiltPlant const& plant)
{
    std::vector<variation::Association> shaping;
    for (auto const number : shaping_numbers(plant))
        shaping.push_back(plant.associations[number].what);
    return shaping;
}

std::vector<std::vector<SegmentId>> drawn_paths(BuiltPlant const& plant)
{
    std::vector<std::vector<SegmentId>> paths;
    for (auto const number : shaping_numbers(plant))
        paths.push_back(plant.associations[number].what.path.vector());
    for (auto const& [graft, first] : limb_segments(plant))
        paths.push_back({ first });
    return paths;
}

std::vector<std::size_t> selected_associations(BuiltPlant const& plant)
{
    std::vector<bool> is_selected(plant.base->segment_count());
    for (auto const& path : plant.selection)
        for (auto const segment : path)
            is_selected[segment] = true;
    auto numbers = shaping_numbers(plant);
    std::erase_if(numbers, [&](std::size_t number) {
        auto const& path = plant.associations[number].what.path;
        return std::none_of(path.begin(), path.end(),
                            [&](SegmentId segment) { return is_selected[segment]; });
    });
    return numbers;
}

Result<DocumentState> apply_edits(DocumentState state, std::span<Edit const> edits,
                                  SceneBuilder& builder)
{
    for (auto const& edit : edits)
        state = TRY(apply_edit(std::move(state), edit, builder));
    return state;
}

Result<Scene> apply_edits(Scene scene, std::span<Edit const> edits,
                          MakeLoadOptions const& load_options)
{
    SceneBuilder builder(scene, load_options);
    return builder.build(TRY(apply_edits(std::move(scene.state), edits, builder)));
}

Result<Scene> apply_edit(Scene scene, Edit const& edit, MakeLoadOptions const& load_options)
{
    return apply_edits(std::move(scene), std::span(&edit, 1), load_options);
}

Result<Scene> fold(std::span<Edit const> edits)
{
    return apply_edits({}, edits);
}

Scene preview_in_season(Scene scene, std::optional<Season> const& season)
{
    auto const show = [&](BuiltPlant& plant) {
        plant.in_season = season ? std::make_shared<Plant const>(
                              in_season(*plant.foliated, *season, scene.state.leaf_sheets))
                                 : plant.foliated;
    };
    for (auto& shared : scene.plants) {
        auto plant = std::make_shared<BuiltPlant>(*shared);
        show(*plant);
        shared = std::move(plant);
    }
    show(scene);
    return scene;
}

} // namespace tractus::scene
