#pragma once

#include "engine/methods/silhouettes/branch_set.h"
#include "engine/methods/silhouettes/styled_places.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::silhouette {

// Places the branches of all parents of one level so that together they match the level's style.
// The constructor arguments must outlive this object.
class StyledBranchSetMaker {
public:
    StyledBranchSetMaker(BranchSetMaker const& branch_sets, Skeleton const& skeleton,
                         TreeOptions const& options, std::uint32_t level);

    struct Parent {
        std::size_t system = 0; // Index of the system whose trunk is the parent.
        bool is_trunk = false;  // True if the parent is the tree's trunk.
        Line const& line;
        std::uint32_t number = 0; // Number of the parent, which selects its random numbers.
    };
    // Places the branches of the next parent; no value if it has none.
    std::optional<BranchSet> next(Parent const& parent);

private:
    using Model = BranchSetMaker::Model;

    // One of the positions that the style gives for branches on a parent.
    struct StyledPlace {
        // Index of the visible branch that takes this position; no value: a branch is added.
        std::optional<std::size_t> branch;
        Place at;
        double share; // Share of the distance from the parent's first position to its last.
    };

    static std::vector<std::size_t> kept_branches(BranchingSystem const& system,
                                                  std::vector<DrawnPlace> const& drawn,
                                                  std::size_t most);
    std::vector<Place> arrangement(Model const& model,
                                   std::vector<std::optional<std::size_t>> const& branch_at,
                                   std::uint32_t id) const;
    bool keeps_end(Parent const& parent, Model const& model, StyledPlace const& place) const;
    void stand(Parent const& parent, BranchSet& branch_set, Model const& model,
               StyledPlace const& place);
    Vec2 way_of(std::size_t index, std::size_t i) const;

    BranchSetMaker const& set_maker_;
    Skeleton const& skeleton_;
    TreeOptions const& options_;
    LevelOptions const& level_;
    StyledPlaces styled_;
};

} // namespace tractus::silhouette
