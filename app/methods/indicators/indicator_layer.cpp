#include "app/methods/indicators/indicator_layer.h"

namespace tractus::indicators {

namespace {

std::vector<std::vector<Vec3f>> arrows(scene::BuiltPlant const& plant)
{
    std::vector<std::vector<Vec3f>> lines;
    for (auto const& [id, indicator, at] : plant.indicators)
        lines.push_back({ indicator.start_mm.cast<float>(), indicator.end_mm.cast<float>() });
    return lines;
}

} // namespace

constexpr tools::Layer kIndicatorLayer {
    .label = "leaning",
    .style = { .color = tools::LayerStyle::Color::Orange,
               .end = tools::LayerStyle::End::Arrow,
               .width_mm = 3.5 },
    .lines = arrows,
};

} // namespace tractus::indicators
