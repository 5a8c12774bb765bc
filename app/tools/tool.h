#pragma once

#include "app/tools/gizmo.h"
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

// The pen's current tool: a kind and its options. A value type: copies share the options, which are
// immutable. A tool line ("T") of a log gives the kind's word and, if options differ from those of
// default_tool_of_kind(), words for these.
class Tool {
public:
    // An unknown tool, for a log made by a program with more tools; the tool's strokes are refused.
    Tool();

    explicit Tool(ToolKind const& kind); // A tool of this kind with default options.

    // `options` must point to options of the type that belongs to the kind.
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

    // The tool's options if its kind is T::kKind, otherwise null.
    template<ToolFields T> T const* get() const
    {
        return kind_ == &T::kKind ? static_cast<T const*>(options_.get()) : nullptr;
    }

    // Passes the options to a visitor that must not change them.
    void show(OptionVisitor& visitor) const { static_cast<void>(changed_by(visitor)); }

    // A copy whose options the visitor has changed.
    Tool changed_by(OptionVisitor& visitor) const;
    // A copy whose options `change` has changed, for example a WordOption::goes_with.
    Tool changed_by(void (*change)(void* options)) const;

    // gizmo() shows the tool's options. dragged() returns the tool after the user has moved the
    // gizmo's handle with the id `handle` to the place `to`, or has pressed it (gizmo.h). Only for
    // kinds with a gizmo.
    Gizmo gizmo() const;
    Tool dragged(std::size_t handle, Vec2 const& to) const;

    // True if the tool acts at once, without a stroke, and leaves the current tool selected. Logs
    // then contain the word "now".
    bool is_done_at_once() const { return at_once_; }
    bool needs_no_stroke() const;
    Tool done_at_once() const;

    // View of the skeleton over which the tool's strokes are drawn, for kinds with
    // Surface::Skeleton. In logs: "view=" and seven numbers separated by commas: azimuth,
    // elevation, zoom, shift in x and y, width and depth of the area; and "bent" if the skeleton is
    // shown as bent by strokes.
    scene::SelectionAngle const& angle() const { return angle_; }
    Tool seen_from(scene::SelectionAngle const& angle) const;

    // Name of the tool, for the user.
    std::string title() const;

    // Interprets a stroke; see ToolKind::edits_for.
    Result<std::vector<scene::Edit>> edits_for(Stroke const& stroke,
                                               scene::Scene const& scene) const
    {
        return kind_->edits_for(*this, stroke, scene);
    }

    bool operator==(Tool const& other) const;

private:
    ToolKind const* kind_;
    std::shared_ptr<void const> options_; // Options of the kind's type; shared between copies.
    scene::SelectionAngle angle_ {};
    bool at_once_ = false;
};

// One of a tool's word options, and the index of the chosen word.
struct WordSetting {
    WordOption option;
    int value = 0;
};
std::vector<WordSetting> word_settings(Tool const& tool);

// The tool with the word option of index `option` set to the word of index `value`.
Tool with_word(Tool const& tool, std::size_t option, int value);

// One of a tool's number options, and its value.
struct NumberSetting {
    NumberOption option;
    double value = 0;
};
std::vector<NumberSetting> number_settings(Tool const& tool);
Tool with_number(Tool const& tool, std::size_t option, double value);

// Parses the number of an option, typed by the user or read from a log. Returns no value if the
// text is not a number or is out of the option's range.
std::optional<double> read_number(NumberOption const& option, std::string_view text);

// Makes a tool from the words of a log or a script. Fails with a user error that lists the
// available tools or arguments.
Result<Tool> parse_tool(ToolKinds kinds, std::string_view name, std::string_view arguments);

// The tool that a log means if it gives only the kind's word, or has no tool lines: each word
// option has its first word, and each number option its default.
Tool default_tool_of_kind(ToolKind const& kind);

// Adds words to `arguments` (which must be valid for parse_tool()), so that the parsed tool equals
// one that a user selects now. The added words set the options without a button that `arguments`
// does not set.
std::string words_of_selected_tool(ToolKinds kinds, std::string_view name,
                                   std::string_view arguments);

// A tool as words that parse_tool() reads.
struct ToolWords {
    std::string name;
    std::string arguments;
};
ToolWords words_for(Tool const& tool);

// A finished stroke and its tool. Without tips: an action of a tool that needs no stroke.
struct ToolStroke {
    Stroke stroke;
    Tool tool;
};

} // namespace tractus::tools
