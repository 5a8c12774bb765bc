#include "app/window/tool_ring.h"

#include "app/window/theme.h"
#include "engine/base/vectors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus {

namespace {

constexpr int kRingChoices = 8;
constexpr float kRingInner_px = 62;
constexpr float kRingOuter_px = 190;
constexpr float kRingGap_rad = 0.035f;
constexpr float kRingSector_rad = static_cast<float>(2 * kPi) / kRingChoices;

constexpr std::array<char const*, kRingChoices> kRingNames {
    "Draw", "Select", "Lean", "Erase", "View", "Undo", "Redo", "Next\nview"
};

float middle_angle(RingChoice choice)
{
    return -static_cast<float>(kPi) / 2 + kRingSector_rad * static_cast<float>(choice);
}

ImVec2 around(ImVec2 const& middle, float angle, float radius)
{
    return { middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle) };
}

} // namespace

void ToolRing::open(ImVec2 const& place_px, float scale)
{
    auto const& display = ImGui::GetIO().DisplaySize;
    float const reach = kRingOuter_px * scale;
    auto const within = [&](float place, float extent) {
        return extent > 2 * reach ? std::clamp(place, reach, extent - reach) : extent / 2;
    };
    middle_px_ = { within(place_px.x, display.x), within(place_px.y, display.y) };
    scale_ = scale;
    is_open_ = true;
    was_touched_ = true;
}

std::optional<RingChoice> ToolRing::under(ImVec2 const& place_px) const
{
    float const x = place_px.x - middle_px_.x;
    float const y = place_px.y - middle_px_.y;
    float const distance = std::hypot(x, y) / scale_;
    if (distance < kRingInner_px || distance > kRingOuter_px)
        return std::nullopt;
    float const turns
        = (std::atan2(y, x) + static_cast<float>(kPi) / 2) / kRingSector_rad + kRingChoices;
    return static_cast<RingChoice>(static_cast<int>(std::lround(turns)) % kRingChoices);
}

// True if the ring is done with.
bool ToolRing::take_pointer(bool button_let_go, std::optional<RingChoice>& chosen)
{
    auto const pointed_at = under(ImGui::GetIO().MousePos);
    bool const is_touched = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    // A touch that opened the ring must end before another counts; over a choice its end does.
    bool const touch_begins = is_touched && !was_touched_;
    bool const first_touch_ends = !is_touched && was_touched_;
    was_touched_ = is_touched;
    if (touch_begins || ((button_let_go || first_touch_ends) && pointed_at))
        chosen = pointed_at;
    return chosen || touch_begins;
}

void ToolRing::draw_sector(RingChoice choice, bool is_pointed_at) const
{
    auto* const draw = ImGui::GetWindowDrawList();
    float const angle = middle_angle(choice);
    float const half = kRingSector_rad / 2 - kRingGap_rad / 2;
    float const middle_radius = (kRingInner_px + kRingOuter_px) / 2 * scale_;
    draw->PathArcTo(middle_px_, middle_radius, angle - half, angle + half, 24);
    draw->PathStroke(ImGui::GetColorU32(is_pointed_at ? ImGuiCol_ButtonActive : ImGuiCol_Button),
                     ImDrawFlags_None, (kRingOuter_px - kRingInner_px) * scale_);
    char const* const name = kRingNames.at(static_cast<std::size_t>(choice));
    ImVec2 const size = ImGui::CalcTextSize(name);
    ImVec2 const place = around(middle_px_, angle, middle_radius);
    draw->AddText({ place.x - size.x / 2, place.y - size.y / 2 }, ImGui::GetColorU32(ImGuiCol_Text),
                  name);
}

std::optional<RingChoice> ToolRing::show(bool button_let_go)
{
    if (!is_open_)
        return std::nullopt;
    ImGui::SetNextWindowPos({ 0, 0 });
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::SetNextWindowFocus();
    ImGui::Begin("ring", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove
                     | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings);
    auto const pointed_at = under(ImGui::GetIO().MousePos);
    for (int i = 0; i < kRingChoices; ++i)
        draw_sector(RingChoice(i), pointed_at == RingChoice(i));
    std::optional<RingChoice> chosen;
    is_open_ = !take_pointer(button_let_go, chosen);
    ImGui::End();
    return chosen;
}

} // namespace tractus
