#pragma once

#include "engine/variation/growth_plan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tractus::variation {

// Positions of leaves while the twigs they belong to have not grown yet.
//
// A model has leaves where the full-grown plant has them: on its last twigs. If all leaves waited
// for these, the plant would be bare for most of its life. So every shoot carries leaves while it
// grows, about as many as a twig of the whole plant, chosen from those that the shoot and its
// descendants will carry in the end. They sit near its apex and move with it, from branch to
// branch, until they reach their final position. Flowers, fruit, and organs without an axis wait.
class YoungLeaves {
public:
    explicit YoungLeaves(GrowthPlan const& plan);

    // Age of the plant when an organ begins to unfold, at the latest when its segment is complete.
    double sprout(std::size_t organ) const { return sprout_[organ]; }

    // Moves the leaves of `plant`, at `age`, that are not yet at their final positions. The
    // movement is continuous in the age, and from age 1 on all are in place.
    void place(Plant& plant, double age) const;

private:
    struct Leaf {
        std::uint32_t organ = 0;
        AxisId axis = 0;
        double along_mm = 0;  // Final distance of the leaf from the base of its axis.
        double behind_mm = 0; // Distance of the leaf behind the apex of a growing shoot.
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
