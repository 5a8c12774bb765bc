#include "app/window/mouse_hand.h"

#include <utility>

namespace tractus::window {

void MouseHand::hold(view::WindowModel& model, PenArea const& area,
                     std::span<MouseMoment const> path)
{
    bool const holds = ImGui::IsItemActive() || is_down_;
    if (!holds && !ImGui::IsItemHovered())
        return let_go(model);
    view::MoveMousePen move;
    for (auto const& moment : path) {
        is_down_ = holds && moment.is_down;
        move.path.push_back({ area.to_mm(moment.place_px), true, is_down_ });
    }
    // A resting mouse still counts as a pen in range, as the surface may move below it.
    if (move.path.empty() && (is_down_ || !is_in_range_))
        move.path.push_back({ area.to_mm(ImGui::GetIO().MousePos), true, is_down_ });
    is_in_range_ = true;
    if (!move.path.empty())
        model.perform(move);
}

void MouseHand::let_go(view::WindowModel& model)
{
    is_down_ = false;
    if (std::exchange(is_in_range_, false))
        model.perform(view::MoveMousePen { { {} } });
}

} // namespace tractus::window
