#include "engine/lsystem/plant_builder.h"

#include <algorithm>

namespace tractus {

PlantBuilder::PlantBuilder(View const& view, double unit_mm)
    : view_(view)
    , unit_mm_(unit_mm)
{
    plant_.materials.emplace_back(); // Bark, for colours that the view does not define.
}

void PlantBuilder::add_segment(Place& place, Segment const& segment)
{
    if (place.axis == kNone) {
        BuiltAxis axis;
        axis.base_mm = segment.base_mm;
        axis.parent_segment = place.segment;
        place.axis = static_cast<std::uint32_t>(axes_.size());
        axes_.push_back(axis);
    }
    auto& axis = axes_[place.axis];
    axis.tip_radius_mm = segment.radius_mm;
    place.segment = static_cast<std::uint32_t>(segment_axis_.size());
    segment_axis_.push_back(place.axis);
    segment_index_.push_back(axis.segment_count++);
    segment_tip_mm_.push_back(segment.tip_mm);
    segment_radius_mm_.push_back(segment.radius_mm);
    segment_material_.push_back(segment.material);
}

void PlantBuilder::set_tip_radius(Place const& place, float radius_mm)
{
    if (place.axis != kNone)
        axes_[place.axis].tip_radius_mm = radius_mm;
}

void PlantBuilder::add_polygon(std::vector<Vec3> const& vertices_mm, std::uint32_t segment,
                               MaterialId material)
{
    if (vertices_mm.size() < 3)
        return;
    Polygon polygon;
    polygon.first_vertex = static_cast<std::uint32_t>(plant_.polygon_vertices_mm.size());
    polygon.vertex_count = static_cast<std::uint32_t>(vertices_mm.size());
    polygon.segment = segment;
    polygon.material = material;
    plant_.polygons.push_back(polygon);
    plant_.polygon_vertices_mm.insert(plant_.polygon_vertices_mm.end(), vertices_mm.begin(),
                                      vertices_mm.end());
}

MaterialId PlantBuilder::material(int color)
{
    auto const found = materials_.find(color);
    if (found != materials_.end())
        return found->second;
    MaterialId id = 0;
    if (auto const defined = view_.materials.find(color); defined != view_.materials.end()) {
        id = static_cast<MaterialId>(plant_.materials.size());
        plant_.materials.push_back(defined->second);
    }
    materials_.emplace(color, id);
    return id;
}

OrganShapeId PlantBuilder::add_shape(OrganShape shape)
{
    shape.length_mm *= unit_mm_;
    shape.width_mm *= unit_mm_;
    shape.petiole_mm *= unit_mm_;
    plant_.organ_shapes.push_back(std::move(shape));
    return static_cast<OrganShapeId>(plant_.organ_shapes.size() - 1);
}

bool PlantBuilder::is_defined(char letter) const
{
    return std::any_of(view_.organs.begin(), view_.organs.end(),
                       [&](auto const& organ) { return organ.letter == letter; });
}

OrganShapeId PlantBuilder::organ_shape(char letter)
{
    auto const found = shapes_.find(letter);
    if (found != shapes_.end())
        return found->second;
    OrganShape shape;
    auto const defined = std::find_if(view_.organs.begin(), view_.organs.end(),
                                      [&](auto const& organ) { return organ.letter == letter; });
    if (defined != view_.organs.end()) {
        shape = defined->shape;
        shape.material = material(shape.material);
    } else {
        shape.name = std::string("leaf ") + letter;
        shape.length_mm = 1;
        shape.width_mm = 0.5;
        shape.material = static_cast<MaterialId>(plant_.materials.size());
        Material leaf;
        leaf.name = shape.name;
        leaf.kind = Material::Kind::Leaf;
        leaf.base_color = { 0.30f, 0.48f, 0.17f };
        leaf.translucency = 0.4f;
        plant_.materials.push_back(leaf);
    }
    auto const id = add_shape(std::move(shape));
    shapes_.emplace(letter, id);
    return id;
}

OrganShapeId PlantBuilder::round_shape(OrganShape::Kind kind, int color)
{
    auto const surface = material(color);
    auto const found = round_shapes_.find({ kind, surface });
    if (found != round_shapes_.end())
        return found->second;
    OrganShape shape;
    shape.name = kind == OrganShape::Kind::Ball ? "ball" : "disc";
    shape.kind = kind;
    shape.material = surface;
    shape.length_mm = 1;
    shape.width_mm = 1;
    auto const id = add_shape(std::move(shape));
    round_shapes_.emplace(std::pair(kind, surface), id);
    return id;
}

// Axes in the order in which they were begun, so that parents come first.
void PlantBuilder::place_axes(std::vector<SegmentId> const& new_ids)
{
    NodeId node = 0;
    SegmentId segment = 0;
    for (auto const& built : axes_) {
        Axis axis;
        axis.first_node = node;
        axis.first_segment = segment;
        axis.segment_count = built.segment_count;
        if (built.parent_segment != kNone) {
            axis.parent_axis = segment_axis_[built.parent_segment];
            axis.parent_segment = new_ids[built.parent_segment];
            axis.order = plant_.axes[axis.parent_axis].order + 1;
        }
        plant_.node_position_mm[node] = built.base_mm;
        plant_.node_radius_mm[node + built.segment_count] = built.tip_radius_mm;
        node += built.segment_count + 1;
        segment += built.segment_count;
        plant_.axes.push_back(axis);
    }
}

Plant PlantBuilder::finish()
{
    auto const count = segment_count();
    std::vector<SegmentId> first_segment(axes_.size());
    for (std::size_t i = 1; i < axes_.size(); ++i)
        first_segment[i] = first_segment[i - 1] + axes_[i - 1].segment_count;
    std::vector<SegmentId> new_ids(count);
    for (std::size_t i = 0; i < count; ++i)
        new_ids[i] = first_segment[segment_axis_[i]] + segment_index_[i];

    plant_.axes.reserve(axes_.size());
    plant_.node_position_mm.resize(count + axes_.size());
    plant_.node_radius_mm.resize(count + axes_.size());
    plant_.segment_material.resize(count);
    place_axes(new_ids);
    for (std::size_t i = 0; i < count; ++i) {
        auto const base = plant_.axes[segment_axis_[i]].first_node + segment_index_[i];
        plant_.node_radius_mm[base] = segment_radius_mm_[i];
        plant_.node_position_mm[base + 1] = segment_tip_mm_[i];
        plant_.segment_material[new_ids[i]] = segment_material_[i];
    }
    for (auto& organ : plant_.organs)
        if (organ.segment != kNone)
            organ.segment = new_ids[organ.segment];
    for (auto& polygon : plant_.polygons)
        if (polygon.segment != kNone)
            polygon.segment = new_ids[polygon.segment];
    return std::move(plant_);
}

} // namespace tractus
