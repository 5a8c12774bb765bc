#include "engine/mesh/aged_mesh.h"

#include "engine/base/check.h"
#include "engine/base/parallel.h"
#include "engine/mesh/mesh_measures.h"

#include <algorithm>
#include <limits>

namespace tractus::mesh {

namespace {

constexpr std::size_t kAxesAtOnce = 512;
constexpr std::size_t kRingsAtOnce = 2048;
constexpr std::size_t kRidersAtOnce = 1024;

// Returns the smallest rotation from one unit vector to another; exactly the identity if they
// differ by less than kSame.
Eigen::Matrix3d turn_from(Vec3 const& from, Vec3 const& to)
{
    constexpr double kSame = 1e-12;
    if ((from - to).squaredNorm() < kSame * kSame)
        return Eigen::Matrix3d::Identity();
    return rotation_between(from, to).toRotationMatrix();
}

// Transforms a normal of a prototype into the plant's frame. Where `scale` is 0 along an axis, 1 is
// used instead.
Vec3f placed_normal(InstanceTransform const& instance, Vec3f const& scale, Vec3f const& normal)
{
    Vec3f const whole = (scale.array() != 0).select(scale, 1);
    return instance.rotation * normal.cwiseQuotient(whole).normalized();
}

void append_organ(TriangleMesh const& prototype, Organ const& organ, TriangleMesh& to)
{
    auto const first = to.positions_mm.size();
    auto const instance = transform_of(organ);
    for (std::size_t i = 0; i < prototype.positions_mm.size(); ++i) {
        to.positions_mm.push_back(placed(instance, prototype.positions_mm[i]));
        to.normals.push_back(placed_normal(instance, organ.scale, prototype.normals[i]));
    }
    to.texture_coordinates.insert(to.texture_coordinates.end(),
                                  prototype.texture_coordinates.begin(),
                                  prototype.texture_coordinates.end());
    for (auto const index : prototype.indices)
        to.indices.push_back(static_cast<std::uint32_t>(first) + index);
    CHECK(to.positions_mm.size() <= std::numeric_limits<std::uint32_t>::max());
}

} // namespace

// How a segment differs between the full-grown plant and the plant at the age of AgedMesh::at().
struct AgedMesh::Carrier {
    // Base of the segment in the full-grown plant. `to_mm`: its base at that age.
    Vec3 from_mm = Vec3::Zero();
    Vec3 to_mm = Vec3::Zero();
    Vec3 direction = Vec3::Zero(); // Direction of the full-grown segment.
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    double length_mm = 0; // Length of the full-grown segment.
    double share = 0;     // Share of length_mm that has grown.
    // Radii at the base and tip of the full-grown segment. `radius_mm`: its radii at that age.
    double whole_radius_mm[2];
    double radius_mm[2];

    // Returns the radius at the share `along` of the segment's length, as a share of the full-grown
    // radius at that point.
    double width_at(double along) const
    {
        double const whole = (1 - along) * whole_radius_mm[0] + along * whole_radius_mm[1];
        double const now = (1 - along) * radius_mm[0] + along * radius_mm[1];
        if (whole > 0)
            return now / whole;
        return share > 0 ? 1 : 0; // A tube of radius 0 has this radius at all ages.
    }
};

AgedMesh::AgedMesh(Plant const& whole, MeshOptions const& options)
    : plant_(whole)
{
    MeshPlan const plan(whole, options);
    whole_.materials = whole.materials;
    whole_.surfaces = make_surfaces(plan);
    find_parts(plan);
    add_organs(options);
}

void AgedMesh::find_parts(MeshPlan const& plan)
{
    for (auto const& surface : plan.surfaces()) {
        auto& parts = parts_.emplace_back();
        for (std::size_t piece = 0; piece < surface.piece_count(); ++piece)
            plan.find_rings(surface, piece, parts.rings);
        for (auto i = surface.tube_count; i < surface.items.size(); ++i)
            parts.polygons.push_back({ surface.items[i].number, surface.items[i].first_vertex });
    }
}

std::size_t AgedMesh::surface_of(MaterialId material)
{
    auto& surfaces = whole_.surfaces;
    auto const found
        = std::find_if(surfaces.begin(), surfaces.end(),
                       [&](TriangleMesh const& surface) { return surface.material == material; });
    if (found != surfaces.end())
        return static_cast<std::size_t>(found - surfaces.begin());
    surfaces.emplace_back().material = material;
    parts_.emplace_back();
    return surfaces.size() - 1;
}

void AgedMesh::add_organs(MeshOptions const& options)
{
    prototypes_.resize(plant_.organ_shapes.size());
    std::vector<bool> is_made(prototypes_.size());
    for (std::uint32_t i = 0; i < plant_.organs.size(); ++i) {
        auto const& organ = plant_.organs[i];
        auto& prototype = prototypes_[organ.shape];
        if (!is_made[organ.shape])
            prototype = make_prototype(plant_, organ.shape, options);
        is_made[organ.shape] = true;
        if (prototype.indices.empty())
            continue;
        auto const surface = surface_of(prototype.material);
        auto& mesh = whole_.surfaces[surface];
        parts_[surface].organs.push_back(
            { i, static_cast<std::uint32_t>(mesh.positions_mm.size()) });
        append_organ(prototype, organ, mesh);
    }
}

// Finds how every segment differs in `young`. A segment that has not grown has no direction of its
// own: it rotates with the segment before it.
std::vector<AgedMesh::Carrier> AgedMesh::carriers(Plant const& young) const
{
    std::vector<Carrier> carriers(plant_.segment_count());
    parallel_for(plant_.axes.size(), kAxesAtOnce, [&](std::size_t begin, std::size_t end) {
        for (auto id = begin; id != end; ++id) {
            auto const& axis = plant_.axes[id];
            Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
            for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
                NodeId const base = axis.first_node + i;
                auto& carrier = carriers[axis.first_segment + i];
                carrier.from_mm = plant_.node_position_mm[base];
                carrier.to_mm = young.node_position_mm[base];
                Vec3 const whole = plant_.node_position_mm[base + 1] - carrier.from_mm;
                Vec3 const now = young.node_position_mm[base + 1] - carrier.to_mm;
                carrier.length_mm = whole.norm();
                double const grown_mm = now.norm();
                if (carrier.length_mm > 0) {
                    carrier.direction = whole / carrier.length_mm;
                    carrier.share = grown_mm / carrier.length_mm;
                }
                if (carrier.length_mm > kSameNode_mm && grown_mm > kSameNode_mm)
                    turn = turn_from(carrier.direction, now / grown_mm);
                carrier.turn = turn;
                for (std::uint32_t k = 0; k < 2; ++k) {
                    carrier.whole_radius_mm[k] = plant_.node_radius_mm[base + k];
                    carrier.radius_mm[k] = young.node_radius_mm[base + k];
                }
            }
        }
    });
    return carriers;
}

// Moves the vertices of tubes, by adding a displacement to each: so vertices that do not move stay
// bit for bit the same.
void AgedMesh::move_rings(std::size_t surface, std::span<Carrier const> carriers,
                          Vertices& to) const
{
    auto const& mesh = whole_.surfaces[surface];
    auto const& rings = parts_[surface].rings;
    parallel_for(rings.size(), kRingsAtOnce, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i != end; ++i) {
            auto const& ring = rings[i];
            auto const& carrier = carriers[ring.segment];
            Vec3 const offset = ring.center_mm - carrier.from_mm;
            double const along = carrier.length_mm > 0
                ? std::clamp(offset.dot(carrier.direction) / carrier.length_mm, 0.0, 1.0)
                : 1;
            Vec3 const center_mm = carrier.to_mm + carrier.share * (carrier.turn * offset);
            Vec3f const step = (center_mm - ring.center_mm).cast<float>();
            Eigen::Matrix3f const turn = carrier.turn.cast<float>();
            Eigen::Matrix3f const change
                = (carrier.width_at(along) * carrier.turn - Eigen::Matrix3d::Identity())
                      .cast<float>();
            Vec3f const middle = ring.center_mm.cast<float>();
            for (auto v = ring.first_vertex; v != ring.first_vertex + ring.vertex_count; ++v) {
                Vec3f const& position = mesh.positions_mm[v];
                to.positions_mm[v] = position + step + change * (position - middle);
                to.normals[v] = turn * mesh.normals[v];
            }
        }
    });
}

void AgedMesh::move_polygons(std::size_t surface, Plant const& young,
                             std::span<Carrier const> carriers, Vertices& to) const
{
    auto const& normals = whole_.surfaces[surface].normals;
    for (auto const& [number, first_vertex] : parts_[surface].polygons) {
        auto const& polygon = plant_.polygons[number];
        Eigen::Matrix3f turn = Eigen::Matrix3f::Identity();
        if (polygon.segment != kNone)
            turn = carriers[polygon.segment].turn.cast<float>();
        for (std::uint32_t i = 0; i < polygon.vertex_count; ++i) {
            to.positions_mm[first_vertex + i]
                = young.polygon_vertices_mm[polygon.first_vertex + i].cast<float>();
            to.normals[first_vertex + i] = turn * normals[first_vertex + i];
        }
    }
}

void AgedMesh::move_organs(std::size_t surface, Plant const& young, Vertices& to) const
{
    auto const& organs = parts_[surface].organs;
    parallel_for(organs.size(), kRidersAtOnce, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i != end; ++i) {
            auto const& [number, first_vertex] = organs[i];
            auto const& organ = young.organs[number];
            auto const& prototype = prototypes_[organ.shape];
            auto const instance = transform_of(organ);
            for (std::size_t v = 0; v < prototype.positions_mm.size(); ++v) {
                to.positions_mm[first_vertex + v] = placed(instance, prototype.positions_mm[v]);
                // An unfolding organ keeps its proportions, so its normals are those of the
                // full-grown organ.
                to.normals[first_vertex + v]
                    = placed_normal(instance, plant_.organs[number].scale, prototype.normals[v]);
            }
        }
    });
}

void AgedMesh::at(Plant const& young, std::vector<Vertices>& surfaces) const
{
    CHECK(young.node_position_mm.size() == plant_.node_position_mm.size());
    CHECK(young.organs.size() == plant_.organs.size());
    CHECK(young.polygon_vertices_mm.size() == plant_.polygon_vertices_mm.size());
    auto const carried = carriers(young);
    surfaces.resize(whole_.surfaces.size());
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        surfaces[i].positions_mm.resize(whole_.surfaces[i].positions_mm.size());
        surfaces[i].normals.resize(whole_.surfaces[i].normals.size());
        move_rings(i, carried, surfaces[i]);
        move_polygons(i, young, carried, surfaces[i]);
        move_organs(i, young, surfaces[i]);
    }
}

} // namespace tractus::mesh
