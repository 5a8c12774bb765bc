#pragma once

#include "app/station/pressing.h"
#include "app/tools/layer.h"
#include "app/tools/least_extent.h"
#include "app/tools/tool.h"
#include "calib/fuser.h"
#include "calib/height_monitor.h"
#include "calib/rig.h"
#include "drivers/reports/device_info.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/reports/pen_decoder.h"
#include "engine/base/result.h"
#include "engine/plant/plant.h"
#include "engine/stroke/stroke_builder.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tractus::station {

struct StationOptions {
    calib::Rig rig;
    std::optional<calib::ScriptedHeight> scripted_height; // In place of a height sensor.
    bool is_height_watched = true; // False for a height that no sensor measures: the mouse's wheel.
    tools::ToolKinds tools {};     // That there are.
    tools::Layers layers {};       // Likewise.
    // What the pen means until a tool line says otherwise; no value: the first of them.
    std::optional<tools::Tool> tool {};
    tools::LeastExtents least_extents {}; // Of strokes, until set_least_extents() says otherwise.
};

// What came in and what became of it.
struct StationCounts {
    std::size_t reports = 0;
    std::size_t pen_samples = 0;
    std::size_t height_samples = 0;
    std::size_t tips_in_silence = 0; // Live ones of readings, while a pen that touched was silent.
    std::size_t broken_reports = 0;  // A decoder refused them; the first reason is kept.
    std::size_t ignored_reports = 0; // Of devices that are neither the pen nor the height sensor.
    std::size_t strokes = 0;
    std::size_t dabs = 0; // Strokes too short to mean anything, which are not among `strokes`.
    std::string first_broken;
};

// The pen at one moment, as a window wants it that the pen works.
struct PenMoment {
    bool in_range = false;
    bool touching = false;
    bool eraser = false;
    bool pressing = false; // Touches to press what the window shows: no stroke comes of it.
    bool barrel = false;   // The first barrel button is held.
    double pressure = 0;
    Vec3 position_mm = Vec3::Zero(); // World frame; the last known one when out of range.
    Timestamp time {};               // When the pen was there: see TipSample.
    std::optional<Vec2> tilt_rad {}; // Likewise.
    std::size_t device = 0;          // The pen's tablet, by its index among the devices.
};

// The way of the data from reports to strokes: decode, fuse, stroke, and the tool that each is for.
// The only class that knows it. Reports and tool changes go in as they come, from devices or from a
// log, and finished strokes come out; what they mean is the document's (app/document). Not
// thread-safe: it lives on the main thread.
//
// Several tablets may be drawn on at once, each with its own pen and strokes. The rig is the first
// one's; others lie with their centre where the first one's is.
class Station {
public:
    // Takes all devices that decode as pens, and the first that decodes as a height sensor. Fails,
    // as the user's fault, if there is no pen, or neither height sensor nor scripted height.
    static Result<Station> create(std::span<drivers::DeviceInfo const> devices,
                                  StationOptions const& options);

    // One report of one of the devices. A report that its decoder refuses is counted and forgotten.
    // An empty report says that the device went away: a stroke that it was drawing, or whose height
    // it measured, ends there and is kept.
    void push(std::size_t device, Timestamp received, std::span<std::byte const> report);

    // From the pen's samples at `time` on, strokes belong to `tool`, or, where they are drawn with
    // the pen's other end, to what that does then (ToolKind::other_end). One that is done at once
    // is a stroke without tips, and changes nothing in the hand.
    void set_tool(Timestamp time, tools::Tool const& tool);

    // A stroke that gets less far than its tool's least extent is a dab: it does nothing and is
    // counted. For strokes that end from now on.
    void set_least_extents(tools::LeastExtents extents) { least_extents_ = std::move(extents); }
    tools::LeastExtents const& least_extents() const { return least_extents_; }
    // The tool that the last dab was for; null before the first.
    tools::ToolKind const* last_dab() const { return last_dab_; }

    // Where a touch presses what the window shows there, from its beginning to its end, and draws
    // nothing: x and y of the world frame, millimetres. None at first. Such touches are tool
    // changes (pressing()), so that a recording of them draws the same.
    void set_pressing_areas(std::vector<Eigen::AlignedBox2d> areas)
    {
        pressing_areas_ = std::move(areas);
    }

    // The touch under way presses, too, from its beginning on: a long one opens the ring of tools.
    void press_instead();

    // What the pen did since the last call, in order; of more than kMostMoments the newest.
    static constexpr std::size_t kMostMoments = 1024;
    std::vector<PenMoment> take_moments() { return std::exchange(moments_, {}); }

    // A change of what the pen means.
    struct ToolChange {
        Timestamp time {};
        tools::Tool tool;
    };
    // Those since the last call, for a recording.
    std::vector<ToolChange> take_tool_changes() { return std::exchange(new_tool_changes_, {}); }

    // Time has passed without a report: some pens leave by falling silent. Each report passes time
    // by itself; live, call this when all that have come are pushed.
    void pass_time(Timestamp now);

    // No more reports come: settles and finishes what is under way.
    void finish();

    // The strokes that were finished since the last call, in order.
    std::vector<tools::ToolStroke> take_strokes() { return std::exchange(strokes_, {}); }

    // Strokes that the next take_strokes() will give.
    std::vector<tools::ToolStroke> const& new_strokes() const { return strokes_; }

    StationCounts const& counts() const { return counts_; }
    calib::FuserCounts fuser_counts() const; // Of all pens.

    // What is, and was, wrong with the height sensor; nothing if the height is scripted, or is not
    // to be watched.
    calib::HeightMonitor const& height_monitor() const { return height_monitor_; }

    // How the pens' ink looks.
    Nib nib() const { return nib_; }

    // For the screen: the ink of each pen's stroke under way, none of it empty, and none where a
    // pen presses a button; the newest tip of all pens, and what it means. Inks are copies.
    std::vector<std::vector<TipSample>> inks() const;
    std::optional<TipSample> const& newest_tip() const { return newest_tip_; }
    // What the pen reaches: the first tablet's area, and the heights of its calibration. World
    // frame.
    Bounds const& volume_mm() const { return volume_mm_; }

    // As the last reading has it, or where heights are scripted the last tip. No value before.
    std::optional<double> surface_height_mm() const;
    bool pen_in_range() const { return pen_in_range_; }
    // The pen has sent nothing for a while, in which the surface may have moved: many tablets are
    // silent about a pen that rests. Never where heights are scripted.
    bool pen_rests() const;
    tools::Tool const& tool() const { return tool_in_hand_; }
    tools::ToolKinds tools() const { return tools_; } // That there are.
    tools::Layers layers() const { return layers_; }  // Likewise.
    // The tools that other ends of the pen are, as they were chosen last.
    std::vector<tools::Tool> remembered() const;
    // What another station has to be given, in order, for both ends of the pen to mean the same.
    std::vector<tools::Tool> tools_to_go_on_with() const;
    // What these tips of a stroke mean, whether it is finished or under way; without any, what the
    // hand holds.
    tools::Tool meaning_of(std::vector<TipSample> const& tips) const;
    bool is_pressing() const { return tool_changes_.back().tool == pressing(); }

private:
    // One tablet's pen, from its reports to its strokes.
    struct Pen {
        std::size_t device = 0;
        std::unique_ptr<drivers::PenDecoder> decoder;
        drivers::PenSilence silence;
        Vec2 scale; // From the decoder's millimetres to those of the surface as it was measured.
        calib::Fuser fuser;
        StrokeBuilder builder {};
        drivers::PenSample last_sample {};
        std::optional<Timestamp> last_tip {};      // Live, of a sample.
        std::optional<Timestamp> touches_since {}; // Latency included; no value: does not touch.
    };

    explicit Station(StationOptions const& options); // Without devices.

    Result<void> add_pens(std::span<drivers::DeviceInfo const> devices,
                          StationOptions const& options);
    Pen* find_pen(std::size_t device);
    void use_pen(Pen& pen, drivers::PenSample const& decoded);
    Timestamp change_before(TipSample const& tip, std::optional<Timestamp> last_tip) const;
    void follow_touch(Pen& pen, TipSample const& tip);
    void keep_moment(Pen const& pen, drivers::PenSample const& sample, TipSample const& tip);
    void change_tool(Timestamp time, tools::Tool const& tool);
    void forget(tools::Tool const& tool);
    void push_pen(Pen& pen, Timestamp received, std::span<std::byte const> report);
    void push_height(Timestamp received, std::span<std::byte const> report);
    void end_with_height();
    void follow_surface(Pen& pen);
    void take_settled(Pen& pen);
    void finish(Pen& pen);
    void finish_stroke(Stroke stroke);
    using ToolChanges = std::vector<ToolChange>;
    tools::Tool chosen_before(tools::ToolKind const& kind, ToolChanges::const_iterator end) const;
    tools::Tool other_end_of(tools::Tool const& tool, ToolChanges::const_iterator before) const;
    void count_broken(Error const& error);

    calib::HeightMonitor height_monitor_;
    Bounds volume_mm_;
    calib::HeightModel height_model_;
    std::optional<double> read_height_mm_;
    Timestamp read_height_time_ {};
    bool is_height_measured_;     // Not scripted.
    bool is_height_watched_;      // For faults of its sensor.
    bool is_height_there_ = true; // The sensor that measures it has not gone away.
    Duration tablet_latency_;
    calib::SampleTimes sample_times_;
    Nib nib_;
    std::vector<Pen> pens_;                    // In the order of their devices.
    std::vector<drivers::PenSample> new_pens_; // Kept for its memory.
    std::unique_ptr<drivers::HeightDecoder> height_decoder_;
    std::size_t height_device_ = 0;
    std::vector<drivers::HeightSample> heights_; // Of one report; kept for its memory.
    ToolChanges tool_changes_;                   // In time order; the first is from the beginning.
    ToolChanges new_tool_changes_;               // Not taken yet.
    // Kinds that an other end of the pen is, with the options that they were chosen with last; and
    // as they were before the first of tool_changes_.
    std::vector<tools::ToolKind const*> remembered_kinds_;
    std::vector<tools::Tool> forgotten_;
    tools::Tool tool_in_hand_; // When it does not press.
    tools::ToolKinds tools_;
    tools::Layers layers_;
    tools::LeastExtents least_extents_;
    tools::ToolKind const* last_dab_ = nullptr;
    std::vector<Eigen::AlignedBox2d> pressing_areas_;
    std::vector<PenMoment> moments_;         // Not taken yet.
    std::vector<tools::ToolStroke> strokes_; // Not taken yet.
    std::optional<TipSample> newest_tip_;
    bool pen_in_range_ = false;
    StationCounts counts_;
};

} // namespace tractus::station
