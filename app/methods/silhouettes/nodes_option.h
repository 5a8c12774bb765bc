#pragma once

#include "app/tools/tool_options.h"

namespace tractus::silhouette {

// Whether branches of one node stay together (TreeForm::has_whole_nodes) in trees that a tool
// begins or reshapes. New trees use Whole; logs from before this option existed lack it and get
// AsAtFirst.
enum class NodesOption { AsAtFirst, Whole };

// Lists the option for logs; it has no button.
void visit_nodes(tools::OptionVisitor& visitor, NodesOption& nodes);

} // namespace tractus::silhouette
