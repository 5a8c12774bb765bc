#include "engine/mesh/distance_field.h"

#include "engine/mesh/spine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace tractus::mesh {

namespace {

// A point of a triangle, and on what it lies: 0 to 2, the vertex; 3 to 5, the edge after vertex
// feature - 3; 6, the face.
struct Nearest {
    Vec3f point;
    int feature;
};

constexpr int kFirstEdge = 3;
constexpr int kFace = 6;

// Returns the point of a triangle that is nearest to `at`, by the Voronoi regions of its features
// (Ericson 2005, "Real-Time Collision Detection", section 5.1.5).
Nearest nearest_on_triangle(Vec3f const& at, Vec3f const& a, Vec3f const& b, Vec3f const& c)
{
    Vec3f const ab = b - a;
    Vec3f const ac = c - a;
    float const d1 = ab.dot(at - a);
    float const d2 = ac.dot(at - a);
    if (d1 <= 0 && d2 <= 0)
        return { a, 0 };
    float const d3 = ab.dot(at - b);
    float const d4 = ac.dot(at - b);
    if (d3 >= 0 && d4 <= d3)
        return { b, 1 };
    float const d5 = ab.dot(at - c);
    float const d6 = ac.dot(at - c);
    if (d6 >= 0 && d5 <= d6)
        return { c, 2 };
    float const vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
        return { a + d1 / (d1 - d3) * ab, kFirstEdge };
    float const va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
        return { b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b), kFirstEdge + 1 };
    float const vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
        return { a + d2 / (d2 - d6) * ac, kFirstEdge + 2 };
    float const scale = 1 / (va + vb + vc);
    return { a + scale * (vb * ab + vc * ac), kFace };
}

} // namespace

DistanceField::DistanceField(SolidParts const& parts)
{
    if (parts.plant)
        add_tubes(*parts.plant);
    for (auto const& shape : parts.shapes)
        add_shape(shape, parts.least_thickness_mm);
}

void DistanceField::add_tubes(Plant const& plant)
{
    double const thickest_mm = plant.node_radius_mm.empty()
        ? 0
        : double { *std::max_element(plant.node_radius_mm.begin(), plant.node_radius_mm.end()) };
    SpineBuffers room;
    for (auto const& axis : plant.axes) {
        if (has_contour(plant, axis))
            continue;
        auto const spine = trace_spine(plant, axis, {}, thickest_mm, room);
        auto const stations = spine.stations;
        for (std::size_t i = 1; i < stations.size(); ++i) {
            auto const& from = stations[i - 1];
            auto const& to = stations[i];
            Cone cone { from.center_mm.cast<float>(), to.center_mm.cast<float>(),
                        static_cast<float>(from.radius_mm), static_cast<float>(to.radius_mm) };
            cone.material = plant.segment_material[to.segment];
            // Without this the base of a trunk would be the half of a sphere.
            if (spine.closed_base && from.arc_mm < 2 * stations[0].radius_mm) {
                cone.below = -stations[0].tangent.cast<float>();
                cone.foot_mm = stations[0].center_mm.cast<float>();
            }
            cones_.push_back(cone);
        }
    }
}

void DistanceField::add_shape(SolidShape const& shape, double thickness_mm)
{
    for (auto const& instance : shape.instances)
        for (auto const& prototype : shape.pieces) {
            auto piece = placed(prototype, instance);
            if (piece.is_closed()) {
                lumps_.push_back(lump_of(std::move(piece), thickness_mm, shape.material));
                continue;
            }
            auto const& at = piece.positions_mm;
            for (auto const& [a, b, c] : piece.triangles)
                plates_.push_back({ { at[a], at[b], at[c] },
                                    static_cast<float>(thickness_mm / 2),
                                    shape.material });
        }
}

DistanceField::Lump DistanceField::lump_of(SheetPiece piece, double thickness_mm,
                                           MaterialId material)
{
    Lump lump;
    lump.growth_mm = static_cast<float>(growth_of(piece, thickness_mm));
    lump.material = material;
    auto const& at = piece.positions_mm;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3f> edges;
    lump.vertex_normals.assign(at.size(), Vec3f::Zero());
    for (auto const& triangle : piece.triangles) {
        Vec3f const side = at[triangle[1]] - at[triangle[0]];
        Vec3f const normal = side.cross(Vec3f(at[triangle[2]] - at[triangle[0]])).normalized();
        lump.face_normals.push_back(normal);
        for (std::size_t k = 0; k < 3; ++k) {
            auto const from = triangle[k];
            auto const to = triangle[(k + 1) % 3];
            auto const [place, is_new] = edges.emplace(std::minmax(from, to), Vec3f(Vec3f::Zero()));
            place->second += normal;
            Vec3f const along = (at[to] - at[from]).normalized();
            Vec3f const back = (at[triangle[(k + 2) % 3]] - at[from]).normalized();
            lump.vertex_normals[from]
                += std::acos(std::clamp(along.dot(back), -1.0f, 1.0f)) * normal;
        }
    }
    for (auto const& triangle : piece.triangles) {
        auto& own = lump.edge_normals.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
            own[k] = edges.at(std::minmax(triangle[k], triangle[(k + 1) % 3]));
    }
    for (auto const& position : at)
        lump.box_mm.extend(position);
    lump.piece = std::move(piece);
    return lump;
}

MaterialId DistanceField::material(std::size_t shape) const
{
    if (shape < cones_.size())
        return cones_[shape].material;
    shape -= cones_.size();
    return shape < plates_.size() ? plates_[shape].material
                                  : lumps_[shape - plates_.size()].material;
}

Eigen::AlignedBox3f DistanceField::box_mm(std::size_t shape) const
{
    Eigen::AlignedBox3f box;
    float growth = 0;
    if (shape < cones_.size()) {
        auto const& cone = cones_[shape];
        box.extend(cone.from_mm).extend(cone.to_mm);
        growth = std::max(cone.from_radius_mm, cone.to_radius_mm);
    } else if (shape -= cones_.size(); shape < plates_.size()) {
        for (auto const& corner : plates_[shape].corners_mm)
            box.extend(corner);
        growth = plates_[shape].half_mm;
    } else {
        auto const& lump = lumps_[shape - plates_.size()];
        box = lump.box_mm;
        growth = lump.growth_mm;
    }
    return { box.min() - Vec3f::Constant(growth), box.max() + Vec3f::Constant(growth) };
}

float DistanceField::distance_mm(std::size_t shape, Vec3f const& at_mm) const
{
    if (shape < cones_.size())
        return distance_of(cones_[shape], at_mm);
    shape -= cones_.size();
    if (shape >= plates_.size())
        return distance_of(lumps_[shape - plates_.size()], at_mm);
    auto const& [corners, half, material] = plates_[shape];
    auto const nearest = nearest_on_triangle(at_mm, corners[0], corners[1], corners[2]);
    return (at_mm - nearest.point).norm() - half;
}

float DistanceField::distance_of(Cone const& cone, Vec3f const& at_mm)
{
    Vec3f const axis = cone.to_mm - cone.from_mm;
    float const length = axis.norm();
    float const taper = cone.from_radius_mm - cone.to_radius_mm;
    Vec3f const offset = at_mm - cone.from_mm;
    float share = taper > 0 ? 0.0f : 1.0f; // Where one sphere contains the other.
    if (std::abs(taper) < length) {
        float const along = offset.dot(axis) / length;
        float const aside = std::sqrt(std::max(0.0f, offset.squaredNorm() - along * along));
        float const sine = taper / length;
        // The centre of the sphere that touches the cone's side where it is nearest to the point.
        float const center = along - aside * sine / std::sqrt(1 - sine * sine);
        share = std::clamp(center / length, 0.0f, 1.0f);
    }
    float const distance = (offset - share * axis).norm() - (cone.from_radius_mm - share * taper);
    bool const is_cut = cone.below != Vec3f::Zero();
    return is_cut ? std::max(distance, cone.below.dot(at_mm - cone.foot_mm)) : distance;
}

float DistanceField::distance_of(Lump const& lump, Vec3f const& at_mm)
{
    auto const& at = lump.piece.positions_mm;
    float least = std::numeric_limits<float>::infinity();
    float side = 1;
    for (std::size_t i = 0; i < lump.piece.triangles.size(); ++i) {
        auto const& triangle = lump.piece.triangles[i];
        auto const nearest
            = nearest_on_triangle(at_mm, at[triangle[0]], at[triangle[1]], at[triangle[2]]);
        Vec3f const from = at_mm - nearest.point;
        if (float const square = from.squaredNorm(); square < least) {
            least = square;
            auto const feature = static_cast<std::size_t>(nearest.feature);
            side = from.dot(nearest.feature == kFace ? lump.face_normals[i]
                                : nearest.feature < kFirstEdge
                                ? lump.vertex_normals[triangle[feature]]
                                : lump.edge_normals[i][feature - kFirstEdge]);
        }
    }
    return std::copysign(std::sqrt(least), side) - lump.growth_mm;
}

} // namespace tractus::mesh
