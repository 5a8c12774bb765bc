#include "app/window/height_gauge.h"

#include "app/window/theme.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus::window {

static constexpr float kAboveScale_px = 6;

void draw_height_gauge(view::WindowState const& state, ImVec2 const& corner, ImVec2 const& size,
                       Side side)
{
    auto* const draw = ImGui::GetWindowDrawList();
    double const low_mm = state.volume_mm.min_mm.z();
    double const range_mm = std::max(1.0, state.volume_mm.max_mm.z() - low_mm);
    // Leaves space above the gauge for the number of the height.
    float const top = corner.y + std::max(size.y * 0.08f, ImGui::GetFontSize() + kAboveScale_px);
    float const length = std::max(1.0f, corner.y + size.y * 0.92f - top);
    auto const y_of = [&](double height_mm) {
        return top + length * (1 - static_cast<float>((height_mm - low_mm) / range_mm));
    };
    bool const is_left = side == Side::Left;
    float const inwards = is_left ? 1.0f : -1.0f; // Direction towards the middle of the view.
    float const x = (is_left ? corner.x : corner.x + size.x) + inwards * size.x * 0.36f;
    draw->AddLine({ x, top }, { x, top + length }, theme::packed(theme::palette().unselected, 0.7f),
                  2);
    for (int tick = 0; tick <= 10; ++tick) {
        float const y = y_of(low_mm + range_mm * tick / 10);
        float const reach = inwards * size.x * (tick % 5 == 0 ? 0.22f : 0.12f);
        draw->AddLine({ x - reach, y }, { x, y }, theme::packed(theme::palette().unselected, 0.7f),
                      2);
    }
    float const y = y_of(std::clamp(state.surface_height_mm, low_mm, low_mm + range_mm));
    float const mark = size.x * 0.20f;
    float const tip = x + inwards * 2;
    float const foot = tip + inwards * mark;
    draw->AddTriangleFilled({ tip, y }, { foot, y - mark * 0.6f }, { foot, y + mark * 0.6f },
                            theme::packed(theme::palette().ink));
    auto const text = fmt::format("{:.0f} mm{}", state.surface_height_mm,
                                  state.is_outside_calibration ? " ?" : "");
    ImVec2 const text_size = ImGui::CalcTextSize(text.c_str());
    float const edge = is_left ? corner.x + 6 : corner.x + size.x - 6 - text_size.x;
    draw->AddText({ edge, top - text_size.y - kAboveScale_px },
                  theme::packed(state.is_outside_calibration ? theme::palette().indicator
                                                             : theme::palette().ink),
                  text.c_str());
    if (!state.is_outside_calibration)
        return;
    constexpr auto kOutside = "outside the calibrated range";
    float const left = is_left ? foot : foot - ImGui::CalcTextSize(kOutside).x;
    draw->AddText({ left, y + mark }, theme::packed(theme::palette().indicator), kOutside);
}

} // namespace tractus::window
