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
// (paper.h): a tablet position (x, y) is at offset + size * (x, y) on the sheet. While a plant is
// displayed at the scale at which its stem was drawn, sheet and tablet coordinates are the same.
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
    Height,   // The surface's height, also for boundaries, see Role::Around.
    Pressure, // The pen's pressure, for stems only, if there is no height sensor.
};

// Method of finding the roles of lines.
enum class Reading {
    // Each line is read when it is drawn (LineRecogniser): the default for older sketches.
    OneByOne,
    Together, // All lines are read again with each new one (explain_sketch.h).
};

// A line of a sketch as drawn with the pen.
struct SketchLine {
    scene::ItemId id = 0;
    Stroke stroke {};        // Stroke of the line, world frame.
    SheetPlacement sheet {}; // Placement of the sheet when the line was drawn.
    Role role = Role::Unsure;
    // Number of nodes in the layer above an inclination line, 0 to kMaxNodesInLayer; for a stem,
    // in the only layer of a sketch with fewer than two inclination lines.
    int nodes = 0;
    // Number of the stem to which the line belongs; for a stem, its own number.
    std::size_t stem = 0;
    std::optional<std::size_t> parent {}; // Parent of a stem, see StemLines.
    DepthBy depth_by = DepthBy::StemsHeight;
    // Height of the surface that corresponds to depth 0: the height at which the line's stem
    // begins, mm. No value if the line lies on the sheet or is a stem.
    std::optional<double> level_mm {};
    // Pattern and organ of the layer whose number of nodes this line stores; organ 0: plain leaves.
    // Default: pattern and organ of the plant.
    std::optional<Pattern> pattern {};
    std::optional<scene::ItemId> organ {};
    // Method of reading the line. A sketch is read together if this is Together for all of its
    // lines.
    Reading reading = Reading::OneByOne;
    bool is_assigned
        = false;             // True if the user has assigned the role; used with Reading::Together.
    bool turn_round = false; // True: the direction of the line, as drawn or as read, is reversed.
};

// Returns the points of a line on the sheet, (u, v, depth), with tremor removed (capture_line.h;
// for Reading::Together clean_hand_line(), which also removes hooks). Depth from height is 0 if the
// surface has moved by less than a twentieth of the line's length; otherwise it is the height above
// that at pen-down, or above `level_mm` if the line has one. Depth from pressure: a stem comes
// towards the viewer by half of its length on the sheet if the pressure exceeds that at its base by
// the full range. Pressure is averaged over a twentieth of the stem, and at its ends, where it is
// unreliable, the pressure at a twentieth from the end is used. Returns at least two points, no two
// neighbours coinciding on the sheet. Fails with a user error if the line is a dot.
Result<std::vector<Vec3>> points_on_sheet(SketchLine const& line);

} // namespace tractus::lines
