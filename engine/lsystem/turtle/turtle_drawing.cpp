#include "engine/lsystem/turtle/turtle_drawing.h"

#include "engine/base/check.h"

#include <algorithm>

namespace tractus::lsystem {

TurtleDrawing TurtleDrawing::copy(std::pmr::memory_resource& memory) const
{
    return { { segments, &memory },
             { axes, &memory },
             { organs, &memory },
             shape_keys,
             { polygons, &memory },
             { polygon_vertices_mm, &memory },
             has_color,
             patches,
             sections,
             gaps,
             warnings };
}

void TurtleDrawing::clear()
{
    segments.clear();
    axes.clear();
    organs.clear();
    shape_keys.clear();
    polygons.clear();
    polygon_vertices_mm.clear();
    has_color.fill(false);
    patches.clear();
    sections.clear();
    gaps.clear();
    warnings.clear();
    target = {};
}

void TurtleDrawing::add_polygon(std::vector<Vec3> const& vertices_mm, std::uint32_t segment,
                                std::uint8_t color)
{
    if (vertices_mm.size() < 3)
        return;
    Polygon polygon;
    polygon.first_vertex = static_cast<std::uint32_t>(polygon_vertices_mm.size());
    polygon.vertex_count = static_cast<std::uint32_t>(vertices_mm.size());
    polygon.segment = segment;
    polygon.material = color;
    polygons.push_back(polygon);
    polygon_vertices_mm.insert(polygon_vertices_mm.end(), vertices_mm.begin(), vertices_mm.end());
    has_color[color] = true;
}

AxisId TurtleDrawing::begin_axis(SegmentId parent_segment, AxisId parent_axis, Vec3 const& base_mm)
{
    CHECK(!target.axis_lengths.empty());
    auto& plant = *target.plant;
    auto const id = target.next_axis++;
    auto& axis = plant.axes[id];
    axis.first_segment = target.next_segment;
    axis.first_node = target.next_segment + id;
    axis.segment_count = target.axis_lengths.front();
    axis.parent_segment = parent_segment;
    if (parent_segment != kNone) {
        axis.parent_axis = parent_axis;
        axis.order = plant.axes[parent_axis].order + 1;
    }
    plant.node_position_mm[axis.first_node] = base_mm;
    target.next_segment += axis.segment_count;
    target.axis_lengths = target.axis_lengths.subspan(1);
    return id;
}

OrganShapeId TurtleDrawing::shape(ShapeKey const& key)
{
    auto const found = std::find(shape_keys.begin(), shape_keys.end(), key);
    auto const index = std::distance(shape_keys.begin(), found);
    if (found == shape_keys.end())
        shape_keys.push_back(key);
    return static_cast<OrganShapeId>(index);
}

} // namespace tractus::lsystem
