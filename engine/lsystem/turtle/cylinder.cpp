#include "engine/lsystem/turtle/cylinder.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::lsystem {

namespace {

constexpr double kMinLength_mm = 1e-5;
constexpr int kMaxRings = 1000;

// Coefficients of a cubic polynomial, in ascending powers of t.
using Cubic = std::array<Vec3, 4>;

Vec3 value(Cubic const& c, double t)
{
    return ((c[3] * t + c[2]) * t + c[1]) * t + c[0];
}

Vec3 slope(Cubic const& c, double t)
{
    return (3 * c[3] * t + 2 * c[2]) * t + c[1];
}

Cubic hermite(Vec3 const& p, Vec3 const& q, Vec3 const& slope_p, Vec3 const& slope_q)
{
    return { p, slope_p, 3 * (q - p) - 2 * slope_p - slope_q, 2 * (p - q) + slope_p + slope_q };
}

Cubic bspline(Vec3 const& a, Vec3 const& b, Vec3 const& c, Vec3 const& d)
{
    return { (a + 4 * b + c) / 6, (c - a) / 2, (a - 2 * b + c) / 2, (d - a) / 6 + (b - c) / 2 };
}

Vec3 unit_or(Vec3 const& v, Vec3 const& otherwise)
{
    double const length = v.norm();
    return length > 1e-9 ? Vec3(v / length) : otherwise;
}

// Moves a normal by parallel transport from the direction `from` to the direction `to`.
Vec3 parallel_transport(Vec3 const& normal, Vec3 const& from, Vec3 const& to)
{
    Vec3 const turned = rotation_between(from, to) * normal;
    return unit_or(turned - turned.dot(to) * to, to.unitOrthogonal());
}

double angle_about(Vec3 const& axis, Vec3 const& from, Vec3 const& to)
{
    return std::atan2(axis.dot(from.cross(to)), from.dot(to));
}

// Returns the coefficients, in ascending powers of t, of the cubic (share of the path, radius)
// between two control points.
std::array<Vec2, 4> radius_curve(CylinderPoint const& from, CylinderPoint const& to,
                                 double tangent_mm)
{
    double const change = to.radius_mm - from.radius_mm;
    auto const tangent = [&](Vec2 const& given) -> Vec2 {
        if (given == Vec2::Zero())
            return { 1, change };
        return { given.x(), given.y() * tangent_mm };
    };
    Vec2 const begin = tangent(from.style.radius_tangents[1]);
    Vec2 const end = tangent(to.style.radius_tangents[0]);
    Vec2 const whole(1, change);
    return { Vec2(0, from.radius_mm), begin, Vec2(3 * whole - 2 * begin - end),
             Vec2(begin + end - 2 * whole) };
}

} // namespace

// The path of one piece and the rotation of its sections about it.
struct CylinderCourse {
    Cubic path;
    // Total rotation of the sections about the path, from one end of the piece to the other.
    double twist_rad = 0;
    int rings = 1;
};

Cylinder::Piece Cylinder::make_piece(CylinderPoint const& to, CylinderCourse const& course) const
{
    auto const& from = current_;
    Piece piece { from, to, {} };
    double const length = (to.position_mm - from.position_mm).norm();
    if (length < kMinLength_mm)
        return piece;
    auto const radii
        = radius_curve(from, to, to.style.scales_radius_tangents ? length : options_.unit_mm);
    for (int i = 1; i < course.rings; ++i) {
        double const r = static_cast<double>(i) / course.rings;
        Vec2 const at = ((radii[3] * r + radii[2]) * r + radii[1]) * r + radii[0];
        CylinderSection section;
        // The tangents may lead beyond the ends of the path.
        double const t = std::clamp(at.x(), -1.0, 2.0);
        section.share = std::clamp(t, 0.0, 1.0);
        section.position_mm = value(course.path, t);
        Vec3 const heading = unit_or(slope(course.path, t), from.heading);
        section.normal = Eigen::AngleAxisd(course.twist_rad * section.share, heading)
            * parallel_transport(from.normal, from.heading, heading);
        section.radius_mm = std::clamp(at.y(), 0.0, 1e6);
        piece.sections.push_back(section);
    }
    piece.sections.push_back({ to.position_mm, to.normal, to.radius_mm, 1 });
    return piece;
}

Cylinder::Piece Cylinder::add(CylinderPoint point, int rings)
{
    rings = std::clamp(rings > 0 ? rings : options_.rings, 1, kMaxRings);
    return is_bspline() ? add_to_bspline(point, rings) : add_to_hermite(std::move(point), rings);
}

Cylinder::Piece Cylinder::add_to_hermite(CylinderPoint point, int rings)
{
    if (count_++ == 0) {
        current_ = point;
        if (options_.path == Path::ClosedHermite)
            first_ = { point };
        return { current_, point, {} };
    }
    CylinderCourse course;
    course.rings = rings;
    Vec3 const level = parallel_transport(current_.normal, current_.heading, point.heading);
    if (options_.twists)
        course.twist_rad = angle_about(point.heading, level, point.normal);
    else
        point.normal = level;
    double const length = (point.position_mm - current_.position_mm).norm();
    course.path = hermite(current_.position_mm, point.position_mm,
                          length * current_.style.tangents[1] * current_.heading,
                          length * point.style.tangents[0] * point.heading);
    auto piece = make_piece(point, course);
    current_ = std::move(point);
    return piece;
}

Cylinder::Piece Cylinder::add_to_bspline(CylinderPoint const& point, int rings)
{
    if (count_++ < 3) {
        last_.push_back(point);
        if (options_.path == Path::ClosedBSpline)
            first_.push_back(point);
        return { point, point, {} };
    }
    CylinderCourse course;
    course.rings = rings;
    course.path = bspline(last_[0].position_mm, last_[1].position_mm, last_[2].position_mm,
                          point.position_mm);
    if (count_ == 4) {
        current_ = last_[1];
        current_.position_mm = value(course.path, 0);
        current_.heading = unit_or(slope(course.path, 0), last_[1].heading);
        current_.normal = parallel_transport(last_[1].normal, last_[1].heading, current_.heading);
    }
    auto end = last_[2];
    end.position_mm = value(course.path, 1);
    end.heading = unit_or(slope(course.path, 1), last_[2].heading);
    end.normal = parallel_transport(current_.normal, current_.heading, end.heading);
    if (options_.twists) {
        Vec3 const own = parallel_transport(last_[2].normal, last_[2].heading, end.heading);
        course.twist_rad = angle_about(end.heading, end.normal, own);
        end.normal = own;
    }
    auto piece = make_piece(end, course);
    current_ = std::move(end);
    last_ = { last_[1], last_[2], point };
    return piece;
}

std::vector<Cylinder::Piece> Cylinder::finish()
{
    std::vector<Piece> pieces;
    if (count_ > first_.size()) // A path with fewer points has nothing to close.
        for (auto const& point : std::exchange(first_, {}))
            pieces.push_back(add(point));
    return pieces;
}

} // namespace tractus::lsystem
