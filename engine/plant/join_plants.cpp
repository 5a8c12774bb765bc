#include "engine/plant/join_plants.h"

#include <cstddef>

namespace tractus {

namespace {

// Difference between the numbers of what is added and those in its own plant.
struct Shift {
    explicit Shift(Plant const& plant)
        : axis(static_cast<AxisId>(plant.axes.size()))
        , node(static_cast<NodeId>(plant.node_position_mm.size()))
        , segment(static_cast<SegmentId>(plant.segment_count()))
        , vertex(static_cast<std::uint32_t>(plant.polygon_vertices_mm.size()))
        , material(static_cast<MaterialId>(plant.materials.size()))
        , shape(static_cast<OrganShapeId>(plant.organ_shapes.size()))
        , contour(static_cast<ContourId>(plant.contours.size()))
    {
    }

    AxisId axis;
    NodeId node;
    SegmentId segment;
    std::uint32_t vertex;
    MaterialId material;
    OrganShapeId shape;
    ContourId contour;
};

std::uint32_t shifted(std::uint32_t number, std::uint32_t by)
{
    return number == kNone ? kNone : number + by;
}

ContourId shifted(ContourId number, ContourId by)
{
    return number == kNoContour ? kNoContour : static_cast<ContourId>(number + by);
}

void append_axes(Plant& plant, Plant const& other, Shift const& shift, Vec3 const& moved_mm)
{
    for (auto axis : other.axes) {
        axis.first_node += shift.node;
        axis.first_segment += shift.segment;
        axis.parent_segment = shifted(axis.parent_segment, shift.segment);
        axis.parent_axis = shifted(axis.parent_axis, shift.axis);
        plant.axes.push_back(axis);
    }
    for (auto const& node_mm : other.node_position_mm)
        plant.node_position_mm.push_back(node_mm + moved_mm);
    plant.node_radius_mm.insert(plant.node_radius_mm.end(), other.node_radius_mm.begin(),
                                other.node_radius_mm.end());
    for (auto const material : other.segment_material)
        plant.segment_material.push_back(static_cast<MaterialId>(material + shift.material));
}

void append_organs(Plant& plant, Plant const& other, Shift const& shift, Vec3 const& moved_mm)
{
    for (auto organ : other.organs) {
        organ.shape = static_cast<OrganShapeId>(organ.shape + shift.shape);
        organ.segment = shifted(organ.segment, shift.segment);
        organ.position_mm += moved_mm;
        plant.organs.push_back(organ);
    }
    for (auto polygon : other.polygons) {
        polygon.first_vertex += shift.vertex;
        polygon.segment = shifted(polygon.segment, shift.segment);
        polygon.material = static_cast<MaterialId>(polygon.material + shift.material);
        plant.polygons.push_back(polygon);
    }
    for (auto const& vertex_mm : other.polygon_vertices_mm)
        plant.polygon_vertices_mm.push_back(vertex_mm + moved_mm);
    for (auto shape : other.organ_shapes) {
        shape.material = static_cast<MaterialId>(shape.material + shift.material);
        plant.organ_shapes.push_back(std::move(shape));
    }
}

// A plant without sections has round ones.
void append_sections(Plant& plant, Plant const& other, Shift const& shift)
{
    if (plant.node_section.empty() && other.node_section.empty())
        return;
    plant.contours.insert(plant.contours.end(), other.contours.begin(), other.contours.end());
    plant.node_section.resize(shift.node);
    for (auto section : other.node_section) {
        section.contour = shifted(section.contour, shift.contour);
        section.next_contour = shifted(section.next_contour, shift.contour);
        plant.node_section.push_back(section);
    }
    plant.node_section.resize(plant.node_position_mm.size());
}

} // namespace

void append_plant(Plant& plant, Plant const& other, Vec3 const& moved_mm)
{
    Shift const shift(plant);
    append_axes(plant, other, shift, moved_mm);
    append_organs(plant, other, shift, moved_mm);
    append_sections(plant, other, shift);
    plant.materials.insert(plant.materials.end(), other.materials.begin(), other.materials.end());
}

} // namespace tractus
