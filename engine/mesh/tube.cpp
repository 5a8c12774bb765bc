#include "engine/mesh/tube.h"

#include "engine/mesh/tube_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus::mesh {
namespace {

constexpr int kMaxSides = 64;
// Maximum slope of a tube's radius. Steeper slopes come from sections that nearly coincide, and are
// limited to this value.
constexpr double kSteepest = 4;

// Twelve floats: four points, or three SIMD vectors.
constexpr int kLanes = 12;
using Lanes = Eigen::Array<float, kLanes, 1>;

// Tables for all rings with the same number of sides. The first corner is repeated as the last.
struct Circle {
    // Cosine and sine of each corner's angle, each value three times, for x, y and z.
    std::array<float, 3 * (kMaxSides + 1)> cosines;
    std::array<float, 3 * (kMaxSides + 1)> sines;
    // Position of each corner as a share of the circumference.
    std::array<float, kMaxSides + 1> shares;
    std::array<Vec2f, kMaxSides> middles; // Direction of the middle of each side.
    // Vertex indices of two triangles per side, relative to the first corner of the lower ring.
    std::array<std::uint32_t, 6 * kMaxSides> quads;
};

Circle make_circle(int sides)
{
    Circle circle {};
    auto const count = static_cast<std::size_t>(sides);
    for (std::size_t j = 0; j <= count; ++j) {
        double const angle = 2 * kPi * static_cast<double>(j % count) / sides;
        std::fill_n(&circle.cosines[3 * j], 3, static_cast<float>(std::cos(angle)));
        std::fill_n(&circle.sines[3 * j], 3, static_cast<float>(std::sin(angle)));
        circle.shares[j] = static_cast<float>(j) / static_cast<float>(sides);
    }
    for (std::uint32_t j = 0; j < count; ++j) {
        double const middle = 2 * kPi * (j + 0.5) / sides;
        circle.middles[j] = Vec2(std::cos(middle), std::sin(middle)).cast<float>();
        auto const upper = static_cast<std::uint32_t>(count + 1);
        std::uint32_t const quad[6] = { j, j + 1, upper + j + 1, j, upper + j + 1, upper + j };
        std::copy(quad, quad + 6, &circle.quads[6 * std::size_t { j }]);
    }
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

// Returns the point repeated four times.
Lanes repeated(Vec3f const& point)
{
    return point.replicate<kLanes / 3, 1>();
}

// Writes center + cosine * x + sine * y for the first `count` corners of a circle.
void write_corners(Circle const& circle, std::size_t count, Vec3f const& center, Vec3f const& x,
                   Vec3f const& y, float* to)
{
    Lanes const centers = repeated(center);
    Lanes const xs = repeated(x);
    Lanes const ys = repeated(y);
    std::size_t i = 0;
    for (; i + kLanes <= 3 * count; i += kLanes)
        Eigen::Map<Lanes>(to + i) = centers + Eigen::Map<Lanes const>(&circle.cosines[i]) * xs
            + Eigen::Map<Lanes const>(&circle.sines[i]) * ys;
    for (std::size_t k = 0; i < 3 * count; ++i, ++k)
        to[i] = centers[static_cast<Eigen::Index>(k)]
            + circle.cosines[i] * xs[static_cast<Eigen::Index>(k)]
            + circle.sines[i] * ys[static_cast<Eigen::Index>(k)];
}

// Maximum number of rings of a dome between the end of its tube and its apex. dome_rings() returns
// the number for a tube with `sides` sides.
constexpr int kMaxDomeRings = 2;
int dome_rings(int sides)
{
    return sides <= 6 ? 0 : sides <= 12 ? 1 : kMaxDomeRings;
}

double slope_at(std::span<SpineStation const> stations, std::size_t i)
{
    auto const& before = stations[i == 0 ? 0 : i - 1];
    auto const& after = stations[std::min(i + 1, stations.size() - 1)];
    double const length = after.arc_mm - before.arc_mm;
    if (!(length > 0))
        return 0;
    return std::clamp((after.radius_mm - before.radius_mm) / length, -kSteepest, kSteepest);
}

// Parallel transport: returns `normal`, rotated by the smallest rotation from `from` to `to`. All
// are unit vectors; `normal` is orthogonal to `from`.
Vec3 carry(Vec3 const& normal, Vec3 const& from, Vec3 const& to)
{
    double const w = 1 + from.dot(to);
    if (w < 1e-6) [[unlikely]] // The direction is reversed, so any normal will do.
        return to.unitOrthogonal();
    Vec3 const carried = normal - (to.dot(normal) / w) * (from + to);
    Vec3 const flat = carried - to * to.dot(carried);
    // Normalises the length, which is 1 up to rounding errors.
    return flat * (1.5 - 0.5 * flat.squaredNorm());
}

// Writes the rings and ends of a tube in sequence.
class Writer {
public:
    Writer(TrianglePlace& place, Spine const& spine)
        : place_(place)
        , ridges_(spine.ridges)
        , sides_(static_cast<std::uint32_t>(spine.sides))
        , circle_(circle_of(spine.sides))
    {
    }

    // Writes a closed ring whose first corner is duplicated for the texture seam.
    void ring(Section const& section)
    {
        std::size_t const count = sides_ + 1;
        write_corners(circle_, count, section.center_mm, section.radius_mm * section.normal,
                      section.radius_mm * section.binormal, place_.position_mm->data());
        float const scale = 1 / std::sqrt(1 + section.slope * section.slope);
        write_corners(circle_, count, -section.slope * scale * section.tangent,
                      scale * section.normal, scale * section.binormal, place_.normal->data());
        if (section.ridge > 0)
            add_ridges(ridges_, section, count, place_.position_mm, place_.normal);
        float* const texture = place_.texture->data();
        for (std::size_t j = 0; j < count; ++j) {
            texture[2 * j] = circle_.shares[j];
            texture[2 * j + 1] = section.v;
        }
        advance(count);
    }

    // Joins the last two rings with two triangles per side.
    void join()
    {
        auto const lower = place_.vertex - 2 * (sides_ + 1);
        std::uint32_t* const index = place_.index;
        for (std::size_t i = 0; i < 6 * std::size_t { sides_ }; ++i)
            index[i] = lower + circle_.quads[i];
        place_.index += 6 * std::size_t { sides_ };
    }

    // Writes an apex above the last ring. It has one vertex per side, so that each side has its own
    // texture coordinates. `side_share`: weight of the side's direction in the normals, 1 for a
    // cone, 0 for a dome.
    void apex(Section const& section, float side_share)
    {
        auto const ring = place_.vertex - (sides_ + 1);
        float const scale = side_share / std::sqrt(1 + section.slope * section.slope);
        Vec3f const along = (1 - side_share - section.slope * scale) * section.tangent;
        float const step = 1 / static_cast<float>(sides_);
        for (std::uint32_t j = 0; j < sides_; ++j) {
            place_.position_mm[j] = section.center_mm;
            place_.normal[j] = scale
                    * (circle_.middles[j].x() * section.normal
                       + circle_.middles[j].y() * section.binormal)
                + along;
            place_.texture[j] = { (static_cast<float>(j) + 0.5f) * step, section.v };
            triangle(ring + j, ring + j + 1, place_.vertex + j);
        }
        advance(sides_);
    }

    // Writes the flat cap of a tube's base, which faces backwards along the axis.
    void base(Section const& section)
    {
        write_corners(circle_, sides_, section.center_mm, section.radius_mm * section.normal,
                      section.radius_mm * section.binormal, place_.position_mm->data());
        if (section.ridge > 0)
            add_ridges(ridges_, section, sides_, place_.position_mm, nullptr);
        for (std::uint32_t j = 0; j < sides_; ++j) {
            Vec2f const corner(circle_.cosines[3 * j], circle_.sines[3 * j]);
            place_.normal[j] = -section.tangent;
            place_.texture[j] = Vec2f(0.5f, section.v) + corner / static_cast<float>(2 * kPi);
        }
        if (ridges_.count > 0) {
            place_.position_mm[sides_] = section.center_mm;
            place_.normal[sides_] = -section.tangent;
            place_.texture[sides_] = { 0.5f, section.v };
            for (std::uint32_t j = 0; j < sides_; ++j)
                triangle(place_.vertex + sides_, place_.vertex + (j + 1) % sides_,
                         place_.vertex + j);
            advance(std::size_t { sides_ } + 1);
            return;
        }
        for (std::uint32_t j = 2; j < sides_; ++j)
            triangle(place_.vertex, place_.vertex + j, place_.vertex + j - 1);
        advance(sides_);
    }

private:
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        *place_.index++ = a;
        *place_.index++ = b;
        *place_.index++ = c;
    }

    void advance(std::size_t count)
    {
        place_.position_mm += count;
        place_.normal += count;
        place_.texture += count;
        place_.vertex += static_cast<std::uint32_t>(count);
    }

    TrianglePlace& place_;
    Ridges const& ridges_;
    std::uint32_t sides_;
    Circle const& circle_;
};

// A ring of a dome of unit radius, relative to the dome's foot.
struct DomeStep {
    float height;
    float radius;
    float slope;
    float v; // Difference of the texture coordinate v from the dome's foot.
};

// Returns a dome's ring at `share` of the quarter circle from the dome's foot to its apex.
DomeStep dome_step(double share)
{
    double const angle = 0.5 * kPi * share;
    return { static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)),
             static_cast<float>(-std::tan(std::min(angle, 1.3))),
             static_cast<float>(angle / (2 * kPi)) };
}

// Writes a hemisphere on the last section. If the tube tapers, the hemisphere meets it at an angle.
// No edge is visible, though, since the normals of the last ring stay those of the tube.
void write_dome(Writer& writer, Section const& end, int rings)
{
    static auto const steps = [] {
        std::array<std::vector<DomeStep>, kMaxDomeRings + 1> all;
        for (int n = 0; n <= kMaxDomeRings; ++n)
            for (int k = 1; k <= n + 1; ++k)
                all[static_cast<std::size_t>(n)].push_back(
                    dome_step(static_cast<double>(k) / (n + 1)));
        return all;
    }();
    auto const& of_dome = steps[static_cast<std::size_t>(rings)];
    auto const at = [&](DomeStep const& step) {
        Section section = end;
        section.radius_mm = end.radius_mm * step.radius;
        section.center_mm += step.height * end.radius_mm * end.tangent;
        section.slope = step.slope;
        section.v += step.v;
        return section;
    };
    for (std::size_t k = 0; k + 1 < of_dome.size(); ++k) {
        writer.ring(at(of_dome[k]));
        writer.join();
    }
    writer.apex(at(of_dome.back()), 0);
}

} // namespace

void frame_sections(Spine const& spine, std::vector<Section>& sections)
{
    auto const stations = spine.stations;
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
                        static_cast<float>(ridge_height(spine.ridges, station.arc_mm)),
                        static_cast<float>(v) };
    }
}

std::size_t base_vertex_count(Spine const& spine)
{
    return static_cast<std::size_t>(spine.sides) + (spine.ridges.count > 0 ? 1 : 0);
}

MeshExtent tube_extent(Spine const& spine, TubePart const& part)
{
    auto const sides = static_cast<std::size_t>(spine.sides);
    std::size_t rings = part.last - part.first + 1;
    bool const has_apex = part.last + 1 == spine.stations.size() && spine.tip != Spine::Tip::Open;
    if (has_apex && spine.tip == Spine::Tip::Point)
        --rings;
    else if (has_apex)
        rings += static_cast<std::size_t>(dome_rings(spine.sides));
    MeshExtent extent { rings * (sides + 1), (rings - 1) * sides * 6 };
    if (has_apex) {
        extent.vertices += sides;
        extent.indices += sides * 3;
    }
    if (part.first == 0 && spine.closed_base) {
        extent.vertices += base_vertex_count(spine);
        extent.indices += (spine.ridges.count > 0 ? sides : sides - 2) * 3;
    }
    return extent;
}

void write_tube(Spine const& spine, std::span<Section const> sections, TubePart const& part,
                TrianglePlace& place)
{
    Writer writer(place, spine);
    if (part.first == 0 && spine.closed_base)
        writer.base(sections[0]);
    bool const has_tip = part.last + 1 == sections.size();
    auto const last_ring = has_tip && spine.tip == Spine::Tip::Point ? part.last - 1 : part.last;
    auto const rings = place;
    writer.ring(sections[part.first]);
    for (auto i = part.first + 1; i <= last_ring; ++i) {
        writer.ring(sections[i]);
        writer.join();
    }
    shape_saddle(spine, sections, { part.first, last_ring }, rings.position_mm, rings.normal);
    if (has_tip && spine.tip == Spine::Tip::Point)
        writer.apex(sections[part.last], 1);
    else if (has_tip && spine.tip == Spine::Tip::Dome)
        write_dome(writer, sections[part.last], dome_rings(spine.sides));
}

} // namespace tractus::mesh
