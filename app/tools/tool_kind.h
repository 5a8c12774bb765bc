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
struct DrawnGlyphKind;
struct GlyphKind;
struct ToolKind;

// What the places of a stroke are places on, and so which view a pen works in.
enum class Surface {
    Space,    // The volume above the desk, through the drawing pad.
    Paper,    // A plane in it.
    Skeleton, // The skeleton's picture, from the angle that the tool line says.
    Plant,    // The plant's picture.
};

// How the ink of a tool looks.
struct InkStyle {
    enum class Look {
        Line,
        Arrow,  // At its end.
        Eraser, // Hardly seen.
    } look
        = Look::Line;
    double width_mm = 0; // 0: as the pressure says.
};

// What the pen's other end does while its tip has a tool in hand.
struct OtherEnd {
    ToolKind const* kind = nullptr; // No value: the same as the tip.
    // Its options; no value: those with which it was chosen last.
    std::shared_ptr<void> (*options)() = nullptr;
};

// All that the program knows of a kind of tool: a row of the table of tools. Logs, ring, bar, keys,
// completion and the manual work by it and know no tool by name. Its functions are called once for
// a stroke or a frame.
struct ToolKind {
    char const* word;  // In logs: "draw". Never changes.
    char const* label; // On its button, where it has one of its own.
    char const* title; // What the pen means, for people: "Draw, branch by branch".
    char const* done;  // What is said when a stroke of it has been drawn.
    char const* help;  // What it does, in a line of the manual.
    char const* group; // The button of bar and ring that leads to it and all others of the group.
    // Of a group that holds several methods: the button, first in the group's row, that leads to
    // the kinds of this one. Kinds of other methods have no buttons of their own meanwhile.
    char const* method = "";
    // A picture for the group's button, of the group's first kind: lines that are separated by
    // spaces, of places that are two digits each, column and row on a grid from 00 at the upper
    // left to 99.
    char const* icon = "";
    char key = 0;                         // A capital letter that takes it in hand; 0: none.
    bool begins_group_of_buttons = false; // Among the buttons that its group leads to.
    bool at_once = false;                 // It needs no stroke: its button does it.
    Surface surface = Surface::Space;
    // A stroke that gets less far than this from where it begins, mm on the desk, is a slip of the
    // hand: it does nothing. 0 where a touch means something. A person may set another
    // (least_extent.h).
    double least_extent_mm = 0;
    InkStyle ink {};
    // The document is shown as a stroke under way would leave it if it ended here. Only where what
    // a stroke means is found and shown within a frame.
    bool shows_outcome = false;
    bool lays_pictures = false; // Its buttons begin with one that opens pictures.
    // The plants that are made with it: it comes to hand with a drawing in which such a one takes
    // what is drawn. Null: none, or those that like_drawn() knows.
    scene::SourceKind const* makes = nullptr;
    OptionsType options;
    GlyphKind const* glyph = nullptr; // Its options as a drawing; no value: numbers and words do.
    DrawnGlyphKind const* drawn_glyph = nullptr; // The active plant's numbers; no value: none.

    // What a finished stroke says, as edits of `scene`, to be applied in order. `stroke` is without
    // tips if the tool does it at once. Fails, as the user's fault, when it says nothing: a stroke
    // beside the plant, nothing selected.
    Result<std::vector<scene::Edit>> (*mean)(Tool const& tool, Stroke const& stroke,
                                             scene::Scene const& scene);

    // What has been drawn with the tool already, and follows when a person gives it other numbers:
    // edits of `scene`, none if nothing does. No value: nothing ever does.
    std::vector<scene::Edit> (*follow)(Tool const& before, Tool const& after,
                                       scene::Scene const& scene)
        = nullptr;
    // The tool with the options that the active plant was drawn with; no value: with none of its
    // kind. Null: there is no such thing.
    std::optional<Tool> (*like_drawn)(Tool const& tool, scene::Scene const& scene) = nullptr;

    // What is said in place of `done`, given the scene as the stroke has left it. No value, or an
    // empty text: `done`.
    std::string (*said)(Tool const& tool, scene::Scene const& after) = nullptr;

    // What shows what a stroke under way would do. No value: nothing.
    std::unique_ptr<StrokePreviewer> (*previewer)() = nullptr;
    // Where each step ends by which something grows along a stroke, as far as that is drawn, for
    // other programs to follow. World frame, mm. No value: nothing grows in steps.
    std::vector<Vec3> (*steps)(Tool const& tool, Stroke const& stroke, scene::Scene const& scene)
        = nullptr;
    // Whether the branches that a stroke under way runs over are marked. No value: never.
    bool (*marks_branches)(Tool const& tool) = nullptr;
    // The branch that the next stroke shapes, where that is not what is selected. No value: it is.
    std::vector<SegmentId> (*aims_at)(scene::Scene const& scene) = nullptr;
    OtherEnd other_end {};
};

// The kinds of tools that a program has, in the order of their buttons. No two have the same word.
// The first is in hand until another is chosen.
using ToolKinds = std::span<ToolKind const* const>;

// Null if there is none.
ToolKind const* find_tool_kind(ToolKinds kinds, std::string_view word);

// A struct of options whose tools have a kind: its static member kKind.
template<typename T>
concept ToolFields = requires
{
    {
        T::kKind
        } -> std::convertible_to<ToolKind const&>;
};

} // namespace tractus::tools
