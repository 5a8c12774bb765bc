#pragma once

#include "app/tools/tool_kind.h"
#include "app/verbs/verb.h"

namespace tractus {

// `tools`: those that a script of the simulated hand may use; none: any word.
void add_record_verb(CLI::App& root, Action& action, ToolKinds tools);

} // namespace tractus
