#pragma once

#include "app/calibration/calibration_view.h"
#include "app/diagnosis/device_monitor.h"
#include "app/diagnosis/finding.h"
#include "app/render/image.h"
#include "app/tools/gizmo.h"
#include "app/tools/layer.h"
#include "app/tools/skeleton_line.h"
#include "app/tools/tool.h"
#include "app/tools/tool_cards.h"
#include "app/view/start_page.h"
#include "engine/base/time.h"
#include "engine/export/glb_writer.h"
#include "engine/lsystem/view/leaf_word.h"
#include "engine/mesh/mesh.h"
#include "engine/plant/branch_address.h"
#include "engine/plant/plant.h"
#include "engine/scene/back_picture.h"
#include "engine/scene/paper.h"
#include "engine/scene/season.h"
#include "engine/variation/individual.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace tractus::view {

// A line that the pen has drawn or is drawing. World frame.
struct InkLine {
    struct Point {
        Vec3f position_mm = Vec3f::Zero();
        float width_mm = 1; // Depends on pressure and nib.
    };
    std::vector<Point> points;
    tools::InkStyle::Look look = tools::InkStyle::Look::Line;
};

// A stroke or indicator whose branch the plant no longer has.
struct OrphanView {
    enum class Kind { Stroke, Indicator } kind = Kind::Stroke;
    scene::ItemId id = 0;
    std::string name; // The orphan's name, for example "stroke 3".
    // Former place of its branch: "up to segment 6 of branch 2 at segment 4 of stem 1".
    std::string place;
};

// A curve that the user drew and that the active plant is made of.
struct DrawnCurveView {
    // Number of the edit that drew the curve; see tools::DrawnCurve for this and `name`.
    std::uint64_t edit = 0;
    std::string name {};
    InkLine line {};
    // Paths of the branches that the stroke shapes, or of the limb that it became (see PickCurve);
    // otherwise empty.
    std::vector<PathAddress> paths {};
    bool is_selected = false; // True if one of `paths` shares a segment with the selection.
};

// A stroke that had no effect.
struct RefusedStroke {
    InkLine ink {};
    tools::Surface surface = tools::Surface::Space; // Surface on which the stroke was drawn.
    std::string why {}; // Sentence for the user that says why the stroke was refused.
};

// A layer's lines for the active plant. World frame.
struct ShownLayer {
    tools::Layer const* layer = nullptr; // The layer; never null.
    std::vector<std::vector<Vec3f>> lines_mm;
    double strength = 1; // Opacity; at 0 the lines are invisible.

    bool operator==(ShownLayer const&) const = default;
};

// The picture behind the drawing.
struct ShownPicture {
    // The picture, of moderate size; never null. Immutable and shared.
    std::shared_ptr<render::Image const> image;
    scene::PicturePlace place {};
};

// The pen's state as the window shows it. World frame.
struct PenView {
    bool in_range = false; // If false, the other members are meaningless.
    bool touching = false;
    Vec3f tip_mm = Vec3f::Zero();
    bool eraser = false;
    bool pressing = false; // The pen operates a control of the window instead of drawing.
    bool barrel = false;   // The pen's first button is pressed.
};

// Growth settings chosen by the user.
struct GrowthView {
    // One of growth_presets(), or empty for growth parameters that have no preset (set on the
    // command line, for example). In a command, empty keeps the parameters.
    std::string preset;
    double variability = 1; // 0, as drawn, to 4; see at_variability().
    double age = 1;         // 0 to 1, where 1 is fully grown.
};

// A variation of the plant that the user can pick.
struct VariationView {
    std::uint64_t seed = 0;
    // Coarse mesh. Immutable; shared between copies.
    std::shared_ptr<mesh::Mesh const> mesh;
};

// The log that records the devices.
struct RecordingView {
    bool is_on = false; // If false, the other members describe the last recording.
    std::string file;   // File name; the status names the folder. Empty before the first recording.
    std::uint64_t bytes = 0; // Size of the log, updated a few times a second.
};

// The devices in use, and problems of the devices or the computer.
struct DevicesView {
    std::vector<diagnosis::DeviceReading> readings; // Latest raw values.
    std::vector<diagnosis::Finding> findings;       // Empty if there is no problem.
};

// Everything that the window shows at one moment. A revision number changes exactly when the values
// after it do; unchanged values are not uploaded or drawn again.
struct WindowState {
    std::string title; // Window title; empty: unchanged.

    // Volume that the pen can reach, in the world frame; z spans the surface's lowest to highest
    // position.
    Bounds volume_mm;

    std::uint64_t live_revision = 0;
    double surface_height_mm = 0; // Height of the surface in the world frame.
    bool is_outside_calibration
        = false; // True if the height is extrapolated, as the rig was never calibrated there.
    PenView pen;
    // The pen's states since the last advance(), in order.
    std::vector<PenView> pen_path;
    std::vector<InkLine> live_ink; // Ink of strokes in progress.
    // The last stroke, if it was refused, until the next one begins. Changes with live_revision.
    std::optional<RefusedStroke> refused {};

    std::uint64_t strokes_revision = 0;
    std::vector<InkLine> strokes; // Ink of finished strokes.

    // Curves of strokes in effect and of the methods' lists, in the order in which they were drawn.
    std::uint64_t curves_revision = 0;
    std::vector<DrawnCurveView> curves;

    std::uint64_t skeleton_revision = 0;
    std::vector<tools::SkeletonLine> skeleton;
    std::vector<ShownLayer> layers; // Visible layers. Also changes with strokes_revision.
    // Bounding box of the whole plant, to which the selection view zooms. Plant frame.
    Bounds skeleton_box_mm;
    // Transforms the skeleton to the world frame.
    Eigen::Affine3f T_world_plant = Eigen::Affine3f::Identity();
    std::uint64_t picture_revision = 0;
    // Picture behind the drawing; no value: there is none, or it is still being decoded.
    std::optional<ShownPicture> picture {};
    scene::Paper paper {}; // Sheet for tools that draw on paper. Changes with strokes_revision.

    std::uint64_t plant_revision = 0;
    // The newest mesh; null before the first one. Valid until the next advance() or settle().
    mesh::Mesh const* plant = nullptr;
    // True while a newer plant is being grown in the background; until then the last one is shown.
    bool is_growing = false;
    // Segments of the active plant as grown, except roots, that are below the ground: lines of two
    // points in the plant frame, and a message such as "growth takes 12 of 632 segments below the
    // ground", which is empty if growth takes none there. Change with plant_revision.
    std::vector<std::vector<Vec3f>> underground_mm {};
    std::string underground {};
    bool along_ground = false; // Plants bend along the ground instead of into it; SetAlongGround.
    GrowthView growth;         // Growth settings requested last.
    std::optional<scene::Season> season {}; // The document's season.

    // Variations requested last, as far as they have been grown; they arrive one by one.
    std::uint64_t collection_revision = 0;
    std::vector<VariationView> collection;
    std::size_t collection_wanted = 0;
    // How the variations differ in addition to growth.
    variation::Individuality individuality = variation::kPlantsOfOneBed;

    // Branches that the stroke in progress would move if it ended now, in their new shape. Plant
    // frame.
    std::uint64_t preview_revision = 0;
    std::vector<tools::SkeletonLine> preview;
    std::string preview_note; // Shown in place of the status; empty: no note.

    // Strokes and indicators that have no effect until their branch reappears. Changes with
    // skeleton_revision.
    std::vector<OrphanView> orphans;

    std::uint64_t devices_revision = 0;
    DevicesView devices; // State of the devices; empty unless WatchDevices requests it.

    tools::ToolKinds tools {}; // Tools that can be selected.
    tools::Tool hand;          // The tool that the pen uses now.
    // The drawn gizmo (DrawnGizmoKind) of the current tool; no value if it has none or nothing was
    // drawn with it. Changes with live_revision.
    std::optional<tools::Gizmo> drawn_gizmo {};
    std::vector<tools::ToolCard> cards {}; // The user's presets for the current kind of tool.
    // Tools for the pen's other end that were selected before, with their last options.
    std::vector<tools::Tool> remembered {};
    std::string tool;   // Name of the current tool for the user, for example "Draw".
    std::string status; // One line about what is happening or was done.
    // One line about a problem with a device and what to do about it. Replaces the status; empty if
    // there is none.
    std::string trouble;
    // True if real devices are read. Then there is no playback to pause, and the mouse is ignored
    // while a pen is in range, as the window system reports that pen as a mouse.
    bool is_live = false;
    // The mouse acts as the pen if there is no tablet. The mouse wheel and keys move the surface if
    // there is no height sensor.
    bool mouse_draws = false;
    bool mouse_moves_surface = false;
    // A simulated hand draws with its own tools; its pen does not operate the window.
    bool is_hand_simulated = false;
    // True if the user holds a tablet's pen.
    bool has_pen() const { return is_live && !mouse_draws && !is_hand_simulated; }
    RecordingView recording; // State of the recording; meaningful only if is_live.
    // Pictures or exports are being written in the background. The status will report the path or
    // the error.
    bool is_saving = false;
    bool may_calibrate = false;  // True if there is a height sensor; see OpenCalibration.
    bool may_begin_anew = false; // True if OpenStartPage is available.
    // Name of the drawing; no value if it has no file.
    std::optional<std::string> drawing_name {};
    bool may_write_rules = false; // True if WriteRules is available.
    bool has_session = false;     // True if the drawing is saved in a file. Undo works without one.
    std::size_t unsaved_steps = 0; // Steps shown that are not on disk yet.
    double progress = 0;           // Playback position in the recording, 0 to 1.
    bool playing = true;
    double speed = 1;       // Playback speed of the recording; 1 is real time.
    std::uint64_t seed = 0; // Seed of the current variation.

    // Width and depth of the tablet's active area. World frame.
    Vec2 surface_size_mm() const { return (volume_mm.max_mm - volume_mm.min_mm).head<2>(); }
};

// Commands of the user to the window's model follow.
struct SetPlaying {
    bool playing = true;
};
struct SetSpeed {
    double speed = 1; // Playback speed, 0.25 to 4.
};
struct Restart { };       // Restarts the recording or the drawing from its start.
struct NextVariation { }; // Selects the variation with the next seed.
// Changes the growth. While a slider moves, the change is only previewed; its release makes it an
// undoable step.
struct ChangeGrowth {
    GrowthView growth;
    enum class Slider { Moving, Released } slider = Slider::Released;
};
// Changes the season that all plants show; no value: leaves look as in the plants' models. While a
// slider moves, the change is only previewed, as for growth.
struct ChangeSeason {
    std::optional<scene::Season> season {};
    ChangeGrowth::Slider slider = ChangeGrowth::Slider::Released;
};
struct RequestCollection {
    std::size_t count = 12; // Number of variations; 0 closes the collection.
    variation::Individuality individuality = variation::kPlantsOfOneBed;
};
// Replaces the plant with a variation: takes over its growth and, where a model's stochastic rules
// have their own seed, its branches. Size, orientation, age, leaf size and missing or duplicated
// branches are not taken over.
struct PickVariation {
    std::uint64_t seed = 1; // Seed of the variation that becomes the plant.
};
// Bends plants along the ground instead of into it, in what is shown and exported from now on. The
// drawing does not keep it.
struct SetAlongGround {
    bool is_on = true;
};
// Saves a picture in the background. The receiver names the file after plant and date, and the
// status reports its path or an error; see WindowState::is_saving.
struct SavePicture {
    render::Image picture; // The plant as shown in the window.
};
// Exports the plant at its current growth and age; a growth that is only previewed does not count.
struct ExportPlant {
    enum class Format {
        Glb,
        Obj,
        Mtg, // Branches and organs without triangles, for botanical software.
    } format
        = Format::Glb;
    exports::GlbOptions::Organs organs = exports::GlbOptions::Organs::Merged;
};
// Starts a new log of everything the devices send and of tool changes, named after plant and date,
// or ends it. See WindowState::recording. Only if WindowState::is_live.
struct SetRecording {
    bool is_on = true;
};
struct ChooseTool {
    tools::Tool tool; // Tool to use from now on.
};
// Sets the current tool's numbers. What was drawn with the tool is adapted (ToolKind::follow);
// while a slider or handle moves, that is only previewed, as for growth.
struct AdjustTool {
    tools::Tool tool;
    ChangeGrowth::Slider slider = ChangeGrowth::Slider::Released;
};
// Drags a handle of WindowState::drawn_gizmo to a place, or presses it. While it moves, the change
// is only previewed, as for growth.
struct DragDrawnGizmo {
    std::size_t handle = 0;
    Vec2 to = Vec2::Zero();
    ChangeGrowth::Slider slider = ChangeGrowth::Slider::Released;
};
// Commands for the user's own presets: save the current tool as a preset with a generated name,
// rename a preset, or delete one. The status reports success or the error.
struct KeepCard { };
struct RenameCard {
    std::string from;
    std::string to;
};
struct RemoveCard {
    std::string name;
};
// Gives the current tool the options with which the active plant was drawn.
struct TakeLikeDrawn { };
struct Undo { }; // Undoes the last step: a stroke, variation, change of growth, or anything else.
struct Redo { }; // Redoes the step undone last.
// Closes and saves the drawing and shows WindowModel::start_page(). If something cannot be saved,
// the status says so and the drawing stays open, as in may_close().
struct OpenStartPage { };
// Commands for the drawing's name: NameDrawing renames it; SaveCopy copies it to a new file of that
// name in the user's drawings folder, and drawing continues in the present one. Only if
// WindowState::drawing_name is set. The status reports success or the error.
struct NameDrawing {
    std::string name;
};
struct SaveCopy {
    std::string name;
};
// Writes the rules of the active plant's model into a folder of their own, and from then on reloads
// the rules whenever the user saves them there. Only if WindowState::may_write_rules. The status
// reports the folder or the error.
struct WriteRules { };
// Selects the branches that one of WindowState::curves shapes, a step that can be undone; for a
// curve that shapes none the status only names it.
struct PickCurve {
    std::size_t curve = 0; // Index in WindowState::curves.
};
struct TakeOrphansAway { }; // Removes all of WindowState::orphans, as an undoable step.

// Areas of the surface where a touch of the pen operates the window's controls instead of drawing.
// World frame, x and y in millimetres.
struct SetPressingAreas {
    std::vector<Eigen::AlignedBox2d> areas;
};
// Makes the current touch operate the controls, too, even outside the pressing areas.
struct PressInstead { };

// State of the mouse when it acts as the pen. World frame, x and y in millimetres.
struct MousePen {
    Vec2 place_mm = Vec2::Zero();
    bool in_range = false;
    bool touching = false;
};
struct MoveMousePen {
    std::vector<MousePen> path; // States since the last such command, the current one last.
};
struct MoveSurface {
    double by_mm = 0; // Distance in millimetres; positive is up.
};

// Opens a page of pictures to lay behind the drawing, as WindowModel::start_page().
struct OpenPictures { };
// Lays a picture file behind the drawing, or reports in the status why that fails.
struct LayPictureFile {
    std::filesystem::path file;
};

// Opens a page of leaves for the active plant, as WindowModel::start_page().
struct OpenLeaves { };
// Gives the active plant leaves; members as in Foliage in app/methods/all_leaves.h.
struct SetActiveFoliage {
    // Path of a grammar file, or its name in the document; empty: the plant's own leaves.
    std::string leaves {};
    // If not 0: the drawn leaf to wear instead of `leaves`; later changes of its drawing apply.
    scene::ItemId drawn = 0;
    double age = 0.5;
    lsystem::LeafDamage damage {};
    // New season of the document; no value: unchanged.
    std::optional<std::optional<scene::Season>> season {};
};

// Adds a leaf in three views to the active plant, as lines that can be edited with the pen.
struct BringLeaf {
    std::filesystem::path file {}; // File as for organ_edits() in app/methods/all_organs.h.
};

struct WatchDevices {
    bool watched = true; // True: fill DevicesView and update it about ten times a second.
};
struct OpenCalibration { }; // Shows WindowModel::calibration(), with the devices in use.
struct CloseCalibration { };

using WindowCommand
    = std::variant<SetPlaying, SetSpeed, Restart, NextVariation, SavePicture, ChooseTool, Undo,
                   Redo, ChangeGrowth, RequestCollection, PickVariation, SetPressingAreas,
                   PressInstead, MoveMousePen, MoveSurface, ExportPlant, SetRecording, WatchDevices,
                   OpenCalibration, CloseCalibration, TakeOrphansAway, OpenStartPage, ChangeSeason,
                   AdjustTool, TakeLikeDrawn, KeepCard, RenameCard, RemoveCard, OpenPictures,
                   LayPictureFile, DragDrawnGizmo, OpenLeaves, SetActiveFoliage, BringLeaf,
                   NameDrawing, SaveCopy, WriteRules, PickCurve, SetAlongGround>;

// Supplies a window's contents. For use on the window's thread only.
class WindowModel {
public:
    virtual ~WindowModel() = default;

    // Advances by `real_step` of the user's time.
    virtual void advance(Duration real_step) = 0;

    // Waits until all background work is done, so that the state depends only on what happened
    // before and not on the speed of the machine. For tests and pictures.
    virtual void settle() { }

    // Called when the user wants to close the window: finishes and saves the drawing. Returns false
    // if something cannot be saved: the status says so, drawing continues, and the user may close
    // anyway on a second try.
    virtual bool may_close() { return true; }

    // Called when the window closes: finishes and saves the drawing and waits for files that are
    // being written. No calls follow. Fails with the first error if something cannot be saved.
    virtual Result<void> close() { return {}; }

    // State after the last advance(), settle() or perform(); valid until the next of these calls.
    virtual WindowState const& state() const = 0;

    virtual void perform(WindowCommand const& command) = 0;

    // Page to show before there is a drawing, or null.
    virtual StartPageModel* start_page() { return nullptr; }

    // Calibration to show instead of the state, or null.
    virtual calibration::CalibrationModel* calibration() { return nullptr; }
};

} // namespace tractus::view
