#include "app/methods/leaves/plant_leaves.h"

#include "app/methods/leaves/atlas_channels.h"
#include "app/methods/leaves/leaf_library.h"
#include "app/methods/leaves/leaf_maps.h"
#include "engine/export/gltf_material.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <list>
#include <memory>
#include <mutex>
#include <span>
#include <utility>

namespace tractus::leaf {

namespace {

constexpr int kCell = 256; // Side of a cell in pixels.
constexpr int kGutter = 8; // Width of the empty border in each cell, in pixels.
constexpr int kMaxBends = 3;

// Number of columns of cells on a page for `variants` leaves: a power of two, as game engines
// prefer such page sizes.
int columns_for(int variants)
{
    int columns = 1;
    while (columns * columns < variants)
        columns *= 2;
    return columns;
}

// Returns the outline with corners added where it crosses the line x = 0, starting at the lower
// crossing. Empty unless there are exactly two crossings.
std::vector<Vec2> cut_at_midrib(std::vector<Vec2> const& outline)
{
    std::vector<Vec2> cut;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        Vec2 const& a = outline[i];
        Vec2 const& b = outline[(i + 1) % outline.size()];
        cut.push_back(a);
        if (a.x() * b.x() < 0)
            cut.emplace_back(0, a.y() + (b.y() - a.y()) * a.x() / (a.x() - b.x()));
    }
    auto const is_on = [](Vec2 const& at) { return at.x() == 0; };
    if (std::ranges::count_if(cut, is_on) != 2)
        return {};
    auto const first = std::ranges::find_if(cut, is_on);
    auto const second = std::find_if(std::next(first), cut.end(), is_on);
    std::rotate(cut.begin(), first->y() < second->y() ? first : second, cut.end());
    return cut;
}

// Position of an outline's corner relative to the petiole's end. A corner within a pixel of the
// midrib is moved onto it, to avoid slivers.
Vec2 from_stem(Vec2 const& pixel, Vec2 const& stem)
{
    Vec2 const at(pixel.x() - stem.x(), stem.y() - pixel.y());
    return { std::abs(at.x()) < 1 ? 0 : at.x(), at.y() };
}

// Adds the triangles of one half of the leaf; `numbers` are the indices of the half's corners.
void add_half(CutLeaf& leaf, std::vector<std::uint32_t> const& numbers)
{
    std::vector<Vec2> half;
    for (auto const number : numbers)
        half.push_back(leaf.corners[number]);
    for (auto const& [a, b, c] : leaf::cut_polygon(half))
        leaf.triangles.push_back({ numbers[a], numbers[b], numbers[c] });
}

// The cut-out mesh of a leaf. It follows the outline as closely as the triangle limit allows: the
// number of bays (concave parts) is reduced until the limit is met. Without bays, the mesh is a
// convex hull.
CutLeaf cut_leaf(leaf::LeafPicture const& picture, Vec2 const& stem, double blade_px)
{
    for (int bays = 6; bays >= 0; --bays) {
        auto const cutout = leaf::cut_out(
            picture.alpha, picture.side,
            { .min_alpha = 0.3f, .most_corners = bays == 0 ? 12 : 16, .most_bays = bays });
        for (int bends = kMaxBends; bends >= 1; --bends) {
            auto leaf = cut_along_midrib(cutout, stem, blade_px, bends);
            if (!leaf.triangles.empty() && leaf.triangles.size() <= kMaxLeafTriangles)
                return leaf;
        }
    }
    return {};
}

struct PageMap {
    AtlasMap const& map;
    PixelMap pixels;
};

PageMap empty_page(AtlasMap const& map, int columns)
{
    auto const side = static_cast<std::size_t>(columns * kCell);
    PixelMap page { .width = columns * kCell,
                    .height = columns * kCell,
                    .channels = static_cast<int>(map.channels.size()) };
    page.pixels.assign(side * side * map.channels.size(), 0);
    return { map, std::move(page) };
}

void place_in_cell(PageMap& page, leaf::LeafPicture const& picture, int cell)
{
    auto const columns = page.pixels.width / kCell;
    auto const channels = page.map.channels.size();
    auto const row = static_cast<std::size_t>(page.pixels.width) * channels;
    place_picture(page.map, picture,
                  page.pixels.pixels.data() + static_cast<std::size_t>(cell / columns * kCell) * row
                      + static_cast<std::size_t>(cell % columns * kCell) * channels,
                  row);
}

std::string png_of(PixelMap const& page)
{
    return exports::png_bytes({ .width = page.width,
                                .height = page.height,
                                .channels = page.channels,
                                .pixels = page.pixels,
                                .packing = exports::PngPicture::Packing::Fast });
}

// Mean colour (sRGB) of all leaves on a page, averaged in linear light.
Vec3f color_of_leaves(PixelMap const& page)
{
    Vec3 sum = Vec3::Zero();
    std::size_t count = 0;
    for (std::size_t i = 0; i + 3 < page.pixels.size(); i += 4) {
        if (page.pixels[i + 3] < 128)
            continue;
        ++count;
        for (std::size_t k = 0; k < 3; ++k)
            sum[static_cast<int>(k)] += exports::linear_from_srgb(page.pixels[i + k] / 255.0);
    }
    sum /= std::max<double>(1, double(count));
    return sum.unaryExpr([](double light) { return exports::srgb_from_linear(light); })
        .cast<float>();
}

// Cache of recently grown leaf sheets. It is needed because models are reloaded often while they
// are edited, and growing a sheet takes some tenths of a second.
class GrownSheets {
public:
    std::optional<std::string> find(std::string const& key)
    {
        std::lock_guard const lock(mutex_);
        auto const known = std::ranges::find(sheets_, key, &Sheet::key);
        if (known == sheets_.end())
            return std::nullopt;
        sheets_.splice(sheets_.begin(), sheets_, known);
        return known->text;
    }

    void keep(std::string const& key, std::string const& text)
    {
        std::lock_guard const lock(mutex_);
        sheets_.push_front({ key, text });
        if (sheets_.size() > kMax)
            sheets_.pop_back();
    }

private:
    static constexpr std::size_t kMax = 8; // Maximum number of cached sheets, about 2 MB each.

    struct Sheet {
        std::string key;
        std::string text;
    };

    std::mutex mutex_;
    std::list<Sheet> sheets_; // Cached sheets, the most recently used first.
};

} // namespace

CutLeaf cut_along_midrib(leaf::Cutout const& cutout, Vec2 const& stem, double blade_px, int bends)
{
    std::vector<Vec2> outline;
    for (auto const& corner : cutout.corners)
        outline.push_back(from_stem(corner, stem) / blade_px);
    CutLeaf leaf;
    leaf.corners = cut_at_midrib(outline);
    if (leaf.corners.empty())
        return {};
    auto const count = static_cast<std::uint32_t>(leaf.corners.size());
    auto const top
        = static_cast<std::uint32_t>(std::find_if(leaf.corners.begin() + 1, leaf.corners.end(),
                                                  [](Vec2 const& at) { return at.x() == 0; })
                                     - leaf.corners.begin());
    Vec2 const low = leaf.corners.front();
    Vec2 const high = leaf.corners[top];
    for (int i = 1; i <= bends; ++i)
        leaf.corners.emplace_back(0, std::lerp(low.y(), high.y(), double(i) / (bends + 1)));
    std::vector<std::uint32_t> right;
    for (std::uint32_t i = 0; i <= top; ++i)
        right.push_back(i);
    std::vector<std::uint32_t> left { 0 };
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(bends); ++i) {
        right.push_back(count + static_cast<std::uint32_t>(bends) - 1 - i);
        left.push_back(count + i);
    }
    for (std::uint32_t i = top; i < count; ++i)
        left.push_back(i);
    add_half(leaf, right);
    add_half(leaf, left);
    return leaf;
}

Result<lsystem::LeafSheet> grow_leaf_sheet(leaf::Grammar const& grammar,
                                           lsystem::LeafOrder const& order)
{
    // The maps of glTF are the first; their first two are "color" and "normal".
    auto const& maps = atlas_channels().front().maps;
    int const columns = columns_for(order.variants);
    auto color = empty_page(maps[0], columns);
    auto normal = empty_page(maps[1], columns);
    auto const damage = lsystem::parse_leaf_word(order.grammar).damage;
    lsystem::LeafSheet sheet;
    leaf::LeafPainter painter;
    for (int i = 0; i < order.variants; ++i) {
        LeafLife const life { .age = lsystem::leaf_age(order, i),
                              .seed = static_cast<std::uint64_t>(i) + 1 };
        auto const grown = TRY(grow_leaf(grammar, life));
        auto paint = paint_options(grammar, life);
        paint_damage(paint, damage_of_leaf(damage, i));
        paint.side = kCell;
        paint.stand
            = { .margin = double(kGutter) / kCell, .middle = leaf::PicturePlacement::Middle::Stem };
        leaf::PictureFrame const frame(grown.triangles, paint.side, paint.stand);
        auto const& picture = painter.paint(grown.leaf, grown.triangles, paint);
        for (auto* page : { &color, &normal })
            place_in_cell(*page, picture, i);
        auto const& outline = grammar.outline.points;
        double const blade_px = frame.scale * (outline.empty() ? 1.0 : outline.back().at.y());
        Vec2 const stem(0.5 * kCell, kCell - kGutter);
        auto leaf = cut_leaf(picture, stem, blade_px);
        if (leaf.triangles.empty())
            return fail(Fault::User,
                        fmt::format("{}: there is nothing to cut out of the leaf of "
                                    "the age {}",
                                    grammar.name, life.age));
        Vec2 const corner = kCell * Vec2(i % columns, i / columns);
        leaf.stem_in_picture = (corner + stem) / (columns * kCell);
        leaf.length_in_picture = blade_px / (columns * kCell);
        sheet.leaves.push_back(std::make_shared<CutLeaf const>(std::move(leaf)));
    }
    sheet.mean_color = color_of_leaves(color.pixels);
    sheet.color = lsystem::leaf_page(png_of(color.pixels));
    sheet.normal = lsystem::leaf_page(png_of(normal.pixels));
    return sheet;
}

Result<std::optional<std::string>> make_ordered_leaves(std::filesystem::path const& folder,
                                                       std::string const& name)
{
    auto const order = lsystem::parse_leaf_sheet_name(name);
    if (!order)
        return std::nullopt;
    auto const wanted = lsystem::parse_leaf_word(order->grammar).grammar;
    bool const is_file = std::filesystem::path(wanted).extension() == ".leaf";
    auto const path = TRY(is_file ? folder / wanted : own_leaf_path(wanted));
    auto const text = TRY(read_leaf_text(path));
    static GrownSheets grown;
    auto const key = fmt::format("{}\n{}\n{}", name, path.string(), text);
    if (auto known = grown.find(key))
        return known;
    auto const grammar = TRY(leaf::parse_grammar(text, path.string()));
    auto sheet = lsystem::print_leaf_sheet(TRY(grow_leaf_sheet(grammar, *order)));
    grown.keep(key, sheet);
    return sheet;
}

} // namespace tractus::leaf
