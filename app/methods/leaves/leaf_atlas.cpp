#include "app/methods/leaves/leaf_atlas.h"

#include "app/methods/leaves/leaf_library.h"
#include "engine/base/file.h"
#include "engine/base/parallel.h"
#include "engine/export/glb_writer.h"
#include "engine/export/png.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
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
    leaf::Cutout cutout;
};

// The maps of a page, in the order of AtlasChannels::maps.
using PageMaps = std::vector<leaf::CellPage>;

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

double blade_length(leaf::Grammar const& grammar)
{
    return grammar.outline.points.empty() ? 1.0 : grammar.outline.points.back().at.y();
}

class AtlasWriter {
public:
    AtlasWriter(AtlasOptions const& options, fs::path const& folder)
        : options_(options)
        , folder_(folder)
    {
    }

    Result<AtlasSummary> write()
    {
        for (auto const& name : options_.leaves)
            grammars_.push_back(TRY(load_leaf_grammar(name)));
        TRY(make_folder(folder_));
        auto const each = static_cast<std::size_t>(options_.count);
        auto const count = grammars_.size() * each;
        auto const columns = static_cast<std::size_t>(options_.page / options_.cell);
        Json pages = Json::array();
        for (std::size_t first = 0; first < count; first += columns * columns)
            pages.push_back(
                TRY(write_page(pages.size(), first, std::min(columns * columns, count - first))));
        Json const all {
            { "page", options_.page },           { "cell", options_.cell },
            { "gutter", gutter(options_.cell) }, { "channels", options_.channels.engine },
            { "seed", options_.seed },           { "pages", pages }
        };
        TRY(write_file(folder_ / "leaves.json", all.dump(1) + "\n"));
        return AtlasSummary { count, pages.size() };
    }

private:
    PageMaps empty_maps() const
    {
        PageMaps maps;
        for (auto const& map : options_.channels.maps) {
            auto const side = static_cast<std::size_t>(options_.page);
            maps.push_back({ .side = options_.page,
                             .cell = options_.cell,
                             .channels = static_cast<int>(map.channels.size()) });
            maps.back().pixels.assign(side * side * map.channels.size(), 0);
        }
        return maps;
    }

    // Grows and paints the leaf with number `number` into the cell `cell` of a page.
    Result<AtlasLeaf> paint_into(PageMaps& maps, std::size_t cell, std::size_t number,
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
        for (std::size_t i = 0; i < maps.size(); ++i)
            place_in_cell(options_.channels.maps[i], picture, maps[i], cell);
        double const blade_mm = grammar.size_mm > 0 ? grammar.size_mm : 100;
        return AtlasLeaf { .name = short_leaf_name(grammar.name),
                           .seed = life.seed,
                           .age = life.age,
                           .pixel_mm = blade_mm / (frame.scale * blade_length(grammar)),
                           .cutout = leaf::cut_out(picture.alpha, paint.side) };
    }

    // Paints the leaves of a page on all threads. There is one painter more than there are threads.
    Result<std::vector<AtlasLeaf>> paint_page(PageMaps& maps, std::size_t first,
                                              std::size_t count) const
    {
        auto const slots = static_cast<std::size_t>(thread_count()) + 1;
        std::vector<leaf::LeafPainter> painters(slots);
        std::vector<std::size_t> cell(slots);
        std::vector<std::optional<Result<AtlasLeaf>>> made(slots);
        std::vector<AtlasLeaf> leaves;
        std::optional<Error> error;
        std::size_t next = 0;
        parallel_in_order(slots,
                          { .next =
                                [&](std::size_t slot) {
                                    cell[slot] = next;
                                    return next++ < count;
                                },
                            .make =
                                [&](std::size_t slot) {
                                    made[slot] = paint_into(maps, cell[slot], first + cell[slot],
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

    Result<Json> write_page(std::size_t number, std::size_t first, std::size_t count) const
    {
        auto maps = empty_maps();
        auto const leaves = TRY(paint_page(maps, first, count));
        fill_unused(maps, count);
        auto const files = pack(maps);
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

    // Fills the unused cells of each map with the value of the map's first pixel, which is not part
    // of a leaf.
    void fill_unused(PageMaps& maps, std::size_t count) const
    {
        auto const columns = static_cast<std::size_t>(options_.page / options_.cell);
        for (auto& map : maps) {
            auto const channels = static_cast<std::size_t>(map.channels);
            auto const row = static_cast<std::size_t>(map.side) * channels;
            auto const width = static_cast<std::size_t>(map.cell);
            std::vector<std::uint8_t> const first(
                map.pixels.begin(), map.pixels.begin() + static_cast<std::ptrdiff_t>(channels));
            for (std::size_t cell = count; cell < columns * columns; ++cell)
                for (std::size_t y = 0; y < width; ++y) {
                    auto* to = map.pixels.data() + (cell / columns * width + y) * row
                        + cell % columns * width * channels;
                    for (std::size_t x = 0; x < width; ++x)
                        to = std::ranges::copy(first, to).out;
                }
        }
    }

    // Encodes the .png files of each map; the full-size file is the first.
    std::vector<std::vector<std::string>> pack(PageMaps& maps) const
    {
        std::vector<std::vector<std::string>> files(maps.size());
        parallel_for(maps.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (auto i = begin; i < end; ++i)
                files[i] = pack_map(std::move(maps[i]), options_.channels.maps[i].kind);
        });
        return files;
    }

    std::vector<std::string> pack_map(leaf::CellPage page, leaf::PageKind kind) const
    {
        // Minimum side of a cell in pixels; at smaller mipmap levels no leaf would be visible.
        constexpr int kMinCell = 4;
        bool const has_alpha = kind == leaf::PageKind::Color && page.channels == 4;
        std::vector<double> wanted;
        if (has_alpha && options_.mips == AtlasOptions::Mips::Files)
            wanted = leaf::alpha_coverage(page);
        std::vector<std::string> files { png_of(page) };
        while (options_.mips == AtlasOptions::Mips::Files && page.cell > kMinCell) {
            page = leaf::half_page(page, kind);
            auto shown = page;
            if (has_alpha)
                leaf::keep_coverage(shown, wanted);
            files.push_back(png_of(shown));
        }
        return files;
    }

    static std::string png_of(leaf::CellPage const& page)
    {
        return exports::png_bytes({ .width = page.side,
                                    .height = page.side,
                                    .channels = page.channels,
                                    .pixels = page.pixels,
                                    .packing = exports::PngPicture::Packing::Fast });
    }

    Vec2 cell_corner(std::size_t cell) const
    {
        auto const columns = static_cast<std::size_t>(options_.page / options_.cell);
        return double(options_.cell) * Vec2(double(cell % columns), double(cell / columns));
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
                              { "mesh", mesh_json(leaf, at) } });
        }
        return cells;
    }

    // The mesh of a leaf as JSON. Positions are in metres from the petiole's end, x to the right, y
    // towards the tip. Texture coordinates are those of glTF, with the origin at the page's upper
    // left corner.
    Json mesh_json(AtlasLeaf const& leaf, Vec2 const& at) const
    {
        Json positions = Json::array();
        Json coordinates = Json::array();
        for (auto const& corner : leaf.cutout.corners) {
            Vec2 const from_stem = leaf.pixel_mm / 1000 * (corner - stem());
            positions.push_back({ from_stem.x(), -from_stem.y() });
            Vec2 const uv = (at + corner) / options_.page;
            coordinates.push_back({ uv.x(), uv.y() });
        }
        return { { "positions", positions },
                 { "uv", coordinates },
                 { "triangles", leaf.cutout.triangles } };
    }

    mesh::Mesh mesh_of_leaf(AtlasLeaf const& leaf, std::size_t cell, Material const& material) const
    {
        mesh::Mesh mesh;
        mesh.materials = { material };
        mesh::TriangleMesh shape;
        for (auto const& corner : leaf.cutout.corners) {
            Vec2 const from_stem = leaf.pixel_mm * (corner - stem());
            Vec2 const uv = (cell_corner(cell) + corner) / options_.page;
            shape.positions_mm.push_back(Vec3(from_stem.x(), 0, -from_stem.y()).cast<float>());
            shape.normals.emplace_back(0.0f, -1.0f, 0.0f);
            shape.texture_coordinates.push_back(uv.cast<float>());
        }
        for (auto const& triangle : leaf.cutout.triangles)
            for (auto const corner : triangle)
                shape.indices.push_back(corner);
        mesh.surfaces.push_back(std::move(shape));
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
                              .alpha = MaterialTextures::Alpha::Mask };
        return material;
    }

    // Writes the leaves' meshes side by side, as on the page, so that any viewer of the file shows
    // all of them.
    Result<void> write_glb_file(std::vector<AtlasLeaf> const& leaves,
                                std::vector<std::vector<std::string>> const& files,
                                std::size_t number, fs::path const& path) const
    {
        auto const material = page_material(files, number);
        auto const columns = static_cast<std::size_t>(options_.page / options_.cell);
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
    std::vector<leaf::Grammar> grammars_;
};

} // namespace

Result<AtlasSummary> write_atlas(AtlasOptions const& options, fs::path const& folder)
{
    return AtlasWriter(options, folder).write();
}

} // namespace tractus::leaf
