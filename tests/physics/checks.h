#pragma once

namespace tractus::physics {

// Number of rigs in each row of a check's table, and the seed of the first rig.
struct Run {
    unsigned rigs = 60;
    unsigned first_seed = 1;

    unsigned end_seed() const { return first_seed + rigs; }
};

// The following checks each print a table with a row for each kind of physics, and the seeds of
// rigs that miss the row's goal. They return false if a row with a goal misses it.
bool check_heights(Run const& run); // Checks `calibrate height`.
// Checks `calibrate zero`, after a string slipped or a table was moved.
bool check_zeroing(Run const& run);
bool check_fusing(Run const& run);   // Checks live and settled tips while the table moves.
bool check_latency(Run const& run);  // Checks `calibrate latency`.
bool check_slips(Run const& run);    // Checks the detection of slips while drawing.
bool check_set_down(Run const& run); // Checks it for a surface that is let down to its stop.
bool check_tilt(Run const& run);     // Checks tips of a leaning pen, and `calibrate tilt`.

// True if `part`, the share of a run's rigs that are good, reaches `goal`. A small run may miss the
// goal slightly by chance.
bool is_enough(double part, double goal, Run const& run);

} // namespace tractus::physics
