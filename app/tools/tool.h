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
// immutable. A log's T lines contain it as a word and, for some tools, further words.
class Tool {
public:
    // An unknown tool, for a log made by another program with more tools; its strokes are refused.
    Tool();

    explicit Tool(ToolKind const& kind); // A tool of this kind with default options.

    // `options` must point to the type that belongs to the kind.
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

    // The options, or null for a tool of another kind.
    template<ToolFields T> T const* get() const
    {
        return kind_ == &T::kKind ? static_cast<T const*>(options_.get()) : nullptr;
    }

    // Passes the options to a visitor that must not change them.
    void show(OptionVisitor& visitor) const { static_cast<void>(changed_by(visitor)); }

    // A copy whose options the visitor has changed.
    Tool changed_by(OptionVisitor& visitor) const;
    // A copy changed by a function for options of its kind (WordOption::goes_with).
    Tool changed_by(void (*change)(void* options)) const;

    // The gizmo of the tool's options, and the tool after the user has dragged or pressed one of
    // its handles (gizmo.h). Only for kinds with a gizmo.
    Gizmo gizmo() const;
    Tool dragged(std::size_t handle, Vec2 const& to) const;

    // True if the tool acts at once, without a stroke, and leaves the current tool selected; "now"
    // in logs.
    bool is_done_at_once() const { return at_once_; }
    bool needs_no_stroke() const;
    Tool done_at_once() const;

    // View direction of the skeleton under the pen, for a tool that works on it. In logs: "view="
    // and seven numbers separated by commas: azimuth, elevation, zoom, shift in x and y, width and
    // depth of the area; and "bent" if the skeleton is shown as strokes have bent it.
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

// The tool with its word option `option` (an index) set to word number `value`.
Tool with_word(Tool const& tool, std::size_t option, int value);

// One of a tool's number options, and its value.
struct NumberSetting {
    NumberOption option;
    double value = 0;
};
std::vector<NumberSetting> number_settings(Tool const& tool);
Tool with_number(Tool const& tool, std::size_t option, double value);

// Parses an option's number, typed by the user or read from a log. No value if the text is not a
// number or is out of range.
std::optional<double> read_number(NumberOption const& option, std::string_view text);

// Makes a tool from the words of a log or a script. Fails with a user error that lists the
// available tools or arguments.
Result<Tool> parse_tool(ToolKinds kinds, std::string_view name, std::string_view arguments);

// The tool that a log means by the kind's word alone, or by having no tool lines.
Tool default_tool_of_kind(ToolKind const& kind);

// Adds to `arguments` (which must be valid for parse_tool()) the words that make the tool equal to
// the one a user selects now: those of options without a button, unless they are given.
std::string words_of_selected_tool(ToolKinds kinds, std::string_view name,
                                   std::string_view arguments);

// A tool as words that parse_tool() reads.
struct ToolWords {
    std::string name;
    std::string arguments;
};
ToolWords words_for(Tool const& tool);

// A finished stroke and its tool; without tips, an action of a tool that needs no stroke.
struct ToolStroke {
    Stroke stroke;
    Tool tool;
};

} // namespace tractus::tools
