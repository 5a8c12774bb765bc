#pragma once

#include "engine/base/time.h"
#include "engine/stroke/stroke.h"

#include <optional>
#include <vector>

namespace tractus {

// Gathers tips into strokes: from the first tip that touches to the first that does not. A gap
// between two tips that touch ends nothing: many tablets are silent about a pen that rests, and the
// devices' decoders know when silence means that a pen has gone (drivers/reports/pen_decoder.h).
//
// Tips come twice. `push_live` takes each at once, with a height that may be extrapolated: that is
// the ink on the screen. `push` takes it again when later heights have settled it: that is the
// stroke. Each of the two must come in time order; a tip that is not later than the last of its
// kind, or is not finite, is ignored. What never gets ink may leave out push_live.
class StrokeBuilder {
public:
    void push_live(TipSample const& tip);

    // The stroke that ended with this tip, if one did. What has fewer than two distinct points (a
    // tap) is no stroke and is dropped.
    [[nodiscard]] std::optional<Stroke> push(TipSample const& tip);

    // The end of all tips: the stroke that was still being drawn, if it is one. Forgets the ink.
    [[nodiscard]] std::optional<Stroke> finish();

    // Returns what is to be seen while it is drawn: the settled tips of the stroke under way, then
    // the live tips later than these. Tips that do not touch stand between two strokes.
    std::vector<TipSample> ink() const;

private:
    std::optional<Stroke> take_stroke();

    Stroke stroke_;
    std::optional<Timestamp> last_settled_;
    std::vector<TipSample> live_; // Later than last_settled_.
};

} // namespace tractus
