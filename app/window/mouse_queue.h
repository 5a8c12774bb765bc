#pragma once

#include "app/window/hand_input.h"

#include <optional>
#include <vector>

namespace tractus::window {

// Passes the mouse's events on in portions of at most one press or release per frame, so that a
// click during a slow frame is neither misplaced nor lost.
class MouseQueue {
public:
    struct Part {
        std::vector<MouseMoment> path;
        // The press or release in this portion of events, if any.
        std::optional<MouseMoment> change;
    };

    void push(MouseMoment const& moment) { waiting_.push_back(moment); }
    bool is_empty() const { return waiting_.empty(); }
    Part take_part();

private:
    std::vector<MouseMoment> waiting_;
    bool is_down_ = false; // State of the button after the last portion.
};

} // namespace tractus::window
