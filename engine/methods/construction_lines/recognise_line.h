#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/construction.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tractus::lines {

// What a stroke of a sketch is.
enum class Role {
    Stem,
    Left,  // The boundary there.
    Right, // The boundary there.
    Inclination,
    HalfInclination, // From the stem to one side: counts on both until its other half is drawn.
    Unsure,          // None of them: it has no effect until somebody says what it is.
    Around,          // A boundary in space, at its azimuth around the stem.
    Outline,         // Both boundaries in one stroke, around the stem's top (explain_sketch.h).
};

// The role's word, in small letters.
std::string name_of(Role role);

struct RecognisedLine {
    Role role = Role::Unsure;
    std::optional<std::size_t> replaces {}; // The stroke that it stands for from now on.
    bool is_drawn_again = false;            // It lies on the one whose place it takes.
    bool is_along_stem = false;             // A boundary that goes along most of it.
    std::string reason {};                  // Unsure: a sentence that says what to draw instead.
};

// Tells what strokes of a sketch are by how they lie to the stem, which is the first of them. The
// others come in any order and in either direction. A stroke keeps its role whatever comes later;
// one that is drawn again, or a second boundary on the same side, takes the earlier one's place and
// says so.
//
// Of strokes other than the stem depth counts only where they are said to be in space: there one
// that goes along the stem and away from it is a boundary that keeps its azimuth.
class LineRecogniser {
public:
    enum class Lies { OnSheet, InSpace };

    // The next stroke, (u, v, depth) in millimetres: at least two points, no two neighbours at one
    // place of the sheet; all finite.
    RecognisedLine const& add(std::vector<Vec3> const& stroke, Lies lies = Lies::OnSheet);

    // What add() would say of a stroke.
    RecognisedLine recognised(std::vector<Vec3> const& stroke, Lies lies = Lies::OnSheet) const;

    // How far a stroke's points are from the stem on average; 0 where there is none yet.
    double distance_mm(std::vector<Vec3> const& stroke) const;

    // A stroke of which somebody has said, or it was found out before, what it is.
    void add_known(std::vector<Vec3> const& stroke, Role role);

    std::vector<RecognisedLine> const& lines() const { return lines_; }

    // Of all that count; without numbers of nodes.
    LineSketch sketch() const;

    // For each of the sketch's inclination lines the number of its stroke, or of the first of its
    // two halves.
    std::vector<std::size_t> inclination_strokes() const;

private:
    bool is_replaced(std::size_t line) const;
    // The newest stroke of a role that counts.
    std::optional<std::size_t> newest(Role role) const;
    std::optional<std::size_t> line_drawn_again(DrawnLine const& stroke) const;
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
