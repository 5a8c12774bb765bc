#pragma once

#include "engine/base/vectors.h"

#include <vector>

namespace tractus::tools {

// A piece of a plant's skeleton that has one state: an axis, or a part of one. In the frame of the
// plant that takes what is drawn.
struct SkeletonLine {
    enum class State {
        Unselected,
        Undetermined, // Touched, but the pen has not yet shown whether it was meant.
        Selected,
        Assigned, // A stroke gives it its shape.
        Next,     // The next stroke will.
        Other,    // Of a plant that does not take what is drawn.
    };

    std::vector<Vec3f> points_mm;
    float width_mm = 1; // Diameter at the base.
    State state = State::Unselected;

    bool operator==(SkeletonLine const&) const = default;
};

} // namespace tractus::tools
