#include "engine/mesh/extrusion.h"

#include "engine/mesh/polygon_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus::mesh {
namespace {

constexpr std::uint32_t kMaxExtrudedSides = 256;

// Returns the point of a contour at `share` (0 to 1) of its parameter range; kNoContour: of the
// unit circle.
Vec3 outline_at(Plant const& plant, ContourId id, double share)
{
    if (id == kNoContour)
        return { std::cos(2 * kPi * share), std::sin(2 * kPi * share), 0 };
    double const place = share * static_cast<double>(Contour::kSteps);
    auto const step = std::min(static_cast<std::size_t>(place), Contour::kSteps - 1);
    auto const& points = plant.contours[id].points;
    double const part = place - static_cast<double>(step);
    return ((1 - part) * points[step].cast<double>() + part * points[step + 1].cast<double>());
}

Vec3 outline_at(Plant const& plant, NodeSection const& section, double share)
{
    Vec3 const point = outline_at(plant, section.contour, share);
    if (section.share == 0)
        return point;
    double const next = section.share;
    return (1 - next) * point + next * outline_at(plant, section.next_contour, share);
}

// The outline of one cross-section, in the plant's frame.
struct Ring {
    std::vector<Vec3> points_mm;
    std::vector<Vec3> along; // Direction of the outline at each point, not normalised.
};

Ring ring_at(Plant const& plant, Extrusion const& extrusion, std::size_t index)
{
    auto const& station = extrusion.stations[index];
    auto const& section = plant.node_section[station.node];
    Vec3 const across = station.normal.cross(station.tangent);
    auto const placed = [&](Vec3 const& point) -> Vec3 {
        return station.radius_mm
            * (point.x() * station.normal + point.y() * across + point.z() * station.tangent);
    };
    constexpr double kStep = 1.0 / Contour::kSteps;
    Ring ring;
    for (std::uint32_t i = 0; i <= extrusion.sides; ++i) {
        double const share = static_cast<double>(i) / extrusion.sides;
        double before = share - kStep;
        double after = share + kStep;
        if (extrusion.is_sheet) {
            before = std::max(before, 0.0);
            after = std::min(after, 1.0);
        } else {
            before += before < 0 ? 1 : 0;
            after -= after > 1 ? 1 : 0;
        }
        ring.points_mm.push_back(station.center_mm + placed(outline_at(plant, section, share)));
        ring.along.push_back(
            placed(outline_at(plant, section, after) - outline_at(plant, section, before)));
    }
    if (!extrusion.is_sheet)
        ring.points_mm.back() = ring.points_mm.front(); // The copy leaves no gap at the seam.
    return ring;
}

double perimeter_mm(Ring const& ring)
{
    double length = 0;
    for (std::size_t i = 1; i < ring.points_mm.size(); ++i)
        length += (ring.points_mm[i] - ring.points_mm[i - 1]).norm();
    return length;
}

// The outlines of the sections of a part. Where the axis continues beyond an end of the part, there
// is one more outline, for the normals.
struct Rings {
    std::vector<Ring> rings;
    std::size_t first_station = 0;

    Ring const& of(std::size_t station) const { return rings[station - first_station]; }
    std::size_t last_station() const { return first_station + rings.size() - 1; }
};

Vec3 normal_at(Rings const& rings, Extrusion const& extrusion, std::size_t station, std::size_t i)
{
    auto const before = std::max(station, rings.first_station + 1) - 1;
    auto const after = std::min(station + 1, rings.last_station());
    Vec3 const up = rings.of(after).points_mm[i] - rings.of(before).points_mm[i];
    Vec3 const normal = up.cross(rings.of(station).along[i]);
    double const length = normal.norm();
    if (length > 1e-12)
        return normal / length;
    // Here the section is a single point, or the direction of its outline is zero.
    Vec3 const out = rings.of(station).points_mm[i] - extrusion.stations[station].center_mm;
    return out.norm() > 1e-9 ? Vec3(out.normalized()) : extrusion.stations[station].normal;
}

void add_vertex(TrianglePlace& place, Vec3 const& position, Vec3 const& normal, Vec2 const& texture)
{
    *place.position_mm++ = position.cast<float>();
    *place.normal++ = normal.cast<float>();
    *place.texture++ = texture.cast<float>();
    ++place.vertex;
}

// Writes one layer of a part: the front (`side` is 1), or the back of a sheet (`side` is -1).
void write_layer(Rings const& rings, Extrusion const& extrusion, TubePart const& part, double side,
                 TrianglePlace& place)
{
    auto const first = place.vertex;
    for (auto station = part.first; station <= part.last; ++station) {
        auto const& ring = rings.of(station);
        double const around = std::max(perimeter_mm(ring), 1e-3);
        for (std::uint32_t i = 0; i <= extrusion.sides; ++i)
            add_vertex(place, ring.points_mm[i], side * normal_at(rings, extrusion, station, i),
                       { static_cast<double>(i) / extrusion.sides,
                         extrusion.stations[station].arc_mm / around });
    }
    auto const width = extrusion.sides + 1;
    for (auto station = part.first; station < part.last; ++station)
        for (std::uint32_t i = 0; i < extrusion.sides; ++i) {
            auto const lower = first + (station - part.first) * width + i;
            auto const upper = lower + width;
            std::array<std::uint32_t, 6> corners { lower,     upper, lower + 1,
                                                   lower + 1, upper, upper + 1 };
            if (side < 0)
                std::reverse(corners.begin(), corners.end());
            place.index = std::copy(corners.begin(), corners.end(), place.index);
        }
}

// Returns the outline of an end cap, counter-clockwise seen from outside.
std::vector<Vec3> cap(Ring const& ring, bool is_base)
{
    std::vector<Vec3> points(ring.points_mm.begin(), ring.points_mm.end() - 1);
    if (!is_base)
        std::reverse(points.begin(), points.end());
    return points;
}

template<typename Use>
void for_each_cap(Plant const& plant, Extrusion const& extrusion, TubePart const& part, Use use)
{
    if (!extrusion.has_caps || extrusion.is_sheet)
        return;
    if (part.first == 0)
        use(cap(ring_at(plant, extrusion, 0), true));
    if (part.last + 1 == extrusion.stations.size())
        use(cap(ring_at(plant, extrusion, part.last), false));
}

void add_stations(Plant const& plant, Axis const& axis, std::vector<Extrusion::Station>& stations)
{
    for (std::uint32_t i = 0; i <= axis.segment_count; ++i) {
        NodeId const node = axis.first_node + i;
        Vec3 const& position = plant.node_position_mm[node];
        double const arc = stations.empty()
            ? 0
            : stations.back().arc_mm + (position - stations.back().center_mm).norm();
        if (!stations.empty() && arc - stations.back().arc_mm < kSameNode_mm)
            continue;
        stations.push_back(
            { position, Vec3::UnitZ(), plant.node_section[node].normal.cast<double>(),
              plant.node_radius_mm[node], arc, axis.first_segment + (i == 0 ? 0 : i - 1), node });
    }
}

// Computes the frames of stations. Tangents bisect the bends; normals are made orthogonal to the
// tangents.
void frame_stations(std::vector<Extrusion::Station>& stations)
{
    for (std::size_t i = 0; i < stations.size(); ++i) {
        auto& station = stations[i];
        Vec3 const before = station.center_mm - stations[i == 0 ? 0 : i - 1].center_mm;
        Vec3 const after
            = stations[std::min(i + 1, stations.size() - 1)].center_mm - station.center_mm;
        Vec3 const sum = before.normalized() + after.normalized();
        station.tangent = sum.norm() > 1e-6 ? Vec3(sum.normalized()) : Vec3(after.normalized());
        auto const flatten
            = [&](Vec3 const& v) -> Vec3 { return v - station.tangent * station.tangent.dot(v); };
        Vec3 normal = flatten(station.normal);
        if (!(normal.norm() > 1e-6) && i > 0)
            normal = flatten(stations[i - 1].normal);
        station.normal
            = normal.norm() > 1e-6 ? Vec3(normal.normalized()) : station.tangent.unitOrthogonal();
    }
}

} // namespace

void trace_extrusion(Plant const& plant, Axis const& axis, MeshOptions const& options,
                     Extrusion& extrusion)
{
    extrusion.stations.clear();
    extrusion.is_sheet = false;
    extrusion.has_caps = options.ends == MeshOptions::Ends::Closed;
    std::uint32_t sides = 3;
    for (std::uint32_t i = 0; i <= axis.segment_count; ++i) {
        auto const& section = plant.node_section[axis.first_node + i];
        sides = std::max<std::uint32_t>(sides, section.sides);
        for (auto const id : { section.contour, section.next_contour })
            if (id != kNoContour && !plant.contours[id].closed)
                extrusion.is_sheet = true;
    }
    double const fineness = options.max_sides / 16.0;
    extrusion.sides = std::clamp<std::uint32_t>(
        static_cast<std::uint32_t>(std::lround(sides * fineness)), 3, kMaxExtrudedSides);
    add_stations(plant, axis, extrusion.stations);
    if (extrusion.stations.size() < 2)
        extrusion.stations.clear();
    frame_stations(extrusion.stations);
}

MeshExtent extrusion_extent(Plant const& plant, Extrusion const& extrusion, TubePart const& part)
{
    std::size_t const layers = extrusion.is_sheet ? 2 : 1;
    std::size_t const rings = part.last - part.first + 1;
    MeshExtent extent { layers * rings * (extrusion.sides + 1),
                        layers * (rings - 1) * extrusion.sides * 6 };
    for_each_cap(plant, extrusion, part,
                 [&](std::vector<Vec3> const& outline) { extent += polygon_extent(outline); });
    return extent;
}

void write_extrusion(Plant const& plant, Extrusion const& extrusion, TubePart const& part,
                     TrianglePlace& place)
{
    Rings rings;
    rings.first_station = part.first == 0 ? 0 : part.first - 1;
    auto const last = std::min<std::size_t>(part.last + 1, extrusion.stations.size() - 1);
    for (auto i = rings.first_station; i <= last; ++i)
        rings.rings.push_back(ring_at(plant, extrusion, i));
    write_layer(rings, extrusion, part, 1, place);
    if (extrusion.is_sheet)
        write_layer(rings, extrusion, part, -1, place);
    for_each_cap(plant, extrusion, part,
                 [&](std::vector<Vec3> const& outline) { write_polygon(outline, place); });
}

} // namespace tractus::mesh
