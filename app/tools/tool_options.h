#pragma once

#include <memory>
#include <optional>
#include <span>

namespace tractus::tools {

// One of the words among which the user chooses the value of a WordOption.
struct OptionWord {
    char const* word;  // Name in logs: never changes, and is unique among the tool's options.
    char const* label; // Text on the word's button.
    // Title of the tool while this word is chosen, if it differs from the kind's title.
    char const* title = nullptr;
    // The word needs no stroke: pressing its button acts at once, and the current tool stays
    // selected.
    bool at_once = false;
};

// An option whose value is one of several words. In logs, the first word is meant if none is given.
struct WordOption {
    std::span<OptionWord const> words;
    enum class Offered {
        // All words have buttons whenever any tool of the kind's group and method is selected.
        Always,
        // The words have buttons while a tool of this kind is selected. Otherwise a single button
        // has the kind's label, unless another option of the kind is offered Always.
        InHand,
        BesideLabel, // Like InHand, but there is always also a button with the kind's label.
        InTurn,      // Like InHand, but one button cycles through all words: "Surface: in space".
        BesideGizmo, // Like InTurn, but only while the kind's gizmo is visible.
        // No button. New tools have the current word, while old logs lack the option and mean the
        // first word.
        Never,
        // A button such as "Rule: Opposite" opens the words as cards, beside the user's own presets
        // (tool_cards.h).
        Cards,
    } offered
        = Offered::Always;
    // Side effect of choosing a word: sets other options of the tool, which logs then contain.
    // Null: no side effect.
    void (*goes_with)(void* options) = nullptr;
    char const* label = ""; // Start of the button's text, if one button stands for all words.
};

// A number option; "name=2.5" in logs.
struct NumberOption {
    char const* name;
    char const* unit; // Unit for the user, such as "mm"; empty for a count or a share.
    double least;     // Least value; values outside the range are refused.
    double greatest;
    double step;                 // Step of the minus and plus buttons.
    char const* label = nullptr; // Text on the option's button; null: `name`.
    enum class Offered {
        Always,       // The option has a button whenever its tool is selected.
        WithoutGizmo, // The option has a button only while the gizmo that also sets it is hidden.
        OnGizmo,      // The option is set by the gizmo only.
    } offered
        = Offered::Always;
    // The value that a log means in which the number is missing; no value: the tool's default. It
    // keeps the plants of logs that are older than a default.
    std::optional<double> in_logs {};
};

// Visits a tool's options in order. Each kind of tool lists its options once, in a function that
// passes them to a visitor. Words in logs, equality, buttons, completion and the manual are derived
// from that.
class OptionVisitor {
public:
    virtual ~OptionVisitor() = default;

    // `value` is the index of the chosen word in `option.words`.
    virtual void word(WordOption const& option, int& value) = 0;
    virtual void number(NumberOption const& option, double& value) = 0;

    // Visits a word option stored as an enumeration, whose values are in the order of the words.
    template<typename Enum> void choice(WordOption const& option, Enum& value)
    {
        int number = static_cast<int>(value);
        word(option, number);
        value = static_cast<Enum>(number);
    }
};

// Operations on the options of a kind of tool. Only the kind's own file knows the options' type.
struct OptionsType {
    std::shared_ptr<void> (*make)(); // Creates default options.
    std::shared_ptr<void> (*copy)(void const* options);
    void (*visit)(OptionVisitor& visitor, void* options);
};

template<typename T> void visit_no_options(OptionVisitor&, T&) { }

template<typename T, void (*visit)(OptionVisitor&, T&) = visit_no_options<T>>
constexpr OptionsType options_type()
{
    return { .make = [] { return std::shared_ptr<void>(std::make_shared<T>()); },
             .copy =
                 [](void const* options) {
                     return std::shared_ptr<void>(
                         std::make_shared<T>(*static_cast<T const*>(options)));
                 },
             .visit = [](OptionVisitor& visitor,
                         void* options) { visit(visitor, *static_cast<T*>(options)); } };
}

} // namespace tractus::tools
