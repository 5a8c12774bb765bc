#pragma once

#include "engine/mesh/mesh.h"

#include <vector>

namespace tractus::render {

// Visibility of the sky in and around a plant, through the plant's own leaves and branches. By it,
// ambient light decreases towards the inside of a crown and below the crown. The plant is modelled
// as a cloud on a coarse grid; the density of a cell is the plant's surface area per volume. Light
// from nine directions of the upper hemisphere is attenuated by the Beer-Lambert law, as in light
// models of canopies (Monsi and Saeki 1953, "Über den Lichtfaktor in den Pflanzengesellschaften").
class SkyVisibility {
public:
    SkyVisibility() = default; // Creates an open sky: all of it is visible everywhere.
    explicit SkyVisibility(mesh::Mesh const& mesh);

    // Returns the visibility at a place in the plant frame, from 0 (dark) to 1 (open sky). The grid
    // extends beyond the plant by a margin; outside the grid, the value at its border applies.
    float at(Vec3f const& position_mm) const;

    // Visibility of the sky from the ground below the plant, as a square image for a texture.
    struct GroundPicture {
        // Values at side * side places, in rows along +x; the first row has the lowest y.
        std::vector<float> values;
        int side = 0;
        // Corner of the square at the first value, in the plant frame.
        Vec2f corner_mm = Vec2f::Zero();
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
    std::vector<float> density_;    // Surface area per volume of each cell, in 1/mm.
    std::vector<float> visibility_; // Visibility of the sky at each cell's centre.
};

} // namespace tractus::render
