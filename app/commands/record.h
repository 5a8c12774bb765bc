#pragma once

#include "app/options/action.h"
#include "app/tools/tool_kind.h"

namespace tractus::commands {

// `tools` are the tools that a script of the simulated hand may name; empty: any name is accepted.
void add_record_command(CLI::App& root, options::Action& action, tools::ToolKinds tools);

} // namespace tractus::commands
