#include "engine/lsystem/turtle/organ_catalogue.h"
#include "engine/lsystem/turtle/turtle.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace tractus::lsystem {

namespace {

// Maximum number of placed surfaces, slightly less than the number of shapes that a plant can have.
constexpr std::size_t kMaxPlacedPatches = 60'000;

// Returns the axes of an organ's frame: the turtle's right, its heading and its upper side.
Eigen::Matrix3d organ_axes(TurtleFrame const& frame)
{
    Eigen::Matrix3d axes;
    axes.col(0) = -frame.left;
    axes.col(1) = frame.heading;
    axes.col(2) = -frame.down;
    return axes;
}

} // namespace

// Interprets ~X, ~X(scale) and ~X(across, along, thick): draws an organ or a surface.
void Turtle::add_organ(char letter, Symbol const& symbol)
{
    if (!has_organ(view_, letter))
        warn(fmt::format("{}: no organ {} in the view; ~{} draws a plain leaf", model_.name, letter,
                         letter));
    auto const& frame = state_.frame;
    Organ organ;
    organ.segment = state_.place.segment;
    organ.position_mm = frame.position_mm;
    auto const axes = organ_axes(frame);
    organ.orientation = Quat(axes).normalized();
    double const uniform = symbol.parameter(0, 1);
    for (int i = 0; i < 3; ++i) {
        double const scale
            = symbol.count >= 3 ? symbol.parameter(static_cast<std::size_t>(i), 1) : uniform;
        organ.scale[i] = static_cast<float>(std::clamp(scale * state_.scale, -1e6, 1e6));
    }
    if (organ.scale.squaredNorm() == 0)
        return;
    auto const* const surface = find_surface(view_, letter);
    organ.shape = surface ? drawing_->shape({ OrganShape::Kind::Surface, letter, state_.color, 0 })
                          : drawing_->shape({ OrganShape::Kind::Blade, letter, 0, 0 });
    drawing_->organs.push_back(organ);
    if (!surface)
        return;
    // As in cpfg, the first scale applies to all three coordinates of the surface's end point.
    Vec3 const end_mm = static_cast<double>(organ.scale[0]) * options_.unit_mm * surface->end_point;
    Vec3 const position_mm = state_.frame.position_mm + axes * end_mm;
    if (end_mm.squaredNorm() > 0 && position_mm.cwiseAbs().maxCoeff() < 1e12) {
        state_.frame.position_mm = position_mm;
        state_.place.is_open = false;
    }
}

// Returns the diameter that the symbol gives as its first parameter, or the line width if it has
// none.
double Turtle::diameter(Symbol const& symbol) const
{
    double const given = symbol.count > 0 ? symbol.parameter(0, 0) * state_.scale
                                          : state_.width * view_.width_unit;
    return std::clamp(given, 0.0, 1e6);
}

// Interprets @o and @O (a ball of the given diameter about the turtle) and @c (a flat disc that
// faces the turtle's upper side). Without a parameter the diameter is the line width.
void Turtle::add_round(OrganShape::Kind kind, Symbol const& symbol)
{
    auto const& frame = state_.frame;
    double const size = diameter(symbol);
    if (!(size > 0))
        return;
    Organ organ;
    organ.shape = drawing_->shape({ kind, 0, state_.color, 0 });
    organ.segment = state_.place.segment;
    organ.position_mm = frame.position_mm;
    Eigen::Matrix3d axes;
    bool const is_ball = kind == OrganShape::Kind::Ball;
    axes.col(1) = is_ball ? frame.heading : -frame.down;
    axes.col(0) = -frame.left;
    axes.col(2) = axes.col(0).cross(axes.col(1));
    organ.orientation = Quat(axes).normalized();
    organ.scale = Vec3f::Constant(static_cast<float>(size));
    if (!is_ball) // A disc is flat, but just thick enough to keep its two sides apart.
        organ.scale.y() *= 2e-3f;
    if (is_ball) // The origin of a ball's shape is on its surface.
        organ.position_mm -= size / 2 * options_.unit_mm * frame.heading;
    drawing_->organs.push_back(organ);
}

// Interprets @bc(diameter): a circle about the turtle in the plane of its heading and left, as
// thick as the line; and @bo(diameter): a circle that faces the viewer.
void Turtle::add_circle(Symbol const& symbol)
{
    constexpr int kSides = 32;
    double const radius = diameter(symbol) / 2 * options_.unit_mm;
    if (!(radius > 0))
        return;
    auto const& frame = state_.frame;
    bool const faces_viewer = symbol.name[2] == 'o';
    Vec3 const x = radius * (faces_viewer ? Vec3(Vec3::UnitX()) : Vec3(-frame.left));
    Vec3 const y = radius * (faces_viewer ? Vec3(Vec3::UnitZ()) : frame.heading);
    auto place = state_.place;
    place.is_open = false;
    Vec3 base_mm = frame.position_mm + x;
    for (int i = 1; i <= kSides; ++i) {
        double const angle = 2 * kPi * (i % kSides) / kSides;
        Vec3 const tip_mm = frame.position_mm + std::cos(angle) * x + std::sin(angle) * y;
        drawing_->add_segment(place, base_mm, tip_mm, radius_mm(state_), state_.color);
        base_mm = tip_mm;
    }
}

// Interprets @PS(id[, basis]) (begin a surface), @PC(id, row, column) (set one of its 16 points)
// and @PD(id) (draw it). Bases: 1 Bézier, 2 B-spline, 3 cardinal.
void Turtle::draw_patch_symbol(Symbol const& symbol)
{
    if (symbol.count == 0)
        return warn(fmt::format("{}: left out @P{} without the surface's number", model_.name,
                                symbol.name[2]));
    auto& patch = patches_[symbol.parameters[0]];
    if (symbol.name[2] == 's' || symbol.name[2] == 'S') {
        double const basis = symbol.parameter(1, 1);
        patch = {};
        patch.basis = basis == 2 ? PatchBasis::BSpline
            : basis == 3         ? PatchBasis::Cardinal
                                 : PatchBasis::Bezier;
    } else if (symbol.name[2] == 'c' || symbol.name[2] == 'C') {
        double const row = std::floor(symbol.parameter(1, -1));
        double const column = std::floor(symbol.parameter(2, -1));
        if (!(row >= 0 && row < 4 && column >= 0 && column < 4))
            return warn(
                fmt::format("{}: left out @PC without a row and column from 0 to 3", model_.name));
        auto const point = static_cast<std::size_t>(4 * row + column);
        patch.control[point] = state_.frame.position_mm;
        patch.given |= 1u << point;
    } else if (patch.given == 0xffff) {
        add_patch(patch);
    } else {
        warn(fmt::format("{}: left out @PD before all 16 points are given", model_.name));
    }
}

// Places a surface. Surfaces that differ only in position share one shape.
void Turtle::add_patch(OpenPatch const& open)
{
    auto const axes = organ_axes(state_.frame);
    BezierPatch patch;
    std::array<std::int32_t, 48> rounded {};
    auto const control = bezier_control(open.control, open.basis);
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < 16; ++i) {
        patch.control[i]
            = axes.transpose() * (control[i] - state_.frame.position_mm) / options_.unit_mm;
        box.extend(patch.control[i]);
    }
    double const step = std::max(box.diagonal().norm() * 1e-5, 1e-12);
    for (std::size_t i = 0; i < 48; ++i)
        rounded[i] = static_cast<std::int32_t>(std::clamp(
            std::round(patch.control[i / 3][static_cast<int>(i % 3)] / step), -2e9, 2e9));
    auto const next = static_cast<std::uint32_t>(drawing_->patches.size() + 1);
    if (next > kMaxPlacedPatches)
        return warn(fmt::format("{}: only the first {} surfaces of @PD are drawn", model_.name,
                                kMaxPlacedPatches));
    auto const [number, is_new] = patch_numbers_.try_emplace(rounded, next);
    if (is_new)
        drawing_->patches.push_back(patch);
    auto const [shape, is_new_shape]
        = patch_shapes_.try_emplace({ number->second, state_.color }, OrganShapeId { 0 });
    if (is_new_shape) {
        shape->second = static_cast<OrganShapeId>(drawing_->shape_keys.size());
        drawing_->shape_keys.push_back(
            { OrganShape::Kind::Surface, 0, state_.color, number->second });
    }
    Organ organ;
    organ.shape = shape->second;
    organ.segment = state_.place.segment;
    organ.position_mm = state_.frame.position_mm;
    organ.orientation = Quat(axes).normalized();
    drawing_->organs.push_back(organ);
}

} // namespace tractus::lsystem
