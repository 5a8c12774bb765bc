#include "engine/lsystem/view/leaf_sheet.h"

#include "engine/base/base64.h"
#include "engine/lsystem/text/text_lines.h"
#include "engine/lsystem/view/view_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <utility>

namespace tractus::lsystem {

namespace {

constexpr std::string_view kEnding = ".leaf-sheet";
constexpr std::size_t kMaxLeaves = 64;
constexpr std::size_t kMaxCorners = 64;

// Reads lines of numbers that begin with a keyword. The first number is the number of corners of a
// leaf.
class SheetReader {
public:
    SheetReader(std::string const& name, std::string_view text)
        : name_(name)
        , lines_ { text }
    {
    }

    Result<LeafSheet> read()
    {
        LeafSheet sheet;
        auto const color = TRY(numbers("mean", 3));
        sheet.mean_color = Vec3(color[0], color[1], color[2]).cwiseMax(0).cwiseMin(1).cast<float>();
        sheet.color = leaf_page(TRY(picture("color")));
        sheet.normal = leaf_page(TRY(picture("normal")));
        auto const count = TRY(numbers("leaves", 1))[0];
        if (!(count >= 1 && count <= double(kMaxLeaves)))
            return error("expected 1 to 64 leaves");
        for (int i = 0; i < static_cast<int>(count); ++i)
            sheet.leaves.push_back(std::make_shared<CutLeaf const>(TRY(leaf(i))));
        return sheet;
    }

private:
    tl::unexpected<Error> error(std::string const& what) const
    {
        return fail(Fault::User, fmt::format("{}:{}: {}", name_, lines_.number, what));
    }

    Result<std::string_view> after(std::string_view key)
    {
        std::string_view line;
        if (!lines_.next(line) || words(line).empty() || words(line)[0] != key)
            return error(fmt::format("expected '{}'", key));
        return after_key(line, key);
    }

    Result<std::vector<double>> numbers(std::string_view key, std::size_t count)
    {
        auto values = numbers_in(TRY(after(key)));
        if (values.size() != count)
            return error(fmt::format("expected {} numbers behind '{}'", count, key));
        return values;
    }

    Result<std::string> picture(std::string_view key)
    {
        auto bytes = from_base64(TRY(after(key)));
        if (!bytes || bytes->substr(0, 4) != "\x89PNG")
            return error(fmt::format("expected a PNG file in base 64 behind '{}'", key));
        return *std::move(bytes);
    }

    Result<CutLeaf> leaf(int place)
    {
        auto const head = TRY(numbers("leaf", 5));
        if (!(head[0] >= 3 && head[0] <= double(kMaxCorners) && head[1] >= 1
              && head[1] <= double(kMaxCorners)))
            return error("expected 3 to 64 corners and 1 to 64 triangles");
        CutLeaf leaf;
        leaf.sheet = name_;
        leaf.number = place;
        leaf.stem_in_picture = { head[2], head[3] };
        leaf.length_in_picture = head[4];
        for (int i = 0; i < static_cast<int>(head[0]); ++i) {
            auto const at = TRY(numbers("corner", 2));
            leaf.corners.emplace_back(at[0], at[1]);
        }
        for (int i = 0; i < static_cast<int>(head[1]); ++i) {
            auto const corners = TRY(numbers("triangle", 3));
            for (auto const corner : corners)
                if (!(corner >= 0 && corner < double(leaf.corners.size())))
                    return error("a triangle names a corner that the leaf has not");
            leaf.triangles.push_back({ static_cast<std::uint32_t>(corners[0]),
                                       static_cast<std::uint32_t>(corners[1]),
                                       static_cast<std::uint32_t>(corners[2]) });
        }
        if (!(box_of(leaf).max().y() > 1e-6))
            return error("the leaf has no length");
        return leaf;
    }

    std::string const& name_;
    TextLines lines_;
};

} // namespace

double leaf_age(LeafOrder const& order, int number)
{
    if (order.spread <= 0)
        return order.age;
    // Multiples of the golden ratio, modulo 1, fill the range evenly for any number of leaves. The
    // inverse of the logistic distribution function, which is within 0.01 of the normal one, turns
    // them into deviations that are almost normally distributed.
    constexpr double kGolden = 0.6180339887498949;
    constexpr double kLogistic = 1.702;
    constexpr double kYoungest = 0.02;
    double const turned = (number + 0.5) * kGolden;
    double const share = std::clamp(turned - std::floor(turned), 0.01, 0.99);
    double const deviation = std::log(share / (1 - share)) / kLogistic;
    return std::clamp(order.age + order.spread * deviation, kYoungest, 1.0);
}

TextureSlot leaf_page(std::string png)
{
    return std::make_shared<TexturePicture const>(
        TexturePicture { .bytes = std::move(png), .edges = TexturePicture::Edges::Clamp });
}

MaterialTextures leaf_textures(LeafSheet const& sheet)
{
    return { .base_color = sheet.color,
             .normal = sheet.normal,
             .alpha = MaterialTextures::Alpha::Mask,
             .color = MaterialTextures::Color::Replaced };
}

// Returns the length of an organ's blade, which is kept when a grown leaf replaces the shape.
static double blade_length_mm(OrganShape const& organ)
{
    double const tip = organ.cut ? box_of(*organ.cut).max().y() : 1;
    return std::max((organ.length_mm - organ.petiole_mm) / std::max(tip, 1e-6), 1e-6);
}

OrganShape leaf_shape(OrganShape const& organ, std::shared_ptr<CutLeaf const> leaf)
{
    double const blade_mm = blade_length_mm(organ);
    auto const box = box_of(*leaf);
    OrganShape shape = organ;
    shape.kind = OrganShape::Kind::Leaf;
    shape.length_mm = blade_mm * box.max().y();
    shape.width_mm = blade_mm * box.sizes().x();
    shape.petiole_mm = 0;
    shape.patches.clear();
    shape.cut = std::move(leaf);
    return shape;
}

std::string leaf_sheet_name(LeafOrder const& order)
{
    auto name = fmt::format("{} {} {}", order.grammar, order.variants, order.age);
    if (order.spread > 0)
        name += fmt::format(" {}", order.spread);
    return name.append(kEnding);
}

std::optional<LeafOrder> parse_leaf_sheet_name(std::string_view name)
{
    if (!name.ends_with(kEnding))
        return std::nullopt;
    name.remove_suffix(kEnding.size());
    auto const parts = words(name, " ");
    if (parts.size() != 3 && parts.size() != 4)
        return std::nullopt;
    auto const variants = number(parts[1]);
    auto const age = number(parts[2]);
    auto const spread = parts.size() == 4 ? number(parts[3]) : 0;
    auto const is_share = [](std::optional<double> value) { return value >= 0.0 && value <= 1.0; };
    if (!variants || !is_share(age) || !is_share(spread)
        || !(*variants >= 1 && *variants <= double(kMaxLeaves)))
        return std::nullopt;
    return LeafOrder { std::string(parts[0]), static_cast<int>(*variants), *age, *spread };
}

std::string print_leaf_sheet(LeafSheet const& sheet)
{
    std::string text
        = fmt::format("mean {} {} {}\ncolor {}\nnormal {}\nleaves {}\n", sheet.mean_color.x(),
                      sheet.mean_color.y(), sheet.mean_color.z(), base64(sheet.color->bytes),
                      base64(sheet.normal->bytes), sheet.leaves.size());
    for (auto const& leaf : sheet.leaves) {
        text += fmt::format("leaf {} {} {} {} {}\n", leaf->corners.size(), leaf->triangles.size(),
                            leaf->stem_in_picture.x(), leaf->stem_in_picture.y(),
                            leaf->length_in_picture);
        for (auto const& corner : leaf->corners)
            text += fmt::format("corner {} {}\n", corner.x(), corner.y());
        for (auto const& [a, b, c] : leaf->triangles)
            text += fmt::format("triangle {} {} {}\n", a, b, c);
    }
    return text;
}

Result<LeafSheet> parse_leaf_sheet(std::string const& name, std::string_view text)
{
    return SheetReader(name, text).read();
}

} // namespace tractus::lsystem
