#pragma once

#include "app/tools/tool_options.h"

namespace tractus::silhouette {

// How the branches of a node stand in trees that tools begin, or give a form. A person begins with
// whole nodes; logs from before there were any have trees without them
// (TreeForm::has_whole_nodes).
enum class NodesOption { AsAtFirst, Whole };

// It is for logs: it has no button.
void visit_nodes(tools::OptionVisitor& visitor, NodesOption& nodes);

} // namespace tractus::silhouette
