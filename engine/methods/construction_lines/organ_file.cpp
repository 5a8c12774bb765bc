#include "engine/methods/construction_lines/organ_file.h"

#include "engine/base/base64.h"
#include "engine/lsystem/view/view_texture.h"
#include "engine/stroke/resample.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <span>
#include <sstream>
#include <vector>

namespace tractus::lines {

namespace {

constexpr std::string_view kFirstLine = "tractus-organ 1";
constexpr std::size_t kMaxPoints = 2000; // Maximum number of points of a line.

// The lines of a leaf in its file, in the order in which they are written.
struct NamedLine {
    char const* name;
    std::vector<Vec2> OrganViews::*points;
};
constexpr std::array<NamedLine, 4> kLines { { { "left", &OrganViews::left },
                                              { "right", &OrganViews::right },
                                              { "midrib", &OrganViews::midrib },
                                              { "section", &OrganViews::section } } };

std::vector<std::string> words_of(std::string line)
{
    line.erase(std::min(line.find("--"), line.size()));
    std::istringstream in(line);
    std::vector<std::string> words;
    for (std::string word; in >> word;)
        words.push_back(word);
    return words;
}

// Resamples a line evenly and rounds to a thousandth of a millimetre.
std::vector<Vec2> even_points(std::vector<Vec2> const& line, std::size_t count)
{
    std::vector<Vec3> points;
    for (auto const& point : line)
        points.emplace_back(point.x(), point.y(), 0);
    std::vector<Vec2> even;
    auto const rounded = [](double at_mm) { return std::round(1000 * at_mm) / 1000; };
    for (auto const& point : resample(points, count))
        even.emplace_back(rounded(point.x()), rounded(point.y()));
    return even;
}

Result<std::vector<Vec2>> read_points(std::span<std::string const> numbers)
{
    std::vector<Vec2> points;
    if (numbers.size() % 2 != 0 || numbers.size() < 4 || numbers.size() > 2 * kMaxPoints)
        return fail(Fault::User,
                    fmt::format("it has {} numbers: give pairs of right and up for 2 to {} points",
                                numbers.size(), kMaxPoints));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        auto const& word = numbers[i];
        double value = 0;
        auto const read = std::from_chars(word.data(), word.data() + word.size(), value);
        constexpr double kFarthest_mm = 10'000;
        if (read.ec != std::errc() || read.ptr != word.data() + word.size()
            || !(std::fabs(value) <= kFarthest_mm))
            return fail(Fault::User,
                        fmt::format("\"{}\" is no place: give millimetres from -10000 to 10000",
                                    word.substr(0, 40)));
        if (i % 2 == 0)
            points.emplace_back(value, 0);
        else
            points.back().y() = value;
    }
    return points;
}

Result<std::shared_ptr<std::string const>> read_picture(std::string const& text)
{
    auto const png = from_base64(text);
    if (!png)
        return fail(Fault::User, "the picture is no PNG file in base 64: leave the line out");
    Material shown;
    TRY(lsystem::put_texture(shown, *png));
    return std::make_shared<std::string const>(*png);
}

Result<void> read_line(std::vector<std::string> const& words, OrganFile& organ)
{
    if (words.front() == "color") {
        organ.color = TRY(parse_color(words.size() == 2 ? words[1] : ""));
        return {};
    }
    if (words.front() == "picture") {
        organ.picture = TRY(read_picture(words.size() == 2 ? words[1] : ""));
        return {};
    }
    for (auto const& [name, points] : kLines)
        if (words.front() == name) {
            if (!(organ.views.*points).empty())
                return fail(Fault::User, "there is such a line above already: leave one out");
            organ.views.*points = TRY(read_points(std::span(words).subspan(1)));
            return {};
        }
    return fail(Fault::User,
                fmt::format("\"{}\" is no part of a leaf: give left, right, midrib, section, "
                            "color or picture",
                            words.front().substr(0, 40)));
}

} // namespace

Result<Vec3> parse_color(std::string_view text)
{
    unsigned int number = 0;
    auto const* const end = text.data() + text.size();
    bool const is_color = text.size() == 7 && text.front() == '#'
        && std::from_chars(text.data() + 1, end, number, 16).ptr == end;
    if (!is_color)
        return fail(Fault::User,
                    "color of the organ is no colour: give \"#rrggbb\", such as \"#c05080\"");
    auto const part = [&](int shift) { return ((number >> shift) & 0xff) / 255.0; };
    return Vec3(part(16), part(8), part(0));
}

Result<OrganFile> parse_organ(std::string_view text, std::string const& name)
{
    OrganFile organ;
    std::istringstream in { std::string(text) };
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        auto const words = words_of(line);
        auto const about = [&](std::string const& message) {
            return fail(Fault::User, fmt::format("{}:{}: {}", name, number, message));
        };
        if (number == 1 && fmt::format("{}", fmt::join(words, " ")) != kFirstLine)
            return about(
                fmt::format("it is no leaf in three views: its first line is \"{}\"", kFirstLine));
        if (number == 1 || words.empty())
            continue;
        if (auto const read = read_line(words, organ); !read)
            return about(read.error().message);
    }
    auto const surface = surface_of(organ);
    if (!surface)
        return fail(surface.error().fault, fmt::format("{}: {}", name, surface.error().message));
    if (!has_breadth(organ.views))
        return fail(Fault::User,
                    fmt::format("{}: the leaf would have no breadth: let its edge be a bow from "
                                "base to tip",
                                name));
    return organ;
}

Result<OrganSurface> surface_of(OrganFile const& organ)
{
    return OrganSurface { .patches = TRY(organ_surface(organ.views)),
                          .color = organ.color,
                          .picture = organ.picture };
}

std::string print_organ(OrganFile const& organ)
{
    auto text = fmt::format("{}\n", kFirstLine);
    if (organ.color) {
        auto const part = [](double share) {
            return static_cast<int>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
        };
        auto const& color = *organ.color;
        text += fmt::format("color #{:02x}{:02x}{:02x}\n", part(color.x()), part(color.y()),
                            part(color.z()));
    }
    for (auto const& [name, points] : kLines) {
        if ((organ.views.*points).empty())
            continue;
        text += name;
        for (auto const& point : organ.views.*points)
            text += fmt::format("  {} {}", point.x() + 0.0, point.y() + 0.0);
        text += '\n';
    }
    if (organ.picture)
        text += fmt::format("picture {}\n", base64(*organ.picture));
    return text;
}

Result<OrganFile> organ_file(SketchOrgan const& organ)
{
    // Number of points of a line in the file: four per patch of the surface along the leaf.
    constexpr std::size_t kPoints = 4 * kAlong + 1;
    OrganFile file { .views = TRY(views_of(organ)) };
    if (organ.color == OrganColor::Picture)
        file.picture = organ.picture;
    else if (organ.color != OrganColor::Leaf)
        file.color = rgb_of(organ.color);
    auto& views = file.views;
    Vec2 const base = (views.left.front() + views.right.front()) / 2;
    for (auto* const side : { &views.left, &views.right })
        for (auto& point : *side)
            point -= base;
    for (auto const& [name, points] : kLines)
        if (!(views.*points).empty())
            views.*points = even_points(views.*points, kPoints);
    return file;
}

} // namespace tractus::lines
