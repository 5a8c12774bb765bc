#pragma once

#include "app/tools/tool.h"

#include <string>

namespace tractus::tools {

// Describes a tool in lines for a terminal: the kind's word with the words that may follow it,
// "draw [descendants|both]", its key, and what it does.
std::string describe_tool(ToolKind const& kind);

// The manual's table of all tools, one line each: name in recordings, words, key, and what it does.
std::string manual_table(ToolKinds kinds);

} // namespace tractus::tools
