#include "app/window/cards_panel.h"

#include "app/window/gizmo_picture.h"
#include "app/window/theme.h"

#include <algorithm>
#include <imgui_stdlib.h>
#include <utility>

namespace tractus::window {

namespace {

constexpr float kCardWidth_px = 148;
constexpr float kGizmoHeight_px = 104;
constexpr float kCardName_px = 34;
constexpr float kAround_px = 14;
// Maximum height of the panel, as a share of the window's height above the bar.
constexpr float kGreatestShare = 0.5f;
constexpr float kTyped_px = 220;

// Returns that card of the user's own which equals the current tool, or null.
tools::ToolCard const* card_in_hand(view::WindowState const& state)
{
    auto const card = tools::card_of(state.hand);
    auto const found = std::find_if(state.cards.begin(), state.cards.end(),
                                    [&](tools::ToolCard const& own) { return own.tool == card; });
    return found == state.cards.end() ? nullptr : &*found;
}

} // namespace

WindowPart CardsPanel::show(view::WindowModel& model, Workspace& workspace,
                            Controls const& controls, WindowPart const& bar)
{
    auto const& state = model.state();
    if (!tools::cards_label(state.hand.kind())) {
        workspace.cards_are_shown = false;
        return {};
    }
    float const around = kAround_px * scale_;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, { around, around });
    // If there is too little room above the bar, the panel overlaps the bar instead of leaving the
    // window.
    ImGui::SetNextWindowPos({ bar.left, std::max(bar.top - height_px_, 0.0f) });
    ImGui::Begin("cards", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove
                     | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PopStyleVar();
    show_cards(model, workspace, bar.width - 2 * around);
    if (auto const* const own = card_in_hand(state))
        show_own(model, workspace, controls, *own);
    if (controls.button("Keep this one", 180))
        model.perform(view::KeepCard {});
    ImGui::SameLine();
    if (controls.button("Close##cards", 96))
        workspace.cards_are_shown = false;
    auto const corner = ImGui::GetWindowPos();
    auto const size = ImGui::GetWindowSize();
    height_px_ = size.y;
    ImGui::End();
    return { corner.x, corner.y, size.x, size.y };
}

// Shows the cards of the current tool's kind. They scroll when they are dragged.
void CardsPanel::show_cards(view::WindowModel& model, Workspace& workspace, float width_px)
{
    auto const& hand = model.state().hand;
    auto cards = tools::ready_cards(hand);
    for (auto const& own : model.state().cards)
        cards.push_back({ own.name, tools::with_card(hand, own.tool) });
    auto const& gap = ImGui::GetStyle().ItemSpacing;
    float const card_px = kCardWidth_px * scale_;
    float const height_px
        = (hand.kind().gizmo ? kGizmoHeight_px + kCardName_px : theme::kButtonHeight_px) * scale_;
    auto const in_row = std::max(1, static_cast<int>((width_px + gap.x) / (card_px + gap.x)));
    auto const rows = (static_cast<int>(cards.size()) + in_row - 1) / in_row;
    float const room_px
        = ImGui::GetIO().DisplaySize.y * kGreatestShare - theme::kButtonHeight_px * scale_;
    float const min_px = std::min(static_cast<float>(in_row), static_cast<float>(cards.size()));
    ImGui::BeginChild("cards",
                      { min_px * (card_px + gap.x),
                        std::clamp(static_cast<float>(rows) * (height_px + gap.y),
                                   height_px + gap.y, std::max(room_px, height_px + gap.y)) });
    for (std::size_t i = 0; i < cards.size(); ++i) {
        if (static_cast<int>(i) % in_row != 0)
            ImGui::SameLine();
        ImGui::PushID(static_cast<int>(i));
        if (show_card(cards[i], cards[i].tool == hand))
            workspace.choose(model, cards[i].tool);
        ImGui::PopID();
    }
    theme::scroll_by_dragging();
    ImGui::EndChild();
}

// Shows a card. Returns true if it was pressed.
bool CardsPanel::show_card(tools::ToolCard const& card, bool is_on) const
{
    bool const has_gizmo = card.tool.kind().gizmo != nullptr;
    float const name_px = (has_gizmo ? kCardName_px : theme::kButtonHeight_px) * scale_;
    float const gizmo_px = has_gizmo ? kGizmoHeight_px * scale_ : 0;
    auto const corner = ImGui::GetCursorScreenPos();
    ImVec2 const size { kCardWidth_px * scale_, gizmo_px + name_px };
    if (is_on)
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_CheckMark));
    bool const is_pressed = ImGui::Button("##card", size);
    if (is_on)
        ImGui::PopStyleColor();
    if (has_gizmo)
        draw_gizmo(card.tool.gizmo(),
                   { { corner.x + size.x / 2, corner.y + gizmo_px / 2 }, gizmo_px / 2 }, scale_);
    auto* const draw = ImGui::GetWindowDrawList();
    float const letter = ImGui::GetFontSize();
    auto const text = ImGui::CalcTextSize(card.name.c_str());
    float const left = corner.x + std::max((size.x - text.x) / 2, letter / 4);
    draw->PushClipRect(corner, { corner.x + size.x, corner.y + size.y }, true);
    draw->AddText({ left, corner.y + gizmo_px + (name_px - letter) / 2 },
                  ImGui::GetColorU32(ImGuiCol_Text), card.name.c_str());
    draw->PopClipRect();
    return is_pressed;
}

// Shows buttons for renaming or deleting the selected card, which is one of the user's own. Without
// a keyboard the new name is entered in the name panel.
void CardsPanel::show_own(view::WindowModel& model, Workspace& workspace, Controls const& controls,
                          tools::ToolCard const& card)
{
    if (std::exchange(named_, card.name) != card.name)
        typed_ = card.name;
    auto const name = card.name; // A copy, because the commands below may delete the card.
    theme::push_button_frame(scale_);
    ImGui::SetNextItemWidth(kTyped_px * scale_);
    bool const is_entered
        = ImGui::InputText("##name", &typed_, ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::PopStyleVar();
    ImGui::SameLine();
    bool const is_pressed = controls.button("Rename", 110);
    if (is_pressed && typed_ == name)
        return workspace.ask_name({ Workspace::NameRequest::Of::Card, name });
    if (is_pressed || is_entered)
        return model.perform(view::RenameCard { name, typed_ });
    ImGui::SameLine();
    if (controls.button("Remove##card", 110))
        model.perform(view::RemoveCard { name });
}

} // namespace tractus::window
