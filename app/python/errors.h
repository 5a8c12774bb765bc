#pragma once

#include "app/document/model_cost.h"
#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <pybind11/pybind11.h>
#include <type_traits>
#include <utility>

namespace tractus::python {

// An error on its way to Python, where it becomes tractus.Error with the same sentence.
struct Failure {
    Error error;
};

// Throws the error of a failed call. If Ctrl-C was pressed meanwhile, it throws KeyboardInterrupt
// instead. Must be called with the GIL held.
[[noreturn]] void throw_error(Error error);

// Returns the value of a result, or throws its error. Must be called with the GIL held.
template<typename T> T value_of(Result<T> result)
{
    if (!result)
        throw_error(std::move(result).error());
    if constexpr (!std::is_void_v<T>)
        return *std::move(result);
}

// Runs work that does not touch Python, while other Python threads run.
template<typename Work> auto without_gil(Work const& work)
{
    pybind11::gil_scoped_release const released;
    return work();
}

// Throws a user error unless a value is within a range.
void check_range(char const* name, double value, double least, double most);

// Limits of a model's cost, as Python gives them.
struct CostLimits {
    std::size_t max_modules = document::ModelCost().max_modules;
    std::optional<std::uint64_t> max_memory_mb {};
    double max_seconds = document::ModelCost().max_seconds;
};

// Returns the limits, with a check that stops the model when Ctrl-C is pressed.
document::ModelCost interruptible(CostLimits const& limits = {});

// Adds tractus.Error to the module.
void add_errors(pybind11::module_& module);

} // namespace tractus::python
