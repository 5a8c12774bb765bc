#include "app/window/controls.h"

#include "app/window/theme.h"
#include "app/window/tool_choices.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <utility>

namespace tractus {

namespace {

constexpr float kProgressHeight_px = 10;
constexpr float kBarAir_px = 8;

using Shown = Workbench::Shown;
constexpr std::array<std::pair<char const*, Shown>, 5> kViews { { { "All", Shown::All },
                                                                  { "Pad", Shown::Pad },
                                                                  { "Skeleton", Shown::Skeleton },
                                                                  { "Plant", Shown::Plant },
                                                                  { "Many", Shown::Collection } } };

} // namespace

float Controls::height_px(WindowState const& state) const
{
    auto const& style = ImGui::GetStyle();
    float const buttons = theme::kButtonHeight_px * scale_;
    float const above = state.is_live ? buttons + style.ItemSpacing.y
                                      : kProgressHeight_px * scale_ + style.ItemSpacing.y;
    return above + buttons + ImGui::GetTextLineHeightWithSpacing() + 2 * kBarAir_px * scale_;
}

WindowPart Controls::show(WindowModel& model, Workbench& bench, float left_px, float right_px)
{
    auto const& display = ImGui::GetIO().DisplaySize;
    auto const& state = model.state();
    float const height = height_px(state);
    WindowPart const part { left_px, display.y - height, right_px - left_px, height };
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, { 16 * scale_, kBarAir_px * scale_ });
    ImGui::SetNextWindowPos({ part.left, part.top });
    ImGui::SetNextWindowSize({ part.width, part.height });
    ImGui::Begin("controls", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove
                     | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar();
    if (!state.is_live)
        ImGui::ProgressBar(static_cast<float>(state.progress), { -1, kProgressHeight_px * scale_ },
                           "");
    show_status(state);
    if (state.is_live)
        show_meanings(model, bench);
    if (state.is_live)
        show_tools(model, bench);
    else
        show_playing(model);
    if (state.has_session)
        show_undo(model);
    show_views(bench);
    ImGui::SameLine();
    if (button("Menu", 96, bench.menu_is_open())) {
        if (bench.menu_is_open())
            bench.close_menu();
        else
            bench.open_menu(bench.last_menu);
    }
    if (!state.is_live) {
        ImGui::SameLine(0, 28 * scale_);
        show_speed(model);
    }
    ImGui::End();
    return part;
}

bool Controls::button(char const* text, float width, bool is_on) const
{
    if (is_on)
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    bool const is_pressed
        = ImGui::Button(text, { width * scale_, theme::kButtonHeight_px * scale_ });
    if (is_on)
        ImGui::PopStyleColor();
    return is_pressed;
}

void Controls::show_status(WindowState const& state) const
{
    if (state.trouble.empty())
        ImGui::TextUnformatted(state.status.c_str());
    else
        ImGui::TextColored(theme::imgui_color(theme::palette().indicator), "%s",
                           state.trouble.c_str());
    if (state.recording.is_on)
        show_recording(state.recording);
}

// At the right end of the status: what is seen while one draws.
void Controls::show_recording(RecordingView const& recording)
{
    auto const text = fmt::format("recording {} · {:.1f} MB", recording.file,
                                  static_cast<double>(recording.bytes) / 1e6);
    float const letter = ImGui::GetFontSize();
    ImGui::SameLine();
    float const left = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x
        - ImGui::CalcTextSize(text.c_str()).x - 1.2f * letter;
    if (left > ImGui::GetCursorPosX())
        ImGui::SetCursorPosX(left);
    auto const corner = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled(
        { corner.x + 0.5f * letter, corner.y + 0.5f * letter }, 0.36f * letter,
        theme::packed(theme::palette().recording));
    ImGui::Dummy({ letter, letter });
    ImGui::SameLine(0, 0.2f * letter);
    ImGui::TextUnformatted(text.c_str());
}

// What the tool in hand may mean: a row for it alone.
void Controls::show_meanings(WindowModel& model, Workbench& bench) const
{
    if (bench.turns_views)
        return show_view_meanings(bench);
    auto const hand = model.state().hand;
    bool is_first = true;
    for (auto const& meaning : meanings_of(hand)) {
        if (!std::exchange(is_first, false))
            ImGui::SameLine(0, meaning.begins_group ? 28 * scale_ : -1);
        if (button(meaning.text, meaning.width, meaning.is_on))
            bench.choose(model, meaning.tool);
    }
    if (is_first)
        ImGui::Dummy({ 1, theme::kButtonHeight_px * scale_ });
}

void Controls::show_view_meanings(Workbench& bench) const
{
    constexpr double kButtonStep = kZoomStep * kZoomStep * kZoomStep;
    if (button("Turn", 96, bench.drag == ViewDrag::Turn))
        bench.drag = ViewDrag::Turn;
    ImGui::SameLine();
    if (button("Move", 96, bench.drag == ViewDrag::Move))
        bench.drag = ViewDrag::Move;
    ImGui::SameLine(0, 28 * scale_);
    if (button("Nearer", 110))
        bench.zoom_wished *= kButtonStep;
    ImGui::SameLine();
    if (button("Farther", 110))
        bench.zoom_wished /= kButtonStep;
    ImGui::SameLine();
    if (button("Whole plant", 150))
        bench.whole_is_wished = true;
}

void Controls::show_tools(WindowModel& model, Workbench& bench) const
{
    auto const hand = model.state().hand;
    for (auto const& choice : tool_choices()) {
        bool const is_in_hand = !bench.turns_views && is_same_tool(choice.tool, hand);
        if (button(choice.text, 96, is_in_hand))
            bench.choose(model, choice.tool);
        ImGui::SameLine();
    }
    if (button("View", 96, bench.turns_views))
        bench.choose_view_tool();
}

void Controls::show_undo(WindowModel& model) const
{
    ImGui::SameLine(0, 28 * scale_);
    if (button("Undo", 88))
        model.perform(Undo {});
    ImGui::SameLine();
    if (button("Redo", 88))
        model.perform(Redo {});
}

void Controls::show_playing(WindowModel& model) const
{
    bool const playing = model.state().playing;
    if (button(playing ? "Pause" : "Play", 150))
        model.perform(SetPlaying { !playing });
    ImGui::SameLine();
    if (button("Restart", 150))
        model.perform(Restart {});
}

void Controls::show_views(Workbench& bench) const
{
    ImGui::SameLine(0, 28 * scale_);
    for (auto const& [name, shown] : kViews) {
        if (button(name, shown == Shown::Skeleton ? 124 : 80, bench.shown == shown))
            bench.shown = shown;
        ImGui::SameLine();
    }
}

void Controls::show_speed(WindowModel& model) const
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
