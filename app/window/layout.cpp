#include "app/window/layout.h"

#include "app/window/theme.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>

namespace tractus {

namespace {

constexpr int kSavedWidth_px = 1600; // Of "Save picture".
constexpr int kSavedHeight_px = 1200;
constexpr float kProgressHeight_px = 10;
constexpr float kGaugeWidth_px = 88;

// A ruler of the surface's calibrated range with a mark at its present height.
void draw_height_gauge(WindowState const& state, ImVec2 const& corner, ImVec2 const& size)
{
    auto* const draw = ImGui::GetWindowDrawList();
    double const low_mm = state.volume_mm.min_mm.z();
    double const range_mm = std::max(1.0, state.volume_mm.max_mm.z() - low_mm);
    float const top = corner.y + size.y * 0.08f;
    float const length = size.y * 0.84f;
    auto const y_of = [&](double height_mm) {
        return top + length * (1 - static_cast<float>((height_mm - low_mm) / range_mm));
    };
    float const x = corner.x + size.x * 0.36f;
    draw->AddLine({ x, top }, { x, top + length }, theme::packed(theme::kUnselected, 0.7f), 2);
    for (int tick = 0; tick <= 10; ++tick) {
        float const y = y_of(low_mm + range_mm * tick / 10);
        float const reach = size.x * (tick % 5 == 0 ? 0.22f : 0.12f);
        draw->AddLine({ x - reach, y }, { x, y }, theme::packed(theme::kUnselected, 0.7f), 2);
    }
    float const y = y_of(std::clamp(state.surface_height_mm, low_mm, low_mm + range_mm));
    float const mark = size.x * 0.20f;
    draw->AddTriangleFilled({ x + 2, y }, { x + 2 + mark, y - mark * 0.6f },
                            { x + 2 + mark, y + mark * 0.6f }, theme::packed(theme::kInk));
    auto const text = fmt::format("{:.0f} mm{}", state.surface_height_mm,
                                  state.is_outside_calibration ? " ?" : "");
    ImVec2 const text_size = ImGui::CalcTextSize(text.c_str());
    draw->AddText({ corner.x + 6, top - text_size.y - 6 },
                  theme::packed(state.is_outside_calibration ? theme::kIndicator : theme::kInk),
                  text.c_str());
    if (state.is_outside_calibration)
        draw->AddText({ x + 2 + mark, y + mark }, theme::packed(theme::kIndicator),
                      "outside the calibrated range");
}

constexpr int kLegendLines = 4;
constexpr float kLegendSpacing = 1.25f; // In letters' heights.

struct LegendEntry {
    Vec3f color;
    char const* text;
};

void draw_legend(ImVec2 const& corner)
{
    static std::array<LegendEntry, kLegendLines> const entries {
        { { theme::kSelected, "selected" },
          { theme::kUndetermined, "undetermined" },
          { theme::kAssigned, "shaped by a stroke" },
          { theme::kIndicator, "leaning" } }
    };
    auto* const draw = ImGui::GetWindowDrawList();
    float const line = ImGui::GetFontSize() * kLegendSpacing;
    float y = corner.y;
    for (auto const& entry : entries) {
        float const middle = y + ImGui::GetFontSize() / 2;
        draw->AddLine({ corner.x, middle }, { corner.x + line, middle }, theme::packed(entry.color),
                      5);
        draw->AddText({ corner.x + line * 1.3f, y }, ImGui::GetColorU32(ImGuiCol_TextDisabled),
                      entry.text);
        y += line;
    }
}

bool is_z_pressed()
{
#if IMGUI_VERSION_NUM >= 18700
    return ImGui::IsKeyPressed(ImGuiKey_Z);
#else
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Z));
#endif
}

} // namespace

void Layout::show(WindowModel& model, Renderer& renderer)
{
    auto const& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({ 0, 0 });
    ImGui::SetNextWindowSize(io.DisplaySize);
    ImGui::Begin("station", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove
                     | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (auto* const calibration = model.calibration()) {
        calibration_.show(*calibration);
        ImGui::End();
        return;
    }
    auto const& style = ImGui::GetStyle();
    float const controls_px = (theme::kButtonHeight_px + kProgressHeight_px) * scale_
        + ImGui::GetFrameHeight() + 3 * style.ItemSpacing.y;
    ImVec2 const room = ImGui::GetContentRegionAvail();
    float const height_px = std::max(room.y - controls_px, 64.0f);
    float const width_px = std::max(room.x - 2 * style.ItemSpacing.x, 192.0f);

    auto const& state = model.state();
    show_pad(state, renderer, { width_px * 0.37f, height_px });
    ImGui::SameLine();
    show_skeleton(state, renderer, { width_px * 0.28f, height_px });
    ImGui::SameLine();
    show_plant(state, renderer, { width_px * 0.35f, height_px });
    show_controls(model, renderer);
    ImGui::End();
}

void Layout::show_title(char const* title, char const* detail) const
{
    ImGui::PushFont(title_font_);
    ImGui::TextUnformatted(title);
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().FramePadding.y + 3 * scale_);
    ImGui::TextDisabled("%s", detail);
}

void Layout::show_pad(WindowState const& state, Renderer& renderer, ImVec2 const& size_px)
{
    ImGui::BeginGroup();
    show_title("Drawing pad", state.tool.c_str());
    ImVec2 const corner = ImGui::GetCursorScreenPos();
    float const gauge_px = kGaugeWidth_px * scale_;
    float const height_px = size_px.y - ImGui::GetFontSize() * 2;
    ImGui::Dummy({ gauge_px, height_px });
    draw_height_gauge(state, corner, { gauge_px, height_px });
    ImGui::SameLine(0, 0);
    pad_.show(state, renderer, { size_px.x - gauge_px, height_px });
    ImGui::EndGroup();
}

void Layout::show_skeleton(WindowState const& state, Renderer& renderer, ImVec2 const& size_px)
{
    ImGui::BeginGroup();
    show_title("Skeleton", "drag to turn, wheel to zoom");
    ImVec2 const corner = ImGui::GetCursorScreenPos();
    skeleton_.show(state, renderer, { size_px.x, size_px.y - ImGui::GetFontSize() * 2 });
    float const legend_px = kLegendLines * kLegendSpacing * ImGui::GetFontSize();
    draw_legend({ corner.x + 14 * scale_, ImGui::GetItemRectMax().y - legend_px - 8 * scale_ });
    ImGui::EndGroup();
}

void Layout::show_plant(WindowState const& state, Renderer& renderer, ImVec2 const& size_px)
{
    ImGui::BeginGroup();
    show_title("Plant", fmt::format("seed {}", state.seed).c_str());
    plant_.show(state, renderer, { size_px.x, size_px.y - ImGui::GetFontSize() * 2 });
    ImGui::EndGroup();
}

void Layout::show_controls(WindowModel& model, Renderer& renderer)
{
    auto const& state = model.state();
    bool const is_live = state.is_live;
    ImGui::ProgressBar(static_cast<float>(state.progress), { -1, kProgressHeight_px * scale_ }, "");
    ImGui::AlignTextToFramePadding();
    if (state.trouble.empty())
        ImGui::TextUnformatted(state.status.c_str());
    else
        ImGui::TextColored(theme::imgui_color(theme::kIndicator), "%s", state.trouble.c_str());

    if (is_live) {
        show_tool_buttons(model);
        ImGui::SameLine();
        if (button("Start again", 180))
            model.perform(Restart {});
        if (state.has_session)
            show_undo_buttons(model);
    } else {
        show_playing_buttons(model);
    }
    ImGui::SameLine();
    if (button("Another one", 200))
        model.perform(NextVariation {});
    ImGui::SameLine();
    if (button("Save picture", 200))
        model.perform(SavePicture { plant_.picture(renderer, kSavedWidth_px, kSavedHeight_px) });
    if (!is_live) {
        ImGui::SameLine();
        show_speed(model);
    }
}

bool Layout::button(char const* text, float width) const
{
    return ImGui::Button(text, { width * scale_, theme::kButtonHeight_px * scale_ });
}

void Layout::show_playing_buttons(WindowModel& model) const
{
    bool const playing = model.state().playing;
    if (button(playing ? "Pause" : "Play", 150))
        model.perform(SetPlaying { !playing });
    ImGui::SameLine();
    if (button("Restart", 150))
        model.perform(Restart {});
}

void Layout::show_tool_buttons(WindowModel& model) const
{
    struct Choice {
        char const* text;
        Tool tool;
    };
    static std::array<Choice, 4> const choices {
        { { "Branch by branch", { Tool::Kind::DrawInOrder } },
          { "Select", { Tool::Kind::Select } },
          { "Draw", { Tool::Kind::Draw, Propagation::Both } },
          { "Lean", { Tool::Kind::Indicate } } }
    };
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (i > 0)
            ImGui::SameLine();
        if (button(choices[i].text, i == 0 ? 250 : 130))
            model.perform(ChooseTool { choices[i].tool });
    }
}

void Layout::show_undo_buttons(WindowModel& model) const
{
    auto const& io = ImGui::GetIO();
    bool const is_key = io.KeyCtrl && is_z_pressed();
    ImGui::SameLine();
    if (button("Undo", 100) || (is_key && !io.KeyShift))
        model.perform(Undo {});
    ImGui::SameLine();
    if (button("Redo", 100) || (is_key && io.KeyShift))
        model.perform(Redo {});
}

void Layout::show_speed(WindowModel& model) const
{
    auto speed = static_cast<float>(model.state().speed);
    float const height = theme::kButtonHeight_px * scale_;
    ImGui::SetNextItemWidth(std::min(420 * scale_, ImGui::GetContentRegionAvail().x));
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        { 16 * scale_, (height - ImGui::GetFontSize()) / 2 });
    if (ImGui::SliderFloat("##speed", &speed, 0.25f, 4, "speed %.2f x",
                           ImGuiSliderFlags_Logarithmic))
        model.perform(SetSpeed { static_cast<double>(speed) });
    ImGui::PopStyleVar();
}

} // namespace tractus
