#include "app/methods/leaves/leaf_mesh.h"

#include "app/methods/leaves/leaf_maps.h"

#include <array>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace tractus::leaf {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

// Turns a leaf upright: the y axis of its grammar, along which leaves usually grow, then points up.
Vec3f upright(Vec3 const& position)
{
    return Vec3(position.x(), -position.z(), position.y()).cast<float>();
}

// Normals of the vertices: the mean of the adjacent triangles' normals, weighted by area.
std::vector<Vec3f> find_normals(leaf::LeafTriangles const& leaf)
{
    std::vector<Vec3> sums(leaf.positions.size(), Vec3::Zero());
    for (auto const& triangles : { std::span(leaf.veins), std::span(leaf.limb) })
        for (auto const& [a, b, c] : triangles) {
            Vec3 const area = (leaf.positions[b] - leaf.positions[a])
                                  .cross(leaf.positions[c] - leaf.positions[a]);
            for (auto const corner : { a, b, c })
                sums[corner] += area;
        }
    std::vector<Vec3f> normals;
    for (auto const& sum : sums) {
        double const length = sum.norm();
        normals.push_back(upright(length > 0 ? Vec3(sum / length) : Vec3(Vec3::UnitZ())));
    }
    return normals;
}

// Makes the mesh of a part of the leaf. Vertices are in the order of their first use.
class PartMaker {
public:
    PartMaker(leaf::LeafTriangles const& leaf, double size_mm)
        : leaf_(leaf)
        , normals_(find_normals(leaf))
    {
        for (auto const& flat : leaf.flat)
            box_.extend(flat);
        scale_ = size_mm / box_.sizes().maxCoeff();
    }

    mesh::TriangleMesh part(std::span<Triangle const> triangles, MaterialId material) const
    {
        constexpr auto kUnused = ~std::uint32_t { 0 };
        mesh::TriangleMesh mesh;
        mesh.material = material;
        std::vector<std::uint32_t> number(leaf_.positions.size(), kUnused);
        for (auto const& triangle : triangles)
            for (auto const corner : triangle) {
                if (number[corner] == kUnused) {
                    number[corner] = static_cast<std::uint32_t>(mesh.positions_mm.size());
                    mesh.positions_mm.push_back(upright(scale_ * leaf_.positions[corner]));
                    mesh.normals.push_back(normals_[corner]);
                    mesh.texture_coordinates.push_back(texture_at(leaf_.flat[corner]));
                }
                mesh.indices.push_back(number[corner]);
            }
        return mesh;
    }

private:
    Vec2f texture_at(Vec2 const& flat) const
    {
        double const side = box_.sizes().maxCoeff();
        return { static_cast<float>(0.5 + (flat.x() - box_.center().x()) / side),
                 static_cast<float>((flat.y() - box_.min().y()) / side) };
    }

    leaf::LeafTriangles const& leaf_;
    std::vector<Vec3f> normals_;
    Eigen::AlignedBox2d box_;
    double scale_ = 1;
};

} // namespace

Result<mesh::Mesh> leaf_mesh(leaf::LeafTriangles const& leaf, double size_mm)
{
    Eigen::AlignedBox2d box;
    for (auto const& flat : leaf.flat)
        box.extend(flat);
    if (!(box.sizes().maxCoeff() > 0))
        return fail(Fault::User, "the leaf has no extent: its faces have no length and no width");
    PartMaker const maker(leaf, size_mm);
    mesh::Mesh mesh;
    mesh.materials.push_back({ .name = "veins",
                               .kind = Material::Kind::Petal,
                               .base_color = { 0.66f, 0.74f, 0.42f },
                               .roughness = 0.6f,
                               .translucency = 0.2f });
    mesh.materials.push_back({ .name = "limb",
                               .kind = Material::Kind::Petal,
                               .base_color = { 0.28f, 0.47f, 0.17f },
                               .roughness = 0.55f,
                               .translucency = 0.4f });
    mesh.surfaces.push_back(maker.part(leaf.veins, 0));
    if (!leaf.limb.empty())
        mesh.surfaces.push_back(maker.part(leaf.limb, 1));
    return mesh;
}

namespace {

template<std::size_t N> TextureSlot texture(std::vector<std::array<std::uint8_t, N>> const& pixels)
{
    return std::make_shared<TexturePicture const>(
        TexturePicture { .bytes = packed_map(pixels), .edges = TexturePicture::Edges::Clamp });
}

} // namespace

Result<mesh::Mesh> painted_leaf_mesh(leaf::LeafTriangles const& leaf,
                                     leaf::LeafPicture const& picture, double size_mm)
{
    auto mesh = TRY(leaf_mesh(leaf, size_mm));
    std::vector<Triangle> all = leaf.veins;
    all.insert(all.end(), leaf.limb.begin(), leaf.limb.end());
    auto surface = PartMaker(leaf, size_mm).part(all, 0);
    // The images' first row, with v = 0, is at the leaf's tip.
    leaf::PictureFrame const frame(leaf, picture.side);
    std::vector<bool> is_placed(leaf.positions.size());
    std::size_t next = 0;
    for (auto const& triangle : all)
        for (auto const corner : triangle)
            if (!is_placed[corner]) {
                is_placed[corner] = true;
                surface.texture_coordinates[next++]
                    = (frame.pixel(leaf.flat[corner]) / picture.side).cast<float>();
            }
    mesh.surfaces = { std::move(surface) };
    auto const roughness = texture(picture.roughness);
    mesh.materials = { { .name = "leaf",
                         .kind = Material::Kind::Petal,
                         .base_color = { 1, 1, 1 },
                         .roughness = 1,
                         .translucency = 0.4f,
                         .textures = { .base_color = texture(picture.color),
                                       .normal = texture(picture.normal),
                                       .occlusion = roughness,
                                       .roughness = roughness,
                                       .alpha = MaterialTextures::Alpha::Mask } } };
    return mesh;
}

} // namespace tractus::leaf
