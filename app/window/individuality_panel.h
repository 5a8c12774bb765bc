#pragma once

#include "app/window/controls.h"
#include "engine/variation/individual.h"

#include <cstddef>
#include <optional>
#include <string>

namespace tractus::window {

// Controls how much the plants of a collection differ: for each trait a switch and a slider for its
// number. A change requests the collection again.
class IndividualityPanel {
public:
    // `scale` is the display's scale factor.
    explicit IndividualityPanel(float scale)
        : scale_(scale)
    {
    }

    // The panel's width beside a sheet of plants in a room of width `room_px`.
    float width_px(float room_px) const;

    // Shows the panel in a part of the window, for a collection of `count` variations.
    void show(view::WindowModel& model, Controls const& controls, WindowPart const& part,
              std::size_t count);

private:
    struct Row {
        char const* name;
        double greatest;
        std::string text; // Label that explains the value, as a format of printf.
    };
    // The change that the user made to a row.
    enum class Change { None, Moving, Released };
    Change show_row(Controls const& controls, Row const& row, double& value, double& when_on) const;
    void show_growth(view::WindowModel& model, Controls const& controls);

    float scale_ = 1;
    float row_px_ = 0; // Inner width of the panel.
    // The traits' numbers while a slider is dragged; no value: those of the model's state apply.
    std::optional<variation::Individuality> moving_;
    // The numbers that traits get when their switches are turned on again.
    variation::Individuality when_on_ = variation::kPlantsOfOneBed;
    double variability_when_on_ = 1;
};

} // namespace tractus::window
