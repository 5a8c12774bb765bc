#pragma once

#include "engine/methods/silhouettes/plane.h"
#include "engine/plant/plant.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tractus::silhouette {

// How well leaves fill an outline, as seen from the drawing plane.
struct LeafCoverage {
    double inside = 0;  // Share of the outline's pixels that leaves cover, 0 to 1.
    double outside = 0; // Share of the leaves' pixels that are outside of the outline, 0 to 1.
};

// Picture of an outline and of the leaves in front of it, seen along the plant's y axis: 512 pixels
// along the longer side of the outline's bounding box, and a third of that as a margin on each
// side. Places are plant millimetres (x to the right, z up). Leaves beyond the margin are not seen.
class LeafRaster {
public:
    static constexpr int kPixels = 512;

    explicit LeafRaster(std::span<Vec2 const> outline_mm);

    // Pixels of an organ's leaves; a pixel that several leaves cover counts once for each.
    struct Pixels {
        std::size_t all = 0;
        std::size_t outside = 0; // Outside of the outline.
        std::size_t fresh = 0;   // Inside, and not covered by organs that were drawn before.
    };
    Pixels count(OrganShape const& shape, Organ const& organ) const;
    void draw(OrganShape const& shape, Organ const& organ);

    LeafCoverage coverage() const;

    // True if the pixel at this place is inside of the outline.
    bool is_inside(Vec2 const& place_mm) const;

    // True if no pixel outside of the outline is nearer than this to the place. May be false where
    // the distance exceeds this by a few per cent.
    bool is_deeper_than(double distance_mm, Vec2 const& place_mm) const;

    // Indices of the outline's pixels that no leaf covers, row by row from below.
    std::vector<std::size_t> uncovered() const;
    bool is_uncovered(std::size_t pixel) const { return is_in_[pixel] && !is_covered_[pixel]; }
    Vec2 place_of(std::size_t pixel) const; // Centre of a pixel, plant millimetres.

    Vec2 low_mm() const { return low_; } // Corners of the picture.
    Vec2 high_mm() const { return low_ + pixel_mm_ * Vec2(columns_, rows_); }

private:
    template<typename Visit>
    void visit_pixels(OrganShape const& shape, Organ const& organ, Visit const& visit) const;
    template<typename Visit>
    void visit_quad(std::array<Vec2, 4> const& corners, Visit const& visit) const;
    void fill_outline(std::span<Vec2 const> outline_mm);
    void measure_depth();
    std::size_t pixel_at(Vec2 const& place_mm) const; // Past the last pixel: not in the picture.

    Vec2 low_ = Vec2::Zero();
    double pixel_mm_ = 1;
    int rows_ = 0;
    int columns_ = 0;
    std::vector<std::uint8_t> is_in_;
    std::vector<std::uint8_t> is_covered_;
    std::vector<float> depth_; // Distance to the nearest pixel outside of the outline, in pixels.
    std::size_t outline_pixels_ = 0;
    std::size_t covered_inside_ = 0;
    std::size_t covered_outside_ = 0;
};

// Coverage of an outline by the leaves of a plant in full foliage: all organs that are surfaces of
// leaf material. `outline_mm`: seen along y, plant millimetres; nothing is covered without one.
LeafCoverage leaf_coverage(Plant const& plant, std::span<Vec2 const> outline_mm);

} // namespace tractus::silhouette
