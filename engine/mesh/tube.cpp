#include "engine/mesh/tube.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus {
namespace {

constexpr int kMaxSides = 64;
constexpr double kSteepest = 4; // Slopes beyond this come from sections that nearly coincide.

// The corners of a regular polygon, the first repeated at the end, and the middles of its sides.
struct Circle {
    std::array<Vec2f, kMaxSides + 1> corners;
    std::array<Vec2f, kMaxSides> middles;
};

Circle make_circle(int sides)
{
    Circle circle {};
    for (int j = 0; j < sides; ++j) {
        double const corner = 2 * kPi * j / sides;
        double const middle = 2 * kPi * (j + 0.5) / sides;
        circle.corners[static_cast<std::size_t>(j)]
            = Vec2(std::cos(corner), std::sin(corner)).cast<float>();
        circle.middles[static_cast<std::size_t>(j)]
            = Vec2(std::cos(middle), std::sin(middle)).cast<float>();
    }
    circle.corners[static_cast<std::size_t>(sides)] = circle.corners[0];
    return circle;
}

Circle const& circle_of(int sides)
{
    static auto const circles = [] {
        std::vector<Circle> all(kMaxSides + 1);
        for (int n = 1; n <= kMaxSides; ++n)
            all[static_cast<std::size_t>(n)] = make_circle(n);
        return all;
    }();
    return circles[static_cast<std::size_t>(sides)];
}

// Rings of a dome between the end of the tube and its apex; thin tubes do without.
int dome_rings(int sides)
{
    return sides <= 6 ? 0 : sides <= 12 ? 1 : 2;
}

double slope_at(std::vector<SpineStation> const& stations, std::size_t i)
{
    auto const& before = stations[i == 0 ? 0 : i - 1];
    auto const& after = stations[std::min(i + 1, stations.size() - 1)];
    double const length = after.arc_mm - before.arc_mm;
    if (!(length > 0))
        return 0;
    return std::clamp((after.radius_mm - before.radius_mm) / length, -kSteepest, kSteepest);
}

// The smallest rotation that takes the unit vector `from` to `to`, applied to a normal of `from`.
Vec3 carry(Vec3 const& normal, Vec3 const& from, Vec3 const& to)
{
    double const cosine = from.dot(to);
    Vec3 const carried = normal - (to.dot(normal) / std::max(1e-9, 1 + cosine)) * (from + to);
    Vec3 const flat = carried - to * to.dot(carried);
    double const length = flat.norm();
    return length > 1e-6 ? Vec3(flat / length) : to.unitOrthogonal();
}

// Appends to a surface's arrays at a place of its own.
class Writer {
public:
    Writer(TriangleMesh& mesh, MeshExtent const& at, int sides)
        : position_(mesh.positions_mm.data() + at.vertices)
        , normal_(mesh.normals.data() + at.vertices)
        , texture_(mesh.texture_coordinates.data() + at.vertices)
        , index_(mesh.indices.data() + at.indices)
        , next_(static_cast<std::uint32_t>(at.vertices))
        , sides_(static_cast<std::uint32_t>(sides))
        , circle_(circle_of(sides))
    {
    }

    // A closed ring whose first corner comes twice, for the texture's seam.
    void ring(Section const& section)
    {
        float const scale = 1 / std::sqrt(1 + section.slope * section.slope);
        Vec3f const lean = -section.slope * scale * section.tangent;
        float const step = 1 / static_cast<float>(sides_);
        for (std::uint32_t j = 0; j <= sides_; ++j) {
            Vec3f const out = circle_.corners[j].x() * section.normal
                + circle_.corners[j].y() * section.binormal;
            *position_++ = section.center_mm + section.radius_mm * out;
            *normal_++ = scale * out + lean;
            *texture_++ = { static_cast<float>(j) * step, section.v };
        }
        next_ += sides_ + 1;
    }

    // Two triangles a side between the last two rings.
    void join()
    {
        auto const upper = next_ - (sides_ + 1);
        auto const lower = upper - (sides_ + 1);
        for (std::uint32_t j = 0; j < sides_; ++j) {
            std::uint32_t const quad[6]
                = { lower + j, lower + j + 1, upper + j + 1, lower + j, upper + j + 1, upper + j };
            index_ = std::copy(quad, quad + 6, index_);
        }
    }

    // A point above the last ring, once for each side, so that each has its texture. A positive
    // slope share of the sides stays in the normals: a cone's; 0 is a dome's.
    void apex(Section const& section, float side_share)
    {
        auto const ring = next_ - (sides_ + 1);
        float const step = 1 / static_cast<float>(sides_);
        for (std::uint32_t j = 0; j < sides_; ++j) {
            Vec3f const out = circle_.middles[j].x() * section.normal
                + circle_.middles[j].y() * section.binormal;
            *position_++ = section.center_mm;
            *normal_++ = (side_share * (out - section.slope * section.tangent)
                          + (1 - side_share) * section.tangent)
                             .normalized();
            *texture_++ = { (static_cast<float>(j) + 0.5f) * step, section.v };
            std::uint32_t const triangle[3] = { ring + j, ring + j + 1, next_ + j };
            index_ = std::copy(triangle, triangle + 3, index_);
        }
        next_ += sides_;
    }

    // A flat face that looks back along the axis.
    void base(Section const& section)
    {
        for (std::uint32_t j = 0; j < sides_; ++j) {
            Vec2f const& corner = circle_.corners[j];
            *position_++ = section.center_mm
                + section.radius_mm * (corner.x() * section.normal + corner.y() * section.binormal);
            *normal_++ = -section.tangent;
            *texture_++ = Vec2f(0.5f, section.v) + corner / static_cast<float>(2 * kPi);
        }
        for (std::uint32_t j = 2; j < sides_; ++j) {
            std::uint32_t const triangle[3] = { next_, next_ + j, next_ + j - 1 };
            index_ = std::copy(triangle, triangle + 3, index_);
        }
        next_ += sides_;
    }

private:
    Vec3f* position_;
    Vec3f* normal_;
    Vec2f* texture_;
    std::uint32_t* index_;
    std::uint32_t next_;
    std::uint32_t sides_;
    Circle const& circle_;
};

// Half a sphere on the last section. It meets the tube at a right angle, whatever the tube's slope:
// the last ring's normals stay the tube's, so that no edge shows.
void write_dome(Writer& writer, Section const& end, int rings)
{
    auto const at = [&](double angle) {
        Section section = end;
        auto const height = static_cast<float>(std::sin(angle));
        section.radius_mm = end.radius_mm * static_cast<float>(std::cos(angle));
        section.center_mm += height * end.radius_mm * end.tangent;
        section.slope = static_cast<float>(-std::tan(std::min(angle, 1.3)));
        section.v += static_cast<float>(angle / (2 * kPi));
        return section;
    };
    for (int k = 1; k <= rings; ++k) {
        writer.ring(at(0.5 * kPi * k / (rings + 1)));
        writer.join();
    }
    writer.apex(at(0.5 * kPi), 0);
}

} // namespace

void frame_sections(Spine const& spine, std::vector<Section>& sections)
{
    auto const& stations = spine.stations;
    sections.resize(stations.size());
    Vec3 normal = carry(Vec3::UnitX(), Vec3::UnitZ(), stations[0].tangent);
    double v = 0;
    for (std::size_t i = 0; i < stations.size(); ++i) {
        auto const& station = stations[i];
        if (i > 0) {
            auto const& before = stations[i - 1];
            normal = carry(normal, before.tangent, station.tangent);
            v += (station.arc_mm - before.arc_mm) / (kPi * (station.radius_mm + before.radius_mm));
        }
        sections[i] = { station.center_mm.cast<float>(),
                        normal.cast<float>(),
                        station.tangent.cross(normal).cast<float>(),
                        station.tangent.cast<float>(),
                        static_cast<float>(station.radius_mm),
                        static_cast<float>(slope_at(stations, i)),
                        static_cast<float>(v) };
    }
}

MeshExtent tube_extent(Spine const& spine, TubePart const& part)
{
    auto const sides = static_cast<std::size_t>(spine.sides);
    bool const is_tip = part.last + 1 == spine.stations.size();
    std::size_t rings = part.last - part.first + 1;
    if (is_tip)
        rings += spine.pointed ? static_cast<std::size_t>(-1)
                               : static_cast<std::size_t>(dome_rings(spine.sides));
    MeshExtent extent { rings * (sides + 1), (rings - 1) * sides * 6 };
    if (is_tip) {
        extent.vertices += sides;
        extent.indices += sides * 3;
    }
    if (part.first == 0 && spine.closed_base) {
        extent.vertices += sides;
        extent.indices += (sides - 2) * 3;
    }
    return extent;
}

void write_tube(Spine const& spine, std::span<Section const> sections, TubePart const& part,
                MeshExtent const& at, TriangleMesh& mesh)
{
    Writer writer(mesh, at, spine.sides);
    if (part.first == 0 && spine.closed_base)
        writer.base(sections[0]);
    bool const is_tip = part.last + 1 == sections.size();
    std::size_t const last_ring = is_tip && spine.pointed ? part.last - 1 : part.last;
    writer.ring(sections[part.first]);
    for (std::size_t i = part.first + 1; i <= last_ring; ++i) {
        writer.ring(sections[i]);
        writer.join();
    }
    if (!is_tip)
        return;
    if (spine.pointed)
        writer.apex(sections[part.last], 1);
    else
        write_dome(writer, sections[part.last], dome_rings(spine.sides));
}

} // namespace tractus
