#pragma once

#include "engine/export/glb_writer.h"

#include <CLI/CLI.hpp>

namespace tractus::options {

// Adds "--quantized", "--compressed" and "--organs HOW", which select the formats of vertices,
// leaves and other organs in .glb files. The command will warn before it writes a large file.
// Returns the option --organs.
CLI::Option* add_glb_options(CLI::App& command, exports::GlbOptions& options);

} // namespace tractus::options
