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
    // Number of the stem to which the stroke belongs; a stroke that is a stem belongs to itself.
    std::size_t stem = 0;
    // For a stem, the number of its parent stem (StemLines::parent).
    std::optional<std::size_t> parent {};
};

// Finds the roles of strokes in a sketch that may have several stems. Each stem has a
// LineRecogniser. A stroke belongs to a stem for which it redraws a line; otherwise to one that it
// follows along its whole length; otherwise to one that it crosses or at which it begins;
// otherwise, as a boundary, to one without a boundary on that side. Among equal stems it belongs to
// the nearest.
class StemRecogniser {
public:
    // What the caller knows about a stroke: nothing, that it is an additional stem, or that its
    // depth is to be used (LineRecogniser::Lies::InSpace).
    enum class Says { Nothing, AnotherStem, InSpace };

    // Adds the next stroke, whose points meet the requirements of LineRecogniser::add(). A stroke
    // after the first begins another stem only with Says::AnotherStem.
    KnownLine const& add(std::vector<Vec3> const& stroke, Says says = Says::Nothing);

    // Adds a stroke with a known role; its `replaces` and `reason` are ignored. Stems must be added
    // in the order of their numbers, except for one that has been redrawn.
    void add_known(std::vector<Vec3> const& stroke, KnownLine line);

    std::vector<KnownLine> const& lines() const { return lines_; }

    // Returns the lines of each stem, without numbers of nodes. A stem without strokes has an empty
    // sketch.
    std::vector<StemLines> stems() const;

    // Index of the stroke of each inclination line of a stem, among all strokes of the sketch (see
    // LineRecogniser::inclination_strokes()).
    std::vector<std::size_t> inclination_strokes(std::size_t stem) const;

private:
    // A stem, with the indices of its strokes among all strokes of the sketch.
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
