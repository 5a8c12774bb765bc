#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::lines {

// Creates a preview of the plant as the unfinished line changes it, be it a construction line or a
// line of a leaf. The preview shows stems as a skeleton, drawn leaves by their edges and midribs,
// and other organs by lines from base to tip. In each layer it shows at most 60 nodes.
std::unique_ptr<tools::StrokePreviewer> line_previewer();

} // namespace tractus::lines
