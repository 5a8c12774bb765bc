#include "app/methods/indicators/indicator_layer.h"

namespace tractus {

namespace {

std::vector<std::vector<Vec3f>> arrows(BuiltPlant const& plant)
{
    std::vector<std::vector<Vec3f>> lines;
    for (auto const& [id, indicator, at] : plant.indicators)
        lines.push_back({ indicator.start_mm.cast<float>(), indicator.end_mm.cast<float>() });
    return lines;
}

} // namespace

constexpr Layer kIndicatorLayer {
    .label = "leaning",
    .style = { .color = LayerStyle::Color::Orange, .end = LayerStyle::End::Arrow, .width_mm = 3.5 },
    .lines = arrows,
};

} // namespace tractus
