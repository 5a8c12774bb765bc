#include "app/render/stage.h"

namespace tractus::render {

Backdrop dark_backdrop()
{
    return { .top = { 0.15f, 0.165f, 0.19f },
             .bottom = { 0.27f, 0.275f, 0.285f },
             .ground = { 0.27f, 0.265f, 0.26f },
             .has_ground = true };
}

static void add_box(Bounds& sum, Bounds const& box, Eigen::Affine3d const& T_sum_box)
{
    if (box.empty())
        return;
    for (int corner = 0; corner < 8; ++corner)
        sum.add(T_sum_box
                * Vec3(corner & 1 ? box.max_mm.x() : box.min_mm.x(),
                       corner & 2 ? box.max_mm.y() : box.min_mm.y(),
                       corner & 4 ? box.max_mm.z() : box.min_mm.z()));
}

static Bounds mesh_bounds(Stage const& stage)
{
    Bounds sum;
    for (auto const& placed : stage.meshes)
        add_box(sum, placed.mesh->bounds(), placed.T_world_plant.cast<double>());
    return sum;
}

bool shows_ground(Stage const& stage)
{
    constexpr double kHiddenShare = 0.1;
    auto const box = mesh_bounds(stage);
    return stage.backdrop.has_ground
        && (box.empty() || -box.min_mm.z() <= kHiddenShare * (box.max_mm.z() - box.min_mm.z()));
}

Bounds bounds(Stage const& stage)
{
    auto sum = mesh_bounds(stage);
    for (auto const* curves : stage.curves)
        add_box(sum, curves->bounds(), Eigen::Affine3d::Identity());
    return sum;
}

} // namespace tractus::render
