#pragma once

#include "calib/rig.h"
#include "drivers/reports/report_source.h"
#include "engine/base/time.h"
#include "engine/base/vectors.h"
#include "sim/simulated_tablet.h"

#include <functional>
#include <memory>
#include <span>

namespace tractus::controllers {

// A tablet and a height sensor emulated with a mouse, for users who lack both or only the sensor:
// the mouse is the pen, and its wheel or two keys move the surface. They are read like real
// devices, so drawings with them are fused, recorded and replayed the same way.
//
// After a stall of the program the sensor sends the reports that were due, so that the height has
// no gaps. Within and across reads, reports of both sources are in time order.
//
// Use the rig and its sources from one thread. The sources never block: read them until they are
// empty, once per frame. They may outlive the rig.
class MouseRig {
public:
    static constexpr Duration kHeightPeriod = std::chrono::milliseconds(5);
    // Period in the middle of a stall, during which the surface is at rest.
    static constexpr Duration kStalledHeightPeriod = std::chrono::milliseconds(100);
    static constexpr double kTop_mm = 300; // Greatest height of the surface; the least is 0.
    // Speed limit for the surface, about that of one moved by hand; the wheel may ask for more.
    static constexpr double kFastest_mm_per_s = 1500;

    // `now` is the clock of the reports.
    explicit MouseRig(std::function<Timestamp()> now);

    // The rig that a calibration of both devices would find.
    static calib::Rig rig();
    // Copies only the height sensor's part of rig() into `rig`, for use with a real tablet.
    static void set_height_sensor_in(calib::Rig& rig);

    std::unique_ptr<drivers::ReportSource> open_tablet() const;
    std::unique_ptr<drivers::ReportSource> open_height() const;

    // Sends the pen's positions since the last call, the current one last, on the tablet of rig().
    // Their times are spread evenly over the time since then, at most 0.1 s. Does nothing before
    // the tablet is opened.
    void move_pen(std::span<sim::TabletPen const> pens);

    // Set the target height, clamped to the range. move_surface() glides there like a surface moved
    // by hand; set_surface() jumps.
    void move_surface(double by_mm);
    void set_surface(double height_mm);

    struct Shared; // State shared with the sources.

private:
    std::shared_ptr<Shared> shared_;
};

} // namespace tractus::controllers
