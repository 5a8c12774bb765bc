#include "engine/export/mesh_pieces.h"

#include "engine/base/check.h"
#include "engine/export/tangents.h"
#include "engine/export/texture.h"
#include "engine/mesh/organ_copy.h"

#include <algorithm>
#include <utility>

namespace tractus::exports {
namespace {

constexpr std::size_t kPieceVertices = 12 << 10;
// Number of MeshPlan's pieces in a piece of Cut::OwnMeshes. It then has about as many vertices as
// 16-bit indices can address.
constexpr std::size_t kPiecesOfOwnMesh = 4;

// A range of an organ's copies: from `first` to before `end`.
struct Copies {
    std::size_t first = 0;
    std::size_t end = 0;
};

Copies copies_in(std::size_t count, std::size_t piece, std::size_t piece_count)
{
    return { count * piece / piece_count, count * (piece + 1) / piece_count };
}

// Adds to `bounds` a box around each copy of the organ.
void add_copies(mesh::InstancedMesh const& organ, Bounds& bounds)
{
    Eigen::AlignedBox3f box;
    for (auto const& position : organ.prototype.positions_mm)
        box.extend(position);
    for (auto const& instance : organ.instances) {
        Eigen::Matrix3f const rotation = instance.rotation.toRotationMatrix();
        Vec3f const center = instance.scale.cwiseProduct(box.center());
        Vec3f const half = 0.5f * instance.scale.cwiseAbs().cwiseProduct(box.sizes());
        Vec3f const middle = rotation * center + instance.translation_mm;
        Vec3f const reach = rotation.cwiseAbs() * half;
        bounds.add((middle - reach).cast<double>());
        bounds.add((middle + reach).cast<double>());
    }
}

} // namespace

TriangleView view_of(mesh::TriangleMesh const& mesh, std::uint32_t first_vertex)
{
    return { .positions_mm = mesh.positions_mm,
             .normals = mesh.normals,
             .texture_coordinates = mesh.texture_coordinates,
             .indices = mesh.indices,
             .first_vertex = first_vertex };
}

MeshPieces::MeshPieces(MeshSource const& source, Organs organs, Tangents tangents, Cut cut)
    : is_merged_(organs == Organs::Merged)
    , has_own_meshes_(cut == Cut::OwnMeshes)
    , has_tangents_(tangents == Tangents::ForRelief)
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
    if (is_merged_)
        merge_organs();
}

// Returns the tangents of a surface in memory. A vertex and its triangles may be in different
// pieces, so all tangents are computed at once. This is done when a piece is first requested, since
// callers that only need a file's size request no pieces.
std::span<Eigen::Vector4f const> MeshPieces::tangents_of_mesh(std::size_t surface) const
{
    std::call_once(mesh_tangents_found_, [&] {
        mesh_tangents_.resize(mesh_->surfaces.size());
        for (std::size_t i = 0; i < mesh_->surfaces.size(); ++i)
            if (has_tangents(mesh_->surfaces[i].material))
                find_tangents(view_of(mesh_->surfaces[i]), mesh_tangents_[i]);
    });
    return mesh_tangents_[surface];
}

void MeshPieces::use_mesh(mesh::Mesh const& mesh)
{
    mesh_ = &mesh;
    for (auto const& surface : mesh.surfaces)
        add_surface(surface.material, { surface.positions_mm.size(), surface.indices.size() },
                    (surface.positions_mm.size() + piece_vertices() - 1) / piece_vertices());
}

void MeshPieces::use_plant(Plant const& plant, PlantToMesh const& source)
{
    plant_ = &plant;
    plan_.emplace(plant, source.options);
    organs_ = mesh::make_organs(plant, source.options);
    wind_ = source.wind;
    organ_wind_.resize(plant.organ_shapes.size());
    if (wind_)
        for (auto const& organ : plant.organs)
            organ_wind_[organ.shape].push_back(mesh::wind_at(plant, organ.segment, *wind_));
    for (auto const& surface : plan_->surfaces())
        add_surface(surface.material, surface.extent,
                    has_own_meshes_
                        ? (surface.piece_count() + kPiecesOfOwnMesh - 1) / kPiecesOfOwnMesh
                        : surface.piece_count());
}

std::size_t MeshPieces::piece_vertices() const
{
    return has_own_meshes_ ? kPiecesOfOwnMesh * kPieceVertices : kPieceVertices;
}

std::size_t MeshPieces::planned_piece(std::size_t piece, std::size_t planned_pieces) const
{
    return std::min(has_own_meshes_ ? kPiecesOfOwnMesh * piece : piece, planned_pieces);
}

void MeshPieces::add_surface(MaterialId material, mesh::MeshExtent const& extent,
                             std::size_t piece_count)
{
    runs_.push_back({ { Run::Of::Surface, surfaces_.size(), 0, piece_count, {} } });
    surfaces_.push_back({ material, extent, piece_count });
}

// Appends the pieces of each organ to the surface with the organ's material, or to a new surface.
void MeshPieces::merge_organs()
{
    auto const organs = all_organs();
    for (std::size_t i = 0; i < organs.size(); ++i) {
        auto const& [prototype, instances, shape] = organs[i];
        if (instances.empty() || prototype.indices.empty())
            continue;
        auto const known = std::find_if(surfaces_.begin(), surfaces_.end(),
                                        [&material = prototype.material](Surface const& surface) {
                                            return surface.material == material;
                                        });
        auto const at = static_cast<std::size_t>(known - surfaces_.begin());
        if (known == surfaces_.end()) {
            surfaces_.push_back({ prototype.material, {}, 0 });
            runs_.emplace_back();
        }
        auto& [material, extent, piece_count] = surfaces_[at];
        mesh::MeshExtent const added { prototype.positions_mm.size() * instances.size(),
                                       prototype.indices.size() * instances.size() };
        auto const pieces = std::min((added.vertices + piece_vertices() - 1) / piece_vertices(),
                                     instances.size());
        runs_[at].push_back({ Run::Of::Organ, i, piece_count, pieces, extent });
        extent.vertices += added.vertices;
        extent.indices += added.indices;
        piece_count += pieces;
    }
}

std::span<mesh::InstancedMesh const> MeshPieces::organs() const
{
    return is_merged_ ? std::span<mesh::InstancedMesh const>() : all_organs();
}

// Returns the run that contains the piece: the last one that begins at or before the piece. Runs
// before it that begin at the same piece are empty.
MeshPieces::Run const& MeshPieces::run_of(std::size_t surface, std::size_t piece) const
{
    auto const& runs = runs_[surface];
    auto const after
        = std::upper_bound(runs.begin(), runs.end(), piece, [](std::size_t wanted, Run const& run) {
              return wanted < run.first_piece;
          });
    return *std::prev(after);
}

Material const& MeshPieces::material(MaterialId id) const
{
    return mesh_ ? mesh_->materials[id] : plant_->materials[id];
}

bool MeshPieces::has_tangents(MaterialId id) const
{
    return has_tangents_ && picture_png_.empty() && has_relief(material(id));
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
    Bounds bounds;
    if (plan_)
        bounds = plan_->bounds_mm();
    else
        for (auto const& surface : mesh_->surfaces)
            for (auto const& position : surface.positions_mm)
                bounds.add(position.cast<double>());
    if (is_merged_)
        for (auto const& organ : all_organs())
            if (!organ.prototype.positions_mm.empty())
                add_copies(organ, bounds);
    return bounds;
}

void MeshPieces::wind(std::size_t surface, std::size_t piece,
                      std::vector<mesh::WindVertex>& buffer) const
{
    buffer.clear();
    if (!wind_)
        return;
    auto const& run = run_of(surface, piece);
    if (run.of == Run::Of::Organ)
        return organ_piece_wind(run, piece - run.first_piece, buffer);
    auto const& planned = plan_->surfaces()[run.index];
    auto const first = planned_piece(piece, planned.piece_count());
    auto const end = planned_piece(piece + 1, planned.piece_count());
    auto const start = planned.start_of(first).vertices;
    buffer.resize(planned.start_of(end).vertices - start);
    for (auto i = first; i < end; ++i)
        plan_->make_wind(planned, i, *wind_,
                         std::span(buffer).subspan(planned.start_of(i).vertices - start,
                                                   planned.extent_of(i).vertices));
}

void MeshPieces::organ_piece_wind(Run const& run, std::size_t piece,
                                  std::vector<mesh::WindVertex>& buffer) const
{
    auto const& organ = organs_[run.index];
    auto const copies = copies_in(organ.instances.size(), piece, run.piece_count);
    for (auto i = copies.first; i < copies.end; ++i)
        buffer.insert(buffer.end(), organ.prototype.positions_mm.size(),
                      organ_wind_[organ.shape][i]);
}

std::span<mesh::WindVertex const> MeshPieces::organ_wind(std::size_t organ) const
{
    if (!wind_)
        return {};
    return organ_wind_[organs_[organ].shape];
}

TriangleView MeshPieces::piece(std::size_t surface, std::size_t piece, Buffer& buffer) const
{
    auto const& run = run_of(surface, piece);
    auto triangles = triangles_of(run, piece - run.first_piece, buffer);
    if (triangles.tangents.empty() && has_tangents(surfaces_[surface].material)) {
        find_tangents(triangles, buffer.tangents);
        triangles.tangents = buffer.tangents;
    }
    return triangles;
}

TriangleView MeshPieces::triangles_of(Run const& run, std::size_t piece, Buffer& buffer) const
{
    if (run.of == Run::Of::Organ)
        return organ_piece(run, piece, buffer.triangles);
    if (!mesh_)
        return plan_piece(run, piece, buffer.triangles);
    return has_own_meshes_ ? own_mesh_piece(run, piece, buffer) : mesh_piece(run, piece);
}

TriangleView MeshPieces::mesh_piece(Run const& run, std::size_t piece) const
{
    auto const whole = view_of(mesh_->surfaces[run.index]);
    auto const vertex = whole.positions_mm.size() * piece / run.piece_count;
    auto const vertices = whole.positions_mm.size() * (piece + 1) / run.piece_count - vertex;
    auto const index = whole.indices.size() * piece / run.piece_count;
    auto const indices = whole.indices.size() * (piece + 1) / run.piece_count - index;
    auto const tangents = tangents_of_mesh(run.index);
    return { .positions_mm = whole.positions_mm.subspan(vertex, vertices),
             .normals = whole.normals.subspan(vertex, vertices),
             .texture_coordinates = whole.texture_coordinates.subspan(vertex, vertices),
             .indices = whole.indices.subspan(index, indices),
             .first_vertex = static_cast<std::uint32_t>(vertex),
             .tangents = tangents.empty() ? tangents : tangents.subspan(vertex, vertices) };
}

static void resize(mesh::TriangleMesh& mesh, mesh::MeshExtent const& extent)
{
    mesh.positions_mm.resize(extent.vertices);
    mesh.normals.resize(extent.vertices);
    mesh.texture_coordinates.resize(extent.vertices);
    mesh.indices.resize(extent.indices);
}

// Makes a mesh of some of the surface's triangles. It has only the vertices that these triangles
// use, in the order of the surface.
TriangleView MeshPieces::own_mesh_piece(Run const& run, std::size_t piece, Buffer& buffer) const
{
    auto const whole = view_of(mesh_->surfaces[run.index]);
    auto const tangents = tangents_of_mesh(run.index);
    auto const triangles = copies_in(whole.indices.size() / 3, piece, run.piece_count);
    auto const indices
        = whole.indices.subspan(3 * triangles.first, 3 * (triangles.end - triangles.first));
    std::vector<std::uint32_t> used(indices.begin(), indices.end());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    auto& mesh = buffer.triangles;
    resize(mesh, { used.size(), indices.size() });
    buffer.tangents.resize(tangents.empty() ? 0 : used.size());
    for (std::size_t i = 0; i < used.size(); ++i) {
        mesh.positions_mm[i] = whole.positions_mm[used[i]];
        mesh.normals[i] = whole.normals[used[i]];
        mesh.texture_coordinates[i] = whole.texture_coordinates[used[i]];
        if (!tangents.empty())
            buffer.tangents[i] = tangents[used[i]];
    }
    for (std::size_t i = 0; i < indices.size(); ++i)
        mesh.indices[i] = static_cast<std::uint32_t>(
            std::lower_bound(used.begin(), used.end(), indices[i]) - used.begin());
    auto view = view_of(mesh);
    view.tangents = buffer.tangents;
    return view;
}

TriangleView MeshPieces::plan_piece(Run const& run, std::size_t piece,
                                    mesh::TriangleMesh& buffer) const
{
    auto const& planned = plan_->surfaces()[run.index];
    auto const first = planned_piece(piece, planned.piece_count());
    auto const end = planned_piece(piece + 1, planned.piece_count());
    auto const start = planned.start_of(first);
    auto const until = planned.start_of(end);
    resize(buffer, { until.vertices - start.vertices, until.indices - start.indices });
    auto const first_vertex = has_own_meshes_ ? 0 : static_cast<std::uint32_t>(start.vertices);
    for (auto i = first; i < end; ++i) {
        auto const at = planned.start_of(i);
        auto place
            = mesh::place_in(buffer, { at.vertices - start.vertices, at.indices - start.indices });
        place.vertex += first_vertex;
        plan_->make_piece(planned, i, place);
    }
    return view_of(buffer, first_vertex);
}

TriangleView MeshPieces::organ_piece(Run const& run, std::size_t piece,
                                     mesh::TriangleMesh& buffer) const
{
    auto const& [prototype, instances, shape] = all_organs()[run.index];
    auto const copies = copies_in(instances.size(), piece, run.piece_count);
    auto const vertices = prototype.positions_mm.size();
    auto const count = copies.end - copies.first;
    resize(buffer, { vertices * count, prototype.indices.size() * count });
    auto place = mesh::place_in(buffer, {});
    auto const first_vertex = has_own_meshes_
        ? 0
        : static_cast<std::uint32_t>(run.start.vertices + copies.first * vertices);
    place.vertex = first_vertex;
    for (auto i = copies.first; i < copies.end; ++i)
        mesh::append_copy(prototype, instances[i], place);
    return view_of(buffer, first_vertex);
}

} // namespace tractus::exports
