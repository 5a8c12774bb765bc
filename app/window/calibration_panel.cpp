#include "app/window/calibration_panel.h"

#include "app/window/theme.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>

namespace tractus::window {

namespace {

constexpr std::array kProcedures {
    calibration::CalibrationProcedure::Height,  calibration::CalibrationProcedure::Travel,
    calibration::CalibrationProcedure::Latency, calibration::CalibrationProcedure::Tilt,
    calibration::CalibrationProcedure::Zero,    calibration::CalibrationProcedure::Check
};
constexpr std::array<char const*, 6> kTitles { "Height", "Travel", "Latency",
                                               "Tilt",   "Zero",   "Check" };

constexpr ImGuiWindowFlags kPadded = ImGuiWindowFlags_AlwaysUseWindowPadding;

Vec3f const kRefused { 0.93f, 0.40f, 0.33f };

Vec3f color_of(calibration::PlotTone tone)
{
    switch (tone) {
    case calibration::PlotTone::Model:
        return theme::palette().assigned;
    case calibration::PlotTone::FromBelow:
        return theme::palette().selected;
    case calibration::PlotTone::FromAbove:
        return theme::palette().stroke;
    case calibration::PlotTone::FromNowhere:
        return theme::palette().unselected;
    case calibration::PlotTone::Slipped:
        return kRefused;
    case calibration::PlotTone::Expected:
        return theme::palette().unselected;
    case calibration::PlotTone::Measured:
        return theme::palette().selected;
    }
    return theme::palette().unselected;
}

// Frame of a plot. It maps the plot's values to pixels.
class Frame {
public:
    Frame(calibration::Plot const& plot, ImVec2 const& corner, ImVec2 const& size)
        : plot_(plot)
        , draw_(*ImGui::GetWindowDrawList())
        , letter_(ImGui::GetFontSize())
        , low_(corner.x + 3.6f * letter_, corner.y + 1.6f * letter_)
        , high_(corner.x + size.x - 0.6f * letter_, corner.y + size.y - 2.6f * letter_)
    {
    }

    void draw()
    {
        draw_grid();
        draw_.PushClipRect(low_, high_, true);
        for (auto const& series : plot_.series)
            draw_series(series);
        draw_.PopClipRect();
        draw_labels();
    }

private:
    ImVec2 place(Vec2 const& value) const
    {
        Vec2 const part = (value - plot_.low).cwiseQuotient(plot_.high - plot_.low);
        return { low_.x + static_cast<float>(part.x()) * (high_.x - low_.x),
                 high_.y - static_cast<float>(part.y()) * (high_.y - low_.y) };
    }

    void draw_grid()
    {
        auto const dim = ImGui::GetColorU32(ImGuiCol_TextDisabled);
        for (double const x : calibration::ticks_between(plot_.low.x(), plot_.high.x(), 5)) {
            auto const at = place({ x, plot_.low.y() });
            auto const text = calibration::tick_text(x);
            draw_.AddLine(at, { at.x, low_.y }, theme::packed(theme::palette().grid));
            draw_.AddText({ at.x - ImGui::CalcTextSize(text.c_str()).x / 2, high_.y + 2 }, dim,
                          text.c_str());
        }
        for (double const y : calibration::ticks_between(plot_.low.y(), plot_.high.y(), 5)) {
            auto const at = place({ plot_.low.x(), y });
            auto const text = calibration::tick_text(y);
            draw_.AddLine(at, { high_.x, at.y }, theme::packed(theme::palette().grid));
            draw_.AddText({ at.x - ImGui::CalcTextSize(text.c_str()).x - 6, at.y - letter_ / 2 },
                          dim, text.c_str());
        }
    }

    void draw_series(calibration::PlotSeries const& series)
    {
        auto const color = theme::packed(color_of(series.tone));
        switch (series.kind) {
        case calibration::PlotSeries::Kind::Line:
            for (std::size_t i = 1; i < series.points.size(); ++i)
                draw_.AddLine(place(series.points[i - 1]), place(series.points[i]), color, 2.5f);
            break;
        case calibration::PlotSeries::Kind::Band:
            for (std::size_t i = 1; i < std::min(series.points.size(), series.upper.size()); ++i)
                draw_.AddQuadFilled(place(series.points[i - 1]), place(series.points[i]),
                                    place(series.upper[i]), place(series.upper[i - 1]),
                                    theme::packed(color_of(series.tone), 0.22f));
            break;
        case calibration::PlotSeries::Kind::Bars:
            for (auto const& point : series.points)
                draw_.AddRectFilled(place({ point.x() - 0.47 * series.bar_width, point.y() }),
                                    place({ point.x() + 0.47 * series.bar_width, 0 }), color);
            break;
        case calibration::PlotSeries::Kind::Dots:
            for (auto const& point : series.points)
                draw_.AddCircleFilled(place(point), letter_ * 0.32f, color);
            break;
        case calibration::PlotSeries::Kind::Crosses:
            for (auto const& point : series.points)
                draw_cross(place(point), color);
            break;
        }
    }

    void draw_cross(ImVec2 const& at, ImU32 color)
    {
        float const reach = letter_ * 0.35f;
        draw_.AddLine({ at.x - reach, at.y - reach }, { at.x + reach, at.y + reach }, color, 4);
        draw_.AddLine({ at.x - reach, at.y + reach }, { at.x + reach, at.y - reach }, color, 4);
    }

    void draw_labels()
    {
        auto const dim = ImGui::GetColorU32(ImGuiCol_TextDisabled);
        draw_line(low_.y - 1.5f * letter_, ImGui::GetColorU32(ImGuiCol_Text), plot_.title);
        draw_line(high_.y + 1.15f * letter_, dim,
                  fmt::format("{} over {}", plot_.y_label, plot_.x_label));
    }

    // Draws a line of text above or below the frame, in a smaller size if the text is wider than
    // the frame.
    void draw_line(float y, ImU32 color, std::string const& text)
    {
        float const longer = ImGui::CalcTextSize(text.c_str()).x / (high_.x - low_.x);
        draw_.AddText(ImGui::GetFont(), letter_ / std::max(1.0f, longer), { low_.x, y }, color,
                      text.c_str());
    }

    calibration::Plot const& plot_;
    ImDrawList& draw_;
    float letter_;
    ImVec2 low_;  // Upper left corner of the frame, in pixels.
    ImVec2 high_; // Lower right corner of the frame, in pixels.
};

char const* word_for(calib::HeightCapture::From from)
{
    switch (from) {
    case calib::HeightCapture::From::Below:
        return "up";
    case calib::HeightCapture::From::Above:
        return "down";
    case calib::HeightCapture::From::Nowhere:
        return "-";
    }
    return "-";
}

// Places the next button beside the last one if there is room, otherwise below it.
void same_line_if_room(float width, float gap)
{
    float const right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    if (ImGui::GetItemRectMax().x + gap + width <= right)
        ImGui::SameLine(0, gap);
}

} // namespace

void show_plot(calibration::Plot const& plot, ImVec2 const& size_px)
{
    auto const corner = ImGui::GetCursorScreenPos();
    ImGui::Dummy(size_px);
    Frame(plot, corner, size_px).draw();
}

bool CalibrationPanel::show(calibration::CalibrationModel& model, bool may_go_back)
{
    bool const wants_back = show_procedures(model, may_go_back);
    show_reading(model.view());
    ImVec2 const room = ImGui::GetContentRegionAvail();
    auto const spacing = ImGui::GetStyle().ItemSpacing;
    constexpr float kControls_px = 520;
    ImGui::BeginChild("captures", { std::max(room.x * 0.38f, kControls_px * scale_), 0 }, false,
                      kPadded);
    show_controls(model);
    show_captures(model.view());
    theme::scroll_by_dragging();
    ImGui::EndChild();
    ImGui::SameLine();
    ImGui::BeginChild("plots", { 0, 0 }, false, kPadded);
    auto const& plots = model.view().plots;
    ImVec2 const inside = ImGui::GetContentRegionAvail();
    ImVec2 const size((inside.x - spacing.x) / 2, (inside.y - spacing.y) / 2);
    for (std::size_t i = 0; i < plots.size(); ++i) {
        if (i % 2 == 1)
            ImGui::SameLine();
        show_plot(plots[i], size);
    }
    ImGui::EndChild();
    return wants_back;
}

bool CalibrationPanel::show_procedures(calibration::CalibrationModel& model, bool may_go_back)
{
    ImVec2 const size(100 * scale_, theme::kButtonHeight_px * scale_);
    auto const present = model.view().procedure;
    for (std::size_t i = 0; i < kProcedures.size(); ++i) {
        if (i > 0)
            same_line_if_room(size.x, ImGui::GetStyle().ItemSpacing.x);
        bool const is_present = kProcedures[i] == present;
        if (is_present)
            ImGui::PushStyleColor(ImGuiCol_Button, theme::imgui_color(theme::palette().assigned));
        if (ImGui::Button(kTitles[i], size) && !is_present)
            model.perform(calibration::ChooseProcedure { kProcedures[i] });
        if (is_present)
            ImGui::PopStyleColor();
    }
    if (!may_go_back)
        return false;
    ImVec2 const back(230 * scale_, size.y);
    same_line_if_room(back.x, 48 * scale_);
    return ImGui::Button("Back to drawing", back);
}

void CalibrationPanel::show_reading(calibration::CalibrationView const& view)
{
    ImGui::PushFont(title_font_);
    if (view.is_on_rail)
        ImGui::TextColored(theme::imgui_color(kRefused), "%s", view.reading.c_str());
    else
        ImGui::TextUnformatted(view.reading.c_str());
    ImGui::PopFont();
    ImGui::PushStyleColor(ImGuiCol_Text,
                          theme::imgui_color(view.is_refusal ? kRefused : theme::palette().ink));
    ImGui::TextWrapped("%s", view.message.c_str());
    ImGui::PopStyleColor();
}

void CalibrationPanel::show_controls(calibration::CalibrationModel& model)
{
    // Values are copied from the view, because a command may replace the view meanwhile.
    auto const& view = model.view();
    bool const is_moving = view.is_moving;
    bool const may_capture = view.may_capture;
    bool const may_keep = view.may_keep;
    bool const has_captures = !view.captures.empty();
    bool const captures = calibration::takes_captures(view.procedure);
    double const height_mm = view.proposed_mm;
    ImVec2 const size(150 * scale_, theme::kButtonHeight_px * scale_);
    if (captures) {
        show_height(model);
        ImGui::BeginDisabled(!may_capture);
        if (ImGui::Button("Capture", size))
            model.perform(calibration::CaptureHeight { height_mm });
        ImGui::EndDisabled();
        ImGui::SameLine();
        ImGui::BeginDisabled(!has_captures);
        if (ImGui::Button("Undo", size))
            model.perform(calibration::UndoCapture {});
        ImGui::EndDisabled();
    } else if (ImGui::Button(is_moving ? "End" : "Begin", size)) {
        is_moving ? model.perform(calibration::EndMovement {})
                  : model.perform(calibration::BeginMovement {});
    }
    ImGui::SameLine();
    ImGui::BeginDisabled(!may_keep);
    if (ImGui::Button("Keep", size))
        model.perform(calibration::KeepRig {});
    ImGui::EndDisabled();
}

// Shows the height of the surface to be captured, which can be entered with the keyboard or the
// pen.
void CalibrationPanel::show_height(calibration::CalibrationModel& model) const
{
    double height_mm = model.view().proposed_mm;
    ImVec2 const size(64 * scale_, theme::kButtonHeight_px * scale_);
    for (double const step_mm : { -10.0, -1.0 }) {
        if (ImGui::Button(fmt::format("{:+g}", step_mm).c_str(), size))
            height_mm += step_mm;
        ImGui::SameLine();
    }
    ImGui::SetNextItemWidth(120 * scale_);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        { 12 * scale_, (size.y - ImGui::GetFontSize()) / 2 });
    ImGui::InputDouble("##height", &height_mm, 0, 0, "%.1f mm");
    ImGui::PopStyleVar();
    for (double const step_mm : { 1.0, 10.0 }) {
        ImGui::SameLine();
        if (ImGui::Button(fmt::format("{:+g}", step_mm).c_str(), size))
            height_mm += step_mm;
    }
    if (height_mm != model.view().proposed_mm)
        model.perform(calibration::ProposeHeight { height_mm });
}

void CalibrationPanel::show_captures(calibration::CalibrationView const& view)
{
    for (std::size_t i = 0; i < view.captures.size(); ++i) {
        auto const& capture = view.captures[i];
        auto text = fmt::format("{:2}  {:7.1f} mm {:>5}  {:9.2f} counts", i + 1, capture.ruler_mm,
                                word_for(capture.from), capture.counts);
        if (i < view.residuals_mm.size())
            text += fmt::format("  {:+.2f} mm", view.residuals_mm[i]);
        bool const is_slipped
            = std::find(view.slipped.begin(), view.slipped.end(), i) != view.slipped.end();
        if (is_slipped)
            text += "  slipped";
        ImGui::PushStyleColor(ImGuiCol_Text,
                              is_slipped ? theme::imgui_color(kRefused)
                                         : ImGui::GetStyle().Colors[ImGuiCol_Text]);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopStyleColor();
    }
    if (!view.report.empty()) {
        ImGui::Separator();
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(view.report.c_str());
        ImGui::PopTextWrapPos();
    }
}

} // namespace tractus::window
