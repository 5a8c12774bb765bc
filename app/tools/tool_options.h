#pragma once

#include <memory>
#include <span>

namespace tractus::tools {

// One of the words among which an option of a tool chooses.
struct OptionWord {
    char const* word;  // In logs: never changes, and no other option of the tool has it.
    char const* label; // On its button.
    // What the tool in hand is called with it, where that differs from its kind's title.
    char const* title = nullptr;
    bool at_once = false; // Needs no stroke: its button does it, and the tool in hand stays.
};

// An option that is one of several words. The first is what none of them means.
struct WordOption {
    std::span<OptionWord const> words;
    enum class Offered {
        Always,      // Its words have buttons as soon as a tool of the group is in hand,
        InHand,      // or when the tool itself is; until then its label has one, if no word has.
        BesideLabel, // Likewise, beside the label's button, which stays,
        InTurn, // as InHand, but one button for all, "Surface: in space", which takes the next one,
        BesideGlyph, // as long as the kind's glyph is seen,
        Never,       // never: how new strokes are understood, where older logs mean it otherwise,
        Cards,       // or "Rule: Opposite", which opens them as cards, beside a person's own
                     // (tool_cards.h).
    } offered
        = Offered::Always;
    // What else a person chooses with a card: sets the tool's other options, which logs then name.
    // Null: nothing.
    void (*goes_with)(void* options) = nullptr;
    char const* label = ""; // What its button begins with, if it has one for all.
};

// An option that is a number: "name=2.5" in logs.
struct NumberOption {
    char const* name;
    char const* unit; // For people: "mm"; empty for a count or a share.
    double least;     // The range; what is outside is refused.
    double greatest;
    double step;                 // Of the buttons that make it less and more.
    char const* label = nullptr; // On its button; no value: the name.
    enum class Offered {
        Always,       // It has a button.
        WithoutGlyph, // It has one as long as the kind's glyph is not seen, which sets it, too.
        OnGlyph,      // Only the glyph sets it.
    } offered
        = Offered::Always;
};

// Visits the options of a tool in their order. A tool says them once, in a function that hands them
// to a visitor; from that come its words in logs, equality, buttons, completion and the manual.
class OptionVisitor {
public:
    virtual ~OptionVisitor() = default;

    // The value is the word's number.
    virtual void word(WordOption const& option, int& value) = 0;
    virtual void number(NumberOption const& option, double& value) = 0;

    // An enumeration whose values are in the order of the words.
    template<typename Enum> void choice(WordOption const& option, Enum& value)
    {
        int number = static_cast<int>(value);
        word(option, number);
        value = static_cast<Enum>(number);
    }
};

// What is done with the options of a kind of tool, whose type only its own file knows.
struct OptionsType {
    std::shared_ptr<void> (*make)(); // By default.
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
