#include "app/window/strokes_view.h"

#include "app/window/stroke_scene.h"
#include "app/window/theme.h"

#include <algorithm>
#include <fmt/core.h>
#include <string>
#include <utility>

namespace tractus::window {

namespace {

constexpr float kPickReach_px = 14; // Maximum distance of a click from the curve that it picks.
// A press that moves farther than this is a drag and does not pick a curve.
constexpr float kStill_px = 5;
// Height of a row in the list of curves; large enough for the pen.
constexpr float kListRow_px = 38;
// Minimum height of the view, in lines of text, at which the front edge has a label.
constexpr float kLinesForFront = 16;

float display_scale()
{
    return ImGui::GetFontSize() / theme::kTextSize_px;
}

render::Backdrop strokes_backdrop()
{
    auto const& color = theme::palette().pad_background;
    return { .top = color, .bottom = color, .ground = {}, .has_ground = false };
}

} // namespace

void StrokesView::pick(std::optional<std::size_t> curve)
{
    if (std::exchange(picked_, curve) != curve)
        ++picks_;
}

void StrokesView::follow(view::WindowState const& state)
{
    auto const newest = state.curves.empty() ? 0 : state.curves.back().edit;
    bool const is_other_list
        = std::exchange(curve_count_, state.curves.size()) != state.curves.size()
        || newest != newest_edit_;
    newest_edit_ = newest;
    if (is_other_list) {
        pick(std::nullopt);
        list_is_behind_ = true;
    }
    highlighted_ = highlighted_curves(state, picked_);
}

std::optional<std::size_t> StrokesView::show(view::WindowState const& state,
                                             render::Renderer& renderer, ImVec2 const& size_px,
                                             ViewDrag drag)
{
    follow(state);
    auto const revision = state.curves_revision + picks_;
    bool changed = std::exchange(turned_, false);
    changed |= curves_.follow(revision, [&] { return stroke_curves(state, highlighted_); });
    changed |= live_.follow(state.live_revision + state.preview_revision,
                            [&] { return live_stroke_curves(state); });
    changed |= ground_.follow(revision, [&] { return ground_curves(state, highlighted_); });
    auto const corner_px = ImGui::GetCursorScreenPos();
    auto const& canvas = canvas_.sized(size_px, changed);
    auto const camera
        = orbit_.camera(strokes_box(state), static_cast<double>(canvas.width()) / canvas.height());
    if (changed) {
        render::Stage stage;
        stage.curves = { ground_.curves(), curves_.curves(), live_.curves() };
        stage.backdrop = strokes_backdrop();
        renderer.draw(stage, camera, canvas);
    }
    canvas_.show();
    draw_labels(state, corner_px, size_px);
    ImGui::SetCursorScreenPos(corner_px);
    bool const is_pressed = ImGui::InvisibleButton("strokes", size_px);
    turned_ = orbit_.take_input(display_scale(), size_px.y, drag);
    auto const& io = ImGui::GetIO();
    float const still_px = kStill_px * display_scale();
    if (!is_pressed || io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > still_px * still_px)
        return std::nullopt;
    PictureProjection const projection(camera, { size_px.x, size_px.y });
    auto const hit = curve_at(state.curves, projection,
                              { io.MousePos.x - corner_px.x, io.MousePos.y - corner_px.y },
                              kPickReach_px * display_scale());
    pick(hit);
    return hit;
}

void StrokesView::draw_labels(view::WindowState const& state, ImVec2 const& corner_px,
                              ImVec2 const& size_px) const
{
    auto const camera = orbit_.camera(strokes_box(state),
                                      static_cast<double>(std::max(1, static_cast<int>(size_px.x)))
                                          / std::max(1, static_cast<int>(size_px.y)));
    PictureProjection const projection(camera, { size_px.x, size_px.y });
    auto* const draw = ImGui::GetWindowDrawList();
    draw->PushClipRect(corner_px, { corner_px.x + size_px.x, corner_px.y + size_px.y }, true);
    auto const at = [&](Vec2f const& place_px) {
        return ImVec2(corner_px.x + place_px.x(), corner_px.y + place_px.y());
    };
    bool const has_room = size_px.y > kLinesForFront * ImGui::GetFontSize();
    if (auto const front_px = projection.to_px(front_mm(state)); front_px && has_room)
        draw->AddText(at(*front_px), ImGui::GetColorU32(ImGuiCol_TextDisabled), "front");
    float const air_px = ImGui::GetFontSize() / 5;
    auto const widest = ImGui::CalcTextSize(std::to_string(state.curves.size()).c_str());
    Vec2f const label_px(widest.x + 2 * air_px, widest.y);
    auto const background = theme::palette().pad_background;
    for (auto const& [curve, place_px] :
         curve_labels(state.curves, highlighted_, projection, label_px)) {
        bool const stands_out = std::ranges::binary_search(highlighted_, curve);
        auto const number = std::to_string(curve + 1);
        auto const color = curve_color(curve);
        auto const low = at(place_px);
        ImVec2 const high(low.x + ImGui::CalcTextSize(number.c_str()).x + 2 * air_px,
                          low.y + label_px.y());
        draw->AddRectFilled(
            low, high, stands_out ? theme::packed(color) : theme::packed(background, 0.7f), air_px);
        draw->AddText({ low.x + air_px, low.y },
                      stands_out ? theme::packed(background) : theme::packed(color),
                      number.c_str());
    }
    draw->PopClipRect();
}

void StrokesView::show_row(view::WindowState const& state, std::size_t curve, float width_px,
                           std::optional<std::size_t>& pressed) const
{
    float const row_px = kListRow_px * display_scale();
    auto const place = ImGui::GetCursorScreenPos();
    bool const stands_out = std::ranges::binary_search(highlighted_, curve);
    ImGui::PushID(static_cast<int>(curve));
    if (ImGui::Selectable("##curve", stands_out, 0, { width_px, row_px }))
        pressed = curve;
    ImGui::PopID();
    auto* const draw = ImGui::GetWindowDrawList();
    float const letter_px = ImGui::GetFontSize();
    float const text_y = place.y + (row_px - letter_px) / 2;
    float const middle = place.y + row_px / 2;
    draw->AddLine({ place.x + letter_px * 0.3f, middle }, { place.x + letter_px * 1.5f, middle },
                  theme::packed(curve_color(curve)), letter_px / 4);
    auto const text = fmt::format("{}  {}", curve + 1, state.curves[curve].name);
    draw->AddText({ place.x + letter_px * 2, text_y }, ImGui::GetColorU32(ImGuiCol_Text),
                  text.c_str());
}

std::optional<std::size_t> StrokesView::show_list(view::WindowState const& state,
                                                  ImVec2 const& size_px)
{
    follow(state);
    std::optional<std::size_t> pressed;
    ImGui::BeginChild("stroke list", size_px);
    float const width_px = ImGui::GetContentRegionAvail().x;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(state.curves.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            show_row(state, static_cast<std::size_t>(i), width_px, pressed);
    clipper.End();
    if (std::exchange(list_is_behind_, false))
        ImGui::SetScrollHereY(1);
    theme::scroll_by_dragging();
    ImGui::EndChild();
    if (pressed)
        pick(pressed);
    return pressed;
}

void StrokesView::show_caption(view::WindowState const& state, ImVec2 const& corner_px) const
{
    if (highlighted_.empty() || highlighted_.back() >= state.curves.size())
        return;
    auto const curve = highlighted_.back();
    auto const text = highlighted_.size() == 1
        ? fmt::format("{}  {}", curve + 1, state.curves[curve].name)
        : fmt::format("{} strokes shape what is selected", highlighted_.size());
    ImGui::GetWindowDrawList()->AddText({ corner_px.x, corner_px.y - ImGui::GetFontSize() },
                                        ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
}

void StrokesView::zoom(double factor)
{
    orbit_.zoom(factor);
    turned_ = true;
}

void StrokesView::look_at_whole()
{
    orbit_.look_at_whole();
    turned_ = true;
}

} // namespace tractus::window
