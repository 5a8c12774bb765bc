#include "app/window/tool_ring.h"

#include "app/window/icon.h"
#include "app/window/theme.h"
#include "engine/base/vectors.h"

#include <algorithm>
#include <cmath>

namespace tractus::window {

namespace {

constexpr float kRingInner_px = 62;
constexpr float kRingOuter_px = 190;
constexpr float kRingGap_rad = 0.035f;
constexpr float kRingIcon_px = 26;
constexpr float kRingIconLine_px = kRingIcon_px / 9;

float sector_rad(std::size_t count)
{
    return static_cast<float>(2 * kPi) / static_cast<float>(count);
}

float middle_angle(std::size_t number, std::size_t count)
{
    return -static_cast<float>(kPi) / 2 + sector_rad(count) * static_cast<float>(number);
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

std::optional<std::size_t> ToolRing::under(ImVec2 const& place_px, std::size_t count) const
{
    float const x = place_px.x - middle_px_.x;
    float const y = place_px.y - middle_px_.y;
    float const distance = std::hypot(x, y) / scale_;
    if (distance < kRingInner_px || distance > kRingOuter_px)
        return std::nullopt;
    float const turns = (std::atan2(y, x) + static_cast<float>(kPi) / 2) / sector_rad(count)
        + static_cast<float>(count);
    return static_cast<std::size_t>(std::lround(turns)) % count;
}

// Handles the pointer's touches. Returns true if the ring should be closed.
bool ToolRing::take_pointer(bool button_let_go, std::size_t count,
                            std::optional<std::size_t>& chosen)
{
    auto const pointed_at = under(ImGui::GetIO().MousePos, count);
    bool const is_touched = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    // If a touch opened the ring, the end of this touch over an entry chooses the entry; otherwise
    // a new touch does.
    bool const touch_begins = is_touched && !was_touched_;
    bool const first_touch_ends = !is_touched && was_touched_;
    was_touched_ = is_touched;
    if (touch_begins || ((button_let_go || first_touch_ends) && pointed_at))
        chosen = pointed_at;
    return chosen || touch_begins;
}

void ToolRing::draw_sector(std::span<RingEntry const> entries, std::size_t number,
                           bool is_pointed_at) const
{
    auto* const draw = ImGui::GetWindowDrawList();
    float const angle = middle_angle(number, entries.size());
    float const half = sector_rad(entries.size()) / 2 - kRingGap_rad / 2;
    float const middle_radius = (kRingInner_px + kRingOuter_px) / 2 * scale_;
    draw->PathArcTo(middle_px_, middle_radius, angle - half, angle + half, 24);
    draw->PathStroke(ImGui::GetColorU32(is_pointed_at ? ImGuiCol_ButtonActive : ImGuiCol_Button),
                     ImDrawFlags_None, (kRingOuter_px - kRingInner_px) * scale_);
    auto const& entry = entries[number];
    ImVec2 const size = ImGui::CalcTextSize(entry.text);
    ImVec2 const place = around(middle_px_, angle, middle_radius);
    draw->AddText({ place.x - size.x / 2, place.y - size.y / 2 }, ImGui::GetColorU32(ImGuiCol_Text),
                  entry.text);
    draw_icon(entry.icon, { place.x, place.y - size.y / 2 - 4 * scale_ }, kRingIcon_px * scale_,
              kRingIconLine_px * scale_);
}

std::optional<std::size_t> ToolRing::show(std::span<RingEntry const> entries, bool button_let_go)
{
    if (!is_open_)
        return std::nullopt;
    ImGui::SetNextWindowPos({ 0, 0 });
    ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
    ImGui::SetNextWindowFocus();
    ImGui::Begin("ring", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove
                     | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings);
    auto const pointed_at = under(ImGui::GetIO().MousePos, entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i)
        draw_sector(entries, i, pointed_at == i);
    std::optional<std::size_t> chosen;
    is_open_ = !take_pointer(button_let_go, entries.size(), chosen);
    ImGui::End();
    return chosen;
}

} // namespace tractus::window
