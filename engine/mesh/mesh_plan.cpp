#include "engine/mesh/mesh_plan.h"

#include "engine/base/check.h"
#include "engine/base/parallel.h"
#include "engine/mesh/extrusion.h"
#include "engine/mesh/polygon_mesh.h"
#include "engine/mesh/section_rings.h"

#include <algorithm>
#include <limits>

namespace tractus::mesh {
namespace {

constexpr std::size_t kAxesPerBlock = 1024;
// Estimated number of a spine's stations per segment, for reserving memory.
constexpr std::size_t kStationsPerSegment = 2;
constexpr std::size_t kPolygonsPerTask = 4096;
// Minimum number of vertices of a piece. They take about half a megabyte, so that the piece stays
// in the cache until it is written to a file.
constexpr std::size_t kPieceVertices = 12 << 10;

// A future MeshPlan::Item, whose place in its surface is not known yet.
struct Planned {
    MaterialId material;
    std::uint32_t number;
    TubePart part;
    std::uint32_t vertices;
    std::uint32_t indices;
};

// Calls use(material, part) for each range of an axis' stations in which the material is the same.
// Ranges of only one station are skipped.
template<typename Stations, typename Use>
void for_each_part(Plant const& plant, Axis const& axis, Stations const& stations, Use const& use)
{
    auto const* const materials = plant.segment_material.data();
    SegmentId const end = axis.first_segment + axis.segment_count;
    std::uint32_t first = 0;
    for (SegmentId segment = axis.first_segment; segment < end;) {
        auto const material = materials[segment];
        while (segment < end && materials[segment] == material)
            ++segment;
        auto last = first;
        while (last + 1 < stations.size() && stations[last + 1].segment < segment)
            ++last;
        if (last > first)
            use(material, TubePart { first, last });
        first = last;
    }
}

// The planned items of one block of consecutive axes, and a box around them.
struct Block {
    std::vector<Planned> items;
    Bounds bounds_mm;
};

// Adds to `bounds` a ball around each section of an axis; the ball of the last section also
// contains the dome. `reach`: greatest distance of a section's outline from its centre, for radius
// 1. `overhang_mm` is added to it.
template<typename Stations>
void add_sections(Stations const& stations, double reach, double overhang_mm, Bounds& bounds)
{
    for (auto const& station : stations) {
        auto const center = station.center_mm.array();
        double const radius = reach * station.radius_mm + overhang_mm;
        bounds.min_mm = bounds.min_mm.cwiseMin((center - radius).matrix());
        bounds.max_mm = bounds.max_mm.cwiseMax((center + radius).matrix());
    }
}

double reach_of(std::vector<Contour> const& contours)
{
    float reach = 1;
    for (auto const& contour : contours)
        for (auto const& point : contour.points)
            reach = std::max(reach, point.norm());
    return reach;
}

void place(MeshPlan::Surface& surface, Planned const& item)
{
    surface.items.push_back({ item.number, item.part,
                              static_cast<std::uint32_t>(surface.extent.vertices),
                              surface.extent.indices });
    surface.extent += { item.vertices, item.indices };
    CHECK(surface.extent.vertices <= std::numeric_limits<std::uint32_t>::max());
}

void cut_into_pieces(MeshPlan::Surface& surface)
{
    std::size_t end = 0; // Vertex index at which the current piece ends.
    for (std::uint32_t i = 0; i < surface.items.size(); ++i)
        if (surface.items[i].first_vertex >= end) {
            surface.pieces.push_back(i);
            end = surface.items[i].first_vertex + kPieceVertices;
        }
    surface.pieces.push_back(static_cast<std::uint32_t>(surface.items.size()));
}

std::span<Vec3 const> vertices_of(Plant const& plant, Polygon const& polygon)
{
    return std::span(plant.polygon_vertices_mm).subspan(polygon.first_vertex, polygon.vertex_count);
}

} // namespace

MeshExtent MeshPlan::Surface::start_of(std::size_t piece) const
{
    auto const item = pieces[piece];
    return item == items.size() ? extent
                                : MeshExtent { items[item].first_vertex, items[item].first_index };
}

MeshExtent MeshPlan::Surface::extent_of(std::size_t piece) const
{
    auto const start = start_of(piece);
    auto const end = start_of(piece + 1);
    return { end.vertices - start.vertices, end.indices - start.indices };
}

MeshPlan::MeshPlan(Plant const& plant, MeshOptions const& options, std::stop_token const& stop)
    : plant_(plant)
    , options_(options)
    , surfaces_(plant.materials.size())
{
    CHECK(options.min_sides >= 3 && options.min_sides <= 64);
    CHECK(options.max_sides >= options.min_sides && options.max_sides <= 64);
    CHECK(options.subdivision >= 0 && options.subdivision <= 16 && options.collar >= 0);
    if (!plant.node_radius_mm.empty())
        thickest_mm_ = *std::max_element(plant.node_radius_mm.begin(), plant.node_radius_mm.end());
    for (std::size_t i = 0; i < surfaces_.size(); ++i)
        surfaces_[i].material = static_cast<MaterialId>(i);
    trace_axes(stop);
    if (stop.stop_requested()) {
        surfaces_.clear();
        return;
    }
    plan_tubes();
    for (auto& surface : surfaces_)
        surface.tube_count = surface.items.size();
    plan_polygons();
    std::erase_if(surfaces_, [](Surface const& surface) { return surface.items.empty(); });
    for (auto& surface : surfaces_)
        cut_into_pieces(surface);
}

void MeshPlan::trace_axes(std::stop_token const& stop)
{
    auto const& axes = plant_.axes;
    spines_.resize(axes.size());
    stations_.resize((axes.size() + kAxesPerBlock - 1) / kAxesPerBlock);
    auto const segments_between = [&](std::size_t first, std::size_t last) {
        return (last < axes.size() ? axes[last].first_segment : plant_.segment_count())
            - axes[first].first_segment;
    };
    parallel_for(stations_.size(), 1, [&](std::size_t begin, std::size_t end) {
        SpineBuffers room;
        for (auto block = begin; block != end && !stop.stop_requested(); ++block) {
            auto& stations = stations_[block];
            auto const last = std::min(axes.size(), (block + 1) * kAxesPerBlock);
            stations.reserve(kStationsPerSegment * segments_between(block * kAxesPerBlock, last));
            for (auto i = block * kAxesPerBlock; i != last; ++i) {
                if (has_contour(plant_, axes[i]))
                    continue;
                spines_[i] = trace_spine(plant_, axes[i], options_, thickest_mm_, room);
                stations.insert(stations.end(), room.stations.begin(), room.stations.end());
            }
            std::span<SpineStation const> left = stations;
            for (auto i = block * kAxesPerBlock; i != last; ++i) {
                auto& own = spines_[i].stations;
                own = left.first(own.size());
                left = left.subspan(own.size());
            }
        }
    });
}

void MeshPlan::plan_tubes()
{
    auto const& axes = plant_.axes;
    double const reach = reach_of(plant_.contours);
    std::vector<Block> blocks(stations_.size());
    parallel_for(blocks.size(), 1, [&](std::size_t begin, std::size_t end) {
        Extrusion extrusion;
        for (auto block = begin; block != end; ++block) {
            auto& planned = blocks[block].items;
            planned.reserve(kAxesPerBlock);
            auto const last = std::min(axes.size(), (block + 1) * kAxesPerBlock);
            for (auto i = block * kAxesPerBlock; i != last; ++i) {
                auto const plan = [&](MaterialId material, TubePart part, MeshExtent const& size) {
                    planned.push_back({ material, static_cast<std::uint32_t>(i), part,
                                        static_cast<std::uint32_t>(size.vertices),
                                        static_cast<std::uint32_t>(size.indices) });
                };
                if (has_contour(plant_, axes[i])) {
                    trace_extrusion(plant_, axes[i], options_, extrusion);
                    add_sections(extrusion.stations, reach, 0, blocks[block].bounds_mm);
                    for_each_part(plant_, axes[i], extrusion.stations,
                                  [&](MaterialId material, TubePart part) {
                                      plan(material, part,
                                           extrusion_extent(plant_, extrusion, part));
                                  });
                    continue;
                }
                auto const& spine = spines_[i];
                add_sections(spine.stations, 1, spine.overhang_mm, blocks[block].bounds_mm);
                for_each_part(plant_, axes[i], spine.stations,
                              [&](MaterialId material, TubePart part) {
                                  plan(material, part, tube_extent(spine, part));
                              });
            }
        }
    });
    std::vector<std::size_t> counts(surfaces_.size());
    for (auto const& block : blocks) {
        bounds_mm_.min_mm = bounds_mm_.min_mm.cwiseMin(block.bounds_mm.min_mm);
        bounds_mm_.max_mm = bounds_mm_.max_mm.cwiseMax(block.bounds_mm.max_mm);
        for (auto const& item : block.items)
            ++counts[item.material];
    }
    for (std::size_t i = 0; i < counts.size(); ++i)
        surfaces_[i].items.reserve(counts[i]);
    for (auto const& block : blocks)
        for (auto const& item : block.items)
            place(surfaces_[item.material], item);
}

void MeshPlan::plan_polygons()
{
    auto const& polygons = plant_.polygons;
    std::vector<MeshExtent> extents(polygons.size());
    parallel_for(polygons.size(), kPolygonsPerTask, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i != end; ++i)
            extents[i] = polygon_extent(vertices_of(plant_, polygons[i]));
    });
    for (auto const& vertex : plant_.polygon_vertices_mm)
        bounds_mm_.add(vertex);
    for (std::uint32_t i = 0; i < polygons.size(); ++i)
        if (extents[i].vertices > 0)
            place(surfaces_[polygons[i].material],
                  { polygons[i].material,
                    i,
                    {},
                    static_cast<std::uint32_t>(extents[i].vertices),
                    static_cast<std::uint32_t>(extents[i].indices) });
}

void MeshPlan::make_piece(Surface const& surface, std::size_t piece, TrianglePlace to) const
{
    std::vector<Section> sections;
    Extrusion extrusion;
    for (auto i = surface.pieces[piece]; i != surface.pieces[piece + 1]; ++i) {
        auto const& item = surface.items[i];
        if (i >= surface.tube_count) {
            write_polygon(vertices_of(plant_, plant_.polygons[item.number]), to);
            continue;
        }
        auto const& axis = plant_.axes[item.number];
        if (has_contour(plant_, axis)) {
            trace_extrusion(plant_, axis, options_, extrusion);
            write_extrusion(plant_, extrusion, item.part, to);
            continue;
        }
        auto const& spine = spines_[item.number];
        frame_sections(spine, sections);
        write_tube(spine, sections, item.part, to);
    }
}

void MeshPlan::make_wind(Surface const& surface, std::size_t piece, WindKey const& key,
                         std::span<WindVertex> to) const
{
    Extrusion extrusion;
    for (auto i = surface.pieces[piece]; i != surface.pieces[piece + 1]; ++i) {
        auto const& item = surface.items[i];
        auto const end = i + 1 < surface.items.size() ? surface.items[i + 1].first_vertex
                                                      : surface.extent.vertices;
        auto const vertices = to.first(end - item.first_vertex);
        to = to.subspan(vertices.size());
        if (i >= surface.tube_count) {
            auto const segment = plant_.polygons[item.number].segment;
            std::fill(vertices.begin(), vertices.end(), wind_at(plant_, segment, key));
            continue;
        }
        auto const& axis = plant_.axes[item.number];
        std::fill(vertices.begin(), vertices.end(), wind_of(plant_, axis, key));
        if (has_contour(plant_, axis)) {
            trace_extrusion(plant_, axis, options_, extrusion);
            bend_extrusion(extrusion, item.part, vertices);
            continue;
        }
        bend_tube(spines_[item.number], item.part, vertices);
    }
}

void MeshPlan::find_rings(Surface const& surface, std::size_t piece, std::vector<Ring>& rings) const
{
    Extrusion extrusion;
    auto const end_of_tubes = static_cast<std::uint32_t>(surface.tube_count);
    for (auto i = surface.pieces[piece]; i < std::min(surface.pieces[piece + 1], end_of_tubes);
         ++i) {
        auto const& item = surface.items[i];
        auto const end = i + 1 < surface.items.size() ? surface.items[i + 1].first_vertex
                                                      : surface.extent.vertices;
        auto vertex = item.first_vertex;
        auto const add_from = [&](auto const& stations) {
            return [&](std::uint32_t station, std::size_t count) {
                auto const size = static_cast<std::uint32_t>(count);
                rings.push_back(
                    { stations[station].center_mm, stations[station].segment, vertex, size });
                vertex += size;
            };
        };
        auto const& axis = plant_.axes[item.number];
        if (has_contour(plant_, axis)) {
            trace_extrusion(plant_, axis, options_, extrusion);
            for_each_ring(extrusion, item.part, end - vertex, add_from(extrusion.stations));
            continue;
        }
        auto const& spine = spines_[item.number];
        for_each_ring(spine, item.part, end - vertex, add_from(spine.stations));
    }
}

std::vector<TriangleMesh> make_surfaces(MeshPlan const& plan, std::stop_token const& stop)
{
    std::vector<TriangleMesh> made;
    for (auto const& surface : plan.surfaces()) {
        if (stop.stop_requested())
            break;
        auto& mesh = made.emplace_back();
        mesh.material = surface.material;
        mesh.positions_mm.resize(surface.extent.vertices);
        mesh.normals.resize(surface.extent.vertices);
        mesh.texture_coordinates.resize(surface.extent.vertices);
        mesh.indices.resize(surface.extent.indices);
        parallel_for(surface.piece_count(), 1, [&](std::size_t begin, std::size_t end) {
            for (auto piece = begin; piece != end && !stop.stop_requested(); ++piece)
                plan.make_piece(surface, piece, place_in(mesh, surface.start_of(piece)));
        });
    }
    return made;
}

} // namespace tractus::mesh
