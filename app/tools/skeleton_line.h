#pragma once

#include "engine/base/vectors.h"

#include <vector>

namespace tractus::tools {

// A line along an axis of a plant's skeleton, or along a part of an axis, if the axis is divided
// into parts of different states. Points are in the frame of the active plant.
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
