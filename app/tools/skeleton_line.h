#pragma once

#include "engine/base/vectors.h"

#include <vector>

namespace tractus::tools {

// A line of a plant's skeleton whose branch is in a single state: an axis or a part of one. In the
// frame of the active plant.
struct SkeletonLine {
    enum class State {
        Unselected,
        Undetermined, // Touched; the finished stroke may or may not select it.
        Selected,
        Assigned, // Shaped by a stroke.
        Next,     // Will be shaped by the next stroke.
        Other,    // Belongs to a plant that is not active.
    };

    std::vector<Vec3f> points_mm;
    float width_mm = 1; // Diameter of the branch at the line's start.
    State state = State::Unselected;

    bool operator==(SkeletonLine const&) const = default;
};

} // namespace tractus::tools
