#include "app/window/skeleton_notes.h"

#include "app/window/palette.h"
#include "app/window/theme.h"

namespace tractus::window {

namespace {

// Distance of the legend's lines, as a multiple of a letter's height.
constexpr float kLegendSpacing = 1.25f;

int legend_pieces(tools::LayerStyle::Pattern pattern)
{
    switch (pattern) {
    case tools::LayerStyle::Pattern::Dashed:
        return 2;
    case tools::LayerStyle::Pattern::Dotted:
        return 4;
    case tools::LayerStyle::Pattern::Solid:
        break;
    }
    return 1;
}

} // namespace

void draw_skeleton_legend(SkeletonStates const& states, ImVec2 const& corner_px)
{
    auto* const draw = ImGui::GetWindowDrawList();
    float const line = ImGui::GetFontSize() * kLegendSpacing;
    float y = corner_px.y;
    // Adds an entry. Its sample line is drawn as `pieces` dashes.
    auto const add = [&](bool is_there, Vec3f const& color, char const* text, int pieces = 1) {
        if (!is_there)
            return;
        y -= line; // Entries are stacked upwards from the bottom.
        float const middle = y + ImGui::GetFontSize() / 2;
        // Length of each dash, and of each gap between dashes.
        float const piece = line / static_cast<float>(2 * pieces - 1);
        for (int i = 0; i < pieces; ++i) {
            float const x = corner_px.x + 2 * static_cast<float>(i) * piece;
            draw->AddLine({ x, middle }, { x + piece, middle }, theme::packed(color), 5);
        }
        draw->AddText({ corner_px.x + line * 1.3f, y }, ImGui::GetColorU32(ImGuiCol_TextDisabled),
                      text);
    };
    auto const& palette = theme::palette();
    for (auto const* const layer : states.layers)
        add(true, layer_color(layer->style), layer->label, legend_pieces(layer->style.pattern));
    add(states.assigned, palette.assigned, "shaped by a stroke");
    add(states.next, palette.ink, "takes the next stroke");
    add(states.undetermined, palette.undetermined, "undetermined");
    add(states.selected, palette.selected, "selected");
}

void draw_selecting_ink(view::WindowState const& state, PenArea const& area)
{
    auto* const draw = ImGui::GetWindowDrawList();
    std::vector<ImVec2> places;
    auto const add = [&](view::InkLine const& ink, float opacity) {
        places.clear();
        for (auto const& point : ink.points)
            places.push_back(area.to_px(point.position_mm.head<2>().cast<double>()));
        draw->AddPolyline(places.data(), static_cast<int>(places.size()),
                          theme::packed(theme::palette().ink, opacity), ImDrawFlags_None, 3);
    };
    for (auto const& ink : state.live_ink)
        add(ink, 0.6f);
    if (state.refused && state.refused->surface == tools::Surface::Skeleton)
        add(state.refused->ink, 0.25f);
    if (state.pen.in_range)
        draw->AddCircleFilled(area.to_px(state.pen.tip_mm.head<2>().cast<double>()), 6,
                              theme::packed(theme::palette().ink, 0.8f));
}

} // namespace tractus::window
