#include "engine/methods/sketch_lsystem/lateral_room.h"

#include "engine/methods/sketch_lsystem/axis_turtle.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tractus::sketch {

namespace {

// A lateral that has room for less than this share of its length does not grow.
constexpr double kMinRoom = 0.25;

// The ends of the internodes of a lateral and of everything that it bears, for a first internode of
// length 1. They are in the order of growth, so that the limit on their number leaves out the
// finest ones.
class LateralCloud {
public:
    explicit LateralCloud(Rule const& rule)
        : rule_(rule)
        , shortest_(shortest_of(rule))
    {
        std::vector<Apex> apices { { .turtle = AxisTurtle(Vec3::Zero()) } };
        for (std::size_t i = 0; i < apices.size() && points_.size() < kMaxPoints; ++i)
            grow(Apex(apices[i]), apices);
    }

    std::vector<Vec3> const& points() const { return points_; }

private:
    static constexpr std::size_t kMaxPoints = 4000;

    // The apex of a lateral. `level` is the index of its lateral rule; if it equals the number of
    // lateral rules, the lateral forks.
    struct Apex {
        std::size_t level = 0;
        int node = 1; // Number of the next node that the apex makes.
        double length = 1;
        AxisTurtle turtle;
    };

    // Minimum length of an internode, as a share of the first internode of the lowest lateral.
    static double shortest_of(Rule const& rule)
    {
        constexpr double kFinest = 0.04;
        double shortest_mm = rule.shortest_mm;
        for (auto const& lateral : rule.lateral_rules)
            shortest_mm = std::min(shortest_mm, lateral.shortest_mm);
        return std::max(kFinest, shortest_mm / (rule.first_length_mm * rule.lateral_length));
    }

    void grow(Apex apex, std::vector<Apex>& apices)
    {
        constexpr double kRounding = 1e-9;
        if (apex.length < shortest_ - kRounding)
            return;
        points_.push_back(apex.turtle.go(apex.length));
        auto const& rules = rule_.lateral_rules;
        bool const forks = apex.level == rules.size();
        auto const ring
            = forks ? (rules.empty() ? ring_of_forks() : rules.back()) : rules[apex.level];
        auto const next = forks ? apex.level : lateral_rule_after(rule_, apex.level);
        for (int i = 0; i < ring.laterals; ++i) {
            Apex lateral { .level = next,
                           .length = apex.length * ring.lateral_length,
                           .turtle = apex.turtle };
            lateral.turtle.roll(ring.twist_deg * (forks ? 1 : apex.node)
                                + 360.0 * i / ring.laterals);
            lateral.turtle.yaw(ring.angle_deg);
            apices.push_back(lateral);
        }
        if (forks)
            return;
        ++apex.node;
        apex.length *= ring.length_ratio;
        apices.push_back(apex);
    }

    // The values of the drawn axis's rule as a LateralRule, for laterals that fork.
    LateralRule ring_of_forks() const
    {
        return { .laterals = rule_.laterals,
                 .angle_deg = rule_.angle_deg,
                 .lateral_length = rule_.lateral_length,
                 .twist_deg = rule_.lateral_twist_deg };
    }

    Rule const& rule_;
    double shortest_;
    std::vector<Vec3> points_;
};

// Vectors from a node of the axis to the nodes on other parts of the axis (lateral_room.h).
std::vector<Vec3> ways_to_other_parts(std::span<Vec3 const> nodes_mm, std::size_t node)
{
    // Two nodes are on one part if their straight distance is at least this share of their distance
    // along the axis. On a circular arc this holds up to a turn of 113 degrees.
    constexpr double kSamePart = 0.85;
    std::vector<double> along_mm { 0 };
    for (std::size_t i = 1; i < nodes_mm.size(); ++i)
        along_mm.push_back(along_mm.back() + (nodes_mm[i] - nodes_mm[i - 1]).norm());
    std::vector<Vec3> ways_mm;
    for (std::size_t i = 0; i < nodes_mm.size(); ++i) {
        Vec3 const way_mm = nodes_mm[i] - nodes_mm[node];
        if (i != node && way_mm.norm() < kSamePart * std::fabs(along_mm[i] - along_mm[node]))
            ways_mm.push_back(way_mm);
    }
    return ways_mm;
}

// The largest share of its size at which a lateral leaves room for other nodes. `ways_mm` lead from
// the lateral's node to these nodes. Of the plane midway along each way, the lateral stays on its
// own side, at least half of `radius_mm` away. A share below kMinRoom becomes 0.
double room_for(std::vector<Vec3> const& lateral_mm, std::vector<Vec3> const& ways_mm,
                double radius_mm)
{
    double room = 1;
    for (auto const& way_mm : ways_mm) {
        double const free_mm = std::max(0.0, (way_mm.norm() - radius_mm) / 2);
        Vec3 const there = way_mm.normalized();
        for (auto const& point_mm : lateral_mm)
            if (double const reach_mm = point_mm.dot(there); reach_mm > free_mm)
                room = std::min(room, free_mm / reach_mm);
    }
    return room < kMinRoom ? 0 : rounded_as_text(std::floor(1000 * room) / 1000);
}

} // namespace

std::vector<double> lateral_room(Rule const& rule, std::span<Vec3 const> nodes_mm,
                                 std::vector<Turn> const& turns)
{
    std::vector<double> room;
    if (nodes_mm.size() < 2)
        return room;
    LateralCloud const cloud(rule);
    AxisTurtle turtle(nodes_mm.front());
    double length_mm = rule.first_length_mm;
    for (std::size_t segment = 0; segment < turns.size(); ++segment) {
        turtle.turn(turns[segment]);
        auto const ways_mm = ways_to_other_parts(nodes_mm, segment + 1);
        for (int i = 0; i < rule.laterals; ++i) {
            auto lateral = turtle;
            lateral.roll(rule.axis_twist_deg * static_cast<double>(segment + 1)
                         + 360.0 * i / rule.laterals);
            lateral.yaw(rule.angle_deg);
            std::vector<Vec3> points_mm;
            if (!ways_mm.empty())
                for (auto const& point : cloud.points())
                    points_mm.push_back(length_mm * rule.lateral_length
                                        * lateral.vector_from_start(point));
            room.push_back(room_for(points_mm, ways_mm, rule.occupancy_radius_mm));
        }
        length_mm *= rule.length_ratio;
    }
    return room;
}

} // namespace tractus::sketch
