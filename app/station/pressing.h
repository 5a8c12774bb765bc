#pragma once

#include "app/tools/tool.h"

namespace tractus::station {

// Pseudo-tool of a touch that operates the window's controls and draws nothing. Logs record this
// state like a tool, but users cannot select it.
tools::Tool const& pressing();

} // namespace tractus::station
