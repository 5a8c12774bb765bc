#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::silhouette {

// Shows the branches that would follow from an outline if it were closed where the pen is.
std::unique_ptr<tools::StrokePreviewer> outline_previewer();

} // namespace tractus::silhouette
