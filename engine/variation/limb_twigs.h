#pragma once

#include "engine/variation/limb.h"
#include "engine/variation/limb_pattern.h"

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace tractus::variation {

// Copies the twigs and organs at the nodes of a limb's pattern to the limb. The copies keep their
// pitch, so that they hang, rise or lie level as on the pattern; their heading follows the limb.
class LimbTwigs {
public:
    // `scale`: factor on the size of twigs and organs. `plant` and `rest` must outlive the object.
    LimbTwigs(Plant const& plant, RestShape const& rest, AxisId pattern, double scale);

    // A node of the limb's own axis.
    struct Place {
        SegmentId segment = 0; // The limb's segment that ends at the node.
        Quat frame = Quat::Identity();
    };

    // Appends the twigs and organs of a node to `limb`, whose first axis is the limb itself.
    void add(Plant& limb, Place const& place, LimbNode const& node);

private:
    // Transform that moves twigs and organs from a node of the pattern to a node of the limb.
    struct Move {
        Vec3 from_mm = Vec3::Zero();
        Vec3 to_mm = Vec3::Zero();
        Quat turn = Quat::Identity();
        double scale = 1;

        Vec3 place(Vec3 const& point_mm) const;
    };

    // Attachments at a node of the pattern: its twigs with all their descendant axes, and the
    // numbers of the organs and polygons at the node or on these axes.
    struct NodeAttachments {
        std::vector<AxisId> axes;
        std::vector<std::size_t> organs;
        std::vector<std::size_t> polygons;
    };

    // Copy of an axis at the node of the limb that was handled last.
    struct Copy {
        AxisId axis = 0;
        Move move {};
    };

    Move upright_move(Move const& rigid, Vec3 const& direction, SegmentId node) const;
    Vec3 start_of_twig(AxisId id) const;
    void add_twig(Plant& limb, AxisId id, Move const& move);
    void add_organ(Plant& limb, Organ organ, Move const& move) const;
    void add_polygon(Plant& limb, Polygon polygon, Move const& move) const;
    Move const& move_of(SegmentId segment, Move const& at_node) const;

    Plant const& plant_;
    RestShape const& rest_;
    AxisId pattern_;
    double scale_;
    // Attachments at the end of each segment of the pattern.
    std::unordered_map<SegmentId, NodeAttachments> borne_;
    // Copies of segments and axes at the node that was handled last, by their numbers in the plant.
    std::unordered_map<SegmentId, SegmentId> segments_;
    std::unordered_map<AxisId, Copy> axes_;
};

// Appends the cross-section of a node of `plant`, rotated by `turn`, to `limb`; does nothing if
// `plant` has only round sections.
void add_turned_section(Plant& limb, Plant const& plant, NodeId node, Quat const& turn);

} // namespace tractus::variation
