#include "engine/lsystem/function_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/core.h>

namespace tractus {

namespace {

constexpr std::size_t kMaxSamples = 100'000;
constexpr double kMaxMultiplicity = 10;

// The point of the uniform cubic B-spline that begins and ends in its first and last control points
// (four equal knots at each end), 0 <= t <= 1, by de Boor's algorithm.
Vec2 spline_point(std::vector<Vec2> const& points, double t)
{
    auto const spans = static_cast<int>(points.size()) - 3;
    double const u = t * spans;
    int const span = std::min(static_cast<int>(u), spans - 1);
    auto const knot = [&](int i) { return static_cast<double>(std::clamp(i - 3, 0, spans)); };
    std::array<Vec2, 4> d;
    for (int j = 0; j < 4; ++j)
        d[static_cast<std::size_t>(j)] = points[static_cast<std::size_t>(span + j)];
    for (int level = 1; level < 4; ++level) {
        for (int j = 3; j >= level; --j) {
            double const low = knot(span + j);
            double const high = knot(span + j + 4 - level);
            double const share = (u - low) / (high - low);
            auto& value = d[static_cast<std::size_t>(j)];
            value = (1 - share) * d[static_cast<std::size_t>(j - 1)] + share * value;
        }
    }
    return d[3];
}

// y at x by bisection, x rising along the curve; as near as cpfg goes, so that numbers agree.
double value_at(std::vector<Vec2> const& points, double x)
{
    constexpr double kPrecision = 0.001;
    double low = 0;
    double high = 1;
    Vec2 point = Vec2::Zero();
    for (int i = 0; i < 60; ++i) {
        double const middle = (low + high) / 2;
        point = spline_point(points, middle);
        if (std::fabs(point.x() - x) <= kPrecision)
            break;
        (point.x() > x ? high : low) = middle;
    }
    return point.y();
}

std::vector<double> tabulate(std::vector<Vec2> const& points, std::size_t samples)
{
    std::vector<double> values(samples);
    for (std::size_t i = 0; i < samples; ++i)
        values[i] = value_at(points, static_cast<double>(i) / static_cast<double>(samples - 1));
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
    auto const below
        = static_cast<std::size_t>(std::min(position, static_cast<double>(values.size() - 1)));
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
                return fail(Fault::User,
                            fmt::format("{}:{}: expected 2 to {} samples", name, lines.number,
                                        kMaxSamples));
            samples = static_cast<std::size_t>(count[0]);
        } else if (line.substr(0, 7) == "points:") {
            auto const count = numbers(after(line, "points:"));
            std::vector<Vec2> points;
            for (double left = count.empty() ? 0 : count[0]; left > 0; --left) {
                auto const point = lines.next(line) ? numbers(line) : std::vector<double>();
                if (point.size() < 2)
                    return fail(
                        Fault::User,
                        fmt::format("{}:{}: expected a control point 'x y'", name, lines.number));
                auto const multiplicity
                    = point.size() > 2 ? std::clamp(point[2], 1.0, kMaxMultiplicity) : 1;
                points.insert(points.end(), static_cast<std::size_t>(multiplicity),
                              Vec2(point[0], point[1]));
            }
            if (points.size() < 4)
                return fail(
                    Fault::User,
                    fmt::format("{}:{}: expected at least 4 control points", name, lines.number));
            result.push_back({ function_name, tabulate(points, samples) });
        }
    }
    return result;
}

} // namespace tractus
