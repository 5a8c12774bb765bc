#pragma once

#include "engine/base/time.h"
#include "engine/stroke/stroke.h"

#include <optional>
#include <vector>

namespace tractus {

// Assembles tips into strokes. A stroke begins with the first tip that touches and ends before the
// first that does not. A gap in time between two touching tips does not end the stroke, since many
// tablets send nothing while the pen rests. A pen that has left the tablet is detected by the
// decoders of the devices (drivers/reports/pen_decoder.h).
//
// Each tip is passed twice. For the ink on the screen, `push_live` takes it immediately, with a
// height that may be extrapolated. For the stroke, `push` takes it again when later height readings
// have settled its height. Both functions must be called in time order: a tip that is not later
// than the previous one of the same function, or is not finite, is ignored. Callers that show no
// ink need not call push_live.
class StrokeBuilder {
public:
    void push_live(TipSample const& tip);

    // Returns the stroke that ended with this tip, if one did. A stroke with fewer than two
    // distinct points (a tap) is dropped.
    [[nodiscard]] std::optional<Stroke> push(TipSample const& tip);

    // Ends the input. Returns the stroke that was still being drawn, if it has two distinct points.
    // Clears the ink.
    [[nodiscard]] std::optional<Stroke> finish();

    // Returns the tips to display while drawing: the settled tips of the current stroke, then the
    // later live tips. Between two strokes there is a tip that does not touch.
    std::vector<TipSample> ink() const;

private:
    std::optional<Stroke> take_stroke();

    Stroke stroke_;
    std::optional<Timestamp> last_settled_;
    std::vector<TipSample> live_; // Live tips later than last_settled_.
};

} // namespace tractus
