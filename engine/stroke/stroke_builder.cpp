#include "engine/stroke/stroke_builder.h"

#include <algorithm>
#include <utility>

namespace tractus {

static bool has_two_points(Stroke const& stroke)
{
    return std::any_of(stroke.tips.begin(), stroke.tips.end(), [&](TipSample const& tip) {
        return tip.position_mm != stroke.tips.front().position_mm;
    });
}

void StrokeBuilder::push_live(TipSample const& tip)
{
    auto const last = live_.empty() ? last_settled_ : live_.back().time;
    if (!tip.position_mm.allFinite() || (last && tip.time <= *last))
        return;
    // One hovering tip is enough to separate two strokes in the ink.
    bool const ink_goes_on = live_.empty() ? !stroke_.tips.empty() : live_.back().touching;
    if (tip.touching || ink_goes_on)
        live_.push_back(tip);
}

std::optional<Stroke> StrokeBuilder::push(TipSample const& tip)
{
    if (!tip.position_mm.allFinite() || (last_settled_ && tip.time <= *last_settled_))
        return std::nullopt;
    last_settled_ = tip.time;
    auto const first_later = std::find_if(live_.begin(), live_.end(),
                                          [&](auto const& live) { return live.time > tip.time; });
    live_.erase(live_.begin(), first_later);

    std::optional<Stroke> ended;
    if (!stroke_.tips.empty() && !tip.touching)
        ended = take_stroke();
    if (tip.touching)
        stroke_.tips.push_back(tip);
    return ended;
}

std::optional<Stroke> StrokeBuilder::finish()
{
    live_.clear();
    return take_stroke();
}

std::vector<TipSample> StrokeBuilder::ink() const
{
    auto ink = stroke_.tips.vector();
    ink.insert(ink.end(), live_.begin(), live_.end());
    return ink;
}

std::optional<Stroke> StrokeBuilder::take_stroke()
{
    auto stroke = std::exchange(stroke_, {});
    if (!has_two_points(stroke))
        return std::nullopt;
    stroke.tips.own().shrink_to_fit(); // Frees unused capacity: the stroke may be kept for hours.
    return stroke;
}

} // namespace tractus
