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
// feedback brings the tip back to the predefined direction; noise and indicators divert it.
struct GrowthParameters {
    enum class Steps {
        // A step is 1 / steps_per_axis of the axis' length, regardless of its segments, so that
        // trunk and twigs vary alike and a finer division does not change the statistics. The
        // law is integrated exactly over each segment (an Ornstein-Uhlenbeck process); the
        // direction of a segment is the solution at its middle.
        PerLength,
        // A step is one segment, and the direction of a segment is the solution at its base: the
        // equation of GrowthParameters taken literally. The first segment of an axis never
        // deviates.
        PerSegment,
    };
    Steps steps = Steps::PerLength;
    double steps_per_axis = 20; // Number of steps along an axis, 1 to 10,000; for PerLength only.

    // Factor on noise and circumnutation: 0 for none, 1 for the usual variation; up to 1e6.
    double strength = 1;

    // Share of the deviation that each step corrects. With PerLength and no delay: 0 to below 1.
    // Otherwise: 0 to below 2 sin(pi / (4 delay_steps + 2)), from where on the feedback oscillates
    // with growing amplitude.
    double gain = 0.2;
    // Delay of the feedback in steps, 0 to 64. With a delay of 1 or 2, branches overshoot. Growth
    // with a delay takes longer to compute.
    int delay_steps = 0;

    double noise_rad = 0.035; // Standard deviation of the noise, per step and component; 0 or more.
    double noise_memory = 0.5; // Correlation of the noise between successive steps; 0 to below 1.

    // Deviation per step, in radians, for an indicator as long as the plant is high.
    double indicator_gain = 0.05;

    // Amplitude of circumnutation (the tip's own circling), radians per step.
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
    // where w is the influence across the direction at that time. 0 to 1,000; with 0 each part
    // lignifies at once. Growth with maturation takes longer to compute.
    int growth_zone_steps = 0;
    double maturation_bending = 0.01;       // Change of c, in radians per step, for w of length 1.
    double maturation_straightening = 0.05; // Share of c that is lost per step, 0 to 1.

    // Sag under the plant's own weight, as a multiple of that of green wood with the same radii;
    // larger for softer material. 0 to 1e6. Default 0, since a drawn shape already includes the
    // sag.
    double sag = 0;

    bool operator==(GrowthParameters const&) const = default;
};

// Scales parameters by `variability`: 0 reproduces the strokes exactly, 1 changes nothing, 4 is the
// maximum. Noise, circumnutation, influences and sag are multiplied by `variability`; above 1 the
// feedback towards the strokes is divided by it. Fails for values outside 0 to 4.
Result<GrowthParameters> at_variability(GrowthParameters parameters, double variability);

// Fails, in one sentence, if a parameter is outside the range stated in GrowthParameters.
Result<void> check_growth_parameters(GrowthParameters const& parameters);

// One step of the law of GrowthParameters, for each component of the deviation d and of x, the
// memory of the noise. g1 and g2 are independent standard normal numbers:
//
//    d' = deviation_kept d + noise_push x + noise_1 g1
//    x' = memory_kept x + memory_1 g1 + memory_2 g2
//
// Indicators act within the step on d, in `substeps` equal parts: d <- substep_kept d +
// substep_push w, where w is the influence across the direction after the previous part. A default
// step has no effect.
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
// delay. Two consecutive steps have the same distribution as one step over the sum of their
// lengths. A step of length 1 equals unit_step() without noise_memory; with noise_memory the two
// have the same steady-state variance.
GrowthStep exact_step(GrowthParameters const& parameters, double length);

// Returns the variance that each component of the deviation d reaches far from the base, without
// indicators and delay.
double steady_variance(GrowthParameters const& parameters);

} // namespace tractus::variation
