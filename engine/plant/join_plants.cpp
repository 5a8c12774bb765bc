#include "engine/plant/join_plants.h"

#include "engine/base/check.h"

#include <cstddef>

namespace tractus {

namespace {

ContourId shifted(ContourId number, ContourId by)
{
    return number == kNoContour ? kNoContour : static_cast<ContourId>(number + by);
}

// Appends a plant to another one, for append_part().
class Joining {
public:
    Joining(Plant& plant, Plant const& part, PartPlace const& place,
            std::vector<bool> const& hidden)
        : plant_(plant)
        , part_(part)
        , place_(place)
        , hidden_(hidden)
        , shift_(place.looks.value_or(next_appearance_offsets(plant)))
        , is_turned_(place.turn.coeffs() != Quat::Identity().coeffs())
    {
        CHECK(hidden.empty() || hidden.size() == part.segment_count());
    }

    std::vector<SegmentId> join()
    {
        bool const has_sections = !plant_.node_section.empty() || !part_.node_section.empty();
        if (has_sections) // The plant's nodes get round sections if they have none yet.
            plant_.node_section.resize(plant_.node_position_mm.size());
        append_axes();
        if (has_sections)
            plant_.node_section.resize(plant_.node_position_mm.size());
        append_organs();
        append_polygons();
        if (!place_.looks)
            append_looks();
        return std::move(segments_);
    }

private:
    Vec3 placed(Vec3 const& point_mm) const
    {
        Vec3 const turned_mm = is_turned_ ? Vec3(place_.turn * point_mm) : point_mm;
        return turned_mm + place_.moved_mm;
    }

    // Counts the visible segments of an axis.
    std::uint32_t count_shown(Axis const& axis) const
    {
        if (axis.parent_segment != kNone && segments_[axis.parent_segment] == kNone)
            return 0;
        std::uint32_t count = 0;
        while (count < axis.segment_count
               && (hidden_.empty() || !hidden_[axis.first_segment + count]))
            ++count;
        return count;
    }

    void append_axes()
    {
        segments_.assign(part_.segment_count(), kNone);
        std::vector<AxisId> axes(part_.axes.size(), kNone);
        bool const on_plant = place_.on != kNone;
        AxisId const parent = on_plant ? axis_of(plant_, place_.on) : kNone;
        for (AxisId id = 0; id < part_.axes.size(); ++id) {
            auto axis = part_.axes[id];
            auto const shown = count_shown(axis);
            if (shown == 0)
                continue;
            bool const is_stem = axis.parent_segment == kNone;
            append_nodes(axis, shown + 1);
            if (on_plant && is_stem && !place_.keeps_base)
                plant_.node_position_mm[plant_.node_position_mm.size() - shown - 1]
                    = plant_.node_position_mm[nodes_of(plant_, place_.on).tip];
            auto const first = static_cast<SegmentId>(plant_.segment_material.size());
            for (std::uint32_t i = 0; i < shown; ++i) {
                segments_[axis.first_segment + i] = first + i;
                plant_.segment_material.push_back(static_cast<MaterialId>(
                    part_.segment_material[axis.first_segment + i] + shift_.material));
            }
            axes[id] = static_cast<AxisId>(plant_.axes.size());
            axis.parent_segment = is_stem ? place_.on : segments_[axis.parent_segment];
            axis.parent_axis = is_stem ? parent : axes[axis.parent_axis];
            axis.first_node = static_cast<NodeId>(plant_.node_position_mm.size() - shown - 1);
            axis.first_segment = first;
            axis.segment_count = shown;
            if (on_plant)
                axis.order += plant_.axes[parent].order + 1;
            plant_.axes.push_back(axis);
        }
    }

    void append_nodes(Axis const& axis, std::uint32_t count)
    {
        for (NodeId node = axis.first_node; node < axis.first_node + count; ++node) {
            plant_.node_position_mm.push_back(placed(part_.node_position_mm[node]));
            plant_.node_radius_mm.push_back(part_.node_radius_mm[node]);
            if (part_.node_section.empty())
                continue;
            auto section = part_.node_section[node];
            section.contour = shifted(section.contour, shift_.contour);
            section.next_contour = shifted(section.next_contour, shift_.contour);
            if (is_turned_)
                section.normal = place_.turn.cast<float>() * section.normal;
            plant_.node_section.push_back(section);
        }
    }

    // True for a visible segment, and for kNone (the ground).
    bool is_shown(SegmentId segment) const
    {
        return segment == kNone || segments_[segment] != kNone;
    }
    SegmentId segment_for(SegmentId segment) const
    {
        return segment == kNone ? place_.on : segments_[segment];
    }

    void append_organs()
    {
        for (auto organ : part_.organs) {
            if (!is_shown(organ.segment))
                continue;
            organ.shape = static_cast<OrganShapeId>(organ.shape + shift_.shape);
            organ.segment = segment_for(organ.segment);
            organ.position_mm = placed(organ.position_mm);
            if (is_turned_)
                organ.orientation = place_.turn * organ.orientation;
            plant_.organs.push_back(organ);
        }
    }

    void append_polygons()
    {
        for (auto polygon : part_.polygons) {
            if (!is_shown(polygon.segment))
                continue;
            auto const first = static_cast<std::uint32_t>(plant_.polygon_vertices_mm.size());
            for (std::uint32_t i = 0; i < polygon.vertex_count; ++i)
                plant_.polygon_vertices_mm.push_back(
                    placed(part_.polygon_vertices_mm[polygon.first_vertex + i]));
            polygon.first_vertex = first;
            polygon.segment = segment_for(polygon.segment);
            polygon.material = static_cast<MaterialId>(polygon.material + shift_.material);
            plant_.polygons.push_back(polygon);
        }
    }

    void append_looks()
    {
        if (plant_.root_flare.ridges == 0)
            plant_.root_flare = part_.root_flare;
        for (auto shape : part_.organ_shapes) {
            shape.material = static_cast<MaterialId>(shape.material + shift_.material);
            plant_.organ_shapes.push_back(std::move(shape));
        }
        plant_.materials.insert(plant_.materials.end(), part_.materials.begin(),
                                part_.materials.end());
        if (!plant_.node_section.empty())
            plant_.contours.insert(plant_.contours.end(), part_.contours.begin(),
                                   part_.contours.end());
    }

    Plant& plant_;
    Plant const& part_;
    PartPlace const& place_;
    std::vector<bool> const& hidden_;
    // Offsets to add to the part's numbers of materials, shapes and contours.
    AppearanceOffsets shift_;
    bool is_turned_;
    // For each segment of the part, its number in the whole plant, or kNone.
    std::vector<SegmentId> segments_;
};

} // namespace

AppearanceOffsets next_appearance_offsets(Plant const& plant)
{
    return { static_cast<MaterialId>(plant.materials.size()),
             static_cast<OrganShapeId>(plant.organ_shapes.size()),
             static_cast<ContourId>(plant.contours.size()) };
}

void append_plant(Plant& plant, Plant const& other, Vec3 const& moved_mm)
{
    append_part(plant, other, { .moved_mm = moved_mm });
}

std::vector<SegmentId> append_part(Plant& plant, Plant const& part, PartPlace const& place,
                                   std::vector<bool> const& hidden)
{
    return Joining(plant, part, place, hidden).join();
}

} // namespace tractus
