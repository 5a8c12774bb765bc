#pragma once

#include "drivers/reports/report_descriptor.h"
#include "engine/base/vectors.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace tractus::drivers {

// Location of a pen's values within its reports, found in a report descriptor. There is one layout
// for each report id that carries pen data.
//
// Two kinds of device are recognised: the digitizer pen (HID Usage Tables, page 0x0D, "Pen" or
// "Stylus"), and the mouse with absolute X and Y and a tip pressure. Many tablets present
// themselves as such a mouse until their own driver switches them: button 1 is the tip, and leaving
// is never reported.
//
// Wacom's own page 0xFF0D, which has the same usages under other numbers, is read as well. Its "in
// proximity" (a pen is near, but its position is not known yet) does not mean "in range".
struct PenLayout {
    std::uint8_t report_id = 0;   // 0 if the device does not use report ids.
    std::size_t report_size = 0;  // Declared size in bytes, including the report id.
    std::size_t bytes_needed = 0; // Bytes up to the end of the last field used here.

    HidField x;
    HidField y;                  // Counts downwards from the far edge, as on a screen.
    std::optional<HidField> tip; // A layout has a tip, a pressure or both.
    std::optional<HidField> pressure;
    std::optional<HidField> in_range;
    std::optional<HidField> invert; // Set while the eraser end points at the tablet.
    std::optional<HidField> eraser; // Set while the eraser end touches.
    std::array<std::optional<HidField>, 3> buttons;
    std::optional<HidField> tilt_x;
    std::optional<HidField> tilt_y; // Positive towards the user.
    std::optional<HidField> tool_serial;
    std::optional<HidField> tool_type; // Type number of the pen, as defined by Wacom.

    Vec2 mm_per_count = Vec2::Ones();
    Vec2 size_mm = Vec2::Zero();            // Size of the active area.
    Vec2 tilt_rad_per_count = Vec2::Zero(); // Factor from the logical value to radians.

    // Origin of the size: the descriptor's physical range (Declared), another source (Known), or a
    // guess (Assumed) if the range is missing or implausible (a side outside 20 to 800 mm, or more
    // than 1000 counts per mm). The guess for a mouse is the size in the same device's pen reports.
    // The guess for a range without a unit is thousandths of an inch. Other guesses are 5080 counts
    // per inch, as on most tablets, or 2540, whichever gives a longer side of 80 to 500 mm, or else
    // a longer side of 250 mm. If both axes have the same range, which fits no tablet's surface,
    // the sides are assumed to be 16:10, as on most tablets.
    enum class Size { Declared, Known, Assumed } size_source = Size::Declared;

    // Sets a size known from another source if the descriptor declares none, or has X and Y
    // exchanged.
    void take_known_size(Vec2 const& known_size_mm);

    // Sets the proportions, known from another source, of a size that is a guess.
    void take_proportions(double width_to_height);

    // True if both axes have the same range, which therefore does not give the proportions.
    bool has_square_counts() const;

    // True if a field has the standard usage of a second barrel button, and not a usage that some
    // makers use in its place.
    bool has_second_barrel_switch() const;

    // True if the second button is declared as a secondary tip switch.
    bool has_secondary_tip_switch() const;
};

// Returns the layouts of all pen reports, in the descriptor's order; empty if it describes no pen.
//
// Tilts without a unit are read as devices mean them: logical maxima up to 180 are degrees, up to
// 18000 hundredths of a degree; larger ranges span 180 degrees.
std::vector<PenLayout> find_pen_layouts(HidReportDescriptor const&);

} // namespace tractus::drivers
