#include "engine/lsystem/view/function_file.h"

#include "engine/lsystem/text/text_lines.h"
#include "engine/stroke/bspline.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <optional>
#include <span>

namespace tractus::lsystem {

namespace {

constexpr std::size_t kMaxFunctionSamples = 100'000;
constexpr double kMaxMultiplicity = 10;

// A curve over [0, 1] with ascending x, in which bisection finds the y of an x. Points at midpoints
// of intervals are cached, because all searches share them.
class HalvedCurve {
public:
    explicit HalvedCurve(std::vector<Vec3> const& points)
        : points_(points)
        , known_(kKept)
    {
    }

    // Returns y at x, found by bisection with cpfg's precision, so that the numbers agree with
    // cpfg's.
    double value_at(double x)
    {
        constexpr double kPrecision = 0.001;
        double low = 0;
        double high = 1;
        // Number of the interval as in a binary heap: its halves have the numbers 2n and 2n + 1.
        std::size_t half = 1;
        Vec3 point = Vec3::Zero();
        for (int i = 0; i < 60; ++i) {
            double const middle = (low + high) / 2;
            point = at(half, middle);
            if (std::fabs(point.x() - x) <= kPrecision)
                break;
            bool const is_below = point.x() > x;
            (is_below ? high : low) = middle;
            half = half < kKept ? 2 * half + (is_below ? 0 : 1) : kKept;
        }
        return point.y();
    }

private:
    // Number of cached points: enough for ten steps of bisection, which reach the precision.
    static constexpr std::size_t kKept = 1024;

    Vec3 at(std::size_t half, double middle)
    {
        if (half >= kKept)
            return bspline_point(points_, middle);
        if (!known_[half])
            known_[half] = bspline_point(points_, middle);
        return *known_[half];
    }

    std::span<Vec3 const> points_;
    std::vector<std::optional<Vec3>> known_;
};

std::vector<double> tabulate(std::vector<Vec3> const& points, std::size_t samples)
{
    HalvedCurve curve(points);
    std::vector<double> values(samples);
    for (std::size_t i = 0; i < samples; ++i)
        values[i] = curve.value_at(static_cast<double>(i) / static_cast<double>(samples - 1));
    return values;
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
    TextLines lines { text, 0 };
    std::string function_name = name.substr(0, name.find('.'));
    std::size_t samples = 100;
    std::string_view line;
    while (lines.next(line)) {
        if (line.substr(0, 5) == "name:") {
            function_name = after_key(line, "name:");
        } else if (line.substr(0, 8) == "samples:") {
            auto const count = numbers_in(after_key(line, "samples:"));
            if (count.size() != 1 || count[0] < 2
                || count[0] > static_cast<double>(kMaxFunctionSamples))
                return fail(Fault::User,
                            fmt::format("{}:{}: expected 2 to {} samples", name, lines.number,
                                        kMaxFunctionSamples));
            samples = static_cast<std::size_t>(count[0]);
        } else if (line.substr(0, 7) == "points:") {
            auto const count = numbers_in(after_key(line, "points:"));
            std::vector<Vec3> points;
            for (double left = count.empty() ? 0 : count[0]; left > 0; --left) {
                auto const point = lines.next(line) ? numbers_in(line) : std::vector<double>();
                if (point.size() < 2)
                    return fail(
                        Fault::User,
                        fmt::format("{}:{}: expected a control point 'x y'", name, lines.number));
                auto const multiplicity
                    = point.size() > 2 ? std::clamp(point[2], 1.0, kMaxMultiplicity) : 1;
                points.insert(points.end(), static_cast<std::size_t>(multiplicity),
                              Vec3(point[0], point[1], 0));
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

} // namespace tractus::lsystem
