#pragma once

#include "app/window/hand_input.h"

#include <optional>
#include <vector>

namespace tractus::window {

// Passes the mouse's events on in portions. Each frame gets a portion with at most one press or
// release, so that a click during a slow frame is neither misplaced nor lost.
class MouseQueue {
public:
    struct Part {
        std::vector<MouseMoment> path;
        // The press or release in this portion; no value if there is none.
        std::optional<MouseMoment> change;
    };

    void push(MouseMoment const& moment) { waiting_.push_back(moment); }
    bool is_empty() const { return waiting_.empty(); }
    Part take_part();

private:
    std::vector<MouseMoment> waiting_;
    bool is_down_ = false; // True if the button was down after the last portion.
};

} // namespace tractus::window
