#pragma once

#include "engine/lsystem/program.h"

#include <string_view>

namespace tractus {

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
    std::string_view name;
    double value = 0;
    bool is_about_files = false;
};

// nullptr for other names.
MissingFunction const* find_missing_function(std::string_view name);

} // namespace tractus
