#include "tests/physics/surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace tractus::physics {

namespace {

constexpr double kLowest_mm = 50;
constexpr double kHighest_mm = 350;
constexpr double kFastest_mm_per_s = 400;
constexpr double kMiddle_mm = 200;

// A minimum-jerk movement from rest to rest.
struct Reach {
    double begins_s = 0;
    double ends_s = 0;
    double from_mm = kMiddle_mm;
    double to_mm = kMiddle_mm;

    double at(double seconds) const
    {
        double const u = std::clamp((seconds - begins_s) / (ends_s - begins_s), 0.0, 1.0);
        return from_mm + (to_mm - from_mm) * u * u * u * (10 + u * (6 * u - 15));
    }
    double least_s() const
    {
        constexpr double kPeakPerMean = 1.875;
        return kPeakPerMean * std::abs(to_mm - from_mm) / kFastest_mm_per_s;
    }
};

// Returns a movement that `next` continues whenever it has ended.
template<typename Next> Movement reaches(Next next)
{
    auto const reach = std::make_shared<Reach>();
    return [reach, next = std::move(next)](double seconds) mutable {
        while (seconds >= reach->ends_s) {
            reach->begins_s = reach->ends_s;
            reach->from_mm = reach->to_mm;
            next(*reach);
        }
        return reach->at(seconds);
    };
}

double log_uniform(Dice& dice, double low, double high)
{
    return std::exp(uniform(dice, std::log(low), std::log(high)));
}

// A run of a motor: its speed rises and falls evenly.
struct MotorRun {
    double begins_s = 0;
    double ends_s = 0;
    double from_mm = kMiddle_mm;
    double mm_per_s = 0;
    double lasts_s = 0; // From the middle of the rise to the middle of the fall.
    double rises_s = 0.1;

    double at(double seconds) const
    {
        auto const ramp = [&](double since_s) {
            double const into_s = std::clamp(since_s, 0.0, rises_s);
            return into_s * into_s / (2 * rises_s) + std::max(0.0, since_s - rises_s);
        };
        return from_mm + mm_per_s * (ramp(seconds - begins_s) - ramp(seconds - begins_s - lasts_s));
    }
};

// A mass with friction that an arm's spring draws to a target.
struct RubbingMass {
    double seconds = 0;
    double mm = kMiddle_mm;
    double mm_per_s = 0;
    double kg = 2;
    double newton_per_m = 1000;
    double newton_s_per_m = 30;
    double static_newton = 6;
    double kinetic_newton = 4;

    void change(Dice& dice)
    {
        newton_per_m = uniform(dice, 300, 2500);
        kg = uniform(dice, 1, 4);
        newton_s_per_m = 2 * uniform(dice, 0.2, 1) * std::sqrt(newton_per_m * kg);
        static_newton = uniform(dice, 2, 12);
        kinetic_newton = static_newton * uniform(dice, 0.4, 0.9);
    }

    void go_on(double target_mm, double step_s)
    {
        constexpr double kStopped_mm_per_s = 0.5;
        double const pull_newton
            = (newton_per_m * (target_mm - mm) - newton_s_per_m * mm_per_s) / 1000;
        bool const is_stopped = std::abs(mm_per_s) < kStopped_mm_per_s;
        if (is_stopped && std::abs(pull_newton) < static_newton) {
            mm_per_s = 0;
        } else {
            double const direction = is_stopped ? pull_newton : mm_per_s;
            double const newton = pull_newton - std::copysign(kinetic_newton, direction);
            double const before = mm_per_s;
            mm_per_s += newton / kg * 1000 * step_s;
            if (!is_stopped && before * mm_per_s < 0)
                mm_per_s = 0;
        }
        mm += mm_per_s * step_s;
        seconds += step_s;
    }

    void bounce(double low_mm, double high_mm, double share)
    {
        constexpr double kTooSlow_mm_per_s = 2;
        if (mm >= low_mm && mm <= high_mm)
            return;
        mm = std::clamp(mm, low_mm, high_mm);
        mm_per_s *= -share;
        if (std::abs(mm_per_s) < kTooSlow_mm_per_s)
            mm_per_s = 0;
    }
};

} // namespace

Movement still()
{
    return [](double) { return kMiddle_mm; };
}

Movement drawing_hand(Dice& dice)
{
    return reaches([&dice](Reach& reach) {
        bool const rests = uniform(dice, 0, 1) < 0.3;
        if (!rests)
            reach.to_mm
                = std::clamp(reach.to_mm + uniform(dice, -150, 150), kLowest_mm, kHighest_mm);
        reach.ends_s = reach.begins_s + std::max(0.25, reach.least_s()) + uniform(dice, 0, 1);
    });
}

Movement hasty_hand(Dice& dice)
{
    return reaches([&dice, rested = false](Reach& reach) mutable {
        rested = !rested && uniform(dice, 0, 1) < 0.7;
        if (rested) {
            reach.ends_s = reach.begins_s + uniform(dice, 0.05, 0.6);
            return;
        }
        double way_mm = log_uniform(dice, 2, 80) * (uniform(dice, 0, 1) < 0.5 ? -1 : 1);
        if (reach.from_mm + way_mm < kLowest_mm || reach.from_mm + way_mm > kHighest_mm)
            way_mm = -way_mm;
        reach.to_mm += way_mm;
        double const least_s = std::max(reach.least_s(), std::abs(way_mm) < 10 ? 0.12 : 0.2);
        reach.ends_s = reach.begins_s + least_s + uniform(dice, 0, 0.2);
    });
}

Movement motor(Dice& dice)
{
    auto const run = std::make_shared<MotorRun>();
    return [run, &dice](double seconds) {
        while (seconds >= run->ends_s) {
            run->from_mm = run->at(run->ends_s);
            run->begins_s = run->ends_s;
            run->mm_per_s = uniform(dice, 25, 50) * (uniform(dice, 0, 1) < 0.5 ? -1 : 1);
            run->rises_s = uniform(dice, 0.05, 0.3);
            run->lasts_s
                = uniform(dice, 0, 1) < 0.5 ? uniform(dice, 0.02, 0.4) : uniform(dice, 0.3, 3);
            double const to_mm = run->from_mm + run->mm_per_s * run->lasts_s;
            if (to_mm < kLowest_mm || to_mm > kHighest_mm)
                run->mm_per_s = -run->mm_per_s;
            run->ends_s = run->begins_s + run->lasts_s + run->rises_s + uniform(dice, 0.05, 1);
        }
        return run->at(seconds);
    };
}

Movement rubbing_surface(Dice& dice)
{
    constexpr double kStep_s = 0.0005;
    constexpr double kChangesEvery_s = 20;
    constexpr double kOver_mm = 10; // The hand reaches this far beyond either stop.
    auto const target = uniform(dice, 0, 1) < 0.5 ? hasty_hand(dice) : drawing_hand(dice);
    auto const mass = std::make_shared<RubbingMass>();
    return [target, mass, &dice](double seconds) {
        while (mass->seconds < seconds) {
            if (uniform(dice, 0, 1) < kStep_s / kChangesEvery_s)
                mass->change(dice);
            mass->go_on(target(mass->seconds), kStep_s);
            mass->bounce(kLowest_mm + kOver_mm, kHighest_mm - kOver_mm, uniform(dice, 0, 0.4));
        }
        return mass->mm;
    };
}

Movement trembling(Movement movement, double deviation_mm, Dice& dice)
{
    struct Wave {
        double rad_per_s = 0;
        double phase = 0;
    };
    constexpr double kTwoPi = 2 * std::numbers::pi;
    std::array<Wave, 6> waves {};
    for (auto& wave : waves)
        wave = { kTwoPi * uniform(dice, 8, 12), uniform(dice, 0, kTwoPi) };
    double const amplitude_mm = deviation_mm * std::sqrt(2.0 / static_cast<double>(waves.size()));
    return [movement = std::move(movement), waves, amplitude_mm](double seconds) {
        double mm = movement(seconds);
        for (auto const& wave : waves)
            mm += amplitude_mm * std::sin(wave.rad_per_s * seconds + wave.phase);
        return mm;
    };
}

} // namespace tractus::physics
