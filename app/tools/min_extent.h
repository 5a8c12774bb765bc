#pragma once

#include "app/tools/tool_kind.h"
#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <map>
#include <string>
#include <string_view>

namespace tractus::tools {

// Minimum extents of strokes by the word of the tool's kind, in mm on the desk; a shorter stroke
// has no effect. Kinds not listed have no minimum. No extent exceeds kMaxMinExtent_mm. A line
// "least" in a log, with words such as "draw=6", sets the extents for the strokes after it; without
// such a line, strokes of a log have no minimum.
using MinExtents = std::map<std::string, double, std::less<>>;
constexpr double kMaxMinExtent_mm = 100;
constexpr std::string_view kMinExtentsLine = "least";

// Default minimum extents of the kinds (ToolKind::min_extent_mm).
MinExtents usual_min_extents(ToolKinds kinds);

// Formats extents for a log: "draw=6 indicate=5". The inverse is parse_min_extents().
std::string print_min_extents(MinExtents const& extents);

// Parses the output of print_min_extents(). Words of kinds that this program does not know are
// kept. Fails with a user error for a word that is not "TOOL=MM" or a number out of range.
Result<MinExtents> parse_min_extents(std::string_view words);

// Minimum extent of strokes drawn with this kind of tool, or 0 if there is none.
double min_extent_mm(MinExtents const& extents, ToolKind const& kind);

// Extent of a stroke: the greatest distance of any tip from the first one, in mm. Zero for a stroke
// without tips.
double extent_mm(Stroke const& stroke);

// Message for the user about a stroke that was shorter than `min_mm`.
std::string describe_dab(ToolKind const& kind, double min_mm);

} // namespace tractus::tools
