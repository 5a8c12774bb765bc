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
#include "app/view/tour_view.h"
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
        float width_mm = 1; // Width of the ink, which follows pressure and nib.
    };
    std::vector<Point> points;
    tools::InkStyle::Look look = tools::InkStyle::Look::Line;
};

// A stroke or indicator whose branch the plant no longer has.
struct OrphanView {
    enum class Kind { Stroke, Indicator } kind = Kind::Stroke;
    scene::ItemId id = 0;
    std::string name; // Display name, for example "stroke 3".
    // Former place of the orphan's branch: "up to segment 6 of branch 2 at segment 4 of stem 1".
    std::string place;
};

// A curve that the user drew and from which the active plant is made.
struct DrawnCurveView {
    // Number of the edit that drew the curve; see tools::DrawnCurve, also for `name`.
    std::uint64_t edit = 0;
    std::string name {};
    InkLine line {};
    // Paths of the branches that the stroke shapes, or of the limb that it became (see PickCurve).
    // Empty for other curves.
    std::vector<PathAddress> paths {};
    bool is_selected = false; // True if one of `paths` shares a segment with the selection.
};

// A stroke that was refused and has no effect.
struct RefusedStroke {
    InkLine ink {};
    tools::Surface surface = tools::Surface::Space; // Surface on which the stroke was drawn.
    std::string why {}; // Sentence that tells the user why the stroke was refused.
};

// The lines of a layer for the active plant. World frame.
struct ShownLayer {
    tools::Layer const* layer = nullptr; // The layer; never null.
    std::vector<std::vector<Vec3f>> lines_mm;
    double strength = 1; // Opacity; at 0 the lines are invisible.

    bool operator==(ShownLayer const&) const = default;
};

// The picture behind the drawing.
struct ShownPicture {
    // The picture, reduced to a moderate size; never null. Immutable and shared.
    std::shared_ptr<render::Image const> image;
    scene::PicturePlace place {};
};

// The state of the pen, as the window shows it. World frame.
struct PenView {
    // True if the pen is in range of the tablet. If false, the other members have no meaning.
    bool in_range = false;
    bool touching = false;
    Vec3f tip_mm = Vec3f::Zero();
    bool eraser = false;
    bool pressing = false; // True if the pen operates a control of the window instead of drawing.
    bool barrel = false;   // True if the pen's first button is pressed.
};

// Growth settings chosen by the user.
struct GrowthView {
    // One of growth_presets(). Empty for parameters that belong to no preset, such as some set on
    // the command line; in a command, empty leaves the parameters unchanged.
    std::string preset;
    // Factor on random variation, from 0 (as drawn) to 4; see at_variability().
    double variability = 1;
    double age = 1; // Age of the plant, from 0 to 1 (fully grown).
};

// A variation of the plant that the user can choose.
struct VariationView {
    std::uint64_t seed = 0;
    // Coarse mesh. Immutable; shared between copies.
    std::shared_ptr<mesh::Mesh const> mesh;
};

// The log in which the devices are being recorded.
struct RecordingView {
    // True while recording. If false, the other members describe the last recording.
    bool is_on = false;
    // Name of the log's file; the status also names its folder. Empty before the first recording.
    std::string file;
    std::uint64_t bytes = 0; // Size of the log, updated a few times a second.
};

// The devices in use, and problems of these devices or of the computer.
struct DevicesView {
    // Latest raw values and statistics of each device.
    std::vector<diagnosis::DeviceReading> readings;
    std::vector<diagnosis::Finding> findings; // Empty if there is no problem.
};

// Everything that the window shows at a given moment. Each revision number changes exactly when the
// values that follow it change; unchanged values are not uploaded or drawn again.
struct WindowState {
    std::string title; // Title of the window; empty: the title does not change.

    // Endings of the files as which a plant can be exported (batch::plant_formats()), most usual
    // first.
    std::vector<std::string> export_endings { ".glb" };

    // Volume that the pen can reach, in the world frame. Its z ranges from the lowest to the
    // highest position of the surface.
    Bounds volume_mm;

    std::uint64_t live_revision = 0;
    double surface_height_mm = 0; // Height of the surface in the world frame.
    // True if the height is extrapolated, beyond the range in which the rig was calibrated.
    bool is_outside_calibration = false;
    PenView pen;
    // States of the pen since the last advance(), in order.
    std::vector<PenView> pen_path;
    std::vector<InkLine> live_ink; // Ink of strokes in progress.
    // The last stroke if it was refused; no value once the next stroke begins. Changes with
    // live_revision.
    std::optional<RefusedStroke> refused {};

    std::uint64_t strokes_revision = 0;
    std::vector<InkLine> strokes; // Ink of finished strokes.

    // Curves of the strokes that have an effect, and curves of the methods' lists, in the order in
    // which they were drawn.
    std::uint64_t curves_revision = 0;
    std::vector<DrawnCurveView> curves;

    std::uint64_t skeleton_revision = 0;
    std::vector<tools::SkeletonLine> skeleton;
    std::vector<ShownLayer> layers; // The visible layers. They also change with strokes_revision.
    // Bounding box of the whole plant, in the plant's frame. The selection view zooms to it.
    // While a stroke makes the first plant, a box around the preview (steady_frame.h).
    Bounds skeleton_box_mm;
    // Transform from the skeleton's frame, the plant's, to the world frame.
    Eigen::Affine3f T_world_plant = Eigen::Affine3f::Identity();
    std::uint64_t picture_revision = 0;
    // Picture behind the drawing; no value if there is none or it is still being decoded.
    std::optional<ShownPicture> picture {};
    scene::Paper paper {}; // Sheet on which some tools draw. Changes with strokes_revision.
    // True if the pad shows the sheet although the tool's strokes may also lie in space
    // (tools::ToolKind::may_draw_on_paper).
    bool is_paper_upright = false;

    std::uint64_t plant_revision = 0;
    // Mesh of the plants grown last; null before the first. Valid until the next advance() or
    // settle().
    mesh::Mesh const* plant = nullptr;
    // True if `plant` is the first of an empty sheet, as far as the stroke in progress has drawn
    // it.
    bool is_first_plant_drawn = false;
    double first_plant_scale = 1; // World millimetres per millimetre of that plant.
    // True while a newer plant is being grown in the background. `plant` is the old one until then.
    bool is_growing = false;
    // Those segments of the grown active plant that are below the ground, except roots.
    // `underground_mm` contains a line of two points for each, in the plant's frame. `underground`
    // is a message such as "growth takes 12 of 632 segments below the ground", or empty if growth
    // takes none there. Both change with plant_revision.
    std::vector<std::vector<Vec3f>> underground_mm {};
    std::string underground {};
    // True if plants bend along the ground instead of growing into it; see SetAlongGround.
    bool along_ground = false;
    GrowthView growth; // Growth settings that were requested last.
    // Season in which the document is shown; no value: none.
    std::optional<scene::Season> season {};

    // Those of the variations requested last that have been grown so far; they arrive one by one.
    std::uint64_t collection_revision = 0;
    std::vector<VariationView> collection;
    std::size_t collection_wanted = 0;
    // Individual differences of the variations, in addition to growth.
    variation::Individuality individuality = variation::kPlantsOfOneBed;

    // Branches that the stroke in progress would move if it ended now, in their new shape and in
    // the plant's frame.
    std::uint64_t preview_revision = 0;
    std::vector<tools::SkeletonLine> preview;
    // Paper on which the previewed plant would stand; no value if it is not drawn on paper.
    std::optional<scene::Paper> preview_paper {};
    std::string preview_note; // Text that is shown instead of the status; empty: none.

    // Strokes and indicators whose branch is missing, so that they have no effect until it appears
    // again. Changes with skeleton_revision.
    std::vector<OrphanView> orphans;

    std::uint64_t devices_revision = 0;
    DevicesView devices; // State of the devices; empty unless requested by WatchDevices.

    tools::ToolKinds tools {}; // Tools that can be selected.
    tools::Tool hand;          // The tool that is selected for the pen.
    // The drawn gizmo (DrawnGizmoKind) of the current tool. No value if the tool has none, or if
    // nothing was drawn with it. Changes with live_revision.
    std::optional<tools::Gizmo> drawn_gizmo {};
    // The user's own cards (presets) for the current kind of tool.
    std::vector<tools::ToolCard> cards {};
    // Tools that the other end of the pen uses, if they were selected before, with their last
    // options.
    std::vector<tools::Tool> remembered {};
    std::string tool;   // Display name of the current tool, for example "Draw".
    std::string status; // One line that says what is happening or what was done.
    // One line about a problem with a device and its remedy, shown instead of the status. Empty if
    // there is no problem.
    std::string trouble;
    // Step of the tour; no value if there is no tour. Changes with live_revision.
    std::optional<TourView> tour {};
    // True if real devices are read. There is then no playback to pause. The mouse is ignored while
    // a pen is in range, as the window system reports the pen as a mouse, too.
    bool is_live = false;
    // `mouse_draws`: there is no tablet, and the mouse acts as the pen. `mouse_moves_surface`:
    // there is no height sensor, and the mouse wheel and keys move the surface.
    bool mouse_draws = false;
    bool mouse_moves_surface = false;
    // True if a simulated hand draws, with its own tools. Its pen does not operate the window.
    bool is_hand_simulated = false;
    // True if the user draws with the pen of a tablet.
    bool has_pen() const { return is_live && !mouse_draws && !is_hand_simulated; }
    RecordingView recording; // State of the recording. Has a meaning only if is_live.
    // True while pictures or exports are being written in the background. Afterwards the status
    // gives the path or the error.
    bool is_saving = false;
    // True if there is a height sensor, so that OpenCalibration is available.
    bool may_calibrate = false;
    bool may_begin_anew = false; // True if OpenStartPage is available.
    // Name of the drawing; no value if the drawing has no file.
    std::optional<std::string> drawing_name {};
    bool may_write_rules = false; // True if WriteRules is available.
    // True if the drawing is saved in a file. Undo also works without a file.
    bool has_session = false;
    std::size_t unsaved_steps = 0; // Number of shown steps that are not saved on disk yet.
    double progress = 0; // Position of playback in the recording, from 0 (start) to 1 (end).
    bool playing = true;
    double speed = 1;       // Speed of playback; 1 is real time.
    std::uint64_t seed = 0; // Seed of the variation that is shown.

    // Returns the width and depth of the tablet's active area, in the world frame.
    Vec2 surface_size_mm() const { return (volume_mm.max_mm - volume_mm.min_mm).head<2>(); }
};

// Commands of the user to the window's model.
struct SetPlaying {
    bool playing = true;
};
struct SetSpeed {
    double speed = 1; // Speed of playback, 0.25 to 4; 1 is real time.
};
struct Restart { };       // Restarts the recording or the drawing from its beginning.
struct NextVariation { }; // Shows the variation with the next seed.
// Changes the growth settings. While a slider moves, the change is only previewed; when the slider
// is released, it becomes a step that can be undone.
struct ChangeGrowth {
    GrowthView growth;
    enum class Slider { Moving, Released } slider = Slider::Released;
};
// Changes the season in which all plants are shown. No value: no season, so that leaves look as in
// the plants' models. While a slider moves, the change is only previewed, as in ChangeGrowth.
struct ChangeSeason {
    std::optional<scene::Season> season {};
    ChangeGrowth::Slider slider = ChangeGrowth::Slider::Released;
};
struct RequestCollection {
    std::size_t count = 12; // Number of variations; 0 closes the collection.
    variation::Individuality individuality = variation::kPlantsOfOneBed;
};
// Replaces the plant by a variation. The plant gets the variation's growth and, if a model's
// stochastic rules have their own seed there, its branches. It does not get the variation's size,
// orientation, age, leaf size or missing and duplicated branches.
struct PickVariation {
    std::uint64_t seed = 1; // Seed of the variation that becomes the plant.
};
// From now on, shows and exports plants that bend along the ground instead of growing into it, or
// no longer. This is not saved in the drawing.
struct SetAlongGround {
    bool is_on = true;
};
// Saves a picture in the background. The file's name contains the plant's name and the date; the
// status reports its path or the error. See WindowState::is_saving.
struct SavePicture {
    render::Image picture; // The plant as the window shows it.
};
// Exports the plant with its current growth and age. Growth that is only previewed is ignored.
struct ExportPlant {
    std::string ending = ".glb"; // The format's, one of WindowState::export_endings.
    exports::GlbOptions::Organs organs = exports::GlbOptions::Organs::Merged;
};
// Begins or ends a log of all reports of the devices and of tool changes. The file's name contains
// the plant's name and the date. See WindowState::recording. Only allowed if WindowState::is_live.
struct SetRecording {
    bool is_on = true;
};
struct ChooseTool {
    tools::Tool tool; // Tool that is used from now on.
};
// Sets the numbers of the current tool. What was drawn with the tool is adapted (ToolKind::follow).
// While a slider or handle moves, the change is only previewed, as in ChangeGrowth.
struct AdjustTool {
    tools::Tool tool;
    ChangeGrowth::Slider slider = ChangeGrowth::Slider::Released;
};
// Drags a handle of WindowState::drawn_gizmo to a place, or presses the handle. While it moves, the
// change is only previewed, as in ChangeGrowth.
struct DragDrawnGizmo {
    std::size_t handle = 0;
    Vec2 to = Vec2::Zero();
    ChangeGrowth::Slider slider = ChangeGrowth::Slider::Released;
};
// Commands for the user's own cards: KeepCard saves the current tool as a card with a generated
// name, RenameCard renames a card, RemoveCard deletes one. The status reports success or the error.
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
struct Undo { }; // Undoes the last step, such as a stroke, a variation or a change of growth.
struct Redo { }; // Redoes the step that was undone last.
// Saves and closes the drawing and shows WindowModel::start_page(). If something cannot be saved,
// the status says so and the drawing stays open, as for WindowModel::may_close().
struct OpenStartPage { };
// Commands for the drawing's name. NameDrawing renames the drawing. SaveCopy copies it to a new
// file with the given name, in the user's folder of drawings; drawing continues in the current
// file. Both are only allowed if WindowState::drawing_name has a value. The status reports success
// or the error.
struct NameDrawing {
    std::string name;
};
struct SaveCopy {
    std::string name;
};
// Writes the rules of the active plant's model to files in a new folder. From then on, whenever the
// user saves the rules there, they are read again. Only allowed if WindowState::may_write_rules.
// The status reports the folder or the error.
struct WriteRules { };
// Selects the branches that a curve of WindowState::curves shapes, as a step that can be undone. If
// the curve shapes no branches, the status only names it.
struct PickCurve {
    std::size_t curve = 0; // Index in WindowState::curves.
};
struct TakeOrphansAway { }; // Removes all WindowState::orphans, as a step that can be undone.

// Sets the areas of the surface in which a touch of the pen operates controls of the window instead
// of drawing. World frame, x and y in millimetres.
struct SetPressingAreas {
    std::vector<Eigen::AlignedBox2d> areas;
};
// Makes the current touch operate the window's controls, even if it is outside the pressing areas.
struct PressInstead { };

// State of the mouse while it acts as the pen. World frame, x and y in millimetres.
struct MousePen {
    Vec2 place_mm = Vec2::Zero();
    bool in_range = false;
    bool touching = false;
};
struct MoveMousePen {
    // States since the last MoveMousePen; the last one is the current state.
    std::vector<MousePen> path;
};
struct MoveSurface {
    // Distance by which the surface moves up, in millimetres; negative moves it down.
    double by_mm = 0;
};

// Opens a page of pictures that can be laid behind the drawing; it is then
// WindowModel::start_page().
struct OpenPictures { };
// Lays the picture of a file behind the drawing. If that fails, the status gives the reason.
struct LayPictureFile {
    std::filesystem::path file;
};

// Opens a page of leaves for the active plant; it is then WindowModel::start_page().
struct OpenLeaves { };
// Gives the active plant leaves. The members are as in methods::Foliage (app/methods/all_leaves.h).
struct SetActiveFoliage {
    // Path of a grammar's file, or name of a grammar in the document. Empty: the plant's own
    // leaves.
    std::string leaves {};
    // Drawn leaf that replaces `leaves` if not 0. Later changes of its drawing also change the
    // plant.
    scene::ItemId drawn = 0;
    double age = 0.5;
    lsystem::LeafDamage damage {};
    // Season in which the document is shown from now on; no value: the season does not change.
    std::optional<std::optional<scene::Season>> season {};
};

// Adds a leaf drawn in three views to the active plant, as lines that the pen can edit.
struct BringLeaf {
    // File of the leaf, as for organ_edits() in app/methods/all_organs.h.
    std::filesystem::path file {};
};

// Commands for the tour (WindowState::tour). BeginTour lets a simulated hand draw a tree in the
// drawing, which should be empty; its devices replace the user's until it is over. SkipTourStep
// goes on to the next step. EndTour ends the tour at any step; what was drawn stays.
struct BeginTour { };
struct SkipTourStep { };
struct EndTour { };

struct WatchDevices {
    // True: DevicesView is filled and updated about ten times a second. False: it stays empty.
    bool watched = true;
};
struct OpenCalibration { }; // Shows WindowModel::calibration() for the devices in use.
struct CloseCalibration { };

using WindowCommand = std::variant<
    SetPlaying, SetSpeed, Restart, NextVariation, SavePicture, ChooseTool, Undo, Redo, ChangeGrowth,
    RequestCollection, PickVariation, SetPressingAreas, PressInstead, MoveMousePen, MoveSurface,
    ExportPlant, SetRecording, WatchDevices, OpenCalibration, CloseCalibration, TakeOrphansAway,
    OpenStartPage, ChangeSeason, AdjustTool, TakeLikeDrawn, KeepCard, RenameCard, RemoveCard,
    OpenPictures, LayPictureFile, DragDrawnGizmo, OpenLeaves, SetActiveFoliage, BringLeaf,
    NameDrawing, SaveCopy, WriteRules, PickCurve, SetAlongGround, BeginTour, SkipTourStep, EndTour>;

// Supplies the contents of a window. For use on the window's thread only.
class WindowModel {
public:
    virtual ~WindowModel() = default;

    // Advances the model by `real_step`, measured in the user's time.
    virtual void advance(Duration real_step) = 0;

    // Waits until all background work is done, so that the state depends only on earlier calls and
    // not on the speed of the machine. For tests and pictures.
    virtual void settle() { }

    // Called when the user wants to close the window. Finishes and saves the drawing. Returns false
    // if something cannot be saved: the status says so, drawing continues, and a second attempt
    // closes the window anyway.
    virtual bool may_close() { return true; }

    // Called when the window closes, as the last call. Finishes and saves the drawing, and waits
    // for files that are being written. Fails with the first error if something cannot be saved.
    virtual Result<void> close() { return {}; }

    // Returns the state after the last advance(), settle() or perform(). Valid until one of these
    // is called again.
    virtual WindowState const& state() const = 0;

    virtual void perform(WindowCommand const& command) = 0;

    // Returns the page to show instead of a drawing, or null.
    virtual StartPageModel* start_page() { return nullptr; }

    // Returns the calibration to show instead of a drawing, or null.
    virtual calibration::CalibrationModel* calibration() { return nullptr; }
};

} // namespace tractus::view
