#include "app/window/number_panel.h"

#include "app/tools/tool_choices.h"
#include "app/window/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>
#include <imgui_stdlib.h>
#include <utility>

namespace tractus::window {

namespace {

constexpr float kValueWidth_px = 400;
constexpr float kKeyWidth_px = 84;
constexpr float kAir_px = 14;
constexpr int kKeysInRow = 3;
// The backspace key has a word as its label, because the font lacks the symbol.
constexpr std::array<std::pair<char const*, char>, 12> kKeys { {
    { "7", '7' },
    { "8", '8' },
    { "9", '9' },
    { "4", '4' },
    { "5", '5' },
    { "6", '6' },
    { "1", '1' },
    { "2", '2' },
    { "3", '3' },
    { "0", '0' },
    { ".", '.' },
    { "Del", 0 },
} };

std::string range_of(tools::NumberOption const& option)
{
    return tools::with_unit(fmt::format("{:g} to {:g}", option.least, option.greatest), option);
}

} // namespace

WindowPart NumberPanel::show(view::WindowModel& model, Workspace& workspace,
                             Controls const& controls, WindowPart const& bar)
{
    auto const numbers = tools::number_settings(workspace.hand(model.state()));
    if (!workspace.edited_number || *workspace.edited_number >= numbers.size()) {
        workspace.edited_number.reset();
        return {};
    }
    auto const number = *workspace.edited_number;
    auto const& chosen = numbers[number];
    if (std::exchange(asked_, chosen.option.name) != chosen.option.name) {
        typed_.clear();
        objection_.clear();
        ImGui::SetNextWindowFocus(); // Brings the panel to the front, as the bar had the focus.
    }
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, { kAir_px * scale_, kAir_px * scale_ });
    // If there is too little room above the bar, the panel overlaps the bar instead of leaving the
    // window.
    ImGui::SetNextWindowPos({ bar.left, std::max(bar.top - height_px_, 0.0f) });
    ImGui::Begin("number", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove
                     | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar();
    ImGui::BeginGroup();
    show_value(chosen, controls);
    if (controls.button("Close", kValueWidth_px))
        workspace.edited_number.reset();
    if (!objection_.empty())
        ImGui::TextColored(theme::imgui_color(theme::palette().indicator), "%s",
                           objection_.c_str());
    ImGui::EndGroup();
    ImGui::SameLine(0, 2 * kAir_px * scale_);
    ImGui::BeginGroup();
    show_keys(chosen, controls);
    ImGui::EndGroup();
    auto const corner = ImGui::GetWindowPos();
    auto const size = ImGui::GetWindowSize();
    height_px_ = size.y;
    ImGui::End();
    adjust(model, workspace, chosen, number);
    return { corner.x, corner.y, size.x, size.y };
}

// Sets the tool's number when a slider is released. While the slider is dragged, the number is only
// previewed.
void NumberPanel::adjust(view::WindowModel& model, Workspace& workspace,
                         tools::NumberSetting const& chosen, std::size_t number)
{
    auto const wanted = std::exchange(wanted_, std::nullopt);
    bool const moves = std::exchange(moves_, false);
    bool const is_released = std::exchange(is_released_, false);
    bool const changes = wanted && *wanted != chosen.value;
    if (!changes && !(is_released && workspace.adjusted))
        return;
    auto const slider
        = moves ? view::ChangeGrowth::Slider::Moving : view::ChangeGrowth::Slider::Released;
    workspace.adjust(
        model,
        tools::with_number(workspace.hand(model.state()), number, wanted.value_or(chosen.value)),
        slider);
}

// Shows the number in words, its range, a slider, and buttons for a step down and a step up.
void NumberPanel::show_value(tools::NumberSetting const& chosen, Controls const& controls)
{
    auto const& option = chosen.option;
    ImGui::TextUnformatted(tools::describe_number(chosen).c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("%s", range_of(option).c_str());
    auto value = static_cast<float>(chosen.value);
    theme::push_button_frame(scale_);
    ImGui::SetNextItemWidth(kValueWidth_px * scale_);
    if (ImGui::SliderFloat("##value", &value, static_cast<float>(option.least),
                           static_cast<float>(option.greatest), "%g", ImGuiSliderFlags_NoInput))
        change_to(option, std::round(static_cast<double>(value) / option.step) * option.step);
    moves_ = ImGui::IsItemActive();
    is_released_ = ImGui::IsItemDeactivated();
    ImGui::PopStyleVar();
    float const gap_px = ImGui::GetStyle().ItemSpacing.x / scale_;
    float const half_px = (kValueWidth_px - gap_px) / 2;
    ImGui::PushButtonRepeat(true);
    if (controls.button(fmt::format("less by {:g}", option.step).c_str(), half_px))
        change_to(option, chosen.value - option.step);
    ImGui::SameLine();
    if (controls.button(fmt::format("more by {:g}", option.step).c_str(), half_px))
        change_to(option, chosen.value + option.step);
    ImGui::PopButtonRepeat();
}

void NumberPanel::show_keys(tools::NumberSetting const& chosen, Controls const& controls)
{
    float const gap_px = ImGui::GetStyle().ItemSpacing.x / scale_;
    float const keys_px = kKeysInRow * kKeyWidth_px + (kKeysInRow - 1) * gap_px;
    theme::push_button_frame(scale_);
    ImGui::SetNextItemWidth((keys_px - kKeyWidth_px - gap_px) * scale_);
    bool const is_entered = ImGui::InputTextWithHint("##typed", "type", &typed_,
                                                     ImGuiInputTextFlags_CharsDecimal
                                                         | ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::PopStyleVar();
    ImGui::SameLine();
    if (controls.button("Set", kKeyWidth_px) || is_entered)
        take_typed(chosen.option);
    for (std::size_t i = 0; i < kKeys.size(); ++i) {
        if (i % kKeysInRow != 0)
            ImGui::SameLine();
        if (controls.button(kKeys[i].first, kKeyWidth_px))
            press_key(kKeys[i].second);
    }
}

void NumberPanel::press_key(char key)
{
    constexpr std::size_t kMaxDigits = 9;
    objection_.clear();
    if (key != 0 && typed_.size() < kMaxDigits)
        typed_ += key;
    else if (key == 0 && !typed_.empty())
        typed_.pop_back();
}

void NumberPanel::take_typed(tools::NumberOption const& option)
{
    if (typed_.empty())
        return;
    wanted_ = tools::read_number(option, typed_);
    objection_ = wanted_ ? "" : fmt::format("It takes {}", range_of(option));
    if (wanted_)
        typed_.clear();
}

void NumberPanel::change_to(tools::NumberOption const& option, double value)
{
    objection_.clear();
    wanted_ = std::clamp(value, option.least, option.greatest);
}

} // namespace tractus::window
