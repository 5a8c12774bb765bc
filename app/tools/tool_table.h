#pragma once

#include "app/tools/tool.h"

#include <string>

namespace tractus::tools {

// Lines for a terminal: its word and those that may stand behind it, "draw [descendants|both]", its
// key, and what it does.
std::string describe_tool(ToolKind const& kind);

// The manual's table of all tools, a line each: what a recording calls it, its words, the key that
// takes it in hand, what it does.
std::string manual_table(ToolKinds kinds);

} // namespace tractus::tools
