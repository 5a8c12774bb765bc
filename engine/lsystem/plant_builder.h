#pragma once

#include "engine/lsystem/view.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <map>
#include <vector>

namespace tractus {

// Collects a plant in the order in which a turtle draws it, where axes interleave, and puts its
// arrays into the order that Plant wants. Segments are numbered here as they are drawn.
class PlantBuilder {
public:
    PlantBuilder(View const& view, double unit_mm);

    // Where the next segment goes on: at the end of `segment`, on `axis` if that is open.
    struct Place {
        std::uint32_t segment = kNone;
        std::uint32_t axis = kNone; // kNone: the next segment begins an axis.
    };

    struct Segment {
        Vec3 base_mm = Vec3::Zero();
        Vec3 tip_mm = Vec3::Zero();
        float radius_mm = 0;
        MaterialId material = 0;
    };

    // Draws a segment at `place` and moves the place to its end.
    void add_segment(Place& place, Segment const& segment);

    // The radius at the end of the axis that `place` has reached.
    void set_tip_radius(Place const& place, float radius_mm);

    void add_organ(Organ const& organ) { plant_.organs.push_back(organ); }

    // Left out when it has fewer than three vertices.
    void add_polygon(std::vector<Vec3> const& vertices_mm, std::uint32_t segment,
                     MaterialId material);

    // The material of a turtle colour.
    MaterialId material(int color);
    // The shape that ~letter draws; a plain leaf where the view defines none (see is_defined).
    OrganShapeId organ_shape(char letter);
    bool is_defined(char letter) const;
    // A ball or disc one turtle unit across.
    OrganShapeId round_shape(OrganShape::Kind kind, int color);

    std::size_t segment_count() const { return segment_axis_.size(); }
    std::size_t part_count() const
    {
        return segment_count() + plant_.organs.size() + plant_.polygons.size();
    }

    Plant finish();

private:
    struct BuiltAxis {
        Vec3 base_mm = Vec3::Zero();
        std::uint32_t parent_segment = kNone;
        std::uint32_t segment_count = 0;
        float tip_radius_mm = 0;
    };

    OrganShapeId add_shape(OrganShape shape);
    void place_axes(std::vector<SegmentId> const& new_ids);

    View const& view_;
    double unit_mm_;
    Plant plant_; // Materials, shapes, organs and polygons; the rest comes with finish().
    std::map<int, MaterialId> materials_;
    std::map<char, OrganShapeId> shapes_;
    std::map<std::pair<OrganShape::Kind, MaterialId>, OrganShapeId> round_shapes_;
    std::vector<BuiltAxis> axes_;
    std::vector<std::uint32_t> segment_axis_; // One per segment, as are the next four.
    std::vector<std::uint32_t> segment_index_;
    std::vector<Vec3> segment_tip_mm_;
    std::vector<float> segment_radius_mm_;
    std::vector<MaterialId> segment_material_;
};

} // namespace tractus
