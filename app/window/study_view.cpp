#include "app/window/study_view.h"

#include "app/window/theme.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace tractus::window {

namespace {

// Layout of the pictures, in units of which the large picture is four wide. Beside it is a column
// of four details, one unit wide; below it is a row of six other pictures.
constexpr float kAcross = 5;
constexpr float kOther = kAcross / 6;
constexpr float kDown = 4 + kOther;
constexpr float kMargin_px = 6;
constexpr float kSliders_px = 290;
// Minimum width of the sliders, where the pictures need much of the width.
constexpr float kMinSliders_px = 210;
// Minimum size of the pictures' unit (see kAcross) for sliders beside the pictures.
constexpr float kMinUnit_px = 52;
constexpr float kMinRow_px = 24; // Minimum height of a slider.
constexpr float kCaption_px = 15;

// Escapes a text that ImGui will read as a format of printf.
std::string as_format(std::string const& text)
{
    std::string format;
    for (char const letter : text)
        format.append(letter == '%' ? 2 : 1, letter);
    return format;
}

} // namespace

void StudyView::show(view::StartPageModel& page, Controls const& controls)
{
    // A copy, because a slider may make the page replace its study.
    auto const study = *page.state().study;
    auto const corner = ImGui::GetCursorScreenPos();
    auto const room = ImGui::GetContentRegionAvail();
    float const gap = 2 * kMargin_px * scale_;
    float const sliders = std::clamp(room.x - gap - kAcross * kMinUnit_px * scale_,
                                     kMinSliders_px * scale_, kSliders_px * scale_);
    float const beside = std::min((room.x - sliders - gap) / kAcross, room.y / kDown);
    if (beside >= 0.99f * kMinUnit_px * scale_) {
        show_pictures(study, corner, beside);
        ImGui::SetCursorScreenPos({ corner.x + kAcross * beside + gap, corner.y });
        float const left = room.x - kAcross * beside - gap;
        show_sliders(page, controls, std::min(left, 1.6f * sliders), room.y);
        return;
    }
    float const unit = std::min(room.x / kAcross, 0.6f * room.y / kDown);
    show_pictures(study, { corner.x + (room.x - kAcross * unit) / 2, corner.y }, unit);
    ImGui::SetCursorScreenPos({ corner.x, corner.y + kDown * unit + gap });
    show_sliders(page, controls, room.x, 0);
    theme::scroll_by_dragging();
}

void StudyView::show_pictures(view::StartStudy const& study, ImVec2 const& corner, float unit)
{
    shown_.resize(1 + study.details.size() + study.others.size());
    std::size_t place = 0;
    auto const at = [&](float x, float y) {
        return ImVec2 { corner.x + x * unit, corner.y + y * unit };
    };
    show_picture(study.large, place++, corner, 4 * unit);
    for (std::size_t i = 0; i < study.details.size(); ++i)
        show_picture(study.details[i], place++, at(4, static_cast<float>(i)), unit);
    for (std::size_t i = 0; i < study.others.size(); ++i)
        show_picture(study.others[i], place++, at(kOther * static_cast<float>(i), 4),
                     kOther * unit);
}

void StudyView::show_picture(view::StartStudy::Picture const& picture, std::size_t place,
                             ImVec2 const& corner, float side)
{
    auto* const draw = ImGui::GetWindowDrawList();
    float const edge = side - kMargin_px * scale_;
    ImVec2 const to { corner.x + edge, corner.y + edge };
    float const rounding = ImGui::GetStyle().FrameRounding;
    auto& [known, texture] = shown_[place];
    if (known != picture.picture) {
        known = picture.picture;
        texture.reset();
        if (known && known->width() > 0)
            texture.emplace(*known);
    }
    if (texture)
        draw->AddImageRounded(
            reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture->texture())), corner,
            to, { 0, 0 }, { 1, 1 }, ImGui::GetColorU32({ 1, 1, 1, 1 }), rounding);
    else
        draw->AddRectFilled(corner, to, theme::packed(theme::palette().pad_background), rounding);
    // The title is dark in both themes, because the pictures have a white background.
    if (!picture.title.empty())
        draw->AddText(ImGui::GetFont(), kCaption_px * scale_,
                      { corner.x + kMargin_px * scale_, corner.y + kMargin_px * scale_ / 2 },
                      IM_COL32(90, 90, 90, 255), picture.title.c_str());
}

// Shows the sliders. `height` is the total height that they should have; at 0, each slider is as
// high as a button.
void StudyView::show_sliders(view::StartPageModel& page, Controls const& controls, float width,
                             float height)
{
    auto const study = *page.state().study;
    float const gap = ImGui::GetStyle().ItemSpacing.y;
    auto const rows = static_cast<float>(study.sliders.size() + 1);
    float const usual = theme::kButtonHeight_px * scale_;
    float const row = height > 0
        ? std::clamp((height - usual) / (rows - 1) - gap, kMinRow_px * scale_, usual)
        : usual;
    ImGui::BeginGroup();
    for (std::size_t i = 0; i < study.sliders.size(); ++i) {
        auto slider = study.sliders[i];
        if (this->slider(i, slider, width, row))
            page.slide(i, slider.value);
    }
    if (!study.accept.empty() && controls.button(study.accept.c_str(), width / scale_))
        page.accept();
    ImGui::EndGroup();
}

// Shows a slider. Returns true while the slider is dragged.
bool StudyView::slider(std::size_t number, view::StartStudy::Slider& slider, float width,
                       float height) const
{
    auto value = static_cast<float>(slider.value);
    auto const most = static_cast<float>(slider.most);
    ImGui::PushID(static_cast<int>(number));
    ImGui::PushStyleVar(
        ImGuiStyleVar_FramePadding,
        { ImGui::GetStyle().FramePadding.x, std::max(0.0f, (height - ImGui::GetFontSize()) / 2) });
    ImGui::SetNextItemWidth(width);
    bool const moves = ImGui::SliderFloat(
        "##slider", &value, 0, most, as_format(slider.text).c_str(), ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopStyleVar();
    ImGui::PopID();
    slider.value = static_cast<double>(value);
    return moves;
}

} // namespace tractus::window
