#pragma once

#include "engine/base/result.h"
#include "engine/base/vectors.h"

namespace tractus::variation {

// How far and in what way a plant grows away from its predefined shape.
//
// Streit, Federl and Sousa ("Modelling plant variation through growth", 2005) published the idea, a
// feedback control system, but not its equations; what follows is a reconstruction in its sense.
// The growing tip of an axis deviates from the predefined direction by an angle d in two components
// (radians, about the sides of the axis' frame) that changes from step to step:
//
//     d' = d - gain d(delay ago) + indicator_gain w + noise + circumnutation
//
// where w is the part of the summed motion indicators across the tip's direction. So the feedback
// brings the tip back, the noise and the indicators lead it astray, and both remember.
struct GrowthParameters {
    enum class Steps {
        // A step is 1 / steps_per_axis of the axis' own length, however many segments it has, so
        // that trunk and twigs vary alike and finer segments change no statistics. The law is
        // integrated exactly over each segment (an Ornstein-Uhlenbeck process), and a segment
        // points as the law says for its middle.
        PerLength,
        // A step is a segment, and a segment points as the law says for its base: the equation
        // above to the letter. The first segment of an axis never deviates.
        PerSegment,
    };
    Steps steps = Steps::PerLength;
    double steps_per_axis = 20; // PerLength only; 1 to 10,000.

    // Scales noise and circumnutation: 0 as drawn, 1 as usual, above: as it likes.
    double strength = 1;

    // Share of the deviation that a step takes back. 0 to below 1; PerSegment and with a delay, 0
    // to below 2 sin(pi / (4 delay_steps + 2)), where the feedback would begin to swing up.
    double gain = 0.2;
    int delay_steps = 0; // 0 to 64. 1 or 2 lets branches overshoot. Costs time when not 0.

    double noise_rad = 0.035;  // Standard deviation per step and component; 0 or more.
    double noise_memory = 0.5; // Correlation of the noise from step to step; 0 to below 1.

    double indicator_gain = 0.05; // Radians per step for indicators as long as the plant is high.

    double circumnutation_rad = 0;          // The tip's own circling; radians per step.
    double circumnutation_period_steps = 8; // Steps of one turn; at least 2.

    // An influence that is there without being drawn, in plant heights: the wind of a place.
    Vec3 prevailing = Vec3::Zero();

    // Maturation (the AC law of Bastien, Bohr, Moulia and Douady, 2013, in the frame of the
    // stroke). What the tip has left behind goes on bending for so many steps before it is wood:
    // in each, the deviation's change c per step becomes
    //
    //     c' = c + maturation_bending w - maturation_straightening c
    //
    // with w of the direction that it has by then. 0 to 1,000; 0: wood at once. Costs time.
    int growth_zone_steps = 0;
    double maturation_bending = 0.01;       // Radians per step, for a unit of w.
    double maturation_straightening = 0.05; // Share per step, 0 to 1.

    // How much the grown plant sags under its own weight: 1 as green wood of its radii would, more
    // for softer stuff. 0 to 1e6; 0: not at all, since what is drawn has sagged already.
    double sag = 0;

    bool operator==(GrowthParameters const&) const = default;
};

// Parameters of plants that vary as much: `variability` is 0 for plants as drawn (the strokes come
// back exactly), 1 for what the parameters say, and up to 4. Chance, influences and weight do as
// much more, and the feedback that holds the plant to its strokes as much less. Refuses what lies
// outside.
Result<GrowthParameters> at_variability(GrowthParameters parameters, double variability);

// Refuses, in a sentence, what is outside of the ranges above.
Result<void> check_growth_parameters(GrowthParameters const& parameters);

// One step of the law for each component of (d, x), where x is the noise's memory and g1 and g2 are
// independent standard normal numbers:
//
//     d' = deviation_kept d + noise_push x + noise_1 g1
//     x' = memory_kept x + memory_1 g1 + memory_2 g2
//
// The indicators enter where d is carried on: in `substeps` equal parts, each
// d <- substep_kept d + substep_push w, with w of the direction that the part before led to.
// By default the step that does nothing.
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

// A step of Steps::PerSegment, without its delay.
GrowthStep unit_step(GrowthParameters const& parameters);

// The exact step over `length`, in units of a step, 0 or more, of Steps::PerLength without delay.
// Two steps one after the other have the same distribution as one over both lengths. A step of
// length 1 without noise_memory is unit_step; with it, it has the same steady variance.
GrowthStep exact_step(GrowthParameters const& parameters, double length);

// Variance of each component of d far from the base, without indicators and delay.
double steady_variance(GrowthParameters const& parameters);

} // namespace tractus::variation
