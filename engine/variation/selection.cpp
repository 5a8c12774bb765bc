#include "engine/variation/selection.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace tractus::variation {

// Maximum number of steps for one movement of the pen. Longer movements are walked in longer steps.
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

// Extends the selected path to `segment`, a descendant of its last segment. Undetermined segments
// that are not on the extended path become unselected.
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

SelectionPen::SelectionPen(ProjectedSkeleton const& skeleton, BranchTree const& tree,
                           PathSelection& selection, PickOptions const& options)
    : skeleton_(skeleton)
    , tree_(tree)
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

// Returns the last common ancestor of the segments in covering_; no value if covering_ is empty.
// The segments must have a common ancestor.
std::optional<SegmentId> SelectionPen::common() const
{
    if (covering_.empty())
        return std::nullopt;
    SegmentId common = covering_.front();
    for (auto const segment : covering_)
        while (!tree_.is_descendant(segment, common))
            common = tree_.parent[common];
    return common;
}

// Returns the segment at which a path through `segment` begins: its nearest ancestor among the
// segments under the pen where it came down (beginnings_), or `segment` itself if there is none.
SegmentId SelectionPen::beginning_of(SegmentId segment) const
{
    SegmentId nearest = kNone;
    for (auto const beginning : beginnings_)
        if (tree_.is_descendant(segment, beginning)
            && (nearest == kNone || tree_.is_descendant(beginning, nearest)))
            nearest = beginning;
    return nearest == kNone ? segment : nearest;
}

bool SelectionPen::touch_at(Vec2 const& point)
{
    auto const front = skeleton_.pick(point, options_);
    ambiguous_.reset();
    if (!front)
        return false;
    skeleton_.find_covering(point, options_, covering_);
    if (selection_.selected().empty())
        return begin(*front);

    auto const end = selection_.selected().back();
    std::erase_if(covering_, [&](SegmentId segment) {
        return segment == end || !tree_.is_descendant(segment, end);
    });
    auto const segment = common().value_or(*front);
    if (segment != *front)
        ambiguous_ = front;
    if (segment == end || segment == last_touched_)
        return false;
    last_touched_ = segment;
    return selection_.touch(segment);
}

bool SelectionPen::begin(SegmentId front)
{
    std::sort(covering_.begin(), covering_.end());
    covering_.erase(std::unique(covering_.begin(), covering_.end()), covering_.end());
    if (beginnings_.empty())
        beginnings_ = covering_;
    if (covering_.size() > 1) {
        ambiguous_ = front;
        return false;
    }
    selection_.touch(beginning_of(front));
    selection_.touch(front);
    last_touched_ = front;
    return true;
}

std::vector<std::vector<SegmentId>> SelectionPen::lift()
{
    if (ambiguous_)
        selection_.touch(*ambiguous_);
    return selection_.finish();
}

} // namespace tractus::variation
