#include "engine/mesh/organ_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <span>

namespace tractus::mesh {
namespace {

std::uint32_t add_vertex(TriangleMesh& mesh, Vec3 const& position, Vec3 const& normal,
                         Vec2 const& texture)
{
    mesh.positions_mm.push_back(position.cast<float>());
    mesh.normals.push_back(normal.normalized().cast<float>());
    mesh.texture_coordinates.push_back(texture.cast<float>());
    return static_cast<std::uint32_t>(mesh.positions_mm.size() - 1);
}

void add_triangles(TriangleMesh& mesh, std::initializer_list<std::uint32_t> indices)
{
    mesh.indices.insert(mesh.indices.end(), indices);
}

// The midrib of an organ: along the petiole it is straight, along +y, then it bends down (towards
// -z) in a circular arc.
struct Midrib {
    double straight_mm;
    double bent_mm;
    double curl_rad;

    double angle(double share) const { return curl_rad * share; }

    Vec3 point(double share) const
    {
        double const turned = angle(share);
        double const arc = bent_mm * share;
        if (std::abs(turned) < 1e-6)
            return { 0, straight_mm + arc, 0 };
        return { 0, straight_mm + arc * std::sin(turned) / turned,
                 -arc * (1 - std::cos(turned)) / turned };
    }
    Vec3 tangent(double share) const
    {
        return { 0, std::cos(angle(share)), -std::sin(angle(share)) };
    }
    Vec3 up(double share) const { return { 0, std::sin(angle(share)), std::cos(angle(share)) }; }
};

// Returns the width at one end of a blade's outline, as a share of the greatest width. x is 0 at
// the end and 1 at the greatest width. Sharpness 0 gives an elliptical arc, 1 a quarter of a sine
// (a pointed end), larger values a concave taper.
double end_width(double x, double sharpness)
{
    double const power
        = sharpness < 1 ? 0.5 + 0.5 * std::max(0.0, sharpness) : std::min(sharpness, 4.0);
    return std::pow(std::sin(0.5 * kPi * std::clamp(x, 0.0, 1.0)), power);
}

// Returns the width of the blade at `share` of the distance from its base to its tip, as a share of
// the greatest width.
double outline(OrganShape const& shape, double share)
{
    double const widest = std::clamp(shape.widest, 0.02, 0.98);
    double const width = share < widest
        ? end_width(share / widest, shape.base_sharpness)
        : end_width((1 - share) / (1 - widest), shape.tip_sharpness);
    if (shape.lobe_count <= 0)
        return width;
    // The tip counts as a lobe of its own.
    double const lobe = 0.5 + 0.5 * std::cos(2 * kPi * (shape.lobe_count + 1) * share);
    return width * (1 - std::clamp(shape.lobes, 0.0, 0.95) * (1 - lobe));
}

// Returns the positions of a blade's rows of vertices, from 0 at the base to 1 at the tip. In a
// blade without lobes the rows are closer together at both ends, where the outline curves most.
std::vector<double> blade_rows(OrganShape const& shape)
{
    int const lobes = std::clamp(shape.lobe_count, 0, 16);
    int const count = lobes > 0 ? 6 * (lobes + 1) : 9;
    std::vector<double> rows;
    for (int i = 0; i <= count; ++i) {
        double const even = static_cast<double>(i) / count;
        double const eased = 0.5 - 0.5 * std::cos(kPi * even);
        rows.push_back(lobes > 0 ? even : 0.4 * even + 0.6 * eased);
    }
    return rows;
}

void add_petiole(TriangleMesh& mesh, double length_mm, double radius_mm)
{
    constexpr std::uint32_t kSides = 3;
    auto const first = static_cast<std::uint32_t>(mesh.positions_mm.size());
    // The petiole ends a little inside the blade.
    for (double const y : { 0.0, length_mm + radius_mm })
        for (std::uint32_t j = 0; j < kSides; ++j) {
            double const angle = 2 * kPi * (j + 0.25) / kSides;
            Vec3 const out(std::cos(angle), 0, std::sin(angle));
            add_vertex(mesh, radius_mm * out + Vec3(0, y, 0), out, { 0.5, 0 });
        }
    for (std::uint32_t j = 0; j < kSides; ++j) {
        auto const here = first + j;
        auto const next = first + (j + 1) % kSides;
        add_triangles(mesh, { here, here + kSides, next, next, here + kSides, next + kSides });
    }
}

// One row of a blade: the indices of its vertices on the left margin, the midrib and the right
// margin.
struct BladeRow {
    std::uint32_t left;
    std::uint32_t middle;
    std::uint32_t right;
};

BladeRow add_row(TriangleMesh& mesh, OrganShape const& shape, Midrib const& midrib, double share)
{
    Vec3 const center = midrib.point(share);
    Vec3 const up = midrib.up(share);
    Vec3 const along = midrib.tangent(share);
    double const width = outline(shape, share);
    Vec3 const across_right
        = std::cos(shape.fold_rad) * Vec3::UnitX() + std::sin(shape.fold_rad) * up;
    Vec3 const across_left(-across_right.x(), across_right.y(), across_right.z());
    double const half_mm = 0.5 * shape.width_mm * width;
    return {
        add_vertex(mesh, center + half_mm * across_left, along.cross(across_left),
                   { 0.5 - 0.5 * width, share }),
        add_vertex(mesh, center, up, { 0.5, share }),
        add_vertex(mesh, center + half_mm * across_right, across_right.cross(along),
                   { 0.5 + 0.5 * width, share }),
    };
}

void add_blade(TriangleMesh& mesh, OrganShape const& shape)
{
    double const petiole = std::clamp(shape.petiole_mm, 0.0, 0.95 * shape.length_mm);
    if (petiole > 0)
        add_petiole(mesh, petiole, std::min(0.025 * shape.width_mm, 0.1 * petiole));
    Midrib const midrib { petiole, shape.length_mm - petiole, shape.curl_rad };
    auto const rows = blade_rows(shape);
    auto const end = [&](double share) {
        return add_vertex(mesh, midrib.point(share), midrib.up(share), { 0.5, share });
    };
    auto const base = end(0);
    auto row = add_row(mesh, shape, midrib, rows[1]);
    add_triangles(mesh, { base, row.middle, row.left, base, row.right, row.middle });
    for (std::size_t i = 2; i + 1 < rows.size(); ++i) {
        auto const next = add_row(mesh, shape, midrib, rows[i]);
        add_triangles(mesh,
                      { row.left, row.middle, next.left, next.left, row.middle, next.middle,
                        row.middle, row.right, next.middle, next.middle, row.right, next.right });
        row = next;
    }
    auto const tip = end(1);
    add_triangles(mesh, { row.left, row.middle, tip, row.middle, row.right, tip });
}

void add_cut_leaf(TriangleMesh& mesh, OrganShape const& shape)
{
    auto const& leaf = *shape.cut;
    double const tip = box_of(leaf).max().y();
    if (!(tip > 0))
        return;
    Midrib const midrib { 0, shape.length_mm, shape.curl_rad };
    double const scale_mm = shape.length_mm / tip;
    for (auto const& corner : leaf.corners) {
        double const share = corner.y() / tip;
        Vec3 const up = midrib.up(share);
        Vec3 const out = std::cos(shape.fold_rad) * Vec3::UnitX();
        double const side = corner.x() > 0 ? 1 : corner.x() < 0 ? -1 : 0;
        double const rise = std::sin(shape.fold_rad);
        add_vertex(
            mesh,
            midrib.point(share) + scale_mm * (corner.x() * out + std::abs(corner.x()) * rise * up),
            std::cos(shape.fold_rad) * up - side * rise * Vec3::UnitX(), leaf.in_picture(corner));
    }
    for (auto const& [a, b, c] : leaf.triangles)
        add_triangles(mesh, { a, b, c });
}

// Joins two rings of `sides` + 1 vertices each. `lower`, `upper`: index of the first vertex of
// each.
void join_rings(TriangleMesh& mesh, std::uint32_t lower, std::uint32_t upper, std::uint32_t sides)
{
    for (std::uint32_t j = 0; j < sides; ++j)
        add_triangles(
            mesh, { lower + j, upper + j, lower + j + 1, lower + j + 1, upper + j, upper + j + 1 });
}

void add_needle(TriangleMesh& mesh, OrganShape const& shape)
{
    constexpr std::uint32_t kSides = 4;
    Midrib const midrib { 0, shape.length_mm, shape.curl_rad };
    auto const ring = [&](double share, double width) {
        auto const first = static_cast<std::uint32_t>(mesh.positions_mm.size());
        for (std::uint32_t j = 0; j <= kSides; ++j) {
            double const angle = 2 * kPi * (j % kSides) / kSides;
            Vec3 const out = std::cos(angle) * Vec3::UnitX() + std::sin(angle) * midrib.up(share);
            add_vertex(mesh, midrib.point(share) + 0.5 * shape.width_mm * width * out, out,
                       { static_cast<double>(j) / kSides, share });
        }
        return first;
    };
    auto const base = ring(0, 0.6);
    auto const middle = ring(0.5, 1);
    join_rings(mesh, base, middle, kSides);
    for (std::uint32_t j = 0; j < kSides; ++j) {
        Vec3 const out = (mesh.normals[middle + j] + mesh.normals[middle + j + 1]).cast<double>();
        auto const tip
            = add_vertex(mesh, midrib.point(1), out.normalized() + 0.3 * midrib.tangent(1),
                         { (j + 0.5) / kSides, 1 });
        add_triangles(mesh, { middle + j, tip, middle + j + 1 });
    }
}

// A point of the profile of a solid of revolution about +y.
struct ProfilePoint {
    double radius_mm;
    double y_mm;
    double normal_radial;
    double normal_y;
};

// Revolves a profile, given from bottom to top, about +y. Its first and last points must be on the
// axis. At these points each of the `sides` has a vertex of its own, for the texture.
void revolve(TriangleMesh& mesh, std::span<ProfilePoint const> profile, std::uint32_t sides)
{
    auto const vertex = [&](ProfilePoint const& point, double turn) {
        // Angles run from +z towards +x, so that counter-clockwise triangles face outwards.
        Vec3 const out(std::sin(2 * kPi * turn), 0, std::cos(2 * kPi * turn));
        return add_vertex(mesh, point.radius_mm * out + Vec3(0, point.y_mm, 0),
                          point.normal_radial * out + Vec3(0, point.normal_y, 0),
                          { turn, point.y_mm / profile.back().y_mm });
    };
    std::vector<std::uint32_t> rings;
    for (auto const& point : profile.subspan(1, profile.size() - 2)) {
        rings.push_back(static_cast<std::uint32_t>(mesh.positions_mm.size()));
        for (std::uint32_t j = 0; j <= sides; ++j)
            vertex(point, static_cast<double>(j) / sides);
        // The last vertex of the ring repeats the first one exactly, for a seam without gaps.
        mesh.positions_mm.back() = mesh.positions_mm[rings.back()];
    }
    for (std::size_t i = 1; i < rings.size(); ++i)
        for (std::uint32_t j = 0; j < sides; ++j) {
            auto const lower = rings[i - 1] + j;
            auto const upper = rings[i] + j;
            add_triangles(mesh, { lower, lower + 1, upper, upper, lower + 1, upper + 1 });
        }
    for (std::uint32_t j = 0; j < sides; ++j) {
        auto const bottom = vertex(profile.front(), (j + 0.5) / sides);
        auto const top = vertex(profile.back(), (j + 0.5) / sides);
        add_triangles(mesh,
                      { rings.front() + j + 1, rings.front() + j, bottom, rings.back() + j,
                        rings.back() + j + 1, top });
    }
}

void add_disc(TriangleMesh& mesh, OrganShape const& shape)
{
    double const radius = 0.5 * shape.width_mm;
    double const rim = 0.4 * shape.length_mm;
    double const dome = shape.length_mm - rim;
    std::array<ProfilePoint, 6> profile {};
    profile[0] = { 0, 0, 0, -1 };
    profile[1] = { radius, rim, rim, -radius };
    profile[2] = { radius, rim, 1, 0.3 };
    for (std::size_t k = 1; k <= 2; ++k) {
        double const angle = 0.5 * kPi * static_cast<double>(k) / 3;
        profile[2 + k] = { radius * std::cos(angle), rim + dome * std::sin(angle),
                           dome * std::cos(angle), radius * std::sin(angle) };
    }
    profile[5] = { 0, shape.length_mm, 0, 1 };
    revolve(mesh, profile, 16);
}

void add_ball(TriangleMesh& mesh, OrganShape const& shape)
{
    double const radius = 0.5 * shape.width_mm;
    double const half = 0.5 * shape.length_mm;
    constexpr int kStacks = 6;
    std::array<ProfilePoint, kStacks + 1> profile {};
    for (int k = 0; k <= kStacks; ++k) {
        double const angle = kPi * k / kStacks;
        profile[static_cast<std::size_t>(k)]
            = { radius * std::sin(angle), half - half * std::cos(angle), half * std::sin(angle),
                -radius * std::cos(angle) };
    }
    profile.front().radius_mm = profile.back().radius_mm = 0;
    revolve(mesh, profile, 10);
}

} // namespace

TriangleMesh organ_mesh(OrganShape const& shape, int subdivision, TextureMapping lies)
{
    if (shape.kind == OrganShape::Kind::Surface)
        return surface_mesh(shape, subdivision, lies);
    TriangleMesh mesh;
    mesh.material = shape.material;
    if (!(shape.length_mm > 0) || !(shape.width_mm > 0))
        return mesh;
    switch (shape.kind) {
    case OrganShape::Kind::Blade:
        add_blade(mesh, shape);
        break;
    case OrganShape::Kind::Needle:
        add_needle(mesh, shape);
        break;
    case OrganShape::Kind::Disc:
        add_disc(mesh, shape);
        break;
    case OrganShape::Kind::Ball:
        add_ball(mesh, shape);
        break;
    case OrganShape::Kind::Leaf:
        if (shape.cut)
            add_cut_leaf(mesh, shape);
        break;
    case OrganShape::Kind::Surface:
        break;
    }
    return mesh;
}

} // namespace tractus::mesh
