#include "engine/methods/silhouettes/branch.h"

#include "engine/base/check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace tractus::silhouette {

namespace {

constexpr std::array kTangentShares { 0.5, 1.0, 1.5, 2.0 };
// Maximum distance by which a branch may leave the outline, as a share of the outline's diagonal.
constexpr double kMaxOutside = 0.01;
constexpr std::size_t kChords = 16;
// A new sample of the branching angle replaces earlier samples that differ from it in t by less
// than this.
constexpr double kSameSample = 0.05;

double curve_length(Cubic const& curve)
{
    double length = 0;
    Vec2 before = curve.base;
    for (std::size_t i = 1; i <= kChords; ++i) {
        Vec2 const point = curve.at(static_cast<double>(i) / kChords);
        length += (point - before).norm();
        before = point;
    }
    return length;
}

Vec2 direction_at(std::span<Vec2 const> trunk, std::size_t sample)
{
    auto const next = std::min(sample + 1, trunk.size() - 1);
    return direction_of(trunk[next] - trunk[sample > 0 ? sample - 1 : 0]);
}

// Candidate bases with their distances from the branch's end, nearest first. A branch is never
// shorter than its chord, so the search for the shortest branch can stop early.
std::vector<std::pair<double, std::size_t>> bases_by_distance(BranchSearch const& search,
                                                              Vec2 const& end)
{
    std::vector<std::pair<double, std::size_t>> bases;
    for (auto k = search.bases.first; k <= search.bases.last; ++k)
        bases.emplace_back((search.trunk[k] - end).norm(), k);
    std::sort(bases.begin(), bases.end());
    return bases;
}

} // namespace

BranchingAngles::BranchingAngles()
    : samples_ { { 0, 80 }, { 1, 35 } }
{
}

BranchingAngles::BranchingAngles(std::vector<Sample> samples, double over)
    : samples_(std::move(samples))
    , over_(over)
{
    CHECK(!samples_.empty());
    std::sort(samples_.begin(), samples_.end(),
              [](Sample const& a, Sample const& b) { return a.t < b.t; });
}

double BranchingAngles::at_deg(double t) const
{
    if (t <= samples_.front().t)
        return samples_.front().angle_deg;
    for (std::size_t i = 1; i < samples_.size(); ++i) {
        auto const& a = samples_[i - 1];
        auto const& b = samples_[i];
        if (t <= b.t)
            return a.angle_deg + (b.angle_deg - a.angle_deg) * (t - a.t) / (b.t - a.t);
    }
    return samples_.back().angle_deg;
}

void BranchingAngles::learn(Sample const& sample)
{
    std::erase_if(samples_,
                  [&](Sample const& other) { return std::fabs(other.t - sample.t) < kSameSample; });
    auto const after = std::find_if(samples_.begin(), samples_.end(),
                                    [&](Sample const& other) { return other.t > sample.t; });
    samples_.insert(after, sample);
}

Vec2 chord_to_share(Cubic const& curve, double share)
{
    double const wanted = share * curve_length(curve);
    double length = 0;
    Vec2 before = curve.base;
    for (std::size_t i = 1; i <= kChords; ++i) {
        Vec2 const point = curve.at(static_cast<double>(i) / kChords);
        double const chord = (point - before).norm();
        if (length + chord >= wanted && chord > 0)
            return before + (wanted - length) / chord * (point - before) - curve.base;
        length += chord;
        before = point;
    }
    return before - curve.base;
}

namespace {

// Rotates a curve's base tangent until the chord over the share `over` of the curve's length makes
// the angle with the parent that the tangent made before. Chord and tangent differ where a curve
// bends early.
void settle_angle(Cubic& curve, Vec2 const& along, double over)
{
    constexpr double kMax_deg = 170;
    double const reach = curve.base_tangent.norm();
    auto const angle_to
        = [&](Vec2 const& way) { return std::atan2(cross(along, way), along.dot(way)); };
    double const wanted = angle_to(curve.base_tangent);
    double start = wanted;
    for (int i = 0; i < 5; ++i) {
        start += wanted - angle_to(chord_to_share(curve, over));
        start = std::clamp(start, -radians(kMax_deg), radians(kMax_deg));
        curve.base_tangent = reach * turned(along, start);
    }
}

} // namespace

BranchCurve branch_from(BranchSearch const& search, std::size_t sample, BranchEnd const& to,
                        double share)
{
    auto const& base = search.trunk[sample];
    Vec2 const along = direction_at(search.trunk, sample);
    BranchCurve branch;
    branch.trunk_sample = sample;
    branch.t = static_cast<double>(sample) / static_cast<double>(search.trunk.size() - 1);
    branch.side = cross(along, to.end - base) > 0 ? Side::Left : Side::Right;
    branch.tangent_share = share;
    double const reach = share * (to.end - base).norm();
    Vec2 const start
        = turned(along, sign_of(branch.side) * radians(search.angles.at_deg(branch.t)));
    branch.curve = { base, to.end, reach * start, reach * to.tangent };
    if (search.angles.over() > 0 && reach > 0)
        settle_angle(branch.curve, along, search.angles.over());
    branch.length = curve_length(branch.curve);
    return branch;
}

namespace {

// Cost of a branch in the choice of its base: its length, or how far its chord is from the
// branching angle, in degrees.
double cost_of(BranchSearch const& search, BranchCurve const& branch)
{
    if (search.angles.bases() == BranchingAngles::Bases::Nearest)
        return branch.length;
    Vec2 const along = direction_at(search.trunk, branch.trunk_sample);
    Vec2 const chord = branch.curve.end - branch.curve.base;
    double const angle_deg = degrees(std::fabs(std::atan2(cross(along, chord), along.dot(chord))));
    return std::fabs(angle_deg - search.angles.at_deg(branch.t));
}

} // namespace

BranchCurve infer_branch(BranchSearch const& search, BranchEnd const& to)
{
    double const limit
        = search.outline.empty() ? 0 : kMaxOutside * box_of(search.outline).diagonal();
    auto const bases = bases_by_distance(search, to.end);
    bool const shortest_wins = search.angles.bases() == BranchingAngles::Bases::Nearest;
    std::optional<BranchCurve> least;
    for (double const share : kTangentShares) {
        std::optional<BranchCurve> best;
        double best_cost = 0;
        for (auto const& [distance, sample] : bases) {
            if (best && shortest_wins && distance > best->length)
                break;
            auto branch = branch_from(search, sample, to, share);
            double const cost = cost_of(search, branch);
            if (best && cost >= best_cost - 1e-9)
                continue;
            if (!search.outline.empty())
                branch.outside = excursion(search.outline, branch.curve.points(kChords + 1));
            if (branch.outside <= limit) {
                best = branch;
                best_cost = cost;
            } else if (!least || branch.outside < least->outside - 1e-9) {
                least = branch;
            }
        }
        if (best)
            return *best;
    }
    return *least;
}

namespace {

// Cumulative lengths at a polyline's points, as shares of its length.
std::vector<double> shares_along(std::span<Vec2 const> line)
{
    std::vector<double> shares { 0 };
    for (std::size_t i = 1; i < line.size(); ++i)
        shares.push_back(shares.back() + (line[i] - line[i - 1]).norm());
    for (auto& share : shares)
        share /= std::max(shares.back(), 1e-300);
    return shares;
}

} // namespace

BranchCurve drawn_branch(BranchSearch const& search, std::span<Vec2 const> stroke)
{
    auto const sample = bases_by_distance(search, stroke.front()).front().second;
    BranchCurve branch;
    branch.trunk_sample = sample;
    branch.t = static_cast<double>(sample) / static_cast<double>(search.trunk.size() - 1);
    auto& curve = branch.curve;
    curve.base = search.trunk[sample];
    curve.end = stroke.back();
    branch.side = cross(direction_at(search.trunk, sample), curve.end - curve.base) > 0
        ? Side::Left
        : Side::Right;
    // Normal equations for the curve's tangents at both ends. A small weight pulls both tangents
    // towards the chord, for strokes of few points.
    Vec2 const way = curve.end - curve.base;
    constexpr double kToStraight = 1e-3;
    double aa = kToStraight;
    double ab = 0;
    double bb = kToStraight;
    Vec2 a = kToStraight * way;
    Vec2 b = kToStraight * way;
    auto const shares = shares_along(stroke);
    for (std::size_t i = 0; i < stroke.size(); ++i) {
        double const x = shares[i];
        double const begins = x * (1 - x) * (1 - x);
        double const ends = x * x * (x - 1);
        double const step = x * x * (3 - 2 * x);
        Vec2 const rest = stroke[i] - (1 - step) * curve.base - step * curve.end;
        aa += begins * begins;
        ab += begins * ends;
        bb += ends * ends;
        a += begins * rest;
        b += ends * rest;
    }
    double const determinant = aa * bb - ab * ab;
    curve.base_tangent = (bb * a - ab * b) / determinant;
    curve.end_tangent = (aa * b - ab * a) / determinant;
    branch.length = curve_length(curve);
    branch.tangent_share = way.norm() > 0 ? curve.base_tangent.norm() / way.norm() : 0;
    if (!search.outline.empty())
        branch.outside = excursion(search.outline, curve.points(kChords + 1));
    return branch;
}

double cone_angle_deg(double radius, double distance)
{
    constexpr double kNarrowest_deg = 20;
    constexpr double kWidest_deg = 110;
    double const share = distance > 0 ? std::clamp(radius / distance, 0.0, 1.0) : 1;
    return kNarrowest_deg + (kWidest_deg - kNarrowest_deg) * share;
}

namespace {

std::vector<Vec2> points_of(std::span<Vec2 const> outline, Arc const& arc)
{
    std::vector<Vec2> points { outline[arc.first] };
    for (auto i = arc.first; i != arc.last;) {
        i = static_cast<std::uint32_t>((i + 1) % outline.size());
        points.push_back(outline[i]);
    }
    return points;
}

// The part of a bump's arc inside the cone at the branch's base; at least the samples beside the
// bump's tip.
std::vector<Vec2> shared_with(std::span<Vec2 const> outline, Bump const& bump, Cubic const& branch,
                              double cone_deg)
{
    auto const arc = points_of(outline, bump.arc);
    Vec2 const axis = direction_of(branch.end - branch.base);
    double const least = std::cos(radians(cone_deg / 2));
    auto const is_in_cone = [&](Vec2 const& point) {
        return (point - branch.base).dot(axis) >= least * (point - branch.base).norm();
    };
    auto const nearest
        = std::min_element(arc.begin(), arc.end(), [&](auto const& a, auto const& b) {
              return (a - bump.tip).squaredNorm() < (b - bump.tip).squaredNorm();
          });
    auto const tip = static_cast<std::size_t>(nearest - arc.begin());
    auto low = tip;
    auto high = tip;
    while (low > 0 && is_in_cone(arc[low - 1]))
        --low;
    while (high + 1 < arc.size() && is_in_cone(arc[high + 1]))
        ++high;
    low = std::min(low, tip > 0 ? tip - 1 : 0);
    high = std::max(high, std::min(tip + 1, arc.size() - 1));
    return { arc.begin() + static_cast<std::ptrdiff_t>(low),
             arc.begin() + static_cast<std::ptrdiff_t>(high) + 1 };
}

} // namespace

std::vector<Vec2> lens_crown(Cubic const& branch)
{
    constexpr std::size_t kPoints = 9;
    // Half the lens's greatest width, as a share of the branch's length.
    constexpr double kWidest = 0.22;
    auto const middle = branch.points(kPoints);
    double const width = kWidest * curve_length(branch);
    std::vector<Vec2> right;
    std::vector<Vec2> left;
    for (std::size_t i = 1; i + 1 < kPoints; ++i) {
        Vec2 const across = turned(direction_of(middle[i + 1] - middle[i - 1]), kPi / 2);
        double const share = static_cast<double>(i) / (kPoints - 1);
        double const off = width * std::sin(kPi * share);
        right.push_back(middle[i] - off * across);
        left.push_back(middle[i] + off * across);
    }
    std::vector<Vec2> lens { middle.front() };
    lens.insert(lens.end(), right.begin(), right.end());
    lens.push_back(middle.back());
    lens.insert(lens.end(), left.rbegin(), left.rend());
    return lens;
}

std::vector<Vec2> crown_of(std::span<Vec2 const> outline, Bump const& bump, Cubic const& branch)
{
    constexpr double kWidestStart_deg = 80;
    constexpr std::size_t kPoints = 9;
    double const cone_deg = cone_angle_deg(bump.radius, (branch.end - branch.base).norm());
    auto const shared = shared_with(outline, bump, branch, cone_deg);
    Vec2 const start = direction_of(branch.at(1.0 / kChords) - branch.base);
    double const open = radians(std::min(cone_deg / 2, kWidestStart_deg));
    auto const& first = shared.front();
    auto const& last = shared.back();
    double const reach_first = (first - branch.base).norm() / 2;
    double const reach_last = (last - branch.base).norm() / 2;
    Cubic const up { branch.base, first, reach_first * turned(start, -open),
                     reach_first * direction_of(shared[1] - first) };
    Cubic const down { last, branch.base,
                       reach_last * direction_of(last - shared[shared.size() - 2]),
                       -reach_last * turned(start, open) };
    auto crown = up.points(kPoints);
    crown.pop_back();
    crown.insert(crown.end(), shared.begin(), shared.end());
    auto const back = down.points(kPoints);
    crown.insert(crown.end(), back.begin() + 1, back.end() - 1);
    return crown;
}

} // namespace tractus::silhouette
