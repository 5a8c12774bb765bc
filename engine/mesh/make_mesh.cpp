#include "engine/mesh/make_mesh.h"

#include "engine/base/check.h"
#include "engine/base/parallel.h"
#include "engine/mesh/organ_mesh.h"
#include "engine/mesh/polygon_mesh.h"
#include "engine/mesh/tube.h"

#include <algorithm>
#include <limits>
#include <span>
#include <vector>

namespace tractus {
namespace {

constexpr std::size_t kAxesPerTask = 256;

// A stretch of one axis' segments that have one material, and the place of its triangles.
struct Run {
    SegmentId end_segment; // One past its last.
    MaterialId material;
    MeshExtent extent {}; // Its size.
    MeshExtent at {};     // Its place in the material's surface.
};

// The runs of all axes, in order; axis i has those from first_run[i] to first_run[i + 1].
struct Runs {
    std::vector<Run> runs;
    std::vector<std::size_t> first_run;
};

Runs find_runs(Plant const& plant)
{
    Runs found;
    found.runs.reserve(plant.axes.size());
    found.first_run.reserve(plant.axes.size() + 1);
    for (auto const& axis : plant.axes) {
        found.first_run.push_back(found.runs.size());
        SegmentId const end = axis.first_segment + axis.segment_count;
        for (SegmentId segment = axis.first_segment; segment < end; ++segment) {
            auto const material = plant.segment_material[segment];
            if (segment == axis.first_segment || material != found.runs.back().material)
                found.runs.push_back({ .end_segment = segment, .material = material });
            found.runs.back().end_segment = segment + 1;
        }
    }
    found.first_run.push_back(found.runs.size());
    return found;
}

// Calls `use(run, part)` for each run of an axis that has any length.
template<typename Use> void for_each_part(Spine const& spine, std::span<Run> runs, Use const& use)
{
    std::size_t first = 0;
    for (auto& run : runs) {
        std::size_t last = first;
        while (last + 1 < spine.stations.size()
               && spine.stations[last + 1].segment < run.end_segment)
            ++last;
        if (last > first)
            use(run, TubePart { first, last });
        first = last;
    }
}

// What a task needs for one axis after another, allocated once.
struct Scratch {
    Spine spine;
    std::vector<Section> sections;
};

// Traces every axis and calls `use(scratch, its runs)`, on all threads.
template<typename Use>
void for_each_axis(Plant const& plant, MeshOptions const& options, Runs& runs, Use const& use)
{
    double const thickest = plant.node_radius_mm.empty()
        ? 0
        : *std::max_element(plant.node_radius_mm.begin(), plant.node_radius_mm.end());
    parallel_for(plant.axes.size(), kAxesPerTask, [&](std::size_t begin, std::size_t end) {
        Scratch scratch;
        for (auto i = begin; i != end; ++i) {
            trace_spine(plant, plant.axes[i], options, thickest, scratch.spine);
            auto const first = runs.first_run[i];
            use(scratch, std::span(runs.runs).subspan(first, runs.first_run[i + 1] - first));
        }
    });
}

// Gives every run its place; answers each material's total.
std::vector<MeshExtent> place_runs(std::vector<Run>& runs, std::size_t material_count)
{
    std::vector<MeshExtent> totals(material_count);
    for (auto& run : runs) {
        auto& total = totals[run.material];
        run.at = total;
        total.vertices += run.extent.vertices;
        total.indices += run.extent.indices;
    }
    return totals;
}

// One surface per material, with room for `totals`.
std::vector<TriangleMesh> allocate_surfaces(std::vector<MeshExtent> const& totals)
{
    std::vector<TriangleMesh> surfaces(totals.size());
    for (std::size_t i = 0; i < totals.size(); ++i) {
        CHECK(totals[i].vertices <= std::numeric_limits<std::uint32_t>::max());
        surfaces[i].material = static_cast<MaterialId>(i);
        surfaces[i].positions_mm.resize(totals[i].vertices);
        surfaces[i].normals.resize(totals[i].vertices);
        surfaces[i].texture_coordinates.resize(totals[i].vertices);
        surfaces[i].indices.resize(totals[i].indices);
    }
    return surfaces;
}

std::vector<TriangleMesh> make_tubes(Plant const& plant, MeshOptions const& options)
{
    auto runs = find_runs(plant);
    for_each_axis(plant, options, runs, [](Scratch const& scratch, std::span<Run> of_axis) {
        for_each_part(scratch.spine, of_axis, [&](Run& run, TubePart const& part) {
            run.extent = tube_extent(scratch.spine, part);
        });
    });
    auto surfaces = allocate_surfaces(place_runs(runs.runs, plant.materials.size()));
    for_each_axis(plant, options, runs, [&](Scratch& scratch, std::span<Run> of_axis) {
        if (scratch.spine.stations.empty())
            return;
        frame_sections(scratch.spine, scratch.sections);
        for_each_part(scratch.spine, of_axis, [&](Run const& run, TubePart const& part) {
            write_tube(scratch.spine, scratch.sections, part, run.at, surfaces[run.material]);
        });
    });
    return surfaces;
}

InstanceTransform transform_of(Organ const& organ)
{
    double const length = organ.orientation.norm();
    return { organ.position_mm.cast<float>(),
             length > 0 ? organ.orientation.normalized().cast<float>() : Quatf::Identity(),
             organ.scale };
}

std::vector<InstancedMesh> make_organs(Plant const& plant)
{
    std::vector<InstancedMesh> organs(plant.organ_shapes.size());
    for (auto const& organ : plant.organs)
        organs[organ.shape].instances.push_back(transform_of(organ));
    for (std::size_t i = 0; i < organs.size(); ++i)
        if (!organs[i].instances.empty())
            organs[i].prototype = organ_mesh(plant.organ_shapes[i]);
    std::erase_if(organs,
                  [](InstancedMesh const& organ) { return organ.prototype.indices.empty(); });
    return organs;
}

} // namespace

Mesh make_mesh(Plant const& plant, MeshOptions const& options)
{
    CHECK(options.min_sides >= 3 && options.min_sides <= 64);
    CHECK(options.max_sides >= options.min_sides && options.max_sides <= 64);
    CHECK(options.subdivision >= 0 && options.subdivision <= 16 && options.collar >= 0);
    Mesh mesh;
    mesh.materials = plant.materials;
    mesh.surfaces = make_tubes(plant, options);
    for (auto const& polygon : plant.polygons)
        append_polygon(std::span(plant.polygon_vertices_mm)
                           .subspan(polygon.first_vertex, polygon.vertex_count),
                       mesh.surfaces[polygon.material]);
    std::erase_if(mesh.surfaces,
                  [](TriangleMesh const& surface) { return surface.indices.empty(); });
    mesh.organs = make_organs(plant);
    return mesh;
}

} // namespace tractus
