#pragma once

#include "app/render/gl_objects.h"
#include "app/render/shader.h"
#include "app/render/sky_visibility.h"
#include "app/render/surface_picture.h"
#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

#include <optional>
#include <vector>

namespace tractus::render {

// A mesh on the graphics card: made once, drawn many times. Lives and dies with the context.
class GpuMesh {
public:
    // How much sky a place sees takes time to find; without light it does not matter.
    enum class Sky { Traced, Open };
    explicit GpuMesh(mesh::Mesh const& mesh, Sky sky = Sky::Traced);

    // The box around all that is drawn, plant frame. Empty for an empty mesh.
    Bounds const& bounds() const { return bounds_; }

    // One draw call: the triangles of one material, once or in many places.
    struct Part {
        Material material;
        // The mesh's pictures of the material; null where it has none.
        SurfacePicture const* picture = nullptr;
        SurfacePicture const* normal = nullptr;
        SurfacePicture const* occlusion = nullptr;
        SurfacePicture const* roughness = nullptr;
        SurfacePicture const* translucency = nullptr;
        GLsizei index_count = 0;
        GLsizei tube_index_count = 0; // The first ones; drawn from outside only.
        GLsizei instance_count = 0;   // 0: drawn once, where it is.
        gl::VertexArray vertex_array;
        std::vector<gl::Buffer> buffers;

        // Organs that are thin: the same seen from afar, a rhombus as long and of the same area,
        // or two that cross.
        struct Rhombus {
            gl::VertexArray vertex_array;
            GLsizei index_count = 0;
            float length_mm = 0; // Mean of the instances.
            float width_mm = 0;
        };
        std::optional<Rhombus> rhombus;
    };
    std::vector<Part> const& parts() const { return parts_; }

    // Draws one part with `shader`, which is in use. Attributes: 0 position, 1 normal, 2 texture
    // coordinate, 3 sky visibility of the vertex; of the instance 4 translation, 5 rotation (a
    // quaternion, scalar last), 6 scale, 7 sky visibility. Uniforms: instance_growth,
    // is_instanced, and those of the material's colour and pictures.
    //
    // `pixel_mm` is what a pixel shows. Organs of a few pixels are drawn as rhombi, and where these
    // are smaller than pixels, some of them for all, larger by as much (Cook, Halstead, Planck, Ryu
    // 2007, "Stochastic simplification of aggregate detail").
    void draw(Part const& part, Shader const& shader, float pixel_mm) const;

    // How much sky the ground below the plant sees: a texture of one channel and where it lies.
    GLuint ground_texture() const { return ground_texture_.name(); }
    Vec2f const& ground_corner_mm() const { return ground_corner_mm_; }
    Vec2f const& ground_size_mm() const { return ground_size_mm_; }

private:
    Part make_part(Material const& material, mesh::TriangleMesh const& triangles);
    void add_surface(Material const& material, mesh::TriangleMesh const& surface,
                     SkyVisibility const& sky);
    void add_organ(Material const& material, mesh::InstancedMesh const& organ,
                   SkyVisibility const& sky);
    void make_ground_texture(SkyVisibility const& sky);

    Bounds bounds_;
    SurfacePictures pictures_;
    std::vector<Part> parts_;
    gl::Texture ground_texture_;
    Vec2f ground_corner_mm_ = Vec2f::Zero();
    Vec2f ground_size_mm_ = Vec2f::Ones();
};

} // namespace tractus::render
