#include "app/batch/collection_sheet.h"

#include "app/render/contact_sheet.h"
#include "engine/mesh/make_mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tractus::batch {

// Coarse mesh options for the sheet's tiles, in which even the thickest trunk is only a few pixels
// wide.
static constexpr mesh::MeshOptions kSheetMesh { .min_sides = 3, .max_sides = 8, .subdivision = 2 };

static std::size_t sheet_plant_count(std::size_t count)
{
    return std::min(count, kMaxSheetPlants);
}

std::size_t sheet_plant(std::size_t tile, std::size_t count)
{
    auto const tiles = sheet_plant_count(count);
    return tiles < 2 ? 0 : tile * (count - 1) / (tiles - 1);
}

render::Image collection_sheet(PictureMaker& pictures, SheetPlants const& plants,
                               PictureSize const& tile_size, terminal::Progress& progress)
{
    auto const tile_count = sheet_plant_count(plants.count);
    progress.begin("drawing the plants", 2 * tile_count);
    // Fits the largest plant, as all plants are shown at the same scale.
    render::Framing framing({}, tile_size.aspect());
    for (std::size_t tile = 0; tile < tile_count; ++tile) {
        framing.add(mesh::make_mesh(plants.plant(sheet_plant(tile, plants.count)), kSheetMesh));
        progress.step();
    }
    std::vector<render::SheetTile> tiles;
    for (std::size_t tile = 0; tile < tile_count; ++tile) {
        auto const index = sheet_plant(tile, plants.count);
        tiles.push_back({ pictures.plant(mesh::make_mesh(plants.plant(index), kSheetMesh),
                                         tile_size, framing.camera()),
                          plants.caption(index) });
        progress.step();
    }
    render::SheetStyle style;
    style.caption_size_px = 15;
    style.gap_px = 12;
    // Number of columns for a sheet slightly wider than high.
    style.columns = static_cast<int>(std::ceil(std::sqrt(1.2 * static_cast<double>(tile_count))));
    return render::contact_sheet(tiles, style);
}

} // namespace tractus::batch
