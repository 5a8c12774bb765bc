#include "engine/methods/silhouettes/crown_line.h"

#include "engine/methods/silhouettes/plane.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace tractus::silhouette {

namespace {

constexpr double kBetweenAzimuths_deg = 360.0 / kAzimuths;

// Plan view: x to the right, y behind the sheet.
Vec2 plan_of(Vec3 const& point)
{
    return { point.x(), point.z() };
}

std::vector<Vec2> plan_of(CrownLine const& line)
{
    std::vector<Vec2> plan;
    for (auto const& point : line)
        plan.push_back(plan_of(point));
    return plan;
}

double length_in_space(CrownLine const& line)
{
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        length += (line[i] - line[i - 1]).norm();
    return length;
}

bool comes_back_in_space(CrownLine const& line)
{
    // Largest gap between the ends of a closed line, as a share of its length; the same as for
    // outlines on the sheet (outline.cpp).
    constexpr double kWidestGap = 0.25;
    return (line.back() - line.front()).norm() <= kWidestGap * length_in_space(line);
}

// Principal axis of a line's plan view, and the plan's extents along the axis and across it.
struct PlanSpread {
    Vec2 middle = Vec2::Zero();
    Vec2 along = Vec2::UnitX();
    double length = 0;
    double width = 0;
};

PlanSpread spread_of(std::vector<Vec2> const& plan)
{
    PlanSpread spread;
    spread.middle
        = std::accumulate(plan.begin(), plan.end(), Vec2(0, 0)) / static_cast<double>(plan.size());
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (auto const& point : plan) {
        Vec2 const off = point - spread.middle;
        xx += off.x() * off.x();
        xy += off.x() * off.y();
        yy += off.y() * off.y();
    }
    double const angle = 0.5 * std::atan2(2 * xy, xx - yy);
    spread.along = { std::cos(angle), std::sin(angle) };
    Vec2 low(1e300, 1e300);
    Vec2 high(-1e300, -1e300);
    for (auto const& point : plan) {
        Vec2 const off = point - spread.middle;
        Vec2 const at(off.dot(spread.along), cross(spread.along, off));
        low = low.cwiseMin(at);
        high = high.cwiseMax(at);
    }
    spread.length = high.x() - low.x();
    spread.width = high.y() - low.y();
    return spread;
}

double wrapped_turn(double angle)
{
    return angle - 2 * kPi * std::round(angle / (2 * kPi));
}

// Number of turns that a line's plan view makes around a point.
double turns_around(std::vector<Vec2> const& plan, Vec2 const& middle)
{
    double angle = 0;
    for (std::size_t i = 1; i < plan.size(); ++i) {
        Vec2 const a = plan[i - 1] - middle;
        Vec2 const b = plan[i] - middle;
        angle += std::atan2(cross(a, b), a.dot(b));
    }
    return std::fabs(angle) / (2 * kPi);
}

// Adds the intersections of a segment with the half planes at all azimuths. Both ends are in the
// trunk's frame.
void cross_azimuths(Vec3 const& from, Vec3 const& to, Crossings& crossings)
{
    double const begin = std::atan2(from.y(), from.x());
    double const turn = wrapped_turn(std::atan2(to.y(), to.x()) - begin);
    double const step = radians(kBetweenAzimuths_deg);
    double const low = std::min(begin, begin + turn);
    double const high = std::max(begin, begin + turn);
    for (auto k = static_cast<long>(std::ceil(low / step)); static_cast<double>(k) * step < high;
         ++k) {
        double const theta = static_cast<double>(k) * step;
        Vec2 const ray(std::cos(theta), std::sin(theta));
        double const before = cross(ray, Vec2(from.head<2>()));
        double const after = cross(ray, Vec2(to.head<2>()));
        double const share
            = before != after ? std::clamp(before / (before - after), 0.0, 1.0) : 0.5;
        Vec3 const at = from + share * (to - from);
        auto const azimuth = static_cast<std::size_t>(
            (k % static_cast<long>(kAzimuths) + static_cast<long>(kAzimuths))
            % static_cast<long>(kAzimuths));
        crossings[azimuth].emplace_back(at.z(), std::max(0.0, ray.dot(at.head<2>())));
    }
}

// Adds the intersections of a line with the half planes at all azimuths, in the line's order.
// Returns the line's number of turns around the trunk.
double cross_azimuths(CrownLine const& line, TrunkFrame const& trunk, Crossings& crossings)
{
    std::vector<Vec2> plan;
    for (std::size_t i = 0; i < line.size(); ++i) {
        Vec3 const at = trunk.of(line[i]);
        plan.emplace_back(at.head<2>());
        if (i > 0)
            cross_azimuths(trunk.of(line[i - 1]), at, crossings);
    }
    return turns_around(plan, Vec2::Zero());
}

// Centre of a climbing line in plan view: the mean over each point and the points half a turn
// before and after it. This is unbiased if the distance grows or falls evenly.
Vec2 middle_of_climb(std::vector<Vec2> const& plan, Vec2 middle)
{
    constexpr int kRounds = 4;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<double> turns { 0 };
        for (std::size_t i = 1; i < plan.size(); ++i) {
            Vec2 const a = plan[i - 1] - middle;
            Vec2 const b = plan[i] - middle;
            turns.push_back(turns.back() + std::atan2(cross(a, b), a.dot(b)));
        }
        double const sign = turns.back() < 0 ? -1 : 1;
        for (auto& turn : turns)
            turn *= sign;
        Vec2 sum = Vec2::Zero();
        double count = 0;
        std::size_t before = 1;
        std::size_t after = 1;
        for (std::size_t i = 1; i < plan.size(); ++i) {
            while (before < i && turns[before] < turns[i] - kPi)
                ++before;
            while (after < plan.size() && turns[after] < turns[i] + kPi)
                ++after;
            if (turns[i] < kPi || after >= plan.size() || turns[before - 1] > turns[i] - kPi)
                continue;
            auto const at = [&](std::size_t k, double turn) -> Vec2 {
                double const step = turns[k] - turns[k - 1];
                double const share
                    = step > 0 ? std::clamp((turn - turns[k - 1]) / step, 0.0, 1.0) : 0;
                return plan[k - 1] + share * (plan[k] - plan[k - 1]);
            };
            sum += plan[i] / 2 + (at(before, turns[i] - kPi) + at(after, turns[i] + kPi)) / 4;
            count += 1;
        }
        if (count == 0)
            return middle;
        middle = sum / count;
    }
    return middle;
}

tl::unexpected<Error> not_around(char const* what, CrownLine const& line)
{
    return fail(Fault::User,
                fmt::format("the {} at {:.0f} mm does not go around the trunk: draw it around that",
                            what, mean_height(line)));
}

} // namespace

Result<CrownLineKind> kind_of(CrownLine const& line)
{
    constexpr double kMin_mm = 2;
    // A line that rises by at most this share of its greatest width counts as a ring, however many
    // turns it makes.
    constexpr double kFlat = 0.12;
    constexpr double kTilted = 0.25;
    // Maximum number of turns of a ring. A closing stroke usually overshoots its beginning a
    // little.
    constexpr double kMaxRing = 1.35;
    constexpr double kMinClimb = 1.25;
    constexpr double kInPlane = 0.2;
    for (auto const& point : line)
        if (!point.allFinite())
            return fail(Fault::User, "a line of the crown has places that are no numbers");
    auto const plan = plan_of(line);
    if (line.size() < 4)
        return fail(Fault::User, "a dot says nothing of a crown: draw a ring around the trunk");
    auto const spread = spread_of(plan);
    auto const [low, high] = std::minmax_element(
        line.begin(), line.end(), [](Vec3 const& a, Vec3 const& b) { return a.y() < b.y(); });
    double const rise = high->y() - low->y();
    if (std::max(spread.length, rise) < kMin_mm)
        return fail(Fault::User, "a dot says nothing of a crown: draw a ring around the trunk");
    double const turns = turns_around(plan, spread.middle);
    bool const is_closed = comes_back_in_space(line);
    bool const is_thin = spread.width <= kInPlane * spread.length;
    if (is_closed && rise <= kTilted * spread.length && turns > 0.6
        && (turns <= kMaxRing || rise <= kFlat * spread.length))
        return CrownLineKind::Ring;
    if (is_closed && is_thin && turns < kMinClimb)
        return CrownLineKind::Side;
    if (turns >= kMinClimb)
        return CrownLineKind::Climb;
    return fail(Fault::User,
                "the line does not say where the crown is: draw a ring around the trunk at one "
                "height, a line that winds around it as it climbs, or an outline in an upright "
                "plane");
}

double azimuth_deg(CrownLine const& side)
{
    Vec2 const along = spread_of(plan_of(side)).along;
    double const angle_deg = degrees(std::atan2(along.y(), along.x()));
    double const turned_deg = angle_deg - 180 * std::floor(angle_deg / 180);
    return turned_deg < 180 ? turned_deg : 0;
}

Vec2 plan_middle(CrownLine const& line)
{
    auto const plan = plan_of(line);
    double const area = signed_area(plan);
    auto const kind = kind_of(line);
    if (kind && *kind == CrownLineKind::Climb)
        return middle_of_climb(plan, box_of(plan).middle());
    if (!kind || *kind != CrownLineKind::Ring || area == 0)
        return box_of(plan).middle();
    Vec2 sum = Vec2::Zero();
    // Reference point close to the line, for numerical accuracy of the sums.
    Vec2 const from = plan.front();
    for (std::size_t i = 0; i < plan.size(); ++i) {
        Vec2 const a = plan[i] - from;
        Vec2 const b = plan[(i + 1) % plan.size()] - from;
        sum += cross(a, b) * (a + b);
    }
    return from + sum / (6 * area);
}

double mean_height(CrownLine const& line)
{
    double sum = 0;
    for (auto const& point : line)
        sum += point.y();
    return sum / static_cast<double>(line.size());
}

bool takes_place_of(CrownLine const& line, CrownLine const& other)
{
    constexpr double kSameHeight_mm = 4;
    constexpr double kSameAzimuth_deg = 10;
    auto const kind = kind_of(line);
    auto const other_kind = kind_of(other);
    if (!kind || !other_kind || *kind != *other_kind)
        return false;
    if (*kind == CrownLineKind::Ring)
        return std::fabs(mean_height(line) - mean_height(other)) <= kSameHeight_mm;
    if (*kind == CrownLineKind::Climb)
        return true;
    double const off_deg = azimuth_deg(line) - azimuth_deg(other);
    return std::fabs(off_deg - 180 * std::round(off_deg / 180)) <= kSameAzimuth_deg;
}

Result<void> add_ring(CrownLine const& ring, TrunkFrame const& trunk, Crossings& crossings)
{
    auto closed = ring;
    closed.push_back(closed.front());
    Crossings found;
    double const turns = cross_azimuths(closed, trunk, found);
    bool const is_around = turns > 0.5
        && std::none_of(found.begin(), found.end(), [](auto const& at) { return at.empty(); });
    if (!is_around)
        return not_around("ring", ring);
    for (std::size_t azimuth = 0; azimuth < kAzimuths; ++azimuth) {
        auto const& at = found[azimuth];
        crossings[azimuth].emplace_back(std::accumulate(at.begin(), at.end(), Vec2(0, 0))
                                        / static_cast<double>(at.size()));
    }
    return {};
}

Result<void> add_climb(CrownLine const& climb, TrunkFrame const& trunk, Crossings& crossings)
{
    Crossings found;
    double const turns = cross_azimuths(climb, trunk, found);
    bool const is_around = turns >= 1
        && std::none_of(found.begin(), found.end(), [](auto const& at) { return at.empty(); });
    if (!is_around)
        return not_around("climbing line", climb);
    for (std::size_t azimuth = 0; azimuth < kAzimuths; ++azimuth)
        crossings[azimuth].insert(crossings[azimuth].end(), found[azimuth].begin(),
                                  found[azimuth].end());
    return {};
}

} // namespace tractus::silhouette
