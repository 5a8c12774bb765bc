#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tractus::window {

// Widths of a button in pixels: as it is usually, and with its letters just whole.
struct ButtonWidth {
    float usual = 0;
    float least = 0;
    bool begins_group = false; // The first of some that stay beside each other, if they can.
};

// Gaps between buttons in pixels. A crowded row has narrower ones, too.
struct ButtonGaps {
    float usual = 0;
    float of_groups = 0;
};

// A row of buttons that begins where the one before it ended.
struct ButtonRow {
    std::size_t end = 0;
    float ease = 1; // 1: usual widths and gaps, 0: the least.

    float width(ButtonWidth const& button) const
    {
        return button.least + ease * (button.usual - button.least);
    }
    float gap_before(ButtonWidth const& button, ButtonGaps const& gaps) const;
};

// Sets buttons into as few rows of `room` pixels as hold whole groups, which are not quite as
// narrow as they can be where that takes no row more. Only a group that is wider than a row is
// divided, and only a button that is wider than a row sticks out of it.
std::vector<ButtonRow> button_rows(std::span<ButtonWidth const> buttons, ButtonGaps const& gaps,
                                   float room);

} // namespace tractus::window
