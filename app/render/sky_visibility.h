#pragma once

#include "engine/mesh/mesh.h"

#include <vector>

namespace tractus::render {

// Visibility of the sky in and around a plant through its own leaves and branches: ambient light
// decreases towards the inside of a crown and below it. The plant is modelled as a cloud on a
// coarse grid with density surface per volume; light from a few directions of the upper hemisphere
// is attenuated by the Beer-Lambert law, as in light models of canopies (Monsi and Saeki 1953,
// "Über den Lichtfaktor in den Pflanzengesellschaften").
class SkyVisibility {
public:
    SkyVisibility() = default; // Creates open sky everywhere.
    explicit SkyVisibility(mesh::Mesh const& mesh);

    // Visibility from 0, dark, to 1, open sky, at a place in the plant frame. The grid has a
    // margin; beyond it the value at its border applies.
    float at(Vec3f const& position_mm) const;

    // Visibility on the ground below the plant, as a square image for a texture.
    struct GroundPicture {
        // Values of side * side places, in rows along +x, the first row at the lowest y.
        std::vector<float> values;
        int side = 0;
        Vec2f corner_mm = Vec2f::Zero(); // Corner at the first value, in the plant frame.
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
    Eigen::Vector3i size_ = Eigen::Vector3i::Zero(); // Number of cells along x, y, z.
    std::vector<float> density_;                     // Surface per volume of each cell, in 1/mm.
    std::vector<float> visibility_;                  // Visibility at each cell's centre.
};

} // namespace tractus::render
