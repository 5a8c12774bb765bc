#pragma once

#include "engine/base/result.h"

#include <CLI/CLI.hpp>
#include <functional>

namespace tractus::options {

// The action that the command line selects: a command's parser sets it and main() runs it. An error
// becomes one line on standard error and exit code 1.
using Action = std::function<Result<void>()>;

} // namespace tractus::options
