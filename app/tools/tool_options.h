#pragma once

#include <memory>
#include <span>

namespace tractus::tools {

// One of the words that a tool's option can have.
struct OptionWord {
    char const* word;  // Name in logs: never changes, and is unique among the tool's options.
    char const* label; // Text on the word's button.
    // Title of the tool with this word, if it differs from its kind's title.
    char const* title = nullptr;
    // Needs no stroke: pressing its button acts at once, and the current tool stays selected.
    bool at_once = false;
};

// An option with one of several words. The first is the default, used if none is given.
struct WordOption {
    std::span<OptionWord const> words;
    enum class Offered {
        Always, // The words have buttons whenever a tool of the group is selected.
        // The words have buttons while the tool itself is selected. Otherwise one button has the
        // kind's label, unless another option is offered Always.
        InHand,
        BesideLabel, // Like InHand, but the button with the kind's label stays beside them.
        InTurn,      // Like InHand, but one button cycles through all words: "Surface: in space".
        BesideGizmo, // The option's words have buttons while the kind's gizmo is visible.
        Never, // No buttons: decides how new strokes are interpreted, because older logs differ.
        // A button such as "Rule: Opposite" opens the words as cards, beside the user's own presets
        // (tool_cards.h).
        Cards,
    } offered
        = Offered::Always;
    // Side effect of choosing a word: sets other options of the tool, which logs then contain.
    // Null: none.
    void (*goes_with)(void* options) = nullptr;
    char const* label = ""; // Start of the button's text, if one button stands for all words.
};

// A number option; "name=2.5" in logs.
struct NumberOption {
    char const* name;
    char const* unit; // Unit for the user, such as "mm"; empty for a count or a share.
    double least;     // Least value; numbers out of range are refused.
    double greatest;
    double step;                 // Step of the minus and plus buttons.
    char const* label = nullptr; // Text on the option's button; null: `name`.
    enum class Offered {
        Always,       // The option always has a button.
        WithoutGizmo, // The option has a button only while the gizmo that also sets it is hidden.
        OnGizmo,      // The option is set by the gizmo only.
    } offered
        = Offered::Always;
};

// Visits a tool's options in order. A tool lists its options once, in a function that passes them
// to a visitor; words in logs, equality, buttons, completion and the manual are derived from that.
class OptionVisitor {
public:
    virtual ~OptionVisitor() = default;

    // `value` is the index of the word.
    virtual void word(WordOption const& option, int& value) = 0;
    virtual void number(NumberOption const& option, double& value) = 0;

    // Visits an enumeration whose values are in the order of the words.
    template<typename Enum> void choice(WordOption const& option, Enum& value)
    {
        int number = static_cast<int>(value);
        word(option, number);
        value = static_cast<Enum>(number);
    }
};

// Operations on the options of a kind of tool, whose type only its own file knows.
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
