#pragma once

#include "app/tools/methods.h"
#include "app/verbs/verb.h"

namespace tractus {

// tractus render FILE.glb -o FILE.png [--size WxH] [--azimuth DEG] [--elevation DEG]
void add_render_verb(CLI::App& root, Action& action, Methods const& methods);

} // namespace tractus
