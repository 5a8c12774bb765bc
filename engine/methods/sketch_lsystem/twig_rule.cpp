#include "engine/methods/sketch_lsystem/twig_rule.h"

#include "engine/stroke/polyline.h"
#include "engine/stroke/resample.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fmt/format.h>
#include <limits>
#include <numeric>
#include <optional>

namespace tractus::sketch {

namespace {

// Assumed inaccuracy of hand drawing: standard deviations of positions on the axis (kPlace_mm) and
// of logarithms of lengths (kLength).
constexpr double kPlace_mm = 0.7;
// Standard deviation of positions on the axis as a share of the axis's length; used where it
// exceeds kPlace_mm.
constexpr double kPlaceShare = 0.008;
constexpr double kLength = 0.06;

// Smooths tremor out of a line with a moving average over 8 mm, or over a tenth of the line if it
// is shorter than 80 mm. The ends of the line stay where they are.
std::vector<Vec3> steady(std::vector<Vec3> const& points)
{
    constexpr std::size_t kPoints = 201;
    constexpr double kMean_mm = 8;
    auto const line = resample(points, kPoints);
    double const length_mm = polyline_length_mm(line);
    double const share = std::min(0.05, kMean_mm / 2 / std::max(length_mm, 1e-9));
    auto const reach = static_cast<std::size_t>(share * static_cast<double>(kPoints));
    std::vector<Vec3> result;
    for (std::size_t i = 0; i < line.size(); ++i) {
        auto const wide = std::min({ reach, i, line.size() - 1 - i });
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = i - wide; k <= i + wide; ++k)
            sum += line[k];
        result.push_back(sum / static_cast<double>(2 * wide + 1));
    }
    return result;
}

struct Foot {
    double away_mm = std::numeric_limits<double>::infinity();
    double at_mm = 0; // Arc length from the line's beginning to the foot.
};

Foot foot_on(std::vector<Vec3> const& line, Vec3 const& point)
{
    Foot best;
    double at_mm = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        double const share = nearest_share(point, line[i - 1], line[i]);
        double const piece_mm = (line[i] - line[i - 1]).norm();
        double const away_mm = (line[i - 1] + share * (line[i] - line[i - 1]) - point).norm();
        if (away_mm < best.away_mm)
            best = { away_mm, at_mm + share * piece_mm };
        at_mm += piece_mm;
    }
    return best;
}

// A drawn lateral, ordered from its foot outwards.
struct Lateral {
    std::vector<Vec3> line;
    // Index of the parent lateral; no value: the axis is the parent.
    std::optional<std::size_t> parent;
    double at_mm = 0;     // Arc length along the parent to the lateral's foot.
    double length_mm = 0; // Length of the lateral's chord.
    int depth = 1;

    Vec3 way() const { return (line.back() - line.front()).normalized(); }
};

// Finds the parent of each lateral: the axis if an end of the lateral touches it; otherwise another
// lateral that passes near one of the ends; failing that, the axis.
std::vector<Lateral> attach(std::vector<Vec3> const& axis, DrawnTwig const& twig)
{
    std::vector<Lateral> laterals;
    for (auto const& points : twig.laterals_mm)
        laterals.push_back({ .line = steady(points), .parent = {} });
    double const near_mm = std::max(3.0, 0.04 * polyline_length_mm(axis));
    std::vector<bool> is_attached(laterals.size(), false);
    auto const attach_to = [&](std::vector<Vec3> const& line, std::optional<std::size_t> parent,
                               double most_mm, int depth) {
        for (std::size_t i = 0; i < laterals.size(); ++i) {
            if (is_attached[i] || parent == i)
                continue;
            auto& lateral = laterals[i];
            auto const begin = foot_on(line, lateral.line.front());
            auto const end = foot_on(line, lateral.line.back());
            if (std::min(begin.away_mm, end.away_mm) > most_mm)
                continue;
            if (end.away_mm < begin.away_mm)
                std::reverse(lateral.line.begin(), lateral.line.end());
            lateral.at_mm = std::min(begin, end, [](Foot const& a, Foot const& b) {
                                return a.away_mm < b.away_mm;
                            }).at_mm;
            lateral.parent = parent;
            lateral.depth = depth;
            is_attached[i] = true;
        }
    };
    // A lateral of a lateral may end near the axis. In the first pass, only laterals that touch the
    // axis are therefore attached to it.
    double const touches_mm = std::max(1.5, 0.008 * polyline_length_mm(axis));
    attach_to(axis, std::nullopt, touches_mm, 1);
    constexpr int kDeepest = 6;
    for (int depth = 2; depth <= kDeepest; ++depth)
        for (std::size_t i = 0; i < laterals.size(); ++i)
            if (is_attached[i] && laterals[i].depth == depth - 1)
                attach_to(std::vector<Vec3>(laterals[i].line), i, near_mm, depth);
    attach_to(axis, std::nullopt, std::numeric_limits<double>::infinity(), 1);
    for (auto& lateral : laterals)
        lateral.length_mm = (lateral.line.back() - lateral.line.front()).norm();
    return laterals;
}

// A ring pattern for the axis's laterals. Nodes are numbered from 0, the first node above the base.
struct Ring {
    int laterals = 1; // Number of laterals at each node.
    int bare = 0;
    double ratio = 0.9;
    double first_mm = 30;
    double length_share = 0.62;
    double cost = std::numeric_limits<double>::infinity();
};

// Distance of node `number` from the axis's base, as a multiple of the first internode's length.
double node_place(double ratio, int number)
{
    double sum = 0;
    double internode = 1;
    for (int i = 0; i <= number; ++i) {
        sum += internode;
        internode *= ratio;
    }
    return sum;
}

// Fits `first_mm` and `length_share` of `ring` to the laterals, for the given ratio. Returns the
// sum of squared residuals, each divided by its standard deviation.
double squares(std::vector<Lateral const*> const& laterals, Ring& ring, double place_mm)
{
    double top = 0;
    double bottom = 0;
    double log_sum = 0;
    for (std::size_t i = 0; i < laterals.size(); ++i) {
        int const node = static_cast<int>(i) / ring.laterals + ring.bare;
        double const place = node_place(ring.ratio, node);
        top += place * laterals[i]->at_mm;
        bottom += place * place;
        log_sum += std::log(laterals[i]->length_mm) - node * std::log(ring.ratio);
    }
    auto const count = static_cast<double>(laterals.size());
    ring.first_mm = top / bottom;
    ring.length_share = std::exp(log_sum / count) / ring.first_mm;
    double sum = 0;
    for (std::size_t i = 0; i < laterals.size(); ++i) {
        int const node = static_cast<int>(i) / ring.laterals + ring.bare;
        double const off_mm = laterals[i]->at_mm - ring.first_mm * node_place(ring.ratio, node);
        double const off_log
            = std::log(laterals[i]->length_mm
                       / (ring.length_share * ring.first_mm * std::pow(ring.ratio, node)));
        sum += std::pow(off_mm / place_mm, 2) + std::pow(off_log / kLength, 2);
    }
    return sum;
}

Ring find_ring(std::vector<Lateral const*> const& laterals, double axis_mm)
{
    constexpr int kMaxLaterals = 8;
    constexpr int kMaxBare = 3;
    constexpr double kStep = 0.0025;
    double const place_mm = std::max(kPlace_mm, kPlaceShare * axis_mm);
    Ring best;
    for (int count = 1; count <= std::min<int>(kMaxLaterals, static_cast<int>(laterals.size()));
         ++count)
        for (int bare = 0; bare <= kMaxBare; ++bare)
            for (double ratio = 0.5; ratio <= 1.2; ratio += kStep) {
                Ring ring { .laterals = count, .bare = bare, .ratio = ratio };
                double const sum = squares(laterals, ring, place_mm);
                auto const missing = static_cast<int>(laterals.size()) % count;
                // Penalties favour simple rules: few bare nodes, and no laterals missing at the
                // topmost node.
                ring.cost = sum + 3.0 * bare + (missing > 0 ? 6 : 0) - 0.01 * count;
                if (ring.cost < best.cost)
                    best = ring;
            }
    return best;
}

// Heading of an axis and two unit vectors across it: the left and down vectors of a turtle
// (drawn_axis.h).
struct Frame {
    Vec3 heading { 0, 0, 1 };
    Vec3 left { -1, 0, 0 };
    Vec3 down { 0, 1, 0 };

    void turn_to(Vec3 const& way)
    {
        auto const turn = Eigen::Quaterniond::FromTwoVectors(heading, way);
        heading = way;
        left = turn * left;
        down = turn * down;
    }
};

// Node, branching angle and azimuth of one lateral of the axis.
struct Turned {
    int node = 0;
    double angle_deg = 0;
    double azimuth_deg = 0;
};

std::vector<Turned> turns_of(std::vector<Lateral const*> const& laterals, Ring const& ring,
                             std::vector<Vec3> const& axis)
{
    ArcLength const along(axis);
    std::vector<Turned> turns;
    Frame frame;
    int reached = -1;
    Vec3 before = axis.front();
    for (std::size_t i = 0; i < laterals.size(); ++i) {
        int const node = static_cast<int>(i) / ring.laterals + ring.bare;
        for (; reached < node; ++reached) {
            Vec3 const next
                = along.at(ring.first_mm * node_place(ring.ratio, reached + 1) / along.length_mm());
            if ((next - before).norm() > 1e-6)
                frame.turn_to((next - before).normalized());
            before = next;
        }
        Vec3 const way = laterals[i]->way();
        turns.push_back({ node, degrees(std::acos(std::clamp(way.dot(frame.heading), -1.0, 1.0))),
                          degrees(std::atan2(way.dot(frame.down), way.dot(frame.left))) });
    }
    return turns;
}

struct Twist {
    double deg = 0;
    double deviation_deg = 0;
};

// Finds the rotation between the rings of successive nodes, within 180/k degrees either way: a ring
// of k laterals looks the same when turned by 360/k degrees.
Twist find_twist(std::vector<Turned> const& turns, int laterals)
{
    constexpr double kStep_deg = 0.25;
    Twist best;
    double most = -1;
    double const half_deg = 180.0 / laterals;
    for (double twist_deg = half_deg; twist_deg > -half_deg; twist_deg -= kStep_deg) {
        std::complex<double> sum;
        for (auto const& turn : turns)
            sum += std::polar(1.0, radians(laterals * (turn.azimuth_deg - twist_deg * turn.node)));
        double const agreement = std::abs(sum) / static_cast<double>(turns.size());
        double const nearer_0 = 1e-9 * std::fabs(twist_deg);
        if (agreement - nearer_0 > most) {
            most = agreement - nearer_0;
            best.deg = twist_deg;
        }
    }
    // Standard deviation of a narrow circular normal distribution whose mean resultant length is
    // `most`.
    best.deviation_deg = degrees(std::sqrt(-2 * std::log(std::clamp(most, 1e-6, 1.0)))) / laterals;
    return best;
}

Result<std::vector<Vec3>> checked_line(std::vector<Vec3> const& points, std::string const& name)
{
    auto distinct = distinct_points(points);
    if (!distinct || polyline_length_mm(*distinct) < 0.5)
        return fail(Fault::User,
                    fmt::format("{} is only a dot, or has a point that is no number: draw it at "
                                "least half a millimetre long",
                                name));
    return distinct;
}

double mean_of(std::vector<double> const& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation_of(std::vector<double> const& values)
{
    double const mean = mean_of(values);
    double sum = 0;
    for (auto const value : values)
        sum += (value - mean) * (value - mean);
    return std::sqrt(sum / static_cast<double>(values.size()));
}

// Appends the branching angles and the logarithms of relative lengths of laterals that are attached
// to other laterals.
void add_deeper(std::vector<Lateral> const& laterals, std::vector<double>& angles_deg,
                std::vector<double>& log_shares)
{
    for (auto const& lateral : laterals) {
        if (!lateral.parent)
            continue;
        auto const& parent = laterals[*lateral.parent];
        angles_deg.push_back(
            degrees(std::acos(std::clamp(lateral.way().dot(parent.way()), -1.0, 1.0))));
        log_shares.push_back(std::log(lateral.length_mm / parent.length_mm));
    }
}

} // namespace

static TwigRule fit(std::vector<Lateral> const& laterals, std::vector<Vec3> const& axis)
{
    std::vector<Lateral const*> of_axis;
    TwigRule result;
    for (auto const& lateral : laterals) {
        result.order = std::max(result.order, lateral.depth);
        if (!lateral.parent)
            of_axis.push_back(&lateral);
    }
    std::stable_sort(of_axis.begin(), of_axis.end(),
                     [](Lateral const* a, Lateral const* b) { return a->at_mm < b->at_mm; });
    auto const ring = find_ring(of_axis, polyline_length_mm(axis));
    auto const turns = turns_of(of_axis, ring, axis);
    auto const twist = find_twist(turns, ring.laterals);
    std::vector<double> angles_deg;
    std::vector<double> log_shares;
    double spacing = 0;
    double shortest_mm = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < of_axis.size(); ++i) {
        int const node = turns[i].node;
        double const internode_mm = ring.first_mm * std::pow(ring.ratio, node);
        double const off_mm = of_axis[i]->at_mm - ring.first_mm * node_place(ring.ratio, node);
        spacing += std::pow(off_mm / internode_mm, 2) / static_cast<double>(of_axis.size());
        angles_deg.push_back(turns[i].angle_deg);
        log_shares.push_back(std::log(of_axis[i]->length_mm / internode_mm));
        shortest_mm = std::min({ shortest_mm, internode_mm, of_axis[i]->length_mm });
    }
    // Only laterals of the axis determine the rule, because it is less certain which lateral bears
    // a deeper one.
    double const angle_deg = mean_of(angles_deg);
    double const log_share = mean_of(log_shares);
    add_deeper(laterals, angles_deg, log_shares);
    auto& rule = result.rule;
    rule.laterals = ring.laterals;
    rule.first_length_mm = ring.first_mm;
    rule.length_ratio = ring.ratio;
    rule.first_width_mm = 0.15 * ring.first_mm;
    rule.angle_deg = angle_deg;
    rule.lateral_length = std::exp(log_share);
    rule.axis_twist_deg = twist.deg;
    rule.lateral_twist_deg = 180.0 / ring.laterals;
    rule.shortest_mm = std::min(0.9 * shortest_mm, ring.first_mm);
    result.nodes = turns.back().node - ring.bare + 1;
    result.bare_nodes = ring.bare;
    result.angle_deviation_deg = deviation_of(angles_deg);
    result.length_deviation = deviation_of(log_shares);
    result.spacing_deviation = std::sqrt(spacing);
    result.twist_deviation_deg = twist.deviation_deg;
    double const across = std::sin(radians(std::clamp(rule.angle_deg, 0.0, 180.0)));
    result.misfit = std::sqrt(std::pow(radians(result.angle_deviation_deg), 2)
                              + std::pow(result.length_deviation, 2) + spacing
                              + std::pow(across * radians(result.twist_deviation_deg), 2));
    return result;
}

Result<TwigRule> find_twig_rule(DrawnTwig const& twig)
{
    if (twig.laterals_mm.empty() || twig.laterals_mm.size() > kMaxTwigLaterals)
        return fail(Fault::User,
                    fmt::format("the twig has {} laterals: draw 1 to {}, three and more for a rule "
                                "that can be told",
                                twig.laterals_mm.size(), kMaxTwigLaterals));
    DrawnTwig drawn { .axis_mm = TRY(checked_line(twig.axis_mm, "the axis")), .laterals_mm = {} };
    for (auto const& lateral : twig.laterals_mm)
        drawn.laterals_mm.push_back(
            TRY(checked_line(lateral, fmt::format("lateral {}", drawn.laterals_mm.size() + 1))));
    auto const axis = steady(drawn.axis_mm);
    auto result = fit(attach(axis, drawn), axis);
    // Values that are slightly out of range through inaccurate drawing are moved into range.
    result.rule.length_ratio = std::clamp(result.rule.length_ratio, 0.5, 1.2);
    result.rule.lateral_length = std::clamp(result.rule.lateral_length, 0.2, 1.0);
    result.rule.angle_deg = std::min(result.rule.angle_deg, 150.0);
    TRY(check_rule(result.rule));
    return result;
}

} // namespace tractus::sketch
