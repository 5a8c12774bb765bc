#include "app/batch/plant_billboard.h"

#include "engine/mesh/mesh_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

namespace tractus::batch {

static constexpr int kViewSide_px = 256;

// Gives transparent pixels the mean colour of the opaque ones, so that mipmaps have no dark
// fringes.
static void fill_transparent(render::Image& picture)
{
    std::array<std::uint64_t, 3> sum {};
    std::uint64_t count = 0;
    for (auto const& pixel : picture.pixels())
        if (pixel.alpha > 127) {
            sum[0] += pixel.red;
            sum[1] += pixel.green;
            sum[2] += pixel.blue;
            ++count;
        }
    auto const mean = [&](std::size_t i) {
        return static_cast<std::uint8_t>(sum[i] / std::max<std::uint64_t>(count, 1));
    };
    for (auto& pixel : picture.pixels())
        if (pixel.alpha == 0)
            pixel = { mean(0), mean(1), mean(2), 0 };
}

// Returns the mesh's greatest distance from the vertical axis through `center_mm`. A view of this
// half width shows the whole mesh from every side.
static double radius_around(Vec3 const& center_mm, mesh::Mesh const& mesh)
{
    Vec2f const center = center_mm.head<2>().cast<float>();
    float radius_mm = 0;
    auto const add = [&](Vec3f const& at, float reach_mm) {
        radius_mm = std::max(radius_mm, (at.head<2>() - center).norm() + reach_mm);
    };
    for (auto const& surface : mesh.surfaces)
        for (auto const& position : surface.positions_mm)
            add(position, 0);
    for (auto const& organ : mesh.organs) {
        float reach_mm = 0;
        for (auto const& position : organ.prototype.positions_mm)
            reach_mm = std::max(reach_mm, position.norm());
        for (auto const& instance : organ.instances)
            add(instance.translation_mm, reach_mm * instance.scale.cwiseAbs().maxCoeff());
    }
    return radius_mm;
}

Result<exports::Billboard> draw_billboard(PictureMaker& pictures, mesh::Mesh const& mesh)
{
    auto const box = mesh::bounds(mesh);
    exports::Billboard billboard;
    if (!box.empty()) {
        Vec3 const size_mm = box.max_mm - box.min_mm;
        billboard.center_mm = 0.5 * (box.min_mm + box.max_mm);
        billboard.side_mm = std::max(2 * radius_around(billboard.center_mm, mesh), size_mm.z());
    }
    billboard.side_mm = std::max(billboard.side_mm, 1.0);
    std::vector<PictureMaker::Cutout> views;
    for (int view = 0; view < exports::kBillboardViews; ++view)
        views.push_back({ billboard.center_mm, billboard.side_mm,
                          2 * kPi * view / exports::kBillboardViews, kViewSide_px });
    render::Image atlas(exports::kBillboardColumns * kViewSide_px,
                        exports::kBillboardViews / exports::kBillboardColumns * kViewSide_px);
    auto const drawn = pictures.cutouts(mesh, views);
    for (int view = 0; view < exports::kBillboardViews; ++view)
        render::paste(atlas, drawn[static_cast<std::size_t>(view)],
                      view % exports::kBillboardColumns * kViewSide_px,
                      view / exports::kBillboardColumns * kViewSide_px);
    fill_transparent(atlas);
    std::ostringstream png;
    TRY(render::write_png(png, atlas));
    billboard.atlas_png = std::move(png).str();
    return billboard;
}

} // namespace tractus::batch
