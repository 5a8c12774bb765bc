#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/construction.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tractus::lines {

// The role of a stroke in a sketch.
enum class Role {
    Stem,
    Left,  // Boundary on the left.
    Right, // Boundary on the right.
    Inclination,
    // Half an inclination line, from the stem to one side; valid for both sides until the other
    // half is drawn.
    HalfInclination,
    Unsure,  // A stroke that was not recognised; it has no effect until the user assigns a role.
    Around,  // Boundary in space, at its azimuth around the stem.
    Outline, // Both boundaries in one stroke, around the stem's top (explain_sketch.h).
};

// Name of the role, in lower case.
std::string name_of(Role role);

struct RecognisedLine {
    Role role = Role::Unsure;
    std::optional<std::size_t> replaces {}; // The earlier stroke that this line replaces.
    bool is_drawn_again = false;            // True if the stroke lies on the one that it replaces.
    bool is_along_stem = false;             // True for a boundary that runs along most of the stem.
    // Advice for an Unsure stroke: one sentence that says what to draw instead.
    std::string reason {};
};

// Finds the roles of a sketch's strokes from their position relative to the stem, which must be the
// first. The others come in any order and direction. A stroke keeps its role regardless of later
// strokes; a redrawn line, or a second boundary on the same side, replaces the earlier one and
// reports it.
//
// Except for the stem, depth is used only for strokes marked as in space: such a stroke that runs
// along the stem, at a distance, is a boundary at its own azimuth.
class LineRecogniser {
public:
    enum class Lies { OnSheet, InSpace };

    // Adds the next stroke, (u, v, depth) in millimetres: at least two points, all finite, with no
    // two neighbours coinciding on the sheet.
    RecognisedLine const& add(std::vector<Vec3> const& stroke, Lies lies = Lies::OnSheet);

    // Returns what add() would return, without adding the stroke.
    RecognisedLine recognised(std::vector<Vec3> const& stroke, Lies lies = Lies::OnSheet) const;

    // Mean distance of a stroke's points from the stem; 0 if there is no stem yet.
    double distance_mm(std::vector<Vec3> const& stroke) const;

    // Adds a stroke whose role is known: assigned by the user or recognised before.
    void add_known(std::vector<Vec3> const& stroke, Role role);

    std::vector<RecognisedLine> const& lines() const { return lines_; }

    // Returns all strokes in use, without numbers of nodes.
    LineSketch sketch() const;

    // Indices of the strokes of the sketch's inclination lines; for a line of two halves, of the
    // first half.
    std::vector<std::size_t> inclination_strokes() const;

private:
    bool is_replaced(std::size_t line) const;
    // The newest stroke in use with a role.
    std::optional<std::size_t> newest(Role role) const;
    std::optional<std::size_t> find_redrawn_line(DrawnLine const& stroke) const;
    std::optional<std::size_t> newest_boundary(double azimuth_deg) const;
    RecognisedLine recognise(DrawnLine const& stroke) const;
    std::optional<RecognisedLine> recognise_in_space(std::vector<Vec3> const& stroke) const;
    struct DrawnInclination {
        std::vector<Vec2> points;
        std::size_t stroke = 0;
    };
    std::vector<DrawnInclination> inclinations(DrawnLine const& stem) const;

    std::vector<std::vector<Vec3>> strokes_;
    std::vector<RecognisedLine> lines_;
};

} // namespace tractus::lines
