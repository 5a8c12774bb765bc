#pragma once

#include "app/tools/drawn_curve.h"
#include "app/view/window_model.h"
#include "engine/scene/scene.h"
#include "engine/stroke/tip_sample.h"

#include <span>
#include <vector>

namespace tractus::view {

// Ink of strokes, kept so that their tips need not be read again. lines[i] is the ink of
// strokes[i].
struct CachedInk {
    std::span<SharedVector<TipSample> const> strokes;
    std::span<InkLine const> lines;
};

// Returns the curves that the user drew for the scene's active plant, in the order in which they
// were drawn: strokes that shape its branches (shaping_numbers()), each once; its limbs; and the
// curves of `lists`. Strokes without ink and limbs that the plant does not have at present are left
// out.
std::vector<DrawnCurveView> drawn_curves(scene::Scene const& scene, CachedInk const& ink,
                                         tools::DrawnCurveLists lists);

} // namespace tractus::view
