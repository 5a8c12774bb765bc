#include "engine/variation/projected_skeleton.h"

#include "engine/base/check.h"
#include "engine/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

namespace tractus::variation {

namespace {

// Points with a homogeneous coordinate w below this are too near to the eye to be projected.
constexpr double kMinW = 1e-6;

// Number of grid cells per line. With this value most cells have few lines, and the counts stay in
// a core's cache while the grid is built.
constexpr double kCellsPerLine = 0.25;
constexpr double kFewestCells = 1024;
constexpr double kMaxCells = 1 << 18;

// Minimum number of lines for which several threads build the grid. With fewer, one thread has
// built it before others have woken up.
constexpr std::size_t kLinesWorthThreads = 16'384;

// Clip planes: rows whose product with a point's homogeneous coordinates is negative where the
// point is behind the eye, or more than one view width outside the view. For the remaining points
// single precision suffices.
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

// A node of the plant, projected onto the plane.
struct Projected {
    Eigen::Vector4d homogeneous;
    Vec3 place;
    bool is_inside = false; // True if the node is within the clip planes.
};

// Projects and clips lines. It is fast for lines that are entirely within the clip planes, as most
// are.
class LineProjector {
public:
    explicit LineProjector(SkeletonProjection const& view)
        : to_plane_(view.to_plane)
        , low_(2 * view.min - view.max)
        , high_(2 * view.max - view.min)
        , planes_(clip_planes(view))
    {
    }

    Projected project(Vec3 const& point) const
    {
        Projected result;
        result.homogeneous = to_plane_.leftCols<3>() * point + to_plane_.col(3);
        double const w = result.homogeneous.w();
        if (w > kMinW) {
            result.place = w == 1 ? Vec3(result.homogeneous.head<3>())
                                  : Vec3(result.homogeneous.head<3>() / w);
            result.is_inside = result.place.x() >= low_.x() && result.place.x() <= high_.x()
                && result.place.y() >= low_.y() && result.place.y() <= high_.y();
        }
        return result;
    }

    // Clips a line to the clip planes; returns false if nothing of it remains.
    bool line(Projected const& from, Projected const& to, ProjectedSkeleton::Line& result) const
    {
        if (from.is_inside && to.is_inside) [[likely]]
            set(from.place, to.place, result);
        else
            return clip(from.homogeneous, to.homogeneous, result);
        return true;
    }

private:
    static void set(Vec3 const& from, Vec3 const& to, ProjectedSkeleton::Line& result)
    {
        result.from = from.head<2>().cast<float>();
        result.to = to.head<2>().cast<float>();
        result.depth_from = static_cast<float>(from.z());
        result.depth_to = static_cast<float>(to.z());
    }

    // Clips a line that is not entirely within the clip planes, by the Liang-Barsky method.
    bool clip(Eigen::Vector4d const& from, Eigen::Vector4d const& to,
              ProjectedSkeleton::Line& result) const
    {
        Eigen::Matrix<double, 5, 1> inside_from = planes_ * from;
        Eigen::Matrix<double, 5, 1> inside_to = planes_ * to;
        inside_from[0] -= kMinW;
        inside_to[0] -= kMinW;
        double begin = 0;
        double end = 1;
        for (int i = 0; i < 5; ++i) {
            if (inside_from[i] < 0 && inside_to[i] < 0)
                return false;
            if (inside_from[i] < 0)
                begin = std::max(begin, inside_from[i] / (inside_from[i] - inside_to[i]));
            else if (inside_to[i] < 0)
                end = std::min(end, inside_from[i] / (inside_from[i] - inside_to[i]));
        }
        if (begin > end)
            return false;
        auto const at = [&](double share) {
            Eigen::Vector4d const point = from + share * (to - from);
            return Vec3(point.head<3>() / point.w());
        };
        set(at(begin), at(end), result);
        return true;
    }

    Eigen::Matrix4d to_plane_;
    Vec2 low_;
    Vec2 high_;
    ClipPlanes planes_;
};

// The point of a line that is nearest to the pen: its distance from the pen and its depth.
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

void ProjectedSkeleton::project(Plant const& plant, SkeletonProjection const& view)
{
    CHECK((view.max.array() >= view.min.array()).all());
    min_ = view.min.cast<float>();
    max_ = view.max.cast<float>();
    find_lines(plant, view);
    lay_grid();
    build_grid();
}

void ProjectedSkeleton::find_lines(Plant const& plant, SkeletonProjection const& view)
{
    // Each axis has a range of lines of its own, so that several threads can write at once.
    // Invisible lines are removed afterwards.
    std::vector<std::uint32_t> first_line(plant.axes.size() + 1);
    for (AxisId id = 0; id < plant.axes.size(); ++id) {
        auto const& axis = plant.axes[id];
        first_line[id + 1]
            = first_line[id] + (axis.order > view.max_order ? 0 : axis.segment_count);
    }
    lines_.resize(first_line.back());
    LineProjector const projector(view);
    std::atomic<bool> is_all_seen = true;
    constexpr std::size_t kAxesPerPiece = 512;
    parallel_for(plant.axes.size(), kAxesPerPiece, [&](std::size_t begin, std::size_t end) {
        bool is_seen = true;
        for (auto id = begin; id < end; ++id) {
            auto const& axis = plant.axes[id];
            if (axis.order > view.max_order)
                continue;
            auto const nodes = plant.positions(axis);
            auto from = projector.project(nodes[0]);
            for (std::uint32_t i = 0; i < axis.segment_count; ++i) {
                auto const to = projector.project(nodes[i + 1]);
                auto& line = lines_[first_line[id] + i];
                bool const seen = projector.line(from, to, line);
                line.segment = seen ? axis.first_segment + i : kNone;
                is_seen &= seen;
                from = to;
            }
        }
        if (!is_seen)
            is_all_seen = false;
    });
    if (!is_all_seen)
        std::erase_if(lines_, [](Line const& line) { return line.segment == kNone; });
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

// Calls visit(cell index) for each cell that the line may pass: row by row, for all columns between
// the points where the line enters and leaves the row.
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
    auto const low_cell = cell_at(low);
    auto const high_cell = cell_at(high);
    if (low_cell.row == high_cell.row
        && low_cell.column == high_cell.column) // Most lines are short enough to lie in one cell.
        return visit(index_of(low_cell));
    int const last_row = high_cell.row;
    for (int row = low_cell.row; row <= last_row; ++row) {
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

void ProjectedSkeleton::lay_grid()
{
    Vec2f const size = max_ - min_;
    double const cells
        = std::clamp(static_cast<double>(lines_.size()) * kCellsPerLine, kFewestCells, kMaxCells);
    float const area = std::max(size.x() * size.y(), std::numeric_limits<float>::min());
    cell_size_ = std::max(std::sqrt(area / static_cast<float>(cells)), size.maxCoeff() / 4096);
    if (!(cell_size_ > 0))
        cell_size_ = 1;
    columns_ = static_cast<int>(size.x() / cell_size_) + 1;
    rows_ = static_cast<int>(size.y() / cell_size_) + 1;
}

// Sorts the lines into cells by counting. Each thread handles a contiguous share of the lines, and
// the lines of a cell keep their order, so the number of threads makes no difference.
void ProjectedSkeleton::build_grid()
{
    auto const cells = index_of({ 0, rows_ });
    std::size_t const shares
        = lines_.size() < kLinesWorthThreads ? 1 : static_cast<std::size_t>(thread_count());
    auto const share = [&](std::size_t number) { return lines_.size() * number / shares; };
    next_in_cell_.resize(shares);
    parallel_for(shares, 1, [&](std::size_t begin, std::size_t end) {
        for (auto number = begin; number < end; ++number) {
            auto& count = next_in_cell_[number];
            count.assign(cells, 0);
            for (auto i = share(number); i < share(number + 1); ++i)
                for_each_cell(lines_[i], [&](std::size_t cell) { ++count[cell]; });
        }
    });

    first_in_cell_.resize(cells + 1);
    std::uint32_t sum = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        first_in_cell_[cell] = sum;
        for (auto& next : next_in_cell_)
            sum += std::exchange(next[cell], sum);
    }
    first_in_cell_[cells] = sum;
    in_cell_.resize(sum);
    parallel_for(shares, 1, [&](std::size_t begin, std::size_t end) {
        for (auto number = begin; number < end; ++number) {
            auto& next = next_in_cell_[number];
            for (auto i = share(number); i < share(number + 1); ++i)
                for_each_cell(lines_[i], [&](std::size_t cell) {
                    in_cell_[next[cell]++] = static_cast<std::uint32_t>(i);
                });
        }
    });
}

// Calls visit(line, nearest point of the line) for the lines within `reach` of the pen, if the pen
// is within the view. A line may be visited several times.
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
    float min_depth = std::numeric_limits<float>::infinity();
    float min_distance = reach;
    for_each_near(point.cast<float>(), reach, [&](Line const& line, auto const& nearest) {
        if (nearest.distance <= half_width && nearest.depth < min_depth) {
            min_depth = nearest.depth;
            covering = line.segment;
        }
        if (nearest.distance < min_distance || !beside) {
            min_distance = nearest.distance;
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

} // namespace tractus::variation
