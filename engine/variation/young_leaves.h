#pragma once

#include "engine/variation/growth_plan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tractus::variation {

// Where leaves are while what will bear them has not grown yet.
//
// A model puts leaves where the whole plant has them: on its last twigs. A plant whose leaves all
// waited for these would stand bare for most of its life, and no plant does. So every shoot bears
// leaves while it grows: of those that will be borne by it and by all that comes of it, as many as
// a twig of the whole plant has. They sit near its apex and go with it, from branch to branch,
// until they come to where they stay. Flowers and fruit wait, and so do what has no axis.
class YoungLeaves {
public:
    explicit YoungLeaves(GrowthPlan const& plan);

    // Age of the plant when an organ begins to unfold, at the latest when its segment is complete.
    double sprout(std::size_t organ) const { return sprout_[organ]; }

    // Moves those leaves of `plant`, as it is at `age`, that are not yet where they stay. A leaf
    // moves without a jump as the age changes, and from age 1 on all are in place.
    void place(Plant& plant, double age) const;

private:
    struct Leaf {
        std::uint32_t organ = 0;
        AxisId axis = 0;
        double along_mm = 0;  // Distance from the base of its axis.
        double behind_mm = 0; // How far behind an apex it sits.
    };

    void find_leaves();
    void find_sprouts();
    Vec3 point_behind_apex(Plant const& plant, Leaf const& leaf, double age) const;
    Vec3 point_on(Plant const& plant, AxisId axis, double along_mm) const;

    GrowthPlan const& plan_;
    std::vector<double> sprout_; // Per organ.
    std::vector<double> end_mm_; // Distance of each segment's end from the base of its axis.
    std::vector<Leaf> leaves_;   // Leaves in the order of organs.
    std::size_t per_shoot_ = 0;
};

} // namespace tractus::variation
