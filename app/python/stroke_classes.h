#pragma once

#include <pybind11/pybind11.h>

namespace tractus::python {

// Adds Stroke, Recording, replay() and read_rig() to the module.
void add_stroke_classes(pybind11::module_& module);

} // namespace tractus::python
