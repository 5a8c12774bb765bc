#include "calib/height_capture_checks.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <numeric>
#include <vector>

namespace tractus::calib {

namespace {

using Captures = std::span<HeightCapture const>;

constexpr double kMinSpan_mm = 20;
constexpr double kMinCounts = 5;
// Heights that differ by at least this much must have different readings.
constexpr double kMinStep_mm = 5;
// The string is slack where the counts per millimetre fall below this share of their median.
constexpr double kSlackPart = 0.05;

std::vector<std::size_t> by_height(Captures captures)
{
    std::vector<std::size_t> order(captures.size());
    std::iota(order.begin(), order.end(), std::size_t { 0 });
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return captures[a].ruler_mm < captures[b].ruler_mm;
    });
    return order;
}

Result<void> check_span(Captures captures)
{
    auto const [low, high]
        = std::minmax_element(captures.begin(), captures.end(),
                              [](auto const& a, auto const& b) { return a.ruler_mm < b.ruler_mm; });
    if (high->ruler_mm - low->ruler_mm < kMinSpan_mm)
        return fail(Fault::User,
                    fmt::format("all {} captures are at one height, {:g} to {:g} mm: move the "
                                "surface over most of its travel, at least {} mm, between captures",
                                captures.size(), low->ruler_mm, high->ruler_mm, kMinSpan_mm));
    return {};
}

tl::unexpected<Error> slack(HeightCapture const& low, HeightCapture const& high)
{
    return fail(Fault::User,
                fmt::format("the reading stayed at {:.0f} counts while the ruler went from {:g} to "
                            "{:g} mm: the string is slack or the sensor is stuck there; tighten "
                            "it, then capture these heights again",
                            (low.counts + high.counts) / 2, low.ruler_mm, high.ruler_mm));
}

// Fails if readings do not follow the ruler, over all captures or between neighbouring heights.
Result<void> check_slack(Captures captures, std::vector<std::size_t> const& order)
{
    auto const [low, high]
        = std::minmax_element(captures.begin(), captures.end(),
                              [](auto const& a, auto const& b) { return a.counts < b.counts; });
    if (high->counts - low->counts < kMinCounts)
        return slack(captures[order.front()], captures[order.back()]);

    struct Step {
        std::size_t low = 0;
        std::size_t high = 0;
        double counts_per_mm = 0;
    };
    std::vector<Step> steps;
    for (std::size_t i = 0; i < order.size();) {
        auto const& here = captures[order[i]];
        auto next = i + 1;
        while (next < order.size() && captures[order[next]].ruler_mm - here.ruler_mm < kMinStep_mm)
            ++next;
        if (next < order.size()) {
            auto const& there = captures[order[next]];
            steps.push_back(
                { order[i], order[next],
                  std::abs(there.counts - here.counts) / (there.ruler_mm - here.ruler_mm) });
        }
        i = next;
    }
    std::vector<double> rates;
    for (auto const& step : steps)
        rates.push_back(step.counts_per_mm);
    std::sort(rates.begin(), rates.end());
    double const usual = rates[rates.size() / 2];
    for (auto const& step : steps)
        if (step.counts_per_mm < kSlackPart * usual)
            return slack(captures[step.low], captures[step.high]);
    return {};
}

// Returns the longest subsequence of captures, in rising height, whose readings all change in the
// direction given by `sign`.
std::vector<std::size_t> longest_in_order(Captures captures, std::vector<std::size_t> const& order,
                                          double sign)
{
    std::vector<std::size_t> length(order.size(), 1);
    std::vector<std::size_t> before(order.size());
    std::size_t best = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        before[i] = i;
        for (std::size_t j = 0; j < i; ++j) {
            auto const& low = captures[order[j]];
            auto const& high = captures[order[i]];
            bool const fits = sign * (high.counts - low.counts) > 0
                || high.ruler_mm - low.ruler_mm <= kSameHeight_mm;
            if (fits && length[j] + 1 > length[i]) {
                length[i] = length[j] + 1;
                before[i] = j;
            }
        }
        if (length[i] > length[best])
            best = i;
    }
    std::vector<std::size_t> chosen { order[best] };
    for (auto i = best; before[i] != i; i = before[i])
        chosen.push_back(order[before[i]]);
    return chosen;
}

Result<void> check_order(Captures captures, std::vector<std::size_t> const& order)
{
    auto const rising = longest_in_order(captures, order, 1);
    auto const falling = longest_in_order(captures, order, -1);
    auto const& kept = rising.size() >= falling.size() ? rising : falling;
    if (captures.size() - kept.size() <= max_slips(captures.size()) && kept.size() >= 2)
        return {};
    std::vector<std::string> stray;
    for (std::size_t i = 0; i < captures.size(); ++i)
        if (std::find(kept.begin(), kept.end(), i) == kept.end())
            stray.push_back(fmt::format("{} ({:g} mm)", i + 1, captures[i].ruler_mm));
    return fail(Fault::User,
                fmt::format("captures {} are out of order: their readings do not lie between those "
                            "of the heights next to them; check what was typed and capture these "
                            "heights again",
                            fmt::join(stray, ", ")));
}

} // namespace

std::size_t max_slips(std::size_t captures)
{
    return std::max<std::size_t>(1, captures / 5);
}

Result<void> check_captures(Captures captures)
{
    if (captures.size() < 2)
        return fail(Fault::User,
                    fmt::format("{} given, and a height needs at least two (five or more are "
                                "advised): capture more heights",
                                captures.empty() ? "no capture was" : "one capture was"));
    TRY(check_span(captures));
    auto const order = by_height(captures);
    TRY(check_slack(captures, order));
    return check_order(captures, order);
}

} // namespace tractus::calib
