#pragma once

#include "engine/methods/silhouettes/branch_set.h"
#include "engine/methods/silhouettes/branching_system.h"
#include "engine/methods/silhouettes/line.h"
#include "engine/methods/silhouettes/surface_fit.h"

#include <Eigen/Geometry>

namespace tractus::silhouette {

using Space = Eigen::Affine3d; // Transform from a drawing plane (x, y, 0) to the plant.

Space in_space(Similarity const& way);

// Scale of the transform: plant millimetres per unit of the plane.
double unit_of(Space const& space);

// The parent of a branch: the transform of its plane, and its axis in that plane.
struct ParentBranch {
    Space const& space;
    Line const& line;
};

// Transform of a placed branch. `share` scales its azimuth about the parent: 0 leaves the branch in
// the parent's plane, 1 applies the full azimuth.
Space space_of(ParentBranch const& bearer, PositionedBranch const& standing, Branch const& branch,
               double share = 1);

// Transform of a placed branch, like space_of(), but fitted into a drawn crown surface: the branch
// rotates back towards its parent's plane and shrinks about its base, as far as needed to stay
// inside. For branches of branches, whose parent is already inside.
Space space_under(SurfaceFit const& surface, ParentBranch const& bearer,
                  PositionedBranch const& standing, Branch const& branch);

} // namespace tractus::silhouette
