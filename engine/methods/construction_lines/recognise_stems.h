#pragma once

#include "engine/base/vectors.h"
#include "engine/methods/construction_lines/recognise_line.h"
#include "engine/methods/construction_lines/several_stems.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace tractus::lines {

// What a stroke of a sketch of several stems is, and where it belongs.
struct KnownLine {
    RecognisedLine line {};               // `replaces`: among all of the sketch's strokes.
    std::size_t stem = 0;                 // The number of its stem; of a stem, its own.
    std::optional<std::size_t> parent {}; // Of a stem: see StemLines.
};

// Tells what strokes of a sketch are that may have several stems. Each stem has a LineRecogniser of
// its own, and the nearest stem for which a stroke means something gets it: one that was drawn
// there before, whose line crosses it or begins at it, or else the one that has no such boundary
// yet.
class StemRecogniser {
public:
    // What is known of a stroke before it is looked at: nothing, that it is another stem, or that
    // its depth counts (LineRecogniser).
    enum class Says { Nothing, AnotherStem, InSpace };

    // The next stroke, as of LineRecogniser. Only strokes of which that is said begin another stem.
    KnownLine const& add(std::vector<Vec3> const& stroke, Says says = Says::Nothing);

    // A stroke of which it is known; its `replaces` and `reason` have no effect. Stems come in the
    // order of their numbers, but for one that was drawn again.
    void add_known(std::vector<Vec3> const& stroke, KnownLine line);

    std::vector<KnownLine> const& lines() const { return lines_; }

    // Without numbers of nodes. One that has no stroke for a stem has none there.
    std::vector<StemLines> stems() const;

    // For each inclination line of a stem the number of its stroke: see LineRecogniser.
    std::vector<std::size_t> inclination_strokes(std::size_t stem) const;

private:
    // A stem, and which of the sketch's strokes its own are.
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
