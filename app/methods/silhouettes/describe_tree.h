#pragma once

#include "app/tools/tool.h"

#include <string>

namespace tractus::silhouette {

// Message for the user after a stroke of the outline tool: the parts of the active tree, and what
// its drawing still lacks. Empty if the active plant was not drawn by its outline.
std::string describe_tree(tools::Tool const& tool, scene::Scene const& after);

} // namespace tractus::silhouette
