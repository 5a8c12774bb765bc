#include "engine/methods/silhouettes/styled_branch_set.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace tractus::silhouette {

static double angle_between_deg(Vec2 const& a, Vec2 const& b)
{
    return degrees(std::fabs(std::atan2(cross(a, b), a.dot(b))));
}

// Returns a branch's rank for a style that has room for some of the branches only: branches of the
// lowest rank are kept first.
static int rank_of(Branch const& branch)
{
    if (branch.is_user_drawn())
        return 0;
    switch (branch.origin) {
    case Branch::Origin::Bump:
    case Branch::Origin::Spaced:
        return 1; // The ends of these branches form the outline.
    case Branch::Origin::Copy:
        return 2;
    case Branch::Origin::Gap:
        return 3;
    case Branch::Origin::Drawn:
    case Branch::Origin::Apex:
        break;
    }
    return 4;
}

StyledBranchSetMaker::StyledBranchSetMaker(BranchSetMaker const& branch_sets,
                                           Skeleton const& skeleton, TreeOptions const& options,
                                           std::uint32_t level)
    : set_maker_(branch_sets)
    , skeleton_(skeleton)
    , options_(options)
    , level_(options.levels[level])
    , styled_(level_.style, level_.pattern, options.seed, level)
{
}

std::optional<BranchSet> StyledBranchSetMaker::next(Parent const& parent)
{
    auto const& system = skeleton_.systems[parent.system];
    if (!styled_.next_has_children())
        return std::nullopt;
    BranchSet branch_set { .parent = parent.line, .branches = {} };
    auto const surface = set_maker_.surface_of(parent.system);
    auto const drawn = BranchSetMaker::drawn_places(branch_set.parent, surface, system);
    // Branches of the trunk do not start below the crown. The crowns of branches are only inferred,
    // so on them the style alone decides where the first branch starts.
    double const crown_u = branch_set.parent.place_of(system.trunk[system.inside.first]);
    double const style_u = level_.style.unbranched;
    auto const drawn_by_hand
        = std::count_if(system.branches.begin(), system.branches.end(), [](Branch const& branch) {
              return branch.origin != Branch::Origin::Apex && branch.is_user_drawn();
          });
    auto const places = styled_.next({ parent.is_trunk ? crown_u : std::min(crown_u, style_u),
                                       static_cast<std::size_t>(drawn_by_hand), parent.number });
    auto const kept = kept_branches(system, drawn, places.size());
    std::vector<std::optional<std::size_t>> branch_at(places.size());
    std::vector<double> at;
    for (auto const i : kept)
        at.push_back(drawn[i].u);
    auto const nearest = nearest_in_order(at, places);
    for (std::size_t k = 0; k < kept.size(); ++k)
        branch_at[nearest[k]] = kept[k];
    Model const model { system, surface, drawn };
    auto const thetas = arrangement(model, branch_at, parent.number);
    double const extent = std::max(places.back() - places.front(), 1e-9);
    // Branches that keep their ends are placed first; the angles of the other branches compensate
    // for the angles of these.
    for (auto const has_end : { true, false })
        for (std::size_t k = 0; k < places.size(); ++k) {
            double const share = (places[k] - places.front()) / extent;
            StyledPlace const place { branch_at[k], { places[k], thetas[k].theta_deg }, share };
            if (has_end == keeps_end(parent, model, place))
                stand(parent, branch_set, model, place);
        }
    BranchSetMaker::finish(branch_set, system);
    return branch_set;
}

// Selects at most `most` visible branches and returns their indices in the order of their
// positions. Branches of the lowest rank are preferred; within a rank, those with the largest
// crowns.
std::vector<std::size_t> StyledBranchSetMaker::kept_branches(BranchingSystem const& system,
                                                             std::vector<DrawnPlace> const& drawn,
                                                             std::size_t most)
{
    std::vector<std::tuple<int, double, std::size_t>> ranks;
    for (std::size_t i = 0; i < drawn.size(); ++i)
        ranks.emplace_back(rank_of(system.branches[i]),
                           -std::fabs(signed_area(system.branches[i].crown)), i);
    std::sort(ranks.begin(), ranks.end());
    std::vector<std::size_t> kept;
    for (std::size_t k = 0; k < std::min(most, ranks.size()); ++k)
        kept.push_back(std::get<2>(ranks[k]));
    std::sort(kept.begin(), kept.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(drawn[a].u, a) < std::pair(drawn[b].u, b);
    });
    return kept;
}

// Arranges the branches around the parent. Positions are mapped as if nodes were equally spaced,
// because the pattern works on node numbers.
std::vector<Place>
StyledBranchSetMaker::arrangement(Model const& model,
                                  std::vector<std::optional<std::size_t>> const& branch_at,
                                  std::uint32_t id) const
{
    constexpr double kAnywhere_deg = 180;
    auto const count = branch_at.size();
    auto const whorl = node_size(level_.pattern);
    double const node = node_distance(level_.pattern, count);
    std::vector<DrawnPlace> free;
    for (std::size_t k = 0; k < count; ++k) {
        double const u = (static_cast<double>(k / whorl) + 0.5) * node;
        auto place = branch_at[k] ? model.drawn[*branch_at[k]]
                                  : DrawnPlace { 0, k % 2 == 0 ? 0.0 : 180.0, kAnywhere_deg };
        place.u = std::min(u, 1.0);
        place.keeps_u = true;
        free.push_back(place);
    }
    return arrange(free,
                   { .pattern = level_.pattern,
                     .count = count,
                     .proposals = level_.proposals,
                     .nodes = level_.nodes },
                   { .seed = options_.seed, .stream = 2, .substream = id })
        .places;
}

// True if the branch at a position keeps its end: it was drawn, or it ends in a bump and can start
// at its new base without being stretched too much or taking an angle far from the style's. Other
// branches do not end on the outline.
bool StyledBranchSetMaker::keeps_end(Parent const& parent, Model const& model,
                                     StyledPlace const& place) const
{
    constexpr double kMaxStretched = 1.5;
    constexpr double kMaxTurned_deg = 30;
    if (!place.branch)
        return false;
    double const u = place.at.u;
    auto const& branch = model.system.branches[*place.branch];
    if (branch.is_user_drawn() || branch.origin != Branch::Origin::Bump)
        return branch.is_user_drawn();
    auto const way = BranchSetMaker::similarity_to_end(branch, parent.line.at(u));
    double const size = way.turn.norm();
    double const angle_deg = angle_between_deg(parent.line.direction(u),
                                               way.vector(way_of(parent.system, *place.branch)));
    double const wanted_deg = level_.style.angle_at_deg(place.share);
    return size < kMaxStretched && 1 < kMaxStretched * size
        && std::fabs(angle_deg - wanted_deg) < kMaxTurned_deg;
}

void StyledBranchSetMaker::stand(Parent const& parent, BranchSet& branch_set, Model const& model,
                                 StyledPlace const& place)
{
    auto const& branch = place.branch;
    if (keeps_end(parent, model, place)) {
        double const as_inferred = model.drawn[*branch].u;
        double const moves_to
            = model.system.branches[*branch].is_user_drawn() ? as_inferred : place.at.u;
        BranchSetMaker::stand(branch_set, model, *branch, { as_inferred, place.at.theta_deg },
                              moves_to);
        auto const& way = branch_set.branches.back().way;
        styled_.take_angle(place.share,
                           angle_between_deg(branch_set.parent.direction(moves_to),
                                             way.vector(way_of(parent.system, *branch))));
        return;
    }
    double const angle_deg = styled_.next_angle_deg(place.share);
    auto const copied = branch ? branch : BranchSetMaker::nearest_drawn(model, place.at);
    if (!copied)
        return;
    BranchSetMaker::place_added_branch(branch_set, model, place.at, *copied,
                                       { .from = way_of(parent.system, *copied),
                                         .angle_deg = angle_deg,
                                         .smaller = BranchSetMaker::Lean::Smaller::Least });
    if (branch)
        branch_set.branches.back().name = name_of(model.system.branches[*branch]);
}

// Chord over the first part of a branch's axis (kAngleOver), from which its angle is measured, in
// the plane of its system.
Vec2 StyledBranchSetMaker::way_of(std::size_t index, std::size_t i) const
{
    auto const& system = skeleton_.systems[index];
    auto const& branch = system.branches[i];
    auto const below = skeleton_.system_of[index][i];
    auto const& model = branch.model ? system.branches[*branch.model] : branch;
    Line const line(set_maker_.line_of(model, below));
    Vec2 const way = line.at(kAngleOver) - line.at(0);
    return branch.model ? branch.from_model.vector(way) : way;
}

} // namespace tractus::silhouette
