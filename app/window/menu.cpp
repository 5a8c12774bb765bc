#include "app/window/menu.h"

#include "app/window/theme.h"
#include "engine/variation/growth_preset.h"

#include <algorithm>
#include <string>
#include <utility>

namespace tractus {

namespace {

constexpr float kMenuWidth_px = 460;
constexpr float kMenuItem_px = 420;
constexpr float kMenuHalfItem_px = 204; // Two beside each other.

} // namespace

WindowPart Menu::show(WindowModel& model, Workbench& bench, Controls const& controls,
                      WindowPart const& room, std::function<Image()> const& picture) const
{
    float const width = std::min(kMenuWidth_px * scale_, room.width);
    WindowPart const part { room.left + room.width - width, room.top, width, room.height };
    ImGui::SetNextWindowPos({ part.left, part.top });
    ImGui::SetNextWindowSize({ part.width, part.height });
    ImGui::Begin("menu", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove
                     | ImGuiWindowFlags_NoSavedSettings);
    show_growth(model, controls);
    ImGui::Spacing();
    if (controls.button("Save picture", kMenuHalfItem_px))
        model.perform(SavePicture { picture() });
    ImGui::SameLine();
    if (controls.button("Keys", kMenuHalfItem_px, bench.keys_are_listed))
        bench.keys_are_listed = !bench.keys_are_listed;
    if (controls.button("Close", kMenuHalfItem_px))
        bench.wants_to_close = true;
    ImGui::SameLine();
    if (model.state().is_live && controls.button("Start again", kMenuHalfItem_px))
        model.perform(Restart {});
    if (controls.button(theme::palette().is_light ? "Dark" : "Light", kMenuHalfItem_px))
        theme::set_light(!theme::palette().is_light);
    ImGui::End();
    return part;
}

void Menu::show_growth(WindowModel& model, Controls const& controls) const
{
    if (controls.button("Another one", kMenuItem_px))
        model.perform(NextVariation {});
    ChangeGrowth change { .growth = model.state().growth };
    auto& growth = change.growth;
    bool is_released = false;
    bool moves = show_slider("##age", "age %.2f", 1, growth.age, is_released);
    moves |= show_slider("##liking", growth.liking < 0.01 ? "as drawn" : "%.2f x as it likes", 4,
                         growth.liking, is_released);
    if (moves || is_released) {
        change.slider = is_released ? ChangeGrowth::Slider::Released : ChangeGrowth::Slider::Moving;
        model.perform(change);
    }
    bool is_left = true;
    for (auto const& preset : growth_presets()) {
        std::string const name(preset.name);
        if (!std::exchange(is_left, !is_left))
            ImGui::SameLine();
        if (!controls.button(name.c_str(), kMenuHalfItem_px, growth.preset == name))
            continue;
        growth.preset = name;
        change.slider = ChangeGrowth::Slider::Released;
        model.perform(change);
    }
}

// True while the slider moves.
bool Menu::show_slider(char const* name, char const* text, float greatest, double& value,
                       bool& is_released) const
{
    auto shown = static_cast<float>(value);
    float const air_px = (theme::kButtonHeight_px * scale_ - ImGui::GetFontSize()) / 2;
    ImGui::SetNextItemWidth(kMenuItem_px * scale_);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, { 16 * scale_, air_px });
    bool const moves
        = ImGui::SliderFloat(name, &shown, 0, greatest, text, ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopStyleVar();
    if (moves)
        value = static_cast<double>(shown);
    is_released |= ImGui::IsItemDeactivatedAfterEdit();
    return moves;
}

} // namespace tractus
