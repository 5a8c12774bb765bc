#include "app/svg/svg_path.h"

#include "app/svg/svg_numbers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>

namespace tractus::svg {

namespace {

constexpr int kCurvePieces = 24;

// Parameters of an arc command without its end point.
struct ArcShape {
    Vec2 radii = Vec2::Zero();
    double turn = 0; // Rotation of the ellipse in radians.
    bool large = false;
    bool sweep = false;
};

// Returns the points of an arc except its start, computed from the ellipse's centre and angles (SVG
// 2, appendix B.2.4).
std::vector<Vec2> arc_points(Vec2 const& from, Vec2 const& to, ArcShape const& shape)
{
    Vec2 radii = shape.radii.cwiseAbs();
    if (radii.minCoeff() <= 0 || from == to)
        return { to };
    Eigen::Rotation2Dd const turn(shape.turn);
    Vec2 const half = turn.inverse() * ((from - to) / 2);
    // Radii that are too small are enlarged just enough for the arc to reach its end point.
    radii *= std::max(1.0, half.cwiseQuotient(radii).norm());
    Vec2 const unit = half.cwiseQuotient(radii);
    double const apart = unit.squaredNorm();
    double const side = shape.large == shape.sweep ? -1 : 1;
    double const root = side * std::sqrt(std::max(0.0, 1 / apart - 1));
    Vec2 const middle_unit(root * unit.y(), -root * unit.x());
    Vec2 const middle = turn * middle_unit.cwiseProduct(radii) + (from + to) / 2;
    auto const angle = [](Vec2 const& way) { return std::atan2(way.y(), way.x()); };
    double const begin = angle(unit - middle_unit);
    double sweep = angle(-unit - middle_unit) - begin;
    if (shape.sweep && sweep < 0)
        sweep += 2 * kPi;
    if (!shape.sweep && sweep > 0)
        sweep -= 2 * kPi;
    std::vector<Vec2> points;
    for (int i = 1; i <= kCurvePieces; ++i) {
        double const at = begin + sweep * i / kCurvePieces;
        points.emplace_back(middle
                            + turn * Vec2(std::cos(at) * radii.x(), std::sin(at) * radii.y()));
    }
    points.back() = to;
    return points;
}

class PathReader {
public:
    explicit PathReader(std::string_view data)
        : numbers_(data)
    {
    }

    std::optional<std::vector<std::vector<Vec2>>> read()
    {
        while (!numbers_.rest().empty())
            if (!read_command())
                return std::nullopt;
        return lines_;
    }

private:
    // Reads a command letter. If a number follows instead, the previous command is repeated.
    bool read_command()
    {
        char const next = numbers_.rest().front();
        if (std::isalpha(static_cast<unsigned char>(next)) != 0)
            command_ = *numbers_.symbol();
        else if (command_ == 'M' || command_ == 'm')
            command_ = command_ == 'M' ? 'L' : 'l';
        char const kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command_)));
        if (lines_.empty() && kind != 'M')
            return false;
        if (kind == 'Z')
            return close(next);
        bool const done = kind == 'M' ? move() : draw(kind);
        last_kind_ = kind;
        return done;
    }

    bool draw(char kind)
    {
        if (closed_) { // After a line was closed, the next line begins at that line's start.
            lines_.push_back({ at_ });
            closed_ = false;
        }
        switch (kind) {
        case 'L':
            return line();
        case 'H':
        case 'V':
            return level_line(kind);
        case 'C':
        case 'S':
            return cubic(kind);
        case 'Q':
        case 'T':
            return quadratic(kind);
        case 'A':
            return arc();
        default:
            return false;
        }
    }

    std::optional<Vec2> point()
    {
        auto const x = numbers_.number();
        auto const y = x ? numbers_.number() : std::nullopt;
        if (!y)
            return std::nullopt;
        Vec2 const read(*x, *y);
        return is_relative() ? Vec2(at_ + read) : read;
    }

    bool is_relative() const { return std::islower(static_cast<unsigned char>(command_)) != 0; }

    void go(Vec2 const& to)
    {
        at_ = to;
        lines_.back().push_back(to);
    }

    bool move()
    {
        auto const to = point();
        if (!to)
            return false;
        at_ = *to;
        lines_.push_back({ *to });
        closed_ = false;
        return true;
    }

    // Closes the current line. The command has no numbers, so it cannot be repeated without its
    // letter.
    bool close(char letter)
    {
        if (letter != command_)
            return false;
        go(lines_.back().front());
        closed_ = true;
        last_kind_ = 'Z';
        return true;
    }

    bool line()
    {
        auto const to = point();
        if (to)
            go(*to);
        return to.has_value();
    }

    bool level_line(char kind)
    {
        auto const number = numbers_.number();
        if (!number)
            return false;
        int const axis = kind == 'H' ? 0 : 1;
        Vec2 to = at_;
        to[axis] = is_relative() ? at_[axis] + *number : *number;
        go(to);
        return true;
    }

    // Returns the control point of a smooth curve: the previous curve's control point, mirrored at
    // the current point, if the previous curve is of the same kind; otherwise the current point.
    Vec2 mirrored_control(char kind, char short_kind) const
    {
        bool const goes_on = last_kind_ == kind || last_kind_ == short_kind;
        return goes_on ? Vec2(2 * at_ - control_) : at_;
    }

    bool cubic(char kind)
    {
        auto const first = kind == 'C' ? point() : mirrored_control('C', 'S');
        auto const second = first ? point() : std::nullopt;
        auto const to = second ? point() : std::nullopt;
        if (!to)
            return false;
        add_curve(*first, *second, *to);
        control_ = *second;
        return true;
    }

    bool quadratic(char kind)
    {
        auto const control = kind == 'Q' ? point() : mirrored_control('Q', 'T');
        auto const to = control ? point() : std::nullopt;
        if (!to)
            return false;
        add_curve(at_ + (*control - at_) * 2 / 3, *to + (*control - *to) * 2 / 3, *to);
        control_ = *control;
        return true;
    }

    void add_curve(Vec2 const& first, Vec2 const& second, Vec2 const& to)
    {
        Vec2 const from = at_;
        for (int i = 1; i <= kCurvePieces; ++i) {
            double const t = static_cast<double>(i) / kCurvePieces;
            double const s = 1 - t;
            go(s * s * s * from + 3 * s * s * t * first + 3 * s * t * t * second + t * t * t * to);
        }
    }

    bool arc()
    {
        std::array<double, 3> shape {};
        for (auto& value : shape) {
            auto const number = numbers_.number();
            if (!number)
                return false;
            value = *number;
        }
        auto const large = numbers_.flag();
        auto const sweep = large ? numbers_.flag() : std::nullopt;
        auto const to = sweep ? point() : std::nullopt;
        if (!to)
            return false;
        Vec2 const from = at_;
        for (auto const& next :
             arc_points(from, *to, { Vec2(shape[0], shape[1]), radians(shape[2]), *large, *sweep }))
            go(next);
        return true;
    }

    SvgNumbers numbers_;
    std::vector<std::vector<Vec2>> lines_;
    Vec2 at_ = Vec2::Zero();
    Vec2 control_ = Vec2::Zero(); // Last control point of the previous curve.
    char command_ = ' ';
    char last_kind_ = ' ';
    bool closed_ = false;
};

} // namespace

std::optional<std::vector<std::vector<Vec2>>> parse_svg_path(std::string_view data)
{
    auto lines = PathReader(data).read();
    if (lines)
        lines->erase(std::remove_if(lines->begin(), lines->end(),
                                    [](std::vector<Vec2> const& line) { return line.size() < 2; }),
                     lines->end());
    return lines;
}

std::optional<std::vector<Vec2>> parse_svg_points(std::string_view points)
{
    SvgNumbers numbers(points);
    std::vector<Vec2> result;
    while (!numbers.rest().empty()) {
        auto const x = numbers.number();
        auto const y = x ? numbers.number() : std::nullopt;
        if (!y)
            return std::nullopt;
        result.emplace_back(*x, *y);
    }
    return result;
}

} // namespace tractus::svg
