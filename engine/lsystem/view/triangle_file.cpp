#include "engine/lsystem/view/triangle_file.h"

#include "engine/lsystem/text/text_lines.h"
#include "engine/lsystem/view/view_reader.h"

#include <cmath>
#include <fmt/core.h>

namespace tractus::lsystem {

namespace {

constexpr std::string_view kBetweenNumbers = " \t,:";
constexpr std::size_t kMaxTriangles = 20'000;

using Triangle = std::array<Vec3, 3>;

// Makes a degenerate patch of a triangle. Each row of the patch ends at the third vertex; the first
// row begins at the first vertex, the last row at the second.
BezierPatch patch_of(Triangle const& triangle)
{
    BezierPatch patch;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 4; ++k) {
            double const s = static_cast<double>(i) / 3;
            double const t = static_cast<double>(k) / 3;
            Vec3 const begin = (1 - s) * triangle[0] + s * triangle[1];
            patch.control[4 * i + k] = (1 - t) * begin + t * triangle[2];
        }
    return patch;
}

class TriangleParser {
public:
    TriangleParser(std::string const& name, std::string_view text, double size)
        : name_(name)
        , lines_ { text }
        , size_(size)
    {
    }

    Result<BezierSurface> parse()
    {
        for (std::string_view line; lines_.next(line);) {
            auto parts = words(line, kBetweenNumbers);
            if (vertex_ == 3 && !parts.empty() && parts[0].substr(0, 8) == "triangle") {
                vertex_ = 0;
                parts.erase(parts.begin());
            }
            if (vertex_ < 3 && !parts.empty())
                TRY(add_vertex(parts));
        }
        if (vertex_ < 3)
            return error("the file ends before the triangle's last vertex");
        if (surface_.patches.empty())
            return error("found no triangle");
        return surface_;
    }

private:
    tl::unexpected<Error> error(std::string const& what) const
    {
        return fail(Fault::User, fmt::format("{}:{}: {}", name_, lines_.number, what));
    }

    Result<void> add_vertex(std::vector<std::string_view> const& parts)
    {
        Vec3 position;
        for (std::size_t i = 0; i < 3; ++i) {
            auto const value = i < parts.size() ? number(parts[i]) : std::nullopt;
            if (!value || std::abs(*value) > 1e6)
                return error("expected a vertex: three coordinates, at most 1e6");
            position[static_cast<int>(i)] = *value * size_;
        }
        // Converts coordinates along the turtle's left, its heading and cpfg's up to the organ's
        // frame.
        triangle_[vertex_++] = { -position.x(), position.y(), -position.z() };
        if (vertex_ < 3)
            return {};
        if (surface_.patches.size() == kMaxTriangles)
            return error(fmt::format("found more than {} triangles", kMaxTriangles));
        surface_.patches.push_back(patch_of(triangle_));
        return {};
    }

    std::string const& name_;
    TextLines lines_;
    double size_;
    Triangle triangle_;
    std::size_t vertex_ = 3; // Index of the next vertex of the triangle; 3 between triangles.
    BezierSurface surface_;
};

} // namespace

Result<BezierSurface> parse_triangle_surface(std::string const& name, std::string_view text,
                                             double size)
{
    return TriangleParser(name, text, size).parse();
}

} // namespace tractus::lsystem
