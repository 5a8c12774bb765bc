#pragma once

#include "app/tools/tool_kind.h"
#include "engine/base/result.h"
#include "engine/stroke/stroke.h"

#include <map>
#include <string>
#include <string_view>

namespace tractus::tools {

// How far a stroke has to get for each kind of tool to mean anything, mm on the desk: by the kinds'
// words. A kind that is not named has no least extent. Greatest value: kGreatestLeastExtent_mm.
//
// A log's line "least", with words such as "draw=6", says which are in force from there on; before
// it there are none, as in logs that were made before there was such a line.
using LeastExtents = std::map<std::string, double, std::less<>>;
constexpr double kGreatestLeastExtent_mm = 100;
constexpr std::string_view kLeastExtentsLine = "least";

// As the kinds themselves say (ToolKind::least_extent_mm).
LeastExtents usual_least_extents(ToolKinds kinds);

// "draw=6 indicate=5", as a log's line says it; parse_least_extents() reads it. Kinds that are not
// among `kinds` are kept: another program may know them.
std::string print_least_extents(LeastExtents const& extents);

// Fails, as the user's fault, for a word that is no "TOOL=MM" or a number outside the range.
Result<LeastExtents> parse_least_extents(std::string_view words);

// Zero where there is none.
double least_extent_mm(LeastExtents const& extents, ToolKind const& kind);

// The greatest distance of any tip from the first one: how far the hand got, mm. Zero for a stroke
// without tips.
double extent_mm(Stroke const& stroke);

// What is said of a stroke that got less far.
std::string describe_dab(ToolKind const& kind, double least_mm);

} // namespace tractus::tools
