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
// Belongs to the thread that moves it; the sources may be read on others, and live as long as they
// like.
class MouseRig {
public:
    static constexpr Duration kHeightPeriod = std::chrono::milliseconds(5);
    static constexpr double kTop_mm = 300; // The surface goes from 0 to here.

    // `now` is the clock of the reports. It is called on the threads that read the sources, too.
    explicit MouseRig(std::function<Timestamp()> now);

    // Returns what a calibration of both would find.
    static calib::Rig rig();
    // The height sensor's part of it, for a tablet that is there.
    static void set_height_sensor_in(calib::Rig& rig);

    std::unique_ptr<drivers::ReportSource> open_tablet() const;
    std::unique_ptr<drivers::ReportSource> open_height() const;

    // Where the pen was since the last call, the last one being where it is now. Their times are
    // spread evenly over the time since then, or the last tenth of a second of it. Places are on
    // the tablet of rig().
    void move_pen(std::span<sim::TabletPen const> pens);

    // Where the surface shall be, clamped to its way: it glides there, as a surface does that hands
    // move; or it is there at once.
    void move_surface(double by_mm);
    void set_surface(double height_mm);

    struct Shared; // State that it and its sources share.

private:
    std::shared_ptr<Shared> shared_;
    Timestamp last_move_ {};
};

} // namespace tractus::controllers
