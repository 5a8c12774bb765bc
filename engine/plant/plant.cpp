#include "engine/plant/plant.h"

#include "engine/base/check.h"
#include "engine/stroke/polyline.h"

#include <algorithm>

namespace tractus {

bool has_contour(Plant const& plant, Axis const& axis)
{
    if (plant.node_section.empty())
        return false;
    auto const first = plant.node_section.begin() + axis.first_node;
    return std::any_of(first, first + axis.segment_count + 1,
                       [](NodeSection const& section) { return !section.is_round(); });
}

AxisId axis_of(Plant const& plant, SegmentId segment)
{
    auto const after = std::upper_bound(
        plant.axes.begin(), plant.axes.end(), segment,
        [](SegmentId value, Axis const& axis) { return value < axis.first_segment; });
    CHECK(after != plant.axes.begin());
    return static_cast<AxisId>(after - plant.axes.begin() - 1);
}

SegmentNodes nodes_of(Plant const& plant, SegmentId segment)
{
    auto const& axis = plant.axes[axis_of(plant, segment)];
    NodeId const base = axis.first_node + (segment - axis.first_segment);
    return { base, base + 1 };
}

SegmentId parent_segment(Plant const& plant, SegmentId segment)
{
    auto const& axis = plant.axes[axis_of(plant, segment)];
    return segment == axis.first_segment ? axis.parent_segment : segment - 1;
}

double axis_length_mm(Plant const& plant, Axis const& axis)
{
    return polyline_length_mm(plant.positions(axis));
}

void Bounds::add(Vec3 const& point)
{
    min_mm = min_mm.cwiseMin(point);
    max_mm = max_mm.cwiseMax(point);
}

Bounds bounds(Plant const& plant)
{
    Bounds box;
    for (auto const& position : plant.node_position_mm)
        box.add(position);
    for (auto const& organ : plant.organs)
        box.add(organ.position_mm);
    for (auto const& vertex : plant.polygon_vertices_mm)
        box.add(vertex);
    return box;
}

static void check_axes(Plant const& plant)
{
    NodeId next_node = 0;
    SegmentId next_segment = 0;
    for (AxisId id = 0; id < plant.axes.size(); ++id) {
        auto const& axis = plant.axes[id];
        CHECK(axis.segment_count >= 1);
        CHECK(axis.first_node == next_node);
        CHECK(axis.first_segment == next_segment);
        CHECK((axis.parent_segment == kNone) == (axis.parent_axis == kNone));
        if (axis.parent_axis != kNone) {
            CHECK(axis.parent_axis < id);
            auto const& parent = plant.axes[axis.parent_axis];
            CHECK(axis.parent_segment >= parent.first_segment);
            CHECK(axis.parent_segment - parent.first_segment < parent.segment_count);
        }
        next_node += axis.segment_count + 1;
        next_segment += axis.segment_count;
    }
    CHECK(next_node == plant.node_position_mm.size());
    CHECK(next_node == plant.node_radius_mm.size());
    CHECK(next_segment == plant.segment_material.size());
}

static void check_sections(Plant const& plant)
{
    for (auto const& contour : plant.contours) {
        CHECK(contour.points.size() == Contour::kSteps + 1);
        for (auto const& point : contour.points)
            CHECK(point.allFinite());
    }
    CHECK(plant.node_section.empty() || plant.node_section.size() == plant.node_position_mm.size());
    for (auto const& section : plant.node_section) {
        CHECK(section.contour == kNoContour || section.contour < plant.contours.size());
        CHECK(section.next_contour == kNoContour || section.next_contour < plant.contours.size());
        CHECK(section.share >= 0 && section.share <= 1);
        CHECK(section.normal.allFinite());
        CHECK(section.sides >= 3);
    }
}

static void check_cut(CutLeaf const& leaf)
{
    for (auto const& corner : leaf.corners)
        CHECK(corner.allFinite());
    for (auto const& triangle : leaf.triangles)
        for (auto const corner : triangle)
            CHECK(corner < leaf.corners.size());
}

void check_plant(Plant const& plant)
{
    check_axes(plant);
    check_sections(plant);
    for (auto const& position : plant.node_position_mm)
        CHECK(position.allFinite());
    for (auto const radius_mm : plant.node_radius_mm)
        CHECK(radius_mm >= 0 && radius_mm < std::numeric_limits<float>::infinity());
    for (auto const material : plant.segment_material)
        CHECK(material < plant.materials.size());
    for (auto const& shape : plant.organ_shapes) {
        CHECK(shape.material < plant.materials.size());
        for (auto const& patch : shape.patches) {
            for (auto const& point : patch.control)
                CHECK(point.allFinite());
            for (auto const neighbor : patch.neighbors)
                CHECK(neighbor == BezierPatch::kNoPatch || neighbor < shape.patches.size());
        }
        if (shape.cut)
            check_cut(*shape.cut);
    }
    for (auto const& organ : plant.organs) {
        CHECK(organ.shape < plant.organ_shapes.size());
        CHECK(organ.segment == kNone || organ.segment < plant.segment_count());
        CHECK(organ.position_mm.allFinite() && organ.scale.allFinite());
        CHECK(organ.orientation.coeffs().allFinite());
    }
    for (auto const& polygon : plant.polygons) {
        CHECK(polygon.vertex_count >= 3);
        CHECK(polygon.material < plant.materials.size());
        CHECK(polygon.segment == kNone || polygon.segment < plant.segment_count());
        CHECK(polygon.first_vertex + polygon.vertex_count <= plant.polygon_vertices_mm.size());
    }
}

} // namespace tractus
