#include "engine/variation/projected_skeleton.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tractus {

namespace {

// What has less of w is too near to the eye to have a place on the plane.
constexpr double kLeastW = 1e-6;

// Cells per line: enough that most cells hold few lines, few enough to be built quickly.
constexpr double kCellsPerLine = 0.5;
constexpr double kFewestCells = 1024;
constexpr double kMostCells = 1 << 20;

// What a point must not be outside of, as products with its homogeneous coordinates that are not
// negative: in front of the eye, and no farther beside the view than the view is large, so that
// single precision is enough for what remains.
using ClipPlanes = Eigen::Matrix<double, 5, 4>;

ClipPlanes clip_planes(SkeletonProjection const& view)
{
    Vec2 const low = 2 * view.min - view.max;
    Vec2 const high = 2 * view.max - view.min;
    ClipPlanes planes;
    planes << 0, 0, 0, 1, 1, 0, 0, -low.x(), -1, 0, 0, high.x(), 0, 1, 0, -low.y(), 0, -1, 0,
        high.y();
    return planes;
}

// The part of a line that the planes leave, or nothing (Liang and Barsky's method).
std::optional<ProjectedSkeleton::Line> project(Eigen::Vector4d const& from,
                                               Eigen::Vector4d const& to, ClipPlanes const& planes)
{
    Eigen::Matrix<double, 5, 1> inside_from = planes * from;
    Eigen::Matrix<double, 5, 1> inside_to = planes * to;
    inside_from[0] -= kLeastW;
    inside_to[0] -= kLeastW;
    double begin = 0;
    double end = 1;
    for (int i = 0; i < 5; ++i) {
        if (inside_from[i] < 0 && inside_to[i] < 0)
            return std::nullopt;
        if (inside_from[i] < 0)
            begin = std::max(begin, inside_from[i] / (inside_from[i] - inside_to[i]));
        else if (inside_to[i] < 0)
            end = std::min(end, inside_from[i] / (inside_from[i] - inside_to[i]));
    }
    if (begin > end)
        return std::nullopt;

    auto const at = [&](double share) {
        Eigen::Vector4d const point = from + share * (to - from);
        return Vec3(point.head<3>() / point.w());
    };
    Vec3 const first = at(begin);
    Vec3 const last = at(end);
    return ProjectedSkeleton::Line {
        .from = first.head<2>().cast<float>(),
        .to = last.head<2>().cast<float>(),
        .depth_from = static_cast<float>(first.z()),
        .depth_to = static_cast<float>(last.z()),
    };
}

// Where a line is nearest to a point.
struct Nearest {
    float distance = 0;
    float depth = 0;
};

Nearest nearest_to(ProjectedSkeleton::Line const& line, Vec2f const& point)
{
    Vec2f const along = line.to - line.from;
    float const squared = along.squaredNorm();
    float const share
        = squared > 0 ? std::clamp((point - line.from).dot(along) / squared, 0.f, 1.f) : 0.f;
    return { (line.from + share * along - point).norm(),
             line.depth_from + share * (line.depth_to - line.depth_from) };
}

} // namespace

SkeletonProjection view_in_pixels(Eigen::Matrix4d const& clip_from_plant, Vec2 const& size_px)
{
    Eigen::Matrix4d pixels_from_clip = Eigen::Matrix4d::Identity();
    pixels_from_clip(0, 0) = pixels_from_clip(0, 3) = size_px.x() / 2;
    pixels_from_clip(1, 1) = -size_px.y() / 2;
    pixels_from_clip(1, 3) = size_px.y() / 2;
    return { pixels_from_clip * clip_from_plant, Vec2::Zero(), size_px };
}

ProjectedSkeleton::ProjectedSkeleton(Plant const& plant, SkeletonProjection const& view)
    : min_(view.min.cast<float>())
    , max_(view.max.cast<float>())
{
    CHECK((view.max.array() >= view.min.array()).all());
    auto const planes = clip_planes(view);
    lines_.reserve(plant.segment_count());
    for (auto const& axis : plant.axes) {
        if (axis.order > view.max_order)
            continue;
        auto const nodes = plant.positions(axis);
        Eigen::Vector4d from = view.to_plane * nodes[0].homogeneous();
        for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
            Eigen::Vector4d const to = view.to_plane * nodes[i + 1].homogeneous();
            if (auto line = project(from, to, planes)) {
                line->segment = axis.first_segment + i;
                lines_.push_back(*line);
            }
            from = to;
        }
    }
    build_grid();
}

ProjectedSkeleton::Cell ProjectedSkeleton::cell_at(Vec2f const& point) const
{
    Vec2f const place = (point - min_) / cell_size_;
    return { static_cast<int>(std::clamp(place.x(), 0.f, static_cast<float>(columns_ - 1))),
             static_cast<int>(std::clamp(place.y(), 0.f, static_cast<float>(rows_ - 1))) };
}

std::size_t ProjectedSkeleton::index_of(Cell const& cell) const
{
    return static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(columns_)
        + static_cast<std::size_t>(cell.column);
}

// Calls visit(cell index) for each cell that the line may pass: row by row, the columns between the
// places where it enters and leaves the row.
template<typename Visit>
void ProjectedSkeleton::for_each_cell(Line const& line, Visit const& visit) const
{
    Vec2f low = line.from.y() <= line.to.y() ? line.from : line.to;
    Vec2f high = line.from.y() <= line.to.y() ? line.to : line.from;
    if (high.y() < min_.y() || low.y() > max_.y() || std::max(low.x(), high.x()) < min_.x()
        || std::min(low.x(), high.x()) > max_.x())
        return;
    float const slope = high.y() > low.y() ? (high.x() - low.x()) / (high.y() - low.y()) : 0;
    auto const x_at = [&](float y) {
        return y <= low.y() ? low.x() : y >= high.y() ? high.x() : low.x() + slope * (y - low.y());
    };
    int const last_row = cell_at(high).row;
    for (int row = cell_at(low).row; row <= last_row; ++row) {
        float const y = min_.y() + static_cast<float>(row) * cell_size_;
        bool const is_flat = slope == 0;
        float const x0 = is_flat ? low.x() : x_at(y);
        float const x1 = is_flat ? high.x() : x_at(y + cell_size_);
        int const first = cell_at({ std::min(x0, x1), y }).column;
        int const last = cell_at({ std::max(x0, x1), y }).column;
        for (int column = first; column <= last; ++column)
            visit(index_of({ column, row }));
    }
}

void ProjectedSkeleton::build_grid()
{
    Vec2f const size = max_ - min_;
    double const cells
        = std::clamp(static_cast<double>(lines_.size()) * kCellsPerLine, kFewestCells, kMostCells);
    float const area = std::max(size.x() * size.y(), std::numeric_limits<float>::min());
    cell_size_ = std::max(std::sqrt(area / static_cast<float>(cells)), size.maxCoeff() / 4096);
    if (!(cell_size_ > 0))
        cell_size_ = 1;
    columns_ = static_cast<int>(size.x() / cell_size_) + 1;
    rows_ = static_cast<int>(size.y() / cell_size_) + 1;

    first_in_cell_.assign(index_of({ 0, rows_ }) + 1, 0);
    for (auto const& line : lines_)
        for_each_cell(line, [&](std::size_t cell) { ++first_in_cell_[cell + 1]; });
    for (std::size_t i = 1; i < first_in_cell_.size(); ++i)
        first_in_cell_[i] += first_in_cell_[i - 1];
    in_cell_.resize(first_in_cell_.back());
    auto next = first_in_cell_;
    for (std::uint32_t number = 0; number < lines_.size(); ++number)
        for_each_cell(lines_[number], [&](std::size_t cell) { in_cell_[next[cell]++] = number; });
}

// Calls visit(line, distance and depth of its point nearest to the pen) for the lines within
// `reach`.
template<typename Visit>
void ProjectedSkeleton::for_each_near(Vec2f const& pen, float reach, Visit const& visit) const
{
    if (!((pen.array() >= min_.array()).all() && (pen.array() <= max_.array()).all()))
        return;
    auto const low = cell_at(pen - Vec2f::Constant(reach));
    auto const high = cell_at(pen + Vec2f::Constant(reach));
    for (Cell cell = low; cell.row <= high.row; ++cell.row) {
        auto const first = first_in_cell_[index_of({ low.column, cell.row })];
        auto const end = first_in_cell_[index_of({ high.column, cell.row }) + 1];
        for (auto i = first; i < end; ++i) {
            auto const& line = lines_[in_cell_[i]];
            if (auto const nearest = nearest_to(line, pen); nearest.distance <= reach)
                visit(line, nearest);
        }
    }
}

std::optional<SegmentId> ProjectedSkeleton::pick(Vec2 const& point,
                                                 PickOptions const& options) const
{
    auto const half_width = static_cast<float>(options.line_half_width);
    auto const reach = std::max(half_width, static_cast<float>(options.finger));
    std::optional<SegmentId> covering;
    std::optional<SegmentId> beside;
    float least_depth = std::numeric_limits<float>::infinity();
    float least_distance = reach;
    for_each_near(point.cast<float>(), reach, [&](Line const& line, auto const& nearest) {
        if (nearest.distance <= half_width && nearest.depth < least_depth) {
            least_depth = nearest.depth;
            covering = line.segment;
        }
        if (nearest.distance < least_distance || !beside) {
            least_distance = nearest.distance;
            beside = line.segment;
        }
    });
    return covering ? covering : beside;
}

void ProjectedSkeleton::find_covering(Vec2 const& point, PickOptions const& options,
                                      std::vector<SegmentId>& covering) const
{
    covering.clear();
    for_each_near(point.cast<float>(), static_cast<float>(options.line_half_width),
                  [&](Line const& line, auto const&) { covering.push_back(line.segment); });
}

} // namespace tractus
