#pragma once

#include "engine/plant/plant.h"

#include <memory>
#include <pybind11/pybind11.h>
#include <string>

namespace tractus::python {

// A plant as Python holds it. Its arrays share the plant.
struct PlantHandle {
    std::shared_ptr<Plant const> plant;
    std::string name;
};

// Adds Plant, OrganShape and WrittenFile to the module.
void add_plant_class(pybind11::module_& module);

} // namespace tractus::python
