#pragma once

#include "app/window/hand_input.h"

#include <optional>
#include <vector>

namespace tractus::window {

// What the mouse did, handed out in parts of at most one press or release, one a frame. So a frame
// that took long shows nobody a click in the wrong place, or none.
class MouseQueue {
public:
    struct Part {
        std::vector<MouseMoment> path;
        std::optional<MouseMoment> change; // The press or release in it.
    };

    void push(MouseMoment const& moment) { waiting_.push_back(moment); }
    bool is_empty() const { return waiting_.empty(); }
    Part take_part();

private:
    std::vector<MouseMoment> waiting_;
    bool is_down_ = false; // As was last handed out.
};

} // namespace tractus::window
