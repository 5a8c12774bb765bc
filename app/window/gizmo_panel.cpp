#include "app/window/gizmo_panel.h"

#include "app/window/theme.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace tractus::window {

namespace {

constexpr float kMinSide_px = 170;
constexpr float kGreatestSide_px = 320;
constexpr float kShareOfPad = 0.4f;
constexpr float kTitle_px = 44; // Height that the view's title needs at the top of the view.
constexpr float kButtonWidth_px = 76;
constexpr float kOpacity = 0.75f; // Opacity of the panel, through which the view remains visible.
constexpr float kSmall = 0.8f;    // Size of small text, relative to normal text.
constexpr float kSmallest = 0.7f; // Size of labels at handles, relative to normal text.
constexpr float kPanelAir_px = 10;
constexpr float kHandleRadius_px = 13; // Radius of a handle on the screen.
constexpr float kGrabReach_px = 22;    // Maximum distance from which a pen grabs a handle.
constexpr float kSmallRadius_px = 8;   // Radius of a handle in gizmos with many handles.
constexpr float kSmallReach_px = 14;

using Slider = view::ChangeGrowth::Slider;

// Returns the index of the tool's number that the handle sets; nullopt if it sets none.
std::optional<std::size_t> number_of(tools::Tool const& tool, tools::Gizmo::Handle const& handle)
{
    auto const numbers = tools::number_settings(tool);
    auto const found
        = std::find_if(numbers.begin(), numbers.end(), [&](tools::NumberSetting const& number) {
              return std::string_view(number.option.name) == handle.number;
          });
    if (found == numbers.end())
        return std::nullopt;
    return static_cast<std::size_t>(found - numbers.begin());
}

} // namespace

std::optional<WindowPart> GizmoPanel::show(view::WindowModel& model, Workspace& workspace,
                                           Controls const& controls, WindowPart const& pad)
{
    auto const& state = model.state();
    auto const& kind = state.hand.kind();
    bool const is_of_drawn = !kind.gizmo && kind.drawn_gizmo && state.drawn_gizmo;
    float const room = kShareOfPad * std::min(pad.width, pad.height);
    workspace.gizmo_is_seen = false;
    if (!(kind.gizmo || is_of_drawn) || !workspace.draws(state) || room < kMinSide_px * scale_)
        return std::nullopt;
    float const side = std::min(room, kGreatestSide_px * scale_);
    auto& is_shown = is_of_drawn ? workspace.drawn_gizmo_is_shown : workspace.gizmo_is_shown;
    workspace.gizmo_is_seen = kind.gizmo && is_shown;
    float const air = kPanelAir_px * scale_;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, { air, air });
    ImGui::SetNextWindowBgAlpha(kOpacity);
    float const edge = workspace.is_left_handed ? pad.left + air : pad.left + pad.width - air;
    ImGui::SetNextWindowPos({ edge, pad.top + kTitle_px * scale_ }, ImGuiCond_Always,
                            { workspace.is_left_handed ? 0.0f : 1.0f, 0 });
    ImGui::Begin("glyph", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove
                     | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar();
    auto const top = ImGui::GetCursorScreenPos();
    if (controls.button(is_of_drawn ? kind.drawn_gizmo->title : kind.gizmo->title, kButtonWidth_px,
                        is_shown))
        is_shown = !is_shown;
    if (is_shown) {
        auto const gizmo = is_of_drawn ? *state.drawn_gizmo : workspace.hand(state).gizmo();
        // The gizmo of drawn curves fills its square, so the square is below the button. The gizmo
        // of a rule leaves a corner of its square free for the button.
        auto const corner = is_of_drawn ? ImGui::GetCursorScreenPos() : top;
        show_gizmo(model, workspace, gizmo,
                   { { corner.x + side / 2, corner.y + side / 2 }, side / 2 });
        ImGui::SetCursorScreenPos(corner);
        ImGui::Dummy({ side, side });
        show_gizmo_message(gizmo);
    }
    auto const corner = ImGui::GetWindowPos();
    auto const size = ImGui::GetWindowSize();
    ImGui::End();
    return WindowPart { corner.x, corner.y, size.x, size.y };
}

void GizmoPanel::show_gizmo_message(tools::Gizmo const& gizmo) const
{
    auto const shown
        = std::find_if(gizmo.handles.begin(), gizmo.handles.end(),
                       [&](tools::Gizmo::Handle const& handle) { return handle.id == shown_; });
    ImGui::SetWindowFontScale(kSmall);
    ImGui::TextUnformatted(shown == gizmo.handles.end() ? gizmo.hint : shown->says.c_str());
    ImGui::SetWindowFontScale(1);
}

void GizmoPanel::show_gizmo(view::WindowModel& model, Workspace& workspace,
                            tools::Gizmo const& gizmo, GizmoSquare const& square)
{
    draw_gizmo(gizmo, square, scale_);
    draw_labels(gizmo, square);
    for (auto const& handle : gizmo.handles) {
        take_hand(model, workspace, handle, square);
        draw_handle(handle, square);
    }
}

void GizmoPanel::draw_labels(tools::Gizmo const& gizmo, GizmoSquare const& square) const
{
    constexpr float kMinHalf_px = 100;
    if (square.half < kMinHalf_px * scale_)
        return;
    float const letter = kSmallest * ImGui::GetFontSize();
    for (auto const& label : gizmo.labels) {
        auto const size = ImGui::GetFont()->CalcTextSizeA(letter, 1000, 0, label.text);
        auto const at = square.to_px(label.place);
        ImGui::GetWindowDrawList()->AddText(ImGui::GetFont(), letter, { at.x - size.x / 2, at.y },
                                            ImGui::GetColorU32(ImGuiCol_TextDisabled), label.text);
    }
}

// Processes hovering over a handle and dragging it, by pen or mouse, in this frame.
void GizmoPanel::take_hand(view::WindowModel& model, Workspace& workspace,
                           tools::Gizmo::Handle const& handle, GizmoSquare const& square)
{
    auto const at = square.to_px(handle.place);
    float const reach = (handle.is_small ? kSmallReach_px : kGrabReach_px) * scale_;
    ImGui::SetCursorScreenPos({ at.x - reach, at.y - reach });
    ImGui::PushID(static_cast<int>(handle.id));
    bool const is_pressed = ImGui::InvisibleButton("handle", { 2 * reach, 2 * reach });
    ImGui::PopID();
    if (ImGui::IsItemHovered() && !held_)
        shown_ = handle.id;
    if (handle.is_button) {
        if (is_pressed)
            press(model, workspace, handle);
        return;
    }
    auto const pointer = ImGui::GetIO().MousePos;
    if (ImGui::IsItemActivated()) {
        held_ = shown_ = handle.id;
        grab_offset_px_ = { at.x - pointer.x, at.y - pointer.y };
        moved_to_.reset();
    }
    if (held_ != handle.id)
        return;
    if (ImGui::IsItemDeactivated()) {
        held_.reset();
        return let_go(model, workspace, handle);
    }
    auto const& delta = ImGui::GetIO().MouseDelta;
    if (delta.x != 0 || delta.y != 0)
        move(model, workspace, handle,
             square.to_frame({ pointer.x + grab_offset_px_.x, pointer.y + grab_offset_px_.y }));
}

void GizmoPanel::press(view::WindowModel& model, Workspace& workspace,
                       tools::Gizmo::Handle const& handle) const
{
    auto const& hand = workspace.hand(model.state());
    if (hand.kind().gizmo)
        return workspace.adjust(model, hand.dragged(handle.id, handle.place), Slider::Released);
    model.perform(view::DragDrawnGizmo { handle.id, handle.place });
}

void GizmoPanel::move(view::WindowModel& model, Workspace& workspace,
                      tools::Gizmo::Handle const& handle, Vec2 const& to)
{
    auto const& hand = workspace.hand(model.state());
    moved_to_ = to;
    if (!hand.kind().gizmo)
        model.perform(view::DragDrawnGizmo { handle.id, to, Slider::Moving });
    else if (auto const dragged = hand.dragged(handle.id, to); dragged != hand)
        workspace.adjust(model, dragged, Slider::Moving);
}

void GizmoPanel::let_go(view::WindowModel& model, Workspace& workspace,
                        tools::Gizmo::Handle const& handle)
{
    auto const& hand = workspace.hand(model.state());
    auto const to = std::exchange(moved_to_, std::nullopt);
    if (!hand.kind().gizmo) {
        if (to)
            model.perform(view::DragDrawnGizmo { handle.id, *to });
    } else if (workspace.adjusted) {
        workspace.adjust(model, hand, Slider::Released);
    } else if (auto const number = number_of(hand, handle)) {
        workspace.ask_number(*number);
    }
}

void GizmoPanel::draw_handle(tools::Gizmo::Handle const& handle, GizmoSquare const& square) const
{
    auto* const draw = ImGui::GetWindowDrawList();
    auto const at = square.to_px(handle.place);
    bool const is_shown = shown_ == handle.id;
    auto const& palette = theme::palette();
    float const radius = (handle.is_small ? kSmallRadius_px : kHandleRadius_px) * scale_;
    draw->AddCircleFilled(at, radius, theme::packed(palette.pad_background, 0.85f));
    draw->AddCircle(at, radius, theme::packed(is_shown ? palette.ink : palette.stroke), 0,
                    (is_shown ? 3.0f : 1.5f) * scale_);
    float const letter = kSmall * ImGui::GetFontSize();
    auto const size = ImGui::GetFont()->CalcTextSizeA(letter, 1000, 0, handle.sign);
    draw->AddText(ImGui::GetFont(), letter, { at.x - size.x / 2, at.y - size.y / 2 },
                  ImGui::GetColorU32(ImGuiCol_Text), handle.sign);
}

} // namespace tractus::window
