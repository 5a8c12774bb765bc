#include "engine/lsystem/view/contour_file.h"

#include "engine/lsystem/text/text_lines.h"
#include "engine/stroke/bspline.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace tractus::lsystem {

namespace {

constexpr std::size_t kMaxContourPoints = 10'000;
constexpr double kMaxContourMultiplicity = 10;
constexpr std::size_t kSamplesPerSpan = 64;

struct ControlPoints {
    bool closed = true;
    std::vector<Vec3> points;
};

class ContourParser {
public:
    ContourParser(std::string const& name, std::string_view text)
        : name_(name)
        , lines_ { text, 0 }
    {
    }

    Result<ControlPoints> parse();

private:
    Result<void> point(std::string_view line);
    Result<void> old_header(std::string_view line);
    tl::unexpected<Error> error(std::string const& what) const
    {
        return fail(Fault::User, fmt::format("{}:{}: {}", name_, lines_.number, what));
    }

    std::string const& name_;
    TextLines lines_;
    ControlPoints read_;
    // Number of lines with an editor's markers that are still to be skipped.
    std::size_t lines_to_skip_ = 0;
};

Result<ControlPoints> ContourParser::parse()
{
    std::string_view line;
    bool is_first = true;
    while (lines_.next(line)) {
        if (line.empty())
            continue;
        if (std::exchange(is_first, false) && line.substr(0, 4) != "cver") {
            TRY(old_header(line));
            continue;
        }
        if (lines_to_skip_ > 0) {
            --lines_to_skip_;
        } else if (line.substr(0, 5) == "type:") {
            auto const type = after_key(line, "type:");
            if (type.empty() || (type[0] != 'o' && type[0] != 'c'))
                return error(fmt::format("found 'type: {}', expected o(pen) or c(losed)", type));
            read_.closed = type[0] == 'c';
        } else if (line.substr(0, 8) == "markers:") {
            auto const count = numbers_in(after_key(line, "markers:"));
            lines_to_skip_ = count.empty()
                ? 0
                : static_cast<std::size_t>(
                    std::clamp(count[0], 0.0, static_cast<double>(kMaxContourPoints)));
        } else if (line.find(':') == std::string_view::npos && line.substr(0, 4) != "cver") {
            TRY(point(line));
        }
    }
    if (read_.points.size() < (read_.closed ? 3u : 4u))
        return error(fmt::format("expected at least {} control points", read_.closed ? 3 : 4));
    return std::move(read_);
}

// Reads the header of the older format, COUNT DIMENSION open|closed. The count is ignored: points
// are read to the end of the file.
Result<void> ContourParser::old_header(std::string_view line)
{
    auto const blank = line.find_last_of(" \t");
    auto const type = blank == std::string_view::npos ? line : line.substr(blank + 1);
    if (type != "open" && type != "closed")
        return error(fmt::format("found '{}', expected 'cver MAJOR MINOR'", line));
    read_.closed = type == "closed";
    return {};
}

Result<void> ContourParser::point(std::string_view line)
{
    auto const numbers = numbers_in(line);
    if (numbers.size() < 2 || numbers.size() > 4)
        return error("expected a control point 'x y z [multiplicity]'");
    auto const count
        = numbers.size() > 3 ? std::clamp(std::floor(numbers[3]), 0.0, kMaxContourMultiplicity) : 1;
    read_.points.insert(read_.points.end(), static_cast<std::size_t>(count),
                        { numbers[0], numbers[1], numbers.size() > 2 ? numbers[2] : 0 });
    if (read_.points.size() > kMaxContourPoints)
        return error(fmt::format("expected at most {} control points", kMaxContourPoints));
    return {};
}

// Returns points of the spline at equal steps of its parameter, kSamplesPerSpan for each span.
std::vector<Vec3> sample(ControlPoints const& contour)
{
    auto control = contour.points;
    if (contour.closed)
        for (std::size_t i = 0; i < 3; ++i)
            control.push_back(contour.points[i]);
    return bspline_points(control, (control.size() - 3) * kSamplesPerSpan + 1,
                          { .ends = BSplineOptions::Ends::Uniform });
}

// Resamples a line at equal steps of arc length, measured in the plane of the contour.
std::vector<Vec3f> at_equal_steps(std::vector<Vec3> const& line)
{
    std::vector<double> lengths(line.size(), 0);
    for (std::size_t i = 1; i < line.size(); ++i)
        lengths[i] = lengths[i - 1] + (line[i] - line[i - 1]).head<2>().norm();
    std::vector<Vec3f> points;
    std::size_t at = 0;
    for (std::size_t i = 0; i <= Contour::kSteps; ++i) {
        double const length
            = lengths.back() * static_cast<double>(i) / static_cast<double>(Contour::kSteps);
        while (at + 2 < line.size() && lengths[at + 1] < length)
            ++at;
        double const step = lengths[at + 1] - lengths[at];
        double const share = step > 0 ? std::clamp((length - lengths[at]) / step, 0.0, 1.0) : 0;
        points.push_back(((1 - share) * line[at] + share * line[at + 1]).cast<float>());
    }
    return points;
}

double signed_area(std::vector<Vec3> const& outline)
{
    double twice = 0;
    for (std::size_t i = 1; i < outline.size(); ++i)
        twice += outline[i - 1].x() * outline[i].y() - outline[i].x() * outline[i - 1].y();
    return twice / 2;
}

// Rotates an outline so that it begins on the x axis. Contours that are blended then correspond
// point by point.
void turn_to_x(std::vector<Vec3>& outline)
{
    Vec2 const start = outline.front().head<2>();
    double const radius = start.norm();
    if (!(radius > 1e-5))
        return;
    Eigen::Matrix2d turn;
    turn << start.x(), start.y(), -start.y(), start.x();
    turn /= radius;
    for (auto& point : outline)
        point.head<2>() = (turn * point.head<2>()).eval();
}

} // namespace

Result<Contour> parse_contour(std::string const& name, std::string_view text)
{
    auto const control = TRY(ContourParser(name, text).parse());
    auto line = sample(control);
    if (control.closed) {
        turn_to_x(line);
        if (signed_area(line) < 0)
            std::reverse(line.begin(), line.end());
    }
    Contour contour;
    contour.name = name.substr(0, name.find('.'));
    contour.closed = control.closed;
    contour.points = at_equal_steps(line);
    if (control.closed)
        contour.points.back() = contour.points.front();
    return contour;
}

} // namespace tractus::lsystem
