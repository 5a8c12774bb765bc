#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// What the pen means now. A log names it in its T lines: a word, and for some more words.
struct Tool {
    enum class Kind {
        Select,        // "select": the stroke runs over the skeleton's picture and chooses a path.
        Draw,          // "draw": the stroke shapes the selected path.
        Indicate,      // "indicate": the stroke's two ends are a motion indicator.
        DrawInOrder,   // "draw_in_order": each stroke shapes the next axis, the trunk first.
        Oversketch,    // "oversketch": the stroke redraws a part of those of the selected branches.
        Smooth,        // "smooth": takes the hand out of the selected branches' strokes.
        Delete,        // "delete": takes the selected branches' last stroke away.
        MoveIndicator, // "move_indicator": the indicator where the stroke begins goes along with
                       // it.
        DeleteIndicator, // "delete_indicator": that where the stroke begins goes.
        Erase, // "erase": strokes and indicators go that the stroke runs over, as the pad shows
               // them, or parts of strokes. What the pen's other end does.
        Press, // "press": the touch pressed what the window showed; it means nothing to the plant.
        Unknown, // Of a log that another program has made, with more tools: means nothing.
    };
    Kind kind = Kind::DrawInOrder;

    // For Draw, its arguments, in any order: "selected" (if none), "descendants" or "both"; "start"
    // (if none), "chord" or "world".
    Propagation propagation = Propagation::Selected;
    StrokeFit fit = StrokeFit::Start;

    // For Select, its argument: what is chosen.
    enum class Selecting {
        Path,    // None: the path under the stroke.
        Add,     // "add": that path as well.
        Take,    // "take": what was chosen but for that path.
        Ends,    // "ends": all between the branches under the stroke's two ends.
        Order,   // "order": all axes of the order of the one under the stroke's end.
        Alike,   // "alike": that axis and all siblings that are like it.
        Invert,  // "invert": what was not chosen; wherever the stroke is.
        Nothing, // "nothing".
    };
    Selecting selecting = Selecting::Path;

    // And from where its skeleton is shown under the pen: "view=", and seven numbers with commas
    // between them: azimuth, elevation, zoom, moved to x and y, and the area's width and depth
    // (SelectionAngle).
    SelectionAngle angle {};

    // For Indicate, its arguments, in any order: "everywhere" (if none), "below" (on the selected
    // branches and what they bear) or "near" (falling off around the stroke); "push" (if none) or
    // "light".
    enum class Reach { Everywhere, Below, Near };
    Reach reach = Reach::Everywhere;
    MotionIndicator::Kind indicator = MotionIndicator::Kind::Push;

    // For Erase, its argument: what goes of a stroke. Indicators have no parts, and go whole.
    enum class Erasing {
        Whole, // "whole" (if none): all of it.
        Part,  // "part": the tips under the eraser; all where those that are left shape nothing.
    };
    Erasing erasing = Erasing::Whole;

    // "now": it is done at once, without a stroke, and the tool in hand stays in hand. For Smooth,
    // Delete, and Select's Invert and Nothing.
    bool at_once = false;

    bool operator==(Tool const&) const = default;
};

// How far beside a line the eraser may be and still touch it.
constexpr double kEraserRadius_mm = 4;

// What the eraser's end of the pen means while its tip is `tool`: to erase, as was chosen last;
// when selecting, to take branches from what is selected.
Tool other_end_of(Tool const& tool, Tool::Erasing erasing);

// A tool from the words of a log or a script. Fails, as the user's fault, naming the tools or
// arguments there are.
Result<Tool> parse_tool(std::string_view name, std::string_view arguments);

// Whether parse_tool() knows a tool of this name, with whatever arguments.
bool is_tool_name(std::string_view name);

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

// What a finished stroke says in the hand of each tool, as edits of `scene`, to be applied in
// order. Fails, as the user's fault, when it says nothing: a stroke beside the plant, nothing
// selected.
Result<std::vector<Edit>> edits_of(Tool const& tool, Stroke const& stroke, Scene const& scene);

// One file for each kind of thing that is edited; edits_of chooses.
Result<std::vector<Edit>> select_edits(Tool const& tool, Stroke const& stroke, Scene const& scene);
Result<std::vector<Edit>> draw_edits(Tool const& tool, Stroke const& stroke, Scene const& scene);
Result<std::vector<Edit>> draw_in_order_edits(Stroke const& stroke, Scene const& scene);
Result<std::vector<Edit>> stroke_edits(Tool::Kind kind, Stroke const& stroke, Scene const& scene);
Result<std::vector<Edit>> indicate_edits(Tool const& tool, Stroke const& stroke,
                                         Scene const& scene);
Result<std::vector<Edit>> indicator_edits(Tool::Kind kind, Stroke const& stroke,
                                          Scene const& scene);
Result<std::vector<Edit>> erase_edits(Tool::Erasing erasing, Stroke const& stroke,
                                      Scene const& scene);

} // namespace tractus
