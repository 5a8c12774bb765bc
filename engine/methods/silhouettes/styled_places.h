#pragma once

#include "engine/methods/silhouettes/arrangement.h"
#include "engine/methods/silhouettes/branch_style.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tractus::silhouette {

// Says of parent after parent of one level where its children stand, so that all of them together
// have the style: what one parent lacks, since branches are whole ones or its crown leaves no room,
// the next ones make up for.
class StyledPlaces {
public:
    // The stream of random numbers is `level`'s own.
    StyledPlaces(BranchStyle const& style, Pattern pattern, std::uint64_t seed,
                 std::uint32_t level);

    // Whether the next parent bears any children.
    bool next_bears();

    struct Parent {
        double low = 0;           // A share of its length: no child stands below.
        std::size_t least = 0;    // It has so many children, whatever the style says.
        std::uint32_t number = 0; // For its random numbers.
    };
    // Shares of the next parent's length, ascending; those of a node are equal. At least one.
    //
    // Distances on a single parent (the trunk) are as uneven as the style says. On one of many they
    // are more uneven than that by up to three fifths, on average by a fifth: the deviation of all
    // distances together is kept, and since a crown has room for less different parents than those
    // of the style were, the distances on each make up for it. That is no chance: where all m gaps
    // together have the coefficient of variation c and the parents' mean gaps v, the gaps on one
    // have sqrt((1 + c^2) / (1 + v^2) - 1).
    std::vector<double> next(Parent const& parent);

    // The angle of the next branch at a share of the way from its parent's first child to its last;
    // and one that has an angle of its own there.
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
    double count_phase_ = 0; // Shares of a turn, at which sequences begin.
    double angle_phase_ = 0;
    double extent_phase_ = 0;
    std::size_t counted_ = 0;
    std::size_t angled_ = 0;
    double bearing_ = 0; // What is left over from the parents before.
    double count_left_ = 0;
    double first_left_ = 0;
    double angle_left_deg_ = 0;
    double extent_left_ = 0;
    double squares_left_ = 0; // Of distances.
};

// For each of some places in ascending order one of others in ascending order, of which there are
// as many at least: an own one, in the same order, such that they are near (least squares). Taking
// one of the others may cost more, as much as such a square; none: nothing.
std::vector<std::size_t> nearest_in_order(std::vector<double> const& places,
                                          std::vector<double> const& others,
                                          std::vector<double> const& costs = {});

} // namespace tractus::silhouette
