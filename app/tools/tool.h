#pragma once

#include "engine/base/result.h"
#include "engine/scene/edit.h"
#include "engine/scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace tractus {

// What the pen means now. A log names it in its T lines: a word, and for some an argument.
struct Tool {
    enum class Kind {
        Select,      // "select": the stroke runs over the skeleton's picture and chooses a path.
        Draw,        // "draw [selected|descendants|both]": the stroke shapes the selected path.
        Indicate,    // "indicate": the stroke's two ends are a motion indicator.
        DrawInOrder, // "draw_in_order": each stroke shapes the next axis, the trunk first.
    };
    Kind kind = Kind::DrawInOrder;
    Propagation propagation = Propagation::Selected; // For Draw alone.

    bool operator==(Tool const&) const = default;
};

// A tool from the words of a log or a script. Fails, as the user's fault, naming the tools there
// are.
Result<Tool> parse_tool(std::string_view name, std::string_view arguments);

// The words for a tool, as parse_tool reads them.
struct ToolWords {
    std::string name;
    std::string arguments;
};
ToolWords words_for(Tool const& tool);

// What a finished stroke says in the hand of each tool, as edits of `scene`, to be applied in
// order. Fails, as the user's fault, when it says nothing: a stroke beside the plant, nothing
// selected.
Result<std::vector<Edit>> edits_of(Tool const& tool, Stroke const& stroke, Scene const& scene);

// The four of them, one file each; edits_of chooses.
Result<std::vector<Edit>> select_edits(Stroke const& stroke, Scene const& scene);
Result<std::vector<Edit>> draw_edits(Propagation propagation, Stroke const& stroke,
                                     Scene const& scene);
Result<std::vector<Edit>> indicate_edits(Stroke const& stroke);
Result<std::vector<Edit>> draw_in_order_edits(Stroke const& stroke, Scene const& scene);

} // namespace tractus
