#pragma once

#include "engine/base/result.h"
#include "engine/methods/silhouettes/crown_surface.h"
#include "engine/methods/silhouettes/outlined_tree.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <vector>

namespace tractus::silhouette {

// The space inside the crown of a tree that was drawn by its outline, in the plant's frame.
class CrownVolume {
public:
    // `skeleton` and `scale` are those of one tree (skeleton_of(), OutlinedTree::scale).
    CrownVolume(Skeleton const& skeleton, double scale);

    bool holds(Vec3 const& plant_mm) const;

    // A box around the volume, computed from the crown surface's sections at 36 azimuths.
    Bounds const& box_mm() const { return box_mm_; }

private:
    Vec3 to_sheet(Vec3 const& plant_mm) const;

    double scale_;
    Vec2 foot_; // Foot of the trunk on the sheet.
    CrownSurface surface_;
    Bounds box_mm_;
};

// The crown of a tree. Fails with a user error if the tree has no outline or is a single leaf, and
// like skeleton_of().
Result<CrownVolume> crown_volume(OutlinedTree const& tree);

// A ball in the plant's frame, in millimetres.
struct CrownBall {
    Vec3 centre_mm = Vec3::Zero();
    double radius_mm = 0;
};

// Balls that together fill a volume. They reach out of the volume by at most 2 % of the box's
// longest side, and the gaps that they leave in it are at most 4 % wide. Ordered from the widest to
// the narrowest.
std::vector<CrownBall> fill_with_balls(CrownVolume const& volume);

// Axis keys of the trunk and of the branches that were drawn, in the plant that build_tree() makes
// of the tree. Fails like skeleton_of().
Result<std::vector<std::uint32_t>> drawn_axes(OutlinedTree const& tree);

} // namespace tractus::silhouette
