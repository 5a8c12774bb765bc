#include "app/window/card_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::window {

namespace {

constexpr float kUsualWidth_px = 170;
constexpr float kMinWidth_px = 130;
// Number of columns in a narrow window, if its cards are then wide enough.
constexpr std::size_t kFewColumns = 3;
constexpr std::size_t kMaxColumns = 8;
constexpr float kGap_px = 14;
constexpr float kTitleHeight_px = 44;
constexpr float kSectionGap_px = 18;
// Height of a card's picture, as a share of the card's width.
constexpr float kPictureHeight = 0.69f;
constexpr float kWordsHeight_px = 74;

// Cards under one title: a group, or a part of a group.
struct CardSection {
    std::string title;
    std::size_t group = 0;
    std::size_t first = 0;
    std::size_t count = 0;
    // First column of the section. If it is above 0, the section shares a row with the previous
    // section.
    std::size_t column = 0;
};

std::size_t column_count(float width, float scale)
{
    auto const fit = [&](float card_px) {
        float const count = (width + kGap_px * scale) / ((card_px + kGap_px) * scale);
        return static_cast<std::size_t>(std::max(1.0f, count));
    };
    return std::min(std::max(fit(kUsualWidth_px), std::min(fit(kMinWidth_px), kFewColumns)),
                    kMaxColumns);
}

// Splits the groups into sections. The first cards of a group in order of use share a row with the
// previous group if there is room, and otherwise have a row of their own.
std::vector<CardSection> sections_of(std::span<view::StartCards const> groups, std::size_t columns)
{
    std::vector<CardSection> sections;
    std::vector<CardSection> later;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        auto const& group = groups[i];
        auto const count = group.cards.size();
        CardSection section { group.title, i, 0, count, 0 };
        if (!group.title_of_others.empty()) {
            bool const is_beside = !sections.empty() && sections.back().column == 0
                && sections.back().count + 1 < columns;
            section.column = is_beside ? sections.back().count : 0;
            section.count = std::min(count, columns - section.column);
            if (section.count < count)
                later.push_back(
                    { group.title_of_others, i, section.count, count - section.count, 0 });
        }
        sections.push_back(std::move(section));
    }
    sections.insert(sections.end(), later.begin(), later.end());
    return sections;
}

} // namespace

CardGrid arrange_cards(std::span<view::StartCards const> groups, float width, float scale)
{
    auto const columns = column_count(width, scale);
    float const gap = kGap_px * scale;
    CardGrid grid;
    // Width of a column including its gap. Cards begin and end at whole pixels; the last one ends
    // at the page's edge.
    float const step_x = (width + gap) / static_cast<float>(columns);
    grid.card_width = std::floor(step_x - gap);
    grid.picture_height = std::floor(kPictureHeight * grid.card_width);
    grid.card_height = grid.picture_height + std::floor(kWordsHeight_px * scale);
    float const step_y = grid.card_height + gap;
    float top = 0; // Upper edge of the current section.
    for (auto const& section : sections_of(groups, columns)) {
        if (section.column == 0)
            top = grid.places.empty() ? 0 : grid.height + kSectionGap_px * scale;
        auto const left_of
            = [&](std::size_t column) { return std::round(static_cast<float>(column) * step_x); };
        grid.titles.push_back({ section.title, left_of(section.column), top });
        float const first_row = top + kTitleHeight_px * scale;
        auto const in_row = columns - section.column;
        for (std::size_t i = 0; i < section.count; ++i) {
            auto const row = static_cast<float>(i / in_row);
            float const card_top = first_row + row * step_y;
            grid.places.push_back({ section.group, section.first + i,
                                    left_of(section.column + i % in_row), card_top });
            grid.height = std::max(grid.height, card_top + grid.card_height);
        }
    }
    return grid;
}

std::size_t neighbour(CardGrid const& grid, std::size_t from, Direction direction)
{
    if (from >= grid.places.size())
        return 0;
    if (direction == Direction::Left)
        return from == 0 ? 0 : from - 1;
    if (direction == Direction::Right)
        return std::min(from + 1, grid.places.size() - 1);
    // Finds the nearest row in the arrow's direction, and in that row the nearest card.
    auto const& here = grid.places[from];
    auto best = from;
    auto const is_farther = [&](CardGrid::Place const& one, CardGrid::Place const& other) {
        return std::pair(std::abs(one.top - here.top), std::abs(one.left - here.left))
            > std::pair(std::abs(other.top - here.top), std::abs(other.left - here.left));
    };
    for (std::size_t i = 0; i < grid.places.size(); ++i) {
        bool const is_that_way = direction == Direction::Up ? grid.places[i].top < here.top
                                                            : grid.places[i].top > here.top;
        if (is_that_way && (best == from || is_farther(grid.places[best], grid.places[i])))
            best = i;
    }
    return best;
}

} // namespace tractus::window
