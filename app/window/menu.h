#pragma once

#include "app/window/controls.h"

#include <functional>

namespace tractus {

// The panel beside the views with what is not needed at each stroke: how the plant grows, pictures,
// the keys.
class Menu {
public:
    explicit Menu(float scale)
        : scale_(scale)
    {
    }

    // Shows it at the right edge of `room`; returns where it is. `picture`: of the plant as it is
    // seen, for a file.
    WindowPart show(WindowModel& model, Workbench& bench, Controls const& controls,
                    WindowPart const& room, std::function<Image()> const& picture) const;

private:
    void show_growth(WindowModel& model, Controls const& controls) const;
    bool show_slider(char const* name, char const* text, float greatest, double& value,
                     bool& is_released) const;

    float scale_ = 1;
};

} // namespace tractus
