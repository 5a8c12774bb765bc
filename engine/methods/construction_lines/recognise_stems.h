#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/recognise_line.h"
#include "engine/methods/construction_lines/several_stems.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace tractus::lines {

// The role of a stroke in a sketch with several stems, and the stem to which the stroke belongs.
struct KnownLine {
    // Role of the stroke; `replaces` is an index among all strokes of the sketch.
    RecognisedLine line {};
    // Number of the stem to which the stroke belongs; for a stem, its own number.
    std::size_t stem = 0;
    std::optional<std::size_t> parent {}; // Parent of a stem, see StemLines.
};

// Finds the roles of strokes in a sketch that may have several stems. Each stem has a
// LineRecogniser, and a stroke belongs to the nearest stem for which it has a role: preferably one
// of whose lines it is a redrawing, then one that it crosses or begins at, then one without a
// boundary on the stroke's side.
class StemRecogniser {
public:
    // Advance knowledge about a stroke: nothing, that it is another stem, or that its depth is used
    // (LineRecogniser).
    enum class Says { Nothing, AnotherStem, InSpace };

    // Adds the next stroke, as for LineRecogniser. A stroke begins another stem only with
    // Says::AnotherStem.
    KnownLine const& add(std::vector<Vec3> const& stroke, Says says = Says::Nothing);

    // Adds a stroke with a known role; `replaces` and `reason` are ignored. Stems come in the order
    // of their numbers, except for a redrawn one.
    void add_known(std::vector<Vec3> const& stroke, KnownLine line);

    std::vector<KnownLine> const& lines() const { return lines_; }

    // Returns the stems without numbers of nodes. A stem without strokes has an empty sketch.
    std::vector<StemLines> stems() const;

    // Indices of the strokes of a stem's inclination lines, see LineRecogniser.
    std::vector<std::size_t> inclination_strokes(std::size_t stem) const;

private:
    // A stem, and the indices of its strokes among those of the sketch.
    struct Stem {
        LineRecogniser lines {};
        std::vector<std::size_t> strokes {};
        std::optional<std::size_t> parent {};
    };
    KnownLine recognise(std::vector<Vec3> const& stroke, Says says) const;
    KnownLine nearest(std::vector<Vec3> const& stroke, LineRecogniser::Lies lies) const;

    std::vector<Stem> stems_;
    std::vector<KnownLine> lines_;
};

} // namespace tractus::lines
