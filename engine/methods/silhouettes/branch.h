#pragma once

#include "engine/methods/silhouettes/bumps.h"
#include "engine/methods/silhouettes/plane.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::silhouette {

// On which side of its parent, seen from the parent's base to its tip, a branch stands.
enum class Side { Left, Right };

inline double sign_of(Side side)
{
    return side == Side::Left ? 1 : -1;
}

// The angle between a parent and its branches by the place t, 0 base to 1 tip: linear between the
// samples (Wither 2009, the branching angle function). At first low branches lie and high ones
// rise.
class BranchingAngles {
public:
    struct Sample {
        double t = 0;
        double angle_deg = 0;
    };

    BranchingAngles(); // 80 degrees at the base, 35 at the tip.
    // In any order; at least one. Angles are those of the way over a share of the branch; 0: at its
    // very base.
    explicit BranchingAngles(std::vector<Sample> samples, double over = 0);

    double at_deg(double t) const;
    // Takes the angle of a branch that was drawn; one within 0.05 of its place goes.
    void learn(Sample const& sample);
    std::vector<Sample> const& samples() const { return samples_; }
    double over() const { return over_; }

private:
    std::vector<Sample> samples_;
    double over_ = 0;
};

// A branch that stands on a sample of a trunk.
struct BranchCurve {
    Cubic curve {};
    std::size_t trunk_sample = 0;
    double t = 0;             // The sample's place along the trunk.
    double length = 0;        // Of sixteen chords of it.
    double tangent_share = 0; // Of the curve's tangents, as shares of the way from base to end.
    Side side = Side::Left;
    double outside = 0; // How far it leaves the outline.
};

// Where a branch has to end and how it arrives there.
struct BranchEnd {
    Vec2 end = Vec2::Zero();
    Vec2 tangent = Vec2::UnitY(); // Length 1.
};

// A trunk's samples and those that may bear branches; the outline that branches stay in.
struct BranchSearch {
    std::span<Vec2 const> trunk; // At least two, at equal distances.
    Run bases;
    std::span<Vec2 const> outline {}; // None: branches may go anywhere.
    BranchingAngles const& angles;
};

// The way from a branch's base to a share of its length.
Vec2 way_over(Cubic const& curve, double share);

// The branch from one sample; tangents are `share` of the way from there to the end.
BranchCurve branch_from(BranchSearch const& search, std::size_t sample, BranchEnd const& to,
                        double share = 0.5);

// The shortest of the branches from all bases (Wither 2009), of those that leave the outline by at
// most 1 % of its diagonal. Where there is none, its tangents become longer; where there is none
// then, the one that leaves the outline least.
BranchCurve infer_branch(BranchSearch const& search, BranchEnd const& to);

// A branch as a stroke has it that begins near the trunk: from the nearest of the bases to the
// stroke's end, its tangents such that it is nearest to the stroke's points (least squares).
BranchCurve drawn_branch(BranchSearch const& search, std::span<Vec2 const> stroke);

// Full opening of the cone around a branch of length `distance` in which its crown lies: 20 degrees
// for a bump without radius, 110 for one whose radius is the distance or more.
double cone_angle_deg(double radius, double distance);

// The crown of a branch that ends in no bump: a lens around its outer part, counter-clockwise.
std::vector<Vec2> lens_around(Cubic const& branch);

// The outline of a branch's own crown, counter-clockwise: the bump's samples in the cone at the
// branch's base, and two curves that close it to there.
std::vector<Vec2> crown_of(std::span<Vec2 const> outline, Bump const& bump, Cubic const& branch);

} // namespace tractus::silhouette
