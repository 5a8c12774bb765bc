#pragma once

#include "app/window/controls.h"
#include "engine/variation/individual.h"

#include <cstddef>
#include <optional>
#include <string>

namespace tractus::window {

// A panel that controls how much the plants of a collection differ. Each trait has a switch, and a
// slider for its number. After each change the collection is requested again.
class IndividualityPanel {
public:
    // `scale` is the display's scale factor.
    explicit IndividualityPanel(float scale)
        : scale_(scale)
    {
    }

    // Returns the width of the panel if panel and sheet of plants share a width of `room_px`.
    float width_px(float room_px) const;

    // Shows the panel in a part of the window. The collection consists of `count` variations.
    void show(view::WindowModel& model, Controls const& controls, WindowPart const& part,
              std::size_t count);

private:
    struct Row {
        char const* name;
        double greatest;
        std::string text; // Label that explains the value, in printf's format.
    };
    // What the user did with a row's slider or switch.
    enum class Change { None, Moving, Released };
    Change show_row(Controls const& controls, Row const& row, double& value, double& when_on) const;
    void show_growth(view::WindowModel& model, Controls const& controls);

    float scale_ = 1;
    float row_px_ = 0; // Width of the panel's content, in pixels.
    // Numbers of the traits while a slider is dragged. No value: those of the model's state apply.
    std::optional<variation::Individuality> moving_;
    // Numbers that the traits get when their switches are turned on again.
    variation::Individuality when_on_ = variation::kPlantsOfOneBed;
    double variability_when_on_ = 1;
};

} // namespace tractus::window
