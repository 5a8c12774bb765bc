#pragma once

#include "engine/lsystem/language/program.h"

#include <string_view>

namespace tractus::lsystem {

// A built-in function that compiles to a single instruction.
struct FunctionEntry {
    std::string_view name;
    Op op;
    int parameter_count;
};

// Finds a built-in function by its name; nullptr if there is none.
FunctionEntry const* find_function(std::string_view name);

// A function of cpfg that is not supported here: calls of it have a fixed value instead.
struct MissingFunction {
    enum class About {
        Files,  // File access: a model of unknown origin must not read or change the user's files.
        Window, // Functions of cpfg's window: its viewpoint, animation and sounds.
        Blobs,  // Functions of implicit surfaces.
    };
    // Value of a call: `value` or, as in cpfg for some functions, the first argument.
    enum class Value { Given, FirstArgument };

    std::string_view name;
    About about = About::Files;
    double value = 0;
    Value which = Value::Given;
};

// Returns the function or statement keyword that `name` is probably a misspelling of; empty if none
// is similar.
std::string_view nearest_function(std::string_view name);

// Finds an unsupported function by its name; nullptr if there is none.
MissingFunction const* find_missing_function(std::string_view name);

} // namespace tractus::lsystem
