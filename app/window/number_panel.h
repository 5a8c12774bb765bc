#pragma once

#include "app/window/controls.h"

#include <optional>
#include <string>

namespace tractus::window {

// A panel above the bar for one number of the tool in hand, with its unit and range: dragged on a
// slider, stepped, or typed on keys that a pen can press, or on a keyboard.
class NumberPanel {
public:
    explicit NumberPanel(float scale)
        : scale_(scale)
    {
    }

    // Shows it for `bench.asked_number` above `bar`, and takes that back when it is closed or the
    // tool in hand has no such number. Returns where it is.
    WindowPart show(view::WindowModel& model, Workbench& bench, Controls const& controls,
                    WindowPart const& bar);

private:
    void show_value(tools::ChosenNumber const& chosen, Controls const& controls);
    void show_keys(tools::ChosenNumber const& chosen, Controls const& controls);
    void press_key(char key);
    void take_typed(tools::NumberOption const& option);
    void change_to(tools::NumberOption const& option, double value);
    void adjust(view::WindowModel& model, Workbench& bench, tools::ChosenNumber const& chosen,
                std::size_t number);

    float scale_ = 1;
    float height_px_ = 0;  // As it was shown last.
    std::string asked_ {}; // The number that `typed_` is of.
    std::string typed_ {};
    std::string objection_ {};        // To what was typed.
    std::optional<double> wanted_ {}; // In this frame.
    bool moves_ = false;              // A slider, in this frame.
    bool is_released_ = false;        // Likewise.
};

} // namespace tractus::window
