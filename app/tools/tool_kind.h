#pragma once

#include "app/tools/stroke_previewer.h"
#include "app/tools/tool_options.h"
#include "engine/base/result.h"
#include "engine/scene/edit_kind.h"
#include "engine/scene/plant_source.h"
#include "engine/scene/scene.h"
#include "engine/stroke/stroke.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::tools {

class Tool;
struct DrawnGizmoKind;
struct GizmoKind;
struct ToolKind;

// What the coordinates of a stroke refer to, and thus the view in which the pen works.
enum class Surface {
    Space,    // The volume above the desk, seen through the tablet.
    Paper,    // A plane in the volume above the desk.
    Skeleton, // The skeleton's picture, in the view Tool::angle().
    Plant,    // The plant's picture.
};

// Appearance of a tool's ink.
struct InkStyle {
    enum class Look {
        Line,
        Arrow,  // A line with an arrow at its end.
        Eraser, // A faint line, for erasers.
    } look
        = Look::Line;
    double width_mm = 0; // Width of the ink; 0: follows the pressure.
};

// The tool at the pen's other end, used while the tip has a tool of some kind.
struct OtherEnd {
    // Kind of the tool at the other end; null: the same as at the tip.
    ToolKind const* kind = nullptr;
    // Creates the options of the tool at the other end. Null: it keeps the options it last had.
    std::shared_ptr<void> (*options)() = nullptr;
};

// Everything the program knows about a kind of tool. Logs, tool ring, tool bar, keys, completion
// and the manual are made from the list of all kinds (ToolKinds) and know no tool by name. The
// functions of a kind are called at most once per stroke or frame.
struct ToolKind {
    char const* word;  // Name in logs, such as "draw". Never changes.
    char const* label; // Text of the tool's button, if it has one of its own.
    char const* title; // Name of the tool for the user: "Draw, branch by branch".
    char const* done;  // Message after a stroke was drawn.
    char const* help;  // What the tool does, in one line of the manual.
    char const* group; // Text of the button in bar and ring that leads to all kinds of the group.
    // Text of the button that leads to the kinds of this method, at the beginning of the group's
    // row of buttons; empty in a group without methods. While a kind of one method is selected,
    // buttons for kinds of other methods are hidden.
    char const* method = "";
    // Icon of the group's button, if this is the group's first kind: polylines separated by spaces.
    // Each point is two digits, column and row on a grid from 00 (upper left) to 99.
    char const* icon = "";
    char key = 0; // Key that selects the tool, a capital letter; 0: none.
    // The kind's buttons start a new block in the row of its group.
    bool begins_group_of_buttons = false;
    bool at_once = false; // The kind needs no stroke: pressing its button is enough.
    Surface surface = Surface::Space;
    // Least extent of a stroke, in mm on the desk; a shorter one is a slip of the hand and does
    // nothing. 0 if a mere touch has a meaning. The user can change it (min_extent.h).
    double min_extent_mm = 0;
    InkStyle ink {};
    // True if the document is shown as an unfinished stroke would change it if it ended now. Only
    // for tools whose strokes can be interpreted and shown within a frame.
    bool shows_outcome = false;
    // True if the tool's strokes may mean an upright sheet of paper: a level stroke does, and a
    // stroke during which the surface moves does not. Null: `surface` says it for all strokes.
    bool (*may_draw_on_paper)(Tool const& tool) = nullptr;
    bool lays_pictures = false; // The tool's buttons start with one that opens picture files.
    // Kind of plants made with the tool. The tool is selected when a drawing opens in which such a
    // plant is active. Null: like_drawn() may recognise the tool's plants.
    scene::SourceKind const* makes = nullptr;
    OptionsType options;
    GizmoKind const* gizmo = nullptr;            // Gizmo of the tool's options; null: none.
    DrawnGizmoKind const* drawn_gizmo = nullptr; // Gizmo that edits the active plant; null: none.

    // Interprets a finished stroke as edits of `scene`, to be applied in order. `stroke` has no
    // tips if the tool acts at once. Fails with a user error if the stroke has no meaning, for
    // example beside the plant or with nothing selected.
    Result<std::vector<scene::Edit>> (*edits_for)(Tool const& tool, Stroke const& stroke,
                                                  scene::Scene const& scene);

    // Edits that adapt existing drawings when the user changes the tool's numbers; empty if none is
    // affected. Null: drawings are never adapted.
    std::vector<scene::Edit> (*follow)(Tool const& before, Tool const& after,
                                       scene::Scene const& scene)
        = nullptr;
    // The tool with the options of the active plant, or no value if that plant was not drawn with
    // this kind. Null: not supported.
    std::optional<Tool> (*like_drawn)(Tool const& tool, scene::Scene const& scene) = nullptr;

    // Message after a stroke, in place of `done`, for the scene after the stroke. Null or an empty
    // text: `done`.
    std::string (*describe)(Tool const& tool, scene::Scene const& after) = nullptr;

    // Creates the previewer of unfinished strokes. Null: no preview.
    std::unique_ptr<StrokePreviewer> (*previewer)() = nullptr;
    // Ends of the growth steps along an unfinished stroke, to be sent to other programs. World
    // frame, mm. Null: nothing grows in steps.
    std::vector<Vec3> (*steps)(Tool const& tool, Stroke const& stroke, scene::Scene const& scene)
        = nullptr;
    // True if the branches crossed by an unfinished stroke are highlighted. Null: never.
    bool (*marks_branches)(Tool const& tool) = nullptr;
    // The branch that the next stroke shapes. Null: strokes shape the selected branches.
    std::vector<SegmentId> (*aims_at)(scene::Scene const& scene) = nullptr;
    OtherEnd other_end {};
};

// The program's kinds of tools in the order of their buttons. Their words are unique. The first is
// selected at the start.
using ToolKinds = std::span<ToolKind const* const>;

// The kind with this word, or null.
ToolKind const* find_tool_kind(ToolKinds kinds, std::string_view word);

// A struct of tool options that has a static member kKind.
template<typename T>
concept ToolFields = requires
{
    {
        T::kKind
        } -> std::convertible_to<ToolKind const&>;
};

} // namespace tractus::tools
