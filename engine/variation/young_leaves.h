#pragma once

#include "engine/variation/growth_plan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tractus::variation {

// Places leaves of a young plant while the twigs that will carry them have not grown yet.
//
// A model has leaves where the full-grown plant has them: on its last twigs. If all leaves waited
// for those twigs, the plant would be bare for most of its life. So every shoot carries leaves
// while it grows, about as many as a twig of the whole plant, chosen from those that the shoot and
// its descendants will carry in the end. These leaves sit near the apex and move with it, from
// branch to branch, until they reach their final position. Flowers, fruit, and organs that are not
// on an axis appear only at their final position.
class YoungLeaves {
public:
    explicit YoungLeaves(GrowthPlan const& plan);

    // Age of the plant at which an organ begins to unfold, at the latest when its segment is
    // complete.
    double sprout(std::size_t organ) const { return sprout_[organ]; }

    // Moves the leaves of `plant`, which has the age `age`, to where they are at that age.
    // Positions change continuously with the age; at age 1 all leaves are at their final positions.
    void place(Plant& plant, double age) const;

private:
    struct Leaf {
        std::uint32_t organ = 0;
        AxisId axis = 0;
        double along_mm = 0; // Final distance of the leaf from the base of its axis.
        // Distance of the leaf from the apex of a growing shoot, towards its base.
        double behind_mm = 0;
    };

    void find_leaves();
    void find_sprouts();
    Vec3 point_behind_apex(Plant const& plant, Leaf const& leaf, double age) const;
    Vec3 point_on(Plant const& plant, AxisId axis, double along_mm) const;

    GrowthPlan const& plan_;
    std::vector<double> sprout_; // Age of the plant when each organ begins to unfold.
    std::vector<double> end_mm_; // Distance of each segment's end from the base of its axis.
    std::vector<Leaf> leaves_;   // All leaves, in the order of the plant's organs.
    std::size_t per_shoot_ = 0;
};

} // namespace tractus::variation
