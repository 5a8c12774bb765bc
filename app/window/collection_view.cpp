#include "app/window/collection_view.h"

#include "app/window/theme.h"
#include "engine/mesh/mesh_measures.h"

#include <algorithm>
#include <fmt/core.h>
#include <optional>
#include <utility>

namespace tractus::window {

namespace {

constexpr render::ViewAngles kSheetAngles { .azimuth_rad = 0.45, .elevation_rad = 0.22 };

// Returns the width to allow for the plants, as a share of their height. It is the larger of their
// extents along x and y, as each plant may be turned about the vertical.
double shape_of(std::vector<view::VariationView> const& plants)
{
    Bounds all;
    for (auto const& plant : plants)
        if (auto const box = mesh::bounds(*plant.mesh); !box.empty()) {
            all.add(box.min_mm);
            all.add(box.max_mm);
        }
    if (all.empty())
        return 1;
    Vec3 const size_mm = all.max_mm - all.min_mm;
    return std::clamp(size_mm.head<2>().maxCoeff() / std::max(1.0, size_mm.z()), 0.2, 5.0);
}

} // namespace

std::size_t sheet_columns(std::size_t count, ImVec2 const& size_px, double shape)
{
    std::size_t best = 1;
    double best_px = 0;
    for (std::size_t columns = 1; columns <= count; ++columns) {
        auto const rows = (count + columns - 1) / columns;
        double const width_px = static_cast<double>(size_px.x) / static_cast<double>(columns);
        double const height_px = static_cast<double>(size_px.y) / static_cast<double>(rows);
        double const plant_px = std::min(height_px, width_px / shape);
        if (plant_px > best_px) {
            best_px = plant_px;
            best = columns;
        }
    }
    return best;
}

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
    model.perform(view::RequestCollection { kVariations, model.state().individuality });
}

void CollectionView::end(view::WindowModel& model)
{
    model.perform(view::RequestCollection { 0, model.state().individuality });
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
    if (std::exchange(shape_revision_, state.collection_revision) != state.collection_revision)
        shape_ = shape_of(state.collection);
    auto const columns = sheet_columns(kVariations, size_px, shape_);
    auto const rows = (kVariations + columns - 1) / columns;
    auto const cell_px = [gap](float room_px, std::size_t cells) {
        return (room_px - gap) / static_cast<float>(cells) - gap;
    };
    ImVec2 const cell(cell_px(size_px.x, columns), cell_px(size_px.y, rows));
    std::optional<std::uint64_t> picked;
    for (std::size_t i = 0; i < state.collection.size() && i < kVariations; ++i) {
        auto const& variation = state.collection[i];
        auto const column = static_cast<float>(i % columns);
        auto const row = static_cast<float>(i / columns);
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
        bool const is_hovered = ImGui::IsItemHovered();
        bool const is_marked = is_hovered || variation.seed == state.seed;
        auto* const paint = ImGui::GetWindowDrawList();
        if (is_marked)
            paint->AddRect(place, { place.x + cell.x, place.y + cell.y },
                           theme::packed(theme::palette().selected), 8, 0, 3);
        paint->AddText({ place.x + gap, place.y + gap }, ImGui::GetColorU32(ImGuiCol_Text),
                       is_hovered ? fmt::format("{} of {}, {}", i + 1, kVariations, name).c_str()
                                  : name.c_str());
    }
    if (picked)
        model.perform(view::PickVariation { *picked });
}

} // namespace tractus::window
