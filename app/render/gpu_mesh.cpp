#include "app/render/gpu_mesh.h"

#include "engine/base/check.h"
#include "engine/base/random.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tractus {

namespace {

constexpr float kRhombusBelow_px = 11;   // Shorter organs are drawn as rhombi.
constexpr float kSmallestArea_px = 2.5f; // Smaller rhombi are drawn fewer and larger,
constexpr float kSmallestShare = 0.02f;  // but no fewer than this share of them.
constexpr std::uint32_t kShuffleStream = 0x72656e64;

struct InstanceVertex {
    Vec3f translation_mm = Vec3f::Zero();
    std::array<float, 4> rotation {}; // x, y, z, w.
    Vec3f scale = Vec3f::Ones();
    float sky = 1;
};

void float_attribute(GLuint index, GLint size, GLsizei stride, std::size_t offset_bytes)
{
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, stride, gl::offset(offset_bytes));
}

// Uploads one value per vertex into a new buffer of the part, as attribute `index`.
template<typename Value>
void add_vertex_values(GpuMesh::Part& part, GLuint index, std::vector<Value> const& values)
{
    gl::upload(part.buffers.emplace_back(), GL_ARRAY_BUFFER, std::span<Value const>(values));
    float_attribute(index, static_cast<GLint>(sizeof(Value) / sizeof(float)), 0, 0);
}

// Uploads triangles as a vertex array, which stays bound; the part keeps the buffers.
void add_triangles(GpuMesh::Part& part, gl::VertexArray const& vertex_array,
                   TriangleMesh const& triangles)
{
    CHECK(triangles.normals.size() == triangles.positions_mm.size());
    glBindVertexArray(vertex_array.name());
    add_vertex_values(part, 0, triangles.positions_mm);
    add_vertex_values(part, 1, triangles.normals);
    if (triangles.texture_coordinates.size() == triangles.positions_mm.size())
        add_vertex_values(part, 2, triangles.texture_coordinates);
    gl::upload(part.buffers.emplace_back(), GL_ELEMENT_ARRAY_BUFFER,
               std::span<std::uint32_t const>(triangles.indices));
}

bool is_flat(TriangleMesh const& mesh, std::size_t first_index)
{
    auto const& normal = mesh.normals[mesh.indices[first_index]];
    return mesh.normals[mesh.indices[first_index + 1]] == normal
        && mesh.normals[mesh.indices[first_index + 2]] == normal;
}

// How many of a surface's indices are tubes, whose inner sides nobody sees: make_mesh() puts
// polygons, which are flat and have two sides, behind them. Surfaces of unknown origin have none.
GLsizei tube_index_count(Material const& material, TriangleMesh const& surface)
{
    if (material.kind != Material::Kind::Bark && material.kind != Material::Kind::Stem)
        return 0;
    std::size_t count = surface.indices.size();
    while (count >= 3 && is_flat(surface, count - 3))
        count -= 3;
    return static_cast<GLsizei>(count);
}

// The instances as attributes of a vertex array; the buffer may serve several.
void use_instances(gl::VertexArray const& vertex_array, GLuint instances)
{
    glBindVertexArray(vertex_array.name());
    glBindBuffer(GL_ARRAY_BUFFER, instances);
    constexpr GLsizei kStride = sizeof(InstanceVertex);
    float_attribute(4, 3, kStride, offsetof(InstanceVertex, translation_mm));
    float_attribute(5, 4, kStride, offsetof(InstanceVertex, rotation));
    float_attribute(6, 3, kStride, offsetof(InstanceVertex, scale));
    float_attribute(7, 1, kStride, offsetof(InstanceVertex, sky));
    for (GLuint index = 4; index < 8; ++index)
        glVertexAttribDivisor(index, 1);
    glBindVertexArray(0);
}

// In an order that has nothing to do with the plant's, so that the first ones stand for all.
std::vector<InstanceVertex> shuffled_instances(InstancedMesh const& organ, SkyVisibility const& sky)
{
    std::vector<InstanceVertex> instances;
    instances.reserve(organ.instances.size());
    for (auto const& instance : organ.instances) {
        auto const& rotation = instance.rotation;
        instances.push_back({ instance.translation_mm,
                              { rotation.x(), rotation.y(), rotation.z(), rotation.w() },
                              instance.scale,
                              sky.at(instance.translation_mm) });
    }
    Random random({ .seed = 0, .stream = kShuffleStream });
    for (std::size_t left = instances.size(); left > 1; --left)
        std::swap(instances[left - 1], instances[random.next_u64() % left]);
    return instances;
}

float surface_area(TriangleMesh const& mesh)
{
    float area = 0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        auto const& a = mesh.positions_mm[mesh.indices[i]];
        auto const& b = mesh.positions_mm[mesh.indices[i + 1]];
        auto const& c = mesh.positions_mm[mesh.indices[i + 2]];
        area += (b - a).cross(c - a).norm() / 2;
    }
    return area;
}

bool lets_light_through(Material const& material)
{
    return material.kind == Material::Kind::Leaf || material.kind == Material::Kind::Petal;
}

// As organs of ours do (organ_shape.h); others' may not.
bool lies_along_y(TriangleMesh const& prototype)
{
    Bounds box;
    for (auto const& position : prototype.positions_mm)
        box.add(position.cast<double>());
    Vec3 const extent = box.max_mm - box.min_mm;
    return extent.y() > 0.5 * extent.maxCoeff();
}

void add_rhombus(TriangleMesh& mesh, Vec3f const& base, Vec3f const& tip, Vec3f const& half_width)
{
    auto const first = static_cast<std::uint32_t>(mesh.positions_mm.size());
    Vec3f const middle = (base + tip) / 2;
    mesh.positions_mm.insert(mesh.positions_mm.end(),
                             { base, middle + half_width, tip, middle - half_width });
    mesh.normals.insert(mesh.normals.end(), 4, half_width.cross(tip - base).normalized());
    mesh.texture_coordinates.insert(
        mesh.texture_coordinates.end(),
        { Vec2f(0.5f, 0), Vec2f(1, 0.5f), Vec2f(0.5f, 1), Vec2f(0, 0.5f) });
    for (std::uint32_t const corner : { 0u, 1u, 2u, 0u, 2u, 3u })
        mesh.indices.push_back(first + corner);
}

// From the lowest to the highest point along the organ's y, across x. As large as the prototype;
// for a closed one (a needle) two that cross, each as large as what a needle shows to a side, which
// is about a quarter of its surface.
TriangleMesh rhombus_of(TriangleMesh const& prototype, bool closed)
{
    auto const by_y = [](Vec3f const& a, Vec3f const& b) { return a.y() < b.y(); };
    Vec3f const base = *std::ranges::min_element(prototype.positions_mm, by_y);
    Vec3f const tip = *std::ranges::max_element(prototype.positions_mm, by_y);
    float const area = surface_area(prototype) * (closed ? 0.27f : 1.0f);
    float const half_width = area / std::max((tip - base).norm(), 1e-6f);
    TriangleMesh rhombus;
    add_rhombus(rhombus, base, tip, Vec3f(half_width, 0, 0));
    if (closed)
        add_rhombus(rhombus, base, tip, Vec3f(0, 0, half_width));
    return rhombus;
}

// Whether it has no rim: then its area vectors sum to nothing, even where vertices are doubled.
bool is_closed(TriangleMesh const& mesh)
{
    Vec3f sum = Vec3f::Zero();
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        auto const& a = mesh.positions_mm[mesh.indices[i]];
        sum += (mesh.positions_mm[mesh.indices[i + 1]] - a)
                   .cross(mesh.positions_mm[mesh.indices[i + 2]] - a)
            / 2;
    }
    return sum.norm() < 0.05f * surface_area(mesh);
}

Vec3f mean_scale(std::vector<InstanceVertex> const& instances)
{
    Vec3f sum = Vec3f::Zero();
    for (auto const& instance : instances)
        sum += instance.scale;
    return sum / static_cast<float>(instances.size());
}

} // namespace

GpuMesh::GpuMesh(Mesh const& mesh)
    : bounds_(tractus::bounds(mesh))
{
    SkyVisibility const sky(mesh);
    for (auto const& surface : mesh.surfaces)
        if (!surface.indices.empty())
            add_surface(mesh.materials.at(surface.material), surface, sky);
    for (auto const& organ : mesh.organs)
        if (!organ.instances.empty() && !organ.prototype.indices.empty())
            add_organ(mesh.materials.at(organ.prototype.material), organ, sky);
    make_ground_texture(sky);
}

GpuMesh::Part GpuMesh::make_part(Material const& material, TriangleMesh const& triangles)
{
    Part part;
    part.material = material;
    part.index_count = static_cast<GLsizei>(triangles.indices.size());
    add_triangles(part, part.vertex_array, triangles);
    return part;
}

void GpuMesh::add_surface(Material const& material, TriangleMesh const& surface,
                          SkyVisibility const& sky)
{
    auto part = make_part(material, surface);
    part.tube_index_count = tube_index_count(material, surface);
    glBindVertexArray(part.vertex_array.name());
    std::vector<float> visible;
    visible.reserve(surface.positions_mm.size());
    for (auto const& position : surface.positions_mm)
        visible.push_back(sky.at(position));
    add_vertex_values(part, 3, visible);
    glBindVertexArray(0);
    parts_.push_back(std::move(part));
}

void GpuMesh::add_organ(Material const& material, InstancedMesh const& organ,
                        SkyVisibility const& sky)
{
    auto part = make_part(material, organ.prototype);
    auto const instances = shuffled_instances(organ, sky);
    part.instance_count = static_cast<GLsizei>(instances.size());
    gl::upload(part.buffers.emplace_back(), GL_ARRAY_BUFFER,
               std::span<InstanceVertex const>(instances));
    GLuint const instance_buffer = part.buffers.back().name();
    use_instances(part.vertex_array, instance_buffer);
    if (lets_light_through(material) && lies_along_y(organ.prototype)) {
        auto const triangles = rhombus_of(organ.prototype, is_closed(organ.prototype));
        auto const& corners = triangles.positions_mm;
        Vec3f const scale = mean_scale(instances).cwiseAbs();
        auto& rhombus = part.rhombus.emplace();
        rhombus.index_count = static_cast<GLsizei>(triangles.indices.size());
        rhombus.length_mm = (corners[2] - corners[0]).norm() * scale.y();
        rhombus.width_mm = (corners[1] - corners[3]).norm() * scale.x();
        add_triangles(part, rhombus.vertex_array, triangles);
        use_instances(rhombus.vertex_array, instance_buffer);
    }
    parts_.push_back(std::move(part));
}

void GpuMesh::draw(Part const& part, Shader const& shader, float pixel_mm) const
{
    shader.set("instance_growth", Vec3f(1, 1, 1));
    if (part.instance_count == 0) {
        glBindVertexArray(part.vertex_array.name());
        glVertexAttrib3f(4, 0, 0, 0);
        glVertexAttrib4f(5, 0, 0, 0, 1);
        glVertexAttrib3f(6, 1, 1, 1);
        glVertexAttrib1f(7, 1);
        glEnable(GL_CULL_FACE);
        glDrawElements(GL_TRIANGLES, part.tube_index_count, GL_UNSIGNED_INT, nullptr);
        glDisable(GL_CULL_FACE);
        glDrawElements(
            GL_TRIANGLES, part.index_count - part.tube_index_count, GL_UNSIGNED_INT,
            gl::offset(static_cast<std::size_t>(part.tube_index_count) * sizeof(std::uint32_t)));
    } else if (!part.rhombus || part.rhombus->length_mm > kRhombusBelow_px * pixel_mm) {
        glBindVertexArray(part.vertex_array.name());
        glVertexAttrib1f(3, 1);
        glDrawElementsInstanced(GL_TRIANGLES, part.index_count, GL_UNSIGNED_INT, nullptr,
                                part.instance_count);
    } else {
        auto const& rhombus = *part.rhombus;
        float const area_px = rhombus.length_mm * rhombus.width_mm / (2 * pixel_mm * pixel_mm);
        float const share = std::clamp(area_px / kSmallestArea_px, kSmallestShare, 1.0f);
        // What is narrow grows across only, or it would reach out of the plant.
        bool const narrow = rhombus.width_mm < 0.25f * rhombus.length_mm;
        float const across = narrow ? 1 / share : 1 / std::sqrt(share);
        shader.set("instance_growth", Vec3f(across, narrow ? 1 : across, 1));
        glBindVertexArray(rhombus.vertex_array.name());
        glVertexAttrib1f(3, 1);
        auto const count
            = static_cast<GLsizei>(std::ceil(static_cast<float>(part.instance_count) * share));
        glDrawElementsInstanced(GL_TRIANGLES, rhombus.index_count, GL_UNSIGNED_INT, nullptr,
                                std::min(count, part.instance_count));
    }
    glBindVertexArray(0);
}

void GpuMesh::make_ground_texture(SkyVisibility const& sky)
{
    auto const picture = sky.ground();
    ground_corner_mm_ = picture.corner_mm;
    ground_size_mm_ = picture.size_mm;
    glBindTexture(GL_TEXTURE_2D, ground_texture_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R16F, picture.side, picture.side, 0, GL_RED, GL_FLOAT,
                 picture.values.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

} // namespace tractus
