#pragma once

#include "engine/base/result.h"

#include <CLI/CLI.hpp>
#include <functional>

namespace tractus::options {

// The action that the command line selects. The parser of a command sets it, and main() runs it. An
// error is printed as one line on standard error, with exit code 1.
using Action = std::function<Result<void>()>;

} // namespace tractus::options
