#include "engine/lsystem/text/hidden_macros.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace tractus::lsystem {

bool HiddenMacros::has(Id set, std::uint32_t macro) const
{
    return std::binary_search(sets_[set].begin(), sets_[set].end(), macro);
}

std::optional<HiddenMacros::Id> HiddenMacros::id(Set set)
{
    constexpr std::size_t kMaxSets = 100'000;
    if (set.size() > kMaxNesting || sets_.size() > kMaxSets)
        return std::nullopt;
    auto const [found, is_new] = ids_.try_emplace(set, static_cast<Id>(sets_.size()));
    if (is_new)
        sets_.push_back(std::move(set));
    return found->second;
}

std::optional<HiddenMacros::Id> HiddenMacros::in_both(Id a, Id b)
{
    if (a == b)
        return a;
    Set both;
    std::set_intersection(sets_[a].begin(), sets_[a].end(), sets_[b].begin(), sets_[b].end(),
                          std::back_inserter(both));
    return id(std::move(both));
}

std::optional<HiddenMacros::Id> HiddenMacros::in_any(Id a, Id b)
{
    if (a == kEmpty || a == b)
        return b;
    Set any;
    std::set_union(sets_[a].begin(), sets_[a].end(), sets_[b].begin(), sets_[b].end(),
                   std::back_inserter(any));
    return id(std::move(any));
}

std::optional<HiddenMacros::Id> HiddenMacros::with(Id set, std::uint32_t macro)
{
    auto with = sets_[set];
    with.insert(std::lower_bound(with.begin(), with.end(), macro), macro);
    return id(std::move(with));
}

} // namespace tractus::lsystem
