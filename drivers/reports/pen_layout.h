#pragma once

#include "drivers/reports/report_descriptor.h"
#include "engine/base/vectors.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::drivers {

// Where a pen report keeps what, found in a report descriptor. One per report id that carries a
// pen.
//
// Two shapes are known: the digitizer pen (HID Usage Tables, page 0x0D, "Pen" or "Stylus"), and the
// mouse with absolute X and Y and a tip pressure, which many tablets are until their own driver
// switches them: button 1 is its tip, and it never says that the pen is out of range.
//
// Wacom's own page 0xFF0D has the same usages under other numbers, and is read as well. Its "in
// proximity" (a pen is somewhere near, but its place is not known yet) is not "in range".
struct PenLayout {
    std::uint8_t report_id = 0;   // 0: the device does not use report ids.
    std::size_t report_size = 0;  // Bytes on the wire, the id included, as the descriptor says.
    std::size_t bytes_needed = 0; // Up to the last field below.

    HidField x;
    HidField y;                  // Counts downwards from the far edge, as on a screen.
    std::optional<HidField> tip; // Tip, pressure or both are there.
    std::optional<HidField> pressure;
    std::optional<HidField> in_range;
    std::optional<HidField> invert; // The eraser's end points at the tablet.
    std::optional<HidField> eraser; // The eraser's end touches.
    std::array<std::optional<HidField>, 3> buttons;
    std::optional<HidField> tilt_x;
    std::optional<HidField> tilt_y; // Towards the user.
    std::optional<HidField> tool_serial;
    std::optional<HidField> tool_type; // Wacom's numbers for kinds of pens.

    Vec2 mm_per_count = Vec2::Ones();
    Vec2 size_mm = Vec2::Zero();            // Size of the active area.
    Vec2 tilt_rad_per_count = Vec2::Zero(); // Times the logical value.

    // The descriptor's physical range, or a guess where that is missing or makes no sense (a side
    // outside 20 to 800 mm, or more than 1000 counts per mm). The guess: for a mouse, what the same
    // device's pen reports say; for a range without a unit, thousandths of an inch; else 5080
    // counts per inch, as most tablets have, or 2540, whichever gives a longer side of 80 to 500
    // mm; else a longer side of 250 mm. Where both axes have one range, which no tablet's surface
    // has, its sides are as 16 to 10, as most tablets' are.
    enum class Size { Declared, Known, Assumed } size_source = Size::Declared;

    // Believes `known_size_mm`, from elsewhere, if the descriptor declares no size, or has X's and
    // Y's changed over.
    void take_known_size(Vec2 const& known_size_mm);

    // Believes the proportions, from elsewhere, of a size that is a guess.
    void take_proportions(double width_to_height);

    // Whether both axes have one range, so that it says nothing of the proportions.
    bool has_square_counts() const;

    // Whether there is one by its proper name, and not by one of those that some makers use in its
    // place.
    bool has_second_barrel_switch() const;

    // The second button is called a secondary tip switch, for want of a better one.
    bool has_secondary_tip_switch() const;
};

// The layouts of all pen reports, in the descriptor's order; empty if it describes no pen.
//
// Tilt without a unit: logical maxima up to 180 are taken for degrees, up to 18000 for hundredths
// of a degree, as devices mean them; beyond, the range spans 180 degrees.
std::vector<PenLayout> find_pen_layouts(HidReportDescriptor const&);

} // namespace tractus::drivers
