#pragma once

#include "app/render/image.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::view {

// A large button of the start page, which opens or continues something.
struct StartCard {
    std::string title {};
    std::string detail {}; // Second line of the card's text; may be empty.
    // Picture of the card; null if there is none or it is not ready yet. Immutable and shared.
    std::shared_ptr<render::Image const> picture {};
    std::string icon {}; // Icon that is shown if there is no picture: lines as in ToolKind::icon.
    char key = 0;        // Shortcut of the card, a capital letter; 0: none.
};

// A group of cards with a title.
struct StartCards {
    std::string title {};
    std::vector<StartCard> cards {};
    // Title for further cards. If it is not empty, the cards are in order of use: the first ones
    // may be shown beside the previous group, and the others follow at the end of the page under
    // this title.
    std::string title_of_others {};
};

// An item that the page shows large instead of the cards, with sliders that change the item.
struct StartStudy {
    struct Picture {
        std::string title {}; // Title of one or two words.
        // Square picture. Immutable and shared; null if it is not ready yet.
        std::shared_ptr<render::Image const> picture {};
    };
    struct Slider {
        std::string text {}; // Label of the slider, including its value.
        double most = 1;     // Maximum value of the slider; the minimum is 0.
        double value = 0;
    };
    Picture large {};
    std::vector<Picture> details {}; // The four pictures beside the large one.
    std::vector<Picture> others {};  // The six pictures below the large one.
    std::vector<Slider> sliders {};
    std::string accept {}; // Label of the button that accepts the item.
};

struct StartPageState {
    std::string title = "What do you want to draw?";
    std::vector<StartCards> groups {}; // Groups of cards; none is empty.
    std::string note {}; // Message that is shown instead of the page's title; empty: none.
    std::optional<StartStudy> study {}; // Item that is shown instead of the groups.
    bool offers_tour = false;           // True if begin_tour() opens the tour.
    bool is_beside_drawing = false;     // True if there is a drawing to which leave() returns.
    // True once a card was chosen, until it has opened; further choices are ignored meanwhile.
    bool is_opening = false;
    std::uint64_t revision = 0; // Changes whenever another member changes.
};

// Model of a page that the window shows instead of a drawing. For use on the window's thread only.
class StartPageModel {
public:
    virtual ~StartPageModel() = default;

    // Returns the current state, valid until the next choose() or the window model's next
    // advance().
    virtual StartPageState const& state() const = 0;

    // Opens a card. The page disappears once the card has opened.
    virtual void choose(std::size_t group, std::size_t card) = 0;

    // Opens an empty sheet and begins the tour there. The page disappears once the sheet has
    // opened.
    virtual void begin_tour() { }

    // Sets a slider of the study; called whenever the slider moves.
    virtual void slide(std::size_t /*slider*/, double /*value*/) { }

    // Accepts the item that the study shows.
    virtual void accept() { }

    // Returns to the drawing without a choice. Only allowed if there is a drawing.
    virtual void leave() { }
};

} // namespace tractus::view
