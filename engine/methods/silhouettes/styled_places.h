#pragma once

#include "engine/methods/silhouettes/arrangement.h"
#include "engine/methods/silhouettes/branch_style.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tractus::silhouette {

// Generates the positions of children for the parents of a level, one after the other, so that all
// together match the style. Where one parent deviates, because counts are whole numbers or its
// crown leaves no room, the following parents compensate.
class StyledPlaces {
public:
    // The random stream is specific to `level`.
    StyledPlaces(BranchStyle const& style, Pattern pattern, std::uint64_t seed,
                 std::uint32_t level);

    // True if the next parent should have children.
    bool next_has_children();

    struct Parent {
        // Share of the parent's length, from its base, that must bear no children.
        double low = 0;
        std::size_t least = 0;    // Minimum number of children, regardless of the style.
        std::uint32_t number = 0; // Number of the parent, which selects its random numbers.
    };
    // Positions of the children on the next parent, as shares of its length: ascending, at least
    // one. Children of one node have equal positions.
    //
    // On a single parent (the trunk), distances between children vary as the style says. On each of
    // many parents they vary more, by a fifth on average and three fifths at most. The standard
    // deviation of all distances together is preserved, but in a crown there is less room for
    // parents to differ than in the measured plant; larger variation on each parent compensates for
    // that. In numbers: if all distances together have the coefficient of variation c, and the
    // parents' mean distances have v, then those on one parent have sqrt((1 + c^2) / (1 + v^2) -
    // 1).
    std::vector<double> next(Parent const& parent);

    // next_angle_deg(): branching angle of the next branch, at `share` of the distance from its
    // parent's first child to its last. take_angle(): records that the branch at this position
    // keeps its own angle, so that later angles compensate for it.
    double next_angle_deg(double share);
    void take_angle(double share, double angle_deg);

private:
    std::size_t next_count(std::size_t least);
    double next_first(double low);
    double next_extent(std::size_t count, double room);
    double extent_factor() const;
    double next_unevenness(std::size_t count, std::size_t nodes, double extent);
    std::vector<double> node_scores(std::size_t nodes, std::uint32_t parent) const;

    BranchStyle style_;
    std::size_t whorl_;
    std::uint64_t seed_;
    // Starting phases of the sequences of counts, angles and extents, as shares of a turn.
    double count_phase_ = 0;
    double angle_phase_ = 0;
    double extent_phase_ = 0;
    std::size_t counted_ = 0;
    std::size_t angled_ = 0;
    // Differences between what the style requires and what earlier parents have; later parents
    // compensate for them.
    double bearing_ = 0;
    double count_left_ = 0;
    double first_left_ = 0;
    double angle_left_deg_ = 0;
    double extent_left_ = 0;
    double squares_left_ = 0; // Sum of squared distances still to be distributed.
};

// Assigns to each of `places` (ascending) a different one of `others` (ascending, at least as
// many), in the same order, with the least sum of squared distances. `costs` gives an additional
// cost for using each of `others`, in the same unit; it may be empty.
std::vector<std::size_t> nearest_in_order(std::vector<double> const& places,
                                          std::vector<double> const& others,
                                          std::vector<double> const& costs = {});

} // namespace tractus::silhouette
