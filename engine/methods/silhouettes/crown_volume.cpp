#include "engine/methods/silhouettes/crown_volume.h"

#include "engine/base/parallel.h"
#include "engine/methods/silhouettes/tree.h"
#include "engine/plant/branch_address.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace tractus::silhouette {

namespace {

CrownSurface surface_of_crown(Skeleton const& skeleton)
{
    auto const& tree = skeleton.systems[0];
    return skeleton.surface.empty() ? CrownSurface(tree.outline, tree.trunk)
                                    : CrownSurface(skeleton.surface, tree.trunk);
}

// A cubic lattice of points over a volume's box, each marked as inside or outside the volume.
class Lattice {
public:
    explicit Lattice(CrownVolume const& volume)
        : low_(volume.box_mm().min_mm)
    {
        constexpr double kPoints = 32; // Number of lattice steps along the box's longest side.
        Vec3 const size = volume.box_mm().max_mm - low_;
        step_ = std::max(size.maxCoeff(), 1e-6) / kPoints;
        // The lattice extends one point beyond the box on each side.
        for (std::size_t a = 0; a < 3; ++a)
            count_[a] = static_cast<std::size_t>(std::ceil(size[Eigen::Index(a)] / step_)) + 3;
        inside_.resize(count_[0] * count_[1] * count_[2]);
        parallel_for(inside_.size(), 256, [&](std::size_t begin, std::size_t end) {
            for (auto i = begin; i < end; ++i)
                inside_[i] = volume.holds(point(i)) ? 1 : 0;
        });
    }

    std::size_t size() const { return inside_.size(); }
    double step() const { return step_; }
    bool is_inside(std::size_t i) const { return inside_[i] != 0; }

    Vec3 point(std::size_t i) const
    {
        auto const x = static_cast<double>(i % count_[0]);
        auto const y = static_cast<double>(i / count_[0] % count_[1]);
        auto const z = static_cast<double>(i / count_[0] / count_[1]);
        return low_ + step_ * (Vec3(x, y, z) - Vec3::Ones());
    }

    // Lattice points outside the volume that have a neighbour inside.
    std::vector<Vec3> border() const
    {
        std::array<std::ptrdiff_t, 3> const steps { 1, std::ptrdiff_t(count_[0]),
                                                    std::ptrdiff_t(count_[0] * count_[1]) };
        std::vector<Vec3> points;
        for (std::size_t i = 0; i < size(); ++i) {
            bool is_border = false;
            for (auto const step : steps)
                for (auto const sign : { -1, 1 }) {
                    auto const at = static_cast<std::ptrdiff_t>(i) + sign * step;
                    is_border |= at >= 0 && at < std::ptrdiff_t(size())
                        && is_inside(static_cast<std::size_t>(at));
                }
            if (is_border && !is_inside(i))
                points.push_back(point(i));
        }
        return points;
    }

private:
    Vec3 low_;
    double step_ = 0;
    std::array<std::size_t, 3> count_ {};
    std::vector<char> inside_;
};

// The largest ball around each lattice point inside the volume. It ends half a lattice step before
// the nearest point outside.
std::vector<CrownBall> inner_balls(Lattice const& lattice)
{
    auto const border = lattice.border();
    std::vector<CrownBall> balls;
    for (std::size_t i = 0; i < lattice.size(); ++i)
        if (lattice.is_inside(i))
            balls.push_back({ lattice.point(i), 0 });
    parallel_for(balls.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i) {
            double nearest = std::numeric_limits<double>::infinity();
            for (auto const& point : border)
                nearest = std::min(nearest, (point - balls[i].centre_mm).squaredNorm());
            balls[i].radius_mm = std::sqrt(nearest) - 0.5 * lattice.step();
        }
    });
    return balls;
}

} // namespace

CrownVolume::CrownVolume(Skeleton const& skeleton, double scale)
    : scale_(scale)
    , foot_(skeleton.systems[0].trunk.front())
    , surface_(surface_of_crown(skeleton))
{
    constexpr int kSections = 36;
    TrunkFrame const frame(skeleton.systems[0].trunk);
    for (int i = 0; i < kSections; ++i) {
        double const theta = 2 * kPi * i / kSections;
        for (auto const& at : surface_.section(degrees(theta))) {
            Vec2 const sheet = frame.to_sheet({ at.x() * std::cos(theta), at.y() });
            Vec2 const plant = (sheet - foot_) / scale_;
            box_mm_.add({ plant.x(), at.x() * std::sin(theta) / scale_, plant.y() });
        }
    }
}

// Inverse of the transform in make_tree(); returns (x, y, distance behind the sheet).
Vec3 CrownVolume::to_sheet(Vec3 const& plant_mm) const
{
    Vec3 const at = scale_ * plant_mm;
    return { at.x() + foot_.x(), at.z() + foot_.y(), at.y() };
}

bool CrownVolume::holds(Vec3 const& plant_mm) const
{
    return surface_.holds(surface_.to_trunk(to_sheet(plant_mm)));
}

Result<CrownVolume> crown_volume(OutlinedTree const& tree)
{
    if (!tree.has_crown())
        return fail(Fault::User, "the tree has no crown that could be filled: draw its outline");
    if (tree.is_leaf)
        return fail(Fault::User,
                    "a leaf is no crown that could be filled: choose a tree with an "
                    "outline");
    return CrownVolume(TRY(skeleton_of(tree)), tree.scale);
}

std::vector<CrownBall> fill_with_balls(CrownVolume const& volume)
{
    Lattice const lattice(volume);
    auto balls = inner_balls(lattice);
    std::stable_sort(balls.begin(), balls.end(), [](CrownBall const& one, CrownBall const& other) {
        return one.radius_mm > other.radius_mm;
    });
    std::vector<CrownBall> chosen;
    for (auto const& ball : balls) {
        // A lattice point is covered if a chosen ball contains the cube around it, except for the
        // cube's corners.
        double const margin = 0.5 * lattice.step();
        bool const is_covered
            = std::any_of(chosen.begin(), chosen.end(), [&](CrownBall const& other) {
                  double const within = std::max(other.radius_mm - margin, 0.0);
                  return (other.centre_mm - ball.centre_mm).squaredNorm() <= within * within;
              });
        if (!is_covered)
            chosen.push_back(ball);
    }
    return chosen;
}

Result<std::vector<std::uint32_t>> drawn_axes(OutlinedTree const& tree)
{
    auto const skeleton = TRY(skeleton_of(tree));
    std::vector<std::uint32_t> keys { axis_key(kTrunkName) };
    for (std::size_t i = 0; i < skeleton.systems.size(); ++i)
        for (std::size_t k = 0; k < skeleton.systems[i].branches.size(); ++k)
            if (skeleton.systems[i].branches[k].is_user_drawn())
                keys.push_back(axis_key(skeleton.path_of({ i, k })));
    return keys;
}

} // namespace tractus::silhouette
