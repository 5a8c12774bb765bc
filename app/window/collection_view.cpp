#include "app/window/collection_view.h"

#include "app/window/theme.h"

#include <algorithm>
#include <fmt/core.h>
#include <optional>
#include <utility>

namespace tractus::window {

namespace {

constexpr int kSheetColumns = 4;
constexpr int kSheetRows = 3;
constexpr render::ViewAngles kSheetAngles { .azimuth_rad = 0.45, .elevation_rad = 0.22 };

} // namespace

void CollectionView::draw(view::WindowState const& state, view::VariationView const& variation,
                          Picture& picture, render::Renderer& renderer, ImVec2 const& size_px) const
{
    bool changed
        = std::exchange(picture.revision, state.collection_revision) != state.collection_revision;
    changed |= picture.mesh != variation.mesh.get();
    auto const& canvas = picture.canvas.sized(size_px, changed);
    if (!changed)
        return;
    picture.mesh = variation.mesh.get();
    render::GpuMesh const on_card(*variation.mesh);
    render::Stage stage;
    stage.backdrop = is_light_ ? render::Backdrop() : render::dark_backdrop();
    stage.meshes.push_back({ &on_card });
    double const aspect = static_cast<double>(canvas.width()) / canvas.height();
    render::Framing framing(kSheetAngles, aspect);
    for (auto const& one : state.collection)
        framing.add(*one.mesh);
    renderer.draw(stage, framing.camera(), canvas);
}

void CollectionView::begin(view::WindowModel& model)
{
    model.perform(view::AskForCollection { kVariations, model.state().individuality });
}

void CollectionView::end(view::WindowModel& model)
{
    model.perform(view::AskForCollection { 0, model.state().individuality });
}

void CollectionView::show(view::WindowModel& model, render::Renderer& renderer,
                          ImVec2 const& size_px)
{
    auto const& state = model.state();
    if (std::exchange(is_light_, theme::palette().is_light) != is_light_)
        pictures_.clear();
    std::erase_if(pictures_, [&](auto const& entry) {
        return std::none_of(state.collection.begin(), state.collection.end(),
                            [&](auto const& one) { return one.seed == entry.first; });
    });
    ImVec2 const corner = ImGui::GetCursorScreenPos();
    float const gap = ImGui::GetStyle().ItemSpacing.x;
    ImVec2 const cell((size_px.x - gap * (kSheetColumns + 1)) / kSheetColumns,
                      (size_px.y - gap * (kSheetRows + 1)) / kSheetRows);
    std::optional<std::uint64_t> picked;
    for (std::size_t i = 0; i < state.collection.size() && i < kVariations; ++i) {
        auto const& variation = state.collection[i];
        auto const column = static_cast<float>(i % kSheetColumns);
        auto const row = static_cast<float>(i / kSheetColumns);
        ImVec2 const place(corner.x + gap + column * (cell.x + gap),
                           corner.y + gap + row * (cell.y + gap));
        auto& picture = pictures_[variation.seed];
        draw(state, variation, picture, renderer, cell);
        ImGui::SetCursorScreenPos(place);
        picture.canvas.show();
        ImGui::SetCursorScreenPos(place);
        auto const name = fmt::format("seed {}", variation.seed);
        if (ImGui::InvisibleButton(name.c_str(), cell))
            picked = variation.seed;
        bool const is_marked = ImGui::IsItemHovered() || variation.seed == state.seed;
        auto* const paint = ImGui::GetWindowDrawList();
        if (is_marked)
            paint->AddRect(place, { place.x + cell.x, place.y + cell.y },
                           theme::packed(theme::palette().selected), 8, 0, 3);
        paint->AddText({ place.x + gap, place.y + gap }, ImGui::GetColorU32(ImGuiCol_Text),
                       name.c_str());
    }
    if (picked)
        model.perform(view::PickVariation { *picked });
}

} // namespace tractus::window
