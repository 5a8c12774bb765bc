#pragma once

#include "app/python/plant_class.h"

#include <pybind11/numpy.h>

namespace tractus::python {

// Arrays of a plant. Those that return a copy say so; the others show the plant's own memory.

pybind11::array node_positions(PlantHandle const& handle);
pybind11::array node_radii(PlantHandle const& handle);
pybind11::array axis_records(PlantHandle const& handle);
pybind11::array organ_records(PlantHandle const& handle);
pybind11::array axis_orders(PlantHandle const& handle);
pybind11::array axis_parents(PlantHandle const& handle);
pybind11::array segment_materials(PlantHandle const& handle);

// Copies: the two nodes of each segment, and the segment below each, or -1.
pybind11::array segment_nodes(PlantHandle const& handle);
pybind11::array segment_parents(PlantHandle const& handle);
// A copy: the axis of each segment.
pybind11::array segment_axes(PlantHandle const& handle);

} // namespace tractus::python
