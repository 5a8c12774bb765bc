#include "app/methods/sketch_lsystem/rule_gizmo.h"

#include "app/methods/sketch_lsystem/model_gizmo.h"
#include "app/methods/sketch_lsystem/sketch_options.h"
#include "engine/base/vectors.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <utility>

namespace tractus::sketch {

namespace {

using Color = tools::LayerStyle::Color;

// Length of the parent branch in the gizmo's frame. The part below kBase is not drawn.
constexpr double kParent = 0.86;
constexpr double kWidth = 0.13; // Width at which the parent branch is drawn.
// Distance of the handle for a twist from the end of the part whose next ring it turns.
constexpr double kDial = 0.24;
constexpr double kAside = 0.3; // Distance of the handle for a width from its part, at width 1.
// Tilt of the view: a point is drawn lower by this share of its distance in front of the picture's
// plane.
constexpr double kTilt = 0.35;
// Length at which the laterals of the next rings are drawn, as a share of their true length.
constexpr double kRing = 0.5;
constexpr double kSpreadWidth = 0.018;
Vec2 const kBase { 0, -0.95 };
Vec2 const kNode { 0, -0.25 };

enum HandleId : std::size_t {
    LateralEnd,
    LateralTwist,
    LateralWidth,
    TopEnd,
    TopTwist,
    TopWidth,
    Fewer,
    More
};

// Projects a point to the picture. The parent branch is vertical, and the first lateral is in the
// picture's plane. Points in front of this plane are drawn lower, as if seen from above.
Vec2 seen(Vec3 const& point)
{
    return { point.x(), point.y() - kTilt * point.z() };
}

// Returns the direction at the angle `angle` to `ahead`, rotated by `around` about `ahead`. If
// `around` is 0, the direction is on the side of `aside`, which is perpendicular to `ahead`.
Vec3 turned(Vec3 const& ahead, Vec3 const& aside, double angle, double around)
{
    Vec3 const out = std::cos(around) * aside + std::sin(around) * aside.cross(ahead);
    return std::cos(angle) * ahead + std::sin(angle) * out;
}

Vec2 from_up(double angle)
{
    return { std::sin(angle), std::cos(angle) };
}

// Positions of a rule's handles in the gizmo.
struct Places {
    explicit Places(sketch::Rule const& rule)
        : angle(radians(rule.angle_deg))
        , top_end(kNode + Vec2(0, kParent * rule.length_ratio))
        , lateral_end(kNode + kParent * rule.lateral_length * from_up(angle))
    {
    }

    double angle;
    Vec2 top_end;
    Vec2 lateral_end;
};

// Adds the ring of laterals at the end of a part. `ahead` is the direction of this part and
// `length` its length.
void add_ring(tools::Gizmo& gizmo, sketch::Rule const& rule, Vec2 const& end, Vec3 const& ahead,
              Vec3 const& aside, double length, double twist_deg)
{
    for (int i = 0; i < rule.laterals; ++i) {
        double const around = radians(twist_deg + 360.0 * i / rule.laterals);
        Vec3 const way = turned(ahead, aside, radians(rule.angle_deg), around);
        gizmo.lines.push_back({ { end, end + kRing * rule.lateral_length * length * seen(way) },
                                0.3 * kWidth,
                                Color::Grey });
    }
}

void add_parts(tools::Gizmo& gizmo, sketch::Rule const& rule)
{
    Places const at(rule);
    gizmo.lines.push_back({ { kBase, kNode }, kWidth, Color::Grey });
    gizmo.lines.push_back({ { kNode, at.top_end }, kWidth * rule.width_ratio, Color::Green });
    add_ring(gizmo, rule, at.top_end, Vec3::UnitY(), Vec3::UnitX(), kParent * rule.length_ratio,
             rule.axis_twist_deg);
    double const length = kParent * rule.lateral_length;
    for (int i = 0; i < rule.laterals; ++i) {
        double const around = radians(360.0 * i / rule.laterals);
        Vec3 const out = turned(Vec3::UnitY(), Vec3::UnitX(), radians(90), around);
        Vec3 const ahead = turned(Vec3::UnitY(), Vec3::UnitX(), at.angle, around);
        Vec3 const aside = std::cos(at.angle) * out - std::sin(at.angle) * Vec3::UnitY();
        Vec2 const end = kNode + length * seen(ahead);
        gizmo.lines.push_back(
            { { kNode, end }, kWidth * rule.lateral_width, i == 0 ? Color::Blue : Color::Grey });
        add_ring(gizmo, rule, end, ahead, aside, length, rule.lateral_twist_deg);
    }
}

// An arc with centre `middle` that spans the directions from `angle` - `half` to `angle` + `half`.
tools::Gizmo::Line arc(Vec2 const& middle, double radius, double angle, double half)
{
    constexpr int kSteps = 8;
    tools::Gizmo::Line line { {}, kSpreadWidth, Color::Grey };
    for (int i = -kSteps; i <= kSteps; ++i)
        line.points.push_back(middle + radius * from_up(angle + half * i / kSteps));
    return line;
}

// Shows how much the plants of a collection vary: the sector in which a lateral's tip can be, and
// arcs for the twists. The arcs are outside the handles at the tips of the lateral and of the top
// internode.
void add_spread(tools::Gizmo& gizmo, sketch::Rule const& rule)
{
    if (rule.laterals == 0)
        return;
    Places const at(rule);
    constexpr double kOutside = 1.75; // Radius of the arcs, as a multiple of kDial.
    auto const most = [](double deviation) { return sketch::kMaxDeviations * deviation; };
    double const reach = (1 + most(sketch::kRuleSpread.share)) * (at.lateral_end - kNode).norm();
    auto edge = arc(kNode, reach, at.angle, radians(most(sketch::kRuleSpread.angle_deg)));
    for (Vec2 const& end : { edge.points.front(), edge.points.back() })
        gizmo.lines.push_back({ { kNode, end }, kSpreadWidth, Color::Grey });
    gizmo.lines.push_back(std::move(edge));
    double const twist = radians(most(sketch::kRuleSpread.twist_deg));
    gizmo.lines.push_back(
        arc(at.lateral_end, kOutside * kDial, at.angle + radians(rule.lateral_twist_deg), twist));
    gizmo.lines.push_back(arc(at.top_end, kOutside * kDial, radians(rule.axis_twist_deg), twist));
}

std::string share(char const* name, double value)
{
    return fmt::format("{} {:.3g}", name, value);
}

void add_handles(tools::Gizmo& gizmo, sketch::Rule const& rule)
{
    Places const at(rule);
    auto const add = [&](HandleId id, Vec2 const& place, char const* sign, char const* number,
                         std::string says) {
        gizmo.handles.push_back({ id, place, std::move(says), sign, false, number });
    };
    add(TopEnd, at.top_end, "D", "ratio", share("Lengthening", rule.length_ratio));
    add(TopWidth, (kNode + at.top_end) / 2 - Vec2(kAside * rule.width_ratio, 0), "F", "width",
        share("Thinning", rule.width_ratio));
    if (rule.laterals > 0) {
        Vec2 const across = from_up(at.angle - radians(90));
        add(LateralEnd, at.lateral_end, "A", "angle",
            fmt::format("Angle {:.3g}\u00b0, length {:.3g}", rule.angle_deg, rule.lateral_length));
        add(LateralWidth, (kNode + at.lateral_end) / 2 - kAside * rule.lateral_width * across, "C",
            "lateral_width", share("Lateral's thickness", rule.lateral_width));
        add(LateralTwist,
            at.lateral_end + kDial * from_up(at.angle + radians(rule.lateral_twist_deg)), "B",
            "lateral_twist", fmt::format("Laterals' twist {:.3g}\u00b0", rule.lateral_twist_deg));
        add(TopTwist, at.top_end + kDial * from_up(radians(rule.axis_twist_deg)), "E", "twist",
            fmt::format("Twist {:.3g}\u00b0", rule.axis_twist_deg));
    }
    auto const laterals = fmt::format("{} lateral{}", rule.laterals, rule.laterals == 1 ? "" : "s");
    gizmo.handles.push_back({ Fewer, { 0.58, -0.86 }, laterals, "-", true });
    gizmo.handles.push_back({ More, { 0.86, -0.86 }, laterals, "+", true });
}

tools::Gizmo show_rule(void const* options)
{
    auto const& tool = *static_cast<SketchTool const*>(options);
    if (auto const model = model_of(tool); model.is_set())
        return show_model(model);
    auto const rule = rule_of(tool);
    tools::Gizmo gizmo;
    add_parts(gizmo, rule);
    // The preset Plant copies the active plant, whose rule cannot be edited with this gizmo.
    if (tool.card == SketchTool::Card::Plant)
        for (auto& line : gizmo.lines)
            line.color = Color::Grey;
    if (tool.card == SketchTool::Card::Plant)
        return gizmo;
    add_spread(gizmo, rule);
    add_handles(gizmo, rule);
    return gizmo;
}

// Rounds to the nearest multiple of `coarse` if this is close, otherwise to the nearest multiple of
// `fine` (a fifth of `coarse`). Limits the result to the range from `least` to `greatest`.
double snapped(double value, double coarse, double fine, double least, double greatest)
{
    // Maximum distance to a multiple of `coarse`, as a share of `fine`. It is so small that the
    // neighbouring multiples of `fine` can still be set.
    constexpr double kReach = 0.8;
    double const near = std::round(value / coarse) * coarse;
    double const taken
        = std::abs(near - value) <= kReach * fine ? near : std::round(value / fine) * fine;
    // Dividing by a whole number gives exactly 0.7, for example, instead of 0.7000000000000001.
    double const in_one = std::round(1 / fine);
    return std::clamp(std::round(taken * in_one) / in_one, least, greatest);
}

double snapped_share(double value, double least, double greatest)
{
    return snapped(value, 0.05, 0.01, least, greatest);
}

double snapped_deg(double angle, double min_deg, double greatest_deg)
{
    return snapped(angle / radians(1), 5, 1, min_deg, greatest_deg);
}

// Angle from up to a direction, positive to the right.
double angle_from_up(Vec2 const& way)
{
    return std::atan2(way.x(), way.y());
}

void drag_rule(void* options, std::size_t handle, Vec2 const& to)
{
    auto& tool = *static_cast<SketchTool*>(options);
    auto rule = rule_of(tool);
    Places const at(rule);
    Vec2 const across = from_up(at.angle - radians(90));
    switch (handle) {
    case LateralEnd:
        rule.angle_deg = snapped_deg(std::abs(angle_from_up(to - kNode)), 0, 150);
        rule.lateral_length = snapped_share((to - kNode).norm() / kParent, 0.2, 1);
        break;
    case LateralTwist:
        rule.lateral_twist_deg
            = wrap_angle_deg(snapped_deg(angle_from_up(to - at.lateral_end) - at.angle, -360, 360));
        break;
    case LateralWidth:
        rule.lateral_width
            = snapped_share(-(to - (kNode + at.lateral_end) / 2).dot(across) / kAside, 0.2, 1);
        break;
    case TopEnd:
        rule.length_ratio = snapped_share((to - kNode).y() / kParent, 0.5, 1.2);
        break;
    case TopTwist:
        rule.axis_twist_deg = snapped_deg(angle_from_up(to - at.top_end), -180, 180);
        break;
    case TopWidth:
        rule.width_ratio = snapped_share((kNode.x() - to.x()) / kAside, 0.3, 1);
        break;
    // Sets the option rather than the rule, since the preset's twist depends on the number of
    // laterals.
    default: {
        double const more = handle == More ? 1 : -1;
        tool.laterals = std::clamp(std::round(tool.laterals) + more, 0.0, 8.0);
        return;
    }
    }
    tool = with_options_of_rule(tool, rule);
}

} // namespace

constexpr tools::GizmoKind kRuleGizmo { .title = "Rule", .show = show_rule, .drag = drag_rule };

} // namespace tractus::sketch
