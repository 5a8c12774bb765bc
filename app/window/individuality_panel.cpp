#include "app/window/individuality_panel.h"

#include "app/window/theme.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>

namespace tractus::window {

namespace {

constexpr float kIndividualityWidth_px = 430;
// Maximum width of the panel, as a share of the width available to panel and sheet.
constexpr float kIndividualityShare = 0.42f;
constexpr float kSwitchWidth_px = 128;

struct Trait {
    char const* name;
    double variation::Individuality::*number;
    double greatest;
    char const* text;  // Format of the label. Its argument is the number, multiplied by `unit`.
    double unit = 100; // Factor from the number to the label's unit; 100 for percent.
};

constexpr std::array<Trait, 6> kTraits {
    { { "Own seeds", &variation::Individuality::seeds, 1, "{:.0f} %% of the plants" },
      { "Branches", &variation::Individuality::branches, 0.5, "{:.0f} %% lost, or twice" },
      { "Size", &variation::Individuality::size, 0.5, "{:.0f} %% more or less" },
      { "Turn", &variation::Individuality::turn, 1, "up to {:.0f}°", 360 },
      { "Age", &variation::Individuality::age, 0.9, "up to {:.0f} %% younger" },
      { "Leaves", &variation::Individuality::organs, 0.5, "{:.0f} %% more or less" } }
};

} // namespace

float IndividualityPanel::width_px(float room_px) const
{
    return std::min(kIndividualityWidth_px * scale_, kIndividualityShare * room_px);
}

IndividualityPanel::Change IndividualityPanel::show_row(Controls const& controls, Row const& row,
                                                        double& value, double& when_on) const
{
    bool const is_on = value > 0;
    auto change = Change::None;
    if (controls.button(row.name, kSwitchWidth_px, is_on)) {
        if (is_on)
            when_on = value;
        value = is_on ? 0 : when_on;
        change = Change::Released;
    }
    ImGui::SameLine();
    auto shown = static_cast<float>(value);
    ImGui::SetNextItemWidth(row_px_ - kSwitchWidth_px * scale_ - ImGui::GetStyle().ItemSpacing.x);
    theme::push_button_frame(scale_);
    auto const name = fmt::format("##{}", row.name);
    if (ImGui::SliderFloat(name.c_str(), &shown, 0, static_cast<float>(row.greatest),
                           is_on ? row.text.c_str() : "off", ImGuiSliderFlags_AlwaysClamp)) {
        value = static_cast<double>(shown);
        change = Change::Moving;
    }
    ImGui::PopStyleVar();
    return ImGui::IsItemDeactivatedAfterEdit() ? Change::Released : change;
}

void IndividualityPanel::show(view::WindowModel& model, Controls const& controls,
                              WindowPart const& part, std::size_t count)
{
    ImGui::SetCursorScreenPos({ part.left, part.top });
    ImGui::BeginChild("individuality", { part.width, part.height });
    row_px_ = ImGui::GetContentRegionAvail().x;
    auto how = moving_.value_or(model.state().individuality);
    bool is_released = false;
    for (auto const& trait : kTraits) {
        double& number = how.*trait.number;
        Row const row { trait.name, trait.greatest,
                        fmt::format(fmt::runtime(trait.text), number * trait.unit) };
        auto const change = show_row(controls, row, number, when_on_.*trait.number);
        if (change != Change::None)
            moving_ = how;
        is_released |= change == Change::Released;
    }
    show_growth(model, controls);
    theme::scroll_by_dragging();
    ImGui::EndChild();
    if (is_released) {
        moving_.reset();
        model.perform(view::RequestCollection { count, how });
    }
}

// Shows the variability of growth, a property of the plant and not of the collection.
void IndividualityPanel::show_growth(view::WindowModel& model, Controls const& controls)
{
    view::ChangeGrowth change { .growth = model.state().growth };
    double& variability = change.growth.variability;
    Row const row { "Growth", 4, fmt::format("variability {:.2f}", variability) };
    auto const done = show_row(controls, row, variability, variability_when_on_);
    if (done == Change::None)
        return;
    change.slider = done == Change::Released ? view::ChangeGrowth::Slider::Released
                                             : view::ChangeGrowth::Slider::Moving;
    model.perform(change);
}

} // namespace tractus::window
