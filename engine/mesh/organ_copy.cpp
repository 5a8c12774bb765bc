#include "engine/mesh/organ_copy.h"

namespace tractus::mesh {

namespace {

// Transforms the normals of an organ's prototype to the plant's frame.
struct NormalTurn {
    // Normals are multiplied by the cofactors of the scale. Unlike its inverse, these exist even if
    // a scale is zero.
    explicit NormalTurn(InstanceTransform const& instance)
        : rotation(instance.rotation.toRotationMatrix())
        , is_mirrored(instance.scale.prod() < 0)
    {
        auto const& s = instance.scale;
        Vec3f const cofactors(s.y() * s.z(), s.x() * s.z(), s.x() * s.y());
        factors = is_mirrored ? Vec3f(-cofactors) : cofactors;
    }

    Vec3f operator()(Vec3f const& normal) const
    {
        Vec3f const scaled = factors.cwiseProduct(normal);
        float const length = scaled.norm();
        return rotation * (length > 0 ? Vec3f(scaled / length) : normal);
    }

    Eigen::Matrix3f rotation;
    bool is_mirrored; // True if the organ is mirrored, so that its triangles must be reversed.
    Vec3f factors;
};

} // namespace

void append_copy(TriangleMesh const& prototype, InstanceTransform const& instance,
                 TrianglePlace& to)
{
    NormalTurn const turn(instance);
    auto const count = prototype.positions_mm.size();
    for (std::size_t i = 0; i < count; ++i) {
        Vec3f const scaled = instance.scale.cwiseProduct(prototype.positions_mm[i]);
        *to.position_mm++ = turn.rotation * scaled + instance.translation_mm;
        *to.normal++ = turn(prototype.normals[i]);
        *to.texture++ = prototype.texture_coordinates[i];
    }
    auto const& indices = prototype.indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        *to.index++ = to.vertex + indices[i];
        *to.index++ = to.vertex + indices[turn.is_mirrored ? i + 2 : i + 1];
        *to.index++ = to.vertex + indices[turn.is_mirrored ? i + 1 : i + 2];
    }
    to.vertex += static_cast<std::uint32_t>(count);
}

TriangleMesh merged_copies(InstancedMesh const& organ)
{
    auto const& prototype = organ.prototype;
    auto const count = organ.instances.size();
    TriangleMesh merged;
    merged.material = prototype.material;
    merged.positions_mm.resize(count * prototype.positions_mm.size());
    merged.normals.resize(count * prototype.normals.size());
    merged.texture_coordinates.resize(count * prototype.texture_coordinates.size());
    merged.indices.resize(count * prototype.indices.size());
    auto place = place_in(merged, {});
    for (auto const& instance : organ.instances)
        append_copy(prototype, instance, place);
    return merged;
}

} // namespace tractus::mesh
