#include "engine/lsystem/fast_rewriting/piece_neighbours.h"

#include <algorithm>

namespace tractus::lsystem {

using Role = NeighbourRoles::Role;

// Scans a piece from the right. The last module of a branch has no right neighbour. The module
// after a branch is the right neighbour of the module before the branch.
template<bool kSeesBranches>
void PieceNeighbours::read_all(NeighbourRoles const& roles, KindId const* string, std::size_t begin,
                               std::size_t end, KindId* rights)
{
    constexpr auto kFound = static_cast<std::size_t>(-1);
    missing_.clear();
    lefts_.assign(1, std::nullopt);
    waiting_.reserve(end - begin);
    auto* const waiting = waiting_.data();
    std::size_t depth = 0; // Closing brackets read so far whose opening bracket lies further left.
    std::size_t left_depth = 0; // Depth at which the next left neighbour is searched for.
    Neighbour taken = 0;
    Neighbour right = kOutside;
    for (auto i = end; i-- > begin;) {
        if (right >= kOutside)
            missing_.push_back({ i, right - kOutside });
        rights[i] = static_cast<KindId>(right);
        auto const kind = string[i];
        auto const role = roles.of_kind[kind];
        if (role == Role::Closing) {
            waiting[depth++] = right;
            if (kSeesBranches)
                right = roles.none;
        } else if (role == Role::Opening && depth > 0) {
            --depth;
            if (kSeesBranches)
                right = waiting[depth];
        } else if (role == Role::Opening) {
            lefts_.emplace_back();
            left_depth = 0;
            if (kSeesBranches)
                right = kOutside + ++taken;
        } else {
            right = role == Role::Seen ? kind : right;
            if (depth == left_depth && role == Role::Seen) {
                lefts_.back() = kind;
                left_depth = kFound;
            }
        }
    }
    waiting_.set_size(kSeesBranches ? depth : 0);
    right_ = right;
    taken_count_ = taken;
    closing_count_ = depth;
}

void PieceNeighbours::read(NeighbourRoles const& roles, KindId const* string, std::size_t begin,
                           std::size_t end, KindId* rights)
{
    if (roles.sees_branches)
        read_all<true>(roles, string, begin, end, rights);
    else
        read_all<false>(roles, string, begin, end, rights);
}

void PieceNeighbours::write_missing(KindId* rights) const
{
    for (auto const& [module, outside] : missing_)
        rights[module] = outside_[outside];
}

static KindId take(NeighbourRoles const& roles, std::vector<KindId>& waiting)
{
    if (waiting.empty())
        return roles.none;
    auto const last = waiting.back();
    waiting.pop_back();
    return last;
}

void PieceNeighbours::take_from_right(NeighbourRoles const& roles, KindId& right,
                                      std::vector<KindId>& waiting)
{
    outside_.assign(1, right);
    for (std::size_t i = 0; i < taken_count_; ++i)
        outside_.push_back(take(roles, waiting));
    for (auto const neighbour : waiting_.span())
        waiting.push_back(value(neighbour));
    right = value(right_);
}

void PieceNeighbours::take_from_left(NeighbourRoles const& roles, KindId& left,
                                     std::vector<KindId>& waiting)
{
    left_ = left;
    auto const first = waiting.size() - std::min(waiting.size(), closing_count_);
    waiting_lefts_.assign(waiting.begin() + static_cast<std::ptrdiff_t>(first), waiting.end());
    for (std::size_t i = 0; i < closing_count_; ++i)
        left = take(roles, waiting);
    for (auto i = lefts_.size(); i-- > 0;) {
        left = lefts_[i].value_or(left);
        if (i > 0)
            waiting.push_back(left);
    }
}

void join_neighbours(NeighbourRoles const& roles, std::span<PieceNeighbours> pieces)
{
    std::vector<KindId> waiting;
    auto neighbour = roles.none;
    for (auto i = pieces.size(); i-- > 0;)
        pieces[i].take_from_right(roles, neighbour, waiting);
    waiting.clear();
    neighbour = roles.none;
    for (auto& piece : pieces)
        piece.take_from_left(roles, neighbour, waiting);
}

} // namespace tractus::lsystem
