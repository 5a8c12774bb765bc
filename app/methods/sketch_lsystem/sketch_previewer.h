#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::sketch {

// Creates a preview of the plant that grows along an unfinished stroke, as a skeleton. If the plant
// has more than 4000 internodes, the preview leaves out the deepest forks.
std::unique_ptr<tools::StrokePreviewer> sketch_previewer();

} // namespace tractus::sketch
