#include "app/window/controls.h"

#include "app/tools/tool_choices.h"
#include "app/window/theme.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <utility>

namespace tractus {

namespace {

constexpr float kProgressHeight_px = 10;
constexpr float kBarAir_px = 8;
constexpr float kGroupGap_px = 28;
constexpr float kLeastAir_px = 7;   // On each side of a button's letters.
constexpr float kLeastGap = 0.4f;   // Between buttons, of the usual one.
constexpr float kToolWidth_px = 96; // At least,
constexpr float kLessAir_px = 12;   // and else so much narrower than what a tool means.

using Shown = Workbench::Shown;
constexpr std::array<std::pair<char const*, Shown>, 5> kViews { { { "All", Shown::All },
                                                                  { "Pad", Shown::Pad },
                                                                  { "Skeleton", Shown::Skeleton },
                                                                  { "Plant", Shown::Plant },
                                                                  { "Many", Shown::Collection } } };

} // namespace

WindowPart Controls::show(WindowModel& model, Workbench& bench, float left_px, float right_px)
{
    auto const& display = ImGui::GetIO().DisplaySize;
    auto const& state = model.state();
    WindowPart const part { left_px, display.y - height_px_, right_px - left_px, height_px_ };
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
        show_rows(bench.turns_views ? view_meanings(bench) : tool_meanings(model, bench));
    show_rows(main_buttons(model, bench));
    if (!state.is_live)
        show_speed(model);
    float const used_px = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y;
    height_px_ = std::min(used_px + kBarAir_px * scale_, display.y / 2);
    ImGui::End();
    return part;
}

// In one row, narrower if need be; where that would clip letters, a group that does not fit into
// what is left of a row begins another.
void Controls::show_rows(std::vector<BarButton> const& buttons) const
{
    if (buttons.empty()) // Nothing jumps when a tool is taken in hand.
        ImGui::Dummy({ 1, theme::kButtonHeight_px * scale_ });
    float const spacing = ImGui::GetStyle().ItemSpacing.x;
    auto const gap_before = [&](BarButton const& button) {
        return button.begins_group ? kGroupGap_px * scale_ : spacing;
    };
    auto const width_to = [&](std::size_t from, std::size_t end) {
        float width = 0;
        for (auto i = from; i < end; ++i)
            width += buttons[i].width * scale_ + (i > from ? gap_before(buttons[i]) : 0);
        return width;
    };
    float const room = ImGui::GetContentRegionAvail().x;
    float const width = width_to(0, buttons.size());
    float least = 0;
    for (std::size_t i = 0; i < buttons.size(); ++i)
        least += least_width_px(buttons[i]) + (i > 0 ? kLeastGap * gap_before(buttons[i]) : 0);
    bool const is_one_row = least <= room;
    // How much is left of what each could be narrower by.
    float const ease
        = !is_one_row || width <= room ? 1 : (room - least) / std::max(width - least, 1.0f);
    float used = 0;
    for (std::size_t i = 0; i < buttons.size(); ++i) {
        auto const& button = buttons[i];
        auto end = i + 1;
        while (button.begins_group && end < buttons.size() && !buttons[end].begins_group)
            ++end;
        float const gap = gap_before(button) * (kLeastGap + ease * (1 - kLeastGap));
        bool const goes_on = is_one_row ? i > 0 : used > 0 && used + gap + width_to(i, end) <= room;
        if (goes_on)
            ImGui::SameLine(0, gap);
        used = (goes_on ? used + gap : 0) + button.width * scale_;
        float const narrow_px = least_width_px(button);
        float const shown_px = narrow_px + ease * (button.width * scale_ - narrow_px);
        if (this->button(button.text.c_str(), shown_px / scale_, button.is_on))
            button.press();
    }
}

// With its letters whole.
float Controls::least_width_px(BarButton const& button) const
{
    return std::min(ImGui::CalcTextSize(button.text.c_str()).x + 2 * kLeastAir_px * scale_,
                    button.width * scale_);
}

bool Controls::button(char const* text, float width, bool is_on) const
{
    if (is_on)
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    // Letters stay in the middle of a button that is hardly wider than they are.
    auto padding = ImGui::GetStyle().FramePadding;
    padding.x = std::min(padding.x, (width * scale_ - ImGui::CalcTextSize(text).x) / 2);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, padding);
    bool const is_pressed
        = ImGui::Button(text, { width * scale_, theme::kButtonHeight_px * scale_ });
    ImGui::PopStyleVar();
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
    if (state.unkept_steps > 0) {
        ImGui::SameLine();
        ImGui::TextDisabled("not on the disk yet");
    }
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

// What the tool in hand may mean.
std::vector<BarButton> Controls::tool_meanings(WindowModel& model, Workbench& bench)
{
    std::vector<BarButton> buttons;
    for (auto const& meaning : meanings_of(model.state().tools, model.state().hand))
        buttons.push_back({ meaning.text, meaning.width, meaning.is_on,
                            buttons.empty() || meaning.begins_group,
                            [&model, &bench, tool = meaning.tool] { bench.choose(model, tool); } });
    return buttons;
}

std::vector<BarButton> Controls::view_meanings(Workbench& bench)
{
    constexpr double kButtonStep = kZoomStep * kZoomStep * kZoomStep;
    auto const drag = [&](ViewDrag wished) { return [&bench, wished] { bench.drag = wished; }; };
    auto const zoom
        = [&](double factor) { return [&bench, factor] { bench.zoom_wished *= factor; }; };
    return { { "Turn", 96, bench.drag == ViewDrag::Turn, true, drag(ViewDrag::Turn) },
             { "Move", 96, bench.drag == ViewDrag::Move, false, drag(ViewDrag::Move) },
             { "Nearer", 110, false, true, zoom(kButtonStep) },
             { "Farther", 110, false, false, zoom(1 / kButtonStep) },
             { "Whole plant", 150, false, false, [&bench] { bench.whole_is_wished = true; } } };
}

std::vector<BarButton> Controls::main_buttons(WindowModel& model, Workbench& bench)
{
    auto buttons = model.state().is_live ? tool_buttons(model, bench) : play_buttons(model);
    if (model.state().has_session) {
        buttons.push_back({ "Undo", 88, false, true, [&model] { model.perform(Undo {}); } });
        buttons.push_back({ "Redo", 88, false, false, [&model] { model.perform(Redo {}); } });
    }
    for (auto const& [name, shown] : kViews)
        buttons.push_back({ name, shown == Shown::Skeleton ? 124.0f : 80.0f, bench.shown == shown,
                            shown == kViews[0].second,
                            [&bench, wished = shown] { bench.shown = wished; } });
    auto const open_or_close = [&bench] {
        if (bench.menu_is_open())
            bench.close_menu();
        else
            bench.open_menu(bench.last_menu);
    };
    buttons.push_back({ "Menu", 96, bench.menu_is_open(), false, open_or_close });
    return buttons;
}

std::vector<BarButton> Controls::tool_buttons(WindowModel& model, Workbench& bench)
{
    std::vector<BarButton> buttons;
    auto const& state = model.state();
    for (auto const& choice : tool_choices(state.tools, state.remembered))
        buttons.push_back(
            { choice.text, std::max(kToolWidth_px, button_width(choice.text) - kLessAir_px),
              !bench.turns_views && is_same_group(choice.tool, state.hand), buttons.empty(),
              [&model, &bench, tool = choice.tool] { bench.choose(model, tool); } });
    buttons.push_back(
        { "View", 96, bench.turns_views, false, [&bench] { bench.choose_view_tool(); } });
    return buttons;
}

std::vector<BarButton> Controls::play_buttons(WindowModel& model)
{
    bool const playing = model.state().playing;
    return { { playing ? "Pause" : "Play", 150, false, true,
               [&model, playing] { model.perform(SetPlaying { !playing }); } },
             { "Restart", 150, false, false, [&model] { model.perform(Restart {}); } } };
}

// Beside the last button if there is room.
void Controls::show_speed(WindowModel& model) const
{
    constexpr float kLeast_px = 240;
    ImGui::SameLine(0, kGroupGap_px * scale_);
    if (ImGui::GetContentRegionAvail().x < kLeast_px * scale_)
        ImGui::NewLine();
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
