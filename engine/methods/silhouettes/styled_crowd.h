#pragma once

#include "engine/methods/silhouettes/crowd.h"
#include "engine/methods/silhouettes/styled_places.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::silhouette {

// Spreads the branches of parents of one level such that all of them together have its style. What
// it is given must outlive it.
class StyledCrowdMaker {
public:
    StyledCrowdMaker(CrowdMaker const& crowds, Skeleton const& skeleton, TreeOptions const& options,
                     std::uint32_t level);

    struct Parent {
        std::size_t system = 0; // Whose trunk it is.
        bool is_trunk = false;  // The tree's.
        Line const& line;
        std::uint32_t number = 0; // For its random numbers.
    };
    // The next parent's; no value: it bears none.
    std::optional<Crowd> next(Parent const& parent);

private:
    using Model = CrowdMaker::Model;

    // One of the places that a style gives.
    struct StyledPlace {
        std::optional<std::size_t> branch; // In the plane, that takes it; no value: one is added.
        Place at;
        double share; // Of the way from the parent's first place to its last.
    };

    static std::vector<std::size_t> kept_branches(BranchingSystem const& system,
                                                  std::vector<DrawnPlace> const& drawn,
                                                  std::size_t most);
    std::vector<Place> arrangement(Model const& model,
                                   std::vector<std::optional<std::size_t>> const& branch_at,
                                   std::uint32_t id) const;
    bool keeps_end(Parent const& parent, Model const& model, StyledPlace const& place) const;
    void stand(Parent const& parent, Crowd& crowd, Model const& model, StyledPlace const& place);
    Vec2 way_of(std::size_t index, std::size_t i) const;

    CrowdMaker const& crowds_;
    Skeleton const& skeleton_;
    TreeOptions const& options_;
    LevelOptions const& level_;
    StyledPlaces styled_;
};

} // namespace tractus::silhouette
