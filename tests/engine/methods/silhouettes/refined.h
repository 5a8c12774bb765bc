#pragma once

#include "engine/methods/silhouettes/skeleton.h"
#include "tests/engine/methods/silhouettes/outlines.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace tractus::silhouette {

// Returns the outline of the right limb of the oak, with lobes of its own.
inline std::vector<Vec2> limb()
{
    std::vector<Vec2> outline;
    for (int i = 0; i < 160; ++i) {
        double const angle = i * kPi / 80;
        double const r = 30 * (1 + 0.25 * std::fabs(std::sin(3.5 * angle)));
        outline.emplace_back(52 + r * std::cos(angle), -18 + 0.8 * r * std::sin(angle));
    }
    return outline;
}

inline Skeleton skeleton_of_lines(Drawing const& drawing, SkeletonOptions const& options = {})
{
    auto skeleton = infer_skeleton(drawing, options);
    EXPECT_TRUE(skeleton) << skeleton.error().message;
    return skeleton ? *std::move(skeleton) : Skeleton();
}

// Measurements of a parent branch. They share nothing with the code for styles: positions are
// lengths along the samples of the parent's line, and angles are measured between lines.
struct Seen {
    std::vector<double> places; // Positions of the children along the parent, in millimetres.
    double length = 0;
    double angle_deg = 0; // Mean branching angle of the children.
};
inline Seen seen_on(BranchingSystem const& system)
{
    auto const trunk = system.whole_trunk();
    Seen seen { .places = {}, .length = length_of(trunk) };
    for (auto const& branch : system.branches) {
        if (branch.origin == Branch::Origin::Apex)
            continue;
        std::size_t nearest = 0;
        for (std::size_t k = 1; k < trunk.size(); ++k)
            if ((trunk[k] - branch.path.curve.base).norm()
                < (trunk[nearest] - branch.path.curve.base).norm())
                nearest = k;
        seen.places.push_back(length_of(std::span(trunk).first(nearest + 1)));
        auto const low = std::max<std::size_t>(nearest, 1) - 1;
        Vec2 const along = trunk[std::min(nearest + 1, trunk.size() - 1)] - trunk[low];
        Vec2 const out = chord_to_share(branch.path.curve, kAngleOver);
        seen.angle_deg += degrees(std::fabs(std::atan2(cross(along, out), along.dot(out))));
    }
    seen.angle_deg /= static_cast<double>(std::max<std::size_t>(seen.places.size(), 1));
    std::sort(seen.places.begin(), seen.places.end());
    return seen;
}

} // namespace tractus::silhouette
