#include "app/batch/plant_format.h"
#include "app/files/resources.h"
#include "app/methods/all_habits.h"
#include "app/python/errors.h"
#include "app/python/mesh_classes.h"
#include "app/python/model_classes.h"
#include "app/python/plant_class.h"
#include "app/python/scene_class.h"
#include "app/python/stroke_classes.h"
#include "engine/base/worker_threads.h"
#include "engine/variation/growth_preset.h"

#include <filesystem>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <vector>

namespace tractus::python {

static std::vector<std::string> growth_names()
{
    std::vector<std::string> names;
    for (auto const& preset : variation::growth_presets())
        names.emplace_back(preset.name);
    return names;
}

static std::filesystem::path resource_path(std::string const& name)
{
    return value_of(files::find_resource(name));
}

static void add_lists(pybind11::module_& module)
{
    module.def("model_names", &files::model_names, "The names of the program's models.");
    module.def("habit_names", &methods::habit_names,
               "The names of the program's trees that grow by themselves.");
    module.def("growth_names", &growth_names,
               "The names of the ways to grow, for load(growth=...).");
    module.def("plant_endings", &batch::plant_endings,
               "The endings of files that Plant.save() writes.");
    module.def("resource_path", &resource_path, pybind11::arg("name"),
               R"(The path of a file or folder that comes with tractus, such as "demo" or "models".

Raises Error if there is none.)");
}

} // namespace tractus::python

PYBIND11_MODULE(tractus, module)
{
    using namespace tractus::python;
    module.doc() = R"(Plants of tractus, the 3D sketching station for plants, as numpy arrays.

Lengths are in millimetres and end in _mm. Errors are tractus.Error, with the program's sentences.
Functions that take long let other threads run. Ctrl-C stops models and variants.)";
    module.attr("__version__") = TRACTUS_VERSION;
    add_errors(module);
    add_lists(module);
    add_mesh_classes(module);
    add_plant_class(module);
    add_scene_class(module);
    add_model_classes(module);
    add_stroke_classes(module);
    // Otherwise helper threads would run beside the destruction of static objects.
    pybind11::module_::import("atexit").attr("register")(
        pybind11::cpp_function(&tractus::end_worker_threads));
}
