#include "app/window/icon.h"

#include <cstddef>
#include <string_view>

namespace tractus::window {

void draw_icon(char const* icon, ImVec2 const& foot, float size, float line_width)
{
    auto* const draw = ImGui::GetWindowDrawList();
    auto const stroke = [&] {
        draw->PathStroke(ImGui::GetColorU32(ImGuiCol_Text), ImDrawFlags_None, line_width);
    };
    std::string_view const places(icon);
    for (std::size_t i = 0; i + 1 < places.size(); i += 2) {
        if (places[i] == ' ') {
            stroke();
            ++i;
        }
        float const x = static_cast<float>(places[i] - '0') / 9 - 0.5f;
        float const y = static_cast<float>(places[i + 1] - '0') / 9 - 1;
        draw->PathLineTo({ foot.x + x * size, foot.y + y * size });
    }
    stroke();
}

} // namespace tractus::window
