#include "app/methods/leaves/leaf_atlas.h"

#include "app/methods/leaves/atlas_page.h"
#include "app/methods/leaves/leaf_library.h"
#include "engine/base/file.h"
#include "engine/base/parallel.h"
#include "engine/export/glb_writer.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

namespace tractus::leaf {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct AtlasLeaf {
    std::string name;
    std::uint64_t seed = 0;
    double age = 0;
    double pixel_mm = 0; // Side of a pixel in millimetres of the leaf.
    AtlasShape shape {};
};

double gutter(int cell)
{
    return std::max(8.0, cell / 32.0);
}

// Age of the leaf with this number. Multiples of the golden ratio, modulo 1, spread any number of
// leaves evenly.
double age_of(AtlasOptions const& options, std::size_t number)
{
    constexpr double kGolden = 0.6180339887498949;
    double const share = std::fmod(0.5 + kGolden * double(number), 1.0);
    return std::lerp(options.age_from, options.age_to, share);
}

leaf::PaintOptions paint_options_of(AtlasOptions const& options, leaf::Grammar const& grammar,
                                    LeafLife const& life)
{
    auto paint = paint_options(grammar, life);
    paint.side = options.cell;
    paint.stand = { .margin = gutter(options.cell) / options.cell,
                    .middle = leaf::PicturePlacement::Middle::Stem };
    paint.has_underside = true;
    paint.larvae.count = options.damage.larvae;
    paint.spots = options.damage.spots;
    paint.mildew = options.damage.mildew;
    paint.mines = options.damage.mines;
    paint.dead_age = options.damage.dead;
    paint.is_skeleton = options.damage.is_skeleton;
    return paint;
}

// Number of levels of each map. At still smaller ones a pixel is more than a hundredth of a cell,
// so that no mask could keep its coverage.
std::size_t level_count(AtlasOptions const& options)
{
    constexpr int kMinCell = 8; // Side of a cell at the smallest level, in pixels.
    std::size_t count = 1;
    if (options.mips == AtlasOptions::Mips::Files)
        while (options.cell >> count >= kMinCell)
            ++count;
    return count;
}

double blade_length(leaf::Grammar const& grammar)
{
    return grammar.outline.points.empty() ? 1.0 : grammar.outline.points.back().at.y();
}

class AtlasWriter {
public:
    AtlasWriter(AtlasOptions const& options, fs::path const& folder)
        : options_(options)
        , folder_(folder)
        , size_ { options.cell, options.page, level_count(options) }
    {
    }

    Result<AtlasSummary> write()
    {
        for (auto const& name : options_.leaves)
            grammars_.push_back(TRY(load_leaf_grammar(name)));
        TRY(make_folder(folder_));
        auto const each = static_cast<std::size_t>(options_.count);
        auto const count = grammars_.size() * each;
        auto const per_page = size_.columns() * size_.columns();
        // One painter more than there are threads, so that none of them waits.
        std::vector<leaf::LeafPainter> painters(static_cast<std::size_t>(thread_count()) + 1);
        Json pages = Json::array();
        for (std::size_t first = 0; first < count; first += per_page)
            pages.push_back(
                TRY(write_page(pages.size(), painters, first, std::min(per_page, count - first))));
        Json const all {
            { "page", options_.page },           { "cell", options_.cell },
            { "gutter", gutter(options_.cell) }, { "channels", options_.channels.engine },
            { "seed", options_.seed },           { "pages", pages }
        };
        TRY(write_file(folder_ / "leaves.json", all.dump(1) + "\n"));
        return AtlasSummary { count, pages.size() };
    }

private:
    // Grows and paints the leaf with number `number` into a cell of a row.
    Result<AtlasLeaf> paint_into(AtlasRow& row, std::size_t column, std::size_t number,
                                 leaf::LeafPainter& painter) const
    {
        auto const each = static_cast<std::size_t>(options_.count);
        auto const& grammar = grammars_[number / each];
        LeafLife const life { .age = age_of(options_, number % each),
                              .seed = options_.seed + number % each,
                              .variation = options_.variation,
                              .steps = options_.steps };
        auto const grown = TRY(grow_leaf(grammar, life));
        auto const paint = paint_options_of(options_, grammar, life);
        leaf::PictureFrame const frame(grown.triangles, paint.side, paint.stand);
        if (!(frame.x0 > 0) || grown.triangles.veins.empty())
            return fail(Fault::User, fmt::format("{}: the leaf has no extent", grammar.name));
        auto const& picture = painter.paint(grown.leaf, grown.triangles, paint);
        row.place(picture, column);
        double const blade_mm = grammar.size_mm > 0 ? grammar.size_mm : 100;
        double const pixel_mm = blade_mm / (frame.scale * blade_length(grammar));
        return AtlasLeaf { .name = short_leaf_name(grammar.name),
                           .seed = life.seed,
                           .age = life.age,
                           .pixel_mm = pixel_mm,
                           .shape = atlas_shape(options_.geometry, grown, picture, frame,
                                                { pixel_mm, stem() }) };
    }

    // Paints `count` leaves from number `first` on into a row of cells, on all threads.
    Result<std::vector<AtlasLeaf>> paint_row(AtlasRow& row,
                                             std::vector<leaf::LeafPainter>& painters,
                                             std::size_t first, std::size_t count) const
    {
        std::vector<std::size_t> column(painters.size());
        std::vector<std::optional<Result<AtlasLeaf>>> made(painters.size());
        std::vector<AtlasLeaf> leaves;
        std::optional<Error> error;
        std::size_t next = 0;
        parallel_in_order(painters.size(),
                          { .next =
                                [&](std::size_t slot) {
                                    column[slot] = next;
                                    return next++ < count;
                                },
                            .make =
                                [&](std::size_t slot) {
                                    made[slot] = paint_into(row, column[slot], first + column[slot],
                                                            painters[slot]);
                                },
                            .use =
                                [&](std::size_t slot) {
                                    if (!*made[slot]) {
                                        error = made[slot]->error();
                                        return false;
                                    }
                                    leaves.push_back(**std::move(made[slot]));
                                    return true;
                                } });
        if (error)
            return tl::unexpected(*error);
        return leaves;
    }

    Result<Json> write_page(std::size_t number, std::vector<leaf::LeafPainter>& painters,
                            std::size_t first, std::size_t count) const
    {
        std::vector<AtlasLeaf> leaves;
        auto const files = TRY(page_files(leaves, painters, first, count));
        Json names;
        for (std::size_t i = 0; i < files.size(); ++i) {
            auto const& map = options_.channels.maps[i].name;
            auto const name = fmt::format("page-{}-{}", number, map);
            names[map] = name + ".png";
            for (std::size_t level = 0; level < files[i].size(); ++level)
                TRY(write_file(
                    folder_
                        / (level == 0 ? name + ".png" : fmt::format("{}-mip{}.png", name, level)),
                    files[i][level]));
        }
        auto const mesh = fmt::format("page-{}.glb", number);
        TRY(write_glb_file(leaves, files, number, folder_ / mesh));
        return Json { { "maps", names },
                      { "mips", files.front().size() - 1 },
                      { "mesh", mesh },
                      { "cells", cells_json(leaves) } };
    }

    // Paints a page, one row of cells after another, and returns the files of its maps.
    Result<std::vector<std::vector<std::string>>>
    page_files(std::vector<AtlasLeaf>& leaves, std::vector<leaf::LeafPainter>& painters,
               std::size_t first, std::size_t count) const
    {
        auto const columns = size_.columns();
        AtlasRow row(options_.channels, size_);
        PageFiles files(options_.channels, size_);
        for (std::size_t begin = 0; begin < columns * columns; begin += columns) {
            auto const painted = std::min(columns, count - std::min(begin, count));
            auto more = TRY(paint_row(row, painters, first + begin, painted));
            leaves.insert(leaves.end(), std::move_iterator(more.begin()),
                          std::move_iterator(more.end()));
            if (begin == 0)
                row.keep_first_pixel();
            for (auto column = painted; column < columns; ++column)
                row.leave_empty(column);
            files.append(row);
        }
        return std::move(files).finish();
    }

    Vec2 cell_corner(std::size_t cell) const
    {
        return double(options_.cell)
            * Vec2(double(cell % size_.columns()), double(cell / size_.columns()));
    }
    // Position of the petiole's end within a cell, in pixels.
    Vec2 stem() const { return { 0.5 * options_.cell, options_.cell - gutter(options_.cell) }; }

    Json cells_json(std::vector<AtlasLeaf> const& leaves) const
    {
        Json cells = Json::array();
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            auto const& leaf = leaves[i];
            auto const at = cell_corner(i);
            cells.push_back({ { "index", i },
                              { "leaf", leaf.name },
                              { "seed", leaf.seed },
                              { "age", leaf.age },
                              { "x", at.x() },
                              { "y", at.y() },
                              { "size", options_.cell },
                              { "stem", { at.x() + stem().x(), at.y() + stem().y() } },
                              { "size_m", leaf.pixel_mm * options_.cell / 1000 },
                              { "mesh", shape_json(leaf.shape, at, options_.page) } });
        }
        return cells;
    }

    mesh::Mesh mesh_of_leaf(AtlasLeaf const& leaf, std::size_t cell, Material const& material) const
    {
        mesh::Mesh mesh;
        mesh.materials = { material };
        mesh.surfaces.push_back(upright_mesh(leaf.shape, cell_corner(cell), options_.page));
        return mesh;
    }

    Material page_material(std::vector<std::vector<std::string>> const& files,
                           std::size_t number) const
    {
        Material material { .name = fmt::format("page {}", number),
                            .kind = Material::Kind::Petal,
                            .base_color = { 1, 1, 1 },
                            .roughness = 1,
                            .translucency = 0.4f };
        if (!options_.channels.is_gltf)
            return material;
        auto const texture = [&](std::size_t i) {
            return std::make_shared<TexturePicture const>(TexturePicture {
                .bytes = files[i].front(), .edges = TexturePicture::Edges::Clamp });
        };
        auto const roughness = texture(2);
        material.textures = { .base_color = texture(0),
                              .normal = texture(1),
                              .occlusion = roughness,
                              .roughness = roughness,
                              .alpha = options_.geometry == AtlasGeometry::Modelled
                                  ? MaterialTextures::Alpha::Opaque
                                  : MaterialTextures::Alpha::Mask };
        return material;
    }

    // Writes the leaves' meshes side by side, as on the page, so that any viewer of the file shows
    // all of them.
    Result<void> write_glb_file(std::vector<AtlasLeaf> const& leaves,
                                std::vector<std::vector<std::string>> const& files,
                                std::size_t number, fs::path const& path) const
    {
        auto const material = page_material(files, number);
        auto const columns = size_.columns();
        double gap_mm = 0;
        for (auto const& leaf : leaves)
            gap_mm = std::max(gap_mm, leaf.pixel_mm * options_.cell);
        std::vector<mesh::Mesh> meshes;
        for (std::size_t i = 0; i < leaves.size(); ++i)
            meshes.push_back(mesh_of_leaf(leaves[i], i, material));
        std::vector<exports::PlacedMesh> placed;
        for (std::size_t i = 0; i < leaves.size(); ++i)
            placed.push_back(
                { .name = fmt::format("{} {}", leaves[i].name, i),
                  .position_mm = gap_mm * Vec3(double(i % columns), 0, -double(i / columns)),
                  .mesh = &meshes[i] });
        exports::GlbOptions const glb { .textures = options_.channels.is_gltf
                                            ? exports::GlbOptions::Textures::Embedded
                                            : exports::GlbOptions::Textures::None };
        return write_file(path, [&](std::ostream& out) -> Result<void> {
            TRY(exports::write_glb(out, placed, glb));
            return {};
        });
    }

    AtlasOptions const& options_;
    fs::path folder_;
    AtlasSize size_;
    std::vector<leaf::Grammar> grammars_;
};

} // namespace

Result<AtlasSummary> write_atlas(AtlasOptions const& options, fs::path const& folder)
{
    return AtlasWriter(options, folder).write();
}

} // namespace tractus::leaf
