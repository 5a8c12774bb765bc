#pragma once

namespace tractus::physics {

// Number of rigs in each row of a check, and the first seed.
struct Run {
    unsigned rigs = 60;
    unsigned first_seed = 1;

    unsigned end_seed() const { return first_seed + rigs; }
};

// Checks, each of which prints a table with a row for each kind of physics, and the seeds of rigs
// that miss the row's goal. False if a row with a goal misses it.
bool check_heights(Run const& run); // Checks `calibrate height`.
// Checks `calibrate zero`, after a string slipped or a table was moved.
bool check_zeroing(Run const& run);
bool check_fusing(Run const& run);  // Checks live and settled tips while the table moves.
bool check_latency(Run const& run); // Checks `calibrate latency`.
bool check_slips(Run const& run);   // Checks the detection of slips while drawing.
bool check_tilt(Run const& run);    // Checks tips of a leaning pen, and `calibrate tilt`.

// True if this share of a run's rigs meets a row's goal, allowing for chance in a small run.
bool is_enough(double part, double goal, Run const& run);

} // namespace tractus::physics
