#pragma once

#include "app/view/start_page.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tractus::window {

// Positions of the cards on a page, in pixels from the page's upper left corner.
struct CardGrid {
    struct Place {
        std::size_t group = 0;
        std::size_t card = 0;
        float left = 0;
        float top = 0;
    };
    struct Title {
        std::string text;
        float left = 0;
        float top = 0;
    };
    std::vector<Place> places {};
    std::vector<Title> titles {};
    float card_width = 0; // Width of the cards, which all have the same size.
    float card_height = 0;
    // Height of the picture at the top of each card; the text is below the picture.
    float picture_height = 0;
    float height = 0; // Total height of the page.
};

// Arranges cards in columns of equal width, with each group under its title. There are as many
// columns as leave each card wide enough for its text and for the pen. `scale` is the display's
// scale factor.
CardGrid arrange_cards(std::span<view::StartCards const> groups, float width, float scale);

enum class Direction { Left, Right, Up, Down };

// Returns the index of the card to which an arrow key leads from the card `from`. Returns `from` if
// there is no card in that direction.
std::size_t neighbour(CardGrid const& grid, std::size_t from, Direction direction);

} // namespace tractus::window
