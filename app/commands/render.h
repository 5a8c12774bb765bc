#pragma once

#include "app/options/action.h"
#include "app/tools/methods.h"

namespace tractus::commands {

// Command `tractus render FILE.glb -o FILE.png [--size WxH] [--azimuth DEG] [--elevation DEG]`.
void add_render_command(CLI::App& root, options::Action& action, tools::Methods const& methods);

} // namespace tractus::commands
