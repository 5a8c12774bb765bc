#include "engine/variation/growth_law.h"

#include "engine/base/vectors.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace tractus::variation {

// Maximum number of substeps of GrowthStep. With it the steady deviation is accurate to one per
// cent for indicators several times as long as the plant is high.
constexpr double kMaxSubsteps = 4;

static double largest_gain(GrowthParameters const& parameters)
{
    if (parameters.steps == GrowthParameters::Steps::PerLength && parameters.delay_steps == 0)
        return 1;
    return 2 * std::sin(kPi / (4 * parameters.delay_steps + 2));
}

Result<void> check_growth_parameters(GrowthParameters const& p)
{
    auto const within
        = [](double value, double low, double high, char const* name) -> Result<void> {
        if (!(value >= low && value <= high))
            return fail(Fault::User,
                        fmt::format("growth: {} is {}, and must lie between {} and {}", name, value,
                                    low, high));
        return {};
    };
    constexpr double kAny = 1e6;
    TRY(within(p.steps_per_axis, 1, 10'000, "steps_per_axis"));
    TRY(within(p.strength, 0, kAny, "strength"));
    TRY(within(p.delay_steps, 0, 64, "delay_steps"));
    TRY(within(p.noise_rad, 0, kAny, "noise_rad"));
    TRY(within(p.noise_memory, 0, std::nextafter(1.0, 0.0), "noise_memory"));
    TRY(within(p.indicator_gain, -kAny, kAny, "indicator_gain"));
    TRY(within(p.circumnutation_rad, -kAny, kAny, "circumnutation_rad"));
    TRY(within(p.circumnutation_period_steps, 2, kAny, "circumnutation_period_steps"));
    TRY(within(p.growth_zone_steps, 0, 1000, "growth_zone_steps"));
    TRY(within(p.maturation_bending, -kAny, kAny, "maturation_bending"));
    TRY(within(p.maturation_straightening, 0, 1, "maturation_straightening"));
    TRY(within(p.sag, 0, kAny, "sag"));
    TRY(within(p.prevailing.norm(), 0, kAny, "prevailing"));
    double const limit = largest_gain(p);
    if (!(p.gain >= 0 && p.gain < limit))
        return fail(
            Fault::User,
            fmt::format("growth: gain is {}, and must lie between 0 and below {:.4g}, where "
                        "the feedback would swing up",
                        p.gain, limit));
    return {};
}

Result<GrowthParameters> at_variability(GrowthParameters parameters, double variability)
{
    constexpr double kMax = 4;
    if (!(variability >= 0 && variability <= kMax))
        return fail(Fault::User,
                    fmt::format("a plant cannot grow {} as it likes: give 0 (as drawn) to {} (as "
                                "it likes)",
                                variability, kMax));
    parameters.strength *= variability;
    parameters.indicator_gain *= variability;
    parameters.maturation_bending *= variability;
    parameters.sag *= variability;
    parameters.gain /= std::max(1.0, variability);
    return parameters;
}

double steady_variance(GrowthParameters const& p)
{
    double const kept = 1 - p.gain;
    double const noise = p.noise_rad * p.strength;
    return noise * noise / (p.gain * (2 - p.gain)) * (1 + p.noise_memory * kept)
        / (1 - p.noise_memory * kept);
}

GrowthStep unit_step(GrowthParameters const& p)
{
    double const noise = p.noise_rad * p.strength;
    double const fresh = std::sqrt(1 - p.noise_memory * p.noise_memory);
    return { .deviation_kept = 1 - p.gain,
             .noise_push = noise * p.noise_memory,
             .noise_1 = noise * fresh,
             .memory_kept = p.noise_memory,
             .memory_1 = fresh,
             .memory_2 = 0,
             .substep_kept = 1 - p.gain,
             .substep_push = p.indicator_gain,
             .substeps = 1 };
}

// Returns the ratio of an influence's push over `length` to its push over a step of length 1: (1 -
// exp(-rate length)) / (1 - exp(-rate)).
static double share_of_push(double rate, double length)
{
    return rate > 0 ? std::expm1(-rate * length) / std::expm1(-rate) : length;
}

// Sets the noise of a step without feedback. The deviation is then a random walk, which has no
// steady state to match; the memory of the noise is replaced by wider steps, which is exact in the
// long run.
static void set_free_noise(GrowthStep& step, GrowthParameters const& p, double length)
{
    double const widened = (1 + p.noise_memory) / (1 - p.noise_memory);
    step.noise_1 = p.noise_rad * p.strength * std::sqrt(length * widened);
    step.memory_kept = 0;
}

// Sets the noise of a step with feedback. The pair (d, x) of GrowthStep is a linear process with
// the matrix A: dd = -a d + s x, dx = -b x + white noise, where x has variance 1. Over a length h
// the pair is multiplied by F = exp(A h) and gets new noise of covariance Q = P - F P F^T. P is the
// steady covariance; s follows from the steady variance of d.
static void set_noise(GrowthStep& step, GrowthParameters const& p, double length)
{
    double const variance = steady_variance(p);
    double const a = -std::log1p(-p.gain);
    double const kept = step.deviation_kept;
    if (p.noise_memory == 0) { // The noise is white: b is infinite.
        step.noise_1 = std::sqrt(variance * (1 - kept * kept));
        step.memory_kept = 0;
        return;
    }
    double const b = -std::log(p.noise_memory);
    double const memory_kept = std::exp(-b * length);
    double const s = std::sqrt(variance * a * (a + b));
    double const covariance = s / (a + b);

    // If a and b nearly agree, the limit of the quotient for a = b is used.
    double const push
        = std::abs(a - b) * length > 1e-5 ? s * (memory_kept - kept) / (a - b) : s * length * kept;

    double const q_dd = variance * (1 - kept * kept) - 2 * kept * push * covariance - push * push;
    double const q_dx = covariance * (1 - kept * memory_kept) - push * memory_kept;
    double const q_xx = 1 - memory_kept * memory_kept;
    step.noise_push = push;
    step.memory_kept = memory_kept;
    step.noise_1 = std::sqrt(std::max(0.0, q_dd));
    step.memory_1 = step.noise_1 > 0 ? q_dx / step.noise_1 : 0;
    step.memory_2 = std::sqrt(std::max(0.0, q_xx - step.memory_1 * step.memory_1));
}

GrowthStep exact_step(GrowthParameters const& p, double length)
{
    GrowthStep step;
    if (!(length > 0))
        return step;
    double const rate = -std::log1p(-p.gain);
    step.deviation_kept = std::exp(-rate * length);
    if (rate > 0)
        set_noise(step, p, length);
    else
        set_free_noise(step, p, length);

    step.substeps = static_cast<int>(std::clamp(std::round(length), 1.0, kMaxSubsteps));
    double const part = length / step.substeps;
    step.substep_kept = std::exp(-rate * part);
    step.substep_push = p.indicator_gain * share_of_push(rate, part);
    return step;
}

} // namespace tractus::variation
