#pragma once

#include "app/python/model_classes.h"
#include "app/python/plant_class.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <pybind11/pybind11.h>
#include <string>
#include <vector>

namespace tractus::python {

constexpr double kMaxSteps = 1e9; // Maximum number of derivation steps.

// A loaded plant, with everything that its variants need, as Python holds it.
struct SceneHandle {
    std::shared_ptr<scene::Scene const> scene;
    std::string name;
    bool is_varied = false; // True: growth varies the plant, or a session says how it grows.
    bool is_above_ground = false;
    std::vector<std::string> warnings;
};

// Returns the scene of a compiled model's plant. Throws Failure as Model.load() says.
SceneHandle scene_of_handle(ModelHandle const& model, std::optional<int> steps, std::uint64_t seed);

// Returns the plant as the command "grow" writes it. Throws Failure if all plants are hidden.
PlantHandle plant_of(SceneHandle const& scene);

// Adds Scene, load() and grow() to the module.
void add_scene_class(pybind11::module_& module);

} // namespace tractus::python
