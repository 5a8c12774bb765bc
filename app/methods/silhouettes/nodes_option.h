#pragma once

#include "app/tools/tool_options.h"

namespace tractus::silhouette {

// Whether branches of one node stay together (TreeForm::has_whole_nodes) in trees that a tool
// begins or reshapes. New trees use Whole; logs from before this option existed lack it and get
// AsAtFirst.
enum class NodesOption { AsAtFirst, Whole };

// How new trees, or those that a tool reshapes, fill an outline with few bumps
// (TreeForm::plane_branches). New trees use BySpacing; logs from before this option existed lack it
// and get AsAtFirst.
enum class FillsOption { AsAtFirst, BySpacing };

// Visit the options, which exist only in logs and have no buttons.
void visit_nodes(tools::OptionVisitor& visitor, NodesOption& nodes);
void visit_fills(tools::OptionVisitor& visitor, FillsOption& fills);

} // namespace tractus::silhouette
