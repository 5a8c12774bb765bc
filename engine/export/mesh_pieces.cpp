#include "engine/export/mesh_pieces.h"

#include "engine/base/check.h"

#include <utility>

namespace tractus {
namespace {

constexpr std::size_t kPieceVertices = 12 << 10;

// What lies before a piece if all are of one size.
MeshExtent start_of(MeshPieces::Surface const& surface, std::size_t piece)
{
    return { surface.extent.vertices * piece / surface.piece_count,
             surface.extent.indices * piece / surface.piece_count };
}

} // namespace

TriangleView view_of(TriangleMesh const& mesh)
{
    return { mesh.positions_mm, mesh.normals, mesh.texture_coordinates, mesh.indices };
}

MeshPieces::MeshPieces(MeshSource const& source)
{
    auto const* const to_mesh = std::get_if<PlantToMesh>(&source);
    if (auto const* const draw = std::get_if<std::function<Billboard()>>(&source)) {
        auto billboard = (*draw)();
        use_mesh(made_.emplace(billboard_mesh(billboard)));
        picture_png_ = std::move(billboard.atlas_png);
    } else if (!to_mesh) {
        use_mesh(mesh_of(source, made_));
    } else if (auto const* const grow = std::get_if<std::function<Plant()>>(&to_mesh->plant)) {
        use_plant(grown_.emplace((*grow)()), *to_mesh);
    } else {
        auto const* const plant = std::get<Plant const*>(to_mesh->plant);
        CHECK(plant);
        use_plant(*plant, *to_mesh);
    }
}

void MeshPieces::use_mesh(Mesh const& mesh)
{
    mesh_ = &mesh;
    for (auto const& surface : mesh.surfaces)
        surfaces_.push_back(
            { surface.material,
              { surface.positions_mm.size(), surface.indices.size() },
              (surface.positions_mm.size() + kPieceVertices - 1) / kPieceVertices });
}

void MeshPieces::use_plant(Plant const& plant, PlantToMesh const& source)
{
    plant_ = &plant;
    plan_.emplace(plant, source.options);
    organs_ = make_organs(plant, source.options);
    wind_ = source.wind;
    organ_wind_.resize(plant.organ_shapes.size());
    if (wind_)
        for (auto const& organ : plant.organs)
            organ_wind_[organ.shape].push_back(wind_at(plant, organ.segment, *wind_));
    for (auto const& surface : plan_->surfaces())
        surfaces_.push_back({ surface.material, surface.extent, surface.piece_count() });
}

std::span<InstancedMesh const> MeshPieces::organs() const
{
    return mesh_ ? mesh_->organs : organs_;
}

Material const& MeshPieces::material(MaterialId id) const
{
    return mesh_ ? mesh_->materials[id] : plant_->materials[id];
}

std::uint64_t MeshPieces::triangle_count() const
{
    std::uint64_t count = 0;
    for (auto const& surface : surfaces_)
        count += surface.extent.indices / 3;
    for (auto const& organ : organs())
        count += organ.prototype.triangle_count() * organ.instances.size();
    return count;
}

Bounds MeshPieces::bounds_mm() const
{
    if (plan_)
        return plan_->bounds_mm();
    Bounds bounds;
    for (auto const& surface : mesh_->surfaces)
        for (auto const& position : surface.positions_mm)
            bounds.add(position.cast<double>());
    return bounds;
}

void MeshPieces::wind(std::size_t surface, std::size_t piece, std::vector<WindVertex>& buffer) const
{
    buffer.clear();
    if (!wind_)
        return;
    auto const& planned = plan_->surfaces()[surface];
    buffer.resize(planned.extent_of(piece).vertices);
    plan_->make_wind(planned, piece, *wind_, buffer);
}

std::span<WindVertex const> MeshPieces::organ_wind(std::size_t organ) const
{
    if (!wind_)
        return {};
    return organ_wind_[organs_[organ].shape];
}

TriangleView MeshPieces::piece(std::size_t surface, std::size_t piece, TriangleMesh& buffer) const
{
    if (mesh_) {
        auto const start = start_of(surfaces_[surface], piece);
        auto const end = start_of(surfaces_[surface], piece + 1);
        auto const whole = view_of(mesh_->surfaces[surface]);
        auto const vertices = end.vertices - start.vertices;
        return { whole.positions_mm.subspan(start.vertices, vertices),
                 whole.normals.subspan(start.vertices, vertices),
                 whole.texture_coordinates.subspan(start.vertices, vertices),
                 whole.indices.subspan(start.indices, end.indices - start.indices) };
    }
    auto const& planned = plan_->surfaces()[surface];
    auto const extent = planned.extent_of(piece);
    buffer.positions_mm.resize(extent.vertices);
    buffer.normals.resize(extent.vertices);
    buffer.texture_coordinates.resize(extent.vertices);
    buffer.indices.resize(extent.indices);
    auto place = place_in(buffer, {});
    place.vertex = static_cast<std::uint32_t>(planned.start_of(piece).vertices);
    plan_->make_piece(planned, piece, place);
    return view_of(buffer);
}

} // namespace tractus
