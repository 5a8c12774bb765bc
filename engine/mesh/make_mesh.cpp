#include "engine/mesh/make_mesh.h"

#include "engine/mesh/coarse_mesh.h"
#include "engine/mesh/mesh_plan.h"
#include "engine/mesh/organ_card.h"
#include "engine/mesh/organ_mesh.h"

#include <array>
#include <utility>
#include <vector>

namespace tractus::mesh {

InstanceTransform transform_of(Organ const& organ)
{
    double const length = organ.orientation.norm();
    return { organ.position_mm.cast<float>(),
             length > 0 ? organ.orientation.normalized().cast<float>() : Quatf::Identity(),
             organ.scale };
}

Mesh make_mesh(Plant const& plant, MeshOptions const& options, std::stop_token const& stop)
{
    Mesh mesh;
    mesh.materials = plant.materials;
    mesh.surfaces = make_surfaces(MeshPlan(plant, options, stop), stop);
    if (stop.stop_requested())
        return mesh;
    mesh.organs = make_organs(plant, options);
    return mesh;
}

// Returns the greatest scale of a shape's copies; 1 if there are none.
static float max_scale(Plant const& plant, OrganShapeId shape)
{
    float scale = 0;
    for (auto const& organ : plant.organs)
        if (organ.shape == shape)
            scale = std::max(scale, organ.scale.cwiseAbs().maxCoeff());
    return scale > 0 ? scale : 1;
}

// Sets the texture coordinates of the card of a cut-out leaf, so that it shows the leaf's picture.
static void place_in_picture(OrganShape const& shape, TriangleMesh& card)
{
    double const length = box_of(*shape.cut).max().y();
    double const right = length * static_cast<double>(card.positions_mm[1].x()) / shape.length_mm;
    std::array const places { Vec2(0, 0), Vec2(right, length / 2), Vec2(0, length),
                              Vec2(-right, length / 2) };
    for (std::size_t i = 0; i < places.size(); ++i)
        card.texture_coordinates[i] = shape.cut->in_picture(places[i]).cast<float>();
}

TriangleMesh make_prototype(Plant const& plant, OrganShapeId id, MeshOptions const& options)
{
    auto const& shape = plant.organ_shapes[id];
    auto const& material = plant.materials[shape.material];
    // Pictures that belong to a material are mapped by patch. Pictures that an exporter generates
    // are made for the bounding box.
    auto const lies
        = material.textures.base_color ? TextureMapping::OnPatches : TextureMapping::OnBox;
    if (options.organs == MeshOptions::Organs::Cards && !shape.spray.empty())
        return organ_mesh(coarser_spray(shape), options.subdivision, lies);
    auto full = organ_mesh(shape, options.subdivision, lies);
    if (options.organ_error_mm > 0 && !full.indices.empty())
        full = simplified(full, static_cast<float>(options.organ_error_mm) / max_scale(plant, id));
    auto const kind = material.kind;
    bool const is_thin = kind == Material::Kind::Leaf || kind == Material::Kind::Petal;
    if (options.organs == MeshOptions::Organs::Full || full.indices.empty())
        return full;
    if (!is_thin)
        return full.triangle_count() > 6 ? organ_spindle(full) : full;
    auto card = organ_card(full);
    if (card && shape.kind == OrganShape::Kind::Leaf)
        place_in_picture(shape, *card);
    return card && card->indices.size() < full.indices.size() ? std::move(*card) : std::move(full);
}

std::vector<InstancedMesh> make_organs(Plant const& plant, MeshOptions const& options)
{
    std::vector<InstancedMesh> organs(plant.organ_shapes.size());
    for (auto const& organ : plant.organs)
        organs[organ.shape].instances.push_back(transform_of(organ));
    for (std::size_t i = 0; i < organs.size(); ++i) {
        organs[i].shape = static_cast<OrganShapeId>(i);
        if (!organs[i].instances.empty())
            organs[i].prototype = make_prototype(plant, organs[i].shape, options);
    }
    std::erase_if(organs,
                  [](InstancedMesh const& organ) { return organ.prototype.indices.empty(); });
    return organs;
}

} // namespace tractus::mesh
