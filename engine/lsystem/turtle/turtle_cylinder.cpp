#include "engine/lsystem/turtle/turtle.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <iterator>
#include <utility>

namespace tractus::lsystem {

// Converts a parameter to a number of rings; a missing parameter is 0.
static int ring_count(double value)
{
    return static_cast<int>(std::clamp(value, 0.0, 1000.0));
}

// Interprets {: a polygon. With a parameter, it is a generalised cylinder instead: {(1) and {(2)
// along an open and a closed Hermite path, {(3) and {(4) along an open and a closed B-spline path.
// A second parameter sets the number of rings from one control point to the next.
void Turtle::begin_path(Symbol const& symbol)
{
    double const type = symbol.parameter(0, 0);
    if (type == 0) {
        polygons_.push_back({ {}, state_.color });
        return;
    }
    if (!(type >= 1 && type < 5))
        return warn(
            fmt::format("{}: found {{({}), expected a path of type 0 to 4", model_.name, type));
    begin_cylinder(static_cast<Cylinder::Path>(static_cast<int>(type) - 1),
                   ring_count(symbol.parameter(1, 0)));
    state_.path = State::Path::OfSteps;
}

void Turtle::end_path()
{
    if (state_.path == State::Path::None)
        return warn(fmt::format("{}: left out a }}(1) without a {{(1)", model_.name));
    for (auto const& piece : cylinder_.cylinder.finish())
        draw_piece(piece);
    state_.path = State::Path::None;
}

void Turtle::add_dot(Symbol const& symbol)
{
    if (!polygons_.empty())
        polygons_.back().vertices_mm.push_back(state_.frame.position_mm);
    else if (state_.path != State::Path::None)
        add_control_point(ring_count(symbol.parameter(0, 0)));
}

// Interprets @Gs (begin a cylinder), @Gc(rings) (continue it), @Ge(rings) (end it), @Gt(in[, out])
// (tangents of the path) and @Gr (tangents of the radius).
void Turtle::draw_cylinder_symbol(Symbol const& symbol)
{
    auto& style = extras_.style;
    switch (symbol.name[2]) {
    case 't':
        style.tangents[0] = std::clamp(symbol.parameter(0, style.tangents[0]), -1e3, 1e3);
        style.tangents[1] = std::clamp(symbol.parameter(1, style.tangents[0]), -1e3, 1e3);
        return;
    case 'r':
        return set_radius_tangents(symbol);
    default:
        break;
    }
    if (symbol.name[2] == 's' || state_.path == State::Path::None) {
        begin_cylinder(Cylinder::Path::OpenHermite, 0);
        state_.path = State::Path::OfSymbols;
    }
    add_control_point(symbol.count > 0 ? std::max(1, ring_count(symbol.parameter(0, 0))) : 0);
    if (symbol.name[2] == 'e')
        end_path();
}

// Interprets @Gr(factor): radius tangents are proportional to the distance of the points if the
// factor is not 0; and @Gr(angle, length[, angle, length]): tangents after and before the point.
void Turtle::set_radius_tangents(Symbol const& symbol)
{
    auto& style = extras_.style;
    if (symbol.count == 1)
        style.scales_radius_tangents = symbol.parameter(0, 0) != 0;
    for (std::size_t i = 0; i < 2; ++i) {
        std::size_t const from = symbol.count >= 4 ? 2 * i : 0;
        if (symbol.count < from + 2)
            continue;
        double const angle_rad = radians(symbol.parameter(from, 0));
        style.radius_tangents[i] = std::clamp(symbol.parameter(from + 1, 0), -1e6, 1e6)
            * Vec2(std::cos(angle_rad), std::sin(angle_rad));
    }
}

void Turtle::begin_cylinder(Cylinder::Path path, int rings)
{
    Cylinder::Options options;
    options.path = path;
    options.rings = rings > 0 ? rings : options.rings;
    options.twists = view_.twist_of_cylinders;
    options.unit_mm = options_.unit_mm;
    cylinder_ = { Cylinder(options), state_.place, true };
    cylinder_.place.is_open = false;
}

void Turtle::add_control_point(int rings)
{
    CylinderPoint point;
    point.position_mm = state_.frame.position_mm;
    point.heading = state_.frame.heading;
    point.normal = state_.frame.down;
    point.radius_mm = static_cast<double>(radius_mm(state_));
    point.color = state_.color;
    point.style = extras_.style;
    draw_piece(cylinder_.cylinder.add(std::move(point), rings));
}

// Draws segments between the sections of the piece. What is drawn next is attached to the last one.
void Turtle::draw_piece(Cylinder::Piece const& piece)
{
    if (piece.sections.empty())
        return;
    auto const& from = piece.from;
    auto& place = cylinder_.place;
    bool const is_round = from.style.contour == kNoContour && piece.to.style.contour == kNoContour;
    if (is_round != cylinder_.is_round)
        place.is_open = false;
    cylinder_.is_round = is_round;
    auto const add_section = [&](std::uint32_t node, Vec3 const& normal, double share) {
        if (is_round)
            return;
        NodeSection section;
        section.contour = from.style.contour;
        section.next_contour = piece.to.style.contour;
        section.share = static_cast<float>(share);
        section.normal = normal.cast<float>();
        section.sides = std::max(from.style.sides, piece.to.style.sides);
        drawing_->sections.push_back({ place.axis, node, section });
    };
    Vec3 base_mm = from.position_mm;
    double radius_mm = from.radius_mm;
    // As in cpfg, the colour changes after the first section: further sections have the colour of
    // the control point at the end of the piece.
    auto color = from.color;
    for (auto const& section : piece.sections) {
        drawing_->add_segment(place, base_mm, section.position_mm, static_cast<float>(radius_mm),
                              std::exchange(color, piece.to.color));
        auto const node = drawing_->axes[place.axis].segment_count;
        if (node == 1)
            add_section(0, from.normal, 0);
        add_section(node, section.normal, section.share);
        base_mm = section.position_mm;
        radius_mm = section.radius_mm;
    }
    drawing_->set_tip_radius(place, static_cast<float>(radius_mm));
    state_.place = place;
    state_.place.is_open = false;
}

// Interprets @#(id): selects the view's contour number `id`; without a parameter, a circle.
void Turtle::set_contour(Symbol const& symbol)
{
    double const id = symbol.parameter(0, 0);
    auto const found = view_.contours.find(static_cast<int>(std::clamp(id, -1.0, 1e9)));
    bool const is_circle = symbol.count == 0 || id == 0;
    if (found == view_.contours.end() && !is_circle)
        warn(fmt::format("{}: no contour {} in the view; @# sets a circle", model_.name, id));
    extras_.style.contour = found != view_.contours.end() && symbol.count > 0
        ? static_cast<ContourId>(std::distance(view_.contours.begin(), found))
        : kNoContour;
}

void Turtle::set_sides(Symbol const& symbol)
{
    extras_.style.sides
        = static_cast<std::uint16_t>(std::clamp(symbol.parameter(0, 8), 3.0, 256.0));
}

} // namespace tractus::lsystem
