#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::window {

// Normal width of a button in pixels, and the minimum width at which its label is not cut off.
struct ButtonWidth {
    float usual = 0;
    float least = 0;
    // True for the first button of a group. A group should stay in one row.
    bool begins_group = false;
};

// Normal gaps, in pixels, between buttons of a group and between groups; they shrink in a crowded
// row.
struct ButtonGaps {
    float usual = 0;
    float of_groups = 0;
};

// A row of buttons. It begins at the end of the previous row and ends before the button `end`.
struct ButtonRow {
    std::size_t end = 0;
    float ease = 1; // At 1 the row has normal widths and gaps, at 0 the minimum ones.

    float width(ButtonWidth const& button) const
    {
        return button.least + ease * (button.usual - button.least);
    }
    float gap_before(ButtonWidth const& button, ButtonGaps const& gaps) const;
};

// Breaks buttons into as few rows of `room` pixels as possible without dividing groups. The rows'
// buttons and gaps are then widened as far as no further row is needed. A group is divided only if
// it is wider than a row, and a button is wider than its row only if its minimum width is.
std::vector<ButtonRow> button_rows(std::span<ButtonWidth const> buttons, ButtonGaps const& gaps,
                                   float room);

} // namespace tractus::window
