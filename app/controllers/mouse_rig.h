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

// A tablet and a height sensor emulated with a mouse, for users who lack both devices or only the
// sensor. The mouse is the pen; its wheel or two keys move the surface. Both are read like real
// devices, so drawings with them are fused, recorded and replayed in the same way.
//
// After a stall of the program the sensor sends the reports that were due, so that the height has
// no gaps. Reports of both devices are in time order, both within one read and from one read to the
// next.
//
// Use the rig and its sources from one thread. The sources never block: read them until they are
// empty, once per frame. The sources may outlive the rig.
class MouseRig {
public:
    static constexpr Duration kHeightPeriod = std::chrono::milliseconds(5);
    // Time between height reports in the middle of a stall, when the surface is at rest.
    static constexpr Duration kStalledHeightPeriod = std::chrono::milliseconds(100);
    static constexpr double kTop_mm = 300; // Maximum height of the surface; the minimum is 0.
    // Maximum speed of the surface, as when moved by hand; the wheel may ask for more.
    static constexpr double kFastest_mm_per_s = 1500;

    // `now` is the clock that gives reports their time.
    explicit MouseRig(std::function<Timestamp()> now);

    // Returns the rig that a calibration of the emulated tablet and sensor would find.
    static calib::Rig rig();
    // Copies only the height sensor's part of rig() to `rig`, for use with a real tablet.
    static void set_height_sensor_in(calib::Rig& rig);

    std::unique_ptr<drivers::ReportSource> open_tablet() const;
    std::unique_ptr<drivers::ReportSource> open_height() const;

    // Sends the positions of the pen since the last call, on the tablet of rig(); the last one is
    // the current position. Their times are spread evenly over the time since the last call, but
    // over at most 0.1 s. Does nothing before the tablet is opened.
    void move_pen(std::span<sim::TabletPen const> pens);

    // Set the surface's target height, clamped to its range. move_surface() changes it by `by_mm`,
    // and the surface glides there as if moved by hand; set_surface() makes it jump there.
    void move_surface(double by_mm);
    void set_surface(double height_mm);

    struct Shared; // State shared with the sources.

private:
    std::shared_ptr<Shared> shared_;
};

} // namespace tractus::controllers
