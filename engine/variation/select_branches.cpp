#include "engine/variation/select_branches.h"

#include "engine/plant/join_axes.h"

#include <algorithm>
#include <fmt/format.h>
#include <unordered_set>

namespace tractus::variation {

Result<std::vector<SegmentId>> path_by_ends(BranchTree const& tree, SegmentId one, SegmentId other)
{
    if (one >= tree.size() || other >= tree.size())
        return fail(Fault::User,
                    fmt::format("segment {} is not in the plant, which has {}: select its ends "
                                "again",
                                std::max(one, other), tree.size()));
    if (tree.is_descendant(other, one))
        return path_between(tree, one, other);
    if (tree.is_descendant(one, other))
        return path_between(tree, other, one);
    return fail(Fault::User,
                "no way from the root to a tip passes both ends: choose two ends of which one "
                "bears the other");
}

Selection axes_of_order(Plant const& plant, std::uint32_t order)
{
    Selection selection;
    for (auto const& axis : plant.axes)
        if (axis.order == order)
            selection.push_back(segments_of(axis));
    return selection;
}

Selection similar_siblings(Plant const& plant, SegmentId segment)
{
    auto const& like = plant.axes[axis_of(plant, segment)];
    double const length_mm = axis_length_mm(plant, like);
    Selection selection;
    for (auto const& axis : plant.axes) {
        if (axis.parent_axis != like.parent_axis)
            continue;
        double const other_mm = axis_length_mm(plant, axis);
        if (2 * other_mm >= length_mm && other_mm <= 2 * length_mm)
            selection.push_back(segments_of(axis));
    }
    return selection;
}

Selection inverted(Plant const& plant, Selection const& selection)
{
    std::vector<bool> is_selected(plant.segment_count());
    for (auto const& path : selection)
        for (auto const segment : path)
            is_selected[segment] = true;
    Selection others;
    for (auto const& axis : plant.axes) {
        bool goes_on = false;
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            auto const segment = axis.first_segment + i;
            if (is_selected[segment]) {
                goes_on = false;
                continue;
            }
            if (!goes_on)
                others.emplace_back();
            others.back().push_back(segment);
            goes_on = true;
        }
    }
    return others;
}

Selection added(Selection selection, Selection const& more)
{
    for (auto const& path : more)
        if (std::find(selection.begin(), selection.end(), path) == selection.end())
            selection.push_back(path);
    return selection;
}

Selection taken(Selection const& selection, Selection const& less)
{
    std::unordered_set<SegmentId> gone;
    for (auto const& path : less)
        gone.insert(path.begin(), path.end());
    Selection left;
    for (auto const& path : selection) {
        bool goes_on = false;
        for (auto const segment : path) {
            if (gone.contains(segment)) {
                goes_on = false;
                continue;
            }
            if (!goes_on)
                left.emplace_back();
            left.back().push_back(segment);
            goes_on = true;
        }
    }
    return left;
}

} // namespace tractus::variation
