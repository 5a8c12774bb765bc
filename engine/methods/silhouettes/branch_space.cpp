#include "engine/methods/silhouettes/branch_space.h"

#include <cmath>
#include <vector>

namespace tractus::silhouette {

static double size_inside(SurfaceFit const& surface, Space const& space, Branch const& branch)
{
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < branch.crown.size(); i += 3)
        places.emplace_back(space * Vec3(branch.crown[i].x(), branch.crown[i].y(), 0));
    Vec2 const base = branch.path.curve.base;
    return surface.size_inside(places, space * Vec3(base.x(), base.y(), 0));
}

Space in_space(Similarity const& way)
{
    double const flip = way.mirrors ? -1 : 1;
    Space space = Space::Identity();
    space.linear() << way.turn.x(), -flip * way.turn.y(), 0, way.turn.y(), flip * way.turn.x(), 0,
        0, 0, flip * way.turn.norm();
    Vec3 const from(way.from.x(), way.from.y(), 0);
    space.translation() = Vec3(way.to.x(), way.to.y(), 0) - space.linear() * from;
    return space;
}

double unit_of(Space const& space)
{
    return std::cbrt(std::fabs(space.linear().determinant()));
}

Space space_of(ParentBranch const& bearer, PositionedBranch const& standing, Branch const& branch,
               double share)
{
    Vec2 const base = standing.way.point(branch.path.curve.base);
    Vec2 const along = bearer.line.direction(standing.u);
    double const reference = branch.path.side == Side::Right ? 0 : 180;
    double const turn_deg = standing.theta_deg - reference;
    double const shorter_deg = turn_deg - 360 * std::round(turn_deg / 360);
    Vec3 const pivot = bearer.space * Vec3(base.x(), base.y(), 0);
    Vec3 const direction = (bearer.space.linear() * Vec3(along.x(), along.y(), 0)).normalized();
    Eigen::AngleAxisd const turn(radians(share == 1 ? turn_deg : share * shorter_deg), direction);
    Space around = Space::Identity();
    around.linear() = turn.toRotationMatrix();
    around.translation() = pivot - around.linear() * pivot;
    return around * bearer.space * in_space(standing.way);
}

Space space_under(SurfaceFit const& surface, ParentBranch const& bearer,
                  PositionedBranch const& standing, Branch const& branch)
{
    constexpr double kLarge = 0.8;
    Space best = space_of(bearer, standing, branch);
    double largest = 0;
    for (double const share : { 1.0, 0.6, 0.3, 0.1 }) {
        Space const turned_back = space_of(bearer, standing, branch, share);
        double const size = size_inside(surface, turned_back, branch);
        if (size <= largest)
            continue;
        largest = size;
        best = turned_back;
        if (largest >= kLarge)
            break;
    }
    Vec2 const base = branch.path.curve.base;
    Vec3 const pivot = best * Vec3(base.x(), base.y(), 0);
    return Eigen::Translation3d(pivot) * Eigen::Scaling(largest) * Eigen::Translation3d(-pivot)
        * best;
}

} // namespace tractus::silhouette
