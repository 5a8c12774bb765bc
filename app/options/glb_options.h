#pragma once

#include "engine/export/glb_writer.h"

#include <CLI/CLI.hpp>

namespace tractus::options {

// "--quantized", "--compressed", and "--organs HOW": how .glb files hold vertices, and leaves and
// other organs. Before a large file is written a warning says so. Returns the latter option.
CLI::Option* add_glb_options(CLI::App& command, exports::GlbOptions& options);

} // namespace tractus::options
