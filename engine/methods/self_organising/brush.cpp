#include "engine/methods/self_organising/brush.h"

#include "engine/base/random.h"
#include "engine/methods/self_organising/cell_index.h"
#include "engine/methods/self_organising/life.h"
#include "engine/methods/self_organising/wood.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <set>
#include <utility>

namespace tractus::self_organising {

namespace {

constexpr std::uint32_t kSowStream = 0x50EE;
// Side of a cell in internodes: on average there is one marker per two cubic internodes.
constexpr double kCellInternodes = 1.26;
constexpr double kMostInCell = 3; // A cell gets 0 to 2 markers, fewer than this number.
constexpr std::size_t kMostSownCells = 4'000'000;

// Internode length along a sweep. It is shorter than the habit's if the brush is small, so that a
// few internodes fit into the ball.
double internode_mm(BrushSweep const& sweep, Habit const& habit)
{
    constexpr double kInternodesInRadius = 4;
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

    // Adds the markers of the cells that the balls before number `end` newly cover.
    Result<void> sow_until(std::size_t end, std::vector<Vec3>& markers)
    {
        for (; next_ < end; ++next_) {
            auto const& ball = sweep_.balls[next_];
            if (next_ == 0) {
                TRY(cover(ball.centre, ball.radius, markers));
                continue;
            }
            auto const& last = sweep_.balls[next_ - 1];
            double const way = (ball.centre - last.centre).norm();
            double const pieces = std::ceil(std::max(way / (0.5 * side_), 1.0));
            TRY(check_cells(pieces));
            for (double k = 1; k <= pieces; ++k)
                TRY(cover(last.centre + (ball.centre - last.centre) * (k / pieces),
                          last.radius + (ball.radius - last.radius) * (k / pieces), markers));
        }
        return {};
    }

private:
    Result<void> check_cells(double count) const
    {
        if (count <= static_cast<double>(kMostSownCells))
            return {};
        return fail(
            Fault::User,
            fmt::format("the brush sweeps over more than {} cells of {:g} mm: draw smaller, "
                        "or give a habit with longer internodes",
                        kMostSownCells, side_));
    }

    Result<void> cover(Vec3 const& centre, double radius, std::vector<Vec3>& markers)
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
                    if (is_covered && covered_.insert({ i, j, k }).second)
                        fill({ i, j, k }, markers);
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
        auto const count = static_cast<int>(random.uniform(0, kMostInCell));
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

// Number of balls that the brush has passed by the end of a year; all of them in the last year.
std::size_t balls_until(BrushSweep const& sweep, int year)
{
    auto const& balls = sweep.balls;
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
    if (sweep.years < 1 || sweep.years > kMostYears)
        return fail(
            Fault::User,
            fmt::format("along a stroke a tree grows for 1 to {} years, and {} are asked for",
                        kMostYears, sweep.years));
    for (auto const& ball : sweep.balls)
        if (!(ball.radius > 0) || !std::isfinite(ball.radius) || !ball.centre.allFinite())
            return fail(Fault::User, "the brush has no radius: give one above 0 mm");
    return {};
}

} // namespace

Result<std::vector<Vec3>> sow(BrushSweep const& sweep, Habit const& habit)
{
    TRY(check_sweep(sweep));
    std::vector<Vec3> markers;
    TRY(Sower(sweep, habit).sow_until(sweep.balls.size(), markers));
    return markers;
}

Result<void> grow_along(GrowingTree& tree, BrushSweep const& sweep, Habit const& habit,
                        std::uint64_t seed)
{
    TRY(check_habit(habit));
    TRY(check_sweep(sweep));
    if (sweep.balls.empty())
        return {};
    Surroundings surroundings { .seed = seed };
    Sower sower(sweep, habit);
    for (int year = 1; year <= sweep.years; ++year) {
        auto const count = balls_until(sweep, year);
        TRY(sower.sow_until(count, surroundings.markers));
        auto const laws = laws_of_brush(habit, tree.step + 1, internode_mm(sweep, habit));
        auto const& ball = sweep.balls[count - 1];
        if (sweep.waits_outside)
            surroundings.region = Region { ball.centre, ball.radius + laws.perception_radius };
        TRY(grow_step(tree, surroundings, laws));
    }
    tree.is_brushed = true;
    auto const laws = laws_in_year(habit, tree.step);
    set_wood(tree, diameters(tree, laws), sag_laws(habit));
    return {};
}

} // namespace tractus::self_organising
