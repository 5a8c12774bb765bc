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

// A tablet and a height sensor for people who have none, or only the tablet: a mouse is the pen,
// its wheel or two keys move the surface. They are devices like others, so that what is drawn with
// them is fused, recorded and replayed in the same way.
//
// However long the program stalls, the surface has been reported all the while: its sensor sends
// afterwards what was due, so that its height is never silent. Reports of both sources together are
// in time order from one reading of them to the next.
//
// The rig and its sources belong to one thread, and the sources never wait: read them until they
// have nothing, once a frame. They live as long as they like.
class MouseRig {
public:
    static constexpr Duration kHeightPeriod = std::chrono::milliseconds(5);
    // The same in the middle of a stall, where the surface is at rest.
    static constexpr Duration kStalledHeightPeriod = std::chrono::milliseconds(100);
    static constexpr double kTop_mm = 300; // The surface goes from 0 to here.
    // The wheel may ask for more: no surface that a hand moves is faster.
    static constexpr double kFastest_mm_per_s = 1500;

    // `now` is the clock of the reports.
    explicit MouseRig(std::function<Timestamp()> now);

    // Returns what a calibration of both would find.
    static calib::Rig rig();
    // The height sensor's part of it, for a tablet that is there.
    static void set_height_sensor_in(calib::Rig& rig);

    std::unique_ptr<drivers::ReportSource> open_tablet() const;
    std::unique_ptr<drivers::ReportSource> open_height() const;

    // Where the pen was since the last call, the last one being where it is now. Their times are
    // spread evenly over the time since then, or the last tenth of a second of it. Places are on
    // the tablet of rig(). Nothing happens before the tablet is opened.
    void move_pen(std::span<sim::TabletPen const> pens);

    // Where the surface shall be, clamped to its way: it glides there, as a surface does that hands
    // move; or it is there at once.
    void move_surface(double by_mm);
    void set_surface(double height_mm);

    struct Shared; // State that it and its sources share.

private:
    std::shared_ptr<Shared> shared_;
};

} // namespace tractus::controllers
