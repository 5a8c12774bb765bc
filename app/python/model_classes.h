#pragma once

#include "app/python/errors.h"
#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"
#include "engine/scene/edit.h"

#include <memory>
#include <string>

namespace tractus::python {

// A model as Python holds it: its texts, and the compiled model, which its strings share.
struct ModelHandle {
    std::string name;
    scene::LoadModel edit;
    std::shared_ptr<lsystem::Model const> model;
};

// A derived string, with the model that gives its modules their meaning.
struct StringHandle {
    std::shared_ptr<lsystem::Model const> model;
    std::shared_ptr<lsystem::ModuleString const> string; // Arrays share it.
    CostLimits limits {};
};

// Adds Model and String to the module.
void add_model_classes(pybind11::module_& module);

} // namespace tractus::python
