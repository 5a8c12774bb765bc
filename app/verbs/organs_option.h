#pragma once

#include "engine/export/glb_writer.h"

#include <CLI/CLI.hpp>

namespace tractus {

// "--organs HOW": how .glb files hold leaves and other organs. Before a large file is written a
// warning says so.
CLI::Option* add_organs_option(CLI::App& verb, GlbOptions& options);

} // namespace tractus
