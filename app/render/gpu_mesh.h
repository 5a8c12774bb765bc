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

// A mesh uploaded to the GPU: created once, drawn many times. Must not outlive the OpenGL context.
class GpuMesh {
public:
    // Whether the sky's visibility is traced, which takes time, or assumed to be open, which is
    // enough without lighting.
    enum class Sky { Traced, Open };
    explicit GpuMesh(mesh::Mesh const& mesh, Sky sky = Sky::Traced);

    // Bounding box of everything drawn, in the plant frame. Empty for an empty mesh.
    Bounds const& bounds() const { return bounds_; }

    // One draw call: the triangles of one material, drawn once or as many instances.
    struct Part {
        Material material;
        // The material's pictures; null for those that it does not have.
        SurfacePicture const* picture = nullptr;
        SurfacePicture const* normal = nullptr;
        SurfacePicture const* occlusion = nullptr;
        SurfacePicture const* roughness = nullptr;
        SurfacePicture const* translucency = nullptr;
        GLsizei index_count = 0;
        // Number of leading indices that belong to tubes; of these only outer sides are drawn.
        GLsizei tube_index_count = 0;
        GLsizei instance_count = 0; // Number of instances; 0: drawn once, without instancing.
        gl::VertexArray vertex_array;
        std::vector<gl::Buffer> buffers;

        // Simplified shape of thin organs seen from afar: a rhombus of the same length and area, or
        // two crossed ones.
        struct Rhombus {
            gl::VertexArray vertex_array;
            GLsizei index_count = 0;
            float length_mm = 0; // Mean over the instances, as is width_mm.
            float width_mm = 0;
        };
        std::optional<Rhombus> rhombus;
    };
    std::vector<Part> const& parts() const { return parts_; }

    // Draws one part with `shader`, which must be in use. Vertex attributes: 0 position, 1 normal,
    // 2 texture coordinate, 3 sky visibility. Instance attributes: 4 translation, 5 rotation (a
    // quaternion, scalar last), 6 scale, 7 sky visibility. Uniforms: instance_growth, is_instanced,
    // and those of the material's colour and pictures. `pixel_mm` is the size of a pixel. Organs a
    // few pixels in size are drawn as rhombi; where these would be smaller than pixels, a random
    // subset is drawn, enlarged accordingly (Cook, Halstead, Planck, Ryu 2007, "Stochastic
    // simplification of aggregate detail").
    void draw(Part const& part, Shader const& shader, float pixel_mm) const;

    // Sky visibility of the ground below the plant: a single-channel texture, and the rectangle
    // that it covers.
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
