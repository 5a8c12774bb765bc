#pragma once

#include "engine/base/vectors.h"
#include "engine/scene/scene.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tractus::tools {

// A curve that the user drew and that a plant is made of, for a list and a view of such curves.
struct DrawnCurve {
    // Number of the edit that drew it, by which curves are ordered; 0, before all others, for
    // curves whose edit is not known.
    std::uint64_t edit = 0;
    // What it did, for the user: the tool's label and what the curve is, "Line: left boundary".
    std::string name {};
    std::vector<Vec3f> points_mm {}; // World frame; at least two.
    enum class End { Plain, Arrow } end = End::Plain;
};

// Returns the curves of one kind that the plant's state keeps, in the order in which they were
// drawn. Curves whose tips cannot be read are left out. Each method has such a function for what is
// drawn with it; strokes that shape branches are known without.
using ListDrawnCurves = std::vector<DrawnCurve> (*)(scene::BuiltPlant const& plant);

using DrawnCurveLists = std::span<ListDrawnCurves const>;

} // namespace tractus::tools
