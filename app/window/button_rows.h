#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::window {

// Widths of a button in pixels: the usual one, and the least at which its label is not cut off.
struct ButtonWidth {
    float usual = 0;
    float least = 0;
    bool begins_group = false; // True for the first button of a group that should stay in one row.
};

// Gaps between buttons in pixels; a crowded row has smaller ones.
struct ButtonGaps {
    float usual = 0;
    float of_groups = 0;
};

// A row of buttons, from the end of the previous row to `end`.
struct ButtonRow {
    std::size_t end = 0;
    float ease = 1; // How roomy the row is: 1 means usual widths and gaps, 0 the least ones.

    float width(ButtonWidth const& button) const
    {
        return button.least + ease * (button.usual - button.least);
    }
    float gap_before(ButtonWidth const& button, ButtonGaps const& gaps) const;
};

// Breaks buttons into as few rows of `room` pixels as possible without dividing groups, then widens
// them as far as this needs no further row. A group is divided only if it is wider than a row, and
// a button extends beyond its row only if it alone is wider.
std::vector<ButtonRow> button_rows(std::span<ButtonWidth const> buttons, ButtonGaps const& gaps,
                                   float room);

} // namespace tractus::window
