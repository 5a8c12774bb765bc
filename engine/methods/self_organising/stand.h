#pragma once

#include "engine/methods/self_organising/brush.h"
#include "engine/methods/self_organising/grown_tree.h"
#include "engine/scene/document_state.h"

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace tractus::self_organising {

// Trees that grow beside each other for some years and shade each other. In each year every tree is
// shaded by the others' buds as they were at the year's beginning, so the trees' order does not
// matter. A neighbour's bud casts as much shade on a tree as the tree's own buds do. Other plants
// of the document shade, too, but do not grow: each cell of a tree's light grid that contains their
// wood counts as one bud. Immutable except for a cache; thread-safe.
class Stand {
public:
    struct Member {
        GrownTree tree {};                // The tree and its life before the years in the stand.
        Vec3 stands_at_mm = Vec3::Zero(); // Position of the tree's base, world frame.
    };
    struct Place {
        std::vector<Member> members {};
        // Other plants, which shade the members but do not grow; not null.
        std::vector<std::shared_ptr<scene::PlantState const>> others {};
        double scale = 0.1; // World millimetres per plant millimetre.
        int years = 1;
    };

    explicit Stand(Place place);

    Place const& place() const { return place_; }

    // Grows all members and returns the one with index `number`. `on_year` receives that tree at
    // its beginning and after each year. Fails like grow_tree(), and if one of the other plants
    // cannot be built.
    Result<GrowingTree> grow_member(std::size_t number, scene::LoadOptions const& options,
                                    YearCallback const& on_year = {}) const;

private:
    Result<std::vector<GrowingTree>> grow(std::size_t watched, scene::LoadOptions const& options,
                                          YearCallback const& on_year) const;

    Result<std::vector<std::vector<Vec3>>>
    points_of_others(scene::LoadOptions const& options) const;

    Place place_;
    // `waiting_` keeps members that grew when another member was requested, until they are
    // requested themselves. A document builds all of its trees, so each member grows only once.
    mutable std::mutex mutex_;
    mutable std::vector<std::unique_ptr<GrowingTree>> waiting_;
    // Cached result of points_of_others(), which has to build each of the other plants.
    mutable std::optional<std::vector<std::vector<Vec3>>> still_;
};

} // namespace tractus::self_organising
