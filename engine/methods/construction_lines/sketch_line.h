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

// Where on a sketch's sheet (drawn_line.h) a place on the tablet is, which is upright paper
// (paper.h): offset + size * (x, y). As long as a plant is shown in the size in which its stem was
// drawn, both are the same.
struct SheetPlacement {
    Vec2 offset_mm = Vec2::Zero();
    double size = 1; // Millimetres of the sheet in one of the tablet; above 0.

    Vec2 on_sheet(Vec2 const& tablet_mm) const { return offset_mm + size * tablet_mm; }
    Vec2 on_tablet(Vec2 const& sheet_mm) const { return (sheet_mm - offset_mm) / size; }
};

// Where a line's depth comes from.
enum class DepthBy {
    StemsHeight, // A stem's from the surface's height; all other lines are on the sheet.
    Height,      // From the surface's height, of boundaries, too: see Role::Around.
    Pressure,    // A stem's from the pen's pressure: where there is no sensor for the height.
};

// How a sketch tells what its lines are.
enum class Reading {
    OneByOne, // Each as it comes (LineRecogniser): sketches of before lines were read together.
    Together, // All again with each new one (explain_sketch.h).
};

// A line of a sketch as a pen drew it.
struct SketchLine {
    scene::ItemId id = 0;
    Stroke stroke {};        // World frame.
    SheetPlacement sheet {}; // When it was drawn.
    Role role = Role::Unsure;
    // In the layer above it, of an inclination line, 0 to kMostNodesInLayer. Of the stem: in the
    // only layer of a sketch with fewer than two of those.
    int nodes = 0;
    std::size_t stem = 0; // The number of the stem to which it belongs; of a stem, its own.
    std::optional<std::size_t> parent {}; // Of a stem: see StemLines.
    DepthBy depth_by = DepthBy::StemsHeight;
    // The surface's height where the depth is 0, that at which its stem begins, mm on the tablet.
    // No value: the line does not leave the sheet, or it is a stem.
    std::optional<double> level_mm {};
    // How organs stand in the layer whose nodes these are, and which of the sketch's organs they
    // are, 0 for plain leaves; no value: as on the rest of the plant.
    std::optional<Pattern> pattern {};
    std::optional<scene::ItemId> organ {};
    Reading reading = Reading::OneByOne; // A sketch is read together if all of its lines are.
    bool is_said = false;                // Read together: somebody has said that it has this role.
    bool turn_round = false; // It goes from where it ends to where it begins, or would be read so.
};

// Where the tips of a line are on the sheet, (u, v, depth), the hand's tremor taken out
// (capture_line.h; of lines that are read together clean_hand_line(), which also cuts hooks). Where
// the surface has moved by less than a twentieth of the line's length the depth is 0; else it is
// the height above pen-down, or of a line that has a level above that. By pressure a stem comes
// towards the viewer by half of its length on the sheet where the pen is pressed with all of its
// range more than at its base; the mean of a twentieth of the stem counts, and at its ends, where
// the pen comes down and is lifted, what is a twentieth from them. At least two points, no two
// neighbours at one place of the sheet. Fails, as the user's fault, for a dot.
Result<std::vector<Vec3>> points_on_sheet(SketchLine const& line);

} // namespace tractus::lines
