#pragma once

#include "app/window/controls.h"

#include <optional>
#include <string>

namespace tractus::window {

// A panel above the bar for one number of the current tool, with its unit and range. The number is
// set with a slider, in steps, with on-screen keys for the pen, or with a keyboard.
class NumberPanel {
public:
    explicit NumberPanel(float scale)
        : scale_(scale)
    {
    }

    // Edits the number `workspace.edited_number` in a panel above `bar`. Resets it when the panel
    // is closed, or if the current tool has no such number. Returns the panel's rectangle.
    WindowPart show(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                    WindowPart const& bar);

private:
    void show_value(tools::NumberSetting const& chosen, Controls const& controls);
    void show_keys(tools::NumberSetting const& chosen, Controls const& controls);
    void press_key(char key);
    void take_typed(tools::NumberOption const& option);
    void change_to(tools::NumberOption const& option, double value);
    void adjust(view::WindowModel& model, Workspace& workspace, tools::NumberSetting const& chosen,
                std::size_t number);

    float scale_ = 1;
    float height_px_ = 0;  // Height of the panel in the last frame.
    std::string asked_ {}; // Name of the number that is being edited.
    std::string typed_ {};
    std::string objection_ {}; // Reason why the typed text is refused; empty if it is accepted.
    std::optional<double> wanted_ {}; // Value that the user set in this frame.
    bool moves_ = false;              // True if a slider was dragged in this frame.
    bool is_released_ = false;        // True if a slider was released in this frame.
};

} // namespace tractus::window
