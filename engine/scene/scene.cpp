#include "engine/scene/scene.h"

#include <algorithm>
#include <set>
#include <utility>

namespace tractus {

ItemId take_id(Scene& scene, ItemId own)
{
    if (own == 0)
        return item_id(scene.last_edit, 0);
    scene.last_edit = std::max(scene.last_edit, edit_of_item(own));
    return own;
}

std::vector<MotionIndicator> motion_indicators(Scene const& scene)
{
    std::vector<MotionIndicator> indicators;
    for (auto const& indicator : scene.indicators)
        indicators.push_back(indicator.what);
    return indicators;
}

std::vector<std::size_t> shaping_numbers(Scene const& scene)
{
    // Whether two are for the same path and propagation; most that are share the path itself.
    auto const before = [&](std::size_t one, std::size_t other) {
        auto const& a = scene.associations[one].what;
        auto const& b = scene.associations[other].what;
        if (a.propagation != b.propagation)
            return a.propagation < b.propagation;
        return a.path.data() != b.path.data() && a.path.vector() < b.path.vector();
    };
    std::set<std::size_t, decltype(before)> later(before);
    std::vector<std::size_t> numbers;
    for (auto i = scene.associations.size(); i-- > 0;)
        if (!scene.associations[i].what.is_orphaned && later.insert(i).second)
            numbers.push_back(i);
    std::reverse(numbers.begin(), numbers.end());
    return numbers;
}

std::vector<Association> shaping_associations(Scene const& scene)
{
    std::vector<Association> shaping;
    for (auto const number : shaping_numbers(scene))
        shaping.push_back(scene.associations[number].what);
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
        auto const& path = scene.associations[number].what.path;
        return std::none_of(path.begin(), path.end(),
                            [&](SegmentId segment) { return is_selected[segment]; });
    });
    return numbers;
}

Result<Scene> fold(std::span<Edit const> edits)
{
    Scene scene;
    for (auto const& edit : edits)
        scene = TRY(apply_edit(std::move(scene), edit));
    return scene;
}

} // namespace tractus
