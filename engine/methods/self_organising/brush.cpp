#include "engine/methods/self_organising/brush.h"

#include "engine/base/random.h"
#include "engine/methods/self_organising/cell_index.h"
#include "engine/methods/self_organising/life.h"
#include "engine/methods/self_organising/wood.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <set>
#include <utility>

namespace tractus::self_organising {

namespace {

constexpr std::uint32_t kSowStream = 0x50EE;
// Side of a cell in which markers are sown, in internode lengths: the cell has twice the volume of
// a cube with sides of one internode length. It gets one marker on average.
constexpr double kCellInternodes = 1.26;
// Exclusive upper limit for the random number of markers in a cell: 0, 1 or 2 markers are sown.
constexpr double kMaxInCell = 3;
constexpr std::size_t kMaxSownCells = 4'000'000;

// Internode length along a sweep. It is shorter than the habit's if the brush is small, so that at
// least four internodes fit into the radius of its largest ball; likewise for a small volume.
double internode_mm(BrushSweep const& sweep, Habit const& habit)
{
    constexpr double kInternodesInRadius = 4;
    // Minimum number of internode lengths along the longest side of the box around a volume's ball
    // centres.
    constexpr double kInternodesInVolume = 80;
    if (sweep.is_volume) {
        Eigen::AlignedBox3d box;
        for (auto const& ball : sweep.balls)
            box.extend(ball.centre);
        return std::min(habit.internode_mm,
                        std::max(box.sizes().maxCoeff(), 1.0) / kInternodesInVolume);
    }
    double radius = 0;
    for (auto const& ball : sweep.balls)
        radius = std::max(radius, ball.radius);
    return std::min(habit.internode_mm, radius / kInternodesInRadius);
}

// Sows markers along a sweep, ball by ball.
class Sower {
public:
    Sower(BrushSweep const& sweep, Habit const& habit)
        : sweep_(sweep)
        , side_(kCellInternodes * internode_mm(sweep, habit))
    {
    }

    // Marks the cells of cleared space as covered, so that no markers are sown there.
    Result<void> clear()
    {
        for (auto const& path : sweep_.cleared)
            for (std::size_t i = 0; i < path.size(); ++i)
                TRY(cover_way(path[i > 0 ? i - 1 : 0], path[i], nullptr));
        return {};
    }

    // Adds markers in the cells that are newly covered by the balls before index `end`.
    Result<void> sow_until(std::size_t end, std::vector<Vec3>& markers)
    {
        for (; next_ < end; ++next_) {
            bool const is_alone = next_ == 0 || sweep_.is_volume;
            TRY(cover_way(sweep_.balls[is_alone ? next_ : next_ - 1], sweep_.balls[next_],
                          &markers));
        }
        return {};
    }

private:
    // Covers the cells swept by a ball that moves from `last` to `ball`, excluding `last` itself.
    Result<void> cover_way(BrushBall const& last, BrushBall const& ball, std::vector<Vec3>* markers)
    {
        double const way = (ball.centre - last.centre).norm();
        double const pieces = std::ceil(std::max(way / (0.5 * side_), 1.0));
        TRY(check_cells(pieces));
        for (double k = 1; k <= pieces; ++k)
            TRY(cover(last.centre + (ball.centre - last.centre) * (k / pieces),
                      last.radius + (ball.radius - last.radius) * (k / pieces), markers));
        return {};
    }

    Result<void> check_cells(double count) const
    {
        if (count <= static_cast<double>(kMaxSownCells))
            return {};
        return fail(
            Fault::User,
            fmt::format("the brush sweeps over more than {} cells of {:g} mm: draw smaller, "
                        "or give a habit with longer internodes",
                        kMaxSownCells, side_));
    }

    // Marks the cells in a ball as covered and sows markers in those that were not covered before.
    // Null `markers`: nothing is sown.
    Result<void> cover(Vec3 const& centre, double radius, std::vector<Vec3>* markers)
    {
        double const across = 2 * radius / side_ + 1;
        TRY(check_cells(across * across * across));
        Vec3 const reach = Vec3::Constant(radius);
        auto const low = cell_at(centre - reach, side_);
        auto const high = cell_at(centre + reach, side_);
        for (auto k = low[2]; k <= high[2]; ++k)
            for (auto j = low[1]; j <= high[1]; ++j)
                for (auto i = low[0]; i <= high[0]; ++i) {
                    Vec3 const middle
                        = (Vec3(double(i), double(j), double(k)) + Vec3::Constant(0.5)) * side_;
                    bool const is_covered = (middle - centre).squaredNorm() <= radius * radius;
                    if (is_covered && covered_.insert({ i, j, k }).second && markers)
                        fill({ i, j, k }, *markers);
                }
        return check_cells(static_cast<double>(covered_.size()));
    }

    void fill(Cell const& cell, std::vector<Vec3>& markers) const
    {
        auto const word = [&](std::size_t a) { return static_cast<std::uint32_t>(cell[a]); };
        Random random(
            { sweep_.seed ^ (std::uint64_t { word(0) } << 32 | word(1)), kSowStream, word(2) });
        Vec3 const corner { static_cast<double>(cell[0]), static_cast<double>(cell[1]),
                            static_cast<double>(cell[2]) };
        auto const count = static_cast<int>(random.uniform(0, kMaxInCell));
        for (int n = 0; n < count; ++n) {
            double const x = random.uniform();
            double const y = random.uniform();
            double const z = random.uniform();
            markers.push_back((corner + Vec3(x, y, z)) * side_);
        }
    }

    BrushSweep const& sweep_;
    double side_;
    std::size_t next_ = 0; // Index of the next ball to be sown.
    std::set<Cell> covered_;
};

// Number of balls that the brush has passed by the end of a year. If the years divide the stroke
// evenly, the brush has passed all balls at the end of the last year.
std::size_t balls_until(BrushSweep const& sweep, int year)
{
    auto const& balls = sweep.balls;
    if (sweep.is_volume)
        return balls.size();
    double const share = static_cast<double>(year) / sweep.years;
    double const seconds = sweep.seconds_per_year > 0
        ? sweep.seconds_per_year * sweep.years
        : balls.back().seconds - balls.front().seconds;
    if (year == sweep.years && sweep.seconds_per_year <= 0)
        return balls.size();
    if (!(seconds > 0)) // The stroke has no usable times.
        return static_cast<std::size_t>(std::ceil(share * static_cast<double>(balls.size())));
    double const until = balls.front().seconds + share * seconds;
    auto const end = std::partition_point(
        balls.begin(), balls.end(), [&](BrushBall const& ball) { return ball.seconds <= until; });
    return std::max<std::size_t>(static_cast<std::size_t>(end - balls.begin()), 1);
}

Result<void> check_sweep(BrushSweep const& sweep)
{
    if (sweep.years < 1 || sweep.years > kMaxYears)
        return fail(
            Fault::User,
            fmt::format("along a stroke a tree grows for 1 to {} years, and {} are asked for",
                        kMaxYears, sweep.years));
    TRY(check_balls(sweep.balls));
    for (auto const& path : sweep.cleared)
        TRY(check_balls(path));
    return {};
}

} // namespace

Result<void> check_balls(std::span<BrushBall const> balls)
{
    for (auto const& ball : balls)
        if (!(ball.radius > 0) || !std::isfinite(ball.radius) || !ball.centre.allFinite())
            return fail(Fault::User, "the brush has no radius: give one above 0 mm");
    return {};
}

Result<std::vector<Vec3>> sow(BrushSweep const& sweep, Habit const& habit)
{
    TRY(check_sweep(sweep));
    std::vector<Vec3> markers;
    Sower sower(sweep, habit);
    TRY(sower.clear());
    TRY(sower.sow_until(sweep.balls.size(), markers));
    return markers;
}

std::vector<BrushBall> dense_path(std::span<BrushBall const> balls)
{
    // Maximum distance between the centres of successive balls, as a share of the smaller of their
    // radii.
    constexpr double kStep = 0.25;
    // Maximum number of balls between two given ones, in case a faulty device reports a jump.
    constexpr double kMaxPieces = 10'000;
    std::vector<BrushBall> path;
    for (auto const& ball : balls) {
        if (path.empty()) {
            path.push_back(ball);
            continue;
        }
        auto const last = path.back();
        double const way = (ball.centre - last.centre).norm();
        double const step = kStep * std::min(ball.radius, last.radius);
        bool const is_same = way < step && std::abs(ball.radius - last.radius) < step;
        if (is_same && &ball != &balls.back())
            continue;
        double const pieces = std::clamp(std::ceil(way / step), 1.0, kMaxPieces);
        for (double k = 1; k <= pieces; ++k)
            path.push_back({ last.seconds + (ball.seconds - last.seconds) * (k / pieces),
                             last.centre + (ball.centre - last.centre) * (k / pieces),
                             last.radius + (ball.radius - last.radius) * (k / pieces) });
    }
    return path;
}

Result<void> grow_along(GrowingTree& tree, BrushSweep const& sweep, Habit const& habit,
                        std::uint64_t seed, YearCallback const& on_year)
{
    TRY(check_habit(habit));
    TRY(check_sweep(sweep));
    if (sweep.balls.empty())
        return {};
    Surroundings surroundings { .seed = seed };
    Sower sower(sweep, habit);
    TRY(sower.clear());
    for (int year = 1; year <= sweep.years; ++year) {
        auto const count = balls_until(sweep, year);
        TRY(sower.sow_until(count, surroundings.markers));
        auto const laws = brush_growth_laws(habit, tree.step + 1, internode_mm(sweep, habit));
        auto const& ball = sweep.balls[count - 1];
        if (sweep.waits_outside)
            surroundings.region = Region { ball.centre, ball.radius + laws.perception_radius };
        TRY(grow_step(tree, surroundings, laws));
        tree.is_brushed = true;
        if (on_year)
            on_year(tree);
    }
    tree.is_brushed = true;
    auto const laws = growth_laws_in_year(habit, tree.step);
    set_wood(tree, diameters(tree, laws), sag_laws(habit));
    return {};
}

} // namespace tractus::self_organising
