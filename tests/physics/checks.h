#pragma once

namespace tractus::physics {

// Rigs that a check looks at: so many of each row, with the seeds from the first on.
struct Run {
    unsigned rigs = 60;
    unsigned first_seed = 1;

    unsigned end_seed() const { return first_seed + rigs; }
};

// Checks each print a table, a row for each kind of physics, with the seeds of the rigs that miss
// the row's goal. False if a row that is held to its goal misses it.
bool check_heights(Run const& run); // Checks `calibrate height`.
// Checks `calibrate zero`, after a string slipped or a table moved.
bool check_zeroing(Run const& run);
bool check_fusing(Run const& run);  // Checks live and settled tips while the table moves.
bool check_latency(Run const& run); // Checks `calibrate latency`.
bool check_slips(Run const& run);   // Checks what tells a slip while drawing.
bool check_tilt(Run const& run);    // Checks tips of a pen that leans, and `calibrate tilt`.

// Whether so great a part of a run's rigs is good enough for a row's goal: a small run may miss by
// what chance makes of so many rigs.
bool is_enough(double part, double goal, Run const& run);

} // namespace tractus::physics
