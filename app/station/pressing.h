#pragma once

#include "app/tools/tool.h"

namespace tractus::station {

// In place of a tool: the touch presses what the window shows; it means nothing to the plant. A
// state of the station that logs say as they say tools, and none that anybody chooses.
tools::Tool const& pressing();

} // namespace tractus::station
