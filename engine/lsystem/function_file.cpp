#include "engine/lsystem/function_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/core.h>

namespace tractus {

namespace {

constexpr std::size_t kMaxSamples = 100'000;
constexpr double kMaxMultiplicity = 10;

// One blending of a uniform cubic B-spline over the four points from `first` on, 0 <= t <= 1.
Vec2 spline_point(std::vector<Vec2> const& points, std::size_t first, double t)
{
    double const s = 1 - t;
    return (s * s * s * points[first] + (3 * t * t * t - 6 * t * t + 4) * points[first + 1]
            + (-3 * t * t * t + 3 * t * t + 3 * t + 1) * points[first + 2] + t * t * t * points[first + 3])
        / 6;
}

// y at x by bisection: x rises along the curve.
double value_at(std::vector<Vec2> const& points, double x, double precision)
{
    double low = 0;
    double high = static_cast<double>(points.size() - 3);
    auto const at = [&](double t) {
        auto const span = std::min(static_cast<std::size_t>(t), points.size() - 4);
        return spline_point(points, span, t - static_cast<double>(span));
    };
    for (int i = 0; i < 200 && high - low > 1e-12; ++i) {
        double const middle = (low + high) / 2;
        auto const point = at(middle);
        if (std::fabs(point.x() - x) < precision)
            return point.y();
        (point.x() < x ? low : high) = middle;
    }
    return at((low + high) / 2).y();
}

std::vector<double> tabulate(std::vector<Vec2> points, std::size_t samples)
{
    std::vector<double> values(samples);
    // Triple end points let the curve begin and end in them.
    if (points.empty())
        return values;
    points.insert(points.begin(), 2, points.front());
    points.insert(points.end(), 2, points.back());
    for (std::size_t i = 0; i < samples; ++i)
        values[i] = value_at(points, static_cast<double>(i) / static_cast<double>(samples - 1),
                             0.01 / static_cast<double>(samples));
    return values;
}

struct Lines {
    std::string_view rest;
    int number = 0;

    bool next(std::string_view& line)
    {
        if (rest.empty())
            return false;
        auto const end = std::min(rest.find('\n'), rest.size());
        line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        ++number;
        while (!line.empty() && (line.back() == '\r' || line.back() == ' '))
            line.remove_suffix(1);
        return true;
    }
};

std::vector<double> numbers(std::string_view line)
{
    std::vector<double> result;
    while (true) {
        auto const begin = line.find_first_not_of(" \t");
        if (begin == std::string_view::npos)
            return result;
        line.remove_prefix(begin);
        double value = 0;
        auto const [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
        if (error != std::errc() || !std::isfinite(value))
            return {};
        result.push_back(value);
        line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    }
}

std::string_view after(std::string_view line, std::string_view key)
{
    auto const value = line.substr(key.size());
    return value.substr(std::min(value.find_first_not_of(' '), value.size()));
}

} // namespace

double FunctionTable::at(double x) const
{
    if (!(x > 0))
        return values.front();
    auto const position = x * static_cast<double>(values.size() - 1);
    auto const below = static_cast<std::size_t>(std::min(position, static_cast<double>(values.size() - 1)));
    if (below + 1 >= values.size())
        return values.back();
    auto const share = position - static_cast<double>(below);
    return values[below] * (1 - share) + values[below + 1] * share;
}

Result<std::vector<FunctionTable>> parse_functions(std::string const& name, std::string_view text)
{
    std::vector<FunctionTable> result;
    Lines lines { text, 0 };
    std::string function_name = name.substr(0, name.find('.'));
    std::size_t samples = 100;
    std::string_view line;
    while (lines.next(line)) {
        if (line.substr(0, 5) == "name:") {
            function_name = after(line, "name:");
        } else if (line.substr(0, 8) == "samples:") {
            auto const count = numbers(after(line, "samples:"));
            if (count.size() != 1 || count[0] < 2 || count[0] > static_cast<double>(kMaxSamples))
                return fail(Fault::User, fmt::format("{}:{}: expected 2 to {} samples", name, lines.number, kMaxSamples));
            samples = static_cast<std::size_t>(count[0]);
        } else if (line.substr(0, 7) == "points:") {
            auto const count = numbers(after(line, "points:"));
            std::vector<Vec2> points;
            for (double left = count.empty() ? 0 : count[0]; left > 0; --left) {
                auto const point = lines.next(line) ? numbers(line) : std::vector<double>();
                if (point.size() < 2)
                    return fail(Fault::User, fmt::format("{}:{}: expected a control point 'x y'", name, lines.number));
                auto const multiplicity = point.size() > 2 ? std::clamp(point[2], 1.0, kMaxMultiplicity) : 1;
                points.insert(points.end(), static_cast<std::size_t>(multiplicity), Vec2(point[0], point[1]));
            }
            result.push_back({ function_name, tabulate(std::move(points), samples) });
        }
    }
    return result;
}

} // namespace tractus
