#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

namespace tractus::variation {

// How a plant's growth deviates from its predefined shape.
//
// Streit, Federl and Sousa ("Modelling plant variation through growth", 2005) published the idea, a
// feedback control system, but not its equations; this is a reconstruction. The growing tip of an
// axis deviates from the predefined direction by an angle d with two components (radians, about the
// normal and binormal of the axis' frame), which changes from step to step:
//
//    d' = d - gain d(delay ago) + indicator_gain w + noise + circumnutation
//
// where w is the component of the summed motion indicators orthogonal to the tip's direction. The
// feedback brings the tip back; noise and indicators divert it; both act over several steps.
struct GrowthParameters {
    enum class Steps {
        // A step is 1 / steps_per_axis of the axis' length, regardless of its segments, so that
        // trunk and twigs vary alike and a finer division does not change the statistics. The
        // law is integrated exactly over each segment (an Ornstein-Uhlenbeck process); the
        // direction of a segment is the solution at its middle.
        PerLength,
        // A step is one segment, and the direction of a segment is the solution at its base: the
        // equation above taken literally. The first segment of an axis never deviates.
        PerSegment,
    };
    Steps steps = Steps::PerLength;
    double steps_per_axis = 20; // Number of steps along an axis, 1 to 10,000; for PerLength only.

    // Factor on noise and circumnutation. 0: shape as drawn; 1: usual variation; no upper limit.
    double strength = 1;

    // Share of the deviation that each step corrects. 0 to below 1; with PerSegment and a delay, 0
    // to below 2 sin(pi / (4 delay_steps + 2)), beyond which the feedback oscillates with growing
    // amplitude.
    double gain = 0.2;
    // Delay of the feedback in steps, 0 to 64. With 1 or 2, branches overshoot. Values above 0 are
    // slower to compute.
    int delay_steps = 0;

    double noise_rad = 0.035;  // Standard deviation per step and component; 0 or more.
    double noise_memory = 0.5; // Correlation of the noise between successive steps; 0 to below 1.

    double indicator_gain = 0.05; // Radians per step for an indicator as long as the plant is high.

    // Amplitude of circumnutation, the circling of the tip itself; radians per step.
    double circumnutation_rad = 0;
    double circumnutation_period_steps = 8; // Steps per revolution; at least 2.

    // A constant influence in addition to the indicators, such as the prevailing wind. Its length
    // is in plant heights, like that of an indicator.
    Vec3 prevailing = Vec3::Zero();

    // Maturation (the AC law of Bastien, Bohr, Moulia and Douady, 2013, in the frame of the
    // stroke): the part behind the tip continues to bend for this many steps before it lignifies.
    // In each step the change c of the deviation per step becomes
    //
    //    c' = c + maturation_bending w - maturation_straightening c
    //
    // with w for the direction at that time. 0 to 1,000; 0: lignifies at once. Values above 0 are
    // slower to compute.
    int growth_zone_steps = 0;
    double maturation_bending = 0.01;       // Radians per step, for a unit of w.
    double maturation_straightening = 0.05; // Share of the bend lost per step, 0 to 1.

    // How much the plant sags under its own weight, relative to green wood of its radii; larger for
    // softer material. 0 to 1e6. Default 0, since a drawn shape includes the sag.
    double sag = 0;

    bool operator==(GrowthParameters const&) const = default;
};

// Scales parameters by `variability`, from 0 (as drawn: the strokes are reproduced exactly) over 1
// (unchanged) to 4. Noise, influences and sag increase by this factor, and the feedback towards the
// strokes decreases by it. Fails for values outside this range.
Result<GrowthParameters> at_variability(GrowthParameters parameters, double variability);

// Fails, in one sentence, if a parameter is outside the range stated in GrowthParameters.
Result<void> check_growth_parameters(GrowthParameters const& parameters);

// One step of the law for each component of (d, x), where x is the memory of the noise and g1 and
// g2 are independent standard normal numbers:
//
//    d' = deviation_kept d + noise_push x + noise_1 g1
//    x' = memory_kept x + memory_1 g1 + memory_2 g2
//
// Indicators act within the step on d, in `substeps` equal parts: d <- substep_kept d +
// substep_push w, with w for the direction after the previous part. The defaults are a step without
// effect.
struct GrowthStep {
    double deviation_kept = 1;
    double noise_push = 0;
    double noise_1 = 0;
    double memory_kept = 1;
    double memory_1 = 0;
    double memory_2 = 0;
    double substep_kept = 1;
    double substep_push = 0;
    int substeps = 1;
};

// Returns the coefficients of one step with Steps::PerSegment, ignoring the delay.
GrowthStep unit_step(GrowthParameters const& parameters);

// Returns the exact step over `length` (0 or more, in units of a step) for Steps::PerLength without
// delay. Two consecutive steps have the same distribution as one over both lengths. For length 1
// and no noise_memory it equals unit_step(); with noise_memory it has the same steady-state
// variance.
GrowthStep exact_step(GrowthParameters const& parameters, double length);

// Steady-state variance of each component of d, far from the base, without indicators and delay.
double steady_variance(GrowthParameters const& parameters);

} // namespace tractus::variation
