#pragma once

#include "app/tools/tool.h"

namespace tractus::station {

// Pseudo-tool of a touch that operates the window's controls and draws nothing. Logs record such a
// touch as a change of tool, but users cannot select this tool.
tools::Tool const& pressing();

} // namespace tractus::station
