#include "app/window/workspace.h"

#include <algorithm>
#include <array>
#include <utility>

namespace tractus::window {

void Workspace::choose(view::WindowModel& model, tools::Tool tool)
{
    bool const is_select = tool.kind().surface == tools::Surface::Skeleton;
    if (is_select)
        tool = tool.seen_from(angle);
    if (!tool.is_done_at_once()) {
        turns_views = false;
        if (shown != Shown::All)
            shown = is_select ? Shown::Skeleton : Shown::Pad;
        if (&tool.kind() != &model.state().hand.kind()) {
            close_panels();
        }
        remember(tool);
    }
    model.perform(view::ChooseTool { tool });
}

tools::Tool const& Workspace::hand(view::WindowState const& state) const
{
    bool const is_same_kind = adjusted && &adjusted->kind() == &state.hand.kind();
    return is_same_kind ? *adjusted : state.hand;
}

void Workspace::adjust(view::WindowModel& model, tools::Tool tool,
                       view::ChangeGrowth::Slider slider)
{
    if (slider == view::ChangeGrowth::Slider::Moving) {
        adjusted = tool;
    } else {
        adjusted.reset();
        remember(tool);
    }
    model.perform(view::AdjustTool { std::move(tool), slider });
}

void Workspace::remember(tools::Tool const& tool)
{
    if (*tool.kind().method == 0)
        return;
    auto& tools = chosen_methods_;
    tools.erase(
        std::remove_if(tools.begin(), tools.end(),
                       [&](tools::Tool const& other) { return &other.kind() == &tool.kind(); }),
        tools.end());
    tools.push_back(tool);
}

std::vector<tools::Tool> Workspace::remembered(view::WindowState const& state) const
{
    auto tools = state.remembered;
    tools.insert(tools.end(), chosen_methods_.begin(), chosen_methods_.end());
    return tools;
}

void Workspace::choose_view_tool()
{
    turns_views = true;
    close_panels();
    if (shown == Shown::Pad)
        shown = Shown::Plant;
}

static constexpr std::array<std::string_view, 6> kShownWords { "all",      "pad",   "strokes",
                                                               "skeleton", "plant", "many" };

std::span<std::string_view const> shown_words()
{
    return kShownWords;
}

std::optional<Workspace::Shown> parse_shown(std::string_view word)
{
    auto const found = std::find(kShownWords.begin(), kShownWords.end(), word);
    if (found == kShownWords.end())
        return std::nullopt;
    return Workspace::Shown(static_cast<int>(found - kShownWords.begin()));
}

void Workspace::show_next()
{
    shown = shown == Shown::Collection ? Shown::All : Shown(static_cast<int>(shown) + 1);
}

void Workspace::turn_full_screen()
{
    requested_full_screen = FullScreen { !will_fill_display() };
}

void Workspace::enter_stage()
{
    is_on_stage = true;
    close_menu();
    keys_are_listed = false;
    close_panels();
    if (!will_fill_display())
        turn_full_screen();
}

bool Workspace::will_fill_display() const
{
    return requested_full_screen ? requested_full_screen->is_on : filled_display.has_value();
}

void Workspace::close_panels()
{
    edited_number.reset();
    cards_are_shown = false;
    name_request.reset();
}

void Workspace::ask_number(std::size_t number)
{
    close_panels();
    edited_number = number;
}

void Workspace::show_cards()
{
    close_panels();
    cards_are_shown = true;
}

void Workspace::ask_name(NameRequest name)
{
    close_panels();
    close_menu();
    name_request = std::move(name);
}

void Workspace::open_menu(MenuPage page)
{
    menu = page;
    last_menu = page;
}

bool Workspace::draws(view::WindowState const& state) const
{
    if (!state.is_live || turns_views)
        return false;
    return is_on_stage ? !selects(state) : is_shown(selects(state) ? Shown::Skeleton : Shown::Pad);
}

} // namespace tractus::window
