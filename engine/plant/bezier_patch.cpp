#include "engine/plant/bezier_patch.h"

namespace tractus {

namespace {

std::array<double, 4> bernstein(double x)
{
    double const y = 1 - x;
    return { y * y * y, 3 * x * y * y, 3 * x * x * y, x * x * x };
}

std::array<double, 4> bernstein_slope(double x)
{
    double const y = 1 - x;
    return { -3 * y * y, 3 * y * (1 - 3 * x), 3 * x * (2 - 3 * x), 3 * x * x };
}

Vec3 blend(std::array<Vec3, 16> const& control, std::array<double, 4> const& across,
           std::array<double, 4> const& along)
{
    Vec3 sum = Vec3::Zero();
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            sum += across[row] * along[column] * control[4 * row + column];
    return sum;
}

// Matrix from the four control points of a cubic in another basis to its Bézier points: row i holds
// the weights for the i-th Bézier point.
using BasisMatrix = std::array<std::array<double, 4>, 4>;

constexpr BasisMatrix kFromBSpline { { { 1.0 / 6, 4.0 / 6, 1.0 / 6, 0 },
                                       { 0, 4.0 / 6, 2.0 / 6, 0 },
                                       { 0, 2.0 / 6, 4.0 / 6, 0 },
                                       { 0, 1.0 / 6, 4.0 / 6, 1.0 / 6 } } };

// A Catmull-Rom spline: the tangent at a point is half the chord between its two neighbours.
constexpr BasisMatrix kFromCardinal {
    { { 0, 1, 0, 0 }, { -1.0 / 6, 1, 1.0 / 6, 0 }, { 0, 1.0 / 6, 1, -1.0 / 6 }, { 0, 0, 1, 0 } }
};

} // namespace

Vec3 BezierPatch::at(double s, double t) const
{
    return blend(control, bernstein(s), bernstein(t));
}

Vec3 BezierPatch::normal_at(double s, double t) const
{
    return blend(control, bernstein_slope(s), bernstein(t))
        .cross(blend(control, bernstein(s), bernstein_slope(t)));
}

std::array<Vec3, 16> bezier_control(std::array<Vec3, 16> const& control, PatchBasis basis)
{
    if (basis == PatchBasis::Bezier)
        return control;
    auto const& matrix = basis == PatchBasis::BSpline ? kFromBSpline : kFromCardinal;
    std::array<Vec3, 16> result;
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            result[4 * row + column] = blend(control, matrix[row], matrix[column]);
    return result;
}

} // namespace tractus
