#include "engine/lsystem/view/surface_file.h"

#include "engine/lsystem/text/text_lines.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <fmt/core.h>
#include <map>

namespace tractus::lsystem {

namespace {

constexpr std::size_t kMaxPatches = 4096;

// A patch as parsed: its own name, the names of its neighbours, and its coordinates.
struct NamedPatch {
    std::string name;
    // Names of the neighbours, by BezierPatch::Side; "~" or empty if there is none.
    std::array<std::string, 4> neighbors;
    std::vector<double> numbers; // Coordinates of the patch's points; 48 numbers when complete.
};

struct Header {
    Vec3 contact = Vec3::Zero();
    Vec3 end = Vec3::Zero();
    Vec3 heading = Vec3::UnitY();
    Vec3 up = -Vec3::UnitZ();
    double size = 0; // Size of the surface; 0 until the header's SIZE has been read.
};

std::vector<std::string_view> words_of(std::string_view line)
{
    std::vector<std::string_view> words;
    while (true) {
        auto const begin = line.find_first_not_of(" \t");
        if (begin == std::string_view::npos)
            return words;
        line.remove_prefix(begin);
        auto const end = std::min(line.find_first_of(" \t"), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
}

class SurfaceParser {
public:
    SurfaceParser(std::string const& name, std::string_view text)
        : name_(name)
        , lines_ { text, 0 }
    {
    }

    Result<void> parse();
    Result<BezierSurface> placed(double size) const;

private:
    Result<void> header_line(std::string_view line);
    Result<void> patch_line(std::string_view line);
    Result<Vec3> labelled_vector(std::string_view line) const;
    tl::unexpected<Error> error(std::string const& what) const
    {
        return fail(Fault::User, fmt::format("{}:{}: {}", name_, lines_.number, what));
    }

    std::string const& name_;
    TextLines lines_;
    Header header_;
    std::vector<NamedPatch> patches_;
};

Result<void> SurfaceParser::parse()
{
    std::string_view line;
    while (lines_.next(line)) {
        if (line.empty())
            continue;
        if (header_.size == 0)
            TRY(header_line(line));
        else
            TRY(patch_line(line));
    }
    if (header_.size == 0)
        return error("the file ends before 'SIZE:'");
    if (patches_.empty() || patches_.back().numbers.size() != 48)
        return error("the file ends before the last patch's 16 points");
    return {};
}

// Parses the vector of a line such as "X: 0.10 Y: -1.38 Z: 0.00".
Result<Vec3> SurfaceParser::labelled_vector(std::string_view line) const
{
    std::vector<double> numbers;
    for (auto const word : words_of(line))
        if (auto const read = numbers_in(word); read.size() == 1)
            numbers.push_back(read[0]);
    if (numbers.size() != 3)
        return error("expected 'X: number Y: number Z: number'");
    return Vec3(numbers[0], numbers[1], numbers[2]);
}

Result<void> SurfaceParser::header_line(std::string_view line)
{
    auto const is = [&](std::string_view key) { return line.substr(0, key.size()) == key; };
    if (is("CONTACT POINT"))
        header_.contact = TRY(labelled_vector(line));
    else if (is("END POINT"))
        header_.end = TRY(labelled_vector(line));
    else if (is("HEADING"))
        header_.heading = TRY(labelled_vector(line));
    else if (is("UP"))
        header_.up = TRY(labelled_vector(line));
    else if (is("SIZE:")) {
        auto const size = numbers_in(after_key(line, "SIZE:"));
        if (size.size() != 1 || !(size[0] >= 1e-6))
            return error("expected 'SIZE:' and a number above 0");
        header_.size = size[0];
        Vec3 const left = header_.heading.cross(header_.up);
        if (!(left.norm() > 1e-6))
            return error("expected HEADING and UP in different directions");
    }
    // The other lines of the header (the extent, PRECISION and VERSION) are for an editor.
    return {};
}

Result<void> SurfaceParser::patch_line(std::string_view line)
{
    auto const words = words_of(line);
    auto const is = [&](std::string_view key) { return words[0] == key; };
    bool const is_inside = !patches_.empty() && patches_.back().numbers.size() < 48;
    if (is("TOP"))
        return {};
    if (is("AL:") || is("L:") || is("BL:")) {
        if (!is_inside)
            return error("expected a patch's name before its neighbours");
        for (std::size_t i = 0; i + 1 < words.size(); i += 2) {
            static constexpr std::array<std::string_view, 4> kSides { "A:", "B:", "L:", "R:" };
            auto const* const side = std::find(kSides.begin(), kSides.end(), words[i]);
            // Neighbours at corners are ignored: they are connected through the neighbours at the
            // sides.
            if (side != kSides.end())
                patches_.back().neighbors[static_cast<std::size_t>(side - kSides.begin())]
                    = words[i + 1];
        }
        return {};
    }
    if (is_inside) {
        auto const numbers = numbers_in(line);
        auto& all = patches_.back().numbers;
        if (numbers.empty() || all.size() + numbers.size() > 48)
            return error(fmt::format("found '{}', expected 16 points of three numbers", line));
        all.insert(all.end(), numbers.begin(), numbers.end());
        return {};
    }
    if (patches_.size() >= kMaxPatches)
        return error(fmt::format("expected at most {} patches", kMaxPatches));
    patches_.emplace_back();
    patches_.back().name = words[0];
    return {};
}

Result<BezierSurface> SurfaceParser::placed(double size) const
{
    double const scale = size / header_.size;
    Vec3 const heading = header_.heading.normalized();
    Vec3 const left = heading.cross(header_.up.normalized()).normalized();
    Vec3 const up = left.cross(heading);
    // The columns of cpfg's matrix are these vectors, left, heading and up, which are also the axes
    // of cpfg's own frame.
    auto const place = [&](Vec3 const& point) -> Vec3 {
        Vec3 const offset = scale * (point - header_.contact);
        Vec3 const turned = offset.x() * left + offset.y() * heading + offset.z() * up;
        return { -turned.x(), turned.y(), -turned.z() };
    };
    std::map<std::string, std::uint16_t> by_name;
    for (std::size_t i = 0; i < patches_.size(); ++i)
        by_name.emplace(patches_[i].name, static_cast<std::uint16_t>(i));
    BezierSurface surface;
    surface.end_point = place(header_.end);
    for (auto const& named : patches_) {
        BezierPatch patch;
        for (std::size_t i = 0; i < 16; ++i)
            patch.control[i] = place(
                { named.numbers[3 * i], named.numbers[3 * i + 1], named.numbers[3 * i + 2] });
        for (std::size_t side = 0; side < 4; ++side)
            if (auto const found = by_name.find(named.neighbors[side]); found != by_name.end())
                patch.neighbors[side] = found->second;
        surface.patches.push_back(patch);
    }
    return surface;
}

} // namespace

Result<BezierSurface> parse_surface(std::string const& name, std::string_view text, double size)
{
    SurfaceParser parser(name, text);
    TRY(parser.parse());
    return parser.placed(size);
}

} // namespace tractus::lsystem
