#include "app/view/shown_layers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::view {

void ShownLayers::set_layers(tools::Layers layers)
{
    kept_.clear();
    for (auto const* const layer : layers)
        kept_.push_back({ .layer = layer });
    has_shown_ = false;
}

double ShownLayers::strength_after(Duration age)
{
    constexpr double kFull_s = 2;
    constexpr double kGone_s = 6;
    constexpr double kSteps = 8;
    double const share = (kGone_s - to_seconds(age)) / (kGone_s - kFull_s);
    return std::ceil(kSteps * std::clamp(share, 0.0, 1.0)) / kSteps;
}

double ShownLayers::strength_of(Kept const& kept, tools::Tool const& in_hand)
{
    auto const& layer = *kept.layer;
    if (layer.seen == tools::Layer::Seen::Always
        || (layer.is_asked_for && layer.is_asked_for(in_hand)))
        return 1;
    return layer.seen == tools::Layer::Seen::AWhile ? strength_after(kept.age) : 0;
}

void ShownLayers::show(scene::Scene const& scene, tools::Tool const& in_hand)
{
    for (auto& kept : kept_) {
        if (kept.layer->seen == tools::Layer::Seen::WhenAskedFor
            && strength_of(kept, in_hand) == 0) {
            kept.of.reset();
            continue;
        }
        // Lines of a layer that is always shown can change with the season or shape while the
        // plant's drawing stays the same. Lines of other layers cannot.
        bool const is_constant = kept.layer->seen != tools::Layer::Seen::Always;
        if (is_constant && kept.of && kept.of == scene.drawn)
            continue;
        kept.of = scene.drawn;
        auto lines_mm = kept.layer->lines(scene);
        if (lines_mm == kept.lines_mm)
            continue;
        kept.lines_mm = std::move(lines_mm);
        if (has_shown_)
            kept.age = Duration::zero();
    }
    has_shown_ = true;
    see(in_hand);
}

void ShownLayers::pass(Duration step, tools::Tool const& in_hand)
{
    bool has_changed = false;
    for (auto& kept : kept_) {
        double const before = strength_of(kept, in_hand);
        kept.age = std::min(kept.age, Duration::max() / 2) + step;
        has_changed = has_changed || strength_of(kept, in_hand) != before;
    }
    if (has_changed)
        see(in_hand);
}

void ShownLayers::see(tools::Tool const& in_hand)
{
    seen_.clear();
    for (auto const& kept : kept_)
        if (double const strength = strength_of(kept, in_hand);
            strength > 0 && !kept.lines_mm.empty())
            seen_.push_back({ kept.layer, kept.lines_mm, strength });
}

} // namespace tractus::view
