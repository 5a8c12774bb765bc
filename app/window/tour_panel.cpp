#include "app/window/tour_panel.h"

#include <algorithm>
#include <fmt/format.h>

namespace tractus::window {

namespace {

constexpr float kTourMargin_px = 12;
constexpr float kSkipButton_px = 96;
constexpr float kEndButton_px = 150;

} // namespace

WindowPart TourPanel::show(view::WindowModel& model, Controls const& controls,
                           WindowPart const& bar)
{
    auto const tour = *model.state().tour;
    float const margin = kTourMargin_px * scale_;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, { margin, margin });
    ImGui::SetNextWindowPos({ bar.left, std::max(bar.top - height_px_, 0.0f) });
    ImGui::SetNextWindowSize({ bar.width, 0 });
    ImGui::Begin("tour", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove
                     | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    float const gap = ImGui::GetStyle().ItemSpacing.x;
    float const buttons
        = (tour.is_last ? kEndButton_px : kSkipButton_px + kEndButton_px) * scale_ + gap;
    float const room = ImGui::GetContentRegionAvail().x;
    auto const place = ImGui::GetCursorPos();
    show_words(tour, std::max(room - buttons - 2 * gap, room / 2));
    float const bottom = ImGui::GetCursorPosY();
    ImGui::SetCursorPos({ place.x + room - buttons, place.y });
    bool const is_skipped = !tour.is_last && controls.button("Skip", kSkipButton_px);
    if (!tour.is_last)
        ImGui::SameLine();
    bool const is_ended
        = controls.button(tour.is_last ? "Close the tour" : "End the tour", kEndButton_px);
    ImGui::SetCursorPosY(std::max(bottom, ImGui::GetCursorPosY()));
    auto const corner = ImGui::GetWindowPos();
    auto const size = ImGui::GetWindowSize();
    height_px_ = size.y;
    ImGui::End();
    ImGui::PopStyleVar();
    if (is_skipped)
        model.perform(view::SkipTourStep {});
    if (is_ended)
        model.perform(view::EndTour {});
    return { corner.x, corner.y, size.x, size.y };
}

void TourPanel::show_words(view::TourView const& tour, float width) const
{
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    ImGui::PushFont(title_font_);
    ImGui::TextUnformatted(tour.task.c_str());
    ImGui::PopFont();
    auto const number = fmt::format("{} of {}", tour.step, tour.count);
    ImGui::SameLine();
    if (ImGui::GetCursorPosX() + ImGui::CalcTextSize(number.c_str()).x < width)
        ImGui::TextDisabled("%s", number.c_str());
    else
        ImGui::NewLine();
    ImGui::TextUnformatted(tour.how.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
}

} // namespace tractus::window
