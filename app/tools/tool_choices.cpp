#include "app/tools/tool_choices.h"

#include "app/tools/tool_cards.h"

#include <algorithm>
#include <cstddef>
#include <fmt/core.h>
#include <string>
#include <string_view>
#include <utility>

namespace tractus::tools {

namespace {

bool is_same_group(ToolKind const& one, ToolKind const& other)
{
    return std::string_view(one.group) == other.group;
}

bool is_same_method(ToolKind const& one, ToolKind const& other)
{
    return is_same_group(one, other) && std::string_view(one.method) == other.method;
}

bool has_method(ToolKind const& kind)
{
    return *kind.method != 0;
}

// The first kind of the group and method of `kind`, possibly `kind` itself.
ToolKind const& first_of_method(ToolKinds kinds, ToolKind const& kind)
{
    return **std::find_if(kinds.begin(), kinds.end(),
                          [&](ToolKind const* other) { return is_same_method(*other, kind); });
}

// The kind that a group's button selects; `first` is the first kind of the group.
ToolKind const& kind_of_group(ToolKinds kinds, ToolKind const& first,
                              std::span<Tool const> remembered)
{
    auto const last = std::find_if(remembered.rbegin(), remembered.rend(), [&](Tool const& tool) {
        return is_same_group(tool.kind(), first) && has_method(tool.kind());
    });
    return last == remembered.rend() ? first : first_of_method(kinds, last->kind());
}

class Meanings {
public:
    explicit Meanings(Tool hand)
        : hand_(std::move(hand))
    {
    }

    // Adds the buttons of the group's methods, if it has several.
    void add_methods(ToolKinds kinds, std::span<Tool const> remembered);
    void add_kind(ToolKind const& kind);
    std::vector<Meaning> take() { return std::move(meanings_); }

private:
    void add_words(Tool const& tool, WordOption const& option, std::size_t number);
    void add_next_word(Tool const& tool, WordSetting const& chosen, std::size_t number);
    void add_cards(WordSetting const& chosen);
    void add_number(NumberSetting const& chosen, std::size_t number);
    void add(std::string const& text, Tool const& tool);

    Tool hand_;
    std::vector<Meaning> meanings_;
    bool begins_group_ = false;
};

void Meanings::add(std::string const& text, Tool const& tool)
{
    meanings_.push_back({ .text = text,
                          .tool = tool,
                          .width = button_width(text),
                          .is_on = tool == hand_,
                          .begins_group = std::exchange(begins_group_, false) });
}

void Meanings::add_methods(ToolKinds kinds, std::span<Tool const> remembered)
{
    for (auto const* const kind : kinds) {
        bool const leads = has_method(*kind) && is_same_group(*kind, hand_.kind())
            && &first_of_method(kinds, *kind) == kind;
        if (!leads)
            continue;
        add(kind->method, newly_selected_tool(*kind, remembered));
        meanings_.back().is_on = is_same_method(*kind, hand_.kind());
    }
    begins_group_ = !meanings_.empty();
}

void Meanings::add_kind(ToolKind const& kind)
{
    bool const is_in_hand = &hand_.kind() == &kind;
    auto const tool = is_in_hand ? hand_ : Tool(kind);
    auto const options = word_settings(tool);
    auto const numbers = number_settings(tool);
    begins_group_ |= kind.begins_group_of_buttons;
    bool const has_word = std::any_of(options.begin(), options.end(), [&](WordSetting const& word) {
        using enum WordOption::Offered;
        auto const offered = word.option.offered;
        return offered == Always || (is_in_hand && offered != Never && offered != BesideLabel);
    });
    if (!has_word)
        add(kind.label, kind.at_once ? tool.done_at_once() : tool);
    for (std::size_t i = 0; i < options.size(); ++i) {
        using enum WordOption::Offered;
        auto const offered = options[i].option.offered;
        if (offered == Never || (offered != Always && !is_in_hand))
            continue;
        begins_group_ |= i > 0 || offered == BesideLabel;
        if (offered == InTurn || offered == BesideGizmo)
            add_next_word(tool, options[i], i);
        else if (offered == Cards)
            add_cards(options[i]);
        else
            add_words(tool, options[i].option, i);
    }
    for (std::size_t i = 0; i < numbers.size() && is_in_hand; ++i)
        if (numbers[i].option.offered != NumberOption::Offered::OnGizmo)
            add_number(numbers[i], i);
}

void Meanings::add_words(Tool const& tool, WordOption const& option, std::size_t number)
{
    bool was_at_once = false;
    for (std::size_t i = 0; i < option.words.size(); ++i) {
        auto const& word = option.words[i];
        auto const chosen = with_word(tool, number, static_cast<int>(i));
        begins_group_ |= word.at_once && !was_at_once;
        was_at_once = word.at_once;
        add(word.label, word.at_once ? chosen.done_at_once() : chosen);
    }
}

void Meanings::add_next_word(Tool const& tool, WordSetting const& chosen, std::size_t number)
{
    auto const& [option, value] = chosen;
    auto const count = static_cast<int>(option.words.size());
    auto const next = with_word(tool, number, (value + 1) % count);
    // The part after "##" is the button's identity, which must not change while its text changes
    // under a press.
    add(fmt::format("{}: {}##{} in turn", option.label,
                    option.words[static_cast<std::size_t>(value)].label, option.label),
        next);
    meanings_.back().is_on = false;
    meanings_.back().is_beside_gizmo = option.offered == WordOption::Offered::BesideGizmo;
}

// Adds the button that opens the presets. The button's text names the preset that exactly matches
// the current tool, if there is one.
void Meanings::add_cards(WordSetting const& chosen)
{
    auto const ready = ready_cards(hand_)[static_cast<std::size_t>(chosen.value)];
    add(fmt::format("{}: {}##{} cards", chosen.option.label,
                    ready.tool == hand_ ? ready.name : "your own", chosen.option.label),
        hand_);
    meanings_.back().is_on = false;
    meanings_.back().opens_cards = true;
}

void Meanings::add_number(NumberSetting const& chosen, std::size_t number)
{
    begins_group_ |= number == 0;
    // The part after "##" is the button's identity, which must not change while its text changes
    // under a press.
    add(fmt::format("{}##{}", describe_number(chosen), chosen.option.name), hand_);
    meanings_.back().is_on = false;
    meanings_.back().number = number;
}

} // namespace

float button_width(std::string_view text)
{
    constexpr float kLetter_px = 11.5f;
    constexpr float kAir_px = 36;
    return kAir_px + kLetter_px * static_cast<float>(text.substr(0, text.find("##")).size());
}

Tool newly_selected_tool(ToolKind const& kind, std::span<Tool const> remembered)
{
    auto const found = std::find_if(remembered.begin(), remembered.end(),
                                    [&](Tool const& tool) { return &tool.kind() == &kind; });
    return found == remembered.end() ? Tool(kind) : *found;
}

// The tool of this kind that made the active plant; no value if the plant was made in another way.
static std::optional<Tool> tool_that_made(ToolKind const& kind, scene::Scene const& scene)
{
    auto const* const plant = scene::active_plant(scene.state);
    if (kind.makes && plant && plant->source.get<void>(*kind.makes))
        return Tool(kind);
    return kind.like_drawn ? kind.like_drawn(Tool(kind), scene) : std::nullopt;
}

Tool tool_for_drawing(ToolKinds kinds, scene::Scene const& scene)
{
    for (auto const* const kind : kinds)
        if (auto const tool = tool_that_made(*kind, scene))
            return *tool;
    bool const begins = scene::active_plant(scene.state) == nullptr;
    for (auto const* const kind : kinds)
        if (begins && has_method(*kind))
            return Tool(*kind);
    return kinds.empty() ? Tool() : Tool(*kinds.front());
}

std::vector<ToolChoice> tool_choices(ToolKinds kinds, std::span<Tool const> remembered)
{
    std::vector<ToolChoice> choices;
    for (auto const* const kind : kinds)
        if (std::none_of(choices.begin(), choices.end(), [&](ToolChoice const& choice) {
                return is_same_group(choice.tool.kind(), *kind);
            }))
            choices.push_back(
                { kind->group,
                  newly_selected_tool(kind_of_group(kinds, *kind, remembered), remembered) });
    return choices;
}

bool is_same_group(Tool const& one, Tool const& other)
{
    return is_same_group(one.kind(), other.kind());
}

std::vector<Meaning> meanings_of(ToolKinds kinds, Tool const& hand,
                                 std::span<Tool const> remembered)
{
    Meanings meanings(hand);
    meanings.add_methods(kinds, remembered);
    for (auto const* const kind : kinds)
        if (is_same_method(*kind, hand.kind()))
            meanings.add_kind(*kind);
    return meanings.take();
}

std::string describe_number(NumberSetting const& chosen)
{
    auto const& option = chosen.option;
    return fmt::format("{} {}", option.label ? option.label : option.name,
                       with_unit(fmt::format("{:g}", chosen.value), option));
}

std::string with_unit(std::string_view number, NumberOption const& option)
{
    std::string_view const unit = option.unit;
    if (unit == "degrees")
        return fmt::format("{}\u00b0", number);
    return fmt::format("{}{}{}", number, unit.empty() ? "" : " ", unit);
}

} // namespace tractus::tools
