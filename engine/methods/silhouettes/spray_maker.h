#pragma once

#include "engine/base/random.h"
#include "engine/methods/silhouettes/branch_space.h"
#include "engine/methods/silhouettes/tree.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tractus::silhouette {

// Number of different shapes of twigs with leaves; the twig without leaves is the shape after them.
constexpr std::uint32_t kSprayVariants = 8;

// Greatest and smallest length of a twig, as shares of the tree's height.
constexpr double kLongestSpray = 0.055;
constexpr double kShortestSpray = 0.016;

// Axes of a spray whose twig points along `heading` (a unit vector): x to the right, level unless
// the heading is upright, when it is `fallback`; y along the heading; z out of the upper side.
Eigen::Matrix3d spray_frame(Vec3 const& heading, Vec3 const& fallback);

// The parent axis of twigs with leaves, already part of the tree.
struct SprayParent {
    Space const& space; // Transform from the parent's plane to the plant.
    Line const& line;
    // Crown inside which twigs end; empty: they have their default length.
    std::vector<Vec2> const& crown;
    AxisId axis = kNone;
};

// Adds twigs with leaves to a tree. The constructor arguments must outlive this object.
class SprayMaker {
public:
    SprayMaker(Tree& tree, TreeOptions const& options)
        : tree_(tree)
        , options_(options)
    {
    }

    // Limits twigs to a drawn crown surface, which must outlive this object.
    void stay_inside(SurfaceFit const& surface) { surface_ = &surface; }

    // Adds the twigs' shapes; must come before all other shapes. Twigs use the plant's first
    // material, their leaves the second.
    void add_shapes();

    // Adds twigs along the part of a parent beyond the share `from` of its length. A longer parent
    // gets more twigs, not longer ones. `places`: positions of the parent's nodes as shares of its
    // length.
    void add(SprayParent const& parent, std::vector<double> const& places, double from);

private:
    struct SprayPlace {
        SprayParent const& parent;
        std::size_t segment;
        Vec2 at;
        Vec2 along;
    };
    struct TwigDirection {
        double lean;
        double around;
        double length; // Length of the twig, in the unit of the parent's plane.
    };

    void add(SprayPlace const& place, TwigDirection const& way, Random& random);

    Tree& tree_;
    TreeOptions const& options_;
    SurfaceFit const* surface_ = nullptr; // The drawn crown surface; null: not drawn.
};

} // namespace tractus::silhouette
