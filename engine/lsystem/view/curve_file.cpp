#include "engine/lsystem/view/curve_file.h"

#include "engine/lsystem/text/text_lines.h"
#include "engine/stroke/bspline.h"

#include <algorithm>
#include <array>
#include <fmt/core.h>
#include <optional>
#include <span>

namespace tractus::lsystem {

namespace {

constexpr std::size_t kMaxCurvePoints = 100'000;
constexpr std::size_t kMaxSamples = 100'000;
constexpr double kMaxCurveMultiplicity = 10;

// A list of points in the file: the curve itself, or a nested list on which an editor moves a
// point.
struct PointList {
    std::size_t missing = 0; // Number of lines of points that are still to be read.
    std::size_t dimension = 2;
    std::string type = "bspline";
    std::vector<Vec3> points;
};

class CurveParser {
public:
    CurveParser(std::string const& name, std::string_view text)
        : name_(name)
        , lines_ { text, 0 }
    {
    }

    Result<PointList> parse();

private:
    Result<void> statement(std::string_view line);
    Result<void> point(std::string_view line);
    tl::unexpected<Error> error(std::string const& what) const
    {
        return fail(Fault::User, fmt::format("{}:{}: {}", name_, lines_.number, what));
    }

    std::string const& name_;
    TextLines lines_;
    std::vector<PointList> lists_; // The curve, then the nested lists that are incomplete.
};

Result<PointList> CurveParser::parse()
{
    std::string_view line;
    while (lines_.next(line)) {
        if (line.empty() || line.substr(0, 2) == "//")
            continue;
        if (line.find(':') != std::string_view::npos)
            TRY(statement(line));
        else
            TRY(point(line));
    }
    if (lists_.empty() || lists_.front().missing > 0)
        return error("the file ends before the curve's last point");
    return std::move(lists_.front());
}

Result<void> CurveParser::statement(std::string_view line)
{
    auto const is = [&](std::string_view key) { return line.substr(0, key.size()) == key; };
    if (is("points:")) {
        auto const count = numbers_in(after_key(line, "points:"));
        if (count.size() != 1 || !(count[0] >= 1)
            || count[0] > static_cast<double>(kMaxCurvePoints))
            return error(
                fmt::format("expected 'points:' and a number from 1 to {}", kMaxCurvePoints));
        if (lists_.size() > 20)
            return error("expected at most 20 lists of points in one another");
        lists_.emplace_back();
        lists_.back().missing = static_cast<std::size_t>(count[0]);
    } else if (is("dim:") || is("dimension:")) {
        auto const dimension = numbers_in(after_key(line, is("dim:") ? "dim:" : "dimension:"));
        if (lists_.empty() || dimension.size() != 1
            || (dimension[0] != 2 && dimension[0] != 3 && dimension[0] != 4))
            return error("expected 'dim:' and 2, 3 or 4, behind 'points:'");
        lists_.back().dimension = static_cast<std::size_t>(dimension[0]);
    } else if (is("type:")) {
        if (lists_.empty())
            return error("expected 'points:' before 'type:'");
        lists_.back().type = after_key(line, "type:");
    }
    return {};
}

Result<void> CurveParser::point(std::string_view line)
{
    while (lists_.size() > 1 && lists_.back().missing == 0)
        lists_.pop_back();
    if (lists_.empty())
        return error("expected 'points:' before the points");
    auto& list = lists_.back();
    auto const read = numbers_in(line);
    if (read.size() != list.dimension)
        return error(fmt::format("expected a control point of {} numbers", list.dimension));
    if (list.missing == 0)
        return error("expected no more points than 'points:' says");
    --list.missing;
    auto const count
        = list.dimension == 4 ? std::clamp(std::floor(read[3]), 0.0, kMaxCurveMultiplicity) : 1;
    list.points.insert(list.points.end(), static_cast<std::size_t>(count),
                       { read[0], read[1], list.dimension > 2 ? read[2] : 0 });
    return {};
}

// Returns the point of the curve at parameter t, from 0 to 1.
Vec3 point_at(CurveTable const& curve, double t)
{
    if (curve.kind != CurveTable::Kind::Bezier)
        return bspline_point(curve.control, t,
                             { .ends = curve.kind == CurveTable::Kind::Clamped
                                   ? BSplineOptions::Ends::Clamped
                                   : BSplineOptions::Ends::Uniform });
    auto const pieces = (curve.control.size() - 1) / 3;
    double const along = t * static_cast<double>(pieces);
    auto const piece = std::min(static_cast<std::size_t>(along), pieces - 1);
    // A Bézier cubic is a clamped B-spline of four control points.
    return bspline_point(std::span(curve.control).subspan(3 * piece, 4),
                         along - static_cast<double>(piece));
}

// Sets the kind of the curve from the file's `type`, and adds the control points that this type
// implies. Returns false for an unknown type.
bool set_kind(CurveTable& curve, std::string_view type)
{
    auto& points = curve.control;
    if (type == "bezier" || type == "bezier-surface")
        curve.kind = CurveTable::Kind::Bezier;
    else if (type == "bspline-endpoint")
        curve.kind = CurveTable::Kind::Clamped;
    else if (type == "bspline-closed" && points.size() >= 3)
        points.insert(points.end(), { points[0], points[1], points[2] });
    else if (type == "bspline-phantom" && points.size() >= 2) {
        // Control points mirrored at the end points make the curve begin and end there.
        Vec3 const first = 2 * points[0] - points[1];
        Vec3 const last = 2 * points.back() - points[points.size() - 2];
        points.insert(points.begin(), first);
        points.push_back(last);
    } else if (type != "bspline")
        return false;
    if (type == "bezier-surface" && points.size() > 4)
        points.resize(4);
    return true;
}

void measure(CurveTable& curve, std::size_t samples)
{
    curve.lengths.assign(samples, 0);
    Vec3 before = point_at(curve, 0);
    for (std::size_t i = 1; i < samples; ++i) {
        Vec3 const here
            = point_at(curve, static_cast<double>(i) / static_cast<double>(samples - 1));
        curve.lengths[i] = curve.lengths[i - 1] + (here - before).norm();
        before = here;
    }
    curve.length = curve.lengths.back();
    if (curve.length > 0)
        for (auto& length : curve.lengths)
            length /= curve.length;
}

} // namespace

Vec3 CurveTable::at(double share) const
{
    if (!(share > 0))
        return point_at(*this, 0);
    if (share >= 1)
        return point_at(*this, 1);
    auto const after = std::upper_bound(lengths.begin(), lengths.end(), share);
    if (after == lengths.end()) // The curve has zero length.
        return point_at(*this, 1);
    auto const before = after - 1;
    double const part = (share - *before) / (*after - *before);
    return point_at(*this,
                    (static_cast<double>(before - lengths.begin()) + part)
                        / static_cast<double>(lengths.size() - 1));
}

Result<CurveTable> parse_curve(std::string const& name, std::string_view text, std::size_t samples)
{
    auto list = TRY(CurveParser(name, text).parse());
    CurveTable curve;
    curve.name = name.substr(0, name.find('.'));
    curve.control = std::move(list.points);
    if (!set_kind(curve, list.type))
        return fail(Fault::User,
                    fmt::format("{}: found 'type: {}', expected bspline, bspline-closed, "
                                "bspline-endpoint, bspline-phantom, bezier or bezier-surface",
                                name, list.type));
    if (curve.control.size() < 4)
        return fail(Fault::User, fmt::format("{}: expected at least 4 control points", name));
    measure(curve, std::clamp<std::size_t>(samples, 2, kMaxSamples));
    return curve;
}

} // namespace tractus::lsystem
