#include "app/controllers/live_cards.h"

#include <fmt/core.h>
#include <utility>

namespace tractus::controllers {

void LiveCards::show(view::WindowState& state)
{
    auto const& kind = state.hand.kind();
    if (std::exchange(shown_, &kind) != &kind)
        state.cards = tools::cards_label(kind) ? library_.cards_of(state.tools, kind)
                                               : std::vector<tools::ToolCard>();
}

void LiveCards::show_again(view::WindowState& state)
{
    shown_ = nullptr;
    show(state);
}

void LiveCards::perform(view::KeepCard const&, view::WindowState& state)
{
    auto const name = library_.keep(state.hand);
    state.status
        = name ? fmt::format("Kept as {} in {}", *name, folder_.string()) : name.error().message;
    show_again(state);
}

void LiveCards::perform(view::RenameCard const& command, view::WindowState& state)
{
    auto const done = library_.rename(command.from, command.to);
    state.status = done ? fmt::format("{} is called {} now", command.from, command.to)
                        : done.error().message;
    show_again(state);
}

void LiveCards::perform(view::RemoveCard const& command, view::WindowState& state)
{
    auto const done = library_.remove(command.name);
    state.status = done ? fmt::format("{} is gone; what was drawn with it stays", command.name)
                        : done.error().message;
    show_again(state);
}

} // namespace tractus::controllers
