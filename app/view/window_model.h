#pragma once

#include "app/calibration/calibration_view.h"
#include "app/diagnosis/device_monitor.h"
#include "app/diagnosis/finding.h"
#include "app/render/image.h"
#include "app/tools/glyph.h"
#include "app/tools/layer.h"
#include "app/tools/skeleton_line.h"
#include "app/tools/tool.h"
#include "app/tools/tool_cards.h"
#include "app/view/start_page.h"
#include "engine/base/time.h"
#include "engine/export/glb_writer.h"
#include "engine/lsystem/view/leaf_word.h"
#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"
#include "engine/scene/back_picture.h"
#include "engine/scene/paper.h"
#include "engine/scene/season.h"

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

// A line that the pen drew, or is drawing. World frame.
struct InkLine {
    struct Point {
        Vec3f position_mm = Vec3f::Zero();
        float width_mm = 1; // As wide as pressure and nib say.
    };
    std::vector<Point> points;
    tools::InkStyle::Look look = tools::InkStyle::Look::Line;
};

// Something that was drawn on a branch that the plant has lost.
struct OrphanView {
    enum class Kind { Stroke, Indicator } kind = Kind::Stroke;
    scene::ItemId id = 0;
    std::string name; // "stroke 3".
    // Where its branch was: "up to segment 6 of branch 2 at segment 4 of stem 1".
    std::string place;
};

// A stroke that changed nothing.
struct RefusedStroke {
    InkLine ink {};
    tools::Surface surface = tools::Surface::Space; // What it was drawn on.
    std::string why {};                             // A sentence for people.
};

// The lines of a layer for the active plant. World frame.
struct ShownLayer {
    tools::Layer const* layer = nullptr; // Never null.
    std::vector<std::vector<Vec3f>> lines_mm;
    double strength = 1; // Towards 0 they fade into the background.

    bool operator==(ShownLayer const&) const = default;
};

// The picture behind what is drawn.
struct ShownPicture {
    // Never null, and not large. Shared; nobody changes it.
    std::shared_ptr<render::Image const> image;
    scene::PicturePlace place {};
};

// The pen as the window shows it. World frame.
struct PenView {
    bool in_range = false; // Else the rest says nothing.
    bool touching = false;
    Vec3f tip_mm = Vec3f::Zero();
    bool eraser = false;
    bool pressing
        = false;         // It touches what the window shows: it works the window and does not draw.
    bool barrel = false; // The first button on it is held.
};

// How the plant grows, as a person sets it.
struct GrowthView {
    // One of growth_presets(); empty: as nobody has named it (from a command line, say), which a
    // command with an empty name leaves as it is.
    std::string preset;
    double variability = 1; // 0, as drawn, to 4; see at_variability().
    double age = 1;         // 0 to 1, full-grown.
};

// Another plant that the scene may become. Others may show it, too.
struct VariationView {
    std::uint64_t seed = 0;
    // Coarse. Shared by the copies of this; nobody changes it.
    std::shared_ptr<mesh::Mesh const> mesh;
};

// The log into which what the devices send is written.
struct RecordingView {
    bool is_on = false;      // The rest is that of the last one otherwise.
    std::string file;        // Its name; the status says in which folder. Empty before the first.
    std::uint64_t bytes = 0; // What is in it, renewed a few times a second.
};

// The devices that are read, and what is the matter with them or with the machine.
struct DevicesView {
    std::vector<diagnosis::DeviceReading> readings; // With the newest raw values.
    std::vector<diagnosis::Finding> findings;       // Empty if nothing is the matter.
};

// All that the window shows at one moment. Each revision number changes when the values after it
// do, and only then: what did not change is not uploaded or drawn again.
struct WindowState {
    std::string title; // Of the window; empty: as it is.

    // The volume that the pen reaches, world frame; z from the lowest to the highest surface.
    Bounds volume_mm;

    std::uint64_t live_revision = 0;
    double surface_height_mm = 0; // World frame.
    bool is_outside_calibration
        = false; // The height is a guess: the rig was never calibrated there.
    PenView pen;
    // The states that the pen has gone through since the last advance(), in order.
    std::vector<PenView> pen_path;
    std::vector<InkLine> live_ink; // Being drawn now.
    // The last stroke if it was refused, until the next one begins. Changes with live_revision.
    std::optional<RefusedStroke> refused {};

    std::uint64_t strokes_revision = 0;
    std::vector<InkLine> strokes; // Finished.

    std::uint64_t skeleton_revision = 0;
    std::vector<tools::SkeletonLine> skeleton;
    std::vector<ShownLayer> layers; // That have lines; changed with the strokes, too.
    Bounds skeleton_box_mm; // Of the whole plant: what the selection view fits. Plant frame.
    // Puts the skeleton into the volume.
    Eigen::Affine3f T_world_plant = Eigen::Affine3f::Identity();
    std::uint64_t picture_revision = 0;
    std::optional<ShownPicture> picture {}; // No value: there is none, or it is being read.
    scene::Paper paper {}; // That tools draw on which draw on paper. Changes with the strokes.

    std::uint64_t plant_revision = 0;
    // The newest one; null before the first. Lives until the next advance() or settle().
    mesh::Mesh const* plant = nullptr;
    // A newer plant is being grown in the background; meanwhile the last one stays.
    bool is_growing = false;
    GrowthView growth;                      // Of the newest one that was asked for.
    std::optional<scene::Season> season {}; // Of the document.

    // Those that were asked for last, as far as they have been grown; they come one by one.
    std::uint64_t collection_revision = 0;
    std::vector<VariationView> collection;
    std::size_t collection_wanted = 0;

    // The branches that the stroke under way would move if it ended here, as it would shape them.
    // Plant frame.
    std::uint64_t preview_revision = 0;
    std::vector<tools::SkeletonLine> preview;
    std::string preview_note; // Stands in place of the status; empty: there is nothing to say.

    // Strokes and indicators that do nothing until their branch comes back. Changes with
    // skeleton_revision.
    std::vector<OrphanView> orphans;

    std::uint64_t devices_revision = 0;
    DevicesView devices; // Empty unless WatchDevices asks for it.

    tools::ToolKinds tools {}; // That can be chosen.
    tools::Tool hand;          // What the pen means now.
    // What has been drawn with the hand's kind, as it shows that (DrawnGlyphKind); no value: it
    // does not, or nothing has. Changes with live_revision.
    std::optional<tools::Glyph> drawn_glyph {};
    std::vector<tools::ToolCard> cards {}; // A person's own of the hand's kind.
    std::vector<tools::Tool>
        remembered {};  // Tools that are chosen with the options that they had last.
    std::string tool;   // What the pen means, for people, for example "Draw".
    std::string status; // One line: what is going on, or what was done.
    // One line: what is wrong with a device at this moment and what to do about it. Shown in place
    // of the status. Empty if nothing is.
    std::string trouble;
    // Devices are read: there is no recording to be paused, and while a pen is in range the mouse
    // counts for nothing, since the window system takes that pen for one.
    bool is_live = false;
    // There is no tablet: the mouse is the pen. There is no height sensor: wheel and keys move the
    // surface.
    bool mouse_draws = false;
    bool mouse_moves_surface = false;
    // A simulated hand draws, with tools of its own: its pen works nothing of the window.
    bool hand_is_played = false;
    // A person holds a tablet's pen.
    bool has_pen() const { return is_live && !mouse_draws && !hand_is_played; }
    RecordingView recording; // Only if is_live.
    // Pictures and exports are being written in the background; the status will say where to, or
    // why not.
    bool is_saving = false;
    bool may_calibrate = false;  // There is a height sensor: see OpenCalibration.
    bool may_begin_anew = false; // See OpenStartPage.
    // What the drawing is called; no value: no file keeps it.
    std::optional<std::string> drawing_name {};
    bool may_write_rules = false; // See WriteRules.
    bool has_session = false;     // What is drawn is kept in a file. Undo works without one, too.
    std::size_t unkept_steps = 0; // Of what is seen: not on the disk yet.
    double progress = 0;          // Of the recording, 0 to 1.
    bool playing = true;
    double speed = 1;       // Of the recording, 1 as it was made.
    std::uint64_t seed = 0; // Of the present variation.

    // Width and depth of the area in which the pen is felt. World frame.
    Vec2 surface_size_mm() const { return (volume_mm.max_mm - volume_mm.min_mm).head<2>(); }
};

// What a person asks for in the window.
struct SetPlaying {
    bool playing = true;
};
struct SetSpeed {
    double speed = 1; // 0.25 to 4.
};
struct Restart { };       // The recording, or the drawing, from its start.
struct NextVariation { }; // "Another one": the next seed.
// Other growth. While a slider that sets it moves it is only shown; released, it is a step that can
// be undone.
struct ChangeGrowth {
    GrowthView growth;
    enum class Slider { Moving, Released } slider = Slider::Released;
};
// The time of the year that all plants show; no value: as their models have their leaves. While a
// slider that sets it moves it is only shown, as with growth.
struct ChangeSeason {
    std::optional<scene::Season> season {};
    ChangeGrowth::Slider slider = ChangeGrowth::Slider::Released;
};
struct AskForCollection {
    std::size_t count = 12; // 0 takes the present one away.
};
struct PickVariation {
    std::uint64_t seed = 1; // Makes it the plant.
};
// The receiver names the files after plant and date, writes them in the background, and says in the
// status where to, or why not: see WindowState::is_saving.
struct SavePicture {
    render::Image picture; // The plant as the window sees it.
};
// The plant as it grows now, at its age: what a slider only previews does not count.
struct ExportPlant {
    enum class Format {
        Glb,
        Obj,
        Mtg, // Branches as botanists' programs read them.
    } format
        = Format::Glb;
    exports::GlbOptions::Organs organs = exports::GlbOptions::Organs::Merged;
};
// Begins a new log of all that the devices send and of every choice of a tool, named after plant
// and date; or ends it. See WindowState::recording. Only if WindowState::is_live.
struct SetRecording {
    bool is_on = true;
};
struct ChooseTool {
    tools::Tool tool; // What the pen means from now on.
};
// The tool in hand with other numbers. What has been drawn with it follows (ToolKind::follow):
// while a slider or a handle moves that is only shown, as with growth.
struct AdjustTool {
    tools::Tool tool;
    ChangeGrowth::Slider slider = ChangeGrowth::Slider::Released;
};
// A handle of WindowState::drawn_glyph is dragged to a place, or pressed. While it moves that is
// only shown, as with growth.
struct DragDrawnGlyph {
    std::size_t handle = 0;
    Vec2 to = Vec2::Zero();
    ChangeGrowth::Slider slider = ChangeGrowth::Slider::Released;
};
// A person's own cards: the hand's is kept under a name of its own, another one is called otherwise
// or goes away. The status says so, or why not.
struct KeepCard { };
struct RenameCard {
    std::string from;
    std::string to;
};
struct RemoveCard {
    std::string name;
};
// The tool in hand with the options that the active plant was drawn with.
struct TakeLikeDrawn { };
struct Undo { }; // The last stroke, another one, other growth, or what else was done last.
struct Redo { }; // What was undone last.
// Closes the drawing, which is kept, and shows WindowModel::start_page(). Where not all can be kept
// the status says so, and drawing goes on, as with may_close().
struct OpenStartPage { };
// Calls the drawing otherwise, or copies it to a new file, named so, in the folder of a person's
// drawings; drawing goes on in the present one. Only with WindowState::drawing_name. The status
// says so, or why not.
struct NameDrawing {
    std::string name;
};
struct SaveCopy {
    std::string name;
};
// Writes the rules of the active plant's model into a folder of their own, and from then on takes
// what is saved there for its rules. Only with WindowState::may_write_rules. The status says where
// they are, or why not.
struct WriteRules { };
struct TakeOrphansAway { }; // All of WindowState::orphans; a step that can be undone.

// Where on the surface a touch of the pen presses what the window shows there, and does not draw.
// World frame, x and y in millimetres.
struct SetPressingAreas {
    std::vector<Eigen::AlignedBox2d> areas;
};
struct PressInstead { }; // The touch under way does so, too, wherever it began.

// The mouse held as a pen. World frame, x and y in millimetres.
struct MousePen {
    Vec2 place_mm = Vec2::Zero();
    bool in_range = false;
    bool touching = false;
};
struct MoveMousePen {
    std::vector<MousePen> path; // Since the last such command; ends where it is now.
};
struct MoveSurface {
    double by_mm = 0; // Upwards.
};

// Shows pictures to be laid behind what is drawn as WindowModel::start_page().
struct OpenPictures { };
// Lays the picture of a file there, or says in the status why not.
struct LayPictureFile {
    std::filesystem::path file;
};

// Shows leaves that the active plant may have as WindowModel::start_page().
struct OpenLeaves { };
// Gives it leaves: as of Dressing in app/methods/all_leaves.h.
struct DressActivePlant {
    std::string leaves {};   // Their grammar's file, or its name in the document; empty: its own.
    scene::ItemId drawn = 0; // In place of it a drawn leaf, which they follow.
    double age = 0.5;
    lsystem::LeafDamage damage {};
    // The season of the document from then on; no value: as it is.
    std::optional<std::optional<scene::Season>> season {};
};

// Brings a leaf in three views to the active plant, as lines that the pen goes on with.
struct BringLeaf {
    std::filesystem::path file {}; // As of organ_edits() in app/methods/all_organs.h.
};

struct WatchDevices {
    bool watched = true; // Show DevicesView, and keep it new, some ten times a second.
};
struct OpenCalibration { }; // Show WindowModel::calibration(), with the devices that are read.
struct CloseCalibration { };

using WindowCommand
    = std::variant<SetPlaying, SetSpeed, Restart, NextVariation, SavePicture, ChooseTool, Undo,
                   Redo, ChangeGrowth, AskForCollection, PickVariation, SetPressingAreas,
                   PressInstead, MoveMousePen, MoveSurface, ExportPlant, SetRecording, WatchDevices,
                   OpenCalibration, CloseCalibration, TakeOrphansAway, OpenStartPage, ChangeSeason,
                   AdjustTool, TakeLikeDrawn, KeepCard, RenameCard, RemoveCard, OpenPictures,
                   LayPictureFile, DragDrawnGlyph, OpenLeaves, DressActivePlant, BringLeaf,
                   NameDrawing, SaveCopy, WriteRules>;

// Where a window's contents come from. Called from the window's thread only.
class WindowModel {
public:
    virtual ~WindowModel() = default;

    // Lets `real_step` of a person's time pass.
    virtual void advance(Duration real_step) = 0;

    // Waits until nothing is done in the background any more: what the state shows then depends on
    // what came before, and not on how fast this machine is. For tests and pictures.
    virtual void settle() { }

    // A person wants to leave: finishes what is drawn and keeps it. False if something cannot be
    // kept: the status says so, drawing goes on, and who asks once more may leave without it.
    virtual bool may_close() { return true; }

    // The window closes: finishes what is drawn, keeps it, and waits for files that are being
    // written. Nothing comes after this. Fails, with the first reason, if something cannot be kept.
    virtual Result<void> close() { return {}; }

    // As of the last advance(), settle() or perform(); valid until the next.
    virtual WindowState const& state() const = 0;

    virtual void perform(WindowCommand const& command) = 0;

    // What to show before there is a drawing; null for none.
    virtual StartPageModel* start_page() { return nullptr; }

    // The calibration to show in place of the state; null for none.
    virtual calibration::CalibrationModel* calibration() { return nullptr; }
};

} // namespace tractus::view
