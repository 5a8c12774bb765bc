#pragma once

#include "app/tools/stroke_previewer.h"

#include <memory>

namespace tractus::silhouette {

// Creates a preview of the branches that an outline would give if it were closed where the pen is.
std::unique_ptr<tools::StrokePreviewer> outline_previewer();

} // namespace tractus::silhouette
