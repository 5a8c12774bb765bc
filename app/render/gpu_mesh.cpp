#include "app/render/gpu_mesh.h"

#include "app/render/image.h"
#include "app/render/leaf_parts.h"
#include "engine/base/check.h"
#include "engine/export/gltf_material.h"
#include "engine/export/texture.h"
#include "engine/mesh/coarse_mesh.h"
#include "engine/mesh/mesh_measures.h"

#include <algorithm>
#include <cstddef>

namespace tractus::render {

namespace {

// First of the five texture units for pictures; the sun's shadow uses the lower ones.
constexpr int kPictureUnit = 2;

struct InstanceVertex {
    Vec3f translation_mm = Vec3f::Zero();
    std::array<float, 4> rotation {}; // Rotation as a quaternion x, y, z, w.
    Vec3f scale = Vec3f::Ones();
    float sky = 1;
    Vec2f individual = Vec2f::Constant(0.5f); // individual_at()
};

void float_attribute(GLuint index, GLint size, GLsizei stride, std::size_t offset_bytes)
{
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, stride, gl::offset(offset_bytes));
}

// Uploads one value per vertex as the attribute `index`, into a new buffer that the part keeps.
template<typename Values>
void add_vertex_values(GpuMesh::Part& part, GLuint index, Values const& values)
{
    using Value = typename Values::value_type;
    gl::upload(part.buffers.emplace_back(), GL_ARRAY_BUFFER, std::span<Value const>(values));
    float_attribute(index, static_cast<GLint>(sizeof(Value) / sizeof(float)), 0, 0);
}

// Uploads triangles to a vertex array, which stays bound. The part keeps the buffers.
void add_triangles(GpuMesh::Part& part, gl::VertexArray const& vertex_array,
                   mesh::TriangleMesh const& triangles)
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

bool is_flat(mesh::TriangleMesh const& mesh, std::size_t first_index)
{
    auto const& normal = mesh.normals[mesh.indices[first_index]];
    return mesh.normals[mesh.indices[first_index + 1]] == normal
        && mesh.normals[mesh.indices[first_index + 2]] == normal;
}

// Returns how many of a surface's first indices belong to tubes, whose inner sides are never
// visible. make_mesh() puts two-sided polygons, which have flat normals, after the tubes. Surfaces
// of other materials than bark and stems, such as those in files from other programs, count as
// having no tubes.
GLsizei tube_index_count(Material const& material, mesh::TriangleMesh const& surface)
{
    if (material.kind != Material::Kind::Bark && material.kind != Material::Kind::Stem)
        return 0;
    std::size_t count = surface.indices.size();
    while (count >= 3 && is_flat(surface, count - 3))
        count -= 3;
    return static_cast<GLsizei>(count);
}

// Binds a buffer of instances to the instance attributes of a vertex array.
void use_instances(gl::VertexArray const& vertex_array, GLuint instances)
{
    glBindVertexArray(vertex_array.name());
    glBindBuffer(GL_ARRAY_BUFFER, instances);
    constexpr GLsizei kStride = sizeof(InstanceVertex);
    float_attribute(4, 3, kStride, offsetof(InstanceVertex, translation_mm));
    float_attribute(5, 4, kStride, offsetof(InstanceVertex, rotation));
    float_attribute(6, 3, kStride, offsetof(InstanceVertex, scale));
    float_attribute(7, 1, kStride, offsetof(InstanceVertex, sky));
    float_attribute(8, 2, kStride, offsetof(InstanceVertex, individual));
    for (GLuint index = 4; index < 9; ++index)
        glVertexAttribDivisor(index, 1);
    glBindVertexArray(0);
}

std::vector<InstanceVertex> instances_of(mesh::InstancedMesh const& organ, SkyVisibility const& sky)
{
    std::vector<InstanceVertex> instances;
    instances.reserve(organ.instances.size());
    Vec3f const middle = middle_of_largest_part(organ.prototype);
    for (auto const& instance : organ.instances) {
        auto const& rotation = instance.rotation;
        Vec3f const place = mesh::placed(instance, middle);
        instances.push_back({ instance.translation_mm,
                              { rotation.x(), rotation.y(), rotation.z(), rotation.w() },
                              instance.scale,
                              sky.at(place),
                              individual_at(place) });
    }
    return instances;
}

float max_scale(mesh::InstancedMesh const& organ)
{
    float scale = 0;
    for (auto const& instance : organ.instances)
        scale = std::max(scale, instance.scale.cwiseAbs().maxCoeff());
    return scale;
}

void draw_instances(GpuMesh::Part const& part, float pixel_mm)
{
    // Less than half a pixel, as some instances are nearer to the camera than its target.
    constexpr float kMaxError_px = 0.3f;
    GLsizei index_count = part.index_count;
    std::size_t first_index = 0;
    for (auto const& coarse : part.coarse)
        if (coarse.error_mm <= kMaxError_px * pixel_mm) {
            index_count = coarse.index_count;
            first_index = coarse.first_index;
            break;
        }
    glBindVertexArray(part.vertex_array.name());
    glVertexAttrib1f(3, 1);
    glDrawElementsInstanced(GL_TRIANGLES, index_count, GL_UNSIGNED_INT,
                            gl::offset(first_index * sizeof(std::uint32_t)), part.instance_count);
}

void draw_surface(GpuMesh::Part const& part)
{
    glBindVertexArray(part.vertex_array.name());
    glVertexAttrib3f(4, 0, 0, 0);
    glVertexAttrib4f(5, 0, 0, 0, 1);
    glVertexAttrib3f(6, 1, 1, 1);
    glVertexAttrib1f(7, 1);
    glVertexAttrib2f(8, 0.5f, 0.5f);
    glEnable(GL_CULL_FACE);
    glDrawElements(GL_TRIANGLES, part.tube_index_count, GL_UNSIGNED_INT, nullptr);
    glDisable(GL_CULL_FACE);
    auto const tubes = static_cast<std::size_t>(part.tube_index_count);
    glDrawElements(GL_TRIANGLES, part.index_count - part.tube_index_count, GL_UNSIGNED_INT,
                   gl::offset(tubes * sizeof(std::uint32_t)));
}

// Sets the uniforms of a picture: its sampler, and its strength, which is 0 if there is no picture.
void set_picture(Shader const& shader, int index, SurfacePicture const* picture, char const* name,
                 char const* strength_name, float strength)
{
    shader.set(strength_name, picture ? strength : 0.0f);
    // Each sampler has a texture unit of its own, as samplers of different types must not share a
    // unit.
    shader.set(name, kPictureUnit + index);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(kPictureUnit + index));
    glBindTexture(GL_TEXTURE_2D, picture ? picture->texture.name() : 0);
    glActiveTexture(GL_TEXTURE0);
}

// Sets the uniform base_color and those of the material's pictures.
void set_pictures(GpuMesh::Part const& part, Shader const& shader, SurfacePictures& pictures)
{
    using Meaning = SurfacePictures::Meaning;
    auto const& textures = part.material.textures;
    // New pictures are uploaded through the active texture unit, which must not be one of the sun's
    // shadow.
    glActiveTexture(GL_TEXTURE0 + kPictureUnit);
    auto const* const picture = pictures.find_or_add(textures.base_color, Meaning::Color);
    auto const* const normal = pictures.find_or_add(textures.normal, Meaning::Numbers);
    auto const* const occlusion = pictures.find_or_add(textures.occlusion, Meaning::Numbers);
    auto const* const roughness = pictures.find_or_add(textures.roughness, Meaning::Numbers);
    auto const* const translucency = pictures.find_or_add(textures.translucency, Meaning::Numbers);

    bool const replaces = textures.color == MaterialTextures::Color::Replaced;
    shader.set("base_color",
               picture && replaces ? Vec3f::Ones().eval() : linear_light(part.material.base_color));
    bool const is_masked = picture && textures.alpha == MaterialTextures::Alpha::Mask;
    shader.set("masked", is_masked ? 1.0f : 0.0f);
    set_picture(shader, 0, picture, "picture", "pictured", 1);
    set_picture(shader, 1, normal, "normals", "bumped", textures.normal_strength);
    set_picture(shader, 2, occlusion, "occlusions", "occluded", textures.occlusion_strength);
    set_picture(shader, 3, roughness, "roughnesses", "roughened", 1);
    set_picture(shader, 4, translucency, "passings", "passing", 1);
}

// Adds the pictures of a kind of bark. The furrows that suit any plant are drawn by the shader.
Material with_bark_pictures(Material material)
{
    if (material.kind != Material::Kind::Bark || material.bark.kind == BarkKind::Furrowed)
        return material;
    Vec3 const light = exports::multiplied_color(material);
    material.textures = exports::textures_of(material);
    if (material.textures.color == MaterialTextures::Color::Multiplied)
        for (int k = 0; k < 3; ++k)
            material.base_color[k] = static_cast<float>(exports::srgb_from_linear(light[k]));
    return material;
}

// If this check fails, the mesh was made wrongly; readers of files check the indices themselves.
Material const& material_of(mesh::Mesh const& mesh, mesh::TriangleMesh const& triangles)
{
    CHECK(triangles.material < mesh.materials.size());
    return mesh.materials[triangles.material];
}

} // namespace

GpuMesh::GpuMesh(mesh::Mesh const& mesh, Sky how)
    : bounds_(mesh::bounds(mesh))
{
    auto const sky = how == Sky::Traced ? SkyVisibility(mesh) : SkyVisibility();
    for (auto const& surface : mesh.surfaces)
        if (!surface.indices.empty())
            add_surface(material_of(mesh, surface), surface, sky);
    for (auto const& organ : mesh.organs)
        if (!organ.instances.empty() && !organ.prototype.indices.empty())
            add_organ(material_of(mesh, organ.prototype), organ, sky);
    make_ground_texture(sky);
}

GpuMesh::Part GpuMesh::make_part(Material const& material, mesh::TriangleMesh const& triangles)
{
    Part part;
    part.material = with_bark_pictures(material);
    part.index_count = static_cast<GLsizei>(triangles.indices.size());
    add_triangles(part, part.vertex_array, triangles);
    return part;
}

void GpuMesh::add_surface(Material const& material, mesh::TriangleMesh const& surface,
                          SkyVisibility const& sky)
{
    auto part = make_part(material, surface);
    part.tube_index_count = tube_index_count(material, surface);
    glBindVertexArray(part.vertex_array.name());
    std::vector<float> visible;
    visible.reserve(surface.positions_mm.size());
    auto const leaves = is_thin(material) ? connected_parts(surface) : ConnectedParts();
    if (leaves.counts.size() > 1) {
        // Merged leaves look as instances of them would: each has one value for the whole of it.
        std::vector<Vec2f> individuals;
        individuals.reserve(surface.positions_mm.size());
        for (auto const leaf : leaves.part) {
            visible.push_back(sky.at(leaves.middles_mm[leaf]));
            individuals.push_back(individual_at(leaves.middles_mm[leaf]));
        }
        add_vertex_values(part, 8, individuals);
    } else {
        for (auto const& position : surface.positions_mm)
            visible.push_back(sky.at(position));
    }
    add_vertex_values(part, 3, visible);
    glBindVertexArray(0);
    parts_.push_back(std::move(part));
}

void GpuMesh::add_organ(Material const& material, mesh::InstancedMesh const& organ,
                        SkyVisibility const& sky)
{
    auto all = organ.prototype;
    auto versions = thinned_versions(all);
    if (versions.empty())
        versions = mesh::coarse_versions(organ.prototype);
    std::vector<Part::Coarse> coarse;
    for (auto const& version : versions) {
        coarse.insert(coarse.begin(),
                      { .error_mm = version.error_mm * max_scale(organ),
                        .index_count = static_cast<GLsizei>(version.indices.size()),
                        .first_index = all.indices.size() });
        all.indices.insert(all.indices.end(), version.indices.begin(), version.indices.end());
    }
    auto part = make_part(material, all);
    part.index_count = static_cast<GLsizei>(organ.prototype.indices.size());
    part.coarse = std::move(coarse);
    auto const instances = instances_of(organ, sky);
    part.instance_count = static_cast<GLsizei>(instances.size());
    gl::upload(part.buffers.emplace_back(), GL_ARRAY_BUFFER,
               std::span<InstanceVertex const>(instances));
    use_instances(part.vertex_array, part.buffers.back().name());
    parts_.push_back(std::move(part));
}

void GpuMesh::draw(Part const& part, Shader const& shader, SurfacePictures& pictures,
                   float pixel_mm) const
{
    set_pictures(part, shader, pictures);
    if (part.instance_count == 0)
        draw_surface(part);
    else
        draw_instances(part, pixel_mm);
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

} // namespace tractus::render
