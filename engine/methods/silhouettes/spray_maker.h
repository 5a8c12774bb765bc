#pragma once

#include "engine/base/random.h"
#include "engine/methods/silhouettes/branch_space.h"
#include "engine/methods/silhouettes/tree.h"

#include <cstddef>
#include <vector>

namespace tractus::silhouette {

// What twigs with leaves stand on: an axis of the tree that is there already.
struct SprayBearer {
    Space const& space; // Of its plane.
    Line const& line;
    std::vector<Vec2> const& crown; // Twigs end in it; empty: they are as long as usual.
    AxisId axis = kNone;
};

// Adds twigs with leaves to a tree. What it is given must outlive it.
class SprayMaker {
public:
    SprayMaker(Tree& tree, TreeOptions const& options)
        : tree_(tree)
        , options_(options)
    {
    }

    // What they stay inside of, where it was drawn. It must outlive this.
    void stay_inside(SurfaceFit const& surface) { surface_ = &surface; }

    // Adds the shapes that twigs have, before all others: twigs are of the plant's first material,
    // their leaves of its second.
    void add_shapes();

    // Twigs of about one length, whatever bears them: more on a longer parent, from the share
    // `from` of its length on. `places`: of the parent's nodes, shares of its length.
    void add(SprayBearer const& parent, std::vector<double> const& places, double from);

private:
    struct SprayPlace {
        SprayBearer const& parent;
        std::size_t segment;
        Vec2 at;
        Vec2 along;
    };
    struct SprayWay {
        double lean;
        double around;
        double length; // In the plane's unit.
    };

    void add(SprayPlace const& place, SprayWay const& way, Random& random);

    Tree& tree_;
    TreeOptions const& options_;
    SurfaceFit const* surface_ = nullptr; // Null: none was drawn.
};

} // namespace tractus::silhouette
