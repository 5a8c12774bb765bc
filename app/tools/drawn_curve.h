#pragma once

#include "engine/base/vectors.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tractus::tools {

// A curve that the user drew and from which a plant was made, for a list and a view of such curves.
struct DrawnCurve {
    // Number of the edit that drew the curve; lists of curves are in the order of these numbers. 0:
    // unknown; such curves come first.
    std::uint64_t edit = 0;
    // Name for the user: the tool's label and the curve's role, such as "Line: left boundary".
    std::string name {};
    std::vector<Vec3f> points_mm {}; // Points of the curve, at least two; world frame.
    enum class End { Plain, Arrow } end = End::Plain;
};

// Returns the curves of one kind that the plant's state keeps, in the order in which they were
// drawn. Curves whose tips cannot be read are left out. Each method has a function of this type for
// its own curves. Strokes that shape branches need none: they are listed separately.
using ListDrawnCurves = std::vector<DrawnCurve> (*)(scene::BuiltPlant const& plant);

using DrawnCurveLists = std::span<ListDrawnCurves const>;

} // namespace tractus::tools
