#pragma once

#include "app/station/pressing.h"
#include "app/tools/drawn_curve.h"
#include "app/tools/layer.h"
#include "app/tools/min_extent.h"
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
    std::optional<calib::ScriptedHeight> scripted_height; // Heights that replace the height sensor.
    // True if a height sensor must be watched for faults. False if something else sets the height,
    // such as the mouse wheel.
    bool is_height_watched = true;
    tools::ToolKinds tools {};        // Available tools.
    tools::Layers layers {};          // Available layers.
    tools::DrawnCurveLists curves {}; // Functions that list drawn curves, one for each method.
    // Initial tool; no value: the first one of `tools`.
    std::optional<tools::Tool> tool {};
    // Initial minimum extents of strokes; set_min_extents() changes them.
    tools::MinExtents min_extents {};
};

// Statistics of a station's input and output.
struct StationCounts {
    std::size_t reports = 0;
    std::size_t pen_samples = 0;
    std::size_t height_samples = 0;
    // Tips made for display from height readings while a touching pen sent no reports.
    std::size_t tips_in_silence = 0;
    // Reports refused by a decoder. first_broken has the reason of the first refusal.
    std::size_t broken_reports = 0;
    std::size_t ignored_reports = 0; // Reports of devices that are neither pen nor height sensor.
    std::size_t strokes = 0;
    std::size_t dabs = 0; // Strokes too short to have an effect; not included in `strokes`.
    std::string first_broken;
};

// The state of a pen at one moment, for windows operated by the pen.
struct PenMoment {
    bool in_range = false;
    bool touching = false;
    bool eraser = false;
    bool pressing = false; // The touch operates the window's controls and draws nothing.
    bool barrel = false;   // The first barrel button is pressed.
    double pressure = 0;
    // Position of the tip in the world frame; the last known one while the pen is out of range.
    Vec3 position_mm = Vec3::Zero();
    Timestamp time {};               // Time at which the tip was there (TipSample::time).
    std::optional<Vec2> tilt_rad {}; // Tilt of the pen; no value if the pen reports none.
    std::size_t device = 0;          // Index of the pen's tablet among the devices.
};

// Data path from reports to strokes: decodes reports, fuses pen and height samples, builds strokes
// and assigns tools to them. Reports and tool changes are pushed as they arrive, from devices or
// from a log. The finished strokes are interpreted by the document (app/document). Not thread-safe;
// used on the main thread. Several tablets can be used at once, each with its own pen and strokes.
// The rig belongs to the first tablet; the centres of all tablets coincide.
class Station {
public:
    // Uses all devices that can be decoded as pens, and the first that can be decoded as a height
    // sensor. Fails with a user error if there is no pen, or neither a height sensor nor a scripted
    // height.
    static Result<Station> create(std::span<drivers::DeviceInfo const> devices,
                                  StationOptions const& options);

    // Processes one report of a device. Reports that the decoder refuses are counted and dropped.
    // An empty report means that the device has disconnected: strokes that were drawn with it, or
    // whose height it measured, end and are kept.
    void push(std::size_t device, Timestamp received, std::span<std::byte const> report);

    // Selects the tool for strokes that begin at `time` or later. Strokes drawn with the pen's
    // other end use the tool's ToolKind::other_end. A tool that acts at once is passed on as a
    // stroke without tips and does not change the selection.
    void set_tool(Timestamp time, tools::Tool const& tool);

    // Sets the minimum extents for strokes that end from now on. A stroke shorter than its tool's
    // minimum extent is a dab: it is counted and has no effect.
    void set_min_extents(tools::MinExtents extents) { min_extents_ = std::move(extents); }
    tools::MinExtents const& min_extents() const { return min_extents_; }
    // Kind of the tool with which the last dab was drawn; null before the first dab.
    tools::ToolKind const* last_dab() const { return last_dab_; }

    // Areas for operating the window's controls, as x and y of the world frame in millimetres;
    // initially none. A touch that begins in such an area operates controls until it ends, and
    // draws nothing. It is recorded as a change to the tool pressing(), so that a recording replays
    // the same way.
    void set_pressing_areas(std::vector<Eigen::AlignedBox2d> areas)
    {
        pressing_areas_ = std::move(areas);
    }

    // Makes the current touch operate controls from its start on, instead of drawing. Used when a
    // long press opens the tool ring.
    void convert_touch_to_press();

    // Moments of the pens since the last call, in order; at most the newest kMaxMoments.
    static constexpr std::size_t kMaxMoments = 1024;
    std::vector<PenMoment> take_moments() { return std::exchange(moments_, {}); }

    // A change of the selected tool.
    struct ToolChange {
        Timestamp time {};
        tools::Tool tool;
    };
    // Tool changes since the last call, for recording in a log.
    std::vector<ToolChange> take_tool_changes() { return std::exchange(new_tool_changes_, {}); }

    // Advances the time when no report has arrived, because some pens leave the tablet without a
    // report. push() advances the time too. With live devices, call this after pushing all reports.
    void pass_time(Timestamp now);

    // Ends the input. The strokes of all pens get their remaining tips and are finished.
    void finish();

    // Strokes finished since the last call, in order.
    std::vector<tools::ToolStroke> take_strokes() { return std::exchange(strokes_, {}); }

    // Strokes that the next take_strokes() will return.
    std::vector<tools::ToolStroke> const& new_strokes() const { return strokes_; }

    StationCounts const& counts() const { return counts_; }
    calib::FuserCounts fuser_counts() const; // Counts of the fusers, summed over all pens.

    // Faults of the height sensor, past and present; empty if the height is scripted or not
    // watched.
    calib::HeightMonitor const& height_monitor() const { return height_monitor_; }

    // Nib of the pens, for displaying their ink.
    Nib nib() const { return nib_; }

    // Copies of the ink of the unfinished strokes, for display. Strokes without tips and touches
    // that operate controls are left out.
    std::vector<std::vector<TipSample>> inks() const;
    std::optional<TipSample> const& newest_tip() const { return newest_tip_; }
    // Volume that the pen can reach, world frame: the first tablet's area and the calibrated
    // heights.
    Bounds const& volume_mm() const { return volume_mm_; }

    // Height of the surface at the last reading, or at the last tip if heights are scripted. No
    // value before the first reading or tip.
    std::optional<double> surface_height_mm() const;
    bool pen_in_range() const { return pen_in_range_; }
    // True if the pen has sent nothing for more than 50 ms, during which the surface may have
    // moved: many tablets do not report a resting pen. Always false if heights are scripted.
    bool pen_rests() const;
    tools::Tool const& tool() const { return selected_tool_; }
    tools::ToolKinds tools() const { return tools_; } // Available tools.
    tools::Layers layers() const { return layers_; }  // Available layers.
    tools::DrawnCurveLists curves() const { return curves_; }
    // Tools at the pen's other end, with the options last chosen for them.
    std::vector<tools::Tool> remembered() const;
    // Tools to select one after another on another station, so that both ends of the pen have the
    // same tools there.
    std::vector<tools::Tool> tools_for_continuation() const;
    // Tool of a finished or unfinished stroke with the tips `tips`; the selected tool if there are
    // none.
    tools::Tool meaning_of(std::vector<TipSample> const& tips) const;
    bool is_pressing() const { return tool_changes_.back().tool == pressing(); }

private:
    // One tablet's pen, with everything between its reports and its strokes.
    struct Pen {
        std::size_t device = 0;
        std::unique_ptr<drivers::PenDecoder> decoder;
        drivers::PenSilence silence;
        Vec2 scale; // Factors that turn the decoder's x and y into measured millimetres.
        calib::Fuser fuser;
        StrokeBuilder builder {};
        drivers::PenSample last_sample {};
        // Time of the last live tip that came from a pen sample.
        std::optional<Timestamp> last_tip {};
        // Start of the touch, as a time of arrival; no value: not touching.
        std::optional<Timestamp> touches_since {};
    };

    explicit Station(StationOptions const& options); // Creates a station that has no devices yet.

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
    bool is_height_measured_;     // False if the height is scripted.
    bool is_height_watched_;      // True if the height sensor is monitored for faults.
    bool is_height_there_ = true; // False once the height sensor has disconnected.
    Duration tablet_latency_;
    calib::SampleTimes sample_times_;
    Nib nib_;
    std::vector<Pen> pens_; // The pens in the order of their devices.
    // Samples of one report; kept as a member so that its memory is reused.
    std::vector<drivers::PenSample> new_pens_;
    std::unique_ptr<drivers::HeightDecoder> height_decoder_;
    std::size_t height_device_ = 0;
    // Samples of one report; kept as a member so that its memory is reused.
    std::vector<drivers::HeightSample> heights_;
    // Tool changes in chronological order; the first one is the initial tool.
    ToolChanges tool_changes_;
    ToolChanges new_tool_changes_; // Tool changes that take_tool_changes() has not returned yet.
    // Kinds used by the pen's other end. forgotten_ has the last tool of each kind, if it was
    // selected before the first entry of tool_changes_.
    std::vector<tools::ToolKind const*> remembered_kinds_;
    std::vector<tools::Tool> forgotten_;
    tools::Tool selected_tool_; // The selected tool, even while the pen operates controls.
    tools::ToolKinds tools_;
    tools::Layers layers_;
    tools::DrawnCurveLists curves_;
    tools::MinExtents min_extents_;
    tools::ToolKind const* last_dab_ = nullptr;
    std::vector<Eigen::AlignedBox2d> pressing_areas_;
    std::vector<PenMoment> moments_;         // Moments that take_moments() has not returned yet.
    std::vector<tools::ToolStroke> strokes_; // Strokes that take_strokes() has not returned yet.
    std::optional<TipSample> newest_tip_;
    bool pen_in_range_ = false;
    StationCounts counts_;
};

} // namespace tractus::station
