#pragma once

#include "engine/lsystem/language/program.h"

#include <string_view>

namespace tractus::lsystem {

// A function that is one instruction.
struct FunctionEntry {
    std::string_view name;
    Op op;
    int parameter_count;
};

// nullptr for other names.
FunctionEntry const* find_function(std::string_view name);

// A function of cpfg's that we do not carry out: it has this value instead.
struct MissingFunction {
    enum class About {
        Files,  // A model from anywhere must not read or change its reader's files.
        Window, // cpfg's: where it looks, its animation, its sounds.
        Blobs,  // Implicit surfaces.
    };
    enum class Value { Given, FirstArgument }; // As cpfg, which leaves some arguments in place.

    std::string_view name;
    About about = About::Files;
    double value = 0;
    Value which = Value::Given;
};

// The name of a function, or of a statement with a condition, that `name` was perhaps meant to be;
// empty if none is near.
std::string_view nearest_function(std::string_view name);

// nullptr for other names.
MissingFunction const* find_missing_function(std::string_view name);

} // namespace tractus::lsystem
