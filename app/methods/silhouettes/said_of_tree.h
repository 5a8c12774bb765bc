#pragma once

#include "app/tools/tool.h"

#include <string>

namespace tractus::silhouette {

// What the tree that takes what is drawn has after a stroke with the tool that draws it, and what
// it still wants; empty: it was not drawn by its outline.
std::string said_of_tree(tools::Tool const& tool, scene::Scene const& after);

} // namespace tractus::silhouette
