#pragma once

#include "engine/methods/silhouettes/branching_system.h"
#include "engine/methods/silhouettes/crowd.h"
#include "engine/methods/silhouettes/line.h"
#include "engine/methods/silhouettes/surface_fit.h"

#include <Eigen/Geometry>

namespace tractus::silhouette {

using Space = Eigen::Affine3d; // From a plane (x, y, 0) to the plant.

Space in_space(Similarity const& way);

// Millimetres of the plant to one of the plane.
double unit_of(Space const& space);

// What bears a branch: its plane, and its line in that.
struct Bearer {
    Space const& space;
    Line const& line;
};

// Where a branch stands, turned about its parent by so much of the angle that it has.
Space space_of(Bearer const& bearer, Standing const& standing, Branch const& branch,
               double share = 1);

// Likewise under a surface that was drawn. Branches on branches leave the plane in which their
// parent was fitted to it: they turn back towards that, and shrink, as far as they must.
Space space_under(SurfaceFit const& surface, Bearer const& bearer, Standing const& standing,
                  Branch const& branch);

} // namespace tractus::silhouette
