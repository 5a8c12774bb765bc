#pragma once

#include "engine/base/time.h"
#include "engine/stroke/stroke.h"

#include <optional>
#include <vector>

namespace tractus {

struct StrokeBuilderOptions {
    // A stroke ends where its tips leave a longer gap than this: the pen was lifted and the report
    // of it got lost. Long enough for a pen that rests, since some tablets say nothing then.
    Duration longest_gap = std::chrono::milliseconds(500);
};

// Gathers tips into strokes: from the first tip that touches to the first that does not.
//
// Tips come twice. `push_live` takes each at once, with a height that may be extrapolated: that is
// the ink on the screen. `push` takes it again when later heights have settled it: that is the
// stroke. Each of the two must come in time order; a tip that is not later than the last of its
// kind, or is not finite, is ignored. What never gets ink may leave out push_live.
class StrokeBuilder {
public:
    explicit StrokeBuilder(StrokeBuilderOptions const& options = {})
        : options_(options)
    {
    }

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

    StrokeBuilderOptions options_;
    Stroke stroke_;
    std::optional<Timestamp> last_settled_;
    std::vector<TipSample> live_; // Later than last_settled_.
};

} // namespace tractus
