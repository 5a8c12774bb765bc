#pragma once

#include "app/render/image.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::view {

// A large button of the start page: something to begin with, or to go on with.
struct StartCard {
    std::string title {};
    std::string detail {}; // A second line; may be empty.
    // Null: there is none, or not yet. Shared with who made it; nobody changes it.
    std::shared_ptr<render::Image const> picture {};
    std::string icon {}; // Shown where there is no picture: lines as in ToolKind::icon.
    char key = 0;        // A capital letter that presses it; 0: none.
};

// Cards that belong together.
struct StartCards {
    std::string title {};
    std::vector<StartCard> cards {};
    // The cards are in order of use: the first may stand beside what comes before them, and the
    // others at the end of the page, under this title. Empty: all stay together.
    std::string title_of_others {};
};

// One thing in place of the cards, shown large, with what can be changed about it.
struct StartStudy {
    struct Picture {
        std::string title {}; // A word or two.
        // A square, as of StartCard; null: not there yet.
        std::shared_ptr<render::Image const> picture {};
    };
    struct Slider {
        std::string text {}; // What it says at its value.
        double most = 1;     // The values are from 0 to this.
        double value = 0;
    };
    Picture large {};
    std::vector<Picture> details {}; // Beside it: four.
    std::vector<Picture> others {};  // Below: six.
    std::vector<Slider> sliders {};
    std::string accept {}; // The button that is pressed when it is as it shall be.
};

struct StartPageState {
    std::string title = "What do you want to draw?";
    std::vector<StartCards> groups {};  // None of them without cards.
    std::string note {};                // A sentence for the person, in place of the title.
    std::optional<StartStudy> study {}; // In place of the groups.
    bool is_beside_drawing = false;     // There is a drawing to go back to: see leave().
    bool is_opening = false;    // A card was chosen: others count for nothing until it opens.
    std::uint64_t revision = 0; // Changes when anything of this does.
};

// What the window shows before there is a drawing. Called from the window's thread only.
class StartPageModel {
public:
    virtual ~StartPageModel() = default;

    // Valid until the next choose() or until the window's model advances.
    virtual StartPageState const& state() const = 0;

    // Opens what the card shows; the page goes when it is open.
    virtual void choose(std::size_t group, std::size_t card) = 0;

    // Sets what a slider of the study changes; called whenever it moves.
    virtual void slide(std::size_t /*slider*/, double /*value*/) { }

    // Takes what the study shows as it is.
    virtual void accept() { }

    // Goes back to the drawing without a choice; only if there is one.
    virtual void leave() { }
};

} // namespace tractus::view
