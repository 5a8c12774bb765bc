#pragma once

#include "app/tools/glyph.h"
#include "app/tools/tool_kind.h"
#include "engine/base/result.h"
#include "engine/scene/desk_placement.h"
#include "engine/stroke/stroke.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus::tools {

// What the pen means now: a kind of tool and its options. A value: copies share the options, which
// nobody changes. A log names it in its T lines: a word, and for some more words.
class Tool {
public:
    // None of this program's, as of a log that another one has made, with more tools: its strokes
    // are refused.
    Tool();

    explicit Tool(ToolKind const& kind); // With the options that it has by default.

    // `options` point to the type that belongs to the kind.
    Tool(ToolKind const& kind, std::shared_ptr<void const> options)
        : kind_(&kind)
        , options_(std::move(options))
    {
    }

    template<ToolFields T>
    Tool(T options) // NOLINT(google-explicit-constructor): is one.
        : kind_(&T::kKind)
        , options_(std::make_shared<T const>(std::move(options)))
    {
    }

    ToolKind const& kind() const { return *kind_; }

    // Null for a tool of another kind.
    template<ToolFields T> T const* get() const
    {
        return kind_ == &T::kKind ? static_cast<T const*>(options_.get()) : nullptr;
    }

    // Lets the visitor look at the options, which it leaves as they are.
    void show(OptionVisitor& visitor) const { static_cast<void>(changed_by(visitor)); }

    // The same tool after the visitor has changed its options.
    Tool changed_by(OptionVisitor& visitor) const;
    // After a function for options of its kind has (WordOption::goes_with).
    Tool changed_by(void (*change)(void* options)) const;

    // Its options as a drawing, and the tool after a person has dragged or pressed a handle of that
    // (glyph.h). Only of kinds that have one.
    Glyph glyph() const;
    Tool dragged(std::size_t handle, Vec2 const& to) const;

    // It is done at once, without a stroke, and the tool in hand stays in hand: "now".
    bool is_done_at_once() const { return at_once_; }
    bool can_be_done_at_once() const;
    Tool done_at_once() const;

    // From where the skeleton is shown under the pen, for a tool that works on that: "view=", and
    // seven numbers with commas between them: azimuth, elevation, zoom, moved to x and y, and the
    // area's width and depth; and "bent" for the skeleton as strokes have bent it.
    scene::SelectionAngle const& angle() const { return angle_; }
    Tool seen_from(scene::SelectionAngle const& angle) const;

    // What it is called, for people.
    std::string title() const;

    // See ToolKind::mean.
    Result<std::vector<scene::Edit>> mean(Stroke const& stroke, scene::Scene const& scene) const
    {
        return kind_->mean(*this, stroke, scene);
    }

    bool operator==(Tool const& other) const;

private:
    ToolKind const* kind_;
    std::shared_ptr<void const> options_; // Shared between copies.
    scene::SelectionAngle angle_ {};
    bool at_once_ = false;
};

// The options of a tool that are words, with the number of the word that each has.
struct ChosenWord {
    WordOption option;
    int value = 0;
};
std::vector<ChosenWord> chosen_words(Tool const& tool);

// The tool with another word for the option of this number among them.
Tool with_word(Tool const& tool, std::size_t option, int value);

// The same of options that are numbers.
struct ChosenNumber {
    NumberOption option;
    double value = 0;
};
std::vector<ChosenNumber> chosen_numbers(Tool const& tool);
Tool with_number(Tool const& tool, std::size_t option, double value);

// A number that a person or a log gives for an option. No value: the text is no number, or one that
// is outside the option's range.
std::optional<double> read_number(NumberOption const& option, std::string_view text);

// A tool from the words of a log or a script. Fails, as the user's fault, naming the tools or
// arguments there are.
Result<Tool> parse_tool(ToolKinds kinds, std::string_view name, std::string_view arguments);

// What a log without tool lines means: the kind as its word alone says it in a log.
Tool tool_of_word(ToolKind const& kind);

// `arguments`, which parse_tool knows, with the words that they need to mean the tool as a person
// takes it in hand now: those of options that no button offers, unless they are among them.
std::string words_in_hand(ToolKinds kinds, std::string_view name, std::string_view arguments);

// The words for a tool, as parse_tool reads them.
struct ToolWords {
    std::string name;
    std::string arguments;
};
ToolWords words_for(Tool const& tool);

// A finished stroke in the hand of a tool; without tips something that the tool does at once.
struct ToolStroke {
    Stroke stroke;
    Tool tool;
};

} // namespace tractus::tools
