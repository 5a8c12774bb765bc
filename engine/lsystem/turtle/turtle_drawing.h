#pragma once

#include "engine/plant/plant.h"

#include <array>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <string>
#include <vector>

namespace tractus::lsystem {

// The drawing of one piece of a string, in drawing order. Segments and axes are numbered within the
// piece; plant_assembly.h assembles the pieces.
//
// A piece is attached to a segment of another piece (kBelow) or stands on the ground (kNone). Its
// gaps are branches that are left out because other pieces draw them.
struct TurtleDrawing {
    // Stands for the segment of another piece to which this piece is attached.
    static constexpr std::uint32_t kBelow = kNone - 1;

    // The place at which the next segment is attached: the end of `segment`, which belongs to
    // `axis`.
    struct Place {
        std::uint32_t segment = kNone;
        std::uint32_t axis = kNone;
        // True: the next segment continues the axis. False: it begins a new axis.
        bool is_open = false;
    };

    // Where axes and segments are written if their places in the plant were counted in advance
    // (segment_plan.h). Places, organs and polygons then refer to the plant's segments and axes.
    struct Target {
        Plant* plant = nullptr; // Not owned; nullptr: axes and segments stay in the drawing.
        AxisId next_axis = 0;
        SegmentId next_segment = 0;
        // Number of segments of each axis that is still to be drawn.
        std::span<std::uint32_t const> axis_lengths {};
    };

    struct Segment {
        Vec3 tip_mm = Vec3::Zero();
        float radius_mm = 0; // Radius at the base of the segment.
        std::uint32_t axis = 0;
        std::uint32_t index = 0; // Index of the segment within the axis.
        std::uint8_t color = 0;
    };

    struct Axis {
        Vec3 base_mm = Vec3::Zero();
        std::uint32_t parent_segment = kNone;
        std::uint32_t segment_count = 0;
        float tip_radius_mm = 0;
    };

    // Shape of an organ: a shape that the view defines for a letter, or one of the turtle's own.
    struct ShapeKey {
        OrganShape::Kind kind = OrganShape::Kind::Blade;
        char letter = 0;        // Letter after ~; 0 for a shape of the turtle's own.
        std::uint8_t color = 0; // Colour of a ball, disc or surface.
        // For a surface made by the turtle, its number in `patches`, counted from 1; otherwise 0.
        std::uint32_t patch = 0;

        auto operator<=>(ShapeKey const&) const = default;
    };

    // A branch that another piece draws. It comes after the axes, organs and polygons counted here.
    struct Gap {
        std::size_t piece = 0;
        std::size_t axis_count = 0;
        std::size_t organ_count = 0;
        std::size_t polygon_count = 0;
    };

    // Cross-section of an axis at a node where it is not round. Contours are numbered in the order
    // of the view.
    struct AxisSection {
        std::uint32_t axis = 0;
        std::uint32_t node = 0;
        NodeSection section;
    };

    struct Warning {
        std::size_t module = 0; // Index in the string of the module that caused the warning.
        std::string text;
    };

    std::pmr::vector<Segment> segments;
    std::pmr::vector<Axis> axes;
    std::pmr::vector<Organ> organs; // Organs; each organ's shape is an index into shape_keys.
    std::vector<ShapeKey> shape_keys;
    std::pmr::vector<Polygon> polygons; // Polygons; each polygon's material is a turtle colour.
    std::pmr::vector<Vec3> polygon_vertices_mm;
    // For each turtle colour, whether segments or polygons have it.
    std::array<bool, 256> has_color {};
    std::vector<BezierPatch> patches {};
    std::vector<AxisSection> sections {};
    std::vector<Gap> gaps;
    std::vector<Warning> warnings;
    Target target {};

    // Returns a copy whose large arrays are allocated from `memory`.
    TurtleDrawing copy(std::pmr::memory_resource& memory) const;
    // Discards the drawing but keeps its memory.
    void clear();

    // Returns the size in bytes of the arrays that grow with the length of the string.
    std::size_t byte_size() const
    {
        return segments.size() * sizeof(Segment) + axes.size() * sizeof(Axis)
            + organs.size() * sizeof(Organ) + polygons.size() * sizeof(Polygon)
            + polygon_vertices_mm.size() * sizeof(Vec3) + patches.size() * sizeof(BezierPatch)
            + sections.size() * sizeof(AxisSection) + warnings.size() * sizeof(Warning);
    }
    std::size_t part_count() const { return segments.size() + organs.size() + polygons.size(); }

    // Draws a segment from `base_mm`, attached at `place`, and moves `place` to its end. Inlined,
    // so that places can be kept in registers.
    [[gnu::always_inline]] void add_segment(Place& place, Vec3 const& base_mm, Vec3 const& tip_mm,
                                            float radius_mm, std::uint8_t color)
    {
        has_color[color] = true;
        if (target.plant)
            return write_segment(place, base_mm, tip_mm, radius_mm, color);
        if (!place.is_open) {
            place.is_open = true;
            place.axis = static_cast<std::uint32_t>(axes.size());
            axes.push_back({ base_mm, place.segment, 0, 0 });
        }
        auto& axis = axes[place.axis];
        axis.tip_radius_mm = radius_mm;
        place.segment = static_cast<std::uint32_t>(segments.size());
        segments.push_back({ tip_mm, radius_mm, place.axis, axis.segment_count++, color });
    }

    // Sets the radius at the present end of the axis at `place`.
    void set_tip_radius(Place const& place, float radius_mm)
    {
        if (!place.is_open)
            return;
        if (target.plant)
            target.plant->node_radius_mm[place.segment + place.axis + 1] = radius_mm;
        else
            axes[place.axis].tip_radius_mm = radius_mm;
    }

    // Adds a polygon that moves with `segment`. Does nothing if it has fewer than three vertices.
    void add_polygon(std::vector<Vec3> const& vertices_mm, std::uint32_t segment,
                     std::uint8_t color);

    // Returns the index of a shape in shape_keys, and adds the shape if it is new.
    OrganShapeId shape(ShapeKey const& key);

private:
    // Writes a segment to the plant. The segments of an axis are consecutive, and each axis has one
    // more node than segments. The index of a segment's first node is therefore the sum of the
    // segment's and the axis's index.
    [[gnu::always_inline]] void write_segment(Place& place, Vec3 const& base_mm, Vec3 const& tip_mm,
                                              float radius_mm, std::uint8_t color)
    {
        auto& plant = *target.plant;
        auto segment = place.segment + 1;
        if (!place.is_open) {
            segment = target.next_segment;
            place.axis = begin_axis(place.segment, place.axis, base_mm);
            place.is_open = true;
        }
        auto const node = segment + place.axis;
        plant.node_radius_mm[node] = radius_mm;
        plant.node_radius_mm[node + 1] = radius_mm;
        plant.node_position_mm[node + 1] = tip_mm;
        plant.segment_material[segment] = color;
        place.segment = segment;
    }
    AxisId begin_axis(SegmentId parent_segment, AxisId parent_axis, Vec3 const& base_mm);
};

} // namespace tractus::lsystem
