#include "app/render/sky_visibility.h"

#include "app/render/leaf_parts.h"
#include "engine/base/parallel.h"
#include "engine/mesh/mesh_measures.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tractus::render {

namespace {

constexpr int kLongestSide = 28; // Number of cells along the grid's longest side.
// Margin of the grid around the plant, as a share of the plant's longest side. The ground's shade
// falls into it.
constexpr float kMargin = 0.2f;

// On average, a randomly oriented surface hides light on half of its area.
constexpr float kExtinction = 0.5f;

struct Patch {
    Vec3f middle_mm = Vec3f::Zero();
    float area_mm2 = 0;
};

// Returns the triangles of a prototype as patches. If the prototype is smaller than a cell, all its
// triangles form one patch.
std::vector<Patch> surface_patches(mesh::TriangleMesh const& prototype, float cell_mm)
{
    std::vector<Patch> patches;
    Patch whole;
    for (std::size_t i = 0; i + 2 < prototype.indices.size(); i += 3) {
        auto const& a = prototype.positions_mm[prototype.indices[i]];
        auto const& b = prototype.positions_mm[prototype.indices[i + 1]];
        auto const& c = prototype.positions_mm[prototype.indices[i + 2]];
        auto const& patch
            = patches.emplace_back(Patch { (a + b + c) / 3, mesh::triangle_area(a, b, c) });
        whole.middle_mm += patch.middle_mm * patch.area_mm2;
        whole.area_mm2 += patch.area_mm2;
    }
    auto const box = mesh::bounds(prototype);
    if (whole.area_mm2 <= 0 || (box.max_mm - box.min_mm).maxCoeff() > static_cast<double>(cell_mm))
        return patches;
    whole.middle_mm /= whole.area_mm2;
    return { whole };
}

// Returns the zenith and two rings of four directions each, weighted by the cosine of the zenith
// angle.
std::array<Vec3f, 9> sky_directions()
{
    std::array<Vec3f, 9> result;
    result[0] = Vec3f::UnitZ();
    for (std::size_t i = 0; i < 8; ++i) {
        float const elevation = i < 4 ? 0.95f : 0.45f;
        float const azimuth = (static_cast<float>(i % 4) + (i < 4 ? 0.0f : 0.5f)) * 1.5707963f;
        result[i + 1] = Vec3f(std::cos(azimuth) * std::cos(elevation),
                              std::sin(azimuth) * std::cos(elevation), std::sin(elevation));
    }
    return result;
}

} // namespace

SkyVisibility::SkyVisibility(mesh::Mesh const& mesh)
{
    auto box = mesh::bounds(mesh);
    if (box.empty())
        return;
    box.add(Vec3((box.min_mm.x() + box.max_mm.x()) / 2, (box.min_mm.y() + box.max_mm.y()) / 2, 0));
    Vec3f extent = (box.max_mm - box.min_mm).cast<float>();
    if (!extent.allFinite())
        // The grid stays empty: coordinates from a file may be finite and yet too far apart.
        return;
    float const margin = std::max(1.0f, extent.maxCoeff() * kMargin);
    corner_mm_ = box.min_mm.cast<float>() - Vec3f(margin, margin, 0);
    extent += Vec3f(2 * margin, 2 * margin, 0);
    cell_mm_ = extent.maxCoeff() / static_cast<float>(kLongestSide);
    size_ = (extent / cell_mm_).array().ceil().cast<int>().max(1);
    density_.assign(static_cast<std::size_t>(size_.prod()), 0.0f);
    visibility_.assign(density_.size(), 1.0f);
    deposit(mesh);
    trace();
}

std::size_t SkyVisibility::index(Eigen::Vector3i const& cell) const
{
    return static_cast<std::size_t>((cell.z() * size_.y() + cell.y()) * size_.x() + cell.x());
}

void SkyVisibility::add_area(Vec3f const& position_mm, float area_mm2)
{
    // Distributes the area among the eight nearest cells, weighted as in linear interpolation.
    Vec3f const place = (position_mm - corner_mm_) / cell_mm_ - Vec3f::Constant(0.5f);
    Eigen::Vector3i const low = place.array().floor().cast<int>();
    Vec3f const share = place - low.cast<float>();
    for (int corner = 0; corner < 8; ++corner) {
        Eigen::Vector3i const step(corner & 1, corner >> 1 & 1, corner >> 2);
        Vec3f const weights
            = step.cast<float>().cwiseProduct(2 * share - Vec3f::Ones()) + Vec3f::Ones() - share;
        Eigen::Vector3i const cell
            = (low + step).cwiseMax(0).cwiseMin(size_ - Eigen::Vector3i::Ones());
        density_[index(cell)] += weights.prod() * area_mm2 / (cell_mm_ * cell_mm_ * cell_mm_);
    }
}

void SkyVisibility::deposit(mesh::Mesh const& mesh)
{
    for (auto const& surface : mesh.surfaces) {
        // Only half of a tube's area counts, as the other half lies behind it on the same branch.
        float const share
            = surface.material < mesh.materials.size() && is_thin(mesh.materials[surface.material])
            ? 1.0f
            : 0.5f;
        for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
            auto const& a = surface.positions_mm[surface.indices[i]];
            auto const& b = surface.positions_mm[surface.indices[i + 1]];
            auto const& c = surface.positions_mm[surface.indices[i + 2]];
            add_area((a + b + c) / 3, share * mesh::triangle_area(a, b, c));
        }
    }
    for (auto const& organ : mesh.organs) {
        auto const patches = surface_patches(organ.prototype, cell_mm_);
        for (auto const& instance : organ.instances)
            for (auto const& patch : patches)
                add_area(mesh::placed(instance, patch.middle_mm),
                         patch.area_mm2 * std::abs(instance.scale.x() * instance.scale.y()));
    }
}

float SkyVisibility::transmitted(Vec3f from, Vec3f const& direction) const
{
    // `from` is in units of cells. The first cell counts half, as half of it lies behind the point.
    float depth = 0;
    Vec3f const limit = size_.cast<float>();
    for (bool first = true; (from.array() >= 0).all() && (from.array() < limit.array()).all();
         from += direction) {
        Eigen::Vector3i const cell = from.cast<int>();
        depth += density_[index(cell)] * (first ? 0.5f : 1.0f);
        first = false;
    }
    return std::exp(-kExtinction * depth * cell_mm_);
}

void SkyVisibility::trace()
{
    auto const directions = sky_directions();
    float whole = 0;
    for (auto const& direction : directions)
        whole += direction.z();
    auto const find = [&](int x, int y, int z) {
        Vec3f const middle
            = Vec3f(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z))
            + Vec3f::Constant(0.5f);
        float sum = 0;
        for (auto const& direction : directions)
            sum += direction.z() * transmitted(middle, direction);
        visibility_[index({ x, y, z })] = sum / whole;
    };
    parallel_for(static_cast<std::size_t>(size_.z()), 1, [&](std::size_t begin, std::size_t end) {
        for (auto z = static_cast<int>(begin); z < static_cast<int>(end); ++z)
            for (int y = 0; y < size_.y(); ++y)
                for (int x = 0; x < size_.x(); ++x)
                    find(x, y, z);
    });
}

float SkyVisibility::at(Vec3f const& position_mm) const
{
    if (visibility_.empty())
        return 1;
    // Trilinear interpolation between the cells' centres, with places clamped to the grid.
    Vec3f const place = (position_mm - corner_mm_) / cell_mm_ - Vec3f::Constant(0.5f);
    Vec3f const limit = (size_ - Eigen::Vector3i::Ones()).cast<float>();
    Vec3f const inside = place.cwiseMax(0.0f).cwiseMin(limit);
    Eigen::Vector3i const low = inside.cast<int>();
    Vec3f const share = inside - low.cast<float>();
    float value = 0;
    for (int corner = 0; corner < 8; ++corner) {
        Eigen::Vector3i const step(corner & 1, corner >> 1 & 1, corner >> 2);
        Vec3f const weights
            = step.cast<float>().cwiseProduct(2 * share - Vec3f::Ones()) + Vec3f::Ones() - share;
        value += weights.prod()
            * visibility_[index((low + step).cwiseMin(size_ - Eigen::Vector3i::Ones()))];
    }
    return value;
}

SkyVisibility::GroundPicture SkyVisibility::ground() const
{
    GroundPicture picture;
    if (visibility_.empty())
        return { { 1.0f }, 1 };
    picture.side = 64;
    picture.corner_mm = corner_mm_.head<2>();
    picture.size_mm = size_.head<2>().cast<float>() * cell_mm_;
    for (int y = 0; y < picture.side; ++y)
        for (int x = 0; x < picture.side; ++x) {
            Vec2f const share((static_cast<float>(x) + 0.5f) / static_cast<float>(picture.side),
                              (static_cast<float>(y) + 0.5f) / static_cast<float>(picture.side));
            Vec2f const place = picture.corner_mm + picture.size_mm.cwiseProduct(share);
            picture.values.push_back(at(Vec3f(place.x(), place.y(), 0)));
        }
    return picture;
}

} // namespace tractus::render
