#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/pattern.h"
#include "engine/methods/construction_lines/recognise_line.h"
#include "engine/scene/anchored.h"
#include "engine/stroke/stroke.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace tractus::lines {

// Placement of a sketch's sheet (drawn_line.h) on the tablet, which represents upright paper
// (paper.h): the tablet position (x, y) is at offset_mm + size * (x, y) on the sheet. While a plant
// is displayed at the scale at which its stem was drawn, sheet and tablet coordinates are equal.
struct SheetPlacement {
    Vec2 offset_mm = Vec2::Zero();
    double size = 1; // Millimetres of the sheet per millimetre of the tablet; above 0.

    Vec2 on_sheet(Vec2 const& tablet_mm) const { return offset_mm + size * tablet_mm; }
    Vec2 on_tablet(Vec2 const& sheet_mm) const { return (sheet_mm - offset_mm) / size; }
};

// Source of a line's depth.
enum class DepthBy {
    // The surface's height, for stems only; all other lines count as flat on the sheet.
    StemsHeight,
    Height,   // The surface's height, for stems and for boundaries in space (Role::Around).
    Pressure, // The pen's pressure, for stems only: for stations without a height sensor.
};

// Method of finding the roles of lines.
enum class Reading {
    // The role of a line is found when it is drawn (LineRecogniser). This is the default for older
    // sketches.
    OneByOne,
    Together, // The roles of all lines are found anew with each line (explain_sketch.h).
};

// A line of a sketch as drawn with the pen.
struct SketchLine {
    scene::ItemId id = 0;
    Stroke stroke {};        // Stroke of the line, world frame.
    SheetPlacement sheet {}; // Placement of the sheet at the time when the line was drawn.
    Role role = Role::Unsure;
    // For an inclination line, the number of nodes in the layer above it, 0 to kMaxNodesInLayer.
    // For a stem, the number of nodes in its only layer, if it has fewer than two inclination
    // lines.
    int nodes = 0;
    // Number of the stem to which the line belongs; a line that is a stem belongs to itself.
    std::size_t stem = 0;
    // For a stem, the number of its parent stem (StemLines::parent).
    std::optional<std::size_t> parent {};
    DepthBy depth_by = DepthBy::StemsHeight;
    // Height of the surface, in mm, that corresponds to depth 0: the height at which the line's
    // stem begins. No value if the line lies on the sheet or is a stem.
    std::optional<double> level_mm {};
    // Pattern and organ of the layer whose number of nodes this line stores; organ 0 stands for
    // plain leaves. Without a value the layer has the pattern or organ of the plant.
    std::optional<Pattern> pattern {};
    std::optional<scene::ItemId> organ {};
    // Method of finding the line's role. The lines of a sketch are interpreted together only if all
    // of them have Reading::Together.
    Reading reading = Reading::OneByOne;
    bool is_assigned = false; // True if the user has assigned the role; only for Reading::Together.
    // True: the line runs opposite to its stroke or, with Reading::Together, to the direction that
    // explain_sketch() would find.
    bool turn_round = false;
};

// Returns the points of a line on the sheet, (u, v, depth), without tremor (capture_line() or, for
// Reading::Together, clean_hand_line(), which also removes hooks).
//
// Depth from height is 0 if the surface moved by less than a twentieth of the line's length.
// Otherwise it is the height above that at pen-down, or above `level_mm` if the line has one. Depth
// from pressure: a stem comes towards the viewer by half of its length on the sheet if the pressure
// exceeds that at its base by the full range. Pressure is averaged over about a twentieth of the
// stem; near the stem's ends, where it is unreliable, the pressure at a twentieth of its length
// from the end is used.
//
// Returns at least two points, with no two neighbours coinciding on the sheet. Fails with a user
// error if the line is a dot.
Result<std::vector<Vec3>> points_on_sheet(SketchLine const& line);

} // namespace tractus::lines
