#pragma once

#include "app/view/start_page.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace tractus::window {

// Where cards stand on a page, in pixels from its upper left corner.
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
    float card_width = 0; // All cards are alike.
    float card_height = 0;
    float picture_height = 0; // The upper part of a card; its words are below it.
    float height = 0;         // Of all.
};

// Sets cards into columns of one width, as many as are wide enough for a pen and for their words,
// each group under its title. `scale` is the display's.
CardGrid arrange_cards(std::span<view::StartCards const> groups, float width, float scale);

enum class Direction { Left, Right, Up, Down };

// The place, by its number, that an arrow key leads to from another; itself where there is none.
std::size_t neighbour(CardGrid const& grid, std::size_t from, Direction direction);

} // namespace tractus::window
