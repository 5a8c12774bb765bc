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
    // Half an inclination line, from the stem to one side. It applies to both sides until the other
    // half is drawn.
    HalfInclination,
    Unsure,  // An unrecognised stroke, which has no effect until the user assigns a role.
    Around,  // Boundary in space, at its azimuth around the stem.
    Outline, // Both boundaries in one stroke, around the stem's top (explain_sketch.h).
};

// Name of the role, in lower case.
std::string name_of(Role role);

struct RecognisedLine {
    Role role = Role::Unsure;
    std::optional<std::size_t> replaces {}; // Index of the earlier stroke that this line replaces.
    bool is_drawn_again = false;            // True if the stroke traces the one that it replaces.
    bool is_along_stem = false;             // True for a boundary that runs along most of the stem.
    // For an Unsure stroke: one sentence that says what to draw instead.
    std::string reason {};
};

// Finds the roles of a sketch's strokes from their position relative to the stem. The stem must be
// the first stroke; the other strokes come in any order and direction. A stroke keeps its role
// regardless of later strokes. A redrawn line, or a second boundary on the same side, replaces the
// earlier line (RecognisedLine::replaces).
//
// Except for the stem, depth matters only for strokes added with Lies::InSpace: such a stroke that
// runs along the stem, at a distance, is a boundary at its own azimuth.
class LineRecogniser {
public:
    enum class Lies { OnSheet, InSpace };

    // Adds the next stroke, with points (u, v, depth) in millimetres, and returns its role. The
    // points must be finite and at least two, with no two neighbours coinciding on the sheet.
    RecognisedLine const& add(std::vector<Vec3> const& stroke, Lies lies = Lies::OnSheet);

    // Returns what add() would return, without adding the stroke.
    RecognisedLine recognised(std::vector<Vec3> const& stroke, Lies lies = Lies::OnSheet) const;

    // Mean distance of a stroke from the stem on the sheet; 0 if there is no stem yet.
    double distance_mm(std::vector<Vec3> const& stroke) const;

    // Adds a stroke whose role is known: assigned by the user or recognised before.
    void add_known(std::vector<Vec3> const& stroke, Role role);

    std::vector<RecognisedLine> const& lines() const { return lines_; }

    // Returns the sketch given by all strokes that have not been replaced; it has no numbers of
    // nodes yet.
    LineSketch sketch() const;

    // Index of the stroke of each inclination line of sketch(); for a line of two halves, of its
    // first half.
    std::vector<std::size_t> inclination_strokes() const;

private:
    bool is_replaced(std::size_t line) const;
    // Index of the newest stroke that has this role and has not been replaced.
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
