#pragma once

#include "app/tools/tool.h"
#include "calib/fuser.h"
#include "calib/height_monitor.h"
#include "calib/rig.h"
#include "drivers/device_info.h"
#include "drivers/height_decoder.h"
#include "drivers/pen_decoder.h"
#include "engine/base/result.h"
#include "engine/scene/scene.h"
#include "engine/stroke/stroke_builder.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tractus {

struct StationOptions {
    Rig rig;
    std::optional<ScriptedHeight> scripted_height; // In place of a height sensor.
    Scene scene; // What the pen works on; its base plant is loaded.
    Tool tool;   // What the pen means until a tool line says otherwise.
};

// What came in and what became of it.
struct StationCounts {
    std::size_t reports = 0;
    std::size_t pen_samples = 0;
    std::size_t height_samples = 0;
    std::size_t broken_reports = 0;  // A decoder refused them; the first reason is kept.
    std::size_t ignored_reports = 0; // Of devices that are neither the pen nor the height sensor.
    std::size_t strokes = 0;
    std::string first_broken;
};

// A finished stroke and what it meant.
struct DrawnStroke {
    Stroke stroke;
    Tool tool;
    std::string refusal; // Why it changed nothing; empty if it did.
};

// The whole way of the data, from reports to the scene: decode, fuse, stroke, mean. The only class
// that knows it. Reports and tool changes go in as they come, from devices or from a log, and the
// scene is what they amount to. Not thread-safe: it lives on the main thread.
class Station {
public:
    // Takes the first device that decodes as a pen, and the first that decodes as a height sensor.
    // Fails, as the user's fault, if there is no pen, or neither height sensor nor scripted height.
    static Result<Station> create(std::span<DeviceInfo const> devices, StationOptions options);

    // One report of one of the devices. A report that its decoder refuses is counted and forgotten.
    void push(std::size_t device, Timestamp received, std::span<std::byte const> report);

    // From the pen's samples at `time` on, strokes belong to `tool`.
    void set_tool(Timestamp time, Tool const& tool);

    // Time has passed without a report: some pens leave by falling silent. Each report passes time
    // by itself; live, call this when all that have come are pushed.
    void pass_time(Timestamp now);

    // No more reports come: settles and finishes what is under way.
    void finish();

    Scene const& scene() const { return scene_; }
    std::vector<DrawnStroke> const& strokes() const { return strokes_; }
    StationCounts const& counts() const { return counts_; }
    FuserCounts const& fuser_counts() const { return fuser_.counts(); }

    // What is, and was, wrong with the height sensor; nothing if the height is scripted.
    HeightMonitor const& height_monitor() const { return height_monitor_; }

    // For the screen: the ink of the stroke under way, the newest tip, and what it means.
    std::vector<TipSample> ink() const { return builder_.ink(); }
    std::optional<TipSample> const& newest_tip() const { return newest_tip_; }
    bool pen_in_range() const { return pen_in_range_; }
    Tool const& tool() const { return tool_changes_.back().tool; }

private:
    struct ToolChange {
        Timestamp time {};
        Tool tool;
    };

    Station(StationOptions options, Fuser fuser);

    void use_pen(PenSample const& sample);
    void push_pen(Timestamp received, std::span<std::byte const> report);
    void push_height(Timestamp received, std::span<std::byte const> report);
    void take_settled();
    void finish_stroke(Stroke stroke);
    Tool tool_at(Timestamp time) const;
    void count_broken(Error const& error);

    Fuser fuser_;
    HeightMonitor height_monitor_;
    bool is_height_measured_; // Not scripted.
    Duration tablet_latency_;
    StrokeBuilder builder_;
    std::unique_ptr<PenDecoder> pen_decoder_;
    PenSilence pen_silence_;
    std::size_t pen_device_ = 0;
    std::unique_ptr<HeightDecoder> height_decoder_;
    std::size_t height_device_ = 0;
    std::vector<HeightSample> heights_;    // Of the report at hand; kept for its memory.
    std::vector<ToolChange> tool_changes_; // In time order; the first is from the beginning.
    Scene scene_;
    std::vector<DrawnStroke> strokes_;
    std::optional<TipSample> newest_tip_;
    bool pen_in_range_ = false;
    StationCounts counts_;
};

} // namespace tractus
