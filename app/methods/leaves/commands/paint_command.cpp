#include "app/methods/leaves/commands/paint_command.h"

#include "app/methods/leaves/leaf_library.h"
#include "app/methods/leaves/leaf_picture.h"
#include "app/options/checks.h"
#include "app/options/examples.h"
#include "app/render/contact_sheet.h"
#include "app/render/image.h"
#include "app/terminal/console.h"
#include "engine/base/file.h"
#include "engine/base/parallel.h"
#include "engine/export/png.h"
#include "engine/methods/leaves/leaf_paint.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tractus::leaf {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kMaxSide = 16'384; // Maximum side of a page, in pixels.
constexpr int kMaxLeaves = 4096;

struct PaintArguments {
    std::vector<std::string> leaves;
    fs::path output;
    int count = 1; // Number of leaves for each grammar.
    int side = 512;
    double age = 0.5;
    std::optional<double> age_to;
    std::optional<int> steps;
    std::uint64_t seed = 1;
    double variation = 1;
    int larvae = 0;
    double spots = 0;
    double mildew = 0;
    int mines = 0;
    double dead = 0;
    bool is_skeleton = false;
};

// A leaf of a page: how it was grown, and its picture.
struct PaintedLeaf {
    std::string name;
    std::uint64_t seed = 0;
    double age = 0;
    double length_mm = 0; // Side of the picture in millimetres of the leaf.
    leaf::LeafPicture picture;
};

Result<PaintedLeaf> paint_one(leaf::Grammar const& grammar, PaintArguments const& arguments,
                              int number)
{
    double const share = arguments.count > 1 ? double(number) / (arguments.count - 1) : 0;
    PaintedLeaf made;
    made.seed = arguments.seed + static_cast<std::uint64_t>(number);
    made.age = std::lerp(arguments.age, arguments.age_to.value_or(arguments.age), share);
    LeafLife const life { .age = made.age,
                          .seed = made.seed,
                          .variation = arguments.variation,
                          .steps = arguments.steps };
    auto const grown = TRY(grow_leaf(grammar, life));
    if (!(leaf::PictureFrame(grown.triangles, arguments.side).scale > 0)
        || grown.triangles.veins.empty())
        return fail(Fault::User, fmt::format("{}: the leaf has no extent", grammar.name));
    auto options = paint_options(grammar, life);
    options.side = arguments.side;
    options.spots = arguments.spots;
    options.mildew = arguments.mildew;
    options.mines = arguments.mines;
    options.dead_age = arguments.dead;
    options.larvae.count = arguments.larvae;
    options.is_skeleton = arguments.is_skeleton;
    leaf::PictureFrame const frame(grown.triangles, arguments.side);
    double const blade_mm = grammar.size_mm > 0 ? grammar.size_mm : 100;
    double const blade
        = grammar.outline.points.empty() ? 1.0 : grammar.outline.points.back().at.y();
    made.length_mm = blade_mm * arguments.side / (frame.scale * blade);
    made.picture = leaf::paint_leaf(grown.leaf, grown.triangles, options);
    return made;
}

// Paints the leaves of all grammars. Each leaf is a separate task for the threads.
Result<std::vector<PaintedLeaf>> paint_all(PaintArguments const& arguments)
{
    std::vector<leaf::Grammar> grammars;
    for (auto const& name : arguments.leaves)
        grammars.push_back(TRY(load_leaf_grammar(name)));
    auto const each = static_cast<std::size_t>(arguments.count);
    auto const count = grammars.size() * each;
    if (count > kMaxLeaves)
        return fail(
            Fault::User,
            fmt::format("these are {} leaves: paint no more than {} at once", count, kMaxLeaves));
    std::vector<std::optional<Result<PaintedLeaf>>> made(count);
    parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            made[i] = paint_one(grammars[i / each], arguments, static_cast<int>(i % each));
    });
    std::vector<PaintedLeaf> leaves;
    for (std::size_t i = 0; i < count; ++i) {
        leaves.push_back(TRY(*std::move(made[i])));
        leaves.back().name = short_leaf_name(arguments.leaves[i / each]);
    }
    return leaves;
}

Result<void> write_sheet(std::span<PaintedLeaf const> leaves, fs::path const& path)
{
    render::SheetStyle style;
    style.columns = static_cast<int>(std::ceil(std::sqrt(double(leaves.size()))));
    std::vector<render::SheetTile> tiles;
    for (auto const& leaf : leaves)
        tiles.push_back({ on_paper(leaf.picture, style.paper), leaf.name });
    auto const image
        = leaves.size() == 1 ? tiles.front().picture : render::contact_sheet(tiles, style);
    return write_file(path, [&](std::ostream& out) { return render::write_png(out, image); });
}

// A page of cells in a square grid; unused cells stay empty.
struct Page {
    int columns = 1;
    int cell = 0;
    int side() const { return columns * cell; }

    template<std::size_t N>
    void place(std::vector<std::uint8_t>& to, std::size_t number,
               std::vector<std::array<std::uint8_t, N>> const& from) const
    {
        auto const width = static_cast<std::size_t>(cell);
        auto const row = number / static_cast<std::size_t>(columns);
        auto const column = number % static_cast<std::size_t>(columns);
        for (std::size_t y = 0; y < width; ++y)
            for (std::size_t x = 0; x < width; ++x)
                for (std::size_t c = 0; c < N; ++c)
                    to[((row * width + y) * static_cast<std::size_t>(side()) + column * width + x)
                           * N
                       + c]
                        = from[y * width + x][c];
    }
};

template<typename Get>
Result<void> write_page(Page const& page, std::span<PaintedLeaf const> leaves, fs::path const& path,
                        std::array<std::uint8_t, 4> const& empty, int channels, Get const& get)
{
    auto const count
        = static_cast<std::size_t>(page.side()) * static_cast<std::size_t>(page.side());
    std::vector<std::uint8_t> pixels;
    pixels.reserve(count * static_cast<std::size_t>(channels));
    for (std::size_t i = 0; i < count; ++i)
        pixels.insert(pixels.end(), empty.begin(), empty.begin() + channels);
    for (std::size_t i = 0; i < leaves.size(); ++i)
        page.place(pixels, i, get(leaves[i].picture));
    return write_file(path,
                      exports::png_bytes({ .width = page.side(),
                                           .height = page.side(),
                                           .channels = channels,
                                           .pixels = pixels,
                                           .packing = exports::PngPicture::Packing::Fast }));
}

Json page_json(Page const& page, std::span<PaintedLeaf const> leaves)
{
    Json cells = Json::array();
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        auto const& leaf = leaves[i];
        auto const columns = static_cast<std::size_t>(page.columns);
        cells.push_back({ { "index", i },
                          { "leaf", leaf.name },
                          { "seed", leaf.seed },
                          { "age", leaf.age },
                          { "x", (i % columns) * static_cast<std::size_t>(page.cell) },
                          { "y", (i / columns) * static_cast<std::size_t>(page.cell) },
                          { "size", page.cell },
                          { "size_m", leaf.length_mm / 1000 } });
    }
    return { { "page", page.side() },
             { "color", "color.png" },
             { "normal", "normal.png" },
             { "occlusion_roughness", "occlusion-roughness.png" },
             { "translucency", "translucency.png" },
             { "cells", cells } };
}

Result<void> write_maps(std::span<PaintedLeaf const> leaves, fs::path const& folder)
{
    Page page { .cell = leaves.front().picture.side };
    page.columns = static_cast<int>(std::ceil(std::sqrt(double(leaves.size()))));
    if (page.side() > kMaxSide)
        return fail(Fault::User,
                    fmt::format("a page of {} leaves of {} pixels is {} pixels wide, and may be "
                                "{}: use a smaller --pixels or --count",
                                leaves.size(), page.cell, page.side(), kMaxSide));
    TRY(make_folder(folder));
    using Picture = leaf::LeafPicture;
    TRY(write_page(
        page, leaves, folder / "color.png", { 96, 110, 60, 0 }, 4,
        [](Picture const& picture) -> auto const& { return picture.color; }));
    TRY(write_page(
        page, leaves, folder / "normal.png", { 128, 128, 255, 0 }, 3,
        [](Picture const& picture) -> auto const& { return picture.normal; }));
    TRY(write_page(
        page, leaves, folder / "occlusion-roughness.png", { 255, 128, 0, 0 }, 3,
        [](Picture const& picture) -> auto const& { return picture.roughness; }));
    TRY(write_page(page, leaves, folder / "translucency.png", { 0, 0, 0, 0 }, 1,
                   [](Picture const& picture) {
                       std::vector<std::array<std::uint8_t, 1>> grey;
                       for (auto const value : picture.translucency)
                           grey.push_back({ value });
                       return grey;
                   }));
    return write_file(folder / "leaves.json", page_json(page, leaves).dump(2) + "\n");
}

Result<void> paint_leaves(PaintArguments const& arguments)
{
    auto const leaves = TRY(paint_all(arguments));
    if (arguments.output.extension() == ".png")
        TRY(write_sheet(leaves, arguments.output));
    else
        TRY(write_maps(leaves, arguments.output));
    return terminal::print_out(
        fmt::format("wrote {}: leaves {}\n", arguments.output.string(), leaves.size()));
}

Result<void> list_leaves()
{
    for (auto const& name : leaf_names()) {
        auto const grammar = TRY(load_leaf_grammar(name));
        TRY(terminal::print_out(
            fmt::format("{:<12} {:>4.0f} mm, {} steps\n", name, grammar.size_mm, grammar.steps)));
    }
    return {};
}

void add_paint_options(CLI::App& paint, PaintArguments& arguments)
{
    paint.add_option("LEAF", arguments.leaves, "Leaf grammars (.leaf), or ours by name: oak")
        ->type_name("LEAF|FILE")
        ->check(options::suggest(leaf_names()))
        ->required();
    paint
        .add_option("-o,--output", arguments.output,
                    "A picture (.png), or a folder for the maps of a material")
        ->type_name("FILE|DIR")
        ->required();
    paint.add_option("--count", arguments.count, "How many of each, all different")
        ->type_name("N")
        ->check(options::whole_number(1, kMaxLeaves))
        ->capture_default_str();
    paint.add_option("--pixels", arguments.side, "Each leaf's picture is so wide and high")
        ->type_name("N")
        ->check(options::whole_number(16, 4096))
        ->capture_default_str();
    paint.add_option("--age", arguments.age, "0: a bud, 0.5: grown up, 1: an old leaf")
        ->type_name("AGE")
        ->check(options::number(0, 1))
        ->capture_default_str();
    paint.add_option("--age-to", arguments.age_to, "The last leaf's age; those between follow")
        ->type_name("AGE")
        ->check(options::number(0, 1));
    paint.add_option("--steps", arguments.steps, "Of a grown-up; without it, the grammar's own")
        ->type_name("N")
        ->check(options::whole_number(1, 1000));
    paint.add_option("--seed", arguments.seed, "Which leaf; the next ones follow")
        ->type_name("SEED")
        ->capture_default_str();
    paint.add_option("--variation", arguments.variation, "How far leaves differ; 0: not at all")
        ->type_name("V")
        ->check(options::number(0, 3))
        ->capture_default_str();
    paint.add_option("--larvae", arguments.larvae, "How many larvae ate of it")
        ->type_name("N")
        ->check(options::whole_number(0, 100))
        ->capture_default_str();
    paint.add_option("--spots", arguments.spots, "How much of it has brown spots")
        ->type_name("SHARE")
        ->check(options::number(0, 1))
        ->capture_default_str();
    paint.add_option("--mildew", arguments.mildew, "How much of it is white with mildew")
        ->type_name("SHARE")
        ->check(options::number(0, 1));
    paint.add_option("--mines", arguments.mines, "How many ways larvae have eaten under its skin")
        ->type_name("N")
        ->check(options::whole_number(0, 100));
    paint.add_option("--dead", arguments.dead, "How far its old colour has become a dead one")
        ->type_name("SHARE")
        ->check(options::number(0, 1));
    paint.add_flag("--skeleton", arguments.is_skeleton, "Leave nothing but veins");
}

} // namespace

void add_paint_commands(CLI::App& leaves, options::Action& action)
{
    auto painted = std::make_shared<PaintArguments>();
    auto* const paint
        = leaves.add_subcommand("paint", "Paint leaves: a picture, or maps for a material");
    add_paint_options(*paint, *painted);
    paint->footer("A folder gets color.png (with alpha), normal.png, occlusion-roughness.png,\n"
                  "translucency.png, each a page with a cell for each leaf, and leaves.json,\n"
                  "which says what lies where and how large it is.");
    options::add_examples(
        *paint,
        { "leaves paint oak ivy rose -o painted.png", "leaves paint oak --count 4 -o oak-leaves" });
    paint->callback([painted, &action] { action = [painted] { return paint_leaves(*painted); }; });

    auto* const list
        = leaves.add_subcommand("list", "Name the leaf grammars that come with the program");
    options::add_examples(*list, { "leaves list" });
    list->callback([&action] { action = [] { return list_leaves(); }; });
}

} // namespace tractus::leaf
