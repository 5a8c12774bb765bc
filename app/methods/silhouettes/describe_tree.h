#pragma once

#include "app/tools/tool.h"

#include <string>

namespace tractus::silhouette {

// Message for the user after a stroke of the outline tool: the active tree's parts, and what is
// still missing. Empty if that plant was not drawn by its outline.
std::string describe_tree(tools::Tool const& tool, scene::Scene const& after);

} // namespace tractus::silhouette
