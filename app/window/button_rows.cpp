#include "app/window/button_rows.h"

#include <algorithm>

namespace tractus::window {

namespace {

constexpr float kMinGap = 0.4f; // Minimum gap between buttons, as a share of the normal gap.
// Minimum ButtonRow::ease of a row with several groups, unless this would need another row.
constexpr float kRoomyEase = 0.5f;

using Buttons = std::span<ButtonWidth const>;

float width_of(Buttons buttons, ButtonGaps const& gaps, float ease)
{
    ButtonRow const row { .end = buttons.size(), .ease = ease };
    float width = 0;
    for (std::size_t i = 0; i < buttons.size(); ++i)
        width += row.width(buttons[i]) + (i > 0 ? row.gap_before(buttons[i], gaps) : 0);
    return width;
}

// Returns the index after the last button of the group that begins at `begin`.
std::size_t end_of_group(Buttons buttons, std::size_t begin)
{
    auto end = begin + 1;
    while (end < buttons.size() && !buttons[end].begins_group)
        ++end;
    return end;
}

// Returns the end of the row that begins at `begin`: after as many groups as fit with at least
// `min_ease`. If the first group alone does not fit, the row ends after as many of its buttons as
// fit.
std::size_t end_of_row(Buttons buttons, std::size_t begin, ButtonGaps const& gaps, float room,
                       float min_ease)
{
    auto const fits = [&](std::size_t end, float ease) {
        return width_of(buttons.subspan(begin, end - begin), gaps, ease) <= room;
    };
    auto end = end_of_group(buttons, begin);
    if (!fits(end, 0)) {
        auto const end_of_first = end;
        end = begin + 1;
        while (end < end_of_first && fits(end + 1, 0))
            ++end;
        return end;
    }
    while (end < buttons.size() && fits(end_of_group(buttons, end), min_ease))
        end = end_of_group(buttons, end);
    return end;
}

std::vector<ButtonRow> rows_with(Buttons buttons, ButtonGaps const& gaps, float room,
                                 float min_ease)
{
    std::vector<ButtonRow> rows;
    for (std::size_t begin = 0; begin < buttons.size(); begin = rows.back().end) {
        auto const end = end_of_row(buttons, begin, gaps, room, min_ease);
        auto const row = buttons.subspan(begin, end - begin);
        float const least = width_of(row, gaps, 0);
        float const usual = width_of(row, gaps, 1);
        float const ease = usual <= room ? 1 : (room - least) / (usual - least);
        rows.push_back({ .end = end, .ease = std::clamp(ease, 0.0f, 1.0f) });
    }
    return rows;
}

} // namespace

float ButtonRow::gap_before(ButtonWidth const& button, ButtonGaps const& gaps) const
{
    return (button.begins_group ? gaps.of_groups : gaps.usual) * (kMinGap + ease * (1 - kMinGap));
}

std::vector<ButtonRow> button_rows(std::span<ButtonWidth const> buttons, ButtonGaps const& gaps,
                                   float room)
{
    auto narrow = rows_with(buttons, gaps, room, 0);
    auto roomy = rows_with(buttons, gaps, room, kRoomyEase);
    return roomy.size() == narrow.size() ? roomy : narrow;
}

} // namespace tractus::window
