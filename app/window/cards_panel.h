#pragma once

#include "app/tools/tool_cards.h"
#include "app/window/controls.h"

#include <string>

namespace tractus::window {

// A panel above the bar with presets (cards) for the current kind of tool, built-in and the user's
// own, each with its gizmo if the kind has one. Pressing a card selects its tool; the current tool
// can be saved as a card, and own cards can be renamed or deleted.
class CardsPanel {
public:
    explicit CardsPanel(float scale)
        : scale_(scale)
    {
    }

    // Shows the cards for the current tool above `bar`; clears `workspace.cards_are_shown` if it is
    // closed or there are no cards. Returns the panel's rectangle.
    WindowPart show(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                    WindowPart const& bar);

private:
    void show_cards(view::WindowModel& model, Workspace& workspace, float width_px);
    bool show_card(tools::ToolCard const& card, bool is_on) const;
    void show_own(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                  tools::ToolCard const& card);

    float scale_ = 1;
    float height_px_ = 0;  // Height of the panel in the last frame.
    std::string named_ {}; // The card being renamed; `typed_` is the new name so far.
    std::string typed_ {};
};

} // namespace tractus::window
