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
        Material material;
        // The material's pictures; null for pictures that the material does not have.
        SurfacePicture const* picture = nullptr;
        SurfacePicture const* normal = nullptr;
        SurfacePicture const* occlusion = nullptr;
        SurfacePicture const* roughness = nullptr;
        SurfacePicture const* translucency = nullptr;
        GLsizei index_count = 0;
        // Number of first indices that belong to tubes. Only the outer sides of tubes are drawn.
        GLsizei tube_index_count = 0;
        GLsizei instance_count = 0; // Number of instances; 0: drawn once, without instancing.
        gl::VertexArray vertex_array;
        std::vector<gl::Buffer> buffers;

        // Simplified shape of thin organs seen from afar: a rhombus with the same length and area
        // as the organ, or two such rhombi that cross.
        struct Rhombus {
            gl::VertexArray vertex_array;
            GLsizei index_count = 0;
            // Mean length of the organ's instances; width_mm is the mean width.
            float length_mm = 0;
            float width_mm = 0;
        };
        std::optional<Rhombus> rhombus;
    };
    std::vector<Part> const& parts() const { return parts_; }

    // Draws one part with `shader`, which must be in use. Vertex attributes: 0 position, 1 normal,
    // 2 texture coordinate, 3 sky visibility. Instance attributes: 4 translation, 5 rotation (a
    // quaternion, scalar last), 6 scale, 7 sky visibility. Uniforms: instance_growth, is_instanced,
    // and those of the material's colour and pictures. `pixel_mm` is the size of a pixel at the
    // plant. Organs of a few pixels are drawn as rhombi. Where rhombi would be smaller than pixels,
    // a random subset is drawn, enlarged so that the total area stays the same (Cook, Halstead,
    // Planck, Ryu 2007, "Stochastic simplification of aggregate detail").
    void draw(Part const& part, Shader const& shader, float pixel_mm) const;

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
    SurfacePictures pictures_;
    std::vector<Part> parts_;
    gl::Texture ground_texture_;
    Vec2f ground_corner_mm_ = Vec2f::Zero();
    Vec2f ground_size_mm_ = Vec2f::Ones();
};

} // namespace tractus::render
