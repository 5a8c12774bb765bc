#include "app/window/refusal_note.h"

#include "app/window/palette.h"
#include "app/window/theme.h"

#include <algorithm>
#include <cctype>
#include <imgui_internal.h>

namespace tractus::window {

std::string as_sentence(std::string message)
{
    auto const is_small = [](unsigned char letter) { return std::islower(letter) != 0; };
    auto const word_end = std::find_if_not(message.begin(), message.end(), is_small);
    bool const is_word = word_end == message.end() || *word_end == ' ' || *word_end == ',';
    if (is_word && word_end != message.begin())
        message[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(message[0])));
    return message;
}

// Returns the bounding box of a stroke in the view, in pixels.
static ImRect box_of(view::InkLine const& ink, PenArea const& area)
{
    ImRect box;
    box.Min = box.Max = area.to_px(ink.points.front().position_mm.head<2>().cast<double>());
    for (auto const& point : ink.points)
        box.Add(area.to_px(point.position_mm.head<2>().cast<double>()));
    return box;
}

void draw_refusal(view::WindowState const& state, PenArea const& area, ImVec2 const& corner_px,
                  ImVec2 const& size_px)
{
    if (!state.refused || state.refused->surface != state.hand.kind().surface
        || state.refused->ink.points.empty())
        return;
    float const em = ImGui::GetFontSize();
    float const edge = em / 2;
    auto const words = as_sentence(state.refused->why);
    float const wrap = std::clamp(size_px.x - 4 * edge, 4 * em, 20 * em);
    auto const text = ImGui::CalcTextSize(words.c_str(), nullptr, false, wrap);
    auto const ink = box_of(state.refused->ink, area);
    float const first = corner_px.x + 2 * edge;
    float const left = std::clamp(ink.Min.x, first,
                                  std::max(first, corner_px.x + size_px.x - text.x - 2 * edge));
    float const lowest = corner_px.y + size_px.y - text.y - 2 * edge;
    float const below = ink.Max.y + em;
    float const top
        = below <= lowest ? below : std::max(ink.Min.y - em - text.y, corner_px.y + 2 * edge);
    auto* const draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled({ left - edge, top - edge }, { left + text.x + edge, top + text.y + edge },
                        theme::packed(theme::palette().pad_background, 0.85f), edge);
    draw->AddText(ImGui::GetFont(), em, { left, top }, ImGui::GetColorU32(ImGuiCol_Text),
                  words.c_str(), nullptr, wrap);
}

} // namespace tractus::window
