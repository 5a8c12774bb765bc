#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::sketch {

// The plant that grows along the stroke under way, as a skeleton that grows under the pen. Of one
// with more internodes than can be told apart the deepest forks are left out.
std::unique_ptr<tools::StrokePreviewer> sketch_previewer();

} // namespace tractus::sketch
