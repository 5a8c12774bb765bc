#pragma once

#include "app/tools/tool_cards.h"
#include "app/window/controls.h"

#include <string>

namespace tractus::window {

// A panel above the bar with the cards of the kind in hand, the ready ones and a person's own, each
// with its glyph if the kind has one. A press takes a card into the hand; the hand can be kept as a
// card, and an own card be called otherwise or taken away.
class CardsPanel {
public:
    explicit CardsPanel(float scale)
        : scale_(scale)
    {
    }

    // Shows it for the tool in hand above `bar`, and takes `bench.cards_are_shown` back when it is
    // closed or there are none. Returns where it is.
    WindowPart show(view::WindowModel& model, Workbench& bench, Controls const& controls,
                    WindowPart const& bar);

private:
    void show_cards(view::WindowModel& model, Workbench& bench, float width_px);
    bool show_card(tools::ToolCard const& card, bool is_on) const;
    void show_own(view::WindowModel& model, Workbench& bench, Controls const& controls,
                  tools::ToolCard const& card);

    float scale_ = 1;
    float height_px_ = 0;  // As it was shown last.
    std::string named_ {}; // The card whose name `typed_` is a new one for.
    std::string typed_ {};
};

} // namespace tractus::window
