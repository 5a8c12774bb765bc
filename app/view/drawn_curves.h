#pragma once

#include "app/tools/drawn_curve.h"
#include "app/view/window_model.h"
#include "engine/scene/scene.h"
#include "engine/stroke/tip_sample.h"

#include <span>
#include <vector>

namespace tractus::view {

// Ink that is kept for strokes, so that their tips need not be read again: `lines` has an element
// for each of `strokes`.
struct CachedInk {
    std::span<SharedVector<TipSample> const> strokes;
    std::span<InkLine const> lines;
};

// Returns the curves of the scene's active plant in the order in which they were drawn: the strokes
// that shape its branches (shaping_numbers()), each once, those of its limbs, and those of the
// lists. Strokes without ink are left out, and limbs that the plant does not have at present.
std::vector<DrawnCurveView> drawn_curves(scene::Scene const& scene, CachedInk const& ink,
                                         tools::DrawnCurveLists lists);

} // namespace tractus::view
