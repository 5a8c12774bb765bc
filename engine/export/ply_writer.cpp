#include "engine/export/ply_writer.h"

#include "engine/export/binary_stream.h"
#include "engine/mesh/organ_copy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <vector>

namespace tractus::exports {

namespace {

Result<void> write_ply_header(std::ostream& out, std::size_t vertices, std::size_t triangles)
{
    if (std::max(vertices, triangles) > std::numeric_limits<std::int32_t>::max())
        return fail(Fault::User,
                    "a PLY file cannot have more than 2,147,483,647 vertices or triangles");
    out << fmt::format("ply\n"
                       "format binary_little_endian 1.0\n"
                       "comment tractus: millimetres, z up\n"
                       "element vertex {}\n"
                       "property float x\nproperty float y\nproperty float z\n"
                       "property float nx\nproperty float ny\nproperty float nz\n"
                       "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                       "element face {}\n"
                       "property list uchar int vertex_indices\n"
                       "end_header\n",
                       vertices, triangles);
    return {};
}

using VertexColor = std::array<std::uint8_t, 3>;

VertexColor vertex_color(Material const& material)
{
    VertexColor color {};
    for (int k = 0; k < 3; ++k)
        color[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(
            std::lround(255 * std::clamp(material.base_color[k], 0.0f, 1.0f)));
    return color;
}

void write_vertex(BinaryStream& to, Vec3f const& position, Vec3f const& normal,
                  VertexColor const& color)
{
    to.write_vector(position);
    to.write_vector(normal);
    to.write_vector(color);
}

void write_face(BinaryStream& to, std::array<std::uint32_t, 3> const& corners)
{
    to.write(std::uint8_t { 3 });
    to.write_vector(corners);
}

Result<void> check_ply(std::ostream& out)
{
    if (!out.flush())
        return fail(Fault::User,
                    "cannot write the PLY file: the disk is full or the stream failed");
    return {};
}

// The unit normals of vertices: the mean of those of their triangles, weighted by area.
std::vector<Vec3f> smooth_normals(mesh::ClosedMesh const& mesh)
{
    auto const& at = mesh.positions_mm;
    std::vector<Vec3f> normals(at.size(), Vec3f::Zero());
    for (auto const& triangle : mesh.triangles) {
        Vec3f const side = at[triangle[1]] - at[triangle[0]];
        Vec3f const area = side.cross(Vec3f(at[triangle[2]] - at[triangle[0]]));
        for (auto const vertex : triangle)
            normals[vertex] += area;
    }
    for (auto& normal : normals) {
        float const length = normal.norm();
        normal = length > 0 ? Vec3f(normal / length) : Vec3f::UnitZ();
    }
    return normals;
}

} // namespace

Result<void> write_ply(std::ostream& out, mesh::Mesh const& mesh)
{
    std::vector<mesh::TriangleMesh> merged;
    merged.reserve(mesh.organs.size());
    std::vector<mesh::TriangleMesh const*> parts;
    for (auto const& surface : mesh.surfaces)
        parts.push_back(&surface);
    for (auto const& organ : mesh.organs)
        parts.push_back(&merged.emplace_back(mesh::merged_copies(organ)));
    std::size_t vertices = 0;
    for (auto const* const part : parts)
        vertices += part->positions_mm.size();
    TRY(write_ply_header(out, vertices, mesh.triangle_count()));
    {
        BinaryStream to(out);
        for (auto const* const part : parts) {
            auto const color = vertex_color(mesh.materials[part->material]);
            for (std::size_t i = 0; i < part->positions_mm.size(); ++i)
                write_vertex(to, part->positions_mm[i], part->normals[i], color);
        }
        std::uint32_t first = 0;
        for (auto const* const part : parts) {
            auto const& indices = part->indices;
            for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
                write_face(to,
                           { first + indices[i], first + indices[i + 1], first + indices[i + 2] });
            first += static_cast<std::uint32_t>(part->positions_mm.size());
        }
    }
    return check_ply(out);
}

Result<void> write_ply(std::ostream& out, mesh::ClosedMesh const& mesh,
                       std::span<Material const> materials)
{
    TRY(write_ply_header(out, mesh.positions_mm.size(), mesh.triangles.size()));
    std::vector<VertexColor> colors;
    for (auto const& material : materials)
        colors.push_back(vertex_color(material));
    auto const normals = smooth_normals(mesh);
    {
        BinaryStream to(out);
        for (std::size_t i = 0; i < normals.size(); ++i)
            write_vertex(to, mesh.positions_mm[i], normals[i], colors[mesh.materials[i]]);
        for (auto const& triangle : mesh.triangles)
            write_face(to, triangle);
    }
    return check_ply(out);
}

} // namespace tractus::exports
