#include "app/methods/leaves/atlas_shape.h"

#include "engine/methods/leaves/leaf_shape.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace tractus::leaf {

namespace {

AtlasShape flat_shape(leaf::Cutout cutout, AtlasScale const& scale)
{
    AtlasShape shape { .corners = std::move(cutout.corners),
                       .triangles = std::move(cutout.triangles) };
    for (auto const& corner : shape.corners) {
        Vec2 const from_stem = scale.pixel_mm * (corner - scale.stem);
        shape.positions_mm.emplace_back(from_stem.x(), -from_stem.y(), 0);
    }
    shape.normals.assign(shape.corners.size(), Vec3::UnitZ());
    return shape;
}

AtlasShape modelled_shape(GrownLeaf const& grown, leaf::LeafPicture const& picture,
                          leaf::PictureFrame const& frame, AtlasScale const& scale)
{
    auto model = leaf::model_leaf(picture.alpha, picture.side, grown.triangles,
                                  grown.leaf.midribs(), frame);
    AtlasShape shape { .corners = std::move(model.corners),
                       .positions_mm = std::move(model.positions),
                       .normals = std::move(model.normals),
                       .triangles = std::move(model.triangles) };
    Vec2 const stem = frame.flat(scale.stem);
    for (auto& position : shape.positions_mm)
        position = scale.pixel_mm * frame.scale * (position - Vec3(stem.x(), stem.y(), 0));
    return shape;
}

} // namespace

AtlasShape atlas_shape(AtlasGeometry geometry, GrownLeaf const& grown,
                       leaf::LeafPicture const& picture, leaf::PictureFrame const& frame,
                       AtlasScale const& scale)
{
    switch (geometry) {
    case AtlasGeometry::Card:
        return flat_shape(leaf::card_around(picture.alpha, picture.side), scale);
    case AtlasGeometry::Cut:
        return flat_shape(leaf::cut_along_edge(picture.alpha, picture.side), scale);
    case AtlasGeometry::Modelled:
        return modelled_shape(grown, picture, frame, scale);
    }
    return {};
}

mesh::TriangleMesh upright_mesh(AtlasShape const& shape, Vec2 const& cell_corner, double page)
{
    auto const upright
        = [](Vec3 const& at) -> Vec3f { return Vec3(at.x(), -at.z(), at.y()).cast<float>(); };
    mesh::TriangleMesh mesh;
    for (std::size_t i = 0; i < shape.corners.size(); ++i) {
        mesh.positions_mm.push_back(upright(shape.positions_mm[i]));
        mesh.normals.push_back(upright(shape.normals[i]));
        mesh.texture_coordinates.push_back(((cell_corner + shape.corners[i]) / page).cast<float>());
    }
    for (auto const& triangle : shape.triangles)
        mesh.indices.insert(mesh.indices.end(), triangle.begin(), triangle.end());
    return mesh;
}

nlohmann::ordered_json shape_json(AtlasShape const& shape, Vec2 const& cell_corner, double page)
{
    using Json = nlohmann::ordered_json;
    bool const is_flat
        = std::ranges::all_of(shape.positions_mm, [](Vec3 const& at) { return at.z() == 0; });
    Json positions = Json::array();
    Json normals = Json::array();
    Json coordinates = Json::array();
    for (std::size_t i = 0; i < shape.corners.size(); ++i) {
        Vec3 const at = shape.positions_mm[i] / 1000;
        Vec3 const& normal = shape.normals[i];
        positions.push_back(is_flat ? Json { at.x(), at.y() } : Json { at.x(), at.y(), at.z() });
        normals.push_back({ normal.x(), normal.y(), normal.z() });
        Vec2 const uv = (cell_corner + shape.corners[i]) / page;
        coordinates.push_back({ uv.x(), uv.y() });
    }
    Json made { { "positions", positions }, { "uv", coordinates } };
    if (!is_flat)
        made["normals"] = normals;
    made["triangles"] = shape.triangles;
    return made;
}

} // namespace tractus::leaf
