#include "app/render/gpu_mesh.h"

#include "engine/base/check.h"

#include <cstddef>

namespace tractus {

namespace {

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

void add_instances(GpuMesh::Part& part, std::vector<InstanceVertex> const& instances)
{
    glBindVertexArray(part.vertex_array.name());
    gl::upload(part.buffers.emplace_back(), GL_ARRAY_BUFFER,
               std::span<InstanceVertex const>(instances));
    constexpr GLsizei kStride = sizeof(InstanceVertex);
    float_attribute(4, 3, kStride, offsetof(InstanceVertex, translation_mm));
    float_attribute(5, 4, kStride, offsetof(InstanceVertex, rotation));
    float_attribute(6, 3, kStride, offsetof(InstanceVertex, scale));
    float_attribute(7, 1, kStride, offsetof(InstanceVertex, sky));
    for (GLuint index = 4; index < 8; ++index)
        glVertexAttribDivisor(index, 1);
    glBindVertexArray(0);
    part.instance_count = static_cast<GLsizei>(instances.size());
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
    CHECK(triangles.normals.size() == triangles.positions_mm.size());
    Part part;
    part.material = material;
    part.index_count = static_cast<GLsizei>(triangles.indices.size());
    glBindVertexArray(part.vertex_array.name());
    add_vertex_values(part, 0, triangles.positions_mm);
    add_vertex_values(part, 1, triangles.normals);
    if (triangles.texture_coordinates.size() == triangles.positions_mm.size())
        add_vertex_values(part, 2, triangles.texture_coordinates);
    gl::upload(part.buffers.emplace_back(), GL_ELEMENT_ARRAY_BUFFER,
               std::span<std::uint32_t const>(triangles.indices));
    return part;
}

void GpuMesh::add_surface(Material const& material, TriangleMesh const& surface,
                          SkyVisibility const& sky)
{
    auto part = make_part(material, surface);
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
    std::vector<InstanceVertex> instances;
    instances.reserve(organ.instances.size());
    for (auto const& instance : organ.instances) {
        auto const& rotation = instance.rotation;
        instances.push_back({ instance.translation_mm,
                              { rotation.x(), rotation.y(), rotation.z(), rotation.w() },
                              instance.scale,
                              sky.at(instance.translation_mm) });
    }
    add_instances(part, instances);
    parts_.push_back(std::move(part));
}

void GpuMesh::draw(Part const& part) const
{
    glBindVertexArray(part.vertex_array.name());
    if (part.instance_count > 0) {
        glVertexAttrib1f(3, 1);
        glDrawElementsInstanced(GL_TRIANGLES, part.index_count, GL_UNSIGNED_INT, nullptr,
                                part.instance_count);
    } else {
        glVertexAttrib3f(4, 0, 0, 0);
        glVertexAttrib4f(5, 0, 0, 0, 1);
        glVertexAttrib3f(6, 1, 1, 1);
        glVertexAttrib1f(7, 1);
        glDrawElements(GL_TRIANGLES, part.index_count, GL_UNSIGNED_INT, nullptr);
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
