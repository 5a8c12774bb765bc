#pragma once

#include "engine/methods/self_organising/grown_tree.h"
#include "engine/methods/self_organising/tree_plant.h"

#include <cstdint>
#include <vector>

namespace tractus::self_organising {

// The growth of a tree as a film, from its beginning through all years of its life. Between whole
// years the shoots of the coming year lengthen evenly.
class TreeFilm {
public:
    // Fails like grow_tree().
    static Result<TreeFilm> make(GrownTree const& tree, scene::LoadOptions const& options = {});

    // Number of years that the tree grows; at least 1.
    int years() const { return static_cast<int>(trees_.size()) - 1; }

    // The plant at an age from 0 to years(). At a whole number of years it is the plant after that
    // many years, including branches that die later.
    Plant plant_at(double age) const;

    // The fully grown plant, for shape_at(). It has every leaf that its branches ever bore, at full
    // size, including leaves that have fallen.
    Plant const& whole() const { return whole_.plant; }

    // Gives `plant`, a copy of whole(), its shape at an age. Parts that have not grown yet get a
    // length, width and size of 0, and so do fallen leaves. Branches that die later are left out.
    // As the age rises, no internode becomes shorter or thinner, unless it was cut.
    void shape_at(double age, Plant& plant) const;

private:
    TreeFilm(GrownTree const& tree, std::vector<GrowingTree> trees);

    void place_leaves(double age, std::vector<Vec3> const& directions, Plant& plant) const;
    double leaf_size(std::size_t node, double age) const;

    Habit habit_;
    std::uint64_t seed_;
    std::vector<GrowingTree> trees_; // The tree at its beginning and after each year.
    TreePlant whole_;
    // number_in_[year][node] is the index, in the tree of that year, of the last tree's node
    // `node`; kNone if the node has not grown yet.
    std::vector<std::vector<std::uint32_t>> number_in_;
    std::vector<std::vector<double>> diameters_; // Node diameters of each year's tree.
    std::vector<std::uint32_t> leaf_node_;       // For each leaf, its node in the last tree.
};

} // namespace tractus::self_organising
