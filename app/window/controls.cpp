#include "app/window/controls.h"

#include "app/tools/tool_choices.h"
#include "app/window/refusal_note.h"
#include "app/window/theme.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <utility>

namespace tractus::window {

namespace {

constexpr char const* kOpenPicture = "Open...";
// Label of the button that copies the drawn plant's numbers to the current tool.
constexpr char const* kLikeDrawn = "Like the plant";
constexpr float kProgressHeight_px = 10;
constexpr float kBarAir_px = 8;
constexpr float kGroupGap_px = 28;
// Maximum height of the bar as a share of the window's height. The main buttons may exceed it.
constexpr float kGreatestPart = 0.6f;
constexpr std::size_t kMaxMainRows = 2;
constexpr float kLowWindow_px = 640;
constexpr float kMinAir_px = 7;     // Minimum space on each side of a button's label.
constexpr float kToolWidth_px = 96; // Minimum width of a tool's button.
// Reduction of the space around the label of tool buttons, compared with other buttons.
constexpr float kLessAir_px = 12;

using Shown = Workspace::Shown;
struct ViewButton {
    char const* name;
    Shown shown;
    float width; // Width of the button in pixels, at a display scale of 1.
};
constexpr std::array<ViewButton, 6> kViews { { { "All", Shown::All, 80 },
                                               { "Pad", Shown::Pad, 80 },
                                               { "Strokes", Shown::Strokes, 108 },
                                               { "Skeleton", Shown::Skeleton, 124 },
                                               { "Plant", Shown::Plant, 80 },
                                               { "Many", Shown::Collection, 80 } } };
// Space for the mark on the button that switches to the next view.
constexpr float kNextMark_px = 24;

} // namespace

WindowPart Controls::show(view::WindowModel& model, Workspace& workspace, float left_px,
                          float right_px)
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
    auto main = main_buttons(model, workspace, Views::Each);
    auto const rows = rows_of(main).size();
    auto shorter = main_buttons(model, workspace, Views::Next);
    // In a low window, one row of buttons less is better than a button for each view.
    bool const is_low = display.y < kLowWindow_px * scale_;
    if (rows > kMaxMainRows || (is_low && rows_of(shorter).size() < rows))
        main = std::move(shorter);
    if (state.is_live)
        show_meanings(workspace.turns_views ? view_meanings(workspace)
                                            : tool_meanings(model, workspace),
                      height_of(main));
    show_rows(main);
    if (!state.is_live)
        show_speed(model);
    float const used_px = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y;
    height_px_ = std::min(used_px + kBarAir_px * scale_, display.y);
    ImGui::End();
    return part;
}

// Shows buttons for the current tool's variants above the main buttons. They scroll when dragged if
// they do not fit, so that the main buttons are always visible.
void Controls::show_meanings(std::vector<BarButton> const& buttons, float main_height_px) const
{
    float const used_px = ImGui::GetCursorPosY() + main_height_px + kBarAir_px * scale_;
    float const room_px = ImGui::GetIO().DisplaySize.y * kGreatestPart - used_px;
    if (height_of(buttons) <= room_px)
        return show_rows(buttons);
    float const spacing = ImGui::GetStyle().ItemSpacing.y;
    float const row_px = theme::kButtonHeight_px * scale_;
    ImGui::BeginChild("meanings", { 0, std::max(room_px - spacing, row_px) });
    show_rows(buttons);
    theme::scroll_by_dragging();
    ImGui::EndChild();
}

// Returns the height of the rows that the buttons need, including the space below them.
float Controls::height_of(std::vector<BarButton> const& buttons) const
{
    auto const rows = std::max<std::size_t>(rows_of(buttons).size(), 1);
    return static_cast<float>(rows)
        * (theme::kButtonHeight_px * scale_ + ImGui::GetStyle().ItemSpacing.y);
}

ButtonGaps Controls::gaps() const
{
    return { ImGui::GetStyle().ItemSpacing.x, kGroupGap_px * scale_ };
}

std::vector<ButtonWidth> Controls::widths_of(std::vector<BarButton> const& buttons) const
{
    std::vector<ButtonWidth> widths;
    for (auto const& button : buttons)
        widths.push_back({ button.width * scale_, min_width_px(button), button.begins_group });
    return widths;
}

std::vector<ButtonRow> Controls::rows_of(std::vector<BarButton> const& buttons) const
{
    return button_rows(widths_of(buttons), gaps(), ImGui::GetContentRegionAvail().x);
}

void Controls::show_rows(std::vector<BarButton> const& buttons) const
{
    // An empty row keeps its height, so that nothing moves when a tool with buttons is selected.
    if (buttons.empty())
        ImGui::Dummy({ 1, theme::kButtonHeight_px * scale_ });
    auto const widths = widths_of(buttons);
    std::size_t begin = 0;
    for (auto const& row : rows_of(buttons)) {
        for (auto i = begin; i < row.end; ++i) {
            if (i > begin)
                ImGui::SameLine(0, row.gap_before(widths[i], gaps()));
            if (button(buttons[i].text.c_str(), row.width(widths[i]) / scale_, buttons[i].is_on))
                buttons[i].press();
        }
        begin = row.end;
    }
}

// Returns the width at which the button's label is not cut off.
float Controls::min_width_px(BarButton const& button) const
{
    return std::min(ImGui::CalcTextSize(button.text.c_str(), nullptr, true).x
                        + 2 * kMinAir_px * scale_,
                    button.width * scale_);
}

bool Controls::button(char const* text, float width, bool is_on) const
{
    if (is_on)
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    // Reduces the padding of a button that is hardly wider than its label, so that the label is
    // centred.
    auto padding = ImGui::GetStyle().FramePadding;
    padding.x
        = std::min(padding.x, (width * scale_ - ImGui::CalcTextSize(text, nullptr, true).x) / 2);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, padding);
    bool const is_pressed
        = ImGui::Button(text, { width * scale_, theme::kButtonHeight_px * scale_ });
    ImGui::PopStyleVar();
    if (is_on)
        ImGui::PopStyleColor();
    return is_pressed;
}

void Controls::show_status(view::WindowState const& state) const
{
    if (state.trouble.empty())
        ImGui::TextUnformatted(
            (state.preview_note.empty() ? as_sentence(state.status) : state.preview_note).c_str());
    else
        ImGui::TextColored(theme::imgui_color(theme::palette().indicator), "%s",
                           as_sentence(state.trouble).c_str());
    if (!state.underground.empty()) {
        ImGui::SameLine();
        ImGui::TextColored(theme::imgui_color(theme::palette().indicator), "%s",
                           state.underground.c_str());
    }
    if (state.unsaved_steps > 0) {
        ImGui::SameLine();
        ImGui::TextDisabled("not on the disk yet");
    }
    if (state.recording.is_on)
        show_recording(state.recording);
}

// Shows that a recording is running, at the right end of the status line, where it stays visible
// while the user draws.
void Controls::show_recording(view::RecordingView const& recording)
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

// True if a handle of the gizmo sets this number. The number then needs no button while the gizmo
// is shown.
static bool is_set_by_gizmo(tools::Meaning const& meaning)
{
    return tools::number_settings(meaning.tool)[*meaning.number].option.offered
        == tools::NumberOption::Offered::WithoutGizmo;
}

// Returns buttons for the variants and numbers of the current tool.
std::vector<BarButton> Controls::tool_meanings(view::WindowModel& model, Workspace& workspace)
{
    std::vector<BarButton> buttons;
    auto const& state = model.state();
    if (state.hand.kind().lays_pictures)
        buttons.push_back({ .text = kOpenPicture,
                            .width = tools::button_width(kOpenPicture),
                            .begins_group = true,
                            .press = [&model] { model.perform(view::OpenPictures {}); } });
    for (auto const& meaning :
         tools::meanings_of(state.tools, workspace.hand(state), workspace.remembered(state))) {
        bool const is_on_gizmo = meaning.number && is_set_by_gizmo(meaning);
        if (workspace.gizmo_is_seen ? is_on_gizmo : meaning.is_beside_gizmo)
            continue;
        bool const is_asked = meaning.number && meaning.number == workspace.edited_number;
        BarButton button { .text = meaning.text,
                           .width = meaning.width,
                           .is_on = meaning.is_on || is_asked
                               || (meaning.opens_cards && workspace.cards_are_shown),
                           .begins_group = buttons.empty() || meaning.begins_group,
                           .press = [&model, &workspace, tool = meaning.tool] {
                               workspace.choose(model, tool);
                           } };
        if (meaning.number)
            button.press = [&workspace, is_asked, number = *meaning.number] {
                is_asked ? workspace.close_panels() : workspace.ask_number(number);
            };
        else if (meaning.opens_cards)
            button.press = [&workspace] {
                workspace.cards_are_shown ? workspace.close_panels() : workspace.show_cards();
            };
        buttons.push_back(std::move(button));
    }
    if (state.hand.kind().like_drawn)
        buttons.push_back({ .text = kLikeDrawn,
                            .width = tools::button_width(kLikeDrawn),
                            .press = [&model] { model.perform(view::TakeLikeDrawn {}); } });
    return buttons;
}

std::vector<BarButton> Controls::view_meanings(Workspace& workspace)
{
    constexpr double kButtonStep = kZoomStep * kZoomStep * kZoomStep;
    auto const drag
        = [&](ViewDrag wished) { return [&workspace, wished] { workspace.drag = wished; }; };
    auto const zoom = [&](double factor) {
        return [&workspace, factor] { workspace.requested_zoom *= factor; };
    };
    return { { "Turn", 96, workspace.drag == ViewDrag::Turn, true, drag(ViewDrag::Turn) },
             { "Move", 96, workspace.drag == ViewDrag::Move, false, drag(ViewDrag::Move) },
             { "Nearer", 110, false, true, zoom(kButtonStep) },
             { "Farther", 110, false, false, zoom(1 / kButtonStep) },
             { "Whole plant", 150, false, false,
               [&workspace] { workspace.is_whole_requested = true; } } };
}

std::vector<BarButton> Controls::main_buttons(view::WindowModel& model, Workspace& workspace,
                                              Views views)
{
    auto buttons = model.state().is_live ? tool_buttons(model, workspace) : play_buttons(model);
    if (model.state().has_session) {
        buttons.push_back({ "Undo", 88, false, true, [&model] { model.perform(view::Undo {}); } });
        buttons.push_back({ "Redo", 88, false, false, [&model] { model.perform(view::Redo {}); } });
    }
    for (auto const& [name, shown, width] : kViews) {
        if (views == Views::Next && workspace.shown == shown)
            buttons.push_back({ fmt::format("{} >", name), width + kNextMark_px, false, true,
                                [&workspace] { workspace.show_next(); } });
        if (views == Views::Next)
            continue;
        buttons.push_back({ name, width, workspace.shown == shown, shown == kViews[0].shown,
                            [&workspace, wished = shown] { workspace.shown = wished; } });
    }
    auto const open_or_close = [&workspace] {
        if (workspace.menu_is_open())
            workspace.close_menu();
        else
            workspace.open_menu(workspace.last_menu);
    };
    buttons.push_back({ "Menu", 96, workspace.menu_is_open(), false, open_or_close });
    return buttons;
}

std::vector<BarButton> Controls::tool_buttons(view::WindowModel& model, Workspace& workspace)
{
    std::vector<BarButton> buttons;
    auto const& state = model.state();
    for (auto const& choice : tools::tool_choices(state.tools, workspace.remembered(state)))
        buttons.push_back(
            { choice.text, std::max(kToolWidth_px, tools::button_width(choice.text) - kLessAir_px),
              !workspace.turns_views && tools::is_same_group(choice.tool, state.hand),
              buttons.empty(),
              [&model, &workspace, tool = choice.tool] { workspace.choose(model, tool); } });
    buttons.push_back({ "View", 96, workspace.turns_views, false,
                        [&workspace] { workspace.choose_view_tool(); } });
    return buttons;
}

std::vector<BarButton> Controls::play_buttons(view::WindowModel& model)
{
    bool const playing = model.state().playing;
    return { { playing ? "Pause" : "Play", 150, false, true,
               [&model, playing] { model.perform(view::SetPlaying { !playing }); } },
             { "Restart", 150, false, false, [&model] { model.perform(view::Restart {}); } } };
}

// Shows the playback speed beside the last button, if there is room.
void Controls::show_speed(view::WindowModel& model) const
{
    constexpr float kMin_px = 240;
    ImGui::SameLine(0, kGroupGap_px * scale_);
    if (ImGui::GetContentRegionAvail().x < kMin_px * scale_)
        ImGui::NewLine();
    auto speed = static_cast<float>(model.state().speed);
    ImGui::SetNextItemWidth(std::min(420 * scale_, ImGui::GetContentRegionAvail().x));
    theme::push_button_frame(scale_);
    if (ImGui::SliderFloat("##speed", &speed, 0.25f, 4, "speed %.2f x",
                           ImGuiSliderFlags_Logarithmic))
        model.perform(view::SetSpeed { static_cast<double>(speed) });
    ImGui::PopStyleVar();
}

} // namespace tractus::window
