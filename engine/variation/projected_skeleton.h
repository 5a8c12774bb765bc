#pragma once

#include "engine/base/vectors.h"
#include "engine/plant/plant.h"

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace tractus::variation {

// How a view shows a plant on a plane, in pixels or millimetres of the pen's tablet.
struct SkeletonProjection {
    // Takes a point (x, y, z, 1) of the plant frame to (u, v, depth, 1) w: u and v on the plane,
    // depth the greater the farther away. w is 1 for a parallel projection; what has w <= 0 is
    // behind the eye and not seen.
    Eigen::Matrix4d to_plane = Eigen::Matrix4d::Identity();

    // The part of the plane that is seen. What lies outside cannot be picked.
    Vec2 min = Vec2::Zero();
    Vec2 max = Vec2::Zero();

    // Axes of a higher order are not shown: in a dense crown they would hide what is meant.
    std::uint32_t max_order = std::numeric_limits<std::uint32_t>::max();
};

// The view of an OpenGL camera: `clip_from_plant` is the product of its projection and view
// matrices, the plane is the window in pixels with v downwards, as windows count.
SkeletonProjection view_in_pixels(Eigen::Matrix4d const& clip_from_plant, Vec2 const& size_px);

// Limits for what counts as under the pen, in units of the plane.
struct PickOptions {
    double line_half_width = 1.5; // Half of the width in which the skeleton is drawn.
    double finger = 6;            // How far beside a line the pen may be and still mean it.
};

// A plant's segments as lines on a plane, and a grid over them in which the one under the pen is
// found without looking at the others.
class ProjectedSkeleton {
public:
    struct Line {
        Vec2f from = Vec2f::Zero();
        Vec2f to = Vec2f::Zero();
        float depth_from = 0;
        float depth_to = 0;
        SegmentId segment = kNone;
    };

    ProjectedSkeleton(Plant const& plant, SkeletonProjection const& view) { project(plant, view); }

    // Projects another plant or view into the memory that is already there: when a view turns.
    // Works on all threads.
    void project(Plant const& plant, SkeletonProjection const& view);

    // Lines that are to be seen, in the order of the segments. They are cut behind the eye, and far
    // outside of the view.
    std::span<Line const> lines() const { return lines_; }

    // The segment under `point`, as a painter leaves it: of all lines that cover the point the
    // nearest to the eye. Where none does, the one least far beside it, up to the finger's
    // thickness. No value where there is nothing, and outside of the view.
    std::optional<SegmentId> pick(Vec2 const& point, PickOptions const& options = {}) const;

    // Finds all segments whose lines cover `point`, near and far, in no particular order and
    // perhaps more than once; put into `covering`, which is kept for its memory.
    void find_covering(Vec2 const& point, PickOptions const& options,
                       std::vector<SegmentId>& covering) const;

private:
    struct Cell {
        int column = 0;
        int row = 0;
    };

    void find_lines(Plant const& plant, SkeletonProjection const& view);
    void lay_grid();
    void build_grid();
    Cell cell_at(Vec2f const& point) const;
    std::size_t index_of(Cell const& cell) const;
    template<typename Visit>
    void for_each_near(Vec2f const& pen, float reach, Visit const& visit) const;
    template<typename Visit> void for_each_cell(Line const& line, Visit const& visit) const;

    std::vector<Line> lines_;
    Vec2f min_ = Vec2f::Zero();
    Vec2f max_ = Vec2f::Zero();
    float cell_size_ = 1;
    int columns_ = 1;
    int rows_ = 1;
    std::vector<std::uint32_t> first_in_cell_; // Per cell and the end.
    std::vector<std::uint32_t> in_cell_;       // Numbers of lines.
    // One for each thread's share of the lines.
    std::vector<std::vector<std::uint32_t>> next_in_cell_;
};

} // namespace tractus::variation
