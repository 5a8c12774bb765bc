#pragma once

#include "engine/mesh/mesh.h"

#include <vector>

namespace tractus::render {

// How much of the sky each place in and around a plant sees through the plant's own leaves and
// branches: the ambient light of a crown falls off towards its inside and below it.
//
// The plant is taken as a cloud whose density is its surface per volume, in the cells of a coarse
// grid, and light from a few directions of the upper half sphere fades by Beer and Lambert's law
// (as light models of canopies do: Monsi and Saeki 1953, "Über den Lichtfaktor in den
// Pflanzengesellschaften").
class SkyVisibility {
public:
    SkyVisibility() = default; // Open sky everywhere.
    explicit SkyVisibility(mesh::Mesh const& mesh);

    // 0 dark to 1 open sky. Plant frame; beyond the grid, which has a margin, as at its border.
    float at(Vec3f const& position_mm) const;

    // Visibility on the ground below the plant, as a square picture for a texture.
    struct GroundPicture {
        std::vector<float> values; // side * side, rows along +x, first row at the least y.
        int side = 0;
        Vec2f corner_mm = Vec2f::Zero(); // Corner of the first value, plant frame.
        Vec2f size_mm = Vec2f::Ones();
    };
    GroundPicture ground() const;

private:
    std::size_t index(Eigen::Vector3i const& cell) const;
    void deposit(mesh::Mesh const& mesh);
    void add_area(Vec3f const& position_mm, float area_mm2);
    void trace();
    float transmitted(Vec3f from, Vec3f const& direction) const;

    Vec3f corner_mm_ = Vec3f::Zero();
    float cell_mm_ = 1;
    Eigen::Vector3i size_ = Eigen::Vector3i::Zero(); // Cells along x, y, z.
    std::vector<float> density_;                     // Surface per volume, 1/mm; one per cell.
    std::vector<float> visibility_;                  // One per cell, at its centre.
};

} // namespace tractus::render
