#pragma once

#include "engine/methods/silhouettes/bumps.h"
#include "engine/methods/silhouettes/plane.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::silhouette {

// The side of the parent axis that a branch is on, looking from the parent's base to its tip.
enum class Side { Left, Right };

inline double sign_of(Side side)
{
    return side == Side::Left ? 1 : -1;
}

// Branching angle as a function of the position t along the parent (0 base, 1 tip), linear between
// samples (the branching angle function of Wither 2009). By default it decreases from base to tip,
// so low branches spread and high ones are steep.
class BranchingAngles {
public:
    struct Sample {
        double t = 0;
        double angle_deg = 0;
    };

    // How the base of a branch is chosen, given its end. Nearest: such that the branch is as short
    // as possible (Wither 2009), so that most branches leave their parent almost at right angles.
    // ByAngle: such that the straight line to the end leaves the parent at the angle of its base.
    enum class Bases { Nearest, ByAngle };

    BranchingAngles(); // Default: 80 degrees at the base, 35 at the tip.
    // Makes the function from samples in any order, at least one. Angles are measured to the chord
    // over the first part of a branch; `over` is this part as a share of the branch's length, 0 for
    // the tangent at its base.
    explicit BranchingAngles(std::vector<Sample> samples, double over = 0);

    double at_deg(double t) const;
    // Adds the angle of a drawn branch and removes earlier samples within 0.05 of its t.
    void learn(Sample const& sample);
    std::vector<Sample> const& samples() const { return samples_; }
    double over() const { return over_; }

    void set_bases(Bases bases) { bases_ = bases; }
    Bases bases() const { return bases_; }

    // Weight of the parent's direction in the direction of a branch's end, if the outline does not
    // give that direction: above 0 branches rise towards their ends, below 0 they hang.
    void set_rise(double rise) { rise_ = rise; }
    double rise() const { return rise_; }
    static constexpr double kUsualRise = 0.25;

private:
    std::vector<Sample> samples_;
    double over_ = 0;
    Bases bases_ = Bases::Nearest;
    double rise_ = kUsualRise;
};

// The curve of a branch, which starts at one of the trunk's samples.
struct BranchCurve {
    Cubic curve {};
    std::size_t trunk_sample = 0;
    double t = 0;      // Position of the branch's base along the trunk, 0 to 1.
    double length = 0; // Arc length of the branch, as the sum of sixteen chords.
    // Magnitude of the curve's tangents at both ends, as a share of the chord from base to end.
    double tangent_share = 0;
    Side side = Side::Left;
    double outside = 0; // Greatest distance by which the branch leaves the outline.
};

// The end of a branch: its position and the branch's direction there.
struct BranchEnd {
    Vec2 end = Vec2::Zero();
    Vec2 tangent = Vec2::UnitY(); // Unit tangent in the branch's direction.
};

// Input of the search for a branch: the trunk's samples, the range of samples where the branch may
// start, and the outline that the branch should stay inside.
struct BranchSearch {
    std::span<Vec2 const> trunk; // Trunk samples, at least two, equally spaced.
    Run bases;
    std::span<Vec2 const> outline {}; // Outline that limits branches; empty: no limit.
    BranchingAngles const& angles;
};

// Chord from a branch's base to the point at `share` of its length.
Vec2 chord_to_share(Cubic const& curve, double share);

// The branch that starts at one sample. The magnitude of the tangents at both ends of the branch is
// `share` of the length of its chord.
BranchCurve branch_from(BranchSearch const& search, std::size_t sample, BranchEnd const& to,
                        double share = 0.5);

// The branch to an end, from that base which BranchingAngles::bases() prefers among those whose
// branch leaves the outline by at most 1 % of its diagonal: the base of the shortest branch, or the
// one at which the branch's chord fits the branching angle best. If there is none, longer tangents
// are tried; if there is still none, the result is the branch that leaves the outline least.
BranchCurve infer_branch(BranchSearch const& search, BranchEnd const& to);

// The branch drawn by a stroke that begins near the trunk: it starts at the candidate base nearest
// to the stroke's beginning and ends at the stroke's end; its tangents are fitted to the stroke's
// points by least squares.
BranchCurve drawn_branch(BranchSearch const& search, std::span<Vec2 const> stroke);

// Full opening angle, degrees, of the cone that contains the crown of a branch of length
// `distance`: 20 for a bump of radius 0, 110 when the radius reaches the distance.
double cone_angle_deg(double radius, double distance);

// Crown of a branch that does not end in a bump: a lens around its outer part, counter-clockwise.
std::vector<Vec2> lens_crown(Cubic const& branch);

// Outline of a branch's own crown, counter-clockwise: the bump's samples that lie in the cone at
// the branch's base, closed by two curves back to the base.
std::vector<Vec2> crown_of(std::span<Vec2 const> outline, Bump const& bump, Cubic const& branch);

} // namespace tractus::silhouette
