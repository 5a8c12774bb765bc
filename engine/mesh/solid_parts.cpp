#include "engine/mesh/solid_parts.h"

#include "engine/base/parallel.h"
#include "engine/mesh/extrusion.h"
#include "engine/mesh/polygon_mesh.h"
#include "engine/mesh/spine.h"
#include "engine/mesh/tube.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::mesh {

namespace {

// Sides of the thinnest tubes. Their radius is that of a circle around a hexagon as wide as the
// least thickness.
constexpr int kSidesOfThinTubes = 6;
constexpr std::size_t kPartsAtOnce = 64;
constexpr MeshOptions kTubes { .min_sides = kSidesOfThinTubes };

SolidShape shape_of(TriangleMesh const& mesh, std::vector<InstanceTransform> instances,
                    double scale)
{
    auto const factor = static_cast<float>(scale);
    for (auto& instance : instances) {
        instance.translation_mm *= factor;
        instance.scale *= factor;
    }
    return { split_sheet(mesh), std::move(instances), mesh.material };
}

// Returns a plant scaled by the options, whose branches have at least the options' thickness.
Plant thickened(Plant plant, SolidOptions const& options)
{
    auto const least
        = static_cast<float>(options.least_thickness_mm / (2 * std::cos(kPi / kSidesOfThinTubes)));
    for (auto& position_mm : plant.node_position_mm)
        position_mm *= options.scale;
    for (auto& radius_mm : plant.node_radius_mm)
        radius_mm = std::max(static_cast<float>(options.scale) * radius_mm, least);
    return plant;
}

TriangleMesh room_for(MeshExtent const& extent, MaterialId material)
{
    TriangleMesh mesh;
    mesh.material = material;
    mesh.positions_mm.resize(extent.vertices);
    mesh.normals.resize(extent.vertices);
    mesh.texture_coordinates.resize(extent.vertices);
    mesh.indices.resize(extent.indices);
    return mesh;
}

// Adds an axis whose sections are not round. It has the material of its first segment.
void add_extrusion(Plant const& plant, Axis const& axis, SolidParts& parts)
{
    Extrusion extrusion;
    trace_extrusion(plant, axis, kTubes, extrusion);
    if (extrusion.stations.empty())
        return;
    TubePart const all { 0, static_cast<std::uint32_t>(extrusion.stations.size() - 1) };
    auto mesh = room_for(extrusion_extent(plant, extrusion, all),
                         plant.segment_material[axis.first_segment]);
    auto place = place_in(mesh, {});
    write_extrusion(plant, extrusion, all, place);
    parts.shapes.push_back(shape_of(mesh, { {} }, 1));
}

void add_polygons(Plant const& plant, double scale, SolidParts& parts)
{
    for (auto const& polygon : plant.polygons) {
        auto const vertices = std::span(plant.polygon_vertices_mm)
                                  .subspan(polygon.first_vertex, polygon.vertex_count);
        auto mesh = room_for(polygon_extent(vertices), polygon.material);
        auto place = place_in(mesh, {});
        write_polygon(vertices, place);
        parts.shapes.push_back(shape_of(mesh, { {} }, scale));
    }
}

// Joins two rings of `sides` vertices; `lower` and `upper` are their first vertices.
void join_rings(ClosedMesh& mesh, std::uint32_t lower, std::uint32_t upper, std::uint32_t sides)
{
    for (std::uint32_t j = 0; j < sides; ++j) {
        auto const next = (j + 1) % sides;
        mesh.triangles.push_back({ lower + j, lower + next, upper + next });
        mesh.triangles.push_back({ lower + j, upper + next, upper + j });
    }
}

// Adds the vertices of a ring and returns the first.
std::uint32_t add_ring(ClosedMesh& mesh, Section const& section, std::uint32_t sides,
                       MaterialId material)
{
    auto const first = static_cast<std::uint32_t>(mesh.positions_mm.size());
    for (std::uint32_t j = 0; j < sides; ++j) {
        double const angle = 2 * kPi * j / sides;
        mesh.positions_mm.push_back(
            section.center_mm
            + section.radius_mm
                * (static_cast<float>(std::cos(angle)) * section.normal
                   + static_cast<float>(std::sin(angle)) * section.binormal));
        mesh.materials.push_back(material);
    }
    return first;
}

// Closes a tube whose last ring is `ring`. `tip_mm`: the end of the tube.
void add_tip(ClosedMesh& mesh, std::uint32_t ring, std::uint32_t sides, Vec3f const& tip_mm)
{
    auto const apex = static_cast<std::uint32_t>(mesh.positions_mm.size());
    mesh.positions_mm.push_back(tip_mm);
    mesh.materials.push_back(mesh.materials[ring]);
    for (std::uint32_t j = 0; j < sides; ++j)
        mesh.triangles.push_back({ ring + j, ring + (j + 1) % sides, apex });
}

// A ring half-way up the dome at a tube's tip.
Section dome_section(Section const& end)
{
    auto section = end;
    auto const share = static_cast<float>(std::sqrt(0.5));
    section.radius_mm *= share;
    section.center_mm += share * end.radius_mm * end.tangent;
    return section;
}

// Returns a tube with a flat base, also where it is inside its parent, and a dome at its tip.
ClosedMesh closed_tube(Plant const& plant, Spine const& spine, std::vector<Section> const& sections)
{
    auto const sides = static_cast<std::uint32_t>(spine.sides);
    bool const is_pointed = spine.tip == Spine::Tip::Point;
    ClosedMesh tube;
    std::uint32_t last = 0;
    for (std::size_t i = 0; i + (is_pointed ? 1 : 0) < sections.size(); ++i) {
        auto const material = plant.segment_material[spine.stations[i].segment];
        auto const ring = add_ring(tube, sections[i], sides, material);
        if (i == 0)
            for (std::uint32_t j = 2; j < sides; ++j)
                tube.triangles.push_back({ ring, ring + j, ring + j - 1 });
        else
            join_rings(tube, last, ring, sides);
        last = ring;
    }
    auto const& end = sections.back();
    if (is_pointed) {
        add_tip(tube, last, sides, end.center_mm);
        return tube;
    }
    auto const dome = add_ring(tube, dome_section(end), sides, tube.materials[last]);
    join_rings(tube, last, dome, sides);
    add_tip(tube, dome, sides, end.center_mm + end.radius_mm * end.tangent);
    return tube;
}

std::vector<ClosedMesh> closed_tubes(Plant const& plant)
{
    std::vector<ClosedMesh> tubes(plant.axes.size());
    double const thickest_mm = plant.node_radius_mm.empty()
        ? 0
        : double { *std::max_element(plant.node_radius_mm.begin(), plant.node_radius_mm.end()) };
    parallel_for(tubes.size(), kPartsAtOnce, [&](std::size_t begin, std::size_t end) {
        SpineBuffers room;
        std::vector<Section> sections;
        for (auto i = begin; i != end; ++i) {
            if (has_contour(plant, plant.axes[i]))
                continue;
            auto const spine = trace_spine(plant, plant.axes[i], kTubes, thickest_mm, room);
            if (spine.stations.empty())
                continue;
            frame_sections(spine, sections);
            tubes[i] = closed_tube(plant, spine, sections);
        }
    });
    return tubes;
}

} // namespace

SolidParts solid_parts(Plant const& plant, SolidOptions const& options)
{
    SolidParts parts { .plant = thickened(plant, options),
                       .least_thickness_mm = options.least_thickness_mm };
    for (auto const& axis : plant.axes)
        if (has_contour(plant, axis))
            add_extrusion(*parts.plant, axis, parts);
    if (options.organs == SolidOptions::Organs::LeftOut)
        return parts;
    add_polygons(plant, options.scale, parts);
    for (auto& organ : make_organs(plant))
        parts.shapes.push_back(
            shape_of(organ.prototype, std::move(organ.instances), options.scale));
    return parts;
}

SolidParts solid_parts(Mesh const& mesh, SolidOptions const& options)
{
    SolidParts parts { .least_thickness_mm = options.least_thickness_mm };
    for (auto const& surface : mesh.surfaces)
        parts.shapes.push_back(shape_of(surface, { {} }, options.scale));
    if (options.organs == SolidOptions::Organs::Solid)
        for (auto const& organ : mesh.organs)
            parts.shapes.push_back(shape_of(organ.prototype, organ.instances, options.scale));
    return parts;
}

ClosedMesh closed_surfaces(SolidParts const& parts)
{
    ClosedMesh mesh;
    if (parts.plant)
        for (auto const& tube : closed_tubes(*parts.plant))
            append(mesh, tube);
    for (auto const& shape : parts.shapes)
        for (auto const& piece : shape.pieces) {
            std::vector<ClosedMesh> solids(shape.instances.size());
            parallel_for(solids.size(), kPartsAtOnce, [&](std::size_t begin, std::size_t end) {
                for (auto i = begin; i != end; ++i)
                    solids[i] = solid_of(placed(piece, shape.instances[i]), shape.material,
                                         parts.least_thickness_mm);
            });
            for (auto const& solid : solids)
                append(mesh, solid);
        }
    separate_vertices(mesh);
    return mesh;
}

} // namespace tractus::mesh
