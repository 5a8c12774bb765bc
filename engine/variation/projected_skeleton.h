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

// Projection of a plant onto a plane, in pixels or in millimetres of the tablet.
struct SkeletonProjection {
    // Transforms a point (x, y, z, 1) of the plant frame to (u, v, depth, 1) w, with u and v on the
    // plane and depth increasing away from the viewer. w is 1 for a parallel projection; points
    // with w <= 0 are behind the eye and invisible.
    Eigen::Matrix4d to_plane = Eigen::Matrix4d::Identity();

    // Corners of the visible part of the plane. Nothing outside it can be picked.
    Vec2 min = Vec2::Zero();
    Vec2 max = Vec2::Zero();

    // Axes of a higher branching order than this are hidden: in a dense crown they would cover the
    // branches to be picked.
    std::uint32_t max_order = std::numeric_limits<std::uint32_t>::max();
};

// Returns the projection of an OpenGL camera. `clip_from_plant` is the product of its projection
// and view matrices; the plane is the window in pixels, with v downwards.
SkeletonProjection view_in_pixels(Eigen::Matrix4d const& clip_from_plant, Vec2 const& size_px);

// Tolerances for picking, in units of the plane.
struct PickOptions {
    double line_half_width = 1.5; // Half the width of the lines as drawn.
    double finger = 6; // Maximum distance of the pen from a line's centre that still picks it.
};

// A plant's segments as lines on a plane, with a grid for finding the line under the pen quickly.
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

    // Replaces the contents by another plant or view, reusing the memory. Uses all threads.
    void project(Plant const& plant, SkeletonProjection const& view);

    // The visible lines, in the order of the segments. Parts behind the eye, or further than a
    // view's width outside the view, are cut off.
    std::span<Line const> lines() const { return lines_; }

    // Returns the segment under `point`. Of all lines that cover the point, this is the nearest to
    // the viewer; if no line covers it, the line at the least distance on the plane, up to
    // `finger`. Returns no value if there is no such line, or if the point is outside the view.
    std::optional<SegmentId> pick(Vec2 const& point, PickOptions const& options = {}) const;

    // Finds all segments whose lines cover `point`, at any depth, in no particular order and
    // possibly repeated. Reuses the memory of `covering`.
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
    // Index in in_cell_ of each cell's first entry, followed by the number of all entries.
    std::vector<std::uint32_t> first_in_cell_;
    std::vector<std::uint32_t> in_cell_; // Indices into lines_, cell by cell.
    // For each thread, and for each cell, the index in in_cell_ where the thread writes the cell's
    // next entry.
    std::vector<std::vector<std::uint32_t>> next_in_cell_;
};

} // namespace tractus::variation
