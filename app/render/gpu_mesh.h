#pragma once

#include "app/render/gl_objects.h"
#include "app/render/shader.h"
#include "app/render/sky_visibility.h"
#include "app/render/surface_picture.h"
#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

#include <vector>

namespace tractus::render {

// A mesh uploaded to the GPU. Create it once and draw it often. It must not outlive the OpenGL
// context.
class GpuMesh {
public:
    // Traced: the visibility of the sky is computed for each place, which takes time. Open: the
    // whole sky is visible everywhere, which is enough for pictures without lighting.
    enum class Sky { Traced, Open };
    explicit GpuMesh(mesh::Mesh const& mesh, Sky sky = Sky::Traced);

    // Bounding box of all surfaces and organs, in the plant frame. Empty for an empty mesh.
    Bounds const& bounds() const { return bounds_; }

    // The triangles of one material, drawn by one draw call: once, or as many instances.
    struct Part {
        Material material; // With the pictures that are generated for its bark.
        GLsizei index_count = 0;
        // Number of first indices that belong to tubes. Only the outer sides of tubes are drawn.
        GLsizei tube_index_count = 0;
        GLsizei instance_count = 0; // Number of instances; 0: drawn once, without instancing.
        // Fewer triangles of instances, the coarsest first, after the others in the index buffer.
        struct Coarse {
            float error_mm = 0; // Distance from the exact surface, of the largest instance.
            GLsizei index_count = 0;
            std::size_t first_index = 0;
        };
        std::vector<Coarse> coarse;
        gl::VertexArray vertex_array;
        std::vector<gl::Buffer> buffers;
    };
    std::vector<Part> const& parts() const { return parts_; }

    // Draws one part with `shader`, which must be in use. Vertex attributes: 0 position, 1 normal,
    // 2 texture coordinate, 3 sky visibility, 8 individual_at() of merged leaves. Instance
    // attributes: 4 translation, 5 rotation (a quaternion, scalar last), 6 scale, 7 sky visibility,
    // 8 individual_at(). Uniforms: those of the material's colour and pictures. Where the picture's
    // pixels are `pixel_mm` wide, instances are drawn with as few triangles as make no visible
    // difference. The material's pictures are uploaded to `pictures` where they are not there yet.
    void draw(Part const& part, Shader const& shader, SurfacePictures& pictures,
              float pixel_mm) const;

    // Visibility of the sky from the ground below the plant: ground_texture() has a single channel
    // and covers the rectangle given by the corner and size.
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
    std::vector<Part> parts_;
    gl::Texture ground_texture_;
    Vec2f ground_corner_mm_ = Vec2f::Zero();
    Vec2f ground_size_mm_ = Vec2f::Ones();
};

} // namespace tractus::render
