#pragma once

#include "app/tools/tool_options.h"

namespace tractus::silhouette {

// Whether the branches of a node stay together (TreeForm::has_whole_nodes) in trees that a tool
// begins or reshapes. The tools now use Whole. Logs that are older than this option lack it and
// mean AsAtFirst.
enum class NodesOption { AsAtFirst, Whole };

// How an outline with few bumps is filled with branches (TreeForm::plane_branches) in trees that a
// tool begins or reshapes, and whether its leaves fill it as seen (TreeForm::leaves_reach_outline).
// ToOutline is BySpacing with leaves that fill the outline. BySpecies is ToOutline with branches
// that leave the trunk at the angles of the species (TreeForm::bases_by_angle); the outline tool
// now uses it, and the tool for crowns in space BySpacing. Logs that are older than this option
// lack it and mean AsAtFirst.
enum class FillsOption { AsAtFirst, BySpacing, ToOutline, BySpecies };

// Visit the two options, which have no buttons and are for logs only.
void visit_nodes(tools::OptionVisitor& visitor, NodesOption& nodes);
void visit_fills(tools::OptionVisitor& visitor, FillsOption& fills);

} // namespace tractus::silhouette
