#pragma once

#include "app/view/start_page.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tractus::window {

// Positions of preset cards on a page, in pixels from its upper left corner.
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
    float card_width = 0; // Width of a card; all cards have the same size.
    float card_height = 0;
    // Height of the picture in the upper part of a card; the text is below it.
    float picture_height = 0;
    float height = 0; // Total height of the page.
};

// Arranges cards in columns of equal width, as many as leave each card wide enough for its text and
// for a pen, with each group under its title. `scale` is the display's scale factor.
CardGrid arrange_cards(std::span<view::StartCards const> groups, float width, float scale);

enum class Direction { Left, Right, Up, Down };

// The index of the card that an arrow key leads to; `from` itself if there is none in that
// direction.
std::size_t neighbour(CardGrid const& grid, std::size_t from, Direction direction);

} // namespace tractus::window
