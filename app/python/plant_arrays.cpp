#include "app/python/plant_arrays.h"

#include "app/python/arrays.h"

#include <cstdint>
#include <vector>

namespace tractus::python {

namespace {

// The plant's kNone reads as -1 in signed numbers, which are otherwise the same: a plant has less
// than 2^31 of anything.
static_assert(static_cast<std::int32_t>(kNone) == -1);

// Shows a member of each axis.
pybind11::array show_of_axes(PlantHandle const& handle, char const* type,
                             std::uint32_t const& (*member)(Axis const& axis))
{
    auto const& axes = handle.plant->axes;
    static Axis const none {};
    auto const& first = axes.empty() ? none : axes.front();
    return show_array(handle.plant, pybind11::dtype(type), &member(first), { extent(axes.size()) },
                      { extent(sizeof(Axis)) });
}

} // namespace

pybind11::array node_positions(PlantHandle const& handle)
{
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    auto const& positions = handle.plant->node_position_mm;
    return show_array(handle.plant, positions.empty() ? nullptr : positions.front().data(),
                      { extent(positions.size()), 3 });
}

pybind11::array node_radii(PlantHandle const& handle)
{
    auto const& radii = handle.plant->node_radius_mm;
    return show_array(handle.plant, radii.data(), { extent(radii.size()) });
}

pybind11::array axis_records(PlantHandle const& handle)
{
    static Axis const axis {};
    auto const type
        = record_type({ { "first_node", "<u4", offset_in(axis, axis.first_node) },
                        { "first_segment", "<u4", offset_in(axis, axis.first_segment) },
                        { "segment_count", "<u4", offset_in(axis, axis.segment_count) },
                        { "parent_segment", "<i4", offset_in(axis, axis.parent_segment) },
                        { "parent_axis", "<i4", offset_in(axis, axis.parent_axis) },
                        { "order", "<u4", offset_in(axis, axis.order) } },
                      sizeof(Axis));
    auto const& axes = handle.plant->axes;
    return show_array(handle.plant, type, axes.data(), { extent(axes.size()) });
}

pybind11::array organ_records(PlantHandle const& handle)
{
    static Organ const organ {};
    auto const type
        = record_type({ { "shape", "<u2", offset_in(organ, organ.shape) },
                        { "segment", "<i4", offset_in(organ, organ.segment) },
                        { "position_mm", "(3,)<f8", offset_in(organ, organ.position_mm) },
                        { "orientation", "(4,)<f8", offset_in(organ, organ.orientation) },
                        { "scale", "(3,)<f4", offset_in(organ, organ.scale) } },
                      sizeof(Organ));
    auto const& organs = handle.plant->organs;
    return show_array(handle.plant, type, organs.data(), { extent(organs.size()) });
}

pybind11::array axis_orders(PlantHandle const& handle)
{
    return show_of_axes(handle, "<u4",
                        [](Axis const& axis) -> std::uint32_t const& { return axis.order; });
}

pybind11::array axis_parents(PlantHandle const& handle)
{
    return show_of_axes(handle, "<i4",
                        [](Axis const& axis) -> std::uint32_t const& { return axis.parent_axis; });
}

pybind11::array segment_materials(PlantHandle const& handle)
{
    auto const& materials = handle.plant->segment_material;
    return show_array(handle.plant, materials.data(), { extent(materials.size()) });
}

pybind11::array segment_nodes(PlantHandle const& handle)
{
    std::vector<std::uint32_t> nodes;
    nodes.reserve(2 * handle.plant->segment_count());
    for (auto const& axis : handle.plant->axes)
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            nodes.push_back(axis.first_node + i);
            nodes.push_back(axis.first_node + i + 1);
        }
    return take_array(std::move(nodes), { extent(handle.plant->segment_count()), 2 });
}

pybind11::array segment_parents(PlantHandle const& handle)
{
    std::vector<std::int32_t> parents;
    parents.reserve(handle.plant->segment_count());
    for (auto const& axis : handle.plant->axes)
        for (std::uint32_t i = 0; i < axis.segment_count; ++i)
            parents.push_back(static_cast<std::int32_t>(i == 0 ? axis.parent_segment
                                                               : axis.first_segment + i - 1));
    return take_array(std::move(parents), { extent(handle.plant->segment_count()) });
}

pybind11::array segment_axes(PlantHandle const& handle)
{
    std::vector<std::uint32_t> axes;
    axes.reserve(handle.plant->segment_count());
    for (std::size_t axis = 0; axis < handle.plant->axes.size(); ++axis)
        axes.insert(axes.end(), handle.plant->axes[axis].segment_count,
                    static_cast<std::uint32_t>(axis));
    return take_array(std::move(axes), { extent(handle.plant->segment_count()) });
}

} // namespace tractus::python
