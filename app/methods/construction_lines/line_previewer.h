#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::lines {

// Previews the plant as changed by the unfinished line, whether a construction line or a line of a
// leaf. It shows stems as a skeleton, drawn leaves by their edges and midribs, and other organs as
// lines from base to tip. Of layers with very many nodes only some nodes are shown.
std::unique_ptr<tools::StrokePreviewer> line_previewer();

} // namespace tractus::lines
