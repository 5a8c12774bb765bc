#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::sketch {

// Previews the plant that grows along an unfinished stroke, as a skeleton. If it has very many
// internodes the deepest forks are left out.
std::unique_ptr<tools::StrokePreviewer> sketch_previewer();

} // namespace tractus::sketch
