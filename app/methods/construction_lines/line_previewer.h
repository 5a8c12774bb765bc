#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::lines {

// The plant that follows the line under way, of itself or of its leaves: its stem as a skeleton,
// drawn leaves by their sides and midribs, and other organs as lines from their feet to their tips.
// Of layers with more nodes than can be told apart some are left out.
std::unique_ptr<tools::StrokePreviewer> line_previewer();

} // namespace tractus::lines
