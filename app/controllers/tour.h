#pragma once

#include "app/view/tour_view.h"
#include "app/view/window_model.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace tractus::controllers {

// The state of the drawing that the tour watches.
struct TourFacts {
    bool is_hand_over = false;  // True once the simulated hand has drawn its tree.
    std::size_t strokes = 0;    // Number of strokes that have an effect.
    std::size_t indicators = 0; // Number of motion indicators of the active plant.
};

// How the user draws, on which the wording of the tasks depends.
struct TourHands {
    bool mouse_draws = false;         // The mouse is the pen.
    bool mouse_moves_surface = false; // The mouse wheel moves the surface.
};

// A walk through the program, in steps. In the first a simulated hand draws a tree. Each of the
// others says what to try, and waits until the user has done it: to draw a limb and the wind, to
// choose leaves and a season, to look at many plants of the kind, to export. The last one has no
// task and waits until the user ends the tour. Every step can be skipped.
//
// The tour only watches; the window's controller moves devices and tools (LiveWindow).
class Tour {
public:
    // Tells the tour of a command that the user has given.
    void take(view::WindowCommand const& command);

    // Tells the tour of the drawing's present state.
    void look(TourFacts const& facts);

    void skip(); // Goes on to the next step, as if the user had done the task.

    // True in the first step.
    bool waits_for_hand() const;

    // Name of the tool with which the step's task is done. Empty if the step needs no tool.
    std::string_view tool() const;

    // Number of the step, from 0. Changes when the next step begins.
    std::size_t step() const { return step_; }

    view::TourView view(TourHands const& hands) const;

private:
    void go_on();

    std::size_t step_ = 0;
    TourFacts facts_ {};
    TourFacts at_begin_ {}; // Facts at the beginning of the step.
};

} // namespace tractus::controllers
