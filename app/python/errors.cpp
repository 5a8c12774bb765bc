#include "app/python/errors.h"

#include <exception>
#include <fmt/format.h>
#include <string>

namespace tractus::python {

namespace py = pybind11;

void throw_error(Error error)
{
    if (PyErr_Occurred()) // The signal handler that interruptible() has called raised an exception.
        throw py::error_already_set();
    throw Failure { std::move(error) };
}

void check_range(char const* name, double value, double least, double most)
{
    if (!(value >= least && value <= most))
        throw_error({ Fault::User,
                      fmt::format("{} is {}: it must be {} to {}", name, value, least, most) });
}

document::ModelCost interruptible(CostLimits const& limits)
{
    document::ModelCost cost;
    cost.max_modules = limits.max_modules;
    cost.max_memory_mb = limits.max_memory_mb.value_or(cost.max_memory_mb);
    cost.max_seconds = limits.max_seconds;
    // Python handles signals only on its main thread. On any other thread this returns false.
    cost.is_stopped = [] {
        py::gil_scoped_acquire const acquired;
        return PyErr_CheckSignals() != 0;
    };
    return cost;
}

static char const* name_of(Fault fault)
{
    switch (fault) {
    case Fault::User:
        return "user";
    case Fault::Device:
        return "device";
    case Fault::Station:
        break;
    }
    return "station";
}

static void translate(std::exception_ptr thrown)
{
    try {
        if (thrown)
            std::rethrow_exception(std::move(thrown));
    } catch (Failure const& failure) {
        auto const type = py::module_::import("tractus").attr("Error");
        auto const error = type(failure.error.message);
        error.attr("fault") = name_of(failure.error.fault);
        PyErr_SetObject(type.ptr(), error.ptr());
    }
}

void add_errors(py::module_& module)
{
    constexpr char const* kDoc
        = "A refusal or failure. Its text is the sentence that the program tractus prints.\n\n"
          "`fault` says who can resolve it: \"user\" (an argument, a file or a permission is "
          "wrong), \"device\" (a recording breaks its device's own protocol) or \"station\" (a bug "
          "of tractus).";
    auto const type = py::reinterpret_steal<py::object>(
        PyErr_NewExceptionWithDoc("tractus.Error", kDoc, PyExc_RuntimeError, nullptr));
    if (!type)
        throw py::error_already_set();
    type.attr("fault") = "user";
    module.attr("Error") = type;
    py::register_local_exception_translator(translate);
}

} // namespace tractus::python
