#pragma once

#include "app/tools/tool_cards.h"
#include "app/window/controls.h"

#include <string>

namespace tractus::window {

// A panel above the bar with cards (presets) for the current kind of tool, both built-in ones and
// the user's own. Each card shows the tool's gizmo, if the kind has one. Pressing a card selects
// its tool. The current tool can be saved as a card, and own cards can be renamed or deleted.
class CardsPanel {
public:
    explicit CardsPanel(float scale)
        : scale_(scale)
    {
    }

    // Shows the cards for the current tool above `bar`. Clears `workspace.cards_are_shown` if the
    // panel is closed or there are no cards. Returns the panel's rectangle.
    WindowPart show(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                    WindowPart const& bar);

private:
    void show_cards(view::WindowModel& model, Workspace& workspace, float width_px);
    bool show_card(tools::ToolCard const& card, bool is_on) const;
    void show_own(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                  tools::ToolCard const& card);

    float scale_ = 1;
    float height_px_ = 0; // Height of the panel in the last frame.
    // Name of the card that is being renamed. `typed_` is its new name as typed so far.
    std::string named_ {};
    std::string typed_ {};
};

} // namespace tractus::window
