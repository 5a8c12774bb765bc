#include "engine/variation/selection.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace tractus {

// Nobody's screen is larger: what is farther apart is walked in longer steps.
constexpr double kLongestMove = 1e5;

PathSelection::PathSelection(BranchTree const& tree)
    : tree_(tree)
    , states_(tree.size(), SegmentState::Unselected)
{
}

bool PathSelection::touch(SegmentId segment)
{
    CHECK(segment < tree_.size());
    if (states_[segment] != SegmentState::Unselected)
        return false;
    if (path_.empty()) {
        path_.push_back(segment);
        states_[segment] = SegmentState::Selected;
        return true;
    }
    if (!tree_.is_descendant(segment, path_.back()))
        return false;

    if (tree_.parent[segment] != path_.back())
        select_down_to(tree_.parent[segment]);
    states_[segment] = SegmentState::Undetermined;
    undetermined_.push_back(segment);
    return true;
}

// Selects from the end of the path to its descendant `segment`. This is what shows that nothing
// that was undetermined beside that way was meant.
void PathSelection::select_down_to(SegmentId segment)
{
    for (auto const other : undetermined_)
        states_[other] = SegmentState::Unselected;
    undetermined_.clear();
    auto const way = path_between(tree_, path_.back(), segment);
    for (auto const next : std::span(way).subspan(1)) {
        states_[next] = SegmentState::Selected;
        path_.push_back(next);
    }
}

std::vector<std::vector<SegmentId>> PathSelection::finish()
{
    if (path_.empty())
        return {};
    if (undetermined_.empty())
        return { path_ };
    std::vector<std::vector<SegmentId>> paths;
    for (auto const last : undetermined_) {
        states_[last] = SegmentState::Selected;
        paths.push_back(path_);
        paths.back().push_back(last);
    }
    return paths;
}

void PathSelection::clear()
{
    for (auto const segment : path_)
        states_[segment] = SegmentState::Unselected;
    for (auto const segment : undetermined_)
        states_[segment] = SegmentState::Unselected;
    path_.clear();
    undetermined_.clear();
}

SelectionPen::SelectionPen(ProjectedSkeleton const& skeleton, PathSelection& selection,
                           PickOptions const& options)
    : skeleton_(skeleton)
    , selection_(selection)
    , options_(options)
{
}

bool SelectionPen::move_to(Vec2 const& point)
{
    if (!point.allFinite())
        return false;
    Vec2 const from = last_point_.value_or(point);
    last_point_ = point;
    auto const steps = static_cast<int>(std::ceil(std::min((point - from).norm(), kLongestMove)));
    bool changed = steps == 0 && touch_at(point);
    for (int i = 1; i <= steps; ++i)
        changed |= touch_at(from + (point - from) * (static_cast<double>(i) / steps));
    return changed;
}

bool SelectionPen::touch_at(Vec2 const& point)
{
    auto const segment = skeleton_.pick(point, options_);
    if (!segment || segment == last_touched_)
        return false;
    last_touched_ = segment;
    return selection_.touch(*segment);
}

} // namespace tractus
