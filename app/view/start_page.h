#pragma once

#include "app/render/image.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::view {

// A large button of the start page that opens or continues something.
struct StartCard {
    std::string title {};
    std::string detail {}; // Second line; may be empty.
    // Picture of the card, or null if there is none or it is not ready. Immutable and shared.
    std::shared_ptr<render::Image const> picture {};
    std::string icon {}; // Shown if there is no picture: lines as in ToolKind::icon.
    char key = 0;        // Shortcut, a capital letter; 0: none.
};

// A group of cards with a title.
struct StartCards {
    std::string title {};
    std::vector<StartCard> cards {};
    // If not empty, the cards are ordered by use: the first card may stay beside the previous
    // group, and the others move to the end of the page under this title.
    std::string title_of_others {};
};

// One item shown large in place of the cards, with sliders that change it.
struct StartStudy {
    struct Picture {
        std::string title {}; // Title of one or two words.
        // Square picture as in StartCard; null: not ready.
        std::shared_ptr<render::Image const> picture {};
    };
    struct Slider {
        std::string text {}; // Label, including the current value.
        double most = 1;     // Greatest value of the slider; the least is 0.
        double value = 0;
    };
    Picture large {};
    std::vector<Picture> details {}; // Four pictures beside the large one.
    std::vector<Picture> others {};  // Six pictures below the large one.
    std::vector<Slider> sliders {};
    std::string accept {}; // Label of the button that accepts the item.
};

struct StartPageState {
    std::string title = "What do you want to draw?";
    std::vector<StartCards> groups {};  // Groups of cards; none is empty.
    std::string note {};                // Message shown in place of the title.
    std::optional<StartStudy> study {}; // Item shown in place of the groups.
    bool is_beside_drawing = false;     // True if there is a drawing to return to with leave().
    bool is_opening = false; // A card was chosen; further choices are ignored until it has opened.
    std::uint64_t revision = 0; // Revision number, changed whenever any other member changes.
};

// Model of the page that the window shows before there is a drawing. For use on the window's thread
// only.
class StartPageModel {
public:
    virtual ~StartPageModel() = default;

    // Current state, valid until the next choose() or advance() of the window's model.
    virtual StartPageState const& state() const = 0;

    // Opens a card; the page disappears once it has opened.
    virtual void choose(std::size_t group, std::size_t card) = 0;

    // Sets the value of a slider of the study; called whenever the slider moves.
    virtual void slide(std::size_t /*slider*/, double /*value*/) { }

    // Accepts the item shown by the study.
    virtual void accept() { }

    // Returns to the drawing without a choice. Only if there is a drawing.
    virtual void leave() { }
};

} // namespace tractus::view
